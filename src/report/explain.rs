//! One equation in full: what was understood, what it was judged from, and the evidence to check by hand.

use crate::algebra::{Formula, Symbol};
use crate::audit::{Entry, Judged, Outcome, Without, is_idle, true_besides, without_each};
use crate::derivation::Source;
use crate::kernel::{Claim, Refuted};
use crate::notation::{latex_statement, plain_formula, plain_statement};

use super::Report;
use super::evidence::Point;
use super::implied;
use super::scaling;
use super::style::{self, BOLD, DIM, paint};
use super::words;
use crate::sorted::Map;

impl Report<'_> {
    /// An equation with all its statements.
    pub fn explain(&self, at: usize) -> String {
        let equation = self.equation(at);
        let document = &self.derivation.pages[equation.page].document;
        let title = match &equation.tag {
            Some(tag) => format!("Equation ({tag})"),
            None => self.reference(at),
        };
        let mut text = format!("{}  {}\n", paint(BOLD, &title), paint(DIM, &self.place(at)));
        for line in document.written(equation.body).lines() {
            text += &format!("  {}\n", paint(DIM, line));
        }
        for entry in self.audit.of_equation(at) {
            text += &self.explain_entry(entry);
        }
        text + "\n"
    }

    fn explain_entry(&self, entry: &Entry) -> String {
        let mut text = String::from("\n");
        if let Some((part, parts)) = self.part_of(entry) {
            text += &format!("Statement {part} of {parts}\n");
        }
        if let Some(statement) = self.statement(entry) {
            text += &format!("  read as     {}\n", plain_statement(statement));
            text += &format!("  as LaTeX    {}\n", latex_statement(statement));
        }
        text += &format!("  said to be  {}\n", entry.kind.word());
        let numeric = match &entry.numeric {
            Some(_) if entry.is_supported() => ", supported numerically",
            _ => "",
        };
        let word = entry.verdict.word();
        let verdict = format!("{} {word}{numeric}", style::sign(entry.verdict));
        let verdict = paint(style::of(entry, self.is_finding(entry)), &verdict);
        text += &format!("  verdict     {verdict}\n");
        text += &self.dimension_lines(entry);
        for note in &entry.notes {
            if let Some(aside) = self.aside(entry.equation, note) {
                text += &format!("  note        {aside}\n");
            }
        }
        if let Some(model) = &entry.model {
            text += "\n  All that is given with it can be true together, for instance at\n";
            for line in assigned(model.point()) {
                text += &format!("    {line}\n");
            }
        }
        text += &self.numeric_lines(entry);
        for (step, judged) in entry.judged.iter().enumerate() {
            text += &self.explain_step(entry, step);
            text += &self.without(entry, judged);
        }
        if !entry.missing.is_empty() {
            text += &format!("\n  It {}.\n", self.supposing(entry));
        }
        if let Some((instead, proven)) = implied::instead_plainly(entry) {
            text += &format!("\n  Instead, {instead}.\n");
            if let Some((judged, _)) = entry.refuted() {
                for line in self.proof(judged, proven) {
                    text += &format!("    {line}\n");
                }
            }
        }
        text
    }

    /// What goes wrong without each premise.
    fn without(&self, entry: &Entry, judged: &Judged) -> String {
        let mut text = String::new();
        for (source, outcome) in without_each(self.derivation, entry.equation, judged) {
            let told = match &outcome {
                Without::Fails(refuted) => self.in_numbers(judged, refuted),
                Without::Follows => "it follows from the rest all the same".into(),
                Without::Open => "neither a proof nor a counterexample was found".into(),
            };
            text += &format!("    without {}: {told}\n", self.source(&source));
        }
        match text.is_empty() {
            true => text,
            false => format!("\n  What each premise is needed for\n{text}"),
        }
    }

    /// The dimension of both sides, or why they have none in common.
    fn dimension_lines(&self, entry: &Entry) -> String {
        let mut text = String::new();
        if let Some(conflict) = self.conflict(entry) {
            for (name, said) in self.dimensions_said(conflict) {
                let lines: Vec<&str> = said.lines().collect();
                text += &format!("  {name:<17}{}\n", lines.join(&format!("\n{:19}", "")));
            }
            return text;
        }
        let dimensions = self.dimensions(entry);
        if !dimensions.is_empty() {
            text += &format!("  dimension   {}\n", words::list(dimensions));
        }
        text
    }

    fn explain_step(&self, entry: &Entry, step: usize) -> String {
        let (judged, steps) = (&entry.judged[step], entry.judged.len());
        let shown = plain_formula(&judged.goal.formula);
        let head = match steps {
            1 => format!("To show: {shown}"),
            _ => format!("Step {} of {steps}: {shown}", step + 1),
        };
        let mut text = format!("\n  {}\n", paint(BOLD, &head));
        let (claim, evidence) = match &judged.outcome {
            Outcome::Stated => {
                text += "    taken as given: nothing to show\n";
                return text;
            }
            Outcome::Defined => {
                text += "    defines a symbol that has not occurred before: nothing to show\n";
                return text;
            }
            Outcome::Proven(proven) => (Some(proven.claim()), self.proof(judged, proven)),
            Outcome::ForEvery(holds) => {
                let lines = self.proof_for_every(judged, holds);
                (Some(&holds.claim().claim), lines)
            }
            Outcome::Refuted(refuted) => (Some(refuted.claim()), self.witness(entry, refuted)),
            Outcome::Scales(proven) => (Some(proven.claim()), self.scaling_proof(judged, proven)),
            Outcome::ScalesNot(refuted, repair) => {
                let mut lines = scaling::situations(refuted);
                if let Some(repair) = repair {
                    lines.push(format!("Instead, {}", scaling::repaired_plainly(repair)));
                    lines.extend(self.scaling_proof_of(judged, refuted.claim(), &repair.proven));
                }
                (Some(refuted.claim()), lines)
            }
            Outcome::Open(stop) => {
                let reason = match stop.reason.is_empty() {
                    true => "nothing was found".to_owned(),
                    false => stop.reason.clone(),
                };
                let tried = match stop.tried {
                    0 => String::new(),
                    tried => format!(" ({} tried)", words::count(tried, "point")),
                };
                (None, vec![format!("Undecided: {reason}{tried}")])
            }
        };
        text += "    From\n";
        for assumed in &judged.assumed {
            let formula = plain_formula(&assumed.formula);
            let origin = match assumed.tells_value_there() {
                true => "told: its value there".into(),
                false => self.origin(assumed.source),
            };
            text += &format!("      {formula}   {}\n", paint(DIM, &origin));
        }
        let domains = claim.map(|claim| self.domains(entry, judged, claim));
        for (line, by) in domains.unwrap_or_default() {
            text += &format!("      {line}   {}\n", paint(DIM, &by));
        }
        if text.ends_with("From\n") {
            text += "      nothing: it must hold for all values\n";
        }
        text += match &judged.outcome {
            Outcome::Proven(_) | Outcome::ForEvery(_) | Outcome::Scales(_) => "    Proof\n",
            Outcome::Refuted(_) | Outcome::ScalesNot(..) => "    Counterexample\n",
            _ => "    Outcome\n",
        };
        for line in evidence {
            text += &format!("      {line}\n");
        }
        if let Some((head, lines)) = self.family_lines(entry, judged) {
            text += &format!("    {head}\n");
            for line in lines {
                text += &format!("      {line}\n");
            }
        }
        text
    }

    /// The values, every premise at them, what else is given, and the goal's two sides.
    fn witness(&self, entry: &Entry, refuted: &Refuted) -> Vec<String> {
        let claim = refuted.claim();
        let point = Point::new(claim, refuted.witness());
        let mut lines: Vec<String> = point
            .values()
            .into_iter()
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        lines.extend(point.remark().map(|said| format!("({said})")));
        for &position in &refuted.witness().unfold {
            if let Some(hypothesis) = claim.hypotheses.get(position) {
                lines.push(format!(
                    "with {} put in",
                    plain_formula(&hypothesis.formula)
                ));
            }
        }
        if !claim.hypotheses.is_empty() {
            lines.push("Every premise is true there:".into());
        }
        let premises = claim.hypotheses.iter().map(|premise| &*premise.formula);
        let premises = premises.filter(|formula| !is_idle(formula));
        lines.extend(premises.map(|formula| evaluated(&point, formula)));
        let besides = true_besides(self.derivation, entry.equation, refuted);
        if !besides.is_empty() {
            lines.push("So is what is given before and not cited:".into());
        }
        for (at, formula) in &besides {
            let from = paint(DIM, &self.name(*at));
            lines.push(format!("{}   {from}", evaluated(&point, formula)));
        }
        lines.push("and what was to be shown is false:".into());
        lines.push(evaluated(&point, &claim.goal));
        lines
    }

    /// Where a hypothesis comes from, with its place.
    fn origin(&self, source: Source) -> String {
        match source {
            Source::Equation(at) => format!("{}, {}", self.name(at), self.place(at)),
            Source::Local(page, at) => {
                let local = self.derivation.local(page, at);
                let how = if local.is_let { "let" } else { "assumed" };
                format!("{how}, {}", self.place_of(page, local.span))
            }
            Source::Step => "shown or supposed in the same statement".into(),
            Source::Taken => "taken so, as it is meant".into(),
            Source::Propagation => words::PROPAGATION.into(),
            Source::Nature => words::NATURE.into(),
        }
    }
}

/// The declared domains that a claim uses, each with whose it is.
pub(super) fn domains(claim: &Claim) -> Vec<(&Symbol, String)> {
    let symbols = claim.domains.iter().map(|(s, d)| (words::symbol(s), s, d));
    let elements = claim
        .sequences
        .iter()
        .map(|(s, d)| (format!("{}_i", words::symbol(s)), s, d));
    let mut lines = Vec::new();
    for (name, symbol, domain) in symbols.chain(elements) {
        let term = crate::algebra::Expr::Symbol(symbol.clone());
        let own = words::symbol(symbol);
        let mut said: Vec<String> = domain
            .formulas(&term)
            .iter()
            .map(|f| plain_formula(f).replacen(&own, &name, 1))
            .collect();
        if domain.integer {
            said.push(format!("{name} an integer"));
        }
        if domain.constant {
            said.push(format!("{name} constant"));
        }
        if !said.is_empty() {
            lines.push((symbol, said.join(", ")));
        }
    }
    lines
}

/// A relation with the values of both its sides.
fn evaluated(point: &Point<'_>, formula: &Formula) -> String {
    let shown = plain_formula(formula);
    match point.sides(formula) {
        Some((left, right)) => {
            format!(
                "  {shown}:  left {}, right {}",
                left.equated(),
                right.equated()
            )
        }
        None => match point.values_of(formula) {
            none if none.is_empty() => format!("  {shown}"),
            values => format!("  {shown}:  {values}"),
        },
    }
}

/// The values of an assignment alone.
pub(super) fn assigned(at: &crate::kernel::Assignment) -> Vec<String> {
    let empty = Claim {
        domains: Map::new(),
        sequences: Map::new(),
        hypotheses: Vec::new(),
        goal: crate::algebra::Formula::nonzero(crate::algebra::Expr::integer(1)),
    };
    let values = Point::new(&empty, at).values().into_iter();
    values
        .map(|(name, value)| format!("{name} = {value}"))
        .collect()
}
