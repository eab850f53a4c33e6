//! Partial derivatives: `\frac{\partial f}{\partial x}`, `\frac{\partial^2 f}{\partial x \partial y}`, `\frac{\partial}{\partial x} f`,
//! `\partial_x f`, and what is held fixed, `\left( \frac{\partial U}{\partial V} \right)_{T}`.
//!
//! What `\frac{\partial}{\partial x}` applies to is the product that follows, as for `\frac{d}{dx}`; `\partial_x` applies to one factor, for
//! of two it is not clear whether the second is differentiated too.

use super::{Factor, Kind, Parser, Read, Shape, refuse, refuse_with};
use crate::algebra::{Expr, Symbol};

/// The highest derivative that is read.
const ORDER: usize = 9;

/// Letters that are indices below a `\partial` rather than variables.
const INDICES: [&str; 18] = [
    "i", "j", "k", "l", "m", "n", "\\alpha", "\\beta", "\\gamma", "\\delta", "\\kappa", "\\lambda",
    "\\mu", "\\nu", "\\rho", "\\sigma", "a", "b",
];

impl Parser<'_> {
    pub(super) fn is_partial(&self, at: usize) -> bool {
        self.kind(at) == Kind::Command("partial")
    }

    /// A `\frac` that is a partial derivative; nothing is taken if it is not one.
    pub(super) fn partial_fraction(&mut self) -> Read<Option<(Expr, Shape)>> {
        let start = self.at;
        if self.kind(start + 1) != Kind::Open || !self.is_partial(start + 2) {
            return Ok(None);
        }
        let under = self.after_group(start + 1);
        let Some(under) =
            under.filter(|&at| self.kind(at) == Kind::Open && self.is_partial(at + 1))
        else {
            return Ok(None);
        };
        self.at = under + 1;
        let mut variables = Vec::new();
        // `\frac{\partial f}{\partial \ln x}` is `x` times the slope by `x`.
        let mut logarithmic = false;
        while self.is_partial(self.at) {
            self.advance();
            logarithmic |= self.accept(Kind::Command("ln"));
            if !self.starts_name(self.at) {
                return self.no_term();
            }
            let (variable, times) = self.partial_variable()?;
            variables.extend(std::iter::repeat_n(variable, times.min(ORDER + 1)));
        }
        let open = self.span();
        self.close(open)?;
        let end = self.at;
        self.at = start + 3;
        let order = match self.peek() {
            Kind::Char('^') => match self.superscript()?.power {
                Some(Expr::Number(n)) => n.to_string().parse().unwrap_or(0),
                _ => 0,
            },
            _ => 1usize,
        };
        if order != variables.len() || order > ORDER || logarithmic && order > 1 {
            self.at = end;
            let message =
                "the orders above and below in this derivative do not agree, or are too high";
            let help = "write `\\frac{\\partial^2 f}{\\partial x^2}`";
            return refuse_with(self.since(start), message, help);
        }
        let (body, shape) = self.differentiated_above(open, end)?;
        let factor = variables.first().filter(|_| logarithmic).cloned();
        let slope = by_all(body, variables);
        let slope = match factor {
            Some(variable) => Expr::Product([Expr::Symbol(variable), slope].into()),
            None => slope,
        };
        Ok(Some((slope, shape)))
    }

    /// `\partial_x f`, `\partial_t^2 f`.
    pub(super) fn partial_operator(&mut self) -> Read<Factor> {
        let start = self.at;
        self.advance();
        if self.peek() != Kind::Char('_') {
            return refuse_with(
                self.since(start),
                "`\\partial` is read only in derivatives",
                "write `\\frac{\\partial f}{\\partial x}`, or `\\partial_x f`",
            );
        }
        self.advance();
        let variable = match self.argument("\\partial_")? {
            Expr::Symbol(variable) if !INDICES.contains(&variable.name()) => variable,
            _ => {
                return refuse_with(
                    self.since(start),
                    "what is differentiated by here is an index, or not clear",
                    "write `\\frac{\\partial f}{\\partial x}`",
                );
            }
        };
        let order = match self.peek() {
            Kind::Char('^') => match self.superscript()?.power {
                Some(Expr::Number(n)) => n.to_string().parse().unwrap_or(0),
                _ => 0,
            },
            _ => 1usize,
        };
        if !(1..=ORDER).contains(&order) {
            return refuse(self.since(start), "this is no order of a derivative");
        }
        let body = self.nested(Self::factor)?;
        if self.pending.is_some() || self.starts_factor() && !is_partial(&body.expr) {
            let help = "put what is differentiated, or the derivative, in parentheses";
            let message = "whether this is differentiated too is not clear";
            return refuse_with(self.span(), message, help);
        }
        Ok(Factor {
            expr: by_all(body.expr, vec![variable; order]),
            shape: Shape::Loose,
            span: self.since(start),
            braces: false,
        })
    }

    /// What is held fixed, said below the parentheses around a partial derivative: `\left( \frac{\partial U}{\partial V} \right)_{T, N}`.
    pub(super) fn held_fixed(&mut self, derivative: Expr) -> Read<Expr> {
        self.advance();
        let mut held = Vec::new();
        let braces = self.accept(Kind::Open);
        loop {
            let start = self.at;
            if !self.starts_name(start) {
                return self.no_term();
            }
            let name = match braces {
                true => self.name()?,
                false => self.single_letter()?,
            };
            match self.symbol(&name, self.since(start))? {
                Expr::Symbol(symbol) if name.power.is_none() => held.push(symbol),
                _ => return refuse(self.since(start), "this cannot be held fixed"),
            }
            if !braces || !self.accept(Kind::Char(',')) {
                break;
            }
        }
        if braces {
            self.close(self.span())?;
        }
        Ok(with_held(derivative, &held))
    }
}

fn is_partial(term: &Expr) -> bool {
    matches!(term, Expr::Partial { .. })
}

/// The derivative by the last variable first, as it is written.
fn by_all(body: Expr, variables: Vec<Symbol>) -> Expr {
    let derived = |body: Expr, variable| Expr::Partial {
        body: body.into(),
        variable,
        held: None,
    };
    variables.into_iter().rev().fold(body, derived)
}

/// A partial derivative, or one of one, of which it is told what is held fixed: also the other variables by which is differentiated.
fn with_held(derivative: Expr, told: &[Symbol]) -> Expr {
    let (variables, inner) = derivative.without_partials();
    let body = inner.clone();
    let derived = |body: Expr, variable: Symbol| {
        let mut held: Vec<Symbol> = told.to_vec();
        held.extend(variables.iter().cloned());
        held.retain(|own| *own != variable);
        held.sort();
        held.dedup();
        Expr::Partial {
            body: body.into(),
            variable,
            held: Some(held.into()),
        }
    };
    variables.iter().rev().cloned().fold(body, derived)
}
