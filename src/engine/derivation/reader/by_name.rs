//! Kinds of things and laws that words name again: "For a diatomic gas", "By conservation of momentum".

use crate::document::{Span, SuppositionKind};
use crate::sorted::Set;

use super::super::supposed::MOST_BEFORE;
use super::Reader;

/// So many kinds of things with values of their own are kept in mind.
const MOST_KINDS: usize = 8;
/// No shorter word names a kind: "a", "of".
const SHORTEST_NAME: usize = 2;
/// So much of two words is the same where one is made of the other: "conserved", "conservation".
const STEM: usize = 7;

impl Reader<'_> {
    /// Takes up the value of the kind of things that the sentence is about that leads on to a display: "For a diatomic gas (1) gives".
    pub(super) fn kind_of(&mut self, leading: Span) {
        let source = &self.page.document.source;
        if self.kinds.is_empty() || leading == Span::default() {
            return;
        }
        let said = words_of(source, leading);
        let newest = self.kinds.len().saturating_sub(MOST_KINDS);
        let kinds = &self.kinds[newest..];
        let all: Vec<Set<String>> = kinds.iter().map(|own| words_of(source, own.0)).collect();
        // What tells a kind from the others: "diatomic" of "diatomic gases".
        let names = |at: usize| {
            let others = (0..all.len()).filter(|&other| all[other] != all[at]);
            let others: Vec<usize> = others.collect();
            let own = all[at].iter();
            let mut own =
                own.filter(|word| others.iter().all(|&other| !all[other].contains(*word)));
            own.any(|word| said.contains(word))
        };
        let meant: Vec<usize> = (0..all.len()).filter(|&at| names(at)).collect();
        let is_one = meant.windows(2).all(|pair| all[pair[0]] == all[pair[1]]);
        let meant: Vec<Span> = meant.into_iter().map(|at| kinds[at].1).collect();
        for body in meant.into_iter().filter(|_| is_one) {
            self.suppose(SuppositionKind::case(true), body);
        }
    }

    /// Whether a law stands on the page already, by its name: "conservation of momentum" after "Momentum is conserved:".
    pub(super) fn stands(&self, law: Span) -> bool {
        let source = &self.page.document.source;
        let stems = |text| -> Set<String> {
            let words = words_of(source, text).into_iter();
            let words = words.filter(|word| word != "the");
            words
                .map(|word| word.chars().take(STEM).collect())
                .collect()
        };
        let name = stems(law);
        let recent = self.introduced.iter().rev().take(MOST_BEFORE);
        // "The law" may be any.
        name.len() > 1 && recent.into_iter().any(|&own| name.is_subset(&stems(own)))
    }
}

/// The words of a piece of text that name something, in lower case and without the ending of the plural.
fn words_of(source: &str, text: Span) -> Set<String> {
    let text = source.get(text.range()).unwrap_or_default();
    let words = text.split(|c: char| !c.is_alphabetic());
    let words = words.filter(|word| word.len() > SHORTEST_NAME);
    words
        .map(|word| word.to_lowercase().trim_end_matches('s').to_owned())
        .collect()
}
