//! The words by which a sentence supposes, names, denies or concludes, in lower case.

/// After these, too, a sentence no longer supposes.
pub(super) const CONCLUDING: &[&str] = &[
    "show",
    "shows",
    "have",
    "see",
    "whether",
    "us",
    "we",
    "want",
    "need",
    "because",
    "since",
    "derivative",
    "gradient",
    "logarithm",
    "limit",
    "difference",
    "sum",
    "average",
    "square",
    "equation",
];
/// Who or what comes before a "have" with which a sentence concludes: "we have".
pub(super) const HAVING: &[&str] = &[
    "we",
    "you",
    "one",
    "i",
    "to",
    "must",
    "now",
    "then",
    "thus",
    "hence",
    "also",
    "therefore",
];
/// With these, a sentence supposes nothing that could be used.
pub(super) const DOUBTFUL: &[&str] = &[
    "or",
    "either",
    "if",
    "unless",
    "contradiction",
    "contradicts",
    "contrary",
    "otherwise",
    "example",
    "instance",
    "wrong",
    "wrongly",
    "false",
    "fails",
    "fail",
    "violates",
    "violated",
    "impossible",
    "absurd",
    "neither",
    "nor",
    "longer",
    "excluded",
    "excluding",
    "exclude",
    "ruled",
    "forbidden",
    "trivial",
    "trivially",
    "useless",
    "nowhere",
    "else",
    "elsewhere",
    "rather",
    "stop",
];
/// With these besides, a sentence supposes nothing by a mere "with" or "taking": they may deny what it names.
pub(super) const DENYING: &[&str] = &[
    "not", "never", "no", "cannot", "would", "were", "without", "could", "might", "nothing",
    "little", "only", "tried", "leads",
];
/// What comes between these and the next word is an origin or a name and no value: "Let $t = 0$ be the moment of release".
pub(super) const NAMED_AFTER: &[&str] = &[
    "be", "is", "denote", "denotes", "mark", "marks", "when", "at", "only", "onwards",
];
/// With these a sentence tells no fact that could be used, whatever it names.
pub(super) const UNDECIDED: &[&str] = &[
    "whether",
    "distinguish",
    "case",
    "cases",
    "compare",
    "until",
    "while",
    "once",
    "long",
    "limit",
    "see",
    "when",
    "except",
    "apart",
    "aside",
    "near",
    "beyond",
    "unlike",
    "instead",
    "dropping",
    "drop",
    "relaxing",
    "relax",
    "even",
    "far",
    "away",
    "than",
    "before",
];
/// After these a fact is named also where a conclusion is drawn: "Hence, since $a = 2 c$".
pub(super) const REASONS: &[&str] = &[
    "with", "since", "as", "because", "using", "where", "for", "by",
];
/// After these it is where something begins: "Suppose the motion starts at $t = 0$".
pub(super) const NAMED_BEFORE: &[&str] = &["from", "at", "until", "after", "before"];
/// A sentence that begins with one of these is about a special case.
pub(super) const OF_CASES: &[&str] = &["for", "when", "if", "at"];
/// After "we" these give a name: "We set $a = 2 c$".
pub(super) const DEFINING: &[&str] = &[
    "set",
    "put",
    "write",
    "define",
    "introduce",
    "choose",
    "denote",
    "abbreviate",
];
/// Before these, a value is named: supposed or not.
pub(super) const NAMING: &[&str] = &[
    "with",
    "where",
    "for",
    "when",
    "at",
    "if",
    "since",
    "because",
    "as",
    "while",
    "setting",
    "putting",
    "taking",
    "inserting",
    "substituting",
    "using",
    "letting",
    "choosing",
    "case",
    "let",
];
/// Before these, an introductory word means its opposite.
pub(super) const NEGATING: &[&str] = &[
    "not", "without", "never", "cannot", "nor", "don", "can", "needn",
];
/// After these, "that" or "to be" tells what is known: "It is known that $v = 3$", "was measured to be $m = 2$".
pub(super) const KNOWN: &[&str] = &[
    "know",
    "known",
    "told",
    "informed",
    "measured",
    "observed",
    "recall",
    "recalled",
    "specified",
    "stated",
    "reported",
    "remember",
];
/// Near before "the case", these compare with it: "In contrast to the case $a = 0$".
pub(super) const COMPARING: &[&str] = &[
    "contrast",
    "unlike",
    "opposed",
    "different",
    "differs",
    "distinct",
    "compared",
    "than",
    "from",
    "except",
    "apart",
    "aside",
    "as",
    "like",
    "similarly",
    "similar",
    "instead",
    "beyond",
    "excluding",
    "besides",
];
