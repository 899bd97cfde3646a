//! Loads on a stack in addition to its weight, summed block by block.

use crate::stability::StabilityError;
use crate::structure::stack::{Block, Stack, StaticLoad};
use glam::DVec3;

/// Loads before horizontal shaking, in addition to those of the stack itself ([`Stack::static_loads`]).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StackLoads {
    /// Vertical acceleration of the ground, m/s², positive upwards, above −g: multiplies all weights by 1 + a_z/g.
    /// Default 0.
    pub vertical_acceleration_m_s2: f64,
    /// Static lateral load as an acceleration of every mass, m/s². Default none.
    pub lateral_m_s2: [f64; 2],
    /// Forces on single blocks. Default none.
    pub forces: Vec<PointForce>,
    /// Wind. Default none.
    pub wind: Option<Wind>,
}

/// A static force on one block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointForce {
    /// Index of the block.
    pub block: usize,
    /// Point of application, m; `None` for the block's centroid.
    pub position_m: Option<[f64; 3]>,
    /// Force, N.
    pub force_n: [f64; 3],
}

/// A steady wind on every block; blocks do not shelter each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wind {
    /// Net pressure on the projected area, windward and leeward side together (dynamic pressure × force coefficient),
    /// Pa, ≥ 0.
    pub pressure_pa: f64,
    /// Direction of the wind, of any length above 0.
    pub direction: [f64; 2],
}

/// Sum of the loads on a group of blocks, without horizontal shaking.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Load {
    pub(super) mass: f64,
    /// Mass × centroid, kg m.
    pub(super) first: DVec3,
    pub(super) force: DVec3,
    /// Moment about the origin, N m.
    pub(super) moment: DVec3,
    /// Moment about the origin of the horizontal static loads alone, N m. It rotates the stack on the soil from its
    /// settled position.
    pub(super) static_moment: DVec3,
    /// Sum of the vertical static loads, downwards, N.
    pub(super) pressed_n: f64,
    /// The same × point of application, N m.
    pub(super) pressed_first: DVec3,
}

impl Load {
    fn add(&mut self, other: &Load) {
        self.mass += other.mass;
        self.first += other.first;
        self.force += other.force;
        self.moment += other.moment;
        self.static_moment += other.static_moment;
        self.pressed_n += other.pressed_n;
        self.pressed_first += other.pressed_first;
    }

    fn push(&mut self, at: DVec3, force: DVec3) {
        self.force += force;
        self.moment += at.cross(force);
        self.static_moment += (DVec3::Z * at.z).cross(force.with_z(0.0));
        self.pressed_n -= force.z;
        self.pressed_first -= at * force.z;
    }

    pub(super) fn centroid(&self) -> DVec3 {
        self.first / self.mass
    }
}

/// Loads by static forces alone, without the weight of the blocks.
pub(super) fn without_weight(count: usize, forces: &[StaticLoad]) -> Vec<Load> {
    let mut loads = vec![Load::default(); count];
    push_all(&mut loads, forces);
    loads
}

pub(super) fn push_all(loads: &mut [Load], forces: &[StaticLoad]) {
    for of in forces {
        if let Some(load) = loads.get_mut(of.block) {
            load.push(of.position_m.into(), of.force_n.into());
        }
    }
}

pub(super) fn together(loads: &[Load], blocks: &[usize]) -> Load {
    let mut sum = Load::default();
    for &block in blocks {
        sum.add(&loads[block]);
    }
    sum
}

impl StackLoads {
    pub(super) fn on_blocks(&self, stack: &Stack) -> Result<Vec<Load>, StabilityError> {
        let mut loads = self.on_bare_blocks(stack)?;
        push_all(&mut loads, stack.static_loads());
        Ok(loads)
    }

    /// Loads on each block, without those of the stack itself.
    fn on_bare_blocks(&self, stack: &Stack) -> Result<Vec<Load>, StabilityError> {
        let gravity = stack.gravity_m_s2();
        let vertical = self.vertical_acceleration_m_s2;
        if !(vertical > -gravity && vertical.is_finite()) {
            return Err(StabilityError::VerticalAcceleration {
                given: vertical,
                gravity_m_s2: gravity,
            });
        }
        finite("lateral_m_s2", &self.lateral_m_s2)?;
        let mut loads: Vec<Load> = Vec::with_capacity(stack.blocks().len());
        for block in stack.blocks() {
            let (mass, centroid) = (block.mass_kg(), DVec3::from(block.solid.centroid_m()));
            let mut load = Load {
                mass,
                first: centroid * mass,
                ..Load::default()
            };
            let weight = DVec3::Z * (-mass * (gravity + vertical));
            load.force += weight;
            load.moment += centroid.cross(weight);
            let [x, y] = self.lateral_m_s2;
            load.push(centroid, DVec3::new(x, y, 0.0) * mass);
            if let Some(wind) = &self.wind {
                let (at, force) = wind.on(block)?;
                load.push(at, force);
            }
            loads.push(load);
        }
        for force in &self.forces {
            let count = loads.len();
            let Some(load) = loads.get_mut(force.block) else {
                return Err(StabilityError::Block {
                    quantity: "forces",
                    given: force.block,
                    count,
                });
            };
            finite("force_n", &force.force_n)?;
            let centroid = stack.blocks()[force.block].solid.centroid_m();
            let at = force.position_m.unwrap_or(centroid);
            finite("position_m of a force", &at)?;
            load.push(at.into(), force.force_n.into());
        }
        Ok(loads)
    }
}

impl Wind {
    /// Point of application and force of the wind on a block.
    fn on(&self, block: &Block) -> Result<(DVec3, DVec3), StabilityError> {
        if !(self.pressure_pa >= 0.0 && self.pressure_pa.is_finite()) {
            return Err(StabilityError::Option {
                option: "pressure_pa of the wind",
                given: self.pressure_pa,
                allowed: "0 or a positive number",
            });
        }
        let length = self.direction[0].hypot(self.direction[1]);
        if !(length > 0.0 && length.is_finite()) {
            return Err(StabilityError::Direction {
                quantity: "direction of the wind",
                given: self.direction,
            });
        }
        let along = DVec3::new(self.direction[0], self.direction[1], 0.0) / length;
        let at = |i: usize| DVec3::from(block.solid.vertices_m()[i]);
        // projected area: the triangles of windward faces, each projected on a plane across the wind
        let (mut area, mut first) = (0.0, DVec3::ZERO);
        for face in block.solid.faces() {
            for k in 1..face.len().saturating_sub(1) {
                let [a, b, c] = [at(face[0]), at(face[k]), at(face[k + 1])];
                let shadow = -0.5 * (b - a).cross(c - a).dot(along);
                if shadow > 0.0 {
                    area += shadow;
                    first += (a + b + c) * (shadow / 3.0);
                }
            }
        }
        let middle = if area > 0.0 {
            first / area
        } else {
            block.solid.centroid_m().into()
        };
        Ok((middle, along * (self.pressure_pa * area)))
    }
}

fn finite(quantity: &'static str, given: &[f64]) -> Result<(), StabilityError> {
    for &value in given {
        if !value.is_finite() {
            return Err(StabilityError::Option {
                option: quantity,
                given: value,
                allowed: "finite numbers",
            });
        }
    }
    Ok(())
}
