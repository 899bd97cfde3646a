//! The thrust line: the points where the resultant crosses each joint under a given acceleration.

use super::contact::{contact, names_below};
use super::cuts::cuts;
use super::loads::together;
use super::pressure::no_tension_pressure;
use super::{Cut, JointPressure, StackLoads};
use crate::stability::StabilityError;
use crate::structure::stack::Stack;
use glam::DVec3;

/// The resultant in one joint.
#[derive(Clone, Debug, PartialEq)]
pub struct ThrustPoint {
    /// The blocks above and the joints below them.
    pub cut: Cut,
    /// The bodies below, in words.
    pub above: String,
    /// Point where the resultant crosses the plane of the joint, m.
    pub point_m: [f64; 3],
    /// The point in the plane of the joint, relative to the origin of its largest patch, m.
    pub in_plane_m: [f64; 2],
    /// Distance from the nearest edge of the contact, m; negative outside, where the part above tips.
    pub depth_m: f64,
    /// Normal force on the joint, N.
    pub normal_force_n: f64,
    /// Shear force in the joint, N.
    pub shear_force_n: f64,
    /// Shear over normal force: the friction coefficient needed.
    pub friction_needed: f64,
    /// Pressure without tension; `None` if the resultant lies outside.
    pub pressure: Option<JointPressure>,
    /// Position of the resultant.
    pub place: ThrustPlace,
}

/// Position of the resultant in a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum ThrustPlace {
    /// In the kern: the whole joint is in contact.
    Kern,
    /// In the joint: a part of it is open.
    Inside,
    /// Outside, or without a normal force: no equilibrium.
    Outside,
}

/// The resultant in every joint under gravity, static loads and a horizontal acceleration, lowest joint first.
///
/// ```text
/// force on the part above, F = W (1 + a_z/g) + static + m x;   point r of the plane with (r × F) · e = M · e, e in the plane
/// ```
///
/// # Arguments
/// `acceleration_m_s2` is the acceleration of the inertia forces m x: opposite to that of the ground.
///
/// # Errors
/// [`StabilityError::Indeterminate`] for a stack where blocks share their load; values out of range.
///
/// # Limits
/// Ties, bond and side supports carry no force.
///
/// # Example
/// ```
/// use dolmen::stability::stack::{thrust_line, StackLoads, ThrustPlace};
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
/// let block = Block { name: "stone".into(), solid: Solid::cuboid(0.4, 0.4, 2.0)?, density_kg_m3: 2600.0 };
/// let stack = Stack::new(vec![block], JointMaterial::default(), 9.81)?;
/// let line = thrust_line(&stack, &StackLoads::default(), [0.15 * 9.81, 0.0])?;
/// assert!((line[0].point_m[0] - 0.15).abs() < 1e-12);
/// assert_eq!(line[0].place, ThrustPlace::Inside);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn thrust_line(
    stack: &Stack,
    static_loads: &StackLoads,
    acceleration_m_s2: [f64; 2],
) -> Result<Vec<ThrustPoint>, StabilityError> {
    let mut with_shaking = static_loads.clone();
    for (sum, x) in with_shaking.lateral_m_s2.iter_mut().zip(acceleration_m_s2) {
        *sum += x;
    }
    let loads = with_shaking.on_blocks(stack)?;
    let found = cuts(stack);
    if !found.statically_determinate {
        return Err(StabilityError::Indeterminate);
    }
    let mut line = Vec::with_capacity(found.cuts.len());
    for cut in found.cuts {
        let load = together(&loads, &cut.blocks);
        let contact = contact(stack, &cut);
        let normal_force = -load.force.dot(contact.axes[2]);
        let shear = (load.force + contact.axes[2] * normal_force).length();
        let about: DVec3 = load.moment - contact.origin.cross(load.force);
        let at = [
            about.dot(contact.axes[1]) / normal_force,
            -about.dot(contact.axes[0]) / normal_force,
        ];
        let pressure = if normal_force > 0.0 {
            no_tension_pressure(&contact.patches, normal_force, at)?
        } else {
            None
        };
        line.push(ThrustPoint {
            above: names_below(stack, &cut),
            point_m: contact.at(at).into(),
            in_plane_m: at,
            depth_m: contact.hull.depth_m(at),
            normal_force_n: normal_force,
            shear_force_n: shear,
            friction_needed: if normal_force > 0.0 {
                shear / normal_force
            } else {
                f64::INFINITY
            },
            place: match &pressure {
                None => ThrustPlace::Outside,
                Some(pressure) if pressure.contact_share >= 1.0 - 1e-9 => ThrustPlace::Kern,
                Some(_) => ThrustPlace::Inside,
            },
            pressure,
            cut,
        });
    }
    Ok(line)
}

#[cfg(test)]
mod tests {
    use super::super::towers::{P10, shifted, tower};
    use super::super::{StackLimits, stack_limits};
    use super::*;

    #[test]
    fn exact_at_the_threshold_the_line_reaches_the_edge_of_one_joint() {
        let stack = tower(&P10, 0.6);
        let first = stack_limits(&stack, &StackLimits::default())
            .unwrap()
            .uplift
            .unwrap();
        let a = first.threshold.acceleration_m_s2;
        let x = first.threshold.direction.map(|d| d * a * (1.0 - 1e-6));
        let line = thrust_line(&stack, &StackLoads::default(), x).unwrap();
        for (i, point) in line.iter().enumerate() {
            assert!(
                point.depth_m > 0.0 && (i == first.cut) == (point.depth_m < 1e-5),
                "{i}"
            );
            assert!((point.friction_needed - a * (1.0 - 1e-6) / 9.81).abs() < 1e-12);
        }
        assert_eq!(line[first.cut].place, ThrustPlace::Inside);
        let x = first.threshold.direction.map(|d| d * a * 1.01);
        assert_eq!(
            thrust_line(&stack, &StackLoads::default(), x).unwrap()[first.cut].place,
            ThrustPlace::Outside
        );
    }

    #[test]
    fn exact_offset_stones_without_shaking() {
        let line = thrust_line(
            &shifted(&[(1.0, 0.5), (1.0, 1.0)], &[0.0, 0.3], 0.9),
            &StackLoads::default(),
            [0.0; 2],
        );
        let line = line.unwrap();
        // centroids at 0 and .3 with weights 1 : 2
        assert!((line[0].point_m[0] - 0.2).abs() < 1e-12 && line[0].place == ThrustPlace::Inside);
        assert!((line[0].pressure.as_ref().unwrap().contact_share - 0.9).abs() < 1e-9);
        // .7 wide from −.2 to .5 with its resultant at .3
        assert!((line[1].pressure.as_ref().unwrap().contact_share - 0.6 / 0.7).abs() < 1e-9);
    }
}
