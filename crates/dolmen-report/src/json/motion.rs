//! Results of `dolmen motion`, as JSON.

use crate::as_json;
use dolmen_records::motions::{ComponentReading, Orientation};
use dolmen_work::motion::{MotionReport, MotionSeries};
use serde_json::Value;

/// Everything except the samples: files and channels, measures, spectra, the match.
pub fn motion_report_json(report: &MotionReport) -> Value {
    let files = report.files.iter().map(|(file, channels)| {
        as_json!({ "file": file, "channels": channels.iter().map(channel).collect::<Vec<_>>() })
    });
    as_json!({
        "files": files.collect::<Vec<_>>(),
        "series": report.series.iter().map(series).collect::<Vec<_>>(),
        "match": report.matched.as_ref().map(|answer| as_json!({
            "demand": answer.demand,
            "component": answer.component.name(),
            "damping_ratio": answer.damping_ratio,
            "factor": answer.matched.factor,
            "rounds": answer.matched.rounds,
            "misfit_before": answer.matched.before,
            "misfit": answer.matched.after,
            "misfit_below": answer.outside[0],
            "misfit_above": answer.outside[1],
            "period_s": answer.matched.periods_s,
            "target_acceleration_m_s2": answer.matched.target_m_s2,
            "pseudo_acceleration_m_s2": answer.matched.matched_m_s2,
        })),
    })
}

fn channel(channel: &ComponentReading) -> Value {
    let azimuth = match channel.orientation {
        Some(Orientation::Horizontal { azimuth_deg }) => Some(azimuth_deg),
        _ => None,
    };
    let vertical = match channel.orientation {
        Some(Orientation::Up) => Some("up"),
        Some(Orientation::Down) => Some("down"),
        _ => None,
    };
    as_json!({
        "format": channel.format.name(),
        "name": channel.name,
        "title": channel.title,
        "samples": channel.acceleration_m_s2.len(),
        "time_step_s": channel.time_step_s,
        "unit": channel.unit.symbol(),
        "azimuth_deg": azimuth,
        "vertical": vertical,
        "begins_s_since_1970": channel.begins_s,
        "mean_subtracted_m_s2": channel.mean_subtracted_m_s2,
    })
}

fn series(series: &MotionSeries) -> Value {
    let (motion, m) = (&series.motion, &series.measures);
    as_json!({
        "name": series.name,
        "motion": motion.name(),
        "component": series.component.name(),
        "samples": motion.length(),
        "time_step_s": motion.time_step_s(),
        "duration_s": motion.duration_s(),
        "history": motion.history().iter().map(ToString::to_string).collect::<Vec<_>>(),
        "peak_acceleration_m_s2": m.peak_acceleration_m_s2,
        "peak_velocity_m_s": m.peak_velocity_m_s,
        "peak_displacement_m": m.peak_displacement_m,
        "last_velocity_m_s": m.last_velocity_m_s,
        "last_displacement_m": m.last_displacement_m,
        "arias_intensity_m_s": m.arias_intensity_m_s,
        "cumulative_absolute_velocity_m_s": m.cumulative_absolute_velocity_m_s,
        "housner_intensity_m": m.housner_intensity_m,
        "significant_duration_s": m.significant_duration_s,
        "significant_from_s": m.significant_from_s,
        "mean_period_s": m.mean_period_s,
        "predominant_period_s": m.predominant_period_s,
        "spectrum": series.spectrum.iter().map(|ordinate| as_json!({
            "period_s": ordinate.period_s,
            "damping_ratio": ordinate.damping_ratio,
            "displacement_m": ordinate.displacement_m,
            "displacement_at_samples_m": ordinate.displacement_at_samples_m,
            "at_s": ordinate.at_s,
            "pseudo_acceleration_m_s2": ordinate.pseudo_acceleration_m_s2(),
        })).collect::<Vec<_>>(),
    })
}
