//! What is said with `\pm`: `x = a \pm b` says that `x` is one of the two, that is `(x - (a + b)) (x - (a - b)) = 0`.
//!
//! The upper signs of one side belong together, and so do the lower ones. A chain in which both signs stand on several sides says two
//! things at once, and is not read; `5.0 \pm 0.1` is a value with its uncertainty.

use super::rounding::is_measured;
use super::statement::Place;
use super::{Kind, Parser, Read};
use crate::algebra::{Expr, Relation};
use crate::document::Span;
use crate::notation::{Link, Side, commands};

/// How a `\pm` is read.
#[derive(Clone, Copy)]
pub(super) struct Signs {
    lower: bool,
    /// The first one that was met.
    pub(super) met: Option<Span>,
}

impl Parser<'_> {
    /// Whether a `\pm` or `\mp` stands here, and is read.
    pub(super) fn at_both_signs(&self) -> bool {
        self.signs.is_some() && matches!(self.peek(), Kind::Command("pm" | "mp"))
    }

    /// Whether the sign that is read here is a minus.
    pub(super) fn lower_sign(&mut self, turned: bool) -> bool {
        let here = self.since(self.at - 1);
        let Some(signs) = &mut self.signs else {
            return false;
        };
        signs.met.get_or_insert(here);
        signs.lower != turned
    }

    /// A place in a chain, read twice where both signs stand in it.
    pub(super) fn place_with_signs(&mut self) -> Read<Place> {
        let (start, choices, names) = (self.at, self.choices.len(), self.before.len());
        let upper = Signs {
            lower: false,
            met: None,
        };
        self.signs = Some(upper);
        let first = self.place();
        let met = self.signs.take().and_then(|signs| signs.met);
        let Some(sign) = met else {
            return first;
        };
        let Place::Side(first) = first? else {
            return refuse_signs(sign);
        };
        let end = self.at;
        self.at = start;
        self.choices.truncate(choices);
        self.before.truncate(names);
        self.signs = Some(Signs {
            lower: true,
            ..upper
        });
        let second = self.place();
        self.signs = None;
        match second? {
            Place::Side(second) if self.at == end => {
                if is_measured(&first.expr) {
                    let side = self.with_uncertainty(start, first, sign)?;
                    return Ok(Place::Side(side));
                }
                Ok(Place::Either {
                    upper: first,
                    lower: second,
                    sign,
                })
            }
            _ => refuse_signs(sign),
        }
    }
}

/// The refusal of both signs.
pub(super) fn refuse_signs<T>(span: Span) -> Read<T> {
    let (message, help) = commands::complaint("pm");
    Err(crate::notation::SyntaxError {
        span,
        message,
        help,
    })
}

/// A chain of one link with both signs on one side, as the product that is 0.
pub(super) fn either(mut places: Vec<Place>, links: &[Link]) -> Read<Vec<Place>> {
    let two = matches!(
        &places[..],
        [Place::Side(_), Place::Either { .. }] | [Place::Either { .. }, Place::Side(_)]
    );
    if !two || !matches!(links, [link] if link.relation == Relation::Equal && !link.questioned) {
        return Ok(places);
    }
    if let Place::Either { .. } = places[0] {
        places.reverse();
    }
    let mut places = places.into_iter();
    let (Some(Place::Side(one)), Some(Place::Either { upper, lower, .. })) =
        (places.next(), places.next())
    else {
        return Ok(Vec::new());
    };
    let less = |other: Expr| {
        let other = Expr::Negate(other.into());
        Expr::Sum([one.expr.clone(), other].into())
    };
    let side = |expr: Expr, span: Span| {
        Place::Side(Side {
            expr,
            span,
            terms: vec![span],
            rounding: None,
            truncated: false,
        })
    };
    let product = Expr::Product([less(upper.expr), less(lower.expr)].into());
    Ok(vec![
        side(product, one.span.to(upper.span)),
        side(Expr::integer(0), upper.span),
    ])
}
