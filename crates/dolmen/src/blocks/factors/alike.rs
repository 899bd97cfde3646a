//! Factors that the modes cannot distinguish, such as those of two equal posts.

use super::model::FactorModel;
use super::result::FactorRange;

/// Difference of sensitivities, relative to the largest, below which they count as equal. Our choice: far above rounding, far below any
/// difference in shape.
const EQUAL_WITHIN: f64 = 1e-6;

/// For each factor, the first factor with equal sensitivities of all data, when all factors are equal; the factor itself if there is none.
pub(super) fn alike(model: &FactorModel, centre: f64) -> Vec<usize> {
    let n = model.unknowns;
    let Some(found) = model.residuals(&vec![centre; n]) else {
        return (0..n).collect();
    };
    let j = &found.jacobian;
    let columns: Vec<Vec<f64>> = (0..n)
        .map(|g| (0..j.rows()).map(|i| j[(i, g)]).collect())
        .collect();
    first_alike(&columns)
}

fn first_alike(columns: &[Vec<f64>]) -> Vec<usize> {
    let largest = columns
        .iter()
        .flatten()
        .fold(0.0_f64, |most, x| most.max(x.abs()));
    let is_alike = |a: &[f64], b: &[f64]| {
        let mut both = a.iter().zip(b);
        both.all(|(a, b)| (a - b).abs() <= EQUAL_WITHIN * largest)
    };
    let first = |g: usize| {
        (0..g)
            .find(|&of| is_alike(&columns[of], &columns[g]))
            .unwrap_or(g)
    };
    (0..columns.len()).map(first).collect()
}

/// Gives indistinguishable factors one common range that contains all their ranges, and a best value only if each of them has one.
pub(super) fn say_alike(alike: &[usize], determined: &mut [Option<[f64; 2]>], ranges: &mut [FactorRange]) {
    let of = |first: usize| {
        let all = alike.iter().enumerate().filter(move |(_, of)| **of == first);
        all.map(|(at, _)| at).collect::<Vec<usize>>()
    };
    for first in 0..alike.len() {
        let all = of(first);
        if all.len() < 2 {
            continue;
        }
        let is_open = all.iter().any(|&at| determined[at].is_none());
        let own: Vec<FactorRange> = all.iter().filter_map(|&at| ranges.get(at).copied()).collect();
        let widest = own.into_iter().reduce(|a, b| FactorRange {
            lower: a.lower.min(b.lower),
            upper: a.upper.max(b.upper),
            is_lower_of_band: a.is_lower_of_band || b.is_lower_of_band,
            is_upper_of_band: a.is_upper_of_band || b.is_upper_of_band,
        });
        for at in all {
            determined[at] = determined[at].filter(|_| !is_open);
            if let (Some(range), Some(widest)) = (ranges.get_mut(at), widest) {
                *range = widest;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_two_equal_posts_get_the_same_word() {
        let columns = [[0.28, 0.50], [0.22, 0.005], [0.28 + 1e-9, 0.50], [0.28, 0.49]];
        let alike = first_alike(&columns.map(|column| column.to_vec()));
        assert_eq!(alike, [0, 1, 0, 3]);
        let range = |lower, upper, is_upper_of_band| FactorRange {
            lower,
            upper,
            is_lower_of_band: false,
            is_upper_of_band,
        };
        let mut ranges = vec![
            range(0.8, 1.2, false),
            range(0.5, 2.0, false),
            range(0.7, 9.0, true),
            range(0.9, 1.1, false),
        ];
        let mut determined = [Some([1.0, 0.1]), Some([1.0, 0.2]), None, Some([1.0, 0.05])];
        say_alike(&alike, &mut determined, &mut ranges);
        assert_eq!(determined, [None, Some([1.0, 0.2]), None, Some([1.0, 0.05])]);
        assert_eq!(
            (ranges[0], ranges[2]),
            (range(0.7, 9.0, true), range(0.7, 9.0, true))
        );
        assert_eq!(ranges[3], range(0.9, 1.1, false));
    }
}
