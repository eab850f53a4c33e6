//! What a picture is made of, before it is SVG, PDF or PNG: paths and text in points, the y axis pointing down.

use super::rich::Rich;

/// A picture.
#[derive(Clone, Debug)]
pub struct Scene {
    /// A short name of letters, to tell apart several pictures in one page.
    pub name: String,
    /// Its width in points.
    pub width: f64,
    /// Its height in points.
    pub height: f64,
    /// What it shows, in a few words.
    pub title: String,
    /// What is to be seen, in sentences, for those who do not see it.
    pub description: String,
    /// What is drawn, the first at the bottom.
    pub items: Vec<Item>,
    /// What is said below it, where that is a part of it.
    pub caption: Option<Caption>,
}

/// A caption that has been drawn.
#[derive(Clone, Debug)]
pub struct Caption {
    /// What it says.
    pub words: Rich,
    /// The height of the picture without it.
    pub above: f64,
    /// How many parts the picture has without it.
    pub items: usize,
    /// The description without it.
    pub description: String,
}

/// A part of a picture.
#[derive(Clone, Debug)]
pub enum Item {
    /// A path, filled, stroked or both.
    Shape(Shape),
    /// A line of text.
    Text(Text),
}

/// A path and how it is drawn.
#[derive(Clone, Debug)]
pub struct Shape {
    /// The path.
    pub path: Vec<Segment>,
    /// What it is filled with.
    pub fill: Option<Ink>,
    /// How it is stroked.
    pub stroke: Option<Stroke>,
}

/// A piece of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// Begins at a point.
    Move(f64, f64),
    /// A straight line to a point.
    Line(f64, f64),
    /// A cubic Bézier curve: two control points and the end.
    Cubic([f64; 6]),
    /// Back to the beginning.
    Close,
}

/// How a path is stroked.
#[derive(Clone, Copy, Debug)]
pub struct Stroke {
    /// With what.
    pub ink: Ink,
    /// The width in points.
    pub width: f64,
    /// Lengths drawn and left out in turn; an unbroken line if there are none.
    pub dash: &'static [f64],
}

/// Colours by what they are for. [`Palette`](super::Palette) says which they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ink {
    /// What lies under everything.
    Paper,
    /// Text and axes.
    Text,
    /// Text that matters less.
    Faint,
    /// The grid.
    Grid,
    /// A curve and what belongs to it, by its position.
    Series(usize),
}

/// A line of text.
#[derive(Clone, Debug)]
pub struct Text {
    /// Where it is anchored.
    pub x: f64,
    /// The baseline there.
    pub y: f64,
    /// The size in points.
    pub size: f64,
    /// Which part of it is there.
    pub anchor: Anchor,
    /// Turned by a quarter, so that it reads upwards.
    pub upwards: bool,
    /// Its colour.
    pub ink: Ink,
    /// What it says.
    pub content: Rich,
}

/// Which part of a text its place is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The beginning.
    Start,
    /// The middle.
    Middle,
    /// The end.
    End,
}

impl Scene {
    /// An empty picture.
    pub fn new(name: &str, width: f64, height: f64) -> Self {
        Scene {
            name: name.to_owned(),
            width,
            height,
            title: String::new(),
            description: String::new(),
            items: Vec::new(),
            caption: None,
        }
    }

    /// The picture without its caption, for a page that says below what is shown, and the caption.
    pub fn parted(mut self) -> (Scene, Rich) {
        let Some(caption) = self.caption.take() else {
            return (self, Rich::default());
        };
        self.items.truncate(caption.items);
        (self.height, self.description) = (caption.above, caption.description);
        (self, caption.words)
    }

    /// Draws lines from point to point.
    pub(super) fn line(&mut self, points: &[(f64, f64)], stroke: Stroke) {
        let place = |(at, &(x, y)): (usize, &(f64, f64))| match at {
            0 => Segment::Move(x, y),
            _ => Segment::Line(x, y),
        };
        self.items.push(Item::Shape(Shape {
            path: points.iter().enumerate().map(place).collect(),
            fill: None,
            stroke: Some(stroke),
        }));
    }

    /// Writes upright text.
    pub(super) fn text(&mut self, at: (f64, f64), anchor: Anchor, size: f64, content: Rich) {
        self.inked(at, anchor, size, Ink::Text, content);
    }

    /// Writes upright text in a colour.
    pub(super) fn inked(
        &mut self,
        (x, y): (f64, f64),
        anchor: Anchor,
        size: f64,
        ink: Ink,
        content: Rich,
    ) {
        self.items.push(Item::Text(Text {
            x,
            y,
            size,
            anchor,
            upwards: false,
            ink,
            content,
        }));
    }

    /// Covers a rectangle with paper, so that no line crosses what is written there.
    pub(super) fn clear(&mut self, left: f64, top: f64, right: f64, bottom: f64) {
        self.items.push(Item::Shape(Shape {
            path: vec![
                Segment::Move(left, top),
                Segment::Line(right, top),
                Segment::Line(right, bottom),
                Segment::Line(left, bottom),
                Segment::Close,
            ],
            fill: Some(Ink::Paper),
            stroke: None,
        }));
    }

    /// Writes a paragraph broken at its spaces; the baseline that a next line would have.
    pub(super) fn paragraph(
        &mut self,
        (x, mut y): (f64, f64),
        width: f64,
        size: f64,
        content: &Rich,
    ) -> f64 {
        for line in content.lines(width / size) {
            self.inked((x, y), Anchor::Start, size, Ink::Faint, line);
            y += 1.4 * size;
        }
        y
    }
}

impl Stroke {
    /// An unbroken line.
    pub fn solid(ink: Ink, width: f64) -> Self {
        Stroke {
            ink,
            width,
            dash: &[],
        }
    }
}
