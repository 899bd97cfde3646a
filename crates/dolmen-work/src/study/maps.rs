//! Additional results of a study: maps of sticking and slipping under harmonic motions, for frames and chains; releases of frames.

use super::column::{Column, ColumnValues};
use super::kind::StudyKind;
use dolmen::dynamics::{AtAmplitude, HarmonicPoint};

/// The map and the release of one case.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseMaps {
    /// The case, counted from 0.
    pub case: usize,
    /// Its description: variant and inputs; empty if there is only one case.
    pub label: String,
    /// Names of the storeys, or of the links above the joints, lowest first.
    pub parts: Vec<String>,
    /// Points of the map, rows of one frequency; empty without one.
    pub harmonic: Vec<HarmonicPoint>,
    /// Cycles of the release, the largest first; empty without one.
    pub release: Vec<AtAmplitude>,
}

/// Points of all maps: one row for each case, frequency, acceleration and storey or joint.
pub fn harmonic_columns(maps: &[ResponseMaps], kind: StudyKind) -> Vec<Column> {
    let [part, deformation, share, fell] = match kind {
        StudyKind::Chain => ["joint_below", "joint_rotation_rad", "moving_share", "fell"],
        _ => ["storey", "drift_m", "slipping_share", "beyond the drift limit"],
    };
    let mut rows: Vec<(&ResponseMaps, &HarmonicPoint, usize)> = Vec::new();
    for map in maps {
        for point in &map.harmonic {
            rows.extend((0..point.deformation.len()).map(|part| (map, point, part)));
        }
    }
    let numbers = |name: &str, of: &dyn Fn(&(&ResponseMaps, &HarmonicPoint, usize)) -> f64| Column {
        name: name.to_owned(),
        values: ColumnValues::Numbers(
            rows.iter()
                .map(|row| Some(of(row)).filter(|v| v.is_finite()))
                .collect(),
        ),
    };
    let words = |name: &str, of: &dyn Fn(&(&ResponseMaps, &HarmonicPoint, usize)) -> String| Column {
        name: name.to_owned(),
        values: ColumnValues::Words(rows.iter().map(of).collect()),
    };
    vec![
        Column {
            name: "case".to_owned(),
            values: ColumnValues::Counts(rows.iter().map(|(map, ..)| map.case as i64 + 1).collect()),
        },
        words("inputs", &|(map, ..)| map.label.clone()),
        numbers("frequency_hz", &|(_, point, _)| point.frequency_hz),
        numbers("ground_acceleration_m_s2", &|(_, point, _)| {
            point.ground_acceleration_m_s2
        }),
        words(part, &|(map, _, part)| {
            map.parts.get(*part).cloned().unwrap_or_default()
        }),
        numbers(deformation, &|(_, point, part)| point.deformation[*part]),
        numbers(share, &|(_, point, part)| point.moving_share[*part]),
        words("state", &|(_, point, _)| {
            let state = match (point.fell, point.steady) {
                (true, _) => fell,
                (false, true) => "steady",
                (false, false) => "not steady",
            };
            state.to_owned()
        }),
    ]
}

/// Cycles of all releases: one row for each case and cycle.
pub fn release_columns(maps: &[ResponseMaps]) -> Vec<Column> {
    let mut rows: Vec<(&ResponseMaps, &AtAmplitude)> = Vec::new();
    for map in maps {
        rows.extend(map.release.iter().map(|swing| (map, swing)));
    }
    let numbers = |name: &str, of: &dyn Fn(&AtAmplitude) -> f64| Column {
        name: name.to_owned(),
        values: ColumnValues::Numbers(
            rows.iter()
                .map(|(_, swing)| Some(of(swing)).filter(|v| v.is_finite()))
                .collect(),
        ),
    };
    vec![
        Column {
            name: "case".to_owned(),
            values: ColumnValues::Counts(rows.iter().map(|(map, _)| map.case as i64 + 1).collect()),
        },
        Column {
            name: "inputs".to_owned(),
            values: ColumnValues::Words(rows.iter().map(|(map, _)| map.label.clone()).collect()),
        },
        numbers("amplitude_m", &|swing| swing.amplitude_m),
        numbers("apparent_frequency_hz", &|swing| swing.apparent_frequency_hz),
        numbers("equivalent_damping_ratio", &|swing| {
            swing.equivalent_damping_ratio
        }),
    ]
}
