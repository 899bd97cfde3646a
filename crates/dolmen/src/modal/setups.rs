//! Several setups of one survey, each identified by itself, put together by the sensors that stayed.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | φ_s | `b` | a shape in setup s at the places that are known already | references × 1 |
//! | r | `a` | what the setups before show there | references × 1 |
//! | α_s | `scale` | what setup s must be multiplied by | - |
//! | f_s, σ_s | | frequency (or damping ratio) in setup s and its deviation | - |

use super::indicators::{assurance, normalized, phase_collinearity};
use super::pairing::{ObservedMode, ObservedPoint, Pairing, pair_modes};
use super::places::{Places, Seat};
use super::{ModalError, Mode, Modes};
use crate::numeric::chi_squared_above;
use dolmen_linalg::Complex64;

/// Options of [`merge_setups`].
#[derive(Clone, Debug, PartialEq)]
pub struct MergeSetups {
    /// How modes of two setups are paired; default 5 % of frequency, else as [`Pairing`].
    pub pairing: Pairing,
}

impl Default for MergeSetups {
    fn default() -> Self {
        MergeSetups {
            pairing: Pairing {
                frequency_within: 0.05,
                ..Pairing::default()
            },
        }
    }
}

/// Whether the setups agree on one number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Deviation of the single setups about their mean, √(Σ (x - mean)²/(S - 1)).
    pub spread: f64,
    /// Σ (x - mean)²/σ²; `None` where a deviation is not known.
    pub chi_squared: Option<f64>,
    /// Probability of so much or more by chance, χ² with S - 1 degrees of freedom.
    pub p: Option<f64>,
}

impl Agreement {
    /// Whether the setups differ beyond chance: in about 1 of 100 cases; in 2 where deviations come from 30 blocks of time, in up to 6 from 10,
    /// for χ² takes them as known.
    pub fn differs(&self) -> bool {
        const CHANCE: f64 = 0.01; // ours: ten modes and no change give a false alarm in one of ten surveys
        self.p.is_some_and(|p| p < CHANCE)
    }
}

/// How one mode came together.
#[derive(Clone, Debug, PartialEq)]
pub struct MergedMode {
    /// Frequency in each setup, Hz.
    pub frequency_hz: Vec<f64>,
    /// Damping ratio in each setup.
    pub damping_ratio: Vec<Option<f64>>,
    /// What the shape of each setup was multiplied by; 1 for the first.
    pub scale: Vec<Complex64>,
    /// Assurance of each setup's shape with those before it, at the places both show; `None` for the first, and with fewer than two.
    pub reference_assurance: Vec<Option<f64>>,
    /// Whether the setups agree on the frequency.
    pub frequency: Agreement,
    /// Whether they agree on the damping ratio; `None` where one has none.
    pub damping: Option<Agreement>,
    /// Degrees of freedom of the deviations where they come from how far the setups differ: one less than setups. `None` where they come from
    /// the deviations of each setup, and have theirs.
    pub degrees_of_freedom: Option<f64>,
    /// Whether another pairing was nearly as good in any setup.
    pub doubtful: bool,
}

/// A mode that not every setup shows.
#[derive(Clone, Debug, PartialEq)]
pub struct PartialMode {
    /// Its frequency, Hz, in the first setup that shows it.
    pub frequency_hz: f64,
    /// Setups that show it, from 0.
    pub setups: Vec<usize>,
}

/// Several setups as one.
#[derive(Clone, Debug, PartialEq)]
pub struct MergedSetups {
    /// The modes that every setup shows, at all sensors.
    pub modes: Modes,
    /// How each came together, in the same order.
    pub merged: Vec<MergedMode>,
    /// Modes that some setups do not show: left out.
    pub partial: Vec<PartialMode>,
    /// Indices, in `modes.channels`, of the sensors that more than one setup has.
    pub references: Vec<usize>,
}

/// Modes of several setups put together (post-separate estimation re-scaling).
///
/// ```text
/// α_s = φ_s* r / φ_s* φ_s                     least squares of α φ_s = r at the places that setups before s show
/// mean f = Σ f_s/σ_s² / Σ 1/σ_s²,   χ² = Σ (f_s - mean)²/σ_s²,   sd = √(1/Σ 1/σ_s²) √max(1, χ²/(S - 1))
/// ```
/// Setup after setup: its modes are paired with those of the setups before by frequency and by their shapes at the places that both
/// show, scaled, and laid beside; where several setups show a place, their mean stands. Where setups disagree on a number the
/// deviation of the mean is widened by √(χ²/(S - 1)).
///
/// # Errors
/// [`ModalError::Setups`] with fewer than two setups; [`ModalError::NoReference`] for a setup that shares no sensor with those before it.
///
/// # Limits
/// A reference near a node of a mode scales it badly: the deviation of the shape holds that, and `reference_assurance` shows it. With one
/// reference there is no such check.
///
/// # Source
/// Reynders, Magalhães, De Roeck & Cunha (2009) Proc. IMAC XXVII; Döhler, Andersen & Mevel (2010) Proc. IMAC XXVIII, the strategy called
/// PoSER there. Widened deviation: Birge (1932) Phys. Rev. 40:207. Differs from the sources: each setup is scaled to the mean of those
/// before it, and not to the first alone, so that references may change from setup to setup.
pub fn merge_setups(setups: &[Modes], options: &MergeSetups) -> Result<MergedSetups, ModalError> {
    let [first, others @ ..] = setups else {
        return Err(ModalError::Setups { given: 0 });
    };
    if others.is_empty() {
        return Err(ModalError::Setups { given: 1 });
    }
    let mut places = Places::of(&first.channels);
    let mut growing: Vec<Growing> = first.modes.iter().map(Growing::of).collect();
    let mut partial = Vec::new();
    for (index, setup) in others.iter().enumerate() {
        let number = index + 1;
        let seats = places.seats(&setup.channels, number, options.pairing.place_within_m)?;
        let known: Vec<ObservedMode> = growing.iter().map(|g| g.observed(&places)).collect();
        let paired = pair_modes(&known, &ObservedMode::all(setup, 0), &options.pairing)?;
        for &alone in &paired.only_first {
            partial.push(PartialMode {
                frequency_hz: growing[alone].members[0].frequency_hz,
                setups: (0..number).collect(),
            });
        }
        partial.extend(paired.only_second.iter().map(|&alone| PartialMode {
            frequency_hz: setup.modes[alone].frequency_hz,
            setups: vec![number],
        }));
        let mut next = Vec::with_capacity(paired.pairs.len());
        for pair in &paired.pairs {
            let mut mode = growing[pair.first].clone();
            mode.doubtful |= pair.doubtful();
            mode.add(&setup.modes[pair.second], &seats, places.channels.len());
            next.push(mode);
        }
        growing = next;
    }
    partial.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    let mut found = Vec::with_capacity(growing.len());
    for mode in &growing {
        found.push(mode.finished()?);
    }
    found.sort_by(|a, b| a.0.frequency_hz.total_cmp(&b.0.frequency_hz));
    let (modes, merged) = found.into_iter().unzip();
    let references = places.seen_by(2);
    Ok(MergedSetups {
        modes: Modes {
            modes,
            channels: places.channels,
            method: first.method,
            duration_s: setups.iter().map(|s| s.duration_s).sum(),
            history: first.history.clone(),
        },
        merged,
        partial,
        references,
    })
}

/// A mode as the setups so far show it.
#[derive(Clone)]
struct Growing {
    members: Vec<Mode>,
    scale: Vec<Complex64>,
    reference_assurance: Vec<Option<f64>>,
    doubtful: bool,
    /// Sum of the scaled components at each place, of their variances, and how many there are.
    sum: Vec<Complex64>,
    variance: Vec<f64>,
    count: Vec<f64>,
}

impl Growing {
    fn of(mode: &Mode) -> Self {
        Growing {
            members: vec![mode.clone()],
            scale: vec![Complex64::ONE],
            reference_assurance: vec![None],
            doubtful: false,
            sum: mode.shape.clone(),
            variance: variances(mode),
            count: vec![1.0; mode.shape.len()],
        }
    }

    fn component(&self, place: usize) -> Complex64 {
        self.sum[place] / self.count[place]
    }

    /// As it is paired with the modes of the next setup.
    fn observed(&self, places: &Places) -> ObservedMode {
        let points = self.sum.iter().zip(&places.channels).enumerate();
        let shape = points
            .map(|(place, (_, channel))| ObservedPoint {
                channel: channel.clone(),
                component: self.component(place),
            })
            .collect();
        let n = self.members.len() as f64;
        ObservedMode {
            frequency_hz: self.members.iter().map(|m| m.frequency_hz).sum::<f64>() / n,
            shape,
            ..ObservedMode::of(&self.members[0], &[], 0)
        }
    }

    /// Scales a mode of the next setup to this one, and lays it beside.
    fn add(&mut self, mode: &Mode, seats: &[Seat], places: usize) {
        let turned: Vec<Complex64> = mode.shape.iter().zip(seats).map(|(x, s)| x * s.sign).collect();
        let own = variances(mode);
        let known: Vec<(usize, Seat)> = seats
            .iter()
            .copied()
            .enumerate()
            .filter(|(_, s)| s.known)
            .collect();
        let a: Vec<Complex64> = known.iter().map(|(_, s)| self.component(s.place)).collect();
        let b: Vec<Complex64> = known.iter().map(|(c, _)| turned[*c]).collect();
        let power: f64 = b.iter().map(|x| x.norm_sqr()).sum();
        let inner: Complex64 = b.iter().zip(&a).map(|(b, a)| b.conj() * a).sum();
        let scale = if power > 0.0 {
            inner / power
        } else {
            Complex64::ONE
        };
        // first order, of the noise of both at the references: var α = Σ |b|² (var a + |α|² var b) / (Σ |b|²)²
        let of_references = known.iter().zip(&b).map(|((c, s), b)| {
            let before = self.variance[s.place] / self.count[s.place].powi(2);
            b.norm_sqr() * (before + scale.norm_sqr() * own[*c])
        });
        let scale_variance = if power > 0.0 {
            of_references.sum::<f64>() / (power * power)
        } else {
            f64::INFINITY
        };
        self.sum.resize(places, Complex64::ZERO);
        self.variance.resize(places, 0.0);
        self.count.resize(places, 0.0);
        for (c, seat) in seats.iter().enumerate() {
            self.sum[seat.place] += scale * turned[c];
            self.variance[seat.place] += scale.norm_sqr() * own[c] + scale_variance * turned[c].norm_sqr();
            self.count[seat.place] += 1.0;
        }
        self.reference_assurance
            .push((known.len() > 1).then(|| assurance(&a, &b)));
        self.scale.push(scale);
        self.members.push(mode.clone());
    }

    /// Changes of the mean by the blocks of time of one setup after the other, widened as its deviation is.
    fn frequency_changes_hz(&self, mean: &Mean) -> Vec<f64> {
        let known =
            |m: &Mode| m.frequency_sd_hz.is_some_and(|sd| sd > 0.0) && !m.frequency_changes_hz.is_empty();
        let (Some(sd), true) = (mean.sd, self.members.iter().all(known)) else {
            return Vec::new();
        };
        let weights = self
            .members
            .iter()
            .map(|m| m.frequency_sd_hz.map_or(0.0, |sd| sd.powi(-2)));
        let total: f64 = weights.clone().sum();
        let widened = sd * total.sqrt();
        let of = |(m, weight): (&Mode, f64)| -> Vec<f64> {
            m.frequency_changes_hz
                .iter()
                .map(|d| widened * weight / total * d)
                .collect()
        };
        self.members.iter().zip(weights).flat_map(of).collect()
    }

    fn finished(&self) -> Result<(Mode, MergedMode), ModalError> {
        let first = &self.members[0];
        let raw: Vec<Complex64> = (0..self.sum.len()).map(|place| self.component(place)).collect();
        let most = raw.iter().map(|x| x.norm()).fold(0.0, f64::max);
        let sds = self.variance.iter().zip(&self.count).map(|(v, n)| v.sqrt() / n);
        let shape_sd: Vec<f64> = sds.map(|sd| if most > 0.0 { sd / most } else { sd }).collect();
        let of = |value: fn(&Mode) -> Option<Known>| -> Option<Vec<Known>> {
            self.members.iter().map(value).collect()
        };
        let frequencies = of(|m| Some((m.frequency_hz, m.frequency_sd_hz))).unwrap_or_default();
        let frequency = mean(&frequencies)?;
        let damping = match of(|m| m.damping_ratio.map(|zeta| (zeta, m.damping_ratio_sd))) {
            Some(known) => Some(mean(&known)?),
            None => None,
        };
        let shape = normalized(&raw);
        let mode = Mode {
            frequency_hz: frequency.value,
            frequency_sd_hz: frequency.sd,
            frequency_changes_hz: self.frequency_changes_hz(&frequency),
            damping_ratio: damping.as_ref().map(|d| d.value),
            damping_ratio_sd: damping.as_ref().and_then(|d| d.sd),
            phase_collinearity: phase_collinearity(&shape),
            shape,
            shape_sd: self
                .members
                .iter()
                .all(|m| m.shape_sd.is_some())
                .then_some(shape_sd),
            cycles: self.members.iter().map(|m| m.cycles).sum(),
            orders: first.orders.clone(),
            kurtosis: first.kurtosis,
            window_bias: first.window_bias,
        };
        let merged = MergedMode {
            frequency_hz: self.members.iter().map(|m| m.frequency_hz).collect(),
            damping_ratio: self.members.iter().map(|m| m.damping_ratio).collect(),
            scale: self.scale.clone(),
            reference_assurance: self.reference_assurance.clone(),
            degrees_of_freedom: damping.as_ref().map_or(frequency.degrees_of_freedom, |d| {
                frequency.degrees_of_freedom.or(d.degrees_of_freedom)
            }),
            frequency: frequency.agreement,
            damping: damping.map(|d| d.agreement),
            doubtful: self.doubtful,
        };
        Ok((mode, merged))
    }
}

fn variances(mode: &Mode) -> Vec<f64> {
    match &mode.shape_sd {
        Some(sd) => sd.iter().map(|sd| sd * sd).collect(),
        None => vec![0.0; mode.shape.len()],
    }
}

/// A number of one setup and its deviation, if that is known.
type Known = (f64, Option<f64>);

/// A number of several setups.
struct Mean {
    value: f64,
    sd: Option<f64>,
    /// Of the deviation, where the spread of the setups made it.
    degrees_of_freedom: Option<f64>,
    agreement: Agreement,
}

/// By inverse variance where all deviations are known, else the plain mean with the deviation of its parts.
fn mean(all: &[Known]) -> Result<Mean, ModalError> {
    let n = all.len() as f64;
    let known: Option<Vec<f64>> = all.iter().map(|(_, sd)| sd.filter(|sd| *sd > 0.0)).collect();
    let plain = all.iter().map(|(x, _)| x).sum::<f64>() / n;
    let squares = |about: f64| all.iter().map(move |(x, _)| (x - about).powi(2));
    let spread = (squares(plain).sum::<f64>() / (n - 1.0)).sqrt();
    let Some(sds) = known else {
        return Ok(Mean {
            value: plain,
            sd: Some(spread / n.sqrt()),
            degrees_of_freedom: Some(n - 1.0),
            agreement: Agreement {
                spread,
                chi_squared: None,
                p: None,
            },
        });
    };
    let weight: f64 = sds.iter().map(|sd| sd.powi(-2)).sum();
    let value = all
        .iter()
        .zip(&sds)
        .map(|((x, _), sd)| x / (sd * sd))
        .sum::<f64>()
        / weight;
    let chi_squared: f64 = squares(value)
        .zip(&sds)
        .map(|(square, sd)| square / (sd * sd))
        .sum();
    let widened = (chi_squared / (n - 1.0)).max(1.0).sqrt();
    Ok(Mean {
        value,
        sd: Some(widened / weight.sqrt()),
        degrees_of_freedom: (widened > 1.0).then_some(n - 1.0),
        agreement: Agreement {
            spread,
            chi_squared: Some(chi_squared),
            p: Some(chi_squared_above(chi_squared, (all.len() - 1) as f64)?),
        },
    })
}

#[cfg(test)]
mod tests {
    use super::super::{Method, ReferenceCase};
    use super::*;
    use crate::signal::Channel;

    #[test]
    fn exact_changes_of_a_mean_sum_to_its_variance_widened_where_the_setups_differ() {
        for factor in [1.0, 1.003] {
            let mut setups = [
                setup(&[0, 1, 2], Complex64::ONE, 1.0),
                setup(&[0, 1, 3], Complex64::ONE, factor),
            ];
            for (s, setup) in setups.iter_mut().enumerate() {
                for (i, mode) in setup.modes.iter_mut().enumerate() {
                    // modes of one setup move alike in its first block, apart in its second
                    let apart = if i % 2 == 0 { 0.6 } else { -0.6 };
                    mode.frequency_sd_hz = Some(0.002 * (s + 1) as f64);
                    mode.frequency_changes_hz = [0.8, apart].map(|c| c * 0.002 * (s + 1) as f64).to_vec();
                }
            }
            let found = merge_setups(&setups, &MergeSetups::default())
                .unwrap()
                .modes
                .modes;
            for mode in &found {
                let square: f64 = mode.frequency_changes_hz.iter().map(|d| d * d).sum();
                assert_eq!(mode.frequency_changes_hz.len(), 4);
                assert!(
                    (square.sqrt() / mode.frequency_sd_hz.unwrap() - 1.0).abs() < 1e-12,
                    "{mode:?}"
                );
            }
            // .8² − .6² of the variances
            let pairs = found[0]
                .frequency_changes_hz
                .iter()
                .zip(&found[1].frequency_changes_hz);
            let product: f64 = pairs.map(|(a, b)| a * b).sum();
            let sds = found[0].frequency_sd_hz.unwrap() * found[1].frequency_sd_hz.unwrap();
            assert!((product / sds - 0.28).abs() < 1e-12, "{product} {sds}");
        }
    }

    /// Exact modes of four floors, seen at the channels named, each shape scaled by itself.
    fn setup(channels: &[usize], scale: Complex64, factor: f64) -> Modes {
        let made = ReferenceCase::ClosePairs.made(0).unwrap();
        let mode = |m: &super::super::MadeMode| Mode {
            frequency_hz: factor * m.frequency_hz,
            frequency_sd_hz: Some(0.002),
            frequency_changes_hz: Vec::new(),
            damping_ratio: Some(m.damping_ratio),
            damping_ratio_sd: Some(0.001),
            shape: channels.iter().map(|c| scale * m.shape[*c]).collect(),
            shape_sd: Some(vec![0.01; channels.len()]),
            phase_collinearity: 1.0,
            cycles: 600.0 * m.frequency_hz,
            orders: vec![8],
            kurtosis: None,
            window_bias: None,
        };
        Modes {
            modes: made.modes.iter().map(mode).collect(),
            channels: channels.iter().map(|c| Channel::named(format!("s{c}"))).collect(),
            method: Method::SsiCov,
            duration_s: 600.0,
            history: Vec::new(),
        }
    }

    #[test]
    fn exact_shapes_come_back_whole_whatever_the_scale_of_each_setup() {
        let setups = [
            setup(&[6, 7, 0, 1], Complex64::ONE, 1.0),
            setup(&[2, 6, 3, 7], Complex64::new(-0.3, 0.2), 1.0),
            setup(&[4, 5, 3, 2], Complex64::new(0.0, 2.0), 1.0), // references of the second setup alone
        ];
        let found = merge_setups(&setups, &MergeSetups::default()).unwrap();
        assert_eq!((found.modes.modes.len(), found.partial.len()), (8, 0));
        let names: Vec<&str> = found.modes.channels.iter().map(|c| c.name.as_str()).collect();
        assert_eq!(names, ["s6", "s7", "s0", "s1", "s2", "s3", "s4", "s5"]);
        assert_eq!(found.references, [0, 1, 4, 5]);
        let truth = ReferenceCase::ClosePairs.made(0).unwrap().modes;
        for (mode, truth) in found.modes.modes.iter().zip(&truth) {
            let whole: Vec<Complex64> = [6, 7, 0, 1, 2, 3, 4, 5]
                .map(|c: usize| Complex64::new(truth.shape[c], 0.0))
                .to_vec();
            assert!(assurance(&mode.shape, &whole) > 1.0 - 1e-12, "{mode:?}");
            assert!((mode.frequency_hz - truth.frequency_hz).abs() < 1e-12);
            assert!((mode.frequency_sd_hz.unwrap() - 0.002 / 3.0_f64.sqrt()).abs() < 1e-15);
        }
        for merged in &found.merged {
            assert!(
                merged.reference_assurance[1..]
                    .iter()
                    .all(|mac| mac.is_some_and(|mac| mac > 1.0 - 1e-12))
            );
            assert!(!merged.frequency.differs());
        }
    }

    #[test]
    fn exact_mean_by_inverse_variance_and_chi_squared_by_hand() {
        let found = mean(&[(1.0, Some(0.1)), (1.3, Some(0.2))]).unwrap();
        // weights 100 and 25: (100 + 32.5)/125 = 1.06; χ² = .06²·100 + .24²·25 = 1.8
        assert!((found.value - 1.06).abs() < 1e-14);
        assert!((found.agreement.chi_squared.unwrap() - 1.8).abs() < 1e-12);
        assert!((found.sd.unwrap() - (1.8_f64 / 125.0).sqrt()).abs() < 1e-14);
        assert_eq!(found.degrees_of_freedom, Some(1.0)); // two setups that differ say so once
        let agree = mean(&[(1.0, Some(0.1)), (1.05, Some(0.2))]).unwrap();
        assert_eq!(agree.degrees_of_freedom, None);
        let bare = mean(&[(1.0, None), (1.3, None), (1.1, None)]).unwrap();
        assert_eq!(bare.degrees_of_freedom, Some(2.0));
        assert!((found.agreement.p.unwrap() - libm::erfc(0.9_f64.sqrt())).abs() < 1e-14);
    }

    #[test]
    fn holds_setups_that_disagree_are_said_and_the_deviation_is_widened() {
        let setups = [
            setup(&[6, 7, 0], Complex64::ONE, 1.0),
            setup(&[6, 7, 1], Complex64::ONE, 1.01),
        ];
        let found = merge_setups(&setups, &MergeSetups::default()).unwrap();
        for (mode, merged) in found.modes.modes.iter().zip(&found.merged) {
            let half = 0.005 * merged.frequency_hz[0]; // of the difference: sd of the mean, by the parts alone
            assert!(merged.frequency.differs() && (mode.frequency_sd_hz.unwrap() / half - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn holds_a_mode_that_one_setup_does_not_show_is_left_out_and_named() {
        let mut second = setup(&[6, 7, 1], Complex64::ONE, 1.0);
        let lost = second.modes.remove(2);
        let found = merge_setups(
            &[setup(&[6, 7, 0], Complex64::ONE, 1.0), second],
            &MergeSetups::default(),
        )
        .unwrap();
        assert_eq!(found.modes.modes.len(), 7);
        assert_eq!(
            found.partial,
            [PartialMode {
                frequency_hz: lost.frequency_hz,
                setups: vec![0],
            }]
        );
    }

    #[test]
    fn refuses_one_setup_and_setups_without_a_reference() {
        let one = setup(&[0, 1], Complex64::ONE, 1.0);
        let message = merge_setups(std::slice::from_ref(&one), &MergeSetups::default())
            .unwrap_err()
            .to_string();
        assert!(message.starts_with("1 setups are given"), "{message}");
        let other = setup(&[2, 3], Complex64::ONE, 1.0);
        let message = merge_setups(&[one, other], &MergeSetups::default())
            .unwrap_err()
            .to_string();
        assert!(
            message.starts_with("setup 2 has no sensor in common"),
            "{message}"
        );
    }
}
