//! Steps that speak of what no equation before does: with any value of that they are refuted, which says nothing of the author's.

use crate::algebra::{Expr, Formula, Symbol, split_subscript};
use crate::derivation::{Assumed, Goal, Source, first_goal, goals};
use crate::kernel::Standing;
use crate::search::{Change, Decision};
use crate::sorted::Set;

use super::super::Outcome;
use super::super::judge::{Found, Judge};
use super::super::stated::quantities;
use super::UNSAID;

const INTEGRATING: [&str; 3] = ["integrating", "integrate", "integration"];

impl Judge<'_> {
    /// Leaves open a step that brings in on one side what no equation before speaks of, and of which words say something: "for a loan of size
    /// $L$", "two measurements $(f_1, V_1)$" of `f` and `V`. With any value of that it is refuted, which says nothing of the author's.
    pub(in crate::audit) fn heed_what_is_new(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        let Some((left, right)) = goal.formula.as_equation() else {
            return;
        };
        if !found.judged.outcome.is_refuted() {
            return;
        }
        let introduced = &self.derivation.equations[self.at].introduces;
        let said = |own: &&Assumed| !own.source.is_of_statement();
        let before = assumed.iter().filter(said);
        let before: Set<Symbol> = before.flat_map(|own| own.formula.names()).collect();
        let (whole, value) = (left, right);
        let (left, right) = (quantities(left), quantities(right));
        // What the display says of it by what was known is used: "`\dot s + s/\lambda = g, \qquad \lambda = D/(4 k)`".
        let is_meant = |symbol: &Symbol| {
            let mut meanings = assumed
                .iter()
                .filter(|own| own.source == Source::Step && own.standing == Standing::Identity);
            meanings.any(|own| match own.formula.as_equation() {
                Some((Expr::Symbol(of), value)) => {
                    of == symbol && value.free_symbols().iter().all(|own| before.contains(own))
                }
                _ => false,
            })
        };
        let is_silent = |symbol: &&Symbol| !before.contains(*symbol) && !is_meant(symbol);
        // What has another index there and is not in the step as well may be meant for this.
        let is_general = |symbol: &Symbol| {
            let stem = stem(symbol);
            let mut speaking = self.derivation.speaking_before(self.at, symbol);
            if found.mended.is_some() || !speaking.all(|other| self.is_undecided(other)) {
                return false;
            }
            let mut others = before.iter().filter(|own| self::stem(own) == stem);
            others.clone().count() == 1
                && others.all(|own| !left.contains(own) && !right.contains(own))
        };
        let spoken_of = || {
            let near = self.approximations();
            let near = near.iter().flat_map(|(one, other)| [one, other]);
            let mut all: Set<Symbol> = before.union(&goal.formula.names()).cloned().collect();
            all.extend(Formula::names_in(near));
            all
        };
        // "`r_n = … = n^2 a_0, \qquad a_0 = 0.529\,\mathrm{Å}`"
        let is_said_beside = |symbol: &Symbol| {
            let statements = self.derivation.equations[self.at].statements().iter();
            let is_own = |own: &Goal| own.formula == goal.formula;
            let others = statements.filter(|own| !goals(own).iter().any(is_own));
            others.filter_map(first_goal).any(|own| own.is_of(symbol))
        };
        let is_named = |symbol: &Symbol| {
            self.derivation
                .is_named_in_words(self.at, symbol, &spoken_of())
        };
        let is_integral = || {
            let says = found.mended.is_none() && self.says(&INTEGRATING);
            says && self.is_integral(whole, value, assumed)
        };
        // Of an identity both sides speak of the same.
        // "The fraction that sits in the rotation is" draws on nothing, and may say what it speaks of.
        let draws = self.derivation.equations[self.at].drawn || self.names_its_premises();
        // In another section "The volume is $$V(h) = …$$" may be of something else.
        let start = self.derivation.section_start(self.at);
        let is_anew = |symbol: &Symbol| {
            let mut speaking = self.derivation.speaking_before(self.at, symbol);
            !draws
                && !self.is_directed()
                && goal.is_of(symbol)
                && speaking.all(|other| other < start)
        };
        let is_new = |symbol: &Symbol| {
            (introduced.contains(symbol) || is_anew(symbol))
                && left.contains(symbol) != right.contains(symbol)
        };
        let judged_from = match &found.judged.outcome {
            Outcome::Refuted(refuted)
                if !draws && !self.is_directed() && goal.suppositions.is_empty() =>
            {
                let own = |said: &Formula| {
                    let mut own = assumed.iter().filter(|own| own.source.is_of_statement());
                    own.any(|own| *own.formula == *said)
                };
                let said = refuted.claim().hypotheses.iter();
                let said = said.filter(|said| !own(&said.formula));
                said.flat_map(|own| own.formula.names()).collect()
            }
            _ => left.union(&right).cloned().collect::<Set<Symbol>>(),
        };
        let is_loose =
            |own: &Symbol| found.mended.is_none() && !judged_from.contains(own) && is_new(own);
        // "$\frac1u + \frac1v = (n - 1) (\frac1{r_1} + \frac1{r_2}) = \frac1f$" ends by saying what `f` is.
        let is_last_word = |own: &Symbol| {
            let mut chain = assumed.iter().filter(|own| own.source.is_of_statement());
            let goes_on = chain.clone().next().is_some();
            let is_used = chain.any(|link| link.formula.names().contains(own));
            goes_on && !is_used && !left.contains(own) && found.mended.is_none() && is_new(own)
        };
        // "In the field of gravity we get $m \dot v = F - m g$" after `m \dot v = F`: no slip of the pen brings a summand with a letter of
        // its own.
        let is_summand_more = |own: &Symbol| {
            let mended = found.mended.as_deref();
            mended.is_some_and(|mended| {
                let kept = &mended.proven.claim().goal;
                mended.change == Change::Summand && !kept.names().contains(own)
            })
        };
        let mut silent = left.union(&right).filter(is_silent);
        if is_integral()
            || silent.any(|own| {
                is_general(own)
                    || is_loose(own)
                    || is_last_word(own)
                    || is_new(own) && (is_said_beside(own) || is_named(own) || is_summand_more(own))
            })
        {
            found.leave_open(UNSAID);
        }
    }

    /// Whether a term changes as a premise says that something does: what it is an integral of. "Integrating (6), the distance fallen is"
    /// says of a new symbol what it is but for where it begins.
    fn is_integral(&self, new: &Expr, term: &Expr, assumed: &[Assumed]) -> bool {
        let variable = match new {
            Expr::Apply(own, arguments) => match &arguments[..] {
                [Expr::Symbol(variable)] => Some((own, variable.clone())),
                _ => None,
            },
            Expr::Symbol(own) => self.variable().map(|variable| (own, variable)),
            _ => None,
        };
        let Some((own, variable)) = variable else {
            return false;
        };
        if self.derivation.is_spoken_of_before(self.at, own) {
            return false;
        }
        let slope = Expr::Derivative {
            body: term.clone().into(),
            variable,
        };
        let cited = assumed
            .iter()
            .filter(|own| matches!(own.source, Source::Equation(_)));
        let mut values = cited.filter_map(|own| Some(own.formula.as_equation()?.1));
        values.any(|value| {
            let formula = Formula::equal(slope.clone(), value.clone());
            let still = self.decide_from(assumed, &formula);
            matches!(still, Some(Decision::Proven { .. }))
        })
    }
}

/// A name without its index.
fn stem(symbol: &Symbol) -> &str {
    split_subscript(symbol.name()).map_or(symbol.name(), |(stem, _)| stem)
}
