//! A stack under wind, static loads and their combinations.

use crate::error::WorkError;
use crate::loads::{CombinationAnswer, Combined, LoadsAnswer, WindMet};
use crate::state::{StackAnswer, StackFrequencies};
use dolmen::assess::{StackCombination, StackUnderLoads, StackWind, stack_under_loads};
use dolmen::stability::stack::{WindArea, WindSurfaces};
use dolmen::structure::stack::{Stack, silhouettes};
use dolmen::structure::wind::{Wind, WindBody, WindError, WindPressure};
use dolmen_project::{LoadsPart, Pick, WindGiven};

/// Height below which EN 1991-1-4, 6.2 (1) a, sets c_s c_d to 1, m.
const LOW_M: f64 = 15.0;
/// Frequency above which a low stack is stiff, Hz. Our choice: a structure that sways more slowly is not like a building.
const SWAYS_HZ: f64 = 1.0;
/// A frequency at which EN 1991-1-4 sets c_s c_d to 1, Hz.
const STIFF_HZ: f64 = 10.0;

/// The response of a stack to wind and static loads; `None` without any.
pub(crate) fn loads(
    given: &LoadsPart,
    answer: &StackAnswer,
    pick: Pick<'_>,
) -> Result<Option<LoadsAnswer>, WorkError> {
    if given.is_empty() {
        return Ok(None);
    }
    let stack = &answer.stack;
    let mut found = LoadsAnswer {
        has_wind: given.wind().is_some(),
        has_loads: !given.loads.is_empty(),
        carried: None,
        tilt_rad: 0.0,
        wind_across: None,
        frame_winds: Vec::new(),
        combinations: Vec::new(),
        wind: None,
    };
    let blows = match given.wind() {
        None => None,
        Some(wind) => match pressure_on(wind, answer, pick) {
            Ok(pressure) => Some((pressure, surfaces(wind, stack, pick))),
            Err(why) => {
                found.wind = Some(Err(why));
                return Ok(Some(found));
            }
        },
    };
    for combination in &given.combinations {
        let under = stack_under_loads(
            stack,
            &StackCombination {
                weight: combination.weight,
                wind: combination.wind,
                loads: combination.loads,
                blows: blows
                    .as_ref()
                    .map(|(pressure, surfaces)| StackWind { pressure, surfaces }),
            },
        )?;
        found.combinations.push(CombinationAnswer {
            name: combination.name.clone(),
            weight: combination.weight,
            wind: combination.wind,
            loads: combination.loads,
            of: Combined::Stack(Box::new(under)),
        });
    }
    if let Some((pressure, surfaces)) = &blows {
        let worst = found.worst().and_then(CombinationAnswer::stack);
        found.wind = Some(Ok(met(answer, (pressure, surfaces), worst)));
    }
    Ok(Some(found))
}

/// Height of the lowest point, m: the ground of the wind.
fn ground_m(stack: &Stack) -> f64 {
    let lows = stack.blocks().iter().map(|block| block.solid.bounds_m()[0][2]);
    lows.fold(f64::INFINITY, f64::min)
}

/// Lowest frequency on the springs of the joints without side supports, which thresholds leave out, Hz.
fn lowest_hz(answer: &StackAnswer) -> Option<f64> {
    let modes = answer.frequencies_of_demand().and_then(StackFrequencies::modes)?;
    modes.first().map(|mode| mode.frequency_hz)
}

/// The pressure by height on the whole stack.
fn pressure_on(wind: &WindGiven, answer: &StackAnswer, pick: Pick<'_>) -> Result<WindPressure, WindError> {
    let stack = &answer.stack;
    let height_m = stack.height_m() - ground_m(stack);
    let breadths = [[1.0, 0.0], [0.0, 1.0]].map(|to| {
        let seen = silhouettes(stack, to);
        seen.iter().map(|of| of.area_m2).sum::<f64>() / height_m
    });
    let built = wind.build(pick);
    let lowest_hz = lowest_hz(answer);
    let frequency_hz = match (&built, lowest_hz) {
        (Wind::Eurocode(_), Some(hz)) if height_m < LOW_M && hz > SWAYS_HZ => Some(hz.max(STIFF_HZ)),
        _ => lowest_hz,
    };
    built.pressure(&WindBody {
        height_m,
        // a narrower body has the larger gust factor
        breadth_m: breadths[0].min(breadths[1]),
        frequency_hz,
        damping_ratio: None,
    })
}

/// The wind on the stones.
fn surfaces(wind: &WindGiven, stack: &Stack, pick: Pick<'_>) -> WindSurfaces {
    let force_coefficient = pick(&wind.force_coefficient);
    let mut surfaces = WindSurfaces {
        force_coefficient,
        instead: vec![None; stack.blocks().len()],
        more: Vec::new(),
        ground_m: ground_m(stack),
    };
    for area in &wind.areas {
        let area_m2 = pick(&area.area);
        let own = area
            .force_coefficient
            .as_ref()
            .map_or(force_coefficient, &mut *pick);
        let of = WindArea {
            area_m2,
            effective_m2: own * area_m2,
        };
        match &area.height {
            Some(height) => surfaces
                .more
                .push((area.part, pick(height) - surfaces.ground_m, of)),
            None => {
                if let Some(slot) = surfaces.instead.get_mut(area.part) {
                    let sum = slot.get_or_insert(WindArea::default());
                    sum.area_m2 += of.area_m2;
                    sum.effective_m2 += of.effective_m2;
                }
            }
        }
    }
    surfaces
}

/// The wind on the stack from the side that is worst for the worst combination.
fn met(
    answer: &StackAnswer,
    (pressure, surfaces): (&WindPressure, &WindSurfaces),
    worst: Option<&StackUnderLoads>,
) -> WindMet {
    let blown = worst.map_or(&[][..], |worst| &worst.blown);
    let height_m = answer.stack.height_m() - surfaces.ground_m;
    WindMet {
        pressure_at_top_pa: pressure.at_pa(height_m),
        response_factor: pressure.response_factor,
        resonance: pressure.resonance,
        frequency_hz: lowest_hz(answer),
        links: Vec::new(),
        force_n: blown.iter().map(|of| of.force_n).sum(),
        moment_n_m: blown
            .iter()
            .map(|of| of.force_n * (of.position_m[2] - surfaces.ground_m))
            .sum(),
    }
}
