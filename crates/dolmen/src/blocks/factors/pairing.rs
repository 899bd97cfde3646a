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
use std::ops::Range;

/// Smallest MAC of a shape with its mode. Our choice: if joints are several times softer than drawn, the MAC is still larger.
const ALIKE_LEAST: f64 = 0.6;
/// Smallest difference between the MAC with this mode and the MAC with any other mode. Our choice.
const FAVOUR_LEAST: f64 = 0.1;
/// Computed modes with frequencies this close are one group, as for equal posts: any combination of them is a mode, and rounding chooses their shapes.
const ONE_FREQUENCY: f64 = 0.01;
/// Fraction of the largest displacement at the points of a shape below which the rest is rounding.
const ROUNDING: f64 = 1e-6;
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
    /// MAC of its shape with the modes of that frequency; `None` without a shape.
    pub(super) assurance: Option<f64>,
}

struct Computed {
    family: usize,
    order: usize,
    frequency_hz: f64,
    displacements: Vec<f64>,
}

/// Pairs measured modes with the modes of the stack with these factors on its springs.
///
/// A shape with two or more points identifies the mode if it is similar to one computed mode and clearly less similar to the others. Modes of one
/// frequency count as one, and are compared by all that they span:
///
/// ```text
/// MAC = Σ_k (q_k · u)²/u²,   q_k: an orthonormal basis of their displacements at the points of u
/// ```
/// Without such a shape, modes are counted from the lowest of their motion. For the second and later modes the frequency must agree:
/// multiplied by the ratio of the lowest modes, the frequency of the counted mode must be the nearest one.
pub(super) fn pair(
    stack: &Stack,
    mass: &Matrix,
    families: &[Family],
    (measured, assumed): (&[MeasuredStackMode], &Assumed),
    factors: &[f64],
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
        let computed = computed(stack, (mass, families), motion, factors)?;
        let mut counting = Counting::default();
        for one in own {
            let shape = Shape::of(stack, one);
            let measured_hz = one.mode.frequency_hz;
            match counting.next(&computed, measured_hz, shape.as_ref()) {
                Ok((number, by)) => {
                    let at = &computed[number];
                    // modes of one frequency that the points tell apart: the shape is that of any combination
                    let group = group_of(&computed, number);
                    let floor = shape.as_ref().map_or(0.0, |shape| shape.floor(&computed));
                    let assurance = shape
                        .as_ref()
                        .map(|shape| shape.assurance(&computed[group.clone()], floor));
                    let shape = shape.map(|shape| (shape.basis(&computed[group], floor).len(), shape));
                    let shape = shape.filter(|(span, _)| *span <= 1);
                    pairing.data.push(Datum {
                        motion,
                        family: at.family,
                        which: which(&families[at.family], at, motion, factors)?,
                        frequency_hz: measured_hz,
                        relative_sd: match one.mode.frequency_sd_hz {
                            0.0 => assumed.frequency_sd,
                            sd => sd / measured_hz,
                        },
                        shape: shape.map(|(_, shape)| shape.data(&families[at.family], assumed)),
                    });
                    pairing.paired.push(Paired {
                        number,
                        by,
                        is_sd_assumed: one.mode.frequency_sd_hz == 0.0,
                        drawn_hz: drawn_hz(&families[at.family], at),
                        assurance,
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
fn which(
    family: &Family,
    at: &Computed,
    motion: StackMotion,
    factors: &[f64],
) -> Result<ModeOfFamily, LinalgError> {
    let modes = family.modes(factors)?;
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

/// Frequency of a mode with the springs as drawn, Hz.
fn drawn_hz(family: &Family, at: &Computed) -> f64 {
    let square = family.square_of(&vec![1.0; family.groups.len()], at.order);
    square.map_or(at.frequency_hz, |square| square.max(0.0).sqrt() / TAU)
}

/// Computed modes of a motion with these factors, ascending.
fn computed(
    stack: &Stack,
    (mass, families): (&Matrix, &[Family]),
    motion: StackMotion,
    factors: &[f64],
) -> Result<Vec<Computed>, LinalgError> {
    let mut all = Vec::new();
    for (at, family) in families.iter().enumerate() {
        let modes = family.modes(factors)?;
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
        let groups = groups(computed);
        let groups: Vec<Range<usize>> = groups.into_iter().filter(|of| of.start < COMPARED_MOST).collect();
        let floor = shape.floor(computed);
        let compared = groups
            .iter()
            .map(|of| (of.clone(), shape.assurance(&computed[of.clone()], floor)));
        let mut alike: Vec<(Range<usize>, f64)> = compared.collect();
        alike.sort_by(|a, b| b.1.total_cmp(&a.1));
        let Some((group, assurance)) = alike.first().cloned() else {
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
            let is_alike =
                |(at, of): &(Range<usize>, f64)| at.contains(&counted) && assurance - of < FAVOUR_LEAST;
            return match alike.iter().any(is_alike) {
                true => Ok((counted, by)),
                false => Err(WhyUnused::ShapesAlike {
                    assurance: [assurance, second],
                }),
            };
        }
        match group.start.max(self.next) {
            number if number < group.end => Ok((number, PairedBy::Shape)),
            _ => Err(WhyUnused::ShapeTaken { assurance }),
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

/// Groups of modes of one frequency, ascending.
fn groups(computed: &[Computed]) -> Vec<Range<usize>> {
    let mut all: Vec<Range<usize>> = Vec::new();
    for (at, mode) in computed.iter().enumerate() {
        match all.last_mut() {
            Some(last) if mode.frequency_hz <= computed[last.start].frequency_hz * (1.0 + ONE_FREQUENCY) => {
                last.end = at + 1;
            }
            _ => all.push(at..at + 1),
        }
    }
    all
}

/// The group of a mode.
fn group_of(computed: &[Computed], number: usize) -> Range<usize> {
    let mut all = groups(computed).into_iter();
    all.find(|of| of.contains(&number)).unwrap_or(number..number + 1)
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

    /// Displacements of a computed mode at the points.
    fn points_of(&self, mode: &Computed) -> Vec<f64> {
        self.rows
            .iter()
            .map(|row| product(row, &mode.displacements))
            .collect()
    }

    /// Length of displacements at the points below which they are rounding.
    fn floor(&self, computed: &[Computed]) -> f64 {
        let lengths = computed.iter().map(|mode| {
            let moved = self.points_of(mode);
            product(&moved, &moved).sqrt()
        });
        ROUNDING * lengths.fold(0.0, f64::max)
    }

    /// An orthonormal basis of what modes span at the points; without modes that do not move them.
    fn basis(&self, modes: &[Computed], floor: f64) -> Vec<Vec<f64>> {
        let mut basis: Vec<Vec<f64>> = Vec::new();
        for mode in modes {
            let mut rest = self.points_of(mode);
            // twice: the first leaves a rounding of the whole
            for _ in 0..2 {
                for of in &basis {
                    let along = product(of, &rest);
                    for (rest, of) in rest.iter_mut().zip(of) {
                        *rest -= along * of;
                    }
                }
            }
            let length = product(&rest, &rest).sqrt();
            if length > floor {
                basis.push(rest.iter().map(|rest| rest / length).collect());
            }
        }
        basis
    }

    /// MAC with the span of modes; 0 if they span all motions of the points, to which any shape is similar.
    fn assurance(&self, modes: &[Computed], floor: f64) -> f64 {
        let measured: Vec<f64> = self.points.iter().map(|point| point.displacement).collect();
        let basis = self.basis(modes, floor);
        if basis.len() > 1 && basis.len() >= measured.len() {
            return 0.0;
        }
        let along = basis.iter().map(|of| product(of, &measured).powi(2));
        along.sum::<f64>() / product(&measured, &measured)
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Three modes of one frequency of four equal posts, each post a point of the shape, between modes of the whole; the first two of them turned.
    fn posts(angle: f64) -> Vec<Computed> {
        let apart = [
            [1.0, 1.0, -1.0, -1.0],
            [1.0, -1.0, -1.0, 1.0],
            [1.0, -1.0, 1.0, -1.0],
        ];
        let mode = |frequency_hz: f64, displacements: Vec<f64>| Computed {
            family: 0,
            order: 0,
            frequency_hz,
            displacements,
        };
        let (sin, cos) = angle.sin_cos();
        let turned = |a: f64, b: f64| (0..4).map(move |at| a * apart[0][at] + b * apart[1][at]);
        vec![
            mode(5.0, vec![1.0, 1.0, 1.0, 1.0, 2.0]),
            mode(80.0, turned(cos, -sin).chain([0.0]).collect()),
            mode(80.0 * (1.0 + 1e-12), turned(sin, cos).chain([0.0]).collect()),
            mode(80.1, apart[2].into_iter().chain([0.0]).collect()),
            mode(95.0, vec![1.0, 1.0, 1.0, 1.0, -1.0]),
        ]
    }

    fn shape(displacements: [f64; 5]) -> Shape {
        let points = displacements.map(|displacement| ShapePoint {
            height_m: 1.0,
            displacement,
            displacement_sd: 0.0,
        });
        let row = |at: usize| (0..5).map(|of| f64::from(u8::from(of == at))).collect();
        Shape {
            points: points.to_vec(),
            rows: (0..5).map(row).collect(),
        }
    }

    #[test]
    fn holds_modes_of_one_frequency_are_compared_by_their_span_however_they_are_turned() {
        let measured = shape([1.0, 0.3, -1.0, -0.2, 0.05]);
        let mut alone = Vec::new();
        for angle in [0.0, 0.4, 0.9, 1.3, 2.2] {
            let computed = posts(angle);
            let floor = measured.floor(&computed);
            assert_eq!(groups(&computed), [0..1, 1..4, 4..5]);
            // u of the posts less its mean over u²: the posts apart from each other
            let squares = 1.0 + 0.09 + 1.0 + 0.04;
            let mean = (1.0 + 0.3 - 1.0 - 0.2) / 4.0;
            let exact = (squares - 4.0 * mean * mean) / (squares + 0.0025);
            let span = measured.assurance(&computed[1..4], floor);
            assert!((span - exact).abs() < 1e-12, "{angle} {span} {exact}");
            let mut counting = Counting::default();
            let found = counting.next(&computed, 81.0, Some(&measured));
            assert_eq!(found.unwrap().0, 1, "{angle}");
            // a second one takes the next mode of the group
            assert_eq!(counting.next(&computed, 81.5, Some(&measured)).unwrap().0, 2);
            alone.push(measured.assurance(&computed[1..2], floor));
        }
        // one by one the likeness depends on the turn
        let [least, most] = [f64::min, f64::max].map(|of| alone.iter().copied().fold(alone[0], of));
        assert!(most > 0.8 && least < 0.3, "{alone:?}");
    }

    #[test]
    fn holds_a_group_that_the_points_do_not_see_is_like_no_shape() {
        // posts in twos, whose mean is the only point: rounding is left of the group
        let mut computed = posts(0.7);
        for mode in &mut computed[1..4] {
            mode.displacements = mode.displacements.iter().map(|of| 1e-14 * of).collect();
        }
        let measured = shape([1.0, -1.0, 1.0, -1.0, 0.0]);
        let found = Counting::default().next(&computed, 81.0, Some(&measured));
        assert!(
            matches!(found, Err(WhyUnused::ShapeUnlike { assurance }) if assurance < 1e-12),
            "{found:?}"
        );
    }
}
