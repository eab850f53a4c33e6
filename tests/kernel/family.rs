//! Counterexamples for every number, and those that are none.

use cradle_verify::algebra::{BigRational, Symbol};
use cradle_verify::kernel::{
    Claim, Domain, FailsThroughout, Family, FamilyPart, Group, Proven, Reject, check_family,
};
use cradle_verify::search::{Effort, prove_unconditionally};
use cradle_verify::sorted::Map;

use super::claims::*;

fn natural() -> Domain {
    Domain {
        lower: Some((number(1), false)),
        integer: true,
        ..Domain::default()
    }
}

/// A sum that vanishes says nothing of the squares.
fn deviations() -> Claim {
    claim(&[r"\sum_{i=1}^k x_i = 0"], r"\sum_{i=1}^k x_i^2 = 0")
        .domain("k", natural())
        .sequence("x")
}

fn group(size: &str, elements: &[(&str, &str)]) -> Group {
    let elements = elements.iter();
    Group {
        size: term(size),
        elements: elements
            .map(|(s, value)| (symbol(s), term(value)))
            .collect(),
    }
}

/// `1 − k` once, and 1 as often as is left, for `k ≥ 2`.
fn family() -> Family {
    Family {
        parameter: symbol("k"),
        least: 2,
        symbols: Map::new(),
        count: symbol("k"),
        groups: vec![group("1", &[("x", "1 - k")]), group("k - 1", &[("x", "1")])],
    }
}

/// Every part that can be proved.
fn proofs(claim: &Claim, family: &Family) -> Result<Vec<Option<Proven>>, Reject> {
    let parts = family.parts(claim)?.into_iter();
    let proven = |part| Some(prove_unconditionally(part, Effort::Full)?.proven);
    Ok(parts.map(|(_, part)| proven(part)).collect())
}

/// What the kernel says where every part is proved, the first that is not, or why there are none.
fn checked(claim: &Claim, family: Family) -> Result<FailsThroughout, Reject> {
    let free = [("v", 1), ("n", 2)].map(|(name, value)| (symbol(name), number(value)));
    let named = claim.free_symbols();
    let free = free
        .into_iter()
        .filter(|(symbol, _)| named.contains(&symbol));
    checked_at(claim, family, &free.collect())
}

fn checked_at(
    claim: &Claim,
    family: Family,
    free: &Map<Symbol, BigRational>,
) -> Result<FailsThroughout, Reject> {
    let proofs = proofs(claim, &family)?;
    check_family(claim, family, proofs.into_iter().flatten().collect(), free)
}

/// What of a family cannot be proved.
fn unproved(claim: &Claim, family: &Family) -> Vec<FamilyPart> {
    let parts = family.parts(claim).unwrap().into_iter();
    let proofs = proofs(claim, family).unwrap();
    let unproved = parts.zip(proofs).filter(|(_, proof)| proof.is_none());
    unproved.map(|((part, _), _)| part).collect()
}

#[test]
fn a_family_is_accepted() {
    let fails = checked(&deviations(), family()).unwrap();
    assert_eq!(fails.family(), &family());
    assert_eq!(fails.claim(), &deviations());
    let first = fails.first().witness();
    assert_eq!(first.sequences[&symbol("x")], [number(-1), number(1)]);
    let parts: Vec<&FamilyPart> = fails.parts().iter().map(|part| &part.0).collect();
    use FamilyPart::{Count, Goal, Hypothesis, Size};
    assert_eq!(parts, [&Size(0), &Size(1), &Count, &Hypothesis(0), &Goal]);
}

#[test]
fn a_missing_proof_is_noticed() {
    let all = proofs(&deviations(), &family()).unwrap();
    let all: Vec<Proven> = all.into_iter().flatten().collect();
    let check = |proofs| check_family(&deviations(), family(), proofs, &Map::new());
    assert!(check(all.clone()).is_ok());
    for without in 0..all.len() {
        let mut fewer = all.clone();
        fewer.remove(without);
        assert_eq!(check(fewer).err(), Some(Reject::WrongKind));
    }
    let doubled = all.iter().chain(all.last()).cloned().collect();
    assert_eq!(check(doubled).err(), Some(Reject::WrongKind));
}

#[test]
fn a_proof_of_something_else_is_no_proof() {
    let all = proofs(&deviations(), &family()).unwrap();
    let mut all: Vec<Proven> = all.into_iter().flatten().collect();
    all.swap(0, 1);
    let verdict = check_family(&deviations(), family(), all, &Map::new());
    assert_eq!(verdict.err(), Some(Reject::WrongKind));
    // What is true from 3 on says nothing of 2.
    let later = Family {
        least: 3,
        ..family()
    };
    let all = proofs(&deviations(), &later).unwrap().into_iter();
    let verdict = check_family(
        &deviations(),
        family(),
        all.flatten().collect(),
        &Map::new(),
    );
    assert_eq!(verdict.err(), Some(Reject::WrongKind));
}

#[test]
fn what_is_false_for_one_member_cannot_be_proved() {
    let early = Family {
        least: 1,
        ..family()
    };
    assert_eq!(unproved(&deviations(), &early), [FamilyPart::Goal]);
    let mut other = family();
    other.groups[0] = group("1", &[("x", "2 - k")]);
    assert_eq!(unproved(&deviations(), &other), [FamilyPart::Hypothesis(0)]);
    let mut fewer = family();
    fewer.groups[1].size = term("k - 2");
    fewer.groups[0] = group("1", &[("x", "2 - k")]);
    let parts = unproved(&deviations(), &fewer);
    assert_eq!(parts, [FamilyPart::Count, FamilyPart::Goal]);
    let mut negative = family();
    negative.groups = vec![
        group("k + 1", &[("x", "1")]),
        group("0 - 1", &[("x", "k + 1")]),
    ];
    assert!(unproved(&deviations(), &negative).contains(&FamilyPart::Size(1)));
}

#[test]
fn domains_are_kept() {
    let mut claim = deviations();
    claim.sequences.insert(symbol("x"), positive());
    let parts = unproved(&claim, &family());
    assert_eq!(parts, [FamilyPart::Elements(symbol("x"), 0)]);
    let claim = deviations().domain("v", positive());
    let with = |value: &str| Family {
        symbols: Map::from([(symbol("v"), term(value))]),
        ..family()
    };
    assert!(unproved(&claim, &with("k")).is_empty());
    let parts = unproved(&claim, &with("2 - k"));
    assert_eq!(parts, [FamilyPart::Domain(symbol("v"))]);
}

#[test]
fn the_parameter_stays_in_its_domain() {
    let few = Domain {
        upper: Some((number(9), false)),
        ..natural()
    };
    let claim = deviations().domain("k", few);
    assert_eq!(checked(&claim, family()).err(), Some(Reject::OutsideDomain));
    let many = Domain {
        lower: Some((number(3), false)),
        ..natural()
    };
    let claim = deviations().domain("k", many);
    assert_eq!(checked(&claim, family()).err(), Some(Reject::OutsideDomain));
    let later = Family {
        least: 3,
        ..family()
    };
    assert!(checked(&claim, later).is_ok());
    let itself = Family {
        symbols: Map::from([(symbol("k"), term("7"))]),
        ..family()
    };
    assert_eq!(
        checked(&deviations(), itself).err(),
        Some(Reject::OutsideDomain)
    );
}

#[test]
fn whole_numbers_are_whole() {
    let whole = Domain {
        integer: true,
        ..Domain::default()
    };
    let mut claim = deviations();
    claim.sequences.insert(symbol("x"), whole.clone());
    assert!(checked(&claim, family()).is_ok());
    let mut halves = family();
    halves.groups[0] = group("1", &[("x", r"\frac{1 - k}{2}")]);
    halves.groups[1] = group("k - 1", &[("x", r"\frac{1}{2}")]);
    assert_eq!(
        checked(&claim, halves.clone()).err(),
        Some(Reject::OutsideDomain)
    );
    assert!(checked(&deviations(), halves).is_ok());
    let mut sizes = family();
    sizes.groups[1].size = term(r"\frac{2 k - 2}{2}");
    assert_eq!(
        checked(&deviations(), sizes).err(),
        Some(Reject::OutsideDomain)
    );
    let claim = deviations().domain("n", whole);
    let with = |value: &str| Family {
        symbols: Map::from([(symbol("n"), term(value))]),
        ..family()
    };
    assert!(checked(&claim, with("3 k - 1")).is_ok());
    assert_eq!(
        checked(&claim, with("v")).err(),
        Some(Reject::OutsideDomain)
    );
}

#[test]
fn what_is_free_has_any_value_of_its_domain_and_has_one() {
    let scaled = |domain| {
        claim(
            &[r"\sum_{i=1}^k x_i = 0"],
            r"\sum_{i=1}^k x_i^2 = v^2 - v^2",
        )
        .domain("k", natural())
        .domain("v", domain)
        .sequence("x")
    };
    let mut family = family();
    family.groups[0] = group("1", &[("x", "(1 - k) v")]);
    family.groups[1] = group("k - 1", &[("x", "v")]);
    let claim = scaled(positive());
    assert!(checked(&claim, family.clone()).is_ok());
    let at = |value| Map::from([(symbol("v"), number(value))]);
    let verdict = checked_at(&claim, family.clone(), &at(0));
    assert_eq!(verdict.err(), Some(Reject::OutsideDomain));
    let verdict = checked_at(&claim, family.clone(), &Map::new());
    assert_eq!(verdict.err(), Some(Reject::NoValue));
    let anything = scaled(Domain::default());
    assert_eq!(unproved(&anything, &family), [FamilyPart::Goal]);
    // Nothing is positive and negative: whatever is proved of such a number is proved of none.
    let nothing = scaled(Domain {
        upper: Some((number(0), true)),
        ..positive()
    });
    let verdict = checked_at(&nothing, family, &at(1));
    assert_eq!(verdict.err(), Some(Reject::OutsideDomain));
}

#[test]
fn terms_are_in_what_is_free() {
    let with = |value: &str| Family {
        symbols: Map::from([(symbol("a"), term("k")), (symbol("b"), term(value))]),
        ..family()
    };
    assert!(checked(&deviations(), with("k + 1")).is_ok());
    for value in ["a + 1", "b", "x_1", r"\pi", r"\sin(k)", r"\frac{d k}{d k}"] {
        let verdict = checked(&deviations(), with(value));
        assert_eq!(verdict.err(), Some(Reject::NoFamily), "{value}");
    }
}

#[test]
fn what_cannot_be_said_of_groups_is_rejected() {
    for hypothesis in [
        r"\sum_{i=1}^k i x_i = 0",
        r"\sum_{i=2}^k x_i = 0",
        r"\sum_{i=1}^n x_i = 0",
        r"\sum_{i=1}^{k+1} x_i = 0",
        "x_1 = 1 - k",
        r"\pi > 3",
        r"\frac{d v}{d t} = 0",
        r"\sin(v) = 0",
    ] {
        let mut claim = deviations();
        let more = super::claims::claim(&[hypothesis], "1 = 0").hypotheses;
        claim.hypotheses.extend(more);
        let verdict = checked(&claim, family());
        assert_eq!(verdict.err(), Some(Reject::NoFamily), "{hypothesis}");
    }
    let claim = claim(&[], r"x_1 = x_2 = \dots = x_n").domain("k", natural());
    assert_eq!(
        checked(&claim, family()).err(),
        Some(Reject::UnsupportedRelation)
    );
}

#[test]
fn a_sequence_that_is_left_out_has_no_elements() {
    let claim = claim(&[r"\sum_{i=1}^k x_i = 0"], r"\sum_{i=1}^k y_i = 0").domain("k", natural());
    assert_eq!(checked(&claim, family()).err(), Some(Reject::OutsideDomain));
}

#[test]
fn elements_of_several_sequences_go_together() {
    let claim = claim(
        &[r"\sum_{i=1}^k x_i = 0", r"\sum_{i=1}^k y_i = 0"],
        r"\sum_{i=1}^k x_i y_i = 0",
    )
    .domain("k", natural());
    let both = |first, second| {
        let mut family = family();
        family.groups[0] = group("1", &[("x", "1 - k"), ("y", first)]);
        family.groups[1] = group("k - 1", &[("x", "1"), ("y", second)]);
        family
    };
    assert!(checked(&claim, both("k - 1", "0 - 1")).is_ok());
    assert_eq!(unproved(&claim, &both("0", "0")), [FamilyPart::Goal]);
}

#[test]
fn sums_in_sums_are_written_out_each_for_itself() {
    let inner = r"\sum_{i=1}^k \left(x_i - \frac{1}{k} \sum_{j=1}^k x_j\right)^2 = 0";
    let claim = claim(&[r"\sum_{i=1}^k x_i = 0"], inner).domain("k", natural());
    assert!(checked(&claim, family()).is_ok());
    let mut alike = family();
    alike.groups = vec![group("k", &[("x", "0")])];
    assert_eq!(unproved(&claim, &alike), [FamilyPart::Goal]);
}

#[test]
fn that_all_are_equal_is_said_of_pairs() {
    let all = |goal| claim(&[], goal).domain("k", natural());
    let equal = all(r"x_1 = x_2 = \dots = x_k");
    assert!(checked(&equal, family()).is_ok());
    let mut alike = family();
    alike.groups[0] = group("1", &[("x", "1")]);
    assert_eq!(unproved(&equal, &alike), [FamilyPart::Goal]);
    // A group without elements makes no difference.
    let mut empty = alike.clone();
    empty.groups.insert(0, group("0", &[("x", "5")]));
    assert_eq!(unproved(&equal, &empty), [FamilyPart::Goal]);
    let one = all(r"x_1 = x_2 = \dots = x_k = 1");
    assert!(checked(&one, family()).is_ok());
    assert_eq!(unproved(&one, &alike), [FamilyPart::Goal]);
    let two = all(r"x_1 = x_2 = \dots = x_k = 2");
    assert!(checked(&two, alike).is_ok());
}

#[test]
fn a_member_with_very_many_elements_is_not_written_out() {
    let later = Family {
        least: 65,
        ..family()
    };
    assert_eq!(checked(&deviations(), later).err(), Some(Reject::TooLarge));
    let last = Family {
        least: 64,
        ..family()
    };
    assert!(checked(&deviations(), last).is_ok());
}

#[test]
fn every_relation_is_denied() {
    for (relation, denied) in [
        ("=", true),
        (r"\neq", false),
        ("<", true),
        (r"\leq", true),
        (">", false),
        (r"\geq", false),
    ] {
        let goal = format!(r"\sum_{{i=1}}^k x_i^2 {relation} 0");
        let claim = claim(&[r"\sum_{i=1}^k x_i = 0"], &goal).domain("k", natural());
        assert_eq!(checked(&claim, family()).is_ok(), denied, "{relation}");
    }
    let goal = r"\sum_{i=1}^k x_i^2 \approx 0";
    let claim = claim(&[r"\sum_{i=1}^k x_i = 0"], goal).domain("k", natural());
    assert_eq!(
        checked(&claim, family()).err(),
        Some(Reject::UnsupportedRelation)
    );
}
