//! The end of the page: how many of each verdict, page by page, and a closing sentence.

use crate::audit::{Entry, Note, Verdict};

use super::Report;
use super::style::{BOLD, DIM, paint};
use super::words::{count, list, shortened};

const WIDEST_TITLE: usize = 44;
const HEAD: [&str; 6] = [
    "given",
    "holds",
    "fails",
    "ill-dim.",
    "undecided",
    "findings",
];

impl Report<'_> {
    /// A row for each page, a row for all, and what it comes to.
    pub fn summary(&self) -> String {
        let pages = &self.derivation.pages;
        let titles: Vec<String> = pages
            .iter()
            .map(|page| match page.title.is_empty() {
                true => shortened(&page.document.path, WIDEST_TITLE),
                false => shortened(&page.title, WIDEST_TITLE),
            })
            .collect();
        let width = titles.iter().map(|t| t.chars().count()).max().unwrap_or(0);
        let width = width.max("all pages".len());
        let mut text = format!("  {:<width$}", "");
        for word in HEAD {
            text += &paint(DIM, &format!("  {word}"));
        }
        text.push('\n');
        for (at, title) in titles.iter().enumerate() {
            let of_page = |e: &&Entry| self.equation(e.equation).page == at;
            let entries: Vec<&Entry> = self.audit.entries.iter().filter(of_page).collect();
            text += &format!("  {title:<width$}");
            text += &self.cells(&entries, self.problems(at));
        }
        if pages.len() > 1 {
            let problems = (0..pages.len()).map(|page| self.problems(page)).sum();
            let entries: Vec<&Entry> = self.audit.entries.iter().collect();
            text += &paint(BOLD, &format!("  {:<width$}", "all pages"));
            text += &self.cells(&entries, problems);
        }
        text + "\n" + &self.closing()
    }

    /// What it comes to, in a sentence or two.
    pub fn closing(&self) -> String {
        let counts = self.audit.counts();
        let of = |verdict| counts.get(&verdict).copied().unwrap_or(0);
        let findings = self.findings();
        let entries = &self.audit.entries;
        if entries.is_empty() && findings == 0 {
            return "No displayed equation was found, so nothing was checked.\n".into();
        }
        let crossed = entries.iter().filter(|e| e.fails_as_marked()).count();
        let asserted = |verdict| {
            let wrong = |e: &&Entry| e.verdict == verdict && !e.fails_as_marked();
            entries.iter().filter(wrong).count()
        };
        let total = count(entries.len(), "statement");
        let supported = entries.iter().filter(|e| e.is_supported()).count();
        let open = of(Verdict::Undecided) - supported;
        let is_unread = |e: &&Entry| e.notes.iter().any(|own| matches!(own, Note::Unreadable(_)));
        let unread = entries.iter().filter(is_unread).count().min(open);
        let mut told = Vec::new();
        for (number, word) in [
            (of(Verdict::Given), "given"),
            (of(Verdict::Holds), "proved"),
            (asserted(Verdict::Fails), "refuted"),
            (crossed, "crossed out by the author and rightly so"),
            (asserted(Verdict::IllDimensioned), "ill-dimensioned"),
            (supported, "supported numerically"),
            (open - unread, "undecided"),
            (unread, "unreadable"),
        ] {
            if number > 0 {
                told.push(format!("{number} {word}"));
            }
        }
        let first = match entries.is_empty() {
            true => "No displayed equation was read.".to_owned(),
            false => format!("Of {total}, {}.", list(told)),
        };
        let wrong = asserted(Verdict::Fails) + asserted(Verdict::IllDimensioned);
        let second = match (findings, open) {
            (0, _) if wrong > 0 => {
                // A configuration may call it a note; it is wrong all the same.
                let those = if wrong == 1 { "is" } else { "are" };
                format!(
                    "{} {those} wrong, which is a note here and no finding.",
                    count(wrong, "statement")
                )
            }
            (0, 0) if entries.iter().any(|e| self.is_unchecked(e)) => {
                "Nothing was found amiss, but what is taken as given was not checked.".into()
            }
            (0, 0) => "Nothing is amiss.".to_owned(),
            (0, _) => "Nothing was found amiss, but what is undecided was not checked.".to_owned(),
            _ => {
                let mut some = entries.iter().filter(|e| self.is_finding(e));
                let replay = some.next().map_or(String::new(), |entry| {
                    let replay = self.replay(entry.equation);
                    format!(" `{replay}` writes one out in full.")
                });
                let verb = if findings == 1 { "needs" } else { "need" };
                format!("{} {verb} mending.{replay}", count(findings, "finding"))
            }
        };
        format!("{first}\n{}\n", paint(BOLD, &second))
    }

    /// Whether a step is taken as given, or for a definition.
    fn is_unchecked(&self, entry: &Entry) -> bool {
        let given = |note: &Note| matches!(note, Note::TakenAsGiven(_));
        self.equation(entry.equation).drawn && entry.notes.iter().any(given)
    }

    fn cells(&self, entries: &[&Entry], problems: usize) -> String {
        let of = |verdict| entries.iter().filter(|e| e.verdict == verdict).count();
        let own = entries.iter().map(|e| self.findings_of(e));
        let findings = problems + own.sum::<usize>();
        let numbers = Verdict::ALL.map(of).into_iter().chain([findings]);
        let cells = numbers.zip(HEAD).map(|(number, head)| {
            let width = head.len();
            match number {
                0 => format!("  {:>width$}", "–"),
                _ => format!("  {number:>width$}"),
            }
        });
        cells.collect::<String>() + "\n"
    }
}
