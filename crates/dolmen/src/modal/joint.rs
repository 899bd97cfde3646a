//! Several setups as one identification: their correlations brought to one shaking and stacked (PreGER).
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | H_s^ref, H_s^mov | `Setup::references`, `moved` | Hankel matrices of the sensors that stay, that move, with those that stay | r br × r br, m_s br × r br |
//! | U | `basis` | left singular vectors of [H_1^ref … H_S^ref] | r br × n |
//! | Z_s | | Uᵀ H_s^ref: what shook setup s | n × r br |
//! | Z_s⁺ = Q R⁻ᵀ | `Shaking` | from the QR of Z_sᵀ | r br × n |

use super::clusters::Cluster;
use super::correlations::{Correlations, correlate, lags_before};
use super::decomposed::of_matrix;
use super::hankel::{future_past, side_by_side};
use super::identify::{check, judge_channels, judged, modes_of, pick, remark, spectrum, wanted};
use super::machines::{split_tones, test_for_machines};
use super::places::{Places, Seat};
use super::settings::{Settings, choose};
use super::ssi::{self, Ssi, Subspace, subspace};
use super::stabilization::{AllOrders, Criteria, Stabilization};
use super::{Identify, Method, ModalError, Mode, Modes, Note, Propagation};
use crate::signal::Record;
use dolmen_linalg::{Matrix, qr, solve_lower};

/// Peaks of two setups so near, relative, are one.
const ONE_PEAK: f64 = 0.03;

/// Several setups identified as one.
#[derive(Clone, Debug)]
pub struct JointSetups {
    /// The modes at all sensors.
    pub modes: Modes,
    /// Indices, in `modes.channels`, of the sensors that every setup has.
    pub references: Vec<usize>,
    /// Every pole with its verdict.
    pub stabilization: Stabilization,
    /// Every group of poles with its fate.
    pub clusters: Vec<Cluster>,
    /// What was chosen from the data.
    pub settings: Settings,
    /// Strength of the motion of the sensors that stay in each setup over that of the first: root of their mean squares.
    pub strength: Vec<f64>,
    /// What must be known beside the modes.
    pub notes: Vec<Note>,
}

/// Modes of several setups from one identification (pre-identification global estimation re-scaling).
///
/// ```text
/// [H_1^ref … H_S^ref] = U S Vᵀ,   Z_s = Uᵀ H_s^ref                         first n columns of U
/// H = [U Z_1; H_1^mov Z_1⁺ Z_1; H_2^mov Z_2⁺ Z_1; … H_S^mov Z_S⁺ Z_1]             shape: l br × r br, l all sensors, r those that stay
/// ```
/// then as [`ssi_cov`](super::ssi_cov()). The sensors that stay see U in every setup and only Z_s differs with the shaking, so that
/// Z_s⁺ Z_1 turns what the moved sensors saw into what they had seen in the first setup. The settings are chosen from the
/// peaks of all setups. Standard deviations: first order, the blocks of time of each setup by themselves.
///
/// # Errors
/// [`ModalError::Setups`] with fewer than two; [`ModalError::NoCommonReference`], [`ModalError::SetupRate`]; else as
/// [`identify`](super::identify()).
///
/// # Limits
/// The setups are one structure: frequencies that moved between them (weather, moved mass) do not show, each mode is smeared over them; putting
/// them together after identification (`merge_setups`) tells. A mode that none of the sensors that stay sees is lost. Machines are told by
/// the spectrum of each setup and by the least kurtosis of all. A sensor that several setups have, but not all, counts as the last of them shows it.
///
/// # Source
/// Mevel, Basseville, Benveniste & Goursat (2002) Mech. Syst. Signal Process. 16:759-783; Döhler, Andersen & Mevel (2010) Proc. IMAC
/// XXVIII, the strategy called PreGER there. Differs from the sources: Z_s⁺ from a QR; in the deviations of the
/// moved sensors U is held (its change cancels to first order).
pub fn joint_setups(
    records: &[Record],
    options: &Identify,
    place_within_m: f64,
) -> Result<JointSetups, ModalError> {
    let [first, others @ ..] = records else {
        return Err(ModalError::Setups { given: 0 });
    };
    if others.is_empty() {
        return Err(ModalError::Setups { given: 1 });
    }
    let mut places = Places::of(first.channels());
    let own = (0..first.channels().len()).map(|place| Seat {
        place,
        sign: 1.0,
        known: false,
    });
    let mut seats: Vec<Vec<Seat>> = vec![own.collect()];
    for (i, record) in others.iter().enumerate() {
        let (given_hz, first_hz) = (record.sampling_rate_hz(), first.sampling_rate_hz());
        if (given_hz / first_hz - 1.0).abs() > 1e-9 {
            return Err(ModalError::SetupRate {
                setup: i + 2,
                given_hz,
                first_hz,
            });
        }
        seats.push(places.seats(record.channels(), i + 1, place_within_m)?);
    }
    let references = places.seen_by(records.len());
    if references.is_empty() {
        return Err(ModalError::NoCommonReference {
            setups: records.len(),
        });
    }
    let options = Identify {
        method: Method::SsiCov,
        references: (0..references.len()).collect(),
        ..options.clone()
    };
    let mut notes = Vec::new();
    let (peaks, tones_hz) = peaks_of_all(records, &options, &mut notes)?;
    let shortest = records.iter().min_by_key(|r| r.length()).unwrap_or(first);
    let settings = choose(shortest, &options, (&peaks, &tones_hz), &mut notes)?;
    let ssi = ssi::check(&settings.ssi(&options.references), places.channels.len())?;
    let duration_s: f64 = records.iter().map(Record::duration_s).sum();
    let mut setups = Vec::with_capacity(records.len());
    for (record, seats) in records.iter().zip(&seats) {
        setups.push(Setup::new(record, seats, &references, &ssi)?);
    }
    let strength: Vec<f64> = setups
        .iter()
        .map(|s| (s.power / setups[0].power).sqrt())
        .collect();
    // each setup alone must explain how well a pole is known: the floor is that of the mean setup
    let found = stacked(
        &setups,
        places.channels.len(),
        &ssi,
        duration_s / records.len() as f64,
    )?;
    let criteria = Criteria {
        frequency_low_hz: options.criteria.frequency_low_hz.max(settings.range_hz[0]),
        frequency_high_hz: options.criteria.frequency_high_hz.min(settings.range_hz[1]),
        ..options.criteria.clone()
    };
    let (stabilization, clusters) = judged(
        &AllOrders::of(&found),
        &mut Propagation::new(&found),
        &criteria,
        &options.clustering,
    )?;
    let mut modes = Modes {
        modes: modes_of(&clusters, duration_s),
        channels: places.channels,
        method: Method::SsiCov,
        duration_s,
        history: first.history().to_vec(),
    };
    let places_of = |seats: &Vec<Seat>| seats.iter().map(|s| s.place).collect();
    let seen: Vec<(&Record, Vec<usize>)> = records.iter().zip(seats.iter().map(places_of)).collect();
    test_for_machines(&seen, &options, &mut modes, &mut notes)?;
    pick(&options, &mut modes)?;
    wanted(&options, &modes)?;
    remark(&modes, &peaks, &mut notes);
    Ok(JointSetups {
        modes,
        references,
        stabilization,
        clusters,
        settings,
        strength,
        notes,
    })
}

/// Peaks of the spectra of all setups that are no machines, each once, and the machines' frequencies, Hz.
fn peaks_of_all(
    records: &[Record],
    options: &Identify,
    notes: &mut Vec<Note>,
) -> Result<(Modes, Vec<f64>), ModalError> {
    let mut all: Option<Modes> = None;
    let mut tones_hz = Vec::new();
    for record in records {
        // references are counted among the sensors that stay, and the spectrum takes all
        check(record, options)?;
        notes.extend(judge_channels(record)?);
        let mut peaks = spectrum(record, options)?;
        let least = options.criteria.damping_ratio_least;
        tones_hz.extend(split_tones(record, &mut peaks, least, notes)?);
        match &mut all {
            None => all = Some(peaks.modes),
            Some(all) => {
                for mode in peaks.modes.modes {
                    let same = |m: &Mode| (m.frequency_hz / mode.frequency_hz - 1.0).abs() < ONE_PEAK;
                    if !all.modes.iter().any(same) {
                        all.modes.push(mode);
                    }
                }
            }
        }
    }
    let mut all = all.ok_or(ModalError::Setups { given: 0 })?;
    all.modes
        .sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    tones_hz.sort_by(f64::total_cmp);
    tones_hz.dedup_by(|a, b| (*a / *b - 1.0).abs() < ONE_PEAK);
    Ok((all, tones_hz))
}

/// Hankel matrices of one setup, sensors turned as the first setup has them.
struct Setup {
    /// Of the sensors that stay, in the order of their places.
    references: Matrix,
    /// Of the others.
    moved: Matrix,
    /// Places of the others.
    moved_places: Vec<usize>,
    /// The same of each block's deviation.
    deviations: Vec<[Matrix; 2]>,
    /// Mean square of the sensors that stay.
    power: f64,
    step_s: f64,
}

impl Setup {
    fn new(record: &Record, seats: &[Seat], references: &[usize], ssi: &Ssi) -> Result<Self, ModalError> {
        let lags = lags_before(2 * ssi.block_rows - 1, ssi.decimation);
        let r = correlate(record, lags, ssi.time_blocks)?.decimated(ssi.decimation);
        Ok(Self::of(&r, seats, references, ssi.block_rows))
    }

    fn of(r: &Correlations, seats: &[Seat], references: &[usize], br: usize) -> Self {
        let l = r.channels;
        let channel_at = |place: &usize| seats.iter().position(|s| s.place == *place);
        let stay: Vec<usize> = references.iter().filter_map(channel_at).collect();
        let move_: Vec<usize> = (0..l).filter(|c| !stay.contains(c)).collect();
        let n = stay.len();
        let split = |whole: &Matrix| {
            let of = |rows: &[usize]| {
                Matrix::from_fn(rows.len() * br, n * br, |i, j| {
                    let c = rows[i % rows.len()];
                    seats[c].sign * seats[stay[j % n]].sign * whole[(i / rows.len() * l + c, j)]
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
            moved_places: move_.iter().map(|&c| seats[c].place).collect(),
            deviations: r.deviations.iter().map(of_lags).collect(),
            power: stay.iter().map(|&c| r.lag(0)[c * l + c]).sum::<f64>() / n as f64,
            step_s: r.step_s,
        }
    }
}

/// Z_s⁺ as Q R⁻ᵀ.
struct Shaking {
    q: Matrix,
    /// Rᵀ.
    lower: Matrix,
}

impl Shaking {
    fn of(basis: &Matrix, references: &Matrix) -> Result<Self, ModalError> {
        let f = qr(&basis.transpose_times(references).transpose())?;
        Ok(Shaking {
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
fn stacked(setups: &[Setup], places: usize, ssi: &Ssi, duration_s: f64) -> Result<Subspace, ModalError> {
    let (r, br) = (ssi.references.len(), ssi.block_rows);
    let beside = Matrix::from_fn(r * br, setups.len() * r * br, |i, j| {
        setups[j / (r * br)].references[(i, j % (r * br))]
    });
    let seen = of_matrix(&beside, ssi.order_most)?;
    let rank = seen
        .s
        .iter()
        .filter(|s| **s > ssi::RANK_LEAST * seen.s[0])
        .count();
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
    let shakings: Vec<Shaking> = setups
        .iter()
        .map(|s| Shaking::of(&basis, &s.references))
        .collect::<Result<_, _>>()?;
    let at_references = &basis * &first;
    let whole = whole_of(&at_references, &|s| {
        shakings[s].rescaled(&setups[s].moved, &first)
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
            let shaken = Shaking::of(&basis, &references)?;
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
                    shaken.rescaled(&added(&setup.moved, of_moved), &first)
                } else {
                    shakings[s].rescaled(&setups[s].moved, &first)
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
    use super::super::Pole;
    use super::*;
    use crate::numeric::Random;
    use crate::signal::Channel;
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
            let seats: Vec<Seat> = channels
                .iter()
                .map(|&place| Seat {
                    place,
                    sign: if l == 3 && place == 0 { -1.0 } else { 1.0 },
                    known: true,
                })
                .collect();
            for lags in [&mut mean, &mut change] {
                for (i, x) in lags.iter_mut().enumerate() {
                    *x *= seats[i / l % l].sign * seats[i % l].sign;
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
            Setup::of(&r, &seats, &[0, 1], BLOCK_ROWS)
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

    #[test]
    fn refuses_setups_without_a_common_sensor_or_of_other_rates() {
        let record = |names: &[&str], rate_hz: f64| {
            let mut random = Random::new(1, 0);
            let samples = names.iter().map(|_| (0..4000).map(|_| random.normal()).collect());
            Record::new(
                names.iter().map(|n| Channel::named(*n)).collect(),
                samples.collect(),
                rate_hz,
            )
            .unwrap()
        };
        let refusal = |records: &[Record]| {
            joint_setups(records, &Identify::default(), 0.1)
                .unwrap_err()
                .to_string()
        };
        let (ab, bc, ca) = (
            record(&["a", "b"], 100.0),
            record(&["b", "c"], 100.0),
            record(&["c", "a"], 100.0),
        );
        let fault = refusal(&[ab.clone(), bc, ca]);
        assert!(fault.starts_with("no sensor is in all 3 setups"), "{fault}");
        let fault = refusal(&[ab.clone(), record(&["a", "d"], 50.0)]);
        assert!(
            fault.starts_with("setup 2 has 50 samples a second, the first 100"),
            "{fault}"
        );
        assert!(refusal(&[ab]).starts_with("1 setups are given"));
    }
}
