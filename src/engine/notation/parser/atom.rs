//! Single factors: numbers, fractions, roots, names, and the powers on them.

use super::function::stem;
use super::name::Superscript;
use super::term::{counted, invisible};
use super::vector::refuse_vector;
use super::{DIGITS, Factor, Kind, LastName, Parser, Read, Shape, refuse, refuse_with};
use crate::algebra::{BigInt, BigRational, Expr, Function, Symbol};
use crate::document::Span;
use crate::notation::commands;

impl<'s> Parser<'s> {
    /// Whether a factor can start here, in a product without a sign.
    pub(super) fn starts_factor(&self) -> bool {
        if self.integrand && (self.at_differential() || self.has_differential()) {
            return false;
        }
        match self.peek() {
            Kind::Number(_) | Kind::Quantity(..) | Kind::Open | Kind::Bad(_) => true,
            Kind::Char('(' | '[') => true,
            Kind::Char('|') => !self.bar,
            Kind::Command(name) => commands::begins_term(name) || self.starts_bracketed(self.at),
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
                if self.at_degrees() && !self.at_scale() {
                    return Ok(self.degrees(start, number));
                }
                let number = match self.peek() {
                    Kind::Char('!') => self.factorial(start, number)?,
                    _ => number,
                };
                (number, Shape::Number)
            }
            Kind::Quantity(number, unit) => return self.quantity(number, unit),
            Kind::Open => return self.braces(),
            Kind::Command(name) if commands::is_fraction(name) => self.nested(Self::fraction)?,
            Kind::Command(name) if commands::is_binomial(name) => {
                (self.nested(Self::binomial)?, Shape::Tight)
            }
            Kind::Command("sqrt") => (self.nested(Self::root)?, Shape::Tight),
            Kind::Command("boxed") => {
                self.advance();
                let open = self.open()?;
                let content = self.inside(false, Self::sum)?;
                self.close(open)?;
                (content.expr, Shape::Tight)
            }
            Kind::Command("underline") => return self.underline(),
            Kind::Command("underbrace" | "overbrace") => return self.underbrace(),
            Kind::Command("sum") => (self.nested(Self::series)?, Shape::Loose),
            Kind::Command("int") => (self.nested(Self::integral)?, Shape::Loose),
            Kind::Command("partial") => return self.partial_operator(),
            Kind::Command("lim") => (self.nested(Self::limit)?, Shape::Loose),
            Kind::Command(name) if commands::is_function(name) => {
                (self.nested(|parser| parser.call(name))?, Shape::Loose)
            }
            Kind::Command("left") if self.kind(self.at + 1) == Kind::Char('.') => {
                return self.nested(Self::bounded);
            }
            _ if self.starts_name(self.at) => return self.named(),
            _ => match self.delimiter() {
                Some(delimiter) => {
                    let brackets = delimiter.function.is_none();
                    let square = delimiter.close == "]";
                    let content = self.group(delimiter)?;
                    // `\left|\frac{du}{dr}\right|_{r = R}`
                    if let Expr::Call(Function::Abs, inner) = &content
                        && self.peek() == Kind::Char('_')
                        && self.has_relation(self.at + 1)
                    {
                        let there = self.between(start, inner, false)?.0;
                        let expr = Expr::Call(Function::Abs, there.expr.into());
                        return Ok(Factor { expr, ..there });
                    }
                    if square && self.at_limits() {
                        return Ok(self.between(start, &content, true)?.0);
                    }
                    if brackets {
                        self.last_group = Some((start, self.at));
                    }
                    let content = match content {
                        partial @ Expr::Partial { .. } if self.peek() == Kind::Char('_') => {
                            self.held_fixed(partial)?
                        }
                        content => content,
                    };
                    (content, Shape::Tight)
                }
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
        let derived = matches!(expr, Expr::Derivative { .. } | Expr::Partial { .. });
        if (derived || matches!(expr, Expr::Call(..))) && shape == Shape::Loose {
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
        let script = self.superscript()?;
        // `2^{(n)}` is a power; nobody takes derivatives of a number.
        if !matches!(expr, Expr::Number(_)) {
            script.refuse_order()?;
        }
        let Superscript {
            power,
            primes,
            marks,
            ..
        } = script;
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
        let expr = self.power(start, expr, power)?;
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
        let factor = self.finish_name(start, name)?;
        self.doubt_operator(start, &factor.expr);
        if stem(&factor.expr).is_some_and(Symbol::is_bracketed) {
            return Ok(factor);
        }
        if let Kind::Operator(text) = self.kind(start)
            && (self.pending.is_some() || self.starts_factor())
        {
            let message = format!(
                "whether `{text}` is applied to what follows, or multiplied by it, is not clear"
            );
            let help = "for a product write `\\cdot`; functions other than `\\sin`, `\\cos`, `\\tan`, `\\exp` and `\\ln` take plain symbols in parentheses";
            return refuse_with(self.since(start), message, help);
        }
        let applied = stem(&factor.expr).is_some_and(|name| commands::is_applied(name.name()));
        if applied && (self.pending.is_some() || self.starts_factor()) {
            return self.unclear(start, &factor.expr);
        }
        Ok(factor)
    }

    pub(super) fn finish_name(
        &mut self,
        start: usize,
        mut name: super::name::Name,
    ) -> Read<Factor> {
        if let Some(power) = name.power.take() {
            let base = self.symbol(&name, self.since(start))?;
            let factor = Factor {
                expr: self.power(start, base, power)?,
                shape: Shape::Power,
                span: self.since(start),
                braces: false,
            };
            return match self.at_argument() {
                true => self.application(start, factor),
                false => Ok(factor),
            };
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
        match self.at_argument() {
            true => self.application(start, factor),
            false => Ok(factor),
        }
    }

    /// Whether brackets open here, in which arguments may stand.
    pub(super) fn at_argument(&self) -> bool {
        let left = usize::from(self.peek() == Kind::Command("left"));
        if self.starts_bracketed(self.at)
            || self.kind(self.at + left) == Kind::Char('[')
                && self.bracket_has_limits(self.at + left)
        {
            return false;
        }
        matches!(
            self.kind(self.at + left),
            Kind::Char('(' | '[') | Kind::Command("lbrack" | "{" | "lbrace")
        )
    }

    fn fraction(&mut self) -> Read<(Expr, Shape)> {
        if let Some(derivative) = self.derivative()? {
            return Ok(derivative);
        }
        if let Some(derivative) = self.partial_fraction()? {
            return Ok(derivative);
        }
        let start = self.at;
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
            _ => {
                let over = match self.over_differential()? {
                    Some(over) => over,
                    None => self.argument("\\frac")?,
                };
                let under = match self.unit_denominator().filter(|_| counted(&over)) {
                    Some(unit) => self.take_unit(unit)?.expr,
                    None => self.argument("\\frac")?,
                };
                (over, under)
            }
        };
        refuse_vector(&under, self.since(start), "nothing is divided by a vector")?;
        Ok((Expr::Quotient(over.into(), under.into()), Shape::Tight))
    }

    fn root(&mut self) -> Read<Expr> {
        let sign = self.at;
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
                    Expr::Quotient(one.into(), index.into())
                }
            };
        }
        let base = self.argument("\\sqrt")?;
        self.power(sign, base, exponent)
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
}

/// A numeral as an exact rational.
fn number(text: &str, span: Span) -> Read<Expr> {
    if text.len() > DIGITS {
        return refuse(span, format!("this number has more than {DIGITS} digits"));
    }
    // Most are whole and short.
    if text.bytes().all(|byte| byte.is_ascii_digit())
        && let Ok(whole) = text.parse::<u64>()
    {
        return Ok(Expr::Number(BigRational::from_integer(whole.into())));
    }
    let text = text.replace("\\,", "").replace("{,}", ".");
    let (whole, decimals) = text.split_once('.').unwrap_or((&text, ""));
    let Ok(digits) = format!("{whole}{decimals}").parse::<BigInt>() else {
        return refuse(span, "this is no number");
    };
    let places = u32::try_from(decimals.len()).unwrap_or(u32::MAX);
    Ok(Expr::Number(BigRational::new(
        digits,
        BigInt::from(10).pow(places),
    )))
}
