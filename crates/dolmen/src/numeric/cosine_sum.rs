//! Sums of cosines at equal steps, by an inverse Fourier transform.

use dolmen_linalg::Complex64;
use realfft::{ComplexToReal, RealFftPlanner};
use std::sync::Arc;

/// x_m = Σ_k Re[c_k e^(2πi k m/N)] for m below N.
pub(crate) struct CosineSum {
    transform: Arc<dyn ComplexToReal<f64>>,
    samples: usize,
}

impl CosineSum {
    /// Prepares sums of N samples per period.
    pub(crate) fn new(samples: usize) -> Self {
        CosineSum {
            transform: RealFftPlanner::<f64>::new().plan_fft_inverse(samples),
            samples,
        }
    }

    /// The first `kept` samples of the sum with these amplitudes. The first amplitude has frequency 0; there must be fewer than N/2. `None` if the
    /// transform fails.
    pub(crate) fn first(&self, amplitudes: &[Complex64], kept: usize) -> Option<Vec<f64>> {
        let mut spectrum = self.transform.make_input_vec();
        for (line, (to, c)) in spectrum.iter_mut().zip(amplitudes).enumerate() {
            *to = match line {
                0 => Complex64::new(c.re, 0.0),
                _ => c.scale(0.5),
            };
        }
        let mut values = self.transform.make_output_vec();
        self.transform.process(&mut spectrum, &mut values).ok()?;
        values.truncate(kept.min(self.samples));
        Some(values)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn exact_three_cosines() {
        let amplitudes = [(0.5, 0.0), (1.0, -2.0), (0.0, 0.0), (0.3, 0.7)];
        let lines = amplitudes.map(|(re, im)| Complex64::new(re, im));
        let found = CosineSum::new(20).first(&lines, 15).unwrap();
        assert_eq!(found.len(), 15);
        for (m, x) in found.iter().enumerate() {
            let turn = |k: usize| TAU * (k * m) as f64 / 20.0;
            let each = amplitudes.iter().enumerate();
            let sum: f64 = each
                .map(|(k, (re, im))| re * turn(k).cos() - im * turn(k).sin())
                .sum();
            assert!((x - sum).abs() < 1e-14, "{m}: {x} {sum}");
        }
    }
}
