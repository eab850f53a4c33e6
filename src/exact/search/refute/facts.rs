//! What is asked of a point besides the premises: that the goal is false there, what roots mean, that units are 1.

use crate::algebra::{
    Atom, Atoms, Expr, Formula, Function, Lowering, Polynomial, Rational, Symbol,
};
use crate::kernel::{Claim, Fact, Sign};
use crate::sorted::Set;

/// What is true where a goal is not.
pub fn negation(goal: &Fact) -> Fact {
    let (polynomial, sign) = match goal.sign {
        Sign::Zero => (goal.polynomial.clone(), Sign::NonZero),
        Sign::NonZero => (goal.polynomial.clone(), Sign::Zero),
        Sign::NonNegative => (goal.polynomial.negated(), Sign::Positive),
        Sign::Positive => (goal.polynomial.negated(), Sign::NonNegative),
    };
    Fact { polynomial, sign }
}

/// What roots mean: `s^q = base`, `s ≥ 0`. `None` where a term cannot be given a value at all.
pub fn roots(atoms: &mut Atoms) -> Option<Vec<Fact>> {
    let mut facts = Vec::new();
    let opaque: Vec<_> = atoms
        .iter()
        .filter_map(|(var, atom)| match atom {
            Atom::Opaque(expr) => Some((var, expr.clone())),
            _ => None,
        })
        .collect();
    // Nothing runs on through a root of 0.
    let is_slope = |expr: &Expr| matches!(expr, Expr::Derivative { .. });
    let sign = match opaque.iter().any(|(_, expr)| is_slope(expr)) {
        true => Sign::Positive,
        false => Sign::NonNegative,
    };
    for (var, expr) in opaque {
        match &expr {
            Expr::Derivative { body, .. }
                if matches!(**body, Expr::Symbol(_) | Expr::Derivative { .. }) => {}
            Expr::Power(base, exponent) => {
                let Expr::Number(exponent) = &**exponent else {
                    return None;
                };
                let q: u32 = exponent.denom().try_into().ok()?;
                let mut lowering = Lowering::plain(atoms);
                let base = lowering.lower(base).ok()?;
                let root = Polynomial::var(var);
                let below = base.expanded_denominator().ok()?;
                let left = root.pow(q).ok()?.times(&below).ok()?;
                facts.push(Fact {
                    polynomial: left.minus(base.numerator()),
                    sign: Sign::Zero,
                });
                facts.push(Fact {
                    polynomial: root,
                    sign,
                });
            }
            // What is known of these is among the facts.
            Expr::Call(function, _) if !matches!(function, Function::Ceiling | Function::Floor) => {
            }
            _ => return None,
        }
    }
    Some(facts)
}

/// That units of measurement are 1: in which units a point is given makes no difference where dimensions agree. Where what is to follow
/// has a unit that nothing it follows from has, they do not, and another unit may show it; but a mere number beside one is a number whose
/// unit was left out.
pub fn measured_in_units(claim: &Claim, atoms: &Atoms) -> impl Iterator<Item = Fact> {
    let units = |formula: &Formula| -> Set<Symbol> {
        let symbols = formula.free_symbols().into_iter();
        symbols.filter(Symbol::is_unit).collect()
    };
    let is_unit = |atom: &Atom| matches!(atom, Atom::Symbol(symbol) if symbol.is_unit());
    // Most claims speak of none.
    let is_open = atoms.iter().any(|(_, atom)| is_unit(atom)) && {
        let of_goal = units(&claim.goal);
        let known: Set<Symbol> = (claim.hypotheses.iter())
            .flat_map(|own| units(&own.formula))
            .collect();
        let mut sides = claim.goal.terms().into_iter();
        !known.is_empty()
            && !of_goal.is_subset(&known)
            && !sides.any(|side| side.free_symbols().is_empty())
    };
    let units = atoms
        .iter()
        .filter(move |(_, atom)| !is_open && is_unit(atom));
    let one = Polynomial::constant(Rational::one());
    units.map(move |(var, _)| Fact {
        polynomial: Polynomial::var(var).minus(&one),
        sign: Sign::Zero,
    })
}
