//! Repairs in SARIF: each is put in where it says, and mends what it is for.

use std::collections::BTreeSet;
use std::path::Path;

use serde_json::Value;

use super::folder;
use super::sarif::{results, sarif};
use crate::common::{Audited, pages};

/// The byte at a line and a column, both from 1, columns in characters.
fn offset(text: &str, line: u64, column: u64) -> usize {
    let start: usize = text
        .split_inclusive('\n')
        .take(line as usize - 1)
        .map(str::len)
        .sum();
    let own = &text[start..];
    let mut characters = own.char_indices().map(|(at, _)| at);
    start + characters.nth(column as usize - 1).unwrap_or(own.len())
}

/// A repair of a text: what it replaces, by what, and the text that comes of it.
struct Repair {
    old: String,
    new: String,
    text: String,
}

fn repair(text: &str, fix: &Value) -> Repair {
    let replacement = &fix["artifactChanges"][0]["replacements"][0];
    let at = |line: &str, column: &str| {
        let number = |name: &str| replacement["deletedRegion"][name].as_u64().unwrap();
        offset(text, number(line), number(column))
    };
    let (start, end) = (at("startLine", "startColumn"), at("endLine", "endColumn"));
    let new = replacement["insertedContent"]["text"].as_str().unwrap();
    Repair {
        old: text[start..end].to_owned(),
        new: new.to_owned(),
        text: format!("{}{new}{}", &text[..start], &text[end..]),
    }
}

/// Where something is to be mended: the line, and what the equation is called.
type Place = (u64, String);

fn to_mend(result: &Value) -> bool {
    result["level"] != "note"
}

fn place(result: &Value) -> Place {
    let name = result["locations"][0]["logicalLocations"][0]["name"].to_string();
    let line = "/locations/0/physicalLocation/region/startLine";
    (result.pointer(line).unwrap().as_u64().unwrap(), name)
}

/// Each repair that is offered for a text, put in by itself. What was derived from the slip may need mending then; nothing else may.
fn repairs(scratch: &Path, name: &str, text: &str) -> Vec<Repair> {
    let audited = |text: &str| {
        std::fs::write(scratch.join(name), text).unwrap();
        let mut all = results(&sarif(scratch, &["check", name, "--no-config"]));
        all.retain(to_mend);
        all
    };
    let before = audited(text);
    let places: BTreeSet<Place> = before.iter().map(place).collect();
    let with_fix = before.iter().filter(|r| r.get("fixes").is_some());
    let applied = with_fix.map(|result| {
        let repair = repair(text, &result["fixes"][0]);
        let after: BTreeSet<Place> = audited(&repair.text).iter().map(place).collect();
        assert!(!after.contains(&place(result)), "{}", repair.text);
        let others: Vec<&Place> = after.difference(&places).collect();
        assert!(others.is_empty(), "{others:?} in {}", repair.text);
        repair
    });
    applied.collect()
}

#[test]
fn a_repair_mends_the_equation_and_leaves_the_others() {
    // A slip in each place where one can be, among them behind a command and behind letters that are no ASCII.
    let text = "<!-- check: symbols t, g, h, v: positive -->\n<!-- check: law -->\n$$ v = g t \\tag{1} $$\n\n\
        <!-- check: law -->\n$$ h = \\frac12 g t^2 \\tag{2} $$\n\nBy (1) and (2) (größer),\n\n\
        $$ h = \\frac{v^2}{3 g} \\tag{3} $$\n\nBy (1),\n\n$$ t = \\frac{g}{v} \\tag{4} $$\n";
    let found = repairs(&folder("fixes"), "page.md", text);
    let replaced: Vec<&str> = found.iter().map(|repair| repair.old.as_str()).collect();
    assert_eq!(replaced, [r"\frac{v^2}{3 g}", r"\frac{g}{v}"]);
}

/// A display in a document, and what is put in where; nothing where no repair can be offered.
const CHAINS: [(&str, &[(&str, &str)]); 12] = [
    // The left side of a row is what the row before says: it is right there.
    (
        r"\begin{align} x &= y + z \\ &= z + y \\ &= z + 2 y \end{align}",
        &[],
    ),
    (
        r"\begin{align} (a+b)^2 &= a (a + b) + b (a + b) \\ &= a^2 + b^2 \end{align}",
        &[],
    ),
    (
        r"\begin{align} (a+b)^2 &= a (a + b) + b (a + b) \\ &= a^2 + a b + b^2 \end{align}",
        &[("a^2 + a b + b^2", "a^2 + 2 a b + b^2")],
    ),
    // A member that disagrees with both neighbours is the wrong one, over rows too.
    (
        r"\begin{align} (a-b)^2 &= a^2 + 2 a b + b^2 \\ &= b^2 - 2 a b + a^2 \end{align}",
        &[("a^2 + 2 a b + b^2", "a^2 - 2 a b + b^2")],
    ),
    (
        r"\begin{align} (a-b)^2 &= a^2 + 2 a b + b^2 = b^2 - 2 a b + a^2 \\ &= (b - a)^2 \end{align}",
        &[("a^2 + 2 a b + b^2", "a^2 - 2 a b + b^2")],
    ),
    (
        r"\begin{equation} p (q + r) = p q - p r = r p + q p \end{equation}",
        &[("p q - p r", "p q + p r")],
    ),
    // The first of a chain, where all others agree.
    (
        r"\begin{equation} (p - q)^2 + 3 p q = p^2 + 2 p q + q^2 = (p + q)^2 \end{equation}",
        &[("(p - q)^2 + 3 p q", "(p - q)^2 + 4 p q")],
    ),
    // The last of one.
    (
        r"\begin{equation} (p - q)^2 + 4 p q = p^2 + 2 p q + q^2 = (p - q)^2 \end{equation}",
        &[("(p - q)^2", "(p + q)^2")],
    ),
    // What follows agrees with the slip: to mend one member is not enough.
    (
        r"\begin{align} x (a + b) &= x a - x b \\ &= x (a - b) \end{align}",
        &[("x (a + b)", "x (a - b)")],
    ),
    (
        r"\begin{align} x &= a - (b - c) \\ &= a - b - c \\ &= a - (b + c) \end{align}",
        &[],
    ),
    // No edit mends the member.
    (
        r"\begin{equation} (p - q)^2 = p^2 + q (p - 2 p) = p^2 + q^2 - 2 q p \end{equation}",
        &[],
    ),
    // Over several rows an author has aligned it.
    (
        "\\begin{align} x &= a (b + c) \\nonumber \\\\ &= a b \\nonumber \\\\ &\\quad - a c \\end{align}",
        &[],
    ),
];

#[test]
fn in_a_chain_only_what_is_new_in_a_link_is_edited() {
    let scratch = folder("fixes-in-chains");
    for (display, wanted) in CHAINS {
        let text = format!(
            "\\documentclass{{article}}\n\\begin{{document}}\nIt is\n{display}\n\\end{{document}}\n"
        );
        let found = repairs(&scratch, "page.tex", &text);
        let found: Vec<(&str, &str)> = found
            .iter()
            .map(|repair| (repair.old.as_str(), repair.new.as_str()))
            .collect();
        assert_eq!(found, wanted, "{display}");
    }
}

#[test]
fn every_repair_of_the_test_pages_mends_what_it_is_for() {
    let scratch = folder("all-fixes");
    let is_refuted = |page: &&Audited| page.audit.entries.iter().any(|e| e.refuted().is_some());
    let refuted = pages().iter().filter(is_refuted);
    let mut texts: Vec<String> = refuted.map(|page| page.source.clone()).collect();
    let slips = include_str!("../repairs.md");
    texts.extend(slips.split("\n## ").skip(1).map(str::to_owned));
    let found = texts.iter().map(|text| repairs(&scratch, "page.md", text));
    let number: usize = found.map(|repairs| repairs.len()).sum();
    assert!(number > 60, "{number}");
}
