//! From documents to what must follow from what.
//!
//! A [`Derivation`] is a set of pages read together, as one report. Each displayed equation becomes an
//! [`Equation`]: what it states, what kind of statement it is, and what it is said to rest on. From these
//! [`Derivation::claim`] makes the claims that are judged: hypotheses ⊢ goal, with every domain explicit.

mod approach;
mod arguments;
mod beside;
mod beyond;
mod chain;
mod checker;
mod common;
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
mod page;
mod partials;
mod pi;
mod qualities;
mod reader;
mod rows;
mod running;
mod slopes;
mod supposed;
mod values;

use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;

use crate::algebra::{BigRational, Expr, Formula, Relation, Symbol};
use crate::document::{Citation, Document, Extent, Premise, Span};
use crate::kernel::{Claim, Domain, Hypothesis, Standing, running_in};
use crate::notation::{Spanned, measured, read_formulas};
use crate::parallel::in_order;
use crate::sorted::{Map, Set, Tree};

pub use approach::Approach;
pub use beside::{About, Beside, Budget, Clash, Place, Severity, Shared};
pub use checker::{Checker, Point, values_at};
pub use equation::{Equation, Goal, Kind, conditions, formulas, goals, unconditional};
pub(crate) use names::{dotted, without_dots};
pub use page::{Datum, Page, Premises};
pub use qualities::Said;
pub use running::Running;
use supposed::said_of_moment;
pub use supposed::{Local, is_put};
pub use values::{ConditionSaid, Printed, ValueSaid};

/// A longer range of numbers is a slip of the pen; only its ends are read.
const LONGEST_RANGE: usize = 1000;
/// The most rows of one display that the last of them is taken to follow from where nothing is said.
const MOST_ROWS: usize = 16;

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

/// A hypothesis with where it comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assumed {
    /// What is assumed.
    pub formula: Arc<Formula>,
    /// Throughout, or at the point in question.
    pub standing: Standing,
    /// Where it comes from.
    pub source: Source,
}

impl Assumed {
    /// Whether the text tells it of one place: that `w` is 0 where `x` is.
    pub fn tells_value_there(&self) -> bool {
        let sides = self.formula.as_equation();
        self.source == Source::Step && matches!(sides, Some((Expr::Limit { .. }, _)))
    }

    /// Whether it was not said, but taken so: that `P_{\max}` is `P` at the place in question.
    pub fn takes_index_off(&self) -> bool {
        let sides = self.formula.as_equation();
        matches!(
            sides,
            Some((Expr::Symbol(new), Expr::Symbol(known)))
                if self.source == Source::Step && new.without_subscript().as_ref() == Some(known)
        )
    }
}

/// Where a hypothesis comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// A `let` or an assumption: page, position in [`Page::locals`].
    Local(usize, usize),
    /// An equation, by position.
    Equation(usize),
    /// An earlier step of the same statement, or the other side of an `\iff`.
    Step,
}

/// A citation that leads nowhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unknown {
    /// What is cited.
    pub label: String,
    /// Where.
    pub span: Span,
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
            slopes::read_marks(&mut page, &mut equations);
            arguments::leave_out(&mut page, &mut equations);
            partials::tell_what_is_held(&mut page, &mut equations);
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
        for page in 0..derivation.pages.len() {
            let mut mentions: Tree<Symbol, Vec<usize>> = Tree::new();
            let mut neighbours = BTreeSet::from([page]);
            for at in derivation.equations_of(page) {
                let equation = &derivation.equations[at];
                for symbol in equation.symbols().into_iter().chain(equation.functions()) {
                    let own = mentions.entry(symbol).or_default();
                    if own.last() != Some(&at) {
                        own.push(at);
                    }
                }
                let cited = derivation.premises(at).0.into_iter();
                neighbours.extend(cited.map(|premise| derivation.equations[premise].page));
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

    /// The equation with a number (`23`) or a name.
    pub fn find(&self, label: &str) -> Option<&Equation> {
        let label = label.trim().trim_start_matches('(').trim_end_matches(')');
        let named = label.strip_prefix("claim ").unwrap_or(label).trim();
        let found = self
            .labels
            .get(&format!("({label})"))
            .or_else(|| self.labels.get(named))
            .or_else(|| self.labels.get(&format!("{{{label}}}")));
        found
            .and_then(|all| all.first())
            .map(|&at| &self.equations[at])
    }

    /// Whether any equation of a page speaks of a symbol.
    pub fn is_spoken_of(&self, page: usize, symbol: &Symbol) -> bool {
        self.mentions[page].get(symbol).is_some()
    }

    /// The equations that bear the same number or name as an earlier one.
    pub fn duplicates(&self) -> Vec<(usize, usize)> {
        let several = self.labels.values().filter(|all| all.len() > 1);
        let mut duplicates: Vec<(usize, usize)> = several
            .flat_map(|all| all[1..].iter().map(|&at| (at, all[0])))
            .filter(|&(at, first)| !self.counted_apart(at, first))
            .collect();
        duplicates.sort_unstable();
        duplicates.dedup_by_key(|pair| pair.0);
        duplicates
    }

    /// Whether LaTeX numbers two equations in two documents: each begins with (1).
    fn counted_apart(&self, one: usize, other: usize) -> bool {
        let document = |at: usize| &self.pages[self.equations[at].page].document;
        let typeset = |at: usize| document(at).is_latex;
        typeset(one)
            && typeset(other)
            && !Arc::ptr_eq(&document(one).origin, &document(other).origin)
    }

    /// The equations that a citation on a page means: of the same page before others; one, unless several share the
    /// number. `label` is as [`Derivation::labels`] has it, and `other` is tried where there is none.
    fn resolve(&self, label: &str, other: &str, page: usize) -> Vec<usize> {
        // Thousands of pages may each have a (1), in reading order.
        let own = |all: &[usize]| {
            let start = all.partition_point(|&at| self.equations[at].page < page);
            start..all.partition_point(|&at| self.equations[at].page <= page)
        };
        for label in [label, other] {
            if let Some(all) = self.labels.get(label) {
                let near = all[own(all)].first();
                return near.or_else(|| all.first()).copied().into_iter().collect();
            }
            if let Some(all) = self.groups.get(label) {
                let near = &all[own(all)];
                return if near.is_empty() {
                    all.clone()
                } else {
                    near.to_vec()
                };
            }
        }
        Vec::new()
    }

    /// The equations that prose cites, in order.
    fn cited(&self, citation: &Citation, page: usize) -> Vec<usize> {
        let find = |tag: &str| {
            let (tag, key) = (format!("({tag})"), format!("{{{tag}}}"));
            match citation.key {
                true => self.resolve(&key, &tag, page),
                false => self.resolve(&tag, &key, page),
            }
        };
        let mut found = find(&citation.tag);
        if let Some(last) = &citation.through
            && let (Some(&from), Some(&to)) = (found.first(), find(last).last())
            && from < to
            && to - from <= LONGEST_RANGE
        {
            let numbered = |at: &usize| self.equations[*at].tag.is_some();
            found = (from..to).filter(numbered).collect();
        }
        found
    }

    /// The number of an equation, where that is a whole number in plain figures.
    pub fn number(&self, at: usize) -> Option<i64> {
        let tag = self.equations[at].tag.as_deref()?;
        let figures = tag.len() <= 9 && tag.bytes().all(|b| b.is_ascii_digit());
        figures.then(|| tag.parse().ok()).flatten()
    }

    /// The equation that a number cited on a page means.
    pub fn numbered(&self, number: i64, page: usize) -> Option<usize> {
        let (tag, key) = (format!("({number})"), format!("{{{number}}}"));
        self.resolve(&tag, &key, page).first().copied()
    }

    /// The equations that an equation is said to follow from, whether it says so itself, and the
    /// citations that lead nowhere.
    ///
    /// A directive names them; without one the prose does; where that cites none it is the equation just
    /// before. What goes on with the equations before it in its display follows from them too, and whoever cites it
    /// cites them.
    pub fn premises(&self, at: usize) -> (Vec<usize>, bool, Vec<Unknown>) {
        let equation = &self.equations[at];
        let (mut found, mut unknown) = (Vec::new(), Vec::new());
        let mut cite = |premises: Vec<usize>, shown: String, span: Span, required: bool| {
            if premises.is_empty() && required {
                unknown.push(Unknown { label: shown, span });
            }
            for premise in premises {
                let chain = premise - self.equations[premise].continues.min(premise);
                for premise in chain..=premise {
                    if premise != at && !found.contains(&premise) {
                        found.push(premise);
                    }
                }
            }
        };
        let says_so = match &equation.premises {
            Premises::Named(named) => {
                for Spanned { value, span } in named {
                    let (premises, shown) = match value {
                        Premise::Tag(tag) => {
                            let (label, key) = (format!("({tag})"), format!("{{{tag}}}"));
                            (self.resolve(&label, &key, equation.page), label)
                        }
                        Premise::Claim(name) => {
                            let shown = format!("claim {name}");
                            (self.resolve(name, name, equation.page), shown)
                        }
                    };
                    cite(premises, shown, *span, true);
                }
                true
            }
            Premises::Cited(cited) => {
                for citation in cited {
                    let premises = self.cited(citation, equation.page);
                    let shown = format!("({})", citation.tag);
                    cite(premises, shown, citation.span, citation.explicit);
                }
                !found.is_empty() || !unknown.is_empty()
            }
        };
        if says_so
            && equation.relative
            && let Some(before) = at.checked_sub(equation.row + 1)
            && self.equations[before].page == equation.page
            && !found.contains(&before)
        {
            found.push(before);
            found.sort_unstable();
        }
        if !says_so {
            // The equation before the display, and those before this one in it; what is put at one moment stands between a law and what
            // follows from it.
            let mut first = at - (equation.row + 1).min(at);
            while !self.equations[first].moments.is_empty() && first > 0 {
                first -= (self.equations[first].row + 1).min(first);
            }
            // Laws that are written one below the other are one.
            while self.equations[first].joined && first > 0 {
                first -= 1;
            }
            let near = (first..at).rev().take(MOST_ROWS);
            found.extend(near.filter(|&p| self.equations[p].page == equation.page));
            found.sort_unstable();
        }
        for premise in at - equation.continues.min(at)..at {
            if !found.contains(&premise) {
                found.push(premise);
            }
        }
        if equation.row > 0 {
            unknown.clear();
        }
        (found, says_so, unknown)
    }

    /// The equations before `at` that share symbols with it, where these were spoken of last: the two nearest, then those that are solved for a
    /// symbol, then the rest, each the nearest first.
    pub fn relatives(&self, at: usize, most: usize) -> Vec<usize> {
        let speaking = |wanted: Set<Symbol>| {
            let mut fresh: BTreeSet<usize> = BTreeSet::new();
            for symbol in &wanted {
                for page in self.speaking_of(symbol, at) {
                    let all = &self.mentions[page][symbol];
                    let before = &all[..all.partition_point(|&other| other < at)];
                    fresh.extend(before.iter().rev().take(most));
                }
            }
            fresh
        };
        // What defines the symbols, and what defines those of the definitions.
        let spoken_of = |at: usize| {
            let own = &self.equations[at];
            own.symbols().into_iter().chain(own.functions())
        };
        let mut wanted: Set<Symbol> = spoken_of(at).collect();
        wanted.extend(self.told_of(at));
        let mut found = speaking(wanted);
        let symbols = found.iter().flat_map(|&other| spoken_of(other));
        found.extend(speaking(symbols.collect()));
        let mut order: Vec<usize> = found.into_iter().rev().take(most).collect();
        let solved = |at: &usize| {
            let mut relations = self.equations[*at].relations().into_iter();
            relations.any(|(left, ..)| matches!(left, crate::algebra::Expr::Symbol(_)))
        };
        let rest = order.split_off(order.len().min(2));
        let (first, last): (Vec<usize>, Vec<usize>) = rest.into_iter().partition(solved);
        order.into_iter().chain(first).chain(last).collect()
    }

    /// The symbols by which the text tells what others are that an equation speaks of: of `\bar M = n_0 M/n` also `n`.
    fn told_of(&self, at: usize) -> Set<Symbol> {
        let own = &self.equations[at];
        if own.told.is_empty() && own.named.is_empty() {
            return Set::new();
        }
        let symbols = own.symbols();
        let locals = &self.pages[own.page].locals;
        let told = own.told.iter().chain(&own.named).map(|&at| &locals[at]);
        // What is concluded from what is told of a case is said of that alone.
        let formulas = told
            .filter(|local| !local.of_case)
            .flat_map(|local| &local.formulas);
        let mut told = Set::new();
        for formula in formulas {
            let names = formula.names();
            if !names.is_disjoint(&symbols) {
                told.extend(names);
            }
        }
        told
    }

    /// The pages to look for a symbol of equation `at`: its own and those that this cites, as far as they speak
    /// of the symbol before; if they do not, the last page that did.
    fn speaking_of(&self, symbol: &Symbol, at: usize) -> Vec<usize> {
        let own = self.equations[at].page;
        let speaks = |&page: &usize| {
            let all = self.mentions[page].get(symbol);
            all.is_some_and(|all| all.first().is_some_and(|&first| first < at))
        };
        let near: Vec<usize> = self.neighbours[own]
            .iter()
            .copied()
            .filter(speaks)
            .collect();
        if !near.is_empty() {
            return near;
        }
        let pages = self
            .pages_of
            .get(symbol)
            .map(Vec::as_slice)
            .unwrap_or_default();
        let before = pages.partition_point(|&page| page < own);
        pages[..before].last().copied().into_iter().collect()
    }

    /// The positions of the equations of a page.
    pub fn equations_of(&self, page: usize) -> Range<usize> {
        equation::of_page(page, &self.equations)
    }

    /// The hypotheses in effect where an equation stands.
    pub fn locals(&self, at: usize) -> Vec<Assumed> {
        self.supposed(at, &self.equations[at].locals)
    }

    /// Those that are so at one moment alone.
    pub fn momentary(&self, at: usize) -> Vec<Assumed> {
        let own = &self.equations[at];
        let locals = own.locals.iter().copied();
        let of_moment = |&local: &usize| self.local(own.page, local).is_momentary();
        self.supposed(at, &locals.filter(of_moment).collect::<Vec<_>>())
    }

    /// Whether an equation says something throughout or of one value alone of what runs in others that it is taken with: "At the top $v = 0$",
    /// or what is given where $t = 0$ is supposed.
    pub fn standing_among(&self, at: usize, others: &[usize]) -> Standing {
        let own = &self.equations[at];
        let given = own.kind == Kind::Given && !own.locals.is_empty();
        let of_moment = |statement| said_of_moment(statement, Extent::Moment, |_| true).is_some();
        let told = own.at_moment && !own.explains && own.statements().iter().all(of_moment);
        if !told && !given {
            return Standing::Identity;
        }
        let statements = others
            .iter()
            .flat_map(|&at| self.equations[at].statements());
        let said: Vec<Formula> = statements.flat_map(formulas).collect();
        let running = running_in(said.iter());
        let page = &self.pages[own.page];
        let fixes = |local: &usize| {
            let local = &page.locals[*local];
            let at_point = |own: &&Arc<Formula>| page.standing_of(local, own) == Standing::AtPoint;
            let mut formulas = local.formulas.iter().filter(at_point);
            formulas.any(|own| {
                own.free_symbols()
                    .iter()
                    .any(|symbol| running.contains(symbol))
            })
        };
        match !running.is_empty() && (told || own.locals.iter().any(fixes)) {
            true => Standing::AtPoint,
            false => Standing::Identity,
        }
    }

    /// What the text before an equation tells in passing, the nearest first. What announces the equation itself is no premise of it.
    pub fn told(&self, at: usize) -> Vec<Assumed> {
        let equation = &self.equations[at];
        let mut told = self.supposed(at, &equation.told);
        let stated: Vec<Formula> = match told.is_empty() {
            true => Vec::new(),
            false => equation.statements().iter().flat_map(formulas).collect(),
        };
        told.retain(|own| !stated.contains(&own.formula));
        told
    }

    /// What the last sentence before an equation tells in passing.
    pub fn told_just_before(&self, at: usize) -> Vec<Assumed> {
        let Some(sentence) = self.equations[at].said_last else {
            return Vec::new();
        };
        let mut told = self.told(at);
        told.retain(|own| match own.source {
            Source::Local(page, local) => self.local(page, local).span.start >= sentence.start,
            _ => false,
        });
        told
    }

    /// Whether words between what is said and an equation leave cases: "For arbitrary masses".
    pub fn is_left_in_words(&self, at: usize, (page, local): (usize, usize)) -> bool {
        let start = self.local(page, local).span.start;
        let general = &self.pages[page].general;
        let left = general.partition_point(|&place| place < start);
        let own = &self.equations[at];
        own.page == page && (general.get(left)).is_some_and(|&place| place < own.span.start)
    }

    /// What the sentence that leads on to an equation names, and does not suppose plainly.
    pub fn named(&self, at: usize) -> Vec<Assumed> {
        self.supposed(at, &self.equations[at].named)
    }

    fn supposed(&self, at: usize, locals: &[usize]) -> Vec<Assumed> {
        let number = self.equations[at].page;
        let page = &self.pages[number];
        let meant = locals
            .iter()
            .filter(|&&local| !self.is_beyond(at, (number, local)));
        let all = meant.flat_map(|&local| {
            let source = self.source_of(number, local);
            let local = &page.locals[local];
            local.formulas.iter().map(move |formula| Assumed {
                formula: formula.clone(),
                standing: page.standing_of(local, formula),
                source,
            })
        });
        all.collect()
    }

    /// The values that the text around an equation names without supposing them, with their places.
    pub fn mentioned(&self, at: usize) -> Vec<(Span, Formula)> {
        let equation = &self.equations[at];
        let page = &self.pages[equation.page];
        let read = equation.mentioned.iter().filter_map(|&body| {
            let mut statements = read_formulas(&page.document.source, body).ok()?;
            page.read_exponentials(statements.iter_mut());
            let plain = statements.iter().filter(|s| s.under.is_empty());
            let said: Vec<Formula> = plain.flat_map(formulas).collect();
            let said = said.into_iter().filter(|f| !constants::speaks_of_some(f));
            Some(said.map(move |formula| (body, formula)))
        });
        read.flatten().collect()
    }

    /// What says a local hypothesis: the display, where one says it of a moment.
    fn source_of(&self, page: usize, local: usize) -> Source {
        let moment = self.pages[page].locals[local].moment.as_ref();
        match moment.and_then(|moment| moment.display) {
            Some(display) => Source::Equation(self.equations_of(page).start + display),
            None => Source::Local(page, local),
        }
    }

    /// A local hypothesis by its source.
    pub fn local(&self, page: usize, local: usize) -> &Local {
        &self.pages[page].locals[local]
    }

    /// Whether a symbol is a constant to which nobody gives a name: one of which is said somewhere that there is one.
    pub fn is_some_constant(&self, symbol: &Symbol) -> bool {
        self.constants.contains(symbol)
    }

    /// What the text says of symbols where an equation stands, or where what it is taken with does, each with the page; another premise may
    /// know better what changes.
    pub fn said(&self, at: usize, assumed: &[Assumed]) -> Map<Symbol, (usize, Said)> {
        let premises = assumed.iter().filter_map(|own| match own.source {
            Source::Equation(premise) => Some(premise),
            _ => None,
        });
        let mut found: Map<Symbol, (usize, Said)> = Map::new();
        for at in std::iter::once(at).chain(premises) {
            let own = &self.equations[at];
            for (symbol, said) in &own.said {
                let told = found.entry(symbol.clone());
                told.or_insert((own.page, said.clone()));
            }
        }
        if !found.is_empty() {
            let premises = assumed.iter().map(|own| &*own.formula);
            let differentiated = Formula::differentiated_in(premises);
            found.retain(|symbol, own| !own.1.is_constant() || !differentiated.contains(symbol));
        }
        found
    }

    /// What an earlier equation speaks of as constant, and what stands before this one has let change since.
    pub fn is_released(&self, at: usize, other: usize) -> Option<&Symbol> {
        let (own, other) = (&self.equations[at], &self.equations[other]);
        let was_constant =
            |symbol: &Symbol| other.is_told_constant(symbol) && other.symbols().contains(symbol);
        let mut released = own.released.iter().filter(|_| own.page == other.page);
        released.find(|symbol| was_constant(symbol))
    }

    /// The claim that a goal of an equation follows from hypotheses, with the domains of all symbols in it.
    pub fn claim(&self, at: usize, assumed: &[Assumed], goal: &Formula) -> Claim {
        let mut claim = Claim {
            domains: Map::new(),
            sequences: Map::new(),
            hypotheses: assumed
                .iter()
                .map(|a| Hypothesis {
                    formula: a.formula.clone(),
                    standing: a.standing,
                })
                .collect(),
            goal: goal.clone(),
        };
        // Declarations are a page's own; those of the pages of premises fill the gaps.
        let own = self.equations[at].page;
        let others = assumed.iter().filter_map(|a| match a.source {
            Source::Equation(premise) => Some(self.equations[premise].page),
            Source::Local(page, _) => Some(page),
            Source::Step => None,
        });
        let mut pages: Vec<usize> = vec![own];
        pages.extend(others);
        pages.dedup();
        let mut domains = Map::new();
        let said = self.said(at, assumed);
        for symbol in claim.free_symbols() {
            let mut declared = pages
                .iter()
                .filter_map(|&p| self.pages[p].domains.get(symbol));
            if let Some(domain) = declared.next() {
                domains.insert(symbol.clone(), domain.clone());
            } else if measured(symbol).is_some() {
                // A unit is a positive quantity that never changes.
                let domain = Domain {
                    lower: Some((BigRational::from_integer(0.into()), true)),
                    constant: true,
                    ..Domain::default()
                };
                domains.insert(symbol.clone(), domain);
            }
            if let Some((_, said)) = said.get(symbol) {
                let narrowed = said.narrowed(domains.get(symbol).cloned());
                domains.insert(symbol.clone(), narrowed);
            }
        }
        claim.domains = domains;
        for sequence in Formula::sequences_of(claim.formulas()) {
            let mut declared = pages
                .iter()
                .filter_map(|&p| self.pages[p].element_domain(&sequence));
            let domain: Domain = declared.next().cloned().unwrap_or_default();
            claim.sequences.insert(sequence, domain);
        }
        claim
    }
}

/// Whether a hypothesis leaves room to move: then what follows from it holds around the point too.
pub fn is_open(formula: &Formula) -> bool {
    use Relation::{Greater, Less, NotEqual};
    matches!(
        formula,
        Formula::Relation {
            relation: Less | Greater | NotEqual,
            ..
        }
    )
}

fn tag_key(tag: Option<&str>) -> Option<String> {
    tag.map(|tag| format!("({tag})"))
}

fn name_key(name: Option<&str>) -> Option<String> {
    name.map(str::to_owned)
}
