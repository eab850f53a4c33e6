//! What partial derivatives hold fixed, where nobody says so: all else of the formula that the page gives for what is differentiated.
//!
//! `\frac{\partial E}{\partial v}` after `E = \frac12 m v^2 + V` holds `m` and `V` fixed. After `L = T - V`, `T = \frac12 m v^2` it is taken of what
//! `L` comes to, for `T` depends on `v`. Where a formula has the variable in it and something besides that depends on it, too, or the
//! page has other formulas, in other symbols, it may be meant in several ways: then nothing that is said with it fails. What stands under the derivative itself,
//! `\frac{\partial}{\partial v}\left[\frac12 m v^2\right] = m v`, holds its other symbols fixed where the equation says what that comes to, in
//! these symbols; in `\frac{\partial}{\partial r}\left[r^2 u\right] = 0` the unknown `u` may depend on `r`.
//!
//! `y(x, t)` and `y` are one quantity where one of them is differentiated. And where `\frac{d}{dt} \frac{\partial L}{\partial \dot x}` is spoken of,
//! `\dot x` is the slope of `x`, and `\ddot x` that of `\dot x`.

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::document::Span;
use crate::notation::{Clause, Statement};
use crate::sorted::{Map, Set};

use super::Equation;
use super::equation::{each_side, map_terms};
use super::names::undotted;
use super::page::Page;

/// A formula for a name, `E = \frac12 m v^2`, or for a function, `y(x, t) = A \sin(k x - \omega t)`.
struct Given {
    of: Expr,
    /// The chain of equations that it stands in.
    chain: usize,
    symbols: Set<Symbol>,
    /// Those of them that are nothing but summands: `T` and `V` in `T - V`.
    summands: Set<Symbol>,
}

/// A formula leads through at most so many others to the variable.
const MOST_STEPS: usize = 8;

/// What the equations of a page say of what depends on what.
#[derive(Default)]
struct Said {
    formulas: Vec<Given>,
    /// What is differentiated partially.
    dependent: Set<Symbol>,
    /// What is differentiated by partially, or is an argument: these do not depend on each other.
    independent: Set<Symbol>,
    /// What is differentiated otherwise.
    moving: Set<Symbol>,
    /// What the formulas that speak of a symbol are of.
    spoken_of_in: Map<Symbol, Set<Symbol>>,
    /// What depends on a symbol by its formulas, once that was asked.
    leading: Map<Symbol, Set<Symbol>>,
    /// Partial derivatives of terms that hold fixed what the equation does not speak of as changing.
    presumed: Set<Expr>,
    /// What is not clear, with the variable.
    unclear: Set<(Symbol, Symbol)>,
}

/// Says of each partial derivative on a page what it holds fixed, as far as that can be told.
pub(super) fn tell_what_is_held(page: &mut Page, equations: &mut [Equation]) {
    // Most pages have none.
    let speaks = |own: &Equation| {
        let text = page.document.text(own.body);
        text.contains("partial") || text.contains("pdv")
    };
    if !equations.iter().any(speaks) {
        return;
    }
    write_alike(page, equations);
    let statements = || equations.iter().flat_map(Equation::statements);
    let mut said = Said::default();
    let chains = statements().filter(|own| own.under.is_empty());
    for (chain, clause) in chains.flat_map(|own| &own.clauses).enumerate() {
        said.learn(&equal_sides(clause), chain);
    }
    let told = page.locals.iter().flat_map(|local| &local.formulas);
    for (formula, chain) in told.zip(usize::MAX / 2..) {
        if let Some((left, right)) = formula.as_equation() {
            said.learn(&[left, right], chain);
        }
    }
    said.look_up();
    let constant = |symbol: &Symbol| match page.domains.get(symbol) {
        Some(domain) => domain.constant,
        None => symbol.name() == "\\pi",
    };
    for equation in equations.iter_mut() {
        for statement in equation.statements.iter_mut().flatten() {
            let all: Vec<Expr> = sides_of(statement).cloned().collect();
            each_side(statement, &mut |side, _| {
                let own = side.clone();
                let others: Vec<&Expr> = all.iter().filter(|other| **other != own).collect();
                *side = said.with_held(&own, &others, &constant);
            });
        }
    }
    for formula in page.locals.iter_mut().flat_map(|local| &mut local.formulas) {
        if formula
            .terms()
            .into_iter()
            .any(|term| term.any(&is_partial))
        {
            let all: Vec<Expr> = formula.terms().into_iter().cloned().collect();
            let told = formula.map_terms(|own| {
                let others: Vec<&Expr> = all.iter().filter(|other| *other != own).collect();
                said.with_held(own, &others, &constant)
            });
            *formula = told.into();
        }
    }
    (page.dependent, page.unclear_slopes) = (said.dependent, said.unclear);
    page.presumed_slopes = said.presumed;
    tie_dots(page, equations);
}

/// How a page speaks of what is differentiated partially.
#[derive(Default)]
struct Applied {
    /// What it is applied to; `None` where that is not the same everywhere.
    to: Option<Vec<Expr>>,
    is_applied: bool,
    /// It stands without arguments, and not only below a partial derivative.
    alone: bool,
    differentiated: bool,
}

/// Writes `y(x, t)` and `y` in one way, where one of them is differentiated partially: without what it depends on where it stands so
/// elsewhere, and otherwise with.
fn write_alike(page: &mut Page, equations: &mut [Equation]) {
    let mut all: Map<Symbol, Applied> = Map::new();
    for statement in equations.iter().flat_map(Equation::statements) {
        sides_of(statement).for_each(|side| see_applied(side, &mut all));
    }
    for formula in page.locals.iter().flat_map(|local| &local.formulas) {
        let terms = formula.terms().into_iter();
        terms.for_each(|term| see_applied(term, &mut all));
    }
    all.retain(|_, own| own.is_applied && own.differentiated && own.to.is_some());
    if !all.is_empty() {
        map_terms(page, equations, |term| alike(term, &all));
    }
}

fn see_applied(term: &Expr, all: &mut Map<Symbol, Applied>) {
    match term {
        Expr::Symbol(name) => all.entry(name.clone()).or_default().alone = true,
        Expr::Apply(name, arguments) => {
            let known = all.entry(name.clone()).or_default();
            let is_first = !known.is_applied;
            known.is_applied = true;
            let bare = arguments.iter().all(|own| matches!(own, Expr::Symbol(_)));
            if is_first && bare {
                known.to = Some(arguments.clone());
            } else if known.to.as_ref() != Some(arguments) {
                known.to = None;
            }
        }
        Expr::Partial { body, .. } => {
            if let Some(name) = name_of(body) {
                all.entry(name.clone()).or_default().differentiated = true;
            }
            if !matches!(**body, Expr::Symbol(_)) {
                see_applied(body, all);
            }
            return;
        }
        _ => {}
    }
    if !matches!(term, Expr::Apply(..)) {
        term.children().for_each(|child| see_applied(child, all));
    }
}

fn alike(term: &Expr, all: &Map<Symbol, Applied>) -> Expr {
    match term {
        Expr::Apply(name, arguments) if arguments.len() > 1 => match all.get(name) {
            Some(own) if own.alone => Expr::Symbol(name.clone()),
            _ => term.clone(),
        },
        Expr::Partial {
            body,
            variable,
            held,
        } => {
            let with_arguments = name_of(body).and_then(|name| {
                let own = all.get(name).filter(|own| !own.alone)?;
                Some(Expr::Apply(name.clone(), own.to.clone()?))
            });
            Expr::Partial {
                body: with_arguments.unwrap_or_else(|| alike(body, all)).into(),
                variable: variable.clone(),
                held: held.clone(),
            }
        }
        term => term.map_children(|child| alike(child, all)),
    }
}

/// Where `\frac{d}{dt} \frac{\partial L}{\partial \dot x}` is spoken of, that `\dot x` and `\ddot x` are slopes.
fn tie_dots(page: &mut Page, equations: &mut [Equation]) {
    let mut found: Option<Span> = None;
    let mut tied: Set<(Symbol, Symbol)> = Set::new();
    let mut time = None;
    for equation in equations.iter() {
        for side in equation.statements().iter().flat_map(sides_of) {
            let mut own = None;
            turned(side, &mut own);
            if let Some(by) = own {
                found = found.or(Some(equation.body));
                time = time.or(Some(by));
            }
            dotted_variables(side, &mut tied);
        }
    }
    let (Some(span), Some(time)) = (found, time) else {
        return;
    };
    let mut said = Vec::new();
    for (dotted, name) in tied {
        let slope = |own: &Symbol| Expr::Symbol(own.clone()).differentiated_by(&time);
        let twice = Symbol::new(format!("\\ddot{{{}}}", name.name()));
        said.push(Formula::equal(slope(&name), Expr::Symbol(dotted.clone())));
        said.push(Formula::equal(slope(&dotted), Expr::Symbol(twice)));
    }
    if said.is_empty() {
        return;
    }
    let own = page.suppose_meant(said, span);
    for equation in equations {
        equation.locals.push(own);
    }
}

/// By what a partial derivative is differentiated further, if one is.
fn turned(term: &Expr, found: &mut Option<Symbol>) {
    if let Expr::Derivative { body, variable } = term
        && body.any(&is_partial)
    {
        found.get_or_insert_with(|| variable.clone());
    }
    term.children().for_each(|child| turned(child, found));
}

/// The names with a dot by which is differentiated, each with the name below it.
fn dotted_variables(term: &Expr, found: &mut Set<(Symbol, Symbol)>) {
    if let Expr::Partial { variable, .. } = term
        && let Some(name) = undotted(variable)
    {
        found.insert((variable.clone(), name));
    }
    term.children()
        .for_each(|child| dotted_variables(child, found));
}

fn is_partial(term: &Expr) -> bool {
    matches!(term, Expr::Partial { .. })
}

fn sides_of(statement: &Statement) -> impl Iterator<Item = &Expr> {
    statement.clauses.iter().flat_map(|clause| match clause {
        Clause::Chain { sides, .. } => sides.iter().map(|side| &side.expr).collect(),
        Clause::AllEqual { .. } => Vec::new(),
    })
}

/// The sides of a chain in which nothing but `=` stands.
fn equal_sides(clause: &Clause) -> Vec<&Expr> {
    match clause {
        Clause::Chain { sides, links } if links.iter().all(|l| l.relation == Relation::Equal) => {
            sides.iter().map(|side| &side.expr).collect()
        }
        _ => Vec::new(),
    }
}

/// The name of what is given or differentiated.
fn name_of(term: &Expr) -> Option<&Symbol> {
    match term {
        Expr::Symbol(name) | Expr::Apply(name, _) => Some(name),
        _ => None,
    }
}

/// The symbols that are summands of a term and stand nowhere else in it.
fn summands(term: &Expr) -> Set<Symbol> {
    let Expr::Sum(terms) = term else {
        return Set::new();
    };
    let (mut found, mut elsewhere) = (Set::new(), Set::new());
    for own in terms {
        match own {
            Expr::Symbol(name) => {
                found.insert(name.clone());
            }
            Expr::Negate(inner) if matches!(**inner, Expr::Symbol(_)) => {
                found.append(&mut inner.free_symbols());
            }
            other => elsewhere.append(&mut other.free_symbols()),
        }
    }
    found.retain(|own| !elsewhere.contains(own));
    found
}

/// In which symbols a formula is written.
enum Written {
    /// In the variables and these.
    In(Set<Symbol>),
    /// Not in all of the variables.
    Elsewhere,
    /// Something besides the variables may depend on them, too.
    Unclear,
}

impl Said {
    /// Learns from terms that are equal to each other.
    fn learn(&mut self, sides: &[&Expr], chain: usize) {
        for (at, of) in sides.iter().enumerate() {
            self.see(of);
            let Some(name) = name_of(of) else { continue };
            let others = sides.iter().enumerate().filter(|(other, _)| *other != at);
            for (_, term) in others {
                let says_nothing = matches!(term, Expr::Number(_)) || name_of(term).is_some();
                if !says_nothing && !term.mentions(name) && !term.any(&is_partial) {
                    self.formulas.push(Given {
                        of: (*of).clone(),
                        chain,
                        symbols: term.free_symbols(),
                        summands: summands(term),
                    });
                }
            }
        }
    }

    fn see(&mut self, term: &Expr) {
        match term {
            Expr::Partial { body, variable, .. } => {
                self.dependent.extend(name_of(body).cloned());
                self.independent.insert(variable.clone());
                self.independent.extend(term.held().iter().cloned());
            }
            Expr::Derivative { body, .. } => self.moving.extend(name_of(body).cloned()),
            Expr::Apply(_, arguments) => {
                let names = arguments.iter().filter_map(|own| match own {
                    Expr::Symbol(name) => Some(name.clone()),
                    _ => None,
                });
                self.independent.extend(names);
            }
            _ => {}
        }
        term.children().for_each(|child| self.see(child));
    }

    fn look_up(&mut self) {
        for given in &self.formulas {
            let Some(name) = name_of(&given.of) else {
                continue;
            };
            for symbol in &given.symbols {
                let known = self.spoken_of_in.entry(symbol.clone()).or_default();
                known.insert(name.clone());
            }
        }
    }

    /// What depends on a symbol by its formula, or by that of something in it, and is no variable itself.
    fn leading_to(&mut self, variable: &Symbol) -> Set<Symbol> {
        if let Some(known) = self.leading.get(variable) {
            return known.clone();
        }
        let mut found = Set::new();
        let mut open = vec![variable.clone()];
        while let Some(symbol) = open.pop() {
            let Some(names) = self.spoken_of_in.get(&symbol) else {
                continue;
            };
            for name in names {
                if !self.independent.contains(name) && found.insert(name.clone()) {
                    open.push(name.clone());
                }
            }
        }
        self.leading.insert(variable.clone(), found.clone());
        found
    }

    /// A term with what its partial derivatives hold fixed; `others` are what it is said to be equal to.
    fn with_held(
        &mut self,
        term: &Expr,
        others: &[&Expr],
        constant: &impl Fn(&Symbol) -> bool,
    ) -> Expr {
        let (variables, inner) = term.without_partials();
        let mut body = inner.map_children(|child| self.with_held(child, others, constant));
        if variables.is_empty() {
            return self.with_parameters(body, constant);
        }
        let together = match name_of(&body).cloned() {
            Some(name) => self
                .formula(&name, &variables, others)
                .map(|(of, together)| {
                    body = of;
                    together
                }),
            None => self.evaluated(&body, &variables, others),
        };
        let held_with = |variable: &Symbol| {
            let held = together.as_ref()?.iter();
            let held = held.filter(|own| *own != variable && !constant(own));
            let held: Box<[Symbol]> = held.cloned().collect();
            (!held.is_empty()).then_some(held)
        };
        let presumed = name_of(&body).is_none() && together.is_some();
        let derived = |body: Expr, variable: Symbol| Expr::Partial {
            body: body.into(),
            held: held_with(&variable),
            variable,
        };
        let slope = variables.into_iter().rev().fold(body, derived);
        if presumed {
            self.presumed.insert(slope.clone());
        }
        slope
    }

    /// A partial derivative of which it is told what is held fixed, with what else is.
    fn with_parameters(&mut self, term: Expr, constant: &impl Fn(&Symbol) -> bool) -> Expr {
        let Expr::Partial {
            body,
            variable,
            held: Some(told),
        } = term
        else {
            return term;
        };
        let mut inner = &*body;
        while let Expr::Partial { body, .. } = inner {
            inner = body;
        }
        let further = name_of(inner).cloned();
        let further = further.and_then(|name| self.parameters(&name, &variable, &told, constant));
        let mut held = told.to_vec();
        held.extend(further.into_iter().flatten());
        held.sort();
        held.dedup();
        Expr::Partial {
            body,
            variable,
            held: Some(held.into()),
        }
    }

    /// With the summands put in that are written in what else the page differentiates by: `V` has to be so for `\frac{\partial L}{\partial x}`, and
    /// cannot be held fixed by itself beside that.
    fn put_in(
        &self,
        mut symbols: Set<Symbol>,
        summands: Set<Symbol>,
        variables: &[Symbol],
    ) -> Set<Symbol> {
        for name in summands {
            let of_it = |given: &&Given| name_of(&given.of) == Some(&name);
            let mut formulas = self.formulas.iter().filter(of_it);
            let Some(first) = formulas.next() else {
                continue;
            };
            let mut own = first.symbols.iter();
            if !variables.contains(&name)
                && !self.independent.contains(&name)
                && formulas.all(|other| other.symbols == first.symbols)
                && own.clone().any(|own| self.independent.contains(own))
                && !own.any(|own| self.dependent.contains(own))
            {
                symbols.remove(&name);
                symbols.extend(first.symbols.iter().cloned());
            }
        }
        symbols
    }

    /// What else is held fixed where it is told that some of it is: the other letters of a formula for it that is written in just what is told
    /// and the variable, as far as nothing on the page speaks of them as changing. `p = \frac{n R T}{V}` has `n` and `R` besides `T` and `V`.
    fn parameters(
        &mut self,
        name: &Symbol,
        variable: &Symbol,
        told: &[Symbol],
        constant: &impl Fn(&Symbol) -> bool,
    ) -> Option<Vec<Symbol>> {
        let mut variables = told.to_vec();
        variables.push(variable.clone());
        let is_written = |given: &&Given| {
            name_of(&given.of) == Some(name)
                && variables.iter().all(|own| given.symbols.contains(own))
        };
        let mut all = self.formulas.iter().filter(is_written);
        let symbols = all.next()?.symbols.clone();
        if !all.all(|own| own.symbols == symbols) {
            return None;
        }
        let others = symbols.iter();
        let others = others.filter(|own| !variables.contains(own) && !constant(own));
        let others: Vec<Symbol> = others.cloned().collect();
        let leading: Vec<Set<Symbol>> = variables.iter().map(|own| self.leading_to(own)).collect();
        let changes = |own: &Symbol| {
            self.independent.contains(own)
                || self.dependent.contains(own)
                || self.moving.contains(own)
                || leading.iter().any(|all| all.contains(own))
        };
        (!others.iter().any(changes)).then_some(others)
    }

    /// What a name is given as, and in which symbols: in a formula that is written in all of these variables, or leads to them.
    ///
    /// Of several one is meant in whose symbols the equation is written.
    fn formula(
        &mut self,
        name: &Symbol,
        variables: &[Symbol],
        others: &[&Expr],
    ) -> Option<(Expr, Set<Symbol>)> {
        let leading: Vec<Set<Symbol>> = variables.iter().map(|own| self.leading_to(own)).collect();
        let own = self.formulas.iter();
        let own: Vec<&Given> = own
            .filter(|given| name_of(&given.of) == Some(name))
            .collect();
        let found: Vec<Written> = own
            .iter()
            .map(|given| self.written_in(name, given, variables, &leading))
            .collect();
        let all = || {
            let both = own.iter().zip(&found);
            both.filter_map(|(given, found)| match found {
                Written::In(symbols) => Some((*given, symbols)),
                _ => None,
            })
        };
        let spoken: Set<Symbol> = others.iter().flat_map(|own| own.free_symbols()).collect();
        let covers = |symbols: &Set<Symbol>| spoken.iter().all(|own| symbols.contains(own));
        let meant = all()
            .find(|(_, symbols)| covers(symbols))
            .or_else(|| all().next());
        let is_clear = meant.is_some_and(|(first, meant)| {
            own.iter().zip(&found).all(|(given, found)| {
                let is_same = match found {
                    Written::In(symbols) => {
                        let same = self.is_the_same(symbols, meant);
                        symbols == meant || same || self.is_the_same(meant, symbols)
                    }
                    Written::Elsewhere => self.is_the_same(&given.symbols, meant),
                    Written::Unclear => false,
                };
                given.of == first.of && (is_same || given.chain == first.chain)
            })
        });
        let meant = meant.map(|(given, symbols)| (given.of.clone(), symbols.clone()));
        if !is_clear && !own.is_empty() {
            let slopes = variables.iter().map(|own| (name.clone(), own.clone()));
            self.unclear.extend(slopes);
        }
        meant
    }

    /// The symbols that a formula in these symbols is written in, once what depends on the variables is put in.
    fn written_in(
        &self,
        name: &Symbol,
        given: &Given,
        variables: &[Symbol],
        leading: &[Set<Symbol>],
    ) -> Written {
        // Of a coordinate whose velocity stands in it, a Lagrangian is written without it if it is cyclic.
        let is_written = |symbols: &Set<Symbol>, variable: &Symbol| {
            let is_velocity = |own: &Symbol| undotted(own).as_ref() == Some(variable);
            symbols.contains(variable) || symbols.iter().any(is_velocity)
        };
        let (mut symbols, mut summands) = (given.symbols.clone(), given.summands.clone());
        for _ in 0..MOST_STEPS {
            let mut further: Set<Symbol> = Set::new();
            for (variable, leading) in variables.iter().zip(leading) {
                let mut open = symbols
                    .iter()
                    .filter(|own| !variables.contains(own) && leading.contains(*own))
                    .peekable();
                if open.peek().is_some() && is_written(&symbols, variable) {
                    return Written::Unclear;
                }
                further.extend(open.cloned());
            }
            if further.is_empty() {
                let carried = |own: &&Symbol| !variables.contains(own);
                let mut carried = symbols.iter().filter(carried);
                return if carried.any(|own| own == name || self.dependent.contains(own)) {
                    Written::Unclear
                } else if variables.iter().all(|own| is_written(&symbols, own)) {
                    Written::In(self.put_in(symbols, summands, variables))
                } else {
                    Written::Elsewhere
                };
            }
            // `W = \frac12 k x^2` does not speak of the time, be `x` given in terms of it.
            if !further.iter().all(|own| summands.contains(own)) {
                return Written::Unclear;
            }
            for name in further {
                let of_it = |given: &&Given| name_of(&given.of) == Some(&name);
                let mut formulas = self.formulas.iter().filter(of_it);
                let first = formulas.next();
                let Some(first) = first.filter(|own| formulas.all(|o| o.symbols == own.symbols))
                else {
                    return Written::Unclear;
                };
                symbols.remove(&name);
                summands.remove(&name);
                summands.retain(|own| !first.symbols.contains(own));
                let new = first.summands.iter();
                summands.extend(new.filter(|own| !symbols.contains(*own)).cloned());
                symbols.extend(first.symbols.iter().cloned());
            }
        }
        Written::Unclear
    }

    /// Whether what is written in some symbols is the same function of others, once what it names is put in.
    fn is_the_same(&self, own: &Set<Symbol>, others: &Set<Symbol>) -> bool {
        let is_named = |own: &Symbol| {
            let mut formulas = self.formulas.iter();
            formulas.any(|other| {
                name_of(&other.of) == Some(own)
                    && other.symbols.iter().all(|symbol| others.contains(symbol))
            })
        };
        let mut all = own.iter();
        all.all(|own| others.contains(own) || is_named(own))
    }

    /// The symbols of what stands under a derivative, where an equation says in them what that comes to.
    fn evaluated(
        &mut self,
        body: &Expr,
        variables: &[Symbol],
        others: &[&Expr],
    ) -> Option<Set<Symbol>> {
        let symbols = body.free_symbols();
        let is_in_these = |term: &&&Expr| {
            let own = term.free_symbols();
            !own.is_empty() && own.iter().all(|symbol| symbols.contains(symbol))
        };
        let written = others.iter().filter(|term| name_of(term).is_none());
        let says = written.clone().count() > 0 && written.clone().all(|term| is_in_these(&term));
        let explicit = variables.iter().all(|own| symbols.contains(own));
        let free = symbols.iter().all(|own| !self.dependent.contains(own));
        let leading: Vec<Set<Symbol>> = variables.iter().map(|own| self.leading_to(own)).collect();
        let depends =
            |own: &Symbol| self.moving.contains(own) || leading.iter().any(|all| all.contains(own));
        let mut carried = symbols.iter().filter(|own| !variables.contains(own));
        (says && explicit && free && !carried.any(depends)).then_some(symbols)
    }
}
