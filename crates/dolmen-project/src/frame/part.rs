//! The frame of a project file, and the frame of the library that it builds.

use crate::heaviness::Heaviness;
use crate::loads::LoadPart;
use crate::quantity::{Pick, Quantity};
use crate::sought::Sought;
use dolmen::dynamics::{
    DynamicsError, FrictionActsOn, FrictionFrame, StoreyFriction, Tenon, ViscousDamping, slip_forces_n,
};
use dolmen::signal::Component;
use dolmen::stability::{FootSection, FreeColumns, StabilityError};
use dolmen::structure::{Convention, Frame, Storey, StructureError};

/// The meaning of `axial_force` of a storey.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axial {
    /// N_i, the force in the columns of the storey: its own level and all above.
    Storey,
    /// P_i, the load added at the top of the storey.
    Level,
    /// None is given: N_i is the weight of the masses at its top and above.
    FromMasses,
}

/// One storey, from the file.
#[derive(Clone, Debug, PartialEq)]
pub struct StoreyPart {
    /// Name, if given.
    pub name: Option<String>,
    /// Mass or weight at its top.
    pub heaviness: Heaviness,
    /// Column height, m.
    pub height: Quantity,
    /// Axial force, N, with the meaning of [`FramePart::axial`]; `None` with [`Axial::FromMasses`].
    pub axial_force: Option<Quantity>,
    /// Free-standing columns, if given.
    pub columns: Option<ColumnsPart>,
}

/// Foot and head of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum FootPart {
    /// A rectangle.
    Rectangle {
        /// Width in the direction of motion, m.
        width: Quantity,
        /// Width across it, m; `None` for a square.
        breadth: Option<Quantity>,
    },
    /// A circle.
    Circle {
        /// Diameter, m.
        diameter: Quantity,
    },
}

/// Equal free-standing columns of a storey on foot stones; as high as the storey.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnsPart {
    /// Number of columns.
    pub count: usize,
    /// Foot and head.
    pub foot: FootPart,
    /// Pressure over indentation, N/m³; `None` for a rigid bed.
    pub bed_stiffness: Option<Quantity>,
}

impl FootPart {
    /// Width in the direction of motion.
    pub fn width(&self) -> &Quantity {
        match self {
            FootPart::Rectangle { width, .. } => width,
            FootPart::Circle { diameter } => diameter,
        }
    }

    /// Area with the file's own values, m².
    pub(super) fn area_m2(&self) -> f64 {
        let width_m = self.width().value;
        match self {
            FootPart::Rectangle { breadth, .. } => {
                width_m * breadth.as_ref().map_or(width_m, |breadth| breadth.value)
            }
            FootPart::Circle { .. } => std::f64::consts::PI / 4.0 * width_m * width_m,
        }
    }

    fn build(&self, pick: Pick<'_>) -> FootSection {
        match self {
            FootPart::Rectangle { width, breadth } => {
                let width_m = pick(width);
                FootSection::Rectangle {
                    width_m,
                    breadth_m: breadth.as_ref().map_or(width_m, pick),
                }
            }
            FootPart::Circle { diameter } => FootSection::Circle {
                diameter_m: pick(diameter),
            },
        }
    }
}

impl ColumnsPart {
    /// The columns of a storey of the frame, each input with the value that `pick` chooses.
    ///
    /// # Errors
    /// None for the values of the file; [`StabilityError`] if a picked value is impossible.
    pub fn build(&self, storey: &Storey, pick: Pick<'_>) -> Result<FreeColumns, StabilityError> {
        let section = self.foot.build(pick);
        let bed_stiffness_n_m3 = self.bed_stiffness.as_ref().map(pick);
        FreeColumns::new(
            self.count,
            section,
            storey.height_m,
            storey.axial_n,
            bed_stiffness_n_m3,
        )
    }
}

/// One horizontal direction: each is a frame of its own with the same storeys.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionPart {
    /// "weak", "strong", "x".
    pub name: String,
    /// The component of a motion, and of a tilt, along it, if known.
    pub along: Option<Component>,
    /// Lateral stiffness of each storey, N/m, lowest first; 0 where free-standing columns alone support it, `None` if unknown.
    pub stiffness: Option<Vec<Quantity>>,
    /// The survey from which to identify it, where the file leaves it to one.
    pub sought: Option<Sought>,
    /// Viscous damping ratio of every mode, if given.
    pub damping_ratio: Option<Quantity>,
    /// Dry friction, if given.
    pub friction: Option<FrictionPart>,
    /// Tenons with slack, if given.
    pub tenons: Option<TenonsPart>,
}

/// Slip forces of the storeys.
#[derive(Clone, Debug, PartialEq)]
pub enum SlipForces {
    /// Coefficients of the axial force: while slipping, and before slipping if different.
    Coefficient {
        /// μ while slipping.
        kinetic: Box<Quantity>,
        /// μ before slipping; `None`: equal to that while slipping.
        fixed: Option<Box<Quantity>>,
    },
    /// One force for each storey, N, lowest first.
    Forces(Vec<Quantity>),
}

/// Dry friction in one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionPart {
    /// Slip forces.
    pub slip: SlipForces,
    /// Remaining stiffness of each storey while its slider slips, N/m (Jenkins); `None` for Coulomb's law.
    pub slipping_stiffness: Option<Vec<Quantity>>,
    /// The quantity that the sliders act on.
    pub acts_on: FrictionActsOn,
}

/// Storeys, lowest first, with the directions in which they move.
#[derive(Clone, Debug, PartialEq)]
pub struct FramePart {
    /// The storeys.
    pub storeys: Vec<StoreyPart>,
    /// The meaning of `axial_force`.
    pub axial: Axial,
    /// The quantity that the stiffness acts on.
    pub convention: Convention,
    /// Directions in the order of the file, at least one; directions that only a survey names follow, with unknown stiffness.
    pub directions: Vec<DirectionPart>,
    /// Its measured lean, from which checks and runs start; `None` if no dated survey gives one, or the file leaves it out.
    pub lean: Option<FrameLean>,
    /// Whether the file leaves out every surveyed tilt.
    pub takes_no_tilt: bool,
    /// Static loads; its masses and axial forces include their weight.
    pub static_loads: Vec<LoadPart>,
    /// Acceleration of gravity, m/s².
    pub gravity_m_s2: f64,
}

/// The measured tilt of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameLean {
    /// The survey.
    pub survey: String,
    /// The text of the file, by direction: "x 1/177, y 1/540".
    pub written: String,
    /// Horizontal over vertical in each direction of the frame; the combined tilt in each direction if the survey names a direction that
    /// the frame does not have.
    pub tilts: Vec<f64>,
    /// Tilt of all directions together.
    pub together: f64,
}

impl FramePart {
    /// The lean in a direction, horizontal over vertical; 0 without a measured tilt.
    pub fn tilt(&self, direction: &str) -> f64 {
        let place = self.directions.iter().position(|own| own.name == direction);
        let tilt = place.and_then(|place| self.lean.as_ref()?.tilts.get(place).copied());
        tilt.unwrap_or(0.0)
    }

    /// The lean across a direction, horizontal over vertical; 0 without a measured tilt, or for an unknown direction.
    pub fn tilt_across(&self, direction: &str) -> f64 {
        let whole = self.lean.as_ref().map_or(0.0, |lean| lean.together);
        let own = self.tilt(direction);
        (whole * whole - own * own).max(0.0).sqrt()
    }

    /// The direction along a component of a motion, if known.
    pub fn along(&self, component: Component) -> Option<&DirectionPart> {
        self.directions.iter().find(|own| own.along == Some(component))
    }

    /// The frame, the same in each direction, with the weight of its static loads, each input with the value that `pick` chooses.
    ///
    /// # Errors
    /// None with the file's own values, which are checked on reading; [`StructureError`] if a picked one is impossible.
    pub fn build(&self, pick: Pick<'_>) -> Result<Frame, StructureError> {
        self.build_weighing([1.0, 1.0], pick)
    }

    /// [`FramePart::build`] with factors on the axial forces of its own weight, and on those of its static loads; the masses are unchanged.
    ///
    /// # Errors
    /// As [`FramePart::build`].
    pub fn build_weighing(&self, [own, loads]: [f64; 2], pick: Pick<'_>) -> Result<Frame, StructureError> {
        let mut storeys = Vec::with_capacity(self.storeys.len());
        for part in &self.storeys {
            let mass_kg = part.heaviness.mass_kg(self.gravity_m_s2, pick);
            storeys.push(Storey {
                mass_kg,
                height_m: pick(&part.height),
                axial_n: match &part.axial_force {
                    Some(force) => pick(force),
                    None => mass_kg * self.gravity_m_s2,
                },
            });
        }
        if self.axial != Axial::Storey {
            let mut above_n = 0.0;
            for storey in storeys.iter_mut().rev() {
                above_n += storey.axial_n;
                storey.axial_n = above_n;
            }
        }
        storeys.iter_mut().for_each(|storey| storey.axial_n *= own);
        for load in &self.static_loads {
            let Some(weight_n) = load.weight.as_ref().map(&mut *pick) else {
                continue;
            };
            // at the top of its storey, carried by that and all below
            for storey in storeys.iter_mut().take(load.part + 1) {
                storey.axial_n += loads * weight_n;
            }
            if let Some(level) = storeys.get_mut(load.part) {
                level.mass_kg += weight_n / self.gravity_m_s2;
            }
        }
        Frame::new(storeys, self.convention)
    }

    /// The force of a static load in a direction, if it has one.
    pub fn force_of<'a>(&self, load: &'a LoadPart, direction: &DirectionPart) -> Option<&'a Quantity> {
        match (self.directions.len(), direction.along) {
            (1, _) | (_, Some(Component::X)) => load.force.as_ref(),
            (_, Some(Component::Y)) => load.force_across.as_ref(),
            _ => None,
        }
    }

    /// Stiffness of each storey in a direction, N/m, lowest first; `None` if it is unknown or there is no such
    /// direction. Where columns alone support a storey, the stiffness of their beds.
    pub fn stiffness_n_m(&self, direction: &str, pick: Pick<'_>) -> Option<Vec<f64>> {
        let named = self.directions.iter().find(|d| d.name == direction)?;
        let given = named.stiffness.as_ref()?.iter().enumerate();
        let each = given.map(|(storey, given)| match given.value == 0.0 {
            true => self.beds_n_m(storey, pick),
            false => Some(pick(given)),
        });
        each.collect()
    }

    /// Whether columns alone support a storey in a direction: a stiffness of 0.
    pub fn is_on_columns_alone(&self, direction: &str) -> bool {
        let named = self.directions.iter().find(|d| d.name == direction);
        let mut given = named.and_then(|own| own.stiffness.as_ref()).into_iter().flatten();
        given.any(|given| given.value == 0.0)
    }

    /// The stiffness that the beds of the columns give a storey at small drift, N/m.
    fn beds_n_m(&self, storey: usize, pick: Pick<'_>) -> Option<f64> {
        let frame = self.build(pick).ok()?;
        let columns = self.storeys[storey].columns.as_ref()?;
        let built = columns.build(frame.storeys().get(storey)?, pick).ok()?;
        built.bed_stiffness_n_m()
    }

    /// The frame with its friction and damping in a direction, for time histories; `None` if the stiffness is unknown or there is
    /// no such direction.
    ///
    /// # Errors
    /// None with the file's own values; [`DynamicsError`] if a picked one is impossible.
    pub fn with_friction(
        &self,
        direction: &str,
        pick: Pick<'_>,
    ) -> Result<Option<FrictionFrame>, DynamicsError> {
        let Some(part) = self.directions.iter().find(|d| d.name == direction) else {
            return Ok(None);
        };
        let Some(whole_n_m) = self.stiffness_n_m(direction, pick) else {
            return Ok(None);
        };
        let frame = self.build(pick)?;
        let Some(friction) = &part.friction else {
            let none = vec![StoreyFriction::None; whole_n_m.len()];
            return furnished(FrictionFrame::new(frame, whole_n_m, none)?, part, pick);
        };
        let slipping_n_m: Option<Vec<f64>> = friction
            .slipping_stiffness
            .as_ref()
            .map(|list| list.iter().map(&mut *pick).collect());
        let sliders = friction.build(&frame, (&whole_n_m, slipping_n_m.as_deref()), pick)?;
        let own = slipping_n_m.unwrap_or(whole_n_m);
        let built = FrictionFrame::new(frame, own, sliders)?.acting_on(friction.acts_on);
        furnished(built, part, pick)
    }

    /// The tenons of each storey in a direction, lowest first; `None` where it has none.
    ///
    /// # Errors
    /// As [`FramePart::build`].
    pub fn tenons(
        &self,
        direction: &str,
        pick: Pick<'_>,
    ) -> Result<Option<Vec<Option<Tenon>>>, StructureError> {
        let part = self.directions.iter().find(|own| own.name == direction);
        let Some(tenons) = part.and_then(|part| part.tenons.as_ref()) else {
            return Ok(None);
        };
        let frame = self.build(pick)?;
        Ok(Some(tenons.build(&frame, pick)))
    }

    /// Stiffness of each storey while every slider slips, N/m; `None` where friction does not reduce the stiffness.
    pub fn slipping_stiffness_n_m(&self, direction: &str, pick: Pick<'_>) -> Option<Vec<f64>> {
        let part = self.directions.iter().find(|d| d.name == direction)?;
        part.stiffness.as_ref()?;
        let slipping = part.friction.as_ref()?.slipping_stiffness.as_ref()?;
        Some(slipping.iter().map(pick).collect())
    }

    /// Whether joints of a direction lose stiffness when they slip.
    pub fn softens(&self) -> bool {
        let mut friction = self.directions.iter().filter_map(|own| own.friction.as_ref());
        friction.any(|own| own.slipping_stiffness.is_some())
    }

    /// Pairs of inputs of which the first is never above the second: the stiffness of a storey while its slider slips and while it sticks, the
    /// coefficient of friction while slipping and before.
    pub(crate) fn ordered_inputs(&self) -> Vec<[&Quantity; 2]> {
        let mut all = Vec::new();
        for direction in &self.directions {
            let Some(friction) = &direction.friction else {
                continue;
            };
            let stuck = direction.stiffness.iter().flatten();
            let slipping = friction.slipping_stiffness.iter().flatten();
            all.extend(slipping.zip(stuck).map(|(slipping, stuck)| [slipping, stuck]));
            if let SlipForces::Coefficient {
                kinetic,
                fixed: Some(fixed),
            } = &friction.slip
            {
                all.push([kinetic, fixed]);
            }
        }
        all
    }

    pub(crate) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        for storey in &self.storeys {
            all.extend([storey.heaviness.quantity(), &storey.height]);
            all.extend(&storey.axial_force);
            if let Some(columns) = &storey.columns {
                all.push(columns.foot.width());
                if let FootPart::Rectangle { breadth, .. } = &columns.foot {
                    all.extend(breadth);
                }
                all.extend(&columns.bed_stiffness);
            }
        }
        for direction in &self.directions {
            all.extend(direction.stiffness.iter().flatten());
            all.extend(&direction.damping_ratio);
            if let Some(tenons) = &direction.tenons {
                tenons.inputs(all);
            }
            let Some(friction) = &direction.friction else {
                continue;
            };
            match &friction.slip {
                SlipForces::Coefficient { kinetic, fixed } => {
                    all.push(kinetic);
                    all.extend(fixed.as_deref());
                }
                SlipForces::Forces(forces) => all.extend(forces),
            }
            all.extend(friction.slipping_stiffness.iter().flatten());
        }
    }
}

/// A frame with the tenons and the damping of its direction.
fn furnished(
    frame: FrictionFrame,
    part: &DirectionPart,
    pick: Pick<'_>,
) -> Result<Option<FrictionFrame>, DynamicsError> {
    let frame = match &part.tenons {
        None => frame,
        Some(tenons) => {
            let built = tenons.build(frame.frame(), pick);
            frame.with_tenons(built)?
        }
    };
    Ok(Some(match &part.damping_ratio {
        None => frame,
        Some(ratio) => frame.with_damping(ViscousDamping::Modal(pick(ratio)))?,
    }))
}

impl FrictionPart {
    /// Sliders of the storeys, from the stiffness while all stick and that while all slip.
    fn build(
        &self,
        frame: &Frame,
        (whole_n_m, slipping_n_m): (&[f64], Option<&[f64]>),
        pick: Pick<'_>,
    ) -> Result<Vec<StoreyFriction>, DynamicsError> {
        let (kinetic, fixed) = match &self.slip {
            SlipForces::Coefficient { kinetic, fixed } => {
                let kinetic = slip_forces_n(frame, pick(kinetic))?;
                let fixed = match fixed {
                    Some(fixed) => slip_forces_n(frame, pick(fixed))?,
                    None => kinetic.clone(),
                };
                (kinetic, fixed)
            }
            SlipForces::Forces(forces) => {
                let forces: Vec<f64> = forces.iter().map(&mut *pick).collect();
                (forces.clone(), forces)
            }
        };
        let each = kinetic.into_iter().zip(fixed).enumerate();
        let built = each.map(|(i, (kinetic_force_n, static_force_n))| match slipping_n_m {
            None => StoreyFriction::Coulomb {
                static_force_n,
                kinetic_force_n,
            },
            Some(slipping) => StoreyFriction::Jenkins {
                stuck_stiffness_n_m: whole_n_m[i] - slipping[i],
                static_force_n,
                kinetic_force_n,
            },
        });
        Ok(built.collect())
    }
}

/// Tenons of a frame in one direction, all of a storey taken together.
#[derive(Clone, Debug, PartialEq)]
pub struct TenonsPart {
    /// Rotation of the columns before the tenons bear, to either side, each storey, lowest first.
    pub slack: Vec<Quantity>,
    /// Stiffness once they bear, N/m; 0 for a storey without tenons.
    pub stiffness: Vec<Quantity>,
    /// Force at which their faces crush, N, for each storey; `None` if they never crush.
    pub crushing_force: Option<Vec<Quantity>>,
    /// Crushed depth, as drift, at which a face keeps half of its stiffness, m; `None` if it keeps all of it.
    pub half_stiffness_depth: Option<Quantity>,
}

impl TenonsPart {
    /// The tenons of each storey, each input with the value that `pick` chooses.
    pub fn build(&self, frame: &Frame, pick: Pick<'_>) -> Vec<Option<Tenon>> {
        let half_stiffness_depth_m = self.half_stiffness_depth.as_ref().map(&mut *pick);
        let storeys = frame.storeys().iter().enumerate();
        let each = storeys.map(|(i, storey)| {
            let stiffness_n_m = self.stiffness.get(i).map(&mut *pick)?;
            let slack = self.slack.get(i).map(&mut *pick)?;
            let crushing = self.crushing_force.as_ref().and_then(|forces| forces.get(i));
            (stiffness_n_m > 0.0).then(|| Tenon {
                slack_m: slack * storey.height_m,
                stiffness_n_m,
                crushing_force_n: crushing.map(&mut *pick),
                half_stiffness_depth_m,
            })
        });
        each.collect()
    }

    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.extend(&self.slack);
        all.extend(&self.stiffness);
        all.extend(self.crushing_force.iter().flatten());
        all.extend(&self.half_stiffness_depth);
    }
}
