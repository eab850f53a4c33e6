//! Frequencies of harmonic motion: "This is simple harmonic motion with the angular frequency $$\omega = \sqrt{\frac{k}{m}}$$" after
//! `m \ddot x = -k x`.
//!
//! What swings at `\omega` obeys `\ddot x = -\omega^2 x`. A frequency or a period is refuted where its law does not say that, and would with one
//! small edit.

use std::cmp::Reverse;

use crate::algebra::{Expr, Formula, Function, Symbol, effort, product_of};
use crate::derivation::{Assumed, Goal, Source, dotted, without_dots, words_of};
use crate::kernel::Standing;
use crate::search::Decision;
use crate::sorted::Set;

use super::super::judge::{Found, Judge, taken};
use super::super::{Judged, Outcome};
use super::obeys::order;

/// So much work is done for that, as [`effort`] counts it.
const MOST_WORK: u64 = 1_000_000;
/// With one of these something is said to swing.
const SWINGING: [&str; 7] = [
    "harmonic",
    "oscillates",
    "oscillate",
    "oscillation",
    "oscillations",
    "oscillator",
    "swings",
];
/// And with one of these not at the frequency of its law alone.
const OTHERWISE: [&str; 6] = ["damped", "damping", "driven", "forced", "beats", "beat"];
/// Where one of these is said, angles are as good as their sines.
const SMALL: [&str; 3] = ["small", "tiny", "slight"];
/// So many displays before may say it.
const MOST_BEFORE: usize = 4;

/// What is said of a frequency that is that of its law, where nobody says that all is positive, or how small is small.
const FOLLOWS: &str = "it follows from how what swings is pulled back, where all is positive and, if that is said, small";

/// What swings, and how.
struct Swing {
    law: Assumed,
    of: Expr,
    acceleration: Expr,
}

/// What a name stands for.
#[derive(Clone, Copy)]
enum Rate {
    Angular,
    Frequency,
    Period,
}

impl Rate {
    /// By the letter that is used for it.
    fn of(symbol: &Symbol) -> Option<Rate> {
        let stem = symbol.without_subscript();
        match stem.as_ref().unwrap_or(symbol).name() {
            "\\omega" | "\\Omega" => Some(Rate::Angular),
            "f" | "\\nu" => Some(Rate::Frequency),
            "T" => Some(Rate::Period),
            _ => None,
        }
    }

    /// The square of the angular frequency.
    fn squared(self, rate: Expr) -> Expr {
        let square = |own: Expr| Expr::Power(own.into(), Expr::integer(2).into());
        let full = || product_of(vec![Expr::integer(2), Expr::Symbol(Symbol::new("\\pi"))]);
        match self {
            Rate::Angular => square(rate),
            Rate::Frequency => square(product_of(vec![full(), rate])),
            Rate::Period => square(Expr::Quotient(full().into(), rate.into())),
        }
    }
}

impl Judge<'_> {
    /// What to say of a frequency that is not that of the law before it; of one that is, that it follows.
    pub(in crate::audit) fn as_no_frequency(
        &self,
        goal: &Goal,
        premises: &[usize],
    ) -> Option<Found> {
        let (rate, value) = match goal.formula.as_equation()? {
            // `T(d) = 2 \pi \sqrt{\dots}`
            (Expr::Apply(rate, _), value) => (rate, value),
            _ => goal.formula.said_of()?,
        };
        let kind = Rate::of(rate)?;
        let is_plain = goal.is_said_outright() && goal.rounding.is_none();
        if !is_plain
            || value.mentions(rate)
            || matches!(value, Expr::Number(_))
            || !self.text_has(&SWINGING, 1)
            || self.text_has(&OTHERWISE, 1)
        {
            return None;
        }
        let near = &self.others(premises)[0];
        let told = self.derivation.told(self.at);
        let known: Vec<&Assumed> = (told.iter())
            .chain(&self.usable.assumed)
            .chain(near)
            .collect();
        let is_small = self.text_has(&SMALL, MOST_BEFORE);
        let named = value.free_symbols();
        let swings = known.iter().filter_map(|own| swing_of(own, is_small));
        // The law is that which speaks most of what the value is made of, the nearest of these.
        let spoken = |own: &Swing| {
            let names = own.law.formula.names();
            named.iter().filter(|own| names.contains(*own)).count()
        };
        let swing = swings.min_by_key(|own| Reverse(spoken(own)));
        let swing = swing.filter(|own| spoken(own) > 0)?;
        effort::within(MOST_WORK, || {
            self.held_to(goal, (rate, kind), &swing, &known)
        })
    }

    fn held_to(
        &self,
        goal: &Goal,
        (rate, kind): (&Symbol, Rate),
        swing: &Swing,
        known: &[&Assumed],
    ) -> Option<Found> {
        let mut spoken = swing.law.formula.names();
        spoken.extend(goal.formula.names());
        // What the law speaks of may have been worked out before.
        let means = |own: &&&Assumed| {
            let said = own.formula.said_of();
            said.is_some_and(|(of, _)| spoken.contains(of) && of != rate)
                && !own.formula.speaks_of_slopes()
        };
        let meant = known.iter().filter(means).map(|own| (*own).clone());
        let mut all: Vec<Assumed> = vec![swing.law.clone()];
        all.extend(meant);
        let mut symbols: Set<Symbol> = all
            .iter()
            .flat_map(|own| own.formula.free_symbols())
            .collect();
        symbols.extend(goal.formula.free_symbols());
        symbols.retain(|own| undotted(own).is_none());
        all.extend(self.meant_positive(symbols));
        let rate = match goal.formula.terms()[0] {
            applied @ Expr::Apply(..) => {
                all.push(taken(&Formula::positive(applied.clone())));
                applied.clone()
            }
            _ => Expr::Symbol(rate.clone()),
        };
        let rate = kind.squared(rate);
        let pull = product_of(vec![rate, swing.of.clone()]);
        let swings = Formula::equal(swing.acceleration.clone(), Expr::Negate(pull.into()));
        all.push(taken(&swings));
        // It follows, and is found sooner where it is said.
        all.push(taken(&Formula::nonzero(swing.acceleration.clone())));
        match self.decide_from(&all, &goal.formula)? {
            Decision::Proven { .. } => Some(Found::open(Judged {
                goal: goal.clone(),
                assumed: all,
                outcome: Outcome::open(FOLLOWS),
            })),
            decision => self.one_slip_away(goal, &all, decision, |_| true),
        }
    }

    /// Whether one of some words stands in the text since so many displays before.
    fn text_has(&self, sought: &[&str], displays: usize) -> bool {
        let page = self.derivation.equations[self.at].page;
        let first = self.derivation.equations_of(page).start;
        let mut displays = (first..=self.at).rev().take(displays);
        displays.any(|at| {
            let mut words = words_of(self.derivation.text_before(at));
            words.any(|word| sought.contains(&word.as_str()))
        })
    }
}

/// The swing that a premise is the law of: nothing slows it down, and angles are small where that is said.
fn swing_of(own: &Assumed, is_small: bool) -> Option<Swing> {
    own.formula.as_equation()?;
    let names = own.formula.names();
    let mut accelerated = names
        .iter()
        .filter_map(|name| Some((name, undotted(name)?)));
    let (accelerated, other) = (accelerated.next(), accelerated.next());
    if other.is_some() {
        return None;
    }
    let (of, speed, acceleration) = match accelerated {
        Some((name, of)) => {
            let speed = Expr::Symbol(dotted(&of, false));
            (of, speed, Expr::Symbol(name.clone()))
        }
        None if order(&own.formula) == 2 => {
            let mut slopes = Set::new();
            let terms = own.formula.terms();
            terms
                .iter()
                .for_each(|term| term.collect_slopes(&mut slopes));
            slopes.retain(|(of, by)| of != by);
            let (of, by) = slopes.pop_first().filter(|_| slopes.is_empty())?;
            let speed = Expr::Symbol(of.clone()).differentiated_by(&by);
            (of, speed.clone(), speed.differentiated_by(&by))
        }
        None => return None,
    };
    let of = Expr::Symbol(of);
    let sine = Expr::Call(Function::Sin, of.clone().into());
    let small = |term: &Expr| match is_small {
        true => term.replace(&sine, &of),
        false => term.clone(),
    };
    let formula = own.formula.map_terms(small);
    // With the acceleration taken out nothing is left that moves but the place.
    let is_slowed = |term: &Expr| {
        let still = term.replace(&acceleration, &of);
        still.any(&|part| *part == speed || matches!(part, Expr::Derivative { .. }))
    };
    let swings = !formula.terms().into_iter().any(is_slowed);
    // For small angles it is not as it is printed.
    let source = match formula == *own.formula {
        true => own.source,
        false => Source::Taken,
    };
    swings.then(|| Swing {
        law: Assumed {
            formula: formula.into(),
            standing: Standing::AtPoint,
            source,
        },
        of,
        acceleration,
    })
}

/// What a name with two dots is the acceleration of: `\ddot{x}` of `x`.
fn undotted(name: &Symbol) -> Option<Symbol> {
    without_dots(name).filter(|own| own.1 == 2).map(|own| own.0)
}
