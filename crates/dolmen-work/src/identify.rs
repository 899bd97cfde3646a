//! `dolmen identify`: records to modes, modes to stiffness.

use crate::answer::IdentifyAnswer;
use crate::asked_modes::{drawn, options};
use crate::building::{self, stiffness::FromModes};
use crate::doubted::{columns, doubt};
use crate::error::{Within as _, WorkError};
use crate::held_beside_file::hold_beside_file;
use crate::kinds;
use crate::model_modes::model_modes;
use crate::more_modes::doubt_more_modes;
use crate::opened::Opened;
use crate::progress::{Progress, Stage};
use crate::record::{self, OpenedRecord};
use crate::record_seen::RecordSeen;
use crate::same_record::refuse_same_records;
use crate::sensor_alarms::SensorFault;
use crate::stack::factors::{self as stack, factors};
use crate::surveyed::{
    Earthquake, ModesOf, RecordAnswer, SetupsAnswer, StiffnessAnswer, SurveyAnswer, WithoutStiffness,
};
use crate::wrong::Place;
use dolmen::modal::{
    During, Identify, MergeSetups, Method, ModalAnalysis, ModalError, Modes, Note, Part, StrongMotion,
    doubt_sensors, identify as modes_of, is_of_one_state, joint_setups, merge_setups, strong_motion,
};
use dolmen::signal::{ChannelFault, Record, clipped_channels, cut};
use dolmen::structure::{StiffnessNote, directional_modes};
use dolmen_project::{
    Conditioning, EarthquakePart, Merge, ModeKind, Project, Quantity, RecordSource, Structure, Survey,
};
use dolmen_records::Files;

/// Choice of surveys.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct IdentifyOptions {
    /// Name of the survey; by default all surveys.
    pub survey: Option<String>,
}

/// Identifies the modes of every survey's records, and every stiffness that explains them.
///
/// # Errors
/// An unknown survey; records that cannot be read or hold no modes.
pub fn identify(
    opened: &Opened,
    options: &IdentifyOptions,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<IdentifyAnswer, WorkError> {
    Ok(IdentifyAnswer {
        file: opened.file.clone(),
        project: opened.project.clone(),
        surveys: surveys(opened, options.survey.as_deref(), files, progress)?,
    })
}

/// Results of the surveys of a project, all of them or the named one; earlier results are reused.
pub(crate) fn surveys(
    opened: &Opened,
    only: Option<&str>,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<Vec<SurveyAnswer>, WorkError> {
    let project = &*opened.project;
    if let Some(name) = only
        && !project.surveys.iter().any(|survey| survey.name == name)
    {
        let names: Vec<&str> = project
            .surveys
            .iter()
            .map(|survey| survey.name.as_str())
            .collect();
        return Err(WorkError::NoSuchSurvey {
            name: name.to_owned(),
            known: names.join(", "),
        });
    }
    let chosen = project
        .surveys
        .iter()
        .filter(|survey| only.is_none_or(|name| survey.name == name));
    refuse_same_records(chosen.clone(), files)?;
    chosen
        .map(|survey| {
            let before = opened.identified.iter().find(|known| known.name == survey.name);
            match before {
                Some(known) => Ok(known.clone()),
                None => of_survey(project, survey, files, progress),
            }
        })
        .collect()
}

/// Results of the records of a survey.
#[derive(Clone, Debug)]
pub struct SurveyModes {
    /// The modes; none if the records contain only an earthquake.
    pub modes: Modes,
    /// Faults of the channels.
    pub faults: Vec<(String, SensorFault)>,
    /// The earthquake in the records.
    pub earthquake: Option<EarthquakePart>,
}

/// Modes of the records of one survey; `None` if it has no records.
///
/// # Errors
/// An unknown survey; records that cannot be read or hold no modes.
pub fn survey_modes(
    project: &Project,
    name: &str,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<Option<SurveyModes>, WorkError> {
    let Some(survey) = project.surveys.iter().find(|survey| survey.name == name) else {
        let names: Vec<&str> = project.surveys.iter().map(|of| of.name.as_str()).collect();
        return Err(WorkError::NoSuchSurvey {
            name: name.to_owned(),
            known: names.join(", "),
        });
    };
    let answer = found_in(survey, files, progress)?;
    let faults = answer.faults();
    Ok(answer.modes().map(|(modes, _)| {
        let mut modes = modes.clone();
        if answer.is_shaken() {
            modes.modes.clear();
        }
        SurveyModes {
            modes,
            faults,
            earthquake: answer.earthquake().filter(|of| of.is_one()).map(Earthquake::part),
        }
    }))
}

/// Modes of a survey's records, without the stiffness.
pub(crate) fn found_in(
    survey: &Survey,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<SurveyAnswer, WorkError> {
    let context = || Place::OfSurvey(survey.name.clone());
    let records = match &survey.records {
        Some(source) => Some(of_record(source, files, progress).within(context)?.0),
        None => None,
    };
    let setups = if survey.setups.is_empty() {
        None
    } else {
        Some(of_setups(survey, files, progress).within(context)?)
    };
    Ok(SurveyAnswer {
        name: survey.name.clone(),
        records,
        setups,
        model: None,
        shape_doubt: None,
        columns: Vec::new(),
        exchanged_directions: None,
        stiffness: Vec::new(),
        plan: None,
        factors: None,
        without_stiffness: None,
    })
}

/// Each setup alone, then all together, and as one if the file requests it.
fn of_setups(survey: &Survey, files: &dyn Files, progress: &dyn Progress) -> Result<SetupsAnswer, WorkError> {
    let (mut records, mut measured) = (Vec::new(), Vec::new());
    for source in &survey.setups {
        let (answer, record) = of_record(source, files, progress)?;
        records.push(answer);
        measured.push(record);
    }
    let modes: Vec<Modes> = records
        .iter()
        .map(|record| record.analysis.modes.clone())
        .collect();
    let merge = MergeSetups::default();
    let merged = merge_setups(&modes, &merge)?;
    let joint = match (survey.merge, survey.setups.first()) {
        (Merge::Preger, Some(first)) => {
            progress.begin(&Stage::Joining);
            let clipped = records
                .iter()
                .flat_map(|of| clipped_channels(&of.faults, of.samples));
            let options = Identify {
                references: Vec::new(),
                clipped: clipped.collect(),
                ..options(first, measured[0].channels())?
            };
            let joint = joint_setups(&measured, &options, merge.pairing.place_within_m)
                .within(|| Place::AllSetups)?;
            progress.end();
            Some(joint)
        }
        _ => None,
    };
    Ok(SetupsAnswer {
        records,
        merged,
        joint,
    })
}

fn of_survey(
    project: &Project,
    survey: &Survey,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<SurveyAnswer, WorkError> {
    let context = || Place::OfSurvey(survey.name.clone());
    let mut answer = found_in(survey, files, progress)?;
    let mut stiffness = Vec::new();
    let alone = |direction: &str| match &project.structure {
        Structure::Frame(part) => part.is_on_columns_alone(direction),
        _ => false,
    };
    for direction in survey.modes.keys().filter(|direction| !alone(direction)) {
        let modes = survey.measured_modes(direction, &mut Quantity::nominal);
        if !modes.is_empty() {
            stiffness.extend(
                kinds::stiffness(project, direction, &modes, &twisting(survey, direction)).within(context)?,
            );
        }
    }
    if let Some((found, _)) = answer.modes() {
        let doubtful = answer
            .setups
            .as_ref()
            .map_or_else(Vec::new, SetupsAnswer::doubtful_hz);
        let unexplained_hz = answer.unexplained_hz();
        for (direction, vector) in [("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0])] {
            if !survey.modes.contains_key(direction) && !alone(direction) {
                let answers = from_record(project, found, &doubtful, (direction, vector));
                stiffness.extend(answers.within(context)?.into_iter().map(|answer| {
                    let highest_hz = answer.frequencies_hz.last().copied().unwrap_or(0.0);
                    let below = unexplained_hz.iter().copied().filter(|hz| *hz < highest_hz);
                    StiffnessAnswer {
                        peaks_below_hz: below.collect(),
                        ..answer
                    }
                }));
            }
        }
    }
    let is_sought = matches!(project.structure, Structure::Chain(_) | Structure::Frame(_));
    let has_record = answer.modes().is_some();
    let of_record = ["x", "y"].into_iter().filter(|_| has_record);
    let on_columns = of_record.chain(survey.modes.keys().map(String::as_str));
    let mut on_columns = on_columns.filter(|direction| alone(direction));
    if let Some(direction) = on_columns.next() {
        answer.without_stiffness = Some(WithoutStiffness::OnColumnsAlone {
            direction: direction.to_owned(),
        });
    }
    if is_sought
        && answer.without_stiffness.is_none()
        && stiffness.is_empty()
        && survey.modes.is_empty()
        && let Some((found, _)) = answer.modes()
    {
        answer.without_stiffness = why_no_stiffness(found);
    }
    if is_sought && answer.without_stiffness.is_none() {
        let all_twist = |direction: &&String| {
            let modes = survey.measured_modes(direction, &mut Quantity::nominal);
            modes.is_empty() && !twisting(survey, direction).is_empty()
        };
        let found = survey.modes.keys().find(all_twist);
        answer.without_stiffness = found.map(|direction| WithoutStiffness::AllTwist {
            direction: direction.clone(),
        });
    }
    if let Some((found, _)) = answer.modes() {
        let (model, seen) = (model_modes(project, found), columns(project, found));
        (answer.model, answer.columns) = (model, seen);
    }
    answer.stiffness = stiffness;
    doubt(project, survey, &mut answer);
    if let Structure::Building(part) = &project.structure {
        let found = answer.modes().map(|(found, _)| found);
        match building::stiffness::stiffness(part, survey, found).within(context)? {
            Some(FromModes::Plan(plan)) => answer.plan = Some(plan),
            Some(FromModes::Without(why)) => answer.without_stiffness = Some(why),
            None => {}
        }
    }
    if let Structure::Stack(part) = &project.structure {
        match factors(part, survey, &answer).within(context)? {
            stack::FromModes::Factors(found) => answer.factors = Some(found),
            stack::FromModes::Without(why) => answer.without_stiffness = Some(why),
        }
    }
    hold_beside_file(project, &mut answer);
    Ok(answer)
}

/// The missing direction of the sensors, if none measures along x or y; `None` otherwise.
fn why_no_stiffness(found: &Modes) -> Option<WithoutStiffness> {
    let along =
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|vector| directional_modes(found, vector).channels_along);
    if along != [0, 0] {
        return None;
    }
    let placed = found
        .channels
        .iter()
        .filter(|c| c.position_m.is_some() && c.direction.is_some());
    let channels: Vec<String> = placed.map(|c| c.name.clone()).collect();
    Some(match channels.is_empty() {
        true => WithoutStiffness::NoPlace,
        false => WithoutStiffness::OffTheAxes { channels },
    })
}

/// The torsional modes of a direction: reported, but not used in the fit.
fn twisting(survey: &Survey, direction: &str) -> Vec<StiffnessNote> {
    let modes = survey.modes.get(direction).into_iter().flatten();
    let twisting = modes.filter(|mode| mode.kind == ModeKind::Torsion);
    twisting
        .map(|mode| StiffnessNote::Twists {
            frequency_hz: mode.frequency.value,
        })
        .collect()
}

fn of_record(
    source: &RecordSource,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<(RecordAnswer, Record), WorkError> {
    let file = source.file.clone();
    progress.begin(&Stage::Reading { file });
    of_opened(source, record::record_to_identify(source, files)?, progress)
}

/// The same error, or the single samples far from their neighbours that hide the modes from the spectrum.
fn hidden_by_spikes(why: WorkError, faults: &[ChannelFault]) -> WorkError {
    match why {
        WorkError::Within { place, cause } => WorkError::Within {
            place,
            cause: Box::new(hidden_by_spikes(*cause, faults)),
        },
        WorkError::Modal(of) if matches!(*of, ModalError::NoPeak { .. } | ModalError::NoPeakLeft { .. }) => {
            let spikes = faults.iter().find_map(|fault| match fault {
                ChannelFault::Spikes {
                    channel,
                    count,
                    first_s,
                } => Some(WorkError::SpikesHideModes {
                    channel: channel.clone(),
                    count: *count,
                    first_s: *first_s,
                }),
                _ => None,
            });
            spikes.unwrap_or(WorkError::Modal(of))
        }
        other => other,
    }
}

/// Modes of a record.
pub(crate) fn of_opened(
    source: &RecordSource,
    opened: OpenedRecord,
    progress: &dyn Progress,
) -> Result<(RecordAnswer, Record), WorkError> {
    let file = source.file.clone();
    progress.begin(&Stage::Identifying { file });
    let options = Identify {
        clipped: clipped_channels(&opened.faults, opened.samples),
        ..options(source, opened.record.channels())?
    };
    let asked = drawn(source.modal.spectrogram.as_ref(), opened.record.channels());
    let asked = asked.within(|| source.file.clone())?;
    // if no shaking was found in the record as read, these are the same samples again
    let is_still =
        !opened.is_shaken && options.inputs.is_empty() && source.conditioning == Conditioning::default();
    let sought = !source.modal.without_earthquake && !is_still;
    let found = sought
        .then(|| strong_motion(&opened.record, &options, &opened.losses))
        .flatten();
    let Quiet {
        part,
        mut analysis,
        earthquake,
    } = quiet(
        source,
        &opened.record,
        &options,
        Shaking {
            found,
            is_whole: opened.losses.lost_s.is_empty(),
        },
    )
    .map_err(|why| hidden_by_spikes(why, &opened.faults))?;
    if earthquake.as_ref().is_some_and(Earthquake::is_shaken) {
        // strong ground motion resembles a loose contact: the faults of the quiet parts count
        let is_spike = |note: &Note| matches!(note, Note::Channel(ChannelFault::Spikes { .. }));
        analysis.notes.retain(|note| !is_spike(note));
    }
    let read_s = opened.samples as f64 / opened.sampling_rate_hz;
    let is_one_file = source.stations.is_empty();
    let seen = RecordSeen::of(&opened.record, read_s, (&analysis, asked), is_one_file)?;
    let seen = seen.with_part(part.as_ref());
    progress.end();
    // counted from the first sample of the file, not of the part in use
    let earthquake = earthquake.map(|of| Earthquake {
        found: of.found.later(seen.time.from_s),
        ..of
    });
    let record = part.unwrap_or(opened.record);
    let answer = RecordAnswer {
        file: source.file.clone(),
        channels: opened.channels,
        samples: opened.samples,
        sampling_rate_hz: opened.sampling_rate_hz,
        unit: opened.unit,
        remarks: opened.remarks,
        unread_stamps: opened.unread_stamps,
        clock_doubts: opened.clock_doubts,
        faults: opened.faults,
        doubts: doubt_sensors(&record, &analysis.modes.modes),
        analysis,
        earthquake,
        seen,
    };
    Ok((answer, record))
}

/// The earthquake in a record.
struct Shaking {
    /// `None`: there is none.
    found: Option<StrongMotion>,
    /// Whether no samples of the record were lost.
    is_whole: bool,
}

/// The part of a record from which its modes are identified.
struct Quiet {
    /// `None`: the whole.
    part: Option<Record>,
    analysis: ModalAnalysis,
    earthquake: Option<Earthquake>,
}

/// The modes after the last earthquake, otherwise between two or before them; those of the strong phase if its ground motion is an input;
/// those of the whole record if there was no earthquake, if it shows one state of the structure above its ground, or if all parts are too
/// short.
fn quiet(
    source: &RecordSource,
    record: &Record,
    options: &Identify,
    shaking: Shaking,
) -> Result<Quiet, WorkError> {
    let whole = |earthquake: Option<Earthquake>| -> Result<Quiet, WorkError> {
        Ok(Quiet {
            part: None,
            analysis: modes_of(record, options).within(|| source.file.clone())?,
            earthquake,
        })
    };
    let Some(found) = shaking.found else {
        return whole(None);
    };
    let part = |of: ModesOf, part: &Part| Some((of, part.span_s, part.analysis.clone()?));
    let first = match (&found.strongest().during, options.method) {
        (During::Driven(of), _) => {
            let one_state = |whole: &ModalAnalysis| is_of_one_state(&whole.modes, &of.analysis.modes);
            if shaking.is_whole && modes_of(record, options).is_ok_and(|whole| one_state(&whole)) {
                return whole(Some(Earthquake {
                    found,
                    modes_of: ModesOf::Whole,
                }));
            }
            Some((ModesOf::During, of.span_s, of.analysis.clone()))
        }
        (_, Method::Okid) => None,
        _ => part(ModesOf::After, found.after())
            .or_else(|| part(ModesOf::Between, found.between()?))
            .or_else(|| part(ModesOf::Before, found.before())),
    };
    let Some((modes_of_part, [from_s, to_s], analysis)) = first else {
        return whole(Some(Earthquake {
            found,
            modes_of: ModesOf::Whole,
        }));
    };
    let part = cut(record.clone(), from_s, to_s)?;
    // the identification itself checks the options of the file
    let is_asked = !options.pick_hz.is_empty()
        || !options.accept_hz.is_empty()
        || !options.inputs.is_empty() && modes_of_part != ModesOf::During
        || options.modes_wanted.is_some();
    Ok(Quiet {
        analysis: match is_asked {
            true => modes_of(&part, options).within(|| source.file.clone())?,
            false => analysis,
        },
        part: Some(part),
        earthquake: Some(Earthquake {
            found,
            modes_of: modes_of_part,
        }),
    })
}

/// Stiffness from the modes of a record along one direction; none if no sensor measures it.
fn from_record(
    project: &Project,
    modes: &Modes,
    doubtful_hz: &[f64],
    (direction, vector): (&str, [f64; 3]),
) -> Result<Vec<StiffnessAnswer>, WorkError> {
    let mut found = directional_modes(modes, vector);
    found.end_before(doubtful_hz);
    let parts = match &project.structure {
        Structure::Chain(part) => part.links.len(),
        Structure::Frame(part) => part.storeys.len(),
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => return Ok(Vec::new()),
    };
    let beyond = found.keep(modes, parts); // a model of n parts has n modes: the lowest are used
    if found.modes.is_empty() {
        return Ok(Vec::new());
    }
    let mut notes: Vec<StiffnessNote> = found.left_out.into_iter().map(StiffnessNote::LeftOut).collect();
    notes.push(StiffnessNote::TakenAsLowest {
        modes: found.modes.len(),
        direction: direction.to_owned(),
    });
    let mut answers = kinds::stiffness(project, direction, &found.modes, &notes)?;
    doubt_more_modes(project, direction, (&found.modes, &beyond), &mut answers)?;
    Ok(answers)
}
