//! What words say is zero, or has a value, without writing it as an equation: "Setting the derivative to zero".

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::{Citation, Span, Vanishing};
use crate::notation::{Clause, read_expr};

use super::super::equation::{Equation, formulas};
use super::super::page::Page;
use super::super::qualities::named;
use super::super::rows::{self, Part};

/// How many displays back is looked for what prose says to be zero.
pub(in crate::derivation) const MOST_BEFORE: usize = 6;
/// By these things change in time.
const TIMES: [&str; 2] = ["t", "\\tau"];

impl Page {
    /// What prose says to be zero, or to have a value, where that is known: at its place in the text, after these equations, and with what
    /// the text cites.
    pub(in crate::derivation) fn vanishing(
        &self,
        what: Vanishing,
        (body, equations, cited): (Span, &[Equation], &[Citation]),
    ) -> Option<Expr> {
        let source = &self.document.source;
        let mut before = equations.iter().rev().take(MOST_BEFORE);
        // Of what is cited there, or else of the display before.
        let meant = || match cited_there(body, cited) {
            Some(cited) => equation_of(cited, equations),
            None => equations.last().filter(|_| what != Vanishing::Cited),
        };
        match what {
            Vanishing::Term => match source.get(body.range())? {
                "one" | "unity" => Some(Expr::integer(1)),
                "zero" | "nought" => Some(Expr::integer(0)),
                _ => self.read_slope(body).or_else(|| {
                    // "where $dm/dn = 1 - n$ vanishes"
                    let read = self.read_slopes(body).ok()?;
                    Some(formulas(read.first()?).first()?.as_equation()?.0.clone())
                }),
            },
            Vanishing::Slope => {
                let is_slope = |side: &&Expr| matches!(side, Expr::Derivative { .. });
                before
                    .find_map(|own| left_side(own).filter(is_slope))
                    .cloned()
            }
            Vanishing::Display | Vanishing::Told => before.next().and_then(left_side).cloned(),
            Vanishing::Previous => before.nth(1).and_then(left_side).cloned(),
            Vanishing::Cited => meant().and_then(left_side).cloned(),
            // What is said of one side is so of the other by the equation itself, which is cited for that.
            Vanishing::LeftSide | Vanishing::RightSide => {
                let sides = meant().map(|own| [left_side(own), right_side(own)])?;
                let [own, other] = match what {
                    Vanishing::LeftSide => sides,
                    _ => [sides[1], sides[0]],
                };
                let is_number = |side: &&Expr| matches!(side, Expr::Number(_));
                other.filter(|side| !is_number(side)).or(own).cloned()
            }
            Vanishing::Named => {
                let noun = source.get(body.range())?;
                let is_said = |own: &&Equation| self.says_what_is(noun, own.span);
                let symbol = |side: &&Expr| matches!(side, Expr::Symbol(_));
                before
                    .find(is_said)
                    .and_then(left_side)
                    .filter(symbol)
                    .cloned()
            }
        }
    }

    /// The slope by a variable of what is named or cited, or of what was displayed last that is made of the variable.
    pub(in crate::derivation) fn slope_of(
        &self,
        (of, variable, partial): (Option<Span>, Span, bool),
        equations: &[Equation],
        cited: &[Citation],
    ) -> Option<Expr> {
        let source = &self.document.source;
        let [variable] = &named(source, variable)[..] else {
            return None;
        };
        let of_citation = |span: Span| {
            let cites = cited.iter().any(|own| own.span == span);
            cites.then(|| self.vanishing(Vanishing::Cited, (span, equations, cited)))
        };
        let wanted = match of {
            Some(span) => match of_citation(span) {
                Some(cited) => Some(cited?),
                None => Some(read_expr(source, span).ok()?),
            },
            None => None,
        };
        let mut before = equations.iter().rev().take(MOST_BEFORE);
        let law = before.find_map(|own| {
            let body = left_side(own)?;
            let name = match body {
                Expr::Symbol(name) => name,
                // `S(a, b) = …`
                Expr::Apply(name, arguments) => {
                    let is_argument =
                        |own: &Expr| matches!(own, Expr::Symbol(own) if own == variable);
                    arguments.iter().any(is_argument).then_some(name)?
                }
                _ => return None,
            };
            let value = right_side(own)?;
            let varies = name != variable && value.mentions(variable);
            let is_wanted = wanted.as_ref().is_none_or(|wanted| {
                wanted == body || matches!(wanted, Expr::Symbol(wanted) if wanted == name)
            });
            (varies && is_wanted).then_some((body, value))
        });
        // Of a sum it is hardly meant that all that is summed up may change.
        let partial = partial || law.is_some_and(|(_, value)| value.has_elements());
        // What is cited or named and given otherwise has a slope, too.
        let body = law.map(|(body, _)| body.clone()).or(wanted)?;
        Some(match partial {
            true => Expr::Partial {
                body: body.into(),
                variable: variable.clone(),
                held: None,
            },
            false => body.differentiated_by(variable),
        })
    }

    /// Whether the words that lead on to a display say what something is that has a name: "The velocity of the ball is".
    fn says_what_is(&self, noun: &str, display: Span) -> bool {
        let before = self
            .document
            .source
            .get(..display.start)
            .unwrap_or_default();
        let line = before.trim_end().rsplit("\n\n").next().unwrap_or_default();
        let sentence = line.rsplit(". ").next().unwrap_or_default();
        let words = sentence.split(|c: char| !c.is_alphanumeric());
        let mut words = words.filter(|word| !word.is_empty());
        // Of nothing else.
        words.any(|word| word.eq_ignore_ascii_case("the"))
            && words.next() == Some(noun)
            && words.next_back() == Some("is")
    }
}

/// The derivative by what a display says the value of, `x = \\dots`, of what was last said to be made of that.
pub(in crate::derivation) fn slope_by(display: &[Part], equations: &[Equation]) -> Option<Expr> {
    let first = formulas(rows::statements(display).next()?)
        .into_iter()
        .next()?;
    let (Expr::Symbol(variable), _) = first.as_equation()? else {
        return None;
    };
    let mut laws = equations
        .iter()
        .rev()
        .take(MOST_BEFORE)
        .flat_map(Equation::statements);
    laws.find_map(|law| {
        let law = formulas(law).into_iter().next()?;
        let (body @ Expr::Symbol(own), value) = law.as_equation()? else {
            return None;
        };
        let varies = own != variable && value.mentions(variable);
        varies.then(|| body.clone().differentiated_by(variable))
    })
}

/// How fast something changes, where an equation says so of this slope without speaking of the time.
pub(in crate::derivation) fn rate_of(slope: &Expr, equations: &[Equation]) -> Option<Expr> {
    let Expr::Derivative { variable, .. } = slope else {
        return None;
    };
    let mut before = equations.iter().rev();
    let rate = right_side(before.find(|own| left_side(own) == Some(slope))?)?;
    lasting(rate, variable)
}

/// A rate that does not speak of the time: where that is zero, it is for good.
fn lasting(rate: &Expr, time: &Symbol) -> Option<Expr> {
    let changes = matches!(rate, Expr::Number(_)) || rate.mentions(time);
    (!changes).then(|| rate.clone())
}

/// How fast all changes of which an equation says that, of what is cited at a place or else of the last that does: where nothing changes,
/// these are zero.
pub(in crate::derivation) fn rates_at(
    (body, equations, cited): (Span, &[Equation], &[Citation]),
) -> Vec<Expr> {
    let rates = |own: &Equation| -> Vec<Expr> {
        let all = own.statements().iter().flat_map(formulas);
        let rate = |law: Formula| match law.as_equation()? {
            // "In the steady state" heat flows all the same.
            (Expr::Derivative { variable, .. }, rate) if TIMES.contains(&variable.name()) => {
                lasting(rate, variable)
            }
            _ => None,
        };
        all.filter_map(rate).collect()
    };
    if let Some(cited) = cited_there(body, cited) {
        return equation_of(cited, equations).map_or_else(Vec::new, rates);
    }
    let before = equations.iter().rev().take(MOST_BEFORE).map(rates);
    let mut before = before.filter(|own| !own.is_empty());
    before.next().unwrap_or_default()
}

/// What is cited at a place.
fn cited_there(body: Span, cited: &[Citation]) -> Option<&Citation> {
    let at = cited.partition_point(|own| own.span.start < body.start);
    cited.get(at).filter(|own| own.span == body)
}

fn equation_of<'e>(cited: &Citation, equations: &'e [Equation]) -> Option<&'e Equation> {
    equations.iter().rev().find(|own| match cited.key {
        true => own.keys.contains(&cited.tag),
        false => own.tag.as_ref() == Some(&cited.tag),
    })
}

/// Whether two displays that are cited at two places say somewhere what the same is: "Equating (2) and (3)" supposes nothing then.
pub(in crate::derivation) fn give_the_same(
    places: [Span; 2],
    equations: &[Equation],
    cited: &[Citation],
) -> bool {
    let sides = |place: Span| -> Vec<Expr> {
        let equation = cited_there(place, cited).and_then(|own| equation_of(own, equations));
        let statements = equation.into_iter().flat_map(Equation::statements);
        let clauses = statements.flat_map(|own| &own.clauses);
        let begins = clauses.filter_map(|own| match own {
            Clause::Chain { sides, .. } => sides.first().map(|side| &side.expr),
            Clause::AllEqual { .. } => None,
        });
        // `\tau(r)` and `\tau`
        let named = begins.map(|side| match side {
            Expr::Apply(name, _) => Expr::Symbol(name.clone()),
            side => side.clone(),
        });
        named.collect()
    };
    let [one, other] = places.map(sides);
    one.iter().any(|own| other.contains(own))
}

/// What an equation says the value of.
fn left_side(equation: &Equation) -> Option<&Expr> {
    match equation.statements().first()?.clauses.first()? {
        Clause::Chain { sides, .. } => sides.first().map(|side| &side.expr),
        Clause::AllEqual { .. } => None,
    }
}

/// What it ends with.
fn right_side(equation: &Equation) -> Option<&Expr> {
    match equation.statements().first()?.clauses.first()? {
        Clause::Chain { sides, .. } => sides.last().map(|side| &side.expr),
        Clause::AllEqual { .. } => None,
    }
}
