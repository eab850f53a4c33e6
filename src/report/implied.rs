//! What follows in the place of a failing equation, and how far what is printed is from it.

use crate::algebra::{BigRational, Expr};
use crate::notation::{latex_formula, plain, plain_formula};
use crate::search::Implied;

/// As LaTeX, to be put in the place of what is printed.
pub(super) fn instead(implied: &Implied) -> String {
    let written = latex_formula(&implied.proven.claim().goal);
    format!("what follows is `{written}`{}", comparison(implied))
}

/// In one line.
pub(super) fn instead_plainly(implied: &Implied) -> String {
    let written = plain_formula(&implied.proven.claim().goal);
    format!("what follows is {written}{}", comparison(implied))
}

fn comparison(implied: &Implied) -> String {
    match &implied.ratio {
        Some(ratio) => format!("; what is printed is {}", times(ratio)),
        None => String::new(),
    }
}

/// `twice that`, `half of that`, `e² times that`.
fn times(ratio: &Expr) -> String {
    let whole = |value: i64| BigRational::from_integer(value.into());
    match ratio {
        Expr::Number(value) if *value == whole(2) => "twice that".into(),
        Expr::Number(value) if *value == whole(-1) => "that with the wrong sign".into(),
        Expr::Number(value) if *value == whole(2).recip() => "half of that".into(),
        Expr::Sum(_) => format!("({}) times that", plain(ratio)),
        _ => format!("{} times that", plain(ratio)),
    }
}
