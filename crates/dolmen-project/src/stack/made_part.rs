//! Generators of the blocks of a stack: an arch, a wall, a tower, a trilithon, a vault or a dome by its dimensions.

use crate::quantity::Quantity;

/// An arch of voussoirs; `None`: the default of the key.
#[derive(Clone, Debug, PartialEq)]
pub struct ArchPart {
    /// Clear span of the inner line, m.
    pub span: Quantity,
    /// Rise of the inner line, m; `None` half the span.
    pub rise: Option<Quantity>,
    /// Thickness along the joints, m.
    pub thickness: Quantity,
    /// Along y, m.
    pub depth: Quantity,
    /// Number of voussoirs.
    pub voussoirs: u32,
    /// Height of the springing, m; `None` on the ground.
    pub springing_height: Option<Quantity>,
    /// Width of the abutments, m; `None` twice the thickness.
    pub abutment: Option<Quantity>,
}

/// A wall in running bond.
#[derive(Clone, Debug, PartialEq)]
pub struct StoneWallPart {
    /// Along x, m.
    pub length: Quantity,
    /// Along y, m.
    pub thickness: Quantity,
    /// Number of courses.
    pub courses: u32,
    /// Height of a course, m.
    pub course_height: Quantity,
    /// Length of a whole stone, m.
    pub stone_length: Quantity,
    /// Leaves side by side.
    pub leaves: u32,
    /// Width of the core between two leaves, m; `None`: a tenth of the thickness.
    pub core: Option<Quantity>,
    /// Every how many courses one consists of through stones.
    pub through_every: Option<u32>,
    /// Doors and windows.
    pub openings: Vec<WallOpeningPart>,
}

/// A door or window of a wall.
#[derive(Clone, Debug, PartialEq)]
pub struct WallOpeningPart {
    /// From the left end of the wall, m.
    pub from: Quantity,
    /// Clear width, m.
    pub width: Quantity,
    /// Its lowest course, from 1.
    pub first_course: u32,
    /// Number of courses.
    pub courses: u32,
    /// Bearing of its lintel, m; `None`: a quarter of the width.
    pub bearing: Option<Quantity>,
}

/// Plan of a tower.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TowerPlanPart {
    /// A square.
    Square,
    /// A circle; hollow, with this number of stones in a ring.
    Round {
        /// Stones in a ring.
        stones: u32,
    },
}

/// A tower of courses; `None`: the default of the key.
#[derive(Clone, Debug, PartialEq)]
pub struct TowerPart {
    /// Its plan.
    pub plan: TowerPlanPart,
    /// Width or diameter of the lowest course, m.
    pub width: Quantity,
    /// The same of the top course, m; `None` as the lowest.
    pub top_width: Option<Quantity>,
    /// Number of courses.
    pub courses: u32,
    /// Height of a course, m.
    pub course_height: Quantity,
    /// Thickness of the wall, m; `None`: solid.
    pub thickness: Option<Quantity>,
}

/// Two posts and a lintel; `None`: the default of the key.
#[derive(Clone, Debug, PartialEq)]
pub struct TrilithonPart {
    /// Clear span, m.
    pub span: Quantity,
    /// Width of a post, m.
    pub post_width: Quantity,
    /// Height of the posts, m.
    pub post_height: Quantity,
    /// Along y, m; `None` as the width of a post.
    pub depth: Option<Quantity>,
    /// Height of the lintel, m.
    pub lintel_height: Quantity,
    /// Beyond the outer faces of the posts, m; `None`: 0.
    pub overhang: Option<Quantity>,
}

/// Bond of courses or rings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BondPart {
    /// Every second course is shifted by half a stone.
    Running,
    /// Joints above each other.
    Straight,
}

/// A barrel vault; `None`: the default of the key.
#[derive(Clone, Debug, PartialEq)]
pub struct VaultPart {
    /// Clear span of the inner line, m.
    pub span: Quantity,
    /// Rise of the inner line, m; `None` half the span.
    pub rise: Option<Quantity>,
    /// Thickness along the bed joints, m.
    pub thickness: Quantity,
    /// Along the axis, m.
    pub length: Quantity,
    /// Number of courses from springing to springing.
    pub voussoirs: u32,
    /// Stones of a course.
    pub stones: u32,
    /// Bond of the courses.
    pub bond: BondPart,
    /// Height of the springing, m; `None` on the ground.
    pub springing_height: Option<Quantity>,
    /// Width of the abutments, m; `None` twice the thickness.
    pub abutment: Option<Quantity>,
}

/// What of a dome is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DomePiecePart {
    /// All of it, its rings in this bond.
    Whole(BondPart),
    /// Two opposite slices.
    Lune,
}

/// A spherical dome; `None`: the default of the key.
#[derive(Clone, Debug, PartialEq)]
pub struct DomePart {
    /// Clear diameter of the inner sphere at the springing, m.
    pub span: Quantity,
    /// Rise of the inner sphere, m; `None` half the span.
    pub rise: Option<Quantity>,
    /// Thickness along the joints, m.
    pub thickness: Quantity,
    /// Number of rings.
    pub rings: u32,
    /// Stones in a ring.
    pub stones: u32,
    /// What of it is there.
    pub piece: DomePiecePart,
    /// Diameter of the opening at the top, m; `None` closed.
    pub oculus: Option<Quantity>,
    /// Height of the springing, m; `None` on the ground.
    pub drum_height: Option<Quantity>,
    /// Thickness of the drum, m; `None` twice the thickness of the dome.
    pub drum_thickness: Option<Quantity>,
}

/// The generator of a stack's blocks, if the file does not list them.
#[derive(Clone, Debug, PartialEq)]
pub enum MadePart {
    /// An arch of voussoirs.
    Arch(Box<ArchPart>),
    /// A wall in running bond.
    Wall(Box<StoneWallPart>),
    /// A tower of courses.
    Tower(Box<TowerPart>),
    /// Two posts and a lintel.
    Trilithon(Box<TrilithonPart>),
    /// A barrel vault.
    Vault(Box<VaultPart>),
    /// A spherical dome.
    Dome(Box<DomePart>),
}
