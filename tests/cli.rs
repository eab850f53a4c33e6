//! The program from outside: exit codes, each command, and input that a careless world sends.

use std::path::PathBuf;
use std::process::{Output, Stdio};

use cradle_verify::cli::progress::bar;

use crate::common::{self, code, command, err, out, piped, run as program};
use serde_json::Value;

/// A directory of this test's own with one document in it.
fn page(test: &str, source: &[u8]) -> PathBuf {
    let path = common::folder(&format!("cli/{test}")).join("page.md");
    std::fs::write(&path, source).unwrap();
    path
}

fn check(test: &str, source: &str) -> Output {
    program(&["check", page(test, source.as_bytes()).to_str().unwrap()])
}

#[test]
fn the_built_in_report_is_audited() {
    let output = program(&[]);
    assert_eq!(code(&output), 1, "{}", err(&output));
    let text = out(&output);
    assert!(
        text.contains("(23)") && text.contains("error[fails]: equation (23)"),
        "{text}"
    );
    assert!(!text.contains('\u{1b}'), "colours without a terminal");
    assert!(err(&output).is_empty());
    let wide = text
        .lines()
        .find(|l| l.starts_with("  (") && l.chars().count() > 100);
    assert_eq!(wide, None);
}

#[test]
fn the_output_is_always_the_same() {
    assert_eq!(program(&[]).stdout, program(&[]).stdout);
}

#[test]
fn any_number_of_threads_says_the_same() {
    // Long enough for its displays to be shared out.
    let step = |at: usize| {
        format!(
            "$$ a_{at} = b + {at} \\tag{{{at}}} $$\n\nBy ({at}),\n$$ b = a_{at} - {at} $$\n\nHence\n$$ b > 2 a_{at} $$\n\n"
        )
    };
    let long = page("jobs", (0..100).map(step).collect::<String>().as_bytes());
    let long = long.to_str().unwrap();
    for format in ["human", "json"] {
        let by = |jobs: &str| program(&["check", long, "--format", format, "--jobs", jobs]);
        let one = by("1");
        assert_eq!(code(&one), 1, "{}", err(&one));
        for jobs in ["2", "5", "1000"] {
            assert_eq!(by(jobs).stdout, one.stdout, "{jobs}");
        }
    }
    let nobody = program(&["check", long, "--jobs", "0"]);
    assert_eq!(code(&nobody), 2);
    assert!(err(&nobody).contains("--jobs"), "{}", err(&nobody));
}

#[test]
fn what_is_true_instead_is_built_in_too() {
    let output = program(&["--builtin", "corrected"]);
    assert_eq!(code(&output), 0, "{}", out(&output));
    assert!(
        out(&output).ends_with("Nothing is amiss.\n"),
        "{}",
        out(&output)
    );
    let folder = program(&["check", "proofs/corrected"]);
    assert_eq!((code(&folder), out(&folder)), (0, out(&output)));
    let one = program(&["explain", "P5", "--builtin", "corrected"]);
    assert_eq!(code(&one), 0);
    assert!(
        out(&one).contains("Σ_{i≤N} x_i² (1 − x_i)²"),
        "{}",
        out(&one)
    );
    let report = program(&["--builtin", "report"]);
    assert_eq!((code(&report), out(&report)), (1, out(&program(&[]))));
    for wrong in [
        &["--builtin", "wrong"][..],
        &["check", "proofs", "--builtin", "corrected"],
        &["explain", "23", "proofs/report", "--builtin", "report"],
        &["simulate", "--builtin", "corrected"],
        &["--scenario", "A", "--builtin", "corrected"],
        &["explain", "23", "--builtin", "corrected"],
    ] {
        let output = program(wrong);
        assert_eq!(code(&output), 2, "{wrong:?}");
        assert!(out(&output).is_empty());
        assert!(err(&output).starts_with("error: "), "{}", err(&output));
    }
}

#[test]
fn scenarios_by_letter() {
    for (letter, expected) in [("A", 1), ("B", 0), ("C", 1), ("D", 0), ("c", 1), ("b", 0)] {
        assert_eq!(
            code(&program(&["--scenario", letter])),
            expected,
            "{letter}"
        );
    }
    for letter in ["E", "", "AB", "é"] {
        let output = program(&["--scenario", letter]);
        assert_eq!(code(&output), 2);
        assert!(err(&output).contains("A, B, C, D"), "{}", err(&output));
    }
}

#[test]
fn scenarios_of_ones_own() {
    let run = |before, after, more: &[&str]| {
        program(&[&["scenario", "--before", before, "--after", after], more].concat())
    };
    assert_eq!(code(&run("1,1,0,0,0", "0,0,0,0,2", &[])), 1);
    assert_eq!(code(&run("1,0", "0,1", &[])), 0);
    assert_eq!(code(&run("-1,0.5", "-1,1/2", &[])), 0);
    assert_eq!(code(&run("1,0", "-1/3,2/3", &["--masses", "1,2"])), 0);
    for (before, after, more) in [
        ("1,x", "0,1", &[][..]),
        ("1,0", "0", &[]),
        ("1/0", "1", &[]),
        ("", "", &[]),
        ("1", "1", &["--masses", "-1"]),
    ] {
        let output = run(before, after, more);
        assert_eq!(code(&output), 2, "{before} {after}");
        assert!(err(&output).starts_with("error: "));
        assert!(out(&output).is_empty());
    }
    let json = run("1,0", "0,1", &["--format", "json"]);
    let value: Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(value["holds"], true);
    // Both laws hold where nothing happens, and yet the balls cannot stay as they are: one is behind a faster one.
    for (before, after, possible) in [
        ("1,0", "0,1", Value::Bool(true)),
        ("1,0", "1,0", Value::Bool(false)),
        ("1,0", "1,1", Value::Bool(false)),
        ("1,0,0", "-1/3,2/3,2/3", Value::Null),
    ] {
        let output = run(before, after, &["--format", "json"]);
        let value: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(value["possible"], possible, "{before} {after}");
    }
}

#[test]
fn a_counterexample_says_what_else_is_true_there() {
    let text = out(&program(&["explain", "23"]));
    for line in [
        "So is what is given before and not cited:",
        "n v₀ = Σ_{i=1}^{k} u_i:  left = 1, right = 1   (17)",
        "n v₀² = Σ_{i=1}^{k} u_i²:  left = 1, right = 1   (18)",
    ] {
        assert!(text.contains(line), "{text}");
    }
    assert!(!text.contains("u_i = Σ"), "{text}");
    // Where a chain of elements is to be shown, their values are what there is to see.
    let text = out(&program(&["explain", "n-in-n-out"]));
    let line = "u₁ = … = u_k = v₀:  k = 3, v₀ = 3, u = (1, 1, 4)";
    assert!(text.contains(line), "{text}");
}

#[test]
fn an_even_power_is_positive_where_its_base_does_not_vanish() {
    let text = out(&program(&[
        "explain",
        "4",
        "tests/pages/completing-the-square.md",
    ]));
    assert!(text.contains("where a ≠ 0 by [2], so (a)² > 0"), "{text}");
}

#[test]
fn simulations_say_what_comes_out() {
    let run = |more: &[&str]| program(&[&["simulate"], more].concat());
    let text = |more: &[&str]| {
        let output = run(more);
        assert_eq!(code(&output), 0, "{more:?}: {}", err(&output));
        out(&output)
    };
    let pairwise = text(&["--balls", "5", "--in", "2"]);
    assert!(
        pairwise.contains("velocity after    0   0   0   1   1\n"),
        "{pairwise}"
    );
    assert!(pairwise.contains("6 collisions") && pairwise.contains("exact"));
    assert!(text(&[]).contains("velocity after    0   0   0   0   1\n"));
    let damped = text(&["--restitution", "9/10"]);
    assert!(
        damped.contains("130321/160000") && damped.contains("heat and sound"),
        "{damped}"
    );
    assert!(text(&["--masses", "1,2,3"]).contains("velocity after    -1/3   -2/15   8/15"));
    let hertz = text(&["--model", "hertz", "--balls", "3"]);
    assert!(hertz.contains("-0.070952   0.076403   0.994549"), "{hertz}");
    assert!(
        hertz.contains("Numeric") && !hertz.contains("exact"),
        "{hertz}"
    );
}

#[test]
fn simulations_for_programs() {
    let json = |more: &[&str]| -> Value {
        let output = program(&[&["simulate", "--format", "json"], more].concat());
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let pairwise = json(&["--balls", "2", "--restitution", "1/2"]);
    assert_eq!(pairwise["exact"], true);
    assert_eq!(pairwise["after"], serde_json::json!(["1/4", "3/4"]));
    assert_eq!(pairwise["kinetic_energy"]["after"], "5/16");
    let hertz = json(&["--model", "hertz", "--in", "2"]);
    assert_eq!(hertz["exact"], false);
    let (after, errors) = (&hertz["after"], &hertz["errors"]);
    assert!((after[4].as_f64().unwrap() - 1.1397).abs() < 1e-4);
    assert!(errors[4].as_f64().unwrap() < 1e-6);
}

#[test]
fn simulations_that_mean_nothing_or_never_end() {
    for (args, said) in [
        (&["--balls", "0"][..], "1 to 1000 balls"),
        (&["--balls", "1001"], "1 to 1000 balls"),
        (&["--balls", "x"], "--balls"),
        (&["--in", "0"], "1 to 5 can come in"),
        (&["--in", "6"], "1 to 5 can come in"),
        (&["--masses", "1,2", "--balls", "3"], "--masses has 2"),
        (&["--masses", "1,-2"], "ball 2 has the mass -2"),
        (&["--masses", "1,y"], "`y` is not a number"),
        (&["--restitution", "11/10"], "between 0 and 1"),
        (&["--restitution", "-1"], "between 0 and 1"),
        (&["--restitution", "e"], "`e` is not a number"),
        (&["--restitution", "0"], "longer than 1000 bits"),
        (
            &["--balls", "1000", "--in", "500"],
            "after 20000 collisions",
        ),
        (&["--model", "hertz", "--restitution", "1/2"], "pairwise"),
        (&["--model", "hertz", "--masses", "1,1e-9"], "1.0e9 times"),
        (
            &["--model", "hertz", "--balls", "500"],
            "500 balls is too long",
        ),
        (&["--model", "newton"], "newton"),
    ] {
        let output = program(&[&["simulate"], args].concat());
        assert_eq!(code(&output), 2, "{args:?}");
        assert!(err(&output).starts_with("error: "), "{}", err(&output));
        assert!(err(&output).contains(said), "{args:?}: {}", err(&output));
        assert!(out(&output).is_empty());
    }
}

#[test]
fn a_document_without_faults() {
    let source =
        "<!-- check: given -->\n$$ a = b + c \\tag{1} $$\n\nSo\n\n$$ a - c = b \\tag{2} $$\n";
    let output = check("sound", source);
    assert_eq!(code(&output), 0, "{}", out(&output));
    assert!(out(&output).contains("Nothing is amiss"));
}

#[test]
fn a_false_step_is_found_with_numbers_and_place() {
    let source =
        "<!-- check: given -->\n$$ a = b + c \\tag{1} $$\n\nSo\n\n$$ a + c = b \\tag{2} $$\n";
    let output = check("false", source);
    assert_eq!(code(&output), 1);
    let text = out(&output);
    for part in [
        "error[fails]: equation (2)",
        "page.md:6:12",
        "left = ",
        "(1): a = b + c",
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
}

#[test]
fn a_directory_is_read_as_one_derivation() {
    let first = page("folder", b"<!-- check: given -->\n$$ a = b \\tag{1} $$\n");
    let folder = first.parent().unwrap();
    std::fs::create_dir(folder.join("sub")).unwrap();
    std::fs::write(
        folder.join("sub/z.md"),
        "From (1):\n\n$$ b = a \\tag{2} $$\n",
    )
    .unwrap();
    std::fs::write(folder.join("ignored.txt"), "$$ 1 = 2 $$").unwrap();
    let output = program(&["check", folder.to_str().unwrap()]);
    assert_eq!(code(&output), 0, "{}", out(&output));
    assert!(out(&output).contains("from (1)"));
}

#[test]
fn standard_input_is_a_document() {
    let page = "<!-- check: derived -->\n$$ 1 + 1 = 3 \\tag{1} $$";
    let output = piped(&["check", "-"], page);
    assert_eq!(code(&output), 1);
    assert!(
        out(&output).contains("standard input:2:"),
        "{}",
        out(&output)
    );
}

#[test]
fn what_cannot_be_read_at_all() {
    let absent = program(&["check", "no/such/file.md"]);
    assert_eq!(code(&absent), 2);
    assert!(err(&absent).contains("no/such/file.md"));
    let binary = page("binary", b"a\nb\xff");
    let output = program(&["check", binary.to_str().unwrap()]);
    assert_eq!(code(&output), 2);
    assert!(err(&output).contains("line 2"), "{}", err(&output));
    std::fs::remove_file(&binary).unwrap();
    let empty = program(&["check", binary.parent().unwrap().to_str().unwrap()]);
    assert_eq!(code(&empty), 2);
    assert!(err(&empty).contains("no Markdown document"));
    assert_eq!(code(&program(&["check"])), 2);
    assert_eq!(code(&program(&["nonsense"])), 2);
}

#[test]
fn what_cannot_be_read_in_a_document_is_a_finding() {
    let deep = format!("$$ a = {}x{} $$", "{".repeat(10_000), "}".repeat(10_000));
    for (test, source, expected) in [
        ("braces", "$$ a = \\frac{b $$", "error[unreadable]"),
        ("macro", "$$ a = \\foo b \\tag{1} $$", "`\\foo`"),
        (
            "twice",
            "$$ a = b \\tag{1} $$\n\nand\n\n$$ a = b \\tag{1} $$",
            "error[duplicate-tag]",
        ),
        (
            "missing",
            "<!-- check: given -->\n$$ a = b \\tag{1} $$\n\n<!-- check: from (9) -->\n$$ b = a \\tag{2} $$",
            "error[unknown-citation]",
        ),
        ("deep", &deep, "error[unreadable]"),
    ] {
        let output = check(test, source);
        assert_eq!(code(&output), 1, "{test}: {}", err(&output));
        assert!(out(&output).contains(expected), "{test}: {}", out(&output));
    }
}

#[test]
fn a_gigantic_power_ends_without_a_crash() {
    let output = check(
        "power",
        "<!-- check: derived -->\n$$ x^{1000000000} + y = (x + 1)^{1000000000} \\tag{1} $$",
    );
    assert!(matches!(code(&output), 0 | 1), "{}", err(&output));
    assert!(out(&output).contains("(1)"));
}

#[test]
fn a_document_without_equations_says_so() {
    let output = check("prose", "Only words.\n");
    assert_eq!(code(&output), 0);
    assert!(out(&output).contains("nothing was checked"));
}

#[test]
fn explanations_can_be_checked_by_hand() {
    let proof = out(&program(&["explain", "45"]));
    for part in [
        "Equation (45)",
        "proofs/report/3.1",
        "read as",
        "To show",
        "premise (42)",
        "G",
    ] {
        assert!(proof.contains(part), "{part} in {proof}");
    }
    let limit = out(&program(&["explain", "65"]));
    assert!(limit.contains("comes to"), "{limit}");
    let witness = program(&["explain", "(23)"]);
    assert_eq!(code(&witness), 1);
    for part in [
        "Counterexample",
        "Every premise is true",
        "left = ",
        "is false",
    ] {
        assert!(out(&witness).contains(part), "{part}");
    }
    assert!(out(&program(&["explain", "n-in-n-out"])).contains("Statement 2 of 2"));
    assert!(out(&program(&["explain", "claim cauchy-equality"])).contains("Step 1 of"));
}

#[test]
fn an_unknown_equation_is_refused_with_its_neighbours() {
    let output = program(&["explain", "233"]);
    assert_eq!(code(&output), 2);
    assert!(err(&output).contains("23"), "{}", err(&output));
    assert!(err(&program(&["explain", "n-in-n-ou"])).contains("n-in-n-out"));
    let own = page("explained", b"<!-- check: given -->\n$$ a = b \\tag{1} $$");
    assert_eq!(code(&program(&["explain", "1", own.to_str().unwrap()])), 0);
    assert_eq!(code(&program(&["explain", "2", own.to_str().unwrap()])), 2);
}

#[test]
fn what_was_understood_can_be_shown() {
    assert!(out(&program(&["--show-understood"])).contains("understood: k \\leq n"));
}

#[test]
fn colours_are_as_asked() {
    assert!(out(&program(&["--color", "always"])).contains('\u{1b}'));
    assert!(!out(&program(&["--color", "never"])).contains('\u{1b}'));
}

#[cfg(unix)]
#[test]
fn a_reader_who_stops_reading_is_no_error() {
    let mut child = command(&[])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(code(&output), 1, "{}", err(&output));
    assert!(err(&output).is_empty(), "{}", err(&output));
}

#[test]
fn json_is_as_the_schema_says() {
    let schema: Value = serde_json::from_str(include_str!("../docs/schema.json")).unwrap();
    let unread = page(
        "schema",
        "$$ a = \\foo $$\n\n<!-- chekc: -->\n\n<!-- check: nonsense -->\n".as_bytes(),
    );
    for args in [
        &["--format", "json"][..],
        &["explain", "33", "--format", "json"],
        &[
            "check",
            "tests/pages/lens.md",
            "--baseline",
            "proofs/report.baseline.json",
            "--format",
            "json",
        ],
        &["check", unread.to_str().unwrap(), "--format", "json"],
    ] {
        let value: Value = serde_json::from_slice(&program(args).stdout).unwrap();
        valid(&value, &schema, &schema, "$");
    }
    let value: Value = serde_json::from_slice(&program(&["--format", "json"]).stdout).unwrap();
    let equations = value["documents"].as_array().unwrap().iter();
    let equations: Vec<&Value> = equations
        .flat_map(|d| d["equations"].as_array().unwrap())
        .collect();
    let total: u64 = value["summary"]
        .as_object()
        .unwrap()
        .values()
        .map(|n| n.as_u64().unwrap())
        .sum();
    assert_eq!(total as usize, equations.len());
    let wrong = equations.iter().find(|e| e["tag"] == "23").unwrap();
    assert_eq!(wrong["verdict"], "fails");
    assert!(wrong["witness"]["k"].is_string());
    let family = &wrong["family"];
    assert_eq!(
        (&family["parameter"], &family["least"]),
        (&"n".into(), &2.into())
    );
    assert_eq!(family["values"]["k"], "n + 1");
    assert_eq!(family["first"]["u"].as_array().unwrap().len(), 3);
    let unnumbered = equations
        .iter()
        .find(|e| e["name"] == "n-in-n-out")
        .unwrap();
    assert!(unnumbered.get("tag").is_none() && unnumbered["part"] == 1);
}

#[test]
fn the_graph_is_given_in_every_format() {
    let schema: Value = serde_json::from_str(include_str!("../docs/graph.schema.json")).unwrap();
    let json = program(&["graph", "--format", "json"]);
    assert_eq!(code(&json), 1);
    let value: Value = serde_json::from_slice(&json.stdout).unwrap();
    valid(&value, &schema, &schema, "$");
    let nodes = value["nodes"].as_array().unwrap();
    let wrong = nodes.iter().find(|n| n["tag"] == "23").unwrap();
    assert_eq!(wrong["falls_with"], serde_json::json!(["24", "25", "26"]));
    for (format, begins) in [
        ("dot", "digraph "),
        ("svg", "<svg "),
        ("human", "115 statements"),
    ] {
        let once = out(&program(&["graph", "--format", format]));
        assert!(once.starts_with(begins), "{once}");
        assert_eq!(
            once,
            out(&program(&["--format", format, "graph"])),
            "{format}"
        );
    }
    let own = page("graph", b"$$ a = 1 \\tag{1} $$\n");
    let none = program(&["graph", own.to_str().unwrap()]);
    assert_eq!(code(&none), 0);
    assert!(out(&none).contains("Nothing fails, so nothing falls."));
    let elsewhere = program(&["--format", "dot"]);
    assert_eq!(code(&elsewhere), 2);
    assert!(err(&elsewhere).contains("only `graph` and `plot` draw"));
}

#[test]
fn what_each_premise_is_needed_for_is_shown_on_request() {
    let text = out(&program(&["explain", "24"]));
    assert!(text.contains("What each premise is needed for"), "{text}");
    assert!(text.contains("without (22): left "), "{text}");
    assert!(text.contains("without (23): left "), "{text}");
    assert!(!out(&program(&[])).contains("needed for"));
    let own = page(
        "unused",
        b"<!-- check: symbols m: positive -->\n<!-- check: law -->\n$$ F = m a \\tag{1} $$\n\n<!-- check: law -->\n$$ p = m v \\tag{2} $$\n\n\
By (1) and (2):\n$$ a = F/m \\tag{3} $$\n",
    );
    let own = own.to_str().unwrap();
    let (short, full) = (program(&["check", own]), program(&["explain", "3", own]));
    assert_eq!((code(&short), code(&full)), (0, 0));
    assert!(!out(&short).contains("to no use"));
    assert!(
        out(&full).contains("note        cites (2) to no use"),
        "{}",
        out(&full)
    );
    let json = out(&program(&["check", own, "--format", "json"]));
    assert!(json.contains("\"unused-premise\""), "{json}");
}

/// What a step before says of a new symbol has an exact value in a counterexample, and not the one that it has at `22/7` for π.
#[test]
fn what_was_put_in_is_exact_in_pi() {
    let own = page(
        "falling",
        b"The friction on a sphere is\n\n$$ f = 6\\pi\\eta a v \\tag{1} $$\n\nand its weight less the lift is\n\n\
$$ w = \\frac43 \\pi a^3 g \\tag{2} $$\n\nAt the final speed both are the same, $f = w$. Then the power lost is\n\n\
$$ P = f v = \\frac{8\\pi a^5 g^2}{9\\eta} \\tag{3} $$\n",
    );
    let json = out(&program(&[
        "check",
        own.to_str().unwrap(),
        "--format",
        "json",
    ]));
    let json: Value = serde_json::from_str(&json).unwrap();
    let equations = json["documents"][0]["equations"].as_array().unwrap();
    let last = equations.last().unwrap();
    assert_eq!(last["verdict"], "fails");
    let text = last.to_string();
    let power = text.find("\"P\":").map(|at| &text[at..]).unwrap();
    assert!(
        power.starts_with("\"P\":{\"in_pi\":[\"0\",\"4/3\"]}"),
        "{text}"
    );
    let explained = out(&program(&["explain", "3", own.to_str().unwrap()]));
    assert!(explained.contains("P = (4/3) π"), "{explained}");
    assert!(!explained.contains("88/21"), "{explained}");
}

/// Whether a text matches one of the patterns that the schemas use.
fn matches(pattern: &str, text: &str) -> bool {
    if pattern.starts_with("sqrt") {
        return text.contains("sqrt(") || text.contains("root of ");
    }
    assert_eq!(pattern, "^-?[0-9]+(/[0-9]+)?$");
    let mut parts = text.strip_prefix('-').unwrap_or(text).split('/');
    let whole = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
    parts.clone().count() <= 2 && parts.all(whole)
}

/// The part of JSON Schema that the schemas in docs/ use.
fn valid(value: &Value, schema: &Value, root: &Value, place: &str) {
    let keys = schema.as_object().unwrap();
    for (key, rule) in keys {
        match key.as_str() {
            "$ref" => {
                let pointer = rule.as_str().unwrap().trim_start_matches('#');
                valid(value, root.pointer(pointer).unwrap(), root, place);
            }
            "type" => {
                let right = match rule.as_str().unwrap() {
                    "object" => value.is_object(),
                    "array" => value.is_array(),
                    "string" => value.is_string(),
                    "integer" => value.is_u64(),
                    other => panic!("type {other}"),
                };
                assert!(right, "{place}: {value} is no {rule}");
            }
            "enum" => assert!(rule.as_array().unwrap().contains(value), "{place}: {value}"),
            "minimum" => assert!(value.as_u64() >= rule.as_u64(), "{place}: {value}"),
            "required" => {
                for name in rule.as_array().unwrap() {
                    assert!(
                        value.get(name.as_str().unwrap()).is_some(),
                        "{place}: {name}"
                    );
                }
            }
            "items" => {
                for (at, item) in value.as_array().unwrap().iter().enumerate() {
                    valid(item, rule, root, &format!("{place}[{at}]"));
                }
            }
            "minItems" | "maxItems" => {
                let (length, bound) = (
                    value.as_array().unwrap().len() as u64,
                    rule.as_u64().unwrap(),
                );
                let right = match key.as_str() {
                    "minItems" => length >= bound,
                    _ => length <= bound,
                };
                assert!(right, "{place}: {length} items");
            }
            "properties" | "additionalProperties" => {}
            "anyOf" => {
                let resolved = |choice: &Value| match choice.get("$ref").and_then(Value::as_str) {
                    Some(pointer) => root.pointer(pointer.trim_start_matches('#')).cloned(),
                    None => Some(choice.clone()),
                };
                let fits = |choice: &Value| {
                    let kind = match value {
                        Value::String(_) => "string",
                        Value::Array(_) => "array",
                        _ => "object",
                    };
                    let pattern = choice.get("pattern").and_then(Value::as_str);
                    let text = value.as_str().unwrap_or_default();
                    choice["type"] == kind && pattern.is_none_or(|own| matches(own, text))
                };
                let mut choices = rule.as_array().unwrap().iter().filter_map(resolved);
                let choice = choices.find(fits);
                let choice = choice.unwrap_or_else(|| panic!("{place}: {value} is none of {rule}"));
                valid(value, &choice, root, place);
            }
            "pattern" => {
                let text = value.as_str().unwrap();
                assert!(matches(rule.as_str().unwrap(), text), "{place}: {text}");
            }
            "$schema" | "title" | "description" | "$defs" => {}
            other => panic!("the schema uses `{other}`"),
        }
    }
    let Some(object) = value.as_object() else {
        return;
    };
    for (name, item) in object {
        let place = format!("{place}.{name}");
        match (
            schema.get("properties").and_then(|p| p.get(name)),
            schema.get("additionalProperties"),
        ) {
            (Some(rule), _) => valid(item, rule, root, &place),
            (None, Some(rule)) if rule.is_object() => valid(item, rule, root, &place),
            (None, Some(_)) => panic!("{place} is not in the schema"),
            (None, None) => {}
        }
    }
}

#[test]
fn the_bar_has_one_length() {
    for done in [0, 1, 7, 10, 11] {
        let shown = bar(done, 10);
        let inside = shown.split(['[', ']']).nth(1).unwrap_or_default();
        assert_eq!(inside.len(), 30, "{shown}");
    }
    assert!(bar(5, 10).starts_with("auditing [===============  "));
}
