//! The frame of a project file, and the frame of the science it builds.

use super::chain::Heaviness;
use super::quantity::{Pick, Quantity};
use dolmen::structure::{Convention, Frame, Storey, StructureError};

/// What `axial_force` of a storey is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axial {
    /// N_i, the force in the columns of the storey: its own level and all above.
    Storey,
    /// P_i, the load added at the top of the storey.
    Level,
    /// None is given: N_i is the weight of the masses at its top and above.
    FromMasses,
}

/// One storey as the file gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct StoreyPart {
    /// Name, if given.
    pub name: Option<String>,
    /// Mass or weight at its top.
    pub heaviness: Heaviness,
    /// Column height, m.
    pub height: Quantity,
    /// Axial force as [`FramePart::axial`] says, N; `None` with [`Axial::FromMasses`].
    pub axial_force: Option<Quantity>,
}

/// One horizontal direction: each is a frame of its own with the same storeys.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionPart {
    /// "weak", "strong", "x".
    pub name: String,
    /// Lateral stiffness of each storey, N/m, lowest first; `None` if unknown.
    pub stiffness: Option<Vec<Quantity>>,
}

/// Storeys, lowest first, with the directions in which they move.
#[derive(Clone, Debug, PartialEq)]
pub struct FramePart {
    /// The storeys.
    pub storeys: Vec<StoreyPart>,
    /// What `axial_force` is.
    pub axial: Axial,
    /// What the stiffness acts on.
    pub convention: Convention,
    /// Directions in the order of the file; those that only a survey names follow, with unknown stiffness.
    /// At least one.
    pub directions: Vec<DirectionPart>,
    /// Acceleration of gravity, m/s².
    pub gravity_m_s2: f64,
}

impl FramePart {
    /// The frame, the same in each direction, each input with the value that `pick` chooses.
    ///
    /// # Errors
    /// None with the file's own values, which are checked on reading; [`StructureError`] if a picked one is
    /// impossible.
    pub fn build(&self, pick: Pick<'_>) -> Result<Frame, StructureError> {
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
        Frame::new(storeys, self.convention)
    }

    /// Stiffness of each storey in a direction, N/m, lowest first; `None` if it is unknown or there is no such
    /// direction.
    pub fn stiffness_n_m(&self, direction: &str, pick: Pick<'_>) -> Option<Vec<f64>> {
        let named = self.directions.iter().find(|d| d.name == direction)?;
        Some(named.stiffness.as_ref()?.iter().map(pick).collect())
    }

    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        for storey in &self.storeys {
            all.extend([storey.heaviness.quantity(), &storey.height]);
            all.extend(&storey.axial_force);
        }
        let stiffness = self.directions.iter().filter_map(|d| d.stiffness.as_ref());
        all.extend(stiffness.flatten());
    }
}
