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

#[test]
fn one_symbol_does_not_lie_in_two_places() {
    let clashes = |first: &str, second: &str| {
        let page = format!(
            "<!-- check: symbols k: {first} -->\n\n# A\n\n<!-- check: symbols k: {second} -->\n"
        );
        Derivation::from_markdown("page.md", &page).pages[0]
            .clashes
            .len()
    };
    assert_eq!(clashes("natural", "positive"), 1);
    assert_eq!(clashes("mass, in [0, 1]", "positive"), 1);
    assert_eq!(clashes("integer", ">= 1"), 1);
    // The same again, or something else about it.
    for (first, second) in [
        ("positive", "positive, constant"),
        ("mass", "positive"),
        ("positive", "mass"),
        ("real", "positive"),
        ("positive", "constant"),
        ("constant", "positive"),
    ] {
        assert_eq!(clashes(first, second), 0, "{first}; {second}");
    }
}

#[test]
fn of_two_places_the_first_counts() {
    let page = "# A\n\n<!-- check: symbols k: positive -->\n\n$$ n = k + 1 \\tag{1} $$\n\n# B\n\n<!-- check: symbols k: natural -->\n";
    let page = Derivation::from_markdown("page.md", page).pages.remove(0);
    let domain = page.domains.iter().next().unwrap().1;
    assert!(!domain.integer);
}
