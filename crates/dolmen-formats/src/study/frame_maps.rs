//! What a study adds for frames: the map of sticking and slipping under harmonic motions, and releases.

use super::table::{Column, ColumnValues};
use dolmen::dynamics::{AtAmplitude, HarmonicPoint};

/// The map and the release of one case.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameMaps {
    /// The case, counted from 0.
    pub case: usize,
    /// What it is, in words: its variant and inputs; empty if there is only one.
    pub label: String,
    /// Names of the storeys, lowest first.
    pub storeys: Vec<String>,
    /// Points of the map, rows of one frequency; empty without one.
    pub harmonic: Vec<HarmonicPoint>,
    /// Swings of the release, the largest first; empty without one.
    pub release: Vec<AtAmplitude>,
}

/// Points of all maps: one row a case, frequency, acceleration and storey.
pub fn harmonic_columns(maps: &[FrameMaps]) -> Vec<Column> {
    let mut rows: Vec<(&FrameMaps, &HarmonicPoint, usize)> = Vec::new();
    for map in maps {
        for point in &map.harmonic {
            rows.extend((0..point.drift_m.len()).map(|storey| (map, point, storey)));
        }
    }
    let numbers = |name: &str, of: &dyn Fn(&(&FrameMaps, &HarmonicPoint, usize)) -> f64| Column {
        name: name.to_owned(),
        values: ColumnValues::Numbers(
            rows.iter()
                .map(|row| Some(of(row)).filter(|v| v.is_finite()))
                .collect(),
        ),
    };
    let words = |name: &str, of: &dyn Fn(&(&FrameMaps, &HarmonicPoint, usize)) -> String| Column {
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
        words("storey", &|(map, _, storey)| {
            map.storeys.get(*storey).cloned().unwrap_or_default()
        }),
        numbers("drift_m", &|(_, point, storey)| point.drift_m[*storey]),
        numbers("slipping_share", &|(_, point, storey)| {
            point.slipping_share[*storey]
        }),
        words("state", &|(_, point, _)| {
            let state = match (point.beyond_drift_limit, point.steady) {
                (true, _) => "beyond the drift limit",
                (false, true) => "steady",
                (false, false) => "not steady",
            };
            state.to_owned()
        }),
    ]
}

/// Swings of all releases: one row a case and swing.
pub fn release_columns(maps: &[FrameMaps]) -> Vec<Column> {
    let mut rows: Vec<(&FrameMaps, &AtAmplitude)> = Vec::new();
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
