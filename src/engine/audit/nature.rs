//! The constants of nature: their letters, what they are measured in, and their values as authors round them.
//!
//! **Source.** CODATA 2022 and BIPM, *The International System of Units*, 9th edition; standard gravity of the 3rd CGPM.

use num_traits::Pow;

use crate::algebra::{BigRational, Dimension, Expr, Formula, Symbol};
use crate::derivation::{Assumed, Source};
use crate::dimension::named;
use crate::kernel::Standing;
use crate::sorted::Set;

/// A constant.
pub(super) struct Constant {
    letters: &'static [&'static str],
    /// Another letter, which may as well be something else where no figures are put in.
    also: Option<&'static str>,
    /// What it is.
    pub name: &'static str,
    /// The values that are usual, in units of the SI but for the power of ten that all of these have.
    pub values: &'static [&'static str],
    tens: i32,
    measured: Option<Measure>,
}

/// The name of what a constant is measured in, and words without one of which its letter means something else.
struct Measure(&'static str, &'static [&'static str]);

const fn constant(
    letters: &'static [&'static str],
    name: &'static str,
    values: &'static [&'static str],
    tens: i32,
) -> Constant {
    Constant {
        letters,
        also: None,
        name,
        values,
        tens,
        measured: None,
    }
}

#[rustfmt::skip]
pub(super) static CONSTANTS: &[Constant] = &[
    constant(&["g"], "standard gravity", &["9.81", "9.8", "9.80665", "10"], 0)
        .measured_as("acceleration", &["gravit", "weight", "pendulum", "fall", "buoyan", "hydrostatic"]),
    constant(&["c"], "the speed of light", &["2.99792458", "2.998", "3"], 8).also("c_0")
        .measured_as("velocity", &["light", "photon", "relativ", "radiat"]),
    constant(&["G"], "the constant of gravitation", &["6.6743", "6.674", "6.67"], -11)
        .measured_as("gravitational constant", &["gravit", "planet", "star", "solar", "galax", "orbit"]),
    constant(&["h"], "the Planck constant", &["6.62607015", "6.626", "6.63"], -34),
    constant(&["\\hbar"], "the reduced Planck constant", &["1.054571817", "1.0546", "1.055", "1.05"], -34)
        .measured_as("action", &[]),
    constant(&["k_B", "k_{\\text{B}}"], "the Boltzmann constant", &["1.380649", "1.381", "1.38"], -23).also("k")
        .measured_as("boltzmann constant", &[]),
    constant(&["N_A", "N_{\\text{A}}"], "the Avogadro constant", &["6.02214076", "6.022", "6.02"], 23),
    constant(&["R"], "the gas constant", &["8.314462618", "8.314", "8.31"], 0)
        .measured_as("gas constant", &["ideal gas", "gas constant", "mole"]),
    constant(&["e"], "the elementary charge", &["1.602176634", "1.602", "1.6"], -19).also("q_e")
        .measured_as("charge", &["electron", "ions", "plasma", "proton"]),
    constant(&["m_e", "m_{\\text{e}}"], "the mass of the electron", &["9.1093837", "9.109", "9.11"], -31)
        .measured_as("mass", &["electron"]),
    constant(&["m_p", "m_{\\text{p}}"], "the mass of the proton", &["1.6726219", "1.673", "1.67"], -27),
    constant(&["\\epsilon_0", "\\varepsilon_0"], "the electric constant", &["8.8541878", "8.854", "8.85"], -12)
        .measured_as("permittivity", &[]),
    constant(&["\\mu_0"], "the magnetic constant", &["1.2566370614", "1.2566", "1.257", "1.26"], -6)
        .measured_as("permeability", &["magnet", "current", "coil"]),
    constant(&["\\sigma", "\\sigma_{SB}", "\\sigma_{\\text{SB}}"], "the Stefan\u{2013}Boltzmann constant", &["5.670374", "5.67"], -8),
    constant(&["F"], "the Faraday constant", &["9.648533", "9.649", "9.65"], 4),
    constant(&["\\mu_B", "\\mu_{\\text{B}}"], "the Bohr magneton", &["9.2740101", "9.274", "9.27"], -24),
];

impl Constant {
    const fn also(self, letter: &'static str) -> Constant {
        Constant {
            also: Some(letter),
            ..self
        }
    }

    const fn measured_as(self, name: &'static str, words: &'static [&'static str]) -> Constant {
        Constant {
            measured: Some(Measure(name, words)),
            ..self
        }
    }

    /// Whether a symbol may stand for it.
    pub fn may_be(&self, symbol: &Symbol) -> bool {
        self.letters.contains(&symbol.name()) || self.also == Some(symbol.name())
    }

    /// What a symbol is measured in, if it stands for this in a text, which is given in small letters.
    pub fn dimension_in(&self, text: &str, symbol: &Symbol) -> Option<Dimension> {
        let Measure(name, words) = self.measured.as_ref()?;
        let speaks = || words.is_empty() || words.iter().any(|word| text.contains(word));
        (self.letters.contains(&symbol.name()) && speaks()).then(|| named(name))?
    }

    /// One of its values, or the nearest to that.
    pub fn value(&self, nearness: usize) -> Option<BigRational> {
        let written = self.values.get(nearness).or(self.values.last())?;
        let (whole, decimals) = written.split_once('.').unwrap_or((written, ""));
        let digits: i64 = format!("{whole}{decimals}").parse().ok()?;
        let places = i32::try_from(decimals.len()).ok()?;
        let ten = BigRational::from_integer(10.into());
        Some(BigRational::from_integer(digits.into()) * Pow::pow(ten, self.tens - places))
    }
}

/// What the constants of which a step and what it is to follow from speak have to do with one another, and that they are positive; nothing where
/// what is assumed says that itself, or gives figures for one of them, which are rounded.
///
/// `c^2 = \frac{1}{\varepsilon_0 \mu_0}`, `\hbar = \frac{h}{2 \pi}`.
pub(super) fn relations(stated: &Set<Symbol>, assumed: &[Assumed]) -> Vec<Assumed> {
    let one = |letters: &[&str]| {
        let mut letters = letters.iter().map(|own| Symbol::new(*own));
        letters.find(|symbol| {
            let mut terms = assumed.iter().flat_map(|own| own.formula.terms());
            stated.contains(symbol) || terms.any(|term| term.mentions(symbol))
        })
    };
    let symbol = |own: &Symbol| Expr::Symbol(own.clone());
    let quotient = |over: Expr, under: [Expr; 2]| {
        Expr::Quotient(over.into(), Expr::Product(under.into()).into())
    };
    let light = || {
        let magnetic = one(&["\\mu_0"])?;
        let electric = one(&["\\varepsilon_0", "\\epsilon_0"])?;
        let c = one(&["c", "c_0"])?;
        let square = Expr::Power(symbol(&c).into(), Expr::integer(2).into());
        let other = quotient(Expr::integer(1), [symbol(&electric), symbol(&magnetic)]);
        Some((Formula::equal(square, other), vec![c, electric, magnetic]))
    };
    let action = || {
        let (reduced, whole) = (one(&["\\hbar"])?, one(&["h"])?);
        let other = quotient(symbol(&whole), [Expr::integer(2), Expr::symbol("\\pi")]);
        Some((
            Formula::equal(symbol(&reduced), other),
            vec![reduced, whole],
        ))
    };
    let is_known = |symbols: &[Symbol]| {
        let of_figures =
            |own: &Formula| own.set_to_number().is_some_and(|set| symbols.contains(set));
        let says_all = |own: &Formula| {
            let names = own.names();
            symbols.iter().all(|symbol| names.contains(symbol))
        };
        assumed
            .iter()
            .any(|own| of_figures(&own.formula) || says_all(&own.formula))
    };
    let relations = [light(), action()].into_iter().flatten();
    let relations = relations.filter(|(_, symbols)| !is_known(symbols));
    let said = relations.flat_map(|(relation, symbols)| {
        let positive = symbols
            .into_iter()
            .map(|own| Formula::positive(Expr::Symbol(own)));
        [relation].into_iter().chain(positive)
    });
    let known = |formula: Formula| Assumed {
        formula: formula.into(),
        standing: Standing::Identity,
        source: Source::Nature,
    };
    said.map(known).collect()
}
