//! The views of a judged scenario: one for people, one for programs. Both print exact numbers.

use std::fmt::Write;

use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use serde_json::{Value, json};

use super::table::{signed, strings, table};
use crate::cradle::{Judgement, Law, Outcome, Remark};

/// The scenario as a student would like to read it: the balls, each law with both its sides, the conclusion, remarks.
pub fn human(outcome: &Outcome) -> String {
    let mut page = headline(outcome) + "\n\n";
    page += &table(&motion(outcome));
    page.push('\n');
    page += &table(&laws(outcome));
    page.push('\n');
    for sentence in conclusion(outcome) {
        let _ = writeln!(page, "{sentence}");
    }
    if !outcome.remarks().is_empty() {
        page.push('\n');
    }
    for remark in outcome.remarks() {
        let _ = writeln!(page, "  note: {remark}");
    }
    page
}

/// The same for programs. Every number is a string in lowest terms, `"2/3"`, for JSON's own numbers are not exact.
pub fn json(outcome: &Outcome) -> Value {
    let scenario = outcome.scenario();
    let laws: Vec<Value> = outcome
        .judgements()
        .iter()
        .map(|judgement| {
            json!({
                "law": judgement.law.to_string(),
                "equations": judgement.equations,
                "before": judgement.before.to_string(),
                "after": judgement.after.to_string(),
                "difference": judgement.difference().to_string(),
                "ratio": judgement.ratio().map(|ratio| ratio.to_string()),
                "holds": judgement.holds(),
            })
        })
        .collect();
    json!({
        "scenario": scenario.name(),
        "sentence": scenario.sentence(),
        "masses": strings(scenario.masses()),
        "before": strings(scenario.before()),
        "after": strings(scenario.after()),
        "laws": laws,
        "holds": outcome.holds(),
        "possible": is_possible(outcome),
        "remarks": outcome.remarks().iter().map(Remark::to_string).collect::<Vec<_>>(),
    })
}

/// Whether both laws hold: what the exit code says.
pub fn holds(outcome: &Outcome) -> bool {
    outcome.holds()
}

/// Whether the outcome can happen; `None` where the laws do not forbid it, and nothing shows how it would.
fn is_possible(outcome: &Outcome) -> Option<bool> {
    let has = |wanted: fn(&Remark) -> bool| outcome.remarks().iter().any(wanted);
    let is_out_of_order = |remark: &Remark| {
        matches!(
            remark,
            Remark::PassesThrough { .. } | Remark::NothingCollides
        )
    };
    match () {
        () if !outcome.holds() => Some(false),
        () if has(|remark| matches!(remark, Remark::PairByPairAgrees)) => Some(true),
        () if has(is_out_of_order) => Some(false),
        () => None,
    }
}

fn headline(outcome: &Outcome) -> String {
    let scenario = outcome.scenario();
    match scenario.name() {
        Some(name) => format!("Scenario {name}: {}   (m = 1, v0 = 1)", scenario.sentence()),
        None => format!("Your scenario: {}", scenario.sentence()),
    }
}

/// The balls in columns; their masses only where they are not all 1.
fn motion(outcome: &Outcome) -> Vec<Vec<String>> {
    let scenario = outcome.scenario();
    let row = |label: &str, cells: Vec<String>| [vec![label.to_owned()], cells].concat();
    let mut rows = vec![row(
        "ball",
        (1..=scenario.masses().len())
            .map(|ball| ball.to_string())
            .collect(),
    )];
    if !scenario.masses().iter().all(One::is_one) {
        rows.push(row("mass", strings(scenario.masses())));
    }
    rows.push(row("velocity before", strings(scenario.before())));
    rows.push(row("velocity after", strings(scenario.after())));
    rows
}

fn laws(outcome: &Outcome) -> Vec<Vec<String>> {
    let mut rows = vec![
        ["law", "before", "after", "after − before", "", ""]
            .map(str::to_owned)
            .to_vec(),
    ];
    rows.extend(outcome.judgements().iter().map(|judgement| {
        let equations: Vec<String> = judgement
            .equations
            .iter()
            .map(|tag| format!("({tag})"))
            .collect();
        vec![
            judgement.law.to_string(),
            judgement.before.to_string(),
            judgement.after.to_string(),
            signed(&judgement.difference()),
            if judgement.holds() { "holds" } else { "FAILS" }.to_owned(),
            equations.join(", "),
        ]
    }));
    rows
}

/// What follows from the laws: a sentence for each one that fails, or one in praise.
fn conclusion(outcome: &Outcome) -> Vec<String> {
    if !outcome.holds() {
        let named = outcome.scenario().name().is_some();
        return outcome
            .judgements()
            .iter()
            .filter(|judgement| !judgement.holds())
            .map(|j| failure(j, named))
            .collect();
    }
    let verdict = match is_possible(outcome) {
        Some(true) => "Both laws hold: this outcome can happen.",
        Some(false) => {
            "Both laws hold, and still this outcome cannot happen: the order of the balls forbids it."
        }
        None => "Both laws hold: they do not forbid this outcome.",
    };
    vec![verdict.to_owned()]
}

/// How a law fails, by how much, and what that rules out.
fn failure(judgement: &Judgement, named: bool) -> String {
    let (quantity, unit, impossible) = match judgement.law {
        Law::Momentum => (
            "Momentum",
            "m v0",
            "without a push from outside, this outcome cannot happen.",
        ),
        Law::KineticEnergy if judgement.after > judgement.before => (
            "Kinetic energy",
            "m v0²",
            "with nothing to supply it, this outcome cannot happen.",
        ),
        Law::KineticEnergy => (
            "Kinetic energy",
            "m v0²",
            "with perfectly elastic balls, this outcome cannot happen.",
        ),
    };
    let difference = match (named, signed(&judgement.difference())) {
        (false, amount) => amount,
        (true, amount) if judgement.difference().abs().is_one() => {
            format!("{}{unit}", &amount[..1])
        }
        (true, amount) => format!("{amount} {unit}"),
    };
    let change = change(judgement);
    format!("{quantity} would have to {change} (after − before = {difference}):\n{impossible}")
}

/// The change as a verb: `double`, `vanish`, `change by the factor 5/9`.
fn change(judgement: &Judgement) -> String {
    let Some(ratio) = judgement.ratio() else {
        return "come from nothing".to_owned();
    };
    let is = |value: i32| ratio == BigRational::from_integer(value.into());
    match () {
        () if ratio.is_zero() => "vanish".to_owned(),
        () if is(2) => "double".to_owned(),
        () if is(3) => "triple".to_owned(),
        () if is(-1) => "turn round".to_owned(),
        () if ratio == BigRational::new(1.into(), 2.into()) => "halve".to_owned(),
        () if ratio.is_negative() => format!("turn round and change by the factor {}", -ratio),
        () => format!("change by the factor {ratio}"),
    }
}
