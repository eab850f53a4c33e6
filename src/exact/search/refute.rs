//! Exact counterexamples, and exact points at which premises hold together.

use std::borrow::Cow;
use std::cell::{Cell, RefCell};
use std::ops::Deref;
use std::rc::Rc;

use num_traits::{Signed, ToPrimitive};

use super::course::in_motion;
use super::functions::{in_terms_of_pi, leave_open, needs};
use super::point::{Target, Tried, Wanted, satisfies};
use super::unfold::definitions_to_unfold;
use super::values::candidates;
use crate::algebra::{
    Atom, Atoms, BigRational, Expr, Formula, Function, Lowering, Polynomial, Rational, Symbol,
    Values, Var, element_parts, element_symbol,
};
use crate::kernel::{Assignment, Claim, Domain, Fact, Hypothesis, Obligation, Sign};
use crate::sorted::{self, Map, Set};

/// Sums over a symbolic number of elements are tried with up to this many.
const MOST_ELEMENTS: i64 = 4;
/// The most terms that sums in one claim are written out to: sums in sums multiply.
const MOST_WRITTEN_OUT: usize = 4_000;
/// The costs that are tried one after another.
const MOST_COST: u32 = 11;
/// How far is looked from a point that is nearly right.
const NEAR_COST: u32 = 3;
const NEAR_CHOICES: usize = 24;

/// A search for points at which all hypotheses of a claim hold and, if so wanted, its goal does not.
pub struct Points<'a> {
    obligation: &'a Obligation,
    counts: Vec<Symbol>,
    /// One search for each choice of the numbers of elements, the smallest first.
    sizes: Vec<(Vec<i64>, Slot<'a>)>,
    /// The claim with definite numbers of elements, where it was read so before; `None` where it cannot be.
    sized: RefCell<Map<Vec<i64>, Option<Rc<Obligation>>>>,
    against_goal: bool,
    wanted: Wanted,
    cost: u32,
    /// How many choices were tried.
    pub tried: usize,
}

/// A search that is prepared when its turn comes, and dropped when it has nothing left.
enum Slot<'a> {
    Waiting,
    Ready(Box<Concrete<'a>>),
    Done,
}

/// The claim itself, or what it is with definite numbers of elements.
#[derive(Clone)]
enum Posed<'a> {
    Itself(&'a Obligation),
    Sized(Rc<Obligation>),
}

impl Deref for Posed<'_> {
    type Target = Obligation;
    fn deref(&self) -> &Obligation {
        match self {
            Posed::Itself(own) => own,
            Posed::Sized(sized) => sized,
        }
    }
}

/// A claim with definite numbers of elements.
struct Concrete<'a> {
    obligation: Posed<'a>,
    /// The problem's unknowns, and those of what roots are taken of.
    atoms: Cow<'a, Atoms>,
    target: Target,
}

impl<'a> Points<'a> {
    /// Prepares a search for points at which the hypotheses hold and the goal does not.
    pub fn new(obligation: &'a Obligation) -> Self {
        Points::prepared(obligation, true, Wanted::Simple)
    }

    /// The same where any such point will do, simple or not.
    pub fn any(obligation: &'a Obligation) -> Self {
        Points::prepared(obligation, true, Wanted::Any)
    }

    /// Prepares a search for points at which the hypotheses hold; the goal is left alone.
    pub fn of_premises(obligation: &'a Obligation) -> Self {
        Points::prepared(obligation, false, Wanted::Any)
    }

    fn prepared(obligation: &'a Obligation, against_goal: bool, wanted: Wanted) -> Self {
        let claim = obligation.claim();
        let counts = count_symbols(claim);
        let mut sizes = sizes(&counts, claim);
        rule_out(&mut sizes, &counts, claim, against_goal);
        let sizes = sizes.into_iter();
        Points {
            obligation,
            sizes: sizes.map(|sizes| (sizes, Slot::Waiting)).collect(),
            sized: RefCell::default(),
            counts,
            against_goal,
            wanted,
            cost: 0,
            tried: 0,
        }
    }

    /// Points that agree with one of the `hints` wherever these give a symbol a value.
    pub fn near<'h>(
        &self,
        hints: impl IntoIterator<Item = &'h Assignment>,
    ) -> impl Iterator<Item = Assignment> {
        let found = hints.into_iter().map(|hint| {
            let size = |count: &Symbol| {
                let value = hint.symbols.get(count)?.to_integer().to_i64()?;
                (1..=MOST_ELEMENTS).contains(&value).then_some(value)
            };
            let sizes: Vec<i64> = self.counts.iter().map(size).collect::<Option<_>>()?;
            let mut concrete = Concrete::new(
                self.at_sizes(&sizes)?,
                self.against_goal,
                Wanted::Simple,
                Some(hint),
            )?;
            let Tried::Found(values) = concrete.target.up_to(NEAR_COST, &mut { NEAR_CHOICES })
            else {
                return None;
            };
            let point = concrete.assignment(&values);
            let claim = self.obligation.claim();
            restored(claim, self.obligation.unfold(), &self.counts, &sizes, point).pop()
        });
        found.flatten()
    }

    /// The claim with definite numbers of elements.
    fn at_sizes(&self, sizes: &[i64]) -> Option<Posed<'a>> {
        let claim = self.obligation.claim();
        if self.counts.is_empty() && claim.sequences.is_empty() {
            return Some(Posed::Itself(self.obligation));
        }
        let read = || {
            let claim = at_sizes(claim, &self.counts, sizes)?;
            let unfold = definitions_to_unfold(&claim);
            Obligation::new(claim, unfold).ok().map(Rc::new)
        };
        let mut sized = self.sized.borrow_mut();
        let own = sized.entry(sizes.to_vec()).or_insert_with(read);
        own.clone().map(Posed::Sized)
    }

    /// The simplest point not yet ruled out, in more than one order of its elements; more of them with each
    /// call. Nothing once the budget is spent or there is nothing left to try.
    ///
    /// A further element costs as much as two less simple numbers, so that few elements come first.
    pub fn next(&mut self, budget: usize) -> Vec<Assignment> {
        let mut left = budget;
        let smallest = self.sizes.first().map_or(0, |s| s.0.iter().sum::<i64>());
        while self.cost <= MOST_COST && left > 0 {
            for at in 0..self.sizes.len() {
                let sizes = &self.sizes[at].0;
                let more = 2 * u32::try_from(sizes.iter().sum::<i64>() - smallest).unwrap_or(0);
                let Some(cost) = self.cost.checked_sub(more) else {
                    continue;
                };
                if matches!(self.sizes[at].1, Slot::Waiting) {
                    let concrete = self.at_sizes(sizes);
                    let concrete = concrete
                        .and_then(|c| Concrete::new(c, self.against_goal, self.wanted, None));
                    self.sizes[at].1 = concrete.map_or(Slot::Done, |c| Slot::Ready(c.into()));
                }
                let (sizes, slot) = &mut self.sizes[at];
                let Slot::Ready(concrete) = slot else {
                    continue;
                };
                let before = left;
                let tried = concrete.target.up_to(cost, &mut left);
                self.tried += before - left;
                match tried {
                    Tried::Found(values) => {
                        let point = concrete.assignment(&values);
                        let posed = &concrete.obligation;
                        let moving = in_motion(posed.claim(), posed.as_written(), &values, &point);
                        *slot = Slot::Done;
                        let claim = self.obligation.claim();
                        let unfold = self.obligation.unfold();
                        let mut points = restored(claim, unfold, &self.counts, sizes, point);
                        points.extend(moving.filter(|_| self.counts.is_empty()));
                        return points;
                    }
                    Tried::Costlier => {}
                    Tried::Exhausted => *slot = Slot::Done,
                }
                if left == 0 {
                    return Vec::new();
                }
            }
            if self.sizes.iter().all(|s| matches!(s.1, Slot::Done)) {
                break;
            }
            self.cost += 1;
        }
        Vec::new()
    }
}

/// The symbols that say how many elements there are, and the whole numbers in exponents: with a definite number in
/// its place a power is a polynomial.
pub fn count_symbols(claim: &Claim) -> Vec<Symbol> {
    let whole = |symbol: &Symbol| {
        let domain = claim.domains.get(symbol);
        domain.is_some_and(|d| {
            d.integer && d.lower.as_ref().is_some_and(|lower| !lower.0.is_negative())
        })
    };
    fn collect(expr: &Expr, whole: &impl Fn(&Symbol) -> bool, found: &mut Set<Symbol>) {
        match expr {
            Expr::Series { to, .. } => found.extend(to.free_symbols()),
            Expr::Power(_, exponent) if !matches!(**exponent, Expr::Number(_)) => {
                found.extend(exponent.free_symbols().into_iter().filter(whole));
            }
            _ => {}
        }
        (expr.children()).for_each(|child| collect(child, whole, found));
    }
    let mut found = Set::new();
    for formula in claim.formulas() {
        formula
            .terms()
            .into_iter()
            .for_each(|term| collect(term, &whole, &mut found));
        if let Formula::AllEqual { to, .. } = formula {
            found.extend(to.free_symbols());
        }
    }
    found.into_iter().collect()
}

/// All choices of sizes, the smallest total first.
fn sizes(counts: &[Symbol], claim: &Claim) -> Vec<Vec<i64>> {
    let mut all: Vec<Vec<i64>> = vec![Vec::new()];
    for count in counts {
        let fits = |n: &i64| {
            let value = BigRational::from_integer((*n).into());
            claim.domains.get(count).is_none_or(|d| d.contains(&value))
        };
        let choices: Vec<i64> = (1..=MOST_ELEMENTS).filter(fits).collect();
        all = all
            .iter()
            .flat_map(|sizes| {
                choices
                    .iter()
                    .map(|&n| sizes.iter().copied().chain([n]).collect())
            })
            .take(256)
            .collect();
    }
    sorted::sort_by_key(&mut all, |sizes| (sizes.iter().sum::<i64>(), sizes.clone()));
    all
}

/// Drops the sizes at which a hypothesis about them alone is false, or the goal true.
fn rule_out(sizes: &mut Vec<Vec<i64>>, counts: &[Symbol], claim: &Claim, against_goal: bool) {
    let about_sizes = |formula: &&Formula| {
        let Formula::Relation { left, right, .. } = formula else {
            return false;
        };
        let own = |term: &Expr| {
            matches!(term, Expr::Number(_)) || matches!(term, Expr::Symbol(s) if counts.contains(s))
        };
        own(left) && own(right)
    };
    let hypotheses = claim.hypotheses.iter().map(|h| &*h.formula);
    let hypotheses: Vec<&Formula> = hypotheses.filter(about_sizes).collect();
    let goal = Some(&claim.goal).filter(|goal| against_goal && about_sizes(goal));
    if hypotheses.is_empty() && goal.is_none() {
        return;
    }
    sizes.retain(|sizes| {
        let pairs = counts.iter().zip(sizes);
        let values = Values {
            symbols: pairs
                .map(|(count, &n)| (count.clone(), BigRational::from_integer(n.into())))
                .collect(),
            ..Values::default()
        };
        let mut hypotheses = hypotheses.iter();
        hypotheses.all(|formula| values.holds(formula) != Ok(false))
            && goal.is_none_or(|goal| values.holds(goal) != Ok(true))
    });
}

/// The claim with definite numbers of elements, each element a symbol of its own.
fn at_sizes(claim: &Claim, counts: &[Symbol], sizes: &[i64]) -> Option<Claim> {
    let left = Cell::new(MOST_WRITTEN_OUT);
    let number = |expr: &Expr| {
        let sizes = counts.iter().zip(sizes);
        let at = sizes.fold(expr.clone(), |e, (count, &n)| {
            e.substitute(count, &Expr::integer(n))
        });
        without_series(&at, &left)
    };
    let mut domains = claim.domains.clone();
    for (sequence, domain) in &claim.sequences {
        for position in 1..=MOST_ELEMENTS as u32 {
            domains.insert(element_symbol(sequence, position), domain.clone());
        }
    }
    let mut hypotheses = Vec::new();
    for hypothesis in &claim.hypotheses {
        for formula in written_out(&hypothesis.formula.map_terms(number))? {
            let standing = hypothesis.standing;
            let formula = formula.into();
            hypotheses.push(Hypothesis { formula, standing });
        }
    }
    // The conclusion is one formula: Σ (aᵢ − bᵢ)² = 0.
    let goals = written_out(&claim.goal.map_terms(number))?;
    if left.get() == 0 {
        return None;
    }
    let goal = match goals.as_slice() {
        [single] => single.clone(),
        several => {
            let squares = several.iter().map(|g| match g {
                Formula::Relation { left, right, .. } => {
                    let minus = Expr::Negate(right.clone().into());
                    let difference = Expr::Sum(vec![left.clone(), minus]);
                    Expr::Power(difference.into(), Expr::integer(2).into())
                }
                Formula::AllEqual { .. } => Expr::integer(0),
            });
            Formula::equal(Expr::Sum(squares.collect()), Expr::integer(0))
        }
    };
    Some(Claim {
        domains,
        sequences: Map::new(),
        hypotheses,
        goal,
    })
}

/// Sums over a definite number of elements, written out while there are terms left to be written.
fn without_series(expr: &Expr, left: &Cell<usize>) -> Expr {
    if let Expr::Series {
        index,
        from,
        to,
        body,
    } = expr
        && let (Expr::Number(from), Expr::Number(to)) = (&**from, &**to)
        && let (Ok(from), Ok(to)) = (
            u32::try_from(from.to_integer()),
            u32::try_from(to.to_integer()),
        )
        && to.saturating_sub(from) < 64
        && left.get() > 0
    {
        let written = (from..=to).map(|position| {
            left.set(left.get().saturating_sub(1));
            without_series(&body.at_index(index, position), left)
        });
        let mut terms: Vec<Expr> = written.collect();
        return match terms.len() {
            0 => Expr::integer(0),
            1 => terms.remove(0),
            _ => Expr::Sum(terms),
        };
    }
    expr.map_children(|child| without_series(child, left))
}

/// A statement about a definite number of elements as equations between them.
fn written_out(formula: &Formula) -> Option<Vec<Formula>> {
    let Formula::AllEqual {
        sequence,
        to,
        value,
    } = formula
    else {
        return Some(vec![formula.clone()]);
    };
    let Expr::Number(to) = to else {
        return None;
    };
    let to: u32 = to.to_integer().try_into().ok()?;
    if to as usize > MOST_WRITTEN_OUT {
        return None;
    }
    let element = |position| Expr::Symbol(element_symbol(sequence, position));
    let (first, from) = match value {
        Some(value) => (value.clone(), 1),
        None => (element(1), 2),
    };
    Some(
        (from..=to)
            .map(|position| Formula::equal(element(position), first.clone()))
            .collect(),
    )
}

/// That units of measurement are 1: in which units a point is given makes no difference where dimensions agree. Where what is to follow
/// has a unit that nothing it follows from has, they do not, and another unit may show it; but a mere number beside one is a number whose
/// unit was left out.
pub fn measured_in_units(claim: &Claim, atoms: &Atoms) -> impl Iterator<Item = Fact> {
    let units = |formula: &Formula| -> Set<Symbol> {
        let symbols = formula.free_symbols().into_iter();
        symbols.filter(Symbol::is_unit).collect()
    };
    let of_goal = units(&claim.goal);
    let is_open = !of_goal.is_empty() && {
        let known: Set<Symbol> = (claim.hypotheses.iter())
            .flat_map(|own| units(&own.formula))
            .collect();
        let mut sides = claim.goal.terms().into_iter();
        !known.is_empty()
            && !of_goal.is_subset(&known)
            && !sides.any(|side| side.free_symbols().is_empty())
    };
    let is_unit = |atom: &Atom| matches!(atom, Atom::Symbol(symbol) if symbol.is_unit());
    let units = atoms
        .iter()
        .filter(move |(_, atom)| !is_open && is_unit(atom));
    let one = Polynomial::constant(Rational::one());
    units.map(move |(var, _)| Fact {
        polynomial: Polynomial::var(var).minus(&one),
        sign: Sign::Zero,
    })
}

impl<'a> Concrete<'a> {
    /// `None` where some term cannot be given a value at all.
    fn new(
        obligation: Posed<'a>,
        against_goal: bool,
        wanted: Wanted,
        hint: Option<&Assignment>,
    ) -> Option<Self> {
        let problem = obligation.as_written();
        let known: Vec<Option<Rational>> = match hint {
            None => Vec::new(),
            Some(hint) => known_at(hint, &problem.atoms),
        };
        let mut facts: Vec<Fact> = Vec::with_capacity(problem.facts.len() + 1);
        if against_goal {
            facts.push(negation(&problem.goal));
        }
        // What is known to be false at the hint rules it out; what is known to be true need not be asked again.
        let at_hint = |fact: &Fact| {
            let value = |var: Var| known.get(var.position())?.clone();
            let value = fact.polynomial.evaluate(value).ok()??;
            Some(satisfies(&value, fact.sign))
        };
        if hint.is_some() && facts.first().and_then(at_hint) == Some(false) {
            return None;
        }
        for fact in &problem.facts {
            match hint.and_then(|_| at_hint(fact)) {
                None => facts.push(fact.clone()),
                Some(true) => {}
                Some(false) => return None,
            }
        }
        if against_goal {
            facts.extend(problem.conditions.nonzero.iter().map(|p| Fact {
                polynomial: p.clone(),
                sign: Sign::NonZero,
            }));
        }
        let mut atoms = match &obligation {
            Posed::Itself(obligation) => Cow::Borrowed(&obligation.as_written().atoms),
            Posed::Sized(obligation) => Cow::Owned(obligation.as_written().atoms.clone()),
        };
        if atoms
            .iter()
            .any(|(_, atom)| matches!(atom, Atom::Opaque(_)))
        {
            facts.extend(roots(atoms.to_mut())?);
            facts.extend(needs(obligation.claim(), obligation.as_written()));
        }
        facts.extend(measured_in_units(obligation.claim(), &atoms));
        let integers = obligation.claim().domains.iter();
        let integers = integers
            .filter(|(_, d)| d.integer)
            .filter_map(|(s, _)| atoms.find(&Atom::Symbol(s.clone())))
            .collect();
        let target = match hint {
            None => Target::new(&facts, integers, wanted),
            Some(_) => {
                let vars = atoms.iter().map(|(var, _)| var);
                let known = vars.filter_map(|var| Some((var, known.get(var.position())?.clone()?)));
                Target::near(&facts, integers, known)?
            }
        };
        Some(Concrete {
            obligation,
            atoms,
            target,
        })
    }

    fn assignment(&self, values: &Map<Var, Rational>) -> Assignment {
        let mut point = Assignment {
            unfold: self.obligation.unfold().to_vec(),
            ..Assignment::default()
        };
        for (var, atom) in self.atoms.iter() {
            let Some(value) = values.get(&var) else {
                continue;
            };
            match atom {
                Atom::Symbol(symbol) => {
                    point.symbols.insert(symbol.clone(), value.to_big());
                }
                Atom::Opaque(Expr::Derivative { body, variable }) => {
                    if let Expr::Symbol(symbol) = &**body {
                        let key = (symbol.clone(), variable.clone());
                        point.derivatives.insert(key, value.to_big());
                    }
                }
                _ => {}
            }
        }
        complete(
            self.obligation.claim(),
            self.obligation.unfold(),
            &mut point,
        );
        let problem = self.obligation.as_written();
        in_terms_of_pi(problem, values, &mut point);
        leave_open(self.obligation.claim(), problem, values, &mut point);
        point
    }
}

/// The values of a problem's unknowns at a point, as far as it gives them one.
pub fn known_at(point: &Assignment, atoms: &Atoms) -> Vec<Option<Rational>> {
    let values = atoms.iter().map(|(_, atom)| match atom {
        Atom::Symbol(symbol) => value_at(point, symbol),
        _ => None,
    });
    values.collect()
}

/// The value of a symbol, or of an element by its own name, at a point.
fn value_at(point: &Assignment, symbol: &Symbol) -> Option<Rational> {
    let value = point.symbols.get(symbol).or_else(|| {
        let (sequence, position) = element_parts(symbol)?;
        point.sequences.get(&sequence)?.get(position as usize - 1)
    });
    value.map(Rational::from)
}

/// What is true where a goal is not.
pub fn negation(goal: &Fact) -> Fact {
    let (polynomial, sign) = match goal.sign {
        Sign::Zero => (goal.polynomial.clone(), Sign::NonZero),
        Sign::NonZero => (goal.polynomial.clone(), Sign::Zero),
        Sign::NonNegative => (goal.polynomial.negated(), Sign::Positive),
        Sign::Positive => (goal.polynomial.negated(), Sign::NonNegative),
    };
    Fact { polynomial, sign }
}

/// What roots mean: `s^q = base`, `s ≥ 0`. `None` where a term cannot be given a value at all.
pub fn roots(atoms: &mut Atoms) -> Option<Vec<Fact>> {
    let mut facts = Vec::new();
    let opaque: Vec<_> = atoms
        .iter()
        .filter_map(|(var, atom)| match atom {
            Atom::Opaque(expr) => Some((var, expr.clone())),
            _ => None,
        })
        .collect();
    for (var, expr) in opaque {
        match &expr {
            Expr::Derivative { body, .. }
                if matches!(**body, Expr::Symbol(_) | Expr::Derivative { .. }) => {}
            Expr::Power(base, exponent) => {
                let Expr::Number(exponent) = &**exponent else {
                    return None;
                };
                let q: u32 = exponent.denom().try_into().ok()?;
                let mut lowering = Lowering::plain(atoms);
                let base = lowering.lower(base).ok()?;
                let root = Polynomial::var(var);
                let below = base.expanded_denominator().ok()?;
                let left = root.pow(q).ok()?.times(&below).ok()?;
                facts.push(Fact {
                    polynomial: left.minus(base.numerator()),
                    sign: Sign::Zero,
                });
                facts.push(Fact {
                    polynomial: root,
                    sign: Sign::NonNegative,
                });
            }
            // What is known of these is among the facts.
            Expr::Call(function, _) if !matches!(function, Function::Ceiling | Function::Floor) => {
            }
            _ => return None,
        }
    }
    Some(facts)
}

/// Gives every symbol a value that the search left open, and those that were put in theirs.
pub fn complete(claim: &Claim, unfold: &[usize], point: &mut Assignment) {
    let defined: Vec<(Symbol, Expr)> = unfold
        .iter()
        .filter_map(|&at| crate::kernel::definition(&claim.hypotheses[at].formula))
        .collect();
    let anything = Domain::default();
    for symbol in claim.free_symbols() {
        let irrational = point.algebraic.as_ref();
        let known = point.symbols.contains_key(symbol)
            || irrational.is_some_and(|own| own.symbols.contains_key(symbol));
        if known || defined.iter().any(|(s, _)| s == symbol) {
            continue;
        }
        let domain = claim.domains.get(symbol).unwrap_or(&anything);
        let mut values = candidates().iter().map(|(_, v)| v.to_big());
        if let Some(value) = values.find(|v| domain.contains(v)) {
            point.symbols.insert(symbol.clone(), value);
        }
    }
    for (symbol, term) in defined.iter().rev() {
        let mut atoms = crate::algebra::Atoms::default();
        let mut lowering = Lowering::plain(&mut atoms);
        let written = point.symbols.iter().fold(term.clone(), |t, (s, v)| {
            t.substitute(s, &Expr::Number(v.clone()))
        });
        if let Ok(value) = lowering.lower(&written)
            && let Some(value) = value.as_constant()
        {
            point.symbols.insert(symbol.clone(), value.to_big());
        }
    }
}

/// The point in the claim's own terms: counts and sequences again. Elements in order along the line come first.
fn restored(
    claim: &Claim,
    unfold: &[usize],
    counts: &[Symbol],
    sizes: &[i64],
    mut point: Assignment,
) -> Vec<Assignment> {
    if counts.is_empty() && claim.sequences.is_empty() {
        return vec![point];
    }
    for (count, &n) in counts.iter().zip(sizes) {
        point
            .symbols
            .insert(count.clone(), BigRational::from_integer(n.into()));
    }
    let longest = sizes.iter().copied().max().unwrap_or(0) as u32;
    for sequence in claim.sequences.keys() {
        let mut elements = Vec::new();
        for position in 1..=MOST_ELEMENTS as u32 {
            let value = point.symbols.remove(&element_symbol(sequence, position));
            if position <= longest {
                elements.push(value.unwrap_or_else(|| BigRational::from_integer(1.into())));
            }
        }
        point.sequences.insert(sequence.clone(), elements);
    }
    // Hypotheses were renumbered where one was written out as several.
    point.unfold = unfold
        .iter()
        .copied()
        .filter(|&at| {
            let formula = &claim.hypotheses[at].formula;
            crate::kernel::definition(formula).is_some_and(|(s, _)| !counts.contains(&s))
        })
        .collect();
    let mut ordered = point.clone();
    ordered
        .sequences
        .values_mut()
        .for_each(|elements| elements.sort());
    vec![ordered, point]
}
