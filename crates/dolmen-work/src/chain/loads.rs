//! A chain under wind, static loads and their combinations.

use crate::error::WorkError;
use crate::loads::{
    Carried, ChainCombination, CombinationAnswer, Combined, LoadsAnswer, WindMet, WindOnLink,
};
use dolmen::assess::ChainCheck;
use dolmen::dynamics::JointOpening;
use dolmen::stability::{
    ChainLoading, ChainUnderLoads, JointHold, LinkLoad, chain_stability, chain_under_loads,
};
use dolmen::structure::wind::{WindBody, WindError};
use dolmen::structure::{AddedMass, Chain, lowest_frequency_hz};
use dolmen_project::{ChainPart, CombinationPart, LoadPart, LoadsPart, Pick, WindArea, WindGiven};

/// What loads beside the weight do to a chain; `None` if there are none.
pub(crate) fn loads(
    part: &ChainPart,
    given: &LoadsPart,
    check: &ChainCheck,
    tilt_rad: f64,
    pick: Pick<'_>,
) -> Result<Option<LoadsAnswer>, WorkError> {
    if given.is_empty() {
        return Ok(None);
    }
    let chain = part.build(pick)?;
    let acting: Vec<Acting> = given
        .loads
        .iter()
        .map(|load| acting(load, &chain, pick))
        .collect();
    let stiffness = part.stiffness_n_m_rad(pick);
    let weight_n: f64 = acting.iter().map(|load| load.weight_n).sum();
    // what loads weigh swings too
    let carried = match &stiffness {
        Some(stiffness) if weight_n != 0.0 => {
            let heavy = weighted(&chain, &acting, [1.0, 1.0])?;
            Some(Carried {
                weight_n,
                load_factor: chain_stability(&heavy, stiffness)?.load_factor,
                frequency_hz: lowest_frequency_hz(&heavy.natural_modes(stiffness)?),
            })
        }
        _ => None,
    };
    let frequency_hz = match carried {
        Some(carried) => carried.frequency_hz,
        None => lowest_frequency_hz(&check.modes),
    };
    let wind = given
        .wind()
        .map(|wind| wind_met(part, wind, frequency_hz, &chain, pick));
    let mut answer = LoadsAnswer {
        has_wind: given.wind().is_some(),
        has_loads: !given.loads.is_empty(),
        carried,
        tilt_rad,
        combinations: Vec::new(),
        wind,
    };
    let met = match &answer.wind {
        Some(Err(_)) => return Ok(Some(answer)),
        Some(Ok(met)) => Some(met),
        None => None,
    };
    let model = Model {
        stiffness,
        holds: holds(part, pick),
        loads: acting,
        met,
        tilt_rad,
        chain,
    };
    let each = given
        .combinations
        .iter()
        .map(|combination| model.under(combination));
    let combinations = each.collect::<Result<Vec<_>, _>>()?;
    answer.combinations = combinations;
    Ok(Some(answer))
}

/// A chain at rest, leaning as surveyed under its weight and static loads, before it is shaken.
pub(crate) struct AtRest {
    /// With the weight of the loads.
    pub(crate) chain: Chain,
    /// What holds each joint.
    pub(crate) holds: Vec<JointHold>,
    /// Moments of the tilt and of the loads, and the limit of each joint.
    pub(crate) under: ChainUnderLoads,
}

/// The chain at rest, each load as it is.
pub(crate) fn at_rest(
    part: &ChainPart,
    given: &LoadsPart,
    tilt_rad: f64,
    pick: Pick<'_>,
) -> Result<AtRest, WorkError> {
    let chain = part.build(pick)?;
    let model = Model {
        stiffness: part.stiffness_n_m_rad(pick),
        holds: holds(part, pick),
        loads: given
            .loads
            .iter()
            .map(|load| acting(load, &chain, pick))
            .collect(),
        chain,
        met: None,
        tilt_rad,
    };
    let still = CombinationPart {
        name: None,
        weight: 1.0,
        wind: 0.0,
        loads: 1.0,
    };
    let chain = weighted(&model.chain, &model.loads, [still.weight, still.loads])?;
    let under = model.blown(&chain, &still, 1.0)?;
    Ok(AtRest {
        chain,
        holds: model.holds,
        under,
    })
}

/// What holds each joint.
fn holds(part: &ChainPart, pick: Pick<'_>) -> Vec<JointHold> {
    let of = |i: usize| {
        let joint = part.joints.as_ref().and_then(|joints| joints.get(i));
        match (joint.and_then(|joint| joint.opening), part.bed(i, pick)) {
            (Some(JointOpening::Held), _) => JointHold::Held,
            (_, Some(bed)) => JointHold::Bed(bed),
            (_, None) => JointHold::Unknown,
        }
    };
    (0..part.links.len()).map(of).collect()
}

/// A static load in numbers.
struct Acting {
    link: usize,
    above_joint_m: f64,
    force_n: f64,
    weight_n: f64,
    moment_n_m: f64,
}

fn acting(load: &LoadPart, chain: &Chain, pick: Pick<'_>) -> Acting {
    Acting {
        link: load.part,
        above_joint_m: load.above_joint_m(chain, pick),
        force_n: load.force.as_ref().map_or(0.0, &mut *pick),
        weight_n: load.weight.as_ref().map_or(0.0, &mut *pick),
        moment_n_m: load.moment.as_ref().map_or(0.0, &mut *pick),
    }
}

/// The wind on each link.
fn wind_met(
    part: &ChainPart,
    wind: &WindGiven,
    frequency_hz: Option<f64>,
    chain: &Chain,
    pick: Pick<'_>,
) -> Result<WindMet, WindError> {
    let own = |i: usize, pick: Pick<'_>| -> f64 {
        let replaced = |area: &&WindArea| area.part == i && area.height.is_none();
        let mut replacing = wind.areas.iter().filter(replaced).peekable();
        if replacing.peek().is_some() {
            return replacing.map(|area| pick(&area.area)).sum();
        }
        let link = &part.links[i];
        let width = link.breadth.as_ref().or(link.bed_width.as_ref());
        width.map_or(f64::NAN, &mut *pick) * pick(&link.length)
    };
    let areas: Vec<f64> = (0..part.links.len()).map(|i| own(i, pick)).collect();
    let height_m = chain.height_m();
    let body = WindBody {
        height_m,
        breadth_m: areas.iter().sum::<f64>() / height_m,
        frequency_hz,
        damping_ratio: part.damping_ratio.as_ref().map(&mut *pick),
    };
    let pressure = wind.build(pick).pressure(&body)?;
    let coefficient = pick(&wind.force_coefficient);
    let bottoms = chain.joint_heights_m();
    let mut links = Vec::with_capacity(areas.len());
    for (i, (own_m2, bottom_m)) in areas.iter().zip(bottoms).enumerate() {
        let length_m = chain.links()[i].length_m;
        let strip = pressure.strip(bottom_m, bottom_m + length_m);
        let mut of = WindOnLink {
            area_m2: *own_m2,
            ..WindOnLink::default()
        };
        let replaced = |area: &&WindArea| area.part == i && area.height.is_none();
        let mut replacing = wind.areas.iter().filter(replaced).peekable();
        // areas in the place of the link's own may have coefficients of their own
        let effective_m2 = match replacing.peek().is_some() {
            true => replacing
                .map(|area| {
                    let own = area.force_coefficient.as_ref().map_or(coefficient, &mut *pick);
                    own * pick(&area.area)
                })
                .sum(),
            false => coefficient * own_m2,
        };
        of.force_n += effective_m2 / length_m * strip.force_n_m;
        of.moment_n_m += effective_m2 / length_m * strip.moment_n;
        for area in wind.areas.iter().filter(|area| area.part == i) {
            let Some(height) = &area.height else { continue };
            let (height_m, area_m2) = (pick(height), pick(&area.area));
            let own = area.force_coefficient.as_ref().map_or(coefficient, &mut *pick);
            let force_n = own * area_m2 * pressure.at_pa(height_m);
            of.area_m2 += area_m2;
            of.force_n += force_n;
            of.moment_n_m += force_n * height_m;
        }
        links.push(of);
    }
    Ok(WindMet {
        pressure_at_top_pa: pressure.at_pa(height_m),
        response_factor: pressure.response_factor,
        resonance: pressure.resonance,
        frequency_hz,
        force_n: links.iter().map(|of| of.force_n).sum(),
        moment_n_m: links.iter().map(|of| of.moment_n_m).sum(),
        links,
    })
}

/// What does not depend on the combination.
struct Model<'a> {
    chain: Chain,
    stiffness: Option<Vec<f64>>,
    holds: Vec<JointHold>,
    loads: Vec<Acting>,
    met: Option<&'a WindMet>,
    tilt_rad: f64,
}

impl Model<'_> {
    /// The chain under a combination, the wind in the worse of its two directions.
    fn under(&self, combination: &CombinationPart) -> Result<CombinationAnswer, WorkError> {
        let chain = weighted(&self.chain, &self.loads, [combination.weight, combination.loads])?;
        let stability = self
            .stiffness
            .as_ref()
            .map(|k| chain_stability(&chain, k))
            .transpose()?;
        let ahead = self.blown(&chain, combination, 1.0)?;
        let blows = self.met.is_some() && combination.wind > 0.0;
        let back = match blows && !self.loads.is_empty() {
            true => Some(self.blown(&chain, combination, -1.0)?),
            false => None,
        };
        let factor = |of: &ChainUnderLoads| of.factor.unwrap_or(f64::INFINITY);
        let (under, wind_reversed) = match back {
            Some(back) if factor(&back) < factor(&ahead) => (back, true),
            _ => (ahead, false),
        };
        Ok(CombinationAnswer {
            name: combination.name.clone(),
            weight: combination.weight,
            wind: combination.wind,
            loads: combination.loads,
            of: Combined::Chain(Box::new(ChainCombination {
                under,
                wind_reversed,
                weight_factor: stability.map(|found| found.load_factor),
            })),
        })
    }

    fn blown(
        &self,
        chain: &Chain,
        combination: &CombinationPart,
        sign: f64,
    ) -> Result<ChainUnderLoads, WorkError> {
        let mut all = Vec::new();
        let bottoms = chain.joint_heights_m();
        for (i, of) in self.met.iter().flat_map(|met| met.links.iter().enumerate()) {
            let factor = sign * combination.wind;
            all.push(LinkLoad {
                link: i + 1,
                height_m: 0.0,
                force_n: factor * of.force_n,
                moment_n_m: factor * (of.moment_n_m - of.force_n * bottoms[i]),
            });
        }
        for load in &self.loads {
            all.push(LinkLoad {
                link: load.link + 1,
                height_m: load.above_joint_m,
                force_n: combination.loads * load.force_n,
                moment_n_m: combination.loads * load.moment_n_m,
            });
        }
        let loading = ChainLoading {
            loads: &all,
            holds: &self.holds,
            tilt_rad: self.tilt_rad,
        };
        Ok(chain_under_loads(chain, self.stiffness.as_deref(), &loading)?)
    }
}

/// The chain with a factor on its weight, and, with another, the weight that static loads add in their place.
fn weighted(chain: &Chain, loads: &[Acting], [weight, loaded]: [f64; 2]) -> Result<Chain, WorkError> {
    let gravity_m_s2 = chain.gravity_m_s2() * weight;
    let heavier = Chain::new(chain.links().to_vec(), gravity_m_s2)?;
    let supports = chain.side_supports().iter().copied();
    let heavier = supports.into_iter().try_fold(heavier, Chain::with_side_support)?;
    let added = loads.iter().map(|load| AddedMass {
        link: load.link,
        height_m: load.above_joint_m,
        mass_kg: loaded * load.weight_n / gravity_m_s2,
    });
    Ok(heavier.with_added_masses(&added.collect::<Vec<_>>())?)
}
