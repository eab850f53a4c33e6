//! An equation that does not follow: what it was judged from, and a point that shows it.

use annotate_snippets::Level;

use crate::audit::{Entry, Judged, Note};
use crate::derivation::Source;
use crate::kernel::Refuted;
use crate::notation::{Mark, plain_formula};

use super::super::Report;
use super::super::evidence::Point;
use super::super::implied;
use super::super::induction;
use super::super::scaling;
use super::super::words;
use super::{Finding, replay};

/// A list of values is broken into lines of this length.
const WIDTH: usize = 76;

impl Report<'_> {
    pub(super) fn failing(&self, entry: &Entry) -> Option<Finding> {
        let Some((judged, refuted)) = entry.refuted() else {
            return self.failing_to_scale(entry);
        };
        let page = self.equation(entry.equation).page;
        let point = Point::new(refuted.claim(), refuted.witness());
        let sides = point.sides_judged(judged);
        let (left, right) = judged.goal.sides;
        let mut context = Vec::new();
        let primary = match &sides {
            Some((a, b)) if left != right && judged.solution().is_none() => {
                context.push((left, format!("is {a} at the point below")));
                (right, format!("is {b}"))
            }
            _ if judged.solution().is_some() => {
                let what = match judged.goal.sides {
                    (left, right) if left != right => left.to(right),
                    _ => judged.goal.span,
                };
                (what, "does not obey what it solves".to_owned())
            }
            _ if judged.is_expanded() => (right, "has another series".to_owned()),
            _ if judged.is_of_change() => {
                (right, "changes otherwise than the left side".to_owned())
            }
            _ => (judged.goal.span, "is false at the point below".to_owned()),
        };
        let fault = match judged.solution() {
            Some(_) => "is no solution",
            None => "does not follow",
        };
        Some(Finding {
            level: Level::ERROR,
            code: "fails",
            title: format!(
                "{} {fault}: {}",
                self.subject(entry),
                self.in_numbers(judged, refuted)
            ),
            page,
            primary,
            context,
            said: self.evidence(entry, judged, refuted),
        })
    }

    fn failing_to_scale(&self, entry: &Entry) -> Option<Finding> {
        let (judged, refuted, repair) = entry.rescaled()?;
        let mut said = vec![(
            Level::NOTE.with_name("judged from"),
            self.judged_from(judged),
        )];
        said.push((
            Level::NOTE.with_name("counterexample"),
            wrapped_list(&scaling::grown(refuted)) + "\nkeeps every premise true",
        ));
        said.extend(repair.map(|repair| (Level::HELP, scaling::repaired(refuted, repair))));
        said.extend(marks(entry));
        said.extend(self.other_reading(entry));
        said.push(replay(self, entry.equation));
        Some(Finding {
            level: Level::ERROR,
            code: "fails",
            title: format!(
                "{} does not follow: {}",
                self.subject(entry),
                self.in_situations(judged, refuted)
            ),
            page: self.equation(entry.equation).page,
            primary: (judged.goal.sides.1, "scales differently".into()),
            context: Vec::new(),
            said,
        })
    }

    fn evidence(
        &self,
        entry: &Entry,
        judged: &Judged,
        refuted: &Refuted,
    ) -> Vec<(Level<'static>, String)> {
        let mut said = vec![(
            Level::NOTE.with_name("judged from"),
            self.judged_from(judged),
        )];
        let point = Point::new(refuted.claim(), refuted.witness());
        let mut lines = match point.values().as_slice() {
            [] => vec!["there is nothing to choose".to_owned()],
            values => wrapped(values),
        };
        let formula = &judged.goal.formula;
        match point.sides_judged(judged) {
            Some((left, right)) => lines.push(format!(
                "left {}, right {}",
                left.equated(),
                right.equated()
            )),
            None => lines.push(format!("`{}` is false there", plain_formula(formula))),
        }
        lines.extend(point.remark());
        said.push((Level::NOTE.with_name("counterexample"), lines.join("\n")));
        let early = induction::before_the_start(refuted.claim());
        said.extend(early.map(|text| (Level::HELP, text)));
        let instead = implied::instead(entry);
        said.extend(instead.map(|text| (Level::HELP, text)));
        if !entry.missing.is_empty() {
            said.push((Level::HELP, self.supposing(entry)));
        }
        said.extend(self.perhaps_law(entry).map(|text| (Level::HELP, text)));
        said.extend(marks(entry));
        said.extend(self.other_reading(entry));
        said.push(replay(self, entry.equation));
        said
    }

    /// The premises, each with its text.
    fn judged_from(&self, judged: &Judged) -> String {
        let mut lines: Vec<String> = Vec::new();
        for assumed in &judged.assumed {
            // That all else stands still on the way is what a series in one thing means.
            if judged.is_expanded() && assumed.source == Source::Step {
                continue;
            }
            let from = match assumed.source {
                Source::Equation(at) => self.name(at),
                Source::Local(..) => "supposed".into(),
                Source::Taken if judged.solution() == Some(assumed) => "it says".into(),
                of_no_place => words::unplaced(of_no_place).into(),
            };
            lines.push(format!("{from}: {}", plain_formula(&assumed.formula)));
        }
        match lines.is_empty() {
            true => "nothing but the declared domains".into(),
            false => lines.join("\n"),
        }
    }
}

/// What the author marks, and what would have to be stated.
fn marks(entry: &Entry) -> Vec<(Level<'static>, String)> {
    let mut said = Vec::new();
    for note in &entry.notes {
        match note {
            Note::UnstatedCondition(conditions) => {
                said.push((Level::HELP, implied::supposing(conditions)));
            }
            Note::WrongMark(Mark::Tick) => said.push((
                Level::NOTE,
                "the author marks it ✓, as an equation that holds".into(),
            )),
            Note::WrongMark(Mark::Cross) => said.push((
                Level::NOTE,
                "the author crosses out something else: this link is meant to hold".into(),
            )),
            _ => {}
        }
    }
    said
}

/// What would have to be stated.
pub(super) fn conditional(conditions: &[crate::algebra::Formula]) -> String {
    let conditions = conditions.iter().map(plain_formula).collect();
    format!("holds if {} is stated", words::list(conditions))
}

fn wrapped(values: &[(String, String)]) -> Vec<String> {
    let items = values
        .iter()
        .map(|(name, value)| format!("{name} = {value}"));
    broken(&items.collect::<Vec<_>>())
}

fn wrapped_list(items: &[String]) -> String {
    broken(items).join("\n")
}

fn broken(items: &[String]) -> Vec<String> {
    let mut lines = vec![String::new()];
    for (at, item) in items.iter().enumerate() {
        let comma = if at + 1 < items.len() { "," } else { "" };
        let item = format!("{item}{comma}");
        match lines.last_mut() {
            Some(line) if line.is_empty() => *line = item,
            Some(line) if line.chars().count() + item.chars().count() < WIDTH => {
                *line = format!("{line} {item}");
            }
            _ => lines.push(item),
        }
    }
    lines
}
