//! The stack: blocks in contact at joints, checked once.

use super::beds::{BED_GAP_M, bed, check_used, gap_allowed_m, rounded};
use super::overlap::overlap_depth;
use super::{Body, Joint, JointMaterial, Sliver, SoilBelow, Solid, StackError, StaticLoad, SupportMovement};
use glam::DVec3;

/// Largest distance of ties and side supports from the bounds of their blocks, m. Our choice: clamps are on the outside of stones.
const PIECE_REACH_M: f64 = 0.1;

/// Least vertical component of the normal of a joint that a block lies on; on a steeper joint it leans. Our choice.
const RISE_LEAST: f64 = 0.05;

/// One stone.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Name, unique in its stack.
    pub name: String,
    /// Shape and position: x right, y away, z up from the ground, m.
    pub solid: Solid,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

impl Block {
    /// Mass, kg.
    pub fn mass_kg(&self) -> f64 {
        self.density_kg_m3 * self.solid.volume_m3()
    }
}

/// A dowel or clamp: a small spring with a strength between two bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tie {
    /// One body.
    pub lower: Body,
    /// The other.
    pub upper: usize,
    /// Point where it crosses the joint, m.
    pub position_m: [f64; 3],
    /// Axis: [0, 0, 1] for a vertical dowel; of any length. It is taken to point from the lower to the upper body.
    pub axis: [f64; 3],
    /// Stiffness along the axis, N/m; 0 for a dowel that can slip out.
    pub axial_stiffness_n_m: f64,
    /// Stiffness across the axis, N/m.
    pub shear_stiffness_n_m: f64,
    /// Tension at which the tie breaks, N.
    pub tension_strength_n: f64,
    /// Shear at which the tie breaks, N.
    pub shear_strength_n: f64,
}

/// A support beside a block, with a gap: unilateral, without friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SideSupport {
    /// The block.
    pub block: usize,
    /// Contact point of the block at rest, m.
    pub position_m: [f64; 3],
    /// Direction in which the block must move to reach the support; of any length.
    pub direction: [f64; 3],
    /// Distance to the support, m.
    pub gap_m: f64,
    /// Stiffness in contact, N/m.
    pub stiffness_n_m: f64,
}

/// Blocks on the ground, with joints between them; construction checks that it is valid.
#[derive(Clone, Debug, PartialEq)]
pub struct Stack {
    pub(super) blocks: Vec<Block>,
    pub(super) joints: Vec<Joint>,
    ties: Vec<Tie>,
    side_supports: Vec<SideSupport>,
    pub(super) support_movements: Vec<SupportMovement>,
    pub(super) static_loads: Vec<StaticLoad>,
    pub(super) soil: Option<SoilBelow>,
    /// Contact material of loose stones; `None` for stones with joints.
    pub(super) loose: Option<JointMaterial>,
    pub(super) slivers_left_out: Vec<Sliver>,
    gravity_m_s2: f64,
}

impl Stack {
    /// Finds the joints between blocks in their positions, and refuses an invalid stack.
    ///
    /// # Errors
    /// [`StackError`] for no blocks, names that repeat, density, gravity or material out of range, blocks that overlap by
    /// more than [`BED_GAP_M`], touch on several facets of a bed that is not flat, on the rounded face of a scan or where one is hollow, and blocks that
    /// no joint carries.
    ///
    /// # Limits
    /// Contact is between convex hulls. A joint in which the stone itself has less contact than the hulls is refused; give such a stone as several
    /// parts. Up to a tenth of the area within the outline may be empty, but springs and bonds use the full area. Two bodies share one joint, from
    /// the pair of faces with the largest common patch. Faces may differ from parallel by up to 5°.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};
    /// let stone = |name: &str, z: f64| -> Result<Block, Box<dyn std::error::Error>> {
    ///     let place = Placement { position_m: [0.0, 0.0, z], ..Placement::default() };
    ///     Ok(Block { name: name.into(), solid: Solid::cuboid(0.3, 0.2, 0.1)?.placed(&place), density_kg_m3: 2600.0 })
    /// };
    /// let stack = Stack::new(vec![stone("lower", 0.0)?, stone("upper", 0.1)?], JointMaterial::default(), 9.81)?;
    /// assert_eq!(stack.joints().len(), 2);
    /// assert!((stack.joints()[1].patch.moments().area_m2 - 0.06).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(blocks: Vec<Block>, material: JointMaterial, gravity_m_s2: f64) -> Result<Self, StackError> {
        let material = material.checked()?;
        check_values(&blocks, gravity_m_s2)?;
        let (mut joints, mut refused) = (Vec::new(), Vec::new());
        for (upper, block) in blocks.iter().enumerate() {
            if let Some(bed) = bed(None, &block.solid) {
                check_used(&bed, "the ground", &block.name)?;
                joints.push(bed.joint(Body::Ground, upper, material));
            } else {
                let sunk = -block.solid.bounds_m()[0][2];
                if sunk > BED_GAP_M {
                    return Err(match block.solid.rounded_below_m() {
                        Some(radius_m) => rounded(&block.name, "the ground", &block.name, radius_m),
                        None => overlap(&block.name, "the ground", sunk),
                    });
                }
            }
            for (lower, other) in blocks.iter().enumerate().take(upper) {
                if apart(&block.solid, &other.solid) {
                    continue;
                }
                if let Some(bed) = bed(Some(&other.solid), &block.solid) {
                    let used = check_used(&bed, &other.name, &block.name);
                    let joint = if bed.rises() > -RISE_LEAST {
                        bed.joint(Body::Block(lower), upper, material)
                    } else {
                        bed.turned().joint(Body::Block(upper), lower, material)
                    };
                    match used {
                        Err(why) if joint.is_sliver => refused.push((joint.lower, joint.upper, why)),
                        used => used?,
                    }
                    joints.push(joint);
                } else {
                    let depth = overlap_depth(&other.solid, &block.solid);
                    if depth > BED_GAP_M {
                        return Err(overlap(&block.name, &other.name, depth));
                    }
                }
            }
        }
        joints.sort_by_key(|joint| (joint.upper, joint.lower));
        let stack = Stack::bare(blocks, joints, gravity_m_s2)
            .without_joints_through_blocks()
            .without_slivers();
        // a sliver that is left out may be no bed at all
        let is_joint = |lower, upper| {
            let mut joints = stack.joints.iter();
            joints.any(|joint| (joint.lower, joint.upper) == (lower, upper))
        };
        if let Some((.., why)) = refused
            .into_iter()
            .find(|(lower, upper, _)| is_joint(*lower, *upper))
        {
            return Err(why);
        }
        stack.check_carried()?;
        Ok(stack)
    }

    /// Blocks with these joints, but without ties, supports and loads.
    pub(super) fn bare(blocks: Vec<Block>, joints: Vec<Joint>, gravity_m_s2: f64) -> Self {
        Stack {
            blocks,
            joints,
            ties: Vec::new(),
            side_supports: Vec::new(),
            support_movements: Vec::new(),
            static_loads: Vec::new(),
            soil: None,
            loose: None,
            slivers_left_out: Vec::new(),
            gravity_m_s2,
        }
    }

    /// The same stack with another material in one joint.
    ///
    /// # Errors
    /// [`StackError::NoJoint`], or [`StackError::Material`] for a value out of its range.
    pub fn with_material(mut self, joint: usize, material: JointMaterial) -> Result<Self, StackError> {
        let count = self.joints.len();
        let slot = self.joints.get_mut(joint);
        slot.ok_or(StackError::NoJoint { given: joint, count })?.material = material.checked()?;
        Ok(self)
    }

    /// The same stack with a dowel or clamp.
    ///
    /// # Errors
    /// [`StackError`] for a block that does not exist, a value out of its range, or a place farther than 0.1 m from the bounds of either block.
    pub fn with_tie(mut self, tie: Tie) -> Result<Self, StackError> {
        if let Body::Block(lower) = tie.lower {
            self.check_block(lower)?;
        }
        self.check_block(tie.upper)?;
        check_direction("axis of a tie", tie.axis)?;
        check_finite("position_m of a tie", tie.position_m)?;
        self.check_near("a tie", tie.position_m, (tie.upper, PIECE_REACH_M))?;
        if let Body::Block(lower) = tie.lower {
            self.check_near("a tie", tie.position_m, (lower, PIECE_REACH_M))?;
        }
        let not_negative = [
            ("axial_stiffness_n_m", tie.axial_stiffness_n_m),
            ("shear_stiffness_n_m", tie.shear_stiffness_n_m),
            ("tension_strength_n", tie.tension_strength_n),
            ("shear_strength_n", tie.shear_strength_n),
        ];
        for (quantity, given) in not_negative {
            // an infinite strength means that the tie never breaks
            if given.is_nan() || given < 0.0 || (quantity.ends_with("_n_m") && given.is_infinite()) {
                return Err(StackError::Dimension {
                    quantity,
                    given,
                    allowed: "0 or a positive number",
                });
            }
        }
        self.ties.push(self.oriented(tie));
        Ok(self)
    }

    /// Refuses a piece far from its block, because it would act with a lever arm that does not exist.
    pub(super) fn check_near(
        &self,
        piece: &'static str,
        position_m: [f64; 3],
        (block, reach_m): (usize, f64),
    ) -> Result<(), StackError> {
        let block = &self.blocks[block];
        let [low, high] = block.solid.bounds_m().map(DVec3::from);
        let at = DVec3::from(position_m);
        let beyond_m = (low - at).max(at - high).max(DVec3::ZERO).length();
        if beyond_m > reach_m {
            return Err(StackError::Far {
                piece,
                position_m,
                beyond_m,
                block: block.name.clone(),
                allowed_m: reach_m,
            });
        }
        Ok(())
    }

    /// The tie with its axis from the lower to the upper body.
    fn oriented(&self, tie: Tie) -> Tie {
        let upper = DVec3::from(self.blocks[tie.upper].solid.centroid_m());
        let lower = match tie.lower {
            Body::Ground => DVec3::from(tie.position_m) - DVec3::Z,
            Body::Block(block) => DVec3::from(self.blocks[block].solid.centroid_m()),
        };
        let sign = if DVec3::from(tie.axis).dot(upper - lower) < 0.0 {
            -1.0
        } else {
            1.0
        };
        Tie {
            axis: tie.axis.map(|component| sign * component),
            ..tie
        }
    }

    /// The stack with a support beside a block.
    ///
    /// # Errors
    /// [`StackError`] for a block that does not exist or a value out of its range.
    pub fn with_side_support(mut self, support: SideSupport) -> Result<Self, StackError> {
        self.check_block(support.block)?;
        check_direction("direction of a side support", support.direction)?;
        check_finite("position_m of a side support", support.position_m)?;
        self.check_near(
            "a side support",
            support.position_m,
            (support.block, PIECE_REACH_M),
        )?;
        for (quantity, given) in [("gap_m", support.gap_m), ("stiffness_n_m", support.stiffness_n_m)] {
            if !(given >= 0.0 && given.is_finite()) {
                return Err(StackError::Dimension {
                    quantity,
                    given,
                    allowed: "0 or a positive number",
                });
            }
        }
        self.side_supports.push(support);
        Ok(self)
    }

    /// The blocks, in the order given.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The joints, ordered by upper block, then by lower body with the ground first.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Dowels and clamps.
    pub fn ties(&self) -> &[Tie] {
        &self.ties
    }

    /// The stack without side supports.
    pub fn without_side_supports(mut self) -> Self {
        self.side_supports.clear();
        self
    }

    /// The side supports of blocks.
    pub fn side_supports(&self) -> &[SideSupport] {
        &self.side_supports
    }

    /// Acceleration of gravity, m/s².
    pub fn gravity_m_s2(&self) -> f64 {
        self.gravity_m_s2
    }

    /// Name of the block, or "ground".
    pub fn name(&self, body: Body) -> &str {
        match body {
            Body::Ground => "ground",
            Body::Block(block) => self.blocks.get(block).map_or("", |block| &block.name),
        }
    }

    /// Height of the highest corner, m.
    pub fn height_m(&self) -> f64 {
        let tops = self.blocks.iter().map(|block| block.solid.bounds_m()[1][2]);
        tops.fold(0.0, f64::max)
    }

    /// Mass of all blocks, kg.
    pub fn mass_kg(&self) -> f64 {
        self.blocks.iter().map(Block::mass_kg).sum()
    }

    pub(super) fn check_block(&self, given: usize) -> Result<(), StackError> {
        let last = self.blocks.len() - 1;
        if given > last {
            return Err(StackError::NoBlock { given, last });
        }
        Ok(())
    }

    /// Checks that every block is connected to the ground through joints, and lies on one joint or leans between several. Equilibrium decides later
    /// whether it is stable.
    pub(super) fn check_carried(&self) -> Result<(), StackError> {
        let leans: Vec<bool> = (0..self.blocks.len())
            .map(|block| {
                let own = |joint: &&Joint| joint.upper == block || joint.lower == Body::Block(block);
                self.joints.iter().filter(own).count() > 1
            })
            .collect();
        let mut carried = vec![false; self.blocks.len()];
        loop {
            let mut changed = false;
            for joint in &self.joints {
                let Body::Block(lower) = joint.lower else {
                    changed |= !std::mem::replace(&mut carried[joint.upper], true);
                    continue;
                };
                let on_it = carried[lower] && (joint.axes[2][2] >= RISE_LEAST || leans[joint.upper]);
                let beside_it = carried[joint.upper] && leans[lower];
                if on_it {
                    changed |= !std::mem::replace(&mut carried[joint.upper], true);
                }
                if beside_it {
                    changed |= !std::mem::replace(&mut carried[lower], true);
                }
            }
            if !changed {
                break;
            }
        }
        let bottom_m = |block: usize| self.blocks[block].solid.bounds_m()[0][2];
        let uncarried = (0..carried.len()).filter(|&block| !carried[block]);
        match uncarried.min_by(|&a, &b| bottom_m(a).total_cmp(&bottom_m(b))) {
            None => Ok(()),
            Some(lowest) => Err(self.uncarried(lowest, &carried)),
        }
    }
}

pub(super) fn overlap(first: &str, second: &str, depth_m: f64) -> StackError {
    StackError::Overlap {
        first: first.to_owned(),
        second: second.to_owned(),
        depth_m,
        allowed_m: BED_GAP_M,
    }
}

/// Whether the bounding boxes of two solids are farther apart than the largest gap of a bed.
pub(super) fn apart(a: &Solid, b: &Solid) -> bool {
    let gap_m = gap_allowed_m(a).max(gap_allowed_m(b));
    let (a, b) = (a.bounds_m(), b.bounds_m());
    (0..3).any(|axis| a[0][axis] > b[1][axis] + gap_m || b[0][axis] > a[1][axis] + gap_m)
}

fn check_direction(quantity: &'static str, given: [f64; 3]) -> Result<(), StackError> {
    let vector = DVec3::from(given);
    if vector.is_finite() && vector.length() > 0.0 {
        return Ok(());
    }
    Err(StackError::Direction { quantity, given })
}

fn check_finite(quantity: &'static str, given: [f64; 3]) -> Result<(), StackError> {
    if given.iter().all(|value| value.is_finite()) {
        return Ok(());
    }
    Err(StackError::Position { quantity, given })
}

pub(super) fn check_values(blocks: &[Block], gravity_m_s2: f64) -> Result<(), StackError> {
    if blocks.is_empty() {
        return Err(StackError::Empty);
    }
    let not_positive = |part: &str, quantity, given: f64| {
        Err(StackError::NotPositive {
            part: part.to_owned(),
            quantity,
            given,
        })
    };
    if !(gravity_m_s2 > 0.0 && gravity_m_s2.is_finite()) {
        return not_positive("the stack", "gravity_m_s2", gravity_m_s2);
    }
    let mut names = std::collections::BTreeSet::new();
    for block in blocks {
        if !names.insert(&block.name) {
            return Err(StackError::Name {
                name: block.name.clone(),
            });
        }
        if !(block.density_kg_m3 > 0.0 && block.density_kg_m3.is_finite()) {
            return not_positive(
                &format!("block '{}'", block.name),
                "density_kg_m3",
                block.density_kg_m3,
            );
        }
    }
    Ok(())
}
