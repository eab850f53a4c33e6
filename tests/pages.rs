//! Pages of right and wrong physics. Dropping a page into `tests/pages/` adds a test.
//!
//! Above each display stands a comment with what must be found, statement by statement:
//!
//! ```markdown
//! <!-- expect: holds -->
//! <!-- expect: fails, unstated-condition -->
//! <!-- expect: holds | fails -->
//! ```
//!
//! first the verdict, then the code of every note, and `supported` where its figures support it. A comment anywhere on the page expects a problem of
//! reading:
//!
//! ```markdown
//! <!-- expect-problem: a part of the message -->
//! ```
//!
//! A right page lists slips of the pen in the display that follows. Each is made by itself, and must be
//! caught where it is made and nowhere else:
//!
//! ```markdown
//! <!-- slip: 2 a s becomes 3 a s -->
//! ```
//!
//! (`slip-spreads:` where the engine still lets a step that cites the wrong one fail with it.)
//!
//! In `tests/pages/not-yet/` some displays bear the right answer that the engine does not give so far. Once
//! it does, the page moves up:
//!
//! ```markdown
//! <!-- not-yet: holds -->
//! ```

use std::collections::BTreeSet;
use std::fmt;
use std::path::{Path, PathBuf};

use cradle_verify::audit::{Audit, Entry, Verdict};
use cradle_verify::derivation::Derivation;

/// What an answer says of a statement that its figures support.
const SUPPORTED: &str = "supported";

/// A page with what it asks for.
struct Page {
    path: String,
    source: String,
    derivation: Derivation,
}

/// A comment of ours, and the line it stands on.
struct Comment<'a> {
    line: usize,
    text: &'a str,
}

/// Verdict and note codes, a statement each.
#[derive(PartialEq, Eq)]
struct Answer(Vec<(String, BTreeSet<String>)>);

impl Answer {
    fn read(text: &str) -> Answer {
        let statement = |text: &str| {
            let mut words = text.split(',').map(|word| word.trim().to_owned());
            (words.next().unwrap_or_default(), words.collect())
        };
        Answer(text.split('|').map(statement).collect())
    }

    fn found(audit: &Audit, rows: std::ops::Range<usize>) -> Answer {
        let entries = rows.flat_map(|at| audit.of_equation(at));
        let entries = entries.map(|entry| {
            let notes = entry.notes.iter().map(|note| note.code().to_owned());
            let supported = entry.numeric.iter().filter(|own| own.is_supported());
            let supported = supported.map(|_| SUPPORTED.to_owned());
            (
                entry.verdict.word().to_owned(),
                notes.chain(supported).collect(),
            )
        });
        Answer(entries.collect())
    }

    /// The verdicts that are none, and the notes that do not exist.
    fn misspelt(&self) -> Vec<&str> {
        const NOTES: [&str; 19] = [
            "citations-shifted",
            "unused-premise",
            "numeric-not-supported",
            "rests-on",
            "rests-on-unproved",
            "miscited",
            "uncited",
            "unstated-condition",
            "inconsistent-premises",
            "wrong-mark",
            "unknown-citation",
            "cites-later",
            "out-of-scope",
            "duplicate-tag",
            "unreadable",
            "unreadable-premise",
            "other-reading",
            "taken-as-given",
            "taken-as-constant",
        ];
        let verdict = |word: &str| Verdict::ALL.iter().any(|v| v.word() == word);
        let mut wrong = Vec::new();
        for (word, notes) in &self.0 {
            wrong.extend(Some(word.as_str()).filter(|word| !verdict(word)));
            let notes = notes.iter().map(String::as_str);
            wrong.extend(notes.filter(|note| !NOTES.contains(note) && *note != SUPPORTED));
        }
        wrong
    }
}

impl fmt::Display for Answer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let statements = self.0.iter().map(|(verdict, notes)| {
            let mut words = vec![verdict.as_str()];
            words.extend(notes.iter().map(String::as_str));
            words.join(", ")
        });
        f.write_str(&statements.collect::<Vec<_>>().join(" | "))
    }
}

impl Page {
    fn read(path: &Path) -> Page {
        let source = std::fs::read_to_string(path).expect("a page is UTF-8");
        let path = path.display().to_string();
        Page {
            derivation: Derivation::from_markdown(&path, &source),
            path,
            source,
        }
    }

    fn line(&self, offset: usize) -> usize {
        self.derivation.pages[0].document.position(offset).line
    }

    /// The comments `<!-- key: … -->` in a part of the page.
    fn comments(&self, key: &str, part: std::ops::Range<usize>) -> Vec<Comment<'_>> {
        let open = format!("<!-- {key}: ");
        let mut found = Vec::new();
        let mut at = part.start;
        while let Some(offset) = self.source[at..part.end].find(&open) {
            let start = at + offset + open.len();
            let rest = &self.source[start..part.end];
            let length = rest.find("-->").unwrap_or(rest.len());
            found.push(Comment {
                line: self.line(at + offset),
                text: rest[..length].trim(),
            });
            at = start + length;
        }
        found
    }

    /// The equations by their displays: rows that share a number are shown, and slip, together.
    fn displays(&self) -> Vec<std::ops::Range<usize>> {
        let all = 0..self.derivation.equations.len();
        let rows = all.map(|at| self.derivation.rows_of(at));
        let mut displays: Vec<_> = rows.collect();
        displays.dedup();
        displays
    }

    /// The text of equations that stand one after another.
    fn body(&self, rows: &std::ops::Range<usize>) -> std::ops::Range<usize> {
        let of = |at: usize| self.derivation.equations[at].body.range();
        of(rows.start).start..of(rows.end - 1).end
    }

    /// The comments above a display.
    fn above(&self, key: &str, equation: usize) -> Vec<Comment<'_>> {
        let equations = &self.derivation.equations;
        let start = equation.checked_sub(1).map_or(0, |e| equations[e].span.end);
        self.comments(key, start..equations[equation].span.start)
    }

    /// `file:line`, and the mathematics.
    fn show(&self, rows: &std::ops::Range<usize>) -> String {
        let body = self.body(rows);
        let line = self.line(body.start);
        let body = self.source[body].split_whitespace();
        let body = body.collect::<Vec<_>>().join(" ");
        format!("{}:{line}\n    equation  {body}", self.path)
    }

    /// Compares what is found with what is expected.
    fn compare(&self, not_yet: bool, faults: &mut Vec<String>) {
        let audit = Audit::of(&self.derivation);
        let mut open = 0;
        for rows in self.displays() {
            let found = Answer::found(&audit, rows.clone());
            let expected = self.above("expect", rows.start);
            let wanted = self.above("not-yet", rows.start);
            let (comment, is_open) = match (&expected[..], &wanted[..]) {
                ([comment], []) => (comment, false),
                ([], [comment]) if not_yet => (comment, true),
                _ => {
                    let shown = self.show(&rows);
                    faults.push(format!(
                        "{shown}\n    needs exactly one comment above it, `<!-- expect: … -->`\n    found     {found}"
                    ));
                    continue;
                }
            };
            let answer = Answer::read(comment.text);
            for word in answer.misspelt() {
                let (path, line) = (&self.path, comment.line);
                faults.push(format!(
                    "{path}:{line}\n    `{word}` is no verdict and no note"
                ));
            }
            open += usize::from(is_open);
            match (is_open, answer == found) {
                (false, true) | (true, false) => {}
                (false, false) => {
                    let shown = self.show(&rows);
                    faults.push(format!(
                        "{shown}\n    expected  {answer}\n    found     {found}"
                    ));
                }
                (true, true) => {
                    let shown = self.show(&rows);
                    faults.push(format!(
                        "{shown}\n    found     {found}\n    good news: this is right now; write `expect:`, and once nothing is open move the page up"
                    ));
                }
            }
        }
        if not_yet && open == 0 {
            let path = &self.path;
            faults.push(format!(
                "{path}\n    nothing is open here: move the page up"
            ));
        }
        self.compare_problems(faults);
    }

    fn compare_problems(&self, faults: &mut Vec<String>) {
        let path = &self.path;
        let mut problems: Vec<_> = self.derivation.pages[0].problems.iter().collect();
        for comment in self.comments("expect-problem", 0..self.source.len()) {
            match problems
                .iter()
                .position(|p| p.message.contains(comment.text))
            {
                Some(at) => drop(problems.remove(at)),
                None => faults.push(format!(
                    "{path}:{}\n    expected a problem with “{}”\n    found     none",
                    comment.line, comment.text
                )),
            }
        }
        for problem in problems {
            let line = self.line(problem.span.start);
            faults.push(format!(
                "{path}:{line}\n    unexpected problem  {}",
                problem.message
            ));
        }
    }

    /// Makes each slip by itself.
    fn slips(&self, faults: &mut Vec<String>) {
        let original = self.failing();
        for rows in self.displays() {
            let at = rows.start;
            let slips = self.above("slip", at).into_iter().map(|slip| (slip, false));
            let spreading = self.above("slip-spreads", at).into_iter();
            for (slip, spreads) in slips.chain(spreading.map(|slip| (slip, true))) {
                let mut fault = |text: &str| {
                    faults.push(format!(
                        "{}:{}\n    slip      {}\n    {text}",
                        self.path, slip.line, slip.text
                    ));
                };
                let Some((right, wrong)) = slip.text.split_once(" becomes ") else {
                    fault("write `right becomes wrong`");
                    continue;
                };
                let body = self.body(&rows);
                let equation = &self.source[body.clone()];
                if equation.matches(right).count() != 1 {
                    fault("what is right does not stand exactly once in the display below");
                    continue;
                }
                let mut source = self.source.clone();
                source.replace_range(body, &equation.replacen(right, wrong, 1));
                let slipped = Page {
                    path: self.path.clone(),
                    derivation: Derivation::from_markdown(&self.path, &source),
                    source,
                };
                let failing = slipped.failing();
                if !failing.contains(&at) {
                    let found = Answer::found(&Audit::of(&slipped.derivation), rows.clone());
                    fault(&format!("is not caught: {found}"));
                }
                let new = failing.difference(&original);
                let others: Vec<&usize> = new.filter(|&&other| other != at).collect();
                if spreads && others.is_empty() {
                    fault("good news: makes no other step fail now; write `slip:`");
                }
                for other in others.iter().filter(|_| !spreads) {
                    fault(&format!(
                        "makes another step fail:\n  {}",
                        slipped.show(&slipped.derivation.rows_of(**other))
                    ));
                }
            }
        }
    }

    /// The displays with a statement that fails or is ill-dimensioned, each by its first equation.
    fn failing(&self) -> BTreeSet<usize> {
        let audit = Audit::of(&self.derivation);
        let entries = audit.entries.iter();
        let failing = entries.filter(|entry| {
            let mut codes = entry.notes.iter().map(|note| note.code());
            entry.is_wrong() || codes.any(|code| code == "numeric-not-supported")
        });
        let first = |entry: &Entry| self.derivation.rows_of(entry.equation).start;
        failing.map(first).collect()
    }
}

fn pages(folder: &str) -> Vec<Page> {
    let folder = Path::new("tests").join(folder);
    let files = std::fs::read_dir(folder).expect("the folder of pages");
    let mut paths: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    // `PAGE=lens cargo test --test all pages::` runs the pages with `lens` in their names.
    if let Ok(part) = std::env::var("PAGE") {
        paths.retain(|path| path.to_string_lossy().contains(&part));
    }
    paths.sort();
    paths.iter().map(|path| Page::read(path)).collect()
}

fn complain(faults: Vec<String>) {
    let count = faults.len();
    assert!(
        count == 0,
        "\n\n{}\n\n{count} in all\n",
        faults.join("\n\n")
    );
}

#[test]
fn each_page_is_judged_as_it_expects() {
    let mut faults = Vec::new();
    for page in pages("pages") {
        page.compare(false, &mut faults);
    }
    complain(faults);
}

#[test]
fn each_slip_is_caught_where_it_is_made_and_nowhere_else() {
    let mut faults = Vec::new();
    for page in pages("pages") {
        page.slips(&mut faults);
    }
    complain(faults);
}

#[test]
fn what_is_not_yet_judged_rightly_is_noticed_once_it_is() {
    let mut faults = Vec::new();
    for page in pages("pages/not-yet") {
        page.compare(true, &mut faults);
    }
    complain(faults);
}
