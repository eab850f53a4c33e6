//! Derivatives, integrals and limits.
//!
//! `\frac{d …}{dx}` is a derivative if, and only if, its denominator is `d` and one name (and a whole power, the same as
//! above); `d` anywhere else is an ordinary symbol. What `\frac{d}{dx}` applies to is the product that follows; if that
//! starts with a bracket it must end with it, since `\frac{d}{dx}(f) g` says too little. An integrand ends at its `dx`.

use super::between::is_a_place;
use super::term::invisible;
use super::vector::is_vector;
use super::{Kind, Parser, Read, Shape, refuse, refuse_with};
use crate::algebra::{Expr, LimitPoint, Symbol};
use crate::document::Span;
use crate::notation::commands;

/// The highest derivative that is read.
const ORDER: usize = 9;

/// So far the point of a limit is looked through.
const FAR: usize = 40;

impl Parser<'_> {
    pub(super) fn is_d(&self, at: usize) -> bool {
        matches!(
            self.kind(at),
            Kind::Letter('d') | Kind::Upright("d") | Kind::Operator("d") | Kind::Text("d")
        )
    }

    /// Whether `dx` stands here.
    pub(super) fn at_differential(&self) -> bool {
        self.is_d(self.at) && self.starts_name(self.at + 1)
    }

    /// Whether a fraction begins at this place that is a derivative: `\frac{d`, and `{d name` below.
    pub(super) fn at_derivative(&self, start: usize) -> bool {
        let over = start + 1;
        let is_sign = |at: usize| self.is_d(at) || self.is_partial(at);
        if self.kind(over) != Kind::Open || !is_sign(over + 1) {
            return false;
        }
        let is_under =
            |at: usize| self.kind(at) == Kind::Open && is_sign(at + 1) && self.starts_name(at + 2);
        self.after_group(over).is_some_and(is_under)
    }

    /// Whether the differential of the integrand that is being read stood above a stroke.
    pub(super) fn has_differential(&self) -> bool {
        self.integrand && self.differential.is_some()
    }

    /// The variable after `d`.
    pub(super) fn variable(&mut self, power_allowed: bool) -> Read<(Symbol, usize)> {
        self.variable_besides(power_allowed, |name| matches!(name, "d" | "\\text{d}"))
    }

    /// The variable of a partial derivative: also `d`, which is a length there.
    pub(super) fn partial_variable(&mut self) -> Read<(Symbol, usize)> {
        self.variable_besides(true, |_| false)
    }

    fn variable_besides(
        &mut self,
        power_allowed: bool,
        is_sign: impl Fn(&str) -> bool,
    ) -> Read<(Symbol, usize)> {
        let start = self.at;
        let mut name = self.name()?;
        let order = match name.power.take() {
            None => 1,
            Some(Expr::Number(n)) if power_allowed && n.is_integer() => {
                n.to_string().parse().unwrap_or(usize::MAX)
            }
            Some(_) => {
                return refuse(
                    self.since(start),
                    "the variable of a differential has no power",
                );
            }
        };
        match self.symbol(&name, self.since(start))? {
            Expr::Symbol(symbol) if !is_sign(symbol.name()) && !is_vector(&symbol) => {
                Ok((symbol, order))
            }
            _ => refuse(
                self.since(start),
                "this cannot be the variable of a differential",
            ),
        }
    }

    /// Whether the fraction that begins here is `\frac{Du}{Dt}`.
    fn is_material(&self, start: usize) -> bool {
        let is_rate = |at: usize| self.kind(at) == Kind::Letter('D') && self.starts_name(at + 1);
        is_rate(start + 2)
            && self.after_group(start + 1).is_some_and(|under| {
                let is_closed = self.kind(under + 3) == Kind::Close;
                self.kind(under) == Kind::Open && is_rate(under + 1) && is_closed
            })
    }

    /// A `\frac` that is a derivative; nothing is taken if it is not one.
    pub(super) fn derivative(&mut self) -> Read<Option<(Expr, Shape)>> {
        // The shape is looked for before anything is read: `\frac{d`, and `{d name}` or `{d name^n}` below.
        let start = self.at;
        if self.kind(start + 1) != Kind::Open {
            return Ok(None);
        }
        if self.is_material(start) {
            let message = "derivatives along a flow are not read";
            return refuse_with(
                self.since(start),
                message,
                "give the rate a name of its own",
            );
        }
        if !self.is_d(start + 2) {
            return Ok(None);
        }
        let Some(under) = self.after_group(start + 1) else {
            return Ok(None);
        };
        if self.kind(under) != Kind::Open || !self.is_d(under + 1) {
            return Ok(None);
        }
        // `\frac{dS}{d\ln T}` is `T` times the slope by `T`.
        let logarithmic =
            self.kind(under + 2) == Kind::Command("ln") && self.starts_name(under + 3);
        if let Kind::Command("ln" | "log" | "lg" | "exp" | "sin" | "cos" | "tan" | "sqrt") =
            self.kind(under + 2)
            && !logarithmic
        {
            self.at = under + 2;
            let help = "write the derivative with respect to the symbol, as in `\\frac{x}{y} \\frac{dy}{dx}`";
            return refuse_with(
                self.span(),
                "derivatives are read with respect to a symbol, not to a term",
                help,
            );
        }
        let name = under + 2 + usize::from(logarithmic);
        if !self.starts_name(name) {
            return Ok(None);
        }
        let Some(end) = self.after_group(under) else {
            return Ok(None);
        };
        self.at = name;
        // `\frac{dL}{dd}` is the slope by a distance `d`.
        let is_by_d = self.is_d(name) && name + 2 == end;
        let denominator = match is_by_d {
            true => self.variable_besides(false, |_| false),
            false => self.variable(true),
        };
        let ends = self.at + 1 == end;
        if self.is_d(self.at) && self.starts_name(self.at + 1) {
            let message =
                "derivatives with respect to several variables are read with `\\partial` alone";
            return refuse(self.span(), message);
        }
        self.at = start;
        if !ends {
            return Ok(None);
        }
        let (variable, below) = denominator?;
        self.at = start + 3;
        let above = match self.peek() {
            Kind::Char('^') => match self.superscript()?.power {
                Some(Expr::Number(n)) => n.to_string().parse().unwrap_or(0),
                _ => 0,
            },
            Kind::Char('_' | '\'') => return self.unexpected(),
            _ => 1usize,
        };
        if above != below || !(1..=ORDER).contains(&above) || logarithmic && above > 1 {
            self.at = end;
            let message =
                "the orders above and below in this derivative do not agree, or are too high";
            return refuse_with(self.since(start), message, "write `\\frac{d^2 x}{dt^2}`");
        }
        let open = self.span();
        let (body, shape) = self.differentiated_above(open, end)?;
        // `\frac{dT}{dx}(0)`
        let is_place = shape == Shape::Tight
            && self.peek() == Kind::Char('(')
            && (self.starts_name(self.at + 1) || matches!(self.kind(self.at + 1), Kind::Number(_)))
            && self.after_place(self.at + 2) == Kind::Char(')');
        let derive = |body: Expr, _| body.differentiated_by(&variable);
        let slope = (0..above).fold(body, derive);
        let slope = match logarithmic {
            true => Expr::Product([Expr::Symbol(variable.clone()), slope].into()),
            false => slope,
        };
        match is_place {
            true => Ok(Some((self.slope_there(slope, &variable)?, shape))),
            false => Ok(Some((slope, shape))),
        }
    }

    /// A slope at the place in parentheses that follows, a number or what else names one; of what may be a factor it is not clear.
    fn slope_there(&mut self, slope: Expr, variable: &Symbol) -> Read<Expr> {
        let open = self.span();
        self.advance();
        let at = self.inside(false, Self::sum)?.expr;
        self.advance();
        let is_itself = matches!(&at, Expr::Symbol(own) if own == variable);
        let point = LimitPoint::Finite(at.into());
        match is_a_place(&point, variable) {
            true => Ok(Expr::Limit {
                body: slope.into(),
                variable: variable.clone(),
                point,
            }),
            false if is_itself => Ok(slope),
            false => {
                let help = format!(
                    "write `\\left.\\frac{{dy}}{{d{variable}}}\\right|_{{{variable} = 0}}` for the slope there, `\\cdot` for a product"
                );
                refuse_with(
                    open,
                    "whether this is a factor or says where the slope is taken is not clear",
                    help,
                )
            }
        }
    }

    /// The token after the subscript that may begin here.
    fn after_place(&self, at: usize) -> Kind<'_> {
        let after = match (self.kind(at), self.kind(at + 1)) {
            (Kind::Char('_'), Kind::Open) => self.after_group(at + 1).unwrap_or(at),
            (Kind::Char('_'), _) => at + 2,
            _ => at,
        };
        self.kind(after)
    }

    /// What a derivative that is written as a fraction applies to: what else stands above, or what comes after the fraction, which ends
    /// at `end`.
    pub(super) fn differentiated_above(&mut self, open: Span, end: usize) -> Read<(Expr, Shape)> {
        let inner = match self.peek() {
            Kind::Close => None,
            _ => {
                let content = self.inside(false, Self::sum)?;
                if content.shape == Shape::Loose && matches!(content.expr, Expr::Sum(_)) {
                    return invisible(content.span);
                }
                Some(content.expr)
            }
        };
        self.close(open)?;
        self.at = end;
        Ok(match inner {
            Some(body) => (body, Shape::Tight),
            None => (self.differentiated()?, Shape::Loose),
        })
    }

    /// What an operator `\frac{d}{dx}` applies to.
    pub(super) fn differentiated(&mut self) -> Read<Expr> {
        if !self.at_delimiter() {
            return self.operand();
        }
        let body = self.factor()?;
        let goes_on = matches!(
            self.peek(),
            Kind::Command("cdot" | "times") | Kind::Char('*' | '/')
        );
        if goes_on || self.starts_factor() {
            let help =
                "put all that is differentiated into one bracket, or the derivative in parentheses";
            return refuse_with(
                self.span(),
                "whether this is differentiated too is not clear",
                help,
            );
        }
        Ok(body.expr)
    }

    /// The token after the group that opens at `at`. Derivatives are few, and their groups are short.
    pub(super) fn after_group(&self, at: usize) -> Option<usize> {
        const FAR: usize = 400;
        let mut depth = 0usize;
        for next in at..at + FAR {
            match self.kind(next) {
                Kind::Open | Kind::BoxOpen => depth += 1,
                Kind::Close | Kind::BoxClose => depth = depth.checked_sub(1)?,
                Kind::End => return None,
                _ => {}
            }
            if depth == 0 {
                return Some(next + 1);
            }
        }
        None
    }

    /// What stands above the stroke of `\frac{p \, dx}{q}`, where that ends an integrand; nothing is taken otherwise.
    pub(super) fn over_differential(&mut self) -> Read<Option<Expr>> {
        if !self.integrand || self.peek() != Kind::Open {
            return Ok(None);
        }
        let (start, open) = (self.at, self.span());
        let Some(end) = self.after_group(start) else {
            return Ok(None);
        };
        let signs = || (start + 1..end).filter(|&at| self.is_d(at) && self.starts_name(at + 1));
        // An integral above the stroke has a differential of its own.
        let integrals = (start + 1..end).filter(|&at| self.kind(at) == Kind::Command("int"));
        let own = signs().count() > integrals.count();
        let Some(sign) = signs().next_back().filter(|_| own) else {
            return Ok(None);
        };
        self.at = sign + 1;
        let variable = self.variable(false);
        let ends = self.at + 1 == end;
        self.at = start;
        let (true, Ok((variable, _))) = (ends, variable) else {
            return Ok(None);
        };
        self.advance();
        let over = match self.at == sign {
            true => Expr::integer(1),
            false => {
                let read = |parser: &mut Self| {
                    parser.integrand = true;
                    parser.sum()
                };
                let over = self.inside(false, read)?;
                if self.at != sign {
                    return self.unexpected();
                }
                if matches!(over.expr, Expr::Sum(_)) && over.shape == Shape::Loose {
                    return invisible(over.span);
                }
                over.expr
            }
        };
        self.at = end - 1;
        self.close(open)?;
        self.differential = Some(variable);
        Ok(Some(over))
    }

    /// `\int_a^b body \, dx`.
    pub(super) fn integral(&mut self) -> Read<Expr> {
        let start = self.at;
        self.advance();
        let limits = self.limits()?;
        if limits.is_none() && self.at > start + 1 {
            return refuse_with(
                self.since(start),
                "of the limits of this integral one is missing",
                "write `\\int_{a}^{b} f \\, dx`",
            );
        }
        let sign = self.since(start);
        let outside = (self.bar, self.integrand, self.differential.take());
        (self.bar, self.integrand) = (false, true);
        // `\int_0^L dx \, \lambda`: the product that follows.
        let first = self.at_differential();
        let body = match first {
            true => self.after_differential(sign),
            false => self.sum().map(|body| body.expr),
        };
        let above = self.differential.take();
        (self.bar, self.integrand, self.differential) = outside;
        let body = body?;
        let variable = match above {
            Some(variable) => {
                self.integrand_has_ended(&body)?;
                variable
            }
            None => self.differential_here(sign)?,
        };
        if !self.integrand && self.at_differential() {
            return refuse(
                self.span(),
                "this is a second differential: an integral has one",
            );
        }
        let Some(limits) = limits else {
            return Ok(self.primitive(body, variable, sign));
        };
        self.integrals.push((variable.clone(), limits.clone()));
        limits.integral(body, variable, sign)
    }

    /// What is integrated where the differential stands before it.
    fn after_differential(&mut self, sign: Span) -> Read<Expr> {
        let variable = self.differential_here(sign)?;
        let body = match self.starts_factor() && !self.at_differential() {
            true => self.term()?.expr,
            false => Expr::integer(1),
        };
        if self.at_differential() {
            return refuse(
                self.span(),
                "this is a second differential: an integral has one",
            );
        }
        self.differential = Some(variable);
        Ok(body)
    }

    /// The variable of the differential that stands here.
    fn differential_here(&mut self, sign: Span) -> Read<Symbol> {
        if !self.at_differential() {
            if self.peek() == Kind::End || self.peek() == Kind::Close {
                return refuse_with(
                    sign,
                    "this integral has no differential",
                    "end the integrand with `\\, dx`",
                );
            }
            return self.unexpected();
        }
        self.advance();
        Ok(self.variable(false)?.0)
    }

    /// After `\int \frac{dx}{x}` it must be clear that nothing else is integrated.
    fn integrand_has_ended(&mut self, body: &Expr) -> Read<()> {
        let sign = matches!(
            self.peek(),
            Kind::Command("cdot" | "times") | Kind::Char('*' | '/')
        );
        if sign || self.starts_factor() || matches!(body, Expr::Sum(_)) {
            return refuse_with(
                self.span(),
                "whether this is integrated too is not clear",
                "end the integrand with `\\, dx`",
            );
        }
        Ok(())
    }

    /// `\lim_{x \to a} body`; the body is the product that follows.
    pub(super) fn limit(&mut self) -> Read<Expr> {
        let start = self.at;
        self.advance();
        if self.peek() != Kind::Char('_') || self.kind(self.at + 1) != Kind::Open {
            let help = "write `\\lim_{x \\to a}`";
            return refuse_with(
                self.since(start),
                "this limit does not say what goes where",
                help,
            );
        }
        self.advance();
        let open = self.span();
        self.advance();
        if !self.starts_name(self.at) {
            return self.no_term();
        }
        let (variable, _) = self.variable(false)?;
        if !matches!(self.peek(), Kind::Command("to" | "rightarrow")) {
            return refuse(
                self.span(),
                "after the variable of a limit, `\\to` is expected",
            );
        }
        self.advance();
        self.refuse_one_side()?;
        let signed = matches!(self.peek(), Kind::Char('+' | '-'));
        let point = if self.kind(self.at + usize::from(signed)) == Kind::Command("infty") {
            let minus = self.peek() == Kind::Char('-');
            self.at += 1 + usize::from(signed);
            if minus {
                LimitPoint::MinusInfinity
            } else {
                LimitPoint::PlusInfinity
            }
        } else {
            LimitPoint::Finite(self.inside(false, Self::sum)?.expr.into())
        };
        self.close(open)?;
        if matches!(self.peek(), Kind::Command(name) if commands::is_dots(name)) {
            return self.no_term();
        }
        let body = self.operand()?;
        Ok(Expr::Limit {
            body: body.into(),
            variable,
            point,
        })
    }

    /// `\lim_{x \to 0^+}`, `a^{-}`: a mark of the place, not of its name.
    fn refuse_one_side(&mut self) -> Read<()> {
        let from = self.at;
        let is_end = |at: usize| matches!(self.kind(at), Kind::Close | Kind::End);
        let inside = (from..from + FAR).take_while(|&at| !is_end(at));
        let Some(raised) = inside.filter(|&at| self.kind(at) == Kind::Char('^')).last() else {
            return Ok(());
        };
        let sign = raised + 1 + usize::from(self.kind(raised + 1) == Kind::Open);
        if !matches!(self.kind(sign), Kind::Char('+' | '-')) || !is_end(sign + 1) {
            return Ok(());
        }
        self.at = sign + 1 + (sign - raised - 1);
        let message = "limits from one side are not read";
        refuse_with(self.since(from), message, "give its value a name")
    }
}
