//! Rubble made by noise on icospheres: twelve stones in three layers, each lowered until it touches a stone below.

use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack, StackError};
use std::collections::BTreeMap;

/// A small generator of random numbers (xorshift), so that a seed repeats.
pub(crate) struct Draws(u64);

impl Draws {
    fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let (a, b) = (self.uniform().max(1e-300), self.uniform());
        (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }
}

/// A closed mesh.
#[derive(Clone)]
pub(crate) struct Mesh {
    pub(crate) vertices: Vec<[f64; 3]>,
    pub(crate) triangles: Vec<[usize; 3]>,
}

/// A unit sphere: an icosahedron whose triangles are divided in four `times` over.
fn icosphere(times: usize) -> Mesh {
    let g = f64::midpoint(1.0, 5.0_f64.sqrt());
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    for a in [-1.0, 1.0] {
        for b in [-g, g] {
            vertices.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
        }
    }
    let near = |a: usize, b: usize| {
        let way: f64 = (0..3).map(|k| (vertices[a][k] - vertices[b][k]).powi(2)).sum();
        a != b && way < 4.1
    };
    let mut triangles: Vec<[usize; 3]> = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                if near(a, b) && near(b, c) && near(a, c) {
                    let [p, q, r] = [a, b, c].map(|i| vertices[i]);
                    let out = determinant(p, q, r) > 0.0;
                    triangles.push(if out { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    for _ in 0..times {
        let mut middles: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        let mut finer = Vec::new();
        for [a, b, c] in triangles {
            let mut middle = |i: usize, j: usize| {
                *middles.entry([i.min(j), i.max(j)]).or_insert_with(|| {
                    vertices.push([0, 1, 2].map(|k| f64::midpoint(vertices[i][k], vertices[j][k])));
                    vertices.len() - 1
                })
            };
            let [x, y, z] = [middle(a, b), middle(b, c), middle(c, a)];
            finer.extend([[a, x, z], [b, y, x], [c, z, y], [x, y, z]]);
        }
        triangles = finer;
    }
    for vertex in &mut vertices {
        let length = vertex.iter().map(|x| x * x).sum::<f64>().sqrt();
        *vertex = vertex.map(|x| x / length);
    }
    Mesh { vertices, triangles }
}

fn determinant(p: [f64; 3], q: [f64; 3], r: [f64; 3]) -> f64 {
    p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
        + p[2] * (q[0] * r[1] - q[1] * r[0])
}

/// A flattened stone with twelve wide bumps of `bumps` times its radius, and vertices with a scatter of `noise_m`. Its 20 triangles are divided
/// in four `times` over.
fn stone(draws: &mut Draws, bumps: f64, noise_m: f64, times: usize) -> Mesh {
    let axes = [
        draws.between(0.25, 0.35),
        draws.between(0.2, 0.3),
        draws.between(0.12, 0.18),
    ];
    let each: Vec<([f64; 3], f64)> = (0..12)
        .map(|_| {
            let at = [0; 3].map(|_: i32| draws.normal());
            let length = at.iter().map(|x| x * x).sum::<f64>().sqrt();
            (at.map(|x| x / length), bumps * draws.normal())
        })
        .collect();
    let turn = draws.between(0.0, std::f64::consts::TAU);
    let mut mesh = icosphere(times);
    for vertex in &mut mesh.vertices {
        let radius = each.iter().fold(1.0, |radius, (at, height)| {
            let way: f64 = (0..3).map(|k| (vertex[k] - at[k]).powi(2)).sum();
            radius + height * (-2.0 * way).exp()
        });
        let [x, y, z] = [0, 1, 2].map(|k| axes[k] * radius * vertex[k] + noise_m * draws.normal());
        *vertex = [
            x * turn.cos() - y * turn.sin(),
            x * turn.sin() + y * turn.cos(),
            z,
        ];
    }
    mesh
}

/// Least vertical distance of the vertices of one mesh from the triangles of another, `upper` over `lower`, m.
fn gap_m(upper: &Mesh, lower: &Mesh) -> f64 {
    let over = |points: &Mesh, faces: &Mesh, sign: f64| {
        let mut least = f64::INFINITY;
        for point in &points.vertices {
            for triangle in &faces.triangles {
                let [a, b, c] = triangle.map(|i| faces.vertices[i]);
                let area = |p: [f64; 3], q: [f64; 3]| {
                    (p[0] - point[0]) * (q[1] - point[1]) - (p[1] - point[1]) * (q[0] - point[0])
                };
                let [u, v, w] = [area(b, c), area(c, a), area(a, b)];
                let whole = u + v + w;
                if u * whole >= 0.0 && v * whole >= 0.0 && w * whole >= 0.0 && whole.abs() > 1e-12 {
                    let height = (u * a[2] + v * b[2] + w * c[2]) / whole;
                    least = least.min(sign * (point[2] - height));
                }
            }
        }
        least
    };
    // for points above the top side of the lower mesh, the nearest triangle; others are far above or below it
    over(upper, lower, 1.0).min(over(lower, upper, -1.0))
}

/// Twelve stones: six on the ground, four in the hollows between them, two on top. Each is as low as the stones below allow; its lowest point is
/// above the ground by at most the gap between vertices.
pub(crate) fn rubble(seed: u64, bumps: f64, noise_m: f64, times: usize) -> Vec<Mesh> {
    let mut draws = Draws(0x9E37_79B9_7F4A_7C15 ^ (seed + 1).wrapping_mul(0xD134_2543_DE82_EF95));
    for _ in 0..8 {
        draws.uniform();
    }
    let mut placed: Vec<Mesh> = Vec::new();
    let layers = [(3, 2), (2, 2), (2, 1)];
    for (layer, (along, across)) in layers.into_iter().enumerate() {
        for i in 0..along {
            for j in 0..across {
                let mut mesh = stone(&mut draws, bumps, noise_m, times);
                let at = [
                    0.72 * (f64::from(i) - 0.5 * f64::from(along - 1)) + draws.between(-0.02, 0.02),
                    0.66 * (f64::from(j) - 0.5 * f64::from(across - 1)) + draws.between(-0.02, 0.02),
                    10.0,
                ];
                // the stones of the middle layer are closer together, above the hollows
                let close = if layer == 1 && across == 2 { 0.6 } else { 1.0 };
                for vertex in &mut mesh.vertices {
                    *vertex = [vertex[0] + at[0], vertex[1] + close * at[1], vertex[2] + at[2]];
                }
                let ground = mesh.vertices.iter().map(|v| v[2]).fold(f64::INFINITY, f64::min);
                let fall = placed
                    .iter()
                    .map(|below| gap_m(&mesh, below))
                    .fold(ground, f64::min);
                for vertex in &mut mesh.vertices {
                    vertex[2] -= fall;
                }
                placed.push(mesh);
            }
        }
    }
    placed
}

/// The stack of loose stones of these meshes, or the name of the stone or stones that are refused and why.
pub(crate) fn loose(meshes: &[Mesh], material: JointMaterial) -> Result<Stack, String> {
    let mut blocks = Vec::new();
    for (number, mesh) in meshes.iter().enumerate() {
        let name = format!("stone {}", number + 1);
        let solid =
            Solid::loose_mesh(&mesh.vertices, &mesh.triangles).map_err(|why| format!("{name}: {why}"))?;
        blocks.push(Block {
            name,
            solid,
            density_kg_m3: 2600.0,
        });
    }
    Stack::loose(blocks, material, 9.80665).map_err(|why: StackError| why.to_string())
}
