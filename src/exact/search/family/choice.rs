//! Which count runs, and what the others are in terms of it.

use std::rc::Rc;

use num_traits::Zero;

use super::is_natural;
use crate::algebra::{BigRational, Expr, Formula, Symbol, Values};
use crate::kernel::{Assignment, Claim};
use crate::sorted::{self, Map, Set};

/// Claims about more counts are left alone.
const MOST_COUNTS: usize = 4;
/// How much more than the number that runs a count may be, the likeliest first.
const MORE: [i64; 4] = [0, 1, -1, 2];
/// The numbers at which relations between counts are looked at.
const SAMPLES: [i64; 2] = [50, 80];

/// A count that runs, and what the others are.
#[derive(Clone, Debug)]
pub(super) struct Choice {
    pub parameter: Symbol,
    others: Map<Symbol, Count>,
}

/// What a count is.
#[derive(Clone, Debug)]
enum Count {
    /// So much more than the number that runs.
    More(i64),
    Number(BigRational),
}

impl Count {
    fn term(&self, parameter: &Symbol, less: usize) -> Expr {
        let less = i64::try_from(less).unwrap_or(0);
        let running = Expr::Symbol(parameter.clone());
        match self {
            Count::More(more) if *more == less => running,
            Count::More(more) if *more > less => {
                Expr::Sum([running, Expr::integer(more - less)].into())
            }
            Count::More(more) => {
                let less = Expr::Negate(Expr::integer(less - more).into());
                Expr::Sum([running, less].into())
            }
            Count::Number(number) => Expr::Number(number - BigRational::from_integer(less.into())),
        }
    }
}

impl Choice {
    /// What the counts are that do not run.
    pub fn terms(&self) -> Map<Symbol, Expr> {
        let others = self.others.iter();
        others
            .map(|(symbol, count)| (symbol.clone(), count.term(&self.parameter, 0)))
            .collect()
    }

    /// The counts where one number is run through.
    fn at(&self, number: i64) -> Map<Symbol, BigRational> {
        let whole = |number: i64| BigRational::from_integer(number.into());
        let others = self.others.iter().map(|(symbol, count)| match count {
            Count::More(more) => (symbol.clone(), whole(number + more)),
            Count::Number(own) => (symbol.clone(), own.clone()),
        });
        others
            .chain([(self.parameter.clone(), whole(number))])
            .collect()
    }

    /// How many elements there are besides some.
    pub fn size_without(&self, count: &Symbol, apart: usize) -> Expr {
        let own = self.others.get(count);
        own.unwrap_or(&Count::More(0)).term(&self.parameter, apart)
    }
}

/// What is said of counts alone, in the premises and in the goal.
struct Relations<'a> {
    premises: Vec<&'a Formula>,
    goal: Option<&'a Formula>,
}

impl<'a> Relations<'a> {
    fn of(claim: &'a Claim, counts: &[Symbol]) -> Self {
        let of_counts = |formula: &&Formula| {
            let named = formula.names();
            !named.is_empty() && named.iter().all(|symbol| counts.contains(symbol))
        };
        let premises = claim.hypotheses.iter().map(|h| &*h.formula);
        Relations {
            premises: premises.filter(of_counts).collect(),
            goal: Some(&claim.goal).filter(of_counts),
        }
    }

    /// Whether none of them speaks against a choice.
    fn allow(&self, choice: &Choice) -> bool {
        SAMPLES.iter().all(|&sample| {
            let values = Values {
                symbols: choice.at(sample),
                ..Values::default()
            };
            let mut premises = self.premises.iter();
            self.goal.is_none_or(|goal| values.holds(goal) != Ok(true))
                && premises.all(|premise| values.holds(premise) != Ok(false))
        })
    }
}

/// The upper limit of all sums over elements, where it is one symbol.
pub(super) fn only_count(claim: &Claim) -> Option<Symbol> {
    if claim
        .formulas()
        .all(|formula| formula.sequences().is_empty())
    {
        return None;
    }
    let mut limits: Set<&Expr> = Set::new();
    for formula in claim.formulas() {
        if let Formula::AllEqual { to, .. } = formula {
            limits.insert(to);
        }
        let mut open = formula.terms();
        while let Some(term) = open.pop() {
            if let Expr::Series { to, .. } = term {
                limits.insert(to);
            }
            open.extend(term.children());
        }
    }
    let mut limits = limits.into_iter();
    match (limits.next(), limits.next()) {
        (Some(Expr::Symbol(count)), None) => Some(count.clone()),
        _ => None,
    }
}

/// Whether a symbol is declared to be a natural number.
pub(super) fn is_whole(claim: &Claim, symbol: &Symbol) -> bool {
    claim.domains.get(symbol).is_some_and(is_natural)
}

/// What the counts may be, the likeliest choice first: what is asked of runs rather than what is summed up to.
pub(super) fn choices<'a>(
    claim: &'a Claim,
    count: &Symbol,
    witness: &Assignment,
) -> impl Iterator<Item = Choice> + Clone + 'a {
    let counts = counts(claim, count);
    let mut all: Vec<(usize, Choice)> = Vec::new();
    for parameter in &counts {
        let others = counts.iter().filter(|other| *other != parameter);
        let choices = of_others(others, witness).into_iter();
        all.extend(choices.map(|(cost, others)| {
            let parameter = parameter.clone();
            (cost, Choice { parameter, others })
        }));
    }
    sorted::sort_by_key(&mut all, |(cost, _)| *cost);
    let relations = Rc::new(Relations::of(claim, &counts));
    let all = all.into_iter().map(|(_, choice)| choice);
    all.filter(move |choice| relations.allow(choice))
}

/// The counts, that first which is asked of; none where there are too many.
fn counts(claim: &Claim, count: &Symbol) -> Vec<Symbol> {
    let named = claim.free_symbols().into_iter();
    let mut counts: Vec<Symbol> = named.filter(|s| is_whole(claim, s)).cloned().collect();
    if !counts.contains(count) {
        counts.push(count.clone());
    }
    if counts.len() > MOST_COUNTS {
        return Vec::new();
    }
    let in_goal = claim.goal.free_symbols();
    let hypotheses = claim.hypotheses.iter();
    let equations = hypotheses.filter(|h| h.formula.as_equation().is_some());
    let in_equations: Set<Symbol> = equations.flat_map(|h| h.formula.free_symbols()).collect();
    sorted::sort_by_key(&mut counts, |s| {
        (s == count, !in_equations.contains(s), !in_goal.contains(s))
    });
    counts
}

/// What the counts may be that do not run, each with how unlikely that is.
fn of_others<'a>(
    others: impl Iterator<Item = &'a Symbol>,
    witness: &Assignment,
) -> Vec<(usize, Map<Symbol, Count>)> {
    let mut choices = vec![(0, Map::new())];
    for other in others {
        let more = MORE.iter().map(|&more| Count::More(more));
        let value = witness.symbols.get(other).filter(|value| !value.is_zero());
        let number = value.cloned().map(Count::Number);
        let each: Vec<(usize, Count)> = more.chain(number).enumerate().collect();
        let with = |(cost, chosen): (usize, Map<Symbol, Count>)| {
            let each = each.clone().into_iter();
            each.map(move |(own, count)| {
                let mut chosen = chosen.clone();
                chosen.insert(other.clone(), count);
                (cost + own, chosen)
            })
        };
        choices = choices.into_iter().flat_map(with).collect();
    }
    choices
}
