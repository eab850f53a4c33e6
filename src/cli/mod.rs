//! The command line: what is asked ([`args`]), what is read ([`input`]), what is shown ([`output`]).
//!
//! Data goes to standard output and talk to standard error. The exit code is 0 where nothing was found, 1 where
//! something was, and 2 where the job could not be done.

pub mod args;
mod audit;
mod config;
mod csv;
mod file;
mod halves;
mod html;
mod init;
pub mod input;
mod manual;
pub mod output;
pub mod plot;
pub mod progress;
mod run;
pub mod scenario;
mod simulate;
mod table;
mod watch;

use std::process::ExitCode;

/// Why the job could not be done, as a sentence for standard error; help is a second one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    /// What is wrong.
    pub message: String,
    /// What to do instead.
    pub help: Option<String>,
    /// What is wrong in a file that was read, in its own text; stands before the sentence.
    pub excerpt: Option<String>,
}

impl Failure {
    /// A failure with nothing to suggest.
    pub fn new(message: impl Into<String>) -> Self {
        Failure {
            message: message.into(),
            help: None,
            excerpt: None,
        }
    }

    /// The same with a suggestion.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

/// What the program does, from its arguments to its exit code.
pub fn main() -> ExitCode {
    let args = args::Args::read();
    if let Some(jobs) = args.jobs {
        crate::parallel::use_threads(jobs.get());
    }
    if let Some(args::Command::Check {
        paths, watch: true, ..
    }) = &args.command
    {
        return watch::watch(&args, paths);
    }
    let done = run::run(&args).and_then(|(content, found)| {
        output::deliver(&content, &args)?;
        Ok(found)
    });
    match done {
        Ok(found) => ExitCode::from(u8::from(found)),
        Err(failure) => refuse(&failure, args.color),
    }
}

fn refuse(failure: &Failure, color: args::Color) -> ExitCode {
    output::talk(failure, color);
    ExitCode::from(2)
}
