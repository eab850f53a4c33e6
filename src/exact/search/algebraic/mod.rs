//! Points with irrational values, where no rational one was found: one root is adjoined, all else is linear in it.
//!
//! Linear equations are solved for an unknown, equations in one unknown for their roots; the first that has no rational
//! root gives the field, and from then on coefficients are polynomials in that root. What no equation settles is tried
//! with the simplest numbers. Square roots are tried before roots of a higher degree.

mod known;
mod solve;
mod state;

use super::functions::{leave_open, needs, without_factor};
use super::refute::{complete, count_symbols, measured_in_units, negation, put_in, roots};
use crate::algebra::{
    Atom, Atoms, Expr, Function, Monomial, Polynomial, Rational, Symbol, Univariate, Var,
};
use crate::kernel::{Algebraic, Assignment, Fact, Field, Obligation, Sign};
use crate::sorted::{self, Map};
pub use known::without_rational_points;
use solve::HIGHEST_DEGREE;
use state::{Search, State};

/// How many choices may be tried, with square roots alone and again with others.
const CHOICES: usize = 80;
/// Larger systems are left alone.
const MOST_EQUATIONS: usize = 24;

/// The first point that is accepted, of those with values in one field.
pub fn first<T>(
    obligation: &Obligation,
    against_goal: bool,
    accepts: impl Fn(Assignment) -> Option<T>,
) -> Option<T> {
    let posed = Posed::new(obligation, against_goal)?;
    let accepted =
        |field: &Field, values: &Map<Var, Univariate>| accepts(posed.assignment(field, values));
    let mut search = Search {
        order: &posed.order,
        integers: &posed.integers,
        highest: 2,
        left: CHOICES,
        passed_over: false,
    };
    let found = search.explore(posed.start.clone(), &accepted);
    if found.is_some() || !search.passed_over {
        return found;
    }
    (search.highest, search.left) = (HIGHEST_DEGREE, CHOICES);
    search.explore(posed.start.clone(), &accepted)
}

/// What a point must satisfy.
struct Posed<'a> {
    obligation: &'a Obligation,
    /// The problem's unknowns, and those of what roots are taken of.
    atoms: Atoms,
    start: State,
    order: Vec<Var>,
    integers: Vec<Var>,
}

impl<'a> Posed<'a> {
    /// `None` where there is no point of this kind to be looked for.
    fn new(obligation: &'a Obligation, against_goal: bool) -> Option<Self> {
        let (claim, problem) = (obligation.claim(), obligation.as_written());
        let plain = |atom: &Atom| match atom {
            Atom::Symbol(_) => true,
            Atom::Opaque(Expr::Power(_, exponent)) => matches!(**exponent, Expr::Number(_)),
            Atom::Opaque(Expr::Call(Function::Abs, _) | Expr::Derivative { .. }) => true,
            // Its value is rational.
            atom => is_left_open(atom),
        };
        if !problem.atoms.iter().all(|(_, atom)| plain(atom))
            || !claim.sequences.is_empty()
            || !count_symbols(claim).is_empty()
        {
            return None;
        }
        let mut facts: Vec<Fact> = Vec::new();
        if against_goal {
            facts.push(negation(&problem.goal));
            facts.extend(problem.conditions.nonzero.iter().map(|p| Fact {
                polynomial: p.clone(),
                sign: Sign::NonZero,
            }));
        }
        facts.extend(problem.facts.iter().cloned());
        if problem.atoms.iter().any(|(_, atom)| is_left_open(atom)) {
            facts.extend(needs(claim, problem));
        }
        let mut atoms = problem.atoms.clone();
        let opaque = |(_, atom): (Var, &Atom)| matches!(atom, Atom::Opaque(_));
        if atoms.iter().any(opaque) {
            facts.extend(roots(&mut atoms)?);
        }
        facts.extend(measured_in_units(claim, &atoms));
        if let Some(pi) = problem.pi() {
            // What is said of π alone is so; what has it for a factor is so whatever it is. Nothing else with it is looked at.
            facts.retain(|fact| fact.polynomial.vars()[..] != [pi]);
            for fact in &mut facts {
                fact.polynomial = without_factor(&fact.polynomial, pi);
            }
            if facts.iter().any(|fact| fact.polynomial.degree_in(pi) > 0) {
                return None;
            }
        }
        // Where every equation is linear, what there is has rational points among it.
        let is_curved = |fact: &Fact| fact.sign == Sign::Zero && fact.polynomial.degree() > 1;
        let equations = facts.iter().filter(|f| f.sign == Sign::Zero).count();
        if equations > MOST_EQUATIONS || !facts.iter().any(is_curved) {
            return None;
        }
        let mut order: Vec<Var> = facts.iter().flat_map(|f| f.polynomial.vars()).collect();
        sorted::sort(&mut order);
        order.dedup();
        let integers = claim.domains.iter().filter(|(_, d)| d.integer);
        let integers = integers.filter_map(|(s, _)| atoms.find(&Atom::Symbol(s.clone())));
        Some(Posed {
            obligation,
            start: State::new(facts),
            order,
            integers: integers.collect(),
            atoms,
        })
    }

    /// The point in the kernel's terms.
    fn assignment(&self, field: &Field, values: &Map<Var, Univariate>) -> Assignment {
        let mut point = Assignment {
            unfold: self.obligation.unfold().to_vec(),
            ..Assignment::default()
        };
        let mut open: Map<Var, Rational> = Map::new();
        let (low, high) = field.ends();
        let mut own = Algebraic {
            polynomial: listed(field.polynomial()),
            low: low.to_big(),
            high: high.to_big(),
            ..Algebraic::default()
        };
        for (var, atom) in self.atoms.iter() {
            let Some(value) = values.get(&var) else {
                continue;
            };
            match (atom, value.as_constant()) {
                (Atom::Symbol(symbol), Some(value)) => {
                    point.symbols.insert(symbol.clone(), value.to_big());
                }
                (Atom::Symbol(symbol), None) => {
                    own.symbols.insert(symbol.clone(), listed(value));
                }
                (Atom::Opaque(Expr::Derivative { body, variable }), Some(value)) => {
                    if let Expr::Symbol(symbol) = &**body {
                        let key = (symbol.clone(), variable.clone());
                        point.derivatives.insert(key, value.to_big());
                    }
                }
                (Atom::Opaque(term @ Expr::Power(..)), _) => {
                    own.roots.insert(term.clone(), listed(value));
                }
                (atom, Some(value)) if is_left_open(atom) => {
                    open.insert(var, value);
                }
                _ => {}
            }
        }
        point.algebraic = Some(own.into());
        let claim = self.obligation.claim();
        complete(claim, &mut point);
        if !open.is_empty() {
            leave_open(claim, self.obligation.as_written(), &open, &mut point);
        }
        // The number π has its value.
        if self.obligation.as_written().pi_is_the_number() {
            point.symbols.remove(&Symbol::new("\\pi"));
        }
        put_in(claim, &mut point);
        point
    }
}

/// Whether an unknown is the value of a function that may be left open.
fn is_left_open(atom: &Atom) -> bool {
    use Function::{Cos, Exp, Sin};
    matches!(atom, Atom::Opaque(Expr::Call(Sin | Cos | Exp, _)))
}

fn listed(value: &Univariate) -> Vec<crate::algebra::BigRational> {
    value.coefficients().iter().map(Rational::to_big).collect()
}

/// The same polynomial in an unknown.
fn polynomial_in(var: Var, value: &Univariate) -> Polynomial {
    let terms = (0_u32..).zip(value.coefficients());
    let terms = terms.map(|(k, c)| Polynomial::term(Monomial::power(var, k), c.clone()));
    terms.fold(Polynomial::zero(), |sum, term| sum.plus(&term))
}

/// A polynomial in one unknown as such.
fn univariate(polynomial: &Polynomial, var: Var) -> Option<Univariate> {
    let parts = polynomial.in_powers_of(var).into_iter();
    let parts: Option<Vec<Rational>> = parts.map(|c| c.as_constant()).collect();
    parts.map(Univariate::new)
}
