//! A building under moving ground, in time.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | a | | acceleration of the ground, straight between its samples, 0 after the last | m/s² |
//! | q | | u, v, θ of the centres of mass of the floors relative to the ground | m, rad |
//! | V, T | `base_shear_n`, `base_torque_n_m` | ιᵀ K q: what the lowest storey's walls carry; T about the centre of all mass | N, N·m |

use super::complex_modes::{Steps, complex_modes};
use super::exponential::ExponentialSteps;
use super::vibrating::VibratingBuilding;
use crate::dynamics::DynamicsError;
use crate::signal::{Component, GroundMotion};
use dolmen_linalg::Matrix;

/// Steps that are multiplied together: the block stays in the cache. Our choice.
const BLOCK: usize = 128;
/// Most steps of a run: 10 million numbers for ten floors. Our choice.
const STEPS_MOST: usize = 4_000_000;

/// Acceleration of the ground at both ends of a step, along x and along y, m/s².
pub(super) type Ground = [[f64; 2]; 2];

/// How a run is made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BuildingRun {
    /// How many steps a sample of the motion is cut into, the ground moving straight between samples; 0 counts as 1.
    pub steps_per_sample: usize,
    /// When the run ends, s; the end of the motion if `None`. After it the ground stands still.
    pub end_s: Option<f64>,
}

/// How a run was computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HistoryMethod {
    /// Mode by mode, exactly: roots of the secular equation where masses couple the modes.
    ComplexModes,
    /// The matrix exponential, exactly: two complex modes are one, or some do not swing.
    MatrixExponential,
}

/// A largest value, and when.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// The value of largest size, with its sign.
    pub value: f64,
    /// When, s.
    pub at_s: f64,
}

/// Largest motions of a floor, relative to the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FloorPeak {
    /// Displacement of the centre of mass along x, m.
    pub displacement_x_m: Peak,
    /// Displacement of the centre of mass along y, m.
    pub displacement_y_m: Peak,
    /// Rotation, rad.
    pub rotation_rad: Peak,
}

/// Largest drifts of a storey: of the floor above it relative to the floor below it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StoreyPeak {
    /// Drift at the centre of mass of the floor above along x, m.
    pub drift_x_m: Peak,
    /// Drift at the centre of mass of the floor above along y, m.
    pub drift_y_m: Peak,
    /// Largest drift along x anywhere on the floor above: at one of its edges. That of the centre if its outline is not known.
    pub edge_drift_x_m: Peak,
    /// Largest drift along y anywhere on the floor above.
    pub edge_drift_y_m: Peak,
    /// Twist of the storey, rad.
    pub twist_rad: Peak,
}

/// Largest values of a run, at its steps.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BuildingPeaks {
    /// Floors, lowest first.
    pub floors: Vec<FloorPeak>,
    /// Storeys, lowest first.
    pub storeys: Vec<StoreyPeak>,
    /// Travel of each mass relative to its place, m.
    pub strokes_m: Vec<Peak>,
    /// Elastic base shear along x and y, N.
    pub base_shear_n: [Peak; 2],
    /// Elastic base torque about the centre of all mass, N·m.
    pub base_torque_n_m: Peak,
}

/// A building in time.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingHistory {
    /// Time between steps, s.
    pub time_step_s: f64,
    /// u, v, θ of each floor, lowest first, then the stroke of each mass: a column for each step, the first at rest.
    pub coordinates: Matrix,
    /// Elastic base shear along x, y, N, and base torque, N·m: a column for each step.
    pub base: Matrix,
    /// How it was computed.
    pub method: HistoryMethod,
    /// Largest values.
    pub peaks: BuildingPeaks,
}

impl BuildingHistory {
    /// Steps, the first at rest included.
    pub fn length(&self) -> usize {
        self.coordinates.columns()
    }

    /// The time of a step, s.
    pub fn time_s(&self, step: usize) -> f64 {
        step as f64 * self.time_step_s
    }

    /// A point along a direction in time, m: its row as [`Building::point_row`](crate::structure::Building::point_row) gives it.
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
        (0..self.length()).map(at).collect()
    }
}

/// The motion of a building under a motion of the ground, from rest.
///
/// ```text
/// M q″ + C q′ + K q = −M ι_x a_x − M ι_y a_y + tuned masses          3N + D values a step
/// ```
/// The ground acceleration is straight between samples, and the solution exact there: mode by mode, with tuned masses by complex
/// modes, whose frequencies are roots of a secular equation of one value a mass; by the matrix exponential where two of these
/// are one. Times between the steps are not looked at.
///
/// # Errors
/// [`DynamicsError::Argument`] for a motion without x and y, an end before 0, or too many steps.
///
/// # Limits
/// Small displacements, linear walls. Peaks are those at the steps: of a mode whose period is n steps, up to π²/(2n²) of it is missed.
/// A 20-storey building with a tuned mass, 40 s of El Centro at 0.005 s: within 1e-9 m of the matrix exponential of the whole.
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
/// // a step of the ground: twice the static displacement
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
    let cut = run.steps_per_sample.max(1);
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
        None => (motion.length() - 1) * cut,
        Some(end_s) if end_s > 0.0 && end_s / h <= STEPS_MOST as f64 => (end_s / h).round() as usize,
        Some(end_s) => {
            return Err(DynamicsError::Argument {
                argument: "end_s",
                given: end_s,
                allowed: "above 0 and at most 4 000 000 steps",
            });
        }
    };
    let ground = |step: usize| -> Ground {
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
    match complex_modes(building) {
        Some(modes) => {
            let own = Steps::new(&modes, h);
            let advance = |from: &[f64], to: &mut [f64], n: usize| own.advance(from, to, ground(n));
            let method = HistoryMethod::ComplexModes;
            Ok(stepped(building, &modes.outputs, (steps, h, method), advance))
        }
        None => {
            let own = ExponentialSteps::new(building, h);
            let advance = |from: &[f64], to: &mut [f64], n: usize| own.advance(from, to, ground(n));
            let method = HistoryMethod::MatrixExponential;
            Ok(stepped(building, &own.outputs, (steps, h, method), advance))
        }
    }
}

/// Steps the state from rest and turns it into displacements, block by block.
fn stepped(
    building: &VibratingBuilding,
    outputs: &Matrix,
    (steps, h, method): (usize, f64, HistoryMethod),
    advance: impl Fn(&[f64], &mut [f64], usize),
) -> BuildingHistory {
    let (rows, states) = (outputs.rows(), outputs.columns());
    let mut coordinates = Matrix::zeros(rows, steps + 1);
    let mut block = Matrix::zeros(states, BLOCK);
    let mut state = vec![0.0; states];
    let mut done = 0;
    while done < steps {
        let count = BLOCK.min(steps - done);
        for i in 0..count {
            let (before, rest) = block.as_mut_slice().split_at_mut(i * states);
            let from = if i == 0 {
                &state[..]
            } else {
                &before[(i - 1) * states..]
            };
            advance(from, &mut rest[..states], done + i);
        }
        state.copy_from_slice(block.column(count - 1));
        let moved = outputs * &block;
        let first = (done + 1) * rows;
        coordinates.as_mut_slice()[first..first + count * rows]
            .copy_from_slice(&moved.as_slice()[..count * rows]);
        done += count;
    }
    let base = base(building, &coordinates);
    let peaks = peaks(building, &coordinates, &base, h);
    BuildingHistory {
        time_step_s: h,
        coordinates,
        base,
        method,
        peaks,
    }
}

/// ιᵀ K q at each step: only the lowest storey's walls hold to the ground.
fn base(building: &VibratingBuilding, coordinates: &Matrix) -> Matrix {
    let rows = building.building().base_rows();
    let mut base = Matrix::zeros(3, coordinates.columns());
    for (step, column) in coordinates
        .as_slice()
        .chunks_exact(coordinates.rows())
        .enumerate()
    {
        let own = base.column_mut(step);
        for (sum, row) in own.iter_mut().zip(&rows) {
            *sum = row[0] * column[0] + row[1] * column[1] + row[2] * column[2];
        }
    }
    base
}

/// Least and most y and x of a floor from its centre of mass.
struct Reach {
    x: [f64; 2],
    y: [f64; 2],
    /// The centre of mass from that of the floor below.
    from_below: [f64; 2],
}

fn reaches(building: &VibratingBuilding) -> Vec<Reach> {
    let floors = building.building().floors();
    let each = floors.iter().enumerate().map(|(i, floor)| {
        let corners = floor
            .outline
            .as_ref()
            .map_or(&[][..], |outline| outline.corners_m());
        let extent = |axis: usize| {
            corners
                .iter()
                .map(|corner| corner[axis] - floor.centre_m[axis])
                .fold([0.0_f64; 2], |[least, most], from| {
                    [least.min(from), most.max(from)]
                })
        };
        let below = if i > 0 {
            floors[i - 1].centre_m
        } else {
            floor.centre_m
        };
        Reach {
            x: extent(0),
            y: extent(1),
            from_below: [floor.centre_m[0] - below[0], floor.centre_m[1] - below[1]],
        }
    });
    each.collect()
}

/// Values that are looked at in each storey, in this order.
const LOOKED_AT: usize = 10;

/// Displacements, drifts of the centre, of the edges, and twists, storey after storey.
fn look(column: &[f64], reaches: &[Reach], values: &mut [f64]) {
    let mut below = [0.0; 3];
    let storeys = column
        .chunks_exact(3)
        .zip(reaches)
        .zip(values.chunks_exact_mut(LOOKED_AT));
    for ((own, reach), values) in storeys {
        let [u, v, theta] = [own[0], own[1], own[2]];
        let twist = theta - below[2];
        // the floor below at the centre of the floor above
        let drift_x = u - (below[0] - reach.from_below[1] * below[2]);
        let drift_y = v - (below[1] + reach.from_below[0] * below[2]);
        values.copy_from_slice(&[
            u,
            v,
            theta,
            drift_x,
            drift_y,
            twist,
            drift_x - reach.y[0] * twist,
            drift_x - reach.y[1] * twist,
            drift_y + reach.x[0] * twist,
            drift_y + reach.x[1] * twist,
        ]);
        below = [u, v, theta];
    }
}

/// The first largest of each of `count` values at each step: the largest of a block of steps, and only where it is more than before, when.
fn largest(count: usize, steps: usize, mut at: impl FnMut(usize, &mut [f64])) -> Vec<(f64, usize)> {
    let mut values = vec![0.0; count * BLOCK];
    let mut found = vec![(0.0_f64, 0); count];
    let mut most = vec![0.0_f64; count];
    for first in (0..steps).step_by(BLOCK) {
        let block = BLOCK.min(steps - first);
        most.fill(0.0);
        for (step, values) in values.chunks_exact_mut(count).take(block).enumerate() {
            at(first + step, values);
            for (value, most) in values.iter().zip(&mut most) {
                let size = value.abs();
                *most = if size > *most { size } else { *most };
            }
        }
        for (i, (most, found)) in most.iter().zip(&mut found).enumerate() {
            if *most > found.0.abs() {
                let mut column = values.iter().skip(i).step_by(count).take(block);
                let step = column.position(|value| value.abs() == *most).unwrap_or(0);
                *found = (values[step * count + i], first + step);
            }
        }
    }
    found
}

fn peaks(building: &VibratingBuilding, coordinates: &Matrix, base: &Matrix, h: f64) -> BuildingPeaks {
    let n = building.building().floors().len();
    let reaches = reaches(building);
    let peak = |&(value, step): &(f64, usize)| Peak {
        value,
        at_s: step as f64 * h,
    };
    let steps = coordinates.columns();
    let storeys = largest(LOOKED_AT * n, steps, |step, values| {
        look(&coordinates.column(step)[..3 * n], &reaches, values);
    });
    let masses = coordinates.rows() - 3 * n;
    let strokes = match masses {
        0 => Vec::new(),
        _ => largest(masses, steps, |step, values| {
            values.copy_from_slice(&coordinates.column(step)[3 * n..]);
        }),
    };
    let base = largest(3, steps, |step, values| values.copy_from_slice(base.column(step)));
    let larger = |a: Peak, b: Peak| if b.value.abs() > a.value.abs() { b } else { a };
    let of_storey = |all: &[(f64, usize)]| {
        let p = |i: usize| peak(&all[i]);
        StoreyPeak {
            drift_x_m: p(3),
            drift_y_m: p(4),
            twist_rad: p(5),
            edge_drift_x_m: larger(p(6), p(7)),
            edge_drift_y_m: larger(p(8), p(9)),
        }
    };
    let of_floor = |all: &[(f64, usize)]| FloorPeak {
        displacement_x_m: peak(&all[0]),
        displacement_y_m: peak(&all[1]),
        rotation_rad: peak(&all[2]),
    };
    BuildingPeaks {
        floors: storeys.chunks_exact(LOOKED_AT).map(of_floor).collect(),
        storeys: storeys.chunks_exact(LOOKED_AT).map(of_storey).collect(),
        strokes_m: strokes.iter().map(peak).collect(),
        base_shear_n: [peak(&base[0]), peak(&base[1])],
        base_torque_n_m: peak(&base[2]),
    }
}
