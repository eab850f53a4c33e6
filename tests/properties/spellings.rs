//! The same derivation written another way has the same verdicts.

use std::collections::BTreeMap;

use cradle_verify::algebra::BigRational;
use cradle_verify::audit::{Audit, Verdict};
use cradle_verify::derivation::{Derivation, Kind};
use cradle_verify::document::Document;
use cradle_verify::proofs::PAGES;
use proptest::collection::vec;
use proptest::prelude::*;

use super::pages::report;
use super::physics::nonzero;

/// The pages on unequal masses and what comes of them, which cite nothing before.
const UNEQUAL: std::ops::Range<usize> = 8..12;
/// The pages on identical balls, together with those between them.
const IDENTICAL: std::ops::Range<usize> = 3..8;

type Verdicts = Vec<(String, usize, Verdict, Vec<&'static str>)>;

fn verdicts(sources: &[(&str, String)]) -> Verdicts {
    let documents = sources
        .iter()
        .map(|(path, source)| Document::markdown(*path, source.as_str()));
    let derivation = Derivation::new(documents.collect());
    let problems: Vec<_> = derivation.pages.iter().flat_map(|p| &p.problems).collect();
    assert!(problems.is_empty(), "{problems:?}");
    let audit = Audit::of(&derivation);
    let entries = audit.entries.iter().map(|entry| {
        let equation = &derivation.equations[entry.equation];
        assert!(
            equation.statements.is_ok(),
            "{:?}: {:?}",
            equation.label(),
            equation.statements
        );
        let codes = entry.notes.iter().map(|n| n.code()).collect();
        (
            equation.label().unwrap_or_default().to_owned(),
            entry.part,
            entry.verdict,
            codes,
        )
    });
    entries.collect()
}

fn original(pages: std::ops::Range<usize>) -> Vec<(&'static str, String)> {
    pages
        .map(|at| (PAGES[at].0, PAGES[at].1.to_owned()))
        .collect()
}

/// Another name for every symbol, at once: through marks that no page contains.
fn renamed(source: &str, names: &[(&str, &str)]) -> String {
    let marks = names.iter().zip('\u{e000}'..);
    let marked = marks
        .clone()
        .fold(source.to_owned(), |text, ((old, _), mark)| {
            text.replace(old, &mark.to_string())
        });
    marks.fold(marked, |text, ((_, new), mark)| text.replace(mark, new))
}

/// An equation rewritten: its sides exchanged, both multiplied by a number, or both.
#[derive(Clone, Debug)]
struct Rewriting {
    swap: bool,
    scale: Option<BigRational>,
}

fn rewriting() -> impl Strategy<Value = Rewriting> {
    (any::<bool>(), proptest::option::of(nonzero()))
        .prop_map(|(swap, scale)| Rewriting { swap, scale })
}

impl Rewriting {
    /// `left = right` written the other way; what has more relations, or a box, is left alone.
    fn of(&self, body: &str) -> Option<String> {
        let cut = body.find("\\tag").unwrap_or(body.len());
        let (text, tag) = body.split_at(cut);
        let text = text.trim().trim_end_matches(['.', ',']);
        let marks = [
            "\\boxed",
            "\\quad",
            "\\qquad",
            "\\leq",
            "\\iff",
            "\\Rightarrow",
            "\\neq",
            "\\sim",
            "\\gg",
            "\\dots",
            "\\stackrel",
            "\\lim",
        ];
        let (left, right) = text.split_once('=')?;
        if right.contains('=') || marks.iter().any(|mark| text.contains(mark)) {
            return None;
        }
        let scaled = |side: &str| match &self.scale {
            Some(by) => format!(
                "\\frac{{{}}}{{{}}} \\left({}\\right)",
                by.numer(),
                by.denom(),
                side.trim()
            ),
            None => side.trim().to_owned(),
        };
        let (left, right) = (scaled(left), scaled(right));
        let (left, right) = if self.swap {
            (right, left)
        } else {
            (left, right)
        };
        Some(format!("{left} = {right} {tag}"))
    }
}

/// The pages with each derived equation rewritten in its own way.
fn rewritten(pages: std::ops::Range<usize>, how: &[Rewriting]) -> Vec<(&'static str, String)> {
    let mut sources = original(pages.clone());
    let mut changes: BTreeMap<usize, Vec<(usize, usize, String)>> = BTreeMap::new();
    for (equation, how) in report()
        .derivation()
        .equations
        .iter()
        .zip(how.iter().cycle())
    {
        if !pages.contains(&equation.page) || equation.kind == Kind::Given {
            continue;
        }
        let (start, end) = (equation.body.start, equation.body.end);
        if let Some(new) = how.of(&PAGES[equation.page].1[start..end]) {
            changes
                .entry(equation.page - pages.start)
                .or_default()
                .push((start, end, new));
        }
    }
    for (page, changes) in changes {
        for (start, end, new) in changes.into_iter().rev() {
            sources[page]
                .1
                .replace_range(start..end, &format!("\n{new}\n"));
        }
    }
    sources
}

/// Pages and the same pages with other names for their symbols are judged alike.
fn assert_same_verdicts(which: std::ops::Range<usize>, names: &[(&str, &str)]) {
    let pages = original(which);
    let other: Vec<_> = pages
        .iter()
        .map(|(path, source)| (*path, renamed(source, names)))
        .collect();
    assert_eq!(verdicts(&other), verdicts(&pages));
}

#[test]
fn a_page_spelt_with_other_letters() {
    let names = [
        ("m_1", "M_a"),
        ("m_2", "M_b"),
        ("v_0", "w"),
        ("v'_1", "x_{\\text{in}}"),
        ("v'_2", "y^*"),
        ("\\mu", "\\lambda"),
        ("\\eta", "\\varepsilon"),
        ("E'_2", "K"),
    ];
    assert_same_verdicts(UNEQUAL, &names);
}

#[test]
fn two_symbols_that_change_places() {
    let names = [
        ("m_1", "m_2"),
        ("m_2", "m_1"),
        ("v'_1", "v'_2"),
        ("v'_2", "v'_1"),
        ("\\mu", "\\eta"),
        ("\\eta", "\\mu"),
    ];
    assert_same_verdicts(UNEQUAL, &names);
}

#[test]
fn identical_balls_spelt_with_other_letters() {
    let names = [
        ("v_0", "V"),
        ("v'_1", "a'"),
        ("v'_2", "b'"),
        ("E_{\\text{after}}", "Z"),
        ("\\Delta E", "Q"),
    ];
    assert_same_verdicts(IDENTICAL, &names);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn unequal_balls_with_sides_exchanged_and_scaled(how in vec(rewriting(), 20..30)) {
        prop_assert_eq!(verdicts(&rewritten(UNEQUAL, &how)), verdicts(&original(UNEQUAL)));
    }

    #[test]
    fn identical_balls_with_sides_exchanged_and_scaled(how in vec(rewriting(), 5..10)) {
        prop_assert_eq!(verdicts(&rewritten(IDENTICAL, &how)), verdicts(&original(IDENTICAL)));
    }
}
