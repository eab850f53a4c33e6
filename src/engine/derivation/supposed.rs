//! What is supposed where: values and hypotheses that prose or a directive brings in, and the special cases that are left again.

use std::ops::{Range, RangeFrom};
use std::sync::Arc;

use crate::algebra::{Expr, Formula, Relation, Symbol, element_parts, element_symbol};
use crate::document::{Citation, Extent, Span, SuppositionKind, Vanishing, is_reason};
use crate::kernel::Standing;
use crate::notation::{Clause, Statement, SyntaxError, read_expr, read_formulas, read_symbol};

use super::definition::Known;
use super::differentials;
use super::doubts::{OnPage, doubtful};
use super::equation::{Equation, formulas};
use super::meanings::renamed;
use super::page::Page;
use super::rows::Part;
use super::slopes::without_slashes;
use crate::sorted::Set;

/// How many displays back is looked for what prose says to be zero.
pub(super) const MOST_BEFORE: usize = 6;

/// No more symbols than this are counted up to in `R_1, \ldots, R_4 > 0`.
const MOST_LISTED: u32 = 32;

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
    /// It lets something that was spoken of before have a value.
    pub(super) is_special: bool,
    /// It is a value of a numerical example.
    pub(super) is_figure: bool,
    /// It says what a new symbol means: "Let $u = 1/N$".
    pub means: bool,
    /// It is said for good: headings do not end it.
    pub(super) lasts: bool,
    /// It is said of the next display alone, and what that concludes of more: "In equilibrium the right-hand side of (1) vanishes", "With
    /// $w = 0$ at $x = 0$ we get".
    pub(super) of_display: bool,
    /// It is so at one moment alone.
    pub(super) moment: Option<Moment>,
    pub(super) level: u8,
}

/// That something is so at one moment, or at one point of a curve: "At the top of its flight $$v = 0$$".
#[derive(Clone, Debug)]
pub struct Moment {
    /// The display with which its passage begins, by position on the page: all that is said of one moment is left together.
    passage: usize,
    /// The display that says it, by position on the page; none for "At $t = 0$" in the text before.
    pub display: Option<usize>,
    /// What is said to have a value: where the text derives something of it again, that is said of other moments.
    subject: Expr,
}

impl Local {
    /// Gives its symbols other names, what it supposes apart.
    pub(super) fn rename(&mut self, own: &impl Fn(&Symbol) -> Symbol) {
        self.set = self.set.iter().map(own).collect();
        if let Some(moment) = &mut self.moment {
            moment.subject = renamed(&moment.subject, own);
        }
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
    pub(super) fn is_left_by(&self, in_general: bool) -> bool {
        self.of_case || in_general && self.is_special
    }

    /// Whether it is a special case.
    pub fn is_case(&self) -> bool {
        self.of_case || !self.set.is_empty()
    }

    /// The symbols that it says the value of.
    pub fn values(&self) -> Set<Symbol> {
        self.formulas.iter().flat_map(|f| assigned(f)).collect()
    }

    /// Whether it says what something is, and does not bound it.
    pub fn is_equation(&self) -> bool {
        self.formulas.iter().all(|own| own.as_equation().is_some())
    }

    /// The symbols and sequences that it speaks of.
    pub fn names(&self) -> Set<Symbol> {
        let formulas = self.formulas.iter();
        formulas.flat_map(|formula| formula.names()).collect()
    }
}

impl Page {
    /// What is supposed is so at one point; of constants alone it is so throughout, and so is what a new symbol is said to mean.
    pub fn standing_of(&self, local: &Local, formula: &Formula) -> Standing {
        let is_constant = |s: &Symbol| self.domains.get(s).is_some_and(|d| d.constant);
        let of_constants =
            || formula.free_symbols().iter().all(is_constant) && formula.sequences().is_empty();
        match local.means || of_constants() {
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
        let is_case = matches!(kind, SuppositionKind::Case { .. } | SuppositionKind::Figure);
        let in_passing = matches!(
            kind,
            SuppositionKind::Fact { .. } | SuppositionKind::Meaning
        );
        let is_fact = in_passing || kind == SuppositionKind::Known;
        let is_let = is_case || kind == SuppositionKind::Let;
        let said = match self.supposed(body) {
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
            let locals = &self.locals;
            active.retain(|&at| {
                let old = &locals[at];
                let before = old.values();
                // "For $m_1 = m_2$, … For $m_2 = 3 m_1$, …" goes from one case to the next.
                let other_case = || {
                    let gives_values = !values.is_empty() && !before.is_empty();
                    gives_values && own.len() > 1 && old.names() == own
                };
                match old.is_let && is_let {
                    true => before.is_disjoint(&values) && !other_case(),
                    // "The height is $x = h$, so … The width is $x = w$, so".
                    false => !is_fact || before.is_disjoint(&values),
                }
            });
            let set = match is_case && kind != SuppositionKind::Figure || in_passing {
                true => formulas.iter().filter_map(set_to_a_number).collect(),
                false => Set::new(),
            };
            active.push(self.locals.len());
            self.locals.push(Local {
                set,
                formulas: formulas.into_iter().map(Arc::new).collect(),
                is_let,
                span,
                of_case: is_case || matches!(kind, SuppositionKind::Fact { of_case: true, .. }),
                is_told: is_fact,
                is_special: false,
                is_figure: false,
                means: false,
                lasts: false,
                of_display: false,
                moment: None,
                level,
            });
        }
    }

    /// What a text says that is supposed, statement by statement.
    pub(super) fn supposed(&self, body: Span) -> Result<Vec<(Vec<Formula>, Span)>, SyntaxError> {
        let source = &self.document.source;
        let mut statements = match self.read_slopes(body) {
            Ok(statements) => statements,
            Err(error) => {
                let bounds = bounds_of_all(source, body).ok_or(error)?;
                return Ok(vec![(bounds, body)]);
            }
        };
        let declared = |name: &Symbol| self.is_declared(name);
        let doubtful = doubtful(&statements, &declared, &OnPage::default());
        if let Some(error) = doubtful.or_else(|| differentials::shown(&statements, declared)) {
            return Err(error);
        }
        self.read_exponentials(statements.iter_mut());
        match statements.iter().find(|s| !s.under.is_empty()) {
            Some(conditional) => Err(SyntaxError {
                span: conditional.span,
                message: "what is supposed here is said under a condition".into(),
                help: Some("suppose the condition first".into()),
            }),
            None => Ok(statements
                .iter()
                .map(|own| (formulas(own), own.span))
                .collect()),
        }
    }

    /// Reads mathematics in the text, slopes with a slash as displays write them: "In the steady state $dc/dt = 0$".
    pub(super) fn read_slopes(&self, body: Span) -> Result<Vec<Statement>, SyntaxError> {
        let source = &self.document.source;
        read_formulas(source, body).or_else(|error| {
            let text = source.get(body.range()).unwrap_or_default();
            let d = Symbol::new("d");
            let written = without_slashes(source, text).filter(|_| !self.is_declared(&d));
            let written = written.ok_or_else(|| error.clone())?;
            let mut read =
                read_formulas(&written, Span::new(0, written.len())).map_err(|_| error)?;
            read.iter_mut().for_each(|own| own.span = body);
            Ok(read)
        })
    }

    /// Whether a text says by terms what symbols are, such as these.
    pub(super) fn explains(&self, body: Span, such: impl Fn(&Symbol) -> bool) -> bool {
        let said = self.supposed(body).unwrap_or_default();
        let mut said = said.iter().flat_map(|own| &own.0);
        let explains = |formula: &Formula| match formula.as_equation() {
            Some((Expr::Symbol(symbol), value)) => {
                is_term(value) && such(symbol) && !value.mentions(symbol)
            }
            _ => false,
        };
        said.clone().next().is_some() && said.all(explains)
    }

    /// Whether a text says of a quantity that it is another one, such as these: "All of it becomes kinetic energy, $U = K$".
    pub(super) fn links(&self, body: Span, such: impl Fn(&Symbol) -> bool) -> bool {
        let said = self.supposed(body).unwrap_or_default();
        let mut said = said.iter().flat_map(|own| &own.0);
        let links = |formula: &Formula| match formula.as_equation() {
            Some((Expr::Symbol(one), Expr::Symbol(other))) => !such(one) && such(other),
            _ => false,
        };
        said.clone().next().is_some() && said.all(links)
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
            local.is_special =
                !explains && !reason && values.any(|symbol| known.speaks_of(&symbol));
            let is_meaning = |formula: &Arc<Formula>| match formula.as_equation() {
                Some((Expr::Symbol(_) | Expr::Apply(..), value)) => {
                    is_term(value) || reason && matches!(value, Expr::Symbol(_))
                }
                _ => false,
            };
            // "For a uniform disk the density is $\sigma = M/(\pi R^2)$": of a new symbol that is said for good.
            let of_case = local.is_told && local.of_case && local.is_special;
            let lasts = local.moment.is_none() && !local.is_special && !of_case;
            local.means = lasts && local.formulas.iter().all(is_meaning);
        }
    }

    /// Begins with what is said of one moment: other moments are left, and the cases whose sentence goes on with the display are of
    /// this one, "At $t = 0$ $$v = v_0$$". What is said of the same moment as the display before `goes_on` with its passage, which is
    /// returned.
    pub(super) fn begin_moment(
        &mut self,
        display: usize,
        goes_on: bool,
        cases: &[usize],
        active: &mut Vec<usize>,
    ) -> usize {
        let of = |locals: &[Local], at: usize| locals[at].moment.as_ref().map(|own| own.passage);
        let before = active.iter().rev().find_map(|&at| of(&self.locals, at));
        let passage = before.filter(|_| goes_on).unwrap_or(display);
        for &at in cases {
            let mut said = self.locals[at].formulas.iter();
            let subject = said.find_map(|formula| formula.as_equation());
            self.locals[at].moment = subject.map(|(subject, _)| Moment {
                passage,
                display: None,
                subject: subject.clone(),
            });
        }
        active.retain(|&at| of(&self.locals, at).is_none_or(|own| own == passage));
        passage
    }

    /// What was just supposed is so at the moment whose passage begins there.
    pub(super) fn date(&mut self, new: RangeFrom<usize>, passage: usize) {
        for local in &mut self.locals[new] {
            let mut said = local.formulas.iter();
            let subject = said.find_map(|formula| formula.as_equation());
            local.moment = subject.map(|(subject, _)| Moment {
                passage,
                display: None,
                subject: subject.clone(),
            });
            local.of_case = true;
        }
    }

    /// Leaves what has another value at the moment that was named just now, "Initially $x = 0$, at the end $x = 1$": no display was of that.
    pub(super) fn leave_other_values(&mut self, new: RangeFrom<usize>, active: &mut Vec<usize>) {
        let subject = |local: &Local| local.moment.as_ref().map(|own| own.subject.clone());
        let named: Vec<Expr> = self.locals[new.clone()]
            .iter()
            .filter_map(subject)
            .collect();
        active.retain(|&at| {
            let local = &mut self.locals[at];
            let is_other = at < new.start && subject(local).is_some_and(|own| named.contains(&own));
            if is_other {
                local.moment = None;
            }
            !is_other
        });
    }

    /// What the text tells for good, it tells of the moment that it speaks of: "Initially $$h = 0$$ and the speed is $v = u$".
    pub(super) fn date_with(&mut self, new: RangeFrom<usize>, active: &[usize]) {
        let moments = active.iter().rev();
        let moment = moments
            .filter_map(|&at| self.locals[at].moment.as_ref())
            .next();
        if let Some(passage) = moment.map(|own| own.passage)
            && self.locals[new.clone()]
                .iter()
                .all(|local| local.set.is_empty())
        {
            self.date(new, passage);
        }
    }

    /// Forgets what was told of moments that are left.
    pub(super) fn forget_moments(&self, active: &[usize], told: &mut Vec<usize>) {
        let passage = |at: &usize| self.locals[*at].moment.as_ref().map(|own| own.passage);
        told.retain(|at| {
            let own = passage(at);
            own.is_none() || active.iter().any(|other| passage(other) == own)
        });
    }

    /// Takes up what a display says of one moment.
    pub(super) fn suppose_at_moment(
        &mut self,
        said: Vec<Formula>,
        (display, span): (usize, Span),
        passage: usize,
        active: &mut Vec<usize>,
    ) -> Range<usize> {
        let start = self.locals.len();
        for formula in said {
            let subject = formula.as_equation().map(|(subject, _)| subject.clone());
            self.locals.push(Local {
                set: Set::new(),
                moment: subject.map(|subject| Moment {
                    passage,
                    display: Some(display),
                    subject,
                }),
                formulas: vec![Arc::new(formula)],
                is_let: false,
                span,
                of_case: true,
                is_told: false,
                is_special: false,
                is_figure: false,
                means: false,
                lasts: false,
                of_display: false,
                level: 0,
            });
        }
        let own = start..self.locals.len();
        active.extend(own.clone());
        own
    }

    /// What prose says to be zero, or to have a value, where that is known: at its place in the text, after these equations, and with what
    /// the text cites.
    pub(super) fn vanishing(
        &self,
        what: Vanishing,
        (body, equations, cited): (Span, &[Equation], &[Citation]),
    ) -> Option<Expr> {
        let source = &self.document.source;
        let mut before = equations.iter().rev().take(MOST_BEFORE);
        // Of what is cited there, or else of the display before.
        let at = cited.partition_point(|own| own.span.start < body.start);
        let meant = || match cited.get(at).filter(|own| own.span == body) {
            Some(cited) => equations.iter().rev().find(|own| match cited.key {
                true => own.keys.contains(&cited.tag),
                false => own.tag.as_ref() == Some(&cited.tag),
            }),
            None => equations.last().filter(|_| what != Vanishing::Cited),
        };
        match what {
            Vanishing::Term => match source.get(body.range())? {
                "one" | "unity" => Some(Expr::integer(1)),
                "zero" | "nought" => Some(Expr::integer(0)),
                _ => read_expr(source, body).ok(),
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

    /// Takes up what a display shows to be meant by names in it, for good.
    pub(super) fn suppose_meant(&mut self, said: Vec<Formula>, span: Span) -> usize {
        self.locals.push(Local {
            set: Set::new(),
            moment: None,
            formulas: said.into_iter().map(Arc::new).collect(),
            is_let: false,
            span,
            of_case: false,
            is_told: true,
            is_special: false,
            is_figure: false,
            means: true,
            lasts: true,
            of_display: false,
            level: 0,
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
            formulas: vec![Arc::new(equal)],
            is_let: false,
            span,
            of_case: true,
            is_told: passage.is_none(),
            is_special: false,
            is_figure: false,
            means: false,
            lasts: false,
            of_display: false,
            moment: passage.map(|passage| Moment {
                passage,
                display: None,
                subject,
            }),
            level: 0,
        });
        self.locals.len() - 1
    }

    /// Supposes of what says how fast something changes that it is zero: what the next display concludes from it is so as long as the text
    /// is about that.
    pub(super) fn suppose_rest(&mut self, rate: Expr, span: Span) -> usize {
        let at = self.suppose_equal(rate, Expr::integer(0), span, None);
        let own = &mut self.locals[at];
        (own.is_told, own.of_case, own.means, own.of_display) = (false, false, true, true);
        at
    }

    /// Leaves the moments of which something is derived again that had a value there, or whose value is said afresh, unless it is that
    /// value: "Hence $v = u - g t = 0$". A law may speak of it: "Energy is conserved: $$E = m v^2/2 + m g h$$".
    pub(super) fn leave_moments(
        &self,
        display: &[Part],
        is_derived: bool,
        active: &mut Vec<usize>,
    ) {
        if active.iter().all(|&at| self.locals[at].moment.is_none()) {
            return;
        }
        let said: Vec<Formula> = display
            .iter()
            .flat_map(|part| part.statements.iter().flatten())
            .flat_map(formulas)
            .collect();
        let left: Set<usize> = active
            .iter()
            .filter_map(|&at| {
                let own = self.locals[at].moment.as_ref()?;
                let spoken_of = |formula: &Formula| {
                    let mut terms = formula.terms().into_iter();
                    terms.any(|term| speaks_of(term, &own.subject))
                };
                let value = self.locals[at].formulas.first()?.as_equation()?.1;
                let is_number = matches!(value, Expr::Number(_));
                let repeats = |formula: &Formula| match formula.as_equation() {
                    Some((left, right)) => is_number && (left == value || right == value),
                    None => false,
                };
                let says_afresh = |formula: &Formula| {
                    let sides = formula.as_equation();
                    sides.is_some_and(|(left, _)| *left == own.subject)
                };
                let speaks = match is_derived {
                    true => said.iter().any(spoken_of),
                    false => said.iter().any(says_afresh),
                };
                let leaves = speaks && !said.iter().any(repeats);
                leaves.then_some(own.passage)
            })
            .collect();
        active.retain(|&at| {
            let moment = self.locals[at].moment.as_ref();
            moment.is_none_or(|own| !left.contains(&own.passage))
        });
    }

    /// Leaves what else was said of a moment that is left: "At $t = 0$ … At $t = T$".
    pub(super) fn leave_passages(&self, active: &mut Vec<usize>) {
        let passage = |at: usize| self.locals[at].moment.as_ref().map(|own| own.passage);
        let left: Set<usize> = (0..self.locals.len())
            .filter(|&at| !self.locals[at].is_told && !active.contains(&at))
            .filter_map(passage)
            .collect();
        active.retain(|&at| passage(at).is_none_or(|own| !left.contains(&own)));
    }

    /// Leaves the cases of whose symbols a display speaks again: "At $t = 0$ the switch is closed. Later $q = I t$". In the
    /// sentence that sets the case it is said of that: "at $\mu = 1$, $\eta = 4 \mu / (1 + \mu)^2 = 1$".
    pub(super) fn leave_cases(&self, display: &[Part], running: &[usize], active: &mut Vec<usize>) {
        let is_left = |at: usize| {
            let set = &self.locals[at].set;
            let statements = || {
                display
                    .iter()
                    .flat_map(|part| part.statements.iter().flatten())
            };
            let mut spoken_of = statements().flat_map(formulas).flat_map(|f| f.names());
            let is_plain = self.locals[at].moment.is_none();
            !set.is_empty()
                && is_plain
                && !running.contains(&at)
                && spoken_of.any(|name| set.contains(&name))
        };
        active.retain(|&at| !is_left(at));
    }
}

/// The derivative by what a display says the value of, `x = \\dots`, of what was last said to be made of that.
pub(super) fn slope_by(display: &[Part], equations: &[Equation]) -> Option<Expr> {
    let mut statements = display
        .iter()
        .flat_map(|part| part.statements.iter().flatten());
    let first = formulas(statements.next()?).into_iter().next()?;
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

/// What one bound says of several symbols: `a, b > 0` or `R_1, \ldots, R_4 > 0`.
fn bounds_of_all(source: &str, body: Span) -> Option<Vec<Formula>> {
    let text = source.get(body.range())?;
    let (names, bound) = text.rsplit_once(',')?;
    let start = body.end - bound.len();
    let statements = read_formulas(source, Span::new(start, body.end)).ok()?;
    let bounds = statements.iter().flat_map(formulas).collect::<Vec<_>>();
    let [
        bound @ Formula::Relation {
            left: Expr::Symbol(last),
            relation,
            ..
        },
    ] = &bounds[..]
    else {
        return None;
    };
    if *relation == Relation::Equal {
        return None;
    }
    let mut all: Vec<Symbol> = Vec::new();
    let mut dots = false;
    for name in names.split(',').map(str::trim) {
        match name {
            "\\ldots" | "\\dots" | "\\cdots" | "\\dotsc" if !dots => dots = true,
            name if !dots => all.push(read_symbol(name).ok()?),
            _ => return None,
        }
    }
    if dots {
        let (stem, from) = element_parts(all.last()?)?;
        let (own, to) = element_parts(last)?;
        if own != stem || to > from + MOST_LISTED {
            return None;
        }
        all.extend((from + 1..to).map(|position| element_symbol(&stem, position)));
    }
    all.push(last.clone());
    let of =
        |name: &Symbol| bound.map_terms(|term| term.substitute(last, &Expr::Symbol(name.clone())));
    Some(all.iter().map(of).collect())
}

/// What an equation says the value of.
fn left_side(equation: &Equation) -> Option<&Expr> {
    match equation.statements().first()?.clauses.first()? {
        Clause::Chain { sides, .. } => sides.first().map(|side| &side.expr),
        Clause::AllEqual { .. } => None,
    }
}

/// How fast something changes, where an equation says so of this slope without speaking of the time: where that is zero, it is for good.
pub(super) fn rate_of(slope: &Expr, equations: &[Equation]) -> Option<Expr> {
    let Expr::Derivative { variable, .. } = slope else {
        return None;
    };
    let mut before = equations.iter().rev();
    let rate = right_side(before.find(|own| left_side(own) == Some(slope))?)?;
    let changes = matches!(rate, Expr::Number(_)) || rate.mentions(variable);
    (!changes).then(|| rate.clone())
}

/// What it ends with.
fn right_side(equation: &Equation) -> Option<&Expr> {
    match equation.statements().first()?.clauses.first()? {
        Clause::Chain { sides, .. } => sides.last().map(|side| &side.expr),
        Clause::AllEqual { .. } => None,
    }
}

/// What a statement says of one moment: a value of what was spoken of before, or that a term has a number for its value; of a chain,
/// what its ends say. What has a name for that moment, `v_1`, has it for good.
pub(super) fn said_of_moment(
    statement: &Statement,
    extent: Extent,
    is_known: impl Fn(&Symbol) -> bool,
) -> Option<Formula> {
    if !statement.under.is_empty() || statement.clauses.len() != 1 {
        return None;
    }
    let said = formulas(statement);
    let sides: Option<Vec<_>> = said.iter().map(Formula::as_equation).collect();
    let sides = sides?;
    let ((subject, _), (_, value)) = (sides.first()?, sides.last()?);
    let named = value.free_symbols();
    let is_number = named.iter().all(Symbol::is_unit);
    let is_new = || named.iter().any(|symbol| !is_known(symbol));
    let has_value = match subject {
        Expr::Symbol(own) if !is_known(own) => **value == Expr::integer(0),
        Expr::Symbol(_) => is_number || sides.len() == 1 && is_put(value, extent) || is_new(),
        _ => is_number,
    };
    let is_state = subject.free_symbols().iter().any(names_a_state);
    let is_quantity = !subject.free_symbols().is_empty();
    (has_value && is_quantity && !is_state)
        .then(|| Formula::equal((*subject).clone(), (*value).clone()))
}

/// Whether a term speaks of what something is, and not only of how it changes: `I`, and not `dI/dt`.
fn speaks_of(term: &Expr, subject: &Expr) -> bool {
    let changes =
        matches!(term, Expr::Derivative { body, .. } if matches!(**body, Expr::Symbol(_)));
    term == subject || !changes && term.children().any(|child| speaks_of(child, subject))
}

/// Whether a mere name, or at a moment a part of it, is put as a value and not derived: "At the maximum $R = r$" is derived.
pub fn is_put(value: &Expr, extent: Extent) -> bool {
    let is_number = |term: &Expr| matches!(term, Expr::Number(_));
    let is_name = |term: &Expr| matches!(term, Expr::Symbol(_));
    let is_part = match value {
        Expr::Quotient(whole, parts) => is_name(whole) && is_number(parts),
        Expr::Product(factors) => match &factors[..] {
            [times, whole] => is_number(times) && is_name(whole),
            _ => false,
        },
        _ => false,
    };
    match extent {
        Extent::Moment => is_name(value) || is_part,
        Extent::Circumstances => is_name(value),
        _ => false,
    }
}

/// Whether a symbol is a name for a value in one state: `v_1`, `v'`, `v_{\text{top}}`; the component `v_x` is none.
fn names_a_state(symbol: &Symbol) -> bool {
    let name = symbol.name();
    let component = |below: &str| {
        matches!(
            below,
            "x" | "y" | "z" | "r" | "\\theta" | "\\phi" | "\\varphi" | "\\parallel" | "\\perp"
        )
    };
    let below = name.rsplit_once('_').map(|(_, below)| below);
    name.contains('\'') || below.is_some_and(|below| !component(below))
}

/// The symbol that an equation says is a number: `t = 0`.
fn set_to_a_number(formula: &Formula) -> Option<Symbol> {
    match formula {
        Formula::Relation {
            left: Expr::Symbol(symbol),
            relation: Relation::Equal,
            right,
        } if right.free_symbols().iter().all(Symbol::is_unit) => Some(symbol.clone()),
        _ => None,
    }
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
