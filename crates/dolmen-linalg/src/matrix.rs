use num_complex::Complex64;
use std::ops::{Index, IndexMut};

/// A dense real matrix, stored column by column.
///
/// ```
/// use dolmen_linalg::Matrix;
/// let a = Matrix::from_rows(&[[1.0, 2.0], [3.0, 4.0]]);
/// assert_eq!((&a * &a)[(1, 0)], 15.0);
/// ```
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    data: Vec<f64>,
}

impl Matrix {
    /// A matrix of zeros.
    pub fn zeros(rows: usize, columns: usize) -> Self {
        Matrix {
            rows,
            columns,
            data: vec![0.0; rows * columns],
        }
    }

    /// The identity, `size` × `size`.
    pub fn identity(size: usize) -> Self {
        Self::from_fn(size, size, |i, j| if i == j { 1.0 } else { 0.0 })
    }

    /// A square matrix with `diagonal` on its diagonal.
    pub fn from_diagonal(diagonal: &[f64]) -> Self {
        Self::from_fn(diagonal.len(), diagonal.len(), |i, j| {
            if i == j { diagonal[i] } else { 0.0 }
        })
    }

    /// Each entry from its row and column.
    pub fn from_fn(rows: usize, columns: usize, mut entry: impl FnMut(usize, usize) -> f64) -> Self {
        let mut data = Vec::with_capacity(rows * columns);
        for j in 0..columns {
            for i in 0..rows {
                data.push(entry(i, j));
            }
        }
        Matrix { rows, columns, data }
    }

    /// A matrix from its rows, as printed on paper.
    pub fn from_rows<const N: usize>(rows: &[[f64; N]]) -> Self {
        Self::from_fn(rows.len(), N, |i, j| rows[i][j])
    }

    /// One column.
    pub fn from_column(column: &[f64]) -> Self {
        Matrix {
            rows: column.len(),
            columns: 1,
            data: column.to_vec(),
        }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// One column as a slice.
    pub fn column(&self, j: usize) -> &[f64] {
        &self.data[j * self.rows..(j + 1) * self.rows]
    }

    /// One column as a mutable slice.
    pub fn column_mut(&mut self, j: usize) -> &mut [f64] {
        &mut self.data[j * self.rows..(j + 1) * self.rows]
    }

    /// All entries, column by column.
    pub fn as_slice(&self) -> &[f64] {
        &self.data
    }

    /// All entries, column by column, mutable.
    pub fn as_mut_slice(&mut self) -> &mut [f64] {
        &mut self.data
    }

    /// The transpose.
    pub fn transpose(&self) -> Self {
        Self::from_fn(self.columns, self.rows, |i, j| self[(j, i)])
    }

    /// The block of `rows` × `columns` entries whose first is at (`row`, `column`).
    pub fn block(&self, row: usize, column: usize, rows: usize, columns: usize) -> Self {
        let mut data = Vec::with_capacity(rows * columns);
        for j in column..column + columns {
            data.extend_from_slice(&self.column(j)[row..row + rows]);
        }
        Matrix { rows, columns, data }
    }

    /// The matrix with each entry multiplied by `factor`.
    pub fn scaled(&self, factor: f64) -> Self {
        Matrix {
            data: self.data.iter().map(|x| x * factor).collect(),
            ..*self
        }
    }

    /// Matrix times vector: `rows` sums over `columns`.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        assert_eq!(
            x.len(),
            self.columns,
            "a vector times a matrix needs as many entries as columns"
        );
        let mut y = vec![0.0; self.rows];
        for (j, xj) in x.iter().enumerate() {
            for (yi, aij) in y.iter_mut().zip(self.column(j)) {
                *yi += aij * xj;
            }
        }
        y
    }

    /// xᵀ A y.
    pub fn form(&self, x: &[f64], y: &[f64]) -> f64 {
        x.iter().zip(self.times(y)).map(|(a, b)| a * b).sum()
    }
}

impl Index<(usize, usize)> for Matrix {
    type Output = f64;
    fn index(&self, (i, j): (usize, usize)) -> &f64 {
        assert!(i < self.rows, "row {i} of {}", self.rows);
        &self.data[j * self.rows + i]
    }
}

impl IndexMut<(usize, usize)> for Matrix {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut f64 {
        assert!(i < self.rows, "row {i} of {}", self.rows);
        &mut self.data[j * self.rows + i]
    }
}

impl std::ops::Add for &Matrix {
    type Output = Matrix;
    fn add(self, other: &Matrix) -> Matrix {
        assert_eq!(
            (self.rows, self.columns),
            (other.rows, other.columns),
            "A + B needs equal shapes"
        );
        Matrix {
            data: self.data.iter().zip(&other.data).map(|(a, b)| a + b).collect(),
            ..*self
        }
    }
}

impl std::ops::Sub for &Matrix {
    type Output = Matrix;
    fn sub(self, other: &Matrix) -> Matrix {
        assert_eq!(
            (self.rows, self.columns),
            (other.rows, other.columns),
            "A - B needs equal shapes"
        );
        Matrix {
            data: self.data.iter().zip(&other.data).map(|(a, b)| a - b).collect(),
            ..*self
        }
    }
}

/// A dense complex matrix, stored column by column.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct ComplexMatrix {
    rows: usize,
    columns: usize,
    data: Vec<Complex64>,
}

impl ComplexMatrix {
    /// A matrix of zeros.
    pub fn zeros(rows: usize, columns: usize) -> Self {
        ComplexMatrix {
            rows,
            columns,
            data: vec![Complex64::ZERO; rows * columns],
        }
    }

    /// Each entry from its row and column.
    pub fn from_fn(rows: usize, columns: usize, mut entry: impl FnMut(usize, usize) -> Complex64) -> Self {
        let mut data = Vec::with_capacity(rows * columns);
        for j in 0..columns {
            for i in 0..rows {
                data.push(entry(i, j));
            }
        }
        ComplexMatrix { rows, columns, data }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// One column as a slice.
    pub fn column(&self, j: usize) -> &[Complex64] {
        &self.data[j * self.rows..(j + 1) * self.rows]
    }

    /// All entries, column by column.
    pub fn as_slice(&self) -> &[Complex64] {
        &self.data
    }

    /// All entries, column by column, mutable.
    pub fn as_mut_slice(&mut self) -> &mut [Complex64] {
        &mut self.data
    }
}

impl Index<(usize, usize)> for ComplexMatrix {
    type Output = Complex64;
    fn index(&self, (i, j): (usize, usize)) -> &Complex64 {
        assert!(i < self.rows, "row {i} of {}", self.rows);
        &self.data[j * self.rows + i]
    }
}

impl IndexMut<(usize, usize)> for ComplexMatrix {
    fn index_mut(&mut self, (i, j): (usize, usize)) -> &mut Complex64 {
        assert!(i < self.rows, "row {i} of {}", self.rows);
        &mut self.data[j * self.rows + i]
    }
}
