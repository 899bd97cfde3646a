//! Properties in a project file that runs under ground motion include or leave out; the same for `simulate` and `study`.

use crate::tilt_left_out::TiltLeftOut;
use crate::wrong::{CaseRefused, OfRuns};
use dolmen::structure::stack::Stack;
use dolmen_project::{FramePart, LoadPart, Project, Structure};
use dolmen_words::message::Both;

/// A property that runs leave out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct LeftOutOfRuns {
    pub(crate) wind: bool,
    /// Forces and moments of static loads on a chain, frame or building; for a stack they act.
    pub(crate) forces: bool,
    /// Stones of a stack whose beds have lost stiffness, which the rigid law does not include.
    pub(crate) loosened: Vec<String>,
    /// A surveyed tilt.
    pub(crate) tilt: Option<TiltLeftOut>,
    /// Free-standing columns beside joints, whose storeys keep their stiffness where feet lift off.
    pub(crate) columns: bool,
}

impl LeftOutOfRuns {
    pub(crate) fn of(project: &Project) -> Self {
        LeftOutOfRuns {
            wind: project.loads.wind().is_some(),
            forces: matches!(
                project.structure,
                Structure::Chain(_) | Structure::Frame(_) | Structure::Building(_)
            ) && project.loads.loads.iter().any(LoadPart::pushes),
            loosened: match &project.structure {
                Structure::Stack(part) => part.loosened_beds.iter().map(|bed| bed.block.clone()).collect(),
                _ => Vec::new(),
            },
            tilt: match &project.structure {
                Structure::Building(_) => TiltLeftOut::of(&project.surveys),
                Structure::Frame(part) if part.lean.is_none() => TiltLeftOut::of(&project.surveys),
                Structure::Chain(part) if part.lean.is_none() => TiltLeftOut::of(&project.surveys),
                Structure::Chain(_) | Structure::Frame(_) | Structure::Stack(_) => {
                    TiltLeftOut::of_model(project)
                }
                Structure::Survey => None,
            },
            columns: match &project.structure {
                Structure::Frame(part) => has_columns_beside_joints(part),
                _ => false,
            },
        }
    }

    /// A sentence for each, for runs by the rigid law or by springs.
    pub(crate) fn words(&self, is_rigid: bool) -> Vec<Both> {
        let tilt = self.tilt.clone().map(|of| OfRuns::TiltLeftOut {
            survey: of.survey,
            tilt: of.written,
        });
        let all = [
            self.wind.then_some(OfRuns::WindLeftOut),
            self.forces.then_some(OfRuns::ForcesLeftOut),
            (is_rigid && !self.loosened.is_empty()).then(|| OfRuns::LoosenedLeftOut(self.loosened.clone())),
            tilt,
            self.columns.then_some(OfRuns::ColumnsLeftOut),
        ];
        all.into_iter().flatten().map(Both::from).collect()
    }
}

/// Whether a storey with free-standing columns has joints or walls in a direction of known stiffness.
fn has_columns_beside_joints(part: &FramePart) -> bool {
    let known = part.directions.iter().filter_map(|own| own.stiffness.as_ref());
    let mut storeys = known.flat_map(|stiffness| part.storeys.iter().zip(stiffness));
    storeys.any(|(storey, stiffness)| storey.columns.is_some() && stiffness.value != 0.0)
}

/// A sentence for each property that runs include in addition to the structure and its weight.
pub(crate) fn held_in_runs(project: &Project) -> Vec<Both> {
    let (lean, posts) = match &project.structure {
        Structure::Stack(part) => (part.lean.as_ref().map(|of| (&of.survey, &of.written)), 0),
        Structure::Chain(part) => (
            part.lean.as_ref().map(|of| (&of.survey, &of.written)),
            part.side_supports.len(),
        ),
        Structure::Frame(part) => (part.lean.as_ref().map(|of| (&of.survey, &of.written)), 0),
        Structure::Building(_) | Structure::Survey => (None, 0),
    };
    let lean = lean.map(|(survey, tilt)| OfRuns::Leans {
        survey: survey.clone(),
        tilt: tilt.clone(),
    });
    let loads = &project.loads.loads;
    let loads = match &project.structure {
        Structure::Stack(_) if !loads.is_empty() => Some(OfRuns::LoadsAct),
        Structure::Chain(_) | Structure::Frame(_) if loads.iter().any(|load| load.weight.is_some()) => {
            Some(OfRuns::LoadsMove)
        }
        _ => None,
    };
    let posts = (posts > 0).then_some(OfRuns::SidePosts(posts));
    let all = [lean, loads, posts];
    all.into_iter().flatten().map(Both::from).collect()
}

/// Why runs of a stack do not give its capacity: loads without mass press its joints together, or its supports move before the ground shakes.
pub(crate) fn no_capacity(stack: &Stack) -> Option<CaseRefused> {
    let mut moved = stack.support_movements().iter();
    if moved.any(|of| of.movement_m.iter().any(|part| *part != 0.0)) {
        return Some(CaseRefused::SupportsMove);
    }
    stack.is_pressed().then_some(CaseRefused::PressedWithoutMass)
}
