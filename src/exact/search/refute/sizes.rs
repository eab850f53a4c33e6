//! Numbers of elements: which are tried, what a claim is with definite ones, and what a point of that is in the claim's own terms.

use std::borrow::Cow;
use std::cell::{Cell, LazyCell};

use num_traits::Signed;

use crate::algebra::{BigRational, Expr, Formula, Symbol, Values, element_symbol};
use crate::kernel::{Assignment, Claim, Hypothesis, Standing, applied_definition, definition};
use crate::sorted::{self, Map, Set};

/// In place of a number of elements, an exponent of one half: that of what lies between 0 and 1.
const HALF: i64 = 0;
/// Sums over a symbolic number of elements are tried with up to this many.
pub(super) const MOST_ELEMENTS: i64 = 4;
/// The most terms that sums in one claim are written out to: sums in sums multiply.
const MOST_WRITTEN_OUT: usize = 4_000;

/// The symbols that say how many elements there are, and those in exponents: with a definite number in its place a power is a polynomial.
/// What varies below a derivative or an integral stays what it is.
pub fn count_symbols(claim: &Claim) -> Vec<Symbol> {
    // Few claims have a symbol in an exponent.
    let varying = LazyCell::new(|| {
        let mut varying = Set::new();
        for term in claim.formulas().flat_map(Formula::terms) {
            collect_varying(term, &mut varying);
        }
        varying
    });
    let is_definite = |symbol: &Symbol| match claim.domains.get(symbol) {
        Some(d) if d.integer => d.lower.as_ref().is_some_and(|lower| !lower.0.is_negative()),
        _ => !varying.contains(symbol) && symbol.name() != "\\pi",
    };
    fn collect(expr: &Expr, is_definite: &impl Fn(&Symbol) -> bool, found: &mut Set<Symbol>) {
        match expr {
            Expr::Series { to, .. } => found.extend(to.free_symbols()),
            // A sum without end has no number of terms.
            Expr::Limit { body, variable, .. } => {
                let mut within = Set::new();
                collect(body, is_definite, &mut within);
                within.remove(variable);
                found.extend(within);
                return;
            }
            Expr::Power(_, exponent) if !matches!(**exponent, Expr::Number(_)) => {
                found.extend(exponent.free_symbols().into_iter().filter(is_definite));
            }
            _ => {}
        }
        (expr.children()).for_each(|child| collect(child, is_definite, found));
    }
    let mut found = Set::new();
    for formula in claim.formulas() {
        formula
            .terms()
            .into_iter()
            .for_each(|term| collect(term, &is_definite, &mut found));
        if let Formula::AllEqual { to, .. } = formula {
            found.extend(to.free_symbols());
        }
    }
    found.into_iter().collect()
}

/// All that stands below a derivative, an integral or a limit, and what sums go over.
fn collect_varying(expr: &Expr, found: &mut Set<Symbol>) {
    if let Expr::Series { index, .. } = expr {
        found.insert(index.clone());
    } else if let Some(variable) = expr.binder() {
        found.insert(variable.clone());
        found.extend(expr.free_symbols());
    }
    (expr.children()).for_each(|child| collect_varying(child, found));
}

/// The number that a size stands for.
fn value_of(size: i64) -> BigRational {
    match size {
        HALF => BigRational::new(1.into(), 2.into()),
        size => BigRational::from_integer(size.into()),
    }
}

/// Whether hypotheses speak of all that the goal speaks of: what nothing is said of may be said in words that were not read.
fn is_told(claim: &Claim, counts: &[Symbol]) -> bool {
    let named = Formula::free_symbols_of(claim.hypotheses.iter().map(|own| &*own.formula));
    let goal = claim.goal.free_symbols();
    goal.iter()
        .all(|own| named.contains(&own) || counts.contains(own))
}

/// All choices of sizes, the smallest total first.
pub(super) fn sizes(counts: &[Symbol], claim: &Claim, against_goal: bool) -> Vec<Vec<i64>> {
    let mut all: Vec<Vec<i64>> = vec![Vec::new()];
    for count in counts {
        let fits = |n: &i64| {
            let domain = claim.domains.get(count);
            domain.is_none_or(|d| d.contains(&value_of(*n)))
        };
        let mut choices: Vec<i64> = (1..=MOST_ELEMENTS).filter(fits).collect();
        if choices.is_empty() && fits(&HALF) && (!against_goal || is_told(claim, counts)) {
            choices.push(HALF);
        }
        all = all
            .iter()
            .flat_map(|sizes| {
                choices
                    .iter()
                    .map(|&n| sizes.iter().copied().chain([n]).collect())
            })
            .take(256)
            .collect();
    }
    sorted::sort_by_key(&mut all, |sizes| (sizes.iter().sum::<i64>(), sizes.clone()));
    all
}

/// Drops the sizes at which a hypothesis about them alone is false, or the goal true.
pub(super) fn rule_out(
    sizes: &mut Vec<Vec<i64>>,
    counts: &[Symbol],
    claim: &Claim,
    against_goal: bool,
) {
    let about_sizes = |formula: &&Formula| {
        let Formula::Relation { left, right, .. } = formula else {
            return false;
        };
        let own = |term: &Expr| {
            matches!(term, Expr::Number(_)) || matches!(term, Expr::Symbol(s) if counts.contains(s))
        };
        own(left) && own(right)
    };
    let hypotheses = claim.hypotheses.iter().map(|h| &*h.formula);
    let hypotheses: Vec<&Formula> = hypotheses.filter(about_sizes).collect();
    let goal = Some(&claim.goal).filter(|goal| against_goal && about_sizes(goal));
    if hypotheses.is_empty() && goal.is_none() {
        return;
    }
    sizes.retain(|sizes| {
        let pairs = counts.iter().zip(sizes);
        let values = Values {
            symbols: pairs
                .map(|(count, &n)| (count.clone(), value_of(n)))
                .collect(),
            ..Values::default()
        };
        let mut hypotheses = hypotheses.iter();
        hypotheses.all(|formula| values.holds(formula) != Ok(false))
            && goal.is_none_or(|goal| values.holds(goal) != Ok(true))
    });
}

/// The claim with definite numbers of elements, each element a symbol of its own.
pub(super) fn at_sizes(claim: &Claim, counts: &[Symbol], sizes: &[i64]) -> Option<Claim> {
    let left = Cell::new(MOST_WRITTEN_OUT);
    let number = |expr: &Expr| {
        let sizes = counts.iter().zip(sizes);
        let at = sizes.fold(Cow::Borrowed(expr), |e, (count, &n)| {
            match e.mentions(count) {
                true => Cow::Owned(e.substitute(count, &Expr::Number(value_of(n)))),
                false => e,
            }
        });
        holding_elements(&without_series(&at, &left), claim)
    };
    let mut domains = claim.domains.clone();
    for (sequence, domain) in &claim.sequences {
        for position in 1..=MOST_ELEMENTS as u32 {
            domains.insert(element_symbol(sequence, position), domain.clone());
        }
    }
    let mut hypotheses = Vec::new();
    for hypothesis in &claim.hypotheses {
        for formula in written_out(hypothesis.formula.map_terms(number))? {
            let standing = hypothesis.standing;
            let formula = formula.into();
            hypotheses.push(Hypothesis { formula, standing });
        }
    }
    // With another exponent than a whole number only what is positive has a power.
    let mut bases = Vec::new();
    for term in claim.formulas().flat_map(Formula::terms) {
        collect_bases(term, claim, counts, &mut bases);
    }
    hypotheses.extend(bases.into_iter().map(|base| Hypothesis {
        formula: Formula::positive(number(base)).into(),
        standing: Standing::AtPoint,
    }));
    // The conclusion is one formula: Σ (aᵢ − bᵢ)² = 0.
    let mut goals = written_out(claim.goal.map_terms(number))?;
    if left.get() == 0 {
        return None;
    }
    let goal = match goals.len() {
        1 => goals.remove(0),
        _ => {
            let squares = goals.into_iter().map(|g| match g {
                Formula::Relation { left, right, .. } => {
                    let minus = Expr::Negate(right.into());
                    let difference = Expr::Sum([left, minus].into());
                    Expr::Power(difference.into(), Expr::integer(2).into())
                }
                Formula::AllEqual { .. } => Expr::integer(0),
            });
            Formula::equal(Expr::Sum(squares.collect()), Expr::integer(0))
        }
    };
    Some(Claim {
        domains,
        sequences: Map::new(),
        hypotheses,
        goal,
    })
}

/// What is raised to exponents that are given definite numbers and may be others than whole ones.
fn collect_bases<'a>(expr: &'a Expr, claim: &Claim, counts: &[Symbol], found: &mut Vec<&'a Expr>) {
    let is_real = |symbol: &Symbol| {
        counts.contains(symbol) && claim.domains.get(symbol).is_none_or(|d| !d.integer)
    };
    if let Expr::Power(base, exponent) = expr
        && exponent.free_symbols().iter().any(is_real)
        && !found.contains(&&**base)
    {
        found.push(base);
    }
    (expr.children()).for_each(|child| collect_bases(child, claim, counts, found));
}

/// Sums over a definite number of elements, written out while there are terms left to be written.
fn without_series(expr: &Expr, left: &Cell<usize>) -> Expr {
    // What has none in it is shared.
    if !expr.any(&|part| matches!(part, Expr::Series { .. })) {
        return expr.clone();
    }
    if let Expr::Series {
        index,
        from,
        to,
        body,
    } = expr
        && let (Expr::Number(from), Expr::Number(to)) = (&**from, &**to)
        && let (Ok(from), Ok(to)) = (
            u32::try_from(from.to_integer()),
            u32::try_from(to.to_integer()),
        )
        && to.saturating_sub(from) < 64
        && left.get() > 0
    {
        let written = (from..=to).map(|position| {
            left.set(left.get().saturating_sub(1));
            without_series(&body.at_index(index, position), left)
        });
        let mut terms: Vec<Expr> = written.collect();
        return match terms.len() {
            0 => Expr::integer(0),
            1 => terms.remove(0),
            _ => Expr::Sum(terms.into()),
        };
    }
    expr.map_children(|child| without_series(child, left))
}

/// A term in which the elements of a sequence are held fixed, each of them, where the sequence is.
fn holding_elements(expr: &Expr, claim: &Claim) -> Expr {
    let is_sequence = |symbol: &Symbol| claim.sequences.contains_key(symbol);
    if !expr.any(&|part| part.held().iter().any(is_sequence)) {
        return expr.clone();
    }
    let own = expr.map_children(|child| holding_elements(child, claim));
    match own {
        Expr::Partial {
            body,
            variable,
            held: Some(held),
        } => {
            let each = |symbol: &Symbol| match is_sequence(symbol) {
                true => {
                    let positions = 1..=MOST_ELEMENTS as u32;
                    positions.map(|at| element_symbol(symbol, at)).collect()
                }
                false => vec![symbol.clone()],
            };
            Expr::Partial {
                body,
                variable,
                held: Some(held.iter().flat_map(each).collect()),
            }
        }
        own => own,
    }
}

/// A statement about a definite number of elements as equations between them.
fn written_out(formula: Formula) -> Option<Vec<Formula>> {
    let Formula::AllEqual {
        sequence,
        to,
        value,
    } = &formula
    else {
        return Some(vec![formula]);
    };
    let Expr::Number(to) = to else {
        return None;
    };
    let to: u32 = to.to_integer().try_into().ok()?;
    if to as usize > MOST_WRITTEN_OUT {
        return None;
    }
    let element = |position| Expr::Symbol(element_symbol(sequence, position));
    let (first, from) = match value {
        Some(value) => (value.clone(), 1),
        None => (element(1), 2),
    };
    Some(
        (from..=to)
            .map(|position| Formula::equal(element(position), first.clone()))
            .collect(),
    )
}

/// The point in the claim's own terms: counts and sequences again. Elements in order along the line come first.
pub(super) fn restored(
    claim: &Claim,
    unfold: &[usize],
    counts: &[Symbol],
    sizes: &[i64],
    mut point: Assignment,
) -> Vec<Assignment> {
    if counts.is_empty() && claim.sequences.is_empty() {
        return vec![point];
    }
    for (count, &n) in counts.iter().zip(sizes) {
        point.symbols.insert(count.clone(), value_of(n));
    }
    let longest = sizes.iter().copied().max().unwrap_or(0) as u32;
    for sequence in claim.sequences.keys() {
        let mut elements = Vec::new();
        for position in 1..=MOST_ELEMENTS as u32 {
            let value = point.symbols.remove(&element_symbol(sequence, position));
            if position <= longest {
                elements.push(value.unwrap_or_else(|| BigRational::from_integer(1.into())));
            }
        }
        point.sequences.insert(sequence.clone(), elements);
    }
    // Hypotheses were renumbered where one was written out as several.
    point.unfold = unfold
        .iter()
        .copied()
        .filter(|&at| {
            let formula = &claim.hypotheses[at].formula;
            let is_count =
                |own: Option<(Symbol, Expr)>| own.is_none_or(|(s, _)| counts.contains(&s));
            applied_definition(formula).is_some() || !is_count(definition(formula))
        })
        .collect();
    let mut ordered = point.clone();
    ordered
        .sequences
        .values_mut()
        .for_each(|elements| elements.sort());
    vec![ordered, point]
}
