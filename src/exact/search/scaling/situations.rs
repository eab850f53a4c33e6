use num_integer::Integer;
use num_traits::{One, ToPrimitive, Zero};

use super::linear::{Echelon, Exponents};
use super::{breaks, preferred};
use crate::algebra::{BigInt, BigRational, Expr, Formula, Rational, Relation, Symbol};
use crate::kernel::{
    Claim, Domain, Product, Rows, ScalesNot, ScalingCandidate, ScalingVerdict, Situations, Size,
    check_scaling,
};
use crate::sorted::{Map, Set};

/// No factor is larger than 2 to this power.
const MOST_DOUBLINGS: u32 = 60;
/// How many rescalings are tried.
const MOST_RESCALINGS: usize = 12;

/// Two situations that the kernel accepts as a counterexample.
pub(super) fn refute(claim: &Claim, rows: &Rows) -> Option<ScalesNot> {
    let mut search = Search::new(claim, rows);
    let starts = if search.uneven.is_empty() { 1 } else { 3 };
    for start in 0..starts {
        search.start = start;
        let Some(first) = search.situation(None) else {
            continue;
        };
        // First with every sum kept in shape, then with sums computed.
        let found = search.rescaled(&first).or_else(|| search.computed(&first));
        if found.is_some() {
            return found;
        }
    }
    None
}

/// Whether the equations between products of powers have a solution in positive numbers, and there is nothing
/// else.
pub(super) fn is_possible(claim: &Claim) -> bool {
    let Ok(rows) = Rows::new(claim) else {
        return false;
    };
    let plain = |product: &Product| {
        let mut quantities = product.exponents.keys();
        quantities.all(is_plain) && !product.negative && !product.slope
    };
    let mut own = rows.rows.iter().take(claim.hypotheses.len());
    let all = own.all(|row| row.as_ref().is_some_and(|row| plain(&row.product)));
    let free = |d: &Domain| d.upper.is_none() && !d.integer;
    all && claim.domains.values().all(free) && exact(&rows, Vec::new()).is_some()
}

fn is_plain(quantity: &Expr) -> bool {
    matches!(quantity, Expr::Symbol(_) | Expr::Apply(..))
}

/// The equations between products of powers, solved for some quantities; `None` where they contradict one
/// another.
fn exact(rows: &Rows, late: Vec<Expr>) -> Option<Echelon> {
    let mut echelon = Echelon::new(late);
    // π is what it is: everything else is solved for.
    let pi = Expr::symbol("\\pi");
    if rows.held.contains(&pi) {
        let own = Exponents::from([(pi, Rational::one())]);
        echelon.insert(0, &own, &Size::pi());
    }
    for row in rows.rows.iter().flatten().filter(|row| row.exact) {
        let product = &row.product;
        if product.exponents.keys().all(is_plain) {
            let value = Size::one().over(&product.number);
            equate(&mut echelon, &product.exponents, &value)?;
        }
    }
    Some(echelon)
}

/// Adds a row; `None` where it contradicts those before it.
fn equate(echelon: &mut Echelon, row: &Exponents, value: &Size) -> Option<()> {
    match echelon.insert(0, row, value) {
        Some(known) => known.over(value).is_one().ok()?.then_some(()),
        None => Some(()),
    }
}

/// A situation that is to differ from another one, in which a quantity is multiplied by a factor.
struct Change<'a> {
    from: &'a Values,
    of: &'a Expr,
    factor: &'a Rational,
}

/// Quantities, and the sums of some, with their sizes.
type Values = Map<Expr, Size>;

struct Search<'a> {
    claim: &'a Claim,
    rows: &'a Rows,
    late: Vec<Expr>,
    aside: Vec<usize>,
    /// All symbols and applications that need a value.
    quantities: Set<Expr>,
    /// The sums among what the rows speak of.
    sums: Set<Expr>,
    /// What occurs in sums, or in premises that say nothing of exponents: it may have to differ.
    uneven: Set<Expr>,
    /// Which numbers are tried for these: all 1, or growing, or falling.
    start: usize,
}

impl<'a> Search<'a> {
    fn new(claim: &'a Claim, rows: &'a Rows) -> Search<'a> {
        let aside = set_aside(claim, rows);
        let mut quantities = Set::new();
        let hypotheses = claim.hypotheses.iter().enumerate();
        let kept = hypotheses.filter(|(at, _)| !aside.contains(at));
        for formula in kept.map(|(_, h)| &*h.formula).chain([&claim.goal]) {
            for term in formula.terms() {
                collect(term, &mut quantities);
            }
        }
        let own = rows.rows.iter().enumerate();
        let products = own
            .filter(|(at, _)| !aside.contains(at))
            .filter_map(|(_, row)| Some(&row.as_ref()?.product));
        let mut sums = Set::new();
        for product in products.chain([&rows.sides.0, &rows.sides.1]) {
            let sum = |q: &&Expr| matches!(q, Expr::Sum(_));
            sums.extend(product.exponents.keys().filter(sum).cloned());
            let plain = product.exponents.keys().filter(|q| is_plain(q));
            quantities.extend(plain.cloned());
        }
        let mut uneven = Set::new();
        sums.iter().for_each(|sum| collect(sum, &mut uneven));
        for (at, hypothesis) in claim.hypotheses.iter().enumerate() {
            let silent = rows.rows.get(at).is_some_and(Option::is_none);
            if silent && !aside.contains(&at) {
                let terms = hypothesis.formula.terms().into_iter();
                terms.for_each(|term| collect(term, &mut uneven));
            }
        }
        Search {
            claim,
            rows,
            late: preferred(rows, claim),
            aside,
            quantities,
            sums,
            uneven,
            start: 0,
        }
    }

    /// A situation with every equation true, as plain as it can be, or as near to another one.
    fn situation(&self, change: Option<&Change<'_>>) -> Option<Values> {
        let mut known = Values::new();
        for _ in 0..4 {
            let mut echelon = exact(self.rows, self.late.clone())?;
            for (sum, size) in &known {
                let own = Exponents::from([(sum.clone(), Rational::one())]);
                equate(&mut echelon, &own, size)?;
            }
            for (at, row) in self.rows.rows.iter().enumerate() {
                let Some(row) = row.as_ref().filter(|_| !self.aside.contains(&at)) else {
                    continue;
                };
                let product = &row.product;
                let ready = |q: &Expr| is_plain(q) || known.contains_key(q);
                if !product.exponents.keys().all(ready) {
                    continue;
                }
                let before = |values: &Values| -> Option<Size> {
                    let mut size = Size::one();
                    for (quantity, exponent) in &product.exponents {
                        size = size.times(values.get(quantity)?, exponent);
                    }
                    Some(size)
                };
                if row.exact {
                    let value = Size::one().over(&product.number);
                    equate(&mut echelon, &product.exponents, &value)?;
                } else if let Some(change) = change {
                    equate(&mut echelon, &product.exponents, &before(change.from)?)?;
                }
            }
            let free = self.quantities.iter().filter(|q| !echelon.is_pivot(q));
            let free = free.map(|quantity| {
                let size = match change {
                    None => self.plain_value(quantity),
                    Some(change) => {
                        let own = change.from.get(quantity).cloned().unwrap_or_default();
                        match quantity == change.of {
                            true => own.times(&Size::from(change.factor.clone()), &Rational::one()),
                            false => own,
                        }
                    }
                };
                (quantity.clone(), size)
            });
            let mut values = echelon.solve(&free.collect());
            values.retain(|q, _| self.quantities.contains(q));
            let mut sums = Values::new();
            for sum in &self.sums {
                let value = number(sum, &values).filter(Rational::is_positive);
                sums.extend(value.map(|value| (sum.clone(), Size::from(value))));
            }
            if sums == known {
                values.extend(sums);
                return Some(values);
            }
            known = sums;
        }
        None
    }

    /// Rescalings under which every sum stays in shape.
    fn rescaled(&self, first: &Values) -> Option<ScalesNot> {
        let mut echelon = Echelon::new(self.late.clone());
        let mut number = 0;
        let mut insert = |echelon: &mut Echelon, row: &Exponents| {
            echelon.insert(number, row, &Size::one());
            number += 1;
        };
        for quantity in &self.rows.held {
            let still = Exponents::from([(quantity.clone(), Rational::one())]);
            insert(&mut echelon, &still);
        }
        let kept = |at: &usize| !self.aside.contains(at);
        let rows = self.rows.rows.iter().enumerate();
        let mut products: Vec<Exponents> = rows
            .filter(|(at, _)| kept(at))
            .filter_map(|(_, row)| Some(row.as_ref()?.product.exponents.clone()))
            .collect();
        let mut seen: Set<Expr> = Set::new();
        let mut at = 0;
        let mut rows = self.rows.clone();
        while at < products.len() {
            insert(&mut echelon, &products[at]);
            let compounds: Vec<Expr> = products[at]
                .keys()
                .filter(|q| !is_plain(q) && seen.insert((*q).clone()))
                .cloned()
                .collect();
            for compound in compounds {
                match rows.compound(&compound) {
                    Ok((parts, row)) => {
                        products.extend(parts.into_iter().map(|p| p.exponents));
                        products.push(row.product.exponents);
                    }
                    // Something that is not understood stays as it is if all in it does.
                    Err(_) => {
                        let mut inside = Set::new();
                        collect(&compound, &mut inside);
                        inside.insert(compound);
                        let still = |q: Expr| Exponents::from([(q, Rational::one())]);
                        products.extend(inside.into_iter().map(still));
                    }
                }
            }
            at += 1;
        }
        let goal = self.rows.goal.exponents.clone();
        let sums = goal.keys().any(|q| !is_plain(q));
        let rescalings = self
            .free(&echelon)
            .into_iter()
            .map(|free| echelon.rescaling(&free))
            .filter(|rescaling| sums || breaks(&goal, rescaling));
        let tries: Vec<Exponents> = rescalings.take(MOST_RESCALINGS).collect();
        tries.into_iter().find_map(|rescaling| {
            doublings(&rescaling).into_iter().find_map(|factor| {
                let plain = first.iter().filter(|(q, _)| is_plain(q));
                let values = plain.map(|(quantity, size)| {
                    let grown = match rescaling.get(quantity) {
                        Some(exponent) => size.times(&Size::from(factor.clone()), exponent),
                        None => size.clone(),
                    };
                    (quantity.clone(), (size.clone(), grown))
                });
                self.check(values.collect())
            })
        })
    }

    /// One quantity doubled, and sums computed in both situations.
    fn computed(&self, first: &Values) -> Option<ScalesNot> {
        if self.sums.is_empty() {
            return None;
        }
        let mut all = self.free(&Echelon::default());
        all.retain(|q| !self.rows.held.contains(q) && is_plain(q));
        for of in all.iter().take(MOST_RESCALINGS) {
            for factor in [2, 4, 16].map(Rational::from) {
                let change = Change {
                    from: first,
                    of,
                    factor: &factor,
                };
                let Some(second) = self.situation(Some(&change)) else {
                    continue;
                };
                let plain = first.iter().filter(|(q, _)| is_plain(q));
                let values = plain.map(|(quantity, size)| {
                    let grown = second.get(quantity).unwrap_or(size).clone();
                    (quantity.clone(), (size.clone(), grown))
                });
                if let Some(refuted) = self.check(values.collect()) {
                    return Some(refuted);
                }
            }
        }
        None
    }

    fn check(&self, values: Map<Expr, (Size, Size)>) -> Option<ScalesNot> {
        let situations = Situations {
            aside: self.aside.clone(),
            values,
        };
        let candidate = ScalingCandidate::Counterexample(situations);
        match check_scaling(self.claim.clone(), candidate) {
            Ok(ScalingVerdict::Refuted(refuted)) => Some(refuted),
            _ => None,
        }
    }

    /// The columns that can be chosen, the best first. Of a proportionality only what is on its right side: what
    /// else is held fixed, it does not say.
    fn free(&self, echelon: &Echelon) -> Vec<Expr> {
        let proportional = matches!(
            &self.claim.goal,
            Formula::Relation {
                relation: Relation::Proportional,
                ..
            }
        );
        let right = &self.rows.sides.1.exponents;
        let late = self.late.iter().rev();
        let others = self.quantities.iter().filter(|q| !self.late.contains(q));
        let mut all: Vec<Expr> = late.chain(others).cloned().collect();
        all.retain(|q| {
            !echelon.is_pivot(q) && (!proportional || right.contains_key(q) || right.is_empty())
        });
        all
    }

    /// 1, unless the domain forbids it: then something that may be doubled, and halved.
    fn plain_value(&self, quantity: &Expr) -> Size {
        let Expr::Symbol(symbol) = quantity else {
            return Size::one();
        };
        if self.rows.held.contains(quantity) && symbol.name() == "\\pi" {
            return Size::pi();
        }
        let own = match self.start > 0 && self.uneven.contains(quantity) {
            true => {
                let mut order: Vec<&Expr> = self.quantities.iter().collect();
                if self.start == 2 {
                    order.reverse();
                }
                let at = order.iter().position(|q| *q == quantity).unwrap_or(0);
                BigRational::from_integer((at + 1).into())
            }
            false => BigRational::one(),
        };
        let Some(domain) = self.claim.domains.get(symbol) else {
            return Size::from(Rational::from(own));
        };
        let quarter = BigRational::new(1.into(), 4.into());
        let two = BigRational::from_integer(2.into());
        let upper = domain.upper.as_ref().map(|b| b.0.clone());
        let lower = domain.lower.as_ref().map(|b| b.0.clone());
        let below = lower.clone().unwrap_or_else(BigRational::zero);
        let guesses = [
            upper.clone().map(|u| u * &quarter),
            Some(own),
            Some(BigRational::one()),
            Some(&below * &two),
            upper.map(|u| (u + &below) / &two),
            Some(below + BigRational::one()),
        ];
        let fits = |value: &BigRational| *value > BigRational::zero() && domain.contains(value);
        let found = guesses.into_iter().flatten().find(fits);
        found.map_or_else(Size::one, |value| Size::from(Rational::from(value)))
    }
}

/// The hypotheses that only say what something is of which nothing else is said.
fn set_aside(claim: &Claim, rows: &Rows) -> Vec<usize> {
    let mut aside: Vec<usize> = Vec::new();
    loop {
        let next = claim.hypotheses.iter().enumerate().find(|(at, h)| {
            let row = rows.rows.get(*at).and_then(Option::as_ref);
            let sum = row.is_none_or(|row| row.product.exponents.keys().any(|q| !is_plain(q)));
            let Formula::Relation {
                left,
                relation: Relation::Equal,
                right,
            } = &*h.formula
            else {
                return false;
            };
            let (symbol, right) = match (left, right) {
                (Expr::Symbol(symbol), term) | (term, Expr::Symbol(symbol)) => (symbol, term),
                (Expr::Apply(symbol, _), term) | (term, Expr::Apply(symbol, _)) => (symbol, term),
                _ => return false,
            };
            let others = claim.hypotheses.iter().enumerate();
            let mut elsewhere = others
                .filter(|(other, _)| other != at && !aside.contains(other))
                .map(|(_, h)| &*h.formula)
                .chain([&claim.goal]);
            sum && !aside.contains(at)
                && !right.mentions(symbol)
                && !elsewhere.any(|f| names(f, symbol))
        });
        match next {
            Some((at, _)) => aside.push(at),
            None => return aside,
        }
    }
}

fn names(formula: &Formula, symbol: &Symbol) -> bool {
    formula.terms().iter().any(|term| term.mentions(symbol))
}

/// The symbols and applications of a term; variables of integration are none.
fn collect(term: &Expr, found: &mut Set<Expr>) {
    match term {
        Expr::Apply(..) => {
            found.insert(term.clone());
        }
        Expr::Symbol(_) => {
            found.insert(term.clone());
        }
        Expr::Integral {
            body,
            variable,
            from,
            to,
        } => {
            let mut inside = Set::new();
            collect(body, &mut inside);
            inside.remove(&Expr::Symbol(variable.clone()));
            found.extend(inside);
            collect(from, found);
            collect(to, found);
        }
        Expr::Derivative { variable, .. } | Expr::Partial { variable, .. } => {
            found.insert(Expr::Symbol(variable.clone()));
            term.children().for_each(|c| collect(c, found));
        }
        _ => term.children().for_each(|c| collect(c, found)),
    }
}

/// 2, and powers of it with which no root is left.
fn doublings(rescaling: &Exponents) -> Vec<Rational> {
    let common = rescaling
        .values()
        .fold(BigInt::one(), |all, e| all.lcm(&e.denom()));
    let mut all = vec![Rational::from(2)];
    let common = common.to_u32().unwrap_or(u32::MAX);
    for power in [common, common.saturating_mul(2), common.saturating_mul(4)] {
        if power > 1 && power <= MOST_DOUBLINGS {
            all.push(Rational::from(BigInt::from(1u64 << power)));
        }
    }
    all
}

/// The rational value of a term that has one.
fn number(term: &Expr, values: &Map<Expr, Size>) -> Option<Rational> {
    let mut map = term.clone();
    fn put(term: &Expr, values: &Map<Expr, Size>, ok: &mut bool) -> Expr {
        if let Some(size) = values.get(term) {
            return match size.as_rational() {
                Ok(Some(value)) => Expr::Number(value.to_big()),
                _ => {
                    *ok = false;
                    term.clone()
                }
            };
        }
        term.map_children(|child| put(child, values, ok))
    }
    let mut ok = true;
    map = put(&map, values, &mut ok);
    let mut atoms = crate::algebra::Atoms::default();
    let mut lowering = crate::algebra::Lowering::plain(&mut atoms);
    lowering.lower(&map).ok()?.as_constant().filter(|_| ok)
}
