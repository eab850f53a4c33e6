//! Arguments of functions without parentheses: `\sin 2\pi x` is of the run of plain factors, side by side.

use super::function::angle_of;
use super::vector::Borne;
use super::{Choice, Doubt, DoubtKind, Factor, Kind, Parser, Read, Shape, refuse, refuse_with};
use crate::algebra::{Expr, product_of};
use crate::notation::commands;

impl Parser<'_> {
    pub(super) fn plain_argument(&mut self) -> Read<Expr> {
        let help = "put the argument in parentheses";
        let start = self.at;
        let mut factors: Vec<Expr> = Vec::new();
        let mut borne = Borne::default();
        let mut last = None;
        if let Kind::Command(inner) = self.peek()
            && commands::is_function(inner)
        {
            return self.function_inside();
        }
        while self.starts_factor() && !self.at_delimiter() && self.is_plain() {
            // Nobody takes `\sin 2x` for `(\sin 2) x`.
            if !matches!(factors.as_slice(), [] | [Expr::Number(_)]) {
                if self.is_rate(start) {
                    break;
                }
                self.choices
                    .push((Choice::FirstName, self.since(start.saturating_sub(1))));
                if self.choice == Some(Choice::FirstName) {
                    break;
                }
                if let [.., Expr::Symbol(name)] = factors.as_slice()
                    && self.tokens.get(self.at).is_some_and(|token| token.spaced)
                {
                    let kind = DoubtKind::Spaced(name.clone());
                    let span = self.since(start.saturating_sub(1));
                    self.doubts.push(Doubt { span, kind });
                }
            }
            let factor = self.factor()?;
            if let Some(in_doubt) = self.angle_before_group(start, &factors, &factor) {
                factors.push(factor.expr);
                if in_doubt && self.choice == Some(Choice::Group) {
                    factors.extend(self.group_of_argument(help)?);
                }
                return Ok(product_of(factors));
            }
            let group = self.pending.take().map(|group| group.span);
            let unclear = factor.braces && (factor.shape == Shape::Loose || self.starts_factor());
            if let Some(span) = group.or(unclear.then_some(factor.span)) {
                return refuse_with(
                    span,
                    "where the argument of this function ends is not clear",
                    help,
                );
            }
            if last == Some(Shape::Number) && factor.shape == Shape::Number {
                return refuse(factor.span, "two numbers stand side by side");
            }
            borne.join(&factor, None)?;
            last = Some(factor.shape);
            factors.push(factor.expr);
        }
        let next_is_function =
            matches!(self.kind(self.at + 1), Kind::Command(name) if commands::is_function(name));
        let ambiguous = match self.peek() {
            // Nobody takes `\sin x/\cos x` for the sine of a quotient.
            Kind::Command("cdot" | "times") | Kind::Char('*' | '/') => !next_is_function,
            _ => self.at_delimiter(),
        };
        if ambiguous && !factors.is_empty() {
            return refuse_with(
                self.span(),
                "where the argument of this function ends is not clear",
                help,
            );
        }
        if !factors.is_empty() {
            return Ok(product_of(factors));
        }
        match self.peek() {
            Kind::Char('+' | '-') => refuse_with(
                self.span(),
                "the argument of a function is missing before this",
                help,
            ),
            _ => self.no_term(),
        }
    }

    /// `\cosh x` in `\ln \cosh x`, with nothing beside it that might go with the outer function or with none.
    fn function_inside(&mut self) -> Read<Expr> {
        let inner = self.factor()?;
        let beside = matches!(
            self.peek(),
            Kind::Char('/' | '*') | Kind::Command("cdot" | "times")
        );
        if beside || self.pending.is_some() || self.starts_factor() || self.at_delimiter() {
            return refuse_with(
                self.span(),
                "where the argument of this function ends is not clear",
                "put the argument in parentheses",
            );
        }
        Ok(inner.expr)
    }

    /// The group that ends the argument of a function, with nothing beside it that might go with it.
    fn group_of_argument(&mut self, help: &str) -> Read<Option<Expr>> {
        let group = self.pending.take().map(|group| group.expr);
        let is_function = matches!(self.peek(), Kind::Command(name) if commands::is_function(name));
        let goes_on = self.starts_factor() && !is_function || self.peek() == Kind::Char('/');
        match goes_on || matches!(group, Some(Expr::Power(..))) {
            true => refuse_with(
                self.span(),
                "where the argument of this function ends is not clear",
                help,
            ),
            false => Ok(group),
        }
    }

    /// Whether a parenthesis after `\sin\theta` multiplies the sine: it does where it holds another sine or cosine of that angle, and may do so
    /// where the page takes those of it elsewhere, as is looked at later. The group is then left pending. Where the page takes sines of products
    /// with that name, `\sin\omega t`, the group is a factor of the argument, `\sin\omega(t - t_0)`, which is a choice. Says whether it is in doubt.
    fn angle_before_group(
        &mut self,
        start: usize,
        before: &[Expr],
        factor: &Factor,
    ) -> Option<bool> {
        let (Some(group), Expr::Symbol(name)) = (&self.pending, &factor.expr) else {
            return None;
        };
        if !self.of_angle || !matches!(before, [] | [Expr::Number(_)]) {
            return None;
        }
        let in_doubt = !group.expr.any(&|part| angle_of(part) == Some(name));
        if in_doubt && self.choice != Some(Choice::Group) {
            let kind = DoubtKind::Angle(name.clone());
            let span = self.since(start.saturating_sub(1));
            self.doubts.push(Doubt { span, kind });
            self.choices.push((Choice::Group, span));
        }
        Some(in_doubt)
    }

    /// Whether a rate or a differential stands here, beside an argument that began at `start`: nobody means it in
    /// `\cos\theta\dot\theta`, `\cos\theta\,d\theta`, `\cos\theta\,\theta'`.
    fn is_rate(&self, start: usize) -> bool {
        let here = self.peek();
        let prime = |at: usize| self.kind(at) == Kind::Char('\'');
        let has = |letter: Kind| {
            let before = start..self.at;
            let mut same = before.filter(|&at| self.is_letter(at) && self.kind(at) == letter);
            same.any(|at| !prime(at + 1))
        };
        match here {
            Kind::Command("dot" | "ddot") => true,
            Kind::Command(name) if commands::is_fraction(name) => self.at_derivative(self.at),
            _ if self.at_differential() => {
                let upright = !matches!(here, Kind::Letter(_));
                let spaced = self.tokens.get(self.at).is_some_and(|token| token.spaced);
                upright || spaced || has(self.kind(self.at + 1))
            }
            letter => prime(self.at + 1) && has(letter),
        }
    }

    pub(super) fn is_plain(&self) -> bool {
        match self.peek() {
            Kind::Number(_) | Kind::Open => true,
            Kind::Command("sqrt") => true,
            Kind::Command(name) if commands::is_fraction(name) || commands::is_binomial(name) => {
                true
            }
            _ => self.starts_name(self.at),
        }
    }
}
