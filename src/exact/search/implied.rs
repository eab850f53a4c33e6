//! What premises give for a symbol of which something false is said.

use num_integer::Integer;

use super::ideal::Ideal;
use super::tracked::Tracked;
use super::{Effort, pose, prove_unconditionally};
use crate::algebra::{
    Atom, Atoms, BigInt, BigRational, Expr, Formula, Fraction, Polynomial, Rational, Symbol, Var,
    expr_of, expr_of_atom, expr_of_fraction, factors, product_of, raised,
};
use crate::kernel::{Claim, Fact, Knowledge, Obligation, Problem, Proven, Sign, definition};
use crate::sorted::{self, Set};

/// More terms than this tell a reader nothing.
const MOST_TERMS: usize = 12;
/// A ratio of greater numbers is no slip in a coefficient.
const LARGEST_FACTOR: i64 = 64;

/// What follows in the place of a failing `symbol = term`.
#[derive(Clone, Debug)]
pub struct Implied {
    /// The kernel's word for `symbol = another term`.
    pub proven: Proven,
    /// What the failing term is, divided by what follows; `None` where that is not short.
    pub ratio: Option<Expr>,
}

impl Implied {
    /// Whether it only says what a premise says.
    pub fn restates(&self) -> bool {
        let claim = self.proven.claim();
        let Some((left, right)) = claim.goal.as_equation() else {
            return false;
        };
        let turned = Formula::equal(right.clone(), left.clone());
        let said = |f: &Formula| *f == claim.goal || *f == turned;
        claim.hypotheses.iter().any(|h| said(&h.formula))
    }

    /// Whether what is printed differs in a number alone, and in one that a pen may have slipped by.
    pub fn is_multiple(&self) -> bool {
        let is_short = |term: &Expr| {
            let most = BigInt::from(LARGEST_FACTOR);
            let own = own_number(term).map(|own| own.abs());
            own.is_some_and(|own| own.numer() <= most && own.denom() <= most)
        };
        let number = |ratio: &Expr| match ratio {
            Expr::Negate(inner) => is_short(inner),
            ratio => is_short(ratio),
        };
        self.ratio.as_ref().is_some_and(number)
    }
}

/// What the premises of a failing `symbol = term` give for the symbol, in what the term speaks of if that can
/// be had.
pub fn implied(obligation: &Obligation) -> Option<Implied> {
    let (claim, problem) = (obligation.claim(), obligation.problem());
    let (symbol, printed) = solved(&claim.goal)?;
    let own = var_of(obligation, symbol)?;
    let mut atoms = problem.atoms.clone();
    let printed_value = problem.lowering_over(&mut atoms).lower(printed).ok()?;
    let mut kept: Set<Var> = printed_value.numerator().vars().into_iter().collect();
    for (factor, _) in printed_value.denominator() {
        kept.extend(factor.vars());
    }
    // The logarithm of a number is a number.
    let is_number = |atom: &Atom| matches!(atom, Atom::Opaque(own) if own.is_logarithm_of_number());
    let numbers = problem.atoms.iter().filter(|(_, atom)| is_number(atom));
    kept.extend(numbers.map(|(var, _)| var));
    let value = value_of(problem, own, &kept)?;
    let quotient = match printed_value.is_zero() {
        true => None,
        false => value.times(&printed_value.recip().ok()??).ok(),
    };
    // Where only a factor is wrong, the author's own words are kept.
    let factor = quotient.as_ref().and_then(Fraction::as_constant);
    let mut candidates = Vec::new();
    if factor
        .as_ref()
        .is_some_and(|f| f.is_negative() && f.abs().is_one())
    {
        candidates.extend(turned(printed));
    }
    let factor = factor.filter(|factor| !factor.is_zero());
    candidates.extend(factor.map(|factor| scaled(printed, &factor)));
    candidates.push(tidy(&value, &atoms));
    candidates.push(expr_of_fraction(&value, &atoms));
    // What a root is taken of may speak of the symbol still.
    candidates.retain(|term| !term.mentions(symbol));
    let proven = candidates.into_iter().find_map(|term| {
        let goal = Formula::equal(Expr::Symbol(symbol.clone()), term);
        let claim = Claim {
            goal,
            ..claim.clone()
        };
        let derived = prove_unconditionally(claim.clone(), Effort::Light)
            .or_else(|| prove_unconditionally(claim, Effort::Full));
        derived.map(|derived| derived.proven)
    })?;
    let ratio = quotient
        .and_then(|q| q.recip().ok()?)
        .filter(|ratio| is_short(ratio) && !is_tied(problem, ratio))
        .map(|ratio| tidy(&ratio, &atoms));
    Some(Implied { proven, ratio })
}

/// The unknown of a symbol; where another name was put in for it, that one's.
fn var_of(obligation: &Obligation, symbol: &Symbol) -> Option<Var> {
    let atoms = &obligation.problem().atoms;
    let find = |symbol: &Symbol| atoms.find(&Atom::Symbol(symbol.clone()));
    find(symbol).or_else(|| {
        let hypotheses = &obligation.claim().hypotheses;
        let mut put_in = obligation.unfold().iter();
        put_in.find_map(|&at| match definition(&hypotheses[at].formula)? {
            (own, Expr::Symbol(other)) if own == *symbol => find(&other),
            _ => None,
        })
    })
}

/// Whether a premise ties the unknowns of a ratio: then they may cancel.
fn is_tied(problem: &Problem, ratio: &Fraction) -> bool {
    let unknowns = unknowns(ratio);
    let ties = |fact: &Fact| {
        let own: Vec<Var> = fact.polynomial.vars().into_iter().collect();
        fact.sign == Sign::Zero && !own.is_empty() && own.iter().all(|var| unknowns.contains(var))
    };
    problem.facts.iter().any(ties)
}

fn unknowns(ratio: &Fraction) -> Set<Var> {
    let below = ratio.denominator().map(|(factor, _)| factor);
    below
        .chain([ratio.numerator()])
        .flat_map(Polynomial::vars)
        .collect()
}

/// Whether a ratio tells a reader something: a number, a product of two unknowns, or what one unknown makes of it.
fn is_short(ratio: &Fraction) -> bool {
    let below: Vec<&Polynomial> = ratio.denominator().map(|(factor, _)| factor).collect();
    let mut all = below.iter().copied().chain([ratio.numerator()]);
    match unknowns(ratio).len() {
        0 => true,
        1 => ratio.numerator().len() <= 2 && below.len() <= 2,
        2 => all.all(|factor| factor.len() == 1),
        _ => false,
    }
}

/// A difference the other way round, where a term is one or has one as a factor: the wrong sign undone without a minus before it.
fn turned(term: &Expr) -> Option<Expr> {
    match term {
        Expr::Sum(items) => match &items[..] {
            [first, Expr::Negate(second)] if !matches!(first, Expr::Negate(_)) => {
                let first = Expr::Negate(first.clone().into());
                Some(Expr::Sum([(**second).clone(), first].into()))
            }
            _ => None,
        },
        Expr::Product(factors) => {
            let mut factors = factors.to_vec();
            let (at, other) = (factors.iter().enumerate())
                .find_map(|(at, factor)| Some((at, turned(factor)?)))?;
            factors[at] = other;
            Some(Expr::Product(factors.into()))
        }
        Expr::Quotient(above, below) => {
            let above = turned(above)?;
            Some(Expr::Quotient(above.into(), below.clone()))
        }
        _ => None,
    }
}

/// `symbol = term` or `term = symbol`, the term not mentioning the symbol.
fn solved(goal: &Formula) -> Option<(&Symbol, &Expr)> {
    let (left, right) = goal.as_equation()?;
    match (left, right) {
        (Expr::Symbol(symbol), term) | (term, Expr::Symbol(symbol)) => {
            (!term.mentions(symbol)).then_some((symbol, term))
        }
        _ => None,
    }
}

/// What the premises give for a symbol in terms of constants alone.
pub fn value_in_constants(claim: &Claim, symbol: &Symbol) -> Option<Expr> {
    let obligation = pose(claim.clone()).ok()?;
    let problem = obligation.problem();
    let own = problem.atoms.find(&Atom::Symbol(symbol.clone()))?;
    let is_constant = |name: &Symbol| {
        let domain = claim.domains.get(name);
        name != symbol && domain.is_some_and(|domain| domain.constant)
            || name.name() == "\\pi" && problem.pi_is_the_number()
    };
    let is_made_of_constants = |atom: &Atom| {
        let term = expr_of_atom(atom);
        !term.has_elements() && term.free_symbols().iter().all(is_constant)
    };
    let atoms = problem.atoms.iter();
    let kept = atoms.filter(|(_, atom)| is_made_of_constants(atom));
    let kept: Set<Var> = kept.map(|(var, _)| var).collect();
    let value = value_of(problem, own, &kept)?;
    let below = value.denominator().map(|(factor, _)| factor);
    let vars = below.chain([value.numerator()]).flat_map(Polynomial::vars);
    let in_constants = { vars }.all(|var| kept.contains(&var));
    in_constants.then(|| tidy(&value, &problem.atoms))
}

/// The value that the equations of a problem give to an unknown, in as few others as may be besides the `kept`.
fn value_of(problem: &Problem, own: Var, kept: &Set<Var>) -> Option<Fraction> {
    let knowledge = Knowledge::new(&problem.facts);
    let outside = |var: Var| var != own && !kept.contains(&var);
    let ideal = Ideal::without(&problem.facts, &knowledge, outside).ok()?;
    let strange = |element: &Tracked| {
        let vars = element.polynomial.vars();
        vars.into_iter().filter(|&var| outside(var)).count()
    };
    // That what is divided by does not vanish is left to the proof.
    let solvable = |element: &&Tracked| {
        let polynomial = &element.polynomial;
        polynomial.len() <= MOST_TERMS && in_two_powers(polynomial, own).is_some()
    };
    let simplest = |elements: &[Tracked]| {
        let all = elements.iter().filter(solvable);
        // What says the same without the unknown as a factor says it plainly.
        let is_multiple = |e: &Tracked| e.polynomial.degree_in(own) > 1;
        all.min_by_key(|e| (is_multiple(e), strange(e), e.polynomial.len()))
            .cloned()
    };
    let first = simplest(&ideal.rest);
    let element = match first.as_ref().is_some_and(|e| strange(e) == 0) {
        true => first,
        false => simplest(&ideal.basis(&knowledge)).or(first),
    }?;
    let (rest, slope) = in_two_powers(&element.polynomial, own)?;
    let slope = Fraction::from(slope).recip().ok()??;
    cancelled(&Fraction::from(rest.negated()).times(&slope).ok()?)
}

/// The last two coefficients in the powers of an unknown, where there are no others: that the unknown itself, `t` in `v t - g t^2 = 0`, does not
/// vanish is left to the proof as well.
fn in_two_powers(polynomial: &Polynomial, own: Var) -> Option<(Polynomial, Polynomial)> {
    let mut parts = polynomial.in_powers_of(own);
    let (slope, rest) = (parts.pop()?, parts.pop()?);
    parts
        .iter()
        .all(Polynomial::is_zero)
        .then_some((rest, slope))
}

/// The same value with the sum in the numerator divided out of the denominator, where it divides a factor of it.
fn cancelled(value: &Fraction) -> Option<Fraction> {
    let numerator = value.numerator();
    let Some(sum) = factors(numerator).into_keys().find(|f| f.len() > 1) else {
        return Some(value.clone());
    };
    let mut below = Fraction::from(Rational::one());
    let mut above = Fraction::from(numerator.clone());
    let mut left = true;
    for (factor, exponent) in value.denominator() {
        let (mut factor, mut power) = (Fraction::from(factor.clone()), exponent);
        let shorter = factor.numerator().divided_by(&sum).filter(|_| left);
        if let Some(shorter) = shorter {
            left = false;
            above = numerator.divided_by(&sum)?.into();
            below = below.times(&shorter.into()).ok()?;
            power -= 1;
        }
        factor = factor.pow(power).ok()?;
        below = below.times(&factor).ok()?;
    }
    above.times(&below.recip().ok()??).ok()
}

/// A number as one would write it: `\frac12` rather than 0.5.
pub(super) fn number(value: &Rational) -> Expr {
    if value.is_integer() {
        return Expr::integer(value.numer());
    }
    let above = Expr::integer(value.abs().numer());
    let quotient = Expr::Quotient(above.into(), Expr::integer(value.denom()).into());
    match value.is_negative() {
        true => Expr::Negate(quotient.into()),
        false => quotient,
    }
}

/// The value of a term that is a number.
pub(super) fn own_number(term: &Expr) -> Option<Rational> {
    match term {
        Expr::Number(value) => Some(value.into()),
        Expr::Quotient(above, below) => match (&**above, &**below) {
            (Expr::Number(above), Expr::Number(below)) => {
                Some(Rational::from(above) / Rational::from(below))
            }
            _ => None,
        },
        _ => None,
    }
}

/// The size of the number that a term begins with, 1 if with none.
pub(super) fn coefficient(term: &Expr) -> Rational {
    let own = match term {
        Expr::Product(factors) => factors.first().and_then(own_number),
        term => own_number(term),
    };
    let own = own.map(|own| own.abs()).filter(|own| !own.is_zero());
    own.unwrap_or_else(Rational::one)
}

/// A term times a number, the number merged into the term as one would write it.
pub(super) fn scaled(term: &Expr, factor: &Rational) -> Expr {
    if let Some(own) = own_number(term) {
        return number(&(factor * own));
    }
    if factor.is_negative() {
        return Expr::Negate(scaled(term, &-factor).into());
    }
    match term {
        Expr::Negate(inner) => Expr::Negate(scaled(inner, factor).into()),
        Expr::Quotient(above, below) => {
            // In lowest terms with the numbers that stand there already.
            let (own, under) = (coefficient(above), coefficient(below));
            let total = factor * &own / &under;
            let up = Rational::from(total.numer()) / own;
            let down = Rational::from(total.denom()) / under;
            let side = |term: &Expr, by: &Rational| match by.is_one() {
                true => term.clone(),
                false => scaled(term, by),
            };
            let (above, below) = (side(above, &up), side(below, &down));
            match below.is_one() {
                true => above,
                false => Expr::Quotient(above.into(), below.into()),
            }
        }
        Expr::Product(factors) => {
            let mut factors = factors.to_vec();
            // With the number that stands there already, if it is the only one, or in the fraction.
            let numbers = factors.iter().filter(|f| own_number(f).is_some()).count();
            let own = factors.iter().position(|f| own_number(f).is_some());
            let fraction = factors.iter().position(|f| matches!(f, Expr::Quotient(..)));
            match (own.filter(|&at| at == 0 || numbers == 1), fraction) {
                (Some(at), _) => {
                    let own = own_number(&factors.remove(at)).unwrap_or_else(Rational::one);
                    let merged = factor * own;
                    if !merged.is_one() {
                        factors.insert(at, number(&merged));
                    }
                }
                (None, Some(at)) if !factor.is_one() => {
                    factors[at] = scaled(&factors[at], factor);
                    if own_number(&factors[at]).is_some_and(|own| own.is_one()) {
                        factors.remove(at);
                    }
                }
                _ if factor.is_one() => {}
                _ => factors.insert(0, number(factor)),
            }
            match factors.len() {
                1 => factors.remove(0),
                _ => Expr::Product(factors.into()),
            }
        }
        _ if factor.is_one() => term.clone(),
        _ => Expr::Product([number(factor), term.clone()].into()),
    }
}

/// A rational function with what its numerator has in common taken out: `1/2 (1 + e²) E_0`.
fn tidy(value: &Fraction, atoms: &Atoms) -> Expr {
    let numerator = value.numerator();
    if numerator.is_zero() {
        return Expr::integer(0);
    }
    let mut number_before = Rational::one();
    let (mut powers, mut sums) = (Vec::new(), Vec::new());
    for (factor, exponent) in factors(numerator) {
        // A sum is there once: no more than unknowns are taken out of a numerator.
        match factor.len() {
            1 => powers.push(raised(expr_of(&factor, atoms), exponent)),
            _ => {
                let (content, primitive) = primitive(&factor);
                number_before *= content;
                sums.push(primitive);
            }
        }
    }
    // The factors are monic: what is left over is a number.
    if let Some((_, lead)) = numerator.leading() {
        number_before *= lead.clone();
    }
    // `(a - b) c` rather than `-(-a + b) c`.
    if let Some(sum) = sums.first_mut().filter(|_| number_before.is_negative()) {
        (number_before, *sum) = (-number_before, sum.negated());
    }
    let sums = sums.iter().map(|sum| positive_first(expr_of(sum, atoms)));
    let mut sums: Vec<Expr> = sums.collect();
    sorted::sort(&mut powers);
    sums.extend(powers);
    let mut below: Vec<Expr> = value
        .denominator()
        .map(|(factor, exponent)| raised(expr_of(factor, atoms), exponent))
        .collect();
    sorted::sort(&mut below);
    let one = Rational::one();
    let (above, under) = match below.is_empty() {
        true => (number_before, one),
        false => (
            Rational::from(number_before.numer()),
            Rational::from(number_before.denom()),
        ),
    };
    let above = scaled(&product_of(sums), &above);
    match below.is_empty() {
        true => above,
        false => Expr::Quotient(above.into(), scaled(&product_of(below), &under).into()),
    }
}

/// A sum that does not begin with a minus, if it can.
fn positive_first(sum: Expr) -> Expr {
    let Expr::Sum(items) = &sum else {
        return sum;
    };
    let is_negative = |item: &Expr| matches!(item, Expr::Negate(_));
    if is_negative(&items[0])
        && let Some(at) = items.iter().position(|item| !is_negative(item))
    {
        let mut items = items.to_vec();
        items[..=at].rotate_right(1);
        return Expr::Sum(items.into());
    }
    sum
}

/// A sum as a number times a sum with whole coefficients that have no divisor in common, the lowest positive.
fn primitive(sum: &Polynomial) -> (Rational, Polynomial) {
    let (mut divisor, mut multiple) = (BigInt::from(0), BigInt::from(1));
    for (_, coefficient) in sum.terms() {
        divisor = divisor.gcd(&coefficient.numer());
        multiple = multiple.lcm(&coefficient.denom());
    }
    let mut content = Rational::from(BigRational::new(divisor, multiple));
    if sum.terms().next().is_some_and(|(_, c)| c.is_negative()) {
        content = -content;
    }
    (content.clone(), sum.scaled(&content.recip()))
}
