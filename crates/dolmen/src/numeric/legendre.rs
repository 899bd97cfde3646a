//! Legendre polynomials P_k, their integrals, and Gauss-Legendre quadrature.

/// P_k on [−1, 1].
pub(crate) fn legendre(k: usize, x: f64) -> f64 {
    let (mut now, mut next) = (1.0, x);
    for i in 1..=k {
        let i = i as f64;
        (now, next) = (next, ((2.0 * i + 1.0) * x * next - i * now) / (i + 1.0));
    }
    now
}

/// Integral of P_k from −1 to x.
pub(crate) fn integral(k: usize, x: f64) -> f64 {
    match k {
        0 => x + 1.0,
        k => (legendre(k + 1, x) - legendre(k - 1, x)) / (2 * k + 1) as f64,
    }
}

pub(crate) fn second_integral(k: usize, x: f64) -> f64 {
    match k {
        0 => 0.5 * (x + 1.0) * (x + 1.0),
        k => (integral(k + 1, x) - integral(k - 1, x)) / (2 * k + 1) as f64,
    }
}

/// Nodes and weights of Gauss-Legendre quadrature on [−1, 1]: roots of P_n by Newton's method.
pub(crate) fn gauss_legendre(n: usize) -> Vec<(f64, f64)> {
    const STEPS: usize = 30;
    let degree = n as f64;
    let slope = |x: f64| degree * (x * legendre(n, x) - legendre(n - 1, x)) / (x * x - 1.0);
    let root = |i: usize| {
        let mut x = -(std::f64::consts::PI * (i as f64 + 0.75) / (degree + 0.5)).cos();
        for _ in 0..STEPS {
            x -= legendre(n, x) / slope(x);
        }
        (x, 2.0 / ((1.0 - x * x) * slope(x) * slope(x)))
    };
    (0..n).map(root).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_quadrature_integrals_and_orthogonality() {
        let points = gauss_legendre(9);
        let sum = |f: &dyn Fn(f64) -> f64| points.iter().map(|(x, w)| w * f(*x)).sum::<f64>();
        for k in 0..9 {
            let square = sum(&|x| legendre(k, x) * legendre(k, x));
            assert!((square - 2.0 / (2 * k + 1) as f64).abs() < 1e-14, "{k}");
            // by parts from −1 to 1, ∫∫ P_k = ∫ (1 − x) P_k
            let twice = sum(&|x| (1.0 - x) * legendre(k, x));
            assert!((second_integral(k, 1.0) - twice).abs() < 1e-14, "{k}");
            assert!((integral(k, 1.0) - sum(&|x| legendre(k, x))).abs() < 1e-14, "{k}");
        }
        assert!((sum(&|x| x.powi(16)) - 2.0 / 17.0).abs() < 1e-14);
    }
}
