//! What is supposed where: values and hypotheses that prose or a directive brings in, and the special cases that are left again.

mod moment;
mod rivals;
mod said;
mod vanishing;

use std::ops::RangeFrom;
use std::sync::Arc;

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::document::{Span, SuppositionKind, is_everywhere, is_reason};
use crate::kernel::Standing;
use crate::sorted::Set;

use super::Equation;
use super::definition::Known;
use super::equation::terms;
use super::meanings::renamed;
use super::page::Page;
use super::rows::{self, Part};

use self::rivals::exclude_each_other;

pub(super) use self::moment::said_of_moment;
pub use self::moment::{Moment, is_put};
pub(super) use self::vanishing::{MOST_BEFORE, give_the_same, rate_of, rates_at, slope_by};

/// A hypothesis that is in effect in a part of a page.
#[derive(Clone, Debug)]
pub struct Local {
    /// What is supposed.
    pub formulas: Vec<Arc<Formula>>,
    /// `let`: a value for this section alone; otherwise `assuming`, which conclusions carry with them.
    pub is_let: bool,
    /// Where it stands.
    pub span: Span,
    /// Of a special case, the symbols that it sets to a number: what speaks of them again is no longer said of that case.
    pub(super) set: Set<Symbol>,
    /// It is a special case, or was told of one, and is left with it.
    pub(super) of_case: bool,
    /// The text told it in passing.
    pub is_told: bool,
    /// It says no more than what a function is of which nothing else speaks.
    pub(super) only_names: bool,
    /// It lets something that was spoken of before have a value.
    pub(super) is_special: bool,
    /// It is a value of a numerical example.
    pub(super) is_figure: bool,
    /// It is supposed for the sake of a contradiction.
    pub is_contrary: bool,
    /// It says what a new symbol means: "Let $u = 1/N$".
    pub means: bool,
    /// It is said for good: headings do not end it.
    pub(super) lasts: bool,
    /// It is said of the next display alone, and what that concludes of more: "In equilibrium the right-hand side of (1) vanishes", "With
    /// $w = 0$ at $x = 0$ we get".
    pub(super) of_display: bool,
    /// It is so everywhere, and not at one point: "In equilibrium $J = 0$".
    everywhere: bool,
    /// It is so at one moment alone.
    pub(super) moment: Option<Moment>,
    pub(super) level: u8,
}

impl Local {
    /// What is said there, and nothing more is known of it.
    pub(super) fn said(formulas: impl IntoIterator<Item = Formula>, span: Span) -> Local {
        Local {
            formulas: formulas.into_iter().map(Arc::new).collect(),
            is_let: false,
            span,
            set: Set::new(),
            of_case: false,
            is_told: false,
            is_special: false,
            is_figure: false,
            is_contrary: false,
            only_names: false,
            means: false,
            lasts: false,
            of_display: false,
            everywhere: false,
            moment: None,
            level: 0,
        }
    }

    /// Gives its symbols other names, what it supposes apart.
    pub(super) fn rename(&mut self, own: &impl Fn(&Symbol) -> Symbol) {
        self.set = self.set.iter().map(own).collect();
        if let Some(moment) = &mut self.moment {
            moment.subject = renamed(&moment.subject, own);
        }
    }

    /// Takes what is put into a law of change for all of its variable, where it gives by that what the law differentiates: `x = A \cos\omega t`.
    pub(super) fn say_of_all(&mut self, equations: &[Equation]) {
        let is_function = |formula: &Arc<Formula>| match formula.as_equation() {
            Some((Expr::Symbol(symbol), value)) if !value.mentions(symbol) => {
                let is_slope = |part: &Expr| match part {
                    Expr::Derivative { body, variable } => {
                        **body == Expr::Symbol(symbol.clone()) && value.mentions(variable)
                    }
                    _ => false,
                };
                let mut sides = equations
                    .iter()
                    .flat_map(Equation::statements)
                    .flat_map(terms);
                sides.any(|side| side.any(&is_slope))
            }
            _ => false,
        };
        self.everywhere |= self.formulas.iter().all(is_function);
    }

    /// Whether it is so at one moment alone: what was concluded from it is a premise elsewhere, too, but it is not.
    pub fn is_momentary(&self) -> bool {
        self.moment.is_some()
    }

    /// Whether another one is said in its place, of the same symbol. What a new symbol means is so for good, be it said to be a number or another
    /// symbol later: "the index $n_1 = c/v_1$" and then "in air $n_1 = 1$".
    pub fn is_replaced_by(&self, other: &Local) -> bool {
        let is_same = !other.values().is_disjoint(&self.values());
        is_same && !self.leaves_room_for(other) && !other.leaves_room_for(self)
    }

    /// Whether it says what a new symbol means, and another one no more than its value.
    fn leaves_room_for(&self, other: &Local) -> bool {
        let is_value = |formula: &Arc<Formula>| match formula.as_equation() {
            Some((Expr::Symbol(_), Expr::Symbol(value))) => !self.names().contains(value),
            Some((Expr::Symbol(_), value)) => value.free_symbols().iter().all(Symbol::is_unit),
            _ => false,
        };
        self.means && other.formulas.iter().all(is_value)
    }

    /// Whether it is said of the display alone that it leads to: what was concluded from it is a premise elsewhere, but it is not.
    pub fn is_passing(&self) -> bool {
        self.is_momentary() || self.of_display
    }

    /// Whether "in general" leaves it; and what leaves cases and moments alone, "later".
    pub fn is_left_by(&self, in_general: bool) -> bool {
        // "Suppose that $a + b = 0$", "Let $n = 3$"
        let restricts = || {
            let sets_number = self
                .formulas
                .iter()
                .any(|own| own.set_to_number().is_some());
            !self.is_told && !self.means && self.is_equation() && (!self.is_let || sets_number)
        };
        self.of_case || in_general && (self.is_special || restricts())
    }

    /// Whether it says under which condition what follows is so, and not what something means.
    pub(super) fn is_condition(&self) -> bool {
        !self.means && !self.lasts && !self.is_momentary()
    }

    /// Whether it sets one of these in a case.
    pub(super) fn sets(&self, symbols: &[Symbol]) -> bool {
        let values = self.values();
        !self.is_figure && self.is_of_some_case() && symbols.iter().any(|own| values.contains(own))
    }

    /// Whether it is a special case.
    pub fn is_case(&self) -> bool {
        self.of_case || !self.set.is_empty()
    }

    /// Whether it is a special case, and no example, that was set before a display.
    pub(super) fn is_case_before(&self, display: Span) -> bool {
        self.of_case && !self.is_figure && self.span.start < display.start
    }

    /// Whether it says what is equal in a special case, and gives no value for an example.
    pub fn is_of_special_case(&self) -> bool {
        self.of_case && !self.is_figure && self.is_equation()
    }

    /// Whether it gives something a value that it does not have throughout: in a case, at one moment, or as far as is supposed.
    pub fn is_of_some_case(&self) -> bool {
        (self.of_case || self.is_special || self.is_momentary()) && self.is_equation()
    }

    /// The symbols that it says the value of.
    pub fn values(&self) -> Set<Symbol> {
        self.formulas.iter().flat_map(|f| assigned(f)).collect()
    }

    /// Whether it says what something is, and does not bound it.
    pub fn is_equation(&self) -> bool {
        self.formulas.iter().all(|own| own.as_equation().is_some())
    }

    /// Whether it is left for another case of the same quantities: "For $m_1 = m_2$, …" and then "If $m_2 = 3 m_1$, …".
    pub fn is_left_for(&self, other: &Local) -> bool {
        self.of_case
            && self.span.start < other.span.start
            && self.formulas != other.formulas
            && self.gives_as(&other.names(), &other.values())
    }

    /// Whether it cannot be so where these are: "First, let $x > 0$. … Now let $x < 0$".
    pub(super) fn is_ruled_out_by<'a>(
        &self,
        formulas: impl IntoIterator<Item = &'a Formula>,
    ) -> bool {
        let mut formulas = formulas.into_iter();
        !self.is_momentary()
            && formulas.any(|other| {
                self.formulas
                    .iter()
                    .any(|own| exclude_each_other(own, other))
            })
    }

    /// Whether it cannot be so where another one is.
    pub fn is_another_case_than(&self, other: &Local) -> bool {
        self.is_ruled_out_by(other.formulas.iter().map(|own| &**own))
    }

    /// Whether it says how the same quantities go together as another one, which speaks of `names` and gives the `values` of some.
    fn gives_as(&self, names: &Set<Symbol>, values: &Set<Symbol>) -> bool {
        let both_give = !values.is_empty() && !self.values().is_empty();
        both_give && names.len() > 1 && self.names() == *names
    }

    /// The symbols and sequences that it speaks of.
    pub fn names(&self) -> Set<Symbol> {
        let formulas = self.formulas.iter();
        formulas.flat_map(|formula| formula.names()).collect()
    }
}

impl Page {
    /// What is supposed is so at one point; of constants alone it is so throughout, and so is what a new symbol is said to mean, or what is
    /// said to be so everywhere.
    pub fn standing_of(&self, local: &Local, formula: &Formula) -> Standing {
        let is_constant = |s: &Symbol| self.domains.get(s).is_some_and(|d| d.constant);
        let of_constants =
            || formula.free_symbols().iter().all(is_constant) && formula.sequences().is_empty();
        // That a slope is nought, each step needs only where it looks.
        let everywhere = || local.everywhere && !formula.speaks_of_slopes();
        match local.means || everywhere() || of_constants() {
            true => Standing::Identity,
            false => Standing::AtPoint,
        }
    }

    /// Takes up a `let` or an assumption. Prose that cannot be read supposes nothing; a directive must be readable.
    pub(super) fn suppose(
        &mut self,
        body: Span,
        kind: SuppositionKind,
        level: u8,
        active: &mut Vec<usize>,
        strict: bool,
    ) {
        use SuppositionKind::{Case, Compared, Contrary, Figure};
        let is_case = matches!(kind, Case { .. } | Compared { .. } | Contrary | Figure);
        let in_passing = matches!(
            kind,
            SuppositionKind::Fact { .. } | SuppositionKind::Meaning
        );
        let is_fact = in_passing || kind == SuppositionKind::Known;
        let is_let = is_case || kind == SuppositionKind::Let;
        let said = match kind {
            Compared { relation, to } => self.compared((body, relation, to)),
            _ => self.supposed(body),
        };
        let said = match said {
            Ok(said) => said,
            Err(error) => {
                if strict {
                    self.complain(error);
                }
                return;
            }
        };
        for (formulas, span) in said {
            let values: Set<Symbol> = formulas.iter().flat_map(assigned).collect();
            let own: Set<Symbol> = formulas.iter().flat_map(Formula::names).collect();
            let (locals, source) = (&self.locals, &self.document.source);
            let mut is_of_several = false;
            active.retain(|&at| {
                let old = &locals[at];
                if !is_fact && !strict && old.is_ruled_out_by(&formulas) {
                    let is_parted = parts_sentences(source, old.span, span);
                    // "The string at $x < 0$ is joined to the one at $x > 0$": one sentence speaks of two places, and is said of neither.
                    is_of_several |= !is_parted && has_words(source, old.span, span);
                    if is_parted || is_of_several {
                        return false;
                    }
                }
                let before = old.values();
                // "For $m_1 = m_2$, … For $m_2 = 3 m_1$, …" goes from one case to the next.
                let other_case = || old.gives_as(&own, &values);
                match old.is_let && is_let {
                    // That $R > 0$ is not taken back by $R = 5$.
                    true => old.bounds() || before.is_disjoint(&values) && !other_case(),
                    // "The height is $x = h$, so … The width is $x = w$, so".
                    false => {
                        let is_other = old.of_case && other_case();
                        !is_other && (!is_fact || before.is_disjoint(&values))
                    }
                }
            });
            if is_of_several {
                continue;
            }
            let set = match is_case && kind != SuppositionKind::Figure || in_passing {
                true => formulas.iter().filter_map(set_to_a_number).collect(),
                false => Set::new(),
            };
            let everywhere = is_everywhere(source, span);
            active.push(self.locals.len());
            self.locals.push(Local {
                set,
                everywhere,
                is_let,
                of_case: is_case || matches!(kind, SuppositionKind::Fact { of_case: true, .. }),
                is_told: is_fact,
                is_contrary: kind == Contrary,
                level,
                ..Local::said(formulas, span)
            });
        }
    }

    /// What gives a value to what was spoken of before is a special case; what gives a new symbol its meaning is none.
    pub(super) fn restrict(&mut self, new: RangeFrom<usize>, kind: SuppositionKind, known: &Known) {
        // "…, where $k = m \omega^2$" says what is meant in what stands before.
        let explains = kind == SuppositionKind::Define;
        let source = &self.document.source;
        for local in &mut self.locals[new] {
            let mut values = local.values().into_iter();
            // A reason is so throughout: "Since $\mu = m_2/m_1$".
            let reason = local.is_told && is_reason(source, local.span);
            let gives = !explains && !reason && values.any(|symbol| known.speaks_of(&symbol));
            // "We write $I = \beta m R^2$" says what `\beta` is, and restricts nothing.
            local.is_special =
                gives && !local.formulas.iter().any(|own| names_a_factor(own, known));
            let is_meaning = |formula: &Arc<Formula>| match formula.as_equation() {
                Some((Expr::Symbol(_) | Expr::Apply(..), value)) => {
                    is_term(value) || reason && matches!(value, Expr::Symbol(_))
                }
                _ => false,
            };
            // "For a uniform disk the density is $\sigma = M/(\pi R^2)$": of a new symbol that is said for good.
            let of_case = local.is_told && local.of_case && gives;
            let lasts = local.moment.is_none() && !gives && !of_case;
            local.means = lasts && local.formulas.iter().all(is_meaning);
        }
    }

    /// Takes up what a display shows to be meant by names in it, for good.
    pub(super) fn suppose_meant(&mut self, said: Vec<Formula>, span: Span) -> usize {
        self.locals.push(Local {
            is_told: true,
            means: true,
            lasts: true,
            ..Local::said(said, span)
        });
        self.locals.len() - 1
    }

    /// Supposes that a term has a value, at a moment whose passage begins there; in passing where there is none.
    pub(super) fn suppose_equal(
        &mut self,
        subject: Expr,
        value: Expr,
        span: Span,
        passage: Option<usize>,
    ) -> usize {
        let equal = Formula::equal(subject.clone(), value);
        self.locals.push(Local {
            set: set_to_a_number(&equal).into_iter().collect(),
            of_case: true,
            is_told: passage.is_none(),
            moment: passage.map(|passage| Moment {
                passage,
                display: None,
                subject,
            }),
            ..Local::said([equal], span)
        });
        self.locals.len() - 1
    }

    /// Supposes what is so in a case.
    pub(super) fn suppose_case(&mut self, formulas: Vec<Formula>, span: Span) -> usize {
        self.locals.push(Local {
            is_let: true,
            of_case: true,
            ..Local::said(formulas, span)
        });
        self.locals.len() - 1
    }

    /// Takes away the condition that was supposed last, and returns what is so otherwise: neither that, nor any of the cases before it since
    /// then. Of things that were supposed together nobody knows which of them is not so.
    pub(super) fn opposite(
        &self,
        active: &mut Vec<usize>,
        since: usize,
    ) -> Option<Option<Vec<Formula>>> {
        let locals = &self.locals;
        let here = |own: &Local| own.is_condition() && own.span.start >= since;
        // A display may have left the case already.
        let case = locals.iter().rposition(|own| own.of_case && here(own));
        let assumed = active
            .last()
            .copied()
            .filter(|&at| locals[at].is_condition());
        let at = case.max(assumed)?;
        let last = &locals[at];
        let source = &self.document.source;
        let with_it = |own: &Local| {
            own.is_condition()
                && own.span != last.span
                && !parts_sentences(source, own.span, last.span)
        };
        let is_one = !active.iter().any(|&at| with_it(&locals[at]));
        active.retain(|&own| own != at && !with_it(&locals[own]));
        let is_before = |own: &&Local| own.of_case && here(own) && own.is_another_case_than(last);
        let cases = locals[..at].iter().filter(is_before).chain([last]);
        let denied = |own: &Local| match own.formulas.as_slice() {
            [own] => own.denied(),
            _ => None,
        };
        Some(match is_one {
            true => cases.map(denied).collect(),
            false => None,
        })
    }

    /// Supposes of what says how fast something changes that it is zero: what the next display concludes from it is so as long as the text
    /// is about that.
    pub(super) fn suppose_rest(&mut self, rate: Expr, span: Span) -> usize {
        let at = self.suppose_equal(rate, Expr::integer(0), span, None);
        let own = &mut self.locals[at];
        (own.is_told, own.of_case, own.means, own.of_display) = (false, false, true, true);
        at
    }

    /// Supposes of a slope that it is zero, in the displays to which the words lead: what is concluded from it stands for what comes.
    pub(super) fn suppose_stationary(&mut self, slope: Expr, span: Span) -> usize {
        let at = self.suppose_equal(slope, Expr::integer(0), span, None);
        let own = &mut self.locals[at];
        (own.is_told, own.of_case, own.of_display) = (false, false, true);
        at
    }

    /// Whether the text has gone through cases since then of which no two can be so at once.
    pub(super) fn has_rival_cases(&self, since: usize) -> bool {
        let here = |own: &&Local| own.of_case && own.span.start >= since;
        let mut cases = self.locals.iter().filter(here);
        cases.next_back().is_some_and(|last| {
            let mut before = cases.rev().take(MOST_BEFORE);
            before.any(|own| own.is_another_case_than(last))
        })
    }

    /// Leaves the cases of whose symbols a display speaks again: "At $t = 0$ the switch is closed. Later $q = I t$". In the
    /// sentence that sets the case it is said of that: "at $\mu = 1$, $\eta = 4 \mu / (1 + \mu)^2 = 1$".
    pub(super) fn leave_cases(&self, display: &[Part], running: &[usize], active: &mut Vec<usize>) {
        let is_left = |at: usize| {
            let set = &self.locals[at].set;
            let mut spoken_of = rows::said(display).flat_map(|own| own.names());
            let is_plain = self.locals[at].moment.is_none();
            !set.is_empty()
                && is_plain
                && !running.contains(&at)
                && spoken_of.any(|name| set.contains(&name))
        };
        active.retain(|&at| !is_left(at));
    }
}

/// The symbol that an equation says is a number: `t = 0`.
fn set_to_a_number(formula: &Formula) -> Option<Symbol> {
    match formula {
        Formula::Relation {
            left: Expr::Symbol(symbol),
            relation: Relation::Equal,
            right,
        } if right.free_symbols().iter().all(is_number) => Some(symbol.clone()),
        _ => None,
    }
}

/// Whether a symbol stands for a number, or for so much of a unit.
pub(super) fn is_number(symbol: &Symbol) -> bool {
    symbol.is_unit() || symbol.name() == "\\pi"
}

/// The symbols that an equation between them gives a value.
fn assigned(formula: &Formula) -> Set<Symbol> {
    match formula {
        Formula::Relation {
            left: Expr::Symbol(symbol),
            ..
        } => Set::from([symbol.clone()]),
        Formula::AllEqual { sequence, .. } => Set::from([sequence.clone()]),
        Formula::Relation { .. } => Set::new(),
    }
}

/// Whether a term says what a symbol means, "Let $u = 1/N$": of a mere name or number it may be told where something begins.
fn is_term(value: &Expr) -> bool {
    !matches!(value, Expr::Symbol(_)) && !value.free_symbols().is_empty()
}

/// Whether a sentence or a display ends between two places.
pub(super) fn parts_sentences(source: &str, one: Span, other: Span) -> bool {
    let between = source.get(one.end..other.start).unwrap_or_default();
    let ends = ["$$", "\\[", "\\end{", "\n\n", ". ", ".\n", ".*", "; "];
    ends.iter().any(|end| between.contains(end))
}

/// Whether more than "and" stands between two places.
fn has_words(source: &str, one: Span, other: Span) -> bool {
    let between = source.get(one.end..other.start).unwrap_or_default();
    let mut words = between.split(|c: char| !c.is_alphanumeric());
    words.any(|word| !word.is_empty() && word != "and")
}

/// Whether a formula says no more than what a new symbol is, by a product that it is a factor of: `I = \beta m R^2`.
fn names_a_factor(formula: &Formula, known: &Known) -> bool {
    let Some((Expr::Symbol(whole), Expr::Product(factors))) = formula.as_equation() else {
        return false;
    };
    let is_new = |factor: &Expr| match factor {
        Expr::Symbol(symbol) => !known.speaks_of(symbol) && symbol != whole,
        _ => false,
    };
    factors.iter().any(is_new)
}
