use super::FigureError;
use super::collision::float;
use super::decay::Decay;
use super::figure::{Figure, Paper, Source, caption, heading, verdicts};
use super::legend::{self, Key};
use super::material::Material;
use super::numbers::Numbers;
use super::panel::{Marker, Panel, Range, shares};
use super::rich::Rich;
use super::scene::{Ink, Scene, Stroke};
use super::words::{exact, rounded};
use crate::algebra::{BigInt, BigRational};
use crate::derivation::Checker;

/// How many collisions the report computes.
const COMPUTED: usize = 40;
/// How many it shows.
const SHOWN: usize = 15;
/// Markers stand at every so many.
const MARKED: usize = 5;
/// A longer coefficient is rounded in the legend.
const LONGEST: usize = 10;
/// To so many decimals.
const ROUNDED: usize = 6;
/// For what is not as printed.
const DASHED: &[f64] = &[6.0, 4.0];

/// The report's second figure: the energy that is left after *n* collisions, for balls of several materials.
///
/// Solid lines repeat the share of (41) as printed, dashed ones the share that the audit has proved in its place. The
/// energy begins at 1 J. The numbers go to 40 collisions as in the report, of which it shows 15.
///
/// # Errors
/// The derivation has not these equations, or they leave no share of the energy.
pub fn energy(checker: &Checker, materials: &[Material]) -> Result<Figure, FigureError> {
    let decay = Decay::of(checker)?;
    let mut numbers = Numbers::new(&["n"]);
    let count = |n: usize| vec![BigRational::from_integer(BigInt::from(n))];
    numbers.rows = (0..=COMPUTED).map(count).collect();
    for material in materials {
        for (law, name) in decay.laws().zip(["printed", "restitution"]) {
            numbers.columns.push(format!("{} {name}", material.name()));
            let energies = Decay::energies(law, material, COMPUTED)?;
            for (row, energy) in numbers.rows.iter_mut().zip(energies) {
                row.push(energy);
            }
        }
    }
    let mut sources = vec![Source::from(&decay.printed)];
    sources.push(decay.claim.clone().into());
    let draw = |paper| draw(paper, &decay, materials, &numbers, &sources);
    let (scene, narrow) = (draw(Paper::Wide), draw(Paper::Narrow));
    sources.extend(decay.corrected.as_ref().map(Source::from));
    Ok(Figure {
        scene,
        narrow,
        numbers,
        sources,
    })
}

fn draw(
    paper: Paper,
    decay: &Decay,
    materials: &[Material],
    numbers: &Numbers,
    sources: &[Source],
) -> Scene {
    let mut scene = paper.scene("energy");
    let title = Rich::words("Energy left after ")
        .math("n")
        .and(" collisions");
    let more = heading(&mut scene, 66.0, &title);
    let panel = Panel {
        left: 66.0,
        top: 48.0 + more,
        right: paper.pick(486.0, 382.0),
        bottom: 400.0 + more,
        x: Range::linear(0.0, SHOWN as f64),
        y: Range::linear(0.0, 1.08),
    };
    let keys = keys(decay, materials);
    let middle = (panel.top + panel.bottom - legend::height(&keys)) / 2.0;
    let corner = paper.pick(
        (panel.right + 28.0, middle.max(panel.top)),
        (24.0, panel.bottom + 52.0),
    );
    let width = (corner.0 + legend::width(&keys) + 18.0).max(scene.width);
    scene.width = width.ceil();
    scene.title = "Energy left after n collisions".into();
    scene.description = "For each material two falling curves of the energy in joule against the number of \
        collisions from 0 to 15, beginning at 1 J: a solid one by the printed law, and above it a dashed one by \
        restitution."
        .into();
    let x_ticks = [(0.0, "0"), (5.0, "5"), (10.0, "10"), (15.0, "15")];
    let y_ticks = shares(panel.y);
    panel.grid(&mut scene, &x_ticks, &y_ticks);
    let between: Vec<f64> = (0..SHOWN).map(|n| n as f64).collect();
    let number = Rich::words("Collision number ").math("n");
    panel.below(&mut scene, &x_ticks, &between, number);
    let left = Rich::words("Kinetic energy ").math("E_n").and(" (J)");
    panel.at_left(&mut scene, &y_ticks, Ink::Text, left);
    let laws = decay.laws().count();
    let curve = |column: usize| -> Vec<(f64, f64)> {
        let rows = numbers.rows.iter().take(SHOWN + 1).enumerate();
        rows.map(|(n, row)| (n as f64, float(&row[column])))
            .collect()
    };
    // The printed law is drawn last: where both fall together, it is the one that is seen.
    for law in (0..laws).rev() {
        for at in 0..materials.len() {
            let (points, ink) = (curve(1 + at * laws + law), Ink::Series(at));
            panel.curve(&mut scene, &points, stroke(ink, law));
            for &point in points.iter().step_by(MARKED) {
                marker(at).draw(&mut scene, panel.at(point), 3.6, ink, law == 1);
            }
        }
    }
    legend::draw(&mut scene, corner, &keys);
    let mut words = Rich::words("Solid: ")
        .and(&decay.printed.standing.label)
        .and(" as printed, ")
        .math(&decay.printed.plain())
        .and(", used again after each collision, as claim energy-decay does. ");
    if let Some(corrected) = &decay.corrected {
        words = words
            .and("Dashed: what conservation of momentum and restitution give in its place, ")
            .math(&corrected.plain())
            .and(", as the audit has proved. ");
    }
    let legend_ends = corner.1 + legend::height(&keys);
    let below = paper.pick(
        (panel.bottom + 66.0).max(legend_ends + 16.0),
        legend_ends + 20.0,
    );
    caption(&mut scene, below, 24.0, &words.and(&verdicts(sources)));
    scene
}

fn stroke(ink: Ink, law: usize) -> Stroke {
    match law {
        0 => Stroke::solid(ink, 2.2),
        _ => Stroke {
            dash: DASHED,
            ..Stroke::solid(ink, 1.6)
        },
    }
}

/// A coefficient of the legend: as given where that is short.
fn restitution(material: &Material) -> String {
    let value = material.restitution();
    let written = exact(value);
    match written.chars().count() <= LONGEST {
        true => format!("= {written}"),
        false => format!("≈ {}", rounded(value, ROUNDED)),
    }
}

fn marker(at: usize) -> Marker {
    Marker::ALL[at % Marker::ALL.len()]
}

fn keys(decay: &Decay, materials: &[Material]) -> Vec<Key> {
    let mut keys = vec![Key {
        stroke: None,
        marker: None,
        label: Rich::words("Material, coefficient ").math("e"),
    }];
    for (at, material) in materials.iter().enumerate() {
        let ink = Ink::Series(at);
        keys.push(Key {
            stroke: Some(stroke(ink, 0)),
            marker: Some((marker(at), ink, false)),
            label: Rich::words(material.name())
                .and(", ")
                .math(&format!("e {}", restitution(material))),
        });
    }
    keys.push(Key::heading(""));
    keys.push(Key::heading("What one collision leaves"));
    for (at, law) in decay.laws().enumerate() {
        let name = match at {
            0 => Rich::words(&law.standing.label)
                .and(" as printed: ")
                .and(&law.standing.words()),
            _ => Rich::words("by restitution: proved"),
        };
        keys.push(Key {
            stroke: Some(stroke(Ink::Text, at)),
            marker: Some((Marker::Circle, Ink::Text, at == 1)),
            label: name,
        });
    }
    keys
}
