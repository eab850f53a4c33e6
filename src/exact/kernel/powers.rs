//! Which powers of a claim may be taken apart, and what its roots and powers are known to be.

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::{Claim, Fact, Knowledge, Origin, Problem, Reject, Sign};
use crate::algebra::{
    Atom, Atoms, BigRational, Expr, Formula, Fraction, Function, Functions, Polynomial, Powers,
    Rational, Relation, Symbol, Var, element_parts, mentions_symbol, sign_of_fraction,
};
use crate::sorted::{Map, Set};

/// The highest order of a root that a symbol is read as a power of.
const HIGHEST_ORDER: u32 = 120;

/// What the terms of a claim let be taken apart; `None` where there is nothing of the kind.
///
/// `elsewhere` are symbols whose domain says nothing of a symbol of that name: those that were put in. `pi` tells whether `\pi` is the
/// number.
pub(super) fn powers_of<'a>(
    claim: &Claim,
    pi: bool,
    terms: impl Iterator<Item = &'a Expr> + Clone,
    sequences: &Set<Symbol>,
    counts: &Set<Symbol>,
    elsewhere: impl Fn(&Symbol) -> bool,
) -> Option<(Powers, Functions)> {
    // Most claims have nothing of the kind.
    if !terms.clone().any(has_powers) {
        return None;
    }
    let mut found = Occurrences::default();
    terms.for_each(|term| found.collect(term, Some(1), false));
    let (mut powers, mut functions) = (Powers::default(), Functions::default());
    // A bound symbol of that name is another.
    let is_other = |symbol: &Symbol| {
        let element = element_parts(symbol).is_some_and(|(s, _)| sequences.contains(&s));
        let of_sequences = element || sequences.contains(symbol);
        of_sequences || elsewhere(symbol) || found.bound.contains(symbol)
    };
    for (symbol, domain) in &claim.domains {
        if is_other(symbol) {
            continue;
        }
        if domain.integer {
            functions.integers.insert(symbol.clone());
            if domain.lower.iter().any(|(bound, _)| !bound.is_negative()) {
                functions.naturals.insert(symbol.clone());
            }
        }
        if !domain.contains(&BigRational::zero()) {
            powers.nonzero.insert(symbol.clone());
        }
        if !domain.is_positive() {
            continue;
        }
        powers.positive.insert(symbol.clone());
        let still = !found.moving.contains(symbol) && !counts.contains(symbol) && !domain.integer;
        if let Some(&order) = found.orders.get(symbol)
            && still
            && (2..=HIGHEST_ORDER).contains(&order)
        {
            powers.roots.insert(symbol.clone(), order);
        }
    }
    let hypotheses = claim.hypotheses.iter();
    let said = hypotheses.filter_map(|own| said_positive(&own.formula));
    for symbol in said.filter(|symbol| !is_other(symbol)) {
        powers.nonzero.insert(symbol.clone());
        powers.positive.insert(symbol.clone());
    }
    if pi {
        let pi = Symbol::new("\\pi");
        powers.nonzero.insert(pi.clone());
        powers.positive.insert(pi);
    }
    functions.positive = powers.positive.clone();
    Some((powers, functions))
}

/// The symbol that a premise says to be positive.
pub(super) fn said_positive(formula: &Formula) -> Option<&Symbol> {
    let Formula::Relation {
        left,
        relation,
        right,
    } = formula
    else {
        return None;
    };
    match (left, relation, right) {
        (Expr::Symbol(symbol), Relation::Greater, Expr::Number(bound))
        | (Expr::Number(bound), Relation::Less, Expr::Symbol(symbol)) => {
            (!bound.is_negative()).then_some(symbol)
        }
        _ => None,
    }
}

/// Whether there is a power with another exponent than an integer in a term.
fn has_powers(term: &Expr) -> bool {
    term.any(&|part| match part {
        Expr::Power(_, exponent) => match &**exponent {
            Expr::Number(exponent) => !exponent.is_integer(),
            exponent => constant(exponent).is_none_or(|e| !e.is_integer()),
        },
        // Of what is positive a logarithm can be taken factor by factor.
        Expr::Call(Function::Ln, _) => true,
        // Sines and cosines of whole numbers of half turns.
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, argument) => {
            argument.mentions(&Symbol::new("\\pi"))
        }
        // In sums over whole numbers every power has a value.
        Expr::Series { index, body, .. } => mentions_symbol(body, index),
        _ => false,
    })
}

/// Where symbols occur.
#[derive(Default)]
struct Occurrences {
    /// The order of the root below which each symbol occurs as a factor; 0 where it is too high.
    orders: Map<Symbol, u32>,
    /// Symbols in sums, derivatives, limits and integrals.
    moving: Set<Symbol>,
    bound: Set<Symbol>,
}

impl Occurrences {
    /// `order` is that of the roots around, `None` where it is too high.
    fn collect(&mut self, term: &Expr, order: Option<u32>, moving: bool) {
        match term {
            Expr::Symbol(symbol) => {
                let slot = self.orders.entry(symbol.clone()).or_insert(1);
                let joint = order.filter(|_| *slot != 0).map(|order| slot.lcm(&order));
                *slot = joint.filter(|&joint| joint <= HIGHEST_ORDER).unwrap_or(0);
                if moving {
                    self.moving.insert(symbol.clone());
                }
            }
            Expr::Power(base, exponent) => {
                let denominator = match constant(exponent) {
                    Some(exponent) => u32::try_from(exponent.denom()).ok(),
                    None => Some(1),
                };
                let below = order.zip(denominator);
                let below = below.and_then(|(a, b)| a.checked_mul(b));
                let below = below.filter(|&order| order <= HIGHEST_ORDER);
                self.collect(base, below, moving);
                self.collect(exponent, Some(1), moving);
            }
            Expr::Product(_) | Expr::Quotient(..) | Expr::Negate(_) => {
                let children = term.children();
                children.for_each(|child| self.collect(child, order, moving));
            }
            _ => {
                let calculus = term.binder();
                self.bound.extend(calculus.cloned());
                let moving = moving || calculus.is_some();
                if moving {
                    self.moving.extend(calculus.cloned());
                }
                let children = term.children();
                children.for_each(|child| self.collect(child, Some(1), moving));
            }
        }
    }
}

/// The value of a term without symbols.
fn constant(term: &Expr) -> Option<BigRational> {
    match term {
        Expr::Number(value) => Some(value.clone()),
        Expr::Negate(inner) => Some(-constant(inner)?),
        Expr::Quotient(above, below) => {
            let below = constant(below).filter(|b| !b.is_zero())?;
            Some(constant(above)? / below)
        }
        Expr::Product(factors) => factors.iter().map(constant).product(),
        Expr::Sum(terms) => terms.iter().map(constant).sum(),
        _ => None,
    }
}

impl Problem {
    /// What roots and powers are: `s^q = base`, `s ≥ 0`.
    ///
    /// Only where the base is seen not to be negative by what is known without the root: elsewhere there may be no
    /// root at all, and that there is one must not follow from what is said of it. Each fact can be made true at
    /// every point at which those before it are, whether or not the terms of the goal have a value there.
    pub(super) fn add_facts_about_powers(&mut self) -> Result<(), Reject> {
        if self.powers.is_none() {
            return Ok(());
        }
        let mut knowledge = Knowledge::new(&self.facts);
        let mut atoms = std::mem::take(&mut self.atoms);
        let mut at = 0;
        loop {
            let next = atoms.iter().nth(at).map(|(var, _)| var);
            let Some(var) = next else {
                break;
            };
            at += 1;
            let Some(base) = self.base_over(&mut atoms, var) else {
                continue;
            };
            for fact in self.about(&atoms, var, &base, &knowledge)? {
                knowledge.learn(&fact);
                self.add(fact.polynomial, fact.sign, Origin::Powers);
            }
        }
        self.atoms = atoms;
        Ok(())
    }

    /// The sign that the base of a root or power has: what must be known of it for [`Problem::about_power`] to say anything.
    /// `None` for any other unknown.
    pub fn sign_of_base(&self, power: Var) -> Option<Polynomial> {
        let base = self.base_over(&mut self.atoms.clone(), power)?;
        sign_of_fraction(&base.value).ok()
    }

    /// What a root or a power is, by what is known of its base.
    ///
    /// # Errors
    /// It is too large to be told.
    pub fn about_power(&self, power: Var, knowledge: &Knowledge) -> Result<Vec<Fact>, Reject> {
        let mut atoms = self.atoms.clone();
        match self.base_over(&mut atoms, power) {
            Some(base) => self.about(&atoms, power, &base, knowledge),
            None => Ok(Vec::new()),
        }
    }

    fn base_over(&self, atoms: &mut Atoms, power: Var) -> Option<Base> {
        let Atom::Opaque(Expr::Power(base, exponent)) = atoms.atom(power).clone() else {
            return None;
        };
        let mut lowering = self.lowering_over(atoms);
        let value = lowering.lower(&base).ok()?;
        let conditions = lowering.conditions;
        let exponent = (*exponent).clone();
        let plain = conditions.zero.is_empty() && conditions.away.is_empty();
        (plain && conditions.doubtful.is_empty()).then_some(Base { value, exponent })
    }

    fn about(
        &self,
        atoms: &Atoms,
        power: Var,
        base: &Base,
        knowledge: &Knowledge,
    ) -> Result<Vec<Fact>, Reject> {
        // What it is made of comes before it, but for symbols, of which all is known that ever will be.
        let is_symbol = |v: Var| matches!(atoms.atom(v), Atom::Symbol(_));
        let before = |p: &Polynomial| p.vars().iter().all(|&v| v < power || is_symbol(v));
        let mut divisors = base.value.denominator();
        let sure = divisors.all(|(d, _)| before(d) && knowledge.is_nonzero(d));
        let apart = self.functions.as_ref().filter(|_| self.powers.is_some());
        match apart {
            Some(functions) if sure && before(base.value.numerator()) => {
                about_power(Polynomial::var(power), base, functions, knowledge)
            }
            _ => Ok(Vec::new()),
        }
    }
}

/// What a root or a power is taken of, and how.
struct Base {
    value: Fraction,
    exponent: Expr,
}

fn about_power(
    power: Polynomial,
    base: &Base,
    functions: &Functions,
    knowledge: &Knowledge,
) -> Result<Vec<Fact>, Reject> {
    let sign = sign_of_fraction(&base.value)?;
    let (base, exponent) = (&base.value, &base.exponent);
    let fact = |polynomial: &Polynomial, sign| Fact {
        polynomial: polynomial.clone(),
        sign,
    };
    let (nonnegative, positive) = (
        knowledge.is_nonnegative(&sign),
        knowledge.is_positive(&sign),
    );
    let mut facts = Vec::new();
    let natural = match exponent {
        Expr::Number(exponent) => {
            // Of an odd root of something negative nothing is said.
            let root = exponent.numer().is_one() && nonnegative;
            let Some(order) = u32::try_from(exponent.denom()).ok().filter(|_| root) else {
                return Ok(facts);
            };
            let left = power.pow(order)?.times(&base.expanded_denominator()?)?;
            facts.push(fact(&left.minus(base.numerator()), Sign::Zero));
            true
        }
        Expr::Symbol(symbol) => functions.naturals.contains(symbol),
        _ => false,
    };
    // (-1)^n is 1 or -1 for a whole number n.
    let whole = matches!(exponent, Expr::Symbol(symbol) if functions.integers.contains(symbol));
    if whole && base.as_constant().is_some_and(|b| (-b).is_one()) {
        let square = power.pow(2)?;
        let one = Polynomial::constant(Rational::one());
        facts.push(fact(&square.minus(&one), Sign::Zero));
    }
    if positive {
        facts.push(fact(&power, Sign::Positive));
        return Ok(facts);
    }
    if natural && nonnegative {
        facts.push(fact(&power, Sign::NonNegative));
    }
    if natural && knowledge.is_nonzero(base.numerator()) {
        facts.push(fact(&power, Sign::NonZero));
    }
    Ok(facts)
}
