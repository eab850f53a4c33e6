//! What partial derivatives hold fixed, where nobody says so: all else of the formula that the page gives for what is differentiated.
//!
//! `\frac{\partial E}{\partial v}` after `E = \frac12 m v^2 + V` holds `m` and `V` fixed. After `L = T - V`, `T = \frac12 m v^2` it is taken of what
//! `L` comes to, for `T` depends on `v`. Where a formula has the variable in it and something besides that depends on it, too, or the
//! page has other formulas, in other symbols, it may be meant in several ways: then nothing that is said with it fails. What stands under the derivative itself,
//! `\frac{\partial}{\partial v}\left[\frac12 m v^2\right] = m v`, holds its other symbols fixed where the equation says what that comes to, in
//! these symbols; in `\frac{\partial}{\partial r}\left[r^2 u\right] = 0` the unknown `u` may depend on `r`.
//!
//! Before that `y(x, t)` and `y` are written in one way ([`alike`]), and after it what has a dot is tied to what it is the slope of ([`dots`]).

mod alike;
mod dots;
mod said;
mod written;

use crate::algebra::{Expr, Relation, Symbol};
use crate::notation::{Clause, Statement};

use super::Equation;
use super::equation::each_side;
use super::page::Page;
use alike::write_alike;
use dots::{tie_accelerations, tie_dots};
use said::Said;

/// Says of each partial derivative on a page what it holds fixed, as far as that can be told.
pub(super) fn tell_what_is_held(page: &mut Page, equations: &mut [Equation]) {
    // Most pages have none.
    let speaks = |own: &Equation| {
        let text = page.document.text(own.body);
        text.contains("partial") || text.contains("pdv")
    };
    let mut supposed = page.locals.iter().flat_map(|local| &local.formulas);
    let mut supposes =
        || supposed.any(|own| own.terms().into_iter().any(|term| term.any(&is_partial)));
    if !equations.iter().any(speaks) && !supposes() {
        let accelerates = |own: &Equation| page.document.text(own.body).contains("ddot");
        if equations.iter().any(accelerates) {
            tie_accelerations(page, equations);
        }
        return;
    }
    write_alike(page, equations);
    let statements = || equations.iter().flat_map(Equation::statements);
    let mut said = Said::default();
    let chains = statements().filter(|own| own.under.is_empty());
    for (chain, clause) in chains.flat_map(|own| &own.clauses).enumerate() {
        said.learn(&equal_sides(clause), chain);
    }
    let told = page.locals.iter().flat_map(|local| &local.formulas);
    for (formula, chain) in told.zip(usize::MAX / 2..) {
        if let Some((left, right)) = formula.as_equation() {
            said.learn(&[left, right], chain);
        }
    }
    said.look_up();
    let constant = |symbol: &Symbol| match page.domains.get(symbol) {
        Some(domain) => domain.constant,
        None => symbol.name() == "\\pi",
    };
    for equation in equations.iter_mut() {
        for statement in equation.statements.iter_mut().flatten() {
            let all: Vec<Expr> = sides_of(statement).cloned().collect();
            each_side(statement, &mut |side, _| {
                let own = side.clone();
                let others: Vec<&Expr> = all.iter().filter(|other| **other != own).collect();
                *side = said.with_held(&own, &others, &constant);
            });
        }
    }
    for formula in page.locals.iter_mut().flat_map(|local| &mut local.formulas) {
        if formula
            .terms()
            .into_iter()
            .any(|term| term.any(&is_partial))
        {
            let all: Vec<Expr> = formula.terms().into_iter().cloned().collect();
            let told = formula.map_terms(|own| {
                let others: Vec<&Expr> = all.iter().filter(|other| *other != own).collect();
                said.with_held(own, &others, &constant)
            });
            *formula = told.into();
        }
    }
    (page.dependent, page.unclear_slopes) = (said.dependent, said.unclear);
    page.presumed_slopes = said.presumed;
    tie_dots(page, equations);
}

impl Said {
    /// A term with what its partial derivatives hold fixed; `others` are what it is said to be equal to.
    fn with_held(
        &mut self,
        term: &Expr,
        others: &[&Expr],
        constant: &impl Fn(&Symbol) -> bool,
    ) -> Expr {
        let (variables, inner) = term.without_partials();
        let mut body = inner.map_children(|child| self.with_held(child, others, constant));
        if variables.is_empty() {
            return self.with_parameters(body, constant);
        }
        let mut presumed = false;
        let is_name = name_of(&body).is_some();
        let name = name_of(&body).or_else(|| function_of(&body)).cloned();
        let given = name.and_then(|name| Some((self.formula(&name, &variables, others)?, name)));
        let together = match given {
            Some(((of, together), name)) => {
                body = match is_name {
                    true => of,
                    false => body.replace(&Expr::Symbol(name), &of),
                };
                Some(together)
            }
            None if is_name => None,
            None => {
                let together = self.evaluated(&body, &variables, others);
                presumed = together.is_some();
                together
            }
        };
        let held_with = |variable: &Symbol| {
            let held = together.as_ref()?.iter();
            let held = held.filter(|own| *own != variable && !constant(own));
            let held: Box<[Symbol]> = held.cloned().collect();
            (!held.is_empty()).then_some(held)
        };
        let derived = |body: Expr, variable: Symbol| Expr::Partial {
            body: body.into(),
            held: held_with(&variable),
            variable,
        };
        let slope = variables.into_iter().rev().fold(body, derived);
        if presumed {
            self.presumed.insert(slope.clone());
        }
        slope
    }

    /// A partial derivative of which it is told what is held fixed, with what else is.
    fn with_parameters(&mut self, term: Expr, constant: &impl Fn(&Symbol) -> bool) -> Expr {
        let Expr::Partial {
            body,
            variable,
            held: Some(told),
        } = term
        else {
            return term;
        };
        let mut inner = &*body;
        while let Expr::Partial { body, .. } = inner {
            inner = body;
        }
        let further = name_of(inner).cloned();
        let further = further.and_then(|name| self.parameters(&name, &variable, &told, constant));
        let mut held = told.to_vec();
        held.extend(further.into_iter().flatten());
        held.sort();
        held.dedup();
        Expr::Partial {
            body,
            variable,
            held: Some(held.into()),
        }
    }
}

fn is_partial(term: &Expr) -> bool {
    matches!(term, Expr::Partial { .. })
}

fn sides_of(statement: &Statement) -> impl Iterator<Item = &Expr> {
    statement.clauses.iter().flat_map(|clause| match clause {
        Clause::Chain { sides, .. } => sides.iter().map(|side| &side.expr).collect(),
        Clause::AllEqual { .. } => Vec::new(),
    })
}

/// The sides of a chain in which nothing but `=` stands.
fn equal_sides(clause: &Clause) -> Vec<&Expr> {
    match clause {
        Clause::Chain { sides, links } if links.iter().all(|l| l.relation == Relation::Equal) => {
            sides.iter().map(|side| &side.expr).collect()
        }
        _ => Vec::new(),
    }
}

/// What a function is taken of, if it is of a name alone: `\ln z`, `v^2`.
fn function_of(term: &Expr) -> Option<&Symbol> {
    let inner = match term {
        Expr::Call(_, inner) | Expr::Negate(inner) => inner,
        Expr::Power(base, exponent) if matches!(**exponent, Expr::Number(_)) => base,
        _ => return None,
    };
    match &**inner {
        Expr::Symbol(name) => Some(name),
        inner => function_of(inner),
    }
}

/// The name of what is given or differentiated.
fn name_of(term: &Expr) -> Option<&Symbol> {
    match term {
        Expr::Symbol(name) | Expr::Apply(name, _) => Some(name),
        _ => None,
    }
}
