//! The motion before the runs of a study.

use super::model::Model;
use super::motions::acting_component;
use super::run::{Run, RunOutcome};
use super::state_before::StateBefore;
use crate::at_rest::{AtRest, SPEED_AT_REST_M_S, WAIT_MOST_S};
use crate::error::WorkError;
use crate::progress::Silent;
use crate::told::told_both;
use crate::wrong::CaseRefused;
use crate::{chain, frame, stack};
use dolmen::signal::{Component, GroundMotion, motion_sequence};
use dolmen_project::StudyPart;
use dolmen_words::message::Both;

/// Effect of the earlier motion on a case.
pub(super) enum EarlierShaking {
    /// There is none for this case.
    Unshaken(StateBefore),
    /// The structure is at rest after it.
    Left(Box<RestState>),
    /// The structure fell in it.
    Fell(StateBefore),
    /// No run can follow.
    Refused {
        /// The reason.
        why: Both,
        /// The state so far.
        state: StateBefore,
    },
}

impl EarlierShaking {
    /// The state, where known.
    pub(super) fn state(&self) -> &StateBefore {
        match self {
            EarlierShaking::Left(left) => &left.state,
            EarlierShaking::Unshaken(state)
            | EarlierShaking::Fell(state)
            | EarlierShaking::Refused { state, .. } => state,
        }
    }

    /// A case that is refused.
    pub(super) fn refused(case: usize, why: Both) -> Self {
        let run = Run {
            outcome: RunOutcome::Refused,
            why: why.clone(),
            ..Run::empty(case)
        };
        EarlierShaking::Refused {
            why,
            state: StateBefore::of(case, f64::NAN, &run),
        }
    }

    /// A case without an earlier motion.
    pub(super) fn unshaken(case: usize) -> Self {
        EarlierShaking::Unshaken(StateBefore::of(case, 0.0, &Run::empty(case)))
    }
}

/// A structure at rest after the first motion.
pub(super) struct RestState {
    first: GroundMotion,
    /// Whether only one component acts.
    in_plane: bool,
    state: StateBefore,
}

impl RestState {
    /// The first motion, the time to rest and another motion as one.
    pub(super) fn then(&self, second: &GroundMotion) -> Result<GroundMotion, WorkError> {
        let both = match self.in_plane {
            true => motion_sequence(&along_x(&self.first)?, self.state.still_s, &along_x(second)?)?,
            false => motion_sequence(&self.first, self.state.still_s, second)?,
        };
        Ok(both.motion)
    }
}

/// The component that acts in a plane, as x.
fn along_x(motion: &GroundMotion) -> Result<GroundMotion, WorkError> {
    let samples = motion.acceleration_m_s2(acting_component(motion)).to_vec();
    let series = vec![(Component::X, samples)];
    Ok(GroundMotion::new(motion.name(), motion.time_step_s(), series)?)
}

/// The first motion as it acts on a case.
pub(super) struct FirstMotion {
    pub(super) acting: GroundMotion,
    pub(super) peak_m_s2: f64,
    /// Whether only one component acts.
    pub(super) in_plane: bool,
}

/// Runs a case under the first motion alone, extended until it is at rest.
pub(super) fn shaken_before(
    study: &StudyPart,
    model: &Model,
    case: usize,
    first: FirstMotion,
) -> EarlierShaking {
    let FirstMotion {
        acting: first,
        peak_m_s2,
        in_plane,
    } = first;
    let whole_s = first.duration_s();
    let mut rest_s = None;
    loop {
        let longer = StudyPart {
            rest_s: rest_s.or(study.rest_s),
            ..study.clone()
        };
        let Some((run, rest)) = alone(&longer, model, &first, case) else {
            return EarlierShaking::refused(case, CaseRefused::NoVerdictBefore.into());
        };
        let mut state = StateBefore::of(case, peak_m_s2, &run);
        if run.outcome == RunOutcome::Fell {
            return EarlierShaking::Fell(state);
        }
        let is_whole = matches!(
            run.outcome,
            RunOutcome::Stood | RunOutcome::Uplifted | RunOutcome::Slid
        );
        let Some(AtRest { end_s, speed_m_s }) = rest.filter(|_| is_whole) else {
            let why = match run.why.english.is_empty() {
                true => CaseRefused::NoVerdictBefore.into(),
                false => CaseRefused::UndecidedBefore(run.why.clone()).into(),
            };
            return refused(state, why);
        };
        let still_s = end_s - whole_s;
        (state.still_s, state.speed_m_s) = (still_s, speed_m_s);
        if speed_m_s <= SPEED_AT_REST_M_S {
            return EarlierShaking::Left(Box::new(RestState {
                first,
                in_plane,
                state,
            }));
        }
        if 2.0 * still_s > WAIT_MOST_S {
            let why = CaseRefused::MovingBefore {
                speed_mm_s: format!("{:.1}", 1e3 * speed_m_s),
                still_s: format!("{still_s:.0}"),
                most_mm_s: format!("{:.0}", 1e3 * SPEED_AT_REST_M_S),
            };
            return refused(state, why.into());
        }
        rest_s = Some(2.0 * still_s);
    }
}

fn refused(mut state: StateBefore, why: Both) -> EarlierShaking {
    state.why = why.clone();
    EarlierShaking::Refused { why, state }
}

/// The run under the first motion alone, and its end.
fn alone(
    study: &StudyPart,
    model: &Model,
    first: &GroundMotion,
    case: usize,
) -> Option<(Run, Option<AtRest>)> {
    let run = Run {
        scale: 1.0,
        ..Run::empty(case)
    };
    match model {
        Model::Stack(model) => stack::study::row_and_rest(study, run, (&model.0, &model.1), first),
        Model::Frame(model) => frame::study::row_and_rest(study, run, model, (first, &Silent)),
        Model::Chain(model) => chain::study::row_and_rest(study, run, model, (first, &Silent)),
        Model::Building(_) => None,
    }
}

/// Why the structure of a case cannot be run under the first motion.
pub(super) fn why_refused(why: &WorkError) -> Both {
    told_both(why)
}
