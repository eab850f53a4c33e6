//! Where the program gets memory from; it need only name this crate.

/// Exact arithmetic asks for many small pieces of memory, from several threads at once.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;
