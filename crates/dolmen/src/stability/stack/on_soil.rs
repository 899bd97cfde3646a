//! A stack on its soil: what a footing that rocks leaves of the accelerations on rigid ground. Symbols as in `footing`.

use super::footing::{Footing, FootingFalls, StandingFooting};
use super::half_plane::HalfPlane;
use super::loads::{Load, together};
use super::{FootingLimit, PointForce, Resistance, StackLoads, Standing, Threshold};
use crate::stability::StabilityError;
use crate::structure::stack::{Body, Polygon, Stack};
use glam::DVec3;

/// Least S over the initial stiffness of the bed: a stack that loads lift does not fall further as it turns. Our choice.
const FALLS_LEAST: f64 = 1e-9;

/// The soil under a stack with its loads.
#[derive(Debug)]
pub(crate) struct OnSoil {
    /// `None` on rigid ground, and if the footing does not stand.
    footing: Option<StandingFooting>,
    pub(super) standing: Standing,
    pub(super) limit: Option<FootingLimit>,
    gravity_m_s2: f64,
}

impl OnSoil {
    /// The soil of a stack under loads.
    ///
    /// # Errors
    /// [`StabilityError`] for loads out of their range.
    pub(crate) fn of(stack: &Stack, loads: &StackLoads) -> Result<Self, StabilityError> {
        let on_blocks = loads.on_blocks(stack)?;
        Ok(Self::under(stack, &on_blocks, loads.vertical_acceleration_m_s2))
    }

    pub(super) fn under(stack: &Stack, loads: &[Load], vertical_m_s2: f64) -> Self {
        let effective = stack.gravity_m_s2() + vertical_m_s2;
        let mut found = OnSoil {
            footing: None,
            standing: Standing::Stands,
            limit: None,
            gravity_m_s2: stack.gravity_m_s2(),
        };
        let all: Vec<usize> = (0..loads.len()).collect();
        let Some(footing) = footing(stack, &together(loads, &all), effective) else {
            return found;
        };
        let falls_n_m = footing.falls_n_m;
        let corners = footing.patch.corners_m.clone();
        let (settled, pushed, force_n, lever) = (
            footing.settled,
            footing.pushed,
            footing.force_n,
            footing.lever_kg_m,
        );
        match StandingFooting::of(footing, effective) {
            Ok(standing) => {
                let way = standing.worst();
                let edge = corners.iter().map(|[x, y]| x * way[0] + y * way[1]);
                let edge = edge.fold(f64::NEG_INFINITY, f64::max);
                let spent = (settled[0] + pushed[0]) * way[0] + (settled[1] + pushed[1]) * way[1];
                let overturns = standing.overturns(way).map_or(0.0, |peak| peak.acceleration_m_s2);
                found.limit = Some(FootingLimit {
                    overturns: Threshold::new(overturns, stack.gravity_m_s2(), way),
                    rigid_m_s2: (force_n * edge - spent) / lever,
                });
                found.footing = Some(standing);
            }
            Err(FootingFalls::Turns { stiffness_n_m_rad }) => {
                found.standing = Standing::SoilTurns {
                    stiffness_n_m_rad,
                    least_n_m_rad: falls_n_m,
                };
            }
            Err(FootingFalls::Pushed {
                moment_n_m,
                bears_n_m,
            }) => {
                found.standing = Standing::SoilOverturns {
                    moment_n_m,
                    bears_n_m,
                }
            }
        }
        found
    }

    /// Whether the stack stands on its soil.
    pub(crate) fn stands(&self) -> bool {
        self.standing.stands()
    }

    /// What the soil leaves of the push that overturns the footing on rigid ground; 1 on rigid ground.
    pub(crate) fn factor(&self) -> f64 {
        self.limit.map_or(1.0, |limit| limit.factor())
    }

    /// Resistances of the footing itself against overturning, in directions around the plan.
    pub(super) fn resists(&self) -> Vec<Resistance> {
        self.footing.as_ref().map_or(Vec::new(), StandingFooting::resists)
    }

    /// The limit of a part on the soil, from that on rigid ground; `of_loads` is the moment of its static loads per radian.
    pub(super) fn half_plane(&self, rigid: HalfPlane, of_loads: [f64; 2]) -> HalfPlane {
        let Some(footing) = &self.footing else {
            return rigid;
        };
        let length = rigid.lever[0].hypot(rigid.lever[1]);
        if length <= 0.0 {
            return rigid;
        }
        HalfPlane {
            reserve: footing.reached(rigid.lever, of_loads, rigid.reserve) * length,
            ..rigid
        }
    }

    /// The half plane of the footing itself, in the direction in which it overturns first.
    pub(super) fn overturns(&self, mass: f64) -> Option<HalfPlane> {
        let Threshold {
            acceleration_m_s2,
            direction,
            ..
        } = self.limit?.overturns;
        Some(HalfPlane {
            lever: direction.map(|part| part * mass),
            reserve: acceleration_m_s2 * mass,
        })
    }

    /// The acceleration on the soil of one on rigid ground, in its direction. Static loads count where they turn the footing, not where they turn
    /// parts above: see [`with_turned_loads`](Self::with_turned_loads).
    pub(crate) fn threshold(&self, rigid: &Threshold) -> Threshold {
        match &self.footing {
            None => *rigid,
            Some(footing) => Threshold::new(
                footing.reached(rigid.direction, [0.0; 2], rigid.acceleration_m_s2),
                self.gravity_m_s2,
                rigid.direction,
            ),
        }
    }

    /// An acceleration over gravity on rigid ground, on the soil in the direction of a threshold; over gravity.
    pub(crate) fn over_gravity(&self, rigid_g: f64, like: &Threshold) -> f64 {
        let rigid = Threshold::new(rigid_g * self.gravity_m_s2, self.gravity_m_s2, like.direction);
        self.threshold(&rigid).acceleration_g
    }

    /// The loads with the horizontal parts that the vertical static loads of the stack have on a footing turned by `way` at an acceleration;
    /// `None` on rigid ground.
    pub(crate) fn with_turned_loads(
        &self,
        stack: &Stack,
        loads: &StackLoads,
        at: &Threshold,
    ) -> Option<StackLoads> {
        let turn = self.footing.as_ref()?.turn(at.direction, at.acceleration_m_s2)?;
        let mut turned = loads.clone();
        for load in stack.static_loads() {
            turned.forces.push(PointForce {
                block: load.block,
                position_m: Some(load.position_m),
                force_n: [-load.force_n[2] * turn[0], -load.force_n[2] * turn[1], 0.0],
            });
        }
        Some(turned)
    }
}

/// Rotation of the footing of a stack under loads without shaking: 0 on rigid ground; `None` if the footing does not stand.
///
/// # Errors
/// [`StabilityError`] for loads out of their range.
pub(crate) fn turned_at_rest(stack: &Stack, loads: &StackLoads) -> Result<Option<[f64; 2]>, StabilityError> {
    let on_blocks = loads.on_blocks(stack)?;
    let effective = stack.gravity_m_s2() + loads.vertical_acceleration_m_s2;
    let all: Vec<usize> = (0..on_blocks.len()).collect();
    let Some(footing) = footing(stack, &together(&on_blocks, &all), effective) else {
        return Ok(Some([0.0; 2]));
    };
    let [x, y] = footing.pushed;
    let moment = x.hypot(y);
    Ok(match StandingFooting::of(footing, effective) {
        Err(_) => None,
        Ok(_) if moment <= 0.0 => Some([0.0; 2]),
        Ok(standing) => standing.turn([x / moment, y / moment], 0.0),
    })
}

/// The footing of a stack on soil; `None` on rigid ground, and if nothing presses it.
fn footing(stack: &Stack, whole: &Load, effective_m_s2: f64) -> Option<Footing> {
    let below = stack.soil()?;
    let joint = stack.joints().iter().find(|joint| joint.lower == Body::Ground)?;
    let axes = joint.axes.map(DVec3::from);
    let middle = joint.patch.moments().centroid_m;
    let origin = DVec3::from(joint.origin_m) + axes[0] * middle[0] + axes[1] * middle[1];
    let corners = joint.patch.corners_m.iter().map(|[x, y]| {
        let at = axes[0] * (x - middle[0]) + axes[1] * (y - middle[1]);
        [at.x, at.y]
    });
    let patch = Polygon {
        corners_m: corners.collect(),
    };
    let force_n = whole.mass * effective_m_s2 + whole.pressed_n;
    if force_n <= 0.0 {
        return None;
    }
    let first = whole.first * effective_m_s2 + whole.pressed_first;
    let [xx, yy, xy] = patch.moments().second_m4;
    let stiffest = (0.5 * (xx + yy) + (0.5 * (xx - yy)).hypot(xy)) * below.normal_stiffness_pa_m;
    Some(Footing {
        middle_m: origin.into(),
        stiffness_pa_m: below.normal_stiffness_pa_m,
        strength_pa: joint.material.compressive_strength_pa,
        force_n,
        falls_n_m: (first.z - force_n * origin.z).max(FALLS_LEAST * stiffest),
        lever_kg_m: whole.first.z - whole.mass * origin.z,
        settled: [first.x - force_n * origin.x, first.y - force_n * origin.y],
        pushed: [
            whole.static_moment.y - origin.z * whole.force.x,
            -whole.static_moment.x - origin.z * whole.force.y,
        ],
        patch,
    })
}
