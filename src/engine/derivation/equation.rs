use std::ops::Range;

use crate::algebra::{BigRational, Expr, Formula, Relation, Symbol};
use crate::document::{Citation, Extent, Span};
use crate::notation::{
    Clause, Connective, Link, Precision, Rounding, Side, Statement, SyntaxError,
};

use super::Premises;
use super::page::Page;
use super::qualities::Said;
use super::slopes::TIME;
use crate::sorted::{Map, Set};

/// The place of a row among statements that share one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Among {
    /// How many of the statements stand in rows before it.
    pub before: usize,
    /// How many there are in all.
    pub all: usize,
}

/// An equation of a document, with all that its surroundings say about it.
#[derive(Clone, Debug)]
pub struct Equation {
    /// The page it stands on.
    pub page: usize,
    /// The number from `\tag{…}`, as printed, or as LaTeX counts it.
    pub tag: Option<String>,
    /// The keys from `\label{…}`.
    pub keys: Vec<String>,
    /// Other numbers and keys by which it is cited together with its neighbours: `(2)` for (2a) and (2b).
    pub group: Vec<String>,
    /// The name from `claim …`.
    pub name: Option<String>,
    /// The display with its fences.
    pub span: Span,
    /// The mathematics alone.
    pub body: Span,
    /// What it states, or why it could not be read.
    pub statements: Result<Vec<Statement>, SyntaxError>,
    /// What kind of statement the author makes.
    pub kind: Kind,
    /// The statements, by position, whose first link defines a symbol that has not occurred before.
    pub defines: Set<usize>,
    /// The symbols of which no equation before speaks.
    pub introduces: Set<Symbol>,
    /// Whether it would define its symbol, had the text not told what that is.
    pub explains: bool,
    /// The symbols of which the display after it says what they mean: "where the Compton wavelength is $$\lambda_C = \frac{h}{m c}$$".
    pub explained: Set<Symbol>,
    /// Whether the page opens with it and nothing is said of where it comes from.
    pub opens: bool,
    /// Whether words say that it is about the display before, too: "which by (2) is".
    pub relative: bool,
    /// Whether words introduce it, and none of them cites anything or says that it follows.
    pub bare: bool,
    /// Whether nothing is said between it and what is introduced with it just before.
    pub joined: bool,
    /// Whether nothing is cited for it, whatever words say.
    pub uncited: bool,
    /// Whether the reason that words give for it is no equation: a law by its name, "since the string does not slip".
    pub reasons: bool,
    /// Whether words put it under a condition: "If the stress is to be the same in all of them, then by (1)".
    pub puts_condition: bool,
    /// The last sentence before its display, ended or not.
    pub said_last: Option<Span>,
    /// Whether the law that words name for it stands on the page already.
    pub law_stands: bool,
    /// Whether words say that all factors of what is differentiated change: "by the product rule".
    pub all_vary: bool,
    /// Whether words say that something is divided by something: "Dividing (2) by (1)".
    pub divides: bool,
    /// Whether a mere "where" or "with" introduces it.
    pub meant: bool,
    /// It takes the place of what it cites.
    pub replaces: bool,
    /// It is one of several laws that the text announces.
    pub is_law: bool,
    /// The display, by position on the page, with which the circumstances begin that it is said under: "For an elastic collision".
    pub circumstances: Option<usize>,
    /// The letters that its section introduces anew: "Here $v$ denotes the volume".
    pub anew: Set<Symbol>,
    /// The first display of its section, by position on the page.
    pub section_start: usize,
    /// Of how much words say that it is said, where none say that it follows.
    pub extent: Extent,
    /// Of how much the text before it says that it is said, cite it what it may.
    pub told_extent: Extent,
    /// What it says of one moment alone, as positions in [`Page::locals`](super::Page::locals).
    pub moments: Range<usize>,
    /// Whether words before it cite something or say that it follows, and none that it defines anything.
    pub drawn: bool,
    /// It is a numeric claim: how near `≈` is meant, where that is said.
    pub numeric: Option<Option<BigRational>>,
    /// What it is said to follow from.
    pub premises: Premises,
    /// How many equations of the same display stand before it.
    pub row: usize,
    /// Where it stands among the statements that share its number, where these are of several rows.
    pub among: Option<Among>,
    /// How many of these it goes on with: `= c` after `a = b`.
    pub continues: usize,
    /// The hypotheses in effect where it stands, as positions in [`Page::locals`](super::Page::locals).
    pub locals: Vec<usize>,
    /// What the text before it tells in passing, the nearest first, as positions there: premises only of what does not follow
    /// without them.
    pub told: Vec<usize>,
    /// What the text says of symbols by adjectives.
    pub said: Map<Symbol, Said>,
    /// What it says is constant, and the page lets change all the same.
    pub disputed: Set<Symbol>,
    /// What was said to be constant, and since is given by what moves.
    pub released: Set<Symbol>,
    /// Values that the text around it names and does not plainly suppose, unread.
    pub mentioned: Vec<Span>,
    /// What the sentence that leads on to it names, by position among the page's locals: it may be meant to follow from that.
    pub named: Vec<usize>,
    /// What the text before it supposes and could not be read.
    pub unread: Vec<Span>,
    /// The heading above it.
    pub section: String,
}

/// What kind of statement an equation is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A law, model or definition: nothing to derive.
    Given,
    /// To be derived from its premises.
    Derived,
    /// Ticked or crossed out by the author.
    Marked,
}

impl Kind {
    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Kind::Given => "given",
            Kind::Derived => "derived",
            Kind::Marked => "marked",
        }
    }
}

/// One relation of a statement, to be judged by itself.
#[derive(Clone, Debug)]
pub struct Goal {
    /// What is stated.
    pub formula: Formula,
    /// Where the relation stands.
    pub span: Span,
    /// Where its sides stand; both the same for a statement about a whole sequence.
    pub sides: (Span, Span),
    /// How near the number on its right side is meant, where it is rounded: `\approx 300`, `= 9.79`.
    pub rounding: Option<Rounding>,
    /// The author asks (`\stackrel{?}{=}`) rather than asserts.
    pub questioned: bool,
    /// What is supposed besides the premises: the other side of an `\iff`, the condition of a case.
    pub suppositions: Vec<Formula>,
    /// The position of the clause in its statement; earlier clauses of an implication are premises.
    pub clause: usize,
}

impl Goal {
    /// Whether it says of a symbol what it is: `s = …`.
    pub fn is_of(&self, symbol: &Symbol) -> bool {
        says_of(&self.formula, symbol)
    }

    /// Whether its author asserts it, and supposes nothing for it.
    pub fn is_said_outright(&self) -> bool {
        !self.questioned && self.suppositions.is_empty()
    }
}

/// Whether a term is a slope by something else than time.
fn is_slope_in_place(term: &Expr) -> bool {
    match term {
        Expr::Derivative { variable, .. } | Expr::Partial { variable, .. } => {
            variable.name() != TIME
        }
        // `\frac{dF}{d(w^2)}`
        Expr::Quotient(_, below) => match &**below {
            Expr::Derivative { body, variable } => {
                variable.is_change() && !body.mentions(&Symbol::new(TIME))
            }
            _ => false,
        },
        _ => false,
    }
}

/// Whether a formula says of a symbol what it is: `s = …`.
pub(super) fn says_of(formula: &Formula, symbol: &Symbol) -> bool {
    let sides = formula.as_equation();
    matches!(sides, Some((Expr::Symbol(own), _)) if own == symbol)
}

/// The first goal of a statement.
pub fn first_goal(statement: &Statement) -> Option<Goal> {
    goals(statement).into_iter().next()
}

/// The goals of a statement, in the order in which they are to be judged.
pub fn goals(statement: &Statement) -> Vec<Goal> {
    let equivalent = |at: usize| {
        statement
            .connectives
            .get(at)
            .is_some_and(|c| c.value == Connective::Equivalent)
    };
    let under = conditions(statement);
    let mut all = Vec::new();
    for (at, clause) in statement.clauses.iter().enumerate() {
        let goals = clause_goals(clause, at);
        let before = at > 0 && equivalent(at - 1);
        let after = equivalent(at);
        if !before && !after {
            all.extend(goals.into_iter().map(|goal| Goal {
                suppositions: under.clone(),
                ..goal
            }));
            continue;
        }
        // Each side of an equivalence follows from the other.
        for neighbour in [before.then(|| at - 1), after.then_some(at + 1)]
            .into_iter()
            .flatten()
        {
            let mut suppositions = stated(&statement.clauses[neighbour]);
            suppositions.extend(under.iter().cloned());
            all.extend(goals.iter().map(|goal| Goal {
                suppositions: suppositions.clone(),
                ..goal.clone()
            }));
        }
    }
    all
}

/// What a clause states.
fn stated(clause: &Clause) -> Vec<Formula> {
    match clause {
        Clause::Chain { sides, links } => {
            let relation = |(link, pair): (&Link, &[Side])| Formula::Relation {
                left: pair[0].expr.clone(),
                relation: link.relation,
                right: pair[1].expr.clone(),
            };
            links.iter().zip(sides.windows(2)).map(relation).collect()
        }
        Clause::AllEqual {
            sequence,
            to,
            value,
            ..
        } => vec![Formula::AllEqual {
            sequence: sequence.clone(),
            to: to.clone(),
            value: value.as_ref().map(|side| side.expr.clone()),
        }],
    }
}

fn clause_goals(clause: &Clause, at: usize) -> Vec<Goal> {
    let formulas = stated(clause).into_iter();
    match clause {
        Clause::Chain { sides, links } => formulas
            .zip(links.iter().zip(sides.windows(2)))
            .map(|(formula, (link, pair))| Goal {
                formula,
                span: link.span,
                sides: (pair[0].span, pair[1].span),
                rounding: rounding(link.relation, &pair[1]),
                questioned: link.questioned,
                suppositions: Vec::new(),
                clause: at,
            })
            .collect(),
        Clause::AllEqual { span, .. } => formulas
            .map(|formula| Goal {
                formula,
                span: *span,
                sides: (*span, *span),
                rounding: None,
                questioned: false,
                suppositions: Vec::new(),
                clause: at,
            })
            .collect(),
    }
}

/// How near a right side is meant. A whole number after `=` is meant exactly.
fn rounding(relation: Relation, right: &Side) -> Option<Rounding> {
    let near = |own: &&Rounding| match relation {
        Relation::Equal => own.precision != Precision::Whole,
        relation => relation == Relation::Approximately,
    };
    right.rounding.as_deref().filter(near).cloned()
}

/// Where the equations of a page stand.
pub(super) fn of_page(page: usize, equations: &[Equation]) -> Range<usize> {
    let start = equations.partition_point(|equation| equation.page < page);
    start..equations.partition_point(|equation| equation.page <= page)
}

/// The equations of some pages, which are in order.
pub(super) fn of_pages<'a>(
    pages: &'a [usize],
    equations: &'a mut [Equation],
) -> impl Iterator<Item = &'a mut Equation> {
    let (first, last) = (pages.first().copied(), pages.last().copied());
    let all = match (first, last) {
        (Some(first), Some(last)) => of_page(first, equations).start..of_page(last, equations).end,
        _ => 0..0,
    };
    let own = |equation: &&mut Equation| pages.binary_search(&equation.page).is_ok();
    equations[all].iter_mut().filter(own)
}

/// Changes each term of a page, in its equations and in what is supposed.
pub(super) fn map_terms(
    page: &mut Page,
    equations: &mut [Equation],
    change: impl Fn(&Expr) -> Expr,
) {
    for equation in equations {
        for statement in equation.statements.iter_mut().flatten() {
            each_side(statement, &mut |term, _| *term = change(term));
        }
    }
    for formula in page.locals.iter_mut().flat_map(|local| &mut local.formulas) {
        *formula = formula.map_terms(&change).into();
    }
}

/// Changes each term of a statement, in its other readings too, given where it stands.
pub(super) fn each_side(statement: &mut Statement, change: &mut impl FnMut(&mut Expr, Span)) {
    let mut of = |clauses: &mut Vec<Clause>| {
        for clause in clauses {
            match clause {
                Clause::Chain { sides, .. } => {
                    sides.iter_mut().for_each(|s| change(&mut s.expr, s.span));
                }
                Clause::AllEqual {
                    to, value, span, ..
                } => {
                    change(to, *span);
                    value.iter_mut().for_each(|s| change(&mut s.expr, s.span));
                }
            }
        }
    };
    of(&mut statement.clauses);
    of(&mut statement.under);
    for other in &mut statement.others {
        of(&mut other.statement.clauses);
        of(&mut other.statement.under);
    }
}

/// The terms of a statement, and of the conditions under which it is said.
pub(super) fn terms(statement: &Statement) -> impl Iterator<Item = &Expr> {
    let clauses = statement.clauses.iter().chain(&statement.under);
    clauses.flat_map(terms_of_clause)
}

/// The terms of a page, in its equations and in what is supposed.
pub(super) fn all_terms<'a>(
    page: &'a Page,
    equations: &'a [Equation],
) -> impl Iterator<Item = &'a Expr> {
    let statements = equations.iter().flat_map(Equation::statements);
    let supposed = page.locals.iter().flat_map(|local| &local.formulas);
    let supposed = supposed.flat_map(|formula| formula.terms());
    statements.flat_map(terms).chain(supposed)
}

pub(super) fn terms_of_clause(clause: &Clause) -> impl Iterator<Item = &Expr> {
    let (to, sides) = match clause {
        Clause::Chain { sides, .. } => (None, sides.as_slice()),
        Clause::AllEqual { to, value, .. } => (Some(to), value.as_slice()),
    };
    to.into_iter().chain(sides.iter().map(|side| &side.expr))
}

/// The formulas of a statement that says one thing: no implication, no question.
pub fn formulas(statement: &Statement) -> Vec<Formula> {
    match &statement.clauses[..] {
        [one] => stated(one),
        several => several.iter().flat_map(stated).collect(),
    }
}

/// What a statement supposes: the conditions under which it is said.
pub fn conditions(statement: &Statement) -> Vec<Formula> {
    statement.under.iter().flat_map(stated).collect()
}

/// The formulas of a statement that is said without conditions.
pub fn unconditional(statement: &Statement) -> Vec<Formula> {
    match statement.under.is_empty() {
        true => formulas(statement),
        false => Vec::new(),
    }
}

impl Equation {
    /// Takes what the end of its sentence cites for what it comes from, if that is said and nothing else is.
    pub(super) fn cite(&mut self, citations: &[Citation], says_from: bool) {
        if let Premises::Cited(cited) = &mut self.premises
            && cited.is_empty()
            && says_from
        {
            cited.extend_from_slice(citations);
            (self.bare, self.uncited) = (self.bare && cited.is_empty(), cited.is_empty());
        }
    }

    /// The number, or the name, or nothing.
    pub fn label(&self) -> Option<&str> {
        self.tag.as_deref().or(self.name.as_deref())
    }

    /// Whether it puts a slope to zero that it works out, `\frac{dR}{dr} = a - b/r^2 = 0`, and a formula of it says so: that is so at one place.
    pub(crate) fn puts_to_nought(&self, formula: &Formula) -> bool {
        let is_nought = |own: &Expr| *own == Expr::integer(0);
        let puts = |clause: &Clause| match clause {
            Clause::Chain { sides, .. } => match &sides[..] {
                [first, _, .., last] => is_slope_in_place(&first.expr) && is_nought(&last.expr),
                _ => false,
            },
            Clause::AllEqual { .. } => false,
        };
        let sides = formula.as_equation();
        sides.is_some_and(|(_, right)| is_nought(right))
            && self
                .statements()
                .iter()
                .any(|own| own.clauses.iter().any(puts))
    }

    /// The number in parentheses, or `claim name`, or `an unnumbered equation`.
    pub fn reference(&self) -> String {
        match (&self.tag, &self.name) {
            (Some(tag), _) => format!("({tag})"),
            (None, Some(name)) => format!("claim {name}"),
            (None, None) => "the unnumbered equation".into(),
        }
    }

    /// The statements; none where they could not be read.
    pub fn statements(&self) -> &[Statement] {
        self.statements.as_deref().unwrap_or_default()
    }

    /// Whether what stands at a position of a page is supposed where it stands, or told before it.
    pub fn is_under(&self, page: usize, local: usize) -> bool {
        let mut all = self.locals.iter().chain(&self.told).chain(&self.named);
        page == self.page && all.any(|&own| own == local)
    }

    /// Whether the text has said by an adjective that a symbol does not change.
    pub fn is_told_constant(&self, symbol: &Symbol) -> bool {
        self.said.get(symbol).is_some_and(Said::is_constant)
    }

    /// The symbols and sequences that it speaks of.
    pub fn symbols(&self) -> Set<Symbol> {
        let clauses = || self.statements().iter().flat_map(|own| &own.clauses);
        let terms = clauses().flat_map(terms_of_clause);
        let sequences = clauses().filter_map(|clause| match clause {
            Clause::AllEqual { sequence, .. } => Some(sequence.clone()),
            Clause::Chain { .. } => None,
        });
        let mut names = Formula::names_in(terms);
        names.extend(sequences);
        names
    }

    /// Whether it says of a symbol that stands alone what that is.
    pub(super) fn is_solved(&self) -> bool {
        let mut clauses = self.statements().iter().flat_map(|own| &own.clauses);
        clauses.any(|clause| match clause {
            Clause::Chain { sides, .. } => sides.split_last().is_some_and(|(_, all)| {
                let mut all = all.iter();
                all.any(|side| matches!(side.expr, Expr::Symbol(_)))
            }),
            Clause::AllEqual { .. } => false,
        })
    }

    /// Every relation of the equation: its two sides and what is said of them.
    pub fn relations(&self) -> Vec<(Expr, Relation, Expr)> {
        let goals = self.statements().iter().flat_map(goals);
        goals
            .filter_map(|goal| match goal.formula {
                Formula::Relation {
                    left,
                    relation,
                    right,
                } => Some((left, relation, right)),
                Formula::AllEqual { .. } => None,
            })
            .collect()
    }
}
