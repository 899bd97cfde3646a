//! The two directions of a chain: the direction of motion, and across it.

use super::axis::ChainAxis;
use super::part::{ChainPart, JointPart, LinkPart};
use crate::loads::LoadsPart;
use crate::quantity::{Pick, Quantity};
use crate::soil::FootingPart;
use dolmen::assess::StiffnessTaken;
use dolmen::stability::BedEdge;
use dolmen::structure::{Chain, Inertia, Link, Soil, StructureError};

impl ChainPart {
    /// Whether the file gives any value across the direction of motion.
    pub fn has_two_axes(&self) -> bool {
        let of_link = |link: &LinkPart| link.depth.is_some() || link.inertia_across.is_some();
        let of_joint = |joint: &JointPart| joint.bed_depth.is_some() || joint.stiffness_across.is_some();
        let soil = self.soil.as_ref().map(|soil| &soil.footing);
        self.links.iter().any(of_link)
            || self.joints.iter().flatten().any(of_joint)
            || self.side_supports.iter().any(|of| of.axis.is_some())
            || matches!(soil, Some(FootingPart::Rectangle([along, across])) if along.value != across.value)
    }

    /// The direction for a name in a survey.
    pub fn axis_of(&self, direction: &str) -> ChainAxis {
        match self.has_two_axes() && direction == ChainAxis::Across.name() {
            true => ChainAxis::Across,
            false => ChainAxis::Along,
        }
    }

    /// The soil for motion in a direction; `None` if no soil is given.
    pub fn soil_towards(&self, axis: ChainAxis, pick: Pick<'_>) -> Option<Soil> {
        let along = self.soil.as_ref()?.build(pick);
        Some(match axis {
            ChainAxis::Along => along,
            ChainAxis::Across => along.across(),
        })
    }

    /// The directions in which it is judged.
    pub fn axes(&self) -> &'static [ChainAxis] {
        match self.has_two_axes() {
            true => &[ChainAxis::Along, ChainAxis::Across],
            false => &[ChainAxis::Along],
        }
    }

    /// The chain in the direction of motion, each input with the value that `pick` chooses (`&mut Quantity::nominal` for the file's own).
    ///
    /// # Errors
    /// As [`ChainPart::build_towards`].
    pub fn build(&self, pick: Pick<'_>) -> Result<Chain, StructureError> {
        self.build_towards(ChainAxis::Along, pick)
    }

    /// The chain in a direction.
    ///
    /// # Errors
    /// None with the file's own values, which are checked on reading. A picked value may be impossible, for
    /// instance a centroid above the link's top: [`StructureError`].
    pub fn build_towards(&self, axis: ChainAxis, pick: Pick<'_>) -> Result<Chain, StructureError> {
        self.build_loaded(axis, &LoadsPart::none(), pick)
    }

    /// The chain in a direction with the masses of its static loads, which its beds also bear.
    ///
    /// # Errors
    /// As [`ChainPart::build_towards`].
    pub fn build_loaded(
        &self,
        axis: ChainAxis,
        loads: &LoadsPart,
        pick: Pick<'_>,
    ) -> Result<Chain, StructureError> {
        let links = self.links.iter().enumerate().map(|(i, part)| Link {
            mass_kg: part.heaviness.mass_kg(self.gravity_m_s2, pick),
            length_m: pick(&part.length),
            centroid_m: pick(&part.centroid),
            inertia: part.inertia_towards(axis, pick),
            bed_width_m: self.bed_towards(axis, i, pick).map(|bed| bed.width_m),
        });
        let alone = Chain::new(links.collect(), self.gravity_m_s2)?;
        let loaded = alone.with_added_masses(&loads.added_masses(&alone, pick))?;
        let mut links: Vec<Link> = loaded.links().to_vec();
        self.take_crushed_beds(axis, &mut links, pick);
        let alone = Chain::new(links, self.gravity_m_s2)?;
        let held = self
            .side_supports
            .iter()
            .filter(|support| support.axis.unwrap_or(ChainAxis::Along) == axis);
        let supports = held.map(|support| support.build(pick));
        supports
            .collect::<Vec<_>>()
            .into_iter()
            .try_fold(alone, Chain::with_side_support)
    }

    /// Reduces the width of each bed that crushes by N/(f w): half of the remaining width times N is the moment of its stress block.
    fn take_crushed_beds(&self, axis: ChainAxis, links: &mut [Link], pick: Pick<'_>) {
        let mut normal_n = 0.0;
        let beds: Vec<Option<BedEdge>> = (0..links.len())
            .map(|i| self.bed_towards(axis, i, pick))
            .collect();
        for (link, bed) in links.iter_mut().zip(beds).rev() {
            normal_n += link.mass_kg * self.gravity_m_s2;
            if let Some(bed) = bed.filter(|bed| bed.strength_pa.is_some()) {
                link.bed_width_m = Some(2.0 * bed.moment_n_m(normal_n) / normal_n);
            }
        }
    }

    /// Whether the bed below a link crushes under the weight above it alone, with that of static loads; not with the values of the file.
    pub fn bed_crushes(&self, loads: &LoadsPart, pick: Pick<'_>) -> bool {
        let mut normal_n = 0.0;
        for (i, link) in self.links.iter().enumerate().rev() {
            normal_n += link.heaviness.mass_kg(self.gravity_m_s2, pick) * self.gravity_m_s2;
            let own = loads.loads.iter().filter(|load| load.part == i);
            normal_n += own
                .filter_map(|load| load.weight.as_ref())
                .map(&mut *pick)
                .sum::<f64>();
            let bed = self.bed(i, pick).filter(|bed| bed.strength_pa.is_some());
            if bed.is_some_and(|bed| bed.moment_n_m(normal_n) <= 0.0) {
                return true;
            }
        }
        false
    }

    /// The bed below a link, from 0 at the bottom, for motion in a direction; `None` where its width is not given.
    pub fn bed(&self, link: usize, pick: Pick<'_>) -> Option<BedEdge> {
        let part = self.links.get(link)?;
        let width_m = pick(part.bed_width.as_ref()?);
        let joint = self.joints.as_ref().and_then(|joints| joints.get(link));
        let given = joint.and_then(|joint| joint.bed_depth.as_ref());
        // without its own depth the bed has the proportions of the link on it
        let depth_m = match (given, &part.depth, &part.breadth) {
            (Some(given), ..) => Some(pick(given)),
            (None, Some(depth), Some(breadth)) => Some(width_m * pick(depth) / pick(breadth)),
            (None, Some(depth), None) => Some(pick(depth).min(width_m)),
            (None, None, _) => None,
        };
        let strength = joint.and_then(|joint| joint.strength.as_ref());
        Some(BedEdge {
            width_m,
            depth_m,
            strength_pa: strength.map(&mut *pick),
        })
    }

    fn bed_towards(&self, axis: ChainAxis, link: usize, pick: Pick<'_>) -> Option<BedEdge> {
        let bed = self.bed(link, pick)?;
        Some(match axis {
            ChainAxis::Along => bed,
            ChainAxis::Across => bed.across(),
        })
    }

    /// Stiffness of each joint in the direction of motion, N m/rad, lowest first, the soil in series with the lowest; `None` if the joints are
    /// unknown.
    pub fn stiffness_n_m_rad(&self, pick: Pick<'_>) -> Option<Vec<f64>> {
        self.stiffness_towards(ChainAxis::Along, pick)
    }

    /// The same in a direction.
    pub fn stiffness_towards(&self, axis: ChainAxis, pick: Pick<'_>) -> Option<Vec<f64>> {
        let mut stiffness = self.joints_alone(axis, pick)?;
        if let (Some(soil), Some(lowest)) = (self.soil_towards(axis, pick), stiffness.first_mut()) {
            *lowest = soil.in_series_n_m_rad(*lowest);
        }
        Some(stiffness)
    }

    /// The same without the soil.
    fn joints_alone(&self, axis: ChainAxis, pick: Pick<'_>) -> Option<Vec<f64>> {
        let joints = self.joints.as_ref()?;
        let each = joints.iter().enumerate().map(|(i, joint)| {
            let along = pick(&joint.stiffness);
            match (axis, &joint.stiffness_across) {
                (ChainAxis::Along, _) => along,
                (ChainAxis::Across, Some(given)) => pick(given),
                (ChainAxis::Across, None) => along * self.stiffness_ratio(i, pick),
            }
        });
        Some(each.collect())
    }

    /// Ratio of the stiffness across to that along where none is given: a bed of equal springs has (w/b)². At most 1: a bed that is longer
    /// across may be stiffer there, but this is not assumed.
    fn stiffness_ratio(&self, joint: usize, pick: Pick<'_>) -> f64 {
        let bed = self.bed(joint, pick);
        bed.map_or(1.0, |bed| bed.stiffness_ratio_across().min(1.0))
    }

    /// The joints whose stiffness across is not given.
    pub fn stiffness_taken(&self, pick: Pick<'_>) -> Vec<StiffnessTaken> {
        let across = self.joints_alone(ChainAxis::Across, pick).unwrap_or_default();
        let joints = self.joints.iter().flatten().zip(across).enumerate();
        let not_given = joints.filter(|(_, (joint, _))| joint.stiffness_across.is_none());
        let taken = not_given.map(|(i, (_, stiffness_n_m_rad))| StiffnessTaken {
            joint: i + 1,
            stiffness_n_m_rad,
            of_along: self.stiffness_ratio(i, pick),
        });
        match self.has_two_axes() {
            true => taken.collect(),
            false => Vec::new(),
        }
    }
}

impl LinkPart {
    fn inertia_towards(&self, axis: ChainAxis, pick: Pick<'_>) -> Inertia {
        let is_across = axis == ChainAxis::Across;
        let own = self.inertia_across.as_ref().filter(|_| is_across);
        let depth = self.depth.as_ref().filter(|_| is_across);
        let boxed = |breadth: &Quantity, pick: Pick<'_>| Inertia::Box {
            breadth_m: pick(breadth),
        };
        match (own, depth, &self.inertia, &self.breadth) {
            (Some(given), ..) => Inertia::Given(pick(given)),
            (None, Some(depth), ..) => boxed(depth, pick),
            (None, None, Some(given), _) => Inertia::Given(pick(given)),
            (None, None, None, Some(breadth)) => boxed(breadth, pick),
            (None, None, None, None) => Inertia::ThinRod,
        }
    }

    /// The breadth exposed to wind in a direction; `None` if no side is known.
    pub fn met_by_wind(&self, axis: ChainAxis, bed: Option<BedEdge>, pick: Pick<'_>) -> Option<f64> {
        let sides = match axis {
            ChainAxis::Along => [&self.depth, &self.breadth],
            ChainAxis::Across => [&self.breadth, &self.depth],
        };
        let side = sides.into_iter().flatten().next();
        let of_bed = bed.map(|bed| match axis {
            ChainAxis::Along => bed.depth_or_width_m(),
            ChainAxis::Across => bed.width_m,
        });
        side.map(pick).or(of_bed)
    }
}
