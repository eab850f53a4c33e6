//! What is true instead of the report's errors: every step holds, and rests on nothing that fails.
//!
//! The pages stand by themselves. Each says which of the report's equations it stands in the place of.

use crate::derivation::{Checker, Derivation};

pages! {
    "proofs/corrected";
    n_in_n_out_by_exchange: "1.4-n-in-n-out-by-exchange", "equal balls exchange velocities, so as many leave as arrive";
    n_in_n_out_by_speed: "1.4-n-in-n-out-by-speed", "the same from momentum and energy, if no ball turns back or outruns the others";
    other_outcomes: "1.4-other-outcomes", "what momentum and energy leave open without that, for every number of balls";
    restitution: "2.1-restitution", "the loss in one click, for a sphere at rest and in the frame of the centre of mass";
    contact: "2.2-contact", "effective modulus and radius of identical spheres";
    heat_and_sound: "2.3-heat-and-sound", "the exponents of heat and sound";
    maximum: "3.7-maximum", "no target is better than a twin, whatever the masses";
    energy_decay: "4.2-energy-decay", "what is left after n clicks";
}

/// All corrected pages, read as one derivation.
pub fn corrected() -> Derivation {
    super::derivation(PAGES)
}

/// A handle on one corrected page, by the name of its file, with or without `.md` and the folder.
///
/// ```
/// use cradle_verify::derivation::Point;
/// use cradle_verify::proofs::corrected;
///
/// // Two of three balls come in and two leave: this is what is left of the three velocities, in units of theirs.
/// let page = corrected::page_checker("1.4-n-in-n-out-by-speed").unwrap();
/// let shares = ["0", "1", "1"].map(|share| share.parse().unwrap());
/// let at = Point::new().with("N", 3).with("n", 2).with_list("x", shares);
/// assert!(page.sides_at("P5", &at).unwrap()[0].holds);
/// ```
pub fn page_checker(name: &str) -> Option<Checker> {
    super::position(PAGES, name).map(|page| Checker::of_page(corrected(), page))
}

/// A handle on all corrected pages.
pub fn checker() -> Checker {
    Checker::new(corrected())
}
