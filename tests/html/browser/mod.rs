//! The page in a browser: what is laid out, followed, folded, read in colours, squeezed, printed, and done without a script.
//!
//! One browser goes through all of it, for starting one is what takes the time, and says in the end all that is amiss.
//! Where there is none the test is skipped, and says so; with `CRADLE_BROWSER=required`, as in continuous integration,
//! that is a failure.

mod driver;
mod picture;

use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use serde_json::{Value, json};

use super::common::folder;
use super::{HOSTILE_PAGES, built_in, hostile_names, page_of, thousands};
use driver::{Failure, Session};

const PAGE: &str = include_str!("page.js");

/// A page of which everything is wrong that is asked about: a question that it passes is no question.
const WRONG: &str = "<!DOCTYPE html><html><head><title>wrong</title></head><body style=\"background:#fff\"><p \
    style=\"color:#999\">pale</p><p style=\"width:5000px\">wide</p><p>$$ \\frac{1}{2} $$</p><a href=\"#nowhere\">lost</a>\
    <math><mfrac style=\"display:inline\"><mn>1</mn><mn>2</mn></mfrac></math><script>console.error('wrong')</script></body></html>";

/// A browser, and the pages to be shown in it.
struct Stage {
    session: Session,
    folder: PathBuf,
}

type Complaints = Result<Vec<String>, Failure>;

impl Stage {
    /// A browser with the pages in a folder of its own, or the reason why there is none.
    fn new(name: &str) -> Option<Stage> {
        let folder = folder(&format!("html/{name}"));
        match Session::start(&folder) {
            Ok(session) => Some(Stage { session, folder }),
            Err(reason) => {
                let required = std::env::var("CRADLE_BROWSER").is_ok_and(|v| v == "required");
                assert!(!required, "{reason}");
                // Not by a macro, whose words are kept from those who look on.
                let _ = writeln!(
                    std::io::stderr(),
                    "skipped, no page was looked at: {reason}"
                );
                None
            }
        }
    }

    /// Shows a page in a window of a telephone's or a screen's width, as it is before anybody touches it.
    fn shows(&self, page: &str, width: u32) -> Result<(), Failure> {
        let size = json!({"width": width, "height": 1000, "deviceScaleFactor": 1, "mobile": false});
        self.session
            .tell("Emulation.setDeviceMetricsOverride", &size)?;
        self.session.show(&self.folder.join(page))
    }

    fn looks(&self, media: &str, scheme: &str) -> Result<(), Failure> {
        let features = [json!({"name": "prefers-color-scheme", "value": scheme})];
        let asked = json!({"media": media, "features": features});
        self.session
            .tell("Emulation.setEmulatedMedia", &asked)
            .map(drop)
    }

    /// What a function of `page.js` says.
    fn asks(&self, question: &str) -> Result<Value, Failure> {
        self.session.run(&format!("{PAGE}\nreturn {question};"))
    }

    fn unfolds(&self) -> Result<(), Failure> {
        self.asks("unfold()").map(drop)
    }

    fn presses(&self, key: &str, text: &str) -> Result<(), Failure> {
        let code = if key == "Tab" { 9 } else { 13 };
        for kind in ["keyDown", "keyUp"] {
            let asked = json!({"type": kind, "key": key, "code": key, "text": text, "windowsVirtualKeyCode": code});
            self.session.tell("Input.dispatchKeyEvent", &asked)?;
        }
        Ok(())
    }
}

/// A list of complaints, as `page.js` makes them.
fn list(value: &Value) -> Vec<String> {
    let lines = value.as_array().expect("a list of complaints");
    lines
        .iter()
        .map(|line| line.as_str().unwrap_or_default().to_owned())
        .collect()
}

/// Complains unless it is so.
fn expect(found: &mut Vec<String>, is_so: bool, what: &str) {
    if !is_so {
        found.push(what.to_owned());
    }
}

fn what_is_wrong_is_found(stage: &Stage) -> Complaints {
    stage.session.console()?;
    stage.shows("wrong.html", 1100)?;
    let mut found = Vec::new();
    let mathematics = stage.asks("mathematics()")?;
    let contrast = stage.asks("contrast()")?;
    for (question, complaints) in [
        ("mathematics", list(&mathematics["complaints"])),
        ("contrast", list(&contrast["complaints"])),
        ("links", list(&stage.asks("links()")?)),
        ("width", list(&stage.asks("width()")?)),
        ("console", stage.session.console()?),
    ] {
        expect(&mut found, !complaints.is_empty(), question);
    }
    Ok(found)
}

fn the_mathematics_is_laid_out_and_the_console_is_silent(stage: &Stage) -> Complaints {
    stage.shows("report.html", 1100)?;
    stage.unfolds()?;
    let said = stage.asks("mathematics()")?;
    let mut found = list(&said["complaints"]);
    expect(
        &mut found,
        said["count"].as_u64() > Some(300),
        "few formulas",
    );
    expect(
        &mut found,
        said["fractions"].as_u64() > Some(50),
        "few fractions",
    );
    found.extend(stage.session.console()?);
    Ok(found)
}

fn links_and_folds_work(stage: &Stage) -> Complaints {
    let session = &stage.session;
    stage.shows("report.html", 1100)?;
    let mut found = list(&stage.asks("links()")?);
    let fold = "#eq-41 summary";
    let is_open = || session.run("return document.querySelector('#eq-41 details').open");
    session.click(fold)?;
    expect(&mut found, is_open()? == true, "a click does not unfold");
    session.click(fold)?;
    expect(
        &mut found,
        is_open()? == false,
        "a second click does not fold",
    );
    session.keys(fold, "\u{e007}")?;
    expect(&mut found, is_open()? == true, "the key does not unfold");
    session.click("#eq-41 .premises a")?;
    found.extend(arrived(stage)?);
    session.click("#graph a[href='#eq-23']")?;
    found.extend(arrived(stage)?);
    // The same without a pointer.
    session.run("document.querySelector(\"#graph a[href='#eq-41']\").focus()")?;
    stage.presses("Enter", "\r")?;
    let hash = session.run("return location.hash")?;
    expect(
        &mut found,
        hash == "#eq-41",
        "a node of the graph has no key",
    );
    found.extend(arrived(stage)?);
    Ok(found)
}

fn arrived(stage: &Stage) -> Complaints {
    let told = stage.asks("arrived()")?;
    let told = told.as_str().unwrap_or_default();
    Ok(if told.is_empty() {
        Vec::new()
    } else {
        vec![told.to_owned()]
    })
}

fn the_keyboard_comes_first_to_the_way_past_the_beginning(stage: &Stage) -> Complaints {
    stage.shows("report.html", 1100)?;
    stage.presses("Tab", "")?;
    let place = stage.session.run(
        "const own = document.activeElement; return own.className + ' ' + (own.getBoundingClientRect().left >= 0)",
    )?;
    let mut found = Vec::new();
    expect(
        &mut found,
        place == "skip true",
        "the first stop is not the skip link, or it is not seen",
    );
    Ok(found)
}

fn the_filter_shows_one_verdict_and_lets_links_through(stage: &Stage) -> Complaints {
    let session = &stage.session;
    stage.shows("report.html", 1100)?;
    let mut found = Vec::new();
    let shown = "[...document.querySelectorAll('.equation')].filter((e) => e.checkVisibility())";
    session.click("#filter button:nth-of-type(4)")?;
    let others =
        format!("return {shown}.filter((e) => !e.dataset.verdict.includes('fails')).length");
    expect(
        &mut found,
        session.run(&others)? == 0,
        "the filter leaves others",
    );
    let some = session.run(&format!("return {shown}.length"))?;
    expect(
        &mut found,
        some.as_u64() > Some(3),
        "the filter leaves too few",
    );
    session.run("location.hash = '#eq-22'")?;
    let back = "const own = document.getElementById('eq-22'); return own.checkVisibility()";
    let mut is_back = Value::Bool(false);
    // The event comes after the script.
    for _ in 0..100 {
        is_back = session.run(back)?;
        if is_back == true {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    expect(
        &mut found,
        is_back == true,
        "a link to what is filtered out does not show it",
    );
    Ok(found)
}

fn text_stands_out_in_light_and_in_dark(stage: &Stage) -> Complaints {
    let mut found = Vec::new();
    let mut papers = Vec::new();
    for scheme in ["light", "dark"] {
        stage.looks("screen", scheme)?;
        stage.shows("report.html", 1100)?;
        stage.unfolds()?;
        let said = stage.asks("contrast()")?;
        found.extend(
            list(&said["complaints"])
                .into_iter()
                .map(|line| format!("{scheme}: {line}")),
        );
        expect(
            &mut found,
            said["count"].as_u64() > Some(2_000),
            "few texts",
        );
        papers.push(said["paper"].clone());
    }
    stage.looks("", "light")?;
    expect(&mut found, papers[0] != papers[1], "light is dark");
    Ok(found)
}

fn nothing_overflows(stage: &Stage) -> Complaints {
    let mut found = Vec::new();
    for (page, width) in [
        ("report.html", 320),
        ("report.html", 360),
        ("report.html", 1100),
        ("hostile.html", 360),
    ] {
        stage.shows(page, width)?;
        stage.unfolds()?;
        let complaints = list(&stage.asks("width()")?).into_iter();
        found.extend(complaints.map(|line| format!("{page}, {width}: {line}")));
    }
    Ok(found)
}

/// As wide as a sheet of A4 between its margins, for a reader who prefers a dark screen.
fn paper_is_light_and_takes_everything(stage: &Stage) -> Complaints {
    stage.looks("print", "dark")?;
    stage.shows("report.html", 718)?;
    let mut found = list(&stage.asks("width()")?);
    let said = stage.asks("contrast()")?;
    found.extend(list(&said["complaints"]));
    expect(
        &mut found,
        said["paper"] == "255 255 255 1",
        "the paper is dark",
    );
    let navigation = stage
        .session
        .run("return document.querySelector('nav').checkVisibility()")?;
    expect(
        &mut found,
        navigation == false,
        "there is navigation on paper",
    );
    stage.looks("", "light")?;
    Ok(found)
}

fn all_of_it_works_without_a_script(stage: &Stage) -> Complaints {
    let session = &stage.session;
    let disable = |value: bool| {
        session.tell(
            "Emulation.setScriptExecutionDisabled",
            &json!({"value": value}),
        )
    };
    disable(true)?;
    stage.shows("report.html", 360)?;
    let mut found = Vec::new();
    let buttons = session.run("return document.querySelectorAll('button').length")?;
    expect(&mut found, buttons == 0, "the script has run");
    session.click("#eq-23 summary")?;
    let is_open = session.run("return document.querySelector('#eq-23 details').open")?;
    expect(&mut found, is_open == true, "a click does not unfold");
    session.click(".findings a")?;
    found.extend(arrived(stage)?);
    found.extend(list(&stage.asks("mathematics()")?["complaints"]));
    found.extend(session.console()?);
    disable(false)?;
    Ok(found)
}

/// A script that ran would open a window or complain of the policy, and the browser would tell.
fn nothing_hostile_is_done(stage: &Stage) -> Complaints {
    stage.shows("hostile.html", 1100)?;
    stage.unfolds()?;
    let mut found = stage.session.console()?;
    found.extend(list(&stage.asks("links()")?));
    let said = stage.asks("contrast()")?;
    found.extend(list(&said["complaints"]));
    Ok(found)
}

fn two_thousand_equations_are_shown(stage: &Stage) -> Complaints {
    stage.shows("many.html", 360)?;
    let said = stage.asks("mathematics()")?;
    let mut found = list(&said["complaints"]);
    expect(
        &mut found,
        said["count"].as_u64() >= Some(4_000),
        "formulas are missing",
    );
    let root = "document.documentElement";
    let wide = stage
        .session
        .run(&format!("return {root}.scrollWidth > {root}.clientWidth"))?;
    expect(&mut found, wide == false, "wider than the window");
    found.extend(stage.session.console()?);
    Ok(found)
}

type Check = (&'static str, fn(&Stage) -> Complaints);

#[test]
fn a_browser_has_nothing_to_complain_of() {
    let Some(stage) = Stage::new("browser") else {
        return;
    };
    let names = [900, 10_000].map(hostile_names);
    let names = [
        ("names.md", names[0].as_str()),
        ("longer.md", names[1].as_str()),
    ];
    let hostile = page_of(&[HOSTILE_PAGES, &names].concat());
    for (name, page) in [
        ("report.html", built_in().to_owned()),
        ("hostile.html", hostile),
        ("many.html", page_of(&[("many.md", &thousands(2_000))])),
        ("wrong.html", WRONG.to_owned()),
    ] {
        std::fs::write(stage.folder.join(name), page).unwrap();
    }
    let checks: &[Check] = &[
        ("what is wrong is found", what_is_wrong_is_found),
        (
            "mathematics",
            the_mathematics_is_laid_out_and_the_console_is_silent,
        ),
        ("links and folds", links_and_folds_work),
        (
            "keyboard",
            the_keyboard_comes_first_to_the_way_past_the_beginning,
        ),
        (
            "filter",
            the_filter_shows_one_verdict_and_lets_links_through,
        ),
        ("contrast", text_stands_out_in_light_and_in_dark),
        ("width", nothing_overflows),
        ("paper", paper_is_light_and_takes_everything),
        ("without a script", all_of_it_works_without_a_script),
        ("hostile documents", nothing_hostile_is_done),
        ("2 000 equations", two_thousand_equations_are_shown),
    ];
    let mut all = Vec::new();
    for (name, check) in checks {
        let start = Instant::now();
        let complaints = check(&stage).unwrap_or_else(|failure| vec![failure]);
        println!("{name}: {:.1} s", start.elapsed().as_secs_f64());
        for line in complaints {
            println!("  {line}");
            all.push(format!("{name}: {line}"));
        }
    }
    assert!(all.is_empty(), "\n{}", all.join("\n"));
}
