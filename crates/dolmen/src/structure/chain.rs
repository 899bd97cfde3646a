//! Chain: n rigid links on rotational springs, as a flagpole of stacked stones (Choi 2021).
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | m_i | `mass_kg` | mass of link i, 1 the lowest | kg |
//! | L_i | `length_m` | length of link i, joint to joint | m |
//! | l_i | `centroid_m` | height of its centre of mass above its lower joint | m |
//! | J_i | `inertia` | moment of inertia about its centre of mass, about a horizontal axis | kg m² |
//! | k_i | stiffness | rotational spring of the joint below link i | N m/rad |
//! | θ_i | | rotation of link i from the vertical | rad |

use super::StructureError;

/// Where a link's moment of inertia about its centre of mass comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Inertia {
    /// Given, kg m².
    Given(f64),
    /// A homogeneous box of this breadth in the direction of motion, m: m (b² + L²)/12.
    Box {
        /// Breadth in the direction of motion, m.
        breadth_m: f64,
    },
    /// Not given: a thin rod, m L²/12.
    ThinRod,
}

/// One rigid link.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Length from joint to joint, m.
    pub length_m: f64,
    /// Height of the centre of mass above the lower joint, m.
    pub centroid_m: f64,
    /// Moment of inertia.
    pub inertia: Inertia,
    /// Width of the bed below it in the direction of motion, m: for the uplift limit of its lower joint.
    pub bed_width_m: Option<f64>,
}

/// A chain of rigid links, lowest first, checked: only valid ones exist. The joints' stiffness is not part of it,
/// since it is what is sought.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    links: Vec<Link>,
    gravity_m_s2: f64,
}

impl Chain {
    /// A chain of links, lowest first.
    ///
    /// # Errors
    /// [`StructureError::Empty`], [`StructureError::NotPositive`], [`StructureError::Centroid`].
    pub fn new(links: Vec<Link>, gravity_m_s2: f64) -> Result<Self, StructureError> {
        if links.is_empty() {
            return Err(StructureError::Empty {
                kind: "chain",
                parts: "links",
            });
        }
        let positive = |number, quantity, given: f64| {
            let part = "link";
            if given > 0.0 && given.is_finite() {
                return Ok(());
            }
            Err(StructureError::NotPositive {
                part,
                number,
                quantity,
                given,
            })
        };
        positive(0, "gravity_m_s2", gravity_m_s2)?;
        for (i, link) in links.iter().enumerate() {
            positive(i + 1, "mass_kg", link.mass_kg)?;
            positive(i + 1, "length_m", link.length_m)?;
            match link.inertia {
                Inertia::Given(j) => positive(i + 1, "inertia_kg_m2", j)?,
                Inertia::Box { breadth_m } => positive(i + 1, "breadth_m", breadth_m)?,
                Inertia::ThinRod => {}
            }
            if let Some(width) = link.bed_width_m {
                positive(i + 1, "bed_width_m", width)?;
            }
            if !(link.centroid_m >= 0.0 && link.centroid_m <= link.length_m) {
                let (centroid_m, length_m) = (link.centroid_m, link.length_m);
                return Err(StructureError::Centroid {
                    link: i + 1,
                    centroid_m,
                    length_m,
                });
            }
        }
        Ok(Chain { links, gravity_m_s2 })
    }

    /// The links, lowest first.
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// Acceleration of gravity, m/s².
    pub fn gravity_m_s2(&self) -> f64 {
        self.gravity_m_s2
    }
}
