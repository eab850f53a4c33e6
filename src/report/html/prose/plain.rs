//! Sources that are not Markdown: headings, paragraphs as plain text, mathematics and displays.

use crate::document::Item;
use crate::notation::escape;

use super::super::{Page, words};
use super::spots::{Kind, Piece, Spots};

pub(super) fn walk(page: &Page<'_>, at: usize) -> String {
    let document = &page.report.derivation.pages[at].document;
    let mut spots = Spots::of(page, at);
    let mut text = String::new();
    for item in &document.items {
        let span = item.span();
        for missed in spots.missed(span.start) {
            text += &page.equation(missed);
        }
        match item {
            Item::Heading { level, title, .. } => {
                let level = (*level + 2).min(6);
                text += &format!("<h{level}>{}</h{level}>\n", words::titled(title));
            }
            Item::Prose(_) => {
                let mut line = String::new();
                spots.pass(&span.range(), |piece| line += &set(page, document, piece));
                for paragraph in line.split("\n\n").filter(|p| !p.trim().is_empty()) {
                    text += &format!("<p>{}</p>\n", paragraph.trim());
                }
            }
            Item::Display { .. } => {
                spots.pass(&span.range(), |piece| {
                    if let Piece::Spot(spot) = piece
                        && let Kind::Display(at) = spot.kind
                    {
                        text += &page.equation(at);
                    }
                });
            }
            Item::Directives { .. } => {}
        }
    }
    for missed in spots.missed(usize::MAX) {
        text += &page.equation(missed);
    }
    text
}

fn set(page: &Page<'_>, document: &crate::document::Document, piece: Piece<'_>) -> String {
    let Piece::Spot(spot) = piece else {
        let Piece::Text(text) = piece else {
            return String::new();
        };
        return escape(text);
    };
    match spot.kind {
        Kind::Math(body) => words::inline(document.text(body)),
        Kind::Cited(at) => format!(
            "<a href=\"#{}\">{}</a>",
            page.anchors.equation(at),
            escape(document.text(spot.span))
        ),
        Kind::Display(_) => String::new(),
    }
}
