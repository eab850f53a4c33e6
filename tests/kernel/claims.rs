//! Claims in notation, and certificates about them.

use cradle_verify::algebra::{BigRational, Expr, Formula, Lowering, Polynomial, Symbol};
use cradle_verify::document::Span;
use cradle_verify::kernel::{
    Assignment, Candidate, Certificate, Checked, Claim, Cofactors, Domain, Factors, Hypothesis,
    Lemma, Origin, PositiveTerm, Problem, Proof, Reject, Standing, check,
};
use cradle_verify::notation::{Clause, read_expr, read_formulas};
use cradle_verify::sorted::{Map, Set};

pub fn symbol(name: &str) -> Symbol {
    Symbol::new(name)
}

pub fn number(value: i64) -> BigRational {
    BigRational::from_integer(value.into())
}

pub fn ratio(above: i64, below: i64) -> BigRational {
    BigRational::new(above.into(), below.into())
}

pub fn term(text: &str) -> Expr {
    read_expr(text, Span::new(0, text.len())).unwrap_or_else(|e| panic!("{text}: {}", e.message))
}

/// One formula.
pub fn formula(text: &str) -> Formula {
    let read = read_formulas(text, Span::new(0, text.len()))
        .unwrap_or_else(|e| panic!("{text}: {}", e.message));
    let [statement] = read.as_slice() else {
        panic!("{text} is not one statement");
    };
    match statement.clauses.as_slice() {
        [Clause::Chain { sides, links }] if links.len() == 1 => Formula::Relation {
            left: sides[0].expr.clone(),
            relation: links[0].relation,
            right: sides[1].expr.clone(),
        },
        [
            Clause::AllEqual {
                sequence,
                to,
                value,
                ..
            },
        ] => Formula::AllEqual {
            sequence: sequence.clone(),
            to: to.clone(),
            value: value.as_ref().map(|side| side.expr.clone()),
        },
        _ => panic!("{text} is not one formula"),
    }
}

/// `hypotheses ⊢ goal`, nothing being said of any symbol.
pub fn claim(hypotheses: &[&str], goal: &str) -> Claim {
    let assumed = |text: &&str| Hypothesis {
        formula: formula(text).into(),
        standing: Standing::Identity,
    };
    Claim {
        domains: Map::new(),
        sequences: Map::new(),
        hypotheses: hypotheses.iter().map(assumed).collect(),
        goal: formula(goal),
    }
}

pub fn positive() -> Domain {
    Domain {
        lower: Some((number(0), true)),
        ..Domain::default()
    }
}

pub fn constant() -> Domain {
    Domain {
        constant: true,
        ..Domain::default()
    }
}

/// Changes to a claim, to be chained.
pub trait Where {
    fn domain(self, name: &str, domain: Domain) -> Self;
    fn sequence(self, name: &str) -> Self;
    fn at_point(self, position: usize) -> Self;
}

impl Where for Claim {
    fn domain(mut self, name: &str, domain: Domain) -> Self {
        self.domains.insert(symbol(name), domain);
        self
    }

    fn sequence(mut self, name: &str) -> Self {
        self.sequences.insert(symbol(name), Domain::default());
        self
    }

    fn at_point(mut self, position: usize) -> Self {
        self.hypotheses[position].standing = Standing::AtPoint;
        self
    }
}

/// A claim being proved: its unknowns, its facts, and the certificate so far.
#[derive(Clone)]
pub struct Proving {
    pub claim: Claim,
    pub problem: Problem,
    pub unfold: Vec<usize>,
    pub lemmas: Vec<Lemma>,
}

impl Proving {
    pub fn new(claim: Claim) -> Self {
        Self::unfolding(claim, &[])
    }

    pub fn unfolding(claim: Claim, unfold: &[usize]) -> Self {
        let problem = Problem::new(&claim, unfold).expect("a claim that can be read");
        Proving {
            claim,
            problem,
            unfold: unfold.to_vec(),
            lemmas: Vec::new(),
        }
    }

    /// A polynomial in the unknowns of the claim.
    pub fn p(&self, text: &str) -> Polynomial {
        let (mut atoms, known) = (self.problem.atoms.clone(), self.problem.atoms.len());
        let value = Lowering {
            sequences: &self.claim.sequences.keys().cloned().collect(),
            constants: &Set::new(),
            ..Lowering::plain(&mut atoms)
        }
        .lower(&term(text))
        .expect("a term");
        assert_eq!(atoms.len(), known, "{text} has unknowns of its own");
        value.as_polynomial().expect("a polynomial").clone()
    }

    /// Where the first fact of a hypothesis is.
    pub fn hypothesis(&self, position: usize) -> usize {
        let own = |o: &Origin| *o == Origin::Hypothesis(position);
        self.problem.origins.iter().position(own).expect("a fact")
    }

    pub fn factors(&self, factors: &[(&str, u32)]) -> Factors {
        factors.iter().map(|&(f, e)| (self.p(f), e)).collect()
    }

    /// Each hypothesis with its cofactor.
    pub fn cofactors(&self, cofactors: &[(usize, &str)]) -> Cofactors {
        let cofactor = |&(at, text): &(usize, &str)| (self.hypothesis(at), self.p(text));
        cofactors.iter().map(cofactor).collect()
    }

    pub fn combination(
        &self,
        multiplier: &[(&str, u32)],
        power: u32,
        cofactors: &[(usize, &str)],
    ) -> Proof {
        Proof::Combination {
            multiplier: self.factors(multiplier),
            power,
            cofactors: self.cofactors(cofactors),
        }
    }

    pub fn non_vanishing(
        &self,
        certain: &[(&str, u32)],
        cofactor: &str,
        cofactors: &[(usize, &str)],
    ) -> Proof {
        Proof::NonVanishing {
            certain: self.factors(certain),
            cofactor: self.p(cofactor),
            cofactors: self.cofactors(cofactors),
        }
    }

    pub fn positivity(
        &self,
        multiplier: &[(&str, u32)],
        terms: Vec<PositiveTerm>,
        cofactors: &[(usize, &str)],
    ) -> Proof {
        Proof::Positivity {
            multiplier: self.factors(multiplier),
            terms,
            cofactors: self.cofactors(cofactors),
        }
    }

    /// What the kernel says of a proof of the goal.
    pub fn checked(&self, conclusion: Proof) -> Result<(), Reject> {
        let certificate = Certificate {
            rates: Vec::new(),
            unfold: self.unfold.clone(),
            lemmas: self.lemmas.clone(),
            conclusion,
        };
        match check(self.claim.clone(), Candidate::Proof(certificate.clone()))? {
            Checked::Proven(proven) => {
                assert_eq!(proven.claim(), &self.claim);
                assert_eq!(proven.certificate(), &certificate);
                Ok(())
            }
            Checked::Refuted(_) => panic!("a proof refutes nothing"),
        }
    }

    /// What the kernel says of the proof that the goal is 0 = 0.
    pub fn trivially(&self) -> Result<(), Reject> {
        self.checked(self.combination(&[], 1, &[]))
    }
}

/// 1, to be made into another term that is not negative.
pub fn one() -> PositiveTerm {
    PositiveTerm {
        coefficient: 1.into(),
        factors: Vec::new(),
        squares: Vec::new(),
        series: Vec::new(),
        bounded: Vec::new(),
        facts: Vec::new(),
    }
}

pub fn point(symbols: &[(&str, i64)]) -> Assignment {
    let value = |&(name, value): &(&str, i64)| (symbol(name), number(value));
    Assignment {
        symbols: symbols.iter().map(value).collect(),
        ..Assignment::default()
    }
}

/// More about a point, to be chained.
pub trait With {
    fn list(self, sequence: &str, elements: &[i64]) -> Self;
    fn slope(self, of: &str, by: &str, value: i64) -> Self;
    fn unfolding(self, hypotheses: &[usize]) -> Self;
    fn fraction(self, name: &str, above: i64, below: i64) -> Self;
}

impl With for Assignment {
    fn list(mut self, sequence: &str, elements: &[i64]) -> Self {
        let elements = elements.iter().map(|&e| number(e)).collect();
        self.sequences.insert(symbol(sequence), elements);
        self
    }

    fn slope(mut self, of: &str, by: &str, value: i64) -> Self {
        let key = (symbol(of), symbol(by));
        self.derivatives.insert(key, number(value));
        self
    }

    fn unfolding(mut self, hypotheses: &[usize]) -> Self {
        self.unfold = hypotheses.to_vec();
        self
    }

    fn fraction(mut self, name: &str, above: i64, below: i64) -> Self {
        self.symbols.insert(symbol(name), ratio(above, below));
        self
    }
}

/// What the kernel says of a counterexample.
pub fn refuted(claim: &Claim, point: Assignment) -> Result<(), Reject> {
    match check(claim.clone(), Candidate::Counterexample(point.clone()))? {
        Checked::Refuted(refuted) => {
            assert_eq!(refuted.claim(), claim);
            assert_eq!(refuted.witness(), &point);
            Ok(())
        }
        Checked::Proven(_) => panic!("a counterexample proves nothing"),
    }
}
