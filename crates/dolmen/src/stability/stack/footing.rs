//! A rigid footing on a bed of springs without tension: how far it turns under its loads, and where it overturns.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | k, f | `stiffness_pa_m`, `strength_pa` | pressure over settlement, largest pressure | Pa/m, Pa |
//! | N, M | `force_n`, `moment` | force on the bed, and its moment: N times the offset of the resultant from the middle of the bed | N, N m |
//! | θ, δ | `slope`, `turn` | slope of the footing, and its change since it settled under the vertical loads | rad |
//! | S | `falls_n_m` | moment that gravity adds per radian: Σ of each vertical force times its height | N m/rad |
//! | u, v | `way`, `across` | direction of the push, and the direction across it | – |
//! | q | `lever_kg_m` | moment of the push per unit of acceleration: Σ m h | kg m |

use super::toe::beyond;
use super::{LimitKind, Resistance};
use crate::structure::stack::Polygon;
use glam::DVec3;

/// Relative error of the force at which the settlement counts as found. Our choice.
const FORCE_OFF: f64 = 1e-14;
/// Largest number of iterations for the settlement, the slope across and the peak. Our choice: they need some ten.
const ITERATIONS_MOST: usize = 80;
/// Relative error of the moment across the push, over N times the size of the bed. Our choice.
const MOMENT_OFF: f64 = 1e-12;
/// Largest rotation across a push, over that along it. Our choice: on rigid ground a bed turns about an edge at up to 45° to the push.
const SIDEWAYS_MOST: f64 = 4.0;
/// Number of bisections for the rotation at which it overturns: 1e-9 of it, where the push is flat. Our choice.
const BISECTIONS: usize = 30;
/// Number of directions in the search for the worst one. Our choice: every 15°, halved four times beside the worst.
const DIRECTIONS: usize = 24;

/// A rigid footing with its loads, on springs without tension.
///
/// ```text
/// p = min(f, max(0, k (c + θ · r))),   ∫ p = N,   M(θ) = ∫ p r         r from the middle of the bed
/// equilibrium       M(θ_g + δ) = M_g + M_s + a q u + S δ               M_g of the vertical loads, M_s of the horizontal ones
/// overturns         at the greatest a on this path
/// rectangle b × l   M = K θ, K = k l b³/12                  while M ≤ N b/6
///                   M = N (b/2 − c/3), c = √(2 N/(k l θ))     beyond: the contact is c wide
///                   M − S θ ≤ N b/2 (1 − (S/K)^⅓)             reached at θ = N b/6 (K S²)^−⅓
/// ```
#[derive(Clone, Debug)]
pub(super) struct Footing {
    /// The bed in plan about its middle, m.
    pub(super) patch: Polygon,
    /// The middle of the bed, m.
    pub(super) middle_m: [f64; 3],
    pub(super) stiffness_pa_m: f64,
    pub(super) strength_pa: Option<f64>,
    pub(super) force_n: f64,
    pub(super) falls_n_m: f64,
    pub(super) lever_kg_m: f64,
    /// M_g, N m.
    pub(super) settled: [f64; 2],
    /// M_s, N m.
    pub(super) pushed: [f64; 2],
}

/// A state of equilibrium of a pushed footing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turned {
    /// δ.
    pub(super) turn: [f64; 2],
    /// a, m/s².
    pub(super) acceleration_m_s2: f64,
    /// da/dδ along the push, m/s² per rad.
    slope: f64,
}

/// Moment and tangent of a slope.
struct Bedding {
    moment: [f64; 2],
    /// k ∫ x², y², xy over the elastic part about its own centroid: ∂M/∂θ under a constant force.
    tangent: [f64; 3],
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn sum(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn scaled(a: [f64; 2], by: f64) -> [f64; 2] {
    [a[0] * by, a[1] * by]
}

/// A unit vector in plan.
fn way_of(degrees: f64) -> [f64; 2] {
    let [x, y] = [degrees.to_radians().cos(), degrees.to_radians().sin()];
    // directions along the axes without the rounding of the cosine
    [x, y].map(|part| if part.abs() < 1e-12 { 0.0 } else { part })
}

/// Along × tangent × other.
fn product(tangent: [f64; 3], a: [f64; 2], b: [f64; 2]) -> f64 {
    let [xx, yy, xy] = tangent;
    a[0] * (xx * b[0] + xy * b[1]) + a[1] * (xy * b[0] + yy * b[1])
}

/// Force, first moments and second moments of the pressure under a plane.
struct Pressed {
    force: f64,
    moment: [f64; 2],
    elastic: Polygon,
}

impl Footing {
    /// Pressure of the settlement c + θ · r.
    fn pressed(&self, settlement: f64, slope: [f64; 2]) -> Pressed {
        let steep = slope[0].hypot(slope[1]);
        let mut found = Pressed {
            force: 0.0,
            moment: [0.0; 2],
            elastic: Polygon::default(),
        };
        let limit = self.strength_pa.map(|strength| strength / self.stiffness_pa_m);
        if steep <= 0.0 {
            found.elastic = self.patch.clone();
        } else {
            let uphill = scaled(slope, 1.0 / steep);
            found.elastic = beyond(&self.patch, uphill, -settlement / steep);
            if let Some(limit) = limit {
                let from = (limit - settlement) / steep;
                let crushed = beyond(&found.elastic, uphill, from).moments();
                found.elastic = beyond(&found.elastic, scaled(uphill, -1.0), -from);
                found.force += crushed.area_m2 * limit;
                found.moment = scaled(crushed.centroid_m, crushed.area_m2 * limit);
            }
        }
        let part = found.elastic.moments();
        let mean = settlement + dot(slope, part.centroid_m);
        let [xx, yy, xy] = part.second_m4;
        found.force += part.area_m2 * mean;
        found.moment = sum(
            sum(found.moment, scaled(part.centroid_m, part.area_m2 * mean)),
            [xx * slope[0] + xy * slope[1], xy * slope[0] + yy * slope[1]],
        );
        found.force *= self.stiffness_pa_m;
        found.moment = scaled(found.moment, self.stiffness_pa_m);
        found
    }

    /// Moment and tangent at a slope under the force N; `None` if the bed cannot bear N.
    fn bedding(&self, slope: [f64; 2]) -> Option<Bedding> {
        let along = self.patch.corners_m.iter().map(|corner| dot(slope, *corner));
        let (least, most) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), at| {
            (least.min(at), most.max(at))
        });
        let area = self.patch.moments().area_m2;
        let mean = self.force_n / (self.stiffness_pa_m * area);
        // closed, and fully pressed or crushed: the force on the bed grows from 0 to more than N
        let (mut low, mut high) = (-most, mean - least);
        if let Some(strength) = self.strength_pa {
            if self.force_n >= strength * area {
                return None;
            }
            high = high.max(strength / self.stiffness_pa_m - least);
        }
        let mut at = mean.clamp(low, high);
        let mut found = self.pressed(at, slope);
        for _ in 0..ITERATIONS_MOST {
            let over = found.force - self.force_n;
            if over.abs() <= FORCE_OFF * self.force_n {
                break;
            }
            match over > 0.0 {
                true => high = at,
                false => low = at,
            }
            let stiffness = self.stiffness_pa_m * found.elastic.moments().area_m2;
            let newton = at - over / stiffness;
            let next = match newton > low && newton < high {
                true => newton,
                false => 0.5 * (low + high),
            };
            if next == at {
                break;
            }
            at = next;
            found = self.pressed(at, slope);
        }
        let tangent = found.elastic.moments().second_m4;
        Some(Bedding {
            moment: found.moment,
            tangent: tangent.map(|part| part * self.stiffness_pa_m),
        })
    }

    /// θ_g, the slope under the vertical loads alone; `None` if the bed does not bear them.
    fn at_rest(&self) -> Option<[f64; 2]> {
        let near = MOMENT_OFF * self.force_n * self.patch.size_m();
        let mut slope = [0.0; 2];
        let mut missing = f64::INFINITY;
        let mut step = [0.0; 2];
        for _ in 0..ITERATIONS_MOST {
            let bed = self.bedding(slope)?;
            let off = sum(self.settled, scaled(bed.moment, -1.0));
            let size = off[0].hypot(off[1]);
            if size <= near {
                return Some(slope);
            }
            if size >= missing {
                // beyond: half of the last step
                step = scaled(step, 0.5);
                slope = sum(slope, scaled(step, -1.0));
                continue;
            }
            missing = size;
            let [xx, yy, xy] = bed.tangent;
            let det = xx * yy - xy * xy;
            if det <= 0.0 {
                return None;
            }
            step = [
                (yy * off[0] - xy * off[1]) / det,
                (xx * off[1] - xy * off[0]) / det,
            ];
            slope = sum(slope, step);
        }
        None
    }

    /// The equilibrium with a given rotation along the push; `None` if it falls across.
    fn turned(&self, rest: [f64; 2], way: [f64; 2], along: f64) -> Option<Turned> {
        let across = [-way[1], way[0]];
        let near = MOMENT_OFF * self.force_n * self.patch.size_m();
        let given = sum(self.settled, self.pushed);
        // the moment across grows with the slope across: its sign says on which side the equilibrium lies
        let [xx, yy, _] = self.patch.moments().second_m4;
        let lifts = self.force_n * self.patch.size_m() / (self.stiffness_pa_m * xx.min(yy));
        let most = SIDEWAYS_MOST * along.abs() + lifts;
        let (mut low, mut high) = (-most, most);
        let mut sideways = 0.0;
        for _ in 0..ITERATIONS_MOST {
            let turn = sum(scaled(way, along), scaled(across, sideways));
            let bed = self.bedding(sum(rest, turn))?;
            let off = dot(bed.moment, across) - dot(given, across) - self.falls_n_m * sideways;
            let holds = product(bed.tangent, across, across) - self.falls_n_m;
            if off.abs() <= near {
                if holds <= 0.0 {
                    return None;
                }
                let coupled = product(bed.tangent, way, across);
                let slope = product(bed.tangent, way, way) - self.falls_n_m - coupled * coupled / holds;
                let left = dot(bed.moment, way) - dot(given, way) - self.falls_n_m * along;
                return Some(Turned {
                    turn,
                    acceleration_m_s2: left / self.lever_kg_m,
                    slope: slope / self.lever_kg_m,
                });
            }
            match off > 0.0 {
                true => high = sideways,
                false => low = sideways,
            }
            let newton = sideways - off / holds;
            sideways = match holds > 0.0 && newton > low && newton < high {
                true => newton,
                false => 0.5 * (low + high),
            };
        }
        None
    }

    /// Where it overturns under a push along a direction; `None` if it falls at rest.
    fn overturns(&self, rest: [f64; 2], way: [f64; 2]) -> Option<Turned> {
        let corners = self.patch.corners_m.iter().map(|corner| dot(*corner, way));
        let edge = corners.fold(f64::NEG_INFINITY, f64::max);
        // beyond this rotation gravity takes more than the bed bears at its edge
        let most = (self.force_n * edge - dot(self.settled, way)) / self.falls_n_m;
        if most.is_nan() || most <= 0.0 {
            return None;
        }
        let rises = |along: f64| {
            let found = self.turned(rest, way, along)?;
            (found.slope > 0.0).then_some(found)
        };
        let (mut low, mut high) = (most, most);
        let mut best = None;
        for _ in 0..ITERATIONS_MOST {
            (low, high) = (0.5 * low, low);
            best = rises(low);
            if best.is_some() {
                break;
            }
        }
        best?;
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            match rises(middle) {
                Some(found) => (low, best) = (middle, Some(found)),
                None => high = middle,
            }
        }
        best
    }
}

/// Why a footing does not stand without shaking.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FootingFalls {
    /// Gravity turns it further than the bed turns it back.
    Turns {
        /// Rocking stiffness of the bed in its softer direction, N m/rad.
        stiffness_n_m_rad: f64,
    },
    /// The horizontal loads overturn it.
    Pushed {
        /// Moment of the loads, N m.
        moment_n_m: f64,
        /// Largest moment that the bed balances, N m.
        bears_n_m: f64,
    },
}

/// A footing that stands, with its peaks by direction.
#[derive(Debug)]
pub(super) struct StandingFooting {
    footing: Footing,
    rest: [f64; 2],
    /// g + a_z, m/s².
    gravity_m_s2: f64,
    known: std::cell::RefCell<Vec<([f64; 2], Turned)>>,
}

impl StandingFooting {
    /// The footing, if it stands on its springs without shaking.
    pub(super) fn of(footing: Footing, gravity_m_s2: f64) -> Result<Self, FootingFalls> {
        let turns = |stiffness_n_m_rad| FootingFalls::Turns { stiffness_n_m_rad };
        let rest = footing.at_rest().ok_or(turns(0.0))?;
        let [xx, yy, xy] = footing.bedding(rest).ok_or(turns(0.0))?.tangent;
        // the smaller stiffness of the two principal directions
        let least = 0.5 * (xx + yy) - (0.5 * (xx - yy)).hypot(xy);
        if least <= footing.falls_n_m {
            return Err(turns(least));
        }
        let [x, y] = footing.pushed;
        let moment_n_m = x.hypot(y);
        if moment_n_m > 0.0 {
            let way = [x / moment_n_m, y / moment_n_m];
            let peak = footing.overturns(rest, way).ok_or(turns(least))?;
            let left_n_m = peak.acceleration_m_s2 * footing.lever_kg_m;
            if left_n_m <= 0.0 {
                return Err(FootingFalls::Pushed {
                    moment_n_m,
                    bears_n_m: moment_n_m + left_n_m,
                });
            }
        }
        Ok(StandingFooting {
            footing,
            rest,
            gravity_m_s2,
            known: std::cell::RefCell::default(),
        })
    }

    /// Where it overturns under a push along a unit vector.
    pub(super) fn overturns(&self, way: [f64; 2]) -> Option<Turned> {
        let is_same = |other: &[f64; 2]| (other[0] - way[0]).hypot(other[1] - way[1]) < 1e-13;
        if let Some((_, found)) = self.known.borrow().iter().find(|(other, _)| is_same(other)) {
            return Some(*found);
        }
        let found = self.footing.overturns(self.rest, way)?;
        self.known.borrow_mut().push((way, found));
        Some(found)
    }

    /// Its resistance against overturning in directions around the plan.
    ///
    /// ```text
    /// t · (M − p × F) ≤ a q         t horizontal across the push, p the middle of the bed; F, M of the push about the origin
    /// ```
    pub(super) fn resists(&self) -> Vec<Resistance> {
        let p = DVec3::from(self.footing.middle_m);
        let each = (0..DIRECTIONS).filter_map(|k| {
            let way = way_of(360.0 * k as f64 / DIRECTIONS as f64);
            let axis = DVec3::new(-way[1], way[0], 0.0);
            let peak = self.overturns(way)?;
            Some(Resistance {
                kind: LimitKind::Uplift,
                force: p.cross(axis).into(),
                moment: axis.into(),
                reserve: peak.acceleration_m_s2 * self.footing.lever_kg_m,
            })
        });
        each.collect()
    }

    /// The direction in which it overturns first.
    pub(super) fn worst(&self) -> [f64; 2] {
        let at = |degrees: f64| {
            let found = self.overturns(way_of(degrees));
            found.map_or(0.0, |found| found.acceleration_m_s2)
        };
        let mut step = 360.0 / DIRECTIONS as f64;
        let mut best = (0.0, at(0.0));
        let try_at = |degrees: f64, best: &mut (f64, f64)| {
            let found = at(degrees);
            // directions that are equal by symmetry differ by rounding
            if found < best.1 * (1.0 - 1e-9) {
                *best = (degrees, found);
            }
        };
        for k in 1..DIRECTIONS {
            try_at(step * k as f64, &mut best);
        }
        for _ in 0..4 {
            step *= 0.5;
            let middle = best.0;
            for degrees in [middle - step, middle + step] {
                try_at(degrees, &mut best);
            }
        }
        way_of(best.0)
    }

    /// The push along the lever at which a part reaches its limit on the turned footing, m/s²: at most that at which the footing overturns.
    ///
    /// ```text
    /// l · (a u + g δ) + l_P · δ = s       u along l; l, l_P moments of the masses, and of the static loads per radian
    /// ```
    pub(super) fn reached(&self, lever: [f64; 2], of_loads: [f64; 2], reserve: f64) -> f64 {
        let length = lever[0].hypot(lever[1]);
        let rigid = reserve / length;
        if !(length > 0.0 && rigid.is_finite()) {
            return rigid;
        }
        let way = scaled(lever, 1.0 / length);
        let Some(peak) = self.overturns(way) else {
            return 0.0;
        };
        let turns = sum(scaled(lever, self.gravity_m_s2), of_loads);
        let spent = |of: &Turned| length * of.acceleration_m_s2 + dot(turns, of.turn) - reserve;
        if spent(&peak) <= 0.0 {
            return peak.acceleration_m_s2;
        }
        // false position, with half the weight for an end that stays (Illinois)
        let high_at = dot(peak.turn, way);
        // without horizontal loads the push is 0 at no turn; loads against the push turn it back first
        let back = [0.0, -0.25, -0.5, -1.0].map(|share| share * high_at);
        let before = back.into_iter().find_map(|along| {
            let at = self.footing.turned(self.rest, way, along)?;
            (spent(&at) < 0.0).then_some((along, at))
        });
        let Some((mut low, first)) = before else {
            return 0.0;
        };
        let (mut high, mut below, mut above) = (high_at, spent(&first), spent(&peak));
        let mut found = first;
        for _ in 0..ITERATIONS_MOST {
            let middle = (low * above - high * below) / (above - below);
            let Some(at) = self.footing.turned(self.rest, way, middle) else {
                return 0.0;
            };
            found = at;
            let over = spent(&found);
            if over.abs() <= MOMENT_OFF * reserve.abs() || high - low <= 1e-15 * high_at {
                break;
            }
            match over > 0.0 {
                true => (high, above, below) = (middle, over, 0.5 * below),
                false => (low, below, above) = (middle, over, 0.5 * above),
            }
        }
        found.acceleration_m_s2
    }

    /// The rotation under a push of an acceleration along a unit vector; that at which it overturns, if the push is larger.
    pub(super) fn turn(&self, way: [f64; 2], acceleration_m_s2: f64) -> Option<[f64; 2]> {
        let peak = self.overturns(way)?;
        let high_at = dot(peak.turn, way);
        let (mut low, mut high) = (-high_at, high_at);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let found = self.footing.turned(self.rest, way, middle)?;
            match found.acceleration_m_s2 > acceleration_m_s2 {
                true => high = middle,
                false => low = middle,
            }
        }
        Some(self.footing.turned(self.rest, way, low)?.turn)
    }
}
