//! Partial derivatives as they are written: several of one another as one of higher order.

use super::latex::{latex, raised_name};
use crate::algebra::{Expr, Symbol};

/// The highest order that is written as one.
const ORDER: usize = 9;

/// A partial derivative of some order.
pub(super) struct Slope<'a> {
    body: &'a Expr,
    /// What is differentiated by, the last one first.
    variables: Vec<&'a Symbol>,
    /// What is told to be held fixed besides the other variables.
    pub held: Vec<&'a Symbol>,
}

impl<'a> Slope<'a> {
    /// A partial derivative, and those that it is taken of, as far as they are taken in the same variables.
    pub fn of(expr: &'a Expr) -> Slope<'a> {
        let mut slope = Slope {
            body: expr,
            variables: Vec::new(),
            held: expr.held().iter().collect(),
        };
        let together = together(expr);
        while let Expr::Partial { body, variable, .. } = slope.body {
            let mut variables = slope.variables.clone();
            variables.push(variable);
            let held = together
                .iter()
                .copied()
                .filter(|own| !variables.contains(own));
            let held: Vec<&Symbol> = held.collect();
            let is_told = slope.body.held().is_empty() == held.is_empty();
            let first = slope.variables.is_empty();
            if variables.len() > ORDER
                || !first && (!is_told || self::together(slope.body) != together)
            {
                break;
            }
            slope = Slope {
                body,
                variables,
                held: if first { slope.held } else { held },
            };
        }
        slope
    }

    /// Whether what is differentiated stands above the stroke.
    pub fn is_of_a_name(&self) -> bool {
        matches!(self.body, Expr::Symbol(_))
    }

    pub fn latex(&self) -> String {
        let sign = "\\partial".to_owned();
        let above = match self.variables.len() {
            1 => sign,
            order => format!("{sign}^{order}"),
        };
        let below = self.variables.chunk_by(|a, b| a == b);
        let below: Vec<String> = below
            .map(|all| match all {
                [one] => format!("\\partial {}", one.name()),
                all => format!("\\partial {}^{}", raised_name(all[0].name()), all.len()),
            })
            .collect();
        let below = below.join(" ");
        let body = latex(self.body);
        let slope = match self.is_of_a_name() {
            true => format!("\\frac{{{above} {body}}}{{{below}}}"),
            false => format!("\\frac{{{above}}}{{{below}}} \\left[ {body} \\right]"),
        };
        let held: Vec<&str> = self.held.iter().map(|own| own.name()).collect();
        match held.is_empty() {
            true => slope,
            false => format!("\\left( {slope} \\right)_{{{}}}", held.join(", ")),
        }
    }
}

/// All variables that a partial derivative is taken in, in order; none where it is not told what is held fixed.
fn together(expr: &Expr) -> Vec<&Symbol> {
    let mut all: Vec<&Symbol> = expr.held().iter().collect();
    if let Expr::Partial { variable, .. } = expr
        && !all.is_empty()
    {
        all.push(variable);
        all.sort();
    }
    all
}
