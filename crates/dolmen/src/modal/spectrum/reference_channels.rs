//! Selects a few reference channels that represent the motion of all channels, from the spectrum.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | M | `seen` | Re Σ S(f)/tr S(f) over the peaks f of the spectrum | l × l |
//! | M_k | `left` | residual of M after linear regression on the k selected channels | l × l |

use dolmen_linalg::Matrix;

/// Channels are selected until the residual motion at the peaks is at most this fraction. Our choice, from the records of the book:
/// 0.1 selects 2 of 8 channels for close pairs, 0.01 nearly all.
const LEFT_MOST: f64 = 0.1;
/// Fewest channels: two modes of the same frequency need two references.
pub(crate) const REFERENCES_LEAST: usize = 2;
/// Arrays of more channels use some of them as references, this share at least, in the methods that start from correlations. Our choice: on the
/// records of the book a quarter gives the same modes, with the same deviations.
const ALL_MOST: usize = 48;
const SHARE_OF_WIDE: usize = 4;

/// Fewest references of an array, if not all channels are to be references.
pub(crate) fn least_of_wide(channels: usize) -> Option<usize> {
    (channels > ALL_MOST).then(|| channels.div_ceil(SHARE_OF_WIDE))
}

/// Reference channels, and the fraction of the motion that they represent.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ReferenceChannels {
    /// Indices of the channels, ascending.
    pub(crate) channels: Vec<usize>,
    /// Fraction of the motion at the peaks that the channels explain, 0 to 1.
    pub(crate) kept: f64,
}

/// Selects channels one by one: each explains most of the remaining motion at the peaks (pivoted Cholesky).
///
/// ```text
/// c_k = argmax diag M_k;   M_(k+1) = M_k - m mᵀ/m_c,  m = column c_k of M_k;   until tr M_k ≤ .1 tr M         shape: l × l
/// ```
/// Every peak has the same weight, however strong. Without peaks all channels are selected, and never fewer than `least`.
pub(crate) fn keeping_most(seen: &Matrix, least: usize) -> ReferenceChannels {
    let l = seen.rows();
    let trace = |m: &Matrix| (0..l).map(|c| m[(c, c)].max(0.0)).sum::<f64>();
    let whole = trace(seen);
    if whole <= 0.0 {
        return ReferenceChannels {
            channels: (0..l).collect(),
            kept: 1.0,
        };
    }
    let mut left = seen.clone();
    let mut channels: Vec<usize> = Vec::new();
    while channels.len() < least.min(l) || trace(&left) > LEFT_MOST * whole {
        let free = (0..l).filter(|c| !channels.contains(c));
        let Some(c) = free.max_by(|a, b| left[(*a, *a)].total_cmp(&left[(*b, *b)])) else {
            break;
        };
        let (pivot, column) = (left[(c, c)], left.column(c).to_vec());
        channels.push(c);
        if pivot <= 0.0 {
            continue;
        }
        for (j, along) in column.iter().enumerate() {
            for (x, m) in left.column_mut(j).iter_mut().zip(&column) {
                *x -= m * along / pivot;
            }
        }
    }
    channels.sort_unstable();
    ReferenceChannels {
        channels,
        kept: 1.0 - trace(&left) / whole,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Σ φ φᵀ / φᵀ φ.
    fn of(shapes: &[[f64; 5]]) -> Matrix {
        Matrix::from_fn(5, 5, |i, j| {
            let part = |phi: &[f64; 5]| phi[i] * phi[j] / phi.iter().map(|x| x * x).sum::<f64>();
            shapes.iter().map(part).sum()
        })
    }

    #[test]
    fn exact_channels_of_two_shapes_are_the_strongest_and_the_one_that_differs_most() {
        // channel 3 has the largest motion; the residual is then largest at channel 1
        let two = [[0.1, 0.3, 0.2, 1.0, 0.4], [0.2, -0.7, 0.1, 1.0, 0.3]];
        let found = keeping_most(&of(&two), REFERENCES_LEAST);
        assert_eq!(found.channels, [1, 3]);
        assert!((found.kept - 1.0).abs() < 1e-12, "{found:?}");
        assert_eq!(keeping_most(&of(&two), 4).channels.len(), 4);
    }

    #[test]
    fn exact_share_that_two_channels_keep_of_three_shapes_by_hand() {
        // e0 e0ᵀ + e1 e1ᵀ + e2 e2ᵀ: each channel has a third of the motion, so two channels leave more than a tenth
        let apart = [
            [1.0, 0.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.0, 0.0],
            [0.0, 0.0, 1.0, 0.0, 0.0],
        ];
        assert_eq!(keeping_most(&of(&apart), REFERENCES_LEAST).channels, [0, 1, 2]);
        // a single shape: still two channels, and no residual
        let one = keeping_most(&of(&[[0.0, 0.0, 2.0, 1.0, 0.0]]), REFERENCES_LEAST);
        assert_eq!((one.channels.len(), one.channels.contains(&2)), (2, true));
        assert!((one.kept - 1.0).abs() < 1e-12);
        assert_eq!(
            keeping_most(&Matrix::zeros(3, 3), REFERENCES_LEAST).channels,
            [0, 1, 2]
        );
    }
}
