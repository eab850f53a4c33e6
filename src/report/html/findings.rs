//! All that is to be mended, before anything else: a line each, with a way to the place.

use crate::audit::Entry;
use crate::notation::escape;
use crate::report::codes::Level;
use crate::report::diagnostic::Finding;
use crate::report::remark::Known;
use crate::sorted;

use super::words;
use super::{Page, anchors};

/// What a finding says that stands with its equation anyway.
const TOLD_THERE: [&str; 3] = ["judged from", "counterexample", "replay"];

impl Page<'_> {
    /// The findings in reading order, those that share what is the matter with them together.
    pub(super) fn findings(&self) -> String {
        let mut text = String::from(
            "<section id=\"findings\" aria-labelledby=\"findings-title\">\n<h2 id=\"findings-title\">Findings</h2>\n",
        );
        let found = self.found();
        if found.is_empty() {
            return text + "<p>There is nothing to mend.</p>\n</section>\n";
        }
        text += "<ol class=\"findings\">\n";
        for (finding, entry) in &found {
            text += &self.finding(finding, *entry);
        }
        text + "</ol>\n</section>\n"
    }

    fn found(&self) -> Vec<(Finding, Option<&Entry>)> {
        let report = self.report;
        let elsewhere = report.elsewhere().into_iter();
        let elsewhere = elsewhere.filter(|(_, finding)| report.is_grave(finding));
        let mut found: Vec<(Finding, Option<&Entry>)> =
            elsewhere.map(|(_, finding)| (finding, None)).collect();
        let first_to_share = report.first_to_share(&Known::new());
        for (entry, shared) in report.audit.entries.iter().zip(first_to_share) {
            let shared = shared.into_iter().map(|own| report.sharing(own));
            found.extend(shared.map(|finding| (report.leveled(finding), Some(entry))));
            let own = report.of_entry(entry).into_iter();
            found.extend(own.map(|finding| (finding, Some(entry))));
        }
        sorted::sort_by_key(&mut found, |(finding, _)| {
            (finding.page, finding.primary.0.start)
        });
        found
    }

    fn finding(&self, finding: &Finding, entry: Option<&Entry>) -> String {
        let target = match entry {
            Some(entry) => anchors::evidence(self.anchors.equation(entry.equation), entry),
            None => anchors::document(finding.page),
        };
        let level = self.report.level(finding.page, finding.code);
        let level = level.unwrap_or(Level::Warning);
        let mut text = format!(
            "<li class=\"finding {level}\"><p><span class=\"code\">{}</span> <a href=\"#{target}\">{}</a></p>\n",
            finding.code,
            words::ticked(&words::capital(&finding.title)),
            level = level.word()
        );
        let said: Vec<(String, String)> = finding.said_plainly();
        let said = said
            .iter()
            .filter(|(name, _)| !TOLD_THERE.contains(&name.as_str()));
        let mut lines: Vec<String> = said
            .map(|(name, said)| {
                let lines: Vec<String> = said
                    .lines()
                    .map(|line| match name.as_str() {
                        "help" => words::ticked_and_set(line),
                        _ => words::ticked(line),
                    })
                    .collect();
                let shown = lines.join("<br/>");
                format!("<div><dt>{}</dt><dd>{shown}</dd></div>", escape(name))
            })
            .collect();
        if entry.is_none() {
            let place = self.report.place_of(finding.page, finding.primary.0);
            lines.insert(
                0,
                format!("<div><dt>at</dt><dd>{}</dd></div>", escape(&place)),
            );
        }
        if !lines.is_empty() {
            text += &format!("<dl>{}</dl>\n", lines.concat());
        }
        text + "</li>\n"
    }
}
