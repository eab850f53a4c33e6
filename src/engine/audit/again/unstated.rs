//! Conditions that nobody states, for nobody says where a symbol lies: a mass that is divided out is not 0, and what is written as a
//! root is not negative.
//!
//! What follows under such conditions holds, and the conditions are told, as a denominator is that must not vanish.

use num_traits::Signed;

use crate::algebra::{Expr, Formula, Function, Symbol, effort};
use crate::derivation::{Assumed, Goal, Kind, Source, values_at};
use crate::kernel::{Assignment, Claim};
use crate::search::{self, Effort, InChain};
use crate::sorted::{self, Set};

use super::super::judge::{Found, Judge, NEARBY, condition, sources, step};
use super::super::{Outcome, stated};

/// So much work is done for one step, as [`effort`] counts it.
const MOST_WORK: u64 = 4_000_000;

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
    fn follows_where_positive(
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
        // What is said to follow from nothing is meant for all values.
        let (cited, says_so, _) = self.derivation.premises(self.at);
        if equation.kind == Kind::Marked
            || of_sign
            || says_so && cited.is_empty()
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
            return false;
        };
        if by_exponents {
            let with = conditions.iter().map(step);
            let with: Vec<Assumed> = assumed.iter().cloned().chain(with).collect();
            let claim = self.derivation.claim(self.at, &with, &goal.formula);
            let (witness, hints) = (witness.as_ref(), self.auditor.hints());
            let unless = search::missing_conditions(&claim, witness, Effort::Full, &hints);
            conditions.extend(unless.map(search::Unless::conditions).unwrap_or_default());
        }
        // An inequality that says no more than the conditions do, `x > -3`, is no step.
        let alone = || {
            let with: Vec<Assumed> = conditions.iter().map(step).collect();
            let claim = self.derivation.claim(self.at, &with, &goal.formula);
            search::prove_unconditionally(claim, Effort::Full).is_some()
        };
        if !is_equation && alone() {
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
        // What nothing introduces as a step may be a law.
        if self.derivation.equations[self.at].bare {
            return;
        }
        let mut sets = vec![assumed.to_vec()];
        if !self.names_its_premises() {
            sets.extend(self.with_others(assumed, premises));
        }
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        for set in sets {
            let bare = self.derivation.claim(self.at, &set, &goal.formula);
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
                self.derivation.claim(self.at, &all, formula)
            };
            let larger = with(&conditions, &goal.formula);
            let Some(refuted) = search::refute_in_context(&claim, larger.clone()) else {
                continue;
            };
            let hints = self.auditor.hints();
            let mended = search::mended(&larger, chain, refuted.witness(), &hints, values_at);
            let Some(mut mended) = mended else {
                continue;
            };
            let meant = mended.proven.claim().goal.clone();
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

    /// Whether the step follows from a set where something is not 0, or is positive; or `still`, where something does not change.
    pub(in crate::audit) fn under_conditions(
        &self,
        goal: &Goal,
        set: Vec<Assumed>,
        witness: Option<&Assignment>,
        (still, effort): (bool, Effort),
        found: &mut Found,
    ) -> bool {
        let claim = self.derivation.claim(self.at, &set, &goal.formula);
        let unbounded = unbounded(&claim);
        if unbounded.is_empty() {
            return false;
        }
        let nonzero = self.nonzero(&claim, &unbounded, witness, effort, found);
        if nonzero.is_some_and(|own| self.holds_under(goal, set.clone(), &own, effort, found)) {
            return true;
        }
        if still && self.holds_still(goal, &set, claim, found) {
            return true;
        }
        if effort == Effort::Full && self.follows_divided(goal, &set, &unbounded, found) {
            return true;
        }
        // Who writes a root means the positive one.
        let conditions = match takes_root(&goal.formula) {
            true => self.positive(goal, &set, &unbounded),
            false => None,
        };
        // That there is a root at all may have to be proved.
        conditions.is_some_and(|conditions| {
            self.holds_under(goal, set.clone(), &conditions, Effort::Full, found)
        }) || effort == Effort::Full && self.follows_on_one_side(goal, &set, found)
    }

    /// Whether the step follows where nothing that is divided by is 0, if words say that something is: "Dividing (2) by (1)".
    fn follows_divided(
        &self,
        goal: &Goal,
        set: &[Assumed],
        unbounded: &[Symbol],
        found: &mut Found,
    ) -> bool {
        if !self.derivation.equations[self.at].divides {
            return false;
        }
        let mut factors = Set::new();
        let cited = set
            .iter()
            .filter(|own| matches!(own.source, Source::Equation(_)));
        for (left, right) in cited.filter_map(|own| own.formula.as_equation()) {
            collect_factors(left, &mut factors);
            collect_factors(right, &mut factors);
        }
        let factors = factors.into_iter().filter(|own| unbounded.contains(own));
        let conditions: Vec<Formula> = factors
            .map(|own| Formula::nonzero(Expr::Symbol(own)))
            .collect();
        let with = conditions.iter().map(step);
        let with: Vec<Assumed> = set.iter().cloned().chain(with).collect();
        !self.is_contradictory(&with, goal)
            && self.holds_under(goal, set.to_vec(), &conditions, Effort::Full, found)
    }

    /// Whether the step follows where what is differentiated nowhere does not change, and something is left that does.
    fn holds_still(&self, goal: &Goal, set: &[Assumed], claim: Claim, found: &mut Found) -> bool {
        let still = search::still_in(claim.clone());
        let mut own = Found::open(found.judged.clone());
        let holds = !still.is_empty()
            && self.holds_under(goal, set.to_vec(), &still, Effort::Full, &mut own)
            && search::is_possible(&claim, &own.conditions)
            && stated::constants(&own.judged, &own.conditions).is_some();
        if holds {
            *found = own;
        }
        holds
    }

    /// What must not vanish for the step to follow, where that is told of single symbols, or of what it is no equation for: who solves
    /// `x (a - b) = c` for `x` means `a ≠ b`, and who draws `x = 1` from `x^2 = 1` does not mean `x ≠ -1`.
    fn nonzero(
        &self,
        claim: &Claim,
        unbounded: &[Symbol],
        witness: Option<&Assignment>,
        effort: Effort,
        found: &mut Found,
    ) -> Option<Vec<Formula>> {
        let unless = search::missing_conditions(claim, witness, effort, &self.auditor.hints());
        found.has_conditions |= witness.is_some();
        let unless = unless?;
        let may_be_meant = |condition: &Formula| {
            let names = condition.free_symbols();
            let solved = || (claim.goal.as_equation()).map(|(left, _)| left.free_symbols());
            names.iter().all(|symbol| unbounded.contains(symbol))
                && (names.len() == 1 || solved().is_some_and(|own| own.is_disjoint(&names)))
        };
        let meant = unless.divided.iter().all(may_be_meant);
        let conditions = unless.conditions();
        // What is to be shown is no condition of its own.
        if conditions.contains(&claim.goal) {
            return None;
        }
        if witness.is_some() {
            found.conditions.clone_from(&conditions);
        }
        meant.then_some(conditions)
    }

    /// That all of the symbols are positive which are no numbers, with what must not vanish beside roots; if that can be.
    ///
    /// Where that cannot be, `U = -k/r`, those that the step speaks of are; or what logarithms and powers are taken of, `Q = -n R T \ln r`.
    pub(in crate::audit) fn positive(
        &self,
        goal: &Goal,
        set: &[Assumed],
        unbounded: &[Symbol],
    ) -> Option<Vec<Formula>> {
        self.all_positive(goal, set, unbounded).or_else(|| {
            let named = goal.formula.names();
            let of_goal: Vec<Symbol> = unbounded
                .iter()
                .filter(|&own| named.contains(own))
                .cloned()
                .collect();
            let fewer = of_goal.len() < unbounded.len();
            let of_goal = fewer
                .then(|| self.all_positive(goal, set, &of_goal))
                .flatten();
            of_goal.or_else(|| {
                let mut below = Set::new();
                let formulas = set.iter().map(|own| &*own.formula);
                for term in formulas.chain([&goal.formula]).flat_map(Formula::terms) {
                    collect_raised(term, &mut below);
                }
                let below: Vec<Symbol> = unbounded
                    .iter()
                    .filter(|&own| below.contains(own))
                    .cloned()
                    .collect();
                let fewer = !below.is_empty() && below.len() < unbounded.len();
                fewer
                    .then(|| self.all_positive(goal, set, &below))
                    .flatten()
            })
        })
    }

    fn all_positive(
        &self,
        goal: &Goal,
        set: &[Assumed],
        unbounded: &[Symbol],
    ) -> Option<Vec<Formula>> {
        let is_number = |symbol: &Symbol| {
            set.iter()
                .any(|a| a.formula.set_to_number() == Some(symbol))
        };
        let open = unbounded.iter().filter(|symbol| !is_number(symbol));
        let mut conditions: Vec<Formula> = open
            .map(|own| Formula::positive(Expr::Symbol(own.clone())))
            .collect();
        if conditions.is_empty() {
            return None;
        }
        let under = |conditions: &[Formula]| {
            let all = set.iter().cloned().chain(conditions.iter().map(step));
            let all: Vec<Assumed> = all.collect();
            self.derivation.claim(self.at, &all, &goal.formula)
        };
        let posed = search::pose(under(&conditions)).ok()?;
        conditions.extend(search::divided_beside_roots(posed.problem()));
        let claim = under(&conditions);
        let possible = search::consistency(&claim, &self.auditor.hints());
        matches!(possible, search::Consistency::Model(_)).then_some(conditions)
    }

    /// Whether the step follows under conditions; those that it does without are left out.
    pub(in crate::audit) fn holds_under(
        &self,
        goal: &Goal,
        set: Vec<Assumed>,
        conditions: &[Formula],
        effort: Effort,
        found: &mut Found,
    ) -> bool {
        let with = |conditions: &[Formula]| -> Vec<Assumed> {
            let conditions = conditions.iter().map(condition);
            set.iter().cloned().chain(conditions).collect()
        };
        let proved = |conditions: &[Formula]| {
            let claim = self
                .derivation
                .claim(self.at, &with(conditions), &goal.formula);
            let posed = search::pose(claim).ok()?;
            let derived = search::prove_posed(&posed, effort)?;
            Some((posed, derived))
        };
        let conditions = conditions.to_vec();
        // What is only found in earnest is not left out by those who try for little.
        let found_under = match effort {
            Effort::Full => search::fewest(conditions, proved),
            Effort::Light => proved(&conditions).map(|found| (found, conditions)),
        };
        let Some(((posed, derived), conditions)) = found_under else {
            return false;
        };
        let with = with(&conditions);
        let (kept, least) = self.least(with, goal, &posed, derived);
        let is_kept = |own: &&Formula| kept.contains(&condition(own));
        found.conditions = conditions.iter().filter(is_kept).cloned().collect();
        found.instead = sources(&kept);
        found.judged.assumed = kept;
        found.judged.outcome = Outcome::Proven(least.into());
        true
    }
}

/// The symbols that a side of an equation is divided by where one is divided by it.
fn collect_factors(side: &Expr, factors: &mut Set<Symbol>) {
    match side {
        Expr::Symbol(symbol) => {
            factors.insert(symbol.clone());
        }
        Expr::Product(parts) => parts.iter().for_each(|own| collect_factors(own, factors)),
        Expr::Power(part, _) | Expr::Quotient(part, _) | Expr::Negate(part) => {
            collect_factors(part, factors);
        }
        _ => {}
    }
}

/// Whether a root is written in a formula.
fn takes_root(formula: &Formula) -> bool {
    any_part(formula, &Expr::is_root)
}

/// Whether there is a logarithm, or a power with symbols in the exponent.
fn has_exponents(formula: &Formula) -> bool {
    any_part(formula, &|part| raised(part).is_some())
}

/// What a logarithm is taken of, or a power with symbols in the exponent.
fn raised(part: &Expr) -> Option<&Expr> {
    match part {
        Expr::Power(base, exponent) if !exponent.free_symbols().is_empty() => Some(base),
        Expr::Call(Function::Ln, of) => Some(of),
        _ => None,
    }
}

fn collect_raised(term: &Expr, found: &mut Set<Symbol>) {
    found.extend(raised(term).into_iter().flat_map(Expr::free_symbols));
    (term.children()).for_each(|child| collect_raised(child, found));
}

/// Whether an absolute value is.
fn takes_size(formula: &Formula) -> bool {
    any_part(formula, &|part| {
        matches!(part, Expr::Call(Function::Abs, _))
    })
}

fn any_part(formula: &Formula, is_meant: &dyn Fn(&Expr) -> bool) -> bool {
    let mut terms = formula.terms().into_iter();
    terms.any(|term| term.any(&is_meant))
}

/// The symbols that a step speaks of, or its premises, and of which nobody says where they lie.
pub(in crate::audit) fn unbounded(claim: &Claim) -> Vec<Symbol> {
    let named = Formula::free_symbols_of(claim.formulas()).into_iter();
    let said = |symbol: &Symbol| {
        let domain = claim.domains.get(symbol);
        domain.is_some_and(|d| d.nonzero || d.bounds().next().is_some())
    };
    let unbounded = named.filter(|symbol| !said(symbol) && !symbol.is_unit());
    unbounded.cloned().collect()
}
