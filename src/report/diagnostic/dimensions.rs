//! An equation that compares what differs in dimension: both dimensions, a change of units, whom it disagrees with.

use annotate_snippets::Level;

use crate::algebra::{Formula, Function, Relation, Symbol};
use crate::audit::{Entry, Tells};
use crate::derivation::Source;
use crate::dimension::Conflict;
use crate::document::Span;
use crate::kernel::dimension::{Comparison, Form, What, comparisons};
use crate::notation::plain_formula;
use crate::sorted::Set;

use super::super::Report;
use super::super::dimension::{called, change_of_units, columns, missing_factor};
use super::super::implied;
use super::super::scaling;
use super::super::words::{list, symbol, unplaced};
use super::differing::{Thing, compared, in_order, place, things};
use super::{Finding, replay};

impl Report<'_> {
    pub(super) fn ill_dimensioned(&self, entry: &Entry) -> Option<Finding> {
        let conflict = self.conflict(entry)?;
        let statement = self.statement(entry)?;
        let equation = self.equation(entry.equation);
        let title = format!("{} {}", self.subject(entry), self.fault(conflict));
        let mut finding = self.disagreement(conflict, equation.page, title, statement.span);
        let (guilty, other) = things(conflict);
        let place =
            |thing: &Thing| Some(place(statement, conflict.reading, thing.path.as_deref()?));
        if let Some(span) = place(&guilty).flatten() {
            finding.primary = (span, format!("is {}", self.called(&guilty.form)));
            if let Some(other_span) = place(&other).flatten().filter(|other| *other != span) {
                finding
                    .context
                    .push((other_span, format!("is {}", self.called(&other.form))));
            } else {
                finding.primary.1 =
                    format!("here {} is {}", guilty.label, self.called(&guilty.form));
            }
        }
        if let Some((judged, refuted)) = entry.refuted() {
            let text = self.in_numbers(judged, refuted);
            finding.said.push((
                Level::NOTE.with_name("as numbers"),
                format!("it does not follow either: {text}"),
            ));
            let instead = implied::instead(entry);
            let instead = instead.map(|text| (Level::HELP, text));
            finding.said.extend(instead);
        }
        if let Some((judged, refuted, repair)) = entry.rescaled() {
            let text = self.in_situations(judged, refuted);
            finding.said.push((
                Level::NOTE.with_name("scaling"),
                format!("it does not follow either: {text}"),
            ));
            let repaired = repair.map(|repair| (Level::HELP, scaling::repaired(refuted, repair)));
            finding.said.extend(repaired);
        }
        finding.said.extend(self.other_reading(entry));
        finding.said.push(replay(self, entry.equation));
        Some(finding)
    }

    /// A `let` or an assumption at fault.
    pub(super) fn ill_supposed(
        &self,
        page: usize,
        at: usize,
        conflict: &Conflict<Source>,
    ) -> Finding {
        let span = self.derivation.local(page, at).span;
        let title = format!("what is supposed here {}", self.fault(conflict));
        self.disagreement(conflict, page, title, span)
    }

    fn disagreement(
        &self,
        conflict: &Conflict<Source>,
        page: usize,
        title: String,
        span: Span,
    ) -> Finding {
        let mut said: Vec<(Level<'static>, String)> = self
            .dimensions_said(conflict)
            .into_iter()
            .map(|(name, text)| {
                let level = if name == "help" {
                    Level::HELP
                } else {
                    Level::NOTE.with_name(name)
                };
                (level, text)
            })
            .collect();
        said.retain(|(_, text)| !text.is_empty());
        Finding {
            level: Level::ERROR,
            code: "ill-dimensioned",
            title,
            page,
            primary: (span, String::new()),
            context: Vec::new(),
            said,
        }
    }

    /// The evidence, a name and a text each.
    pub(in super::super) fn dimensions_said(
        &self,
        conflict: &Conflict<Source>,
    ) -> Vec<(&'static str, String)> {
        let unknowns = &self.audit.dimensions.unknowns;
        let (first, second) = in_order(conflict);
        let rows = [
            (first.label.clone(), &first.form),
            (second.label.clone(), &second.form),
        ];
        let mut said = vec![("dimension", columns(&rows, unknowns).join("\n"))];
        if let Some(rescaling) = conflict.evidence.rescaling() {
            said.push((
                "change of units",
                change_of_units(rescaling, &first.words, &second.words),
            ));
        }
        let comparison = conflict.evidence.comparison();
        if comparison.what == What::Sides && conflict.origins.len() == 1 {
            let quotient = first.form.over(&second.form);
            let hint = quotient.dimension().and_then(missing_factor);
            said.extend(hint.map(|hint| ("note", format!("the right side {hint}"))));
        }
        if conflict.origins.len() > 1 {
            let others = conflict
                .origins
                .iter()
                .zip(conflict.evidence.parts())
                .skip(1);
            let mut lines: Vec<String> = Vec::new();
            for (origin, part) in others {
                let line = match *origin == conflict.origins[0] {
                    true => format!("itself: {}", compared(part)),
                    false => format!(
                        "{}: {}",
                        self.origin_of(*origin),
                        plain_formula(&part.formula)
                    ),
                };
                if !lines.contains(&line) {
                    lines.push(line);
                }
            }
            said.push(("disagrees with", lines.join("\n")));
            said.push(("help", self.settled_by(conflict)));
        }
        let told = self.units_told(conflict);
        if !told.is_empty() {
            said.push(("told", told.join("\n")));
        }
        said
    }

    /// What the text gives with units of all that is compared, where no dimension is declared.
    fn units_told(&self, conflict: &Conflict<Source>) -> Vec<String> {
        let Source::Equation(at) = conflict.origins[0] else {
            return Vec::new();
        };
        let page = self.derivation.equations[at].page;
        let Some(told) = self.audit.dimensions.told.get(page) else {
            return Vec::new();
        };
        let parts = conflict.evidence.parts().iter();
        let names: Set<Symbol> = parts.flat_map(|part| part.formula.names()).collect();
        let told = names.iter().filter_map(|own| Some((own, told.get(own)?)));
        told.map(|(own, told)| match &told.by {
            Tells::Units(words) | Tells::Beside(words) => plain_formula(words),
            Tells::Name(quantity) => {
                let line = self.line_of(page, quantity.body);
                format!(
                    "{} is {} ({line})",
                    symbol(own),
                    with_article(quantity.name)
                )
            }
            Tells::Rates => format!("{} is the time", symbol(own)),
            Tells::Letter(name) => format!("{} is {name}", symbol(own)),
        })
        .collect()
    }

    /// The declarations that would tell which of several equations is wrong.
    fn settled_by(&self, conflict: &Conflict<Source>) -> String {
        let mut open: Vec<String> = Vec::new();
        for part in conflict.evidence.parts() {
            let all = comparisons(&part.formula, &part.scope);
            let quotient = all.get(part.comparison).map(Comparison::quotient);
            for unknown in quotient.iter().flat_map(|q| q.unknowns.keys()) {
                let name = self.audit.dimensions.unknowns.get(unknown.0).map(symbol);
                open.extend(name.filter(|name| !open.contains(name)));
            }
        }
        let two = match &open[..] {
            [symbol] if self.is_across_sections(conflict) => {
                format!(
                    "; or does {symbol} stand for two quantities? Then declare one of them below its heading, for that section"
                )
            }
            _ => String::new(),
        };
        format!(
            "declare the dimension of {}: then the one that is wrong stands out{two}",
            list(open)
        )
    }

    /// Whether equations disagree that stand under different headings of one document.
    fn is_across_sections(&self, conflict: &Conflict<Source>) -> bool {
        let mut equations = conflict.origins.iter().filter_map(|origin| match origin {
            Source::Equation(at) => Some(self.equation(*at)),
            _ => None,
        });
        let Some(first) = equations.next() else {
            return false;
        };
        equations.any(|other| other.page == first.page && other.section != first.section)
    }

    fn origin_of(&self, origin: Source) -> String {
        match origin {
            Source::Equation(at) => format!("{} at {}", self.name(at), self.place(at)),
            Source::Local(page, at) => format!(
                "supposed at {}",
                self.place_of(page, self.derivation.local(page, at).span)
            ),
            of_no_place => unplaced(of_no_place).into(),
        }
    }

    pub(in super::super) fn conflict(&self, entry: &Entry) -> Option<&Conflict<Source>> {
        self.audit
            .dimensions
            .conflicts
            .get(&(entry.equation, entry.part))
    }

    fn called(&self, form: &Form) -> String {
        called(form, &self.audit.dimensions.unknowns)
    }

    /// What is wrong, as the end of a sentence.
    pub(in super::super) fn fault(&self, conflict: &Conflict<Source>) -> String {
        let (guilty, other) = things(conflict);
        let (own, needed) = (self.called(&guilty.form), self.called(&other.form));
        let fault = match conflict.evidence.comparison().what {
            What::Sides => {
                let (left, right) = in_order(conflict);
                let equal = matches!(
                    &conflict.evidence.parts()[0].formula,
                    Formula::Relation {
                        relation: Relation::Equal,
                        ..
                    } | Formula::AllEqual { .. }
                );
                let verb = if equal { "equates" } else { "compares" };
                format!(
                    "{verb} {} and {}",
                    self.called(&left.form),
                    self.called(&right.form)
                )
            }
            What::Summands => format!("adds {own} to {needed}"),
            What::Argument(function) => format!("takes the {} of {own}", function_name(function)),
            What::Exponent => format!("has {own} in an exponent"),
            What::Count => format!("counts up to {own}"),
            What::Limit => format!("lets a variable with the dimension {needed} go to {own}"),
        };
        let mut others: Vec<usize> = Vec::new();
        for origin in &conflict.origins[1..] {
            if let Source::Equation(at) = origin
                && conflict.origins[0] != *origin
                && !others.contains(at)
            {
                others.push(*at);
            }
        }
        match others.is_empty() {
            true => fault,
            false => format!(
                "{fault}, as {} {} it",
                self.references(&others),
                if others.len() == 1 { "has" } else { "have" }
            ),
        }
    }
}

fn function_name(function: Function) -> &'static str {
    match function {
        Function::Sin => "sine",
        Function::Cos => "cosine",
        Function::Tan => "tangent",
        Function::ArcSin => "arcsine",
        Function::ArcCos => "arccosine",
        Function::ArcTan => "arctangent",
        Function::Exp => "exponential",
        Function::Ln => "logarithm",
        Function::Abs => "absolute value",
        Function::Ceiling | Function::Floor => "whole part",
    }
}

/// `a radius`, `an area`
fn with_article(name: &str) -> String {
    let article = match name.starts_with(['a', 'e', 'i', 'o']) {
        true => "an",
        false => "a",
    };
    format!("{article} {name}")
}
