//! Signals: Ctrl-C, SIGTERM and SIGHUP end a run and keep its results, and exceeding the system's file size limit is an ordinary error.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock, OnceLock};

/// Set when the command should stop: the current run ends at its next sample and keeps its results.
static STOP: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);
/// Signals are watched once per process, from the first run on.
static WATCHED: OnceLock<()> = OnceLock::new();

/// From now on, Ctrl-C, SIGTERM and SIGHUP ask to stop and keep the results; a second one ends the process.
pub(crate) fn watch() {
    WATCHED.get_or_init(system::watch);
}

/// Whether the command should stop.
pub(crate) fn asked_to_stop() -> bool {
    STOP.load(Ordering::SeqCst)
}

/// Makes a write beyond the file size limit (`ulimit -f`) fail with an error instead of killing the process.
pub(crate) fn make_too_large_files_an_error() {
    system::make_too_large_files_an_error();
}

#[cfg(unix)]
mod system {
    use super::STOP;
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
    use signal_hook::flag::{register, register_conditional_shutdown};
    use std::sync::Arc;

    /// A process ended by a signal has this exit status plus the signal's number, as in shells.
    const ENDED_BY: i32 = 128;

    pub(super) fn watch() {
        for signal in [SIGINT, SIGTERM, SIGHUP] {
            if signal == SIGHUP && may_be_ignored(signal) {
                continue;
            }
            // the order matters: the first signal finds no flag set, and sets it; if this fails, the signal ends the process as usual
            let _ = register_conditional_shutdown(signal, ENDED_BY + signal, Arc::clone(&STOP))
                .and_then(|_| register(signal, Arc::clone(&STOP)));
        }
    }

    /// Whether the parent process ignores this signal, as `nohup` does; also true if unknown.
    fn may_be_ignored(signal: i32) -> bool {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok());
        mask.is_none_or(|mask| mask & 1 << (signal - 1) != 0)
    }

    pub(super) fn make_too_large_files_an_error() {
        // with a handler the write fails with its reason; nobody reads the flag
        let _ = register(SIGXFSZ, Arc::default());
    }
}

#[cfg(not(unix))]
mod system {
    use super::STOP;
    use std::sync::atomic::Ordering;

    /// Exit status after Ctrl-C.
    const INTERRUPTED: i32 = 130;

    pub(super) fn watch() {
        // if this fails, Ctrl-C ends the process as usual
        let _ = ctrlc::set_handler(|| {
            if STOP.swap(true, Ordering::SeqCst) {
                std::process::exit(INTERRUPTED);
            }
        });
    }

    pub(super) fn make_too_large_files_an_error() {} // there is no such limit
}
