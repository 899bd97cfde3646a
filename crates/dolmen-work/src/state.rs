//! Whether a version of a structure stands, and everything that speaks for or against it.

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
use dolmen_project::{Names, Quantity, SurveyedLean};
use dolmen_words::message::Both;

/// The result whose sensitivities are given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SensitivityOf {
    /// λ: the structure's stiffness is known.
    #[default]
    LoadFactor,
    /// Stiffness that equal joints of a chain need: its own is not known.
    EqualJoints,
    /// Horizontal acceleration at which a stack begins to move.
    FirstMotion,
}

/// Whether one version of a structure stands.
#[derive(Clone, Debug)]
pub struct State {
    /// The check of the structure.
    pub check: Check,
    /// Measured tilt against the tilt at which a joint reaches its uplift limit, of the last survey that states one.
    pub tilts: Vec<TiltCheck>,
    /// What wind and static loads do; `None` if the file gives none.
    pub loads: Option<LoadsAnswer>,
    /// Where a measured first frequency and that of the model differ by more than [`FREQUENCY_RATIO_MOST`].
    pub contradictions: Vec<FrequencyContradiction>,
    /// What the springs of a stack must be multiplied by to have the frequencies that surveys measured.
    pub spring_fits: Vec<SpringFit>,
    /// What an earthquake asks for at its site; `None` if the file has none.
    pub demand: Option<DemandAnswer>,
    /// Its scatter under the inputs that carry a cov; `None` if not asked for or no stiffness is known.
    pub sampled: Option<Sampled>,
}

/// What an earthquake asks of a structure.
#[derive(Clone, Debug, PartialEq)]
pub struct DemandAnswer {
    /// The site with every number on the way.
    pub site: SiteDemand,
    /// A stack against it; `None` for other structures, and where the site gives no acceleration of the ground.
    pub stack: Option<StackDemandCheck>,
    /// The part of a stack that lifts first against the spectral velocity; `None` of other structures, and where it does not rock first.
    pub by_velocity: Option<VelocityDemand>,
    /// Local mechanisms of a stack against it, as codes want them: beside that, and they decide nothing.
    pub local_mechanisms: Vec<LocalMechanismAgainstSite>,
    /// Storeys, joints and dampers against what limits them.
    pub compared: Compared,
    /// Allowable drift of storeys; `None` where the file gives none.
    pub drift_limit: Option<DriftLimit>,
    /// The spectrum at the first period of each direction that is known.
    pub spectral: Vec<SpectralAt>,
    /// Why nothing was compared, or a value is missing.
    pub refused: Option<Both>,
}

/// The spectrum at a first period.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct SpectralAt {
    /// "x", "weak"; "all" for a structure that is the same in all.
    pub direction: String,
    /// T₁, s.
    pub period_s: f64,
    /// ζ at which the spectrum is read: that of the mode of a building, of a chain or frame what the file gives it, else that of the site.
    pub damping_ratio: f64,
    /// S_a(T₁, ζ), m/s².
    pub acceleration_m_s2: f64,
}

/// Ratio of a measured first frequency to the model's (or the other way round) from which the stiffness of the model is
/// not that of the structure measured: 10 %, a fifth in stiffness. Chosen here.
pub const FREQUENCY_RATIO_MOST: f64 = 1.1;

/// A measured tilt against overturning, which a load factor does not see: a linear joint does not open, and a linear storey has no end.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltCheck {
    /// The survey.
    pub survey: String,
    /// Direction of the tilt, "x"; "x+y" of both together.
    pub direction: String,
    /// Horizontal / vertical.
    pub tilt: f64,
    /// Least tilt of all joints at which one reaches its uplift limit N b/2, of a frame that at which a storey counts as fallen; `None` without bed widths or stiffness.
    pub uplift_tilt: Option<f64>,
    /// Least tilt of all joints at which a bed begins to open under a linear pressure.
    pub opens_tilt: Option<f64>,
}

/// How a structure leans as surveyed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Leaning {
    /// By all directions together, rad.
    pub(crate) together_rad: f64,
    /// Along x and y, rad; both that of all together where a direction has another name.
    pub(crate) each_rad: [f64; 2],
}

impl Leaning {
    pub(crate) fn of(tilts: &[TiltCheck]) -> Self {
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
    /// Of the tilt at which a bed stands on its edge: along one of its sides it begins to open at this share.
    pub const OPENS: f64 = 1.0 / 3.0;

    /// The tilt of all directions together, which are across each other, rad.
    pub(crate) fn resultant(tilts: &[TiltCheck]) -> f64 {
        let each = tilts.iter().filter(|of| !of.is_of_both());
        each.map(|of| of.tilt * of.tilt).sum::<f64>().sqrt()
    }

    /// Whether it is that of two directions together.
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

/// A measured frequency that the model does not have.
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
    /// Three standard deviations of the measurement reach the model's frequency: it is too rough to tell.
    pub is_too_rough: bool,
    /// The later survey that measured this direction too, and decides.
    pub superseded_by: Option<String>,
}

impl FrequencyContradiction {
    /// The slip that gives just this ratio; `None` if there is none.
    pub fn likely(&self) -> Option<dolmen_project::Doubted> {
        dolmen_project::likely(self.measured_hz, self.computed_hz)
    }
}

/// The check, by kind of structure.
#[derive(Clone, Debug)]
pub enum Check {
    /// A chain.
    Chain(Box<ChainCheck>),
    /// A frame, one check a direction.
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
    /// Does it stand, and at what horizontal acceleration does it begin to move.
    pub check: StackCheck,
    /// How it leans as surveyed.
    pub lean: Option<SurveyedLean>,
    /// Natural frequencies on the springs of its joints; `None` if it does not stand.
    pub frequencies: Option<StackFrequencies>,
    /// The same without its side supports, which demands leave out; `None` where the frequencies count none.
    pub frequencies_unheld: Option<StackFrequencies>,
    /// How each side support takes part in the frequencies; none of a stack that does not stand.
    pub beside: Vec<BesideInSmallMotion>,
    /// Local mechanisms as codes want them, a direction each; none if it does not stand. `None` where they were not asked for.
    pub local_mechanisms: Option<Vec<LocalMechanismRow>>,
    /// Frequencies of pagodas like it, of other heights and storeys; empty of a stack that no factors make, and where they were not asked for.
    pub frequency_by_height: Vec<FrequencyByHeight>,
}

impl StackAnswer {
    /// The frequencies without its side supports, which every threshold leaves out.
    pub fn frequencies_of_demand(&self) -> Option<&StackFrequencies> {
        self.frequencies_unheld.as_ref().or(self.frequencies.as_ref())
    }
}

/// The local mechanism of a stack one way.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalMechanismRow {
    /// Unit vector of the inertia forces in plan.
    pub direction: [f64; 2],
    /// What moves and what it bears; `None` where nothing moves, or the limit analysis found no solution.
    pub capacity: Option<LocalMechanismCapacity>,
}

/// A local mechanism of a stack against its site.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalMechanismAgainstSite {
    /// What it bears.
    pub capacity: LocalMechanismCapacity,
    /// What the site asks of it.
    pub demand: LocalMechanismDemand,
}

/// Natural frequencies of a stack: those of the springs that the file gives or Dolmen assumes.
#[derive(Clone, Debug, PartialEq)]
pub enum StackFrequencies {
    /// They are known.
    Known {
        /// Lowest first, of few stones all; [`MODES_SHOWN`] are shown.
        modes: Vec<StackMode>,
        /// Which of all its modes is the first of swaying along x and along y, and its frequency, Hz.
        sways: [Option<(usize, f64)>; 2],
    },
    /// Why they are not.
    Refused(String),
}

/// How many natural frequencies of a stack are shown. Chosen here: swaying along both axes, and one more.
pub const MODES_SHOWN: usize = 3;

impl StackFrequencies {
    /// The first mode of swaying along "x" or "y": its number among all modes, from 0, and its frequency, Hz.
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

    /// The modes found, lowest first.
    pub fn modes(&self) -> Option<&[StackMode]> {
        match self {
            StackFrequencies::Known { modes, .. } => Some(modes),
            StackFrequencies::Refused(_) => None,
        }
    }
}

/// One factor on all springs of a stack, from one survey.
#[derive(Clone, Debug, PartialEq)]
pub struct SpringFit {
    /// The survey.
    pub survey: String,
    /// What the stiffness of every joint must be multiplied by; `None` if nothing can be compared.
    pub factor: Option<f64>,
    /// By direction the lowest frequency measured, and that of the stack with the factor.
    pub frequencies: Vec<(String, MatchedFrequency)>,
    /// Directions with a measured frequency that are neither x nor y: not compared.
    pub not_compared: Vec<String>,
}

/// A frame in one direction.
#[derive(Clone, Debug)]
pub struct DirectionCheck {
    /// "weak", "strong", "x".
    pub direction: String,
    /// Its check, with every joint stuck.
    pub check: FrameCheck,
    /// The same while every joint slips; `None` where slipping takes no stiffness away, or it is not known.
    pub slipping: Option<FrameCheck>,
    /// How it leans as surveyed, at rest; `None` where it takes no tilt over, is not known, or falls.
    pub lean: Option<DirectionLean>,
    /// What free-standing columns hold, of the storeys that have some.
    pub columns: Vec<StoreyColumns>,
    /// What its tenons with slack add once they bear; `None` without any, or where its stiffness is not known.
    pub tenons: Option<TenonsCheck>,
}

/// A variant and whether it stands.
#[derive(Clone, Debug)]
pub struct VariantAnswer {
    /// The table's name.
    pub name: String,
    /// A longer name, if given.
    pub title: Option<Names>,
    /// Inputs that the project as given does not have, or not so.
    pub own_inputs: Vec<Quantity>,
    /// Does it stand.
    pub state: State,
}

/// The load factor under inputs drawn from their distributions.
#[derive(Clone, Debug, serde::Serialize)]
pub struct Sampled {
    /// Probability that the structure falls: λ ≤ 1, or a frame leans to its fall as surveyed.
    pub unstable: Probability,
    /// Probability that a combination of wind and static loads brings a joint to its limit; `None` where there are none.
    pub under_loads: Option<Probability>,
    /// λ of each sample, ascending. For a frame the smallest of its directions.
    #[serde(rename = "load_factor_quantiles", serialize_with = "as_quantiles")]
    pub load_factors: Vec<f64>,
    /// Paths of the inputs that were drawn.
    pub inputs: Vec<String>,
}

/// Shares of the samples whose load factors are printed.
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
    /// Whether a damper of a building needs more room under the spectrum of its site than it has.
    pub fn is_beyond_room(&self) -> bool {
        match &self.check {
            Check::Building(answer) => {
                let mut standing = answer.stands.iter();
                standing.any(|standing| !standing.beyond_room().is_empty())
            }
            _ => false,
        }
    }

    /// Load factor λ: of a frame the smallest of its directions; `None` if no stiffness is known, and of a stack.
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

    /// Least load factor of a frame whose joints slip; `None` if none can.
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

    /// That of wind and static loads. Supports that move change the shape: static loads as they are move with it, of wind and of factors
    /// nothing is known then.
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

    /// The share of the samples that falls under its own weight, or that wind and static loads bring to a limit, whichever is larger; `None`
    /// without samples, or where none does.
    pub fn falling_share(&self) -> Option<f64> {
        let sampled = self.sampled.as_ref()?;
        let each = std::iter::once(&sampled.unstable).chain(&sampled.under_loads);
        let shares = each.filter(|of| of.count > 0).map(|of| of.estimate);
        shares.max_by(f64::total_cmp)
    }

    /// The worst verdict without wind and static loads.
    fn weight_verdict(&self) -> Verdict {
        // a tilt that cannot be checked stands beside the verdict, and does not change it
        let tilts = self
            .tilts
            .iter()
            .map(TiltCheck::verdict)
            .filter(|verdict| *verdict != Verdict::Unknown);
        worst(tilts.chain([self.stability_verdict()]))
    }

    /// Wind and loads, where they make the verdict what it is.
    pub fn governing_loads(&self) -> Option<&LoadsAnswer> {
        let loads = self.loads.as_ref()?;
        let verdict = self.verdict();
        // static loads of a stack are in its check already
        let in_check = matches!(&self.check, Check::Stack(answer) if !answer.stack.static_loads().is_empty());
        let is_one = in_check && verdict != Verdict::Stable && self.loads_verdict(loads) == verdict;
        (is_one || self.weight_verdict() != verdict).then_some(loads)
    }

    /// The direction of a chain of two in which it is worse off under its weight and its tilt; `None` of others, and where both do alike.
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

    /// Against the demand of its site; `None` if that is not compared.
    pub fn demand_verdict(&self) -> Option<DemandVerdict> {
        Some(self.demand.as_ref()?.stack.as_ref()?.verdict)
    }

    /// The verdict on the load factor alone, of a stack on its least margin without shaking.
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

/// Unstable if any is; else unknown if any is; else the worse of the rest.
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
