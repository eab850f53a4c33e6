//! One document: its title, its layers strip by strip, and what nothing hangs on below them.
//!
//! What leaves or enters by the gutter does so at the left side where a statement stands in the first column of its strip.
//! Elsewhere it runs in the gap beside its column, and above the strip or below it: there are no boxes and no titles.

use std::collections::BTreeMap;
use std::ops::Range;

use super::super::Graph;
use super::columns::{Columns, Item};
use super::{
    Ends, Frame, GAP, LOOSE, NODE_HEIGHT, PADDING, Point, ROW, STRIP_GAP, TITLE, room, track,
    width_of,
};

/// An arrow runs level for so long before its tip.
const LEAD: i64 = 9;

/// A document whose corner is at the origin.
pub(super) struct Card {
    pub width: i64,
    pub height: i64,
    /// By statement.
    pub frames: Vec<Frame>,
    /// Edges that run through the layers, each with the boxes it passes, those of its ends included.
    pub through: Vec<(usize, Vec<Frame>)>,
    /// By statement: how edges get from it to the gutter, and from the gutter to it.
    pub ports: Vec<Port>,
}

/// The ways between a statement and the gutter; no points where there are none.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Port {
    /// From the statement to where the way turns to the gutter.
    pub exit: Vec<Point>,
    /// From where the way has come from the gutter to the statement.
    pub entry: Vec<Point>,
}

impl Port {
    /// The same for a card whose corner is at a point.
    pub(super) fn moved(mut self, (x, y): Point) -> Port {
        for point in self.exit.iter_mut().chain(&mut self.entry) {
            *point = (point.0 + x, point.1 + y);
        }
        self
    }

    /// Where the way to the gutter ends.
    pub fn leaves(&self) -> i64 {
        self.exit.last().map_or(0, |(_, y)| *y)
    }

    /// Where the way from the gutter begins.
    pub fn enters(&self) -> i64 {
        self.entry.first().map_or(0, |(_, y)| *y)
    }
}

/// A column of a strip, once it has a place.
#[derive(Clone, Copy, Debug, Default)]
struct Column {
    /// Between the gaps at both sides, lines that run up and down beside the boxes included.
    start: i64,
    end: i64,
    /// The left side of the boxes.
    x: i64,
}

impl Card {
    pub fn of(graph: &Graph, own: Range<usize>, edges: &[usize], far: &[Ends], strip: i64) -> Card {
        let start = own.start;
        let columns = Columns::of(graph, own.clone(), edges, far, strip);
        let mut ends = far.to_vec();
        for &edge in &columns.around {
            let (from, to) = graph.edges[edge];
            ends[from - start].begins = true;
            ends[to - start].ends = true;
        }
        let title = &graph.documents[graph.nodes[start].document].0;
        // A longer title is cut.
        let width = (title.chars().count() as i64 * 8).min(strip);
        let card = Card {
            width: width + 2 * PADDING,
            height: TITLE,
            frames: vec![Frame::default(); own.len()],
            through: Vec::new(),
            ports: vec![Port::default(); own.len()],
        };
        let mut setter = Setter {
            graph,
            start,
            ends,
            vias: BTreeMap::new(),
            stand: vec![Column::default(); own.len()],
            card,
        };
        for strip in &columns.strips {
            setter.strip(&columns, strip);
        }
        setter.loose(&columns.loose);
        setter.link(&columns.through);
        setter.card.height -= STRIP_GAP;
        setter.card
    }

    /// Whether an edge leaves or enters by the gutter.
    pub fn is_left(&self) -> bool {
        let used = |port: &Port| !port.exit.is_empty() || !port.entry.is_empty();
        self.ports.iter().any(used)
    }
}

/// A card being set.
struct Setter<'a> {
    graph: &'a Graph,
    start: usize,
    ends: Vec<Ends>,
    /// Where each edge passes, from left to right.
    vias: BTreeMap<usize, Vec<Frame>>,
    /// By statement: its column.
    stand: Vec<Column>,
    card: Card,
}

impl Setter<'_> {
    /// Sets the layers of a strip below what has been set.
    fn strip(&mut self, columns: &Columns, strip: &Range<usize>) {
        if columns.widths[strip.clone()]
            .iter()
            .all(|&width| width == 0)
        {
            return;
        }
        let rows = columns.rows(self.graph, self.start, strip);
        let most = rows.iter().flatten().max().map_or(0, |row| row + 1);
        // By layer the statements that lines run to beside the boxes, from above to below.
        let beside = |which: &dyn Fn(&Ends) -> bool| -> Vec<Vec<usize>> {
            let all = strip.clone().map(|layer| {
                let placed = columns.items[layer].iter().zip(&rows[layer - strip.start]);
                let mut own: Vec<(i64, usize)> = placed
                    .filter_map(|(item, row)| match *item {
                        Item::Node(own) if which(&self.ends[own]) => Some((*row, own)),
                        _ => None,
                    })
                    .collect();
                own.sort_unstable();
                own.into_iter().map(|(_, own)| own).collect()
            });
            all.collect()
        };
        let (entries, exits) = (beside(&|e| e.ends), beside(&|e| e.begins));
        // Above run the ways to the columns on the right, then those to what stands high: so none of them cross.
        let above: Vec<usize> = entries.iter().skip(1).rev().flatten().copied().collect();
        let below: Vec<usize> = exits
            .iter()
            .skip(1)
            .flat_map(|own| own.iter().rev())
            .copied()
            .collect();
        let top = self.card.height + room(above.len());
        let bottom = top + most * ROW;
        let mut x = PADDING;
        for layer in strip.clone() {
            let at = layer - strip.start;
            let (entries, exits) = match at {
                0 => (&[][..], &[][..]),
                _ => (&entries[at][..], &exits[at][..]),
            };
            let lead = if at == 0 { 0 } else { LEAD };
            let left = x + room(entries.len()) + lead;
            let column = Column {
                start: x,
                x: left,
                end: left + columns.widths[layer] + room(exits.len()),
            };
            self.column(&columns.items[layer], &rows[at], column, top);
            for (order, &own) in entries.iter().enumerate() {
                let x = column.x - lead - track(order, entries.len());
                self.card.ports[own].entry.push((x, 0));
            }
            for (order, &own) in exits.iter().enumerate() {
                let x = column.end - track(order, exits.len());
                self.card.ports[own].exit.push((x, 0));
            }
            x = column.end + GAP;
        }
        self.at_the_left(entries[0].iter().copied(), exits[0].iter().copied());
        for (order, &own) in above.iter().enumerate() {
            let frame = self.card.frames[own];
            let y = self.card.height + track(order, above.len());
            let entry = &mut self.card.ports[own].entry;
            let x = entry[0].0;
            *entry = vec![(x, y), (x, frame.middle()), (frame.x, frame.middle())];
        }
        for (order, &own) in below.iter().enumerate() {
            let frame = self.card.frames[own];
            let y = bottom + track(order, below.len());
            let exit = &mut self.card.ports[own].exit;
            let x = exit[0].0;
            *exit = vec![(frame.right(), frame.middle()), (x, frame.middle()), (x, y)];
        }
        self.card.width = self.card.width.max(x - GAP + PADDING);
        self.card.height = bottom + room(below.len()) + STRIP_GAP;
    }

    /// Sets what stands in a column and what passes it.
    fn column(&mut self, items: &[Item], rows: &[i64], column: Column, top: i64) {
        for (item, &row) in items.iter().zip(rows) {
            let y = top + row * ROW;
            match *item {
                Item::Node(own) => {
                    self.stand[own] = column;
                    self.card.frames[own] = Frame {
                        x: column.x,
                        y,
                        width: width_of(&self.graph.nodes[self.start + own].name),
                        height: NODE_HEIGHT,
                    };
                }
                Item::Via(edge) => self.vias.entry(edge).or_default().push(Frame {
                    x: column.start,
                    y,
                    width: column.end - column.start,
                    height: NODE_HEIGHT,
                }),
            }
        }
    }

    /// What stands in the first column is left and entered at its left side; where it is both, the ways lie apart.
    fn at_the_left(
        &mut self,
        entries: impl Iterator<Item = usize>,
        exits: impl Iterator<Item = usize>,
    ) {
        for own in entries {
            let frame = self.card.frames[own];
            self.card.ports[own].entry = vec![(frame.x, frame.middle())];
        }
        for own in exits {
            let frame = self.card.frames[own];
            let y = match self.ends[own].ends {
                true => frame.middle() + NODE_HEIGHT / 4,
                false => frame.middle(),
            };
            self.card.ports[own].exit = vec![(frame.x, y)];
        }
    }

    /// Sets in lines what nothing hangs on.
    fn loose(&mut self, loose: &[usize]) {
        let width = |own: usize| width_of(&self.graph.nodes[self.start + own].name);
        let widest = self.card.width.max(LOOSE + 2 * PADDING) - PADDING;
        let (mut x, mut y) = (PADDING, self.card.height);
        for &own in loose {
            let width = width(own);
            if x > PADDING && x + width > widest {
                (x, y) = (PADDING, y + ROW);
            }
            self.card.frames[own] = Frame {
                x,
                y,
                width,
                height: NODE_HEIGHT,
            };
            self.card.width = self.card.width.max(x + width + PADDING);
            x += width + 12;
        }
        if !loose.is_empty() {
            self.card.height = y + ROW + STRIP_GAP;
        }
    }

    /// The ways of the edges that run through the layers.
    fn link(&mut self, edges: &[usize]) {
        for &edge in edges {
            let (from, to) = self.graph.edges[edge];
            let (from, to) = (from - self.start, to - self.start);
            // A way leaves the column before it bends, and has entered the next when it has bent.
            let (first, last) = (self.card.frames[from], self.card.frames[to]);
            let mut boxes = vec![Frame {
                x: first.right(),
                width: self.stand[from].end - first.right(),
                ..first
            }];
            boxes.extend(self.vias.remove(&edge).into_iter().flatten());
            boxes.push(Frame {
                x: self.stand[to].start,
                width: last.x - self.stand[to].start,
                ..last
            });
            self.card.through.push((edge, boxes));
        }
    }
}
