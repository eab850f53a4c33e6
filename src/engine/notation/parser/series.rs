//! Sums over an index: `\sum_{i=1}^{k} u_i`, and `u_1 + u_2 + \cdots + u_k`. A sum without end is a limit: `\sum_{k=0}^\infty r^k` is
//! `\lim_{k' \to \infty} \sum_{k=0}^{k'} r^k`.
//!
//! The summand of a `\sum` is the product that follows it, up to the next `+`, `-`, relation or closing delimiter.
//! For a sum with dots, the term before the dots and the one after them must be the same but for a subscript; the
//! terms before them must run up from 1 in the same pattern; or they are a [`progression`](super::progression). What does not match is
//! refused, never guessed at.

use std::sync::Arc;

use super::name::with_subscript;
use super::progression::{Progression, progression};
use super::{Kind, Parser, Read, Term, refuse, refuse_with};
use crate::algebra::{BigRational, Expr, LimitPoint, Relation, Symbol, split_subscript};
use crate::document::Span;
use crate::notation::{Clause, Link, Side, SyntaxError, Through};

impl Parser<'_> {
    /// `\sum_{i=1}^{k} body`.
    pub(super) fn series(&mut self) -> Read<Expr> {
        let start = self.at;
        self.advance();
        let (mut lower, mut upper, mut bare) = (None, None, None);
        while lower.is_none() || upper.is_none() {
            match self.peek() {
                Kind::Char('_') if lower.is_none() => {
                    self.advance();
                    let open = self.span();
                    if let Some(index) = self.bare_index() {
                        bare = Some(index);
                        break;
                    }
                    if !self.accept(Kind::Open) {
                        break;
                    }
                    lower = Some(self.index()?);
                    self.close(open)?;
                }
                Kind::Char('^') if upper.is_none() => {
                    self.advance();
                    upper = Some(match self.without_end()? {
                        true => None,
                        false => Some(self.argument("\\sum^")?),
                    });
                }
                Kind::Bad(_) => return self.unexpected(),
                _ => break,
            }
        }
        let is_unsaid = lower.is_none() && upper.is_none();
        let told = self.run.filter(|_| is_unsaid);
        let unsaid = self.since(start);
        let (index, from, to) = match (lower, upper, told) {
            (Some((index, from)), Some(to), _) => (index, from, to),
            (_, _, Some(run)) => {
                let index = bare.unwrap_or_else(|| run.index.clone());
                (index, run.from.clone(), Some(run.to.clone()))
            }
            _ => return ends_unsaid(unsaid),
        };
        self.bound.push(index.name().to_owned());
        let body = self.operand();
        self.bound.pop();
        let body = body?;
        if told.is_some_and(|run| !run.is_of(&body, &index)) {
            return ends_unsaid(unsaid);
        }
        // A name that nothing else in it has.
        let mut far = Symbol::new(format!("{index}'"));
        while body.mentions(&far) || from.mentions(&far) {
            far = Symbol::new(format!("{far}'"));
        }
        let is_endless = to.is_none();
        let sum = Expr::Series {
            index,
            from: from.into(),
            to: to.unwrap_or_else(|| Expr::Symbol(far.clone())).into(),
            body: body.into(),
        };
        Ok(match is_endless {
            true => Expr::Limit {
                body: sum.into(),
                variable: far,
                point: LimitPoint::PlusInfinity,
            },
            false => sum,
        })
    }

    /// Takes `\infty`, `+\infty` or the same in braces, if that comes next.
    fn without_end(&mut self) -> Read<bool> {
        let open = self.span();
        let braces = self.peek() == Kind::Open;
        let first = self.at + usize::from(braces);
        let signed = usize::from(braces && self.kind(first) == Kind::Char('+'));
        if self.kind(first + signed) != Kind::Command("infty") {
            return Ok(false);
        }
        self.at = first + signed + 1;
        if braces {
            self.close(open)?;
        }
        Ok(true)
    }

    /// The index of `\sum_i` and `\sum_{i}`, which say no more.
    fn bare_index(&mut self) -> Option<Symbol> {
        let braces = usize::from(self.peek() == Kind::Open);
        let letter = self.at + braces;
        let ends = braces == 0 || self.kind(letter + 1) == Kind::Close;
        if !ends || !self.is_letter(letter) {
            return None;
        }
        self.at = letter;
        let index = self.single_letter().ok()?.canonical();
        self.at += braces;
        Some(Symbol::new(index))
    }

    /// `i=1`
    fn index(&mut self) -> Read<(Symbol, Expr)> {
        if !self.is_letter(self.at) {
            return refuse(self.span(), "the index of a sum must be a single letter");
        }
        let index = Symbol::new(self.single_letter()?.canonical());
        match self.peek() {
            Kind::Relation(crate::algebra::Relation::Equal, false) => self.advance(),
            _ => {
                return refuse(
                    self.span(),
                    "after the index of a sum, `=` and its first value are expected",
                );
            }
        }
        Ok((index, self.inside(false, Self::sum)?.expr))
    }

    /// Makes one term of `… + u_1 + u_2 + \cdots + u_k`, taking back from `terms` what belongs to it.
    ///
    /// A sign before the dots is that of the terms that they stand for: of a progression, whose terms alternate, or are all negative.
    pub(super) fn dotted(
        &mut self,
        terms: &mut Vec<Term>,
        last: Term,
        (dots, negative): (Span, bool),
    ) -> Read<Term> {
        let Some(first) = terms.last() else {
            return refuse(dots, "nothing stands before these dots");
        };
        let mismatch = |span: Span| -> SyntaxError {
            SyntaxError {
                span,
                message: "the terms around these dots do not follow one pattern".to_owned(),
                help: Some(
                    "write `u_1 + u_2 + \\cdots + u_k`, or `\\sum_{i=1}^{k} u_i`".to_owned(),
                ),
            }
        };
        let hole = hole(&first.expr, &last.expr).filter(|_| !negative);
        let Some((low, high)) = hole else {
            let found = progression(terms, &last).ok_or_else(|| mismatch(dots))?;
            return Ok(written_out(terms, last, &found));
        };
        let first_span = first.span;
        let Some(count) = low.parse::<usize>().ok().filter(|&count| count > 0) else {
            return Err(mismatch(first_span));
        };
        let to = self.end_of_range(&high, last.span)?;
        if let Expr::Number(end) = &to
            && *end <= BigRational::from_integer(count.into())
        {
            return Err(mismatch(last.span));
        }
        let index = fresh_index(&[&last.expr, &to]);
        let body_of =
            |expr: &Expr, number: usize| summand(expr, &last.expr, (number, &high), &index);
        let Some(body) = body_of(&first.expr, count) else {
            return Err(mismatch(first_span));
        };
        let mut span = last.span;
        for number in (1..=count).rev() {
            let Some(term) = terms.pop() else {
                return refuse(dots, "a sum with dots must start at the index 1");
            };
            if term.negative || last.negative || body_of(&term.expr, number).as_ref() != Some(&body)
            {
                return Err(mismatch(term.span));
            }
            span = span.to(term.span);
        }
        let from = Expr::Number(BigRational::from_integer(1.into())).into();
        let expr = Expr::Series {
            index,
            from,
            to: to.into(),
            body: body.into(),
        };
        Ok(Term { expr, span, ..last })
    }

    /// `f_1 = f_2 = \dots = f_n = w`, with terms `f_i` of one pattern: `\sum_{i=1}^{n} (f_i - w)^2 = 0`, which says
    /// the same. `None` where the terms follow no pattern, or count from elsewhere than 1.
    pub(super) fn all_equal_terms(
        &self,
        firsts: &[Side],
        last: &Side,
        value: &Side,
        sign: Span,
    ) -> Read<Option<Clause>> {
        let Some((low, high)) = firsts.first().and_then(|f| hole(&f.expr, &last.expr)) else {
            return Ok(None);
        };
        let to = self.end_of_range(&high, last.span)?;
        let counted = BigRational::from_integer(firsts.len().into());
        if low != "1" || matches!(&to, Expr::Number(n) if *n <= counted) {
            return Ok(None);
        }
        let index = fresh_index(&[&last.expr, &value.expr, &to]);
        let bodies = (1..).zip(firsts);
        let mut bodies =
            bodies.map(|(number, side)| summand(&side.expr, &last.expr, (number, &high), &index));
        let Some(Some(body)) = bodies.next() else {
            return Ok(None);
        };
        if bodies.any(|other| other.as_ref() != Some(&body)) {
            return Ok(None);
        }
        let body = match &value.expr {
            zero if *zero == Expr::integer(0) => body,
            value => Expr::Sum([body, Expr::Negate(value.clone().into())].into()),
        };
        let span = firsts[0].span.to(last.span);
        let sum = Expr::Series {
            index,
            from: Expr::integer(1).into(),
            to: to.into(),
            body: Expr::Power(body.into(), Expr::integer(2).into()).into(),
        };
        let side = |expr, span| Side {
            expr,
            span,
            terms: vec![span],
            rounding: None,
            truncated: false,
        };
        Ok(Some(Clause::Chain {
            sides: vec![side(sum, span), side(Expr::integer(0), value.span)],
            links: vec![Link {
                relation: Relation::Equal,
                questioned: false,
                span: sign,
            }],
        }))
    }

    /// The last index of a sequence, `k` or `5` or `n-1`, as a term.
    pub(super) fn end_of_range(&self, text: &str, span: Span) -> Read<Expr> {
        match crate::notation::read_expr(text, Span::new(0, text.len())) {
            Ok(expr) => Ok(expr),
            Err(_) => refuse(
                span,
                format!("the subscript `{text}` is no number of elements"),
            ),
        }
    }
}

/// What is said of a sum of which it is not known what it runs through.
const ENDS_UNSAID: &str = "this sum does not say where its index starts and ends";

fn ends_unsaid<T>(span: Span) -> Read<T> {
    refuse_with(span, ENDS_UNSAID, "write `\\sum_{i=1}^{k} u_i`")
}

impl SyntaxError {
    /// Whether it is of a sum that does not say what it runs through.
    pub(crate) fn is_of_ends(&self) -> bool {
        self.message == ENDS_UNSAID
    }
}

impl Through {
    /// Whether a sum with this index is one of those: it has elements of the same sequences.
    fn is_of(&self, body: &Expr, index: &Symbol) -> bool {
        let is_same = |part: &Expr| match part {
            Expr::Element {
                sequence,
                index: own,
            } if own == index => *index == self.index || self.sequences.contains(sequence),
            _ => false,
        };
        body.any(&is_same)
    }
}

/// The sum of a progression, its terms taken back from `terms`.
fn written_out(terms: &mut Vec<Term>, last: Term, found: &Progression) -> Term {
    let to = Expr::Symbol(found.letter.clone());
    let index = fresh_index(&[&last.expr]);
    let own = match last.negative {
        true => Expr::Negate(last.expr.clone().into()),
        false => last.expr.clone(),
    };
    let body = own.substitute(&found.letter, &Expr::Symbol(index.clone()));
    let taken = terms.drain(terms.len() - found.count..);
    let span = taken.fold(last.span, |span, term| span.to(term.span));
    let expr = Expr::Series {
        index,
        from: Expr::integer(found.from).into(),
        to: to.into(),
        body: body.into(),
    };
    Term {
        expr,
        span,
        negative: false,
        ..last
    }
}

/// The subscripts in which two symbols of one sequence differ: `1` and `k` of `u_1` and `u_k`.
pub(super) fn hole_of<'a>(a: &'a Symbol, b: &'a Symbol) -> Option<(&'a str, &'a str)> {
    let (stem, low) = split_subscript(a.name())?;
    let (other, high) = split_subscript(b.name())?;
    (stem == other).then_some((low, high))
}

/// The one pair of subscripts in which two terms of the same form differ.
fn hole(first: &Expr, last: &Expr) -> Option<(String, String)> {
    let mut hole = None;
    merge(first, last, &mut |a, b| {
        let (low, high) = hole_of(a, b)?;
        match &hole {
            None => hole = Some((low.to_owned(), high.to_owned())),
            Some((l, h)) if l == low && h == high => {}
            Some(_) => return None,
        }
        Some(Expr::Symbol(a.clone()))
    })?;
    hole
}

/// The term with the subscript `number` where the last one has `high`, at an index instead.
fn summand(expr: &Expr, last: &Expr, at: (usize, &str), index: &Symbol) -> Option<Expr> {
    let (number, high) = (at.0.to_string(), at.1);
    merge(expr, last, &mut |a, b| {
        let (low, upper) = hole_of(a, b)?;
        let (stem, _) = split_subscript(a.name())?;
        (low == number && upper == high).then(|| Expr::Element {
            sequence: Symbol::new(stem),
            index: index.clone(),
        })
    })
}

/// Walks over two terms of the same form at once. Where a symbol differs, `differ` says what stands there.
fn merge(
    a: &Expr,
    b: &Expr,
    differ: &mut dyn FnMut(&Symbol, &Symbol) -> Option<Expr>,
) -> Option<Expr> {
    if let (Expr::Symbol(x), Expr::Symbol(y)) = (a, b) {
        return if x == y {
            Some(a.clone())
        } else {
            differ(x, y)
        };
    }
    let mut both = |a: &Expr, b: &Expr| merge(a, b, differ).map(Arc::new);
    Some(match (a, b) {
        (Expr::Negate(a), Expr::Negate(b)) => Expr::Negate(both(a, b)?),
        (Expr::Quotient(a, c), Expr::Quotient(b, d)) => Expr::Quotient(both(a, b)?, both(c, d)?),
        (Expr::Power(a, c), Expr::Power(b, d)) => Expr::Power(both(a, b)?, both(c, d)?),
        (Expr::Call(f, a), Expr::Call(g, b)) if f == g => Expr::Call(*f, both(a, b)?),
        (Expr::Sum(a), Expr::Sum(b)) => Expr::Sum(merge_all(a, b, differ)?),
        (Expr::Product(a), Expr::Product(b)) => Expr::Product(merge_all(a, b, differ)?),
        (Expr::Apply(f, a), Expr::Apply(g, b)) if f == g => {
            Expr::Apply(f.clone(), merge_all(a, b, differ)?)
        }
        _ => (a == b).then(|| a.clone())?,
    })
}

fn merge_all(
    a: &[Expr],
    b: &[Expr],
    differ: &mut dyn FnMut(&Symbol, &Symbol) -> Option<Expr>,
) -> Option<Arc<[Expr]>> {
    if a.len() != b.len() {
        return None;
    }
    a.iter().zip(b).map(|(a, b)| merge(a, b, differ)).collect()
}

/// An index that means nothing yet in these terms, as a symbol or as a subscript.
fn fresh_index(terms: &[&Expr]) -> Symbol {
    let free = |letter: &&&str| !terms.iter().any(|term| mentions(term, letter));
    let letters = [
        "i", "j", "l", "m", "n", "p", "q", "r", "s", "t", "a", "b", "c", "f", "g", "h", "o",
    ];
    let index = letters.iter().find(free).copied().unwrap_or("\\iota");
    Symbol::new(index)
}

fn mentions(expr: &Expr, letter: &str) -> bool {
    let named = |symbol: &Symbol| {
        symbol
            .name()
            .split(|c: char| !c.is_ascii_alphanumeric())
            .any(|part| part == letter)
            || symbol.name() == with_subscript("", letter)
    };
    match expr {
        Expr::Number(_) => false,
        Expr::Symbol(symbol) => named(symbol),
        Expr::Element { sequence, index } => named(sequence) || named(index),
        Expr::Sum(all) | Expr::Product(all) => all.iter().any(|expr| mentions(expr, letter)),
        Expr::Apply(symbol, all) => named(symbol) || all.iter().any(|expr| mentions(expr, letter)),
        Expr::Negate(a) | Expr::Call(_, a) => mentions(a, letter),
        Expr::Quotient(a, b) | Expr::Power(a, b) => mentions(a, letter) || mentions(b, letter),
        Expr::Series {
            index,
            from,
            to,
            body,
        } => {
            named(index)
                || [from, to, body]
                    .into_iter()
                    .any(|expr| mentions(expr, letter))
        }
        Expr::Derivative { body, variable } => named(variable) || mentions(body, letter),
        Expr::Partial { body, variable, .. } => {
            named(variable) || mentions(body, letter) || expr.held().iter().any(named)
        }
        Expr::Limit {
            body,
            variable,
            point,
        } => {
            named(variable)
                || mentions(body, letter)
                || matches!(point, crate::algebra::LimitPoint::Finite(point) if mentions(point, letter))
        }
        Expr::Integral {
            body,
            variable,
            from,
            to,
        } => {
            named(variable)
                || [from, to, body]
                    .into_iter()
                    .any(|expr| mentions(expr, letter))
        }
    }
}
