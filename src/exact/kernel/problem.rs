use std::sync::Arc;

use num_traits::Zero;

use super::functions::pi_is_the_number;
use super::powers::powers_of;
use super::{Claim, Domain, Fact, Hypothesis, Reject, Sign, Standing};
use crate::algebra::{
    Atom, Atoms, BigRational, Conditions, Expr, Formula, Fraction, Functions, Lowering, Polynomial,
    Powers, Rational, Relation, Symbol, element_parts, element_symbol, expr_of, power_sum,
};
use crate::sorted::{self, Map, Set};

/// A claim as facts about polynomials: what certificates speak of.
///
/// Made from the claim alone, in one way only, so that the search and the kernel mean the same by
/// "fact 3".
#[derive(Clone, Debug)]
pub struct Problem {
    /// The unknowns.
    pub atoms: Atoms,
    /// What is known.
    pub facts: Vec<Fact>,
    /// Where each fact comes from.
    pub origins: Vec<Origin>,
    /// What is to be shown.
    pub goal: Fact,
    /// What must be known for the goal to be defined at all.
    pub conditions: Conditions,
    pub(super) readings: Vec<Reading>,
    pub(super) integers: Vec<Fraction>,
    pub(super) sequences: Set<Symbol>,
    /// The declared domains of elements.
    elements: Map<Symbol, Domain>,
    /// The symbols that are known to be natural numbers, for sums go up to them.
    counts: Set<Symbol>,
    pub(super) constants: Set<Symbol>,
    /// Symbols that a premise says do not depend on another.
    still: Set<(Symbol, Symbol)>,
    /// How powers are taken apart; `None` where terms are read as they are written.
    pub(super) powers: Option<Powers>,
    /// What is known of symbols where functions are taken apart; `None` where there is nothing.
    pub(super) functions: Option<Functions>,
    pub(super) formulas: Vec<(Arc<Formula>, Standing)>,
    pub(super) goal_formula: Formula,
}

/// Where a fact comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The hypothesis at this position.
    Hypothesis(usize),
    /// The hypothesis at this position, differentiated.
    Rate(usize),
    /// The declared domain of a symbol.
    Domain(Symbol),
    /// The nature of sums: counts and even power sums are not negative.
    Sums,
    /// The nature of roots and powers: the power of a root is what it is taken of.
    Powers,
    /// The nature of functions: sin² + cos² = 1; and of `\pi`.
    Functions,
    /// A lemma of the certificate.
    Lemma,
}

/// A premise as it is evaluated at a point: `None` where its relation has no exact meaning there.
#[derive(Clone, Debug)]
pub(super) struct Reading {
    pub fact: Option<Fact>,
    pub conditions: Conditions,
}

impl Problem {
    /// The facts that a claim gives once the hypotheses `unfold` are put in.
    ///
    /// # Errors
    /// A hypothesis that cannot be put in, a goal whose relation certificates do not speak of, or a
    /// term that is too large or divides by 0.
    pub fn new(claim: &Claim, unfold: &[usize]) -> Result<Problem, Reject> {
        Problem::read_as(claim, unfold, true)
    }

    /// The same with every power read as it is written: what points are evaluated with.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn as_written(claim: &Claim, unfold: &[usize]) -> Result<Problem, Reject> {
        Problem::read_as(claim, unfold, false)
    }

    /// Whether powers are taken apart in it, so that it is not the same as written.
    pub fn takes_powers_apart(&self) -> bool {
        self.powers.is_some()
    }

    /// Whether `\pi` is the number in it, and not a symbol of the author's.
    pub fn pi_is_the_number(&self) -> bool {
        self.functions.as_ref().is_some_and(|f| f.pi)
    }

    fn read_as(claim: &Claim, unfold: &[usize], apart: bool) -> Result<Problem, Reject> {
        if let Some(slope) = by_whole_number(claim) {
            return Err(Reject::MayHaveNoValue(slope));
        }
        let sequences = sequences(claim);
        let (formulas, goal, values) = unfolded(claim, unfold, &sequences)?;
        let named = claim.free_symbols();
        let pi = named.iter().any(|s| s.name() == "\\pi") && pi_is_the_number(claim);
        // Whatever is said of it, a number is no other term.
        if pi && let Some(at) = values.iter().position(|v| v.0.name() == "\\pi") {
            return Err(Reject::NotUnfoldable(at));
        }
        let counts = counts(claim);
        let powers = {
            let all = formulas.iter().map(|f| &*f.0).chain([&goal]);
            let terms = all
                .flat_map(Formula::terms)
                .chain(values.iter().map(|v| &v.1));
            let put_in = |symbol: &Symbol| values.iter().any(|v| v.0 == *symbol);
            powers_of(claim, pi, terms, &sequences, &counts, put_in)
        };
        let (powers, functions) = powers.unzip();
        let functions = (pi || functions.is_some()).then(|| Functions {
            pi,
            ..functions.unwrap_or_default()
        });
        let constants = constants(claim, &named, pi);
        // Most hypotheses and most domains say one thing, or two.
        let likely = 2 * (claim.hypotheses.len() + claim.domains.len());
        let mut problem = Problem {
            atoms: Atoms::default(),
            facts: Vec::with_capacity(likely),
            origins: Vec::with_capacity(likely),
            goal: Fact {
                polynomial: Polynomial::zero(),
                sign: Sign::Zero,
            },
            conditions: Conditions::default(),
            readings: Vec::with_capacity(likely),
            integers: Vec::new(),
            sequences,
            elements: claim.sequences.clone(),
            counts: counts.clone(),
            constants,
            still: still(claim),
            powers: powers.filter(|_| apart),
            functions,
            formulas: Vec::new(),
            goal_formula: Formula::equal(Expr::integer(0), Expr::integer(0)),
        };
        let (fact, conditions) = problem.read(&goal)?;
        problem.goal = fact.ok_or(Reject::UnsupportedRelation)?;
        problem.conditions = conditions;
        problem.goal_formula = goal;
        if let Some(powers) = &mut problem.powers {
            powers.cautious = true;
        }
        for (position, (formula, _)) in formulas.iter().enumerate() {
            problem.assume(formula, Origin::Hypothesis(position))?;
        }
        problem.formulas = formulas;
        let natural = Domain {
            lower: Some((BigRational::from_integer(0.into()), false)),
            integer: true,
            ..Domain::default()
        };
        let mut every = named.clone();
        every.extend(&counts);
        sorted::sort(&mut every);
        every.dedup();
        for symbol in every {
            if !claim.domains.contains_key(symbol) && !counts.contains(symbol) {
                continue;
            }
            let own = Expr::Symbol(symbol.clone());
            let term = values
                .iter()
                .find(|v| v.0 == *symbol)
                .map_or(&own, |v| &v.1);
            // A sum up to something that is not a natural number is no sum.
            let counted = counts.contains(symbol).then_some((&natural, Origin::Sums));
            let declared = claim
                .domains
                .get(symbol)
                .map(|d| (d, Origin::Domain(symbol.clone())));
            for (domain, origin) in declared.into_iter().chain(counted) {
                problem.confine(term, domain, &origin)?;
                if domain.integer {
                    let value = problem.lowering().lower(term)?;
                    problem.integers.push(value);
                }
            }
        }
        // Elements of sums that were written out are named nowhere else.
        let atoms = problem.atoms.iter().filter_map(|(_, atom)| match atom {
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
                problem.confine(&term, domain, &Origin::Domain(symbol))?;
            }
        }
        problem.add_facts_about_sums(claim)?;
        let roots = problem.atoms.iter().filter_map(|(var, atom)| match atom {
            Atom::Root { of, .. } => Some((var, of.clone())),
            _ => None,
        });
        for (var, of) in roots.collect::<Vec<_>>() {
            problem.add(Polynomial::var(var), Sign::Positive, Origin::Domain(of));
        }
        problem.add_facts_about_pi();
        problem.add_facts_about_powers()?;
        problem.add_facts_about_functions()?;
        Ok(problem)
    }

    /// Whether a hypothesis says that a polynomial vanishes throughout: that a slope vanishes at one point
    /// holds nothing constant.
    pub fn vanishes_throughout(&self, polynomial: &Polynomial) -> bool {
        let throughout = |origin: &Origin| match origin {
            Origin::Hypothesis(at) => {
                let formula = self.formulas.get(*at);
                formula.is_some_and(|f| f.1 == Standing::Identity)
            }
            _ => false,
        };
        let monic = polynomial.monic();
        let mut facts = self.facts.iter().zip(&self.origins);
        facts.any(|(f, origin)| {
            f.sign == Sign::Zero && f.polynomial.monic() == monic && throughout(origin)
        })
    }

    /// Whether a sum goes up to a symbol, outside of any sum that binds it as an index.
    pub(super) fn is_count(&self, symbol: &Symbol) -> bool {
        self.counts.contains(symbol)
    }

    /// Where the elements of a sequence lie, all of them, as far as it is declared.
    pub fn element_domain(&self, sequence: &Symbol) -> Option<&Domain> {
        self.elements.get(sequence)
    }

    pub(super) fn lowering(&mut self) -> Lowering<'_> {
        Lowering {
            sequences: &self.sequences,
            constants: &self.constants,
            still: &self.still,
            powers: self.powers.as_ref(),
            functions: self.functions.as_ref(),
            ..Lowering::plain(&mut self.atoms)
        }
    }

    /// The hypotheses and the goal, with what is put in.
    pub(super) fn statements(&self) -> impl Iterator<Item = &Formula> + Clone {
        let hypotheses = self.formulas.iter().map(|own| &*own.0);
        hypotheses.chain([&self.goal_formula])
    }

    /// Reads further terms in the way of this problem, over a copy of its unknowns.
    pub fn lowering_over<'a>(&'a self, atoms: &'a mut Atoms) -> Lowering<'a> {
        Lowering {
            sequences: &self.sequences,
            constants: &self.constants,
            still: &self.still,
            powers: self.powers.as_ref(),
            functions: self.functions.as_ref(),
            ..Lowering::plain(atoms)
        }
    }

    pub(super) fn add(&mut self, polynomial: Polynomial, sign: Sign, origin: Origin) {
        self.facts.push(Fact { polynomial, sign });
        self.origins.push(origin);
    }

    /// A formula as a fact. `None` for relations that say nothing exact.
    fn read(&mut self, formula: &Formula) -> Result<(Option<Fact>, Conditions), Reject> {
        let mut lowering = self.lowering();
        let (left, relation, right) = match formula {
            Formula::Relation {
                left,
                relation,
                right,
            } => (lowering.lower(left)?, *relation, lowering.lower(right)?),
            // u_1 = … = u_n (= w)  ⇔  n Σu² − (Σu)² = 0  (Σu² − 2w Σu + n w² = 0)
            Formula::AllEqual {
                sequence,
                to,
                value,
            } => {
                let square = Expr::Power(
                    Expr::Element {
                        sequence: sequence.clone(),
                        index: Symbol::new("i"),
                    }
                    .into(),
                    Expr::integer(2).into(),
                );
                let element = Expr::Element {
                    sequence: sequence.clone(),
                    index: Symbol::new("i"),
                };
                let sum = |body: Expr| Expr::Series {
                    index: Symbol::new("i"),
                    from: Expr::integer(1).into(),
                    to: to.clone().into(),
                    body: body.into(),
                };
                let (first, second) = (
                    lowering.lower(&sum(element))?,
                    lowering.lower(&sum(square))?,
                );
                let count = lowering.lower(to)?;
                let spread = match value {
                    None => count.times(&second)?.plus(&first.pow(2)?.negated())?,
                    Some(value) => {
                        let value = lowering.lower(value)?;
                        let two = Fraction::from(Rational::from(2));
                        let middle = two.times(&value)?.times(&first)?.negated();
                        second.plus(&middle)?.plus(&count.times(&value.pow(2)?)?)?
                    }
                };
                (spread, Relation::Equal, Fraction::default())
            }
        };
        let conditions = lowering.conditions;
        Ok((compared(&left, relation, &right)?, conditions))
    }

    /// Assumes that a term lies in a domain; that it is an integer is not among the facts.
    fn confine(&mut self, term: &Expr, domain: &Domain, origin: &Origin) -> Result<(), Reject> {
        let mut bounds = domain.bounds().peekable();
        if bounds.peek().is_none() {
            return Ok(());
        }
        let mut lowering = self.lowering();
        let value = lowering.lower(term)?;
        let conditions = lowering.conditions;
        for (relation, bound) in bounds {
            let fact = compared(&value, relation, &Rational::from(bound).into())?;
            self.take(fact, conditions.clone(), origin);
        }
        Ok(())
    }

    fn assume(&mut self, formula: &Formula, origin: Origin) -> Result<(), Reject> {
        let (fact, conditions) = match super::scaling::sides(formula) {
            // At one point a relation between two says no more than that neither side is 0.
            Some((left, right)) => {
                let both = Expr::Product(vec![left.clone(), right.clone()]);
                self.read(&Formula::nonzero(both))?
            }
            None => self.read(formula)?,
        };
        let fact = match fact {
            Some(fact) => away_from(fact, &conditions.away)?,
            None => None,
        };
        self.take(fact, conditions, &origin);
        Ok(())
    }

    fn take(&mut self, fact: Option<Fact>, conditions: Conditions, origin: &Origin) {
        // A limit that was taken with something held constant means what was read only if that is so.
        let fact = fact.filter(|_| conditions.zero.is_empty());
        if let Some(fact) = fact.clone() {
            self.add(fact.polynomial, fact.sign, origin.clone());
            // What is asserted is defined.
            for factor in &conditions.nonzero {
                self.add(factor.clone(), Sign::NonZero, origin.clone());
            }
            for base in &conditions.nonnegative {
                self.add(base.clone(), Sign::NonNegative, origin.clone());
            }
            for base in &conditions.positive {
                self.add(base.clone(), Sign::Positive, origin.clone());
            }
        }
        self.readings.push(Reading { fact, conditions });
    }

    /// Counts and even power sums are not negative; equal elements make every power sum a multiple of one power.
    fn add_facts_about_sums(&mut self, claim: &Claim) -> Result<(), Reject> {
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

/// `left relation right` as a fact. `None` for relations that say nothing exact.
fn compared(left: &Fraction, relation: Relation, right: &Fraction) -> Result<Option<Fact>, Reject> {
    let value = match relation {
        Relation::Less | Relation::LessOrEqual => right.minus(left)?,
        _ => left.minus(right)?,
    };
    let sign = match relation {
        Relation::Equal => Sign::Zero,
        Relation::NotEqual => Sign::NonZero,
        Relation::Less | Relation::Greater => Sign::Positive,
        Relation::LessOrEqual | Relation::GreaterOrEqual => Sign::NonNegative,
        _ => return Ok(None),
    };
    let (mut polynomial, denominator) = value.into_parts();
    if matches!(sign, Sign::Positive | Sign::NonNegative) {
        // P / Q has the sign of P times the factors of Q with an odd exponent.
        for (factor, exponent) in denominator {
            if exponent % 2 == 1 {
                polynomial = polynomial.times(&factor)?;
            }
        }
    }
    Ok(Some(Fact { polynomial, sign }))
}

type Unfolded = (Vec<(Arc<Formula>, Standing)>, Formula, Vec<(Symbol, Expr)>);

/// Puts hypotheses `symbol = term` in everywhere, in order, and says what each symbol became.
fn unfolded(claim: &Claim, unfold: &[usize], sequences: &Set<Symbol>) -> Result<Unfolded, Reject> {
    let hypotheses = claim.hypotheses.iter();
    let mut formulas: Vec<_> = hypotheses
        .map(|h| (h.formula.clone(), h.standing))
        .collect();
    let mut goal = claim.goal.clone();
    let mut values: Vec<(Symbol, Expr)> = Vec::new();
    for &position in unfold {
        let (formula, standing) = formulas.get(position).ok_or(Reject::NoSuchFact(position))?;
        if let Some((applied, term)) = applied_definition(formula) {
            // A law about a function holds for all of its arguments, under an integral too.
            let captured = |f: &Formula| f.terms().iter().any(|t| captures(t, &term));
            let throughout = *standing == Standing::Identity;
            if !throughout || formulas.iter().map(|f| &*f.0).chain([&goal]).any(captured) {
                return Err(Reject::NotUnfoldable(position));
            }
            for (formula, _) in &mut formulas {
                *formula = formula.map_terms(|t| t.replace(&applied, &term)).into();
            }
            goal = goal.map_terms(|t| t.replace(&applied, &term));
            for (_, value) in &mut values {
                *value = value.replace(&applied, &term);
            }
            continue;
        }
        let (symbol, term) = definition(formula).ok_or(Reject::NotUnfoldable(position))?;
        let all = || formulas.iter().map(|f| &*f.0).chain([&goal]);
        let moving = |f: &Formula| f.terms().iter().any(|t| moves(t, &symbol));
        let captured = |f: &Formula| f.terms().iter().any(|t| captures(t, &term));
        // An element is named by its sequence too, under a sum and in the sequence's domain.
        let element = element_parts(&symbol).map(|parts| parts.0);
        let named = sequences.contains(&symbol) || element.is_some_and(|e| sequences.contains(&e));
        let derived_by = |f: &Formula| f.terms().iter().any(|t| is_variable(t, &symbol));
        let stuck = *standing == Standing::AtPoint && all().any(moving);
        if stuck || named || all().any(captured) || all().any(derived_by) {
            return Err(Reject::NotUnfoldable(position));
        }
        let pointwise = *standing == Standing::AtPoint;
        for (formula, standing) in &mut formulas {
            if !formula.terms().iter().any(|t| t.mentions(&symbol)) {
                continue;
            }
            let changed = formula.map_terms(|t| t.substitute(&symbol, &term));
            // A law into which a value was put says something of this point only.
            if pointwise && changed != **formula {
                *standing = Standing::AtPoint;
            }
            *formula = changed.into();
        }
        goal = goal.map_terms(|t| t.substitute(&symbol, &term));
        for (_, value) in &mut values {
            *value = value.substitute(&symbol, &term);
        }
        values.push((symbol, term));
    }
    Ok((formulas, goal, values))
}

/// What a premise says if something vanishes, too, where its terms are read as if that did not: nothing then.
fn away_from(fact: Fact, away: &Set<Polynomial>) -> Result<Option<Fact>, Reject> {
    let Fact {
        mut polynomial,
        mut sign,
    } = fact;
    for factor in away {
        polynomial = match sign {
            Sign::Zero => polynomial.times(factor)?,
            Sign::NonNegative | Sign::Positive => {
                sign = Sign::NonNegative;
                polynomial.times(factor)?.times(factor)?
            }
            Sign::NonZero => return Ok(None),
        };
    }
    Ok(Some(Fact { polynomial, sign }))
}

/// `symbol = term`, the term not mentioning the symbol.
pub fn definition(formula: &Formula) -> Option<(Symbol, Expr)> {
    let (left, right) = formula.as_equation()?;
    let solved = |a: &Expr, b: &Expr| match a {
        Expr::Symbol(symbol) if !b.mentions(symbol) => Some((symbol.clone(), b.clone())),
        _ => None,
    };
    solved(left, right).or_else(|| solved(right, left))
}

/// `F(x) = term`, the term not mentioning the function and no lone symbol.
pub(crate) fn applied_definition(formula: &Formula) -> Option<(Expr, Expr)> {
    let (left, right) = formula.as_equation()?;
    if definition(formula).is_some() {
        return None;
    }
    let solved = |a: &Expr, b: &Expr| match a {
        Expr::Apply(function, _) if !b.mentions(function) => Some((a.clone(), b.clone())),
        _ => None,
    };
    solved(left, right).or_else(|| solved(right, left))
}

/// The symbols that name sequences, declared or not.
pub(super) fn sequences(claim: &Claim) -> Set<Symbol> {
    let mut all = Formula::sequences_of(claim.formulas());
    all.extend(claim.sequences.keys().cloned());
    all
}

/// A derivative by what is always a whole number: there is none.
fn by_whole_number(claim: &Claim) -> Option<Expr> {
    let whole = |symbol: &Symbol| claim.domains.get(symbol).is_some_and(|d| d.integer);
    if !claim.domains.values().any(|domain| domain.integer) {
        return None;
    }
    fn find(term: &Expr, whole: &impl Fn(&Symbol) -> bool) -> Option<Expr> {
        match term {
            Expr::Derivative { variable, .. } | Expr::Partial { variable, .. }
                if whole(variable) =>
            {
                Some(term.clone())
            }
            term => term.children().find_map(|child| find(child, whole)),
        }
    }
    let mut terms = claim.formulas().flat_map(Formula::terms);
    terms.find_map(|term| find(term, &whole))
}

/// The symbols that depend on no variable, and the sequences whose elements do not.
fn constants(claim: &Claim, named: &[&Symbol], pi: bool) -> Set<Symbol> {
    let declared = claim.domains.iter().filter(|(_, d)| d.constant);
    // `x` may be something else than the elements `x_i`.
    let sequences = (claim.sequences.iter()).filter(|(s, d)| d.constant && !named.contains(s));
    let symbols = declared.chain(sequences).map(|(symbol, _)| symbol.clone());
    symbols.chain(pi.then(|| Symbol::new("\\pi"))).collect()
}

/// The symbols of which a premise says throughout that they do not depend on another, `dk/ds = 0`, by which is integrated or which goes
/// to a limit.
fn still(claim: &Claim) -> Set<(Symbol, Symbol)> {
    let integrated = |variable: &Symbol| {
        let over = |part: &Expr| match part {
            Expr::Integral { variable: own, .. } | Expr::Limit { variable: own, .. } => {
                own == variable
            }
            _ => false,
        };
        let mut terms = claim.formulas().flat_map(Formula::terms);
        terms.any(|term| term.any(&over))
    };
    let laws = claim.hypotheses.iter();
    let laws = laws.filter(|own| own.standing == Standing::Identity);
    let pair = |law: &Hypothesis| match law.formula.as_equation()? {
        (Expr::Derivative { body, variable }, Expr::Number(zero)) if zero.is_zero() => {
            match &**body {
                Expr::Symbol(symbol) if integrated(variable) => {
                    Some((symbol.clone(), variable.clone()))
                }
                _ => None,
            }
        }
        _ => None,
    };
    laws.filter_map(pair).collect()
}

/// The symbols that say how many elements there are. A sum up to the index of another says nothing of the symbol
/// outside of it.
fn counts(claim: &Claim) -> Set<Symbol> {
    fn collect<'a>(expr: &'a Expr, bound: &mut Vec<&'a Symbol>, found: &mut Set<Symbol>) {
        if let Expr::Series { to, .. } = expr
            && let Expr::Symbol(count) = &**to
            && !bound.contains(&count)
        {
            found.insert(count.clone());
        }
        let scope = expr.binder().and_then(|_| expr.scope());
        let Some((own, body, outside)) = scope else {
            let children = expr.children();
            return children.for_each(|child| collect(child, bound, found));
        };
        outside.into_iter().for_each(|e| collect(e, bound, found));
        bound.push(own);
        collect(body, bound, found);
        bound.pop();
    }
    let mut found = Set::new();
    for formula in claim.formulas() {
        formula
            .terms()
            .into_iter()
            .for_each(|term| collect(term, &mut Vec::new(), &mut found));
        if let Formula::AllEqual {
            to: Expr::Symbol(count),
            ..
        } = formula
        {
            found.insert(count.clone());
        }
    }
    found
}

/// Whether a symbol stands where it is differentiated, integrated or taken to a limit, or is what that is done by.
fn moves(term: &Expr, symbol: &Symbol) -> bool {
    term.any(&|part| match part {
        Expr::Derivative { .. }
        | Expr::Partial { .. }
        | Expr::Limit { .. }
        | Expr::Integral { .. } => part.mentions(symbol),
        _ => false,
    })
}

/// Whether a symbol is what is differentiated by, is held fixed meanwhile, goes to a limit or is integrated over: putting a term in its
/// place elsewhere would sever the two.
fn is_variable(term: &Expr, symbol: &Symbol) -> bool {
    term.any(&|part| match part {
        Expr::Series { .. } => false,
        Expr::Partial { variable, .. } => variable == symbol || part.held().contains(symbol),
        _ => part.binder() == Some(symbol),
    })
}

/// Whether a sum binds an index that occurs in `value` outside of any sum of its own.
fn captures(term: &Expr, value: &Expr) -> bool {
    term.any(&|part| matches!(part, Expr::Series { index, .. } if is_free(index, value)))
}

fn is_free(index: &Symbol, term: &Expr) -> bool {
    match term {
        Expr::Series { .. } => term.scope().is_some_and(|(own, body, outside)| {
            let mut outside = outside.into_iter();
            own != index && is_free(index, body) || outside.any(|e| is_free(index, e))
        }),
        Expr::Symbol(own) | Expr::Apply(own, _) if own == index => true,
        Expr::Element {
            sequence,
            index: own,
        } => sequence == index || own == index,
        _ => term.binder() == Some(index) || term.children().any(|e| is_free(index, e)),
    }
}
