//! Where all may be true that stands before a link, as far as floating point tells: what is near to the link is worth asking the kernel about
//! if it is true there, too.

use std::cell::Cell;

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, Source};
use crate::sampling::Sample;

use super::super::entry::Entry;
use super::super::readings::Circumstances;
use super::super::{Auditor, judge};

/// So many times it is tried to find out where all may be true; so many such places are enough, and so many are needed.
const MOST_SEEDS: u32 = 20;
/// So many terms are worked out for that.
const MOST_STEPS: u64 = 1_000_000;
const MOST_SAMPLES: usize = 3;
const FEWEST_SAMPLES: usize = 2;
/// So many are looked at for some where what the link speaks of is positive, too.
const LOOKED_AT: usize = 8;
/// So many times it is tried whether a law is true with what is near to a link.
const MOST_SAMPLES_WITH: u32 = 2;

impl Auditor<'_> {
    /// Where all may be true that stands before a link.
    pub(super) fn samples(
        &self,
        judge: &judge::Judge,
        how: &Circumstances,
        entry: &Entry,
        goal: &Goal,
    ) -> Samples {
        let mut all = entry.judged.iter();
        let links = all.clone().map(|own| &own.goal);
        let links = links.take_while(|own| own.sides != goal.sides);
        let links: Vec<Assumed> = links.map(|own| judge::step(&own.formula)).collect();
        // What laws say of particular things, `k_1 = A e^{-E/R T_1}`, it was judged from alone.
        let own = all.find(|own| own.goal.sides == goal.sides);
        let of_it = own.map_or(&[][..], |own| &own.assumed);
        let is_new = |own: &&Assumed| {
            let mut usable = how.usable.assumed.iter();
            !usable.any(|other| other.formula == own.formula)
        };
        let of_it: Vec<Assumed> = of_it.iter().filter(is_new).cloned().collect();
        let [near, all] = judge.others(how.premises);
        let open = judge.open_before(how.premises);
        let with = |others| -> Vec<&Formula> {
            let all = [&how.usable.assumed, &links, &of_it, others, &open];
            let mut all: Vec<&Assumed> = all.into_iter().flatten().collect();
            // What is cited says how something changes, and what words supposed of it before leaves constants open.
            if goal.formula.speaks_of_slopes() {
                all.sort_by_key(|own| matches!(own.source, Source::Local(..)));
            }
            all.into_iter().map(|own| &*own.formula).collect()
        };
        let mut sets = vec![with(near)];
        if !all.is_empty() {
            sets.insert(0, with(all));
        }
        // Where something is, how it moves leaves open.
        if !goal.formula.speaks_of_slopes() {
            for at in 0..sets.len() {
                let mut still = sets[at].clone();
                still.retain(|own| !own.speaks_of_slopes());
                if still.len() < sets[at].len() {
                    sets.push(still);
                }
            }
        }
        let of = |all| Samples::new(all, &sets[0], &goal.formula);
        // What nobody says the sign of is mostly meant to be positive.
        let mut of_any_sign = Vec::new();
        for premises in &sets {
            let mut found = where_true(premises, &goal.formula);
            let is_throughout = |own: &Sample| own.is_positive_with(&goal.formula);
            for is_positive in [
                &is_throughout as &dyn Fn(&Sample) -> bool,
                &Sample::is_positive,
            ] {
                if found.iter().filter(|own| is_positive(own)).count() >= FEWEST_SAMPLES {
                    found.retain(is_positive);
                    found.truncate(MOST_SAMPLES);
                    return of(found);
                }
            }
            of_any_sign.push(found);
        }
        let enough = of_any_sign
            .into_iter()
            .find(|own| own.len() >= FEWEST_SAMPLES);
        let any = || seeds(&sets[0], &goal.formula).take(MOST_SAMPLES).collect();
        let mut found: Vec<Sample> = enough.unwrap_or_else(any);
        found.truncate(MOST_SAMPLES);
        of(found)
    }
}

/// Places at which a link has a value, whatever stands before it.
pub(super) fn anywhere(goal: &Formula) -> Samples {
    let mut found = where_true(&[], goal);
    found.truncate(MOST_SAMPLES);
    Samples::new(found, &[], goal)
}

/// Where all may be true that stands before a link.
pub(super) struct Samples {
    all: Vec<Sample>,
    /// How that changes which the link gives; few links have such laws.
    laws: Vec<Formula>,
    /// What else stands before, if there are any.
    others: Vec<Formula>,
    /// So many terms may still be worked out to see whether laws are true.
    left: Cell<u64>,
}

impl Samples {
    fn new(all: Vec<Sample>, premises: &[&Formula], goal: &Formula) -> Samples {
        let of = match goal.as_equation() {
            Some((Expr::Symbol(own) | Expr::Apply(own, _), _)) => Some(own),
            _ => None,
        };
        let is_law = |own: &&&Formula| of.is_some_and(|of| says_how_changes(own, of));
        let (laws, others): (Vec<&Formula>, Vec<&Formula>) = premises.iter().partition(is_law);
        let kept = |all: Vec<&Formula>| -> Vec<Formula> { all.into_iter().cloned().collect() };
        Samples {
            all,
            others: match laws.is_empty() {
                true => Vec::new(),
                false => kept(others),
            },
            laws: kept(laws),
            left: Cell::new(MOST_STEPS),
        }
    }

    pub(super) fn are_enough(&self) -> bool {
        self.all.len() >= FEWEST_SAMPLES
    }

    /// Whether a formula is true at most of them: what is false in general may be true somewhere, `\sin\frac{n \pi}{2} = 0` at even `n`.
    pub(super) fn allow(&self, formula: &Formula) -> bool {
        let all = self.all.iter();
        2 * all.filter(|own| own.holds(formula) == Some(true)).count() > self.all.len()
    }

    /// Whether something near to the link is true wherever the premises are, or they are true with it: `w = \frac{F x^2}{6 E I} (3 L - x)`
    /// beside `E I \frac{dw}{dx} = F (L x - \frac{x^2}{2})`.
    pub(super) fn are_true_with(&self, formula: &Formula) -> bool {
        if self.all.iter().all(|own| own.holds(formula) == Some(true)) {
            return true;
        }
        let Some(first) = self.laws.first() else {
            return false;
        };
        (0..MOST_SAMPLES_WITH).all(|seed| {
            if self.left.get() == 0 {
                return false;
            }
            let all = [formula].into_iter().chain(&self.others);
            let sample = Sample::of(all, first, seed);
            let are_true = self.laws.iter().all(|own| sample.holds(own) == Some(true));
            self.left
                .set(self.left.get().saturating_sub(sample.steps()));
            are_true
        })
    }
}

/// Whether a formula is a law of how something changes.
fn says_how_changes(formula: &Formula, of: &Symbol) -> bool {
    let is_slope = |part: &Expr| match part {
        Expr::Derivative { body, .. } => {
            matches!(&**body, Expr::Symbol(own) | Expr::Apply(own, _) if own == of)
        }
        _ => false,
    };
    let mut terms = formula.terms().into_iter();
    formula.as_equation().is_some() && terms.any(|term| term.any(&is_slope))
}

/// Places at which a goal has a value, from different seeds.
fn seeds<'a>(premises: &'a [&Formula], goal: &'a Formula) -> impl Iterator<Item = Sample> + 'a {
    let mut left = MOST_STEPS;
    let samples = (0..MOST_SEEDS).map_while(move |seed| {
        let own = (left > 0).then(|| Sample::of(premises.iter().copied(), goal, seed))?;
        let has_value = own.has_value(goal);
        left = left.saturating_sub(own.steps());
        Some((own, has_value))
    });
    samples.filter_map(|(own, has_value)| has_value.then_some(own))
}

/// Those of these places at which premises are true, as far as that can be told, until there are enough at which all is positive, with what
/// the goal speaks of if that does not take long.
fn where_true(premises: &[&Formula], goal: &Formula) -> Vec<Sample> {
    let is_false = |own: &Sample, premise: &Formula| own.holds(premise) == Some(false);
    let fits = |own: &Sample| !premises.iter().any(|premise| is_false(own, premise));
    let (mut found, mut positive, mut throughout) = (Vec::new(), 0, 0);
    for own in seeds(premises, goal).filter(fits) {
        positive += usize::from(own.is_positive());
        throughout += usize::from(own.is_positive_with(goal));
        found.push(own);
        if throughout == MOST_SAMPLES || positive >= MOST_SAMPLES && found.len() >= LOOKED_AT {
            break;
        }
    }
    found
}
