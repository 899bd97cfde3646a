//! The answer on wind and static loads.

use super::on_building::BuildingCombination;
use dolmen::assess::StackUnderLoads;
use dolmen::stability::{ChainUnderLoads, StoreyUnderLoads, Verdict};
use dolmen::structure::wind::{Resonance, WindError};

/// Natural frequency below which resonance adds to a given gust, Hz: 5 Hz in EN 1991-1-4, 1 Hz in KDS 41 12 00.
const RESONANCE_BELOW_HZ: f64 = 1.0;

/// The response to loads other than the weight.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadsAnswer {
    /// Whether the file gives a wind.
    pub has_wind: bool,
    /// Whether the file has static loads.
    pub has_loads: bool,
    /// The wind on the structure, or why it is unknown; `None` without wind.
    pub wind: Option<Result<WindMet, WindError>>,
    /// The same across a chain with two directions; `None` for others, or if `wind` is unknown.
    pub wind_across: Option<WindMet>,
    /// The wind along each direction of a frame; empty for others, and where `wind` is unknown.
    pub frame_winds: Vec<FrameWind>,
    /// A chain with the weights of its static loads; `None` if they weigh nothing, or its stiffness is unknown.
    pub carried: Option<Carried>,
    /// Surveyed tilt in every combination, rad.
    pub tilt_rad: f64,
    /// Each combination; empty if the wind is unknown.
    pub combinations: Vec<CombinationAnswer>,
}

/// The wind along a direction of a frame.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct FrameWind {
    /// The direction.
    pub direction: String,
    /// The wind; its links are the storeys.
    pub met: WindMet,
    /// Force on each level, lowest first, N: the levels above and below a storey share the wind on it.
    pub levels_n: Vec<f64>,
    /// The same at the frequency of the frame with every joint slipping; `None` where no gust slips a joint, or slipping does not soften it.
    pub slipping: Option<SlippingWind>,
}

/// The wind on a frame whose joints slip.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct SlippingWind {
    /// The wind.
    pub met: WindMet,
    /// Force on each level, lowest first, N.
    pub levels_n: Vec<f64>,
}

impl FrameWind {
    /// Force on each level while joints slip, or while they stick, N.
    pub(crate) fn levels_in(&self, slips: bool) -> &[f64] {
        match &self.slipping {
            Some(slipping) if slips => &slipping.levels_n,
            _ => &self.levels_n,
        }
    }

    /// The wind while joints stick and, where a gust slips them, while they slip.
    pub fn states(&self) -> impl Iterator<Item = &WindMet> {
        std::iter::once(&self.met).chain(self.slipping.as_ref().map(|of| &of.met))
    }
}

/// A chain with the weights of its static loads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried {
    /// The weights, N.
    pub weight_n: f64,
    /// Factor on the total weight at which it falls.
    pub load_factor: f64,
    /// Lowest natural frequency, Hz; `None` where it falls.
    pub frequency_hz: Option<f64>,
}

impl Carried {
    /// Verdict from the factor on the total weight.
    pub fn verdict(&self) -> Verdict {
        Verdict::of_load_factor(self.load_factor)
    }
}

/// Wind on a structure, without the factor of a combination.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct WindMet {
    /// Peak velocity pressure at the top, with the factor for size and resonance, Pa.
    pub pressure_at_top_pa: f64,
    /// c_s c_d or G_D; 1 for a gust as given.
    pub response_factor: f64,
    /// Whether it includes resonance.
    pub resonance: Resonance,
    /// Lowest natural frequency, Hz; `None` if unknown.
    pub frequency_hz: Option<f64>,
    /// The wind on each link, lowest first; empty for a stack.
    pub links: Vec<WindOnLink>,
    /// Whole force, N.
    pub force_n: f64,
    /// Its moment about the ground, N m.
    pub moment_n_m: f64,
}

/// The wind on one link.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
pub struct WindOnLink {
    /// Area including banners and signs, m².
    pub area_m2: f64,
    /// Force, N.
    pub force_n: f64,
    /// Moment about the ground, N m.
    pub moment_n_m: f64,
}

/// One combination.
#[derive(Clone, Debug, PartialEq)]
pub struct CombinationAnswer {
    /// Its name in the file; `None` for all loads as given.
    pub name: Option<String>,
    /// Factors on weight, wind and static loads.
    pub weight: f64,
    /// Factor on wind.
    pub wind: f64,
    /// Factor on static loads.
    pub loads: f64,
    /// Its result.
    pub of: Combined,
}

/// Result of a combination, by kind of structure.
#[derive(Clone, Debug, PartialEq)]
pub enum Combined {
    /// For a chain.
    Chain(Box<ChainCombination>),
    /// For a stack, with the wind from its worst side.
    Stack(Box<StackUnderLoads>),
    /// For a frame, one direction at a time.
    Frame(Box<FrameCombination>),
    /// For a building: drifts.
    Building(Box<BuildingCombination>),
}

/// A frame under a combination; each storey with the worse direction of the wind, joints sticking or slipping.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameCombination {
    /// Each direction whose stiffness is known.
    pub directions: Vec<DirectionUnderLoads>,
    /// Directions with unknown stiffness.
    pub unknown: Vec<String>,
    /// Factor on the weight of the combination, including static loads, at which it falls; `None` if no stiffness is known.
    pub weight_factor: Option<f64>,
}

/// A direction of a frame under a combination.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct DirectionUnderLoads {
    /// The direction.
    pub direction: String,
    /// Its storeys, lowest first.
    pub storeys: Vec<LoadedStorey>,
}

/// A storey of a frame in its worst case.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct LoadedStorey {
    /// The factor on the loads that it resists.
    pub under: StoreyUnderLoads,
    /// Its height, m.
    pub height_m: f64,
    /// Its surveyed lean, horizontal over vertical; the loads act in that direction.
    pub tilt: f64,
    /// Whether the wind blows against the positive direction of the static loads.
    pub wind_reversed: bool,
    /// Whether its joints slip.
    pub slips: bool,
}

impl LoadedStorey {
    /// Lean under the loads, horizontal over vertical; `None` if it cannot resist them.
    pub fn lean(&self) -> Option<f64> {
        Some(self.under.lean_at_rest? + self.under.drift_m? / self.height_m)
    }
}

impl DirectionUnderLoads {
    /// The storey with the smallest factor, 0 the lowest.
    pub fn governing(&self) -> Option<(usize, &LoadedStorey)> {
        let each = self.storeys.iter().enumerate();
        each.min_by(|a, b| a.1.under.factor.total_cmp(&b.1.under.factor))
    }
}

impl FrameCombination {
    /// The direction and the storey, 0 the lowest, with the smallest factor.
    pub fn governing(&self) -> Option<(&DirectionUnderLoads, usize, &LoadedStorey)> {
        let each = self.directions.iter().filter_map(|own| {
            let (storey, of) = own.governing()?;
            Some((own, storey, of))
        });
        each.min_by(|a, b| a.2.under.factor.total_cmp(&b.2.under.factor))
    }

    /// Smallest factor on the loads at which a storey falls; `None` if no stiffness is known.
    pub fn factor(&self) -> Option<f64> {
        Some(self.governing()?.2.under.factor)
    }

    /// Verdict from the factor on the weight.
    pub fn weight_verdict(&self) -> Verdict {
        self.weight_factor
            .map_or(Verdict::Unknown, Verdict::of_load_factor)
    }

    /// Verdict from the factors on loads and on weight; unknown if a direction is unknown, unless another falls.
    pub fn verdict(&self) -> Verdict {
        let by_loads = match self.factor() {
            Some(f64::INFINITY) => Verdict::Stable,
            Some(factor) => Verdict::of_load_factor(factor),
            None => Verdict::Unknown,
        };
        match (by_loads, self.weight_verdict()) {
            (Verdict::Unstable, _) | (_, Verdict::Unstable) => Verdict::Unstable,
            _ if !self.unknown.is_empty() => Verdict::Unknown,
            (Verdict::Unknown, _) | (_, Verdict::Unknown) => Verdict::Unknown,
            (Verdict::Marginal, _) | (_, Verdict::Marginal) => Verdict::Marginal,
            (Verdict::Stable, Verdict::Stable) => Verdict::Stable,
        }
    }
}

/// A chain under a combination, in the worse of the two directions of the wind.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainCombination {
    /// Moments and limits.
    pub under: ChainUnderLoads,
    /// Whether the wind blows against the positive direction of the static loads.
    pub wind_reversed: bool,
    /// Factor on the weight of the combination, including static loads, at which it falls; `None` without stiffness.
    pub weight_factor: Option<f64>,
    /// Across, for a chain with two directions; the factors on loads are then those of both together.
    pub across: Option<AcrossCombination>,
}

/// A chain across under a combination, with the wind from its worst side.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct AcrossCombination {
    /// Moments and limits across.
    pub under: ChainUnderLoads,
    /// Direction of the wind, degrees from along to across; `None` without wind.
    pub wind_towards_deg: Option<f64>,
}

impl CombinationAnswer {
    /// The result for a chain; `None` for others.
    pub fn chain(&self) -> Option<&ChainCombination> {
        match &self.of {
            Combined::Chain(chain) => Some(chain),
            Combined::Stack(_) | Combined::Frame(_) | Combined::Building(_) => None,
        }
    }

    /// The result for a stack; `None` for others.
    pub fn stack(&self) -> Option<&StackUnderLoads> {
        match &self.of {
            Combined::Chain(_) | Combined::Frame(_) | Combined::Building(_) => None,
            Combined::Stack(stack) => Some(stack),
        }
    }

    /// The result for a frame; `None` for others.
    pub fn frame(&self) -> Option<&FrameCombination> {
        match &self.of {
            Combined::Chain(_) | Combined::Stack(_) | Combined::Building(_) => None,
            Combined::Frame(frame) => Some(frame),
        }
    }

    /// The result for a building; `None` for others.
    pub fn building(&self) -> Option<&BuildingCombination> {
        match &self.of {
            Combined::Chain(_) | Combined::Stack(_) | Combined::Frame(_) => None,
            Combined::Building(building) => Some(building),
        }
    }

    /// Smallest factor on wind and loads at which a joint reaches its limit, stones move, or a storey falls; `None` if no limit is known, and for a building.
    pub fn factor(&self) -> Option<f64> {
        match &self.of {
            Combined::Chain(chain) => chain.under.factor,
            Combined::Stack(stack) => Some(stack.found.factor),
            Combined::Frame(frame) => frame.factor(),
            Combined::Building(_) => None,
        }
    }

    /// Verdict from the factors on loads and on weight; unknown if a limit or the stiffness is unknown, unless it overturns in any case.
    pub fn verdict(&self) -> Verdict {
        match &self.of {
            Combined::Chain(chain) => chain.verdict(),
            Combined::Stack(stack) => stack.verdict(),
            Combined::Frame(frame) => frame.verdict(),
            Combined::Building(building) => building.verdict(),
        }
    }
}

impl ChainCombination {
    /// Verdict from the factor on the weight.
    pub fn weight_verdict(&self) -> Verdict {
        self.weight_factor
            .map_or(Verdict::Unknown, Verdict::of_load_factor)
    }

    /// Verdict from the factors on loads and on weight.
    pub fn verdict(&self) -> Verdict {
        let under = &self.under;
        let by_factor = match under.factor {
            Some(f64::INFINITY) => Verdict::Stable,
            Some(factor) => Verdict::of_load_factor(factor),
            None => Verdict::Unknown,
        };
        match by_factor {
            Verdict::Unstable => Verdict::Unstable,
            _ if self.weight_verdict() == Verdict::Unstable => Verdict::Unstable,
            _ if !under.limits_known || !under.second_order => Verdict::Unknown,
            Verdict::Stable => match self.weight_verdict() {
                Verdict::Marginal => Verdict::Marginal,
                _ => Verdict::Stable,
            },
            verdict => verdict,
        }
    }
}

impl LoadsAnswer {
    /// Whether the file gives a wind that no combination counts.
    pub fn leaves_wind_out(&self) -> bool {
        self.has_wind && self.is_in_none(|of| of.wind)
    }

    /// Whether the file gives static loads that no combination counts.
    pub fn leaves_loads_out(&self) -> bool {
        self.has_loads && self.is_in_none(|of| of.loads)
    }

    fn is_in_none(&self, factor: fn(&CombinationAnswer) -> f64) -> bool {
        !self.combinations.is_empty() && self.combinations.iter().all(|each| factor(each) == 0.0)
    }

    /// The combination with the worst verdict, then with the smallest factor, for a building with the smallest margin of drift, or, without a
    /// limit, the largest drift.
    pub fn worst(&self) -> Option<&CombinationAnswer> {
        self.combinations.iter().min_by(|a, b| {
            let severity = |of: &CombinationAnswer| match of.verdict() {
                Verdict::Unstable => 0,
                Verdict::Unknown => 1,
                Verdict::Marginal => 2,
                Verdict::Stable => 3,
            };
            let factor = |of: &CombinationAnswer| of.factor().unwrap_or(f64::INFINITY);
            let margin = |of: &CombinationAnswer| {
                let building = of.building();
                building
                    .and_then(BuildingCombination::drift_margin)
                    .unwrap_or(f64::INFINITY)
            };
            let drift = |of: &CombinationAnswer| {
                let largest = of.building().and_then(BuildingCombination::largest);
                largest.map_or(0.0, |of| of.ratio)
            };
            severity(a)
                .cmp(&severity(b))
                .then(factor(a).total_cmp(&factor(b)))
                .then(margin(a).total_cmp(&margin(b)))
                .then(drift(b).total_cmp(&drift(a)))
        })
    }

    /// The worst verdict; unknown if the wind is unknown, or does not include the resonance of the structure.
    pub fn verdict(&self) -> Verdict {
        if self.falls_as_it_hangs() {
            return Verdict::Unstable;
        }
        match self.worst().map_or(Verdict::Unknown, CombinationAnswer::verdict) {
            Verdict::Unstable => Verdict::Unstable,
            _ if self.lacks_resonance_at_hz().is_some() => Verdict::Unknown,
            Verdict::Stable if self.carried.is_some_and(|of| of.verdict() == Verdict::Marginal) => {
                Verdict::Marginal
            }
            verdict => verdict,
        }
    }

    /// Whether it falls under its weight and the weights of its static loads, with factors of 1.
    pub fn falls_as_it_hangs(&self) -> bool {
        self.carried.is_some_and(|of| of.verdict() == Verdict::Unstable)
    }

    /// The lowest natural frequency, Hz, of a structure whose resonance the wind does not include.
    pub fn lacks_resonance_at_hz(&self) -> Option<f64> {
        let along = self.wind.as_ref()?.as_ref().ok()?;
        let blows = self.combinations.iter().any(|of| of.wind != 0.0);
        let of_frame = self.frame_winds.iter().flat_map(FrameWind::states);
        let lacking = [Some(along), self.wind_across.as_ref()].into_iter().flatten();
        let lacking = lacking.chain(of_frame);
        let swinging = lacking.filter_map(|met| match met.resonance {
            Resonance::LeftOut => met.frequency_hz,
            Resonance::NotCounted => met.frequency_hz.filter(|hz| *hz < RESONANCE_BELOW_HZ),
            Resonance::Stiff | Resonance::Counted => None,
        });
        swinging.filter(|_| blows).min_by(f64::total_cmp)
    }

    /// Smallest factor of all combinations.
    pub fn factor(&self) -> Option<f64> {
        let factors = self.combinations.iter().filter_map(CombinationAnswer::factor);
        factors.min_by(f64::total_cmp)
    }
}
