//! Letters and signs that are typed as characters of their own: `α`, `x²`, `≤`. They are what the command is that prints them.

use super::{Kind, Lexer};
use crate::document::Span;
use crate::notation::Mark;
use crate::notation::commands::LETTERS;

/// Signs, and the commands that print them.
const SIGNS: &[(char, &str)] = &[
    ('·', "cdot"),
    ('⋅', "cdot"),
    ('×', "times"),
    ('±', "pm"),
    ('∓', "mp"),
    ('…', "dots"),
    ('⋯', "dots"),
    ('≠', "neq"),
    ('≤', "leq"),
    ('≥', "geq"),
    ('⩽', "leqslant"),
    ('⩾', "geqslant"),
    ('≪', "ll"),
    ('≫', "gg"),
    ('≈', "approx"),
    ('≃', "simeq"),
    ('∼', "sim"),
    ('∝', "propto"),
    ('≡', "equiv"),
    ('≔', "coloneqq"),
    ('→', "to"),
    ('⇒', "Rightarrow"),
    ('⟹', "implies"),
    ('⇔', "Leftrightarrow"),
    ('⟺', "iff"),
    ('∴', "therefore"),
    ('∞', "infty"),
    ('∂', "partial"),
    ('∇', "nabla"),
    ('∑', "sum"),
    ('∏', "prod"),
    ('∫', "int"),
    ('∮', "oint"),
    ('∈', "in"),
    ('∀', "forall"),
    ('⟨', "langle"),
    ('⟩', "rangle"),
    ('⌈', "lceil"),
    ('⌉', "rceil"),
    ('⌊', "lfloor"),
    ('⌋', "rfloor"),
];

/// Letters that have another character than that of the vocabulary, and look the same.
const ALIKE: &[(char, &str)] = &[
    ('µ', "mu"),
    ('\u{2126}', "Omega"),
    ('∆', "Delta"),
    ('ℏ', "hbar"),
];

const FRACTIONS: &[(char, &str, &str)] = &[
    ('½', "1", "2"),
    ('⅓', "1", "3"),
    ('⅔', "2", "3"),
    ('¼', "1", "4"),
    ('¾', "3", "4"),
    ('⅕', "1", "5"),
    ('⅙', "1", "6"),
    ('⅛', "1", "8"),
];

const DIGITS: [&str; 10] = ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"];

/// What stands above or below the line in one character.
fn script(c: char) -> Option<(char, Kind<'static>)> {
    let digit = |from: char| DIGITS.get((c as usize).checked_sub(from as usize)?);
    let raised = match c {
        '¹' => Some(Kind::Number("1")),
        '²' => Some(Kind::Number("2")),
        '³' => Some(Kind::Number("3")),
        '⁰' | '⁴'..='⁹' => digit('⁰').map(|digit| Kind::Number(digit)),
        '⁺' => Some(Kind::Char('+')),
        '⁻' => Some(Kind::Char('-')),
        'ⁿ' => Some(Kind::Letter('n')),
        'ⁱ' => Some(Kind::Letter('i')),
        _ => None,
    };
    if let Some(kind) = raised {
        return Some(('^', kind));
    }
    let lowered = match c {
        '₀'..='₉' => digit('₀').map(|digit| Kind::Number(digit))?,
        '₊' => Kind::Char('+'),
        '₋' => Kind::Char('-'),
        'ₐ' => Kind::Letter('a'),
        'ₑ' => Kind::Letter('e'),
        'ₕ' => Kind::Letter('h'),
        'ᵢ' => Kind::Letter('i'),
        'ⱼ' => Kind::Letter('j'),
        'ₖ' => Kind::Letter('k'),
        'ₗ' => Kind::Letter('l'),
        'ₘ' => Kind::Letter('m'),
        'ₙ' => Kind::Letter('n'),
        'ₒ' => Kind::Letter('o'),
        'ₚ' => Kind::Letter('p'),
        'ᵣ' => Kind::Letter('r'),
        'ₛ' => Kind::Letter('s'),
        'ₜ' => Kind::Letter('t'),
        'ₓ' => Kind::Letter('x'),
        _ => return None,
    };
    Some(('_', lowered))
}

/// The command that a character stands for.
fn command(c: char) -> Option<&'static str> {
    let among = |table: &[(char, &'static str)]| {
        let mut table = table.iter();
        table.find(|(own, _)| *own == c).map(|(_, name)| *name)
    };
    let letter = || {
        let mut letters = LETTERS.iter();
        letters.find(|(_, shown)| shown.chars().eq([c]))
    };
    among(SIGNS)
        .or_else(|| among(ALIKE))
        .or_else(|| letter().map(|(name, _)| *name))
}

impl Lexer<'_> {
    /// A character that is no letter, digit or sign of ASCII, behind it.
    pub(super) fn unusual(&mut self, start: usize, c: char) {
        let plain = match c {
            '−' => Some(Kind::Char('-')),
            '∗' => Some(Kind::Char('*')),
            '′' | '’' => Some(Kind::Char('\'')),
            '✓' | '✔' => Some(Kind::Mark(Mark::Tick)),
            '✗' | '✘' => Some(Kind::Mark(Mark::Cross)),
            c => command(c).map(Kind::Command),
        };
        if let Some(kind) = plain {
            return self.push(start, kind);
        }
        if let Some((sign, first)) = script(c) {
            return self.script(start, sign, first);
        }
        if c == '°' {
            self.push(start, Kind::Char('^'));
            return self.push(start, Kind::Command("circ"));
        }
        if let Some((_, over, under)) = FRACTIONS.iter().find(|(own, ..)| *own == c) {
            self.push(start, Kind::Command("frac"));
            for number in [over, under] {
                for kind in [Kind::Open, Kind::Number(number), Kind::Close] {
                    self.push(start, kind);
                }
            }
            return;
        }
        let help = match c {
            '√' => Some("what it reaches over is not printed: write `\\sqrt{…}`"),
            '∛' => Some("write `\\sqrt[3]{…}`"),
            '÷' => Some("write `/`, or `\\frac{…}{…}`"),
            '‖' => Some("write `\\lvert … \\rvert` for a magnitude"),
            '–' | '—' | '‐' | '‑' => Some("write `-` for a minus sign"),
            '“' | '”' | '„' | '″' => Some("write `''` for two primes"),
            _ => None,
        };
        let span = Span::new(start, self.at);
        let help = help.map(str::to_owned);
        self.bad(span, format!("the character `{c}` is not known"), help);
    }

    /// A run of characters above the line, or below it: `⁻¹`, `₁₂`.
    fn script(&mut self, start: usize, sign: char, first: Kind<'static>) {
        let mut inside = vec![first];
        while let Some(c) = self.peek()
            && let Some((own, kind)) = script(c)
            && own == sign
        {
            self.at += c.len_utf8();
            inside.push(kind);
        }
        let number = |kind: &Kind| matches!(kind, Kind::Number(_));
        if sign == '^' && inside.windows(2).any(|two| two.iter().all(number)) {
            let message = "a raised number is read here of one digit only".to_owned();
            let help = Some("write `^{…}`".to_owned());
            return self.bad(Span::new(start, self.at), message, help);
        }
        self.push(start, Kind::Char(sign));
        self.push(start, Kind::Open);
        for kind in inside {
            self.push(start, kind);
        }
        self.push(start, Kind::Close);
    }
}
