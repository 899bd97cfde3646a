//! Modes of a structure from a record with measured base motion.

use super::driven_modes::Driven;
use super::followed_inputs::{driven_modes, responses, segment_for};
use super::ground_ratios::{OffGround, off_ground};
use super::lowest_response::lowest_response_hz;
use super::observer::{Fit, Measured, coefficients_of, observe};
use super::realization::{Realization, Realize, realize};
use super::refused_inputs::{refuse_alike, refuse_sine, refuse_unrelated};
use super::responses::FrequencyResponses;
use crate::modal::accept::{accepted, candidates, put_in};
use crate::modal::modal_analysis::{ModalAnalysis, of_peaks};
use crate::modal::options::Identify;
use crate::modal::quality::{Diagram, Quantities, to_one_quantity};
use crate::modal::settings::{Seen, Settings, choose};
use crate::modal::shared_steps::{judged, modes_of, note_blends, pick, spectrum, wanted};
use crate::modal::subspace::{AllOrders, Cluster, Clustering, Fate, Stabilization, group_poles};
use crate::modal::{Method, ModalError, Mode, Modes, Note};
use crate::signal::{Record, decimate, leave_out};

/// Largest number of coefficients of an observer: more take seconds. Our choice.
const COEFFICIENTS_MOST: usize = 600;
/// Fewest samples per coefficient. Our choice.
const SAMPLES_A_COEFFICIENT: usize = 8;
/// Samples per period of the highest mode. The ground reacts to the structure within a sample. This changes the frequencies of a simulated frame
/// by 0.1 % with 4 samples, 0.03 % with 6 and less than 0.01 % with 13.
const SAMPLES_A_PERIOD: f64 = 10.0;
/// Number of blocks of time. Their scores are independent even if the blocks are short.
const BLOCKS: usize = 100;
/// Assumed noise over the standard deviation of a channel; the first value that gives a stable observer is used. For a simulated frame with 2 %
/// noise all three give the same frequencies to 1e-4.
const NOISE: [f64; 3] = [0.003, 0.01, 0.03];
/// Possible noise of the sensors over the standard deviation of a channel. It biases least squares, most at frequencies where the ground hardly
/// moves, which are those of the structure on a fixed base. Its true size is unknown, so the standard deviations include its effect. Our choice.
const NOISE_ALLOWED: f64 = 0.02;
/// Largest standard deviation of a frequency over the lower bound for ambient vibration. Structure and ground together have no resonance at the
/// frequency of the fixed base, so this frequency is less accurate if wind excites the structure more than the ground does. Our choice; poles
/// that fit noise start near 10.
const FLOOR_MOST: f64 = 8.0;
/// Duration below which a record is short, s: its channels may have no peak at the lowest mode, and poles that fit noise are stable. Our choice: longer
/// records show their modes by themselves.
const SHORT_S: f64 = 90.0;
/// Largest ratio of deviation over bound of a mode to the smallest one in a short record, where it exceeds that of other methods. What excites one mode
/// little excites the others little, too: in made records of ground and wind the ratio of true modes is at most 4.9 for three storeys, and that of poles
/// of noise in short earthquakes at least 15. Our choice.
const FLOOR_OVER_BEST: f64 = 11.0;
/// Modes of the structure on a base that is fixed at the inputs: the motion of the inputs is given.
///
/// ```text
/// y_t = Σ_{i=1..p} A_i y_{t-i} + Σ_{k=0..p} B_k u_{t-k} + e_t                  least squares over all samples
/// ```
/// The regression contains past outputs and inputs, so the cause of the ground motion does not matter: it may be seismic waves or the structure
/// itself, whose motion reaches the ground a sample later.
///
/// `ambient` identifies the record without its inputs.
///
/// # Errors
/// As `ambient`; [`ModalError::InputsAlike`], [`ModalError::InputsSine`], [`ModalError::NoObserver`].
///
/// # Limits
/// Motion that no input measures is not fixed: on a rocking base without a rotation sensor, the modes are those of the rocking structure.
/// Rotation and translation of one base come from the same shaking, so their effects as inputs cannot be distinguished: refused.
pub(crate) fn of_driven(
    (record, options): (&Record, &Identify),
    mut notes: Vec<Note>,
    ambient: &dyn Fn(&Record, &Identify) -> Result<ModalAnalysis, ModalError>,
) -> Result<ModalAnalysis, ModalError> {
    let name = |c: &usize| record.channels()[*c].name.clone();
    let names: Vec<String> = options.inputs.iter().map(name).collect();
    let named: Vec<&str> = names.iter().map(String::as_str).collect();
    let outputs = leave_out(record.clone(), &named)?;
    let free = Identify {
        inputs: Vec::new(),
        references: Vec::new(),
        method: Method::SsiCov,
        // the user gives frequencies of the structure on a fixed base
        pick_hz: Vec::new(),
        accept_hz: Vec::new(),
        ..options.clone()
    };
    let peaks = spectrum(&outputs, &free)?;
    let dense = Identify {
        decimation: dense_decimation(record, options, &peaks.modes),
        // an observer needs no correlations of blocks
        time_blocks: 0,
        ..free.clone()
    };
    let seen = with_lowest(&peaks.modes, (record, &options.inputs));
    // an observer needs no more poles than the peaks
    let mut settings = choose(&outputs, &dense, &Seen::peaks_alone(&seen), &mut notes)?;
    let slower = match settings.decimation {
        1 => record.clone(),
        factor => decimate(record.clone(), factor)?,
    };
    refuse_sine(&slower, &options.inputs)?;
    refuse_alike(&slower, &options.inputs, settings.range_hz)?;
    let lags = lags_within(&slower, options.inputs.len(), &mut settings);
    let (mut found, noise) = realized(&slower, (options, lags), &settings)?;
    let mut poles = found.poles.clone();
    Quantities::of(outputs.channels()).judge_as_one(&mut poles);
    let all = AllOrders {
        poles: &poles,
        duration_s: record.duration_s(),
        order_most: settings.order_most,
        order_step: 2,
    };
    let (stabilization, clusters, clustering) = grouped(&all, &mut found, (options, settings.range_hz))?;
    let diagram = Diagram {
        stabilization: &stabilization,
        clusters: &clusters,
        clustering: &clustering,
        duration_s: record.duration_s(),
    };
    // a peak of the spectrum belongs to structure and ground together: only the poles give the modes
    let mut no_peaks = peaks.modes.clone();
    no_peaks.modes.clear();
    let refused = candidates(options, (&no_peaks, &[]), &diagram, &mut found)?;
    note_blends(&clusters, &mut notes);
    let mut analysis = of_peaks(peaks, &outputs, &free);
    analysis.modes = Modes {
        modes: modes_of(&clusters, record.duration_s()),
        channels: outputs.channels().to_vec(),
        method: Method::Okid,
        duration_s: record.duration_s(),
        history: record.history().to_vec(),
    };
    (settings.time_blocks, settings.time_blocks_effective) = (BLOCKS, BLOCKS);
    settings.references = Vec::new();
    analysis.stabilization = stabilization;
    analysis.clusters = clusters;
    analysis.hankel_singular_values = found.singular_values;
    analysis.settings = settings;
    to_one_quantity(&mut analysis.modes, &mut notes);
    let groups = analysis.clusters.iter();
    let poles_hz: Vec<f64> = groups.map(|group| group.medoid.frequency_hz).collect();
    let insisted = accepted(options, &analysis.modes.modes, (&refused, &poles_hz), &mut notes);
    let not_picked_hz = pick(options, &mut analysis.modes)?;
    notes.extend((!not_picked_hz.is_empty()).then_some(Note::NotPicked {
        frequency_hz: not_picked_hz,
    }));
    wanted(options, &analysis.modes)?;
    put_in(&outputs, &free, insisted, &mut analysis.modes, &mut notes)?;
    let together = ambient(record, &free).ok().map(|of| of.modes);
    let modes = driven_modes((&slower, &options.inputs), &analysis.modes, together.as_ref());
    let of_found = modes
        .iter()
        .zip(&analysis.modes.modes)
        .filter(|(_, mode)| mode.is_found());
    refuse_unrelated(of_found.map(|(of, _)| of))?;
    let responses = responses(&slower, &options.inputs, &analysis.modes);
    analysis.driven = Some(Driven {
        inputs: names,
        lags,
        noise,
        off_ground: off_their_ground(record, options, (responses.as_ref(), &analysis.modes)),
        responses,
        modes,
    });
    analysis.notes = notes;
    Ok(analysis)
}

/// The poles judged and grouped, and the limits of the groups: those of ambient vibration, with wider deviations.
fn grouped(
    all: &AllOrders<'_>,
    found: &mut Realization,
    (options, range_hz): (&Identify, [f64; 2]),
) -> Result<(Stabilization, Vec<Cluster>, Clustering), ModalError> {
    let mut criteria = options.criteria.within(range_hz);
    criteria.deviation_over_floor_most = criteria.deviation_over_floor_most.max(FLOOR_MOST);
    let mut clustering = options.clustering.clone();
    let least = clustering.deviation_over_floor_most;
    clustering.deviation_over_floor_most = least.max(FLOOR_MOST);
    let (stabilization, mut clusters) = judged(all, found, &criteria, &clustering)?;
    let by_best = floor_by_best(&clusters, all.duration_s).map(|of| of.max(least));
    let is_lower = |most: &f64| all.duration_s < SHORT_S && *most < clustering.deviation_over_floor_most;
    if let Some(most) = by_best.filter(is_lower) {
        clustering.deviation_over_floor_most = most;
        clusters = group_poles(all, found, &stabilization, &clustering)?;
    }
    Ok((stabilization, clusters, clustering))
}

/// [`FLOOR_OVER_BEST`] times the smallest deviation of a mode over its bound; `None` without modes.
fn floor_by_best(clusters: &[Cluster], duration_s: f64) -> Option<f64> {
    let modes = clusters.iter().filter(|of| of.fate == Fate::Mode);
    let ratios = modes.filter_map(|of| {
        let sd_hz = of.deviation.as_ref()?.frequency_sd_hz;
        Some(sd_hz / of.medoid.floor_hz(duration_s))
    });
    ratios.reduce(f64::min).map(|best| FLOOR_OVER_BEST * best)
}

/// The peaks, and below them the lowest resonance above the inputs if the record is short.
fn with_lowest(peaks: &Modes, (record, inputs): (&Record, &[usize])) -> Modes {
    let mut all = peaks.clone();
    if record.duration_s() >= SHORT_S {
        return all;
    }
    let lowest = lowest_response_hz(record, inputs, segment_for(record, inputs, 0.0));
    let below = all.modes.first().cloned().zip(lowest);
    if let Some((first, frequency_hz)) = below.filter(|(first, hz)| *hz < first.frequency_hz) {
        all.modes.insert(
            0,
            Mode {
                frequency_hz,
                ..first
            },
        );
    }
    all
}

/// Channels that contradict their ground, by the responses below the lowest mode that was found.
fn off_their_ground(
    record: &Record,
    options: &Identify,
    (responses, modes): (Option<&FrequencyResponses>, &Modes),
) -> Vec<OffGround> {
    let lowest = modes.modes.iter().find(|mode| mode.is_found());
    responses.zip(lowest).map_or_else(Vec::new, |(of, lowest)| {
        let measured = (record.channels(), options.inputs.as_slice());
        off_ground(of, measured, lowest.frequency_hz)
    })
}

/// The requested factor, or otherwise the factor that gives [`SAMPLES_A_PERIOD`] in a period of the highest peak.
fn dense_decimation(record: &Record, options: &Identify, peaks: &Modes) -> Option<usize> {
    let highest = peaks.modes.last().map(|mode| mode.frequency_hz);
    let highest_hz = options.frequency_high_hz.or(highest);
    let fast = highest_hz.map(|hz| (record.sampling_rate_hz() / (SAMPLES_A_PERIOD * hz)) as usize);
    options.decimation.or(fast.map(|factor| factor.max(1)))
}

/// Number of past samples: the longest lag of a subspace method, limited by the record and the computing time.
fn lags_within(record: &Record, inputs: usize, settings: &mut Settings) -> usize {
    let outputs = record.channels().len() - inputs;
    let most = COEFFICIENTS_MOST.min(record.length() / SAMPLES_A_COEFFICIENT);
    let wished = 2 * settings.block_rows;
    let allowed = (1..=wished).take_while(|lags| coefficients_of(outputs, inputs, *lags) <= most);
    let lags = allowed.last().unwrap_or(1);
    settings.block_rows = settings.block_rows.min(lags).max(2);
    settings.order_most = settings
        .order_most
        .min(outputs * (settings.block_rows - 1) / 2 * 2)
        .max(2);
    lags
}

/// The realization with the smallest assumed noise that gives a possible structure, and this noise.
fn realized(
    record: &Record,
    (options, lags): (&Identify, usize),
    settings: &Settings,
) -> Result<(Realization, f64), ModalError> {
    let scaled = |channel: usize| -> (Vec<f64>, f64) {
        let samples = record.samples(channel);
        let count = samples.len() as f64;
        let mean = samples.iter().sum::<f64>() / count;
        let power = samples.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / count;
        let scale = power.sqrt().max(f64::MIN_POSITIVE);
        (samples.iter().map(|x| (x - mean) / scale).collect(), scale)
    };
    let is_input = |channel: &usize| options.inputs.contains(channel);
    let outputs = (0..record.channels().len()).filter(|channel| !is_input(channel));
    let (outputs, scales): (Vec<_>, Vec<_>) = outputs.map(scaled).unzip();
    let measured = Measured {
        outputs,
        inputs: options.inputs.iter().map(|&channel| scaled(channel).0).collect(),
    };
    let how = Realize {
        block_rows: settings.block_rows,
        order_most: settings.order_most,
        rate_hz: settings.sampling_rate_hz,
        scales: &scales,
    };
    for noise in NOISE {
        let fit = Fit {
            lags,
            blocks: BLOCKS,
            noise,
        };
        if let Some(mut found) = realize(&observe(&measured, &fit)?, &how)? {
            let noisier = Fit {
                noise: NOISE_ALLOWED.hypot(noise),
                blocks: 1,
                ..fit
            };
            let noisier = realize(&observe(&measured, &noisier)?, &how)?;
            found.noisier = noisier.map_or_else(Vec::new, |of| of.poles);
            return Ok((found, noise));
        }
    }
    Err(ModalError::NoObserver)
}

#[cfg(test)]
mod tests {
    use super::super::made::{MadeOnGround, MadeOneMass};
    use super::*;
    use crate::modal::identify;
    use crate::signal::{Channel, ChannelFault};

    fn options() -> Identify {
        Identify {
            method: Method::Okid,
            inputs: vec![0],
            ..Identify::default()
        }
    }

    const QUAKE: MadeOnGround = MadeOnGround {
        seed: 0,
        duration_s: 150.0,
        waves_kn: 60.0,
        quake_s: Some(30.0),
        wind_kn: 0.3,
        noise: 0.01,
    };
    const AMBIENT: MadeOnGround = MadeOnGround {
        duration_s: 300.0,
        waves_kn: 2.0,
        quake_s: None,
        wind_kn: 0.5,
        ..QUAKE
    };

    /// The roof is excited by a force at 5.1 Hz, with noise of `wide` times the sine, and by ambient motion.
    fn on_a_shaker(wide: f64) -> Result<ModalAnalysis, ModalError> {
        let made = crate::modal::ReferenceCase::ShearChain.made(3)?.make()?;
        let mut random = crate::numeric::Random::new(8, 0);
        let force = |t: usize| (std::f64::consts::TAU * 5.1 * 0.01 * t as f64).sin() + wide * random.normal();
        let force: Vec<f64> = (0..made.length()).map(force).collect();
        let follows = |c: usize| -> Vec<f64> {
            let both = made.samples(c).iter().zip(&force);
            both.map(|(y, f)| y + 0.5 * f).collect()
        };
        let channels = ["shaker", "floor", "roof"].map(Channel::named).to_vec();
        let samples = vec![force.clone(), follows(0), follows(1)];
        identify(&Record::new(channels, samples, 100.0)?, &options())
    }

    #[test]
    fn refuses_a_sine_as_the_only_input() {
        let why = on_a_shaker(0.02).unwrap_err().to_string();
        assert!(
            why.contains("% of the power of every input lies at one frequency, 5.1"),
            "{why}"
        );
        let random = on_a_shaker(1.0);
        assert!(
            !matches!(random, Err(ModalError::InputsSine { .. })),
            "{random:?}"
        );
    }

    #[test]
    fn holds_the_frequencies_of_a_held_base_lie_in_their_intervals() {
        const RUNS: u64 = 6; // of 20, seeds 0 to 19: 20, 20, 20, 20 (quake) and 20, 19, 18, 20 (ambient)
        let truth = MadeOnGround::held_hz();
        for (what, case) in [("quake", QUAKE), ("ambient", AMBIENT)] {
            let mut within = [0; 4];
            for seed in 0..RUNS {
                let record = MadeOnGround { seed, ..case }.make().unwrap();
                let found = identify(&record, &options()).unwrap();
                let modes = &found.modes.modes;
                for (k, hz) in truth.iter().enumerate() {
                    let mode = found.modes.nearest(*hz, 0.1 * hz).unwrap();
                    let off = (mode.frequency_hz - hz) / mode.frequency_sd_hz.unwrap();
                    within[k] += usize::from(off.abs() < 1.96);
                    let off = (mode.damping_ratio.unwrap() - MadeOnGround::DAMPING)
                        / mode.damping_ratio_sd.unwrap();
                    within[2 + k] += usize::from(off.abs() < 1.96);
                }
                assert_eq!(modes.len(), 2, "{what} {seed}");
                let driven = found.driven.unwrap();
                let with_base = driven.modes[0].with_base_hz;
                assert!(
                    with_base.is_none_or(|(hz, _)| hz < 0.95 * truth[0]),
                    "{what} {seed} {driven:?}"
                );
            }
            assert!(within.iter().all(|count| *count >= 5), "{what} {within:?}");
        }
    }

    #[test]
    fn holds_a_short_earthquake_shows_every_mode_of_the_held_base_and_hardly_any_other() {
        let (mut found, mut false_modes) = (0, 0);
        for seed in 0..10 {
            let short = MadeOnGround {
                seed,
                duration_s: 22.0,
                quake_s: Some(8.0),
                ..QUAKE
            };
            let modes = identify(&short.make().unwrap(), &options()).unwrap().modes;
            let is = |hz: f64| move |mode: &&Mode| (mode.frequency_hz / hz - 1.0).abs() < 0.01;
            let truth = MadeOnGround::held_hz();
            let true_modes = truth
                .iter()
                .filter(|hz| modes.modes.iter().any(|mode| is(**hz)(&mode)));
            let all = true_modes.count();
            found += all;
            false_modes += modes.modes.len() - all;
        }
        assert!(found == 20 && false_modes <= 1, "{found} {false_modes}");
    }

    #[test]
    fn holds_a_clipped_channel_above_measured_ground_is_named_and_makes_no_mode() {
        let truth = MadeOnGround::held_hz();
        for (seed, clipped) in [(0, 1), (1, 2)] {
            let record = MadeOnGround { seed, ..AMBIENT }.make().unwrap();
            let end = record.mean_square(clipped).sqrt();
            let samples = (0..3).map(|c| {
                let end = if c == clipped { end } else { f64::INFINITY };
                record.samples(c).iter().map(|y| y.clamp(-end, end)).collect()
            });
            let channels = record.channels().to_vec();
            let record = Record::new(channels, samples.collect(), record.sampling_rate_hz()).unwrap();
            let found = identify(&record, &options()).unwrap();
            let name = &record.channels()[clipped].name;
            let is_named = |note: &Note| matches!(note, Note::Channel(ChannelFault::Clipped { channel, .. }) if channel == name);
            assert!(found.notes.iter().any(is_named), "{:?}", found.notes);
            let hz: Vec<f64> = found.modes.modes.iter().map(|mode| mode.frequency_hz).collect();
            assert_eq!(hz.len(), 2, "{seed} {hz:?}");
            for (found_hz, hz) in hz.iter().zip(truth) {
                assert!((found_hz / hz - 1.0).abs() < 0.02, "{seed} {found_hz} {hz}");
            }
        }
    }

    #[test]
    fn holds_the_frequency_of_one_mass_lies_in_its_interval_in_nineteen_of_twenty() {
        let mut within = [0; 2];
        for seed in 0..20 {
            let made = MadeOneMass {
                seed,
                frequency_hz: 2.4,
                damping_ratio: 0.02,
                duration_s: 60.0,
                noise: 0.01,
            };
            let found = identify(&made.make().unwrap(), &options()).unwrap();
            let mode = found.modes.nearest(2.4, 0.2).unwrap();
            let off = [
                (mode.frequency_hz - 2.4) / mode.frequency_sd_hz.unwrap(),
                (mode.damping_ratio.unwrap() - 0.02) / mode.damping_ratio_sd.unwrap(),
            ];
            for (within, off) in within.iter_mut().zip(off) {
                *within += usize::from(off.abs() < 1.96);
            }
        }
        assert!(within[0] >= 19 && within[1] >= 18, "{within:?}");
    }
}
