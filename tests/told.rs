//! What sentences say beside displays: what is told in passing, how long it is so, and where it is so no more.

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;

use crate::common::{last_noted, verdicts};

/// What the last sentence before a display names it may be drawn from, whatever time it is of.
#[test]
fn laws_in_words_link_what_the_displays_say() {
    let page = |height: &str| {
        verdicts(&format!(
            "The stored energy is\n\n$$ U = \\frac12 k d^2 \\tag{{1}} $$\n\nAll of it becomes kinetic energy, $U = K$, where\n\n\
             $$ K = \\frac12 m v^2 \\tag{{2}} $$\n\nso by (1) and (2)\n\n$$ v^2 = \\frac{{k d^2}}{{m}} \\tag{{3}} $$\n\n\
             The block rises until $m g h = K$, which with (2) and (3) gives\n\n$$ h = {height} \\tag{{4}} $$\n"
        ))
    };
    let right = ["given", "given", "holds", "holds"];
    assert_eq!(page(r"\frac{k d^2}{2 m g}"), right);
    assert_eq!(page(r"\frac{k d^2}{m g}")[3], "fails");
}

#[test]
fn bounds_of_what_is_introduced_and_meanings_outlast_the_section() {
    let page = |setup: &str, between: &str| {
        last_noted(&format!(
            "# Setup\n\n{setup}\n\n# Laws\n\n$$ m v = m w \\tag{{1}} $$\n\n{between}Hence\n\n$$ v = w $$\n"
        ))
    };
    let stated = ("holds", vec![]);
    let unstated = ("holds", vec!["unstated-condition"]);
    for setup in [
        "We assume $m > 0$.",
        "Throughout we assume that $m \\neq 0$.",
        "There are five balls, each of mass $m > 0$.",
        "The mass $m$ is positive.",
        "Let $m > 0$.",
    ] {
        assert_eq!(page(setup, ""), stated, "{setup}");
    }
    // A case is over with its section, and a letter may be introduced anew.
    assert_eq!(page("If $m > 0$, then nothing is lost.", ""), unstated);
    assert_eq!(
        page("We assume $m > 0$.", "Let $m$ be any number. "),
        unstated
    );

    let ratio = |between: &str, end: &str| {
        verdicts(&format!(
            "$$ w (a + b) = a v \\tag{{1}} $$\n\n## Ratio\n\nLet $\\mu = b/a$ be the ratio. From (1)\n\n\
             $$ w = \\frac{{v}}{{1 + \\mu}} \\tag{{2}} $$\n\n## Energy\n\n{between}From (2)\n\n$$ w^2 = {end} $$\n"
        ))[2]
    };
    assert_eq!(ratio("", r"\frac{v^2}{(1 + b/a)^2}"), "holds");
    assert_eq!(ratio("", r"\frac{v^2}{(1 + a/b)^2}"), "fails");
}

/// What is said between displays without a sentence that could be cited.
#[test]
fn words_that_lead_on_draw_or_announce() {
    let page = |laws: &str, lead: &str, end: &str| {
        verdicts(&format!("{laws}\n\n{lead}\n\n$$ {end} $$\n"))
            .pop()
            .unwrap()
    };
    let law = "The current is\n\n$$ I = \\frac{U}{R + r} \\tag{1} $$";
    // The same in other words.
    for lead in ["i.e.", "that is,", "or", "or, equivalently,"] {
        assert_eq!(page(law, lead, "U = I (R + r)"), "holds", "{lead}");
        assert_eq!(page(law, lead, "U = I (R - r)"), "fails", "{lead}");
    }
    // Laws that are written one below the other are one premise.
    let two = "Momentum and energy are conserved:\n\n$$ m u = m v + M w $$\n\n$$ m u^2 = m v^2 + M w^2 $$";
    assert_eq!(page(two, "Therefore", "w = u + v"), "holds");
    assert_eq!(page(two, "Therefore", "w = u - v"), "fails");
    // A label of an exercise cites nothing.
    let parts =
        "(a) The momentum is\n\n$$ p = m v $$\n\n(b) The energy is\n\n$$ E = \\frac{p^2}{2 m} $$";
    assert_eq!(page(parts, "so that", "E = \\frac12 m v^2"), "holds");
    // What is done with the display before, and with what.
    let energy = "$$ m v = p \\tag{1} $$\n\nThe energy is\n\n$$ E = \\frac12 m v^2 \\tag{2} $$";
    assert_eq!(
        page(energy, "Rearranging with the help of (1),", "2 E = p v"),
        "holds"
    );
}

#[test]
fn several_laws_are_announced_together() {
    let page = |announced: &str| {
        verdicts(&format!(
            "{announced}\n\n$$ N + M = m g $$\n\nand\n\n$$ N a = M b $$\n\nHence\n\n$$ N (a + b) = m g b $$\n"
        ))
    };
    let right = ["given", "given", "holds"];
    assert_eq!(page("The two conditions of equilibrium are"), right);
    assert_eq!(page("We have the following equations."), right);
}

/// A case is over where another of the same is set.
#[test]
fn rival_cases_leave_one_another() {
    let page = |lead: &str, end: &str| {
        last_noted(&format!(
            "The current is\n\n$$ I = \\frac{{U}}{{R + r}} \\tag{{1}} $$\n\nIf $R = r$, (1) becomes\n\n$$ I = \\frac{{U}}{{2 r}} $$\n\n\
             {lead}\n\n$$ {end} $$\n"
        ))
        .0
    };
    assert_eq!(page("If $r = 0$, (1) becomes", r"I = \frac{U}{R}"), "holds");
    assert_eq!(
        page("If $r = 0$, (1) becomes", r"I = \frac{U}{2 R}"),
        "fails"
    );
    assert_eq!(
        page("- If $R = 2 r$, (1) becomes", r"I = \frac{U}{3 r}"),
        "holds"
    );
}

/// What a sentence bounds in passing, and what would be called something.
#[test]
fn bounds_and_names_in_passing() {
    let page = |lead: &str, end: &str| {
        last_noted(&format!(
            "$$ M u = M v \\tag{{1}} $$\n\n{lead}\n\n$$ {end} $$\n"
        ))
    };
    let stated = ("holds", vec![]);
    assert_eq!(page("With $M > 0$ we get from (1)", "u = v"), stated);
    assert_eq!(page("For every $M > 0$, (1) gives", "u = v"), stated);
    assert_eq!(
        page("(1) gives", "u = v"),
        ("holds", vec!["unstated-condition"])
    );
    let named = |would: &str| {
        verdicts(&format!(
            "The price is\n\n$$ p = a - b q \\tag{{1}} $$\n\nA monopolist {would} the quantity $Q = a/(2 b)$. At $q = Q$ we have, by (1),\n\n\
             $$ p = \\frac{{a}}{{2}} $$\n"
        ))[1]
    };
    assert_eq!(named("would choose"), "holds");
}

/// "The velocity vanishes" is said of the letter that the text calls so; of what has no letter, nothing is refuted.
#[test]
fn what_has_a_name_vanishes() {
    let page = |law: &str, lead: &str, end: &str| {
        last_noted(&format!(
            "{law}\n\n$$ v = u - g t \\tag{{1}} $$\n\n{lead}\n\n$$ t = {end} $$\n"
        ))
        .0
    };
    let (velocity, top) = (
        "The velocity of the ball is",
        "At the highest point the velocity vanishes, so",
    );
    assert_eq!(page(velocity, top, r"\frac{u}{g}"), "holds");
    assert_eq!(page(velocity, top, r"\frac{2 u}{g}"), "fails");
    assert_eq!(page("We know that", top, r"\frac{u}{g}"), "undecided");
    for lead in [
        "The velocity never vanishes, so",
        "If the velocity vanishes, then",
        "Thus the acceleration is not zero, so",
    ] {
        assert_ne!(page(velocity, lead, r"\frac{u}{g}"), "holds", "{lead}");
    }
}

/// A letter that a section introduces anew is not the one of the sections above.
#[test]
fn letters_of_another_section_are_others() {
    let page = |between: &str| {
        verdicts(&format!(
            "# Speed\n\nThe force is\n\n$$ F = c v \\tag{{1}} $$\n\n# Volume\n\n{between}\n\n$$ P = F v $$\n\nso\n\n$$ P = c v^2 $$\n"
        ))[2]
    };
    assert_eq!(page("The power is"), "holds");
    assert_ne!(page("Here $v$ denotes the volume. We set"), "holds");
}

#[test]
fn this_vanishes_where() {
    let page = |lead: &str, end: &str| {
        last_noted(&format!(
            "The slope is\n\n$$ s = a (x - b) \\tag{{1}} $$\n\nwith $a > 0$. {lead}\n\n$$ x = {end} $$\n"
        ))
        .0
    };
    for lead in ["This vanishes for", "It is zero when"] {
        assert_eq!(page(lead, "b"), "holds", "{lead}");
        assert_eq!(page(lead, "2 b"), "fails", "{lead}");
    }
    assert_ne!(page("This never vanishes for", "b"), "holds");
}

/// A moment of inertia is no moment, and a sentence about one place says nothing of what comes after it.
#[test]
fn what_is_of_one_place() {
    let pendulum = "Its moment of inertia is $J = M k^2$. By the theorem\n\n$$ I = J + M d^2 \\tag{1} $$\n\nThe motion obeys\n\n\
                    $$ w = M g d/I \\tag{2} $$\n\nUsing (1),\n\n$$ w = \\frac{g d}{k^2 + d^2} $$\n";
    assert_eq!(verdicts(pendulum)[2], "holds");
    let rate = |lead: &str| {
        verdicts(&format!(
            "The rate is\n\n$$ v = \\frac{{V s}}{{K + s}} \\tag{{1}} $$\n\n{lead}\n\n$$ v = \\frac{{V}}{{2}} $$\n"
        ))[1]
    };
    assert_eq!(rate("At $s = K$, by (1),"), "holds");
    assert_ne!(
        rate("At $s = K$ the rate is half of its maximum. Thus by (1)"),
        "fails"
    );
}

/// Where not all that nobody bounds can be positive, what the step speaks of may be.
#[test]
fn the_sign_that_is_left_unsaid_is_the_step_s() {
    let page = |speed: &str| {
        last_noted(&format!(
            "A body of mass $m > 0$ at the distance $r > 0$ has\n\n$$ U = -\\frac{{k m}}{{r}} \\tag{{1}} $$\n\n$$ \\frac12 m w^2 + U = 0 \\tag{{2}} $$\n\n\
             By (1) and (2),\n\n$$ w = {speed} $$\n"
        ))
    };
    let holds = ("holds", vec!["unstated-condition"]);
    assert_eq!(page(r"\sqrt{\frac{2 k}{r}}"), holds);
    assert_eq!(page(r"\sqrt{\frac{k}{2 r}}").0, "fails");
}

/// `T^2 = \dots` says that `T` changes with what stands there, and so that other factors need not.
#[test]
fn a_power_that_is_given_changes() {
    let page = "$$ T^2 = \\frac{r^3}{k} \\tag{1} $$\n\nThe energy is\n\n$$ E = \\frac{k m}{r} \\tag{2} $$\n\nDifferentiating (2) with respect to $r$,\n\n\
                $$ \\frac{dE}{dr} = -\\frac{k m}{r^2} $$\n";
    assert_eq!(last_noted(page), ("holds", vec!["taken-as-constant"]));
}

/// The side of the equation that is cited is set to zero, whatever stands last.
#[test]
fn sides_of_what_is_cited_vanish() {
    let slope = |lead: &str, end: &str| {
        last_noted(&format!(
            "The first derivative is\n\n$$ \\frac{{df}}{{dx}} = 3 x^2 - 12 x \\tag{{1}} $$\n\nand the second\n\n\
             $$ \\frac{{d^2 f}}{{dx^2}} = 6 x - 12. \\tag{{2}} $$\n\n{lead} for $x \\neq 0$,\n\n$$ x = {end}. $$\n"
        ))
        .0
    };
    for lead in [
        "Setting (1) equal to zero gives,",
        "Setting the derivative (1) to zero we find",
        "Equating (1) to zero gives,",
        "The right-hand side of (1) vanishes. Hence,",
    ] {
        assert_eq!(slope(lead, "4"), "holds", "{lead}");
        assert_eq!(slope(lead, "2"), "fails", "{lead}");
    }
    let rest = |lead: &str, end: &str| {
        verdicts(&format!(
            "The rate is\n\n$$ \\frac{{dN}}{{dt}} = r N - H \\tag{{1}} $$\n\n{lead}\n\n$$ {end} \\tag{{2}} $$\n\nDifferentiating (2) by $r$,\n\n\
             $$ \\frac{{dH}}{{dr}} = N + r \\frac{{dN}}{{dr}} $$\n"
        ))
    };
    for lead in [
        "In equilibrium the right-hand side of (1) vanishes:",
        "In equilibrium (1) vanishes. Hence",
        "At equilibrium the left side of (1) is zero, so",
    ] {
        assert_eq!(rest(lead, "r N = H")[1], "holds", "{lead}");
        assert_eq!(rest(lead, "r H = N")[1], "fails", "{lead}");
    }
    let again = "In equilibrium the right-hand side of (1) vanishes:";
    assert_eq!(rest(again, "r N = H")[2], "holds");
}

/// What must have a value is what the display before says the value of.
#[test]
fn it_must_be_equal_to_something() {
    let page = |lead: &str, end: &str| {
        last_noted(&format!(
            "The integral is\n\n$$ N = \\frac{{A^2 L}}{{2}}. \\tag{{1}} $$\n\n{lead}\n\n$$ {end} $$\n"
        ))
        .0
    };
    for lead in [
        "It must be equal to one, so",
        "It has to be 1. Hence",
        "which must be 1. Hence",
        "As the left-hand side of (1) must equal $1$, we get",
        "This should be unity, so",
        "Setting this equal to one, we get",
        "Equating $N$ to 1 gives",
    ] {
        assert_eq!(page(lead, r"A^2 = \frac{2}{L}"), "holds", "{lead}");
        assert_eq!(page(lead, r"A^2 = \frac{1}{L}"), "fails", "{lead}");
    }
    assert_eq!(
        page("It must equal $M$, so", r"A^2 = \frac{2 M}{L}"),
        "holds"
    );
    assert_eq!(
        page("It must not be equal to one, so", r"A^2 = \frac{2}{L}"),
        "fails"
    );
    let profit = |lead: &str, end: &str| {
        last_noted(&format!(
            "The profit is\n\n$$ G = (a - c) q - b q^2. \\tag{{1}} $$\n\nThe derivative is\n\n\
             $$ \\frac{{dG}}{{dq}} = a - c - 2 b q. \\tag{{2}} $$\n\n{lead}\n\n$$ q = {end} $$\n"
        ))
        .0
    };
    for lead in [
        "At the maximum it vanishes, so",
        "At the maximum it must vanish, so",
    ] {
        assert_eq!(profit(lead, r"\frac{a - c}{2 b}"), "holds", "{lead}");
        assert_eq!(profit(lead, r"\frac{a - c}{b}"), "fails", "{lead}");
    }
}

/// Of two equations that are equated the left sides are equal.
#[test]
fn equations_are_equated() {
    let page = |lead: &str, end: &str| {
        last_noted(&format!(
            "The kinetic energy is\n\n$$ K = \\frac12 m v^2 \\tag{{1}} $$\n\nand the potential energy\n\n$$ U = m g h. \\tag{{2}} $$\n\n\
             {lead}\n\n$$ h = {end} $$\n"
        ))
        .0
    };
    for lead in [
        "Equating (1) and (2) we get",
        "Setting (1) equal to (2) gives",
        "Equating the two expressions,",
        "Equating the kinetic energy (1) with the potential energy (2), we find",
        "Since no energy is lost, $K = U$, and therefore",
    ] {
        assert_eq!(page(lead, r"\frac{v^2}{2 g}"), "holds", "{lead}");
        assert_eq!(page(lead, r"\frac{v^2}{g}"), "fails", "{lead}");
    }
    assert_eq!(
        page("Since no energy $K = U$ is lost,", r"\frac{v^2}{g}"),
        "undecided"
    );
}

/// A condition in words that are not understood leaves open what may follow from it.
#[test]
fn conditions_that_are_not_understood_refute_nothing() {
    let page = |lead: &str| {
        last_noted(&format!(
            "The force is\n\n$$ F = a x - b \\tag{{1}} $$\n\nand the torque\n\n$$ M = F c + d x. \\tag{{2}} $$\n\n{lead}\n\n$$ x = \\frac{{b}}{{a}} $$\n"
        ))
        .0
    };
    for lead in [
        "Where both parts vanish,",
        "Equating coefficients in (1) we get",
        "It must be equal to the weight, so",
        "It never vanishes, so",
        "Hence the sum vanishes for",
    ] {
        assert_eq!(page(lead), "undecided", "{lead}");
    }
    assert_eq!(page("From (1) we get"), "fails");
}

/// What a sentence begins with before it says anything.
#[test]
fn words_that_only_lead_on() {
    let page = |lead: &str, end: &str| {
        last_noted(&format!(
            "We have\n\n$$ T = \\frac{{m (2 n + M)}}{{m + n + M}}. \\tag{{1}} $$\n\n{lead}\n\n$$ T = {end} $$\n"
        ))
        .0
    };
    for lead in [
        "As a check, for a massless pulley, $M = 0$, this is the well known result",
        "As a test, for $M = 0$ we have",
        "As expected, if $M = 0$, this becomes",
        "For example, with $M = 0$ we get",
        "For example, take $M = 0$. We get",
        "Conversely, at $M = 0$,",
        "Finally, setting $M = 0$ we find",
        "In particular, for $M = 0$ this gives",
        "To check this, let $M = 0$. Then",
    ] {
        assert_eq!(page(lead, r"\frac{2 m n}{m + n}"), "holds", "{lead}");
        assert_eq!(page(lead, r"\frac{m n}{m + n}"), "fails", "{lead}");
    }
}

/// Numbers that are taken are put in until the text speaks of the symbols again.
#[test]
fn numbers_are_taken() {
    let page = |lead: &str, end: &str| {
        verdicts(&format!(
            "The chance is\n\n$$ P = p s + (1 - p)(1 - c). \\tag{{1}} $$\n\n{lead}\n\n$$ P = {end} $$\n\nIn other words,\n\n\
             $$ P = 1 - p - c + p c + p s $$\n"
        ))
    };
    for lead in [
        "Now some numbers. Take $p = 0.01$, $s = 0.9$ and $c = 0.95$. We get",
        "We take $p = 0.01$, $s = 0.9$, and $c = 0.95$. This gives",
        "Let us take $p = 0.01$, $s = 0.9$ and $c = 0.95$. Hence",
        "Set $p = 0.01$, $s = 0.9$ and $c = 0.95$. Then",
    ] {
        let right = page(lead, r"0.01 \cdot 0.9 + 0.99 \cdot 0.05 = 0.0585");
        assert_eq!(right[1..], ["holds", "holds"], "{lead}");
        let wrong = page(lead, r"0.01 \cdot 0.9 + 0.99 \cdot 0.95 = 0.9495");
        assert_eq!(wrong[1], "fails", "{lead}");
    }
}

/// A word in parentheses that numbers no equation cites none.
#[test]
fn remarks_in_parentheses_cite_nothing() {
    let page = |remark: &str, law: &str| {
        verdicts(&format!(
            "We want the acceleration $a$ ({remark}). Newton's second law is\n\n$$ {law} = m a. $$\n\nHence\n\n$$ a = g - \\frac{{T}}{{m}} $$\n"
        ))
    };
    assert_eq!(page("downwards", "m g - T"), ["given", "holds"]);
    assert_eq!(page("downwards", "m g + T"), ["given", "fails"]);
    let tagged = "$$ p v = c \\tag{gas} $$\n\nFrom the law of the ideal state (gas) we get\n\n$$ v = c p $$\n";
    assert_eq!(verdicts(tagged)[1], "fails");
}

/// Values of one symbol for different things are each so of its own.
#[test]
fn values_of_kinds_are_told_apart() {
    let page = |said: &str, end: &str| {
        last_noted(&format!(
            "The heat capacity is\n\n$$ C = \\frac{{f}}{{2}} R \\tag{{1}} $$\n\n{said}\n\n$$ C = \\frac{{{end}}}{{2}} R $$\n"
        ))
        .0
    };
    for said in [
        "where $f = 3$ for monatomic and $f = 5$ for diatomic gases. For a diatomic gas (1) gives",
        "with $f = 3$ for a monatomic gas and $f = 5$ for a diatomic gas. For a diatomic gas, where $f = 5$, this becomes",
        "where for a monatomic gas $f = 3$ and for a diatomic gas $f = 5$. For a diatomic gas we get from (1)",
        "For a monatomic gas $f = 3$. For a diatomic gas $f = 5$. Hence for a diatomic gas",
        "For a monatomic gas $f = 3$. For a diatomic gas $f = 5$, so",
        "with $f = 5$ for a diatomic gas. Hence",
    ] {
        assert_eq!(page(said, "5"), "holds", "{said}");
        assert_ne!(page(said, "3"), "holds", "{said}");
    }
    // Of what nobody says which it is neither is a premise.
    let none = "where $f = 3$ for monatomic and $f = 5$ for diatomic gases. By (1)";
    assert_eq!(page(none, "5"), "fails");
    assert_eq!(page(none, "3"), "fails");
    // Nor does the first let a display before it follow from anything.
    let before = "The energy is\n\n$$ E = \\frac12 m v^2 + \\frac12 I w^2 $$\n\nWe write\n\n$$ I = b m r^2 $$\n\nwith $b = 1/2$ for a cylinder.\n";
    assert_eq!(verdicts(before), ["given", "given"]);
}

/// What is so at one moment, or for the moment, is so no longer.
#[test]
fn what_is_so_for_a_moment() {
    let page = |clause: &str, end: &str| {
        last_noted(&format!(
            "The current is\n\n$$ I = I_0 + k t, \\tag{{1}} $$\n\n{clause} The power is\n\n$$ P = R I^2. \\tag{{2}} $$\n\n\
             Inserting (1) into (2) we get\n\n$$ P = {end} $$\n"
        ))
        .0
    };
    for clause in [
        "which starts with $I = I_0$ at $t = 0$.",
        "where $I = I_0$ when $t = 0$.",
        "so $I = I_0$ at the time $t = 0$.",
    ] {
        assert_eq!(page(clause, "R (I_0 + k t)^2"), "holds", "{clause}");
        assert_eq!(page(clause, "R I_0^2"), "fails", "{clause}");
    }
    let force = |between: &str, end: &str| {
        verdicts(&format!(
            "The force is\n\n$$ F = m a + k v. \\tag{{1}} $$\n\nWe assume $k = 0$ for the moment. Then\n\n$$ F = m a. $$\n\n{between}The power is\n\n\
             $$ P = F v. \\tag{{3}} $$\n\nInserting (1) into (3) we obtain\n\n$$ P = {end} $$\n"
        ))
    };
    for between in [
        "Now we include friction again. ",
        "Now we allow for friction again. ",
        "We no longer neglect friction. ",
        "Restoring friction, we go on. ",
    ] {
        assert_eq!(force(between, "m a v + k v^2")[3], "holds", "{between}");
        assert_eq!(force(between, "m a v")[3], "fails", "{between}");
    }
    assert_eq!(force("", "m a v")[1..], ["holds", "given", "holds"]);
}

/// What goes on with a law by "and", names moments, or puts circumstances in words, is a law.
#[test]
fn laws_that_words_go_on_to() {
    let page = |first: &str, law: &str, lead: &str, next: &str, end: &str| {
        verdicts(&format!(
            "{first}\n\n$$ {law} $$\n\n{lead}\n\n$$ {next} $$\n\nTherefore\n\n$$ {end} $$\n"
        ))
    };
    let incline = |lead: &str, end: &str| {
        let law = r"m a = m g \sin\theta - \mu N \tag{1}";
        let next = r"N = m g \cos\theta \tag{2}";
        page(
            "Newton's second law along the incline gives",
            law,
            lead,
            next,
            end,
        )
    };
    let right = ["given", "given", "holds"];
    assert_eq!(
        incline("and perpendicular to it", r"\mu N = \mu m g \cos\theta"),
        right
    );
    assert_eq!(
        incline("and perpendicular to it", r"\mu N = m g \cos\theta")[2],
        "fails"
    );
    assert_eq!(
        incline("and hence", r"\mu N = m g \cos\theta")[1],
        "undecided"
    );
    let beam = |lead: &str, end: &str| {
        let law = "R + S = P + a + b \\tag{1}";
        page(
            "Equilibrium of the vertical forces demands",
            law,
            lead,
            "S b = P a \\tag{2}",
            end,
        )
    };
    assert_eq!(beam("and the moments about A give", "2 S b = 2 P a"), right);
    assert_eq!(
        beam("and the moments about A give", "S b = 2 P a")[2],
        "fails"
    );
    let flow = |lead: &str, end: &str| {
        let law = r"Q = A \sqrt{\frac{2 P}{\rho}} \tag{1}";
        page(
            "The flow is",
            law,
            lead,
            r"P = (\sigma - \rho) g h \tag{2}",
            end,
        )
    };
    let manometer = "If the pressure is read from a mercury manometer, then";
    assert_eq!(flow(manometer, r"P = \sigma g h - \rho g h"), right);
    assert_eq!(flow(manometer, r"P = \sigma g h")[2], "undecided");
}

/// What is said to be fixed does not change, whatever the rest of the sentence says changes.
#[test]
fn what_is_fixed_does_not_change() {
    let page = |said: &str, end: &str| {
        last_noted(&format!(
            "The surface is\n\n$$ A = 2 \\pi r^2 + \\frac{{2 V}}{{r}}. \\tag{{1}} $$\n\n{said}\n\n$$ \\frac{{dA}}{{dr}} = {end} $$\n"
        ))
    };
    for said in [
        "Now $A$ depends on $r$ only, since $V$ is fixed. From (1) the derivative is",
        "From (1) the derivative is, for a fixed volume $V$,",
        "$V$ is fixed. By (1) the derivative is",
    ] {
        let right = page(said, r"4 \pi r - \frac{2 V}{r^2}");
        assert_eq!(right, ("holds", vec![]), "{said}");
        assert_eq!(page(said, r"4 \pi r - \frac{2 V}{r}").0, "fails", "{said}");
    }
}

/// The text may write with a slash what displays write as a fraction.
#[test]
fn slopes_with_a_slash() {
    let page = |lead: &str, end: &str| {
        last_noted(&format!(
            "The rate is\n\n$$ \\frac{{dc}}{{dt}} = k e s - n c. \\tag{{1}} $$\n\n{lead}\n\n$$ k e s = {end}. \\tag{{2}} $$\n"
        ))
        .0
    };
    for lead in [
        "In the quasi-steady state $dc/dt = 0$, so that",
        "Setting $dc/dt = 0$ we get",
        "With $dc / dt = 0$ in (1) we get",
        "At the maximum $d c/d t = 0$, so",
    ] {
        assert_eq!(page(lead, "n c"), "holds", "{lead}");
        assert_eq!(page(lead, "2 n c"), "fails", "{lead}");
    }
}

/// A volume that is fixed is tied to what is solved for by it, and has another form where the surface is least: it is fixed all the same.
#[test]
fn what_is_fixed_may_be_given() {
    let page = |slope: &str| {
        verdicts(&format!(
            "The volume is\n\n$$ V = \\pi r^2 h. \\tag{{1}} $$\n\nWe solve (1) for the height, with $r > 0$,\n\n$$ h = \\frac{{V}}{{\\pi r^2}}. \\tag{{2}} $$\n\n\
             The surface is\n\n$$ A = 2 \\pi r^2 + \\frac{{2 V}}{{r}}. \\tag{{3}} $$\n\nNow $A$ depends on $r$ only, since $V$ is fixed. From (3) the derivative is\n\n\
             $$ \\frac{{dA}}{{dr}} = {slope}. \\tag{{4}} $$\n\nSetting (4) to zero gives\n\n$$ V = 2 \\pi r^3. $$\n"
        ))
    };
    let right = ["given", "holds", "given", "holds", "holds"];
    assert_eq!(page(r"4 \pi r - \frac{2 V}{r^2}"), right);
    assert_eq!(page(r"4 \pi r - \frac{V}{r^2}")[3], "fails");
    // That it is a volume is said of it.
    assert_eq!(page(r"4 \pi r - \frac{2 V}{r}")[3], "ill-dimensioned");
}

/// A volume that is fixed ties the height to the radius, be it named by its letter or by its word.
#[test]
fn what_is_fixed_lets_what_it_is_made_of_keep_up() {
    let page = |said: &str, slope: &str| {
        last_noted(&format!(
            "The volume is\n\n$$ V = \\pi r^2 h \\tag{{1}} $$\n\nand the surface\n\n$$ A = 2 \\pi r^2 + 2 \\pi r h \\tag{{2}} $$\n\n\
             {said}, differentiating (2) gives\n\n$$ \\frac{{dA}}{{dr}} = {slope} \\tag{{3}} $$\n"
        ))
    };
    for said in [
        "For a fixed volume",
        "For fixed volume",
        "With the volume fixed",
        "For a fixed volume $V$",
    ] {
        let (verdict, codes) = page(said, r"4 \pi r - 2 \pi h");
        assert_eq!((verdict, codes), ("holds", vec!["miscited"]), "{said}");
        assert_eq!(page(said, r"4 \pi r + 2 \pi h").0, "undecided", "{said}");
    }
    // A height that is fixed lets the volume change.
    assert_eq!(
        page("For a fixed height $h$", r"4 \pi r + 2 \pi h").0,
        "holds"
    );
    assert_eq!(
        page("For a fixed height $h$", r"4 \pi r - 2 \pi h").0,
        "fails"
    );
}

/// What was shown for a constant inflow says nothing of one that is controlled.
#[test]
fn what_was_constant_and_is_given_by_what_moves_is_constant_no_more() {
    let page = |sign: &str| {
        verdicts(&format!(
            "The balance reads\n\n$$ \\tau \\frac{{dy}}{{dt}} + y = R u \\tag{{1}} $$\n\nFor a constant inflow $u$ and an empty tank the solution is\n\n\
             $$ y = R u \\left( 1 - e^{{-t/\\tau}} \\right) \\tag{{2}} $$\n\nNow we close the loop with a controller,\n\n$$ u = K (w - y) \\tag{{3}} $$\n\n\
             Inserting (3) into (1) yields\n\n$$ \\tau \\frac{{dy}}{{dt}} + (1 {sign} K R) y = K R w \\tag{{4}} $$\n"
        ))
    };
    assert_eq!(page("+"), ["given", "given", "given", "holds"]);
    assert_eq!(page("-")[3], "fails");
}

/// What words draw is checked, be its left side a new letter.
#[test]
fn what_words_draw_is_no_definition() {
    let end = |text: &str, right: &str, wrong: &str| {
        let page = |formula: &str| last_noted(&format!("{text}\n\n$$ {formula} $$\n")).0;
        (page(right), page(wrong))
    };
    let segment = "The area is\n\n$$ A = \\frac{r^2}{2} (\\varphi - \\sin\\varphi) \\tag{1} $$\n\nFor a half circle, $\\varphi = \\pi$, we recover";
    let (right, wrong) = (r"A = \frac{\pi r^2}{2}", r"A = \frac{\pi r^2}{4}");
    assert_eq!(end(segment, right, wrong), ("holds", "fails"));
    // That it is an area is said of it.
    let unlike = end(segment, right, r"A = \frac{\pi r}{2}");
    assert_eq!(unlike, ("holds", "ill-dimensioned"));

    let lost = "The momentum balance reads\n\n$$ m v = (m + M) V \\tag{1} $$\n\nThe energy that is lost is\n\n\
                $$ Q = \\frac12 m v^2 - \\frac12 (m+M) V^2 \\tag{2} $$\n\nAs a fraction of the initial energy this is";
    let share = |part: &str| format!("\\frac{{2Q}}{{m v^2}} = \\frac{{{part}}}{{m + M}}");
    assert_eq!(end(lost, &share("M"), &share("m")), ("holds", "fails"));

    let rolling = "The speed is\n\n$$ v^2 = \\frac{2 g h}{1+\\beta} \\tag{1} $$\n\nwhere\n\n$$ h = \\ell \\sin\\theta \\tag{2} $$\n\n\
                   Because the acceleration is constant, $v^2 = 2 a \\ell$. Combining this with (1) and (2) yields";
    let slope = |function: &str| format!("a = \\frac{{g {function}\\theta}}{{1 + \\beta}}");
    let found = end(rolling, &slope("\\sin"), &slope("\\cos"));
    assert_eq!(found, ("holds", "fails"));

    // What is told of another new letter says nothing of this one.
    let other = "The speed is\n\n$$ v^2 = 2 g h \\tag{1} $$\n\nThe kinetic energy is $K = \\frac12 m w^2$. By (1) we get";
    let page = |formula: &str| last_noted(&format!("{other}\n\n$$ {formula} $$\n")).0;
    assert_eq!(page(r"w = 2 g h"), "given");
}

/// "We obtain the velocity": it is the slope of what is cited.
#[test]
fn a_slope_that_words_take_is_that_of_what_they_cite() {
    let page = |words: &str, value: &str| {
        last_noted(&format!(
            "The position is\n\n$$ x = A \\cos(\\omega t) \\tag{{1}} $$\n\n{words}\n\n$$ v = {value} $$\n"
        ))
        .0
    };
    for words in [
        "Differentiating (1) with respect to time we obtain the velocity",
        "Differentiating (1) with respect to $t$ gives",
        "Differentiating (1), we find the velocity",
    ] {
        let right = page(words, r"-A \omega \sin(\omega t)");
        assert_eq!(right, "holds", "{words}");
        assert_eq!(page(words, r"-A \sin(\omega t)"), "fails", "{words}");
    }
    let twice = "Differentiating (1) twice with respect to time we obtain";
    assert_eq!(page(twice, r"-A \omega^2 \cos(\omega t)"), "holds");
    assert_eq!(page(twice, r"-A \omega \sin(\omega t)"), "fails");
    // By what is not said here.
    assert_eq!(page("Differentiating (1) we find", "-A"), "given");
}

/// Two symbols take two equations to define.
#[test]
fn all_rows_define_what_is_defined_through_them() {
    let page = |words: &str| {
        verdicts(&format!(
            "At the apsides\n\n$$ p v = q w \\tag{{1}} $$\n\n{words}\n\n\
             $$ \\begin{{aligned}} p &= a (1 - e) \\\\ q &= a (1 + e) \\end{{aligned}} $$\n"
        ))
    };
    let two = "The semi-major axis $a$ and the eccentricity $e$ are defined through";
    assert_eq!(page(two), ["given", "given", "given"]);
    assert_eq!(page("Hence")[2], "undecided");
}

#[test]
fn this_that_something_is_compared_with_is_the_display_before() {
    let page = |height: &str| {
        last_noted(&format!(
            "The volume is\n\n$$ V = \\pi r^2 h \\tag{{1}} $$\n\nand the area\n\n$$ A = 2 \\pi r^2 + \\frac{{2 V}}{{r}} \\tag{{2}} $$\n\n\
             Its derivative is\n\n$$ \\frac{{dA}}{{dr}} = 4 \\pi r - \\frac{{2 V}}{{r^2}} \\tag{{3}} $$\n\n\
             Setting (3) equal to zero gives\n\n$$ V = 2 \\pi r^3 \\tag{{4}} $$\n\nComparing this with (1), we see that\n\n$$ h = {height} $$\n"
        ))
        .0
    };
    assert_eq!(page("2 r"), "holds");
    assert_eq!(page("3 r"), "fails");
}

/// Who cites another equation goes on from the display before all the same, and from what that was shown under.
#[test]
fn a_step_goes_on_from_the_display_before_as_it_is_meant() {
    let page = |sign: &str, said: &str| {
        verdicts(&format!(
            "The total enzyme is\n\n$$ z = e + c \\tag{{1}} $$\n\nand the rate\n\n$$ \\frac{{dc}}{{dt}} = k e s - n c \\tag{{2}} $$\n\n\
             In the steady state $dc/dt = 0$, so that\n\n$$ k e s = n c \\tag{{3}} $$\n\n{said}Eliminating $e$ with (1),\n\n\
             $$ c = \\frac{{k z s}}{{n {sign} k s}} \\tag{{4}} $$\n"
        ))[3]
    };
    assert_eq!(page("+", ""), "holds");
    assert_eq!(page("-", ""), "fails");
}

/// What tells `r` from `s` is of no case in which they are one; nor is what is said in general.
#[test]
fn what_is_beyond_a_special_case_does_not_rest_on_it() {
    let risks = |words: &str, first: &str, second: &str| {
        verdicts(&format!(
            "The variance is\n\n$$ V = w^2 s^2 + (1 - w)^2 r^2 \\tag{{1}} $$\n\n{words}\n\n\
             $$ V = (1 - 2 w + 2 w^2) s^2 \\tag{{2}} $$\n\nDifferentiating (1) gives\n\n\
             $$ \\frac{{dV}}{{dw}} = 2 w {first}^2 - 2 (1 - w) {second}^2 \\tag{{3}} $$\n"
        ))
    };
    for words in ["For equal risks $s = r$ this is", "If $s = r$ this is"] {
        assert_eq!(risks(words, "s", "r"), ["given", "holds", "holds"]);
        assert_eq!(risks(words, "r", "s"), ["given", "holds", "fails"]);
    }

    let lens = |begins: &str, ratio: &str| {
        last_noted(&format!(
            "The lens equation and the magnification are\n\n\
             $$ \\frac1s + \\frac1t = \\frac1f, \\qquad M = \\frac{{t}}{{s}} \\tag{{1}} $$\n\n\
             Object and image have the same size where $s = t$. From (1) we find\n\n$$ s = 2 f \\tag{{2}} $$\n\n\
             {begins} the magnification is, by (1),\n\n$$ M = {ratio} \\tag{{3}} $$\n"
        ))
        .0
    };
    for begins in ["In all cases", "In general"] {
        assert_eq!(lens(begins, "\\frac{f}{s - f}"), "holds");
        assert_eq!(lens(begins, "\\frac{s - f}{f}"), "fails");
    }
}

/// What is told to be so is no case: a law may speak of both sides again, and so may the display that the case leads to.
#[test]
fn what_holds_anyway_is_in_force_for_what_speaks_of_all_of_it() {
    let page = |words: &str, speed: &str| {
        last_noted(&format!(
            "The momentum is\n\n$$ p = m v + n w \\tag{{1}} $$\n\n{words}\n\n$$ p = (m + n) v \\tag{{2}} $$\n\n\
             The energy\n\n$$ E = \\frac12 m v^2 + \\frac12 n w^2 \\tag{{3}} $$\n\ntherefore is\n\n$$ E = {speed} $$\n"
        ))
        .0
    };
    for words in [
        "The string is taut and $v = w$. Then",
        "Since $v = w$ we have",
    ] {
        assert_eq!(page(words, "\\frac12 (m + n) v w"), "holds");
        assert_eq!(page(words, "(m + n) v w"), "fails");
    }
}

/// Whoever goes on from what holds under a condition means that, whatever else is cited.
#[test]
fn a_step_goes_on_from_what_holds_under_a_condition() {
    let page = |power: u8| {
        last_noted(&format!(
            "The star gives off\n\n$$ L = 4 \\pi R^2 \\sigma T^4 \\tag{{1}} $$\n\nof which there arrives\n\n\
             $$ S = \\frac{{L}}{{4 \\pi d^2}} \\tag{{2}} $$\n\nA planet absorbs\n\n$$ P = \\pi r^2 S \\tag{{3}} $$\n\nand emits\n\n\
             $$ Q = 4 \\pi r^2 \\sigma U^4 \\tag{{4}} $$\n\nIn equilibrium, $P = Q$, so that from (3) and (4)\n\n\
             $$ U^4 = \\frac{{S}}{{4 \\sigma}} \\tag{{5}} $$\n\nInserting (1) and (2) we get\n\n\
             $$ U^4 = \\frac{{R^2}}{{4 d^{power}}} T^4 \\tag{{6}} $$\n"
        ))
    };
    let (verdict, codes) = page(2);
    assert_eq!((verdict, codes.contains(&"miscited")), ("holds", false));
    assert_eq!(page(3).0, "fails");
}

/// What an implication arrives at is no new meaning of the symbol: `\Rightarrow \mu = 1` finds a value.
#[test]
fn what_is_found_is_no_new_meaning() {
    let page = |numerator: &str| {
        last_noted(&format!(
            "# One\n\n## Ratio\n\nTwo masses $m > 0$ and $n > 0$ collide. Let $r = n/m$ be their ratio. The share is\n\n\
             $$ s = \\frac{{4 m n}}{{(m + n)^2}} \\tag{{1}} $$\n\nwhich is\n\n$$ s = \\frac{{4 r}}{{(1 + r)^2}} \\tag{{2}} $$\n\n## Best\n\n\
             Differentiating (2),\n\n$$ \\frac{{ds}}{{dr}} = \\frac{{4 (1 - r)}}{{(1 + r)^3}} \\tag{{3}} $$\n\n\
             Setting the derivative to zero gives\n\n\
             $$ \\frac{{4 (1 - r)}}{{(1 + r)^3}} = 0 \\quad \\Rightarrow \\quad {numerator} = 0 \\quad \\Rightarrow \\quad r = 1 $$\n"
        ))
        .0
    };
    assert_eq!(page("1 - r"), "holds");
    assert_eq!(page("2 - r"), "fails");
}

/// What several quantities have in common gets a name in words.
#[test]
fn a_name_for_a_common_value_is_that_of_each() {
    let page = |words: &str, sum: &str| {
        last_noted(&format!(
            "The bodies have the total momentum\n\n$$ p = m v + n w \\tag{{1}} $$\n\nIn the end they stick together:\n\n\
             $$ v = w \\tag{{2}} $$\n\n{words} from (1)\n\n$$ p = {sum} u \\tag{{3}} $$\n"
        ))
        .0
    };
    for words in [
        "Call their common velocity $u$. Then",
        "Calling the common velocity $u$, we have",
        "We denote the common velocity by $u$. Then",
        "Let $u$ be their common velocity. Then",
    ] {
        assert_eq!(page(words, "(m + n)"), "holds", "{words}");
        assert_eq!(page(words, "(m - n)"), "fails", "{words}");
    }

    // A common denominator is no value of theirs.
    assert_eq!(
        verdicts(
            "The two are equal,\n\n$$ v = w \\tag{1} $$\n\nWith the common denominator $d$, which is\n\n$$ d = a + b \\tag{2} $$\n"
        )[1],
        "given"
    );

    let balls = |result: &str| {
        last_noted(&format!(
            "<!-- check: symbols n: count, natural -->\n\nThe momentum is\n\n$$ n w = \\sum_{{i=1}}^n u_i \\tag{{1}} $$\n\n\
             and all velocities are the same:\n\n$$ u_1 = u_2 = \\dots = u_n \\tag{{2}} $$\n\nCalling the common value $u$, we read off from (1)\n\n\
             $$ n w = n u \\quad \\Rightarrow \\quad u = {result} $$\n"
        ))
        .0
    };
    assert_eq!(balls("w"), "holds");
    assert_eq!(balls("2 w"), "fails");
}

/// Whoever goes on from the display before rests on what that rests on, whatever else is cited.
#[test]
fn a_step_goes_on_from_what_rests_on_something_false() {
    let page = |value: &str| {
        verdicts(&format!(
            "The sum is\n\n$$ p = a + b \\tag{{1}} $$\n\nand by assumption\n\n$$ p \\geq 2 a \\tag{{2}} $$\n\n\
             From (1) we conclude that\n\n$$ p \\leq 2 a \\tag{{3}} $$\n\nFrom (2) and (3) follows\n\n$$ p = 2 a \\tag{{4}} $$\n\n\
             So this is the case of equality in (2), and therefore\n\n$$ a = b \\tag{{5}} $$\n\n\
             Calling the common value $c$, we read off from (1) that\n\n$$ p = {value} \\tag{{6}} $$\n"
        ))
    };
    assert_eq!(page("2 c")[2..], ["fails", "holds", "holds", "holds"]);
    assert_eq!(page("3 c")[2..], ["fails", "holds", "holds", "fails"]);
}

/// Also where it needs a condition of its own.
#[test]
fn what_is_inserted_is_the_display_before() {
    let page = |area: &str| {
        last_noted(&format!(
            "Two tanks hold\n\n$$ A x + B y = V \\tag{{1}} $$\n\nand the flow between them is\n\n$$ Q = k (x - y) \\tag{{2}} $$\n\n\
             Solving (2) for $y$ gives\n\n$$ y = x - \\frac{{Q}}{{k}} \\tag{{3}} $$\n\nand inserting this into (1)\n\n\
             $$ x = \\frac{{V + {area} Q/k}}{{A + B}} \\tag{{4}} $$\n"
        ))
    };
    let (verdict, codes) = page("B");
    assert_eq!((verdict, codes.contains(&"miscited")), ("holds", false));
    assert_eq!(page("A").0, "fails");
}

/// A case that is set in a sentence of its own is one of the step that comes next, where that no longer speaks of what is set.
#[test]
fn a_case_is_set_in_the_sentence_before() {
    let page = |words: &str, result: &str| {
        last_noted(&format!(
            "The height is\n\n$$ y = u t - \\frac12 g t^2 \\tag{{1}} $$\n\n{words}\n\n$$ g t^2 = {result} \\tag{{2}} $$\n"
        ))
        .0
    };
    for words in [
        "The ball is back on the ground when $y = 0$. By (1), this is at",
        "For $y = 0$ the ball is on the ground. (1) becomes",
    ] {
        assert_eq!(page(words, "2 u t"), "holds", "{words}");
        assert_eq!(page(words, "u t"), "fails", "{words}");
    }
    let left = "The ball is back on the ground when $y = 0$. In general, by (1),";
    assert_ne!(page(left, "2 u t"), "holds");
}

/// What is told of a case is told of the next display of the same sentence, too.
#[test]
fn a_sentence_goes_on_past_a_display() {
    let page = |result: &str| {
        verdicts(&format!(
            "The variance and the optimal share are\n\n$$ V = w^2 s^2 + (1 - w)^2 r^2 + 2 w (1 - w) c s r \\tag{{1}} $$\n\n\
             $$ w = \\frac{{r^2 - c s r}}{{s^2 + r^2 - 2 c s r}} \\tag{{2}} $$\n\n\
             For uncorrelated assets, $c = 0$, equation (2) becomes\n\n$$ w = \\frac{{r^2}}{{s^2 + r^2}} \\tag{{3}} $$\n\n\
             and the variance (1) is then\n\n$$ V = \\frac{{{result}}}{{s^2 + r^2}} \\tag{{4}} $$\n"
        ))
    };
    assert_eq!(page("s^2 r^2"), ["given", "given", "holds", "holds"]);
    assert_eq!(page("2 s^2 r^2")[3], "fails");
}

/// What a symbol is said to be just before its display is put in, with what speaks of the symbols that it is said by.
#[test]
fn what_a_symbol_is_said_to_be_leads_to_what_else_is_known() {
    let page = |factor: &str| {
        last_noted(&format!(
            "Altogether there are\n\n$$ n = n_0 (1 + \\alpha) \\tag{{1}} $$\n\nmoles. The equilibrium constant is\n\n\
             $$ K = \\frac{{4 \\alpha^2}}{{1 - \\alpha^2}} p \\tag{{2}} $$\n\n\
             If the degree of dissociation is $\\alpha = 1/2$, then by (2)\n\n$$ K = \\frac43 p \\tag{{3}} $$\n\n\
             and the mean molar mass, $\\bar M = n_0 M/n$, is\n\n$$ \\bar M = {factor} M \\tag{{4}} $$\n"
        ))
        .0
    };
    assert_eq!(page("\\frac{2}{3}"), "holds");
    assert_eq!(page("\\frac{3}{2}"), "fails");
}

/// A counterexample has what the sentence tells; where none is found with that, nothing is said.
#[test]
fn what_a_sentence_tells_is_so_in_a_counterexample() {
    let page = |result: &str| {
        last_noted(&format!(
            "The field is\n\n$$ I = \\int_0^{{a}} f(x) \\, dx + \\int_0^{{b}} f(x) \\, dx $$\n\n\
             For equal lengths, $a = b = c$, so that (1) becomes\n\n$$ I = {result} \\int_0^c f(x) \\, dx $$\n"
        ))
        .0
    };
    assert_ne!(page("2"), "fails");
    assert_ne!(page("3"), "holds");
}

/// What is put in at one place is no case of what comes later.
#[test]
fn what_is_put_in_at_a_place_is_not_kept() {
    let page = |factor: &str| {
        last_noted(&format!(
            "The drag is\n\n$$ F = \\frac12 \\rho A v^2 \\tag{{1}} $$\n\nand the equation of motion is\n\n\
             $$ m \\frac{{dv}}{{dt}} = m g - F \\tag{{2}} $$\n\nSetting $F = m g$ at $v = u$ in (1),\n\n\
             $$ u = \\sqrt{{\\frac{{2 m g}}{{\\rho A}}}} \\tag{{3}} $$\n\nWith (1) and (3), (2) can be rewritten as\n\n\
             $$ \\frac{{dv}}{{dt}} = {factor} g \\left(1 - \\frac{{v^2}}{{u^2}}\\right) \\tag{{4}} $$\n"
        ))
        .0
    };
    assert_ne!(page(""), "fails");
    assert_eq!(page("2"), "fails");
}

/// A step that cites one equation and names another by words follows from what holds under a condition, too.
#[test]
fn a_step_may_need_what_holds_under_a_condition() {
    let page = |factor: &str| {
        last_noted(&format!(
            "The force keeps the proton on a circle:\n\n$$ q v B = \\frac{{m v^2}}{{r}} \\tag{{1}} $$\n\nOne turn takes\n\n\
             $$ T = \\frac{{2\\pi r}}{{v}} \\tag{{2}} $$\n\nso by (1)\n\n$$ T = \\frac{{2\\pi m}}{{q B}} \\tag{{3}} $$\n\n\
             The oscillator must run at\n\n$$ f = \\frac{{1}}{{T}} = \\frac{{q B}}{{2\\pi m}} \\tag{{4}} $$\n\n\
             At the extraction radius $R$ the kinetic energy is\n\n$$ K = \\frac{{q^2 B^2 R^2}}{{2 m}} \\tag{{5}} $$\n\n\
             Expressed by the frequency, the energy (5) becomes\n\n$$ K = {factor} \\pi^2 m f^2 R^2 \\tag{{6}} $$\n"
        ))
        .0
    };
    assert_eq!(page("2"), "holds");
    assert_eq!(page("4"), "fails");
}

/// "If …, then" puts a condition in words: of new symbols nobody knows what they are under it.
#[test]
fn a_condition_in_words_may_bring_in_symbols() {
    let page = |words: &str, radius: &str| {
        last_noted(&format!(
            "The stress at the wall is\n\n$$ \\tau = \\frac{{4 \\eta Q}}{{\\pi r^3}} \\tag{{1}} $$\n\n{words}\n\n\
             $$ \\frac{{Q}}{{{radius}_0^3}} = \\frac{{Q/2}}{{{radius}_1^3}} \\tag{{2}} $$\n"
        ))
        .0
    };
    let condition = "If the stress is to be the same in all of them, then by (1)";
    assert_eq!(page(condition, "r"), "undecided");
    // Which radii they are nobody says.
    assert_eq!(page("By (1)", "r"), "undecided");
    assert_eq!(page("By (1)", "s"), "undecided");
}

/// Figures are put in for all of a side that an equation speaks of as one.
#[test]
fn a_quotient_is_weighed_as_it_stands() {
    let page = |value: &str| {
        last_noted(&format!(
            "The hidden fraction is\n\n$$ \\frac{{V}}{{W}} = \\frac{{a}}{{b}} $$\n\n\
             With $a = 917\\,\\mathrm{{kg/m^3}}$ and $b = 1025\\,\\mathrm{{kg/m^3}}$ we get\n\n$$ \\frac{{V}}{{W}} = {value} $$\n"
        ))
        .0
    };
    assert_eq!(page("0.895"), "undecided");
    assert_eq!(page("0.805"), "fails");
}

/// What is so at one place says what constants are, and nothing of what varies.
#[test]
fn conditions_that_are_met_at_one_place_say_what_constants_are() {
    let page = |condition: &str, constant: &str, solution: &str| {
        verdicts(&format!(
            "Integrating gives\n\n$$ w = \\frac{{k x^2}}{{2}} + B x + C \\tag{{1}} $$\n\n{condition}\n\n$$ C = {constant} \\tag{{2}} $$\n\n\
             and so\n\n$$ w = {solution} \\tag{{3}} $$\n"
        ))
    };
    for condition in [
        "With $w = c$ at $x = 0$ we get",
        "Since $w = c$ at the wall $x = 0$, we get",
        "The boundary condition $w = c$ at $x = 0$ gives",
        "Setting $w = c$ when $x = 0$ yields",
    ] {
        let right = page(condition, "c", r"\frac{k x^2}{2} + B x + c");
        assert_eq!(right, ["given", "holds", "holds"], "{condition}");
        let wrong = page(condition, "2 c", r"\frac{k x^2}{2} + B x + 2 c");
        assert_eq!(wrong[1], "fails", "{condition}");
        // The place is left with the display.
        let wrong = page(condition, "c", r"\frac{k x^2}{2} + c");
        assert_ne!(wrong[2], "holds", "{condition}");
    }
    // What is so there says what the law is elsewhere only with what it is there.
    let of_all = |solution: &str| {
        verdicts(&format!(
            "Integrating gives\n\n$$ w = \\frac{{k x^2}}{{2}} + C \\tag{{1}} $$\n\nBecause $w = c$ when $x = 0$, we have\n\n$$ w = {solution} \\tag{{2}} $$\n"
        ))
    };
    assert_eq!(of_all(r"\frac{k x^2}{2} + c")[1], "undecided");
    assert_ne!(of_all(r"\frac{k x^2}{2} + 2 c")[1], "holds");
    let two = "With $w = 0$ at $x = 0$ and $w = 0$ at $x = L$ we get";
    let text = |constants: &str| {
        verdicts(&format!(
            "Let $L > 0$. Integrating gives\n\n$$ w = \\frac{{k x^2}}{{2}} + B x + C \\tag{{1}} $$\n\n{two}\n\n$$ {constants} \\tag{{2}} $$\n"
        ))
    };
    // Two places are none, and what follows from both together is left open.
    assert_eq!(text(r"C = 1")[1], "undecided");
    assert_eq!(text(r"B = -\frac{k L}{2}")[1], "undecided");
}

/// The solution of a law of change is not of the moment at which it begins.
#[test]
fn solutions_are_not_of_the_moment_at_which_they_begin() {
    let page = |begins: &str, solution: &str| {
        verdicts(&format!(
            "The number obeys\n\n$$ \\frac{{dN}}{{dt}} = -k N \\tag{{1}} $$\n\nwhere $k$ is constant. {begins}\n\n$$ N = {solution} \\tag{{2}} $$\n\n\
             Hence\n\n$$ \\frac{{dN}}{{dt}} = -k N_0 e^{{-k t}} \\tag{{3}} $$\n"
        ))
    };
    let begins = "With $N = N_0$ at $t = 0$ the solution is";
    assert_eq!(page(begins, r"N_0 e^{-k t}"), ["given", "holds", "holds"]);
    assert_eq!(page(begins, r"N_0 e^{k t}")[1], "fails");
    assert_ne!(page(begins, r"N_0")[1], "holds");
    // What is put in at a value that is a name is said of the next display alone, too.
    let drag = |right: &str| {
        verdicts(&format!(
            "The drag is\n\n$$ F = a v^2 \\tag{{1}} $$\n\nand the equation of motion is\n\n$$ m \\frac{{dv}}{{dt}} = m g - F \\tag{{2}} $$\n\n\
             Setting $F = m g$ at $v = u$ in (1),\n\n$$ u^2 = {right} \\tag{{3}} $$\n"
        ))
    };
    assert_eq!(drag(r"\frac{m g}{a}")[2], "holds");
    assert_eq!(drag(r"\frac{2 m g}{a}")[2], "fails");
}

#[test]
fn numbers_that_the_text_tells_are_not_overlooked() {
    let page = |words: &str, value: &str| {
        last_noted(&format!(
            "The toll is\n\n$$ L = \\frac{{g + 3 h}}{{2}} \\tag{{1}} $$\n\n{words}\n\n$$ L = {value} $$\n"
        ))
        .0
    };
    // Plainly supposed, if not in so many words.
    for words in [
        "If $g = 7$ and $h = 5$, a carrier would pay",
        "For $g = 7$ and $h = 5$ one could ask",
        "Suppose $g = 7$. The rate is $h = 5$. Hence",
    ] {
        assert_eq!(page(words, "11"), "holds", "{words}");
        assert_eq!(page(words, "12"), "fails", "{words}");
    }
    // Only told: nothing is refuted as if it were not.
    for words in [
        "Our ferry has $g = 7$ and $h = 5$. By (1) the toll is therefore",
        "The data are $g = 7$ and $h = 5$. From (1),",
        "The ferry goes at $h = 5$ in a harbour with $g = 7$. (1) tells us that",
    ] {
        assert_eq!(page(words, "11"), "undecided", "{words}");
        assert_eq!(page(words, "12"), "fails", "{words}");
    }
    assert_eq!(page("From (1) it is plain that", "11"), "fails");
}

/// What a sentence of its own says to vanish is so in the next one; so is what goes on from it at once.
#[test]
fn what_is_said_to_vanish_is_put_in() {
    let page = |words: &str, momentum: &str| {
        last_noted(&format!(
            "Momentum is conserved:\n\n$$ m v + n w = p \\tag{{1}} $$\n\n{words}\n\n$$ p = {momentum} $$\n"
        ))
        .0
    };
    for words in [
        "The target is at rest, $w = 0$. Then",
        "Consider first a target at rest, $w = 0$. Then",
        "Special case 1: $w = 0$. From (1),",
        "The target stands still ($w = 0$). From (1),",
        "The target does not move ($w = 0$). From (1),",
        "We have $w = 0$ before the collision, and (1) gives",
    ] {
        assert_eq!(page(words, "m v"), "holds", "{words}");
        assert_eq!(page(words, "2 m v"), "fails", "{words}");
    }
    for words in [
        "The target does not rest with $w = 0$. From (1),",
        "The target stands still only if $w = 0$. In general, from (1),",
    ] {
        assert_eq!(page(words, "m v"), "fails", "{words}");
    }
}

/// What is substituted "from (1)" is what (1) says, and no supposition of its own.
#[test]
fn what_is_read_off_a_display_wrongly_supposes_nothing() {
    let page = |read_off: &str, energy: &str| {
        last_noted(&format!(
            "The speed is\n\n$$ v = \\sqrt{{2 g h}} \\tag{{1}} $$\n\nand the energy\n\n$$ K = \\frac12 m v^2 . \\tag{{2}} $$\n\n\
             Using $v^2 = {read_off}$ from (1), we find\n\n$$ K = {energy} $$\n"
        ))
        .0
    };
    assert_eq!(page("2 g h", "m g h"), "holds");
    assert_eq!(page("2 g h", r"\frac12 m g h"), "fails");
    assert_eq!(page("g h", r"\frac12 m g h"), "fails");
}

/// Of a term that is given without something nobody takes the slope with that held.
#[test]
fn what_is_eliminated_is_not_held() {
    let page = |slope: &str| {
        last_noted(&format!(
            "A tin has\n\n$$ W = \\pi s^2 h , \\qquad B = 2 \\pi s^2 + 2 \\pi s h . \\tag{{1}} $$\n\n\
             Eliminating $h$ from (1) we get, for $s > 0$,\n\n$$ B = 2 \\pi s^2 + \\frac{{2 W}}{{s}} . \\tag{{2}} $$\n\n\
             Hence\n\n$$ \\frac{{dB}}{{ds}} = {slope} $$\n"
        ))
        .0
    };
    assert_eq!(page(r"4 \pi s - \frac{2 W}{s^2}"), "holds");
    assert_eq!(page(r"4 \pi s + \frac{2 W}{s^2}"), "undecided");
}

/// "where $A \neq 0$" after an equation is a condition, and "where $A = b$" says what something means.
#[test]
fn where_something_lies_is_a_condition() {
    let page = |end: &str| {
        last_noted(&format!(
            "The flow is\n\n$$ Q = A v \\tag{{1}} $$\n\nand\n\n$$ Q = B w . \\tag{{2}} $$\n\nFrom (1) and (2)\n\n$$ {end} $$\n"
        ))
        .0
    };
    for condition in [r"where } A \neq 0", r"with } A > 0", r"if } A \neq 0"] {
        let end = format!(r"v = \frac{{B}}{{A}} w \quad\text{{{condition}");
        assert_eq!(page(&end), "holds", "{condition}");
        let end = format!(r"v = \frac{{A}}{{B}} w \quad\text{{{condition}");
        assert_eq!(page(&end), "fails", "{condition}");
    }
}

/// What a page begins with and calls an identity is claimed for all values.
#[test]
fn an_identity_that_a_page_begins_with_is_checked() {
    let page = |right: &str| {
        last_noted(&format!(
            "For all $a$ and $b$ we have the identity\n\n$$ (a + b)^2 = {right} $$\n"
        ))
        .0
    };
    assert_eq!(page("a^2 + 2 a b + b^2"), "holds");
    assert_eq!(page("a^2 + b^2"), "fails");
}

/// A name that words give to a term stands for it.
#[test]
fn a_term_is_given_a_name_in_words() {
    let page = |words: &str, value: &str| {
        last_noted(&format!(
            "The potential is\n\n$$ V = \\frac{{k z}}{{z^2 + a^2}} \\tag{{1}} $$\n\n{words}\n\n$$ V = {value} $$\n"
        ))
        .0
    };
    for words in [
        "The ratio $z/a$ is called $u$. In terms of $u$, (1) becomes",
        "We abbreviate $z/a$ as $u$. Then (1) becomes",
        "We denote the ratio $z/a$ by $u$, and (1) becomes",
        "Writing $u$ for $z/a$, we get from (1)",
        "Writing $u$ for the ratio $z/a$, we get from (1)",
    ] {
        assert_eq!(page(words, r"\frac{k u}{a (1 + u^2)}"), "holds", "{words}");
        assert_eq!(page(words, r"\frac{k u}{1 + u^2}"), "fails", "{words}");
    }
}

#[test]
fn a_rounded_link_beside_one_that_is_open_is_not_refuted() {
    let page = |value: &str| {
        last_noted(&format!(
            "The way down is\n\n$$ z = \\frac{{1}}{{2}} b t^2 \\tag{{1}} $$\n\nWe found $z = 1.30\\,\\mathrm{{m}}$ and a time $t = 1.10\\,\\mathrm{{s}}$. \
             With $g = 9.81\\,\\mathrm{{m/s^2}}$ (1) yields\n\n\
             $$ b = \\frac{{2 \\cdot 1.30\\,\\mathrm{{m}}}}{{(1.10\\,\\mathrm{{s}})^2}} = {value}\\,\\mathrm{{m/s^2}} $$\n"
        ))
        .0
    };
    assert_eq!(page("2.15"), "undecided");
    assert_eq!(page("2.51"), "fails");
}

#[test]
fn of_what_an_unreadable_display_speaks_nothing_else_is_refuted() {
    let page = |before: &str, step: &str| {
        last_noted(&format!(
            "The share is\n\n$$ q = \\frac{{u}}{{w}} \\tag{{1}} $$\n\nand the mean\n\n$$ {before} \\tag{{2}} $$\n\nIn the rates, by (1), this is\n\n$$ {step} $$\n"
        ))
        .0
    };
    let unreadable = r"K = \prod_{n=0}^{\infty} n (1 - q) q^n";
    assert_eq!(page(unreadable, r"K = \frac{u}{w - u}"), "undecided");
    // It speaks of something else.
    let other = r"J = \prod_{n=0}^{\infty} n (1 - q) q^n";
    assert_eq!(page(other, r"q = \frac{w}{u}"), "fails");
}

#[test]
fn powers_to_which_no_charge_is_raised_are_those_of_eulers_number() {
    let page = |energy: &str, value: &str| {
        last_noted(&format!(
            "An electron has the charge $-e$ and the energy\n\n$$ V = {energy} \\tag{{1}} $$\n\nWith $a > 0$ a mean is\n\n\
             $$ A = \\frac{{4}}{{a^3}} \\int_0^\\infty r e^{{-2r/a}} \\, dr = {value} $$\n"
        ))
        .0
    };
    let energy = r"-\frac{e^2 C}{r}";
    assert_eq!(page(energy, r"\frac{1}{a}"), "holds");
    assert_eq!(page(energy, r"\frac{2}{a}"), "fails");
    // A temperature over a charge, or over the number?
    assert_eq!(page(r"\frac{C}{e} + e r", r"\frac{1}{a}"), "undecided");
}

/// What a sentence says of a moment or a case is over with that sentence, where the next one names something and says what it comes from.
#[test]
fn what_is_told_of_a_case_is_no_premise_of_what_is_named_later() {
    let page = |words: &str, step: &str| {
        last_noted(&format!(
            "A body moves by\n\n$$ x = v t. \\tag{{1}} $$\n\n{words} The square $q = x^2$ is, by (1),\n\n$$ {step} $$\n"
        ))
        .0
    };
    for words in [
        "At $t = 1$ the body is at $x = v$.",
        "At $t = 1$ we have $x = v$.",
        "At the end the position is $x = v$.",
        "When $t = 1$, the position is $x = v$.",
        "For $t = 1$ the position is $x = v$.",
        "(For $t = 1$ it has come to $x = v$.)",
        "If $t = 1$, then $x = v$.",
        "The position is $x = v$ at $t = 1$.",
    ] {
        assert_eq!(page(words, "q = v^2"), "undecided", "{words}");
        assert_eq!(page(words, "q = v^2 t^2"), "holds", "{words}");
    }
    // These set the scene for what comes next.
    for words in ["Suppose that $t = 1$.", "Take $t = 1$."] {
        assert_eq!(page(words, "q = v^2"), "holds", "{words}");
        assert_eq!(page(words, "q = 2 v^2"), "fails", "{words}");
    }
}

/// What is set before is meant for what is named next.
#[test]
fn what_is_set_in_a_sentence_of_its_own_is_meant_for_the_next() {
    let page = |words: &str, number: &str| {
        last_noted(&format!(
            "The speeds obey\n\n$$ m u = M w. \\tag{{1}} $$\n\n{words} The ratio $k = u/w$ is, by (1),\n\n$$ k = {number}. $$\n"
        ))
        .0
    };
    for words in [
        "Let $m = a$ and $M = 3 a$.",
        "Let $m = a$ for the first ball and $M = 3 a$ for the second.",
        "Suppose that $m = a$ and $M = 3 a$.",
        "Take $m = a$, $M = 3 a$.",
        "We consider the case $m = a$, $M = 3 a$.",
        "The masses are $m = a$ and $M = 3 a$.",
        "The balls have the masses $m = a$, $M = 3 a$.",
    ] {
        assert_eq!(page(words, "3"), "holds", "{words}");
        assert_ne!(page(words, "2"), "holds", "{words}");
    }
}

#[test]
fn what_is_displayed_of_a_moment_is_no_premise_of_what_is_named_later() {
    let page = |step: &str| {
        last_noted(&format!(
            "A body moves by\n\n$$ x = v t. \\tag{{1}} $$\n\nInitially, at $t = 0$, we have\n\n$$ x = 0. \\tag{{2}} $$\n\nThe square $q = x^2$ is, by (1),\n\n$$ {step} $$\n"
        ))
        .0
    };
    assert_eq!(page("q = 0"), "undecided");
    assert_eq!(page("q = v^2 t^2"), "holds");
}

#[test]
fn the_first_of_two_cases_is_over_with_the_second() {
    for second in [
        "Suppose next that it accelerates with $a$.",
        "Next, suppose that it accelerates with $a$.",
        "Suppose instead that it accelerates with $a$.",
    ] {
        let page = |step: &str| {
            last_noted(&format!(
                "Suppose first that the lift is at rest, $a = 0$. The floor pushes with\n\n$$ N = m g. \\tag{{1}} $$\n\n{second} Then\n\n\
                 $$ F = m (g + a). \\tag{{2}} $$\n\nThe ratio $k = F/N$ is, by (1) and (2),\n\n$$ {step} $$\n"
            ))
            .0
        };
        assert_eq!(page("k = 1"), "undecided", "{second}");
        assert_eq!(page(r"k = 1 + \frac{a}{g}"), "holds", "{second}");
    }
}

#[test]
fn what_is_said_again_otherwise_is_meant_no_more() {
    let page = |step: &str| {
        last_noted(&format!(
            "A cart has the momentum\n\n$$ p = m v. \\tag{{1}} $$\n\nIt starts from rest: $v = 0$ at $t = 0$. Later $v = a t$, and (1) becomes\n\n$$ {step} $$\n"
        ))
        .0
    };
    assert_eq!(page("p = 0"), "undecided");
    assert_eq!(page("p = m a t"), "holds");
}

#[test]
fn what_is_neglected_is_zero() {
    let page = |words: &str, mass: &str| {
        last_noted(&format!(
            "Two bodies stick together:\n\n$$ m v + M w = (m + M) u \\tag{{1}} $$\n\n{words}\n\n$$ u = \\frac{{{mass} v}}{{m + M}} $$\n"
        ))
        .0
    };
    for words in [
        "Neglecting $w$, (1) gives",
        "Neglecting $w$ we get from (1)",
        "If $w$ is negligible, (1) gives",
        "If we neglect $w$, (1) gives",
        "Ignoring $w$ in (1), we get",
        "As $w$ is negligible, (1) gives",
        "We neglect $w$. Then (1) gives",
    ] {
        assert_eq!(page(words, "m"), "holds", "{words}");
        assert_eq!(page(words, "M"), "fails", "{words}");
    }
    // What is neglected beside something else is not zero, and neither is what is not neglected.
    for words in [
        "Neglecting $w$ against $v$, (1) gives",
        "If $w$ is negligible compared with $v$, (1) gives",
        "If we do not neglect $w$, (1) gives",
    ] {
        assert_ne!(page(words, "m"), "holds", "{words}");
    }
}

/// What a clause denies is not what the next one says in other words.
#[test]
fn what_is_denied_says_what_is_so_in_other_words() {
    let page = |words: &str, mass: &str| {
        last_noted(&format!(
            "Two bodies have the momentum\n\n$$ p = m v + M w. \\tag{{1}} $$\n\n{words}\n\n$$ p = {mass} v. $$\n"
        ))
        .0
    };
    for words in [
        "The second does not move, so $w = 0$. By (1),",
        "The second does not move ($w = 0$). By (1),",
        "Since the second does not move, we have $w = 0$, and thus from (1)",
        "The second is not moving, i.e. $w = 0$. By (1),",
        "The second has no velocity, $w = 0$. By (1),",
        "Before the collision the second is at rest, $w = 0$. By (1),",
        "The second rests before the collision ($w = 0$). By (1),",
        "Often the second is at rest, so $w = 0$ and (1) becomes",
    ] {
        assert_eq!(page(words, "m"), "holds", "{words}");
        assert_eq!(page(words, "M"), "fails", "{words}");
    }
    for words in [
        "It is not so that $w = 0$. By (1),",
        "It never comes to $w = 0$. By (1),",
        "The second does not have $w = 0$. By (1),",
        "We do not assume that the second is at rest, $w = 0$. By (1),",
        "The second is not at rest ($w = 0$). By (1),",
        "The second moves, so it is not the case that $w = 0$. By (1),",
    ] {
        assert_eq!(page(words, "m"), "fails", "{words}");
    }
}

#[test]
fn a_case_that_is_looked_at_is_left_again() {
    for words in [
        "As a check, consider the limit $M = 0$: then",
        "Consider $M = 0$: then",
        "Consider first the limit $M = 0$. Then",
        "Let us look at the special case $M = 0$, which gives",
    ] {
        let page = |step: &str| {
            last_noted(&format!(
                "Two bodies have the momentum\n\n$$ p = m v + M w, \\quad m > 0. \\tag{{1}} $$\n\n{words}\n\n$$ p = m v. \\tag{{2}} $$\n\n\
                 In general, both bodies are heavy. From (1),\n\n$$ {step} $$\n"
            ))
            .0
        };
        assert_eq!(page("v = p/m"), "fails", "{words}");
        assert_eq!(page("v = (p - M w)/m"), "holds", "{words}");
    }
}

/// What cannot be so together is of two cases.
#[test]
fn a_case_ends_with_what_rules_it_out() {
    let page = |first: &str, second: &str, step: &str| {
        last_noted(&format!(
            "The quantity of interest is\n\n$$ y = x + c. \\tag{{1}} $$\n\n{first}\n\n$$ y > c. \\tag{{2}} $$\n\n{second}\n\n$$ {step} $$\n"
        ))
        .0
    };
    for (first, second) in [
        ("First, let $x > 0$. Then", "Case 2: $x < 0$. Then"),
        ("Case 1: $x > 0$. Then", "Case 2: $x < 0$. Then"),
        ("Let $x > 0$. Then", "Otherwise,"),
        ("Let $x > 0$. Then", "Now let $x = -1$. Then"),
        ("Let $x > 0$. Then", "If, on the contrary, $x < 0$, we have"),
    ] {
        assert_eq!(page(first, second, "|x| = x"), "fails", "{first} {second}");
    }
    let (first, second) = (
        "(i) $x > 0$. In this case",
        "(ii) $x \\leq 0$. In this case",
    );
    assert_ne!(page(first, second, "|x| = x"), "holds");
    // These leave room for each other.
    for (first, second) in [
        ("Let $x > 0$. Then", "Now let $c > 0$. Then"),
        ("Let $x > 0$. Then", "Now let $x = 5$. Then"),
        ("Let $x \\geq 0$ and $x \\neq 0$. Then", "Also,"),
    ] {
        assert_eq!(page(first, second, "|x| = x"), "holds", "{first} {second}");
    }
}

#[test]
fn what_is_concluded_in_one_case_is_not_so_in_the_other() {
    let page = |second: &str, sign: &str| {
        last_noted(&format!(
            "Let $y = |x|$.\n\nCase 1: $x \\geq 0$. Then\n\n$$ y = x. \\tag{{1}} $$\n\n{second}\n\n$$ y^2 = {sign} x y. $$\n"
        ))
        .0
    };
    assert_eq!(page("Case 2: $x < 0$. From (1) we get", ""), "fails");
    assert_eq!(page("Case 2: $x < 0$. Here", "-"), "holds");
}

#[test]
fn a_supposition_is_left_in_words() {
    for leaving in [
        "In the general case we obtain",
        "In general, however,",
        "Now drop this assumption. We have",
        "Without this assumption we have",
    ] {
        for supposing in ["Suppose that", "Assume that", "Let"] {
            let page = |step: &str| {
                last_noted(&format!(
                    "The sum is\n\n$$ S = a + b. \\tag{{1}} $$\n\n{supposing} $a = -b$. Then\n\n$$ S = 0. \\tag{{2}} $$\n\n{leaving}\n\n$$ {step} $$\n"
                ))
                .0
            };
            assert_eq!(
                page("(a + b)^2 = a^2 - b^2"),
                "fails",
                "{supposing} {leaving}"
            );
            assert_eq!(page("S^2 = (a + b)^2"), "holds", "{supposing} {leaving}");
        }
    }
}

/// The condition of a sentence that the next one goes on from is that of the display.
#[test]
fn a_condition_is_meant_where_the_next_sentence_goes_on() {
    let page = |words: &str, step: &str| {
        last_noted(&format!(
            "The discriminant is, with $k > 0$ and $d > 0$,\n\n$$ D = s^2 - 4 k d. \\tag{{1}} $$\n\n{words}\n\n$$ {step} $$\n"
        ))
        .0
    };
    for words in [
        "We distinguish two cases. First, if $D < 0$, there is no common point. Second, if $D = 0$, the line is a tangent. Then (1) gives",
        "The two points coincide if $D = 0$. Then",
        "If $D = 0$, the line is a tangent. In this case",
    ] {
        assert_eq!(page(words, "s^2 = 4 k d"), "holds", "{words}");
        assert_eq!(page(words, "s^2 = 2 k d"), "fails", "{words}");
    }
}

#[test]
fn a_sentence_supposes_what_it_displays() {
    for words in [
        "Now let",
        "We require that",
        "Suppose that",
        "The constraint is",
        "It is given that",
    ] {
        let page = |step: &str| {
            last_noted(&format!(
                "The flow in the first pipe is\n\n$$ q = A u, \\tag{{1}} $$\n\nthat in the second one\n\n$$ r = B v. \\tag{{2}} $$\n\n{words}\n\n\
                 $$ q = r. \\tag{{3}} $$\n\nHence\n\n$$ {step} $$\n"
            ))
            .0
        };
        assert_eq!(page("A u = B v"), "holds", "{words}");
        assert_eq!(page("A v = B u"), "fails", "{words}");
    }
}

/// A number of which nothing was known before has no value that a case could give it.
#[test]
fn a_name_for_a_factor_is_no_case() {
    let page = |step: &str| {
        last_noted(&format!(
            "The force is\n\n$$ F = \\frac{{I a}}{{R^2}}, \\quad I > 0, m > 0, R > 0, \\tag{{1}} $$\n\nWe write $I = \\beta m R^2$ with a number \
             $\\beta > 0$ that depends on the shape. The force of friction is, by (1),\n\n$$ {step} $$\n"
        ))
        .0
    };
    assert_eq!(page(r"F = \beta m a"), "holds");
    assert_eq!(page(r"F = \frac{m a}{\beta}"), "fails");
}

#[test]
fn what_does_not_vanish_is_no_wrong_citation() {
    let (verdict, notes) = last_noted(
        "The wavelength is\n\n$$ L = \\frac{c}{h}. \\tag{1} $$\n\nWith $c > 0$ one hears\n\n$$ f = \\frac{c}{c - u} h, \\tag{2} $$\n\nand the change is\n\n\
         $$ \\frac{f - h}{h} = \\frac{u}{c - u}. \\tag{3} $$\n\nAfterwards one hears\n\n$$ g = \\frac{c}{c + u} h. \\tag{4} $$\n\n\
         The ratio is, by (2) and (4),\n\n$$ \\frac{f}{g} = \\frac{c + u}{c - u}. $$\n",
    );
    assert_eq!(verdict, "holds");
    assert!(!notes.contains(&"miscited"), "{notes:?}");
}

#[test]
fn numbers_that_displays_come_to_are_not_overlooked() {
    let page = |current: &str| {
        last_noted(&format!(
            "At $U = 12$ the current is\n\n$$ I = \\frac{{U}}{{2}} = 6. \\tag{{1}} $$\n\nThe current through the first one is\n\n\
             $$ J = \\frac{{U}}{{6}} = 2, \\tag{{2}} $$\n\nhence that through the second one is\n\n$$ K = I - J = {current}. $$\n"
        ))
        .0
    };
    assert_eq!(page("4"), "undecided");
    assert_ne!(page("3"), "holds");
}

/// Two equations that cite each other: neither waits for the other for ever.
#[test]
fn what_is_cited_and_comes_later_is_not_waited_for() {
    for page in [
        "By (2)\n\n$$ c = d \\tag{1} $$\n\nby (1)\n\n$$ d = c. \\tag{2} $$\n",
        "From (2),\n\n$$ v = g t \\tag{1} $$\n\n<!-- check: law -->\n\n$$ s = v t \\tag{3} $$\n\nBy (1) and (3),\n\n$$ s = g t^2. \\tag{2} $$\n",
    ] {
        let audit = Audit::of(&Derivation::new(vec![Document::markdown("a.md", page)]));
        let first = &audit.entries[0];
        assert!(first.notes.iter().any(|note| note.code() == "cites-later"));
    }
}

/// What is divided by is found beside `\pi`, too.
#[test]
fn what_must_not_vanish_is_found_beside_pi() {
    let page = |speed: &str| {
        last_noted(&format!(
            "The weight is\n\n$$ G = \\frac{{4}}{{3}} \\pi R^3 \\rho g, \\tag{{1}} $$\n\nthe buoyancy is\n\n$$ B = \\frac{{4}}{{3}} \\pi R^3 \\sigma g. \\tag{{2}} $$\n\n\
             At the terminal speed\n\n$$ G = B + 6 \\pi \\eta R u. \\tag{{3}} $$\n\nSubstituting (1) and (2) into (3) we find\n\n$$ u = {speed}. $$\n"
        ))
    };
    let (verdict, notes) = page(r"\frac{2 R^2 g (\rho - \sigma)}{9 \eta}");
    assert_eq!(
        (verdict, &notes[..]),
        ("holds", &["unstated-condition"][..])
    );
    assert_eq!(page(r"\frac{4 R^2 g (\rho - \sigma)}{9 \eta}").0, "fails");
}

/// What is said of an element, or put in where a slope is taken, may be meant throughout: that is left open and not refuted.
#[test]
fn what_may_be_meant_throughout_is_not_refuted_at_a_point() {
    let chain = |step: &str| {
        last_noted(&format!(
            "With $y = x^2$ the chain rule gives\n\n$$ \\frac{{dy}}{{dt}} = 2 x \\frac{{dx}}{{dt}}. \\tag{{1}} $$\n\nWith $x = t^3$ it becomes\n\n$$ {step} $$\n"
        ))
        .0
    };
    assert_ne!(chain(r"\frac{dy}{dt} = 6 t^5"), "fails");
    assert_ne!(chain(r"\frac{dy}{dt} = 5 t^5"), "holds");
    let (verdict, _) = last_noted(
        "The total mass is\n\n$$ M = m_1 + m_2 + m_3. \\tag{1} $$\n\nIf all are equal, $m_i = m$, then\n\n$$ M = 3 m. $$\n",
    );
    assert_ne!(verdict, "fails");
}

/// In the special value that words name, one quantity of several that the text knows may be meant.
#[test]
fn a_special_value_may_be_of_what_stands_farther_back() {
    let page = |radius: &str| {
        last_noted(&format!(
            "The electron obeys\n\n$$ m v r = n h, \\tag{{1}} $$\n\n$$ m v^2 r = k. \\tag{{2}} $$\n\nBy (1) and (2) the radius is\n\n$$ r = \\frac{{n^2 h^2}}{{m k}}. \\tag{{3}} $$\n\n\
             The energy is\n\n$$ E = - \\frac{{m k^2}}{{2 n^2 h^2}}. \\tag{{4}} $$\n\nIn the ground state, $n = 1$, the radius is\n\n$$ a_0 = {radius}. $$\n"
        ))
        .0
    };
    assert_ne!(page(r"\frac{h^2}{m k}"), "fails");
    assert_ne!(page(r"\frac{2 h^2}{m k}"), "holds");
}

#[test]
fn what_is_said_under_circumstances_may_be_meant_under_others() {
    let page = |step: &str| {
        last_noted(&format!(
            "Under random mating the genotypes have the frequencies\n\n$$ P = p^2, \\qquad H = 2 p q, \\tag{{1}} $$\n\nwhere\n\n$$ p + q = 1. \\tag{{2}} $$\n\n\
             In the next generation the frequency is\n\n$$ u = P + \\frac{{1}}{{2}} H = {step}. $$\n"
        ))
        .0
    };
    assert_ne!(page("p"), "fails");
    assert_ne!(page("q"), "holds");
}

#[test]
fn what_is_so_by_symmetry_is_not_refuted() {
    let page = |words: &str, other: &str| {
        last_noted(&format!(
            "The best response of the first firm is, with $b > 0$,\n\n$$ q_1 = \\frac{{a - c - b q_2}}{{2 b}}. \\tag{{1}} $$\n\n{words} the best response of the second firm is\n\n$$ q_2 = {other}. $$\n"
        ))
        .0
    };
    for words in ["By symmetry", "Similarly,", "In the same way"] {
        assert_eq!(
            page(words, r"\frac{a - c - b q_1}{2 b}"),
            "undecided",
            "{words}"
        );
        assert_eq!(
            page(words, r"\frac{a - c - b q_1}{3 b}"),
            "fails",
            "{words}"
        );
    }
    assert_eq!(page("Hence", r"\frac{a - c - b q_1}{2 b}"), "fails");
}

/// What is told of a variable is not so where that grows without bound.
#[test]
fn what_is_told_of_a_variable_is_left_where_it_grows() {
    let page = |value: &str| {
        last_noted(&format!(
            "The loss is, with $C_1 > 0$ and $C_2 > 0$,\n\n$$ W = \\frac{{C_1 C_2}}{{C_1 + C_2}} U^2. \\tag{{1}} $$\n\nFor equal capacitors, $C_1 = C_2$, this is\n\n\
             $$ W = \\frac{{1}}{{2}} C_1 U^2. \\tag{{2}} $$\n\nIf the second capacitor is very large, all is lost, for\n\n\
             $$ \\lim_{{C_2 \\to \\infty}} \\frac{{C_1 C_2}}{{C_1 + C_2}} U^2 = {value} U^2. $$\n"
        ))
        .0
    };
    assert_eq!(page("C_1"), "holds");
    assert_ne!(page("C_2"), "holds");
}

/// A name for a term may be given in many words; what is only put in the place of something is not understood.
#[test]
fn names_for_terms_are_given_in_many_words() {
    let page = |words: &str, formula: &str| {
        crate::common::last(&format!(
            "We consider\n\n$$ y = \\frac{{a}}{{b}} + c. \\tag{{1}} $$\n\n{words}\n\n$$ y = {formula}. \\tag{{2}} $$\n"
        ))
    };
    for words in [
        "Let $k$ denote $a/b$. Then",
        "Let $k$ denote the ratio $a/b$. Then",
        "Let $k$ be the ratio $a/b$. Then",
        "Let $k$ stand for $a/b$. We get",
        "We call $a/b$ the gain $k$. Then",
        "Denoting the ratio $a/b$ by $k$ we find",
        "Replacing $a/b$ by $k$ gives",
        "Let $k \\equiv a/b$. Then",
        "With $k \\equiv a/b$",
    ] {
        assert_eq!(page(words, "k + c"), "holds", "{words}");
        assert_eq!(page(words, "2 k + c"), "fails", "{words}");
    }
    for words in [
        "Replacing $a$ by $2 a$ gives",
        "Exchanging $a$ and $b$ gives",
    ] {
        assert_eq!(page(words, "\\frac{2 a}{b} + c"), "undecided", "{words}");
    }
    // What it is a part of is not what it is.
    for words in [
        "Let $k$ be a root of $a/b$. Then",
        "Let $k$ not be $a/b$. Then",
    ] {
        assert_ne!(page(words, "k + c"), "holds", "{words}");
    }
}
