//! Data of the earthquakes of motions.

/// Data of the earthquake of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EarthquakeOf {
    /// Its magnitude, if the file gives it.
    pub magnitude: Option<f64>,
    /// Its distance, km, if the file gives it.
    pub distance_km: Option<f64>,
    /// Time from 5 to 95 % of the motion's Arias intensity, s.
    pub duration_s: Option<f64>,
}
