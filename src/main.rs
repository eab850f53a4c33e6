//! The `cradle-verify` program; everything it does is in the library.

/// Exact arithmetic asks for many small pieces of memory, from several threads at once.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> std::process::ExitCode {
    cradle_verify::cli::main()
}
