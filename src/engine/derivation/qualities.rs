//! What the text says of symbols by adjectives, "where $g$ is constant", as far as nothing on the page speaks against it.

use std::ops::Range;

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::{Attribute, Span};
use crate::kernel::{Domain, running_in};
use crate::notation::{Spanned, read_expr, read_formulas, read_symbol};
use crate::sorted::{Map, Set};

use super::equation::formulas;
use super::names::undotted;
use super::page::{Page, is_empty, narrow};
use super::{Equation, Kind};

/// No more than this is kept in mind of what is said, the latest: each display after it is told of all.
const MOST_SAYINGS: usize = 64;

/// What the text says of a symbol, and where.
#[derive(Clone, Debug, Default)]
pub struct Said {
    /// What it says.
    pub attributes: Vec<Spanned<Attribute>>,
}

impl Said {
    /// Whether it says that the symbol does not change.
    pub fn is_constant(&self) -> bool {
        self.attributes
            .iter()
            .any(|own| own.value == Attribute::Constant)
    }

    /// Whether it says where the symbol lies.
    pub(super) fn has_sign(&self) -> bool {
        self.attributes.iter().any(|own| is_sign(&own.value))
    }

    /// A domain with that besides; as it was where nothing would be left of it.
    pub(super) fn narrowed(&self, domain: Option<Domain>) -> Domain {
        let before = domain.unwrap_or_default();
        let mut narrowed = before.clone();
        narrow(&mut narrowed, &self.attributes);
        match is_empty(&narrowed) {
            true => before,
            false => narrowed,
        }
    }
}

/// Whether an attribute says where a symbol lies: of two that do, the later counts.
fn is_sign(attribute: &Attribute) -> bool {
    matches!(
        attribute,
        Attribute::Positive | Attribute::Nonnegative | Attribute::Interval { .. }
    )
}

/// The symbols of a list; none where it is no list of symbols.
pub(super) fn named(source: &str, body: Span) -> Vec<Symbol> {
    let text = source.get(body.range()).unwrap_or_default();
    let read = |text: &str| read_symbol(text).map(|symbol| vec![symbol]);
    let list = |_| text.split(',').map(read_symbol).collect();
    let said: Result<Vec<Symbol>, _> = read(text).or_else(list);
    said.unwrap_or_default()
}

/// All symbols and functions in a piece of inline mathematics.
pub(super) fn spoken_of(source: &str, body: Span) -> Set<Symbol> {
    let mut found: Set<Symbol> = named(source, body).into_iter().collect();
    for term in terms(source, body) {
        found.extend(term.free_symbols());
        term.collect_applied(&|_| true, &mut found);
    }
    found
}

fn terms(source: &str, body: Span) -> Vec<Expr> {
    match read_formulas(source, body) {
        Ok(statements) => {
            let said = statements.iter().flat_map(formulas);
            said.flat_map(|formula| formula.terms().into_iter().cloned().collect::<Vec<_>>())
                .collect()
        }
        Err(_) => read_expr(source, body).into_iter().collect(),
    }
}

/// Leaves out of what is said to be constant what the page lets change all the same: of that it is not known which is meant.
pub(super) fn leave_out_what_moves(page: &Page, equations: &mut [Equation]) {
    let constant = |own: &Equation| own.said.values().any(Said::is_constant);
    if !equations.iter().any(constant) {
        return;
    }
    let moving = Moving::of(page, equations);
    let mut last = 0;
    for equation in equations.iter_mut() {
        let mut disputed = Set::new();
        let here = last..equation.span.start;
        last = equation.span.end;
        for (symbol, said) in equation.said.iter_mut() {
            if said.is_constant() && moving.has(symbol) && !moving.lets_rest(symbol, said, &here) {
                disputed.insert(symbol.clone());
                said.attributes
                    .retain(|own| own.value != Attribute::Constant);
            }
        }
        equation.said.retain(|_, said| !said.attributes.is_empty());
        equation.disputed = disputed;
    }
    release(page, equations, &moving);
}

/// Takes back that something is constant where a law says how it moves: "For a constant inflow $u$ $$y = \\dots$$ Now $$u = K (w - y)$$". What was
/// said before the law is said of another inflow.
fn release(page: &Page, equations: &mut [Equation], moving: &Moving) {
    let lets_move = |at: usize| {
        let own = &equations[at];
        let momentary = own.locals.iter().any(|&at| page.locals[at].is_momentary());
        let is_law = own.kind == Kind::Given || own.bare && !own.drawn && !momentary;
        let said = own.statements().iter().filter(|_| is_law);
        let said = said.flat_map(formulas).filter_map(|law| {
            let (Expr::Symbol(symbol), value) = law.as_equation()? else {
                return None;
            };
            let before = || equations[..at].iter();
            // "For a fixed volume $V$" and `V = \pi r^2 h` go together.
            let was_said =
                |own: &Equation| own.is_told_constant(symbol) && own.symbols().contains(symbol);
            // What only solves an equation before for it is no law of its own.
            let names = law.names();
            let is_new = || !before().any(|own| names.is_subset(&own.symbols()));
            let moves = own.is_told_constant(symbol) && speaks_of(value, &moving.by_itself);
            (moves && before().any(was_said) && is_new()).then(|| symbol.clone())
        });
        said.collect::<Vec<Symbol>>()
    };
    let laws =
        (0..equations.len()).flat_map(|at| lets_move(at).into_iter().map(move |own| (at, own)));
    for (at, symbol) in laws.collect::<Vec<_>>() {
        let place = equations[at].span.start;
        for equation in &mut equations[at..] {
            if let Some(said) = equation.said.get_mut(&symbol) {
                let stays = |own: &Spanned<Attribute>| {
                    own.value != Attribute::Constant || own.span.start > place
                };
                said.attributes.retain(stays);
            }
            equation.released.insert(symbol.clone());
        }
    }
}

/// What the page lets change.
struct Moving {
    /// What something runs through, what is differentiated or a function; also in the text.
    by_itself: Set<Symbol>,
    /// What is given by a term in these, each with that and its place.
    given: Vec<(Symbol, Expr, usize)>,
}

impl Moving {
    fn of(page: &Page, equations: &[Equation]) -> Moving {
        // At the minimum $V = 2 \pi r^3$, and elsewhere not.
        let is_throughout = |own: &&Equation| {
            let mut locals = own.locals.iter();
            !locals.any(|&at| page.locals[at].is_momentary())
        };
        let stated = equations.iter().filter(is_throughout);
        let stated = stated.flat_map(|own| {
            let said = own.statements().iter().flat_map(formulas);
            said.map(|formula| (own.span.start, formula))
        });
        let locals = page.locals.iter().flat_map(|local| {
            let said = local.formulas.iter();
            said.map(|formula| (local.span.start, (**formula).clone()))
        });
        let (places, said): (Vec<usize>, Vec<Formula>) = stated.chain(locals).unzip();
        let mut moving = running_in(said.iter());
        moving.extend(page.changing());
        moving.extend(Formula::differentiated_in(said.iter()));
        for term in said.iter().flat_map(Formula::terms) {
            term.collect_applied(&|_| true, &mut moving);
        }
        let named = said.iter().flat_map(Formula::names);
        moving.extend(named.filter_map(|own| undotted(&own)));
        let mut given = Vec::new();
        for (&place, law) in places.iter().zip(&said) {
            let Some((left, right)) = law.as_equation() else {
                continue;
            };
            // `p V = c` ties two that move to what may well be constant.
            let ties = matches!(right, Expr::Symbol(_))
                && moving
                    .iter()
                    .filter(|own| left.mentions(own))
                    .nth(1)
                    .is_some();
            let sides = [(left, right), (right, left)].into_iter();
            for (side, other) in sides.take(if ties { 1 } else { 2 }) {
                if let Expr::Symbol(symbol) = side
                    && speaks_of(other, &moving)
                    && !ties_another(symbol, other, &said)
                {
                    given.push((symbol.clone(), other.clone(), place));
                }
            }
        }
        Moving {
            by_itself: moving,
            given,
        }
    }

    fn has(&self, symbol: &Symbol) -> bool {
        self.by_itself.contains(symbol) || self.given.iter().any(|own| own.0 == *symbol)
    }

    /// Whether the text that leads on to an equation says that something stands still which the page gives by what moves: "For a fixed
    /// volume $V$" beside `V = \pi r^2 h`. Then something else in that must keep up with it.
    fn lets_rest(&self, symbol: &Symbol, said: &Said, leading: &Range<usize>) -> bool {
        let is_here = |own: &Spanned<Attribute>| {
            own.value == Attribute::Constant && leading.contains(&own.span.start)
        };
        let keeps_up = |value: &Expr| {
            let mut names = value.free_symbols().into_iter();
            names.any(|own| !self.has(&own) && own != *symbol && own.name() != "\\pi")
        };
        let mut given = self.given.iter().filter(|own| own.0 == *symbol);
        said.attributes.iter().any(is_here)
            && !self.by_itself.contains(symbol)
            && given.all(|own| own.2 < leading.start && keeps_up(&own.1))
    }
}

impl Page {
    /// What the text says changes, "the mass $m$ grows", or lets change: `m(t)` is a function, and `\frac{dh}{dt}` the slope of one.
    pub fn changing(&self) -> Set<Symbol> {
        self.changing_since().into_keys().collect()
    }

    /// The same with where it says so first.
    pub fn changing_since(&self) -> Map<Symbol, usize> {
        let source = &self.document.source;
        let mut since: Map<Symbol, usize> = Map::new();
        let mut tell = |symbol: Symbol, place: usize| {
            let first = since.entry(symbol).or_insert(place);
            *first = place.min(*first);
        };
        for &body in self.document.prose().flat_map(|prose| &prose.changing) {
            let spoken = spoken_of(source, body).into_iter();
            spoken.for_each(|symbol| tell(symbol, body.start));
        }
        for math in self.document.inline() {
            let text = self.document.text(math.body);
            if !text.contains("\\frac{d") && !text.contains("\\dot") && !text.contains('(') {
                continue;
            }
            let mut found = Set::new();
            for term in terms(source, math.body) {
                term.collect_differentiated(&mut found);
                // Of `m(t)`, and not of `m(0)`.
                let runs = |arguments: &[Expr]| matches!(arguments, [Expr::Symbol(_)]);
                term.collect_applied(&runs, &mut found);
                found.extend(term.free_symbols().iter().filter_map(undotted));
            }
            let found = found.into_iter();
            found.for_each(|symbol| tell(symbol, math.body.start));
        }
        since
    }
}

/// Whether an equation for a symbol is solved for another that is in it: by `h = V/(\pi r^2)`, `V = \pi r^2 h` ties `h` to a volume that
/// may be fixed.
fn ties_another(symbol: &Symbol, value: &Expr, said: &[Formula]) -> bool {
    let tied = value.free_symbols();
    let mut sides = said.iter().filter_map(Formula::as_equation);
    sides.any(|(left, right)| match left {
        Expr::Symbol(own) => own != symbol && tied.contains(own) && right.mentions(symbol),
        _ => false,
    })
}

/// Whether a term speaks of one of these but in slopes: `F = m \frac{dv}{dt}` gives no force by the time.
fn speaks_of(term: &Expr, symbols: &Set<Symbol>) -> bool {
    match term {
        Expr::Derivative { .. } => false,
        Expr::Symbol(symbol) => symbols.contains(symbol),
        term => term.children().any(|part| speaks_of(part, symbols)),
    }
}

/// What is said of symbols at one place of a page.
#[derive(Default)]
pub(super) struct Sayings(Vec<Saying>);

struct Saying {
    symbol: Symbol,
    attribute: Spanned<Attribute>,
    /// The level of the heading below which it is said.
    level: u8,
    /// It is said of circumstances: "with constant force $F$".
    of_case: bool,
}

impl Sayings {
    /// A heading ends what is said below another of its level.
    pub fn below(&mut self, level: u8) {
        self.0.retain(|own| own.level < level);
    }

    /// What was said of these symbols before a place in the text.
    pub fn forget_above(&mut self, symbols: &Set<Symbol>, place: usize) {
        let is_above = |own: &Saying| own.attribute.span.start < place;
        self.0
            .retain(|own| !(symbols.contains(&own.symbol) && is_above(own)));
    }

    /// Nothing is said any more.
    pub fn forget(&mut self) {
        self.0.clear();
    }

    /// Symbols of which the text says that they change.
    pub fn forget_these(&mut self, symbols: &Set<Symbol>) {
        self.0.retain(|own| !symbols.contains(&own.symbol));
    }

    /// Other circumstances are told of.
    pub fn leave_case(&mut self) {
        self.0.retain(|own| !own.of_case);
    }

    /// Takes up what is said of a symbol.
    pub fn take(
        &mut self,
        symbol: &Symbol,
        attribute: Spanned<Attribute>,
        level: u8,
        of_case: bool,
    ) {
        // Once, and of two places the later.
        let replaces =
            |own: &Attribute| *own == attribute.value || is_sign(own) && is_sign(&attribute.value);
        self.0
            .retain(|own| own.symbol != *symbol || !replaces(&own.attribute.value));
        if self.0.len() == MOST_SAYINGS {
            self.0.remove(0);
        }
        self.0.push(Saying {
            symbol: symbol.clone(),
            attribute,
            level,
            of_case,
        });
    }

    /// All that is said here.
    pub fn here(&self) -> Map<Symbol, Said> {
        let mut all: Map<Symbol, Said> = Map::new();
        for own in &self.0 {
            let said = all.entry(own.symbol.clone()).or_default();
            said.attributes.push(own.attribute.clone());
        }
        all
    }
}
