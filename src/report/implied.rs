//! What follows in the place of a failing equation: the slip of the pen undone, or what its premises give, and how
//! far what is printed is from it.

use crate::algebra::{BigRational, Expr, Formula, Symbol};
use crate::audit::Entry;
use crate::derivation::{Kind, Premises};
use crate::kernel::Proven;
use crate::notation::{latex_formula, measured, plain, plain_formula};
use crate::search::{Change, Implied};

use super::{Report, words};

/// What should be read, proved, and how what is printed differs.
struct Instead<'a> {
    proven: &'a Proven,
    difference: String,
}

/// The nearest that follows: one edit away, if there is such a thing.
fn nearest(entry: &Entry) -> Option<Instead<'_>> {
    if let Some(mended) = &entry.mended {
        return Some(Instead {
            proven: &mended.proven,
            difference: format!("{}; {}", under(&mended.under), slip(&mended.change)),
        });
    }
    entry.implied.as_ref().map(|implied| Instead {
        proven: &implied.proven,
        difference: comparison(implied),
    })
}

/// As LaTeX, to be put in the place of what is printed.
pub(super) fn instead(entry: &Entry) -> Option<String> {
    nearest(entry).map(|instead| {
        let written = latex_formula(&instead.proven.claim().goal);
        format!("what follows is `{written}`{}", instead.difference)
    })
}

/// In one line, with its proof.
pub(super) fn instead_plainly(entry: &Entry) -> Option<(String, &Proven)> {
    nearest(entry).map(|instead| {
        let written = plain_formula(&instead.proven.claim().goal);
        let text = format!("what follows is {written}{}", instead.difference);
        (text, instead.proven)
    })
}

/// What follows, and in words how far what is printed is from it: nothing, or `; twice that`.
pub(super) fn instead_apart(entry: &Entry) -> Option<(&Proven, String)> {
    nearest(entry).map(|instead| (instead.proven, instead.difference))
}

/// What would have to be supposed besides.
pub(super) fn supposing(conditions: &[Formula]) -> String {
    let conditions = conditions
        .iter()
        .map(|c| format!("`{}`", latex_formula(c)))
        .collect();
    format!("follows if also {}", words::list(conditions))
}

impl Report<'_> {
    /// The same of what an entry misses, and where the text names it.
    pub(super) fn supposing(&self, entry: &Entry) -> String {
        let text = supposing(&entry.missing);
        let mentioned = self.derivation.mentioned(entry.equation);
        let named = |formula: &Formula| mentioned.iter().find(|(_, said)| said == formula);
        let Some(places) = entry.missing.iter().map(named).collect::<Option<Vec<_>>>() else {
            return text;
        };
        let Some((span, _)) = places.first() else {
            return text;
        };
        let page = self.equation(entry.equation).page;
        let said = entry
            .missing
            .iter()
            .map(|c| format!("${}$", latex_formula(c)));
        format!(
            "{text}; named at {} and not plainly supposed there: write `Let {}.` before the equation",
            self.place_of(page, *span),
            words::list(said.collect()),
        )
    }

    /// Where a new symbol makes a law of what is taken for a step: how to say so.
    pub(super) fn perhaps_law(&self, entry: &Entry) -> Option<String> {
        let equation = self.equation(entry.equation);
        let cites_nothing =
            matches!(&equation.premises, Premises::Cited(cited) if cited.is_empty());
        if !cites_nothing || equation.kind != Kind::Derived || !entry.missing.is_empty() {
            return None;
        }
        let (judged, _) = entry.refuted()?;
        // What speaks of the same on both sides is meant as an identity.
        if let Formula::Relation { left, right, .. } = &judged.goal.formula
            && left.free_symbols() == right.free_symbols()
        {
            return None;
        }
        let named = judged.goal.formula.free_symbols();
        // What a law says of particular things is spoken of.
        let said = judged.assumed.iter().map(|own| own.formula.names());
        let said: Vec<_> = said.collect();
        let is_said = |symbol: &Symbol| said.iter().any(|names| names.contains(symbol));
        let mut new = named.intersection(&equation.introduces);
        let symbol = new.find(|symbol| measured(symbol).is_none() && !is_said(symbol))?;
        let is_latex = self.derivation.pages[equation.page].document.is_latex;
        let directive = if is_latex {
            "% check: law"
        } else {
            "<!-- check: law -->"
        };
        Some(format!(
            "nothing before it speaks of {}; if it is a law, a model or a definition, write `{directive}` above it",
            words::symbol(symbol),
        ))
    }
}

/// What must hold besides.
fn under(conditions: &[Formula]) -> String {
    match conditions {
        [] => String::new(),
        all => format!(
            ", if {}",
            words::list(all.iter().map(plain_formula).collect())
        ),
    }
}

/// What the pen slipped on.
fn slip(change: &Change) -> String {
    match change {
        Change::Sign => "only a sign differs".into(),
        Change::Coefficient => "only a coefficient differs".into(),
        Change::Exponent => "only an exponent differs".into(),
        Change::Exchanged { one, other } => {
            format!(
                "only {} and {} change places",
                words::symbol(one),
                words::symbol(other)
            )
        }
        Change::Inverted => "only a fraction is upside down".into(),
        Change::Relation => "only the relation is turned round".into(),
        Change::Strict => "both sides can be equal".into(),
        Change::Factor => "only a factor differs".into(),
        Change::Summand => "only a summand differs".into(),
        Change::Function => "only a function differs".into(),
        Change::Symbol { printed, meant } => format!(
            "only {} stands for {}",
            words::symbol(printed),
            words::symbol(meant)
        ),
    }
}

fn comparison(implied: &Implied) -> String {
    match &implied.ratio {
        Some(ratio) => format!("; what is printed is {}", times(ratio)),
        None => String::new(),
    }
}

/// `twice that`, `half of that`, `e² times that`.
fn times(ratio: &Expr) -> String {
    let whole = |value: i64| BigRational::from_integer(value.into());
    let is = |term: &Expr, value| matches!(term, Expr::Number(own) if *own == whole(value));
    match ratio {
        Expr::Number(value) if *value == whole(2) => "twice that".into(),
        Expr::Number(value) if *value == whole(-1) => "that with the wrong sign".into(),
        Expr::Number(value) if *value == whole(2).recip() => "half of that".into(),
        Expr::Quotient(above, below) if is(above, 1) && is(below, 2) => "half of that".into(),
        Expr::Sum(_) => format!("({}) times that", plain(ratio)),
        _ => format!("{} times that", plain(ratio)),
    }
}
