//! Patterns over all links and joints of a chain that look like a mistake.
//!
//! | pattern | real flagpoles and columns | bound |
//! |:--|:--|:--|
//! | mass per length, lowest to top | falls, or the same | grows at every link, 1.5 in all |
//! | centre of mass / length | below or near 1/2: stones taper | all above 1/2, 0.52 on average |
//! | side of the lowest link as stone / height | 1/40 to 1/4 | 1/45 to 1/2, of three links and more |
//! | width of beds / side as stone | 0.7 to 1.5 | 0.4 to 2.5, mean of all |
//! | mass per length / mean of both neighbours | 1/4 to 4 | 1/6 to 6 |
//! | stiffness / (weight × height) | 0.17 (Choi 2021, too little) to 200 (full beds) | all below 0.12, all above 500 |

use super::part::{ChainPart, LinkPart};
use crate::doubted::Doubted;
use crate::reader::Reader;
use crate::usual::mass_kg;
use crate::usual_numbers::{metres, ratio};

/// Fewest links that have an order. Our choice.
const LINKS_LEAST: usize = 3;
const UPWARDS: f64 = 1.5;
const CENTROID_MEAN: f64 = 0.52;
const STONE_KG_M3: f64 = 2500.0;
const SIDE_TO_HEIGHT: [f64; 2] = [1.0 / 45.0, 0.5];
const BED_TO_SIDE: [f64; 2] = [0.4, 2.5];
const NEIGHBOURS: f64 = 6.0;
const SHARE: [f64; 2] = [0.12, 500.0];

/// The chain as numbers.
struct Chain<'a> {
    part: &'a ChainPart,
    /// Mass of each link, kg.
    masses_kg: Vec<f64>,
    /// Mass per length of each link, kg/m.
    per_length: Vec<f64>,
    /// Height of the whole, m.
    height_m: f64,
}

pub(crate) fn doubt_chain(reader: &mut Reader, part: &ChainPart) {
    let masses_kg: Vec<f64> = part
        .links
        .iter()
        .map(|link| mass_kg(&link.heaviness, part.gravity_m_s2))
        .collect();
    let lengths = part.links.iter().map(|link| link.length.value);
    let chain = Chain {
        part,
        per_length: masses_kg
            .iter()
            .zip(lengths.clone())
            .map(|(mass, length)| mass / length)
            .collect(),
        masses_kg,
        height_m: lengths.sum(),
    };
    if chain.part.links.len() >= LINKS_LEAST {
        order(reader, &chain);
        centroids(reader, &chain);
        sides(reader, &chain);
        neighbours(reader, &chain);
    }
    beds(reader, &chain);
    joints(reader, &chain);
}

fn order(reader: &mut Reader, chain: &Chain<'_>) {
    let grows = chain.per_length.windows(2).all(|pair| pair[1] > pair[0]);
    if let (Some(first), Some(last)) = (chain.per_length.first(), chain.per_length.last())
        && grows
        && last / first > UPWARDS
    {
        reader.doubt("links", Doubted::ChainOrder(ratio(last / first)));
    }
}

fn centroids(reader: &mut Reader, chain: &Chain<'_>) {
    let share = |link: &LinkPart| link.centroid.value / link.length.value;
    let links = &chain.part.links;
    let mean = links.iter().map(share).sum::<f64>() / links.len() as f64;
    if links.iter().all(|link| share(link) > 0.5) && mean > CENTROID_MEAN {
        reader.doubt("links", Doubted::CentroidsFromTop(ratio(mean)));
    }
}

fn sides(reader: &mut Reader, chain: &Chain<'_>) {
    let Some(lowest) = chain.per_length.first() else {
        return;
    };
    let side_m = (lowest / STONE_KG_M3).sqrt();
    let (width, height) = (metres(side_m), metres(chain.height_m));
    let share = side_m / chain.height_m;
    if share < SIDE_TO_HEIGHT[0] {
        reader.doubt("links", Doubted::Thin { width, height });
    } else if share > SIDE_TO_HEIGHT[1] {
        reader.doubt("links", Doubted::Thick { width, height });
    }
}

/// A link that differs from both of its neighbours; a link at an end has one neighbour.
fn neighbours(reader: &mut Reader, chain: &Chain<'_>) {
    for middle in 1..chain.per_length.len().saturating_sub(1) {
        let [below, own, above] = [middle - 1, middle, middle + 1].map(|i| chain.per_length[i]);
        let against = own / (below * above).sqrt();
        if !(1.0 / NEIGHBOURS..=NEIGHBOURS).contains(&against) {
            let path = &chain.part.links[middle].heaviness.quantity().path;
            reader.doubt(
                path,
                Doubted::LinkOdd {
                    path: path.clone(),
                    ratio: ratio(against),
                },
            );
        }
    }
}

fn beds(reader: &mut Reader, chain: &Chain<'_>) {
    let each = chain.part.links.iter().zip(&chain.per_length);
    let ratios: Vec<f64> = each
        .filter_map(|(link, per_length)| {
            Some(link.bed_width.as_ref()?.value / (per_length / STONE_KG_M3).sqrt())
        })
        .collect();
    if ratios.is_empty() {
        return;
    }
    let mean = (ratios.iter().map(|of| of.ln()).sum::<f64>() / ratios.len() as f64).exp();
    if !(BED_TO_SIDE[0]..=BED_TO_SIDE[1]).contains(&mean) {
        reader.doubt("links", Doubted::Beds(ratio(mean)));
    }
}

fn joints(reader: &mut Reader, chain: &Chain<'_>) {
    let Some(joints) = &chain.part.joints else { return };
    let links = &chain.part.links;
    let count = joints.len().min(links.len());
    let share = |i: usize| {
        let weight_n = chain.masses_kg[i..].iter().sum::<f64>() * chain.part.gravity_m_s2;
        let height_m = links[i..].iter().map(|link| link.length.value).sum::<f64>();
        joints[i].stiffness.value / (weight_n * height_m)
    };
    let (least, most) = (0..count)
        .map(share)
        .fold((f64::INFINITY, 0.0_f64), |(least, most), of| {
            (least.min(of), most.max(of))
        });
    if count > 0 && most < SHARE[0] {
        reader.doubt("joints", Doubted::WeakJoints(ratio(most)));
    } else if count > 0 && least > SHARE[1] {
        reader.doubt("joints", Doubted::StiffJoints(ratio(least)));
    }
}
