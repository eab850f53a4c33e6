//! The `cradle-verify` program; everything it does is in the library.

// The allocator.
use cradle_memory as _;

fn main() -> std::process::ExitCode {
    cradle_verify::cli::main()
}
