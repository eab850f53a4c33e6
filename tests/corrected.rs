//! The corrected pages: nothing on them may fail, rest on what fails, or be left undecided; and a slip anywhere is caught
//! where it is made.

mod slips;

use std::collections::BTreeSet;

use cradle_verify::audit::{Audit, Entry, Verdict};
use cradle_verify::derivation::Derivation;
use cradle_verify::notation::plain_formula;
use cradle_verify::proofs::corrected::{PAGES, corrected};
use slips::{SLIPS, SPREADING};

use crate::common;

/// `path:line`, the equation, and its name.
fn place(derivation: &Derivation, at: usize) -> String {
    let equation = &derivation.equations[at];
    let document = &derivation.pages[equation.page].document;
    let line = document.position(equation.body.start).line;
    format!("{}:{line}  {}", document.path, equation.reference())
}

/// What is amiss with one statement, in words.
fn amiss(entry: &Entry) -> Option<String> {
    let verdict = match entry.verdict {
        Verdict::Given | Verdict::Holds => Vec::new(),
        other => vec![other.word()],
    };
    let words: Vec<&str> = verdict
        .into_iter()
        .chain(entry.notes.iter().map(|note| note.code()))
        .collect();
    (!words.is_empty()).then(|| words.join(", "))
}

/// All that is amiss with pages, a line each.
fn complaints(derivation: &Derivation) -> Vec<String> {
    let audit = Audit::of(derivation);
    let mut all = Vec::new();
    for page in &derivation.pages {
        for problem in &page.problems {
            let line = page.document.position(problem.span.start).line;
            all.push(format!(
                "{}:{line}  {}",
                page.document.path, problem.message
            ));
        }
    }
    for entry in &audit.entries {
        if let Some(words) = amiss(entry) {
            let goals = entry.judged.iter().map(|j| plain_formula(&j.goal.formula));
            all.push(format!(
                "{}: {words}\n    {}",
                place(derivation, entry.equation),
                goals.collect::<Vec<_>>().join("; ")
            ));
        }
    }
    all
}

fn complain(faults: &[String]) {
    assert!(
        faults.is_empty(),
        "\n\n{}\n\n{} in all\n",
        faults.join("\n\n"),
        faults.len()
    );
}

#[test]
fn every_step_holds_and_rests_on_nothing_that_fails() {
    let derivation = corrected();
    assert!(derivation.equations.len() > 100);
    complain(&complaints(&derivation));
}

#[test]
fn each_page_stands_by_itself() {
    for (path, source) in PAGES {
        complain(&complaints(&Derivation::from_markdown(path, source)));
    }
}

#[test]
fn what_is_printed() {
    let derivation = corrected();
    let (findings, text) = common::reported(&derivation, |r| (r.findings(), r.human(false)));
    assert_eq!(findings, 0);
    let text = anstream::adapter::strip_str(&text).to_string();
    insta::assert_snapshot!("human", text);
}

/// The equations of a page with a statement that fails or is ill-dimensioned.
fn wrong(derivation: &Derivation) -> BTreeSet<usize> {
    let audit = Audit::of(derivation);
    let entries = audit.entries.iter();
    let wrong = entries.filter(|entry| entry.is_wrong());
    wrong.map(|entry| entry.equation).collect()
}

#[test]
fn each_slip_is_caught_where_it_is_made_and_nowhere_else() {
    let whole = corrected();
    let mut faults = Vec::new();
    for (label, right, slip) in SLIPS.iter().chain(SPREADING) {
        let spreads = SPREADING.contains(&(label, right, slip));
        let equation = whole.find(label).expect("a slip names an equation");
        let (path, source) = PAGES[equation.page];
        let body = equation.body.range();
        let text = &source[body.clone()];
        let mut fault = |what: String| {
            let at = whole
                .equations
                .iter()
                .position(|e| std::ptr::eq(e, equation));
            let place = at.map(|at| place(&whole, at)).unwrap_or_default();
            faults.push(format!("{place}\n    {right} becomes {slip}\n    {what}"));
        };
        if text.matches(right).count() != 1 {
            fault("what is right does not stand exactly once in it".into());
            continue;
        }
        let mut changed = source.to_owned();
        changed.replace_range(body, &text.replacen(right, slip, 1));
        let page = Derivation::from_markdown(path, &changed);
        let own = page.equations.iter();
        let own = own.clone().position(|e| e.label() == equation.label());
        let own = own.expect("the equation keeps its name");
        let found = wrong(&page);
        if !found.contains(&own) {
            let audit = Audit::of(&page);
            let verdicts = audit.of_equation(own).iter().map(|e| e.verdict.word());
            fault(format!(
                "is not caught: {}",
                verdicts.collect::<Vec<_>>().join(", ")
            ));
        }
        let others: Vec<usize> = found.into_iter().filter(|&other| other != own).collect();
        if spreads && others.is_empty() {
            fault("good news: no other step fails with it now".into());
        }
        for other in others {
            if spreads && page.premises(other).0.contains(&own) {
                continue;
            }
            fault(format!("makes another step fail: {}", place(&page, other)));
        }
    }
    complain(&faults);
}

#[test]
fn every_derived_equation_has_a_slip() {
    let whole = corrected();
    let audit = Audit::of(&whole);
    let slipped = SLIPS.iter().chain(SPREADING);
    let slipped: BTreeSet<&str> = slipped.map(|slip| slip.0).collect();
    for entry in audit.entries.iter().filter(|e| e.verdict == Verdict::Holds) {
        let label = whole.equations[entry.equation].label();
        let label = label.expect("every equation has a number or a name");
        assert!(slipped.contains(label), "no slip is made in ({label})");
    }
}
