//! Commands of what the notation lacks, several to a reason.

/// Names, why they are not read, and what to write instead.
type Row = (&'static [&'static str], &'static str, Option<&'static str>);

const UNREAD: &[Row] = &[
    (
        &["pmod", "bmod", "mod", "pod"],
        "the notation has no remainders",
        Some("write `a = b + n m` with a whole number `n`"),
    ),
    (
        &[
            "in",
            "notin",
            "ni",
            "cup",
            "cap",
            "bigcup",
            "bigcap",
            "setminus",
            "subset",
            "subseteq",
            "supset",
            "supseteq",
            "emptyset",
            "varnothing",
        ],
        "the notation has no sets",
        Some("write bounds, as `0 \\leq x \\leq 1`, or say it in the text"),
    ),
    (
        &["otimes", "bigotimes", "bigoplus", "wedge"],
        "the notation has no products of tensors and spaces",
        Some("write it in components"),
    ),
    (
        &[
            "det", "Det", "tr", "Tr", "trace", "rank", "gcd", "deg", "dim", "ker", "hom", "arg",
            "sup", "inf", "limsup", "liminf", "Pr", "Re", "Im", "argmax", "argmin", "sgn", "erf",
        ],
        "what it comes to is not known here",
        Some("give its value a name"),
    ),
    (
        &["lVert", "rVert", "Vert", "|"],
        "the notation has no norms",
        Some("write `\\lvert … \\rvert` for the magnitude of a number, or give the norm a name"),
    ),
    (
        &["div"],
        "it may be a division or a divergence",
        Some("write `\\frac{…}{…}`, or partial derivatives by coordinates"),
    ),
    (
        &["ast", "star", "bullet"],
        "whether it is a product or something else is not clear",
        Some("for a product write `\\cdot`"),
    ),
    (
        &["because", "since"],
        "a reason is no part of the statement",
        Some("give the reason in the text"),
    ),
    (
        &[
            "rightarrow",
            "longrightarrow",
            "leftarrow",
            "longleftarrow",
            "leftrightarrow",
            "longleftrightarrow",
            "mapsto",
            "longmapsto",
            "gets",
            "Leftarrow",
            "Longleftarrow",
            "impliedby",
            "rightleftharpoons",
            "xrightarrow",
            "xleftarrow",
            "nearrow",
            "searrow",
            "uparrow",
            "downarrow",
        ],
        "it states no relation that can be checked",
        Some("for an implication write `\\Rightarrow`, for a limit `\\lim_{x \\to a}`"),
    ),
    (
        &["lesssim", "gtrsim"],
        "how near is meant is not said",
        Some("write `\\leq` or `\\geq`, or `\\approx`"),
    ),
    (
        &["cong"],
        "it may be a congruence, or say that something is nearly so",
        Some("write `=` or `\\approx`"),
    ),
    (
        &["textbf", "textit", "textsf", "texttt", "textsc", "emph"],
        "it sets words",
        Some("write `\\mathbf{…}` or its like for a name, `\\text{…}` for words"),
    ),
    (
        &["overrightarrow", "overleftarrow", "overleftrightarrow"],
        "what stands below it is no single name",
        Some("write `\\vec a`, or give a length a name of its own"),
    ),
    (
        &["underset", "underaccent", "substack"],
        "what stands below a sign is not understood",
        Some("say it in the text"),
    ),
    (
        &["square", "blacksquare", "Box"],
        "it is no term",
        Some("leave it out, or write it at the very end, after `\\quad`"),
    ),
    (
        &["atop", "choose", "brack", "brace"],
        "it stands between what it sets one above the other",
        Some("write `\\binom{n}{k}`"),
    ),
    (
        &[
            "footnote",
            "footnotemark",
            "cite",
            "citep",
            "citet",
            "href",
            "url",
        ],
        "it belongs into the text",
        None,
    ),
    (
        &[
            "grad",
            "gradient",
            "curl",
            "divergence",
            "laplacian",
            "nabla",
        ],
        "the notation has no vector calculus",
        Some("write it with partial derivatives by coordinates"),
    ),
    (
        &["var", "variation", "fdv", "functionalderivative"],
        "the notation has no variations",
        None,
    ),
    (
        &[
            "ket", "bra", "braket", "ketbra", "expval", "ev", "mel", "dyad",
        ],
        "the notation has no states and operators",
        None,
    ),
    (
        &[
            "comm",
            "commutator",
            "acomm",
            "anticommutator",
            "pb",
            "poissonbracket",
        ],
        "the notation has no brackets of operators",
        None,
    ),
    (
        &["dddot", "ddddot"],
        "only one dot and two are",
        Some("write `\\frac{d^3 x}{dt^3}`"),
    ),
    (&["order"], "the notation has no orders of magnitude", None),
    (
        &["iint", "iiint", "oint", "oiint"],
        "only integrals over one variable are",
        Some("write definite integrals, one inside the other"),
    ),
];

/// Why a command is not read, and what to write instead.
pub(super) fn reason(command: &str) -> Option<(&'static str, Option<&'static str>)> {
    let mut rows = UNREAD.iter();
    let row = rows.find(|(names, ..)| names.contains(&command));
    row.map(|(_, why, help)| (*why, *help))
}
