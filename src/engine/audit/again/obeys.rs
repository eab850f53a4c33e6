//! Solutions that do not obey their law: "The solution is $N = N_0 e^{\lambda t}$" after `\frac{dN}{dt} = -\lambda N`.
//!
//! What a law of change leaves open is fixed by constants that a solution brings along. Put into the law, a solution must obey it for some of
//! them; one that obeys it for none, unless something is nought, is none.

use crate::algebra::{BigRational, Expr, Formula, Function, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source, first_goal};
use crate::document::Extent;
use crate::kernel::{Refuted, Standing};
use crate::search::{self, Decision};
use crate::sorted::Set;

use super::super::judge::{Found, Judge, positive, taken};
use super::super::{Judged, Outcome, Verdict};
use super::antiderivative::INTEGRATING;
use super::borrowed::chain_of;
use super::conditions::collect_waves;
use super::driven::{driven_by, with_drivers_put_in};
use super::solution::{for_the_quantity, value_of_its_own, with_own_value_named, without_factors};

/// What a solution comes after, where nothing else says that it is one.
const SOLVING: [&str; 12] = [
    "solve",
    "solved",
    "solves",
    "solving",
    "solution",
    "solutions",
    "integral",
    "separate",
    "separating",
    "separation",
    "exponentiate",
    "exponentiating",
];
/// With one of these it is the solution of something simpler than what the law says, or near one.
const OF_ANOTHER_LAW: [&str; 22] = [
    "without",
    "absence",
    "neglect",
    "neglecting",
    "neglected",
    "ignoring",
    "ignored",
    "vanishing",
    "slow",
    "early",
    "late",
    "short",
    "long",
    "approximate",
    "approximately",
    "undamped",
    "leading",
    "expanding",
    "expansion",
    "initially",
    "asymptotic",
    "asymptotically",
];
/// So it is with one of these, unless symbols say of which case it is.
const OF_A_CASE: [&str; 4] = ["small", "large", "weak", "strong"];
/// With one of these it is said to be the one that meets the conditions that stand just before it.
const MEETING: [&str; 12] = [
    "satisfy",
    "satisfies",
    "satisfying",
    "condition",
    "conditions",
    "boundary",
    "these",
    "them",
    "subject",
    "meeting",
    "meets",
    "fitting",
];
/// What is put in for constants.
const NUMBERS: [i64; 6] = [2, 3, 5, 7, 11, 13];
/// Why a solution is left open that a point of its law refutes.
const OBEYS: &str =
    "it obeys the law that it is drawn from, and from where it begins was not understood";
/// So much work is done, as [`effort`] counts it.
const MOST_WORK: u64 = 2_000_000;

/// So many equations after a law are looked at for what solves it there.
const MOST_SOLVED: usize = 64;

/// What is said to be a solution, and of what.
#[derive(Clone)]
struct Solution {
    law: Assumed,
    /// What was put into it: how what drives it goes with the variable.
    drivers: Vec<Assumed>,
    variable: Symbol,
    /// What does not move in either.
    constants: Set<Symbol>,
    /// What the law speaks of, and what is said to be made of that.
    fixed: Set<Symbol>,
    /// The solution, that all is positive, and what the text says besides.
    assumed: Vec<Assumed>,
}

impl Solution {
    /// Whether a symbol is of the law, or what it is is said otherwise: a solution may not choose what it is.
    fn is_of_law(&self, own: &Symbol) -> bool {
        *own == self.variable
            || self.fixed.contains(own)
            || Expr::Symbol(own.clone()) == value_of_its_own()
    }

    /// Numbers for the constants of the law, no two alike: great ones, or one over them.
    fn numbers(&self, great: bool) -> Vec<Assumed> {
        let of_law = self.law.formula.names();
        let given = self
            .assumed
            .iter()
            .filter_map(|own| match own.formula.as_equation()?.0 {
                Expr::Symbol(name) => Some(name),
                _ => None,
            });
        let given: Set<&Symbol> = given.collect();
        let constants = self.constants.iter();
        let open = constants.filter(|&own| of_law.contains(own) && !given.contains(&own));
        let set = |(own, number): (&Symbol, i64)| {
            let number = BigRational::from_integer(number.into());
            let number = if great { number } else { number.recip() };
            taken(&Formula::number(own.clone(), number))
        };
        open.zip(NUMBERS).map(set).collect()
    }

    /// The same where only what a solution names is fixed: for some `I` it obeys `I \frac{dw}{dt} = \mu m g R` where it says that
    /// `w = w_0 + \frac{5 \mu g}{2 R} t`.
    fn told_by(&self, named: &Set<Symbol>) -> Solution {
        let is_of_others = |said: &Assumed| {
            said.source == Source::Taken && said.formula.names().is_disjoint(named)
        };
        let mut told = self.clone();
        told.fixed.retain(|symbol| named.contains(symbol));
        told.assumed.retain(|said| !is_of_others(said));
        told
    }

    /// What is assumed besides the solution.
    fn circumstances(&self) -> &[Assumed] {
        &self.assumed[1..]
    }
}

impl Judge<'_> {
    /// What to say of a solution that obeys the law that it is said to solve for no values of its constants but nought, or of one that obeys
    /// it and was refuted all the same.
    pub(in crate::audit) fn as_no_solution(
        &self,
        goal: &Goal,
        premises: &[usize],
        judged: Option<&Judged>,
    ) -> Option<Found> {
        // A point of a law refutes nothing that is said to come of an integration.
        let at_a_point = |own: &&Judged| own.outcome.is_refuted() && !draws_on_values(own);
        let refuted_at_a_point = judged.filter(at_a_point);
        if refuted_at_a_point.is_some() && !self.is_led_to_as_solution() {
            return None;
        }
        let own = self.said_to_solve(goal, premises, None);
        let own = own.map(|own| (own, goal.clone()));
        let (mut own, solution) = own.or_else(|| self.with_its_parameter(goal, premises))?;
        let solution = &solution;
        effort::within(MOST_WORK, || {
            let mut decision = self.decide_of(&own, &own.assumed, &own.law.formula)?;
            // With numbers for its constants what is left of the law may have a sign.
            for great in [true, false] {
                let Decision::Open(_) = decision else {
                    break;
                };
                let mut assumed = own.assumed.clone();
                assumed.extend(own.numbers(great));
                let numbered = || self.decide_of(&own, &assumed, &own.law.formula);
                if let Some(Decision::Refuted(refuted)) = effort::within(MOST_WORK, numbered) {
                    own.assumed = assumed;
                    decision = Decision::Refuted(refuted);
                }
            }
            let refuted = match decision {
                Decision::Refuted(refuted) => refuted,
                // It obeys the law, and may have another value where the text tells one.
                Decision::Proven { .. } => {
                    let begins = self.begins_otherwise((goal, solution), &own);
                    let other = begins.or_else(|| self.ends_otherwise(goal, &own));
                    return other.or_else(|| {
                        let mut open = Found::open(refuted_at_a_point?.clone());
                        open.leave_open(OBEYS);
                        Some(open)
                    });
                }
                Decision::Open(_) => return self.ends_otherwise(goal, &own),
            };
            // For some values of the constants that it brings along it may be one, whatever the law's own are, and for some of those on which
            // it is silent.
            let named = solution.formula.names();
            let is_told = |symbol: &Symbol| own.is_of_law(symbol) && named.contains(symbol);
            if !own.constants.iter().all(is_told)
                && !self.is_one_for_none(solution, &own.told_by(&named), &refuted)
            {
                return None;
            }
            let mut found = refuted_of(goal, &own.law.formula, &own.assumed, refuted);
            found.judged.assumed.append(&mut own.drivers);
            found.constant = own.constants.iter().cloned().collect();
            Some(found)
        })
    }

    /// Whether words lead on to a step as to what solves something.
    pub(super) fn is_led_to_as_solution(&self) -> bool {
        self.says(&SOLVING) || self.says(&INTEGRATING)
    }

    /// The law that a goal is said to solve; nothing where words say that it is none of that law, or something else moves.
    fn said_to_solve(
        &self,
        goal: &Goal,
        premises: &[usize],
        beside: Option<&Assumed>,
    ) -> Option<Solution> {
        let (left, right) = goal.formula.as_equation()?;
        if !goal.is_said_outright() {
            return None;
        }
        let (left, right) = for_the_quantity(left, right);
        let (right, own_variable) = with_own_value_named(&left, &right);
        // "and, since the liquid sticks to the wall, $u(a) = 0$,"
        let says_where = || {
            let mut said = self.derivation.conditions_said(self.at).into_iter();
            said.any(|said| {
                let is_of = |own: &Symbol| left.mentions(own);
                said.just_said && matches!(&said.of, Expr::Symbol(own) if is_of(own))
            })
        };
        let own = &self.derivation.equations[self.at];
        if !own.drawn
            && !self.is_led_to_as_solution()
            && !says_where()
            && !self.is_wave(&left, &right)
        {
            return None;
        }
        // "Without friction the solution is" is of another law.
        let in_general = own.extent == Extent::Throughout || self.names_its_case();
        if self.is_of_another_law() {
            return None;
        }
        // What stands before is gathered only for what may be a solution.
        let variable = self.variable_between(&left, &right)?;
        let near = &self.others(premises)[0];
        let laws = || self.usable.assumed.iter().chain(near).chain(beside);
        let mut moved = standing_in_slopes(laws().map(|own| &*own.formula));
        moved.retain(|own| left.mentions(own) && !right.mentions(own));
        let of = moved.pop_first().filter(|_| moved.is_empty())?;
        let (left, right) = without_factors(&left, &right, &of).unwrap_or((left, right));
        let is_law = |own: &&Assumed| {
            (own.standing == Standing::Identity || speaks_of_course(&own.formula, &of, &variable))
                && matches!(own.source, Source::Equation(_))
                && own.formula.as_equation().is_some()
                && standing_in_slopes([&*own.formula].into_iter()).contains(&of)
                && own.formula.differentiates_by(&variable)
                && order(&own.formula) > order(&goal.formula)
                && !self.is_solved_there(&own.source, &of)
        };
        if !right.mentions(&variable) || own_variable.is_some_and(|own| own != variable) {
            return None;
        }
        let driven = |law: &Assumed| {
            let drivers = driven_by(laws(), &law.formula, (&of, &variable));
            let formula = with_drivers_put_in(&law.formula, &drivers);
            let law = Assumed {
                formula: formula.into(),
                ..law.clone()
            };
            (!law.formula.speaks_of_values()).then_some((law, drivers))
        };
        let (mut law, drivers) = laws().filter(is_law).find_map(driven)?;
        let said = law.formula;
        law.formula = with_numbers_put_in(&said, laws()).into();
        if !in_general && law.formula == said {
            return None;
        }
        // What is said to vary further on does so from one case to another.
        let moves = |own: &Symbol| {
            self.auditor.changes(self.at, own, &variable)
                && !self.auditor.is_told_to_change_later(self.at, own)
        };
        let right = without_constants((&left, &right), &law.formula, (&of, &variable), moves)
            .unwrap_or(right);
        let solution = Formula::equal(left, right.clone());
        // Nothing else moves, and nothing else is known of what stands in it.
        let mut constants = solution.free_symbols();
        constants.extend(law.formula.free_symbols());
        let meant = meant(laws(), &mut constants, (&of, &variable));
        let fixed = fixed_by(&law.formula, &meant);
        let page = &self.derivation.pages[self.derivation.equations[self.at].page];
        constants.retain(|own| *own != of && *own != variable && !page.is_number(own));
        if constants.iter().any(moves) {
            return None;
        }
        let throughout = |formula: &Formula| Assumed {
            standing: Standing::Identity,
            ..taken(formula)
        };
        // What swings and dies away has values that are known where the exponent is 0.
        let begins = Some(&variable).filter(|_| !is_damped_wave(&right, &variable, &fixed));
        let positive = constants.iter().chain(begins).map(positive);
        let assumed = [throughout(&solution)].into_iter().chain(meant);
        let assumed = assumed.chain(positive);
        let assumed = assumed.collect();
        let mut own = Solution {
            law,
            drivers,
            assumed,
            fixed,
            variable,
            constants,
        };
        // What the text says besides may be of a case in which it is one, "**Critical damping** ($\gamma = \omega_0$)", and of no moment, as
        // are "with $v(0) = 0$" and "Setting the left side of (2) to zero".
        let is_of_a_moment = |said: &Formula| {
            let names = said.names();
            said.speaks_of_values() || names.contains(&own.variable) || names.contains(&of)
        };
        let is_of_law = |said: &Formula| said.names().iter().all(|name| own.is_of_law(name));
        let mut said = self.derivation.written_since(self.at);
        said.retain(|said| is_of_law(said) && !is_of_a_moment(said));
        let supposed = self.usable.assumed.iter().filter(|said| {
            matches!(said.source, Source::Local(..)) && !is_of_a_moment(&said.formula)
        });
        let said = said.iter().map(throughout).chain(supposed.cloned());
        let said: Vec<Assumed> = said.collect();
        own.assumed.extend(said);
        Some(own)
    }

    /// Whether a law stands in a section that is over, and something is said there to solve it: that may be of a case of its own.
    fn is_solved_there(&self, law: &Source, of: &Symbol) -> bool {
        let Source::Equation(law) = *law else {
            return false;
        };
        let own = self.derivation.section_start(self.at);
        let section = self.derivation.section_start(law);
        let mut others =
            (law + 1..own).take_while(|&at| self.derivation.section_start(at) == section);
        let mut others = others.by_ref().take(MOST_SOLVED);
        let gives = |formula: &Formula| {
            let sides = formula.as_equation();
            sides.is_some_and(|(left, right)| {
                let factor = without_factors(left, right, of);
                *left == Expr::Symbol(of.clone()) || factor.is_some()
            })
        };
        others.any(|at| {
            let statements = self.derivation.equations[at].statements().iter();
            statements
                .filter_map(first_goal)
                .any(|own| gives(&own.formula))
        })
    }

    /// A solution of the same display with what a goal says of one of its constants: "$x = A e^{-\gamma t} \cos\omega t, \quad
    /// \omega = \sqrt{\omega_0^2 - \gamma^2}$".
    fn with_its_parameter(&self, goal: &Goal, premises: &[usize]) -> Option<(Solution, Goal)> {
        let (Expr::Symbol(parameter), value) = goal.formula.as_equation()? else {
            return None;
        };
        if value.mentions(parameter) {
            return None;
        }
        let beside = Assumed {
            standing: Standing::Identity,
            ..taken(&goal.formula)
        };
        let display = self.derivation.display_start(self.at)..self.at + 1;
        let equations = display.map(|at| &self.derivation.equations[at]);
        let statements = equations.flat_map(|own| own.statements());
        let mut solutions = statements.filter_map(first_goal);
        solutions.find_map(|own| {
            let (left, right) = own.formula.as_equation()?;
            if !right.mentions(parameter) || left.mentions(parameter) {
                return None;
            }
            let solution = self.said_to_solve(&own, premises, Some(&beside))?;
            let is_fixed = solution.fixed.contains(parameter);
            is_fixed.then_some((solution, own))
        })
    }

    /// Whether a step says of a quantity what it is at all times, as a wave: `x = A e^{-\gamma t} \cos(\omega t + \varphi)` needs no words to be a
    /// solution.
    fn is_wave(&self, left: &Expr, right: &Expr) -> bool {
        let mut waves = Vec::new();
        collect_waves(right, &mut waves);
        // To look for the variable is to look through the page.
        if waves.is_empty() || !matches!(left, Expr::Symbol(_)) {
            return false;
        }
        let variable = self.variable_between(left, right);
        variable.is_some_and(|variable| waves.iter().any(|wave| wave.mentions(&variable)))
    }

    /// Whether symbols before a step say in which case it is, `\gamma < \omega_0`: a law is the same in each.
    fn names_its_case(&self) -> bool {
        let said = self.derivation.written_since(self.at);
        said.iter().any(Formula::is_inequality)
    }

    /// Whether words say that a solution is one of something simpler than the law, or near one. "If the damping is weak ($\gamma < \omega_0$)" says
    /// of which case it is.
    pub(super) fn is_of_another_law(&self) -> bool {
        self.says(&OF_ANOTHER_LAW) || self.says(&OF_A_CASE) && !self.names_its_case()
    }

    /// What is decided where all but the variable and what depends on it is constant.
    fn decide_of(
        &self,
        own: &Solution,
        assumed: &[Assumed],
        formula: &Formula,
    ) -> Option<Decision> {
        let claim = self.derivation.claim(self.at, assumed, formula);
        let claim = search::with_constants(claim, own.constants.iter().cloned());
        Some(self.decide(&*self.pose_claim(claim).ok()?))
    }

    /// What to say of a solution that has another value than the text tells just before it.
    fn begins_otherwise(&self, (goal, solution): (&Goal, &Goal), own: &Solution) -> Option<Found> {
        let mut said = self.derivation.conditions_said(self.at);
        said.retain(|own| own.just_said);
        let mut met = self.slopes_where_told(&said, solution, &own.variable);
        met.extend(self.met_where_it_begins(said, solution, &own.variable));
        met.into_iter().find_map(|(_, there)| {
            match self.decide_of(own, own.circumstances(), &there)? {
                // The solution itself was put in there.
                Decision::Refuted(refuted) => Some(refuted_of(goal, &there, &own.assumed, refuted)),
                _ => None,
            }
        })
    }

    /// What to say of a solution that has another value at a boundary than it is said to have: "with
    /// $$\theta(0) = \theta_0, \qquad \theta'(L) = 0$$ The solution satisfying these is".
    fn ends_otherwise(&self, goal: &Goal, own: &Solution) -> Option<Found> {
        let (Expr::Symbol(of), right) = own.assumed.first()?.formula.as_equation()? else {
            return None;
        };
        let value_there = |said: &Assumed| {
            let (there, value) = said.formula.as_equation()?;
            let Expr::Limit { body, variable, .. } = there else {
                return None;
            };
            let is_told = body.mentions(of) && *variable == own.variable;
            let is_told = is_told && !value.mentions(of) && !value.mentions(variable);
            is_told.then(|| Formula::equal(there.substitute(of, right), value.clone()))
        };
        let mut told = self.usable.assumed.clone();
        if self.says(&MEETING) {
            let before: Vec<usize> = self.derivation.display_before(self.at).collect();
            told.extend(self.gathered(&before));
        }
        // What another solution comes to is no condition: "At the end $w(L) = F L^3/3 E I$. For a line load instead".
        let is_drawn = |other: usize| self.derivation.equations[other].drawn;
        told.retain(|said| match said.source {
            Source::Equation(other) => self.is_all(Verdict::Given, other) || !is_drawn(other),
            _ => true,
        });
        told.into_iter().find_map(|said| {
            let there = value_there(&said)?;
            let Decision::Refuted(refuted) = self.decide_of(own, own.circumstances(), &there)?
            else {
                return None;
            };
            // The solution itself was put in there.
            let mut assumed = own.assumed.clone();
            assumed.push(said);
            Some(refuted_of(goal, &there, &assumed, refuted))
        })
    }

    /// Whether a solution obeys its law for no values of the constants that it brings along, where those of the law are as a point says.
    fn is_one_for_none(&self, goal: &Goal, own: &Solution, point: &Refuted) -> bool {
        let set = point.witness().symbols.iter();
        let set = set.filter(|(symbol, _)| own.is_of_law(symbol));
        let set = set.map(|(symbol, value)| taken(&Formula::number(symbol.clone(), value.clone())));
        let so = Assumed {
            standing: Standing::AtPoint,
            ..own.law.clone()
        };
        // It would have to be one at each moment, and so where no wave is nought.
        let mut waves = Vec::new();
        if let Some((_, right)) = goal.formula.as_equation() {
            collect_waves(right, &mut waves);
        }
        let is_tangent = |wave: &Expr| matches!(wave, Expr::Call(Function::Tan, _));
        waves.retain(|wave| wave.mentions(&own.variable) && !is_tangent(wave));
        let waves = waves
            .into_iter()
            .map(|wave| taken(&Formula::positive(wave)));
        let all = own
            .assumed
            .iter()
            .cloned()
            .chain(set)
            .chain([so])
            .chain(waves);
        let all: Vec<Assumed> = all.collect();
        let nonsense = Formula::equal(Expr::integer(0), Expr::integer(1));
        matches!(
            self.decide_of(own, &all, &nonsense),
            Some(Decision::Proven { .. })
        )
    }
}

/// Whether a term has exponentials and waves of a variable, `e^{-\gamma t} \cos(\omega t)`, and brings no rates of its own along: for what they
/// would have to be, too much damping may leave nothing.
fn is_damped_wave(term: &Expr, variable: &Symbol, fixed: &Set<Symbol>) -> bool {
    use Function::{Cos, Exp, Sin};
    let has = |functions: &[Function]| {
        term.any(&|part| match part {
            Expr::Call(own, argument) => functions.contains(own) && argument.mentions(variable),
            _ => false,
        })
    };
    let is_fixed = |own: &Symbol| own == variable || fixed.contains(own);
    let brings = |rate: &Expr| rate.mentions(variable) && !rate.free_symbols().iter().all(is_fixed);
    let brings_rates = term.any(&|part| match part {
        Expr::Call(Exp | Sin | Cos, argument) => match &**argument {
            Expr::Sum(terms) => terms.iter().any(brings),
            whole => brings(whole),
        },
        _ => false,
    });
    has(&[Exp]) && has(&[Sin, Cos]) && !brings_rates
}

/// What a slope is said to be but for the constants of its integration, `C` of `E I \frac{dv}{dx} = -\frac{w x^3}{6} + C`, of which a law says
/// nothing that speaks of how that slope changes alone.
fn without_constants(
    (left, right): (&Expr, &Expr),
    law: &Formula,
    (of, variable): (&Symbol, &Symbol),
    moves: impl Fn(&Symbol) -> bool,
) -> Option<Expr> {
    let slope = Expr::Symbol(of.clone()).differentiated_by(variable);
    let change = slope.clone().differentiated_by(variable);
    let speaks = |term: &Expr| term.replace(&change, &Expr::integer(0)).mentions(of);
    let (Expr::Sum(items), true) = (right, left.any(&|part| *part == slope)) else {
        return None;
    };
    if law.terms().into_iter().any(speaks) {
        return None;
    }
    let of_law = law.names();
    let is_constant = |item: &&Expr| match item {
        Expr::Symbol(own) => !of_law.contains(own) && !moves(own),
        _ => false,
    };
    let mut rest: Vec<Expr> = items
        .iter()
        .filter(|own| !is_constant(own))
        .cloned()
        .collect();
    match rest.len() {
        0 => None,
        1 => rest.pop(),
        _ => Some(Expr::Sum(rest.into())),
    }
}

/// What stands below a derivative and is not what is differentiated by.
fn standing_in_slopes<'a>(formulas: impl Iterator<Item = &'a Formula>) -> Set<Symbol> {
    let mut slopes = Set::new();
    for term in formulas.flat_map(Formula::terms) {
        term.collect_slopes(&mut slopes);
    }
    let others = slopes.into_iter().filter(|(own, by)| own != by);
    others.map(|(own, _)| own).collect()
}

/// How often what a formula speaks of is differentiated at most: a law of the first order has no solution that speaks of a slope.
pub(super) fn order(formula: &Formula) -> usize {
    fn of(term: &Expr) -> usize {
        let within = term.children().map(of).max().unwrap_or_default();
        within + usize::from(matches!(term, Expr::Derivative { .. }))
    }
    let terms = formula.terms().into_iter();
    terms.map(of).max().unwrap_or_default()
}

/// A law with the numbers put in that something in it is everywhere: "In equilibrium $J = 0$".
fn with_numbers_put_in<'a>(law: &Formula, said: impl Iterator<Item = &'a Assumed>) -> Formula {
    let everywhere = said.filter(|own| own.standing == Standing::Identity);
    everywhere.fold(law.clone(), |law, own| match own.formula.as_equation() {
        Some((Expr::Symbol(name), number @ Expr::Number(_))) => {
            law.map_terms(|term| term.substitute(name, number))
        }
        _ => law,
    })
}

/// What some of these say that symbols among some mean, by what does not change: `\ell = D/v`. What they are made of joins the symbols.
pub(super) fn meant<'a>(
    said: impl Iterator<Item = &'a Assumed>,
    symbols: &mut Set<Symbol>,
    (of, variable): (&Symbol, &Symbol),
) -> Vec<Assumed> {
    let said = said.filter(|own| own.standing == Standing::Identity);
    let means = |own: &Assumed, symbols: &Set<Symbol>| match own.formula.as_equation() {
        Some((name, value)) => raised(name).is_some_and(|name| {
            let moves = value.mentions(of) || value.mentions(variable);
            symbols.contains(name) && name != of && !moves && !value.mentions(name)
        }),
        None => false,
    };
    chain_of(&mut said.cloned().collect(), symbols, means)
}

/// Whether an equation says how a slope goes with what varies, `\frac{du}{dr} = -\frac{r g}{2 \mu}`: that is of more than one place, also where it
/// was drawn from what words say.
pub(super) fn speaks_of_course(law: &Formula, of: &Symbol, variable: &Symbol) -> bool {
    fn moves(term: &Expr, of: &Symbol, variable: &Symbol) -> bool {
        match term {
            Expr::Derivative { .. } | Expr::Partial { .. } | Expr::Limit { .. } => false,
            Expr::Symbol(own) => own == of || own == variable,
            term => term.children().any(|part| moves(part, of, variable)),
        }
    }
    let mut terms = law.terms().into_iter();
    terms.any(|term| moves(term, of, variable))
}

/// The symbol that something is given of, by itself or as a power: `\omega_0^2 = k/m`.
fn raised(given: &Expr) -> Option<&Symbol> {
    match given {
        Expr::Symbol(name) => Some(name),
        Expr::Power(base, exponent) if matches!(**exponent, Expr::Number(_)) => match &**base {
            Expr::Symbol(name) => Some(name),
            _ => None,
        },
        _ => None,
    }
}

/// What a law speaks of, and the symbols that some equations give by that: of `\tau = u/g` and `\dot v = g - k v^2` none, as `u` may be chosen.
pub(super) fn fixed_by(law: &Formula, given: &[Assumed]) -> Set<Symbol> {
    let mut fixed = law.names();
    loop {
        let before = fixed.len();
        for (name, value) in given.iter().filter_map(|own| own.formula.as_equation()) {
            if let Some(name) = raised(name)
                && value.free_symbols().iter().all(|own| fixed.contains(own))
            {
                fixed.insert(name.clone());
            }
        }
        if fixed.len() == before {
            return fixed;
        }
    }
}

/// That something else than a goal is refuted, and by that the goal.
pub(super) fn refuted_of(
    goal: &Goal,
    formula: &Formula,
    assumed: &[Assumed],
    refuted: Refuted,
) -> Found {
    Found::open(Judged {
        goal: Goal {
            formula: formula.clone(),
            ..goal.clone()
        },
        assumed: assumed.to_vec(),
        outcome: Outcome::Refuted(refuted.into()),
    })
}

/// Whether a step draws on what says the value of something at a place.
fn draws_on_values(judged: &Judged) -> bool {
    let mut assumed = judged.assumed.iter();
    assumed.any(|own| own.formula.speaks_of_values())
}
