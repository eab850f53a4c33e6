//! The gutter at the left of the cards: there runs every edge that leads from one card to another, or around the boxes of one.
//!
//! What leaves one statement shares a line until it turns off, and what enters one statement shares the rest of the way,
//! so there are no more lines than statements. Lines that do not overlap may share a track; the shortest are next to the cards.

use std::collections::BTreeMap;

use super::super::Graph;
use super::card::Port;
use super::{ROW, Route, TRACK};

/// More lines than this beside each other run on the tracks of others.
const MOST: usize = 40;
/// Between the first track and the cards.
const BESIDE: i64 = 10;

/// Leads every edge that does not run through the layers of a card, and says how wide the gutter is.
pub(super) fn lead(graph: &Graph, ports: &[Port], routes: &mut [Route]) -> i64 {
    let around = || {
        let all = graph.edges.iter().zip(routes.iter());
        all.filter(|(_, route)| matches!(route, Route::Around(_)))
            .map(|(edge, _)| *edge)
    };
    let tracks = tracks(ports, around());
    for (route, (from, _)) in routes.iter_mut().zip(&graph.edges) {
        if let Route::Around(x) = route {
            *x = -BESIDE - tracks[from] as i64 * TRACK;
        }
    }
    let widest = tracks.values().max();
    widest.map_or(0, |&track| BESIDE + (track as i64 + 1) * TRACK)
}

/// The track of what leaves each statement.
fn tracks(ports: &[Port], around: impl Iterator<Item = (usize, usize)>) -> BTreeMap<usize, usize> {
    let mut spans: BTreeMap<usize, (i64, i64)> = BTreeMap::new();
    for (from, to) in around {
        let (leaves, enters) = (ports[from].leaves(), ports[to].enters());
        let span = spans.entry(from).or_insert((leaves, leaves));
        *span = (span.0.min(enters), span.1.max(enters));
    }
    let mut order: Vec<(i64, usize)> = spans
        .iter()
        .map(|(&from, &(top, bottom))| (bottom - top, from))
        .collect();
    order.sort_unstable();
    // By track what is taken: where it begins, and where it ends.
    let mut taken: Vec<BTreeMap<i64, i64>> = Vec::new();
    let mut tracks = BTreeMap::new();
    for (at, (_, from)) in order.into_iter().enumerate() {
        let (top, bottom) = spans[&from];
        let is_free = |track: &BTreeMap<i64, i64>| {
            let above = track.range(..bottom + ROW / 2).next_back();
            above.is_none_or(|(_, end)| *end < top - ROW / 2)
        };
        let track = match taken.iter().position(is_free) {
            Some(track) => track,
            None if taken.len() < MOST => {
                taken.push(BTreeMap::new());
                taken.len() - 1
            }
            None => at % MOST,
        };
        let end = taken[track].entry(top).or_insert(bottom);
        *end = bottom.max(*end);
        tracks.insert(from, track);
    }
    tracks
}
