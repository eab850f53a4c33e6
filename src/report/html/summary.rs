//! The top of the page: what it comes to, how many of each verdict, and a table of documents.

use crate::audit::{Entry, Verdict};
use crate::report::{Report, uncoloured};

use super::Pictures;
use super::entry::Tone;
use super::words;
use super::{Page, anchors};

impl Page<'_> {
    /// Title, closing sentences, numbers and the table, in the landmark of a banner.
    pub(super) fn head(&self, title: &str, pictures: &Pictures) -> String {
        let report = self.report;
        let closing = uncoloured(&report.closing());
        let mut lines = closing.lines();
        let (first, second) = (lines.next().unwrap_or(""), lines.next().unwrap_or(""));
        // What to type to see more is no news where all is to be seen.
        let sentence = |line: &str| words::ticked(line.split(" `").next().unwrap_or(line));
        let mut text = format!(
            "<header>\n<p class=\"kicker\">Audit of the equations</p>\n<h1>{title}</h1>\n\
             <p class=\"lead\"><strong>{}</strong> {}</p>\n",
            sentence(second),
            sentence(first)
        );
        text += &self.tally();
        text += "</header>\n";
        text += "<nav aria-label=\"On this page\"><a href=\"#overview\">Overview</a> <a href=\"#findings\">Findings</a> \
                 <a href=\"#documents\">Documents</a>";
        if !report.audit.entries.is_empty() {
            text += " <a href=\"#graph\">What rests on what</a>";
        }
        if !pictures.is_empty() {
            text += " <a href=\"#figures\">Figures and tables</a>";
        }
        text += "</nav>\n<div id=\"filter\"></div>\n";
        text + &self.table()
    }

    /// A number for each verdict.
    fn tally(&self) -> String {
        let mut text = String::from("<ul class=\"tally\">\n");
        for verdict in Verdict::ALL {
            let count = self.report.audit.entries.iter();
            let count = count.filter(|e| e.verdict == verdict).count();
            text += &format!(
                "<li class=\"{}\"><span class=\"number\">{count}</span> <span class=\"sign\" aria-hidden=\"true\">{}</span> {}</li>\n",
                Tone::of_verdict(verdict).class(),
                super::super::style::sign(verdict),
                verdict.word()
            );
        }
        text + "</ul>\n"
    }

    /// A row for each document, and one for all.
    fn table(&self) -> String {
        let report = self.report;
        let mut text = String::from(
            "<section id=\"overview\" aria-labelledby=\"overview-title\">\n<h2 id=\"overview-title\">Overview</h2>\n\
             <div class=\"scroll\"><table class=\"overview\">\n<caption>Statements by document and verdict</caption>\n\
             <thead><tr><th scope=\"col\">document</th>",
        );
        for word in Verdict::ALL
            .map(Verdict::word)
            .into_iter()
            .chain(["findings"])
        {
            text += &format!("<th scope=\"col\">{word}</th>");
        }
        text += "</tr></thead>\n<tbody>\n";
        let pages = &report.derivation.pages;
        let mut by_page: Vec<Vec<&Entry>> = vec![Vec::new(); pages.len()];
        for entry in &report.audit.entries {
            by_page[report.equation(entry.equation).page].push(entry);
        }
        for (at, entries) in by_page.iter().enumerate() {
            let title = self.title_of(at, words::inline);
            text += &format!(
                "<tr><th scope=\"row\"><a href=\"#{}\">{title}</a></th>{}</tr>\n",
                anchors::document(at),
                cells(report, entries, report.problems(at))
            );
        }
        text += "</tbody>\n";
        if pages.len() > 1 {
            let entries: Vec<&Entry> = report.audit.entries.iter().collect();
            text += &format!(
                "<tfoot><tr><th scope=\"row\">all documents</th>{}</tr></tfoot>\n",
                cells(report, &entries, report.unread())
            );
        }
        text + "</table></div>\n</section>\n"
    }
}

fn cells(report: &Report<'_>, entries: &[&Entry], problems: usize) -> String {
    let of = |verdict| entries.iter().filter(|e| e.verdict == verdict).count();
    let own = entries.iter().map(|e| report.findings_of(e));
    let findings = problems + own.sum::<usize>();
    let numbers = Verdict::ALL.map(of).into_iter().chain([findings]);
    let cell = |number: usize| match number {
        0 => "<td class=\"none\">0</td>".to_owned(),
        _ => format!("<td>{number}</td>"),
    };
    numbers.map(cell).collect()
}
