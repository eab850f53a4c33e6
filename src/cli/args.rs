//! The arguments; names are exact, for scripts use them.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand, ValueEnum};

use super::plot::{Materials, Plot};
use crate::report::codes::Level;

/// Audits the equations of a physics derivation: each is proved exactly, refuted in exact numbers, or left undecided.
///
/// Without a command, audits the report on Newton's cradle that ships inside. The exit code is 0 where nothing was
/// found, 1 where something was (`--fail-on` and `--baseline` say what counts), 2 where the job could not be done.
#[derive(Clone, Debug, Default, Parser)]
#[command(name = "cradle-verify", version)]
pub struct Args {
    /// What to do; without it, audit the built-in report.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// Judge one of the report's scenarios by its letter: A, B, C or D.
    #[arg(long, value_name = "LETTER", conflicts_with = "builtin")]
    pub scenario: Option<String>,
    /// Which of the pages that ship inside to audit or explain, where no path is given; without it, the report.
    #[arg(long, global = true, value_enum)]
    pub builtin: Option<Builtin>,
    /// For people or for programs; `csv` and `markdown` are for tables.
    #[arg(long, global = true, value_enum, default_value_t)]
    pub format: Format,
    /// Whether to colour the output; `auto` does on a terminal, unless NO_COLOR is set.
    #[arg(long, global = true, value_enum, default_value_t)]
    pub color: Color,
    /// Print under each line what was understood, as LaTeX.
    #[arg(long, global = true)]
    pub show_understood: bool,
    /// Write to this file instead of standard output; it is replaced as a whole, or not at all. `-` is standard output.
    #[arg(short, long, global = true, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Work with this many threads, at most 8; without it, as many as there are processors. The result is the same.
    #[arg(long, global = true, value_name = "NUMBER")]
    pub jobs: Option<NonZeroUsize>,
    /// Take this `cradle.toml`, for all documents, instead of the nearest one to each.
    #[arg(long, global = true, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// Take no `cradle.toml`.
    #[arg(long, global = true, conflicts_with = "config")]
    pub no_config: bool,
    /// What makes the audit of the built-in report fail.
    #[command(flatten)]
    pub gate: Gate,
}

/// The options that say which documents are read, and what is told of their equations.
const OF_DOCUMENTS: [&str; 4] = ["builtin", "config", "no_config", "show_understood"];
/// The commands that read no documents.
const WITHOUT_DOCUMENTS: [&str; 6] = [
    "scenario",
    "simulate",
    "plot",
    "table",
    "completions",
    "man",
];

/// The commands with their options; none lists an option that says nothing to it.
pub fn commands() -> clap::Command {
    let all = Args::command();
    let hidden = all.get_arguments().filter_map(|option| {
        let is_of_documents = OF_DOCUMENTS.contains(&option.get_id().as_str());
        is_of_documents.then(|| option.clone().hide(true))
    });
    let hidden: Vec<clap::Arg> = hidden.collect();
    WITHOUT_DOCUMENTS.into_iter().fold(all, |all, name| {
        all.mut_subcommand(name, |command| command.args(hidden.clone()))
    })
}

impl Args {
    /// The arguments that the program was started with; it ends where they cannot be understood.
    pub fn read() -> Args {
        if std::env::args_os().len() < 2 {
            // To build what could be asked takes a twentieth of the audit.
            return Args::default();
        }
        let matches = commands().get_matches();
        let mut args = Args::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
        // `-` is what is written to where no file is named.
        args.output = args.output.filter(|file| file.as_os_str() != "-");
        args
    }

    /// Whether it is audited again whenever a document changes.
    pub fn is_watching(&self) -> bool {
        matches!(self.command, Some(Command::Check { watch: true, .. }))
    }
}

/// What makes an audit fail.
#[derive(Clone, Debug, Default, PartialEq, Eq, clap::Args)]
pub struct Gate {
    /// The least that makes the exit code 1.
    #[arg(long, value_enum, value_name = "LEVEL", default_value_t)]
    pub fail_on: FailOn,
    /// Findings recorded in this file are known and fail nothing; new ones do.
    #[arg(long, value_name = "FILE")]
    pub baseline: Option<PathBuf>,
    /// Write the baseline anew from what is found now.
    #[arg(long, requires = "baseline", conflicts_with = "strict_baseline")]
    pub update_baseline: bool,
    /// Fail on any difference from the baseline, be it for the better.
    #[arg(long, requires = "baseline")]
    pub strict_baseline: bool,
}

/// The least that makes an audit fail.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum FailOn {
    /// An equation is wrong, or could not be judged for what is written.
    Error,
    /// The same, or what is said of an equation is wrong or missing.
    #[default]
    Warning,
    /// The same, or anything that is good to know; an undecided equation is.
    Note,
    /// Nothing.
    Never,
}

impl FailOn {
    /// The level, if there is one.
    pub fn level(self) -> Option<Level> {
        match self {
            FailOn::Error => Some(Level::Error),
            FailOn::Warning => Some(Level::Warning),
            FailOn::Note => Some(Level::Note),
            FailOn::Never => None,
        }
    }
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
    /// Draw a figure from the audited equations: SVG, PNG or PDF.
    #[command(subcommand)]
    Plot(Plot),
    /// Tell after how many collisions no more than half of the energy is left, by (41) and by restitution.
    Table {
        /// The materials.
        #[command(flatten)]
        materials: Materials,
    },
    /// Audit Markdown or LaTeX documents and Jupyter notebooks of your own, read together as one derivation.
    Check {
        /// Files, directories (every `.md`, `.markdown`, `.qmd`, `.tex` and `.ipynb` in them), or `-` for standard input; without
        /// any, the `files` of `cradle.toml`.
        #[arg(value_name = "PATH")]
        paths: Vec<PathBuf>,
        /// What standard input is called in findings.
        #[arg(long, value_name = "NAME")]
        stdin_filename: Option<String>,
        /// Audit again whenever a document changes, until Ctrl-C.
        #[arg(long)]
        watch: bool,
        /// What makes it fail.
        #[command(flatten)]
        gate: Gate,
    },
    /// Show what rests on what, and what falls with each equation that fails: in words, or as `--format dot`, `json` or `svg`.
    Graph {
        /// Files, directories or `-`; without any, the built-in report, or the `files` of `--config`.
        #[arg(value_name = "PATH")]
        paths: Vec<PathBuf>,
        /// What standard input is called in findings.
        #[arg(long, value_name = "NAME")]
        stdin_filename: Option<String>,
    },
    /// Write the whole audit as one page for a browser: the documents, every verdict, its evidence, what rests on what.
    Report {
        /// Files, directories or `-`; without any, the built-in report, or the `files` of `--config`.
        #[arg(value_name = "PATH")]
        paths: Vec<PathBuf>,
        /// What standard input is called in findings.
        #[arg(long, value_name = "NAME")]
        stdin_filename: Option<String>,
    },
    /// Write out one equation's evidence in full, so that it can be checked by hand; or what a code means.
    Explain {
        /// The number (`23`) or name of an equation, or the code of a verdict or note (`miscited`).
        #[arg(value_name = "EQUATION|CODE")]
        label: String,
        /// Where it stands; without it, the built-in report, or the `files` of `--config`.
        #[arg(value_name = "PATH")]
        paths: Vec<PathBuf>,
        /// What standard input is called in findings.
        #[arg(long, value_name = "NAME")]
        stdin_filename: Option<String>,
    },
    /// List the symbols of documents, and print the declarations that are left to make, to be pasted and completed.
    Init {
        /// Files, directories or `-`; without any, the `files` of `cradle.toml`.
        #[arg(value_name = "FILE")]
        paths: Vec<PathBuf>,
        /// Write a `cradle.toml` instead of comments.
        #[arg(long)]
        toml: bool,
        /// Add to the `cradle.toml` that is there, `--toml -o cradle.toml`, what it does not declare yet; all else in it stays.
        #[arg(long, requires_all = ["toml", "output"])]
        update: bool,
        /// What standard input is called, and what it is written in.
        #[arg(long, value_name = "NAME")]
        stdin_filename: Option<String>,
    },
    /// Print a script with which a shell completes the arguments.
    Completions {
        /// The shell.
        #[arg(value_enum)]
        shell: clap_complete::Shell,
    },
    /// Print a manual page, as roff.
    Man {
        /// The command that it is about, `check` or `plot energy`; without it, the program.
        command: Vec<String>,
    },
}

/// The pages that ship inside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Builtin {
    /// The report on Newton's cradle, with its errors.
    #[default]
    Report,
    /// What is true instead of its errors.
    Corrected,
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// People.
    #[default]
    Human,
    /// Editors: `file:line:col: level[code]: message`.
    Short,
    /// Programs; docs/schema.json says how an audit is laid out.
    Json,
    /// Code scanning: SARIF 2.1.0.
    Sarif,
    /// Annotations of GitHub's checks.
    Github,
    /// Test reports: JUnit's XML.
    Junit,
    /// `graph` only: for Graphviz.
    Dot,
    /// `graph` only: a drawing.
    Svg,
    /// Spreadsheets: comma-separated values. `table` and `plot` only.
    Csv,
    /// A table in Markdown. `table` only.
    Markdown,
}

impl Format {
    /// The word that asks for it.
    pub fn word(self) -> &'static str {
        match self {
            Format::Human => "human",
            Format::Short => "short",
            Format::Json => "json",
            Format::Sarif => "sarif",
            Format::Github => "github",
            Format::Junit => "junit",
            Format::Dot => "dot",
            Format::Svg => "svg",
            Format::Csv => "csv",
            Format::Markdown => "markdown",
        }
    }
}

/// Whether to colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Color {
    /// On a terminal, unless NO_COLOR is set.
    #[default]
    Auto,
    /// Always.
    Always,
    /// Never.
    Never,
}
