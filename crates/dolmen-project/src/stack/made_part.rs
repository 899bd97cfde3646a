//! Generators of the blocks of a stack: an arch, a wall, a tower or a trilithon by its dimensions.

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
}
