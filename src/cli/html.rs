//! `report`: the whole audit as one page, with the report's own figures and table where it is about the report.

use super::args::{Args, Format};
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
    is_report: bool,
) -> Done {
    if args.format != Format::Human {
        return Err(
            Failure::new("`report` writes a page of HTML, and that only")
                .help("`cradle-verify check --format json` is for programs"),
        );
    }
    let checker = Checker::new(derivation);
    let report = Report {
        derivation: checker.derivation(),
        audit: checker.audit(),
        paths,
    };
    let pictures = match is_report {
        true => pictures(&checker).map_err(super::plot::failed)?,
        false => Pictures::default(),
    };
    let page = report.html(&pictures);
    let found = report.findings() > 0;
    Ok((Content::Bytes(page.into_bytes()), found))
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
        let scene = figure(checker)?.scene;
        Ok(Picture {
            svg: figures::svg(&scene),
            title: scene.title,
        })
    });
    Ok(Pictures {
        figures: drawn.into_iter().collect::<Result<_, FigureError>>()?,
        tables: vec![halves::on_a_page(checker, &materials)?],
    })
}
