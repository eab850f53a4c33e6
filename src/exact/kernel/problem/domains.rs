//! What is declared of symbols, as facts.

use super::super::{Claim, Domain, Reject, Sign};
use super::formulas::compared;
use super::{Origin, Problem};
use crate::algebra::{Atom, BigRational, Expr, Polynomial, Rational, Symbol, element_symbol};
use crate::sorted::{self, Set};

impl Problem {
    /// Assumes of every symbol what is declared of it, and that a sum goes up to a natural number; of what `values` were put in for,
    /// it is said of these.
    pub(super) fn assume_domains(
        &mut self,
        claim: &Claim,
        named: &[&Symbol],
        counts: &Set<Symbol>,
        values: &[(Symbol, Expr)],
    ) -> Result<(), Reject> {
        let natural = Domain {
            lower: Some((BigRational::from_integer(0.into()), false)),
            integer: true,
            ..Domain::default()
        };
        let mut every = named.to_vec();
        every.extend(counts);
        sorted::sort(&mut every);
        every.dedup();
        for symbol in every {
            let (declared, counted) = (claim.domains.get(symbol), counts.contains(symbol));
            if declared.is_none() && !counted {
                continue;
            }
            let own = Expr::Symbol(symbol.clone());
            let term = values
                .iter()
                .find(|v| v.0 == *symbol)
                .map_or(&own, |v| &v.1);
            // A sum up to something that is not a natural number is no sum.
            let counted = counted.then_some((&natural, Origin::Sums));
            let declared = declared.map(|d| (d, Origin::Domain(symbol.clone())));
            for (domain, origin) in declared.into_iter().chain(counted) {
                self.confine(term, domain, &origin)?;
                if domain.integer {
                    let value = self.lowering().lower(term)?;
                    self.integers.push(value);
                }
            }
        }
        Ok(())
    }

    /// The same of symbols that no formula names.
    pub(super) fn confine_unnamed(
        &mut self,
        claim: &Claim,
        named: &[&Symbol],
    ) -> Result<(), Reject> {
        // Elements of sums that were written out are named nowhere else.
        let atoms = self.atoms.iter().filter_map(|(_, atom)| match atom {
            Atom::Symbol(symbol) => Some(symbol.clone()),
            Atom::Element { sequence, position } => Some(element_symbol(sequence, *position)),
            _ => None,
        });
        let unnamed: Vec<Symbol> = atoms
            .filter(|symbol| named.binary_search(&symbol).is_err())
            .collect();
        for symbol in unnamed {
            if let Some(domain) = claim.domains.get(&symbol) {
                let term = Expr::Symbol(symbol.clone());
                self.confine(&term, domain, &Origin::Domain(symbol))?;
            }
        }
        Ok(())
    }

    /// A root is read only of what is declared to be positive.
    pub(super) fn add_signs_of_roots(&mut self) {
        let roots = self.atoms.iter().filter_map(|(var, atom)| match atom {
            Atom::Root { of, .. } => Some((var, of.clone())),
            _ => None,
        });
        for (var, of) in roots.collect::<Vec<_>>() {
            self.add(Polynomial::var(var), Sign::Positive, Origin::Domain(of));
        }
    }

    /// Assumes that a term lies in a domain; that it is an integer is not among the facts.
    pub(super) fn confine(
        &mut self,
        term: &Expr,
        domain: &Domain,
        origin: &Origin,
    ) -> Result<(), Reject> {
        let mut bounds = domain.bounds().peekable();
        if bounds.peek().is_none() {
            return Ok(());
        }
        let mut lowering = self.lowering();
        let value = lowering.lower(term)?;
        let conditions = lowering.conditions;
        for (relation, bound) in bounds {
            let fact = compared(value.clone(), relation, Rational::from(bound).into())?;
            self.take(fact, conditions.clone(), origin);
        }
        Ok(())
    }
}
