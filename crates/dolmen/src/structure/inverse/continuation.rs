//! All complex solutions of det(diag(k) + H − λ_j W) = 0, j = 1…n, by following them from a case that is solved.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | H, W | `h`, `w` | symmetric, W positive definite: stiffness without the springs sought, and mass |
//! | S_j(t) | | λ_j W − H with its entries off the diagonal times t |
//! | A_j | `a` | diag(k) − S_j(t) |
//! | s | `s` | way along the path, 0 to 1 |
//!
//! At t = 0 the matrices are diagonal: every assignment of frequencies to springs, k_i = S_j(i),ii, is a solution, n! of
//! them. As t goes to 1 on an arc through the complex plane none of them meet (except on a set of measure zero) and none
//! goes to infinity, so they become all n! solutions of the problem.

use dolmen_linalg::{Complex64, Matrix};

/// The problem.
pub(crate) struct Pencil {
    pub(crate) h: Matrix,
    pub(crate) w: Matrix,
    pub(crate) lambda: Vec<f64>,
}

/// What was found.
pub(crate) struct AllSolutions {
    /// Distinct solutions.
    pub(crate) solutions: Vec<Vec<Complex64>>,
    /// How many there are, counted with multiplicity: n!.
    pub(crate) expected: usize,
}

/// Heights of the arc that t takes beside the real axis, in order of trial; any would do, unlike numbers meet no
/// special case twice.
const ARCS: [f64; 4] = [0.618, -0.377, 1.173, -0.845];
/// First and longest step along the path, and shrinking of both for each further arc tried.
const STEP_MOST: f64 = 0.1;
const CAUTION: f64 = 0.3;
/// Step below which a path counts as lost: it ends where two solutions meet, which then differ by √ of this.
const STEP_LEAST: f64 = 1e-12;
/// Steps after which a path counts as lost; 10 to 60 are usual. Frequencies within a per mille of each other need more.
const STEPS_MOST: usize = 500;
/// A corrector must start within this of the solution, relative, and end within the next after three iterations.
const CORRECTION_MOST: f64 = 0.05;
const CORRECTED: f64 = 1e-9;
const CORRECTIONS: usize = 3;
/// Newton iterations at the end of a path, to rounding.
const FINISHING: usize = 12;
/// Pivot, relative to the largest entry, that stands in for a smaller one: far below rounding, far above underflow.
const PIVOT_LEAST: f64 = 1e-40;
/// Two solutions nearer than this, relative, are one.
const SAME: f64 = 1e-7;

/// Every distinct complex solution.
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

/// All orders of 0…n−1.
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

/// Largest difference of one unknown, relative to it.
fn distance(a: &[Complex64], b: &[Complex64]) -> f64 {
    let pairs = a.iter().zip(b);
    pairs.fold(0.0, |most, (a, b)| {
        most.max((a - b).norm() / a.norm().max(b.norm()))
    })
}

/// The end of one path; `None` if it is lost.
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
            break; // singular to working precision: it is there
        };
        k = advanced(&k, &change, 1.0);
    }
    k.iter().all(|k| k.is_finite()).then_some(k)
}

fn advanced(k: &[Complex64], slope: &[Complex64], by: f64) -> Vec<Complex64> {
    k.iter().zip(slope).map(|(k, d)| k + d * by).collect()
}

/// A few Newton iterations at fixed t; `None` unless they start close and converge.
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

/// Change of k that makes every det A_j zero to first order: Σ_i (A_j⁻¹)_ii dk_i = −1.
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
/// `pivot_least` is replaced by it: a singular A then has an inverse whose direction is right and whose size is huge.
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
