//! The figures for symbols: their `data` clauses.

use crate::algebra::{BigRational, Symbol, as_printed};
use crate::document::{Directive, Item, Problem, Span};
use crate::notation::read_symbol;

use super::super::meanings::Meanings;
use super::Page;

/// Figures for a symbol: between what numbers its value lies, in SI units, and who says so.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Datum {
    /// The least value.
    pub low: BigRational,
    /// The greatest value.
    pub high: BigRational,
    /// Where the figures come from.
    pub source: String,
    /// The clause.
    pub span: Span,
    /// The name of the constant that it is, where the page says nothing of it.
    pub constant: Option<&'static str>,
}

impl Page {
    /// The `data` clauses.
    pub(super) fn figures(&mut self, items: &[Item], meanings: &Meanings) {
        for item in items {
            let Item::Directives { clauses, .. } = item else {
                continue;
            };
            for clause in clauses {
                let Directive::Data {
                    names,
                    low,
                    high,
                    source,
                } = &clause.value
                else {
                    continue;
                };
                let datum = Datum {
                    low: low.clone(),
                    high: high.clone(),
                    source: source.clone(),
                    span: clause.span,
                    constant: None,
                };
                for &span in names {
                    match read_symbol(self.document.text(span)) {
                        Ok(letter) => {
                            self.figure(meanings.at(&letter, span.start), span, datum.clone());
                        }
                        Err(error) => self.complain_at(span, error),
                    }
                }
            }
        }
    }

    /// One figure of each symbol counts, and it must lie where the symbol is declared to lie.
    fn figure(&mut self, symbol: Symbol, span: Span, datum: Datum) {
        let domain = self.domains.get(&symbol);
        let within = domain.is_none_or(|d| d.contains(&datum.low) && d.contains(&datum.high));
        let shown = as_printed(symbol.name()).0.into_owned();
        let (message, help) = match (within, self.data.contains_key(&symbol)) {
            (true, false) => {
                self.data.insert(symbol, datum);
                return;
            }
            (true, true) => (
                format!("`{shown}` has figures already on this page"),
                "give one of the two another name; until then the first counts",
            ),
            (false, _) => (
                format!("the figures of `{shown}` leave its declared domain"),
                "make the declaration wider, or the figures narrower",
            ),
        };
        self.problems.push(Problem::new(span, message, help));
    }
}
