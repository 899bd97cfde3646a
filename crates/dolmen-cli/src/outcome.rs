//! How a run ended, other than by an error.

/// The end of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// The work is done.
    Done,
    /// A requested run did not finish or converge.
    Unfinished,
    /// The exit status of a judgement.
    Judged(u8),
}

impl Outcome {
    /// Done or unfinished.
    pub(crate) fn finished(is_done: bool) -> Self {
        match is_done {
            true => Outcome::Done,
            false => Outcome::Unfinished,
        }
    }
}
