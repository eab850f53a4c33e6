//! Steps after an approximation in words: "the liquid takes negligible room, $\Delta v \approx v_g$", "for small angles
//! $\sin\theta \approx \theta$".
//!
//! What is near something is not that, so nothing is proved by it; nor is anything refuted that follows where one is put for the other.

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::derivation::{Assumed, Goal, Source, formulas};
use crate::notation::{is_figures, plain, read_formulas};
use crate::search::Decision;

use super::super::judge::{Found, Judge};
use crate::sorted::Set;

/// More approximations than this are not put in.
const MOST: usize = 4;

impl Judge<'_> {
    /// Leaves open, and tells why, what follows where what the text before it calls near something is taken for that.
    pub(in crate::audit) fn heed_approximations(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        if found.judged.outcome.is_proven() {
            return;
        }
        let mut near = self.approximations();
        near.extend(self.displayed_to_be_near(assumed));
        if near.is_empty() || near.len() > MOST {
            return;
        }
        let put = |formula: &Formula| {
            let own = |term: &Expr| {
                near.iter()
                    .fold(term.clone(), |term, (a, b)| term.replace(a, b))
            };
            formula.map_terms(own)
        };
        let told = self.derivation.told(self.at);
        let all = assumed.iter().chain(&told).map(|own| Assumed {
            formula: put(&own.formula).into(),
            ..own.clone()
        });
        let all: Vec<Assumed> = all.collect();
        let changed = |own: &Assumed| {
            assumed
                .iter()
                .chain(&told)
                .all(|o| o.formula != own.formula)
        };
        let goal = Goal {
            formula: put(&goal.formula),
            ..goal.clone()
        };
        if !all.iter().any(changed) || self.is_contradictory(&all, &goal) {
            return;
        }
        let follows = |all: &[Assumed]| {
            let decision = self.decide_from(all, &goal.formula);
            matches!(decision, Some(Decision::Proven { .. }))
        };
        // "$I \ddot\phi = -M g d \phi$" is so for no positive values.
        let follows_where_positive = || {
            let positive = self.where_all_is_positive(&goal, all.clone());
            !self.is_contradictory(&positive, &goal) && follows(&positive)
        };
        if follows(&all) || follows_where_positive() {
            let said: Vec<String> = near
                .iter()
                .map(|(a, b)| format!("`{} ≈ {}`", plain(a), plain(b)))
                .collect();
            found.leave_open(format!(
                "it follows where {} is taken for equal, and how near it is was not judged",
                said.join(" and ")
            ));
        }
    }

    /// What the displays that premises come from say is near something else in symbols: `a = \frac{M}{(d - r)^2} - \frac{M}{d^2} \approx
    /// \frac{2 M r}{d^3}`.
    fn displayed_to_be_near(&self, assumed: &[Assumed]) -> Vec<(Expr, Expr)> {
        let cited = assumed.iter().filter_map(|own| match own.source {
            Source::Equation(premise) => Some(premise),
            _ => None,
        });
        // What says nothing else is no premise, and is cited all the same.
        let (premises, ..) = self.derivation.premises(self.at);
        let cited: Set<usize> = cited.chain(premises.iter().copied()).collect();
        let statements = cited
            .into_iter()
            .flat_map(|own| self.derivation.equations[own].statements());
        let near = statements.flat_map(formulas).filter_map(|own| match own {
            Formula::Relation {
                left,
                relation: Relation::Approximately,
                right,
            } if !is_figures(&right) => Some((left, right)),
            _ => None,
        });
        near.collect()
    }

    /// What the text between the display before and this one says is near something else.
    pub(in crate::audit) fn approximations(&self) -> Vec<(Expr, Expr)> {
        let own = &self.derivation.equations[self.at];
        let document = &self.derivation.pages[own.page].document;
        let bodies = self.derivation.inline_before(self.at).map(|math| math.body);
        let mut found = Vec::new();
        for body in bodies {
            let text = document.text(body);
            if !["\\approx", "\\simeq", "≈", "\\sim"]
                .iter()
                .any(|sign| text.contains(sign))
            {
                continue;
            }
            let read = read_formulas(&document.source, body).unwrap_or_default();
            for said in read.iter().flat_map(formulas) {
                if let Formula::Relation {
                    left,
                    relation: Relation::Approximately,
                    right,
                } = said
                    && !matches!(left, Expr::Number(_))
                    && !right.free_symbols().iter().all(Symbol::is_unit)
                {
                    found.push((left, right));
                }
            }
        }
        found
    }
}
