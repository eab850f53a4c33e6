//! Marks that stand for slopes: `\dot x` and `\ddot x` where a page says how `x` goes with the time, `x = A \cos(\omega t)`, or what else that
//! has dots it is made of, `s = x + y`, and `f'` where it says what a function is, `f(x) = x^3`. Elsewhere they are names like any other. And slopes that the text writes with a slash, `dc/dt`,
//! where displays write `\frac{dc}{dt}`.

use std::cell::LazyCell;

use crate::algebra::{Expr, Formula, LimitPoint, Symbol};
use crate::notation::names_a_place;
use crate::sorted::{Map, Set};

use super::Equation;
use super::equation::{all_terms, conditions, formulas, map_terms};
use super::names::{self, without_dots};
use super::page::Page;

/// What a dot stands for a slope by. A prime stands for another thing there, what comes after, or another frame, unless a page that speaks
/// of derivatives gives `y(t)` and writes `y'(t)`.
pub(crate) const TIME: &str = "t";

/// What a marked name stands for.
struct Slope {
    /// The name without marks.
    name: Symbol,
    order: usize,
    /// What it is differentiated by.
    by: Symbol,
    is_dot: bool,
    /// It has two primes somewhere: then what it is a function of may be left out.
    is_curved: bool,
}

/// What a page gives by terms.
#[derive(Default)]
struct Given {
    /// By a term in the time.
    moving: Set<Symbol>,
    /// By a term of any other kind, with what that speaks of.
    defined: Vec<(Symbol, Set<Symbol>)>,
    /// By any term, where what it is a function of is written with it.
    given: Set<Symbol>,
    /// Functions, each with what it is a function of; `None` where that is not the same everywhere.
    functions: Map<Symbol, Option<Symbol>>,
    /// What stands with two primes, `w''(x)`, each with what it is a function of there.
    curved: Map<Symbol, Set<Symbol>>,
    /// What stands with primes, `w'(x)`, with what it is a function of there.
    primed: Set<(Symbol, Symbol)>,
    /// All names with marks.
    marked: Set<Symbol>,
    /// What has a dot in `\frac{\partial L}{\partial \dot q}`: by that is differentiated as by a name of its own.
    varied: Set<Symbol>,
    /// Those that stand without what they are functions of.
    alone: Set<Symbol>,
    /// The text gives them by terms of their own.
    own: Set<Symbol>,
    /// What is differentiated somewhere.
    differentiated: Set<Symbol>,
    /// The same by name, with what by.
    slopes: Set<(Symbol, Symbol)>,
}

/// Reads dots over what is given by a term in `t` as derivatives by it, and primes on functions, unless they are declared.
pub(super) fn read_marks(page: &mut Page, equations: &mut [Equation]) {
    // Few pages have a mark.
    let is_marked = |part: &Expr| matches!(part, Expr::Symbol(name) | Expr::Apply(name, _) if base(name).is_some());
    if !all_terms(page, equations).any(|term| term.any(&is_marked)) {
        return;
    }
    let time = Symbol::new(TIME);
    let mut given = Given::default();
    for statement in equations.iter().flat_map(Equation::statements) {
        for formula in formulas(statement).iter().chain(&conditions(statement)) {
            given.see(formula, &time);
        }
    }
    for formula in page.locals.iter().flat_map(|local| &local.formulas) {
        given.see(formula, &time);
        if let Some((Expr::Symbol(name) | Expr::Apply(name, _), _)) = formula.as_equation() {
            given.own.insert(name.clone());
        }
    }
    given.tie_together(&time);
    given.heed_slopes();
    given.heed_curvatures();
    if given.marked.iter().any(|own| own.name().ends_with("''")) {
        let in_text = names::arguments_in_text(&page.document.source, page.document.inline());
        given.heed(in_text);
    }
    let source = &page.document.source;
    let of_slopes = LazyCell::new(|| {
        let mut words = ["derivative", "Derivative", "ifferentiat"].into_iter();
        words.any(|word| source.contains(word))
    });
    let of_slopes = || *of_slopes;
    let marked = std::mem::take(&mut given.marked).into_iter();
    let meant = marked.filter(|name| !page.is_declared(name));
    let slopes: Map<Symbol, Slope> = meant
        .filter_map(|name| Some((name.clone(), given.meaning(&name, &time, &of_slopes)?)))
        .collect();
    if !slopes.is_empty() {
        map_terms(page, equations, |term| written_out(term, &slopes));
    }
}

/// Whether a term speaks of something but for its value at a place: `x = x(0) e^{-t}` gives `x`.
fn varies_in(name: &Symbol, term: &Expr) -> bool {
    match term {
        Expr::Apply(own, at) if own == name => !matches!(&at[..], [Expr::Number(_)]),
        Expr::Symbol(own) if own == name => true,
        term => term.children().any(|part| varies_in(name, part)),
    }
}

impl Given {
    fn see(&mut self, formula: &Formula, time: &Symbol) {
        if let Some((left @ (Expr::Symbol(name) | Expr::Apply(name, _)), value)) =
            formula.as_equation()
            && !varies_in(name, value)
        {
            if value.mentions(time) {
                self.moving.insert(name.clone());
            } else if !matches!(value, Expr::Symbol(_)) {
                self.defined.push((name.clone(), value.free_symbols()));
            }
            if let Expr::Apply(_, arguments) = left
                && let [Expr::Symbol(argument)] = &arguments[..]
            {
                self.given.insert(name.clone());
                if value.mentions(argument) {
                    let known = self.functions.entry(name.clone());
                    let known = known.or_insert_with(|| Some(argument.clone()));
                    if known.as_ref() != Some(argument) {
                        *known = None;
                    }
                }
            }
        }
        for term in formula.terms() {
            self.collect_marked(term);
            term.collect_differentiated(&mut self.differentiated);
            self.collect_slopes(term);
        }
    }

    /// Adds the names of which `\frac{dx}{dt}` is written, with what they are differentiated by.
    fn collect_slopes(&mut self, term: &Expr) {
        if let Expr::Derivative { body, variable } = term
            && let Expr::Symbol(name) | Expr::Apply(name, _) = &**body
        {
            self.slopes.insert((name.clone(), variable.clone()));
        }
        (term.children()).for_each(|part| self.collect_slopes(part));
    }

    /// The place `L` in `w(L) = \frac{F L^3}{3 E I}` is no variable of a `w` of which `\frac{dw}{dx}` is written, and no other slope.
    fn heed_slopes(&mut self) {
        // `y'(x)` beside `\frac{dy}{dx}`.
        for own in self.primed.iter().filter(|own| self.slopes.contains(own)) {
            let (name, by) = own.clone();
            self.functions.entry(name).or_insert(Some(by));
        }
        for (name, argument) in &mut self.functions {
            let mut by = self.slopes.iter().filter(|own| own.0 == *name);
            if let (Some((_, by)), None) = (by.next(), by.next()) {
                *argument = Some(by.clone());
            }
        }
    }

    /// What stands with two primes where it is a function of `x` alone is one of that, and `w(L) = \frac{F L^3}{3 E I}` its value at a place.
    fn heed_curvatures(&mut self) {
        let (functions, slopes) = (&mut self.functions, &self.slopes);
        self.curved.retain(|name, arguments| {
            let mut arguments = arguments.iter().filter(|own| !names_a_place(own));
            let known = functions.get(name).and_then(Option::as_ref);
            let is_known = known.is_some_and(|own| !names_a_place(own))
                || slopes.iter().any(|own| own.0 == *name);
            match (arguments.next(), arguments.next()) {
                (Some(own), None) if !is_known => {
                    functions.insert(name.clone(), Some(own.clone()));
                    true
                }
                _ => false,
            }
        });
    }

    /// Where a page speaks of accelerations, what has dots and is given by others that have some moves as they do: after `s = x_1 + x_2`
    /// `\ddot s` is `\ddot x_1 + \ddot x_2`. A flow, `\dot Q = \dot m q`, need not be the slope of what has its letter.
    fn tie_together(&mut self, time: &Symbol) {
        let dots = |name: &Symbol| without_dots(name).filter(|own| own.1 <= 2);
        let dotted: Vec<(Symbol, u8)> = self.marked.iter().filter_map(dots).collect();
        let moves: Set<Symbol> = dotted.iter().map(|own| own.0.clone()).collect();
        self.tie_to_rates(&moves, time);
        if dotted.iter().all(|own| own.1 < 2) {
            return;
        }
        let varied = std::mem::take(&mut self.varied);
        for (name, of) in std::mem::take(&mut self.defined) {
            let of = of
                .iter()
                .map(|own| dots(own).map_or_else(|| own.clone(), |own| own.0));
            let mut others = of
                .filter(|own| moves.contains(own) && *own != name)
                .peekable();
            if moves.contains(&name) && others.peek().is_some() {
                let tied = others
                    .chain([name.clone()])
                    .filter(|own| !varied.contains(own));
                self.moving.extend(tied);
            }
        }
    }

    /// Where a page writes both `\frac{dx}{dt}` and `\dot x` of something, its dots are slopes by the time.
    fn tie_to_rates(&mut self, dotted: &Set<Symbol>, time: &Symbol) {
        let is_rate = |own: &Symbol| self.slopes.contains(&(own.clone(), time.clone()));
        if dotted.iter().any(is_rate) {
            let tied = dotted.iter().filter(|own| !self.varied.contains(*own));
            self.moving.extend(tied.cloned());
        }
    }

    /// What the text calls a function, "let $w(x)$ be the deflection", is one where its slope has two primes: with one, something else may be meant.
    fn heed(&mut self, in_text: Map<Symbol, Symbol>) {
        for (name, argument) in in_text {
            let twice = Symbol::new(format!("{name}''"));
            if self.marked.contains(&twice) && !self.functions.contains_key(&name) {
                self.functions.insert(name, Some(argument));
            }
        }
    }

    /// The names with marks in a term.
    fn collect_marked(&mut self, term: &Expr) {
        if let Expr::Symbol(name) | Expr::Apply(name, _) = term
            && base(name).is_some()
        {
            self.marked.insert(name.clone());
            match term {
                Expr::Apply(_, arguments) => self.collect_primed(name, arguments),
                _ => drop(self.alone.insert(name.clone())),
            }
        }
        if let Expr::Partial { variable, .. } = term
            && let Some((name, _)) = without_dots(variable)
        {
            self.varied.insert(name);
        }
        (term.children()).for_each(|part| self.collect_marked(part));
    }

    fn collect_primed(&mut self, marked: &Symbol, arguments: &[Expr]) {
        if let (Some((name, order, false)), [Expr::Symbol(argument)]) = (base(marked), arguments) {
            if order > 1 {
                let known = self.curved.entry(name.clone()).or_default();
                known.insert(argument.clone());
            }
            self.primed.insert((name, argument.clone()));
        }
    }

    /// What a name stands for, if that is a slope of something that is given; of what is given in the time only where the text speaks `of_slopes`,
    /// which is asked last.
    fn meaning(
        &self,
        marked: &Symbol,
        time: &Symbol,
        of_slopes: &impl Fn() -> bool,
    ) -> Option<Slope> {
        let (name, order, is_dot) = base(marked)?;
        let is_another = || self.alone.contains(marked) || self.own.contains(marked);
        // Who gives an `R'(r)` and writes `\frac{dR'}{dr}` means a thing of its own, per unit length.
        let is_own =
            || self.given.contains(marked) && self.slopes.iter().any(|own| own.0 == *marked);
        let says_so = || self.differentiated.contains(&name) || of_slopes();
        let may_be = |by: &Symbol| by != time || !is_another() && says_so();
        let by = match is_dot {
            true => self.moving.contains(&name).then(|| time.clone()),
            false if is_own() => None,
            false => self.functions.get(&name)?.clone().filter(may_be),
        };
        by.map(|by| Slope {
            is_curved: self.curved.contains_key(&name),
            name,
            order,
            by,
            is_dot,
        })
    }
}

/// What stands below the dots of a name, or before its primes, how many they are, and whether they are dots.
pub(super) fn base(name: &Symbol) -> Option<(Symbol, usize, bool)> {
    if let Some((own, dots)) = without_dots(name) {
        return (dots <= 2).then_some((own, dots.into(), true));
    }
    // Primes stand before what is below: `B''_1`.
    let marked = name.name();
    let first = marked.find('\'')?;
    let rest = marked[first..].trim_start_matches('\'');
    let order = marked.len() - first - rest.len();
    let is_name = first > 0 && (rest.is_empty() || rest.starts_with('_'));
    is_name.then(|| {
        let own = Symbol::new(format!("{}{rest}", &marked[..first]));
        (own, order, false)
    })
}

impl Slope {
    fn of(&self, body: Expr) -> Expr {
        (0..self.order).fold(body, |body, _| body.differentiated_by(&self.by))
    }

    /// With what is written in parentheses.
    fn at(&self, arguments: &[Expr]) -> Option<Expr> {
        let by = Expr::Symbol(self.by.clone());
        let body = || match self.is_curved {
            true => Expr::Symbol(self.name.clone()),
            false => Expr::Apply(self.name.clone(), [by.clone()].into()),
        };
        let slope = || self.of(body());
        match arguments {
            [argument] if *argument == by => Some(slope()),
            // Of a dotted name the value at a number is read later.
            [place] if !self.is_dot && !matches!(place, Expr::Symbol(_)) => Some(Expr::Limit {
                body: slope().into(),
                variable: self.by.clone(),
                point: LimitPoint::Finite(place.clone().into()),
            }),
            _ => None,
        }
    }
}

fn written_out(term: &Expr, slopes: &Map<Symbol, Slope>) -> Expr {
    let own = match term {
        Expr::Symbol(name) => {
            let slope = slopes.get(name);
            slope.map(|own| own.of(Expr::Symbol(own.name.clone())))
        }
        Expr::Apply(name, arguments) => slopes.get(name).and_then(|own| own.at(arguments)),
        _ => None,
    };
    own.unwrap_or_else(|| term.map_children(|part| written_out(part, slopes)))
}

/// A piece of mathematics in the text with its slopes written as displays write them, `\frac{dc}{dt}` for `dc/dt`, where displays
/// differentiate by the same with a `d`. By itself it might be a quotient of products.
pub(super) fn without_slashes(source: &str, math: &str) -> Option<String> {
    let mut written = String::new();
    let mut rest = math;
    let mut found = false;
    while let Some(slash) = rest.find('/') {
        let (before, after) = (rest[..slash].trim_end(), rest[slash + 1..].trim_start());
        let slope = upper(before).zip(lower(after));
        let is_meant = |lower: &str| differentiates(source, lower) || !has_letter_d(source);
        match slope.filter(|(_, lower)| is_meant(lower)) {
            Some((upper, lower)) => {
                written.push_str(&before[..before.len() - upper.len()]);
                written.push_str(&format!("\\frac{{{}}}{{{lower}}}", upper.trim()));
                rest = &after[lower.len()..];
                found = true;
            }
            None => {
                written.push_str(&rest[..=slash]);
                rest = after;
            }
        }
    }
    written.push_str(rest);
    found.then_some(written)
}

/// `dc` or `d^2 c` at the end of a text, as the upper part of a slope.
fn upper(text: &str) -> Option<&str> {
    let starts = text.match_indices('d').map(|(at, _)| at).rev();
    let is_upper = |&at: &usize| {
        let inside = text[..at].ends_with(|c: char| c.is_alphanumeric() || "\\_{^".contains(c));
        let name = text[at + 1..].trim_start();
        let name = name.strip_prefix("^2").unwrap_or(name).trim_start();
        !inside && length_of_name(name) == Some(name.len())
    };
    starts.take(2).find(is_upper).map(|at| &text[at..])
}

/// `dt` or `dt^2` at the beginning of a text, as the lower part of a slope.
fn lower(text: &str) -> Option<&str> {
    let after = text.strip_prefix('d')?;
    let name = after.trim_start();
    let mut length = text.len() - name.len() + length_of_name(name)?;
    if text[length..].starts_with("^2") {
        length += 2;
    }
    Some(&text[..length])
}

/// The length of a letter or a command, with what is below it, that a text begins with.
fn length_of_name(text: &str) -> Option<usize> {
    let first = text.chars().next()?;
    let mut length = match first {
        '\\' => {
            let letters = text[1..].find(|c: char| !c.is_ascii_alphabetic());
            1 + letters.unwrap_or(text.len() - 1)
        }
        first if first.is_alphabetic() => first.len_utf8(),
        _ => return None,
    };
    if let Some(below) = text[length..].strip_prefix('_') {
        length += 1 + match below.strip_prefix('{') {
            Some(inside) => inside.find('}')? + 2,
            None => below.chars().next()?.len_utf8(),
        };
    }
    Some(length)
}

/// Whether a text has a `d` that is no sign of differentials: with nothing after it that could be what changes.
fn has_letter_d(source: &str) -> bool {
    let mut all = source.match_indices('d');
    all.any(|(at, _)| {
        let begins = |c: char| c.is_alphanumeric() || matches!(c, '\\' | '{');
        let inside = source[..at].ends_with(|c: char| c.is_alphabetic() || c == '_');
        let after = source[at + 1..].trim_start();
        // `\frac{d^2 w}{dx^2}`
        let is_upper = after.starts_with('^') && source[..at].ends_with("\\frac{");
        !inside && !is_upper && !after.starts_with(begins)
    })
}

/// Whether a text has a fraction of differentials with this one below: `\frac{dx}{dt}`.
fn differentiates(source: &str, lower: &str) -> bool {
    let plain = |text: &str| text.replace([' ', '~'], "").replace("^2", "");
    let below = plain(lower);
    let mut fractions = source.split("\\frac{").skip(1);
    fractions.any(|own| {
        let parts = own.split_once('}');
        parts.is_some_and(|(over, rest)| {
            let under = rest
                .trim_start()
                .strip_prefix('{')
                .and_then(|own| own.split_once('}'));
            plain(over).starts_with('d') && under.is_some_and(|(under, _)| plain(under) == below)
        })
    })
}
