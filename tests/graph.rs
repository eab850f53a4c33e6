//! What rests on what, and what falls with what fails.

use std::time::{Duration, Instant};

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;
use cradle_verify::proofs;
use cradle_verify::report::Report;
use cradle_verify::report::graph::{Graph, Node, Status};

use crate::common;

/// Looks at the graph of a page.
fn graph<T>(source: &str, look: impl FnOnce(&Graph, &Report<'_>) -> T) -> T {
    of(&Derivation::from_markdown("page.md", source), look)
}

fn of<T>(derivation: &Derivation, look: impl FnOnce(&Graph, &Report<'_>) -> T) -> T {
    common::reported(derivation, |report| look(&Graph::of(report), report))
}

fn node<'a>(graph: &'a Graph, id: &str) -> &'a Node {
    graph.nodes.iter().find(|n| n.id == id).expect(id)
}

fn ids(graph: &Graph, nodes: &[usize]) -> Vec<String> {
    nodes.iter().map(|&at| graph.nodes[at].id.clone()).collect()
}

/// (2) is false; (3), (4) and (5) come from it, and (1) gives (3), and so (4), all the same.
const BOUNDS: &str = r"
<!-- check: symbols x: positive -->
<!-- check: law -->
$$ x \leq 3 \tag{1} $$
<!-- check: from (1) -->
$$ x \leq 1 \tag{2} $$
<!-- check: from (2) -->
$$ x \leq 4 \tag{3} $$
<!-- check: from (3) -->
$$ x \leq 5 \tag{4} $$
<!-- check: from (2) -->
$$ x \leq 2 \tag{5} $$
";

#[test]
fn what_falls_may_stand_on_its_own() {
    graph(BOUNDS, |graph, report| {
        assert_eq!(ids(graph, &node(graph, "2").falls), ["3", "4", "5"]);
        let status = |id| node(graph, id).status;
        assert_eq!(status("3"), Status::Stands);
        assert_eq!(status("4"), Status::Stands);
        assert_eq!(status("5"), Status::Falls);
        let text = anstream::adapter::strip_str(&graph.text(report)).to_string();
        assert!(
            text.contains("(2) fails; with it fall (3), (4) and (5)"),
            "{text}"
        );
        assert!(
            text.contains("(3)  stands on its own: it follows from (1)\n"),
            "{text}"
        );
        assert!(text.contains("(5)  no other way to it was found"), "{text}");
        let view = serde_json::to_value(graph.json(report)).unwrap();
        assert_eq!(
            view["nodes"][1]["falls_with"],
            serde_json::json!(["3", "4", "5"])
        );
        assert_eq!(view["nodes"][2]["rederived_from"], serde_json::json!(["1"]));
        assert!(view["nodes"][4].get("rederived_from").is_none());
    });
}

#[test]
fn what_fails_besides_rests_on_what_it_is_derived_from() {
    let page = BOUNDS.replace("x \\leq 2 \\tag{5}", "x \\leq 1/2 \\tag{5}");
    graph(&page, |graph, report| {
        assert_eq!(node(graph, "5").status, Status::Fails);
        let text = anstream::adapter::strip_str(&graph.text(report)).to_string();
        for told in [
            "(2) fails; with it fall (3) and (4); (5) is derived from it and fails too",
            "(5) fails; nothing rests on it",
            "Of 5 statements, 2 fail; 2 fall with them, and 2 of these stand on their own.",
        ] {
            assert!(text.contains(told), "{told}: {text}");
        }
        let edge = graph.edges.iter().find(|(_, to)| *to == 4).unwrap();
        assert!(graph.is_broken(*edge));
    });
}

#[test]
fn what_the_author_crosses_out_takes_nothing_with_it() {
    let page = "$$ a = 1 \\tag{1} $$\n\nCompare (1):\n\n$$ a = 2 \\times \\tag{2} $$\n";
    graph(page, |graph, _| {
        assert_eq!(node(graph, "2").status, Status::CrossedOut);
        assert!(graph.nodes.iter().all(|n| n.falls.is_empty()));
    });
}

#[test]
fn the_graph_of_the_report() {
    of(&proofs::report(), |graph, report| {
        assert_eq!(ids(graph, &node(graph, "23").falls), ["24", "25", "26"]);
        // What falls is what the audit says rests on something.
        for (node, entry) in graph.nodes.iter().zip(&report.audit.entries) {
            assert_eq!(
                node.rests_on.is_empty(),
                entry.rests_on.is_empty(),
                "{}",
                node.id
            );
        }
        insta::assert_snapshot!(
            "report",
            anstream::adapter::strip_str(&graph.text(report)).to_string()
        );
    });
}

/// What holds a drawing together: no box lies on another, and none out of the picture.
#[test]
fn a_drawing_is_legible() {
    of(&proofs::report(), |graph, _| {
        let linked = graph.svg_linked(&|at| format!("#node-{at}"));
        for at in 0..graph.nodes.len() {
            assert_eq!(linked.matches(&format!("href=\"#node-{at}\"")).count(), 1);
        }
        legible(&graph.svg());
        legible(&linked);
    });
}

fn legible(svg: &str) {
    let number = |text: &str, key: &str| -> i64 {
        let rest = &text[text.find(key).expect(key) + key.len()..];
        rest[..rest.find('"').unwrap()].parse().unwrap()
    };
    // Pieces stand one below the other, with no gap and nothing twice.
    let width = number(svg, " width=\"");
    let mut height = 0;
    for piece in svg.split("<svg ").skip(1) {
        let tall = number(piece, " height=\"");
        let seen = format!("viewBox=\"0 {height} {width} {tall}\"");
        assert!(piece.contains(&seen), "{piece}");
        height += tall;
    }
    let boxes: Vec<[i64; 4]> = svg
        .split("<rect class=\"cv-box\"")
        .skip(1)
        .map(|r| [" x=\"", " y=\"", " width=\"", " height=\""].map(|key| number(r, key)))
        .collect();
    assert!(boxes.len() > 90, "{}", boxes.len());
    for (at, a) in boxes.iter().enumerate() {
        assert!(
            a[0] >= 0 && a[0] + a[2] <= width && a[1] + a[3] <= height,
            "{a:?}"
        );
        for b in boxes[..at].iter().filter(|b| b[3] == 26 && a[3] == 26) {
            let apart = |i: usize| a[i] + a[i + 2] <= b[i] || b[i] + b[i + 2] <= a[i];
            assert!(apart(0) || apart(1), "{a:?} on {b:?}");
        }
    }
}

/// What stands in the way of lines: statements and titles, as left, top, right and bottom.
fn obstacles(drawing: &str) -> Vec<[f64; 4]> {
    let after = |text: &str, key: &str| {
        let rest = &text[text.find(key).expect(key) + key.len()..];
        let end = rest.find(|c: char| c != '-' && c != '.' && !c.is_ascii_digit());
        rest[..end.unwrap_or(rest.len())].parse::<f64>().unwrap()
    };
    let mut all = Vec::new();
    for line in drawing.lines() {
        if line.contains("cv-node") {
            // A rectangle, or the path of an octagon whose corners are cut.
            let (x, y, width) = match line.find("<rect ") {
                Some(at) => {
                    let rect = &line[at..];
                    let [x, y, width] = [" x=\"", " y=\"", " width=\""].map(|k| after(rect, k));
                    (x, y, width)
                }
                None => {
                    let path = &line[line.find("cv-box").unwrap()..];
                    let path = &path[path.find(" d=\"M").unwrap() + 4..];
                    let (x, y) = (after(path, "M") - 8.0, after(path, " "));
                    (x, y, after(path, "H") + 8.0 - x)
                }
            };
            all.push([x, y, x + width, y + 26.0]);
        } else if line.contains("cv-title") {
            let (x, y) = (after(line, " x=\""), after(line, " y=\""));
            let title = &line[line.find("\"600\">").unwrap() + 6..line.find("</text>").unwrap()];
            all.push([x, y - 12.0, x + 6.0 * title.chars().count() as f64, y + 3.0]);
        }
    }
    all
}

/// Points of a path, close to each other.
fn points(path: &str) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut rest = path;
    while let Some(command) = rest.chars().next() {
        let end = rest[1..].find(|c: char| c.is_ascii_alphabetic());
        let end = end.map_or(rest.len(), |end| end + 1);
        let numbers: Vec<f64> = rest[1..end]
            .split([' ', ','])
            .map(|n| n.parse().unwrap())
            .collect();
        let from = points.last().copied().unwrap_or_default();
        let stops: Vec<[f64; 2]> = match command {
            'H' => vec![[numbers[0], from[1]]],
            'V' => vec![[from[0], numbers[0]]],
            _ => numbers.chunks(2).map(|n| [n[0], n[1]]).collect(),
        };
        // De Casteljau's way, whatever the degree.
        for step in 1..=if command == 'M' { 1 } else { 200 } {
            let share = if command == 'M' {
                1.0
            } else {
                f64::from(step) / 200.0
            };
            let mut hull = vec![from];
            hull.extend(&stops);
            while hull.len() > 1 {
                let between = |a: f64, b: f64| a + share * (b - a);
                hull = hull
                    .windows(2)
                    .map(|w| [between(w[0][0], w[1][0]), between(w[0][1], w[1][1])])
                    .collect();
            }
            points.push(hull[0]);
        }
        rest = &rest[end..];
    }
    points
}

/// Looks at the paths of all lines in a drawing, and says how many there are.
fn runs_around_everything(svg: &str) -> usize {
    let mut number = 0;
    for drawing in svg.split(")\">\n").skip(1) {
        let obstacles = obstacles(drawing);
        for line in drawing.lines().filter(|line| line.contains("\"cv-edge")) {
            let path = &line[line.find(" d=\"").unwrap() + 4..line.rfind('"').unwrap()];
            number += 1;
            for [x, y] in points(path) {
                for [left, top, right, bottom] in &obstacles {
                    let is_within =
                        left + 1.0 < x && x < right - 1.0 && top + 1.0 < y && y < bottom - 1.0;
                    assert!(
                        !is_within,
                        "{path} at {x} {y} in {left} {top} {right} {bottom}"
                    );
                }
            }
        }
    }
    number
}

#[test]
fn no_line_runs_behind_a_statement_or_a_title() {
    of(&proofs::report(), |graph, _| {
        assert!(runs_around_everything(&graph.svg()) > graph.edges.len());
        assert!(runs_around_everything(&graph.svg_linked(&|at| format!("#{at}"))) > 100);
    });
    of(&proofs::corrected::corrected(), |graph, _| {
        assert!(runs_around_everything(&graph.svg()) > 100);
    });
}

/// Long chains that go on below, steps that lean on what stands far off, and on what comes only later.
#[test]
fn lines_of_a_long_document_run_around_everything() {
    let mut page = String::from("<!-- check: symbols x: positive -->\n");
    for at in 1..=90 {
        let premises = match at {
            1..=3 => String::from("<!-- check: law -->\n"),
            _ => {
                let cited = [at - 1, at / 2, if at % 7 == 0 { at + 2 } else { at - 3 }];
                let cited: Vec<String> = cited.iter().map(|c| format!("({c})")).collect();
                format!("<!-- check: from {} -->\n", cited.join(", "))
            }
        };
        page += &format!("{premises}$$ x \\leq {at} \\tag{{{at}}} $$\n");
    }
    graph(&page, |graph, _| {
        assert!(runs_around_everything(&graph.svg()) > 90);
        assert!(runs_around_everything(&graph.svg_linked(&|at| format!("#{at}"))) > 90);
    });
}

#[test]
fn names_cannot_break_out_of_a_drawing() {
    let page =
        "# <script>\"&\\\n\n$$ x = \"1 \\tag{<b>\"\\&} $$\n\n$$ y = 2 \\tag{]]>-->\"];} $$\n";
    graph(page, |graph, _| {
        for svg in [graph.svg(), graph.svg_linked(&|_| "#\"><script>".into())] {
            assert!(!svg.contains("<script>") && !svg.contains("<b>"), "{svg}");
        }
        for line in graph.dot().lines() {
            let quotes = line.replace("\\\\", "").replace("\\\"", "");
            assert_eq!(quotes.matches('"').count() % 2, 0, "{line}");
        }
    });
}

#[test]
fn two_thousand_equations_are_drawn_in_time() {
    let mut page = String::from(
        "<!-- check: symbols x: positive -->\n<!-- check: law -->\n$$ x \\leq 3 \\tag{1} $$\n",
    );
    page += "<!-- check: from (1) -->\n$$ x \\leq 1 \\tag{2} $$\n";
    for at in 3..=2000 {
        page += &format!(
            "<!-- check: from ({}) -->\n$$ x \\leq {at} \\tag{{{at}}} $$\n",
            at - 1
        );
    }
    let derivation = Derivation::from_markdown("page.md", &page);
    let audit = Audit::of(&derivation);
    let report = Report {
        derivation: &derivation,
        audit: &audit,
        paths: &[],
    };
    let start = Instant::now();
    let graph = Graph::of(&report);
    assert_eq!(node(&graph, "2").falls.len(), 1998);
    assert!(graph.svg().len() + graph.dot().len() + graph.text(&report).len() > 100_000);
    assert!(
        start.elapsed() < Duration::from_secs(20),
        "{:?}",
        start.elapsed()
    );
}
