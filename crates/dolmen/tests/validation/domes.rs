// SOURCE     Vaults: least thickness of semicircular arches of the same section (assemblies.rs). Domes: a linear programme for one slice of the dome,
//            written here on microlp 0.7; least thicknesses also by scipy 1.16 (HiGHS). A hemisphere of thin slices without hoop forces needs 0.0428
//            of its middle radius.
// GOAL       Barrels stand and fall as their section; slices and whole domes as the slice with and without hoop forces; too little friction slides.
//
//        a whole dome in straight bond is symmetric: if any forces balance it, symmetric ones do. A slice of width 2η then has in its middle plane
//        bed forces at the inner and outer edge of both beds, and at each corner the resultant 2 N sin η of both hoop forces, outwards.
//
// PARAMETERS barrels of 9 voussoirs; slices and domes of 4 to 8 rings, 8 to 12 stones, with and without oculus; friction 5 against sliding.
// TOLERANCE  2e-3 of the thickness, 5e-3 of the friction: it falls below and stands above.

use crate::stack_loads::GRAVITY_M_S2;
use dolmen::assess::{StackCheckOptions, check_stack};
use dolmen::stability::Verdict;
use dolmen::stability::stack::{LimitAnalysis, LimitAnalysisStatus, Shaking, limit_analysis};
use dolmen::structure::stack::{
    Block, Bond, DomeFactors, DomePart, JointMaterial, Stack, VaultFactors, dome, vault,
};
use microlp::{ComparisonOp, LinearExpr, OptimizationDirection, Problem};
use std::f64::consts::{FRAC_PI_2, PI};

fn stack(blocks: Vec<Block>, friction: f64) -> Stack {
    Stack::new(blocks, JointMaterial::with_friction(friction), GRAVITY_M_S2).unwrap()
}

fn stands(blocks: Vec<Block>, friction: f64) -> bool {
    let options = LimitAnalysis {
        shaking: Shaking::Along([1.0, 0.0]),
        ..LimitAnalysis::default()
    };
    let found = limit_analysis(&stack(blocks, friction), &options).unwrap();
    found.status != LimitAnalysisStatus::DoesNotStand
}

/// A hemisphere whose middle surface has the radius 1 m.
#[derive(Clone, Copy)]
struct Hemisphere {
    rings: u32,
    stones: u32,
    oculus_m: Option<f64>,
    part: DomePart,
    friction: f64,
}

const WHOLE: Hemisphere = Hemisphere {
    rings: 4,
    stones: 8,
    oculus_m: Some(0.4),
    part: DomePart::Whole(Bond::Straight),
    friction: 5.0,
};
const SLICES: Hemisphere = Hemisphere {
    rings: 8,
    stones: 12,
    oculus_m: None,
    part: DomePart::Lune,
    friction: 5.0,
};

/// The forces of one slice: equations of its stones, then that of its share of the keystone.
struct Slice {
    problem: Problem,
    sums: Vec<LinearExpr>,
    centroids: Vec<[f64; 2]>,
}

impl Slice {
    /// A force on a stone, or a fraction `sign` of it.
    fn put(&mut self, stone: usize, at: [f64; 2], sign: f64, force: (microlp::Variable, [f64; 2])) {
        let (variable, way) = force;
        match self.centroids.get(stone) {
            Some(centroid) => {
                let arm = [at[0] - centroid[0], at[1] - centroid[1]];
                self.sums[3 * stone].add(variable, sign * way[0]);
                self.sums[3 * stone + 1].add(variable, sign * way[1]);
                self.sums[3 * stone + 2].add(variable, sign * (arm[0] * way[1] - arm[1] * way[0]));
            }
            None => self.sums[3 * stone].add(variable, sign * way[1]),
        }
    }
}

impl Hemisphere {
    fn blocks(self, thickness_m: f64) -> Vec<Block> {
        let inner_m = 1.0 - 0.5 * thickness_m;
        dome(&DomeFactors {
            span_m: 2.0 * inner_m,
            rise_m: inner_m,
            thickness_m,
            rings: self.rings,
            stones: self.stones,
            part: self.part,
            oculus_m: self.oculus_m,
            drum_height_m: 0.0,
            drum_thickness_m: 1.0,
            density_kg_m3: 2600.0,
        })
        .unwrap()
    }

    fn stands(self, thickness_m: f64) -> bool {
        stands(self.blocks(thickness_m), self.friction)
    }

    /// Whether forces balance one slice, by simplex.
    fn stands_by_simplex(self, thickness_m: f64) -> bool {
        let radii = [1.0 - 0.5 * thickness_m, 1.0 + 0.5 * thickness_m];
        let (rings, eta) = (self.rings as usize, PI / f64::from(self.stones));
        let step = match self.oculus_m {
            Some(oculus) => (FRAC_PI_2 - (0.5 * oculus / radii[0]).asin()) / rings as f64,
            None => FRAC_PI_2 / (rings as f64 + 0.5),
        };
        let theta = |bed: usize| FRAC_PI_2 - bed as f64 * step;
        let at = |radius: f64, bed: usize| [radius * theta(bed).sin() * eta.cos(), radius * theta(bed).cos()];
        let powers = |power: i32| radii[1].powi(power) - radii[0].powi(power);
        let (mut centroids, mut weights) = (Vec::new(), Vec::new());
        for ring in 0..rings {
            // the outer less the inner of two pyramids from the centre over a trapezoid
            let ([low, high], [wide, narrow]) = (
                [at(1.0, ring), at(1.0, ring + 1)],
                [theta(ring).sin(), theta(ring + 1).sin()],
            );
            let up = (wide + 2.0 * narrow) / (3.0 * (wide + narrow));
            let far = 0.75 * powers(4) / powers(3);
            centroids.push([0, 1].map(|k| far * (low[k] + up * (high[k] - low[k]))));
            let cross = (low[0] * high[1] - low[1] * high[0]).abs();
            weights.push((wide + narrow) * eta.sin() * cross * powers(3) / 3.0);
        }
        let is_closed = self.oculus_m.is_none();
        let mut slice = Slice {
            problem: Problem::new(OptimizationDirection::Maximize),
            sums: vec![LinearExpr::empty(); 3 * rings + usize::from(is_closed)],
            centroids,
        };
        for bed in 0..rings + usize::from(is_closed) {
            let along = {
                let [x, z] = at(1.0, bed);
                [x / x.hypot(z), z / x.hypot(z)]
            };
            let normal = [-along[1], along[0]];
            for radius in radii {
                let press = slice.problem.add_var(0.0, (0.0, f64::INFINITY));
                let rub = slice.problem.add_var(0.0, (f64::NEG_INFINITY, f64::INFINITY));
                for sign in [1.0, -1.0] {
                    let mut cone = LinearExpr::empty();
                    cone.add(rub, sign);
                    cone.add(press, -self.friction);
                    slice.problem.add_constraint(cone, ComparisonOp::Le, 0.0);
                }
                for force in [(press, normal), (rub, along)] {
                    slice.put(bed, at(radius, bed), 1.0, force);
                    if bed > 0 {
                        slice.put(bed - 1, at(radius, bed), -1.0, force);
                    }
                }
            }
        }
        if self.part != DomePart::Lune {
            for ring in 0..rings {
                for (radius, bed) in radii.into_iter().flat_map(|r| [(r, ring), (r, ring + 1)]) {
                    let press = slice.problem.add_var(0.0, (0.0, f64::INFINITY));
                    slice.put(ring, at(radius, bed), 1.0, (press, [2.0 * eta.sin(), 0.0]));
                }
            }
        }
        let top = theta(rings);
        let wedge = eta.sin() * eta.cos() * top.sin().powi(2) * top.cos() * powers(3) / 3.0;
        let keystone = match self.part {
            DomePart::Lune => 2.0 * wedge,
            DomePart::Whole(_) => wedge,
        };
        let largest = weights.iter().copied().fold(0.0, f64::max);
        for (row, sum) in slice.sums.into_iter().enumerate() {
            let right = match (weights.get(row / 3), row % 3) {
                (Some(weight), 1) => weight / largest,
                (Some(_), _) => 0.0,
                (None, _) => keystone / largest,
            };
            slice.problem.add_constraint(sum, ComparisonOp::Eq, right);
        }
        slice
            .problem
            .solve()
            .is_ok_and(|found| found.into_solution().is_ok())
    }

    /// The value at which the slice begins to stand, between two values.
    fn least(self, [mut falls, mut stands]: [f64; 2], stands_at: impl Fn(f64) -> bool) -> f64 {
        while stands - falls > 1e-5 * stands {
            let middle = 0.5 * (falls + stands);
            match stands_at(middle) {
                true => stands = middle,
                false => falls = middle,
            }
        }
        0.5 * (falls + stands)
    }

    fn least_thickness(self) -> f64 {
        self.least([0.01, 0.2], |thickness| self.stands_by_simplex(thickness))
    }
}

#[test]
fn holds_a_barrel_stands_and_falls_as_its_section() {
    let of = |thickness_m: f64, stones: u32, bond: Bond| {
        let inner_m = 1.0 - 0.5 * thickness_m;
        let made = vault(&VaultFactors {
            span_m: 2.0 * inner_m,
            rise_m: inner_m,
            thickness_m,
            length_m: 0.8,
            voussoirs: 9,
            stones,
            bond,
            springing_height_m: 0.0,
            abutment_m: 1.0,
            density_kg_m3: 2600.0,
        });
        stands(made.unwrap(), 5.0)
    };
    for (stones, bond) in [
        (2, Bond::Straight),
        (3, Bond::Straight),
        (2, Bond::Running),
        (3, Bond::Running),
    ] {
        assert!(!of(0.101525 * 0.998, stones, bond), "{stones} {bond:?}");
        assert!(of(0.101525 * 1.002, stones, bond), "{stones} {bond:?}");
    }
}

#[test]
fn agrees_slices_of_a_hemisphere_with_a_programme_for_one() {
    for (rings, stones, known) in [(6, 8, 0.041566), (8, 12, 0.042778)] {
        let slices = Hemisphere {
            rings,
            stones,
            ..SLICES
        };
        let least = slices.least_thickness();
        assert!((least / known - 1.0).abs() < 1e-4, "{least} {known}");
        let verdict = |thickness| {
            let stack = stack(slices.blocks(thickness), 5.0);
            check_stack(&stack, &StackCheckOptions::default())
                .unwrap()
                .verdict
        };
        assert_eq!(verdict(0.998 * least), Verdict::Unstable);
        assert_eq!(verdict(1.002 * least), Verdict::Marginal);
    }
    // many rings of thin slices
    let many = Hemisphere {
        rings: 20,
        stones: 60,
        ..SLICES
    };
    assert!(!many.stands_by_simplex(0.0426) && many.stands_by_simplex(0.0429));
}

#[test]
fn agrees_rings_carry_an_oculus_that_slices_cannot() {
    for (rings, oculus_m, known) in [(4, Some(0.4), 0.038438), (3, None, f64::NAN)] {
        let whole = Hemisphere {
            rings,
            oculus_m,
            ..WHOLE
        };
        let least = whole.least_thickness();
        assert!(known.is_nan() || (least / known - 1.0).abs() < 1e-4, "{least}");
        assert!(!whole.stands(0.998 * least), "{rings}");
        assert!(whole.stands(1.002 * least), "{rings}");
    }
    for thickness in [0.1, 0.3] {
        let slices = Hemisphere {
            part: DomePart::Lune,
            ..WHOLE
        };
        assert!(WHOLE.stands(thickness));
        assert!(!slices.stands(thickness) && !slices.stands_by_simplex(thickness));
    }
}

#[test]
fn agrees_too_little_friction_slides() {
    for (of, thickness) in [(WHOLE, 0.15), (SLICES, 0.15)] {
        let with = |friction| Hemisphere { friction, ..of };
        let least = of.least([0.01, 5.0], |friction| {
            with(friction).stands_by_simplex(thickness)
        });
        assert!((0.05..1.0).contains(&least), "{least}");
        assert!(!with(0.995 * least).stands(thickness), "{least}");
        assert!(with(1.005 * least).stands(thickness), "{least}");
    }
}
