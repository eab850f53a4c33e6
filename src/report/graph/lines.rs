//! The lines of a drawing: from one statement to the next, and around what stands between them.

use std::collections::BTreeMap;
use std::ops::Range;

use super::Graph;
use super::layout::{Frame, Layout, Point, Route};

/// How round a corner is.
const ROUND: i64 = 6;

/// A line, or the tip of one.
pub(super) struct Line {
    /// What it covers from above to below.
    rows: Range<i64>,
    element: String,
}

impl Line {
    /// What is seen of it between two heights.
    pub fn within(&self, rows: &Range<i64>) -> Option<&str> {
        let is_seen = self.rows.start < rows.end && rows.start < self.rows.end;
        is_seen.then_some(self.element.as_str())
    }

    fn stroke(rows: Range<i64>, path: &str, is_broken: bool) -> Line {
        let class = if is_broken { " cv-broken" } else { "" };
        Line {
            rows,
            element: format!("<path class=\"cv-edge{class}\" d=\"{path}\"/>\n"),
        }
    }

    /// The tip of an arrow at a statement.
    fn tip(frame: &Frame, is_broken: bool) -> Line {
        let class = if is_broken { " cv-broken" } else { "" };
        let (x, y) = (frame.x, frame.middle());
        Line {
            rows: frame.y..frame.y + frame.height,
            element: format!("<path class=\"cv-tip{class}\" d=\"M{x} {y}l-7 -3.5v7z\"/>\n"),
        }
    }

    fn around(corners: &[Point], is_broken: bool) -> Line {
        let (mut top, mut bottom) = (i64::MAX, i64::MIN);
        for (_, y) in corners {
            (top, bottom) = (top.min(*y), bottom.max(*y));
        }
        Line::stroke(top - 1..bottom + 1, &rounded(corners), is_broken)
    }
}

impl Graph {
    /// All lines, in the order in which they are drawn: what is broken lies over the rest, and tips over lines.
    pub(super) fn lines(&self, layout: &Layout) -> Vec<Line> {
        let mut lines = self.of_a_kind(layout, false);
        lines.extend(self.of_a_kind(layout, true));
        let mut broken = vec![None; self.nodes.len()];
        for &edge in &self.edges {
            *broken[edge.1].get_or_insert(false) |= self.is_broken(edge);
        }
        let tips = layout.nodes.iter().zip(broken);
        lines.extend(tips.filter_map(|(frame, broken)| Some(Line::tip(frame, broken?))));
        lines
    }

    /// The lines that are broken, or those that are not, nothing of them twice: what several edges share is one line.
    fn of_a_kind(&self, layout: &Layout, is_broken: bool) -> Vec<Line> {
        let mut lines = Vec::new();
        // By beginning, how far up and down its edges run in the gutter.
        let mut trunks: BTreeMap<usize, Trunk> = BTreeMap::new();
        // By end, from how far at the left it is reached.
        let mut entries: BTreeMap<usize, i64> = BTreeMap::new();
        for (&(from, to), route) in self.edges.iter().zip(&layout.routes) {
            if self.is_broken((from, to)) != is_broken {
                continue;
            }
            let x = match route {
                Route::Through(boxes) => {
                    let top = boxes.iter().map(|frame| frame.y).min().unwrap_or(0);
                    let bottom = boxes.iter().map(|frame| frame.y + frame.height).max();
                    let rows = top..bottom.unwrap_or(0);
                    lines.push(Line::stroke(rows, &level(boxes), is_broken));
                    continue;
                }
                Route::Around(x) => *x,
            };
            let (leaves, enters) = (layout.ports[from].leaves(), layout.ports[to].enters());
            let turn = match leaves < enters {
                true => enters - ROUND,
                false => enters + ROUND,
            };
            let trunk = trunks.entry(from).or_insert(Trunk {
                x,
                top: leaves,
                bottom: leaves,
            });
            (trunk.top, trunk.bottom) = (trunk.top.min(turn), trunk.bottom.max(turn));
            let turned = x + ROUND;
            let corner = format!("M{x} {turn}Q{x} {enters},{turned} {enters}");
            let rows = turn.min(enters)..turn.max(enters);
            lines.push(Line::stroke(rows, &corner, is_broken));
            let left = entries.entry(to).or_insert(turned);
            *left = turned.min(*left);
        }
        for (from, trunk) in trunks {
            let leaves = layout.ports[from].leaves();
            for end in [trunk.top, trunk.bottom] {
                if end != leaves {
                    let mut corners = layout.ports[from].exit.clone();
                    corners.extend([(trunk.x, leaves), (trunk.x, end)]);
                    lines.push(Line::around(&corners, is_broken));
                }
            }
        }
        for (to, left) in entries {
            let mut corners = vec![(left, layout.ports[to].enters())];
            corners.extend(&layout.ports[to].entry);
            lines.push(Line::around(&corners, is_broken));
        }
        lines
    }
}

/// What leaves one statement by the gutter.
struct Trunk {
    x: i64,
    top: i64,
    bottom: i64,
}

/// Level through boxes, and in a bend from each to the next.
fn level(boxes: &[Frame]) -> String {
    let mut text = String::new();
    let mut last: Option<Point> = None;
    for frame in boxes {
        let y = frame.middle();
        text += &match last {
            None => format!("M{} {y}", frame.x),
            Some((_, above)) if above == y => String::new(),
            Some((x, above)) => {
                let half = (x + frame.x) / 2;
                format!("C{half} {above},{half} {y},{} {y}", frame.x)
            }
        };
        text += &format!("H{}", frame.x + frame.width);
        last = Some((frame.x + frame.width, y));
    }
    text
}

/// From corner to corner, level and upright in turn, each corner rounded as far as there is room.
fn rounded(corners: &[Point]) -> String {
    let (first, last) = (corners[0], corners[corners.len() - 1]);
    let mut text = format!("M{} {}", first.0, first.1);
    for turn in corners.windows(3) {
        let [from, (x, y), to] = [turn[0], turn[1], turn[2]];
        let length = |(a, b): Point| (a - x).abs() + (b - y).abs();
        let round = ROUND.min(length(from) / 2).min(length(to) / 2);
        let near = |(a, b): Point| (x + round * (a - x).signum(), y + round * (b - y).signum());
        let ((ax, ay), (bx, by)) = (near(from), near(to));
        text += &format!("L{ax} {ay}Q{x} {y},{bx} {by}");
    }
    text + &format!("L{} {}", last.0, last.1)
}
