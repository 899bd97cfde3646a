//! Side supports of a chain: posts that hold a pole at a height, tightly or with a gap.

use super::axis::ChainAxis;
use super::part::LinkPart;
use super::support_part::ChainSupportPart;
use crate::error::Fault;
use crate::file_number::At;
use crate::file_way::WayRaw;
use crate::measure::{Bound, Measure};
use crate::needed::listed;
use crate::reader::Reader;
use crate::stack::SideSupportRaw;
use crate::usual::{guess, rounded, unit_of};
use crate::wrong::WrongChain;

/// Largest gap between a pole and a post over the height of contact: a pole leans by 1/10 at its end. Our choice.
const GAP_SHARE_MOST: f64 = 0.2;
/// Least stiffness of a post times its height squared over weight × height of the pole: about 1 keeps a pole upright. Our choice.
const HOLD_SHARE_LEAST: f64 = 0.01;
/// Largest stiffness of a post, N/m: a hundred times that of a granite cantilever half a metre thick and two metres high. Our choice.
const STIFFNESS_MOST_N_M: f64 = 1e10;

/// Probable slips in the posts of a pole that weighs `weight_n`.
pub(super) fn judge_side_supports(
    reader: &mut Reader,
    supports: &[ChainSupportPart],
    weight_n: f64,
    height_m: f64,
) {
    for support in supports {
        if let Some(gap) = &support.gap {
            let share = gap.value / support.height.value;
            if share > GAP_SHARE_MOST {
                let message = WrongChain::GapOfPost {
                    path: gap.path.clone(),
                    written: gap.written.clone(),
                    share: rounded(share),
                };
                reader.slip(&gap.path, message, guess(1000.0, unit_of(gap)));
            }
        }
        let stiffness = &support.stiffness;
        let share = stiffness.value * support.height.value.powi(2) / (weight_n * height_m);
        if share < HOLD_SHARE_LEAST || stiffness.value > STIFFNESS_MOST_N_M {
            let message = WrongChain::StiffnessOfPost {
                path: stiffness.path.clone(),
                written: stiffness.written.clone(),
                share: rounded(share),
                product: reader.echo(weight_n * height_m, Measure::Moment),
            };
            reader.slip(&stiffness.path, message, WrongChain::StiffnessOfPostUnits);
        }
    }
}

pub(super) fn side_supports(
    reader: &mut Reader,
    raw: Option<&[At<SideSupportRaw>]>,
    links: &[LinkPart],
) -> Option<Vec<ChainSupportPart>> {
    let top_m: f64 = links.iter().map(|link| link.length.value).sum();
    listed(reader, raw, "side_supports", |reader, raw, path| {
        side_support(reader, raw, path, top_m)
    })
}

fn side_support(
    reader: &mut Reader,
    raw: &At<SideSupportRaw>,
    path: &str,
    top_m: f64,
) -> Option<ChainSupportPart> {
    let keys = &raw.value;
    let of_stacks = [
        ("block", keys.block.is_some()),
        ("position", keys.position.is_some()),
    ];
    if let Some((key, _)) = of_stacks.into_iter().find(|(_, is_given)| *is_given) {
        let key = format!("{path}.{key}");
        let fault = Fault::new(reader.place(path), &key, WrongChain::SupportOfStack(key.clone()));
        reader.fault(fault.help(WrongChain::SupportKeys));
        return None;
    }
    let axis = match &keys.direction {
        None => None,
        Some(raw) => Some(axis(reader, raw, &format!("{path}.direction"))?),
    };
    let mut of =
        |raw, key: &str, measure, bound| reader.quantity(raw, &format!("{path}.{key}"), measure, bound);
    let height = of(keys.height.as_ref(), "height", Measure::Length, Bound::Positive);
    let gap = of(keys.gap.as_ref(), "gap", Measure::Length, Bound::NotNegative);
    let stiffness = of(
        keys.stiffness.as_ref(),
        "stiffness",
        Measure::StoreyStiffness,
        Bound::Positive,
    );
    for (key, is_given) in [
        ("height", keys.height.is_some()),
        ("stiffness", keys.stiffness.is_some()),
    ] {
        if !is_given {
            let key = format!("{path}.{key}");
            let fault = Fault::new(reader.place(path), &key, WrongChain::SupportNeeds(key.clone()));
            reader.fault(fault.help(WrongChain::SupportKeys));
        }
    }
    if keys.gap.is_some() {
        gap.as_ref()?;
    }
    let (height, stiffness) = (height?, stiffness?);
    if height.value > top_m {
        let message = WrongChain::SupportAboveTop {
            path: height.path.clone(),
            written: height.written.clone(),
            top: reader.echo(top_m, Measure::Length),
        };
        let fault = Fault::new(reader.place(&height.path), &height.path, message);
        reader.fault(fault.help(WrongChain::SupportHeight));
        return None;
    }
    Some(ChainSupportPart {
        height,
        stiffness,
        gap,
        axis,
    })
}

/// The direction in which it holds the chain.
fn axis(reader: &mut Reader, raw: &At<WayRaw>, path: &str) -> Option<ChainAxis> {
    match &raw.value {
        WayRaw::Axis(name) if name == ChainAxis::Along.name() => Some(ChainAxis::Along),
        WayRaw::Axis(name) if name == ChainAxis::Across.name() => Some(ChainAxis::Across),
        WayRaw::Axis(_) | WayRaw::Vector(_) => {
            let message = WrongChain::SupportDirection(path.to_owned());
            let fault = Fault::new(raw.span.clone(), path, message);
            reader.fault(fault.help(WrongChain::SupportDirections));
            None
        }
    }
}
