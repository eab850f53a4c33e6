//! Steps that end in rounded numbers: `g = 9.79\,\mathrm{m/s^2}` from `h = 1.20\,\mathrm{m}` and `t = 0.495\,\mathrm{s}`.
//!
//! No exact equation follows from such figures, and none is claimed: what is printed is half a unit of its last decimal wide. So
//! what does not follow exactly is weighed as a numeric claim is, which proves nothing. It is refuted all the same where it is wrong
//! whatever the figures were rounded from.

use std::cell::OnceCell;

use num_traits::{Signed, Zero};

use crate::algebra::{BigInt, BigRational, Expr, Formula, Relation, Symbol};
use crate::derivation::{Assumed, Goal, Page, Printed, Source, goals, values_at};
use crate::kernel::{Refuted, Standing};
use crate::notation::{
    Precision, Rounding, Statement, decimal_places, has_decimals, has_units, is_figures,
    is_in_units,
};

use crate::search;

use super::super::again::unitless::{OTHER_UNITS, number_written};
use super::super::entry::leave_open;
use super::super::judge::{self, Judge};
use super::super::{Auditor, Entry, Judged, Note, Outcome, Verdict, numeric, premise};
use super::{Link, Numeric, Taken, Weighed, coefficient, complex, reckoned};

/// Why a step that ends in a rounded number is neither.
pub(super) const ROUNDED: &str = "it is rounded";
/// Why nothing is said of a number that differs from another one that is told of the same.
const SAID_AGAIN: &str = "another number is told of it before, and it may be told of another case";
impl Auditor<'_> {
    /// Goals that end in rounded numbers, from the figures as they are printed; if these say otherwise, from all that may have been
    /// rounded to them.
    fn weighed(&self, at: usize, goals: &[Goal], assumed: &[Assumed], said: &[Printed]) -> Numeric {
        let weighed =
            |taken| numeric::weigh_rounded(self.derivation, at, goals, assumed, taken, said);
        let numeric = weighed(Taken::Exactly);
        match numeric.outcome() {
            Weighed::Contradicted => weighed(Taken::Rounded),
            _ => numeric,
        }
    }

    /// What the page prints before, but for what is wrong.
    pub(super) fn printed_before(&self, at: usize) -> Vec<Printed> {
        let wrong = |premise: usize| {
            let mut entries = self.entries_of(at, premise);
            entries.any(|entry| match entry.verdict {
                Verdict::Fails | Verdict::IllDimensioned => true,
                _ => entry
                    .notes
                    .iter()
                    .any(|note| matches!(note, Note::NumericNotSupported)),
            })
        };
        let mut all = self.derivation.figures_before(at);
        all.retain(|own| !own.equation.is_some_and(wrong));
        // What is printed behind a step came out, and was rounded: "The heats are $q = 1050$".
        let end = self.derivation.equations[at].span.end;
        for own in all.iter_mut().filter(|own| own.span.start > end) {
            own.goal = near_whole(&own.goal);
        }
        all
    }

    /// Weighs what was not proved of a statement, if all of that ends in rounded numbers.
    pub(in crate::audit) fn weigh_rounded(
        &self,
        judge: &Judge,
        premises: &[usize],
        entry: &mut Entry,
    ) {
        let (at, usable) = (judge.at, judge.usable);
        if !matches!(entry.verdict, Verdict::Fails | Verdict::Undecided) {
            return;
        }
        let is_settled =
            |own: &&Judged| own.outcome.is_proven() || matches!(own.outcome, Outcome::Defined);
        let open = entry.judged.iter().filter(|own| !is_settled(own));
        // A whole number is exact, but not where what it is worked out from is rounded.
        let page = &self.derivation.pages[self.derivation.equations[at].page];
        let as_meant = |own: &Judged| match usable.numeric.is_empty() {
            true => as_rounded(own, page),
            false => near_whole(&own.goal),
        };
        // What is worked out of numbers alone, and rounded on the way.
        let source = &page.document.source;
        let (mut agreed, mut wrong, mut left) = (Vec::new(), Vec::new(), Vec::new());
        let as_near = |own: &Judged| {
            let before = self.derivation.link_before(at, &own.goal);
            as_near_as_before(as_meant(own), before)
        };
        for goal in open.map(as_near).map(near_summands) {
            if let Some(link) = reckoned::agreed_loosely(&goal, source) {
                agreed.push(link);
                continue;
            }
            match coefficient::weighed(&goal, source, &usable.assumed) {
                Some(link) if link.outcome == Weighed::Supported => agreed.push(link),
                Some(link) if link.outcome == Weighed::Contradicted => wrong.push(link),
                _ => left.push(goal),
            }
        }
        if !wrong.is_empty() {
            return self.heed_coefficients(judge, wrong, entry);
        }
        let open = left;
        if open.is_empty() && !agreed.is_empty() {
            leave_open(entry, ROUNDED);
            entry.numeric = Some(Box::new(Numeric::of_links(agreed)));
            return;
        }
        for judged in &mut entry.judged {
            let is_own = |own: &Link| own.goal.sides == judged.goal.sides;
            if judged.outcome.is_refuted() && agreed.iter().any(is_own) {
                judged.outcome = Outcome::open(ROUNDED);
            }
        }
        let printed = OnceCell::new();
        let printed = || printed.get_or_init(|| self.printed_before(at)).as_slice();
        if open.is_empty() || !open.iter().all(is_weighed) {
            let refuted = entry.judged.iter().filter(|own| own.outcome.is_refuted());
            let refuted: Vec<Goal> = refuted.map(as_meant).collect();
            // Beside a link that is open the one that is refuted may only be rounded.
            let is_near = || {
                let all = self.figures(at, usable);
                let weighed = |said: &[Printed]| self.weighed(at, &refuted, &all, said);
                refuted.iter().all(is_weighed)
                    && (weighed(&[]).is_supported() || weighed(printed()).is_supported())
            };
            if self.weigh_decimals(judge, premises, &open, entry) {
                return;
            }
            match entry.verdict == Verdict::Fails && is_near() {
                true => leave_open(entry, ROUNDED),
                false => self.leave_possible(judge, premises, entry),
            }
            self.weigh_beside(at, usable, &open, entry);
            return;
        }
        let mut assumed = self.figures(at, usable);
        // What the links before say.
        let settled = entry.judged.iter().filter(is_settled);
        assumed.extend(settled.map(|own| judge::step(&own.goal.formula)));
        let mut numeric = self.weighed(at, &open, &assumed, &[]);
        if !numeric.is_supported() {
            // What is printed elsewhere on the page may say more, and nearer to what is measured.
            let with = self.weighed(at, &open, &assumed, printed());
            if !matches!(with.outcome(), Weighed::NoValue(_)) {
                numeric = with;
            }
        }
        if matches!(numeric.outcome(), Weighed::NoValue(_)) && judge.cites_loosely() {
            // What all of the left side is may have been said before: `V/W = a/b`.
            let [others, _] = judge.others(premises);
            let all = assumed.iter().chain(others).cloned();
            let all: Vec<Assumed> = all.chain(judge.open_before(premises)).collect();
            let with = self.weighed(at, &open, &all, &[]);
            if with.is_supported() {
                numeric = with;
            }
        }
        if matches!(numeric.outcome(), Weighed::NoValue(_)) && !usable.out_of_scope.is_empty() {
            // "With these figures (2) gives" means the equation, under whatever case that was drawn.
            let others = self.of_other_cases(at, usable);
            let all: Vec<Assumed> = assumed.iter().cloned().chain(others).collect();
            let with = self.weighed(at, &open, &all, &[]);
            if with.is_supported() {
                numeric = with;
            }
        }
        if matches!(numeric.outcome(), Weighed::NoValue(_)) && !judge.is_directed() {
            let before = self.open_figures(judge, premises);
            let all: Vec<Assumed> = assumed.iter().cloned().chain(before).collect();
            let mut sets = [assumed, all].into_iter();
            let found = sets.find_map(|own| self.with_what_is_usual(at, &open, &own, printed()));
            numeric = found.unwrap_or(numeric);
        }
        if self.says_again(at, &numeric, printed) {
            return leave_open(entry, SAID_AGAIN);
        }
        match (numeric.outcome(), entry.verdict) {
            (Weighed::Supported | Weighed::NotSettled, _) => {
                leave_open(entry, ROUNDED);
                entry
                    .notes
                    .retain(|note| !matches!(note, Note::UnstatedCondition(_)));
            }
            (Weighed::Contradicted, Verdict::Undecided) => {
                if self.mixes_units(at, &numeric, printed()) {
                    return leave_open(entry, OTHER_UNITS);
                }
                entry.notes.push(Note::NumericNotSupported);
            }
            (Weighed::Contradicted, _) => {
                (entry.implied, entry.mended) = (None, None);
                entry.missing.clear();
            }
            // Where figures are cited, they may have told it.
            (Weighed::NoValue(_), _) if usable.numeric.is_empty() => {
                return self.leave_possible(judge, premises, entry);
            }
            _ => return,
        }
        let mut used = numeric::used(&numeric);
        used.extend(self.concerned(entry.judged.iter(), &usable.numeric));
        let open = self.unproved(at, &used);
        if !open.is_empty() {
            entry.notes.push(Note::RestsOnUnproved(open));
        }
        entry.numeric = Some(numeric.into());
    }

    /// Weighs what ends in numbers beside what is left open. Of what figures speak against that is told where they support it with one small
    /// edit, or where it is complex.
    fn weigh_beside(&self, at: usize, usable: &premise::Usable, open: &[Goal], entry: &mut Entry) {
        let page = &self.derivation.pages[self.derivation.equations[at].page];
        let is_complex = |own: &Goal| complex::ends_in_one(own, &page.complex);
        // What is worked out of numbers alone is weighed wherever it stands.
        let is_worked_out = |own: &Goal| match own.formula.as_equation() {
            Some((left, _)) => is_figures(left),
            None => true,
        };
        let is_number = |own: &&Goal| is_weighed(own) && !is_worked_out(own) || is_complex(own);
        let numbers: Vec<Goal> = open.iter().filter(is_number).cloned().collect();
        if entry.verdict != Verdict::Undecided || numbers.is_empty() {
            return;
        }
        let (figures, printed) = (self.figures(at, usable), self.printed_before(at));
        let exactly = |goals: &[Goal]| {
            let taken = Taken::Exactly;
            numeric::weigh_rounded(self.derivation, at, goals, &figures, taken, &printed)
        };
        for goal in numbers {
            let goals = [goal];
            let mut numeric = self.weighed(at, &goals, &figures, &printed);
            if *numeric.outcome() != Weighed::Contradicted
                || self.says_again(at, &numeric, || &printed)
            {
                continue;
            }
            if !is_complex(&goals[0]) {
                numeric.nearest = self.slip_of_figures(at, &goals, &numeric, &exactly);
                if numeric.nearest.is_none() {
                    continue;
                }
            }
            entry.notes.push(Note::NumericNotSupported);
            entry.numeric = Some(numeric.into());
            return;
        }
    }

    /// Whether what is wrong is said again of something, and not worked out: it is said of another case. So is what differs from what a display
    /// prints of the same, and is said to follow from nothing.
    fn says_again<'p>(
        &self,
        at: usize,
        numeric: &Numeric,
        printed: impl Fn() -> &'p [Printed],
    ) -> bool {
        let (_, is_cited, _) = self.derivation.premises(at);
        let is_printed = |own: &Symbol| {
            let mut all = printed().iter().filter(|own| own.equation.is_some());
            !is_cited && all.any(|other| other.goal.formula.said_of().is_some_and(|of| of.0 == own))
        };
        let is_wrong = |own: &&Link| own.outcome == Weighed::Contradicted;
        let mut wrong = numeric.links.iter().filter(is_wrong);
        wrong.any(|link| match &link.goal.formula {
            Formula::Relation {
                left: Expr::Symbol(own),
                ..
            } => numeric.data.contains_key(own) || is_printed(own),
            _ => false,
        })
    }

    /// Whether some of the numbers in the text that are put in stand without a unit, and others beside words that are turned into units of the SI:
    /// "$r = 0.90$, $h = 0.10$ per year". Who writes prefixes, "$d = 5$ mm", thinks in the SI.
    fn mixes_units(&self, at: usize, numeric: &Numeric, printed: &[Printed]) -> bool {
        let page = &self.derivation.pages[self.derivation.equations[at].page];
        let source = &page.document.source;
        let (mut bare, mut converted) = (false, false);
        for own in printed.iter().filter(|own| own.equation.is_none()) {
            let Some((of, value)) = own.goal.formula.said_of() else {
                continue;
            };
            let text = source.get(own.span.range()).unwrap_or_default();
            if let (Expr::Number(value), Some(Expr::Number(written))) =
                (value, number_written(text))
                && numeric.data.contains_key(of)
            {
                match *value == written {
                    true => bare |= !is_in_units(source, own.span.end),
                    false => converted |= !is_power_of_ten(&(value / written)),
                }
            }
        }
        bare && converted
    }

    /// Leaves open what fails only for rounded numbers that may be so, as far as what it was judged from tells: somebody measured them.
    ///
    /// A whole number, `400\,\Omega`, must be possible as far as anything before tells.
    fn leave_possible(&self, judge: &Judge, premises: &[usize], entry: &mut Entry) {
        let at = judge.at;
        let is_possible = |own: &Judged| {
            let so = [judge::step(&own.goal.formula)];
            let others: &[Assumed] = match !is_weighed(&own.goal) && is_quantity(&own.goal) {
                true => &judge.others(premises)[0],
                false => &[],
            };
            let all = own.assumed.iter().chain(others).cloned().chain(so);
            let all: Vec<Assumed> = all.collect();
            let claim = self.derivation.claim(at, &all, &own.goal.formula);
            let found = search::consistency(&claim, &self.hints());
            !matches!(found, search::Consistency::Contradictory(_))
        };
        // `x_1 = \frac{5 + 7}{6} = 2`; `\beta \geq \frac{569 - 506}{569 - 450} = 0.53`, where nothing bounds it.
        let is_evaluated = |own: &Judged| {
            let value = match &own.goal.formula {
                Formula::Relation {
                    left,
                    relation,
                    right,
                } => {
                    let names = left.free_symbols();
                    let speaks = |own: &Assumed| !own.formula.names().is_disjoint(&names);
                    let is_free = *relation == Relation::Equal || !own.assumed.iter().any(speaks);
                    is_free.then_some((left, right))
                }
                Formula::AllEqual { .. } => None,
            };
            let is_figure = |term: &Expr| term.free_symbols().iter().all(Symbol::is_unit);
            entry
                .judged
                .iter()
                .any(|next| match (value, &next.goal.formula) {
                    (Some((_, value)), Formula::Relation { left, right, .. }) => {
                        value == left && is_figure(left) && is_figure(right)
                    }
                    _ => false,
                })
        };
        // `u = 0.125\,\mathrm{m/s}, \quad \mathrm{Re} = 250`, where nobody has told what that is made of.
        let statements = self.derivation.equations[at].statements();
        let lists_numbers = || {
            let ends = |own: &Statement| goals(own).last().is_some_and(ends_in_figures);
            statements.len() > 1 && statements.iter().all(ends)
        };
        let is_number = |own: &Judged| {
            let sides = own.goal.formula.as_equation();
            let is_plain = |value: &Expr| value.is_arithmetic() && value.free_symbols().is_empty();
            let is_one =
                sides.is_some_and(|(of, value)| matches!(of, Expr::Symbol(_)) && is_plain(value));
            let outright = own.goal.suppositions.is_empty();
            is_one
                && outright
                && entry.mended.is_none()
                && (lists_numbers() || judge.cites_loosely())
        };
        let may_be =
            |own: &Judged| says_how_great(&own.goal) || is_evaluated(own) || is_number(own);
        let mut refuted = entry.judged.iter().filter(|own| own.outcome.is_refuted());
        if entry.verdict == Verdict::Fails && refuted.all(|own| may_be(own) && is_possible(own)) {
            leave_open(
                entry,
                "it says how great something is, and nothing before tells that",
            );
        }
    }

    /// What an equation says that is supported by figures.
    fn supported(&self, at: usize, premise: usize) -> Vec<Assumed> {
        let entries = self.entries_of(at, premise);
        let weighed = entries.filter_map(|entry| entry.numeric.as_ref());
        let links = weighed
            .filter(|own| own.is_supported())
            .flat_map(|own| &own.links);
        links
            .map(|link| Assumed {
                formula: link.goal.formula.clone().into(),
                standing: Standing::AtPoint,
                source: Source::Equation(premise),
            })
            .collect()
    }

    /// What else they may be taken from where that supports a step, whatever is cited: what stands before, be it proved or left open.
    pub(super) fn open_figures(&self, judge: &Judge, premises: &[usize]) -> Vec<Assumed> {
        let is_wrong = |own: &Assumed| match own.source {
            Source::Equation(premise) => {
                let mut entries = self.entries_of(judge.at, premise);
                entries.any(Entry::is_wrong)
            }
            _ => false,
        };
        let mut all = judge.usable.assumed.clone();
        all.extend(judge.others(premises)[0].iter().cloned());
        all.extend(judge.open_before(premises));
        all.retain(|own| !is_wrong(own));
        all
    }

    /// What figures may be taken from: what is cited and sound, what the text tells, and what is supported by figures itself.
    pub(super) fn figures(&self, at: usize, usable: &premise::Usable) -> Vec<Assumed> {
        let mut all = self.sound_figures(at, usable);
        all.extend(self.told_figures(at));
        for &premise in &usable.numeric {
            all.extend(self.supported(at, premise));
        }
        all
    }

    /// What the text tells in passing, but for places of which it spoke before: "from a level $y = a$", where something is differentiated by `y`.
    fn told_figures(&self, at: usize) -> Vec<Assumed> {
        let mut told = self.derivation.told(at);
        if told.is_empty() {
            return told;
        }
        let variables = self.variables(at);
        let just = self.derivation.told_just_before(at);
        let is_place = |own: &Assumed| match own.formula.as_equation() {
            Some((Expr::Symbol(name), value)) => variables.contains(name) && !is_figures(value),
            _ => false,
        };
        told.retain(|own| just.contains(own) || !is_place(own));
        told
    }
}

/// Whether a goal that is not proved is weighed: it ends in a rounded number, and is asserted as it stands.
pub(super) fn is_weighed(goal: &Goal) -> bool {
    goal.rounding.is_some() && goal.is_said_outright()
}

fn ends_in_figures(goal: &Goal) -> bool {
    let sides = goal.formula.as_equation();
    sides.is_some_and(|(_, right)| is_figures(right))
}

/// Whether a goal says how great something is: it ends in a rounded number, or in figures from which that is worked out.
fn says_how_great(goal: &Goal) -> bool {
    let asserts = goal.is_said_outright();
    is_weighed(goal) || asserts && is_measured(goal)
}

/// Whether a goal ends in figures, units or decimals among them, and begins with what is no figure.
pub(in crate::audit) fn is_measured(goal: &Goal) -> bool {
    let Some((left, right)) = goal.formula.as_equation() else {
        return false;
    };
    let of_figures = is_figures(right) && (has_units(right) || has_decimals(right));
    !is_figures(left)
        && (of_figures || has_units(right) && !has_units(left))
        && numeric::is_evaluable(right)
}

/// Whether a goal ends in a number with units beside it, and in nothing that is worked out.
pub(super) fn is_quantity(goal: &Goal) -> bool {
    let is_unit = |own: &Expr| {
        let symbols = own.free_symbols();
        !symbols.is_empty() && symbols.iter().all(Symbol::is_unit)
    };
    let Some((_, right)) = goal.formula.as_equation() else {
        return false;
    };
    let right = match right {
        Expr::Negate(inner) => inner,
        right => right,
    };
    match right {
        Expr::Product(factors) => match factors.split_first() {
            Some((Expr::Number(_), units)) => units.iter().all(is_unit),
            _ => false,
        },
        right => matches!(right, Expr::Number(_)),
    }
}

/// Leaves open what was refuted, and figures speak against: that is told instead.
pub(in crate::audit) fn open_by_figures(entry: &mut Entry) {
    leave_open(entry, ROUNDED);
    entry.notes.push(Note::NumericNotSupported);
}

/// How many units a term is, if it is nothing but so many.
fn number_of(term: &Expr) -> Option<&BigRational> {
    match term {
        Expr::Number(number) => Some(number),
        Expr::Product(factors) => match factors.split_first()? {
            (Expr::Number(number), units) => {
                let is_unit = |own: &Expr| own.free_symbols().iter().all(Symbol::is_unit);
                units.iter().all(is_unit).then_some(number)
            }
            _ => None,
        },
        _ => None,
    }
}

/// The goal of a link that ends in a whole number, taken for rounded where it is no decimal: two digits of a root, and three of a multiple
/// of π, which may have been worked out from more digits than are printed, or of a fraction that has a unit.
fn as_rounded(judged: &Judged, page: &Page) -> Goal {
    let goal = &judged.goal;
    let sides = goal.formula.as_equation();
    let value = sides.and_then(|(left, right)| Some((left, number_of(right)?)));
    let (Outcome::Refuted(refuted), Some((left, value))) = (&judged.outcome, value) else {
        return goal.clone();
    };
    let reaches = |least: i64| *value >= BigRational::from_integer(least.into());
    let pi = Symbol::new("\\pi");
    let mut loosely = near_whole(goal);
    if refuted.witness().algebraic.is_some() && reaches(10) {
        return loosely;
    }
    // `E I = 333\,\mathrm{N\,m^2}` for 1000/3
    let is_near = |own: &Rounding| is_rounded(left, value, &own.share, refuted);
    if reaches(100)
        && sides.is_some_and(|(_, right)| has_units(right))
        && loosely.rounding.as_ref().is_some_and(is_near)
    {
        return loosely;
    }
    if !left.mentions(&pi) || page.domains.contains_key(&pi) || !reaches(100) {
        return goal.clone();
    }
    if let (None, Some(rounding)) = (&goal.rounding, &mut loosely.rounding) {
        rounding.share *= BigRational::from_integer(2.into());
    }
    loosely
}

/// Whether the value of a term at a point can be no decimal, and is a number up to a share of that, units aside.
fn is_rounded(term: &Expr, number: &BigRational, share: &BigRational, refuted: &Refuted) -> bool {
    let there = values_at(refuted.claim(), refuted.witness());
    let Ok(value) = there.value(term) else {
        return false;
    };
    decimal_places(&value).is_none() && (value - number).abs() <= share * number
}

/// A goal whose right side adds up whole numbers of one unit that are long enough to be rounded, `T = 662\,\mathrm{keV} - 184\,\mathrm{keV}`: each is
/// half a unit of its last digit wide.
fn near_summands(goal: Goal) -> Goal {
    const LEAST: i64 = 100;
    let parted = |term: &Expr| {
        let (negative, term) = match term {
            Expr::Negate(inner) => (true, &**inner),
            term => (false, term),
        };
        let number = number_of(term)?;
        let unit = match term {
            Expr::Product(factors) => factors[1..].to_vec(),
            _ => Vec::new(),
        };
        let is_long = number.is_integer() && *number >= BigRational::from_integer(LEAST.into());
        let number = if negative { -number } else { number.clone() };
        is_long.then_some((number, unit))
    };
    let share = || {
        let Some((_, Expr::Sum(terms))) = goal.formula.as_equation() else {
            return None;
        };
        let parted: Option<Vec<(BigRational, Vec<Expr>)>> = terms.iter().map(parted).collect();
        let parted = parted?;
        let unit = &parted.first()?.1;
        let sum: BigRational = parted.iter().map(|(number, _)| number).sum();
        let is_one = parted.iter().all(|(_, own)| own == unit) && !sum.is_zero();
        let width = BigRational::new(parted.len().into(), 2.into());
        is_one.then(|| width / sum.abs())
    };
    match goal.rounding {
        None => {
            let rounding = share().map(|share| Rounding {
                share,
                precision: Precision::Whole,
            });
            Goal { rounding, ..goal }
        }
        Some(_) => goal,
    }
}

/// A goal that goes on from what the link before it rounded, as near as that is at most: `r = 1.63\,a_0 = 0.0862\,\mathrm{nm}`.
fn as_near_as_before(mut goal: Goal, before: Option<Goal>) -> Goal {
    let is_of_figures = |own: &Goal| {
        own.formula
            .terms()
            .get(1)
            .is_some_and(|end| is_figures(end))
    };
    let before = before.filter(|own| !is_of_figures(own));
    if let (Some(own), Some(before)) = (&mut goal.rounding, before.and_then(|own| own.rounding)) {
        own.share += before.share;
    }
    goal
}

/// A goal whose right side is a whole number, taken for rounded to its last digit that is not 0.
pub(super) fn near_whole(goal: &Goal) -> Goal {
    let number = (goal.formula.as_equation()).and_then(|(_, right)| number_of(right));
    let whole = number.filter(|number| number.is_integer() && !number.is_zero());
    let rounding = whole.map(|number| {
        let digits = number.to_integer().to_string();
        let digits: String = digits.chars().filter(char::is_ascii_digit).collect();
        let leading: BigInt = digits.trim_end_matches('0').parse().unwrap_or_default();
        Rounding {
            share: BigRational::new(1.into(), leading * 2),
            precision: Precision::Whole,
        }
    });
    Goal {
        rounding: goal.rounding.clone().or(rounding),
        ..goal.clone()
    }
}

/// Whether a number is `10`, `100`, `1/1000`: what the prefixes of units are.
fn is_power_of_ten(number: &BigRational) -> bool {
    let whole = (number.numer() * number.denom()).to_string();
    whole.trim_end_matches('0') == "1"
}
