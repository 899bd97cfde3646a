//! Identifies several setups together: their correlations are transformed to one excitation and stacked (PreGER).

use super::common_excitation::{Setup, stacked};
use super::merge_setups::{MergeSetups, MergedSetups};
use super::pairing::{ObservedMode, pair_modes};
use super::sensor_places::{ChannelPlace, SensorPlaces};
use crate::modal::accept::{accepted, candidates, join, taken_out};
use crate::modal::candidate::Candidate;
use crate::modal::quality::doubt_channels;
use crate::modal::quality::remark;
use crate::modal::quality::{ClippedRecord, leave_out_clipped};
use crate::modal::quality::{Diagram, leave_out_combs, of_steady, split_tones, test_for_machines};
use crate::modal::settings::{Seen, Settings, choose};
use crate::modal::shared_steps::{
    check, clipped_record, judge_channels, judged, modes_of, note_blends, note_filter, pick, spectrum, wanted,
};
use crate::modal::spectrum::BuriedPeak;
use crate::modal::subspace::check_ssi;
use crate::modal::subspace::{AllOrders, Stabilization};
use crate::modal::subspace::{Cluster, Clustering};
use crate::modal::{Identify, Method, ModalError, Mode, Modes, Note, Propagation, Refusal};
use crate::signal::Record;

/// Relative difference below which peaks of two setups are the same.
const ONE_PEAK: f64 = 0.03;

/// Largest relative difference of the frequencies of one mode in several setups. Our choice.
const ONE_MODE: f64 = 0.01;

/// Several setups identified together.
#[derive(Clone, Debug)]
pub struct JointSetups {
    /// The modes at all sensors.
    pub modes: Modes,
    /// Indices, in `modes.channels`, of the sensors in every setup.
    pub references: Vec<usize>,
    /// Every pole with its verdict.
    pub stabilization: Stabilization,
    /// Every cluster of poles with its verdict.
    pub clusters: Vec<Cluster>,
    /// Settings chosen from the data.
    pub settings: Settings,
    /// Root mean square of the fixed sensors in each setup over that in the first setup.
    pub strength: Vec<f64>,
    /// Notes on the modes.
    pub notes: Vec<Note>,
}

impl JointSetups {
    /// Frequencies, Hz, of the modes of `merged` that are missing here, including modes found only in single setups.
    ///
    /// # Errors
    /// As [`pair_modes`].
    pub fn not_shown_hz(&self, merged: &MergedSetups) -> Result<Vec<f64>, ModalError> {
        let own = ObservedMode::all(&self.modes, 0);
        let together = ObservedMode::all(&merged.modes, 0);
        let options = MergeSetups::default().pairing;
        let paired = pair_modes(&together, &own, &options)?;
        let lost = paired.only_first.iter().map(|&i| together[i].frequency_hz);
        let mut frequency_hz: Vec<f64> = lost.collect();
        // a mode of some setups has no shape at all sensors: it is paired by frequency with the remaining modes
        let mut free: Vec<f64> = paired.only_second.iter().map(|&j| own[j].frequency_hz).collect();
        for mode in &merged.partial {
            let near = |hz: &f64| (hz / mode.frequency_hz - 1.0).abs() <= ONE_PEAK;
            match free.iter().position(near) {
                Some(at) if mode.unlike_in.is_empty() => drop(free.remove(at)),
                Some(_) => {} // its counterparts in other setups are the same
                None => frequency_hz.push(mode.frequency_hz),
            }
        }
        frequency_hz.sort_by(f64::total_cmp);
        frequency_hz.dedup_by(|a, b| (*a / *b - 1.0).abs() <= ONE_MODE);
        Ok(frequency_hz)
    }
}

/// Modes of several setups from one identification (pre-identification global estimation re-scaling).
///
/// ```text
/// [H_1^ref … H_S^ref] = U S Vᵀ,   Z_s = Uᵀ H_s^ref                         first n columns of U
/// H = [U Z_1; H_1^mov Z_1⁺ Z_1; H_2^mov Z_2⁺ Z_1; … H_S^mov Z_S⁺ Z_1]             shape: l br × r br, l all sensors, r fixed ones
/// ```
/// then as [`ssi_cov`](crate::modal::ssi_cov()). The fixed sensors have the same U in every setup; only Z_s depends on the excitation. So Z_s⁺
/// Z_1 transforms the motion of the moved sensors to the excitation of the first setup. The settings are chosen from the peaks of all setups.
/// Standard deviations are of first order, from the blocks of time of each setup separately.
///
/// # Errors
/// [`ModalError::Setups`] with fewer than two; [`ModalError::NoCommonReference`], [`ModalError::SetupRate`]; otherwise as
/// [`identify`](crate::modal::identify()).
///
/// # Limits
/// The setups are assumed to measure the same structure: frequencies that change between them (weather, moved mass) are not detected and blur
/// each mode. Merging after identification (`merge_setups`) shows such changes. A mode without motion at the fixed sensors is lost. Machines are
/// detected by the spectrum of each setup and by the least kurtosis of all. A sensor in several setups, but not all, has the component of the
/// last one.
///
/// # Source
/// Mevel, Basseville, Benveniste & Goursat (2002) Mech. Syst. Signal Process. 16:759-783; Döhler, Andersen & Mevel (2010) Proc. IMAC XXVIII,
/// which calls the strategy PreGER. Differs from the sources: Z_s⁺ from a QR; U is constant in the standard deviations of the moved sensors (its
/// change cancels to first order).
pub fn joint_setups(
    records: &[Record],
    options: &Identify,
    place_within_m: f64,
) -> Result<JointSetups, ModalError> {
    let [first, ..] = records else {
        return Err(ModalError::Setups { given: 0 });
    };
    let (places, channel_places) = common_places(records, place_within_m)?;
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
    let all = peaks_of_all(records, &options, &mut notes)?;
    let shortest = records.iter().min_by_key(|r| r.length()).unwrap_or(first);
    let mut settings = choose(shortest, &options, &all.seen(), &mut notes)?;
    let peaks = all.peaks;
    let ssi = check_ssi(&settings.ssi(), places.channels.len())?;
    // indices among all sensors, not among the fixed ones
    settings.references.clone_from(&references);
    let duration_s: f64 = records.iter().map(Record::duration_s).sum();
    let mut setups = Vec::with_capacity(records.len());
    for (record, channel_places) in records.iter().zip(&channel_places) {
        setups.push(Setup::new(record, channel_places, &references, &ssi)?);
    }
    let strength: Vec<f64> = setups
        .iter()
        .map(|s| (s.power / setups[0].power).sqrt())
        .collect();
    // the standard deviation of a pole is compared with the lower bound of the mean setup
    let mean_s = duration_s / records.len() as f64;
    let found = stacked(&setups, places.channels.len(), &ssi, mean_s)?;
    let channels = records.iter().map(|r| r.channels().len()).sum::<usize>() as f64 / records.len() as f64;
    let past = channels / references.len() as f64;
    let clustering = Clustering {
        // the past includes only the fixed sensors: with a third of all sensors, standard deviations are up to three times as large
        deviation_over_floor_most: past.sqrt() * options.clustering.deviation_over_floor_most,
        ..options.clustering.clone()
    };
    let mut deviations = Propagation::new(&found);
    let (stabilization, clusters) = judged(
        &AllOrders::of(&found),
        &mut deviations,
        &options.criteria.within(settings.range_hz),
        &clustering,
    )?;
    let diagram = Diagram {
        stabilization: &stabilization,
        clusters: &clusters,
        clustering: &clustering,
        duration_s,
    };
    // no setup shows the complete shape of a peak: only the poles give the modes
    let no_peaks = Modes {
        modes: Vec::new(),
        ..peaks.clone()
    };
    let mut refused = candidates(&options, (&no_peaks, &[]), &diagram, &mut deviations)?;
    note_blends(&clusters, &mut notes);
    let mut modes = Modes {
        modes: modes_of(&clusters, duration_s),
        channels: places.channels,
        method: Method::SsiCov,
        duration_s,
        history: first.history().to_vec(),
    };
    let places_of = |channel_places: &Vec<ChannelPlace>| channel_places.iter().map(|s| s.place).collect();
    let seen: Vec<(&Record, Vec<usize>)> = records.iter().zip(channel_places.iter().map(places_of)).collect();
    let of_setups = (&seen[..], all.clipped);
    refused.extend(leave_out_made(of_setups, &options, &mut modes, &mut notes)?);
    let peaks_hz: Vec<f64> = peaks.modes.iter().map(|mode| mode.frequency_hz).collect();
    let insisted = accepted(&options, &modes.modes, (&refused, &peaks_hz), &mut notes);
    let not_picked_hz = pick(&options, &mut modes)?;
    wanted(&options, &modes)?;
    let mut of_channels = Vec::new();
    doubt_channels(&modes, &mut of_channels);
    join(insisted, &mut modes.modes, &mut notes);
    remark(&modes, (&peaks, &|_| None), not_picked_hz, &mut notes);
    notes.extend(of_channels);
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

/// Removes and returns the modes that machines and clipping make. Each setup comes with the places of its channels.
fn leave_out_made(
    (seen, clipped): (&[(&Record, Vec<usize>)], Vec<ClippedRecord<'_>>),
    options: &Identify,
    modes: &mut Modes,
    notes: &mut Vec<Note>,
) -> Result<Vec<Candidate>, ModalError> {
    let before = modes.modes.clone();
    test_for_machines(seen, options, modes, notes)?;
    let mut made = taken_out(&before, &modes.modes, of_steady);
    let before = modes.modes.clone();
    leave_out_combs(modes, notes);
    made.extend(taken_out(&before, &modes.modes, |_| Refusal::Machine));
    let each = clipped.into_iter().zip(seen);
    let placed = each.map(|(of, (_, places))| ClippedRecord {
        places: places.clone(),
        ..of
    });
    let clipped: Vec<ClippedRecord<'_>> = placed.collect();
    let before = modes.modes.clone();
    leave_out_clipped(&clipped, modes, notes)?;
    made.extend(taken_out(&before, &modes.modes, |_| Refusal::Clipping));
    Ok(made)
}

/// The places of all sensors, and of the channels of each record.
fn common_places(
    records: &[Record],
    place_within_m: f64,
) -> Result<(SensorPlaces, Vec<Vec<ChannelPlace>>), ModalError> {
    let [first, others @ ..] = records else {
        return Err(ModalError::Setups { given: 0 });
    };
    if others.is_empty() {
        return Err(ModalError::Setups { given: 1 });
    }
    let mut places = SensorPlaces::of(first.channels());
    let own = (0..first.channels().len()).map(|place| ChannelPlace {
        place,
        sign: 1.0,
        known: false,
    });
    let mut channel_places: Vec<Vec<ChannelPlace>> = vec![own.collect()];
    for (i, record) in others.iter().enumerate() {
        let (given_hz, first_hz) = (record.sampling_rate_hz(), first.sampling_rate_hz());
        if (given_hz / first_hz - 1.0).abs() > 1e-9 {
            return Err(ModalError::SetupRate {
                setup: i + 2,
                given_hz,
                first_hz,
            });
        }
        channel_places.push(places.channel_places(record.channels(), i + 1, place_within_m)?);
    }
    Ok((places, channel_places))
}

/// What the spectra of all setups show.
struct PeaksOfAll<'a> {
    /// Peaks, each once and without machines.
    peaks: Modes,
    /// Peaks of smaller singular values or wider averages alone, each once.
    buried: Vec<BuriedPeak>,
    /// Frequencies of machines, Hz.
    tones_hz: Vec<f64>,
    /// The setups with their clipped channels.
    clipped: Vec<ClippedRecord<'a>>,
}

impl PeaksOfAll<'_> {
    fn seen(&self) -> Seen<'_> {
        Seen {
            peaks: &self.peaks,
            buried: &self.buried,
            tones_hz: &self.tones_hz,
        }
    }
}

fn peaks_of_all<'a>(
    records: &'a [Record],
    options: &Identify,
    notes: &mut Vec<Note>,
) -> Result<PeaksOfAll<'a>, ModalError> {
    let mut all: Option<Modes> = None;
    let (mut tones_hz, mut buried, mut clipped) = (Vec::new(), Vec::new(), Vec::new());
    for record in records {
        // indices of references refer to the fixed sensors, but the spectrum uses all sensors
        check(record, options)?;
        let of_channels = judge_channels(record)?;
        clipped.push(clipped_record(record, options, &of_channels));
        notes.extend(of_channels);
        note_filter(record, options, notes);
        let mut peaks = spectrum(record, options)?;
        tones_hz.extend(split_tones(record, &mut peaks, options, notes)?.tones_hz);
        buried.append(&mut peaks.buried);
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
    buried.sort_by(|a, b| a.mode.frequency_hz.total_cmp(&b.mode.frequency_hz));
    buried.dedup_by(|a, b| (a.mode.frequency_hz / b.mode.frequency_hz - 1.0).abs() < ONE_PEAK);
    Ok(PeaksOfAll {
        peaks: all,
        buried,
        tones_hz,
        clipped,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use crate::signal::Channel;

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
