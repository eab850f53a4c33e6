//! Where the nodes of a drawing stand: a card for each document, and in it layers from left to right.
//!
//! A statement stands one layer to the right of the last of its premises in the same document. Layers that would make a
//! card too wide go on below, as lines of a text do. An edge that skips layers keeps a place free in each. Cards
//! stand side by side in reading order as far as there is room. All is in whole units, and the work grows
//! with the number of statements and edges.

use std::ops::Range;

use super::Graph;
use crate::sorted::{self, Tree};

/// Sizes, in units of the drawing.
pub(super) const NODE_HEIGHT: i64 = 26;
const ROW: i64 = 34;
const GAP: i64 = 28;
const STRIP_GAP: i64 = 12;
const PADDING: i64 = 14;
const TITLE: i64 = 34;
/// Twice the width of a letter, wide fonts included.
const LETTER: i64 = 17;
const WIDE_LETTER: i64 = 26;
const MOST_LETTERS: usize = 24;
/// The width of a letter in a title, which has no box of its own.
const TITLE_LETTER: i64 = 7;
/// No wider than this are the layers of one strip, unless a single name is, or less is asked for.
const STRIP: i64 = 1_080;
/// Statements that nothing in the document hangs on stand in lines of this width.
const LOOSE: i64 = 520;
const BETWEEN_CARDS: i64 = 18;

/// A box.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Frame {
    pub x: i64,
    pub y: i64,
    pub width: i64,
    pub height: i64,
}

/// Where everything stands.
pub(super) struct Layout {
    pub width: i64,
    pub height: i64,
    /// Document and box.
    pub cards: Vec<(usize, Frame)>,
    /// By node.
    pub nodes: Vec<Frame>,
    /// By edge: the boxes that it passes through between its ends.
    pub vias: Vec<Vec<Frame>>,
}

/// How a name is cut for a drawing.
pub(super) fn drawn_name(name: &str) -> String {
    super::shortened(name, MOST_LETTERS)
}

fn is_wide(c: char) -> bool {
    matches!(c, 'm' | 'w' | 'M' | 'W')
}

/// How many letters of a title have room in a width.
pub(super) fn letters_in(title: &str, width: i64) -> usize {
    let mut used = 0;
    let fits = |c: &char| {
        used += if is_wide(*c) {
            WIDE_LETTER / 2
        } else {
            TITLE_LETTER
        };
        used <= width
    };
    title.chars().take_while(fits).count()
}

fn width_of(name: &str) -> i64 {
    let length = |c: char| if is_wide(c) { WIDE_LETTER } else { LETTER };
    let letters: i64 = drawn_name(name).chars().map(length).sum();
    (letters / 2 + 32).max(58)
}

impl Layout {
    /// Where everything stands in a drawing that is as wide as is asked for, or wider where a card needs it.
    pub fn of(graph: &Graph, widest: i64) -> Layout {
        let strip = STRIP.min(widest - 2 * PADDING);
        let mut layout = Layout {
            width: widest,
            height: 0,
            cards: Vec::new(),
            nodes: vec![Frame::default(); graph.nodes.len()],
            vias: vec![Vec::new(); graph.edges.len()],
        };
        // The edges within each document, by position.
        let mut inner: Vec<Vec<usize>> = vec![Vec::new(); graph.documents.len()];
        for (at, &(from, to)) in graph.edges.iter().enumerate() {
            if graph.nodes[from].document == graph.nodes[to].document {
                inner[graph.nodes[from].document].push(at);
            }
        }
        let (mut x, mut y, mut lowest) = (0, 0, 0);
        for (document, edges) in inner.iter().enumerate() {
            let start = graph.nodes.partition_point(|n| n.document < document);
            let end = graph.nodes.partition_point(|n| n.document <= document);
            if start == end {
                continue;
            }
            let (width, height) = card(&mut layout, graph, start..end, edges, strip);
            if x > 0 && x + width > widest {
                (x, y) = (0, lowest + BETWEEN_CARDS);
            }
            let frame = Frame {
                x,
                y,
                width,
                height,
            };
            for node in &mut layout.nodes[start..end] {
                (node.x, node.y) = (node.x + x, node.y + y);
            }
            for &edge in edges {
                for via in &mut layout.vias[edge] {
                    (via.x, via.y) = (via.x + x, via.y + y);
                }
            }
            layout.cards.push((document, frame));
            layout.width = layout.width.max(x + width);
            lowest = lowest.max(y + height);
            x += width + BETWEEN_CARDS;
        }
        layout.height = lowest;
        layout
    }

    /// The heights between two rows of cards.
    pub fn rows(&self) -> Vec<i64> {
        let mut starts: Vec<i64> = self.cards.iter().map(|(_, frame)| frame.y).collect();
        starts.dedup();
        let below = starts.into_iter().skip(1);
        below.map(|y| y - BETWEEN_CARDS / 2).collect()
    }
}

/// What stands at one place of a layer.
#[derive(Clone, Copy)]
enum Item {
    Node(usize),
    /// An edge passes, by its position in the graph.
    Via(usize),
}

/// Puts the nodes of one document into a card whose corner is at the origin, and says how large it is.
fn card(
    layout: &mut Layout,
    graph: &Graph,
    own: Range<usize>,
    edges: &[usize],
    strip: i64,
) -> (i64, i64) {
    let (start, number) = (own.start, own.len());
    let mut before: Vec<Vec<usize>> = vec![Vec::new(); number];
    let mut after: Vec<Vec<usize>> = vec![Vec::new(); number];
    for &edge in edges {
        let (from, to) = graph.edges[edge];
        before[to - start].push(from - start);
        after[from - start].push(to - start);
    }
    let mut depth = vec![0usize; number];
    for own in 0..number {
        let premises = before[own].iter().filter(|&&p| p < own);
        depth[own] = premises.map(|&p| depth[p] + 1).max().unwrap_or(0);
    }
    for own in 0..number {
        // What begins a chain stands next to what it is first used for.
        if before[own].is_empty()
            && let Some(first) = after[own].iter().map(|&next| depth[next]).min()
        {
            depth[own] = first.saturating_sub(1);
        }
    }
    let loose = |own: &usize| before[*own].is_empty() && after[*own].is_empty();
    let layers = 1 + depth.iter().copied().max().unwrap_or(0);
    let mut columns: Vec<Vec<Item>> = vec![Vec::new(); layers];
    let mut widths = vec![0i64; layers];
    for own in (0..number).filter(|own| !loose(own)) {
        columns[depth[own]].push(Item::Node(own));
        let width = width_of(&graph.nodes[start + own].name);
        widths[depth[own]] = widths[depth[own]].max(width);
    }
    let strip_of = strips(&widths, strip);
    // Places are kept free for long edges, as long as there are not too many of them.
    let mut budget = 4 * number + 64;
    for &edge in edges {
        let (from, to) = graph.edges[edge];
        let (from, to) = (depth[from - start], depth[to - start]);
        if to > from + 1 && strip_of[from] == strip_of[to] && budget >= to - from {
            budget -= to - from;
            for column in &mut columns[from + 1..to] {
                column.push(Item::Via(edge));
            }
        }
    }
    let mut y = TITLE;
    let width = graph.documents[graph.nodes[start].document]
        .0
        .chars()
        .count() as i64
        * 8;
    // A longer title is cut.
    let mut width = width.min(strip);
    let mut at = 0;
    while at < layers {
        let next = (at..layers)
            .find(|&l| strip_of[l] != strip_of[at])
            .unwrap_or(layers);
        if widths[at..next].iter().all(|&w| w == 0) {
            break;
        }
        let rows = slots(graph, start, &columns[at..next], &before, &depth, at);
        let mut x = PADDING;
        let mut most = 0;
        for layer in at..next {
            for (item, &row) in columns[layer].iter().zip(&rows[layer - at]) {
                most = most.max(row + 1);
                let top = y + row * ROW;
                match *item {
                    Item::Node(own) => {
                        let name = &graph.nodes[start + own].name;
                        layout.nodes[start + own] = Frame {
                            x,
                            y: top,
                            width: width_of(name),
                            height: NODE_HEIGHT,
                        };
                    }
                    Item::Via(edge) => layout.vias[edge].push(Frame {
                        x,
                        y: top,
                        width: widths[layer],
                        height: NODE_HEIGHT,
                    }),
                }
            }
            x += widths[layer] + GAP;
        }
        width = width.max(x - GAP - PADDING);
        y += most * ROW + STRIP_GAP;
        at = next;
    }
    let mut x = PADDING;
    let room = width.max(LOOSE);
    let mut any = false;
    for own in (0..number).filter(loose) {
        let own_width = width_of(&graph.nodes[start + own].name);
        if any && x + own_width > PADDING + room {
            (x, y) = (PADDING, y + ROW);
        }
        any = true;
        layout.nodes[start + own] = Frame {
            x,
            y,
            width: own_width,
            height: NODE_HEIGHT,
        };
        width = width.max(x + own_width - PADDING);
        x += own_width + 12;
    }
    if any {
        y += ROW + STRIP_GAP;
    }
    (width + 2 * PADDING, y - STRIP_GAP)
}

/// For each layer the strip that it stands in.
fn strips(widths: &[i64], widest: i64) -> Vec<usize> {
    let (mut strip, mut used) = (0, 0);
    let mut all = Vec::with_capacity(widths.len());
    for &width in widths {
        if used > 0 && used + GAP + width > widest {
            (strip, used) = (strip + 1, 0);
        }
        used += width + GAP;
        all.push(strip);
    }
    all
}

/// For each item of each layer its row: near the mean of what leads to it, so that a chain runs straight.
fn slots(
    graph: &Graph,
    start: usize,
    columns: &[Vec<Item>],
    before: &[Vec<usize>],
    depth: &[usize],
    first: usize,
) -> Vec<Vec<i64>> {
    let mut row_of_node: Tree<usize, i64> = Tree::new();
    let mut row_of_via: Tree<usize, i64> = Tree::new();
    let mut all = Vec::with_capacity(columns.len());
    for (layer, column) in columns.iter().enumerate() {
        let wish = |item: &Item| -> Option<i64> {
            let rows: Vec<i64> = match *item {
                Item::Node(own) => {
                    let edge = |p: usize| graph.edges.binary_search(&(start + p, start + own)).ok();
                    let row = |&p: &usize| match depth[p] + 1 == first + layer {
                        true => row_of_node.get(&p).copied(),
                        false => row_of_via.get(&edge(p)?).copied(),
                    };
                    before[own].iter().filter_map(row).collect()
                }
                Item::Via(edge) => {
                    let from = graph.edges[edge].0 - start;
                    let row = row_of_via.get(&edge).or_else(|| row_of_node.get(&from));
                    row.copied().into_iter().collect()
                }
            };
            let number = rows.len() as i64;
            (number > 0).then(|| 2 * rows.iter().sum::<i64>() / number)
        };
        let mut order: Vec<(i64, usize)> = column
            .iter()
            .enumerate()
            .map(|(at, item)| (wish(item).unwrap_or(i64::MAX), at))
            .collect();
        sorted::sort(&mut order);
        let mut rows = vec![0; column.len()];
        let mut next = 0;
        for (wish, at) in order {
            let row = match wish {
                i64::MAX => next,
                wish => next.max(wish / 2),
            };
            next = row + 1;
            rows[at] = row;
            match column[at] {
                Item::Node(own) => row_of_node.insert(own, row),
                Item::Via(edge) => row_of_via.insert(edge, row),
            };
        }
        all.push(rows);
    }
    all
}
