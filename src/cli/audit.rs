//! An audit in the format that is asked for, held against a baseline where there is one.

use std::path::Path;

use super::args::{Args, Format, Gate};
use super::run::{Done, no_audit, pretty};
use super::{Failure, file, input, output, progress};
use crate::derivation::Derivation;
use crate::report::baseline::{Baseline, Comparison};
use crate::report::remark::Known;
use crate::report::{Report, github, short};

/// Audits a derivation; the paths are those that were asked for.
pub(super) fn audit(derivation: Derivation, args: &Args, gate: &Gate, paths: &[String]) -> Done {
    let audit = progress::audited(&derivation);
    let report = Report {
        derivation: &derivation,
        audit: &audit,
        paths,
    };
    let here = std::env::current_dir().unwrap_or_default();
    if let (Some(output), Some(baseline)) = (&args.output, &gate.baseline)
        && input::same(output) == input::same(baseline)
    {
        return Err(Failure::new(format!(
            "`{}` cannot be the baseline and the output",
            output.display()
        ))
        .help("name another file to write"));
    }
    let comparison = match &gate.baseline {
        Some(path) => Some(compared(&report, path, gate.update_baseline, &here)?),
        None => None,
    };
    let text = view(&report, comparison.as_ref(), args, gate, &here)?;
    let fails = fails(&report, comparison.as_ref(), gate);
    if !args.is_watching() {
        // The program ends here, and the system takes all memory back at once: to take apart what is in it takes longer.
        std::mem::forget((audit, derivation));
    }
    Ok((text.into(), fails))
}

/// Reads the baseline, or writes it.
fn compared(
    report: &Report<'_>,
    path: &Path,
    update: bool,
    here: &Path,
) -> Result<Comparison, Failure> {
    let shown = path.display();
    if update {
        replaceable(path)?;
        let baseline = report.baseline(here);
        file::replace(path, baseline.written())?;
        output::say(&format!(
            "wrote {shown}: {}\n",
            report.size_of_baseline(here)
        ));
        return Ok(report.compared(&baseline, here));
    }
    let text = std::fs::read_to_string(path).map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => Failure::new(format!("there is no baseline `{shown}`"))
            .help("`--update-baseline` writes one"),
        _ => Failure::new(format!("`{shown}` cannot be read: {error}")),
    })?;
    let baseline = Baseline::read(&text).map_err(|error| {
        Failure::new(format!("`{shown}` {error}")).help(match Baseline::may_replace(&text) {
            true => "`--update-baseline` writes it anew",
            false => "name a baseline; where none is there, `--update-baseline` writes one",
        })
    })?;
    Ok(report.compared(&baseline, here))
}

/// That no file is written over which is no baseline.
fn replaceable(path: &Path) -> Result<(), Failure> {
    let is_file = std::fs::metadata(path).is_ok_and(|about| about.is_file());
    if !is_file {
        return Ok(());
    }
    let text = std::fs::read_to_string(path).ok();
    match text.is_some_and(|text| Baseline::may_replace(&text)) {
        true => Ok(()),
        false => Err(Failure::new(format!(
            "`{}` is there and is no baseline, so it is not replaced",
            path.display()
        ))
        .help("name another file, or remove this one")),
    }
}

fn view(
    report: &Report<'_>,
    comparison: Option<&Comparison>,
    args: &Args,
    gate: &Gate,
    here: &Path,
) -> Result<String, Failure> {
    let nothing = Known::new();
    let known = comparison.map_or(&nothing, |comparison| &comparison.remarks);
    let strict = gate.strict_baseline;
    if let Some(comparison) = comparison
        && args.format != Format::Human
    {
        let told = comparison.differences.iter();
        if told.clone().any(|d| strict || d.change.concerns()) {
            output::say(&format!("baseline:\n{}", comparison.told(strict)));
        }
    }
    let remarks = || report.remarks(here, known);
    Ok(match args.format {
        Format::Human => {
            let mut text = report.human_but(args.show_understood, known);
            if let Some(comparison) = comparison {
                let bold = anstyle::Style::new().bold();
                let told = comparison.told(strict);
                text += &format!("\n{bold}Baseline{bold:#}\n\n{told}");
            }
            text
        }
        Format::Json => {
            let mut view = report.json();
            view.baseline = comparison.cloned();
            pretty(&view)?
        }
        Format::Short => short(&remarks()),
        Format::Github => github(&remarks()),
        Format::Sarif => pretty(&report.sarif(&remarks(), comparison.is_some()))?,
        Format::Junit => report.junit(&remarks(), gate.fail_on.level(), here),
        other => return Err(no_audit(other)),
    })
}

/// Whether the exit code is 1.
fn fails(report: &Report<'_>, comparison: Option<&Comparison>, gate: &Gate) -> bool {
    let least = gate.fail_on.level();
    if let Some(comparison) = comparison {
        let mut differences = comparison.differences.iter();
        return differences.any(|d| gate.strict_baseline || d.fails(least));
    }
    least.is_some() && report.gravest() >= least
}
