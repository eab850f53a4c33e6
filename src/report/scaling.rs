//! The evidence about scaling relations: exponents in a table, two situations side by side.

use crate::algebra::{Expr, Formula, Rational};
use crate::audit::Judged;
use crate::kernel::{Claim, Combination, Product, Rows, Scales, ScalesNot, Size};
use crate::notation::{latex, latex_formula, plain, plain_formula};
use crate::search::{Repair, kept_hypotheses};

use super::Report;
use crate::sorted::{self, Map};

impl Report<'_> {
    /// A proof so that it can be redone on paper: a row of exponents for each premise, and the sum of rows that
    /// the goal is.
    pub(super) fn scaling_proof(&self, judged: &Judged, proven: &Scales) -> Vec<String> {
        let Ok(mut rows) = Rows::new(proven.claim()) else {
            return vec!["the certificate cannot be written out".into()];
        };
        let hypotheses = &proven.claim().hypotheses;
        let mut table = Table::default();
        for (at, row) in rows.rows.iter().enumerate() {
            let Some(row) = row else { continue };
            let name = match hypotheses.get(at) {
                Some(own) => self.premise(judged, at, &own.formula),
                None => "the integral runs over it".into(),
            };
            table.push(format!("[{}]", at + 1), rows.varying(&row.product), name);
        }
        let mut sums = Vec::new();
        let mut number = rows.rows.len();
        for alike in &proven.proof().alike {
            let Ok((parts, row)) = rows.compound(&alike.term) else {
                continue;
            };
            for (part, combination) in parts.iter().zip(&alike.combinations) {
                let part = exponents_written(&rows.varying(part));
                sums.push(format!("{part} ~ 1, for it is {}", written(combination)));
            }
            number += 1;
            let name = format!("so {} scales as a product", plain(&alike.term));
            table.push(format!("[{number}]"), rows.varying(&row.product), name);
        }
        let goal = rows.varying(&rows.goal);
        if goal.is_empty() {
            return vec!["Both sides are the same product of powers, but for a number.".into()];
        }
        table.push("goal".into(), goal, "left side over right side".into());
        let mut lines =
            vec!["Exponents of left side over right side; each row is constant:".to_owned()];
        lines.extend(table.lines());
        lines.extend(sums);
        lines.push(format!("goal = {}", written(&proven.proof().combination)));
        lines
    }

    /// The same for a relation that follows instead of one with more premises.
    pub(super) fn scaling_proof_of(
        &self,
        judged: &Judged,
        larger: &Claim,
        proven: &Scales,
    ) -> Vec<String> {
        let kept = kept_hypotheses(larger, proven).into_iter();
        let assumed = kept.filter_map(|at| judged.assumed.get(at).cloned());
        let judged = Judged {
            assumed: assumed.collect(),
            ..judged.clone()
        };
        self.scaling_proof(&judged, proven)
    }

    /// `double v_0: left ×2^(11/5), right ×2^(6/5)`.
    pub(super) fn in_situations(&self, judged: &Judged, refuted: &ScalesNot) -> String {
        let (left, right) = sides(refuted, &judged.goal.formula);
        let unknown = || "changes".to_owned();
        format!(
            "{}: left {}, right {}",
            changed(refuted),
            left.unwrap_or_else(unknown),
            right.unwrap_or_else(unknown),
        )
    }
}

/// Everything that changes, every premise, and the goal.
pub(super) fn situations(refuted: &ScalesNot) -> Vec<String> {
    let claim = refuted.claim();
    let mut lines = vec![format!("Let {}.", grown(refuted).join(", "))];
    if !claim.hypotheses.is_empty() {
        lines.push("Every premise stays true:".into());
    }
    for (at, hypothesis) in claim.hypotheses.iter().enumerate() {
        let shown = plain_formula(&hypothesis.formula);
        let aside = refuted.situations().aside.contains(&at);
        lines.push(match sides(refuted, &hypothesis.formula) {
            _ if aside => format!("  {shown}:  says only what its left side is"),
            (Some(left), Some(right)) => format!("  {shown}:  left {left}, right {right}"),
            _ => format!("  {shown}"),
        });
    }
    lines.push("and what was to be shown does not:".into());
    let shown = plain_formula(&claim.goal);
    let (left, right) = sides(refuted, &claim.goal);
    let unknown = || "changes".to_owned();
    lines.push(format!(
        "  {shown}:  left {}, right {}",
        left.unwrap_or_else(unknown),
        right.unwrap_or_else(unknown)
    ));
    let first = refuted.situations().values.iter();
    let told: Vec<String> = first
        .filter(|(_, (first, _))| !first.is_one().unwrap_or(false))
        .map(|(quantity, (first, _))| format!("{} = {}", plain(quantity), size(first)))
        .collect();
    lines.push(match told.is_empty() {
        true => "In the first situation every quantity is 1.".into(),
        false => format!(
            "In the first situation {}; all other quantities are 1.",
            told.join(", ")
        ),
    });
    lines
}

/// Each quantity that changes, with its factor.
pub(super) fn grown(refuted: &ScalesNot) -> Vec<String> {
    let all = growths(refuted).into_iter();
    all.map(|(quantity, growth)| format!("{} {}", plain(&quantity), factor(&growth)))
        .collect()
}

/// By LaTeX name, each quantity in the first and in the second situation.
pub(super) fn values(refuted: &ScalesNot) -> Map<String, Vec<String>> {
    let all = refuted.situations().values.iter();
    all.map(|(quantity, (first, second))| {
        let name = latex(quantity);
        (name, vec![size(first), size(second)])
    })
    .collect()
}

/// What follows instead, as LaTeX.
pub(super) fn repaired(refuted: &ScalesNot, repair: &Repair) -> String {
    let written = latex_formula(&repair.proven.claim().goal);
    let among = match repair.one_of_many {
        true => ", among others: the premises relate the quantities on the right to one another",
        false => "",
    };
    let only = match differing(refuted, repair).as_slice() {
        [only] => format!("; only the exponent of `{}` differs", latex(only)),
        _ => String::new(),
    };
    format!("what follows is `{written}`{among}{only}")
}

/// The quantities that have another exponent on the right side of what follows.
fn differing(refuted: &ScalesNot, repair: &Repair) -> Vec<Expr> {
    // The sides are read without the premises.
    let right = |claim: &Claim| {
        let bare = Claim {
            hypotheses: Vec::new(),
            ..claim.clone()
        };
        Rows::new(&bare).map(|rows| rows.sides.1.exponents)
    };
    let (Ok(own), Ok(meant)) = (right(refuted.claim()), right(repair.proven.claim())) else {
        return Vec::new();
    };
    let mut all: Vec<Expr> = own.keys().chain(meant.keys()).cloned().collect();
    sorted::sort(&mut all);
    all.dedup();
    all.retain(|quantity| own.get(quantity) != meant.get(quantity));
    all
}

/// `what follows: …` in a line.
pub(super) fn repaired_plainly(repair: &Repair) -> String {
    format!(
        "what follows is {}",
        plain_formula(&repair.proven.claim().goal)
    )
}

fn growths(refuted: &ScalesNot) -> Vec<(Expr, Size)> {
    let all = refuted.situations().values.iter();
    all.map(|(quantity, (first, second))| (quantity.clone(), second.over(first)))
        .filter(|(_, growth)| !growth.is_one().unwrap_or(false))
        .collect()
}

/// What is changed of one's own accord: what is on the right side of the goal, or else not on its left.
fn changed(refuted: &ScalesNot) -> String {
    let growths = growths(refuted);
    let Formula::Relation { left, right, .. } = &refuted.claim().goal else {
        return String::new();
    };
    let inside = |term: &Expr, quantity: &Expr| term.any(&|part| part == quantity);
    let on = |test: &dyn Fn(&Expr) -> bool| -> Vec<&(Expr, Size)> {
        growths.iter().filter(|(q, _)| test(q)).collect()
    };
    let mut chosen = on(&|q| inside(right, q));
    if chosen.is_empty() {
        let two = Size::from(Rational::from(2));
        chosen = on(&|q| !inside(left, q));
        if let Some(doubled) = chosen.iter().find(|(_, growth)| *growth == two) {
            chosen = vec![*doubled];
        }
    }
    if chosen.is_empty() {
        chosen = on(&|_| true);
    }
    let two = Size::from(Rational::from(2));
    match chosen.as_slice() {
        [(quantity, growth)] if *growth == two => format!("double {}", plain(quantity)),
        all => {
            let all = all.iter();
            let said: Vec<String> = all
                .map(|(quantity, growth)| format!("{} {}", plain(quantity), factor(growth)))
                .collect();
            format!("with {}", said.join(", "))
        }
    }
}

/// The factors by which the sides of a relation grow.
fn sides(refuted: &ScalesNot, formula: &Formula) -> (Option<String>, Option<String>) {
    let Formula::Relation { left, right, .. } = formula else {
        return (None, None);
    };
    let of = |term: &Expr| refuted.growth(term).map(|growth| factor(&growth));
    (of(left), of(right))
}

/// `×2^(6/5)`.
fn factor(growth: &Size) -> String {
    format!("×{}", size(growth))
}

/// A size in its simplest form.
fn size(value: &Size) -> String {
    if let Ok(Some(value)) = value.as_rational() {
        return value.to_string();
    }
    let one = Rational::one();
    let power = |base: String, exponent: &Rational| match exponent {
        e if *e == one => base,
        e if e.is_integer() && !e.is_negative() => format!("{base}^{e}"),
        e => format!("{base}^({e})"),
    };
    let powers = value.powers.iter().map(|(base, exponent)| {
        let base = match base.is_integer() {
            true => base.to_string(),
            false => format!("({base})"),
        };
        power(base, exponent)
    });
    let mut all: Vec<String> = powers.collect();
    if !value.pi.is_zero() {
        all.push(power("π".into(), &value.pi));
    }
    all.join(" · ")
}

/// `[1] + 2/5 [3]`.
fn written(combination: &Combination) -> String {
    let mut text = String::new();
    for (at, coefficient) in combination {
        let sign = match (text.is_empty(), coefficient.is_negative()) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        };
        let number = match coefficient.abs() {
            one if one.is_one() => String::new(),
            other => format!("{other} "),
        };
        text += &format!("{sign}{number}[{}]", at + 1);
    }
    match text.is_empty() {
        true => "nothing".into(),
        false => text,
    }
}

fn exponents_written(exponents: &Map<Expr, Rational>) -> String {
    let product = Product {
        exponents: exponents.clone(),
        ..Product::default()
    };
    let all = product
        .exponents
        .iter()
        .map(|(quantity, exponent)| match exponent.is_one() {
            true => plain(quantity),
            false => format!("{}^({exponent})", plain(quantity)),
        });
    all.collect::<Vec<_>>().join(" ")
}

/// Rows of exponents in columns.
#[derive(Default)]
struct Table {
    rows: Vec<(String, Map<Expr, Rational>, String)>,
}

impl Table {
    fn push(&mut self, number: String, row: Map<Expr, Rational>, name: String) {
        self.rows.push((number, row, name));
    }

    fn lines(&self) -> Vec<String> {
        let mut columns: Vec<&Expr> = Vec::new();
        for (_, row, _) in self.rows.iter().rev() {
            for quantity in row.keys() {
                if !columns.contains(&quantity) {
                    columns.push(quantity);
                }
            }
        }
        let cell = |row: &Map<Expr, Rational>, column: &Expr| {
            let exponent = row.get(column);
            exponent.map_or_else(|| "·".to_owned(), |e| e.to_string().replace('-', "−"))
        };
        let names: Vec<String> = columns.iter().map(|c| plain(c)).collect();
        let widths: Vec<usize> = columns
            .iter()
            .zip(&names)
            .map(|(column, name)| {
                let cells = self.rows.iter().map(|r| cell(&r.1, column).chars().count());
                cells.chain([name.chars().count()]).max().unwrap_or(0)
            })
            .collect();
        let numbers = self.rows.iter().map(|r| r.0.chars().count()).max();
        let first = numbers.unwrap_or(0);
        let line = |number: &str, cells: &[String], name: &str| {
            let mut text = format!("  {number:<first$}");
            for (cell, &width) in cells.iter().zip(&widths) {
                text += &format!("  {cell:>width$}");
            }
            format!("{text}   {name}").trim_end().to_owned()
        };
        let mut lines = vec![line("", &names, "")];
        for (number, row, name) in &self.rows {
            let cells: Vec<String> = columns.iter().map(|c| cell(row, c)).collect();
            lines.push(line(number, &cells, name));
        }
        lines
    }
}
