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

/// The names that are read, the longer first, with those of what they are measured in, and the letters that they are read for, where others
/// mean something else by them. A rate, a flux or a moment says nothing of what it is measured in.
#[rustfmt::skip]
static NAMES: &[Name] = &[
    ("young's modulus", "pressure", &[]),
    ("diffusion coefficient", "diffusivity", &[]),
    ("speed of light", "speed of light", &[]),
    ("volume flow rate", "volume flow rate", &[]),
    ("surface charge density", "surface charge density", &[]),
    ("moment of inertia", "moment of inertia", &[]),
    ("mass flow rate", "mass flow rate", &[]),
    ("speed of sound", "speed of sound", &[]),
    ("surface tension", "surface tension", &[]),
    ("thermal diffusivity", "thermal diffusivity", &[]),
    ("angular momentum", "angular momentum", &[]),
    ("boltzmann constant", "boltzmann constant", &[]),
    ("angular acceleration", "angular acceleration", &[]),
    ("current density", "current density", &[]),
    ("angular speed", "angular speed", &[]),
    ("molar mass", "molar mass", &[]),
    ("focal length", "focal length", &[]),
    ("mass density", "mass density", &[]),
    ("spring constant", "spring constant", &[]),
    ("thermal conductivity", "thermal conductivity", &[]),
    ("potential energy", "potential energy", &[]),
    ("angular frequency", "angular frequency", &[]),
    ("gas constant", "gas constant", &[]),
    ("kinematic viscosity", "kinematic viscosity", &[]),
    ("kinetic energy", "kinetic energy", &[]),
    ("diffusion constant", "diffusivity", &[]),
    ("dynamic viscosity", "dynamic viscosity", &[]),
    ("number density", "number density", &[]),
    ("gravitational constant", "gravitational constant", &[]),
    ("energy density", "energy density", &[]),
    ("magnetic field", "magnetic field", &[]),
    ("electric field", "electric field", &[]),
    ("angular velocity", "angular velocity", &[]),
    ("charge density", "charge density", &[]),
    ("mass", "mass", &[]),
    ("length", "length", &[]),
    ("distance", "distance", &[]),
    ("height", "height", &[]),
    ("depth", "depth", &[]),
    ("width", "width", &[]),
    ("radius", "radius", &[]),
    ("diameter", "diameter", &[]),
    ("wavelength", "wavelength", &[]),
    ("time", "time", &[]),
    ("duration", "duration", &[]),
    ("velocity", "velocity", &[]),
    ("speed", "speed", &[]),
    ("acceleration", "acceleration", &[]),
    ("momentum", "momentum", &[]),
    ("force", "force", &[]),
    ("torque", "torque", &[]),
    ("pressure", "pressure", &[]),
    ("temperature", "temperature", &[]),
    ("area", "area", &[]),
    ("volume", "volume", &[]),
    ("frequency", "frequency", &[]),
    ("charge", "charge", &[]),
    ("voltage", "voltage", &[]),
    ("resistance", "resistance", &[]),
    ("capacitance", "capacitance", &[]),
    ("inductance", "inductance", &[]),
    ("resistivity", "resistivity", &[]),
    ("permittivity", "permittivity", &[]),
    ("permeability", "permeability", &[]),
    ("density", "mass density", &["\\rho", "\\varrho"]),
    ("power", "power", &["P"]),
    ("current", "current", &["I", "i"]),
    ("tension", "force", &["T", "F"]),
    ("cross-section", "area", &["A", "S", "a"]),
    ("luminosity", "power", &["L"]),
    ("viscosity", "dynamic viscosity", &["\\eta", "\\mu"]),
    ("stress", "pressure", &["\\sigma", "\\tau"]),
    ("energy", "energy", &["E", "U", "W"]),
    ("thickness", "thickness", &[]),
];
/// A name, that of what it is measured in, and the letters that it is read for.
type Name = (&'static str, &'static str, &'static [&'static str]);
/// The longest name in words.
const LONGEST: usize = 3;
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
]);
/// After these a symbol is what is spoken of.
const SPEAKING: [&str; 7] = ["where", "here", "if", "with", "since", "let", "when"];
const LINKING: [&str; 6] = ["is", "are", "be", "denotes", "denote", "being"];
/// With these after it a name is all that is said.
const AFTER: [&str; 17] = [
    "of", "and", "at", "in", "to", "for", "from", "between", "with", "on", "along", "inside",
    "outside", "above", "below", "behind", "through",
];
/// So far before a symbol it is looked for what is said of it.
const MOST_BEFORE: usize = 64;
/// So many words describe what is named after a symbol.
const MOST_DESCRIBING: usize = 2;
/// So many words after a symbol are looked at for what it is counted per.
const MOST_AFTER: usize = 5;

/// The quantities that symbols are said to be, in order.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Quantity> {
    let mut found: Vec<Quantity> = Vec::new();
    for at in 0..tokens.len() {
        let Token::Math(body) = tokens[at].0 else {
            continue;
        };
        if is_per_something(&tokens[at + 1..]) {
            continue;
        }
        let list = first_of_list(tokens, at);
        let Token::Math(first) = tokens[list].0 else {
            continue;
        };
        let name = name_before(&tokens[..list]);
        let is_explained = name.is_none();
        let Some(&(_, name, letters)) = name.or_else(|| name_after(tokens, at)) else {
            continue;
        };
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
    (1..=LONGEST.min(before.len())).rev().find_map(|words| {
        let (rest, last) = before.split_at(before.len() - words);
        let name = NAMES.iter().find(|(name, ..)| is_named(last, name))?;
        is_of_itself(rest).then_some(name)
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

/// Whether some words are a name, in the plural perhaps.
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
    let near = &tokens[at.saturating_sub(MOST_BEFORE)..at];
    let start = near.iter().rposition(|(token, _)| token.is_stop());
    let sentence = &near[start.map_or(0, |stop| stop + 1)..];
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
            let name = NAMES
                .iter()
                .find(|(name, ..)| is_named(&named[..words], name))?;
            let ends = match named.get(words) {
                None => true,
                Some((Token::Word(_), _)) => among(named, words, &AFTER),
                Some((token, _)) => token.is_stop() || matches!(token, Token::Mark(_)),
            };
            (ends && !is_per_something(&named[words..])).then_some(name)
        })
    })
}
