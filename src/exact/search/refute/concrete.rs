//! A claim with definite numbers of elements: what is to be solved for, and the point that values of its unknowns give.

use std::borrow::Cow;
use std::ops::Deref;
use std::rc::Rc;

use super::super::functions::{
    in_terms_of_pi, leave_open, needs, positive_exponents, tied_exponents,
};
use super::super::point::{Target, Wanted, satisfies};
use super::super::values::candidates;
use super::facts::{measured_in_units, negation, roots};
use crate::algebra::{
    Atom, Atoms, BigRational, Expr, Lowering, Polynomial, Rational, Symbol, Var, element_parts,
};
use crate::kernel::{
    Assignment, Claim, Domain, Fact, Obligation, Origin, Sign, definition, in_powers_of_pi,
};
use crate::sorted::Map;

/// The claim itself, or what it is with definite numbers of elements.
#[derive(Clone)]
pub(super) enum Posed<'a> {
    Itself(&'a Obligation),
    Sized(Rc<Obligation>),
}

impl Deref for Posed<'_> {
    type Target = Obligation;
    fn deref(&self) -> &Obligation {
        match self {
            Posed::Itself(own) => own,
            Posed::Sized(sized) => sized,
        }
    }
}

/// A claim with definite numbers of elements.
pub(super) struct Concrete<'a> {
    pub obligation: Posed<'a>,
    /// The problem's unknowns, and those of what roots are taken of.
    atoms: Cow<'a, Atoms>,
    /// What roots with π in them are, `s^2 - 4 \pi D = 0`.
    roots: Vec<Polynomial>,
    pub target: Target,
    wanted: Wanted,
}

impl<'a> Concrete<'a> {
    /// `None` where some term cannot be given a value at all.
    pub fn new(
        obligation: Posed<'a>,
        against_goal: bool,
        wanted: Wanted,
        hint: Option<&Assignment>,
    ) -> Option<Self> {
        let problem = obligation.as_written();
        let known: Vec<Option<Rational>> = match hint {
            None => Vec::new(),
            Some(hint) => known_at(hint, &problem.atoms),
        };
        let mut facts: Vec<Fact> = Vec::with_capacity(problem.facts.len() + 1);
        if against_goal {
            facts.push(negation(&problem.goal));
        }
        // What is known to be false at the hint rules it out; what is known to be true need not be asked again.
        let at_hint = |fact: &Fact| {
            let value = |var: Var| known.get(var.position())?.clone();
            let value = fact.polynomial.evaluate(value).ok()??;
            Some(satisfies(&value, fact.sign))
        };
        if hint.is_some() && facts.first().and_then(at_hint) == Some(false) {
            return None;
        }
        // A point need not give the logarithms that no one speaks of.
        let told = problem.facts.iter().zip(&problem.origins);
        let told = told.filter(|(_, origin)| !matches!(origin, Origin::Logarithms(_)));
        for (fact, _) in told {
            match hint.and_then(|_| at_hint(fact)) {
                None => facts.push(fact.clone()),
                Some(true) => {}
                Some(false) => return None,
            }
        }
        if against_goal {
            facts.extend(problem.conditions.nonzero.iter().map(|p| Fact {
                polynomial: p.clone(),
                sign: Sign::NonZero,
            }));
        }
        let mut atoms = match &obligation {
            Posed::Itself(obligation) => Cow::Borrowed(&obligation.as_written().atoms),
            Posed::Sized(obligation) => Cow::Owned(obligation.as_written().atoms.clone()),
        };
        let mut root_equations = Vec::new();
        if atoms
            .iter()
            .any(|(_, atom)| matches!(atom, Atom::Opaque(_)))
        {
            let about_roots = roots(atoms.to_mut())?;
            if let Some(pi) = problem.pi() {
                let has_pi =
                    |own: &&Fact| own.sign == Sign::Zero && own.polynomial.degree_in(pi) > 0;
                let equations = about_roots.iter().filter(has_pi);
                root_equations.extend(equations.map(|own| own.polynomial.clone()));
            }
            facts.extend(about_roots);
            facts.extend(match wanted {
                Wanted::Exponentials => positive_exponents(obligation.as_written()),
                _ => needs(obligation.claim(), obligation.as_written()),
            });
            if wanted == Wanted::Powers {
                facts.extend(tied_exponents(obligation.claim(), obligation.as_written()));
            }
        }
        facts.extend(measured_in_units(obligation.claim(), &atoms));
        let integers = obligation.claim().domains.iter();
        let integers = integers
            .filter(|(_, d)| d.integer)
            .filter_map(|(s, _)| atoms.find(&Atom::Symbol(s.clone())))
            .collect();
        let target = match hint {
            None => Target::new(facts, integers, wanted),
            Some(_) => {
                let vars = atoms.iter().map(|(var, _)| var);
                let known = vars.filter_map(|var| Some((var, known.get(var.position())?.clone()?)));
                Target::near(facts, integers, known)?
            }
        };
        Some(Concrete {
            obligation,
            atoms,
            roots: root_equations,
            target,
            wanted,
        })
    }

    /// The point in terms of this claim that values of its unknowns give.
    pub fn assignment(&self, values: &Map<Var, Rational>) -> Assignment {
        let mut point = Assignment {
            unfold: self.obligation.unfold().to_vec(),
            ..Assignment::default()
        };
        for (var, atom) in self.atoms.iter() {
            let Some(value) = values.get(&var) else {
                continue;
            };
            match atom {
                Atom::Symbol(symbol) => {
                    point.symbols.insert(symbol.clone(), value.to_big());
                }
                Atom::Opaque(Expr::Derivative { body, variable }) => {
                    if let Expr::Symbol(symbol) = &**body {
                        let key = (symbol.clone(), variable.clone());
                        point.derivatives.insert(key, value.to_big());
                    }
                }
                _ => {}
            }
        }
        complete(self.obligation.claim(), &mut point);
        let problem = self.obligation.as_written();
        in_terms_of_pi(problem, (&self.atoms, &self.roots), values, &mut point);
        if self.wanted != Wanted::Exponentials {
            leave_open(self.obligation.claim(), problem, values, &mut point);
        }
        put_in(self.obligation.claim(), &mut point);
        point
    }
}

/// The values of a problem's unknowns at a point, as far as it gives them one.
pub fn known_at(point: &Assignment, atoms: &Atoms) -> Vec<Option<Rational>> {
    let values = atoms.iter().map(|(_, atom)| match atom {
        Atom::Symbol(symbol) => value_at(point, symbol),
        _ => None,
    });
    values.collect()
}

/// The value of a symbol, or of an element by its own name, at a point.
fn value_at(point: &Assignment, symbol: &Symbol) -> Option<Rational> {
    let value = point.symbols.get(symbol).or_else(|| {
        let (sequence, position) = element_parts(symbol)?;
        point.sequences.get(&sequence)?.get(position as usize - 1)
    });
    value.map(Rational::from)
}

/// Gives every symbol a value that the search left open, but for those that were put in.
pub fn complete(claim: &Claim, point: &mut Assignment) {
    let defined = definitions(claim, point);
    let anything = Domain::default();
    for symbol in claim.free_symbols() {
        let irrational = point.algebraic.as_ref();
        let known = point.symbols.contains_key(symbol)
            || irrational.is_some_and(|own| own.symbols.contains_key(symbol));
        if known || defined.iter().any(|(s, _)| s == symbol) {
            continue;
        }
        let domain = claim.domains.get(symbol).unwrap_or(&anything);
        let mut values = candidates().iter().map(|(_, v)| v.to_big());
        if let Some(value) = values.find(|v| domain.contains(v)) {
            point.symbols.insert(symbol.clone(), value);
        }
    }
}

/// Gives those that were put in the values that they have where all others have theirs: rational ones, or polynomials in π.
pub fn put_in(claim: &Claim, point: &mut Assignment) {
    let pi = Symbol::new("\\pi");
    for (symbol, term) in definitions(claim, point).iter().rev() {
        let rational = point.symbols.iter().filter(|own| own.0 != symbol);
        let rational = rational.map(|(own, value)| (own, Expr::Number(value.clone())));
        let in_pi = point.in_pi.iter().filter(|own| own.0 != symbol);
        let in_pi = in_pi.map(|(own, parts)| (own, in_powers_of_pi(parts)));
        let written = rational.chain(in_pi);
        let written = written.fold(term.clone(), |term, (own, value)| {
            term.substitute(own, &value)
        });
        let parts = in_parts(&written, &pi);
        // What was found with another number for π is no value.
        if parts.is_some() || written.mentions(&pi) {
            point.symbols.remove(symbol);
            point.in_pi.remove(symbol);
        }
        match parts.as_deref() {
            Some([only]) => drop(point.symbols.insert(symbol.clone(), only.clone())),
            Some(parts) => drop(point.in_pi.insert(symbol.clone(), parts.to_vec())),
            None => {}
        }
    }
}

/// The coefficients of a term that is a polynomial in π, one of them at least.
fn in_parts(term: &Expr, pi: &Symbol) -> Option<Vec<BigRational>> {
    let mut atoms = Atoms::default();
    let value = Lowering::plain(&mut atoms).lower(term).ok()?;
    let value = value.as_polynomial()?;
    let parts = match atoms.find(&Atom::Symbol(pi.clone())) {
        Some(pi) if value.degree_in(pi) > 0 => value.in_powers_of(pi),
        _ => vec![value.clone()],
    };
    let parts = parts.iter().map(|own| own.as_constant());
    parts.map(|own| own.map(|own| own.to_big())).collect()
}

/// What was put in at a point, with the symbols for which it was.
fn definitions(claim: &Claim, point: &Assignment) -> Vec<(Symbol, Expr)> {
    let put_in = point.unfold.iter();
    let put_in = put_in.filter_map(|&at| definition(&claim.hypotheses[at].formula));
    put_in.collect()
}
