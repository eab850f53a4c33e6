//! A document with its declarations read, and the equations in it.

mod declared;
mod figures;

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::algebra::{Dimension, Expr, Formula, Relation, Symbol};
use crate::document::{
    Citation, Directive, Document, Inline, Item, Premise, Problem, Quantity, Row, Span,
};
use crate::kernel::Domain;
use crate::notation::{Context, Spanned, Statement, SyntaxError, read_symbol};
use crate::sorted::{self, Set, Tree};

use super::beside::{Beside, Clash, Place};
use super::called::{self, Called};
use super::equation::each_side;
use super::imaginary::is_imaginary_unit;
use super::meanings::Meanings;
use super::reader::Reader;
use super::supposed::Local;
use super::tabulated::tabulated;
use super::values::Printed;
use super::{Equation, approach, counts, differentials, doubts, names, sums};

pub(super) use self::declared::{adds_to, bounds_in, dimension_of, is_empty, narrow, no_value};
pub use self::figures::Datum;

/// Of no more words in parentheses it is asked whether they cite.
const MOST_REMARKS: usize = 64;
/// A shorter word in parentheses may be a number: "(ii)".
const SHORTEST_REMARK: usize = 4;

/// A document with its declarations read.
#[derive(Clone, Debug)]
pub struct Page {
    /// The document.
    pub document: Document,
    /// Its first heading.
    pub title: String,
    /// Where each declared symbol may lie.
    pub domains: Tree<Symbol, Domain>,
    /// The declared dimension of each symbol.
    pub dimensions: Tree<Symbol, Dimension>,
    /// Whether directives, or the file beside the document, say of equations that they are given or what they follow from. Where
    /// none does, the text alone says which are laws, however many symbols are declared.
    pub directs: bool,
    /// Whether its text speaks of means.
    pub speaks_of_means: bool,
    /// The quantity that the text says each symbol is, where it says that of some; nothing where it says different ones.
    pub quantities: Tree<Symbol, Option<Quantity>>,
    /// The figures for each symbol that has some.
    pub data: Tree<Symbol, Datum>,
    /// The symbols that stand for Euler's number: their powers are read as exponentials.
    pub euler: BTreeSet<Symbol>,
    /// Whether `e` is a quantity, and Euler's number where it is the base of powers that no quantity is raised to.
    pub has_both_e: bool,
    /// The imaginary unit where the document has one, and what is given by it: nothing is decided of these.
    pub complex: BTreeSet<Symbol>,
    /// Small changes, `\delta V`: of these nothing is decided either, for what is said of them is said up to their squares.
    pub small: BTreeSet<Symbol>,
    /// What is differentiated partially.
    pub dependent: Set<Symbol>,
    /// The same with the variable, where it is not clear what is held fixed: nothing that is said with it fails.
    pub unclear_slopes: Set<(Symbol, Symbol)>,
    /// Where the text leaves special cases, "In general", in order.
    pub(super) general: Vec<usize>,
    /// The sentences that say what is so at a place or in a case, in order.
    pub(super) of_places: Vec<Span>,
    /// Partial derivatives of terms that hold fixed what might depend on the variable: nothing is drawn from what is said with these.
    pub presumed_slopes: Set<Expr>,
    /// Everything supposed on the page, by `let` or `assuming`.
    pub locals: Vec<Local>,
    /// What could not be read, besides equations.
    pub problems: Vec<Problem>,
    /// Where each declared symbol is declared, what stands beside the document first.
    pub declared: Tree<Symbol, Vec<Place>>,
    /// What stands beside the document and holds in it too.
    pub beside: Option<Arc<Beside>>,
    /// Which of what that names as given was found here, by position.
    pub given: BTreeSet<usize>,
    /// What the document says otherwise.
    pub clashes: Vec<Clash>,
    /// What its text says goes somewhere, in order.
    pub(super) approaches: Vec<approach::Told>,
    /// What it tells of its notation, where that is in question.
    pub(super) context: Context,
    /// What its tables say that quantities are.
    pub(super) tabulated: Vec<Printed>,
}

/// Why nothing is decided of a formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// It speaks of what may be complex, and claims are about real numbers.
    Complex,
    /// It speaks of small changes, and is meant up to their squares.
    Small,
}

/// What an equation is said to follow from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Premises {
    /// A directive names them.
    Named(Vec<Spanned<Premise>>),
    /// The prose cites them.
    Cited(Vec<Citation>),
}

/// So often a page is read again for its functions.
const MOST_READINGS: usize = 3;

/// Reads a page and its equations, without regard to other pages: where an equation would define what it has on its left side,
/// [`definition::settle`](super::definition::settle) says whether it is the first to speak of it.
pub(super) fn read_page(
    document: Document,
    beside: Option<Arc<Beside>>,
    number: usize,
) -> (Page, Vec<Equation>) {
    let mut page = Page {
        title: String::new(),
        domains: Tree::new(),
        dimensions: Tree::new(),
        directs: false,
        speaks_of_means: false,
        quantities: Tree::new(),
        data: Tree::new(),
        euler: BTreeSet::new(),
        has_both_e: false,
        complex: BTreeSet::new(),
        small: BTreeSet::new(),
        dependent: Set::new(),
        unclear_slopes: Set::new(),
        general: Vec::new(),
        of_places: Vec::new(),
        presumed_slopes: Set::new(),
        locals: Vec::new(),
        problems: document.problems.clone(),
        declared: Tree::new(),
        given: BTreeSet::new(),
        clashes: Vec::new(),
        approaches: approach::told(&document),
        context: Context {
            has_concentrations: speaks_of_concentrations(&document.source),
            ..Context::default()
        },
        tabulated: tabulated(&document),
        document,
        beside,
    };
    // What a preamble declares was told of where it stands.
    let inherited = std::mem::take(&mut page.document.inherited);
    let mut items = std::mem::take(&mut page.document.items);
    forget_remarks(&page.document.source, &mut items);
    if let Some(beside) = page.beside.clone() {
        let mut own = page.clone();
        let mut meanings = Meanings::default();
        own.declarations(&inherited, &mut meanings);
        own.declarations(&items, &mut meanings);
        page.take_up(&beside, &own);
    }
    let mut meanings = Meanings::default();
    page.declarations(&inherited, &mut meanings);
    page.figures(&inherited, &meanings);
    page.problems.clone_from(&page.document.problems);
    page.document.inherited = inherited;
    page.declarations(&items, &mut meanings);
    page.figures(&items, &meanings);
    page.speaks_of_means = speaks_of_means(&page.document.source);
    page.directs = items.iter().any(directs)
        || page
            .beside
            .as_ref()
            .is_some_and(|beside| !beside.given.is_empty());
    let mut unread = page.clone();
    let (mut equations, mut derived) = read_items(&mut page, number, &items);
    let called = {
        let prose = items.iter().filter_map(|item| match item {
            Item::Prose(prose) => Some(&**prose),
            _ => None,
        });
        Called::of(&page.document.source, prose)
    };
    // The same letters are named again and again.
    let named = inline(&items).map(|math: &Inline| page.document.text(math.body));
    let named: BTreeSet<&str> = named.collect();
    let alone = named.into_iter().filter_map(|math| read_symbol(math).ok());
    let spoken_of: Set<Symbol> = alone.collect();
    unread.context.run = sums::run_through(&equations);
    unread.context.valued = names::with_values(&equations, &page.document.source, inline(&items));
    if unread.context.run.is_some() || !unread.context.valued.is_empty() {
        page = unread.clone();
        (equations, derived) = read_items(&mut page, number, &items);
    }
    let mut applied = names::in_question(&equations, &spoken_of);
    for attempt in 0..MOST_READINGS {
        if applied.is_empty() {
            break;
        }
        page = unread.clone();
        page.context.applied.clone_from(&applied);
        (equations, derived) = read_items(&mut page, number, &items);
        let alone = names::stand_alone(&equations, &applied);
        if alone.is_empty() {
            break;
        }
        applied.retain(|own| attempt + 2 < MOST_READINGS && !alone.contains(own));
        if applied.is_empty() {
            page = unread.clone();
            (equations, derived) = read_items(&mut page, number, &items);
        }
    }
    meanings.settle(&mut equations, &mut page.locals);
    for equation in &mut equations {
        leave_values_of_quantified(equation, &page.locals);
    }
    let declared =
        |name: &Symbol| page.domains.contains_key(name) || page.dimensions.contains_key(name);
    let in_text = || names::named_in_text(&page.document.source, inline(&items), &called);
    names::refuse(&mut equations, declared, in_text);
    called::refuse_products(&mut equations, &called.operators);
    called::refuse_products_of_vectors(&mut equations, &mut page.locals, &called.vectors);
    doubts::refuse(&mut equations, declared, spoken_of.iter().cloned());
    differentials::read(&mut page, &mut equations, &spoken_of);
    if let Some(beside) = page.beside.clone() {
        page.give(&beside, &mut equations, &derived);
    }
    counts::infer(&mut page, &equations);
    sorted::sort_by_key(&mut page.problems, |p| p.span);
    page.document.items = items;
    (page, equations)
}

/// Goes through the items of a page: its equations, and what is said to be derived.
fn read_items(
    page: &mut Page,
    number: usize,
    items: &[Item],
) -> (Vec<Equation>, Vec<Option<Span>>) {
    let mut reader = Reader::new(page, number, items);
    items.iter().for_each(|item| reader.item(item));
    reader.finish()
}

/// The mathematics in the text.
fn inline(items: &[Item]) -> impl Iterator<Item = &Inline> {
    let prose = items.iter().filter_map(|item| match item {
        Item::Prose(prose) => Some(&prose.math),
        _ => None,
    });
    prose.flatten()
}

/// Forgets what looks like a citation and is a remark: "the acceleration $a$ (downwards)". A word that is the number of no equation cites
/// none.
fn forget_remarks(source: &str, items: &mut [Item]) {
    let is_word = |own: &Citation| {
        let plain = !own.explicit && !own.key && own.tag.len() >= SHORTEST_REMARK;
        plain && own.tag.bytes().all(|byte| byte.is_ascii_lowercase())
    };
    let is_number = |tag: &str| {
        let printed = |own: &Row| own.number.as_deref() == Some(tag);
        let set = |item: &Item| match item {
            Item::Display { layout, .. } => {
                let rows = layout.iter().flat_map(|layout| &layout.rows);
                rows.into_iter().any(printed)
            }
            _ => false,
        };
        source.contains(&format!("\\tag{{{tag}}}")) || items.iter().any(set)
    };
    let mut remarks: BTreeSet<String> = BTreeSet::new();
    for item in items.iter() {
        if let Item::Prose(prose) = item {
            let words = prose.citations.iter().filter(|own| is_word(own));
            remarks.extend(words.take(MOST_REMARKS).map(|own| own.tag.clone()));
        }
    }
    let asked = remarks.into_iter().take(MOST_REMARKS);
    let remarks: BTreeSet<String> = asked.filter(|own| !is_number(own)).collect();
    for item in items {
        if let Item::Prose(prose) = item
            && !remarks.is_empty()
        {
            prose.drop_citations(|own| is_word(own) && remarks.contains(&own.tag));
        }
    }
}

/// Whether words of a text speak of means: what a bar above the name of a sequence stands for.
fn speaks_of_means(source: &str) -> bool {
    has_word_among(source, &["mean", "means", "average", "averages"])
}

/// Whether words of a text speak of concentrations, which are written with brackets.
fn speaks_of_concentrations(source: &str) -> bool {
    let words = [
        "concentration",
        "concentrations",
        "enzyme",
        "reactant",
        "reactants",
        "ligand",
    ];
    has_word_among(source, &words)
}

fn has_word_among(source: &str, such: &[&str]) -> bool {
    let mut words = source.split(|c: char| !c.is_alphabetic());
    words.any(|word| such.contains(&word))
}

/// Whether a directive says of an equation that it is given, or what it follows from.
fn directs(item: &Item) -> bool {
    use Directive::{Derived, From, Given};
    let Item::Directives { clauses, .. } = item else {
        return false;
    };
    let says_so = |clause: &Spanned<Directive>| matches!(clause.value, Given | Derived | From(_));
    clauses.iter().any(says_so)
}

/// What is said for all `x` is not said of the `x = 1` that is supposed around it.
fn leave_values_of_quantified(equation: &mut Equation, locals: &[Local]) {
    let quantified = equation.statements().iter().map(|own| &own.quantified);
    let quantified: Set<Symbol> = quantified.flatten().cloned().collect();
    if quantified.is_empty() {
        return;
    }
    let is_number = |formula: &Arc<Formula>| match &**formula {
        Formula::Relation {
            left: Expr::Symbol(symbol),
            relation: Relation::Equal,
            ..
        } => quantified.contains(symbol) && formula.names().len() == 1,
        _ => false,
    };
    let stays = |local: &usize| !locals[*local].formulas.iter().any(is_number);
    for own in [
        &mut equation.locals,
        &mut equation.told,
        &mut equation.named,
    ] {
        own.retain(stays);
    }
}

/// The pages of each document: what LaTeX puts together from several files is one, and so is all else that is read together.
pub(super) fn of_documents(pages: &[Page]) -> Vec<Vec<usize>> {
    let mut documents: Tree<Option<usize>, Vec<usize>> = Tree::new();
    let mut first = 0;
    for (at, page) in pages.iter().enumerate() {
        let before = &pages[first].document;
        if !before.is_latex || !Arc::ptr_eq(&page.document.origin, &before.origin) {
            first = at;
        }
        let document = page.document.is_latex.then_some(first);
        documents.entry(document).or_default().push(at);
    }
    documents.into_values().collect()
}

impl Page {
    /// Whether its author says more of it than the text does, in directives about equations or in a file beside it.
    pub(crate) fn is_annotated(&self) -> bool {
        self.directs || self.beside.is_some()
    }

    pub(super) fn complain(&mut self, error: SyntaxError) {
        self.problems.push(Problem {
            span: error.span,
            message: error.message,
            help: error.help,
        });
    }

    /// A complaint about a part of a directive that was read by itself.
    fn complain_at(&mut self, part: Span, error: SyntaxError) {
        let span = Span::new(part.start + error.span.start, part.start + error.span.end);
        self.complain(SyntaxError { span, ..error });
    }

    /// Reads `e^x` as `\exp(x)`, where e is declared to be Euler's number.
    pub(super) fn read_exponentials<'a>(
        &self,
        statements: impl Iterator<Item = &'a mut Statement>,
    ) {
        if self.euler.is_empty() && !self.has_both_e {
            return;
        }
        for statement in statements {
            each_side(statement, &mut |term, _| {
                *term = self.with_exponentials(term)
            });
        }
    }

    /// Whether a symbol is the imaginary unit here.
    pub fn is_imaginary_unit(&self, symbol: &Symbol) -> bool {
        self.complex.contains(symbol) && is_imaginary_unit(symbol)
    }

    /// Whether a formula ties small changes to one another as differentials, `\frac{\delta V}{V} = 3 \frac{\delta r}{r}`: so it is meant as it
    /// stands.
    fn is_of_differentials(&self, formula: &Formula) -> bool {
        let order = |side: &Expr| order_in(side, &self.small);
        match formula.as_equation() {
            Some((left, right)) => {
                let orders = order(left).zip(order(right));
                orders.is_some_and(|(left, right)| left == right && left.abs() <= 1)
            }
            None => false,
        }
    }

    /// Whether a formula speaks of something of which nothing is decided.
    pub fn beyond(&self, formula: &Formula) -> Option<Beyond> {
        if self.complex.is_empty() && self.small.is_empty() {
            return None;
        }
        let names = formula.names();
        let speaks = |of: &BTreeSet<Symbol>| names.iter().any(|own| of.contains(own));
        match (speaks(&self.complex), speaks(&self.small)) {
            (true, _) => Some(Beyond::Complex),
            (false, true) => (!self.is_of_differentials(formula)).then_some(Beyond::Small),
            (false, false) => None,
        }
    }
}

/// The order of a term in what is small, where all of it is of one.
fn order_in(term: &Expr, small: &BTreeSet<Symbol>) -> Option<i64> {
    let order = |own: &Expr| order_in(own, small);
    match term {
        Expr::Symbol(own) => Some(i64::from(small.contains(own))),
        Expr::Negate(inner) => order(inner),
        Expr::Product(factors) => factors.iter().map(order).sum(),
        Expr::Quotient(above, below) => Some(order(above)? - order(below)?),
        Expr::Sum(summands) => {
            let mut orders = summands.iter().map(order);
            let first = orders.next()??;
            orders.all(|own| own == Some(first)).then_some(first)
        }
        other => {
            let names = Formula::names_in(std::iter::once(other));
            (!names.iter().any(|own| small.contains(own))).then_some(0)
        }
    }
}
