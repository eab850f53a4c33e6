//! Dimensions: how they are declared, how those that are not declared are inferred, and that a change of units changes
//! nothing about a well-dimensioned equation. The last is checked by evaluating both sides, which shares no code with
//! the inference.

use cradle_verify::algebra::{
    Base, BigInt, BigRational, Dimension, Formula, Rational, Symbol, Values,
};
use cradle_verify::audit::{Audit, Verdict};
use cradle_verify::derivation::{Derivation, formulas};
use cradle_verify::dimension::{names, parse};
use cradle_verify::kernel::dimension::{Form, comparisons};
use cradle_verify::sorted::Map;
use proptest::prelude::*;

fn dimension(exponents: &[(Base, i32)]) -> Dimension {
    Dimension::of(exponents)
}

#[test]
fn every_name_is_read() {
    for name in names() {
        assert!(parse(name).is_ok(), "{name}");
    }
}

#[test]
fn names_and_exponents_say_the_same() {
    for (name, exponents) in [
        ("force", "M L T^{-2}"),
        ("energy", "M L^2 T^-2"),
        ("energy", "L²MT⁻²"),
        ("work", "force length"),
        ("power", "energy / time"),
        ("pressure", "force/area"),
        ("entropy", "energy/temperature"),
        ("entropy", r"M L^{2} T^{-2} \Theta^{-1}"),
        ("voltage", "M L^2/(T^3 I)"),
        ("resistance", "voltage/current"),
        ("capacitance", "charge/voltage"),
        ("inductance", "voltage time / current"),
        ("viscosity", "pressure·time"),
        ("moment of inertia", "mass length^2"),
        ("Angular Velocity", "1/time"),
        ("angular-velocity", "T^{-1}"),
        ("gas constant", "energy/(amount temperature)"),
        ("luminosity", "J"),
        ("dimensionless", "M/M"),
        ("temperature", "K"),
        ("temperature", "Θ"),
        ("velocity", r"L \cdot T^{-1}"),
        ("length", "(L^2)^{1/2}"),
        ("frequency", "(M L)^0 T^{−1}"),
    ] {
        assert_eq!(parse(name), parse(exponents), "{name} = {exponents}");
        assert!(parse(name).is_ok(), "{name}");
    }
}

#[test]
fn exponents_are_rational() {
    let read = parse("M L^{-1/2} T^{-2}").unwrap();
    assert_eq!(read.exponent(Base::Length), Some(Rational::ratio(-1, 2)));
    assert_eq!(
        parse("(M/L)^(1/2)").unwrap(),
        parse("M^{1/2} L^{-1/2}").unwrap()
    );
    assert_eq!(
        parse("stiffness^{3/2}").unwrap(),
        parse("M^{3/2} T^{-3}").unwrap()
    );
    assert_eq!(parse("M L^{0}").unwrap(), dimension(&[(Base::Mass, 1)]));
}

#[test]
fn what_is_no_dimension_is_named_at_its_place() {
    for (text, at, word) in [
        ("mas", 0..3, Some("mas")),
        ("M velcity", 2..9, Some("velcity")),
        ("mass of water", 5..13, Some("of water")),
        ("M/L T", 4..5, None),
        ("M/L/", 4..4, None),
        ("M^x", 1..2, None),
        ("M^{1/0}", 1..7, None),
        ("M^{2", 1..4, None),
        ("(M L", 0..4, None),
        ("M )", 2..3, None),
        ("", 0..0, None),
        ("M^{99999999}", 1..12, None),
        ("L + T", 2..3, None),
    ] {
        let error = parse(text).expect_err(text);
        assert_eq!((error.at, error.word.as_deref()), (at, word), "{text}");
    }
    // However deep, it is refused rather than followed.
    assert!(parse(&"(".repeat(100_000)).is_err());
}

fn audit(source: &str) -> (Derivation, Audit) {
    let derivation = Derivation::from_markdown("page.md", source);
    assert!(
        derivation.pages[0].problems.is_empty(),
        "{:?}",
        derivation.pages[0].problems
    );
    let audit = Audit::of(&derivation);
    (derivation, audit)
}

fn page(declared: &[(&str, String)], equations: &[&str]) -> String {
    let mut source = String::from("<!-- check:\n");
    for (name, dimension) in declared {
        source += &format!("symbols {name}: {dimension}\n");
    }
    source += "-->\n";
    for equation in equations {
        source += &format!("\n<!-- check: given -->\n$$ {equation} $$\n");
    }
    source
}

/// The positions of the ill-dimensioned equations.
fn guilty(declared: &[(&str, &str)], equations: &[&str]) -> Vec<usize> {
    let declared: Vec<(&str, String)> = declared
        .iter()
        .map(|(n, d)| (*n, (*d).to_owned()))
        .collect();
    let (_, audit) = audit(&page(&declared, equations));
    let entries = audit.entries.iter();
    let guilty = entries.filter(|e| e.verdict == Verdict::IllDimensioned);
    guilty.map(|e| e.equation).collect()
}

#[test]
fn an_equation_that_is_wrong_by_itself_poisons_nothing() {
    let declared = [("m", "mass"), ("v", "velocity"), ("x", "length")];
    let equations = ["x q + m = v", "q = m v", "q v = m v^2", "q = x"];
    assert_eq!(guilty(&declared, &equations), [0, 3]);
}

#[test]
fn equations_in_any_order_are_solved() {
    let declared = [("l", "length")];
    let chain = ["a = b", "b = c^2", "c = l"];
    let with = |last: &'static str| guilty(&declared, &[&chain[..], &[last]].concat());
    assert!(with("a = l^2").is_empty());
    assert_eq!(with("a = l"), [3]);
}

#[test]
fn what_an_equation_taught_before_it_disagreed_is_forgotten_and_nothing_else() {
    let declared = [("m", "mass"), ("v", "velocity"), ("x", "length")];
    // The second would have b to be x / a.
    let equations = ["a = m", "b a + x = v", "b = m v", "a = v"];
    assert_eq!(guilty(&declared, &equations), [1, 3]);
}

#[test]
fn what_disagrees_is_traced_to_its_sources_with_their_multipliers() {
    let equations = ["a = b", "f l^5 = 1", "b = c^2", "c = l", "a^3 l = 1"];
    let (_, audit) = audit(&page(&[("l", "length".to_owned())], &equations));
    let conflict = &audit.dimensions.conflicts[&(4, 0)];
    let parts = conflict.evidence.parts();
    assert_eq!(parts.len(), 4, "all but the second");
    let mut total = Form::default();
    for part in parts {
        let own = &comparisons(&part.formula, &part.scope)[part.comparison];
        total.multiply(&own.quotient(), &part.multiplier);
    }
    assert_eq!(total.dimension(), Some(&dimension(&[(Base::Length, 7)])));
}

#[test]
fn the_fewest_equations_that_disagree_are_named() {
    let declared = [("m", "mass"), ("v", "velocity")];
    let equations = ["a = m", "b = a v", "c = b v", "d = v", "e = b d", "b = 2 m"];
    let declared: Vec<(&str, String)> = declared
        .iter()
        .map(|(n, d)| (*n, (*d).to_owned()))
        .collect();
    let (_, audit) = audit(&page(&declared, &equations));
    let conflict = &audit.dimensions.conflicts[&(5, 0)];
    let parts = conflict.evidence.parts();
    assert_eq!(parts.len(), 3, "a, b and the last");
    assert_eq!(conflict.origins.len(), 3);
}

#[test]
fn pages_share_what_they_cite_and_nothing_else() {
    let read = |pages: &[&str]| {
        let documents = pages.iter().enumerate().map(|(at, source)| {
            cradle_verify::document::Document::markdown(format!("{at}.md"), *source)
        });
        let derivation = Derivation::new(documents.collect());
        let audit = Audit::of(&derivation);
        audit
            .entries
            .iter()
            .map(|e| e.verdict == Verdict::IllDimensioned)
            .collect::<Vec<_>>()
    };
    let first =
        "<!-- check: symbols m: mass; symbols v: velocity; given -->\n$$ p = m v \\tag{1} $$\n";
    let apart = "<!-- check: symbols V: volume; given -->\n$$ p = V \\tag{2} $$\n";
    assert_eq!(read(&[first, apart]), [false, false]);
    let citing = "<!-- check: symbols V: volume; given; from (1) -->\n$$ p = V \\tag{2} $$\n";
    assert_eq!(read(&[first, citing]), [false, true]);
    let borrowing = "<!-- check: given; from (1) -->\n$$ q = m + v \\tag{2} $$\n";
    assert_eq!(read(&[first, borrowing]), [false, true]);
}

#[test]
fn a_unit_that_the_author_picks_is_none_of_our_business() {
    let source = "<!-- check: symbols v, w: velocity -->\n## A\n<!-- check: let v = 1 -->\n<!-- check: given -->\n$$ w = 2 $$\n## B\n<!-- check: given -->\n$$ w = 2 $$\n";
    let (_, audit) = audit(source);
    assert_eq!(audit.entries[0].verdict, Verdict::Given);
    assert_eq!(audit.entries[1].verdict, Verdict::IllDimensioned);
}

#[test]
fn what_is_supposed_is_checked() {
    let source = "<!-- check: symbols v: velocity; symbols m: mass; assuming v > m -->\n<!-- check: given -->\n$$ v = 0 $$\n";
    let (_, audit) = audit(source);
    assert_eq!(audit.dimensions.suppositions.len(), 1);
}

#[test]
fn a_tick_behind_what_is_ill_dimensioned_is_wrong() {
    let source = "<!-- check: symbols v: velocity; symbols m: mass -->\n<!-- check: from nothing -->\n$$ v = m \\quad \\checkmark $$\n<!-- check: from nothing -->\n$$ v = m \\quad \\times $$\n";
    let (_, audit) = audit(source);
    assert!(audit.entries[0].is_finding());
    assert!(
        audit.entries[0]
            .notes
            .iter()
            .any(|n| n.code() == "wrong-mark")
    );
    assert!(!audit.entries[1].is_finding());
}

/// Four quantities with random dimensions in the first three bases, and exponents for each of two products.
fn products() -> impl Strategy<Value = (Vec<[i32; 3]>, Vec<i32>, Vec<i32>)> {
    let exponents = || prop::collection::vec(-3..=3, 4);
    (
        prop::collection::vec([-2..=2, -2..=2, -2..=2], 4),
        exponents(),
        exponents(),
    )
}

const NAMES: [&str; 7] = ["a", "b", "c", "f", "m", "x", "t"];

/// `a^{2} b^{-1}`, times what makes up for a dimension in mass, length and time.
fn product(exponents: &[i32], lacking: [i32; 3]) -> String {
    let all = exponents.iter().chain(&lacking);
    let factors = NAMES
        .iter()
        .zip(all)
        .map(|(name, exponent)| format!("{name}^{{{exponent}}}"));
    factors.collect::<Vec<_>>().join(" ")
}

fn total(dimensions: &[[i32; 3]], exponents: &[i32]) -> [i32; 3] {
    let mut total = [0; 3];
    for (dimension, exponent) in dimensions.iter().zip(exponents) {
        (0..3).for_each(|at| total[at] += dimension[at] * exponent);
    }
    total
}

/// The declarations after a change of bases: new mass, length and time are products of the old ones.
fn declared(dimensions: &[[i32; 3]], change: &[[i32; 3]; 3]) -> Vec<(&'static str, String)> {
    let bases = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    let all = dimensions.iter().chain(&bases);
    let text = |d: &[i32; 3]| {
        let exponent = |new: usize| (0..3).map(|old| d[old] * change[old][new]).sum::<i32>();
        format!(
            "M^{{{}}} L^{{{}}} T^{{{}/2}}",
            exponent(0),
            exponent(1),
            exponent(2)
        )
    };
    NAMES
        .iter()
        .zip(all)
        .map(|(name, d)| (*name, text(d)))
        .collect()
}

fn value(
    formula: &Formula,
    factor: i64,
    dimensions: &[(Symbol, [i32; 3])],
    base: usize,
) -> [BigRational; 2] {
    let symbols: Map<Symbol, BigRational> = (2..)
        .zip(dimensions)
        .map(|(own, (symbol, dimension))| {
            let scale = BigRational::from_integer(BigInt::from(factor)).pow(dimension[base]);
            (
                symbol.clone(),
                scale * BigRational::from_integer(BigInt::from(own)),
            )
        })
        .collect();
    let values = Values {
        symbols,
        ..Values::default()
    };
    let sides = values.sides(formula).expect("a value").remove(0);
    [sides.left, sides.right]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn well_dimensioned_equations_stay_so_whatever_the_bases(
        (dimensions, left, right) in products(),
        change in [[-2..=2, -2..=2, -2..=2], [-2..=2, -2..=2, -2..=2], [-2..=2, -2..=2, -2..=2]],
        wrong in 0..3_usize,
    ) {
        let [a, b] = [total(&dimensions, &left), total(&dimensions, &right)];
        let makes_up = [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
        let sides = [product(&left, [0; 3]), product(&right, makes_up)];
        let right_one = format!("{0} = 3 {1} - \\frac12 {0}", sides[0], sides[1]);
        let mut off = makes_up;
        off[wrong] += 1;
        let wrong_one = format!("{} = 3 {}", sides[0], product(&right, off));
        let unchanged = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

        let (derivation, audited) = audit(&page(&declared(&dimensions, &unchanged), &[&right_one, &wrong_one]));
        prop_assert_eq!(audited.entries[0].verdict, Verdict::Given);
        prop_assert_eq!(audited.entries[1].verdict, Verdict::IllDimensioned);
        let (_, changed) = audit(&page(&declared(&dimensions, &change), &[&right_one]));
        prop_assert_eq!(changed.entries[0].verdict, Verdict::Given);

        // In numbers: both sides of the right equation grow alike in any unit, those of the wrong one do not.
        let bases = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
        let named: Vec<(Symbol, [i32; 3])> =
            NAMES.iter().map(|n| Symbol::new(*n)).zip(dimensions.iter().chain(&bases).copied()).collect();
        for base in 0..3 {
            for (at, alike) in [(0, true), (1, base != wrong)] {
                let formula = formulas(&derivation.equations[at].statements()[0]).remove(0);
                let (one, other) = (value(&formula, 1, &named, base), value(&formula, 2, &named, base));
                prop_assert_eq!(&one[0] * &other[1] == &one[1] * &other[0], alike);
            }
        }
    }

    #[test]
    fn what_is_inferred_in_any_order_is_the_same(order in Just(vec![0, 1, 2, 3]).prop_shuffle()) {
        let all = ["p = m v", "K = p v", "F = p / t", "F x = K"];
        let equations: Vec<&str> = order.iter().map(|at| all[*at]).collect();
        let declared = [("m", "mass"), ("v", "velocity"), ("t", "time"), ("x", "length")];
        prop_assert!(guilty(&declared, &equations).is_empty());
        let broken: Vec<String> = equations.iter().map(|e| e.replace("F x", "F x^2")).collect();
        let broken: Vec<&str> = broken.iter().map(String::as_str).collect();
        // K, F and p disagree whatever p is; whichever of the three comes last is told.
        let last = equations.iter().rposition(|e| *e != all[0]).unwrap();
        prop_assert_eq!(guilty(&declared, &broken), [last]);
    }
}
