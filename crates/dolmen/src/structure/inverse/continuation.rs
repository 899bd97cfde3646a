//! All complex solutions of det(diag(k) + H − λ_j W) = 0, j = 1…n, by continuation from a diagonal problem with known
//! solutions.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | H, W | `h`, `w` | stiffness without the unknown springs, and mass; symmetric, W positive definite |
//! | S_j(t) | | λ_j W − H with its off-diagonal entries multiplied by t |
//! | A_j | `a` | diag(k) − S_j(t) |
//! | s | `s` | parameter of the path, 0 to 1 |
//!
//! At t = 0 the matrices are diagonal, and every assignment of frequencies to springs, k_i = S_j(i),ii, is a solution:
//! there are n! solutions. Then t moves from 0 to 1 on an arc in the complex plane. On this arc no solutions meet
//! (except on a set of measure zero) and none goes to infinity, so the paths end at the n! solutions of the problem.

use dolmen_linalg::{Complex64, Matrix};

/// The matrices and the frequencies of the problem.
pub(crate) struct Pencil {
    pub(crate) h: Matrix,
    pub(crate) w: Matrix,
    pub(crate) lambda: Vec<f64>,
}

/// Result of the continuation.
pub(crate) struct AllSolutions {
    /// Distinct solutions.
    pub(crate) solutions: Vec<Vec<Complex64>>,
    /// Number of solutions counted with multiplicity: n!.
    pub(crate) expected: usize,
}

/// Heights of the arc of t above the real axis, in the order of the attempts. Any heights are possible; unrelated
/// numbers avoid meeting the same special case twice.
const ARCS: [f64; 4] = [0.618, -0.377, 1.173, -0.845];
/// Longest step along the path, which is also the first; and its factor for each further arc.
const STEP_MOST: f64 = 0.1;
const CAUTION: f64 = 0.3;
/// Step below which a path is lost: two solutions meet there, and then differ by the square root of this.
const STEP_LEAST: f64 = 1e-12;
/// Number of steps after which a path is lost. 10 to 60 are usual; frequencies within 0.1 % of each other need more.
const STEPS_MOST: usize = 500;
/// Largest relative error before the corrector, largest relative error after it, and its number of Newton iterations.
const CORRECTION_MOST: f64 = 0.05;
const CORRECTED: f64 = 1e-9;
const CORRECTIONS: usize = 3;
/// Number of Newton iterations at the end of a path, enough to converge to rounding.
const FINISHING: usize = 12;
/// Replaces a smaller pivot, relative to the largest entry: far below rounding, far above underflow.
const PIVOT_LEAST: f64 = 1e-40;
/// Two solutions are the same if they differ by less than this (relative).
const SAME: f64 = 1e-7;

/// All distinct complex solutions.
pub(crate) fn continue_all(pencil: &Pencil) -> AllSolutions {
    let starts = permutations(pencil.lambda.len());
    let expected = starts.len();
    let mut solutions: Vec<Vec<Complex64>> = Vec::new();
    let mut step_most = STEP_MOST;
    for arc in ARCS {
        for start in &starts {
            let Some(end) = follow(pencil, start, arc, step_most) else {
                continue;
            };
            if !solutions.iter().any(|known| distance(known, &end) < SAME) {
                solutions.push(end);
            }
        }
        if solutions.len() >= expected || solutions.is_empty() {
            break;
        }
        step_most *= CAUTION;
    }
    AllSolutions { solutions, expected }
}

fn permutations(n: usize) -> Vec<Vec<usize>> {
    let mut all = vec![Vec::new()];
    for item in 0..n {
        let mut longer = Vec::with_capacity(all.len() * (item + 1));
        for order in &all {
            for place in 0..=order.len() {
                let mut order: Vec<usize> = order.clone();
                order.insert(place, item);
                longer.push(order);
            }
        }
        all = longer;
    }
    all
}

/// Largest relative difference of any unknown.
fn distance(a: &[Complex64], b: &[Complex64]) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |most, (a, b)| {
        most.max((a - b).norm() / a.norm().max(b.norm()))
    })
}

/// Follows one path to its end; `None` if the path is lost.
fn follow(pencil: &Pencil, start: &[usize], arc: f64, step_most: f64) -> Option<Vec<Complex64>> {
    let t = |s: f64| Complex64::new(s, arc * s * (1.0 - s));
    let dt = |s: f64| Complex64::new(1.0, arc * (1.0 - 2.0 * s));
    let on_diagonal = |(i, &j): (usize, &usize)| pencil.lambda[j] * pencil.w[(i, i)] - pencil.h[(i, i)];
    let mut k: Vec<Complex64> = start.iter().enumerate().map(|x| on_diagonal(x).into()).collect();
    let (mut s, mut step) = (0.0, step_most);
    for _ in 0..STEPS_MOST {
        if s >= 1.0 {
            break;
        }
        let next = if s + step > 1.0 - STEP_LEAST {
            1.0
        } else {
            s + step
        };
        // predictor: midpoint rule along the tangent
        let half = 0.5 * (next - s);
        let predicted = tangent(pencil, &k, t(s), dt(s)).and_then(|slope| {
            let middle = advanced(&k, &slope, half);
            let slope = tangent(pencil, &middle, t(s + half), dt(s + half))?;
            Some(advanced(&k, &slope, 2.0 * half))
        });
        match predicted.and_then(|start| corrected(pencil, start, t(next))) {
            Some(corrected) => {
                k = corrected;
                s = next;
                step = (1.5 * step).min(step_most);
            }
            None => {
                step *= 0.5;
                if step < STEP_LEAST {
                    return None;
                }
            }
        }
    }
    if s < 1.0 {
        return None;
    }
    for _ in 0..FINISHING {
        let Some(change) = newton_step(pencil, &k, Complex64::ONE) else {
            break; // singular to working precision: already at the solution
        };
        k = advanced(&k, &change, 1.0);
    }
    k.iter().all(|k| k.is_finite()).then_some(k)
}

fn advanced(k: &[Complex64], slope: &[Complex64], by: f64) -> Vec<Complex64> {
    k.iter().zip(slope).map(|(k, d)| k + d * by).collect()
}

/// A few Newton iterations at fixed t; `None` if the start is too far away or they do not converge.
fn corrected(pencil: &Pencil, start: Vec<Complex64>, t: Complex64) -> Option<Vec<Complex64>> {
    let mut k = start;
    for iteration in 0..CORRECTIONS {
        let change = newton_step(pencil, &k, t)?;
        let size = change
            .iter()
            .zip(&k)
            .fold(0.0_f64, |most, (d, k)| most.max(d.norm() / k.norm()));
        if iteration == 0 && (size.is_nan() || size > CORRECTION_MOST) {
            return None;
        }
        k = advanced(&k, &change, 1.0);
        if size < CORRECTED {
            return Some(k);
        }
    }
    None
}

/// Newton step: the dk that makes every det A_j zero to first order, Σ_i (A_j⁻¹)_ii dk_i = −1.
fn newton_step(pencil: &Pencil, k: &[Complex64], t: Complex64) -> Option<Vec<Complex64>> {
    linearised(pencil, k, t, |_, _| Complex64::ONE)
}

/// dk/ds on the path: Σ_i (A_j⁻¹)_ii dk_i = −tr(A_j⁻¹ dA_j/dt) dt/ds.
fn tangent(pencil: &Pencil, k: &[Complex64], t: Complex64, dt: Complex64) -> Option<Vec<Complex64>> {
    linearised(pencil, k, t, |inverse, lambda| {
        let n = k.len();
        let mut trace = Complex64::ZERO;
        for row in 0..n {
            for column in (0..n).filter(|&column| column != row) {
                trace +=
                    inverse[column * n + row] * (pencil.h[(row, column)] - lambda * pencil.w[(row, column)]);
            }
        }
        trace * dt
    })
}

/// Solves Σ_i (A_j⁻¹)_ii x_i = −right_j, each row scaled: det A_j itself is never formed.
fn linearised(
    pencil: &Pencil,
    k: &[Complex64],
    t: Complex64,
    right: impl Fn(&[Complex64], f64) -> Complex64,
) -> Option<Vec<Complex64>> {
    let n = k.len();
    let mut rows = Vec::with_capacity(n * (n + 1));
    for &lambda in &pencil.lambda {
        let mut a = Vec::with_capacity(n * 2 * n);
        for (row, k) in k.iter().enumerate() {
            for column in 0..n {
                let s = lambda * pencil.w[(row, column)] - pencil.h[(row, column)];
                a.push(if row == column { k - s } else { -s * t });
            }
            a.extend((0..n).map(|column| Complex64::from(if row == column { 1.0 } else { 0.0 })));
        }
        let largest = a.iter().fold(0.0_f64, |most, a| most.max(a.norm()));
        let inverse = eliminated(a, n, n, largest * PIVOT_LEAST);
        let scale = (0..n).fold(0.0_f64, |most, i| most.max(inverse[i * n + i].norm()));
        rows.extend((0..n).map(|i| inverse[i * n + i] / scale));
        rows.push(-right(&inverse, lambda) / scale);
    }
    let x = eliminated(rows, n, 1, PIVOT_LEAST);
    x.iter().all(|x| x.is_finite()).then_some(x)
}

/// X of A X = B from the rows of [A B], by Gauss–Jordan elimination with partial pivoting, row by row. A pivot below
/// `pivot_least` is replaced by that value: a singular A then has an inverse with the right direction and a huge size.
fn eliminated(mut rows: Vec<Complex64>, n: usize, right: usize, pivot_least: f64) -> Vec<Complex64> {
    let width = n + right;
    for pivot in 0..n {
        let mut best = pivot;
        for row in pivot + 1..n {
            if rows[row * width + pivot].norm_sqr() > rows[best * width + pivot].norm_sqr() {
                best = row;
            }
        }
        for column in 0..width {
            rows.swap(pivot * width + column, best * width + column);
        }
        let divisor = rows[pivot * width + pivot];
        let divisor = if divisor.norm() < pivot_least {
            pivot_least.into()
        } else {
            divisor
        };
        let inverse = divisor.inv();
        for column in pivot..width {
            rows[pivot * width + column] *= inverse;
        }
        for row in (0..n).filter(|&row| row != pivot) {
            let factor = rows[row * width + pivot];
            for column in pivot..width {
                let product = factor * rows[pivot * width + column];
                rows[row * width + column] -= product;
            }
        }
    }
    let kept = (0..n).flat_map(|row| row * width + n..(row + 1) * width);
    kept.map(|at| rows[at]).collect()
}
