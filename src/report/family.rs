//! Counterexamples for every number at once, in words: where they are, and what was proved of them.

use crate::algebra::{Expr, Formula, Symbol, expr_of};
use crate::audit::{Counterexamples, Entry, Judged, counterexamples, is_idle};
use crate::kernel::{FailsThroughout, FamilyPart, Group, Knowledge, Problem, Proven, Sign};
use crate::notation::{latex, plain, plain_formula};
use crate::sorted;

use super::evidence::Point;
use super::style::{DIM, paint};
use super::{Report, explain, words};

/// One thing that was proved of all members.
pub(super) struct Shown<'a> {
    /// What it is about, as the claim has it; nothing where that is a domain.
    pub of: Option<&'a Formula>,
    /// The equation that gives it, where the step does not rest on that.
    pub besides: Option<usize>,
    /// What was proved.
    pub proven: &'a Proven,
}

/// What was proved, by what it shows.
#[derive(Default)]
pub(super) struct Checks<'a> {
    /// The members keep to all domains.
    pub possible: Vec<Shown<'a>>,
    /// The premises are true there.
    pub premises: Vec<Shown<'a>>,
    /// So is what is given besides.
    pub besides: Vec<Shown<'a>>,
    /// And the goal is false.
    pub goal: Vec<Shown<'a>>,
}

impl Report<'_> {
    /// The family of counterexamples to a link, where one is found.
    pub(super) fn family(&self, entry: &Entry, judged: &Judged) -> Option<Counterexamples> {
        counterexamples(self.derivation, entry.equation, judged)
    }

    /// A heading, then what everything is in the family, every premise as it is said of that, and why each is true.
    pub(super) fn family_lines(
        &self,
        entry: &Entry,
        judged: &Judged,
    ) -> Option<(String, Vec<String>)> {
        let found = self.family(entry, judged)?;
        let mut lines = values(&found.fails);
        let checks = checks(&found);
        let parts = [
            ("It keeps to every domain:", &checks.possible),
            ("Every premise is true there:", &checks.premises),
            ("So is what is given before and not cited:", &checks.besides),
            ("and what was to be shown is false:", &checks.goal),
        ];
        for (head, all) in parts.into_iter().filter(|(_, all)| !all.is_empty()) {
            lines.push(head.into());
            all.iter()
                .for_each(|shown| lines.extend(self.check_lines(shown)));
        }
        lines.push(format!("The first is {}", first(&found.fails)));
        let head = format!("Counterexample for {}", range(&found.fails));
        Some((head, lines))
    }

    /// What was proved of a formula, and why it is true.
    fn check_lines(&self, shown: &Shown) -> Vec<String> {
        let mut line = String::from("  ");
        if let Some(formula) = shown.of {
            line += &format!("{}:  ", plain_formula(formula));
        }
        line += &plain_formula(&shown.proven.claim().goal);
        let reason = at_sight(shown.proven);
        let proof = match &reason {
            Some(_) => Vec::new(),
            None => self.proof_of(shown.proven),
        };
        let from = shown.besides.map(|at| self.name(at));
        let aside: Vec<String> = from.into_iter().chain(reason).collect();
        if !aside.is_empty() {
            line += &format!("   {}", paint(DIM, &aside.join(", ")));
        }
        let proof = proof.iter().map(|line| format!("    {line}"));
        std::iter::once(line).chain(proof).collect()
    }
}

/// Why something is true of which that is seen at once: `an identity`, or what it comes to.
pub(super) fn at_sight(proven: &Proven) -> Option<String> {
    let problem = Problem::new(proven.claim(), &[]).ok()?;
    let goal = &problem.goal;
    if goal.sign == Sign::Zero {
        return goal.polynomial.is_zero().then(|| "an identity".into());
    }
    let knowledge = Knowledge::new(&problem.facts);
    let (seen, sign) = match goal.sign {
        Sign::Zero => return None,
        Sign::NonZero => (knowledge.is_nonzero(&goal.polynomial), "≠ 0"),
        Sign::NonNegative => (knowledge.is_nonnegative(&goal.polynomial), "≥ 0"),
        Sign::Positive => (knowledge.is_positive(&goal.polynomial), "> 0"),
    };
    let term = plain(&expr_of(&goal.polynomial, &problem.atoms));
    seen.then(|| format!("for {term} {sign}"))
}

/// `every n ≥ 2 and every v₀ ≠ 0`: what a member is chosen by.
pub(super) fn range(fails: &FailsThroughout) -> String {
    let family = fails.family();
    let parameter = words::symbol(&family.parameter);
    let mut all = vec![format!("every {parameter} ≥ {}", family.least)];
    let domains = explain::domains(fails.claim());
    for symbol in free(fails) {
        let declared = domains.iter().find(|(own, _)| *own == symbol);
        let name = || words::symbol(symbol);
        let said = declared.map_or_else(name, |(_, said)| said.clone());
        all.push(format!("every {said}"));
    }
    words::list(all)
}

/// The symbols that a family leaves free, besides the number that runs.
pub(super) fn free(fails: &FailsThroughout) -> Vec<&Symbol> {
    let family = fails.family();
    let named = fails.claim().free_symbols().into_iter();
    named
        .filter(|s| **s != family.parameter && !family.symbols.contains_key(*s))
        .collect()
}

/// `k = n + 1`, `u₁ = … = u_n = (n − 1)/(n + 1) v₀`: what everything is in a family.
pub(super) fn values(fails: &FailsThroughout) -> Vec<String> {
    let family = fails.family();
    let symbols = family.symbols.iter();
    let mut all: Vec<String> = symbols
        .map(|(symbol, term)| format!("{} = {}", words::symbol(symbol), plain(term)))
        .collect();
    let sequences = family.groups.first().map(|group| group.elements.keys());
    for sequence in sequences.into_iter().flatten() {
        all.extend(elements(fails, sequence));
    }
    all
}

/// What the elements of a sequence are, neighbours that are alike together.
fn elements(fails: &FailsThroughout, sequence: &Symbol) -> Vec<String> {
    let groups = &fails.family().groups;
    let point = Point::new(fails.claim(), fails.first().witness());
    let sum = |first: i32, groups: &[Group]| {
        let sizes = groups.iter().map(|group| group.size.clone());
        let sum = Expr::Sum([Expr::integer(first)].into_iter().chain(sizes).collect());
        point.computed(&sum).unwrap_or(sum)
    };
    let element = |position: &Expr| {
        let name = format!("{sequence}_{{{}}}", latex(position));
        words::symbol(&Symbol::new(name))
    };
    let alike = |a: &Group, b: &Group| a.elements.get(sequence) == b.elements.get(sequence);
    let (mut told, mut before) = (Vec::new(), 0);
    for own in groups.chunk_by(alike) {
        let start = sum(1, &groups[..before]);
        before += own.len();
        let end = match before == groups.len() {
            true => Expr::Symbol(fails.family().count.clone()),
            false => sum(0, &groups[..before]),
        };
        let named = match own {
            [single] if single.size.is_one() => element(&end),
            _ => format!("{} = … = {}", element(&start), element(&end)),
        };
        let term = own.first().and_then(|group| group.elements.get(sequence));
        told.extend(term.map(|term| format!("{named} = {}", plain(term))));
    }
    told
}

/// `n = 2, N = 3, k = 3, v₀ = 1, u = (1/3, 1/3, 4/3)`, what is run through before the rest.
pub(super) fn first(fails: &FailsThroughout) -> String {
    let refuted = fails.first();
    let parameter = words::symbol(&fails.family().parameter);
    let mut values = Point::new(refuted.claim(), refuted.witness()).values();
    sorted::sort_by_key(&mut values, |(name, _)| *name != parameter);
    let values = values
        .iter()
        .map(|(name, value)| format!("{name} = {value}"));
    values.collect::<Vec<_>>().join(", ")
}

/// What was proved, each thing once, and not that all groups together have as many elements as there are.
pub(super) fn checks(found: &Counterexamples) -> Checks<'_> {
    let claim = found.fails.claim();
    let cited = claim.hypotheses.len() - found.besides.len();
    let mut checks = Checks::default();
    for (part, proven) in found.fails.parts() {
        let mut shown = Shown {
            of: None,
            besides: None,
            proven,
        };
        match part {
            FamilyPart::Domain(_) | FamilyPart::Elements(..) => {
                let goal = &proven.claim().goal;
                if checks
                    .possible
                    .iter()
                    .all(|s| s.proven.claim().goal != *goal)
                {
                    checks.possible.push(shown);
                }
            }
            FamilyPart::Size(_) | FamilyPart::Count => {}
            FamilyPart::Hypothesis(at) => {
                let formula = &*claim.hypotheses[*at].formula;
                if is_idle(formula) {
                    continue;
                }
                shown.of = Some(formula);
                match at.checked_sub(cited) {
                    Some(own) => {
                        shown.besides = found.besides.get(own).copied();
                        checks.besides.push(shown);
                    }
                    None => checks.premises.push(shown),
                }
            }
            FamilyPart::Goal => {
                shown.of = Some(&claim.goal);
                checks.goal.push(shown);
            }
        }
    }
    checks
}
