//! Whether a version of a structure stands, with all evidence for and against it.

use crate::building::BuildingAnswer;
use crate::frame::{DirectionLean, StoreyColumns, TenonsCheck};
use crate::loads::LoadsAnswer;
use crate::part_limit::Compared;
use crate::stack::{FrequencyByHeight, VelocityDemand};
use dolmen::assess::demand::{
    DriftLimit, LocalMechanismCapacity, LocalMechanismDemand, SiteDemand, StackDemandCheck,
};
use dolmen::assess::{ChainCheck, FrameCheck, Probability, StackCheck};
use dolmen::blocks::{BesideInSmallMotion, MatchedFrequency, StackMode};
use dolmen::stability::stack::DemandVerdict;
use dolmen::stability::{ChainStability, Verdict};
use dolmen::structure::stack::Stack;
use dolmen_project::{ChainPart, Names, Quantity, SurveyedLean};
use dolmen_words::message::Both;

/// Load factors of chains and frames above this need confirmation. Our choice: measured timber frames and stone poles have 5 to 100, a low
/// gate that sways at 4 Hz has up to 1200.
pub const LOAD_FACTOR_USUAL_MOST: f64 = 2000.0;

/// The result whose sensitivities are given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SensitivityOf {
    /// λ: the structure's stiffness is known.
    #[default]
    LoadFactor,
    /// Stiffness that equal joints of a chain need, because its stiffness is unknown.
    EqualJoints,
    /// Horizontal acceleration at which a stack begins to move.
    FirstMotion,
}

/// The state of one version of a structure.
#[derive(Clone, Debug)]
pub struct State {
    /// The check of the structure.
    pub check: Check,
    /// Measured tilt of the latest survey with a tilt, and the tilt at which a joint reaches its uplift limit.
    pub tilts: Vec<TiltCheck>,
    /// The response to wind and static loads; `None` if the file gives none.
    pub loads: Option<LoadsAnswer>,
    /// Measured first frequencies that differ from the model's by more than [`FREQUENCY_RATIO_MOST`].
    pub contradictions: Vec<FrequencyContradiction>,
    /// The factor on the springs of a stack that gives the frequencies of surveys.
    pub spring_fits: Vec<SpringFit>,
    /// The demand of an earthquake at its site; `None` without a site.
    pub demand: Option<DemandAnswer>,
    /// The scatter of the load factor under uncertain inputs; `None` if not requested, or without a known stiffness.
    pub sampled: Option<Sampled>,
}

/// The seismic demand on a structure.
#[derive(Clone, Debug, PartialEq)]
pub struct DemandAnswer {
    /// The site, with all intermediate numbers.
    pub site: SiteDemand,
    /// The comparison of a stack with it; `None` for other structures, or if the site gives no ground acceleration.
    pub stack: Option<StackDemandCheck>,
    /// The part of a stack that lifts first, under the spectral velocity; `None` for other structures, or if it does not rock first.
    pub by_velocity: Option<VelocityDemand>,
    /// The comparison of local mechanisms of a stack with it, as codes require; they do not affect the verdict.
    pub local_mechanisms: Vec<LocalMechanismAgainstSite>,
    /// Storeys, joints and dampers compared with their limits.
    pub compared: Compared,
    /// Allowable drift of storeys; `None` where the file gives none.
    pub drift_limit: Option<DriftLimit>,
    /// The spectrum at the first period of each direction with a known period.
    pub spectral: Vec<SpectralAt>,
    /// Why there is no comparison, or why a value is missing.
    pub refused: Option<Both>,
}

/// The spectrum at a first period.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct SpectralAt {
    /// "x", "weak"; "all" for a structure that is the same in all directions.
    pub direction: String,
    /// T₁, s.
    pub period_s: f64,
    /// Damping ratio of the spectrum: that of the mode of a building; for a chain or frame that of the file, otherwise that of the site.
    pub damping_ratio: f64,
    /// S_a(T₁, ζ), m/s².
    pub acceleration_m_s2: f64,
}

/// Ratio of a measured first frequency to the model's (or the inverse) from which the model's stiffness does not represent the measured
/// structure: 10 %, a fifth in stiffness. Our choice.
pub const FREQUENCY_RATIO_MOST: f64 = 1.1;

/// A measured tilt compared with overturning, which a load factor does not include: linear joints do not open, and linear storeys have no limit.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltCheck {
    /// The survey.
    pub survey: String,
    /// Direction of the tilt, "x"; "x+y" for both together.
    pub direction: String,
    /// Horizontal / vertical.
    pub tilt: f64,
    /// Smallest tilt at which a joint reaches its uplift limit N b/2; for a frame, the tilt at which a storey has fallen. `None` without bed
    /// widths or stiffness.
    pub uplift_tilt: Option<f64>,
    /// Smallest tilt over all joints at which a bed begins to open under a linear pressure.
    pub opens_tilt: Option<f64>,
}

/// The surveyed lean of a structure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Leaning {
    /// Resultant of all directions, rad.
    pub(crate) together_rad: f64,
    /// Along x and y, rad; both are the resultant if a direction has another name.
    pub(crate) each_rad: [f64; 2],
}

impl Leaning {
    /// The lean of a chain under its loads: none if the file leaves it out.
    pub(crate) fn of_chain(part: &ChainPart, tilts: &[TiltCheck]) -> Self {
        Self::of(if part.takes_no_tilt { &[] } else { tilts })
    }

    fn of(tilts: &[TiltCheck]) -> Self {
        let together_rad = TiltCheck::resultant(tilts);
        let each = tilts.iter().filter(|of| !of.is_of_both());
        let is_named = each.clone().all(|of| of.direction == "x" || of.direction == "y");
        let along = |direction: &str| {
            each.clone()
                .find(|of| of.direction == direction)
                .map_or(0.0, |of| of.tilt)
        };
        Leaning {
            together_rad,
            each_rad: match is_named {
                true => ["x", "y"].map(along),
                false => [together_rad; 2],
            },
        }
    }
}

impl TiltCheck {
    /// Share of the overturning tilt at which a bed begins to open at a side.
    pub const OPENS: f64 = 1.0 / 3.0;

    /// The resultant tilt of perpendicular directions, rad.
    pub(crate) fn resultant(tilts: &[TiltCheck]) -> f64 {
        let each = tilts.iter().filter(|of| !of.is_of_both());
        each.map(|of| of.tilt * of.tilt).sum::<f64>().sqrt()
    }

    /// Whether it is the resultant of two directions.
    fn is_of_both(&self) -> bool {
        self.direction.contains('+')
    }

    /// Unstable if the tilt has reached the uplift limit, marginal within [`Verdict::MARGINAL_BELOW`] of it.
    pub fn verdict(&self) -> Verdict {
        self.uplift_tilt.map_or(Verdict::Unknown, |limit| {
            Verdict::of_load_factor(limit / self.tilt.abs())
        })
    }
}

/// A measured frequency that contradicts the model.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct FrequencyContradiction {
    /// The survey.
    pub survey: String,
    /// Direction of the mode.
    pub direction: String,
    /// Lowest measured frequency of translation, Hz.
    pub measured_hz: f64,
    /// Lowest frequency of the model, Hz.
    pub computed_hz: f64,
    /// Whether the model's frequency is within three standard deviations: the measurement is too inaccurate to contradict it.
    pub is_too_rough: bool,
    /// The later survey that also measured this direction and is used instead.
    pub superseded_by: Option<String>,
}

impl FrequencyContradiction {
    /// The mistake that gives exactly this ratio; `None` if there is none.
    pub fn likely(&self) -> Option<dolmen_project::Doubted> {
        dolmen_project::likely(self.measured_hz, self.computed_hz)
    }
}

/// The check, by kind of structure.
#[derive(Clone, Debug)]
pub enum Check {
    /// A chain.
    Chain(Box<ChainCheck>),
    /// A frame, one check for each direction.
    Frame(Vec<DirectionCheck>),
    /// A stack of blocks.
    Stack(Box<StackAnswer>),
    /// A building.
    Building(Box<BuildingAnswer>),
}

/// A stack and its check.
#[derive(Clone, Debug, PartialEq)]
pub struct StackAnswer {
    /// The stack as the file gives it.
    pub stack: Stack,
    /// Whether it stands, and the horizontal acceleration at which it begins to move.
    pub check: StackCheck,
    /// Its measured lean.
    pub lean: Option<SurveyedLean>,
    /// Natural frequencies on the springs of its joints; `None` if it does not stand.
    pub frequencies: Option<StackFrequencies>,
    /// The same without its side supports, which demands leave out; `None` without side supports in the frequencies.
    pub frequencies_unheld: Option<StackFrequencies>,
    /// The role of each side support in the frequencies; empty for a stack that does not stand.
    pub beside: Vec<BesideInSmallMotion>,
    /// Local mechanisms as codes require, one for each direction; empty if it does not stand, `None` if not requested.
    pub local_mechanisms: Option<Vec<LocalMechanismRow>>,
    /// Frequencies of pagodas with its factors, for other heights and storeys; empty for a stack without factors, and if not requested.
    pub frequency_by_height: Vec<FrequencyByHeight>,
}

impl StackAnswer {
    /// The frequencies without its side supports, which every threshold leaves out.
    pub fn frequencies_of_demand(&self) -> Option<&StackFrequencies> {
        self.frequencies_unheld.as_ref().or(self.frequencies.as_ref())
    }
}

/// The local mechanism of a stack in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalMechanismRow {
    /// Unit vector of the inertia forces in plan.
    pub direction: [f64; 2],
    /// The moving part and its load factor; `None` where nothing moves, or the limit analysis found no solution.
    pub capacity: Option<LocalMechanismCapacity>,
}

/// A local mechanism of a stack compared with the demand of its site.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalMechanismAgainstSite {
    /// Its capacity.
    pub capacity: LocalMechanismCapacity,
    /// The demand.
    pub demand: LocalMechanismDemand,
}

/// Natural frequencies of a stack: those of the springs that the file gives or Dolmen assumes.
#[derive(Clone, Debug, PartialEq)]
pub enum StackFrequencies {
    /// They are known.
    Known {
        /// Lowest first, all of them for few stones; [`MODES_SHOWN`] are shown.
        modes: Vec<StackMode>,
        /// Index of the first mode of swaying along x and along y, and its frequency, Hz.
        sways: [Option<(usize, f64)>; 2],
    },
    /// Why they are unknown.
    Refused(Both),
}

/// Number of natural frequencies of a stack that are shown. Our choice: swaying along both axes, and one more.
pub const MODES_SHOWN: usize = 3;

impl StackFrequencies {
    /// The first mode of swaying along "x" or "y": its index among all modes, from 0, and its frequency, Hz.
    pub fn sway(&self, direction: &str) -> Option<(usize, f64)> {
        let StackFrequencies::Known { sways, .. } = self else {
            return None;
        };
        match direction {
            "x" => sways[0],
            "y" => sways[1],
            _ => None,
        }
    }

    /// The computed modes, lowest first.
    pub fn modes(&self) -> Option<&[StackMode]> {
        match self {
            StackFrequencies::Known { modes, .. } => Some(modes),
            StackFrequencies::Refused(_) => None,
        }
    }
}

/// The factor on all springs of a stack from one survey.
#[derive(Clone, Debug, PartialEq)]
pub struct SpringFit {
    /// The survey.
    pub survey: String,
    /// The factor; `None` without a comparable frequency.
    pub factor: Option<f64>,
    /// For each direction the lowest measured frequency, and that of the stack with the factor.
    pub frequencies: Vec<(String, MatchedFrequency)>,
    /// Directions with a measured frequency other than x and y: not compared.
    pub not_compared: Vec<String>,
}

/// A frame in one direction.
#[derive(Clone, Debug)]
pub struct DirectionCheck {
    /// "weak", "strong", "x".
    pub direction: String,
    /// Its check, with every joint stuck.
    pub check: FrameCheck,
    /// The same with every joint slipping; `None` if slipping does not reduce the stiffness, or if the stiffness is unknown.
    pub slipping: Option<FrameCheck>,
    /// Its surveyed lean at rest; `None` without a tilt, with unknown stiffness, or if it falls.
    pub lean: Option<DirectionLean>,
    /// The resistance of free-standing columns, for the storeys that have some.
    pub columns: Vec<StoreyColumns>,
    /// The stiffness of its tenons with slack once they bear; `None` without any, or if its stiffness is unknown.
    pub tenons: Option<TenonsCheck>,
}

/// A variant and its state.
#[derive(Clone, Debug)]
pub struct VariantAnswer {
    /// The table's name.
    pub name: String,
    /// A longer name, if given.
    pub title: Option<Names>,
    /// Inputs that the project as given lacks or has with other values.
    pub own_inputs: Vec<Quantity>,
    /// Its state.
    pub state: State,
}

/// The load factor for random samples of the inputs.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Sampled {
    /// Probability of a fall: λ ≤ 1, or a frame whose surveyed lean grows to a fall.
    pub unstable: Probability,
    /// Probability that a combination of wind and static loads brings a joint to its limit; `None` without such loads.
    pub under_loads: Option<Probability>,
    /// λ of each sample, ascending. For a frame the smallest of its directions.
    #[serde(rename = "load_factor_quantiles", serialize_with = "as_quantiles")]
    pub load_factors: Vec<f64>,
    /// Paths of the random inputs.
    pub inputs: Vec<String>,
    /// Whether static loads add to the weight.
    #[serde(skip)]
    pub weighs_loads: bool,
    /// For a plumb frame whose joints lose stiffness when they slip: the number of samples that fall while they stick.
    #[serde(skip)]
    pub falls_sticking: Option<usize>,
}

/// Quantiles of the samples whose load factors are printed.
const QUANTILES: [(&str, f64); 3] = [("5 %", 0.05), ("50 %", 0.5), ("95 %", 0.95)];

impl Sampled {
    /// λ below which 5, 50 and 95 % of the samples lie.
    pub fn quantiles(&self) -> [f64; 3] {
        quantiles(&self.load_factors)
    }
}

fn quantiles(ascending: &[f64]) -> [f64; 3] {
    let last = ascending.len().saturating_sub(1);
    QUANTILES.map(|(_, share)| {
        let place = (share * last as f64).round() as usize;
        ascending.get(place).copied().unwrap_or(f64::NAN)
    })
}

fn as_quantiles<S: serde::Serializer>(load_factors: &[f64], serializer: S) -> Result<S::Ok, S::Error> {
    let shares = QUANTILES.iter().map(|(share, _)| share);
    serializer.collect_map(shares.zip(quantiles(load_factors)))
}

impl State {
    /// Load factor λ: for a frame the smallest of its directions; `None` if no stiffness is known, and for a stack.
    pub fn load_factor(&self) -> Option<f64> {
        match &self.check {
            Check::Chain(check) => check.load_factor(),
            Check::Frame(directions) => {
                let known = directions.iter().filter_map(|d| d.check.stability.as_ref());
                known.map(|s| s.load_factor).min_by(f64::total_cmp)
            }
            Check::Building(building) => Some(building.load_factor()),
            Check::Stack(_) => None,
        }
    }

    /// The load factor of a chain or frame, if it is so large that a unit is probably wrong. For a building, the reader of the file checks
    /// its lowest frequency.
    pub fn unusual_load_factor(&self) -> Option<f64> {
        match &self.check {
            Check::Chain(_) | Check::Frame(_) => self
                .load_factor()
                .filter(|factor| factor.is_finite() && *factor > LOAD_FACTOR_USUAL_MOST),
            Check::Building(_) | Check::Stack(_) => None,
        }
    }

    /// Smallest load factor of a frame with slipping joints; `None` if none can slip.
    pub fn slipping_load_factor(&self) -> Option<f64> {
        let Check::Frame(directions) = &self.check else {
            return None;
        };
        let slipping = directions
            .iter()
            .filter_map(|direction| direction.slipping.as_ref());
        let known = slipping.filter_map(|check| check.stability.as_ref());
        known
            .map(|stability| stability.load_factor)
            .min_by(f64::total_cmp)
    }

    /// The worst verdict of the structure.
    pub fn verdict(&self) -> Verdict {
        let loads = self.loads.as_ref().map(|loads| self.loads_verdict(loads));
        worst([self.weight_verdict()].into_iter().chain(loads))
    }

    /// The verdict on wind and static loads. Supports that move change the shape: static loads without factors move with it, but the effect of
    /// wind and of factors is then unknown.
    fn loads_verdict(&self, loads: &LoadsAnswer) -> Verdict {
        let moves =
            matches!(&self.check, Check::Stack(answer) if !answer.stack.support_movements().is_empty());
        let mut combinations = loads.combinations.iter();
        let asks_more = combinations.any(|of| of.wind != 0.0 || of.loads > 1.0 || of.weight < 1.0);
        match loads.verdict() {
            Verdict::Stable | Verdict::Marginal if moves && asks_more => Verdict::Unknown,
            verdict => verdict,
        }
    }

    /// The share of the samples that fall under their own weight, or reach a limit under wind and static loads, whichever is larger; `None`
    /// without samples, or if none does.
    pub fn falling_share(&self) -> Option<f64> {
        let sampled = self.sampled.as_ref()?;
        let each = std::iter::once(&sampled.unstable).chain(&sampled.under_loads);
        let shares = each.filter(|of| of.count > 0).map(|of| of.estimate);
        shares.max_by(f64::total_cmp)
    }

    /// The worst verdict without wind and static loads.
    fn weight_verdict(&self) -> Verdict {
        // a tilt that cannot be checked does not change the verdict
        let tilts = self
            .tilts
            .iter()
            .map(TiltCheck::verdict)
            .filter(|verdict| *verdict != Verdict::Unknown);
        worst(tilts.chain([self.stability_verdict()]))
    }

    /// Wind and loads, where they govern the verdict.
    pub fn governing_loads(&self) -> Option<&LoadsAnswer> {
        let loads = self.loads.as_ref()?;
        let verdict = self.verdict();
        // the check of a stack includes its static loads already
        let in_check = matches!(&self.check, Check::Stack(answer) if !answer.stack.static_loads().is_empty());
        let is_one = in_check && verdict != Verdict::Stable && self.loads_verdict(loads) == verdict;
        (is_one || self.weight_verdict() != verdict).then_some(loads)
    }

    /// The worse direction of a chain with two, under its weight and its tilt; `None` for others, or if both are equal.
    pub fn worse_direction(&self) -> Option<&'static str> {
        let Check::Chain(check) = &self.check else {
            return None;
        };
        let across = check.across.as_ref()?.stability.as_ref()?;
        let of = |stability: &ChainStability, name: &str| {
            let tilts = self.tilts.iter().filter(|of| of.direction == name);
            let factors = tilts.filter_map(|of| Some(of.uplift_tilt? / of.tilt.abs()));
            factors.fold(stability.load_factor, f64::min)
        };
        let (along, across) = (of(check.stability.as_ref()?, "x"), of(across, "y"));
        match along.total_cmp(&across) {
            std::cmp::Ordering::Less => Some("x"),
            std::cmp::Ordering::Greater => Some("y"),
            std::cmp::Ordering::Equal => None,
        }
    }

    /// The comparison with the demand of its site; `None` without one.
    pub fn demand_verdict(&self) -> Option<DemandVerdict> {
        Some(self.demand.as_ref()?.stack.as_ref()?.verdict)
    }

    /// The verdict on the load factor alone; for a stack, on its smallest margin without shaking.
    pub fn stability_verdict(&self) -> Verdict {
        match &self.check {
            Check::Chain(chain) => {
                let along = chain.stability.as_ref().map_or(Verdict::Unknown, |s| s.verdict);
                let across = chain.across.iter();
                let across = across.map(|of| of.stability.as_ref().map_or(Verdict::Unknown, |s| s.verdict));
                worst([along].into_iter().chain(across))
            }
            Check::Frame(directions) => {
                let of =
                    |check: &FrameCheck| check.stability.as_ref().map_or(Verdict::Unknown, |s| s.verdict);
                let checks = directions
                    .iter()
                    .flat_map(|d| [&d.check].into_iter().chain(&d.slipping));
                worst(checks.map(of))
            }
            Check::Building(building) => Verdict::of_load_factor(building.load_factor()),
            Check::Stack(answer) => answer.check.verdict,
        }
    }
}

/// Unstable if any is; otherwise unknown if any is; otherwise the worst.
fn worst(verdicts: impl Iterator<Item = Verdict>) -> Verdict {
    let severity = |verdict: &Verdict| match verdict {
        Verdict::Unstable => 3,
        Verdict::Unknown => 2,
        Verdict::Marginal => 1,
        Verdict::Stable => 0,
    };
    verdicts.max_by_key(severity).unwrap_or(Verdict::Unknown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_an_unknown_direction_never_hides_behind_a_stable_one() {
        assert_eq!(
            worst([Verdict::Stable, Verdict::Unknown].into_iter()),
            Verdict::Unknown
        );
        assert_eq!(
            worst([Verdict::Unknown, Verdict::Unstable].into_iter()),
            Verdict::Unstable
        );
        assert_eq!(
            worst([Verdict::Marginal, Verdict::Stable].into_iter()),
            Verdict::Marginal
        );
        assert_eq!(worst([].into_iter()), Verdict::Unknown);
    }
}
