//! Names that a page has both before arguments and before factors: `f(x)` here, `f(x + 1)` there.

use std::collections::BTreeSet;

use crate::algebra::Symbol;
use crate::notation::SyntaxError;

use super::Equation;

/// Refuses the equations of a page in which a name is read as a factor before a parenthesis and elsewhere on the page as a function.
///
/// `f(x + 1)` is a product by itself ([docs/notation.md](../../docs/notation.md)). Where the page has `f(x)` too, it is the
/// value of a function at another place, and a product would be a misreading.
pub(super) fn refuse(equations: &mut [Equation]) {
    let before = |equation: &Equation| {
        let statements = equation.statements().iter();
        let all = statements.flat_map(|statement| statement.before.clone());
        all.collect::<Vec<_>>()
    };
    let functions: BTreeSet<Symbol> = equations
        .iter()
        .flat_map(|equation| equation.statements())
        .flat_map(|statement| &statement.before)
        .filter(|before| before.applied)
        .map(|before| before.name.clone())
        .collect();
    if functions.is_empty() {
        return;
    }
    for equation in equations {
        let factor = before(equation)
            .into_iter()
            .find(|before| !before.applied && functions.contains(&before.name));
        if let Some(factor) = factor {
            let name = &factor.name;
            equation.statements = Err(SyntaxError {
                span: factor.span,
                message: format!(
                    "whether the function `{name}` is applied here, or a factor, is not clear"
                ),
                help: Some(format!(
                    "for a product write `{name} \\cdot (…)`; a function is read only with bare symbols as its arguments"
                )),
            });
        }
    }
}
