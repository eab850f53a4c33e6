//! What each command does: text for standard output, and whether anything was found.

use std::path::PathBuf;

use nalgebra::DVector;
use num_rational::BigRational;
use num_traits::One;

use super::args::{Args, Command, Format};
use super::{Failure, input, scenario, simulate};
use crate::audit::Audit;
use crate::cradle::{Scenario, parse_list};
use crate::derivation::Derivation;
use crate::proofs;
use crate::report::Report;

type Done = Result<(String, bool), Failure>;

/// Does what is asked.
pub(super) fn run(args: &Args) -> Done {
    if let Some(letter) = &args.scenario {
        if args.command.is_some() {
            return Err(Failure::new("`--scenario` stands without a command").help(
                "for an outcome of your own: `cradle-verify scenario --before … --after …`",
            ));
        }
        return judged(&built_in(letter)?, args.format);
    }
    match &args.command {
        None => audit(&proofs::report(), args, &[]),
        Some(Command::Check { paths }) => {
            let derivation = input::derivation(paths, args.stdin_filename.as_deref())?;
            audit(&derivation, args, &shown(paths))
        }
        Some(Command::Explain { label, paths }) => {
            let derivation = match paths.is_empty() {
                true => proofs::report(),
                false => input::derivation(paths, args.stdin_filename.as_deref())?,
            };
            explain(&derivation, label, args, &shown(paths))
        }
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
            };
            Ok((text, false))
        }
    }
}

fn shown(paths: &[PathBuf]) -> Vec<String> {
    paths
        .iter()
        .map(|path| path.display().to_string())
        .collect()
}

fn audit(derivation: &Derivation, args: &Args, paths: &[String]) -> Done {
    let audit = Audit::of(derivation);
    let report = Report {
        derivation,
        audit: &audit,
        paths,
    };
    let text = match args.format {
        Format::Human => report.human(args.show_understood),
        Format::Json => pretty(&report.json())?,
    };
    Ok((text, report.findings() > 0))
}

fn explain(derivation: &Derivation, label: &str, args: &Args, paths: &[String]) -> Done {
    let found = derivation.find(label);
    let Some(found) = found else {
        let failure = Failure::new(format!("there is no equation `{label}`"));
        let near = crate::report::near::near_misses(derivation, label);
        return Err(match near.is_empty() {
            true => failure.help("the number as printed, `23`, or the name of a claim"),
            false => failure.help(format!("there is {}", near.join(", "))),
        });
    };
    let (tag, name) = (found.tag.clone(), found.name.clone());
    let same = |e: &crate::derivation::Equation| match &tag {
        Some(_) => e.tag == tag,
        None => e.name == name,
    };
    let equations = derivation.equations.iter().enumerate();
    let all: Vec<usize> = equations
        .filter(|(_, e)| same(e))
        .map(|(at, _)| at)
        .collect();
    let audit = Audit::of(derivation);
    let report = Report {
        derivation,
        audit: &audit,
        paths,
    };
    let entries = || all.iter().flat_map(|&at| audit.of_equation(at));
    let text = match args.format {
        Format::Human => all.iter().map(|&at| report.explain(at)).collect(),
        Format::Json => pretty(&report.json_of(&all))?,
    };
    Ok((text, entries().any(|entry| entry.is_finding())))
}

fn pretty(value: &impl serde::Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(value)
        .map(|text| text + "\n")
        .map_err(|error| Failure::new(format!("the result cannot be written as JSON: {error}")))
}

fn judged(asked: &Scenario, format: Format) -> Done {
    let outcome = asked.judge();
    let text = match format {
        Format::Human => scenario::human(&outcome),
        Format::Json => pretty(&scenario::json(&outcome))?,
    };
    Ok((text, !scenario::holds(&outcome)))
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
