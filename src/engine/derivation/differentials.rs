//! Differentials, `dU = T\,dS - p\,dV` and `\mathrm{d}(v^2) = 2 v\,\mathrm{d}v`: refused. What they mean is not known here, and products with a
//! number `d` they are not.

use crate::algebra::{Expr, Symbol};
use crate::notation::{BeforeKind, Clause, Statement, SyntaxError};

use super::Equation;
use super::equation::terms;

/// What is written for a differential.
const SIGNS: [&str; 3] = ["d", "\\text{d}", "\\delta"];
/// So many in one display are no accident where the sign may be a number; an upright one is none.
const FEWEST: usize = 2;

/// Refuses the equations of a page with differentials outside of derivatives and integrals.
///
/// A `d` that is a symbol (`is_symbol`: declared, or by itself in the text), or stands anywhere but before what it would be the differential
/// of, is a symbol like others. Where one display shows that it is none, it is none in the others of the page either.
pub(super) fn refuse(equations: &mut [Equation], is_symbol: impl Fn(&Symbol) -> bool) {
    for d in SIGNS.map(Symbol::new) {
        let mut statements = equations.iter().flat_map(Equation::statements);
        let is_written = statements.any(|own| terms(own).any(|term| term.mentions(&d)));
        if !is_written || is_symbol(&d) {
            continue;
        }
        let count = |equation: &Equation| Occurrences::of(equation.statements(), &d);
        let all: Vec<Occurrences> = equations.iter().map(count).collect();
        if all.iter().any(|found| found.alone > 0) || !all.iter().any(|found| found.show(&d)) {
            continue;
        }
        for (equation, found) in equations.iter_mut().zip(&all) {
            if found.differentials > 0
                && let Some(error) = refusal(equation.statements(), &d)
            {
                equation.statements = Err(error);
            }
        }
    }
}

/// Why statements that stand together in the text cannot be read as they are, if they show differentials.
pub(super) fn shown(
    statements: &[Statement],
    is_symbol: impl Fn(&Symbol) -> bool,
) -> Option<SyntaxError> {
    SIGNS.map(Symbol::new).iter().find_map(|d| {
        let found = Occurrences::of(statements, d);
        match !is_symbol(d) && found.alone == 0 && found.show(d) {
            true => refusal(statements, d),
            false => None,
        }
    })
}

fn refusal(statements: &[Statement], d: &Symbol) -> Option<SyntaxError> {
    Some(SyntaxError {
        span: statements.first()?.span,
        message: "differentials are not understood".to_owned(),
        help: Some(format!(
            "write a derivative, `\\frac{{d}}{{dt}}`, or an integral; where `{d}` is a number, say `symbols {d}: …`"
        )),
    })
}

/// Where a symbol stands that may be the sign of differentials.
#[derive(Default)]
struct Occurrences {
    /// Before a name, a power of one or a parenthesis.
    differentials: usize,
    /// Elsewhere.
    alone: usize,
}

impl Occurrences {
    fn of(statements: &[Statement], d: &Symbol) -> Self {
        let mut found = Occurrences::default();
        let clauses = statements.iter().flat_map(|own| &own.clauses);
        let sides = clauses.flat_map(|clause| match clause {
            Clause::Chain { sides, .. } => sides.as_slice(),
            Clause::AllEqual { value, .. } => value.as_slice(),
        });
        for side in sides {
            found.count(&side.expr, d);
        }
        // A parenthesis does not show in the term: `d \cdot (a + b)` is the same product, and is one.
        let before = statements.iter().flat_map(|own| &own.before);
        let groups = before.filter(|own| {
            let is_factor = matches!(own.kind, BeforeKind::Factor | BeforeKind::Product);
            is_factor && own.name == *d
        });
        let groups = groups.count().min(found.alone);
        found.alone -= groups;
        found.differentials += groups;
        found
    }

    /// Whether a display shows by these that the sign is one of differentials.
    fn show(&self, d: &Symbol) -> bool {
        let fewest = if is_upright(d) { 1 } else { FEWEST };
        self.differentials >= fewest
    }

    fn count(&mut self, term: &Expr, d: &Symbol) {
        if let Expr::Symbol(own) = term {
            self.alone += usize::from(own == d);
        }
        let children: Vec<&Expr> = term.children().collect();
        for (at, child) in children.iter().enumerate() {
            let is_factor = matches!(term, Expr::Product(_));
            let follows = is_factor && children.get(at + 1).is_some_and(|next| is_name(next));
            match child {
                child if follows && is_sign(child, d) => self.differentials += 1,
                // `d(u v)/dt` is read as `(d(u v)/d) t`.
                Expr::Quotient(over, under) if follows && is_sign(under, d) => {
                    self.differentials += 1;
                    self.count(over, d);
                }
                child => self.count(child, d),
            }
        }
        // An upright `\mathrm{d}(v)` is no function.
        if let Expr::Apply(own, _) = term
            && own == d
        {
            match is_upright(d) {
                true => self.differentials += 1,
                false => self.alone += 1,
            }
        }
    }
}

/// Whether a factor is the sign, or a second one, `\mathrm{d}^2 x`.
fn is_sign(factor: &Expr, d: &Symbol) -> bool {
    match factor {
        Expr::Symbol(own) => own == d,
        Expr::Power(base, _) => is_upright(d) && matches!(&**base, Expr::Symbol(own) if own == d),
        _ => false,
    }
}

/// Whether a factor is a name, or a power of one: `ds^2 = dx^2 + dy^2`.
fn is_name(factor: &Expr) -> bool {
    match factor {
        Expr::Power(base, _) => is_name(base),
        factor => matches!(factor, Expr::Symbol(_) | Expr::Apply(..)),
    }
}

fn is_upright(d: &Symbol) -> bool {
    d.name() == "\\text{d}"
}
