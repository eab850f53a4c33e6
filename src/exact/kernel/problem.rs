//! A claim as facts about polynomials: what certificates speak of.

mod domains;
mod formulas;
mod sums;
mod symbols;
mod unfold;

use std::sync::Arc;

use super::functions::pi_is_the_number;
use super::powers::powers_of;
use super::{Claim, Domain, Fact, Reject, Sign, Standing};
use crate::algebra::{
    Atom, Atoms, Conditions, Expr, Formula, Fraction, Functions, Lowering, Polynomial, Powers,
    Symbol, Var,
};
use crate::sorted::{Map, Set};
pub(super) use symbols::sequences_and_counts;
use symbols::{by_whole_number, constants, still};
pub(crate) use unfold::applied_definition;
pub use unfold::definition;
use unfold::unfolded;

/// A claim as facts about polynomials: what certificates speak of.
///
/// Made from the claim alone, in one way only, so that the search and the kernel mean the same by
/// "fact 3".
#[derive(Clone, Debug)]
pub struct Problem {
    /// The unknowns.
    pub atoms: Atoms,
    /// What is known.
    pub facts: Vec<Fact>,
    /// Where each fact comes from.
    pub origins: Vec<Origin>,
    /// What is to be shown.
    pub goal: Fact,
    /// The same with logarithms taken of both sides, where it equates products that are known to be positive.
    pub goal_in_logarithms: Option<Polynomial>,
    /// What must be known for the goal to be defined at all.
    pub conditions: Conditions,
    pub(super) readings: Vec<Reading>,
    pub(super) integers: Vec<Fraction>,
    pub(super) sequences: Set<Symbol>,
    /// The declared domains of elements.
    elements: Map<Symbol, Domain>,
    /// The symbols that are known to be natural numbers, for sums go up to them.
    counts: Set<Symbol>,
    pub(super) constants: Set<Symbol>,
    /// Symbols that a premise says do not depend on another.
    still: Set<(Symbol, Symbol)>,
    /// How powers are taken apart; `None` where terms are read as they are written.
    pub(super) powers: Option<Powers>,
    /// What is known of symbols where functions are taken apart; `None` where there is nothing.
    pub(super) functions: Option<Functions>,
    pub(super) formulas: Vec<(Arc<Formula>, Standing)>,
    pub(super) goal_formula: Formula,
}

/// Where a fact comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The hypothesis at this position.
    Hypothesis(usize),
    /// The hypothesis at this position, differentiated.
    Rate(usize),
    /// The hypothesis at this position, with the logarithms of both sides taken.
    Logarithms(usize),
    /// The declared domain of a symbol.
    Domain(Symbol),
    /// The nature of sums: counts and even power sums are not negative.
    Sums,
    /// The nature of roots and powers: the power of a root is what it is taken of.
    Powers,
    /// The nature of functions: sin² + cos² = 1; and of `\pi`.
    Functions,
    /// A lemma of the certificate.
    Lemma,
}

/// A premise as it is evaluated at a point: `None` where its relation has no exact meaning there.
#[derive(Clone, Debug)]
pub(super) struct Reading {
    /// Its position among the facts.
    pub fact: Option<usize>,
    pub conditions: Conditions,
}

impl Problem {
    /// The facts that a claim gives once the hypotheses `unfold` are put in.
    ///
    /// # Errors
    /// A hypothesis that cannot be put in, a goal whose relation certificates do not speak of, or a
    /// term that is too large or divides by 0.
    pub fn new(claim: &Claim, unfold: &[usize]) -> Result<Problem, Reject> {
        Problem::read_as(claim, unfold, true)
    }

    /// The same with every power read as it is written: what points are evaluated with.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn as_written(claim: &Claim, unfold: &[usize]) -> Result<Problem, Reject> {
        Problem::read_as(claim, unfold, false)
    }

    /// Whether powers are taken apart in it, so that it is not the same as written.
    pub fn takes_powers_apart(&self) -> bool {
        self.powers.is_some()
    }

    /// Whether `\pi` is the number in it, and not a symbol of the author's.
    pub fn pi_is_the_number(&self) -> bool {
        self.functions.as_ref().is_some_and(|f| f.pi)
    }

    /// The unknown of the number π, where the claim speaks of it.
    pub fn pi(&self) -> Option<Var> {
        let pi = || self.atoms.find(&Atom::Symbol(Symbol::new("\\pi")));
        self.pi_is_the_number().then(pi).flatten()
    }

    fn read_as(claim: &Claim, unfold: &[usize], apart: bool) -> Result<Problem, Reject> {
        if let Some(slope) = by_whole_number(claim) {
            return Err(Reject::MayHaveNoValue(slope));
        }
        let (sequences, counts) = sequences_and_counts(claim);
        let (formulas, goal, values) = unfolded(claim, unfold, &sequences)?;
        let named = claim.free_symbols();
        let pi = named.iter().any(|s| s.name() == "\\pi") && pi_is_the_number(claim);
        // Whatever is said of it, a number is no other term.
        if pi && let Some(at) = values.iter().position(|v| v.0.name() == "\\pi") {
            return Err(Reject::NotUnfoldable(at));
        }
        let powers = {
            let all = formulas.iter().map(|f| &*f.0).chain([&goal]);
            let terms = all
                .flat_map(Formula::terms)
                .chain(values.iter().map(|v| &v.1));
            let put_in = |symbol: &Symbol| values.iter().any(|v| v.0 == *symbol);
            powers_of(claim, pi, terms, &sequences, &counts, put_in)
        };
        let (powers, functions) = powers.unzip();
        let functions = (pi || functions.is_some()).then(|| Functions {
            pi,
            ..functions.unwrap_or_default()
        });
        let constants = constants(claim, &named, pi);
        // Most hypotheses and most domains say one thing, or two.
        let likely = 2 * (claim.hypotheses.len() + claim.domains.len());
        let mut problem = Problem {
            atoms: Atoms::default(),
            facts: Vec::with_capacity(likely),
            origins: Vec::with_capacity(likely),
            goal: Fact {
                polynomial: Polynomial::zero(),
                sign: Sign::Zero,
            },
            goal_in_logarithms: None,
            conditions: Conditions::default(),
            readings: Vec::with_capacity(likely),
            integers: Vec::new(),
            sequences,
            elements: claim.sequences.clone(),
            counts: counts.clone(),
            constants,
            still: still(claim),
            powers: powers.filter(|_| apart),
            functions,
            formulas: Vec::new(),
            goal_formula: Formula::equal(Expr::integer(0), Expr::integer(0)),
        };
        let (fact, conditions) = problem.read(&goal)?;
        problem.goal = fact.ok_or(Reject::UnsupportedRelation)?;
        problem.conditions = conditions;
        problem.goal_formula = goal;
        if let Some(powers) = &mut problem.powers {
            powers.cautious = true;
        }
        for (position, (formula, _)) in formulas.iter().enumerate() {
            problem.assume(formula, Origin::Hypothesis(position))?;
        }
        problem.formulas = formulas;
        problem.assume_domains(claim, &named, &counts, &values)?;
        problem.confine_unnamed(claim, &named)?;
        problem.add_facts_about_sums(claim)?;
        problem.add_signs_of_roots();
        problem.add_facts_about_pi();
        problem.add_facts_about_powers()?;
        problem.add_facts_about_functions()?;
        Ok(problem)
    }

    /// Whether a hypothesis says that a polynomial vanishes throughout: that a slope vanishes at one point
    /// holds nothing constant.
    pub fn vanishes_throughout(&self, polynomial: &Polynomial) -> bool {
        let throughout = |origin: &Origin| match origin {
            Origin::Hypothesis(at) => {
                let formula = self.formulas.get(*at);
                formula.is_some_and(|f| f.1 == Standing::Identity)
            }
            _ => false,
        };
        let monic = polynomial.monic();
        let mut facts = self.facts.iter().zip(&self.origins);
        facts.any(|(f, origin)| {
            f.sign == Sign::Zero && f.polynomial.monic() == monic && throughout(origin)
        })
    }

    /// Whether a sum goes up to a symbol, outside of any sum that binds it as an index.
    pub(super) fn is_count(&self, symbol: &Symbol) -> bool {
        self.counts.contains(symbol)
    }

    /// Where the elements of a sequence lie, all of them, as far as it is declared.
    pub fn element_domain(&self, sequence: &Symbol) -> Option<&Domain> {
        self.elements.get(sequence)
    }

    pub(super) fn lowering(&mut self) -> Lowering<'_> {
        Lowering {
            sequences: &self.sequences,
            constants: &self.constants,
            still: &self.still,
            powers: self.powers.as_ref(),
            functions: self.functions.as_ref(),
            ..Lowering::plain(&mut self.atoms)
        }
    }

    /// The hypotheses and the goal, with what is put in.
    pub(super) fn statements(&self) -> impl Iterator<Item = &Formula> + Clone {
        let hypotheses = self.formulas.iter().map(|own| &*own.0);
        hypotheses.chain([&self.goal_formula])
    }

    /// Reads further terms in the way of this problem, over a copy of its unknowns.
    pub fn lowering_over<'a>(&'a self, atoms: &'a mut Atoms) -> Lowering<'a> {
        Lowering {
            sequences: &self.sequences,
            constants: &self.constants,
            still: &self.still,
            powers: self.powers.as_ref(),
            functions: self.functions.as_ref(),
            ..Lowering::plain(atoms)
        }
    }

    pub(super) fn add(&mut self, polynomial: Polynomial, sign: Sign, origin: Origin) {
        self.facts.push(Fact { polynomial, sign });
        self.origins.push(origin);
    }
}
