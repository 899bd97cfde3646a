//! Correlations of several setups, transformed to a common excitation and stacked, with their changes by each block of time.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | H_s^ref, H_s^mov | `Setup::whole` | Hankel matrices of the fixed and of the moved sensors with the fixed ones; never formed | r br
//! × r br, m_s br × r br |
//! | U | `basis` | left singular vectors of [H_1^ref … H_S^ref] | r br × n |
//! | Z_s | | Uᵀ H_s^ref: excitation of setup s | n × r br |
//! | Z_s⁺ = Q R⁻ᵀ | `Excitation` | from the QR of Z_sᵀ | r br × n |
//! | T | `Setup::seen` | H_s^mov Z_s⁺: motion of the moved sensors when that of the fixed ones is U | m_s br × n |
//! | X | `x` | singular vectors of the stacked matrix over its singular values | r br × n |

use super::sensor_places::ChannelPlace;
use crate::modal::correlations::{Correlations, correlate_decimated, wide};
use crate::modal::subspace::{BlockHankel, FuturePast, RANK_LEAST, Rows, Ssi, Subspace};
use crate::modal::subspace::{of_operator, of_product, subspace};
use crate::modal::{Method, ModalError};
use crate::signal::Record;
use dolmen_linalg::{LinalgError, Matrix, Operator, qr, solve_lower, solve_lower_transposed};

/// Hankel matrices of one setup, with the signs of the first setup; fixed sensors come first, in the order of their places.
pub(super) struct Setup {
    whole: FuturePast,
    /// Deviation of each block of time.
    deviations: Vec<BlockHankel>,
    channels: usize,
    /// Number of fixed sensors.
    references: usize,
    moved_places: Vec<usize>,
    /// Mean square of the fixed sensors.
    pub(super) power: f64,
    step_s: f64,
}

impl Setup {
    pub(super) fn new(
        record: &Record,
        channel_places: &[ChannelPlace],
        references: &[usize],
        ssi: &Ssi,
    ) -> Result<Self, ModalError> {
        let lags = (2 * ssi.block_rows - 1, ssi.time_blocks);
        let all: Vec<usize> = (0..record.channels().len()).collect();
        let r = correlate_decimated(record, lags, (ssi.decimation, false), &all)?;
        Ok(Self::of(&r, channel_places, references, ssi.block_rows))
    }

    fn of(r: &Correlations, channel_places: &[ChannelPlace], references: &[usize], br: usize) -> Self {
        let channel_at = |place: &usize| channel_places.iter().position(|s| s.place == *place);
        let stay: Vec<usize> = references.iter().filter_map(channel_at).collect();
        let moved: Vec<usize> = (0..r.channels).filter(|c| !stay.contains(c)).collect();
        let order: Vec<usize> = stay.iter().chain(&moved).copied().collect();
        let signs: Vec<f64> = order.iter().map(|&c| channel_places[c].sign).collect();
        let r = r.arranged(&order, &signs);
        let (l, n) = (order.len(), stay.len());
        let first: Vec<usize> = (0..n).collect();
        Setup {
            whole: FuturePast::new(&r, &first, br),
            deviations: (r.deviations.iter())
                .map(|lags| BlockHankel::new(&wide(lags), [l, l], &first, br))
                .collect(),
            channels: l,
            references: n,
            moved_places: moved.iter().map(|&c| channel_places[c].place).collect(),
            power: (0..n).map(|c| r.lag(0)[c * l + c]).sum::<f64>() / n as f64,
            step_s: r.step_s,
        }
    }

    /// Rows of the fixed sensors, and of the moved sensors.
    fn parted(&self, y: &Matrix) -> [Matrix; 2] {
        let (l, n) = (self.channels, self.references);
        let blocks = y.rows() / l;
        let of = |from: usize, count: usize| {
            Matrix::from_fn(count * blocks, y.columns(), |i, j| {
                y[(i / count * l + from + i % count, j)]
            })
        };
        // a setup may have no moved sensors
        let moved = match l - n {
            0 => Matrix::zeros(0, y.columns()),
            count => of(n, count),
        };
        [of(0, n), moved]
    }

    /// Rows of the fixed sensors, with zeros for the moved ones.
    fn lifted(&self, y: &Matrix) -> Matrix {
        let (l, n) = (self.channels, self.references);
        Matrix::from_fn(y.rows() / n * l, y.columns(), |i, j| match i % l {
            c if c < n => y[(i / l * n + c, j)],
            _ => 0.0,
        })
    }
}

/// [H_1^ref … H_S^ref], never formed.
struct ReferenceHankels<'a> {
    setups: &'a [Setup],
    rows: usize,
}

impl ReferenceHankels<'_> {
    fn formed(&self) -> Result<Matrix, LinalgError> {
        let of_each: Vec<Matrix> = (self.setups.iter())
            .map(|s| Ok(s.parted(&s.whole.times(Matrix::identity(self.rows))?)[0].clone()))
            .collect::<Result<_, LinalgError>>()?;
        Ok(Matrix::from_fn(self.rows, of_each.len() * self.rows, |i, j| {
            of_each[j / self.rows][(i, j % self.rows)]
        }))
    }
}

impl Operator for ReferenceHankels<'_> {
    fn shape(&self) -> [usize; 2] {
        [self.rows, self.setups.len() * self.rows]
    }
    fn times(&self, x: Matrix) -> Result<Matrix, LinalgError> {
        let mut sum = Matrix::zeros(self.rows, x.columns());
        for (s, setup) in self.setups.iter().enumerate() {
            let of_setup = x.block(s * self.rows, 0, self.rows, x.columns());
            sum = &sum + &setup.parted(&setup.whole.times(of_setup)?)[0];
        }
        Ok(sum)
    }
    fn transpose_times(&self, y: Matrix) -> Result<Matrix, LinalgError> {
        let mut all = Matrix::zeros(self.shape()[1], y.columns());
        for (s, setup) in self.setups.iter().enumerate() {
            let of_setup = setup.whole.transpose_times(setup.lifted(&y))?;
            for j in 0..y.columns() {
                all.column_mut(j)[s * self.rows..(s + 1) * self.rows].copy_from_slice(of_setup.column(j));
            }
        }
        Ok(all)
    }
}

/// Z_s⁺ as Q R⁻ᵀ.
struct Excitation {
    q: Matrix,
    /// Rᵀ.
    lower: Matrix,
}

impl Excitation {
    /// From the QR of Z_sᵀ.
    fn of(transposed: &Matrix) -> Result<Self, ModalError> {
        let f = qr(transposed)?;
        Ok(Excitation {
            q: f.q,
            lower: f.r.transpose(),
        })
    }

    /// Z_s⁺ Y.
    fn inverse_times(&self, y: Matrix) -> Result<Matrix, ModalError> {
        Ok(&self.q * &solve_lower(&self.lower, y)?)
    }
}

/// Quantities needed for the deviations of all blocks of time.
struct Stacked<'a> {
    setups: &'a [Setup],
    basis: Matrix,
    /// From the singular value decomposition of [`ReferenceHankels`].
    beside_x: Matrix,
    /// Z_sᵀ.
    transposed: Vec<Matrix>,
    /// T of each setup.
    seen: Vec<Matrix>,
    x: Matrix,
    /// Z_1 X.
    first_x: Matrix,
}

/// Poles of the stacked correlations, and their changes by each block of time.
pub(super) fn stacked(
    setups: &[Setup],
    places: usize,
    ssi: &Ssi,
    duration_s: f64,
) -> Result<Subspace, ModalError> {
    let (rows, n) = (ssi.references.len() * ssi.block_rows, ssi.order_most);
    let beside = ReferenceHankels { setups, rows };
    let shared = of_operator(&beside, n, || beside.formed())?;
    let rank = shared.s.iter().filter(|s| **s > RANK_LEAST * shared.s[0]).count();
    if n > rank {
        return Err(ModalError::Rank { given: n, rank });
    }
    let basis = shared.u;
    let moved_places: Vec<usize> = setups
        .iter()
        .flat_map(|s| s.moved_places.iter().copied())
        .collect();
    let stay: Vec<usize> = (0..places)
        .filter(|place| !moved_places.contains(place))
        .collect();
    let (mut transposed, mut seen) = (Vec::new(), Vec::new());
    // U, and T of each setup, at their places among all sensors
    let mut all = Matrix::zeros(places * ssi.block_rows, n);
    placed(&mut all, &basis, (&stay, places));
    for setup in setups {
        let z = setup.whole.transpose_times(setup.lifted(&basis))?;
        let excitation = Excitation::of(&z)?;
        let [_, moved] = setup.parted(&setup.whole.times(excitation.q)?);
        let of_setup = solve_lower_transposed(&excitation.lower, moved.transpose())?.transpose();
        placed(&mut all, &of_setup, (&setup.moved_places, places));
        seen.push(of_setup);
        transposed.push(z);
    }
    // U Z_1 is the projection of the first setup's references on the basis, to which all setups contribute
    let parts = of_product(&all, &transposed[0])?;
    let stacked = Stacked {
        setups,
        beside_x: shared.x,
        first_x: transposed[0].transpose_times(&parts.x),
        x: parts.x.clone(),
        basis,
        transposed,
        seen,
    };
    let correlations = Correlations {
        channels: places,
        columns: (0..places).collect(),
        step_s: setups[0].step_s,
        mean: Vec::new(),
        deviations: Vec::new(),
        ends: None,
        padded: None,
    };
    let mut found = subspace(correlations, ssi, (Method::SsiCov, duration_s), parts)?;
    let blocks: usize = setups.iter().map(|s| s.deviations.len()).sum();
    for (index, setup) in setups.iter().enumerate() {
        let count = setup.deviations.len() as f64;
        // each setup has its own mean, so the factor is b/(b - 1) of its own blocks
        let share = (count / (count - 1.0) * (blocks as f64 - 1.0) / blocks as f64).sqrt();
        let own: Vec<usize> = stay.iter().chain(&setup.moved_places).copied().collect();
        // the first setup defines the common excitation
        let touched: Vec<usize> = if index == 0 { (0..places).collect() } else { own };
        let rows = Rows::of((&found.u, &found.upper), places, &touched);
        for deviation in &setup.deviations {
            let mut change = Matrix::zeros(touched.len() * ssi.block_rows, n);
            for (part, at) in stacked.changes(index, deviation)? {
                let at = at.unwrap_or(&stay);
                let among: Vec<usize> = (at.iter())
                    .filter_map(|place| touched.iter().position(|t| t == place))
                    .collect();
                placed(&mut change, &part.scaled(share), (&among, touched.len()));
            }
            let block = rows.block(&change);
            found.moved.push(block);
        }
    }
    Ok(found)
}

/// A change of some rows, and the places of their sensors; `None` for the fixed sensors.
type Change<'a> = (Matrix, Option<&'a [usize]>);

impl Stacked<'_> {
    /// First-order change of the stacked matrix times X, when the deviation of one block of time changes the setup at `index`.
    fn changes(&self, index: usize, deviation: &BlockHankel) -> Result<Vec<Change<'_>>, ModalError> {
        let setup = &self.setups[index];
        let (basis, rows) = (&self.basis, self.basis.rows());
        let z = &self.transposed[index] + &deviation.transposed_times(&setup.lifted(basis));
        let first_x = match index {
            0 => z.transpose_times(&self.x),
            _ => self.first_x.clone(),
        };
        // U Uᵀ H_1 changes with U: (I - U Uᵀ) dH_s X_s Z_1, X_s = V S⁻¹
        let weights = &self
            .beside_x
            .block(index * rows, 0, rows, self.beside_x.columns())
            * &first_x;
        let [turned, _] = setup.parted(&deviation.times(&weights));
        let inside = basis.transpose_times(&turned);
        let along = &(&first_x - &self.first_x) - &inside;
        let mut changes = vec![(&(basis * &along) + &turned, None)];
        let weights = Excitation::of(&z)?.inverse_times(first_x.clone())?;
        let sum = &setup.whole.times(weights.clone())? + &deviation.times(&weights);
        for (s, (setup, seen)) in self.setups.iter().zip(&self.seen).enumerate() {
            let now = match s == index {
                true => setup.parted(&sum)[1].clone(),
                false if index == 0 => seen * &first_x,
                false => continue,
            };
            changes.push((
                &now - &(seen * &self.first_x),
                Some(setup.moved_places.as_slice()),
            ));
        }
        Ok(changes)
    }
}

/// Writes the rows of one setup to their places among all sensors: in each block row one row for each of `at`.
fn placed(whole: &mut Matrix, part: &Matrix, (at, places): (&[usize], usize)) {
    for j in 0..part.columns() {
        let column = whole.column_mut(j);
        for (i, x) in part.column(j).iter().enumerate() {
            column[i / at.len() * places + at[i % at.len()]] = *x;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Pole, Propagation};
    use crate::numeric::Random;
    use dolmen_linalg::Complex64;
    use std::f64::consts::PI;

    const STEP_S: f64 = 0.05;
    const BLOCK_ROWS: usize = 10;
    const MODES: [(f64, f64); 3] = [(1.0, 0.01), (2.5, 0.03), (2.55, 0.02)];
    const SHAPES: [[f64; 6]; 3] = [
        [1.0, 0.5, -0.2, 0.3, 0.6, -0.7],
        [0.3, -0.8, 1.0, 0.1, -0.4, 0.2],
        [0.9, 1.0, 0.4, -0.6, 0.2, 0.8],
    ];

    fn lambda((f, zeta): (f64, f64)) -> Complex64 {
        let omega = 2.0 * PI * f;
        (Complex64::new(-zeta, (1.0 - zeta * zeta).sqrt()) * omega * STEP_S).exp()
    }

    /// Re Σ φ λ^k gᵀ for the channels of one setup, with the excitation g and the modes φ, λ; `more` multiplies their frequencies.
    fn lags_of(channels: &[usize], g: &[[Complex64; 6]; 3], more: f64) -> Vec<f64> {
        let entry = |k: usize, a: usize, b: usize| -> f64 {
            let of = MODES.iter().zip(&SHAPES).zip(g);
            of.map(|((mode, phi), g)| (lambda((more * mode.0, mode.1)).powu(k as u32) * phi[a] * g[b]).re)
                .sum()
        };
        (0..2 * BLOCK_ROWS)
            .flat_map(|k| {
                channels
                    .iter()
                    .flat_map(move |&a| channels.iter().map(move |&b| (k, a, b)))
            })
            .map(|(k, a, b)| entry(k, a, b))
            .collect()
    }

    /// Sensors 0 and 1 are fixed; one of them is reversed in the second setup. Each setup has its own excitation.
    fn setups(more: f64) -> (Vec<Setup>, Ssi) {
        let ssi = Ssi {
            block_rows: BLOCK_ROWS,
            order_most: 6,
            references: vec![0, 1],
            ..Ssi::default()
        };
        let mut random = Random::new(11, 0);
        let all = [vec![0, 1, 2, 3], vec![4, 0, 1], vec![1, 5, 0]];
        let setups = all.iter().zip([1.0, 0.02, 7.0]).map(|(channels, gain)| {
            let g =
                [(); 3].map(|()| [(); 6].map(|()| gain * Complex64::new(random.normal(), random.normal())));
            let (mut mean, moved) = (lags_of(channels, &g, 1.0), lags_of(channels, &g, more));
            let mut change: Vec<f64> = moved.iter().zip(&mean).map(|(a, b)| a - b).collect();
            let l = channels.len();
            let channel_places: Vec<ChannelPlace> = channels
                .iter()
                .map(|&place| ChannelPlace {
                    place,
                    sign: if l == 3 && place == 0 { -1.0 } else { 1.0 },
                    known: true,
                })
                .collect();
            for lags in [&mut mean, &mut change] {
                for (i, x) in lags.iter_mut().enumerate() {
                    *x *= channel_places[i / l % l].sign * channel_places[i % l].sign;
                }
            }
            let deviations = [1.0, -1.0].map(|sign| change.iter().map(|x| (sign * x) as f32).collect());
            let r = Correlations {
                channels: l,
                columns: (0..l).collect(),
                step_s: STEP_S,
                mean,
                deviations: deviations.to_vec(),
                ends: None,
                padded: None,
            };
            Setup::of(&r, &channel_places, &[0, 1], BLOCK_ROWS)
        });
        (setups.collect(), ssi)
    }

    #[test]
    fn exact_poles_and_shapes_of_a_structure_cut_into_setups_shaken_each_in_its_own_way() {
        let (setups, ssi) = setups(1.0);
        let found = stacked(&setups, 6, &ssi, 100.0).unwrap();
        let at_six: Vec<&Pole> = found.poles.iter().filter(|p| p.order == 6).collect();
        assert_eq!(at_six.len(), 3);
        for ((pole, (f, zeta)), phi) in at_six.iter().zip(MODES).zip(SHAPES) {
            assert!((pole.frequency_hz / f - 1.0).abs() < 1e-9, "{pole:?}");
            assert!((pole.damping_ratio - zeta).abs() < 1e-9, "{pole:?}");
            for (z, phi) in pole.shape.iter().zip(phi) {
                assert!((z - phi).norm() < 1e-8, "{pole:?}");
            }
        }
    }

    #[test]
    fn exact_scatter_of_setups_whose_frequencies_move_together() {
        // every block of every setup changes all frequencies by ± ε: each setup alone has 2 × 2 (ε f)². The changes of the three
        // setups, one at a time, change the pole by shares with the sum ε f
        let epsilon = 1e-6;
        let (setups, ssi) = setups(1.0 + epsilon);
        let found = stacked(&setups, 6, &ssi, 100.0).unwrap();
        assert_eq!(found.moved.len(), 6);
        let mut together = found.clone();
        // blocks 0, 2 and 4 together, and their opposites
        together.moved = (0..2)
            .map(|sign| {
                let two = found.moved[sign].plus(&found.moved[2 + sign]);
                two.plus(&found.moved[4 + sign])
            })
            .collect();
        // without the factor √(2/1 × 5/6)
        let share = (2.0_f64 * 5.0 / 6.0).sqrt();
        let mut propagation = Propagation::new(&together);
        let mut changes = Vec::new();
        for (pole, (f, _)) in found.poles.iter().filter(|p| p.order == 6).zip(MODES) {
            let sd_hz = propagation.frequency_sd_hz(pole).unwrap();
            assert!(
                (sd_hz / (share * 2.0 * epsilon * f) - 1.0).abs() < 1e-3,
                "{sd_hz} {f}"
            );
            changes.push(propagation.deviation(pole).unwrap().frequency_changes_hz);
        }
        // they change together: their covariance is the product of their standard deviations
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let correlation = product(&changes[0], &changes[2])
            / (product(&changes[0], &changes[0]) * product(&changes[2], &changes[2])).sqrt();
        assert!((correlation - 1.0).abs() < 1e-6, "{correlation}");
    }
}
