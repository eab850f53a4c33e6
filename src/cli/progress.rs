//! How far a long audit has come, on a terminal's standard error. An audit that is soon done shows nothing.

use std::io::{IsTerminal, Write};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use crate::audit::Audit;
use crate::derivation::Derivation;
use crate::parallel::threads;

/// What takes less than this shows nothing.
const PATIENCE: Duration = Duration::from_millis(1000);
/// How often the bar is drawn.
const STEP: Duration = Duration::from_millis(100);
/// The length of the bar.
const WIDTH: usize = 30;

/// The audit, with a bar while it takes long.
pub fn audited(derivation: &Derivation) -> Audit {
    let total = derivation.equations.len();
    let dumb = std::env::var_os("TERM").is_some_and(|term| term == "dumb");
    if dumb || !std::io::stderr().is_terminal() {
        return Audit::of(derivation);
    }
    let progress = AtomicUsize::new(0);
    let (finished, wait) = channel::<()>();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            let mut next = PATIENCE;
            let mut drawn = false;
            let wait = wait;
            // The other end is dropped when the audit is done, also if it panics.
            while wait.recv_timeout(next) == Err(RecvTimeoutError::Timeout) {
                draw(progress.load(Ordering::Relaxed), total);
                (next, drawn) = (STEP, true);
            }
            if drawn {
                let _ = write!(std::io::stderr(), "\r\x1b[2K");
            }
        });
        let audit = Audit::by(derivation, threads(), &progress);
        drop(finished);
        audit
    })
}

fn draw(done: usize, total: usize) {
    let bar = bar(done, total);
    // Where standard error is closed there is nobody to tell.
    let _ = write!(std::io::stderr(), "\r\x1b[2K{bar}");
}

/// `auditing [===   ] 3 of 20 equations`
pub fn bar(done: usize, total: usize) -> String {
    let full = match total {
        0 => WIDTH,
        _ => WIDTH * done.min(total) / total,
    };
    let (full, rest) = ("=".repeat(full), " ".repeat(WIDTH - full));
    format!("auditing [{full}{rest}] {done} of {total} equations")
}
