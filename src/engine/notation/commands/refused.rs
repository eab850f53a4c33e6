//! What to say about commands that are not read.

use super::{known, relation, unread};
use crate::notation::shorthand::is_abbreviation;

/// Commands that are understood and refused: what they are called, and what to do instead.
const REFUSED: &[(&str, &str, Option<&str>)] = &[
    (
        "stackrel",
        "only `?`, `!` and citations are read above a relation sign",
        Some("write `\\stackrel{?}{=}`, or say in the text why it is so"),
    ),
    (
        "overset",
        "only `?`, `!` and citations are read above a relation sign",
        Some("write `\\stackrel{?}{=}`, or say in the text why it is so"),
    ),
    ("not", "`\\not` is read only before `=`", None),
    (
        "left",
        "after `\\left` a delimiter is expected: `(`, `[`, `\\{`, `|`, `\\lceil` or `\\lfloor`",
        None,
    ),
    (
        "pm",
        "`\\pm` states two equations at once, which is not read",
        Some("write the two cases as two equations"),
    ),
    (
        "mp",
        "`\\mp` states two equations at once, which is not read",
        Some("write the two cases as two equations"),
    ),
    (
        "partial",
        "`\\partial` is read only in derivatives",
        Some("write `\\frac{\\partial f}{\\partial x}`, or `\\partial_x f`"),
    ),
    (
        "prod",
        "products over an index (`\\prod`) are not read",
        None,
    ),
    (
        "infty",
        "`\\infty` is no number: it is read only where a limit goes, `\\lim_{x \\to \\infty}`",
        None,
    ),
    (
        "to",
        "`\\to` is read only inside `\\lim_{x \\to a}`, and in chains with `=`",
        None,
    ),
    (
        "colorbox",
        "`\\colorbox` is not read: colours do not belong to the mathematics",
        Some("use `\\boxed{…}`"),
    ),
    (
        "cancel",
        "`\\cancel` is not read: whether what is crossed out counts is not clear",
        Some("write the equation after cancelling"),
    ),
    (
        "forall",
        "`\\forall` is read before a statement or behind it, and not in it",
        Some("write `x^2 \\geq 0 \\quad \\forall x`"),
    ),
    (
        "exists",
        "`\\exists` is not read: state the quantifier in the text",
        None,
    ),
    ("over", "`\\over` is not read", Some("write `\\frac{…}{…}`")),
    (
        "circ",
        "degrees are read only right after a number, as in `30^\\circ`",
        Some("write the angle in radians: `30^\\circ` is `\\pi/6`"),
    ),
    (
        "%",
        "`\\%` is read only right after a number, as in `40\\,\\%`",
        None,
    ),
    (
        "mid",
        "`\\mid` is not read: the notation has no conditional probabilities",
        Some("give it a name of its own"),
    ),
    ("middle", "`\\middle` is not read", None),
    (
        "max",
        "`\\max` is read only as a subscript, as in `\\eta_{\\max}`",
        Some("write the cases as two statements, each with its condition"),
    ),
    (
        "min",
        "`\\min` is read only as a subscript, as in `\\eta_{\\min}`",
        Some("write the cases as two statements, each with its condition"),
    ),
];

/// Whether a command is refused with a reason of its own.
pub(super) fn is_refused(command: &str) -> bool {
    REFUSED.iter().any(|(own, ..)| *own == command) || unread::reason(command).is_some()
}

/// What to say about a command that cannot stand where it stands: message and help.
pub(in crate::notation) fn complaint(command: &str) -> (String, Option<String>) {
    if let Some((_, message, help)) = REFUSED.iter().find(|(name, ..)| *name == command) {
        return ((*message).to_owned(), help.map(str::to_owned));
    }
    if let Some((why, help)) = unread::reason(command) {
        return (
            format!("`\\{command}` is not read: {why}"),
            help.map(str::to_owned),
        );
    }
    if known().any(|name| name == command)
        || relation(command).is_some()
        || is_abbreviation(command)
    {
        return (format!("`\\{command}` cannot stand here"), None);
    }
    let help = nearest(command).map(|name| format!("did you mean `\\{name}`?"));
    (format!("`\\{command}` is not known"), help)
}

/// The known command that a misspelt one is nearest to, if it is near enough to be meant.
fn nearest(command: &str) -> Option<&'static str> {
    let length = command.chars().count();
    if !(2..=20).contains(&length) {
        return None;
    }
    let allowed = if length < 4 { 1 } else { 2 };
    known()
        .map(|name| (strsim::osa_distance(command, name), name))
        .filter(|(distance, _)| *distance <= allowed)
        .min()
        .map(|(_, name)| name)
}
