//! Differentials, `dU = T\,dS - p\,dV` and `\mathrm{d}(v^2) = 2 v\,\mathrm{d}v`: rates along any change, where each term of an equation has one
//! factor that is one. All else with them is refused: products with a number `d` they are not. Small changes, `\delta p`, have names.

mod along;
mod degree;
mod relative;
mod written;

use crate::algebra::{Expr, Formula, Symbol};
use crate::notation::{BeforeKind, Clause, Statement, SyntaxError};
use crate::sorted::Set;

use super::Equation;
use super::equation::{all_terms, first_goal};
use super::page::Page;

/// What is written for a differential.
const SIGNS: [&str; 3] = ["d", "\\text{d}", DELTA];
/// What is written for small changes: `\delta V` is a name, as `\Delta V` is.
const DELTA: &str = "\\delta";
/// How their names begin.
const SMALL: &str = "\\delta ";
/// So many in one display are no accident where the sign may be a number; an upright one is none.
const FEWEST: usize = 2;

/// Reads differentials outside of derivatives and integrals, in the equations of a page and in what is supposed on it, or refuses them.
///
/// A `d` that is a symbol (declared, or `spoken_of` by itself in the text), or stands anywhere but before what it would be the differential
/// of, is a symbol like others. Where one display shows that it is none, it is none in the others of the page either.
pub(super) fn read(page: &mut Page, equations: &mut [Equation], spoken_of: &Set<Symbol>) {
    let mut signs = Set::new();
    // A quantity `d` is the sign all the same where a slope that the page has is taken apart: `\phi \, d\phi = 2 \, dx`.
    let mut quantities = Vec::new();
    for d in SIGNS.map(Symbol::new) {
        let is_written = all_terms(page, equations).any(|term| written::has(term, &d));
        let is_declared = page.domains.contains_key(&d) || page.dimensions.contains_key(&d);
        if !is_written {
            continue;
        }
        let is_shown = || {
            let in_equations = equations
                .iter()
                .map(|own| Occurrences::of(own.statements(), &d));
            let supposed = page.locals.iter().map(|own| {
                let mut found = Occurrences::default();
                let terms = own.formulas.iter().flat_map(|formula| formula.terms());
                terms.for_each(|term| found.count(term, &d));
                found
            });
            let all: Vec<Occurrences> = in_equations.chain(supposed).collect();
            all.iter().all(|found| found.alone == 0) && all.iter().any(|found| found.show(&d))
        };
        match !is_declared && !spoken_of.contains(&d) && is_shown() {
            true => drop(signs.insert(d)),
            false => quantities.push(d),
        }
    }
    let slopes = match quantities.is_empty() {
        true => Set::new(),
        false => slopes(page, equations),
    };
    for equation in equations.iter_mut() {
        let Ok(statements) = &mut equation.statements else {
            continue;
        };
        statements.iter_mut().for_each(relative::read);
        let is_sign =
            |d: &&Symbol| takes_apart(statements, d, &slopes) || names_small_change(statements, d);
        let others: Vec<&Symbol> = quantities.iter().filter(is_sign).collect();
        let read = match others.is_empty() {
            true => written::read(statements, &signs),
            false => {
                let all = signs.iter().chain(others);
                written::read(statements, &all.cloned().collect())
            }
        };
        if let Err(error) = read {
            equation.statements = Err(error);
        }
    }
    for formula in page.locals.iter_mut().flat_map(|local| &mut local.formulas) {
        if let Some(read) = written::in_formula(formula, &signs) {
            *formula = read.into();
        }
    }
    along::follow(page, equations);
    let delta = Symbol::new(DELTA);
    if signs.contains(&delta) || quantities.contains(&delta) {
        let names = Formula::names_in(all_terms(page, equations)).into_iter();
        page.small = names.filter(|own| own.name().starts_with(SMALL)).collect();
    }
}

/// The slopes that a page has, by what is differentiated and what by.
fn slopes(page: &Page, equations: &[Equation]) -> Set<(Symbol, Symbol)> {
    fn collect(term: &Expr, found: &mut Set<(Symbol, Symbol)>) {
        if let Expr::Derivative { body, variable } = term
            && let Expr::Symbol(own) | Expr::Apply(own, _) = &**body
        {
            found.insert((own.clone(), variable.clone()));
        }
        (term.children()).for_each(|part| collect(part, found));
    }
    let mut found = Set::new();
    all_terms(page, equations).for_each(|term| collect(term, &mut found));
    found
}

/// Whether statements have the sign of small changes only before symbols, and name such a change or set it against what changes:
/// `\delta\nu = \frac{\Delta\nu}{F}`, `\frac{\lambda}{\delta\lambda} = m F`. Nobody says of a product what it is.
fn names_small_change(statements: &[Statement], d: &Symbol) -> bool {
    if d.name() != DELTA || Occurrences::of(statements, d).alone > 0 {
        return false;
    }
    let change = |term: &Expr| match term {
        Expr::Product(factors) => match &factors[..] {
            [Expr::Symbol(sign), Expr::Symbol(own)] if sign == d => Some(own.clone()),
            _ => None,
        },
        _ => None,
    };
    let is_of = |of: &Expr, change: Option<Symbol>| matches!((of, change), (Expr::Symbol(own), Some(changed)) if *own == changed);
    let is_relative = |part: &Expr| match part {
        Expr::Quotient(above, below) => is_of(above, change(below)) || is_of(below, change(above)),
        _ => false,
    };
    // `\delta (b + c)` is a product.
    let stands_otherwise = |part: &Expr| match part {
        Expr::Product(factors) => (0..factors.len()).any(|at| {
            let is_sign = matches!(&factors[at], Expr::Symbol(own) if own == d);
            is_sign && !matches!(factors.get(at + 1), Some(Expr::Symbol(_)))
        }),
        _ => false,
    };
    let first = statements.iter().filter_map(first_goal);
    let mut named = first.filter_map(|own| own.formula.as_equation().map(|own| own.0.clone()));
    let terms = || statements.iter().flat_map(super::equation::terms);
    !terms().any(|term| term.any(&stands_otherwise))
        && (named.any(|own| change(&own).is_some()) || terms().any(|term| term.any(&is_relative)))
}

/// Whether statements have a letter only before what one of some slopes is a slope of, and by.
fn takes_apart(statements: &[Statement], d: &Symbol, slopes: &Set<(Symbol, Symbol)>) -> bool {
    fn collect(term: &Expr, d: &Symbol, found: &mut Set<Symbol>) {
        if let Expr::Product(factors) = term {
            for pair in factors.windows(2) {
                if let [Expr::Symbol(sign), Expr::Symbol(own)] = pair
                    && sign == d
                {
                    found.insert(own.clone());
                }
            }
        }
        (term.children()).for_each(|part| collect(part, d, found));
    }
    let found = Occurrences::of(statements, d);
    if found.alone > 0 || !found.show(d) {
        return false;
    }
    let mut names = Set::new();
    let terms = statements.iter().flat_map(super::equation::terms);
    terms.for_each(|term| collect(term, d, &mut names));
    let is_taken_apart =
        |(of, by): &(Symbol, Symbol)| names.len() == 2 && names.contains(of) && names.contains(by);
    slopes.iter().any(is_taken_apart)
}

/// Why statements that stand together in the text cannot be read as they are, if they show differentials.
pub(super) fn shown(
    statements: &[Statement],
    is_symbol: impl Fn(&Symbol) -> bool,
) -> Option<SyntaxError> {
    SIGNS.map(Symbol::new).iter().find_map(|d| {
        let found = Occurrences::of(statements, d);
        match !is_symbol(d) && found.alone == 0 && found.show(d) {
            true => {
                let signs = Set::from([d.clone()]);
                written::read(&mut statements.to_vec(), &signs).err()
            }
            false => None,
        }
    })
}

fn refusal(statement: &Statement, sign: &Symbol) -> SyntaxError {
    SyntaxError {
        span: statement.span,
        message: "these differentials are not understood".to_owned(),
        help: Some(format!(
            "write one in each term, `dU = T\\,dS`, a derivative, `\\frac{{d}}{{dt}}`, or an integral; where `{sign}` is a number, say `symbols {sign}: …`"
        )),
    }
}

/// Where a symbol stands that may be the sign of differentials.
#[derive(Default)]
struct Occurrences {
    /// Before a name, a power of one or a parenthesis.
    differentials: usize,
    /// Elsewhere, but for before a function: `d\ln p` and `d\sin\theta` show nothing.
    alone: usize,
}

impl Occurrences {
    fn of(statements: &[Statement], d: &Symbol) -> Self {
        let mut found = Occurrences::default();
        let clauses = statements.iter().flat_map(|own| &own.clauses);
        let sides = clauses.flat_map(|clause| match clause {
            Clause::Chain { sides, .. } => sides.as_slice(),
            Clause::AllEqual { value, .. } => value.as_slice(),
        });
        for side in sides {
            found.count(&side.expr, d);
        }
        // A parenthesis does not show in the term: `d \cdot (a + b)` is the same product, and is one.
        let groups = statements.iter().map(|own| groups(own, d)).sum::<usize>();
        let groups = groups.min(found.alone);
        found.alone -= groups;
        found.differentials += groups;
        found
    }

    /// Whether a display shows by these that the sign is one of differentials.
    fn show(&self, d: &Symbol) -> bool {
        let fewest = if is_upright(d) { 1 } else { FEWEST };
        self.differentials >= fewest
    }

    fn count(&mut self, term: &Expr, d: &Symbol) {
        if let Expr::Symbol(own) = term {
            self.alone += usize::from(own == d);
        }
        let children: Vec<&Expr> = term.children().collect();
        for (at, child) in children.iter().enumerate() {
            let is_factor = matches!(term, Expr::Product(_));
            let next = children.get(at + 1).filter(|_| is_factor);
            let follows = next.is_some_and(|next| is_name(next));
            match child {
                child if follows && is_sign(child, d) => self.differentials += 1,
                Expr::Symbol(own) if own == d && matches!(next, Some(Expr::Call(..))) => {}
                // `d(u v)/dt` is read as `(d(u v)/d) t`.
                Expr::Quotient(over, under) if follows && is_sign(under, d) => {
                    self.differentials += 1;
                    self.count(over, d);
                }
                child => self.count(child, d),
            }
        }
        // An upright `\mathrm{d}(v)` is no function.
        if let Expr::Apply(own, _) = term
            && own == d
        {
            match is_upright(d) {
                true => self.differentials += 1,
                false => self.alone += 1,
            }
        }
    }
}

/// How often a statement has a sign right before a parenthesis.
fn groups(statement: &Statement, d: &Symbol) -> usize {
    let before = statement.before.iter().filter(|own| {
        let is_factor = matches!(own.kind, BeforeKind::Factor | BeforeKind::Product);
        is_factor && own.name == *d
    });
    before.count()
}

/// Whether a factor is the sign, or a second one, `\mathrm{d}^2 x`.
fn is_sign(factor: &Expr, d: &Symbol) -> bool {
    match factor {
        Expr::Symbol(own) => own == d,
        Expr::Power(base, _) => is_upright(d) && matches!(&**base, Expr::Symbol(own) if own == d),
        _ => false,
    }
}

/// Whether a factor is a name, or a power of one: `ds^2 = dx^2 + dy^2`.
fn is_name(factor: &Expr) -> bool {
    match factor {
        Expr::Power(base, _) => is_name(base),
        factor => matches!(factor, Expr::Symbol(_) | Expr::Apply(..)),
    }
}

fn is_upright(d: &Symbol) -> bool {
    d.name() == "\\text{d}"
}
