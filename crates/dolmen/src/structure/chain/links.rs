//! The links of a chain (Choi 2021, Figs 10, 11, 13).
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | m_i | `mass_kg` | mass of link i; i = 1 is the lowest | kg |
//! | L_i | `length_m` | length of link i from joint to joint | m |
//! | l_i | `centroid_m` | height of the centre of mass of link i above its lower joint | m |
//! | J_i | `inertia` | moment of inertia of link i about a horizontal axis through its centre of mass | kg m² |
//! | b_i | `bed_width_m` | width of the bed below link i, in the direction of motion | m |

use super::SideSupport;
use crate::structure::StructureError;

/// How the moment of inertia of a link about its centre of mass is determined.
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
    /// Width of the bed below the link in the direction of motion, m, for the uplift limit of the lower joint.
    pub bed_width_m: Option<f64>,
}

impl Link {
    /// Moment of inertia J about the centre of mass, kg m²: the given value, m (b² + L²)/12 for a box (Choi 2021 eqs
    /// 15, 16), or m L²/12 for a thin rod.
    pub fn inertia_kg_m2(&self) -> f64 {
        const SLENDER: f64 = 12.0; // second moment of a uniform line of length L about its middle is L³/12
        let (m, l) = (self.mass_kg, self.length_m);
        match self.inertia {
            Inertia::Given(j) => j,
            Inertia::Box { breadth_m } => m * (breadth_m * breadth_m + l * l) / SLENDER,
            Inertia::ThinRod => m * l * l / SLENDER,
        }
    }
}

/// A chain of rigid links, lowest first. [`Chain::new`] checks the data, so every `Chain` is valid. The stiffness of
/// the joints is not included, because it is the unknown of the identification.
///
/// # Limits
/// Small rotations; rigid links; joints that transmit moments in both directions (no opening). Leaving out
/// the cap stone errs on the unsafe side: add its mass to the top link.
///
/// # Example
/// ```
/// use dolmen::structure::{Chain, Inertia, Link};
/// let stone = |mass_kg, length_m, centroid_m| Link {
///     mass_kg,
///     length_m,
///     centroid_m,
///     inertia: Inertia::ThinRod,
///     bed_width_m: None,
/// };
/// let chain = Chain::new(vec![stone(4000.0, 3.7, 1.6), stone(1500.0, 2.6, 1.2)], 9.81)?;
/// assert_eq!(chain.links().len(), 2);
/// assert!((chain.height_m() - 6.3).abs() < 1e-12);
/// # Ok::<(), dolmen::structure::StructureError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    links: Vec<Link>,
    gravity_m_s2: f64,
    side_supports: Vec<SideSupport>,
}

impl Chain {
    /// A chain of links, lowest first.
    ///
    /// # Errors
    /// [`StructureError::Empty`] without links; [`StructureError::Gravity`], [`StructureError::NotPositive`] or
    /// [`StructureError::Centroid`] for a value out of its range.
    pub fn new(links: Vec<Link>, gravity_m_s2: f64) -> Result<Self, StructureError> {
        if links.is_empty() {
            return Err(StructureError::Empty {
                kind: "chain",
                parts: "links",
            });
        }
        if !positive(gravity_m_s2) {
            return Err(StructureError::Gravity { given: gravity_m_s2 });
        }
        for (i, link) in links.iter().enumerate() {
            let mut quantities = vec![("mass_kg", link.mass_kg), ("length_m", link.length_m)];
            match link.inertia {
                Inertia::Given(j) => quantities.push(("inertia_kg_m2", j)),
                Inertia::Box { breadth_m } => quantities.push(("breadth_m", breadth_m)),
                Inertia::ThinRod => {}
            }
            quantities.extend(link.bed_width_m.map(|width| ("bed_width_m", width)));
            for (quantity, given) in quantities {
                if !positive(given) {
                    return Err(StructureError::NotPositive {
                        part: "link",
                        number: i + 1,
                        quantity,
                        given,
                    });
                }
            }
            let (centroid_m, length_m) = (link.centroid_m, link.length_m);
            if !(0.0..=length_m).contains(&centroid_m) {
                return Err(StructureError::Centroid {
                    link: i + 1,
                    centroid_m,
                    length_m,
                });
            }
        }
        Ok(Chain {
            links,
            gravity_m_s2,
            side_supports: Vec::new(),
        })
    }

    /// Adds a spring between the chain and the ground.
    ///
    /// # Errors
    /// [`StructureError::Height`] if the spring is not on the chain; [`StructureError::NotPositive`] for its
    /// stiffness; [`StructureError::Negative`] for its gap.
    pub fn with_side_support(mut self, support: SideSupport) -> Result<Self, StructureError> {
        support.check(self.side_supports.len() + 1, self.height_m())?;
        self.side_supports.push(support);
        Ok(self)
    }

    /// The chain with the centre of mass of one link (from 1 at the bottom) at `1 + change` times its height.
    ///
    /// # Errors
    /// [`StructureError::Part`] if there is no such link; [`StructureError::Centroid`] if the new centre of mass is
    /// outside the link.
    pub fn with_centroid_changed(&self, link: usize, change: f64) -> Result<Self, StructureError> {
        let mut links = self.links.clone();
        let most = links.len();
        match link.checked_sub(1).and_then(|i| links.get_mut(i)) {
            Some(chosen) => chosen.centroid_m *= 1.0 + change,
            None => {
                return Err(StructureError::Part {
                    part: "link",
                    given: link,
                    most,
                });
            }
        }
        let side_supports = self.side_supports.clone();
        Ok(Chain {
            side_supports,
            ..Chain::new(links, self.gravity_m_s2)?
        })
    }

    /// The links, lowest first.
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// Acceleration of gravity, m/s².
    pub fn gravity_m_s2(&self) -> f64 {
        self.gravity_m_s2
    }

    /// The side supports.
    pub fn side_supports(&self) -> &[SideSupport] {
        &self.side_supports
    }

    /// The chain without side supports.
    pub fn without_side_supports(&self) -> Self {
        Chain {
            side_supports: Vec::new(),
            ..self.clone()
        }
    }

    /// Height of the top above the lowest joint, m.
    pub fn height_m(&self) -> f64 {
        self.links.iter().map(|link| link.length_m).sum()
    }

    /// Height of each joint above the lowest, m, lowest first: the lower ends of the links.
    pub fn joint_heights_m(&self) -> Vec<f64> {
        let below = |height: &mut f64, link: &Link| {
            let joint = *height;
            *height += link.length_m;
            Some(joint)
        };
        self.links.iter().scan(0.0, below).collect()
    }

    /// Whether any link without a given moment of inertia is taken as a thin rod.
    pub fn assumes_thin_rods(&self) -> bool {
        self.links.iter().any(|link| link.inertia == Inertia::ThinRod)
    }
}

fn positive(x: f64) -> bool {
    x > 0.0 && x.is_finite()
}
