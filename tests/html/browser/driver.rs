//! A browser that is told what to do, through WebDriver: JSON over HTTP to a `chromedriver` of our own.
//!
//! Everything has a time limit, and nothing outlives its session: the driver runs under `timeout`, which makes it and
//! the browser a group of processes and ends the group after [`LONGEST`], or when a shell tells it to. The shell does so
//! when its input ends, and that it does even where a test is killed.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// What a session may take, in seconds. A quiet machine needs a fiftieth of it.
const LONGEST: u64 = 1500;
/// What one answer may take, on a machine with much else to do.
const ANSWER: Duration = Duration::from_secs(300);

/// Why something was not done: the driver's words.
pub type Failure = String;

/// Runs something until there is nothing more to be read, or until a signal comes that ends the test too.
const UNTIL_TOLD: &str = "trap : TERM INT HUP; timeout --kill-after=5 \"$@\" </dev/null & \
                          cat >/dev/null; kill -TERM $! 2>/dev/null; wait";

/// A browser without a window.
pub struct Session {
    driver: Child,
    port: u16,
    path: String,
}

/// The first of some programs that answers when it is asked for its version, with the folder that it is in.
fn program(variable: &str, usual: &[&str]) -> Option<PathBuf> {
    let named = std::env::var_os(variable).map(PathBuf::from);
    let folders = std::env::var_os("PATH").unwrap_or_default();
    let folders: Vec<PathBuf> = std::env::split_paths(&folders).collect();
    let found = usual
        .iter()
        .flat_map(|name| folders.iter().map(move |folder| folder.join(name)));
    let mut all = named.into_iter().chain(found.filter(|path| path.is_file()));
    all.find(|path| {
        let mut asked = Command::new("timeout");
        let asked = asked.arg("120").arg(path).arg("--version");
        let asked = asked.stdout(Stdio::null()).stderr(Stdio::null());
        asked.status().is_ok_and(|status| status.success())
    })
}

impl Session {
    /// Starts a browser with a profile of its own below a folder.
    ///
    /// # Errors
    /// There is no browser or no driver here, or they do not answer.
    pub fn start(folder: &Path) -> Result<Session, Failure> {
        let usual = ["chromium", "chromium-browser", "google-chrome", "chrome"];
        let browser = program("CHROMIUM", &usual)
            .ok_or("there is no Chromium here; set CHROMIUM to its path")?;
        let driver = program("CHROMEDRIVER", &["chromedriver"])
            .ok_or("there is no chromedriver here; set CHROMEDRIVER to its path")?;
        let profile = folder.join("profile");
        let _ = std::fs::remove_dir_all(&profile);
        std::fs::create_dir_all(&profile).map_err(|error| error.to_string())?;

        let mut running = Command::new("sh")
            .args(["-c", UNTIL_TOLD, "sh", &LONGEST.to_string()])
            .arg(driver)
            .args(["--port=0", "--log-level=SEVERE"])
            // Where the browser keeps what it does not keep in its profile.
            .env("HOME", &profile)
            .env("TMPDIR", &profile)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .map_err(|error| error.to_string())?;
        let said = running.stdout.take();
        let mut session = Session {
            driver: running,
            port: 0,
            path: String::new(),
        };
        session.port = port(said).ok_or("chromedriver has not started in time")?;

        let arguments = [
            "--headless",
            // Whoever runs tests in a container is root there, for whom Chromium has no sandbox. Only our pages are shown.
            "--no-sandbox",
            "--disable-gpu",
            "--disable-dev-shm-usage",
            "--disable-quic",
            "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            "--force-prefers-reduced-motion",
            "--window-size=1100,1000",
        ];
        let mut arguments: Vec<String> = arguments.map(str::to_owned).into();
        arguments.push(format!("--user-data-dir={}", profile.display()));
        let asked = json!({"capabilities": {"alwaysMatch": {
            "browserName": "chrome",
            "timeouts": {"script": 280_000, "pageLoad": 280_000},
            "goog:loggingPrefs": {"browser": "ALL"},
            "goog:chromeOptions": {"binary": browser, "args": arguments},
        }}});
        let answer = session.ask("POST", "/session", Some(&asked))?;
        let name = answer["sessionId"]
            .as_str()
            .ok_or("a session has no name")?;
        session.path = format!("/session/{name}");
        Ok(session)
    }

    /// Shows a file.
    pub fn show(&self, file: &Path) -> Result<(), Failure> {
        // What differs in its hash alone would not be shown anew.
        self.post("/url", &json!({"url": "about:blank"}))?;
        let address = format!("file://{}", file.display());
        self.post("/url", &json!({"url": address}))?;
        let end = Instant::now() + ANSWER;
        while self.run("return document.readyState")? != "complete" {
            if Instant::now() > end {
                return Err(format!("{} is not shown in time", file.display()));
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        Ok(())
    }

    /// What a piece of script returns.
    pub fn run(&self, script: &str) -> Result<Value, Failure> {
        self.post("/execute/sync", &json!({"script": script, "args": []}))
    }

    /// Sends a command of the DevTools.
    pub fn tell(&self, command: &str, parameters: &Value) -> Result<Value, Failure> {
        let asked = json!({"cmd": command, "params": parameters});
        self.post("/goog/cdp/execute", &asked)
    }

    /// Clicks on the element that a selector finds, where a pointer would meet it.
    pub fn click(&self, selector: &str) -> Result<(), Failure> {
        let element = self.element(selector)?;
        self.post(&format!("/element/{element}/click"), &json!({}))
            .map(drop)
    }

    /// Types into the element that a selector finds, which has the focus afterwards.
    pub fn keys(&self, selector: &str, text: &str) -> Result<(), Failure> {
        let element = self.element(selector)?;
        let asked = json!({"text": text});
        self.post(&format!("/element/{element}/value"), &asked)
            .map(drop)
    }

    fn element(&self, selector: &str) -> Result<String, Failure> {
        let asked = json!({"using": "css selector", "value": selector});
        let answer = self.post("/element", &asked)?;
        let mut names = answer
            .as_object()
            .into_iter()
            .flat_map(|found| found.values());
        let name = names.next().and_then(Value::as_str);
        name.map(str::to_owned)
            .ok_or_else(|| format!("no {selector}"))
    }

    /// What has been said on the console since this was last asked.
    pub fn console(&self) -> Result<Vec<String>, Failure> {
        let answer = self.post("/se/log", &json!({"type": "browser"}))?;
        let lines = answer.as_array().cloned().unwrap_or_default();
        Ok(lines.iter().map(Value::to_string).collect())
    }

    fn post(&self, path: &str, body: &Value) -> Result<Value, Failure> {
        self.ask("POST", &format!("{}{path}", self.path), Some(body))
    }

    fn ask(&self, method: &str, path: &str, body: Option<&Value>) -> Result<Value, Failure> {
        let told = |error: std::io::Error| format!("{method} {path}: {error}");
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).map_err(told)?;
        stream.set_read_timeout(Some(ANSWER)).map_err(told)?;
        let body = body.map(Value::to_string).unwrap_or_default();
        let head = format!(
            "{method} {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nContent-Type: application/json; charset=utf-8\r\n\
             Content-Length: {}\r\nConnection: close\r\n\r\n",
            self.port,
            body.len()
        );
        stream.write_all(head.as_bytes()).map_err(told)?;
        stream.write_all(body.as_bytes()).map_err(told)?;
        let answer = answer(stream).map_err(told)?;
        let mut answer: Value =
            serde_json::from_slice(&answer).map_err(|error| format!("{method} {path}: {error}"))?;
        let value = answer["value"].take();
        match value.get("error").and_then(Value::as_str) {
            Some(error) => Err(format!("{method} {path}: {error}: {}", value["message"])),
            None => Ok(value),
        }
    }
}

/// The body of an answer, which says how long it is.
fn answer(stream: TcpStream) -> std::io::Result<Vec<u8>> {
    let mut reader = BufReader::new(stream);
    let mut length = 0;
    loop {
        let mut line = String::new();
        reader.read_line(&mut line)?;
        let line = line.trim_end();
        if line.is_empty() {
            break;
        }
        if let Some((name, value)) = line.split_once(':')
            && name.eq_ignore_ascii_case("content-length")
        {
            length = value.trim().parse().unwrap_or(0);
        }
    }
    let mut body = vec![0; length];
    reader.read_exact(&mut body)?;
    Ok(body)
}

/// The port that the driver says it listens on.
fn port(said: Option<std::process::ChildStdout>) -> Option<u16> {
    let (sender, receiver) = mpsc::channel();
    let said = BufReader::new(said?);
    // Reads on to the end, so that the driver never writes into nothing.
    std::thread::spawn(move || {
        for line in said.lines().map_while(Result::ok) {
            let number = line.rsplit_once("on port ").map(|(_, rest)| rest);
            let number = number.and_then(|rest| rest.trim_end_matches('.').parse::<u16>().ok());
            // Before it is ready it says that it starts on port 0.
            if let Some(number) = number.filter(|number| *number > 0) {
                let _ = sender.send(number);
            }
        }
    });
    receiver.recv_timeout(Duration::from_secs(120)).ok()
}

impl Drop for Session {
    fn drop(&mut self) {
        if !self.path.is_empty() {
            let _ = self.ask("DELETE", &self.path, None);
        }
        drop(self.driver.stdin.take());
        let end = Instant::now() + Duration::from_secs(30);
        while matches!(self.driver.try_wait(), Ok(None)) && Instant::now() < end {
            std::thread::sleep(Duration::from_millis(20));
        }
    }
}
