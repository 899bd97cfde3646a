//! Motions of a project that cannot be read, reported before a simulation needs them.

use crate::answer::UnreadableMotion;
use crate::motion::{MotionRequest, prepared};
use crate::told::told_both;
use dolmen_project::{MotionSource, Project};
use dolmen_records::Files;

/// Motions whose files are missing or do not fit the project.
pub fn unreadable_motions(project: &Project, files: &dyn Files) -> Vec<UnreadableMotion> {
    let of_files = project
        .motions
        .iter()
        .filter(|motion| matches!(motion.from, MotionSource::Files(_)));
    let each = of_files.filter_map(|motion| {
        let why = prepared(&MotionRequest::named(&motion.name), (project, files)).err()?;
        Some(UnreadableMotion {
            motion: motion.name.clone(),
            why: told_both(&why),
        })
    });
    each.collect()
}
