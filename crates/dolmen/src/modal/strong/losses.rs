//! Lost samples and clipped channels of a record.

/// Missing samples and time of a record.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Losses {
    /// Times from and to of lost samples that were filled in, s from the first sample.
    pub lost_s: Vec<[f64; 2]>,
    /// Channels that were clipped at the end of their range.
    pub clipped: Vec<String>,
}

/// Why the true peak of a channel may have been larger.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtLeast {
    /// The channel was clipped.
    Clipped,
    /// Samples were lost during the earthquake.
    Lost,
    /// The record begins or ends during the earthquake.
    Edge,
}

impl Losses {
    pub(super) fn is_lost(&self, [from_s, to_s]: [f64; 2]) -> bool {
        self.lost_s.iter().any(|[from, to]| *from < to_s && *to > from_s)
    }

    /// The longest time between these two without lost samples; the later one of two equal times.
    pub(super) fn whole_within(&self, [from_s, to_s]: [f64; 2]) -> [f64; 2] {
        let mut inside: Vec<[f64; 2]> = self
            .lost_s
            .iter()
            .copied()
            .filter(|of| of[0] < to_s && of[1] > from_s)
            .collect();
        inside.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let starts = std::iter::once(from_s).chain(inside.iter().map(|of| of[1]));
        let ends = inside.iter().map(|of| of[0]).chain([to_s]);
        let spans = starts.zip(ends).map(|(start, end)| [start, end.max(start)]);
        let longest = spans.max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
        longest.unwrap_or([from_s, to_s])
    }
}

#[cfg(test)]
mod tests {
    use super::Losses;

    #[test]
    fn exact_the_longest_whole_time() {
        let losses = Losses {
            lost_s: vec![[50.0, 60.0], [10.0, 12.0]],
            ..Losses::default()
        };
        assert_eq!(losses.whole_within([0.0, 100.0]), [60.0, 100.0]);
        assert_eq!(losses.whole_within([0.0, 70.0]), [12.0, 50.0]);
        assert_eq!(losses.whole_within([55.0, 58.0]), [60.0, 60.0]);
        assert_eq!(losses.whole_within([20.0, 30.0]), [20.0, 30.0]);
        assert!(losses.is_lost([59.0, 61.0]) && !losses.is_lost([60.0, 61.0]));
    }
}
