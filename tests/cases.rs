//! How a text names the case that what comes next is said of, and how it leaves it.

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;

use crate::common::{last, verdicts, verdicts_of};

/// Of each pair the first names the case of a positive `x`, the second that of a negative one.
const WAYS: &[[&str; 2]] = &[
    ["If $x > 0$, then", "If $x < 0$, then"],
    ["When $x > 0$, we have", "When $x < 0$, we have"],
    ["If $x$ is positive, then", "If $x$ is negative, then"],
    ["For positive $x$ we get", "For negative $x$ we get"],
    ["For $x$ positive we get", "For $x$ negative we get"],
    ["For a positive $x$,", "For a negative $x$,"],
    [
        "For any positive number $x$ we get",
        "For any negative number $x$ we get",
    ],
    ["For $x$ greater than zero", "For $x$ less than zero"],
    [
        "If $x$ is larger than zero,",
        "If $x$ is smaller than zero,",
    ],
    ["Where $x$ is positive,", "Where $x$ is negative,"],
    ["Should $x$ be positive,", "Should $x$ be negative,"],
    [
        "With $c$ positive and $x$ positive,",
        "For a positive $c$ and a negative $x$,",
    ],
    ["For positive values of $x$,", "For negative values of $x$,"],
    [
        "In the case that $x$ is positive,",
        "In the case that $x$ is negative,",
    ],
    [
        "Suppose that $x$ is positive. Then",
        "Now let $x$ be negative. Then",
    ],
    [
        "If $x$ is greater than 0, then",
        "If $x$ is less than 0, then",
    ],
    ["If $x$ exceeds $0$, then", "If $x$ is smaller than 0, then"],
    ["**Case 1: $x > 0$.** Then", "**Case 2: $x < 0$.** Then"],
    ["**Case 1** ($x > 0$). Then", "**Case 2** ($x < 0$). Then"],
    ["Case A: positive $x$. Then", "Case B: negative $x$. Then"],
    ["*Positive $x$.* Here", "*Negative $x$.* Here"],
    ["The case $x > 0$: here", "The case $x < 0$: here"],
    [
        "The case of positive $x$: here",
        "The case of negative $x$: here",
    ],
    ["- $x > 0$: Then", "- $x < 0$: Then"],
    ["1. $x > 0$. Then", "2. $x < 0$. Then"],
    ["(i) $x > 0$. Then", "(ii) $x < 0$. Then"],
    ["### Case 1: $x > 0$\n\nHere", "### Case 2: $x < 0$\n\nHere"],
    ["### Positive $x$\n\nHere", "### Negative $x$\n\nHere"],
    [
        "### The case $x > 0$\n\nHere",
        "### The case $x < 0$\n\nHere",
    ],
    [
        "### Gains ($x > 0$)\n\nHere",
        "### Losses ($x < 0$)\n\nHere",
    ],
];

#[test]
fn a_case_is_left_for_the_next_however_it_is_named() {
    for [positive, negative] in WAYS {
        let page = |first: &str, second: &str| {
            verdicts(&format!(
                "# Shifts\n\nWe consider\n\n$$ y = x + c. \\tag{{1}} $$\n\n{positive}\n\n$$ y {first} c. \\tag{{2}} $$\n\n\
                 {negative}\n\n$$ y {second} c. \\tag{{3}} $$\n"
            ))
        };
        assert_eq!(page(">", "<"), ["given", "holds", "holds"], "{negative}");
        assert_eq!(page("<", ">"), ["given", "fails", "fails"], "{negative}");
    }
}

/// "Not positive" is nought or less, and no more than that.
#[test]
fn a_sign_that_is_denied_is_the_other_one_or_nought() {
    let page = |words: &str, relation: &str| {
        last(&format!(
            "We consider\n\n$$ y = x + c. \\tag{{1}} $$\n\nIf $x > 0$, then\n\n$$ y > c. \\tag{{2}} $$\n\n\
             {words}\n\n$$ y {relation} c. \\tag{{3}} $$\n"
        ))
    };
    for words in [
        "When $x$ is not positive,",
        "If $x$ is not strictly positive, then",
        "If $x$ is non-positive, then",
        "For non-positive $x$ we get",
        "In the case that $x$ is not positive,",
    ] {
        assert_eq!(page(words, "\\leq"), "holds", "{words}");
        assert_eq!(page(words, "<"), "fails", "{words}");
        assert_eq!(page(words, ">"), "fails", "{words}");
    }
}

/// However a text says that it has turned to what cannot be so in the case before, that case is over.
#[test]
fn what_rules_out_a_case_is_the_next_one() {
    for words in [
        "If instead $x < 0$ then",
        "If, on the other hand, $x < 0$, then",
        "In the opposite case, $x < 0$,",
        "Otherwise, $x < 0$ and",
        "Else, if $x < 0$,",
        "By contrast, $x < 0$ gives",
        "Now take $x < 0$. Then",
        "Had we $x < 0$,",
        "As soon as $x < 0$,",
        "In the regime $x < 0$",
        "To the left of the origin, $x < 0$,",
        "For the other sign of $x$, $x < 0$,",
        "The second possibility is $x < 0$. Then",
        "It remains to consider $x < 0$. Then",
        "The remaining case is $x < 0$. Here",
        "Given $x < 0$,",
        "Next, $x < 0$ gives",
        "Regime II, $x < 0$:",
        "Yet when $x < 0$,",
        "whereas if $x < 0$,",
        "Likewise, if $x$ is negative,",
        "Once $x$ becomes negative,",
        "As soon as $x$ turns negative,",
        "If $x$ negative,",
        "If $x$ were negative, then",
        "Were $x$ negative, then",
        "Choosing $x$ negative,",
        "In the regime of negative $x$",
        "For values of $x$ below zero",
        "For $x$ below $-1$",
        "If $x$ is at most $-2$, then",
    ] {
        let page = |relation: &str| {
            verdicts(&format!(
                "We consider\n\n$$ y = x + c. \\tag{{1}} $$\n\nIf $x > 0$, then\n\n$$ y > c. \\tag{{2}} $$\n\n\
                 {words}\n\n$$ y {relation} c, \\tag{{3}} $$\n\nand therefore\n\n$$ |x| = -x. \\tag{{4}} $$\n"
            ))
        };
        assert_eq!(page("<"), ["given", "holds", "holds", "holds"], "{words}");
        assert_eq!(page(">")[2], "fails", "{words}");
    }
}

/// What is so in a case alone is not concluded from it where the text says that the case is over.
#[test]
fn what_was_a_case_may_be_anything_again() {
    for words in [
        "For general $x$",
        "For an arbitrary $x$ we have",
        "For any $x$",
        "For other values of $x$",
        "Let now $x$ be arbitrary. Then",
        "Now let $x$ vary. Then",
        "As a function of $x$,",
        "Independent of the value of $x$,",
        "Regardless of $x$,",
        "Whatever $x$ is,",
        "With $x$ kept general,",
        "When $x$ is left open,",
        "When $x$ is not 1,",
        "Away from $x = 1$,",
        "Unless $x = 1$,",
        "Apart from this special case,",
        "Except for this case,",
        "In all other cases",
        "If this condition is not met,",
        "If it does not hold,",
        "If not,",
        "Removing the condition,",
        "Relaxing $x = 1$,",
        "We now drop the condition $x = 1$. Then",
    ] {
        let page = |formula: &str| {
            last(&format!(
                "We consider\n\n$$ y = x + c. \\tag{{1}} $$\n\nIf $x = 1$, then\n\n$$ y = c + 1. \\tag{{2}} $$\n\n\
                 {words}\n\n$$ {formula}. \\tag{{3}} $$\n"
            ))
        };
        assert_ne!(page("y - c = 1"), "holds", "{words}");
        assert_eq!(page("y - x = c"), "holds", "{words}");
    }
    // What may be anything is another letter, or the case goes on.
    for words in [
        "For general $c$",
        "With $c$ left open",
        "In this case",
        "If this condition is met,",
        "If this is so,",
    ] {
        let page = format!(
            "We consider\n\n$$ y = x + c. \\tag{{1}} $$\n\nIf $x = 1$, then\n\n$$ y = c + 1. \\tag{{2}} $$\n\n\
             {words}\n\n$$ y - c = 1. \\tag{{3}} $$\n"
        );
        assert_eq!(last(&page), "holds", "{words}");
    }
}

/// "Otherwise" it is not so, and neither is what was so in the cases before.
#[test]
fn otherwise_none_of_the_cases_before_is_so() {
    let page = |cases: &[&str], words: &str, formula: &str| {
        let mut text = "We consider\n\n$$ y = x + c. \\tag{1} $$\n\n".to_owned();
        for case in cases {
            text.push_str(&format!("If {case}, then\n\n$$ (y - c)^2 = x^2. $$\n\n"));
        }
        last(&format!("{text}{words} by (1)\n\n$$ {formula}. $$\n"))
    };
    for words in [
        "Otherwise",
        "Otherwise we have",
        "Else",
        "In the opposite case",
    ] {
        assert_eq!(page(&["$x > 0$"], words, "y \\leq c"), "holds", "{words}");
        assert_eq!(page(&["$x > 0$"], words, "y < c"), "fails", "{words}");
        let two = ["$x > 0$", "$x = 0$"];
        assert_eq!(page(&two, words, "y < c"), "holds", "{words}");
        assert_eq!(page(&two, words, "y > c"), "fails", "{words}");
        // Which of two things is not so is not said.
        let both = ["$x > 0$ and $c > 0$"];
        assert_eq!(page(&both, words, "y \\leq c"), "undecided", "{words}");
    }
}

/// What a sentence says that has come to its end is not supposed of what comes after it; and what it doubts is no case.
#[test]
fn what_is_only_said_of_a_sign_is_no_case() {
    for words in [
        "If $x$ is negative, the body moves to the left. By (1)",
        "For negative $x$ nothing is known. By (1)",
        "Whether $x$ is negative or positive, by (1)",
        "If $x$ is not negative, then by (1)",
    ] {
        let page = format!(
            "We consider\n\n$$ y = x + c. \\tag{{1}} $$\n\n{words}\n\n$$ y < c. \\tag{{2}} $$\n"
        );
        assert_ne!(verdicts(&page)[1], "holds", "{words}");
    }
}

#[test]
fn what_is_so_in_both_cases_is_not_refuted_beside_them() {
    let page = |last: &str| {
        verdicts(&format!(
            "We consider\n\n$$ y = x + c. \\tag{{1}} $$\n\nIf $x > 0$, then\n\n$$ y > c, \\tag{{2}} $$\n\nand if $x < 0$, then\n\n\
             $$ y < c. \\tag{{3}} $$\n\nIn both cases\n\n$$ {last}. \\tag{{4}} $$\n"
        ))[3]
    };
    assert_eq!(page("(y - c) x > 0"), "undecided");
    assert_eq!(page("(y - c) x \\geq 0"), "holds");
    assert_ne!(page("y < c"), "holds");
}

/// A heading that names a law or a question is of no case.
#[test]
fn a_heading_that_names_a_law_is_no_case() {
    for heading in [
        "Work and heat ($y = c$)",
        "Why $x = 0$ is excluded",
        "Proof of $y = c$",
        "From $x = 0$ to $x = 1$",
    ] {
        let page = format!(
            "We consider\n\n$$ y = x + c. \\tag{{1}} $$\n\n## {heading}\n\nBy (1)\n\n$$ y = c. \\tag{{2}} $$\n"
        );
        assert_eq!(verdicts(&page), ["given", "fails"], "{heading}");
    }
}

#[test]
fn lists_and_headings_in_latex_name_cases() {
    let page = |first: &str, second: &str| {
        let text = format!(
            "\\documentclass{{article}}\n\\begin{{document}}\nWe consider\n\\begin{{equation}} y = x + c. \\end{{equation}}\n\
             {first}\n\\begin{{equation}} y > c. \\end{{equation}}\n{second}\n\\begin{{equation}} y < c. \\end{{equation}}\n\\end{{document}}\n"
        );
        verdicts_of(Document::latex("a.tex", text, &()))
    };
    for [first, second] in [
        [
            "\\paragraph{Case 1: $x > 0$.} Here",
            "\\paragraph{Case 2: \\(x < 0\\).} Here",
        ],
        [
            "\\subsection{Positive $x$} Here",
            "\\subsection{Negative $x$} Here",
        ],
        [
            "\\textbf{Case 1: $x > 0$.} Then",
            "\\textbf{Case 2:} $x < 0$. Then",
        ],
        ["\\emph{Positive $x$.} Then", "\\emph{Negative $x$.} Then"],
        [
            "\\begin{itemize}\n\\item $x > 0$: Here",
            "\\item $x < 0$: Here",
        ],
        [
            "\\begin{enumerate}\n\\item If $x > 0$, then",
            "\\item[(b)] $x < 0$. Then",
        ],
        [
            "\\begin{itemize}\n\\item If $x > 0$, then",
            "\\end{itemize}\n\\textit{Negative $x$.} Then",
        ],
    ] {
        assert_eq!(page(first, second), ["given", "holds", "holds"], "{second}");
        assert_eq!(page(second, first), ["given", "fails", "fails"], "{second}");
    }
}

/// What is supposed for the sake of a contradiction is so until that is reached; and that is no fault.
#[test]
fn a_contradiction_ends_what_was_supposed_for_its_sake() {
    let page = |suppose: &str, first: &str, last: &str| {
        verdicts(&format!(
            "The numbers differ,\n\n$$ a \\neq b, \\tag{{1}} $$\n\nand\n\n$$ m (a - b) = c - d. \\tag{{2}} $$\n\n{suppose} that $c = d$. Then by (2)\n\n\
             $$ {first}, \\tag{{3}} $$\n\nwhich contradicts $m (a - b) \\neq 0$. Hence\n\n$$ {last}. \\tag{{4}} $$\n"
        ))
    };
    for suppose in [
        "Suppose, on the contrary,",
        "Suppose to the contrary",
        "Assume, for contradiction,",
    ] {
        let right = page(suppose, "m (a - b) = 0", "m (a - b) = c - d");
        assert_eq!(right, ["given", "given", "holds", "holds"], "{suppose}");
        let wrong = page(suppose, "m (a - b) = 1", "m = 0");
        assert_eq!(wrong[2], "fails", "{suppose}");
        assert_ne!(wrong[3], "holds", "{suppose}");
    }

    let page = "The numbers satisfy\n\n$$ p^2 = 2 q^2 + 1. \\tag{1} $$\n\nAssume for contradiction that $p = q$. Then\n\n$$ q^2 = - 1, \\tag{2} $$\n\n\
         which is impossible. Thus\n\n$$ p \\neq q. \\tag{3} $$\n";
    let audit = Audit::of(&Derivation::from_markdown("a.md", page));
    let mut notes = audit.entries.iter().flat_map(|own| &own.notes);
    assert!(notes.all(|note| note.code() != "inconsistent-premises"));
    assert_eq!(audit.entries[2].verdict.word(), "holds");
}

/// What is solved for has no value any more that was put in for it.
#[test]
fn what_is_solved_for_has_the_value_no_more_that_it_had_in_a_case() {
    let page = |weight: &str| {
        verdicts(&format!(
            "The mixture has the density\n\n$$ r = w A + (1 - w) B. \\tag{{1}} $$\n\nSuppose that $w = \\frac12$. Then\n\n$$ r = \\frac{{A + B}}{{2}}. \\tag{{2}} $$\n\n\
             Solving (1) for $w$ we obtain, with $A \\neq B$,\n\n$$ w = {weight}. \\tag{{3}} $$\n"
        ))[2]
    };
    assert_eq!(page(r"\frac{r - B}{A - B}"), "holds");
    assert_ne!(page(r"\frac{r - B}{2 r - 2 B}"), "holds");
}

#[test]
fn cases_that_are_counted_are_taken_up_by_their_number() {
    let page = |count: &str, first: &str, second: &str| {
        verdicts(&format!(
            "The shift is\n\n$$ y = x + c. \\tag{{1}} $$\n\n{count} {first} case\n\n$$ y > c, \\tag{{2}} $$\n\n{second} case\n\n$$ y < c. \\tag{{3}} $$\n"
        ))
    };
    for count in [
        "Either $x > 0$ or $x < 0$.",
        "There are two cases: $x > 0$ and $x < 0$.",
        "We distinguish the cases $x > 0$ and $x < 0$.",
        "Hence $x > 0$ or $x < 0$.",
    ] {
        for [first, second] in [
            ["In the first", "and in the second"],
            ["In the former", "In the latter"],
            ["In the first", "In the other"],
        ] {
            let right = page(count, first, second);
            assert_eq!(right, ["given", "holds", "holds"], "{count} {first}");
            let wrong = page(count, second, first);
            assert_eq!(wrong[1], "fails", "{count} {second}");
        }
    }
}

#[test]
fn a_condition_that_is_also_enough_is_said_of_what_it_comes_to() {
    let page = |root: &str| {
        verdicts(&format!(
            "The discriminant is\n\n$$ D = p^2 - 4 q. \\tag{{1}} $$\n\nThere is a double root if and only if $D = 0$, that is,\n\n$$ q = {root}. \\tag{{2}} $$\n"
        ))[1]
    };
    assert_eq!(page(r"\frac{p^2}{4}"), "holds");
    assert_eq!(page(r"\frac{p^2}{2}"), "fails");
}

#[test]
fn cases_in_one_sentence_are_told_apart() {
    for joins in ["and", "while", "whereas", "but"] {
        let page = |second: &str| {
            verdicts(&format!(
                "For $x \\geq 0$ we have $|x| = x$, so\n\n$$ |x| + x = 2 x, \\tag{{1}} $$\n\n{joins} for $x < 0$ we have $|x| = -x$, so\n\n$$ |x| + x = {second}. \\tag{{2}} $$\n"
            ))
        };
        assert_eq!(page("0"), ["holds", "holds"], "{joins}");
        assert_eq!(page("2 x"), ["holds", "fails"], "{joins}");
    }
}

/// What takes the place of another law is given, and that one is used no more.
#[test]
fn what_replaces_another_law_is_given() {
    let page = |words: &str, last: &str| {
        verdicts(&format!(
            "Without friction\n\n$$ m a = F. \\tag{{1}} $$\n\n{words}\n\n$$ m a = F - R. \\tag{{2}} $$\n\nWith $m \\neq 0$ we conclude that\n\n$$ a = {last}. \\tag{{3}} $$\n"
        ))
    };
    for words in [
        "With friction (1) is replaced by",
        "Instead of (1) we now have",
    ] {
        let right = ["given", "given", "holds"];
        assert_eq!(page(words, r"\frac{F - R}{m}"), right, "{words}");
        // It follows where `R` is 0, and a text may leave that unsaid.
        assert_eq!(page(words, r"\frac{F}{m}")[2], "undecided", "{words}");
    }
}

/// What is not understood is said of all displays to which it leads.
#[test]
fn what_is_not_understood_is_said_of_displays_side_by_side() {
    let page = "The sum of squares is\n\n$$ S = \\sum_{i=1}^n (y_i - a - b x_i)^2. \\tag{1} $$\n\n\
                Setting the derivatives with respect to $a$ and $b$ to zero gives\n\n\
                $$ \\sum_{i=1}^n y_i = n a + b \\sum_{i=1}^n x_i, \\tag{2} $$\n\n\
                $$ \\sum_{i=1}^n x_i y_i = a \\sum_{i=1}^n x_i + b \\sum_{i=1}^n x_i^2. \\tag{3} $$\n";
    assert!(!verdicts(page).contains(&"fails"));
}

/// A value in words may be of anything: what follows is left open, and a slip beside it fails where it is no value's doing.
#[test]
fn values_of_what_has_no_symbol_refute_nothing() {
    for words in [
        "For an angle of $30^\\circ$, (1) gives",
        "At an angle of 30 degrees we have by (1)",
        "For an inclination of $30^\\circ$ we find",
        "If the plane is inclined by $\\pi/6$, then by (1)",
        "Thus at $30^\\circ$",
    ] {
        let page = format!(
            "The acceleration is\n\n$$ a = g \\sin\\theta. \\tag{{1}} $$\n\n{words}\n\n$$ a = \\frac{{g}}{{2}}. \\tag{{2}} $$\n"
        );
        assert!(
            matches!(verdicts(&page)[1], "given" | "undecided"),
            "{words}"
        );
    }
}

/// What was told of another case is told no more in one that is counted, or supposed for a contradiction.
#[test]
fn what_is_told_of_a_case_is_not_told_of_the_next() {
    for words in [
        "In the second case we have by (1)",
        "Suppose, on the contrary, that $r > 2$. Then by (1)",
        "For $r > 2$ we have by (1)",
    ] {
        let page = format!(
            "The pressures obey\n\n$$ p_1 + r g h_1 = p_2 + r g h_2. \\tag{{1}} $$\n\nEither $r > 0$ or $r < 0$. \
             For a horizontal pipe, $h_1 = h_2$, (1) becomes\n\n$$ p_1 = p_2. \\tag{{2}} $$\n\n{words}\n\n$$ p_1 = p_2. \\tag{{3}} $$\n"
        );
        assert_eq!(verdicts(&page), ["given", "holds", "fails"], "{words}");
    }
}
