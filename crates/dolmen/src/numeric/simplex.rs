//! The farthest that a polyhedral cone reaches along a line: a linear programme with one unknown that counts.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | A, b, d | `columns`, `right`, `along` | what is balanced by x ≥ 0: b + t d |
//! | B⁻¹ | `inverse` | inverse of the columns in the basis, kept whole, column after column |
//! | y | `prices` | wᵀ B⁻¹: w = 1 on what is missing at first, −1 on t then |

use super::NumericError;

/// One column of a matrix: rows and values.
pub(crate) type SparseColumn = Vec<(usize, f64)>;

/// How far the cone reaches.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Reach {
    /// To `most`, with the shares of the columns at 0 and there.
    To {
        most: f64,
        at_start: Vec<f64>,
        at_most: Vec<f64>,
    },
    /// Without end; the shares at 0.
    Endless { at_start: Vec<f64> },
    /// Not even b is within it: this share of it is missing.
    Nowhere { missing: f64 },
}

/// Smallest gain, per unit of a column of order 1, for which a column enters. Chosen here.
const GAIN: f64 = 1e-10;
/// Smallest pivot. Chosen here.
const PIVOT: f64 = 1e-8;
/// By how much a share may fall below 0 so that a larger pivot can be had (Harris). Chosen here.
const BELOW: f64 = 1e-11;
/// What may be missing at the start, over Σ |b| or 1. Chosen here.
const MISSING: f64 = 1e-9;
/// Steps between two corrections of the inverse. Chosen here.
const CORRECT_EVERY: usize = 100;
/// Steps without progress after which Bland's rule takes over until there is some. Chosen here.
const STALLED: usize = 40;
/// Steps allowed, per row and column. Chosen here; some 3 a row are usual.
const STEPS: usize = 50;

/// The largest t ≥ 0 for which shares x ≥ 0 give A x = b + t d, if b alone can be had.
///
/// ```text
/// maximise t over x, t ≥ 0:  A x − t d = b,   started from A x = b        A [m × n], b, d [m], of order 1
/// ```
///
/// # Errors
/// [`NumericError::Steps`] if it does not end.
///
/// # Source
/// Dantzig's revised simplex method in two phases; ratio test after Harris (1973), Bland's rule (1977) where it stalls.
/// Differs from the source: the inverse is kept whole (the programmes are small) and corrected by Schulz's iteration.
pub(crate) fn reach(columns: &[SparseColumn], right: &[f64], along: &[f64]) -> Result<Reach, NumericError> {
    let mut all: Vec<SparseColumn> = columns.to_vec();
    all.push(
        (0..along.len())
            .filter(|&row| along[row] != 0.0)
            .map(|row| (row, -along[row]))
            .collect(),
    );
    let sought = columns.len();
    let mut simplex = Simplex::new(&all, right);
    simplex.climb(sought, None)?;
    let missing: f64 = simplex.missing();
    if missing > MISSING * right.iter().map(|b| b.abs()).sum::<f64>().max(1.0) {
        return Ok(Reach::Nowhere { missing });
    }
    let at_start = simplex.shares();
    // from here on t grows: the line enters, then whatever lets it grow
    let Some(row) = simplex.enter(sought, true, false) else {
        return Ok(Reach::Endless { at_start });
    };
    Ok(match simplex.climb(sought, Some(row))? {
        Climbed::Top => Reach::To {
            at_most: simplex.shares(),
            most: simplex.values[row],
            at_start,
        },
        Climbed::Endless => Reach::Endless { at_start },
    })
}

enum Climbed {
    Top,
    Endless,
}

struct Simplex<'a> {
    columns: &'a [SparseColumn],
    right: &'a [f64],
    /// Which column is basic in a row; from `columns.len()` on what is missing in a row.
    basis: Vec<usize>,
    inverse: Vec<f64>,
    values: Vec<f64>,
}

impl<'a> Simplex<'a> {
    /// All of b is missing.
    fn new(columns: &'a [SparseColumn], right: &'a [f64]) -> Self {
        let m = right.len();
        let mut inverse = vec![0.0; m * m];
        for (row, b) in right.iter().enumerate() {
            inverse[row * m + row] = sign(*b);
        }
        Simplex {
            columns,
            right,
            basis: (columns.len()..columns.len() + m).collect(),
            inverse,
            values: right.iter().map(|b| b.abs()).collect(),
        }
    }

    fn is_missing(&self, row: usize) -> bool {
        self.basis[row] >= self.columns.len()
    }

    fn missing(&self) -> f64 {
        let rows = (0..self.values.len()).filter(|&row| self.is_missing(row));
        rows.map(|row| self.values[row].abs()).sum()
    }

    /// Shares of all columns but the last.
    fn shares(&self) -> Vec<f64> {
        let mut shares = vec![0.0; self.columns.len() + self.right.len()];
        for (&column, &value) in self.basis.iter().zip(&self.values) {
            shares[column] = value;
        }
        shares.truncate(self.columns.len() - 1);
        shares
    }

    /// Lets columns before `end` enter as long as one gains: on what is missing, or on the value of a row.
    fn climb(&mut self, end: usize, counts: Option<usize>) -> Result<Climbed, NumericError> {
        let most = STEPS * (self.right.len() + self.columns.len());
        let (mut best, mut since) = (f64::NEG_INFINITY, 0);
        for step in 1..=most {
            let now = counts.map_or_else(|| -self.missing(), |row| self.values[row]);
            if now > best + BELOW {
                (best, since) = (now, 0);
            } else {
                since += 1;
            }
            if step % CORRECT_EVERY == 0 {
                self.correct();
            }
            let bland = since > STALLED;
            let Some(column) = self.gaining(end, counts, bland) else {
                self.correct();
                return Ok(Climbed::Top);
            };
            if self.enter(column, counts.is_some(), bland).is_none() {
                return Ok(Climbed::Endless);
            }
        }
        Err(NumericError::Steps { most })
    }

    /// The column before `end` that gains most, or the first that gains.
    fn gaining(&self, end: usize, counts: Option<usize>, first: bool) -> Option<usize> {
        let m = self.right.len();
        let prices: Vec<f64> = self
            .inverse
            .chunks_exact(m)
            .map(|column| match counts {
                Some(row) => -column[row],
                None => (0..m)
                    .filter(|&row| self.is_missing(row))
                    .map(|row| column[row])
                    .sum(),
            })
            .collect();
        let least = GAIN * prices.iter().fold(1.0_f64, |most, price| most.max(price.abs()));
        let (mut best, mut gains) = (None, least);
        for (index, column) in self.columns[..end].iter().enumerate() {
            let gain: f64 = column.iter().map(|&(row, value)| prices[row] * value).sum();
            if gain > gains {
                (best, gains) = (Some(index), gain);
                if first {
                    break;
                }
            }
        }
        best
    }

    /// Takes a column into the basis; the row it takes, or `None` if nothing stops it. With `complete` nothing is missing and
    /// must stay so.
    fn enter(&mut self, column: usize, complete: bool, bland: bool) -> Option<usize> {
        let m = self.right.len();
        let mut change = vec![0.0; m];
        for &(row, value) in &self.columns[column] {
            for (change, inverse) in change.iter_mut().zip(&self.inverse[row * m..]) {
                *change += value * inverse;
            }
        }
        let stops = |row: usize| -> Option<f64> {
            let size = change[row];
            if complete && self.is_missing(row) {
                return (size.abs() > PIVOT).then_some(0.0);
            }
            (size > PIVOT).then(|| self.values[row].max(0.0) / size)
        };
        let allowed = (0..m)
            .filter_map(|row| stops(row).map(|ratio| ratio + BELOW / change[row].abs()))
            .fold(f64::INFINITY, f64::min);
        let candidates = (0..m).filter(|&row| stops(row).is_some_and(|ratio| ratio <= allowed));
        let row = if bland {
            candidates.min_by_key(|&row| self.basis[row])
        } else {
            candidates.max_by(|&a, &b| change[a].abs().total_cmp(&change[b].abs()))
        }?;
        let far = stops(row)?;
        for (value, change) in self.values.iter_mut().zip(&change) {
            *value -= far * change;
        }
        self.values[row] = far;
        for inverse in self.inverse.chunks_exact_mut(m) {
            let times = inverse[row] / change[row];
            if times != 0.0 {
                for (inverse, change) in inverse.iter_mut().zip(&change) {
                    *inverse -= times * change;
                }
                inverse[row] = times;
            }
        }
        self.basis[row] = column;
        Some(row)
    }

    /// One step of Schulz's iteration, X + (I − X B) X, then the values anew.
    fn correct(&mut self) {
        let m = self.right.len();
        let mut corrected = self.inverse.clone();
        for (at, &basic) in self.basis.iter().enumerate() {
            // column `at` of I − X B
            let mut error = vec![0.0; m];
            error[at] = 1.0;
            let missing;
            let column = match self.columns.get(basic) {
                Some(column) => column,
                None => {
                    let row = basic - self.columns.len();
                    missing = vec![(row, sign(self.right[row]))];
                    &missing
                }
            };
            for &(row, value) in column {
                for (error, inverse) in error.iter_mut().zip(&self.inverse[row * m..]) {
                    *error -= value * inverse;
                }
            }
            for (corrected, inverse) in corrected.chunks_exact_mut(m).zip(self.inverse.chunks_exact(m)) {
                if inverse[at] != 0.0 {
                    for (corrected, error) in corrected.iter_mut().zip(&error) {
                        *corrected += error * inverse[at];
                    }
                }
            }
        }
        self.inverse = corrected;
        self.values.fill(0.0);
        for (inverse, b) in self.inverse.chunks_exact(m).zip(self.right) {
            for (value, inverse) in self.values.iter_mut().zip(inverse) {
                *value += inverse * b;
            }
        }
    }
}

fn sign(value: f64) -> f64 {
    if value < 0.0 { -1.0 } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use microlp::{ComparisonOp, LinearExpr, OptimizationDirection, Problem};

    fn dense(columns: &[&[f64]]) -> Vec<SparseColumn> {
        let sparse = |column: &&[f64]| column.iter().copied().enumerate().collect();
        columns.iter().map(sparse).collect()
    }

    #[test]
    fn exact_small_programmes() {
        // x1 (1, 1) + x2 (−1, 1) = (0, 1) + t (1, 0): all of it on x1, t = 1
        let columns = dense(&[&[1.0, 1.0], &[-1.0, 1.0]]);
        let Reach::To {
            most,
            at_start,
            at_most,
        } = reach(&columns, &[0.0, 1.0], &[1.0, 0.0]).unwrap()
        else {
            panic!("no end")
        };
        assert!((most - 1.0).abs() < 1e-14);
        assert!((at_start[0] - 0.5).abs() < 1e-14 && (at_start[1] - 0.5).abs() < 1e-14);
        assert!((at_most[0] - 1.0).abs() < 1e-14 && at_most[1].abs() < 1e-14);
        let upwards = reach(&columns, &[0.0, 1.0], &[0.0, 1.0]).unwrap();
        assert!(matches!(upwards, Reach::Endless { .. }), "{upwards:?}");
        let below = reach(&columns, &[0.0, -1.0], &[1.0, 0.0]).unwrap();
        assert_eq!(below, Reach::Nowhere { missing: 1.0 });
    }

    #[test]
    fn agrees_with_microlp_0_7_on_random_programmes() {
        let mut random = Random::new(11, 0);
        for case in 0..200 {
            let (m, n) = (2 + case % 9, 12 + case % 23);
            // every third case has many equal ratios: whole numbers
            let mut number = || {
                let value = 4.0 * (random.uniform() - 0.5);
                if case % 3 == 0 { value.round() } else { value }
            };
            let columns: Vec<SparseColumn> = (0..n)
                .map(|_| (0..m).map(|row| (row, number())).collect())
                .collect();
            let along: Vec<f64> = (0..m).map(|_| number()).collect();
            let mut right = vec![0.0; m];
            for column in &columns[..m.min(4)] {
                for &(row, value) in column {
                    right[row] += value;
                }
            }
            let mut problem = Problem::new(OptimizationDirection::Maximize);
            let sought = problem.add_var(1.0, (0.0, f64::INFINITY));
            let shares: Vec<_> = columns
                .iter()
                .map(|_| problem.add_var(0.0, (0.0, f64::INFINITY)))
                .collect();
            for row in 0..m {
                let mut sum = LinearExpr::empty();
                sum.add(sought, -along[row]);
                for (column, &share) in columns.iter().zip(&shares) {
                    sum.add(share, column[row].1);
                }
                problem.add_constraint(sum, ComparisonOp::Eq, right[row]);
            }
            let theirs = match problem.solve() {
                Ok(outcome) => outcome.into_solution().unwrap().var_value(sought),
                Err(_) => f64::INFINITY,
            };
            let ours = match reach(&columns, &right, &along).unwrap() {
                Reach::To { most, .. } => most,
                Reach::Endless { .. } => f64::INFINITY,
                Reach::Nowhere { missing } => panic!("case {case}: {missing}"),
            };
            assert!(
                ours == theirs || (ours - theirs).abs() < 1e-8 * (1.0 + theirs.abs()),
                "case {case}: {ours} {theirs}"
            );
        }
    }
}
