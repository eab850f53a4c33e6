use std::fmt;

use num_traits::{One, Signed};

use crate::algebra::{BigInt, BigRational};

/// A material by the name that a figure gives it, with its coefficient of restitution.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Material {
    name: String,
    restitution: BigRational,
}

/// Why there is no such material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MaterialError {
    /// The name is empty.
    Nameless,
    /// The name has more than [`Material::LONGEST_NAME`] characters; how many.
    LongName(usize),
    /// The name has a character that is not seen.
    Unseen(char),
    /// The coefficient is below 0 or above 1.
    OutOfRange(BigRational),
    /// The coefficient has too many digits to be raised to powers.
    TooLong,
    /// Two materials have one name.
    Twice(String),
    /// There are more than [`Material::MOST`]; how many.
    TooMany(usize),
}

impl fmt::Display for MaterialError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MaterialError::Nameless => write!(f, "the material has no name"),
            MaterialError::LongName(length) => write!(
                f,
                "a name of {length} characters is too long: at most {} are drawn",
                Material::LONGEST_NAME
            ),
            MaterialError::Unseen(character) => write!(
                f,
                "the name has a character that is not seen, U+{:04X}",
                u32::from(*character)
            ),
            MaterialError::OutOfRange(value) => {
                write!(
                    f,
                    "a coefficient of restitution is from 0 to 1, and not {value}"
                )
            }
            MaterialError::TooLong => write!(
                f,
                "the coefficient has too many digits: write at most {} behind the point, or in its fraction",
                Material::MOST_DIGITS
            ),
            MaterialError::Twice(name) => write!(f, "there are two materials `{name}`"),
            MaterialError::TooMany(count) => write!(
                f,
                "{count} materials are too many: at most {} are told apart",
                Material::MOST
            ),
        }
    }
}

impl std::error::Error for MaterialError {}

impl Material {
    /// The longest name, in characters.
    pub const LONGEST_NAME: usize = 24;
    /// As many as have a marker of their own.
    pub const MOST: usize = 8;
    /// The digits behind the point, or those of numerator and denominator.
    pub const MOST_DIGITS: usize = 30;

    /// A material.
    ///
    /// # Errors
    /// The name is empty, too long or has unseen characters; the coefficient is not from 0 to 1 or too long.
    pub fn new(name: &str, restitution: BigRational) -> Result<Self, MaterialError> {
        let name = name.trim();
        let length = name.chars().count();
        if length == 0 {
            return Err(MaterialError::Nameless);
        }
        if length > Material::LONGEST_NAME {
            return Err(MaterialError::LongName(length));
        }
        if let Some(character) = name.chars().find(|&c| is_unseen(c)) {
            return Err(MaterialError::Unseen(character));
        }
        if restitution.is_negative() || restitution > BigRational::one() {
            return Err(MaterialError::OutOfRange(restitution));
        }
        // So many digits behind the point are a fraction of this denominator.
        if *restitution.denom() > num_traits::pow(BigInt::from(10), Material::MOST_DIGITS) {
            return Err(MaterialError::TooLong);
        }
        Ok(Material {
            name: name.to_owned(),
            restitution,
        })
    }

    /// The materials of the report's listing, which names no source for them.
    pub fn of_the_report() -> Vec<Material> {
        let hundredths = |(name, hundredths): (&str, i64)| Material {
            name: name.to_owned(),
            restitution: BigRational::new(BigInt::from(hundredths), BigInt::from(100)),
        };
        [("steel", 98), ("glass", 95), ("brass", 90), ("rubber", 70)]
            .map(hundredths)
            .to_vec()
    }

    /// That materials can be told apart.
    ///
    /// # Errors
    /// There are too many, or two have one name.
    pub fn distinct(materials: &[Material]) -> Result<(), MaterialError> {
        if materials.len() > Material::MOST {
            return Err(MaterialError::TooMany(materials.len()));
        }
        for (at, material) in materials.iter().enumerate() {
            if materials[..at].iter().any(|own| own.name == material.name) {
                return Err(MaterialError::Twice(material.name.clone()));
            }
        }
        Ok(())
    }

    /// The name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The coefficient of restitution, from 0 to 1.
    pub fn restitution(&self) -> &BigRational {
        &self.restitution
    }
}

/// Control characters, and those that turn the direction of writing or have no width.
fn is_unseen(character: char) -> bool {
    character.is_control()
        || matches!(character,
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffc}' | '\u{fffe}' | '\u{ffff}'
            | '\u{e0000}'..='\u{e0fff}')
}
