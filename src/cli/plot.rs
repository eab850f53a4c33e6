//! `plot`: a figure as a picture in a file, or on standard output as SVG or as numbers.

use std::path::Path;

use clap::{Args, Subcommand};
use serde_json::{Value, json};

use super::Failure;
use super::args::Format;
use super::csv;
use super::output::Content;
use crate::cradle::parse_exact;
use crate::figures::{self, Figure, FigureError, Material, rounded};
use crate::proofs;

/// Decimals in CSV; JSON has the exact fractions.
const DECIMALS: usize = 12;

/// Which figure.
#[derive(Clone, Debug, Subcommand)]
pub enum Plot {
    /// Velocities and energy transfer of an elastic collision against the mass ratio: (59), (60), (64).
    Collision,
    /// The energy left after n collisions, by (41) as printed and by restitution.
    Energy {
        /// The materials.
        #[command(flatten)]
        materials: Materials,
    },
    /// What two conservation laws leave open for three balls.
    Outcomes {
        /// How many balls. Only with three is it a curve.
        #[arg(long, value_name = "NUMBER", default_value_t = 3)]
        balls: usize,
    },
    /// Energy transfer over six powers of ten of the mass ratio: (64) and its limits.
    Lithotripsy,
}

/// Balls of several materials.
#[derive(Clone, Debug, Args)]
pub struct Materials {
    /// A material and its coefficient of restitution, from 0 to 1: `steel=0.98`, `cork=3/5`. To be repeated; replaces
    /// the report's steel, glass, brass and rubber.
    #[arg(long = "material", value_name = "NAME=E", allow_hyphen_values = true)]
    given: Vec<String>,
}

impl Materials {
    /// The materials named, or the report's.
    pub(super) fn read(&self) -> Result<Vec<Material>, Failure> {
        if self.given.is_empty() {
            return Ok(Material::of_the_report());
        }
        let shown = |text: &str| text.escape_debug().take(60).collect::<String>();
        let mut materials = Vec::new();
        for text in &self.given {
            let failure = |problem: String| {
                Failure::new(format!("--material `{}`: {problem}", shown(text)))
                    .help("write a name and a number from 0 to 1: `--material cork=3/5`")
            };
            let (name, value) = text
                .rsplit_once('=')
                .ok_or_else(|| failure("there is no `=` in it".into()))?;
            let value = parse_exact(value).map_err(|error| failure(error.to_string()))?;
            let material = Material::new(name, value).map_err(|e| failure(e.to_string()))?;
            materials.push(material);
        }
        Material::distinct(&materials)
            .map_err(|error| Failure::new(format!("--material: {error}")))?;
        Ok(materials)
    }
}

/// What a file holds.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Svg,
    Png,
    Pdf,
    Json,
    Csv,
}

/// Draws a figure.
///
/// The ending of the file that it goes to says what it is: .svg, .png, .pdf, or .json and .csv for the numbers.
pub(super) fn plot(plot: &Plot, format: Format, file: Option<&Path>) -> Result<Content, Failure> {
    // What cannot be written is not drawn first.
    let kind = kind(file, format)?;
    let checker = proofs::checker();
    let (name, figure) = match plot {
        Plot::Collision => ("collision", figures::collision(&checker)),
        Plot::Energy { materials, .. } => ("energy", figures::energy(&checker, &materials.read()?)),
        Plot::Outcomes { balls: 3, .. } => ("outcomes", figures::outcomes(&checker)),
        Plot::Outcomes { balls, .. } => {
            let balls = match balls {
                1 => "1 ball".to_owned(),
                balls => format!("{balls} balls"),
            };
            return Err(Failure::new(format!(
                "--balls: the outcomes of {balls} are no curve on paper"
            ))
            .help("with 3 balls they are a circle: `--balls 3`"));
        }
        Plot::Lithotripsy => ("lithotripsy", figures::lithotripsy(&checker)),
    };
    let figure = figure.map_err(failed)?;
    Ok(match kind {
        Kind::Svg => figures::svg(&figure.scene).into(),
        Kind::Png => Content::Bytes(figures::png(&figure.scene).map_err(failed)?),
        Kind::Pdf => Content::Bytes(figures::pdf(&figure.scene).map_err(failed)?),
        Kind::Json => super::run::pretty(&json(name, &figure))?.into(),
        Kind::Csv => table(&figure).into(),
    })
}

pub(super) fn failed(error: FigureError) -> Failure {
    let failure = Failure::new(error.to_string());
    match error {
        FigureError::NoGlyph(_) => failure
            .help("write SVG, whose text is drawn with the viewer's own fonts: `-o FILE.svg`"),
        _ => failure,
    }
}

fn kind(file: Option<&Path>, format: Format) -> Result<Kind, Failure> {
    let asked = match format {
        Format::Human => None,
        Format::Json => Some(Kind::Json),
        Format::Csv => Some(Kind::Csv),
        Format::Svg => Some(Kind::Svg),
        Format::Markdown => {
            return Err(Failure::new("a figure is not written as Markdown")
                .help("its numbers are, as JSON or CSV: `--format csv`"));
        }
        other => return Err(super::run::no_audit(other)),
    };
    let Some(path) = file else {
        return Ok(asked.unwrap_or(Kind::Svg));
    };
    let kind = by_ending(path)?;
    match asked {
        Some(asked) if asked != kind => Err(Failure::new(format!(
            "--format and the ending of `{}` ask for two things",
            path.display()
        ))
        .help("leave out --format: with -o the ending decides")),
        _ => Ok(kind),
    }
}

fn by_ending(path: &Path) -> Result<Kind, Failure> {
    let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        Some("svg") => Ok(Kind::Svg),
        Some("png") => Ok(Kind::Png),
        Some("pdf") => Ok(Kind::Pdf),
        Some("json") => Ok(Kind::Json),
        Some("csv") => Ok(Kind::Csv),
        other => {
            let what = match other {
                Some(ending) => format!("a figure is not written as `.{ending}`"),
                None => format!("`{}` has no ending that says what to write", path.display()),
            };
            Err(Failure::new(what)
                .help("the endings are .svg, .png and .pdf, and .json and .csv for the numbers"))
        }
    }
}

fn table(figure: &Figure) -> String {
    let mut rows = vec![figure.numbers.columns.clone()];
    let text = |row: &Vec<_>| row.iter().map(|value| rounded(value, DECIMALS)).collect();
    rows.extend(figure.numbers.rows.iter().map(text));
    csv::csv(&rows)
}

fn json(name: &str, figure: &Figure) -> Value {
    let text = |row: &Vec<crate::algebra::BigRational>| -> Vec<String> {
        row.iter().map(ToString::to_string).collect()
    };
    let sources: Vec<Value> = figure
        .sources
        .iter()
        .map(|source| {
            json!({
                "equation": source.standing.label,
                "verdict": source.standing.verdict.word(),
                "rests_on": source.standing.rests_on,
                "latex": source.latex,
            })
        })
        .collect();
    json!({
        "figure": name,
        "title": figure.scene.title,
        "description": figure.scene.description,
        "sources": sources,
        "columns": figure.numbers.columns,
        "rows": figure.numbers.rows.iter().map(text).collect::<Vec<_>>(),
    })
}
