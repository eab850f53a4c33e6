//! From a text that was gone through to documents: one for each page.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::super::{Directive, Document, Item};
use super::assemble::Assembled;
use super::numbering::Numbering;
use super::scan::Scanner;
use crate::sorted;

/// The documents that a text consists of.
pub(super) fn documents(assembled: Assembled) -> Vec<Document> {
    let Assembled {
        text,
        origin,
        mut problems,
        mut obstacles,
        pages,
        lost,
    } = assembled;
    sorted::sort_by_key(&mut problems, |problem| problem.span);
    sorted::sort_by_key(&mut obstacles, |problem| problem.span);
    let mut scanner = Scanner {
        text: &text,
        bytes: text.as_bytes(),
        at: 0,
        numbering: Numbering::of_class(""),
        subs: Vec::new(),
        items: Vec::new(),
        problems: Vec::new(),
        amiss: problems,
        obstacles,
        lost,
        keys: BTreeSet::new(),
        elsewhere: BTreeSet::new(),
        preamble: text.contains("\\begin{document}"),
        prose_from: 0,
        inline: Vec::new(),
        hidden: Vec::new(),
        depth: 0,
        quiet: 0,
    };
    scanner.run();
    scanner.drop_citations_of_other_things();
    let body = text.find("\\begin{document}").unwrap_or(0);
    let Scanner {
        mut items,
        mut problems,
        amiss,
        ..
    } = scanner;
    problems.extend(amiss);
    sorted::sort_by_key(&mut problems, |problem| problem.span);
    sorted::sort_by_key(&mut items, |item| item.span().start);
    let declares = |item: &&Item| {
        let Item::Directives { clauses, span } = item else {
            return false;
        };
        let lasting =
            |c: &Directive| matches!(c, Directive::Symbols { .. } | Directive::Data { .. });
        span.start < body && clauses.iter().any(|clause| lasting(&clause.value))
    };
    let inherited: Vec<Item> = items.iter().filter(declares).cloned().collect();
    let source: Arc<str> = text.as_str().into();
    let origin = Arc::new(origin);
    let mut starts = vec![(0, 0)];
    starts.extend(pages);
    let mut documents: Vec<Document> = Vec::new();
    let (mut items, mut problems) = (
        items.into_iter().peekable(),
        problems.into_iter().peekable(),
    );
    for (at, &(_, file)) in starts.iter().enumerate() {
        let end = starts.get(at + 1).map_or(usize::MAX, |next| next.0);
        let mut document = Document {
            path: origin.files[file].path.clone(),
            source: source.clone(),
            items: Vec::new(),
            inherited: match at {
                0 => Vec::new(),
                _ => inherited.clone(),
            },
            problems: Vec::new(),
            is_latex: true,
            origin: origin.clone(),
            beside: None,
        };
        while let Some(item) = items.next_if(|item| item.span().start < end) {
            document.items.push(item);
        }
        while let Some(problem) = problems.next_if(|problem| problem.span.start < end) {
            document.problems.push(problem);
        }
        let says = |item: &Item| matches!(item, Item::Display { .. } | Item::Directives { .. });
        if !document.problems.is_empty() || document.items.iter().any(says) {
            documents.push(document);
        }
    }
    if documents.is_empty() {
        documents.push(Document {
            path: origin.files[0].path.clone(),
            source,
            items: Vec::new(),
            inherited: Vec::new(),
            problems: Vec::new(),
            is_latex: true,
            origin,
            beside: None,
        });
    }
    documents
}
