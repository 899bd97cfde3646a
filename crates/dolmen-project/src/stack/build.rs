//! From the stack of a project file to the stack of the library: the place of each block, and the properties of each joint.

use super::fault::StackFault;
use super::made_part::MadePart;
use super::part::{
    BedPart, BlockPart, ContactPart, OpeningPart, PagodaPart, PagodaSlendernessPart, PointsFrame, ShapePart,
    StackPart,
};
use super::surveyed_lean::Turn;
use super::top::Top;
use crate::loads::LoadPart;
use crate::quantity::{Pick, Quantity};
use dolmen::structure::stack::{
    Block, Body, Joint, JointMaterial, LostBed, Pagoda, PagodaFactors, PagodaSlenderness, Placement,
    SideSupport, Solid, Stack, StackError, StaticLoad, SupportMovement, Tie, pagoda, without_bed,
};

impl PointsFrame {
    /// A stone in its own coordinates, or unchanged.
    pub(super) fn of(self, solid: Solid) -> Solid {
        if self == PointsFrame::Site {
            return solid;
        }
        let [low, high] = solid.bounds_m();
        let to_base = Placement {
            position_m: [-0.5 * (low[0] + high[0]), -0.5 * (low[1] + high[1]), -low[2]],
            ..Placement::default()
        };
        solid.placed(&to_base)
    }
}

impl PagodaPart {
    /// The pagoda, each factor with the value that `pick` chooses.
    ///
    /// # Errors
    /// [`StackError`] for impossible factors.
    pub fn made(&self, density_kg_m3: f64, pick: Pick<'_>) -> Result<Pagoda, StackError> {
        pagoda(&PagodaFactors {
            density_kg_m3,
            ..self.factors(pick)
        })
    }

    /// Its factors, each with the value that `pick` chooses, and the usual density.
    pub fn factors(&self, pick: Pick<'_>) -> PagodaFactors {
        let usual = PagodaFactors::default();
        PagodaFactors {
            storeys: self.storeys,
            body_height_m: pick(&self.body_height),
            slenderness: match &self.slenderness {
                Some(PagodaSlendernessPart::Body(given)) => PagodaSlenderness::Body(pick(given)),
                Some(PagodaSlendernessPart::Angle(given)) => PagodaSlenderness::Angle(pick(given)),
                None => usual.slenderness,
            },
            taper_rad: self.taper.as_ref().map_or(usual.taper_rad, &mut *pick),
            body_base_height_ratio: self
                .body_base_height_ratio
                .as_ref()
                .map_or(usual.body_base_height_ratio, &mut *pick),
            ..usual
        }
    }
}

impl ShapePart {
    pub(super) fn solid(&self, pick: Pick<'_>) -> Result<Solid, StackError> {
        match self {
            ShapePart::Box { width, depth, height } => {
                let width_m = pick(width);
                let depth_m = depth.as_ref().map_or(width_m, &mut *pick);
                Solid::cuboid(width_m, depth_m, pick(height))
            }
            ShapePart::Frustum {
                width,
                depth,
                top,
                height,
            } => {
                let base = pick(width);
                let base = [base, depth.as_ref().map_or(base, &mut *pick)];
                let top_width = pick(&top.width);
                let in_proportion = base[1] * top_width / base[0];
                let top_depth = top.depth.as_ref().map_or(in_proportion, &mut *pick);
                Solid::frustum(base, [top_width, top_depth], pick(height))
            }
            ShapePart::Prism {
                sides,
                width,
                top_width,
                height,
            } => {
                let base = pick(width);
                let top = top_width.as_ref().map_or(base, &mut *pick);
                Solid::prism_frustum(*sides, base, top, pick(height))
            }
            ShapePart::Drum {
                diameter,
                top_diameter,
                height,
            } => {
                let base = pick(diameter);
                let top = top_diameter.as_ref().map_or(base, &mut *pick);
                Solid::tapered_drum(base, top, pick(height))
            }
            ShapePart::Points { points, frame } => {
                let points_m: Vec<[f64; 3]> = points
                    .iter()
                    .map(|point| point.each_ref().map(&mut *pick))
                    .collect();
                Ok(frame.of(Solid::convex(&points_m)?))
            }
            ShapePart::Mesh(mesh) => Ok(mesh.solid.clone()),
        }
    }
}

impl OpeningPart {
    fn solid(&self, pick: Pick<'_>) -> Result<Solid, StackError> {
        let width_m = pick(&self.width);
        let depth_m = self.depth.as_ref().map_or(width_m, &mut *pick);
        let place = Placement {
            position_m: self.position.each_ref().map(&mut *pick),
            ..Placement::default()
        };
        Ok(Solid::cuboid(width_m, depth_m, pick(&self.height))?.placed(&place))
    }
}

impl BedPart {
    /// The material around it with what it says itself.
    pub(super) fn over(&self, around: JointMaterial, pick: Pick<'_>) -> JointMaterial {
        let mut material = around;
        let mut set = |slot: &mut f64, quantity: &Option<Quantity>| {
            if let Some(quantity) = quantity {
                *slot = pick(quantity);
            }
        };
        if self.friction.is_some() {
            set(&mut material.friction_static, &self.friction);
            material.friction_kinetic = material.friction_static;
        }
        set(&mut material.friction_kinetic, &self.friction_kinetic);
        set(&mut material.cohesion_pa, &self.cohesion);
        set(&mut material.tension_pa, &self.tension);
        set(&mut material.normal_stiffness_pa_m, &self.normal_stiffness);
        set(&mut material.shear_stiffness_pa_m, &self.shear_stiffness);
        set(&mut material.damping_ratio, &self.damping_ratio);
        set(&mut material.normal_restitution, &self.normal_restitution);
        if self.normal_restitution.is_some() && self.damping_ratio.is_none() {
            material.damping_ratio = JointMaterial::damping_ratio_of(material.normal_restitution);
        }
        if let Some(rocking) = &self.rocking_restitution {
            material.rocking_restitution = Some(pick(rocking));
        }
        if let Some(strength) = &self.strength {
            material.compressive_strength_pa = Some(pick(strength));
        }
        material
    }

    pub(super) fn says_something(&self) -> bool {
        let mut all = Vec::new();
        self.inputs(&mut all);
        !all.is_empty()
    }
}

impl StackPart {
    /// The stack, each input with the value that `pick` chooses.
    ///
    /// Every block stands on the highest face of the block below it; on several blocks, on the highest of them.
    ///
    /// # Errors
    /// None with the file's own values, which are checked on reading; [`StackFault`] if picked ones are impossible.
    pub fn build(&self, pick: Pick<'_>) -> Result<Stack, StackFault> {
        if self.is_loose {
            return Err(StackFault::Loose);
        }
        let mut blocks = self.all_blocks(pick)?;
        for lost in &self.lost_beds {
            let block = blocks.iter().position(|block| block.name == lost.block);
            let bed = LostBed {
                block: block.unwrap_or(blocks.len()),
                share: lost.share,
                outward: lost.outward,
            };
            blocks = without_bed(blocks, &bed).map_err(|why| StackFault::part(lost.path.clone(), why))?;
        }
        let turn = self.lean.as_ref().and_then(|lean| lean.turn(&blocks));
        if let Some(turn) = turn {
            blocks = blocks.into_iter().map(|block| turn.block(block)).collect();
        }
        let around = self.joint.over(JointMaterial::default(), pick);
        let stack = Stack::new(blocks, around, self.gravity_m_s2).map_err(|why| self.locate(why))?;
        self.check_beds(&stack)?;
        let stack = self.with_materials(stack, around, pick)?;
        let mut stack = self.with_loosened_beds(stack)?;
        if let Some(soil) = &self.soil {
            let below = soil.below(stack, pick);
            stack = below.map_err(|why| StackFault::part("soil".to_owned(), why))?;
        }
        self.with_pieces(stack, turn, pick)
    }

    /// The blocks that the file lists or generates, whole and plumb.
    fn all_blocks(&self, pick: Pick<'_>) -> Result<Vec<Block>, StackFault> {
        let density = |pick: Pick<'_>| self.density.as_ref().map_or(f64::NAN, pick);
        if let Some(factors) = &self.pagoda {
            let made = factors.made(density(&mut *pick), pick);
            return Ok(made
                .map_err(|why| StackFault::part("pagoda".to_owned(), why))?
                .blocks);
        }
        let Some(part) = &self.made else {
            return self.placed_blocks(pick);
        };
        let density = density(&mut *pick);
        let made = match part {
            MadePart::Arch(arch) => arch.made(density, pick),
            MadePart::Wall(wall) => wall.made(density, pick),
            MadePart::Tower(tower) => tower.made(density, pick),
            MadePart::Trilithon(trilithon) => trilithon.made(density, pick),
            MadePart::Vault(vault) => vault.made(density, pick),
            MadePart::Dome(dome) => dome.made(density, pick),
        };
        made.map_err(|why| StackFault::part(self.made_by().to_owned(), why))
    }

    /// Names of the blocks that are generated; none if the file lists them.
    pub(crate) fn generated_names(&self) -> Vec<String> {
        if self.pagoda.is_none() && self.made.is_none() {
            return Vec::new();
        }
        let blocks = self.all_blocks(&mut Quantity::nominal).unwrap_or_default();
        blocks.into_iter().map(|block| block.name).collect()
    }

    /// The blocks of the file, each at its place.
    pub(super) fn placed_blocks(&self, pick: Pick<'_>) -> Result<Vec<Block>, StackFault> {
        let mut placed: Vec<Option<Block>> = vec![None; self.blocks.len()];
        for i in self.lowest_first() {
            let part = &self.blocks[i];
            let shape = part.shape.solid(pick).and_then(|of| part.on_cornice(of, pick));
            let mut solid = shape.map_err(|why| at_block(i, why))?;
            for (k, opening) in part.openings.iter().enumerate() {
                let path = format!("blocks[{}].openings[{}]", i + 1, k + 1);
                let cut = opening
                    .solid(pick)
                    .and_then(|opening| solid.with_opening(&opening));
                solid = cut.map_err(|why| StackFault::part(path, why))?;
            }
            let placement = part.placement(&placed, pick);
            let density = part.density.as_ref().or(self.density.as_ref());
            let density = density.map_or(f64::NAN, &mut *pick); // refused by the stack
            let block = part.under_mast(solid, density, pick);
            let block = block.map_err(|why| at_block(i, why))?;
            placed[i] = Some(Block {
                solid: block.solid.placed(&placement),
                ..block
            });
        }
        Ok(placed.into_iter().flatten().collect())
    }

    /// The blocks in an order in which each comes after those that it stands on; blocks that stand on each other in a
    /// ring, which reading refuses, come in the order of the file.
    fn lowest_first(&self) -> Vec<usize> {
        let mut order: Vec<usize> = Vec::with_capacity(self.blocks.len());
        let mut listed = vec![false; self.blocks.len()];
        loop {
            let ready = |i: &usize| {
                let known = |body: &Body| match body {
                    Body::Ground => true,
                    Body::Block(lower) => listed[*lower],
                };
                !listed[*i] && self.blocks[*i].on.iter().all(known)
            };
            let next = (0..self.blocks.len()).find(ready);
            let Some(next) = next.or_else(|| listed.iter().position(|listed| !listed)) else {
                return order;
            };
            listed[next] = true;
            order.push(next);
        }
    }

    /// A block that stands on itself through others.
    pub(super) fn ring(&self) -> Option<usize> {
        let order = self.lowest_first();
        let place = |block: usize| order.iter().position(|other| *other == block);
        order.iter().copied().find(|&block| {
            self.blocks[block].on.iter().any(|body| match body {
                Body::Ground => false,
                Body::Block(lower) => place(*lower) > place(block),
            })
        })
    }

    /// The key that makes its blocks.
    pub(super) fn made_by(&self) -> &'static str {
        match (&self.pagoda, &self.made) {
            (Some(_), _) => "pagoda",
            (None, Some(MadePart::Arch(_))) => "arch",
            (None, Some(MadePart::Wall(_))) => "wall",
            (None, Some(MadePart::Tower(_))) => "tower",
            (None, Some(MadePart::Trilithon(_))) => "trilithon",
            (None, Some(MadePart::Vault(_))) => "vault",
            (None, Some(MadePart::Dome(_))) => "dome",
            (None, None) => "blocks",
        }
    }

    /// Every block must touch what the file says it stands on.
    fn check_beds(&self, stack: &Stack) -> Result<(), StackFault> {
        let placed = |(_, part): &(usize, &BlockPart)| !part.shape.keeps_its_place();
        for (upper, part) in self.blocks.iter().enumerate().filter(placed) {
            for lower in &part.on {
                let meets = |joint: &Joint| joint.lower == *lower && joint.upper == upper;
                if !stack.joints().iter().any(meets) {
                    let path = format!("blocks[{}]", upper + 1);
                    return Err(StackFault::not_on(path, stack, upper, *lower));
                }
            }
        }
        Ok(())
    }

    fn with_materials(
        &self,
        mut stack: Stack,
        around: JointMaterial,
        pick: Pick<'_>,
    ) -> Result<Stack, StackFault> {
        let ends: Vec<(Body, usize)> = stack.joints().iter().map(|j| (j.lower, j.upper)).collect();
        for (joint, (lower, upper)) in ends.iter().enumerate() {
            let own = self.blocks.get(*upper).map(|block| &block.joint);
            if let Some(own) = own.filter(|own| own.says_something()) {
                let path = format!("blocks[{}].joint", upper + 1);
                stack = stack
                    .with_material(joint, own.over(around, pick))
                    .map_err(|why| StackFault::part(path, why))?;
            }
            for (i, contact) in self.contacts.iter().enumerate() {
                let one = (contact.lower, contact.upper) == (*lower, *upper);
                let other = (Body::Block(contact.upper), contact.lower) == (*lower, Body::Block(*upper));
                if one || other {
                    let path = format!("contacts[{}].joint", i + 1);
                    let material = contact.joint.over(stack.joints()[joint].material, pick);
                    stack = stack
                        .with_material(joint, material)
                        .map_err(|why| StackFault::part(path, why))?;
                }
            }
        }
        for (i, contact) in self.contacts.iter().enumerate() {
            let ends_of = |contact: &ContactPart| [contact.lower, Body::Block(contact.upper)];
            let [lower, upper] = ends_of(contact);
            let same = |other: &ContactPart| {
                let [a, b] = ends_of(other);
                (a, b) == (lower, upper) || (b, a) == (lower, upper)
            };
            if let Some(first) = self.contacts[..i].iter().position(same) {
                return Err(StackFault::Twice {
                    path: format!("contacts[{}]", i + 1),
                    upper: stack.name(upper).to_owned(),
                    lower: stack.name(lower).to_owned(),
                    first: first + 1,
                });
            }
            let meets = |(lower, upper): &(Body, usize)| {
                (contact.lower, contact.upper) == (*lower, *upper)
                    || (Body::Block(contact.upper), contact.lower) == (*lower, Body::Block(*upper))
            };
            if !ends.iter().any(meets) {
                let path = format!("contacts[{}]", i + 1);
                return Err(StackFault::not_beside(path, &stack, contact.upper, contact.lower));
            }
        }
        Ok(stack)
    }

    fn with_pieces(&self, mut stack: Stack, turn: Option<Turn>, pick: Pick<'_>) -> Result<Stack, StackFault> {
        for (i, part) in self.ties.iter().enumerate() {
            let path = format!("ties[{}]", i + 1);
            let position_m = part.position.each_ref().map(&mut *pick);
            let tie = Tie {
                lower: part.lower,
                upper: part.upper,
                position_m: turn.map_or(position_m, |turn| turn.point(position_m)),
                axis: turn.map_or(part.axis, |turn| turn.turned(part.axis)),
                axial_stiffness_n_m: part.axial_stiffness.as_ref().map_or(0.0, &mut *pick),
                shear_stiffness_n_m: pick(&part.shear_stiffness),
                tension_strength_n: part.tension_strength.as_ref().map_or(0.0, &mut *pick),
                shear_strength_n: pick(&part.shear_strength),
            };
            stack = stack.with_tie(tie).map_err(|why| StackFault::part(path, why))?;
        }
        for (i, part) in self.side_supports.iter().enumerate() {
            let path = format!("side_supports[{}]", i + 1);
            let support = SideSupport {
                block: part.block,
                position_m: part.position.each_ref().map(&mut *pick),
                direction: part.direction,
                gap_m: part.gap.as_ref().map_or(0.0, &mut *pick),
                stiffness_n_m: pick(&part.stiffness),
            };
            stack = stack
                .with_side_support(support)
                .map_err(|why| StackFault::part(path, why))?;
        }
        for (i, part) in self.support_movement.iter().enumerate() {
            let path = format!("support_movement[{}]", i + 1);
            let movement = SupportMovement {
                block: part.block,
                movement_m: part
                    .movement
                    .each_ref()
                    .map(|part| part.as_ref().map_or(0.0, &mut *pick)),
            };
            stack = stack
                .with_support_movement(movement)
                .map_err(|why| StackFault::part(path, why))?;
        }
        for (i, part) in self.static_loads.iter().enumerate() {
            let path = format!("loads[{}]", i + 1);
            let load = static_load(part, &stack, turn, pick);
            stack = stack
                .with_static_load(load)
                .map_err(|why| StackFault::part(path, why))?;
        }
        Ok(stack)
    }

    /// Where in the file the science's complaint belongs.
    pub(super) fn locate(&self, why: StackError) -> StackFault {
        let index = |name: &str| self.blocks.iter().position(|block| block.name == name);
        let path = match &why {
            StackError::Overlap { first, second, .. } => {
                let (first, second) = (index(first), index(second));
                first.max(second).map(|i| format!("blocks[{}]", i + 1))
            }
            StackError::Floating { block: name, .. }
            | StackError::JointUsed { upper: name, .. }
            | StackError::JointFacets { upper: name, .. }
            | StackError::JointRounded { rounded: name, .. }
            | StackError::JointHollow { upper: name, .. }
            | StackError::Name { name } => index(name).map(|i| format!("blocks[{}]", i + 1)),
            StackError::Material { .. } => Some("joint".to_owned()),
            _ => None,
        };
        let path = path.unwrap_or_else(|| self.made_by().to_owned());
        StackFault::part(path, why)
    }
}

impl BlockPart {
    /// Its place, with the earlier blocks at their places.
    fn placement(&self, before: &[Option<Block>], pick: Pick<'_>) -> Placement {
        if self.shape.keeps_its_place() {
            return Placement::default();
        }
        let tops: Vec<Top> = self
            .on
            .iter()
            .map(|body| match body {
                Body::Ground => Top::GROUND,
                Body::Block(lower) => {
                    let stone = before[*lower].as_ref();
                    stone
                        .and_then(|stone| Top::of(&stone.solid))
                        .unwrap_or(Top::GROUND)
                }
            })
            .collect();
        let mean =
            |axis: usize| tops.iter().map(|top| top.centroid_m[axis]).sum::<f64>() / tops.len().max(1) as f64;
        let mut plan = match &self.at {
            Some(at) => at.each_ref().map(&mut *pick),
            None => [mean(0), mean(1)],
        };
        if let Some(offset) = &self.offset {
            for (place, shift) in plan.iter_mut().zip(offset) {
                *place += pick(shift);
            }
        }
        // on one stone the plane of that stone, even if it leans; on several the highest of their tops
        let height_m = match tops.as_slice() {
            [one] => one.height_m(plan),
            several => several
                .iter()
                .map(|top| top.centroid_m[2])
                .fold(f64::NEG_INFINITY, f64::max),
        };
        Placement {
            yaw_rad: self.rotation.as_ref().map_or(0.0, &mut *pick),
            tilt: self
                .tilt
                .each_ref()
                .map(|tilt| tilt.as_ref().map_or(0.0, &mut *pick)),
            position_m: [plan[0], plan[1], height_m],
        }
    }
}

fn at_block(index: usize, why: StackError) -> StackFault {
    let path = format!("blocks[{}]", index + 1);
    StackFault::part(path, why)
}

/// A static load; without a position it is in the middle of its stone in plan, at its height or the top of the stone.
fn static_load(part: &LoadPart, stack: &Stack, turn: Option<Turn>, pick: Pick<'_>) -> StaticLoad {
    let position_m = match (&part.position, stack.blocks().get(part.part)) {
        (Some(position), _) => {
            let position_m = position.each_ref().map(&mut *pick);
            turn.map_or(position_m, |turn| turn.point(position_m))
        }
        (None, Some(block)) => {
            let [x, y, _] = block.solid.centroid_m();
            let top_m = block.solid.bounds_m()[1][2];
            [x, y, part.height.as_ref().map_or(top_m, &mut *pick)]
        }
        (None, None) => [f64::NAN; 3], // refused by the stack
    };
    StaticLoad {
        block: part.part,
        position_m,
        force_n: part
            .components
            .as_ref()
            .map_or([0.0; 3], |force| force.each_ref().map(&mut *pick)),
    }
}
