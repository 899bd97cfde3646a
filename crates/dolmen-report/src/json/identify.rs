//! `dolmen identify` as JSON.

use super::check::project;
use super::earthquake::{change, earthquake};
use super::identified::identified;
use super::with::with;
use crate::as_json;
use crate::modal::{decay_remarks, setup_remarks};
use dolmen::blocks::JointFactor;
use dolmen::modal::{
    Agreement, AtAmplitude, Decay, Driven, DrivenMode, MergedMode, ModeDecay, Modes, Settings,
};
use dolmen::structure::building::{PlanMode, PlanSolution};
use dolmen::structure::{ChannelChange, ColumnsMove, ColumnsOfLevel, ShapeDoubt};
use dolmen_words::advice::Advice;
use dolmen_words::{Language, Sentence};
use dolmen_work::WrittenBack;
use dolmen_work::answer::IdentifyAnswer;
use dolmen_work::building::PlanAnswer;
use dolmen_work::model_modes::{BesideModel, ModelMode, ModelModes, WhichMode};
use dolmen_work::record_seen::{ChannelSeen, RecordSeen, SpectrogramSeen};
use dolmen_work::stack::FactorsAnswer;
use dolmen_work::surveyed::{
    RecordAnswer, SetupsAnswer, StiffnessAnswer, StiffnessDoubt, SurveyAnswer, SurveyColumns,
};
use serde_json::Value;

/// The identification of every survey.
pub fn identification_json(answer: &IdentifyAnswer) -> Value {
    as_json!({
        "project": project(&answer.project, &answer.file),
        "made_up_surveys": answer.project.surveys.iter().filter(|of| of.is_made_up).map(|of| &of.name).collect::<Vec<_>>(),
        "surveys": answer.surveys.iter().map(survey).collect::<Vec<_>>(),
    })
}

/// The values written into the project file, by path.
pub fn written_back_json(written: &WrittenBack) -> Value {
    let each = written.numbers.iter().map(|(path, number)| {
        as_json!({ "path": path, "value": number.value, "sd": number.sd, "unit": number.unit, "before": number.before })
    });
    as_json!({ "survey": written.survey, "unchecked": written.is_unchecked, "numbers": each.collect::<Vec<_>>() })
}

fn survey(survey: &SurveyAnswer) -> Value {
    as_json!({
        "name": survey.name,
        "records": survey.records.as_ref().map(record),
        "setups": survey.setups.as_ref().map(setups),
        "model": survey.model.as_ref().map(model),
        "shape_doubt": survey.shape_doubt.as_ref().map(shape_doubt),
        "columns": survey.columns.iter().map(columns).collect::<Vec<_>>(),
        "exchanged_directions": survey.exchanged_directions,
        "stiffness": survey.stiffness.iter().map(stiffness).collect::<Vec<_>>(),
        "plan": survey.plan.as_deref().map(plan),
        "joint_factors": survey.factors.as_deref().map(joint_factors),
        "without_stiffness": survey.without_stiffness.as_ref().map(ToString::to_string),
    })
}

/// Sensors on each level, compared with the mean of the others, mode by mode.
fn columns(of: &SurveyColumns) -> Value {
    let level = |level: &ColumnsOfLevel| {
        let (moves, any_of) = match &level.moves {
            ColumnsMove::AsOne => ("as one", &[][..]),
            ColumnsMove::Turning => ("as a floor that turns", &[][..]),
            ColumnsMove::TwoDiffer => ("two differ", &[][..]),
            ColumnsMove::Apart { any_of } => ("apart", any_of.as_slice()),
        };
        let columns = level.columns.iter().map(|column| {
            as_json!({
                "channel": column.channel,
                "amplitude_of_others": column.of_others.norm(),
                "phase_from_others_deg": column.of_others.arg().to_degrees(),
                "amplitude_sd": column.of_others_sd,
            })
        });
        as_json!({
            "frequency_hz": level.frequency_hz,
            "height_m": level.height_m,
            "moves": moves,
            "apart_any_of": any_of.iter().map(|at| &level.columns[*at].channel).collect::<Vec<_>>(),
            "columns": columns.collect::<Vec<_>>(),
        })
    };
    as_json!({ "direction": of.direction, "levels": of.levels.iter().map(level).collect::<Vec<_>>() })
}

/// Shapes of a record that the model does not have, and changes of sensors that would make them agree.
fn shape_doubt(doubt: &ShapeDoubt) -> Value {
    let change = |of: &ChannelChange| match of {
        ChannelChange::Turned { channel } => {
            as_json!({ "kind": "turned", "channels": [channel], "factor": -1.0 })
        }
        ChannelChange::Exchanged { channels } => {
            as_json!({ "kind": "exchanged", "channels": channels, "factor": null })
        }
        ChannelChange::Scaled { channel, factor } => {
            as_json!({ "kind": "scaled", "channels": [channel], "factor": factor })
        }
    };
    as_json!({
        "unexplained": doubt.unexplained,
        "unexplained_along": doubt.unexplained_along,
        "changed": doubt.changed,
        "changes": doubt.changes.iter().map(change).collect::<Vec<_>>(),
    })
}

/// Measured modes compared with those of the model; modes of the model by their number, from 1.
fn model(model: &ModelModes) -> Value {
    let number = |place: &usize| model.of_model[*place].first + 1;
    let of_model = |of: &ModelMode| as_json!({ "number": of.first + 1, "count": of.count, "frequency_hz": of.frequency_hz });
    let measured = |of: &BesideModel| {
        let (is, numbers) = match &of.is {
            WhichMode::One(place) => ("one", vec![number(place)]),
            WhichMode::Several(places) => ("several", places.iter().map(number).collect()),
            WhichMode::None(best) => ("none", best.iter().map(number).collect()),
        };
        as_json!({ "frequency_hz": of.frequency_hz, "assurance": of.assurance, "is": is, "of_model": numbers })
    };
    as_json!({
        "of_model": model.of_model.iter().map(of_model).collect::<Vec<_>>(),
        "measured": model.measured.iter().map(measured).collect::<Vec<_>>(),
        "channels": model.channels,
        "left_out": model.left_out,
        "without_dampers": model.without_dampers,
        "far_off": model.far_off().iter().map(|at| at + 1).collect::<Vec<_>>(),
    })
}

fn setups(setups: &SetupsAnswer) -> Value {
    let agreement = |of: &Agreement| with(of, as_json!({ "differs": of.differs() }));
    let merged = |m: &MergedMode| {
        as_json!({
            "frequency_hz": m.frequency_hz,
            "damping_ratio": m.damping_ratio,
            "scale": m.scale.iter().map(|z| [z.re, z.im]).collect::<Vec<_>>(),
            "reference_assurance": m.reference_assurance,
            "frequency_agreement": agreement(&m.frequency),
            "damping_ratio_agreement": m.damping.as_ref().map(agreement),
            "doubtful": m.doubtful,
        })
    };
    let found = &setups.merged;
    as_json!({
        "records": setups.records.iter().map(record).collect::<Vec<_>>(),
        "modes": identified(&found.modes),
        "merged": found.merged.iter().map(merged).collect::<Vec<_>>(),
        "partial": found.partial.iter().map(|p| as_json!({
            "frequency_hz": p.frequency_hz,
            "setups": p.setups.iter().map(|s| s + 1).collect::<Vec<_>>(),
            "unlike_in": p.unlike_in.iter().map(|s| s + 1).collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
        "reference_faults": found.reference_faults.iter().map(|fault| as_json!({
            "setup": fault.setups[0] + 1,
            "against_setup": fault.setups[1] + 1,
            "suspects": fault.suspects.iter().map(|of| as_json!({
                "channel": of.channel,
                "factor": of.factor,
                "factor_sd": of.factor_sd,
            })).collect::<Vec<_>>(),
            "modes": fault.modes,
        })).collect::<Vec<_>>(),
        "references": found.references.iter().map(|&c| &found.modes.channels[c].name).collect::<Vec<_>>(),
        "joint": setups.joint.as_ref().map(|joint| as_json!({
            "modes": identified(&joint.modes),
            "references": joint.references.iter().map(|&c| &joint.modes.channels[c].name).collect::<Vec<_>>(),
            "strength": joint.strength,
            "settings": settings(&joint.settings, &joint.modes),
            "notes": joint.notes.iter().map(Advice::advised).collect::<Vec<_>>(),
        })),
        "notes": english(setup_remarks(setups)),
    })
}

fn english(sentences: Vec<Sentence>) -> Vec<String> {
    let each = sentences.iter();
    each.map(|sentence| sentence.text(Language::English)).collect()
}

fn record(record: &RecordAnswer) -> Value {
    let analysis = &record.analysis;
    as_json!({
        "file": record.file,
        "channels": record.channels,
        "samples": record.samples,
        "sampling_rate_hz": record.sampling_rate_hz,
        "unit": record.unit,
        "remarks": record.remarks.iter().map(|remark| &remark.english).collect::<Vec<_>>(),
        "faults": record.faults.iter().map(Advice::advised).collect::<Vec<_>>(),
        "history": analysis.modes.history.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "settings": settings(&analysis.settings, &analysis.fdd_modes),
        "modes": identified(&analysis.modes),
        "fdd_modes": identified(&analysis.fdd_modes),
        "free_decays": analysis.free_decays.as_ref().map(|of| as_json!({ "explained": of.explained, "spans_s": of.spans_s })),
        "between_halves": analysis.between_halves.iter().map(change).collect::<Vec<_>>(),
        "decay": analysis.decay.as_ref().map(decay),
        "driven": analysis.driven.as_ref().map(driven),
        "earthquake": record.earthquake.as_ref().map(earthquake),
        "notes": analysis.notes.iter().map(Advice::advised).collect::<Vec<_>>(),
        "seen": seen(&record.seen),
    })
}

/// The record as used.
fn seen(seen: &RecordSeen) -> Value {
    let channel = |of: &ChannelSeen| as_json!({ "name": of.name, "mean": of.mean, "deviation": of.deviation, "largest": of.largest, "largest_at_s": of.largest_at_s });
    let spectrogram = |drawn: &SpectrogramSeen| {
        as_json!({
            "channel": seen.channels[drawn.channel].name,
            "asked": drawn.is_asked,
            "resolution_hz": drawn.of.resolution_hz,
            "segment_s": 2.0 * drawn.of.first_s,
            "columns": drawn.of.columns.len(),
        })
    };
    as_json!({
        "used_s": [seen.time.from_s, seen.time.to_s],
        "file_s": seen.time.whole_s,
        "channels": seen.channels.iter().map(channel).collect::<Vec<_>>(),
        "spectrogram": seen.spectrogram.as_ref().map(spectrogram),
    })
}

fn settings(settings: &Settings, modes: &Modes) -> Value {
    let name = |&c: &usize| modes.channels.get(c).map(|channel| &channel.name);
    as_json!({
        "lowest_hz": settings.lowest_hz,
        "highest_hz": settings.highest_hz,
        "decimation": settings.decimation,
        "sampling_rate_hz": settings.sampling_rate_hz,
        "lines": settings.lines,
        "block_rows": settings.block_rows,
        "block_rows_least": settings.block_rows_least,
        "order_most": settings.order_most,
        "time_blocks": settings.time_blocks,
        "time_blocks_effective": settings.time_blocks_effective,
        "references": settings.references.iter().map(name).collect::<Vec<_>>(),
        "references_keep": settings.references_keep,
        "range_hz": settings.range_hz,
    })
}

/// Further results from a measured input.
fn driven(driven: &Driven) -> Value {
    let mode = |m: &DrivenMode| as_json!({ "frequency_hz": m.frequency_hz, "explained": m.explained, "with_base_hz": m.with_base_hz.map(|of| of.0), "with_base_sd_hz": m.with_base_hz.and_then(|of| of.1) });
    as_json!({
        "inputs": driven.inputs,
        "lags": driven.lags,
        "noise": driven.noise,
        "modes": driven.modes.iter().map(mode).collect::<Vec<_>>(),
    })
}

fn decay(decay: &Decay) -> Value {
    let at = |of: &AtAmplitude| with(of, as_json!({ "half_width_95": of.half_width_95().ok() }));
    let mode = |m: &ModeDecay| as_json!({ "frequency_hz": m.frequency_hz, "poles_hz": m.poles_hz, "sd_over_white": m.over_white, "damping_follows": m.damping_follows, "overtone_of_hz": m.overtone.map(|of| of.of_hz), "swings": m.swings.iter().map(at).collect::<Vec<_>>() });
    as_json!({
        "explained": decay.explained,
        "left_peaks_hz": decay.left_peaks_hz,
        "machines_hz": decay.machines_hz,
        "modes": decay.modes.iter().map(mode).collect::<Vec<_>>(),
        "notes": english(decay_remarks(decay)),
    })
}

/// Stiffness of a building's storey in plan, SI.
fn plan(answer: &PlanAnswer) -> Value {
    let found = &answer.found;
    let mode = |mode: &PlanMode| {
        as_json!({
            "frequency_hz": mode.frequency_hz,
            "frequency_sd_hz": mode.frequency_sd_hz,
            "motion": mode.motion,
            "twist": mode.twist.map(|twist| twist.ratio),
            "twist_sd": mode.twist.map(|twist| twist.sd),
            "shape": mode.shape,
        })
    };
    let solution = |one: &PlanSolution| with(one, as_json!({ "energy_shares": one.energy_shares() }));
    as_json!({
        "modes": answer.modes.iter().map(mode).collect::<Vec<_>>(),
        "centre_of_mass_m": answer.centre_of_mass_m,
        "written_stiffness": answer.written.stiffness,
        "written_eccentricity_m": answer.written.eccentricity_m,
        "eccentricity_from": found.eccentricity_from,
        "solutions": found.solutions.iter().map(solution).collect::<Vec<_>>(),
        "accepted": found.accepted().count(),
        "load_factors": answer.load_factors,
        "complete": found.complete,
        "singles": found.singles,
        "free": found.free,
        "is_determined": answer.determined().is_some(),
        "bounds": answer.bounds,
        "sensors_off_the_floor": answer.off_floor,
        "beside_file": answer.beside_file,
        "from_record": answer.from_record.map(|of| as_json!({
            "sensors": of.sensors,
            "modes_found": of.modes_found,
            "unexplained": of.unexplained,
        })),
    })
}

/// Factors on the springs of a stack's joints, SI.
fn joint_factors(answer: &FactorsAnswer) -> Value {
    let found = &answer.found;
    let factor = |(at, one): (usize, &JointFactor)| {
        let [upper, lower] = answer.names(at);
        with(
            one,
            as_json!({
                "upper": upper,
                "lower": lower,
                "stiffness_in_file_pa_m": answer.drawn_stiffness_pa_m(at),
            }),
        )
    };
    as_json!({
        "of": found.of,
        "common": found.common,
        "band": found.band,
        "factors": found.factors.iter().enumerate().map(factor).collect::<Vec<_>>(),
        "modes": found.modes,
        "unused": found.unused,
        "fixed_combinations": found.fixed_combinations,
        "singular_values": found.singular_values,
        "best_misfit": found.best_misfit,
        "explains": found.explains,
        "open_joints": found.open_joints,
        "resettled_change": found.resettled.as_ref().ok(),
        "resettled_error": found.resettled.as_ref().err().map(Advice::advised),
        "other_directions": answer.other_directions,
        "side_supports": answer.beside,
    })
}

fn stiffness(answer: &StiffnessAnswer) -> Value {
    let found = &answer.solutions;
    as_json!({
        "direction": answer.direction,
        "convention": answer.convention,
        "unit": if answer.convention.is_some() { "N/m" } else { "N m/rad" },
        "frequencies_hz": answer.frequencies_hz,
        "with_shapes": answer.with_shapes,
        "choice": found.choice,
        "load_factors": answer.load_factors,
        "peaks_below_hz": answer.peaks_below_hz,
        "is_chosen": answer.is_chosen(),
        "doubted": answer.doubted.map(|of| match of {
            StiffnessDoubt::Sensors => as_json!({ "of": "sensors", "unexplained": null }),
            StiffnessDoubt::Shapes { unexplained } => as_json!({ "of": "shapes", "unexplained": unexplained }),
            StiffnessDoubt::MoreModes => as_json!({ "of": "more_modes", "unexplained": null }),
            StiffnessDoubt::Machine { .. } => as_json!({ "of": "machine", "unexplained": null }),
        }),
        "other_choices": answer.other_choices.iter().map(|of| as_json!({
            "frequencies_hz": of.frequencies_hz,
            "stiffness": of.stiffness,
            "stiffness_sd": of.stiffness_sd,
        })).collect::<Vec<_>>(),
        "beside_file": answer.beside_file,
        "solutions": found.solutions,
        "visibility": found.visibility,
        "starts": found.starts,
        "notes": found.notes.iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}
