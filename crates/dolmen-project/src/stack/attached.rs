//! Steps below a roof stone (옥개받침) and a mast on a finial (찰주): parts of their block that do not move by themselves.

use super::attached_part::{CornicePart, MastPart};
use super::file::{BlockRaw, CorniceRaw, MastRaw};
use super::part::{BlockPart, ShapePart};
use crate::error::Fault;
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::quantity::{Pick, Quantity};
use crate::reader::Reader;
use crate::wrong::WrongStack;
use dolmen::structure::stack::{Block, Body, Placement, Solid, StackError};

/// Most steps of a cornice. Our choice: pagodas have three to five.
const STEPS_MOST: usize = 20;

/// The cornice of a block, `Some(None)` if the file gives none.
pub(super) fn cornice(
    reader: &mut Reader,
    block: &BlockRaw,
    path: &str,
    shape: Option<&ShapePart>,
) -> Option<Option<CornicePart>> {
    let Some(raw) = &block.cornice else {
        return Some(None);
    };
    let path = format!("{path}.cornice");
    let refuse = |reader: &mut Reader, message: WrongStack, help: WrongStack| {
        reader.fault(Fault::new(raw.span.clone(), &path, message).help(help));
        None
    };
    if block.openings.is_some() {
        let message = WrongStack::CorniceWithOpenings { path: path.clone() };
        return refuse(reader, message, WrongStack::SplitStone);
    }
    let part = cornice_part(reader, raw, &path)?;
    let shape = shape?;
    let Some(least) = shape.least_width() else {
        let message = WrongStack::CorniceOfShape { path: path.clone() };
        return refuse(reader, message, WrongStack::CorniceShapes);
    };
    let left_m = least.value - 2.0 * f64::from(part.steps) * part.setback.value;
    if left_m <= 0.0 {
        let message = WrongStack::CorniceLeavesNothing {
            path: path.clone(),
            steps: part.steps.to_string(),
            setback: part.setback.written.clone(),
            width: least.written.clone(),
        };
        return refuse(reader, message, WrongStack::CorniceBed);
    }
    Some(Some(part))
}

fn cornice_part(reader: &mut Reader, raw: &At<CorniceRaw>, path: &str) -> Option<CornicePart> {
    let of = &raw.value;
    let steps = reader.count(of.steps.as_ref(), &format!("{path}.steps"), 1, STEPS_MOST);
    let mut length =
        |raw, key: &str| reader.quantity(raw, &format!("{path}.{key}"), Measure::Length, Bound::Positive);
    let (height, setback) = (
        length(of.height.as_ref(), "height"),
        length(of.setback.as_ref(), "setback"),
    );
    Some(CornicePart {
        steps: steps.and_then(|steps| u32::try_from(steps).ok())?,
        height: height?,
        setback: setback?,
    })
}

/// The mast of a block, `Some(None)` if the file gives none.
pub(super) fn mast(reader: &mut Reader, raw: Option<&At<MastRaw>>, path: &str) -> Option<Option<MastPart>> {
    let Some(raw) = raw else { return Some(None) };
    let of = &raw.value;
    let before = reader.faults.len();
    let mut read = |raw, key: &str, measure| {
        reader.quantity(raw, &format!("{path}.mast.{key}"), measure, Bound::Positive)
    };
    let (height, diameter, density) = (
        read(of.height.as_ref(), "height", Measure::Length),
        read(of.diameter.as_ref(), "diameter", Measure::Length),
        read(of.density.as_ref(), "density", Measure::Density),
    );
    (reader.faults.len() == before).then_some(())?;
    Some(Some(MastPart {
        height: height?,
        diameter: diameter?,
        density,
    }))
}

/// Rejects a mast on a block that carries another.
pub(super) fn masts_on_top(reader: &mut Reader, list: &[At<BlockRaw>], blocks: &[Option<BlockPart>]) {
    for (i, raw) in list.iter().enumerate() {
        let Some(mast) = &raw.value.mast else { continue };
        let above = blocks
            .iter()
            .flatten()
            .find(|block| block.on.contains(&Body::Block(i)));
        if let Some(above) = above {
            let path = format!("blocks[{}].mast", i + 1);
            let message = WrongStack::MastUnderBlock {
                path: path.clone(),
                above: above.name.clone(),
            };
            let fault = Fault::new(mast.span.clone(), &path, message);
            reader.fault(fault.help(WrongStack::MastOnTop));
        }
    }
}

impl ShapePart {
    /// The smaller width of its base, for a box, frustum or prism.
    fn least_width(&self) -> Option<&Quantity> {
        match self {
            ShapePart::Box { width, depth, .. } | ShapePart::Frustum { width, depth, .. } => Some(
                depth
                    .as_ref()
                    .filter(|depth| depth.value < width.value)
                    .unwrap_or(width),
            ),
            ShapePart::Prism { width, .. } => Some(width),
            ShapePart::Drum { .. } | ShapePart::Points { .. } | ShapePart::Mesh(_) => None,
        }
    }

    /// A step of this height under its base, its sides set back.
    fn step(&self, back_m: f64, height_m: f64, pick: Pick<'_>) -> Result<Solid, StackError> {
        match self {
            ShapePart::Prism { sides, width, .. } => {
                Solid::prism(*sides, pick(width) - 2.0 * back_m, height_m)
            }
            ShapePart::Box { width, depth, .. } | ShapePart::Frustum { width, depth, .. } => {
                let width_m = pick(width);
                let depth_m = depth.as_ref().map_or(width_m, &mut *pick);
                Solid::cuboid(width_m - 2.0 * back_m, depth_m - 2.0 * back_m, height_m)
            }
            // refused on reading
            ShapePart::Drum { .. } | ShapePart::Points { .. } | ShapePart::Mesh(_) => self.solid(pick),
        }
    }
}

fn raised(solid: &Solid, by_m: f64) -> Solid {
    solid.placed(&Placement {
        position_m: [0.0, 0.0, by_m],
        ..Placement::default()
    })
}

impl BlockPart {
    /// Its shape with its cornice below.
    pub(super) fn on_cornice(&self, solid: Solid, pick: Pick<'_>) -> Result<Solid, StackError> {
        let Some(cornice) = &self.cornice else {
            return Ok(solid);
        };
        let (height_m, setback_m) = (pick(&cornice.height), pick(&cornice.setback));
        let each_m = height_m / f64::from(cornice.steps);
        let mut pieces = Vec::new();
        for step in 0..cornice.steps {
            let back_m = setback_m * f64::from(cornice.steps - step);
            let piece = self.shape.step(back_m, each_m, &mut *pick)?;
            pieces.push(raised(&piece, each_m * f64::from(step)));
        }
        pieces.push(raised(&solid, height_m));
        Solid::joined(&pieces)
    }

    /// The shape with its mast on the middle of its top, with the mean density of both.
    pub(super) fn under_mast(
        &self,
        solid: Solid,
        density_kg_m3: f64,
        pick: Pick<'_>,
    ) -> Result<Block, StackError> {
        let name = self.name.clone();
        let Some(mast) = &self.mast else {
            return Ok(Block {
                name,
                solid,
                density_kg_m3,
            });
        };
        let cylinder = Solid::drum(pick(&mast.diameter), pick(&mast.height))?;
        let ratio = match &mast.density {
            Some(own) if density_kg_m3 > 0.0 => pick(own) / density_kg_m3,
            _ => 1.0,
        };
        let top_m = solid.bounds_m()[1][2];
        let with = solid.with_mast(&raised(&cylinder, top_m), ratio)?;
        Ok(Block {
            name,
            solid: with.solid,
            density_kg_m3: density_kg_m3 * with.mean_density_ratio,
        })
    }

    /// Numbers of its cornice and its mast.
    pub(super) fn attached_inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        if let Some(cornice) = &self.cornice {
            all.extend([&cornice.height, &cornice.setback]);
        }
        if let Some(mast) = &self.mast {
            all.extend([&mast.height, &mast.diameter]);
            all.extend(&mast.density);
        }
    }
}
