use num_traits::Zero;

use super::FigureError;
use super::collision::float;
use super::figure::{Figure, Paper, Source, caption, heading, verdicts};
use super::law::{Audited, Standing, cited};
use super::legend::{self, Key};
use super::numbers::Numbers;
use super::panel::{Marker, circle};
use super::rich::Rich;
use super::scene::{Anchor, Ink, Item, Scene, Shape, Stroke};
use super::words::{exact, list};
use crate::algebra::{BigInt, BigRational, Formula, Symbol};
use crate::derivation::{Checker, Equation, Point, goals};
use crate::parallel::in_order;
use crate::sorted::{self, Tree};

/// Points on the circle.
const FINE: i32 = 90;
/// A direction is rounded to so many parts of its length.
const ROUNDED: f64 = 100.0;

/// The velocities of three balls.
type Outcome = [BigRational; 3];

/// What two conservation laws leave open for three balls of which one comes in.
///
/// The outcomes that keep momentum, (17), and energy, (18), are a circle in the space of the three velocities. On it
/// lie the outcome in which the first ball's velocity goes to the last, and the counterexamples that the audit has
/// found to what the report concludes. Only an arc has the balls in an order in which they do not meet again.
///
/// Each point is rational: it is found on a line through a known one, and both equations are evaluated at it.
///
/// # Errors
/// The derivation has not these equations, or they are not what is drawn.
pub fn outcomes(checker: &Checker) -> Result<Figure, FigureError> {
    let conserved = Conserved::of(checker)?;
    let found = in_order(0..FINE, |step| conserved.checked(on_circle(step)));
    let mut around = found.into_iter().collect::<Result<Vec<Outcome>, _>>()?;
    // Where the arc of the ordered outcomes begins and ends.
    for end in [swap(), outcome([-1, 2, 2], 3)] {
        around.push(conserved.checked(end)?);
    }
    sorted::sort_by(&mut around, |a, b| angle(a).total_cmp(&angle(b)));
    around.dedup();
    // The counterexamples are those of all the page, which begins with the two laws.
    let of_page = checker.derivation().equations.iter();
    let of_page = of_page.filter(|equation| equation.page == conserved.page);
    let of_page: Vec<String> = of_page.map(Equation::reference).collect();
    let shown = ["17", "18", "22", "23", "24", "claim n-in-n-out"];
    let labels: Vec<&str> = of_page.iter().map(String::as_str).chain(shown).collect();
    let audited = Audited::of(checker, &labels)?;
    let witnesses = witnesses(checker, &audited, &conserved);
    let mut sources = Vec::new();
    for label in shown {
        sources.push(Source::from(Standing::of(&audited, label)?));
    }
    let mut numbers = Numbers::new(&["v1", "v2", "v3"]);
    numbers.rows = around.iter().map(|outcome| outcome.to_vec()).collect();
    let scene = draw(Paper::Wide, &around, &witnesses, &sources);
    let narrow = draw(Paper::Narrow, &around, &witnesses, &sources);
    Ok(Figure {
        scene,
        narrow,
        numbers,
        sources,
    })
}

fn outcome(above: [i64; 3], below: i64) -> Outcome {
    above.map(|above| BigRational::new(BigInt::from(above), BigInt::from(below)))
}

/// The first ball's velocity goes to the last.
fn swap() -> Outcome {
    outcome([0, 0, 1], 1)
}

/// Where a line of sight from the swap at an angle leaves the circle: floating point chooses the direction, the point is exact.
fn on_circle(step: i32) -> Outcome {
    let angle = f64::from(step) / f64::from(FINE) * std::f64::consts::PI;
    let (sine, cosine) = angle.sin_cos();
    let (x, y) = (cosine, sine / 3.0_f64.sqrt());
    let part = |value: f64| (value * ROUNDED).round() as i64;
    // The velocities change by what leaves their sum alone.
    let (first, second) = (part(-x - y), part(x - y));
    let third = -(first + second);
    let length = first * first + second * second + third * third;
    if length == 0 {
        return swap();
    }
    // From (0, 0, 1) as far again as to where the way is at a right angle to the radius.
    let far = -2 * third;
    outcome([first * far, second * far, third * far + length], length)
}

/// The two laws that every outcome drawn keeps, as the page states them.
struct Conserved<'a> {
    /// The page that states them.
    page: usize,
    /// How each is cited, and what it says.
    laws: Vec<(&'a Equation, Vec<Formula>)>,
    /// What there is besides the outcome: one of three balls comes in, with velocity 1.
    before: Point,
}

impl<'a> Conserved<'a> {
    fn of(checker: &'a Checker) -> Result<Self, FigureError> {
        let law = |label: &str| {
            let equation = checker.equation(label);
            let equation = equation.ok_or_else(|| FigureError::NoEquation(label.to_owned()))?;
            let said = equation.statements().iter().flat_map(goals);
            Ok((equation, said.map(|goal| goal.formula).collect()))
        };
        let laws = ["17", "18"].map(law).into_iter();
        let laws: Vec<(&Equation, Vec<Formula>)> = laws.collect::<Result<_, FigureError>>()?;
        Ok(Conserved {
            page: laws[0].0.page,
            laws,
            before: Point::new().with("n", 1).with("k", 3).with("v_0", 1),
        })
    }

    /// The outcome, if it keeps both laws.
    fn checked(&self, outcome: Outcome) -> Result<Outcome, FigureError> {
        let at = self.before.clone();
        let at = at.with_list("u", outcome.iter().cloned());
        for (equation, said) in &self.laws {
            for formula in said {
                let holds = at.holds(formula);
                let holds = holds.map_err(|error| FigureError::Evaluate {
                    label: equation.reference(),
                    error,
                })?;
                if !holds {
                    return Err(FigureError::NotConserved(equation.reference()));
                }
            }
        }
        Ok(outcome)
    }
}

/// The audit's counterexamples in which one of three balls comes in, with the equations that each of them refutes.
fn witnesses(
    checker: &Checker,
    audited: &Audited<'_>,
    conserved: &Conserved<'_>,
) -> Vec<(Outcome, Vec<String>)> {
    let mut found: Tree<Outcome, Vec<String>> = Tree::new();
    for entry in audited.entries() {
        for judged in &entry.judged {
            let crate::audit::Outcome::Refuted(refuted) = &judged.outcome else {
                continue;
            };
            let witness = refuted.witness();
            let symbol = |name: &str| witness.symbols.get(&Symbol::new(name));
            let (Some(n), Some(k), Some(speed), Some(all)) = (
                symbol("n"),
                symbol("k"),
                symbol("v_0"),
                witness.sequences.get(&Symbol::new("u")),
            ) else {
                continue;
            };
            let one = BigRational::from_integer(BigInt::from(1));
            let three = BigRational::from_integer(BigInt::from(3));
            if *n != one || *k != three || speed.is_zero() || all.len() < 3 {
                continue;
            }
            let outcome = [0, 1, 2].map(|at| &all[at] / speed);
            let Ok(outcome) = conserved.checked(outcome) else {
                continue;
            };
            let labels = found.entry(outcome).or_default();
            let label = cited(checker, entry.equation);
            if !labels.contains(&label) {
                labels.push(label);
            }
        }
    }
    found.into_entries().collect()
}

/// The plane in which momentum is what it was, seen at a right angle; the third velocity grows upwards.
fn seen(outcome: &Outcome) -> (f64, f64) {
    let [first, second, third] = [0, 1, 2].map(|at| float(&outcome[at]));
    let across = (second - first) / 2.0_f64.sqrt();
    let up = (2.0 * third - first - second) / 6.0_f64.sqrt();
    (across, up)
}

/// The direction from the middle, clockwise from the top, up to a full turn.
fn angle(outcome: &Outcome) -> f64 {
    let (across, up) = seen(outcome);
    across.atan2(up).rem_euclid(std::f64::consts::TAU)
}

/// That no ball is behind a faster one.
fn ordered(outcome: &Outcome) -> bool {
    outcome[0] <= outcome[1] && outcome[1] <= outcome[2]
}

fn vector(outcome: &Outcome) -> String {
    let parts: Vec<String> = outcome.iter().map(exact).collect();
    format!("({})", parts.join(", "))
}

fn draw(
    paper: Paper,
    around: &[Outcome],
    witnesses: &[(Outcome, Vec<String>)],
    sources: &[Source],
) -> Scene {
    let mut scene = paper.scene("outcomes");
    scene.title = "What two conservation laws leave open for three balls".into();
    scene.description = "A circle in the plane of the outcomes that conserve momentum: on it kinetic energy is \
        conserved too. An arc of a sixth of it holds the outcomes in which the balls do not meet again; the swap is one \
        end of the arc, and a counterexample of the audit the other."
        .into();
    let title = Rich::words("One of three balls comes in: what two conservation laws leave open");
    let more = heading(&mut scene, 24.0, &title);
    let unit = paper.pick(165.0, 140.0);
    let middle = (paper.pick(190.0, 165.0), 67.0 + unit + more);
    let place = |outcome: &Outcome| {
        let (across, up) = seen(outcome);
        (middle.0 + unit * across, middle.1 - unit * up)
    };
    // The three velocities as directions; those of which two are equal as lines through the middle.
    for (ball, end) in [[1, 0, 0], [0, 1, 0], [0, 0, 1]].into_iter().enumerate() {
        let (across, up) = seen(&outcome(end, 1));
        let tip = |reach: f64| {
            (
                middle.0 + unit * reach * across,
                middle.1 - unit * reach * up,
            )
        };
        scene.line(&[tip(-1.0), tip(1.18)], Stroke::solid(Ink::Grid, 1.0));
        let (x, y) = tip(1.3);
        let label = Rich::formula(&format!("v_{}", ball + 1));
        scene.inked((x, y + 4.0), Anchor::Middle, 12.0, Ink::Faint, label);
    }
    let closed: Vec<(f64, f64)> = around.iter().chain(around.first()).map(place).collect();
    scene.line(&closed, Stroke::solid(Ink::Faint, 1.4));
    let arc: Vec<(f64, f64)> = around.iter().filter(|o| ordered(o)).map(place).collect();
    scene.line(&arc, Stroke::solid(Ink::Series(0), 4.5));
    let before = outcome([1, 0, 0], 1);
    let mut keys = vec![
        Key {
            stroke: Some(Stroke::solid(Ink::Faint, 1.4)),
            marker: None,
            label: Rich::words("momentum and energy are conserved"),
        },
        Key {
            stroke: Some(Stroke::solid(Ink::Series(0), 4.5)),
            marker: None,
            label: Rich::words("and no ball is behind a faster one"),
        },
        Key::heading(""),
    ];
    let marks = [
        (
            before,
            Marker::Square,
            Ink::Text,
            true,
            "as the balls came in".to_owned(),
        ),
        (
            swap(),
            Marker::Circle,
            Ink::Series(2),
            false,
            "the swap: the last ball leaves alone".to_owned(),
        ),
    ];
    let refuting = witnesses.iter().map(|(outcome, labels)| {
        let what = format!("counterexample to {}", list(labels));
        (
            outcome.clone(),
            Marker::Diamond,
            Ink::Series(1),
            false,
            what,
        )
    });
    for (outcome, marker, ink, open, what) in marks.into_iter().chain(refuting) {
        let (x, y) = place(&outcome);
        marker.draw(&mut scene, (x, y), 5.0, ink, open);
        // Away from the middle, where nothing else is drawn.
        let outwards = if x < middle.0 - 1.0 { -1.0 } else { 1.0 };
        let anchor = if outwards < 0.0 {
            Anchor::End
        } else {
            Anchor::Start
        };
        let (label_x, label_y) = (x + outwards * 11.0, y - 9.0);
        let label = Rich::formula(&vector(&outcome));
        scene.inked((label_x, label_y), anchor, 12.0, ink, label);
        keys.push(Key {
            stroke: None,
            marker: Some((marker, ink, open)),
            label: Rich::words(&what),
        });
    }
    scene.items.push(Item::Shape(Shape {
        path: circle(middle, 2.0),
        fill: Some(Ink::Faint),
        stroke: None,
    }));
    let corner = paper.pick(
        (middle.0 + unit + 85.0, 150.0),
        (24.0, middle.1 + unit + 25.0),
    );
    scene.width = scene
        .width
        .max((corner.0 + legend::width(&keys) + 18.0).ceil());
    legend::draw(&mut scene, corner, &keys);
    let below = paper.pick(430.0, corner.1 + legend::height(&keys) + 20.0);
    let words = Rich::words("Equal elastic balls, the first arriving with velocity 1. The plane is that of ")
        .math("v₁ + v₂ + v₃ = 1")
        .and(", equation (17); on the circle ")
        .math("v₁² + v₂² + v₃² = 1")
        .and(
            ", equation (18). Each point drawn is rational, and both equations are true at it. Conservation alone does \
             not single out the last ball: it leaves the whole circle, and the order of the balls an arc of it. ",
        );
    caption(&mut scene, below, 24.0, &words.and(&verdicts(sources)));
    scene
}
