//! Lists of words that prose is held against.

/// Words in lower case that a word of a text may be one of, in small letters or capitals.
pub(super) trait Listed {
    fn has_in_any_case(&self, word: &str) -> bool;
}

impl Listed for [&str] {
    #[inline]
    fn has_in_any_case(&self, word: &str) -> bool {
        self.iter().any(|own| is_in_any_case(word, own))
    }
}

impl<const N: usize> Listed for [&str; N] {
    #[inline]
    fn has_in_any_case(&self, word: &str) -> bool {
        self.iter().any(|own| is_in_any_case(word, own))
    }
}

/// Whether a word is another one, in small letters or capitals. Most have another length, which is seen where it is asked.
#[inline]
pub(super) fn is_in_any_case(word: &str, own: &str) -> bool {
    word.len() == own.len() && word.eq_ignore_ascii_case(own)
}

/// A list that every word of a text is held against: of most words it is seen at a glance that they are not on it.
pub(super) struct Words {
    all: &'static [&'static str],
    /// A bit for each length that words with like first and last letters have.
    lengths: [u32; 64],
}

impl Words {
    pub(super) const fn of(all: &'static [&'static str]) -> Words {
        let mut lengths = [0; 64];
        let mut at = 0;
        while at < all.len() {
            let (letters, length) = Words::look(all[at]);
            lengths[letters] |= length;
            at += 1;
        }
        Words { all, lengths }
    }

    /// What the first and the last letter come to, small or capital, and the bit of the length.
    const fn look(word: &str) -> (usize, u32) {
        let length = match word.len() {
            length if length < 32 => 1 << length,
            _ => 0,
        };
        let letters = match word.as_bytes() {
            [first, .., last] => (*first & 31) as usize + 2 * (*last & 31) as usize,
            [only] => *only as usize,
            [] => 0,
        };
        (letters & 63, length)
    }

    /// Always put in where it is asked, so that a word that is held against several lists is looked at once.
    #[inline(always)]
    fn may_have(&self, word: &str) -> bool {
        let (letters, length) = Words::look(word);
        self.lengths[letters] & length != 0
    }

    /// Whether a word is on the list as it is written.
    #[inline(always)]
    pub(super) fn has(&self, word: &str) -> bool {
        self.may_have(word) && self.lists(word)
    }

    #[inline(never)]
    fn lists(&self, word: &str) -> bool {
        self.all.contains(&word)
    }

    #[inline(never)]
    fn lists_in_any_case(&self, word: &str) -> bool {
        self.all.has_in_any_case(word)
    }
}

impl Listed for Words {
    #[inline(always)]
    fn has_in_any_case(&self, word: &str) -> bool {
        self.may_have(word) && self.lists_in_any_case(word)
    }
}
