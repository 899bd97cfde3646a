//! A building under moving ground, in time.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | a | | acceleration of the ground, straight between its samples, 0 after the last | m/s² |
//! | q | | u, v, θ of the centres of mass of the floors relative to the ground | m, rad |
//! | V, T | `base_shear_n`, `base_torque_n_m` | k_1 q_1, the forces in the walls of the lowest storey; T about the centre of all mass | N, N·m |

use super::building_peaks::{BuildingPeaks, Peak};
use super::complex_modes::{Steps, complex_modes};
use super::exponential::ExponentialSteps;
use super::peak_tracking::PeakTracker;
use super::peaks::{RequestedHistories, Watcher};
use super::stepping::{Ground, Stepping, walk};
use super::vibrating::VibratingBuilding;
use crate::dynamics::DynamicsError;
use crate::signal::{Component, GroundMotion};
use dolmen_linalg::Matrix;

/// Duration after the motion: at least this long, s, as for frames and chains, and at least this many periods of the slowest mode or mass. Our
/// choice.
const REST_LEAST_S: f64 = 20.0;
const REST_PERIODS: f64 = 10.0;
/// Largest number of steps of a run: 10 million numbers for ten floors. Our choice.
const STEPS_MOST: usize = 4_000_000;

/// Options of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BuildingRun {
    /// Number of steps per sample of the motion, which is linear between samples; 0 counts as 1.
    pub steps_per_sample: usize,
    /// End of the run, s. `None`: after the motion, with the ground at rest, for 10 periods of the slowest mode or mass, and at least 20 s.
    pub end_s: Option<f64>,
    /// Points whose motion and absolute acceleration are requested, each a row of
    /// [`Building::point_row`](crate::structure::Building::point_row).
    pub watched: Vec<Vec<f64>>,
    /// The requested output.
    pub histories: Histories,
}

/// Output of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Histories {
    /// Every value at every step.
    #[default]
    Kept,
    /// Only largest values: histories are empty; for twenty storeys this saves 4 MB.
    PeaksAlone,
}

/// Method of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HistoryMethod {
    /// Mode by mode, exactly. If tuned masses couple the modes, the complex modes are roots of the secular equation.
    ComplexModes,
    /// By the matrix exponential, exactly. Used if two complex modes coincide, or some do not oscillate.
    MatrixExponential,
}

/// The history of a point.
#[derive(Clone, Debug, PartialEq)]
pub struct WatchedHistory {
    /// Displacement relative to the ground at each step, m; empty if only peaks were requested.
    pub displacement_m: Vec<f64>,
    /// Absolute acceleration at each step, m/s²; empty if only peaks were requested.
    pub acceleration_m_s2: Vec<f64>,
    /// Largest displacement, m.
    pub displacement_peak_m: Peak,
    /// Largest absolute acceleration, m/s².
    pub acceleration_peak_m_s2: Peak,
}

/// The history of a building.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingHistory {
    /// Time between steps, s.
    pub time_step_s: f64,
    /// Number of steps.
    pub steps: usize,
    /// u, v, θ of each floor, lowest first, then the stroke of each mass: one column for each step, the first at rest; no columns if only
    /// peaks were requested.
    pub coordinates: Matrix,
    /// Elastic base shear along x, y, N, and base torque, N·m: one column for each step; no columns if only peaks were requested.
    pub base: Matrix,
    /// Method of the run.
    pub method: HistoryMethod,
    /// Largest values.
    pub peaks: BuildingPeaks,
    /// Histories of the watched points, in their order.
    pub watched: Vec<WatchedHistory>,
}

impl BuildingHistory {
    /// Whether a displacement or stroke was largest at the end of the run, so that it may have grown further.
    pub fn grows_at_the_end(&self) -> bool {
        let last_s = (self.length() as f64 - 1.5) * self.time_step_s;
        let floors = self.peaks.floors.iter();
        let each =
            floors.flat_map(|floor| [floor.displacement_x_m, floor.displacement_y_m, floor.rotation_rad]);
        let mut all = each.chain(self.peaks.strokes_m.iter().copied());
        all.any(|peak| peak.value != 0.0 && peak.at_s >= last_s)
    }

    /// Number of steps, including the first at rest.
    pub fn length(&self) -> usize {
        self.steps + 1
    }

    /// The time of a step, s.
    pub fn time_s(&self, step: usize) -> f64 {
        step as f64 * self.time_step_s
    }

    /// Displacement of a point along a direction over time, m, from its row by [`Building::point_row`](crate::structure::Building::point_row).
    pub fn along(&self, row: &[f64]) -> Vec<f64> {
        let used: Vec<(usize, f64)> = row
            .iter()
            .copied()
            .enumerate()
            .filter(|(_, x)| *x != 0.0)
            .collect();
        let at = |step: usize| {
            let column = self.coordinates.column(step);
            used.iter().map(|&(i, factor)| factor * column[i]).sum()
        };
        (0..self.coordinates.columns()).map(at).collect()
    }
}

/// The motion of a building under a motion of the ground, from rest.
///
/// ```text
/// M q″ + C q′ + K q = −M ι_x a_x − M ι_y a_y + tuned masses          3N + D values a step
/// ```
/// The ground acceleration is linear between samples, and the solution is exact for it. It is computed mode by mode; with tuned masses by
/// complex modes, whose frequencies are roots of a secular equation with one unknown for each mass; and by the matrix exponential if two of
/// these coincide. Peaks between the steps follow from the states at both ends of the steps next to the largest value, by the polynomial of
/// degree five through value, velocity and acceleration there.
///
/// # Errors
/// [`DynamicsError::Argument`] for a motion without x and y, an end before 0, or too many steps.
///
/// # Limits
/// Displacements are small and walls linear. For a mode with a period of 10 steps, a peak has a relative error of 2e-6. It is the peak next to
/// the largest value at a step. A different peak that is higher between steps by less than π²/(2n²), with n steps per period, may be missed.
/// For a 20-storey building with a tuned mass and 40 s of El Centro at 0.005 s, the difference from the matrix exponential is below 1e-9 m.
///
/// # Example
/// ```
/// use dolmen::dynamics::{BuildingRun, VibratingBuilding, building_history};
/// use dolmen::signal::{Component, GroundMotion};
/// use dolmen::structure::building::{Building, BuildingDamping, Floor, PDelta, Storey, StoreyStiffness};
/// let floor = Floor { mass_kg: 1.0, centre_m: [0.0, 0.0], gyration_m: 2.0, outline: None };
/// let stiffness = StoreyStiffness::at_centre(100.0, 50.0, 300.0, [0.0, 0.0]);
/// let building = Building::new(vec![floor], vec![Storey { height_m: 3.0, stiffness }], PDelta::LeftOut)?;
/// let vibrating = VibratingBuilding::new(building, &BuildingDamping::Modal(vec![0.0]), Vec::new())?;
/// // a sudden constant acceleration of the ground: twice the static displacement
/// let step = GroundMotion::new("step", 0.01, vec![(Component::X, vec![1.0; 200])])?;
/// let history = building_history(&vibrating, &step, &BuildingRun::default())?;
/// assert!((history.peaks.floors[0].displacement_x_m.value + 0.02).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn building_history(
    building: &VibratingBuilding,
    motion: &GroundMotion,
    run: &BuildingRun,
) -> Result<BuildingHistory, DynamicsError> {
    let modes = building.modes().modes.iter().map(|mode| mode.frequency_hz);
    let masses = building.tuned_masses().iter().map(|tuned| tuned.frequency_hz);
    let slowest_hz = modes.chain(masses).fold(f64::INFINITY, f64::min);
    let (ground, over) = shaken(building, motion, run, slowest_hz)?;
    Ok(match complex_modes(building) {
        Some(modes) => over.history(&Steps::new(&modes, over.h), HistoryMethod::ComplexModes, &ground),
        None => over.history(
            &ExponentialSteps::of_building(building, over.h),
            HistoryMethod::MatrixExponential,
            &ground,
        ),
    })
}

/// The ground motion of a run, step by step, and its duration.
pub(crate) fn shaken<'a>(
    building: &'a VibratingBuilding,
    motion: &'a GroundMotion,
    run: &'a BuildingRun,
    slowest_hz: f64,
) -> Result<(impl Fn(usize) -> Ground + 'a, SystemRun<'a>), DynamicsError> {
    if let Some(row) = run
        .watched
        .iter()
        .position(|row| row.len() != building.building().coordinates())
    {
        return Err(DynamicsError::Entries {
            argument: "watched",
            given: run.watched[row].len(),
            needed: building.building().coordinates(),
        });
    }
    let cut = run.steps_per_sample.max(1);
    if cut > STEPS_MOST {
        return Err(DynamicsError::Argument {
            argument: "steps_per_sample",
            given: cut as f64,
            allowed: "at most 4 000 000",
        });
    }
    let h = motion.time_step_s() / cut as f64;
    let axes: Vec<(usize, &[f64])> = [Component::X, Component::Y]
        .into_iter()
        .enumerate()
        .filter(|(_, component)| motion.has(*component))
        .map(|(axis, component)| (axis, motion.acceleration_m_s2(component)))
        .collect();
    if axes.is_empty() {
        return Err(DynamicsError::Argument {
            argument: "horizontal components of the motion",
            given: 0.0,
            allowed: "1 or 2: x, y or both",
        });
    }
    let steps = match run.end_s {
        None => {
            let rest_s = REST_LEAST_S.max(REST_PERIODS / slowest_hz);
            let steps = (motion.length() - 1) as f64 * cut as f64 + (rest_s / h).ceil();
            if steps > STEPS_MOST as f64 {
                return Err(DynamicsError::Argument {
                    argument: "steps of the motion with 10 periods after it",
                    given: steps,
                    allowed: "at most 4 000 000: give end_s, or longer steps",
                });
            }
            steps as usize
        }
        Some(end_s) if end_s >= 0.5 * h && end_s / h <= STEPS_MOST as f64 => (end_s / h).round() as usize,
        Some(end_s) => {
            return Err(DynamicsError::Argument {
                argument: "end_s",
                given: end_s,
                allowed: "one step at least, and at most 4 000 000",
            });
        }
    };
    let ground = move |step: usize| -> Ground {
        let (sample, part) = (step / cut, (step % cut) as f64);
        let mut ground = Ground::default();
        for &(axis, values) in &axes {
            if let Some(&[before, after]) = values.get(sample..sample + 2) {
                let slope = (after - before) / cut as f64;
                ground[axis] = [before + part * slope, before + (part + 1.0) * slope];
            }
        }
        ground
    };
    let over = SystemRun {
        building,
        steps,
        h,
        watched: &run.watched,
        histories: run.histories,
    };
    Ok((ground, over))
}

/// The system of a run, and its outputs.
pub(crate) struct SystemRun<'a> {
    pub(crate) building: &'a VibratingBuilding,
    steps: usize,
    pub(crate) h: f64,
    watched: &'a [Vec<f64>],
    histories: Histories,
}

impl SystemRun<'_> {
    /// The whole run: steps, peaks at the steps, and peaks between them.
    pub(crate) fn history(
        &self,
        stepping: &impl Stepping,
        method: HistoryMethod,
        ground: &dyn Fn(usize) -> Ground,
    ) -> BuildingHistory {
        let (own, points) = (stepping.outputs().rows(), self.watched.len());
        let watcher = Watcher::new(self.building, stepping, self.watched);
        let mut tracker = PeakTracker::new(watcher.floor_extents(), watcher.others());
        let mut kept = match self.histories {
            Histories::Kept => Some(RequestedHistories::new(own, points, self.steps)),
            Histories::PeaksAlone => None,
        };
        let mut see = |block: &Matrix, first: usize, now: usize| {
            watcher.see(block, (first, now), &mut tracker, kept.as_mut());
        };
        let states = walk(stepping, &watcher.outputs, self.steps, ground, &mut see);
        let (largest, longest) = tracker.found();
        let looked = (&largest[..], &longest[..]);
        let found = watcher.peaks(looked, (self.steps + 1, self.h), &states, stepping, ground);
        let RequestedHistories {
            coordinates,
            base,
            moved,
            felt,
        } = kept.unwrap_or_else(|| RequestedHistories::none(own, points));
        let mut history = BuildingHistory {
            time_step_s: self.h,
            steps: self.steps,
            coordinates,
            base,
            method,
            peaks: BuildingPeaks::default(),
            watched: Vec::new(),
        };
        history.peaks = found.building;
        let each = moved.into_iter().zip(felt).zip(found.watched);
        history.watched = each
            .map(
                |((displacement_m, acceleration_m_s2), [displacement_peak_m, acceleration_peak_m_s2])| {
                    WatchedHistory {
                        displacement_m,
                        acceleration_m_s2,
                        displacement_peak_m,
                        acceleration_peak_m_s2,
                    }
                },
            )
            .collect();
        history
    }
}
