//! From documents to what must follow from what.
//!
//! A [`Derivation`] is a set of pages read together, as one report. Each displayed equation becomes an
//! [`Equation`]: what it states, what kind of statement it is, and what it is said to rest on. From these
//! [`Derivation::claim`] makes the claims that are judged: hypotheses ⊢ goal, with every domain explicit.

mod approach;
mod arguments;
mod assumed;
mod beside;
mod beyond;
mod called;
mod chain;
mod checker;
mod citations;
mod claim;
mod common;
mod complex;
mod constants;
mod counts;
mod definition;
mod differentials;
mod doubts;
mod equation;
mod euler;
mod example;
mod functions;
mod imaginary;
mod indices;
mod initial;
mod lasting;
mod meanings;
mod names;
mod nested;
mod page;
mod partials;
mod pi;
mod qualities;
mod quantities;
mod raised;
mod reader;
mod relatives;
mod rows;
mod running;
mod slopes;
mod sums;
mod supposed;
mod tabulated;
mod values;

use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

use crate::algebra::Symbol;
use crate::document::{Document, Span};
use crate::parallel::in_order;
use crate::sorted::{Set, Tree};

use citations::{name_key, tag_key};

pub use approach::{Approach, sizes};
pub use assumed::{Assumed, Source};
pub use beside::{About, Beside, Budget, Clash, Place, Severity, Shared};
pub use checker::{Checker, Point, values_at};
pub use citations::Unknown;
pub use claim::is_open;
pub(crate) use complex::{comes_to_nothing, parts_of};
pub use equation::{
    Among, Equation, Goal, Kind, conditions, first_goal, formulas, goals, unconditional,
};
pub(crate) use imaginary::is_imaginary_unit;
pub(crate) use meanings::renamed;
pub(crate) use names::{dotted, without_dots};
pub use page::{Beyond, Datum, Page, Premises};
pub use qualities::Said;
pub(crate) use relatives::{in_a_row, words_of};
pub use running::Running;
pub(crate) use slopes::TIME;
pub use sums::sums_in;
pub use supposed::{Local, is_put};
pub use values::{ConditionSaid, Printed, ValueSaid};

/// A set of pages that are read together, with their equations in reading order.
#[derive(Clone, Debug)]
pub struct Derivation {
    /// The pages.
    pub pages: Vec<Page>,
    /// The equations of all pages.
    pub equations: Vec<Equation>,
    labels: Tree<String, Vec<usize>>,
    /// Numbers and keys that several equations share: those of `subequations`.
    groups: Tree<String, Vec<usize>>,
    /// By equation, what it is said to follow from: [`Derivation::premises`].
    cites: Vec<(Vec<usize>, bool, Vec<Unknown>)>,
    /// The equations whose place others take, each with the first that does.
    replaced: Tree<usize, usize>,
    /// By equation, the symbols, sequences and functions that it speaks of.
    spoken_of: Vec<Set<Symbol>>,
    /// By page, the equations in which a symbol occurs.
    mentions: Vec<Tree<Symbol, Vec<usize>>>,
    /// The pages in which a symbol occurs.
    pages_of: Tree<Symbol, Vec<usize>>,
    /// By page, the pages that it cites, and itself.
    neighbours: Vec<BTreeSet<usize>>,
    /// By page, the indices that run through sequences.
    running: Vec<Vec<Running>>,
    /// The constants to which nobody gives a name: `\text{const}`.
    constants: BTreeSet<Symbol>,
}

impl Derivation {
    /// Reads documents as one derivation, in the given order.
    pub fn new(documents: Vec<Document>) -> Self {
        Derivation::beside(documents.into_iter().map(|own| (own, None)).collect())
    }

    /// Reads documents as one derivation, each with what stands beside it.
    pub fn beside(documents: Vec<(Document, Option<Arc<Beside>>)>) -> Self {
        Derivation::read(documents, |document| document)
    }

    /// Reads documents as one derivation, several at a time: `open` makes of each item a document and what stands beside it.
    pub fn read<T: Send>(
        items: impl IntoIterator<Item = T>,
        open: impl Fn(T) -> (Document, Option<Arc<Beside>>) + Sync,
    ) -> Self {
        let mut derivation = Derivation {
            pages: Vec::new(),
            equations: Vec::new(),
            labels: Tree::new(),
            groups: Tree::new(),
            cites: Vec::new(),
            replaced: Tree::new(),
            spoken_of: Vec::new(),
            mentions: Vec::new(),
            pages_of: Tree::new(),
            neighbours: Vec::new(),
            running: Vec::new(),
            constants: BTreeSet::new(),
        };
        let read = |(at, item)| {
            let (mut own, beside) = open(item);
            own.beside = beside.as_ref().map(|beside| Arc::clone(&beside.file));
            let (mut page, mut equations) = page::read_page(own, beside, at);
            raised::read_cases(&mut page, &mut equations);
            slopes::read_marks(&mut page, &mut equations);
            arguments::leave_out(&mut page, &mut equations);
            partials::tell_what_is_held(&mut page, &mut equations);
            functions::see_mere_names(&mut page, &equations);
            (page, equations)
        };
        for (page, equations) in in_order(items.into_iter().enumerate(), read) {
            derivation.pages.push(page);
            derivation.equations.extend(equations);
        }
        let (pages, equations) = (&mut derivation.pages, &mut derivation.equations);
        for own in page::of_documents(pages) {
            euler::recognize(&own, pages, equations);
            imaginary::recognize(&own, pages, equations);
            pi::recognize(&own, pages, equations);
        }
        for (at, page) in pages.iter().enumerate() {
            let own = equation::of_page(at, equations);
            qualities::leave_out_what_moves(page, &mut equations[own]);
        }
        derivation.constants = constants::tell_apart(pages, equations);
        definition::settle(equations, pages, &derivation.constants);
        for (at, equation) in derivation.equations.iter().enumerate() {
            let labels = [
                tag_key(equation.tag.as_deref()),
                name_key(equation.name.as_deref()),
            ];
            let keys = equation.keys.iter().map(|key| format!("{{{key}}}"));
            for label in labels.into_iter().flatten().chain(keys) {
                derivation.labels.entry(label).or_default().push(at);
            }
            for label in &equation.group {
                derivation.groups.entry(label.clone()).or_default().push(at);
            }
        }
        let all = 0..derivation.equations.len();
        derivation.cites = all.map(|at| derivation.find_premises(at)).collect();
        for (at, (cited, ..)) in derivation.cites.iter().enumerate() {
            for &old in cited.iter().filter(|_| derivation.equations[at].replaces) {
                derivation.replaced.entry(old).or_insert(at);
            }
        }
        for page in 0..derivation.pages.len() {
            let mut mentions: Tree<Symbol, Vec<usize>> = Tree::new();
            let mut neighbours = BTreeSet::from([page]);
            for at in derivation.equations_of(page) {
                let equation = &derivation.equations[at];
                let mut spoken_of = equation.symbols();
                spoken_of.extend(equation.functions());
                for symbol in &spoken_of {
                    mentions.entry(symbol.clone()).or_default().push(at);
                }
                derivation.spoken_of.push(spoken_of);
                let cited = derivation.cites[at].0.iter();
                neighbours.extend(cited.map(|&premise| derivation.equations[premise].page));
            }
            for symbol in mentions.keys() {
                derivation
                    .pages_of
                    .entry(symbol.clone())
                    .or_default()
                    .push(page);
            }
            let equations = &derivation.equations[derivation.equations_of(page)];
            let running = running::running(&derivation.pages[page], equations);
            derivation.mentions.push(mentions);
            derivation.neighbours.push(neighbours);
            derivation.running.push(running);
        }
        derivation
    }

    /// Reads one Markdown document.
    pub fn from_markdown(path: &str, source: &str) -> Self {
        Derivation::new(vec![Document::markdown(path, source)])
    }

    /// Reads one LaTeX document that stands alone: it takes in no other files.
    pub fn from_latex(path: &str, source: &str) -> Self {
        Derivation::new(Document::latex(path, source, &()))
    }

    /// The positions of the equations of a page.
    pub fn equations_of(&self, page: usize) -> Range<usize> {
        equation::of_page(page, &self.equations)
    }

    /// The first equation of the display that an equation is of.
    pub fn display_start(&self, at: usize) -> usize {
        at - self.equations[at].row.min(at)
    }

    /// The equations that share the number of one, itself among them: rows of one display.
    pub fn rows_of(&self, at: usize) -> Range<usize> {
        if self.equations[at].among.is_none() {
            return at..at + 1;
        }
        let after = self.equations[at + 1..].iter();
        let rows = after.take_while(|own| own.row > 0).count();
        self.display_start(at)..at + 1 + rows
    }

    /// The last equation of the display before that, on the same page.
    pub fn before_display(&self, at: usize) -> Option<usize> {
        let before = self.display_start(at).checked_sub(1)?;
        (self.equations[before].page == self.equations[at].page).then_some(before)
    }

    /// The equations of the display before that, on the same page.
    pub fn display_before(&self, at: usize) -> Range<usize> {
        match self.before_display(at) {
            Some(last) => self.display_start(last)..last + 1,
            None => at..at,
        }
    }

    /// The first equation of the section that an equation stands in.
    pub fn section_start(&self, at: usize) -> usize {
        let own = &self.equations[at];
        self.equations_of(own.page).start + own.section_start
    }

    /// Whether what is said at a place of the same page is said after that display.
    pub fn is_said_since(&self, at: usize, said: Span) -> bool {
        let before = self.before_display(at);
        before.is_none_or(|before| self.equations[before].span.end <= said.start)
    }
}
