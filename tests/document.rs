//! Markdown documents, read end to end.

mod numbers;
mod outline;

use cradle_verify::document::{
    Attribute, Directive, Document, Extent, Item, NotUtf8, Premise, Prose, Span, SuppositionKind,
    Vanishing, decode, read_bytes,
};
use proptest::prelude::*;

fn read(source: &str) -> Document {
    Document::markdown("page.md", source)
}

/// The bodies of the displays.
fn displays(document: &Document) -> Vec<&str> {
    let body = |item: &Item| match item {
        Item::Display { body, .. } => Some(*body),
        _ => None,
    };
    let bodies = document.items.iter().filter_map(body);
    bodies.map(|body| document.text(body)).collect()
}

/// The problems: the guilty text and the message.
fn problems(document: &Document) -> Vec<(&str, &str)> {
    let problems = document.problems.iter();
    problems
        .map(|problem| (document.text(problem.span), &*problem.message))
        .collect()
}

fn headings(document: &Document) -> Vec<(u8, &str)> {
    let headings = document.items.iter();
    headings
        .filter_map(|item| match item {
            Item::Heading { level, title, .. } => Some((*level, title.as_str())),
            _ => None,
        })
        .collect()
}

fn prose<'d>(document: &'d Document) -> Vec<&'d Prose> {
    let prose = |item: &'d Item| match item {
        Item::Prose(prose) => Some(&**prose),
        _ => None,
    };
    document.items.iter().filter_map(prose).collect()
}

/// The tags that a page cites, with `!` if they must exist.
fn cited(source: &str) -> String {
    let document = read(source);
    let citations = prose(&document)
        .into_iter()
        .flat_map(|prose| &prose.citations);
    let shown = citations.map(|citation| {
        let mark = if citation.explicit { "!" } else { "" };
        format!("{}{mark}", citation.tag)
    });
    shown.collect::<Vec<_>>().join(" ")
}

/// What a page supposes.
fn supposed(source: &str) -> Vec<(SuppositionKind, String)> {
    let document = read(source);
    let suppositions = prose(&document)
        .into_iter()
        .flat_map(|prose| &prose.suppositions);
    suppositions
        .map(|supposition| (supposition.kind, document.text(supposition.body).to_owned()))
        .collect()
}

fn directives(document: &Document) -> Vec<&Directive> {
    let mut found = Vec::new();
    for item in &document.items {
        if let Item::Directives { clauses, .. } = item {
            found.extend(clauses.iter().map(|clause| &clause.value));
        }
    }
    found
}

#[test]
fn a_page_is_read_in_order() {
    let page = "# One ball\n\nBy equation (2):\n\n<!-- check: from (2) -->\n$$\na = b \\tag{3}\n$$\n\nDone.\n";
    let document = read(page);
    let [
        Item::Heading {
            level: 1,
            title,
            cases: _,
            span,
        },
        Item::Prose(prose),
        Item::Directives {
            clauses,
            span: comment,
        },
        Item::Display {
            body, span: fenced, ..
        },
        Item::Prose(last),
    ] = &document.items[..]
    else {
        panic!("{:#?}", document.items);
    };
    assert_eq!(
        (title.as_str(), document.text(*span)),
        ("One ball", "# One ball")
    );
    assert_eq!(document.text(prose.span), "By equation (2):");
    assert_eq!(document.text(prose.citations[0].span), "(2)");
    assert_eq!(document.text(clauses[0].span), "from (2)");
    assert_eq!(document.text(*comment), "<!-- check: from (2) -->");
    assert_eq!(document.text(*body), "a = b \\tag{3}");
    assert_eq!(document.text(*fenced), "$$\na = b \\tag{3}\n$$");
    assert_eq!(document.text(last.span), "Done.");
    assert_eq!(document.position(body.start).line, 7);
    assert!(document.problems.is_empty());
}

#[test]
fn displays_that_markdown_readers_lose() {
    for (page, body) in [
        ("text $$ x_1 \\tag{2} $$ text", "x_1 \\tag{2}"),
        ("$$\na\n\n= *b*\n$$", "a\n\n= *b*"),
        ("$$\na\n=\nb\n$$", "a\n=\nb"),
        ("text\n$$\n# a\n- b\n$$\n", "# a\n- b"),
        ("$$ a ` b $$ and ` c", "a ` b"),
        ("$$ a <!-- b $$ and -->", "a <!-- b"),
        ("\\[ a \\\\[2pt] b \\]", "a \\\\[2pt] b"),
        ("```math\na = b\n```", "a = b"),
        ("- item\n\n  ```math\n  a\n  = b\n  ```\n", "a\n  = b"),
        ("> $$ a = b $$", "a = b"),
        ("$$ a \\$$$", "a \\$"),
        ("<!-- note --> $$ a $$", "a"),
        ("$$\r\na\r\n$$\r\n", "a"),
        ("cost $5 and $6, $$x$$", "x"),
        ("$$\n\n    a\n$$", "a"),
    ] {
        let document = read(page);
        assert_eq!(
            displays(&document),
            [body],
            "{page}: {:?}",
            document.problems
        );
        assert_eq!(problems(&document), [], "{page}");
        assert_eq!(headings(&document), [], "{page}");
    }
}

#[test]
fn what_is_in_code_or_comments_is_no_equation() {
    for page in [
        "`$$ x $$`",
        "```\n$$ x $$\n```",
        "~~~tex\n$$ x\n~~~",
        "text\n\n    $$ x $$\n",
        "<!-- $$ x $$ -->",
        "text <!-- $$ --> text",
        "---\ntitle: $$ x $$\n---\n",
        "\\$\\$ and \\$$5",
        "<pre>\n$$ x $$\n</pre>",
        "# The `$$` fence",
    ] {
        let document = read(page);
        assert!(displays(&document).is_empty(), "{page}");
        assert_eq!(problems(&document), [], "{page}");
    }
}

#[test]
fn structure_after_mathematics_that_looks_like_code_is_still_read() {
    let page = "$$ a <b\n`c $$\n\n`$$`\n\n# After\n\n```\n$$\n```\n\n$$ d $$";
    let document = read(page);
    assert_eq!(displays(&document), ["a <b\n`c", "d"]);
    assert_eq!(headings(&document), [(1, "After")]);
    assert_eq!(problems(&document), []);
}

#[test]
fn what_is_not_read_is_named() {
    for (page, guilty) in [
        ("text $$ a = b", "$$"),
        ("\\[ a = b", "\\["),
        ("\\begin{align*} a \\end{align}", "\\begin{align*}"),
        ("```math\na", "```"),
        ("> $$\n> a\n> $$", "$$\n> a\n> $$"),
        ("# Title $$x$$", "$$x$$"),
        ("Title $$x$$\n===", "$$x$$"),
        ("<div>\n$$ x\n</div>", "$$"),
        ("$$ $$", "$$ $$"),
        ("<!-- check: given", "<!--"),
    ] {
        let document = read(page);
        let found = problems(&document);
        assert_eq!(
            found.iter().map(|(text, _)| *text).collect::<Vec<_>>(),
            [guilty],
            "{page}"
        );
    }
}

#[test]
fn a_lost_fence_is_blamed_where_it_is_and_the_rest_is_read() {
    let document = read("$$ a $$\n\n$$ b\n\ntext\n\n$$ c $$\n\nand\n\n$$ d $$\n");
    assert_eq!(displays(&document), ["a", "c", "d"]);
    assert_eq!(document.problems.len(), 1);
    assert_eq!(document.position(document.problems[0].span.start).line, 3);
}

#[test]
fn citations() {
    for (text, tags) in [
        ("Simplifying equation (2):", "2!"),
        ("Substituting equations (13) and (17):", "13! 17!"),
        ("By eq. (4) and Eqs. (2)–(5)", "4! 2! 3! 4! 5!"),
        (
            "Eqs. (2)-(4); Eqs. (6) to (8); Eqs. (2–3)",
            "2! 3! 4! 6! 7! 8! 2! 3!",
        ),
        ("from (42), (43)", "42 43"),
        ("equations 17 and 18", "17! 18!"),
        ("From equations 17 and 18, 2 balls leave", "17! 18!"),
        ("\\eqref{a:b} or \\ref{c}, \\ref{fig:x}", "a:b! c!"),
        ("(A.3) and (2') of 1985 (1985)", "A.3 2' 1985"),
        ("**Equation~(3)** and Eq.(4)", "3! 4!"),
        ("by equation (2), (elastic) collisions", "2! elastic"),
        (
            "claim energy, f(2), $g(3)$, `(4)`, [x](5), [y](a_(6)), (2, 3)",
            "",
        ),
        ("# By (2)\n", ""),
        ("in relation (3), relation 4", "3!"),
        ("[1, 4] and (see there)", ""),
    ] {
        assert_eq!(cited(text), tags, "{text}");
    }
}

#[test]
fn suppositions() {
    use SuppositionKind::{
        Alternative, Arbitrary, Assume, Contrary, Define, Elsewhere, Fact, General, Known, Let,
        Unread, Vanishes,
    };
    let told = Fact {
        runs_on: false,
        of_case: false,
    };
    let telling = Fact {
        runs_on: true,
        of_case: false,
    };
    let of_case = Fact {
        runs_on: true,
        of_case: true,
    };
    let ended = SuppositionKind::case(false);
    let open = SuppositionKind::case(true);
    for (text, expected) in [
        (
            "Let $v_1 = v_2 = 0$ and $v_4 = v_0/2$.",
            vec![(Let, "v_1 = v_2 = 0"), (Let, "v_4 = v_0/2")],
        ),
        (
            "Initial momentum: $2v_0$. Let $v_1 = 0$. So $b = 2$.",
            vec![(Let, "v_1 = 0")],
        ),
        (
            "Rearrange (taking non-trivial solution $v'_2 \\neq 0$):",
            vec![(Assume, "v'_2 \\neq 0")],
        ),
        (
            "taking the non-trivial solution $v'_2 \\neq 0$",
            vec![(Assume, "v'_2 \\neq 0")],
        ),
        ("At $\\mu = 1$, $\\eta = 1$:", vec![(open, "\\mu = 1")]),
        (
            "Assuming $m > 0$, the energy is $E = 2$.",
            vec![(Assume, "m > 0")],
        ),
        (
            "It holds provided that \\(m \\geq 1\\).",
            vec![(Assume, "m \\geq 1")],
        ),
        (
            "- Suppose $a < b$ and $`c = d`$",
            vec![(Assume, "a < b"), (Assume, "c = d")],
        ),
        ("Let $a = 1$, then $b = 2$.", vec![(Let, "a = 1")]),
        ("Let $a = 1$. The rest has $b = 2$.", vec![(Let, "a = 1")]),
        ("Let us show that $a = b$.", vec![]),
        ("Let $\\sum_{i=1}^k u_i$ be given.", vec![]),
        (
            "Assume $a = 0$ or $b = 0$.",
            vec![(Alternative, "a = 0"), (Alternative, "b = 0")],
        ),
        (
            "Suppose for contradiction that $a = 0$.",
            vec![(Contrary, "a = 0")],
        ),
        ("We do not assume $a = 0$.", vec![]),
        (
            "Since $\\mu = m_2/m_1$, it vanishes at $\\mu = 1$.",
            vec![(told, "\\mu = m_2/m_1")],
        ),
        ("it costs $5 and $6", vec![]),
        (
            "Setting $Q = 0$ in (1) gives $a = b$:",
            vec![(open, "Q = 0")],
        ),
        ("For $N = 3$, the rest is zero.", vec![(ended, "N = 3")]),
        ("When $v = 0$, (1) becomes $a = b$.", vec![(ended, "v = 0")]),
        ("At $Q=0$, when it is empty,", vec![(open, "Q=0")]),
        ("For $N = 3$ the values are $a = b$.", vec![]),
        ("For $u = c$ this gives", vec![(open, "u = c")]),
        ("For $u = c$ (1) gives", vec![(open, "u = c")]),
        ("which is zero at $s = 2 f$, where", vec![(open, "s = 2 f")]),
        ("It is zero at $s = 2 f$, where it turns.", vec![]),
        (
            "For a narrow pipe, $h = k$, (1) becomes",
            vec![(of_case, "h = k")],
        ),
        (
            "For a tank, $p = q$ and $v = 0$ in (1) give",
            vec![(of_case, "p = q"), (of_case, "v = 0")],
        ),
        (
            "The magnification $M = -s/f$ is",
            vec![(telling, "M = -s/f")],
        ),
        ("The start $t = 0$ is the time of release.", vec![]),
        ("For $x > 0$, it grows. For $x < 0$, it falls.", vec![]),
        ("It vanishes when $v = 0$, as it must.", vec![]),
        ("With $g = 10$, the weight is", vec![(open, "g = 10")]),
        (
            "With $a = 1$ and $b = 2$ we have $c = 3$.",
            vec![(ended, "a = 1"), (ended, "b = 2")],
        ),
        ("With $g = 10$ this would be wrong.", vec![]),
        ("With $g = 10$ it is not zero.", vec![]),
        ("Is (1) true with $v = 0$? Can it be?", vec![]),
        ("With $v = 0$, is (1) true?", vec![]),
        ("For $N = 3$, for example, it is zero.", vec![]),
        (
            "where $k = m \\omega^2$ is the stiffness and $M = 2 m$.",
            vec![(Define, "k = m \\omega^2"), (Define, "M = 2 m")],
        ),
        (
            ", with $k = q$ as before, hence $b = c$.",
            vec![(Define, "k = q")],
        ),
        ("where $k = 2$ is not constant", vec![]),
        (
            "With $a = 2$, $b = 3$ and $c = 4$ we get",
            vec![(open, "a = 2"), (open, "b = 3"), (open, "c = 4")],
        ),
        ("For $t = 0$, $s = 0$ and $v = 0$.", vec![(ended, "t = 0")]),
        ("We set $a = 2 c$ and find", vec![(Let, "a = 2 c")]),
        ("By (1) with $a = b$", vec![(open, "a = b")]),
        ("Putting $a = b$ into (1) gives", vec![(open, "a = b")]),
        ("In general, by (1),", vec![(General, "general")]),
        (
            "At $t = 0$ it rests; later, by (1),",
            vec![(ended, "t = 0")],
        ),
        ("Let $t = 0$ be the moment of release.", vec![]),
        ("Suppose the motion starts at $t = 0$.", vec![]),
        ("Taking $x = 0$ is not allowed.", vec![]),
        ("Suppose that neither $x = 0$ nor $z = 1$.", vec![]),
        ("Let's not assume $x = 0$.", vec![]),
        (
            "The period is $T = 2 \\pi r/v$, so",
            vec![(telling, "T = 2 \\pi r/v")],
        ),
        (
            "Since they collide, $u \\neq v$.",
            vec![(told, "u \\neq v")],
        ),
        ("Hence, since $a = 2 c$,", vec![(telling, "a = 2 c")]),
        ("We get $a = 2 c$.", vec![]),
        ("Whether $a = 2 c$ is open.", vec![]),
        ("We no longer suppose $x = 0$.", vec![]),
        ("For $x = 0$, (1) is trivial.", vec![]),
        ("This is so where $k = 2$.", vec![]),
        ("Then, with $k = 2$, it is so.", vec![(told, "k = 2")]),
        ("It is known that $v = 3$. So", vec![(Known, "v = 3")]),
        (
            "The masses were measured to be $m = 2$ and $M = 3$.",
            vec![(Known, "m = 2"), (Known, "M = 3")],
        ),
        ("Suppose we know that $v = 3$.", vec![(Known, "v = 3")]),
        ("It is not known that $v = 3$.", vec![]),
        ("If we know that $v = 3$,", vec![]),
        ("In contrast to the case $a = 0$, it is", vec![]),
        ("Unlike in the case $a = 0$, it is", vec![]),
        ("In the case $a = 0$, it is", vec![(open, "a = 0")]),
        (
            "Returning to the general case, by (1)",
            vec![(General, "general")],
        ),
        ("Without this assumption,", vec![(General, "assumption")]),
        ("In between, by (1)", vec![(Elsewhere, "between")]),
        (
            "For arbitrary $w$ we have",
            vec![(Elsewhere, "arbitrary"), (Arbitrary, "w")],
        ),
        (
            "Setting the derivative to zero gives",
            vec![(Vanishes(Vanishing::Slope), "derivative")],
        ),
        (
            "If we set $F - k x$ equal to zero, we find",
            vec![(Vanishes(Vanishing::Term), "F - k x")],
        ),
        (
            "Putting this to zero,",
            vec![(Vanishes(Vanishing::Display), "this")],
        ),
        ("The slope never vanishes:", vec![]),
        (
            "If the slope vanishes,",
            vec![(Unread, "If the slope vanishes")],
        ),
        (
            "where the second derivative is zero",
            vec![(Unread, "where the second derivative is zero")],
        ),
        (
            ", which vanishes at $x = 0$. Hence",
            vec![(Vanishes(Vanishing::Told), "which"), (of_case, "x = 0")],
        ),
    ] {
        let found = supposed(text);
        // What a new symbol would mean, if it is new, is looked at below.
        let found: Vec<_> = found
            .iter()
            .filter(|(kind, _)| *kind != SuppositionKind::Meaning)
            .map(|(kind, body)| (*kind, body.as_str()))
            .collect();
        assert_eq!(found, expected, "{text}");
    }
}

#[test]
fn what_a_new_symbol_may_mean() {
    use SuppositionKind::{Contradicted, Fact, Let, Meaning};
    let kinds = |text: &str| -> Vec<SuppositionKind> {
        let found = supposed(text);
        let kinds = found.iter().map(|(kind, _)| *kind);
        // That supposes nothing.
        kinds.filter(|kind| *kind != Contradicted).collect()
    };
    for text in [
        "Hence, writing $r = p^2/m$,",
        "so in terms of $r = p^2/m$,",
        "Thus, introducing the ratio $r = p^2/m$,",
    ] {
        assert_eq!(kinds(text), [Meaning], "{text}");
    }
    assert_eq!(kinds("Let $\\mu = a b$ be the reduced mass."), [Let]);
    assert_eq!(kinds("Let $r = 2 a$ denote the radius."), [Let]);
    let of_moment = |of_case| Fact {
        runs_on: false,
        of_case,
    };
    assert_eq!(kinds("The height is $h = L/2$."), [of_moment(false)]);
    for text in [
        "The ball starts from the height $h = L/2$.",
        "Initially the height is $h = L/2$.",
        "At the top the height is $h = L/2$.",
        "The maximum height is $h = L/2$.",
    ] {
        assert_eq!(kinds(text), [of_moment(true)], "{text}");
    }
    // Denied, somebody else's, still to be shown, near the truth, said of something else, or taken back.
    for text in [
        "The power isn't $P = m v^2$. Hence",
        "Nobody believes that the power is $P = m v^2$. Hence",
        "It is a myth that the power is $P = m v^2$. Hence",
        "The range differs from $R = v^2/g$. Thus",
        "They rejected $R = v^2/g$. Thus",
        "The momentum is $p = m v^3$. This is wrong. So",
        "The momentum is $p = m v^3$. It fails. So",
        "Leibniz called $E = m v^2$ the living force. Today",
        "Students often write $E = m v^2$.",
        "A naive estimate is $D = k v$.",
        "A first approximation is $y = A x$.",
        "**Theorem.** The area is $a = b^2$.",
        "We claim that the energy is $E = m v^2$. Indeed",
        "Show that the energy is $E = m v^2$. Hence",
        "The aim is $E = m v^2$. Hence",
        "Perhaps the energy is $E = m v^2$. Hence",
        "For points off the line $y = 2 x$ we find",
        "With a curve other than $y = x^3$ we find",
        "Suppose the point lies above the line $y = 2 x$. Then",
        "Suppose $a = b + c$. This is absurd. So",
    ] {
        assert_eq!(kinds(text), [], "{text}");
    }
    // What goes on takes nothing back.
    for text in [
        "The speed is $v = s/t$. In this case",
        "The speed is $v = s/t$. It does not depend on the mass. Hence",
        "The speed is $v = s/t$. This is only the case when",
    ] {
        assert_eq!(kinds(text), [of_moment(false)], "{text}");
    }
    assert_eq!(
        kinds("Let $a = 2 b$. In this case only one root is left. Hence"),
        [Let]
    );
    // Where something is positive is said of it whatever else is.
    assert_eq!(
        kinds("A stone of mass $m > 0$ is dropped from above."),
        [of_moment(false)]
    );
}

/// What prose says of symbols by adjectives: `g: Constant`.
fn said(source: &str) -> String {
    let document = read(source);
    let told = prose(&document).into_iter().flat_map(|own| &own.qualities);
    let shown = told.map(|own| {
        let attributes: Vec<&str> = own.attributes.iter().map(named_attribute).collect();
        format!("{} {}", document.text(own.body), attributes.join(" "))
    });
    shown.collect::<Vec<_>>().join("; ")
}

fn named_attribute(attribute: &Attribute) -> &'static str {
    match attribute {
        Attribute::Constant => "constant",
        Attribute::Positive => "positive",
        Attribute::Integer => "integer",
        Attribute::Interval { lower: None, .. } => "negative",
        _ => "other",
    }
}

#[test]
fn what_adjectives_say() {
    let mut wrong = Vec::new();
    for (text, expected) in [
        ("where $g$ is constant.", "g constant"),
        ("where $A$ and $B$ are constants,", "A constant; B constant"),
        (
            "with $a$, $b$ and $c$ constant.",
            "a constant; b constant; c constant",
        ),
        ("with $k$ a constant", "k constant"),
        ("where $k$ is the spring constant", "k constant"),
        ("Since $g$ is constant, we get", "g constant"),
        ("Hence, since $g$ is constant,", "g constant"),
        ("Assuming $g$ constant, we get", "g constant"),
        ("The acceleration $a$ stays constant.", "a constant"),
        ("Let a constant force $F$ act on it.", "F constant"),
        ("It moves with constant acceleration $a$.", "a constant"),
        ("for some constants $A$ and $B$.", "A constant; B constant"),
        ("with a constant of integration $C$.", "C constant"),
        ("with the rate constant $k$, $[A] = A_0$.", "k constant"),
        ("where $a, b$ are constants.", "a, b constant"),
        ("where $a$ and $b$ are positive.", "a positive; b positive"),
        ("where $n$ is a positive integer.", "n positive integer"),
        ("where $k$ is a positive constant.", "k positive constant"),
        ("with positive $a$, we have", "a positive"),
        (
            "The masses $m$ and $M$ are positive.",
            "m positive; M positive",
        ),
        ("where $x$ is negative, and", "x negative"),
        // What is concluded or a condition.
        ("so $q$ is constant and therefore", ""),
        ("Hence $L$ is constant.", ""),
        ("This shows that $L$ is constant.", ""),
        ("If $v$ is constant, then", ""),
        ("When the force $F$ is constant,", ""),
        ("Is $v$ constant? Is $v$ a constant?", ""),
        ("must be a constant $C$.", ""),
        ("For positive $x$, it grows.", ""),
        // Denials, and what is constant in a way or for a while.
        ("where $g$ is not constant.", ""),
        ("with non-constant acceleration $a$.", ""),
        ("where $g$ is nearly constant.", ""),
        ("where $a$ is hardly constant.", ""),
        ("where $a$ is initially constant.", ""),
        ("with constant acceleration $a$ at first.", ""),
        ("where $E$ is constant along the path", ""),
        ("where $v$ is constant in space", ""),
        ("where $v$ is constant (in space).", ""),
        ("where $v$ is constant, in space.", ""),
        ("where $F$ is constant for $x < 0$", ""),
        ("where $a$ is constant with height.", ""),
        ("where $a$ is constant, but only in the mean.", ""),
        ("where $a$ is constant. This is false.", ""),
        ("where $a$ is constant. In time it grows.", ""),
        ("With $T$ held constant, $p$", ""),
        ("At constant $T$ the gas", ""),
        ("At constant temperature $T$ the gas", ""),
        ("In the first phase, with constant acceleration $a$, it", ""),
        // What is said of something else.
        ("The rate of change of $x$ is constant.", ""),
        ("The ratio of $a$ to $b$ is constant.", ""),
        ("where $v$ is proportional to a constant", ""),
        ("where $y$ is a constant times $x$", ""),
        ("where $y$ is a constant fraction of $v$.", ""),
        ("with constant mean $a$.", ""),
        ("with constant $k$ and $a$ growing.", ""),
        ("with constant $k$ and $a$ as a function of time.", ""),
        ("a constant, and $x$ is not", ""),
        ("With $x$ the place, a constant is", ""),
        // Other cases, and what others say.
        (
            "In contrast to the case with constant acceleration $a$,",
            "",
        ),
        (
            "This differs from motion with constant acceleration $a$.",
            "",
        ),
        ("without constant acceleration $a$.", ""),
        ("Another body moves with constant acceleration $a$.", ""),
        ("Euler thought that $a$ is constant.", ""),
        ("In the case of constant $a$ this is easy.", ""),
        ("Compare this with constant voltage $U$.", ""),
        // What changes after all.
        ("The spring constant $k$, which depends on time, is", ""),
        ("The constant $a$ varies.", ""),
        (
            "Variation of constants: the constant $a$ becomes a function.",
            "",
        ),
        (
            "We begin with constant voltage $U$ and then let it vary.",
            "",
        ),
        ("with the slowly varying spring constant $k$.", ""),
    ] {
        if said(text) != expected {
            wrong.push((text, said(text)));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn what_is_said_to_change() {
    let changing = |text: &str| {
        let document = read(text);
        let own = prose(&document).into_iter().flat_map(|own| &own.changing);
        let bodies: Vec<&str> = own.map(|&body| document.text(body)).collect();
        bodies.join(" ")
    };
    assert_eq!(changing("For a rocket, $m$ is not constant."), "m");
    assert_eq!(
        changing("where $p$, $V$ and $T$ change with time."),
        "p V T"
    );
    assert_eq!(
        changing("The spring heats up, and $k$ depends on $t$."),
        "k t"
    );
    assert_eq!(changing("where $k$ does not depend on $x$."), "");
    assert_eq!(changing("where $k$ is constant."), "");
}

#[test]
fn of_how_much_a_display_is_said() {
    use Extent::{AsBefore, Circumstances, Condition, Moment, Throughout};
    for (text, expected) in [
        ("At the top of its flight", Some(Moment)),
        ("**Initially** the charge is", Some(Moment)),
        ("It rises. When it comes to rest,", Some(Moment)),
        ("At $t = 0$", Some(Moment)),
        ("Just after the switch is closed,", Some(Moment)),
        ("After a long time", Some(Moment)),
        ("At all times", Some(Throughout)),
        ("At the same time", Some(Throughout)),
        ("At constant temperature", Some(Circumstances)),
        ("At low speed", Some(Circumstances)),
        ("After the collision", Some(Circumstances)),
        ("For a symmetric arrangement", Some(Circumstances)),
        ("In other words,", Some(Throughout)),
        ("At the maximum", Some(Condition)),
        ("The minimum is where", Some(Condition)),
        ("The condition for this is", Some(Condition)),
        ("The period is constant, where", Some(Throughout)),
        ("where", Some(Throughout)),
        ("At the top it rests for a while.", Some(Throughout)),
        ("The law says:", Some(Throughout)),
        ("and", Some(AsBefore)),
        ("<!-- nothing -->", None),
    ] {
        let document = read(&format!("{text}\n\n$$ a = b $$"));
        let found = prose(&document).last().and_then(|prose| prose.extent);
        assert_eq!(found, expected, "{text}");
    }
}

#[test]
fn directives_of_every_kind() {
    let page = "<!--check: derived, claim energy-1; from (2)–(3), (7) and claim a.b\n  assuming v > 0,\n m \\neq 0\n let a = \\frac{1}{2}\\;b -->";
    let document = read(page);
    assert_eq!(problems(&document), []);
    let found = directives(&document);
    let [
        Directive::Derived,
        Directive::Claim(name),
        Directive::From(premises),
        Directive::Assuming(hypotheses),
        Directive::Let(values),
    ] = &found[..]
    else {
        panic!("{found:#?}");
    };
    assert_eq!(name.value, "energy-1");
    let tag = |tag: &str| Premise::Tag(tag.to_owned());
    let named: Vec<_> = premises
        .iter()
        .map(|premise| premise.value.clone())
        .collect();
    assert_eq!(
        named,
        [
            tag("2"),
            tag("3"),
            tag("7"),
            Premise::Claim("a.b".to_owned())
        ]
    );
    assert_eq!(document.text(*hypotheses), "v > 0,\n m \\neq 0");
    assert_eq!(document.text(*values), "a = \\frac{1}{2}\\;b");
}

#[test]
fn declarations() {
    let document =
        read("<!-- check: symbols m_1, x_{a,b}: M L^{-1/2} T^{-2}, natural, in (0, 1/2], ≥ 1 -->");
    assert_eq!(problems(&document), []);
    let [Directive::Symbols { names, attributes }] = directives(&document)[..] else {
        panic!();
    };
    assert_eq!(
        names
            .iter()
            .map(|name| document.text(*name))
            .collect::<Vec<_>>(),
        ["m_1", "x_{a,b}"]
    );
    assert_eq!(
        attributes[0].value,
        Attribute::Dimension("M L^{-1/2} T^{-2}".to_owned())
    );
    assert_eq!(attributes[1].value, Attribute::Natural);
    let Attribute::Interval {
        lower: Some(lower),
        upper: Some(upper),
    } = &attributes[2].value
    else {
        panic!();
    };
    assert_eq!(
        (lower.value.to_string(), lower.strict),
        ("0".to_owned(), true)
    );
    assert_eq!(
        (upper.value.to_string(), upper.strict),
        ("1/2".to_owned(), false)
    );
    let Attribute::Interval {
        lower: Some(one),
        upper: None,
    } = &attributes[3].value
    else {
        panic!();
    };
    assert!(!one.strict);
}

#[test]
fn slips_in_directives_are_named_with_their_repair() {
    for (comment, guilty, help) in [
        ("chek: given", "chek", "`check:`"),
        ("Check given", "Check", "`check:`"),
        ("check: gven", "gven", "`given`"),
        ("chekc: given", "chekc", "`check:`"),
        ("check: Fomr (2)", "Fomr", "`from`"),
        ("check: let a = 1\nasuming b > 0", "asuming", "`assuming`"),
        ("check: symbols m: postive", "postive", "`positive`"),
        (
            "check: symbols m: mass, in [1, 0]",
            "in [1, 0]",
            "exact bounds",
        ),
        (
            "check: symbols m: in [0, \\infty]",
            "in [0, \\infty]",
            "exact bounds",
        ),
        ("check: symbols m, : mass", ",", "for example"),
        ("check: symbols m", "symbols m", "for example"),
        ("check: from 42", "42", "from (42)"),
        ("check: from (2),", "from (2),", "from (42)"),
        ("check: claim a b", "a b", "a name has"),
        ("check: given (2)", "(2)", "separate"),
        ("check: let", "let", "let m = 1"),
        ("check:", "", "a clause begins"),
    ] {
        let source = format!("<!-- {comment} -->");
        let document = read(&source);
        let [problem] = &document.problems[..] else {
            panic!("{comment}: {:#?}", document.problems);
        };
        assert_eq!(document.text(problem.span), guilty, "{comment}");
        let said = problem.help.as_deref().unwrap_or_default();
        assert!(said.contains(help), "{comment}: {said}");
    }
    for other in ["banana", &"x".repeat(1000)] {
        let source = format!("<!-- check: {other} -->");
        let document = read(&source);
        let help = document.problems[0].help.as_deref().unwrap_or_default();
        assert!(!help.contains("did you mean"), "{other}: {help}");
    }
    for other in [
        "a note",
        "check this later",
        "TODO: given",
        "checklist: given",
    ] {
        assert_eq!(problems(&read(&format!("<!-- {other} -->"))), [], "{other}");
    }
}

#[test]
fn directives_are_read_wherever_a_comment_is() {
    for page in [
        "text <!-- check: given --> text",
        "# Title <!-- check: given -->",
        "<div>\n<!-- check: given -->\n</div>",
        "<!-- a --> <!-- check: given -->",
        "- item\n\n  <!-- check: given -->\n",
    ] {
        assert_eq!(directives(&read(page)), [&Directive::Given], "{page}");
    }
    assert_eq!(
        headings(&read("# Title <!-- check: given -->")),
        [(1, "Title")]
    );
    assert!(directives(&read("`<!-- check: given -->`")).is_empty());
}

#[test]
fn bytes_must_be_text() {
    assert!(read_bytes("x.md", "δ".as_bytes()).is_ok());
    assert_eq!(
        read_bytes("x.md", b"a\n\xff")
            .map_err(|error| error.line)
            .err(),
        Some(2)
    );
    assert_eq!(decode(b"a\nb\xff"), Err(NotUtf8 { offset: 3, line: 2 }));
    assert_eq!(decode(b"a"), Ok("a"));
}

#[test]
fn columns_count_characters_on_every_kind_of_line() {
    let source = "\u{feff}a\r\nδ = 1\rz";
    let document = read(source);
    let at = |needle: &str| {
        let position = document.position(source.find(needle).unwrap());
        (position.line, position.column)
    };
    assert_eq!(at("a"), (1, 1));
    assert_eq!(at("="), (2, 3));
    assert_eq!(at("z"), (3, 1));
}

#[test]
fn an_offset_past_the_end_or_inside_a_character_is_rounded_down() {
    let document = read("δ");
    assert_eq!(document.position(1), document.position(0));
    assert_eq!(document.position(99).column, 2);
}

#[test]
fn long_and_hostile_documents_take_linear_time() {
    for piece in [
        "$",
        "$$ ",
        "$a ",
        "\\[",
        "\\(",
        "`",
        "<!--",
        "<!-- check",
        "> ",
        "#\n",
        "\\begin{align}",
        "(2) ",
        "<b ",
        "[",
        "- a\n",
        "* ",
        "$$\n=\n$$\n\n",
        "a\n=\n",
        "Eqs. (1)-(9) ",
    ] {
        let clock = std::time::Instant::now();
        read(&piece.repeat(200_000 / piece.len()));
        // What grew with the square of the length would take far longer, and a busy machine far less.
        assert!(
            clock.elapsed().as_secs() < 60,
            "{piece}: {:?}",
            clock.elapsed()
        );
    }
}

fn covers(document: &Document, at: usize) -> bool {
    let displays = document.items.iter().filter_map(|item| match item {
        Item::Display { span, .. } => Some(*span),
        _ => None,
    });
    let problems = document.problems.iter().map(|problem| problem.span);
    displays
        .chain(problems)
        .any(|Span { start, end }| start <= at && at < end)
}

const PIECES: &[&str] = &[
    "$$",
    "$$",
    "$",
    "\n",
    "\n\n",
    " ",
    "    ",
    "a = b",
    "\\",
    "\\[",
    "\\]",
    "\\(",
    "\\)",
    "`",
    "```",
    "```math\n",
    "<!--",
    "-->",
    " check: ",
    "let ",
    ";",
    "# ",
    "=\n",
    "---\n",
    "> ",
    "- ",
    "<div>",
    "é",
    "\r\n",
    "\t",
    "(2)",
    "equations ",
    "–",
    "Let ",
    "symbols ",
    ": ",
    ", ",
    "in [0, 1)",
    "{",
    "}",
    "from ",
    "\\begin{align}",
    "\\end{align}",
    ".",
    "[x](",
    "\u{feff}",
];

fn document() -> impl Strategy<Value = String> {
    let piece = proptest::sample::select(PIECES);
    proptest::collection::vec(piece, 0..40).prop_map(|pieces| pieces.concat())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn no_text_is_too_strange(source in prop_oneof![document(), any::<String>()]) {
        let document = read(&source);
        let mut last = 0;
        for item in &document.items {
            let span = item.span();
            prop_assert!(source.get(span.range()).is_some_and(|text| !text.is_empty()));
            let in_heading = matches!(item, Item::Directives { .. });
            prop_assert!(span.start >= last || in_heading);
            last = span.end;
            document.position(span.start);
        }
        for problem in &document.problems {
            prop_assert!(source.get(problem.span.range()).is_some());
        }
    }

    /// Without code, HTML, escapes and indentation, every pair of dollars counts.
    #[test]
    fn every_fence_is_a_display_or_a_problem(source in document()) {
        let plain: String = source.chars().filter(|c| !"`<\\\t\r~+".contains(*c)).collect();
        let mut plain = format!("x\n{}", plain.replace("---\n", "--\n").replace("[x](", "["));
        // What is left out may bring spaces together.
        while plain.contains("    ") {
            plain = plain.replace("    ", " ");
        }
        let document = read(&plain);
        let (bytes, mut at) = (plain.as_bytes(), 0);
        while at + 1 < bytes.len() {
            if &bytes[at..at + 2] == b"$$" {
                prop_assert!(covers(&document, at), "{plain:?} at {at}: {document:#?}");
                at += 2;
            } else {
                at += 1;
            }
        }
    }

    /// With them, a display of its own paragraph is found whatever closed blocks surround it.
    #[test]
    fn no_display_is_lost_between_code_and_comments(
        blocks in proptest::collection::vec(proptest::sample::select(&[
            "`$$`", "```\n$$\n```", "<!-- $$ -->", "# a", "text $b$", "$$\n`\n\n<!--\n#\n=\n$$", "$$ a $$", "a\n===", "\\$$5 text",
        ][..]), 0..12)
    ) {
        let source = blocks.join("\n\n");
        let document = read(&source);
        let expected = blocks.iter().filter(|block| block.starts_with("$$")).count();
        prop_assert_eq!(displays(&document).len(), expected, "{}", source);
        prop_assert!(document.problems.is_empty());
    }
}
