use std::sync::Arc;

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{
    Approach, Assumed, Beyond, Derivation, Goal, Kind, Local, Page, Running, Source, conditions,
    formulas, goals, is_open,
};
use crate::kernel::Standing;
use crate::notation::{Connective, Mark, Statement};

use super::{Entry, Judged, Note, Outcome, Verdict};
use crate::sorted::Set;

/// What an equation offers to those that cite it.
#[derive(Clone, Debug, Default)]
pub struct Offer {
    /// What it states.
    pub formulas: Vec<Arc<Formula>>,
    /// What it states under conditions.
    pub cases: Vec<(Vec<Formula>, Arc<Formula>)>,
    /// The local hypotheses that its derivation used, itself or through its premises: page and position.
    pub under: Set<(usize, usize)>,
    /// Which formulas, by position, are true for every value of an index that runs on the page.
    pub throughout: Set<(usize, Symbol)>,
    /// Part of it is supported by figures, or not: that proves nothing, and is not offered.
    pub is_numeric: bool,
    /// It is said of a limit, and nothing but the limit is offered.
    pub in_limit: bool,
}

impl Offer {
    /// What is offered by an equation that is given.
    pub fn given(derivation: &Derivation, at: usize) -> Offer {
        let mut offer = Offer {
            under: own_moments(derivation, at),
            ..Offer::default()
        };
        for statement in derivation.equations[at].statements() {
            let own = formulas(statement).into_iter().map(Arc::new);
            match statement.under.is_empty() {
                true => offer.formulas.extend(own),
                false => (offer.cases).extend(own.map(|own| (conditions(statement), own))),
            }
        }
        for running in derivation.running(derivation.equations[at].page) {
            for (position, formula) in offer.formulas.iter().enumerate() {
                if derivation.is_given_throughout(at, formula, running) {
                    let index = running.index.clone();
                    offer.throughout.insert((position, index));
                }
            }
        }
        offer
    }

    /// Whether a formula that is offered is true for every value of an index.
    pub fn is_throughout(&self, formula: &Formula, index: &Symbol) -> bool {
        let mut positions = self.throughout.iter().filter(|(_, own)| own == index);
        positions.any(|(position, _)| {
            let own = self.formulas.get(*position);
            own.is_some_and(|own| **own == *formula)
        })
    }

    /// What is offered by an equation once judged: all that it asserts, be it true or not. What it only
    /// asks, or crosses out, counts once it is proved; an equivalence asserts neither side.
    pub fn judged<'a>(
        derivation: &Derivation,
        at: usize,
        entries: &[Entry],
        offers: impl Fn(usize) -> Option<&'a Offer>,
    ) -> Offer {
        let mut offer = Offer {
            under: own_moments(derivation, at),
            ..Offer::default()
        };
        let weighed =
            |entry: &Entry| entry.numeric.is_some() && entry.verdict == Verdict::Undecided;
        offer.is_numeric = entries.iter().any(weighed);
        for (statement, entry) in derivation.equations[at].statements().iter().zip(entries) {
            if statement
                .connectives
                .iter()
                .any(|c| c.value == Connective::Equivalent)
            {
                continue;
            }
            let crossed = statement
                .mark
                .as_ref()
                .is_some_and(|m| m.value == Mark::Cross);
            for judged in &entry.judged {
                let proven = judged.outcome.is_proven();
                // What figures support is no premise.
                let is_exact = proven || matches!(judged.outcome, Outcome::Defined);
                if weighed(entry) && !is_exact || judged.is_expanded() {
                    continue;
                }
                // What is so in a limit is so at no point.
                let is_limit = matches!(
                    judged.goal.formula.as_equation(),
                    Some((Expr::Limit { .. }, _))
                );
                let is_approached = |formula: &Formula| {
                    let all = derivation.approached(at);
                    !all.is_empty() && !names_value_there(derivation, at, formula, &all)
                };
                if (!proven || is_limit) && is_approached(&judged.goal.formula) {
                    offer.in_limit = true;
                    if !proven {
                        continue;
                    }
                }
                if proven || !(crossed || judged.goal.questioned) {
                    let own = match judged.outcome.is_refuted() {
                        true => offered(statement, judged).into(),
                        false => judged.goal.formula.clone().into(),
                    };
                    if statement.under.is_empty() {
                        let position = offer.formulas.len();
                        let all = throughout(derivation, at, entry, &offers).into_iter();
                        offer.throughout.extend(all.map(|index| (position, index)));
                        offer.formulas.push(own);
                    } else {
                        offer.cases.push((conditions(statement), own));
                    }
                }
                // What a new symbol names is so wherever that is spoken of: `P_m` is what `P` was there.
                let mut assumed = judged.assumed.iter();
                if assumed.any(|own| own.source == Source::Taken) {
                    continue;
                }
                for assumed in &judged.assumed {
                    match assumed.source {
                        Source::Local(page, local) => {
                            offer.under.insert((page, local));
                        }
                        Source::Equation(premise) => {
                            // Which case of it applied was known from the hypotheses in effect.
                            let mut said = derivation.equations[premise].statements().iter();
                            if said.any(|statement| !statement.under.is_empty()) {
                                let own = &derivation.equations[at];
                                let locals = own.locals.iter().map(|&local| (own.page, local));
                                offer.under.extend(locals);
                            }
                            let inherited = offers(premise);
                            offer.under.extend(inherited.iter().flat_map(|o| &o.under));
                        }
                        Source::Step | Source::Taken | Source::Propagation | Source::Nature => {}
                    }
                }
            }
        }
        offer
    }
}

/// Whether a display gives a new name to something that it says without what moves: "Barely escaping means $v_r \to 0$ as $r \to \infty$:
/// $$v_e = \sqrt{2 G M/R}$$" is so wherever `v_e` is spoken of.
fn names_value_there(
    derivation: &Derivation,
    at: usize,
    formula: &Formula,
    all: &[Approach],
) -> bool {
    let is_new = |side: &Expr| match side {
        Expr::Symbol(own) => derivation.equations[at].introduces.contains(own),
        _ => false,
    };
    let names = formula.names();
    formula.as_equation().is_some_and(|(left, _)| is_new(left))
        && !all.iter().any(|own| names.contains(&own.variable))
}

/// What an equation says of one moment alone is said under itself.
fn own_moments(derivation: &Derivation, at: usize) -> Set<(usize, usize)> {
    let own = &derivation.equations[at];
    own.moments.clone().map(|local| (own.page, local)).collect()
}

/// The running indices for every value of which a statement is shown: each link is proved, and from nothing that is
/// said of one value alone or may depend on it unseen. What is not proved is taken as it is written, as what is given is:
/// those who cite it are judged from it all the same.
fn throughout<'a>(
    derivation: &Derivation,
    at: usize,
    entry: &Entry,
    offers: &impl Fn(usize) -> Option<&'a Offer>,
) -> Vec<Symbol> {
    let conditional = |n: &Note| matches!(n, Note::UnstatedCondition(_));
    if entry.notes.iter().any(conditional) {
        return Vec::new();
    }
    let fine = |running: &&Running| {
        let said = |assumed: &Assumed| match assumed.source {
            Source::Step | Source::Taken | Source::Propagation | Source::Nature => {
                !running.ties(&assumed.formula) || entry.judged.len() > 1
            }
            Source::Local(..) => !running.ties(&assumed.formula),
            Source::Equation(premise) => {
                let offer = offers(premise);
                !running.ties(&assumed.formula)
                    || offer.is_some_and(|o| o.is_throughout(&assumed.formula, &running.index))
            }
        };
        entry.judged.iter().all(|judged| match &judged.outcome {
            outcome if outcome.is_proven() => judged.assumed.iter().all(said),
            _ => derivation.is_given_throughout(at, &judged.goal.formula, running),
        })
    };
    let running = derivation.running(derivation.equations[at].page).iter();
    running.filter(fine).map(|r| r.index.clone()).collect()
}

/// The premises that an equation may use, and those that it may not.
#[derive(Clone, Debug, Default)]
pub struct Usable {
    /// Hypotheses in order: local ones, then those of each premise.
    pub assumed: Vec<Assumed>,
    /// Hypotheses that premises offer under conditions.
    pub cases: Vec<(Vec<Formula>, Assumed)>,
    /// Premises that hold for particular values only, which are not in effect.
    pub out_of_scope: Vec<usize>,
    /// Premises that are derived later.
    pub later: Vec<usize>,
    /// Numeric claims: supported or not, they prove nothing.
    pub numeric: Vec<usize>,
    /// Premises that are said of a limit: what is meant by them may be more than what they offer.
    pub in_limit: Vec<usize>,
    /// Premises that could not be read.
    pub unreadable: Vec<usize>,
    /// Why some are left out: claims are exact, and about real numbers.
    pub beyond: Option<Beyond>,
    /// Some speak of partial derivatives of terms in which something may depend on the variable, and are left out: if they are laws, it does.
    pub has_presumed: bool,
}

/// Gathers the hypotheses that come with `premises` where equation `at` stands.
pub fn usable<'a>(
    derivation: &Derivation,
    offers: impl Fn(usize) -> Option<&'a Offer>,
    at: usize,
    premises: &[usize],
) -> Usable {
    let mut usable = Usable {
        assumed: derivation.locals(at),
        ..Usable::default()
    };
    let page = derivation.equations[at].page;
    let own = &derivation.equations[at];
    let in_effect = own.locals.iter().chain(&own.told).chain(&own.named);
    let in_effect: Set<(usize, usize)> = in_effect.map(|&local| (page, local)).collect();
    // A value that the text has given to another symbol's place since is no longer meant.
    let others = || {
        in_effect
            .iter()
            .map(|&(page, at)| derivation.local(page, at))
    };
    // That $k > 0$ is not taken back by $k = m \omega^2$.
    let replaced =
        |own: &Local| own.is_equation() && others().any(|other| own.is_replaced_by(other));
    let is_left_for_other = |own: &Local| others().any(|other| own.is_left_for(other));
    usable.assumed.retain(|own| match own.source {
        Source::Local(page, at) => !is_left_for_other(derivation.local(page, at)),
        _ => true,
    });
    let (_, named, _) = derivation.premises(at);
    let together: Vec<usize> = premises.iter().copied().chain([at]).collect();
    for &premise in premises {
        let equation = &derivation.equations[premise];
        if equation.statements.is_err() {
            usable.unreadable.push(premise);
            continue;
        }
        let offer = match offers(premise) {
            _ if equation.numeric.is_some() => {
                usable.numeric.push(premise);
                continue;
            }
            Some(offer) => offer.clone(),
            None if equation.kind == Kind::Given => Offer::given(derivation, premise),
            None => {
                usable.later.push(premise);
                continue;
            }
        };
        if offer.is_numeric {
            usable.numeric.push(premise);
        }
        if offer.in_limit {
            usable.in_limit.push(premise);
        }
        let is_left = |place: &(usize, usize)| {
            let local = derivation.local(place.0, place.1);
            // "For the disc, with moment of inertia $I = M R^2/2$," tells what a new symbol means, and no case.
            let is_case = match local.is_told && local.means {
                true => replaced(local) || derivation.is_left_in_words(at, *place),
                false => local.is_let || local.is_case() || local.is_told && replaced(local),
            };
            let is_over = !in_effect.contains(place) || is_left_for_other(local);
            let is_case = is_case
                || local.is_left_by(true) && derivation.is_left_in_words(at, *place)
                || others().any(|other| local.is_another_case_than(other));
            is_case && !local.is_momentary() && is_over
                || !named && derivation.is_beyond(at, *place)
        };
        if offer.under.iter().any(is_left) {
            usable.out_of_scope.push(premise);
            continue;
        }
        // An assumption is carried along by what was concluded under it.
        let mut standing = derivation.standing_among(premise, &together);
        let mut carried = Vec::new();
        for &(page, local) in &offer.under {
            for formula in &derivation.local(page, local).formulas {
                let own =
                    derivation.pages[page].standing_of(derivation.local(page, local), formula);
                // What explains a symbol is meant throughout, as a definition is.
                if !is_open(formula) && !equation.explains && own == Standing::AtPoint {
                    standing = own;
                }
                // What was so at one moment is said of that moment alone, be what was concluded from it used elsewhere.
                if derivation.local(page, local).is_passing() {
                    continue;
                }
                carried.push(Assumed {
                    formula: formula.clone(),
                    standing: own,
                    source: Source::Local(page, local),
                });
            }
        }
        let case = |(conditions, formula)| {
            let assumed = Assumed {
                formula,
                standing: Standing::AtPoint,
                source: Source::Equation(premise),
            };
            (conditions, assumed)
        };
        usable.cases.extend(offer.cases.into_iter().map(case));
        let stated = offer.formulas.into_iter().map(|formula| Assumed {
            standing: match equation.puts_to_nought(&formula) {
                true => Standing::AtPoint,
                false => standing,
            },
            formula,
            source: Source::Equation(premise),
        });
        let values = derivation.values_of_function(premise, &together);
        let values = values.into_iter().map(|formula| Assumed {
            formula: formula.into(),
            standing,
            source: Source::Equation(premise),
        });
        // What was concluded says more of the same symbol than what it was concluded from.
        for assumed in stated.chain(values).chain(carried) {
            if !usable.assumed.contains(&assumed) {
                usable.assumed.push(assumed);
            }
        }
    }
    let page = &derivation.pages[page];
    if !page.dependent.is_empty() {
        add_formulas(&mut usable.assumed, &page.dependent);
    }
    if !page.presumed_slopes.is_empty() {
        let is_presumed = |part: &Expr| page.presumed_slopes.contains(part);
        let speaks = |own: &Assumed| own.formula.terms().into_iter().any(|t| t.any(&is_presumed));
        let all = usable.assumed.len();
        usable.assumed.retain(|own| !speaks(own));
        usable.has_presumed = usable.assumed.len() < all;
    }
    leave_what_is_beyond(page, &mut usable);
    arrive_past_integrals(&mut usable.assumed);
    usable
}

/// Where a chain says by an integral what a symbol is, `V = \int_0^R f \, ds = w`, and what that comes to, says the second of the symbol: `V = w`
/// in place of `V = \int_0^R f \, ds`, which says the same beside the rest of the chain, and can be differentiated.
fn arrive_past_integrals(assumed: &mut [Assumed]) {
    for at in 0..assumed.len() {
        if let Some(whole) = past_integrals(&assumed[at..]) {
            assumed[at].formula = whole.into();
        }
    }
}

/// What the first of these says of a symbol, with the first member of its chain in which nothing is integrated in place of an integral.
fn past_integrals(chain: &[Assumed]) -> Option<Formula> {
    let has_integral = |term: &Expr| term.any(&|part| matches!(part, Expr::Integral { .. }));
    let (first, rest) = chain.split_first()?;
    let (Expr::Symbol(name), mut end) = first.formula.as_equation()? else {
        return None;
    };
    if !has_integral(end) {
        return None;
    }
    for next in rest {
        let (left, right) = next.formula.as_equation()?;
        if (next.source, next.standing) != (first.source, first.standing) || left != end {
            return None;
        }
        end = right;
        if !has_integral(end) {
            let whole = || Formula::equal(Expr::Symbol(name.clone()), end.clone());
            return (!end.mentions(name)).then(whole);
        }
    }
    None
}

/// Leaves out what speaks of complex numbers or small changes. Where a chain goes through complex members from a real one to a real one,
/// `w^2 = 2 - e^{i k} - e^{-i k} = 2 - 2 \cos k`, its ends are kept.
fn leave_what_is_beyond(page: &Page, usable: &mut Usable) {
    let is_real = |term: &Expr| {
        let mut names = Formula::names_in([term].into_iter()).into_iter();
        names.all(|own| !page.complex.contains(&own))
    };
    let mut kept: Vec<Assumed> = Vec::new();
    // The chain, the real member that it goes on from, and the complex one it has come to.
    let mut way: Option<(Source, Expr, Expr)> = None;
    for own in std::mem::take(&mut usable.assumed) {
        let Some(beyond) = page.beyond(&own.formula) else {
            kept.push(own);
            continue;
        };
        let sides = own.formula.as_equation();
        let Some((left, right)) = sides.filter(|_| beyond == Beyond::Complex) else {
            usable.beyond.get_or_insert(beyond);
            continue;
        };
        let goes_on =
            |(source, _, end): &(Source, Expr, Expr)| *source == own.source && end == left;
        let begin = match way.take() {
            Some(before) if goes_on(&before) => Some(before.1),
            Some(_) => {
                usable.beyond.get_or_insert(beyond);
                None
            }
            None => None,
        };
        match begin.or_else(|| is_real(left).then(|| left.clone())) {
            Some(begin) if is_real(right) => kept.push(Assumed {
                formula: Formula::equal(begin, right.clone()).into(),
                ..own.clone()
            }),
            Some(begin) => way = Some((own.source, begin, right.clone())),
            None => _ = usable.beyond.get_or_insert(beyond),
        }
    }
    if way.is_some() {
        usable.beyond.get_or_insert(Beyond::Complex);
    }
    usable.assumed = kept;
}

/// Of `L = T - V = w`, where `L` is differentiated partially, also that `L = w`: that may be the formula of which this is meant.
fn add_formulas(assumed: &mut Vec<Assumed>, dependent: &Set<Symbol>) {
    let found = ends_of_chains(assumed.iter(), |name| dependent.contains(name));
    for formula in found {
        if !assumed.contains(&formula) {
            assumed.push(formula);
        }
    }
}

/// Of `L = T - V = w` that `L = w`, for chains that begin with a name such as is asked for.
pub(in crate::audit) fn ends_of_chains<'a>(
    assumed: impl Iterator<Item = &'a Assumed>,
    begins: impl Fn(&Symbol) -> bool,
) -> Vec<Assumed> {
    let mut found: Vec<Assumed> = Vec::new();
    // The last link of a chain that begins with such a name, and the name.
    let mut chain: Option<(&Assumed, &Expr)> = None;
    for link in assumed {
        let Some((left, right)) = link.formula.as_equation() else {
            chain = None;
            continue;
        };
        chain = match (left, chain) {
            (Expr::Symbol(name), _) if begins(name) => Some((link, left)),
            (_, Some((before, name)))
                if before.source == link.source
                    && before
                        .formula
                        .as_equation()
                        .is_some_and(|own| own.1 == left) =>
            {
                found.push(Assumed {
                    formula: Formula::equal(name.clone(), right.clone()).into(),
                    ..link.clone()
                });
                Some((link, name))
            }
            _ => None,
        };
    }
    found
}

/// What is offered of a statement that was refuted: what is printed, where how its sides change was judged, or what it says beside what follows.
fn offered(statement: &Statement, judged: &Judged) -> Formula {
    let refuted = &judged.goal;
    let printed = goals(statement);
    let mut printed = printed.into_iter();
    let printed = printed.find(|own| own.clause == refuted.clause && own.sides == refuted.sides);
    let says_the_same = |own: &Goal| own.formula.terms().get(1) == refuted.formula.terms().get(1);
    match printed {
        Some(own) if judged.is_of_change() || says_the_same(&own) => own.formula,
        _ => refuted.formula.clone(),
    }
}
