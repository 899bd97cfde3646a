// SOURCE     arithmetic: a block of width b and height h tips at b/h and slides at tan φ; two pillars below a beam sway at b/h
// GOAL       where meshes show only the corners of the beds that decide the first motion, the check says what 1 mm of error in them changes
// PARAMETERS boxes and frusta as meshes, each side one square (eight corners) or 8 × 8; noise of 2 mm of each vertex along x, y and z
// TOLERANCE  block 1e-9 (rounding), limit analysis 1e-5; of the made scans at least 95 % of the true limits lie within twice the stated change

use dolmen::assess::{StackCheck, StackCheckOptions, StackNote, check_stack};
use dolmen::numeric::Random;
use dolmen::structure::stack::{Block, Body, JointMaterial, Solid, Stack};
use std::collections::BTreeMap;

/// A frustum between rectangles in plan, centred on `at`, and how its mesh shows it.
#[derive(Clone, Copy)]
struct Stone {
    base: [f64; 2],
    top: [f64; 2],
    height: f64,
    at: [f64; 3],
}

impl Stone {
    fn boxed(size: [f64; 3], at: [f64; 3]) -> Self {
        let [width, depth, height] = size;
        let base = [width, depth];
        Stone {
            base,
            top: base,
            height,
            at,
        }
    }

    /// Its mesh with each side in n × n squares, and every vertex moved along x, y and z by `noise`.
    fn mesh(&self, n: usize, mut noise: impl FnMut() -> f64) -> Result<Solid, String> {
        let mut numbers: BTreeMap<[usize; 3], usize> = BTreeMap::new();
        let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
        for (axis, end) in (0..3).flat_map(|axis| [(axis, 0), (axis, n)]) {
            for (i, j) in (0..n * n).map(|k| (k / n, k % n)) {
                let mut corner = |a: usize, b: usize| {
                    let mut key = [0; 3];
                    (key[axis], key[(axis + 1) % 3], key[(axis + 2) % 3]) = (end, a, b);
                    *numbers.entry(key).or_insert_with(|| {
                        let [u, v, w] = key.map(|k| k as f64 / n as f64);
                        let size = [0, 1].map(|k| self.base[k] + (self.top[k] - self.base[k]) * w);
                        let place = [size[0] * (u - 0.5), size[1] * (v - 0.5), self.height * w];
                        vertices.push([0, 1, 2].map(|k| self.at[k] + place[k] + noise()));
                        vertices.len() - 1
                    })
                };
                let [a, b, c, d] =
                    [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(a, b)| corner(a, b));
                let two = [[a, b, c], [a, c, d]];
                triangles.extend(two.map(|t| if end == 0 { [t[0], t[2], t[1]] } else { t }));
            }
        }
        Solid::mesh(&vertices, &triangles).map_err(|why| why.to_string())
    }

    fn drawn(&self) -> Solid {
        let place = dolmen::structure::stack::Placement {
            position_m: self.at,
            ..Default::default()
        };
        Solid::frustum(self.base, self.top, self.height)
            .unwrap()
            .placed(&place)
    }
}

fn check(solids: Vec<Solid>, friction: f64) -> Result<StackCheck, String> {
    let blocks = solids.into_iter().enumerate().map(|(number, solid)| Block {
        name: format!("stone {}", number + 1),
        solid,
        density_kg_m3: 2600.0,
    });
    let stack = Stack::new(blocks.collect(), JointMaterial::with_friction(friction), 9.81)
        .map_err(|why| why.to_string())?;
    check_stack(&stack, &StackCheckOptions::default()).map_err(|why| why.to_string())
}

/// The bed that the note names, and the relative change by 1 mm.
fn noted(check: &StackCheck) -> Option<(Body, usize, f64)> {
    check.notes.iter().find_map(|note| match note {
        StackNote::OnlyCorners {
            lower,
            upper,
            off_m,
            change,
        } => {
            assert_eq!(*off_m, 1e-3);
            Some((*lower, *upper, *change))
        }
        _ => None,
    })
}

#[test]
fn exact_one_millimetre_of_the_corners_of_a_block() {
    let still = || 0.0;
    for (size, friction, exact) in [
        // tips at b/h: (b − 2 mm)/h
        ([0.6, 0.8, 2.0], 0.6, 2e-3 / 0.6),
        ([0.12, 0.3, 0.5], 0.6, 2e-3 / 0.12),
        // slides at tan φ along x, its bed 2 mm lower over b
        (
            [0.6, 0.6, 0.3],
            0.5,
            1.0 - (0.5_f64.atan() - 2e-3 / 0.6).tan() / 0.5,
        ),
    ] {
        let stone = Stone::boxed(size, [0.0; 3]);
        let (lower, upper, change) =
            noted(&check(vec![stone.mesh(1, still).unwrap()], friction).unwrap()).unwrap();
        assert_eq!((lower, upper), (Body::Ground, 0));
        assert!((change - exact).abs() < 1e-9, "{size:?}: {change} for {exact}");
        for solid in [stone.mesh(8, still).unwrap(), stone.drawn()] {
            assert_eq!(noted(&check(vec![solid], friction).unwrap()), None);
        }
    }
}

#[test]
fn exact_one_millimetre_of_the_corners_of_two_pillars_below_a_beam() {
    let pillar = |x: f64| Stone::boxed([0.4, 2.0, 2.0], [x, 0.0, 0.0]);
    let beam = Stone::boxed([2.0, 2.0, 0.5], [0.0, 0.0, 2.0]).drawn();
    let meshes = [-0.8, 0.8].map(|x| pillar(x).mesh(1, || 0.0).unwrap());
    let [left, right] = meshes;
    let found = check(vec![left, right, beam.clone()], 2.0).unwrap();
    let (.., change) = noted(&found).unwrap();
    // both ends of each pillar: (b − 2 mm)/h
    assert!((change - 2e-3 / 0.4).abs() < 1e-5, "{change}");
    let drawn = vec![pillar(-0.8).drawn(), pillar(0.8).drawn(), beam];
    assert_eq!(noted(&check(drawn, 2.0).unwrap()), None);
}

/// A tower of two to four boxes and frusta.
fn tower(random: &mut Random) -> Vec<Stone> {
    let mut between = |low: f64, high: f64| low + (high - low) * random.uniform();
    let stones = between(2.0, 5.0) as usize;
    let (mut z, mut wide) = (0.0, between(0.5, 0.9));
    (0..stones)
        .map(|_| {
            let (depth, height) = (wide * between(0.8, 1.0), between(0.3, 0.6));
            let narrow = between(0.75, 1.2).min(1.0);
            let stone = Stone {
                base: [wide, depth],
                top: [wide * narrow, depth * narrow],
                height,
                at: [between(-0.01, 0.01), between(-0.01, 0.01), z],
            };
            z += height;
            wide = (wide * narrow * between(0.8, 1.0)).max(0.3);
            stone
        })
        .collect()
}

#[test]
fn holds_the_true_limit_lies_within_twice_the_stated_change() {
    const NOISE_M: f64 = 2e-3;
    let (mut answered, mut within) = (0, 0);
    for number in 0..50 {
        let mut random = Random::new(16, number);
        let stones = tower(&mut random);
        let exact = check(stones.iter().map(Stone::drawn).collect(), 0.6).unwrap();
        let mut noise = || NOISE_M * random.normal();
        let meshes: Result<Vec<Solid>, String> =
            stones.iter().map(|stone| stone.mesh(1, &mut noise)).collect();
        let Ok(found) = meshes.and_then(|solids| check(solids, 0.6)) else {
            continue; // its corners bound no plane
        };
        let limit = |check: &StackCheck| check.capacity.unwrap().acceleration_g;
        let (.., change) = noted(&found).unwrap();
        let off = (limit(&exact) / limit(&found) - 1.0).abs();
        answered += 1;
        within += usize::from(off <= 2.0 * change * NOISE_M / 1e-3);
    }
    assert!(answered >= 30, "{answered}");
    assert!(within * 100 >= 95 * answered, "{within} of {answered}");
}
