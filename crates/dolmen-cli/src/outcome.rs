//! How a run ended, other than by an error.

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// What was asked for is done.
    Done,
    /// A run that was asked for did not finish or converge.
    Unfinished,
    /// A judgement, or what could be done beside it, has this exit status.
    Judged(u8),
}

impl Outcome {
    /// Done, or not.
    pub(crate) fn finished(is_done: bool) -> Self {
        match is_done {
            true => Outcome::Done,
            false => Outcome::Unfinished,
        }
    }
}
