use super::super::{Claim, Reject};
use super::Size;
use crate::algebra::{
    Atom, Atoms, Expr, Function, Lowering, Polynomial, Rational, Symbol, expr_of, expr_of_atom,
};
use crate::sorted::{Map, Set};

/// A term as a number times a product of rational powers of quantities.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Product {
    /// The number in front, without its sign.
    pub number: Size,
    /// Whether the number is negative.
    pub negative: bool,
    /// Each quantity with its exponent, which is not 0.
    pub exponents: Map<Expr, Rational>,
    /// Whether a derivative was read as a quotient: then the number in front says nothing.
    pub slope: bool,
}

impl Product {
    fn quantity(term: Expr) -> Product {
        Product {
            exponents: Map::from([(term, Rational::one())]),
            ..Product::default()
        }
    }

    /// `self · other^exponent`.
    pub fn times(&self, other: &Product, exponent: &Rational) -> Product {
        let mut product = self.clone();
        for (term, own) in &other.exponents {
            let slot = product
                .exponents
                .entry(term.clone())
                .or_insert_with(Rational::zero);
            *slot += own * exponent;
        }
        product.exponents.retain(|_, e| !e.is_zero());
        product.number = product.number.times(&other.number, exponent);
        product.negative ^= other.negative && !exponent.is_zero();
        product.slope |= other.slope;
        product
    }

    /// `self / other`.
    pub fn over(&self, other: &Product) -> Product {
        self.times(other, &-Rational::one())
    }
}

/// What has to be alike for a sum, or an integral that does not begin at 0, to scale as a product.
#[derive(Clone, Debug)]
pub(super) struct Compound {
    /// The quantity that stands for the sum or integral in every product.
    pub quantity: Expr,
    /// What it then scales as.
    pub scales_as: Product,
    /// Products that must be found to scale as 1.
    pub alike: Vec<Product>,
}

/// Reads terms as products.
#[derive(Clone)]
pub(super) struct Reader {
    atoms: Atoms,
    sequences: Set<Symbol>,
    constants: Set<Symbol>,
}

impl Reader {
    pub fn new(claim: &Claim) -> Reader {
        let constant = claim.domains.iter().filter(|(_, d)| d.constant);
        Reader {
            atoms: Atoms::default(),
            sequences: claim.sequences.keys().cloned().collect(),
            constants: constant.map(|(s, _)| s.clone()).collect(),
        }
    }

    fn lowering(&mut self) -> Lowering<'_> {
        Lowering {
            sequences: &self.sequences,
            constants: &self.constants,
            ..Lowering::plain(&mut self.atoms)
        }
    }

    fn lowered(&mut self, term: &Expr) -> Result<crate::algebra::Fraction, Reject> {
        let mut lowering = self.lowering();
        let value = lowering.lower(term)?;
        // Quantities are not 0 here, and roots are of sizes; but a limit or a sum may have no value at all.
        let conditions = lowering.conditions;
        let plain = conditions.zero.is_empty() && conditions.away.is_empty();
        match plain && conditions.doubtful.is_empty() {
            true => Ok(value),
            false => Err(Reject::NotAProduct(term.clone())),
        }
    }

    /// A term as a product; sums and what is not understood are quantities of their own.
    pub fn read(&mut self, term: &Expr) -> Result<Product, Reject> {
        let value = self.lowered(term)?;
        if value.numerator().is_zero() {
            return Err(Reject::NotAProduct(term.clone()));
        }
        let mut product = self.polynomial(&value.numerator().clone())?;
        let below: Vec<(Polynomial, u32)> =
            value.denominator().map(|(f, e)| (f.clone(), e)).collect();
        for (factor, exponent) in below {
            let mut divisor = self.polynomial(&factor)?;
            divisor.negative &= exponent % 2 == 1;
            product = product.times(&divisor, &-Rational::from(exponent));
        }
        Ok(product)
    }

    fn polynomial(&mut self, polynomial: &Polynomial) -> Result<Product, Reject> {
        let content = polynomial.content();
        let common = Polynomial::term(content.clone(), Rational::one());
        let rest = polynomial.divided_by(&common).unwrap_or_default();
        let (number, mut product) = match rest.as_constant() {
            Some(number) => (number, Product::default()),
            None => {
                let lead = rest.leading().map_or_else(Rational::one, |t| t.1.clone());
                let sum = expr_of(&rest.monic(), &self.atoms);
                (lead, Product::quantity(sum))
            }
        };
        product.number = Size::from(number.abs());
        product.negative = number.is_negative();
        for &(var, exponent) in content.powers() {
            let atom = self.atoms.atom(var).clone();
            let mut factor = self.atom(&atom)?;
            factor.negative &= exponent % 2 == 1;
            product = product.times(&factor, &Rational::from(exponent));
        }
        Ok(product)
    }

    fn atom(&mut self, atom: &Atom) -> Result<Product, Reject> {
        let Atom::Opaque(term) = atom else {
            return Ok(Product::quantity(expr_of_atom(atom)));
        };
        match term {
            Expr::Power(base, exponent) => match &**exponent {
                Expr::Number(exponent) => {
                    let exponent = Rational::from(exponent);
                    let mut root = Product::default().times(&self.read(base)?, &exponent);
                    // An odd root of something negative is negative.
                    root.negative &= exponent.denom() % 2u32 != 0.into();
                    Ok(root)
                }
                _ => Ok(Product::quantity(term.clone())),
            },
            Expr::Call(Function::Abs, inner) => Ok(Product {
                negative: false,
                ..self.read(inner)?
            }),
            Expr::Derivative { body, variable } | Expr::Partial { body, variable, .. } => {
                let clock = Product::quantity(Expr::Symbol(variable.clone()));
                Ok(Product {
                    slope: true,
                    ..self.read(body)?.over(&clock)
                })
            }
            Expr::Integral { .. } => match self.integral(term)? {
                Some(whole) if whole.alike.is_empty() => Ok(whole.scales_as),
                _ => Ok(Product::quantity(term.clone())),
            },
            _ => Ok(Product::quantity(term.clone())),
        }
    }

    /// `∫_from^to body d variable` as `body · to`, where the body is a product of powers of quantities and
    /// `from` is 0, or scales as `to`.
    fn integral(&mut self, term: &Expr) -> Result<Option<Compound>, Reject> {
        let Expr::Integral {
            body,
            variable,
            from,
            to,
        } = term
        else {
            return Ok(None);
        };
        let (mut inside, end) = (self.read(body)?, self.read(to)?);
        let own = inside.exponents.remove(&Expr::Symbol(variable.clone()));
        let plain = |term: &Expr| matches!(term, Expr::Symbol(_) | Expr::Apply(..));
        let power = own.unwrap_or_else(Rational::zero) + Rational::one();
        // ∫ x^-1 dx from 0 has no value.
        if !inside.exponents.keys().all(plain) || !power.is_positive() || end.negative {
            return Ok(None);
        }
        // Where everything else stands still the integral of x^(p-1) is x^p / p.
        inside.number = inside.number.over(&Size::from(power.clone()));
        let start = self.lowered(from)?;
        let mut alike = Vec::new();
        if !start.numerator().is_zero() {
            alike.push(self.read(from)?.over(&end));
        }
        Ok(Some(Compound {
            quantity: term.clone(),
            scales_as: inside.times(&end, &power),
            alike,
        }))
    }

    /// What must be alike in a sum or integral.
    pub fn compound(&mut self, term: &Expr) -> Result<Compound, Reject> {
        let no = || Reject::NotAProduct(term.clone());
        if let Expr::Integral { .. } = term {
            let found = self.integral(term)?;
            return found.filter(|whole| !whole.alike.is_empty()).ok_or_else(no);
        }
        let value = self.lowered(term)?;
        let sum = value.as_polynomial().filter(|p| p.len() > 1).cloned();
        let sum = sum.ok_or_else(no)?;
        let mut parts = Vec::new();
        for (monomial, coefficient) in sum.terms() {
            let part = Polynomial::term(monomial.clone(), coefficient.clone());
            parts.push(self.polynomial(&part)?);
        }
        let first = parts.remove(0);
        Ok(Compound {
            quantity: expr_of(&sum.monic(), &self.atoms),
            alike: parts.iter().map(|part| part.over(&first)).collect(),
            scales_as: first,
        })
    }

    /// The value of a term that has one: a number once numbers are put in.
    pub fn constant(&mut self, term: &Expr) -> Result<Option<Rational>, Reject> {
        Ok(self.lowered(term)?.as_constant())
    }

    /// Whether a term has a value wherever all its quantities are positive, and whether it is positive there.
    pub fn is_positive_by_sight(&mut self, term: &Expr) -> Result<(bool, bool), Reject> {
        let mut lowering = self.lowering();
        let value = lowering.lower(term)?;
        let conditions = lowering.conditions;
        let atoms = &self.atoms;
        let positive = |p: &Polynomial| {
            p.terms().all(|(_, c)| c.is_positive())
                && p.vars()
                    .iter()
                    .all(|&v| is_positive(&expr_of_atom(atoms.atom(v))))
        };
        let signs = conditions.nonnegative.iter().chain(&conditions.positive);
        let mut needed = conditions.divisors().chain(signs);
        let above = value.numerator();
        let defined = needed.all(positive)
            && conditions.zero.is_empty()
            && conditions.doubtful.is_empty()
            && above
                .vars()
                .iter()
                .all(|&v| is_positive(&expr_of_atom(atoms.atom(v))));
        Ok((
            defined,
            defined && positive(above) && value.denominator().all(|(f, _)| positive(f)),
        ))
    }
}

/// Whether a term is positive wherever all quantities in it are.
fn is_positive(term: &Expr) -> bool {
    match term {
        Expr::Symbol(_) | Expr::Apply(..) => true,
        Expr::Number(value) => value > &crate::algebra::BigRational::from_integer(0.into()),
        Expr::Sum(_) | Expr::Product(_) | Expr::Quotient(..) => term.children().all(is_positive),
        Expr::Power(base, exponent) => is_positive(base) && matches!(&**exponent, Expr::Number(_)),
        _ => false,
    }
}
