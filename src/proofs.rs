//! The report that ships inside the program: what the bare command audits. What is true instead of its errors is in
//! [`corrected`].

use crate::derivation::{Checker, Derivation};
use crate::document::Document;

/// The pages of a folder, and a handle on each: its file's name, and a line on what it is about.
macro_rules! pages {
    ($folder:literal; $($handle:ident: $name:literal, $about:literal;)*) => {
        /// The pages in reading order: the path of each, and its text.
        pub const PAGES: &[(&str, &str)] = &[$((
            concat!($folder, "/", $name, ".md"),
            include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/", $folder, "/", $name, ".md")),
        )),*];

        /// A handle on each page.
        pub mod pages {
            use crate::derivation::Checker;

            $(
                #[doc = concat!("Page ", $name, ": ", $about, ".")]
                pub fn $handle() -> Checker {
                    super::page_checker($name).expect("the page is one of those above")
                }
            )*
        }
    };
}

pub mod corrected;

pages! {
    "proofs/report";
    conservation_laws: "1.2-conservation-laws", "momentum and kinetic energy of five equal balls";
    scenarios: "1.3-scenarios", "four outcomes put to both laws";
    n_balls_in_n_balls_out: "1.4-n-balls-in-n-balls-out", "what two conservation laws say about how many balls leave";
    restitution: "2.1-restitution", "the energy that one imperfect click costs";
    hertz_contact: "2.2-hertz-contact", "how two spheres press on each other";
    heat: "2.3-heat", "friction inside the contact";
    sound: "2.4-sound", "the click itself";
    energy_balance: "2.5-energy-balance", "where the energy of one collision goes";
    unequal_masses: "3.1-unequal-masses", "two unequal balls";
    mass_ratio: "3.5-mass-ratio", "both velocities by the ratio of the masses alone";
    efficiency: "3.6-efficiency", "how much of the energy gets across";
    maximum: "3.7-maximum", "the best target";
    energy_decay: "4.2-energy-decay", "how the clicking dies away";
}

/// The whole report, read as one derivation.
pub fn report() -> Derivation {
    derivation(PAGES)
}

fn derivation(pages: &[(&str, &str)]) -> Derivation {
    Derivation::read(pages, |&(path, source)| {
        (Document::markdown(path, source), None)
    })
}

/// One page's text, by its path.
pub fn page(path: &str) -> Option<&'static str> {
    PAGES
        .iter()
        .find(|(own, _)| *own == path)
        .map(|&(_, source)| source)
}

/// A handle on one page of the report, by the name of its file, with or without `.md` and the folder.
///
/// The page is read together with all others, which its equations may cite.
///
/// ```
/// use cradle_verify::derivation::Point;
/// use cradle_verify::proofs::page_checker;
///
/// let page = page_checker("3.1-unequal-masses").unwrap();
/// // A ball strikes one of twice its mass.
/// let at = Point::new().with("m_1", 1).with("m_2", 2).with("v_0", 3).with("v'_2", 2);
/// let sides = &page.sides_at("54", &at).unwrap()[0];
/// assert_eq!(sides.right.to_string(), "2");
/// assert!(sides.holds);
/// assert!(page_checker("9.9-nothing").is_none());
/// ```
pub fn page_checker(name: &str) -> Option<Checker> {
    position(PAGES, name).map(|page| Checker::of_page(report(), page))
}

/// Where the page of a name stands, with or without `.md` and the folder.
fn position(pages: &[(&str, &str)], name: &str) -> Option<usize> {
    let name = name.strip_suffix(".md").unwrap_or(name);
    let named = |path: &str| {
        let path = path.strip_suffix(".md").unwrap_or(path);
        path == name || path.rsplit('/').next() == Some(name)
    };
    pages.iter().position(|(path, _)| named(path))
}

/// A handle on the whole report.
pub fn checker() -> Checker {
    Checker::new(report())
}
