//! What stands in a `cradle.toml` beside documents: where a document says otherwise, and where a symbol is declared that a
//! document does not declare itself.

use annotate_snippets::Level;

use crate::algebra::Symbol;
use crate::audit::{Entry, Judged};
use crate::derivation::{About, Clash, Page, Source};
use crate::document::Span;
use crate::kernel::Claim;

use super::Report;
use super::diagnostic::Finding;
use super::explain;
use super::words;

/// The code of a clash.
pub(super) const CODE: &str = "clashing-declaration";

impl Report<'_> {
    /// A clash as a finding.
    pub(super) fn clashing(&self, page: usize, clash: &Clash) -> Finding {
        let there = self.place_of(page, clash.beside);
        let other = match clash.about {
            About::TwoDomains(_) => "declared here before",
            _ => "the file says otherwise",
        };
        let (title, here, said) = match &clash.about {
            About::Dimension(symbol) => (
                format!(
                    "`{}` has another dimension here than at {there}",
                    words::symbol(symbol)
                ),
                "this counts in the document",
                "one symbol, one dimension: give one of the two another name, or leave out one declaration",
            ),
            About::Domain(symbol) => (
                format!(
                    "`{}` is allowed values here that {there} rules out",
                    words::symbol(symbol)
                ),
                "this counts in the document",
                "a document may narrow what the file says of a symbol; leave out one of the two, or make them agree",
            ),
            About::TwoDomains(symbol) => (
                format!(
                    "`{0}` may lie elsewhere here than at {there}: does `{0}` stand for two quantities?",
                    words::symbol(symbol)
                ),
                "until they agree the first counts",
                "declare the second of two quantities below a heading of its own, for that section; of one quantity declare in one place where it may lie",
            ),
            About::Euler(symbol) => (
                format!(
                    "`{}` is Euler's number either here or at {there}, and not in both",
                    words::symbol(symbol)
                ),
                "this counts in the document",
                "a letter is a number or a quantity: give one of the two another name",
            ),
            About::Given(label) => (
                format!("`{label}` is derived here, and given by {there}"),
                "this counts",
                "leave out one of the two",
            ),
        };
        Finding {
            level: Level::WARNING,
            code: CODE,
            title,
            page,
            primary: (clash.own, here.to_owned()),
            context: vec![(clash.beside, other.to_owned())],
            said: vec![(Level::HELP, said.to_owned())],
        }
    }

    /// What a step takes of where symbols lie and of whether they change, each with whoever says so.
    pub(super) fn domains(
        &self,
        entry: &Entry,
        judged: &Judged,
        claim: &Claim,
    ) -> Vec<(String, String)> {
        // A counterexample may be one of few situations: what moves nowhere in it need not be declared constant.
        let said = (self.derivation).claim(entry.equation, &judged.assumed, &judged.goal.formula);
        let told = self.derivation.said(entry.equation, &judged.assumed);
        let lines = explain::domains(claim).into_iter();
        let sourced = lines.map(|(symbol, line)| {
            let is_held = claim.domains.get(symbol) != said.domains.get(symbol);
            let place = self.place_of_declaration(entry, judged, symbol);
            let mut by = Vec::new();
            match place {
                _ if is_held && judged.outcome.is_refuted() => {
                    by.push("in this counterexample".to_owned());
                }
                _ if is_held => by.push("taken as constant".to_owned()),
                Some(Some(place)) => by.push(format!("declared, {place}")),
                Some(None) => by.push("declared".to_owned()),
                None if told.contains_key(symbol) => {}
                None => by.push("declared".to_owned()),
            }
            if let Some((page, said)) = told.get(symbol).filter(|_| !is_held) {
                let places = said.attributes.iter().map(|own| own.span);
                let mut places: Vec<Span> = places.collect();
                places.dedup();
                for span in places {
                    by.push(format!("the text says so, {}", self.place_of(*page, span)));
                }
            }
            (line, by.join("; "))
        });
        sourced.collect()
    }

    /// Whether a symbol, or the elements of a sequence, are declared for a step, and where if that is in a configuration: as
    /// [`crate::derivation::Derivation::claim`] has it, by the page of the step or else by that of a premise.
    fn place_of_declaration(
        &self,
        entry: &Entry,
        judged: &Judged,
        symbol: &Symbol,
    ) -> Option<Option<String>> {
        let own = self.equation(entry.equation).page;
        let others = judged.assumed.iter().filter_map(|a| match a.source {
            Source::Equation(premise) => Some(self.equation(premise).page),
            Source::Local(page, _) => Some(page),
            Source::Step | Source::Taken | Source::Propagation | Source::Nature => None,
        });
        let mut pages = std::iter::once(own).chain(others);
        pages.find_map(|at| {
            let page = &self.derivation.pages[at];
            let name = page.declared_name(symbol)?;
            Some(place_beside(page, name))
        })
    }
}

/// The place in a configuration at which a symbol is declared, if a page has it declared there alone.
pub(super) fn place_beside(page: &Page, symbol: &Symbol) -> Option<String> {
    let (path, at) = page.document.place(page.declared_beside(symbol)?);
    Some(format!("{path}:{}:{}", at.line, at.column))
}
