//! What is on the page, read as XML.

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use cradle_verify::audit::Audit;
use cradle_verify::proofs;

use super::{built_in, has_class, page_of, text_of, thousands, tree};

#[test]
fn every_link_within_the_page_leads_somewhere_and_every_name_is_used_once() {
    let page = built_in();
    let tree = tree(page);
    let names: Vec<&str> = tree
        .descendants()
        .filter_map(|n| n.attribute("id"))
        .collect();
    let all: BTreeSet<&str> = names.iter().copied().collect();
    assert_eq!(all.len(), names.len());
    let mut links = 0;
    for node in tree.descendants() {
        if let Some(target) = node.attribute("href").and_then(|h| h.strip_prefix('#')) {
            assert!(all.contains(target), "{target}");
            links += 1;
        }
        for list in ["aria-labelledby", "aria-describedby"] {
            for name in node.attribute(list).unwrap_or("").split_whitespace() {
                assert!(all.contains(name), "{name}");
            }
        }
    }
    assert!(links > names.len() / 2);
}

/// The way from the drawing to the statement, for a pointer, for keys, and for those who are told.
#[test]
fn every_statement_of_the_drawing_leads_to_its_equation() {
    let page = built_in();
    let tree = tree(page);
    // A piece for each row of documents, so that paper can end between two of them.
    let pieces: Vec<_> = tree
        .descendants()
        .filter(|n| has_class(n, "cv-graph"))
        .collect();
    assert!(pieces.len() > 5);
    for piece in &pieces {
        // Within an image there would be no links for a screen reader.
        assert_eq!(piece.attribute("role"), Some("group"));
    }
    let derivation = proofs::report();
    let audit = Audit::of(&derivation);
    let nodes: Vec<_> = pieces
        .iter()
        .flat_map(|piece| piece.descendants())
        .filter(|n| n.tag_name().name() == "a")
        .collect();
    assert_eq!(nodes.len(), audit.entries.len());
    for (node, entry) in nodes.iter().zip(&audit.entries) {
        if let Some(tag) = &derivation.equations[entry.equation].tag {
            assert_eq!(node.attribute("href"), Some(format!("#eq-{tag}").as_str()));
            let title = node.children().find(|n| n.tag_name().name() == "title");
            let title = text_of(title.expect("a title"));
            assert!(title.starts_with(&format!("({tag})")), "{title}");
        }
    }
}

#[test]
fn scripts_are_set_where_there_is_no_formula() {
    let page = page_of(&[(
        "a.md",
        "<!-- check: symbols E_{\\text{in}}, E_{\\text{out}}: energy, positive -->\n\n<!-- check: law -->\n\n\
         $$ E_{\\text{out}} = 2 E_{\\text{in}} \\tag{1} $$\n\nBy (1):\n\n$$ E_{\\text{out}} = 3 E_{\\text{in}} \\tag{2} $$\n",
    )]);
    let tree = tree(&page);
    assert!(page.contains("E<sub>out</sub> = 1"));
    let outside = |n: &roxmltree::Node<'_, '_>| {
        !n.ancestors()
            .any(|a| ["code", "pre", "style", "script", "title"].contains(&a.tag_name().name()))
    };
    for node in tree.descendants().filter(|n| n.is_text() && outside(n)) {
        let text = node.text().unwrap_or_default();
        assert!(!text.contains("_{") && !text.contains("^("), "{text}");
    }
}

#[test]
fn every_statement_of_the_report_is_there_with_its_verdict_in_words() {
    let page = built_in();
    let tree = tree(page);
    let derivation = proofs::report();
    let audit = Audit::of(&derivation);
    let shown: Vec<_> = tree
        .descendants()
        .filter(|n| has_class(n, "equation"))
        .collect();
    assert_eq!(shown.len(), derivation.equations.len());
    for (at, equation) in shown.iter().enumerate() {
        let entries = audit.of_equation(at);
        let verdicts: Vec<&str> = entries.iter().map(|e| e.verdict.word()).collect();
        assert_eq!(
            equation.attribute("data-verdict"),
            Some(verdicts.join(" ").as_str())
        );
        let words: Vec<String> = equation
            .descendants()
            .filter(|n| has_class(n, "verdict"))
            .map(text_of)
            .collect();
        assert_eq!(words.len(), entries.len());
        for (word, entry) in words.iter().zip(entries) {
            assert!(word.contains(entry.verdict.word()), "{word}");
        }
        if let Some(tag) = &derivation.equations[at].tag {
            assert!(text_of(*equation).contains(&format!("({tag})")));
            assert_eq!(equation.attribute("id"), Some(format!("eq-{tag}").as_str()));
        }
        // Typeset, and with its evidence folded below.
        let math = equation
            .descendants()
            .filter(|n| n.tag_name().name() == "math")
            .count();
        assert!(math >= entries.len());
        let folds = equation
            .descendants()
            .filter(|n| n.tag_name().name() == "details")
            .count();
        assert_eq!(folds, entries.len());
    }
}

#[test]
fn what_is_typeset_has_no_latex_left_in_it() {
    let page = built_in();
    for math in tree(page)
        .descendants()
        .filter(|n| n.tag_name().name() == "math")
    {
        let text = text_of(math);
        assert!(!text.contains(['\\', '{', '}', '$', '_']), "{text}");
        assert!(!text.is_empty());
    }
    let prose = tree(page)
        .descendants()
        .filter(|n| n.tag_name().name() == "p")
        .map(text_of)
        .collect::<String>();
    assert!(!prose.contains('$') && !prose.contains("<!--"));
}

#[test]
fn what_is_said_of_formulas_has_its_scripts_set() {
    let page = tree(built_in());
    let told = page.descendants().filter(|node| {
        let class = node.attribute("class").unwrap_or_default();
        let parent = node
            .parent()
            .and_then(|p| p.attribute("class"))
            .unwrap_or_default();
        class.starts_with("finding ") || parent.starts_with("evidence")
    });
    // LaTeX is shown as it was typed.
    let is_typed = |node: &roxmltree::Node| {
        let mut around = node.ancestors().filter(|n| n.tag_name().name() == "code");
        around.any(|code| text_of(code).contains('\\') || code.attribute("class") == Some("tex"))
    };
    let texts = told.flat_map(|node| node.descendants().filter(|n| n.is_text()));
    for text in texts.filter(|text| !is_typed(text)) {
        let said = text.text().unwrap_or_default();
        assert!(!said.contains(['_', '$']), "{said}");
    }
}

#[test]
fn headings_go_down_a_step_at_a_time_and_tables_name_their_columns() {
    let page = built_in();
    let tree = tree(page);
    let mut last = 0;
    for node in tree.descendants() {
        let name = node.tag_name().name();
        if let Some(level) = name.strip_prefix('h').and_then(|l| l.parse::<u32>().ok()) {
            assert!(level <= last + 1, "{name} after h{last}: {}", text_of(node));
            last = level;
        }
        if name == "table" {
            let heads = node
                .descendants()
                .filter(|n| n.attribute("scope") == Some("col"));
            assert!(heads.count() > 1);
        }
    }
    for landmark in ["header", "nav", "main", "footer"] {
        assert_eq!(
            tree.descendants()
                .filter(|n| n.tag_name().name() == landmark)
                .count(),
            1
        );
    }
}

#[test]
fn nothing_is_fetched() {
    let page = built_in();
    for node in tree(page).descendants() {
        assert!(
            !["link", "img", "iframe", "object", "image", "use"].contains(&node.tag_name().name())
        );
        for attribute in node.attributes() {
            assert!(!["src", "srcset", "style", "data"].contains(&attribute.name()));
            assert!(!attribute.name().starts_with("on"), "{}", attribute.name());
        }
    }
    assert!(!page.contains("url(") && !page.contains("@import"));
    assert!(page.len() < 1_000_000, "{}", page.len());
}

#[test]
fn displays_keep_their_place_in_whatever_is_around_them() {
    let page = page_of(&[(
        "around.md",
        "# A list\n\n1. First $a$ and\n   $$ a = b \\tag{1} $$\n   after\n2. **bold $$ b = a \\tag{2} $$ still**\n\n\
         > quoted\n> $$ a + b = 2 b \\tag{3} $$\n> end\n\n| x | y |\n|---|---|\n| $a|b$ | 2 |\n\n\
         <div>\n$$ a - b = 0 \\tag{4} $$\n</div>\n\n[ref]: x \"$$ c = d \\tag{5} $$\"\n",
    )]);
    let tree = tree(&page);
    let names: Vec<&str> = tree
        .descendants()
        .filter(|n| has_class(n, "equation"))
        .filter_map(|n| n.attribute("id"))
        .collect();
    for number in ["eq-1", "eq-2", "eq-3", "eq-5"] {
        assert_eq!(
            names.iter().filter(|name| **name == number).count(),
            1,
            "{names:?}"
        );
    }
    // What is not read is said, and shown as it was typed.
    let text = text_of(tree.root());
    assert!(
        text.contains("an equation in a block of HTML is not read") && text.contains("a - b = 0")
    );
    for node in tree.descendants().filter(|n| has_class(n, "equation")) {
        let narrow = ["p", "strong", "em", "h3", "h4", "pre", "a"];
        assert!(
            node.ancestors()
                .all(|a| !narrow.contains(&a.tag_name().name()))
        );
    }
    let within = |id: &str, tag: &str| {
        let node = tree
            .descendants()
            .find(|n| n.attribute("id") == Some(id))
            .unwrap();
        node.ancestors().any(|a| a.tag_name().name() == tag)
    };
    assert!(within("eq-1", "li") && within("eq-2", "li") && within("eq-3", "blockquote"));
}

#[test]
fn titles_are_those_of_the_documents() {
    let head = |documents: &[(&str, &str)]| {
        let page = page_of(documents);
        let tree = tree(&page);
        let named = |name| tree.descendants().find(|n| n.tag_name().name() == name);
        let (title, head) = (named("title").unwrap(), named("h1").unwrap());
        assert!(head.descendants().all(|n| n.tag_name().name() != "b"));
        (text_of(title), text_of(head))
    };
    let first = (
        "docs/a.md",
        "# On $x^2$, **bold** and `code` <b>\n\n$$ a = b $$\n",
    );
    let (title, shown) = head(&[first]);
    assert_eq!(title, "On x², bold and code <b>: audit");
    assert_eq!(shown, "On x2, bold and code <b>");
    let rest = [
        ("docs/b.md", "# 1. Two\n"),
        ("docs/c.md", "# Three\n"),
        ("docs/d.md", ""),
    ];
    let (_, shown) = head(&[rest[0], rest[1]]);
    assert_eq!(shown, "1. Two and Three");
    let (_, shown) = head(&rest);
    assert_eq!(shown, "1. Two, Three and 1 more");
    assert!(built_in().contains("<h1>The report on Newton’s cradle</h1>"));
}

#[test]
fn columns_are_aligned_lines_end_and_footnotes_are_led_to() {
    let page = page_of(&[(
        "a.md",
        "# A\n\nOne<br>two[^1] and[^x].\n\n| a | b | c |\n|:--|--:|:-:|\n| $x$ | 2 | 3 |\n\n- [x] done\n\n[^1]: The note $z$.\n\n[^x]: Another.\n",
    )]);
    let tree = tree(&page);
    assert!(page.contains("One<br/>\ntwo<sup><a href=\"#doc-1:note-1\">1</a></sup>"));
    assert!(page.contains("<td class=\"r\">2</td><td class=\"c\">3</td>"));
    assert!(page.contains("☑ done"));
    let note = tree
        .descendants()
        .find(|n| n.attribute("id") == Some("doc-1:note-2"));
    assert!(text_of(note.unwrap()).contains("Another."));
}

#[test]
fn a_finding_leads_into_the_evidence() {
    let page = built_in();
    let tree = tree(page);
    let findings = tree.descendants().filter(|n| has_class(n, "finding"));
    let links = findings.filter_map(|n| n.descendants().find_map(|n| n.attribute("href")));
    let mut led = 0;
    for link in links.filter(|link| link.starts_with("#eq-")) {
        let target = tree
            .descendants()
            .find(|n| n.attribute("id") == link.strip_prefix('#'));
        let target = target.unwrap_or_else(|| panic!("{link}"));
        assert!(
            target.ancestors().any(|n| n.tag_name().name() == "details"),
            "{link}"
        );
        led += 1;
    }
    assert!(led > 5);
}

#[test]
fn what_is_to_mend_has_one_colour_and_what_rests_on_an_error_says_so() {
    let page = built_in();
    let tree = tree(page);
    let statement = |id: &str| {
        let equation = tree.descendants().find(|n| n.attribute("id") == Some(id));
        let mut statements = equation.unwrap().descendants();
        statements.find(|n| has_class(n, "statement")).unwrap()
    };
    for id in ["eq-44", "eq-45", "eq-46"] {
        assert!(has_class(&statement(id), "mixed"), "{id}");
    }
    for id in ["eq-24", "eq-25", "eq-26"] {
        let verdict = statement(id)
            .descendants()
            .find(|n| has_class(n, "verdict"));
        assert!(text_of(verdict.unwrap()).contains("rests on (23)"), "{id}");
    }
}

#[test]
fn thousands_of_equations_stay_whole_and_linear() {
    let few = page_of(&[("few.md", &thousands(500))]);
    let start = Instant::now();
    let many = page_of(&[("many.md", &thousands(2_000))]);
    // A second or two without optimization, where nothing else is to be done.
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
    let shown = tree(&many)
        .descendants()
        .filter(|n| has_class(n, "equation"))
        .count();
    assert_eq!(shown, 2_000);
    assert!(
        many.len() < 5 * few.len(),
        "{} against {}",
        many.len(),
        few.len()
    );
}

#[test]
fn nothing_to_read_is_a_page_too() {
    for documents in [
        &[][..],
        &[("empty.md", "")],
        &[("words.md", "# Words\n\nOnly.\n")],
    ] {
        let page = page_of(documents);
        assert!(text_of(tree(&page).root()).contains("No displayed equation was found"));
    }
}

/// What parts the rows that share a number is no prose between them.
#[test]
fn nothing_stands_between_rows_of_one_number() {
    let source = "We have\n\n$$\n\\begin{aligned}\na &= b, \\\\\nb &= c,\n\\end{aligned} \\tag{1}\n$$\n\nand nothing else.\n";
    let page = page_of(&[("a.md", source)]);
    let document = tree(&page);
    let paragraphs = document.descendants().filter(|own| own.has_tag_name("p"));
    let said: Vec<String> = paragraphs.map(text_of).collect();
    let has = |text: &str| said.iter().any(|own| own.trim() == text);
    assert!(has("We have") && has("and nothing else."), "{said:?}");
    assert!(!said.iter().any(|own| own.contains('\\')), "{said:?}");
}
