//! A square matrix of 6 × 6 blocks that are nonzero only near its diagonal, with LU factors within its skyline. For a chain
//! the matrix is block-tridiagonal, and the cost per body does not depend on the number of bodies.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | f_i | `first` | first filled block column of row i, and first filled row of column i |
//! | A_ij, j < i | `lower` | row by row from f_i |
//! | A_ji, j < i | `upper` | column by column from f_i |

/// Rows of a block.
pub(super) const SIX: usize = 6;

/// A 6 × 6 block, row by row.
pub(super) type Block = [[f64; SIX]; SIX];

/// Pivot below which a block counts as singular, over its largest entry. Our choice: rounding.
const SINGULAR: f64 = 1e-14;

/// The matrix, then its factors.
#[derive(Clone, Debug, Default)]
pub(super) struct BlockSkyline {
    first: Vec<usize>,
    start: Vec<usize>,
    diagonal: Vec<Block>,
    lower: Vec<Block>,
    upper: Vec<Block>,
}

impl BlockSkyline {
    /// A zero matrix with this skyline.
    pub(super) fn within(first: Vec<usize>) -> Self {
        let mut start = Vec::with_capacity(first.len());
        let mut filled = 0;
        for (row, first) in first.iter().enumerate() {
            start.push(filled);
            filled += row - first;
        }
        let zero = [[0.0; SIX]; SIX];
        BlockSkyline {
            diagonal: vec![zero; first.len()],
            lower: vec![zero; filled],
            upper: vec![zero; filled],
            first,
            start,
        }
    }

    pub(super) fn clear(&mut self) {
        for part in [&mut self.diagonal, &mut self.lower, &mut self.upper] {
            part.fill([[0.0; SIX]; SIX]);
        }
    }

    /// The block at a row and a column within the skyline.
    pub(super) fn block_mut(&mut self, row: usize, column: usize) -> &mut Block {
        if row == column {
            return &mut self.diagonal[row];
        }
        let (long, short) = (row.max(column), row.min(column));
        let at = self.start[long] + short - self.first[long];
        match row > column {
            true => &mut self.lower[at],
            false => &mut self.upper[at],
        }
    }

    /// Replaces the matrix by its factors, with inverses on the diagonal; false if a block on the diagonal is singular.
    ///
    /// ```text
    /// L_ij = (A_ij − Σ_k L_ik U_kj) U_jj⁻¹,   U_ji = A_ji − Σ_k L_jk U_ki,   U_ii = A_ii − Σ_k L_ik U_ki
    /// ```
    pub(super) fn factor(&mut self) -> bool {
        for i in 0..self.first.len() {
            for j in self.first[i]..i {
                let (at_i, at_j) = (self.start[i] + j - self.first[i], self.start[j]);
                let from = self.first[i].max(self.first[j]);
                let (mut low, mut high) = (self.lower[at_i], self.upper[at_i]);
                for k in from..j {
                    let of_i = self.start[i] + k - self.first[i];
                    let of_j = at_j + k - self.first[j];
                    subtract_product(&mut low, &self.lower[of_i], &self.upper[of_j]);
                    subtract_product(&mut high, &self.lower[of_j], &self.upper[of_i]);
                }
                self.lower[at_i] = product(&low, &self.diagonal[j]);
                self.upper[at_i] = high;
            }
            let mut diagonal = self.diagonal[i];
            for j in self.first[i]..i {
                let at = self.start[i] + j - self.first[i];
                subtract_product(&mut diagonal, &self.lower[at], &self.upper[at]);
            }
            match inverse(diagonal) {
                Some(inverse) => self.diagonal[i] = inverse,
                None => return false,
            }
        }
        true
    }

    /// Increases every diagonal entry by this fraction of itself, plus the smallest positive number.
    pub(super) fn stiffen(&mut self, part: f64) {
        for block in &mut self.diagonal {
            for (i, row) in block.iter_mut().enumerate() {
                row[i] += f64::MIN_POSITIVE + part * row[i];
            }
        }
    }

    /// Whether the symmetric matrix of these factors is positive definite: all remaining diagonal blocks are.
    pub(super) fn is_positive_definite(&self) -> bool {
        self.diagonal.iter().all(is_positive_definite)
    }

    /// Solves with the factors, in place.
    pub(super) fn solve(&self, right: &mut [[f64; SIX]]) {
        let rows = self.first.len();
        for i in 0..rows {
            let mut sum = right[i];
            let row = &self.lower[self.start[i]..self.start[i] + i - self.first[i]];
            for (block, solved) in row.iter().zip(&right[self.first[i]..i]) {
                subtract_from(&mut sum, block, solved);
            }
            right[i] = sum;
        }
        for i in (0..rows).rev() {
            let mut solved = [0.0; SIX];
            subtract_from(&mut solved, &self.diagonal[i], &right[i]);
            right[i] = solved.map(|value| -value);
            for j in self.first[i]..i {
                let mut sum = right[j];
                subtract_from(
                    &mut sum,
                    &self.upper[self.start[i] + j - self.first[i]],
                    &right[i],
                );
                right[j] = sum;
            }
        }
    }
}

/// Whether a symmetric block is positive definite, by the pivots of its Cholesky factorization.
fn is_positive_definite(block: &Block) -> bool {
    let mut lower = [[0.0_f64; SIX]; SIX];
    for i in 0..SIX {
        for j in 0..=i {
            let own = 0.5 * (block[i][j] + block[j][i]);
            let left = (0..j).fold(own, |left, k| left - lower[i][k] * lower[j][k]);
            lower[i][j] = match i == j {
                true if left > 0.0 => left.sqrt(),
                true => return false,
                false => left / lower[j][j],
            };
        }
    }
    true
}

/// C −= A B.
#[inline]
fn subtract_product(c: &mut Block, a: &Block, b: &Block) {
    for (c, a) in c.iter_mut().zip(a) {
        for (a, b) in a.iter().zip(b) {
            for (c, b) in c.iter_mut().zip(b) {
                *c -= a * b;
            }
        }
    }
}

#[inline]
fn product(a: &Block, b: &Block) -> Block {
    let mut c = [[0.0; SIX]; SIX];
    subtract_product(&mut c, a, b);
    c.map(|row| row.map(|value| -value))
}

/// y −= A x.
#[inline]
fn subtract_from(y: &mut [f64; SIX], a: &Block, x: &[f64; SIX]) {
    for (y, a) in y.iter_mut().zip(a) {
        let mut sum = 0.0;
        for (a, x) in a.iter().zip(x) {
            sum += a * x;
        }
        *y -= sum;
    }
}

/// Inverse by Gauss–Jordan elimination with pivots in the column.
fn inverse(mut a: Block) -> Option<Block> {
    let largest = a
        .iter()
        .flatten()
        .fold(0.0_f64, |most, value| most.max(value.abs()));
    let mut swaps = [0; SIX];
    for pivot in 0..SIX {
        let mut row = pivot;
        for other in pivot + 1..SIX {
            if a[other][pivot].abs() > a[row][pivot].abs() {
                row = other;
            }
        }
        let value = a[row][pivot];
        if value.is_nan() || value.abs() <= SINGULAR * largest {
            return None;
        }
        a.swap(pivot, row);
        swaps[pivot] = row;
        let scale = 1.0 / value;
        a[pivot][pivot] = 1.0;
        for entry in &mut a[pivot] {
            *entry *= scale;
        }
        let of_pivot = a[pivot];
        for (index, row) in a.iter_mut().enumerate() {
            if index != pivot {
                let factor = row[pivot];
                row[pivot] = 0.0;
                for (entry, of_pivot) in row.iter_mut().zip(&of_pivot) {
                    *entry -= factor * of_pivot;
                }
            }
        }
    }
    for pivot in (0..SIX).rev() {
        if swaps[pivot] != pivot {
            for row in &mut a {
                row.swap(pivot, swaps[pivot]);
            }
        }
    }
    Some(a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_linalg::{Matrix, solve};

    /// An unsymmetric matrix within a skyline, and a right side, from fixed pseudo-random numbers.
    fn case(first: &[usize]) -> (BlockSkyline, Matrix, Vec<[f64; SIX]>) {
        let mut seed = 7_u64;
        let mut draw = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let rows = first.len();
        let mut sky = BlockSkyline::within(first.to_vec());
        let mut full = Matrix::zeros(SIX * rows, SIX * rows);
        for (i, &from) in first.iter().enumerate() {
            for j in from..=i {
                for (row, column) in if i == j {
                    vec![(i, i)]
                } else {
                    vec![(i, j), (j, i)]
                } {
                    for a in 0..SIX {
                        for b in 0..SIX {
                            let value = draw() + if row == column && a == b { 4.0 } else { 0.0 };
                            sky.block_mut(row, column)[a][b] = value;
                            full[(SIX * row + a, SIX * column + b)] = value;
                        }
                    }
                }
            }
        }
        let right = (0..rows).map(|_| std::array::from_fn(|_| draw())).collect();
        (sky, full, right)
    }

    #[test]
    fn agrees_with_a_full_solution() {
        for first in [vec![0, 0, 1, 2, 3], vec![0, 0, 0, 2, 1, 0, 5], vec![0, 1, 2]] {
            let (mut sky, full, mut right) = case(&first);
            let flat: Vec<f64> = right.iter().flatten().copied().collect();
            let exact = solve(&full, &Matrix::from_column(&flat)).unwrap();
            assert!(sky.factor());
            sky.solve(&mut right);
            for (found, exact) in right.iter().flatten().zip(exact.column(0)) {
                assert!((found - exact).abs() < 1e-12, "{found} against {exact}");
            }
        }
    }

    #[test]
    fn exact_a_symmetric_matrix_is_positive_definite_until_its_least_eigenvalue_is_0() {
        // a chain of springs of stiffness 1 held at one end by k: smallest pivot k / (1 + k) > 0
        for (held, expected) in [(1e-3, true), (-1e-3, false)] {
            let mut sky = BlockSkyline::within(vec![0, 0, 1]);
            for row in 0..3 {
                for part in 0..SIX {
                    let ends = if row == 2 { 1.0 } else { 2.0 };
                    sky.block_mut(row, row)[part][part] = if row == 0 { 1.0 + held } else { ends };
                    if row > 0 {
                        sky.block_mut(row, row - 1)[part][part] = -1.0;
                        sky.block_mut(row - 1, row)[part][part] = -1.0;
                    }
                }
            }
            assert!(sky.factor());
            assert_eq!(sky.is_positive_definite(), expected);
        }
    }

    #[test]
    fn refuses_a_singular_block() {
        let mut sky = BlockSkyline::within(vec![0]);
        sky.block_mut(0, 0)[0][0] = 1.0;
        assert!(!sky.factor());
    }
}
