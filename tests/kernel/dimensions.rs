//! Forged evidence about dimensions.

use std::sync::Arc;

use cradle_verify::algebra::{Base, Dimension, Rational, Symbol};
use cradle_verify::kernel::dimension::{
    Disagreement, Form, Mismatch, Part, Rescaling, Said, Scope, Unknown, check_agreement,
    check_disagreement, comparisons,
};
use cradle_verify::sorted::Map;

use super::claims::{formula, number};

const MASS: &[(Base, i32)] = &[(Base::Mass, 1)];
const VELOCITY: &[(Base, i32)] = &[(Base::Length, 1), (Base::Time, -1)];
const ENERGY: &[(Base, i32)] = &[(Base::Mass, 1), (Base::Length, 2), (Base::Time, -2)];

/// `m`, `v` and `E` are declared, `p` and `q` are not.
fn scope() -> Arc<Scope> {
    let declared = [("m", MASS), ("v", VELOCITY), ("E", ENERGY)];
    let mut symbols: Map<Symbol, Said> = declared
        .iter()
        .map(|(name, exponents)| (Symbol::new(*name), Said::Declared(Dimension::of(exponents))))
        .collect();
    symbols.insert(Symbol::new("p"), Said::Unknown(Unknown(0)));
    symbols.insert(Symbol::new("q"), Said::Unknown(Unknown(1)));
    Arc::new(Scope {
        symbols,
        sequences: Map::new(),
    })
}

fn part(text: &str, multiplier: i32) -> Part {
    Part {
        formula: formula(text),
        scope: scope(),
        comparison: 0,
        multiplier: Rational::from(multiplier),
    }
}

fn known(exponents: &[(Base, i32)]) -> Form {
    Form::known(Dimension::of(exponents))
}

fn momentum() -> Form {
    known(&[(Base::Mass, 1), (Base::Length, 1), (Base::Time, -1)])
}

/// `E = m v`, with lengths measured in half metres.
fn alone() -> Disagreement {
    Disagreement {
        parts: vec![part("E = m v", 1)],
        solution: Map::new(),
        rescaling: Some(Rescaling {
            base: Base::Length,
            factor: number(2),
            left: number(4),
            right: number(2),
        }),
    }
}

/// `p = m v` after `E = p`.
fn together() -> Disagreement {
    Disagreement {
        parts: vec![part("p = m v", 1), part("E = p", 1)],
        solution: Map::from([(Unknown(0), known(ENERGY))]),
        rescaling: None,
    }
}

fn rejected(evidence: Disagreement) -> Mismatch {
    check_disagreement(evidence).expect_err("it is forged")
}

#[test]
fn what_disagrees_is_accepted() {
    let evidence = check_disagreement(alone()).unwrap();
    assert_eq!(evidence.comparison().left.form, known(ENERGY));
    assert_eq!(
        evidence.comparison().right.as_ref().unwrap().form,
        momentum()
    );
    let evidence = check_disagreement(together()).unwrap();
    assert_eq!(evidence.comparison().left.form, known(ENERGY));
}

#[test]
fn no_evidence_at_all_is_rejected() {
    let evidence = Disagreement {
        parts: Vec::new(),
        ..alone()
    };
    assert_eq!(rejected(evidence), Mismatch::Nothing);
}

#[test]
fn what_agrees_is_rejected() {
    let mut evidence = alone();
    evidence.rescaling = None;
    evidence.parts = vec![part("E = m q", 1), part("q = v", 1)];
    evidence.solution = Map::from([(Unknown(1), known(VELOCITY))]);
    assert!(check_disagreement(evidence.clone()).is_ok());
    evidence.parts[0] = part("E = m v q", 1);
    assert_eq!(rejected(evidence), Mismatch::Agrees);
}

#[test]
fn a_comparison_that_the_formula_does_not_make_is_rejected() {
    let mut evidence = alone();
    evidence.parts[0].comparison = 1;
    assert_eq!(rejected(evidence), Mismatch::NoSuchComparison);
    let mut evidence = alone();
    evidence.parts[0] = part("E = m v^2", 1);
    assert_eq!(rejected(evidence), Mismatch::NoSuchComparison);
}

#[test]
fn multipliers_that_leave_an_unknown_are_rejected() {
    let mut evidence = together();
    evidence.parts[1].multiplier = Rational::from(-1);
    assert_eq!(rejected(evidence), Mismatch::UnknownsLeft);
    let mut evidence = together();
    evidence.parts.pop();
    assert_eq!(rejected(evidence), Mismatch::UnknownsLeft);
}

#[test]
fn an_innocent_equation_is_not_found_guilty_by_two_others() {
    let mut evidence = together();
    evidence.parts.insert(0, part("m = q", 0));
    assert_eq!(rejected(evidence), Mismatch::NotInvolved);
}

#[test]
fn a_solution_that_does_not_solve_is_rejected() {
    let mut evidence = together();
    evidence.solution.insert(Unknown(0), momentum());
    assert_eq!(rejected(evidence), Mismatch::NoSolution);
    let mut evidence = together();
    evidence.solution.clear();
    assert_eq!(rejected(evidence), Mismatch::NoSolution);
}

#[test]
fn a_solution_in_a_circle_is_rejected() {
    let mut evidence = together();
    let unknown = |at| Form::said(&Said::Unknown(Unknown(at)));
    evidence.solution = Map::from([(Unknown(0), unknown(1)), (Unknown(1), unknown(0))]);
    assert_eq!(rejected(evidence), Mismatch::NoSolution);
}

#[test]
fn a_wrong_change_of_units_is_rejected() {
    let change = |change: fn(&mut Rescaling)| {
        let mut evidence = alone();
        change(evidence.rescaling.as_mut().unwrap());
        rejected(evidence)
    };
    assert_eq!(change(|r| r.left = number(2)), Mismatch::WrongFactor);
    assert_eq!(change(|r| r.right = number(4)), Mismatch::WrongFactor);
    assert_eq!(change(|r| r.base = Base::Time), Mismatch::WrongFactor);
    assert_eq!(change(|r| r.base = Base::Mass), Mismatch::WrongFactor);
    assert_eq!(change(|r| r.factor = number(-2)), Mismatch::WrongFactor);
    // True of every unit that is left as it is.
    assert_eq!(
        change(|r| {
            r.factor = number(1);
            r.left = number(1);
            r.right = number(1);
        }),
        Mismatch::WrongFactor
    );
}

#[test]
fn a_power_of_an_unknown_with_a_symbolic_exponent_says_nothing() {
    assert!(
        comparisons(&formula("E = p^{q} m"), &scope())
            .iter()
            .all(|c| c.right.is_none())
    );
    assert!(comparisons(&formula("v^{m/m} = v"), &scope()).len() == 1);
}

#[test]
fn agreement_needs_every_comparison() {
    let scope = scope();
    let solution = Map::from([(Unknown(0), momentum())]);
    let agreed = |text| check_agreement(&formula(text), &scope, &solution);
    let sides = agreed("E = \\frac{p^2}{2 m}").unwrap();
    assert_eq!(sides.sides()[1], Some(known(ENERGY)));
    assert!(agreed("E = p v + p").is_err());
    assert!(agreed("0 = p v + p").is_err());
    assert!(agreed("E = p").is_err());
    assert!(agreed("p = \\sin(p)").is_err());
    // An unknown of which nothing is said may be anything, and so it proves nothing.
    assert!(agreed("q = p").is_err());
}
