//! True equations with one thing in them changed: the audit must never prove one that is false of the balls, and must
//! say so with a witness that stands up to another evaluation.

use std::fmt::Write;

use cradle_verify::algebra::BigRational;
use cradle_verify::audit::{Audit, Verdict};
use cradle_verify::derivation::{Derivation, Point};
use cradle_verify::document::Document;
use cradle_verify::kernel::Refuted;
use cradle_verify::proofs::PAGES;
use num_traits::{One, Zero};

use super::pages::{TOTALS, UNEQUAL, report};
use super::physics::*;

/// Changed equations that are false and that the search does not refute: it lowers no sum from 2 on, and on the
/// other pages it only ever looks where μ = 1, where these are true or have no value. None is said to hold.
const UNDECIDED: &[(&str, &str)] = &[
    ("19", r"\sum_{i=[2]}^k u_i^2"),
    ("63", r"(1[-]\mu)^2"),
    ("66", r"([2]+\mu)^4"),
    ("66", r"(1[-]\mu)^4"),
    ("66", r"(1+\mu)^[8]"),
    ("66", r"(1+\mu)^[5]"),
    ("68", r"[8](1-\mu)"),
    ("68", r"[5](1-\mu)"),
    ("68", r"([2]+\mu)^3"),
    ("68", r"(1[-]\mu)^3"),
    ("68", r"(1+\mu)^[6]"),
    ("68", r"(1+\mu)^[4]"),
];

/// One place in a page, and what is put there instead.
struct Break {
    page: usize,
    label: String,
    source: String,
    shown: String,
}

/// Whether a digit is part of a name: `v'_1`, `\mu_{12}`. Exponents are not.
fn in_subscript(before: &str) -> bool {
    before.ends_with('_') || before.ends_with("_{")
}

/// Every number doubled or increased by one, and every sign between terms turned, one at a time.
fn breaks(label: &str) -> Vec<Break> {
    let equation = report().equation(label).unwrap();
    let (_, source) = PAGES[equation.page];
    let body = &source[equation.body.start..equation.body.end];
    let body = &body[..body.find("\\tag").unwrap_or(body.len())];
    let mut all = Vec::new();
    let mut put = |at: usize, length: usize, new: String| {
        let mut changed = source.to_owned();
        let start = equation.body.start + at;
        changed.replace_range(start..start + length, &new);
        let shown = format!("{}[{new}]{}", &body[..at], &body[at + length..]);
        all.push(Break {
            page: equation.page,
            label: label.to_owned(),
            source: changed,
            shown,
        });
    };
    for (at, sign) in body.char_indices() {
        if let Some(digit) = sign.to_digit(10)
            && !in_subscript(&body[..at])
        {
            let new = [2 * digit, digit + 1];
            let new = &new[..if new[0] == new[1] { 1 } else { 2 }];
            for new in new.iter().filter(|&&new| new != digit) {
                // `\frac12` is two numbers; only one digit stays one.
                if *new < 10 {
                    put(at, 1, new.to_string());
                }
            }
        }
        match sign {
            '+' => put(at, 1, "-".into()),
            '-' => put(at, 1, "+".into()),
            _ => {}
        }
    }
    all
}

fn broken_report(own: &Break) -> Derivation {
    let pages = PAGES.iter().enumerate().map(|(at, &(path, source))| {
        let source = if at == own.page { &own.source } else { source };
        Document::markdown(path, source)
    });
    // What comes later cites the broken page and is not looked at.
    Derivation::new(pages.take(own.page + 1).skip(own.page.min(FIRST)).collect())
}

/// The pages on unequal masses start here; they cite nothing before.
const FIRST: usize = 8;

/// Premises true, goal false, by an evaluation that is not the kernel's.
pub fn stands_up(refuted: &Refuted) -> Result<(), String> {
    // Irrational points are held against plain numbers in `algebraic`; these are of rational numbers.
    if refuted.witness().algebraic.is_some() {
        return Ok(());
    }
    let at = Point::at_witness(refuted);
    let claim = refuted.claim();
    for (symbol, value) in &at.values().symbols {
        let domain = claim.domains.get(symbol);
        if domain.is_some_and(|domain| !domain.contains(value)) {
            return Err(format!("{symbol} = {value} lies outside of its domain"));
        }
    }
    for hypothesis in &claim.hypotheses {
        match at.holds(&hypothesis.formula) {
            Ok(true) => {}
            other => return Err(format!("{other:?}: {:?}", hypothesis.formula)),
        }
    }
    match at.holds(&claim.goal) {
        Ok(false) => Ok(()),
        other => Err(format!("{other:?}: the goal {:?}", claim.goal)),
    }
}

/// Audits every broken form of these equations that is false at one of the points.
fn audit_broken(labels: &[&str], points: &[Point], least: usize) {
    let (mut said, mut tried) = (String::new(), 0);
    for own in labels.iter().flat_map(|label| breaks(label)) {
        let derivation = broken_report(&own);
        let checker = cradle_verify::derivation::Checker::new(derivation);
        let truths = points.iter().map(|at| {
            let sides = checker.sides_at(&own.label, at);
            sides.is_ok_and(|sides| sides.iter().all(|s| s.holds))
        });
        let differs = truths.filter(|&t| !t).count() > 0;
        let equation = checker.equation(&own.label).unwrap();
        if !differs || equation.statements.is_err() {
            continue;
        }
        tried += 1;
        let position = checker
            .derivation()
            .equations
            .iter()
            .position(|e| std::ptr::eq(e, equation))
            .unwrap();
        let audit: &Audit = checker.audit();
        let entries = audit.of_equation(position);
        if entries.iter().all(|e| e.verdict == Verdict::Given) {
            continue;
        }
        let mut failing = entries.iter().filter(|e| e.is_wrong());
        match failing.next().and_then(|e| e.refuted()) {
            // A changed exponent changes a dimension too, and then numbers need not tell.
            None if entries.iter().any(|e| e.verdict == Verdict::IllDimensioned) => {}
            None => {
                let known =
                    |&(label, part): &(&str, &str)| label == own.label && own.shown.contains(part);
                let holds = entries.iter().all(|e| e.verdict == Verdict::Holds);
                if !holds && UNDECIDED.iter().any(known) {
                    continue;
                }
                let verdict = entries[0].verdict.word();
                let _ = writeln!(said, "({}) is {verdict}: {}", own.label, own.shown.trim());
            }
            Some((_, refuted)) => {
                if let Err(problem) = stands_up(refuted) {
                    let _ = writeln!(said, "({}) {}: {problem}", own.label, own.shown.trim());
                }
            }
        }
    }
    assert!(tried > least, "only {tried} equations were really broken");
    assert!(said.is_empty(), "{said}");
}

#[test]
fn broken_equations_of_unequal_balls() {
    let points: Vec<Point> = [(1, 2, 3), (5, 3, 2), (1, 1, -1), (2, 7, -5)]
        .map(|(m1, m2, v0)| unequal(&ratio(m1, 1), &ratio(m2, 1), &ratio(v0, 2)))
        .into();
    audit_broken(UNEQUAL, &points, 100);
}

#[test]
fn broken_equations_of_slopes() {
    let at = |mu: i64| {
        Point::new()
            .with("\\mu", mu)
            .with_term("\\eta", "4\\mu / (1+\\mu)^2")
    };
    audit_broken(&["65", "66", "67", "68"], &[at(1), at(2), at(5)], 20);
}

#[test]
fn broken_totals() {
    let real = Cradle {
        balls: 3,
        moving: 2,
        v0: ratio(3, 2),
        after: vec![ratio(3, 2); 2],
    };
    let mut scatter = vec![BigRational::one(), Zero::zero(), Zero::zero()];
    scatter = scattered(scatter, &[ratio(1, 1), ratio(2, 1), ratio(4, 1)]);
    let spread = Cradle {
        balls: 3,
        moving: 1,
        v0: ratio(1, 1),
        after: scatter,
    };
    let own: Vec<&str> = TOTALS[2..].to_vec();
    audit_broken(&own, &[real.point(), spread.point()], 3);
}
