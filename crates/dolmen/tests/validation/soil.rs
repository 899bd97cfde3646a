// SOURCE     A rigid punch on an elastic half-space without friction; Boussinesq's surface settlement under a square of pressure.
// GOAL       Rocking stiffness of rectangular and round footings.
// PARAMETERS squares and slender rectangles in both orientations, a circle; shear modulus 40 MPa, Poisson's ratio 0.3.
// TOLERANCE  5 %: the published fit is for a welded footing and accurate to a few per cent, the squares of constant pressure to
//            two.
//
//   another method: squares of constant pressure under the footing, each settling by the closed form of Boussinesq's solution;
//   the pressures that tilt it rigidly give moment over angle.

use dolmen::blocks::{ContactRule, stack_modes};
use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
use dolmen::structure::{Footing, Soil};

const SHEAR_MODULUS_PA: f64 = 40e6;
const POISSON_RATIO: f64 = 0.3;

/// ∫∫ dA / r over the rectangle from the origin to (x, y).
fn corner(x: f64, y: f64) -> f64 {
    let r = x.hypot(y);
    let part = |a: f64, b: f64| match a == 0.0 {
        true => 0.0,
        false => a * (b + r).ln(),
    };
    part(x, y) + part(y, x)
}

/// The same over a square of side `side` about (x, y).
fn square(x: f64, y: f64, side: f64) -> f64 {
    let ends = |at: f64| [at - 0.5 * side, at + 0.5 * side];
    let ([x0, x1], [y0, y1]) = (ends(x), ends(y));
    corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0)
}

/// Moment over angle of the squares of `side` about these centres, all with x > 0: those at −x have the opposite pressure.
fn by_pressures(centres: &[[f64; 2]], side: f64) -> f64 {
    let settles = (1.0 - POISSON_RATIO) / (2.0 * std::f64::consts::PI * SHEAR_MODULUS_PA);
    let n = centres.len();
    let mut rows: Vec<Vec<f64>> = centres
        .iter()
        .map(|[x, y]| {
            let of =
                |[ox, oy]: &[f64; 2]| settles * (square(x - ox, y - oy, side) - square(x + ox, y - oy, side));
            centres.iter().map(of).chain([*x]).collect()
        })
        .collect();
    for i in 0..n {
        let pivot = rows[i].clone();
        for row in rows.iter_mut().skip(i + 1) {
            let factor = row[i] / pivot[i];
            for (value, above) in row.iter_mut().zip(&pivot).skip(i) {
                *value -= factor * above;
            }
        }
    }
    let mut pressure = vec![0.0; n];
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| rows[i][j] * pressure[j]).sum();
        pressure[i] = (rows[i][n] - known) / rows[i][i];
    }
    let moments = centres.iter().zip(&pressure);
    2.0 * side * side * moments.map(|([x, _], p)| x * p).sum::<f64>()
}

fn rocking(footing: Footing) -> f64 {
    let soil = Soil {
        shear_modulus_pa: SHEAR_MODULUS_PA,
        poisson_ratio: POISSON_RATIO,
        footing,
    };
    soil.rocking_n_m_rad()
}

#[test]
fn holds_pressures_on_a_half_space_give_the_same_stiffness() {
    for (along_m, across_m, side) in [
        (2.0_f64, 2.0_f64, 0.1_f64),
        (1.0, 2.0, 0.0625),
        (2.0, 1.0, 0.0625),
        (3.0, 1.0, 0.0625),
    ] {
        let (nx, ny) = (
            (0.5 * along_m / side) as usize,
            (across_m / side).round() as usize,
        );
        let centre = |i: usize, j: usize| [(i as f64 + 0.5) * side, (j as f64 + 0.5) * side - 0.5 * across_m];
        let centres: Vec<[f64; 2]> = (0..nx).flat_map(|i| (0..ny).map(move |j| centre(i, j))).collect();
        let ratio = rocking(Footing::Rectangle { along_m, across_m }) / by_pressures(&centres, side);
        assert!((ratio - 1.0).abs() < 0.05, "{along_m} by {across_m}: {ratio}");
    }
}

#[test]
fn holds_a_round_footing_is_as_stiff_as_the_closed_form_and_the_pressures() {
    let exact = 8.0 * SHEAR_MODULUS_PA / (3.0 * (1.0 - POISSON_RATIO));
    let own = rocking(Footing::Circle { diameter_m: 2.0 });
    assert!((own / exact - 1.0).abs() < 1e-12, "{own} {exact}");
    let side = 0.05;
    let all = (0..20)
        .flat_map(|i| (-20..20).map(move |j| [(f64::from(i) + 0.5) * side, (f64::from(j) + 0.5) * side]));
    let centres: Vec<[f64; 2]> = all.filter(|[x, y]| x.hypot(*y) < 1.0).collect();
    let ratio = own / by_pressures(&centres, side);
    assert!((ratio - 1.0).abs() < 0.05, "{ratio}");
}

#[test]
fn holds_a_joint_and_the_soil_in_series_give_the_joint_back() {
    let soil = Soil {
        shear_modulus_pa: SHEAR_MODULUS_PA,
        poisson_ratio: POISSON_RATIO,
        footing: Footing::Circle { diameter_m: 2.0 },
    };
    for share in [1e-3, 0.4, 0.999] {
        let together = share * soil.rocking_n_m_rad();
        let joint = soil.joint_n_m_rad(together).unwrap();
        assert!((soil.in_series_n_m_rad(joint) / together - 1.0).abs() < 1e-12);
        assert!((1.0 / together - 1.0 / joint - 1.0 / soil.rocking_n_m_rad()).abs() * together < 1e-12);
    }
    assert_eq!(soil.joint_n_m_rad(soil.rocking_n_m_rad()), None);
}

/// A rigid body that sways and rocks on two springs, by its two frequencies in closed form.
#[test]
fn agrees_frequencies_of_one_stone_that_sways_and_rocks() {
    let (side, height, modulus, nu) = (1.2, 3.0, 20e6, 0.3);
    let material = JointMaterial {
        normal_stiffness_pa_m: 1e16,
        shear_stiffness_pa_m: 1e16,
        ..JointMaterial::default()
    };
    let stone = Block {
        name: "stone".into(),
        solid: Solid::cuboid(side, side, height).unwrap(),
        density_kg_m3: 2600.0,
    };
    let stack = Stack::new(vec![stone], material, 9.81)
        .and_then(|stack| stack.on_half_space([modulus, nu], None))
        .unwrap();
    // the square of half side b: K = 4 G b^3/(1 - v), from the formula of the rectangle at L = B
    let rocking = 4.0 * modulus * (0.5_f64 * side).powi(3) / (1.0 - nu);
    let sway = 8.0 * modulus * (side * side / std::f64::consts::PI).sqrt() / (2.0 - nu);
    let mass = 2600.0 * side * side * height;
    let about = mass * (side * side + height * height) / 12.0;
    let lever = 0.5 * height;
    // (sway - m w^2)(rocking + sway c^2 - I w^2) = (sway c)^2 about the centroid, c its height
    let (a, b) = (mass, about);
    let (k, kc, kr) = (sway, sway * lever, rocking + sway * lever * lever);
    let (p, q) = (k / a + kr / b, (k * kr - kc * kc) / (a * b));
    let exact = (0.5 * (p - (p * p - 4.0 * q).sqrt())).sqrt() / std::f64::consts::TAU;
    let modes = stack_modes(&stack, ContactRule::Four).unwrap();
    let found = modes
        .iter()
        .map(|mode| mode.frequency_hz)
        .fold(f64::INFINITY, f64::min);
    assert!((found / exact - 1.0).abs() < 1e-4, "{found} Hz for {exact}");
}
