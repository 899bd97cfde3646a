//! Response of each channel to the inputs, line by line: frequency response functions and coherence.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | S_xx, S_yx | `of_inputs`, `across` | cross spectral densities of the inputs, and between an output and the inputs |
//! | v_k, λ_k | `vectors`, `values` | eigenvectors and eigenvalues of S_xx |

use crate::modal::ModalError;
use crate::signal::{CrossSpectra, Record, Welch, cross_spectra};
use dolmen_linalg::{Complex64, ComplexMatrix, hermitian_eigen};

/// Fraction of the largest eigenvalue of S_xx below which an eigenvalue is rounding.
const ROUNDING: f64 = 1e-9;

/// Responses of all channels except the inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct FrequencyResponses {
    /// Frequency of each line, Hz, from 0.
    pub frequency_hz: Vec<f64>,
    /// Number of averaged segments. Unrelated channels have a mean coherence of inputs over segments.
    pub segments: usize,
    /// Each output.
    pub outputs: Vec<FrequencyResponse>,
}

/// Response of one channel to the inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct FrequencyResponse {
    /// Name of the channel.
    pub channel: String,
    /// H₁ for each input and line: unit of the channel over that of the input.
    pub h1: Vec<Vec<Complex64>>,
    /// Multiple coherence at each line, 0 to 1.
    pub coherence: Vec<f64>,
}

/// Frequency response functions of all other channels to these inputs, and their coherence.
///
/// ```text
/// H₁ = S_yx S_xx⁻¹ = Σ_k (S_yx v_k) v_k* / λ_k,      γ² = Σ_k |S_yx v_k|²/λ_k / S_yy
/// ```
/// Noise of the output does not bias H₁; noise of the input divides H₁ by 1 + noise over input. With one input, H₂ = H₁/γ² is biased by noise of the
/// output instead: the true value is between H₁ and H₂.
///
/// # Errors
/// [`ModalError::Record`] for a segment that is longer than the record; [`ModalError::Linalg`].
///
/// # Source
/// Bendat & Piersol (2010) Random Data, 4th ed., sections 6.1 and 7.2; Welch (1967) IEEE Trans. Audio Electroacoust. 15(2):70-73.
pub fn frequency_responses(
    record: &Record,
    inputs: &[usize],
    segment_length: usize,
) -> Result<FrequencyResponses, ModalError> {
    let spectra = cross_spectra(record, &Welch { segment_length })?;
    let lines = spectra.frequency_hz.len();
    let names = record.channels().iter().enumerate();
    let outputs: Vec<usize> = names
        .clone()
        .map(|(at, _)| at)
        .filter(|at| !inputs.contains(at))
        .collect();
    let mut responses: Vec<FrequencyResponse> = outputs
        .iter()
        .map(|&at| FrequencyResponse {
            channel: record.channels()[at].name.clone(),
            h1: vec![Vec::with_capacity(lines); inputs.len()],
            coherence: Vec::with_capacity(lines),
        })
        .collect();
    for line in 0..lines {
        let of_inputs = InputsAt::of(&spectra, inputs, line)?;
        for (&at, response) in outputs.iter().zip(&mut responses) {
            let (h1, coherence) = of_inputs.followed_by(&spectra, at);
            response.h1.iter_mut().zip(h1).for_each(|(all, h)| all.push(h));
            response.coherence.push(coherence);
        }
    }
    Ok(FrequencyResponses {
        segments: spectra.segments,
        frequency_hz: spectra.frequency_hz,
        outputs: responses,
    })
}

/// S_xx at one line.
pub(super) struct InputsAt<'a> {
    inputs: &'a [usize],
    line: usize,
    values: Vec<f64>,
    vectors: ComplexMatrix,
}

impl<'a> InputsAt<'a> {
    pub(super) fn of(spectra: &CrossSpectra, inputs: &'a [usize], line: usize) -> Result<Self, ModalError> {
        let of_inputs = ComplexMatrix::from_fn(inputs.len(), inputs.len(), |i, j| {
            spectra.density(inputs[i], inputs[j], line)
        });
        let found = hermitian_eigen(&of_inputs)?;
        Ok(InputsAt {
            inputs,
            line,
            values: found.values,
            vectors: found.vectors,
        })
    }

    /// H₁ of a channel, one value per input, and its multiple coherence.
    pub(super) fn followed_by(&self, spectra: &CrossSpectra, output: usize) -> (Vec<Complex64>, f64) {
        let n = self.inputs.len();
        let across: Vec<Complex64> = self
            .inputs
            .iter()
            .map(|&input| spectra.density(output, input, self.line))
            .collect();
        let (mut h1, mut seen) = (vec![Complex64::ZERO; n], 0.0);
        for (k, value) in self.values.iter().enumerate() {
            if *value <= ROUNDING * self.values[n - 1] {
                continue;
            }
            let vector = self.vectors.column(k);
            let along: Complex64 = across.iter().zip(vector).map(|(s, v)| s * v).sum();
            seen += along.norm_sqr() / value;
            h1.iter_mut()
                .zip(vector)
                .for_each(|(h, v)| *h += along * v.conj() / value);
        }
        let power = spectra.density(output, output, self.line).re;
        let coherence = if power > 0.0 {
            (seen / power).clamp(0.0, 1.0)
        } else {
            0.0
        };
        (h1, coherence)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::MadeOnGround;
    use crate::numeric::Random;
    use crate::signal::Channel;
    use std::f64::consts::TAU;

    #[test]
    fn exact_response_of_a_frame_to_its_ground_whatever_moves_the_ground() {
        let made = MadeOnGround {
            seed: 3,
            duration_s: 1800.0,
            waves_kn: 20.0,
            quake_s: None,
            wind_kn: 0.0,
            noise: 0.0,
        };
        let found = frequency_responses(&made.make().unwrap(), &[0], 8192).unwrap();
        assert_eq!(found.outputs[1].channel, "roof");
        for (line, hz) in found.frequency_hz.iter().enumerate() {
            if !(0.5..11.0).contains(hz) {
                continue;
            }
            for (output, exact) in found.outputs.iter().zip(MadeOnGround::response(*hz)) {
                let off = (output.h1[0][line] - exact).norm() / (1.0 + exact.norm());
                assert!(off < 0.04, "{hz} Hz: {} for {exact}", output.h1[0][line]);
                assert!(
                    output.coherence[line] > 0.97,
                    "{hz} Hz: {}",
                    output.coherence[line]
                );
            }
        }
    }

    #[test]
    fn exact_coherence_under_known_noise_and_two_inputs_told_apart() {
        // y_t = 0.8 y_(t−1) + a_t + 0.5 b_(t−1), and noise of variance 4: γ² = S/(S + 4), S = (1 + 0.25)/|1 − 0.8 z⁻¹|²
        let mut random = Random::new(17, 0);
        let n = 200_000;
        let mut white = |size: f64| -> Vec<f64> { (0..n).map(|_| size * random.normal()).collect() };
        let (a, b, noise) = (white(1.0), white(1.0), white(2.0));
        let mut y = vec![0.0; n];
        for t in 1..n {
            y[t] = 0.8 * y[t - 1] + a[t] + 0.5 * b[t - 1];
        }
        let noisy = y.iter().zip(&noise).map(|(y, e)| y + e).collect();
        let channels = ["a", "b", "y"].map(Channel::named).to_vec();
        let record = Record::new(channels, vec![a, b, noisy], 100.0).unwrap();
        let found = frequency_responses(&record, &[0, 1], 512).unwrap();
        let (mut worst, mut sum, mut count) = (0.0_f64, 0.0, 0.0);
        for (line, hz) in found.frequency_hz.iter().enumerate() {
            if !(0.5..49.5).contains(hz) {
                continue;
            }
            let delay = Complex64::from_polar(1.0, -TAU * hz / 100.0);
            let h = (Complex64::ONE - 0.8 * delay).inv();
            let exact = [h, 0.5 * delay * h];
            let response = &found.outputs[0];
            for (input, exact) in exact.iter().enumerate() {
                // its deviation is √((1 − γ²) S_yy/(n S_xx)) (Bendat and Piersol 2010, section 9.2)
                let sd = ((1.25 * h.norm_sqr() + 4.0) / found.segments as f64).sqrt();
                let off = (response.h1[input][line] - exact).norm() / sd;
                worst = worst.max(off);
            }
            let signal = 1.25 * h.norm_sqr();
            sum += response.coherence[line] - signal / (signal + 4.0);
            count += 1.0;
        }
        assert!(worst < 4.5, "{worst}");
        // the mean of 250 lines, each biased by at most inputs over segments
        let bias = 2.0 / found.segments as f64;
        assert!((sum / count).abs() < 2.0 * bias, "{} {bias}", sum / count);
    }

    #[test]
    fn refuses_a_segment_longer_than_the_record() {
        let channels = ["x", "y"].map(Channel::named).to_vec();
        let samples = vec![vec![0.0, 1.0, 0.5, 0.2, 0.1, 0.0, 0.3, 0.2, 0.1]; 2];
        let record = Record::new(channels, samples, 1.0).unwrap();
        assert!(frequency_responses(&record, &[0], 100).is_err());
    }
}
