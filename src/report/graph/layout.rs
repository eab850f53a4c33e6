//! Where everything in a drawing stands and runs: a card for each document, and at their left a gutter for what leaves them.
//!
//! `columns` puts the statements of a document into layers from left to right, `card` gives each its place, and
//! `gutter` leads every edge that does not run through the layers of one card around all boxes and titles. Cards
//! stand below each other in reading order, side by side where no such edge begins or ends in them. All is in whole
//! units, and the work grows with the number of statements and edges.

mod card;
mod columns;
mod gutter;

use super::Graph;
use card::Card;
pub(super) use card::Port;

/// Sizes, in units of the drawing.
pub(super) const NODE_HEIGHT: i64 = 26;
const ROW: i64 = 34;
const GAP: i64 = 30;
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
/// Statements that nothing hangs on stand in lines of this width.
const LOOSE: i64 = 520;
const BETWEEN_CARDS: i64 = 18;
/// From one line to the next that runs beside it.
const TRACK: i64 = 7;
/// How much room lines beside each other may take; where they are many, they come closer.
const MOST_TRACKS: i64 = 90;

/// A point of the drawing.
pub(super) type Point = (i64, i64);

/// A box.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Frame {
    pub x: i64,
    pub y: i64,
    pub width: i64,
    pub height: i64,
}

impl Frame {
    fn right(&self) -> i64 {
        self.x + self.width
    }

    /// Half-way down.
    pub fn middle(&self) -> i64 {
        self.y + self.height / 2
    }
}

/// Where everything stands.
pub(super) struct Layout {
    /// The room at the left of the cards, whose corner is the origin.
    pub left: i64,
    pub width: i64,
    pub height: i64,
    /// Document and box.
    pub cards: Vec<(usize, Frame)>,
    /// By node.
    pub nodes: Vec<Frame>,
    /// By node: the ways to the gutter and from it.
    pub ports: Vec<Port>,
    /// By edge.
    pub routes: Vec<Route>,
}

/// How an edge runs.
#[derive(Clone, Debug)]
pub(super) enum Route {
    /// Through the layers of a card; within each box that it passes it runs level, and between two it bends.
    Through(Vec<Frame>),
    /// Around all that stands in the way: from the exit of its beginning, up or down at this place in the gutter, and
    /// by the entry of its end.
    Around(i64),
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

/// How much room a number of lines beside each other take.
fn room(tracks: usize) -> i64 {
    (tracks as i64 * TRACK).min(MOST_TRACKS)
}

/// Where one of several lines beside each other runs, from the beginning of their room.
fn track(at: usize, tracks: usize) -> i64 {
    (2 * at as i64 + 1) * room(tracks) / (2 * tracks as i64)
}

/// Edges by where they run, before anything has a place.
struct Parted {
    /// The edges within each document, by position.
    inner: Vec<Vec<usize>>,
    /// By node: whether an edge to or from another document ends here.
    ends: Vec<Ends>,
}

/// Whether edges that run around the boxes begin or end at a statement.
#[derive(Clone, Copy, Debug, Default)]
struct Ends {
    begins: bool,
    ends: bool,
}

impl Parted {
    fn of(graph: &Graph) -> Parted {
        let mut inner = vec![Vec::new(); graph.documents.len()];
        let mut ends = vec![Ends::default(); graph.nodes.len()];
        for (at, &(from, to)) in graph.edges.iter().enumerate() {
            let document = graph.nodes[from].document;
            match document == graph.nodes[to].document {
                true => inner[document].push(at),
                false => (ends[from].begins, ends[to].ends) = (true, true),
            }
        }
        Parted { inner, ends }
    }
}

impl Layout {
    /// Where everything stands in a drawing whose cards are no wider than is asked for, unless one cannot be.
    pub fn of(graph: &Graph, widest: i64) -> Layout {
        let strip = STRIP.min(widest - 2 * PADDING);
        let parted = Parted::of(graph);
        let mut layout = Layout {
            left: 0,
            width: LOOSE,
            height: 0,
            cards: Vec::new(),
            nodes: vec![Frame::default(); graph.nodes.len()],
            ports: vec![Port::default(); graph.nodes.len()],
            routes: vec![Route::Around(0); graph.edges.len()],
        };
        let (mut x, mut y) = (0, 0);
        for (document, edges) in parted.inner.iter().enumerate() {
            let start = graph.nodes.partition_point(|n| n.document < document);
            let end = graph.nodes.partition_point(|n| n.document <= document);
            if start == end {
                continue;
            }
            let card = Card::of(graph, start..end, edges, &parted.ends[start..end], strip);
            if x > 0 && (card.is_left() || x + card.width > widest) {
                (x, y) = (0, layout.height + BETWEEN_CARDS);
            }
            let (width, height) = (card.width, card.height);
            layout.take(card, document, start, (x, y));
            layout.width = layout.width.max(x + width);
            layout.height = layout.height.max(y + height);
            x += width + BETWEEN_CARDS;
        }
        layout.left = gutter::lead(graph, &layout.ports, &mut layout.routes);
        layout
    }

    /// Takes in a card, moved to its place.
    fn take(&mut self, card: Card, document: usize, start: usize, (x, y): Point) {
        let moved = |frame: Frame| Frame {
            x: frame.x + x,
            y: frame.y + y,
            ..frame
        };
        for (own, frame) in card.frames.into_iter().enumerate() {
            self.nodes[start + own] = moved(frame);
        }
        for (edge, boxes) in card.through {
            self.routes[edge] = Route::Through(boxes.into_iter().map(moved).collect());
        }
        for (own, port) in card.ports.into_iter().enumerate() {
            self.ports[start + own] = port.moved((x, y));
        }
        let frame = Frame {
            x,
            y,
            width: card.width,
            height: card.height,
        };
        self.cards.push((document, frame));
    }

    /// The heights between two rows of cards.
    pub fn rows(&self) -> Vec<i64> {
        let mut starts: Vec<i64> = self.cards.iter().map(|(_, frame)| frame.y).collect();
        starts.dedup();
        let below = starts.into_iter().skip(1);
        below.map(|y| y - BETWEEN_CARDS / 2).collect()
    }
}
