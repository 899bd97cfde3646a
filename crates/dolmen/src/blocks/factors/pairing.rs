//! Pairs measured modes with computed modes.

use super::families::Family;
use super::measured::{Assumed, MeasuredStackMode};
use super::model::{Datum, ModeOfFamily, ShapeData, product};
use super::motions::{displacement_row, moves};
use super::result::{PairedBy, UnusedMode, WhyUnused};
use super::stack_motion::StackMotion;
use crate::structure::ShapePoint;
use crate::structure::stack::Stack;
use dolmen_linalg::{LinalgError, Matrix};
use std::f64::consts::TAU;

/// Smallest MAC of a shape with its mode. Our choice: if joints are several times softer than drawn, the MAC is still larger.
const ALIKE_LEAST: f64 = 0.6;
/// Smallest difference between the MAC with this mode and the MAC with any other mode. Our choice.
const FAVOUR_LEAST: f64 = 0.1;
/// Fraction of kinetic energy above which a mode with several motions clearly belongs to one of them. Our choice.
const CLEAR_LEAST: f64 = 0.75;
/// Largest number of modes of one motion that are compared with a shape. Our choice: higher modes of stacks have not been measured.
const COMPARED_MOST: usize = 8;

/// Data of the paired modes, the basis of each pairing, and the modes without a pair.
pub(super) struct Pairing {
    pub(super) data: Vec<Datum>,
    pub(super) paired: Vec<Paired>,
    pub(super) unused: Vec<UnusedMode>,
}

/// The pairing of a measured mode.
pub(super) struct Paired {
    /// Index among the computed modes of this motion, 0 the lowest.
    pub(super) number: usize,
    pub(super) by: PairedBy,
    pub(super) is_sd_assumed: bool,
    pub(super) drawn_hz: f64,
}

struct Computed {
    family: usize,
    order: usize,
    frequency_hz: f64,
    displacements: Vec<f64>,
}

/// Pairs measured modes with the modes of the stack with springs as drawn.
///
/// A shape with two or more points identifies the mode if it is similar to one computed mode and clearly less similar to the others.
/// Without such a shape, modes are counted from the lowest of their motion. For the second and later modes the frequency must agree:
/// multiplied by the ratio of the lowest modes, the frequency of the counted mode must be the nearest one.
pub(super) fn pair(
    stack: &Stack,
    mass: &Matrix,
    families: &[Family],
    measured: &[MeasuredStackMode],
    assumed: &Assumed,
) -> Result<Pairing, LinalgError> {
    let mut pairing = Pairing {
        data: Vec::new(),
        paired: Vec::new(),
        unused: Vec::new(),
    };
    for motion in [StackMotion::X, StackMotion::Y, StackMotion::Torsion] {
        let mut own: Vec<&MeasuredStackMode> = measured.iter().filter(|one| one.motion == motion).collect();
        own.sort_by(|a, b| a.mode.frequency_hz.total_cmp(&b.mode.frequency_hz));
        if own.is_empty() {
            continue;
        }
        let computed = computed(stack, mass, families, motion)?;
        let mut counting = Counting::default();
        for one in own {
            let shape = Shape::of(stack, one);
            let measured_hz = one.mode.frequency_hz;
            match counting.next(&computed, measured_hz, shape.as_ref()) {
                Ok((number, by)) => {
                    let at = &computed[number];
                    pairing.data.push(Datum {
                        motion,
                        family: at.family,
                        which: which(&families[at.family], at, motion)?,
                        frequency_hz: measured_hz,
                        relative_sd: match one.mode.frequency_sd_hz {
                            0.0 => assumed.frequency_sd,
                            sd => sd / measured_hz,
                        },
                        shape: shape.map(|shape| shape.data(&families[at.family], assumed)),
                    });
                    pairing.paired.push(Paired {
                        number,
                        by,
                        is_sd_assumed: one.mode.frequency_sd_hz == 0.0,
                        drawn_hz: at.frequency_hz,
                    });
                }
                Err(why) => pairing.unused.push(UnusedMode {
                    motion,
                    measured_hz,
                    why,
                }),
            }
        }
    }
    Ok(pairing)
}

/// Identifies the mode by its order in the family, unless the family also has modes of other motions and this mode clearly belongs to one
/// motion.
fn which(family: &Family, at: &Computed, motion: StackMotion) -> Result<ModeOfFamily, LinalgError> {
    let modes = family.modes(&vec![1.0; family.groups.len()])?;
    let others = [StackMotion::X, StackMotion::Y, StackMotion::Torsion];
    let has_others = others
        .into_iter()
        .any(|other| other != motion && !family.orders_of(&modes, other).is_empty());
    let is_clear = family.share(modes.vectors.column(at.order), motion) >= CLEAR_LEAST;
    let number = family
        .orders_of(&modes, motion)
        .iter()
        .position(|order| *order == at.order);
    Ok(match number {
        Some(number) if has_others && is_clear => ModeOfFamily::OfMotion(number),
        _ => ModeOfFamily::Order(at.order),
    })
}

/// Computed modes of a motion, ascending.
fn computed(
    stack: &Stack,
    mass: &Matrix,
    families: &[Family],
    motion: StackMotion,
) -> Result<Vec<Computed>, LinalgError> {
    let mut all = Vec::new();
    for (at, family) in families.iter().enumerate() {
        let drawn = vec![1.0; family.groups.len()];
        let modes = family.modes(&drawn)?;
        for (order, square) in modes.values.iter().enumerate() {
            let displacements = family.displacements(modes.vectors.column(order));
            if *square > 0.0 && moves(stack, mass, &displacements, motion) {
                all.push(Computed {
                    family: at,
                    order,
                    frequency_hz: square.sqrt() / TAU,
                    displacements,
                });
            }
        }
    }
    all.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    Ok(all)
}

/// Counting of the measured modes of one motion, from the lowest.
#[derive(Default)]
struct Counting {
    /// The number that follows the last paired mode.
    next: usize,
    /// ln(measured/computed) of the first paired mode.
    ratio: Option<f64>,
    has_gap: bool,
}

impl Counting {
    fn next(
        &mut self,
        computed: &[Computed],
        measured_hz: f64,
        shape: Option<&Shape>,
    ) -> Result<(usize, PairedBy), WhyUnused> {
        let found = match shape {
            Some(shape) => self.by_shape(computed, measured_hz, shape),
            None => self.by_order(computed, measured_hz),
        };
        match found {
            Ok((number, _)) => {
                self.next = number + 1;
                self.has_gap = false;
                let ratio = (measured_hz / computed[number].frequency_hz).ln();
                self.ratio.get_or_insert(ratio);
            }
            Err(_) => self.has_gap = true,
        }
        found
    }

    fn by_shape(
        &self,
        computed: &[Computed],
        measured_hz: f64,
        shape: &Shape,
    ) -> Result<(usize, PairedBy), WhyUnused> {
        let compared = computed.iter().take(COMPARED_MOST).enumerate();
        let mut alike: Vec<(usize, f64)> = compared.map(|(at, mode)| (at, shape.assurance(mode))).collect();
        alike.sort_by(|a, b| b.1.total_cmp(&a.1));
        let Some(&(number, assurance)) = alike.first() else {
            return Err(WhyUnused::TooMany { computed: 0 });
        };
        if assurance < ALIKE_LEAST {
            return Err(WhyUnused::ShapeUnlike { assurance });
        }
        let second = alike
            .get(1)
            .filter(|(_, second)| assurance - second < FAVOUR_LEAST);
        if let Some(&(_, second)) = second {
            // too few points: the mode is counted, if its shape is similar to that of the counted mode
            let (counted, by) = self.by_order(computed, measured_hz)?;
            let is_alike = |(at, of): &(usize, f64)| *at == counted && assurance - of < FAVOUR_LEAST;
            return match alike.iter().any(is_alike) {
                true => Ok((counted, by)),
                false => Err(WhyUnused::ShapesAlike {
                    assurance: [assurance, second],
                }),
            };
        }
        match number < self.next {
            true => Err(WhyUnused::ShapeTaken { assurance }),
            false => Ok((number, PairedBy::Shape)),
        }
    }

    fn by_order(&self, computed: &[Computed], measured_hz: f64) -> Result<(usize, PairedBy), WhyUnused> {
        if self.has_gap {
            return Err(WhyUnused::AfterUnused);
        }
        let Some(counted) = computed.get(self.next) else {
            return Err(WhyUnused::TooMany {
                computed: computed.len(),
            });
        };
        if let Some(ratio) = self.ratio {
            let away = |mode: &Computed| (measured_hz / mode.frequency_hz).ln() - ratio;
            let nearest = computed
                .iter()
                .min_by(|a, b| away(a).abs().total_cmp(&away(b).abs()));
            if let Some(nearest) = nearest.filter(|nearest| nearest.frequency_hz != counted.frequency_hz) {
                return Err(WhyUnused::BetweenModes {
                    counted_hz: counted.frequency_hz * ratio.exp(),
                    nearest_hz: nearest.frequency_hz * ratio.exp(),
                });
            }
        }
        Ok((self.next, PairedBy::Order))
    }
}

/// Measured points of a sway, and rows that give the same points of a computed mode.
struct Shape {
    points: Vec<ShapePoint>,
    rows: Vec<Vec<f64>>,
}

impl Shape {
    /// `None` for torsion and for fewer than two points, because the scale of a shape is free.
    fn of(stack: &Stack, one: &MeasuredStackMode) -> Option<Self> {
        let axis = one.motion.axis()?;
        let points: Vec<ShapePoint> = one.mode.shape.clone();
        let moved = points.iter().filter(|point| point.displacement != 0.0).count();
        let rows = points
            .iter()
            .map(|point| displacement_row(stack, point.height_m, axis))
            .collect();
        (points.len() >= 2 && moved > 0).then_some(Shape { points, rows })
    }

    fn assurance(&self, mode: &Computed) -> f64 {
        let computed: Vec<f64> = self
            .rows
            .iter()
            .map(|row| product(row, &mode.displacements))
            .collect();
        let measured: Vec<f64> = self.points.iter().map(|point| point.displacement).collect();
        assurance(&computed, &measured)
    }

    fn data(&self, family: &Family, assumed: &Assumed) -> ShapeData {
        let largest = self
            .points
            .iter()
            .fold(0.0_f64, |most, point| most.max(point.displacement.abs()));
        let size = family.basis.columns();
        ShapeData {
            rows: Matrix::from_fn(self.rows.len(), size, |i, j| {
                product(&self.rows[i], family.basis.column(j))
            }),
            displacement: self.points.iter().map(|point| point.displacement).collect(),
            sd: self
                .points
                .iter()
                .map(|point| match point.displacement_sd {
                    0.0 => assumed.shape_sd * largest,
                    sd => sd,
                })
                .collect(),
        }
    }
}

/// MAC of two shapes; 0 if one of them is zero.
pub(super) fn assurance(a: &[f64], b: &[f64]) -> f64 {
    let squares = product(a, a) * product(b, b);
    match squares > 0.0 {
        true => product(a, b).powi(2) / squares,
        false => 0.0,
    }
}
