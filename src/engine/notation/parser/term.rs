//! Sums and products: the arithmetic between single factors.
//!
//! Precedence, loosest first: `+` and `-`; products (side by side, `\cdot`, `\times`, `*`) and `/`, which bind alike
//! and run from left to right; powers. Names side by side behind a stroke all stand below it, `t/RC` is `t/(RC)`, but
//! not where both sides of the stroke begin with numbers: `1/2m` is `(1/2)m`. A sign at the start of a term holds for
//! all of it: `-ab` is `-(ab)`. Parentheses are kept: `(a + b) + c` is a sum whose first term is a sum.

use num_traits::Signed;

use super::vector::Borne;
use super::{Choice, Factor, Kind, Parser, Read, Shape, Term, refuse, refuse_with};
use crate::algebra::Expr;
use crate::document::Span;
use crate::notation::{commands, measured};

/// How many `/` one term may hold; more than one is hard enough to read.
const SLASHES: usize = 8;
/// An uncertainty has so many digits, or one more where the number before it has as many.
const FIGURES_IN_DOUBT: usize = 2;
/// How many factors beside what a stroke divides by are read or tried below it.
const MOST_BELOW: u8 = 5;

impl Parser<'_> {
    /// A sum of terms; a single term is itself.
    pub(super) fn sum(&mut self) -> Read<Term> {
        self.nested(Self::sum_inner)
    }

    fn sum_inner(&mut self) -> Read<Term> {
        let start = self.at;
        let mut terms: Vec<Term> = Vec::new();
        let mut dots = None;
        loop {
            let from = self.at;
            let negative = match self.peek() {
                Kind::Char('+') => {
                    self.advance();
                    false
                }
                Kind::Char('-') => {
                    self.advance();
                    true
                }
                Kind::Command(name @ ("pm" | "mp")) if self.at_both_signs() => {
                    self.advance();
                    self.lower_sign(name == "mp")
                }
                _ => false,
            };
            if let Kind::Command(name) = self.peek()
                && commands::is_dots(name)
                && !terms.is_empty()
            {
                if dots.is_some() {
                    return refuse(self.span(), "dots are read only once");
                }
                dots = Some((self.span(), negative));
                self.advance();
                let subtracts = negative && self.peek() == Kind::Char('-');
                if self.truncated.is_some() && self.ends_a_sum() {
                    self.truncated = Some(true);
                    break;
                }
                if self.peek() != Kind::Char('+') && !subtracts {
                    return refuse(
                        self.since(self.at - 1),
                        "after the dots, `+` and the last term are missing",
                    );
                }
                continue;
            }
            self.barred = None;
            let term = self.term()?;
            if negative && term.braces {
                return invisible(term.span);
            }
            if let Some(variable) = self.barred.take()
                && terms.iter().any(|before| before.expr.mentions(&variable))
            {
                let message =
                    "whether the whole sum is meant here, or its last term alone, is not clear";
                return refuse_with(term.span, message, "write `\\left[ … \\right]_a^b`");
            }
            let mut term = Term {
                span: self.since(from),
                negative,
                ..term
            };
            if let Some(dots) = dots.take() {
                term = self.dotted(&mut terms, term, dots)?;
            }
            terms.push(term);
            let goes_on = matches!(self.peek(), Kind::Char('+' | '-')) || self.at_both_signs();
            if !goes_on || self.has_differential() {
                break;
            }
        }
        self.gather(start, terms)
    }

    /// Whether nothing more of a sum follows here: a relation, what separates statements, or what closes the group.
    fn ends_a_sum(&self) -> bool {
        let close = usize::from(self.peek() == Kind::Command("right"));
        let next = self.kind(self.at + close);
        let closes = matches!(next, Kind::Char(')' | ']') | Kind::Close | Kind::BoxClose);
        let parts = matches!(next, Kind::Char(',' | ';' | '.') | Kind::Wide | Kind::Row);
        let relates = matches!(next, Kind::Relation(..) | Kind::Connective(_));
        closes || parts || relates || matches!(next, Kind::End | Kind::Finish(_))
    }

    fn gather(&mut self, start: usize, mut terms: Vec<Term>) -> Read<Term> {
        let span = self.since(start);
        let Some(last) = terms.pop() else {
            return self.no_term();
        };
        if terms.is_empty() {
            return Ok(match last.negative {
                true => {
                    let expr = Expr::Negate(last.expr.into());
                    Term {
                        expr,
                        shape: Shape::Loose,
                        span,
                        negative: false,
                        braces: false,
                    }
                }
                false => Term { span, ..last },
            });
        }
        terms.push(last);
        self.summands = terms.iter().map(|term| term.span).collect();
        let sum = terms.into_iter().map(|term| match term.negative {
            true => Expr::Negate(term.expr.into()),
            false => term.expr,
        });
        Ok(Term {
            expr: Expr::Sum(sum.collect()),
            shape: Shape::Loose,
            span,
            negative: false,
            braces: false,
        })
    }

    /// A product; a single factor is itself.
    pub(super) fn term(&mut self) -> Read<Term> {
        self.nested(Self::term_inner)
    }

    /// The product that an operator applies to. Braces do not show how far it reaches: `\sum_k {k + 1}`.
    pub(super) fn operand(&mut self) -> Read<Expr> {
        let term = self.term()?;
        match term.braces && matches!(term.expr, Expr::Sum(_)) {
            true => invisible(term.span),
            false => Ok(term.expr),
        }
    }

    /// Whether `d x`, `d^2 x` or a bare `d` over something begins here.
    fn begins_slope(&self) -> bool {
        let next = self.kind(self.at + 1);
        self.at_differential() || self.is_d(self.at) && matches!(next, Kind::Char('^' | '/'))
    }

    fn term_inner(&mut self) -> Read<Term> {
        let start = self.at;
        // The stroke that was read last, and how many factors stand beside what it divides by.
        let mut stroke: Option<(usize, u8)> = None;
        let mut product = Product::default();
        let mut differential = self.begins_slope();
        product.push(self.factor()?)?;
        product.take_pending(self)?;
        let mut slashes = 0;
        loop {
            match self.peek() {
                _ if self.has_differential() => break,
                Kind::Command("cdot" | "times") | Kind::Char('*') => {
                    if self.peek() == Kind::Command("times") {
                        product.times = Some(self.span());
                    }
                    self.advance();
                    stroke = None;
                    if product.measured
                        && let Some(unit) = self.unit_after_sign(true)
                    {
                        product.push_unit(self.take_unit(unit)?)?;
                        continue;
                    }
                    product.signed = true;
                    differential |= self.at_differential();
                    product.push(self.factor()?)?;
                }
                Kind::Char('/') => {
                    self.advance();
                    slashes += 1;
                    if slashes > SLASHES {
                        let message =
                            format!("one term holds more than {SLASHES} fraction strokes");
                        return refuse_with(self.span(), message, "write `\\frac{…}{…}`");
                    }
                    if differential && self.at_differential() {
                        let help =
                            "write `\\frac{d\\eta}{d\\mu}`, or `d \\cdot \\eta` for a product";
                        self.at += 2;
                        return refuse_with(
                            self.since(start),
                            "this may be a derivative or a quotient of products",
                            help,
                        );
                    }
                    if let Kind::Quantity(number, unit) = self.peek()
                        && !number.is_empty()
                        && !unit.is_empty()
                    {
                        let message = "whether this unit stands below the stroke is not clear";
                        return refuse_with(self.span(), message, "write `\\frac{…}{…}`");
                    }
                    let from = self.at;
                    let after_unit = product.measured;
                    if product.last().is_some_and(|last| self.may_have_unit(last))
                        && let Some(unit) = self.unit_below(after_unit)
                    {
                        let unit = self.take_unit(unit)?;
                        product.divide(unit)?;
                        continue;
                    }
                    let is_coefficient = !product.is_lettered()
                        && matches!(self.peek(), Kind::Number(_))
                        && !self.is_kept_together(start);
                    let (under, below) = match self.choice {
                        Some(Choice::Below(more)) => (self.all_below(more)?, more),
                        _ if is_coefficient => (self.factor()?, 0),
                        _ => self.names_below()?,
                    };
                    let place = self.since(from - 1);
                    let fewer = (0..below).map(|fewer| (Choice::Below(fewer), place));
                    self.choices.extend(fewer);
                    stroke = Some((from - 1, below));
                    if self.pending.is_some() {
                        self.beside(&mut stroke);
                    }
                    product.divide(under)?;
                }
                _ if product.last().is_some_and(|last| self.may_have_unit(last))
                    && let Some(unit) = self.unit_here(product.measured) =>
                {
                    product.push_unit(self.take_unit(unit)?)?;
                }
                _ if self.at_bar() => {
                    let before = std::mem::take(&mut product).finish(self.since(start))?;
                    self.advance();
                    let (between, variable) = self.between(start, &before.expr, false)?;
                    product.push(between)?;
                    stroke = None;
                    self.barred = Some(variable);
                }
                _ if self.starts_factor() => {
                    differential |= self.at_differential();
                    product.grouped = self.at_delimiter() && !self.may_be_uncertainty();
                    product.push(self.factor()?)?;
                    self.beside(&mut stroke);
                    if self.pending.is_some() {
                        self.beside(&mut stroke);
                    }
                }
                _ => break,
            }
            product.take_pending(self)?;
        }
        product.finish(self.since(start))
    }
}

impl Parser<'_> {
    /// Whether parentheses hold a number over a number and names without a space, and nothing else, `(1/2L) \sqrt{T/\mu}`: half of `L` would need
    /// none. After a name they hold an argument.
    fn is_kept_together(&self, start: usize) -> bool {
        let opens = start
            .checked_sub(1)
            .is_some_and(|at| self.kind(at) == Kind::Char('('));
        let before = start.checked_sub(2).map(|at| self.kind(at));
        let begins = matches!(
            before,
            None | Some(Kind::Relation(..) | Kind::Char('+' | '-') | Kind::Wide)
        );
        let after = self.tokens.get(self.at + 1..).unwrap_or_default();
        let names = after
            .iter()
            .take_while(|own| matches!(own.kind, Kind::Letter(_)) && !own.spaced)
            .count();
        let closes = self.kind(self.at + 1 + names) == Kind::Char(')');
        opens && begins && start + 2 == self.at && names > 0 && closes
    }

    /// Whether a number in parentheses here may say how uncertain the decimal before it is, `1.0(2)`: it has a digit or two then, and is whole.
    fn may_be_uncertainty(&self) -> bool {
        let (Some(Kind::Number(before)), Kind::Number(number)) = (
            self.at.checked_sub(1).map(|at| self.kind(at)),
            self.kind(self.at + 1),
        ) else {
            return false;
        };
        let decimals = before.split(['.', '}']).nth(1).map_or(0, str::len);
        let digits = number
            .bytes()
            .all(|c| c.is_ascii_digit())
            .then_some(number.len());
        let is_short = digits
            .is_some_and(|own| own <= FIGURES_IN_DOUBT.max(decimals.min(FIGURES_IN_DOUBT + 1)));
        decimals > 0 && is_short && self.kind(self.at + 2) == Kind::Char(')')
    }

    /// A factor was read beside what a stroke divides by: it may be meant to stand below the stroke too.
    fn beside(&mut self, stroke: &mut Option<(usize, u8)>) {
        if let Some((start, count)) = stroke
            && *count < MOST_BELOW
        {
            *count += 1;
            let place = (Choice::Below(*count), self.since(*start));
            self.choices.push(place);
        }
    }

    /// What a stroke divides by, with the names side by side that follow it, and how many these are.
    fn names_below(&mut self) -> Read<(Factor, u8)> {
        let start = self.at;
        let first = self.factor()?;
        if self.pending.is_some() || !self.is_name_beside() {
            return Ok((first, 0));
        }
        let mut product = Product::default();
        product.push(first)?;
        let mut names = 0;
        while names < MOST_BELOW && self.pending.is_none() && self.is_name_beside() {
            product.push(self.factor()?)?;
            names += 1;
        }
        Ok((product.below(self.since(start))?, names))
    }

    /// Whether a name comes next, and nothing before it keeps it apart.
    fn is_name_beside(&self) -> bool {
        let spaced = (self.tokens.get(self.at)).is_some_and(|token| token.spaced);
        !spaced && self.starts_factor() && self.starts_name(self.at)
    }

    /// What a stroke divides by, and up to so many factors beside it, as another reading of `a/bc` has them.
    fn all_below(&mut self, more: u8) -> Read<Factor> {
        let start = self.at;
        let mut product = Product::default();
        product.push(self.factor()?)?;
        let mut left = more;
        while left > 0 && (self.pending.is_some() || self.starts_factor()) {
            left -= 1;
            match self.pending.take() {
                Some(group) => product.push(group)?,
                None => product.push(self.factor()?)?,
            }
        }
        product.below(self.since(start))
    }
}

/// The factors of a term so far.
#[derive(Default)]
struct Product {
    factors: Vec<Factor>,
    divided: bool,
    /// Whether a sign stands before the next factor, so that two numbers do not run together.
    signed: bool,
    /// Whether parentheses around the next factor part it from a number before it, `3(200)`.
    grouped: bool,
    /// Whether the last factor is a unit after a number, so that another may go on with it.
    measured: bool,
    /// The `\times` before the next factor.
    times: Option<Span>,
    borne: Borne,
}

impl Product {
    /// Whether a letter stands in it.
    fn is_lettered(&self) -> bool {
        let is_letter = |part: &Expr| matches!(part, Expr::Symbol(_));
        self.factors
            .iter()
            .any(|factor| factor.expr.any(&is_letter))
    }

    fn take_pending(&mut self, parser: &mut Parser) -> Read<()> {
        match parser.pending.take() {
            Some(group) => self.push(group),
            None => Ok(()),
        }
    }

    fn last(&self) -> Option<&Expr> {
        self.factors.last().map(|last| &last.expr)
    }

    /// A unit after a number. One that is itself a number, such as `\%` and `\mathrm{rad}`, is no second number beside it.
    fn push_unit(&mut self, unit: Factor) -> Read<()> {
        self.signed = true;
        self.push(unit)?;
        self.measured = true;
        Ok(())
    }

    fn push(&mut self, factor: Factor) -> Read<()> {
        self.measured = false;
        let parted = std::mem::take(&mut self.signed) | std::mem::take(&mut self.grouped);
        self.borne.join(&factor, self.times.take())?;
        if let Some(before) = self.factors.last()
            && !parted
            && before.shape == Shape::Number
        {
            if factor.shape == Shape::Number
                || factor.shape == Shape::Power && starts_with_number(&factor.expr)
            {
                let help =
                    "for a product write `2 \\cdot 3`; a long number is written without spaces";
                return refuse_with(factor.span, "two numbers stand side by side", help);
            }
            if factor.shape == Shape::Tight
                && matches!(&factor.expr, Expr::Number(n) if n.is_integer() && !n.is_negative())
            {
                let help = "for a product write `2 \\cdot 3`; uncertainties in parentheses are not understood";
                return refuse_with(
                    factor.span,
                    "this may be an uncertainty, as in 1.0(2), or a product",
                    help,
                );
            }
            if is_numeric_fraction(&factor.expr) && factor.shape == Shape::Tight {
                let help = "for a product write `2 \\cdot \\frac{1}{2}`";
                return refuse_with(factor.span, "this may be a mixed number or a product", help);
            }
        }
        self.factors.push(factor);
        Ok(())
    }

    fn divide(&mut self, by: Factor) -> Read<()> {
        (self.signed, self.measured) = (false, false);
        self.borne.divide(&by)?;
        self.check_braces(true)?;
        if by.braces && by.shape == Shape::Loose {
            return invisible(by.span);
        }
        let span = self
            .factors
            .first()
            .map_or(by.span, |first| first.span.to(by.span));
        let Some(over) = self.value() else {
            return refuse(by.span, "a numerator is missing");
        };
        let expr = Expr::Quotient(over.into(), by.expr.into());
        self.factors = vec![Factor {
            expr,
            shape: Shape::Loose,
            span,
            braces: false,
        }];
        self.divided = true;
        Ok(())
    }

    /// All of it, as what a stroke divides by.
    fn below(self, span: Span) -> Read<Factor> {
        let term = self.finish(span)?;
        Ok(Factor {
            expr: term.expr,
            shape: Shape::Tight,
            span: term.span,
            braces: false,
        })
    }

    fn value(&mut self) -> Option<Expr> {
        if self.factors.len() > 1 {
            let factors = self.factors.drain(..).map(|factor| factor.expr);
            return Some(Expr::Product(factors.collect()));
        }
        self.factors.pop().map(|factor| factor.expr)
    }

    /// TeX does not print braces, so `{a + b} c` looks like `a + bc`: refused, unless it stands alone.
    fn check_braces(&self, company: bool) -> Read<()> {
        if !company && self.factors.len() < 2 {
            return Ok(());
        }
        match self
            .factors
            .iter()
            .find(|factor| factor.braces && factor.shape == Shape::Loose)
        {
            Some(factor) => invisible(factor.span),
            None => Ok(()),
        }
    }

    fn finish(mut self, span: crate::document::Span) -> Read<Term> {
        self.check_braces(self.divided)?;
        let (shape, braces) = match self.factors.as_slice() {
            [single] => (single.shape, single.braces && single.shape == Shape::Loose),
            _ => (Shape::Loose, false),
        };
        match self.value() {
            Some(expr) => Ok(Term {
                expr,
                shape,
                span,
                negative: false,
                braces,
            }),
            None => refuse(span, "a factor is missing"),
        }
    }
}

pub(super) fn invisible<T>(span: crate::document::Span) -> Read<T> {
    refuse_with(
        span,
        "TeX does not print these braces, so a reader takes this differently",
        "write parentheses",
    )
}

pub(super) fn counted(expr: &Expr) -> bool {
    match expr {
        Expr::Number(_) => true,
        Expr::Symbol(symbol) => measured(symbol).is_some(),
        Expr::Power(base, _) => matches!(&**base, Expr::Number(_)) || counted(base),
        Expr::Product(factors) => factors.iter().all(counted),
        Expr::Quotient(over, under) => counted(over) && counted(under),
        _ => false,
    }
}

fn starts_with_number(expr: &Expr) -> bool {
    matches!(expr, Expr::Power(base, _) if matches!(**base, Expr::Number(_)))
}

fn is_numeric_fraction(expr: &Expr) -> bool {
    matches!(expr, Expr::Quotient(a, b) if matches!((&**a, &**b), (Expr::Number(_), Expr::Number(_))))
}
