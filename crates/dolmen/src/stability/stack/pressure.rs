//! Pressure in a joint without tension.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | N, r | `normal_force_n`, `resultant_m` | compressive force, point where its resultant crosses the joint | N, m |
//! | σ(x, y) | `plane` | c₀ + c₁ x + c₂ y about the centroid; positive values are pressure | Pa |
//! | H | `hessian` | ∫ [1 x y]ᵀ [1 x y] over the area in contact | m², m³, m⁴ |

use super::toe::beyond;
use crate::stability::StabilityError;
use crate::structure::stack::Polygon;

/// Linear pressure over the part of a joint that stays in contact.
#[derive(Clone, Debug, PartialEq)]
pub struct JointPressure {
    /// Greatest pressure, at a corner, Pa.
    pub peak_pa: f64,
    /// Its position, m.
    pub peak_at_m: [f64; 2],
    /// Area in contact over area of the joint.
    pub contact_share: f64,
    /// The areas in contact, one for each patch; empty if the patch is open.
    pub contact: Vec<Polygon>,
    /// Pressure is `plane[0] + plane[1] x + plane[2] y` where this is positive, Pa and Pa/m.
    pub plane: [f64; 3],
    /// Number of iterations.
    pub iterations: usize,
    /// Relative error of the force, and of the position of the resultant over the size of the joint.
    pub residual: f64,
}

/// Largest number of iterations; fewer than 20 are needed. Our choice.
const STEPS_MOST: usize = 200;
/// Residual at which the iteration ends. Our choice.
const RESIDUAL: f64 = 1e-12;

/// Pressure under a force on one or several convex patches in one plane: linear, without tension. `None` if the
/// resultant lies outside the convex hull of the patches or on its edge.
///
/// ```text
/// σ = max(0, c₀ + c₁x + c₂y),   ∫σ = N, ∫σx = N r_x, ∫σy = N r_y
///     minimum of ½∫σ² − N (c₀ + c₁r_x + c₂r_y), which is convex: Newton steps H(contact) c = N [1 r_x r_y], shortened
/// rectangle l × b, resultant e from an edge, e < l/3:   peak 2 N / (3 e b), contact 3 e / l
/// ```
///
/// # Errors
/// [`StabilityError::Option`] for a force that is not positive, or an iteration that did not end.
///
/// # Limits
/// The joint stays plane and has uniform stiffness. Near the edge the peak grows without bound.
///
/// # Example
/// ```
/// use dolmen::stability::stack::no_tension_pressure;
/// use dolmen::structure::stack::Polygon;
/// let joint = Polygon { corners_m: vec![[-0.5, -1.0], [0.5, -1.0], [0.5, 1.0], [-0.5, 1.0]] };
/// let pressure = no_tension_pressure(&[joint], 6e3, [0.4, 0.0])?.ok_or("outside")?;
/// assert!((pressure.peak_pa - 2.0 * 6e3 / (3.0 * 0.1 * 2.0)).abs() < 1e-6);
/// assert!((pressure.contact_share - 0.3).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn no_tension_pressure(
    patches: &[Polygon],
    normal_force_n: f64,
    resultant_m: [f64; 2],
) -> Result<Option<JointPressure>, StabilityError> {
    if !(normal_force_n > 0.0 && normal_force_n.is_finite()) {
        return Err(StabilityError::Option {
            option: "normal_force_n",
            given: normal_force_n,
            allowed: "a positive number: a joint without tension bears nothing else",
        });
    }
    let hull = Polygon::hull(patches.iter().flat_map(|patch| patch.corners_m.clone()).collect());
    let depth = hull.depth_m(resultant_m);
    let size = hull.size_m();
    if depth.is_nan() || depth <= 1e-9 * size || hull.corners_m.len() < 3 {
        return Ok(None);
    }
    // coordinates relative to the resultant, divided by the size, and force 1: the loads are then [1, 0, 0]
    let scaled: Vec<Polygon> = patches
        .iter()
        .map(|patch| Polygon {
            corners_m: patch
                .corners_m
                .iter()
                .map(|corner| {
                    [
                        (corner[0] - resultant_m[0]) / size,
                        (corner[1] - resultant_m[1]) / size,
                    ]
                })
                .collect(),
        })
        .collect();
    let area: f64 = scaled.iter().map(|patch| patch.moments().area_m2).sum();
    let mut c = [1.0 / area, 0.0, 0.0];
    let mut hessian = hessian(&in_contact(&scaled, c));
    let mut iterations = 0;
    let residual = loop {
        let got = times(&hessian, c);
        let residual = (got[0] - 1.0).abs().max(got[1].abs()).max(got[2].abs());
        if residual <= RESIDUAL || iterations == STEPS_MOST {
            break residual;
        }
        iterations += 1;
        let Some(target) = solved(&hessian, [1.0, 0.0, 0.0]) else {
            break residual;
        };
        let value = energy(&hessian, c);
        let step: [f64; 3] = std::array::from_fn(|i| target[i] - c[i]);
        let size_of = |v: &[f64; 3]| v.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        if size_of(&step) <= 1e-14 * size_of(&c) {
            break residual; // rounding: the next step would be equal
        }
        let slope: f64 = (0..3)
            .map(|i| step[i] * (got[i] - f64::from(u8::from(i == 0))))
            .sum();
        let mut share = 1.0;
        loop {
            let trial: [f64; 3] = std::array::from_fn(|i| c[i] + share * step[i]);
            let trial_hessian = self::hessian(&in_contact(&scaled, trial));
            let trial_got = times(&trial_hessian, trial);
            let trial_residual = (trial_got[0] - 1.0)
                .abs()
                .max(trial_got[1].abs())
                .max(trial_got[2].abs());
            // Armijo condition with 1e-4 of the slope; near the end the energy is constant within rounding, but the
            // residual is not
            if energy(&trial_hessian, trial) <= value + 1e-4 * share * slope
                || trial_residual <= 0.5 * residual
                || share < 1e-6
            {
                (c, hessian) = (trial, trial_hessian);
                break;
            }
            share *= 0.5;
        }
    };
    if residual > 1e-6 {
        return Err(StabilityError::Pressure { residual, iterations });
    }
    Ok(Some(result(
        patches,
        &scaled,
        c,
        [normal_force_n, size],
        resultant_m,
        iterations,
        residual,
    )))
}

/// Transforms the result back to the coordinates of the joint.
fn result(
    patches: &[Polygon],
    scaled: &[Polygon],
    c: [f64; 3],
    [force, size]: [f64; 2],
    resultant_m: [f64; 2],
    iterations: usize,
    residual: f64,
) -> JointPressure {
    let unit = force / (size * size);
    let plane = [
        unit * (c[0] - (c[1] * resultant_m[0] + c[2] * resultant_m[1]) / size),
        unit * c[1] / size,
        unit * c[2] / size,
    ];
    let contact: Vec<Polygon> = in_contact(scaled, c)
        .into_iter()
        .map(|patch| Polygon {
            corners_m: patch
                .corners_m
                .iter()
                .map(|corner| {
                    [
                        corner[0] * size + resultant_m[0],
                        corner[1] * size + resultant_m[1],
                    ]
                })
                .collect(),
        })
        .collect();
    let pressure = |corner: &[f64; 2]| plane[0] + plane[1] * corner[0] + plane[2] * corner[1];
    let (mut peak_pa, mut peak_at_m) = (f64::NEG_INFINITY, [0.0; 2]);
    for corner in patches.iter().flat_map(|patch| &patch.corners_m) {
        if pressure(corner) > peak_pa {
            (peak_pa, peak_at_m) = (pressure(corner), *corner);
        }
    }
    let area = |polygons: &[Polygon]| polygons.iter().map(|p| p.moments().area_m2).sum::<f64>();
    JointPressure {
        peak_pa,
        peak_at_m,
        contact_share: (area(&contact) / area(patches)).min(1.0),
        contact,
        plane,
        iterations,
        residual,
    }
}

/// Parts of the patches where c₀ + c₁x + c₂y ≥ 0.
fn in_contact(patches: &[Polygon], c: [f64; 3]) -> Vec<Polygon> {
    let slope = c[1].hypot(c[2]);
    if slope == 0.0 {
        return if c[0] > 0.0 { patches.to_vec() } else { Vec::new() };
    }
    let uphill = [c[1] / slope, c[2] / slope];
    patches
        .iter()
        .map(|patch| beyond(patch, uphill, -c[0] / slope))
        .collect()
}

fn hessian(contact: &[Polygon]) -> [[f64; 3]; 3] {
    let mut h = [[0.0; 3]; 3];
    for polygon in contact {
        let m = polygon.moments();
        let (a, [x, y], [xx, yy, xy]) = (m.area_m2, m.centroid_m, m.second_m4);
        h[0][0] += a;
        h[0][1] += a * x;
        h[0][2] += a * y;
        h[1][1] += xx + a * x * x;
        h[2][2] += yy + a * y * y;
        h[1][2] += xy + a * x * y;
    }
    (h[1][0], h[2][0], h[2][1]) = (h[0][1], h[0][2], h[1][2]);
    h
}

fn times(h: &[[f64; 3]; 3], c: [f64; 3]) -> [f64; 3] {
    h.map(|row| row[0] * c[0] + row[1] * c[1] + row[2] * c[2])
}

fn energy(h: &[[f64; 3]; 3], c: [f64; 3]) -> f64 {
    let hc = times(h, c);
    0.5 * (c[0] * hc[0] + c[1] * hc[1] + c[2] * hc[2]) - c[0]
}

/// H c = b by Cholesky; `None` if H is singular.
fn solved(h: &[[f64; 3]; 3], b: [f64; 3]) -> Option<[f64; 3]> {
    let mut l = [[0.0_f64; 3]; 3];
    for i in 0..3 {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| l[i][k] * l[j][k]).sum();
            let left = h[i][j] - sum;
            if i == j {
                if left <= 0.0 {
                    return None;
                }
                l[i][i] = left.sqrt();
            } else {
                l[i][j] = left / l[j][j];
            }
        }
    }
    let mut y = [0.0; 3];
    for i in 0..3 {
        let sum: f64 = (0..i).map(|k| l[i][k] * y[k]).sum();
        y[i] = (b[i] - sum) / l[i][i];
    }
    let mut x = [0.0; 3];
    for i in (0..3).rev() {
        let sum: f64 = (i + 1..3).map(|k| l[k][i] * x[k]).sum();
        x[i] = (y[i] - sum) / l[i][i];
    }
    Some(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    fn rectangle(l: f64, b: f64) -> Polygon {
        Polygon {
            corners_m: vec![
                [-l / 2.0, -b / 2.0],
                [l / 2.0, -b / 2.0],
                [l / 2.0, b / 2.0],
                [-l / 2.0, b / 2.0],
            ],
        }
    }

    #[test]
    fn exact_rectangle_within_and_beyond_the_middle_third() {
        let (l, b, n) = (1.2, 0.7, 5e4);
        for part in [0.0, 0.1, 1.0 / 6.0, 0.2, 0.3, 0.4, 0.49, 0.4999] {
            let p = no_tension_pressure(&[rectangle(l, b)], n, [part * l, 0.0])
                .unwrap()
                .unwrap();
            let e = (0.5 - part) * l;
            let (peak, share) = if part <= 1.0 / 6.0 {
                (n / (l * b) * (1.0 + 6.0 * part), 1.0)
            } else {
                (2.0 * n / (3.0 * e * b), 3.0 * e / l)
            };
            assert!(
                (p.peak_pa / peak - 1.0).abs() < 1e-9,
                "{part}: {} {peak} {}",
                p.peak_pa,
                p.iterations
            );
            assert!((p.contact_share - share).abs() < 1e-9, "{part}");
        }
        assert_eq!(
            no_tension_pressure(&[rectangle(l, b)], n, [0.61, 0.0]).unwrap(),
            None
        );
    }

    #[test]
    fn exact_corner_of_a_rectangle() {
        // resultant so near a corner that the contact is a triangle with legs a = 4 e_x, b = 4 e_y: peak 6 N / (a b)
        let p = no_tension_pressure(&[rectangle(2.0, 1.0)], 1e3, [0.9, 0.45])
            .unwrap()
            .unwrap();
        assert!(
            (p.peak_pa / (6.0 * 1e3 / (0.4 * 0.2)) - 1.0).abs() < 1e-9,
            "{}",
            p.peak_pa
        );
        assert!((p.contact_share - 0.5 * 0.4 * 0.2 / 2.0).abs() < 1e-10);
    }

    #[test]
    fn holds_force_and_moments_on_several_patches() {
        let mut random = Random::new(7, 0);
        let mut patches = vec![rectangle(0.4, 0.4), rectangle(0.3, 0.5)];
        for corner in &mut patches[1].corners_m {
            corner[0] += 1.0;
        }
        let mut most = 0;
        for _ in 0..300 {
            let r = [-0.15 + 1.25 * random.uniform(), 0.36 * (random.uniform() - 0.5)];
            let p = no_tension_pressure(&patches, 2.0, r).unwrap().unwrap();
            most = most.max(p.iterations);
            let mut sums = [0.0; 3];
            for part in &p.contact {
                let m = part.moments();
                let ([x, y], [xx, yy, xy]) = (m.centroid_m, m.second_m4);
                let mean = p.plane[0] + p.plane[1] * x + p.plane[2] * y;
                sums[0] += mean * m.area_m2;
                sums[1] += mean * m.area_m2 * x + p.plane[1] * xx + p.plane[2] * xy;
                sums[2] += mean * m.area_m2 * y + p.plane[1] * xy + p.plane[2] * yy;
            }
            assert!(
                (sums[0] - 2.0).abs() < 1e-9 && (sums[1] - 2.0 * r[0]).abs() < 1e-9,
                "{r:?} {sums:?}"
            );
            assert!((sums[2] - 2.0 * r[1]).abs() < 1e-9, "{r:?} {sums:?}");
        }
        assert!(most < 40, "{most}");
    }

    #[test]
    fn refuses_a_pull() {
        assert!(no_tension_pressure(&[rectangle(1.0, 1.0)], -1.0, [0.0, 0.0]).is_err());
    }
}
