//! Derivatives: of rational functions by their rules, of each unknown 1, 0 or an unknown of its own.

use super::lower::{LowerError, Lowered, Lowering};
use super::{
    Atom, Expr, Fraction, Held, Polynomial, Rational, Symbol, Var, element_parts, expr_of_atom,
};
use crate::sorted::Set;

impl Lowering<'_> {
    /// The value of a derivative, a partial one if it is said what is held fixed.
    pub(super) fn differentiated(
        &mut self,
        body: &Expr,
        variable: &Symbol,
        partial: Option<Held>,
    ) -> Lowered {
        let body = self.lower(body)?;
        let outside = std::mem::replace(&mut self.partial, partial);
        let slope = self.derivative(&body, variable);
        self.partial = outside;
        slope
    }

    /// The derivative of a value by a symbol; [`Lowering::conditions`] grows by what it needs.
    ///
    /// # Errors
    /// As [`Lowering::lower`].
    pub fn derivative(&mut self, value: &Fraction, variable: &Symbol) -> Lowered {
        let mut total = Fraction::default();
        let mut vars: Set<Var> = value.numerator().vars().into_iter().collect();
        for (factor, _) in value.denominator() {
            vars.extend(factor.vars());
        }
        for var in vars {
            let inner = self.atom_derivative(var, variable)?;
            if inner.is_zero() {
                continue;
            }
            total = total.plus(&partial_derivative(value, var)?.times(&inner)?)?;
        }
        Ok(total)
    }

    /// The derivative of one unknown: 1, 0, or an unknown of its own.
    pub(super) fn atom_derivative(&mut self, var: Var, variable: &Symbol) -> Lowered {
        let atom = self.atoms.atom(var).clone();
        if atom == self.atom_of_symbol(variable) {
            return Ok(Rational::one().into());
        }
        if self.is_constant(&atom, variable) {
            return Ok(Fraction::default());
        }
        let body = expr_of_atom(&atom);
        if let Expr::Call(function, argument) = &body
            && let Some(slope) = self.derivative_of_call(*function, argument, variable)?
        {
            return Ok(slope);
        }
        // A root of a symbol would lead back to itself.
        if let Expr::Power(base, exponent) = &body
            && !matches!(atom, Atom::Root { .. })
        {
            return self.derivative_of_power(var, base, exponent, variable);
        }
        let slope = match &self.partial {
            Some(held) => held.slope_of(body, variable),
            None => body.differentiated_by(variable),
        };
        Ok(self.atom(Atom::Opaque(slope)))
    }

    /// The derivative of an unknown that is a power, by the rules for products and for logarithms:
    ///
    /// $$ \frac{d}{dx} b^r = b^r \left(\frac{r}{b} \frac{db}{dx} + \ln b \, \frac{dr}{dx}\right) $$
    ///
    /// Where the base changes it must not vanish, and where the exponent does it must be positive.
    fn derivative_of_power(
        &mut self,
        power: Var,
        base: &Expr,
        exponent: &Expr,
        variable: &Symbol,
    ) -> Lowered {
        let base = self.lower_apart(base)?;
        let exponent = self.lower_apart(exponent)?;
        let inner = self.derivative(&base, variable)?;
        let rise = self.derivative(&exponent, variable)?;
        let own = Fraction::from(Polynomial::var(power));
        let mut slope = Fraction::default();
        if !inner.is_zero() {
            let share = exponent.times(&self.recip(&base)?)?;
            slope = own.times(&share)?.times(&inner)?;
        }
        if !rise.is_zero() {
            let logarithm = self.logarithm_of_positive(&base)?;
            slope = slope.plus(&own.times(&logarithm)?.times(&rise)?)?;
        }
        Ok(slope)
    }

    /// Whether an unknown is made of declared constants alone, the variable not among them.
    pub(super) fn is_constant(&self, atom: &Atom, variable: &Symbol) -> bool {
        // Along the line of a partial derivative something else may change than otherwise.
        let still = |s: &Symbol| {
            self.partial.is_none()
                && !self.still.is_empty()
                && self.still.contains(&(s.clone(), variable.clone()))
        };
        let held = |s: &Symbol| self.partial.as_ref().is_some_and(|own| own.holds(s));
        let constant =
            |s: &Symbol| s != variable && (self.constants.contains(s) || held(s) || still(s));
        match atom {
            Atom::Symbol(symbol) => constant(symbol),
            // How many elements there are does not change while something else does.
            Atom::PowerSum { to, powers } => {
                let own = element_parts(variable).map(|parts| parts.0);
                let still = |s: &Symbol| constant(s) && own.as_ref() != Some(s);
                to != variable && powers.iter().all(|(sequence, _)| still(sequence))
            }
            atom => {
                let body = expr_of_atom(atom);
                // That `f` and `y` are held fixed says nothing of a slope of `f` by `y`, but where they never change.
                let is_slope =
                    |part: &Expr| matches!(part, Expr::Derivative { .. } | Expr::Partial { .. });
                let mut names = body.free_symbols().into_iter();
                let still = match self.partial.is_some() && body.any(&is_slope) {
                    true => names.all(|own| own != *variable && self.constants.contains(&own)),
                    false => names.all(|own| constant(&own)),
                };
                still && !body.has_elements()
            }
        }
    }

    /// The value of a term in what is being differentiated, where it is not being differentiated itself.
    pub(super) fn lower_apart(&mut self, term: &Expr) -> Lowered {
        let outside = self.partial.take();
        let value = self.lower(term);
        self.partial = outside;
        value
    }
}

fn partial_derivative(value: &Fraction, var: Var) -> Lowered {
    let mut below = Fraction::from(Rational::one());
    for (factor, exponent) in value.denominator() {
        below = below.times(&Fraction::from(factor.clone()).pow(exponent)?)?;
    }
    let invert = |f: &Fraction| -> Lowered { f.recip()?.ok_or(LowerError::DivisionByZero) };
    let mut total = Fraction::from(value.numerator().derivative(var)).times(&invert(&below)?)?;
    // (1/f^e)' = -e f' / f^(e+1)
    for (factor, exponent) in value.denominator() {
        let slope = factor.derivative(var);
        if slope.is_zero() {
            continue;
        }
        let slope = slope.scaled(&exponent.into());
        let change = Fraction::from(slope).times(&invert(&factor.clone().into())?)?;
        total = total.plus(&value.times(&change)?.negated())?;
    }
    Ok(total)
}
