//! Range of a stiffness when each frequency may be anywhere within a half-width.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | h_j | `half_width_hz` | half-width of the interval of frequency j | Hz |
//! | s | `way` | position between the measured frequencies (0) and a corner of the box (1) | – |

use super::SpringModel;
use super::newton::stiffness_by_newton;
use crate::structure::StiffnessRange;

/// Number of steps from the centre of the box of frequencies to each corner.
const STEPS: usize = 16;

/// Follows the root to the 2ⁿ corners of the box of frequencies and keeps its extremes.
pub(crate) fn range_of_root(
    model: &SpringModel,
    frequencies_hz: &[f64],
    half_width_hz: &[f64],
    root: &[f64],
) -> StiffnessRange {
    let n = root.len();
    let mut range = StiffnessRange {
        half_width_hz: half_width_hz.to_vec(),
        lower: root.to_vec(),
        upper: root.to_vec(),
        exists_throughout: true,
    };
    for corner in 0..1_usize << n {
        let mut k = root.to_vec();
        for step in 1..=STEPS {
            let way = step as f64 / STEPS as f64;
            let lambda: Vec<f64> = (0..n)
                .map(|j| {
                    let sign = if corner >> j & 1 == 0 { -1.0 } else { 1.0 };
                    (std::f64::consts::TAU * (frequencies_hz[j] + sign * way * half_width_hz[j])).powi(2)
                })
                .collect();
            let ascending = lambda.windows(2).all(|pair| pair[0] < pair[1]);
            let next = if ascending {
                stiffness_by_newton(model, &lambda, k)
            } else {
                None
            };
            let Some(next) = next else {
                range.exists_throughout = false;
                break;
            };
            for (i, &k) in next.iter().enumerate() {
                range.lower[i] = range.lower[i].min(k);
                range.upper[i] = range.upper[i].max(k);
            }
            k = next;
        }
    }
    range
}
