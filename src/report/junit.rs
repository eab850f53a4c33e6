//! JUnit's XML: a suite for each document, a case for each statement.
//!
//! What is given or holds passes, as does what its author crosses out rightly; what fails is a failure, what is undecided
//! is skipped, what could not be read is an error. A remark beside the verdict, such as a stale citation, is a case of its
//! own, so that the step itself still passes.

use std::path::Path;

use crate::audit::{Entry, Note, Verdict};

use super::Report;
use super::codes::Level;
use super::place::relative;
use super::remark::{Remark, Subject};
use crate::notation::escape_by;

/// How many cases of a suite did not pass.
#[derive(Default)]
struct Tally {
    cases: usize,
    failures: usize,
    errors: usize,
    skipped: usize,
}

/// What comes of a case.
enum Result<'a> {
    Pass,
    Skipped(String),
    Failure(&'a Remark),
    Error(&'a Remark),
}

impl Report<'_> {
    /// The document; remarks below a level are no failures, paths are told from `here`.
    pub fn junit(&self, remarks: &[Remark], fail_on: Option<Level>, here: &Path) -> String {
        let mut suites = String::new();
        let mut all = Tally::default();
        for (page, own) in self.derivation.pages.iter().enumerate() {
            let path = relative(&own.document.path, here);
            let mut tally = Tally::default();
            let mut cases = String::new();
            for (name, result) in self.cases(page, remarks, fail_on) {
                cases += &case(&mut tally, &path, &name, &result);
            }
            suites += &format!(
                "  <testsuite name=\"{}\" {}>\n",
                escaped(&path),
                tally.written()
            );
            suites += &cases;
            suites += "  </testsuite>\n";
            all.cases += tally.cases;
            all.failures += tally.failures;
            all.errors += tally.errors;
            all.skipped += tally.skipped;
        }
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"cradle-verify\" {}>\n{suites}</testsuites>\n",
            all.written()
        )
    }

    fn cases<'a>(
        &self,
        page: usize,
        remarks: &'a [Remark],
        fail_on: Option<Level>,
    ) -> Vec<(String, Result<'a>)> {
        let weighed = |remark: &'a Remark| match fail_on {
            _ if remark.known => Result::Skipped(format!("known: {}", remark.title)),
            Some(level) if remark.level >= level && remark.code == "unreadable" => {
                Result::Error(remark)
            }
            Some(level) if remark.level >= level && remark.code == "given-up" => {
                Result::Error(remark)
            }
            Some(level) if remark.level >= level => Result::Failure(remark),
            _ => Result::Skipped(remark.title.clone()),
        };
        let mut cases = Vec::new();
        for remark in remarks.iter().filter(|r| r.page == page) {
            if let Subject::Page(..) = remark.subject {
                cases.push((format!("line {}", remark.place.0.line), weighed(remark)));
            }
        }
        for (at, entry) in self.audit.entries.iter().enumerate() {
            if self.equation(entry.equation).page != page {
                continue;
            }
            let own = remarks.iter().filter(|r| r.subject == Subject::Entry(at));
            let name = self.case_name(entry);
            let (verdict, beside): (Vec<&Remark>, Vec<&Remark>) =
                own.partition(|remark| is_of_verdict(entry, remark.code));
            let result = match verdict.first() {
                Some(remark) => weighed(remark),
                None if entry.verdict == Verdict::Undecided => {
                    Result::Skipped(self.headline(entry))
                }
                None => Result::Pass,
            };
            cases.push((name.clone(), result));
            for remark in beside.into_iter().filter(|r| r.level > Level::Note) {
                cases.push((format!("{name} [{}]", remark.code), weighed(remark)));
            }
        }
        cases
    }

    fn case_name(&self, entry: &Entry) -> String {
        let subject = self.subject(entry);
        subject.trim_end_matches(',').to_owned()
    }
}

/// Whether a remark says what the verdict says.
fn is_of_verdict(entry: &Entry, code: &str) -> bool {
    let broken = |note: &Note| matches!(note, Note::Unreadable(_) | Note::GivenUp);
    match entry.notes.iter().find(|note| broken(note)) {
        Some(note) => note.code() == code,
        None => entry.verdict.word() == code,
    }
}

impl Tally {
    fn written(&self) -> String {
        let Tally {
            cases,
            failures,
            errors,
            skipped,
        } = self;
        format!(
            "tests=\"{cases}\" failures=\"{failures}\" errors=\"{errors}\" skipped=\"{skipped}\""
        )
    }
}

fn case(tally: &mut Tally, suite: &str, name: &str, result: &Result<'_>) -> String {
    tally.cases += 1;
    let head = format!(
        "    <testcase classname=\"{}\" name=\"{}\"",
        escaped(suite),
        escaped(name)
    );
    let (element, remark) = match result {
        Result::Pass => return format!("{head}/>\n"),
        Result::Skipped(message) => {
            tally.skipped += 1;
            let message = escaped(message);
            return format!("{head}>\n      <skipped message=\"{message}\"/>\n    </testcase>\n");
        }
        Result::Failure(remark) => {
            tally.failures += 1;
            ("failure", remark)
        }
        Result::Error(remark) => {
            tally.errors += 1;
            ("error", remark)
        }
    };
    let start = remark.place.0;
    let mut body = format!("{}:{}:{}\n", remark.path, start.line, start.column);
    for (name, said) in &remark.said {
        body += &format!("{name}: {}\n", said.replace('\n', "\n  "));
    }
    format!(
        "{head}>\n      <{element} type=\"{}\" message=\"{}\">{}</{element}>\n    </testcase>\n",
        remark.code,
        escaped(&remark.title),
        escaped(&body)
    )
}

/// Text for an attribute or an element. XML has no way to write most control characters, so they are left out.
fn escaped(text: &str) -> String {
    escape_by(text, |c| match c {
        '\n' => Some('\n'),
        '\t' => Some(' '),
        _ => None,
    })
}
