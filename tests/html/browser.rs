//! The page in a browser, where there is one: `CHROMIUM` names it, or it is found by its usual names.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::built_in;

/// A browser that answers.
fn browser() -> Option<PathBuf> {
    let named = std::env::var_os("CHROMIUM").map(PathBuf::from);
    let usual = ["chromium", "chromium-browser", "google-chrome", "chrome"].map(PathBuf::from);
    let mut all = named.into_iter().chain(usual);
    let answers = |path: &PathBuf| {
        let mut asked = Command::new(path);
        let asked = asked
            .arg("--version")
            .stdout(Stdio::null())
            .stderr(Stdio::null());
        asked.status().is_ok_and(|status| status.success())
    };
    all.find(answers)
}

/// What a page comes to, and what is said on its console; nothing, where the browser does not answer in time.
fn loaded(browser: &Path, folder: &Path, name: &str) -> Option<(String, Vec<String>)> {
    let file = |ending: &str| folder.join(format!("{name}.{ending}"));
    let mut running = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu"])
        .args(["--enable-logging=stderr", "--timeout=5000", "--dump-dom"])
        .arg(format!(
            "--user-data-dir={}",
            folder.join("profile").display()
        ))
        .arg(format!("file://{}", folder.join(name).display()))
        .stdout(std::fs::File::create(file("out")).unwrap())
        .stderr(std::fs::File::create(file("err")).unwrap())
        .spawn()
        .unwrap();
    let end = Instant::now() + Duration::from_secs(30);
    while running.try_wait().unwrap().is_none() {
        if Instant::now() > end {
            running.kill().unwrap();
            running.wait().unwrap();
            return None;
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    let said = std::fs::read(file("err")).unwrap();
    let said = String::from_utf8_lossy(&said).into_owned();
    let console = said
        .lines()
        .filter(|line| line.contains("CONSOLE"))
        .map(str::to_owned);
    let shown = std::fs::read(file("out")).unwrap();
    Some((
        String::from_utf8_lossy(&shown).into_owned(),
        console.collect(),
    ))
}

#[test]
fn a_browser_has_nothing_to_complain_of_and_nothing_is_wider_than_a_telephone() {
    let Some(browser) = browser() else {
        eprintln!("skipped: there is no Chromium here; set CHROMIUM to its path");
        return;
    };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("browser");
    std::fs::create_dir_all(&folder).unwrap();
    let page = built_in();
    std::fs::write(folder.join("page.html"), &page).unwrap();
    let Some((shown, console)) = loaded(&browser, &folder, "page.html") else {
        eprintln!(
            "skipped: {} did not answer within 30 seconds",
            browser.display()
        );
        return;
    };
    assert!(console.is_empty(), "{console:?}");
    // The script has run.
    assert!(shown.contains("unfold all evidence"));

    // In a frame as wide as a telephone, with everything unfolded, the page tells how wide it is.
    let probe = "<script>addEventListener('load', function () { document.querySelectorAll('details').forEach(function (d) \
                 { d.open = true; }); parent.postMessage(document.documentElement.scrollWidth, '*'); });</script></body>";
    let start = page.find("<meta http-equiv").unwrap();
    let end = start + page[start..].find("/>").unwrap() + 2;
    let probed = format!("{}{}", &page[..start], &page[end..]).replace("</body>", probe);
    std::fs::write(folder.join("probed.html"), probed).unwrap();
    let frame = "<!DOCTYPE html><title></title><iframe width=360 height=800 style=\"border:0\" src=\"probed.html\"></iframe>\
                 <script>addEventListener('message', function (told) { document.title = 'width ' + told.data; });</script>";
    std::fs::write(folder.join("frame.html"), frame).unwrap();
    let (shown, console) = loaded(&browser, &folder, "frame.html").unwrap();
    assert!(console.is_empty(), "{console:?}");
    assert!(
        shown.contains("<title>width 360</title>"),
        "{}",
        shown.chars().take(300).collect::<String>()
    );
}
