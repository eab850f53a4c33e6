//! Decimals before what has symbols in it: `d = R \left(\frac{2 p}{s}\right)^{1/3} = 1.26 R \left(\frac{p}{s}\right)^{1/3}`.
//!
//! Where all symbols cancel, both sides differ by a number, and the decimal is as near to it as it is printed. This is no proof.

use num_traits::{One, Signed, Zero};

use crate::algebra::{BigInt, BigRational, Expr, Formula, Relation};
use crate::derivation::{Assumed, Goal};
use crate::interval::Figures;
use crate::notation::{Precision, Rounding, is_figures};
use crate::sorted::{Map, Set};

use super::super::judge::Judge;
use super::super::{Auditor, Entry, Note, Verdict};
use super::decimals::{FEWEST_DIGITS, decimals};
use super::{Link, Numeric, Weighed, is_evaluable, likened};

/// Digits of what is rounded from no rational number.
const FEWEST_OF_IRRATIONAL: usize = 2;

/// What a link comes to whose right side is a decimal times what has symbols in it; nothing of others, or where the symbols do not cancel.
pub(super) fn weighed(goal: &Goal, source: &str, assumed: &[Assumed]) -> Option<Link> {
    let (left, relation, right) = likened(&goal.formula)?;
    let is_of_symbols = !is_figures(right) && is_evaluable(right);
    if !goal.is_said_outright() || !is_of_symbols {
        return None;
    }
    // What is near enough on both sides was rounded on both.
    let (one, other) = goal.sides;
    let share = |fewest: usize| {
        let text = [one, other].map(|side| source.get(side.range()).unwrap_or_default());
        let written = text.map(|text| decimals(text, fewest));
        printed_in(right, &written[1])?;
        let shares = written.iter().flat_map(|own| own.iter());
        let shares = shares.filter(|(number, _)| !number.is_zero());
        let shares = shares.map(|(number, half)| half / number.abs());
        Some(shares.fold(BigRational::zero(), |sum, own| sum + own))
    };
    let loosest = share(FEWEST_OF_IRRATIONAL)?;
    let given = || {
        let mut said = assumed.iter().filter_map(|own| own.formula.as_equation());
        said.find(|(of, value)| *of == left && is_evaluable(value))
    };
    let left = match left {
        Expr::Symbol(_) => given()?.1,
        left if is_evaluable(left) => left,
        _ => return None,
    };
    let free: Set<_> = [left, right]
        .into_iter()
        .flat_map(Expr::free_symbols)
        .collect();
    let ratio = Figures::default().but_free(&free).ratio(left, right).ok()?;
    let is_rational = ratio.low() == ratio.high();
    let near = match is_rational && relation == Relation::Equal {
        true => share(FEWEST_DIGITS)?,
        false => loosest,
    };
    let one = BigRational::one();
    let off = |times: i64| {
        let most = &near * BigRational::from_integer(times.into());
        *ratio.low() < &one - &most || *ratio.high() > &one + &most
    };
    // Who breaks digits off is wrong by one at most.
    let outcome = match (off(1), off(2)) {
        (false, _) => Weighed::Supported,
        (_, false) => Weighed::NotSettled,
        _ => Weighed::Contradicted,
    };
    let rounding = Some(Rounding {
        share: near.clone(),
        precision: Precision::Decimal,
    });
    Some(Link {
        goal: Goal {
            rounding,
            ..goal.clone()
        },
        sides: None,
        ratio: Some(ratio),
        near: Some(near),
        outcome,
    })
}

/// What a link that is wrong would say with the decimal that both sides differ by, in as many places.
fn nearest(link: &Link, source: &str) -> Option<Formula> {
    let Formula::Relation { right, .. } = &link.goal.formula else {
        return None;
    };
    let written = decimals(source.get(link.goal.sides.1.range())?, FEWEST_OF_IRRATIONAL);
    let (number, half) = printed_in(right, &written)?;
    let ratio = link.ratio.as_ref()?;
    let two = BigRational::from_integer(BigInt::from(2));
    let middle = (ratio.low() + ratio.high()) / &two;
    let step = half * &two;
    let near = (number * middle / &step).round() * step;
    let instead = right.replace(&Expr::Number(number.clone()), &Expr::Number(near));
    Some(link.goal.formula.map_terms(|term| match term == right {
        true => instead.clone(),
        false => term.clone(),
    }))
}

/// The factor of a product that is printed as one of some decimals, with half a unit of its last digit.
fn printed_in<'a>(
    term: &'a Expr,
    written: &'a Map<BigRational, BigRational>,
) -> Option<(&'a BigRational, &'a BigRational)> {
    let Expr::Product(factors) = term else {
        return None;
    };
    factors.iter().find_map(|own| match own {
        Expr::Number(number) => Some((number, written.get(number)?)),
        _ => None,
    })
}

impl Auditor<'_> {
    /// Tells of a decimal that is not what both sides differ by. What is refuted is so without it.
    pub(super) fn heed_coefficients(&self, judge: &Judge, wrong: Vec<Link>, entry: &mut Entry) {
        let is_of_name = |own: &Link| {
            let formula = &own.goal.formula;
            matches!(
                formula,
                Formula::Relation {
                    left: Expr::Symbol(_),
                    ..
                }
            )
        };
        if entry.verdict != Verdict::Undecided
            || judge.cites_loosely() && wrong.iter().any(is_of_name)
        {
            return;
        }
        let page = &self.derivation.pages[self.derivation.equations[judge.at].page];
        let source = &page.document.source;
        let nearest = wrong.first().and_then(|link| nearest(link, source));
        entry.notes.push(Note::NumericNotSupported);
        entry.numeric = Some(Box::new(Numeric {
            nearest,
            ..Numeric::of_links(wrong)
        }));
    }
}
