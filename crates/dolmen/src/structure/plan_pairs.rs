//! Pairs of modes of nearly one frequency, along x and along y, that a record shows mixed in plan.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | φ_1, φ_2 | `pair` | real shapes of two neighbouring modes, of length 1 |
//! | e_1, e_2 | `basis` | orthonormal basis of their plane |
//! | v_x, v_y | `along` | vectors of the plane with the largest share along x and along y |
//! | w | `overlap` | (v·φ)²: how much of a vector each measured mode has |

use super::real_shape::{ALONG_LEAST, real_shape};
use crate::modal::{Mode, Modes};
use dolmen_linalg::Complex64;

/// Largest ratio of the two frequencies. Our choice: records of 10 min of a square pavilion with 2 % of damping mix two modes 1 % apart, and
/// keep two modes 3 % apart.
const RATIO_MOST: f64 = 1.03;
/// Share of a shape along one axis from which it is not mixed. Our choice: motion at 18° to the axis.
const PURE_LEAST: f64 = 0.9;
/// Share that the best vectors of the plane must have along x and along y. Our choice: the noise of shapes is less.
const PLANE_LEAST: f64 = 0.95;

/// The modes with mixed pairs replaced by their motion along x and along y; all others unchanged.
///
/// ```text
/// v_x = argmax ‖P_x v‖²,  v_y = argmax ‖P_y v‖²  over unit vectors v of span{φ_1, φ_2}
/// ```
/// Any combination of two modes of one frequency is a mode as well, so a record determines their plane and not the two shapes. Each vector takes
/// the frequency of the mode that it resembles more, and the distance to the other frequency widens its deviation: σ² + w (f_2 − f_1)², w the
/// share of the other mode.
///
/// # Limits
/// Pairs up to 3 % apart, whose plane has motion along x alone and along y alone.
pub(super) fn unmixed(modes: &Modes) -> Vec<Mode> {
    let axis_of: Vec<Option<usize>> = modes
        .channels
        .iter()
        .map(|channel| {
            let direction = channel.position_m.and(channel.direction)?;
            [0, 1]
                .into_iter()
                .find(|axis| direction[*axis].abs() >= ALONG_LEAST)
        })
        .collect();
    let mut all = modes.modes.clone();
    let mut at = 0;
    while at + 1 < all.len() {
        match apart(&all[at], &all[at + 1], &axis_of) {
            Some(pair) => {
                all[at..at + 2].clone_from_slice(&pair);
                at += 2;
            }
            None => at += 1,
        }
    }
    all
}

/// The pair along x and y, in the order of their frequencies; `None` if the two are no pair, or not mixed.
fn apart(low: &Mode, high: &Mode, axis_of: &[Option<usize>]) -> Option<[Mode; 2]> {
    let is_near = high.frequency_hz <= RATIO_MOST * low.frequency_hz;
    if !is_near || low.shape.len() != axis_of.len() || high.shape.len() != axis_of.len() {
        return None;
    }
    let pair = [unit(&real_shape(&low.shape))?, unit(&real_shape(&high.shape))?];
    let share = |shape: &[f64], axis: usize| -> f64 {
        let own = shape.iter().zip(axis_of).filter(|(_, of)| **of == Some(axis));
        own.map(|(x, _)| x * x).sum()
    };
    let is_pure = |x: usize| share(&pair[x], 0) >= PURE_LEAST && share(&pair[1 - x], 1) >= PURE_LEAST;
    if is_pure(0) || is_pure(1) {
        return None;
    }
    let across = dot(&pair[0], &pair[1]);
    let rest: Vec<f64> = pair[1]
        .iter()
        .zip(&pair[0])
        .map(|(b, a)| b - across * a)
        .collect();
    let basis = [pair[0].clone(), unit(&rest)?];
    let along = [0, 1].map(|axis| largest(&basis, axis_of, axis));
    if [0, 1]
        .into_iter()
        .any(|axis| share(&along[axis], axis) < PLANE_LEAST)
    {
        return None;
    }
    let overlap = |axis: usize, mode: usize| dot(&along[axis], &pair[mode]).powi(2);
    let x_first = overlap(0, 0) + overlap(1, 1) >= overlap(0, 1) + overlap(1, 0);
    let order = if x_first { [0, 1] } else { [1, 0] };
    let distance_hz = high.frequency_hz - low.frequency_hz;
    let made = |mode: usize| {
        let (own, axis) = ([low, high][mode], order[mode]);
        let [mine, other] = [overlap(axis, mode), overlap(axis, 1 - mode)];
        let other = other / (mine + other);
        let sd_hz = own.frequency_sd_hz.unwrap_or(0.0);
        let sds = [&low.shape_sd, &high.shape_sd].map(|sd| sd.as_deref());
        let mixed = |of: [&[f64]; 2]| -> Vec<f64> {
            let each = of[mode].iter().zip(of[1 - mode]);
            each.map(|(a, b)| ((1.0 - other) * a * a + other * b * b).sqrt())
                .collect()
        };
        Mode {
            frequency_sd_hz: Some((sd_hz * sd_hz + other * distance_hz * distance_hz).sqrt()),
            shape: along[axis].iter().map(|x| Complex64::new(*x, 0.0)).collect(),
            shape_sd: match sds {
                [Some(low), Some(high)] => Some(mixed([low, high])),
                [_, _] => None,
            },
            ..own.clone()
        }
    };
    Some([made(0), made(1)])
}

/// The unit vector of the plane with the largest share along an axis: the larger principal axis of a symmetric 2×2 matrix.
fn largest(basis: &[Vec<f64>; 2], axis_of: &[Option<usize>], axis: usize) -> Vec<f64> {
    let product = |a: usize, b: usize| -> f64 {
        let each = basis[a].iter().zip(&basis[b]).zip(axis_of);
        each.filter(|(_, of)| **of == Some(axis))
            .map(|((x, y), _)| x * y)
            .sum()
    };
    let angle = 0.5 * (2.0 * product(0, 1)).atan2(product(0, 0) - product(1, 1));
    let (sin, cos) = angle.sin_cos();
    basis[0]
        .iter()
        .zip(&basis[1])
        .map(|(a, b)| cos * a + sin * b)
        .collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The vector with length 1; `None` for a vector of rounding alone.
fn unit(of: &[f64]) -> Option<Vec<f64>> {
    let length = dot(of, of).sqrt();
    (length > 1e-6).then(|| of.iter().map(|x| x / length).collect())
}
