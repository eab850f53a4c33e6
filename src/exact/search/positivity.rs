//! Why a polynomial cannot be negative: by inspection, as a sum of squares, or as a nonnegative combination
//! of products of what is known.

use super::simplex::nonnegative_solution;
use super::tracked::Tracked;
use crate::algebra::{Atom, Atoms, Monomial, Polynomial, Rational, Symbol, power_sum};
use crate::kernel::{Fact, Knowledge, PositiveTerm, SeriesSquare, Sign};
use crate::sorted::{self, Map, Set};

/// Guesses at what a step of a derivation can need.
const MOST_CANDIDATES: usize = 400;
const MOST_COLUMNS: usize = 90;
const MOST_ROWS: usize = 60;

/// What a decomposition may use.
pub struct Known<'a> {
    pub atoms: &'a Atoms,
    pub knowledge: &'a Knowledge,
    /// Facts by their position in the certificate.
    pub facts: &'a [(usize, Fact)],
    /// There are many facts, of which a plain combination is likely to do.
    pub plain_first: bool,
    /// Equations that are left; those with a multiplier of 1 can be added freely.
    pub equations: &'a [Tracked],
}

/// `goal = Σ terms + Σ weight · equation`.
pub struct Decomposition {
    pub terms: Vec<PositiveTerm>,
    /// Equations by their position in [`Known::equations`].
    pub equations: Vec<(usize, Polynomial)>,
}

/// A number, to be multiplied by what else is not negative.
pub fn plain(coefficient: Rational) -> PositiveTerm {
    PositiveTerm {
        coefficient,
        factors: Vec::new(),
        squares: Vec::new(),
        series: Vec::new(),
        bounded: Vec::new(),
        facts: Vec::new(),
    }
}

/// What is seen by inspection not to be negative.
pub fn factor(polynomial: Polynomial) -> PositiveTerm {
    PositiveTerm {
        factors: vec![(polynomial, 1)],
        ..plain(Rational::one())
    }
}

/// The unknowns of a monomial as factors.
fn monomial_term(monomial: &Monomial, coefficient: Rational) -> PositiveTerm {
    let factors = monomial.powers().iter();
    PositiveTerm {
        factors: factors.map(|&(v, e)| (Polynomial::var(v), e)).collect(),
        ..plain(coefficient)
    }
}

/// A decomposition of `goal`; with a positive term in it where `strict`.
pub fn decompose(goal: &Polynomial, strict: bool, known: &Known) -> Option<Decomposition> {
    let terms_only = |terms| Decomposition {
        terms,
        equations: Vec::new(),
    };
    if goal.is_zero() && !strict {
        return Some(terms_only(Vec::new()));
    }
    if let Some(terms) = by_inspection(goal, strict, known.knowledge) {
        return Some(terms_only(terms));
    }
    if let Some(terms) = sum_of_squares(goal)
        && (!strict || terms.iter().any(|t| is_strict(t, known.knowledge)))
    {
        return Some(terms_only(terms));
    }
    if let Some(found) = squares_by_an_equation(goal, strict, known) {
        return Some(found);
    }
    if known.plain_first
        && let Some(found) = plain_combination(goal, strict, known)
    {
        return Some(found);
    }
    combination(goal, strict, known)
}

/// A sum of squares once an equation has taken the place of the constant: `1/2 − s c` with `s² + c² = 1`.
fn squares_by_an_equation(goal: &Polynomial, strict: bool, known: &Known) -> Option<Decomposition> {
    let constant = goal.coefficient(&Monomial::one())?.clone();
    let equations = known.equations.iter().enumerate();
    equations
        .filter(|(_, equation)| equation.multiplier.is_empty())
        .find_map(|(at, equation)| {
            let own = equation.polynomial.coefficient(&Monomial::one())?;
            let weight = &constant / own;
            let rest = goal.minus(&equation.polynomial.scaled(&weight));
            let terms = sum_of_squares(&rest)?;
            let fits = !strict || terms.iter().any(|t| is_strict(t, known.knowledge));
            fits.then(|| Decomposition {
                terms,
                equations: vec![(at, Polynomial::constant(weight))],
            })
        })
}

fn is_strict(term: &PositiveTerm, knowledge: &Knowledge) -> bool {
    !term.coefficient.is_zero() && term.squares.iter().all(|s| knowledge.is_nonzero(s))
}

fn by_inspection(
    goal: &Polynomial,
    strict: bool,
    knowledge: &Knowledge,
) -> Option<Vec<PositiveTerm>> {
    let terms: Vec<_> = goal.terms().collect();
    let one = |m: &Monomial| Polynomial::term(m.clone(), Rational::one());
    let fine = terms
        .iter()
        .all(|(m, c)| c.is_positive() && knowledge.is_nonnegative(&one(m)));
    let positive = terms.iter().any(|(m, _)| knowledge.monomial_is_positive(m));
    (fine && (!strict || positive)).then(|| {
        terms
            .iter()
            .map(|(m, c)| monomial_term(m, (*c).clone()))
            .collect()
    })
}

/// `z' G z` with `G` positive semidefinite, where the polynomial determines `G`: exact `L D L'`.
fn sum_of_squares(goal: &Polynomial) -> Option<Vec<PositiveTerm>> {
    // Half of every even monomial is a candidate for the basis.
    let basis: Vec<Monomial> = goal
        .terms()
        .filter_map(|(m, c)| if c.is_positive() { m.sqrt() } else { None })
        .collect();
    let n = basis.len();
    if n == 0 || n > 12 {
        return None;
    }
    let mut place: Map<Monomial, (usize, usize)> = Map::new();
    for i in 0..n {
        for j in i..n {
            if place.insert(basis[i].times(&basis[j]), (i, j)).is_some() {
                return None;
            }
        }
    }
    let mut gram = vec![vec![Rational::zero(); n]; n];
    let half = Rational::ratio(1, 2);
    for (monomial, coefficient) in goal.terms() {
        let &(i, j) = place.get(monomial)?;
        match i == j {
            true => gram[i][i] = coefficient.clone(),
            false => {
                gram[i][j] = coefficient * &half;
                gram[j][i] = coefficient * &half;
            }
        }
    }
    let mut terms = Vec::new();
    for k in 0..n {
        let pivot = gram[k][k].clone();
        if pivot.is_negative() {
            return None;
        }
        if pivot.is_zero() {
            if gram[k].iter().any(|x| !x.is_zero()) {
                return None;
            }
            continue;
        }
        let row = gram[k].clone();
        let mut form = Polynomial::zero();
        for (j, value) in row.iter().enumerate().skip(k) {
            form = form.plus(&Polynomial::term(basis[j].clone(), value / &pivot));
        }
        for i in k..n {
            let factor = &row[i] / &pivot;
            for j in k..n {
                let change = &factor * &row[j];
                gram[i][j] -= change;
            }
        }
        terms.push(PositiveTerm {
            squares: vec![form],
            ..plain(pivot)
        });
    }
    Some(terms)
}

struct Column {
    value: Polynomial,
    made: Made,
    strict: bool,
}

/// How a column is made. Few of many columns are of any use, and only these are put into words.
enum Made {
    /// A weight, which is not negative, times something.
    Product(Monomial, Of),
    /// An equation times a weight; it may be taken with either sign.
    Equation(usize, Monomial),
}

/// What is not negative besides a weight.
enum Of {
    Nothing,
    Series(SeriesSquare),
    Fact(usize),
    Facts(usize, usize),
    Square(Polynomial),
}

impl Column {
    fn is_equation(&self) -> bool {
        matches!(self.made, Made::Equation(..))
    }

    /// What the column is, with a coefficient; none for an equation.
    fn term(&self, coefficient: Rational) -> Option<PositiveTerm> {
        let Made::Product(weight, of) = &self.made else {
            return None;
        };
        let mut term = monomial_term(weight, coefficient);
        match of {
            Of::Nothing => {}
            Of::Series(series) => term.series.push(series.clone()),
            Of::Fact(at) => term.facts.push(*at),
            Of::Facts(one, other) => term.facts.extend([*one, *other]),
            Of::Square(form) => term.squares.push(form.clone()),
        }
        Some(term)
    }
}

/// A nonnegative combination of what is known, without products.
fn plain_combination(goal: &Polynomial, strict: bool, known: &Known) -> Option<Decomposition> {
    let facts = known.facts.iter().map(|(at, fact)| Column {
        value: fact.polynomial.clone(),
        made: Made::Product(Monomial::one(), Of::Fact(*at)),
        strict: fact.sign == Sign::Positive,
    });
    let free = known.equations.iter().enumerate();
    let free = free.filter(|(_, e)| e.multiplier.is_empty());
    let equations = free.map(|(at, equation)| Column {
        value: equation.polynomial.clone(),
        made: Made::Equation(at, Monomial::one()),
        strict: false,
    });
    solved(goal, strict, facts.chain(equations).collect())
}

/// A nonnegative combination of products of what is known, by linear programming.
fn combination(goal: &Polynomial, strict: bool, known: &Known) -> Option<Decomposition> {
    solved(goal, strict, candidates(goal, known)?)
}

fn solved(goal: &Polynomial, strict: bool, mut columns: Vec<Column>) -> Option<Decomposition> {
    prune(&mut columns, goal);
    let is_possible = !strict || columns.iter().any(|column| column.strict);
    if columns.len() > MOST_COLUMNS || !is_possible {
        return None;
    }
    let system = System::of(goal, &columns)?;
    if !strict {
        return system.solve(goal);
    }
    // goal = ε · (something positive) + the rest, for some ε = 1, 1/2, …
    let positive = columns.iter().filter(|column| column.strict);
    let choices = positive.flat_map(|column| [0, 2, 6, 12].map(|shift| (column, shift)));
    for (tried, (column, shift)) in choices.enumerate() {
        // To try one costs as much as to find out whether any will do.
        if tried == 1 && !system.is_ever_strict(goal) {
            return None;
        }
        let epsilon = Rational::ratio(1, 1 << shift);
        let rest = goal.minus(&column.value.scaled(&epsilon));
        if let (Some(mut found), Some(term)) = (system.solve(&rest), column.term(epsilon)) {
            found.terms.push(term);
            return Some(found);
        }
    }
    None
}

/// Columns as linear equations, one for each monomial that they or a goal have.
struct System<'a> {
    columns: &'a [Column],
    rows: Map<Monomial, usize>,
    matrix: Vec<Vec<(usize, Rational)>>,
    /// The equations among the columns, which come again with the other sign behind all others.
    free: Vec<usize>,
}

impl<'a> System<'a> {
    /// Nothing where there are too many monomials.
    fn of(goal: &Polynomial, columns: &'a [Column]) -> Option<System<'a>> {
        let mut rows: Map<Monomial, usize> = Map::new();
        let all = columns.iter().map(|c| &c.value).chain([goal]);
        for (monomial, _) in all.flat_map(|p| p.terms()) {
            let next = rows.len();
            rows.entry(monomial.clone()).or_insert(next);
        }
        if rows.len() > MOST_ROWS {
            return None;
        }
        let free = (0..columns.len()).filter(|&at| columns[at].is_equation());
        let mut system = System {
            columns,
            rows,
            matrix: Vec::with_capacity(columns.len()),
            free: free.collect(),
        };
        let free = system.free.iter().map(|&at| columns[at].value.negated());
        let free: Vec<Polynomial> = free.collect();
        let all = columns.iter().map(|column| &column.value).chain(&free);
        system.matrix = all.map(|value| system.entries(value)).collect();
        Some(system)
    }

    fn entries(&self, polynomial: &Polynomial) -> Vec<(usize, Rational)> {
        let terms = polynomial.terms();
        terms.map(|(m, c)| (self.rows[m], c.clone())).collect()
    }

    /// A goal as a nonnegative combination of the columns. It has no other monomials than these, and the goal that the system is of.
    fn solve(&self, goal: &Polynomial) -> Option<Decomposition> {
        let mut right = vec![Rational::zero(); self.rows.len()];
        for (row, value) in self.entries(goal) {
            right[row] = value;
        }
        let solution = nonnegative_solution(&self.matrix, &right)?;
        let (mut terms, mut equations) = (Vec::new(), Vec::new());
        for (at, column) in self.columns.iter().enumerate() {
            let mut weight = solution[at].clone();
            if let Some(place) = self.free.iter().position(|&f| f == at) {
                weight -= &solution[self.columns.len() + place];
            }
            if weight.is_zero() {
                continue;
            }
            match &column.made {
                Made::Product(..) => terms.extend(column.term(weight)),
                Made::Equation(index, factor) => {
                    equations.push((*index, Polynomial::term(factor.clone(), weight)));
                }
            }
        }
        Some(Decomposition { terms, equations })
    }

    /// Whether a multiple of a goal, or 0, is a nonnegative combination in which something is positive.
    fn is_ever_strict(&self, goal: &Polynomial) -> bool {
        // What is positive comes to 1 in all, and the goal has a weight of its own.
        let last = self.rows.len();
        let mut matrix = self.matrix.clone();
        let positive = self.columns.iter().zip(&mut matrix);
        for (_, entries) in positive.filter(|(column, _)| column.strict) {
            entries.push((last, Rational::one()));
        }
        matrix.push(self.entries(&goal.negated()));
        let mut right = vec![Rational::zero(); last];
        right.push(Rational::one());
        nonnegative_solution(&matrix, &right).is_some()
    }
}

/// Drops columns with a monomial that nothing else can cancel.
fn prune(columns: &mut Vec<Column>, goal: &Polynomial) {
    let mut kept = kept(columns, goal).into_iter();
    columns.retain(|_| kept.next().unwrap_or(false));
}

/// What tells most monomials apart: the degree and the first two powers.
fn glance(monomial: &Monomial) -> u64 {
    let powers = monomial.powers().iter().take(2);
    powers.fold(monomial.degree().into(), |seen, &(var, exponent)| {
        (seen << 24) ^ ((var.position() as u64) << 8) ^ u64::from(exponent)
    })
}

/// Which columns have no monomial that nothing else can cancel.
fn kept(columns: &[Column], goal: &Polynomial) -> Vec<bool> {
    // Each term as the place of its monomial among all, and whether it can add to that, and take from it.
    let all = columns.iter().map(|column| &column.value).chain([goal]);
    let of_all = all
        .enumerate()
        .flat_map(|(at, p)| p.terms().map(move |(m, c)| (glance(m), m, c, at)));
    let mut sorted: Vec<(u64, &Monomial, &Rational, usize)> = of_all.collect();
    sorted.sort_unstable_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)));
    let room = columns.iter().map(|column| column.value.len());
    let room = room.chain([goal.len()]).map(Vec::with_capacity);
    let mut terms: Vec<Vec<(usize, (bool, bool))>> = room.collect();
    let (mut places, mut last) = (0, None);
    for (_, monomial, coefficient, at) in sorted {
        if last.replace(monomial).is_some_and(|last| last != monomial) {
            places += 1;
        }
        let signs = match columns.get(at).map(|column| &column.made) {
            Some(Made::Equation(..)) => (true, true),
            _ => (coefficient.is_positive(), coefficient.is_negative()),
        };
        terms[at].push((places, signs));
    }
    let of_goal = terms.pop().unwrap_or_default();
    let mut kept = vec![true; columns.len()];
    loop {
        let mut balance = vec![(false, false); places + 1];
        let mut add = |at: usize, (adds, takes): (bool, bool)| {
            balance[at].0 |= adds;
            balance[at].1 |= takes;
        };
        // The goal stands on the other side.
        for &(at, (adds, takes)) in &of_goal {
            add(at, (takes, adds));
        }
        let left = terms.iter().zip(&kept).filter(|(_, kept)| **kept);
        for &(at, own) in left.flat_map(|(terms, _)| terms) {
            add(at, own);
        }
        // What is added has to be taken, and the other way round.
        let cancels = |&(at, (adds, takes)): &(usize, (bool, bool))| {
            (!adds || balance[at].1) && (!takes || balance[at].0)
        };
        let mut dropped = false;
        for (terms, kept) in terms.iter().zip(&mut kept).filter(|(_, kept)| **kept) {
            *kept = terms.iter().all(cancels);
            dropped |= !*kept;
        }
        if !dropped {
            return kept;
        }
    }
}

fn candidates(goal: &Polynomial, known: &Known) -> Option<Vec<Column>> {
    let knowledge = known.knowledge;
    let mut columns: Vec<Column> = Vec::with_capacity(MOST_COLUMNS);
    let mut push = |value: Polynomial, weight: &Monomial, of: Of, strict: bool| {
        if !value.is_zero() && columns.len() < MOST_CANDIDATES {
            columns.push(Column {
                value,
                made: Made::Product(weight.clone(), of),
                strict,
            });
        }
    };
    let one = Rational::one;
    // What a product may be multiplied by: unknowns (and their products) that are not negative.
    let vars = goal.vars();
    let single = vars.iter().map(|&v| Monomial::power(v, 1));
    let mut weights: Vec<Monomial> = single
        .filter(|m| knowledge.is_nonnegative(&Polynomial::term(m.clone(), one())))
        .collect();
    let pairs: Vec<Monomial> = weights
        .iter()
        .enumerate()
        .flat_map(|(i, a)| weights[i..].iter().map(|b| a.times(b)))
        .collect();
    weights.insert(0, Monomial::one());
    if weights.len() <= 5 {
        weights.extend(pairs);
    }
    let polynomial = |m: &Monomial| Polynomial::term(m.clone(), one());
    let support: Set<Monomial> = goal
        .terms()
        .map(|(m, _)| m.clone())
        .chain([Monomial::one()])
        .collect();
    for monomial in support.iter().chain(&weights) {
        if knowledge.is_nonnegative(&polynomial(monomial)) {
            let strict = knowledge.monomial_is_positive(monomial);
            push(polynomial(monomial), monomial, Of::Nothing, strict);
        }
    }
    // Sums of squares over the elements of sequences.
    for (value, series) in series_squares(known.atoms) {
        for weight in &weights {
            let value = value.times(&polynomial(weight)).ok()?;
            push(value, weight, Of::Series(series.clone()), false);
        }
    }
    let facts: Vec<&(usize, Fact)> = known
        .facts
        .iter()
        .filter(|(_, f)| matches!(f.sign, Sign::NonNegative | Sign::Positive))
        .filter(|(_, f)| f.polynomial.as_constant().is_none_or(|c| c.is_negative()))
        .collect();
    for (at, fact) in &facts {
        for weight in &weights {
            let strict = fact.sign == Sign::Positive && knowledge.monomial_is_positive(weight);
            let value = fact.polynomial.times(&polynomial(weight)).ok()?;
            push(value, weight, Of::Fact(*at), strict);
        }
    }
    if facts.len() <= 12 {
        for (i, (at, a)) in facts.iter().enumerate() {
            for (other, b) in &facts[i..] {
                let strict = a.sign == Sign::Positive && b.sign == Sign::Positive;
                let value = a.polynomial.times(&b.polynomial).ok()?;
                push(value, &Monomial::one(), Of::Facts(*at, *other), strict);
            }
        }
    }
    // Squares of differences and sums of half-monomials.
    let mut halves: Set<Monomial> = Set::from([Monomial::one()]);
    for monomial in &support {
        for weight in &weights {
            halves.extend(monomial.divided_by(weight).and_then(|m| m.sqrt()));
        }
    }
    // The sums of squares bring (Σu)² with them.
    for (var, atom) in known.atoms.iter() {
        if let Atom::PowerSum { powers, .. } = atom
            && powers.len() == 1
            && powers[0].1 == 1
        {
            halves.insert(Monomial::power(var, 1));
        }
    }
    let halves: Vec<Monomial> = halves.into_iter().take(8).collect();
    for (i, a) in halves.iter().enumerate() {
        for b in &halves[i + 1..] {
            let (a, b) = (polynomial(a), polynomial(b));
            let forms = [a.minus(&b), a.plus(&b)];
            let squares = [forms[0].pow(2).ok()?, forms[1].pow(2).ok()?];
            for weight in &weights {
                for (form, square) in forms.iter().zip(&squares) {
                    let value = square.times(&polynomial(weight)).ok()?;
                    push(value, weight, Of::Square(form.clone()), false);
                }
            }
        }
    }
    let equations = known
        .equations
        .iter()
        .enumerate()
        .filter(|(_, e)| e.multiplier.is_empty());
    for (at, equation) in equations {
        for weight in weights.iter().take(4) {
            columns.push(Column {
                value: equation.polynomial.times(&polynomial(weight)).ok()?,
                made: Made::Equation(at, weight.clone()),
                strict: false,
            });
        }
    }
    Some(columns)
}

/// Lagrange's identity for the sequences that are summed: `n Σu² − (Σu)²`, `Σu² Σw² − (Σuw)²`.
fn series_squares(atoms: &Atoms) -> Vec<(Polynomial, SeriesSquare)> {
    let mut counts: Map<&Symbol, Set<&Symbol>> = Map::new();
    for (_, atom) in atoms.iter() {
        if let Atom::PowerSum { to, powers } = atom {
            counts
                .entry(to)
                .or_default()
                .extend(powers.iter().map(|p| &p.0));
        }
    }
    let mut found = Vec::new();
    for (count, sequences) in counts {
        let sequences: Vec<&Symbol> = sequences.into_iter().collect();
        for (i, &u) in sequences.iter().enumerate() {
            let others = sequences[i + 1..].iter().map(|w| vec![((*w).clone(), 1)]);
            for g in others.chain([Vec::new()]) {
                let f = vec![(u.clone(), 1)];
                let sum = |powers: Vec<(Symbol, u32)>| {
                    let var = atoms.find(&power_sum(count, powers))?;
                    Some(Polynomial::var(var))
                };
                let doubled =
                    |p: &[(Symbol, u32)]| p.iter().map(|(s, e)| (s.clone(), 2 * e)).collect();
                let mut both: Vec<_> = f.iter().chain(&g).cloned().collect();
                sorted::sort(&mut both);
                let (Some(ff), Some(gg), Some(fg)) =
                    (sum(doubled(&f)), sum(doubled(&g)), sum(both))
                else {
                    continue;
                };
                if let (Ok(product), Ok(square)) = (ff.times(&gg), fg.pow(2)) {
                    let count = count.clone();
                    found.push((product.minus(&square), SeriesSquare { count, f, g }));
                }
            }
        }
    }
    found
}
