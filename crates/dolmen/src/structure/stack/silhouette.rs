//! Outline of each block of a stack as seen by the wind, without the parts hidden by other blocks.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | s | `across` | coordinate in plan across the wind | m |
//! | t | `along` | coordinate in plan along the wind | m |

use super::Stack;
use glam::DVec3;

/// Number of cells along the longer side of the grid on which blocks hide each other. Our choice: the error of the hidden area is about
/// half a per cent.
const CELLS: f64 = 500.0;
/// Position of the ray in its cell: not the middle, where edges with round coordinates are.
const IN_CELL: [f64; 2] = [0.503_17, 0.497_31];

/// Visible outline of one block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Silhouette {
    /// Area of the block's own outline, m².
    pub own_area_m2: f64,
    /// Visible area, m².
    pub area_m2: f64,
    /// Centroid of the visible area: across the wind, and height, m.
    pub centroid_m: [f64; 2],
    /// The visible outline by height, lowest strip first.
    pub strips: Vec<SilhouetteStrip>,
}

/// Visible part of a block between two heights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SilhouetteStrip {
    /// Lower height, m.
    pub bottom_m: f64,
    /// Upper height, m.
    pub top_m: f64,
    /// Visible breadth, m; all strips together have the visible area.
    pub breadth_m: f64,
    /// Centre of the strip across the wind, m.
    pub middle_m: f64,
}

/// Unit vector across a wind in plan, to its left.
pub fn across([x, y]: [f64; 2]) -> [f64; 2] {
    [-y, x]
}

/// Outlines of the blocks of a stack as seen by a wind that blows towards `direction`, a unit vector in plan.
///
/// # Limits
/// The outline of a convex block that nothing hides is exact. Hidden parts, and outlines of other blocks, are counted on a grid of 500
/// cells along the longer side, which is accurate to about half a per cent. A part behind another block is hidden at any distance.
pub fn silhouettes(stack: &Stack, direction: [f64; 2]) -> Vec<Silhouette> {
    let all: Vec<Facing> = stack
        .blocks()
        .iter()
        .map(|block| Facing::of(block.solid.vertices_m(), block.solid.faces(), direction))
        .collect();
    let mut grid = Grid::round(&all);
    for (index, facing) in all.iter().enumerate() {
        grid.draw(index, facing);
    }
    grid.seen(&all)
}

/// A triangle that faces the wind; its corners across, upwards and along the wind.
type Triangle = [DVec3; 3];

/// The triangles of a block that face the wind.
struct Facing {
    triangles: Vec<Triangle>,
    area: f64,
    /// Area times centroid, across and upwards.
    first: [f64; 2],
}

impl Facing {
    fn of(vertices: &[[f64; 3]], faces: &[Vec<usize>], direction: [f64; 2]) -> Self {
        let [ax, ay] = across(direction);
        let seen = |vertex: usize| {
            let [x, y, z] = vertices[vertex];
            DVec3::new(ax * x + ay * y, z, direction[0] * x + direction[1] * y)
        };
        let mut facing = Facing {
            triangles: Vec::new(),
            area: 0.0,
            first: [0.0; 2],
        };
        for face in faces {
            for k in 1..face.len().saturating_sub(1) {
                let corners = [face[0], face[k], face[k + 1]].map(seen);
                let [a, b, c] = corners;
                // outward faces are counterclockwise; (across, up, along) is right-handed for a viewer who looks along the wind
                let area = 0.5 * (b - a).cross(c - a).z;
                let shadow = area.abs();
                if area * Facing::WINDWARD > 1e-12 {
                    let middle = (a + b + c) / 3.0;
                    facing.area += shadow;
                    facing.first[0] += shadow * middle.x;
                    facing.first[1] += shadow * middle.y;
                    facing.triangles.push(corners);
                }
            }
        }
        facing
    }

    /// Sign of the area of a triangle that faces the wind.
    const WINDWARD: f64 = -1.0;
}

#[derive(Clone, Copy, Default)]
struct Cells {
    count: f64,
    across: f64,
    up: f64,
}

impl Cells {
    fn add(&mut self, [across, up]: [f64; 2]) {
        self.count += 1.0;
        self.across += across;
        self.up += up;
    }

    fn middle(&self) -> [f64; 2] {
        [self.across / self.count, self.up / self.count]
    }
}

/// Grid of the cells on which blocks hide each other.
struct Grid {
    low: [f64; 2],
    cell: f64,
    size: [usize; 2],
    /// The block that is visible in a cell, and its distance along the wind.
    seen: Vec<Option<(usize, f64)>>,
    /// The block that was drawn last into a cell.
    drawn: Vec<usize>,
    /// Number of cells in each block's own outline, and how often its faces cover them.
    own: Vec<(Cells, f64)>,
}

impl Grid {
    fn round(all: &[Facing]) -> Self {
        let corners = all.iter().flat_map(|facing| facing.triangles.iter().flatten());
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for corner in corners {
            low = low.min(*corner);
            high = high.max(*corner);
        }
        let cell = (high.x - low.x).max(high.y - low.y) / CELLS;
        let size = [high.x - low.x, high.y - low.y].map(|length| (length / cell).ceil() as usize + 1);
        let cells = size[0] * size[1];
        Grid {
            low: [low.x, low.y],
            cell,
            size,
            seen: vec![None; cells],
            drawn: vec![usize::MAX; cells],
            own: vec![(Cells::default(), 0.0); all.len()],
        }
    }

    fn place(&self, column: usize, row: usize) -> [f64; 2] {
        [
            self.low[0] + (column as f64 + IN_CELL[0]) * self.cell,
            self.low[1] + (row as f64 + IN_CELL[1]) * self.cell,
        ]
    }

    /// The first index whose ray is at or above a coordinate.
    fn index(&self, axis: usize, at: f64) -> usize {
        let index = ((at - self.low[axis]) / self.cell - IN_CELL[axis]).ceil();
        (index.max(0.0) as usize).min(self.size[axis])
    }

    fn draw(&mut self, block: usize, facing: &Facing) {
        for [a, b, c] in &facing.triangles {
            let least = a.y.min(b.y).min(c.y);
            let most = a.y.max(b.y).max(c.y);
            for row in self.index(1, least)..self.index(1, most) {
                let up = self.place(0, row)[1];
                let Some([from, to]) = crossed([*a, *b, *c], up) else {
                    continue;
                };
                for column in self.index(0, from.x)..self.index(0, to.x) {
                    let at = self.place(column, row);
                    let share = (at[0] - from.x) / (to.x - from.x);
                    self.cover(block, [column, row], from.z + share * (to.z - from.z));
                }
            }
        }
    }

    fn cover(&mut self, block: usize, [column, row]: [usize; 2], along: f64) {
        let cell = row * self.size[0] + column;
        let (own, covered) = &mut self.own[block];
        *covered += 1.0;
        if self.drawn[cell] != block {
            self.drawn[cell] = block;
            let at = [
                self.low[0] + (column as f64 + IN_CELL[0]) * self.cell,
                self.low[1] + (row as f64 + IN_CELL[1]) * self.cell,
            ];
            own.add(at);
        }
        if self.seen[cell].is_none_or(|(_, before)| along < before) {
            self.seen[cell] = Some((block, along));
        }
    }

    fn seen(&self, all: &[Facing]) -> Vec<Silhouette> {
        let mut rows: Vec<Vec<Cells>> = vec![vec![Cells::default(); self.size[1]]; all.len()];
        for (cell, seen) in self.seen.iter().enumerate() {
            if let Some((block, _)) = seen {
                let (column, row) = (cell % self.size[0], cell / self.size[0]);
                rows[*block][row].add(self.place(column, row));
            }
        }
        let each = all.iter().zip(&self.own).zip(&rows);
        each.map(|((facing, (own, covered)), rows)| self.silhouette(facing, own, *covered, rows))
            .collect()
    }

    fn silhouette(&self, facing: &Facing, own: &Cells, covered: f64, rows: &[Cells]) -> Silhouette {
        if facing.area <= 0.0 {
            return Silhouette::default();
        }
        let exact = facing.first.map(|first| first / facing.area);
        if own.count == 0.0 {
            return thin(facing, exact);
        }
        // 1 for a convex solid: no face hides another of the same block
        let once = own.count / covered;
        let own_area_m2 = facing.area * once;
        let mut all = Cells::default();
        for row in rows {
            (all.count, all.across, all.up) =
                (all.count + row.count, all.across + row.across, all.up + row.up);
        }
        if all.count == 0.0 {
            return Silhouette {
                own_area_m2,
                centroid_m: exact,
                ..Silhouette::default()
            };
        }
        let area_m2 = own_area_m2 * all.count / own.count;
        // the grid changes the whole block by the same ratio
        let rounding = match once == 1.0 {
            true => [0, 1].map(|axis| exact[axis] - own.middle()[axis]),
            false => [0.0; 2],
        };
        let centroid_m = [0, 1].map(|axis| all.middle()[axis] + rounding[axis]);
        let per_cell = area_m2 / all.count / self.cell;
        let strips = rows.iter().enumerate().filter(|(_, row)| row.count > 0.0);
        let strips = strips.map(|(index, row)| {
            let bottom_m =
                self.low[1] + index as f64 * self.cell + rounding[1] + (IN_CELL[1] - 0.5) * self.cell;
            SilhouetteStrip {
                bottom_m,
                top_m: bottom_m + self.cell,
                breadth_m: per_cell * row.count,
                middle_m: row.middle()[0] + rounding[0],
            }
        });
        Silhouette {
            own_area_m2,
            area_m2,
            centroid_m,
            strips: strips.collect(),
        }
    }
}

/// A block too thin for the grid, treated as if nothing hid it.
fn thin(facing: &Facing, exact: [f64; 2]) -> Silhouette {
    let heights = facing.triangles.iter().flatten().map(|corner| corner.y);
    let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
        (low.min(at), high.max(at))
    });
    Silhouette {
        own_area_m2: facing.area,
        area_m2: facing.area,
        centroid_m: exact,
        strips: vec![SilhouetteStrip {
            bottom_m: low,
            top_m: high,
            breadth_m: facing.area / (high - low),
            middle_m: exact[0],
        }],
    }
}

/// Intersection of a triangle with a height: left and right end, with their distances along the wind.
fn crossed(corners: Triangle, up: f64) -> Option<[DVec3; 2]> {
    let mut ends: Vec<DVec3> = Vec::with_capacity(2);
    for k in 0..3 {
        let (a, b) = (corners[k], corners[(k + 1) % 3]);
        if (a.y <= up) != (b.y <= up) {
            ends.push(a + (b - a) * ((up - a.y) / (b.y - a.y)));
        }
    }
    match ends[..] {
        [a, b] if a.x < b.x => Some([a, b]),
        [a, b] if b.x < a.x => Some([b, a]),
        _ => None,
    }
}
