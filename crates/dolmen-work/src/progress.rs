//! Progress of a verb, and requests to stop.

/// A stage of work.
#[derive(Clone, Debug, PartialEq)]
pub enum Stage {
    /// A run over simulated time; its position is in seconds.
    Simulating {
        /// Length of the run, s.
        whole_s: f64,
    },
    /// Runs of a study, approximate; its position counts them.
    Runs {
        /// Number of runs, approximate.
        about: usize,
    },
    /// Reading of a record.
    Reading {
        /// Its file.
        file: String,
    },
    /// Identification of the modes of a record.
    Identifying {
        /// Its file.
        file: String,
    },
    /// Identification of all setups as one.
    Joining,
}

/// Receives the progress of a verb, and may stop it; finished work is kept.
pub trait Progress: Send + Sync {
    /// Begins a stage, which replaces the one before.
    fn begin(&self, stage: &Stage);
    /// The stage has reached `position`, in its own unit.
    fn advance(&self, position: f64);
    /// The stage is over.
    fn end(&self);
    /// Whether to stop at the next point where finished work can be kept.
    fn is_cancelled(&self) -> bool;
}

/// Ignores progress and never stops.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn begin(&self, _stage: &Stage) {}

    fn advance(&self, _position: f64) {}

    fn end(&self) {}

    fn is_cancelled(&self) -> bool {
        false
    }
}

/// Runs `run` as a stage of simulated time: `run` reports the time reached, and learns whether to continue.
pub(crate) fn simulating<T>(
    progress: &dyn Progress,
    whole_s: f64,
    run: impl FnOnce(&mut dyn FnMut(f64) -> bool) -> T,
) -> T {
    progress.begin(&Stage::Simulating { whole_s });
    let done = run(&mut |time_s| {
        progress.advance(time_s);
        !progress.is_cancelled()
    });
    progress.end();
    done
}
