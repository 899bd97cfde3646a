//! Heights at which the modes of a chain or frame have their displacements.

use dolmen_project::{Quantity, Structure};

/// Heights of the top of each link of a chain, or of each level of a frame, m; `None` for other kinds.
pub fn mode_heights_m(structure: &Structure) -> Option<Vec<f64>> {
    match structure {
        Structure::Frame(part) => {
            let frame = part.build(&mut Quantity::nominal).ok()?;
            Some(frame.level_heights_m())
        }
        Structure::Chain(part) => {
            let chain = part.build(&mut Quantity::nominal).ok()?;
            let tops = chain.links().iter().scan(0.0, |height, link| {
                *height += link.length_m;
                Some(*height)
            });
            Some(tops.collect())
        }
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => None,
    }
}
