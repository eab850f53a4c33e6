//! The graph as a drawing that needs nothing else: no fonts, no styles, no scripts.
//!
//! Colours are custom properties, so that a page that takes the drawing in can set them; by itself it follows the
//! reader's choice of light or dark. What fails and what falls is told apart by shape and sign too.

use std::ops::Range;

use super::super::words::count;
use super::layout::{Frame, Layout, drawn_name, letters_in};
use super::legend::{LEGEND_LINE, legend};
use super::lines::Line;
use super::{Graph, Status};
use crate::notation::{escape_by, unbraced};

pub(super) const MARGIN: i64 = 20;
/// Above the cards: a heading and one line of the legend.
const HEAD: i64 = 74;
/// How wide a drawing of its own is, without its margins.
const WIDTH: i64 = 1_110;
/// How wide it is on a page, which has less room and may go on for longer: on a sheet of A4 its text is 7 points high.
const WIDTH_ON_A_PAGE: i64 = 900;

/// `:where` weighs nothing: a page's own rule for `.cv-graph` prevails.
const STYLE: &str = "\
:where(.cv-graph){--cv-paper:#ffffff;--cv-card:#f6f8fa;--cv-rim:#d0d7de;--cv-ink:#1f2328;--cv-soft:#57606a;\
--cv-line:#8c959f;--cv-good:#1a7f37;--cv-bad:#cf222e;--cv-bad-fill:#ffebe9;--cv-warn:#9a6700}\
@media screen and (prefers-color-scheme:dark){:where(.cv-graph){--cv-paper:#0d1117;--cv-card:#161b22;--cv-rim:#30363d;\
--cv-ink:#e6edf3;--cv-soft:#9198a1;--cv-line:#6e7681;--cv-good:#3fb950;--cv-bad:#ff7b72;--cv-bad-fill:#3c1618;\
--cv-warn:#d29922}}\
.cv-graph text{font-family:system-ui,sans-serif;fill:var(--cv-ink)}\
.cv-graph .cv-page{fill:var(--cv-paper)}\
.cv-graph .cv-card{fill:var(--cv-card);stroke:var(--cv-rim)}\
.cv-graph .cv-soft{fill:var(--cv-soft)}\
.cv-graph .cv-title{stroke:var(--cv-card);stroke-width:4;stroke-linejoin:round;paint-order:stroke}\
.cv-graph .cv-edge{fill:none;stroke:var(--cv-line);stroke-width:1.3}\
.cv-graph .cv-edge.cv-broken{stroke:var(--cv-bad);stroke-width:2.4}\
.cv-graph .cv-tip{fill:var(--cv-line)}\
.cv-graph .cv-tip.cv-broken{fill:var(--cv-bad)}\
.cv-graph .cv-node .cv-box{fill:var(--cv-paper);stroke:var(--cv-soft);stroke-width:1.3}\
.cv-graph .cv-node .cv-sign{fill:none;stroke:var(--cv-soft);stroke-width:1.8;stroke-linecap:round}\
.cv-graph .cv-holds .cv-box{stroke:var(--cv-good)}\
.cv-graph .cv-holds .cv-sign{stroke:var(--cv-good)}\
.cv-graph .cv-fails .cv-box{fill:var(--cv-bad-fill);stroke:var(--cv-bad);stroke-width:2.4}\
.cv-graph .cv-fails .cv-sign{stroke:var(--cv-bad);stroke-width:2.2}\
.cv-graph .cv-fails text{font-weight:600}\
.cv-graph .cv-falls .cv-box{stroke:var(--cv-bad);stroke-dasharray:5 3}\
.cv-graph .cv-falls .cv-sign{stroke:var(--cv-bad)}\
.cv-graph .cv-stands .cv-box{stroke:var(--cv-warn);stroke-dasharray:5 3}\
.cv-graph .cv-stands .cv-sign{stroke:var(--cv-warn)}\
.cv-graph .cv-undecided .cv-box{stroke:var(--cv-warn);stroke-dasharray:1 3;stroke-linecap:round}\
.cv-graph .cv-undecided .cv-sign{stroke:var(--cv-warn)}\
.cv-graph a:hover text,.cv-graph a:focus-visible text{text-decoration:underline}";

/// The address of each statement, by position.
type Address<'a> = &'a dyn Fn(usize) -> String;

impl Graph {
    /// An `<svg>` element, with its size and its own colours, light and dark.
    pub fn svg(&self) -> String {
        self.drawing(WIDTH, None)
    }

    /// The same for a page that has the statements: narrower, without a heading, each statement a link to its address. It is
    /// several `<svg>` elements one below the other, one for each row of cards: paper ends between two of them.
    pub fn svg_linked(&self, address: Address<'_>) -> String {
        self.drawing(WIDTH_ON_A_PAGE, Some(address))
    }

    fn drawing(&self, widest: i64, address: Option<Address<'_>>) -> String {
        let layout = Layout::of(self, widest);
        let (legend, lines) = legend(self, layout.left + layout.width + MARGIN);
        let head = HEAD + (lines - 1) * LEGEND_LINE;
        let (width, height) = (
            layout.left + layout.width + 2 * MARGIN,
            layout.height + head + 2 * MARGIN,
        );
        let fallen = self.nodes.iter().filter(|n| n.status.is_fallen()).count();
        let mut told = vec![count(self.nodes.len(), "statement")];
        told.extend(self.wrong([
            ["failing"; 2],
            ["ill-dimensioned"; 2],
            ["crossed out by the author"; 2],
        ]));
        if fallen > 0 {
            told.push(format!("{fallen} falling with what fails"));
        }
        let told = told.join(", ");
        let line = MARGIN + 16;
        let (beside, heading) = match address {
            Some(_) => (MARGIN, String::new()),
            None => (
                MARGIN + 230,
                format!(
                    "<text x=\"{MARGIN}\" y=\"{line}\" font-size=\"20\" font-weight=\"600\">What rests on what</text>\n"
                ),
            ),
        };
        let first = [
            format!(
                "<title>What rests on what</title>\n<desc>{told}</desc>\n<style>{STYLE}</style>\n"
            ),
            format!(
                "{heading}<text class=\"cv-soft\" x=\"{beside}\" y=\"{line}\">{told}</text>\n{legend}"
            ),
        ];
        // What is within an image is no link to a screen reader.
        let (role, rows) = match address {
            Some(_) => ("group", layout.rows()),
            None => ("img", Vec::new()),
        };
        let (right, down) = (MARGIN + layout.left, MARGIN + head);
        let mut text = String::new();
        let drawn = self.lines(&layout);
        let mut start = 0;
        for end in rows.into_iter().map(|y| y + down).chain([height]) {
            let [about, legend] = match start {
                0 => first.each_ref().map(String::as_str),
                _ => ["", ""],
            };
            let tall = end - start;
            text += &format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"cv-graph\" role=\"{role}\" width=\"{width}\" \
                 height=\"{tall}\" viewBox=\"0 {start} {width} {tall}\" font-size=\"13\">\n{about}\
                 <rect class=\"cv-page\" y=\"{start}\" width=\"{width}\" height=\"{tall}\"/>\n{legend}\
                 <g transform=\"translate({right} {down})\">\n"
            );
            text += &self.between(&layout, &drawn, start - down..end - down, address);
            text += "</g>\n</svg>\n";
            start = end;
        }
        text
    }

    /// What is to be seen between two heights: cards with their statements, and the lines that pass.
    fn between(
        &self,
        layout: &Layout,
        lines: &[Line],
        own: Range<i64>,
        address: Option<Address<'_>>,
    ) -> String {
        let mut text = String::new();
        let is_here = |frame: &Frame| own.contains(&frame.y);
        for (_, frame) in layout.cards.iter().filter(|(_, frame)| is_here(frame)) {
            text += &format!(
                "<rect class=\"cv-card\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"8\"/>\n",
                frame.x, frame.y, frame.width, frame.height
            );
        }
        text.extend(lines.iter().filter_map(|line| line.within(&own)));
        for card in layout.cards.iter().filter(|(_, frame)| is_here(frame)) {
            text += &self.title(card);
        }
        for (at, frame) in layout.nodes.iter().enumerate() {
            if is_here(frame) {
                text += &self.drawn(at, *frame, address);
            }
        }
        text
    }

    /// The title of a card, to be read over whatever passes below.
    fn title(&self, (document, frame): &(usize, Frame)) -> String {
        let (title, path) = &self.documents[*document];
        let title = if title.is_empty() { path } else { title };
        let room = letters_in(title, frame.width);
        format!(
            "<text class=\"cv-soft cv-title\" x=\"{}\" y=\"{}\" font-weight=\"600\">{}</text>\n",
            frame.x + 14,
            frame.y + 21,
            escaped(&super::shortened(title, room))
        )
    }

    fn drawn(&self, at: usize, frame: Frame, address: Option<Address<'_>>) -> String {
        let node = &self.nodes[at];
        let (opening, closing) = match address {
            Some(address) => (format!("a href=\"{}\"", escaped(&address(at))), "a"),
            None => ("g".to_owned(), "g"),
        };
        let statement = unbraced(&node.statement);
        let mut told = format!("{}: {}, {statement}", node.name, node.status.words());
        if !node.rests_on.is_empty() {
            let names = node
                .rests_on
                .iter()
                .take(8)
                .map(|&at| self.nodes[at].name.clone());
            told += &format!("; rests on {}", names.collect::<Vec<_>>().join(", "));
        }
        format!(
            "<{opening} class=\"cv-node {}\"><title>{}</title>{}{}<text x=\"{}\" y=\"{}\">{}</text></{closing}>\n",
            class(node.status),
            escaped(&told),
            shape(node.status, frame),
            sign(node.status, frame.x + 14, frame.middle()),
            frame.x + 25,
            frame.y + 17,
            escaped(&drawn_name(&node.name))
        )
    }
}

pub(super) fn class(status: Status) -> &'static str {
    match status {
        Status::Given => "cv-given",
        Status::Holds => "cv-holds",
        Status::Falls => "cv-falls",
        Status::Stands => "cv-stands",
        Status::Fails | Status::IllDimensioned => "cv-fails",
        Status::CrossedOut => "cv-crossed",
        Status::Undecided => "cv-undecided",
    }
}

pub(super) fn shape(status: Status, frame: Frame) -> String {
    let Frame {
        x,
        y,
        width,
        height,
    } = frame;
    match status {
        Status::Fails | Status::IllDimensioned | Status::CrossedOut => {
            let cut = 8;
            format!(
                "<path class=\"cv-box\" d=\"M{} {y}H{}L{} {}V{}L{} {}H{}L{x} {}V{}Z\"/>",
                x + cut,
                x + width - cut,
                x + width,
                y + cut,
                y + height - cut,
                x + width - cut,
                y + height,
                x + cut,
                y + height - cut,
                y + cut
            )
        }
        _ => {
            let round = match status {
                Status::Given => height / 2,
                _ => 4,
            };
            format!(
                "<rect class=\"cv-box\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"{round}\"/>"
            )
        }
    }
}

/// A small sign, drawn rather than written, around a point.
pub(super) fn sign(status: Status, x: i64, y: i64) -> String {
    let path = match status {
        Status::Given => format!("M{} {y}h.01", x),
        Status::Holds => format!("M{} {}l3 3l5 -7", x - 4, y + 1),
        Status::Falls => format!("M{x} {}v8m-3 -3l3 3l3 -3", y - 4),
        Status::Stands => format!("M{x} {}v7m-3 -3l3 3l3 -3M{} {}h8", y - 5, x - 4, y + 5),
        Status::Fails | Status::CrossedOut => format!("M{} {}l7 7m0 -7l-7 7", x - 4, y - 4),
        Status::IllDimensioned => format!("M{x} {}v6m0 4v.01", y - 5),
        Status::Undecided => format!("M{} {}c0 -5 6 -5 6 -1c0 3 -3 2 -3 4m0 3v.01", x - 3, y - 1),
    };
    format!("<path class=\"cv-sign\" d=\"{path}\"/>")
}

/// Text between tags: one line, without what may not stand in XML at all.
fn escaped(text: &str) -> String {
    escape_by(text, |c| matches!(c, '\n' | '\t' | '\r').then_some(' '))
}
