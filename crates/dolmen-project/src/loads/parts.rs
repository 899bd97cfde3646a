//! Parts of a structure for loads.

use crate::chain::LinkPart;
use crate::content::Structure;
use crate::error::Fault;
use crate::file_number::At;
use crate::frame::FramePart;
use crate::measure::Measure;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::stack::StackPart;
use crate::wrong::{Common, WrongLoads};
use dolmen::signal::Component;
use dolmen_words::message::Both;
use dolmen_words::nearest;

/// Smallest difference of two heights, m: three courses of 0.3 m end at 0.9 m except for rounding. Our choice.
const ROUNDING_M: f64 = 1e-9;

/// Parts that can be loaded: the name of their list, and their own names.
pub(super) struct Parts {
    /// Whether they are the stones of a stack, with forces in three dimensions.
    pub(super) are_stones: bool,
    /// Whether forces act on them in two directions, along and across.
    pub(super) have_two_axes: bool,
    /// Whether they are the floors of a building.
    pub(super) are_floors: bool,
    /// The directions of a frame and the component along each; `None` for other structures.
    pub(super) directions: Option<Vec<(String, Option<Component>)>>,
    /// Largest height of the middle of an area above its part, m: a roof is above its columns.
    pub(super) above_m: f64,
    pub(super) list: &'static str,
    pub(super) names: Vec<Option<String>>,
    /// Height of the lower and upper end of each above the ground, m.
    pub(super) ends_m: Vec<[f64; 2]>,
    /// Whether the width of each across the wind is known.
    pub(super) has_width: Vec<bool>,
}

/// The parts of a structure that can be loaded; `None` if it takes no loads.
pub(super) fn parts(structure: &Structure) -> Option<Parts> {
    match structure {
        Structure::Chain(part) => Some(Parts {
            have_two_axes: part.has_two_axes(),
            are_stones: false,
            are_floors: false,
            directions: None,
            above_m: 0.0,
            list: "links",
            names: part.links.iter().map(|link| link.name.clone()).collect(),
            ends_m: {
                let mut top_m = 0.0;
                let ends = |link: &LinkPart| {
                    let bottom_m = top_m;
                    top_m += link.length.value;
                    [bottom_m, top_m]
                };
                part.links.iter().map(ends).collect()
            },
            has_width: part
                .links
                .iter()
                .map(|link| link.breadth.is_some() || link.bed_width.is_some())
                .collect(),
        }),
        Structure::Stack(part) => Some(stones(part)),
        Structure::Building(part) => Some(Parts {
            have_two_axes: false,
            are_stones: false,
            are_floors: true,
            directions: None,
            above_m: 0.0,
            list: "floors",
            names: part.floor_names().into_iter().map(Some).collect(),
            ends_m: Vec::new(),
            has_width: part.floors.iter().map(|floor| floor.outline.is_some()).collect(),
        }),
        Structure::Frame(part) => Some(storeys(part)),
        Structure::Survey => None,
    }
}

/// The storeys of a frame: the width of their walls and roofs is unknown.
fn storeys(part: &FramePart) -> Parts {
    let mut top_m = 0.0;
    let ends = part.storeys.iter().map(|storey| {
        let bottom_m = top_m;
        top_m += storey.height.value;
        [bottom_m, top_m]
    });
    let ends_m: Vec<[f64; 2]> = ends.collect();
    let directions = part.directions.iter();
    Parts {
        are_stones: false,
        have_two_axes: part.directions.len() > 1,
        are_floors: false,
        directions: Some(directions.map(|own| (own.name.clone(), own.along)).collect()),
        above_m: top_m,
        list: "storeys",
        names: part.storeys.iter().map(|storey| storey.name.clone()).collect(),
        has_width: vec![false; ends_m.len()],
        ends_m,
    }
}

/// The stones of a stack; empty for a stack that cannot be built, which another check rejects.
fn stones(part: &StackPart) -> Parts {
    let built = part.build(&mut Quantity::nominal);
    let blocks = built.as_ref().map_or(&[][..], |stack| stack.blocks());
    Parts {
        have_two_axes: false,
        are_stones: true,
        are_floors: false,
        directions: None,
        above_m: 0.0,
        list: "blocks",
        names: blocks.iter().map(|block| Some(block.name.clone())).collect(),
        ends_m: blocks
            .iter()
            .map(|block| block.solid.bounds_m().map(|end| end[2]))
            .collect(),
        has_width: vec![true; blocks.len()],
    }
}

/// The number of a part, from 0, by its name or as "links[2]".
pub(super) fn part_of(reader: &mut Reader, raw: &At<String>, path: &str, parts: &Parts) -> Option<usize> {
    let written = raw.value.trim();
    if parts.names.is_empty() {
        return None;
    }
    let named: Vec<usize> = (0..parts.names.len())
        .filter(|i| parts.names[*i].as_deref() == Some(written))
        .collect();
    let number = match parts.are_floors {
        true => Some(written), // an entry of the list may be several floors
        false => written
            .strip_prefix(parts.list)
            .and_then(|rest| rest.strip_prefix('[')?.strip_suffix(']')),
    };
    let numbered = number
        .and_then(|number| number.parse::<usize>().ok())
        .and_then(|number| number.checked_sub(1))
        .filter(|i| *i < parts.names.len());
    match (named.as_slice(), numbered) {
        ([one], _) => Some(*one),
        ([], Some(i)) => Some(i),
        (several, _) => {
            let problem = match several.is_empty() {
                true => WrongLoads::ThereIsNoPart {
                    path: path.to_string(),
                    written: written.to_string(),
                },
                false => WrongLoads::PartsAreCalled {
                    path: path.to_string(),
                    count: several.len().to_string(),
                    written: written.to_string(),
                },
            };
            let help: Both = match nearest(written, parts.names.iter().flatten().map(String::as_str)) {
                Some(near) if several.is_empty() => Common::DidYouMean(near.to_string()).into(),
                _ if parts.are_stones => WrongLoads::WriteNameOfStone.into(),
                _ if parts.are_floors => WrongLoads::WriteFloor(parts.names.len().to_string()).into(),
                _ => WrongLoads::WriteForLowestTo {
                    list: parts.list.to_string(),
                    count: parts.names.len().to_string(),
                }
                .into(),
            };
            reader.fault(Fault::new(raw.span.clone(), path, problem).help(help));
            None
        }
    }
}

/// Rejects a height that is neither on its part nor at most `above_m` above its top.
pub(super) fn on_part(
    reader: &mut Reader,
    height: &Quantity,
    (part, above_m): (usize, f64),
    parts: &Parts,
) -> Option<()> {
    let [bottom_m, top_m] = parts.ends_m[part];
    let top_m = top_m + above_m;
    if (bottom_m - ROUNDING_M..=top_m + ROUNDING_M).contains(&height.value) {
        return Some(());
    }
    let message = WrongLoads::IsNotOn {
        path: height.path.to_string(),
        written: height.written.to_string(),
        list: parts.list.to_string(),
        part: (part + 1).to_string(),
    };
    let [bottom, top] = [bottom_m, top_m].map(|m| reader.echo(m, Measure::Length));
    let fault = Fault::new(reader.place(&height.path), &height.path, message);
    reader.fault(
        fault
            .allowed(WrongLoads::MustBeTo {
                bottom: bottom.to_string(),
                top: top.to_string(),
            })
            .help(match parts.directions {
                Some(_) => WrongLoads::HeightsCountFromFeet,
                None => WrongLoads::HeightsCountFromLowest,
            }),
    );
    None
}
