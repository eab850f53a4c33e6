use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::common::{self, code, out, run};

/// What it says, where it does the job.
fn says(args: &[&str]) -> String {
    let output = run(args);
    assert_eq!(code(&output), 0, "{args:?}: {output:?}");
    out(&output)
}

/// What it complains of, where it does not; nothing is on standard output.
fn complains(args: &[&str]) -> String {
    let output = run(args);
    assert_eq!(code(&output), 2, "{args:?}: {output:?}");
    assert!(output.stdout.is_empty(), "{args:?}");
    common::err(&output)
}

fn folder(test: &str) -> PathBuf {
    common::folder(&format!("figures-{test}"))
}

fn files(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn without_a_file_the_picture_is_on_standard_output() {
    for figure in ["collision", "energy", "lithotripsy", "outcomes"] {
        assert!(says(&["plot", figure]).starts_with("<svg "), "{figure}");
    }
}

#[test]
fn the_ending_says_what_is_written_and_what_was_there_is_replaced() {
    let folder = folder("endings");
    let begins: [(&str, &[u8]); 5] = [
        ("a.svg", b"<svg "),
        ("b.PNG", b"\x89PNG"),
        ("c.pdf", b"%PDF-"),
        ("d.json", b"{"),
        ("e.csv", b"mu,"),
    ];
    for (name, beginning) in begins {
        let path = folder.join(name);
        std::fs::write(&path, "what was there").unwrap();
        assert_eq!(
            says(&["plot", "collision", "-o", path.to_str().unwrap()]),
            ""
        );
        assert!(
            std::fs::read(&path).unwrap().starts_with(beginning),
            "{name}"
        );
    }
    assert_eq!(
        files(&folder),
        ["a.svg", "b.PNG", "c.pdf", "d.json", "e.csv"]
    );
}

#[test]
fn what_cannot_be_written_is_an_error_and_leaves_nothing() {
    let folder = folder("errors");
    let path = |name: &str| folder.join(name).to_str().unwrap().to_owned();
    std::fs::create_dir(folder.join("taken.svg")).unwrap();
    assert!(complains(&["plot", "collision", "-o", &path("a.gif")]).contains("`.gif`"));
    assert!(complains(&["plot", "collision", "-o", &path("none")]).contains("no ending"));
    assert!(
        complains(&["plot", "energy", "-o", &path("no/such/a.svg")])
            .contains("could not be written")
    );
    assert!(complains(&["plot", "energy", "-o", &path("taken.svg")]).contains("no file"));
    let both = complains(&["plot", "energy", "-o", &path("a.svg"), "--format", "csv"]);
    assert!(both.contains("two things"), "{both}");
    let foreign = complains(&[
        "plot",
        "energy",
        "--material",
        "鋼=1/2",
        "-o",
        &path("a.png"),
    ]);
    assert!(
        foreign.contains('鋼') && foreign.contains("SVG"),
        "{foreign}"
    );
    assert_eq!(files(&folder), ["taken.svg"]);
}

#[test]
fn the_numbers_come_as_json_and_csv() {
    let json: Value = serde_json::from_str(&says(&["plot", "energy", "--format", "json"])).unwrap();
    assert_eq!(json["columns"][1], "steel printed");
    assert_eq!(json["rows"][1][1], "2401/2500");
    assert_eq!(json["rows"][1][2], "4901/5000");
    assert_eq!(json["sources"][0]["equation"], "(41)");
    assert_eq!(json["sources"][0]["verdict"], "fails");
    let csv = says(&["plot", "collision", "--format", "csv"]);
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("mu,v1/v0,v2/v0,eta"));
    assert!(lines.any(|line| line == "3,-0.5,0.5,0.75"), "{csv}");
}

#[test]
fn materials_replace_the_list() {
    let csv = says(&[
        "table",
        "--format",
        "csv",
        "--material",
        "cork=3/5",
        "--material",
        "a=b=0.5",
    ]);
    assert_eq!(
        csv,
        "material,e,loss_printed,half_printed,loss_restitution,half_restitution\n\
         cork,0.6,0.64,1,0.32,2\n\
         a=b,0.5,0.75,1,0.375,2\n"
    );
}

#[test]
fn the_ends_of_the_range_are_spoken_of() {
    let text = says(&["table", "--material", "ideal=1", "--material", "putty=0"]);
    assert!(
        text.contains("At e = 1 nothing is lost, and the energy never halves."),
        "{text}"
    );
    assert!(text.contains("At e = 0 the balls stay together"), "{text}");
    assert!(text.contains("by restitution 50 %"), "{text}");
    let csv = says(&["table", "--format=csv", "--material", "ideal=1"]);
    assert!(csv.ends_with("ideal,1,0,never,0,never\n"), "{csv}");
    let json: Value = serde_json::from_str(&says(&[
        "table",
        "--format",
        "json",
        "--material",
        "ideal=1",
    ]))
    .unwrap();
    assert_eq!(json["rows"][0]["printed"]["half_after"], Value::Null);
}

#[test]
fn long_numbers_are_rounded_for_people_alone() {
    let given = [
        "--material",
        "third=1/3",
        "--material",
        "fine=0.999999999999999",
    ];
    let text = says(&[&["table"][..], &given].concat());
    assert!(
        text.contains("≈ 88.888889 %") && text.contains("< 0.000001 %"),
        "{text}"
    );
    let csv = says(&[&["table", "--format", "csv"][..], &given].concat());
    assert!(csv.contains("third,1/3,8/9,1,4/9,2\n"), "{csv}");
    assert!(
        csv.contains("fine,0.999999999999999,0.000000000000001999999999999999,"),
        "{csv}"
    );
}

#[test]
fn the_table_is_there_in_every_format() {
    insta::assert_snapshot!("table", says(&["table"]));
    insta::assert_snapshot!("table_markdown", says(&["table", "--format", "markdown"]));
    let csv = says(&["table", "--format", "csv"]);
    let json: Value = serde_json::from_str(&says(&["table", "--format", "json"])).unwrap();
    for (line, row) in csv.lines().skip(1).zip(json["rows"].as_array().unwrap()) {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells[0], row["material"]);
        assert_eq!(cells[3], row["printed"]["half_after"]);
        assert_eq!(cells[5], row["restitution"]["half_after"]);
    }
}

#[test]
fn numbers_of_one_column_have_as_many_digits_each() {
    let svg = says(&["plot", "energy"]);
    for written in ["0.98", "0.95", "0.9", "0.7"] {
        assert!(
            svg.contains(&format!("= {written}<")) || svg.contains(&format!("\u{a0}{written}<")),
            "{svg}"
        );
    }
    let given = ["--material=a=1", "--material=b=1/3", "--material=c=0.25"];
    let text = says(&[&["table"][..], &given].concat());
    let lines: Vec<Vec<&str>> = text
        .lines()
        .map(|line| {
            line.split("   ")
                .map(str::trim)
                .filter(|cell| !cell.is_empty())
                .collect()
        })
        .collect();
    let column = |at: usize| -> Vec<&str> { lines[3..6].iter().map(|line| line[at]).collect() };
    assert_eq!(column(1), ["1.00", "1/3", "0.25"]);
    assert_eq!(column(2), ["0.00 %", "≈ 88.888889 %", "93.75 %"]);
}

#[test]
fn the_ending_says_how_a_table_is_written() {
    let folder = folder("table-endings");
    for (name, beginning) in [
        ("a.csv", "material,e,"),
        ("b.json", "{"),
        ("c.md", "| material |"),
        ("d.txt", "Energy lost"),
    ] {
        let path = folder.join(name);
        assert_eq!(says(&["table", "-o", path.to_str().unwrap()]), "");
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.starts_with(beginning), "{name}: {text}");
    }
    let path = folder.join("e.csv");
    let both = complains(&["table", "-o", path.to_str().unwrap(), "--format", "json"]);
    assert!(both.contains("two things") && !path.exists(), "{both}");
}

#[test]
fn what_is_read_aloud_is_right_mathematics() {
    let described = |figure: &str| {
        let json: Value =
            serde_json::from_str(&says(&["plot", figure, "--format", "json"])).unwrap();
        let text = json["description"].as_str().unwrap().to_owned();
        assert!(says(&["plot", figure]).contains(&text), "{figure}");
        text
    };
    let outcomes = described("outcomes");
    assert!(outcomes.contains("v₁² + v₂² + v₃² = 1"), "{outcomes}");
    let energy = described("energy");
    assert!(
        energy.contains("E_after = e² E₀") && energy.contains("E_after = (1/2) (e² + 1) E₀"),
        "{energy}"
    );
}

#[test]
fn both_ends_of_the_curve_are_told_and_stones_stand_where_they_belong() {
    let json: Value =
        serde_json::from_str(&says(&["plot", "lithotripsy", "--format", "json"])).unwrap();
    let text = json["description"].as_str().unwrap();
    assert!(
        text.contains("between μ = 2, where the curve is at 8/9, and μ = 6, where it is at 24/49"),
        "{text}"
    );
    assert!(text.contains("At μ = 0 it is at 0"), "{text}");
    let svg = says(&["plot", "lithotripsy"]);
    assert_eq!(svg.matches("→\u{a0}").count(), 4, "{svg}");
}

#[test]
fn a_name_with_markup_stays_a_name() {
    let name = "a|b,\"c\"*<i>";
    let given = format!("{name}=1/2");
    let csv = says(&["table", "--format", "csv", "--material", &given]);
    assert!(csv.contains("\n\"a|b,\"\"c\"\"*<i>\",0.5,"), "{csv}");
    let markdown = says(&["table", "--format", "markdown", "--material", &given]);
    assert!(
        markdown.contains(r#"| a\|b,"c"\*\<i\> | 0.5 |"#),
        "{markdown}"
    );
}

#[test]
fn materials_that_are_none_are_refused() {
    let many: Vec<String> = (0..9).map(|at| format!("--material=m{at}=0.5")).collect();
    let many: Vec<&str> = ["table"]
        .into_iter()
        .chain(many.iter().map(String::as_str))
        .collect();
    assert!(complains(&many).contains("9 materials are too many"));
    let long = "x".repeat(25) + "=0.5";
    let precise = format!("x=0.{}1", "9".repeat(40));
    for (text, why) in [
        ("steel", "no `=`"),
        ("=0.5", "no name"),
        ("steel=", "a number is missing"),
        ("steel=1.01", "from 0 to 1"),
        ("steel=-0.1", "from 0 to 1"),
        ("steel=1/0", "divides by zero"),
        ("steel=nan", "not a number"),
        (&long, "25 characters"),
        (&precise, "too many digits"),
        ("a\u{202e}b=0.5", "U+202E"),
        ("a\nb=0.5", "U+000A"),
    ] {
        let said = complains(&["table", "--material", text]);
        assert!(said.contains(why), "{text}: {said}");
        assert!(!said.contains('\u{202e}'), "{said}");
    }
    let twice = complains(&["plot", "energy", "--material", "a=0", "--material", "a=1"]);
    assert!(twice.contains("two materials `a`"), "{twice}");
}

#[test]
fn formats_that_a_command_has_not_are_refused() {
    assert!(complains(&["--format", "csv"]).contains("tables"));
    assert!(complains(&["explain", "41", "--format", "markdown"]).contains("tables"));
    assert!(complains(&["plot", "energy", "--format", "markdown"]).contains("Markdown"));
    assert!(complains(&["plot", "outcomes", "--balls", "4"]).contains("4 balls"));
    assert!(complains(&["plot", "outcomes", "--balls", "1"]).contains("of 1 ball are no curve"));
    assert!(says(&["plot", "outcomes", "--balls", "3"]).starts_with("<svg"));
}

#[test]
fn a_dash_is_standard_output_for_every_command() {
    assert_eq!(says(&["table", "-o", "-"]), says(&["table"]));
    assert_eq!(
        says(&["plot", "collision", "-o", "-"]),
        says(&["plot", "collision"])
    );
    let page = run(&["report", "-o", "-"]);
    assert_eq!(code(&page), 1);
    assert!(out(&page).starts_with("<!DOCTYPE html>"));
    assert!(!Path::new("-").exists());
}

#[test]
fn a_page_goes_to_a_file_that_promises_no_other() {
    let folder = folder("page");
    for name in ["a.pdf", "a.svg", "a.md"] {
        let said = complains(&["report", "-o", folder.join(name).to_str().unwrap()]);
        assert!(said.contains("a page of HTML is not written as"), "{said}");
    }
    assert!(files(&folder).is_empty());
    for name in ["a.html", "b.HTM", "c"] {
        let page = run(&["report", "-o", folder.join(name).to_str().unwrap()]);
        assert_eq!(code(&page), 1, "{name}");
    }
    assert_eq!(files(&folder), ["a.html", "b.HTM", "c"]);
}

#[test]
fn a_coefficient_has_up_to_thirty_digits() {
    let nines = |count| format!("a=0.{}", "9".repeat(count));
    let csv = says(&["table", "--format=csv", "--material", &nines(30)]);
    assert!(csv.contains("346573590279972654708616060729"), "{csv}");
    let said = complains(&["table", "--material", &nines(31)]);
    assert!(said.contains("at most 30"), "{said}");
}

#[test]
fn what_is_exact_is_as_short_as_it_can_be() {
    let materials = [
        "--material",
        "b=0.123456789012345678901234567",
        "--material",
        "c=1",
        "--material",
        "g=0.51",
    ];
    let svg = says(&[&["plot", "energy"][..], &materials].concat());
    for label in ["≈\u{a0}0.123457<", "=\u{a0}1<", "=\u{a0}0.51<"] {
        assert!(svg.contains(label), "{label}: {svg}");
    }
    let table = says(&["table", "--material", "c=1/3", "--material", "d=0"]);
    assert!(table.contains(" 100 %"), "{table}");
    assert!(table.contains("≈ 88.888889 %"), "{table}");
}

#[test]
fn what_people_read_has_no_braces() {
    for args in [
        &["table"][..],
        &["table", "--format", "markdown"],
        &["graph"],
    ] {
        let text = out(&run(args));
        assert!(!text.contains(['{', '}']), "{args:?}: {text}");
    }
    let svg = says(&["plot", "energy"]);
    let described = &svg[svg.find("<desc").unwrap()..svg.find("</desc>").unwrap()];
    assert!(described.contains("E_after = "), "{described}");
    assert!(!described.contains('{'), "{described}");
}

#[test]
fn no_name_is_a_formula_in_a_spreadsheet() {
    let names = [
        "=1+1=0.5", "@a=0.5", "-b=0.5", "+c=0.5", "-1=0.5", "e-f=0.5",
    ];
    let materials = names.iter().flat_map(|name| ["--material", *name]);
    let args: Vec<&str> = ["table", "--format", "csv"]
        .into_iter()
        .chain(materials)
        .collect();
    let csv = says(&args);
    let firsts: Vec<&str> = csv
        .lines()
        .skip(1)
        .filter_map(|l| l.split(',').next())
        .collect();
    assert_eq!(firsts, ["'=1+1", "'@a", "'-b", "'+c", "-1", "e-f"]);
}

#[test]
fn help_lists_no_option_that_says_nothing() {
    for command in [
        &["plot"][..],
        &["plot", "energy"],
        &["table"],
        &["simulate"],
    ] {
        let help = says(&[command, &["--help"]].concat());
        for option in ["--builtin", "--config", "--no-config", "--show-understood"] {
            assert!(!help.contains(option), "{command:?}: {option}");
        }
        assert!(help.contains("--jobs"), "{command:?}");
    }
    assert!(says(&["report", "--help"]).contains("--builtin"));
    assert!(complains(&["table", "--builtin", "corrected"]).contains("--builtin"));
}
