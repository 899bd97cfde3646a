//! Stacks as they are written.

use crate::file_number::{At, QuantityRaw};
use crate::file_way::WayRaw;
use schemars::JsonSchema;

/// Coordinates of a point.
pub(super) type PointRaw = At<Vec<At<QuantityRaw>>>;

/// Shape of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum ShapeRaw {
    /// width × depth × height.
    Box,
    /// The same with top_width × top_depth at its top.
    Frustum,
    /// A regular polygon of so many sides in plan, width across its flats; one side faces along x.
    Prism,
    /// An upright cylinder.
    Drum,
    /// The convex hull of points.
    Points,
    /// A closed mesh of triangles from a file.
    Mesh,
}

/// Where the coordinates of points or of a mesh count from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum CoordinatesRaw {
    /// The stone's own: it is moved so that its lowest point is its base, in the middle of its bounds in plan.
    Own,
    /// Those of the site: it stays where they put it.
    Site,
}

/// The six factors of a pagoda.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct PagodaRaw {
    /// Storeys, 1 to 13.
    #[schemars(required)]
    pub(super) storeys: Option<At<i64>>,
    /// Height of all storeys, without the base.
    #[schemars(required)]
    pub(super) body_height: Option<At<QuantityRaw>>,
    /// Height of all storeys over the width of the first body; or slenderness_angle. 3.74 if neither is given.
    pub(super) body_slenderness: Option<At<QuantityRaw>>,
    /// Least half width over height of the centroid above it, a ratio or "21 deg"; or body_slenderness.
    pub(super) slenderness_angle: Option<At<QuantityRaw>>,
    /// How the body narrows, with its unit; "8 deg" if not given.
    pub(super) taper: Option<At<QuantityRaw>>,
    /// Height of all storeys over that of the base; 3 if not given.
    pub(super) body_base_height_ratio: Option<At<QuantityRaw>>,
}

/// An arch of flat-faced voussoirs.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ArchRaw {
    /// Clear span of the inner line at the springing.
    #[schemars(required)]
    pub(super) span: Option<At<QuantityRaw>>,
    /// Rise of the inner line: half the span, a round arch, if not given; less is a segment of a circle, more a pointed arch.
    pub(super) rise: Option<At<QuantityRaw>>,
    /// Thickness of the ring, along the joints.
    #[schemars(required)]
    pub(super) thickness: Option<At<QuantityRaw>>,
    /// Along y.
    #[schemars(required)]
    pub(super) depth: Option<At<QuantityRaw>>,
    /// Number of voussoirs, 2 to 400; an odd number has a keystone.
    #[schemars(required)]
    pub(super) voussoirs: Option<At<i64>>,
    /// Height of the springing above the ground, on two abutments; 0, on the ground, if not given.
    pub(super) springing_height: Option<At<QuantityRaw>>,
    /// Width of the abutments; twice the thickness if not given.
    pub(super) abutment: Option<At<QuantityRaw>>,
}

/// A wall in running bond.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct StoneWallRaw {
    /// Along x.
    #[schemars(required)]
    pub(super) length: Option<At<QuantityRaw>>,
    /// Along y.
    #[schemars(required)]
    pub(super) thickness: Option<At<QuantityRaw>>,
    /// Number of courses, 1 to 100.
    #[schemars(required)]
    pub(super) courses: Option<At<i64>>,
    /// Height of a course.
    #[schemars(required)]
    pub(super) course_height: Option<At<QuantityRaw>>,
    /// Length of a whole stone.
    #[schemars(required)]
    pub(super) stone_length: Option<At<QuantityRaw>>,
    /// Leaves side by side across the thickness, 1 to 3; 1 if not given. Only through stones and lintels hold them together.
    pub(super) leaves: Option<At<i64>>,
    /// Width of the core between two leaves, whose filling is left out; a tenth of the thickness if not given.
    pub(super) core: Option<At<QuantityRaw>>,
    /// Every so many courses one is of through stones, as thick as the wall; none if not given.
    pub(super) through_every: Option<At<i64>>,
    /// Doors and windows.
    pub(super) openings: Option<Vec<At<WallOpeningRaw>>>,
}

/// A door or window of a wall.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct WallOpeningRaw {
    /// From the left end of the wall to its left side.
    #[schemars(required)]
    pub(super) from: Option<At<QuantityRaw>>,
    /// Clear width.
    #[schemars(required)]
    pub(super) width: Option<At<QuantityRaw>>,
    /// Its lowest course, from 1; 1 if not given.
    pub(super) first_course: Option<At<i64>>,
    /// How many courses it is high.
    #[schemars(required)]
    pub(super) courses: Option<At<i64>>,
    /// How far its lintel, one course high, lies on either side; a quarter of the clear width if not given.
    pub(super) bearing: Option<At<QuantityRaw>>,
}

/// Plan of a tower.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum TowerPlanRaw {
    /// A square, its sides along x and y.
    Square,
    /// A circle.
    Round,
}

/// A tower of courses, each set back alike.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TowerRaw {
    /// "square" or "round"; "square" if not given.
    pub(super) plan: Option<At<TowerPlanRaw>>,
    /// Width or diameter of the lowest course.
    #[schemars(required)]
    pub(super) width: Option<At<QuantityRaw>>,
    /// The same of the top course; as width if not given.
    pub(super) top_width: Option<At<QuantityRaw>>,
    /// Number of courses, 1 to 200.
    #[schemars(required)]
    pub(super) courses: Option<At<i64>>,
    /// Height of a course.
    #[schemars(required)]
    pub(super) course_height: Option<At<QuantityRaw>>,
    /// Thickness of the wall of a hollow tower; solid, one stone a course, if not given.
    pub(super) thickness: Option<At<QuantityRaw>>,
    /// Of a round hollow tower: stones in a ring, 6 to 48; 12 if not given.
    pub(super) stones: Option<At<i64>>,
}

/// Two posts and a lintel.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TrilithonRaw {
    /// Clear span between the posts.
    #[schemars(required)]
    pub(super) span: Option<At<QuantityRaw>>,
    /// Width of a post, along x.
    #[schemars(required)]
    pub(super) post_width: Option<At<QuantityRaw>>,
    /// Height of the posts.
    #[schemars(required)]
    pub(super) post_height: Option<At<QuantityRaw>>,
    /// Depth of posts and lintel, along y; as post_width if not given.
    pub(super) depth: Option<At<QuantityRaw>>,
    /// Height of the lintel.
    #[schemars(required)]
    pub(super) lintel_height: Option<At<QuantityRaw>>,
    /// How far the lintel goes beyond the outer faces of the posts; negative where it ends on them, 0 if not given.
    pub(super) overhang: Option<At<QuantityRaw>>,
}

/// Bond of courses or rings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum BondRaw {
    /// Every second course is shifted by half a stone.
    Running,
    /// Joints above each other.
    Straight,
}

/// A barrel vault on two abutments or on the ground, its axis along y.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct VaultRaw {
    /// Clear span of the inner line at the springing.
    #[schemars(required)]
    pub(super) span: Option<At<QuantityRaw>>,
    /// Rise of the inner line: half the span, a round barrel, if not given; less is a segment of a circle, more a pointed barrel.
    pub(super) rise: Option<At<QuantityRaw>>,
    /// Thickness along the bed joints.
    #[schemars(required)]
    pub(super) thickness: Option<At<QuantityRaw>>,
    /// Along the axis, y.
    #[schemars(required)]
    pub(super) length: Option<At<QuantityRaw>>,
    /// Number of courses from one springing to the other, 2 to 400.
    #[schemars(required)]
    pub(super) voussoirs: Option<At<i64>>,
    /// Stones of a course along the axis, 1 to 100.
    #[schemars(required)]
    pub(super) stones: Option<At<i64>>,
    /// "running" or "straight"; "running" if not given.
    pub(super) bond: Option<At<BondRaw>>,
    /// Height of the springing above the ground, on two abutments; 0, on the ground, if not given.
    pub(super) springing_height: Option<At<QuantityRaw>>,
    /// Width of the abutments; twice the thickness if not given.
    pub(super) abutment: Option<At<QuantityRaw>>,
}

/// What of a dome is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum DomePieceRaw {
    /// All of it.
    Whole,
    /// Two opposite slices, each one stone wide, with a keystone between them.
    Lune,
}

/// A spherical dome on a drum or on the ground.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct DomeRaw {
    /// Clear diameter of the inner sphere at the springing, between opposite corners.
    #[schemars(required)]
    pub(super) span: Option<At<QuantityRaw>>,
    /// Rise of the inner sphere: half the span, a hemisphere, if not given; less is a cap.
    pub(super) rise: Option<At<QuantityRaw>>,
    /// Thickness along the joints.
    #[schemars(required)]
    pub(super) thickness: Option<At<QuantityRaw>>,
    /// Rings above each other, 1 to 40.
    #[schemars(required)]
    pub(super) rings: Option<At<i64>>,
    /// Stones in a ring, 6 to 48.
    #[schemars(required)]
    pub(super) stones: Option<At<i64>>,
    /// "whole" or "lune", two opposite slices; "whole" if not given.
    pub(super) part: Option<At<DomePieceRaw>>,
    /// Bond of a whole dome: "running" or "straight"; "running" if not given. Slices are one stone wide and have none.
    pub(super) bond: Option<At<BondRaw>>,
    /// Diameter of the opening at the top, between opposite corners; closed by a keystone if not given.
    pub(super) oculus: Option<At<QuantityRaw>>,
    /// Height of the springing above the ground, on a drum; 0, on the ground, if not given.
    pub(super) drum_height: Option<At<QuantityRaw>>,
    /// Thickness of the drum; twice that of the dome if not given.
    pub(super) drum_thickness: Option<At<QuantityRaw>>,
}

/// Names of one or several blocks.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(untagged)]
#[schemars(extend("x-must-be" = "the name of a block, a list of names, or \"ground\""))]
pub(super) enum OnRaw {
    One(String),
    Several(Vec<String>),
}

/// Leaning: horizontal / vertical in either direction.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct LeanRaw {
    /// Towards x: "1/200", a ratio, or text with a unit ("0.3 deg", "5 mm/m").
    pub(super) x: Option<At<QuantityRaw>>,
    /// Towards y.
    pub(super) y: Option<At<QuantityRaw>>,
}

/// What acts in a joint; what is not given is that of the joints around it.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct BedRaw {
    /// Friction coefficient; 0.6 if not given.
    pub(super) friction: Option<At<QuantityRaw>>,
    /// Friction coefficient while it slips, if it is less than friction.
    pub(super) friction_kinetic: Option<At<QuantityRaw>>,
    /// Shear strength of the bond beyond friction, a stress; 0 if not given: dry.
    pub(super) cohesion: Option<At<QuantityRaw>>,
    /// Tensile strength of the bond, a stress; 0 if not given: dry.
    pub(super) tension: Option<At<QuantityRaw>>,
    /// Compressive strength of stone or mortar in the joint, a stress: its edges crush under blocks of this stress; they never crush if not given.
    pub(super) strength: Option<At<QuantityRaw>>,
    /// Normal stiffness per area; 1e9 Pa/m if not given.
    pub(super) normal_stiffness: Option<At<QuantityRaw>>,
    /// Shear stiffness per area; 4e8 Pa/m if not given.
    pub(super) shear_stiffness: Option<At<QuantityRaw>>,
    /// Dashpots as a fraction of critical damping, 0 to 1; 0.3 if not given.
    pub(super) damping_ratio: Option<At<QuantityRaw>>,
    /// Part of the velocity that a stone keeps when it falls flat, 0 to 1; 0 if not given. Contact springs take it as their damping_ratio.
    pub(super) normal_restitution: Option<At<QuantityRaw>>,
    /// Part of its angular velocity that a stone keeps when it rocks from edge to edge, above 0 to 1, of the rigid law; Housner's
    /// 1 - 1.5 sin2(alpha) if not given.
    pub(super) rocking_restitution: Option<At<QuantityRaw>>,
    /// Earlier name of normal_restitution.
    pub(super) restitution: Option<At<QuantityRaw>>,
}

/// One stone.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct BlockRaw {
    /// What people call it; unique in the stack.
    #[schemars(required)]
    pub(super) name: Option<At<String>>,
    /// If not given: "points" with points, "mesh" with a file, else "box".
    pub(super) shape: Option<At<ShapeRaw>>,
    /// Along x; of a frustum at its base; of a prism twice the distance from its axis to a side.
    pub(super) width: Option<At<QuantityRaw>>,
    /// Along y; the same as width if not given.
    pub(super) depth: Option<At<QuantityRaw>>,
    /// Upwards.
    pub(super) height: Option<At<QuantityRaw>>,
    /// Of a frustum, and of a prism that tapers: width at its top.
    pub(super) top_width: Option<At<QuantityRaw>>,
    /// Of a frustum: depth at its top; in proportion to depth if not given.
    pub(super) top_depth: Option<At<QuantityRaw>>,
    /// Of a prism: number of its sides, 3 to 64.
    pub(super) sides: Option<At<i64>>,
    /// Of a drum: diameter at its base.
    pub(super) diameter: Option<At<QuantityRaw>>,
    /// Of a drum that tapers: diameter at its top.
    pub(super) top_diameter: Option<At<QuantityRaw>>,
    /// Of points: four or more, [x, y, z].
    pub(super) points: Option<At<Vec<PointRaw>>>,
    /// Of a mesh: its file, OBJ, STL or PLY, relative to the project file.
    pub(super) file: Option<At<String>>,
    /// Of a mesh: unit of length of its file; units.length if not given.
    pub(super) unit: Option<At<String>>,
    /// Of points and meshes: where their coordinates count from; "own" if not given.
    pub(super) coordinates: Option<At<CoordinatesRaw>>,
    /// Niches and chambers: they take mass away and leave the joints as they are.
    pub(super) openings: Option<Vec<At<OpeningRaw>>>,
    /// Of a box, frustum or prism: steps below it (옥개받침), set back from its base; the block and they are one stone.
    pub(super) cornice: Option<At<CorniceRaw>>,
    /// A mast on its top (찰주), which moves with it.
    pub(super) mast: Option<At<MastRaw>>,
    /// Density; that of the stack if not given.
    pub(super) density: Option<At<QuantityRaw>>,
    /// What it stands on: a block, several, or "ground"; the one before it if not given, with coordinates = "site" what it touches.
    pub(super) on: Option<At<OnRaw>>,
    /// Where the centre of its base stands in plan, [x, y]; the middle of what it stands on if not given.
    pub(super) at: Option<At<Vec<At<QuantityRaw>>>>,
    /// How far its base stands off the middle of what it stands on, [x, y].
    pub(super) offset: Option<At<Vec<At<QuantityRaw>>>>,
    /// Turn about the vertical, counterclockwise seen from above, with its unit: "3 deg".
    pub(super) rotation: Option<At<QuantityRaw>>,
    /// How its vertical edges lean.
    pub(super) tilt: Option<At<LeanRaw>>,
    /// The joints below it, where they differ from the joints of the stack.
    pub(super) joint: Option<At<BedRaw>>,
}

/// Steps below a block.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct CorniceRaw {
    /// Number of steps.
    #[schemars(required)]
    pub(super) steps: Option<At<i64>>,
    /// Height of all steps together.
    #[schemars(required)]
    pub(super) height: Option<At<QuantityRaw>>,
    /// How far the sides of each step are set back from those above it.
    #[schemars(required)]
    pub(super) setback: Option<At<QuantityRaw>>,
}

/// An upright cylinder on a block.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct MastRaw {
    /// Its height above the block.
    #[schemars(required)]
    pub(super) height: Option<At<QuantityRaw>>,
    /// Its diameter.
    #[schemars(required)]
    pub(super) diameter: Option<At<QuantityRaw>>,
    /// Its density, iron 7850 kg/m3; that of the block if not given.
    pub(super) density: Option<At<QuantityRaw>>,
}

/// A box taken out of a block.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct OpeningRaw {
    /// Along x.
    #[schemars(required)]
    pub(super) width: Option<At<QuantityRaw>>,
    /// Along y; the same as width if not given.
    pub(super) depth: Option<At<QuantityRaw>>,
    /// Upwards.
    #[schemars(required)]
    pub(super) height: Option<At<QuantityRaw>>,
    /// The centre of its floor, [x, y, z] from the centre of the block's base, along the block's own sides.
    #[schemars(required)]
    pub(super) position: Option<At<Vec<At<QuantityRaw>>>>,
}

/// A joint that differs, by the names of its two blocks.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ContactRaw {
    /// One block, or "ground".
    #[schemars(required)]
    pub(super) lower: Option<At<String>>,
    /// The other block.
    #[schemars(required)]
    pub(super) upper: Option<At<String>>,
    /// What differs in it.
    #[schemars(required)]
    pub(super) joint: Option<At<BedRaw>>,
}

/// A dowel or clamp.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct TieRaw {
    /// One block, or "ground".
    #[schemars(required)]
    pub(super) lower: Option<At<String>>,
    /// The other block.
    #[schemars(required)]
    pub(super) upper: Option<At<String>>,
    /// Where it crosses the joint: [x, y, z], z up from the ground.
    #[schemars(required)]
    pub(super) position: Option<At<Vec<At<QuantityRaw>>>>,
    /// Its axis; "z", a vertical dowel, if not given.
    pub(super) axis: Option<At<WayRaw>>,
    /// Stiffness along its axis, a force per length; 0, a dowel that can slip out, if not given.
    pub(super) axial_stiffness: Option<At<QuantityRaw>>,
    /// Stiffness across its axis, a force per length.
    #[schemars(required)]
    pub(super) shear_stiffness: Option<At<QuantityRaw>>,
    /// Tension at which it breaks, a force; 0 if not given.
    pub(super) tension_strength: Option<At<QuantityRaw>>,
    /// Shear at which it breaks, a force.
    #[schemars(required)]
    pub(super) shear_strength: Option<At<QuantityRaw>>,
}

/// The ground under a block that moves.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SupportMovementRaw {
    /// The block, which stands on the ground; the stack stands as drawn before the ground below it moves.
    #[schemars(required)]
    pub(super) on: Option<At<String>>,
    /// How far the ground moves along x; 0 if not given.
    pub(super) x: Option<At<QuantityRaw>>,
    /// Along y; 0 if not given.
    pub(super) y: Option<At<QuantityRaw>>,
    /// Upwards, a settlement is negative; 0 if not given.
    pub(super) z: Option<At<QuantityRaw>>,
}

/// Something beside a block or a chain that it meets after a gap.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SideSupportRaw {
    /// kind = "stack": the block.
    pub(crate) block: Option<At<String>>,
    /// kind = "stack": point of the block that meets it: [x, y, z], z up from the ground.
    pub(crate) position: Option<At<Vec<At<QuantityRaw>>>>,
    /// kind = "stack": direction in which the block must move to meet it. kind = "chain": "x", in the direction of motion (if not given), or
    /// "y", across: to either side.
    pub(crate) direction: Option<At<WayRaw>>,
    /// kind = "chain": height above the lowest joint.
    pub(crate) height: Option<At<QuantityRaw>>,
    /// How far it must move, a chain to either side; 0 if not given.
    pub(crate) gap: Option<At<QuantityRaw>>,
    /// Stiffness once met, a force per length.
    #[schemars(required)]
    pub(crate) stiffness: Option<At<QuantityRaw>>,
}
