//! Names that are one thing here and another there: a function in `f(x)` and a factor in `f(x + 1)`, a unit in
//! `5\,\mathrm{m}` and a symbol in `\mathrm{m} v`.

use std::collections::BTreeSet;

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::{Inline, Span};
use crate::notation::{
    Before, BeforeKind, Clause, Statement, SyntaxError, has_units, is_degrees, is_figures,
    names_a_place, read_expr, read_symbol,
};

use super::called::Called;
use super::{Equation, formulas, slopes};
use crate::sorted::{Map, Set, Tree};

/// No function that a text speaks of is written longer: `\tilde{\theta}_{\mathrm{out}}(t)`.
const MOST_SPOKEN: usize = 40;
/// The accents for one dot, two and three.
const DOTS: [&str; 3] = ["\\dot{", "\\ddot{", "\\dddot{"];

/// `x` of `\dot{x}`.
pub(super) fn undotted(name: &Symbol) -> Option<Symbol> {
    below(name, DOTS[0])
}

/// What stands below the dots of a name, and how many they are: `x_1` and 2 of `\ddot{x}_1`.
pub(crate) fn without_dots(name: &Symbol) -> Option<(Symbol, u8)> {
    let mut dots = DOTS.iter().zip(1..);
    dots.find_map(|(accent, count)| Some((below(name, accent)?, count)))
}

/// A name with a dot, or with two: `\dot{x}_1` of `x_1`.
pub(crate) fn dotted(name: &Symbol, twice: bool) -> Symbol {
    let text = name.name();
    let mut depth = 0_usize;
    let stem = text.find(|c| {
        match c {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && matches!(c, '_' | '^' | '\'')
    });
    let (stem, scripts) = text.split_at(stem.unwrap_or(text.len()));
    Symbol::new(format!("{}{stem}}}{scripts}", DOTS[usize::from(twice)]))
}

/// What is below an accent, with the scripts that the name has beside it.
fn below(name: &Symbol, accent: &str) -> Option<Symbol> {
    let inside = name.name().strip_prefix(accent)?;
    let mut depth = 1_usize;
    let end = inside.find(|c| {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        depth == 0
    })?;
    let (stem, scripts) = (&inside[..end], &inside[end + 1..]);
    let is_script = scripts.is_empty() || scripts.starts_with(['_', '^', '\'']);
    is_script.then(|| Symbol::new(format!("{stem}{scripts}")))
}

/// What the text of a page names as functions: "Let $f(x) = x^2$", "the function $f$".
pub(super) fn functions_in_text<'a>(
    source: &str,
    inline: impl Iterator<Item = &'a Inline>,
) -> BTreeSet<Symbol> {
    let named = inline.filter_map(|math| {
        let text = source.get(math.body.range())?;
        let said = text.split('=').next().unwrap_or(text);
        let before = source.get(..math.span.start)?.trim_end();
        match said.contains('(') {
            true => match read_expr(said, Span::new(0, said.len())).ok()? {
                Expr::Apply(name, arguments) => {
                    let plain = |own: &Expr| matches!(own, Expr::Symbol(_));
                    arguments.iter().all(plain).then_some(name)
                }
                _ => None,
            },
            false if before.ends_with("function") => read_symbol(said).ok(),
            false => None,
        }
    });
    named.collect()
}

/// What the functions that the text of a page speaks of are functions of, each of one symbol that varies: `x` where it says "let $w(x)$ be the
/// deflection". Not where it says so of several.
pub(super) fn arguments_in_text<'a>(
    source: &str,
    inline: impl Iterator<Item = &'a Inline>,
) -> Map<Symbol, Symbol> {
    let mut all: Tree<Symbol, Option<Symbol>> = Tree::new();
    for math in inline {
        let text = source.get(math.body.range()).unwrap_or_default();
        // Little else in a text is that short.
        if text.len() > MOST_SPOKEN || !text.ends_with(')') {
            continue;
        }
        let Ok(Expr::Apply(name, arguments)) = read_expr(text, Span::new(0, text.len())) else {
            continue;
        };
        let [Expr::Symbol(argument)] = &arguments[..] else {
            continue;
        };
        if names_a_place(argument) {
            continue;
        }
        let known = all.entry(name);
        let known = known.or_insert_with(|| Some(argument.clone()));
        if known.as_ref() != Some(argument) {
            *known = None;
        }
    }
    let of_one = |(name, argument): (Symbol, Option<Symbol>)| Some((name, argument?));
    all.into_entries().filter_map(of_one).collect()
}

/// What the text of a page names as functions, and what its words call functions or operators.
pub(super) fn named_in_text<'a>(
    source: &str,
    inline: impl Iterator<Item = &'a Inline>,
    called: &Called,
) -> BTreeSet<Symbol> {
    let mut named = functions_in_text(source, inline);
    named.extend(called.functions.iter().chain(&called.operators).cloned());
    named
}

/// The functions that displays of a page define, where something on it may be the value of one at another place: it is read again then.
/// What the text has by itself is a quantity.
pub(super) fn in_question(equations: &[Equation], spoken_of: &Set<Symbol>) -> BTreeSet<Symbol> {
    let statements = || equations.iter().flat_map(|equation| equation.statements());
    let before = || statements().flat_map(|statement| &statement.before);
    let mut factors = before().filter(|before| before.kind == BeforeKind::Factor);
    let is_unread = |own: &Equation| own.statements.is_err();
    if factors.next().is_none() && !equations.iter().any(is_unread) {
        return BTreeSet::new();
    }
    let mut defined = defined(equations, |_| true);
    defined.retain(|own| !spoken_of.contains(own));
    defined
}

/// The functions that displays of a page give by a term in all of their arguments, if these are as is asked.
fn defined(equations: &[Equation], is_asked: impl Fn(&[Expr]) -> bool) -> BTreeSet<Symbol> {
    let statements = equations.iter().flat_map(|equation| equation.statements());
    let said = statements.flat_map(formulas);
    let name = |own: Formula| match own.as_equation()? {
        (Expr::Apply(name, arguments), value) => {
            let moves = |own: &Expr| matches!(own, Expr::Symbol(own) if value.mentions(own));
            let is_so = arguments.iter().all(moves) && !value.mentions(name) && is_asked(arguments);
            is_so.then(|| name.clone())
        }
        _ => None,
    };
    said.filter_map(name).collect()
}

/// The functions of one symbol that displays of a page define, which may be applied elsewhere to what is read as a factor: `v(L/2)` beside
/// `v(x)`, though the page has `v` by itself, too. So may those that only the text writes with what they are functions of. And those that stand
/// raised in what was not read, `w^2(z)`.
pub(super) fn with_values<'a>(
    equations: &[Equation],
    source: &str,
    inline: impl Iterator<Item = &'a Inline>,
) -> BTreeSet<Symbol> {
    let statements = equations.iter().flat_map(|equation| equation.statements());
    let before = statements.flat_map(|statement| &statement.before);
    let factors = before.filter(|before| before.kind == BeforeKind::Factor);
    let factors: Set<&Symbol> = factors.map(|before| &before.name).collect();
    let unread = equations.iter().filter(|own| own.statements.is_err());
    let unread = unread.filter_map(|own| source.get(own.body.range()));
    let unread: Vec<&str> = unread.filter(|text| text.contains('^')).collect();
    if factors.is_empty() && unread.is_empty() {
        return BTreeSet::new();
    }
    let mut found = defined(equations, |arguments| arguments.len() == 1);
    let told = arguments_in_text(source, inline).into_iter();
    found.extend(told.map(|own| own.0).filter(|own| factors.contains(own)));
    found.retain(|own| {
        let raised = || format!("{own}^");
        factors.contains(own) || unread.iter().any(|text| text.contains(&raised()))
    });
    found
}

/// Which of these a page has as quantities, too: what stands in parentheses after them may be a factor.
pub(super) fn stand_alone(equations: &[Equation], names: &BTreeSet<Symbol>) -> BTreeSet<Symbol> {
    let statements = equations.iter().flat_map(|equation| equation.statements());
    let formulas = statements.flat_map(formulas);
    let mut found: BTreeSet<Symbol> = formulas.flat_map(|own| own.free_symbols()).collect();
    found.retain(|own| names.contains(own));
    found
}

/// Refuses the equations of a page in which a name is read as a factor before a parenthesis and elsewhere on the page as a function.
///
/// `f(x + 1)` is a product by itself ([docs/notation.md](../../docs/notation.md)). Where the page has `f(x)` too, it is the
/// value of a function at another place, and a product would be a misreading; not so `f (1 - f)`, for no argument holds its own function.
/// The value at a number, `x(0)`, is read of what the page has as a function.
/// What is read as a unit after a number is refused in the same way where the page has or declares a symbol of that name.
pub(super) fn refuse(
    equations: &mut [Equation],
    declared: impl Fn(&Symbol) -> bool,
    in_text: impl Fn() -> BTreeSet<Symbol>,
) {
    let all = || {
        let statements = equations.iter().flat_map(|equation| equation.statements());
        statements.flat_map(|statement| &statement.before)
    };
    let of = |kind: BeforeKind| -> BTreeSet<Symbol> {
        let all = all().filter(|before| before.kind == kind);
        all.map(|before| before.name.clone()).collect()
    };
    let mut functions = of(BeforeKind::Function);
    let factors = of(BeforeKind::Factor);
    if !factors.is_subset(&functions) {
        functions.extend(in_text().into_iter().filter(|own| factors.contains(own)));
    }
    let said = || -> Vec<Formula> {
        let statements = equations.iter().flat_map(|equation| equation.statements());
        statements.flat_map(formulas).collect()
    };
    let values = of(BeforeKind::Value);
    // `w(0)` of a law for `\frac{d^2 w}{dx^2}`.
    let moving = match values.is_empty() {
        true => Set::new(),
        false => Formula::differentiated_in(said().iter()),
    };
    let mut symbols = of(BeforeKind::Unit);
    if !symbols.is_empty() {
        let free: BTreeSet<Symbol> = said().iter().flat_map(Formula::free_symbols).collect();
        symbols.retain(|name| declared(name) || free.contains(name));
    }
    let angles = of(BeforeKind::Degrees);
    let angles: BTreeSet<Symbol> = angles.into_iter().filter(|name| declared(name)).collect();
    let multiplied = of(BeforeKind::Quantity);
    let all = [
        &functions,
        &factors,
        &symbols,
        &angles,
        &values,
        &multiplied,
    ];
    if all.into_iter().all(BTreeSet::is_empty) {
        return;
    }
    // "f''(2)" where the page has $f(x)$
    let is_slope = |name: &Symbol| slopes::base(name).is_some_and(|own| functions.contains(&own.0));
    let has_values = |name: &Symbol| {
        let moves = || slopes::base(name).is_some_and(|own| moving.contains(&own.0));
        functions.contains(name) || is_slope(name) || moving.contains(name) || moves()
    };
    for equation in equations {
        let mut before = equation.statements().iter().flat_map(|s| &s.before);
        let doubtful = before.find(|before| match before.kind {
            BeforeKind::Function | BeforeKind::Product => false,
            BeforeKind::Value => !has_values(&before.name),
            BeforeKind::Factor => {
                let primed = before.name.name().contains('\'') && is_slope(&before.name);
                functions.contains(&before.name)
                    || primed
                    || is_told_there(equation.statements(), before)
            }
            BeforeKind::Quantity => {
                functions.contains(&before.name)
                    || !stands_by_itself(equation.statements(), &before.name)
            }
            BeforeKind::Unit => symbols.contains(&before.name),
            BeforeKind::Degrees => angles.contains(&before.name),
        });
        let Some(Before { name, span, kind }) = doubtful.cloned() else {
            continue;
        };
        let (message, help) = match kind {
            BeforeKind::Factor if !functions.contains(&name) && !name.name().contains('\'') => {
                no_value(&name)
            }
            BeforeKind::Unit => (
                format!(
                    "whether `{name}` is a unit here, or the symbol of that name, is not clear"
                ),
                "write `\\qty{…}{…}` for a quantity, or `\\cdot` before a symbol".to_owned(),
            ),
            BeforeKind::Value => no_value(&name),
            BeforeKind::Quantity => (
                format!(
                    "whether `{name}` is applied to what follows, or multiplied by it, is not clear"
                ),
                format!(
                    "for a product write `{name} \\cdot (…)`; functions are read as `f(x)`, of bare symbols"
                ),
            ),
            BeforeKind::Degrees => (
                format!(
                    "degrees are read with the number `{name}`, which the page declares to be something else"
                ),
                "write the angle in radians".to_owned(),
            ),
            _ => (
                format!("whether the function `{name}` is applied here, or a factor, is not clear"),
                format!(
                    "for a product write `{name} \\cdot (…)`; other arguments than bare symbols are read of a function that a display defines and that stands nowhere without one"
                ),
            ),
        };
        equation.statements = Err(SyntaxError {
            span,
            message,
            help: Some(help),
        });
    }
}

/// Why a name before a number in parentheses is not read, and what to write.
fn no_value(name: &Symbol) -> (String, String) {
    (
        format!("this may be the value of a function `{name}` at a number, or a product"),
        format!(
            "for a product write `\\cdot` before the parenthesis; values are read of what the page has as a function, as `{name}(t)`"
        ),
    )
}

/// Whether a name before a quantity in parentheses is all that a statement begins with: `\delta(50\,\mathrm{Hz}) = 9.35\,\mathrm{mm}` tells what
/// `\delta` is there, and so does `E'(180^\circ) = 184\,\mathrm{keV}`.
fn is_told_there(statements: &[Statement], before: &Before) -> bool {
    let is_told = |clause: &Clause| match clause {
        Clause::Chain { sides, .. } => {
            let side = &sides[0];
            let is_figure = |own: &Expr| {
                matches!(own, Expr::Symbol(own) if *own == before.name) || is_figures(own)
            };
            let is_measured = || has_units(&side.expr) || side.expr.any(&is_degrees);
            side.span == before.span && is_measured() && side.expr.children().all(is_figure)
        }
        Clause::AllEqual { .. } => false,
    };
    statements.iter().flat_map(|own| &own.clauses).any(is_told)
}

/// Whether a name stands in statements elsewhere than before what it might be applied to.
fn stands_by_itself(statements: &[Statement], name: &Symbol) -> bool {
    fn count(term: &Expr, name: &Symbol) -> usize {
        let own = matches!(term, Expr::Symbol(own) if own == name);
        usize::from(own) + term.children().map(|part| count(part, name)).sum::<usize>()
    }
    let all: Vec<Formula> = statements.iter().flat_map(formulas).collect();
    let terms = all.iter().flat_map(Formula::terms);
    let found: usize = terms.map(|term| count(term, name)).sum();
    let before = statements.iter().flat_map(|own| &own.before);
    let before = before.filter(|own| own.kind == BeforeKind::Quantity && own.name == *name);
    found > before.count()
}
