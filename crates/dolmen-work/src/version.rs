//! The versions of a project: as it is, and its variants.

use crate::error::WorkError;
use crate::opened::Opened;
use dolmen_project::{Names, Project};

/// A version of a project: as it is, or a variant with its name and title.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Version<'a> {
    pub(crate) file: &'a str,
    pub(crate) project: &'a Project,
    pub(crate) variant: Option<&'a str>,
    pub(crate) title: Option<&'a Names>,
}

impl<'a> Version<'a> {
    /// The project as it is, then its variants.
    pub(crate) fn all(project: &'a Project, file: &'a str) -> Vec<Version<'a>> {
        let own = Version {
            file,
            project,
            variant: None,
            title: None,
        };
        let variants = project.variants.iter().map(|variant| Version {
            file,
            project: &variant.project,
            variant: Some(&variant.name),
            title: variant.title.as_ref(),
        });
        [own].into_iter().chain(variants).collect()
    }

    /// The project as it is, or the variant of this name.
    pub(crate) fn named(opened: &'a Opened, name: Option<&str>) -> Result<Version<'a>, WorkError> {
        let all = Version::all(&opened.project, &opened.file);
        let found = all.iter().find(|version| version.variant == name).copied();
        found.ok_or_else(|| no_such_variant(&opened.project, name.unwrap_or_default()))
    }
}

/// The error for an unknown variant, with the names of the variants.
pub(crate) fn no_such_variant(project: &Project, name: &str) -> WorkError {
    let names: Vec<&str> = project.variants.iter().map(|v| v.name.as_str()).collect();
    WorkError::NoSuchVariant {
        name: name.to_owned(),
        known: match names.is_empty() {
            true => "none".to_owned(),
            false => names.join(", "),
        },
    }
}
