//! What shapes and lines of a drawing mean.

use super::layout::Frame;
use super::svg::{MARGIN, class, shape, sign};
use super::{Graph, Status};

/// From one line of the legend to the next.
pub(super) const LEGEND_LINE: i64 = 30;
const WIDTH: i64 = 28;
const HEIGHT: i64 = 22;

/// A sample of each kind that occurs, none further to the right than `end`, and how many lines they take.
pub(super) fn legend(graph: &Graph, end: i64) -> (String, i64) {
    let mut text = String::new();
    let (mut x, mut lines) = (MARGIN, 1);
    for (sample, words) in statuses(graph).into_iter().chain(edges(graph)) {
        let length = 60 + 8 * words.chars().count() as i64;
        if x > MARGIN && x + length > end {
            (x, lines) = (MARGIN, lines + 1);
        }
        let y = MARGIN + 34 + (lines - 1) * LEGEND_LINE;
        text += &format!(
            "<g transform=\"translate({x} {y})\">{sample}</g><text class=\"cv-soft\" x=\"{}\" y=\"{}\">{words}</text>\n",
            x + WIDTH + 8,
            y + 15
        );
        x += length;
    }
    (text, lines)
}

/// How statements stand, each as a sample with its words.
fn statuses(graph: &Graph) -> Vec<(String, &'static str)> {
    let seen = |status: &Status| graph.nodes.iter().any(|n| n.status == *status);
    let frame = Frame {
        width: WIDTH,
        height: HEIGHT,
        ..Frame::default()
    };
    let sample = |status: Status| {
        let drawn = shape(status, frame) + &sign(status, WIDTH / 2, HEIGHT / 2);
        (
            format!("<g class=\"cv-node {}\">{drawn}</g>", class(status)),
            status.words(),
        )
    };
    Status::ALL.into_iter().filter(seen).map(sample).collect()
}

/// What arrows mean, each as a sample with its words.
fn edges(graph: &Graph) -> Vec<(String, &'static str)> {
    let seen = |broken: bool| graph.edges.iter().any(|e| graph.is_broken(*e) == broken);
    let sample = |(_, kind, words): (bool, &str, &'static str)| {
        let middle = HEIGHT / 2;
        let drawn = format!(
            "<path class=\"cv-edge{kind}\" d=\"M0 {middle}H{WIDTH}\"/><path class=\"cv-tip{kind}\" d=\"M{WIDTH} {middle}l-7 -3.5v7z\"/>"
        );
        (drawn, words)
    };
    let all = [
        (false, "", "leads to what rests on it"),
        (true, " cv-broken", "hands on what is wrong"),
    ];
    let all = all.into_iter().filter(|(broken, ..)| seen(*broken));
    all.map(sample).collect()
}
