//! Limits, what a term grows by from one to the other, `\left[ \frac{x^2}{2} \right]_a^b` or `\frac{x^2}{2} \Big|_a^b`, and what it is
//! at a place, `\left. \frac{dU}{dx} \right|_{x = a}`: the limit there, which is the value of what does not jump.
//!
//! What runs from `a` to `b` in a bracket is told there, `_{x=a}^{x=b}`, or by the integral before it in the same display that has
//! the same limits. A limit that is infinite is taken as a limit: `\int_a^\infty f \, dx` is `\lim_{x' \to \infty} \int_a^{x'} f \, dx`.

use super::{Factor, Kind, Parser, Read, Shape, refuse, refuse_with};
use crate::algebra::{Expr, LimitPoint, Relation, Symbol, split_subscript};
use crate::document::Span;

/// A bracket is looked up among so many integrals before it.
const NEAR: usize = 16;
/// These mostly name places where something begins or ends.
const LENGTHS: [&str; 7] = ["a", "b", "d", "l", "\\ell", "L", "R"];

/// Where something begins and ends.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Limits {
    pub(super) from: Limit,
    pub(super) to: Limit,
}

/// One limit.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Limit {
    /// What runs, where that is said: `x` in `_{x = a}`.
    of: Option<Symbol>,
    at: LimitPoint,
}

impl Limits {
    /// The integral between these limits.
    pub(super) fn integral(self, body: Expr, variable: Symbol, sign: Span) -> Read<Expr> {
        let named = [&self.from, &self.to]
            .into_iter()
            .filter_map(|own| own.of.as_ref());
        if named.into_iter().any(|own| *own != variable) {
            return refuse(sign, "the limits of this integral are of another variable");
        }
        let outside = [&self.from.at, &self.to.at]
            .into_iter()
            .filter_map(|own| match own {
                LimitPoint::Finite(own) => Some(&**own),
                _ => None,
            });
        let outside: Vec<Expr> = outside.cloned().collect();
        // A name that nothing else in it has, and whose dimension is the same.
        let mut far = Symbol::new(format!("{variable}'"));
        while body.mentions(&far) || outside.iter().any(|own| own.mentions(&far)) {
            far = Symbol::new(format!("{far}'"));
        }
        let mut taken = None;
        let mut end = |limit: LimitPoint| match limit {
            LimitPoint::Finite(at) => Ok(at),
            far_away if taken.is_none() => {
                taken = Some(far_away);
                Ok(Expr::Symbol(far.clone()).into())
            }
            _ => refuse(
                sign,
                "of the limits of an integral only one may be infinite",
            ),
        };
        let integral = Expr::Integral {
            from: end(self.from.at)?,
            to: end(self.to.at)?,
            body: body.into(),
            variable,
        };
        Ok(match taken {
            None => integral,
            Some(point) => Expr::Limit {
                body: integral.into(),
                variable: far,
                point,
            },
        })
    }
}

impl Parser<'_> {
    /// `_a^b` or `^b_a`, if both are here.
    pub(super) fn limits(&mut self) -> Read<Option<Limits>> {
        let (from, to) = self.scripted()?;
        Ok(from.zip(to).map(|(from, to)| Limits { from, to }))
    }

    fn scripted(&mut self) -> Read<(Option<Limit>, Option<Limit>)> {
        let (mut from, mut to) = (None, None);
        loop {
            match self.peek() {
                Kind::Char('_') if from.is_none() => {
                    self.advance();
                    from = Some(self.one_limit("_")?);
                }
                Kind::Char('^') if to.is_none() => {
                    self.advance();
                    to = Some(self.one_limit("^")?);
                }
                _ => return Ok((from, to)),
            }
        }
    }

    fn one_limit(&mut self, sign: &str) -> Read<Limit> {
        let braces = self.peek() == Kind::Open;
        let open = self.span();
        let first = self.at + usize::from(braces);
        // `x = a`
        let mut of = None;
        if braces && self.has_relation(self.at) {
            self.advance();
            if !self.starts_name(self.at) {
                return self.unexpected();
            }
            of = Some(self.variable(false)?.0);
            if !matches!(self.peek(), Kind::Relation(Relation::Equal, _)) {
                return self.unexpected();
            }
            self.advance();
        }
        let at = if of.is_some() { self.at } else { first };
        let signed = usize::from(braces && matches!(self.kind(at), Kind::Char('+' | '-')));
        if self.kind(at + signed) == Kind::Command("infty") {
            let minus = self.kind(at) == Kind::Char('-');
            self.at = at + signed + 1;
            if braces {
                self.close(open)?;
            }
            let at = match minus {
                true => LimitPoint::MinusInfinity,
                false => LimitPoint::PlusInfinity,
            };
            return Ok(Limit { of, at });
        }
        let at = match of {
            None => self.argument(sign)?,
            Some(_) => {
                let at = self.inside(false, Self::sum)?;
                self.close(open)?;
                at.expr
            }
        };
        let at = LimitPoint::Finite(at.into());
        Ok(Limit { of, at })
    }

    /// Whether a relation sign stands in the group that opens here.
    pub(super) fn has_relation(&self, open: usize) -> bool {
        let end = self.after_group(open).unwrap_or(open);
        let mut depth = 0usize;
        (open..end).any(|at| {
            match self.kind(at) {
                Kind::Open | Kind::Char('(' | '[') => depth += 1,
                Kind::Close | Kind::Char(')' | ']') => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth == 1 && matches!(self.kind(at), Kind::Relation(..))
        })
    }

    /// Whether limits follow a bracket.
    pub(super) fn at_limits(&self) -> bool {
        self.limits_at(self.at)
    }

    fn limits_at(&self, at: usize) -> bool {
        match self.kind(at) {
            Kind::Char('_') => true,
            Kind::Char('^') => {
                let power = match self.kind(at + 1) {
                    Kind::Open => self.after_group(at + 1),
                    _ => Some(at + 2),
                };
                power.is_some_and(|after| self.kind(after) == Kind::Char('_'))
            }
            _ => false,
        }
    }

    /// Whether limits follow the bracket that opens at a place. Brackets with limits are short.
    pub(super) fn bracket_has_limits(&self, open: usize) -> bool {
        const FAR: usize = 400;
        let mut depth = 0usize;
        for at in open..open + FAR {
            match self.kind(at) {
                Kind::Char('[') => depth += 1,
                Kind::Char(']') => depth -= 1,
                Kind::End => return false,
                _ => {}
            }
            if depth == 0 {
                return self.limits_at(at + 1);
            }
        }
        false
    }

    /// `\left. f \right|` with limits or a place, which follow.
    pub(super) fn bounded(&mut self) -> Read<Factor> {
        let start = self.at;
        self.at += 2;
        let open = self.since(start);
        let content = self.inside(false, Self::sum)?;
        if self.peek() == Kind::End {
            return refuse(open, "this is never closed");
        }
        if self.peek() != Kind::Command("right") || !self.is_bar(self.at + 1) {
            return refuse_with(
                self.span(),
                "`\\right|` is expected here, to close what was opened",
                "write `\\left. f \\right|_{x = a}`",
            );
        }
        self.at += 2;
        // `\left. \frac{\partial U}{\partial V} \right|_T`
        let names = self.kind(self.at + 1) != Kind::Open || !self.has_relation(self.at + 1);
        if let partial @ Expr::Partial { .. } = content.expr.clone()
            && self.peek() == Kind::Char('_')
            && names
        {
            return Ok(Factor {
                expr: self.held_fixed(partial)?,
                shape: Shape::Tight,
                span: self.since(start),
                braces: false,
            });
        }
        Ok(self.between(start, &content.expr, false)?.0)
    }

    fn is_bar(&self, at: usize) -> bool {
        matches!(
            self.kind(at),
            Kind::Char('|') | Kind::Command("vert" | "rvert")
        )
    }

    /// Whether a bar stands here that what stands before it is evaluated at: `f |_{x = a}`.
    pub(super) fn at_bar(&self) -> bool {
        !self.bar && self.is_bar(self.at) && matches!(self.kind(self.at + 1), Kind::Char('_' | '^'))
    }

    /// What a term is at the place that follows, `_{x = a}`, or grows by between the limits that do; and what runs there. `square` are
    /// brackets, not a bar.
    pub(super) fn between(
        &mut self,
        start: usize,
        term: &Expr,
        square: bool,
    ) -> Read<(Factor, Symbol)> {
        let sign = self.at;
        let (mut from, to) = self.scripted()?;
        // `\left. \frac{d\phi}{dr} \right|_a`
        if let (Some(place), None, Expr::Derivative { variable, .. }) = (&mut from, &to, term)
            && place.of.is_none()
            && !square
            && is_a_place(&place.at, variable)
        {
            place.of = Some(variable.clone());
        }
        let (upper, lower) = match (from, to) {
            (Some(from), Some(to)) => (to, Some(from)),
            (Some(place), None) if place.of.is_some() => (place, None),
            _ => {
                return refuse_with(
                    self.since(sign),
                    "of the limits after this one is missing",
                    "write `\\left[ f \\right]_{x=a}^{x=b}`, or `\\left. f \\right|_{x=a}` for a value",
                );
            }
        };
        let told = upper
            .of
            .as_ref()
            .or(lower.as_ref().and_then(|own| own.of.as_ref()));
        let mut near = self.integrals.iter().rev().take(NEAR);
        let integral = near.find(|(_, own)| {
            Some(&own.from.at) == lower.as_ref().map(|own| &own.at) && own.to.at == upper.at
        });
        let variable = told.or(integral.map(|(variable, _)| variable)).cloned();
        let Some(variable) = variable else {
            return refuse_with(
                self.since(start),
                "what runs between these limits is not told",
                "write `\\left[ f \\right]_{x=a}^{x=b}`",
            );
        };
        let is_other = |own: &Limit| own.of.as_ref().is_some_and(|own| *own != variable);
        let named = term.free_symbols();
        let runs = named.contains(&variable);
        // What a bracket is drawn around runs with it; what is evaluated at a bar may depend on it unseen.
        let hides = told.is_some() && !square;
        if is_other(&upper) || lower.as_ref().is_some_and(is_other) || !runs && !hides {
            return refuse(
                self.since(start),
                format!("nothing in this bracket runs with `{variable}`"),
            );
        }
        // What may depend on the variable without its being written there is known by its limit alone.
        let moves = |part: &Expr| {
            matches!(
                part,
                Expr::Derivative { .. }
                    | Expr::Partial { .. }
                    | Expr::Integral { .. }
                    | Expr::Apply(..)
            )
        };
        let hidden = named.iter().any(|own| *own != variable) || term.any(&moves);
        let at = |limit: LimitPoint| match limit {
            LimitPoint::Finite(value) if !hidden => term.substitute(&variable, &value),
            point => Expr::Limit {
                body: term.clone().into(),
                variable: variable.clone(),
                point,
            },
        };
        let upper = at(upper.at);
        let expr = match lower {
            None => upper,
            Some(lower) => Expr::Sum([upper, Expr::Negate(at(lower.at).into())].into()),
        };
        let factor = Factor {
            expr,
            shape: Shape::Tight,
            span: self.since(start),
            braces: false,
        };
        Ok((factor, variable))
    }
}

/// Whether what stands below a bar behind a slope names a place: a number, a term, `x_0`, `x^*`, or a letter of lengths. `\frac{dU}{dT} |_V` holds
/// something fixed.
pub(super) fn is_a_place(at: &LimitPoint, variable: &Symbol) -> bool {
    let LimitPoint::Finite(at) = at else {
        return false;
    };
    match &**at {
        Expr::Symbol(own) => {
            let stem = split_subscript(own.name()).map(|(stem, _)| stem);
            let starred = own.name().strip_suffix("^*");
            LENGTHS.contains(&own.name()) || [stem, starred].contains(&Some(variable.name()))
        }
        _ => true,
    }
}
