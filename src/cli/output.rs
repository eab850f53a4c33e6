//! Where text goes, with or without its colours. A reader who stops reading (`| head`) is no error.

use std::borrow::Cow;
use std::io::{ErrorKind, Write};

use anstream::{AutoStream, ColorChoice};
use anstyle::AnsiColor;

use super::args::{Args, Color};
use super::{Failure, file};
use crate::document::next_command;
use crate::report::uncoloured;

impl From<Color> for ColorChoice {
    fn from(color: Color) -> Self {
        match color {
            Color::Auto => ColorChoice::Auto,
            Color::Always => ColorChoice::Always,
            Color::Never => ColorChoice::Never,
        }
    }
}

/// What a command makes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Content {
    /// Text, which may have colours in it.
    Text(String),
    /// A page for a browser or a picture: written as it is.
    Bytes(Vec<u8>),
}

impl From<String> for Content {
    fn from(text: String) -> Self {
        Content::Text(text)
    }
}

/// Writes what a command makes where it was asked for; whether anybody reads on.
///
/// # Errors
/// It cannot be written, for another reason than that nobody reads on.
pub fn deliver(content: &Content, args: &Args) -> Result<bool, Failure> {
    let text = match content {
        Content::Text(text) => tamed(text),
        Content::Bytes(bytes) => {
            return match &args.output {
                Some(path) => file::replace(path, bytes).map(|()| true),
                None => written(bytes),
            };
        }
    };
    let Some(path) = &args.output else {
        return data(&text, args.color);
    };
    let plain = match args.color {
        Color::Always => text.into_owned(),
        _ => uncoloured(&text),
    };
    file::replace(path, &plain)?;
    Ok(true)
}

/// Text in which nothing commands a terminal but colours: a tag or a heading may hold any character, and what clears the
/// screen or rings the bell shows as `\u{fffd}`.
fn tamed(text: &str) -> Cow<'_, str> {
    let mut tamed = String::new();
    let mut kept = 0;
    while let Some(at) = next_command(text, kept) {
        tamed += &text[kept..at];
        tamed.push(char::REPLACEMENT_CHARACTER);
        kept = at + text[at..].chars().next().map_or(1, char::len_utf8);
    }
    if kept == 0 {
        return Cow::Borrowed(text);
    }
    tamed += &text[kept..];
    Cow::Owned(tamed)
}

/// Writes text to standard output, with its colours where they are wanted; whether anybody reads on.
///
/// # Errors
/// It cannot be written, for another reason than that nobody reads on.
pub fn data(text: &str, color: Color) -> Result<bool, Failure> {
    let color = match color.into() {
        ColorChoice::Auto => AutoStream::choice(&std::io::stdout()),
        choice => choice,
    };
    match color {
        ColorChoice::Never => written(uncoloured(text).as_bytes()),
        _ => written(text.as_bytes()),
    }
}

/// Writes to standard output; whether anybody reads on.
fn written(bytes: &[u8]) -> Result<bool, Failure> {
    let mut stdout = std::io::stdout().lock();
    let written = stdout.write_all(bytes).and_then(|()| stdout.flush());
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::new(format!(
            "standard output could not be written: {error}"
        ))),
        written => Ok(written.is_ok()),
    }
}

/// Says on standard error why the job could not be done.
pub fn talk(failure: &Failure, color: Color) {
    let mut stream = AutoStream::new(std::io::stderr().lock(), color.into());
    let red = AnsiColor::Red.on_default().bold();
    let cyan = AnsiColor::Cyan.on_default().bold();
    if let Some(excerpt) = &failure.excerpt {
        let _ = write!(stream, "{}", tamed(excerpt));
    }
    // Where standard error is closed there is nobody to tell.
    let _ = writeln!(stream, "{red}error{red:#}: {}", failure.message);
    if let Some(help) = &failure.help {
        let _ = writeln!(stream, "{cyan}help{cyan:#}: {help}");
    }
}

/// Says something on standard error that is no complaint.
pub fn say(text: &str) {
    // Where standard error is closed there is nobody to tell.
    let _ = write!(std::io::stderr().lock(), "{text}");
}
