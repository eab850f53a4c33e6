//! A handle on a derivation: what anyone can ask of it.

mod point;

use std::borrow::Cow;
use std::sync::OnceLock;

use crate::algebra::{EvaluateError, Formula, Sides};
use crate::audit::Audit;
use crate::kernel::{Claim, Refuted, Standing};
use crate::notation::{Connective, Mark, Statement};
use crate::search::{self, Decision};

use super::{Assumed, Derivation, Equation, Kind, Source, formulas, goals, is_open};
use crate::sorted::Set;

pub use point::{Point, values_at};

/// A derivation, or one page of it, as something to be questioned: audited, read, evaluated, attacked.
///
/// The pages of the report have handles of their own in `cradle_verify::proofs::pages`. Anybody's
/// derivation will do:
///
/// ```
/// use cradle_engine::algebra::{BigInt, BigRational};
/// use cradle_engine::audit::Verdict;
/// use cradle_engine::derivation::{Checker, Point};
///
/// let page = Checker::from_markdown("stretch.md", r"
/// <!-- check:
/// symbols k: positive
/// symbols x, F, W: real
/// -->
///
/// <!-- check: law -->
/// $$ F = k x \tag{1} $$
///
/// <!-- check: definition -->
/// $$ W = \frac{k x^2}{2} \tag{2} $$
///
/// By (1) and (2) the work is half of force times way,
///
/// $$ W = \frac{F x}{2} \tag{3} $$
///
/// and so, still by (1) and (2), never more than that:
///
/// $$ W > F x \tag{4} $$
/// ");
///
/// // Every equation judged, from what it cites.
/// let verdicts: Vec<Verdict> = page.audit().entries.iter().map(|e| e.verdict).collect();
/// assert_eq!(verdicts, [Verdict::Given, Verdict::Given, Verdict::Holds, Verdict::Fails]);
///
/// // One equation at one point, both sides exact.
/// let third = BigRational::new(BigInt::from(1), BigInt::from(3));
/// let at = Point::new().with("k", 2).with_ratio("x", third).with_term("F", "k x").with_term("W", "k x^2 / 2");
/// let sides = &page.sides_at("3", &at).unwrap()[0];
/// assert_eq!((sides.left.to_string(), sides.right.to_string(), sides.holds), ("1/9".into(), "1/9".into(), true));
/// assert_eq!(page.sides_at("1", &Point::new()).unwrap_err().to_string(), "`F` has no value at this point");
///
/// // A counterexample that the kernel has checked, where there is one.
/// assert!(page.hunt("3").is_none());
/// let refuted = page.hunt("4").unwrap();
/// let there = Point::at_witness(&refuted);
/// assert!(there.holds(&refuted.claim().hypotheses[0].formula).unwrap());
/// assert!(!there.holds(&refuted.claim().goal).unwrap());
/// ```
#[derive(Debug)]
pub struct Checker {
    derivation: Derivation,
    /// The page in question; `None` for all of them.
    page: Option<usize>,
    audit: OnceLock<Audit>,
}

impl Checker {
    /// A handle on a whole derivation.
    pub fn new(derivation: Derivation) -> Self {
        Checker {
            derivation,
            page: None,
            audit: OnceLock::new(),
        }
    }

    /// A handle on one Markdown page that stands alone.
    pub fn from_markdown(path: &str, source: &str) -> Self {
        Checker::new(Derivation::from_markdown(path, source))
    }

    /// A handle on one page of a derivation, by its position. The other pages remain what it may cite.
    pub fn of_page(derivation: Derivation, page: usize) -> Self {
        Checker {
            page: Some(page),
            ..Checker::new(derivation)
        }
    }

    /// What is questioned, with the pages around it.
    pub fn derivation(&self) -> &Derivation {
        &self.derivation
    }

    /// The equations in question, in reading order.
    pub fn equations(&self) -> impl Iterator<Item = &Equation> {
        let all = self.derivation.equations.iter();
        all.filter(|equation| self.page.is_none_or(|page| equation.page == page))
    }

    /// Every equation in question judged from its premises; the work is done once.
    pub fn audit(&self) -> &Audit {
        self.audit.get_or_init(|| {
            let mut audit = Audit::of(&self.derivation);
            let here = |at: usize| {
                let page = self.derivation.equations[at].page;
                self.page.is_none_or(|own| own == page)
            };
            audit.entries.retain(|entry| here(entry.equation));
            audit
        })
    }

    /// The audit where only some equations count, by their positions in the derivation: the whole one if that is done, otherwise
    /// one of these and of what their verdicts depend on.
    pub fn audit_of(&self, wanted: &[usize]) -> Cow<'_, Audit> {
        match self.audit.get() {
            Some(audit) => Cow::Borrowed(audit),
            None => Cow::Owned(Audit::of_these(&self.derivation, wanted)),
        }
    }

    /// The equation of a number, `54` or `(54)`, or of a name: one of this page before one of another.
    pub fn equation(&self, label: &str) -> Option<&Equation> {
        self.position(label)
            .map(|at| &self.derivation.equations[at])
    }

    /// Where the equation of such a number or name stands in the derivation.
    pub fn position(&self, label: &str) -> Option<usize> {
        let label = label.trim();
        let label = label.strip_prefix("claim ").unwrap_or(label).trim();
        let tag = label.trim_start_matches('(').trim_end_matches(')');
        let bears = |equation: &Equation| {
            equation.tag.as_deref() == Some(tag) || equation.name.as_deref() == Some(label)
        };
        let all = || self.derivation.equations.iter();
        let near = all().position(|e| self.page.is_none_or(|page| e.page == page) && bears(e));
        near.or_else(|| all().position(bears))
    }

    /// Both sides of every relation that an equation states, in exact numbers: of `a = b \leq c` there are two.
    ///
    /// Only the point counts here, no premise and no declared domain: the point may be one at which the
    /// equation is not meant to be true.
    ///
    /// # Errors
    /// There is no such equation, the point leaves out a symbol, something is divided by 0, or a term is not one
    /// that is evaluated (an unknown function, an integral).
    pub fn sides_at(&self, label: &str, point: &Point) -> Result<Vec<Sides>, EvaluateError> {
        let at = self
            .position(label)
            .ok_or_else(|| EvaluateError::NoEquation(label.to_owned()))?;
        let mut all = Vec::new();
        for equation in &self.derivation.equations[self.derivation.rows_of(at)] {
            let statements = match &equation.statements {
                Ok(statements) => statements,
                Err(error) => {
                    return Err(EvaluateError::Unreadable {
                        text: label.to_owned(),
                        message: error.message.clone(),
                    });
                }
            };
            for formula in statements.iter().flat_map(formulas) {
                all.extend(point.sides(&formula)?);
            }
        }
        Ok(all)
    }

    /// A counterexample to an equation, checked by the kernel: what it cites is true there, and it is false.
    ///
    /// Unlike the [audit](Checker::audit) this takes the citations at their word: a step that cites the wrong
    /// equation is refuted, even if another equation would prove it. What was derived for particular values
    /// (`let`) that are not in effect is no premise. `None` where nothing was found, for what is given, and for
    /// a label that does not exist.
    pub fn hunt(&self, label: &str) -> Option<Refuted> {
        let rows = self.derivation.rows_of(self.position(label)?);
        let claims = rows.flat_map(|at| self.claims(at));
        claims
            .map(|claim| search::decide(claim, &[]))
            .find_map(|decision| match decision {
                Decision::Refuted(refuted) => Some(refuted),
                _ => None,
            })
    }

    /// What an equation claims: each of its relations, from what it cites and what it has shown before.
    fn claims(&self, at: usize) -> Vec<Claim> {
        let derivation = &self.derivation;
        let equation = &derivation.equations[at];
        if equation.kind == Kind::Given {
            return Vec::new();
        }
        // What a case says counts under its condition only, so it is not put to the test from here.
        let by_cases = |&premise: &usize| {
            let mut statements = derivation.equations[premise].statements().iter();
            statements.any(|statement| !statement.under.is_empty())
        };
        if derivation.premises(at).0.iter().any(by_cases) {
            return Vec::new();
        }
        let cited = self.cited(at);
        let step = |formula: &Formula| Assumed {
            formula: formula.clone().into(),
            standing: Standing::AtPoint,
            source: Source::Step,
        };
        let mut claims = Vec::new();
        for (part, statement) in equation.statements().iter().enumerate() {
            let mut shown: Vec<Assumed> = Vec::new();
            for (position, goal) in goals(statement).into_iter().enumerate() {
                let mut assumed = cited.clone();
                match goal.suppositions.as_slice() {
                    [] => assumed.extend(shown.iter().cloned()),
                    supposed => assumed.extend(supposed.iter().map(step)),
                }
                if !(equation.defines.contains(&part) && position == 0) {
                    claims.push(derivation.claim(at, &assumed, &goal.formula));
                }
                if goal.is_said_outright() {
                    shown.push(step(&goal.formula));
                }
            }
        }
        claims
    }

    /// The hypotheses that an equation cites, with those in effect where it stands.
    fn cited(&self, at: usize) -> Vec<Assumed> {
        let derivation = &self.derivation;
        let equation = &derivation.equations[at];
        let in_effect: Set<(usize, usize)> = locals(equation).collect();
        let mut assumed = derivation.locals(at);
        for &premise in derivation.premises(at).0 {
            let other = &derivation.equations[premise];
            let derived = other.kind != Kind::Given;
            let own = other.moments.clone().map(|local| (other.page, local));
            let under: Vec<(usize, usize)> = locals(other).filter(|_| derived).chain(own).collect();
            let foreign = |local: &(usize, usize)| {
                let own = derivation.local(local.0, local.1);
                own.is_let && !own.is_momentary() && !in_effect.contains(local)
            };
            if under.iter().any(foreign) {
                continue;
            }
            // What was concluded under an assumption brings it along.
            let mut standing = Standing::Identity;
            for &(page, local) in &under {
                for formula in &derivation.local(page, local).formulas {
                    if !is_open(formula) {
                        standing = Standing::AtPoint;
                    }
                    if derivation.local(page, local).is_momentary() {
                        continue;
                    }
                    let carried = Assumed {
                        formula: formula.clone(),
                        standing: Standing::AtPoint,
                        source: Source::Local(page, local),
                    };
                    if !assumed.contains(&carried) {
                        assumed.push(carried);
                    }
                }
            }
            let asserted = other.statements().iter().flat_map(asserted);
            assumed.extend(asserted.map(|formula| Assumed {
                formula: formula.into(),
                standing,
                source: Source::Equation(premise),
            }));
        }
        assumed
    }
}

fn locals(equation: &Equation) -> impl Iterator<Item = (usize, usize)> {
    equation.locals.iter().map(|&local| (equation.page, local))
}

/// What a statement asserts: nothing that it only asks or crosses out, and neither side of an equivalence.
fn asserted(statement: &Statement) -> Vec<Formula> {
    let crossed = statement
        .mark
        .as_ref()
        .is_some_and(|m| m.value == Mark::Cross);
    let mut connectives = statement.connectives.iter();
    let equivalent = connectives.any(|c| c.value == Connective::Equivalent);
    if crossed || equivalent || !statement.under.is_empty() {
        return Vec::new();
    }
    let asserted = goals(statement).into_iter().filter(|g| !g.questioned);
    asserted.map(|goal| goal.formula).collect()
}
