//! The ordinary claims that a claim about every index comes to.

use super::{ForEvery, Instance};
use crate::algebra::{Formula, Moved, Place, Symbol, expr_of};
use crate::kernel::{
    Claim, Domain, Fact, Hypothesis, Knowledge, Origin, Problem, Reject, Sign, Standing,
};
use crate::sorted::{Map, Set};

/// Where a hypothesis of a part comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PartOrigin {
    /// The hypothesis with this position, which says nothing of the index.
    Constant(usize),
    /// A hypothesis that is said of every index, at one of them.
    Instance(Instance),
    /// The goal itself, so far from the index: what an induction supposes.
    Supposed(u32),
}

impl ForEvery {
    /// The goal at an index, from all hypotheses that say nothing of it, some instances of those that are said of every
    /// index, and the goal itself at `n`, `n + 1`, … as often as is `supposed`.
    ///
    /// # Errors
    /// A hypothesis is not said of every index, or not of this one; something cannot be said of another index, or may
    /// depend on it without showing it.
    pub fn part(
        &self,
        goal: Moved,
        supposed: u32,
        instances: &[Instance],
    ) -> Result<(Claim, Vec<PartOrigin>), Reject> {
        let start = self.start()?;
        let varying = self.varying();
        let all = self.claim.hypotheses.iter().enumerate();
        let constant =
            all.filter(|(at, h)| self.is_constant(*at) && !speaks_of(&h.formula, &varying));
        let (mut origins, mut hypotheses): (Vec<PartOrigin>, Vec<Hypothesis>) = constant
            .map(|(at, own)| (PartOrigin::Constant(at), own.clone()))
            .unzip();
        for &instance in instances {
            hypotheses.push(self.instance(instance, start)?);
            origins.push(PartOrigin::Instance(instance));
        }
        let at = |to| self.elsewhere(&self.claim.goal, to, &varying);
        for ahead in 0..supposed {
            hypotheses.push(Hypothesis {
                formula: at(Moved::By(ahead))?.into(),
                standing: Standing::AtPoint,
            });
            origins.push(PartOrigin::Supposed(ahead));
        }
        let mut claim = Claim {
            domains: Map::new(),
            sequences: self.claim.sequences.clone(),
            hypotheses,
            goal: at(goal)?,
        };
        let symbols = claim.free_symbols().into_iter();
        let domains = symbols.filter_map(|s| Some((s.clone(), self.domain(s, start)?.clone())));
        claim.domains = domains.collect();
        Ok((claim, origins))
    }

    /// A hypothesis at an index.
    pub(super) fn instance(&self, instance: Instance, start: u32) -> Result<Hypothesis, Reject> {
        let Instance { hypothesis, at } = instance;
        let own = self.claim.hypotheses.get(hypothesis);
        let own = own.ok_or(Reject::NoSuchFact(hypothesis))?;
        if !self.throughout.contains(&hypothesis) {
            return Err(Reject::NotThroughout(hypothesis));
        }
        // Of numbers before the first the premise says nothing, nor of elements before that with number 0.
        let least = match at {
            Moved::To(number) if number < start => return Err(Reject::OutOfRange(hypothesis)),
            Moved::To(number) => number,
            Moved::By(ahead) => start + ahead,
        };
        if i64::from(least) + self.first_offset(&own.formula) < 0 {
            return Err(Reject::OutOfRange(hypothesis));
        }
        Ok(Hypothesis {
            formula: self.elsewhere(&own.formula, at, &self.varying())?.into(),
            standing: own.standing,
        })
    }

    /// A formula at another index.
    pub(super) fn elsewhere(
        &self,
        formula: &Formula,
        to: Moved,
        varying: &Set<Symbol>,
    ) -> Result<Formula, Reject> {
        let named = formula.free_symbols();
        let sequences = formula.sequences();
        if let Some(symbol) = named.union(&sequences).find(|s| varying.contains(*s)) {
            return Err(Reject::MayRun(symbol.clone()));
        }
        // An element that has a sum over all of its sequence beside it would be read in two ways.
        let doubly = |s: &Symbol| {
            let stem = s.place(&self.index).map(|(stem, _)| stem);
            stem.is_some_and(|stem| self.is_running(&stem) && self.is_summed(&stem))
        };
        if named.iter().any(doubly) {
            return Err(Reject::Unmovable);
        }
        formula.moved(&self.index, to).ok_or(Reject::Unmovable)
    }

    /// Symbols that may depend on the index: those that are said to, those of which a hypothesis speaks that is true
    /// for the index in question alone, and those that stand beside such a one.
    pub(super) fn varying(&self) -> Set<Symbol> {
        let mut varying = self.varying.clone();
        loop {
            let before = varying.len();
            for (at, hypothesis) in self.claim.hypotheses.iter().enumerate() {
                let formula = &hypothesis.formula;
                let here = match self.is_constant(at) {
                    true => speaks_of(formula, &varying),
                    false => !self.throughout.contains(&at),
                };
                if here {
                    varying.extend(self.plain(formula));
                }
            }
            if varying.len() == before {
                return varying;
            }
        }
    }

    /// The symbols and sequences of a formula that are neither constant nor elements.
    fn plain(&self, formula: &Formula) -> Set<Symbol> {
        let all = formula.names().into_iter();
        let plain = all.filter(|symbol| {
            let domain = self.claim.domains.get(symbol);
            let element = match symbol.place(&self.index) {
                Some((stem, Place::Number(_))) => self.is_running(&stem),
                place => place.is_some(),
            };
            !element && *symbol != self.index && !domain.is_some_and(|d| d.constant)
        });
        plain.collect()
    }

    /// The least offset from the index in a formula, or 0.
    fn first_offset(&self, formula: &Formula) -> i64 {
        let symbols = formula.free_symbols().into_iter();
        let offsets = symbols.filter_map(|s| match s.place(&self.index)?.1 {
            Place::Running(offset) => Some(offset),
            _ => None,
        });
        offsets.min().unwrap_or(0).min(0)
    }

    /// Whether elements of a sequence stand at the running index somewhere.
    pub fn is_running(&self, stem: &Symbol) -> bool {
        let symbols = Formula::free_symbols_of(self.claim.formulas());
        let mut places = symbols.iter().filter_map(|s| s.place(&self.index));
        places.any(|(own, place)| own == *stem && !matches!(place, Place::Number(_)))
    }

    fn is_summed(&self, stem: &Symbol) -> bool {
        let mentioned = || self.claim.formulas().any(|f| f.sequences().contains(stem));
        self.claim.sequences.contains_key(stem) || mentioned()
    }

    /// Where a symbol of a part may lie: elements as all elements in the range of the index do.
    fn domain(&self, symbol: &Symbol, start: u32) -> Option<&Domain> {
        let own = || self.claim.domains.get(symbol);
        match symbol.place(&self.index) {
            Some((stem, Place::Running(offset))) => {
                let of_all = self.elements.get(&stem).filter(|_| offset >= 0);
                // Only what is said of `E_{n+1}` itself is left.
                of_all.or_else(own).filter(|_| offset >= 0)
            }
            Some((stem, Place::Number(number))) => {
                let of_all = || self.elements.get(&stem).filter(|_| number >= start);
                own().or_else(of_all)
            }
            _ => own(),
        }
    }
}

/// Whether one of some symbols or sequences occurs.
fn speaks_of(formula: &Formula, symbols: &Set<Symbol>) -> bool {
    let named = formula.free_symbols();
    let sequences = formula.sequences();
    !symbols.is_empty() && named.union(&sequences).any(|s| symbols.contains(s))
}

/// Whether what a step supposes is seen to have a value without being supposed. That `a r^{n-1}` has one must not
/// be learnt from the supposition: at the first index it has, whatever `r` is.
pub(super) fn has_value(problem: &Problem, origins: &[PartOrigin]) -> Result<(), Reject> {
    let supposed = |origin: &Origin| match origin {
        Origin::Hypothesis(position) => {
            let own = origins.get(*position);
            matches!(own, Some(PartOrigin::Supposed(_))).then_some(*position)
        }
        _ => None,
    };
    let all = || problem.facts.iter().zip(&problem.origins);
    let others = all().filter(|(_, origin)| supposed(origin).is_none());
    let others: Vec<Fact> = others.map(|(fact, _)| fact.clone()).collect();
    let knowledge = Knowledge::new(&others);
    let mut stated = Set::new();
    for (fact, origin) in all() {
        let Some(position) = supposed(origin) else {
            continue;
        };
        // The first fact is what is said, those after it that it has a value.
        if stated.insert(position) {
            continue;
        }
        let seen = match fact.sign {
            Sign::Zero => false,
            Sign::NonZero => knowledge.is_nonzero(&fact.polynomial),
            Sign::NonNegative => knowledge.is_nonnegative(&fact.polynomial),
            Sign::Positive => knowledge.is_positive(&fact.polynomial),
        };
        if !seen {
            let term = expr_of(&fact.polynomial, &problem.atoms);
            return Err(Reject::MayHaveNoValue(term));
        }
    }
    Ok(())
}
