//! Signals: Ctrl-C, SIGTERM and SIGHUP end a run and keep what is done, and a file beyond the system's limit is an error like any other.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock, OnceLock};

/// The command was asked to stop: what is under way ends at its next sample and keeps what is done.
static STOP: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);
/// Signals are watched from the first run on, once a process.
static WATCHED: OnceLock<()> = OnceLock::new();

/// From now on Ctrl-C, SIGTERM and SIGHUP ask to end and keep what is done; a second one ends the process.
pub(crate) fn watch() {
    WATCHED.get_or_init(system::watch);
}

/// Whether the command was asked to stop.
pub(crate) fn asked_to_stop() -> bool {
    STOP.load(Ordering::SeqCst)
}

/// From now on a write beyond the limit on the size of files (`ulimit -f`) fails; it killed the process.
pub(crate) fn make_too_large_files_an_error() {
    system::make_too_large_files_an_error();
}

#[cfg(unix)]
mod system {
    use super::STOP;
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
    use signal_hook::flag::{register, register_conditional_shutdown};
    use std::sync::Arc;

    /// Exit status of a process that a signal ends, as shells have it: this and the signal's number.
    const ENDED_BY: i32 = 128;

    pub(super) fn watch() {
        for signal in [SIGINT, SIGTERM, SIGHUP] {
            if signal == SIGHUP && may_be_ignored(signal) {
                continue;
            }
            // in this order: the first signal finds no flag set, and sets it. Where one cannot be watched, it ends the process as it would
            let _ = register_conditional_shutdown(signal, ENDED_BY + signal, Arc::clone(&STOP))
                .and_then(|_| register(signal, Arc::clone(&STOP)));
        }
    }

    /// Whether who started the command asked for this signal to be passed over, as `nohup` does; also where that cannot be known.
    fn may_be_ignored(signal: i32) -> bool {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok());
        mask.is_none_or(|mask| mask & 1 << (signal - 1) != 0)
    }

    pub(super) fn make_too_large_files_an_error() {
        // the write that meets a handler fails with its reason, and nobody reads the flag
        let _ = register(SIGXFSZ, Arc::default());
    }
}

#[cfg(not(unix))]
mod system {
    use super::STOP;
    use std::sync::atomic::Ordering;

    /// Exit status of a process that Ctrl-C ends.
    const INTERRUPTED: i32 = 130;

    pub(super) fn watch() {
        // where Ctrl-C cannot be watched, it ends the process as it would
        let _ = ctrlc::set_handler(|| {
            if STOP.swap(true, Ordering::SeqCst) {
                std::process::exit(INTERRUPTED);
            }
        });
    }

    pub(super) fn make_too_large_files_an_error() {} // there is no such limit
}
