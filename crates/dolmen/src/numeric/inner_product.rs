//! Sums of products of long rows of numbers.

/// Inner product Σ a b, in lanes that the processor adds together.
pub(crate) fn inner(a: &[f64], b: &[f64]) -> f64 {
    const LANES: usize = 8;
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
