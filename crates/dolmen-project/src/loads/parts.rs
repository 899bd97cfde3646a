//! Parts of a structure that loads act on.

use crate::chain::LinkPart;
use crate::content::Structure;
use crate::error::Fault;
use crate::file_number::At;
use crate::measure::Measure;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::wrong::{Common, WrongLoads};
use dolmen_words::message::Both;
use dolmen_words::nearest;

/// Parts that loads can act on: how lists of them are called, and their names.
pub(super) struct Parts<'a> {
    pub(super) list: &'static str,
    pub(super) names: Vec<Option<&'a str>>,
    /// Height of the lower and upper end of each above the ground, m.
    pub(super) ends_m: Vec<[f64; 2]>,
    /// Whether the width of each across the wind is known.
    pub(super) has_width: Vec<bool>,
}

/// The parts of a structure that can be loaded; `None` where loads are not read.
pub(super) fn parts(structure: &Structure) -> Option<Parts<'_>> {
    match structure {
        Structure::Chain(part) => Some(Parts {
            list: "links",
            names: part.links.iter().map(|link| link.name.as_deref()).collect(),
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
        Structure::Frame(_) | Structure::Stack(_) | Structure::Building(_) | Structure::Survey => None,
    }
}

/// The number of a part, from 0, by its name or as "links[2]".
pub(super) fn part_of(reader: &mut Reader, raw: &At<String>, path: &str, parts: &Parts<'_>) -> Option<usize> {
    let written = raw.value.trim();
    let named: Vec<usize> = (0..parts.names.len())
        .filter(|i| parts.names[*i] == Some(written))
        .collect();
    let numbered = written
        .strip_prefix(parts.list)
        .and_then(|rest| rest.strip_prefix('[')?.strip_suffix(']')?.parse::<usize>().ok())
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
            let help: Both = match nearest(written, parts.names.iter().flatten().copied()) {
                Some(near) if several.is_empty() => Common::DidYouMean {
                    near: near.to_string(),
                }
                .into(),
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

/// Refuses a height that is not on its part.
pub(super) fn on_part(reader: &mut Reader, height: &Quantity, part: usize, parts: &Parts<'_>) -> Option<()> {
    let [bottom_m, top_m] = parts.ends_m[part];
    if (bottom_m..=top_m).contains(&height.value) {
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
            .help(WrongLoads::HeightsCountFromLowest),
    );
    None
}
