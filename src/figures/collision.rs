use num_traits::ToPrimitive;

use super::FigureError;
use super::figure::{Figure, Paper, Source, caption, heading, verdicts};
use super::law::{Audited, Law};
use super::legend::{self, Key};
use super::numbers::Numbers;
use super::panel::{self, Marker, Panel, Range};
use super::rich::Rich;
use super::scene::{Anchor, Ink, Scene, Stroke};
use super::words::exact;
use crate::algebra::{BigInt, BigRational};
use crate::derivation::{Checker, Point};
use crate::parallel::in_order;

/// The largest mass ratio that is drawn.
const LAST: i64 = 5;
/// Points to a unit of the mass ratio.
const FINE: i64 = 40;
/// Long dashes.
const DASHED: &[f64] = &[8.0, 4.0];
/// Dashes and dots.
const DOTTED: &[f64] = &[10.0, 3.0, 2.0, 3.0];

/// The report's first figure: what becomes of two unequal balls, against the ratio of their masses.
///
/// Both velocities, in units of that of the striker, belong to the axis at the left, the share of the energy that the
/// struck ball takes to the one at the right. They are the terms of (59), (60) and (64), evaluated exactly. Axes as
/// in the report's listing, which does not show how far its mass ratio goes; here up to 5.
///
/// # Errors
/// The derivation has not these equations.
pub fn collision(checker: &Checker) -> Result<Figure, FigureError> {
    let audited = Audited::of(checker, &["59", "60", "64"])?;
    let laws = [
        Law::of(&audited, "59", "v'_1")?,
        Law::of(&audited, "60", "v'_2")?,
        Law::of(&audited, "64", r"\eta")?,
    ];
    let before = Point::new().with("v_0", 1);
    let row = |mu: &BigRational| -> Result<Vec<BigRational>, FigureError> {
        let at = before.clone().with_ratio(r"\mu", mu.clone());
        let mut row = vec![mu.clone()];
        for law in &laws {
            row.push(law.value(&at)?);
        }
        Ok(row)
    };
    let mut numbers = Numbers::new(&["mu", "v1/v0", "v2/v0", "eta"]);
    let rows = in_order(0..=LAST * FINE, |step| {
        // A mass ratio is positive: in the place of 0 stands a small one.
        let mu = match step {
            0 => BigRational::new(BigInt::from(1), BigInt::from(1000)),
            step => BigRational::new(BigInt::from(step), BigInt::from(FINE)),
        };
        row(&mu)
    });
    numbers.rows = rows.into_iter().collect::<Result<_, _>>()?;
    let equal = row(&BigRational::from_integer(BigInt::from(1)))?;
    let sources: Vec<Source> = laws.iter().map(Source::from).collect();
    let scene = draw(Paper::Wide, &numbers, &equal, &sources);
    let narrow = draw(Paper::Narrow, &numbers, &equal, &sources);
    Ok(Figure {
        scene,
        narrow,
        numbers,
        sources,
    })
}

fn draw(paper: Paper, numbers: &Numbers, equal: &[BigRational], sources: &[Source]) -> Scene {
    let mut scene = paper.scene("collision");
    scene.title = "Elastic collision with a ball at rest, by mass ratio".into();
    scene.description = "Three curves against the mass ratio μ from 0 to 5. The striker’s velocity falls from v₀ \
        through 0 at μ = 1 to negative values; the struck ball’s falls from 2 v₀; the share of the energy that is \
        handed over rises to its maximum at μ = 1 and falls slowly."
        .into();
    let left = paper.pick(70.0, 62.0);
    let title = Rich::words("Elastic collision with a ball at rest");
    let more = heading(&mut scene, left, &title);
    let panel = Panel {
        left,
        top: 48.0 + more,
        right: paper.pick(646.0, 330.0),
        bottom: 400.0 + more,
        x: Range::linear(0.0, 5.0),
        y: Range::linear(-1.3, 2.1),
    };
    let shares = panel.with_y(Range::linear(0.0, 1.25));
    let x_ticks = [
        (0.0, "0"),
        (1.0, "1"),
        (2.0, "2"),
        (3.0, "3"),
        (4.0, "4"),
        (5.0, "5"),
    ];
    let y_ticks = [
        (-1.0, "−1.0"),
        (-0.5, "−0.5"),
        (0.0, "0.0"),
        (0.5, "0.5"),
        (1.0, "1.0"),
        (1.5, "1.5"),
        (2.0, "2.0"),
    ];
    let share_ticks = panel::shares(shares.y);
    panel.grid(&mut scene, &x_ticks, &y_ticks);
    panel.across(&mut scene, 0.0, Stroke::solid(Ink::Faint, 1.0));
    let here = Stroke {
        dash: &[3.0, 3.0],
        ..Stroke::solid(Ink::Faint, 1.2)
    };
    panel.upright(&mut scene, 1.0, here);
    let ratio = Rich::words("Mass ratio ").math("μ = m₂/m₁");
    panel.below(&mut scene, &x_ticks, &[0.5, 1.5, 2.5, 3.5, 4.5], ratio);
    let velocity = Rich::words("Velocity after, ").math("v′/v₀");
    panel.at_left(&mut scene, &y_ticks, Ink::Text, velocity);
    let share = Rich::words("Energy transfer efficiency ").math("η");
    shares.at_right(&mut scene, &share_ticks, Ink::Series(1), share);
    let curves = [
        (panel, Ink::Series(0), &[][..], Marker::Circle, "v′₁/v₀"),
        (panel, Ink::Series(2), DASHED, Marker::Square, "v′₂/v₀"),
        (shares, Ink::Series(1), DOTTED, Marker::Diamond, "η"),
    ];
    let mut keys = Vec::new();
    for (at, (panel, ink, dash, marker, name)) in curves.into_iter().enumerate() {
        let stroke = Stroke {
            dash,
            ..Stroke::solid(ink, 2.2)
        };
        panel.curve(&mut scene, &points(numbers, 0, at + 1), stroke);
        keys.push(Key {
            stroke: Some(stroke),
            marker: Some((marker, ink, false)),
            label: match at {
                2 => Rich::formula(name).and(" (right axis)"),
                _ => Rich::formula(name),
            },
        });
    }
    for (at, (panel, ink, _, marker, name)) in curves.into_iter().enumerate() {
        let place = panel.at((1.0, float(&equal[at + 1])));
        marker.draw(&mut scene, place, 4.0, ink, false);
        let value = exact(&equal[at + 1]);
        // Where curves are close, colour says whose value it is.
        let label = Rich::formula(&paper.pick(format!("{name} = {value}"), value.clone()));
        let beside = (place.0 + 9.0, place.1 - 8.0);
        scene.inked(beside, Anchor::Start, 12.0, ink, label);
    }
    let corner = paper.pick(
        (panel.right - legend::width(&keys) - 9.0, panel.top + 10.0),
        (panel.left, panel.bottom + 52.0),
    );
    legend::draw(&mut scene, corner, &keys);
    let below = panel.bottom + paper.pick(66.0, 72.0 + legend::height(&keys));
    let top = Rich::formula("μ = 1");
    let above = (panel.x_at(1.0), panel.top - 5.0);
    scene.inked(above, Anchor::Middle, 11.0, Ink::Faint, top);
    let words = Rich::words("A ball of mass ")
        .math("m₁")
        .and(" and velocity ")
        .math("v₀")
        .and(" strikes a ball of mass ")
        .math("m₂")
        .and(" at rest. Velocities by (59) and (60), the share of the energy by (64), each evaluated in exact numbers. ")
        .and(&verdicts(sources));
    caption(&mut scene, below, 24.0, &words);
    scene
}

/// Two columns as the nearest floating-point numbers, to be drawn.
pub(super) fn points(numbers: &Numbers, x: usize, y: usize) -> Vec<(f64, f64)> {
    let row = |row: &Vec<BigRational>| (float(&row[x]), float(&row[y]));
    numbers.rows.iter().map(row).collect()
}

/// The nearest floating-point number: where something is drawn, never what is said of it.
pub(super) fn float(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or_default()
}
