//! Integrals by antiderivatives: what is right is proved, what is wrong is not, and nothing is integrated across a pole.

use cradle_verify::kernel::{Claim, Reject};
use cradle_verify::search::{Effort, prove_unconditionally};

use super::claims::*;

/// Symbols that are constant, and positive where a root or a logarithm is taken.
fn declared(goal: &str) -> Claim {
    let mut claim = claim(&[], goal);
    for name in ["a", "b", "k", "c", "w"] {
        let domain = cradle_verify::kernel::Domain {
            constant: true,
            ..positive()
        };
        claim = claim.domain(name, domain);
    }
    claim
}

fn checked(goal: &str) -> Result<(), Reject> {
    let p = Proving::new(declared(goal));
    p.checked(p.combination(&[], 1, &[]))
}

/// The first of each pair is proved, and the second is not.
fn told_apart(pairs: &[(&str, &str)]) {
    for (right, wrong) in pairs {
        assert_eq!(checked(right), Ok(()), "{right}");
        assert_eq!(checked(wrong), Err(Reject::IdentityFails), "{wrong}");
    }
}

fn refused(goals: &[&str]) {
    for none in goals {
        assert!(checked(none).is_err(), "{none}");
    }
}

/// Terms in x.
const TERMS: &[&str] = &[
    "x^3",
    r"k \cdot x^2 - c \cdot x",
    r"\frac{k}{x}",
    r"\frac{k}{x^2} + c \cdot x",
    r"\frac{1}{c + k \cdot x}",
    r"\frac{1}{(c + k \cdot x)^2}",
    r"\ln x",
    r"k \ln(c + k \cdot x)",
    r"\exp(-k \cdot x)",
    r"\exp(c \cdot x) \exp(k \cdot x)",
    r"c \sin(k \cdot x)",
    r"\cos(k \cdot x + c)",
    r"x - \sin(k \cdot x) \cos(k \cdot x)",
];

fn at(term: &str, limit: &str) -> String {
    let letters = term.replace(r"\exp", "@");
    format!(
        "({})",
        letters
            .replace('x', &format!("({limit})"))
            .replace('@', r"\exp")
    )
}

#[test]
fn slope_is_integrated_to_what_it_is_the_slope_of() {
    for term in TERMS {
        let slope = format!(r"\int_a^b \frac{{d}}{{dx}}\left[{term}\right] \, dx");
        let (end, start) = (at(term, "b"), at(term, "a"));
        assert_eq!(
            checked(&format!("{slope} = {end} - {start}")),
            Ok(()),
            "{term}"
        );
        for wrong in [
            format!("{slope} = {end} + {start}"),
            format!("{slope} = 2 {end} - {start}"),
            format!("{slope} = {start} - {end}"),
            format!("{slope} = {end} - {}", at(term, "2 a")),
        ] {
            assert_eq!(checked(&wrong), Err(Reject::IdentityFails), "{wrong}");
        }
    }
}

#[test]
fn what_has_no_known_antiderivative_is_left_as_it_stands() {
    for integrand in [
        r"x \sin(k x)",
        r"\exp(-k x^2)",
        r"\frac{\sin x}{x}",
        r"\frac{x}{c + k x}",
        r"\frac{1}{c + x^2}",
        r"\ln x",
    ] {
        let zero = format!(r"\int_a^b {integrand} \, dx = 0");
        assert_eq!(checked(&zero), Err(Reject::IdentityFails), "{integrand}");
        let itself = format!(r"\int_a^b {integrand} \, dx = \int_a^b {integrand} \, dx");
        assert_eq!(checked(&itself), Ok(()), "{integrand}");
    }
}

#[test]
fn what_may_move_is_not_taken_out() {
    for (integrand, as_if) in [
        (r"\frac{p}{x^2}", r"\frac{p}{a} - \frac{p}{b}"),
        (r"p \exp(p x)", r"\exp(p b) - \exp(p a)"),
        (r"p^2 x", r"\frac{p^2}{2} (b^2 - a^2)"),
    ] {
        let goal = format!(r"\int_a^b {integrand} \, dx = {as_if}");
        assert_eq!(checked(&goal), Err(Reject::IdentityFails), "{goal}");
    }
}

#[test]
fn what_a_premise_says_throughout_does_not_move_is_taken_out() {
    let goal = r"\int_a^b \frac{p}{x^2} \, dx = \frac{p}{a} - \frac{p}{b}";
    let with = |premise: &str| Claim {
        hypotheses: claim(&[premise], goal).hypotheses,
        ..declared(goal)
    };
    let checked = |claim: Claim| {
        let p = Proving::new(claim);
        p.checked(p.combination(&[], 1, &[]))
    };
    let stands_still = r"\frac{dp}{dx} = 0";
    assert_eq!(checked(with(stands_still)), Ok(()));
    // At one point a slope may be 0 of what moves everywhere else.
    assert_eq!(
        checked(with(stands_still).at_point(0)),
        Err(Reject::IdentityFails)
    );
    for other in [
        r"\frac{dp}{dt} = 0",
        r"\frac{dq}{dx} = 0",
        r"\frac{dp}{dx} = 1",
        r"\frac{dp}{dx} = q",
    ] {
        assert_eq!(checked(with(other)), Err(Reject::IdentityFails), "{other}");
    }
    // Where nothing is integrated it is a fact like others, which a certificate has to name.
    let slope = claim(&[stands_still], r"\frac{d}{dx}\left[p^2\right] = 0");
    assert_eq!(checked(slope), Err(Reject::IdentityFails));
}

#[test]
fn improper_integrals_and_limits_of_exponentials() {
    told_apart(&[
        (
            r"\int_a^\infty \frac{k}{x^2} \, dx = \frac{k}{a}",
            r"\int_a^\infty \frac{k}{x^2} \, dx = \frac{k}{a^2}",
        ),
        (
            r"\int_0^\infty \exp(-k x) \, dx = \frac{1}{k}",
            r"\int_0^\infty \exp(-k x) \, dx = k",
        ),
        (
            r"\lim_{x \to \infty} (c - \exp(-k x)) = c",
            r"\lim_{x \to \infty} (c - \exp(-k x)) = 0",
        ),
        (
            r"\lim_{x \to \infty} x^3 \exp(-k x) = 0",
            r"\lim_{x \to \infty} x^3 \exp(-k x) = 1",
        ),
        (
            r"\lim_{x \to \infty} \frac{c \exp(k x) + x}{\exp(k x) - x} = c",
            r"\lim_{x \to \infty} \frac{c \exp(k x) + x}{\exp(k x) - x} = 1",
        ),
    ]);
    // What grows, or may grow, has no limit there.
    refused(&[
        r"\lim_{x \to \infty} \exp(k x) = 0",
        r"\lim_{x \to -\infty} \exp(-k x) = 0",
        r"\int_a^\infty \frac{k}{x} \, dx = 0",
        r"\int_a^\infty k \, dx = 0",
        r"\int_{-\infty}^b \exp(-k x) \, dx = 0",
    ]);
    let unsigned = claim(&[], r"\lim_{x \to \infty} \exp(-q x) = 0").domain("q", constant());
    let p = Proving::new(unsigned);
    let refused = p.checked(p.combination(&[], 1, &[]));
    assert!(
        matches!(refused, Err(Reject::MayBeNegative(_))),
        "{refused:?}"
    );
}

#[test]
fn limits_where_nothing_jumps() {
    told_apart(&[
        (
            r"\lim_{x \to 0} (a \cos(w x) + b \sin(w x)) = a",
            r"\lim_{x \to 0} (a \cos(w x) + b \sin(w x)) = b",
        ),
        (
            r"\lim_{x \to 0} \frac{d}{dx}\left[b \sin(w x)\right] = w b",
            r"\lim_{x \to 0} \frac{d}{dx}\left[b \sin(w x)\right] = b",
        ),
        (
            r"\lim_{x \to k} c \exp(-x) = c \exp(-k)",
            r"\lim_{x \to k} c \exp(-x) = c \exp(k)",
        ),
        (
            r"\lim_{x \to 4} \frac{c \sqrt{x}}{x + 1} = \frac{2 c}{5}",
            r"\lim_{x \to 4} \frac{c \sqrt{x}}{x + 1} = \frac{c}{5}",
        ),
    ]);
    refused(&[
        r"\lim_{x \to 0} \frac{\sin x}{x} = 0",
        r"\lim_{x \to 0} \frac{\cos x}{x} = 0",
        r"\lim_{x \to 0} \ln x = 0",
        r"\lim_{x \to -1} \sqrt{x} \cos x = 0",
        r"\lim_{x \to 0} q \cos x = q",
    ]);
}

#[test]
fn law_of_logarithms_is_one_of_exponentials() {
    let laws = [r"\ln N - \ln M = -k t"];
    let bare = claim(&laws, r"N = M \exp(-k t)")
        .domain("N", positive())
        .domain("M", positive());
    let p = Proving::new(bare);
    let facts = p.problem.facts.iter().zip(&p.problem.origins);
    let of_the_law = facts.filter(|(fact, origin)| {
        fact.sign == cradle_verify::kernel::Sign::Zero
            && matches!(origin, cradle_verify::kernel::Origin::Hypothesis(0))
    });
    assert_eq!(of_the_law.count(), 2);
    // A factor that may be 0 is not divided by.
    let laws = [r"v = u \ln M - u \ln m"];
    for (domain, count) in [(constant(), 1), (positive(), 2)] {
        let bare = claim(&laws, r"M = m \exp(v/u)").domain("m", positive());
        let p = Proving::new(bare.domain("M", positive()).domain("u", domain));
        let facts = p.problem.facts.iter().zip(&p.problem.origins);
        let of_the_law = facts.filter(|(fact, origin)| {
            fact.sign == cradle_verify::kernel::Sign::Zero
                && matches!(origin, cradle_verify::kernel::Origin::Hypothesis(0))
        });
        assert_eq!(of_the_law.count(), count);
    }
}

#[test]
fn evidence_about_fewer_situations_must_be_about_the_same_claim() {
    use cradle_verify::kernel::{Candidate, Checked, Obligation};
    let goal = r"\int_a^b \frac{q}{x^2} \, dx = q";
    let bare = claim(&[], goal)
        .domain("a", positive())
        .domain("b", positive());
    let own = Obligation::new(bare.clone(), Vec::new()).expect("a claim");
    let still = bare.clone().domain("q", constant());
    let posed = Obligation::new(still.clone(), Vec::new()).expect("a claim");
    let point = point(&[("a", 1), ("b", 2), ("q", 1)]);
    let found = posed
        .check(Candidate::Counterexample(point))
        .expect("evidence");
    let Checked::Refuted(found) = found else {
        panic!("a counterexample refutes");
    };
    assert_eq!(own.refuted_by_fewer(&found), Ok(()));
    for other in [
        claim(&[], goal).domain("a", positive()),
        claim(&["q = 1"], goal)
            .domain("a", positive())
            .domain("b", positive()),
        claim(&[], r"\int_a^b \frac{q}{x^2} \, dx = 2 q")
            .domain("a", positive())
            .domain("b", positive()),
        bare.domain("q", positive()),
    ] {
        let other = Obligation::new(other, Vec::new()).expect("a claim");
        assert_eq!(other.refuted_by_fewer(&found), Err(Reject::OfAnotherClaim));
    }
}

/// Where π is declared constant it may be any number; where it is not, it is the one that it is.
#[test]
fn a_counterexample_with_another_pi_is_none() {
    use cradle_verify::kernel::{Candidate, Checked, Obligation};
    let bare = claim(&[r"q = v \pi"], "q = 2 v");
    let still = bare.clone().domain(r"\pi", constant());
    let posed = Obligation::new(still.clone(), Vec::new()).expect("a claim");
    let mut given = point(&[("q", 1), ("v", 1)]);
    given.symbols.insert(symbol(r"\pi"), number(1));
    let found = match posed.check(Candidate::Counterexample(given)) {
        Ok(Checked::Refuted(found)) => found,
        other => panic!("{other:?}"),
    };
    let own = Obligation::new(bare, Vec::new()).expect("a claim");
    assert_eq!(own.refuted_by_fewer(&found), Err(Reject::OfAnotherClaim));
    let same = Obligation::new(still, Vec::new()).expect("a claim");
    assert_eq!(same.refuted_by_fewer(&found), Ok(()));
}

#[test]
fn elements_that_are_constant_say_nothing_of_a_symbol_of_their_name() {
    let checked = |goal: &str| {
        let mut own = claim(&[], goal);
        own.sequences.insert(symbol("x"), constant());
        let p = Proving::new(own);
        p.checked(p.combination(&[], 1, &[]))
    };
    let slope = |of: &str| format!(r"\frac{{d}}{{dt}}\left[{of}\right] = 0");
    let elements = r"\sum_{i=1}^{n} x_i^2";
    assert_eq!(checked(&slope(elements)), Ok(()));
    assert_eq!(checked(&slope("x")), Err(Reject::IdentityFails));
    let both = format!("{elements} + x");
    assert!(checked(&slope(&both)).is_err());
}

#[test]
fn quotients_are_taken_apart_into_partial_fractions() {
    told_apart(&[
        (
            r"\int_0^b \frac{x}{a + x} \, dx = b - a \ln\frac{a + b}{a}",
            r"\int_0^b \frac{x}{a + x} \, dx = b + a \ln\frac{a + b}{a}",
        ),
        (
            r"\int_0^b \frac{c x}{a + k x} \, dx = \frac{c b}{k} - \frac{c a}{k^2} \ln\frac{a + k b}{a}",
            r"\int_0^b \frac{c x}{a + k x} \, dx = \frac{c b}{k} - \frac{c a}{k} \ln\frac{a + k b}{a}",
        ),
        (
            r"\int_0^b \frac{x^2}{(a + x)^2} \, dx = a + b - \frac{a^2}{a + b} - 2 a \ln\frac{a + b}{a}",
            r"\int_0^b \frac{x^2}{(a + x)^2} \, dx = a + b - \frac{a^2}{a + b} - a \ln\frac{a + b}{a}",
        ),
        (
            r"\int_0^b \frac{1}{(x + k) (x + 2 k)} \, dx = \frac{1}{k} (\ln\frac{b + k}{k} - \ln\frac{b + 2 k}{2 k})",
            r"\int_0^b \frac{1}{(x + k) (x + 2 k)} \, dx = \frac{1}{k} (\ln\frac{b + k}{k} + \ln\frac{b + 2 k}{2 k})",
        ),
        (
            r"\int_a^b \frac{1}{x (x + k)} \, dx = \frac{1}{k} (\ln\frac{b}{a} - \ln\frac{b + k}{a + k})",
            r"\int_a^b \frac{1}{x (x + k)} \, dx = \ln\frac{b}{a} - \ln\frac{b + k}{a + k}",
        ),
        (
            r"\int_a^b \frac{1}{x^2 (x + k)} \, dx = \frac{1}{k} (\frac{1}{a} - \frac{1}{b}) - \frac{1}{k^2} (\ln\frac{b}{a} - \ln\frac{b + k}{a + k})",
            r"\int_a^b \frac{1}{x^2 (x + k)} \, dx = \frac{1}{k} (\frac{1}{a} - \frac{1}{b}) + \frac{1}{k^2} (\ln\frac{b}{a} - \ln\frac{b + k}{a + k})",
        ),
    ]);
    // Across a pole, where two factors may be one, and of too many.
    refused(&[
        r"\int_0^b \frac{x}{a - x} \, dx = -b - a \ln\frac{a - b}{a}",
        r"\int_{-b}^b \frac{x}{a + x} \, dx = 2 b - a \ln\frac{a + b}{a - b}",
        r"\int_a^b \frac{1}{(x + k) (x + c)} \, dx = \frac{1}{c - k} (\ln\frac{b + k}{a + k} - \ln\frac{b + c}{a + c})",
        r"\int_{-a}^b \frac{1}{x (x + k)} \, dx = 0",
        r"\int_0^b \frac{x^9}{a + x} \, dx = 0",
    ]);
}

#[test]
fn limits_at_minus_infinity_are_those_of_the_opposite() {
    told_apart(&[
        (
            r"\lim_{x \to -\infty} \exp(k x) = 0",
            r"\lim_{x \to -\infty} \exp(k x) = 1",
        ),
        (
            r"\lim_{x \to -\infty} \frac{c x + 1}{x - k} = c",
            r"\lim_{x \to -\infty} \frac{c x + 1}{x - k} = -c",
        ),
        (
            r"\lim_{x \to -\infty} x \exp(k x) = 0",
            r"\lim_{x \to -\infty} x \exp(k x) = 1",
        ),
        (
            r"\int_{-\infty}^0 c \exp(2 k x) \, dx = \frac{c}{2 k}",
            r"\int_{-\infty}^0 c \exp(2 k x) \, dx = \frac{c}{k}",
        ),
    ]);
    refused(&[
        r"\lim_{x \to -\infty} \exp(-k x) = 0",
        r"\lim_{x \to -\infty} x = 0",
        r"\int_{-\infty}^0 \exp(-k x) \, dx = 0",
    ]);
}

#[test]
fn powers_times_exponentials_of_powers() {
    told_apart(&[
        (
            r"\int_0^b x \exp(-k x^2) \, dx = \frac{1 - \exp(-k b^2)}{2 k}",
            r"\int_0^b x \exp(-k x^2) \, dx = \frac{1 - \exp(-k b^2)}{k}",
        ),
        (
            r"\int_0^b x^3 \exp(-x^2) \, dx = \frac{1}{2} - \frac{(b^2 + 1) \exp(-b^2)}{2}",
            r"\int_0^b x^3 \exp(-x^2) \, dx = \frac{1}{2} - \frac{b^2 \exp(-b^2)}{2}",
        ),
        (
            r"\int_0^b x^2 \exp(\frac{x^3}{a}) \, dx = \frac{a}{3} (\exp(\frac{b^3}{a}) - 1)",
            r"\int_0^b x^2 \exp(\frac{x^3}{a}) \, dx = \frac{1}{3} (\exp(\frac{b^3}{a}) - 1)",
        ),
    ]);
    refused(&[
        r"\int_0^b \exp(-x^2) \, dx = 0",
        r"\int_0^b x^2 \exp(-x^2) \, dx = 0",
        r"\int_0^b x \exp(-x^2 - x) \, dx = 0",
    ]);
}

#[test]
fn areas_beside_a_pole_at_nought() {
    told_apart(&[
        (
            r"\int_0^b \frac{1}{\sqrt{x}} \, dx = 2 \sqrt{b}",
            r"\int_0^b \frac{1}{\sqrt{x}} \, dx = \sqrt{b}",
        ),
        (
            r"\int_b^0 \frac{k}{\sqrt{x}} \, dx = -2 k \sqrt{b}",
            r"\int_b^0 \frac{k}{\sqrt{x}} \, dx = 2 k \sqrt{b}",
        ),
        (
            r"\int_0^b \frac{c + x^2}{\sqrt{x}} \, dx = 2 c \sqrt{b} + \frac{2 b^{5/2}}{5}",
            r"\int_0^b \frac{c + x^2}{\sqrt{x}} \, dx = 2 c \sqrt{b} + \frac{b^{5/2}}{5}",
        ),
        (
            r"\int_0^8 \frac{1}{\sqrt[3]{x}} \, dx = 6",
            r"\int_0^8 \frac{1}{\sqrt[3]{x}} \, dx = 4",
        ),
    ]);
    // Where it grows too fast, where more than the variable moves, and below 0.
    refused(&[
        r"\int_0^1 \frac{1}{x \sqrt{x}} \, dx = -2",
        r"\int_0^1 \frac{1}{x} \, dx = 0",
        r"\int_0^1 \frac{1 + x^2}{x \sqrt{x}} \, dx = -\frac{4}{3}",
        r"\int_0^b \frac{1}{x + x^2} \, dx = \ln\frac{b}{b + 1}",
        r"\int_{-b}^0 \frac{1}{\sqrt{x}} \, dx = -2 \sqrt{b}",
        r"\int_{-8}^0 \frac{1}{x^2} \, dx = -\frac{1}{8}",
        r"\int_{-1}^1 \frac{1}{x^2} \, dx = -2",
    ]);
}

/// Whether a goal is proved, with what roots are.
fn follows(goal: &str) -> bool {
    prove_unconditionally(declared(goal), Effort::Full).is_some()
}

#[test]
fn odd_powers_beside_a_square_are_integrated() {
    for (right, wrong) in [
        (
            r"\int_0^a \frac{x}{\sqrt{x^2 + b^2}} \, dx = \sqrt{a^2 + b^2} - b",
            r"\int_0^a \frac{x}{\sqrt{x^2 + b^2}} \, dx = \sqrt{a^2 + b^2} + b",
        ),
        (
            r"\int_0^a \frac{c x}{(b^2 + x^2)^{3/2}} \, dx = c \left(\frac{1}{b} - \frac{1}{\sqrt{a^2 + b^2}}\right)",
            r"\int_0^a \frac{c x}{(b^2 + x^2)^{3/2}} \, dx = c \left(\frac{1}{\sqrt{a^2 + b^2}} - \frac{1}{b}\right)",
        ),
        (
            r"\int_0^a \frac{x^3}{\sqrt{b^2 + k x^2}} \, dx = \frac{(b^2 + k a^2)^{3/2} - b^3}{3 k^2} - \frac{b^2}{k^2} (\sqrt{b^2 + k a^2} - b)",
            r"\int_0^a \frac{x^3}{\sqrt{b^2 + k x^2}} \, dx = \frac{(b^2 + k a^2)^{3/2} - b^3}{3 k^2} + \frac{b^2}{k^2} (\sqrt{b^2 + k a^2} - b)",
        ),
        (
            r"\int_0^a \frac{x^5}{\sqrt{b^2 + x^2}} \, dx = \frac{(a^2 + b^2)^{5/2} - b^5}{5} - \frac{2 b^2}{3} ((a^2 + b^2)^{3/2} - b^3) + b^4 (\sqrt{a^2 + b^2} - b)",
            r"\int_0^a \frac{x^5}{\sqrt{b^2 + x^2}} \, dx = \frac{(a^2 + b^2)^{5/2} - b^5}{5} - \frac{b^2}{3} ((a^2 + b^2)^{3/2} - b^3) + b^4 (\sqrt{a^2 + b^2} - b)",
        ),
        (
            r"\int_0^a \frac{x}{c \sqrt{x^2 + b^2}} \, dx = \frac{\sqrt{a^2 + b^2} - b}{c}",
            r"\int_0^a \frac{x}{c \sqrt{x^2 + b^2}} \, dx = \sqrt{a^2 + b^2} - b",
        ),
        (
            r"\int_0^a x \sqrt{b^2 + x^2} \, dx = \frac{(b^2 + a^2)^{3/2} - b^3}{3}",
            r"\int_0^a x \sqrt{b^2 + x^2} \, dx = \frac{(b^2 + a^2)^{3/2} - b^3}{2}",
        ),
        (
            r"\int_0^a \frac{x}{b^2 + x^2} \, dx = \frac{1}{2} \ln \frac{a^2 + b^2}{b^2}",
            r"\int_0^a \frac{x}{b^2 + x^2} \, dx = \ln \frac{a^2 + b^2}{b^2}",
        ),
        (
            r"\int_0^a \frac{x}{(b^2 + x^2)^2} \, dx = \frac{1}{2 b^2} - \frac{1}{2 (a^2 + b^2)}",
            r"\int_0^a \frac{x}{(b^2 + x^2)^2} \, dx = \frac{1}{b^2} - \frac{1}{a^2 + b^2}",
        ),
    ] {
        assert!(follows(right), "{right}");
        assert!(!follows(wrong), "{wrong}");
    }
}

/// What stands under the root may be a fraction, and it may vanish at a limit where nothing is divided by it.
#[test]
fn a_root_may_vanish_at_a_limit() {
    for (right, wrong) in [
        (
            r"\int_0^a x \sqrt{a^2 - x^2} \, dx = \frac{a^3}{3}",
            r"\int_0^a x \sqrt{a^2 - x^2} \, dx = \frac{a^3}{2}",
        ),
        (
            r"\int_0^a x \sqrt{1 - \frac{x^2}{a^2}} \, dx = \frac{a^2}{3}",
            r"\int_0^a x \sqrt{1 - \frac{x^2}{a^2}} \, dx = \frac{a^3}{3}",
        ),
        (
            r"\int_0^a x^3 \sqrt{1 - \frac{x^2}{a^2}} \, dx = \frac{2 a^4}{15}",
            r"\int_0^a x^3 \sqrt{1 - \frac{x^2}{a^2}} \, dx = \frac{4 a^4}{15}",
        ),
        (
            r"\int_0^a \frac{x}{\sqrt{1 + \frac{x^2}{b^2}}} \, dx = b^2 \left(\sqrt{1 + \frac{a^2}{b^2}} - 1\right)",
            r"\int_0^a \frac{x}{\sqrt{1 + \frac{x^2}{b^2}}} \, dx = b \left(\sqrt{1 + \frac{a^2}{b^2}} - 1\right)",
        ),
    ] {
        assert!(follows(right), "{right}");
        assert!(!follows(wrong), "{wrong}");
    }
    for none in [
        // Beyond the limit there is no root.
        r"\int_0^{2 a} x \sqrt{a^2 - x^2} \, dx = -\sqrt{-27} \frac{a^3}{3}",
        r"\int_0^{2 a} x \sqrt{1 - \frac{x^2}{a^2}} \, dx = \frac{a^2}{3}",
        r"\int_0^b x \sqrt{1 - \frac{x^2}{a^2}} \, dx = \frac{a^2}{3} \left(1 - \left(1 - \frac{b^2}{a^2}\right)^{3/2}\right)",
        // What is divided by it grows beyond all bounds.
        r"\int_0^a \frac{x}{\sqrt{1 - \frac{x^2}{a^2}}} \, dx = a^2",
        r"\int_0^a \frac{x}{(a^2 - x^2)^{3/2}} \, dx = -\frac{1}{a}",
    ] {
        assert!(!follows(none), "{none}");
    }
}

/// The exponential of a power goes where that goes.
#[test]
fn exponentials_of_powers_die_away_or_grow() {
    told_apart(&[
        (
            r"\lim_{x \to \infty} x^3 \exp(-k x^2) = 0",
            r"\lim_{x \to \infty} x^3 \exp(-k x^2) = 1",
        ),
        (
            r"\lim_{x \to \infty} \frac{\exp(k x^2) + x}{c \exp(k x^2) - 1} = \frac{1}{c}",
            r"\lim_{x \to \infty} \frac{\exp(k x^2) + x}{c \exp(k x^2) - 1} = -1",
        ),
        (
            r"\int_0^\infty x \exp(-k x^2) \, dx = \frac{1}{2 k}",
            r"\int_0^\infty x \exp(-k x^2) \, dx = \frac{1}{k}",
        ),
        (
            r"\int_0^\infty x^3 \exp\left(-\frac{x^2}{2 b}\right) \, dx = 2 b^2",
            r"\int_0^\infty x^3 \exp\left(-\frac{x^2}{2 b}\right) \, dx = b^2",
        ),
    ]);
    refused(&[
        r"\lim_{x \to \infty} x \exp(k x^2) = 0",
        r"\lim_{x \to \infty} \exp(k x - x^2 (c - k)) = 0",
        r"\lim_{x \to \infty} \exp(-k x^2 + b x^3) = 0",
        r"\int_0^\infty x \exp(k x^2) \, dx = -\frac{1}{2 k}",
    ]);
}

/// Where the square vanishes between the limits, or may, there is no such integral; nor where what moves with it asks for more.
#[test]
fn no_square_is_integrated_where_it_may_vanish() {
    for none in [
        r"\int_0^2 \frac{x}{(1 - x^2)^2} \, dx = -\frac{2}{3}",
        r"\int_{-2}^2 \frac{x}{x^2 - 1} \, dx = 0",
        r"\int_0^1 \frac{x}{\sqrt{1 - x^2}} \, dx = 1",
        r"\int_0^a \frac{x}{(b - x^2)^2} \, dx = \frac{1}{2 (b - a^2)} - \frac{1}{2 b}",
        r"\int_0^a \frac{x}{\sqrt{b^2 + x^2} \ln x} \, dx = 0",
        r"\int_0^a \frac{x (x - c)}{(x - c) \sqrt{x^2 + b^2}} \, dx = \sqrt{a^2 + b^2} - b",
        r"\int_0^a \frac{x (\sqrt{x - c})^2}{(x - c) \sqrt{x^2 + b^2}} \, dx = \sqrt{a^2 + b^2} - b",
    ] {
        assert!(!follows(none), "{none}");
    }
}
