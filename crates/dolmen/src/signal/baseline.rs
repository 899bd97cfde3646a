//! Base-line correction of ground motions by polynomials or high-pass filters; the history lists each step.

use super::sections::Sections;
use super::{Component, GroundMotion, Processing, SignalError};
use dolmen_linalg::{Matrix, solve_least_squares};

/// How to correct a base line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Baseline {
    /// Subtract the least-squares polynomial from the acceleration: degree 0 is its mean, 1 a straight line; 6 is the highest.
    Polynomial {
        /// Degree of the polynomial.
        degree: usize,
    },
    /// Remove everything below a corner frequency: a zero-phase Butterworth filter, run forwards and backwards; its gain at the corner is ½.
    HighPass {
        /// Corner frequency, Hz.
        corner_hz: f64,
        /// Order of one pass, 1 to 12; 4 is usual.
        order: usize,
    },
}

/// Highest degree of a polynomial: a higher one would remove the motion itself. Our choice.
const DEGREE_MOST: usize = 6;
const ORDER_MOST: usize = 12;

impl GroundMotion {
    /// Corrects the base line in all directions of the motion.
    ///
    /// # Errors
    /// [`SignalError::Argument`] for a degree above 6, [`SignalError::FilterOrder`], [`SignalError::Corner`],
    /// [`SignalError::TooShortForFilter`] if the filter rings for longer than the motion lasts.
    ///
    /// # Limits
    /// A high-pass filter also removes permanent displacements, which are real near a fault. The ends are extended by odd reflection, as for
    /// records.
    ///
    /// # Source
    /// Boore, Bommer (2005) Soil Dyn. Earthq. Eng. 25(2):93-115. Agrees with `numpy.polyfit` and with
    /// `scipy.signal.sosfiltfilt` of the same padlen.
    ///
    /// # Example
    /// ```
    /// use dolmen::signal::{Baseline, Component, GroundMotion};
    /// let motion = GroundMotion::new("offset", 0.1, vec![(Component::X, vec![1.0, 2.0, 3.0])])?;
    /// let flat = motion.baseline_corrected(Baseline::Polynomial { degree: 1 })?;
    /// assert!(flat.peak_acceleration_m_s2() < 1e-15);
    /// # Ok::<(), dolmen::signal::SignalError>(())
    /// ```
    pub fn baseline_corrected(mut self, baseline: Baseline) -> Result<Self, SignalError> {
        let given = Component::ALL
            .into_iter()
            .filter(|component| self.has(*component));
        let components: Vec<Component> = given.collect();
        match baseline {
            Baseline::Polynomial { degree } => {
                if degree > DEGREE_MOST {
                    let allowed = "0 to 6";
                    return Err(SignalError::Argument {
                        argument: "degree",
                        given: degree as f64,
                        allowed,
                    });
                }
                for component in components {
                    without_polynomial(self.samples_mut(component), degree)?;
                }
                self.note(Processing::Detrend { degree });
            }
            Baseline::HighPass { corner_hz, order } => {
                let rate_hz = 1.0 / self.time_step_s();
                let nyquist_hz = 0.5 * rate_hz;
                if !(corner_hz > 0.0 && corner_hz < nyquist_hz) {
                    return Err(SignalError::Corner {
                        argument: "corner_hz",
                        given: corner_hz,
                        nyquist_hz,
                    });
                }
                if !(1..=ORDER_MOST).contains(&order) {
                    return Err(SignalError::FilterOrder {
                        given: order,
                        most: ORDER_MOST,
                    });
                }
                let mut filter = Sections::high_pass(order, corner_hz / rate_hz);
                if self.length() <= filter.ringing {
                    return Err(SignalError::TooShortForFilter {
                        filter: "high-pass",
                        duration_s: self.duration_s(),
                        ringing_s: filter.ringing as f64 / rate_hz,
                    });
                }
                for component in components {
                    filter.forward_backward(self.samples_mut(component));
                }
                self.note(Processing::HighPass { corner_hz, order });
            }
        }
        Ok(self)
    }
}

/// Subtracts the least-squares polynomial. The basis is Chebyshev polynomials on −1 … 1, whose columns are nearly orthogonal.
fn without_polynomial(samples: &mut [f64], degree: usize) -> Result<(), SignalError> {
    let last = (samples.len() - 1) as f64;
    let degree = degree.min(samples.len() - 1);
    let x = |i: usize| 2.0 * i as f64 / last - 1.0;
    let columns = Matrix::from_fn(samples.len(), degree + 1, |i, k| {
        (k as f64 * x(i).clamp(-1.0, 1.0).acos()).cos()
    });
    let fitted = solve_least_squares(&columns, &Matrix::from_column(samples));
    let fitted = fitted.map_err(|fault| SignalError::Match {
        why: fault.to_string(),
    })?;
    let values = columns.times(fitted.column(0));
    samples.iter_mut().zip(values).for_each(|(a, value)| *a -= value);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion(n: usize) -> GroundMotion {
        let x = (0..n).map(|i| i as f64);
        let samples = x.map(|i| {
            (0.37 * i).sin() + 0.5 * (1.1 * i + 0.3).cos() + 1e-3 * i - 2e-7 * i * i + 1e-10 * i.powi(3)
        });
        GroundMotion::new("test", 0.01, vec![(Component::X, samples.collect())]).unwrap()
    }

    // numpy 2.4.6, scipy 1.17.1: i = np.arange(2000); a = np.sin(.37*i)+.5*np.cos(1.1*i+.3)+1e-3*i-2e-7*i*i+1e-10*i**3
    const AT: [usize; 5] = [0, 1, 700, 1998, 1999];

    fn agree(corrected: &GroundMotion, wanted: [f64; 5]) {
        for (at, wanted) in AT.into_iter().zip(wanted) {
            let got = corrected.acceleration_m_s2(Component::X)[at];
            assert!((got - wanted).abs() < 1e-9, "sample {at}: {got}, {wanted}");
        }
    }

    #[test]
    fn agrees_with_polyfit() {
        // np.polynomial.Polynomial.fit(i, a, d)(i)
        let of = |degree| {
            motion(2000)
                .baseline_corrected(Baseline::Polynomial { degree })
                .unwrap()
        };
        agree(&of(1), POLYFIT_1);
        agree(&of(3), POLYFIT_3);
        assert_eq!(of(3).history(), [Processing::Detrend { degree: 3 }]);
    }

    #[test]
    fn agrees_with_sosfiltfilt_high_pass() {
        // sos = butter(n, fc, 'high', fs=100, output='sos'); p = ceil(log(.01)/log(max |pole|)); sosfiltfilt(sos, a, padlen=p)
        let of = |corner_hz, order| {
            motion(2000)
                .baseline_corrected(Baseline::HighPass { corner_hz, order })
                .unwrap()
        };
        agree(&of(2.0, 4), HIGH_PASS_2);
        agree(&of(5.0, 3), HIGH_PASS_5);
    }

    const POLYFIT_1: [f64; 5] = [
        0.49903305620798744,
        0.46800736105914553,
        0.5619988002527425,
        -0.4618322739192795,
        -0.3703594272986064,
    ];
    const POLYFIT_3: [f64; 5] = [
        0.45604320013124244,
        0.4250526074005252,
        0.5771935844901551,
        -0.5670011017857259,
        -0.47593908425177056,
    ];
    const HIGH_PASS_2: [f64; 5] = [
        -0.0007597533256197744,
        0.007401661590549294,
        0.5735513811377577,
        -0.1326417524084033,
        0.0015799297326559714,
    ];
    const HIGH_PASS_5: [f64; 5] = [
        0.0036266316307583812,
        -0.021498342226119294,
        0.3094952209392208,
        -0.2776354993090118,
        0.01004780877546707,
    ];

    #[test]
    fn refuses_what_cannot_be_taken_off() {
        let say = |baseline| motion(100).baseline_corrected(baseline).unwrap_err().to_string();
        assert_eq!(
            say(Baseline::Polynomial { degree: 7 }),
            "degree is 7, but must be 0 to 6"
        );
        assert!(
            say(Baseline::HighPass {
                corner_hz: 0.05,
                order: 4
            })
            .contains("the high-pass filter rings for")
        );
        assert!(
            say(Baseline::HighPass {
                corner_hz: 60.0,
                order: 4
            })
            .starts_with("corner_hz is 60 Hz")
        );
    }
}
