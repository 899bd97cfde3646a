//! Sums over long rows of numbers, in lanes that the processor adds together.

const LANES: usize = 8;

/// Inner product Σ a b.
pub(crate) fn inner(a: &[f64], b: &[f64]) -> f64 {
    let mut sum = [0.0; LANES];
    let (head, tail) = a.split_at(a.len() / LANES * LANES);
    for (a, b) in head.chunks_exact(LANES).zip(b.chunks_exact(LANES)) {
        for ((s, a), b) in sum.iter_mut().zip(a).zip(b) {
            *s += a * b;
        }
    }
    let rest = tail.iter().zip(&b[head.len()..]);
    sum.iter().sum::<f64>() + rest.map(|(a, b)| a * b).sum::<f64>()
}

/// Σ f(x).
#[inline(always)]
pub(crate) fn sum_of(x: &[f64], f: impl Fn(f64) -> f64) -> f64 {
    let mut sum = [0.0; LANES];
    let chunks = x.chunks_exact(LANES);
    let rest = chunks.remainder().iter();
    for chunk in chunks {
        for (s, x) in sum.iter_mut().zip(chunk) {
            *s += f(*x);
        }
    }
    sum.iter().sum::<f64>() + rest.map(|x| f(*x)).sum::<f64>()
}

/// The largest f(x), −∞ of none.
#[inline(always)]
pub(crate) fn largest_of(x: &[f64], f: impl Fn(f64) -> f64) -> f64 {
    let larger = |a: f64, b: f64| if b > a { b } else { a };
    let mut lanes = [f64::NEG_INFINITY; LANES];
    let chunks = x.chunks_exact(LANES);
    let rest = chunks.remainder().iter().map(|x| f(*x));
    for chunk in chunks {
        for (lane, x) in lanes.iter_mut().zip(chunk) {
            *lane = larger(*lane, f(*x));
        }
    }
    lanes.into_iter().chain(rest).fold(f64::NEG_INFINITY, larger)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_sums_and_extremes_of_rows_of_any_length() {
        for n in [0_usize, 1, 7, 8, 21] {
            let x: Vec<f64> = (0..n).map(|i| (i as f64 - 9.0) * 0.5).collect();
            assert_eq!(sum_of(&x, |x| x * x), x.iter().map(|x| x * x).sum::<f64>());
            assert_eq!(inner(&x, &x), sum_of(&x, |x| x * x));
            let most = x.iter().map(|x| -x).fold(f64::NEG_INFINITY, f64::max);
            assert_eq!(largest_of(&x, |x| -x), most);
        }
    }
}
