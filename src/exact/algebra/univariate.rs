use super::Rational;

/// A polynomial in one unknown, by its coefficients, the constant one first.
///
/// Canonical by construction: the last coefficient is not 0, and 0 has none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Univariate(Vec<Rational>);

impl Univariate {
    /// `Σ c_k x^k`.
    pub fn new(coefficients: impl IntoIterator<Item = Rational>) -> Self {
        let mut all: Vec<Rational> = coefficients.into_iter().collect();
        while all.last().is_some_and(Rational::is_zero) {
            all.pop();
        }
        Univariate(all)
    }

    /// A constant.
    pub fn constant(value: Rational) -> Self {
        Univariate::new([value])
    }

    /// The unknown itself.
    pub fn unknown() -> Self {
        Univariate::new([Rational::zero(), Rational::one()])
    }

    /// The coefficients, the constant one first.
    pub fn coefficients(&self) -> &[Rational] {
        &self.0
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The degree; 0 for the zero polynomial.
    pub fn degree(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    /// The value, where the unknown does not occur.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.0.as_slice() {
            [] => Some(Rational::zero()),
            [only] => Some(only.clone()),
            _ => None,
        }
    }

    /// The length of the longest number in it, in bits.
    pub fn bits(&self) -> u64 {
        let bits = self.0.iter().map(|c| c.numer().bits() + c.denom().bits());
        bits.max().unwrap_or(0)
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        let length = self.0.len().max(other.0.len());
        let at = |list: &[Rational], k| list.get(k).cloned().unwrap_or_else(Rational::zero);
        Univariate::new((0..length).map(|k| at(&self.0, k) + at(&other.0, k)))
    }

    /// The difference.
    pub fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(&-Rational::one()))
    }

    /// A rational multiple.
    pub fn scaled(&self, factor: &Rational) -> Self {
        Univariate::new(self.0.iter().map(|c| c * factor))
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        let mut all = vec![Rational::zero(); (self.0.len() + other.0.len()).saturating_sub(1)];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                all[i + j] += a * b;
            }
        }
        Univariate::new(all)
    }

    /// Quotient and remainder; `None` where the divisor is 0.
    pub fn divided_by(&self, other: &Self) -> Option<(Self, Self)> {
        let lead = other.0.last()?.recip();
        let mut rest = self.0.clone();
        let mut quotient = vec![Rational::zero(); (rest.len() + 1).saturating_sub(other.0.len())];
        for at in (0..quotient.len()).rev() {
            let factor = &rest[at + other.degree()] * &lead;
            for (k, c) in other.0.iter().enumerate() {
                rest[at + k] -= &factor * c;
            }
            quotient[at] = factor;
        }
        Some((Univariate::new(quotient), Univariate::new(rest)))
    }

    /// What is left of it modulo another; all of it where that is 0.
    pub fn modulo(&self, other: &Self) -> Self {
        self.divided_by(other).map_or_else(|| self.clone(), |d| d.1)
    }

    /// The polynomial divided by its leading coefficient; 0 stays 0.
    pub fn monic(&self) -> Self {
        match self.0.last() {
            Some(lead) => self.scaled(&lead.recip()),
            None => self.clone(),
        }
    }

    /// The derivative.
    pub fn derivative(&self) -> Self {
        let terms = (0_u32..).zip(&self.0).skip(1);
        Univariate::new(terms.map(|(k, c)| c * Rational::from(k)))
    }

    /// The value at a number.
    pub fn at(&self, value: &Rational) -> Rational {
        let terms = self.0.iter().rev();
        terms.fold(Rational::zero(), |sum, c| sum * value + c)
    }

    /// The greatest common divisor, monic.
    pub fn gcd(&self, other: &Self) -> Self {
        let (mut a, mut b) = (self.monic(), other.monic());
        while !b.is_zero() {
            (a, b) = (b.clone(), a.modulo(&b).monic());
        }
        a
    }

    /// `u` with `u · self = 1` modulo another polynomial; `None` where they have a common factor.
    pub fn inverse_modulo(&self, other: &Self) -> Option<Self> {
        let (mut a, mut b) = (other.clone(), self.modulo(other));
        let (mut of_a, mut of_b) = (Univariate::default(), Univariate::constant(Rational::one()));
        while b.degree() > 0 {
            let (quotient, rest) = a.divided_by(&b)?;
            let of_rest = of_a.minus(&quotient.times(&of_b));
            (a, b, of_a, of_b) = (b, rest, of_b, of_rest);
        }
        let unit = b.0.first()?.recip();
        Some(of_b.scaled(&unit).modulo(other))
    }

    /// The signed remainder sequence `p, f, −(p mod f), …`, each up to a positive factor; the last one is the greatest
    /// common divisor of the first two.
    ///
    /// **Source.** Basu, Pollack, Roy, *Algorithms in Real Algebraic Geometry*, chapter 1.
    pub fn signed_remainders(&self, f: &Self) -> Vec<Self> {
        let mut all = vec![self.clone()];
        let mut next = f.clone();
        while !next.is_zero() {
            let last = all.last().unwrap_or(self);
            let rest = last.modulo(&next);
            let size = rest.0.last().map_or_else(Rational::one, |c| c.abs());
            all.push(next);
            next = rest.scaled(&-size.recip());
        }
        all
    }
}

/// How often the sign changes along a sequence of polynomials at a number; zeros are left out.
fn variations(sequence: &[Univariate], at: &Rational) -> i32 {
    let values = sequence.iter().map(|p| p.at(at));
    let signs: Vec<bool> = values
        .filter(|v| !v.is_zero())
        .map(|v| v.is_positive())
        .collect();
    let changes = signs.windows(2).filter(|pair| pair[0] != pair[1]);
    i32::try_from(changes.count()).unwrap_or(i32::MAX)
}

/// The sum of the signs of `f` at all roots of `p` between two numbers that are no roots, where the sequence is that of
/// the signed remainders of `p` and `p' f`, or of `p` and what `p' f` is modulo `p`. With `f = 1` it is the number of roots.
///
/// $$ \sum_{a < c < b,\; p(c) = 0} \operatorname{sign} f(c) = V(a) - V(b) $$
///
/// **Source.** Sturm and Tarski; Basu, Pollack, Roy, *Algorithms in Real Algebraic Geometry*, chapter 2.
pub fn sum_of_signs(sequence: &[Univariate], a: &Rational, b: &Rational) -> i32 {
    variations(sequence, a) - variations(sequence, b)
}
