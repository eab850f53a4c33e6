//! One line for each equation: its number, the verdict, and the one thing to know.

use crate::algebra::{Formula, Relation};
use crate::audit::{Entry, Judged, Note, Outcome, Verdict};
use crate::derivation::Source;
use crate::kernel::Refuted;
use crate::notation::{Mark, latex_statement, plain_statement};
use crate::search::UNDECIDED;
use crate::sorted;

use super::evidence::Point;
use super::style::{self, DIM, paint};
use super::words::shortened;
use super::{Report, numeric, words};

/// The widest that a name may be.
const WIDEST_NAME: usize = 26;
/// The width of a line.
const WIDTH: usize = 100;

impl Report<'_> {
    /// How wide the column of names must be.
    pub(super) fn width_of_names(&self) -> usize {
        let entries = self.audit.entries.iter();
        let widths = entries.map(|e| self.line_name(e).chars().count());
        widths.max().unwrap_or(0).min(WIDEST_NAME)
    }

    fn line_name(&self, entry: &Entry) -> String {
        let name = self.name(entry.equation);
        match self.part_of(entry) {
            None => name,
            Some((part, parts)) => format!("{name} {part}/{parts}"),
        }
    }

    /// A sign and a word for what was found.
    pub(super) fn told(&self, entry: &Entry) -> (&'static str, &'static str) {
        match &entry.numeric {
            Some(_) if entry.is_supported() => ("≈", "supported"),
            Some(_) if unsupported(entry) => ("≉", "not supported"),
            _ => (style::sign(entry.verdict), entry.verdict.word()),
        }
    }

    /// The line of one entry.
    pub fn line(&self, entry: &Entry, names: usize) -> String {
        let name = shortened(&self.line_name(entry), names);
        let (sign, word) = self.told(entry);
        let verdict = format!("{sign} {word:<9}");
        let room = WIDTH.saturating_sub(names + 7 + word.len().max(9));
        let headline = shortened(&self.headline(entry), room);
        let gap = " ".repeat(names.saturating_sub(name.chars().count()));
        let line = format!(
            "  {name}{gap}  {} {headline}",
            paint(style::of(entry, self.is_finding(entry)), &verdict)
        );
        line.trim_end().to_owned() + "\n"
    }

    /// What was understood, on a line of its own.
    pub fn understood(&self, entry: &Entry, names: usize) -> String {
        let text = match self.statement(entry) {
            Some(statement) => latex_statement(statement),
            None => "not read".into(),
        };
        let line = |text: &str| format!("  {:<names$}    {}\n", "", paint(DIM, text));
        let equation = self.equation(entry.equation);
        let locals = equation.locals.iter();
        let sources: Vec<Source> = locals
            .map(|&local| Source::Local(equation.page, local))
            .collect();
        let mut lines = line(&format!("understood: {text}"));
        if !sources.is_empty() {
            lines += &line(&format!("supposed: {}", self.sources(&sources)));
        }
        lines
    }

    /// What there is to know of an entry, in less than a line.
    pub fn headline(&self, entry: &Entry) -> String {
        let mut said: Vec<String> = Vec::new();
        match entry.verdict {
            Verdict::Given => said.extend(self.statement(entry).map(plain_statement)),
            Verdict::Fails => said.push(self.failure(entry)),
            Verdict::Undecided => said.extend(match &entry.numeric {
                Some(numeric) => Some(numeric::headline(numeric)),
                None => undecided(entry),
            }),
            Verdict::Holds if !entry.notes.iter().any(|note| self.is_in_line(entry, note)) => {
                said.push(self.holds_from(entry));
            }
            Verdict::Holds if is_propagated(entry) => {
                said.push(format!("by {}", words::PROPAGATION));
            }
            Verdict::IllDimensioned => {
                said.extend(
                    self.conflict(entry)
                        .map(|conflict| match entry.fails_as_marked() {
                            true => format!("as the author says: {}", self.fault(conflict)),
                            false => self.fault(conflict),
                        }),
                )
            }
            Verdict::Holds => {}
        }
        // The line of a numeric claim says so itself.
        let apart = |note: &&Note| {
            let told = matches!(note, Note::NumericNotSupported) && unsupported(entry);
            self.is_in_line(entry, note) && !told
        };
        let notes = entry.notes.iter().filter(apart);
        said.extend(notes.filter_map(|note| self.aside(entry.equation, note)));
        if said.is_empty() && entry.verdict == Verdict::Undecided {
            return UNDECIDED.into();
        }
        said.join("; ")
    }

    fn failure(&self, entry: &Entry) -> String {
        let evidence = match (entry.refuted(), entry.rescaled()) {
            (Some((judged, refuted)), _) => self.in_numbers(judged, refuted),
            (None, Some((judged, refuted, _))) => self.in_situations(judged, refuted),
            (None, None) => return "refuted".into(),
        };
        match entry.fails_as_marked() {
            true => format!("as the author says: {evidence}"),
            false => evidence,
        }
    }

    /// `2 ≤ 1 is false at k = 2, n = 1`.
    pub(super) fn in_numbers(&self, judged: &Judged, refuted: &Refuted) -> String {
        if judged.is_expanded() {
            return "the two sides have different series".to_owned();
        }
        let point = Point::new(refuted.claim(), refuted.witness());
        let formula = &judged.goal.formula;
        let values = point.values_of(formula);
        let at = match values.is_empty() {
            true => String::new(),
            false => format!(" at {values}"),
        };
        match point.sides_judged(judged) {
            Some((left, right)) => match (formula, left.expr(), right.expr()) {
                (Formula::Relation { relation, .. }, Some(left), Some(right))
                    if *relation != Relation::Equal =>
                {
                    let there = Formula::Relation {
                        left,
                        relation: *relation,
                        right,
                    };
                    format!("{} is false{at}", crate::notation::plain_formula(&there))
                }
                _ => format!("left {left}, right {right}{at}"),
            },
            None => format!("`{}` is false{at}", crate::notation::plain_formula(formula)),
        }
    }

    fn holds_from(&self, entry: &Entry) -> String {
        if entry
            .judged
            .iter()
            .all(|j| matches!(j.outcome, Outcome::Defined))
        {
            return "a definition".into();
        }
        let mut used: Vec<Source> = entry
            .judged
            .iter()
            .flat_map(|j| j.assumed.iter().map(|a| a.source))
            .filter(|s| !s.is_of_statement())
            .collect();
        sorted::sort_by_key(&mut used, |s| !matches!(s, Source::Equation(_)));
        used.dedup();
        let mut shown: Vec<String> = Vec::new();
        for source in used {
            let text = match source {
                Source::Local(page, at) => {
                    let formulas = &self.derivation.local(page, at).formulas;
                    let said: Vec<String> = formulas
                        .iter()
                        .map(|formula| crate::notation::plain_formula(formula))
                        .collect();
                    format!("`{}`", said.join(", "))
                }
                source => self.source(&source),
            };
            if !shown.contains(&text) {
                shown.push(text);
            }
        }
        if is_propagated(entry) {
            shown.push(words::PROPAGATION.into());
        }
        let equation = |j: &Judged| matches!(&j.goal.formula, Formula::Relation { relation, .. } if *relation == Relation::Equal);
        match shown.is_empty() {
            true if entry.judged.iter().any(Judged::is_expanded) => {
                "up to the order that is printed".into()
            }
            true if entry.judged.iter().all(equation) => "an identity".into(),
            true => "by algebra alone".into(),
            false => format!("from {}{}", words::list(shown), self.found_where(entry)),
        }
    }

    /// The values and cases that the derivation of an equation used.
    fn values_of(&self, at: usize) -> Vec<Source> {
        let entries = self.audit.of_equation(at).iter();
        let used = entries
            .flat_map(|entry| &entry.judged)
            .flat_map(|judged| &judged.assumed);
        let mut values: Vec<Source> = used
            .map(|assumed| assumed.source)
            .filter(|source| match *source {
                Source::Local(page, local) => {
                    let local = self.derivation.local(page, local);
                    local.is_let || local.is_case()
                }
                _ => false,
            })
            .collect();
        values.sort_unstable();
        values.dedup();
        values
    }

    /// Of what moments premises were derived that are used elsewhere: they may hold there alone.
    fn found_where(&self, entry: &Entry) -> String {
        let own = self.equation(entry.equation);
        let is_left = |source: &Source| match *source {
            Source::Local(page, local) => {
                self.derivation.local(page, local).is_momentary() && !own.is_under(page, local)
            }
            Source::Equation(at) => {
                let put = self.equation(at);
                !put.moments.is_empty() && !put.moments.clone().any(|at| own.is_under(put.page, at))
            }
            Source::Step | Source::Taken | Source::Propagation | Source::Nature => false,
        };
        let premises = entry
            .premises
            .iter()
            .flat_map(|&at| self.audit.of_equation(at));
        let used = premises
            .flat_map(|premise| &premise.judged)
            .flat_map(|judged| &judged.assumed);
        let mut left: Vec<Source> = used.map(|a| a.source).filter(is_left).collect();
        left.sort_unstable();
        left.dedup();
        match left.is_empty() {
            true => String::new(),
            false => format!(", found at the moment of {}", self.sources(&left)),
        }
    }

    /// What a step follows from in the place of what it cites.
    fn exchanged(&self, cited: &[usize], instead: &[Source]) -> String {
        let (added, dropped) = exchange(cited, instead);
        match (added.is_empty(), dropped.is_empty()) {
            (true, _) => format!("follows from {}", self.sources(instead)),
            (false, true) => format!("follows from {}, not cited", self.sources(&added)),
            (false, false) => format!(
                "follows from {}, not {}",
                self.sources(&added),
                self.references(&dropped)
            ),
        }
    }

    /// `rests on (2), which holds if R ≠ 0, and on (3), not proved`.
    fn resting_unproved(&self, open: &[usize]) -> String {
        let conditions = |at: usize| -> Vec<String> {
            let entries = self.audit.of_equation(at);
            if entries.iter().any(|e| e.verdict != Verdict::Holds) {
                return Vec::new();
            }
            let notes = entries.iter().flat_map(|entry| &entry.notes);
            let told = notes.filter_map(|note| match note {
                Note::UnstatedCondition(all) => Some(all),
                _ => None,
            });
            let mut all: Vec<String> = told.flatten().map(crate::notation::plain_formula).collect();
            all.dedup();
            all
        };
        // What holds under the same conditions is told of together.
        let mut alike: Vec<(String, Vec<usize>)> = Vec::new();
        let mut unproved: Vec<usize> = Vec::new();
        for &at in open {
            let told = conditions(at);
            if told.is_empty() {
                unproved.push(at);
                continue;
            }
            let told = words::list(told);
            match alike.iter_mut().find(|(own, _)| *own == told) {
                Some((_, all)) => all.push(at),
                None => alike.push((told, vec![at])),
            }
        }
        let clause = |(told, all): &(String, Vec<usize>)| {
            let holds = if all.len() == 1 { "holds" } else { "hold" };
            format!("{}, which {holds} if {told}", self.references(all))
        };
        let mut said: Vec<String> = alike.iter().map(clause).collect();
        if !unproved.is_empty() {
            said.push(format!("{}, not proved", self.references(&unproved)));
        }
        format!("rests on {}", said.join(", and on "))
    }

    /// A note as a clause.
    pub(super) fn aside(&self, own: usize, note: &Note) -> Option<String> {
        Some(match note {
            Note::RestsOn(failing) => format!("rests on {}", self.references(failing)),
            Note::RestsOnUnproved(open) => self.resting_unproved(open),
            Note::Miscited { cited, instead } => {
                format!("miscited: {}", self.exchanged(cited, instead))
            }
            Note::CitationsShifted {
                by, cited, instead, ..
            } => format!(
                "cites numbers {} too {}: {}",
                by.abs(),
                if *by > 0 { "small" } else { "large" },
                self.exchanged(cited, instead)
            ),
            Note::UnusedPremise(unused) => {
                format!("cites {} to no use", self.references(unused))
            }
            Note::TakenAsConstant(symbols) => {
                let shown = symbols.iter().map(words::symbol).collect();
                format!("{} taken as constant", words::list(shown))
            }
            Note::TakenAsGiven(symbols) => {
                let equation = self.equation(own);
                let taken = match equation.drawn {
                    true if !equation.defines.is_empty() => "taken for a definition, not checked",
                    true => "taken as given, not checked",
                    false => "taken as given",
                };
                // Of what goes on with what follows the beginning is meant.
                let holds = |e: &Entry| e.verdict == Verdict::Holds;
                let of_chain = self.audit.of_equation(own).iter().all(holds);
                let taken = format!("{}{taken}", if of_chain { "its first step " } else { "" });
                let held = |symbol| self.derivation.is_some_constant(symbol);
                let new = |symbol| equation.introduces.contains(symbol);
                let shown = || words::list(symbols.iter().map(words::symbol).collect());
                match () {
                    () if !symbols.is_empty() && symbols.iter().all(new) => {
                        format!("{taken}: nothing before speaks of {}", shown())
                    }
                    () if !symbols.is_empty() => {
                        format!("{taken}: nothing before gives the value of {}", shown())
                    }
                    () if equation.symbols().iter().any(held) => {
                        format!("{taken}: nothing before shows that it does not change")
                    }
                    () => format!("{taken}: it follows from nothing before"),
                }
            }
            Note::NumericNotSupported => {
                "not supported: false for all figures within their bounds".into()
            }
            Note::OtherReading(other) => self.read_otherwise(own, other),
            Note::GivenUp => "the search broke down: please report this".into(),
            Note::Uncited(sources) => format!("from {}, uncited", self.sources(sources)),
            Note::UnstatedCondition(conditions) => format!(
                "if {}, which is not stated",
                words::list(
                    conditions
                        .iter()
                        .map(crate::notation::plain_formula)
                        .collect()
                )
            ),
            Note::InconsistentPremises(sources) if sources.is_empty() => {
                "true for no values that its symbols may have".into()
            }
            Note::InconsistentPremises(sources) => {
                format!("contradicts {}", self.sources(sources))
            }
            Note::WrongMark(Mark::Tick) => "the author's ✓ is wrong".into(),
            Note::WrongMark(Mark::Cross) => "the author's ✗ is wrong".into(),
            Note::UnknownCitation(label, _) => format!("cites {label}, which is not there"),
            Note::CitesLater(at) => {
                format!("cites {}, which comes later", self.reference(*at))
            }
            Note::OutOfScope(at) => {
                let values = self.values_of(*at);
                let values = match values.is_empty() {
                    true => "particular values".into(),
                    false => self.sources(&values),
                };
                format!("cites {}, derived for {values}", self.reference(*at))
            }
            Note::DuplicateTag(at) => {
                format!("has the number of the equation at {}", self.place(*at))
            }
            Note::Unreadable(error) => format!("could not be read: {}", error.message),
            Note::UnreadablePremise(unread) => {
                format!("{} could not be read", self.references(unread))
            }
        })
    }
}

/// A numeric claim that the figures contradict.
fn unsupported(entry: &Entry) -> bool {
    let noted = |note: &Note| matches!(note, Note::NumericNotSupported);
    entry.verdict == Verdict::Undecided && entry.notes.iter().any(noted)
}

fn undecided(entry: &Entry) -> Option<String> {
    entry
        .judged
        .iter()
        .find_map(|judged| match &judged.outcome {
            Outcome::Open(stop) if !stop.reason.is_empty() => Some(stop.reason.clone()),
            _ => None,
        })
}

/// What should be cited and is not, and what is cited to no use.
pub(super) fn exchange(cited: &[usize], instead: &[Source]) -> (Vec<Source>, Vec<usize>) {
    let is_cited = |s: &&Source| matches!(s, Source::Equation(at) if cited.contains(at));
    let equation = |s: &&Source| matches!(s, Source::Equation(_));
    let added = instead.iter().filter(equation).filter(|s| !is_cited(s));
    let unused = |at: &&usize| !instead.contains(&Source::Equation(**at));
    (
        added.copied().collect(),
        cited.iter().filter(unused).copied().collect(),
    )
}

/// Whether something of an entry was judged from the law of propagation.
fn is_propagated(entry: &Entry) -> bool {
    entry.judged.iter().any(Judged::is_propagated)
}
