//! What a verb says while it works, and how it is asked to stop.

/// What is under way.
#[derive(Clone, Debug, PartialEq)]
pub enum Stage {
    /// A run of so many seconds of simulated time; its position is in seconds.
    Simulating {
        /// Length of the run, s.
        whole_s: f64,
    },
    /// About so many runs of a study; its position counts them.
    Runs {
        /// How many, more or less.
        about: usize,
    },
    /// A record is read.
    Reading {
        /// Its file.
        file: String,
    },
    /// Modes of a record are sought.
    Identifying {
        /// Its file.
        file: String,
    },
    /// Setups are identified as one.
    Joining,
}

/// Hears how far a verb has come, and may ask it to stop. What is done is then kept.
pub trait Progress: Send + Sync {
    /// A stage begins; it replaces the one before.
    fn begin(&self, stage: &Stage);
    /// The stage has come to `position`, in its own unit.
    fn advance(&self, position: f64);
    /// The stage is over.
    fn end(&self);
    /// Whether to stop at the next place where what is done can be kept.
    fn is_cancelled(&self) -> bool;
}

/// Says nothing and never stops.
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

/// Runs `run` as a stage of simulated time: `run` reports the time that it reached, and learns whether to go on.
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
