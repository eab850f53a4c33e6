//! Single factors: numbers, fractions, roots, groups, functions, and the powers on them.

use super::name::Superscript;
use super::term::invisible;
use super::{DIGITS, Factor, Kind, LastName, Parser, Read, Shape, refuse, refuse_with};
use crate::algebra::{BigInt, BigRational, Expr, Function};
use crate::document::Span;
use crate::notation::commands;

/// An opening delimiter, and how the closing one must look.
struct Delimiter {
    left: bool,
    close: &'static str,
    function: Option<Function>,
}

impl<'s> Parser<'s> {
    /// Whether a factor can start here, in a product without a sign.
    pub(super) fn starts_factor(&self) -> bool {
        if self.integrand && self.at_differential() {
            return false;
        }
        match self.peek() {
            Kind::Number(_) | Kind::Open | Kind::Bad(_) => true,
            Kind::Char('(' | '[') => true,
            Kind::Char('|') => !self.bar,
            Kind::Command(name) => {
                matches!(
                    name,
                    "frac"
                        | "tfrac"
                        | "dfrac"
                        | "sfrac"
                        | "sqrt"
                        | "boxed"
                        | "underbrace"
                        | "overbrace"
                        | "sum"
                        | "int"
                        | "lim"
                        | "left"
                        | "lvert"
                        | "lceil"
                        | "lfloor"
                        | "{"
                        | "lbrace"
                        | "lbrack"
                ) || commands::function(name).is_some()
                    || self.starts_name(self.at)
            }
            _ => self.starts_name(self.at),
        }
    }

    /// A factor with its scripts.
    pub(super) fn factor(&mut self) -> Read<Factor> {
        if self.integrand && self.at_differential() {
            return refuse(self.span(), "a term is missing before this differential");
        }
        let start = self.at;
        let (expr, shape) = match self.peek() {
            Kind::Number(text) => {
                let number = number(text, self.span())?;
                self.advance();
                (number, Shape::Number)
            }
            Kind::Open => return self.braces(),
            Kind::Command("frac" | "tfrac" | "dfrac" | "sfrac") => self.nested(Self::fraction)?,
            Kind::Command("sqrt") => (self.nested(Self::root)?, Shape::Tight),
            Kind::Command("boxed") => {
                self.advance();
                let open = self.open()?;
                let content = self.inside(false, Self::sum)?;
                self.close(open)?;
                (content.expr, Shape::Tight)
            }
            Kind::Command("underbrace" | "overbrace") => return self.underbrace(),
            Kind::Command("sum") => (self.nested(Self::series)?, Shape::Loose),
            Kind::Command("int") => (self.nested(Self::integral)?, Shape::Loose),
            Kind::Command("lim") => (self.nested(Self::limit)?, Shape::Loose),
            Kind::Command(name) if let Some(function) = commands::function(name) => {
                (self.nested(|parser| parser.call(function))?, Shape::Loose)
            }
            _ if self.starts_name(self.at) => return self.named(),
            _ => match self.delimiter() {
                Some(delimiter) => (self.group(delimiter)?, Shape::Tight),
                None => return self.no_term(),
            },
        };
        self.scripts(start, expr, shape, false)
    }

    /// The superscripts after something that is not a name.
    pub(super) fn scripts(
        &mut self,
        start: usize,
        expr: Expr,
        shape: Shape,
        braces: bool,
    ) -> Read<Factor> {
        match self.peek() {
            Kind::Char('^') => {}
            Kind::Char('\'') => {
                return refuse(self.span(), "a prime belongs to the name of a symbol");
            }
            Kind::Char('_') => {
                return refuse(self.span(), "a subscript belongs to the name of a symbol");
            }
            _ => {
                return Ok(Factor {
                    expr,
                    shape,
                    span: self.since(start),
                    braces,
                });
            }
        }
        if matches!(expr, Expr::Derivative { .. } | Expr::Call(..)) && shape == Shape::Loose {
            return refuse_with(
                self.span(),
                "what this power applies to is not clear",
                "put it in parentheses",
            );
        }
        if shape == Shape::Power || braces && shape == Shape::Loose {
            return invisible(self.since(start));
        }
        let sign = self.span();
        let Superscript {
            power,
            primes,
            marks,
        } = self.superscript()?;
        let Some(power) = power.filter(|_| primes == 0 && marks.is_empty()) else {
            return refuse(
                sign.to(self.since(self.at - 1)),
                "a mark belongs to the name of a symbol",
            );
        };
        if matches!(self.peek(), Kind::Char('^' | '_' | '\'')) {
            return refuse_with(
                self.span(),
                "this is a second script on the same thing",
                "use braces or parentheses",
            );
        }
        let expr = Expr::Power(Box::new(expr), Box::new(power));
        Ok(Factor {
            expr,
            shape: Shape::Power,
            span: self.since(start),
            braces: false,
        })
    }

    /// A name, and the argument if it is a function applied to bare symbols, as in `P(t)`.
    pub(super) fn named(&mut self) -> Read<Factor> {
        let start = self.at;
        let name = self.name()?;
        self.finish_name(start, name)
    }

    fn finish_name(&mut self, start: usize, mut name: super::name::Name) -> Read<Factor> {
        if let Some(power) = name.power.take() {
            let base = self.symbol(&name, self.since(start))?;
            let expr = Expr::Power(Box::new(base), Box::new(power));
            return Ok(Factor {
                expr,
                shape: Shape::Power,
                span: self.since(start),
                braces: false,
            });
        }
        let expr = self.symbol(&name, self.since(start))?;
        let factor = Factor {
            expr,
            shape: Shape::Tight,
            span: self.since(start),
            braces: false,
        };
        self.last_name = Some(LastName {
            name,
            start,
            end: self.at,
        });
        let at_parenthesis = self.peek() == Kind::Char('(')
            || self.peek() == Kind::Command("left") && self.kind(self.at + 1) == Kind::Char('(');
        if at_parenthesis {
            self.application(start, factor)
        } else {
            Ok(factor)
        }
    }

    /// `P(t)` or `v_0(1 - \mu)`: a function if the parentheses hold nothing but bare symbols.
    fn application(&mut self, start: usize, function: Factor) -> Read<Factor> {
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

    fn open(&mut self) -> Read<Span> {
        let span = self.span();
        if self.accept(Kind::Open) {
            Ok(span)
        } else {
            refuse(span, "an opening brace is missing before this")
        }
    }

    /// `{…}`, which TeX does not print.
    fn braces(&mut self) -> Read<Factor> {
        let start = self.at;
        let open = self.open()?;
        let content = self.inside(false, Self::sum)?;
        let end = self.at;
        self.close(open)?;
        if let Some(last) = self
            .last_name
            .take_if(|last| last.start == start + 1 && last.end == end)
        {
            let name = self.suffixes(last.name, start)?;
            return self.finish_name(start, name);
        }
        self.scripts(start, content.expr, content.shape, true)
    }

    /// `\underbrace{…}_{words}`: what is braced; the words under it are for people.
    fn underbrace(&mut self) -> Read<Factor> {
        let start = self.at;
        self.advance();
        let open = self.open()?;
        let content = self.inside(false, Self::sum)?;
        self.close(open)?;
        if matches!(self.peek(), Kind::Char('_' | '^')) {
            self.advance();
            let open = self.open()?;
            let mut depth = 1usize;
            while depth > 0 {
                match self.peek() {
                    Kind::Open | Kind::BoxOpen => depth += 1,
                    Kind::Close | Kind::BoxClose => depth -= 1,
                    Kind::End => return self.close(open).and_then(|()| self.unexpected()),
                    Kind::Bad(_) => return self.unexpected(),
                    _ => {}
                }
                self.advance();
            }
        }
        let braces = content.shape == Shape::Loose;
        self.scripts(start, content.expr, content.shape, braces)
    }

    /// The opening delimiter here, if there is one; takes it.
    fn delimiter(&mut self) -> Option<Delimiter> {
        let left = self.peek() == Kind::Command("left");
        let (close, function) = match self.kind(self.at + usize::from(left)) {
            Kind::Char('(') => (")", None),
            Kind::Char('[') | Kind::Command("lbrack") => ("]", None),
            Kind::Command("{" | "lbrace") => ("}", None),
            Kind::Char('|') | Kind::Command("lvert" | "vert") => ("|", Some(Function::Abs)),
            Kind::Command("lceil") => ("⌉", Some(Function::Ceiling)),
            Kind::Command("lfloor") => ("⌋", Some(Function::Floor)),
            _ => return None,
        };
        self.at += 1 + usize::from(left);
        Some(Delimiter {
            left,
            close,
            function,
        })
    }

    pub(super) fn at_delimiter(&self) -> bool {
        match self.peek() {
            Kind::Char('(' | '[') => true,
            Kind::Char('|') => !self.bar,
            Kind::Command(name) => {
                matches!(
                    name,
                    "left" | "{" | "lbrace" | "lbrack" | "lvert" | "lceil" | "lfloor"
                )
            }
            _ => false,
        }
    }

    fn group(&mut self, delimiter: Delimiter) -> Read<Expr> {
        let open = self.since(self.at - 1 - usize::from(delimiter.left));
        let bar = delimiter.close == "|" && !delimiter.left;
        let content = self.inside(bar, Self::sum)?;
        self.end_group(&delimiter, open)?;
        Ok(match delimiter.function {
            Some(function) => Expr::Call(function, Box::new(content.expr)),
            None => content.expr,
        })
    }

    fn end_group(&mut self, delimiter: &Delimiter, open: Span) -> Read<()> {
        let right = self.peek() == Kind::Command("right");
        let found = match self.kind(self.at + usize::from(right)) {
            Kind::Char(')') => ")",
            Kind::Char(']') | Kind::Command("rbrack") => "]",
            Kind::Command("}" | "rbrace") => "}",
            Kind::Char('|') | Kind::Command("rvert" | "vert") => "|",
            Kind::Command("rceil") => "⌉",
            Kind::Command("rfloor") => "⌋",
            Kind::End => return refuse(open, "this is never closed"),
            Kind::Relation(..) => {
                let help = "state a condition as a statement of its own, after a comma";
                return refuse_with(
                    self.span(),
                    "a relation sign cannot stand inside a group",
                    help,
                );
            }
            _ => return self.unexpected(),
        };
        let start = self.at;
        self.at += 1 + usize::from(right);
        if found != delimiter.close || right != delimiter.left {
            let expected = delimiter.close;
            let right = if delimiter.left { "\\right" } else { "" };
            return refuse(
                self.since(start),
                format!("`{right}{expected}` is expected here, to close what was opened"),
            );
        }
        Ok(())
    }

    fn fraction(&mut self) -> Read<(Expr, Shape)> {
        if let Some(derivative) = self.derivative()? {
            return Ok(derivative);
        }
        self.advance();
        let (over, under) = match self.peek() {
            // `\frac12`: TeX takes one digit for each place.
            Kind::Number(text) if text.len() > 1 => {
                let span = self.span();
                let mut digits = text.chars();
                let (Some(over), Some(under), None) = (digits.next(), digits.next(), digits.next())
                else {
                    let message = format!("TeX reads `{text}` here digit by digit");
                    return refuse_with(span, message, "write `\\frac{…}{…}`");
                };
                self.advance();
                (
                    number(&over.to_string(), span)?,
                    number(&under.to_string(), span)?,
                )
            }
            _ => (self.argument("\\frac")?, self.argument("\\frac")?),
        };
        Ok((
            Expr::Quotient(Box::new(over), Box::new(under)),
            Shape::Tight,
        ))
    }

    fn root(&mut self) -> Read<Expr> {
        self.advance();
        let half = || Expr::Number(BigRational::new(1.into(), 2.into()));
        let mut exponent = half();
        if self.peek() == Kind::Char('[') {
            let open = self.span();
            self.advance();
            let start = self.at;
            let index = self.inside(false, Self::sum)?.expr;
            let span = self.since(start);
            if self.peek() != Kind::Char(']') {
                return if self.peek() == Kind::End {
                    refuse(open, "this is never closed")
                } else {
                    self.unexpected()
                };
            }
            self.advance();
            exponent = match index {
                Expr::Number(n) if n.is_integer() && n > BigRational::from_integer(0.into()) => {
                    Expr::Number(n.recip())
                }
                Expr::Number(_) | Expr::Negate(_) => {
                    return refuse(span, "a root is of a positive whole degree");
                }
                index => {
                    let one = Expr::Number(BigRational::from_integer(1.into()));
                    Expr::Quotient(Box::new(one), Box::new(index))
                }
            };
        }
        let base = self.argument("\\sqrt")?;
        Ok(Expr::Power(Box::new(base), Box::new(exponent)))
    }

    /// What a command applies to: a group in braces, or a single sign.
    pub(super) fn argument(&mut self, command: &str) -> Read<Expr> {
        let span = self.span();
        match self.peek() {
            Kind::Open => {
                self.advance();
                let content = self.inside(false, Self::sum)?;
                self.close(span)?;
                Ok(content.expr)
            }
            Kind::Number(text) if text.len() == 1 => {
                self.advance();
                number(text, span)
            }
            Kind::Number(text) => {
                let message = format!("TeX takes only the first digit of `{text}` here");
                refuse_with(span, message, format!("write `{{{text}}}` in braces"))
            }
            Kind::Letter(_) | Kind::Command(_) if self.is_letter(self.at) => {
                let name = self.single_letter()?;
                self.symbol(&name, span)
            }
            Kind::End | Kind::Close => refuse(
                span,
                format!("after this, what `{command}` applies to is missing"),
            ),
            Kind::Bad(_) => self.unexpected(),
            _ => refuse_with(
                span,
                format!("what `{command}` applies to is not clear"),
                "put it in braces",
            ),
        }
    }

    /// `\sin(x)`, or `\sin 2\pi x`: without parentheses the argument is the run of plain factors, side by side.
    fn call(&mut self, function: Function) -> Read<Expr> {
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

    fn plain_argument(&mut self) -> Read<Expr> {
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

    fn is_plain(&self) -> bool {
        match self.peek() {
            Kind::Number(_) | Kind::Open => true,
            Kind::Command("frac" | "tfrac" | "dfrac" | "sfrac" | "sqrt") => true,
            _ => self.starts_name(self.at),
        }
    }
}

/// A numeral as an exact rational.
fn number(text: &str, span: Span) -> Read<Expr> {
    if text.len() > DIGITS {
        return refuse(span, format!("this number has more than {DIGITS} digits"));
    }
    let (whole, decimals) = text.split_once('.').unwrap_or((text, ""));
    let Ok(digits) = format!("{whole}{decimals}").parse::<BigInt>() else {
        return refuse(span, "this is no number");
    };
    let places = u32::try_from(decimals.len()).unwrap_or(u32::MAX);
    Ok(Expr::Number(BigRational::new(
        digits,
        BigInt::from(10).pow(places),
    )))
}
