//! Functions: the known ones, `\sin x`, and unknown ones applied to bare symbols, `P(t)`.

use super::{Before, BeforeKind, Choice, Factor, Kind, Parser, Read, Shape, refuse, refuse_with};
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
                let single = arguments.len() == 1;
                if single {
                    self.choices.push((Choice::Product, self.since(start)));
                }
                if single && self.choice == Some(Choice::Product) {
                    return self.before_factor(start, open, Expr::Symbol(symbol), arguments);
                }
                self.before.push(Before {
                    name: symbol.clone(),
                    span: self.since(start),
                    kind: BeforeKind::Function,
                });
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
                if let (Expr::Symbol(name), [Expr::Number(_)]) = (&expr, arguments.as_slice()) {
                    let message = format!(
                        "this may be the value of a function `{name}` at a number, or a product"
                    );
                    let help = "for a product write `\\cdot` before the parenthesis; give the value of a function at a number a name, such as `x_0`";
                    return refuse_with(self.since(start), message, help);
                }
                if let Expr::Symbol(name) = &expr {
                    self.before.push(Before {
                        name: name.clone(),
                        span: self.since(start),
                        kind: BeforeKind::Factor,
                    });
                }
                self.before_factor(start, open, expr, arguments)
            }
        }
    }

    /// A name, read as a factor, and the group after it.
    fn before_factor(
        &mut self,
        start: usize,
        open: usize,
        name: Expr,
        mut group: Vec<Expr>,
    ) -> Read<Factor> {
        let Some(content) = group.pop().filter(|_| group.is_empty()) else {
            return refuse(
                self.since(open),
                "the arguments of an unknown function must be bare symbols",
            );
        };
        let span = self
            .tokens
            .get(start..open)
            .and_then(|name| Some(name.first()?.span.to(name.last()?.span)))
            .unwrap_or(self.body);
        self.pending = Some(self.scripts(open, content, Shape::Tight, false)?);
        Ok(Factor {
            expr: name,
            shape: Shape::Tight,
            span,
            braces: false,
        })
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
            None => {
                let argument = self.plain_argument()?;
                if let Expr::Power(base, exponent) = &argument
                    && matches!(&**exponent, Expr::Number(n) if n.is_integer())
                    && power.is_none()
                {
                    self.choices.push((Choice::OfValue, self.since(start)));
                    if self.choice == Some(Choice::OfValue) {
                        let value = Expr::Call(function, base.clone());
                        return Ok(Expr::Power(Box::new(value), exponent.clone()));
                    }
                }
                argument
            }
        };
        let call = Expr::Call(function, Box::new(argument));
        Ok(match power {
            Some(power) => Expr::Power(Box::new(call), Box::new(power)),
            None => call,
        })
    }

    pub(super) fn plain_argument(&mut self) -> Read<Expr> {
        let help = "put the argument in parentheses";
        let start = self.at;
        let mut factors: Vec<Expr> = Vec::new();
        let mut last = None;
        while self.starts_factor() && !self.at_delimiter() && self.is_plain() {
            // Nobody takes `\sin 2x` for `(\sin 2) x`.
            if !matches!(factors.as_slice(), [] | [Expr::Number(_)]) {
                self.choices
                    .push((Choice::FirstName, self.since(start.saturating_sub(1))));
                if self.choice == Some(Choice::FirstName) {
                    break;
                }
            }
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
