//! Impacts of the rigid law: located in time, then resolved.

use super::patch::LANES;
use super::rigid_faces::{Face, velocity};
use super::rigid_point::{ForceTorque, Part, Point};
use super::rigid_run::{FOUND_M, Ground, IMPACT_FROM, Run, Unsolved, halves, six};
use super::rigid_solve::Inertia;
use glam::DVec3;

/// Impacts closer together than this fraction of a step are one impact. Our choice.
const SAME_TIME: f64 = 0.01;
/// Largest number of halvings of a rebound until the impact creates no energy; after them there is no rebound.
const REBOUNDS_MOST: usize = 6;
/// Relative energy below which it counts as zero. Our choice.
const ROUNDING: f64 = 1e-9;
/// Tolerance of the restitution of a rocking joint, relative to the closing velocity, and largest number of trial solutions. Our choice.
const KEPT_TO: f64 = 1e-6;
const BRAKES_MOST: usize = 6;
/// Largest couple in the search, relative to the first estimate. The estimate is for the stone alone; mass on its edge makes the couple up to about
/// ten times as large. Our choice.
const COUPLE_MOST: f64 = 100.0;

/// Largest number of false-position steps for an impact.
const FIND_MOST: usize = 30;

/// A joint in which a stone rocks from edge to edge, and the velocity that remains at the middle of the contact, m/s.
struct Rocking {
    face: usize,
    at: [f64; 2],
    keeps_m_s: f64,
}

impl Run {
    /// Time of the first impact in the remaining step, by the method of false position (Illinois).
    pub(super) fn first_meeting(&self, left_s: f64) -> f64 {
        let least_gap = |part_s: f64| {
            let bodies = self.drifted(part_s);
            let mut least = f64::INFINITY;
            for ((_, patch, _, _), face) in self.assembly.contacts().zip(&self.faces) {
                let motion = patch.motion(&bodies);
                for point in face.points.iter().filter(|point| point.part == Part::Away) {
                    let (group, lane) = (&patch.points[point.index / LANES], point.index % LANES);
                    least = least.min(patch.place(group, lane, &motion).z);
                }
            }
            least
        };
        let (mut low, mut high) = (0.0, left_s);
        let (mut at_low, mut at_high) = (least_gap(low), least_gap(high));
        if at_high > -FOUND_M {
            return left_s;
        }
        for _ in 0..FIND_MOST {
            let middle = low + (high - low) * at_low / (at_low - at_high);
            let gap = least_gap(middle);
            if gap.abs() <= FOUND_M {
                return middle;
            }
            if gap > 0.0 {
                (low, at_low) = (middle, gap);
                at_high *= 0.5;
            } else {
                (high, at_high) = (middle, gap);
                at_low *= 0.5;
            }
        }
        low
    }

    /// Advances the stack to an impact after `part_s`, and resolves the impact.
    pub(super) fn strike(&mut self, time_s: f64, part_s: f64, ground: Ground<'_>) -> Result<(), Unsolved> {
        let there = self.drifted(part_s);
        for (body, there) in self.assembly.bodies.iter_mut().zip(&there).skip(1) {
            (body.position, body.turn, body.rotation) = (there.position, there.turn, there.rotation);
            body.travel = there.travel;
        }
        // up to the impact, only points that were in contact before it are active
        let parts = |face: &Face| face.points.iter().map(|point| point.part).collect();
        let parts_before: Vec<Vec<Part>> = self.faces.iter().map(parts).collect();
        self.see_faces(self.h, 0.0);
        for (face, parts) in self.faces.iter_mut().zip(&parts_before) {
            for (point, part) in face.points.iter_mut().zip(parts) {
                point.part = *part;
                point.offset = [0.0; 3];
            }
        }
        self.kick_over(time_s, self.lag_s + part_s, 0.0, ground)?;
        self.note_forces();
        self.commit();
        self.lag_s = 0.0;
        self.evidence.impacts += 1;
        self.see_faces(self.h, SAME_TIME * self.h);
        self.kick_s = 0.0;
        self.pull = DVec3::ZERO;
        self.shaking = DVec3::ZERO;
        self.inertia.clear();
        for (index, body) in self.assembly.bodies.iter().enumerate() {
            self.inertia.push(Inertia {
                mass: body.mass,
                turning: body.inertia_after(0.0),
                radius: body.radius,
            });
            self.momentum[index] = six(body.velocity * body.mass, body.momentum);
            self.velocity[index] = six(body.velocity, body.spin);
        }
        (self.momentum[0], self.velocity[0]) = ([0.0; 6], [0.0; 6]);
        self.hold_ground();
        let slow = IMPACT_FROM * self.assembly.gravity * self.h;
        let mut rocking = Vec::new();
        for (index, (face, parts)) in self.faces.iter_mut().zip(&parts_before).enumerate() {
            let before = face.ahead;
            for point in &mut face.points {
                point.offset = [0.0; 3];
            }
            if face
                .points
                .iter()
                .zip(parts)
                .any(|(point, before)| point.part != *before)
            {
                self.memory[face.pair].known = false;
            }
            let passes_on = parts.contains(&Part::Near);
            let of = match passes_on {
                true => face.restitution.rocks,
                false => Some(face.restitution.falls).filter(|of| *of > 0.0),
            };
            let rebound = of.and_then(|of| face.rebound(&before, slow, of));
            // a joint whose middle opens does not rock
            let passes_on = |(_, keeps_m_s): &([f64; 2], f64)| passes_on && *keeps_m_s > 0.0;
            if let Some((at, keeps_m_s)) = rebound.filter(passes_on) {
                let face = index;
                rocking.push(Rocking { face, at, keeps_m_s });
            }
        }
        let before = self.kinetic(&self.velocity);
        let start = self.velocity.clone();
        for _ in 0..REBOUNDS_MOST {
            self.solve()?;
            if self.kinetic(&self.velocity) <= before * (1.0 + ROUNDING) {
                break;
            }
            // an impact on several stones would create energy: reduce the rebound
            self.velocity.clone_from(&start);
            for face in &mut self.faces {
                face.rebound_less();
            }
        }
        for of in &rocking {
            self.brake(of)?;
        }
        self.acceleration.fill(DVec3::ZERO);
        self.commit();
        Ok(())
    }

    /// Reduces the velocity of a joint after an impact at its edge according to its restitution. A couple against the rotation makes the velocity at
    /// the middle of the contact `keeps_m_s`. Velocities are linear in the couple while the same points are active, so a secant method finds it.
    fn brake(&mut self, of: &Rocking) -> Result<(), Unsolved> {
        let opening = |run: &Run| {
            let twist = run.faces[of.face].twist_of(&run.velocity);
            (velocity(&twist, of.at[0], of.at[1])[2], twist)
        };
        let (mut now, twist) = opening(self);
        if now <= of.keeps_m_s * (1.0 + KEPT_TO) {
            return Ok(());
        }
        let face = &self.faces[of.face];
        let (plane_body, point_body) = (face.plane_body, face.point_body);
        let spin = face.to_ground * DVec3::new(twist[3], twist[4], 0.0);
        let turns = [plane_body, point_body].map(|body| {
            let inertia = self.inertia.get(body).filter(|_| body > 0);
            inertia.map_or(f64::INFINITY, |of| of.turning.mul_vec3(spin).length())
        });
        let mut couple = spin.normalize_or_zero() * turns[0].min(turns[1]) * (1.0 - of.keeps_m_s / now);
        let most = COUPLE_MOST * couple.length();
        for _ in 0..BRAKES_MOST {
            let is_done = (now - of.keeps_m_s).abs() <= KEPT_TO * of.keeps_m_s;
            // no couple reaches the target, because other points support the stone
            if is_done || couple.is_nan() || couple.length() > most {
                break;
            }
            for (body, sign) in [(plane_body, 1.0), (point_body, -1.0)] {
                if body > 0 {
                    let (linear, turning) = halves(&self.momentum[body]);
                    self.momentum[body] = six(linear, turning + sign * couple);
                }
            }
            self.solve()?;
            let (next, _) = opening(self);
            couple *= (next - of.keeps_m_s) / (now - next);
            now = next;
        }
        Ok(())
    }

    /// Kinetic energy at velocities of the bodies, J.
    fn kinetic(&self, velocity: &[ForceTorque]) -> f64 {
        let stones = self.inertia.iter().take(self.assembly.stones().end);
        let each = stones.zip(velocity).map(|(of, velocity)| {
            let (v, w) = halves(velocity);
            0.5 * (of.mass * v.length_squared() + w.dot(of.turning * w))
        });
        each.sum()
    }
}

impl Face {
    /// Adds the rebound of an impact: the mean normal velocity of the contact points becomes at least −e times its value before. The impulse acts
    /// uniformly on these points, that is at their middle. `None` if no contact closes fast enough for an impact.
    fn rebound(&mut self, before: &ForceTorque, slow: f64, restitution: f64) -> Option<([f64; 2], f64)> {
        let (mut area, mut at) = (0.0, [0.0; 2]);
        let (mut fastest, mut friction) = (0.0_f64, f64::INFINITY);
        for point in self.points.iter().filter(|point| point.part == Part::Near) {
            area += point.area;
            at[0] += point.area * point.x;
            at[1] += point.area * point.y;
            fastest = fastest.max(-velocity(before, point.x, point.y)[2]);
            friction = friction.min(point.friction);
        }
        if area <= 0.0 || fastest <= slow {
            return None;
        }
        let at = at.map(|moment| moment / area);
        let keeps_m_s = -restitution * velocity(before, at[0], at[1])[2];
        self.points.push(Point {
            friction,
            gap_ahead: keeps_m_s, // to detect when only a little of it remains
            offset: [0.0, 0.0, -keeps_m_s],
            part: Part::Near,
            index: usize::MAX,
            ..Point::at(at, area)
        });
        Some((at, keeps_m_s))
    }

    /// Halves the rebound; removes it when it is negligible.
    fn rebound_less(&mut self) {
        const LEAST: f64 = 0.1;
        for point in &mut self.points {
            point.held = [0.0; 3];
            if point.index == usize::MAX {
                let left = point.offset[2] * 0.5;
                let gone = left.abs() < LEAST * point.gap_ahead;
                point.offset[2] = if gone { 0.0 } else { left };
            }
        }
    }
}
