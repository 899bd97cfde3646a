//! Minimises the maximum of several smooth functions.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | f_k, g_k | `Piece` | value and gradient of one function (n entries) |
//! | B | `curvature` | n × n, curvature of Σ λ_k f_k, estimated from changes of the gradients |
//! | λ | `weights` | weight of each function, λ ≥ 0, Σ λ = 1; positive for the functions that are active at the optimum |
//! | d | `step` | minimum of max_k (f_k + g_k·d) + ½ dᵀBd |

/// One of the functions at one point.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) value: f64,
    pub(crate) slope: Vec<f64>,
}

/// The functions whose maximum is minimised. Functions and relevant changes of x should be of order 1, for example logarithms of positive
/// quantities.
pub(crate) trait Worst {
    /// The largest of the functions; `None` if there is no value.
    fn worst(&mut self, x: &[f64]) -> Option<f64>;
    /// The functions that are, or may become, the largest near x, in an order that does not depend on x.
    fn pieces(&mut self, x: &[f64]) -> Option<Vec<Piece>>;
}

/// Parameters of the search.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Minimax {
    pub(crate) iterations_most: usize,
    /// Length of a step below which the search ends; at best 1e-10, the rounding of gradients by differences.
    pub(crate) step_least: f64,
    /// B of a search that ended nearby, as a start.
    pub(crate) curvature: Option<Vec<Vec<f64>>>,
}

impl Minimax {
    pub(crate) fn steps(iterations_most: usize) -> Self {
        Minimax {
            iterations_most,
            step_least: 1e-10,
            curvature: None,
        }
    }
}

/// The end of the search.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MinimaxPoint {
    pub(crate) x: Vec<f64>,
    pub(crate) worst: f64,
    pub(crate) iterations: usize,
    /// Largest entry of the last trial step.
    pub(crate) last_step: f64,
    pub(crate) curvature: Vec<Vec<f64>>,
}

/// Longest step of one unknown; unknowns are logarithms, so this is a factor of 1.6.
const STEP_MOST: f64 = 0.5;
/// Fraction of the predicted decrease that a step must achieve (Nocedal and Wright 2006, sec. 3.1).
const DECREASE_LEAST: f64 = 1e-4;
/// Largest number of halvings of a step.
const HALVINGS: usize = 25;
/// Damping of the update of B (Powell 1978).
const POWELL: f64 = 0.2;

/// A local minimum of max_k f_k(x) from the start point; `None` if the start is refused.
///
/// Sequential quadratic programming: each step solves the piecewise linear model with curvature B. If it brings no decrease, it is corrected once
/// for the curvature of the functions, and then halved.
///
/// # Source
/// Han, S.-P. (1981) J. Optim. Theory Appl. 35:199-210 for the model and its step; Powell (1978) for B; the correction is that of Fletcher (1982).
pub(crate) fn minimax(start: Vec<f64>, options: &Minimax, problem: &mut impl Worst) -> Option<MinimaxPoint> {
    let n = start.len();
    let mut x = start;
    let mut worst = problem.worst(&x)?;
    let mut pieces = problem.pieces(&x)?;
    let mut fresh = options.curvature.is_none();
    let mut curvature = options.curvature.clone().unwrap_or_else(|| identity(n));
    let mut last_step = f64::INFINITY;
    let mut iterations = 0;
    while iterations < options.iterations_most {
        iterations += 1;
        let values: Vec<f64> = pieces.iter().map(|piece| piece.value).collect();
        let Some(Direction { step, weights }) = direction(&values, &pieces, &curvature) else {
            break;
        };
        last_step = largest(&step);
        let predicted = model(&values, &pieces, &curvature, &step) - worst;
        if last_step <= options.step_least {
            break;
        }
        let moved = (predicted < 0.0)
            .then(|| search(problem, (&x, worst), &pieces, &curvature, (&step, predicted)))
            .flatten();
        let Some((next, value)) = moved else {
            if fresh {
                break;
            }
            (curvature, fresh) = (identity(n), true);
            continue;
        };
        let Some(after) = problem.pieces(&next) else {
            break;
        };
        if after.len() == pieces.len() {
            let s: Vec<f64> = (0..n).map(|i| next[i] - x[i]).collect();
            let change = |i: usize| -> f64 {
                let each = weights.iter().zip(pieces.iter().zip(&after));
                each.map(|(w, (before, after))| w * (after.slope[i] - before.slope[i]))
                    .sum()
            };
            let y: Vec<f64> = (0..n).map(change).collect();
            learn(&mut curvature, &s, &y, fresh);
            fresh = false;
        }
        (x, worst, pieces) = (next, value, after);
    }
    Some(MinimaxPoint {
        x,
        worst,
        iterations,
        last_step,
        curvature,
    })
}

/// A function value and its gradient by central differences, h = 1e-5. Their error is h² times the third derivative, and 1e-11 of rounding.
pub(crate) fn by_differences(x: &[f64], mut value: impl FnMut(&[f64]) -> Option<f64>) -> Option<Piece> {
    all_by_differences(x, |x| Some(vec![value(x)?]))?.pop()
}

/// Derivatives by differences, for functions that are computed together.
fn all_by_differences(x: &[f64], mut values: impl FnMut(&[f64]) -> Option<Vec<f64>>) -> Option<Vec<Piece>> {
    const H: f64 = 1e-5;
    let piece = |value| Piece {
        value,
        slope: Vec::with_capacity(x.len()),
    };
    let mut pieces: Vec<Piece> = values(x)?.into_iter().map(piece).collect();
    let mut moved = x.to_vec();
    for i in 0..x.len() {
        moved[i] = x[i] + H;
        let above = values(&moved)?;
        moved[i] = x[i] - H;
        let below = values(&moved)?;
        moved[i] = x[i];
        for (piece, (a, b)) in pieces.iter_mut().zip(above.iter().zip(&below)) {
            piece.slope.push((a - b) / (2.0 * H));
        }
    }
    Some(pieces)
}

fn identity(n: usize) -> Vec<Vec<f64>> {
    (0..n)
        .map(|i| (0..n).map(|j| if i == j { 1.0 } else { 0.0 }).collect())
        .collect()
}

fn largest(step: &[f64]) -> f64 {
    step.iter().fold(0.0_f64, |most, d| most.max(d.abs()))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn model(values: &[f64], pieces: &[Piece], curvature: &[Vec<f64>], step: &[f64]) -> f64 {
    let linear = values
        .iter()
        .zip(pieces)
        .map(|(f, piece)| f + dot(&piece.slope, step));
    let quadratic: f64 = curvature
        .iter()
        .zip(step)
        .map(|(row, d)| d * dot(row, step))
        .sum();
    linear.fold(f64::NEG_INFINITY, f64::max) + 0.5 * quadratic
}

/// The full step, its correction, or a fraction of it: the first that brings a decrease.
fn search(
    problem: &mut impl Worst,
    (x, worst): (&[f64], f64),
    pieces: &[Piece],
    curvature: &[Vec<f64>],
    (step, predicted): (&[f64], f64),
) -> Option<(Vec<f64>, f64)> {
    let mut part = (STEP_MOST / largest(step)).min(1.0);
    let whole = part >= 1.0;
    for halving in 0..HALVINGS {
        let next: Vec<f64> = x.iter().zip(step).map(|(x, d)| x + part * d).collect();
        let value = problem.worst(&next);
        if let Some(value) = value.filter(|value| *value <= worst + DECREASE_LEAST * part * predicted) {
            return Some((next, value));
        }
        if halving == 0
            && whole
            && pieces.len() > 1
            && let Some(there) = problem.pieces(&next)
            && there.len() == pieces.len()
        {
            let each = there.iter().zip(pieces);
            let corrected: Vec<f64> = each.map(|(t, p)| t.value - dot(&p.slope, step)).collect();
            if let Some(second) = direction(&corrected, pieces, curvature) {
                let next: Vec<f64> = x.iter().zip(&second.step).map(|(x, d)| x + d).collect();
                let near = largest(&second.step) <= 2.0 * largest(step);
                let value = problem.worst(&next).filter(|_| near);
                if let Some(value) = value.filter(|value| *value <= worst + DECREASE_LEAST * predicted) {
                    return Some((next, value));
                }
            }
        }
        part *= 0.5;
    }
    None
}

struct Direction {
    step: Vec<f64>,
    weights: Vec<f64>,
}

/// The minimum over d of max_k (f_k + g_k·d) + ½ dᵀBd, by its dual: λ in the simplex that maximises Σ λ f − ½ ‖Σ λ g‖²_B⁻¹, with an active set.
fn direction(values: &[f64], pieces: &[Piece], curvature: &[Vec<f64>]) -> Option<Direction> {
    let m = values.len();
    let solved: Vec<Vec<f64>> = pieces
        .iter()
        .map(|piece| gauss(curvature.to_vec(), piece.slope.clone()))
        .collect::<Option<_>>()?; // B⁻¹ g
    let gram = |i: usize, j: usize| dot(&pieces[i].slope, &solved[j]);
    let first = (0..m).reduce(|best, k| if values[k] > values[best] { k } else { best })?;
    let mut active = vec![first];
    let mut weights = vec![0.0; m];
    weights[first] = 1.0;
    for _ in 0..10 * m + 10 {
        // stationary weights of the active set: Gram λ + t = f, Σ λ = 1
        let p = active.len();
        let ridge = 1e-14
            * active
                .iter()
                .map(|&k| gram(k, k))
                .fold(f64::MIN_POSITIVE, f64::max);
        let mut a = vec![vec![1.0; p + 1]; p + 1];
        let mut b: Vec<f64> = active.iter().map(|&k| values[k]).collect();
        for (i, &ki) in active.iter().enumerate() {
            for (j, &kj) in active.iter().enumerate() {
                a[i][j] = gram(ki, kj) + if i == j { ridge } else { 0.0 };
            }
        }
        a[p][p] = 0.0;
        b.push(1.0);
        let stationary = gauss(a, b)?;
        let level = stationary[p];
        // move there, or as far as all weights stay positive
        let mut part = 1.0;
        let mut leaving = None;
        for (i, &k) in active.iter().enumerate() {
            if stationary[i] < 0.0 {
                let reach = weights[k] / (weights[k] - stationary[i]);
                if reach < part {
                    (part, leaving) = (reach, Some(i));
                }
            }
        }
        for (i, &k) in active.iter().enumerate() {
            weights[k] += part * (stationary[i] - weights[k]);
        }
        if let Some(i) = leaving {
            weights[active[i]] = 0.0;
            active.remove(i);
            continue;
        }
        let rise =
            |k: usize| values[k] - active.iter().map(|&j| weights[j] * gram(k, j)).sum::<f64>() - level;
        let scale = values
            .iter()
            .fold(1e-300_f64, |most, f| most.max(f.abs()))
            .max(level.abs());
        let entering = (0..m)
            .filter(|k| !active.contains(k))
            .map(|k| (k, rise(k)))
            .filter(|(_, rise)| *rise > 1e-14 * scale)
            .reduce(|best, next| if next.1 > best.1 { next } else { best });
        match entering {
            Some((k, _)) => active.push(k),
            None => break,
        }
    }
    let n = curvature.len();
    let step = (0..n)
        .map(|i| -(0..m).map(|k| weights[k] * solved[k][i]).sum::<f64>())
        .collect();
    Some(Direction { step, weights })
}

/// Solves A x = b by elimination with row pivoting; `None` if A is singular.
fn gauss(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Option<Vec<f64>> {
    let n = b.len();
    for j in 0..n {
        let pivot = (j..n).reduce(|best, i| if a[i][j].abs() > a[best][j].abs() { i } else { best })?;
        a.swap(j, pivot);
        b.swap(j, pivot);
        if a[j][j] == 0.0 || !a[j][j].is_finite() {
            return None;
        }
        for i in j + 1..n {
            let factor = a[i][j] / a[j][j];
            let (above, below) = a.split_at_mut(i);
            for (target, source) in below[0][j..].iter_mut().zip(&above[j][j..]) {
                *target -= factor * source;
            }
            b[i] -= factor * b[j];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = dot(&a[i][i + 1..], &b[i + 1..]);
        b[i] = (b[i] - known) / a[i][i];
    }
    Some(b)
}

/// Updates B from a step s and the change y of the weighted gradient, damped so that B stays positive definite.
fn learn(curvature: &mut [Vec<f64>], s: &[f64], y: &[f64], fresh: bool) {
    let n = s.len();
    let (sy, ss) = (dot(s, y), dot(s, s));
    if fresh && sy > 0.0 {
        let scale = dot(y, y) / sy; // Nocedal and Wright 2006, eq. 6.20
        for (i, row) in curvature.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = if i == j { scale } else { 0.0 };
            }
        }
    }
    let bs: Vec<f64> = curvature.iter().map(|row| dot(row, s)).collect();
    let sbs = dot(s, &bs);
    if sbs <= 1e-300 || ss == 0.0 {
        return;
    }
    let theta = if sy >= POWELL * sbs {
        1.0
    } else {
        (1.0 - POWELL) * sbs / (sbs - sy)
    };
    let r: Vec<f64> = (0..n).map(|i| theta * y[i] + (1.0 - theta) * bs[i]).collect();
    let sr = dot(s, &r);
    for i in 0..n {
        for j in 0..n {
            curvature[i][j] += r[i] * r[j] / sr - bs[i] * bs[j] / sbs;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Functions<F: Fn(&[f64]) -> Vec<f64>>(F);

    impl<F: Fn(&[f64]) -> Vec<f64>> Worst for Functions<F> {
        fn worst(&mut self, x: &[f64]) -> Option<f64> {
            (self.0)(x).into_iter().reduce(f64::max)
        }
        fn pieces(&mut self, x: &[f64]) -> Option<Vec<Piece>> {
            let count = (self.0)(x).len();
            (0..count)
                .map(|k| by_differences(x, |x| Some((self.0)(x)[k])))
                .collect()
        }
    }

    #[test]
    fn exact_a_smooth_valley() {
        let rosenbrock = |x: &[f64]| vec![100.0 * (x[1] - x[0] * x[0]).powi(2) + (1.0 - x[0]).powi(2)];
        let least = minimax(vec![-1.2, 1.0], &Minimax::steps(200), &mut Functions(rosenbrock)).unwrap();
        assert!(
            (least.x[0] - 1.0).abs() < 1e-7 && (least.x[1] - 1.0).abs() < 1e-7,
            "{least:?}"
        );
    }

    #[test]
    fn published_charalambous_and_conn_1978() {
        // two problems of Charalambous & Conn (1978) SIAM J. Numer. Anal. 15(1), CB2 and CB3
        let cb2 = |x: &[f64]| {
            vec![
                x[0] * x[0] + x[1].powi(4),
                (2.0 - x[0]).powi(2) + (2.0 - x[1]).powi(2),
                2.0 * (x[1] - x[0]).exp(),
            ]
        };
        let least = minimax(vec![1.0, -0.1], &Minimax::steps(100), &mut Functions(cb2)).unwrap();
        assert!((least.worst - 1.952_224_494_3).abs() < 1e-9, "{least:?}");
        let cb3 = |x: &[f64]| {
            vec![
                x[0].powi(4) + x[1] * x[1],
                (2.0 - x[0]).powi(2) + (2.0 - x[1]).powi(2),
                2.0 * (x[1] - x[0]).exp(),
            ]
        };
        let least = minimax(vec![2.0, 2.0], &Minimax::steps(100), &mut Functions(cb3)).unwrap();
        assert!((least.worst - 2.0).abs() < 1e-9, "{least:?}");
    }
}
