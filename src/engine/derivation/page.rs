use std::collections::BTreeSet;
use std::sync::Arc;

use num_traits::Zero;

use crate::algebra::{
    BigRational, Dimension, Expr, Formula, Function, Relation, Symbol, as_printed, element_symbol,
};
use crate::dimension;
use crate::document::{
    Attribute, Bound, Citation, Directive, Document, Inline, Item, Premise, Problem, Row, Span,
    nearest,
};
use crate::kernel::Domain;
use crate::notation::{Spanned, Statement, SyntaxError, read_symbol};
use crate::sorted::{self, Set, Tree};

use super::approach;
use super::beside::{About, Beside, Clash, Place, narrows};
use super::equation::each_side;
use super::meanings::{Meanings, section_ends};
use super::reader::Reader;
use super::supposed::Local;
use super::{Equation, counts, differentials, doubts, names};

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
    /// The figures for each symbol that has some.
    pub data: Tree<Symbol, Datum>,
    /// The symbols that stand for Euler's number: their powers are read as exponentials.
    pub euler: BTreeSet<Symbol>,
    /// The imaginary unit where the document has one, and what is given by it: nothing is decided of these.
    pub complex: BTreeSet<Symbol>,
    /// What is differentiated partially.
    pub dependent: Set<Symbol>,
    /// The same with the variable, where it is not clear what is held fixed: nothing that is said with it fails.
    pub unclear_slopes: Set<(Symbol, Symbol)>,
    /// Where the text leaves special cases, "In general", in order.
    pub(super) general: Vec<usize>,
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
}

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
}

/// What an equation is said to follow from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Premises {
    /// A directive names them.
    Named(Vec<Spanned<Premise>>),
    /// The prose cites them.
    Cited(Vec<Citation>),
}

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
        data: Tree::new(),
        euler: BTreeSet::new(),
        complex: BTreeSet::new(),
        dependent: Set::new(),
        unclear_slopes: Set::new(),
        general: Vec::new(),
        presumed_slopes: Set::new(),
        locals: Vec::new(),
        problems: document.problems.clone(),
        declared: Tree::new(),
        given: BTreeSet::new(),
        clashes: Vec::new(),
        approaches: approach::told(&document),
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
    page.directs = items.iter().any(directs)
        || page
            .beside
            .as_ref()
            .is_some_and(|beside| !beside.given.is_empty());
    let mut reader = Reader::new(&mut page, number, &items);
    items.iter().for_each(|item| reader.item(item));
    let (mut equations, derived) = reader.finish();
    meanings.settle(&mut equations, &mut page.locals);
    for equation in &mut equations {
        leave_values_of_quantified(equation, &page.locals);
    }
    let declared =
        |name: &Symbol| page.domains.contains_key(name) || page.dimensions.contains_key(name);
    names::refuse(&mut equations, declared);
    let prose = items.iter().filter_map(|item| match item {
        Item::Prose(prose) => Some(&prose.math),
        _ => None,
    });
    // The same letters are named again and again.
    let named = prose
        .flatten()
        .map(|math: &Inline| page.document.text(math.body));
    let named: BTreeSet<&str> = named.collect();
    let alone = named.into_iter().filter_map(|math| read_symbol(math).ok());
    let spoken_of: Set<Symbol> = alone.collect();
    let is_symbol = |name: &Symbol| declared(name) || spoken_of.contains(name);
    doubts::refuse(&mut equations, declared, spoken_of.iter().cloned());
    differentials::refuse(&mut equations, is_symbol);
    if let Some(beside) = page.beside.clone() {
        page.give(&beside, &mut equations, &derived);
    }
    counts::infer(&mut page, &equations);
    sorted::sort_by_key(&mut page.problems, |p| p.span);
    page.document.items = items;
    (page, equations)
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

/// Reads powers of Euler's number as exponentials.
pub(super) fn exponentials(term: &Expr, euler: &BTreeSet<Symbol>) -> Expr {
    let is_euler = |term: &Expr| matches!(term, Expr::Symbol(symbol) if euler.contains(symbol));
    let raised = |exponent: Expr| Expr::Call(Function::Exp, exponent.into());
    match term {
        Expr::Power(base, exponent) if is_euler(base) => raised(exponentials(exponent, euler)),
        term if is_euler(term) => raised(Expr::integer(1)),
        term => term.map_children(|child| exponentials(child, euler)),
    }
}

impl Page {
    pub(super) fn complain(&mut self, error: SyntaxError) {
        self.problems.push(Problem {
            span: error.span,
            message: error.message,
            help: error.help,
        });
    }

    /// Takes up what a document declares, and what that makes of its letters.
    fn declarations(&mut self, items: &[Item], meanings: &mut Meanings) {
        let mut section = None;
        for (item, end) in items.iter().zip(section_ends(items)) {
            if let Item::Heading { span, .. } = item {
                section = Some(Span::new(span.start, end));
            }
            let Item::Directives { clauses, .. } = item else {
                continue;
            };
            for clause in clauses {
                let Directive::Symbols { names, attributes } = &clause.value else {
                    continue;
                };
                let dimension = dimension_of(attributes, &mut self.problems);
                for &span in names {
                    match read_symbol(self.document.text(span)) {
                        Ok(letter) => {
                            let said = (&attributes[..], dimension.as_ref());
                            let symbol = self.declared_as(&letter, span, said, section, meanings);
                            let bounded = &mut meanings.bounded;
                            match self.bounded_otherwise(&symbol, span, attributes, bounded) {
                                true => self.declare(symbol.clone(), span, &unbounded(attributes)),
                                false => self.declare(symbol.clone(), span, attributes),
                            }
                            self.declare_dimension(symbol, span, dimension.as_ref());
                        }
                        Err(error) => self.complain_at(span, error),
                    }
                }
            }
        }
    }

    /// Whether a declaration says that a symbol lies elsewhere than the document has said before; that is told.
    ///
    /// Put together, the two would prove of one quantity what is so of another that has the same letter.
    fn bounded_otherwise(
        &mut self,
        symbol: &Symbol,
        own: Span,
        attributes: &[Spanned<Attribute>],
        bounded: &mut Tree<Symbol, (Domain, Span)>,
    ) -> bool {
        let domain = bounds_in(attributes);
        match bounded.get(symbol) {
            _ if domain == Domain::default() => false,
            Some((before, first)) if !adds_to(&domain, before) => {
                let about = About::TwoDomains(symbol.clone());
                let beside = *first;
                self.clashes.push(Clash { about, own, beside });
                true
            }
            Some(_) => false,
            None => {
                bounded.insert(symbol.clone(), (domain, own));
                false
            }
        }
    }

    /// A complaint about a part of a directive that was read by itself.
    fn complain_at(&mut self, part: Span, error: SyntaxError) {
        let span = Span::new(part.start + error.span.start, part.start + error.span.end);
        self.complain(SyntaxError { span, ..error });
    }

    /// The `data` clauses.
    fn figures(&mut self, items: &[Item], meanings: &Meanings) {
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

    pub(super) fn declare_dimension(
        &mut self,
        symbol: Symbol,
        span: Span,
        dimension: Option<&Dimension>,
    ) {
        let Some(dimension) = dimension else {
            return;
        };
        let before = self.dimensions.get(&symbol);
        if before.is_some_and(|before| before != dimension) {
            self.problems.push(Problem::new(
                span,
                format!(
                    "`{}` is declared with two dimensions on this page: does it stand for two quantities?",
                    as_printed(symbol.name()).0
                ),
                "give one of the two another name, or declare it below a heading of its own; until then the first counts",
            ));
            return;
        }
        self.dimensions.insert(symbol, dimension.clone());
    }

    pub(super) fn declare(
        &mut self,
        symbol: Symbol,
        span: Span,
        attributes: &[Spanned<Attribute>],
    ) {
        let is_dimension = |a: &Spanned<Attribute>| matches!(a.value, Attribute::Dimension(_));
        let dimension = attributes.iter().any(is_dimension);
        let places = self.declared.entry(symbol.clone()).or_default();
        places.push(Place { span, dimension });
        if attributes.iter().any(|a| a.value == Attribute::Euler) {
            self.euler.insert(symbol.clone());
        }
        let domain = self.domains.entry(symbol.clone()).or_default();
        narrow(domain, attributes);
        if is_empty(domain) {
            // From what is nowhere anything would follow.
            *domain = Domain::default();
            self.problems.push(no_value(&symbol, span));
        }
    }

    /// Reads `e^x` as `\exp(x)`, where e is declared to be Euler's number.
    pub(super) fn read_exponentials<'a>(
        &self,
        statements: impl Iterator<Item = &'a mut Statement>,
    ) {
        if self.euler.is_empty() {
            return;
        }
        for statement in statements {
            each_side(statement, &mut |term, _| {
                *term = exponentials(term, &self.euler)
            });
        }
    }

    /// The domain of the elements of a sequence: that declared for `u_i`, whatever the index is called.
    pub fn element_domain(&self, sequence: &Symbol) -> Option<&Domain> {
        of_elements(&self.domains, sequence)
    }

    /// The name by which the page declares a symbol, or the elements of a sequence: `u` is declared as `u_i`.
    pub fn declared_name(&self, symbol: &Symbol) -> Option<&Symbol> {
        let own = self.declared.get_key_value(symbol);
        own.map(|(name, _)| name).or_else(|| {
            let (name, _) = elements_of(&self.declared, symbol)?;
            Some(name)
        })
    }

    /// Whether a symbol is declared by itself.
    pub fn is_declared(&self, symbol: &Symbol) -> bool {
        self.declared.contains_key(symbol)
    }

    /// Whether a formula speaks of something that may be complex.
    pub fn is_complex(&self, formula: &Formula) -> bool {
        !self.complex.is_empty() && formula.names().iter().any(|own| self.complex.contains(own))
    }

    /// The dimension of the elements of a sequence: that declared for `u_i`, for `u`, or for `u_1`.
    pub fn element_dimension(&self, sequence: &Symbol) -> Option<&Dimension> {
        let element = || self.dimensions.get(&element_symbol(sequence, 1));
        let own = of_elements(&self.dimensions, sequence);
        own.or_else(|| self.dimensions.get(sequence))
            .or_else(element)
    }
}

/// What is declared for `u_i`, whatever the index is called.
fn of_elements<'a, T>(declared: &'a Tree<Symbol, T>, sequence: &Symbol) -> Option<&'a T> {
    elements_of(declared, sequence).map(|(_, value)| value)
}

fn elements_of<'a, T>(
    declared: &'a Tree<Symbol, T>,
    sequence: &Symbol,
) -> Option<(&'a Symbol, &'a T)> {
    let prefix = format!("{sequence}_");
    let is_index = |rest: &str| rest.len() == 1 && rest.chars().all(|c| c.is_ascii_lowercase());
    let mut declared = declared.iter();
    declared.find(|(s, _)| s.name().strip_prefix(&prefix).is_some_and(is_index))
}

/// Adds to a domain what attributes say of it.
pub(super) fn narrow(domain: &mut Domain, attributes: &[Spanned<Attribute>]) {
    let at = |bound: &Bound| (bound.value.clone(), bound.strict);
    let number = |n: i32, strict| (BigRational::from_integer(n.into()), strict);
    for attribute in attributes {
        match &attribute.value {
            Attribute::Dimension(_) | Attribute::Real | Attribute::Euler => {}
            Attribute::Positive => domain.lower = Some(number(0, true)),
            Attribute::Nonnegative => domain.lower = Some(number(0, false)),
            Attribute::Nonzero => domain.nonzero = true,
            Attribute::Integer => domain.integer = true,
            Attribute::Natural => {
                domain.integer = true;
                domain.lower = Some(number(1, false));
            }
            Attribute::Constant => domain.constant = true,
            Attribute::Interval { lower, upper } => {
                domain.lower = lower.as_ref().map(at).or(domain.lower.take());
                domain.upper = upper.as_ref().map(at).or(domain.upper.take());
            }
        }
    }
}

/// Where attributes say that a symbol lies, whether or not it changes.
pub(super) fn bounds_in(attributes: &[Spanned<Attribute>]) -> Domain {
    let mut domain = Domain::default();
    narrow(&mut domain, attributes);
    domain.constant = false;
    domain
}

/// Whether a domain is the same as another or says more of the same numbers: `> 1` after `positive`, but not `natural`.
pub(super) fn adds_to(own: &Domain, before: &Domain) -> bool {
    own == before || own.integer == before.integer && narrows(own, before)
}

/// A declaration without what it says of where symbols lie.
fn unbounded(attributes: &[Spanned<Attribute>]) -> Vec<Spanned<Attribute>> {
    use Attribute::{Constant, Dimension, Euler, Real};
    let kept =
        |own: &&Spanned<Attribute>| matches!(own.value, Dimension(_) | Constant | Euler | Real);
    attributes.iter().filter(kept).cloned().collect()
}

/// Whether the bounds of a domain leave no number between them.
pub(super) fn is_empty(domain: &Domain) -> bool {
    match (&domain.lower, &domain.upper) {
        (Some((low, open)), Some((high, closed))) => {
            low > high || low == high && (*open || *closed || domain.nonzero && low.is_zero())
        }
        _ => false,
    }
}

/// What is said of a symbol that no number is declared to be.
pub(super) fn no_value(symbol: &Symbol, span: Span) -> Problem {
    let shown = as_printed(symbol.name()).0;
    let message = format!("no number is all that `{shown}` is declared to be");
    let help =
        "let its bounds leave room between them; until then nothing is known of where it lies";
    Problem::new(span, message, help)
}

/// The dimension among the attributes of a declaration; what is none, and a second one, are problems.
pub(super) fn dimension_of(
    attributes: &[Spanned<Attribute>],
    problems: &mut Vec<Problem>,
) -> Option<Dimension> {
    let mut read: Option<Dimension> = None;
    for attribute in attributes {
        let Attribute::Dimension(text) = &attribute.value else {
            continue;
        };
        match dimension::parse(text) {
            Ok(own) if read.as_ref().is_some_and(|other| *other != own) => {
                problems.push(Problem::new(
                    attribute.span,
                    format!("`{text}` is a second dimension"),
                    "a declaration has one dimension; write a product with a space, `M L`",
                ));
            }
            Ok(own) => read = Some(own),
            Err(error) => {
                let start = attribute.span.start;
                let span = Span::new(start + error.at.start, start + error.at.end);
                problems.push(Problem {
                    span,
                    message: error.message,
                    help: Some(dimension_help(error.word.as_deref())),
                });
            }
        }
    }
    read
}

/// What to write instead of what is no dimension.
fn dimension_help(word: Option<&str>) -> String {
    let names: Vec<&str> = dimension::names().collect();
    let near = word.and_then(|word| {
        let slips = if word.len() < 6 { 1 } else { 2 };
        nearest(word, &names, slips)
    });
    match near {
        Some(near) => format!("did you mean `{near}`?"),
        None => "a dimension is a name (`mass`, `velocity`, `energy/temperature`) or a product of powers of the bases \
                 `M L T I \\Theta N J`, such as `M L^{-1/2} T^{-2}`"
            .into(),
    }
}
