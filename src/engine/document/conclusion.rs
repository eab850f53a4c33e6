//! Whether prose says that what is displayed next follows: "Hence", "Substituting (3) into (4) gives".

use super::prose::{Placed, Token};

/// What comes after these is drawn from what was said before. With one of them a sentence no longer supposes anything, either.
const DRAWN: [&str; 36] = [
    "then",
    "so",
    "hence",
    "thus",
    "therefore",
    "whence",
    "gives",
    "give",
    "giving",
    "yields",
    "yield",
    "yielding",
    "implies",
    "imply",
    "implying",
    "follows",
    "becomes",
    "become",
    "obtain",
    "obtains",
    "get",
    "find",
    "prove",
    "check",
    "verify",
    "means",
    "derive",
    "compute",
    "determine",
    "solve",
    "leads",
    "reduces",
    "deduce",
    "conclude",
    "consequently",
    "accordingly",
];
/// What is done with equations that stand already; and words for what is true of itself.
const WORKED: [&str; 62] = [
    "obtained",
    "gets",
    "gave",
    "yielded",
    "follow",
    "finds",
    "found",
    "leading",
    "reduce",
    "reducing",
    "simplify",
    "simplifies",
    "simplifying",
    "simplified",
    "rearrange",
    "rearranges",
    "rearranging",
    "rearranged",
    "solving",
    "solved",
    "substitute",
    "substituting",
    "substitution",
    "insert",
    "inserting",
    "eliminate",
    "eliminating",
    "expand",
    "expanding",
    "factor",
    "factoring",
    "divide",
    "dividing",
    "multiply",
    "multiplying",
    "adding",
    "subtracting",
    "differentiate",
    "differentiating",
    "integrate",
    "integrating",
    "combine",
    "combining",
    "equating",
    "comparing",
    "squaring",
    "cancelling",
    "canceling",
    "collecting",
    "evaluating",
    "rewrite",
    "rewriting",
    "rewritten",
    "result",
    "results",
    "equivalently",
    "thereby",
    "identity",
    "identities",
    "always",
    "must",
    "deduced",
];

/// What comes after these is what something is meant by.
const DEFINING: [&str; 18] = [
    "define",
    "defines",
    "defined",
    "definition",
    "denote",
    "denotes",
    "denoted",
    "call",
    "called",
    "introduce",
    "introducing",
    "abbreviate",
    "abbreviation",
    "let",
    "set",
    "setting",
    "put",
    "notation",
];

/// Whether a word, in lower case, draws a conclusion.
pub(super) fn draws(word: &str) -> bool {
    DRAWN.contains(&word)
}

/// Whether the first sentence is about the display before it: "which by (2) is".
pub(super) fn is_relative(tokens: &[Placed<'_>]) -> bool {
    let first = tokens
        .iter()
        .find(|(token, _)| !matches!(token, Token::Mark(',' | ';')));
    matches!(first, Some((Token::Word("which"), _)))
}

/// Whether nothing but a "where" or "with" leads on to the display: it says what is meant in the one before.
pub(super) fn says_what_is_meant(tokens: &[Placed<'_>]) -> bool {
    let mut said = tokens
        .iter()
        .filter(|(token, _)| !matches!(token, Token::Mark(',' | ';' | ':')));
    let first = said.next().map(|(token, _)| *token);
    matches!(first, Some(Token::Word("where" | "with"))) && said.next().is_none()
}

/// Whether the last sentence says what is meant by what comes after it.
pub(super) fn defines(tokens: &[Placed<'_>]) -> bool {
    let defining = |(token, _): &Placed<'_>| match token {
        Token::Word(word) => DEFINING.contains(&word.to_lowercase().as_str()),
        _ => false,
    };
    last_sentence(tokens).is_some_and(|last| last.iter().any(defining))
}

/// The last sentence with a word in it.
pub(super) fn last_sentence<'t, 'a>(tokens: &'t [Placed<'a>]) -> Option<&'t [Placed<'a>]> {
    let says = |(token, _): &Placed<'_>| matches!(token, Token::Word(_));
    let mut sentences = tokens.split(|(token, _)| *token == Token::Stop);
    sentences.rfind(|sentence| sentence.iter().any(says))
}

/// Whether the last sentence says that what comes after it follows from something, as far as words tell; `None` where nothing
/// is said.
pub(super) fn read(tokens: &[Placed<'_>]) -> Option<bool> {
    let last = last_sentence(tokens)?;
    Some(last.iter().enumerate().any(|(at, (token, _))| {
        let Token::Word(word) = token else {
            return false;
        };
        // "From then on mechanical energy is conserved" tells when.
        let before = at.checked_sub(1).map(|before| last[before].0);
        let tells_when = matches!(
            before,
            Some(Token::Word(
                "from" | "From" | "since" | "only" | "till" | "until"
            ))
        );
        let word = word.to_lowercase();
        draws(&word) && !(word == "then" && tells_when) || WORKED.contains(&word.as_str())
    }))
}
