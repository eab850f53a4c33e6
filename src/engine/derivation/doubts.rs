//! What is read as a power or a product and may be meant otherwise: decided here, where the whole page is known, and refused where nothing
//! on it says that the reading is what was meant.

use crate::algebra::{Expr, Formula, Symbol, split_subscript};
use crate::document::Span;
use crate::notation::{
    Choice, Doubt, DoubtKind, Other, Spelt, Statement, SyntaxError, angle_of, argument_of,
};
use crate::sorted::Set;

use super::Equation;
use super::equation::{conditions, formulas};
use super::indices::{self, Letters};

/// The symbols that stand for something on a page.
#[derive(Default)]
pub(super) struct OnPage {
    /// Those of which displays speak as quantities.
    pub quantities: Set<Symbol>,
    /// Those that stand by themselves in the text, as indices may: "where $\mu$ runs from 0 to 3".
    pub spoken_of: Set<Symbol>,
    /// Concentrations, `[\mathrm{A}]`, where they are no units of something.
    pub concentrations: Set<Symbol>,
    /// Those of which sines and cosines are taken where nothing else could be meant: `\sin\theta = x/\ell`.
    pub angles: Set<Symbol>,
    /// Those that begin products of which sines are taken: `\sin \omega t`.
    pub factors: Set<Symbol>,
    /// Those that count, as something comes after each: `F_{t+1}`.
    pub counting: Set<Symbol>,
}

/// Refuses the equations of a page in which something is no power or no product, as far as the page lets one see that.
///
/// `spoken_of` are the symbols that stand by themselves in the text.
pub(super) fn refuse(
    equations: &mut [Equation],
    declared: impl Fn(&Symbol) -> bool,
    spoken_of: impl Iterator<Item = Symbol>,
) {
    let all = || equations.iter().flat_map(Equation::statements);
    if all().all(|statement| statement.doubts.is_empty()) {
        return;
    }
    // What stands in words says nothing of its letters.
    let is_worded = |doubt: &Doubt| {
        matches!(
            doubt.kind,
            DoubtKind::Operator(_) | DoubtKind::Letters { .. }
        )
    };
    let standing = OnPage {
        quantities: standing_in(all().filter(|own| !own.doubts.iter().any(is_worded))),
        spoken_of: spoken_of.collect(),
        concentrations: concentrations_in(all()),
        angles: angles_in(all()),
        factors: factors_in(all()),
        counting: counting_in(all()),
    };
    for equation in equations {
        let statements = equation.statements.iter_mut().flatten();
        statements.for_each(|statement| {
            settle(statement, &standing);
            end_at_spaces(statement, &standing);
        });
        if let Some(error) = doubtful(equation.statements(), &declared, &standing) {
            equation.statements = Err(error);
        }
    }
}

/// Reads `\sin\omega(t - t_0)` as the sine of a product where the page has `\sin\omega t`, and not `\sin\omega`.
fn settle(statement: &mut Statement, standing: &OnPage) {
    let is_factor = |doubt: &Doubt| match &doubt.kind {
        DoubtKind::Angle(own) => !standing.angles.contains(own) && standing.factors.contains(own),
        _ => true,
    };
    let Some(other) = take_other(statement, Choice::Group) else {
        return;
    };
    if statement.doubts.iter().all(is_factor) {
        choose(statement, other);
    }
}

/// Takes away the reading of a statement that makes a choice, if there is one.
fn take_other(statement: &mut Statement, choice: Choice) -> Option<Other> {
    let others = &mut statement.others;
    let at = others.iter().position(|other| other.choice == choice)?;
    Some(others.remove(at))
}

/// Takes a statement as another reading has it. How long an argument of it is remains a choice.
fn choose(statement: &mut Statement, other: Other) {
    let before = std::mem::replace(statement, other.statement);
    statement.others = vec![Other {
        choice: Choice::FirstName,
        span: other.span,
        statement: before,
    }];
}

/// Reads `v \cos\theta\,t` as `(v \cos\theta) t` where the page takes sines or cosines of that angle alone.
fn end_at_spaces(statement: &mut Statement, standing: &OnPage) {
    let mut doubts = statement.doubts.iter();
    let is_angle = |doubt: &Doubt| matches!(&doubt.kind, DoubtKind::Spaced(own) if standing.angles.contains(own));
    if !doubts.any(is_angle) {
        return;
    }
    if let Some(ended) = take_other(statement, Choice::FirstName) {
        choose(statement, ended);
    }
}

/// Why statements that stand together cannot be read as they are, if they cannot; `standing` is what stands for itself on the page.
pub(super) fn doubtful(
    statements: &[Statement],
    declared: &dyn Fn(&Symbol) -> bool,
    standing: &OnPage,
) -> Option<SyntaxError> {
    let mut doubts = statements.iter().flat_map(|own| &own.doubts).peekable();
    doubts.peek()?;
    let letters = Letters::of(statements, declared, standing);
    doubts.find_map(|doubt| match &doubt.kind {
        DoubtKind::Angle(own) => {
            let is_angle = standing.angles.contains(own);
            (!is_angle).then(|| no_end(doubt.span))
        }
        _ => refusal(doubt, &letters),
    })
}

fn refusal(doubt: &Doubt, letters: &Letters) -> Option<SyntaxError> {
    match &doubt.kind {
        DoubtKind::Raised {
            name,
            letters: above,
        } => letters.refusal(name, above, doubt.span),
        DoubtKind::Letters { word, spelt } => {
            let mut own = word.chars().map(|letter| Symbol::new(letter.to_string()));
            let product = match spelt {
                Spelt::Word | Spelt::Unit | Spelt::Remainder => {
                    own.all(|letter| letters.is_known(&letter))
                }
                Spelt::Function(_) | Spelt::Between => {
                    own.all(|letter| letters.is_declared(&letter))
                }
            };
            (!product).then(|| no_product(word, spelt, doubt.span))
        }
        // Asked of the page, not of letters.
        DoubtKind::Angle(_) | DoubtKind::Spaced(_) => None,
        DoubtKind::Applied(name) => letters.stands(name).then(|| no_value(name, doubt.span)),
        DoubtKind::Concentration(name) => {
            let known = letters.is_declared(name) || letters.has_concentrations();
            (!known).then(|| no_concentration(name, doubt.span))
        }
        DoubtKind::Operator(name) => (!letters.is_known(name)).then(|| no_factor(name, doubt.span)),
    }
}

/// The refusal of a sine before a parenthesis.
fn no_end(span: Span) -> SyntaxError {
    SyntaxError {
        span,
        message: "where the argument of this function ends is not clear".to_owned(),
        help: Some("put the argument in parentheses".to_owned()),
    }
}

/// The refusal of a name before brackets that is a quantity elsewhere.
fn no_value(name: &Symbol, span: Span) -> SyntaxError {
    SyntaxError {
        span,
        message: format!(
            "whether `{name}` is applied to what follows, or multiplied by it, is not clear"
        ),
        help: Some(format!(
            "`{name}` is a quantity elsewhere; for what is applied write `\\operatorname{{…}}`"
        )),
    }
}

/// The refusal of a word in brackets that may be the unit of what stands before it.
fn no_concentration(name: &Symbol, span: Span) -> SyntaxError {
    SyntaxError {
        span,
        message: "whether this is a concentration or a unit in brackets is not clear".to_owned(),
        help: Some(format!(
            "leave the brackets around a unit out; for a concentration declare `{name}`"
        )),
    }
}

/// The refusal of a `\Delta` or `\Sigma` that nothing says to be a quantity.
fn no_factor(name: &Symbol, span: Span) -> SyntaxError {
    let (what, help) = match name.name().starts_with("\\Sigma") {
        true => ("a sum", "give the sum a name, `F_{\\text{net}}`"),
        false => (
            "a difference",
            "write the difference out, or give it a name, `\\Delta p`",
        ),
    };
    SyntaxError {
        span,
        message: format!("whether `{name}` is {what} of what follows, or a factor, is not clear"),
        help: Some(format!(
            "{help}; for a product write `{name} \\cdot`, or declare `{name}`"
        )),
    }
}

/// The refusal of letters that spell something.
fn no_product(word: &str, spelt: &Spelt, span: Span) -> SyntaxError {
    let help = match spelt {
        Spelt::Function("sqrt") => "write `\\sqrt{…}`".to_owned(),
        Spelt::Function(name) => format!("write `\\{name}`"),
        Spelt::Between => format!("write `\\text{{ {word} }}`"),
        Spelt::Unit => format!("write `\\,\\mathrm{{{word}}}` for a unit"),
        Spelt::Remainder => {
            "the notation has no remainders: write `a = b + n m` with a whole number `n`".to_owned()
        }
        Spelt::Word => format!("write `\\mathrm{{{word}}}` for a name, `\\text{{…}}` for words"),
    };
    SyntaxError {
        span,
        message: format!("TeX sets `{word}` as a product of single letters, which is hardly meant"),
        help: Some(format!(
            "{help}; for a product leave spaces between the factors"
        )),
    }
}

/// The symbols that stand for quantities in statements: all but those that are seen in exponents of names alone, where they may be indices.
pub(super) fn standing_in<'s>(statements: impl Iterator<Item = &'s Statement>) -> Set<Symbol> {
    let mut found = Set::new();
    for statement in statements {
        let all = formulas(statement).into_iter();
        let all: Vec<Formula> = all.chain(conditions(statement)).collect();
        for term in all.iter().flat_map(Formula::terms) {
            indices::standing(term, &mut found);
        }
        found.extend(statement.runs.iter().map(|run| run.symbol.clone()));
    }
    found
}

/// Whether something in a statement is in doubt.
fn doubts(statement: &Statement, kind: &DoubtKind) -> bool {
    statement.doubts.iter().any(|own| own.kind == *kind)
}

/// The concentrations in statements, but those that may be units.
fn concentrations_in<'s>(statements: impl Iterator<Item = &'s Statement>) -> Set<Symbol> {
    let mut found = Set::new();
    for statement in statements {
        let in_doubt = |name: &Symbol| doubts(statement, &DoubtKind::Concentration(name.clone()));
        symbols_in(std::slice::from_ref(statement), &mut |name| {
            if name.name().starts_with('[') && !in_doubt(name) {
                found.insert(name.clone());
            }
        });
    }
    found
}

/// The symbols of which statements take sines and cosines where it is clear that these are of nothing more.
fn angles_in<'s>(statements: impl Iterator<Item = &'s Statement>) -> Set<Symbol> {
    let mut found = Set::new();
    for statement in statements {
        let in_doubt = |name: &Symbol| doubts(statement, &DoubtKind::Angle(name.clone()));
        for formula in formulas(statement) {
            for term in formula.terms() {
                collect_angles(term, &mut |name| {
                    if !in_doubt(name) {
                        found.insert(name.clone());
                    }
                });
            }
        }
    }
    found
}

fn collect_angles(term: &Expr, see: &mut impl FnMut(&Symbol)) {
    if let Some(name) = angle_of(term) {
        see(name);
    }
    term.children().for_each(|part| collect_angles(part, see));
}

/// The symbols that begin a product of names of which statements take sines, cosines or tangents.
fn factors_in<'s>(statements: impl Iterator<Item = &'s Statement>) -> Set<Symbol> {
    let mut found = Set::new();
    for formula in statements.flat_map(formulas) {
        let terms = formula.terms().into_iter();
        terms.for_each(|term| collect_factors(term, &mut found));
    }
    found
}

fn collect_factors(term: &Expr, found: &mut Set<Symbol>) {
    if let Some(Expr::Product(factors)) = argument_of(term) {
        let mut names = factors.iter().filter(|own| !matches!(own, Expr::Number(_)));
        if let Some(Expr::Symbol(first)) = names.next()
            && let Some(Expr::Symbol(_)) = names.next()
        {
            found.insert(first.clone());
        }
    }
    term.children()
        .for_each(|part| collect_factors(part, found));
}

/// The letters that a number is added to, or taken from, in subscripts: `F_{t+1}`.
fn counting_in<'s>(statements: impl Iterator<Item = &'s Statement>) -> Set<Symbol> {
    let mut found = Set::new();
    for statement in statements {
        symbols_in(std::slice::from_ref(statement), &mut |name| {
            let below = split_subscript(name.name()).map(|(_, below)| below);
            if let Some((letter, number)) = below.and_then(|own| own.split_once(['+', '-'])) {
                let (letter, number) = (letter.trim(), number.trim());
                let counts = !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit());
                if counts && matches!(letter.as_bytes(), [b'a'..=b'z' | b'A'..=b'Z']) {
                    found.insert(Symbol::new(letter));
                }
            }
        });
    }
    found
}

/// All symbols of statements, those with scripts among them.
pub(super) fn symbols_in(statements: &[Statement], see: &mut impl FnMut(&Symbol)) {
    fn look(term: &Expr, see: &mut impl FnMut(&Symbol)) {
        match term {
            Expr::Symbol(symbol) | Expr::Apply(symbol, _) => see(symbol),
            Expr::Element { sequence, index } => {
                see(&Symbol::new(format!("{sequence}_{{{index}}}")))
            }
            _ => {}
        }
        term.children().for_each(|child| look(child, see));
    }
    for formula in statements.iter().flat_map(formulas) {
        formula.terms().into_iter().for_each(|term| look(term, see));
    }
}
