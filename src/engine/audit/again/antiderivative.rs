//! What a further integration is said to give, where no law says of what: `x = v_0 [t - \tau (1 - e^{-t/\tau})]` after
//! `v = v_0 (1 - e^{-t/\tau})`, "A further integration yields".
//!
//! Authors leave unsaid that the one is the slope of the other. It is refuted where it is not, and would be with one small edit; not where both
//! differ by a factor, for something may stand between them.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source, first_goal, values_at};
use crate::kernel::Standing;
use crate::search::{self, Decision, Effort, InChain, Mended, Slips};

use super::super::judge::{Found, Judge, positive, taken};
use super::super::{Judged, Outcome};

/// After one of these a step integrates what stands before.
pub(super) const INTEGRATING: [&str; 6] = [
    "integrate",
    "integrated",
    "integrates",
    "integrating",
    "integration",
    "integrations",
];
/// With one of these it does something else with it, too.
const OTHERWISE: [&str; 9] = [
    "separate",
    "separating",
    "separation",
    "parts",
    "divide",
    "dividing",
    "multiply",
    "multiplying",
    "twice",
];
/// So much work is done for that, as [`effort`] counts it.
const MOST_WORK: u64 = 1_000_000;
/// So many edits are tried.
const MOST_EDITS: usize = 60;

impl Judge<'_> {
    /// What to say of a new quantity that is no integral of the one that the display before gives.
    pub(in crate::audit) fn as_no_integral(&self, goal: &Goal) -> Option<Found> {
        let (new, value) = goal.formula.as_equation()?;
        let new = match new {
            Expr::Symbol(name) | Expr::Apply(name, _) => name,
            _ => return None,
        };
        let is_integral = goal.is_said_outright()
            && goal.rounding.is_none()
            && self.says(&INTEGRATING)
            && !self.says(&OTHERWISE);
        if !is_integral {
            return None;
        }
        let before = self.derivation.before_display(self.at)?;
        let slope = first_goal(self.derivation.equations[before].statements().first()?)?;
        let (Expr::Symbol(of), rate) = slope.formula.as_equation()? else {
            return None;
        };
        let variable = self.variable_of(&Expr::Symbol(of.clone()))?;
        let is_rate = rate.mentions(&variable) && !rate.mentions(of) && !rate.mentions(new);
        if !is_rate || !value.mentions(&variable) || value.mentions(of) || of == new {
            return None;
        }
        effort::within(MOST_WORK, || {
            self.held_against_rate(goal, before, &slope.formula, &variable)
        })
    }

    fn held_against_rate(
        &self,
        goal: &Goal,
        before: usize,
        given: &Formula,
        variable: &Symbol,
    ) -> Option<Found> {
        let (new, value) = goal.formula.as_equation()?;
        let (of, rate) = given.as_equation()?;
        let moves = |own: &Symbol| self.auditor.changes(self.at, own, variable);
        let mut constants = value.free_symbols();
        constants.extend(rate.free_symbols());
        let page = &self.derivation.pages[self.derivation.equations[self.at].page];
        constants.retain(|own| own != variable && !page.is_number(own));
        if constants.iter().any(moves) {
            return None;
        }
        let slope = value.clone().differentiated_by(variable);
        let given = Assumed {
            formula: given.clone().into(),
            standing: Standing::Identity,
            source: Source::Equation(before),
        };
        // What is divided by is not 0.
        let positive = constants.iter().map(positive);
        let assumed: Vec<Assumed> = [given].into_iter().chain(positive).collect();
        let claim = |assumed: &[Assumed], formula: &Formula| {
            let claim = self.derivation.claim(self.at, assumed, formula);
            search::with_constants(claim, constants.iter().cloned())
        };
        let formula = Formula::equal(slope.clone(), of.clone());
        let own = claim(&assumed, &formula);
        let Decision::Refuted(refuted) = self.decide(&*self.pose_claim(own.clone()).ok()?) else {
            return None;
        };
        // "Integrating the current over the capacitance" differs by that.
        let ratio = Expr::Quotient(slope.into(), rate.clone().into()).differentiated_by(variable);
        let is_multiple = Formula::equal(ratio, Expr::integer(0));
        let is_multiple = claim(&[], &is_multiple);
        let is_multiple = search::prove_unconditionally(is_multiple.clone(), Effort::Light)
            .is_some()
            || search::pose(is_multiple).is_ok_and(|posed| {
                search::missing_conditions(&posed, None, Effort::Light, &[]).is_some()
            });
        if is_multiple {
            return None;
        }
        let bare = claim(&[], &goal.formula);
        let slips = Slips::of(&bare, &InChain::default(), None, values_at).and_rarer();
        let shown = |formula: &Formula| {
            search::prove_unconditionally(claim(&assumed, formula), Effort::Light)
        };
        let at_nought = |own: &Expr| own.substitute(variable, &Expr::integer(0));
        let mut mended: Option<Mended> = None;
        for edit in slips.take(MOST_EDITS) {
            let Some((_, near)) = edit.formula.as_equation() else {
                continue;
            };
            let is_slope = Formula::equal(near.clone().differentiated_by(variable), of.clone());
            let Some(derived) = shown(&is_slope) else {
                continue;
            };
            // Of several the one is meant that begins where the printed one does.
            let begins = Formula::equal(at_nought(near), at_nought(value));
            let begins_so = shown(&begins).is_some();
            if mended.is_none() || begins_so {
                mended = Some(Mended::of(derived.proven, edit.change));
            }
            if begins_so {
                break;
            }
        }
        let mended = mended?;
        let meant = Formula::equal(new.clone().differentiated_by(variable), of.clone());
        let assumed = assumed.into_iter().chain([taken(&meant)]).collect();
        let mut found = Found::open(Judged {
            goal: Goal {
                formula,
                ..goal.clone()
            },
            assumed,
            outcome: Outcome::Refuted(refuted.into()),
        });
        found.mended = Some(mended.into());
        found.constant = constants.into_iter().collect();
        Some(found)
    }
}
