//! The lines of a drawing: from one statement to the next, and around what stands between them.

use std::collections::BTreeMap;
use std::ops::Range;

use super::Graph;
use super::layout::{Frame, Layout, Point, Route};

/// How round a corner is.
const ROUND: i64 = 6;

/// Lines that nothing else distinguishes, in `d` of a path each.
#[derive(Default)]
struct Lines(Vec<String>);

impl Graph {
    /// The lines between two heights. What is broken is drawn last, over the rest.
    pub(super) fn lines(&self, layout: &Layout, own: &Range<i64>) -> String {
        let mut text = String::new();
        for (is_broken, class) in [(false, "cv-edge"), (true, "cv-edge cv-broken")] {
            let edges = self.edges.iter().zip(&layout.routes);
            let edges: Vec<(usize, usize, &Route)> = edges
                .filter(|(edge, _)| self.is_broken(**edge) == is_broken)
                .map(|(&(from, to), route)| (from, to, route))
                .collect();
            for path in Lines::of(layout, own, &edges).0 {
                text += &format!("<path class=\"{class}\" d=\"{path}\"/>\n");
            }
        }
        text + &self.tips(layout, own)
    }

    /// The tip of an arrow at each statement that anything leads to.
    fn tips(&self, layout: &Layout, own: &Range<i64>) -> String {
        let mut broken = vec![None; self.nodes.len()];
        for &edge in &self.edges {
            let told = broken[edge.1].get_or_insert(false);
            *told |= self.is_broken(edge);
        }
        let mut text = String::new();
        for (frame, broken) in layout.nodes.iter().zip(broken) {
            let Some(is_broken) = broken.filter(|_| own.contains(&frame.y)) else {
                continue;
            };
            let class = if is_broken { " cv-broken" } else { "" };
            text += &format!(
                "<path class=\"cv-tip{class}\" d=\"M{} {}l-7 -3.5v7z\"/>\n",
                frame.x,
                frame.middle()
            );
        }
        text
    }
}

/// What leaves one statement by the gutter.
struct Trunk {
    x: i64,
    top: i64,
    bottom: i64,
}

impl Lines {
    /// What is seen of edges between two heights, nothing of it twice: what several share is one line.
    fn of(layout: &Layout, own: &Range<i64>, edges: &[(usize, usize, &Route)]) -> Lines {
        let mut lines = Lines::default();
        let is_here = |node: usize| own.contains(&layout.nodes[node].y);
        let mut trunks: BTreeMap<usize, Trunk> = BTreeMap::new();
        // By end, from how far at the left it is reached.
        let mut entries: BTreeMap<usize, i64> = BTreeMap::new();
        for &(from, to, route) in edges {
            match route {
                Route::Through(boxes) if is_here(from) => lines.0.push(level(boxes)),
                Route::Through(_) => {}
                Route::Around(x) => {
                    let (leaves, enters) = (layout.ports[from].leaves(), layout.ports[to].enters());
                    let turn = match leaves < enters {
                        true => enters - ROUND,
                        false => enters + ROUND,
                    };
                    let trunk = trunks.entry(from).or_insert(Trunk {
                        x: *x,
                        top: leaves,
                        bottom: leaves,
                    });
                    (trunk.top, trunk.bottom) = (trunk.top.min(turn), trunk.bottom.max(turn));
                    if is_here(to) {
                        let turned = x + ROUND;
                        lines
                            .0
                            .push(format!("M{x} {turn}Q{x} {enters},{turned} {enters}"));
                        let left = entries.entry(to).or_insert(turned);
                        *left = turned.min(*left);
                    }
                }
            }
        }
        for (from, trunk) in trunks {
            let exit = &layout.ports[from].exit;
            let leaves = layout.ports[from].leaves();
            for end in [trunk.top, trunk.bottom] {
                if is_here(from) && end != leaves {
                    let mut corners = exit.clone();
                    corners.extend([(trunk.x, leaves), (trunk.x, end)]);
                    lines.0.push(rounded(&corners));
                }
            }
            let (start, end) = (trunk.top.max(own.start), trunk.bottom.min(own.end));
            if !is_here(from) && start < end {
                lines.0.push(format!("M{} {start}V{end}", trunk.x));
            }
        }
        for (to, left) in entries {
            let mut corners = vec![(left, layout.ports[to].enters())];
            corners.extend(&layout.ports[to].entry);
            lines.0.push(rounded(&corners));
        }
        lines
    }
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
