//! Additional masses on the links of a chain.

use super::{Chain, Inertia, Link};
use crate::structure::StructureError;

/// An additional mass at one height of a link, such as a lamp or a board.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AddedMass {
    /// The link, from 0 at the bottom.
    pub link: usize,
    /// Height above the joint below the link, m.
    pub height_m: f64,
    /// Mass, kg.
    pub mass_kg: f64,
}

impl Chain {
    /// The chain with additional masses on its links: mass, centroid and moment of inertia of each link include the mass
    /// that it carries.
    ///
    /// ```text
    /// m' = m + a,   c' = (m c + a h) / m',   J' = J + m a (h − c)² / m'
    /// ```
    ///
    /// # Errors
    /// [`StructureError`] if a link with its added mass is invalid: a negative mass, or a height that is not a number.
    pub fn with_added_masses(&self, added: &[AddedMass]) -> Result<Self, StructureError> {
        let mut links: Vec<Link> = self.links().to_vec();
        for of in added {
            let Some(link) = links.get_mut(of.link) else {
                continue;
            };
            let mass_kg = link.mass_kg + of.mass_kg;
            let apart_m = of.height_m - link.centroid_m;
            let reduced_kg = link.mass_kg * of.mass_kg / mass_kg;
            link.inertia = Inertia::Given(link.inertia_kg_m2() + reduced_kg * apart_m * apart_m);
            link.centroid_m = (link.mass_kg * link.centroid_m + of.mass_kg * of.height_m) / mass_kg;
            link.mass_kg = mass_kg;
        }
        let loaded = Chain::new(links, self.gravity_m_s2())?;
        let supports = self.side_supports().iter().copied();
        supports.into_iter().try_fold(loaded, Chain::with_side_support)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_two_point_masses_on_a_rod() {
        let rod = Link {
            mass_kg: 600.0,
            length_m: 3.0,
            centroid_m: 1.5,
            inertia: Inertia::ThinRod,
            bed_width_m: Some(0.5),
        };
        let chain = Chain::new(vec![rod], 9.81).unwrap();
        let added = [2.0, 3.0].map(|height_m| AddedMass {
            link: 0,
            height_m,
            mass_kg: 200.0,
        });
        let loaded = chain.with_added_masses(&added).unwrap();
        let link = &loaded.links()[0];
        // about the joint: 600 · 3²/3 + 200 (2² + 3²) = 4400 kg m²; centroid (600 · 1.5 + 200 · 5) / 1000 = 1.9 m
        assert!((link.mass_kg - 1000.0).abs() < 1e-9 && (link.centroid_m - 1.9).abs() < 1e-12);
        let about_joint = link.inertia_kg_m2() + 1000.0 * 1.9 * 1.9;
        assert!((about_joint - 4400.0).abs() < 1e-9, "{about_joint}");
    }
}
