//! Envelope of a channel: smallest and largest sample of equal parts, so that a drawing shows every spike.

use crate::numeric::largest_of;

/// Smallest and largest sample of each part of a series.
#[derive(Clone, Debug, PartialEq)]
pub struct Envelope {
    /// First sample of each part, then the number of samples.
    pub starts: Vec<usize>,
    /// Smallest sample of each part.
    pub least: Vec<f64>,
    /// Largest sample of each part.
    pub most: Vec<f64>,
}

/// Smallest and largest sample of `parts` parts, whose lengths differ by at most one sample. A series with fewer samples than `parts` gives one
/// part a sample.
///
/// # Example
/// ```
/// let drawn = dolmen::signal::envelope(&[0.0, 5.0, -1.0, 0.0], 2);
/// assert_eq!((drawn.least, drawn.most), (vec![0.0, -1.0], vec![5.0, 0.0]));
/// ```
pub fn envelope(samples: &[f64], parts: usize) -> Envelope {
    let parts = parts.min(samples.len());
    let starts: Vec<usize> = (0..=parts)
        .map(|part| part * samples.len() / parts.max(1))
        .collect();
    let each = || starts.windows(2).map(|ends| &samples[ends[0]..ends[1]]);
    let least = each().map(|part| -largest_of(part, |x| -x));
    let most = each().map(|part| largest_of(part, |x| x));
    let (least, most) = (least.collect(), most.collect());
    Envelope { starts, least, most }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn holds_every_extreme_is_kept(x in prop::collection::vec(-1.0..1.0, 1..300), parts in 1_usize..400) {
            let drawn = envelope(&x, parts);
            prop_assert_eq!(drawn.least.len(), parts.min(x.len()));
            prop_assert_eq!(drawn.starts.first().copied(), Some(0));
            prop_assert_eq!(drawn.starts.last().copied(), Some(x.len()));
            for (part, ends) in drawn.starts.windows(2).enumerate() {
                let own = &x[ends[0]..ends[1]];
                prop_assert!(!own.is_empty());
                prop_assert!(own.iter().all(|v| (drawn.least[part]..=drawn.most[part]).contains(v)));
                prop_assert!(own.contains(&drawn.least[part]) && own.contains(&drawn.most[part]));
            }
        }
    }

    #[test]
    fn exact_one_spike_of_a_long_record_is_seen() {
        let mut x = vec![0.0; 100_003];
        x[77_777] = -9.0;
        let drawn = envelope(&x, 600);
        let at = drawn.least.iter().position(|least| *least == -9.0).unwrap();
        assert!((drawn.starts[at]..drawn.starts[at + 1]).contains(&77_777));
        assert_eq!(drawn.least.iter().filter(|least| **least == 0.0).count(), 599);
        assert_eq!(envelope(&[], 5).least, Vec::<f64>::new());
    }
}
