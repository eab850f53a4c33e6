//! What there is to say beside a verdict, as findings.

use annotate_snippets::Level;

use crate::audit::{Entry, Note};
use crate::derivation::Source;
use crate::document::Span;
use crate::notation::Mark;

use super::super::Report;
use super::super::line::exchange;
use super::super::words::list;
use super::fails::conditional;
use super::{Finding, replay, unreadable};

impl Report<'_> {
    /// One note of an entry.
    pub(super) fn noted(&self, entry: &Entry, note: &Note) -> Option<Finding> {
        let equation = self.equation(entry.equation);
        let subject = self.subject(entry);
        let whole = self.statement(entry).map_or(equation.body, |s| s.span);
        let mut finding = Finding {
            level: Level::WARNING,
            code: note.code(),
            title: String::new(),
            page: equation.page,
            primary: (whole, String::new()),
            context: Vec::new(),
            said: Vec::new(),
        };
        match note {
            Note::Miscited { cited, instead } => {
                finding.title = format!(
                    "{subject} does not follow from {}; it does from {}",
                    self.references(cited),
                    self.sources(instead)
                );
                finding
                    .said
                    .extend(self.repair(note).map(|r| (Level::HELP, r)));
                for source in exchange(cited, instead).0 {
                    if let Source::Equation(at) = source {
                        finding.said.extend(self.where_they_are(&[at]));
                    }
                }
            }
            Note::CitationsShifted { by, steps, .. } => {
                if steps.is_empty() {
                    return None;
                }
                self.shifted(&mut finding, *by, steps);
            }
            Note::NumericNotSupported => {
                finding.title = format!("{subject} is not supported by its figures");
                if let Some(numeric) = &entry.numeric {
                    let text = super::super::numeric::headline(numeric);
                    finding.said.push((Level::NOTE, text));
                }
                let nearest = entry.numeric.as_ref().and_then(|own| own.nearest.as_ref());
                if let Some(nearest) = nearest {
                    let written = crate::notation::latex_formula(nearest);
                    let text = format!("the figures support `{written}`; did the pen slip?");
                    finding.said.push((Level::HELP, text));
                } else {
                    let text = "it is false whatever the figures are within their bounds";
                    finding.said.push((Level::NOTE, text.into()));
                }
            }
            Note::GivenUp => {
                finding.level = Level::ERROR;
                finding.title = format!(
                    "{subject}: the search broke down; this is a defect of this program, please report it"
                );
            }
            Note::UnstatedCondition(conditions) => {
                let shown = conditions.iter().map(crate::notation::plain_formula);
                finding.title = format!(
                    "{subject} holds if {}, and nothing says so",
                    list(shown.collect())
                );
                finding.said.push((Level::HELP, conditional(conditions)));
            }
            Note::InconsistentPremises(sources) => {
                finding.level = Level::ERROR;
                let given = entry.kind == crate::derivation::Kind::Given;
                finding.title = match (sources.is_empty(), given) {
                    // Nothing else is needed but the rest of its display, and what is declared.
                    (true, true) if entry.parts > 1 => {
                        format!(
                            "{subject} and the others of its display are true for no values that their symbols may have"
                        )
                    }
                    (true, true) => {
                        format!("{subject} is true for no values that its symbols may have")
                    }
                    (true, false) => format!(
                        "{subject} is derived from what is true for no values that its symbols may have"
                    ),
                    (false, true) => format!(
                        "{subject} contradicts {}: they cannot all be true",
                        self.sources(sources)
                    ),
                    (false, false) => format!(
                        "{subject} is derived from what cannot all be true: {}",
                        self.sources(sources)
                    ),
                };
                let text = "anything follows from a contradiction, so nothing is proved by it";
                finding.said.push((Level::NOTE, text.into()));
            }
            Note::WrongMark(mark) => {
                finding.level = Level::ERROR;
                finding.title = match mark {
                    Mark::Tick => format!("the author ticks {subject}, and it does not hold"),
                    Mark::Cross => format!("the author crosses out {subject}, and it holds"),
                };
                if let Some(mark) = self.statement(entry).and_then(|s| s.mark.as_ref()) {
                    finding.primary = (mark.span, "the author's mark".into());
                }
            }
            Note::UnknownCitation(label, span) => {
                finding.level = Level::ERROR;
                finding.title = format!("{subject} cites {label}, and there is no such equation");
                finding.primary = (*span, "cited here".into());
                finding.context = vec![(equation.body, "by this equation".into())];
            }
            Note::CitesLater(at) => {
                finding.title = format!(
                    "{subject} cites {}, which is derived only later",
                    self.reference(*at)
                );
                finding.said.extend(self.where_they_are(&[*at]));
            }
            Note::DuplicateTag(at) => {
                finding.level = Level::ERROR;
                let label = self.reference(entry.equation);
                finding.title = format!("{label} stands for two equations");
                let text = format!("the first is at {}", self.place(*at));
                finding.said.push((Level::NOTE, text));
                let help =
                    "give one of them another number; citations mean the one on the same page";
                finding.said.push((Level::HELP, help.into()));
            }
            Note::Unreadable(error) => {
                let subject = match equation.label() {
                    Some(_) => subject,
                    None => "this equation".into(),
                };
                let title = format!("{subject} could not be read: {}", error.message);
                let help = error.help.clone();
                let mut finding = unreadable(equation.page, error.span, title, help);
                if contains(equation.body, error.span) && equation.body != error.span {
                    finding.primary.1 = "here".into();
                }
                return Some(finding);
            }
            Note::RestsOn(_)
            | Note::UnreadablePremise(_)
            | Note::Uncited(_)
            | Note::OutOfScope(_)
            | Note::RestsOnUnproved(_)
            | Note::UnusedPremise(_)
            | Note::TakenAsGiven(_)
            | Note::TakenAsConstant(_)
            | Note::OtherReading(_) => return None,
        }
        if !matches!(note, Note::DuplicateTag(_) | Note::UnknownCitation(..)) {
            finding.said.push(replay(self, entry.equation));
        }
        Some(finding)
    }

    /// One finding for steps whose citations are all off by the same number.
    fn shifted(&self, finding: &mut Finding, by: i64, steps: &[usize]) {
        let (off, mend) = match by > 0 {
            true => ("small", "add"),
            false => ("large", "subtract"),
        };
        let (by, preposition) = (by.abs(), if by > 0 { "to" } else { "from" });
        finding.title = format!(
            "the numbers cited by {} are all {by} too {off}",
            self.references(steps)
        );
        let help = format!("{mend} {by} {preposition} each number that they cite");
        finding.said.push((Level::HELP, help));
        for &at in steps {
            let (cited, ..) = self.derivation.premises(at);
            let pairs = cited.iter().filter_map(|&cited| {
                let number = self.derivation.number(cited)?;
                let signed = if off == "small" { by } else { -by };
                Some(format!("({number}) stands for ({})", number + signed))
            });
            let text = format!("in {}, {}", self.reference(at), list(pairs.collect()));
            finding.said.push((Level::NOTE, text));
        }
        finding.primary.1 = "the first of them".into();
    }

    /// What would mend it, where that is known.
    pub fn repair(&self, note: &Note) -> Option<String> {
        match note {
            Note::UnstatedCondition(conditions) => Some(conditional(conditions)),
            Note::Miscited { cited, instead } | Note::CitationsShifted { cited, instead, .. } => {
                let (added, dropped) = exchange(cited, instead);
                match (added.is_empty(), dropped.is_empty()) {
                    (true, _) => None,
                    (false, true) => Some(format!("cite {} as well", self.sources(&added))),
                    (false, false) => Some(format!(
                        "cite {} instead of {}",
                        self.sources(&added),
                        self.references(&dropped)
                    )),
                }
            }
            _ => None,
        }
    }
}

fn contains(outer: Span, inner: Span) -> bool {
    outer.start <= inner.start && inner.end <= outer.end
}
