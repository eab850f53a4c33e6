//! Relations between logarithms that are false, though no side has a rational value anywhere: `t = \frac{\ln 3}{k}` where
//! `e^{k t} = 2`, `\ln 3 < \ln 2`, or `\ln (a + b) = \ln a + b`, at some numbers.

use super::{Consistency, Decision, Effort, consistency_posed, prove_posed, prove_unconditionally};
use crate::algebra::{Atom, BigRational, Expr, Formula, Function, Symbol};
use crate::kernel::{Assignment, Claim, Hypothesis, Obligation, Refuted, Standing, definition};
use crate::sorted::{self, Map, Set};

/// What is put in for symbols, beginning at one place after another: so many points are tried.
const NUMBERS: [i64; 7] = [1, 2, 3, 5, 1, 7, 4];
const MOST_POINTS: usize = 7;
/// No more definitions are put in: what is defined by what is defined grows.
const MOST_PUT_IN: usize = 8;

/// Refutes a relation where logarithms are spoken of: the opposite is proved, and a point is found at which the hypotheses are true.
pub(super) fn decide(obligation: &Obligation, hints: &[Assignment]) -> Option<Decision> {
    let is_logarithm = |part: &Expr| matches!(part, Expr::Call(Function::Ln, _));
    // `\sqrt{\frac{1}{12} - \frac{1}{2 \pi^2}}`
    let pi = Symbol::new("\\pi");
    let is_of_pi = |part: &Expr| part.is_root() && part.mentions(&pi);
    let mut terms = obligation.claim().formulas().flat_map(Formula::terms);
    let is_written = terms.any(|term| term.any(&|part| is_logarithm(part) || is_of_pi(part)));
    // Of exponentials logarithms are taken, and beside `x` that of `x` is known nowhere but at 0: `\frac{x}{e^x - 1} = \frac{x}{e^x + 1}`.
    let is_transcendental =
        |own: &Expr| is_logarithm(own) || matches!(own, Expr::Call(Function::Exp, _));
    let mut atoms = obligation.problem().atoms.iter();
    let is_one = |own: &Atom| matches!(own, Atom::Opaque(own) if is_transcendental(own));
    if !is_written && !atoms.any(|(_, atom)| is_one(atom)) {
        return None;
    }
    let mut claim = obligation.claim().clone();
    claim.goal = claim.goal.denied()?;
    let throughout = || {
        let opposite = prove_unconditionally(claim.clone(), Effort::Full)?;
        let premises = Obligation::of_premises(claim.clone(), obligation.unfold().to_vec()).ok()?;
        let Consistency::Model(model) = consistency_posed(&premises, hints) else {
            return None;
        };
        let refuted = obligation.refuted_by_opposite(&opposite.proven, model.point().clone());
        refuted.ok()
    };
    let somewhere = || is_written.then(|| at_numbers(obligation, &claim)).flatten();
    throughout().or_else(somewhere).map(Decision::Refuted)
}

/// Refutes a relation by its opposite where all symbols are numbers but those that the hypotheses define by others.
fn at_numbers(obligation: &Obligation, opposite: &Claim) -> Option<Refuted> {
    let mut put_in: Map<Symbol, (usize, Expr)> = Map::new();
    for (at, own) in opposite.hypotheses.iter().enumerate() {
        if let Some((symbol, term)) = definition(&own.formula)
            && !put_in.contains_key(&symbol)
            && put_in.len() < MOST_PUT_IN
            && !comes_back_to(&symbol, &term, &put_in)
        {
            put_in.insert(symbol, (at, term));
        }
    }
    let mut unfold: Vec<usize> = put_in.values().map(|own| own.0).collect();
    sorted::sort(&mut unfold);
    let premises = Obligation::of_premises(opposite.clone(), unfold.clone()).ok()?;
    let named = opposite.free_symbols().into_iter();
    let is_open = |own: &&Symbol| {
        own.name() != "\\pi" && !put_in.contains_key(*own) && !opposite.sequences.contains_key(*own)
    };
    let open: Vec<Symbol> = named.filter(is_open).cloned().collect();
    let is_exponent = |own: &Symbol| {
        let raised =
            |part: &Expr| matches!(part, Expr::Call(Function::Exp, of) if of.mentions(own));
        let mut terms = opposite.formulas().flat_map(Formula::terms);
        terms.any(|term| term.any(&raised))
    };
    let exponents: Set<&Symbol> = open.iter().filter(|own| is_exponent(own)).collect();
    let turned: Set<&Symbol> = open
        .iter()
        .filter(|own| only_turned(opposite, own))
        .collect();
    (0..MOST_POINTS).find_map(|turn| {
        let numbers = NUMBERS.iter().cycle().skip(turn);
        let symbols = open.iter().zip(numbers);
        let symbols = symbols.map(|(own, &number)| {
            let number = if turned.contains(own) { 0 } else { number };
            (own.clone(), BigRational::from_integer(number.into()))
        });
        let point = Assignment {
            symbols: symbols.collect(),
            unfold: unfold.clone(),
            ..Assignment::default()
        };
        premises.model(point.clone()).ok()?;
        let mut there = opposite.clone();
        let said = |(own, number): (&Symbol, &BigRational)| Hypothesis {
            formula: Formula::number(own.clone(), number.clone()).into(),
            standing: Standing::AtPoint,
        };
        there.hypotheses.extend(point.symbols.iter().map(said));
        // `\ln(e^{-t})` is known to be `-t`; of what a number makes of it nothing is.
        let named = point.symbols.keys().zip(opposite.hypotheses.len()..);
        let plain = named.filter(|(own, _)| !exponents.contains(own));
        let plain = plain.map(|(_, at)| at);
        let all = unfold.iter().copied().chain(plain).collect();
        let there = Obligation::new(there, all).ok()?;
        let proven = prove_posed(&there, Effort::Full)?.proven;
        obligation.refuted_by_opposite(&proven, point).ok()
    })
}

/// Whether of a symbol nothing but cosines is spoken of: of these one is known at a number, `\cos 0`.
fn only_turned(claim: &Claim, symbol: &Symbol) -> bool {
    fn is_bare(term: &Expr, symbol: &Symbol) -> bool {
        match term {
            Expr::Symbol(own) => own == symbol,
            Expr::Call(Function::Cos, _) => false,
            _ => term.binder() == Some(symbol) || term.children().any(|own| is_bare(own, symbol)),
        }
    }
    let mut terms = claim.formulas().flat_map(Formula::terms);
    !terms.any(|term| is_bare(term, symbol))
}

/// Whether what a term is made of, with what that is defined by, speaks of a symbol.
fn comes_back_to(symbol: &Symbol, term: &Expr, put_in: &Map<Symbol, (usize, Expr)>) -> bool {
    let (mut open, mut seen) = (vec![term], Set::new());
    while let Some(term) = open.pop() {
        for own in term.free_symbols() {
            if own == *symbol {
                return true;
            }
            if let Some((_, term)) = put_in.get(&own)
                && seen.insert(own)
            {
                open.push(term);
            }
        }
    }
    false
}
