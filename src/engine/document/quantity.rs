//! What prose says a symbol is by the name of a quantity: "a rod of length $L$", "the masses $m_1$ and $m_2$", "where $p$ is the pressure".
//!
//! A name says more with others beside it, "mass per length", "vapour density", so that only those that leave it what it is may stand there.

use super::Span;
use super::prose::{Placed, Token, among, in_lower_case};
use super::words::Words;

/// The name of a quantity, and what it is the name of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// The name, in the singular.
    pub name: &'static str,
    /// The inside of the mathematics that it is said of.
    pub body: Span,
    /// That of the first that it is said of in one breath: "the masses $m_1$ and $m_2$".
    pub first: Span,
    /// Whether a whole clause says so: "where $p$ is the pressure".
    pub is_explained: bool,
}

/// A name, that of what it is measured in, and the letters that it is read for where others mean something else by them.
type Name = (&'static str, &'static str, &'static [&'static str]);

const fn plain(name: &'static str) -> Name {
    (name, name, &[])
}

const fn measured_as(
    name: &'static str,
    of: &'static str,
    letters: &'static [&'static str],
) -> Name {
    (name, of, letters)
}

/// The names that are read. A rate, a flux or a moment says nothing of what it is measured in.
#[rustfmt::skip]
static NAMES: &[Name] = &[
    plain("speed of light"), plain("volume flow rate"), plain("surface charge density"), plain("moment of inertia"),
    plain("mass flow rate"), plain("speed of sound"), plain("surface tension"), plain("thermal diffusivity"), plain("angular momentum"),
    plain("boltzmann constant"), plain("angular acceleration"), plain("current density"), plain("angular speed"), plain("molar mass"),
    plain("focal length"), plain("mass density"), plain("spring constant"), plain("thermal conductivity"), plain("potential energy"),
    plain("angular frequency"), plain("gas constant"), plain("kinematic viscosity"), plain("kinetic energy"),
    plain("dynamic viscosity"), plain("number density"), plain("gravitational constant"), plain("energy density"),
    plain("magnetic field"), plain("electric field"), plain("angular velocity"), plain("charge density"),
    measured_as("mass per unit length", "line density", &[]), measured_as("mass per unit area", "surface density", &[]),
    measured_as("mass per unit volume", "mass density", &[]), measured_as("charge per unit area", "surface charge density", &[]),
    measured_as("charge per unit volume", "charge density", &[]), measured_as("force per unit area", "pressure", &[]),
    measured_as("force per unit length", "surface tension", &[]), measured_as("energy per unit volume", "energy density", &[]),
    measured_as("energy per unit area", "surface tension", &[]), measured_as("power per unit area", "intensity", &[]),
    measured_as("current per unit area", "current density", &[]), measured_as("energy per unit mass", "specific energy", &[]),
    measured_as("young's modulus", "pressure", &[]),
    measured_as("diffusion coefficient", "diffusivity", &[]),
    measured_as("diffusion constant", "diffusivity", &[]),
    plain("mass"), plain("length"), plain("distance"), plain("height"), plain("depth"), plain("width"), plain("radius"),
    plain("diameter"), plain("wavelength"), plain("time"), plain("duration"), plain("velocity"), plain("speed"), plain("acceleration"),
    plain("momentum"), plain("force"), plain("torque"), plain("pressure"), plain("temperature"), plain("area"), plain("volume"),
    plain("frequency"), plain("charge"), plain("voltage"), plain("resistance"), plain("capacitance"), plain("inductance"),
    plain("resistivity"), plain("permittivity"), plain("permeability"), plain("thickness"),
    measured_as("density", "mass density", &["\\rho", "\\varrho"]),
    measured_as("power", "power", &["P"]),
    measured_as("period", "time", &["T"]),
    measured_as("resistor", "resistance", &["R"]),
    measured_as("inductor", "inductance", &["L"]),
    measured_as("capacitor", "capacitance", &["C"]),
    measured_as("work", "energy", &["W"]),
    measured_as("current", "current", &["I", "i"]),
    measured_as("tension", "force", &["T", "F"]),
    measured_as("cross-section", "area", &["A", "S", "a"]),
    measured_as("luminosity", "power", &["L"]),
    measured_as("stiffness", "spring constant", &["k", "\\kappa"]),
    measured_as("viscosity", "dynamic viscosity", &["\\eta", "\\mu"]),
    measured_as("stress", "pressure", &["\\sigma", "\\tau"]),
    measured_as("energy", "energy", &["E", "U", "W"]),
];
/// The longest name in words.
const LONGEST: usize = 4;
/// With one of these before it a name is that of something else.
static OF_ANOTHER: Words = Words::of(&[
    "per",
    "unit",
    "specific",
    "molar",
    "partial",
    "reduced",
    "scaled",
    "normalised",
    "normalized",
    "dimensionless",
    "nondimensional",
    "relative",
    "fractional",
    "logarithmic",
    "generalised",
    "generalized",
    "virtual",
    "number",
    "probability",
    "optical",
    "log",
    "spectral",
    "surface",
    "linear",
    "areal",
    "column",
    "phase",
    "angular",
    "hyperbolic",
    "inverse",
    "reciprocal",
    "path",
    "word",
    "code",
    "data",
    "time",
    "squared",
    "square",
    "mean-square",
    "magnetic",
    "topological",
    "color",
    "proper",
    "half",
    "twice",
    "bending",
    "torsional",
    "flexural",
    "rotational",
]);
/// After these a symbol is what is spoken of.
const SPEAKING: [&str; 7] = ["where", "here", "if", "with", "since", "let", "when"];
/// These say of a symbol what is named, or of what is named a symbol.
const LINKING: [&str; 6] = ["is", "are", "be", "denotes", "denote", "being"];
/// With these after it a name is all that is said.
const AFTER: [&str; 17] = [
    "of", "and", "at", "in", "to", "for", "from", "between", "with", "on", "along", "inside",
    "outside", "above", "below", "behind", "through",
];
/// Without more words each of these is said of several things: of what stands in the way of heat and of a current, of a temperature and its energy.
const LOOSE: [&str; 12] = [
    "resistance",
    "resistivity",
    "temperature",
    "time",
    "voltage",
    "current",
    "charge",
    "tension",
    "stress",
    "permittivity",
    "permeability",
    "energy",
];
/// With one of these a sentence leads on to what something is.
const SAYING: [&str; 6] = ["is", "becomes", "equals", "was", "reads", "be"];
/// These may stand behind that.
const TRAILING: [&str; 10] = [
    "then",
    "therefore",
    "thus",
    "hence",
    "simply",
    "just",
    "now",
    "given",
    "by",
    "again",
];
/// What comes after these is what the display gives, with an article, or without.
const GIVING: [&str; 15] = [
    "give", "gives", "gave", "giving", "yield", "yields", "yielding", "obtain", "obtains", "find",
    "finds", "get", "use", "used", "using",
];
const HAVING: [&str; 4] = ["with", "has", "have", "having"];
/// A subject begins with one of these.
const ARTICLES: [&str; 5] = ["the", "its", "their", "this", "a"];
/// One of these may stand before it.
const BEFORE_SUBJECT: [&str; 13] = [
    "and",
    "so",
    "then",
    "hence",
    "thus",
    "therefore",
    "that",
    "where",
    "but",
    "consequently",
    "finally",
    "accordingly",
    "while",
];
/// In so many words something is said of a subject, and in so many a sentence.
const LONGEST_SUBJECT: usize = 10;
const LONGEST_SENTENCE: usize = 40;
/// So far before a symbol it is looked for what is said of it.
const MOST_BEFORE: usize = 64;
/// So many words describe what is named after a symbol.
const MOST_DESCRIBING: usize = 2;
/// So many words after a symbol are looked at for what it is counted per.
const MOST_AFTER: usize = 5;

/// What a display says, where the sentence that leads on to it has the name of a quantity for its subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Subject {
    /// The name, in the singular.
    pub name: &'static str,
    letters: &'static [&'static str],
}

impl Subject {
    /// Whether it is meant by what a symbol is written with.
    pub(crate) fn may_be(&self, symbol: &str) -> bool {
        self.letters.is_empty() || self.letters.iter().any(|own| symbol.starts_with(own))
    }
}

/// The subject of the sentence that leads on to a display: "The kinetic energy of the disc is".
pub(super) fn subject(tokens: &[Placed<'_>]) -> Option<Subject> {
    let sentence = sentence_before(tokens, LONGEST_SENTENCE);
    // "is then given by"
    let trailing = |(token, _): &Placed<'_>| token.is_among(&TRAILING) || token.is_mark(',');
    let end = sentence.len()
        - sentence
            .iter()
            .rev()
            .take_while(|own| trailing(own))
            .count();
    let (said, verb) = sentence[..end].split_at(end.checked_sub(1)?);
    if !verb[0].0.is_among(&SAYING) {
        return object(sentence);
    }
    // "The force on the wall": what is said of it more nearly.
    let plain = said.iter().rev();
    let plain = plain.take_while(|(token, _)| matches!(token, Token::Word(_)));
    let clause = &said[said.len() - plain.take(LONGEST_SUBJECT).count()..];
    let before = &said[..said.len() - clause.len()];
    let article = clause.iter().position(|own| own.0.is_among(&ARTICLES))?;
    let begins = match (article.checked_sub(1), before.last()) {
        (Some(at), _) => clause[at].0.is_among(&BEFORE_SUBJECT),
        (None, Some((token, _))) => token.is_mark(',') || token.is_mark(';'),
        (None, None) => true,
    };
    let named = &clause[article + 1..];
    let name = |at: usize| {
        let words = (1..=LONGEST.min(named.len() - at)).rev();
        let mut found = words.filter_map(|words| Some((name_of(&named[at..at + words])?, words)));
        found.next()
    };
    let (at, (&(_, name, letters), words)) =
        (0..named.len().min(MOST_DESCRIBING + 1)).find_map(|at| Some((at, name(at)?)))?;
    let after = &named[at + words..];
    let goes_on = after.is_empty() || among(after, 0, &AFTER) && !among(after, 0, &["and"]);
    let is_plain = is_of_itself(&named[..at]) && !is_per_something(after) && goes_on;
    (begins && is_plain && !LOOSE.contains(&name)).then_some(Subject { name, letters })
}

/// What a sentence ends in that gives it, or has it: "The two together give the downward force", "It moves like a mass on a spring with stiffness".
fn object(sentence: &[Placed<'_>]) -> Option<Subject> {
    let comma = sentence.last().is_some_and(|(token, _)| token.is_mark(','));
    let sentence = &sentence[..sentence.len() - usize::from(comma)];
    let (before, &(_, name, letters)) = names_at_the_end(sentence).next()?;
    let says = |at: usize, words: &[&str]| {
        at < before.len() && among(before, before.len() - 1 - at, words)
    };
    let has = says(0, &HAVING);
    // "We find the distribution of speeds" gives another thing.
    let describes = |at: usize| !says(at, &AFTER);
    let is_given = |at: usize| says(at, &GIVING) || says(at, &HAVING);
    let gives = (0..=MOST_DESCRIBING)
        .any(|at| says(at, &ARTICLES) && is_given(at + 1) && (0..at).all(describes));
    (is_of_itself(before) && (has || gives) && !LOOSE.contains(&name))
        .then_some(Subject { name, letters })
}

/// The quantities that symbols are said to be, in order.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Quantity> {
    let mut found: Vec<Quantity> = Vec::new();
    for at in 0..tokens.len() {
        let Token::Math(body) = tokens[at].0 else {
            continue;
        };
        let list = first_of_list(tokens, at);
        let Token::Math(first) = tokens[list].0 else {
            continue;
        };
        let name = name_before(&tokens[..list]);
        let is_explained = name.is_none();
        let after = || name_after(tokens, at);
        let is_per = is_per_something(&tokens[at + 1..]);
        // "the mass $\mu$ per unit length", and "where $\mu$ is the mass per unit length".
        let name = name.filter(|_| !is_per).or_else(after);
        let Some(&(called, name, letters)) = name else {
            continue;
        };
        if is_per && !called.contains(" per ") {
            continue;
        }
        let text = source.get(body.range()).unwrap_or_default().trim_start();
        let is_meant = letters.is_empty() || letters.iter().any(|letter| text.starts_with(letter));
        found.extend(is_meant.then_some(Quantity {
            name,
            body,
            first,
            is_explained,
        }));
    }
    found
}

/// The sentence that some tokens end in, as far as it is so near.
fn sentence_before<'t, 'a>(tokens: &'t [Placed<'a>], most: usize) -> &'t [Placed<'a>] {
    let near = &tokens[tokens.len().saturating_sub(most)..];
    let start = near.iter().rposition(|(token, _)| token.is_stop());
    &near[start.map_or(0, |stop| stop + 1)..]
}

/// "the mass $\\mu$ per unit length"
fn is_per_something(after: &[Placed<'_>]) -> bool {
    let words = after.iter().take(MOST_AFTER).map(|(token, _)| *token);
    let mut clause = words.take_while(|token| matches!(token, Token::Word(_)));
    clause.any(|token| token.is_among(&["per", "over", "divided", "times", "squared", "units"]))
}

/// Where the list begins that a symbol is in: "$m_1$, $m_2$ and $m_3$".
fn first_of_list(tokens: &[Placed<'_>], mut at: usize) -> usize {
    let is_math = |at: usize| matches!(tokens[at].0, Token::Math(_));
    let joins = |at: usize| tokens[at].0.is_mark(',') || among(tokens, at, &["and", "or"]);
    let last = at.saturating_sub(MOST_BEFORE);
    while at >= last + 2 && joins(at - 1) && is_math(at - 2) {
        at -= 2;
    }
    at
}

/// The name that ends where a symbol begins: "the length $L$", "its length is $L$".
fn name_before(before: &[Placed<'_>]) -> Option<&'static Name> {
    let linked = before
        .split_last()
        .filter(|((token, _), _)| token.is_among(&LINKING));
    let before = linked.map_or(before, |(_, before)| before);
    let mut names = names_at_the_end(before);
    names.find_map(|(rest, name)| is_of_itself(rest).then_some(name))
}

/// The names that some words end in, the longest first, with what stands before each.
fn names_at_the_end<'t, 'a>(
    words: &'t [Placed<'a>],
) -> impl Iterator<Item = (&'t [Placed<'a>], &'static Name)> {
    let lengths = (1..=LONGEST.min(words.len())).rev();
    lengths.filter_map(|length| {
        let (rest, last) = words.split_at(words.len() - length);
        Some((rest, name_of(last)?))
    })
}

/// Whether what stands before a name leaves it what it is.
fn is_of_itself(before: &[Placed<'_>]) -> bool {
    match before.last() {
        Some((Token::Word(_), _)) => !among(before, before.len() - 1, &OF_ANOTHER),
        Some((Token::Mark(mark), _)) => matches!(mark, '(' | ',' | ':' | ';'),
        Some((token, _)) => token.is_stop(),
        None => true,
    }
}

/// The name that some words are, in the plural perhaps.
fn name_of(words: &[Placed<'_>]) -> Option<&'static Name> {
    let (Token::Word(first), _) = words.first()? else {
        return None;
    };
    // Nearly all are seen by the first letter to be others.
    let initial = first.as_bytes().first()?.to_ascii_lowercase();
    let mut names = NAMES.iter();
    names.find(|(name, ..)| name.as_bytes()[0] == initial && is_named(words, name))
}

fn is_named(words: &[Placed<'_>], name: &str) -> bool {
    let mut parts = name.split(' ');
    let alike = words.iter().all(|(token, _)| {
        let (Token::Word(word), Some(part)) = (token, parts.next()) else {
            return false;
        };
        let word = in_lower_case(word);
        *word == *part || is_plural(&word, part)
    });
    alike && parts.next().is_none()
}

fn is_plural(word: &str, name: &str) -> bool {
    match name {
        "radius" => word == "radii",
        "momentum" => word == "momenta",
        name => match name.strip_suffix('y') {
            Some(stem) => word.strip_prefix(stem) == Some("ies"),
            None => matches!(word.strip_prefix(name), Some("s" | "es")),
        },
    }
}

/// "where $k$ is the thermal conductivity of the wall"
fn name_after(tokens: &[Placed<'_>], at: usize) -> Option<&'static Name> {
    if !among(tokens, at + 1, &LINKING) || !among(tokens, at + 2, &["the", "its", "a", "an"]) {
        return None;
    }
    let sentence = sentence_before(&tokens[..at], MOST_BEFORE);
    let speaks = match sentence.last() {
        None => true,
        Some((token, _)) if token.is_among(&SPEAKING) => true,
        Some((token, _)) if token.is_mark(',') || token.is_among(&["and"]) => {
            sentence.iter().any(|(token, _)| token.is_among(&SPEAKING))
        }
        _ => false,
    };
    if !speaks {
        return None;
    }
    let rest = &tokens[at + 3..];
    (0..=MOST_DESCRIBING.min(rest.len())).find_map(|skipped| {
        let (describing, named) = rest.split_at(skipped);
        let plain = describing
            .iter()
            .all(|(token, _)| matches!(token, Token::Word(_)));
        if !plain || !is_of_itself(describing) {
            return None;
        }
        (1..=LONGEST.min(named.len())).rev().find_map(|words| {
            let name = name_of(&named[..words])?;
            let ends = match named.get(words) {
                None => true,
                Some((Token::Word(_), _)) => among(named, words, &AFTER),
                Some((token, _)) => token.is_stop() || matches!(token, Token::Mark(_)),
            };
            (ends && !is_per_something(&named[words..])).then_some(name)
        })
    })
}
