use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use num_traits::Zero;

use crate::algebra::{BigRational, Dimension, Expr, Formula, Function, Symbol, element_symbol};
use crate::dimension;
use crate::document::{
    Attribute, Bound, Citation, Directive, Document, Extent, Item, Premise, Problem, Span,
    Supposition, SuppositionKind, Vanishing,
};
use crate::document::{above_signs, nearest};
use crate::kernel::Domain;
use crate::notation::{Spanned, Statement, SyntaxError, read_symbol};

use super::beside::{Beside, Clash, Place};
use super::definition::Known;
use super::equation::each_side;
use super::rows::Part;
use super::supposed::{Local, said_of_moment, slope_by};
use super::{Equation, Kind, counts, names, rows};
use crate::sorted::Set;

/// Of the values that a piece of text names, so many are looked at.
const MOST_MENTIONED: usize = 6;

/// A document with its declarations read.
#[derive(Clone, Debug)]
pub struct Page {
    /// The document.
    pub document: Document,
    /// Its first heading.
    pub title: String,
    /// Where each declared symbol may lie.
    pub domains: BTreeMap<Symbol, Domain>,
    /// The declared dimension of each symbol.
    pub dimensions: BTreeMap<Symbol, Dimension>,
    /// The figures for each symbol that has some.
    pub data: BTreeMap<Symbol, Datum>,
    /// The symbols that stand for Euler's number: their powers are read as exponentials.
    pub euler: BTreeSet<Symbol>,
    /// Everything supposed on the page, by `let` or `assuming`.
    pub locals: Vec<Local>,
    /// What could not be read, besides equations.
    pub problems: Vec<Problem>,
    /// Where each declared symbol is declared, what stands beside the document first.
    pub declared: BTreeMap<Symbol, Vec<Place>>,
    /// What stands beside the document and holds in it too.
    pub beside: Option<Arc<Beside>>,
    /// Which of what that names as given was found here, by position.
    pub given: BTreeSet<usize>,
    /// What the document says otherwise.
    pub clashes: Vec<Clash>,
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

/// What is said between one display and the next.
#[derive(Default)]
struct Between {
    given: bool,
    derived: bool,
    from: Option<Vec<Spanned<Premise>>>,
    name: Option<String>,
    numeric: Option<Option<BigRational>>,
    /// What says that the display is derived.
    derives: Option<Span>,
    cited: Vec<Citation>,
    mentioned: Vec<Span>,
    /// Whether words say that the display follows from something.
    concludes: Option<bool>,
    /// Whether they cite something just before the display.
    cites: bool,
    /// Whether they say what something is meant by.
    defines: bool,
    /// Whether they go on from the display before.
    relative: bool,
    /// Whether they give a reason that is no equation.
    reasons: bool,
    /// Whether they are a mere "where" or "with".
    meant: bool,
    /// Of how much the display is said.
    extent: Option<Extent>,
    /// Where a slope is said to be zero that nobody has written yet.
    slope: Option<Span>,
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
        domains: BTreeMap::new(),
        dimensions: BTreeMap::new(),
        data: BTreeMap::new(),
        euler: BTreeSet::new(),
        locals: Vec::new(),
        problems: document.problems.clone(),
        declared: BTreeMap::new(),
        given: BTreeSet::new(),
        clashes: Vec::new(),
        document,
        beside,
    };
    // What a preamble declares was told of where it stands.
    let inherited = std::mem::take(&mut page.document.inherited);
    let items = std::mem::take(&mut page.document.items);
    if let Some(beside) = page.beside.clone() {
        let mut own = page.clone();
        own.declarations(&inherited);
        own.declarations(&items);
        page.take_up(&beside, &own);
    }
    page.declarations(&inherited);
    page.figures(&inherited);
    page.problems.clone_from(&page.document.problems);
    page.document.inherited = inherited;
    page.declarations(&items);
    page.figures(&items);
    let mut ahead = rows::read_ahead(&page.document.source, &items).into_iter();
    let mut equations: Vec<Equation> = Vec::new();
    // Of each equation, what says that it is derived.
    let mut derived: Vec<Option<Span>> = Vec::new();
    let mut active: Vec<usize> = Vec::new();
    let mut between = Between::default();
    // Whether nothing that introduces the next display makes it a step: at the beginning and after a heading nothing does.
    let mut bare = true;
    // The equations of the display that the text goes on from.
    let mut last = 0..0;
    // What is told in passing.
    let mut told: Vec<usize> = Vec::new();
    // The cases whose sentence goes on with the next display.
    let mut running: Vec<usize> = Vec::new();
    // Of how much the display before is said.
    let mut extent = Extent::Throughout;
    let mut known = Known::default();
    // The same with the last display.
    let mut spoken_of = Known::default();
    let (mut level, mut section) = (0, String::new());
    for item in &items {
        match item {
            &Item::Heading {
                level: own,
                ref title,
                ..
            } => {
                if page.title.is_empty() {
                    page.title = title.clone();
                }
                (level, section) = (own, title.clone());
                (last, bare, extent) = (0..0, true, Extent::Throughout);
                active.retain(|&at| page.locals[at].level < own && !page.locals[at].is_momentary());
                told.retain(|&at| page.locals[at].level < own);
            }
            Item::Prose(prose) => {
                let tail = if last.is_empty() { 0 } else { prose.tail };
                let (of_last, own) = prose.citations.split_at(tail);
                between.cited.extend(own.iter().cloned());
                for equation in &mut equations[last.clone()] {
                    equation.cite(of_last, prose.says_from);
                }
                between.relative |= prose.is_relative && between.concludes.is_none();
                between.concludes = prose.concludes.or(between.concludes);
                between.reasons |= prose.reasons;
                between.meant |= prose.says_what_is_meant;
                between.extent = prose.extent.or(between.extent);
                between.cites |= prose.cites;
                between.defines |= prose.defines;
                let mut mentioned = prose.mentions.clone();
                if prose.suppositions.iter().any(|s| s.kind.begins_a_case()) {
                    told.retain(|&at| !page.locals[at].of_case);
                }
                for &Supposition { kind, body } in &prose.suppositions {
                    if let SuppositionKind::General | SuppositionKind::Elsewhere = kind {
                        let all = kind == SuppositionKind::General;
                        active.retain(|&at| !page.locals[at].is_left_by(all));
                        continue;
                    }
                    if kind == SuppositionKind::Moment {
                        let (new, passage) = (page.locals.len().., equations.len());
                        page.begin_moment(passage, false, &[], &mut active);
                        page.suppose(body, SuppositionKind::Assume, level, &mut active, false);
                        page.date(new.clone(), passage);
                        page.leave_other_values(new, &mut active);
                        continue;
                    }
                    if let SuppositionKind::Fact { runs_on, .. } = kind {
                        let new = page.locals.len()..;
                        page.suppose(body, kind, level, &mut told, false);
                        page.date_with(new, &active);
                        told.retain(|&at| runs_on || page.locals[at].set.is_empty());
                        continue;
                    }
                    if let SuppositionKind::Vanishes(what) = kind {
                        let passage = equations.len();
                        match page.vanishing(what, body, &equations) {
                            Some(term) if what == Vanishing::Told => {
                                told.push(page.suppose_zero(term, body, None));
                            }
                            Some(term) => {
                                page.begin_moment(passage, false, &[], &mut active);
                                active.push(page.suppose_zero(term, body, Some(passage)));
                            }
                            None if what == Vanishing::Slope => between.slope = Some(body),
                            None => {}
                        }
                        continue;
                    }
                    if kind == SuppositionKind::Known {
                        page.suppose(body, kind, level, &mut told, false);
                        continue;
                    }
                    if kind == SuppositionKind::Define
                        && !known.says_what_is_meant(body, &page, &equations, last.clone())
                    {
                        mentioned.push(body);
                        continue;
                    }
                    let before = page.locals.len();
                    spoken_of.learn(&equations, &page.locals);
                    page.suppose(body, kind, level, &mut active, false);
                    page.restrict(before.., &spoken_of);
                    if kind == (SuppositionKind::Case { runs_on: true }) {
                        running.extend(before..page.locals.len());
                    }
                    if kind == SuppositionKind::Define {
                        for equation in &mut equations[last.clone()] {
                            equation.locals.extend(before..page.locals.len());
                        }
                    }
                }
                page.leave_passages(&mut active);
                page.forget_moments(&active, &mut told);
                mentioned.truncate(MOST_MENTIONED);
                for equation in &mut equations[std::mem::take(&mut last)] {
                    equation.mentioned.extend(&mentioned);
                }
                between.mentioned.extend(mentioned);
                between.mentioned.truncate(MOST_MENTIONED);
            }
            Item::Directives { clauses, .. } => {
                for clause in clauses {
                    if let Directive::Derived | Directive::From(_) | Directive::Numeric(_) =
                        &clause.value
                    {
                        between.derives = Some(clause.span);
                    }
                    match &clause.value {
                        Directive::Given => between.given = true,
                        Directive::Derived => between.derived = true,
                        Directive::From(premises) => between.from = Some(premises.clone()),
                        Directive::Claim(name) => between.name = Some(name.value.clone()),
                        Directive::Assuming(body) => {
                            let kind = SuppositionKind::Assume;
                            page.suppose(*body, kind, level, &mut active, true);
                        }
                        Directive::Let(body) => {
                            page.suppose(*body, SuppositionKind::Let, level, &mut active, true);
                        }
                        Directive::Numeric(near) => between.numeric = Some(near.clone()),
                        Directive::Symbols { .. } | Directive::Data { .. } => {}
                    }
                }
            }
            Item::Display { span, body, layout } => {
                let (span, body) = (*span, *body);
                let mut said = std::mem::take(&mut between);
                let source = &page.document.source;
                said.cited.extend(above_signs(source, body));
                let read = ahead.next();
                let mut read = read.unwrap_or_else(|| rows::read(source, body, layout.as_deref()));
                let statements = read.iter_mut().flat_map(|row| row.statements.as_mut());
                page.read_exponentials(statements.flatten());
                page.leave_cases(&read, &running, &mut active);
                if let Some(span) = said.slope
                    && let Some(slope) = slope_by(&read, &equations)
                {
                    let passage = equations.len();
                    page.begin_moment(passage, false, &[], &mut active);
                    active.push(page.suppose_zero(slope, span, Some(passage)));
                }
                // "Torricelli's law @eq-law:" announces what is displayed next.
                let announces = |cited: &Citation| {
                    read.iter().any(|part| match cited.key {
                        true => part.keys.contains(&cited.tag),
                        false => part.tag.as_ref() == Some(&cited.tag),
                    })
                };
                let alone =
                    equations.is_empty() && said.cited.iter().all(announces) && said.from.is_none();
                // Where nothing is said between two displays, they are introduced together.
                let uncited = said.cited.is_empty()
                    && !(said.given
                        || said.derived
                        || said.from.is_some()
                        || said.numeric.is_some());
                bare = uncited
                    && match said.concludes {
                        Some(concludes) => !concludes || said.reasons,
                        None => bare,
                    };
                // What is announced is not cited.
                let cites = said.cites && !said.cited.iter().all(announces);
                let drawn = (said.concludes == Some(true) || cites) && !said.defines;
                let of_display = read.len();
                let goes_on = matches!(said.extent, None | Some(Extent::AsBefore));
                extent = match said.extent {
                    _ if !bare => Extent::Throughout,
                    None | Some(Extent::AsBefore) => extent,
                    Some(extent) => extent,
                };
                let at_moment: Vec<Vec<Formula>> = match extent {
                    Extent::Moment | Extent::Condition => {
                        spoken_of.learn(&equations, &page.locals);
                        let is_known = |symbol: &Symbol| spoken_of.speaks_of(symbol);
                        let of = |part: &Part| {
                            let statements = part.statements.iter().flatten();
                            let said = |s| said_of_moment(s, extent, is_known);
                            statements.filter_map(said).collect()
                        };
                        read.iter().map(of).collect()
                    }
                    _ => vec![Vec::new(); of_display],
                };
                let passage = match at_moment.iter().all(Vec::is_empty) {
                    true => {
                        let is_derived = drawn || !said.cited.iter().all(announces);
                        page.leave_moments(&read, is_derived, &mut active);
                        None
                    }
                    false => {
                        Some(page.begin_moment(equations.len(), goes_on, &running, &mut active))
                    }
                };
                running.clear();
                page.forget_moments(&active, &mut told);
                last = equations.len()..equations.len() + of_display;
                let mut name = said.name;
                for (row, (part, at_moment)) in read.into_iter().zip(at_moment).enumerate() {
                    let statements = || part.statements.iter().flatten();
                    let mark = statements().any(|s| s.mark.is_some());
                    let kind = match () {
                        () if said.given => Kind::Given,
                        () if said.numeric.is_some() => Kind::Derived,
                        () if mark => Kind::Marked,
                        () => Kind::Derived,
                    };
                    let by_cases = statements().find(|s| !s.under.is_empty());
                    let by_cases = by_cases.filter(|_| said.numeric.is_some()).map(|s| s.span);
                    let stated = said.derived || said.numeric.is_some();
                    let may_define = kind == Kind::Derived && !stated && said.from.is_none();
                    let defines = (0..statements().count()).filter(|_| may_define).collect();
                    derived.push(said.derives);
                    let at = equations.len();
                    equations.push(Equation {
                        page: number,
                        tag: part.tag,
                        keys: part.keys,
                        group: part.group,
                        // A claim is one display; where that has several numbers the name is that of the last.
                        name: match row + 1 == of_display {
                            true => name.take(),
                            false => None,
                        },
                        span: if of_display == 1 { span } else { part.body },
                        body: part.body,
                        statements: match by_cases {
                            None => part.statements,
                            Some(span) => Err(SyntaxError {
                                span,
                                message: "a numeric claim is not read by cases".into(),
                                help: None,
                            }),
                        },
                        kind,
                        defines,
                        introduces: Set::new(),
                        explains: false,
                        opens: alone && kind == Kind::Derived && !stated,
                        relative: said.relative,
                        bare: bare && kind == Kind::Derived && part.continues == 0,
                        uncited: uncited && kind == Kind::Derived && part.continues == 0,
                        reasons: said.reasons,
                        meant: said.meant,
                        extent,
                        moments: 0..0,
                        drawn: drawn && kind == Kind::Derived,
                        numeric: said.numeric.clone().filter(|_| kind != Kind::Given),
                        premises: match &said.from {
                            Some(named) => Premises::Named(named.clone()),
                            None => Premises::Cited(said.cited.clone()),
                        },
                        row,
                        continues: part.continues,
                        locals: active.clone(),
                        told: told.iter().rev().take(MOST_MENTIONED).copied().collect(),
                        mentioned: said.mentioned.clone(),
                        section: section.clone(),
                    });
                    if let Some((equation, passage)) = equations.last_mut().zip(passage) {
                        let display = (at, equation.body);
                        equation.moments =
                            page.suppose_at_moment(at_moment, display, passage, &mut active);
                    }
                }
                // What has a number for a value is told of one display.
                told.retain(|&at| page.locals[at].set.is_empty());
            }
        }
    }
    let declared =
        |name: &Symbol| page.domains.contains_key(name) || page.dimensions.contains_key(name);
    names::refuse(&mut equations, declared);
    names::refuse_differentials(&mut equations, declared);
    if let Some(beside) = page.beside.clone() {
        page.give(&beside, &mut equations, &derived);
    }
    counts::infer(&mut page, &equations);
    page.problems.sort_by_key(|p| p.span);
    page.document.items = items;
    (page, equations)
}

/// The pages of each document: what LaTeX puts together from several files is one, and so is all else that is read together.
pub(super) fn of_documents(pages: &[Page]) -> Vec<Vec<usize>> {
    let mut documents: BTreeMap<Option<usize>, Vec<usize>> = BTreeMap::new();
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

    fn declarations(&mut self, items: &[Item]) {
        for item in items {
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
                        Ok(symbol) => {
                            self.declare(symbol.clone(), span, attributes);
                            self.declare_dimension(symbol, span, dimension.as_ref());
                        }
                        Err(error) => self.complain_at(span, error),
                    }
                }
            }
        }
    }

    /// A complaint about a part of a directive that was read by itself.
    fn complain_at(&mut self, part: Span, error: SyntaxError) {
        let span = Span::new(part.start + error.span.start, part.start + error.span.end);
        self.complain(SyntaxError { span, ..error });
    }

    /// The `data` clauses.
    fn figures(&mut self, items: &[Item]) {
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
                        Ok(symbol) => self.figure(symbol, span, datum.clone()),
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
        let (message, help) = match (within, self.data.contains_key(&symbol)) {
            (true, false) => {
                self.data.insert(symbol, datum);
                return;
            }
            (true, true) => (
                format!("`{symbol}` has figures already on this page"),
                "give one of the two another name; until then the first counts",
            ),
            (false, _) => (
                format!("the figures of `{symbol}` leave its declared domain"),
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
                format!("`{symbol}` is declared with two dimensions on this page"),
                "give one of the two another name; until then the first counts",
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

    /// The dimension of the elements of a sequence: that declared for `u_i`, for `u`, or for `u_1`.
    pub fn element_dimension(&self, sequence: &Symbol) -> Option<&Dimension> {
        let element = || self.dimensions.get(&element_symbol(sequence, 1));
        let own = of_elements(&self.dimensions, sequence);
        own.or_else(|| self.dimensions.get(sequence))
            .or_else(element)
    }
}

/// What is declared for `u_i`, whatever the index is called.
fn of_elements<'a, T>(declared: &'a BTreeMap<Symbol, T>, sequence: &Symbol) -> Option<&'a T> {
    elements_of(declared, sequence).map(|(_, value)| value)
}

fn elements_of<'a, T>(
    declared: &'a BTreeMap<Symbol, T>,
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
    let message = format!("no number is all that `{symbol}` is declared to be");
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
