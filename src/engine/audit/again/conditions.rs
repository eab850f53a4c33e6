//! A step tried under conditions: that something is not 0, is positive, or does not change.

use crate::algebra::{BigRational, Expr, Formula, Function, Symbol};
use crate::derivation::{Assumed, Goal, Source};
use crate::kernel::{Assignment, Claim, Obligation};
use crate::search::{self, Effort};
use crate::sorted::Set;
use num_traits::Signed;

use super::super::judge::{Found, Judge, condition, sources, step};
use super::super::{Outcome, stated};

/// More differences that are squared are not supposed to be positive.
const MOST_SQUARED: usize = 3;

impl Judge<'_> {
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
        let posed = self.pose_claim(claim).ok();
        let nonzero = self.nonzero(posed.as_deref(), &unbounded, witness, effort, found);
        if nonzero.is_some_and(|own| self.holds_under(goal, set.clone(), &own, effort, found)) {
            return true;
        }
        if still
            && let Some(posed) = &posed
            && self.holds_still(goal, &set, posed, found)
        {
            return true;
        }
        if effort == Effort::Full
            && (self.follows_divided(goal, &set, &unbounded, found)
                || self.follows_over_what_is_positive(goal, &set, &unbounded, found))
        {
            return true;
        }
        // Who writes a root means the positive one, and who takes a logarithm takes it of what is positive.
        let (takes_root, takes_logarithm) = (
            takes_root(&goal.formula),
            takes_logarithm(&goal.formula) && !self.says_from_nothing(),
        );
        let conditions = match takes_root || takes_logarithm {
            true => self.positive(goal, &set, &unbounded),
            false => None,
        };
        // That there is a root at all may have to be proved.
        conditions.is_some_and(|conditions| {
            self.holds_under(goal, set.clone(), &conditions, Effort::Full, found)
        }) || takes_root && self.follows_by_signs(goal, &set, found)
            || (takes_logarithm || takes_root && integrates(&goal.formula))
                && self.follows_by_signs(goal, &[], found)
            || effort == Effort::Full && self.follows_on_one_side(goal, &set, found)
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
        self.holds_where_possible(goal, set, &conditions, found)
    }

    /// Whether the step follows under conditions that do not contradict what it follows from.
    fn holds_where_possible(
        &self,
        goal: &Goal,
        set: &[Assumed],
        conditions: &[Formula],
        found: &mut Found,
    ) -> bool {
        let with = conditions.iter().map(step);
        let with: Vec<Assumed> = set.iter().cloned().chain(with).collect();
        !self.is_contradictory(&with, goal)
            && self.holds_under(goal, set.to_vec(), conditions, Effort::Full, found)
    }

    /// Whether an inequality follows where all that it or what it is equivalent to is divided by is positive: who draws
    /// `\beta \geq \frac{q - p}{q - r}` from `\frac{p}{1 - \beta} \geq q + \frac{\beta r}{1 - \beta}` means `\beta < 1` and `q > r`.
    fn follows_over_what_is_positive(
        &self,
        goal: &Goal,
        set: &[Assumed],
        unbounded: &[Symbol],
        found: &mut Found,
    ) -> bool {
        if !goal.formula.is_inequality() {
            return false;
        }
        let mut below = Vec::new();
        let before = set.iter().filter(|own| own.source == Source::Step);
        let formulas = before.map(|own| &*own.formula).chain([&goal.formula]);
        let terms = formulas.flat_map(Formula::terms);
        terms.for_each(|term| collect_divisors(term, &mut below));
        let mut conditions: Vec<Formula> = Vec::new();
        for own in below {
            let symbols = own.free_symbols();
            let condition = Formula::positive(own);
            if !symbols.is_empty()
                && symbols.iter().all(|own| unbounded.contains(own))
                && !conditions.contains(&condition)
            {
                conditions.push(condition);
            }
        }
        // What they say by themselves is no step.
        let alone = || {
            let with: Vec<Assumed> = conditions.iter().map(step).collect();
            let claim = self.derivation.claim(self.at, &with, &goal.formula);
            search::prove_unconditionally(claim, Effort::Full).is_some()
        };
        !conditions.is_empty()
            && !alone()
            && self.holds_where_possible(goal, set, &conditions, found)
    }

    /// Whether the step follows where what is differentiated nowhere does not change, and something is left that does.
    fn holds_still(
        &self,
        goal: &Goal,
        set: &[Assumed],
        posed: &Obligation,
        found: &mut Found,
    ) -> bool {
        let still = search::still_in(posed);
        let mut own = Found::open(found.judged.clone());
        let under = |conditions: &[Formula], own: &mut Found| {
            self.holds_under(goal, set.to_vec(), conditions, Effort::Full, own)
        };
        let follows = !still.is_empty()
            && (under(&still, &mut own)
                || (self.divided_where_still(goal, set, &still, &mut own))
                    .is_some_and(|conditions| under(&conditions, &mut own)));
        let (held, _): (Vec<Formula>, Vec<Formula>) =
            (own.conditions.iter().cloned()).partition(stated::stands_still);
        let holds = follows
            && search::is_possible(posed.claim(), &own.conditions)
            && stated::constants(&own.judged, &held).is_some();
        if holds {
            *found = own;
        }
        holds
    }

    /// What does not change, and what is divided by besides: `q = (a - c)/(2 b)` where the slope of `P = (a - b q) q - c q` is zero.
    fn divided_where_still(
        &self,
        goal: &Goal,
        set: &[Assumed],
        still: &[Formula],
        found: &mut Found,
    ) -> Option<Vec<Formula>> {
        let held = still.iter().filter_map(|own| match own.as_equation()?.0 {
            Expr::Derivative { body, .. } => match &**body {
                Expr::Symbol(symbol) => Some(symbol.clone()),
                _ => None,
            },
            _ => None,
        });
        let claim = self.derivation.claim(self.at, set, &goal.formula);
        let claim = search::with_constants(claim, held);
        let unbounded = unbounded(&claim);
        let posed = self.pose_claim(claim).ok();
        let nonzero = self.nonzero(posed.as_deref(), &unbounded, None, Effort::Full, found)?;
        Some(still.iter().cloned().chain(nonzero).collect())
    }

    /// What must not vanish for the step to follow, where that is told of single symbols, or of what it is no equation for: who solves
    /// `x (a - b) = c` for `x` means `a ≠ b`, and who draws `x = 1` from `x^2 = 1` does not mean `x ≠ -1`.
    fn nonzero(
        &self,
        posed: Option<&Obligation>,
        unbounded: &[Symbol],
        witness: Option<&Assignment>,
        effort: Effort,
        found: &mut Found,
    ) -> Option<Vec<Formula>> {
        found.has_conditions |= witness.is_some();
        let posed = posed?;
        let unless = search::missing_conditions(posed, witness, effort, &self.auditor.hints())?;
        let claim = posed.claim();
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

    /// Whether the step follows where its own symbols are positive, from what speaks of nothing else: whether all that is before it is
    /// possible so may be more than can be told, beside exponentials.
    pub(super) fn follows_by_signs(&self, goal: &Goal, set: &[Assumed], found: &mut Found) -> bool {
        let named = goal.formula.names();
        let mut set = set.to_vec();
        set.retain(|own| own.formula.names().is_subset(&named) && !own.formula.speaks_of_values());
        let claim = self.derivation.claim(self.at, &set, &goal.formula);
        let mut free = unbounded(&claim);
        free.retain(|own| named.contains(own));
        let conditions = self.all_positive(goal, &set, &free);
        conditions.is_some_and(|own| self.holds_under(goal, set, &own, Effort::Full, found))
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
        // `\sqrt{2 g h} = 2 \sqrt{g L} \sin\frac{\theta}{2}` is meant where the sine is positive.
        let mut waves = Vec::new();
        let terms = goal.formula.terms();
        terms
            .into_iter()
            .for_each(|term| collect_waves(term, &mut waves));
        conditions.extend(waves.into_iter().map(Formula::positive));
        // So is `\sqrt{4 R/(1 - R)^2} = 2 \sqrt{R}/(1 - R)` where `R < 1`.
        if takes_root(&goal.formula) {
            let mut squared = Vec::new();
            let formulas = set.iter().map(|own| &*own.formula);
            let terms = formulas.chain([&goal.formula]).flat_map(Formula::terms);
            terms.for_each(|term| collect_squared(term, &mut squared));
            squared.truncate(MOST_SQUARED);
            conditions.extend(squared.into_iter().map(Formula::positive));
        }
        let under = |conditions: &[Formula]| {
            let all = set.iter().cloned().chain(conditions.iter().map(step));
            let all: Vec<Assumed> = all.collect();
            self.derivation.claim(self.at, &all, &goal.formula)
        };
        let posed = self.pose_claim(under(&conditions)).ok()?;
        conditions.extend(search::divided_beside_roots(posed.problem()));
        let anything = self::unbounded(posed.claim());
        let rest = without_definitions(set, unbounded, &anything);
        if rest.is_empty() {
            return Some(conditions);
        }
        // What is defined by the rest can be met wherever that can.
        let rest = rest.into_iter().cloned();
        let all: Vec<Assumed> = rest.chain(conditions.iter().map(step)).collect();
        let claim = self.derivation.claim(self.at, &all, &goal.formula);
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
            let posed = self.pose(&with(conditions), &goal.formula).ok()?;
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

/// Hypotheses without those that only say what a symbol is that may be `anything`, or by a term that is positive wherever some symbols are:
/// for any positive values of the others these can be met, `M = \frac{4}{3} \pi R^3 \rho` and `v = \sqrt{2 G M/R}`.
fn without_definitions<'a>(
    set: &'a [Assumed],
    positive: &[Symbol],
    anything: &[Symbol],
) -> Vec<&'a Assumed> {
    let mut rest: Vec<&Assumed> = set.iter().collect();
    loop {
        let is_free = |at: usize| {
            let Some((Expr::Symbol(own), term)) = rest[at].formula.as_equation() else {
                return false;
            };
            let others = rest.iter().enumerate().filter(|(other, _)| *other != at);
            let is_so = match positive.contains(own) {
                true => is_positive(term, positive),
                false => anything.contains(own) && own.name() != "\\pi",
            };
            is_so
                && !term.mentions(own)
                && !others
                    .flat_map(|(_, own)| own.formula.terms())
                    .any(|term| term.mentions(own))
        };
        match (0..rest.len()).find(|&at| is_free(at)) {
            Some(at) => rest.remove(at),
            None => return rest,
        };
    }
}

/// Whether a term is seen at once to be positive where some symbols are.
fn is_positive(term: &Expr, positive: &[Symbol]) -> bool {
    let inner = |part: &Expr| is_positive(part, positive);
    match term {
        Expr::Number(value) => value.is_positive(),
        Expr::Symbol(own) => positive.contains(own) || own.name() == "\\pi",
        Expr::Sum(parts) | Expr::Product(parts) => parts.iter().all(inner),
        Expr::Quotient(above, below) => inner(above) && inner(below),
        Expr::Power(base, _) => inner(base),
        Expr::Call(Function::Exp, _) => true,
        _ => false,
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

/// What a term is divided by.
pub(super) fn collect_divisors(term: &Expr, found: &mut Vec<Expr>) {
    if let Expr::Quotient(_, below) = term {
        found.push((**below).clone());
    }
    (term.children()).for_each(|child| collect_divisors(child, found));
}

/// Whether a root is written in a formula.
pub(super) fn takes_root(formula: &Formula) -> bool {
    any_part(formula, &Expr::is_root)
}

/// Whether something is integrated in a formula.
fn integrates(formula: &Formula) -> bool {
    any_part(formula, &|part| matches!(part, Expr::Integral { .. }))
}

/// Whether a logarithm is taken in a formula.
fn takes_logarithm(formula: &Formula) -> bool {
    any_part(
        formula,
        &|part| matches!(part, Expr::Call(Function::Ln, of) if !of.free_symbols().is_empty()),
    )
}

/// The differences that are squared in a term.
fn collect_squared(term: &Expr, found: &mut Vec<Expr>) {
    if let Expr::Power(base, exponent) = term
        && let (Expr::Sum(parts), Expr::Number(exponent)) = (&**base, &**exponent)
        && (exponent / BigRational::from_integer(2.into())).is_integer()
        && parts.iter().any(|part| matches!(part, Expr::Negate(_)))
        && !found.contains(base)
    {
        found.push((**base).clone());
    }
    (term.children()).for_each(|child| collect_squared(child, found));
}

/// What a logarithm is taken of, or a power with symbols in the exponent.
pub(super) fn raised(part: &Expr) -> Option<&Expr> {
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

pub(super) fn any_part(formula: &Formula, is_meant: &dyn Fn(&Expr) -> bool) -> bool {
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

/// The sines, cosines and tangents in a term.
pub(super) fn collect_waves(term: &Expr, found: &mut Vec<Expr>) {
    match term {
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, _) => {
            if !found.contains(term) {
                found.push(term.clone());
            }
        }
        _ => (term.children()).for_each(|child| collect_waves(child, found)),
    }
}
