//! The simulation of a building, with its input.

use crate::motion::MotionAnswer;
use crate::tilt_left_out::TiltLeftOut;
use dolmen::assess::demand::DriftLimit;
use dolmen::dynamics::{
    BuildingHistory, BuildingPeaks, Peak, ResultantDrift, VibratingBuilding, WatchedHistory,
};
use dolmen::signal::Component;
use dolmen_project::{BuiltDamper, Names, strokes_of};

/// A point of a floor whose motion is recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct WatchedPoint {
    /// Its name.
    pub name: String,
    /// Its floor, from 1.
    pub floor: usize,
    /// Its place in plan, m.
    pub place_m: [f64; 2],
    /// Displacement and absolute acceleration along x and y.
    pub along: [WatchedHistory; 2],
}

/// The largest drift ratio of a storey.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LargestDrift {
    /// The storey, from 1.
    pub storey: usize,
    /// Drift over height.
    pub ratio: f64,
    /// Whether it is at a corner of the floor above; without an outline it is at its centre of mass.
    pub at_corner: bool,
    /// The drift as a vector, its place and time.
    pub drift: ResultantDrift,
}

/// A largest value with dampers relative to that without.
#[derive(Clone, Debug, PartialEq)]
pub struct Against {
    /// Its name, in English and Korean.
    pub what: [String; 2],
    /// The ratio.
    pub ratio: f64,
}

/// A damper whose stroke exceeds its room.
#[derive(Clone, Debug, PartialEq)]
pub struct BeyondRoom {
    /// The damper, or "NAME liquid".
    pub name: String,
    /// Its largest stroke, m.
    pub stroke_m: f64,
    /// Its room in each direction, m.
    pub room_m: f64,
}

impl BeyondRoom {
    /// The dampers among those with these strokes, m, in the order of [`strokes_of`].
    pub fn of(dampers: &[BuiltDamper], strokes_m: impl Iterator<Item = f64>) -> Vec<Self> {
        let pairs = strokes_of(dampers).into_iter().zip(strokes_m);
        let beyond = pairs.filter_map(|(stroke, stroke_m)| {
            let room_m = stroke.room_m?;
            (stroke_m > room_m).then_some(BeyondRoom {
                name: stroke.name,
                stroke_m,
                room_m,
            })
        });
        beyond.collect()
    }
}

/// A simulation of a building, and its inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingSimulation {
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
    /// The building, including its tuned masses if all dampers are of that kind; other dampers are separate.
    pub building: VibratingBuilding,
    /// The dampers.
    pub dampers: Vec<BuiltDamper>,
    /// The motion of the ground.
    pub motion: MotionAnswer,
    /// Allowable drift of storeys; `None` where the file gives none.
    pub drift_limit: Option<DriftLimit>,
    /// The response.
    pub history: BuildingHistory,
    /// The response without the dampers; `None` if there are none.
    pub without_dampers: Option<Box<BuildingHistory>>,
    /// Points of the file.
    pub points: Vec<WatchedPoint>,
    /// A surveyed tilt that is not in the start of the run.
    pub tilt_left_out: Option<TiltLeftOut>,
    /// Whether the file gives a wind, which is not applied during a motion.
    pub without_wind: bool,
}

impl BuildingSimulation {
    /// End of the run, s, if it is before that of the motion: results then cover only that part.
    pub fn ended_before_the_motion_s(&self) -> Option<f64> {
        let history = &self.history;
        self.motion
            .cut_at_s(history.time_s(history.length().saturating_sub(1)))
    }

    /// Largest drift ratio of all storeys in any direction, at a corner if the outline of the floor above is known.
    pub fn drift(&self) -> LargestDrift {
        let storeys = self.building.building().storeys();
        let each = self.history.peaks.storeys.iter().zip(storeys).enumerate();
        let drifts = each.map(|(i, (peak, storey))| LargestDrift {
            storey: i + 1,
            ratio: peak.resultant.size_m / storey.height_m,
            at_corner: peak.edge_drift_x_m.is_some(),
            drift: peak.resultant,
        });
        drifts.fold(LargestDrift::default(), |most, own| {
            if own.ratio > most.ratio { own } else { most }
        })
    }

    /// Largest values with dampers relative to those without, each along x and y: top, worst drift of a storey, points. Leaves out a
    /// quantity whose value without dampers is below a thousandth of the largest of its kind; empty without dampers.
    pub fn against_without(&self) -> Vec<Against> {
        const HARDLY: f64 = 1e-3;
        let Some(without) = &self.without_dampers else {
            return Vec::new();
        };
        let mut all = Vec::new();
        let mut add = |pairs: Vec<([String; 2], f64, f64)>| {
            let largest = pairs
                .iter()
                .map(|(_, _, without)| without.abs())
                .fold(0.0, f64::max);
            for (what, with, without) in pairs {
                if without.abs() > HARDLY * largest {
                    all.push(Against {
                        what,
                        ratio: (with / without).abs(),
                    });
                }
            }
        };
        let axes = ["x", "y"];
        let peaks = [&self.history.peaks, &without.peaks];
        let top = peaks.map(|peaks| {
            let floor = peaks.floors.last().copied().unwrap_or_default();
            [floor.displacement_x_m.value, floor.displacement_y_m.value]
        });
        add((0..2)
            .map(|axis| {
                let words = [
                    format!("the top along {}", axes[axis]),
                    format!("최상층 {} 방향", axes[axis]),
                ];
                (words, top[0][axis], top[1][axis])
            })
            .collect());
        let base = |peaks: &BuildingPeaks| peaks.base_shear_n.map(|peak| peak.value);
        let shear = peaks.map(base);
        add((0..2)
            .map(|axis| {
                let words = [
                    format!("the base shear along {}", axes[axis]),
                    format!("밑면 전단력 {} 방향", axes[axis]),
                ];
                (words, shear[0][axis], shear[1][axis])
            })
            .collect());
        // an arm of less than a millimetre gives no meaningful torque
        let torque = peaks.map(|peaks| peaks.base_torque_n_m.value);
        if torque[1].abs() > HARDLY * shear[1][0].abs().max(shear[1][1].abs()) {
            let words = ["the base torque", "밑면 비틀림 모멘트"].map(str::to_owned);
            add(vec![(words, torque[0], torque[1])]);
        }
        let drift = |peaks: &BuildingPeaks, storey: usize, axis: usize| {
            let own = &peaks.storeys[storey];
            let edge = [own.edge_drift_x_m, own.edge_drift_y_m][axis];
            edge.unwrap_or([own.drift_x_m, own.drift_y_m][axis]).value
        };
        let storeys = (0..self.floors.len()).flat_map(|storey| (0..2).map(move |axis| (storey, axis)));
        add(storeys
            .map(|(storey, axis)| {
                let name = &self.floors[storey];
                let floor = match name.bytes().all(|byte| byte.is_ascii_digit()) {
                    true => format!("{name}번"),
                    false => name.clone(),
                };
                let words = [
                    format!("the drift along {} below floor {name}", axes[axis]),
                    format!("{floor} 바닥 아래 {} 방향 층간변위", axes[axis]),
                ];
                (
                    words,
                    drift(peaks[0], storey, axis),
                    drift(peaks[1], storey, axis),
                )
            })
            .collect());
        let points = self.points.iter().zip(without.watched.chunks_exact(2));
        let each = points.flat_map(|(point, other)| (0..2).map(move |axis| (point, axis, other)));
        add(each
            .map(|(point, axis, other)| {
                let words = [
                    format!("point {} along {}", point.name, axes[axis]),
                    format!("{} 지점 {} 방향", point.name, axes[axis]),
                ];
                let with = point.along[axis].displacement_peak_m.value;
                (words, with, other[axis].displacement_peak_m.value)
            })
            .collect());
        all
    }

    /// Names of the strokes: the dampers, then the liquids of columns on springs.
    pub fn stroke_names(&self) -> Vec<String> {
        let strokes = strokes_of(&self.dampers).into_iter();
        strokes.map(|stroke| stroke.name).collect()
    }

    /// The largest force of the dashpot of each damper, N, and its time; `None` for a liquid column, which has no dashpot.
    pub fn dashpot_forces_n(&self) -> Vec<Option<Peak>> {
        let pairs = self.dampers.iter().zip(&self.history.peaks.stroke_rates_m_s);
        let each = pairs.map(|(damper, rate)| {
            Some(Peak {
                value: damper.dashpot_n_s_m()? * rate.value,
                at_s: rate.at_s,
            })
        });
        each.collect()
    }

    /// Dampers at right angles to the shaking: only the rotation of their floor moves them, so the run does not show their effect.
    pub fn across_the_motion(&self) -> Vec<&BuiltDamper> {
        const HARDLY: f64 = 1e-6; // a rotation by 90° leaves 1e-16 along an axis
        let motion = &self.motion.motion;
        let of = |component| match motion.has(component) {
            true => motion.acceleration_m_s2(component),
            false => &[],
        };
        let shaken = [of(Component::X), of(Component::Y)];
        let along = |[c_x, c_y]: [f64; 2]| {
            let at = |axis: usize, i: usize| shaken[axis].get(i).copied().unwrap_or(0.0);
            let each = (0..motion.length()).map(|i| (c_x * at(0, i) + c_y * at(1, i)).abs());
            each.fold(0.0, f64::max)
        };
        let peak = along([1.0, 0.0]).max(along([0.0, 1.0]));
        let is_across = |damper: &&BuiltDamper| along(damper.direction.unit()) <= HARDLY * peak;
        self.dampers.iter().filter(is_across).collect()
    }

    /// Dampers whose stroke exceeds their room: the run has no stops.
    pub fn beyond_room(&self) -> Vec<BeyondRoom> {
        let strokes = self.history.peaks.strokes_m.iter();
        BeyondRoom::of(&self.dampers, strokes.map(|stroke| stroke.value.abs()))
    }
}
