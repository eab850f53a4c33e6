//! Counterexamples for every number at once: what a family of them may look like.
//!
//! All elements but one or two are alike; the counts are the number that runs, or one more, and so on. Then the equations
//! among the premises are few polynomials in few unknowns, and the kernel is asked about whatever solves them.

mod choice;
mod solve;
mod written;

use num_traits::ToPrimitive;

use super::{pose, prove_by_degrees};
use crate::algebra::{
    Atom, Atoms, BigRational, Expr, Formula, Fraction, Lowering, Polynomial, Rational, Symbol,
    Values, Var,
};
use crate::kernel::{
    Assignment, Candidate, Claim, Domain, FailsThroughout, Family, FamilyPart, Group, Obligation,
    check_family,
};
use crate::sorted::{self, Map};
use choice::Choice;
use solve::Solution;

/// How many of the elements stand by themselves, the likeliest first; all others are alike.
const APART: [usize; 3] = [1, 0, 2];
/// So many choices of counts are looked into for each of these.
const MOST_SYSTEMS: usize = 12;
/// What may be spent on each kind of family: steps of solving equations, members that are evaluated for a first look, and
/// families that look right and are put to the proof.
const MOST: Budget = Budget {
    steps: 100,
    looks: 80,
    proofs: 3,
};
/// What an element is that nothing else decides.
const NUMBERS: [i32; 4] = [1, 2, 0, -1];
/// For so many elements that nothing decides more than one number is tried.
const MOST_UNDECIDED: usize = 3;
/// So far from the least number of its domain a family is looked at first. It is hoped to begin no later.
const TYPICAL: u32 = 4;

/// A family of counterexamples to a claim about a symbolic number of elements, of which one counterexample is known.
pub fn family(claim: &Claim, witness: &Assignment) -> Option<FailsThroughout> {
    let count = choice::only_count(claim)?;
    let choices = choice::choices(claim, &count, witness);
    let mut search = Search {
        claim,
        witness,
        obligation: Obligation::new(claim.clone(), Vec::new()).ok()?,
        count,
        left: MOST,
    };
    let kinds = match search.others().is_empty() {
        true => &[Others::Free][..],
        false => &[Others::Free, Others::Derived, Others::Fixed],
    };
    kinds.iter().find_map(|&others| {
        search.left = MOST;
        APART.into_iter().find_map(|apart| {
            let mut choices = choices.clone().take(MOST_SYSTEMS);
            choices.find_map(|choice| search.chosen(&choice, apart, others))
        })
    })
}

/// What becomes of symbols that are no counts. What is said for all their values is said best.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Others {
    /// The elements are told in terms of them, as far as that goes.
    Free,
    /// They are told in terms of the elements, as far as that goes.
    Derived,
    /// They are what they are at the counterexample that is known.
    Fixed,
}

struct Search<'a> {
    claim: &'a Claim,
    witness: &'a Assignment,
    obligation: Obligation,
    count: Symbol,
    left: Budget,
}

/// What is left to be spent.
#[derive(Clone, Copy, Debug)]
struct Budget {
    steps: usize,
    looks: usize,
    proofs: usize,
}

impl Budget {
    fn is_spent(self) -> bool {
        self.steps == 0 || self.looks == 0 || self.proofs == 0
    }
}

impl Search<'_> {
    /// The symbols that are no counts, with their values at the counterexample that is known.
    fn others(&self) -> Map<Symbol, BigRational> {
        let symbols = self.claim.free_symbols().into_iter();
        let symbols = symbols.filter(|s| **s != self.count && !choice::is_whole(self.claim, s));
        let valued = symbols.map(|symbol| {
            let value = self.witness.symbols.get(symbol).cloned();
            let one = || BigRational::from_integer(1.into());
            (symbol.clone(), value.unwrap_or_else(one))
        });
        valued.collect()
    }

    /// A number at which a family should have members.
    fn typical(&self, parameter: &Symbol) -> u32 {
        let domain = self.claim.domains.get(parameter);
        let lower = domain.and_then(|domain| domain.lower.as_ref());
        let lower = lower.and_then(|(bound, _)| bound.to_integer().to_u32());
        lower.unwrap_or(0).saturating_add(TYPICAL)
    }

    /// The first family with these counts that is one.
    fn chosen(&mut self, choice: &Choice, apart: usize, kind: Others) -> Option<FailsThroughout> {
        if self.left.is_spent() {
            return None;
        }
        let mut others = self.others();
        let mut symbols = choice.terms();
        if kind == Others::Fixed {
            let numbers = std::mem::take(&mut others).into_iter();
            symbols.extend(numbers.map(|(symbol, value)| (symbol, Expr::Number(value))));
        }
        let sequences: Vec<Symbol> = {
            let all = self.claim.formulas().flat_map(Formula::sequences);
            let mut all: Vec<Symbol> = all.collect();
            sorted::sort(&mut all);
            all.dedup();
            all
        };
        let single = std::iter::repeat_n(Expr::integer(1), apart);
        let sizes = std::iter::once(choice.size_without(&self.count, apart)).chain(single);
        let groups = sizes.enumerate().map(|(at, size)| Group {
            size,
            elements: (sequences.iter())
                .map(|s| (s.clone(), Expr::Symbol(unknown(s, at))))
                .collect(),
        });
        let family = Family {
            parameter: choice.parameter.clone(),
            least: self.typical(&choice.parameter),
            symbols,
            count: self.count.clone(),
            groups: groups.collect(),
        };
        self.solved(&family, &others, kind == Others::Derived)
    }

    /// The unknown elements of a family found from the equations among the hypotheses.
    fn solved(
        &mut self,
        family: &Family,
        free: &Map<Symbol, BigRational>,
        derived: bool,
    ) -> Option<FailsThroughout> {
        let mut atoms = Atoms::default();
        let equations = equations(family, self.claim, &mut atoms)?;
        let var = |symbol: &Symbol, atoms: &mut Atoms| atoms.var(Atom::Symbol(symbol.clone()));
        let parameter = var(&family.parameter, &mut atoms);
        let elements: Vec<Var> = self
            .unknowns(family)
            .map(|symbol| var(symbol, &mut atoms))
            .collect();
        let others: Vec<Var> = free.keys().map(|s| var(s, &mut atoms)).collect();
        let unknowns = match derived {
            true => [others, elements.clone()].concat(),
            false => [elements.clone(), others].concat(),
        };
        let steps = &mut self.left.steps;
        for solution in solve::solutions(equations, &elements, &unknowns, steps) {
            let undecided = elements.iter().copied();
            let undecided: Vec<Var> = undecided.filter(|v| !solution.contains_key(v)).collect();
            for chosen in numbers(&undecided) {
                if self.left.is_spent() {
                    return None;
                }
                self.left.looks -= 1;
                if !self.looks_right(family, free, &solution, &chosen, &mut atoms) {
                    continue;
                }
                let values = solve::put_in(&solution, &chosen)?;
                let term = |value| written::term(value, parameter, &atoms);
                let terms = values
                    .iter()
                    .map(|(&var, value)| (name(var, &atoms), term(value)));
                let found = self.proved(with_values(family, &terms.collect()), free);
                if found.is_some() {
                    return found;
                }
            }
        }
        None
    }

    /// Whether a solution gives a counterexample at one number.
    fn looks_right(
        &self,
        family: &Family,
        free: &Map<Symbol, BigRational>,
        solution: &Solution,
        chosen: &Solution,
        atoms: &mut Atoms,
    ) -> bool {
        let mut values = free.clone();
        let number = BigRational::from_integer(family.least.into());
        values.insert(family.parameter.clone(), number);
        let own = |(&var, value): (&Var, &Fraction)| {
            let value = value.as_constant()?.to_big();
            Some((name(var, atoms), value))
        };
        values.extend(chosen.iter().filter_map(own));
        let at: Vec<(Var, Rational)> = values
            .iter()
            .map(|(symbol, value)| (atoms.var(Atom::Symbol(symbol.clone())), value.into()))
            .collect();
        for (&var, value) in solution {
            let Some(value) = solve::value_at(value, &at) else {
                return false;
            };
            values.insert(name(var, atoms), value.to_big());
        }
        let member = family.member(family.least, &values).ok();
        member.is_some_and(|member| self.refutes(member))
    }

    fn refutes(&self, member: Assignment) -> bool {
        let candidate = Candidate::Counterexample(member);
        self.obligation.check(candidate).is_ok()
    }

    /// The unknown elements: those that stand by themselves are eliminated first, those of which the goal speaks are chosen
    /// first.
    fn unknowns<'f>(&self, family: &'f Family) -> impl Iterator<Item = &'f Symbol> {
        let asked = self.claim.goal.sequences();
        let elements = family.groups.iter().rev().flat_map(|g| &g.elements);
        let mut elements: Vec<(bool, &Symbol)> = elements
            .filter_map(|(sequence, term)| match term {
                Expr::Symbol(symbol) => Some((!asked.contains(sequence), symbol)),
                _ => None,
            })
            .collect();
        sorted::sort_by_key(&mut elements, |own| own.0);
        elements.into_iter().map(|own| own.1)
    }

    /// A family that consists of counterexamples, from the least number on from which it does.
    fn proved(
        &mut self,
        mut family: Family,
        free: &Map<Symbol, BigRational>,
    ) -> Option<FailsThroughout> {
        let free: Map<Symbol, BigRational> = free
            .iter()
            .filter(|(symbol, _)| !family.symbols.contains_key(*symbol))
            .map(|(symbol, value)| (symbol.clone(), value.clone()))
            .collect();
        let refutes = |number: u32| {
            let member = family.member(number, &free).ok();
            member.is_some_and(|member| self.refutes(member))
        };
        let numbers = (0..=family.least).rev();
        let least = numbers.take_while(|&n| refutes(n)).last()?;
        family.least = least;
        in_order(&mut family, &free);
        self.left.proofs -= 1;
        let parts = family.parts(self.claim).ok()?.into_iter();
        let proofs = parts.map(|(_, part)| {
            let derived = prove_by_degrees(&pose(part).ok()?);
            derived.map(|derived| derived.proven)
        });
        check_family(self.claim, family, proofs.collect::<Option<_>>()?, &free).ok()
    }
}

/// A name that no document can give.
fn unknown(sequence: &Symbol, group: usize) -> Symbol {
    Symbol::new(format!("{sequence} {group}"))
}

/// The symbol that an unknown stands for; all of them are symbols.
fn name(var: Var, atoms: &Atoms) -> Symbol {
    match atoms.atom(var) {
        Atom::Symbol(symbol) => symbol.clone(),
        _ => Symbol::new(""),
    }
}

/// What vanishes where the hypotheses hold that are equations.
fn equations(family: &Family, claim: &Claim, atoms: &mut Atoms) -> Option<Vec<Polynomial>> {
    let mut lowering = Lowering::plain(atoms);
    let mut equations = Vec::new();
    for (part, claim) in family.parts(claim).ok()? {
        if let (FamilyPart::Hypothesis(_), Some((left, right))) = (part, claim.goal.as_equation()) {
            let difference = lowering
                .lower(left)
                .ok()?
                .minus(&lowering.lower(right).ok()?);
            equations.push(difference.ok()?.numerator().clone());
        }
    }
    Some(equations)
}

/// Ways to give numbers to what nothing else decides; one where that is nothing.
fn numbers(undecided: &[Var]) -> Vec<Map<Var, Fraction>> {
    let mut all = vec![Map::new()];
    for (at, &var) in undecided.iter().enumerate() {
        let numbers = match at < MOST_UNDECIDED {
            true => &NUMBERS[..],
            false => &NUMBERS[..1],
        };
        let with = |chosen: Map<Var, Fraction>| {
            numbers.iter().map(move |&number| {
                let mut chosen = chosen.clone();
                chosen.insert(var, Rational::from(number).into());
                chosen
            })
        };
        all = all.into_iter().flat_map(with).collect();
    }
    all
}

/// The family with what its unknowns and some free symbols were found to be.
fn with_values(family: &Family, terms: &Map<Symbol, Expr>) -> Family {
    let mut family = family.clone();
    let unknowns = family
        .groups
        .iter_mut()
        .flat_map(|g| g.elements.values_mut());
    let mut names = Vec::new();
    for element in unknowns {
        if let Expr::Symbol(name) = element
            && let Some(term) = terms.get(name)
        {
            names.push(name.clone());
            *element = term.clone();
        }
    }
    let others = terms.iter().filter(|(symbol, _)| !names.contains(symbol));
    let others = others.map(|(symbol, term)| (symbol.clone(), term.clone()));
    family.symbols.extend(others);
    family
}

/// Puts the elements in order, the smallest first, as they are at the first member.
fn in_order(family: &mut Family, free: &Map<Symbol, BigRational>) {
    let mut symbols = free.clone();
    let least = BigRational::from_integer(family.least.into());
    symbols.insert(family.parameter.clone(), least);
    let at = Values {
        symbols,
        ..Values::default()
    };
    family.groups.sort_by_cached_key(|group| {
        let terms = group.elements.values();
        terms.map(|term| at.value(term).ok()).collect::<Vec<_>>()
    });
}

/// The domain of a natural number.
fn is_natural(domain: &Domain) -> bool {
    domain.integer && domain.upper.is_none()
}
