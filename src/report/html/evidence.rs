//! What folds out below an equation: the claim as it was understood, its premises, and proof or counterexample.

use crate::audit::{Entry, Judged, Outcome, is_idle, true_besides};
use crate::derivation::Source;
use crate::kernel::{Claim, Proven, Refuted};
use crate::notation::{escape, latex_statement};
use crate::report::evidence::Point;
use crate::report::words::unplaced;
use crate::report::{explain, family, implied, scaling, uncoloured};

use super::{Page, words};

impl Page<'_> {
    pub(super) fn evidence(&self, entry: &Entry) -> String {
        let report = self.report;
        let equation = report.equation(entry.equation);
        let document = &report.derivation.pages[equation.page].document;
        let mut text = String::from("<dl class=\"facts\">\n");
        let mut fact = |name: &str, value: String| {
            text += &format!("<div><dt>{name}</dt><dd>{value}</dd></div>\n");
        };
        let typed = |latex: &str| format!("<code class=\"tex\">{}</code>", escape(latex));
        fact("at", escape(&report.place(entry.equation)));
        fact("written", typed(document.text(equation.body)));
        if let Some(statement) = report.statement(entry) {
            fact("understood", typed(&latex_statement(statement)));
        }
        fact("said to be", entry.kind.word().to_owned());
        match report.conflict(entry) {
            Some(conflict) => {
                for (name, said) in report.dimensions_said(conflict) {
                    fact(name, format!("<pre>{}</pre>", escape(&said)));
                }
            }
            None => {
                let dimensions: Vec<String> = report
                    .dimensions(entry)
                    .iter()
                    .map(|d| words::scripted(d))
                    .collect();
                if !dimensions.is_empty() {
                    fact("dimension", dimensions.join("; "));
                }
            }
        }
        for aside in entry
            .notes
            .iter()
            .filter_map(|note| report.aside(entry.equation, note))
        {
            fact("note", words::ticked(&aside));
        }
        let replay = report.replay(entry.equation);
        fact("replay", format!("<code>{}</code>", escape(&replay)));
        text += "</dl>\n";
        if let Some(model) = &entry.model {
            let values = explain::assigned(model.point());
            text += &format!(
                "<p>All that is given with it can be true together, for instance at {}.</p>\n",
                words::scripted(&values.join(", "))
            );
        }
        let numeric = report.numeric_lines(entry);
        if !numeric.is_empty() {
            text += &preformatted(&uncoloured(&numeric));
        }
        for step in 0..entry.judged.len() {
            text += &self.step(entry, step);
        }
        text + &self.repair(entry)
    }

    fn step(&self, entry: &Entry, step: usize) -> String {
        let (judged, steps) = (&entry.judged[step], entry.judged.len());
        let head = match steps {
            1 => "To show".to_owned(),
            _ => format!("Step {} of {steps}", step + 1),
        };
        let mut text = format!(
            "<div class=\"step\">\n<p class=\"goal\"><span class=\"what\">{head}</span> <span class=\"wide\">{}</span></p>\n",
            words::formula(&judged.goal.formula)
        );
        let (claim, evidence) = match &judged.outcome {
            Outcome::Stated => {
                return text + "<p>It is taken as given: nothing to show.</p>\n</div>\n";
            }
            Outcome::Defined => {
                return text
                    + "<p>It defines a symbol that has not occurred before: nothing to show.</p>\n</div>\n";
            }
            Outcome::Proven(proven) => (Some(proven.claim()), self.proof(judged, proven)),
            Outcome::ForEvery(holds) => {
                let lines = self.report.proof_for_every(judged, holds);
                (Some(&holds.claim().claim), folded("Proof", &lines))
            }
            Outcome::Refuted(refuted) => {
                let shown = self.counterexample(entry, refuted) + &self.family(entry, judged);
                (Some(refuted.claim()), shown)
            }
            Outcome::Scales(proven) => {
                let lines = self.report.scaling_proof(judged, proven);
                (Some(proven.claim()), folded("Proof", &lines))
            }
            Outcome::ScalesNot(refuted, repair) => {
                let mut shown = folded("Counterexample", &scaling::situations(refuted));
                if let Some(repair) = repair {
                    let goal = &repair.proven.claim().goal;
                    shown += &format!(
                        "<p>What follows instead is <span class=\"wide\">{}</span>.</p>\n",
                        words::formula(goal)
                    );
                    let claim = refuted.claim();
                    let lines = self.report.scaling_proof_of(judged, claim, &repair.proven);
                    shown += &folded("Proof", &lines);
                }
                (Some(refuted.claim()), shown)
            }
            Outcome::Open(stop) => {
                let reason = match stop.reason.is_empty() {
                    true => "nothing was found",
                    false => &stop.reason,
                };
                let tried = match stop.tried {
                    0 => String::new(),
                    1 => " (1 point tried)".into(),
                    tried => format!(" ({tried} points tried)"),
                };
                let shown = format!("<p>Undecided: {}{tried}.</p>\n", words::ticked(reason));
                (None, shown)
            }
        };
        text += &self.premises(entry, judged, claim);
        text + &evidence + "</div>\n"
    }

    /// What the claim was judged from, each with a way to where it stands.
    fn premises(&self, entry: &Entry, judged: &Judged, claim: Option<&Claim>) -> String {
        let mut items: Vec<String> = Vec::new();
        for assumed in &judged.assumed {
            let from = match assumed.source {
                Source::Equation(at) => format!(
                    "<a href=\"#{}\">{}</a>",
                    self.anchors.equation(at),
                    escape(&self.report.name(at))
                ),
                Source::Local(page, at) => {
                    let local = self.report.derivation.local(page, at);
                    let how = if local.is_let { "let" } else { "assumed" };
                    format!("{how}, {}", escape(&self.report.place_of(page, local.span)))
                }
                Source::Step => "the same statement".into(),
                of_no_place => unplaced(of_no_place).into(),
            };
            let formula = words::formula(&assumed.formula);
            items.push(format!(
                "<span class=\"wide\">{formula}</span> <span class=\"from\">{from}</span>"
            ));
        }
        let domains = claim.map(|claim| self.report.domains(entry, judged, claim));
        for (line, by) in domains.unwrap_or_default() {
            items.push(format!(
                "{} <span class=\"from\">{}</span>",
                words::scripted(&line),
                escape(&by)
            ));
        }
        match items.is_empty() {
            true => "<p>From nothing: it must hold for all values.</p>\n".into(),
            false => format!(
                "<p class=\"what\">From</p>\n<ul class=\"premises\">\n<li>{}</li>\n</ul>\n",
                items.join("</li>\n<li>")
            ),
        }
    }

    /// The values, and both sides of every premise, of what else is given, and of the goal at them.
    fn counterexample(&self, entry: &Entry, refuted: &Refuted) -> String {
        let claim = refuted.claim();
        let point = Point::new(claim, refuted.witness());
        let values: Vec<String> = point
            .values()
            .into_iter()
            .map(|(name, value)| {
                format!(
                    "<span class=\"value\">{} = {}</span>",
                    words::scripted(&name),
                    words::scripted(&value)
                )
            })
            .collect();
        let mut text = String::from("<p class=\"what\">Counterexample</p>\n");
        if !values.is_empty() {
            text += &format!("<p class=\"values\">{}</p>\n", values.join(", "));
        }
        if let Some(said) = point.remark() {
            text += &format!("<p>{}.</p>\n", escape(&words::capital(&said)));
        }
        text += "<div class=\"scroll\"><table>\n<thead><tr><th scope=\"col\">at this point</th><th scope=\"col\">left</th>\
                 <th scope=\"col\">right</th><th scope=\"col\"></th></tr></thead>\n<tbody>\n";
        let premises = claim.hypotheses.iter().map(|h| (&*h.formula, "true"));
        let premises = premises.filter(|(formula, _)| !is_idle(formula));
        let besides = true_besides(self.report.derivation, entry.equation, refuted);
        let besides = besides.iter().map(|(_, formula)| (formula, "true"));
        for (formula, truth) in premises.chain(besides).chain([(&claim.goal, "false")]) {
            let (left, right) = match point.sides(formula) {
                Some((left, right)) => (left.to_string(), right.to_string()),
                None => (String::new(), String::new()),
            };
            text += &format!(
                "<tr class=\"{truth}\"><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{truth}</td></tr>\n",
                words::formula(formula),
                words::scripted(&left),
                words::scripted(&right)
            );
        }
        text + "</tbody>\n</table></div>\n"
    }

    /// A counterexample for every number: what everything is in it, and all that was proved of it.
    fn family(&self, entry: &Entry, judged: &Judged) -> String {
        let Some(found) = self.report.family(entry, judged) else {
            return String::new();
        };
        let values: Vec<String> = family::values(&found.fails)
            .iter()
            .map(|own| format!("<span class=\"value\">{}</span>", words::scripted(own)))
            .collect();
        let range = words::scripted(&family::range(&found.fails));
        let mut text = format!(
            "<p class=\"what\">Counterexample for {range}</p>\n<p class=\"values\">{}</p>\n",
            values.join(", ")
        );
        text += "<div class=\"scroll\"><table>\n<thead><tr><th scope=\"col\">at all of them</th><th scope=\"col\">is</th>\
                 <th scope=\"col\"></th><th scope=\"col\"></th></tr></thead>\n<tbody>\n";
        let mut proofs = Vec::new();
        let checks = family::checks(&found);
        let premises = [&checks.possible, &checks.premises, &checks.besides];
        let premises = premises.into_iter().flatten().map(|shown| (shown, "true"));
        let goal = checks.goal.iter().map(|shown| (shown, "false"));
        for (shown, truth) in premises.chain(goal) {
            let proved = &shown.proven.claim().goal;
            let reason = family::at_sight(shown.proven);
            if reason.is_none() {
                proofs.extend(self.report.proof_of(shown.proven));
            }
            let (of, proved) = match shown.of {
                Some(of) => (words::formula(of), words::formula(proved)),
                None => (words::formula(proved), String::new()),
            };
            text += &format!(
                "<tr class=\"{truth}\"><th scope=\"row\">{of}</th><td>{proved}</td><td>{}</td><td>{truth}</td></tr>\n",
                words::scripted(&reason.unwrap_or_default()),
            );
        }
        text += "</tbody>\n</table></div>\n";
        if !proofs.is_empty() {
            text += &folded("Proof", &proofs);
        }
        let first = words::scripted(&family::first(&found.fails));
        text + &format!("<p>The first is {first}.</p>\n")
    }

    fn proof(&self, judged: &Judged, proven: &Proven) -> String {
        folded("Proof", &self.report.proof(judged, proven))
    }

    /// What follows instead, and what would have to be supposed.
    fn repair(&self, entry: &Entry) -> String {
        let mut text = String::new();
        if !entry.missing.is_empty() {
            let missing: Vec<String> = entry.missing.iter().map(words::formula).collect();
            text += &format!(
                "<p class=\"repair\">It follows if also {}.</p>\n",
                missing.join(", ")
            );
        }
        if let Some((proven, difference)) = implied::instead_apart(entry) {
            text += &format!(
                "<p class=\"repair\">What follows instead is <span class=\"wide\">{}</span>{}.</p>\n",
                words::formula(&proven.claim().goal),
                words::scripted(&difference)
            );
            if let Some((judged, _)) = entry.refuted() {
                text += &self.proof(judged, proven);
            }
        }
        text
    }
}

/// Lines under a heading, as they are.
fn folded(head: &str, lines: &[String]) -> String {
    format!(
        "<p class=\"what\">{head}</p>\n{}",
        preformatted(&lines.join("\n"))
    )
}

fn preformatted(text: &str) -> String {
    format!("<pre>{}</pre>\n", words::scripted(text.trim_matches('\n')))
}
