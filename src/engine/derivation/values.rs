//! What the text says that a symbol is the value of: `v(0) = v_0`, "$q = q_0$ at $t = 0$".

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::document::{Document, Span};
use crate::notation::{Statement, read_formulas};

use super::Derivation;
use super::equation::{Goal, formulas, goals};

/// More pieces of mathematics in the text than this are not looked through.
const MOST_SAID: usize = 500;
/// The words between a relation and the place where it is so.
const AT: [&str; 6] = ["at", "at time", "at the time", "for", "when", "where"];

/// More numbers than this that a page prints are not looked at.
const MOST_FIGURES: usize = 100;

/// A number that a page prints for a symbol. Of what case it is said is not known.
#[derive(Clone, Debug)]
pub struct Printed {
    /// `m = 2.5\,\mathrm{kg}`
    pub goal: Goal,
    /// Where it stands.
    pub span: Span,
    /// The display that prints it, if it is none in the text.
    pub equation: Option<usize>,
}

/// The value of something at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValueSaid {
    /// What has the value.
    pub of: Symbol,
    /// What is a number at the place, where that is said.
    pub variable: Option<Symbol>,
    /// The number.
    pub place: Expr,
}

impl Derivation {
    /// The numbers that a page prints for symbols before the display after an equation, in the text and in displays, the nearest ones.
    pub fn figures_before(&self, at: usize) -> Vec<Printed> {
        let own = &self.equations[at];
        let document = &self.pages[own.page].document;
        let next = self.equations.get(at + 1);
        let until = match next.filter(|next| next.page == own.page) {
            Some(next) => next.span.start,
            None => document.source.len(),
        };
        let bodies = document.inline().map(|math| math.body);
        let bodies = bodies.take_while(|body| body.end <= until);
        let may_be_figure = |body: &Span| {
            let text = document.source.get(body.range()).unwrap_or_default();
            let is_number = text.contains(|c: char| c.is_ascii_digit());
            is_number && (text.contains('=') || text.contains("\\approx"))
        };
        let mut bodies: Vec<Span> = bodies.filter(may_be_figure).collect();
        let nearest = bodies.len().saturating_sub(MOST_FIGURES);
        let mut found = Vec::new();
        for span in bodies.drain(nearest..) {
            let read = read_formulas(&document.source, span).unwrap_or_default();
            found.extend(read.iter().filter_map(figure).map(|goal| Printed {
                goal,
                span,
                equation: None,
            }));
        }
        let first = self.equations_of(own.page).start;
        let displays = (first..at).rev().take(MOST_FIGURES);
        for (at, equation) in displays.map(|at| (at, &self.equations[at])) {
            let all = equation.statements().iter().filter_map(figure);
            found.extend(all.map(|goal| Printed {
                goal,
                span: equation.body,
                equation: Some(at),
            }));
        }
        found
    }

    /// What the text of a page says that a symbol is the value of. `None` where it says something of the symbol that is no such thing,
    /// or too much to look through.
    pub fn values_said(&self, page: usize, symbol: &Symbol) -> Option<Vec<ValueSaid>> {
        let document = &self.pages[page].document;
        if document.inline().count() > MOST_SAID {
            return None;
        }
        let all: Vec<Span> = document.inline().map(|math| math.body).collect();
        let value_of = Expr::Symbol(symbol.clone());
        let mut values = Vec::new();
        for (at, &body) in all.iter().enumerate() {
            for formula in said(document, body) {
                if formula.names().contains(symbol) {
                    let place = || place(document, &all, at);
                    let value = value(&formula, &value_of);
                    values.push(value.or_else(|| value_at(&formula, &value_of, &place()?))?);
                }
            }
        }
        Some(values)
    }

    /// The number that the text before a display says a symbol has at a place, the last one: "with $w = 0$ at $x = 0$".
    pub fn number_said(&self, at: usize, of: &Symbol) -> Option<(ValueSaid, Expr)> {
        let equation = &self.equations[at];
        let document = &self.pages[equation.page].document;
        let all: Vec<Span> = (document.inline().map(|math| math.body))
            .take_while(|body| body.end <= equation.span.start)
            .take(MOST_SAID)
            .collect();
        let number = |formula: &Formula| match formula.as_equation() {
            Some((Expr::Symbol(own), number @ Expr::Number(_))) if own == of => {
                Some(number.clone())
            }
            _ => None,
        };
        (0..all.len()).rev().find_map(|at| {
            let mut read = said(document, all[at]).into_iter();
            read.find_map(|formula| {
                let number = number(&formula)?;
                let place = place(document, &all, at)?;
                Some((value_at(&formula, &number, &place)?, number))
            })
        })
    }
}

fn said(document: &Document, body: Span) -> Vec<Formula> {
    let read = read_formulas(&document.source, body).unwrap_or_default();
    read.iter().flat_map(formulas).collect()
}

/// Where something has the value that a formula of a text gives it: what comes "at" after it, or begins the sentence.
fn place(document: &Document, all: &[Span], at: usize) -> Option<Vec<Formula>> {
    let body = all[at];
    let before = at.checked_sub(1).map(|at| all[at]);
    match all.get(at + 1) {
        Some(&next) if comes_at(document, body, next) => Some(said(document, next)),
        _ => before
            .filter(|&own| goes_on(document, own, body))
            .map(|own| said(document, own)),
    }
}

/// What a statement says that a symbol is, as a number: `m = 2.5\,\mathrm{kg}`, and what `v = a t = 8.5` comes to.
fn figure(statement: &Statement) -> Option<Goal> {
    let goals = goals(statement);
    let is_near = |goal: &Goal| {
        let near = matches!(
            goal.formula,
            Formula::Relation {
                relation: Relation::Equal | Relation::Approximately,
                ..
            }
        );
        near && goal.suppositions.is_empty() && !goal.questioned && goal.clause == 0
    };
    let (first, last) = (goals.first()?, goals.last()?);
    let Formula::Relation { left, .. } = &first.formula else {
        return None;
    };
    let Formula::Relation {
        relation, right, ..
    } = &last.formula
    else {
        return None;
    };
    let is_symbol = matches!(left, Expr::Symbol(symbol) if !symbol.is_unit());
    let is_number = right.free_symbols().iter().all(Symbol::is_unit);
    let plain = statement.mark.is_none() && goals.iter().all(is_near);
    (plain && is_symbol && is_number).then(|| Goal {
        formula: Formula::Relation {
            left: left.clone(),
            relation: *relation,
            right: right.clone(),
        },
        ..last.clone()
    })
}

/// `v(0) = v_0`.
fn value(formula: &Formula, value: &Expr) -> Option<ValueSaid> {
    match formula.as_equation()? {
        (Expr::Apply(name, arguments), own) if own == value => {
            let [place @ Expr::Number(_)] = arguments.as_slice() else {
                return None;
            };
            Some(ValueSaid {
                of: name.clone(),
                variable: None,
                place: place.clone(),
            })
        }
        _ => None,
    }
}

/// `q = q_0`, where something is a number.
fn value_at(formula: &Formula, value: &Expr, place: &[Formula]) -> Option<ValueSaid> {
    let [place] = place else {
        return None;
    };
    match (formula.as_equation()?, place.as_equation()?) {
        ((Expr::Symbol(name), own), (Expr::Symbol(variable), place @ Expr::Number(_)))
            if own == value =>
        {
            Some(ValueSaid {
                of: name.clone(),
                variable: Some(variable.clone()),
                place: place.clone(),
            })
        }
        _ => None,
    }
}

/// "$q = q_0$ at $t = 0$".
fn comes_at(document: &Document, body: Span, place: Span) -> bool {
    let between = document
        .source
        .get(body.end..place.start)
        .unwrap_or_default();
    let words = between.trim_matches(|c: char| !c.is_alphabetic());
    AT.iter().any(|own| own.eq_ignore_ascii_case(words))
}

/// "At $t = 0$ the charge is $q = q_0$": one sentence, which begins with the place.
fn goes_on(document: &Document, place: Span, body: Span) -> bool {
    let between = document
        .source
        .get(place.end..body.start)
        .unwrap_or_default();
    let before = document.source.get(..place.start).unwrap_or_default();
    let word = before.trim_end_matches(|c: char| !c.is_alphabetic());
    let word = word.rsplit(|c: char| !c.is_alphabetic()).next();
    let begins = word.is_some_and(|word| ["At", "at", "When", "when", "time"].contains(&word));
    begins && !between.contains(['.', ';', '?'])
}
