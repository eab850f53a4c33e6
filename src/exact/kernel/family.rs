//! Counterexamples without end: one for every whole number from some least one on.
//!
//! A [`Family`] says in terms of that number what the symbols of a claim and the elements of its sequences are. The
//! kernel makes ordinary claims of it, in one way only ([`Family::parts`]): that each domain is kept, that each hypothesis
//! is true and that the goal is not. Sums over all elements are written out by groups of elements that are alike:
//!
//! $$ \sum_{i=1}^{k} f(u_i) = \sum_g s_g\, f(u_g), \qquad \sum_g s_g = k, \qquad s_g \ge 0 \text{ whole} $$
//!
//! Each of these claims is to be proved by an ordinary certificate, and the first member is evaluated as any counterexample
//! is. **Trusts** nothing but [`check`].

use num_traits::{Signed, ToPrimitive};

use super::problem::sequences_and_counts;
use super::{Assignment, Candidate, Checked, Claim, Domain, Proven, Refuted, Reject, check};
use crate::algebra::{BigRational, Expr, Formula, Symbol, Values, element_parts};
use crate::sorted::{Map, Set};

/// Members with more elements than this are not written out.
const LONGEST: usize = 64;

/// A counterexample in terms of a whole number. Nothing in here is believed.
///
/// Symbols of the claim that are neither the parameter nor given a term stay free: whatever they are within their domains.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Family {
    /// The whole number.
    pub parameter: Symbol,
    /// From where on it runs.
    pub least: u32,
    /// What other symbols are.
    pub symbols: Map<Symbol, Expr>,
    /// The upper limit of all sums.
    pub count: Symbol,
    /// The elements, those that are alike together.
    pub groups: Vec<Group>,
}

/// Elements that are alike.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    /// How many.
    pub size: Expr,
    /// What each of them is, by sequence.
    pub elements: Map<Symbol, Expr>,
}

/// What a part of the proof that a family consists of counterexamples is about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FamilyPart {
    /// A symbol that is given a term lies in its domain.
    Domain(Symbol),
    /// No group has less than no elements.
    Size(usize),
    /// All groups together have as many elements as there are.
    Count,
    /// The elements of this sequence that are in this group lie in their domain.
    Elements(Symbol, usize),
    /// The hypothesis with this position is true.
    Hypothesis(usize),
    /// The goal is false.
    Goal,
}

/// A family of counterexamples to a claim, each part of it proved. Only [`check_family`] builds one.
///
/// ```compile_fail
/// use cradle_exact::kernel::{Claim, FailsThroughout, Family, Refuted};
/// fn forge(claim: Claim, family: Family, first: Refuted) -> FailsThroughout {
///     FailsThroughout { claim, family, parts: Vec::new(), first }
/// }
/// ```
#[derive(Clone, Debug)]
pub struct FailsThroughout {
    family: Family,
    parts: Vec<(FamilyPart, Proven)>,
    first: Refuted,
}

impl FailsThroughout {
    /// What was refuted.
    pub fn claim(&self) -> &Claim {
        self.first.claim()
    }

    /// Where the hypotheses are true and the goal false.
    pub fn family(&self) -> &Family {
        &self.family
    }

    /// What was proved of it, a part after another.
    pub fn parts(&self) -> &[(FamilyPart, Proven)] {
        &self.parts
    }

    /// The member for the least number.
    pub fn first(&self) -> &Refuted {
        &self.first
    }
}

/// Decides whether every member of a family is a counterexample to a claim: there must be a proof for each of its
/// [parts](Family::parts), in their order. `free` gives the first member's values of what stays free.
///
/// # Errors
/// The first reason found for which that is not shown.
pub fn check_family(
    claim: &Claim,
    family: Family,
    proofs: Vec<Proven>,
    free: &Map<Symbol, BigRational>,
) -> Result<FailsThroughout, Reject> {
    let parts = family.parts(claim)?;
    let fits = |(part, proof): (&(FamilyPart, Claim), &Proven)| part.1 == *proof.claim();
    if parts.len() != proofs.len() || !parts.iter().zip(&proofs).all(fits) {
        return Err(Reject::WrongKind);
    }
    // The free symbols have values together, so that what is said of all of them is said of something.
    let first = family.member(family.least, free)?;
    let Checked::Refuted(first) = check(claim.clone(), Candidate::Counterexample(first))? else {
        return Err(Reject::WrongKind);
    };
    let parts = parts.into_iter().map(|(part, _)| part);
    Ok(FailsThroughout {
        parts: parts.zip(proofs).collect(),
        family,
        first,
    })
}

impl Family {
    /// What has to be proved of it, each part an ordinary claim without hypotheses.
    ///
    /// # Errors
    /// A formula of the claim cannot be said of a family, or the family is none: the parameter leaves its domain, a term
    /// is no plain one in what stays free, or is not seen to be whole where it must be.
    pub fn parts(&self, claim: &Claim) -> Result<Vec<(FamilyPart, Claim)>, Reject> {
        self.is_possible(claim)?;
        let mut parts = Vec::new();
        let mut add = |part: FamilyPart, formula| parts.push((part, self.part(claim, formula)));
        for (symbol, term) in &self.symbols {
            let domain = claim.domains.get(symbol).into_iter();
            for formula in domain.flat_map(|domain| domain.formulas(term)) {
                add(FamilyPart::Domain(symbol.clone()), formula);
            }
        }
        for (at, group) in self.groups.iter().enumerate() {
            let natural = Domain {
                lower: Some((BigRational::from_integer(0.into()), false)),
                ..Domain::default()
            };
            for formula in natural.formulas(&group.size) {
                add(FamilyPart::Size(at), formula);
            }
        }
        let sizes = self.groups.iter().map(|group| group.size.clone());
        let all = Formula::equal(self.value(&self.count), sum_of(sizes.collect()));
        add(FamilyPart::Count, all);
        for (at, group) in self.groups.iter().enumerate() {
            for (sequence, term) in &group.elements {
                let domain = claim.sequences.get(sequence).into_iter();
                for formula in domain.flat_map(|domain| domain.formulas(term)) {
                    add(FamilyPart::Elements(sequence.clone(), at), formula);
                }
            }
        }
        for (at, hypothesis) in claim.hypotheses.iter().enumerate() {
            let formula = self.formula(&hypothesis.formula)?;
            add(FamilyPart::Hypothesis(at), formula);
        }
        let Formula::Relation {
            left,
            relation,
            right,
        } = self.formula(&claim.goal)?
        else {
            return Err(Reject::UnsupportedRelation);
        };
        let relation = relation.denied().ok_or(Reject::UnsupportedRelation)?;
        let denied = Formula::Relation {
            left,
            relation,
            right,
        };
        add(FamilyPart::Goal, denied);
        Ok(parts)
    }

    /// The member for one number, `free` being the values of what stays free.
    ///
    /// # Errors
    /// A term has no value there, or there are too many elements.
    pub fn member(
        &self,
        number: u32,
        free: &Map<Symbol, BigRational>,
    ) -> Result<Assignment, Reject> {
        let mut symbols = free.clone();
        symbols.insert(
            self.parameter.clone(),
            BigRational::from_integer(number.into()),
        );
        let at = Values {
            symbols,
            ..Values::default()
        };
        let value = |term: &Expr| at.value(term).map_err(|_| Reject::NoValue);
        let mut member = Assignment {
            symbols: at.symbols.clone(),
            ..Assignment::default()
        };
        for (symbol, term) in &self.symbols {
            member.symbols.insert(symbol.clone(), value(term)?);
        }
        let mut longest = 0_usize;
        for group in &self.groups {
            let size = value(&group.size)?;
            let size = Some(size).filter(|size| size.is_integer() && !size.is_negative());
            let size = size.and_then(|size| size.to_usize());
            let size = size.ok_or(Reject::OutsideDomain)?;
            longest = longest.saturating_add(size);
            if longest > LONGEST {
                return Err(Reject::TooLarge);
            }
            for (sequence, term) in &group.elements {
                let own = member.sequences.entry(sequence.clone()).or_default();
                own.extend(std::iter::repeat_n(value(term)?, size));
            }
        }
        Ok(member)
    }

    /// One part, for the parameter from the least number on and everything that is free within its domain.
    fn part(&self, claim: &Claim, goal: Formula) -> Claim {
        let own = |symbol: Symbol| match symbol == self.parameter {
            true => {
                let domain = claim.domains.get(&symbol).cloned().unwrap_or_default();
                let least = BigRational::from_integer(self.least.into());
                let domain = Domain {
                    lower: Some((least, false)),
                    integer: true,
                    ..domain
                };
                Some((symbol, domain))
            }
            false => claim.domains.get(&symbol).cloned().map(|d| (symbol, d)),
        };
        Claim {
            domains: goal.free_symbols().into_iter().filter_map(own).collect(),
            sequences: Map::new(),
            hypotheses: Vec::new(),
            goal,
        }
    }

    /// Whether the parameter may be any number from the least one on, and every term is in what is free, whole where it
    /// must be, and there where it is needed.
    fn is_possible(&self, claim: &Claim) -> Result<(), Reject> {
        let (sequences, _) = sequences_and_counts(claim);
        let least = BigRational::from_integer(self.least.into());
        let all_above = |domain: &Domain| domain.upper.is_none() && domain.contains(&least);
        if !claim.domains.get(&self.parameter).is_none_or(all_above)
            || self.symbols.contains_key(&self.parameter)
        {
            return Err(Reject::OutsideDomain);
        }
        // A single element has a name of its own, and π is no number that could be chosen.
        let is_special = |symbol: &Symbol| {
            let element = element_parts(symbol).is_some_and(|(own, _)| sequences.contains(&own));
            element || symbol.name() == "\\pi"
        };
        let named: Set<&Symbol> = claim.free_symbols().into_iter().collect();
        if named.iter().any(|symbol| is_special(symbol)) {
            return Err(Reject::NoFamily);
        }
        let terms = self.groups.iter().flat_map(|group| group.elements.values());
        for term in terms.chain(self.symbols.values()) {
            let plain = !term.any(&|part| !part.is_arithmetic());
            let free = |s: &Symbol| !self.symbols.contains_key(s) && !is_special(s);
            if !plain || !term.free_symbols().iter().all(free) {
                return Err(Reject::NoFamily);
            }
        }
        let whole = |term: &Expr| self.is_whole(claim, term);
        let declared = |domain: Option<&Domain>| domain.is_some_and(|domain| domain.integer);
        let symbols = self.symbols.iter();
        let mut symbols = symbols.filter(|own| declared(claim.domains.get(own.0)));
        let groups_fit = self.groups.iter().all(|group| {
            let mut elements = group.elements.iter();
            whole(&group.size)
                && sequences.iter().all(|s| group.elements.contains_key(s))
                && elements.all(|(s, term)| !declared(claim.sequences.get(s)) || whole(term))
        });
        match symbols.all(|(_, term)| whole(term)) && groups_fit {
            true => Ok(()),
            false => Err(Reject::OutsideDomain),
        }
    }

    /// Whether a term is seen to be a whole number: sums and products of such.
    fn is_whole(&self, claim: &Claim, term: &Expr) -> bool {
        let whole = |term: &Expr| self.is_whole(claim, term);
        match term {
            Expr::Number(value) => value.is_integer(),
            Expr::Symbol(symbol) if *symbol == self.parameter => true,
            Expr::Symbol(symbol) => {
                let domain = claim.domains.get(symbol).filter(|domain| domain.integer);
                domain.is_some() && !self.symbols.contains_key(symbol)
            }
            Expr::Sum(terms) | Expr::Product(terms) => terms.iter().all(whole),
            Expr::Negate(inner) => whole(inner),
            _ => false,
        }
    }

    /// What a symbol is.
    fn value(&self, symbol: &Symbol) -> Expr {
        let term = self.symbols.get(symbol).cloned();
        term.unwrap_or_else(|| Expr::Symbol(symbol.clone()))
    }

    /// A formula as it is said of the family.
    fn formula(&self, formula: &Formula) -> Result<Formula, Reject> {
        match formula {
            Formula::Relation {
                left,
                relation,
                right,
            } if relation.denied().is_some() => Ok(Formula::Relation {
                left: self.term(left, &mut Vec::new())?,
                relation: *relation,
                right: self.term(right, &mut Vec::new())?,
            }),
            Formula::AllEqual {
                sequence,
                to: Expr::Symbol(to),
                value,
            } if *to == self.count => {
                let value = value.as_ref();
                let value = value.map(|value| self.term(value, &mut Vec::new()));
                Ok(self.all_equal(sequence, value.transpose()?))
            }
            _ => Err(Reject::UnsupportedRelation),
        }
    }

    /// `Σ_g s_g (u_g − w)² = 0`, or `Σ_{g<h} s_g s_h (u_g − u_h)² = 0` where no value is named: each summand vanishes, so
    /// that the elements of groups that have any are equal.
    fn all_equal(&self, sequence: &Symbol, value: Option<Expr>) -> Formula {
        let square = |a: Expr, b: Expr| {
            let difference = Expr::Sum([a, Expr::Negate(b.into())].into());
            Expr::Power(difference.into(), Expr::integer(2).into())
        };
        let element = |group: &Group| group.elements.get(sequence).cloned();
        let mut terms = Vec::new();
        for (at, group) in self.groups.iter().enumerate() {
            let Some(own) = element(group) else { continue };
            if let Some(value) = &value {
                terms.push(times(&group.size, square(own, value.clone())));
                continue;
            }
            let others = self.groups[at + 1..].iter();
            for (other, its) in others.filter_map(|other| Some((other, element(other)?))) {
                let pairs = times(&other.size, square(own.clone(), its));
                terms.push(times(&group.size, pairs));
            }
        }
        Formula::equal(sum_of(terms), Expr::integer(0))
    }

    /// A term as it is said of the family; `bound` are the indices that run, each with the group that its element is in.
    fn term(&self, term: &Expr, bound: &mut Vec<(Symbol, usize)>) -> Result<Expr, Reject> {
        match term {
            // What depends on the number of an element is not alike in a group.
            Expr::Symbol(symbol) if bound.iter().any(|(index, _)| index == symbol) => {
                Err(Reject::NoFamily)
            }
            Expr::Symbol(symbol) => Ok(self.value(symbol)),
            Expr::Element { sequence, index } => {
                let group = bound.iter().rev().find(|(own, _)| own == index);
                let element = group.and_then(|&(_, at)| self.groups[at].elements.get(sequence));
                element.cloned().ok_or(Reject::NoFamily)
            }
            Expr::Series {
                index,
                from,
                to: limit,
                body,
            } => {
                if !from.is_one() || **limit != Expr::Symbol(self.count.clone()) {
                    return Err(Reject::NoFamily);
                }
                let mut terms = Vec::new();
                for (at, group) in self.groups.iter().enumerate() {
                    bound.push((index.clone(), at));
                    let own = self.term(body, bound);
                    bound.pop();
                    terms.push(times(&group.size, own?));
                }
                Ok(sum_of(terms))
            }
            // Equals can be put in for symbols.
            term if term.is_arithmetic() => {
                let mut failed = None;
                let written = term.map_children(|child| {
                    self.term(child, bound).unwrap_or_else(|reject| {
                        failed = Some(reject);
                        Expr::integer(0)
                    })
                });
                failed.map_or(Ok(written), Err)
            }
            _ => Err(Reject::NoFamily),
        }
    }
}

fn times(size: &Expr, term: Expr) -> Expr {
    match size.is_one() {
        true => term,
        false => Expr::Product([size.clone(), term].into()),
    }
}

fn sum_of(mut terms: Vec<Expr>) -> Expr {
    match terms.len() {
        0 => Expr::integer(0),
        1 => terms.remove(0),
        _ => Expr::Sum(terms.into()),
    }
}
