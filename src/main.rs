//! The `cradle-verify` program; everything it does is in the library.

fn main() -> std::process::ExitCode {
    cradle_verify::cli::main()
}
