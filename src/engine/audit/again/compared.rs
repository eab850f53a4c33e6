//! What is compared as words say, for every value of a variable: "Matching coefficients".

use std::sync::Arc;

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal};
use crate::kernel::Standing;

use super::super::judge::Judge;

/// With one of these a text says that two terms are compared for every value of a variable.
const COMPARING: [&str; 7] = [
    "slope",
    "intercept",
    "coefficient",
    "coefficients",
    "comparing",
    "comparison",
    "matching",
];
/// So it goes on with one of these before that: "Comparing this with the standard form $$…$$ one reads off".
const READING: [&str; 3] = ["read", "reads", "reading"];
const OFF: [&str; 1] = ["off"];
/// Or with one of these: "Comparison with the standard form $$…$$ identifies".
const GIVING: [&str; 12] = [
    "gives",
    "give",
    "yields",
    "yield",
    "identifies",
    "identify",
    "shows",
    "show",
    "get",
    "obtain",
    "find",
    "identified",
];
/// So many equations with the left side of another are compared with that.
const MOST_SAME: usize = 3;

impl Judge<'_> {
    /// Whether words say that terms are compared.
    pub(super) fn compares(&self) -> bool {
        let goes_on = || {
            let before = self.derivation.before_display(self.at);
            before.is_some_and(|before| self.is_led_to_by(before, &COMPARING))
        };
        self.says(&COMPARING)
            || (self.says_in_a_row(&READING, &OFF) || self.says(&GIVING)) && goes_on()
    }

    /// What is compared as words say, for every value of a variable that the step leaves out: "From slope $b$ and intercept $a$" of
    /// `\frac{4 \pi^2}{k} (m + M) = a + b m` for every `m`, or two equations with the same left side, `H = \frac{1}{1 + s \tau}` and
    /// `H = \frac{\omega}{\omega + s}`.
    pub(super) fn compared(&self, goal: &Goal, set: &[Assumed]) -> Vec<(Symbol, Vec<Assumed>)> {
        if !self.compares() {
            return Vec::new();
        }
        let laws: Vec<&Assumed> = (set.iter())
            .filter(|own| own.standing == Standing::Identity)
            .collect();
        let named = goal.formula.names();
        let mut compared = Vec::new();
        for own in equated(&laws) {
            let Some((left, right)) = own.first().and_then(|own| own.formula.as_equation()) else {
                continue;
            };
            let right = right.free_symbols();
            let both = left.free_symbols().into_iter();
            let both = both.filter(|own| right.contains(own));
            let both = both.filter(|own| !own.is_unit() && !named.contains(own));
            compared.extend(both.map(|variable| (variable, own.clone())));
        }
        compared
    }
}

/// What the laws say of terms that are written out, and what follows where two of them say what the same is: `A = B` from `H = A` and `H = B`,
/// once from each of the two. A function that is only named may be anything, and nothing follows from what it is.
fn equated(laws: &[&Assumed]) -> Vec<Vec<Assumed>> {
    let is_named = |part: &Expr| matches!(part, Expr::Apply(..));
    let is_written = |own: &&Expr| !own.any(&is_named);
    let sides = laws
        .iter()
        .filter_map(|own| Some((*own, own.formula.as_equation()?)));
    let mut sides: Vec<(&Assumed, (&Expr, &Expr))> = sides.collect();
    // What a chain begins with is what it ends with, `\frac{Y}{R} = \frac{K G}{1 + K G} = \frac{K b}{s^2 + a s + K b}`.
    let links = sides.len();
    for at in 0..links {
        let (own, (left, mut end)) = sides[at];
        for next in at + 1..links {
            let (other, (start, right)) = sides[next];
            if other.source != own.source || start != end {
                break;
            }
            end = right;
            sides.push((own, (left, end)));
        }
    }
    let mut found: Vec<Vec<Assumed>> = (sides.iter())
        .filter(|(_, (left, right))| is_written(left) && is_written(right))
        .map(|own| vec![own.0.clone()])
        .collect();
    for (at, (own, (left, one))) in sides.iter().enumerate() {
        let same = sides[at + 1..].iter().filter(|other| other.1.0 == *left);
        let same = same.filter(|other| is_written(one) && is_written(&other.1.1));
        found.extend(same.take(MOST_SAME).map(|(second, (_, other))| {
            let formula = Arc::new(Formula::equal((*one).clone(), (*other).clone()));
            let from = |law: &Assumed| Assumed {
                formula: Arc::clone(&formula),
                ..law.clone()
            };
            vec![from(own), from(second)]
        }));
    }
    found
}
