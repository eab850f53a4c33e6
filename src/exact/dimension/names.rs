//! The names of dimensions: what may be written in a declaration, and what a finding says.

use crate::algebra::{Base, Dimension};

/// Exponents of mass, length, time, current, temperature, amount and luminosity.
type Exponents = [i8; 7];

/// Each dimension: the name a finding uses, all names that a declaration may use, the exponents. Where a dimension
/// has two rows, a finding gives both names.
#[rustfmt::skip]
const TABLE: &[(&str, &[&str], Exponents)] = &[
    ("pure number", &["dimensionless", "number", "pure number", "count", "angle", "plane angle", "solid angle",
        "ratio", "strain", "fraction", "probability", "efficiency", "1"], [0, 0, 0, 0, 0, 0, 0]),
    ("Mass", &["mass"], [1, 0, 0, 0, 0, 0, 0]),
    ("Length", &["length", "distance", "displacement", "position", "height", "width", "depth", "radius", "diameter",
        "wavelength", "amplitude", "focal length", "thickness"], [0, 1, 0, 0, 0, 0, 0]),
    ("Time", &["time", "duration", "period"], [0, 0, 1, 0, 0, 0, 0]),
    ("Current", &["current", "electric current"], [0, 0, 0, 1, 0, 0, 0]),
    ("Temperature", &["temperature"], [0, 0, 0, 0, 1, 0, 0]),
    ("Amount", &["amount", "amount of substance"], [0, 0, 0, 0, 0, 1, 0]),
    ("Luminous intensity", &["luminosity", "luminous intensity"], [0, 0, 0, 0, 0, 0, 1]),
    ("Area", &["area", "cross section"], [0, 2, 0, 0, 0, 0, 0]),
    ("Volume", &["volume"], [0, 3, 0, 0, 0, 0, 0]),
    ("Wavenumber", &["wavenumber", "wave number", "curvature"], [0, -1, 0, 0, 0, 0, 0]),
    ("Frequency", &["frequency", "rate", "angular velocity", "angular frequency", "angular speed", "decay rate"],
        [0, 0, -1, 0, 0, 0, 0]),
    ("Angular acceleration", &["angular acceleration"], [0, 0, -2, 0, 0, 0, 0]),
    ("Velocity", &["velocity", "speed", "speed of light", "speed of sound"], [0, 1, -1, 0, 0, 0, 0]),
    ("Acceleration", &["acceleration"], [0, 1, -2, 0, 0, 0, 0]),
    ("Jerk", &["jerk"], [0, 1, -3, 0, 0, 0, 0]),
    ("Density", &["density", "mass density"], [1, -3, 0, 0, 0, 0, 0]),
    ("Surface density", &["surface density", "area density"], [1, -2, 0, 0, 0, 0, 0]),
    ("Line density", &["line density", "linear density"], [1, -1, 0, 0, 0, 0, 0]),
    ("Mass flow", &["mass flow", "mass flow rate"], [1, 0, -1, 0, 0, 0, 0]),
    ("Volume flow", &["volume flow", "volume flow rate", "flow rate"], [0, 3, -1, 0, 0, 0, 0]),
    ("Momentum", &["momentum", "impulse"], [1, 1, -1, 0, 0, 0, 0]),
    ("Force", &["force", "weight"], [1, 1, -2, 0, 0, 0, 0]),
    ("Energy", &["energy", "work", "heat", "kinetic energy", "potential energy", "enthalpy", "free energy"],
        [1, 2, -2, 0, 0, 0, 0]),
    ("Torque", &["torque", "moment", "moment of force"], [1, 2, -2, 0, 0, 0, 0]),
    ("Power", &["power"], [1, 2, -3, 0, 0, 0, 0]),
    ("Intensity", &["intensity", "irradiance", "energy flux"], [1, 0, -3, 0, 0, 0, 0]),
    ("Pressure", &["pressure", "stress", "modulus", "elastic modulus", "shear modulus", "bulk modulus",
        "energy density"], [1, -1, -2, 0, 0, 0, 0]),
    ("Angular momentum", &["angular momentum"], [1, 2, -1, 0, 0, 0, 0]),
    ("Action", &["action"], [1, 2, -1, 0, 0, 0, 0]),
    ("Moment of inertia", &["moment of inertia"], [1, 2, 0, 0, 0, 0, 0]),
    ("Stiffness", &["stiffness", "spring constant"], [1, 0, -2, 0, 0, 0, 0]),
    ("Surface tension", &["surface tension"], [1, 0, -2, 0, 0, 0, 0]),
    ("Viscosity", &["viscosity", "dynamic viscosity"], [1, -1, -1, 0, 0, 0, 0]),
    ("Diffusivity", &["diffusivity", "kinematic viscosity", "diffusion constant", "thermal diffusivity"],
        [0, 2, -1, 0, 0, 0, 0]),
    ("Gravitational constant", &["gravitational constant"], [-1, 3, -2, 0, 0, 0, 0]),
    ("Specific energy", &["specific energy", "gravitational potential"], [0, 2, -2, 0, 0, 0, 0]),
    ("Heat capacity", &["heat capacity"], [1, 2, -2, 0, -1, 0, 0]),
    ("Entropy", &["entropy", "boltzmann constant"], [1, 2, -2, 0, -1, 0, 0]),
    ("Specific heat capacity", &["specific heat", "specific heat capacity"], [0, 2, -2, 0, -1, 0, 0]),
    ("Molar heat capacity", &["molar heat capacity", "gas constant", "molar entropy"], [1, 2, -2, 0, -1, -1, 0]),
    ("Molar mass", &["molar mass"], [1, 0, 0, 0, 0, -1, 0]),
    ("Concentration", &["concentration"], [0, -3, 0, 0, 0, 1, 0]),
    ("Number density", &["number density"], [0, -3, 0, 0, 0, 0, 0]),
    ("Thermal conductivity", &["thermal conductivity"], [1, 1, -3, 0, -1, 0, 0]),
    ("Charge", &["charge", "electric charge"], [0, 0, 1, 1, 0, 0, 0]),
    ("Charge density", &["charge density"], [0, -3, 1, 1, 0, 0, 0]),
    ("Surface charge density", &["surface charge density"], [0, -2, 1, 1, 0, 0, 0]),
    ("Current density", &["current density"], [0, -2, 0, 1, 0, 0, 0]),
    ("Voltage", &["voltage", "electric potential", "emf"], [1, 2, -3, -1, 0, 0, 0]),
    ("Electric field", &["electric field"], [1, 1, -3, -1, 0, 0, 0]),
    ("Magnetic field", &["magnetic field", "magnetic flux density"], [1, 0, -2, -1, 0, 0, 0]),
    ("Magnetic flux", &["magnetic flux"], [1, 2, -2, -1, 0, 0, 0]),
    ("Resistance", &["resistance", "impedance", "reactance"], [1, 2, -3, -2, 0, 0, 0]),
    ("Resistivity", &["resistivity"], [1, 3, -3, -2, 0, 0, 0]),
    ("Conductance", &["conductance"], [-1, -2, 3, 2, 0, 0, 0]),
    ("Conductivity", &["conductivity"], [-1, -3, 3, 2, 0, 0, 0]),
    ("Capacitance", &["capacitance"], [-1, -2, 4, 2, 0, 0, 0]),
    ("Inductance", &["inductance"], [1, 2, -2, -2, 0, 0, 0]),
    ("Permittivity", &["permittivity"], [-1, -3, 4, 2, 0, 0, 0]),
    ("Permeability", &["permeability"], [1, 1, -2, -2, 0, 0, 0]),
];

fn dimension(exponents: Exponents) -> Dimension {
    let pairs = Base::ALL.into_iter().zip(exponents.map(i32::from));
    Dimension::of(&pairs.collect::<Vec<_>>())
}

/// The dimension of this name, in lower case.
pub fn named(name: &str) -> Option<Dimension> {
    let row = TABLE.iter().find(|(_, names, _)| names.contains(&name))?;
    Some(dimension(row.2))
}

/// The names of a dimension, as findings give them: `Energy`, `Torque`.
pub fn names_of(wanted: &Dimension) -> Vec<&'static str> {
    // The exponents are compared with the rows: making a dimension of each row would take far longer.
    let exponent = |base: Base| {
        let mut all = wanted.exponents(base);
        match (all.next(), all.next()) {
            (None, _) => Some(0),
            (Some((None, own)), None) if own.is_integer() => i8::try_from(own.numer()).ok(),
            _ => None,
        }
    };
    let Some(own) = Base::ALL
        .map(exponent)
        .into_iter()
        .collect::<Option<Vec<i8>>>()
    else {
        return Vec::new();
    };
    let rows = TABLE.iter().filter(|row| row.2[..] == own[..]);
    rows.map(|row| row.0).collect()
}

/// The name of a dimension in a declaration: that of the first quantity that has it.
pub fn declared_name(wanted: &Dimension) -> Option<String> {
    match *names_of(wanted).first()? {
        "pure number" => Some("dimensionless".into()),
        name => Some(name.to_lowercase()),
    }
}

/// Every name that a declaration may use.
pub fn names() -> impl Iterator<Item = &'static str> {
    TABLE.iter().flat_map(|row| row.1.iter().copied())
}

/// The name of a base.
pub fn base_name(base: Base) -> &'static str {
    match base {
        Base::Mass => "Mass",
        Base::Length => "Length",
        Base::Time => "Time",
        Base::Current => "Current",
        Base::Temperature => "Temperature",
        Base::Amount => "Amount",
        Base::Luminosity => "Luminosity",
    }
}

/// The letter of a base, as declarations spell it.
pub fn base_letter(base: Base) -> &'static str {
    match base {
        Base::Mass => "M",
        Base::Length => "L",
        Base::Time => "T",
        Base::Current => "I",
        Base::Temperature => "\\Theta",
        Base::Amount => "N",
        Base::Luminosity => "J",
    }
}
