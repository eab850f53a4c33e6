//! The whole audit as one page for a browser: documents, verdicts, evidence, and what rests on what.
//!
//! The page is a single file that fetches nothing. It is well-formed as XML too, works without its script, and may be
//! put beside the documents as it is.
//!
//! `summary` and `findings` come first; `prose` walks the documents and hands each display to `entry`, which sets it
//! beside its verdict with the `evidence` folded below; `pictures` has the figures and tables that somebody else has
//! drawn. `anchors` says what each equation is called in links, `words` makes text safe.
//!
//! **Invariant:** whatever comes from a document passes through `escape`, directly or in MathML; every display of a
//! document is on the page, whatever surrounds it. Deliberately absent: verdicts of its own, pictures that are fetched,
//! any markup of the document's own making.

mod anchors;
mod entry;
mod evidence;
mod findings;
mod pictures;
mod prose;
mod summary;
mod words;

use super::graph::Graph;
use super::{Report, uncoloured};
use crate::notation::escape;
use crate::parallel::in_order;
use anchors::Anchors;

pub use pictures::{Picture, Pictures, Table};

const STYLE: &str = include_str!("style.css");
const SCRIPT: &str = include_str!("script.js");
/// What the browser may load, but for the script: styles that stand on the page, and nothing else.
const POLICY: &str = include_str!("policy.txt");
/// The hash of `script.js`, so that no other script runs. A test computes it anew.
const SCRIPT_HASH: &str = "sha256-eMJaQZSEtlUGNNMq5NWd9NLJDGOKBVR8w4fLubtnhoA=";

/// A page being written.
struct Page<'a> {
    report: &'a Report<'a>,
    anchors: Anchors,
}

impl Report<'_> {
    /// A page of HTML that stands alone.
    pub fn html(&self, pictures: &Pictures) -> String {
        let page = Page {
            report: self,
            anchors: Anchors::of(self),
        };
        let given = pictures.title.as_deref().map(escape);
        let head = given.unwrap_or_else(|| page.title(words::inline));
        let title = match &pictures.title {
            Some(title) => escape(title),
            None => words::untagged(&page.title(words::in_characters)),
        };
        let mut text = String::from(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n",
        );
        text += &format!(
            "<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}; script-src '{SCRIPT_HASH}'\"/>\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
             <meta name=\"color-scheme\" content=\"light dark\"/>\n\
             <meta name=\"generator\" content=\"cradle-verify {}\"/>\n\
             <title>{title}: audit</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
             <a class=\"skip\" href=\"#documents\">Skip to the documents</a>\n",
            env!("CARGO_PKG_VERSION")
        );
        text += &page.head(&head, pictures);
        text += "<main>\n";
        text += &page.findings();
        text += "<section id=\"documents\" aria-labelledby=\"documents-title\">\n<h2 id=\"documents-title\">Documents</h2>\n";
        let documents = in_order(0..self.derivation.pages.len(), |at| page.document(at));
        text.extend(documents);
        text += "</section>\n";
        text += &page.graph();
        text += &pictures.markup();
        text += "</main>\n";
        text += &format!(
            "<footer><p>Written by cradle-verify {}. A verdict stands on evidence that a small kernel has checked; \
             without such evidence it is undecided.</p></footer>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n",
            env!("CARGO_PKG_VERSION")
        );
        text
    }
}

impl Page<'_> {
    /// What the page is called, where nobody says so: like its documents, of which the first two are named.
    fn title(&self, math: fn(&str) -> String) -> String {
        let of = |at| self.title_of(at, math);
        match self.report.derivation.pages.len() {
            0 => "No documents".into(),
            1 => of(0),
            2 => format!("{} and {}", of(0), of(1)),
            several => format!("{}, {} and {} more", of(0), of(1), several - 2),
        }
    }

    /// What rests on what, drawn and in words.
    fn graph(&self) -> String {
        if self.report.audit.entries.is_empty() {
            return String::new();
        }
        let graph = Graph::of(self.report);
        // A node stands for an entry, at the same position.
        let entries = &self.report.audit.entries;
        let address = |at: usize| format!("#{}", self.anchors.equation(entries[at].equation));
        format!(
            "<section id=\"graph\" aria-labelledby=\"graph-title\">\n<h2 id=\"graph-title\">What rests on what</h2>\n\
             <div class=\"scroll drawing\" role=\"region\" aria-label=\"Drawing of what rests on what\" tabindex=\"0\">\n{}</div>\n\
             <details><summary>The same in words</summary>\n<pre>{}</pre></details>\n</section>\n",
            graph.svg_linked(&address),
            escape(&uncoloured(&graph.text(self.report)))
        )
    }
}
