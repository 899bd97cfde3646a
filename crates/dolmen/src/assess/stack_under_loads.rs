//! A stack under a combination of weight, wind and static loads: its load factor for the worst wind direction.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ | `factor` | factor on wind and static loads, with unchanged weight | – |

use super::AssessError;
use super::least_pressed::TURNS;
use super::loads_on_soil::factor_on_soil;
use crate::stability::Verdict;
use crate::stability::stack::{
    BlownBlock, LoadFactor, ROUNDS, StackLoads, SteadyLoads, WindSurfaces, blown_blocks,
    driving_under_growth, growth, load_factor, smoother_starts, without_sliding_friction,
};
use crate::structure::stack::{Stack, StaticLoad};
use crate::structure::wind::WindPressure;
use std::f64::consts::TAU;

/// Number of wind directions: on the faces and on the corners of square stones along x and y. Our choice. For directions between them, the
/// coefficient of a face would apply to a wider outline (up to 1.21 times the face), which no table of coefficients intends.
const DIRECTIONS: u32 = 8;
/// Relative difference by which a direction must be worse: directions that are equal by symmetry differ by rounding. Our choice.
const WORSE: f64 = 1e-6;

/// A wind on a stack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StackWind<'a> {
    /// Pressure by height.
    pub pressure: &'a WindPressure,
    /// Wind data of the blocks.
    pub surfaces: &'a WindSurfaces,
}

/// A load combination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StackCombination<'a> {
    /// Factor on the weight of the blocks, above 0.
    pub weight: f64,
    /// Factor on the wind.
    pub wind: f64,
    /// Factor on the static loads.
    pub loads: f64,
    /// The wind, from all directions; `None` without wind.
    pub blows: Option<StackWind<'a>>,
}

/// The loads that increase at the smallest load factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Grows {
    /// Wind and static loads together.
    All,
    /// Wind and static loads, except downward loads, which may stabilise the stones.
    AllButDownwards,
    /// The wind only; the static loads stay constant, without those downward loads that resist it.
    Wind,
}

/// Resistance of a stack to one load combination.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StackUnderLoads {
    /// The load factor, and how the stack begins to move.
    pub found: LoadFactor,
    /// The factor with associated friction in all joints, if it is larger. Associated friction makes upright joints rise as they slide; `found` has
    /// no friction in them.
    pub dilating_factor: Option<f64>,
    /// The factor with infinite strength, if it is larger.
    pub uncrushed_factor: Option<f64>,
    /// The factor on rigid ground, if it is larger than on the soil.
    pub rigid_ground_factor: Option<f64>,
    /// The loads that grow.
    pub grows: Grows,
    /// The worst direction of the wind, a unit vector in plan; `None` without wind.
    pub wind_to: Option<[f64; 2]>,
    /// Wind force on each block, without the factor of the combination.
    pub blown: Vec<BlownBlock>,
}

impl StackUnderLoads {
    /// Stable from 1.5, unstable at 1 and below.
    pub fn verdict(&self) -> Verdict {
        match self.found.factor {
            f64::INFINITY => Verdict::Stable,
            factor => Verdict::of_load_factor(factor),
        }
    }
}

/// Resistance of a stack to wind and static loads ([`Stack::static_loads`]), each with its factor.
///
/// ```text
/// λ = least over eight directions of the wind of the factor on
///     wind + loads | wind + loads, with constant downward loads | wind, without the downward loads that resist it
/// ```
///
/// # Errors
/// [`AssessError`] for a factor on the weight that is not positive, and a programme that was not solved.
///
/// # Limits
/// As for [`load_factor`] and [`blown_blocks`], except for upright joints that slide: they count without friction if that reduces the resistance.
/// Wind is applied along x, along y and halfway between: on the faces and corners of square stones with sides along x and y. For other orientations
/// the outline between face and corner may be exposed, with the same coefficient: up to 1.21 times the force on a face.
pub fn stack_under_loads(
    stack: &Stack,
    combination: &StackCombination<'_>,
) -> Result<StackUnderLoads, AssessError> {
    let mut least = least_of_frictions(stack, combination)?;
    if stack.least_strength_pa().is_some() {
        let uncrushed = least_of_frictions(&stack.clone().without_strength(), combination)?;
        let factor = uncrushed.found.factor;
        least.uncrushed_factor = is_less(least.found.factor, factor).then_some(factor);
    }
    Ok(least)
}

/// The smaller factor of those with and without friction in upright joints that slide, or that only touch.
fn least_of_frictions(
    stack: &Stack,
    combination: &StackCombination<'_>,
) -> Result<StackUnderLoads, AssessError> {
    let mut least = with_associated_friction(stack, combination)?;
    let all_friction = least.found.factor;
    if all_friction <= 0.0 {
        return Ok(least);
    }
    let at_rest = stack.clone().without_static_loads();
    let mechanism = least.found.mechanism.as_ref();
    for start in smoother_starts(stack, (&at_rest, &StackLoads::default()), mechanism)? {
        let mut smoother = Some(start);
        for _ in 0..ROUNDS {
            let Some(next) = smoother else {
                break;
            };
            let lesser = with_associated_friction(&next, combination)?;
            smoother = without_sliding_friction(&next, lesser.found.mechanism.as_ref());
            // a stack that needs that friction to stand only has an upper bound
            if lesser.found.factor <= 0.0 {
                break;
            }
            if lesser.found.factor < (1.0 - WORSE) * least.found.factor {
                least = StackUnderLoads {
                    dilating_factor: Some(all_friction),
                    ..lesser
                };
            }
        }
    }
    Ok(least)
}

fn with_associated_friction(
    stack: &Stack,
    combination: &StackCombination<'_>,
) -> Result<StackUnderLoads, AssessError> {
    let loads: Vec<StaticLoad> = stack
        .static_loads()
        .iter()
        .map(|load| StaticLoad {
            force_n: load.force_n.map(|part| part * combination.loads),
            ..*load
        })
        .collect();
    let case = Case {
        stack,
        weight: combination.weight,
        loads,
    };
    let still = Pushed::default();
    let Some(wind) = combination.blows.filter(|_| combination.wind > 0.0) else {
        let (_, ray) = case.least(&still, RestState::Nothing)?;
        return case.whole(still, ray);
    };
    let blown_to = |number: u32| {
        let angle_rad = TAU * f64::from(number) / f64::from(DIRECTIONS);
        let to = [angle_rad.cos(), angle_rad.sin()].map(|part| (part * 1e12).round() / 1e12);
        let blown = blown_blocks(stack, wind.surfaces, wind.pressure, to);
        Pushed::of(to, blown, combination.wind)
    };
    // the loads without wind are equal in every direction, and so is the result
    let mut worst = blown_to(0);
    let (mut least, mut worst_ray) = case.least(&worst, RestState::Nothing)?;
    for number in 1..DIRECTIONS {
        if least == 0.0 {
            break;
        }
        let pushed = blown_to(number);
        let (factor, ray) = case.least(&pushed, RestState::Stands)?;
        if is_less(factor, least) {
            (worst, least, worst_ray) = (pushed, factor, ray);
        }
    }
    case.whole(worst, worst_ray)
}

fn is_less(one: f64, other: f64) -> bool {
    one < (1.0 - WORSE) * other
}

/// State of a stack before its loads increase.
#[derive(Clone, Copy, PartialEq)]
enum RestState {
    Nothing,
    Stands,
}

/// A wind from one side with the factor of the combination.
#[derive(Default)]
struct Pushed {
    wind_to: Option<[f64; 2]>,
    blown: Vec<BlownBlock>,
    loads: Vec<StaticLoad>,
}

impl Pushed {
    fn of(to: [f64; 2], blown: Vec<BlownBlock>, factor: f64) -> Self {
        Pushed {
            wind_to: Some(to),
            loads: blown.iter().map(|block| block.load(to, factor)).collect(),
            blown,
        }
    }
}

/// What grows, with the constant and the increasing loads.
type Ray = (Grows, Vec<StaticLoad>, Vec<StaticLoad>);

/// Quantities that do not depend on the wind.
struct Case<'a> {
    stack: &'a Stack,
    weight: f64,
    /// Static loads with their factor.
    loads: Vec<StaticLoad>,
}

impl Case<'_> {
    /// The smallest factor of all rays, and the index of the ray.
    fn least(&self, pushed: &Pushed, known: RestState) -> Result<(f64, usize), AssessError> {
        let mut least = (f64::INFINITY, 0);
        for (index, (_, steady, growing)) in self.rays(&pushed.loads)?.iter().enumerate() {
            let steady = SteadyLoads {
                weight: self.weight,
                loads: steady,
            };
            let rigid = match known {
                RestState::Nothing => load_factor(self.stack, &steady, growing)?.factor,
                RestState::Stands => growth(self.stack, &steady, growing)?,
            };
            let factor = factor_on_soil(self.stack, &steady, growing, rigid)?;
            // constant loads that the stack does not bear leave no factor for the others: that of all loads governs
            let exceeds_at_rest = index > 0 && factor <= 0.0 && least.0 <= 1.0;
            if !exceeds_at_rest && is_less(factor, least.0) {
                least = (factor, index);
            }
        }
        Ok(least)
    }

    /// The full result for one ray.
    fn whole(&self, pushed: Pushed, ray: usize) -> Result<StackUnderLoads, AssessError> {
        let mut rays = self.rays(&pushed.loads)?;
        let (grows, steady, growing) = rays.swap_remove(ray);
        let steady = SteadyLoads {
            weight: self.weight,
            loads: &steady,
        };
        let mut found = load_factor(self.stack, &steady, &growing)?;
        let rigid = found.factor;
        found.factor = factor_on_soil(self.stack, &steady, &growing, rigid)?;
        found.at_least = found.at_least.min(found.factor);
        Ok(StackUnderLoads {
            rigid_ground_factor: is_less(found.factor, rigid).then_some(rigid),
            found,
            dilating_factor: None,
            uncrushed_factor: None,
            grows,
            wind_to: pushed.wind_to,
            blown: pushed.blown,
        })
    }

    /// Pairs of constant and increasing loads.
    fn rays(&self, wind: &[StaticLoad]) -> Result<Vec<Ray>, AssessError> {
        let all: Vec<StaticLoad> = wind.iter().chain(&self.loads).copied().collect();
        let mut rays = vec![(Grows::All, Vec::new(), all)];
        let part = |of: fn([f64; 3]) -> [f64; 3]| -> Vec<StaticLoad> {
            let each = self.loads.iter().map(|load| StaticLoad {
                force_n: of(load.force_n),
                ..*load
            });
            each.filter(|load| load.force_n != [0.0; 3]).collect()
        };
        let downwards = part(|[_, _, z]| [0.0, 0.0, z.min(0.0)]);
        let mut others = part(|[x, y, z]| [x, y, z.max(0.0)]);
        others.extend(wind);
        if !downwards.is_empty() && !others.is_empty() {
            rays.push((Grows::AllButDownwards, downwards, others));
        }
        if !wind.is_empty() && self.loads.iter().any(|load| load.force_n != [0.0; 3]) {
            rays.push((Grows::Wind, self.beside_wind(wind)?, wind.to_vec()));
        }
        Ok(rays)
    }

    /// The static loads of the least factor on the wind: each downward load may be there or not when it blows.
    fn beside_wind(&self, wind: &[StaticLoad]) -> Result<Vec<StaticLoad>, AssessError> {
        let (downwards, others): (Vec<StaticLoad>, Vec<StaticLoad>) =
            self.loads.iter().partition(|load| load.force_n[2] < 0.0);
        let mut there = vec![false; downwards.len()];
        let mut steady = others.clone();
        for _ in 0..TURNS {
            let weighs = SteadyLoads {
                weight: self.weight,
                loads: &steady,
            };
            let drives = driving_under_growth(self.stack, &weighs, wind, &downwards)?;
            let Some(drives) = drives.filter(|drives| *drives != there) else {
                break;
            };
            there = drives;
            let kept = downwards.iter().zip(&there).filter(|(_, there)| **there);
            steady = others.iter().chain(kept.map(|(load, _)| load)).copied().collect();
        }
        Ok(steady)
    }
}
