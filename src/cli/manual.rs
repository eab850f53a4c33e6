//! What is generated from the arguments: shell completions and manual pages.

use super::Failure;
use super::args::commands;

/// The script for a shell.
pub fn completions(shell: clap_complete::Shell) -> String {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut commands(), "cradle-verify", &mut script);
    String::from_utf8_lossy(&script).into_owned()
}

/// A manual page: of the program, or of one of its commands, each word of which is a name: `plot energy`.
///
/// # Errors
/// There is no such command.
pub fn page(names: &[String]) -> Result<String, Failure> {
    let mut all = commands();
    all.build();
    let mut command = &all;
    for name in names {
        let Some(own) = command.find_subcommand(name) else {
            let failure = Failure::new(format!("there is no command `{}`", names.join(" ")));
            let known: Vec<&str> = command.get_subcommands().map(|c| c.get_name()).collect();
            return Err(match known.is_empty() {
                true => failure,
                false => failure.help(format!("the commands are {}", known.join(", "))),
            });
        };
        command = own;
    }
    let command = command.clone();
    let mut roff = Vec::new();
    clap_mangen::Man::new(command)
        .render(&mut roff)
        .map_err(|error| Failure::new(format!("the page cannot be written: {error}")))?;
    Ok(String::from_utf8_lossy(&roff).into_owned())
}
