//! The vocabulary: which LaTeX commands mean something here.

mod refused;
mod unread;

use super::lexer::is_space;
use crate::algebra::{Function, Relation};
pub(super) use refused::complaint;
use refused::is_refused;

/// Commands that are letters, and how a terminal shows them.
pub(super) const LETTERS: &[(&str, &str)] = &[
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ϵ"),
    ("varepsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("vartheta", "ϑ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("varkappa", "ϰ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("varpi", "ϖ"),
    ("rho", "ρ"),
    ("varrho", "ϱ"),
    ("sigma", "σ"),
    ("varsigma", "ς"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "ϕ"),
    ("varphi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Upsilon", "Υ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
    ("ell", "ℓ"),
    ("hbar", "ħ"),
];

/// Commands that decorate one letter and belong to its name, and the combining mark a terminal shows.
pub(super) const ACCENTS: &[(&str, &str)] = &[
    ("dot", "\u{307}"),
    ("ddot", "\u{308}"),
    ("bar", "\u{304}"),
    ("overline", "\u{305}"),
    ("hat", "\u{302}"),
    ("widehat", "\u{302}"),
    ("tilde", "\u{303}"),
    ("widetilde", "\u{303}"),
    ("vec", "\u{20d7}"),
    ("check", "\u{30c}"),
    ("breve", "\u{306}"),
    ("mathring", "\u{30a}"),
    ("mathbf", ""),
    ("boldsymbol", ""),
    ("bm", ""),
    ("mathcal", ""),
    ("mathit", ""),
    ("mathsf", ""),
    ("mathbb", ""),
    ("mathscr", ""),
    ("mathfrak", ""),
];

/// Commands that may stand in a subscript, beside the letters.
pub(super) const SUBSCRIPTS: &[(&str, &str)] = &[
    ("max", "max"),
    ("min", "min"),
    ("infty", "∞"),
    ("prime", "′"),
    ("parallel", "∥"),
    ("perp", "⊥"),
    ("odot", "⊙"),
    ("oplus", "⊕"),
    ("times", "×"),
    ("uparrow", "↑"),
    ("downarrow", "↓"),
    ("leftarrow", "←"),
    ("rightarrow", "→"),
];

/// Commands that only move ink about, besides those that leave space. They mean nothing, so ignoring them misreads nothing.
pub(super) const SPACING: &[&str] = &[
    "displaystyle",
    "textstyle",
    "scriptstyle",
    "nonumber",
    "notag",
    "limits",
    "nolimits",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigl",
    "Bigl",
    "biggl",
    "Biggl",
    "bigr",
    "Bigr",
    "biggr",
    "Biggr",
    "ensuremath",
    "xspace",
    "allowbreak",
    "nobreak",
    "qed",
    "qedhere",
];

/// Commands with a meaning of their own in the grammar.
const GRAMMAR: &[&str] = &[
    "frac",
    "tfrac",
    "dfrac",
    "sfrac",
    "cfrac",
    "binom",
    "tbinom",
    "dbinom",
    "sqrt",
    "cdot",
    "times",
    "left",
    "right",
    "lvert",
    "rvert",
    "vert",
    "lceil",
    "rceil",
    "lfloor",
    "rfloor",
    "lbrace",
    "rbrace",
    "lbrack",
    "rbrack",
    "langle",
    "rangle",
    "sum",
    "int",
    "lim",
    "to",
    "infty",
    "boxed",
    "underbrace",
    "overbrace",
    "text",
    "mathrm",
    "operatorname",
    "rm",
    "bf",
    "it",
    "sf",
    "cal",
    "num",
    "qty",
    "SI",
    "unit",
    "si",
    "stackrel",
    "overset",
    "not",
    "checkmark",
    "cmark",
    "xmark",
    "quad",
    "qquad",
    "begin",
    "end",
    "tag",
    "label",
    "dots",
    "cdots",
    "ldots",
    "prime",
    "dagger",
    "Rightarrow",
    "implies",
    "Longrightarrow",
    "iff",
    "Leftrightarrow",
    "Longleftrightarrow",
    "therefore",
    "underline",
];

/// What a command says as a relation sign.
pub(super) fn relation(command: &str) -> Option<Relation> {
    Some(match command {
        "neq" | "ne" => Relation::NotEqual,
        "lt" => Relation::Less,
        "gt" => Relation::Greater,
        "le" | "leq" | "leqslant" | "leqq" => Relation::LessOrEqual,
        "ge" | "geq" | "geqslant" | "geqq" => Relation::GreaterOrEqual,
        "sim" => Relation::Scales,
        "propto" => Relation::Proportional,
        "approx" | "simeq" | "approxeq" => Relation::Approximately,
        "ll" => Relation::MuchLess,
        "gg" => Relation::MuchGreater,
        "equiv" | "coloneqq" | "coloneq" | "triangleq" => Relation::Equal,
        _ => return None,
    })
}

const RELATIONS: &[&str] = &[
    "neq", "leq", "leqslant", "geq", "geqslant", "sim", "propto", "approx", "simeq", "equiv",
    "coloneqq",
];

/// The function that a command names.
pub(super) fn function(command: &str) -> Option<Function> {
    Some(match command {
        "sin" => Function::Sin,
        "cos" => Function::Cos,
        "tan" => Function::Tan,
        "arcsin" => Function::ArcSin,
        "arccos" => Function::ArcCos,
        "arctan" => Function::ArcTan,
        "exp" => Function::Exp,
        "ln" | "log" => Function::Ln,
        _ => return None,
    })
}

/// Whether a command names a function: one of these, or one that is made of them, as `\cot` is.
pub(super) fn is_function(command: &str) -> bool {
    function(command).is_some()
        || is_hyperbolic(command)
        || is_area(command)
        || matches!(command, "cot" | "sec" | "csc" | "lg")
}

/// Whether a command names a hyperbolic function, which is read as what it is in exponentials.
pub(super) fn is_hyperbolic(command: &str) -> bool {
    let names = ["sinh", "cosh", "tanh", "coth", "sech", "csch"];
    names.contains(&command)
}

/// Whether a word names the inverse of a hyperbolic function, which is read as what it is in logarithms.
pub(super) fn is_area(command: &str) -> bool {
    let names = [
        "arsinh", "arcsinh", "arcosh", "arccosh", "artanh", "arctanh",
    ];
    names.contains(&command)
}

/// Whether an arrow says what something tends to.
pub(super) fn tends(command: &str) -> bool {
    matches!(command, "to" | "rightarrow" | "longrightarrow")
}

const FUNCTIONS: &[&str] = &[
    "sin", "cos", "tan", "cot", "sec", "csc", "arcsin", "arccos", "arctan", "exp", "log", "sinh",
    "cosh", "tanh", "coth", "sech", "csch", "lg",
];

/// Looks a command up in one of the tables of this page.
pub(super) fn find(
    table: &'static [(&'static str, &'static str)],
    command: &str,
) -> Option<&'static str> {
    table
        .iter()
        .find(|(name, _)| *name == command)
        .map(|(_, shown)| *shown)
}

/// Whether a command sets one thing over another with a line between.
pub(super) fn is_fraction(command: &str) -> bool {
    matches!(command, "frac" | "tfrac" | "dfrac" | "sfrac" | "cfrac")
}

/// Whether a command is a binomial coefficient.
pub(super) fn is_binomial(command: &str) -> bool {
    matches!(command, "binom" | "tbinom" | "dbinom")
}

/// Upright words that are applied to what follows, and never factors.
const APPLIED: &[&str] = &[
    "Arg", "Bias", "Corr", "Cov", "Det", "Ln", "Log", "SD", "Tr", "Var", "acos", "arccos",
    "arccot", "arcosh", "arcsin", "arctan", "arctg", "arg", "argmax", "argmin", "arsinh", "artanh",
    "asin", "atan", "corr", "cos", "cosh", "cot", "coth", "cov", "csc", "csch", "ctg", "curl",
    "det", "diag", "div", "erf", "erfc", "exp", "grad", "inf", "ld", "lg", "ln", "log", "max",
    "min", "mod", "rot", "sech", "sgn", "sign", "sin", "sinc", "sinh", "sup", "tan", "tanh", "tg",
    "tr", "var",
];

/// The upright word that a name begins with: `Var` in `\text{Var}_1`.
fn word(name: &str) -> Option<&str> {
    let (word, scripts) = name.strip_prefix("\\text{")?.split_once('}')?;
    // `\text{Var}(X)` is a value.
    (!scripts.starts_with(['(', '['])).then_some(word)
}

/// Whether a name is that of an operator, which has no value by itself: `\text{Var}`, `\mathbb{E}`.
pub(super) fn is_applied(name: &str) -> bool {
    let expectation = ["\\mathbb{E}", "\\mathbb{P}"];
    let is_value = |rest: &str| rest.starts_with(['(', '[']);
    let mut rests = expectation.iter().filter_map(|own| name.strip_prefix(own));
    rests.any(|rest| !is_value(rest)) || word(name).is_some_and(|word| APPLIED.contains(&word))
}

/// Whether a name is a word, which before a parenthesis may be a function: `\text{Re}(x + 1)`.
pub(super) fn is_word(name: &str) -> bool {
    word(name).is_some_and(|word| word.chars().count() > 1) || is_applied(name)
}

/// Whether a name before a square bracket is likely to be applied: `E[X^2]`, `\mathcal{F}[f + g]`.
pub(super) fn is_functional(name: &str) -> bool {
    let mut letter = name;
    while let Some((accent, rest)) = letter.strip_prefix('\\').and_then(|l| l.split_once('{')) {
        if matches!(accent, "mathbb" | "mathcal") {
            return true;
        }
        letter = rest;
    }
    letter.starts_with(['E', 'P']) || is_word(name)
}

/// Whether a command begins a factor: a name, a fraction, a delimiter, an operator with what it applies to.
pub(super) fn begins_term(command: &str) -> bool {
    matches!(
        command,
        "sqrt"
            | "boxed"
            | "underline"
            | "underbrace"
            | "overbrace"
            | "sum"
            | "int"
            | "lim"
            | "partial"
            | "left"
            | "lvert"
            | "lceil"
            | "lfloor"
            | "{"
            | "lbrace"
            | "lbrack"
    ) || is_fraction(command)
        || is_binomial(command)
        || is_function(command)
        || find(LETTERS, command).is_some()
        || find(ACCENTS, command).is_some()
}

/// Whether a command is three dots.
pub(super) fn is_dots(command: &str) -> bool {
    matches!(
        command,
        "dots" | "ldots" | "cdots" | "dotsb" | "dotsc" | "dotsm"
    )
}

/// Whether a command of this name is read, or refused with a reason of its own.
pub(crate) fn is_command(name: &str) -> bool {
    known().any(|own| own == name)
        || relation(name).is_some()
        || SPACING.contains(&name)
        || is_space(name)
        || is_refused(name)
}

fn known() -> impl Iterator<Item = &'static str> {
    let tables = [LETTERS, ACCENTS, SUBSCRIPTS]
        .into_iter()
        .flatten()
        .map(|(name, _)| *name);
    let lists = [GRAMMAR, RELATIONS, FUNCTIONS, &["ln", "exp"]]
        .into_iter()
        .flatten()
        .copied();
    tables.chain(lists)
}
