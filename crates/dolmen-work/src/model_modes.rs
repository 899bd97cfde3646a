//! Pairs measured modes with those of the model of a stack or a building, by their shapes at the sensors.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | φ | `shape` | a measured shape at the sensors |
//! | q_k | `basis` | motion of the model's modes of one frequency at the sensors, orthonormalised |
//! | MAC | `assurance` | Σ_k \|q_k* φ\|² / φ*φ; for a single mode the usual MAC |

use crate::error::WorkError;
use dolmen::blocks::{ContactRule, lowest_stack_modes};
use dolmen::modal::Modes;
use dolmen::structure::stack::Solid;
use dolmen_project::{BuildingPart, Project, Quantity, StackPart, Structure};

/// Number of modes of the model: two more than twice the measured ones.
const MORE: usize = 2;
/// Largest number of modes of the model.
const MODES_MOST: usize = 16;
/// Modes of the model with frequencies this close are a pair, and any combination of them is a mode, as for a square pagoda.
const ONE_FREQUENCY: f64 = 0.01;
/// Smallest MAC for a pair of measured and model modes. Our choice: below it, other modes are as likely.
pub const SAME_FROM: f64 = 0.8;
/// A measured frequency is doubted if it is this many times that of its mode in the model, or the inverse. Our choice.
pub const FREQUENCY_RATIO_DOUBTED: f64 = 1.5;
/// A sensor stands on the stone nearest to it, within this distance, m.
const NEAR_M: f64 = 0.3;
/// Fraction of the length of a shape below which the rest is rounding.
const ROUNDING: f64 = 1e-6;

/// The modes of the model paired with measured ones.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelModes {
    /// The modes of the model, by frequency.
    pub of_model: Vec<ModelMode>,
    /// The measured ones, in their order.
    pub measured: Vec<BesideModel>,
    /// Channels at places of the model.
    pub channels: usize,
    /// Channels elsewhere, or without a place or direction.
    pub left_out: Vec<String>,
    /// Dampers of the structure: the modes of the model are without them.
    pub without_dampers: Vec<String>,
}

/// Dampers of a structure whose shapes are computed without them.
pub(crate) fn dampers_left_out(project: &Project) -> Vec<String> {
    match &project.structure {
        Structure::Building(part) => part.dampers.iter().map(|damper| damper.name.clone()).collect(),
        _ => Vec::new(),
    }
}

/// A mode of the model, or several of one frequency.
#[derive(Clone, Debug, PartialEq)]
pub struct ModelMode {
    /// Index among the modes of the model, from 0.
    pub first: usize,
    /// Number of modes with this frequency.
    pub count: usize,
    /// Its frequency, the mean of several, Hz.
    pub frequency_hz: f64,
}

/// A measured mode and those of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct BesideModel {
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// MAC with each of [`ModelModes::of_model`].
    pub assurance: Vec<f64>,
    /// Its index among them.
    pub is: WhichMode,
}

impl ModelModes {
    /// Indices of measured modes whose frequency is far from that of the mode with the most similar shape: the model is of another
    /// structure, or these channels do not distinguish its modes.
    pub fn far_off(&self) -> Vec<usize> {
        let each = self.measured.iter().enumerate();
        let far = each.filter(|(_, of)| match of.is {
            WhichMode::One(place) => {
                let ratio = of.frequency_hz / self.of_model[place].frequency_hz;
                ratio.ln().abs() > FREQUENCY_RATIO_DOUBTED.ln()
            }
            WhichMode::Several(_) | WhichMode::None(_) => false,
        });
        far.map(|(at, _)| at).collect()
    }
}

/// The mode of the model for a measured one; indices among [`ModelModes::of_model`].
#[derive(Clone, Debug, PartialEq)]
pub enum WhichMode {
    /// Exactly one is similar.
    One(usize),
    /// Several are similar at the sensors.
    Several(Vec<usize>),
    /// No mode is similar; the index is that of the most similar one.
    None(Option<usize>),
}

/// Pairs measured modes with those of the model; `None` for kinds other than stacks and buildings, for a structure that falls, and with fewer
/// than two channels on it.
///
/// A model whose modes cannot be computed gives no pairs; the check reports what is wrong with it.
pub(crate) fn model_modes(project: &Project, modes: &Modes) -> Option<ModelModes> {
    let wanted = (2 * modes.modes.len() + MORE).min(MODES_MOST);
    let model = Model::of(project, wanted).ok()??;
    let (mut rows, mut places, mut left_out) = (Vec::new(), Vec::new(), Vec::new());
    for (at, channel) in modes.channels.iter().enumerate() {
        let placed = channel.position_m.zip(channel.direction);
        match placed.and_then(|(position_m, direction)| model.moved(position_m, direction)) {
            Some(row) => {
                rows.push(row);
                places.push(at);
            }
            None => left_out.push(channel.name.clone()),
        }
    }
    if rows.len() < 2 || modes.modes.is_empty() {
        return None;
    }
    let of_model = grouped(&model.frequency_hz);
    let bases: Vec<Vec<Vec<f64>>> = of_model
        .iter()
        .map(|of| basis((of.first..of.first + of.count).map(|k| rows.iter().map(|row| row[k]).collect())))
        .collect();
    let measured = modes.modes.iter().map(|mode| {
        let shape: Vec<[f64; 2]> = places
            .iter()
            .map(|at| [mode.shape[*at].re, mode.shape[*at].im])
            .collect();
        // if the shapes of one frequency span all motions of the sensors, any shape is similar
        let within = |basis: &Vec<Vec<f64>>| {
            if basis.len() < rows.len() {
                share(basis, &shape)
            } else {
                0.0
            }
        };
        let assurance: Vec<f64> = bases.iter().map(within).collect();
        BesideModel {
            frequency_hz: mode.frequency_hz,
            is: which(&assurance),
            assurance,
        }
    });
    Some(ModelModes {
        measured: measured.collect(),
        of_model,
        channels: rows.len(),
        left_out,
        without_dampers: dampers_left_out(project),
    })
}

/// The only one with at least [`SAME_FROM`], several, or none.
fn which(assurance: &[f64]) -> WhichMode {
    let alike: Vec<usize> = (0..assurance.len())
        .filter(|k| assurance[*k] >= SAME_FROM)
        .collect();
    match alike.as_slice() {
        [one] => WhichMode::One(*one),
        [] => {
            let best = (0..assurance.len()).max_by(|a, b| assurance[*a].total_cmp(&assurance[*b]));
            WhichMode::None(best)
        }
        _ => WhichMode::Several(alike),
    }
}

/// Modes of one frequency together.
fn grouped(frequency_hz: &[f64]) -> Vec<ModelMode> {
    let mut all: Vec<ModelMode> = Vec::new();
    for (at, hz) in frequency_hz.iter().enumerate() {
        match all.last_mut() {
            Some(last) if hz / frequency_hz[at - 1] - 1.0 <= ONE_FREQUENCY => {
                last.frequency_hz += (hz - last.frequency_hz) / (last.count + 1) as f64;
                last.count += 1;
            }
            _ => all.push(ModelMode {
                first: at,
                count: 1,
                frequency_hz: *hz,
            }),
        }
    }
    all
}

/// An orthonormal basis of the given shapes.
fn basis(shapes: impl Iterator<Item = Vec<f64>>) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for shape in shapes {
        let length = dot(&shape, &shape).sqrt();
        let mut left = shape;
        for q in &basis {
            let along = dot(q, &left);
            left.iter_mut().zip(q).for_each(|(x, q)| *x -= along * q);
        }
        let rest = dot(&left, &left).sqrt();
        if rest > ROUNDING * length && rest > 0.0 {
            basis.push(left.iter().map(|x| x / rest).collect());
        }
    }
    basis
}

/// Σ_k |q_k* φ|² / φ*φ.
fn share(basis: &[Vec<f64>], shape: &[[f64; 2]]) -> f64 {
    let power: f64 = shape.iter().flatten().map(|x| x * x).sum();
    let along = basis
        .iter()
        .flat_map(|q| [0, 1].map(|part| q.iter().zip(shape).map(|(q, z)| q * z[part]).sum::<f64>()));
    if power > 0.0 {
        (along.map(|x| x * x).sum::<f64>() / power).min(1.0)
    } else {
        0.0
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Motion of the model's places in each of its modes.
struct Model {
    frequency_hz: Vec<f64>,
    of: PlaceMotion,
}

enum PlaceMotion {
    /// For each mode, each floor from the ground: u, v and θ about its centre.
    Floors {
        heights_m: Vec<f64>,
        centres_m: Vec<[f64; 2]>,
        shapes: Vec<Vec<[f64; 3]>>,
    },
    /// For each mode, each stone: displacement of its centroid, and rotation about it.
    Stones {
        solids: Vec<Solid>,
        shapes: Vec<Vec<[f64; 6]>>,
    },
}

impl Model {
    fn of(project: &Project, wanted: usize) -> Result<Option<Model>, WorkError> {
        match &project.structure {
            Structure::Stack(part) => Model::of_stack(part, wanted).map(Some),
            Structure::Building(part) => Model::of_building(part, wanted),
            Structure::Chain(_) | Structure::Frame(_) | Structure::Survey => Ok(None),
        }
    }

    fn of_stack(part: &StackPart, wanted: usize) -> Result<Model, WorkError> {
        let stack = part.build(&mut Quantity::nominal)?;
        let mut all = lowest_stack_modes(&stack, ContactRule::Four, wanted)?;
        all.truncate(wanted);
        Ok(Model {
            frequency_hz: all.iter().map(|mode| mode.frequency_hz).collect(),
            of: PlaceMotion::Stones {
                solids: stack.blocks().iter().map(|block| block.solid.clone()).collect(),
                shapes: all.into_iter().map(|mode| mode.shape).collect(),
            },
        })
    }

    /// `None` for a structure that falls.
    fn of_building(part: &BuildingPart, wanted: usize) -> Result<Option<Model>, WorkError> {
        let Some(vibrating) = part.as_written() else {
            return Ok(None);
        };
        let found = vibrating.building().modes()?;
        let (floors, _) = part.floors_and_storeys(&mut Quantity::nominal)?;
        let storeys = part
            .floors
            .iter()
            .flat_map(|floor| std::iter::repeat_n(floor.height.value, floor.count));
        let mut heights_m = vec![0.0];
        heights_m.extend(storeys.scan(0.0, |height, storey| {
            *height += storey;
            Some(*height)
        }));
        let modes = found.modes.iter().take(wanted);
        let shape = |of: &[f64]| -> Vec<[f64; 3]> {
            let floors = of.chunks_exact(3).map(|floor| [floor[0], floor[1], floor[2]]);
            std::iter::once([0.0; 3]).chain(floors).collect()
        };
        let first = floors.first().map_or([0.0; 2], |floor| floor.centre_m);
        Ok(Some(Model {
            frequency_hz: modes.clone().map(|mode| mode.frequency_hz).collect(),
            of: PlaceMotion::Floors {
                heights_m,
                centres_m: std::iter::once(first)
                    .chain(floors.iter().map(|floor| floor.centre_m))
                    .collect(),
                shapes: modes.map(|mode| shape(&mode.shape)).collect(),
            },
        }))
    }

    /// The displacement of a place along a direction in each mode; `None` if the model has nothing there.
    fn moved(&self, position_m: [f64; 3], direction: [f64; 3]) -> Option<Vec<f64>> {
        let along = |by: [f64; 3]| by.iter().zip(direction).map(|(by, d)| by * d).sum::<f64>();
        match &self.of {
            PlaceMotion::Floors {
                heights_m,
                centres_m,
                shapes,
            } => {
                let [x, y, z] = position_m;
                let of_floor = |shape: &[[f64; 3]], floor: usize| {
                    let ([u, v, turn], [cx, cy]) = (shape[floor], centres_m[floor]);
                    [u - turn * (y - cy), v + turn * (x - cx), 0.0]
                };
                let top = heights_m.len() - 1;
                let above = heights_m
                    .iter()
                    .position(|height| *height >= z)
                    .unwrap_or(top)
                    .max(1);
                let storey_m = heights_m[above] - heights_m[above - 1];
                if z > heights_m[top] + 0.5 * storey_m || z < 0.0 {
                    return None;
                }
                // walls shear between their floors
                let share = ((z - heights_m[above - 1]) / storey_m).min(1.0);
                let each = shapes.iter().map(|shape| {
                    let (low, high) = (of_floor(shape, above - 1), of_floor(shape, above));
                    along(std::array::from_fn(|i| (1.0 - share) * low[i] + share * high[i]))
                });
                Some(each.collect())
            }
            PlaceMotion::Stones { solids, shapes } => {
                let far = |solid: &Solid| {
                    let [low, high] = solid.bounds_m();
                    let beyond =
                        (0..3).map(|i| (low[i] - position_m[i]).max(position_m[i] - high[i]).max(0.0));
                    beyond.map(|x| x * x).sum::<f64>().sqrt()
                };
                let nearest =
                    (0..solids.len()).min_by(|a, b| far(&solids[*a]).total_cmp(&far(&solids[*b])))?;
                if far(&solids[nearest]) > NEAR_M {
                    return None;
                }
                let centre = solids[nearest].centroid_m();
                let arm: [f64; 3] = std::array::from_fn(|i| position_m[i] - centre[i]);
                let each = shapes.iter().map(|shape| {
                    let [ux, uy, uz, rx, ry, rz] = shape[nearest];
                    along([
                        ux + ry * arm[2] - rz * arm[1],
                        uy + rz * arm[0] - rx * arm[2],
                        uz + rx * arm[1] - ry * arm[0],
                    ])
                });
                Some(each.collect())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::opened::Opened;
    use crate::sensors::{Axis, SensorsOptions, sensors};
    use dolmen::modal::{Identify, ReferenceCase, identify};
    use dolmen::signal::Channel;
    use dolmen_records::NoFiles;

    fn example(name: &str) -> Opened {
        let text = match name {
            "twisting_floor" => include_str!("../../../examples/twisting_floor/project.toml"),
            "three_storey_pagoda" => include_str!("../../../examples/three_storey_pagoda/project.toml"),
            other => panic!("no example {other}"),
        };
        Opened::read(text.to_owned(), "p".to_owned(), &NoFiles).unwrap()
    }

    /// Modes measured by these channels; everything else is from a simulated record.
    fn measured(channels: Vec<Channel>, shapes: &[Vec<[f64; 2]>]) -> Modes {
        let record = ReferenceCase::ShearChain.made(1).unwrap().make().unwrap();
        let found = identify(&record, &Identify::default()).unwrap().modes;
        let first = found.modes[0].clone();
        let each = shapes.iter().enumerate();
        let modes = each.map(|(at, shape)| {
            let mut mode = first.clone();
            mode.frequency_hz = 1.0 + at as f64;
            mode.shape = vec![first.shape[0]; shape.len()];
            for (z, [re, im]) in mode.shape.iter_mut().zip(shape) {
                (z.re, z.im) = (*re, *im);
            }
            mode
        });
        Modes {
            modes: modes.collect(),
            channels,
            ..found
        }
    }

    fn channel(name: &str, position_m: [f64; 3], direction: [f64; 3]) -> Channel {
        Channel {
            position_m: Some(position_m),
            direction: Some(direction),
            ..Channel::named(name)
        }
    }

    /// At the sensor places of `dolmen sensors`, the model moves as that verb gives; written independently of this file.
    #[test]
    fn agrees_with_the_shapes_that_sensors_are_planned_by() {
        for name in ["twisting_floor", "three_storey_pagoda"] {
            let opened = example(name);
            let options = SensorsOptions {
                count: Some(6),
                modes: Some(3),
                ..SensorsOptions::default()
            };
            let answer = sensors(&opened, &options).unwrap();
            let model = Model::of(&opened.project, 3).unwrap().unwrap();
            let mut rows = Vec::new();
            for sensor in &answer.sensors {
                let direction = match sensor.site.axes[0] {
                    Axis::X => [1.0, 0.0, 0.0],
                    Axis::Y => [0.0, 1.0, 0.0],
                    _ => [0.0, 0.0, 1.0],
                };
                rows.push(model.moved(sensor.site.position_m, direction).unwrap());
            }
            // the MAC of the modes at those sensors is that of the plan
            for i in 0..3 {
                for j in 0..3 {
                    let of = |k: usize| rows.iter().map(|row| row[k]).collect::<Vec<f64>>();
                    let (a, b) = (of(i), of(j));
                    let mac = dot(&a, &b).powi(2) / (dot(&a, &a) * dot(&b, &b));
                    assert!(
                        (mac - answer.likeness[i][j]).abs() < 1e-9,
                        "{name} {i} {j}: {mac}"
                    );
                }
            }
        }
    }

    /// The left wall is nearly twice as stiff as the right one. In the first mode, the right end therefore moves more, about a centre far to
    /// the left where nothing moves along y. Half way up the storey, everything moves half as much.
    #[test]
    fn exact_the_soft_end_of_a_floor_swings_more_about_the_centre_of_its_mode() {
        let opened = example("twisting_floor");
        let model = Model::of(&opened.project, 3).unwrap().unwrap();
        let along_y = |x: f64, z: f64| model.moved([x, 0.0, z], [0.0, 1.0, 0.0]).unwrap();
        let (left, right) = (along_y(-5.0, 30.0), along_y(5.0, 30.0));
        assert!(right[0].abs() > 1.5 * left[0].abs(), "{left:?} {right:?}");
        // the printed centres of modes 1 and 3
        for (mode, x) in [(0, -23.378_24), (2, 0.584_589)] {
            assert!(along_y(x, 30.0)[mode].abs() < 1e-6 * right[mode].abs(), "{mode}");
        }
        assert!((along_y(5.0, 15.0)[0] / right[0] - 0.5).abs() < 1e-12);
        assert_eq!(model.moved([0.0, 0.0, 80.0], [0.0, 1.0, 0.0]), None);
    }

    #[test]
    fn exact_a_measured_shape_of_the_model_is_its_mode_and_a_blend_is_none() {
        let opened = example("twisting_floor");
        let model = Model::of(&opened.project, 3).unwrap().unwrap();
        let x = [1.0, 0.0, 0.0];
        let y = [0.0, 1.0, 0.0];
        let top = match &model.of {
            PlaceMotion::Floors { heights_m, .. } => *heights_m.last().unwrap(),
            PlaceMotion::Stones { .. } => unreachable!("it is a building"),
        };
        let channels = vec![
            channel("a", [0.0, 0.0, top], x),
            channel("b", [6.0, 0.0, top], y),
            channel("c", [0.0, 4.0, top], x),
            channel("far", [0.0, 0.0, top + 50.0], x),
            Channel::named("nowhere"),
        ];
        let of = |k: usize| -> Vec<f64> {
            let placed = channels[..3].iter();
            placed
                .map(|c| model.moved(c.position_m.unwrap(), c.direction.unwrap()).unwrap()[k])
                .collect()
        };
        // a rotated phase changes nothing; components of other channels are ignored
        let complex = |shape: &[f64], turn: f64| -> Vec<[f64; 2]> {
            let (sin, cos) = f64::sin_cos(turn);
            let mut all: Vec<[f64; 2]> = shape.iter().map(|x| [x * cos, x * sin]).collect();
            all.extend([[9.0, 0.0], [5.0, 1.0]]);
            all
        };
        let unit = |k: usize| {
            let shape = of(k);
            let length = dot(&shape, &shape).sqrt();
            shape.into_iter().map(|x| x / length).collect::<Vec<f64>>()
        };
        let blend: Vec<f64> = unit(0).iter().zip(unit(1)).map(|(a, b)| a + b).collect();
        let shapes = [
            complex(&of(0), 0.3),
            complex(&of(1), -2.0),
            complex(&of(2), 0.0),
            complex(&blend, 0.0),
        ];
        let found = model_modes(&opened.project, &measured(channels.clone(), &shapes)).unwrap();
        assert_eq!(
            (found.channels, found.left_out.clone()),
            (3, vec!["far".to_owned(), "nowhere".to_owned()])
        );
        for k in 0..3 {
            assert_eq!(found.measured[k].is, WhichMode::One(k));
            // made at 1, 2, 3 Hz: three to six times the frequencies of the model
            assert!(found.far_off().contains(&k));
            assert!((found.measured[k].assurance[k] - 1.0).abs() < 1e-12);
        }
        assert!(
            matches!(found.measured[3].is, WhichMode::None(Some(_))),
            "{:?}",
            found.measured[3]
        );
        // two channels along x cannot distinguish two of three modes: no answer
        let few = measured(vec![channels[0].clone()], &[vec![[1.0, 0.0]]]);
        assert_eq!(model_modes(&opened.project, &few), None);
    }

    /// A square pagoda sways in any direction at one frequency: a diagonal measured mode is of that pair.
    #[test]
    fn holds_a_mode_between_two_of_one_frequency_is_of_that_pair() {
        let opened = example("three_storey_pagoda");
        let model = Model::of(&opened.project, 6).unwrap().unwrap();
        let groups = grouped(&model.frequency_hz);
        assert_eq!(
            (groups[0].first, groups[0].count),
            (0, 2),
            "{:?}",
            model.frequency_hz
        );
        let PlaceMotion::Stones { solids, .. } = &model.of else {
            unreachable!("it is a stack")
        };
        let mut channels = Vec::new();
        for (at, solid) in solids.iter().enumerate().skip(1).step_by(3) {
            let place = solid.centroid_m();
            channels.push(channel(&format!("x{at}"), place, [1.0, 0.0, 0.0]));
            channels.push(channel(&format!("y{at}"), place, [0.0, 1.0, 0.0]));
        }
        let row = |c: &Channel| model.moved(c.position_m.unwrap(), c.direction.unwrap()).unwrap();
        let shape: Vec<[f64; 2]> = channels
            .iter()
            .map(|c| [0.6 * row(c)[0] - 0.8 * row(c)[1], 0.0])
            .collect();
        let found = model_modes(&opened.project, &measured(channels, &[shape])).unwrap();
        assert_eq!(found.measured[0].is, WhichMode::One(0));
        assert_eq!(
            found.far_off().is_empty(),
            (1.0 / groups[0].frequency_hz).ln().abs() <= 1.5_f64.ln()
        );
        assert!((found.measured[0].assurance[0] - 1.0).abs() < 1e-9);
        assert!(
            grouped(&[1.0, 1.005, 1.3])
                == vec![
                    ModelMode {
                        first: 0,
                        count: 2,
                        frequency_hz: 1.0025
                    },
                    ModelMode {
                        first: 2,
                        count: 1,
                        frequency_hz: 1.3
                    },
                ]
        );
    }
}
