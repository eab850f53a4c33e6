//! "Did you mean …?": the nearest of the words that would have been understood.

/// Longer words are never a slip of a keyword, and comparing them would cost their product.
const LONGEST: usize = 24;

/// How many letters must be inserted, dropped, changed or swapped with their neighbour.
pub(super) fn distance(left: &str, right: &str) -> usize {
    let (mut own, mut other) = (['\0'; LONGEST], ['\0'; LONGEST]);
    let (Some(left), Some(right)) = (letters(left, &mut own), letters(right, &mut other)) else {
        return usize::MAX;
    };
    let width = right.len() + 1;
    let mut rows = [[0; LONGEST + 1]; 2];
    rows[0] = std::array::from_fn(|j| j);
    for i in 1..=left.len() {
        let (mut row, above, before) = ([i; LONGEST + 1], rows[0], rows[1]);
        for j in 1..width {
            let change = usize::from(left[i - 1] != right[j - 1]);
            row[j] = (above[j] + 1)
                .min(row[j - 1] + 1)
                .min(above[j - 1] + change);
            if i > 1 && j > 1 && left[i - 1] == right[j - 2] && left[i - 2] == right[j - 1] {
                row[j] = row[j].min(before[j - 2] + 1);
            }
        }
        rows = [row, above];
    }
    rows[0][width - 1]
}

/// The letters of a word that is not too long.
fn letters<'a>(word: &str, space: &'a mut [char; LONGEST]) -> Option<&'a [char]> {
    let mut length = 0;
    for letter in word.chars() {
        *space.get_mut(length)? = letter;
        length += 1;
    }
    Some(&space[..length])
}

/// The first of the nearest `words`, if it is no further than `slips`, in any case of letters.
pub(crate) fn nearest<'w>(written: &str, words: &[&'w str], slips: usize) -> Option<&'w str> {
    if let Some(word) = words.iter().find(|word| **word == written) {
        return Some(word);
    }
    if slips == 0 && !written.contains(|c: char| c.is_uppercase()) {
        return None;
    }
    let written: String = written.chars().take(LONGEST + 1).collect();
    let written = written.to_lowercase();
    let length = written.chars().count();
    words
        .iter()
        .filter(|word| word.chars().count().abs_diff(length) <= slips)
        .map(|word| (distance(&written, word), *word))
        .filter(|(distance, _)| *distance <= slips)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, word)| word)
}
