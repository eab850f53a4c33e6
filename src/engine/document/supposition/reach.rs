//! How far a supposition reaches in its sentence.

/// How far a supposition reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reach {
    /// "Let", "Assume" as the verb of the sentence: all of it.
    Sentence,
    /// "With $…$, $…$ and $…$": so many more.
    List { left: usize },
    /// "…, taking $…$ and $…$, …": what is joined to it.
    Joined {
        /// Words that may still come before the first.
        patience: usize,
        /// A comma has just been read.
        comma: bool,
        /// Something has been supposed.
        found: bool,
        /// "At $…$": a comma ends it.
        short: bool,
    },
}

impl Reach {
    pub(super) fn past_word(self, word: &str) -> Option<Reach> {
        let (patience, found, short) = match self {
            Reach::Sentence => return Some(self),
            Reach::List { .. } => return (word == "and").then_some(self),
            Reach::Joined {
                patience,
                found,
                short,
                ..
            } => (patience, found, short),
        };
        let patience = patience.checked_sub(1)?;
        let joins = matches!(word, "and" | "that" | "both" | "also");
        (joins || !found).then_some(Reach::Joined {
            patience,
            comma: false,
            found,
            short,
        })
    }

    pub(super) fn past_math(self, relation: bool) -> Option<Reach> {
        Some(match self {
            Reach::Joined {
                patience,
                found,
                short,
                ..
            } => Reach::Joined {
                patience,
                comma: false,
                found: found || relation,
                short,
            },
            Reach::List { left } => Reach::List {
                left: left.saturating_sub(1),
            },
            Reach::Sentence => self,
        })
    }

    pub(super) fn past_comma(self) -> Option<Reach> {
        match self {
            Reach::Sentence => Some(self),
            Reach::List { left } => (left > 0).then_some(self),
            Reach::Joined {
                found,
                short,
                comma,
                ..
            } if !found || short || comma => None,
            Reach::Joined {
                patience,
                found,
                short,
                ..
            } => Some(Reach::Joined {
                patience,
                comma: true,
                found,
                short,
            }),
        }
    }
}
