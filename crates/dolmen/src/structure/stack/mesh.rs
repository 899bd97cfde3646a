//! Solids from closed triangle meshes: mass from the mesh, contact from its convex hull.

use super::scan::fitted;
use super::solid::moments_of;
use super::{Scan, Solid, StackError};
use glam::DVec3;
use std::collections::BTreeMap;

/// Least fraction of its convex hull that a mesh fills. Our choice: less is rounding; a real stone fills half.
const FILL_LEAST: f64 = 1e-6;
/// Least fraction of its hull that a loose stone fills, because the hull carries its contact. Our choice.
const HULL_FILLED_LEAST: f64 = 0.9;
/// Largest such fraction: the hull is flat within 1e-6 of its size, and a stone is at least 1/10 as thick as long. Our choice.
const FILL_MOST: f64 = 1.0 + 1e-4;

impl Solid {
    /// The solid within a closed triangle mesh, each triangle counterclockwise seen from outside.
    ///
    /// Volume, centroid and inertia are those of the mesh; contact is that of its convex hull. Compare
    /// [`Solid::hull_volume_m3`] with [`Solid::volume_m3`] to see how much of the hull is stone.
    ///
    /// # Errors
    /// [`StackError`] for a coordinate that is not finite, an index that does not exist, a triangle with a repeated corner,
    /// an edge with one triangle (a hole) or more than two, adjacent triangles with different orientation, more than one
    /// piece, an inside-out mesh, a mesh that overlaps itself so that its volume exceeds that of its hull, or a flat mesh.
    ///
    /// # Limits
    /// Corners at the same place with different indices do not connect their triangles. A mesh that intersects itself is detected
    /// only if its volume shows it.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::stack::Solid;
    /// let corners = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    /// let solid = Solid::mesh(&corners, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])?;
    /// assert!((solid.volume_m3() - 1.0 / 6.0).abs() < 1e-15);
    /// let fault = Solid::mesh(&corners, &[[0, 2, 1], [0, 1, 3], [1, 2, 3]]).unwrap_err();
    /// assert!(fault.to_string().starts_with("the mesh has a hole: the edge from vertex 0 (0, 0, 0)"));
    /// # Ok::<(), dolmen::structure::stack::StackError>(())
    /// ```
    pub fn mesh(vertices_m: &[[f64; 3]], triangles: &[[usize; 3]]) -> Result<Self, StackError> {
        Solid::of_mesh(vertices_m, triangles, true)
    }

    /// As [`Solid::mesh`], but the convex hull is the contact body even of a mesh with noise: for loose stones, which have no beds.
    ///
    /// # Errors
    /// As [`Solid::mesh`]; [`StackError::MeshHull`] for a stone that fills less than 0.9 of its hull.
    pub fn loose_mesh(vertices_m: &[[f64; 3]], triangles: &[[usize; 3]]) -> Result<Self, StackError> {
        let solid = Solid::of_mesh(vertices_m, triangles, false)?;
        let filled = solid.volume_m3() / solid.hull_volume_m3();
        if filled < HULL_FILLED_LEAST {
            return Err(StackError::MeshHull {
                filled,
                allowed: HULL_FILLED_LEAST,
            });
        }
        Ok(solid)
    }

    fn of_mesh(
        vertices_m: &[[f64; 3]],
        triangles: &[[usize; 3]],
        has_beds: bool,
    ) -> Result<Self, StackError> {
        check_corners(vertices_m, triangles)?;
        check_edges(vertices_m, triangles)?;
        check_pieces(triangles)?;
        let soup: Vec<[DVec3; 3]> = triangles
            .iter()
            .map(|t| t.map(|i| DVec3::from(vertices_m[i])))
            .collect();
        let used: Vec<[f64; 3]> = soup.iter().flatten().map(|&v| v.into()).collect();
        let hull = Solid::convex_of(&used, 0.0)?;
        let (volume, centroid, second) = moments_of(soup.iter().copied(), DVec3::from(hull.centroid_m()));
        let hull_volume_m3 = hull.volume_m3();
        if volume < FILL_LEAST * hull_volume_m3 {
            return Err(StackError::MeshInverted { volume_m3: volume });
        }
        if volume > FILL_MOST * hull_volume_m3 {
            return Err(StackError::MeshOverfull {
                volume_m3: volume,
                hull_volume_m3,
            });
        }
        let [low, high] = hull.bounds_m().map(DVec3::from);
        let flat_m = 2.0 * super::hull::FLAT * (high - low).max_element();
        let fit = match has_beds {
            true => fitted(vertices_m, triangles, &hull, volume, flat_m)?,
            false => None,
        };
        let (contact, scan) = match fit {
            None => (hull, None),
            Some(fit) => {
                let scan = Scan {
                    noise_m: fit.noise_m,
                    triangles: fit.triangles,
                    radii_m: fit.radii_m,
                };
                (fit.solid, Some(Box::new(scan)))
            }
        };
        let mut solid = contact.with_moments(volume, centroid, second);
        (solid.mesh, solid.scan) = (soup, scan);
        Ok(solid)
    }

    /// Volume of the convex hull that carries contact, m³. It equals the volume of a box or prism, is 0.64 % less for a drum, and
    /// more for a mesh or a solid with openings.
    pub fn hull_volume_m3(&self) -> f64 {
        let near = self.vertices_m().first().copied().unwrap_or_default();
        moments_of(self.hull_triangles().into_iter(), DVec3::from(near)).0
    }
}

pub(super) fn check_corners(vertices_m: &[[f64; 3]], triangles: &[[usize; 3]]) -> Result<(), StackError> {
    for &given in vertices_m {
        if !given.iter().all(|value| value.is_finite()) {
            let quantity = "a vertex of a mesh";
            return Err(StackError::Position { quantity, given });
        }
    }
    for (triangle, corners) in triangles.iter().enumerate() {
        if let Some(&given) = corners.iter().find(|&&corner| corner >= vertices_m.len()) {
            return Err(StackError::MeshIndex {
                triangle,
                given,
                vertices: vertices_m.len(),
            });
        }
        let [a, b, c] = corners.map(|corner| vertices_m[corner]);
        if a == b || b == c || c == a {
            return Err(StackError::MeshTriangle {
                triangle,
                corners: *corners,
                at_m: a,
            });
        }
    }
    Ok(())
}

/// Checks that each edge has two triangles, one on each side.
pub(super) fn check_edges(vertices_m: &[[f64; 3]], triangles: &[[usize; 3]]) -> Result<(), StackError> {
    let mut sides: BTreeMap<[usize; 2], [usize; 2]> = BTreeMap::new(); // triangles that run up it and down it
    for triangle in triangles {
        for edge in 0..3 {
            let (from, to) = (triangle[edge], triangle[(edge + 1) % 3]);
            sides.entry([from.min(to), from.max(to)]).or_default()[usize::from(from > to)] += 1;
        }
    }
    let wrong = |is: &dyn Fn([usize; 2]) -> bool| {
        let mut all = sides.iter().filter(|(_, sides)| is(**sides));
        let (&[from, to], &[up, down]) = all.next()?;
        Some((from, to, up + down, 1 + all.count()))
    };
    for (fault, remedy, found) in [
        (
            "the mesh has a hole",
            "fill it, or join vertices that lie in one place",
            wrong(&|[up, down]| up + down == 1),
        ),
        (
            "sheets of the mesh meet in an edge",
            "take out what lies inside or is doubled",
            wrong(&|[up, down]| up + down > 2),
        ),
    ] {
        if let Some((from, to, triangles, count)) = found {
            return Err(StackError::MeshEdge {
                fault,
                from,
                from_m: vertices_m[from],
                to,
                to_m: vertices_m[to],
                triangles,
                count,
                remedy,
            });
        }
    }
    match wrong(&|[up, down]| up != down) {
        Some((from, to, _, count)) => Err(StackError::MeshTurned {
            from,
            from_m: vertices_m[from],
            to,
            to_m: vertices_m[to],
            count,
        }),
        None => Ok(()),
    }
}

/// Checks that all triangles are connected.
fn check_pieces(triangles: &[[usize; 3]]) -> Result<(), StackError> {
    let owners = super::hull_faces::edge_owners(triangles);
    let mut piece = vec![usize::MAX; triangles.len()];
    let mut sizes: Vec<usize> = Vec::new();
    for seed in 0..triangles.len() {
        if piece[seed] != usize::MAX {
            continue;
        }
        let number = sizes.len();
        piece[seed] = number;
        let (mut reached, mut size) = (vec![seed], 0);
        while let Some(triangle) = reached.pop() {
            size += 1;
            for edge in 0..3 {
                let (from, to) = (triangles[triangle][edge], triangles[triangle][(edge + 1) % 3]);
                if let Some(&beyond) = owners.get(&(to, from))
                    && piece[beyond] == usize::MAX
                {
                    piece[beyond] = number;
                    reached.push(beyond);
                }
            }
        }
        sizes.push(size);
    }
    if sizes.len() > 1 {
        return Err(StackError::MeshPieces {
            count: sizes.len(),
            largest: sizes.iter().copied().max().unwrap_or_default(),
            smallest: sizes.iter().copied().min().unwrap_or_default(),
        });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::Placement;
    use super::*;

    const CUBE: [[f64; 3]; 8] = [
        [0., 0., 0.],
        [1., 0., 0.],
        [1., 1., 0.],
        [0., 1., 0.],
        [0., 0., 1.],
        [1., 0., 1.],
        [1., 1., 1.],
        [0., 1., 1.],
    ];
    const SIDES: [[usize; 3]; 12] = [
        [0, 2, 1],
        [0, 3, 2],
        [4, 5, 6],
        [4, 6, 7],
        [0, 1, 5],
        [0, 5, 4],
        [1, 2, 6],
        [1, 6, 5],
        [2, 3, 7],
        [2, 7, 6],
        [3, 0, 4],
        [3, 4, 7],
    ];

    fn fault(triangles: &[[usize; 3]]) -> String {
        Solid::mesh(&CUBE, triangles).unwrap_err().to_string()
    }

    /// A regular tetrahedron of edge s: V = s³/6√2, moment of inertia m s²/20 about every axis through its centroid.
    #[test]
    fn exact_inertia_of_a_regular_tetrahedron() {
        let corners = [[1., 1., 1.], [1., -1., -1.], [-1., 1., -1.], [-1., -1., 1.]];
        let solid = Solid::mesh(&corners, &[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]).unwrap();
        let volume = 8.0_f64.powf(1.5) / (6.0 * 2.0_f64.sqrt());
        assert!((solid.volume_m3() - volume).abs() < 1e-14);
        for (i, row) in solid.inertia_m5().iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                let exact = if i == j { volume * 8.0 / 20.0 } else { 0.0 };
                assert!((value - exact).abs() < 1e-14);
            }
        }
    }

    /// An L of three unit cubes: mass of the mesh, contact of the hull, and everything rotates with the solid.
    #[test]
    fn exact_mass_of_an_l_and_contact_of_its_hull() {
        let outline = [[0., 0.], [2., 0.], [2., 1.], [1., 1.], [1., 2.], [0., 2.]];
        let ring = |z: f64| outline.iter().map(move |p| [p[0], p[1], z]);
        let corners: Vec<[f64; 3]> = ring(0.0).chain(ring(1.0)).collect();
        let flat = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]];
        let mut triangles: Vec<[usize; 3]> = flat.iter().map(|t| [t[0], t[2], t[1]]).collect();
        triangles.extend(flat.iter().map(|t| t.map(|i| i + 6)));
        for i in 0..6 {
            let next = (i + 1) % 6;
            triangles.extend([[i, next, next + 6], [i, next + 6, i + 6]]);
        }
        let solid = Solid::mesh(&corners, &triangles).unwrap();
        assert!((solid.volume_m3() - 3.0).abs() < 1e-14 && (solid.hull_volume_m3() - 3.5).abs() < 1e-14);
        assert!((solid.centroid_m()[0] - 2.5 / 3.0).abs() < 1e-15);
        assert_eq!(solid.faces().len(), 7);
        let place = Placement {
            yaw_rad: 0.4,
            tilt: [0.1, -0.2],
            position_m: [3.0, 2.0, 1.0],
        };
        let moved: Vec<[f64; 3]> = {
            let (rotation, shift) = (place.rotation(), DVec3::from(place.position_m));
            corners
                .iter()
                .map(|&v| (rotation * DVec3::from(v) + shift).into())
                .collect()
        };
        let (a, b) = (solid.placed(&place), Solid::mesh(&moved, &triangles).unwrap());
        for (a, b) in a
            .inertia_m5()
            .iter()
            .flatten()
            .zip(b.inertia_m5().iter().flatten())
        {
            assert!((a - b).abs() < 1e-13);
        }
    }

    #[test]
    fn refuses_a_cube_with_a_hole() {
        assert!((Solid::mesh(&CUBE, &SIDES).unwrap().volume_m3() - 1.0).abs() < 1e-15);
        assert_eq!(
            fault(&SIDES[..11]),
            "the mesh has a hole: the edge from vertex 3 (0, 1, 0) to vertex 4 (0, 0, 1) belongs to 1 triangle instead of \
             2, the first of 3 such edges: fill it, or join vertices that lie in one place"
        );
    }

    #[test]
    fn refuses_what_is_no_surface() {
        let mut turned = SIDES;
        turned[5].swap(0, 1);
        assert!(
            fault(&turned).contains("disagree about its outside"),
            "{}",
            fault(&turned)
        );
        let mut doubled = SIDES.to_vec();
        doubled.extend([[0, 2, 6], [0, 6, 2]]);
        assert!(
            fault(&doubled).contains("sheets of the mesh meet"),
            "{}",
            fault(&doubled)
        );
        let inverted = SIDES.map(|[a, b, c]| [a, c, b]);
        assert!(
            fault(&inverted).starts_with("the mesh is inverted: its volume is -1"),
            "{}",
            fault(&inverted)
        );
        let mut out_of_range = SIDES;
        out_of_range[3][1] = 8;
        assert_eq!(
            fault(&out_of_range),
            "triangle 3 of the mesh names vertex 8, but there are 8, numbered from 0"
        );
        let mut degenerate = SIDES;
        degenerate[0] = [0, 2, 2];
        assert!(
            fault(&degenerate).starts_with("triangle 0 of the mesh"),
            "{}",
            fault(&degenerate)
        );
        assert!(fault(&[]).contains("0 points"), "{}", fault(&[]));
        let mut far = CUBE;
        far[2][1] = f64::INFINITY;
        assert!(matches!(
            Solid::mesh(&far, &SIDES),
            Err(StackError::Position { .. })
        ));
    }

    #[test]
    fn refuses_two_pieces() {
        let corners: Vec<[f64; 3]> = CUBE
            .iter()
            .copied()
            .chain(CUBE.iter().map(|v| [v[0] + 5.0, v[1], v[2]]))
            .collect();
        let triangles: Vec<[usize; 3]> = SIDES
            .iter()
            .copied()
            .chain(SIDES.iter().map(|t| t.map(|i| i + 8)))
            .collect();
        let fault = Solid::mesh(&corners, &triangles).unwrap_err();
        assert!(
            fault.to_string().starts_with("the mesh is in 2 pieces"),
            "{fault}"
        );
    }
}
