//! Axes: a rectangle in which values have places.

use super::rich::Rich;
use super::scene::{Anchor, Ink, Item, Scene, Segment, Shape, Stroke, Text};

/// The size of what stands at the ticks.
pub(super) const SMALL: f64 = 11.0;
/// The size of titles of axes, and of legends.
pub(super) const MEDIUM: f64 = 13.0;
/// The size of the picture's title.
pub(super) const LARGE: f64 = 15.0;
/// Of captions.
pub(super) const CAPTION: f64 = 10.5;
/// The length of a tick.
const TICK: f64 = 4.0;

/// The values that an axis goes through.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    /// The value at the left, or at the bottom.
    pub from: f64,
    /// The value at the other end.
    pub to: f64,
    /// Equal ratios are equally far apart, rather than equal differences.
    pub logarithmic: bool,
}

impl Range {
    pub(super) fn linear(from: f64, to: f64) -> Self {
        Range {
            from,
            to,
            logarithmic: false,
        }
    }

    pub(super) fn logarithmic(from: f64, to: f64) -> Self {
        Range {
            from,
            to,
            logarithmic: true,
        }
    }

    /// How far along a value is, from 0 to 1.
    fn share(&self, value: f64) -> f64 {
        match self.logarithmic {
            true => (value / self.from).ln() / (self.to / self.from).ln(),
            false => (value - self.from) / (self.to - self.from),
        }
    }
}

/// Where on an axis something is written.
pub(super) type Tick<'a> = (f64, &'a str);

/// The ticks of shares, up to a little more than all.
const SHARES: [Tick<'static>; 7] = [
    (0.0, "0.0"),
    (0.2, "0.2"),
    (0.4, "0.4"),
    (0.6, "0.6"),
    (0.8, "0.8"),
    (1.0, "1.0"),
    (1.2, "1.2"),
];

/// The ticks of an axis for shares of a whole, as far as it goes.
pub(super) fn shares(axis: Range) -> Vec<Tick<'static>> {
    let on_it = |(value, _): &Tick| *value <= axis.to;
    SHARES.into_iter().filter(on_it).collect()
}

/// A rectangle with an axis below it and one at its side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Panel {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
    pub x: Range,
    pub y: Range,
}

impl Panel {
    /// The same rectangle with another axis at its side.
    pub(super) fn with_y(self, y: Range) -> Self {
        Panel { y, ..self }
    }

    pub(super) fn x_at(&self, value: f64) -> f64 {
        self.left + (self.right - self.left) * self.x.share(value)
    }

    pub(super) fn y_at(&self, value: f64) -> f64 {
        self.bottom - (self.bottom - self.top) * self.y.share(value)
    }

    pub(super) fn at(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (self.x_at(x), self.y_at(y))
    }

    /// A curve through points.
    pub(super) fn curve(&self, scene: &mut Scene, points: &[(f64, f64)], stroke: Stroke) {
        let places: Vec<(f64, f64)> = points.iter().map(|&point| self.at(point)).collect();
        scene.line(&places, stroke);
    }

    /// A line across at a value of the axis at the side.
    pub(super) fn across(&self, scene: &mut Scene, value: f64, stroke: Stroke) {
        let y = self.y_at(value);
        scene.line(&[(self.left, y), (self.right, y)], stroke);
    }

    /// A line upright at a value of the axis below.
    pub(super) fn upright(&self, scene: &mut Scene, value: f64, stroke: Stroke) {
        let x = self.x_at(value);
        scene.line(&[(x, self.top), (x, self.bottom)], stroke);
    }

    /// The lines of the grid, at the ticks of both axes.
    pub(super) fn grid(&self, scene: &mut Scene, x: &[Tick], y: &[Tick]) {
        for (value, _) in x {
            self.upright(scene, *value, Stroke::solid(Ink::Grid, 0.75));
        }
        for (value, _) in y {
            self.across(scene, *value, Stroke::solid(Ink::Grid, 0.75));
        }
    }

    /// The axis below, with small ticks between the others.
    pub(super) fn below(&self, scene: &mut Scene, ticks: &[Tick], between: &[f64], title: Rich) {
        let y = self.bottom;
        let line = Stroke::solid(Ink::Text, 1.0);
        scene.line(&[(self.left, y), (self.right, y)], line);
        for value in between {
            let x = self.x_at(*value);
            scene.line(&[(x, y), (x, y + TICK / 2.0)], line);
        }
        for (value, label) in ticks {
            let x = self.x_at(*value);
            scene.line(&[(x, y), (x, y + TICK)], line);
            scene.text(
                (x, y + TICK + 1.1 * SMALL),
                Anchor::Middle,
                SMALL,
                Rich::formula(label),
            );
        }
        let middle = (self.left + self.right) / 2.0;
        let below = y + TICK + 1.1 * SMALL + 1.6 * MEDIUM;
        scene.text((middle, below), Anchor::Middle, MEDIUM, title);
    }

    /// The axis at the left.
    pub(super) fn at_left(&self, scene: &mut Scene, ticks: &[Tick], ink: Ink, title: Rich) {
        self.side(scene, ticks, ink, title, self.left, -1.0);
    }

    /// The axis at the right.
    pub(super) fn at_right(&self, scene: &mut Scene, ticks: &[Tick], ink: Ink, title: Rich) {
        self.side(scene, ticks, ink, title, self.right, 1.0);
    }

    fn side(
        &self,
        scene: &mut Scene,
        ticks: &[Tick],
        ink: Ink,
        title: Rich,
        x: f64,
        outwards: f64,
    ) {
        let line = Stroke::solid(ink, 1.0);
        scene.line(&[(x, self.top), (x, self.bottom)], line);
        let anchor = match outwards > 0.0 {
            true => Anchor::Start,
            false => Anchor::End,
        };
        let mut widest: f64 = 0.0;
        for (value, label) in ticks {
            let y = self.y_at(*value);
            scene.line(&[(x, y), (x + outwards * TICK, y)], line);
            let label = Rich::formula(label);
            widest = widest.max(label.width() * SMALL);
            let place = (x + outwards * (TICK + 3.0), y + 0.36 * SMALL);
            scene.inked(place, anchor, SMALL, ink, label);
        }
        // Read upwards on either side, the baseline towards the right.
        let beside = x + outwards * (TICK + 3.0 + widest + 0.9 * MEDIUM);
        scene.items.push(Item::Text(Text {
            x: beside + 0.36 * MEDIUM,
            y: (self.top + self.bottom) / 2.0,
            size: MEDIUM,
            anchor: Anchor::Middle,
            upwards: true,
            ink,
            content: title,
        }));
    }
}

/// The form of a marker: told apart without colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Marker {
    Circle,
    Square,
    Triangle,
    Diamond,
    Downwards,
    Cross,
    Hexagon,
    Star,
}

impl Marker {
    /// In the order in which they are used.
    pub(super) const ALL: [Marker; 8] = [
        Marker::Circle,
        Marker::Square,
        Marker::Triangle,
        Marker::Diamond,
        Marker::Downwards,
        Marker::Cross,
        Marker::Hexagon,
        Marker::Star,
    ];

    /// Draws it, filled or open.
    pub(super) fn draw(
        self,
        scene: &mut Scene,
        (x, y): (f64, f64),
        size: f64,
        ink: Ink,
        open: bool,
    ) {
        let corner = |turn: f64, reach: f64| {
            let angle = turn * std::f64::consts::TAU;
            (
                x + reach * size * angle.sin(),
                y - reach * size * angle.cos(),
            )
        };
        let polygon = |corners: usize, first: f64, reach: f64| -> Vec<(f64, f64)> {
            let turn = |at: usize| first + at as f64 / corners as f64;
            (0..corners).map(|at| corner(turn(at), reach)).collect()
        };
        let star = |points: usize, inner: f64, first: f64| -> Vec<(f64, f64)> {
            let each = |at: usize| {
                let turn = first + at as f64 / (2 * points) as f64;
                corner(turn, if at.is_multiple_of(2) { 1.3 } else { inner })
            };
            (0..2 * points).map(each).collect()
        };
        let corners = match self {
            Marker::Circle => Vec::new(),
            Marker::Square => polygon(4, 0.125, 1.25),
            Marker::Triangle => polygon(3, 0.0, 1.3),
            Marker::Diamond => polygon(4, 0.0, 1.35),
            Marker::Downwards => polygon(3, 0.5, 1.3),
            Marker::Cross => star(4, 0.45, 0.0),
            Marker::Hexagon => polygon(6, 0.0, 1.15),
            Marker::Star => star(5, 0.55, 0.0),
        };
        let path = match corners.split_first() {
            None => circle((x, y), size),
            Some((&(x, y), rest)) => {
                let mut path = vec![Segment::Move(x, y)];
                path.extend(rest.iter().map(|&(x, y)| Segment::Line(x, y)));
                path.push(Segment::Close);
                path
            }
        };
        scene.items.push(Item::Shape(Shape {
            path,
            fill: Some(if open { Ink::Paper } else { ink }),
            stroke: Some(Stroke::solid(ink, 1.4)),
        }));
    }
}

/// A circle as four cubic curves.
pub(super) fn circle((x, y): (f64, f64), radius: f64) -> Vec<Segment> {
    // The usual distance of the control points, at which a quarter is right to three thousandths of a per cent.
    let reach = radius * 4.0 / 3.0 * (std::f64::consts::SQRT_2 - 1.0);
    let r = radius;
    vec![
        Segment::Move(x + r, y),
        Segment::Cubic([x + r, y + reach, x + reach, y + r, x, y + r]),
        Segment::Cubic([x - reach, y + r, x - r, y + reach, x - r, y]),
        Segment::Cubic([x - r, y - reach, x - reach, y - r, x, y - r]),
        Segment::Cubic([x + reach, y - r, x + r, y - reach, x + r, y]),
        Segment::Close,
    ]
}
