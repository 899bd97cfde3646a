//! The parts of a structure by their names in reports, photographs and inspections.

use crate::content::Structure;
use crate::quantity::Quantity;

/// The names of all parts, lowest first.
#[derive(Clone, Debug, Default)]
pub(crate) struct PartNames(pub(crate) Vec<String>);

impl PartNames {
    pub(crate) fn of(structure: &Structure) -> Self {
        PartNames(structure.part_names())
    }
}

impl Structure {
    /// The names of its parts, lowest first; a part without a name has its number, "3". Empty for a survey only, and for a stack that
    /// cannot be built.
    pub fn part_names(&self) -> Vec<String> {
        fn named<'a>(names: impl Iterator<Item = Option<&'a String>>) -> Vec<String> {
            let each = (1..).zip(names);
            each.map(|(number, name)| name.cloned().unwrap_or_else(|| number.to_string()))
                .collect()
        }
        match self {
            Structure::Chain(part) => named(part.links.iter().map(|link| link.name.as_ref())),
            Structure::Frame(part) => named(part.storeys.iter().map(|storey| storey.name.as_ref())),
            Structure::Building(part) => part.floor_names(),
            Structure::Stack(part) => {
                let built = part.build(&mut Quantity::nominal);
                built.map_or(Vec::new(), |stack| {
                    stack.blocks().iter().map(|block| block.name.clone()).collect()
                })
            }
            Structure::Survey => Vec::new(),
        }
    }
}
