//! Correlations of several setups brought to one shaking and stacked, with what each block of time changes in them.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | H_s^ref, H_s^mov | `Setup::references`, `moved` | Hankel matrices of the sensors that stay, that move, with those that stay | r br × r br, m_s br × r br |
//! | U | `basis` | left singular vectors of [H_1^ref … H_S^ref] | r br × n |
//! | Z_s | | Uᵀ H_s^ref: what shook setup s | n × r br |
//! | Z_s⁺ = Q R⁻ᵀ | `Excitation` | from the QR of Z_sᵀ | r br × n |

use super::sensor_places::ChannelPlace;
use crate::modal::correlations::{Correlations, correlate, lags_before};
use crate::modal::subspace::Ssi;
use crate::modal::subspace::of_matrix;
use crate::modal::subspace::{RANK_LEAST, Subspace, subspace};
use crate::modal::subspace::{future_past, side_by_side};
use crate::modal::{Method, ModalError};
use crate::signal::Record;
use dolmen_linalg::{Matrix, qr, solve_lower};

/// Hankel matrices of one setup, sensors turned as the first setup has them.
pub(super) struct Setup {
    /// Of the sensors that stay, in the order of their places.
    references: Matrix,
    /// Of the others.
    moved: Matrix,
    /// Places of the others.
    moved_places: Vec<usize>,
    /// The same of each block's deviation.
    deviations: Vec<[Matrix; 2]>,
    /// Mean square of the sensors that stay.
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
        let lags = lags_before(2 * ssi.block_rows - 1, ssi.decimation);
        let r = correlate(record, lags, ssi.time_blocks)?.decimated(ssi.decimation);
        Ok(Self::of(&r, channel_places, references, ssi.block_rows))
    }

    fn of(r: &Correlations, channel_places: &[ChannelPlace], references: &[usize], br: usize) -> Self {
        let l = r.channels;
        let channel_at = |place: &usize| channel_places.iter().position(|s| s.place == *place);
        let stay: Vec<usize> = references.iter().filter_map(channel_at).collect();
        let move_: Vec<usize> = (0..l).filter(|c| !stay.contains(c)).collect();
        let n = stay.len();
        let split = |whole: &Matrix| {
            let of = |rows: &[usize]| {
                Matrix::from_fn(rows.len() * br, n * br, |i, j| {
                    let c = rows[i % rows.len()];
                    channel_places[c].sign
                        * channel_places[stay[j % n]].sign
                        * whole[(i / rows.len() * l + c, j)]
                })
            };
            [of(&stay), of(&move_)]
        };
        let of_lags = |lags: &Vec<f64>| {
            let beside = side_by_side(lags, l, &stay, br);
            let whole = Matrix::from_fn(l * br, n * br, |i, j| beside[(i % l, i / l * n + j)]);
            split(&whole)
        };
        let [at_references, moved] = split(&future_past(r, &stay, br));
        Setup {
            references: at_references,
            moved,
            moved_places: move_.iter().map(|&c| channel_places[c].place).collect(),
            deviations: r.deviations.iter().map(of_lags).collect(),
            power: stay.iter().map(|&c| r.lag(0)[c * l + c]).sum::<f64>() / n as f64,
            step_s: r.step_s,
        }
    }
}

/// Z_s⁺ as Q R⁻ᵀ.
struct Excitation {
    q: Matrix,
    /// Rᵀ.
    lower: Matrix,
}

impl Excitation {
    fn of(basis: &Matrix, references: &Matrix) -> Result<Self, ModalError> {
        let f = qr(&basis.transpose_times(references).transpose())?;
        Ok(Excitation {
            q: f.q,
            lower: f.r.transpose(),
        })
    }

    /// H^mov Z_s⁺ Z_1.
    fn rescaled(&self, moved: &Matrix, first: &Matrix) -> Result<Matrix, ModalError> {
        Ok(&(moved * &self.q) * &solve_lower(&self.lower, first.clone())?)
    }
}

/// Poles of the stacked correlations, and what each block of time changes in them.
pub(super) fn stacked(
    setups: &[Setup],
    places: usize,
    ssi: &Ssi,
    duration_s: f64,
) -> Result<Subspace, ModalError> {
    let (r, br) = (ssi.references.len(), ssi.block_rows);
    let beside = Matrix::from_fn(r * br, setups.len() * r * br, |i, j| {
        setups[j / (r * br)].references[(i, j % (r * br))]
    });
    let seen = of_matrix(&beside, ssi.order_most)?;
    let rank = seen.s.iter().filter(|s| **s > RANK_LEAST * seen.s[0]).count();
    if ssi.order_most > rank {
        return Err(ModalError::Rank {
            given: ssi.order_most,
            rank,
        });
    }
    let (basis, x) = (seen.u, seen.x);
    let stay: Vec<usize> = {
        let moved: Vec<usize> = setups
            .iter()
            .flat_map(|s| s.moved_places.iter().copied())
            .collect();
        (0..places).filter(|place| !moved.contains(place)).collect()
    };
    // rows of one setup at their places among all
    let place = |whole: &mut Matrix, part: &Matrix, at: &[usize]| {
        for j in 0..part.columns() {
            let column = whole.column_mut(j);
            for (i, x) in part.column(j).iter().enumerate() {
                column[i / at.len() * places + at[i % at.len()]] = *x;
            }
        }
    };
    // U Z_1 is what of the first setup's references the basis spans: every setup has a say in what they see
    let first = basis.transpose_times(&setups[0].references);
    let whole_of = |at_references: &Matrix, of: &dyn Fn(usize) -> Result<Matrix, ModalError>| {
        let mut whole = Matrix::zeros(places * br, r * br);
        place(&mut whole, at_references, &stay);
        for (s, setup) in setups.iter().enumerate() {
            if !setup.moved_places.is_empty() {
                place(&mut whole, &of(s)?, &setup.moved_places);
            }
        }
        Ok::<Matrix, ModalError>(whole)
    };
    let excitations: Vec<Excitation> = setups
        .iter()
        .map(|s| Excitation::of(&basis, &s.references))
        .collect::<Result<_, _>>()?;
    let at_references = &basis * &first;
    let whole = whole_of(&at_references, &|s| {
        excitations[s].rescaled(&setups[s].moved, &first)
    })?;
    let parts = of_matrix(&whole, ssi.order_most)?;
    let blocks: usize = setups.iter().map(|s| s.deviations.len()).sum();
    let mut moved = Vec::with_capacity(blocks);
    for (index, setup) in setups.iter().enumerate() {
        let count = setup.deviations.len() as f64;
        // each setup has its own mean: b/(b - 1) of its own blocks, not of all
        let share = (count / (count - 1.0) * (blocks as f64 - 1.0) / blocks as f64).sqrt();
        for [of_references, of_moved] in &setup.deviations {
            let references = added(&setup.references, of_references);
            let excitation = Excitation::of(&basis, &references)?;
            let first = if index == 0 {
                basis.transpose_times(&references)
            } else {
                first.clone()
            };
            // U Uᵀ H_1 turns with U: (I - U Uᵀ) dH_s X_s Z_1, X = V S⁻¹
            let turned = of_references * &(&x.block(index * r * br, 0, r * br, x.columns()) * &first);
            let inside = &basis * &basis.transpose_times(&turned);
            let at_references = added(&added(&(&basis * &first), &turned), &inside.scaled(-1.0));
            let changed = whole_of(&at_references, &|s| {
                if s == index {
                    excitation.rescaled(&added(&setup.moved, of_moved), &first)
                } else {
                    excitations[s].rescaled(&setups[s].moved, &first)
                }
            })?;
            let mut change = changed;
            for (x, before) in change.as_mut_slice().iter_mut().zip(whole.as_slice()) {
                *x = share * (*x - before);
            }
            moved.push(&change * &parts.x);
        }
    }
    let correlations = Correlations {
        channels: places,
        lags: 0,
        step_s: setups[0].step_s,
        mean: Vec::new(),
        deviations: Vec::new(),
        ends: None,
        padded: None,
    };
    let found = subspace(correlations, ssi, (Method::SsiCov, duration_s), parts)?;
    Ok(Subspace { moved, ..found })
}

fn added(a: &Matrix, b: &Matrix) -> Matrix {
    let mut sum = a.clone();
    for (x, y) in sum.as_mut_slice().iter_mut().zip(b.as_slice()) {
        *x += y;
    }
    sum
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

    /// Re Σ φ λ^k gᵀ of the channels of one setup, g whatever shook it; φ and λ of modes whose frequencies are `more` as large.
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

    /// Sensors 0 and 1 stay, one of them turned round in the second setup; each setup is shaken in its own way.
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
            let deviations = vec![change.clone(), change.iter().map(|x| -x).collect()];
            let r = Correlations {
                channels: l,
                lags: 2 * BLOCK_ROWS - 1,
                step_s: STEP_S,
                mean,
                deviations,
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
        // every block of every setup moves all frequencies by ± ε: each setup alone has 2 × 2 (ε f)², and the three, moved one at a
        // time, move the pole by shares that sum to ε f
        let epsilon = 1e-6;
        let (setups, ssi) = setups(1.0 + epsilon);
        let found = stacked(&setups, 6, &ssi, 100.0).unwrap();
        assert_eq!(found.moved.len(), 6);
        let mut together = found.clone();
        // blocks 0, 2 and 4 at once, and their opposites
        together.moved = (0..2)
            .map(|sign| {
                added(
                    &added(&found.moved[sign], &found.moved[2 + sign]),
                    &found.moved[4 + sign],
                )
            })
            .collect();
        // they were scaled by √(2/1 × 5/6): taken out
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
        // and they move as one: their covariance is the product of their deviations
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let correlation = product(&changes[0], &changes[2])
            / (product(&changes[0], &changes[0]) * product(&changes[2], &changes[2])).sqrt();
        assert!((correlation - 1.0).abs() < 1e-6, "{correlation}");
    }
}
