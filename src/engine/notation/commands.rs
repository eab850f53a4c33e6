//! The vocabulary: which LaTeX commands mean something here, and what to say about those that do not.

use super::shorthand::is_abbreviation;
use crate::algebra::{Function, Relation};

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
    ("mathbf", ""),
    ("boldsymbol", ""),
    ("bm", ""),
    ("mathcal", ""),
    ("mathit", ""),
    ("mathsf", ""),
    ("mathbb", ""),
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
];

/// Commands that only move ink about. They mean nothing, so ignoring them misreads nothing.
pub(super) const SPACING: &[&str] = &[
    ",",
    ";",
    ":",
    "!",
    " ",
    ">",
    "thinspace",
    "medspace",
    "thickspace",
    "enspace",
    "negthinspace",
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
];

/// Those of them that leave a space on the page, as there is one between a number and its unit.
pub(super) const PRINTED: &[&str] = &[
    ",",
    ";",
    ":",
    " ",
    ">",
    "thinspace",
    "medspace",
    "thickspace",
    "enspace",
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

/// Commands that are understood and refused: what they are called, and what to do instead.
const REFUSED: &[(&str, &str, Option<&str>)] = &[
    (
        "stackrel",
        "only `?`, `!` and citations are read above a relation sign",
        Some("write `\\stackrel{?}{=}`, or say in the text why it is so"),
    ),
    (
        "overset",
        "only `?`, `!` and citations are read above a relation sign",
        Some("write `\\stackrel{?}{=}`, or say in the text why it is so"),
    ),
    ("not", "`\\not` is read only before `=`", None),
    (
        "left",
        "after `\\left` a delimiter is expected: `(`, `[`, `\\{`, `|`, `\\lceil` or `\\lfloor`",
        None,
    ),
    (
        "pm",
        "`\\pm` states two equations at once, which is not read",
        Some("write the two cases as two equations"),
    ),
    (
        "mp",
        "`\\mp` states two equations at once, which is not read",
        Some("write the two cases as two equations"),
    ),
    (
        "partial",
        "`\\partial` is read only in derivatives",
        Some("write `\\frac{\\partial f}{\\partial x}`, or `\\partial_x f`"),
    ),
    (
        "nabla",
        "`\\nabla` is not read: the notation has no vector calculus",
        Some("write it with partial derivatives by coordinates"),
    ),
    (
        "grad",
        "`\\grad` is not read: the notation has no vector calculus",
        Some("write it with partial derivatives by coordinates"),
    ),
    (
        "gradient",
        "`\\gradient` is not read: the notation has no vector calculus",
        Some("write it with partial derivatives by coordinates"),
    ),
    (
        "curl",
        "`\\curl` is not read: the notation has no vector calculus",
        Some("write it with partial derivatives by coordinates"),
    ),
    (
        "divergence",
        "`\\divergence` is not read: the notation has no vector calculus",
        Some("write it with partial derivatives by coordinates"),
    ),
    (
        "laplacian",
        "`\\laplacian` is not read: the notation has no vector calculus",
        Some("write it with partial derivatives by coordinates"),
    ),
    (
        "var",
        "`\\var` is not read: the notation has no variations",
        None,
    ),
    (
        "variation",
        "`\\variation` is not read: the notation has no variations",
        None,
    ),
    (
        "fdv",
        "`\\fdv` is not read: the notation has no variations",
        None,
    ),
    (
        "functionalderivative",
        "`\\functionalderivative` is not read: the notation has no variations",
        None,
    ),
    (
        "ket",
        "`\\ket` is not read: the notation has no states and operators",
        None,
    ),
    (
        "bra",
        "`\\bra` is not read: the notation has no states and operators",
        None,
    ),
    (
        "braket",
        "`\\braket` is not read: the notation has no states and operators",
        None,
    ),
    (
        "ketbra",
        "`\\ketbra` is not read: the notation has no states and operators",
        None,
    ),
    (
        "expval",
        "`\\expval` is not read: the notation has no states and operators",
        None,
    ),
    (
        "ev",
        "`\\ev` is not read: the notation has no states and operators",
        None,
    ),
    (
        "mel",
        "`\\mel` is not read: the notation has no states and operators",
        None,
    ),
    (
        "dyad",
        "`\\dyad` is not read: the notation has no states and operators",
        None,
    ),
    (
        "comm",
        "`\\comm` is not read: the notation has no brackets of operators",
        None,
    ),
    (
        "commutator",
        "`\\commutator` is not read: the notation has no brackets of operators",
        None,
    ),
    (
        "acomm",
        "`\\acomm` is not read: the notation has no brackets of operators",
        None,
    ),
    (
        "anticommutator",
        "`\\anticommutator` is not read: the notation has no brackets of operators",
        None,
    ),
    (
        "pb",
        "`\\pb` is not read: the notation has no brackets of operators",
        None,
    ),
    (
        "poissonbracket",
        "`\\poissonbracket` is not read: the notation has no brackets of operators",
        None,
    ),
    (
        "order",
        "`\\order` is not read: the notation has no orders of magnitude",
        None,
    ),
    (
        "prod",
        "products over an index (`\\prod`) are not read",
        None,
    ),
    (
        "oint",
        "`\\oint` is not read: only definite integrals `\\int_a^b` are",
        None,
    ),
    (
        "iint",
        "`\\iint` is not read: write two definite integrals, one inside the other",
        None,
    ),
    (
        "infty",
        "`\\infty` is no number: it is read only where a limit goes, `\\lim_{x \\to \\infty}`",
        None,
    ),
    ("to", "`\\to` is read only inside `\\lim_{x \\to a}`", None),
    (
        "rightarrow",
        "`\\rightarrow` states no relation that can be checked",
        Some("for an implication write `\\Rightarrow`, for a limit `\\lim_{x \\to a}`"),
    ),
    (
        "color",
        "`\\color` is not read: colours do not belong to the mathematics",
        Some("remove the colour"),
    ),
    (
        "textcolor",
        "`\\textcolor` is not read: colours do not belong to the mathematics",
        Some("remove the colour"),
    ),
    (
        "colorbox",
        "`\\colorbox` is not read: colours do not belong to the mathematics",
        Some("use `\\boxed{…}`"),
    ),
    (
        "cancel",
        "`\\cancel` is not read: whether what is crossed out counts is not clear",
        Some("write the equation after cancelling"),
    ),
    ("in", "`\\in` is not read: the notation has no sets", None),
    (
        "forall",
        "`\\forall` is read before a statement or behind it, and not in it",
        Some("write `x^2 \\geq 0 \\quad \\forall x`"),
    ),
    (
        "exists",
        "`\\exists` is not read: state the quantifier in the text",
        None,
    ),
    (
        "max",
        "`\\max` is read only as a subscript, as in `\\eta_{\\max}`",
        None,
    ),
    (
        "min",
        "`\\min` is read only as a subscript, as in `\\eta_{\\min}`",
        None,
    ),
    ("langle", "angle brackets are not read", None),
    ("over", "`\\over` is not read", Some("write `\\frac{…}{…}`")),
    ("hspace", "`\\hspace` is not read", Some("write `\\quad`")),
    (
        "circ",
        "degrees are read only in the angle of a sine, a cosine or a tangent, as in `\\sin 30^\\circ`",
        Some("write the angle in radians: `30^\\circ` is `\\pi/6`"),
    ),
    (
        "%",
        "`\\%` is read only right after a number, as in `40\\,\\%`",
        None,
    ),
    (
        "arcsin",
        "inverse functions (`\\arcsin`) are not read",
        Some("write `\\sin\\alpha = x`"),
    ),
    (
        "arccos",
        "inverse functions (`\\arccos`) are not read",
        Some("write `\\cos\\alpha = x`"),
    ),
    (
        "arctan",
        "inverse functions (`\\arctan`) are not read",
        Some("write `\\tan\\alpha = x`"),
    ),
    (
        "coth",
        "`\\coth` is not read",
        Some("write `\\frac{\\cosh x}{\\sinh x}`"),
    ),
    (
        "cot",
        "`\\cot` is not read",
        Some("write `\\frac{\\cos x}{\\sin x}`"),
    ),
    ("middle", "`\\middle` is not read", None),
    (
        "ang",
        "angles in degrees (`\\ang`) are not read",
        Some("write the angle in radians"),
    ),
];

/// What a command says as a relation sign.
pub(super) fn relation(command: &str) -> Option<Relation> {
    Some(match command {
        "neq" | "ne" => Relation::NotEqual,
        "lt" => Relation::Less,
        "gt" => Relation::Greater,
        "le" | "leq" | "leqslant" => Relation::LessOrEqual,
        "ge" | "geq" | "geqslant" => Relation::GreaterOrEqual,
        "sim" => Relation::Scales,
        "propto" => Relation::Proportional,
        "approx" | "simeq" => Relation::Approximately,
        "ll" => Relation::MuchLess,
        "gg" => Relation::MuchGreater,
        "equiv" | "coloneqq" => Relation::Equal,
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
        "exp" => Function::Exp,
        "ln" | "log" => Function::Ln,
        _ => return None,
    })
}

/// Whether a command names a function: one of these, or one that is made of them.
pub(super) fn is_function(command: &str) -> bool {
    function(command).is_some() || matches!(command, "sinh" | "cosh" | "tanh" | "lg")
}

const FUNCTIONS: &[&str] = &[
    "sin", "cos", "tan", "exp", "log", "sinh", "cosh", "tanh", "lg",
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
    "Bias", "Corr", "Cov", "SD", "Tr", "Var", "arccos", "arcsin", "arctan", "arg", "argmax",
    "argmin", "corr", "cos", "cosh", "cot", "cov", "curl", "det", "diag", "div", "erf", "erfc",
    "exp", "grad", "inf", "lg", "ln", "log", "max", "min", "rot", "sgn", "sign", "sin", "sinh",
    "sup", "tan", "tanh", "tr", "var",
];

/// The upright word that a name begins with: `Var` in `\text{Var}_1`.
fn word(name: &str) -> Option<&str> {
    name.strip_prefix("\\text{")?.split('}').next()
}

/// Whether a name is that of an operator, which has no value by itself: `\text{Var}`, `\mathbb{E}`.
pub(super) fn is_applied(name: &str) -> bool {
    let expectation = ["\\mathbb{E}", "\\mathbb{P}"];
    expectation.iter().any(|own| name.starts_with(own))
        || word(name).is_some_and(|word| APPLIED.contains(&word))
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

/// Whether a command is three dots.
pub(super) fn is_dots(command: &str) -> bool {
    matches!(
        command,
        "dots" | "ldots" | "cdots" | "dotsb" | "dotsc" | "dotsm"
    )
}

/// What to say about a command that cannot stand where it stands: message and help.
pub(super) fn complaint(command: &str) -> (String, Option<String>) {
    if let Some((_, message, help)) = REFUSED.iter().find(|(name, ..)| *name == command) {
        return ((*message).to_owned(), help.map(str::to_owned));
    }
    if known().any(|name| name == command)
        || relation(command).is_some()
        || is_abbreviation(command)
    {
        return (format!("`\\{command}` cannot stand here"), None);
    }
    let help = nearest(command).map(|name| format!("did you mean `\\{name}`?"));
    (format!("`\\{command}` is not known"), help)
}

/// Whether a command of this name is read, or refused with a reason of its own.
pub(crate) fn is_command(name: &str) -> bool {
    known().any(|own| own == name)
        || relation(name).is_some()
        || SPACING.contains(&name)
        || REFUSED.iter().any(|(own, ..)| *own == name)
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

/// The known command that a misspelt one is nearest to, if it is near enough to be meant.
fn nearest(command: &str) -> Option<&'static str> {
    let length = command.chars().count();
    if !(2..=20).contains(&length) {
        return None;
    }
    let allowed = if length < 4 { 1 } else { 2 };
    known()
        .map(|name| (strsim::osa_distance(command, name), name))
        .filter(|(distance, _)| *distance <= allowed)
        .min()
        .map(|(_, name)| name)
}
