//! Where text goes, with or without its colours. A reader who stops reading (`| head`) is no error.

use std::io::{ErrorKind, Write};

use anstream::{AutoStream, ColorChoice};
use anstyle::AnsiColor;

use super::args::{Args, Color};
use super::{Failure, file};

impl From<Color> for ColorChoice {
    fn from(color: Color) -> Self {
        match color {
            Color::Auto => ColorChoice::Auto,
            Color::Always => ColorChoice::Always,
            Color::Never => ColorChoice::Never,
        }
    }
}

/// Writes data where it was asked for; whether anybody reads on.
///
/// # Errors
/// It cannot be written, for another reason than that nobody reads on.
pub fn deliver(text: &str, args: &Args) -> Result<bool, Failure> {
    let Some(path) = &args.output else {
        return data(text, args.color);
    };
    let plain = match args.color {
        Color::Always => text.to_owned(),
        _ => anstream::adapter::strip_str(text).to_string(),
    };
    file::replace(path, &plain)?;
    Ok(true)
}

/// Writes data to standard output; whether anybody reads on.
///
/// # Errors
/// It cannot be written, for another reason than that nobody reads on.
pub fn data(text: &str, color: Color) -> Result<bool, Failure> {
    let mut stdout = std::io::stdout().lock();
    let color = match color.into() {
        ColorChoice::Auto => AutoStream::choice(&stdout),
        choice => choice,
    };
    // Colours are taken out piece by piece; in the buffer, so that not every piece is a call to the system.
    let mut buffer = AutoStream::new(Vec::with_capacity(text.len()), color);
    let written = buffer
        .write_all(text.as_bytes())
        .and_then(|()| stdout.write_all(&buffer.into_inner()))
        .and_then(|()| stdout.flush());
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
