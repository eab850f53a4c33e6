//! What stands before determines both sides of a step in the same symbols, and otherwise than it says: `c = a_0 - a - b`, where `a` and `b` are known
//! in just what `c` is said to be made of.
//!
//! What else stands before could save the step only if it tied these symbols to one another: what does is put in, be it left open itself. Laws of how something
//! changes do not, and stand in the way of a counterexample.

use crate::algebra::{Expr, Symbol, effort};
use crate::derivation::{Assumed, Goal};
use crate::notation::measured;
use crate::search;
use crate::sorted::Set;

use super::super::Outcome;
use super::super::judge::{Found, Judge};
use super::super::stated::quantities;
use super::obeys::refuted_of;
use super::{ELSEWHERE, OPEN_ITSELF, UNSAID};

/// So many equations may lead from one side to the other.
const MOST_LINKS: usize = 6;
const MOST_LOOKED_AT: usize = 500;
/// So much work is done, as [`effort`] counts it.
const MOST_WORK: u64 = 400_000;

impl Judge<'_> {
    /// What to say of a step that was left open, and comes to something else by what determines both of its sides.
    pub(in crate::audit) fn determined_otherwise(
        &self,
        goal: &Goal,
        premises: &[usize],
        found: &Found,
    ) -> Option<Found> {
        let Outcome::Open(stop) = &found.judged.outcome else {
            return None;
        };
        let is_open = [search::UNDECIDED, OPEN_ITSELF, ELSEWHERE, UNSAID].contains(&&*stop.reason);
        let (left, value) = goal.formula.as_equation()?;
        let is_plain = goal.is_said_outright()
            && goal.rounding.is_none()
            && !goal.questioned
            && !goal.formula.speaks_of_slopes();
        if !is_open
            || !is_plain
            || self.is_directed()
            || !self.usable.unreadable.is_empty()
            || !self.usable.out_of_scope.is_empty()
            || !self.approximations().is_empty()
        {
            return None;
        }
        let [near, _] = self.others(premises);
        let known: Vec<&Assumed> = (found.judged.assumed.iter().chain(&self.usable.assumed))
            .chain(near)
            .filter(|own| !own.formula.speaks_of_slopes())
            .collect();
        let (settled, chosen) = (self.settled(goal, (left, value), &known))
            .or_else(|| self.settled(goal, (value, left), &known))?;
        // What ties the symbols to one another, understood or not.
        let ties: Vec<Assumed> = (known.iter().copied().cloned())
            .chain(self.open_before(premises))
            .filter(|own| {
                own.formula.names().is_subset(&settled) && !own.formula.speaks_of_slopes()
            })
            .collect();
        let mut all: Vec<Assumed> = chosen.into_iter().cloned().collect();
        for own in ties {
            if !all.contains(&own) {
                all.push(own);
            }
        }
        effort::within(MOST_WORK, || {
            let refuted = self.counterexample(&all, &goal.formula)?;
            let mut own = refuted_of(goal, &goal.formula, &all, refuted);
            self.instead(goal, &all, premises, &mut own);
            Some(own)
        })
    }

    /// What says what one side is in the symbols of the other, and all symbols that then are settled.
    fn settled<'a>(
        &self,
        goal: &Goal,
        (side, other): (&Expr, &Expr),
        known: &'a [&'a Assumed],
    ) -> Option<(Set<Symbol>, Vec<&'a Assumed>)> {
        let made_of = quantities(other);
        let mut open = quantities(side);
        open.retain(|own| !made_of.contains(own));
        if made_of.is_empty() || open.is_empty() {
            return None;
        }
        let bound = [side, other]
            .into_iter()
            .flat_map(|own| bound_in(own).into_iter());
        let mut settling = Settling {
            known,
            settled: made_of.iter().cloned().chain(bound).collect(),
            chosen: Vec::new(),
            left: MOST_LOOKED_AT,
        };
        let (left, _) = goal.formula.as_equation()?;
        let is_whole = |own: &Symbol| *left == Expr::Symbol(own.clone());
        for symbol in open {
            settling.settle(&symbol, is_whole(&symbol))?;
        }
        let Settling {
            settled, chosen, ..
        } = settling;
        // "Since $a + b + c = a_0$" gives what `c` is by what `a` and `b` are.
        let is_explicit =
            |own: &&Assumed| matches!(own.formula.as_equation(), Some((Expr::Symbol(_), _)));
        if !chosen.iter().all(is_explicit) {
            let all: Vec<Assumed> = chosen.iter().copied().cloned().collect();
            let posed = self.pose(&all, &goal.formula).ok()?;
            let implied = search::implied(&posed)?;
            let (_, own) = implied.proven.claim().goal.as_equation()?;
            if !quantities(own).is_subset(&made_of) {
                return None;
            }
        }
        // What speaks of more may be said of more: "The balance is now $e_0 = e (1 + i/K) + z$".
        let mut known = quantities(side);
        known.extend(chosen.iter().flat_map(|own| own.formula.names()));
        made_of.is_subset(&known).then_some((settled, chosen))
    }
}

/// Equations that say what symbols are in others that are settled.
struct Settling<'a> {
    known: &'a [&'a Assumed],
    settled: Set<Symbol>,
    chosen: Vec<&'a Assumed>,
    /// So many may still be looked at.
    left: usize,
}

impl Settling<'_> {
    /// Chooses what says what a symbol is, one equation after another; one that is not solved for it only where it may be.
    fn settle(&mut self, symbol: &Symbol, may_be_implicit: bool) -> Option<()> {
        if self.settled.contains(symbol) {
            return Some(());
        }
        let (settled, chosen) = (self.settled.clone(), self.chosen.clone());
        for own in self.known {
            self.left = self.left.checked_sub(1)?;
            let Some((left, right)) = own.formula.as_equation() else {
                continue;
            };
            let is_explicit = *left == Expr::Symbol(symbol.clone()) && !right.mentions(symbol);
            let names = own.formula.names();
            if !(is_explicit || may_be_implicit && names.contains(symbol)) {
                continue;
            }
            if self.chosen.len() >= MOST_LINKS {
                return None;
            }
            self.settled.insert(symbol.clone());
            self.chosen.push(own);
            let mut names = names.iter().filter(|own| measured(own).is_none());
            if names.all(|own| self.settle(own, false).is_some()) {
                return Some(());
            }
            (self.settled, self.chosen) = (settled.clone(), chosen.clone());
        }
        None
    }
}

/// What a term binds: sums and integrals run over it.
fn bound_in(term: &Expr) -> Set<Symbol> {
    let mut found: Set<Symbol> = term
        .children()
        .flat_map(|own| bound_in(own).into_iter())
        .collect();
    found.extend(term.binder().cloned());
    found
}
