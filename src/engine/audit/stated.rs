//! Laws and data in the middle of a text. Where nothing is declared, words are all there is to tell a law from a step: what
//! cites nothing, is introduced by no word that draws a conclusion and speaks of something new is no step that fails.
//!
//! Nor is anything said of most constants: what is differentiated nowhere is meant not to change.
//!
//! What is so taken is told. An equation that contradicts what stands before, or is one slip of the pen away from what
//! follows, still fails.

use crate::algebra::{Expr, Formula, LimitPoint, Relation, Symbol};
use crate::derivation::{Assumed, Equation, Goal, Kind, Source, is_put};
use crate::document::Extent;
use crate::kernel::Standing;
use crate::notation::measured;
use crate::search;

use super::judge::{Judge, step};
use super::{Entry, Judged, Note, Outcome, Verdict, identity, numeric};
use crate::sorted::Set;

impl Judge<'_> {
    /// Whether a side is the slope of something that a premise gives by a term in the variable.
    fn is_slope_of_given(&self, side: &Expr) -> bool {
        let side = match side {
            Expr::Limit { body, .. } => body,
            side => side,
        };
        let Expr::Derivative { body, variable } = side else {
            return false;
        };
        let mut body = &**body;
        // `\frac{d^2 R}{dr^2}`, where `R` is given or its slope is.
        let mut bodies = vec![body];
        while let Expr::Derivative { body: inner, .. } = body {
            body = inner;
            bodies.push(body);
        }
        let gives = |own: &Assumed| match own.formula.as_equation() {
            Some((left, right)) => {
                bodies.contains(&left)
                    && right.mentions(variable)
                    && !right.any(&|part| part == body)
            }
            None => false,
        };
        matches!(body, Expr::Symbol(_) | Expr::Apply(..)) && self.usable.assumed.iter().any(gives)
    }

    /// Whether a side is the value at a place of something that a premise gives by a term, in which all that it is said to be made of stands.
    /// What brings in something else, `y(0) = y_0`, may be a condition.
    fn is_value_of_given(&self, side: &Expr, others: &Set<Symbol>) -> bool {
        let Expr::Limit {
            body,
            variable,
            point: LimitPoint::Finite(place),
        } = side
        else {
            return false;
        };
        // The place is a value of the variable: `\tau(a) = a P/(2 L)`.
        let place = quantities(place);
        let others: Set<Symbol> = others.difference(&place).cloned().collect();
        if others.is_empty() {
            return false;
        }
        let [sound, _] = self.others(&[]);
        let open = self.open_before(&[]);
        let known = || self.usable.assumed.iter().chain(sound).chain(&open);
        let given = |of: &Expr| -> Vec<&Expr> {
            let values = known().filter_map(|own| own.formula.as_equation());
            let values = values.filter(|(left, _)| *left == of);
            values.map(|(_, value)| value).collect()
        };
        // What it is made of may be said by others: `s(b)` of `s = A + \frac{B}{r^2}`, where `A` and `B` are known in `a` and `b`.
        let is_made_of_these = |value: &&Expr| {
            let mut made_of = quantities(value);
            for own in quantities(value) {
                let parts = given(&Expr::Symbol(own)).into_iter();
                made_of.extend(parts.flat_map(quantities));
            }
            value.mentions(variable) && others.is_subset(&made_of)
        };
        given(body).iter().any(is_made_of_these)
    }

    /// What a statement that is not proved speaks of first, or says how great it is, if it may be stated rather than derived.
    pub(super) fn stated(&self, entry: &Entry) -> Option<Vec<Symbol>> {
        let equation = &self.derivation.equations[self.at];
        // `E = T + V = \text{const}` defines and says of what it defines that it does not change.
        let defines = |judged: &&Judged| matches!(judged.outcome, Outcome::Defined);
        // "At the top $v = u - g t = 0$" says what follows, and that it has that value there.
        let momentary = matches!(equation.extent, Extent::Moment | Extent::Condition);
        let settled = |judged: &&Judged| defines(judged) || momentary && judged.outcome.is_proven();
        let defined = entry.judged.iter().take_while(settled).count();
        let [judged, rest @ ..] = &entry.judged[defined..] else {
            return None;
        };
        // "Momentum is conserved: $n v_0 = u_1 + \dots + u_k = \sum_i u_i$" goes on with what is so anyway.
        // So does `E = E_c - E_a = 0.34\,\mathrm{V} + 0.76\,\mathrm{V}`, and says how great these are.
        let goes_on = |own: &Judged| {
            let open = matches!(own.outcome, Outcome::Open(_) | Outcome::Refuted(_));
            own.outcome.is_proven() || open && numeric::is_measured(&own.goal)
        };
        if !rest.iter().all(goes_on) {
            return None;
        }
        // `\eta = E_2 / E_0 = m_2 w^2 / (m_1 v^2)` says what `E_2` is as well.
        let brings_more = || self.brings_by_the_way(&judged.goal.formula);
        let is_constant = || self.some_constant(&judged.goal, &[]).is_some();
        if defined > 0 && !momentary && !is_constant() && !brings_more() {
            return None;
        }
        if !equation.uncited {
            return None;
        }
        // What a law gives that stands on the page follows from what stands there.
        let is_value = matches!(
            judged.goal.formula.as_equation(),
            Some((Expr::Symbol(_), _))
        );
        if equation.law_stands && equation.introduces.is_empty() && is_value {
            return None;
        }
        // What comes of an approximation is no law.
        if !self.approximations().is_empty() {
            return None;
        }
        // What could not be read may speak of all of it.
        if !self.usable.unreadable.is_empty() {
            return None;
        }
        if self.beyond(&judged.goal).is_some() {
            return None;
        }
        // Nor is what a law that it is said to solve rules out.
        if judged.outcome.is_refuted() && judged.solution().is_some() {
            return None;
        }
        // Nor is what laws say of particular things.
        if self.is_of_instances(&judged.goal) {
            return None;
        }
        let (goal, outcome) = (judged.goal.clone(), &judged.outcome);
        let Formula::Relation {
            left,
            relation,
            right,
        } = &goal.formula
        else {
            return None;
        };
        // What is not proved of something new can hardly follow from what does not speak of it.
        let silent = !self.derivation.pages[equation.page].directs;
        let scales = matches!(outcome, Outcome::ScalesNot(..))
            || matches!(relation, Relation::Scales | Relation::Proportional);
        let is_open = match outcome {
            // Which scales as which is said of nothing else.
            Outcome::ScalesNot(..) => equation.bare && silent,
            outcome => matches!(outcome, Outcome::Refuted(_) | Outcome::Open(_)),
        };
        if !is_open || !goal.is_said_outright() {
            return None;
        }
        // Of an identity both sides speak of the same.
        let (named, others) = (quantities(left), quantities(right));
        // What is put has that value at that moment alone: that it is near what follows in general is no slip.
        let (told, usable) = (self.derivation.told(self.at), self.usable);
        let is_new = |symbol: &Symbol| {
            let own = |a: &&Assumed| !a.source.is_of_statement();
            let before = usable.assumed.iter().filter(own);
            let mut before = told.iter().chain(before);
            // "where $0 \le t < 1$" says nothing more of it.
            let speaks = |own: &Formula| {
                let is_bound = own.as_equation().is_none() && own.names().len() == 1;
                !is_bound && own.terms().iter().any(|term| term.mentions(symbol))
            };
            equation.introduces.contains(symbol) && !before.any(|a| speaks(&a.formula))
        };
        let has_value = momentary && (others.is_empty() || others.iter().any(is_new));
        let put = has_value || is_put(right, equation.extent);
        // That a measured value does not go with what is wrong itself is no slip.
        let is_number = matches!(left, Expr::Symbol(_)) && others.is_empty();
        let is_otherwise = || put && is_otherwise(entry, &others);
        let is_slip =
            || (is_slip(entry) || is_otherwise()) && !(is_number && self.draws_on_failing(judged));
        if !has_value && is_slip() || !put && !entry.missing.is_empty() {
            return None;
        }
        let symbols: Vec<Symbol> = match left {
            Expr::Symbol(symbol) if *relation == Relation::Equal && others.is_empty() => {
                vec![symbol.clone()]
            }
            _ if named == others => return None,
            // A limit of what is written out could not be otherwise; nor could the slope of what the page gives by a term, in what is known.
            _ if identity::is_carried_out(left, right, equation.drawn) => return None,
            // Nor could the value at a place of what the page gives by a term in just what it is said to be made of.
            _ if self.is_value_of_given(left, &others) => return None,
            // That it is 0 is a condition.
            _ if self.is_slope_of_given(left)
                && !others.is_empty()
                && !others.iter().any(is_new) =>
            {
                return None;
            }
            _ => {
                let all = named.union(&others);
                let domains = &self.derivation.pages[equation.page].domains;
                let counts = |s: &Symbol| domains.get(s).is_some_and(|domain| domain.integer);
                all.filter(|s| is_new(s) && !counts(s)).cloned().collect()
            }
        };
        // What is said to follow may bring in something new, and cannot follow then. A second law may speak of nothing new, where nobody
        // could have said that it is one; a value of something known is none, if no reason is given that is no equation.
        let is_law = || {
            equation.reasons
                || equation.is_law
                || silent && (scales || !matches!(left, Expr::Symbol(_)))
        };
        // "For a solid cylinder the moment of inertia is": of what nobody has said anything else.
        let is_case = silent && equation.extent == Extent::Circumstances && !self.is_explicit(left);
        // A value in what nobody has spoken of is a second law: "If a column is connected, then $F = m g h$".
        let in_others = !equation.drawn && !others.is_empty() && others.iter().all(is_new);
        let is_value = matches!(left, Expr::Symbol(symbol) if !is_new(symbol)) && !in_others;
        let brings = !is_value && symbols.iter().any(is_new);
        let throughout = equation.extent == Extent::Throughout;
        let is_elsewhere =
            || silent && throughout && !equation.drawn && self.is_of_another_section(judged);
        let may_be_law = || {
            let meant = equation.meant || !symbols.is_empty() || put;
            meant || is_law() || is_case || is_elsewhere()
        };
        let is_meaning = || matches!(left, Expr::Symbol(own) if self.goes_on_with_meaning(own));
        if !(brings || equation.bare && may_be_law() || is_meaning()) {
            return None;
        }
        // Another circuit has another output, in the same quantities.
        if matches!(outcome, Outcome::Refuted(_))
            && !is_elsewhere()
            && self.is_evaluation(left, &others)
        {
            return None;
        }
        // How something changes of which is known what it is follows from that.
        let mut slope = left;
        while let Expr::Derivative { body, .. } = slope {
            if !has_value && self.is_explicit(body) {
                return None;
            }
            slope = body;
        }
        // What is wrong itself contradicts others already.
        let [sound, _] = self.others(&[]);
        let right = |a: &&Assumed| match a.source {
            Source::Equation(premise) => {
                let premise = Set::from([premise]);
                self.auditor.failing(self.at, &premise).is_empty()
            }
            _ => true,
        };
        let own = self.usable.assumed.iter().filter(right);
        let mut all: Vec<Assumed> = own.cloned().collect();
        all.extend(sound.iter().cloned());
        all.push(step(&goal.formula));
        let named = symbols.into_iter();
        let named = named.filter(|symbol| !self.derivation.is_some_constant(symbol));
        let named = named.collect();
        let is_step = equation.drawn || equation.reasons;
        let is_step = is_step && equation.extent == Extent::Throughout;
        let is_out =
            is_step && (self.leaves_nothing(&all, &goal) || self.gives_otherwise(&all, &goal));
        (!is_out && !self.is_contradictory(&all, &goal)).then_some(named)
    }

    /// Whether the words before the display go on with what symbols of the display before mean, of which that is the first to speak:
    /// "where for unit width $$I = \frac{a^3}{12}$$".
    fn goes_on_with_meaning(&self, symbol: &Symbol) -> bool {
        let leading = self.derivation.leading(self.at).unwrap_or_default();
        let rest = leading.trim_start().strip_prefix("where");
        let begins = rest.is_some_and(|rest| !rest.starts_with(char::is_alphanumeric));
        let before = begins.then(|| self.derivation.before_display(self.at));
        before.flatten().is_some_and(|before| {
            let own = &self.derivation.equations[before];
            own.introduces.contains(symbol)
        })
    }

    /// Whether all equations that a link was judged from stand in sections before: another circuit has another output.
    fn is_of_another_section(&self, judged: &Judged) -> bool {
        let start = self.derivation.section_start(self.at);
        let mut from = judged.assumed.iter().filter_map(|own| match own.source {
            Source::Equation(premise) => Some(premise),
            _ => None,
        });
        self.at == start && from.all(|premise| premise < start)
    }

    /// Whether a link was refuted from what fails itself.
    fn draws_on_failing(&self, judged: &Judged) -> bool {
        let mut assumed = judged.assumed.iter();
        assumed.any(|own| match own.source {
            Source::Equation(premise) => {
                let premise = Set::from([premise]);
                !self.auditor.failing(self.at, &premise).is_empty()
            }
            _ => false,
        })
    }

    /// Whether what stands before says what the symbol is that a step gives a value of, by a term in just the same symbols: another value
    /// is no second law, whatever reason words give for it.
    fn gives_otherwise(&self, all: &[Assumed], goal: &Goal) -> bool {
        let Some((Expr::Symbol(_), value)) = goal.formula.as_equation() else {
            return false;
        };
        let [before @ .., _] = all else {
            return false;
        };
        let posed = self.pose(before, &goal.formula).ok();
        let implied = posed.as_deref().and_then(search::implied);
        let implied = implied
            .as_ref()
            .and_then(|own| own.proven.claim().goal.as_equation());
        implied.is_some_and(|(_, own)| quantities(own) == quantities(value))
    }

    /// Whether a law of which words draw the step leaves hardly anything of what stands before: `w = m v/(m + 2 M)` beside
    /// `m v = (m + M) w`, which both are so where nothing moves.
    fn leaves_nothing(&self, all: &[Assumed], goal: &Goal) -> bool {
        goal.formula.as_equation().is_some()
            && (self.pose(all, &goal.formula)).is_ok_and(|posed| search::makes_goal_vanish(&posed))
    }
}

impl Judge<'_> {
    /// Whether the display is the first to speak of something on the left of a link alone.
    fn brings_by_the_way(&self, link: &Formula) -> bool {
        let introduced = &self.derivation.equations[self.at].introduces;
        let Some((left, right)) = link.as_equation() else {
            return false;
        };
        let (left, right) = (quantities(left), quantities(right));
        let new = left.iter();
        let mut new = new.filter(|&own| introduced.contains(own) && !right.contains(own));
        // "A ball of moment of inertia $I = \frac25 m R^2$" has said what it is.
        let is_told = |own: &Symbol| {
            let told = self.derivation.told(self.at);
            told.iter().any(|a| a.formula.names().contains(own))
        };
        new.any(|own| !is_told(own))
    }

    /// What to say of a definition that words before it announce as a step, and of which nothing before says that it is one.
    pub(super) fn unchecked(&self, entry: &Entry) -> Option<Note> {
        let equation = &self.derivation.equations[self.at];
        let [judged] = &entry.judged[..] else {
            return None;
        };
        let (Expr::Symbol(symbol) | Expr::Apply(symbol, _), value) =
            judged.goal.formula.as_equation()?
        else {
            return None;
        };
        // What goes on with the name in the same display defines it.
        let alone = equation.statements().len() == 1;
        let named = quantities(value);
        if !equation.drawn || !alone || named.is_empty() {
            return None;
        }
        Some(Note::TakenAsGiven(vec![symbol.clone()]))
    }

    /// The same of what is cited for a chain, and used for none of it that is proved: only what defines something can be drawn from it.
    /// "By (1), `u = \sqrt{g h} = 2 \sqrt{g R}`."
    pub(super) fn begins_unchecked(&self, entry: &Entry) -> Option<Note> {
        let equation = &self.derivation.equations[self.at];
        let [first, _, ..] = &entry.judged[..] else {
            return None;
        };
        let (left, value) = first.goal.formula.as_equation()?;
        let new = quantities(left).into_iter();
        let new: Vec<Symbol> = new
            .filter(|own| equation.introduces.contains(own))
            .collect();
        let is_defined = matches!(first.outcome, Outcome::Defined) && !quantities(value).is_empty();
        (self.names_its_premises() && equation.drawn && is_defined && !new.is_empty())
            .then_some(Note::TakenAsGiven(new))
    }

    /// Whether a step only says how great something is: all that is on its left is known in just what is on its right. "`P_1 - 2 P_2 = `",
    /// where both are known in `a`, `b` and `c`.
    fn is_evaluation(&self, left: &Expr, others: &Set<Symbol>) -> bool {
        let [sound, _] = self.others(&[]);
        let known = || self.usable.assumed.iter().chain(sound);
        let mut given_in = Set::new();
        for symbol in quantities(left) {
            let gives = |own: &Assumed| match own.formula.as_equation()? {
                (Expr::Symbol(own), value) if *own == symbol && !value.mentions(&symbol) => {
                    Some(quantities(value)).filter(|own| !own.is_empty())
                }
                _ => None,
            };
            let mut values = known().filter_map(gives);
            match values.find(|own| own.is_subset(others)) {
                Some(own) => given_in.extend(own),
                None => return false,
            }
        }
        !others.is_empty() && given_in == *others
    }

    /// Whether an equation that stands before says what a term is.
    fn is_explicit(&self, term: &Expr) -> bool {
        let [sound, _] = self.others(&[]);
        let mut known = self.usable.assumed.iter().chain(sound);
        known.any(|assumed| {
            let sides = assumed.formula.as_equation();
            sides.is_some_and(|(left, right)| left == term && !matches!(right, Expr::Number(_)))
        })
    }
}

/// Whether a condition says that something does not change.
pub(super) fn stands_still(condition: &Formula) -> bool {
    let sides = condition.as_equation();
    matches!(sides, Some((Expr::Derivative { .. }, Expr::Number(_))))
}

/// The symbols that a proof takes as constant by conditions that say so.
///
/// Something must be left that moves, and of which the premises or the goal speak: where everything stands still that an energy is
/// made of, that it is conserved says nothing.
pub(super) fn constants(judged: &Judged, conditions: &[Formula]) -> Option<Vec<Symbol>> {
    if conditions.is_empty() || !judged.outcome.is_proven() {
        return None;
    }
    let mut variables = Set::new();
    let mut constants = Vec::new();
    for condition in conditions {
        let (slope, zero) = condition.as_equation()?;
        let (Expr::Derivative { body, variable }, Expr::Number(_)) = (slope, zero) else {
            return None;
        };
        let held = match &**body {
            Expr::Symbol(symbol) => vec![symbol.clone()],
            // A slope of a slope.
            Expr::Derivative { body, .. } if let Expr::Symbol(symbol) = &**body => {
                vec![symbol.clone()]
            }
            body @ Expr::Series { .. } => elements(body),
            _ => return None,
        };
        variables.insert(variable.clone());
        for symbol in held {
            if !constants.contains(&symbol) {
                constants.push(symbol);
            }
        }
    }
    let assumed = judged.assumed.iter().map(|a| &*a.formula);
    let said: Vec<&Formula> = assumed
        .filter(|f| !conditions.contains(f))
        .chain([&judged.goal.formula])
        .collect();
    let mut moving = variables;
    moving.extend(Formula::differentiated_in(said.iter().copied()));
    // At one moment something may have a value and move all the same.
    let at_moment = |a: &Assumed| a.standing == Standing::AtPoint && !a.source.is_of_statement();
    let is_law = |formula: &&&Formula| {
        **formula != &judged.goal.formula || !judged.assumed.iter().any(at_moment)
    };
    for formula in said.iter().filter(is_law) {
        if let Some((Expr::Symbol(symbol), _)) = formula.as_equation() {
            moving.remove(symbol);
        }
    }
    let mut terms = said.iter().flat_map(|f| f.terms());
    let moves = terms.any(|term| moving.iter().any(|symbol| stands(term, symbol)));
    moves.then_some(constants)
}

/// The elements that a term speaks of, as the author names them: `x_i`.
fn elements(term: &Expr) -> Vec<Symbol> {
    match term {
        Expr::Element { sequence, index } => vec![Symbol::new(format!("{sequence}_{index}"))],
        _ => term.children().flat_map(elements).collect(),
    }
}

/// Whether a symbol stands in a term by itself, not only with its derivative.
fn stands(term: &Expr, symbol: &Symbol) -> bool {
    match term {
        Expr::Symbol(own) => own == symbol,
        // What is integrated over moves, whether the integrand speaks of it or not.
        Expr::Integral { variable, .. } if variable == symbol => true,
        Expr::Derivative { body, .. } if matches!(**body, Expr::Symbol(_)) => false,
        _ => term.children().any(|child| stands(child, symbol)),
    }
}

/// Whether one edit makes it follow from what is said.
pub(super) fn is_slip(entry: &Entry) -> bool {
    let mended = entry.mended.as_ref();
    mended.is_some_and(|mended| mended.under.is_empty())
}

/// Whether something else follows that is made of the same symbols: what is put at a place, `V = v/4`, is another value there then.
fn is_otherwise(entry: &Entry, named: &Set<Symbol>) -> bool {
    let implied = entry.implied.as_ref().map(|own| &own.proven.claim().goal);
    let value = implied.and_then(|goal| Some(goal.as_equation()?.1));
    !named.is_empty() && value.is_some_and(|value| quantities(value) == *named)
}

/// Whether what a page begins with goes on with something false: a link whose sides speak of the same (`A = \pi r^2 = 2 \pi r`), what
/// is implied, or another value of a symbol that is not new, unless that is a condition. A law may go on with another,
/// `p V = n R T = N k T`. Of a row that goes on with others the first link is no beginning.
pub(super) fn slips(entry: &Entry, equation: &Equation) -> bool {
    let (new, before) = (&equation.introduces, equation.continues);
    let is_condition = equation.extent == Extent::Condition;
    let first = entry.judged.first().map(|judged| judged.goal.clause);
    let mut refuted = (entry.judged.iter().enumerate()).filter(|(_, j)| j.outcome.is_refuted());
    refuted.any(|(link, judged)| {
        let Formula::Relation { left, right, .. } = &judged.goal.formula else {
            return false;
        };
        let (named, others) = (quantities(left), quantities(right));
        let again = matches!(left, Expr::Symbol(symbol) if !new.contains(symbol));
        match link + before {
            // Who calls it an identity claims that it is so for all values.
            0 if equation.drawn && !named.is_empty() && named == others => true,
            0 => again && !others.is_empty() && !is_condition,
            _ => first != Some(judged.goal.clause) || !named.is_empty() && named == others,
        }
    })
}

/// "It is largest when $\frac{dG}{dN} = a - b N = 0$": that it is 0 there is a condition, and cannot be false where what it is put for is left
/// open. Of a slope by anything but time, `\frac{dR}{dr} = a - b/r^2 = 0`, it is one without words: nobody says of a term in a display that
/// it vanishes for all values and leaves it standing.
pub(super) fn leave_condition(entry: &mut Entry, equation: &Equation) {
    let Some((last, before)) = entry.judged.split_last_mut() else {
        return;
    };
    let is_open = |judged: &Judged| matches!(judged.outcome, Outcome::Open(_));
    let (is_refuted, is_shown) = (last.outcome.is_refuted(), last.outcome.is_proven());
    let ends_in_a_number = {
        let sides = last.goal.formula.as_equation();
        sides.is_some_and(|(_, right)| matches!(right, Expr::Number(_)))
    };
    if !ends_in_a_number || is_shown || before.iter().any(|own| own.outcome.is_refuted()) {
        return;
    }
    // What another clause says, `\Rightarrow y = 0`, is no end of the chain that begins with the slope.
    let is_of_slope = || {
        let clause = last.goal.clause;
        let mut before = before.iter();
        before
            .next()
            .is_some_and(|first| first.goal.clause == clause)
            && before.all(|own| own.goal.clause == clause)
            && equation.puts_to_nought(&last.goal.formula)
    };
    last.outcome = match before.iter().any(is_open) {
        true if equation.extent == Extent::Condition && is_refuted => {
            Outcome::open("it is a condition, and what it is one of is left open")
        }
        // "The condition is transcendental": of what is put to nought, words alone have told.
        false
            if before.is_empty()
                && equation.told_extent == Extent::Condition
                && is_refuted
                && entry.mended.is_none()
                && !matches!(last.goal.formula.terms()[0], Expr::Symbol(_)) =>
        {
            Outcome::open("it is a condition, and nothing before says what vanishes there")
        }
        false if is_of_slope() => {
            last.assumed.clear();
            Outcome::Stated
        }
        _ => return,
    };
    entry.implied = None;
    entry.mended = None;
    entry.missing.clear();
}

/// What a page begins with is given, as far as it is not concluded in the display itself.
pub(super) fn begin(entry: &mut Entry) {
    let goes_on = entry.judged.len() > 1;
    let Some(first) = entry.judged.first_mut().filter(|_| goes_on) else {
        return;
    };
    if !first.outcome.is_proven() && !matches!(first.outcome, Outcome::Defined) {
        first.outcome = Outcome::Stated;
        first.assumed.clear();
        entry.verdict = super::entry::verdict(&entry.judged);
    }
}

/// The symbols of a term that are no units.
pub(super) fn quantities(term: &Expr) -> Set<Symbol> {
    let mut symbols = term.free_symbols();
    symbols.retain(|symbol| measured(symbol).is_none());
    symbols
}

/// The entry of a statement that is taken as given; what it goes on with has been proved.
pub(super) fn given(mut entry: Entry, symbols: Vec<Symbol>) -> Entry {
    let is_open = |judged: &Judged| !judged.outcome.is_proven();
    let stated = entry.judged.iter().rposition(is_open);
    for judged in &mut entry.judged[..=stated.unwrap_or_default()] {
        judged.assumed.clear();
        judged.outcome = Outcome::Stated;
    }
    (entry.kind, entry.verdict) = (Kind::Given, Verdict::Given);
    (entry.implied, entry.mended) = (None, None);
    entry.missing.clear();
    entry.notes = vec![Note::TakenAsGiven(symbols)];
    entry
}
