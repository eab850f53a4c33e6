//! "Did you mean …?": the nearest of the words that would have been understood.

/// Longer words are never a slip of a keyword, and comparing them would cost their product.
const LONGEST: usize = 24;

/// The first of the nearest `words`, if it is no further than `slips`, in any case of letters.
pub fn nearest<'w>(written: &str, words: &[&'w str], slips: usize) -> Option<&'w str> {
    if let Some(word) = words.iter().find(|word| **word == written) {
        return Some(word);
    }
    if slips == 0 && !written.contains(|c: char| c.is_uppercase()) {
        return None;
    }
    let written: String = written.chars().take(LONGEST + 1).collect();
    let written = written.to_lowercase();
    let (length, own) = (written.chars().count(), letters(&written));
    let may_be = |word: &&&str| {
        let others = (letters(word) ^ own).count_ones() as usize;
        word.chars().count().abs_diff(length) <= slips && others <= 2 * slips
    };
    words
        .iter()
        .filter(may_be)
        .map(|word| (strsim::osa_distance(&written, word), *word))
        .filter(|(distance, _)| *distance <= slips)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, word)| word)
}

/// The letters of a word, as bits. A slip puts no more than one in the place of another, so it changes two at most.
fn letters(word: &str) -> u64 {
    let bits = word.chars().map(|letter| 1 << (u32::from(letter) % 64));
    bits.fold(0, |all, bit| all | bit)
}
