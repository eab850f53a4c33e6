//! Partial derivatives: nothing is held fixed of which that is not told.

use cradle_verify::kernel::{Domain, Problem, Reject, Standing};

use super::claims::*;

/// Whether the goal is an identity, once these hypotheses are put in.
fn identity(hypotheses: &[&str], unfold: &[usize], goal: &str) -> Result<(), Reject> {
    let claim = claim(hypotheses, goal);
    Problem::new(&claim, unfold)?;
    let proving = Proving::unfolding(claim, unfold);
    proving.checked(proving.combination(&[], 1, &[]))
}

const KINETIC: &str = r"\left(\frac{\partial}{\partial v}\left[\frac12 m v^2\right]\right)_m";

#[test]
fn what_is_told_to_be_held_fixed_is_and_nothing_else() {
    let judged = |goal: &str| identity(&[], &[], goal);
    assert_eq!(judged(&format!("{KINETIC} = m v")), Ok(()));
    assert_eq!(
        judged(&format!("{KINETIC} = 2 m v")),
        Err(Reject::IdentityFails)
    );
    let untold = r"\frac{\partial}{\partial v}\left[\frac12 m v^2\right] = m v";
    assert_eq!(judged(untold), Err(Reject::IdentityFails));
    let product = r"\frac{\partial}{\partial v}\left[\frac12 m v^2\right] = m v + \frac12 v^2 \frac{\partial m}{\partial v}";
    assert_eq!(judged(product), Ok(()));
    let constant = claim(&[], untold).domain("m", constant());
    let proving = Proving::new(constant);
    assert_eq!(proving.checked(proving.combination(&[], 1, &[])), Ok(()));
}

#[test]
fn functions_and_roots_are_differentiated_by_the_chain_rule() {
    let pairs = [
        (
            r"\left(\frac{\partial}{\partial t}[\sin(k x - w t)]\right)_{k, w, x}",
            r"-w \cos(k x - w t)",
            r"w \cos(k x - w t)",
        ),
        (
            r"\left(\frac{\partial}{\partial x}[\exp(a x)]\right)_a",
            r"a \exp(a x)",
            r"\exp(a x)",
        ),
    ];
    for (slope, right, wrong) in pairs {
        assert_eq!(identity(&[], &[], &format!("{slope} = {right}")), Ok(()));
        assert_eq!(
            identity(&[], &[], &format!("{slope} = {wrong}")),
            Err(Reject::IdentityFails)
        );
    }
}

#[test]
fn below_a_root_what_is_held_fixed_is() {
    let judged = |slope: &str| {
        let goal =
            format!(r"\left(\frac{{\partial}}{{\partial x}}[\sqrt{{x + y}}]\right)_y = {slope}");
        let claim = claim(&[], &goal)
            .domain("x", positive())
            .domain("y", positive());
        let proving = Proving::new(claim);
        proving.checked(proving.combination(&[], 1, &[]))
    };
    assert_eq!(judged(r"\frac{\sqrt{x + y}}{2 (x + y)}"), Ok(()));
    assert_eq!(
        judged(r"\frac{\sqrt{x + y}}{x + y}"),
        Err(Reject::IdentityFails)
    );
}

#[test]
fn the_order_is_free_within_one_set_of_variables() {
    let judged = |goal: &str| identity(&[], &[], goal);
    let untold =
        r"\frac{\partial^2 f}{\partial x \partial y} = \frac{\partial^2 f}{\partial y \partial x}";
    assert_eq!(judged(untold), Ok(()));
    let nested = |first: &str, second: &str| {
        format!(
            r"\left(\frac{{\partial}}{{\partial x}}\left[\left(\frac{{\partial f}}{{\partial y}}\right)_{{{first}}}\right]\right)_{{{second}}}"
        )
    };
    let turned = r"\left(\frac{\partial}{\partial y}\left[\left(\frac{\partial f}{\partial x}\right)_{y, z}\right]\right)_{x, z}";
    assert_eq!(
        judged(&format!("{} = {turned}", nested("x, z", "y, z"))),
        Ok(())
    );
    // Along a line on which p does not change, x does.
    assert_eq!(
        judged(&format!("{} = {turned}", nested("p, z", "y, z"))),
        Err(Reject::IdentityFails)
    );
}

#[test]
fn a_formula_is_put_in_where_it_holds_throughout() {
    let energy = r"E = \frac12 m v^2 + V";
    let slope = r"\left(\frac{\partial E}{\partial v}\right)_{m, V}";
    let goal = format!("{slope} = m v");
    assert_eq!(identity(&[energy], &[0], &goal), Ok(()));
    assert_eq!(identity(&[energy], &[], &goal), Err(Reject::IdentityFails));
    // What is so at one point says nothing of a slope.
    let mut momentary = claim(&[energy], &goal);
    momentary.hypotheses[0].standing = Standing::AtPoint;
    let refused = Problem::new(&momentary, &[0]).err();
    assert_eq!(refused, Some(Reject::NotUnfoldable(0)));
    // What is held fixed, and what is differentiated by, are not replaced.
    for other in ["V = v x", "v = p"] {
        let refused = identity(&[energy, other], &[0, 1], &goal);
        assert_eq!(refused, Err(Reject::NotUnfoldable(1)), "{other}");
    }
}

#[test]
fn an_unknown_slope_has_no_value_at_a_point() {
    let unknown = claim(&[], r"\frac{\partial E}{\partial v} = 0");
    let at = point(&[("E", 1), ("v", 1)]);
    assert_eq!(refuted(&unknown, at), Err(Reject::NoValue));
    let known = claim(&[], &format!("{KINETIC} = 2 m v"));
    assert_eq!(refuted(&known, point(&[("m", 1), ("v", 1)])), Ok(()));
    let right = claim(&[], &format!("{KINETIC} = m v"));
    let at = point(&[("m", 1), ("v", 1)]);
    assert_eq!(refuted(&right, at), Err(Reject::GoalNotFalse));
}

/// A slope of what is held fixed is an unknown of its own, that may change all the same.
#[test]
fn a_slope_of_what_is_held_fixed_is_not() {
    for slope in [
        r"\frac{df}{dy}",
        r"\left(\frac{\partial f}{\partial y}\right)_z",
    ] {
        let goal = format!(
            r"\left(\frac{{\partial}}{{\partial x}}[x {slope}]\right)_{{f, y, z}} = {slope}"
        );
        assert_eq!(identity(&[], &[], &goal), Err(Reject::IdentityFails));
    }
}

/// Of a function of the variable alone nothing has to be held fixed; of one of several something has.
#[test]
fn a_function_of_the_variable_alone_has_one_slope() {
    let judged = |goal: &str| identity(&[], &[], goal);
    let of_one = r"\left(\frac{\partial}{\partial x}[m V(x)]\right)_{m, v} = m \frac{d}{dx} V(x)";
    assert_eq!(judged(of_one), Ok(()));
    let of_two =
        r"\left(\frac{\partial}{\partial x}[m V(x, v)]\right)_{m, v} = m \frac{d}{dx} V(x, v)";
    assert_eq!(judged(of_two), Err(Reject::IdentityFails));
}

/// What does not change otherwise may do so along the line on which something else is held fixed.
#[test]
fn what_stands_still_otherwise_is_not_held_fixed() {
    let still = claim(
        &[r"\frac{dk}{ds} = 0", r"\int_0^1 k s \, ds = \frac{k}{2}"],
        r"\left(\frac{\partial}{\partial s}[k s]\right)_p = k",
    );
    let proving = Proving::new(still);
    let found = proving.checked(proving.combination(&[], 1, &[]));
    assert_eq!(found, Err(Reject::IdentityFails));
}

#[test]
fn nothing_is_differentiated_by_a_whole_number() {
    let whole = Domain {
        integer: true,
        ..Domain::default()
    };
    let claim = claim(&[], r"\left(\frac{\partial}{\partial n}[a n]\right)_a = a");
    assert!(Problem::new(&claim.domain("n", whole), &[]).is_err());
}
