//! Goals about the elements of sequences, where what is said of every index is needed.

use crate::algebra::{Expr, Formula, Place, Symbol};
use crate::derivation::{Assumed, Goal, Kind, Source};
use crate::kernel::{Claim, ForEvery, HoldsForEvery, Hypothesis, Standing};
use crate::search::{self, Effort};

use super::Outcome;
use super::judge::{Found, Judge, NEARBY, sources};
use crate::sorted::Set;

/// Why nothing is said of the elements of sequences.
pub(super) const NO_INDUCTION: &str =
    "neither a proof by induction nor first elements against it were found";

impl Judge<'_> {
    /// Settles a goal that does not follow from what its premises say at the index itself, where they say more: by
    /// other indices, by induction, by a counterexample in first elements; and where that is not found, by leaving it
    /// open. Values at one index alone would refute what is true of sequences. `false` where no index runs, or where the
    /// goal follows on some `condition` and no better proof is found.
    pub fn for_every(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        condition: bool,
        found: &mut Found,
    ) -> bool {
        let claims = self.claims_for_every(goal, assumed);
        let page = self.derivation.equations[self.at].page;
        if claims.is_empty() && self.derivation.running(page).is_empty() {
            return false;
        }
        if self.proved_for_every(&claims, goal, assumed, found) {
            return true;
        }
        // What the author crosses out need not follow from anything else.
        let marked = self.derivation.equations[self.at].kind == Kind::Marked && goal.questioned;
        // What gives every element is mostly not cited again.
        if !condition
            && !marked
            && let Some(all) = self.with_others(assumed, premises)
            && self.proved_for_every(&self.claims_for_every(goal, &all), goal, &all, found)
        {
            // What is not cited is no premise that could contradict others.
            if found.contradictory.is_empty() {
                found.instead = sources(&found.judged.assumed);
                return true;
            }
            found.contradictory.clear();
        }
        if claims.is_empty() {
            return false;
        }
        // A sum says itself what it is further on, and values at one index refute what is said of it; so they do where nothing ties
        // an index to another.
        let alone = |claim: &ForEvery| claim.throughout.is_empty() || is_of_one_index(claim);
        if condition || claims.iter().all(alone) {
            return false;
        }
        if !marked {
            let attempts = self.attempts(goal, assumed, premises, None);
            if self.rescue(goal, &attempts, &NEARBY, found) {
                return true;
            }
            // "It is paid off when $L_n = 0$, so" is said of one index.
            if self.with_what_is_named(goal, assumed, premises).is_some() {
                return false;
            }
        }
        match claims.iter().find_map(search::refute_by_first_elements) {
            Some(refuted) => {
                found.judged.outcome = Outcome::Refuted(refuted.into());
                if !marked {
                    self.instead(goal, assumed, premises, found);
                }
            }
            None => {
                found.judged.outcome = Outcome::open(NO_INDUCTION);
            }
        }
        true
    }

    /// Whether one of these claims is proved, or its premises contradict one another.
    fn proved_for_every(
        &self,
        claims: &[ForEvery],
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let proved = |claim| Some((claim, search::prove_for_every(claim)?));
        let Some((claim, (holds, used))) = claims.iter().find_map(proved) else {
            return false;
        };
        let (kept, least) = self.least_for_every(claim, holds, &used, goal, assumed);
        if self.is_contradictory(&kept, goal) {
            found.contradictory = sources(&kept);
            return true;
        }
        found.judged.assumed = kept;
        found.judged.outcome = Outcome::ForEvery(least.into());
        true
    }

    /// The goal as a claim about every index, for each index that runs here.
    fn claims_for_every(&self, goal: &Goal, assumed: &[Assumed]) -> Vec<ForEvery> {
        if !goal.suppositions.is_empty() {
            return Vec::new();
        }
        let said = |a: &Assumed, index: &Symbol| match a.source {
            Source::Equation(premise) => {
                let offer = self.auditor.offer(self.at, premise);
                match offer {
                    Some(offer) => offer.is_throughout(&a.formula, index),
                    None => {
                        let page = self.derivation.equations[premise].page;
                        let mut running = self.derivation.running(page).iter();
                        let given = self.derivation.equations[premise].kind == Kind::Given;
                        given
                            && running.any(|running| {
                                running.index == *index
                                    && self
                                        .derivation
                                        .is_given_throughout(premise, &a.formula, running)
                            })
                    }
                }
            }
            _ => false,
        };
        self.derivation
            .for_every(self.at, assumed, &goal.formula, said)
    }

    /// Leaves out the hypotheses that a proof does without.
    fn least_for_every(
        &self,
        claim: &ForEvery,
        holds: HoldsForEvery,
        used: &Set<usize>,
        goal: &Goal,
        assumed: &[Assumed],
    ) -> (Vec<Assumed>, HoldsForEvery) {
        let all = assumed.iter().enumerate();
        let fewer: Vec<Assumed> = all
            .filter(|(position, _)| used.contains(position))
            .map(|(_, own)| own.clone())
            .collect();
        let mut smaller = self.claims_for_every(goal, &fewer).into_iter();
        let own = smaller.find(|other| other.index == claim.index);
        match own.as_ref().and_then(search::prove_for_every) {
            Some((least, _)) => (fewer, least),
            None => (assumed.to_vec(), holds),
        }
    }
}

/// Whether a claim speaks of elements at the index itself alone, and each hypothesis of every index says what another of them is: then
/// there are such elements at the other indices whatever they are at this one. Or it speaks of none, and says of any other index what it
/// says of this one.
fn is_of_one_index(claim: &ForEvery) -> bool {
    let is_own = |symbol: &Symbol| match symbol.place(&claim.index) {
        Some((_, place)) => place == Place::Running(0),
        None => true,
    };
    let mut spoken_of: Set<Symbol> = Set::new();
    let mut defines = |formula: &Formula| {
        let own = match formula.as_equation() {
            Some((Expr::Symbol(symbol) | Expr::Apply(symbol, _), right))
                if symbol.place(&claim.index).is_some() =>
            {
                !right.mentions(symbol) && !spoken_of.contains(symbol)
            }
            _ => false,
        };
        spoken_of.extend(formula.free_symbols());
        own
    };
    let mut throughout = claim.throughout.iter();
    throughout.all(|&at| {
        let formula = &claim.claim.hypotheses[at].formula;
        defines(formula) || says_the_same_of_any(claim, formula)
    }) && Formula::free_symbols_of(claim.claim.formulas())
        .into_iter()
        .all(is_own)
}

/// Whether a hypothesis speaks of no elements and is so at any index where it is so at one: `\frac{n^2 \hbar^2}{2} = \frac{n^2 h^2}{8 \pi^2}`.
fn says_the_same_of_any(claim: &ForEvery, formula: &Formula) -> bool {
    let own = &claim.index;
    if formula.names().iter().any(|name| name.place(own).is_some()) {
        return false;
    }
    let other = Symbol::new("\\another");
    let mut domains = claim.claim.domains.clone();
    if let Some(domain) = domains.get(own).cloned() {
        domains.insert(other.clone(), domain);
    }
    let there = Expr::Symbol(other);
    let so = Claim {
        hypotheses: vec![Hypothesis {
            formula: formula.clone().into(),
            standing: Standing::AtPoint,
        }],
        goal: formula.map_terms(|term| term.substitute(own, &there)),
        domains,
        ..claim.claim.clone()
    };
    search::prove_unconditionally(so, Effort::Light).is_some()
}
