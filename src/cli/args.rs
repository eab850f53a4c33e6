//! The arguments; names are exact, for scripts use them.

use std::path::PathBuf;

use clap::{Parser, Subcommand, ValueEnum};

/// Audits the equations of a physics derivation: each is proved exactly, refuted in exact numbers, or left undecided.
///
/// Without a command, audits the report on Newton's cradle that ships inside. The exit code is 0 where nothing was
/// found, 1 where something was, 2 where the job could not be done.
#[derive(Clone, Debug, Parser)]
#[command(name = "cradle-verify", version)]
pub struct Args {
    /// What to do; without it, audit the built-in report.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Judge one of the report's scenarios by its letter: A, B, C or D.
    #[arg(long, value_name = "LETTER")]
    pub scenario: Option<String>,
    /// For people or for programs.
    #[arg(long, global = true, value_enum, default_value_t = Format::Human)]
    pub format: Format,
    /// Whether to colour the output; `auto` does on a terminal, unless NO_COLOR is set.
    #[arg(long, global = true, value_enum, default_value_t = Color::Auto)]
    pub color: Color,
    /// Print under each line what was understood, as LaTeX.
    #[arg(long, global = true)]
    pub show_understood: bool,
    /// The name of what comes on standard input (`-`); its ending says what it is written in.
    #[arg(long, global = true, value_name = "NAME")]
    pub stdin_filename: Option<String>,
}

/// What can be asked for.
#[derive(Clone, Debug, Subcommand)]
pub enum Command {
    /// Judge an outcome of your own: do momentum and kinetic energy allow it?
    Scenario {
        /// The velocities before, parted by commas: `1,1,0,0,0`. Exact: `2/3`, `0.5`, `-1`.
        #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
        before: String,
        /// The velocities after.
        #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
        after: String,
        /// The masses; without them, all are 1.
        #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
        masses: Option<String>,
    },
    /// Let balls collide: the first ones come in at speed 1, the others stand. What comes out?
    Simulate {
        /// How many balls; without it, as many as there are masses, or five.
        #[arg(long, value_name = "NUMBER")]
        balls: Option<usize>,
        /// How many of them come in.
        #[arg(long = "in", value_name = "NUMBER", default_value_t = 1)]
        arriving: usize,
        /// How they collide.
        #[arg(long, value_enum, default_value_t = Model::Pairwise)]
        model: Model,
        /// The coefficient of restitution, from 0 to 1: `9/10`. Without it, 1. Pairwise only.
        #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
        restitution: Option<String>,
        /// The masses, parted by commas; without them, all are 1.
        #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
        masses: Option<String>,
    },
    /// Audit Markdown or LaTeX documents and Jupyter notebooks of your own, read together as one derivation.
    Check {
        /// Files, directories (every `.md`, `.markdown`, `.tex` and `.ipynb` in them), or `-` for standard input.
        #[arg(required = true, value_name = "PATH")]
        paths: Vec<PathBuf>,
    },
    /// Write out one equation's evidence in full, so that it can be checked by hand.
    Explain {
        /// The number (`23`) or name of the equation.
        #[arg(value_name = "EQUATION")]
        label: String,
        /// Where it stands; without it, the built-in report.
        #[arg(value_name = "PATH")]
        paths: Vec<PathBuf>,
    },
}

/// How balls collide.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Model {
    /// One pair after the other, in an instant, with small gaps between the balls. Exact.
    Pairwise,
    /// All at once, by Hertz's contact force, the balls touching from the start. Numeric, with an estimate of the error.
    Hertz,
}

/// Whom the output is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// People.
    Human,
    /// Programs; docs/schema.json says how it is laid out.
    Json,
}

/// Whether to colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Color {
    /// On a terminal, unless NO_COLOR is set.
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}
