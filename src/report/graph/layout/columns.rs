//! The layers of a card, from left to right, and how they are parted into strips.
//!
//! A statement stands one layer to the right of the last of its premises in the same document. Layers that would make a
//! card too wide go on below, as lines of a text do. An edge that skips layers keeps a place free in each; one that
//! leads to another strip, or backwards, does not run through the layers at all.

use std::ops::Range;

use super::super::Graph;
use super::{Ends, GAP, width_of};
use crate::sorted::{self, Tree};

/// What stands at one place of a layer.
#[derive(Clone, Copy)]
pub(super) enum Item {
    /// A statement, by its position in the document.
    Node(usize),
    /// An edge passes, by its position in the graph.
    Via(usize),
}

/// The statements of one document in layers.
pub(super) struct Columns {
    /// What stands in each layer.
    pub items: Vec<Vec<Item>>,
    /// How wide the boxes of each layer are.
    pub widths: Vec<i64>,
    /// The layers of each strip.
    pub strips: Vec<Range<usize>>,
    /// By statement: its layer.
    pub depth: Vec<usize>,
    /// The edges that run through the layers of a strip.
    pub through: Vec<usize>,
    /// The edges that cannot.
    pub around: Vec<usize>,
    /// By statement: what it rests on in the document.
    before: Vec<Vec<usize>>,
    /// The statements that no edge begins or ends at.
    pub loose: Vec<usize>,
}

impl Columns {
    /// Puts the statements of a document into layers, in strips no wider than is asked for.
    pub fn of(
        graph: &Graph,
        own: Range<usize>,
        edges: &[usize],
        ends: &[Ends],
        strip: i64,
    ) -> Self {
        let (start, number) = (own.start, own.len());
        let mut before: Vec<Vec<usize>> = vec![Vec::new(); number];
        let mut after: Vec<Vec<usize>> = vec![Vec::new(); number];
        for &edge in edges {
            let (from, to) = graph.edges[edge];
            before[to - start].push(from - start);
            after[from - start].push(to - start);
        }
        let is_far = |own: usize| ends[own].begins || ends[own].ends;
        let is_loose =
            |own: &usize| before[*own].is_empty() && after[*own].is_empty() && !is_far(*own);
        let depth = depths(&before, &after, is_far);
        let layers = 1 + depth.iter().copied().max().unwrap_or(0);
        let mut items: Vec<Vec<Item>> = vec![Vec::new(); layers];
        let mut widths = vec![0i64; layers];
        for own in (0..number).filter(|own| !is_loose(own)) {
            items[depth[own]].push(Item::Node(own));
            let width = width_of(&graph.nodes[start + own].name);
            widths[depth[own]] = widths[depth[own]].max(width);
        }
        let strips = strips(&widths, strip);
        let strip_of = |layer: usize| strips.partition_point(|strip| strip.end <= layer);
        let (mut through, mut around) = (Vec::new(), Vec::new());
        // Places are kept free for long edges, as long as there are not too many of them.
        let mut budget = 4 * number + 64;
        for &edge in edges {
            let (from, to) = graph.edges[edge];
            let (from, to) = (depth[from - start], depth[to - start]);
            if from >= to || strip_of(from) != strip_of(to) || budget < to - from - 1 {
                around.push(edge);
                continue;
            }
            budget -= to - from - 1;
            through.push(edge);
            for column in &mut items[from + 1..to] {
                column.push(Item::Via(edge));
            }
        }
        Columns {
            loose: (0..number).filter(is_loose).collect(),
            items,
            widths,
            strips,
            depth,
            through,
            around,
            before,
        }
    }

    /// For each item of each layer of a strip its row: near the mean of what leads to it, so that a chain runs straight.
    pub fn rows(&self, graph: &Graph, start: usize, strip: &Range<usize>) -> Vec<Vec<i64>> {
        let mut row_of_node: Tree<usize, i64> = Tree::new();
        let mut row_of_via: Tree<usize, i64> = Tree::new();
        let mut all = Vec::with_capacity(strip.len());
        for layer in strip.clone() {
            let column = &self.items[layer];
            let wish = |item: &Item| -> Option<i64> {
                let rows: Vec<i64> = match *item {
                    Item::Node(own) => {
                        let edge =
                            |p: usize| graph.edges.binary_search(&(start + p, start + own)).ok();
                        let row = |&p: &usize| match self.depth[p] + 1 == layer {
                            true => row_of_node.get(&p).copied(),
                            false => row_of_via.get(&edge(p)?).copied(),
                        };
                        self.before[own].iter().filter_map(row).collect()
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
}

/// By statement its layer. What begins a chain stands next to what it is first used for, unless edges from other documents
/// have to find it: these come from the left.
fn depths(
    before: &[Vec<usize>],
    after: &[Vec<usize>],
    is_far: impl Fn(usize) -> bool,
) -> Vec<usize> {
    let mut depth = vec![0usize; before.len()];
    for own in 0..before.len() {
        let premises = before[own].iter().filter(|&&p| p < own);
        depth[own] = premises.map(|&p| depth[p] + 1).max().unwrap_or(0);
    }
    for own in 0..before.len() {
        if before[own].is_empty()
            && !is_far(own)
            && let Some(first) = after[own].iter().map(|&next| depth[next]).min()
        {
            depth[own] = first.saturating_sub(1);
        }
    }
    depth
}

/// The layers of each strip.
fn strips(widths: &[i64], widest: i64) -> Vec<Range<usize>> {
    let mut all = Vec::new();
    let (mut start, mut used) = (0, 0);
    for (layer, &width) in widths.iter().enumerate() {
        if used > 0 && used + GAP + width > widest {
            all.push(start..layer);
            (start, used) = (layer, 0);
        }
        used += width + GAP;
    }
    all.push(start..widths.len());
    all
}
