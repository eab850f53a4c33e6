//! What was found once, written down, and how what is found now differs from it.
//!
//! A baseline has a line for each statement with its verdict and the codes of what is remarked on it. Which statement of
//! today is which line is found by `matching`.

mod matching;

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::Report;
use super::codes::Level;
use super::fingerprint::fingerprint;
use super::place::relative;
use super::remark::{Known, Subject};
use super::words::count;

/// The version of the layout. In the first the number of a statement was part of its fingerprint, and there were no labels.
const VERSION: u32 = 2;

/// A baseline.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Baseline {
    version: u32,
    statements: Vec<Line>,
}

/// What is recorded of a statement, or of a place that could not be read.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    path: String,
    /// The number or name; empty where there is none.
    equation: String,
    /// The name that the author gave it: of a claim, or its first key. Numbers change where something is put in before them,
    /// names do not. Empty where there is none.
    #[serde(skip_serializing_if = "String::is_empty", default)]
    label: String,
    /// Absent for what is no equation.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    verdict: Option<String>,
    codes: Vec<String>,
    fingerprint: String,
    statement: String,
}

/// A statement that is not as it was.
#[derive(Clone, Debug, Serialize)]
pub struct Difference {
    /// The path of its page.
    pub path: String,
    /// Its number or name; empty where there is none.
    pub equation: String,
    /// What it states.
    pub statement: String,
    /// How it differs.
    #[serde(flatten)]
    pub change: Change,
    /// How grave what is new about it is.
    #[serde(skip)]
    pub level: Option<Level>,
}

/// How a statement differs from what is recorded.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "change", rename_all = "kebab-case")]
pub enum Change {
    /// These are remarked now and were not.
    New {
        /// Their codes.
        codes: Vec<String>,
    },
    /// These were remarked and are no more.
    Gone {
        /// Their codes.
        codes: Vec<String>,
    },
    /// The verdict is another.
    Verdict {
        /// What it was.
        was: String,
        /// What it is.
        is: String,
    },
    /// It has another text under the same name or number.
    Edited,
    /// The statement was not there.
    Added,
    /// The statement is not there any more.
    Removed,
}

/// A baseline held against what is found now.
#[derive(Clone, Debug, Serialize)]
pub struct Comparison {
    /// How many findings the baseline knows.
    pub known: usize,
    /// What is not as recorded, in the order of the baseline.
    pub differences: Vec<Difference>,
    /// Which remarks are known.
    #[serde(skip)]
    pub remarks: Known,
}

impl Report<'_> {
    /// What there is to record; paths are told from `here`.
    pub fn baseline(&self, here: &Path) -> Baseline {
        let mut lines: Vec<Line> = self.lines_now(here).into_iter().map(|(_, l)| l).collect();
        lines.sort_by_cached_key(Line::order);
        Baseline {
            version: VERSION,
            statements: lines,
        }
    }

    /// How many statements a baseline of this records, and how many findings.
    pub fn size_of_baseline(&self, here: &Path) -> String {
        let lines = self.lines_now(here);
        let remarks = lines.iter().flat_map(|(remarks, _)| remarks);
        let level = |(subject, code): &(Subject, &str)| self.level(self.page_of(*subject), code);
        let findings = remarks.filter(|remark| level(remark) > Some(Level::Note));
        let statements = count(lines.len(), "statement");
        format!("{statements}, {}", count(findings.count(), "finding"))
    }

    fn lines_now(&self, here: &Path) -> Vec<(Vec<(Subject, &'static str)>, Line)> {
        let mut lines = Vec::new();
        for remark in self.remarks(here, &Known::new()) {
            if let Subject::Page(..) = remark.subject {
                let line = Line {
                    path: remark.path,
                    equation: String::new(),
                    label: String::new(),
                    verdict: None,
                    codes: vec![remark.code.to_owned()],
                    fingerprint: remark.fingerprint,
                    statement: remark.title,
                };
                lines.push((vec![(remark.subject, remark.code)], line));
            }
        }
        for (at, entry) in self.audit.entries.iter().enumerate() {
            let statement = self.content(at);
            let page = self.equation(entry.equation).page;
            let codes = self.codes(entry);
            let line = Line {
                path: relative(&self.derivation.pages[page].document.path, here),
                equation: self.key(at),
                label: self.given_name(at),
                verdict: Some(entry.verdict.word().to_owned()),
                codes: codes.iter().map(|code| (*code).to_owned()).collect(),
                fingerprint: fingerprint(&[&statement]),
                statement,
            };
            let subject = Subject::Entry(at);
            lines.push((codes.into_iter().map(|c| (subject, c)).collect(), line));
        }
        lines
    }

    /// How what is found differs from a baseline.
    pub fn compared(&self, with: &Baseline, here: &Path) -> Comparison {
        let (remarks, lines): (Vec<_>, Vec<_>) = self.lines_now(here).into_iter().unzip();
        let partners = matching::partners(&lines, &with.statements);
        let mut left = vec![true; with.statements.len()];
        let mut comparison = Comparison {
            known: 0,
            differences: Vec::new(),
            remarks: Known::new(),
        };
        let mut changed: Vec<(Line, Change, Option<Level>)> = Vec::new();
        for ((remarks, now), partner) in remarks.into_iter().zip(lines).zip(partners) {
            let was = partner.map(|at| {
                left[at] = false;
                &with.statements[at]
            });
            let before = was.map_or(&[][..], |was| &was.codes);
            let new = without(&now.codes, before);
            let mut gravest = None;
            for &(subject, code) in &remarks {
                let level = self.level(self.page_of(subject), code);
                if !new.iter().any(|own| own == code) {
                    comparison.remarks.insert((subject, code));
                    comparison.known += usize::from(level > Some(Level::Note));
                } else {
                    gravest = gravest.max(level);
                }
            }
            let gone = without(before, &now.codes);
            if let Some(was) = was {
                let change = was.change_to(&now);
                changed.extend(change.map(|change| (now.clone(), change, None)));
            }
            if !new.is_empty() {
                changed.push((now.clone(), Change::New { codes: new }, gravest));
            } else if was.is_none() {
                changed.push((now.clone(), Change::Added, None));
            }
            if !gone.is_empty() {
                changed.push((now, Change::Gone { codes: gone }, None));
            }
        }
        let recorded = with.statements.iter().zip(left);
        for (line, _) in recorded.filter(|(_, left)| *left) {
            let change = match line.codes.is_empty() {
                true => Change::Removed,
                false => Change::Gone {
                    codes: line.codes.clone(),
                },
            };
            changed.push((line.clone(), change, None));
        }
        changed.sort_by_cached_key(|(line, change, _)| {
            let (path, before, number, after, fingerprint) = line.order();
            (path, before, number, after, change.rank(), fingerprint)
        });
        let differences = changed.into_iter().map(|(line, change, level)| Difference {
            path: line.path,
            equation: line.equation,
            statement: line.statement,
            change,
            level,
        });
        comparison.differences = differences.collect();
        comparison
    }
}

/// What is in the first list and not in the second; what is there twice must be so in both.
fn without(all: &[String], known: &[String]) -> Vec<String> {
    let mut known: Vec<&String> = known.iter().collect();
    let mut left = all.to_vec();
    left.retain(|code| match known.iter().position(|own| *own == code) {
        Some(at) => {
            known.swap_remove(at);
            false
        }
        None => true,
    });
    left
}

impl Line {
    /// What became of a statement itself, whatever is remarked on it. The verdict on another text is no change of verdict.
    fn change_to(&self, now: &Line) -> Option<Change> {
        let (was, is) = (self.verdict.clone()?, now.verdict.clone()?);
        match self.fingerprint == now.fingerprint {
            true => (was != is).then_some(Change::Verdict { was, is }),
            false => Some(Change::Edited),
        }
    }

    /// Whether it is about a statement, and not about a place that could not be read.
    fn is_statement(&self) -> bool {
        self.verdict.is_some()
    }

    /// By page, then by number: (9) before (10).
    fn order(&self) -> (String, String, u64, String, String) {
        let digit = |c: char| c.is_ascii_digit();
        let label = &self.equation;
        let start = label.find(digit).unwrap_or(label.len());
        let (before, rest) = label.split_at(start);
        let end = rest.find(|c| !digit(c)).unwrap_or(rest.len());
        let (number, after) = rest.split_at(end);
        (
            self.path.clone(),
            before.to_owned(),
            number.parse().unwrap_or(u64::MAX),
            after.to_owned(),
            self.fingerprint.clone(),
        )
    }
}

impl Baseline {
    /// The file: JSON, a statement on each line.
    pub fn written(&self) -> String {
        let lines = self.statements.iter();
        let lines = lines.filter_map(|line| serde_json::to_string(line).ok());
        let lines: Vec<String> = lines.map(|line| format!("    {line}")).collect();
        let version = self.version;
        match lines.is_empty() {
            true => format!("{{\n  \"version\": {version},\n  \"statements\": []\n}}\n"),
            false => format!(
                "{{\n  \"version\": {version},\n  \"statements\": [\n{}\n  ]\n}}\n",
                lines.join(",\n")
            ),
        }
    }

    /// Whether a file may be written anew: it is blank, or a baseline, be it of another version or with mistakes in it.
    pub fn may_replace(text: &str) -> bool {
        let is_one =
            |own: serde_json::Value| own["version"].is_u64() && own["statements"].is_array();
        text.trim().is_empty() || serde_json::from_str(text).is_ok_and(is_one)
    }

    /// Reads a file.
    ///
    /// # Errors
    /// It is no baseline, or one of another version; in a clause.
    pub fn read(text: &str) -> Result<Baseline, String> {
        let version = serde_json::from_str::<serde_json::Value>(text)
            .map_err(|error| format!("is no JSON: {error}"))?;
        match version.get("version").and_then(serde_json::Value::as_u64) {
            Some(version) if (1..=u64::from(VERSION)).contains(&version) => {}
            Some(version) => return Err(format!("has the version {version}, not {VERSION}")),
            None => return Err("is no baseline: it has no `version`".into()),
        }
        let baseline: Baseline =
            serde_json::from_str(text).map_err(|error| format!("is no baseline: {error}"))?;
        Ok(baseline.brought_up_to_date())
    }

    /// As this version would have written it: the first counted the number of a statement as part of what it says.
    fn brought_up_to_date(mut self) -> Baseline {
        if self.version == 1 {
            let statements = self
                .statements
                .iter_mut()
                .filter(|line| line.is_statement());
            for line in statements {
                line.fingerprint = fingerprint(&[&line.statement]);
            }
            self.version = VERSION;
        }
        self
    }
}

impl Difference {
    /// Whether it makes a run fail at a level. What was proved and is not any more is as grave as an error.
    pub fn fails(&self, fail_on: Option<Level>) -> bool {
        match (&self.change, fail_on) {
            (Change::New { .. }, Some(level)) => self.level >= Some(level),
            (Change::Verdict { was, is }, Some(_)) => was == "holds" && is == "undecided",
            _ => false,
        }
    }
}

impl Change {
    /// What was there is told before what is.
    fn rank(&self) -> usize {
        match self {
            Change::Removed => 0,
            Change::Gone { .. } => 1,
            Change::Verdict { .. } => 2,
            Change::Edited => 3,
            Change::New { .. } => 4,
            Change::Added => 5,
        }
    }

    /// Whether it is told where the comparison is not strict: a statement more or less, or in other words, is then nobody's concern.
    pub fn concerns(&self) -> bool {
        !matches!(self, Change::Added | Change::Removed | Change::Edited)
    }
}

impl Comparison {
    /// The comparison in words, a line for each difference.
    pub fn told(&self, strict: bool) -> String {
        let told = self.differences.iter();
        let told = told.filter(|difference| strict || difference.change.concerns());
        let mut text = String::new();
        for difference in told.clone() {
            let (word, what) = match &difference.change {
                Change::New { codes } => ("new", codes.join(", ")),
                Change::Gone { codes } => ("gone", codes.join(", ")),
                Change::Verdict { was, is } => ("changed", format!("{was} → {is}")),
                Change::Edited => ("edited", String::new()),
                Change::Added => ("added", String::new()),
                Change::Removed => ("removed", String::new()),
            };
            let subject = match difference.equation.is_empty() {
                true => super::words::shortened(&difference.statement, 40),
                false => difference.equation.clone(),
            };
            let subject = super::place::one_line(&subject);
            let path = super::place::one_line(&difference.path);
            let parts = [subject, what, path];
            let parts: Vec<String> = parts.into_iter().filter(|p| !p.is_empty()).collect();
            text += &format!("  {word:<7}  {}", parts.join("  "));
            text.push('\n');
        }
        let known = count(self.known, "known finding");
        let number = told.count();
        let closing = match number {
            0 => "nothing else has changed".to_owned(),
            _ => count(number, "difference"),
        };
        text + &format!("{known}; {closing}.\n")
    }
}
