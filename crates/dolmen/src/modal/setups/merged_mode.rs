//! Merges one mode of several setups: each shape is scaled at the known places and combined with the others.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | φ_s | `b` | shape in setup s at the places that earlier setups have too | references × 1 |
//! | r | `a` | shape from the earlier setups at these places | references × 1 |
//! | α_s | `scale` | factor on the shape of setup s | - |

use super::agreement::{Agreement, Estimate, Mean, mean};
use super::pairing::{ObservedMode, ObservedPoint};
use super::sensor_places::{ChannelPlace, SensorPlaces};
use crate::modal::indicators::{assurance, normalized, phase_collinearity};
use crate::modal::{ModalError, Mode};
use dolmen_linalg::Complex64;

/// How one mode was merged.
#[derive(Clone, Debug, PartialEq)]
pub struct MergedMode {
    /// Frequency in each setup, Hz.
    pub frequency_hz: Vec<f64>,
    /// Damping ratio in each setup.
    pub damping_ratio: Vec<Option<f64>>,
    /// Factor on the shape of each setup; 1 for the first.
    pub scale: Vec<Complex64>,
    /// Assurance (MAC) between the shape of each setup and the earlier ones at their common places; `None` for the first setup, and with
    /// fewer than two places.
    pub reference_assurance: Vec<Option<f64>>,
    /// Whether the setups agree on the frequency.
    pub frequency: Agreement,
    /// Whether the setups agree on the damping ratio; `None` if one has none.
    pub damping: Option<Agreement>,
    /// Degrees of freedom of the standard deviations, if they come from the differences between setups: number of setups minus one. `None`
    /// if they come from those of each setup.
    pub degrees_of_freedom: Option<f64>,
    /// Whether another pairing was nearly as good in any setup.
    pub doubtful: bool,
}

#[derive(Clone)]
pub(super) struct MergingMode {
    pub(super) members: Vec<Mode>,
    scale: Vec<Complex64>,
    reference_assurance: Vec<Option<f64>>,
    pub(super) doubtful: bool,
    /// For each place: sum of the scaled components, sum of their variances, and their number.
    sum: Vec<Complex64>,
    variance: Vec<f64>,
    count: Vec<f64>,
}

impl MergingMode {
    pub(super) fn of(mode: &Mode) -> Self {
        MergingMode {
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

    /// The mode, to be paired with the modes of the next setup.
    pub(super) fn observed(&self, places: &SensorPlaces) -> ObservedMode {
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

    /// Scales a mode of the next setup to this mode, and adds its components.
    pub(super) fn add(&mut self, mode: &Mode, channel_places: &[ChannelPlace], places: usize) {
        let turned: Vec<Complex64> = mode
            .shape
            .iter()
            .zip(channel_places)
            .map(|(x, s)| x * s.sign)
            .collect();
        let own = variances(mode);
        let known: Vec<(usize, ChannelPlace)> = channel_places
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
        // first order, from the noise of both at the references: var α = Σ |b|² (var a + |α|² var b) / (Σ |b|²)²
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
        for (c, channel_place) in channel_places.iter().enumerate() {
            self.sum[channel_place.place] += scale * turned[c];
            self.variance[channel_place.place] +=
                scale.norm_sqr() * own[c] + scale_variance * turned[c].norm_sqr();
            self.count[channel_place.place] += 1.0;
        }
        self.reference_assurance
            .push((known.len() > 1).then(|| assurance(&a, &b)));
        self.scale.push(scale);
        self.members.push(mode.clone());
    }

    /// Changes of the mean by the blocks of time of each setup in turn, multiplied by the same factor as the standard deviation of the mean.
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

    pub(super) fn finished(&self) -> Result<(Mode, MergedMode), ModalError> {
        let first = &self.members[0];
        let raw: Vec<Complex64> = (0..self.sum.len()).map(|place| self.component(place)).collect();
        let most = raw.iter().map(|x| x.norm()).fold(0.0, f64::max);
        let sds = self.variance.iter().zip(&self.count).map(|(v, n)| v.sqrt() / n);
        let shape_sd: Vec<f64> = sds.map(|sd| if most > 0.0 { sd / most } else { sd }).collect();
        let of = |value: fn(&Mode) -> Option<Estimate>| -> Option<Vec<Estimate>> {
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
            wander: first.wander,
            window_bias: first.window_bias,
            accepted: self.members.iter().find_map(|m| m.accepted),
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
