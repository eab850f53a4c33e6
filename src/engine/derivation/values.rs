//! What the text says that a symbol is the value of: `v(0) = v_0`, "$q = q_0$ at $t = 0$".

use num_traits::Zero;

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::document::{Document, Inline, Item, Span};
use crate::notation::{Statement, read_formulas};

use super::Derivation;
use super::equation::{Goal, formulas, goals};
use super::page::Page;
use super::slopes::base;
use super::supposed::is_number as is_number_or_unit;
use crate::notation::names_a_place;

/// More pieces of mathematics in the text than this are not looked through.
const MOST_SAID: usize = 500;
/// The words between a relation and the place where it is so.
const AT: [&str; 6] = ["at", "at time", "at the time", "for", "when", "where"];
/// What a dot is the slope by.
const TIMES: [&str; 2] = ["t", "\\tau"];
/// A place may have a name before its value, of no more words: "at the lower end $x = 0$".
const MOST_NAMING: usize = 3;
/// No more conditions are met at one place.
const MOST_JOINED: usize = 4;

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
    /// The name of the constant that it is, if nothing prints it.
    pub constant: Option<&'static str>,
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

/// What the text says that something is where a variable has some value: "$w = 0$ at the wall $r = R$".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConditionSaid {
    /// What has the value: a symbol, or a slope.
    pub of: Expr,
    /// The value.
    pub value: Expr,
    /// What says where that is; `None` for `w(0)`.
    pub variable: Option<Symbol>,
    /// What it is there.
    pub place: Expr,
    /// It is said between the display and the one before it.
    pub just_said: bool,
}

impl ConditionSaid {
    /// Whether it is told of how something changes there.
    pub fn is_of_slope(&self) -> bool {
        match &self.of {
            Expr::Symbol(name) => base(name).is_some(),
            own => matches!(own, Expr::Derivative { .. }),
        }
    }

    /// What has the value, where that may change with a variable: `y'` is the slope of `y`, and `\dot y` that by the time.
    pub fn subject(&self, variable: &Symbol) -> Expr {
        let is_time = TIMES.contains(&variable.name());
        match &self.of {
            Expr::Symbol(name)
                if let Some((own, order, is_dot)) = base(name)
                    && (is_time || !is_dot) =>
            {
                let own = Expr::Symbol(own);
                (0..order).fold(own, |own, _| own.differentiated_by(variable))
            }
            own => own.clone(),
        }
    }
}

impl Derivation {
    /// What the text says that something is at a place, the last said first: between a display and the one before it, or, where it says no
    /// such thing there, farther before.
    pub fn conditions_said(&self, at: usize) -> Vec<ConditionSaid> {
        let equation = &self.equations[at];
        let page = &self.pages[equation.page];
        let all: Vec<Span> = (page.document.inline().map(|math| math.body))
            .take_while(|body| body.end <= equation.span.start)
            .take(MOST_SAID)
            .collect();
        let conditions_at = |at: usize| conditions_at(page, &all, at);
        let before = self.before_display(at);
        let from = before.map_or(0, |before| self.equations[before].span.end);
        let first = all.partition_point(|body| body.start < from);
        let said: Vec<ConditionSaid> = (first..all.len()).rev().flat_map(conditions_at).collect();
        match said.is_empty() {
            true => (0..first).rev().flat_map(conditions_at).collect(),
            false => said
                .into_iter()
                .map(|own| ConditionSaid {
                    just_said: true,
                    ..own
                })
                .collect(),
        }
    }

    /// The numbers that a page prints for symbols before the display after an equation, in the text and in displays, the nearest ones.
    pub fn figures_before(&self, at: usize) -> Vec<Printed> {
        let own = &self.equations[at];
        let document = &self.pages[own.page].document;
        let next = self.equations.get(at + 1);
        let until = match next.filter(|next| next.page == own.page) {
            Some(next) => next.span.start,
            None => document.source.len(),
        };
        // What stands below the next heading is said of something else.
        let after = (document.items).partition_point(|item| item.span().start < own.span.end);
        let mut after = document.items[after..].iter();
        let heading = after.find(|item| matches!(item, Item::Heading { .. }));
        let until = heading.map_or(until, |heading| heading.span().start.min(until));
        // "with root $y \approx 0.919$": what solves an equation is not what is always meant.
        let solves = |math: &Inline| {
            let before = document.source.get(..math.span.start).unwrap_or_default();
            let before = before.trim_end();
            before.ends_with(" root") || before.ends_with(" roots")
        };
        let inline = document.inline().filter(|math| !solves(math));
        let bodies = inline.map(|math| math.body);
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
                constant: None,
            }));
        }
        let tabulated = &self.pages[own.page].tabulated;
        let before = tabulated.partition_point(|told| told.span.end <= until);
        let nearest = before.saturating_sub(MOST_FIGURES);
        found.extend_from_slice(&tabulated[nearest..before]);
        let first = self.equations_of(own.page).start;
        let displays = (first..at).rev().take(MOST_FIGURES);
        for (at, equation) in displays.map(|at| (at, &self.equations[at])) {
            let all = equation.statements().iter().filter_map(figure);
            found.extend(all.map(|goal| Printed {
                goal,
                span: equation.body,
                equation: Some(at),
                constant: None,
            }));
        }
        found
    }

    /// What the text of a page says that a symbol is the value of. `None` where it says something of the symbol that is no such thing,
    /// or too much to look through.
    pub fn values_said(&self, page: usize, symbol: &Symbol, of: &Symbol) -> Option<Vec<ValueSaid>> {
        let document = &self.pages[page].document;
        if document.inline().count() > MOST_SAID {
            return None;
        }
        let all: Vec<Span> = document.inline().map(|math| math.body).collect();
        let value_of = Expr::Symbol(symbol.clone());
        // "Setting $N = N_0/2$" and "what has decayed is $D = N_0 - N$" say nothing of what `N_0` is.
        let is_other = |formula: &Formula| match formula.as_equation() {
            Some((left, right)) => {
                let values = [left, right].into_iter().all(|side| *side != value_of);
                values && formula.terms().iter().any(|term| term.mentions(of))
            }
            None => false,
        };
        let mut values = Vec::new();
        for (at, &body) in all.iter().enumerate() {
            for formula in said(document, body) {
                if formula.names().contains(symbol) && !is_other(&formula) {
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

/// What one piece of mathematics says that something is at a place: "$w = w' = 0$ at $x = 0$", `w(0) = 0`.
fn conditions_at(page: &Page, all: &[Span], at: usize) -> Vec<ConditionSaid> {
    let text = page.document.text(all[at]);
    let place = place(&page.document, all, at);
    if !text.contains('=') || place.is_none() && !text.contains('(') {
        return Vec::new();
    }
    let place = match place.as_deref() {
        Some([place]) => place.as_equation(),
        _ => None,
    };
    let read = page.read_slopes(all[at]).unwrap_or_default();
    let said: Vec<Formula> = read.iter().flat_map(formulas).collect();
    let mut found: Vec<ConditionSaid> = Vec::new();
    // What `w = w' = 0` says of the first is what the last is.
    for (of, value) in said.iter().rev().filter_map(Formula::as_equation) {
        let same = found.iter().find(|own| own.of == *value);
        let value = same.map_or(value, |own| &own.value).clone();
        let (of, variable, place) = match (of, place) {
            (Expr::Apply(name, arguments), _)
                if let [place] = &arguments[..]
                    && is_place(place) =>
            {
                (Expr::Symbol(name.clone()), None, place)
            }
            (Expr::Symbol(_) | Expr::Derivative { .. }, Some((Expr::Symbol(variable), place))) => {
                (of.clone(), Some(variable), place)
            }
            _ => continue,
        };
        let varies = |term: &Expr| variable.is_some_and(|own| term.mentions(own));
        // "$w = c$ at $x = 0$ and $w = 0$ at $x = L$" says nothing of `x`.
        let is_place = matches!(&of, Expr::Symbol(own) if variable == Some(own));
        if !is_place && !varies(&value) && !varies(place) {
            found.push(ConditionSaid {
                of,
                value,
                variable: variable.cloned(),
                place: place.clone(),
                just_said: false,
            });
        }
    }
    found
}

/// Whether what is written in parentheses may be a place, and not what varies: `w(0)`, `w(L)`, `v(t_0)`.
fn is_place(argument: &Expr) -> bool {
    match argument {
        Expr::Number(_) => true,
        Expr::Symbol(own) => names_a_place(own),
        _ => false,
    }
}

fn said(document: &Document, body: Span) -> Vec<Formula> {
    let read = read_formulas(&document.source, body).unwrap_or_default();
    read.iter().flat_map(formulas).collect()
}

/// Where something has the value that a formula of a text gives it: what comes "at" after it, or begins the sentence.
fn place(document: &Document, all: &[Span], at: usize) -> Option<Vec<Formula>> {
    let before = at.checked_sub(1).map(|at| all[at]);
    // "$w = 0$ and $w' = 0$ at $x = 0$"
    let rest = all[at..].iter().take(MOST_JOINED).zip(&all[at + 1..]);
    let joined = rest.take_while(|own| joins(document, *own.0, *own.1));
    let last = at + joined.count();
    let body = all[last];
    match all.get(last + 1) {
        Some(&next) if comes_at(document, body, next) => Some(said(document, next)),
        _ => before
            .filter(|&own| goes_on(document, own, body))
            .map(|own| said(document, own)),
    }
}

/// What a statement says that a symbol is, as a number: `m = 2.5\,\mathrm{kg}`, and what `v = a t = 8.5` comes to.
pub(super) fn figure(statement: &Statement) -> Option<Goal> {
    let goals = goals(statement);
    let is_near = |goal: &Goal| {
        let near = matches!(
            goal.formula,
            Formula::Relation {
                relation: Relation::Equal | Relation::Approximately,
                ..
            }
        );
        near && goal.is_said_outright() && goal.clause == 0
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
    // That something is 0 is a case or a condition.
    let is_nought = matches!(right, Expr::Number(value) if value.is_zero());
    let is_number = !is_nought && right.free_symbols().iter().all(is_number_or_unit);
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
            let [place @ Expr::Number(_)] = &arguments[..] else {
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

/// "$q = q_0$ at $t = 0$", "$v = 0$ at the wall $r = R$".
fn comes_at(document: &Document, body: Span, place: Span) -> bool {
    let between = document
        .source
        .get(body.end..place.start)
        .unwrap_or_default();
    let words = between.trim_matches(|c: char| !c.is_alphabetic());
    let named = || {
        let name = words.strip_prefix("at the ")?;
        let mut name = name.split_whitespace();
        let is_word = |word: &str| word.chars().all(char::is_alphabetic);
        Some(name.by_ref().take(MOST_NAMING).all(is_word) && name.next().is_none())
    };
    AT.iter().any(|own| own.eq_ignore_ascii_case(words)) || named().unwrap_or(false)
}

/// "$w = 0$ and $w' = 0$", "$w = 0$, $w' = 0$"
fn joins(document: &Document, body: Span, next: Span) -> bool {
    let between = document.source.get(body.end..next.start);
    let between = between.unwrap_or_default();
    let words = between.trim_matches(|c: char| !c.is_alphabetic());
    matches!(words, "" | "and") && !between.contains(['.', ';', '?', '!', ':'])
}

/// "At $t = 0$ the charge is $q = q_0$": one sentence, which begins with the place.
fn goes_on(document: &Document, place: Span, body: Span) -> bool {
    let between = document
        .source
        .get(place.end..body.start)
        .unwrap_or_default();
    let before = document.source.get(..place.start).unwrap_or_default();
    let before = before.trim_end_matches(|c: char| !c.is_alphabetic());
    let word = before.rsplit(|c: char| !c.is_alphabetic()).next();
    let begins = word.is_some_and(|word| ["At", "at", "When", "when", "time"].contains(&word));
    // "At the wall $x = b$ we have $w = 0$", "from the wall $x = b$, where $w = 0$"
    let named = || {
        let words = before.rsplit(char::is_whitespace).take(MOST_NAMING + 2);
        let words: Vec<&str> = words.collect();
        let the = words.iter().skip(1).position(|own| *own == "the");
        the.and_then(|at| words.get(at + 2)).copied()
    };
    let where_it_is = || between.trim_matches(|c: char| !c.is_alphabetic()) == "where";
    let begins = begins
        || match named() {
            Some("At" | "at") => true,
            Some("from" | "From") => where_it_is(),
            _ => false,
        };
    begins && !between.contains(['.', ';', '?'])
}
