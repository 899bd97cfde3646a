//! Projected change of a subspace by one block of time, computed once for all orders. See uncertainty.rs for the
//! symbols.

use dolmen_linalg::{Matrix, Qr};

/// Projected change by one block of time.
#[derive(Clone, Debug)]
pub(crate) struct Block {
    pub(super) e: Matrix,
    pub(super) f: Matrix,
    pub(super) g: Matrix,
    pub(super) j: Matrix,
    pub(super) k: Matrix,
    /// First block row of D.
    pub(super) top: Matrix,
}

#[cfg(test)]
impl Block {
    /// Sum of two blocks of time that are correlated.
    pub(crate) fn plus(&self, other: &Block) -> Block {
        Block {
            e: &self.e + &other.e,
            f: &self.f + &other.f,
            g: &self.g + &other.g,
            j: &self.j + &other.j,
            k: &self.k + &other.k,
            top: &self.top + &other.top,
        }
    }
}

/// Rows of some channels in U, U↓ and Q, which project a change in the rows of these channels alone.
pub(crate) struct Rows {
    channels: Vec<usize>,
    /// Total number of channels.
    count: usize,
    r: Matrix,
    /// Last block row of U.
    last: Matrix,
    u_down: Matrix,
    q: Matrix,
}

impl Rows {
    /// From U and from the QR of U↑, which have one row for each channel and block.
    pub(crate) fn of((u, upper): (&Matrix, &Qr), count: usize, channels: &[usize]) -> Self {
        let those = |m: &Matrix| {
            let blocks = m.rows() / count;
            Matrix::from_fn(blocks * channels.len(), m.columns(), |i, j| {
                m[(i / channels.len() * count + channels[i % channels.len()], j)]
            })
        };
        let (u, k) = (those(u), channels.len());
        Rows {
            u_down: u.block(k, 0, u.rows() - k, u.columns()),
            last: u.block(u.rows() - k, 0, k, u.columns()),
            q: those(&upper.q),
            r: upper.r.clone(),
            channels: channels.to_vec(),
            count,
        }
    }

    /// The change from the rows of D that belong to these channels; the other rows are zero. U↑ = Q R gives Uᵀ D = Rᵀ Qᵀ D↑ and what the last
    /// block row adds.
    pub(crate) fn block(&self, d: &Matrix) -> Block {
        let (k, n) = (self.channels.len(), d.columns());
        let rows = d.rows() - k;
        let (up, down) = (d.block(0, 0, rows, n), d.block(k, 0, rows, n));
        let g = self.q.transpose_times(&up);
        let mut top = Matrix::zeros(self.count, n);
        for j in 0..n {
            for (i, channel) in self.channels.iter().enumerate() {
                top[(*channel, j)] = d[(i, j)];
            }
        }
        Block {
            e: &self.r.transpose_times(&g) + &self.last.transpose_times(&d.block(rows, 0, k, n)),
            f: self.q.transpose_times(&down),
            j: up.transpose_times(&self.u_down),
            k: g.transpose_times(&self.r),
            g,
            top,
        }
    }
}
