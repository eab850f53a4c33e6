use std::cmp::Ordering;

use num_traits::Zero;

use super::super::{Claim, Domain, Reject};
use super::product::Reader;
use super::rows::{Clocks, held, mentions, sides};
use super::{Product, Situations, Size};
use crate::algebra::{BigRational, Expr, Formula, Rational, Relation, Symbol};
use crate::sorted::Map;

/// Checks that every premise is true in both situations, and that the sides of the goal change differently.
///
/// Whatever depends on a variable of integration stands still in both: then each integral is its integrand
/// times its length, and every curve is a stretched copy of every other.
pub(super) fn check(claim: &Claim, candidate: &Situations) -> Result<(), Reject> {
    let (left, right) = sides(&claim.goal).ok_or(Reject::UnsupportedRelation)?;
    let clocks = Clocks::of(claim);
    // A thing that stands still has no slope, and its clock is not spoken of.
    let moving = clocks.integrals() && (clocks.slopes || clocks.variable_is_free(claim));
    if moving || !claim.sequences.is_empty() {
        return Err(Reject::NoValue);
    }
    let mut both = Both {
        claim,
        values: &candidate.values,
        reader: Reader::new(claim),
    };
    both.values_make_sense()?;
    let aside = both.set_aside(&candidate.aside)?;
    both.domains(&aside)?;
    for (position, hypothesis) in claim.hypotheses.iter().enumerate() {
        if !candidate.aside.contains(&position) && !both.is_true(&hypothesis.formula)? {
            return Err(Reject::PremiseFalse(position));
        }
    }
    for quantity in held(claim) {
        if candidate.values.contains_key(&quantity) && !both.growth_of(&quantity)?.is_one()? {
            return Err(Reject::OutsideDomain);
        }
    }
    let growth = both.growth(left)?.over(&both.growth(right)?);
    match growth.is_one()? {
        true => Err(Reject::GoalNotFalse),
        false => Ok(()),
    }
}

/// By how much a term grows from the first situation to the second.
pub(super) fn growth(claim: &Claim, at: &Situations, term: &Expr) -> Result<Size, Reject> {
    let mut both = Both {
        claim,
        values: &at.values,
        reader: Reader::new(claim),
    };
    both.growth(term)
}

struct Both<'a> {
    claim: &'a Claim,
    values: &'a Map<Expr, (Size, Size)>,
    reader: Reader,
}

impl Both<'_> {
    /// Only symbols and applications have values; these are positive, π is π, and a function has one value for
    /// the same arguments.
    fn values_make_sense(&self) -> Result<(), Reject> {
        let pi = Expr::symbol("\\pi");
        for (quantity, (first, second)) in self.values {
            let plain = matches!(quantity, Expr::Symbol(_) | Expr::Apply(..));
            if !plain || !first.is_positive() || !second.is_positive() {
                return Err(Reject::OutsideDomain);
            }
            let is_pi = |size: &Size| size.powers.is_empty() && size.pi.is_one();
            let number = *quantity == pi && held(self.claim).contains(&pi);
            if number && !(is_pi(first) && is_pi(second)) {
                return Err(Reject::OutsideDomain);
            }
        }
        let applied: Vec<(&Symbol, &[Expr], &(Size, Size))> = self
            .values
            .iter()
            .filter_map(|(quantity, sizes)| match quantity {
                Expr::Apply(name, arguments) => Some((name, &**arguments, sizes)),
                _ => None,
            })
            .collect();
        for (at, (name, own, (first, second))) in applied.iter().enumerate() {
            for (other, others, (third, fourth)) in &applied[at + 1..] {
                if name != other || own.len() != others.len() {
                    continue;
                }
                for (a, b, pick) in [(first, third, 0), (second, fourth, 1)] {
                    let same = |(x, y): (&Expr, &Expr)| -> Result<bool, Reject> {
                        if x == y {
                            return Ok(true);
                        }
                        let of = |e: &Expr| {
                            let sizes = self.values.get(e).ok_or(Reject::NoValue)?;
                            Ok::<_, Reject>(if pick == 0 { &sizes.0 } else { &sizes.1 })
                        };
                        of(x)?.over(of(y)?).is_one()
                    };
                    let pairs: Result<Vec<bool>, Reject> =
                        own.iter().zip(others.iter()).map(same).collect();
                    if pairs?.into_iter().all(|same| same) && !a.over(b).is_one()? {
                        return Err(Reject::NoValue);
                    }
                }
            }
        }
        Ok(())
    }

    /// The symbols of quantities that only their own equation speaks of: it has a solution in any situation.
    fn set_aside(&mut self, positions: &[usize]) -> Result<Vec<Symbol>, Reject> {
        let mut symbols = Vec::new();
        let mut gone: Vec<usize> = Vec::new();
        for &position in positions {
            let no = || Reject::NotSetAside(position);
            let hypothesis = self.claim.hypotheses.get(position).ok_or_else(no)?;
            let Formula::Relation {
                left,
                relation: Relation::Equal,
                right,
            } = &*hypothesis.formula
            else {
                return Err(no());
            };
            let (symbol, applied, right) = match (left, right) {
                (Expr::Symbol(symbol), term) | (term, Expr::Symbol(symbol)) => {
                    (symbol, false, term)
                }
                (Expr::Apply(symbol, _), term) | (term, Expr::Apply(symbol, _)) => {
                    (symbol, true, term)
                }
                _ => return Err(no()),
            };
            gone.push(position);
            let all = self.claim.hypotheses.iter().enumerate();
            let rest = all.filter(|(at, _)| !gone.contains(at));
            let mut elsewhere = rest.map(|(_, h)| &*h.formula).chain([&self.claim.goal]);
            if right.mentions(symbol) || elsewhere.any(|f| mentions(f, symbol)) {
                return Err(no());
            }
            let (defined, positive) = self.reader.is_positive_by_sight(right)?;
            let domain = self.claim.domains.get(symbol).filter(|_| !applied);
            let fits = match domain {
                None => defined,
                Some(domain) => defined && (is_free(domain) || positive && is_half(domain)),
            };
            // A function of its arguments alone may be asked for two values.
            if !fits
                || applied
                    && self
                        .values
                        .keys()
                        .any(|q| matches!(q, Expr::Apply(name, _) if name == symbol))
            {
                return Err(no());
            }
            symbols.push(symbol.clone());
        }
        Ok(symbols)
    }

    fn domains(&self, aside: &[Symbol]) -> Result<(), Reject> {
        for symbol in self.claim.free_symbols() {
            if aside.contains(symbol) {
                continue;
            }
            let own = Expr::Symbol(symbol.clone());
            let domain = self.claim.domains.get(symbol);
            match (self.values.get(&own), domain) {
                (Some((first, second)), Some(domain)) => {
                    if !lies_in(first, domain)? || !lies_in(second, domain)? {
                        return Err(Reject::OutsideDomain);
                    }
                }
                (Some(_), None) => {}
                // Nothing is asked of it, so it may have any value.
                (None, None) => {}
                (None, Some(domain)) if is_free(domain) || is_half(domain) => {}
                (None, Some(_)) => return Err(Reject::NoValue),
            }
        }
        Ok(())
    }

    fn is_true(&mut self, formula: &Formula) -> Result<bool, Reject> {
        let Formula::Relation {
            left,
            relation,
            right,
        } = formula
        else {
            return Err(Reject::NoValue);
        };
        if matches!(relation, Relation::Scales | Relation::Proportional) {
            return self.growth(left)?.over(&self.growth(right)?).is_one();
        }
        for pick in [0, 1] {
            let order = match self.products_compared(left, right, pick) {
                Ok(order) => order,
                Err(_) => {
                    let (left, right) = (self.number(left, pick)?, self.number(right, pick)?);
                    left.cmp(&right)
                }
            };
            let fits = match relation {
                Relation::Equal => order.is_eq(),
                Relation::NotEqual => order.is_ne(),
                Relation::Less => order.is_lt(),
                Relation::LessOrEqual => order.is_le(),
                Relation::Greater => order.is_gt(),
                Relation::GreaterOrEqual => order.is_ge(),
                _ => return Err(Reject::NoValue),
            };
            if !fits {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// How two products compare in one of the situations.
    fn products_compared(
        &mut self,
        left: &Expr,
        right: &Expr,
        pick: usize,
    ) -> Result<Ordering, Reject> {
        if self.reader.constant(right)?.is_some_and(|c| c.is_zero()) {
            let product = self.reader.read(left)?;
            let mut quantities = product.exponents.keys();
            return match quantities.all(|q| self.values.contains_key(q)) {
                true if product.negative => Ok(Ordering::Less),
                true => Ok(Ordering::Greater),
                false => Err(Reject::NoValue),
            };
        }
        let (left, right) = (self.reader.read(left)?, self.reader.read(right)?);
        if left.slope || right.slope {
            return Err(Reject::NoValue);
        }
        let ratio = left.over(&right);
        let signs = (left.negative, right.negative);
        let mut value = ratio.number.clone();
        for (quantity, exponent) in &ratio.exponents {
            let size = match self.values.get(quantity) {
                Some(sizes) => if pick == 0 { &sizes.0 } else { &sizes.1 }.clone(),
                None => {
                    let number = self.number(quantity, pick)?;
                    let positive = Some(number).filter(Rational::is_positive);
                    Size::from(positive.ok_or(Reject::NoValue)?)
                }
            };
            value = value.times(&size, exponent);
        }
        let order = match value.is_one()? {
            true => Ordering::Equal,
            false if value.pi.is_zero() => value.against_one()?,
            false => return Err(Reject::NoValue),
        };
        Ok(match signs {
            (false, false) => order,
            (true, true) => order.reverse(),
            (true, false) => Ordering::Less,
            (false, true) => Ordering::Greater,
        })
    }

    /// The rational value of a term in one of the situations.
    fn number(&mut self, term: &Expr, pick: usize) -> Result<Rational, Reject> {
        let numbered = self.numbered(term, pick)?;
        self.reader.constant(&numbered)?.ok_or(Reject::NoValue)
    }

    /// A term with numbers for its quantities.
    fn numbered(&self, term: &Expr, pick: usize) -> Result<Expr, Reject> {
        match term {
            Expr::Number(_) => return Ok(term.clone()),
            Expr::Symbol(_) | Expr::Apply(..) => {
                let sizes = self.values.get(term).ok_or(Reject::NoValue)?;
                let size = if pick == 0 { &sizes.0 } else { &sizes.1 };
                let value = size.as_rational()?.ok_or(Reject::NoValue)?;
                return Ok(Expr::Number(value.to_big()));
            }
            Expr::Sum(_)
            | Expr::Product(_)
            | Expr::Negate(_)
            | Expr::Quotient(..)
            | Expr::Power(..) => {}
            _ => return Err(Reject::NoValue),
        }
        let mut failed = None;
        let result = term.map_children(|child| match self.numbered(child, pick) {
            Ok(child) => child,
            Err(reject) => {
                failed = Some(reject);
                child.clone()
            }
        });
        match failed {
            Some(reject) => Err(reject),
            None => Ok(result),
        }
    }

    fn growth(&mut self, term: &Expr) -> Result<Size, Reject> {
        let Product { exponents, .. } = self.reader.read(term)?;
        let mut growth = Size::one();
        for (quantity, exponent) in &exponents {
            growth = growth.times(&self.growth_of(quantity)?, exponent);
        }
        Ok(growth)
    }

    fn growth_of(&mut self, quantity: &Expr) -> Result<Size, Reject> {
        if let Some((first, second)) = self.values.get(quantity) {
            return Ok(second.over(first));
        }
        // What is made of unchanged quantities has not changed.
        let unchanged = |symbol: &Symbol| -> Result<bool, Reject> {
            match self.values.get(&Expr::Symbol(symbol.clone())) {
                Some((first, second)) => second.over(first).is_one(),
                None => Ok(false),
            }
        };
        let free = quantity.free_symbols();
        let still: Result<Vec<bool>, Reject> = free.iter().map(unchanged).collect();
        let plain =
            !matches!(quantity, Expr::Symbol(_) | Expr::Apply(..)) && !has_unknowns(quantity);
        if plain && still?.into_iter().all(|still| still) {
            return Ok(Size::one());
        }
        let (first, second) = (self.number(quantity, 0)?, self.number(quantity, 1)?);
        let ratio = match first.is_zero() || second.is_zero() {
            true => return Err(Reject::NoValue),
            false => second / first,
        };
        match ratio.is_positive() {
            true => Ok(Size::from(ratio)),
            false => Err(Reject::NoValue),
        }
    }
}

/// Whether an unknown function is applied in a term, or something varies under a binder.
fn has_unknowns(term: &Expr) -> bool {
    term.any(&|part| {
        matches!(
            part,
            Expr::Apply(..) | Expr::Derivative { .. } | Expr::Partial { .. }
        )
    })
}

/// Any real number, 0 perhaps excluded.
fn is_free(domain: &Domain) -> bool {
    domain.lower.is_none() && domain.upper.is_none() && !domain.nonzero && !domain.integer
}

/// All positive numbers, at least.
fn is_half(domain: &Domain) -> bool {
    let below = |(bound, _): &(BigRational, bool)| bound <= &BigRational::zero();
    domain.lower.as_ref().is_none_or(below) && domain.upper.is_none() && !domain.integer
}

fn lies_in(size: &Size, domain: &Domain) -> Result<bool, Reject> {
    if is_half(domain) {
        return Ok(true);
    }
    if let Some(value) = size.as_rational()? {
        return Ok(domain.contains(&value.to_big()));
    }
    if domain.integer {
        return Ok(false);
    }
    let against = |bound: &BigRational| -> Result<Ordering, Reject> {
        let bound = Rational::from(bound);
        match bound.is_positive() {
            true => size.over(&Size::from(bound)).against_one(),
            false => Ok(Ordering::Greater),
        }
    };
    // An irrational number equals no bound.
    let above = match &domain.lower {
        Some((bound, _)) => against(bound)?.is_gt(),
        None => true,
    };
    let below = match &domain.upper {
        Some((bound, _)) => against(bound)?.is_lt(),
        None => true,
    };
    Ok(above && below)
}
