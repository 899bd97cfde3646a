//! `dolmen new KIND DIR --bare`: a file of placeholders, without the surveys, variants and sources of an example.

use crate::cli::Kind;

/// The project file of a new project.
pub(crate) fn skeleton(kind: Kind) -> &'static str {
    match kind {
        Kind::Flagpole => include_str!("bare/flagpole.toml"),
        Kind::Gate => include_str!("bare/gate.toml"),
        Kind::Pagoda => include_str!("bare/pagoda.toml"),
        Kind::Arch => include_str!("bare/arch.toml"),
        Kind::Wall => include_str!("bare/wall.toml"),
        Kind::Tower => include_str!("bare/tower.toml"),
        Kind::Trilithon => include_str!("bare/trilithon.toml"),
        Kind::Vault => include_str!("bare/vault.toml"),
        Kind::Dome => include_str!("bare/dome.toml"),
        Kind::Building => include_str!("bare/building.toml"),
        Kind::Survey => include_str!("bare/survey.toml"),
    }
}
