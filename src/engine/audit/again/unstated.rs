//! Conditions that nobody states, for nobody says where a symbol lies: a mass that is divided out is not 0, and what is written as a
//! root is not negative.
//!
//! What follows under such conditions holds, and the conditions are told, as a denominator is that must not vanish.

use num_traits::Signed;

use crate::algebra::{Expr, Formula, Function, Symbol, effort};
use crate::derivation::{Assumed, Goal, Kind, Source, values_at};
use crate::search::{self, Effort, InChain};
use crate::sorted::{self, Set};

use super::super::Outcome;
use super::super::judge::{Found, Judge, NEARBY, step};
use super::borrowed::chain_of;
use super::conditions::{any_part, raised, takes_root, unbounded};

/// So much work is done for one step, as [`effort`] counts it.
const MOST_WORK: u64 = 500_000;

impl Judge<'_> {
    /// Whether a step that was not proved follows, from what it cites or from what stands before, where symbols that could be anything
    /// are not 0; of a root, where they are positive.
    ///
    /// It takes work of its own: what may be tried after it is tried however long this takes.
    pub(in crate::audit) fn unstated(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        effort::within(MOST_WORK, || {
            self.follows_throughout(goal, assumed, premises, found)
        }) || effort::within(MOST_WORK, || {
            self.follows_from_definitions(goal, assumed, premises, found)
        }) || effort::within(MOST_WORK, || {
            self.follows_unstated(goal, assumed, premises, found)
        }) || effort::within(MOST_WORK, || {
            self.follows_where_positive(goal, assumed, true, found)
        }) || effort::within(MOST_WORK, || {
            self.follows_where_all_positive(goal, assumed, premises, found)
        })
    }

    /// The same as [`Self::follows_where_positive`] with the nearest of what stands before and is not cited.
    fn follows_where_all_positive(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        // From what fails anything may follow, if only hard enough is tried.
        if self.names_its_premises() && self.is_directed() || !self.failing(premises).is_empty() {
            return false;
        }
        let Some(all) = self.with_others(assumed, premises) else {
            return false;
        };
        let is_told = |own: &&Assumed| matches!(own.source, Source::Local(..));
        let told = all[assumed.len()..].iter().take_while(is_told).count();
        let few = all.len().min(assumed.len() + told + NEARBY[0].0);
        self.follows_where_positive(goal, &all[..few], false, found)
            || few < all.len() && self.follows_where_positive(goal, &all, false, found)
    }

    /// The same from nothing but what says what the symbols of the step are, and those in that: beside a law and its solution hardly
    /// anything is found.
    fn follows_from_definitions(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        if self.names_its_premises() || !self.failing(premises).is_empty() {
            return false;
        }
        let Some(mut left) = self.with_others(assumed, premises) else {
            return false;
        };
        let defines = |own: &Assumed, names: &Set<Symbol>| {
            !own.formula.speaks_of_slopes() && names.iter().any(|name| own.is_of(name))
        };
        let chain = chain_of(&mut left, &mut goal.formula.names(), defines);
        !chain.is_empty()
            && !left.is_empty()
            && (self.under_conditions(goal, chain.clone(), None, (false, Effort::Full), found)
                || self.follows_where_positive(goal, &chain, false, found))
    }

    fn follows_unstated(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        let witness = match &found.judged.outcome {
            Outcome::Refuted(refuted) => Some(refuted.witness().clone()),
            Outcome::Open(_) => None,
            _ => return false,
        };
        let witness = witness.as_ref();
        let (light, earnest) = ((true, Effort::Light), (true, Effort::Full));
        if self.under_conditions(goal, assumed.to_vec(), witness, light, found) {
            found.instead.clear();
            return true;
        }
        if self.names_its_premises() && self.is_directed() {
            return false;
        }
        let sound = self.sound(assumed, &self.failing(premises));
        // From what fails anything may follow, if only hard enough is tried.
        self.follows_with_others(goal, assumed, premises, Effort::Light, found)
            || sound.len() < assumed.len()
                && self.follows_with_others(goal, &sound, premises, Effort::Light, found)
            || self.under_conditions(goal, sound.clone(), witness, earnest, found) && {
                if sound.len() == assumed.len() {
                    found.instead.clear();
                }
                true
            }
            || self.follows_with_others(goal, &sound, premises, Effort::Full, found)
            || self.follows_without_open(goal, &sound, premises, found)
    }

    /// The same without what stands just before and is left open itself, where nothing says that the step goes on from that.
    fn follows_without_open(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        if self.names_its_premises() {
            return false;
        }
        let mut open = premises.to_vec();
        open.retain(|&own| self.is_undecided(own));
        let others = self.sound(assumed, &open);
        others.len() < assumed.len()
            && self.follows_with_others(goal, &others, premises, Effort::Light, found)
    }

    /// Whether the step follows, from what it cites alone (`is_cited`) or from what else it is tried with, where symbols of which nobody
    /// says where they lie are positive: who solves `w^2 R^2 C^2 = 1` for `w` means no negative resistance. A proof says that no positive
    /// values speak against it.
    ///
    /// That a symbol is negative nobody leaves unsaid.
    pub(super) fn follows_where_positive(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        is_cited: bool,
        found: &mut Found,
    ) -> bool {
        let equation = &self.derivation.equations[self.at];
        // What is crossed out is meant to fail somewhere, and an equivalence to hold both ways. A root says by itself what is meant, and
        // who writes `|z|` thinks of signs.
        let said = assumed.iter().map(|own| &*own.formula);
        // What is said of a sign is what signs are to be told from: `p > 0`.
        let is_equation = goal.formula.as_equation().is_some();
        let of_sign = !is_equation && goal.formula.terms().contains(&&Expr::integer(0));
        if equation.kind == Kind::Marked
            || of_sign
            || self.says_from_nothing()
            || !goal.suppositions.is_empty()
            || takes_root(&goal.formula)
            || said.chain([&goal.formula]).any(takes_size)
        {
            return false;
        }
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        let free = unbounded(&claim);
        // Where it is false at a point at which they are, it does not follow so; but for an exponent that is 0 there.
        let witness = match &found.judged.outcome {
            // Of what is not cited nothing need be true at the witness.
            Outcome::Refuted(refuted) if is_cited => Some(refuted.witness().clone()),
            _ => None,
        };
        let by_exponents = claim.formulas().any(has_exponents);
        if let Some(witness) = &witness {
            let values = &witness.symbols;
            let is_positive = |symbol| values.get(symbol).is_some_and(Signed::is_positive);
            if !by_exponents && free.iter().all(is_positive) {
                return false;
            }
        }
        let Some(mut conditions) = self.positive(goal, assumed, &free) else {
            let holds = is_equation && is_cited && self.follows_by_signs(goal, assumed, found);
            if holds {
                found.instead.clear();
            }
            return holds;
        };
        if by_exponents {
            let with = conditions.iter().map(step);
            let with: Vec<Assumed> = assumed.iter().cloned().chain(with).collect();
            let (witness, hints) = (witness.as_ref(), self.auditor.hints());
            let unless = self.pose(&with, &goal.formula).ok().and_then(|posed| {
                search::missing_conditions(&posed, witness, Effort::Full, &hints)
            });
            conditions.extend(unless.map(search::Unless::conditions).unwrap_or_default());
        }
        // An inequality that says no more than the conditions do, `x > -3`, is no step.
        let alone = || {
            let with: Vec<Assumed> = conditions.iter().map(step).collect();
            let claim = self.derivation.claim(self.at, &with, &goal.formula);
            search::prove_unconditionally(claim, Effort::Full).is_some()
        };
        // Nor is one that a condition only says in other words: `h < h_0` where $Q = m g (h_0 - h)$ is positive.
        let is_said_by = |condition: &Formula| {
            let without = self.derivation.claim(self.at, assumed, condition);
            let with = assumed.iter().cloned().chain([step(&goal.formula)]);
            let with: Vec<Assumed> = with.collect();
            let with = self.derivation.claim(self.at, &with, condition);
            search::prove_unconditionally(with, Effort::Full).is_some()
                && search::prove_unconditionally(without, Effort::Full).is_none()
        };
        if !is_equation && (alone() || conditions.iter().any(is_said_by)) {
            return false;
        }
        let holds = self.holds_under(goal, assumed.to_vec(), &conditions, Effort::Full, found);
        if holds && is_cited {
            found.instead.clear();
        }
        holds
    }

    /// The same from some of what it cites, with what stands before and is not cited.
    pub(super) fn follows_with_others(
        &self,
        goal: &Goal,
        cited: &[Assumed],
        premises: &[usize],
        effort: Effort,
        found: &mut Found,
    ) -> bool {
        // Of what is not cited nothing need be true at the witness.
        let Some(all) = self.with_others(cited, premises) else {
            return false;
        };
        let others = all[cited.len()..].to_vec();
        // The nearest first: with more a proof may use what it need not.
        let told = others
            .iter()
            .take_while(|own| matches!(own.source, Source::Local(..)));
        let mut sets = vec![told.count(), NEARBY[0].0.min(others.len()), others.len()];
        sets.dedup();
        for many in sets.into_iter().filter(|&many| many > 0) {
            let set = all[..cited.len() + many].to_vec();
            if self.under_conditions(goal, set, None, (true, effort), found) {
                return true;
            }
        }
        // Whether all of it can be true may be more than can be told. What moves is then told by all of it, not by one.
        effort == Effort::Light
            && others.len() > 1
            && others.into_iter().any(|other| {
                let set = cited.iter().cloned().chain([other]).collect();
                self.under_conditions(goal, set, None, (false, Effort::Light), found)
            })
    }

    /// The slip of the pen in a step that would follow, without it, where symbols that could be anything are not 0: with a counterexample at
    /// which none of them is.
    pub(in crate::audit) fn mended_under_conditions(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        chain: &InChain,
        found: &mut Found,
    ) {
        // What nothing introduces as a step may be a law, but for what an integral is worked out to.
        let is_integral = |part: &Expr| matches!(part, Expr::Integral { .. });
        let sides = goal.formula.as_equation();
        let integrates = sides.is_some_and(|(left, _)| left.any(&is_integral));
        if self.derivation.equations[self.at].bare && !integrates {
            return;
        }
        let held = match &found.judged.outcome {
            Outcome::Refuted(refuted) => {
                let claim = self.derivation.claim(self.at, assumed, &goal.formula);
                self.held_in(goal, (assumed, premises), refuted.claim(), &claim)
            }
            _ => Vec::new(),
        };
        let claim = |all: &[Assumed], formula: &Formula| {
            let own = self.derivation.claim(self.at, all, formula);
            search::with_constants(own, held.iter().cloned())
        };
        let mut sets = vec![assumed.to_vec()];
        if !self.names_its_premises() {
            sets.extend(self.with_others(assumed, premises));
        }
        for set in sets {
            let bare = claim(&set, &goal.formula);
            let nonzero = |symbol: &Symbol| Formula::nonzero(Expr::Symbol(symbol.clone()));
            let conditions: Vec<Formula> = unbounded(&bare).iter().map(nonzero).collect();
            if conditions.is_empty() {
                return;
            }
            let with = |conditions: &[Formula], formula: &Formula| {
                let all: Vec<Assumed> = set
                    .iter()
                    .cloned()
                    .chain(conditions.iter().map(step))
                    .collect();
                claim(&all, formula)
            };
            let larger = with(&conditions, &goal.formula);
            let cited = claim(assumed, &goal.formula);
            let Some(refuted) = self.refuted_together(cited, larger.clone()) else {
                continue;
            };
            let hints = self.auditor.hints();
            let mended = search::mended(&larger, chain, refuted.witness(), &hints, values_at);
            let Some(mut mended) = mended else {
                continue;
            };
            let meant = mended.proven.claim().goal.clone();
            if self.derivation.is_of_section_before(self.at, &meant) {
                continue;
            }
            // What must not vanish in the equation itself is told rather than what would make it so.
            let names = meant.free_symbols();
            let foreign = |condition: &Formula| condition.free_symbols().is_disjoint(&names);
            let mut order = conditions.clone();
            sorted::sort_by_key(&mut order, |condition| !foreign(condition));
            mended.under.clone_from(&conditions);
            for condition in &order {
                let mut fewer = mended.under.clone();
                fewer.retain(|own| own != condition);
                let claim = with(&fewer, &meant);
                if let Some(derived) = search::prove_unconditionally(claim, Effort::Light) {
                    (mended.under, mended.proven) = (fewer, derived.proven);
                }
            }
            found.judged.outcome = Outcome::Refuted(refuted.into());
            (found.mended, found.implied) = (Some(mended.into()), None);
            return;
        }
    }
}

/// Whether there is a logarithm, or a power with symbols in the exponent.
fn has_exponents(formula: &Formula) -> bool {
    any_part(formula, &|part| raised(part).is_some())
}

/// Whether an absolute value is.
fn takes_size(formula: &Formula) -> bool {
    any_part(formula, &|part| {
        matches!(part, Expr::Call(Function::Abs, _))
    })
}
