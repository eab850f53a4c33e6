//! What is generated from the arguments: shell completions and manual pages.

use clap::CommandFactory;

use super::Failure;
use super::args::Args;

/// The script for a shell.
pub fn completions(shell: clap_complete::Shell) -> String {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Args::command(), "cradle-verify", &mut script);
    String::from_utf8_lossy(&script).into_owned()
}

/// A manual page: of the program, or of one of its commands.
///
/// # Errors
/// There is no such command.
pub fn page(name: Option<&str>) -> Result<String, Failure> {
    let mut all = Args::command();
    all.build();
    let command = match name {
        None => all,
        Some(name) => {
            let Some(command) = all.find_subcommand(name) else {
                let names: Vec<&str> = all.get_subcommands().map(|c| c.get_name()).collect();
                return Err(Failure::new(format!("there is no command `{name}`"))
                    .help(format!("there is {}", names.join(", "))));
            };
            command.clone()
        }
    };
    let mut roff = Vec::new();
    clap_mangen::Man::new(command)
        .render(&mut roff)
        .map_err(|error| Failure::new(format!("the page cannot be written: {error}")))?;
    Ok(String::from_utf8_lossy(&roff).into_owned())
}
