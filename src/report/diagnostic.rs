//! Findings in the author's own text: what is wrong, the exact evidence, the nearest repair.

mod differing;
mod dimensions;
mod fails;
mod notes;
mod shared;

use annotate_snippets::{AnnotationKind, Element, Group, Level, Origin, Renderer, Snippet};

use crate::audit::{Entry, Note, Verdict};
use crate::document::{File, Span};
use crate::notation::plain_statement;

use super::remark::{Known, Subject};
use super::{Report, codes};

pub(super) use shared::Shared;

/// So much of a line is given to the renderer on either side of what is marked; it shows less.
const MOST_BESIDE: usize = 512;

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

/// One finding as it is shown.
pub(super) struct LaidOut {
    /// Its page and where it stands there: findings are shown in this order.
    pub place: (usize, usize),
    pub text: String,
}

impl Finding {
    /// What is said besides, names and texts, without layout.
    pub(super) fn said_plainly(&self) -> Vec<(String, String)> {
        let plain = |(level, text): &(Level<'static>, String)| (name_of(level), text.clone());
        self.said.iter().map(plain).collect()
    }
}

impl Report<'_> {
    /// What is found elsewhere than in equations, but for what is known.
    pub(super) fn told_elsewhere(&self, known: &Known) -> Vec<LaidOut> {
        let is_new =
            |(subject, finding): &(Subject, Finding)| !known.contains(&(*subject, finding.code));
        let elsewhere = self.elsewhere().into_iter().filter(is_new);
        let grave = elsewhere.filter(|(_, finding)| self.is_grave(finding));
        grave.map(|(_, finding)| self.laid_out(&finding)).collect()
    }

    /// What is found in an entry, but for what is known, and what it is the first to share with others.
    pub(super) fn told_of_entry(
        &self,
        at: usize,
        shared: &[Shared],
        known: &Known,
    ) -> Vec<LaidOut> {
        let is_new = |finding: &Finding| !known.contains(&(Subject::Entry(at), finding.code));
        let shared = shared.iter().map(|&own| self.leveled(self.sharing(own)));
        let own = self.of_entry(&self.audit.entries[at]).into_iter();
        let all = shared.chain(own.filter(is_new));
        all.map(|finding| self.laid_out(&finding)).collect()
    }

    /// What there is to remark besides equations: what could not be read, suppositions that differ in dimension, and
    /// what is declared otherwise beside the document.
    pub(super) fn elsewhere(&self) -> Vec<(Subject, Finding)> {
        let mut all = Vec::new();
        for (number, page) in self.derivation.pages.iter().enumerate() {
            for clash in &page.clashes {
                let finding = self.clashing(number, clash);
                all.push((Subject::Page(number, clash.own.start), finding));
            }
            for problem in &page.problems {
                let (message, help) = (problem.message.clone(), problem.help.clone());
                let finding = unreadable(number, problem.span, message, help);
                all.push((Subject::Page(number, problem.span.start), finding));
            }
        }
        for (&(page, at), conflict) in self.audit.dimensions.suppositions.iter() {
            let finding = self.ill_supposed(page, at, conflict);
            all.push((Subject::Page(page, finding.primary.0.start), finding));
        }
        all.retain(|(_, finding)| self.level(finding.page, finding.code).is_some());
        for (_, finding) in &mut all {
            self.level_out(finding);
        }
        all
    }

    /// Whether a finding is to be mended, rather than to be known.
    pub(super) fn is_grave(&self, finding: &Finding) -> bool {
        self.level(finding.page, finding.code) > Some(codes::Level::Note)
    }

    /// Gives a finding the level that its code has on its page.
    fn level_out(&self, finding: &mut Finding) {
        finding.level = match self.level(finding.page, finding.code) {
            Some(codes::Level::Error) => Level::ERROR,
            Some(codes::Level::Warning) => Level::WARNING,
            Some(codes::Level::Note) | None => Level::NOTE,
        };
    }

    pub(super) fn leveled(&self, mut finding: Finding) -> Finding {
        self.level_out(&mut finding);
        finding
    }

    /// What is to be mended about an entry, but for what it shares with others, which is told once.
    pub(super) fn of_entry(&self, entry: &Entry) -> Vec<Finding> {
        let mut all = self.remarked(entry, codes::Level::Warning);
        all.retain(|finding| !Shared::is_code(finding.code));
        all
    }

    /// Each remark on an entry, from a level on.
    pub(super) fn remarked(&self, entry: &Entry, least: codes::Level) -> Vec<Finding> {
        let mut all = Vec::new();
        if self.level_of_verdict(entry) >= Some(least) {
            match entry.verdict {
                Verdict::Fails => all.extend(self.failing(entry)),
                Verdict::IllDimensioned => all.extend(self.ill_dimensioned(entry)),
                _ => {}
            }
        }
        let told = |note: &&Note| self.level_of_note(entry, note) >= Some(least);
        for note in entry.notes.iter().filter(told) {
            all.extend(self.noted(entry, note));
        }
        for note in entry.notes.iter().filter(told) {
            all.extend(self.told_shortly(entry, note));
        }
        if entry.verdict == Verdict::Undecided && self.level_of_verdict(entry) >= Some(least) {
            all.push(self.left_open(entry));
        }
        if all.is_empty() {
            return all;
        }
        let understood = self.statement(entry).map(plain_statement);
        let understood = understood.map(|own| (Level::NOTE.with_name("understood"), own));
        for finding in &mut all {
            self.level_out(finding);
            finding.said.splice(0..0, understood.clone());
        }
        all
    }

    fn laid_out(&self, finding: &Finding) -> LaidOut {
        LaidOut {
            place: (finding.page, finding.primary.0.start),
            text: self.lay_out(finding) + "\n\n",
        }
    }

    fn lay_out(&self, finding: &Finding) -> String {
        let document = &self.derivation.pages[finding.page].document;
        let (own, primary) = document.written_at(finding.primary.0);
        let mut marks = vec![(AnnotationKind::Primary, primary, finding.primary.1.as_str())];
        // What is pointed at in another file stands below, in that file.
        let mut elsewhere: Vec<(&File, Span, &str)> = Vec::new();
        for (span, label) in &finding.context {
            match document.written_at(*span) {
                (file, span) if file.path == own.path => {
                    marks.push((AnnotationKind::Context, span, label));
                }
                (file, span) => elsewhere.push((file, span, label)),
            }
        }
        let title = finding.level.clone().primary_title(finding.title.as_str());
        let titled = Group::with_title(title.id(finding.code));
        let mut group = with_snippet(titled, own, &marks);
        for (file, span, label) in elsewhere {
            group = with_snippet(group, file, &[(AnnotationKind::Context, span, label)]);
        }
        for (level, text) in &finding.said {
            group = group.element(Element::Message(level.clone().message(text.as_str())));
        }
        Renderer::styled().term_width(100).render(&[group])
    }
}

/// A group with a part of a file in it, with marks.
pub(super) fn with_snippet<'a>(
    mut group: Group<'a>,
    file: &'a File,
    marks: &[(AnnotationKind, Span, &str)],
) -> Group<'a> {
    // Only what is shown: the renderer reads all it is given, there may be many findings, and lines may be long.
    let whole = marks.iter().map(|mark| mark.1).reduce(Span::to);
    let whole = whole.unwrap_or_default();
    let full: &str = &file.source;
    let far = |at: usize| within(full, Span::new(at, at)).start;
    let (from, to) = (
        far(whole.start.saturating_sub(MOST_BESIDE)),
        far(whole.end + MOST_BESIDE),
    );
    let before = full.get(from..whole.start).and_then(|s| s.rfind('\n'));
    let is_whole = before.is_some() || from == 0;
    let start = before.map_or(from, |at| from + at + 1);
    let after = full.get(whole.end..to).and_then(|s| s.find('\n'));
    let end = after.map_or(to, |at| whole.end + at);
    let source = full.get(start..end).unwrap_or_default();
    let first = file.position(start);
    let mut snippet = Snippet::source(source).line_start(first.line);
    if is_whole {
        snippet = snippet.path(file.path.as_str());
    } else {
        // The renderer counts columns from where its text begins.
        let place = file.position(marks.first().map_or(start, |mark| mark.1.start));
        let origin = Origin::path(file.path.as_str()).line(place.line);
        group = group.element(origin.char_column(place.column));
    }
    for (kind, span, label) in marks {
        let local = Span::new(
            span.start.saturating_sub(start),
            span.end.saturating_sub(start),
        );
        let mark = kind.span(within(source, local));
        snippet = snippet.annotation(match label.is_empty() {
            true => mark,
            false => mark.label((*label).to_owned()),
        });
    }
    group.element(snippet)
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

/// The name that a level is printed with, which the renderer alone knows.
fn name_of(level: &Level<'static>) -> String {
    let group = Group::with_title(level.clone().secondary_title("|"));
    let shown = Renderer::plain().render(&[group]);
    shown.trim().trim_end_matches(": |").to_owned()
}

/// What to type to see one equation's evidence in full.
pub(super) fn replay(report: &Report<'_>, at: usize) -> (Level<'static>, String) {
    let level = Level::NOTE.with_name("replay");
    (level, report.replay(at))
}
