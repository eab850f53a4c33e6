//! What is known of sums over elements: counts and even power sums, and what equal elements make of them.

use std::sync::Arc;

use super::super::{Claim, Reject, Sign};
use super::{Origin, Problem};
use crate::algebra::{Atom, Expr, Formula, Polynomial, Symbol, expr_of, power_sum};
use crate::sorted::Set;

impl Problem {
    /// Counts and even power sums are not negative; equal elements make every power sum a multiple of one power.
    pub(super) fn add_facts_about_sums(&mut self, claim: &Claim) -> Result<(), Reject> {
        let of_sums = |atom: &Atom| matches!(atom, Atom::PowerSum { .. } | Atom::Element { .. });
        let all_equal = |own: &(Arc<Formula>, _)| matches!(*own.0, Formula::AllEqual { .. });
        // Most claims have nothing of the kind.
        if !self.atoms.iter().any(|(_, atom)| of_sums(atom)) && !self.formulas.iter().any(all_equal)
        {
            return Ok(());
        }
        let sums: Set<(Symbol, Vec<(Symbol, u32)>)> = self
            .atoms
            .iter()
            .filter_map(|(_, atom)| match atom {
                Atom::PowerSum { to, powers } => Some((to.clone(), powers.clone())),
                _ => None,
            })
            .collect();
        let counts: Set<&Symbol> = sums.iter().map(|(to, _)| to).collect();
        let sequences: Set<&Symbol> = sums
            .iter()
            .flat_map(|(_, p)| p.iter().map(|x| &x.0))
            .collect();
        // The sums that Lagrange's identity for these elements speaks of.
        for &count in &counts {
            self.atoms.var(Atom::Symbol(count.clone()));
            for &a in &sequences {
                self.atoms.var(power_sum(count, vec![(a.clone(), 1)]));
                self.atoms.var(power_sum(count, vec![(a.clone(), 2)]));
                for &b in sequences
                    .range::<&Symbol>((std::ops::Bound::Excluded(a), std::ops::Bound::Unbounded))
                {
                    self.atoms
                        .var(power_sum(count, vec![(a.clone(), 1), (b.clone(), 1)]));
                }
            }
        }
        let all: Vec<_> = self.atoms.iter().map(|(v, a)| (v, a.clone())).collect();
        let sums = all.iter().filter_map(|(_, atom)| match atom {
            Atom::PowerSum { to, powers } => Some((to.clone(), powers.clone())),
            _ => None,
        });
        let sums: Set<(Symbol, Vec<(Symbol, u32)>)> = sums.collect();
        for (var, atom) in all {
            match atom {
                Atom::PowerSum { powers, .. } if powers.iter().all(|p| p.1 % 2 == 0) => {
                    self.add(Polynomial::var(var), Sign::NonNegative, Origin::Sums);
                }
                Atom::Element { sequence, .. } => {
                    let domain = claim.sequences.get(&sequence).cloned().unwrap_or_default();
                    let term = expr_of(&Polynomial::var(var), &self.atoms);
                    self.confine(&term, &domain, &Origin::Domain(sequence))?;
                }
                _ => {}
            }
        }
        for position in 0..self.formulas.len() {
            if let Formula::AllEqual {
                sequence,
                to: Expr::Symbol(to),
                value,
            } = &*self.formulas[position].0.clone()
            {
                self.equal_elements(position, sequence, to, value.as_ref(), &sums)?;
            }
        }
        Ok(())
    }

    fn equal_elements(
        &mut self,
        position: usize,
        sequence: &Symbol,
        count: &Symbol,
        value: Option<&Expr>,
        sums: &Set<(Symbol, Vec<(Symbol, u32)>)>,
    ) -> Result<(), Reject> {
        let common = match value {
            Some(value) => {
                let mut lowering = self.lowering();
                let common = lowering.lower(value)?;
                // A limit with something held constant: see `assume`.
                if !(lowering.conditions.zero.is_empty() && lowering.conditions.away.is_empty()) {
                    return Ok(());
                }
                common
            }
            None => {
                let first = Atom::Element {
                    sequence: sequence.clone(),
                    position: 1,
                };
                Polynomial::var(self.atoms.var(first)).into()
            }
        };
        let Some(common) = common.as_polynomial() else {
            return Ok(());
        };
        let number = Polynomial::var(self.atoms.var(Atom::Symbol(count.clone())));
        for (to, powers) in sums {
            if let (true, [(own, exponent)]) = (to == count, powers.as_slice())
                && own == sequence
            {
                let sum = Polynomial::var(self.atoms.var(power_sum(to, powers.clone())));
                let multiple = number.times(&common.pow(*exponent)?)?;
                self.add(
                    sum.minus(&multiple),
                    Sign::Zero,
                    Origin::Hypothesis(position),
                );
            }
        }
        Ok(())
    }
}
