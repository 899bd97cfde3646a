//! Why a stack of blocks is invalid.

/// Why a stack, a block or a joint is invalid. Each variant carries the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StackError {
    /// There are no blocks.
    #[error("the stack has no blocks, but needs at least 1")]
    Empty,
    /// Two blocks have the same name.
    #[error("two blocks are named '{name}': give each its own name")]
    Name {
        /// The name.
        name: String,
    },
    /// A tie, a side support or a static load is far from one of its blocks.
    #[error(
        "position_m of {piece} is [{}, {}, {}], {beyond_m:.3} m off {block}: it must lie within {allowed_m} m of it; is it in mm, or from \
         another datum?",
        position_m[0], position_m[1], position_m[2]
    )]
    Far {
        /// "a tie", "a side support" or "a static load".
        piece: &'static str,
        /// Position of the piece.
        position_m: [f64; 3],
        /// Distance from the bounds of the block, m.
        beyond_m: f64,
        /// Name of the block in the stack.
        block: String,
        /// The allowed value, m.
        allowed_m: f64,
    },
    /// A dimension that must be positive and finite is not.
    #[error("{quantity} is {given}, but must be {allowed}")]
    Dimension {
        /// The dimension, with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A prism has too few or too many sides.
    #[error("a prism of {given} sides: it must have 3 to {most}; more than that is a drum")]
    Sides {
        /// Given number.
        given: u32,
        /// Largest number.
        most: u32,
    },
    /// An opening is not inside the solid.
    #[error(
        "an opening must lie inside its stone and leave some of it, but its corner {corner:?} lies {beyond_m:.4} m outside: check its size and place"
    )]
    Opening {
        /// The corner that is farthest outside, m.
        corner: [f64; 3],
        /// Distance of this corner, m.
        beyond_m: f64,
    },
    /// Two openings overlap.
    #[error(
        "two openings of a stone overlap by {depth_m:.4} m, and what they share would be taken out twice: move or join them"
    )]
    Openings {
        /// Least distance to separate the two, m.
        depth_m: f64,
    },
    /// There are too few points for a solid.
    #[error("a convex solid needs at least 4 points, but {given} points are given")]
    Points {
        /// Number of points.
        given: usize,
    },
    /// The points have no thickness.
    #[error(
        "the points are flat: within {allowed_m:.6} m they lie in a plane or on a line {size_m} m long, and a stone needs a thickness"
    )]
    Flat {
        /// Largest extent of the points, m.
        size_m: f64,
        /// Thickness below which points are flat, m.
        allowed_m: f64,
    },
    /// A triangle refers to a vertex that does not exist.
    #[error(
        "triangle {triangle} of the mesh names vertex {given}, but there are {vertices}, numbered from 0"
    )]
    MeshIndex {
        /// The triangle, from 0.
        triangle: usize,
        /// Index of the vertex.
        given: usize,
        /// Number of vertices.
        vertices: usize,
    },
    /// A triangle has two corners at one place.
    #[error(
        "triangle {triangle} of the mesh has two corners in one place, near {at_m:?} (vertices {corners:?}): take such triangles out"
    )]
    MeshTriangle {
        /// The triangle, from 0.
        triangle: usize,
        /// Indices of its vertices.
        corners: [usize; 3],
        /// Position of one of them, m.
        at_m: [f64; 3],
    },
    /// The triangles at an edge do not bound a body.
    #[error(
        "{fault}: the edge from vertex {from} {} to vertex {to} {} belongs to {triangles} triangle{} instead of 2, the first of {count} such edge{}: {remedy}",
        place(*from_m), place(*to_m), plural(*triangles), plural(*count)
    )]
    MeshEdge {
        /// The fault.
        fault: &'static str,
        /// First vertex of the edge.
        from: usize,
        /// Position of the first vertex, m.
        from_m: [f64; 3],
        /// Second vertex of the edge.
        to: usize,
        /// Position of the second vertex, m.
        to_m: [f64; 3],
        /// Number of triangles at the edge.
        triangles: usize,
        /// Number of edges with this fault.
        count: usize,
        /// Remedy.
        remedy: &'static str,
    },
    /// Two adjacent triangles of a mesh have opposite orientations.
    #[error(
        "two triangles of the mesh disagree about its outside: both run from vertex {from} {} to vertex {to} {}, the first of {count} such edge{}: make the orientation of the triangles agree",
        place(*from_m), place(*to_m), plural(*count)
    )]
    MeshTurned {
        /// First vertex of the edge.
        from: usize,
        /// Position of the first vertex, m.
        from_m: [f64; 3],
        /// Second vertex of the edge.
        to: usize,
        /// Position of the second vertex, m.
        to_m: [f64; 3],
        /// Number of edges with this fault.
        count: usize,
    },
    /// A mesh consists of several bodies.
    #[error(
        "the mesh is in {count} pieces, of {largest} triangles down to {smallest}: keep one, or give each as a stone of its own"
    )]
    MeshPieces {
        /// Number of pieces.
        count: usize,
        /// Number of triangles of the largest.
        largest: usize,
        /// Number of triangles of the smallest.
        smallest: usize,
    },
    /// A mesh is inside out.
    #[error("the mesh is inverted: its volume is {volume_m3:.6} m³; turn all its triangles round")]
    MeshInverted {
        /// Volume of the mesh, m³.
        volume_m3: f64,
    },
    /// The volume of a mesh exceeds that of its hull.
    #[error(
        "the mesh passes through itself: it holds {volume_m3:.6} m³, more than its convex hull of {hull_volume_m3:.6} m³; repair it"
    )]
    MeshOverfull {
        /// Volume of the mesh, m³.
        volume_m3: f64,
        /// Volume of the convex hull, m³.
        hull_volume_m3: f64,
    },
    /// A loose stone fills too little of its hull, which carries its contact.
    #[error(
        "the stone fills {:.1} % of its convex hull, which carries the contact of loose stones, but must fill {:.0} %: divide it into convex parts",
        100.0 * filled, 100.0 * allowed
    )]
    MeshHull {
        /// Volume of the mesh over that of its hull.
        filled: f64,
        /// Least allowed ratio.
        allowed: f64,
    },
    /// The few vertices of a face of a mesh do not lie in one plane.
    #[error(
        "a face of the mesh shows no plane: of its {corners} vertices, the one at {} lies {:.1} mm off the plane of the others, and so few do not \
         average out: scan this face more closely, or give the stone as a box, frustum or solid of points",
        place(*at_m), 1e3 * off_m
    )]
    MeshBent {
        /// The vertex that is farthest from the plane of the others, m.
        at_m: [f64; 3],
        /// Its distance from that plane, m.
        off_m: f64,
        /// Number of vertices of the face.
        corners: usize,
    },
    /// The fitted faces of a scan do not bound a body similar to the scan.
    #[error(
        "the surface of the mesh is uneven ({}), and its flat faces bound {}, not its own {volume_m3:.5} m³: the \
         stone is not convex, or too worn or curved for beds to be found in it; cut it into convex parts, scan its beds more closely, \
         or give it as a box, frustum or solid of points",
        scatter(*noise_m), bounded(*fitted_m3)
    )]
    MeshUneven {
        /// Standard deviation of its vertices, m; `None` if they are too few to show it.
        noise_m: Option<f64>,
        /// Volume of the mesh, m³.
        volume_m3: f64,
        /// Volume within the fitted planes, m³; `None` if they bound none.
        fitted_m3: Option<f64>,
    },
    /// Two fitted beds have too little stone in their overlap.
    #[error(
        "the joint of '{upper}' on '{lower}': only {:.0} % of the overlap of their beds is flat stone, but it must be {:.0} %: scan these \
         beds more closely, or give the stones as solids of points",
        100.0 * used, 100.0 * allowed
    )]
    JointUsed {
        /// The upper block.
        upper: String,
        /// Name of the body below.
        lower: String,
        /// Area of stone in both beds, over their overlap.
        used: f64,
        /// The allowed range.
        allowed: f64,
    },
    /// The face of a scan in a joint is part of a curved surface.
    #[error(
        "'{upper}' on '{lower}': '{rounded}' rests on a rounded face (radius of curvature {radius_m:.2} m), not on a bed, and rolls at any \
         acceleration; if it is bedded in mortar, give it as a box, frustum or solid of points, and if wedges hold it, give them as \
         blocks"
    )]
    JointRounded {
        /// The upper block.
        upper: String,
        /// Name of the body below.
        lower: String,
        /// The one with the rounded face.
        rounded: String,
        /// Its radius of curvature, m.
        radius_m: f64,
    },
    /// Two stones touch on several facets, none of which represents the others.
    #[error(
        "'{upper}' touches '{lower}' on several facets, of which the largest is {:.0} % of what touches, but it must be {:.0} %: give the \
         points of each bed in one plane, rounded to whole 1, 0.1 or 0.01 mm, or one of the plain shapes",
        100.0 * share, 100.0 * allowed
    )]
    JointFacets {
        /// The upper block.
        upper: String,
        /// Name of the body below.
        lower: String,
        /// Area of the largest facet over that of all facets.
        share: f64,
        /// The allowed range.
        allowed: f64,
    },
    /// In a joint of hulls, the stones themselves do not touch, or touch differently.
    #[error(
        "'{upper}' on '{lower}': where their convex hulls meet, stone meets stone on {:.1} % of the area (at least {} % must), and the outline of that spans {:.1} % of it (at least {} % must): one of them is not convex there, or an opening reaches the joint. Divide it into convex parts, each a block of its own",
        100.0 * area, 100.0 * area_allowed, 100.0 * outline, 100.0 * outline_allowed
    )]
    JointHollow {
        /// The upper block.
        upper: String,
        /// The lower block, or "the ground".
        lower: String,
        /// Area of stone on stone, over the common area of the hulls.
        area: f64,
        /// Least allowed value.
        area_allowed: f64,
        /// Area of its convex outline, over the same area.
        outline: f64,
        /// Least allowed value.
        outline_allowed: f64,
    },
    /// A cut leaves nothing.
    #[error(
        "nothing is left of the stone behind the plane through {point_m:?} with normal {normal:?}: move the plane or turn its normal round"
    )]
    CutAway {
        /// A point of the plane, m.
        point_m: [f64; 3],
        /// Normal of the plane, away from the part that remains.
        normal: [f64; 3],
    },
    /// The surface of a mesh passes through an opening, or the opening is outside the stone.
    #[error(
        "the opening is not inside the stone: {area_m2:.6} m² of the surface of its mesh lie within the opening"
    )]
    OpeningInMesh {
        /// Area of the mesh within the opening, m².
        area_m2: f64,
    },
    /// Two factors of a pagoda contradict each other.
    #[error(
        "{quantity} is {given:.4}, but with the other factors of this pagoda its limit is {allowed:.4}: change it or them"
    )]
    Pagoda {
        /// The factor.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// The limit that it exceeds.
        allowed: f64,
    },
    /// A density or gravity is out of its range.
    #[error("{part}: {quantity} is {given}, but must be a positive number")]
    NotPositive {
        /// The block, or "the stack".
        part: String,
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
    },
    /// A value of a joint is out of its range.
    #[error("{quantity} of a joint is {given}, but must be {allowed}")]
    Material {
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// Two blocks overlap.
    #[error(
        "'{first}' and '{second}' overlap by {depth_m:.4} m, but stones may touch only (within {allowed_m} m): check their sizes and offsets"
    )]
    Overlap {
        /// One block.
        first: String,
        /// The other block, or "the ground".
        second: String,
        /// Least distance to separate the two, m.
        depth_m: f64,
        /// The allowed value, m.
        allowed_m: f64,
    },
    /// A movement of the ground is given below a block that does not stand on the ground.
    #[error(
        "the ground is to move under '{block}', which does not stand on it: name one that does ({})", on_ground.join(", ")
    )]
    NotOnGround {
        /// The block.
        block: String,
        /// The blocks that stand on the ground.
        on_ground: Vec<String>,
    },
    /// Soil is defined for a single footing.
    #[error(
        "the soil is that under one footing, but {count} joints lie on the ground: put one block under them all, or leave the soil out"
    )]
    SoilUnderSeveral {
        /// Number of joints on the ground.
        count: usize,
    },
    /// A block meets the one below at an edge, because their beds are not parallel.
    #[error(
        "'{block}' does not lie on {lower}: their beds are not parallel but {angle_deg:.2}° apart, so that the far edge is {far_m:.4} m up, and the middle of a bed must lie within {allowed_m} m: check the coordinates, or give the wedge between them as a block"
    )]
    BedsNotParallel {
        /// The block.
        block: String,
        /// The block below it, or "the ground".
        lower: String,
        /// Angle between the beds, °.
        angle_deg: f64,
        /// Height of the farthest corner over the bed below, m.
        far_m: f64,
        /// The allowed value, m.
        allowed_m: f64,
    },
    /// A block has no support.
    #[error(
        "'{block}' floats: it is {}{above_ground_m:.4} m above the ground, and a bed must lie within {allowed_m} m",
        off(nearest.as_deref(), *apart_m)
    )]
    Floating {
        /// The block.
        block: String,
        /// The block that stands and could carry it with the fewest changes of its place, or the nearest of those; `None` if none stands.
        nearest: Option<String>,
        /// Distances from the top of that block along x, y and z, m, positive if this block lies on the positive side.
        apart_m: [f64; 3],
        /// Distance from the ground, m.
        above_ground_m: f64,
        /// The allowed value, m.
        allowed_m: f64,
    },
    /// A block does not exist.
    #[error("there is no block {given}, only 0 to {last}")]
    NoBlock {
        /// The index given.
        given: usize,
        /// Largest index.
        last: usize,
    },
    /// A joint does not exist.
    #[error("there is no joint {given}: the stack has {count}")]
    NoJoint {
        /// The index given.
        given: usize,
        /// Number of joints.
        count: usize,
    },
    /// A vector has no direction.
    #[error("{quantity} is {given:?}, but must be a vector of finite, not all zero numbers")]
    Direction {
        /// The vector.
        quantity: &'static str,
        /// The value given.
        given: [f64; 3],
    },
    /// A position is not finite.
    #[error("{quantity} is {given:?}, but must be three finite numbers")]
    Position {
        /// The position.
        quantity: &'static str,
        /// The value given, m.
        given: [f64; 3],
    },
}

fn scatter(noise_m: Option<f64>) -> String {
    noise_m.map_or(
        "of too few vertices to show how far they scatter".to_owned(),
        |noise| format!("its vertices scatter by {:.2} mm", 1e3 * noise),
    )
}

fn bounded(volume_m3: Option<f64>) -> String {
    volume_m3.map_or("nothing".to_owned(), |volume| format!("{volume:.5} m³"))
}

fn off(stone: Option<&str>, apart_m: [f64; 3]) -> String {
    let [x, y, z] = apart_m;
    stone.map_or(String::new(), |stone| {
        format!("{x:.4} m along x, {y:.4} m along y and {z:.4} m along z off the top of {stone}, and ")
    })
}

fn place(at: [f64; 3]) -> String {
    // to 0.1 mm
    let [x, y, z] = at.map(|m| (1e4 * m).round() / 1e4);
    format!("({x}, {y}, {z})")
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}
