//! Findings in the author's own text: what is wrong, the exact evidence, the nearest repair.

mod differing;
mod dimensions;
mod fails;
mod notes;

use annotate_snippets::{Annotation, AnnotationKind, Element, Group, Level, Renderer, Snippet};

use crate::audit::{Note, Verdict};
use crate::document::Span;

use super::Report;

/// One finding, before it is laid out.
pub(super) struct Finding {
    pub level: Level<'static>,
    pub code: &'static str,
    pub title: String,
    pub page: usize,
    /// What is underlined as guilty, with a word about it.
    pub primary: (Span, String),
    /// What is pointed at besides.
    pub context: Vec<(Span, String)>,
    /// Notes and helps.
    pub said: Vec<(Level<'static>, String)>,
}

impl Report<'_> {
    /// All findings, in reading order; those that rest on the same failing equation together.
    pub fn diagnostics(&self) -> String {
        let mut text = String::new();
        for finding in self.all_findings() {
            text += &self.lay_out(&finding);
            text += "\n\n";
        }
        text
    }

    fn all_findings(&self) -> Vec<Finding> {
        let mut all = Vec::new();
        for (number, page) in self.derivation.pages.iter().enumerate() {
            for problem in &page.problems {
                all.push(unreadable(
                    number,
                    problem.span,
                    problem.message.clone(),
                    problem.help.clone(),
                ));
            }
        }
        for (&(page, at), conflict) in &self.audit.dimensions.suppositions {
            all.push(self.ill_supposed(page, at, conflict));
        }
        let mut told: Vec<&[usize]> = Vec::new();
        for entry in &self.audit.entries {
            let fails = entry.is_finding() && !entry.fails_as_marked();
            match entry.verdict {
                Verdict::Fails if fails => all.extend(self.failing(entry)),
                Verdict::IllDimensioned if fails => all.extend(self.ill_dimensioned(entry)),
                _ => {}
            }
            let apart = |note: &&Note| {
                note.is_finding() && !(entry.is_wrong() && fails && super::belongs_to_failing(note))
            };
            for note in entry.notes.iter().filter(apart) {
                match note {
                    Note::RestsOn(on) if told.contains(&on.as_slice()) => {}
                    Note::RestsOn(on) => {
                        told.push(on);
                        all.push(self.resting(on));
                    }
                    note => all.extend(self.noted(entry, note)),
                }
            }
        }
        all.sort_by_key(|finding| (finding.page, finding.primary.0.start));
        all
    }

    fn lay_out(&self, finding: &Finding) -> String {
        let document = &self.derivation.pages[finding.page].document;
        // Only the lines that are shown: the renderer reads all it is given, and there may be many findings.
        let spans = finding
            .context
            .iter()
            .map(|c| c.0)
            .chain([finding.primary.0]);
        let whole = spans.reduce(Span::to).unwrap_or_default();
        let full: &str = &document.source;
        let start = full
            .get(..whole.start)
            .and_then(|s| s.rfind('\n'))
            .map_or(0, |at| at + 1);
        let rest = full.get(whole.end..).and_then(|s| s.find('\n'));
        let end = rest.map_or(full.len(), |at| whole.end + at);
        let source = full.get(start..end).unwrap_or_default();
        let line = document.position(start).line;
        let mark = |kind: AnnotationKind, (span, label): &(Span, String)| -> Annotation<'_> {
            let local = Span::new(
                span.start.saturating_sub(start),
                span.end.saturating_sub(start),
            );
            let mark = kind.span(within(source, local));
            match label.is_empty() {
                true => mark,
                false => mark.label(label.clone()),
            }
        };
        let mut snippet = Snippet::source(source)
            .line_start(line)
            .path(document.path.as_str())
            .annotation(mark(AnnotationKind::Primary, &finding.primary));
        for context in &finding.context {
            snippet = snippet.annotation(mark(AnnotationKind::Context, context));
        }
        let title = finding.level.clone().primary_title(finding.title.as_str());
        let mut group = Group::with_title(title.id(finding.code)).element(snippet);
        for (level, text) in &finding.said {
            group = group.element(Element::Message(level.clone().message(text.as_str())));
        }
        Renderer::styled().term_width(100).render(&[group])
    }
}

/// A place that could not be read.
pub(super) fn unreadable(page: usize, span: Span, title: String, help: Option<String>) -> Finding {
    Finding {
        level: Level::ERROR,
        code: "unreadable",
        title,
        page,
        primary: (span, String::new()),
        context: Vec::new(),
        said: help.into_iter().map(|help| (Level::HELP, help)).collect(),
    }
}

/// A span inside the text, on the bounds of characters and not empty where that can be.
fn within(source: &str, span: Span) -> std::ops::Range<usize> {
    let mut start = span.start.min(source.len());
    while !source.is_char_boundary(start) {
        start -= 1;
    }
    let mut end = span.end.clamp(start, source.len());
    while !source.is_char_boundary(end) {
        end += 1;
    }
    start..end
}

/// What to type to see one equation's evidence in full.
pub(super) fn replay(report: &Report<'_>, at: usize) -> Option<(Level<'static>, String)> {
    let level = Level::NOTE.with_name("replay");
    Some((level, report.replay(at)?))
}
