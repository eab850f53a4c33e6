//! Values of what has no symbol in its sentence: "For an angle of $30^\circ$, (1) gives", "At an inclination of 30 degrees".
//!
//! Of what they are values is not known: what follows may follow from them.

use super::super::prose::{Placed, Token, ends_sentence};
use super::super::{Supposition, SuppositionKind};
use super::mathematics::{is_number, relates};

/// A value stands after one of these.
const BEFORE: &[&str] = &["of", "at", "for", "by"];
/// A number in words is an angle with one of these after it.
const DEGREES: &[&str] = &["degree", "degrees"];
/// This writes an angle with its unit, `on a slope of \ang{20}`.
const ANGLE: &str = "\\ang{";
/// How far before it the phrase begins in which a value stands.
const MOST_NAMING: usize = 2;

/// The first such value in the sentence that leads on to a display.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Option<Supposition> {
    let sentence = tokens.rsplit(|token| ends_sentence(source, token)).next()?;
    let is_value = |at: usize| match sentence[at].0 {
        Token::Math(body) => source.get(body.range()).is_some_and(|own| {
            let angle = own.contains("circ") || own.contains("\\pi");
            let plain = own
                .replace("\\pi", "")
                .replace("\\circ", "")
                .replace("\\degree", "");
            angle && !relates(own) && is_number(&plain)
        }),
        Token::Number(number) => {
            let next = sentence.get(at + 1).map(|(token, _)| *token);
            let before = source.get(..sentence[at].1.start).unwrap_or_default();
            let is_angle = number.contains('°') || before.ends_with(ANGLE);
            is_angle || next.is_some_and(|next| next.is_among(DEGREES))
        }
        _ => false,
    };
    let at = (1..sentence.len()).find(|&at| sentence[at - 1].0.is_among(BEFORE) && is_value(at))?;
    let begin = (at - 1).saturating_sub(MOST_NAMING);
    Some(Supposition {
        kind: SuppositionKind::Unread,
        body: sentence[begin].1.to(sentence[at].1),
    })
}
