//! Functions: the known ones, `\sin x`, and unknown ones applied to bare symbols, `P(t)`.

use super::{Factor, Kind, Parser, Read, Shape, refuse, refuse_with};
use crate::algebra::{Expr, Function};
use crate::notation::commands;

impl Parser<'_> {
    /// `P(t)` or `v_0(1 - \mu)`: a function if the parentheses hold nothing but bare symbols.
    pub(super) fn application(&mut self, start: usize, function: Factor) -> Read<Factor> {
        let open = self.at;
        let open_span = self.span();
        let Some(delimiter) = self.delimiter() else {
            return self.no_term();
        };
        let mut arguments = Vec::new();
        let mut bare = true;
        self.inside(false, |parser| {
            loop {
                let argument = parser.sum()?;
                let symbol = matches!(argument.expr, Expr::Symbol(_) | Expr::Element { .. });
                bare &= symbol && argument.shape == Shape::Tight;
                arguments.push(argument.expr);
                if parser.peek() != Kind::Char(',') {
                    return Ok(());
                }
                if !bare {
                    return parser.unexpected();
                }
                parser.advance();
            }
        })?;
        self.end_group(&delimiter, open_span)?;
        match (bare, function.expr) {
            (true, Expr::Symbol(symbol)) => {
                let raised = self.peek() == Kind::Char('^');
                if raised
                    && matches!(arguments.as_slice(), [Expr::Symbol(only)] if only.name().contains(['^', ' ']))
                {
                    let help = "for a product write `\\cdot` before the parenthesis";
                    return refuse_with(
                        self.since(open),
                        "this may be a factor or an argument",
                        help,
                    );
                }
                self.scripts(start, Expr::Apply(symbol, arguments), Shape::Tight, false)
            }
            (true, _) => refuse_with(
                self.since(start),
                "this may be a product or a function",
                "for a product write `\\cdot` before the parenthesis",
            ),
            (false, expr) => {
                let Some(content) = arguments.pop().filter(|_| arguments.is_empty()) else {
                    return refuse(
                        self.since(open),
                        "the arguments of an unknown function must be bare symbols",
                    );
                };
                self.pending = Some(self.scripts(open, content, Shape::Tight, false)?);
                Ok(Factor { expr, ..function })
            }
        }
    }

    /// `\sin(x)`, or `\sin 2\pi x`: without parentheses the argument is the run of plain factors, side by side.
    pub(super) fn call(&mut self, function: Function) -> Read<Expr> {
        let start = self.at;
        self.advance();
        let mut power = None;
        if self.peek() == Kind::Char('^') {
            let script = self.superscript()?;
            power = match script.power {
                Some(Expr::Number(n)) if n.is_integer() => Some(Expr::Number(n)),
                _ => {
                    let help = "put the whole function value in parentheses and raise that";
                    return refuse_with(
                        self.since(start),
                        "this power on a function is ambiguous",
                        help,
                    );
                }
            };
        }
        if self.peek() == Kind::Char('_') {
            return refuse_with(
                self.span(),
                "a logarithm with a base is not read",
                "write `\\frac{\\ln x}{\\ln b}`",
            );
        }
        let argument = match self.delimiter() {
            Some(delimiter) => {
                let group = self.group(delimiter)?;
                if self.peek() == Kind::Char('^') {
                    let help = "put the whole function value, or its argument, in parentheses";
                    return refuse_with(
                        self.span(),
                        "what this power applies to is not clear",
                        help,
                    );
                }
                group
            }
            None => self.plain_argument()?,
        };
        let call = Expr::Call(function, Box::new(argument));
        Ok(match power {
            Some(power) => Expr::Power(Box::new(call), Box::new(power)),
            None => call,
        })
    }

    pub(super) fn plain_argument(&mut self) -> Read<Expr> {
        let help = "put the argument in parentheses";
        let mut factors = Vec::new();
        let mut last = None;
        while self.starts_factor() && !self.at_delimiter() && self.is_plain() {
            let factor = self.factor()?;
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
            last = Some(factor.shape);
            factors.push(factor.expr);
        }
        let next_is_function = matches!(self.kind(self.at + 1), Kind::Command(name) if commands::function(name).is_some());
        let ambiguous = match self.peek() {
            Kind::Char('/') => true,
            Kind::Command("cdot" | "times") | Kind::Char('*') => !next_is_function,
            _ => self.at_delimiter(),
        };
        if ambiguous && !factors.is_empty() {
            return refuse_with(
                self.span(),
                "where the argument of this function ends is not clear",
                help,
            );
        }
        match (factors.len(), factors.pop()) {
            (1, Some(single)) => Ok(single),
            (_, Some(single)) => {
                factors.push(single);
                Ok(Expr::Product(factors))
            }
            (_, None) => match self.peek() {
                Kind::Char('+' | '-') => refuse_with(
                    self.span(),
                    "the argument of a function is missing before this",
                    help,
                ),
                _ => self.no_term(),
            },
        }
    }

    pub(super) fn is_plain(&self) -> bool {
        match self.peek() {
            Kind::Number(_) | Kind::Open => true,
            Kind::Command("frac" | "tfrac" | "dfrac" | "sfrac" | "sqrt") => true,
            _ => self.starts_name(self.at),
        }
    }
}
