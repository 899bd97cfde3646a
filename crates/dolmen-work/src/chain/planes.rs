//! A chain in each of its directions, with its static loads and the wind on it.

use crate::error::WorkError;
use crate::loads::{Carried, WindMet};
use crate::state::Leaning;
use dolmen::dynamics::JointOpening;
use dolmen::stability::{
    ChainLoading, ChainUnderLoads, JointHold, LinkLoad, chain_stability, chain_under_loads,
};
use dolmen::structure::{AddedMass, Chain, lowest_frequency_hz};
use dolmen_project::{ChainAxis, ChainPart, LoadPart, LoadsPart, Pick};

/// Properties of the joints.
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

/// A static load in numbers; forces and moments along and across.
pub(super) struct LoadComponents {
    link: usize,
    above_joint_m: f64,
    force_n: [f64; 2],
    pub(super) weight_n: f64,
    moment_n_m: [f64; 2],
}

fn acting(load: &LoadPart, chain: &Chain, pick: Pick<'_>) -> LoadComponents {
    let force_n = [&load.force, &load.force_across].map(|force| force.as_ref().map_or(0.0, &mut *pick));
    // the moment acts in the direction of the force
    let size = force_n[0].hypot(force_n[1]);
    let share = match load.force_across.is_some() && size > 0.0 {
        true => force_n.map(|force_n| force_n / size),
        false => [1.0, 0.0],
    };
    let moment_n_m = load.moment.as_ref().map_or(0.0, &mut *pick);
    LoadComponents {
        link: load.part,
        above_joint_m: load.above_joint_m(chain, pick),
        force_n,
        weight_n: load.weight.as_ref().map_or(0.0, &mut *pick),
        moment_n_m: share.map(|share| share * moment_n_m),
    }
}

/// Data that do not depend on the combination.
pub(super) struct Model {
    /// Along, and across if the chain has separate values there.
    pub(super) planes: Vec<Plane>,
    /// Properties of the joints, with the widths of the beds along.
    pub(super) holds: Vec<JointHold>,
    pub(super) loads: Vec<LoadComponents>,
}

/// The chain in one direction.
pub(super) struct Plane {
    pub(super) axis: ChainAxis,
    pub(super) chain: Chain,
    pub(super) stiffness: Option<Vec<f64>>,
    pub(super) met: Option<WindMet>,
    pub(super) tilt_rad: f64,
}

impl Model {
    pub(super) fn new(
        part: &ChainPart,
        given: &LoadsPart,
        leaning: Leaning,
        pick: Pick<'_>,
    ) -> Result<Self, WorkError> {
        let mut planes = Vec::new();
        for axis in part.axes() {
            planes.push(Plane {
                axis: *axis,
                chain: part.build_towards(*axis, pick)?,
                stiffness: part.stiffness_towards(*axis, pick),
                met: None,
                tilt_rad: match (part.has_two_axes(), axis) {
                    (false, _) => leaning.together_rad,
                    (true, ChainAxis::Along) => leaning.each_rad[0],
                    (true, ChainAxis::Across) => leaning.each_rad[1],
                },
            });
        }
        let chain = part.build(pick)?;
        Ok(Model {
            planes,
            holds: holds(part, pick),
            loads: given
                .loads
                .iter()
                .map(|load| acting(load, &chain, pick))
                .collect(),
        })
    }

    /// Load factor with the weights of the loads, which move as well: the smaller of the directions.
    pub(super) fn carried(&self, weight_n: f64) -> Result<Option<Carried>, WorkError> {
        let mut all = Vec::new();
        for plane in &self.planes {
            let Some(stiffness) = plane.stiffness.as_ref().filter(|_| weight_n != 0.0) else {
                return Ok(None);
            };
            let heavy = weighted(&plane.chain, &self.loads, [1.0, 1.0])?;
            all.push(Carried {
                weight_n,
                load_factor: chain_stability(&heavy, stiffness)?.load_factor,
                frequency_hz: lowest_frequency_hz(&heavy.natural_modes(stiffness)?),
            });
        }
        Ok(all
            .into_iter()
            .min_by(|a, b| a.load_factor.total_cmp(&b.load_factor)))
    }
}

impl Plane {
    /// Lowest frequency with the weights of the loads, Hz; `None` if the chain falls or no stiffness is known.
    pub(super) fn heavy_frequency_hz(&self, loads: &[LoadComponents]) -> Result<Option<f64>, WorkError> {
        let Some(stiffness) = &self.stiffness else {
            return Ok(None);
        };
        let heavy = weighted(&self.chain, loads, [1.0, 1.0])?;
        Ok(lowest_frequency_hz(&heavy.natural_modes(stiffness)?))
    }

    /// The chain under factors on static loads and on the wind in this direction.
    pub(super) fn under(
        &self,
        chain: &Chain,
        model: &Model,
        [loads, wind]: [f64; 2],
    ) -> Result<ChainUnderLoads, WorkError> {
        let mut all = Vec::new();
        let bottoms = chain.joint_heights_m();
        for (i, of) in self.met.iter().flat_map(|met| met.links.iter().enumerate()) {
            all.push(LinkLoad {
                link: i + 1,
                height_m: 0.0,
                force_n: wind * of.force_n,
                moment_n_m: wind * (of.moment_n_m - of.force_n * bottoms[i]),
            });
        }
        let axis = match self.axis {
            ChainAxis::Along => 0,
            ChainAxis::Across => 1,
        };
        for load in &model.loads {
            all.push(LinkLoad {
                link: load.link + 1,
                height_m: load.above_joint_m,
                force_n: loads * load.force_n[axis],
                moment_n_m: loads * load.moment_n_m[axis],
            });
        }
        let holds: Vec<JointHold> = model
            .holds
            .iter()
            .map(|hold| hold_towards(*hold, self.axis))
            .collect();
        let loading = ChainLoading {
            loads: &all,
            holds: &holds,
            tilt_rad: self.tilt_rad,
        };
        Ok(chain_under_loads(chain, self.stiffness.as_deref(), &loading)?)
    }
}

/// Properties of a joint for motion in one direction.
fn hold_towards(hold: JointHold, axis: ChainAxis) -> JointHold {
    match (hold, axis) {
        (JointHold::Bed(bed), ChainAxis::Across) => JointHold::Bed(bed.across()),
        _ => hold,
    }
}

/// The chain with a factor on its own weight, and another on the weights of static loads.
pub(super) fn weighted(
    chain: &Chain,
    loads: &[LoadComponents],
    [weight, loaded]: [f64; 2],
) -> Result<Chain, WorkError> {
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
