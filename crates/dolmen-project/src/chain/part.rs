//! The chain of a project file, and the chain of the science it builds.

use super::soil_part::SoilPart;
use super::support_part::ChainSupportPart;
use crate::heaviness::Heaviness;
use crate::loads::LoadsPart;
use crate::quantity::{Pick, Quantity};
use dolmen::assess::JointOnSoil;
use dolmen::dynamics::{ChainJoint, ChainModel, ChainRotations, DynamicsError, JointFriction, JointOpening};
use dolmen::stability::BedEdge;
use dolmen::structure::{Chain, Inertia, Link, Stone, StructureError};

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
    /// Width of its bed across the direction of motion, m; `None`: as wide as in it.
    pub bed_depth: Option<Quantity>,
    /// Compressive strength of its bed, Pa; `None`: it does not crush.
    pub strength: Option<Quantity>,
    /// Whether it opens, as the file says; `None`: at the edge of its bed where that is known.
    pub opening: Option<JointOpening>,
    /// Dry friction.
    pub friction: Option<JointFrictionPart>,
}

/// Dry friction of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct JointFrictionPart {
    /// Moment while it turns, N m.
    pub kinetic: Quantity,
    /// Moment before it turns, N m; as the kinetic one if not given.
    pub fixed: Option<Quantity>,
}

/// The stone of the links.
#[derive(Clone, Debug, PartialEq)]
pub struct StonePart {
    /// Young's modulus, Pa.
    pub elastic_modulus: Quantity,
    /// Poisson's ratio.
    pub poisson_ratio: Quantity,
    /// Density, kg/m³.
    pub density: Quantity,
}

impl StonePart {
    /// Its numbers, each with the value that `pick` chooses.
    pub fn build(&self, pick: Pick<'_>) -> Stone {
        Stone {
            elastic_modulus_pa: pick(&self.elastic_modulus),
            poisson_ratio: pick(&self.poisson_ratio),
            density_kg_m3: pick(&self.density),
        }
    }
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
    /// Damping ratio of the first mode, by dashpots in proportion to the springs.
    pub damping_ratio: Option<Quantity>,
    /// The stone of the links; `None` if it is not given.
    pub stone: Option<Box<StonePart>>,
    /// The soil below, in series with the lowest joint; `None` if the joint holds it.
    pub soil: Option<Box<SoilPart>>,
    /// What holds it at its side.
    pub side_supports: Vec<ChainSupportPart>,
    /// Acceleration of gravity, m/s², that turns weights into masses.
    pub gravity_m_s2: f64,
    /// How a survey found it to lean; `None` if none did, or the file leaves that out.
    pub lean: Option<ChainLean>,
}

/// How a survey found a chain to lean as a whole, beds with it.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainLean {
    /// The survey.
    pub survey: String,
    /// As written: "x 1/177, y 1/540".
    pub written: String,
    /// The tilts of all directions together, rad.
    pub lean_rad: f64,
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
        let mut links: Vec<Link> = links.collect();
        self.take_crushed_beds(&mut links, pick);
        let alone = Chain::new(links, self.gravity_m_s2)?;
        let supports = self.side_supports.iter().map(|support| support.build(pick));
        supports
            .collect::<Vec<_>>()
            .into_iter()
            .try_fold(alone, Chain::with_side_support)
    }

    /// Takes N/(f w) off the width of each bed that crushes: half of what is left, times N, is the moment of its stress block.
    fn take_crushed_beds(&self, links: &mut [Link], pick: Pick<'_>) {
        let mut normal_n = 0.0;
        let beds: Vec<Option<BedEdge>> = (0..links.len()).map(|i| self.bed(i, pick)).collect();
        for (link, bed) in links.iter_mut().zip(beds).rev() {
            normal_n += link.mass_kg * self.gravity_m_s2;
            if let Some(bed) = bed.filter(|bed| bed.strength_pa.is_some()) {
                link.bed_width_m = Some(2.0 * bed.moment_n_m(normal_n) / normal_n);
            }
        }
    }

    /// The bed below a link, from 0 at the bottom; `None` where its width is not given.
    pub fn bed(&self, link: usize, pick: Pick<'_>) -> Option<BedEdge> {
        let width_m = pick(self.links.get(link)?.bed_width.as_ref()?);
        let joint = self.joints.as_ref().and_then(|joints| joints.get(link));
        let depth = joint.and_then(|joint| joint.bed_depth.as_ref());
        let strength = joint.and_then(|joint| joint.strength.as_ref());
        Some(BedEdge {
            width_m,
            depth_m: depth.map_or(width_m, &mut *pick),
            strength_pa: strength.map(&mut *pick),
        })
    }

    /// Stiffness of each joint, N m/rad, lowest first, the soil in series with the lowest; `None` if the joints are unknown.
    pub fn stiffness_n_m_rad(&self, pick: Pick<'_>) -> Option<Vec<f64>> {
        let joints = self.joints.as_ref()?;
        let each = joints.iter().map(|joint| pick(&joint.stiffness));
        let mut stiffness: Vec<f64> = each.collect();
        if let (Some(soil), Some(lowest)) = (&self.soil, stiffness.first_mut()) {
            *lowest = soil.build(pick).in_series_n_m_rad(*lowest);
        }
        Some(stiffness)
    }

    /// The lowest joint and the soil below it; `None` if nothing is known of the soil.
    pub fn on_soil(&self, pick: Pick<'_>) -> Option<JointOnSoil> {
        let soil = self.soil.as_ref()?.build(pick);
        let joint = self.joints.as_ref().and_then(|joints| joints.first());
        let joint_n_m_rad = joint.map(|joint| pick(&joint.stiffness));
        Some(JointOnSoil {
            soil_n_m_rad: soil.rocking_n_m_rad(),
            joint_n_m_rad,
            together_n_m_rad: joint_n_m_rad.map(|joint| soil.in_series_n_m_rad(joint)),
            across: None,
        })
    }

    /// Dashpot of each joint, N m s/rad, lowest first, 0 where none is given; `None` if the joints are unknown.
    pub fn damping_n_m_s_rad(&self, pick: Pick<'_>) -> Option<Vec<f64>> {
        let joints = self.joints.as_ref()?;
        let damping = |joint: &JointPart| joint.damping.as_ref().map_or(0.0, &mut *pick);
        Some(joints.iter().map(damping).collect())
    }

    /// The chain with its springs, dashpots, beds, friction and lean, and the masses of its static loads, for time histories; `None` if the
    /// joints are unknown.
    ///
    /// # Errors
    /// [`DynamicsError`] for a damping ratio of a chain that falls by itself; else none with the file's own values.
    pub fn moving(
        &self,
        loads: &LoadsPart,
        rotations: ChainRotations,
        pick: Pick<'_>,
    ) -> Result<Option<ChainModel>, DynamicsError> {
        let (Some(joints), Some(stiffness)) = (&self.joints, self.stiffness_n_m_rad(pick)) else {
            return Ok(None);
        };
        let chain = self.build(pick)?;
        let chain = chain.with_added_masses(&loads.added_masses(&chain, pick))?;
        let mut built = Vec::with_capacity(joints.len());
        for ((part, link), stiffness_n_m_rad) in joints.iter().zip(chain.links()).zip(stiffness) {
            let by_bed = match link.bed_width_m {
                Some(_) => JointOpening::AtBedEdge,
                None => JointOpening::Held,
            };
            let friction = match &part.friction {
                None => JointFriction::None,
                Some(friction) => {
                    let kinetic_moment_n_m = pick(&friction.kinetic);
                    JointFriction::Coulomb {
                        static_moment_n_m: friction.fixed.as_ref().map_or(kinetic_moment_n_m, &mut *pick),
                        kinetic_moment_n_m,
                    }
                }
            };
            built.push(ChainJoint {
                stiffness_n_m_rad,
                damping_n_m_s_rad: part.damping.as_ref().map_or(0.0, &mut *pick),
                opening: part.opening.unwrap_or(by_bed),
                friction,
            });
        }
        let lean_rad = self.lean.as_ref().map_or(0.0, |lean| lean.lean_rad);
        let model = ChainModel::new(chain, built, rotations)?.leaning(lean_rad)?;
        Ok(Some(match &self.damping_ratio {
            None => model,
            Some(ratio) => model.with_first_mode_damping(pick(ratio))?,
        }))
    }

    pub(crate) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        for link in &self.links {
            all.extend([link.heaviness.quantity(), &link.length, &link.centroid]);
            all.extend(link.inertia.iter().chain(&link.breadth).chain(&link.bed_width));
        }
        for joint in self.joints.iter().flatten() {
            all.push(&joint.stiffness);
            all.extend(
                joint
                    .damping
                    .iter()
                    .chain(&joint.bed_depth)
                    .chain(&joint.strength),
            );
            if let Some(friction) = &joint.friction {
                all.push(&friction.kinetic);
                all.extend(&friction.fixed);
            }
        }
        all.extend(&self.damping_ratio);
        if let Some(stone) = &self.stone {
            all.extend([&stone.elastic_modulus, &stone.poisson_ratio, &stone.density]);
        }
        all.extend(self.soil.iter().flat_map(|soil| soil.inputs()));
        all.extend(self.side_supports.iter().flat_map(|support| support.inputs()));
    }
}
