//! The chain of a project file, and the chain of the science it builds.

use super::quantity::{Pick, Quantity};
use dolmen::structure::{Chain, Inertia, Link, StructureError};

/// How heavy a part is: the file gives one of the two.
#[derive(Clone, Debug, PartialEq)]
pub enum Heaviness {
    /// Mass, kg.
    Mass(Quantity),
    /// Weight, N: divided by the project's gravity.
    Weight(Quantity),
}

impl Heaviness {
    /// The number the file gives.
    pub fn quantity(&self) -> &Quantity {
        match self {
            Heaviness::Mass(quantity) | Heaviness::Weight(quantity) => quantity,
        }
    }

    /// Mass, kg, with the value that `pick` chooses.
    pub fn mass_kg(&self, gravity_m_s2: f64, pick: Pick<'_>) -> f64 {
        match self {
            Heaviness::Mass(mass) => pick(mass),
            Heaviness::Weight(weight) => pick(weight) / gravity_m_s2,
        }
    }
}

/// One link as the file gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkPart {
    /// Name, if given.
    pub name: Option<String>,
    /// Weight or mass.
    pub heaviness: Heaviness,
    /// Length from joint to joint, m.
    pub length: Quantity,
    /// Height of the centre of mass above the link's lower joint, m.
    pub centroid: Quantity,
    /// Moment of inertia about the centre of mass, kg m².
    pub inertia: Option<Quantity>,
    /// Breadth in the direction of motion, m: the link's inertia is then that of a box.
    pub breadth: Option<Quantity>,
    /// Width of the bed below it in the direction of motion, m.
    pub bed_width: Option<Quantity>,
}

/// The joint below a link.
#[derive(Clone, Debug, PartialEq)]
pub struct JointPart {
    /// Rotational stiffness, N m/rad.
    pub stiffness: Quantity,
    /// Rotational dashpot, N m s/rad.
    pub damping: Option<Quantity>,
}

/// Whether the part at the very top (cap stone, finial) is among the links.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cap {
    /// There is none, or it is among the links.
    Included,
    /// It is left out: unconservative, and warned about.
    LeftOut,
}

/// Links on joints, lowest first.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainPart {
    /// The links.
    pub links: Vec<LinkPart>,
    /// The joint below each link; `None` if they are unknown.
    pub joints: Option<Vec<JointPart>>,
    /// Whether the part at the very top is among the links.
    pub cap: Cap,
    /// Acceleration of gravity, m/s², that turns weights into masses.
    pub gravity_m_s2: f64,
}

impl ChainPart {
    /// The chain, each input with the value that `pick` chooses (`&mut Quantity::nominal` for the file's own).
    ///
    /// # Errors
    /// None with the file's own values, which are checked on reading. A picked value may be impossible, for
    /// instance a centroid above the link's top: [`StructureError`].
    pub fn build(&self, pick: Pick<'_>) -> Result<Chain, StructureError> {
        let links = self.links.iter().map(|part| {
            let length_m = pick(&part.length);
            let inertia = match (&part.inertia, &part.breadth) {
                (Some(given), _) => Inertia::Given(pick(given)),
                (None, Some(breadth)) => Inertia::Box {
                    breadth_m: pick(breadth),
                },
                (None, None) => Inertia::ThinRod,
            };
            Link {
                mass_kg: part.heaviness.mass_kg(self.gravity_m_s2, pick),
                length_m,
                centroid_m: pick(&part.centroid),
                inertia,
                bed_width_m: part.bed_width.as_ref().map(&mut *pick),
            }
        });
        Chain::new(links.collect(), self.gravity_m_s2)
    }

    /// Stiffness of each joint, N m/rad, lowest first; `None` if the joints are unknown.
    pub fn stiffness_n_m_rad(&self, pick: Pick<'_>) -> Option<Vec<f64>> {
        let joints = self.joints.as_ref()?;
        Some(joints.iter().map(|joint| pick(&joint.stiffness)).collect())
    }

    /// Dashpot of each joint, N m s/rad, lowest first, 0 where none is given; `None` if the joints are unknown.
    pub fn damping_n_m_s_rad(&self, pick: Pick<'_>) -> Option<Vec<f64>> {
        let joints = self.joints.as_ref()?;
        let damping = |joint: &JointPart| joint.damping.as_ref().map_or(0.0, &mut *pick);
        Some(joints.iter().map(damping).collect())
    }

    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        for link in &self.links {
            all.extend([link.heaviness.quantity(), &link.length, &link.centroid]);
            all.extend(link.inertia.iter().chain(&link.breadth).chain(&link.bed_width));
        }
        for joint in self.joints.iter().flatten() {
            all.push(&joint.stiffness);
            all.extend(&joint.damping);
        }
    }
}
