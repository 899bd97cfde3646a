//! A building in histories of the wind of its file, compared with the mean square.

use super::simulation::BeyondRoom;
use super::wind_answer::WIND_DURATION_S;
use dolmen::damper::GustPeak;
use dolmen::numeric::variance;
use dolmen::structure::Building;
use dolmen_project::{BuiltDamper, Names, strokes_of};

/// Results of `dolmen simulate --wind`.
#[derive(Clone, Debug, PartialEq)]
pub struct WindSimulation {
    /// The project file, as the user named it.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// The variant of the file; `None` for the structure as given.
    pub variant: Option<String>,
    /// A longer name of the variant, if the file gives one.
    pub variant_title: Option<Names>,
    /// Names of the floors, lowest first.
    pub floors: Vec<String>,
    /// The building.
    pub building: Building,
    /// Its dampers.
    pub dampers: Vec<BuiltDamper>,
    /// Largest allowed peak acceleration of the top floor, m/s².
    pub acceleration_limit_m_s2: Option<f64>,
    /// Largest allowed drift ratio of a storey.
    pub drift_limit: Option<f64>,
    /// Distance of the force from the middle of the breadth, relative to the breadth, to either side.
    pub eccentricity: f64,
    /// Length of each history, s.
    pub duration_s: f64,
    /// Time between samples, s.
    pub time_step_s: f64,
    /// Period after which each history would repeat, s.
    pub period_s: f64,
    /// Seed of each history.
    pub seeds: Vec<u64>,
    /// The wind along x, along y.
    pub along: [HistoriesAlong; 2],
}

/// Histories of the wind from one side.
#[derive(Clone, Debug, PartialEq)]
pub struct HistoriesAlong {
    /// Mean breadth of the floors across the wind, m.
    pub breadth_m: f64,
    /// Without dampers.
    pub without: MotionInTime,
    /// With the dampers of the file, if it has any, in the same gusts.
    pub with: Option<MotionInTime>,
}

/// Motion of the building in histories of the wind from one side.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionInTime {
    /// Displacement of the top floor along the wind, m.
    pub top_displacement_m: InTime,
    /// Drift along the wind of each storey at its worse edge, m, lowest first.
    pub drifts_m: Vec<InTime>,
    /// Acceleration of the centre of mass of the top floor along the wind, m/s².
    pub top_acceleration_m_s2: InTime,
    /// Acceleration of the worst corner of the top floor in its worst direction, m/s².
    pub corner_m_s2: InTime,
    /// Shear along the wind in the walls of the lowest storey, N.
    pub base_shear_n: InTime,
    /// Their torque about the vertical through the centre of all mass, N·m.
    pub base_torque_n_m: InTime,
    /// Strokes of the dampers, then the liquids of columns on springs, m.
    pub strokes_m: Vec<InTime>,
}

/// A quantity in histories of the wind. Where it has several rows, such as both edges and each eccentricity, the row with the largest mean
/// peak.
#[derive(Clone, Debug, PartialEq)]
pub struct InTime {
    /// The same by the mean square, the worst of these rows.
    pub mean_square: GustPeak,
    /// Mean of the histories.
    pub mean: f64,
    /// Standard deviation about the mean, over all histories.
    pub rms: f64,
    /// Largest absolute value in each history.
    pub peaks: Vec<f64>,
    /// The first history.
    pub first: Vec<f64>,
}

impl InTime {
    /// Mean of the peaks.
    pub fn peak(&self) -> f64 {
        self.peaks.iter().sum::<f64>() / self.peaks.len().max(1) as f64
    }

    /// The value compared with limits: the mean of the peaks, or the peak by the mean square if that is larger.
    pub fn judged(&self) -> f64 {
        self.peak().max(self.mean_square.peak())
    }

    /// Standard deviation of the peaks; `None` for fewer than two histories.
    pub fn peak_rms(&self) -> Option<f64> {
        variance(&self.peaks).ok().map(f64::sqrt)
    }

    /// Number of histories beyond a limit.
    pub fn beyond(&self, limit: f64) -> usize {
        self.peaks.iter().filter(|peak| **peak > limit).count()
    }

    /// The largest peak of all.
    pub fn largest(&self) -> f64 {
        self.peaks.iter().copied().fold(0.0, f64::max)
    }
}

impl HistoriesAlong {
    /// With the dampers if there are any, otherwise without.
    pub fn as_it_is(&self) -> &MotionInTime {
        self.with.as_ref().unwrap_or(&self.without)
    }
}

impl WindSimulation {
    /// With the dampers if there are any, otherwise without: the wind along x, along y.
    pub fn motions(&self) -> [&MotionInTime; 2] {
        self.along.each_ref().map(HistoriesAlong::as_it_is)
    }

    /// The largest peak acceleration of the top floor, in the mean over the histories, and its wind, 0 along x and 1 along y.
    pub fn top_acceleration(&self) -> (usize, &InTime) {
        let [x, y] = self.motions().map(|motion| &motion.corner_m_s2);
        if x.peak() >= y.peak() { (0, x) } else { (1, y) }
    }

    /// The storey with the largest drift ratio in the mean of the histories: the wind, the storey from 0.
    pub fn largest_drift(&self) -> Option<DriftInTime> {
        self.drift_by(InTime::peak)
    }

    /// The acceleration of the top floor for the comparison with its limit, m/s².
    pub fn judged_acceleration_m_s2(&self) -> f64 {
        let [x, y] = self.motions().map(|motion| motion.corner_m_s2.judged());
        x.max(y)
    }

    /// The drift for the comparison with its limit: the largest over its height.
    pub fn judged_drift(&self) -> Option<DriftInTime> {
        self.drift_by(InTime::judged)
    }

    /// Each stroke for the comparison with its room, m.
    pub fn judged_strokes_m(&self) -> Vec<f64> {
        self.strokes_by(InTime::judged)
    }

    /// Dampers whose stroke, in the mean over the histories or by the mean square, exceeds their room.
    pub fn beyond_room(&self) -> Vec<BeyondRoom> {
        BeyondRoom::of(&self.dampers, self.judged_strokes_m().into_iter())
    }

    /// Dampers that meet their stops in some history, whatever the mean.
    pub fn struck(&self) -> Vec<Struck> {
        let [x, y] = self.motions();
        let pairs = x.strokes_m.iter().zip(&y.strokes_m);
        let each = strokes_of(&self.dampers).into_iter().zip(pairs);
        let found = each.filter_map(|(of, (x, y))| {
            let room_m = of.room_m?;
            let mut peaks = x.peaks.iter().zip(&y.peaks).map(|(x, y)| x.max(*y));
            let histories = peaks.by_ref().filter(|peak| *peak > room_m).count();
            (histories > 0).then(|| Struck {
                name: of.name,
                histories,
                largest_m: x.largest().max(y.largest()),
                room_m,
            })
        });
        found.collect()
    }

    /// Whether a history is at least as long as the time for which the limits hold.
    pub fn is_as_long_as_its_wind(&self) -> bool {
        self.duration_s >= WIND_DURATION_S
    }

    fn strokes_by(&self, value: fn(&InTime) -> f64) -> Vec<f64> {
        let [x, y] = self.motions();
        let pairs = x.strokes_m.iter().zip(&y.strokes_m);
        pairs.map(|(x, y)| value(x).max(value(y))).collect()
    }

    fn drift_by(&self, value: fn(&InTime) -> f64) -> Option<DriftInTime> {
        let each = self.motions().into_iter().enumerate();
        let all = each.flat_map(|(axis, motion)| {
            let storeys = motion.drifts_m.iter().zip(self.building.storeys()).enumerate();
            storeys.map(move |(storey, (drift, of))| DriftInTime {
                axis,
                storey,
                of_height: value(drift) / of.height_m,
            })
        });
        all.max_by(|a, b| a.of_height.total_cmp(&b.of_height))
    }
}

/// A damper that meets its stops in some histories.
#[derive(Clone, Debug, PartialEq)]
pub struct Struck {
    /// Name of its stroke.
    pub name: String,
    /// Number of these histories.
    pub histories: usize,
    /// Its largest stroke in all histories, m.
    pub largest_m: f64,
    /// Its room, m.
    pub room_m: f64,
}

/// The drift of a storey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriftInTime {
    /// The wind, 0 along x and 1 along y.
    pub axis: usize,
    /// The storey, from 0.
    pub storey: usize,
    /// Its peak drift ratio.
    pub of_height: f64,
}
