//! Made scans against the exact solids: towers of boxes and frusta as meshes with noise, first motion of both.
//!
//! `cargo run --release -p dolmen --example made_scans [TOWERS [NOISE_MM [EDGE_MM]]]` prints a row for each noise and edge: towers, those answered, the
//! largest difference of first motion, how many differ by more than 2 %, how many answers say what an error of the corners of their beds would change,
//! and how many of these differ by at most twice as much; and the refusals.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a measurement")]

use dolmen::assess::{StackCheckOptions, StackNote, check_stack};
use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};
use std::collections::BTreeMap;

/// Number of refusals that are printed for each row.
const REFUSALS: usize = 4;

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
        (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.uniform()
    }
}

/// A frustum as a mesh: sides divided into squares of about `edge_m`, each cut in two, corners off by `noise_m`.
fn scan(
    base: [f64; 2],
    top: [f64; 2],
    height: f64,
    place: &Placement,
    edge_m: f64,
    noise_m: f64,
    draws: &mut Draws,
) -> Result<Solid, String> {
    let longest = base[0].max(base[1]).max(top[0]).max(top[1]).max(height);
    let n = ((longest / edge_m).ceil() as usize).max(1);
    let point = |u: f64, v: f64, w: f64| {
        let size = [0, 1].map(|k| base[k] + (top[k] - base[k]) * w);
        [size[0] * (u - 0.5), size[1] * (v - 0.5), height * w]
    };
    let mut numbers: BTreeMap<[usize; 3], usize> = BTreeMap::new();
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    let mut triangles: Vec<[usize; 3]> = Vec::new();
    for axis in 0..3 {
        for end in [0, n] {
            for i in 0..n {
                for j in 0..n {
                    let mut corner = |a: usize, b: usize| {
                        let mut key = [0; 3];
                        (key[axis], key[(axis + 1) % 3], key[(axis + 2) % 3]) = (end, a, b);
                        *numbers.entry(key).or_insert_with(|| {
                            let [u, v, w] = key.map(|k| k as f64 / n as f64);
                            vertices.push(point(u, v, w));
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
    }
    let (sin, cos) = place.yaw_rad.sin_cos();
    for v in &mut vertices {
        *v = [
            cos * v[0] - sin * v[1] + place.position_m[0] + noise_m * draws.normal(),
            sin * v[0] + cos * v[1] + place.position_m[1] + noise_m * draws.normal(),
            v[2] + place.position_m[2] + noise_m * draws.normal(),
        ];
    }
    Solid::mesh(&vertices, &triangles).map_err(|why| why.to_string())
}

/// The first motion of a tower, over gravity, and its relative change if the corners of its beds are 1 m off, where only these are known.
struct Motion {
    acceleration_g: f64,
    change_per_m: Option<f64>,
}

fn first_motion(blocks: Vec<Block>) -> Result<Motion, String> {
    let stack = Stack::new(blocks, JointMaterial::default(), 9.80665).map_err(|why| why.to_string())?;
    let check = check_stack(&stack, &StackCheckOptions::default()).map_err(|why| why.to_string())?;
    let governing = check.limits.governing.ok_or("no limit")?;
    let change_per_m = check.notes.iter().find_map(|note| match note {
        StackNote::OnlyCorners { off_m, change, .. } => Some(change / off_m),
        _ => None,
    });
    Ok(Motion {
        acceleration_g: governing.threshold.acceleration_g,
        change_per_m,
    })
}

fn tower(draws: &mut Draws, edge_m: f64, noise_m: f64) -> [Result<Motion, String>; 2] {
    let block = |number: usize, solid: Solid| Block {
        name: format!("stone {number}"),
        solid,
        density_kg_m3: 2600.0,
    };
    let (mut exact, mut scanned, mut fault) = (Vec::new(), Vec::new(), None);
    let (mut z, mut wide) = (0.0, draws.between(0.5, 0.9));
    let stones = 2 + (draws.uniform() * 3.0) as usize;
    for number in 1..=stones {
        let depth = wide * draws.between(0.8, 1.0);
        let height = draws.between(0.3, 0.6);
        let narrow = if draws.uniform() < 0.5 {
            1.0
        } else {
            draws.between(0.75, 0.95)
        };
        let (base, top) = ([wide, depth], [wide * narrow, depth * narrow]);
        let place = Placement {
            yaw_rad: draws.between(-0.1, 0.1),
            position_m: [draws.between(-0.01, 0.01), draws.between(-0.01, 0.01), z],
            ..Placement::default()
        };
        exact.push(block(
            number,
            Solid::frustum(base, top, height)
                .unwrap_or_else(|why| panic!("{why}"))
                .placed(&place),
        ));
        match scan(base, top, height, &place, edge_m, noise_m, draws) {
            Ok(solid) => scanned.push(block(number, solid)),
            Err(why) => fault = Some(format!("stone {number}: {why}")),
        }
        z += height;
        wide = (wide * narrow * draws.between(0.8, 1.0)).max(0.3);
    }
    let scanned = match fault {
        Some(why) => Err(why),
        None => first_motion(scanned),
    };
    [first_motion(exact), scanned]
}

fn main() {
    let towers = std::env::args().nth(1).and_then(|n| n.parse().ok()).unwrap_or(40);
    let only: Option<f64> = std::env::args().nth(2).and_then(|mm| mm.parse().ok());
    let edge: Option<f64> = std::env::args().nth(3).and_then(|mm| mm.parse().ok());
    println!(
        "noise_mm,edge_mm,towers,answered,largest_difference_percent,above_2_percent,only_corners,within_twice"
    );
    let noises = [0.0, 0.01, 0.1, 1.0, 2.0].into_iter();
    for noise_mm in noises.filter(|mm| only.is_none_or(|only| only == *mm)) {
        for edge_mm in [10.0, 25.0, 50.0, 1000.0]
            .into_iter()
            .filter(|mm| edge.is_none_or(|edge| edge == *mm))
        {
            let mut draws = Draws(0x9e37_79b9_7f4a_7c15);
            let (mut answered, mut largest, mut wrong) = (0, 0.0_f64, 0);
            let (mut stated, mut within) = (0, 0);
            let mut refusals: BTreeMap<String, usize> = BTreeMap::new();
            for _ in 0..towers {
                let [exact, found] = tower(&mut draws, 1e-3 * edge_mm, 1e-3 * noise_mm);
                match [exact, found] {
                    [Ok(exact), Ok(found)] => {
                        let off = (found.acceleration_g / exact.acceleration_g - 1.0).abs();
                        if let Some(change_per_m) = found.change_per_m {
                            let truth_off = (exact.acceleration_g / found.acceleration_g - 1.0).abs();
                            stated += 1;
                            within += usize::from(truth_off <= 2e-3 * noise_mm * change_per_m);
                        }
                        answered += 1;
                        largest = largest.max(off);
                        wrong += usize::from(off > 0.02);
                    }
                    [_, Err(why)] | [Err(why), Ok(_)] => {
                        *refusals.entry(why.chars().take(200).collect()).or_default() += 1
                    }
                }
            }
            println!(
                "{noise_mm},{edge_mm},{towers},{answered},{:.3},{wrong},{stated},{within}",
                100.0 * largest
            );
            for (why, count) in refusals.iter().take(REFUSALS) {
                eprintln!("    {count} × {why}");
            }
        }
    }
}
