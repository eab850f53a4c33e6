//! What each command does: what it makes, and whether anything was found.

use std::path::PathBuf;

use nalgebra::DVector;
use num_rational::BigRational;
use num_traits::One;

use super::args::{Args, Builtin, Command, Format, Gate};
use super::config::{self, Configs};
use super::input::Look;
use super::output::{self, Content};
use super::{Failure, audit, file, halves, html, init, input, manual, plot, scenario, simulate};
use crate::audit::Audit;
use crate::cradle::{Scenario, parse_list};
use crate::derivation::Derivation;
use crate::proofs;
use crate::report::graph::Graph;
use crate::report::{Report, codes};

pub(super) type Done = Result<(Content, bool), Failure>;

/// Does what is asked.
pub(super) fn run(args: &Args) -> Done {
    run_looking(args, &mut Look::new())
}

/// The same; of a check, with what is seen of the files that its documents take in.
pub(super) fn run_looking(args: &Args, taken_in: &mut Look) -> Done {
    let drawn = matches!(args.format, Format::Dot | Format::Svg);
    if drawn && !matches!(args.command, Some(Command::Graph { .. } | Command::Plot(_))) {
        return Err(Failure::new("only `graph` and `plot` draw").help(
            "`cradle-verify graph --format svg`; elsewhere the format is `human` or `json`",
        ));
    }
    let tabular = matches!(args.command, Some(Command::Table { .. } | Command::Plot(_)));
    if let (Format::Csv | Format::Markdown, false) = (args.format, tabular) {
        return Err(Failure::new(
            "`--format csv` and `--format markdown` are for tables of numbers",
        )
        .help("`table` has both, `plot` has csv; here there are human and json"));
    }
    if let Some(letter) = &args.scenario {
        if args.command.is_some() {
            return Err(Failure::new("`--scenario` stands without a command").help(
                "for an outcome of your own: `cradle-verify scenario --before … --after …`",
            ));
        }
        if args.gate != Gate::default() {
            return Err(Failure::new("`--fail-on` and `--baseline` are for audits")
                .help("a scenario fails where a law does"));
        }
        return judged(&built_in(letter)?, args.format);
    }
    if args.command.is_some() && args.gate != Gate::default() {
        return Err(Failure::new(
            "`--fail-on` and `--baseline` stand behind the command that they are for",
        )
        .help("`cradle-verify check --fail-on error page.md`"));
    }
    if args.builtin.is_some() && !speaks_of_what_is_inside(args) {
        return Err(Failure::new(
            "`--builtin` names pages that ship inside, and this reads none of them",
        )
        .help("`cradle-verify --builtin corrected`, or `cradle-verify explain P5 --builtin corrected`"));
    }
    if (args.config.is_some() || args.no_config) && !reads_documents(args) {
        return Err(Failure::new(
            "`--config` and `--no-config` are for documents of your own, and this reads none",
        )
        .help("`cradle-verify check` audits the `files` of a `cradle.toml`"));
    }
    match &args.command {
        None => {
            let (derivation, shown) = inside(args);
            audit::audit(derivation, args, &args.gate, &shown)
        }
        Some(Command::Check {
            paths,
            stdin_filename,
            gate,
            watch: _,
        }) => {
            let (derivation, shown, looks) = looked_at(args, paths, stdin_filename.as_deref())?;
            *taken_in = looks;
            audit::audit(derivation, args, gate, &shown)
        }
        Some(Command::Explain {
            label,
            paths,
            stdin_filename,
        }) => {
            let (derivation, shown) = asked_for(args, paths, stdin_filename.as_deref())?;
            explain(&derivation, label, args, &shown)
        }
        Some(Command::Graph {
            paths,
            stdin_filename,
        }) => {
            let (derivation, shown) = asked_for(args, paths, stdin_filename.as_deref())?;
            graph(&derivation, args, &shown)
        }
        Some(Command::Report {
            paths,
            stdin_filename,
        }) => {
            let (derivation, shown) = asked_for(args, paths, stdin_filename.as_deref())?;
            let inside = speaks_of_what_is_inside(args);
            let inside = inside.then(|| args.builtin.unwrap_or_default());
            html::report(derivation, args, &shown, inside)
        }
        Some(Command::Init {
            paths,
            stdin_filename,
            toml,
            update,
        }) => {
            init::possible(args, *toml && !*update)?;
            let (derivation, _) = read(args, paths, stdin_filename.as_deref())?;
            let text = match args.output.as_ref().filter(|_| *update) {
                Some(file) => init::update(&derivation, &shown(paths), file)?,
                None => init::init(&derivation, &shown(paths), *toml),
            };
            Ok((text.into(), false))
        }
        Some(Command::Completions { shell }) => Ok((manual::completions(*shell).into(), false)),
        Some(Command::Man { command }) => Ok((manual::page(command)?.into(), false)),
        Some(Command::Scenario {
            before,
            after,
            masses,
        }) => judged(&own(before, after, masses.as_deref())?, args.format),
        Some(Command::Simulate {
            balls,
            arriving,
            model,
            restitution,
            masses,
        }) => {
            let balls = simulate::balls(*balls, *arriving, masses.as_deref())?;
            let simulation = balls.simulate(*model, restitution.as_deref())?;
            let text = match args.format {
                Format::Human => simulation.human(),
                Format::Json => pretty(&simulation.json())?,
                other => return Err(no_audit(other)),
            };
            Ok((text.into(), false))
        }
        Some(Command::Plot(figure)) => Ok((
            plot::plot(figure, args.format, args.output.as_deref())?,
            false,
        )),
        Some(Command::Table { materials }) => {
            let materials = materials.read()?;
            let format = halves::format(args.format, args.output.as_deref())?;
            let table = halves::halves(&proofs::checker(), &materials, format)?;
            Ok((table.into(), false))
        }
    }
}

fn speaks_of_what_is_inside(args: &Args) -> bool {
    match &args.command {
        None => true,
        Some(
            Command::Explain {
                paths,
                stdin_filename,
                ..
            }
            | Command::Graph {
                paths,
                stdin_filename,
            }
            | Command::Report {
                paths,
                stdin_filename,
                ..
            },
        ) => paths.is_empty() && stdin_filename.is_none() && args.config.is_none(),
        Some(_) => false,
    }
}

fn reads_documents(args: &Args) -> bool {
    match &args.command {
        Some(Command::Check { .. } | Command::Init { .. }) => true,
        Some(Command::Explain { .. } | Command::Graph { .. } | Command::Report { .. }) => {
            !speaks_of_what_is_inside(args)
        }
        _ => false,
    }
}

/// The pages that ship inside, and how they are asked for.
fn inside(args: &Args) -> (Derivation, Vec<String>) {
    match args.builtin.unwrap_or_default() {
        Builtin::Report => (proofs::report(), Vec::new()),
        Builtin::Corrected => (
            proofs::corrected::corrected(),
            vec!["--builtin".into(), "corrected".into()],
        ),
    }
}

/// The documents that are named, or what ships inside where there are none.
fn asked_for(
    args: &Args,
    paths: &[PathBuf],
    stdin_filename: Option<&str>,
) -> Result<(Derivation, Vec<String>), Failure> {
    match speaks_of_what_is_inside(args) {
        true => Ok(inside(args)),
        false => read(args, paths, stdin_filename),
    }
}

/// The documents that are named, or those that a configuration lists, each with what stands beside it; and how they are
/// asked for.
fn read(
    args: &Args,
    paths: &[PathBuf],
    stdin_filename: Option<&str>,
) -> Result<(Derivation, Vec<String>), Failure> {
    let (derivation, asked, _) = looked_at(args, paths, stdin_filename)?;
    Ok((derivation, asked))
}

/// The same, with what is seen of the files that documents take in.
fn looked_at(
    args: &Args,
    paths: &[PathBuf],
    stdin_filename: Option<&str>,
) -> Result<(Derivation, Vec<String>, Look), Failure> {
    let mut configs = Configs::new(args);
    let mut asked = shown(paths);
    let (files, listing) = match paths.is_empty() && stdin_filename.is_none() {
        true => {
            let (files, config) = configs.listed()?;
            (files, Some(config))
        }
        false => (paths.to_vec(), args.config.clone()),
    };
    if let Some(config) = listing {
        asked.extend(["--config".to_owned(), config.display().to_string()]);
    }
    if args.no_config {
        asked.push("--no-config".into());
    }
    let input::Documents {
        derivation,
        files: mut read,
        taken_in,
    } = input::derivation(&files, stdin_filename, &mut configs)?;
    // What `init --update` writes has all in it that it reads there.
    if !matches!(args.command, Some(Command::Init { update: true, .. })) {
        read.extend(configs.files());
    }
    for target in targets(args) {
        file::spare(target, &read)?;
    }
    output::say(&config::unmet(&derivation));
    Ok((derivation, asked, taken_in))
}

/// The files that are about to be written.
fn targets(args: &Args) -> impl Iterator<Item = &PathBuf> {
    let baseline = match &args.command {
        Some(Command::Check { gate, .. }) if gate.update_baseline => gate.baseline.as_ref(),
        _ => None,
    };
    args.output.iter().chain(baseline)
}

/// What rests on what.
fn graph(derivation: &Derivation, args: &Args, paths: &[String]) -> Done {
    let audit = Audit::of(derivation);
    let report = Report {
        derivation,
        audit: &audit,
        paths,
    };
    let graph = Graph::of(&report);
    let text = match args.format {
        Format::Human => graph.text(&report),
        Format::Json => pretty(&graph.json(&report))?,
        Format::Dot => graph.dot(),
        Format::Svg => graph.svg(),
        other => return Err(no_audit(other)),
    };
    Ok((text.into(), report.findings() > 0))
}

/// `a`, `a or b`, `a, b or c`.
fn list(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [all @ .., last] => format!("{} or {last}", all.join(", ")),
    }
}

fn shown(paths: &[PathBuf]) -> Vec<String> {
    paths
        .iter()
        .map(|path| path.display().to_string())
        .collect()
}

fn explain(derivation: &Derivation, label: &str, args: &Args, paths: &[String]) -> Done {
    let all = crate::report::meant(derivation, label);
    if all.is_empty() {
        if let Some((code, text)) = codes::page(label) {
            return meaning(code, text, args.format);
        }
        let failure = Failure::new(format!("there is no equation and no code `{label}`"));
        let mut near = crate::report::near::near_misses(derivation, label);
        near.extend(codes::near(label).map(str::to_owned));
        return Err(match near.is_empty() {
            true => failure.help(
                "the number as printed, `23`, the name of a claim, the place of an equation, `page.md:7:4`, or the code of \
                 a finding",
            ),
            false => failure.help(format!("perhaps {} is meant", list(&near))),
        });
    }
    let audit = Audit::of(derivation);
    let report = Report {
        derivation,
        audit: &audit,
        paths,
    };
    let entries = || all.iter().flat_map(|&at| audit.of_equation(at));
    let text: String = match args.format {
        Format::Human => all.iter().map(|&at| report.explain(at)).collect(),
        Format::Json => pretty(&report.json_of(&all))?,
        other => return Err(no_audit(other)),
    };
    Ok((text.into(), entries().any(|entry| report.is_finding(entry))))
}

/// What a code means, as docs/notes.md says it.
fn meaning(code: &str, text: &str, format: Format) -> Done {
    let level = codes::level(code).map(codes::Level::word);
    let shown = match format {
        Format::Human => {
            let bold = anstyle::Style::new().bold();
            let level = level.map_or(String::new(), |level| format!("  {level}"));
            format!("{bold}{code}{bold:#}{level}\n\n{text}\n")
        }
        Format::Json => pretty(&serde_json::json!({
            "code": code,
            "level": level,
            "text": text,
        }))?,
        other => return Err(no_audit(other)),
    };
    Ok((shown.into(), false))
}

/// A format that lists what an audit finds, asked of what is none.
pub(super) fn no_audit(format: Format) -> Failure {
    let word = format.word();
    Failure::new(format!(
        "`--format {word}` lists the findings of an audit, and this is none"
    ))
    .help("`--format json` is for programs; `cradle-verify check` has all formats")
}

pub(super) fn pretty(value: &impl serde::Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(value)
        .map(|text| text + "\n")
        .map_err(|error| Failure::new(format!("the result cannot be written as JSON: {error}")))
}

fn judged(asked: &Scenario, format: Format) -> Done {
    let outcome = asked.judge();
    let text = match format {
        Format::Human => scenario::human(&outcome),
        Format::Json => pretty(&scenario::json(&outcome))?,
        other => return Err(no_audit(other)),
    };
    Ok((text.into(), !scenario::holds(&outcome)))
}

fn built_in(letter: &str) -> Result<Scenario, Failure> {
    let mut letters = letter.trim().chars();
    let found = match (letters.next(), letters.next()) {
        (Some(letter), None) => Scenario::built_in(letter),
        _ => None,
    };
    let names: Vec<String> = Scenario::BUILT_IN.iter().map(char::to_string).collect();
    found.ok_or_else(|| {
        Failure::new(format!("there is no scenario `{letter}`")).help(format!(
            "the report has {}; for one of your own: `cradle-verify scenario --before … --after …`",
            names.join(", ")
        ))
    })
}

fn own(before: &str, after: &str, masses: Option<&str>) -> Result<Scenario, Failure> {
    let read = |flag: &str, text: &str| {
        parse_list(text).map_err(|error| Failure::new(format!("{flag}: {error}")))
    };
    let before = read("--before", before)?;
    let after = read("--after", after)?;
    let masses = match masses {
        Some(masses) => read("--masses", masses)?,
        None => DVector::from_element(before.len(), BigRational::one()),
    };
    Scenario::new(masses, before, after).map_err(|error| Failure::new(error.to_string()))
}
