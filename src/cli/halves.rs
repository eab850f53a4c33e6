//! `table`: after how many collisions no more than half of the energy is left.

use std::fmt::Write;
use std::path::Path;

use num_bigint::BigUint;
use num_rational::BigRational;
use num_traits::{One, Zero};
use serde_json::{Value, json};

use super::Failure;
use super::args::Format;
use super::csv;
use super::plot::failed;
use super::table::numbered;
use crate::audit::Verdict;
use crate::derivation::Checker;
use crate::figures::{Decay, FigureError, Law, Material, alike, exact, rounded, share};
use crate::notation::unbraced;
use crate::report::html::Table;

const TITLE: &str = "Energy lost in one collision, and collisions until no more than half is left";
/// Longer numbers are rounded where people read.
const LONGEST: usize = 12;
/// To so many decimals.
const ROUNDED: usize = 6;

/// A material with what each law says of it, the printed one first.
struct Row<'a> {
    material: &'a Material,
    laws: Vec<Said>,
}

/// What a law says of a material.
struct Said {
    /// The share of the energy that a collision costs.
    loss: BigRational,
    /// The first number of collisions that leave no more than half.
    halving: Option<BigUint>,
}

/// The format that is asked for, or that the ending of a file says where none is.
pub(super) fn format(asked: Format, file: Option<&Path>) -> Result<Format, Failure> {
    let ending = file.and_then(Path::extension);
    let ending = ending.map(|ending| ending.to_string_lossy().to_lowercase());
    let by_ending = match ending.as_deref() {
        Some("csv") => Format::Csv,
        Some("json") => Format::Json,
        Some("md" | "markdown") => Format::Markdown,
        _ => return Ok(asked),
    };
    match asked {
        Format::Human => Ok(by_ending),
        asked if asked == by_ending => Ok(asked),
        _ => Err(Failure::new(format!(
            "--format and the ending of `{}` ask for two things",
            file.unwrap_or(Path::new("")).display()
        ))
        .help("leave out --format: with -o the ending decides")),
    }
}

/// The table in the format that is asked for.
pub(super) fn halves(
    checker: &Checker,
    materials: &[Material],
    format: Format,
) -> Result<String, Failure> {
    let decay = Decay::of(checker).map_err(failed)?;
    let rows: Result<Vec<Row>, FigureError> = materials.iter().map(|m| row(&decay, m)).collect();
    let rows = rows.map_err(failed)?;
    match format {
        Format::Human => Ok(human(&decay, &rows)),
        Format::Json => super::run::pretty(&json(&decay, &rows)),
        Format::Csv => Ok(csv::csv(&cells(&decay, &rows, Format::Csv))),
        Format::Markdown => {
            let table = csv::markdown(&cells(&decay, &rows, Format::Markdown));
            let notes = notes(&decay, &rows).join("\n");
            Ok(format!("{table}\n{}\n", csv::escaped(&unbraced(&notes))))
        }
        other => Err(super::run::no_audit(other)),
    }
}

/// The table for a page, with what is to be said of it.
pub(super) fn on_a_page(checker: &Checker, materials: &[Material]) -> Result<Table, FigureError> {
    let decay = Decay::of(checker)?;
    let rows: Result<Vec<Row>, FigureError> = materials.iter().map(|m| row(&decay, m)).collect();
    let rows = rows?;
    let mut cells = cells(&decay, &rows, Format::Human).into_iter();
    Ok(Table {
        title: TITLE.to_owned(),
        head: cells.next().unwrap_or_default(),
        rows: cells.collect(),
        notes: notes(&decay, &rows),
    })
}

fn row<'a>(decay: &Decay, material: &'a Material) -> Result<Row<'a>, FigureError> {
    let said = |law: &Law| {
        Ok(Said {
            loss: BigRational::one() - share(law, material)?,
            halving: Decay::halving(law, material)?,
        })
    };
    Ok(Row {
        material,
        laws: decay.laws().map(said).collect::<Result<_, FigureError>>()?,
    })
}

/// The head and the rows, every number as text.
fn cells(decay: &Decay, rows: &[Row], format: Format) -> Vec<Vec<String>> {
    let laws = decay.laws().count();
    let head: &[&str] = match format {
        Format::Csv => &[
            "material",
            "e",
            "loss_printed",
            "half_printed",
            "loss_restitution",
            "half_restitution",
        ],
        _ => &[
            "material",
            "e",
            "loss, (41)",
            "half after, (41)",
            "loss, restitution",
            "half after, restitution",
        ],
    };
    let mut all = vec![
        head[..2 + 2 * laws]
            .iter()
            .map(|&text| text.to_owned())
            .collect(),
    ];
    let restitutions: Vec<BigRational> = rows.iter().map(restitution).collect();
    let restitutions = numbers(&restitutions, format);
    let losses = (0..laws).map(|law| {
        let losses: Vec<BigRational> = rows.iter().map(|r| r.laws[law].loss.clone()).collect();
        match format {
            Format::Csv => numbers(&losses, format),
            _ => percents(&losses),
        }
    });
    let losses: Vec<Vec<String>> = losses.collect();
    for (at, row) in rows.iter().enumerate() {
        let mut line = vec![row.material.name().to_owned(), restitutions[at].clone()];
        for (said, losses) in row.laws.iter().zip(&losses) {
            line.push(losses[at].clone());
            line.push(match &said.halving {
                Some(count) => count.to_string(),
                None => "never".to_owned(),
            });
        }
        all.push(line);
    }
    all
}

fn restitution(row: &Row) -> BigRational {
    row.material.restitution().clone()
}

/// The exact numbers of one column; for people with as many digits each.
fn numbers(values: &[BigRational], format: Format) -> Vec<String> {
    match format {
        Format::Csv => values
            .iter()
            .map(|value| exact(value).replace('−', "-"))
            .collect(),
        _ => alike(values, LONGEST),
    }
}

/// The shares of one column in per cent with as many digits each, exactly where that is short.
fn percents(shares: &[BigRational]) -> Vec<String> {
    let percents = shares
        .iter()
        .map(|share| share * BigRational::from_integer(100.into()));
    let percents: Vec<BigRational> = percents.collect();
    let is_short = |percent: &BigRational| {
        let written = exact(percent);
        written.chars().count() <= LONGEST && !written.contains('/')
    };
    // What is rounded makes nothing else longer.
    let short: Vec<BigRational> = percents.iter().filter(|p| is_short(p)).cloned().collect();
    let mut short = alike(&short, LONGEST).into_iter();
    let mut written = |percent: &BigRational| match is_short(percent) {
        true => format!("{} %", short.next().unwrap_or_default()),
        false => approximately(percent),
    };
    percents.iter().map(&mut written).collect()
}

/// A percentage that is rounded.
fn approximately(percent: &BigRational) -> String {
    match rounded(percent, ROUNDED).as_str() {
        "0" => format!("< 0.{:0>ROUNDED$} %", 1),
        text => format!("≈ {text} %"),
    }
}

fn human(decay: &Decay, rows: &[Row]) -> String {
    let mut text = format!("{TITLE}\n\n");
    text += &numbered(&cells(decay, rows, Format::Human));
    text.push('\n');
    for note in notes(decay, rows) {
        let _ = writeln!(text, "{}", unbraced(&note));
    }
    text
}

/// What the columns are, what the audit says of them, and the ends of the range of e.
fn notes(decay: &Decay, rows: &[Row]) -> Vec<String> {
    let printed = &decay.printed;
    let mut notes = vec![format!(
        "{} as printed, {}, {}.",
        printed.standing.label,
        printed.plain(),
        printed.standing.words()
    )];
    if let Some(corrected) = &decay.corrected {
        notes.push(format!(
            "Restitution gives {} in its place, as the audit has proved.",
            corrected.plain()
        ));
    } else if printed.standing.verdict != Verdict::Holds {
        notes.push("The audit has nothing in its place.".to_owned());
    }
    let has = |end: fn(&BigRational) -> bool| rows.iter().any(|r| end(r.material.restitution()));
    if has(One::is_one) {
        notes.push("At e = 1 nothing is lost, and the energy never halves.".to_owned());
    }
    if has(Zero::is_zero) {
        let at_zero = rows.iter().find(|r| r.material.restitution().is_zero());
        let left: Vec<String> = at_zero
            .into_iter()
            .flat_map(|row| &row.laws)
            .zip(["as printed", "by restitution"])
            .map(|(said, law)| {
                let left = BigRational::one() - &said.loss;
                match left.is_zero() {
                    true => format!("{law} nothing"),
                    false => format!("{law} {}", percents(&[left]).concat()),
                }
            })
            .collect();
        notes.push(format!(
            "At e = 0 the balls stay together: one collision leaves {}.",
            left.join(", ")
        ));
    }
    notes
}

fn json(decay: &Decay, rows: &[Row]) -> Value {
    let law = |law: &Law| {
        json!({
            "equation": law.standing.label,
            "latex": law.latex(),
            "verdict": law.standing.verdict.word(),
        })
    };
    let said = |said: &Said| {
        json!({
            "loss": said.loss.to_string(),
            "half_after": said.halving.as_ref().map(ToString::to_string),
        })
    };
    let row = |row: &Row| {
        json!({
            "material": row.material.name(),
            "e": row.material.restitution().to_string(),
            "printed": row.laws.first().map(said),
            "restitution": row.laws.get(1).map(said),
        })
    };
    json!({
        "printed": law(&decay.printed),
        "restitution": decay.corrected.as_ref().map(law),
        "rows": rows.iter().map(row).collect::<Vec<_>>(),
    })
}
