//! Commands that are a sign, and how it stands beside its neighbours. Letters are in the vocabulary of the reader.

use crate::notation::commands::{self, LETTERS, SUBSCRIPTS};

/// What a sign is to its neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    /// Nothing yet: the beginning of a line, and what leaves no trace.
    None,
    Ordinary,
    /// The name of a function, which stands a little apart from its argument.
    Function,
    /// Such a name with its scripts below and above it.
    Limits,
    /// A large sign with its scripts below and above it.
    Large,
    Integral,
    Binary,
    Relation,
    Open,
    Close,
    Comma,
}

/// What a command shows.
pub(super) fn sign(command: &str) -> Option<(&'static str, Class)> {
    let found = SIGNS.iter().find(|(names, ..)| names.contains(&command));
    if let Some((_, shown, class)) = found {
        return Some((shown, *class));
    }
    let letter = commands::find(LETTERS, command).or_else(|| commands::find(SUBSCRIPTS, command));
    letter.map(|shown| (shown, Class::Ordinary))
}

/// The name that a command sets upright as that of a function, and whether scripts go below and above it.
pub(super) fn function(command: &str) -> Option<(&'static str, Class)> {
    let own = |list: &'static [&'static str]| list.iter().find(|name| **name == command);
    let found = own(FUNCTIONS).map(|name| (*name, Class::Function));
    found
        .or_else(|| own(LIMITS).map(|name| (*name, Class::Limits)))
        .or(match command {
            "limsup" => Some(("lim sup", Class::Limits)),
            "liminf" => Some(("lim inf", Class::Limits)),
            _ => None,
        })
}

const FUNCTIONS: &[&str] = &[
    "sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "coth", "arcsin", "arccos",
    "arctan", "exp", "ln", "log", "lg", "arg", "deg", "dim", "hom", "ker",
];

const LIMITS: &[&str] = &["lim", "max", "min", "sup", "inf", "det", "gcd", "Pr"];

/// Names of a sign, the sign, and its class.
type Row = (&'static [&'static str], &'static str, Class);

const SIGNS: &[Row] = &[
    // Between terms.
    (&["cdot"], "⋅", Class::Binary),
    (&["times"], "×", Class::Binary),
    (&["div"], "÷", Class::Binary),
    (&["pm"], "±", Class::Binary),
    (&["mp"], "∓", Class::Binary),
    (&["ast"], "∗", Class::Binary),
    (&["star"], "⋆", Class::Binary),
    (&["circ"], "∘", Class::Binary),
    (&["bullet"], "∙", Class::Binary),
    (&["oplus"], "⊕", Class::Binary),
    (&["ominus"], "⊖", Class::Binary),
    (&["otimes"], "⊗", Class::Binary),
    (&["odot"], "⊙", Class::Binary),
    (&["wedge", "land"], "∧", Class::Binary),
    (&["vee", "lor"], "∨", Class::Binary),
    (&["cap"], "∩", Class::Binary),
    (&["cup"], "∪", Class::Binary),
    (&["setminus", "backslash"], "∖", Class::Binary),
    // Relations.
    (&["neq", "ne"], "≠", Class::Relation),
    (&["lt"], "<", Class::Relation),
    (&["gt"], ">", Class::Relation),
    (&["le", "leq"], "≤", Class::Relation),
    (&["ge", "geq"], "≥", Class::Relation),
    (&["leqslant"], "⩽", Class::Relation),
    (&["geqslant"], "⩾", Class::Relation),
    (&["ll"], "≪", Class::Relation),
    (&["gg"], "≫", Class::Relation),
    (&["lesssim"], "≲", Class::Relation),
    (&["gtrsim"], "≳", Class::Relation),
    (&["sim"], "∼", Class::Relation),
    (&["simeq"], "≃", Class::Relation),
    (&["approx"], "≈", Class::Relation),
    (&["cong"], "≅", Class::Relation),
    (&["equiv"], "≡", Class::Relation),
    (&["coloneqq", "coloneq"], "≔", Class::Relation),
    (&["doteq"], "≐", Class::Relation),
    (&["triangleq"], "≜", Class::Relation),
    (&["propto"], "∝", Class::Relation),
    (&["in"], "∈", Class::Relation),
    (&["notin"], "∉", Class::Relation),
    (&["ni"], "∋", Class::Relation),
    (&["subset"], "⊂", Class::Relation),
    (&["subseteq"], "⊆", Class::Relation),
    (&["supset"], "⊃", Class::Relation),
    (&["supseteq"], "⊇", Class::Relation),
    (&["mid"], "∣", Class::Relation),
    (&["parallel"], "∥", Class::Relation),
    (&["perp"], "⊥", Class::Relation),
    (&["colon"], ":", Class::Relation),
    (&["vdash"], "⊢", Class::Relation),
    (&["models"], "⊨", Class::Relation),
    (&["to", "rightarrow"], "→", Class::Relation),
    (&["gets", "leftarrow"], "←", Class::Relation),
    (&["longrightarrow"], "⟶", Class::Relation),
    (&["leftrightarrow"], "↔", Class::Relation),
    (&["mapsto"], "↦", Class::Relation),
    (&["longmapsto"], "⟼", Class::Relation),
    (&["hookrightarrow"], "↪", Class::Relation),
    (&["Rightarrow"], "⇒", Class::Relation),
    (&["implies", "Longrightarrow"], "⟹", Class::Relation),
    (&["Leftarrow", "impliedby"], "⇐", Class::Relation),
    (&["Leftrightarrow"], "⇔", Class::Relation),
    (&["iff", "Longleftrightarrow"], "⟺", Class::Relation),
    (&["uparrow"], "↑", Class::Relation),
    (&["downarrow"], "↓", Class::Relation),
    (&["nearrow"], "↗", Class::Relation),
    (&["searrow"], "↘", Class::Relation),
    (&["rightleftharpoons"], "⇌", Class::Relation),
    (&["therefore"], "∴", Class::Relation),
    (&["because"], "∵", Class::Relation),
    // Large signs.
    (&["sum"], "∑", Class::Large),
    (&["prod"], "∏", Class::Large),
    (&["coprod"], "∐", Class::Large),
    (&["bigcup"], "⋃", Class::Large),
    (&["bigcap"], "⋂", Class::Large),
    (&["bigoplus"], "⨁", Class::Large),
    (&["bigotimes"], "⨂", Class::Large),
    (&["int"], "∫", Class::Integral),
    (&["iint"], "∬", Class::Integral),
    (&["iiint"], "∭", Class::Integral),
    (&["oint"], "∮", Class::Integral),
    // Fences.
    (&["langle"], "⟨", Class::Open),
    (&["rangle"], "⟩", Class::Close),
    (&["lvert"], "|", Class::Open),
    (&["rvert"], "|", Class::Close),
    (&["lVert"], "‖", Class::Open),
    (&["rVert"], "‖", Class::Close),
    (&["lceil"], "⌈", Class::Open),
    (&["rceil"], "⌉", Class::Close),
    (&["lfloor"], "⌊", Class::Open),
    (&["rfloor"], "⌋", Class::Close),
    (&["{", "lbrace"], "{", Class::Open),
    (&["}", "rbrace"], "}", Class::Close),
    (&["lbrack"], "[", Class::Open),
    (&["rbrack"], "]", Class::Close),
    (&["lparen"], "(", Class::Open),
    (&["rparen"], ")", Class::Close),
    // Everything else.
    (&["infty"], "∞", Class::Ordinary),
    (&["partial"], "∂", Class::Ordinary),
    (&["nabla"], "∇", Class::Ordinary),
    (&["hslash"], "ℏ", Class::Ordinary),
    (&["imath"], "ı", Class::Ordinary),
    (&["jmath"], "ȷ", Class::Ordinary),
    (&["Re"], "ℜ", Class::Ordinary),
    (&["Im"], "ℑ", Class::Ordinary),
    (&["aleph"], "ℵ", Class::Ordinary),
    (&["forall"], "∀", Class::Ordinary),
    (&["exists"], "∃", Class::Ordinary),
    (&["nexists"], "∄", Class::Ordinary),
    (&["neg", "lnot"], "¬", Class::Ordinary),
    (&["emptyset", "varnothing"], "∅", Class::Ordinary),
    (&["angle"], "∠", Class::Ordinary),
    (&["triangle"], "△", Class::Ordinary),
    (&["square", "Box"], "□", Class::Ordinary),
    (&["degree", "textdegree"], "°", Class::Ordinary),
    (&["dagger"], "†", Class::Ordinary),
    (&["ddagger"], "‡", Class::Ordinary),
    (&["checkmark", "cmark"], "✓", Class::Ordinary),
    (&["xmark"], "✗", Class::Ordinary),
    (&["dots", "ldots", "dotsc"], "…", Class::Ordinary),
    (&["cdots", "dotsb", "dotsm"], "⋯", Class::Ordinary),
    (&["vdots"], "⋮", Class::Ordinary),
    (&["ddots"], "⋱", Class::Ordinary),
    (&["top"], "⊤", Class::Ordinary),
    (&["bot"], "⊥", Class::Ordinary),
    (&["|", "Vert"], "‖", Class::Ordinary),
    (&["vert"], "|", Class::Ordinary),
    (&["%"], "%", Class::Ordinary),
    (&["$"], "$", Class::Ordinary),
    (&["#"], "#", Class::Ordinary),
    (&["&"], "&", Class::Ordinary),
    (&["_"], "_", Class::Ordinary),
    (&["S"], "§", Class::Ordinary),
    (&["pounds"], "£", Class::Ordinary),
];

/// How wide the space is that a command leaves; 0 for those that leave none, and for what moves ink about.
pub(super) fn space(command: &str) -> Option<&'static str> {
    Some(match command {
        "," | "thinspace" => "0.17em",
        ":" | ">" | "medspace" => "0.22em",
        ";" | "thickspace" | " " | "\n" | "\t" | "space" | "nobreakspace" => "0.28em",
        "enspace" | "enskip" => "0.5em",
        "quad" => "1em",
        "qquad" => "2em",
        "!" | "negthinspace" | "/" | "-" => "0",
        _ if commands::SPACING.contains(&command) => "0",
        _ => return None,
    })
}
