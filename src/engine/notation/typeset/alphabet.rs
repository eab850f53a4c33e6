//! Typefaces: what `\mathbb`, `\mathcal` and their like make of a letter, and what accents look like.

use crate::notation::escape;

/// How letters look.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in crate::notation) enum Face {
    /// Single letters, in italics.
    #[default]
    Plain,
    /// Words.
    Upright,
    Bold,
    BoldItalic,
    Sans,
    Typewriter,
    /// `ℝ`
    Blackboard,
    /// `ℒ`
    Script,
    /// `ℌ`
    Fraktur,
}

impl Face {
    /// The typeface that a command sets its argument in, or all that follows it.
    pub(in crate::notation) fn of(command: &str) -> Option<Face> {
        Some(match command {
            "mathrm" | "operatorname" | "rm" | "mathup" => Face::Upright,
            "mathbf" | "bf" | "textbf" | "vb" | "vectorbold" => Face::Bold,
            "boldsymbol" | "bm" | "pmb" => Face::BoldItalic,
            "mathsf" | "sf" => Face::Sans,
            "mathtt" | "tt" => Face::Typewriter,
            "mathbb" | "mathds" | "Bbb" => Face::Blackboard,
            "mathcal" | "mathscr" | "cal" => Face::Script,
            "mathfrak" | "frak" => Face::Fraktur,
            "mathit" | "mathnormal" | "it" => Face::Plain,
            _ => return None,
        })
    }

    /// Whether letters side by side are a word.
    pub(super) fn is_of_words(self) -> bool {
        matches!(
            self,
            Face::Upright | Face::Bold | Face::Sans | Face::Typewriter
        )
    }

    /// A letter or a word in this face.
    pub(super) fn letters(self, word: &str) -> String {
        let shown = escape(&self.characters(word));
        let upright = match word.chars().count() {
            1 => " mathvariant=\"normal\"",
            _ => "",
        };
        match self {
            Face::Upright => format!("<mi{upright}>{shown}</mi>"),
            Face::Bold => format!("<mi class=\"mathbf\"{upright}>{shown}</mi>"),
            Face::Sans => format!("<mi class=\"mathsf\"{upright}>{shown}</mi>"),
            Face::Typewriter => format!("<mi class=\"mathtt\"{upright}>{shown}</mi>"),
            Face::BoldItalic => format!("<mi class=\"boldsymbol\">{shown}</mi>"),
            _ => format!("<mi>{shown}</mi>"),
        }
    }

    /// The characters that stand for these letters, where this face has some of its own.
    pub(in crate::notation) fn characters(self, word: &str) -> String {
        word.chars().map(|c| self.character(c)).collect()
    }

    fn character(self, c: char) -> char {
        let (exceptions, capitals): (&[(char, char)], u32) = match self {
            Face::Blackboard => (BLACKBOARD, 0x1_d538),
            Face::Script => (SCRIPT, 0x1_d49c),
            Face::Fraktur => (FRAKTUR, 0x1_d504),
            _ => return c,
        };
        if let Some((_, own)) = exceptions.iter().find(|(letter, _)| *letter == c) {
            return *own;
        }
        let place = match c {
            'A'..='Z' => u32::from(c) - u32::from('A'),
            'a'..='z' => u32::from(c) - u32::from('a') + 26,
            _ => return c,
        };
        char::from_u32(capitals + place).unwrap_or(c)
    }
}

/// Letters that had characters before there was a whole alphabet.
const BLACKBOARD: &[(char, char)] = &[
    ('C', 'ℂ'),
    ('H', 'ℍ'),
    ('N', 'ℕ'),
    ('P', 'ℙ'),
    ('Q', 'ℚ'),
    ('R', 'ℝ'),
    ('Z', 'ℤ'),
    ('1', '𝟙'),
];

const SCRIPT: &[(char, char)] = &[
    ('B', 'ℬ'),
    ('E', 'ℰ'),
    ('F', 'ℱ'),
    ('H', 'ℋ'),
    ('I', 'ℐ'),
    ('L', 'ℒ'),
    ('M', 'ℳ'),
    ('R', 'ℛ'),
    ('e', 'ℯ'),
    ('g', 'ℊ'),
    ('o', 'ℴ'),
];

const FRAKTUR: &[(char, char)] = &[('C', 'ℭ'), ('H', 'ℌ'), ('I', 'ℑ'), ('R', 'ℜ'), ('Z', 'ℨ')];

/// The sign that an accent sets above what it stands before, and whether it is as wide as that.
pub(in crate::notation) fn accent(command: &str) -> Option<(&'static str, bool)> {
    Some(match command {
        "dot" => ("˙", false),
        "ddot" => ("¨", false),
        "dddot" => ("⃛", false),
        "bar" => ("‾", false),
        "overline" => ("‾", true),
        "hat" | "vu" => ("^", false),
        "widehat" => ("^", true),
        "tilde" => ("~", false),
        "widetilde" => ("~", true),
        "vec" | "va" => ("→", false),
        "overrightarrow" => ("→", true),
        "overleftarrow" => ("←", true),
        "overleftrightarrow" => ("↔", true),
        "overbrace" => ("⏞", true),
        "acute" => ("´", false),
        "grave" => ("`", false),
        "check" => ("ˇ", false),
        "breve" => ("˘", false),
        "mathring" => ("˚", false),
        _ => return None,
    })
}
