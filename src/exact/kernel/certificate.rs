//! The certificate language: plain data, written by the search, believed by nobody.
//!
//! Polynomials refer to the unknowns of the [`Problem`](super::Problem) that the kernel makes of the claim,
//! facts to their position in it.

use std::cmp::Ordering;

use super::Rate;
use crate::algebra::{BigRational, Expr, Polynomial, Rational, Symbol, TooLarge, Var};
use crate::sorted::Map;

/// What the search hands over. Nothing in here is believed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Candidate {
    /// The goal follows.
    Proof(Certificate),
    /// The premises can be true and the goal false.
    Counterexample(Assignment),
}

impl Candidate {
    /// The hypotheses that it puts in.
    pub fn unfold(&self) -> &[usize] {
        match self {
            Candidate::Proof(certificate) => &certificate.unfold,
            Candidate::Counterexample(point) => &point.unfold,
        }
    }
}

/// A proof that a goal follows from its hypotheses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate {
    /// The hypotheses of the form `symbol = term` that are put in everywhere first, in order.
    pub unfold: Vec<usize>,
    /// The facts that are differentiated, in order; what comes of them stands after all other facts.
    pub rates: Vec<Rate>,
    /// Facts to be added, in order, each with its proof.
    pub lemmas: Vec<Lemma>,
    /// The proof of the goal.
    pub conclusion: Proof,
}

/// A fact with its proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lemma {
    /// What is added to the facts.
    pub fact: Fact,
    /// Why it follows from the facts before it.
    pub proof: Proof,
}

/// A polynomial and what is known of its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// The polynomial.
    pub polynomial: Polynomial,
    /// What is known of its value.
    pub sign: Sign,
}

/// What can be known of the value of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// = 0
    Zero,
    /// ≠ 0
    NonZero,
    /// ≥ 0
    NonNegative,
    /// > 0
    Positive,
}

impl Sign {
    /// Whether a number has the sign, by how it compares with 0.
    pub fn admits(self, order: Ordering) -> bool {
        match self {
            Sign::Zero => order.is_eq(),
            Sign::NonZero => order.is_ne(),
            Sign::NonNegative => order.is_ge(),
            Sign::Positive => order.is_gt(),
        }
    }
}

/// A product of powers of polynomials.
pub type Factors = Vec<(Polynomial, u32)>;

/// A combination of the facts that are equations: each by its position, with its cofactor.
pub type Cofactors = Vec<(usize, Polynomial)>;

/// Why a fact follows from others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Proof {
    /// `multiplier · goal^power = Σ cofactor · equation`, the multiplier not vanishing: the goal is 0.
    Combination {
        /// Known not to vanish, factor by factor.
        multiplier: Factors,
        /// At least 1.
        power: u32,
        /// The combination.
        cofactors: Cofactors,
    },
    /// `certain = cofactor · goal + Σ cofactor · equation`, `certain` not vanishing: the goal is not 0.
    NonVanishing {
        /// Known not to vanish, factor by factor.
        certain: Factors,
        /// The cofactor of the goal.
        cofactor: Polynomial,
        /// The combination.
        cofactors: Cofactors,
    },
    /// `multiplier · goal = Σ terms + Σ cofactor · equation`, the multiplier positive: the goal is not
    /// negative, and positive where a term is.
    Positivity {
        /// Known to be positive, factor by factor.
        multiplier: Factors,
        /// Terms that cannot be negative.
        terms: Vec<PositiveTerm>,
        /// The combination.
        cofactors: Cofactors,
    },
    /// `a ≥ 0` and `-a ≥ 0`: the goal is 0.
    BothBounds {
        /// That the goal is not negative.
        below: Box<Proof>,
        /// That its negative is not.
        above: Box<Proof>,
    },
    /// `\ln a = \ln b`: the goal, `a - b`, is 0. Of the claim's own goal only.
    Logarithms(Box<Proof>),
    /// `-a² ≥ 0`: the goal is 0. So a vanishing sum of squares makes each of its terms vanish.
    Square(Box<Proof>),
    /// `a ≥ 0` and `a² − (a − goal)² ≥ 0`: what is taken from `a` has no greater square, so the goal is not negative;
    /// it is positive where the difference of the squares is.
    Larger {
        /// `a`, seen by inspection not to be negative.
        larger: Polynomial,
        /// That the difference of the squares has the sign.
        squares: Box<Proof>,
    },
    /// What a root or a power is, `s^q = base` and `s ≥ 0`, once its base is known not to be negative.
    OfPower {
        /// The root or power.
        power: Var,
        /// The fact that says so of its base, by position.
        base: usize,
    },
}

/// `coefficient · Π factors · Π squares² · Π series · Π bounded · Π facts`: a product that cannot be negative.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PositiveTerm {
    /// Not negative.
    pub coefficient: Rational,
    /// Each is seen not to be negative by inspection, or has an even exponent.
    pub factors: Factors,
    /// Each is squared.
    pub squares: Vec<Polynomial>,
    /// Sums of squares over all elements of a sequence, or all pairs of elements.
    pub series: Vec<SeriesSquare>,
    /// Sums over all elements of a sequence of what their declared domain keeps from being negative.
    pub bounded: Vec<BoundedSeries>,
    /// Facts that are known to be non-negative or positive, by position.
    pub facts: Vec<usize>,
}

/// `Σ_{i<j} (f_i g_j − f_j g_i)² = Σ f² Σ g² − (Σ f g)²` with `f`, `g` products of elements (Lagrange's
/// identity); an empty product is 1, so `g = 1` gives `count · Σ f² − (Σ f)²`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SeriesSquare {
    /// The number of elements.
    pub count: Symbol,
    /// `f`: each sequence with its exponent.
    pub f: Vec<(Symbol, u32)>,
    /// `g`: each sequence with its exponent.
    pub g: Vec<(Symbol, u32)>,
}

/// `Σ_i f_i`; or, with a second product, `Σ_{i≠j} f_i g_j = Σ f Σ g − Σ f g`. Each of `f_i`, `g_j` is a product of
/// factors that are not negative for any element in its declared domain, so neither is the sum.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BoundedSeries {
    /// The number of elements.
    pub count: Symbol,
    /// `f`
    pub f: Vec<ElementFactor>,
    /// `g`, for pairs of different elements.
    pub g: Option<Vec<ElementFactor>>,
}

/// A power of an element, or of its distance from a bound of its domain.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ElementFactor {
    /// The sequence.
    pub sequence: Symbol,
    /// What of its element is raised.
    pub side: ElementSide,
    /// To which power.
    pub exponent: u32,
}

/// What of an element is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ElementSide {
    /// `u_i`; the exponent must be even.
    Own,
    /// `u_i − a`, with `a` the lower bound of the domain.
    AboveLower,
    /// `b − u_i`, with `b` the upper bound.
    BelowUpper,
}

/// Exact values for the symbols of a claim.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Assignment {
    /// The hypotheses `symbol = term` that are put in first; their symbols need no value.
    pub unfold: Vec<usize>,
    /// The value of each symbol.
    pub symbols: Map<Symbol, BigRational>,
    /// The elements of each sequence.
    pub sequences: Map<Symbol, Vec<BigRational>>,
    /// The value of `ds/dx` at the point, for symbols `s` of which nothing else is said, or in a course.
    pub derivatives: Map<(Symbol, Symbol), BigRational>,
    /// How everything can move through the point, where laws tie derivatives together.
    pub course: Option<Course>,
    /// The values of sines, cosines, exponentials and logarithms, by call, in place of a value for the one symbol in
    /// their argument that has none; and of unknown functions that are constant.
    pub functions: Map<Expr, BigRational>,
    /// Values `Σ c_k π^k` by their coefficients, for symbols that have no rational one.
    pub in_pi: Map<Symbol, Vec<BigRational>>,
    /// Values in terms of one irrational root, where there are such.
    pub algebraic: Option<Box<Algebraic>>,
}

/// Values `Σ c_k α^k`, where α is the one root of a polynomial between two numbers. Lists of coefficients begin with
/// the constant one.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Algebraic {
    /// The polynomial that vanishes at α. It has no root more than once.
    pub polynomial: Vec<BigRational>,
    /// Below α, above all smaller roots.
    pub low: BigRational,
    /// Above α, below all greater roots.
    pub high: BigRational,
    /// The symbols that have such a value.
    pub symbols: Map<Symbol, Vec<BigRational>>,
    /// The values of roots, by the term `base^(1/q)`.
    pub roots: Map<Expr, Vec<BigRational>>,
}

/// How symbols that are differentiated move through a point.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Course {
    /// The second derivative of a symbol and those above it, by symbol and variable.
    pub higher: Map<(Symbol, Symbol), Vec<BigRational>>,
    /// For each law that speaks of something that moves, by its position among the hypotheses, what it is to be solved
    /// for: the highest derivative of a symbol, or a symbol of which no derivative occurs. Each leads one law.
    pub leads: Map<usize, Expr>,
}

impl Certificate {
    /// Every polynomial in it.
    pub fn polynomials(&self) -> Vec<&Polynomial> {
        let mut all: Vec<&Polynomial> = self.lemmas.iter().map(|l| &l.fact.polynomial).collect();
        let proofs = self
            .lemmas
            .iter()
            .map(|l| &l.proof)
            .chain([&self.conclusion]);
        proofs.for_each(|proof| proof.collect_polynomials(&mut all));
        all
    }
}

impl Proof {
    /// `a² − (a − goal)²`, what [`Proof::Larger`] asks the sign of.
    ///
    /// # Errors
    /// It is too large to multiply out.
    pub fn difference_of_squares(
        larger: &Polynomial,
        goal: &Polynomial,
    ) -> Result<Polynomial, TooLarge> {
        Ok(larger.pow(2)?.minus(&larger.minus(goal).pow(2)?))
    }

    fn collect_polynomials<'a>(&'a self, all: &mut Vec<&'a Polynomial>) {
        match self {
            Proof::Combination {
                multiplier: factors,
                cofactors,
                ..
            } => {
                all.extend(
                    factors
                        .iter()
                        .map(|f| &f.0)
                        .chain(cofactors.iter().map(|c| &c.1)),
                );
            }
            Proof::NonVanishing {
                certain,
                cofactor,
                cofactors,
            } => {
                all.push(cofactor);
                all.extend(
                    certain
                        .iter()
                        .map(|f| &f.0)
                        .chain(cofactors.iter().map(|c| &c.1)),
                );
            }
            Proof::Positivity {
                multiplier,
                terms,
                cofactors,
            } => {
                all.extend(
                    multiplier
                        .iter()
                        .map(|f| &f.0)
                        .chain(cofactors.iter().map(|c| &c.1)),
                );
                for term in terms {
                    all.extend(term.factors.iter().map(|f| &f.0).chain(&term.squares));
                }
            }
            Proof::BothBounds { below, above } => {
                below.collect_polynomials(all);
                above.collect_polynomials(all);
            }
            Proof::Square(inner) | Proof::Logarithms(inner) => inner.collect_polynomials(all),
            Proof::Larger { larger, squares } => {
                all.push(larger);
                squares.collect_polynomials(all);
            }
            Proof::OfPower { .. } => {}
        }
    }
}
