//! Faults that the library finds in a structure that was read without a fault.

use super::building;
use super::content::Structure;
use super::error::Fault;
use super::quantity::Quantity;
use super::reader::Reader;
use super::wrong::{StackSlip, said};
use dolmen::structure::StructureError;
use dolmen_words::message::Both;

/// Further faults that the library finds: storeys whose axial force grows upwards.
pub(super) fn buildable(reader: &mut Reader, structure: Option<&mut Structure>) {
    if !reader.faults.is_empty() {
        return;
    }
    let (built, path) = match structure {
        Some(Structure::Chain(chain)) => (chain.build(&mut Quantity::nominal).map(|_| ()), "links"),
        Some(Structure::Frame(frame)) => (frame.build(&mut Quantity::nominal).map(|_| ()), "storeys"),
        Some(Structure::Stack(stack)) => {
            let built = match stack.is_loose {
                true => stack.build_loose(&mut Quantity::nominal),
                false => stack.build(&mut Quantity::nominal),
            };
            if let Err(why) = built {
                let path = why.path();
                let fault = Fault::new(reader.place(path), path, Both::from(why.sentence()));
                reader.fault(match stack.tilt_that_overlaps(&why) {
                    Some(tilt) => fault.help(StackSlip::TiltedIntoBed {
                        path: tilt.path.clone(),
                        written: tilt.written.clone(),
                    }),
                    None => fault,
                });
            }
            return;
        }
        Some(Structure::Building(part)) => {
            building::buildable(reader, part);
            return;
        }
        Some(Structure::Survey) | None => return,
    };
    if let Err(why) = built {
        let path = match &why {
            StructureError::AxialOrder { storey, .. } => format!("storeys[{storey}].axial_force"),
            _ => path.to_owned(),
        };
        reader.fault(Fault::new(reader.place(&path), &path, said(&why)));
    }
}
