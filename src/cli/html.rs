//! `report`: the whole audit as one page, with the report's own figures and table where it is about the report.

use std::path::Path;

use super::args::{Args, Builtin, Format};
use super::output::Content;
use super::run::Done;
use super::{Failure, halves};
use crate::derivation::{Checker, Derivation};
use crate::figures::{self, Figure, FigureError, Material};
use crate::parallel::in_order;
use crate::report::Report;
use crate::report::html::{Picture, Pictures};

/// The page, and whether anything was found.
pub(super) fn report(
    derivation: Derivation,
    args: &Args,
    paths: &[String],
    inside: Option<Builtin>,
) -> Done {
    if args.format != Format::Human {
        return Err(
            Failure::new("`report` writes a page of HTML, and that only")
                .help("`cradle-verify check --format json` is for programs"),
        );
    }
    if let Some(file) = &args.output {
        is_of_a_page(file)?;
    }
    let checker = Checker::new(derivation);
    let report = Report {
        derivation: checker.derivation(),
        audit: checker.audit(),
        paths,
    };
    let mut pictures = match inside {
        Some(Builtin::Report) => pictures(&checker).map_err(super::plot::failed)?,
        _ => Pictures::default(),
    };
    pictures.title = inside.map(|inside| title(inside).to_owned());
    let page = report.html(&pictures);
    let found = report.findings() > 0;
    Ok((Content::Bytes(page.into_bytes()), found))
}

/// That the name of a file does not promise anything but a page. One without an ending promises nothing.
fn is_of_a_page(file: &Path) -> Result<(), Failure> {
    let ending = file.extension().map(|e| e.to_string_lossy().to_lowercase());
    match ending.as_deref() {
        None | Some("html" | "htm" | "xhtml") => Ok(()),
        Some(ending) => Err(
            Failure::new(format!("a page of HTML is not written as `.{ending}`"))
                .help("write it as `.html`; a browser prints it to PDF"),
        ),
    }
}

/// What the page is called that is about what ships inside.
fn title(inside: Builtin) -> &'static str {
    match inside {
        Builtin::Report => "The report on Newton’s cradle",
        Builtin::Corrected => "The report on Newton’s cradle, corrected",
    }
}

/// What draws one of the figures.
type Drawing<'a> = dyn Fn(&Checker) -> Result<Figure, FigureError> + Sync + 'a;

/// The figures and the table that are drawn from the report's own equations.
fn pictures(checker: &Checker) -> Result<Pictures, FigureError> {
    let materials = Material::of_the_report();
    let energy = |checker: &Checker| figures::energy(checker, &materials);
    let all: [&Drawing; 4] = [
        &figures::collision,
        &energy,
        &figures::outcomes,
        &figures::lithotripsy,
    ];
    let drawn = in_order(all, |figure| {
        let Figure { scene, narrow, .. } = figure(checker)?;
        let (scene, caption) = scene.parted();
        Ok(Picture {
            svg: figures::svg(&scene),
            narrow: figures::svg(&narrow.parted().0),
            caption: figures::markup(&caption),
        })
    });
    Ok(Pictures {
        title: None,
        figures: drawn.into_iter().collect::<Result<_, FigureError>>()?,
        tables: vec![halves::on_a_page(checker, &materials)?],
    })
}
