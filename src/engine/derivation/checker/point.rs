use crate::algebra::{BigInt, BigRational, EvaluateError, Expr, Formula, Sides, Symbol, Values};
use crate::document::Span;
use crate::kernel::{Assignment, Claim, Refuted, definition};
use crate::notation::{read_expr, read_symbol};

/// Exact values for the symbols of an equation, by their LaTeX names.
///
/// ```
/// use cradle_engine::derivation::{Checker, Point};
///
/// let page = Checker::from_markdown("share.md", r"$$ \frac{d\eta}{d\mu} = \frac{4(1 - \mu)}{(1 + \mu)^3} \tag{1} $$");
/// let at = Point::new().with("\\mu", 3).with_term("\\eta", r"\frac{4\mu}{(1+\mu)^2}");
/// let sides = &page.sides_at("1", &at).unwrap()[0];
/// assert_eq!((sides.left.to_string(), sides.holds), ("-1/8".to_owned(), true));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Point {
    values: Values,
    problem: Option<EvaluateError>,
}

impl Point {
    /// No values yet.
    pub fn new() -> Self {
        Point::default()
    }

    /// Gives a symbol a whole number.
    pub fn with(self, name: &str, value: impl Into<BigInt>) -> Self {
        self.with_ratio(name, BigRational::from_integer(value.into()))
    }

    /// Gives a symbol any rational number.
    pub fn with_ratio(self, name: &str, value: BigRational) -> Self {
        self.named(name, |point, symbol| {
            point.values.symbols.insert(symbol, value);
        })
    }

    /// Lists the elements of a sequence: those of `u` are `u_1`, `u_2` and so on.
    pub fn with_list(self, name: &str, elements: impl IntoIterator<Item = BigRational>) -> Self {
        self.named(name, |point, symbol| {
            let elements = elements.into_iter().collect();
            point.values.sequences.insert(symbol, elements);
        })
    }

    /// Defines a symbol by a term in others: then it can be differentiated too.
    pub fn with_term(mut self, name: &str, term: &str) -> Self {
        match read_expr(term, Span::new(0, term.len())) {
            Ok(expr) => self.named(name, |point, symbol| {
                point.values.terms.insert(symbol, expr);
            }),
            Err(error) => {
                self.complain(term, error.message);
                self
            }
        }
    }

    /// Gives the derivative of a symbol of which no term says how it varies.
    pub fn with_slope(self, name: &str, variable: &str, value: BigRational) -> Self {
        self.named(name, |point, symbol| match read_symbol(variable) {
            Ok(variable) => {
                point.values.slopes.insert((symbol, variable), value);
            }
            Err(error) => point.complain(variable, error.message),
        })
    }

    fn named(mut self, name: &str, then: impl FnOnce(&mut Point, Symbol)) -> Self {
        match read_symbol(name) {
            Ok(symbol) => then(&mut self, symbol),
            Err(error) => self.complain(name, error.message),
        }
        self
    }

    /// The first thing that could not be read is told when the point is used.
    fn complain(&mut self, text: &str, message: String) {
        self.problem.get_or_insert(EvaluateError::Unreadable {
            text: text.to_owned(),
            message,
        });
    }

    /// The point at which the kernel has seen a claim refuted.
    pub fn at_witness(refuted: &Refuted) -> Self {
        Point {
            values: values_at(refuted.claim(), refuted.witness()),
            problem: None,
        }
    }

    /// The values themselves.
    pub fn values(&self) -> &Values {
        &self.values
    }

    /// The value of a term.
    ///
    /// # Errors
    /// It has none here, or a name of the point could not be read.
    pub fn value(&self, term: &Expr) -> Result<BigRational, EvaluateError> {
        self.usable()?.value(term)
    }

    /// Both sides of what a formula states.
    ///
    /// # Errors
    /// As [`Checker::sides_at`](super::Checker::sides_at).
    pub fn sides(&self, formula: &Formula) -> Result<Vec<Sides>, EvaluateError> {
        self.usable()?.sides(formula)
    }

    /// Whether a formula is true here.
    ///
    /// # Errors
    /// As [`Point::sides`].
    pub fn holds(&self, formula: &Formula) -> Result<bool, EvaluateError> {
        self.usable()?.holds(formula)
    }

    fn usable(&self) -> Result<&Values, EvaluateError> {
        match &self.problem {
            Some(problem) => Err(problem.clone()),
            None => Ok(&self.values),
        }
    }
}

/// The values that an assignment gives the symbols of a claim, the definitions that it puts in included.
pub fn values_at(claim: &Claim, at: &Assignment) -> Values {
    let fixed = claim
        .domains
        .iter()
        .filter(|(_, d)| d.constant || d.integer);
    let mut values = Values {
        symbols: at.symbols.clone(),
        sequences: at.sequences.clone(),
        slopes: at.derivatives.clone(),
        higher: at
            .course
            .as_ref()
            .map(|c| c.higher.clone())
            .unwrap_or_default(),
        constants: fixed.map(|(symbol, _)| symbol.clone()).collect(),
        // What the kernel is told nothing of does not vary.
        still: true,
        ..Values::default()
    };
    let hypotheses = at.unfold.iter().filter_map(|&h| claim.hypotheses.get(h));
    for hypothesis in hypotheses {
        let mut formula = Formula::clone(&hypothesis.formula);
        for (symbol, term) in &values.terms {
            formula = formula.map_terms(|t| t.substitute(symbol, term));
        }
        if let Some((symbol, term)) = definition(&formula) {
            values.terms.insert(symbol, term);
        }
    }
    values
}
