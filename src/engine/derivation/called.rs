//! What prose calls a function, an operator or a four-vector: "where $f$ and $g$ are arbitrary functions", "the operator $\hat H$".
//!
//! `f(x - v t)` is then no product, in `\hat H \psi` the order matters, and `P^2` may vanish where `P` does not. Nothing else is drawn from
//! such words, so where they are misunderstood a product is refused, and no more.

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::{Inline, Prose, Span};
use crate::notation::{Clause, SyntaxError, read_symbol};
use crate::sorted::Set;

use super::Equation;
use super::equation::terms;
use super::supposed::Local;

const FUNCTIONS: [&str; 2] = ["function", "functions"];
const OPERATORS: [&str; 2] = ["operator", "operators"];
const VECTORS: [&str; 10] = [
    "four-vector",
    "four-vectors",
    "four-momentum",
    "four-momenta",
    "four-velocity",
    "four-velocities",
    "4-vector",
    "4-vectors",
    "4-momentum",
    "4-momenta",
];
/// Between names that are called the same.
const JOINING: [&str; 5] = ["and", "or", ",", ", and", ", or"];
/// Functions that nothing is multiplied by, whatever else they are called beside: "With $\Phi$ the standard normal distribution function".
const APPLIED: [&str; 5] = ["distribution", "error", "gamma", "step", "characteristic"];
/// After names these say what they are.
const LINKING: [&str; 7] = ["is", "are", "be", "being", "denotes", "denote", "as"];
/// Such are functions, and no quantities: "$v$ is a known function of $t$" says what `v` depends on.
const ANY: [&str; 3] = ["any", "arbitrary", "some"];
/// So many words may stand there.
const MOST_BETWEEN: usize = 5;

/// The symbols that prose calls so.
#[derive(Default)]
pub(super) struct Called {
    pub functions: Set<Symbol>,
    pub operators: Set<Symbol>,
    pub vectors: Set<Symbol>,
}

impl Called {
    pub(super) fn of<'a>(source: &str, all: impl Iterator<Item = &'a Prose>) -> Called {
        let mut called = Called::default();
        for prose in all {
            let text = source.get(prose.span.range()).unwrap_or("");
            // Most prose speaks of none.
            let parts = ["unction", "perator", "four-", "Four-", "4-"];
            if parts.iter().any(|part| text.contains(part)) {
                called.look(source, prose);
            }
        }
        called
    }

    fn look(&mut self, source: &str, prose: &Prose) {
        let between = |from: usize, to: usize| source.get(from..to).unwrap_or("").trim();
        let mut start = prose.span.start;
        let mut names: Vec<&Inline> = Vec::new();
        let mut before = "";
        for (at, math) in prose.math.iter().enumerate() {
            let gap = between(start, math.span.start);
            if names.is_empty() || !JOINING.contains(&gap) {
                names.clear();
                before = gap;
            }
            names.push(math);
            start = math.span.end;
            let next = prose.math.get(at + 1);
            let after = between(start, next.map_or(prose.span.end, |next| next.span.start));
            if JOINING.contains(&after) && next.is_some() {
                continue;
            }
            let own = |words: &[&str]| ends_with(before, words) || are(after, words);
            let symbols = || names.iter().flat_map(|name| symbols(source, name.body));
            // "and $Q$, $Q'$ those of the electron"
            let mut spoken = after.split_whitespace();
            let goes_on = match spoken.next() {
                Some("those") => true,
                // "Write the four-momenta as $k$ for the photon, $p$ for the electron"
                Some("for") => !before.contains('.') && at > 0,
                _ => false,
            };
            let those = goes_on && !self.vectors.is_empty();
            match () {
                () if own(&OPERATORS) => self.operators.extend(symbols()),
                () if own(&FUNCTIONS) || beside(after) => self.functions.extend(symbols()),
                () if own(&VECTORS) || those => self.vectors.extend(symbols()),
                () => {}
            }
        }
    }
}

/// The symbols of a piece of mathematics that is nothing but names: `k, k'`.
fn symbols(source: &str, body: Span) -> Vec<Symbol> {
    let names = source.get(body.range()).unwrap_or_default().split(',');
    let read: Option<Vec<Symbol>> = names.map(|name| read_symbol(name.trim()).ok()).collect();
    read.unwrap_or_default()
}

/// Whether the last word of what stands before names is one of these: "the four-momenta $p$", "Write the four-momenta as $p$".
fn ends_with(before: &str, words: &[&str]) -> bool {
    let mut back = before.split_whitespace().rev();
    let last = back.next().and_then(|last| match last {
        "as" | "by" => back.next(),
        _ => Some(last),
    });
    last.is_some_and(|last| words.contains(&last.to_lowercase().as_str()))
}

/// Whether what stands after names begins with words that say that they are such: "are arbitrary functions".
fn are(after: &str, words: &[&str]) -> bool {
    let mut spoken = spoken_in_clause(after);
    if !spoken.next().is_some_and(|word| LINKING.contains(&word)) {
        return false;
    }
    let mut any = false;
    let mut spoken = spoken.take(MOST_BETWEEN + 1).peekable();
    while let Some(word) = spoken.next() {
        if words.contains(&word) {
            return any || words != FUNCTIONS || spoken.peek() != Some(&"of");
        }
        any |= ANY.contains(&word);
    }
    false
}

/// The words up to where a clause ends.
fn spoken_in_clause(after: &str) -> impl Iterator<Item = &str> {
    let clause = after.split([',', '.', ';', ':', '(']).next().unwrap_or("");
    clause.split_whitespace()
}

/// Whether what stands after names begins with words beside them that say that they are functions which are only applied.
fn beside(after: &str) -> bool {
    let spoken: Vec<&str> = spoken_in_clause(after).take(MOST_BETWEEN + 1).collect();
    let is_such = |pair: &[&str]| APPLIED.contains(&pair[0]) && FUNCTIONS.contains(&pair[1]);
    spoken.first() == Some(&"the") && spoken.windows(2).any(is_such)
}

/// Refuses the equations in which an operator is multiplied by what it acts on.
pub(super) fn refuse_products(equations: &mut [Equation], operators: &Set<Symbol>) {
    if operators.is_empty() {
        return;
    }
    for equation in equations {
        let statements = equation.statements().iter();
        let mut sides = statements
            .flat_map(|own| own.clauses.iter().chain(&own.under))
            .flat_map(|clause| match clause {
                Clause::Chain { sides, .. } => sides.as_slice(),
                Clause::AllEqual { value, .. } => value.as_slice(),
            });
        let found =
            sides.find_map(|side| Some((side.span, acting(&side.expr, operators)?.clone())));
        if let Some((span, name)) = found {
            equation.statements = Err(SyntaxError {
                span,
                message: format!(
                    "the text calls `{name}` an operator, so what stands after it is no factor"
                ),
                help: Some(
                    "the notation has no states and operators: write what comes of it".to_owned(),
                ),
            });
        }
    }
}

/// Whether a term multiplies what are called vectors, `P \cdot Q` and `P^2`: the rules of numbers do not hold of it.
fn multiplies(term: &Expr, vectors: &Set<Symbol>) -> bool {
    let speaks = |part: &Expr| !part.free_symbols().is_disjoint(vectors);
    term.any(&|part| match part {
        Expr::Product(factors) => factors.iter().filter(|own| speaks(own)).count() > 1,
        Expr::Power(base, _) => speaks(base),
        Expr::Quotient(_, below) => speaks(below),
        Expr::Call(_, inner) => speaks(inner),
        _ => false,
    })
}

/// Refuses the equations that multiply what the text calls vectors, and leaves out what it supposes of such products.
pub(super) fn refuse_products_of_vectors(
    equations: &mut [Equation],
    locals: &mut [Local],
    vectors: &Set<Symbol>,
) {
    if vectors.is_empty() {
        return;
    }
    for local in locals {
        let is_refused = |own: &Formula| own.terms().iter().any(|term| multiplies(term, vectors));
        local.formulas.retain(|own| !is_refused(own));
    }
    for equation in equations {
        let all = equation.statements().iter().flat_map(terms);
        if all.into_iter().any(|term| multiplies(term, vectors)) {
            equation.statements = Err(SyntaxError {
                span: equation.body,
                message:
                    "the text calls factors in it four-vectors, and their products do not obey \
                          the rules of numbers"
                        .to_owned(),
                help: Some("write it in components, or give the products names".to_owned()),
            });
        }
    }
}

/// The operator after which something other than a number stands in a product.
fn acting<'a>(term: &'a Expr, operators: &Set<Symbol>) -> Option<&'a Symbol> {
    if let Expr::Product(factors) = term {
        for pair in factors.windows(2) {
            let operator = match &pair[0] {
                Expr::Power(base, _) => &**base,
                factor => factor,
            };
            if let Expr::Symbol(name) = operator
                && operators.contains(name)
                && !matches!(pair[1], Expr::Number(_))
            {
                return Some(name);
            }
        }
    }
    term.children().find_map(|part| acting(part, operators))
}
