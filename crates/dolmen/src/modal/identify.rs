//! Identifies the modes of a record: spectrum, machines, subspace method, clusters, and a report of every choice.

use super::accept::{accepted, candidates, put_in, taken_out};
use super::candidate::Candidate;
use super::decay::{decays_in, leave_out_copies, of_decay};
use super::driven::of_driven;
use super::halves::changed_between_halves;
use super::likelihood::{Question, refined, shown_by_lines};
use super::modal_analysis::{ModalAnalysis, of_peaks};
use super::options::Identify;
use super::quality::in_valleys;
use super::quality::leave_out_clipped;
use super::quality::leave_out_combs;
use super::quality::leave_out_flanks;
use super::quality::leave_out_other_clocks;
use super::quality::leave_out_spells;
use super::quality::note_hidden_pairs;
use super::quality::off_clocks;
use super::quality::{Diagram, remark};
use super::quality::{Quantities, doubt_channels, to_one_quantity};
use super::quality::{SetAside, note_tones_on_modes, of_steady, split_tones};
use super::quality::{leave_out_steadier, test_for_machines};
use super::quality::{unequal, widen};
use super::settings::{Seen, Settings, choose};
use super::shared_steps::{
    check, clipped_record, judge_channels, judged, modes_of, note_blends, note_filter, undecided_of,
    undecided_peaks,
};
use super::shared_steps::{pick, spectrum, wanted};
use super::spectrum::FddResult;
use super::spectrum::FractionScatter;
use super::spectrum::Plscf;
use super::spectrum::plscf;
use super::spectrum::{REFERENCES_LEAST, keeping_most, least_of_wide};
use super::subspace::{AllOrders, Cluster, Criteria, Deviations};
use super::subspace::{ssi_cov, ssi_data};
use super::{Method, ModalError, Mode, Modes, Note, Propagation, Refusal};
use crate::signal::{ChannelFault, Record, leave_out};

/// Modes of an ambient record, without user interaction: spectrum, a subspace method at all orders, clusters. Some values of
/// `method` use only the peaks of the spectrum.
///
/// The lowest and highest peaks of the spectrum determine the length of the correlations and the decimation, as reported in
/// [`Settings`](super::Settings). The record is read twice: with long lags for the spectrum, and for SSI.
///
/// # Errors
/// [`ModalError::Channel`], [`ModalError::NoPeak`], [`ModalError::NoPeakLeft`], [`ModalError::BlockRows`],
/// [`ModalError::Order`], [`ModalError::ModesWanted`], [`ModalError::ModesMissing`], [`ModalError::TooShort`],
/// [`ModalError::NoModeAt`], [`ModalError::Dependent`], [`ModalError::Option`], [`ModalError::Linalg`].
///
/// # Example
/// ```
/// use dolmen::modal::{Identify, ReferenceCase, identify};
/// let record = ReferenceCase::ShearChain.made(1)?.make()?;
/// let found = identify(&record, &Identify::default())?;
/// assert_eq!(found.modes.modes.len(), 2);
/// let first = &found.modes.modes[0];
/// assert!((first.frequency_hz - 1.1).abs() < 4.0 * first.frequency_sd_hz.unwrap_or(0.0));
/// # Ok::<(), dolmen::modal::ModalError>(())
/// ```
pub fn identify(record: &Record, options: &Identify) -> Result<ModalAnalysis, ModalError> {
    let mut found = as_one_state(record, options)?;
    if !matches!(options.method, Method::Era | Method::Okid) && found.free_decays.is_none() {
        found.between_halves = changed_between_halves(record, options, &found, &as_one_state);
    }
    Ok(found)
}

/// Modes of a record of a structure that does not change.
fn as_one_state(record: &Record, options: &Identify) -> Result<ModalAnalysis, ModalError> {
    check(record, options)?;
    let mut notes = judge_channels(record)?;
    note_filter(record, options, &mut notes);
    if options.method == Method::Okid {
        return of_driven((record, options), notes, &as_one_state);
    }
    if options.method != Method::Era
        && let Some(rest) = without_loose_sensors(record, options, &notes)
    {
        return Ok(rest);
    }
    if options.method != Method::Era
        && let Some(brought_together) = without_off_clocks(record, options, &notes)
    {
        return Ok(brought_together);
    }
    of_ambient(record, options, notes)
}

/// Modes of a record whose channels have one clock.
fn of_ambient(
    record: &Record,
    options: &Identify,
    mut notes: Vec<Note>,
) -> Result<ModalAnalysis, ModalError> {
    let mut peaks = spectrum(record, options)?;
    let decaying = match options.method {
        Method::Era => None,
        _ => decays_in(record),
    };
    // the tests for machines and footsteps assume random forces
    let is_ambient = options.method != Method::Era && decaying.is_none();
    let set_aside = match decaying {
        Some(_) => SetAside::default(),
        None => split_tones(record, &mut peaks, options, &mut notes)?,
    };
    let mut refused = set_aside.peaks.clone();
    let mut analysis = match options.method {
        Method::Fdd | Method::Efdd | Method::Fsdd => of_peaks(peaks, record, options),
        Method::Era => of_decay(record, options, peaks)?,
        Method::SsiCov | Method::SsiData | Method::Bayoma | Method::Plscf | Method::Okid => {
            of_separate_poles(record, options, (peaks, &set_aside), (&mut refused, &mut notes))?
        }
    };
    if let Some(found) = decaying {
        let before = analysis.modes.modes.clone();
        leave_out_copies(&mut analysis.modes, &found.modes);
        refused.extend(taken_out(&before, &analysis.modes.modes, |_| Refusal::SplitsOff));
        analysis.free_decays = Some(found.decays);
    }
    if options.method != Method::Era {
        let before = analysis.modes.modes.clone();
        let whole = clipped_record(record, options, &notes);
        leave_out_clipped(&[whole], &mut analysis.modes, &mut notes)?;
        refused.extend(taken_out(&before, &analysis.modes.modes, |_| Refusal::Clipping));
    }
    if is_ambient {
        leave_out_not_random(record, options, &mut analysis.modes, (&mut refused, &mut notes))?;
    }
    if options.method != Method::Era {
        leave_out_other_clocks(record, &mut analysis.modes, &mut notes);
        if let Some(alone) = of_one_clock(record, options, &analysis.modes, &notes) {
            return Ok(alone);
        }
    }
    to_one_quantity(&mut analysis.modes, &mut notes);
    let seen = set_aside
        .peaks
        .iter()
        .map(|of| &of.mode)
        .chain(&analysis.fdd_modes.modes);
    let seen_hz: Vec<f64> = seen.map(|mode| mode.frequency_hz).collect();
    let insisted = accepted(options, &analysis.modes.modes, (&refused, &seen_hz), &mut notes);
    let not_picked_hz = pick(options, &mut analysis.modes)?;
    wanted(options, &analysis.modes)?;
    // modes that only the user requested give no information about the channels
    let mut of_channels = Vec::new();
    doubt_channels(&analysis.modes, &mut of_channels);
    put_in(record, options, insisted, &mut analysis.modes, &mut notes)?;
    note_tones_on_modes(
        (record, options),
        (&mut analysis.modes, &analysis.fdd_modes),
        &mut notes,
    );
    let diagram = Diagram {
        stabilization: &analysis.stabilization,
        clusters: &analysis.clusters,
        clustering: &options.clustering,
        duration_s: analysis.modes.duration_s,
    };
    let why = |peak_hz: f64| diagram.refusal(peak_hz);
    remark(
        &analysis.modes,
        (&analysis.fdd_modes, &why),
        not_picked_hz,
        &mut notes,
    );
    // the subspace methods separate such modes, if the record allows it
    if matches!(
        options.method,
        Method::Fdd | Method::Efdd | Method::Fsdd | Method::Plscf
    ) {
        let prominence_db = options.fdd.prominence_db;
        note_hidden_pairs(&analysis.modes, &analysis.spectrum, prominence_db, &mut notes);
    }
    notes.extend(of_channels);
    analysis.notes = notes;
    Ok(analysis)
}

/// Leaves out what random forces cannot have made a mode: machines, footsteps, their multiples, and flanks of other modes.
fn leave_out_not_random(
    record: &Record,
    options: &Identify,
    modes: &mut Modes,
    (refused, notes): (&mut Vec<Candidate>, &mut Vec<Note>),
) -> Result<(), ModalError> {
    let all = (0..record.channels().len()).collect();
    let before = modes.modes.clone();
    test_for_machines(&[(record, all)], options, modes, notes)?;
    refused.extend(taken_out(&before, &modes.modes, of_steady));
    let before = modes.modes.clone();
    leave_out_spells(record, modes, notes);
    refused.extend(taken_out(&before, &modes.modes, |_| Refusal::InSpells));
    let before = modes.modes.clone();
    leave_out_combs(modes, notes);
    refused.extend(taken_out(&before, &modes.modes, |_| Refusal::Machine));
    let before = modes.modes.clone();
    leave_out_flanks(modes);
    refused.extend(taken_out(&before, &modes.modes, |_| Refusal::SplitsOff));
    Ok(())
}

/// Identification with only the channels of one clock, if others were left out: their phases would split or destroy a mode.
fn of_one_clock(record: &Record, options: &Identify, modes: &Modes, notes: &[Note]) -> Option<ModalAnalysis> {
    const CHANNELS_LEAST: usize = 2; // one alone has no shape, and modes with a node there are lost
    let is_off = |name: &&str| modes.channels.iter().all(|kept| kept.name != **name);
    let off: Vec<&str> = record.channels().iter().map(|c| c.name.as_str()).collect();
    let off: Vec<&str> = off.into_iter().filter(is_off).collect();
    if off.is_empty() || modes.channels.len() < CHANNELS_LEAST || !options.references.is_empty() {
        return None;
    }
    let mut alone = as_one_state(&leave_out(record.clone(), &off).ok()?, options).ok()?;
    let of_clocks = |note: &&Note| matches!(note, Note::ClockDrift { .. });
    alone.notes.extend(notes.iter().filter(of_clocks).cloned());
    Some(alone)
}

/// Options for `kept`, some channels of `record`.
fn with_references_of(kept: &Record, record: &Record, options: &Identify) -> Identify {
    let place = |reference: &usize| {
        let name = &record.channels().get(*reference)?.name;
        kept.channels().iter().position(|own| own.name == *name)
    };
    Identify {
        references: options.references.iter().filter_map(place).collect(),
        ..options.clone()
    }
}

/// Identification without loose sensors, if there are any: their amplitude is wrong, and a mode whose strength at one sensor changes with time appears as
/// two. `notes` are those on the channels.
fn without_loose_sensors(record: &Record, options: &Identify, notes: &[Note]) -> Option<ModalAnalysis> {
    let loose: Vec<&ChannelFault> = notes
        .iter()
        .filter_map(|note| match note {
            Note::Channel(fault @ ChannelFault::Loose { .. }) => Some(fault),
            _ => None,
        })
        .collect();
    if loose.is_empty() {
        return None;
    }
    let names: Vec<&str> = loose.iter().map(|fault| fault.channel()).collect();
    let kept = leave_out(record.clone(), &names).ok()?;
    let mut found = as_one_state(&kept, &with_references_of(&kept, record, options)).ok()?;
    let left_out = loose.into_iter().cloned().map(Note::LeftOut);
    found.notes.splice(0..0, left_out);
    Some(found)
}

/// Identification without the channels whose phases contradict those of the others, if there are any. `notes` are those on the channels.
fn without_off_clocks(record: &Record, options: &Identify, notes: &[Note]) -> Option<ModalAnalysis> {
    let off = off_clocks(record);
    let kept = off.taken_off(record).ok()??;
    let as_given = |name: &str| record.channels().iter().find(|own| own.name == name);
    let options = with_references_of(&kept, record, options);
    let is_whole = kept.channels().len() == record.channels().len();
    let mut found = match is_whole {
        true => of_ambient(&kept, &options, notes.to_vec()),
        false => as_one_state(&kept, &options),
    }
    .ok()?;
    for channel in &mut found.modes.channels {
        channel.quantity = as_given(&channel.name).map_or(channel.quantity, |own| own.quantity);
    }
    found.notes.extend(off.notes());
    Some(found)
}

/// Poles with as many block rows as separate modes need: with few channels, 240 or 480 rows of the Hankel matrix split a mode that stands in the
/// valley between two peaks (our choice; 120 and 240 block rows of two channels separate modes 9 % apart among fifteen). A mode whose poles end
/// before the highest orders is left out if it stays there.
fn of_separate_poles(
    record: &Record,
    options: &Identify,
    (peaks, set_aside): (FddResult, &SetAside),
    (refused, notes): (&mut Vec<Candidate>, &mut Vec<Note>),
) -> Result<ModalAnalysis, ModalError> {
    const ROWS: [usize; 2] = [240, 480];
    let earlier = notes.len();
    let mut analysis = of_poles(
        record,
        options,
        (peaks.clone(), set_aside),
        (&mut *refused, &mut *notes),
    )?;
    let lumps = in_valleys(record, &analysis.modes.modes, analysis.settings.order_most);
    let is_chosen = options.block_rows.is_none() && options.method != Method::Plscf;
    for rows in ROWS.into_iter().filter(|_| is_chosen && !lumps.is_empty()) {
        let block_rows = rows / analysis.settings.references.len().max(1);
        if block_rows <= analysis.settings.block_rows {
            continue;
        }
        let more = Identify {
            block_rows: Some(block_rows),
            ..options.clone()
        };
        let (mut of_more, mut told) = (refused.clone(), Vec::new());
        // a short record has no room for them
        let Ok(found) = of_poles(
            record,
            &more,
            (peaks.clone(), set_aside),
            (&mut of_more, &mut told),
        ) else {
            break;
        };
        if lumps.iter().all(|lump| lump.is_split_in(&found.modes.modes)) {
            *refused = of_more;
            notes.truncate(earlier);
            notes.extend(told);
            return Ok(found);
        }
    }
    let blends: Vec<[f64; 2]> = lumps
        .iter()
        .filter(|lump| lump.ends)
        .map(|lump| [lump.frequency_hz, lump.damping_ratio])
        .collect();
    if !blends.is_empty() {
        let before = analysis.modes.modes.clone();
        let is_left = |mode: &Mode| blends.iter().all(|[hz, _]| *hz != mode.frequency_hz);
        analysis.modes.modes.retain(is_left);
        refused.extend(taken_out(&before, &analysis.modes.modes, |mode| Refusal::Blend {
            damping_ratio: mode.damping_ratio.unwrap_or(0.0),
        }));
        notes.push(Note::InValleys { blends });
    }
    Ok(analysis)
}

/// The same error, or that tests set all peaks aside.
fn none_left(why: ModalError, set_aside: &SetAside) -> ModalError {
    let mut at_hz: Vec<f64> = set_aside.peaks.iter().map(|of| of.mode.frequency_hz).collect();
    at_hz.sort_by(f64::total_cmp);
    match why {
        ModalError::NoPeak { .. } if !at_hz.is_empty() => ModalError::NoPeakLeft { at_hz },
        why => why,
    }
}

/// Poles of all orders, judged and grouped.
fn of_poles(
    record: &Record,
    options: &Identify,
    (peaks, set_aside): (FddResult, &SetAside),
    (refused, notes): (&mut Vec<Candidate>, &mut Vec<Note>),
) -> Result<ModalAnalysis, ModalError> {
    let tones_hz: &[f64] = &set_aside.tones_hz;
    let fewest = match options.method {
        _ if !options.references.is_empty() => None,
        Method::Plscf => Some(REFERENCES_LEAST),
        Method::SsiCov | Method::Bayoma => least_of_wide(record.channels().len()),
        _ => None,
    };
    let few = fewest.map(|least| keeping_most(&peaks.seen_at_peaks(), least));
    let with_few = Identify {
        references: few
            .as_ref()
            .map_or_else(|| options.references.clone(), |few| few.channels.clone()),
        ..options.clone()
    };
    let chosen = choose(record, &with_few, &Seen::of(&peaks, tones_hz), notes);
    let mut settings = chosen.map_err(|why| none_left(why, set_aside))?;
    settings.references_keep = few.map(|few| few.kept);
    let criteria = options.criteria.within(settings.range_hz);
    let mut hankel_singular_values = Vec::new();
    let quantities = Quantities::of(record.channels());
    let mut judge = |all: &AllOrders<'_>, deviations: &mut dyn Deviations| {
        let (stabilization, clusters) = judged(all, deviations, &criteria, &options.clustering)?;
        let diagram = Diagram {
            stabilization: &stabilization,
            clusters: &clusters,
            clustering: &options.clustering,
            duration_s: record.duration_s(),
        };
        *refused = candidates(options, (&peaks.modes, &set_aside.peaks), &diagram, deviations)?;
        Ok::<_, ModalError>((stabilization, clusters))
    };
    let (stabilization, clusters) = if options.method == Method::Plscf {
        let mut found = plscf(
            record,
            &Plscf {
                lags: 2 * settings.block_rows - 1,
                order_most: settings.order_most,
                decimation: settings.decimation,
                time_blocks: settings.time_blocks,
                references: settings.references.clone(),
                frequency_low_hz: settings.range_hz[0],
                frequency_high_hz: settings.range_hz[1],
                ..Plscf::default()
            },
        )?;
        settings.lines = found.lines;
        quantities.judge_as_one(&mut found.poles);
        let all = AllOrders {
            poles: &found.poles,
            duration_s: found.duration_s,
            order_most: found.order_most,
            order_step: found.references.len(),
        };
        judge(&all, &mut FractionScatter::new(&found))?
    } else {
        let ssi = settings.ssi();
        let mut found = match options.method {
            Method::SsiData => ssi_data(record, &ssi)?,
            _ => ssi_cov(record, &ssi)?,
        };
        hankel_singular_values.clone_from(&found.singular_values);
        quantities.judge_as_one(&mut found.poles);
        judge(&AllOrders::of(&found), &mut Propagation::new(&found))?
    };
    note_blends(&clusters, notes);
    let of_settings = (&settings, &criteria, tones_hz);
    let mut modes = by_lines((record, options), (&clusters, &peaks), of_settings, notes)?;
    let unequal = unequal(record, settings.time_blocks);
    widen(&mut modes, unequal.widening);
    widen(refused.iter_mut().map(|of| &mut of.mode), unequal.widening);
    settings.time_blocks_effective = unequal.time_blocks;
    Ok(ModalAnalysis {
        modes: Modes {
            modes,
            channels: record.channels().to_vec(),
            method: options.method,
            duration_s: record.duration_s(),
            history: record.history().to_vec(),
        },
        spectrum: peaks.spectrum,
        fdd_modes: peaks.modes,
        stabilization,
        clusters,
        hankel_singular_values,
        settings,
        decay: None,
        free_decays: None,
        between_halves: Vec::new(),
        driven: None,
        notes: Vec::new(),
    })
}

/// The modes of the clusters, with what the lines of the record say of them: which undecided clusters are modes, and with `bayoma` all values.
fn by_lines(
    (record, options): (&Record, &Identify),
    (clusters, peaks): (&[Cluster], &FddResult),
    (settings, criteria, tones_hz): (&Settings, &Criteria, &[f64]),
    notes: &mut Vec<Note>,
) -> Result<Vec<Mode>, ModalError> {
    let mut modes = modes_of(clusters, record.duration_s());
    if options.method == Method::Bayoma {
        let all = refined(record, modes, (peaks, tones_hz), (settings, criteria), notes);
        return Ok(all);
    }
    if !matches!(options.method, Method::SsiCov | Method::SsiData) {
        return Ok(modes);
    }
    let how = Question {
        range_hz: settings.range_hz,
        criteria,
        // the least deviation holds for blocks that are equally strong
        deviation_over_floor_most: unequal(record, settings.time_blocks).scatter
            * options.clustering.deviation_over_floor_most,
        tones_hz,
        time_blocks: settings.time_blocks,
    };
    let mut undecided = undecided_of(clusters, record.duration_s());
    undecided.extend(undecided_peaks(peaks, clusters));
    let mut shown = shown_by_lines(record, &modes, undecided, &how);
    leave_out_steadier((record, options), &mut shown)?;
    shown.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    if !shown.is_empty() {
        notes.push(Note::FromPeaks {
            frequency_hz: shown.iter().map(|mode| mode.frequency_hz).collect(),
        });
    }
    modes.append(&mut shown);
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    Ok(modes)
}
