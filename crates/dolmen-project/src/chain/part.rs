//! The chain of a project file, and the chain of the library that it builds.

use super::axis::ChainAxis;
use super::support_part::ChainSupportPart;
use crate::heaviness::Heaviness;
use crate::loads::LoadsPart;
use crate::quantity::{Pick, Quantity};
use crate::soil::SoilPart;
use crate::sought::Sought;
use dolmen::assess::JointOnSoil;
use dolmen::dynamics::{ChainJoint, ChainModel, ChainRotations, DynamicsError, JointFriction, JointOpening};
use dolmen::structure::Stone;

/// One link, from the file.
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
    /// Moment of inertia across the direction of motion, kg m²; `None`: by its depth, else that in the direction of motion.
    pub inertia_across: Option<Quantity>,
    /// Breadth in the direction of motion, m: the link's inertia is then that of a box.
    pub breadth: Option<Quantity>,
    /// Breadth across, m.
    pub depth: Option<Quantity>,
    /// Width of the bed below it in the direction of motion, m.
    pub bed_width: Option<Quantity>,
}

/// The joint below a link.
#[derive(Clone, Debug, PartialEq)]
pub struct JointPart {
    /// Rotational stiffness, N m/rad.
    pub stiffness: Quantity,
    /// Stiffness across the direction of motion; `None`: by the sides of its bed.
    pub stiffness_across: Option<Quantity>,
    /// Rotational dashpot, N m s/rad.
    pub damping: Option<Quantity>,
    /// Width of its bed across the direction of motion, m; `None`: equal to that in the direction of motion.
    pub bed_depth: Option<Quantity>,
    /// Compressive strength of its bed, Pa; `None`: no crushing.
    pub strength: Option<Quantity>,
    /// Whether the joint opens, by the file; `None`: it opens at the edge of its bed if that is known.
    pub opening: Option<JointOpening>,
    /// Dry friction.
    pub friction: Option<JointFrictionPart>,
}

/// Dry friction of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct JointFrictionPart {
    /// Moment while it rotates, N m.
    pub kinetic: Quantity,
    /// Moment before it rotates, N m; the kinetic one if not given.
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
    /// The numbers of the stone, each with the value that `pick` chooses.
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
    /// There is no such part, or it is one of the links.
    Included,
    /// It is left out: unconservative, with a warning.
    LeftOut,
}

/// Links on joints, lowest first.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainPart {
    /// The links.
    pub links: Vec<LinkPart>,
    /// The joint below each link; `None` if they are unknown.
    pub joints: Option<Vec<JointPart>>,
    /// The survey from which to identify their stiffness, where the file leaves it to one.
    pub sought: Option<Sought>,
    /// Whether the part at the very top is among the links.
    pub cap: Cap,
    /// Damping ratio of the first mode, by dashpots in proportion to the springs.
    pub damping_ratio: Option<Quantity>,
    /// The stone of the links, if given.
    pub stone: Option<Box<StonePart>>,
    /// The soil below, in series with the lowest joint; `None` if the stiffness of the joint includes it.
    pub soil: Option<Box<SoilPart>>,
    /// Its side supports.
    pub side_supports: Vec<ChainSupportPart>,
    /// Acceleration of gravity, m/s², that turns weights into masses.
    pub gravity_m_s2: f64,
    /// Its measured lean; `None` if no survey gives one, or the file leaves it out.
    pub lean: Option<ChainLean>,
    /// Whether the file leaves the measured lean out: `as_surveyed = "none"`.
    pub takes_no_tilt: bool,
}

/// The measured lean of a whole chain, beds included.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainLean {
    /// The survey.
    pub survey: String,
    /// The text of the file: "x 1/177, y 1/540".
    pub written: String,
    /// The tilts of all directions combined, rad.
    pub lean_rad: f64,
    /// The tilts in the direction of motion and across, rad; both the combined tilt where the survey does not name x and y.
    pub each_rad: [f64; 2],
}

impl ChainLean {
    /// The tilt in a direction, rad.
    pub fn towards_rad(&self, axis: ChainAxis) -> f64 {
        match axis {
            ChainAxis::Along => self.each_rad[0],
            ChainAxis::Across => self.each_rad[1],
        }
    }
}

impl ChainPart {
    /// The lowest joint and the soil below it; `None` if no soil is given.
    pub fn on_soil(&self, pick: Pick<'_>) -> Option<JointOnSoil> {
        let soil = self.soil.as_ref()?.build(pick);
        let joint = self.joints.as_ref().and_then(|joints| joints.first());
        let joint_n_m_rad = joint.map(|joint| pick(&joint.stiffness));
        Some(JointOnSoil {
            soil_n_m_rad: soil.rocking_n_m_rad(),
            joint_n_m_rad,
            together_n_m_rad: joint_n_m_rad.map(|joint| soil.in_series_n_m_rad(joint)),
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
    /// [`DynamicsError`] for a damping ratio of a chain that falls under its own weight; none else with the file's own values.
    pub fn moving(
        &self,
        loads: &LoadsPart,
        rotations: ChainRotations,
        pick: Pick<'_>,
    ) -> Result<Option<ChainModel>, DynamicsError> {
        self.moving_towards(loads, (rotations, ChainAxis::Along), pick)
    }

    /// [`ChainPart::moving`] in another direction.
    ///
    /// # Errors
    /// As [`ChainPart::moving`].
    pub fn moving_towards(
        &self,
        loads: &LoadsPart,
        (rotations, axis): (ChainRotations, ChainAxis),
        pick: Pick<'_>,
    ) -> Result<Option<ChainModel>, DynamicsError> {
        let (Some(joints), Some(stiffness)) = (&self.joints, self.stiffness_towards(axis, pick)) else {
            return Ok(None);
        };
        let chain = self.build_loaded(axis, loads, pick)?;
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
        let lean_rad = self.lean.as_ref().map_or(0.0, |lean| match self.has_two_axes() {
            false => lean.lean_rad,
            true => lean.towards_rad(axis),
        });
        let model = ChainModel::new(chain, built, rotations)?.leaning(lean_rad)?;
        Ok(Some(match &self.damping_ratio {
            None => model,
            Some(ratio) => model.with_first_mode_damping(pick(ratio))?,
        }))
    }

    /// Pairs of inputs of which the first is never above the second: the friction moment of a joint while it turns and before.
    pub(crate) fn ordered_inputs(&self) -> Vec<[&Quantity; 2]> {
        let joints = self.joints.iter().flatten();
        let each = joints.filter_map(|joint| {
            let friction = joint.friction.as_ref()?;
            Some([&friction.kinetic, friction.fixed.as_ref()?])
        });
        each.collect()
    }

    pub(crate) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        for link in &self.links {
            all.extend([link.heaviness.quantity(), &link.length, &link.centroid]);
            let sides = link.breadth.iter().chain(&link.depth).chain(&link.bed_width);
            all.extend(link.inertia.iter().chain(&link.inertia_across).chain(sides));
        }
        for joint in self.joints.iter().flatten() {
            all.push(&joint.stiffness);
            all.extend(
                joint
                    .stiffness_across
                    .iter()
                    .chain(&joint.damping)
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
