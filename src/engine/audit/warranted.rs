//! Whether a counterexample to a step of loose prose warrants the word that it fails.
//!
//! Where directives say what follows from what, a step is wrong if it is false somewhere where all that is true. Where none does, what a step
//! is to follow from is gathered from the words around it, and most texts leave something unsaid: that a wheel rolls, that two resistances
//! are the same. Then much is false at some point that nobody thinks of. That it is a slip shows where there is something right that it is a
//! slip of: one small edit with which the same step would have been shown; or where nothing can have been left unsaid, as in a piece of
//! algebra or arithmetic, or where the text cites what speaks of all of it.

use std::cell::LazyCell;

use num_traits::Signed;

use crate::algebra::{Expr, Formula, Relation, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source, first_goal, goals, in_a_row};
use crate::document::Span;
use crate::notation::{Statement, has_units, plain_formula, read_expr};
use crate::search::{self, Decision, Mended};
use crate::sorted::Set;

use super::entry::{Entry, leave_open};
use super::readings::Circumstances;
use super::stated::quantities;
use super::{Auditor, Judged, Note, Outcome, Verdict, judge, numeric};

/// How much work may be done to see whether a bound is wrong for positive numbers, too.
const MOST_WORK: u64 = 2_000_000;
/// So many values are told of a point.
const MOST_VALUES: usize = 6;

impl Auditor<'_> {
    /// Leaves open what fails as far as was found, where something may be left unsaid that it follows from.
    pub(super) fn heed_what_is_unsaid(
        &self,
        statement: &Statement,
        how: &Circumstances,
        mut entry: Entry,
    ) -> Entry {
        if self.is_open_for_what_is_unread(how, &entry)
            && self.may_leave_unsaid(statement, how, &entry)
            && let Some((before, mended)) = self.slip_in(statement, how, &entry)
        {
            entry.verdict = Verdict::Fails;
            let is_unread = |own: &Note| matches!(own, Note::UnreadablePremise(_));
            entry.notes.retain(|own| !is_unread(own));
            return slipped(entry, before, mended);
        }
        let by_laws = (entry.refuted()).is_some_and(|(own, _)| may_follow_from_laws(own));
        if entry.verdict != Verdict::Fails
            || !by_laws && !self.may_leave_unsaid(statement, how, &entry)
        {
            return entry;
        }
        let is_wrong =
            |own: &&Judged| own.outcome.is_refuted() && self.fails_where_positive(how.at, own);
        let wrong: Vec<&Judged> = entry.judged.iter().filter(is_wrong).collect();
        let is_first = entry
            .refuted()
            .is_some_and(|(first, _)| wrong.first().is_some_and(|own| std::ptr::eq(*own, first)));
        let is_warranted = is_first && self.has_repair(&entry)
            || !by_laws
                && (self.leaves_nothing_unsaid(statement, how, &wrong)
                    || entry.rescaled().is_some());
        if is_warranted {
            return entry;
        }
        let slip = || self.slip_in(statement, how, &entry);
        match is_first.then(slip).flatten() {
            Some((before, mended)) => slipped(entry, before, mended),
            None => {
                let reason = unsaid(&entry);
                leave_open(&mut entry, &reason);
                entry
            }
        }
    }

    /// Whether something was refuted, and is left open only for a premise that could not be read. What is one slip away from what follows says
    /// no more than that.
    fn is_open_for_what_is_unread(&self, how: &Circumstances, entry: &Entry) -> bool {
        let usable = how.usable;
        entry.verdict == Verdict::Undecided
            && entry.refuted().is_some()
            && entry.mended.is_none()
            && !usable.unreadable.is_empty()
            && usable.later.is_empty()
            && usable.in_limit.is_empty()
            && self.derivation.equations[how.at].unread.is_empty()
    }

    /// Whether the text is one that may leave something unsaid: no directive says what follows from what.
    pub(super) fn may_leave_unsaid(
        &self,
        statement: &Statement,
        how: &Circumstances,
        entry: &Entry,
    ) -> bool {
        let page = &self.derivation.pages[self.derivation.equations[how.at].page];
        !page.is_annotated() && entry.numeric.is_none() && statement.quantified.is_empty()
    }

    /// Whether something near to what is printed is known to follow.
    fn has_repair(&self, entry: &Entry) -> bool {
        let Some((judged, _)) = entry.refuted() else {
            return false;
        };
        if let Some(implied) = &entry.implied {
            let own = judged.goal.formula.names();
            let names = implied.proven.claim().goal.names();
            // What speaks of more may be said of more.
            let is_said = names == own;
            // What rests on a guess of what a name means may be a wrong guess.
            let mut assumed = judged.assumed.iter();
            let is_guessed = assumed.any(|own| own.source == Source::Taken);
            if implied.is_multiple() || is_said && !is_guessed {
                return true;
            }
        }
        let mended = entry.mended.as_ref();
        mended.is_some_and(|mended| {
            let goal = &judged.goal.formula;
            let untied = LazyCell::new(|| self.untied(entry.equation, goal));
            !is_supposed(goal, &mended.under)
                && self.is_likely(entry.equation, &mended.change, &untied)
        })
    }

    fn leaves_nothing_unsaid(
        &self,
        statement: &Statement,
        how: &Circumstances,
        wrong: &[&Judged],
    ) -> bool {
        // What a solution is put into is not what is printed.
        let printed = goals(statement);
        let is_printed = |own: &Judged| {
            let mut printed = printed.iter();
            printed.any(|goal| goal.formula == own.goal.formula)
        };
        wrong.iter().any(|own| {
            own.solution().is_some()
                || !is_printed(own)
                || own.is_propagated()
                || is_closed(own)
                || how.says_so
                    && !is_condition(statement, own)
                    && !numeric::is_measured(&own.goal)
                    && is_spoken_of(own)
                    && !only_names(own)
                    && !self.leaves_out_in_words(how.at, own)
                    && !self.supposes_in_words(how.at)
        })
    }

    /// Whether the sentence before a step says that something is missing or small, and the step no longer speaks of all that it comes from:
    /// "With no damping, (4) is simply".
    fn leaves_out_in_words(&self, at: usize, judged: &Judged) -> bool {
        const LEFT_OUT: [&str; 4] = ["without", "absence", "absent", "negligible"];
        let words = self.derivation.leading_words(at);
        let own = judged.goal.formula.names();
        let is_left = |premise: &Assumed| !premise.formula.names().is_subset(&own);
        let says_none = || in_a_row(&words, &["with"], &["no"]);
        (words.iter().any(|word| LEFT_OUT.contains(&&**word)) || says_none())
            && judged.assumed.iter().any(is_left)
    }

    /// Whether the sentence before a step supposes something in words alone: "If the source shines exactly at the limit (3), we may eliminate".
    fn supposes_in_words(&self, at: usize) -> bool {
        let own = &self.derivation.equations[at];
        let (Some(said), Some(sentence)) = (self.derivation.leading(at), own.said_last) else {
            return false;
        };
        let mut found = said.match_indices("if ").chain(said.match_indices("If "));
        let Some((begin, _)) = found.find(|(at, _)| !said[..*at].ends_with(char::is_alphabetic))
        else {
            return false;
        };
        let end = said[begin..]
            .find(',')
            .map_or(said.len(), |comma| begin + comma);
        let clause = sentence.start + begin..sentence.start + end;
        let document = &self.derivation.pages[own.page].document;
        let mut written = self.derivation.inline_before(at).map(|math| math.body);
        // What is more than a term says something in symbols.
        let states = |body: Span| read_expr(&document.source, body).is_err();
        !written.any(|body| clause.contains(&body.start) && states(body))
    }

    /// Whether a bound is wrong for positive numbers, too, and so is what is said to be a root: most authors speak of no others, and few say
    /// so.
    fn fails_where_positive(&self, at: usize, judged: &Judged) -> bool {
        let formula = &judged.goal.formula;
        let mut names = formula.names();
        if !formula.is_inequality() {
            match formula.as_equation() {
                Some((Expr::Symbol(own), root)) if root.any(&Expr::is_root) => {
                    names.retain(|name| name == own);
                }
                _ => return true,
            }
        }
        let terms = names.iter().cloned().map(Expr::Symbol);
        let positive = terms.map(|own| judge::step(&Formula::positive(own)));
        let all: Vec<Assumed> = judged.assumed.iter().cloned().chain(positive).collect();
        let claim = self.derivation.claim(at, &all, formula);
        let decision = effort::within(MOST_WORK, || search::decide(claim, &self.hints()));
        match (decision, &judged.outcome) {
            (Decision::Refuted(_), _) => true,
            // Not known, but that is where it is false.
            (Decision::Open(_), Outcome::Refuted(refuted)) if !formula.is_inequality() => {
                let values = &refuted.witness().symbols;
                let mut values = names.iter().filter_map(|own| values.get(own));
                values.all(|value| !value.is_negative())
            }
            _ => false,
        }
    }
}

/// A step that is one slip away from what follows, with what is found of the links before that.
fn slipped(mut entry: Entry, before: Vec<Judged>, mended: Mended) -> Entry {
    for (own, edited) in entry.judged.iter_mut().zip(before) {
        *own = edited;
    }
    (entry.mended, entry.implied) = (Some(Box::new(mended)), None);
    entry.missing.clear();
    entry
}

/// Whether what is near to a link is only a bound under what is supposed besides: with enough of that any bound is so.
pub(super) fn is_supposed(link: &Formula, under: &[Formula]) -> bool {
    link.is_inequality() && !under.is_empty()
}

/// Whether a link speaks of a mean or a chance of which no premise says what it is, beside others: there are laws that relate these, as that
/// the mean of a sum is the sum of the means, and none of them is known here.
fn may_follow_from_laws(judged: &Judged) -> bool {
    let is_value =
        |own: &Symbol| own.is_bracketed() && !own.name().starts_with('[') && !own.is_part();
    let values = |formula: &Formula| -> Set<Symbol> {
        formula.names().into_iter().filter(is_value).collect()
    };
    let mut open = values(&judged.goal.formula);
    if open.is_empty() {
        return false;
    }
    let told: Vec<Set<Symbol>> = (judged.assumed.iter())
        .filter(|own| own.formula.as_equation().is_some())
        .map(|own| values(&own.formula))
        .collect();
    let mut all = open.clone();
    all.extend(told.iter().flatten().cloned());
    if all.len() < 2 {
        return false;
    }
    let mut known: Set<Symbol> = Set::new();
    loop {
        let mut unknown = told
            .iter()
            .map(|own| own.iter().filter(|own| !known.contains(*own)));
        let Some(next) = unknown.find_map(|mut own| own.next().filter(|_| own.next().is_none()))
        else {
            break;
        };
        known.insert(next.clone());
    }
    open.retain(|own| !known.contains(own));
    !open.is_empty()
}

/// Why nothing is said of what is false and near to nothing that follows.
fn unsaid(entry: &Entry) -> String {
    let (mut values, mut dots) = (Vec::new(), "");
    if let Some((judged, refuted)) = entry.refuted() {
        let mut names = judged.goal.formula.names();
        names.retain(|own| !own.is_unit());
        let own = refuted.witness().symbols.iter();
        let mut own = own.filter(|(symbol, _)| names.contains(*symbol));
        let told = own.by_ref().take(MOST_VALUES).map(|(symbol, value)| {
            let value = Expr::Number(value.clone());
            plain_formula(&Formula::equal(Expr::Symbol(symbol.clone()), value))
        });
        values.extend(told);
        dots = if own.next().is_some() { ", …" } else { "" };
    }
    let point = match values.is_empty() {
        true => "somewhere".to_owned(),
        false => format!("at {}{dots}", values.join(", ")),
    };
    let unless = match entry.missing.as_slice() {
        [] => "nothing near to it follows either".to_owned(),
        missing => {
            let missing: Vec<String> = missing.iter().map(plain_formula).collect();
            format!("it follows if also {}", missing.join(" and "))
        }
    };
    format!("false {point}, but {unless}: something may be left unsaid")
}

/// Whether a link says what it is under which the next clause follows: `\frac{dA}{dx} = 0 \Rightarrow`; or bounds what a statement begins
/// with by a number, `R_0 = \frac{\beta}{\gamma} > 1`.
fn is_condition(statement: &Statement, judged: &Judged) -> bool {
    let formula = &judged.goal.formula;
    let names = |own: &Goal| matches!(own.formula.as_equation(), Some((Expr::Symbol(_), _)));
    let is_number = |own: &&Expr| matches!(own, Expr::Number(_));
    if formula.is_inequality()
        && formula.terms().get(1).is_some_and(is_number)
        && first_goal(statement).as_ref().is_some_and(names)
    {
        return true;
    }
    let sides = formula.as_equation();
    let is_nought = sides.is_some_and(|(_, right)| *right == Expr::integer(0));
    is_nought && judged.goal.clause + 1 < statement.clauses.len()
}

/// Whether all that a link is said to follow from gives names to several terms, and none of these names is in the link: nothing follows from
/// that but what is so anyway, "Differentiating (1) and (2), the slopes at the knot are equal where".
fn only_names(judged: &Judged) -> bool {
    let goal = judged.goal.formula.names();
    let mut left: Vec<&Formula> = judged.assumed.iter().map(|own| &*own.formula).collect();
    left.retain(|own| own.as_equation().is_some());
    let several = left.len() > 1;
    loop {
        let is_name = |at: usize| {
            let others = left.iter().enumerate().filter(|own| own.0 != at);
            let is_new = |own: &Symbol, term: &Expr| {
                let mut others = others.clone();
                !goal.contains(own)
                    && !term.mentions(own)
                    && !others.any(|(_, other)| other.names().contains(own))
            };
            match left[at].as_equation() {
                Some((Expr::Symbol(own), term) | (term, Expr::Symbol(own))) => is_new(own, term),
                _ => false,
            }
        };
        match (0..left.len()).find(|&at| is_name(at)) {
            Some(at) => drop(left.swap_remove(at)),
            None => return left.is_empty() && several,
        }
    }
}

/// Whether equations that were named speak of all that a link does.
fn is_spoken_of(judged: &Judged) -> bool {
    let all = judged.assumed.iter();
    let said_of = Formula::applied_in(all.clone().flat_map(|own| own.formula.terms()));
    let said = all.filter(|own| matches!(own.source, Source::Equation(_)));
    let said: Set<Symbol> = said.flat_map(|own| own.formula.names()).collect();
    // By what is differentiated is clear.
    let terms = judged.goal.formula.terms();
    let is_variable = |own: &Symbol| {
        let binds = |part: &Expr| part.binder().is_some_and(|bound| bound == own);
        terms.iter().any(|term| term.any(&binds))
    };
    let mut names = judged.goal.formula.names();
    names.retain(|own| !said.contains(own));
    names.iter().all(is_variable)
        && Formula::applied_in(judged.goal.formula.terms()).is_subset(&said_of)
}

/// Whether a link is said of numbers, or of the same symbols on both sides, or works something out: what would have to be said besides of
/// those would be a condition.
fn is_closed(judged: &Judged) -> bool {
    let Formula::Relation {
        left,
        relation,
        right,
    } = &judged.goal.formula
    else {
        return true;
    };
    // `x = 2 x` says that it is 0, where `x > 2 x` is said of all.
    let bare = |side: &Expr| matches!(side, Expr::Symbol(_)) && *relation == Relation::Equal;
    let (own, other): (Set<Symbol>, Set<Symbol>) = (quantities(left), quantities(right));
    let known = known(judged);
    let is_known = |symbol: &Symbol| known.contains(symbol);
    // `x = 1 \iff x^2 = 1`
    let suppositions = judged.goal.suppositions.iter();
    let supposed = Formula::names_in(suppositions.flat_map(Formula::terms));
    if !supposed.is_empty() && supposed == judged.goal.formula.names() {
        return true;
    }
    // `k \geq 1` is about what `k` may be.
    let is_bound =
        |side: &Expr| matches!(side, Expr::Symbol(_)) && judged.goal.formula.is_inequality();
    match (own.is_empty(), other.is_empty()) {
        (true, true) => true,
        (true, false) | (false, true)
            if (is_bound(left) || is_bound(right)) && !has_units(left) && !has_units(right) =>
        {
            true
        }
        (true, false) => other.iter().all(is_known),
        (false, true) => own.iter().all(is_known),
        (false, false) => {
            !bare(left) && !bare(right) && own == other
                || works_out(left) && other.is_subset(&own)
                || works_out(right) && own.is_subset(&other)
        }
    }
}

/// The symbols of which premises say what numbers they are, one by another.
fn known(judged: &Judged) -> Set<Symbol> {
    let said = judged.assumed.iter().filter_map(|own| {
        let (left, right) = own.formula.as_equation()?;
        match left {
            Expr::Symbol(symbol) => Some((symbol.clone(), quantities(right))),
            _ => None,
        }
    });
    let said: Vec<(Symbol, Set<Symbol>)> = said.collect();
    let mut known = Set::new();
    loop {
        let is_next = |(own, of): &&(Symbol, Set<Symbol>)| {
            !known.contains(own) && of.iter().all(|other| known.contains(other))
        };
        let Some((next, _)) = said.iter().find(is_next) else {
            return known;
        };
        known.insert(next.clone());
    }
}

/// Whether a term is a sum, a limit, an integral or a slope of something that is written out.
fn works_out(term: &Expr) -> bool {
    let body = match term {
        Expr::Series { .. } | Expr::Integral { .. } => return true,
        Expr::Limit { body, .. } | Expr::Derivative { body, .. } => body,
        _ => return false,
    };
    !matches!(
        **body,
        Expr::Symbol(_) | Expr::Apply(..) | Expr::Derivative { .. }
    )
}
