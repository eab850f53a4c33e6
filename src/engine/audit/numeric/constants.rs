//! Well-known constants that a text puts in without a word: `m g h = 3.9\,\mathrm{J}` after `m` and `h` alone.
//!
//! A letter may mean something else, so that a constant is taken only for what nothing before tells, and only to support what is said; what
//! is not supported is told where it is with one small edit. Authors round as they like: each value that is usual is tried.
//!
//! **Source.** CODATA 2022 and BIPM, *The International System of Units*, 9th edition; standard gravity of the 3rd CGPM.

use num_traits::Pow;

use crate::algebra::{BigRational, Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, Printed};

use super::super::Auditor;
use super::{Numeric, Taken, Weighed, weigh_rounded};

/// No more of them are put in at once.
const MOST: usize = 4;

/// A constant: its letters, what it is, the values that are usual, and the power of ten that all of these have, in units of the SI.
struct Constant {
    letters: &'static [&'static str],
    name: &'static str,
    values: &'static [&'static str],
    tens: i32,
}

const fn constant(
    letters: &'static [&'static str],
    name: &'static str,
    values: &'static [&'static str],
    tens: i32,
) -> Constant {
    Constant {
        letters,
        name,
        values,
        tens,
    }
}

#[rustfmt::skip]
static CONSTANTS: &[Constant] = &[
    constant(&["g"], "standard gravity", &["9.81", "9.8", "9.80665", "10"], 0),
    constant(&["c", "c_0"], "the speed of light", &["2.99792458", "2.998", "3"], 8),
    constant(&["G"], "the constant of gravitation", &["6.6743", "6.674", "6.67"], -11),
    constant(&["h"], "the Planck constant", &["6.62607015", "6.626", "6.63"], -34),
    constant(&["\\hbar"], "the reduced Planck constant", &["1.054571817", "1.0546", "1.055", "1.05"], -34),
    constant(&["k_B", "k_{\\text{B}}", "k"], "the Boltzmann constant", &["1.380649", "1.381", "1.38"], -23),
    constant(&["N_A", "N_{\\text{A}}"], "the Avogadro constant", &["6.02214076", "6.022", "6.02"], 23),
    constant(&["R"], "the gas constant", &["8.314462618", "8.314", "8.31"], 0),
    constant(&["e", "q_e"], "the elementary charge", &["1.602176634", "1.602", "1.6"], -19),
    constant(&["m_e", "m_{\\text{e}}"], "the mass of the electron", &["9.1093837", "9.109", "9.11"], -31),
    constant(&["m_p", "m_{\\text{p}}"], "the mass of the proton", &["1.6726219", "1.673", "1.67"], -27),
    constant(&["\\epsilon_0", "\\varepsilon_0"], "the electric constant", &["8.8541878", "8.854", "8.85"], -12),
    constant(&["\\mu_0"], "the magnetic constant", &["1.2566370614", "1.2566", "1.257", "1.26"], -6),
    constant(&["\\sigma", "\\sigma_{SB}", "\\sigma_{\\text{SB}}"], "the Stefan\u{2013}Boltzmann constant", &["5.670374", "5.67"], -8),
    constant(&["F"], "the Faraday constant", &["9.648533", "9.649", "9.65"], 4),
    constant(&["\\mu_B", "\\mu_{\\text{B}}"], "the Bohr magneton", &["9.2740101", "9.274", "9.27"], -24),
];

impl Constant {
    /// One of its values, or the nearest to that.
    fn value(&self, nearness: usize) -> Option<BigRational> {
        let written = self.values.get(nearness).or(self.values.last())?;
        let (whole, decimals) = written.split_once('.').unwrap_or((written, ""));
        let digits: i64 = format!("{whole}{decimals}").parse().ok()?;
        let places = i32::try_from(decimals.len()).ok()?;
        let ten = BigRational::from_integer(10.into());
        Some(BigRational::from_integer(digits.into()) * Pow::pow(ten, self.tens - places))
    }
}

impl Auditor<'_> {
    /// Goals from figures, with what the page prints and constants that nothing tells: supported, or so with one small edit.
    pub(super) fn with_what_is_usual(
        &self,
        at: usize,
        goals: &[Goal],
        figures: &[Assumed],
        printed: &[Printed],
    ) -> Option<Numeric> {
        let weigh = |goals: &[Goal], said: &[Printed]| {
            weigh_rounded(self.derivation, at, goals, figures, Taken::Exactly, said)
        };
        let plainly = weigh(goals, printed);
        if plainly.is_supported() {
            return Some(plainly);
        }
        let with = |said: &[Printed]| weigh(goals, said);
        let (mut numeric, said) = self.with_constants(at, &plainly, figures, printed, &with)?;
        if !numeric.is_supported() {
            let exactly = |goals: &[Goal]| weigh(goals, &said);
            numeric.nearest = self.slip_of_figures(at, goals, &numeric, &exactly);
            numeric.nearest.as_ref()?;
        }
        Some(numeric)
    }

    /// What is come to with constants, where something had no value without: supported, if that is so with any that are usual, and how it
    /// was worked out.
    pub(super) fn with_constants(
        &self,
        at: usize,
        weighed: &Numeric,
        figures: &[Assumed],
        said: &[Printed],
        weigh: &dyn Fn(&[Printed]) -> Numeric,
    ) -> Option<(Numeric, Vec<Printed>)> {
        if !matches!(weighed.outcome(), Weighed::NoValue(_)) {
            return None;
        }
        let goal = &weighed.links.first()?.goal;
        let page = &self.derivation.pages[self.derivation.equations[at].page];
        let is_told = |own: &Symbol| {
            page.domains.contains_key(own)
                || said.iter().any(|printed| printed.goal.is_of(own))
                || weighed.links.iter().any(|link| link.goal.is_of(own))
                || figures.iter().any(|assumed| assumed.is_of(own))
        };
        let constant = |own: &Symbol| {
            let mut all = CONSTANTS.iter();
            let found = all.find(|constant| constant.letters.contains(&own.name()))?;
            (!is_told(own)).then(|| (own.clone(), found))
        };
        let unknown: Vec<_> = weighed
            .unknown
            .iter()
            .filter_map(constant)
            .take(MOST)
            .collect();
        let usual = unknown.iter().map(|(_, own)| own.values.len()).max()?;
        let mut found = None;
        for nearness in 0..usual {
            let mut with = said.to_vec();
            for (symbol, constant) in &unknown {
                let value = Expr::Number(constant.value(nearness)?);
                with.push(Printed {
                    goal: Goal {
                        formula: Formula::equal(Expr::Symbol(symbol.clone()), value),
                        rounding: None,
                        ..goal.clone()
                    },
                    span: self.derivation.equations[at].body,
                    equation: Some(at),
                    constant: Some(constant.name),
                });
            }
            let numeric = weigh(&with);
            match numeric.outcome() {
                Weighed::Supported => return Some((numeric, with)),
                Weighed::Contradicted => found = found.or(Some((numeric, with))),
                _ => return None,
            }
        }
        found
    }
}
