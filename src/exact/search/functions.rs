//! Points in the kernel's terms where functions or `\pi` occur: which symbols are left open, and which values are
//! polynomials in π.

use crate::algebra::{
    Atom, Atoms, Expr, Fraction, Function, Polynomial, Rational, Symbol, Var, sign_of_fraction,
};
use crate::kernel::{Assignment, Claim, Fact, Origin, Problem, Sign};
use crate::sorted::{self, Map};

/// How deep the tree of fractions is descended.
const MOST_STEPS: usize = 1_000;

/// Gives functions the values that were found for them, and takes the value from a symbol in each argument of which
/// nothing else is said.
pub fn leave_open(
    claim: &Claim,
    problem: &Problem,
    values: &Map<Var, Rational>,
    point: &mut Assignment,
) {
    let mut families: Map<Symbol, Vec<(Rational, Function, Expr)>> = Map::new();
    for (var, atom) in problem.atoms.iter() {
        let Atom::Opaque(Expr::Call(function, argument)) = atom else {
            continue;
        };
        let known = matches!(function, Function::Sin | Function::Exp | Function::Ln);
        if !known || !values.contains_key(&var) {
            continue;
        }
        let Some((symbol, value)) = open_in(claim, problem, argument) else {
            continue;
        };
        let own = (
            slope_at(problem, &symbol, &value, values),
            *function,
            (**argument).clone(),
        );
        families.entry(symbol).or_default().push(own);
    }
    for (symbol, mut family) in families {
        // The others are multiples of the smallest.
        sorted::sort(&mut family);
        if family.iter().any(|f| f.1 == Function::Sin) {
            family.retain(|f| f.1 == Function::Sin);
        }
        let (_, function, argument) = family.swap_remove(0);
        let partner = match function {
            Function::Sin => vec![Function::Sin, Function::Cos],
            other => vec![other],
        };
        for function in partner {
            let call = Expr::Call(function, argument.clone().into());
            let value = problem.atoms.find(&Atom::Opaque(call.clone()));
            if let Some(value) = value.and_then(|var| values.get(&var)) {
                point.functions.insert(call, value.to_big());
            }
        }
        point.symbols.remove(&symbol);
        // What is put in and speaks of it has no value either.
        for &at in &point.unfold {
            if let Some((defined, term)) = crate::kernel::definition(&claim.hypotheses[at].formula)
                && term.mentions(&symbol)
            {
                point.symbols.remove(&defined);
            }
        }
    }
}

/// How steep an argument is at a point in the symbol that is left open in it; where that is not known, by its numbers alone.
fn slope_at(
    problem: &Problem,
    symbol: &Symbol,
    argument: &Fraction,
    values: &Map<Var, Rational>,
) -> Rational {
    let evaluated = |polynomial: &Polynomial| {
        let value = polynomial.evaluate(|var| values.get(&var).cloned());
        value.ok().flatten().filter(|value| !value.is_zero())
    };
    let at_point = || {
        let own = problem.atoms.find(&Atom::Symbol(symbol.clone()))?;
        let above = argument.numerator().coefficient_of_power(own, 1);
        let below = argument.expanded_denominator().ok()?;
        Some(evaluated(&above)? / evaluated(&below)?)
    };
    let by_numbers = || argument.numerator().leading().map(|(_, c)| c.clone());
    let slope = at_point().or_else(by_numbers);
    slope.map_or_else(Rational::zero, |own| own.abs())
}

/// The symbol that can be left open in an argument, and the argument.
fn open_in(claim: &Claim, problem: &Problem, argument: &Expr) -> Option<(Symbol, Fraction)> {
    let (mut found, value) = candidates(claim, problem, argument)?;
    // Of two in one exponent one has a value: `k` of `k t`, where nothing but `t` can be left open in another.
    if found.len() > 1 {
        let only = |atom: &Atom| {
            let Atom::Opaque(Expr::Call(Function::Exp, other)) = atom else {
                return None;
            };
            match &candidates(claim, problem, other)?.0[..] {
                [only] => Some(only.clone()),
                _ => None,
            }
        };
        let all = problem.atoms.iter();
        let forced: Vec<Symbol> = all.filter_map(|(_, atom)| only(atom)).collect();
        if found.iter().any(|own| forced.contains(own)) {
            found.retain(|own| forced.contains(own));
        }
    }
    // What stands in few arguments ties few of them together: `m` of `m t` beside `d t`.
    let calls = |symbol: &Symbol| {
        let all = problem.atoms.iter();
        let in_call = |atom: &Atom| match atom {
            Atom::Opaque(Expr::Call(_, argument)) => argument.mentions(symbol),
            _ => false,
        };
        all.filter(|(_, atom)| in_call(atom)).count()
    };
    let symbol = found.into_iter().min_by_key(calls)?;
    Some((symbol, value))
}

/// The symbols that could be left open in an argument, and the argument.
fn candidates(
    claim: &Claim,
    problem: &Problem,
    argument: &Expr,
) -> Option<(Vec<Symbol>, Fraction)> {
    let mut atoms = problem.atoms.clone();
    let value = problem.lowering_over(&mut atoms).lower(argument).ok()?;
    let content = value.numerator().content();
    let found = content.powers().iter().filter_map(|&(var, exponent)| {
        let Atom::Symbol(symbol) = atoms.atom(var) else {
            return None;
        };
        let below = value.denominator().any(|(f, _)| f.degree_in(var) > 0);
        let open = exponent == 1 && !below && is_open(claim, problem, symbol);
        open.then(|| symbol.clone())
    });
    let found = found.collect();
    Some((found, value))
}

/// What a point needs for the functions in it to have values: something in their argument that can be left open, all
/// else in it not being 0; or the argument for which the value is known.
pub fn needs(claim: &Claim, problem: &Problem) -> Vec<Fact> {
    let mut facts = Vec::new();
    let mut need = |polynomial, sign| facts.push(Fact { polynomial, sign });
    let mut kinds = Map::new();
    let calls = problem.atoms.iter();
    let mut calls: Vec<(Var, &Atom)> = calls
        .filter(|(var, _)| !is_of_logarithms_alone(problem, *var))
        .collect();
    let last = |atom: &Atom| matches!(atom, Atom::Opaque(Expr::Call(Function::Exp, _)));
    sorted::sort_by_key(&mut calls, |(_, atom)| last(atom));
    for (var, atom) in calls {
        let Atom::Opaque(call @ Expr::Call(function, argument)) = atom else {
            continue;
        };
        // The logarithm of a number is no rational number, and every point gives it.
        if call.is_logarithm_of_number() {
            continue;
        }
        if !matches!(
            function,
            Function::Sin | Function::Cos | Function::Exp | Function::Ln
        ) {
            continue;
        }
        if let Some((symbol, value)) = open_in(claim, problem, argument) {
            let own = problem.atoms.find(&Atom::Symbol(symbol));
            let slope = own.map(|own| value.numerator().in_powers_of(own).pop());
            // One symbol cannot be left open for an angle and an exponent: one of them is 0.
            let kind = kinds.entry(own).or_insert_with(|| kind_of(*function));
            if let Some(Some(slope)) = slope
                && slope.as_constant().is_none()
            {
                if *kind != kind_of(*function) && *function == Function::Exp {
                    need(slope, Sign::Zero);
                    let value = Polynomial::var(var).minus(&Polynomial::one());
                    need(value, Sign::Zero);
                    continue;
                }
                need(slope, Sign::NonZero);
            }
            // Between two bounds an angle is tried that is acute.
            let bounds = |sign: fn(&Rational) -> bool| {
                problem.facts.iter().any(|f| {
                    let own = own.map(|own| f.polynomial.in_powers_of(own));
                    let slope = own.filter(|p| p.len() == 2).and_then(|mut p| p.pop());
                    let slope = slope.and_then(|p| p.as_constant());
                    matches!(f.sign, Sign::Positive | Sign::NonNegative)
                        && slope.is_some_and(|s| sign(&s))
                })
            };
            let angle = matches!(function, Function::Sin | Function::Cos);
            if angle && bounds(Rational::is_positive) && bounds(Rational::is_negative) {
                need(Polynomial::var(var), Sign::Positive);
            }
            continue;
        }
        let mut atoms = problem.atoms.clone();
        let lowered = problem.lowering_over(&mut atoms).lower(argument);
        let Some((value, below)) = lowered
            .ok()
            .and_then(|v| Some((v.numerator().clone(), v.expanded_denominator().ok()?)))
        else {
            continue;
        };
        let own = Polynomial::var(var);
        let (argument, own) = match function {
            Function::Sin => (value, own),
            Function::Cos | Function::Exp => (value, own.minus(&Polynomial::one())),
            _ => (value.minus(&below), own),
        };
        need(argument, Sign::Zero);
        need(own, Sign::Zero);
    }
    facts
}

/// What lets several exponentials of one symbol have values at once, `e^{a t}` and `e^{b t}`: that the exponents are as 1, 2, 3 and so on, and
/// the exponentials powers of the first. Nothing where there are no two of them.
pub fn tied_exponents(claim: &Claim, problem: &Problem) -> Vec<Fact> {
    let mut families: Map<Symbol, Vec<(Var, Polynomial, Polynomial)>> = Map::new();
    for (var, atom) in problem.atoms.iter() {
        if let Atom::Opaque(Expr::Call(Function::Exp, argument)) = atom
            && let Some((symbol, value)) = open_in(claim, problem, argument)
            && let Ok(below) = value.expanded_denominator()
        {
            let family = families.entry(symbol).or_default();
            family.push((var, value.numerator().clone(), below));
        }
    }
    let mut facts = Vec::new();
    for family in families.into_values() {
        let Some(((first, above, below), others)) = family.split_first() else {
            continue;
        };
        for (multiple, (var, own, under)) in (2_u32..).zip(others) {
            let pair = (own.times(below), above.times(under));
            let (Ok(own), Ok(as_first)) = pair else {
                continue;
            };
            let times = Rational::from(multiple);
            let Ok(power) = Polynomial::var(*first).pow(multiple) else {
                continue;
            };
            let exponent = own.minus(&as_first.scaled(&times));
            let value = Polynomial::var(*var).minus(&power);
            facts.extend([exponent, value].map(|polynomial| Fact {
                polynomial: polynomial.without_content().1.into_owned(),
                sign: Sign::Zero,
            }));
        }
    }
    facts
}

/// Whether exponentials are the only functions of a problem, so that they may be taken of numbers.
pub fn speaks_of_exponentials_alone(problem: &Problem) -> bool {
    let calls = problem.atoms.iter().filter_map(|(_, atom)| match atom {
        Atom::Opaque(Expr::Call(function, _)) => Some(*function),
        _ => None,
    });
    let mut calls = calls.peekable();
    calls.peek().is_some()
        && !problem.pi_is_the_number()
        && calls.all(|function| function == Function::Exp)
}

/// What a point needs for exponentials to be taken of numbers: that these are positive.
pub fn positive_exponents(problem: &Problem) -> Vec<Fact> {
    let mut atoms = problem.atoms.clone();
    let calls = problem.atoms.iter().filter_map(|(_, atom)| match atom {
        Atom::Opaque(Expr::Call(Function::Exp, argument)) => Some(argument),
        _ => None,
    });
    let mut positive = |argument: &Expr| {
        let value = problem.lowering_over(&mut atoms).lower(argument).ok()?;
        let polynomial = sign_of_fraction(&value).ok()?;
        let sign = Sign::Positive;
        Some(Fact { polynomial, sign })
    };
    calls.filter_map(|argument| positive(argument)).collect()
}

/// Sines and cosines are of one kind.
fn kind_of(function: Function) -> Function {
    match function {
        Function::Cos => Function::Sin,
        other => other,
    }
}

/// The facts, but those that only say the same with logarithms.
fn told(problem: &Problem) -> impl Iterator<Item = &Fact> {
    let facts = problem.facts.iter().zip(&problem.origins);
    let told = facts.filter(|(_, origin)| !matches!(origin, Origin::Logarithms(_)));
    told.map(|(fact, _)| fact)
}

/// Whether an unknown was brought in where logarithms were taken, and is spoken of nowhere else.
fn is_of_logarithms_alone(problem: &Problem, var: Var) -> bool {
    let speaks = |fact: &Fact| fact.polynomial.degree_in(var) > 0;
    let Atom::Opaque(call @ Expr::Call(Function::Ln, _)) = problem.atoms.atom(var) else {
        return false;
    };
    let stands_in = |atom: &Atom| match atom {
        Atom::Opaque(term) => term != call && term.any(&|part| part == call),
        _ => false,
    };
    problem.facts.iter().any(speaks)
        && !told(problem).chain([&problem.goal]).any(speaks)
        && !problem.atoms.iter().any(|(_, atom)| stands_in(atom))
}

/// Whether facts speak of a symbol only to bound it.
fn is_open(claim: &Claim, problem: &Problem, symbol: &Symbol) -> bool {
    let Some(var) = problem.atoms.find(&Atom::Symbol(symbol.clone())) else {
        return false;
    };
    let pi = problem.pi_is_the_number() && symbol.name() == "\\pi";
    // What logarithms say of it is so wherever the exponentials have the values that they need.
    let bounded = told(problem).all(|fact| match fact.sign {
        Sign::Zero => fact.polynomial.degree_in(var) == 0,
        // Of a product of powers it is enough that it is positive.
        _ => {
            let polynomial = &fact.polynomial;
            polynomial.degree_in(var) <= polynomial.content().exponent(var).max(1)
        }
    });
    let integer = claim.domains.get(symbol).is_some_and(|d| d.integer);
    bounded
        && !integer
        && !pi
        && !is_torn(claim, problem, symbol)
        && problem.goal.polynomial.degree_in(var) == 0
}

/// Whether a symbol stands in an exponential and in a sine, and the exponential cannot be without it: then it is left open for none of
/// them, and 0 is tried.
fn is_torn(claim: &Claim, problem: &Problem, symbol: &Symbol) -> bool {
    let stands_in = |is: fn(Function) -> bool, others: &dyn Fn(&Symbol) -> bool| {
        problem.atoms.iter().any(|(_, atom)| {
            let Atom::Opaque(Expr::Call(own, argument)) = atom else {
                return false;
            };
            let symbols = argument.free_symbols();
            let mut all = symbols.iter().filter(|s| *s != symbol);
            is(*own) && symbols.contains(symbol) && all.all(others)
        })
    };
    let stays = |own: &Symbol| is_not_nought(claim, problem, own);
    stands_in(|f| kind_of(f) == Function::Sin, &|_| true)
        && stands_in(|f| f == Function::Exp, &stays)
}

/// Whether a symbol cannot be 0 at a point that is looked for: its domain or a fact says so, or the goal would hold there.
fn is_not_nought(claim: &Claim, problem: &Problem, symbol: &Symbol) -> bool {
    let zero = crate::algebra::BigRational::from_integer(0.into());
    if claim
        .domains
        .get(symbol)
        .is_some_and(|d| !d.contains(&zero))
    {
        return true;
    }
    let Some(var) = problem.atoms.find(&Atom::Symbol(symbol.clone())) else {
        return false;
    };
    let is_power = |own: &Polynomial| own.vars().as_slice() == [var] && own.terms().count() == 1;
    let says = |fact: &Fact| match fact.sign {
        Sign::Positive | Sign::NonZero => is_power(&fact.polynomial),
        _ => false,
    };
    let goal = &problem.goal;
    let is_factor = || goal.polynomial.content().exponent(var) > 0;
    problem.facts.iter().any(says) || goal.sign == Sign::Zero && is_factor()
}

/// A polynomial without the powers of an unknown that all of it has as a factor.
pub fn without_factor(polynomial: &Polynomial, var: Var) -> Polynomial {
    let mut rest = polynomial.clone();
    while !rest.is_zero()
        && let Some(less) = rest.divided_by(&Polynomial::var(var))
    {
        rest = less;
    }
    rest
}

/// Writes the values that depend on what was put in for `\pi` as polynomials in it: each equation with π in it is
/// solved for one symbol that is linear in it. `roots` say what the roots among the unknowns are, `s^2 - 4 \pi D = 0`.
pub fn in_terms_of_pi(
    problem: &Problem,
    (atoms, roots): (&Atoms, &[Polynomial]),
    values: &Map<Var, Rational>,
    point: &mut Assignment,
) {
    let Some(pi) = problem.pi() else {
        return;
    };
    point.symbols.remove(&Symbol::new("\\pi"));
    let equations = problem.facts.iter().filter(|f| f.sign == Sign::Zero);
    let equations = equations.map(|fact| &fact.polynomial).chain(roots);
    // What has π for a factor throughout is so whatever that is.
    let plain: Vec<Polynomial> = equations.map(|own| without_factor(own, pi)).collect();
    let mut pending: Vec<&Polynomial> = plain.iter().collect();
    let all = pending.clone();
    let speak_of = |equations: &[&Polynomial], var: Var| {
        let own = equations.iter().filter(|own| own.degree_in(var) > 0);
        own.count()
    };
    let mut in_pi = InPi {
        pi,
        values,
        lifted: Map::new(),
    };
    let is_symbol = |var: Var| matches!(atoms.atom(var), Atom::Symbol(_));
    loop {
        // What changes in one equation may stand in one before it.
        let depends = |equation: &Polynomial| {
            let mut vars = equation.vars().into_iter();
            vars.any(|var| in_pi.is_settled(var))
        };
        let is_open = |var: Var| is_symbol(var) && !in_pi.is_settled(var);
        // `V = \pi r^2` can be solved for `V` alone, `M = V + \pi u` for either side: the first has no other choice.
        let choices = |equation: &Polynomial| {
            let vars = equation.vars().into_iter();
            let is_choice = |&var: &Var| is_open(var) && is_plain(equation, var);
            vars.filter(is_choice).count()
        };
        let next = (0..pending.len()).filter(|&at| depends(pending[at]));
        let Some(at) = next.min_by_key(|&at| choices(pending[at]).wrapping_sub(1)) else {
            break;
        };
        let equation = pending.remove(at);
        let vars = equation.vars().into_iter().rev();
        let mut candidates: Vec<Var> = vars.filter(|&var| is_open(var)).collect();
        // What few equations speak of can be changed with the least harm to the others.
        sorted::sort_by_key(&mut candidates, |&var| speak_of(&all, var));
        if in_pi.solve(equation, &candidates) {
            continue;
        }
        // `4 \pi \epsilon F = q^2` can be solved for `\epsilon` where `q` is a multiple of π.
        let is_square = |&var: &Var| {
            let is_new = speak_of(&pending, var) + 1 == speak_of(&all, var);
            is_new && equation.degree_in(var) > 1
        };
        // `s^2 = 4 \pi D` of `s = \sqrt{4 \pi D}` can be solved for `D` where the root is one.
        let roots = equation.vars().into_iter();
        let roots = roots.filter(|&var| !is_symbol(var) && !in_pi.is_settled(var));
        let mut squares = candidates.iter().copied().chain(roots).filter(is_square);
        let with_multiple = squares.find_map(|square| {
            let mut with = in_pi.clone();
            let multiple = with.value(square)?.times(&Polynomial::var(pi)).ok()?;
            with.lifted.insert(square, multiple);
            let others: Vec<Var> = candidates
                .iter()
                .copied()
                .filter(|&v| v != square)
                .collect();
            (with.is_met(equation) || with.solve(equation, &others)).then_some(with)
        });
        in_pi = with_multiple.unwrap_or(in_pi);
    }
    for (var, value) in in_pi.lifted {
        let Atom::Symbol(symbol) = atoms.atom(var) else {
            continue;
        };
        let parts = value.in_powers_of(pi).into_iter();
        let parts = parts.map(|c| c.as_constant().map(|c| c.to_big()));
        if let Some(parts) = parts.collect::<Option<Vec<_>>>() {
            match parts.as_slice() {
                [only] => {
                    point.symbols.insert(symbol.clone(), only.clone());
                }
                _ => {
                    point.symbols.remove(symbol);
                    point.in_pi.insert(symbol.clone(), parts);
                }
            }
        }
    }
}

/// Values of which some are polynomials in π.
#[derive(Clone)]
struct InPi<'a> {
    pi: Var,
    /// Those that are numbers, where nothing lifts them.
    values: &'a Map<Var, Rational>,
    lifted: Map<Var, Polynomial>,
}

impl InPi<'_> {
    /// Whether it is π or a polynomial in it already.
    fn is_settled(&self, var: Var) -> bool {
        var == self.pi || self.lifted.contains_key(&var)
    }

    fn value(&self, var: Var) -> Option<Polynomial> {
        match self.lifted.get(&var) {
            Some(value) => Some(value.clone()),
            None => Some(Polynomial::constant(self.values.get(&var)?.clone())),
        }
    }

    /// Solves an equation for the first of some unknowns that is linear in it, with a factor that is a number. Whether there is one.
    fn solve(&mut self, equation: &Polynomial, candidates: &[Var]) -> bool {
        let mut candidates = candidates.iter();
        let solved = candidates.find_map(|&var| Some((var, self.solved_for(equation, var)?)));
        let found = solved.is_some();
        self.lifted.extend(solved);
        found
    }

    /// Whether an equation is so with these values.
    fn is_met(&self, equation: &Polynomial) -> bool {
        let mut left = equation.clone();
        for var in equation.vars() {
            let value = self.value(var).filter(|_| var != self.pi);
            let put_in = value.and_then(|value| left.substitute(var, &value).ok());
            match put_in {
                Some(with) => left = with,
                None if var == self.pi => {}
                None => return false,
            }
        }
        left.is_zero()
    }

    fn solved_for(&self, equation: &Polynomial, var: Var) -> Option<Polynomial> {
        let mut left = equation.clone();
        let others = equation.vars().into_iter();
        for other in others.filter(|&other| other != var && other != self.pi) {
            left = left.substitute(other, &self.value(other)?).ok()?;
        }
        // What is put in may have brought π to all of it.
        let parts = without_factor(&left, self.pi).in_powers_of(var);
        let [rest, slope] = parts.as_slice() else {
            return None;
        };
        let slope = slope.as_constant().filter(|s| !s.is_zero())?;
        Some(rest.scaled(&-slope.recip()))
    }
}

/// Whether nothing is multiplied with a symbol where an equation speaks of it.
fn is_plain(equation: &Polynomial, var: Var) -> bool {
    match equation.in_powers_of(var).as_slice() {
        [_, slope] => slope.as_constant().is_some(),
        _ => false,
    }
}

/// The simplest rational number between two bounds, by descent in the Stern-Brocot tree.
pub fn simplest_between(below: &Rational, above: &Rational) -> Option<Rational> {
    if below.is_negative() {
        return match above.is_positive() {
            true => Some(Rational::zero()),
            false => simplest_between(&-above, &-below).map(|value| -value),
        };
    }
    let (mut left, mut right) = ((0_u64, 1_u64), (1_u64, 0_u64));
    for _ in 0..MOST_STEPS {
        let middle = (left.0.checked_add(right.0)?, left.1.checked_add(right.1)?);
        let value = Rational::from(middle.0) / Rational::from(middle.1);
        if value <= *below {
            left = middle;
        } else if value >= *above {
            right = middle;
        } else {
            return Some(value);
        }
    }
    None
}
