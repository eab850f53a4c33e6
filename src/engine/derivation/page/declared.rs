//! What a page declares of symbols: where they lie, and their dimensions.

use num_traits::Zero;

use crate::algebra::{BigRational, Dimension, Symbol, as_printed, element_symbol};
use crate::dimension;
use crate::document::{Attribute, Bound, Directive, Item, Problem, Span, nearest};
use crate::kernel::Domain;
use crate::notation::{Spanned, read_symbol};
use crate::sorted::Tree;

use super::super::beside::{About, Clash, Place, narrows};
use super::super::meanings::{Meanings, section_ends};
use super::Page;

impl Page {
    /// Takes up what a document declares, and what that makes of its letters.
    pub(super) fn declarations(&mut self, items: &[Item], meanings: &mut Meanings) {
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

    pub(in crate::derivation) fn declare_dimension(
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

    pub(in crate::derivation) fn declare(
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
pub(in crate::derivation) fn narrow(domain: &mut Domain, attributes: &[Spanned<Attribute>]) {
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
pub(in crate::derivation) fn bounds_in(attributes: &[Spanned<Attribute>]) -> Domain {
    let mut domain = Domain::default();
    narrow(&mut domain, attributes);
    domain.constant = false;
    domain
}

/// Whether a domain is the same as another or says more of the same numbers: `> 1` after `positive`, but not `natural`.
pub(in crate::derivation) fn adds_to(own: &Domain, before: &Domain) -> bool {
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
pub(in crate::derivation) fn is_empty(domain: &Domain) -> bool {
    match (&domain.lower, &domain.upper) {
        (Some((low, open)), Some((high, closed))) => {
            low > high || low == high && (*open || *closed || domain.nonzero && low.is_zero())
        }
        _ => false,
    }
}

/// What is said of a symbol that no number is declared to be.
pub(in crate::derivation) fn no_value(symbol: &Symbol, span: Span) -> Problem {
    let shown = as_printed(symbol.name()).0;
    let message = format!("no number is all that `{shown}` is declared to be");
    let help =
        "let its bounds leave room between them; until then nothing is known of where it lies";
    Problem::new(span, message, help)
}

/// The dimension among the attributes of a declaration; what is none, and a second one, are problems.
pub(in crate::derivation) fn dimension_of(
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
