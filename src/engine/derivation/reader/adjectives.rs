//! What the text says of symbols by adjectives.

use num_traits::Zero;

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::document::{Attribute, Prose, Qualities, Supposition, SuppositionKind, Vanishing};
use crate::notation::Spanned;

use super::super::qualities;
use super::Reader;

impl Reader<'_> {
    /// Takes up what is said by adjectives: in the display that the sentence is of, too.
    pub(super) fn qualities(&mut self, prose: &Prose) {
        let mut all = prose.suppositions.iter();
        let left = all.rfind(|own| own.kind.leaves_cases());
        if left.is_some() {
            self.sayings.forget();
        }
        if prose.qualities.iter().any(|own| own.of_case) {
            self.sayings.leave_case();
        }
        let is_here = |own: &Qualities| left.is_none_or(|left| left.body.start < own.body.start);
        for quality in prose.qualities.iter().filter(|own| is_here(own)) {
            let is_same = |own: &Supposition| {
                own.body == quality.body && matches!(own.kind, SuppositionKind::Compared { .. })
            };
            if !prose.suppositions.iter().any(is_same) || !self.is_compared(quality.body) {
                self.quality(quality);
            }
        }
        for &body in &prose.changing {
            let changing = qualities::spoken_of(&self.page.document.source, body);
            self.sayings.forget_these(&changing);
        }
    }

    /// "For negative $x$" leaves "If $x > 0$".
    fn leave_other_signs(&mut self, symbol: &Symbol, attributes: &[Spanned<Attribute>]) {
        let bound = |attribute: &Spanned<Attribute>| {
            let (relation, number) = match &attribute.value {
                Attribute::Positive => (Relation::Greater, Expr::integer(0)),
                Attribute::Nonnegative => (Relation::GreaterOrEqual, Expr::integer(0)),
                Attribute::Nonzero => (Relation::NotEqual, Expr::integer(0)),
                Attribute::Interval {
                    lower: None,
                    upper: Some(upper),
                } if upper.value.is_zero() => (Relation::Less, Expr::integer(0)),
                _ => return None,
            };
            Some(Formula::Relation {
                left: Expr::Symbol(symbol.clone()),
                relation,
                right: number,
            })
        };
        let bounds: Vec<Formula> = attributes.iter().filter_map(bound).collect();
        let locals = &self.page.locals;
        self.active
            .retain(|&at| !locals[at].is_ruled_out_by(&bounds));
    }

    fn quality(&mut self, quality: &Qualities) {
        self.displayed.learn(&self.equations, &[]);
        let named = match quality.by_name {
            true => {
                let place = (quality.body, &self.equations[..], &[][..]);
                match self.page.vanishing(Vanishing::Named, place) {
                    Some(Expr::Symbol(symbol)) => vec![symbol],
                    _ => Vec::new(),
                }
            }
            false => qualities::named(&self.page.document.source, quality.body),
        };
        let attributes = quality.attributes.iter().cloned();
        let attributes: Vec<Spanned<Attribute>> = attributes
            .map(|value| Spanned {
                value,
                span: quality.body,
            })
            .collect();
        for symbol in &named {
            self.leave_other_signs(symbol, &attributes);
            for attribute in &attributes {
                let of_case = quality.of_case;
                let introduces = !of_case && !self.displayed.speaks_of(symbol);
                let level = if introduces { 0 } else { self.level };
                self.sayings.take(symbol, attribute.clone(), level, of_case);
            }
            if quality.goes_on {
                for equation in &mut self.equations[self.last.clone()] {
                    let said = equation.said.entry(symbol.clone()).or_default();
                    said.attributes.extend(attributes.iter().cloned());
                }
            }
        }
    }
}
