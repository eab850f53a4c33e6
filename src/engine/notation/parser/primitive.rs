//! Integrals without limits: `\int f \, dx = F + C` says that `F` is differentiated to `f`.
//!
//! Such an integral is no value, but any function with that slope. So it is read only in an equation, as a side or a summand of one, and what
//! the equation says is what it says of slopes: each side is differentiated by what is integrated over, `f = \frac{d}{dx}[F]`. A symbol that is
//! added and stands nowhere else in the equation, `C`, is the constant that may always be added. A side without an
//! integral must be written in that, or be a name for such a side: `W = \int F \, dx` and `m = \int \rho \, dV = \rho V_0` leave their limits to
//! the reader. Integrals over different variables, `\int \frac{dN}{N} = \int r \, dt`, are compared as the differentials that they sum up.

use num_traits::One;

use super::{Parser, Read, refuse_with};
use crate::algebra::{Expr, Relation, Symbol};
use crate::document::Span;
use crate::notation::{Link, Side};
use crate::sorted::{Map, Set};

/// An integral without limits that was read.
pub(super) struct Primitive {
    /// What stands for it in a term until the equation has been read.
    name: Symbol,
    integrand: Expr,
    variable: Symbol,
    /// Its sign.
    span: Span,
}

impl Parser<'_> {
    /// What stands for an integral without limits.
    pub(super) fn primitive(&mut self, integrand: Expr, variable: Symbol, span: Span) -> Expr {
        let name = Symbol::new(format!("\\int {}", self.primitives.len()));
        self.primitives.push(Primitive {
            name: name.clone(),
            integrand,
            variable,
            span,
        });
        Expr::Symbol(name)
    }

    /// Refuses an integral without limits that stands in no equation.
    pub(super) fn no_primitive_is_left(&mut self) -> Read<()> {
        match self.primitives.first() {
            Some(first) => no_equation(first.span),
            None => Ok(()),
        }
    }

    /// The sides of an equation with integrals without limits, differentiated.
    pub(super) fn differentiated_sides(
        &mut self,
        mut sides: Vec<Side>,
        links: &[Link],
    ) -> Read<Vec<Side>> {
        let all = std::mem::take(&mut self.primitives);
        let Some(first) = all.first() else {
            return Ok(sides);
        };
        if links.iter().any(|link| link.relation != Relation::Equal) {
            return no_equation(first.span);
        }
        let variable = &first.variable;
        leave_out_constants(&mut sides, &all);
        if let Some(other) = all.iter().find(|own| own.variable != first.variable) {
            return separated(sides, &all, other.span);
        }
        let integrands = all.iter().map(|own| &own.integrand);
        let terms = || {
            integrands
                .clone()
                .chain(sides.iter().map(|side| &side.expr))
        };
        if has_slope_by_name(terms()) {
            let message = format!("whether something in this depends on `{variable}` is not told");
            let help = "write `\\int_{a}^{b} f \\, dx`";
            return refuse_with(first.span, message, help);
        }
        let has_integral = |term: &Expr| all.iter().any(|own| term.mentions(&own.name));
        let is_read =
            |side: &Side| !has_integral(&side.expr) || slope(&side.expr, &all, variable).is_some();
        if !sides.iter().all(is_read) {
            return no_equation(first.span);
        }
        let is_written = |side: &Side| !has_integral(&side.expr) && side.expr.mentions(variable);
        let is_named = sides.iter().any(is_written);
        let runs = |term: &Expr| match term {
            Expr::Sum(terms) if has_integral(term) => terms.iter().all(|own| {
                let is_constant = matches!(own, Expr::Symbol(_) | Expr::Number(_));
                is_constant || has_integral(own) || own.mentions(variable)
            }),
            Expr::Symbol(_) if is_named => true,
            term => has_integral(term) || term.mentions(variable),
        };
        let slope = |side: Side| {
            if !runs(&side.expr) {
                let message = format!(
                    "between which limits is integrated is not told: this does not run with `{variable}`"
                );
                let help = "write `\\int_{a}^{b} f \\, dx`";
                return refuse_with(side.span, message, help);
            }
            match slope(&side.expr, &all, variable) {
                Some(expr) => Ok(Side {
                    expr,
                    span: side.span,
                    terms: vec![side.span],
                    rounding: None,
                    truncated: false,
                }),
                None => no_equation(first.span),
            }
        };
        sides.into_iter().map(slope).collect()
    }
}

/// The sides of `\int \frac{dN}{N} = \int r \, dt`, which says of differentials what `\frac{dN}{N} = r \, dt` says.
fn separated(sides: Vec<Side>, all: &[Primitive], span: Span) -> Read<Vec<Side>> {
    let of_side = |side: Side| match differential(&side.expr, all) {
        Some(expr) => Ok(Side {
            expr,
            span: side.span,
            terms: vec![side.span],
            rounding: None,
            truncated: false,
        }),
        None => {
            let message = "integrals over different variables cannot be compared without limits";
            refuse_with(span, message, "write `\\int_{a}^{b} f \\, dx`")
        }
    };
    sides.into_iter().map(of_side).collect()
}

fn no_equation<T>(span: Span) -> Read<T> {
    refuse_with(
        span,
        "an integral without limits is read only as a side of an equation, or a summand of one",
        "write `\\int f \\, dx = F + C`, or limits, `\\int_{a}^{b} f \\, dx`",
    )
}

/// Leaves out each symbol that is added to something and stands nowhere else.
fn leave_out_constants(sides: &mut [Side], all: &[Primitive]) {
    let mut seen: Map<Symbol, usize> = Map::new();
    let mut count =
        |term: &Expr| symbols(term, &mut |own| *seen.entry(own.clone()).or_default() += 1);
    for own in all {
        count(&own.integrand);
        count(&Expr::Symbol(own.variable.clone()));
    }
    sides.iter().for_each(|side| count(&side.expr));
    let is_constant = |term: &Expr| match term {
        Expr::Symbol(own) => {
            seen.get(own) == Some(&1) && !all.iter().any(|integral| integral.name == *own)
        }
        _ => false,
    };
    for side in sides {
        if let Expr::Sum(terms) = &side.expr
            && !terms.iter().all(is_constant)
        {
            let terms = terms.iter().filter(|term| !is_constant(term));
            let mut terms: Vec<Expr> = terms.cloned().collect();
            side.expr = match terms.len() {
                1 => terms.remove(0),
                _ => Expr::Sum(terms.into()),
            };
        }
    }
}

/// Calls `see` for each place where a symbol stands.
fn symbols(term: &Expr, see: &mut impl FnMut(&Symbol)) {
    match term {
        Expr::Symbol(own) => see(own),
        term => term.children().for_each(|part| symbols(part, see)),
    }
}

/// Whether names with dots or primes stand beside the same without, which then depends on something: `u'` and `u`.
fn has_slope_by_name<'a>(terms: impl Iterator<Item = &'a Expr>) -> bool {
    let names: Set<Symbol> = terms.flat_map(Expr::free_symbols).collect();
    names.iter().any(|name| {
        let dotted = ["\\dot{", "\\ddot{"].into_iter().find_map(|dots| {
            let inside = name.name().strip_prefix(dots)?;
            inside.strip_suffix('}')
        });
        let plain = dotted.map_or(name.name().replace('\'', ""), str::to_owned);
        plain != name.name() && names.contains(plain.as_str())
    })
}

/// The differential of a side, where it is clear what that is: of a sum of integrals, each with factors that are constant.
fn differential(term: &Expr, all: &[Primitive]) -> Option<Expr> {
    let is_constant = |own: &Expr| {
        let mut integrals = all.iter();
        integrals.all(|integral| !own.mentions(&integral.name) && !own.mentions(&integral.variable))
    };
    let of_integral = |term: &Expr| match term {
        Expr::Symbol(name) => {
            let own = all.iter().find(|own| own.name == *name)?;
            let change = Expr::Symbol(own.variable.clone()).differential();
            Some(match &own.integrand {
                Expr::Number(one) if one.is_one() => change,
                integrand => Expr::Product([integrand.clone(), change].into()),
            })
        }
        _ => None,
    };
    linearly(term, &of_integral, &is_constant)
}

/// The slope of a side, where it is clear what that is.
fn slope(term: &Expr, all: &[Primitive], variable: &Symbol) -> Option<Expr> {
    let of_part = |term: &Expr| match term {
        term if !all.iter().any(|own| term.mentions(&own.name)) => {
            Some(term.clone().differentiated_by(variable))
        }
        Expr::Symbol(name) => {
            let known = all.iter().find(|own| own.name == *name);
            known.map(|own| own.integrand.clone())
        }
        _ => None,
    };
    linearly(term, &of_part, &is_number)
}

/// What is linear and known of some terms, of a sum of such with constant factors.
fn linearly(
    term: &Expr,
    known: &dyn Fn(&Expr) -> Option<Expr>,
    is_constant: &dyn Fn(&Expr) -> bool,
) -> Option<Expr> {
    if let Some(own) = known(term) {
        return Some(own);
    }
    let of_part = |part: &Expr| linearly(part, known, is_constant);
    match term {
        Expr::Negate(part) => Some(Expr::Negate(of_part(part)?.into())),
        Expr::Quotient(part, by) if is_constant(by) => {
            Some(Expr::Quotient(of_part(part)?.into(), by.clone()))
        }
        Expr::Product(factors) => {
            let (last, others) = factors.split_last()?;
            let mut factors = others.to_vec();
            factors.push(of_part(last)?);
            (others.iter().all(is_constant)).then_some(Expr::Product(factors.into()))
        }
        Expr::Sum(terms) => {
            let all = terms.iter().map(of_part);
            Some(Expr::Sum(all.collect::<Option<_>>()?))
        }
        _ => None,
    }
}

fn is_number(term: &Expr) -> bool {
    match term {
        Expr::Number(_) => true,
        Expr::Quotient(above, below) => is_number(above) && is_number(below),
        _ => false,
    }
}
