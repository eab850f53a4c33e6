//! Limits: of rational functions, of sums without end, at a place of what sines, exponentials and roots are in, and at infinity of what exponentials are in, too.

use super::effort::is_spent;
use super::function::inverse;
use super::lower::{LowerError, Lowered, Lowering};
use super::{
    Atom, Conditions, Expr, Fraction, Function, LimitPoint, Polynomial, Symbol, Var, expr_of,
    expr_of_fraction, sign_of_fraction,
};
use crate::sorted::Set;

/// Leading terms are compared up to this degree.
const HIGHEST_DEGREE: u32 = 4096;

/// A numerator and a denominator.
type Parts = (Fraction, Fraction);

impl Lowering<'_> {
    /// A limit, where it can be told; otherwise an unknown of which it is not known whether it has a value.
    pub(super) fn limit(&mut self, body: &Expr, variable: &Symbol, point: &LimitPoint) -> Lowered {
        if let Some((index, from, term)) = endless(body, variable, point)
            && let Some(sum) = self.endless_sum(index, from, term)?
        {
            return Ok(sum);
        }
        if *point == LimitPoint::MinusInfinity
            && let Some(found) = self.limit_of_mirrored(body, variable)
        {
            return Ok(found);
        }
        if !is_no_more_than_a_limit(body, variable) {
            return self.limit_of(body, variable, point);
        }
        // Nothing else depends on what there is for the limit's sake alone.
        let others = body.free_symbols().into_iter();
        let pairs = others.map(|own| (own, variable.clone()));
        let still: Set<(Symbol, Symbol)> = self.still.iter().cloned().chain(pairs).collect();
        let mut atoms = std::mem::take(self.atoms);
        let mut within = Lowering {
            still: &still,
            ..self.over(&mut atoms)
        };
        let value = within.limit_of(body, variable, point);
        let conditions = within.conditions;
        *self.atoms = atoms;
        self.conditions.extend(conditions);
        value
    }

    /// A limit at minus infinity, as that at plus infinity of the same in the opposite of the variable; `None` where that cannot be told.
    fn limit_of_mirrored(&mut self, body: &Expr, variable: &Symbol) -> Option<Fraction> {
        let opposite = Expr::Negate(Expr::Symbol(variable.clone()).into());
        let mirrored = body.substitute(variable, &opposite);
        let before = self.conditions.clone();
        let found = self.limit(&mirrored, variable, &LimitPoint::PlusInfinity);
        let found = found
            .ok()
            .filter(|_| self.conditions.doubtful == before.doubtful);
        if found.is_none() {
            self.conditions = before;
        }
        found
    }

    fn limit_of(&mut self, body: &Expr, variable: &Symbol, point: &LimitPoint) -> Lowered {
        if *point == LimitPoint::PlusInfinity
            && is_in_function(body, variable)
            && let Some(found) = self.by_series(body, variable)?
        {
            return Ok(found);
        }
        let outer = std::mem::take(&mut self.conditions);
        let value = self.lower(body)?;
        let inner = std::mem::replace(&mut self.conditions, outer);
        let opaque = Expr::Limit {
            body: expr_of_fraction(&value, self.atoms).into(),
            variable: variable.clone(),
            point: point.clone(),
        };
        if let LimitPoint::Finite(place) = point
            && let Some(found) = self.where_it_is_continuous(&value, &inner, variable, place)?
        {
            return Ok(found);
        }
        let own = self.atom_of_symbol(variable);
        let var = self.atoms.var(own);
        let below = value.expanded_denominator()?;
        let mut others: Set<Var> = value.numerator().vars().into_iter().collect();
        others.extend(below.vars());
        others.remove(&var);
        let growing = self.growing(&others, variable, point)?;
        if let Some((exponential, _)) = &growing {
            others.remove(exponential);
        }
        let plain = others.iter().all(|&other| match self.atoms.atom(other) {
            Atom::Symbol(_) => true,
            other => self.is_constant(other, variable),
        });
        let held = self.slopes(&others, variable)?;
        // That something is positive all the way is known at infinity only, from where on does not matter.
        let far = *point == LimitPoint::PlusInfinity;
        let signs = inner.positive.len() + inner.nonnegative.len();
        let needed = inner.polynomials().count() - inner.nonzero.len();
        let found = match point {
            _ if !plain || needed > if far { signs } else { 0 } => None,
            _ if !inner.doubtful.is_empty() => None,
            // A lone symbol that is not known to be constant tells nothing about where it goes.
            _ if !held.is_empty()
                && value.as_polynomial().is_some_and(|p| p.degree_in(var) == 0) =>
            {
                None
            }
            LimitPoint::Finite(point) => {
                let point = self.lower(point)?;
                let moves = point.numerator().degree_in(var) > 0;
                if moves {
                    None
                } else {
                    limit_at(value.numerator(), &below, var, &point)?
                }
            }
            LimitPoint::PlusInfinity | LimitPoint::MinusInfinity => match &growing {
                None => limit_at_infinity(value.numerator(), &below, var)?,
                // What grows exponentially grows faster than every power.
                Some((exponential, _)) => {
                    match limit_at_infinity(value.numerator(), &below, *exponential)? {
                        Some((above, below)) => {
                            let (above, below) = (above.numerator(), below.numerator());
                            limit_at_infinity(above, below, var)?
                        }
                        None => None,
                    }
                }
            },
        };
        let Some((above, below)) = found else {
            self.conditions.doubtful.insert(opaque.clone());
            return Ok(self.atom(Atom::Opaque(opaque)));
        };
        let mut leading = vec![var];
        if let Some((exponential, rate)) = growing {
            leading.insert(0, exponential);
            self.conditions.positive.insert(rate);
        }
        self.needed_on_the_way(&inner, &leading);
        self.conditions.zero.extend(held);
        if let LimitPoint::Finite(_) = point {
            // Where it vanishes there may be a limit all the same: that of 0/x at 0.
            let inverse = below.recip()?.ok_or(LowerError::DivisionByZero)?;
            let factors = inverse.denominator().map(|(factor, _)| factor.clone());
            self.conditions.away.extend(factors);
            return Ok(above.times(&inverse)?);
        }
        Ok(above.times(&self.recip(&below)?)?)
    }

    /// The limit at plus infinity of what has a power series there.
    fn by_series(
        &mut self,
        body: &Expr,
        variable: &Symbol,
    ) -> Result<Option<Fraction>, LowerError> {
        let Some(value) = self.limit_of_expansion(body, variable)? else {
            return Ok(None);
        };
        let held = self.held_beside(body, variable)?;
        self.conditions.zero.extend(held);
        Ok(Some(value))
    }

    /// The value at a finite point, of what sines, cosines, exponentials or roots are in: it is the limit where nothing is divided by 0 there,
    /// and everything under a root or in a logarithm is positive there. `None` for what is rational and what else there is.
    fn where_it_is_continuous(
        &mut self,
        value: &Fraction,
        inner: &Conditions,
        variable: &Symbol,
        place: &Expr,
    ) -> Result<Option<Fraction>, LowerError> {
        let explicit = expr_of_fraction(value, self.atoms);
        let is_smooth = |part: &Expr| match part {
            Expr::Call(function, _) => matches!(
                function,
                Function::Sin | Function::Cos | Function::Exp | Function::Ln
            ),
            part => part.is_arithmetic(),
        };
        let rational = !explicit.any(&|part| matches!(part, Expr::Call(..)) || part.is_root());
        if rational || place.mentions(variable) || explicit.any(&|part| !is_smooth(part)) {
            return Ok(None);
        }
        let held = self.held_beside(&explicit, variable)?;
        let unknown = !inner.doubtful.is_empty() || !inner.bases.is_empty();
        if unknown || !explicit.mentions(variable) && !held.is_empty() {
            return Ok(None);
        }
        // What does not change on the way is so there, or nowhere; what does must be so there, or more would have to be known.
        let (lasting, changing): (Vec<&Polynomial>, Vec<&Polynomial>) =
            (inner.nonzero.iter()).partition(|own| !expr_of(own, self.atoms).mentions(variable));
        let at_place =
            |own: &Polynomial, atoms: &_| expr_of(own, atoms).substitute(variable, place);
        let changing: Vec<Expr> = changing
            .into_iter()
            .map(|own| at_place(own, self.atoms))
            .collect();
        let signs = inner.positive.iter().chain(&inner.nonnegative);
        let signs: Vec<Expr> = signs.map(|own| at_place(own, self.atoms)).collect();
        let outer = std::mem::take(&mut self.conditions);
        let mut there = || {
            let value = self.lower(&explicit.substitute(variable, place))?;
            for condition in &changing {
                let divisor = self.lower(condition)?.numerator().clone();
                self.conditions.away.insert(divisor);
            }
            for condition in &signs {
                let sign = sign_of_fraction(&self.lower(condition)?)?;
                self.conditions.positive.insert(sign);
            }
            Ok(value)
        };
        let there = there();
        let own = std::mem::replace(&mut self.conditions, outer);
        let there = match there {
            Err(LowerError::DivisionByZero) => return Ok(None),
            there => there?,
        };
        let is_positive = |own: &Polynomial| own.as_constant().is_some_and(|c| c.is_positive());
        let fits = own.doubtful.is_empty()
            && own.bases.is_empty()
            && own.zero.is_empty()
            && own.positive.iter().chain(&own.nonnegative).all(is_positive);
        let away = own.nonzero.iter().chain(&own.away);
        let away = away
            .filter(|own| !lasting.contains(own) && own.as_constant().is_none_or(|c| c.is_zero()));
        let away: Vec<Polynomial> = away.cloned().collect();
        if !fits || away.iter().any(Polynomial::is_zero) {
            return Ok(None);
        }
        self.conditions.nonzero.extend(lasting.into_iter().cloned());
        self.conditions
            .zero
            .extend(inner.zero.iter().cloned().chain(held));
        self.conditions.away.extend(away);
        Ok(Some(there))
    }

    /// What must be 0 for all that is in a term beside a variable not to move with it.
    fn held_beside(
        &mut self,
        term: &Expr,
        variable: &Symbol,
    ) -> Result<Vec<Polynomial>, LowerError> {
        let others = term.free_symbols().into_iter();
        let others = others.filter(|own| own != variable);
        let others: Set<Var> = others
            .map(|own| self.atoms.var(self.atom_of_symbol(&own)))
            .collect();
        self.slopes(&others, variable)
    }

    /// The slopes of unknowns by a variable, of those that are not known to stand still.
    fn slopes(
        &mut self,
        vars: &Set<Var>,
        variable: &Symbol,
    ) -> Result<Vec<Polynomial>, LowerError> {
        let mut slopes = Vec::new();
        for &var in vars {
            let change = self.atom_derivative(var, variable)?;
            if !change.is_zero() {
                slopes.push(change.numerator().clone());
            }
        }
        Ok(slopes)
    }

    /// The only exponential in which the variable is, and what must be positive so that it grows beyond all bounds towards
    /// plus infinity; nothing where something else is in the way.
    fn growing(
        &mut self,
        vars: &Set<Var>,
        variable: &Symbol,
        point: &LimitPoint,
    ) -> Result<Option<(Var, Polynomial)>, LowerError> {
        if *point != LimitPoint::PlusInfinity {
            return Ok(None);
        }
        let moving = |own: &&Var| match self.atoms.atom(**own) {
            Atom::Opaque(Expr::Call(Function::Exp, exponent)) => exponent.mentions(variable),
            _ => false,
        };
        let found: Vec<Var> = vars.iter().filter(moving).copied().collect();
        let &[var] = &found[..] else {
            return Ok(None);
        };
        let rate = self.rate_far_out(var, variable)?;
        Ok(match rate {
            Some(rate) => Some((var, sign_of_fraction(&rate)?)),
            None => None,
        })
    }

    /// The leading coefficient of f'/f, where that is a polynomial in the variable with coefficients that do not move: if it is positive, f
    /// grows towards plus infinity at least as an exponential does, `e^{a x^2}` as `a > 0`.
    fn rate_far_out(
        &mut self,
        var: Var,
        variable: &Symbol,
    ) -> Result<Option<Fraction>, LowerError> {
        let slope = self.atom_derivative(var, variable)?;
        let rate = slope.times(&inverse(&Polynomial::var(var).into())?)?;
        let own = self.atom_of_symbol(variable);
        let coefficients = rate.numerator().in_powers_of(self.atoms.var(own));
        let below = rate.expanded_denominator()?;
        let stays = |polynomial: &Polynomial| {
            let vars = polynomial.vars();
            let mut atoms = vars.iter().map(|&var| self.atoms.atom(var));
            atoms.all(|atom| self.is_constant(atom, variable))
        };
        let Some(leading) = coefficients.last().filter(|own| !own.is_zero()) else {
            return Ok(None);
        };
        if !coefficients.iter().chain([&below]).all(stays) {
            return Ok(None);
        }
        let far_out = Fraction::from(leading.clone()).times(&inverse(&below.into())?)?;
        Ok(Some(far_out))
    }

    /// What must not vanish, or must be positive, near the point: as a polynomial in what grows, fastest first, it does if its
    /// leading coefficient does.
    fn needed_on_the_way(&mut self, inner: &Conditions, growing: &[Var]) {
        let lead = |p: &Polynomial| {
            let lead = |p: Polynomial, &var: &Var| p.in_powers_of(var).pop().unwrap_or_default();
            growing.iter().fold(p.clone(), lead)
        };
        for divisor in &inner.nonzero {
            let lead = lead(divisor);
            if lead.as_constant().is_none() {
                self.conditions.nonzero.insert(lead);
            }
        }
        let signs = inner.positive.iter().chain(&inner.nonnegative);
        self.conditions.positive.extend(signs.map(lead));
    }
}

/// The index of a sum without end, where it starts and what is summed.
fn endless<'a>(
    body: &'a Expr,
    variable: &Symbol,
    point: &LimitPoint,
) -> Option<(&'a Symbol, &'a Expr, &'a Expr)> {
    let Expr::Series {
        index,
        from,
        to,
        body,
    } = body
    else {
        return None;
    };
    let ends = matches!(&**to, Expr::Symbol(own) if own == variable);
    let is_endless = ends && *point == LimitPoint::PlusInfinity && index != variable;
    (is_endless && !from.mentions(variable) && !body.mentions(variable))
        .then_some((index, from, body))
}

/// Whether a variable stands in a function, under a root or in a base of which the exponent is no number.
fn is_in_function(body: &Expr, variable: &Symbol) -> bool {
    body.any(&|part| match part {
        Expr::Call(_, of) => of.mentions(variable),
        Expr::Power(base, exponent) => {
            let is_whole = matches!(&**exponent, Expr::Number(own) if own.is_integer());
            !is_whole && base.mentions(variable)
        }
        _ => false,
    })
}

/// Whether a variable is nothing but a limit of an integral: what `\int_a^\infty` is read with.
fn is_no_more_than_a_limit(body: &Expr, variable: &Symbol) -> bool {
    let Expr::Integral { body, from, to, .. } = body else {
        return false;
    };
    let is = |limit: &Expr| matches!(limit, Expr::Symbol(own) if own == variable);
    let others = [&**from, &**to, &**body].into_iter().filter(|own| !is(own));
    (is(from) || is(to)) && !others.into_iter().any(|own| own.mentions(variable))
}

/// The limit at infinity by the leading terms; `None` where it is not finite.
fn limit_at_infinity(
    above: &Polynomial,
    below: &Polynomial,
    var: Var,
) -> Result<Option<Parts>, LowerError> {
    let (m, n) = (above.degree_in(var), below.degree_in(var));
    if m.max(n) > HIGHEST_DEGREE {
        return Err(LowerError::TooLarge);
    }
    let lead = |p: &Polynomial| p.in_powers_of(var).pop().unwrap_or_default();
    Ok(match m.cmp(&n) {
        std::cmp::Ordering::Less => Some((Fraction::default(), lead(below).into())),
        std::cmp::Ordering::Equal => Some((lead(above).into(), lead(below).into())),
        std::cmp::Ordering::Greater => None,
    })
}

/// The limit at a finite point: common zeros are divided out, then the point is put in.
fn limit_at(
    above: &Polynomial,
    below: &Polynomial,
    var: Var,
    point: &Fraction,
) -> Result<Option<Parts>, LowerError> {
    let Some(point) = point.as_polynomial() else {
        return Ok(None);
    };
    let root = Polynomial::var(var).minus(point);
    let (mut above, mut below) = (above.clone(), below.clone());
    loop {
        let bottom = below.substitute(var, point)?;
        let top = above.substitute(var, point)?;
        if !bottom.is_zero() {
            return Ok(Some((top.into(), bottom.into())));
        }
        if !top.is_zero() || above.is_zero() {
            return Ok(None);
        }
        let (Some(a), Some(b)) = (above.divided_by(&root), below.divided_by(&root)) else {
            return match is_spent() {
                true => Err(LowerError::TooLarge),
                false => Ok(None),
            };
        };
        (above, below) = (a, b);
    }
}
