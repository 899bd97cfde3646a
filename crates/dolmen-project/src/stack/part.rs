//! The stack of a project file.

use super::attached_part::{CornicePart, MastPart};
use super::loose_material::loose_material;
use super::made_part::MadePart;
use super::surveyed_lean::SurveyedLean;
use crate::loads::LoadPart;
use crate::quantity::{Evidence, Quantity};
use crate::soil::SoilBelowPart;
use dolmen::structure::stack::{Body, JointMaterial, Solid};

/// The shape of a block, from the file.
#[derive(Clone, Debug, PartialEq)]
pub enum ShapePart {
    /// width × depth × height.
    Box {
        /// Width along x, m.
        width: Quantity,
        /// Depth along y, m; `None`: equal to the width.
        depth: Option<Quantity>,
        /// Height, m.
        height: Quantity,
    },
    /// A box with another width and depth at its top.
    Frustum {
        /// Along x at its base, m.
        width: Quantity,
        /// Along y at its base, m; `None`: equal to the width.
        depth: Option<Quantity>,
        /// At its top.
        top: Box<TopPart>,
        /// Upwards, m.
        height: Quantity,
    },
    /// A regular polygon in plan.
    Prism {
        /// Number of its sides.
        sides: u32,
        /// Across flats at its base, m.
        width: Quantity,
        /// Across flats at its top, m; `None`: equal to that at its base.
        top_width: Option<Quantity>,
        /// Upwards, m.
        height: Quantity,
    },
    /// An upright cylinder.
    Drum {
        /// At its base, m.
        diameter: Quantity,
        /// At its top, m; `None`: equal to that at its base.
        top_diameter: Option<Quantity>,
        /// Upwards, m.
        height: Quantity,
    },
    /// The convex hull of points.
    Points {
        /// Their coordinates, m.
        points: Vec<[Quantity; 3]>,
        /// Origin of the coordinates.
        frame: PointsFrame,
    },
    /// A closed mesh from a file.
    Mesh(Box<MeshPart>),
}

/// The origin of the coordinates of points or of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointsFrame {
    /// The origin is that of the stone: it is moved so that its lowest point is at its base, in the middle of its bounds in plan.
    Own,
    /// The origin is that of the site: the stone stays at these coordinates.
    Site,
}

/// A stone from a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshPart {
    /// Its file, with the name in the project.
    pub file: String,
    /// Number of triangles in the file.
    pub triangles: usize,
    /// Length of the unit of the file, m.
    pub unit_m: f64,
    /// The stone, m.
    pub solid: Solid,
    /// The origin of its coordinates.
    pub frame: PointsFrame,
}

/// The slenderness factor of a pagoda that the file gives.
#[derive(Clone, Debug, PartialEq)]
pub enum PagodaSlendernessPart {
    /// Height of all storeys over the width of the first body.
    Body(Quantity),
    /// Least half width over height of the centroid above it.
    Angle(Quantity),
}

/// A pagoda made from six factors; `None`: the default of the library.
#[derive(Clone, Debug, PartialEq)]
pub struct PagodaPart {
    /// Storeys.
    pub storeys: u32,
    /// Height of all storeys, without the base, m.
    pub body_height: Quantity,
    /// Its slenderness.
    pub slenderness: Option<PagodaSlendernessPart>,
    /// Taper of the body, rad.
    pub taper: Option<Quantity>,
    /// Height of all storeys over that of the base.
    pub body_base_height_ratio: Option<Quantity>,
}

/// The top of a frustum.
#[derive(Clone, Debug, PartialEq)]
pub struct TopPart {
    /// Along x, m.
    pub width: Quantity,
    /// Along y, m; `None` in proportion to the depth at its base.
    pub depth: Option<Quantity>,
}

/// A box-shaped opening in a block.
#[derive(Clone, Debug, PartialEq)]
pub struct OpeningPart {
    /// Along x, m.
    pub width: Quantity,
    /// Along y, m; `None` as wide.
    pub depth: Option<Quantity>,
    /// Upwards, m.
    pub height: Quantity,
    /// Centre of its floor from the centre of the block's base, m.
    pub position: [Quantity; 3],
}

/// The properties of a joint; `None`: as in the joints around it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BedPart {
    /// Coefficient of static friction; also of kinetic friction unless that is given.
    pub friction: Option<Quantity>,
    /// Kinetic friction coefficient.
    pub friction_kinetic: Option<Quantity>,
    /// Shear strength of the bond beyond friction, Pa.
    pub cohesion: Option<Quantity>,
    /// Tensile strength of the bond, Pa.
    pub tension: Option<Quantity>,
    /// Compressive strength, Pa; without it no edge crushes.
    pub strength: Option<Quantity>,
    /// Normal stiffness per area, Pa/m.
    pub normal_stiffness: Option<Quantity>,
    /// Shear stiffness per area, Pa/m.
    pub shear_stiffness: Option<Quantity>,
    /// Dashpots as a fraction of critical damping.
    pub damping_ratio: Option<Quantity>,
    /// Restitution of a stone that falls flat.
    pub normal_restitution: Option<Quantity>,
    /// Restitution of rocking from edge to edge, of the rigid law.
    pub rocking_restitution: Option<Quantity>,
}

/// Dolmen's default values of joints, used where a file gives none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JointDefaults {
    /// Friction coefficient.
    pub friction: Option<f64>,
    /// Normal stiffness per area, Pa/m.
    pub normal_stiffness_pa_m: Option<f64>,
    /// Shear stiffness per area, Pa/m.
    pub shear_stiffness_pa_m: Option<f64>,
    /// Dashpots as a fraction of critical damping.
    pub damping_ratio: Option<f64>,
}

impl JointDefaults {
    /// Number of defaults used.
    pub fn count(&self) -> usize {
        let all = [
            self.friction,
            self.normal_stiffness_pa_m,
            self.shear_stiffness_pa_m,
            self.damping_ratio,
        ];
        all.iter().flatten().count()
    }
}

/// One block, from the file.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockPart {
    /// Its name, unique.
    pub name: String,
    /// Its shape.
    pub shape: ShapePart,
    /// Its openings.
    pub openings: Vec<OpeningPart>,
    /// Steps below it.
    pub cornice: Option<CornicePart>,
    /// A mast on it.
    pub mast: Option<MastPart>,
    /// Density, kg/m³; `None` that of the stack.
    pub density: Option<Quantity>,
    /// Its supports: blocks, or the ground; empty if it keeps its place and the file names none.
    pub on: Vec<Body>,
    /// Plan position of the centre of its base, m; `None`: the middle of its supports.
    pub at: Option<[Quantity; 2]>,
    /// Shift from there, m.
    pub offset: Option<[Quantity; 2]>,
    /// Rotation about the vertical, rad.
    pub rotation: Option<Quantity>,
    /// Leaning towards x and y, horizontal / vertical.
    pub tilt: [Option<Quantity>; 2],
    /// The joints below it.
    pub joint: BedPart,
}

/// A joint with its own properties.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactPart {
    /// One body.
    pub lower: Body,
    /// The other, a block by its index.
    pub upper: usize,
    /// Its own properties.
    pub joint: BedPart,
}

/// A dowel or clamp, from the file.
#[derive(Clone, Debug, PartialEq)]
pub struct TiePart {
    /// One body.
    pub lower: Body,
    /// The other, a block by its index.
    pub upper: usize,
    /// Point at which it crosses the joint, m.
    pub position: [Quantity; 3],
    /// Unit vector of its axis.
    pub axis: [f64; 3],
    /// Stiffness along it, N/m.
    pub axial_stiffness: Option<Quantity>,
    /// Stiffness across it, N/m.
    pub shear_stiffness: Quantity,
    /// Tension at which it breaks, N.
    pub tension_strength: Option<Quantity>,
    /// Shear at which it breaks, N.
    pub shear_strength: Quantity,
}

/// A side support of a block, from the file.
#[derive(Clone, Debug, PartialEq)]
pub struct SideSupportPart {
    /// The block, by its index.
    pub block: usize,
    /// Point of the block that meets it, m.
    pub position: [Quantity; 3],
    /// Unit vector in which the block must move to meet it.
    pub direction: [f64; 3],
    /// The distance that it must move, m.
    pub gap: Option<Quantity>,
    /// Stiffness once met, N/m.
    pub stiffness: Quantity,
}

/// The movement of the ground under a block, from the file.
#[derive(Clone, Debug, PartialEq)]
pub struct SupportMovementPart {
    /// The block, by its index.
    pub block: usize,
    /// Along x, y and upwards, m; `None`: 0.
    pub movement: [Option<Quantity>; 3],
}

/// A bed of which a part no longer bears, by an inspection.
#[derive(Clone, Debug, PartialEq)]
pub struct LostBedPart {
    /// The name of the block above it.
    pub block: String,
    /// Share of its width.
    pub share: f64,
    /// The side from which it is lost, x and y.
    pub outward: [f64; 2],
    /// Its path in the file.
    pub path: String,
}

/// The bed of a block whose springs have lost stiffness.
#[derive(Clone, Debug, PartialEq)]
pub struct LoosenedBedPart {
    /// The name of the block above it.
    pub block: String,
    /// Remaining share of the normal and shear stiffness.
    pub factor: f64,
    /// Its path in the file.
    pub path: String,
}

/// Whether the file marks a value as measured or tested.
fn is_measured(value: &Quantity) -> bool {
    matches!(
        value.source,
        Some(Evidence::Measured | Evidence::Test | Evidence::Identified)
    )
}

/// Blocks, lowest first, the joints between them, ties and side supports.
#[derive(Clone, Debug, PartialEq)]
pub struct StackPart {
    /// The blocks in the order of the file; empty if they are generated.
    pub blocks: Vec<BlockPart>,
    /// The pagoda that generates the blocks, if the file does not list them.
    pub pagoda: Option<PagodaPart>,
    /// Another generator of the blocks, if there is neither a list nor a pagoda.
    pub made: Option<MadePart>,
    /// Whether the blocks are loose stones, which settle first and have no joints of their own.
    pub is_loose: bool,
    /// Density of the blocks that have none of their own, kg/m³.
    pub density: Option<Quantity>,
    /// The properties of every joint without its own.
    pub joint: BedPart,
    /// Joints with their own properties, by the two blocks that meet.
    pub contacts: Vec<ContactPart>,
    /// Dowels and clamps.
    pub ties: Vec<TiePart>,
    /// Side supports of blocks.
    pub side_supports: Vec<SideSupportPart>,
    /// Supports that spread or settle.
    pub support_movement: Vec<SupportMovementPart>,
    /// Static loads on its blocks; their inputs are listed with those of the file's loads.
    pub static_loads: Vec<LoadPart>,
    /// Beds of which a part is lost.
    pub lost_beds: Vec<LostBedPart>,
    /// Beds that have lost stiffness.
    pub loosened_beds: Vec<LoosenedBedPart>,
    /// The soil under it; `None` for rigid ground.
    pub soil: Option<SoilBelowPart>,
    /// How it leans as surveyed; `None` if upright, or if blocks carry their own tilt.
    pub lean: Option<SurveyedLean>,
    /// Acceleration of gravity, m/s².
    pub gravity_m_s2: f64,
}

impl StackPart {
    /// Whether every joint has a measured or tested normal stiffness; a joint without one takes Dolmen's default, which is assumed.
    pub fn has_measured_stiffness(&self) -> bool {
        let is_measured = |bed: &BedPart| bed.normal_stiffness.as_ref().map(is_measured);
        let blocks = self.blocks.iter().map(|block| &block.joint);
        let mut own = blocks.chain(self.contacts.iter().map(|contact| &contact.joint));
        is_measured(&self.joint) == Some(true) && own.all(|bed| is_measured(bed) != Some(false))
    }

    /// The properties that neither `joint` nor every block gives, for which Dolmen's defaults are used; all of them are assumed.
    pub fn joint_defaults(&self) -> JointDefaults {
        let is_given = |key: fn(&BedPart) -> &Option<Quantity>| {
            let blocks = &self.blocks;
            let own = !blocks.is_empty() && blocks.iter().all(|block| key(&block.joint).is_some());
            key(&self.joint).is_some() || own
        };
        let usual = match self.is_loose {
            true => loose_material(),
            false => JointMaterial::default(),
        };
        let taken = |is_given: bool, value: f64| (!is_given).then_some(value);
        JointDefaults {
            friction: taken(is_given(|bed| &bed.friction), usual.friction_static),
            normal_stiffness_pa_m: taken(is_given(|bed| &bed.normal_stiffness), usual.normal_stiffness_pa_m),
            shear_stiffness_pa_m: taken(is_given(|bed| &bed.shear_stiffness), usual.shear_stiffness_pa_m),
            damping_ratio: taken(is_given(|bed| &bed.damping_ratio), usual.damping_ratio),
        }
    }

    /// Whether its blocks have their own tilt, offset or coordinates, so that a surveyed tilt is not added.
    pub fn carries_own_lean(&self) -> bool {
        self.blocks.iter().any(BlockPart::has_own_place)
    }
}

impl BlockPart {
    /// Whether it gives its own displacement from its place: tilt, offset, or coordinates of the site.
    pub(super) fn has_own_place(&self) -> bool {
        self.offset.is_some() || self.tilt.iter().any(Option::is_some) || self.shape.keeps_its_place()
    }
}

impl ShapePart {
    /// Its dimensions: width, depth, height, and so on.
    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        match self {
            ShapePart::Box { width, depth, height } => {
                all.push(width);
                all.extend(depth);
                all.push(height);
            }
            ShapePart::Frustum {
                width,
                depth,
                top,
                height,
            } => {
                all.push(width);
                all.extend(depth);
                all.push(&top.width);
                all.extend(&top.depth);
                all.push(height);
            }
            ShapePart::Prism {
                width,
                top_width,
                height,
                ..
            } => {
                all.push(width);
                all.extend(top_width);
                all.push(height);
            }
            ShapePart::Drum {
                diameter,
                top_diameter,
                height,
            } => {
                all.push(diameter);
                all.extend(top_diameter);
                all.push(height);
            }
            ShapePart::Points { points, .. } => all.extend(points.iter().flatten()),
            ShapePart::Mesh(_) => {}
        }
    }

    /// Whether its coordinates are those of the site.
    pub(super) fn keeps_its_place(&self) -> bool {
        match self {
            ShapePart::Points { frame, .. } => *frame == PointsFrame::Site,
            ShapePart::Mesh(mesh) => mesh.frame == PointsFrame::Site,
            _ => false,
        }
    }
}

impl PagodaPart {
    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.push(&self.body_height);
        match &self.slenderness {
            Some(PagodaSlendernessPart::Body(given) | PagodaSlendernessPart::Angle(given)) => all.push(given),
            None => {}
        }
        all.extend(&self.taper);
        all.extend(&self.body_base_height_ratio);
    }
}

impl BedPart {
    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        let each = [
            &self.friction,
            &self.friction_kinetic,
            &self.cohesion,
            &self.tension,
            &self.strength,
            &self.normal_stiffness,
            &self.shear_stiffness,
            &self.damping_ratio,
            &self.normal_restitution,
            &self.rocking_restitution,
        ];
        all.extend(each.into_iter().flatten());
    }
}

impl StackPart {
    /// Pairs of inputs of which the first is never above the second: kinetic and static friction of a bed.
    pub(crate) fn ordered_inputs(&self) -> Vec<[&Quantity; 2]> {
        let blocks = self.blocks.iter().map(|block| &block.joint);
        let contacts = self.contacts.iter().map(|contact| &contact.joint);
        let beds = std::iter::once(&self.joint).chain(blocks).chain(contacts);
        let each = beds.filter_map(|bed| Some([bed.friction_kinetic.as_ref()?, bed.friction.as_ref()?]));
        each.collect()
    }

    pub(crate) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.extend(&self.density);
        self.joint.inputs(all);
        all.extend(self.soil.iter().flat_map(SoilBelowPart::inputs));
        if let Some(pagoda) = &self.pagoda {
            pagoda.inputs(all);
        }
        match &self.made {
            Some(MadePart::Arch(arch)) => arch.inputs(all),
            Some(MadePart::Wall(wall)) => wall.inputs(all),
            Some(MadePart::Tower(tower)) => tower.inputs(all),
            Some(MadePart::Trilithon(trilithon)) => trilithon.inputs(all),
            Some(MadePart::Vault(vault)) => vault.inputs(all),
            Some(MadePart::Dome(dome)) => dome.inputs(all),
            None => {}
        }
        for block in &self.blocks {
            block.shape.inputs(all);
            for opening in &block.openings {
                all.push(&opening.width);
                all.extend(&opening.depth);
                all.push(&opening.height);
                all.extend(&opening.position);
            }
            block.attached_inputs(all);
            all.extend(&block.density);
            all.extend(block.at.iter().flatten());
            all.extend(block.offset.iter().flatten());
            all.extend(&block.rotation);
            all.extend(block.tilt.iter().flatten());
            block.joint.inputs(all);
        }
        for contact in &self.contacts {
            contact.joint.inputs(all);
        }
        for tie in &self.ties {
            all.extend(&tie.position);
            all.extend(&tie.axial_stiffness);
            all.push(&tie.shear_stiffness);
            all.extend(&tie.tension_strength);
            all.push(&tie.shear_strength);
        }
        for support in &self.side_supports {
            all.extend(&support.position);
            all.extend(&support.gap);
            all.push(&support.stiffness);
        }
        for support in &self.support_movement {
            all.extend(support.movement.iter().flatten());
        }
    }
}
