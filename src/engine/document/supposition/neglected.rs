//! Quantities that are neglected, and so zero: "Neglecting $v_2$, (1) gives", "If $v_2$ is negligible,", "We neglect $v_2$. Then".

use super::super::prose::{Placed, Token};
use super::super::{Supposition, SuppositionKind, Vanishing};
use super::mathematics::is_letters;

/// Before the quantity nothing stands but these.
const BEGINNING: &[&str] = &[
    "if", "we", "as", "since", "because", "when", "now", "let", "us",
];
const NEGLECTING: &[&str] = &["neglecting", "ignoring", "neglect", "ignore"];
const NEGLECTED: &[&str] = &["negligible", "neglected", "ignored"];
/// With these the sentence goes on. "Neglecting $m$ against $M$" leaves more than where $m = 0$.
const GOING_ON: &[&str] = &["we", "one", "in", "so"];

/// The quantity that a sentence neglects, and not beside another one.
pub(super) fn read(source: &str, sentence: &[Placed<'_>]) -> Option<Supposition> {
    let is_math = |(token, _): &Placed<'_>| matches!(token, Token::Math(_));
    let (before, rest) = sentence.split_at(sentence.iter().position(is_math)?);
    let [(Token::Math(body), _), after @ ..] = rest else {
        return None;
    };
    let begins = |(token, _): &Placed<'_>| token.is_among(BEGINNING) || token.is_among(NEGLECTING);
    if !before.iter().all(begins) || !is_letters(source.get(body.range())?) {
        return None;
    }
    let after = match (before, after) {
        ([.., (last, _)], after) if last.is_among(NEGLECTING) => after,
        (_, [(be, _), (neglected, _), after @ ..])
            if be.is_among(&["is", "are"]) && neglected.is_among(NEGLECTED) =>
        {
            after
        }
        _ => return None,
    };
    let goes_on =
        (after.first()).is_none_or(|(token, _)| token.is_mark(',') || token.is_among(GOING_ON));
    goes_on.then_some(Supposition {
        kind: SuppositionKind::Vanishes(Vanishing::Term),
        body: *body,
    })
}
