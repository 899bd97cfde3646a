//! Which components of the motions act on the structure of a combination, and what its runs leave out.

use super::motions::PreparedMotion;
use crate::frame::together::{has_both, is_in_plan};
use crate::wrong::OfRuns;
use dolmen::signal::Component;
use dolmen_project::{FramePart, Project, Structure, StudyPart};
use dolmen_words::message::Both;
use dolmen_words::number::trimmed;

/// Motions by name.
type Motions = [(String, PreparedMotion)];

/// Whether both components of a motion, along x and along y, act on the structure.
pub(super) fn meets_both(study: &StudyPart, project: &Project) -> bool {
    match &project.structure {
        Structure::Chain(part) => part.has_two_axes(),
        Structure::Frame(part) => is_in_plan(study, part),
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => false,
    }
}

/// The component of a motion with both that acts on a structure which meets only one: that along the direction of a frame, otherwise x.
pub(super) fn along(study: &StudyPart, project: &Project) -> Component {
    let direction = match &project.structure {
        Structure::Frame(part) => shaken(study, part),
        _ => None,
    };
    direction.and_then(|(_, along)| along).unwrap_or(Component::X)
}

/// The only direction of a frame that a study shakes, and the component along it; `None` if there are several.
fn shaken<'a>(study: &StudyPart, part: &'a FramePart) -> Option<(&'a str, Option<Component>)> {
    let chosen = |name: &str| match &study.direction {
        Some(direction) => direction == name,
        None => true,
    };
    let known = part.directions.iter();
    let known = known.filter(|own| own.stiffness.is_some() && chosen(&own.name));
    match known.collect::<Vec<_>>().as_slice() {
        [only] => Some((&only.name, only.along)),
        _ => None,
    }
}

/// The components of motions that do not act on the structure, which moves along one.
pub(super) fn across_left_out(study: &StudyPart, project: &Project, motions: &Motions) -> Option<Both> {
    let both = motions.iter().filter(|(_, motion)| has_both(&motion.motion));
    let motions: Vec<String> = both.map(|(name, _)| name.clone()).collect();
    if motions.is_empty() || meets_both(study, project) {
        return None;
    }
    match &project.structure {
        Structure::Frame(part) => {
            let (direction, _) = shaken(study, part)?;
            let acts = along(study, project);
            let left_out = match acts {
                Component::Y => Component::X,
                Component::X | Component::Z => Component::Y,
            };
            Some(
                OfRuns::AcrossOfDirection {
                    motions,
                    direction: direction.to_owned(),
                    acts: acts.name().to_owned(),
                    left_out: left_out.name().to_owned(),
                }
                .into(),
            )
        }
        Structure::Chain(_) => Some(OfRuns::AcrossOfPlane { motions }.into()),
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => None,
    }
}

/// Vertical components, which act on stacks alone: the largest over the horizontal peak of its motion.
pub(super) fn vertical_left_out(motions: &Motions) -> Option<Both> {
    let each = motions.iter();
    let each = each.filter_map(|(_, motion)| motion.vertical_over_peak());
    let most = each.reduce(f64::max)?;
    let percent = trimmed(100.0 * most, 3);
    Some(OfRuns::VerticalLeftOut { percent }.into())
}

/// What older journals of frames computed in another way: the component along the direction of the study, and crushed tenons.
pub(super) fn counted_otherwise(
    study: &StudyPart,
    project: &Project,
    motions: &Motions,
) -> Vec<(String, String)> {
    let Structure::Frame(part) = &project.structure else {
        return Vec::new();
    };
    let meets_y = along(study, project) == Component::Y && across_left_out(study, project, motions).is_some();
    let component = meets_y.then(|| ("component that acts".to_owned(), Component::Y.name().to_owned()));
    let has_tenons = part.directions.iter().any(|own| own.tenons.is_some());
    let tenons = has_tenons.then(|| ("crushed tenons".to_owned(), "counted".to_owned()));
    component.into_iter().chain(tenons).collect()
}
