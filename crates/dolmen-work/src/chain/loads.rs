//! A chain under wind, static loads and their combinations.

use super::all_round::all_round;
use super::planes::{Model, Plane, weighted};
use super::wind::wind_met;
use crate::error::WorkError;
use crate::loads::{ChainCombination, CombinationAnswer, Combined, LoadsAnswer, WindMet};
use crate::state::Leaning;
use dolmen::assess::ChainCheck;
use dolmen::stability::{ChainUnderLoads, JointHold, chain_stability};
use dolmen::structure::wind::WindError;
use dolmen::structure::{Chain, lowest_frequency_hz};
use dolmen_project::{ChainAxis, ChainPart, CombinationPart, LoadsPart, Pick};

/// The response of a chain to loads in addition to its weight; `None` without such loads.
pub(crate) fn loads(
    part: &ChainPart,
    given: &LoadsPart,
    check: &ChainCheck,
    leaning: Leaning,
    pick: Pick<'_>,
) -> Result<Option<LoadsAnswer>, WorkError> {
    if given.is_empty() {
        return Ok(None);
    }
    let mut model = Model::new(part, given, leaning, pick)?;
    let weight_n: f64 = model.loads.iter().map(|load| load.weight_n).sum();
    let carried = model.carried(weight_n)?;
    let of_check = [
        Some(&check.modes),
        check.across.as_ref().map(|across| &across.modes),
    ];
    let mut winds: Vec<Result<WindMet, WindError>> = Vec::new();
    for (plane, modes) in model.planes.iter().zip(of_check) {
        let Some(wind) = given.wind() else { break };
        let frequency_hz = match (&carried, plane.heavy_frequency_hz(&model.loads)?) {
            (Some(_), frequency_hz) => frequency_hz,
            (None, _) => modes.and_then(|modes| lowest_frequency_hz(modes)),
        };
        winds.push(wind_met(
            part,
            (wind, plane.axis),
            frequency_hz,
            &plane.chain,
            pick,
        ));
    }
    let mut answer = LoadsAnswer {
        has_wind: given.wind().is_some(),
        has_loads: !given.loads.is_empty(),
        carried,
        tilt_rad: leaning.together_rad,
        combinations: Vec::new(),
        wind: None,
        wind_across: None,
        frame_winds: Vec::new(),
    };
    let mut met = Vec::new();
    for wind in winds {
        match wind {
            Ok(wind) => met.push(wind),
            Err(why) => {
                answer.wind = Some(Err(why));
                return Ok(Some(answer));
            }
        }
    }
    for (plane, met) in model.planes.iter_mut().zip(&met) {
        plane.met = Some(met.clone());
    }
    let mut met = met.into_iter();
    (answer.wind, answer.wind_across) = (met.next().map(Ok), met.next());
    let each = given
        .combinations
        .iter()
        .map(|combination| under(&model, combination));
    let combinations = each.collect::<Result<Vec<_>, _>>()?;
    answer.combinations = combinations;
    Ok(Some(answer))
}

/// A chain at rest, leaning as surveyed under its weight and static loads, before a motion in one direction.
pub(crate) struct AtRest {
    /// The direction.
    pub(crate) axis: ChainAxis,
    /// With the weight of the loads.
    pub(crate) chain: Chain,
    /// Properties of the joints, with the widths of the beds along the direction.
    pub(crate) holds: Vec<JointHold>,
    /// Moments of the tilt and of the loads, and the limit of each joint.
    pub(crate) under: ChainUnderLoads,
}

/// The chain at rest in each of its directions, under the loads as given.
pub(crate) fn at_rest(
    part: &ChainPart,
    given: &LoadsPart,
    leaning: Leaning,
    pick: Pick<'_>,
) -> Result<Vec<AtRest>, WorkError> {
    let model = Model::new(part, given, leaning, pick)?;
    let each = model.planes.iter().map(|plane| {
        let chain = weighted(&plane.chain, &model.loads, [1.0, 1.0])?;
        let under = plane.under(&chain, &model, [1.0, 0.0])?;
        Ok(AtRest {
            axis: plane.axis,
            chain,
            holds: model.holds.clone(),
            under,
        })
    });
    each.collect()
}

/// The chain under a combination, with the wind in the worst of its directions.
fn under(model: &Model, combination: &CombinationPart) -> Result<CombinationAnswer, WorkError> {
    let mut chains = Vec::new();
    let mut weight_factor: Option<f64> = None;
    for plane in &model.planes {
        let chain = weighted(
            &plane.chain,
            &model.loads,
            [combination.weight, combination.loads],
        )?;
        if let Some(k) = &plane.stiffness {
            let factor = chain_stability(&chain, k)?.load_factor;
            weight_factor = Some(weight_factor.map_or(factor, |least| least.min(factor)));
        }
        chains.push(chain);
    }
    let found = match (model.planes.as_slice(), chains.as_slice()) {
        ([plane], [chain]) => along(model, plane, chain, combination)?,
        _ => all_round(model, &chains, combination)?,
    };
    Ok(CombinationAnswer {
        name: combination.name.clone(),
        weight: combination.weight,
        wind: combination.wind,
        loads: combination.loads,
        of: Combined::Chain(Box::new(ChainCombination {
            weight_factor,
            ..found
        })),
    })
}

/// With the wind in the worse of its two directions in one plane.
fn along(
    model: &Model,
    plane: &Plane,
    chain: &Chain,
    combination: &CombinationPart,
) -> Result<ChainCombination, WorkError> {
    let blown = |sign: f64| plane.under(chain, model, [combination.loads, sign * combination.wind]);
    let ahead = blown(1.0)?;
    let blows = plane.met.is_some() && combination.wind > 0.0;
    let back = match blows && !model.loads.is_empty() {
        true => Some(blown(-1.0)?),
        false => None,
    };
    let factor = |of: &ChainUnderLoads| of.factor.unwrap_or(f64::INFINITY);
    let (under, wind_reversed) = match back {
        Some(back) if factor(&back) < factor(&ahead) => (back, true),
        _ => (ahead, false),
    };
    Ok(ChainCombination {
        under,
        wind_reversed,
        weight_factor: None,
        across: None,
    })
}
