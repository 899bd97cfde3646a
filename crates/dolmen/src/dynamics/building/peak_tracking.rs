//! Processes each block of steps: largest values, and histories if requested.
//!
//! A block has one column for each row of the outputs, with consecutive values in time, so that the processor handles several steps at once.

use super::stepping::BLOCK;
use super::vibrating::VibratingBuilding;
use dolmen_linalg::Matrix;
use pulp::Arch;

/// Values of each storey, in this order: u, v, θ, drift of the centre along x and y, twist, drift along x of the front and the back edge, along
/// y of the left and the right edge.
pub(super) const TRACKED: usize = 10;

/// Largest values at steps: each with its sign, and the step.
pub(super) type SignedPeaks = Vec<(f64, usize)>;

/// Smallest and largest y and x of a floor from its centre of mass.
pub(super) struct FloorExtent {
    pub(super) is_known: bool,
    x: [f64; 2],
    y: [f64; 2],
    /// Its corners; only the centre of mass if they are unknown.
    pub(super) corners: Vec<[f64; 2]>,
    /// The centre of mass from that of the floor below.
    from_below: [f64; 2],
}

pub(super) fn floor_extents(building: &VibratingBuilding) -> Vec<FloorExtent> {
    let floors = building.building().floors();
    let each = floors.iter().enumerate().map(|(i, floor)| {
        let corners: Vec<[f64; 2]> = match &floor.outline {
            Some(outline) => outline
                .corners_m()
                .iter()
                .map(|corner| [0, 1].map(|axis| corner[axis] - floor.centre_m[axis]))
                .collect(),
            None => vec![[0.0; 2]],
        };
        let extent = |axis: usize| {
            corners
                .iter()
                .map(|corner| corner[axis])
                .fold([0.0_f64; 2], |[least, most], from| {
                    [least.min(from), most.max(from)]
                })
        };
        let below = if i > 0 {
            floors[i - 1].centre_m
        } else {
            floor.centre_m
        };
        FloorExtent {
            is_known: floor.outline.is_some(),
            x: extent(0),
            y: extent(1),
            from_below: [floor.centre_m[0] - below[0], floor.centre_m[1] - below[1]],
            corners,
        }
    });
    each.collect()
}

/// Coefficients of u, v, θ of a storey's floor and of the floor below for one of the tracked values.
pub(super) fn factors(value: usize, extent: &FloorExtent) -> [[f64; 3]; 2] {
    let unit = |k: usize| [0, 1, 2].map(|i| f64::from(i == k));
    let own = [0, 1, 2].map(|k| storey_values(unit(k), [0.0; 3], extent)[value]);
    let below = [0, 1, 2].map(|k| storey_values([0.0; 3], unit(k), extent)[value]);
    [own, below]
}

fn storey_values([u, v, theta]: [f64; 3], below: [f64; 3], extent: &FloorExtent) -> [f64; TRACKED] {
    let twist = theta - below[2];
    // the floor below at the centre of the floor above
    let drift_x = u - (below[0] - extent.from_below[1] * below[2]);
    let drift_y = v - (below[1] + extent.from_below[0] * below[2]);
    [
        u,
        v,
        theta,
        drift_x,
        drift_y,
        twist,
        drift_x - extent.y[0] * twist,
        drift_x - extent.y[1] * twist,
        drift_y + extent.x[0] * twist,
        drift_y + extent.x[1] * twist,
    ]
}

/// The longest drift of a corner at a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct LongestDrift {
    pub(super) drift: [f64; 2],
    pub(super) step: usize,
}

impl LongestDrift {
    pub(super) fn squared(&self) -> f64 {
        self.drift.iter().map(|along| along * along).sum()
    }
}

/// The largest of each value so far.
pub(super) struct PeakTracker<'a> {
    floor_extents: &'a [FloorExtent],
    largest: SignedPeaks,
    /// For each corner of each floor.
    longest: Vec<Vec<LongestDrift>>,
    drifts: Box<Drifts>,
}

/// The values of one storey in a block after u, v, θ, each in time.
struct Drifts([[f64; BLOCK]; TRACKED - 3]);

impl Drifts {
    /// As [`storey_values`], for all steps of a block at once.
    #[inline(always)]
    fn of_storey(&mut self, own: [&[f64; BLOCK]; 3], below: [&[f64; BLOCK]; 3], extent: &FloorExtent) {
        let [u, v, theta] = own;
        let [u_below, v_below, theta_below] = below;
        let [drift_x, drift_y, twist, front, back, left, right] = &mut self.0;
        let [from_x, from_y] = extent.from_below;
        for t in 0..BLOCK {
            twist[t] = theta[t] - theta_below[t];
            drift_x[t] = u[t] - (u_below[t] - from_y * theta_below[t]);
            drift_y[t] = v[t] - (v_below[t] + from_x * theta_below[t]);
        }
        let [[y_low, y_high], [x_low, x_high]] = [extent.y, extent.x];
        for t in 0..BLOCK {
            front[t] = drift_x[t] - y_low * twist[t];
            back[t] = drift_x[t] - y_high * twist[t];
            left[t] = drift_y[t] + x_low * twist[t];
            right[t] = drift_y[t] + x_high * twist[t];
        }
    }

    /// The drift of a corner as a vector.
    #[inline(always)]
    fn look_at_corner(
        &self,
        longest: &mut LongestDrift,
        [from_x, from_y]: [f64; 2],
        (first, now): (usize, usize),
    ) {
        let [drift_x, drift_y, twist, ..] = &self.0;
        let (mut most, mut at) = (longest.squared(), None);
        for t in 0..now {
            let (x, y) = (drift_x[t] - from_y * twist[t], drift_y[t] + from_x * twist[t]);
            let squared = x * x + y * y;
            if squared > most {
                most = squared;
                at = Some((t, [x, y]));
            }
        }
        if let Some((t, drift)) = at {
            *longest = LongestDrift {
                drift,
                step: first + t,
            };
        }
    }
}

impl<'a> PeakTracker<'a> {
    /// Starts with `count` values in addition to those of the storeys.
    pub(super) fn new(floor_extents: &'a [FloorExtent], count: usize) -> Self {
        PeakTracker {
            floor_extents,
            largest: vec![(0.0, 0); TRACKED * floor_extents.len() + count],
            longest: floor_extents
                .iter()
                .map(|extent| vec![LongestDrift::default(); extent.corners.len()])
                .collect(),
            drifts: Box::new(Drifts([[0.0; BLOCK]; TRACKED - 3])),
        }
    }

    /// Processes the storeys in the steps from `first` on: `block` has one column for u, v, θ of each floor.
    pub(super) fn storeys(&mut self, block: &Matrix, steps: (usize, usize)) {
        Arch::new().dispatch(
            #[inline(always)]
            || self.storeys_of(block, steps),
        );
    }

    #[inline(always)]
    fn storeys_of(&mut self, block: &Matrix, (first, now): (usize, usize)) {
        let still = [0.0; BLOCK];
        let mut below = [&still; 3];
        for (i, extent) in self.floor_extents.iter().enumerate() {
            let own = [0, 1, 2].map(|k| block.column(3 * i + k).first_chunk().unwrap_or(&still));
            self.drifts.of_storey(own, below, extent);
            let found = &mut self.largest[TRACKED * i..TRACKED * (i + 1)];
            let mut sizes = [0.0; TRACKED];
            let values = own.into_iter().chain(&self.drifts.0);
            for ((found, size), values) in found.iter_mut().zip(&mut sizes).zip(values) {
                *size = take(found, &values[..now], first);
            }
            let [.., front, back, left, right] = sizes;
            let (x, y) = (front.max(back), left.max(right));
            for (longest, corner) in self.longest[i].iter_mut().zip(&extent.corners) {
                // no corner moves farther than both edges together
                if x * x + y * y > longest.squared() {
                    self.drifts.look_at_corner(longest, *corner, (first, now));
                }
            }
            below = own;
        }
    }

    /// Processes another value in the steps from `first` on, the `which`-th after those of the storeys.
    pub(super) fn other(&mut self, which: usize, values: &[f64], first: usize) {
        let of_storeys = TRACKED * self.floor_extents.len();
        take(&mut self.largest[of_storeys + which], values, first);
    }

    /// Largest values, and the longest drift of each corner of each storey.
    pub(super) fn found(self) -> (SignedPeaks, Vec<Vec<LongestDrift>>) {
        (self.largest, self.longest)
    }
}

/// Updates the largest values, keeping the first of equal ones. Returns the largest magnitude.
#[inline(always)]
fn take(found: &mut (f64, usize), values: &[f64], first: usize) -> f64 {
    const LANES: usize = 8;
    let mut most = [0.0_f64; LANES];
    let chunks = values.chunks_exact(LANES);
    let rest = chunks.remainder();
    for chunk in chunks {
        for (most, value) in most.iter_mut().zip(chunk) {
            let size = value.abs();
            *most = if size > *most { size } else { *most };
        }
    }
    let most = most
        .into_iter()
        .chain(rest.iter().map(|value| value.abs()))
        .fold(0.0, f64::max);
    if most > found.0.abs() {
        let step = values.iter().position(|value| value.abs() == most).unwrap_or(0);
        *found = (values[step], first + step);
    }
    most
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_a_block_of_a_storey_is_its_values_step_by_step() {
        let extent = FloorExtent {
            is_known: true,
            x: [-1.5, 2.5],
            y: [-3.5, 4.5],
            from_below: [0.25, -0.75],
            corners: vec![[-1.5, -3.5], [2.5, 4.5]],
        };
        let wave = |phase: f64| std::array::from_fn(|t| (0.1 * t as f64 + phase).sin());
        let all: [[f64; BLOCK]; 6] = [0.1, 0.7, 1.3, 2.1, 2.9, 3.4].map(wave);
        let [u, v, theta, below @ ..] = &all;
        let mut drifts = Drifts([[0.0; BLOCK]; TRACKED - 3]);
        drifts.of_storey([u, v, theta], [&below[0], &below[1], &below[2]], &extent);
        for t in 0..BLOCK {
            let values = storey_values([u[t], v[t], theta[t]], below.map(|of| of[t]), &extent);
            for (k, value) in values[3..].iter().enumerate() {
                assert!((drifts.0[k][t] - value).abs() < 1e-15, "{k} at {t}");
            }
        }
    }

    #[test]
    fn holds_the_first_of_the_largest_values_is_kept() {
        let mut found = (0.0, 0);
        let mut values = vec![0.5; 19];
        (values[3], values[11], values[18]) = (-2.0, 2.0, 1.0);
        take(&mut found, &values, 100);
        assert_eq!(found, (-2.0, 103));
        take(&mut found, &[2.0, -1.0], 119); // equal magnitude: the first stays
        assert_eq!(found, (-2.0, 103));
        take(&mut found, &[0.0, 0.0, 3.0], 121); // in the remainder
        assert_eq!(found, (3.0, 123));
    }
}
