//! Common parts of the answers on a check: findings, comparison of versions, scatter, assumptions.

mod agreement;
mod assumed;
mod findings;
mod from_surveys;
mod made_stones;
mod measured;
mod project;
mod sampled;
mod text;
mod variant_responses;
mod variant_rows;
mod variant_stacks;
mod variants;
mod versions;

pub(crate) use findings::findings;
pub(crate) use from_surveys::from_surveys_text;
pub(crate) use measured::{over_the_years, tilt_beyond};
pub use project::{against_studies_text, against_text};
pub(crate) use project::{doubtful, made_up_text, project_text};
pub(crate) use sampled::sections as scatter_sections;
pub use text::check_text;
pub(crate) use variants::{section as variants_section, title, version};
pub(crate) use versions::{is_of_variant, variants_in_full};

use dolmen_words::Template;

/// Templates of the sentences of every check.
pub(crate) const TEMPLATES: [&[Template]; 13] = [
    agreement::Agreement::TEMPLATES,
    assumed::Assumed::TEMPLATES,
    findings::Unusual::TEMPLATES,
    from_surveys::Identified::TEMPLATES,
    made_stones::Made::TEMPLATES,
    measured::Measured::TEMPLATES,
    project::Size::TEMPLATES,
    sampled::Scatter::TEMPLATES,
    text::Said::TEMPLATES,
    variant_responses::Responses::TEMPLATES,
    variant_stacks::StackVariant::TEMPLATES,
    variants::Variants::TEMPLATES,
    versions::OfVariant::TEMPLATES,
];
