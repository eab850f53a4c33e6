//! Numeric claims: definitions put in until figures are left, then weighed.

mod coefficient;
mod complex;
mod constants;
mod decimals;
mod figures;
mod put_in;
mod reckoned;
mod rounded;
mod solved;

use num_traits::{One, Zero};

use crate::algebra::{BigRational, Expr, Formula, Function, Relation, Symbol};
use crate::derivation::{Assumed, Datum, Derivation, Goal, Printed, Source, goals};
use crate::document::Span;
use crate::interval::{Compared, Figures, Interval, NoInterval};
use crate::notation::{
    Precision, Rounding, has_units, in_si, measured, read_formulas, without_units,
};
use crate::sorted::{Map, Set};

pub(super) use self::rounded::{is_measured, open_by_figures};
use self::solved::of_element;

/// "Much greater" is taken for: at least so many times.
pub const FAR: i32 = 10;
/// How many definitions are tried before a symbol is given up.
const MOST_TRIED: usize = 4000;
/// How many symbols without a value may cancel.
const MOST_FREE: usize = 4;

/// A numeric claim, evaluated over its figures. It is no proof: it is as good as they are.
#[derive(Clone, Debug)]
pub struct Numeric {
    /// A link at a time.
    pub links: Vec<Link>,
    /// The figures that were used, and the page that declares each.
    pub data: Map<Symbol, (usize, Datum)>,
    /// What was put in for the symbols without figures, or for a whole side, each once, and where it comes from.
    pub put_in: Vec<(Expr, Expr, Source)>,
    /// The symbols of which nothing was found that says how great they are.
    pub unknown: Set<Symbol>,
    /// What a link that is contradicted would say, with one small edit with which all is supported.
    pub nearest: Option<Formula>,
}

/// A link of a numeric claim.
#[derive(Clone, Debug)]
pub struct Link {
    /// What is claimed.
    pub goal: Goal,
    /// The values of both sides and of their quotient, where they were found.
    pub sides: Option<(Interval, Interval)>,
    /// Left over right, with what is common to both cancelled; nothing where the right side may be 0.
    pub ratio: Option<Interval>,
    /// How near `≈` is meant.
    pub near: Option<BigRational>,
    /// What it comes to.
    pub outcome: Weighed,
}

/// What figures say of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Weighed {
    /// True whatever the figures are within their bounds.
    Supported,
    /// False whatever they are.
    Contradicted,
    /// Either, as the figures may be.
    NotSettled,
    /// Not evaluated.
    NoValue(NoInterval),
    /// `≈`, and it is not said how near.
    NoTolerance,
    /// Not a relation between numbers.
    NoComparison,
}

impl Numeric {
    /// Links that were weighed without figures of symbols.
    fn of_links(links: Vec<Link>) -> Numeric {
        Numeric {
            links,
            data: Map::new(),
            put_in: Vec::new(),
            unknown: Set::new(),
            nearest: None,
        }
    }

    /// What the links together come to: the first that is not supported.
    pub fn outcome(&self) -> &Weighed {
        let mut outcomes = self.links.iter().map(|link| &link.outcome);
        let contradicted = outcomes.clone().find(|o| **o == Weighed::Contradicted);
        contradicted
            .or_else(|| outcomes.find(|o| **o != Weighed::Supported))
            .unwrap_or(match self.links.is_empty() {
                true => &Weighed::NoComparison,
                false => &Weighed::Supported,
            })
    }

    /// True whatever the figures are within their bounds.
    pub fn is_supported(&self) -> bool {
        *self.outcome() == Weighed::Supported
    }
}

/// How near the numbers are taken that premises print.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Taken {
    /// As they are printed, whatever their uncertainty; what is claimed may be rounded.
    Exactly,
    /// As they are printed, and within their uncertainty where one is stated.
    AsStated,
    /// Within half a unit of their last decimal; what is claimed may be rounded, too.
    Rounded,
}

/// Evaluates goals from what they cite, and the figures of its pages.
fn evaluate(derivation: &Derivation, at: usize, goals: &[Goal], assumed: &[Assumed]) -> Numeric {
    weigh_rounded(derivation, at, goals, assumed, Taken::AsStated, &[])
}

/// The same with numbers that are taken as they are rounded, and with what the page prints for symbols of which nothing else says what
/// they are.
fn weigh_rounded(
    derivation: &Derivation,
    at: usize,
    goals: &[Goal],
    assumed: &[Assumed],
    taken: Taken,
    said: &[Printed],
) -> Numeric {
    let own = derivation.equations[at].page;
    let mut pages = vec![own];
    for assumed in assumed {
        let page = match assumed.source {
            Source::Equation(premise) => derivation.equations[premise].page,
            Source::Local(page, _) => page,
            Source::Step | Source::Taken | Source::Propagation | Source::Nature => own,
        };
        if !pages.contains(&page) {
            pages.push(page);
        }
    }
    let mut known = Known {
        derivation,
        pages,
        assumed,
        taken,
        said,
        tried: 0,
        free: Set::new(),
        unit: None,
        data: Map::new(),
        put_in: Vec::new(),
        unknown: Set::new(),
    };
    let near = derivation.equations[at].numeric.clone().flatten();
    let links = goals.iter().cloned();
    let links = links.map(|goal| known.link(goal, near.clone())).collect();
    Numeric {
        links,
        data: known.data,
        put_in: known.put_in,
        unknown: known.unknown,
        nearest: None,
    }
}

/// What is known of symbols where the claim stands.
struct Known<'a> {
    derivation: &'a Derivation,
    /// Its own page first.
    pages: Vec<usize>,
    assumed: &'a [Assumed],
    taken: Taken,
    said: &'a [Printed],
    tried: usize,
    /// What nothing gives a value, and which may be cancelled.
    free: Set<Symbol>,
    /// The imaginary unit in what is weighed.
    unit: Option<Symbol>,
    data: Map<Symbol, (usize, Datum)>,
    put_in: Vec<(Expr, Expr, Source)>,
    unknown: Set<Symbol>,
}

impl Known<'_> {
    fn link(&mut self, goal: Goal, near: Option<BigRational>) -> Link {
        let mut link = Link {
            goal,
            sides: None,
            ratio: None,
            near,
            outcome: Weighed::NoComparison,
        };
        let Formula::Relation {
            left,
            relation,
            right,
        } = link.goal.formula.clone()
        else {
            return link;
        };
        if matches!(
            relation,
            Relation::Scales | Relation::Proportional | Relation::Tends
        ) || !link.goal.suppositions.is_empty()
        {
            return link;
        }
        if let Some(term) = self.logarithm_of_units(&link.goal.formula) {
            link.outcome = Weighed::NoValue(NoInterval::Unsupported(term));
            return link;
        }
        if let Some(outcome) = self.weigh_complex(&link.goal) {
            link.outcome = outcome;
            return link;
        }
        let rounding = link.goal.rounding.as_ref();
        let relation = match relation {
            // What is rounded is near what it is rounded from.
            Relation::Equal if rounding.is_some() && self.taken != Taken::AsStated => {
                Relation::Approximately
            }
            own => own,
        };
        if relation == Relation::Approximately {
            link.near = link.near.or_else(|| rounding.map(|own| own.share.clone()));
        }
        let found = self
            .sides(&left, &right)
            .or_else(|error| self.sides_but_free(&left, &right, &error).ok_or(error))
            .or_else(|error| self.sides_by_whole(&left, &right).ok_or(error));
        let Compared {
            left,
            right,
            difference,
            ratio,
        } = match found {
            Ok(found) => found,
            Err(error) => {
                link.outcome = Weighed::NoValue(error);
                return link;
            }
        };
        link.outcome = weigh(relation, &difference, ratio.as_ref(), link.near.as_ref());
        link.sides = Some((left, right));
        link.ratio = ratio;
        if link.outcome != Weighed::Supported {
            self.leave_units(relation, &mut link);
        }
        link
    }

    /// The logarithm of a quantity that is printed with units, `\mathrm{pH} = -\log_{10} h` after `h = 8 \cdot 10^{-3}\,\mathrm{mol/L}`: that is meant in
    /// just these, and figures are in those of the SI.
    fn logarithm_of_units(&self, formula: &Formula) -> Option<Expr> {
        let is_printed = |symbol: &Symbol, own: &Formula| match own.as_equation() {
            Some((Expr::Symbol(of), value)) => of == symbol && has_units(value),
            _ => false,
        };
        let has_units = |symbol: &Symbol| {
            let mut assumed = self.assumed.iter();
            let mut said = self.said.iter();
            assumed.any(|own| is_printed(symbol, &own.formula))
                || said.any(|own| is_printed(symbol, &own.goal.formula))
        };
        let is_one = |part: &Expr| match part {
            Expr::Call(Function::Ln, of) => matches!(&**of, Expr::Symbol(of) if has_units(of)),
            _ => false,
        };
        let mut terms = formula.terms().into_iter();
        terms.find(|term| term.any(&is_one)).cloned()
    }

    /// Weighs a link of which one side has units and the other none again without them, `\frac{320 \cdot 480}{800} = 192\,\Omega`, if that
    /// supports it: they were left out until the end.
    fn leave_units(&mut self, relation: Relation, link: &mut Link) {
        let Formula::Relation { left, right, .. } = &link.goal.formula else {
            return;
        };
        if has_units(left) == has_units(right) {
            return;
        }
        let Ok(found) = self.sides(&without_units(left), &without_units(right)) else {
            return;
        };
        let near = link.near.as_ref();
        let outcome = weigh(relation, &found.difference, found.ratio.as_ref(), near);
        if outcome == Weighed::Supported {
            link.outcome = outcome;
            (link.sides, link.ratio) = (Some((found.left, found.right)), found.ratio);
        }
    }

    /// Within what the figures lie that were used.
    fn intervals(&self) -> impl Iterator<Item = (Symbol, Interval)> {
        self.data.iter().filter_map(|(symbol, (_, datum))| {
            let interval = Interval::new(datum.low.clone(), datum.high.clone())?;
            Some((symbol.clone(), interval))
        })
    }

    fn sides(&mut self, left: &Expr, right: &Expr) -> Result<Compared, NoInterval> {
        let left = self.in_data(left, &mut Vec::new())?;
        let right = self.in_data(right, &mut Vec::new())?;
        let figures: Figures = self.intervals().collect();
        figures.but_free(&self.free).compared(&left, &right)
    }

    /// The same where symbols without a value cancel, as `p_0` does in `p/p_0` after `p = 0.7 p_0`.
    fn sides_but_free(
        &mut self,
        left: &Expr,
        right: &Expr,
        error: &NoInterval,
    ) -> Option<Compared> {
        let mut error = error.clone();
        while let NoInterval::Unknown(symbol) = error
            && self.free.len() < MOST_FREE
            && self.free.insert(symbol)
        {
            match self.sides(left, right) {
                Ok(found) => return Some(found),
                Err(next) => error = next,
            }
        }
        None
    }

    /// The same where a premise says what all of the left side is, and nothing what its symbols are: `V/W` after `V/W = a/b`.
    fn sides_by_whole(&mut self, left: &Expr, right: &Expr) -> Option<Compared> {
        if matches!(left, Expr::Symbol(_)) {
            return None;
        }
        let (data, length) = (self.data.clone(), self.put_in.len());
        let assumed = self.assumed;
        assumed.iter().find_map(|own| {
            let value = match own.formula.as_equation()? {
                (term, value) | (value, term) if term == left => value,
                _ => return None,
            };
            self.data.clone_from(&data);
            self.put_in.truncate(length);
            let found = self.sides(value, right).ok()?;
            let put_in = (left.clone(), value.clone(), own.source);
            self.put_in.push(put_in);
            Some(found)
        })
    }

    /// A term with definitions put in until only symbols with figures remain.
    fn in_data(&mut self, term: &Expr, open: &mut Vec<Symbol>) -> Result<Expr, NoInterval> {
        if !is_evaluable(term) {
            return Err(NoInterval::Unsupported(term.clone()));
        }
        let mut result = term.clone();
        let mut replaced = Vec::new();
        for symbol in term.free_symbols() {
            let value = self.symbol(&symbol, open)?;
            if value != Expr::Symbol(symbol.clone()) {
                replaced.push((symbol, value));
            }
        }
        // What is put in contains nothing but symbols with figures, which stay as they are.
        for (symbol, value) in replaced {
            result = result.substitute(&symbol, &value);
        }
        Ok(result)
    }

    fn symbol(&mut self, symbol: &Symbol, open: &mut Vec<Symbol>) -> Result<Expr, NoInterval> {
        // Figures are in SI units.
        if measured(symbol).is_some() {
            return Ok(Expr::integer(1));
        }
        if self.unit.as_ref() == Some(symbol) {
            return Ok(Expr::Symbol(symbol.clone()));
        }
        let pages = self.pages.iter();
        let mut figures = pages.filter_map(|&page| {
            let datum = self.derivation.pages[page].data.get(symbol)?;
            Some((page, datum.clone()))
        });
        if let Some(datum) = figures.next() {
            self.data.insert(symbol.clone(), datum);
            return Ok(Expr::Symbol(symbol.clone()));
        }
        let mut pages = self.pages.iter();
        let is_declared =
            pages.any(|&page| self.derivation.pages[page].domains.get(symbol).is_some());
        if !is_declared && Figures::default().of(symbol).is_some() {
            return Ok(Expr::Symbol(symbol.clone()));
        }
        if let Some(datum) = self.printed(symbol) {
            self.data.insert(symbol.clone(), datum);
            return Ok(Expr::Symbol(symbol.clone()));
        }
        let is_own = |own: &Expr| matches!(own, Expr::Symbol(own) if own == symbol);
        if let Some((_, value, _)) = self.put_in.iter().find(|(own, ..)| is_own(own)) {
            let value = value.clone();
            open.push(symbol.clone());
            let result = self.in_data(&value, open);
            open.pop();
            return result;
        }
        if self.free.contains(symbol) {
            return Ok(Expr::Symbol(symbol.clone()));
        }
        let unknown = NoInterval::Unknown(symbol.clone());
        if open.contains(symbol) {
            return Err(unknown);
        }
        let mut first = None;
        // What is written as a definition comes before what must be solved, and so does what the page prints.
        for plain in [true, false] {
            if !plain && let Some(datum) = self.said_once(symbol) {
                let page = self.pages[0];
                self.data.insert(symbol.clone(), (page, datum));
                return Ok(Expr::Symbol(symbol.clone()));
            }
            for assumed in self.assumed {
                let solved = self.solved(&assumed.formula, symbol, plain);
                let element = || of_element(&assumed.formula, symbol).filter(|_| plain);
                let Some(value) = solved.or_else(element) else {
                    continue;
                };
                self.tried += 1;
                if self.tried > MOST_TRIED {
                    return Err(NoInterval::TooLarge);
                }
                open.push(symbol.clone());
                let (data, length) = (self.data.clone(), self.put_in.len());
                let result = self.in_data(&value, open);
                open.pop();
                match result {
                    Ok(result) => {
                        let put_in = (Expr::Symbol(symbol.clone()), value, assumed.source);
                        self.put_in.push(put_in);
                        return Ok(result);
                    }
                    Err(error) => {
                        self.data = data;
                        self.put_in.truncate(length);
                        let own = matches!(&error, NoInterval::Unknown(s) if open.contains(s) || s == symbol);
                        if !own {
                            first = first.or(Some(error));
                        }
                    }
                }
            }
        }
        self.unknown.insert(symbol.clone());
        Err(first.unwrap_or(unknown))
    }

    /// The number that the page prints for a symbol, if that is one and the same wherever it does.
    fn said_once(&self, symbol: &Symbol) -> Option<Datum> {
        let value = |own: &Printed| match &own.goal.formula {
            Formula::Relation {
                left: Expr::Symbol(of),
                right,
                ..
            } if of == symbol => Some(right.clone()),
            _ => None,
        };
        let mut own = self.said.iter().filter_map(|own| Some((own, value(own)?)));
        let (first, number) = own.next()?;
        let same = own.all(|(_, other)| other == number);
        let datum =
            same.then(|| self.within(&number, first.goal.rounding.as_ref(), first.span))??;
        Some(match first.constant {
            Some(name) => Datum {
                source: format!("{name}, of which the page says nothing"),
                constant: Some(name),
                ..datum
            },
            None => datum,
        })
    }

    /// A printed number with what may have been rounded to it.
    fn within(&self, number: &Expr, rounding: Option<&Rounding>, span: Span) -> Option<Datum> {
        let share = match (self.taken, rounding) {
            (_, None) | (Taken::Exactly, _) => BigRational::zero(),
            (Taken::AsStated, Some(own)) if own.precision != Precision::Stated => {
                BigRational::zero()
            }
            (_, Some(own)) => own.share.clone(),
        };
        let value = Figures::default().value(&in_si(number)).ok()?;
        let spread = value.abs().high() * share;
        Some(Datum {
            low: value.low() - &spread,
            high: value.high() + spread,
            source: "as it is printed".into(),
            span,
            constant: None,
        })
    }

    /// The figures that a premise prints for a symbol, where it is not taken for just that number.
    fn printed(&self, symbol: &Symbol) -> Option<(usize, Datum)> {
        self.assumed.iter().find_map(|assumed| {
            let Formula::Relation {
                left,
                relation,
                right,
            } = &*assumed.formula
            else {
                return None;
            };
            if !matches!(left, Expr::Symbol(own) if own == symbol) {
                return None;
            }
            let (page, span, goal) = self.written(assumed)?;
            let rounding = goal.rounding?;
            let datum = self.within(right, Some(&rounding), span)?;
            // What is just that number is put in.
            let is_exact = *relation == Relation::Equal && datum.low == datum.high;
            (!is_exact).then_some((page, datum))
        })
    }

    /// Where a premise is written, and as what.
    fn written(&self, assumed: &Assumed) -> Option<(usize, Span, Goal)> {
        let is_own = |goal: &Goal| goal.formula == *assumed.formula;
        match assumed.source {
            Source::Local(page, local) => {
                let span = self.derivation.local(page, local).span;
                let source = &self.derivation.pages[page].document.source;
                let statements = read_formulas(source, span).ok()?;
                let goal = statements.iter().flat_map(goals).find(is_own)?;
                Some((page, span, goal))
            }
            Source::Equation(at) => {
                let equation = &self.derivation.equations[at];
                let goal = equation.statements().iter().flat_map(goals).find(is_own)?;
                Some((equation.page, equation.body, goal))
            }
            Source::Step | Source::Taken | Source::Propagation | Source::Nature => None,
        }
    }
}

/// The sides of what is said to be equal, or nearly.
fn likened(formula: &Formula) -> Option<(&Expr, Relation, &Expr)> {
    match formula {
        Formula::Relation {
            left,
            relation: relation @ (Relation::Equal | Relation::Approximately),
            right,
        } => Some((left, *relation, right)),
        _ => None,
    }
}

/// Whether a term is made of what intervals know.
pub(super) fn is_evaluable(term: &Expr) -> bool {
    let here = term.is_arithmetic() || matches!(term, Expr::Call(..));
    here && term.children().all(is_evaluable)
}

/// What the difference and the quotient of both sides say of a relation.
fn weigh(
    relation: Relation,
    difference: &Interval,
    ratio: Option<&Interval>,
    near: Option<&BigRational>,
) -> Weighed {
    let (zero, one) = (BigRational::zero(), BigRational::one());
    let far = BigRational::from_integer(FAR.into());
    let settle = |yes: bool, no: bool| match (yes, no) {
        (true, _) => Weighed::Supported,
        (_, true) => Weighed::Contradicted,
        _ => Weighed::NotSettled,
    };
    let (low, high) = (difference.low(), difference.high());
    let size = ratio.map(Interval::abs);
    match relation {
        Relation::Less => settle(*high < zero, *low >= zero),
        Relation::LessOrEqual => settle(*high <= zero, *low > zero),
        Relation::Greater => settle(*low > zero, *high <= zero),
        Relation::GreaterOrEqual => settle(*low >= zero, *high < zero),
        // Figures that are not points can agree, and no more.
        Relation::Equal => settle(difference.contains(&zero), true),
        Relation::NotEqual => settle(!difference.contains(&zero), low == high),
        Relation::MuchGreater => match size {
            Some(size) => settle(*size.low() >= far, *size.high() < far),
            None => Weighed::NotSettled,
        },
        Relation::MuchLess => match size {
            Some(size) => {
                let least = far.recip();
                settle(*size.high() <= least, *size.low() > least)
            }
            None => Weighed::NotSettled,
        },
        Relation::Approximately => match (near, ratio) {
            (None, _) => Weighed::NoTolerance,
            (Some(near), Some(ratio)) => {
                let (below, above) = (&one - near, &one + near);
                let yes = *ratio.low() >= below && *ratio.high() <= above;
                settle(yes, *ratio.high() < below || *ratio.low() > above)
            }
            (Some(_), None) => Weighed::NotSettled,
        },
        Relation::Scales | Relation::Proportional | Relation::Tends => Weighed::NoComparison,
    }
}

/// The premises whose equations were put in.
pub(super) fn used(numeric: &Numeric) -> Set<usize> {
    let sources = numeric.put_in.iter().map(|(.., source)| source);
    sources
        .filter_map(|source| match source {
            Source::Equation(at) => Some(*at),
            _ => None,
        })
        .collect()
}
