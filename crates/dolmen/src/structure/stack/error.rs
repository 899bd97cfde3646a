//! Why a stack of blocks cannot exist.

/// Why a stack, a block or a joint cannot be. Each variant carries the value that was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StackError {
    /// No blocks.
    #[error("the stack has no blocks, but needs at least 1")]
    Empty,
    /// Two blocks of one name.
    #[error("two blocks are named '{name}': give each its own name")]
    Name {
        /// The name.
        name: String,
    },
    /// A tie, a side support or a static load that is nowhere near its block.
    #[error(
        "position_m of {piece} is [{}, {}, {}], {beyond_m:.3} m off {}: it must lie within {allowed_m} m of it; is it in mm, or from \
         another datum?",
        position_m[0], position_m[1], position_m[2], blocks.join(" and ")
    )]
    Far {
        /// "a tie", "a side support" or "a static load".
        piece: &'static str,
        /// Its place.
        position_m: [f64; 3],
        /// Distance from the bounds of its stone, m.
        beyond_m: f64,
        /// Names of the blocks in the stack.
        blocks: Vec<String>,
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
    /// A prism with too few or too many sides.
    #[error("a prism of {given} sides: it must have 3 to {most}; more than that is a drum")]
    Sides {
        /// The number given.
        given: u32,
        /// The most there may be.
        most: u32,
    },
    /// An opening that is not inside.
    #[error(
        "an opening must lie inside its stone and leave some of it, but its corner {corner:?} lies {beyond_m:.4} m outside: check its size and place"
    )]
    Opening {
        /// The corner that lies farthest out, m.
        corner: [f64; 3],
        /// The distance, m.
        beyond_m: f64,
    },
    /// Two openings in the same place.
    #[error(
        "two openings of a stone overlap by {depth_m:.4} m, and what they share would be taken out twice: move or join them"
    )]
    Openings {
        /// Least distance by which one must move to be free of the other, m.
        depth_m: f64,
    },
    /// Too few points for a solid.
    #[error("a convex solid needs at least 4 points, but {given} points are given")]
    Points {
        /// Their number.
        given: usize,
    },
    /// Points without a thickness.
    #[error(
        "the points are flat: within {allowed_m:.6} m they lie in a plane or on a line {size_m} m long, and a stone needs a thickness"
    )]
    Flat {
        /// Largest extent, m.
        size_m: f64,
        /// Thickness below which they are flat, m.
        allowed_m: f64,
    },
    /// A triangle names a vertex that is not there.
    #[error(
        "triangle {triangle} of the mesh names vertex {given}, but there are {vertices}, numbered from 0"
    )]
    MeshIndex {
        /// The triangle, from 0.
        triangle: usize,
        /// The vertex it names.
        given: usize,
        /// Their number.
        vertices: usize,
    },
    /// A triangle with two corners in one place.
    #[error(
        "triangle {triangle} of the mesh has two corners in one place, near {at_m:?} (vertices {corners:?}): take such triangles out"
    )]
    MeshTriangle {
        /// The triangle, from 0.
        triangle: usize,
        /// Its vertices.
        corners: [usize; 3],
        /// One of them, m.
        at_m: [f64; 3],
    },
    /// An edge whose triangles do not bound a body.
    #[error(
        "{fault}: the edge from vertex {from} {} to vertex {to} {} belongs to {triangles} triangle{} instead of 2, the first of {count} such edge{}: {remedy}",
        place(*from_m), place(*to_m), plural(*triangles), plural(*count)
    )]
    MeshEdge {
        /// The fault.
        fault: &'static str,
        /// First vertex of the edge.
        from: usize,
        /// Its place, m.
        from_m: [f64; 3],
        /// Second vertex of the edge.
        to: usize,
        /// Its place, m.
        to_m: [f64; 3],
        /// Number of triangles at the edge.
        triangles: usize,
        /// Number of edges with this fault.
        count: usize,
        /// What to do.
        remedy: &'static str,
    },
    /// Two neighbours of a mesh that disagree about the outside.
    #[error(
        "two triangles of the mesh disagree about its outside: both run from vertex {from} {} to vertex {to} {}, the first of {count} such edge{}: make the orientation of the triangles agree",
        place(*from_m), place(*to_m), plural(*count)
    )]
    MeshTurned {
        /// First vertex of the edge.
        from: usize,
        /// Its place, m.
        from_m: [f64; 3],
        /// Second vertex of the edge.
        to: usize,
        /// Its place, m.
        to_m: [f64; 3],
        /// Number of edges with this fault.
        count: usize,
    },
    /// A mesh of several bodies.
    #[error(
        "the mesh is in {count} pieces, of {largest} triangles down to {smallest}: keep one, or give each as a stone of its own"
    )]
    MeshPieces {
        /// Number of pieces.
        count: usize,
        /// Triangles of the largest.
        largest: usize,
        /// Triangles of the smallest.
        smallest: usize,
    },
    /// A mesh turned inside out.
    #[error("the mesh is inverted: its volume is {volume_m3:.6} m³; turn all its triangles round")]
    MeshInverted {
        /// Its volume, m³.
        volume_m3: f64,
    },
    /// A mesh that holds more than its hull.
    #[error(
        "the mesh passes through itself: it holds {volume_m3:.6} m³, more than its convex hull of {hull_volume_m3:.6} m³; repair it"
    )]
    MeshOverfull {
        /// Its volume, m³.
        volume_m3: f64,
        /// Volume of the convex hull, m³.
        hull_volume_m3: f64,
    },
    /// A loose stone that is too hollow for its hull to carry its contact.
    #[error(
        "the stone fills {:.1} % of its convex hull, which carries the contact of loose stones, but must fill {:.0} %: divide it into convex parts",
        100.0 * filled, 100.0 * allowed
    )]
    MeshHull {
        /// Volume of the mesh over that of its hull.
        filled: f64,
        /// The least.
        allowed: f64,
    },
    /// A scan whose flat faces bound no body like it.
    #[error(
        "the surface of the mesh is uneven (its vertices scatter by {:.2} mm), and its flat faces bound {}, not its own {volume_m3:.5} m³: the \
         stone is not convex, or too worn or curved for beds to be found in it; cut it into convex parts, scan its beds more closely, \
         or give it as a box, frustum or solid of points",
        1e3 * noise_m, bounded(*fitted_m3)
    )]
    MeshUneven {
        /// Standard deviation of its vertices off their neighbours, m.
        noise_m: f64,
        /// Volume of the mesh, m³.
        volume_m3: f64,
        /// Volume that the fitted planes bound, m³; `None` if none.
        fitted_m3: Option<f64>,
    },
    /// Two fitted beds with too little stone in their overlap.
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
        /// Area of both beds that is there, over their overlap.
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
        /// Area of the largest facet over that of all.
        share: f64,
        /// The allowed range.
        allowed: f64,
    },
    /// A joint of hulls where the stones themselves do not meet, or not as the hulls do.
    #[error(
        "'{upper}' on '{lower}': where their convex hulls meet, stone meets stone on {:.1} % of the area (at least {} % must), and the outline of that spans {:.1} % of it (at least {} % must): one of them is not convex there, or an opening reaches the joint. Divide it into convex parts, each a block of its own",
        100.0 * area, 100.0 * area_allowed, 100.0 * outline, 100.0 * outline_allowed
    )]
    JointHollow {
        /// The upper block.
        upper: String,
        /// The lower one, or "the ground".
        lower: String,
        /// Stone on stone, in parts of the area that the hulls have in common.
        area: f64,
        /// The least allowed.
        area_allowed: f64,
        /// Its convex outline, in the same parts.
        outline: f64,
        /// The least allowed.
        outline_allowed: f64,
    },
    /// A cut that leaves nothing.
    #[error(
        "nothing is left of the stone behind the plane through {point_m:?} with normal {normal:?}: move the plane or turn its normal round"
    )]
    CutAway {
        /// A point of the plane, m.
        point_m: [f64; 3],
        /// Normal of the plane, away from the part that remains.
        normal: [f64; 3],
    },
    /// An opening that the surface of a mesh passes through, or that lies in the open.
    #[error(
        "the opening is not inside the stone: {area_m2:.6} m² of the surface of its mesh lie within the opening"
    )]
    OpeningInMesh {
        /// Area of the mesh within it, m².
        area_m2: f64,
    },
    /// Factors of a pagoda that cannot be together.
    #[error(
        "{quantity} is {given:.4}, but with the other factors of this pagoda its limit is {allowed:.4}: change it or them"
    )]
    Pagoda {
        /// The factor.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// The bound that it crosses.
        allowed: f64,
    },
    /// A density or gravity out of its range.
    #[error("{part}: {quantity} is {given}, but must be a positive number")]
    NotPositive {
        /// The block, or "the stack".
        part: String,
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
    },
    /// A value of a joint out of its range.
    #[error("{quantity} of a joint is {given}, but must be {allowed}")]
    Material {
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// Two blocks share space.
    #[error(
        "'{first}' and '{second}' overlap by {depth_m:.4} m, but stones may touch only (within {allowed_m} m): check their sizes and offsets"
    )]
    Overlap {
        /// One block.
        first: String,
        /// The other, or "the ground".
        second: String,
        /// Least distance by which one must move to be free of the other, m.
        depth_m: f64,
        /// The allowed value, m.
        allowed_m: f64,
    },
    /// The ground is to move under a block that does not stand on it.
    #[error(
        "the ground is to move under '{block}', which does not stand on it: name one that does ({})", on_ground.join(", ")
    )]
    NotOnGround {
        /// The block.
        block: String,
        /// The blocks that stand on the ground.
        on_ground: Vec<String>,
    },
    /// The soil is that under one footing.
    #[error(
        "the soil is that under one footing, but {count} joints lie on the ground: put one block under them all, or leave the soil out"
    )]
    SoilUnderSeveral {
        /// Joints on the ground.
        count: usize,
    },
    /// A block rests on nothing.
    #[error(
        "'{block}' floats: the nearest bed below it, of {nearest}, is {gap_m:.4} m away, and a bed must lie within {allowed_m} m"
    )]
    Floating {
        /// The block.
        block: String,
        /// The nearest block below it, or "the ground".
        nearest: String,
        /// Distance to it, m.
        gap_m: f64,
        /// The allowed value, m.
        allowed_m: f64,
    },
    /// There is no such block.
    #[error("there is no block {given}, only 0 to {last}")]
    NoBlock {
        /// The index given.
        given: usize,
        /// The last one there is.
        last: usize,
    },
    /// There is no such joint.
    #[error("there is no joint {given}: the stack has {count}")]
    NoJoint {
        /// The index given.
        given: usize,
        /// Their number.
        count: usize,
    },
    /// A vector that must have a direction has none.
    #[error("{quantity} is {given:?}, but must be a vector of finite, not all zero numbers")]
    Direction {
        /// The vector.
        quantity: &'static str,
        /// The value given.
        given: [f64; 3],
    },
    /// A place that is not finite.
    #[error("{quantity} is {given:?}, but must be three finite numbers")]
    Position {
        /// The place.
        quantity: &'static str,
        /// The value given, m.
        given: [f64; 3],
    },
}

fn bounded(volume_m3: Option<f64>) -> String {
    volume_m3.map_or("nothing".to_owned(), |volume| format!("{volume:.5} m³"))
}

fn place(at: [f64; 3]) -> String {
    let [x, y, z] = at;
    format!("({x}, {y}, {z})")
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}
