//! Motions of a project that cannot be read: said before somebody wants to shake it.

use crate::answer::UnreadableMotion;
use crate::motion::{MotionRequest, prepared};
use crate::told::told_both;
use dolmen_project::{MotionSource, Project};
use dolmen_records::Files;

/// The motions of files that are missing, or not what the project says of them.
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
