//! Quantities as siunitx writes them, `\qty{9.81}{m/s^2}`: an exact number and a product of powers of base units.
//!
//! A base unit is a positive symbol, `\unit{m}`, of the dimension that it measures. Every other unit is a number times a
//! product of powers of these, and so is every prefix; all of that is exact, so that 5 km = 5000 m is an identity and
//! 1 m = 1 s disagrees in dimension. What has no such number is refused: degrees of angle (π), degrees Celsius (they begin
//! elsewhere), decibels. **Source.** BIPM, *The International System of Units*, 9th edition, tables 2 to 8.

use crate::algebra::{Base, BigInt, BigRational, Symbol};

/// The base units, in the order in which they are printed.
const BASES: [(&str, Base); 7] = [
    ("kg", Base::Mass),
    ("m", Base::Length),
    ("s", Base::Time),
    ("A", Base::Current),
    ("K", Base::Temperature),
    ("mol", Base::Amount),
    ("cd", Base::Luminosity),
];

/// Exponents of kg, m, s, A, K, mol, cd.
type Powers = [i32; 7];

/// A unit: symbol, macro, powers of the base units, the number before them as numerator, denominator and power of ten,
/// and whether it takes prefixes.
type Row = (&'static str, &'static str, Powers, (u64, u64, i32), bool);

const UNITS: &[Row] = &[
    ("m", "metre", [0, 1, 0, 0, 0, 0, 0], (1, 1, 0), true),
    ("g", "gram", [1, 0, 0, 0, 0, 0, 0], (1, 1, -3), true),
    ("s", "second", [0, 0, 1, 0, 0, 0, 0], (1, 1, 0), true),
    ("A", "ampere", [0, 0, 0, 1, 0, 0, 0], (1, 1, 0), true),
    ("K", "kelvin", [0, 0, 0, 0, 1, 0, 0], (1, 1, 0), true),
    ("mol", "mole", [0, 0, 0, 0, 0, 1, 0], (1, 1, 0), true),
    ("cd", "candela", [0, 0, 0, 0, 0, 0, 1], (1, 1, 0), true),
    ("rad", "radian", [0, 0, 0, 0, 0, 0, 0], (1, 1, 0), true),
    ("sr", "steradian", [0, 0, 0, 0, 0, 0, 0], (1, 1, 0), false),
    ("Hz", "hertz", [0, 0, -1, 0, 0, 0, 0], (1, 1, 0), true),
    ("N", "newton", [1, 1, -2, 0, 0, 0, 0], (1, 1, 0), true),
    ("Pa", "pascal", [1, -1, -2, 0, 0, 0, 0], (1, 1, 0), true),
    ("J", "joule", [1, 2, -2, 0, 0, 0, 0], (1, 1, 0), true),
    ("W", "watt", [1, 2, -3, 0, 0, 0, 0], (1, 1, 0), true),
    ("C", "coulomb", [0, 0, 1, 1, 0, 0, 0], (1, 1, 0), true),
    ("V", "volt", [1, 2, -3, -1, 0, 0, 0], (1, 1, 0), true),
    ("F", "farad", [-1, -2, 4, 2, 0, 0, 0], (1, 1, 0), true),
    ("Ω", "ohm", [1, 2, -3, -2, 0, 0, 0], (1, 1, 0), true),
    ("S", "siemens", [-1, -2, 3, 2, 0, 0, 0], (1, 1, 0), true),
    ("Wb", "weber", [1, 2, -2, -1, 0, 0, 0], (1, 1, 0), true),
    ("T", "tesla", [1, 0, -2, -1, 0, 0, 0], (1, 1, 0), true),
    ("H", "henry", [1, 2, -2, -2, 0, 0, 0], (1, 1, 0), true),
    ("lm", "lumen", [0, 0, 0, 0, 0, 0, 1], (1, 1, 0), true),
    ("lx", "lux", [0, -2, 0, 0, 0, 0, 1], (1, 1, 0), true),
    ("Bq", "becquerel", [0, 0, -1, 0, 0, 0, 0], (1, 1, 0), true),
    ("Gy", "gray", [0, 2, -2, 0, 0, 0, 0], (1, 1, 0), true),
    ("Sv", "sievert", [0, 2, -2, 0, 0, 0, 0], (1, 1, 0), true),
    ("kat", "katal", [0, 0, -1, 0, 0, 1, 0], (1, 1, 0), true),
    ("min", "minute", [0, 0, 1, 0, 0, 0, 0], (60, 1, 0), false),
    ("h", "hour", [0, 0, 1, 0, 0, 0, 0], (3600, 1, 0), false),
    ("d", "day", [0, 0, 1, 0, 0, 0, 0], (86_400, 1, 0), false),
    (
        "yr",
        "year",
        [0, 0, 1, 0, 0, 0, 0],
        (31_557_600, 1, 0),
        true,
    ),
    ("Å", "angstrom", [0, 1, 0, 0, 0, 0, 0], (1, 1, -10), false),
    (
        "au",
        "astronomicalunit",
        [0, 1, 0, 0, 0, 0, 0],
        (149_597_870_700, 1, 0),
        false,
    ),
    ("L", "litre", [0, 3, 0, 0, 0, 0, 0], (1, 1, -3), true),
    ("l", "liter", [0, 3, 0, 0, 0, 0, 0], (1, 1, -3), true),
    ("t", "tonne", [1, 0, 0, 0, 0, 0, 0], (1, 1, 3), false),
    ("ha", "hectare", [0, 2, 0, 0, 0, 0, 0], (1, 1, 4), false),
    ("bar", "bar", [1, -1, -2, 0, 0, 0, 0], (1, 1, 5), true),
    (
        "eV",
        "electronvolt",
        [1, 2, -2, 0, 0, 0, 0],
        (1_602_176_634, 1, -28),
        true,
    ),
    ("Wh", "watthour", [1, 2, -2, 0, 0, 0, 0], (3600, 1, 0), true),
    (
        "Ah",
        "amperehour",
        [0, 0, 1, 1, 0, 0, 0],
        (3600, 1, 0),
        true,
    ),
    (
        "cal",
        "calorie",
        [1, 2, -2, 0, 0, 0, 0],
        (4184, 1, -3),
        true,
    ),
    (
        "atm",
        "atmosphere",
        [1, -1, -2, 0, 0, 0, 0],
        (101_325, 1, 0),
        false,
    ),
    ("%", "percent", [0, 0, 0, 0, 0, 0, 0], (1, 1, -2), false),
];

/// Prefixes: symbol, macro, power of ten.
const PREFIXES: &[(&str, &str, i32)] = &[
    ("Y", "yotta", 24),
    ("Z", "zetta", 21),
    ("E", "exa", 18),
    ("P", "peta", 15),
    ("T", "tera", 12),
    ("G", "giga", 9),
    ("M", "mega", 6),
    ("k", "kilo", 3),
    ("h", "hecto", 2),
    ("da", "deca", 1),
    ("d", "deci", -1),
    ("c", "centi", -2),
    ("m", "milli", -3),
    ("µ", "micro", -6),
    ("n", "nano", -9),
    ("p", "pico", -12),
    ("f", "femto", -15),
    ("a", "atto", -18),
    ("z", "zepto", -21),
    ("y", "yocto", -24),
];

/// The greatest exponent of ten, and of a unit.
const MOST_TENS: i32 = 400;
const MOST_POWER: i32 = 40;

/// A product of a number and powers of base units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Unit {
    pub number: BigRational,
    powers: Powers,
}

impl Unit {
    pub(super) fn one() -> Unit {
        Unit {
            number: BigRational::from_integer(1.into()),
            powers: [0; 7],
        }
    }

    /// The base units that occur, with their exponents.
    pub(super) fn factors(&self) -> impl Iterator<Item = (Symbol, i32)> {
        let named = BASES.iter().zip(self.powers);
        named
            .filter(|(_, power)| *power != 0)
            .map(|((name, _), power)| (Symbol::new(format!("\\unit{{{name}}}")), power))
    }

    /// Raises the last part of it to a power, `2` of `m/s` in `\text{m/s}^2`. Of `m/s^{-1}` nobody knows what is meant.
    pub(super) fn raise(&mut self, last: &Last, power: i32) -> Option<()> {
        let more = match last.below {
            true if power < 1 => return None,
            true => 1 - power,
            false => power - 1,
        };
        self.times(&last.unit, more)
    }

    pub(super) fn times(&mut self, other: &Unit, power: i32) -> Option<()> {
        if power.abs() > MOST_POWER {
            return None;
        }
        self.number *= other.number.pow(power);
        for (own, other) in self.powers.iter_mut().zip(other.powers) {
            *own += other * power;
            if own.abs() > MOST_POWER {
                return None;
            }
        }
        Some(())
    }
}

/// What a base unit measures; `None` for a symbol that is none.
pub fn measured(symbol: &Symbol) -> Option<Base> {
    let name = symbol.name().strip_prefix("\\unit{")?.strip_suffix('}')?;
    let base = BASES.iter().find(|(own, _)| *own == name)?;
    Some(base.1)
}

/// The number in `\qty{…}{…}` or `\num{…}`: digits with a decimal point, and perhaps a power of ten, `1.6e-19`.
pub(super) fn number(text: &str) -> Option<BigRational> {
    let text = text.trim();
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa.trim(), exponent.trim()),
        None => (text, "0"),
    };
    let (negative, mantissa) = match mantissa.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, mantissa.strip_prefix('+').unwrap_or(mantissa)),
    };
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let figures = |part: &str| part.bytes().all(|b| b.is_ascii_digit());
    if !figures(whole) || !figures(decimals) || whole.len() + decimals.len() == 0 {
        return None;
    }
    if whole.len() + decimals.len() > 2_000 || exponent.len() > 5 {
        return None;
    }
    let digits: BigInt = format!("{whole}{decimals}").parse().ok()?;
    let exponent: i32 = exponent
        .strip_prefix('+')
        .unwrap_or(exponent)
        .parse()
        .ok()?;
    let places = i32::try_from(decimals.len()).ok()?;
    if exponent.abs() > MOST_TENS {
        return None;
    }
    let value = BigRational::from_integer(digits) * tens(exponent - places);
    Some(if negative { -value } else { value })
}

fn tens(exponent: i32) -> BigRational {
    BigRational::from_integer(10.into()).pow(exponent)
}

fn row_unit(row: &Row, prefix: i32) -> Unit {
    let (over, under, ten) = row.3;
    Unit {
        number: BigRational::new(over.into(), under.into()) * tens(ten + prefix),
        powers: row.2,
    }
}

/// A unit by its symbol, perhaps with a prefix: `km`.
fn by_symbol(text: &str) -> Option<Unit> {
    if let Some(row) = UNITS.iter().find(|row| row.0 == text) {
        return Some(row_unit(row, 0));
    }
    let prefixed = PREFIXES.iter().filter_map(|(prefix, _, power)| {
        let rest = text.strip_prefix(prefix)?;
        let row = UNITS.iter().find(|row| row.4 && row.0 == rest)?;
        Some(row_unit(row, *power))
    });
    prefixed.into_iter().next().or_else(|| molar(text))
}

/// What is written below a stroke without a space, and meant as a product: `W/mK` is no watt per millikelvin.
fn per_kelvin(name: &str) -> Option<Unit> {
    let of = name.strip_suffix('K')?;
    let mut unit = ["m", "kg", "mol"].contains(&of).then(|| by_symbol(of))??;
    unit.times(&by_symbol("K")?, 1)?;
    Some(unit)
}

/// Moles per litre, `M`, with the prefixes that they have: `GM` is a product.
fn molar(text: &str) -> Option<Unit> {
    let prefix = text.strip_suffix('M')?;
    let power = match prefix {
        "" => 0,
        "m" | "µ" | "n" | "p" => PREFIXES.iter().find(|own| own.0 == prefix)?.2,
        _ => return None,
    };
    let mut unit = by_symbol("mol")?;
    unit.times(&by_symbol("L")?, -1)?;
    unit.number *= tens(power);
    Some(unit)
}

/// A unit by the command that is spelt as its symbol, a `u` for the sign of a millionth: `\kg`, `\m`, `\um`.
fn abbreviated(command: &str) -> Option<Unit> {
    let spelt = command.strip_prefix('u').map(|rest| format!("µ{rest}"));
    by_symbol(command).or_else(|| by_symbol(&spelt?))
}

/// The symbol of a prefix that is spelt as a command: `k` for `kilo`.
pub(super) fn prefix(command: &str) -> Option<&'static str> {
    let found = PREFIXES.iter().find(|own| own.1 == command);
    found.map(|own| own.0)
}

/// The symbol of a unit that is spelt as a command: `m` for `metre`.
pub(super) fn symbol(command: &str) -> Option<&'static str> {
    match command {
        "meter" => Some("m"),
        "kilogram" => Some("kg"),
        _ => UNITS.iter().find(|row| row.1 == command).map(|row| row.0),
    }
}

/// Whether upright letters after a number can only be a unit, as far as the letters tell. A `d` may be that of a differential, and an `M` by
/// itself is a mass as often, as `GM` is; of concentrations in it logarithms are taken, as if it were 1.
pub(super) fn is_symbol(text: &str) -> bool {
    let is_other = || text.ends_with('M') && !matches!(text, "mM" | "µM" | "nM" | "pM");
    text != "d" && !is_other() && by_symbol(text).is_some()
}

/// A unit as siunitx takes it, `m/s^2`, `kg.m^2.s^{-2}`, `\kilo\metre\per\second\squared`, or as it is written by hand,
/// `J/(mol\,K)`, `\frac{m}{s^2}`, `k\Omega`.
///
/// # Errors
/// What in it is not read.
pub(super) fn read(text: &str) -> Result<Unit, String> {
    Ok(read_with_last(text)?.0)
}

/// The last part of a unit, of which a power behind the whole is meant: the second in `m/s`.
#[derive(Clone, Debug)]
pub(super) struct Last {
    unit: Unit,
    below: bool,
}

/// The same, with the last part of it, if that has no power yet.
pub(super) fn read_with_last(text: &str) -> Result<(Unit, Option<Last>), String> {
    let mut reader = Reader {
        rest: text,
        unit: Unit::one(),
        below: false,
        strokes: 0,
        after_stroke: 0,
        raised: 1,
        group: false,
        last: None,
    };
    while reader.step()? {}
    if reader.below || reader.raised != 1 || reader.group {
        return Err(format!("`{}` ends where a unit is expected", text.trim()));
    }
    // `J/kg K`: whether K stands below the stroke, the page does not tell.
    if reader.strokes > 0 && reader.after_stroke > 1 {
        return Err(format!(
            "what stands below the stroke in `{}` is not clear: write `J.kg^{{-1}}.K^{{-1}}` or `\\per`",
            text.trim()
        ));
    }
    Ok((reader.unit, reader.last))
}

struct Reader<'a> {
    rest: &'a str,
    unit: Unit,
    /// The next unit is divided by.
    below: bool,
    strokes: usize,
    /// How many units stand after the first stroke.
    after_stroke: usize,
    /// The power of the next unit, from `\square` and `\cubic`.
    raised: i32,
    /// Inside the parentheses that stand below the stroke.
    group: bool,
    /// The unit that was read last, if it has no power.
    last: Option<Last>,
}

/// Signs in the names of units that are spelt as commands.
const SIGNS: &[(&str, &str)] = &[("Omega", "Ω"), ("mu", "µ"), ("AA", "Å"), ("%", "%")];

impl<'a> Reader<'a> {
    fn step(&mut self) -> Result<bool, String> {
        self.rest = self
            .rest
            .trim_start_matches([' ', '\t', '\n', '\r', '~', '.', '·']);
        let Some(first) = self.rest.chars().next() else {
            return Ok(false);
        };
        match first {
            '/' => {
                self.rest = &self.rest[1..];
                if self.below || self.strokes > 0 {
                    return Err("a second stroke in a unit is not read".into());
                }
                (self.below, self.strokes) = (true, 1);
            }
            '(' if self.below && self.strokes == 1 => {
                self.rest = &self.rest[1..];
                (self.below, self.group) = (false, true);
            }
            ')' if self.group && self.after_stroke == 0 => {
                self.rest = &self.rest[1..];
                (self.group, self.after_stroke) = (false, 1);
                self.last = None;
            }
            '\\' if self.sign().is_none() => {
                let rest = &self.rest[1..];
                let length = rest.find(|c: char| !c.is_ascii_alphabetic());
                let name = &rest[..length.unwrap_or(rest.len())];
                self.rest = &rest[name.len()..];
                self.command(name)?;
            }
            _ => {
                let name = self.name();
                if name.is_empty() {
                    return Err(format!("`{first}` is not read in a unit"));
                }
                let product = (self.below || self.group).then(|| per_kelvin(&name));
                let unit = (product.flatten())
                    .or_else(|| by_symbol(&name.replace('μ', "µ")))
                    .ok_or_else(|| format!("the unit `{name}` is not known"))?;
                self.take(&unit)?;
            }
        }
        Ok(true)
    }

    /// The sign that a command here spells, and what stands after it.
    fn sign(&self) -> Option<(&'static str, &'a str)> {
        let rest = self.rest.strip_prefix('\\')?;
        SIGNS.iter().find_map(|(command, sign)| {
            let after = rest.strip_prefix(command)?;
            let ends = *command == "%" || !after.starts_with(|c: char| c.is_ascii_alphabetic());
            ends.then_some((*sign, after.trim_start()))
        })
    }

    /// The letters of a unit, signs among them: `km`, `k\Omega`, `\mu m`.
    fn name(&mut self) -> String {
        let mut name = String::new();
        loop {
            let letters = self.rest.find(|c: char| !c.is_alphabetic() && c != '%');
            let (own, rest) = self.rest.split_at(letters.unwrap_or(self.rest.len()));
            name.push_str(own);
            self.rest = rest;
            // `k\Omega` is one unit; what stands after an `\Omega` is another.
            let ended = name.ends_with(['Ω', '%']);
            match self.sign() {
                Some((sign, after)) if !ended => {
                    name.push_str(sign);
                    self.rest = after;
                    if sign == "Ω" {
                        return name;
                    }
                }
                _ => return name,
            }
        }
    }

    /// `\frac{J}{mol\,K}`
    fn fraction(&mut self) -> Result<(), String> {
        self.last = None;
        for power in [1, -1] {
            let (inner, after) = braced(self.rest.trim_start())
                .ok_or("a fraction in a unit needs two pairs of braces")?;
            self.rest = after;
            if power > 0 && inner.trim() == "1" {
                continue;
            }
            let taken = self.unit.times(&read(inner)?, power);
            taken.ok_or("this power of a unit is too large")?;
        }
        Ok(())
    }

    fn command(&mut self, name: &str) -> Result<(), String> {
        match name {
            "frac" | "tfrac" | "dfrac" if !self.below && self.raised == 1 && self.strokes == 0 => {
                self.fraction()?;
            }
            "" if self.rest.starts_with([',', ';', ' ']) => self.rest = &self.rest[1..],
            "cdot" => {}
            "per" => {
                if self.below || self.group {
                    return Err("a second stroke in a unit is not read".into());
                }
                self.below = true;
            }
            "square" => self.raised = 2,
            "cubic" => self.raised = 3,
            _ => {
                let (power, own) = match PREFIXES
                    .iter()
                    .find(|p| p.1 == name || name == "deka" && p.1 == "deca")
                {
                    None => (0, name),
                    Some((.., power)) => {
                        let rest = self.rest.trim_start();
                        let Some(rest) = rest.strip_prefix('\\') else {
                            return self.after_prefix(name, *power);
                        };
                        let length = rest.find(|c: char| !c.is_ascii_alphabetic());
                        let own = &rest[..length.unwrap_or(rest.len())];
                        self.rest = &rest[own.len()..];
                        (*power, own)
                    }
                };
                let spelt = match own {
                    "meter" => "metre",
                    other => other,
                };
                let row = UNITS.iter().find(|row| row.1 == spelt);
                let unit = match row {
                    Some(row) => row_unit(row, power),
                    None if power == 0 && spelt == "kilogram" => row_unit(&UNITS[1], 3),
                    None => abbreviated(spelt)
                        .filter(|_| power == 0)
                        .ok_or_else(|| format!("the unit `\\{own}` is not read"))?,
                };
                self.take(&unit)?;
            }
        }
        Ok(())
    }

    /// `\micro s`: letters after a prefix that is spelt as a command.
    fn after_prefix(&mut self, prefix: &str, power: i32) -> Result<(), String> {
        self.rest = self.rest.trim_start();
        let name = self.name();
        let row = UNITS.iter().find(|row| row.4 && row.0 == name);
        let row = row.ok_or_else(|| format!("a unit is missing after `\\{prefix}`"))?;
        self.take(&row_unit(row, power))
    }

    /// A unit, with the power that follows it.
    fn take(&mut self, unit: &Unit) -> Result<(), String> {
        let mut power = std::mem::replace(&mut self.raised, 1);
        let rest = self.rest.trim_start();
        let before = (power, rest.len());
        if let Some(after) = rest.strip_prefix("\\squared") {
            (power, self.rest) = (power * 2, after);
        } else if let Some(after) = rest.strip_prefix("\\cubed") {
            (power, self.rest) = (power * 3, after);
        } else if let Some(after) = rest.strip_prefix('^').or(rest.strip_prefix("\\tothe")) {
            let (digits, after) = match after.strip_prefix('{') {
                Some(inner) => inner
                    .split_once('}')
                    .ok_or("a brace in a unit is never closed")?,
                None => {
                    let sign = if after.starts_with('-') { 1 } else { 0 };
                    let digit = after[sign..].chars().next().map_or(0, char::len_utf8);
                    after.split_at(sign + digit)
                }
            };
            let exponent: i32 = digits
                .trim()
                .replace('−', "-")
                .parse()
                .ok()
                .filter(|exponent: &i32| exponent.unsigned_abs() <= MOST_POWER.unsigned_abs())
                .ok_or_else(|| format!("the power `{}` of a unit is not read", digits.trim()))?;
            (power, self.rest) = (power * exponent, after);
        } else if let Some((exponent, after)) = raised(rest) {
            (power, self.rest) = (power * exponent, after);
        }
        let is_bare = before == (1, self.rest.trim_start().len());
        let below = std::mem::take(&mut self.below) || self.group;
        if below {
            power = -power;
        }
        self.last = (is_bare && !self.group).then(|| Last {
            unit: unit.clone(),
            below,
        });
        if !self.group {
            self.after_stroke += self.strokes;
        }
        let taken = self.unit.times(unit, power);
        taken.ok_or_else(|| "this power of a unit is too large".to_owned())
    }
}

/// The figure that stands above the line here.
pub(super) fn raised_figure(sign: char) -> Option<usize> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|own| own == sign)
}

/// The power that a raised figure is, and what stands after them: `⁻²`.
fn raised(text: &str) -> Option<(i32, &str)> {
    let below = text.strip_prefix('⁻');
    let figures = below.unwrap_or(text);
    let first = figures.chars().next()?;
    let exponent = i32::try_from(raised_figure(first)?).ok()?;
    let after = &figures[first.len_utf8()..];
    let ends = !after.starts_with(|c| raised_figure(c).is_some());
    ends.then_some((if below.is_some() { -exponent } else { exponent }, after))
}

/// What stands between braces, and what after them.
fn braced(text: &str) -> Option<(&str, &str)> {
    let inner = text.strip_prefix('{')?;
    let mut depth = 1_usize;
    for (at, c) in inner.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some((&inner[..at], &inner[at + 1..]));
        }
    }
    None
}
