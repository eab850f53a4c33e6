//! Derivations: which names can be told apart.

use cradle_verify::derivation::Derivation;

fn read(page: &str) -> Vec<bool> {
    let derivation = Derivation::from_markdown("page.md", page);
    let read = derivation.equations.iter().map(|e| e.statements.is_ok());
    read.collect()
}

#[test]
fn differentials_are_refused() {
    assert_eq!(read(r"$$ dU = T\,dS - p\,dV $$"), [false]);
    assert_eq!(read(r"$$ \mathrm{d}U = T \mathrm{d}S $$"), [false]);
    // Derivatives and integrals are understood.
    assert_eq!(read(r"$$ \frac{dU}{dT} = \int_0^T c\, dT $$"), [true]);
}

#[test]
fn distance_is_no_differential() {
    assert_eq!(read("$$ d = v t $$\n$$ d a = d b $$"), [true, true]);
    let declared = "<!-- check: symbols d: length -->\n$$ d a = d b $$";
    assert_eq!(read(declared), [true]);
    assert_eq!(read("$$ F = q d E $$"), [true]);
    // In the middle of a chain it stands once.
    assert_eq!(read("$$ W = q d E = F $$"), [true]);
}
