//! Panics, also those that the program itself gets over.

use std::cell::RefCell;
use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, set_hook, take_hook};
use std::sync::{Mutex, Once, PoisonError};

use super::checks::Checked;

/// Panics of the threads that the program starts.
static ELSEWHERE: Mutex<Vec<String>> = Mutex::new(Vec::new());

thread_local! {
    static HERE: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

/// Does something and says whether anything in it panicked.
///
/// Tests run side by side, so a panic of a thread without a name may be told of the wrong input, but is told.
pub fn caught(work: impl FnOnce() -> Checked) -> Checked {
    static HOOK: Once = Once::new();
    HOOK.call_once(|| {
        let usual = take_hook();
        set_hook(Box::new(move |info| note(info, &usual)));
    });
    HERE.take();
    let done = catch_unwind(AssertUnwindSafe(work));
    let mut told = HERE.take();
    told.append(&mut ELSEWHERE.lock().unwrap_or_else(PoisonError::into_inner));
    match (told.first(), done) {
        (Some(first), _) => Err(first.clone()),
        (None, Ok(done)) => done,
        (None, Err(_)) => Err("a panic without words".to_owned()),
    }
}

/// The test's own failure comes here too, and that of every other test, and must be seen.
fn note(info: &PanicHookInfo<'_>, usual: &dyn Fn(&PanicHookInfo<'_>)) {
    match std::thread::current().name() {
        Some(_) => {
            usual(info);
            HERE.with_borrow_mut(|all| all.push(info.to_string()));
        }
        None => ELSEWHERE
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .push(info.to_string()),
    }
}
