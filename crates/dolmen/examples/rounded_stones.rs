//! Rounded stones on flat ground: how many Dolmen takes to stand on a bed, although they roll at any acceleration.
//!
//! `cargo run --release -p dolmen --example rounded_stones [SEEDS]` prints a row for each radius and noise: stones, those called stable, and the largest
//! acceleration at which one of them would begin to move.

#![allow(clippy::print_stdout, reason = "a measurement")]

use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A small generator of random numbers (xorshift), so that rows repeat.
struct Draws(u64);

impl Draws {
    fn uniform(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let (a, b) = (self.uniform().max(1e-300), self.uniform());
        (-2.0 * a.ln()).sqrt() * (TAU * b).cos()
    }
}

type Mesh = (Vec<[f64; 3]>, Vec<[usize; 3]>);

/// A box on the origin, its sides divided into squares, each cut in two.
fn cut_box(size: [f64; 3], n: [usize; 3]) -> Mesh {
    let mut numbers: BTreeMap<[usize; 3], usize> = BTreeMap::new();
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for axis in 0..3 {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        for end in [0, n[axis]] {
            for (i, j) in (0..n[next] * n[last]).map(|k| (k / n[last], k % n[last])) {
                let mut corner = |a: usize, b: usize| {
                    let mut key = [0; 3];
                    (key[axis], key[next], key[last]) = (end, a, b);
                    *numbers.entry(key).or_insert_with(|| {
                        vertices.push([0, 1, 2].map(|k| size[k] * (key[k] as f64 / n[k] as f64 - 0.5)));
                        vertices.len() - 1
                    })
                };
                let [a, b, c, d] = [
                    corner(i, j),
                    corner(i + 1, j),
                    corner(i + 1, j + 1),
                    corner(i, j + 1),
                ];
                let two = match (i + j) % 2 {
                    0 => [[a, b, c], [a, c, d]],
                    _ => [[a, b, d], [b, c, d]],
                };
                triangles.extend(two.map(|t| if end == 0 { [t[0], t[2], t[1]] } else { t }));
            }
        }
    }
    (vertices, triangles)
}

/// A boulder: a spheroid whose crown has this radius of curvature, 0.6 m or less wide, from a turned cube of `n` squares a side.
fn boulder(radius_m: f64, n: usize, draws: &mut Draws) -> Mesh {
    let (mut vertices, triangles) = cut_box([2.0; 3], [n; 3]);
    let half_height = radius_m.min(0.09 / radius_m);
    let half_width = (radius_m * half_height).sqrt();
    let q = [0; 4].map(|_| draws.normal());
    let length = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|part| part / length);
    for v in &mut vertices {
        let size = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let [a, b, c] = v.map(|x| x / size);
        // turned by the quaternion: v + 2 w (q × v) + 2 q × (q × v)
        let [i, j, k] = [y * c - z * b, z * a - x * c, x * b - y * a].map(|part| 2.0 * part);
        *v = [
            half_width * (a + w * i + y * k - z * j),
            half_width * (b + w * j + z * i - x * k),
            half_height * (c + w * k + x * j - y * i),
        ];
    }
    (vertices, triangles)
}

/// A block of 0.4 × 0.36 × 0.4 m with a base that is part of a sphere, or of a cylinder.
fn block(radius_m: f64, edge_m: f64, is_sphere: bool) -> Mesh {
    let size = [0.4, 0.36, 0.4];
    let (mut vertices, triangles) = cut_box(size, size.map(|length| (length / edge_m).round() as usize));
    for v in &mut vertices {
        let across = if is_sphere { v[0].hypot(v[1]) } else { v[0].abs() };
        let rise = radius_m
            - (radius_m * radius_m - across * across)
                .max(0.25 * radius_m * radius_m)
                .sqrt();
        v[2] += rise * (0.5 - v[2] / size[2]);
    }
    (vertices, triangles)
}

/// The acceleration at which the stone on its bed begins to rock, g; the reason if it has none.
fn answer((mut vertices, triangles): Mesh, noise_m: f64, draws: &mut Draws) -> Result<f64, String> {
    vertices
        .iter_mut()
        .flatten()
        .for_each(|x| *x += noise_m * draws.normal());
    let low = vertices.iter().map(|v| v[2]).fold(f64::INFINITY, f64::min);
    vertices.iter_mut().for_each(|v| v[2] -= low);
    let solid = Solid::mesh(&vertices, &triangles).map_err(|why| why.to_string())?;
    let centroid = solid.centroid_m();
    let stone = Block {
        name: "stone".to_owned(),
        solid,
        density_kg_m3: 2600.0,
    };
    let stack = Stack::new(vec![stone], JointMaterial::default(), 9.80665).map_err(|why| why.to_string())?;
    let joint = &stack.joints()[0];
    let from = [0, 1].map(|k| centroid[k] - joint.origin_m[k]);
    let reach = (0..360).map(|degree| {
        let (sin, cos) = (TAU * f64::from(degree) / 360.0).sin_cos();
        joint.patch.reach_m(from, [cos, sin])
    });
    Ok(reach.fold(f64::INFINITY, f64::min) / (centroid[2] - joint.origin_m[2]))
}

fn main() {
    let seeds: usize = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(20);
    println!("shape,radius_m,noise_mm,stones,stable,largest_g");
    for shape in ["boulder", "base of a sphere", "base of a cylinder"] {
        for radius_m in [0.2, 0.3, 0.5, 1.0, 2.0, 3.0] {
            for noise_mm in [0.0, 0.1, 0.5, 1.0] {
                let mut draws = Draws(0x9e37_79b9_7f4a_7c15);
                let (mut stable, mut largest_g) = (0, 0.0_f64);
                for edge_m in [0.02, 0.04] {
                    for _ in 0..seeds {
                        let mesh = match shape {
                            "boulder" => boulder(radius_m, (0.4 / edge_m) as usize, &mut draws),
                            _ => block(radius_m, edge_m, shape == "base of a sphere"),
                        };
                        // what is in balance on its bed is called stable or marginal
                        if let Ok(first_g) = answer(mesh, 1e-3 * noise_mm, &mut draws)
                            && first_g > 0.0
                        {
                            stable += 1;
                            largest_g = largest_g.max(first_g);
                        }
                    }
                }
                println!(
                    "{shape},{radius_m},{noise_mm},{},{stable},{largest_g:.3}",
                    2 * seeds
                );
            }
        }
    }
}
