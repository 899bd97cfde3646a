//! Probable slips of unit: values that are possible in themselves, but not beside each other or in this world.
//!
//! A slip between units of one kind is a factor of 1000 (mm, kN, t), seldom 10, 100 or 57.3. Each bound below lies
//! between the widest real structures we know and the mildest slip of 1000, so that neither is mistaken for the
//! other. What they refuse can be let pass with `allow`. Slips of 10 to 100 cannot be told from real structures.
//!
//! | what is compared | real structures | after a slip of 1000 | bound |
//! |:--|:--|:--|:--|
//! | mass per length of a link / median of the others | 1/92 (iron finial on stone drums) to 13 | 76 and more | 200 |
//! | side of a link as a block of stone / height of the whole | 0.006 (antenna tube) to 1.5 (squat statue) | ≤ 0.002, ≥ 1.9 (flagpole) | 0.004 to 1.5 |
//! | length of a link / median of the others | 1/70 to 10 | 14 and more | 100 |
//! | joint stiffness / (P H), over the median of the others | 1/100 to 100 (wedged base, loose tops) | 10 and more | 300 |
//! | mass of a storey | 1 t (open pavilion) to 20 000 t | | same |
//! | axial force / weight above | 0.5 to 2 (columns and loads counted differently) | ≤ 0.002, ≥ 500 | 0.2 to 5 |
//! | √(k/m)/2π of a storey | 0.3 to 30 Hz | a factor of 32 | 0.2 to 60 Hz |
//! | measured frequency | 0.1 Hz (high tower) to 100 Hz (small stone) | | 0.05 to 200 Hz |

use super::chain::{ChainPart, Heaviness, LinkPart};
use super::content::Structure;
use super::frame::{Axial, FramePart, StoreyPart};
use super::quantity::Quantity;
use super::reader::{Measure, Reader, short};
use super::survey::Survey;

/// Density of stone that a link is compared with, kg/m³: granite 2600, marble 2700, sandstone 2300.
const STONE_KG_M3: f64 = 2500.0;
/// Mass per length of a stone shaft half a metre wide, kg/m: of two unlike links the one further from it is doubted.
const SHAFT_KG_M: f64 = 600.0;
/// Mass per length of a link over the median of the others, either way.
const LINK_RATIO_MOST: f64 = 200.0;
/// Side of a link, as a square block of stone, over the height of the whole.
const LINK_SIDE_TO_HEIGHT: (f64, f64) = (0.004, 1.5);
/// Length of a link, m.
const LINK_LENGTH_M: (f64, f64) = (0.005, 100.0);
/// Length of a link over the median of the others, either way.
const LENGTH_RATIO_MOST: f64 = 100.0;
/// A centre of mass nearer to the lower joint than this share of the length, but not 0.
const CENTROID_SHARE_LEAST: f64 = 0.02;
/// Density of a link with a breadth, taken as square in plan, kg/m³: hollow timber to solid iron, each with room.
const BOX_DENSITY_KG_M3: (f64, f64) = (20.0, 50_000.0);
/// Radius of gyration over the larger of length and side as a block of stone: 0.29 for rod and block.
const GYRATION: (f64, f64) = (0.03, 3.0);
/// Width of a bed over the side of its link as a block of stone.
const BED_RATIO_MOST: f64 = 30.0;
/// Least stiffness of a joint over weight × height above it: 1 is about what keeps a chain upright.
const JOINT_SHARE_LEAST: f64 = 0.01;
/// That share over the median of the other joints', either way.
const JOINT_RATIO_MOST: f64 = 300.0;
/// Mass of a storey, kg.
const STOREY_MASS_KG: (f64, f64) = (1e3, 2e7);
/// Height of a storey, m.
const STOREY_HEIGHT_M: (f64, f64) = (0.1, 50.0);
/// Axial force over the weight that the storey carries. 0 leaves P-delta out and is not judged.
const AXIAL_SHARE: (f64, f64) = (0.2, 5.0);
/// How near two readings of axial forces must come to the weights to be the better one.
const AXIAL_MATCH: f64 = 0.25;
/// √(k/m)/2π of a storey, Hz.
const STOREY_FREQUENCY_HZ: (f64, f64) = (0.2, 60.0);
/// Measured frequency, Hz.
const FREQUENCY_HZ: (f64, f64) = (0.05, 200.0);
/// Damping ratio: ambient vibration of heritage has 0.005 to 0.1.
const DAMPING_RATIO_MOST: f64 = 0.3;
/// Gravity on Earth, m/s²: 9.78 at the equator, 9.83 at the poles, 9.76 on high mountains.
const GRAVITY_M_S2: (f64, f64) = (9.75, 9.85);

/// Reports every probable slip of what has been read.
pub(super) fn judge(
    reader: &mut Reader,
    gravity: Option<&Quantity>,
    structure: Option<&Structure>,
    surveys: &[Survey],
) {
    if let Some(gravity) = gravity
        && !within(gravity.value, GRAVITY_M_S2)
    {
        let message = format!(
            "gravity = {} is not that of the Earth, 9.78 to 9.83 m/s2",
            gravity.written
        );
        reader.slip(&gravity.path, message, guess(gravity.value / 9.81, "m/s2"));
    }
    match structure {
        Some(Structure::Chain(chain)) => judge_chain(reader, chain),
        Some(Structure::Frame(frame)) => judge_frame(reader, frame),
        Some(Structure::Survey) | None => {}
    }
    for survey in surveys {
        judge_modes(reader, survey);
    }
}

fn within(value: f64, range: (f64, f64)) -> bool {
    (range.0..=range.1).contains(&value)
}

/// The unit that would bring a value, `ratio` times what is plausible, back.
fn guess(ratio: f64, unit: &str) -> String {
    let (smaller, larger) = match unit {
        "N" | "kN" | "MN" => ("N", "MN"),
        "m" | "mm" | "cm" => ("mm", "km"),
        "kg" | "t" => ("kg", "t"),
        "Hz" => ("mHz", "kHz"),
        "m/s2" => return "did you mean gal or mm/s2? 9.81 m/s2 = 981 gal".to_owned(),
        _ => {
            return format!(
                "it is about {} times what others like it have: check its unit",
                rounded(ratio)
            );
        }
    };
    let meant = match (unit, ratio > 1.0) {
        ("kN", true) | ("t", true) | ("m", true) | ("MN", true) => smaller,
        ("N", false) => "kN",
        ("kg", false) => larger,
        ("mm" | "cm", false) => "m",
        _ => {
            return format!(
                "it is about {} times what others like it have: check its unit",
                rounded(ratio)
            );
        }
    };
    format!("did you mean {meant}?")
}

/// A ratio for a message: three significant digits, below 1 as a fraction.
fn rounded(ratio: f64) -> String {
    if ratio < 1.0 {
        return format!("1/{}", rounded(1.0 / ratio));
    }
    let exponent = ratio.log10().floor() as i32;
    let unit = 10f64.powi((exponent - 2).max(-2));
    short((ratio / unit).round() * unit)
}

/// The unit a quantity was written in, for a guess.
fn unit_of(quantity: &Quantity) -> &str {
    quantity.written.split_once(' ').map_or("", |(_, unit)| unit)
}

/// Median of all values but one; `None` if there is no other.
fn median_of_others(values: &[f64], but: usize) -> Option<f64> {
    let others = values.iter().enumerate().filter(|(i, _)| *i != but);
    let mut others: Vec<f64> = others.map(|(_, value)| *value).collect();
    others.sort_by(f64::total_cmp);
    let middle = others.len() / 2;
    match others.len() % 2 {
        1 => others.get(middle).copied(),
        _ => Some((others.get(middle.checked_sub(1)?)? * others.get(middle)?).sqrt()),
    }
}

/// Values that are `most` times above or below the median of the others. Of two values only one can be the odd one:
/// that further from `usual`.
fn odd_ones(values: &[f64], most: f64, usual: f64) -> Vec<usize> {
    let odd = |i: usize| {
        median_of_others(values, i).is_some_and(|median| {
            let ratio = values[i] / median;
            ratio > most || ratio < 1.0 / most
        })
    };
    let distance = |i: usize| (values[i] / usual).ln().abs();
    match values.len() {
        2 if odd(0) && distance(0) > distance(1) => vec![0],
        2 if odd(1) => vec![1],
        count => (0..count).filter(|i| odd(*i)).collect(),
    }
}

/// "388 × the link below" or "1/388 of the link above".
fn beside_neighbour(parts: &[&Quantity], i: usize, part: &str) -> String {
    let (other, place) = match i.checked_sub(1).and_then(|below| parts.get(below)) {
        Some(below) => (*below, "below"),
        None => match parts.get(i + 1) {
            Some(above) => (*above, "above"),
            None => return String::new(),
        },
    };
    let ratio = parts[i].value / other.value;
    if ratio >= 1.0 {
        format!("{} × the {part} {place}", rounded(ratio))
    } else {
        format!("{} of the {part} {place}", rounded(ratio))
    }
}

fn mass_kg(heaviness: &Heaviness, gravity_m_s2: f64) -> f64 {
    heaviness.mass_kg(gravity_m_s2, &mut Quantity::nominal)
}

fn judge_chain(reader: &mut Reader, chain: &ChainPart) {
    let lengths: Vec<&Quantity> = chain.links.iter().map(|link| &link.length).collect();
    if judge_lengths(reader, &lengths) {
        // Everything below divides by lengths.
        return;
    }
    let masses: Vec<f64> = chain
        .links
        .iter()
        .map(|link| mass_kg(&link.heaviness, chain.gravity_m_s2))
        .collect();
    judge_link_masses(reader, chain, &masses);
    for (link, mass_kg) in chain.links.iter().zip(&masses) {
        judge_link(reader, link, *mass_kg);
    }
    judge_joints(reader, chain, &masses);
}

/// Whether a length of a link is a probable slip.
fn judge_lengths(reader: &mut Reader, lengths: &[&Quantity]) -> bool {
    let values: Vec<f64> = lengths.iter().map(|length| length.value).collect();
    let odd = odd_ones(&values, LENGTH_RATIO_MOST, 1.0);
    let before = reader.faults.len();
    for (i, length) in lengths.iter().enumerate() {
        let (least, most) = LINK_LENGTH_M;
        if within(length.value, LINK_LENGTH_M) && !odd.contains(&i) {
            continue;
        }
        let beside = match beside_neighbour(lengths, i, "link") {
            beside if beside.is_empty() => format!("links are {least} to {most} m long"),
            beside => beside,
        };
        let message = format!("{} = {}, {beside}", length.path, length.written);
        let ratio = if length.value > 1.0 { 1000.0 } else { 0.001 };
        reader.slip(&length.path, message, guess(ratio, unit_of(length)));
    }
    reader.faults.len() > before
}

fn judge_link_masses(reader: &mut Reader, chain: &ChainPart, masses: &[f64]) {
    let height_m: f64 = chain.links.iter().map(|link| link.length.value).sum();
    let per_length: Vec<f64> = masses
        .iter()
        .zip(&chain.links)
        .map(|(mass, link)| mass / link.length.value)
        .collect();
    let odd = odd_ones(&per_length, LINK_RATIO_MOST, SHAFT_KG_M);
    let given: Vec<&Quantity> = chain.links.iter().map(|link| link.heaviness.quantity()).collect();
    for (i, quantity) in given.iter().enumerate() {
        let side_m = (per_length[i] / STONE_KG_M3).sqrt();
        let share = side_m / height_m;
        if odd.contains(&i) {
            let median = median_of_others(&per_length, i).unwrap_or(SHAFT_KG_M);
            let beside = beside_neighbour(&given, i, "link");
            let message = format!("{} = {}, {beside}", quantity.path, quantity.written);
            reader.slip(
                &quantity.path,
                message,
                guess(per_length[i] / median, unit_of(quantity)),
            );
        } else if !within(share, LINK_SIDE_TO_HEIGHT) {
            let message = format!(
                "{} = {}: as stone the link would be {} m wide, and the whole is {} m high",
                quantity.path,
                quantity.written,
                rounded_length(side_m),
                rounded_length(height_m)
            );
            let ratio = if share > 1.0 { 1000.0 } else { 0.001 };
            reader.slip(&quantity.path, message, guess(ratio, unit_of(quantity)));
        }
    }
}

fn rounded_length(length_m: f64) -> String {
    let exponent = length_m.log10().floor() as i32;
    let unit = 10f64.powi(exponent - 2);
    short((length_m / unit).round() * unit)
}

fn judge_link(reader: &mut Reader, link: &LinkPart, mass_kg: f64) {
    let length_m = link.length.value;
    let side_m = (mass_kg / (STONE_KG_M3 * length_m)).sqrt();
    let share = link.centroid.value / length_m;
    if share > 0.0 && share < CENTROID_SHARE_LEAST {
        let centroid = &link.centroid;
        let message = format!(
            "{} = {} is {} of the link's length: a block's centre of mass is near its middle",
            centroid.path,
            centroid.written,
            rounded(share)
        );
        reader.slip(&centroid.path, message, guess(0.001, unit_of(centroid)));
    }
    if let Some(breadth) = &link.breadth {
        let density = mass_kg / (length_m * breadth.value * breadth.value);
        if !within(density, BOX_DENSITY_KG_M3) {
            let message = format!(
                "{} = {}: the link's density would be about {} kg/m3",
                breadth.path,
                breadth.written,
                rounded(density)
            );
            reader.slip(&breadth.path, message, guess(1.0 / density, unit_of(breadth)));
        }
    }
    if let Some(inertia) = &link.inertia {
        let gyration = (inertia.value / mass_kg).sqrt() / length_m.max(side_m);
        if !within(gyration, GYRATION) {
            let radius_m = (inertia.value / mass_kg).sqrt();
            let message = format!(
                "{} = {}: the link's radius of gyration would be {} m, and the link is {} m long",
                inertia.path,
                inertia.written,
                rounded_length(radius_m),
                short(length_m)
            );
            let help = format!("a thin rod of this mass and length has {}", {
                let (unit, factor) = reader.bare_unit(Measure::Inertia);
                format!(
                    "{} {unit}",
                    rounded_length(mass_kg * length_m * length_m / 12.0 / factor)
                )
            });
            reader.slip(&inertia.path, message, help);
        }
    }
    if let Some(bed) = &link.bed_width {
        let ratio = bed.value / side_m;
        if !within(ratio, (1.0 / BED_RATIO_MOST, BED_RATIO_MOST)) {
            let message = format!(
                "{} = {}: the link would be {} m wide as stone",
                bed.path,
                bed.written,
                rounded_length(side_m)
            );
            reader.slip(&bed.path, message, guess(ratio, unit_of(bed)));
        }
    }
}

fn judge_joints(reader: &mut Reader, chain: &ChainPart, masses: &[f64]) {
    let Some(joints) = &chain.joints else {
        return;
    };
    let above = |i: usize| {
        let weight_n = masses[i..].iter().sum::<f64>() * chain.gravity_m_s2;
        let height_m = chain.links[i..].iter().map(|link| link.length.value).sum::<f64>();
        weight_n * height_m
    };
    let count = joints.len().min(masses.len());
    let shares: Vec<f64> = (0..count).map(|i| joints[i].stiffness.value / above(i)).collect();
    let odd = odd_ones(&shares, JOINT_RATIO_MOST, 1.0);
    for i in 0..count {
        let stiffness = &joints[i].stiffness;
        if shares[i] >= JOINT_SHARE_LEAST && !odd.contains(&i) {
            continue;
        }
        let product = reader.echo(above(i), Measure::JointStiffness);
        let message = format!(
            "{} = {} is {} × the weight times height above the joint, {product}",
            stiffness.path,
            stiffness.written,
            rounded(shares[i])
        );
        let help = "a joint that keeps a chain upright has about 1 × that or more; is it in N m/rad, kN m/rad or kN m/deg?";
        reader.slip(&stiffness.path, message, help.to_owned());
    }
}

fn judge_frame(reader: &mut Reader, frame: &FramePart) {
    for storey in &frame.storeys {
        let height = &storey.height;
        if !within(height.value, STOREY_HEIGHT_M) {
            let (least, most) = STOREY_HEIGHT_M;
            let message = format!(
                "{} = {}, but storeys are {least} to {most} m high",
                height.path, height.written
            );
            reader.slip(&height.path, message, guess(height.value, unit_of(height)));
        }
    }
    let masses: Vec<f64> = frame
        .storeys
        .iter()
        .map(|part| mass_kg(&part.heaviness, frame.gravity_m_s2))
        .collect();
    let mut is_mass_odd = false;
    for (storey, mass_kg) in frame.storeys.iter().zip(&masses) {
        if !within(*mass_kg, STOREY_MASS_KG) {
            is_mass_odd = true;
            let given = storey.heaviness.quantity();
            let message = format!(
                "{} = {}, but storeys have 1 t to 20 000 t",
                given.path, given.written
            );
            let ratio = if *mass_kg > 1e5 { 1000.0 } else { 0.001 };
            reader.slip(&given.path, message, guess(ratio, unit_of(given)));
        }
    }
    if is_mass_odd {
        // Axial forces and stiffness are compared with masses.
        return;
    }
    judge_axial(reader, frame, &masses);
    for direction in &frame.directions {
        for (stiffness, mass_kg) in direction.stiffness.iter().flatten().zip(&masses) {
            let frequency_hz = (stiffness.value / mass_kg).sqrt() / std::f64::consts::TAU;
            if !within(frequency_hz, STOREY_FREQUENCY_HZ) {
                let (least, most) = STOREY_FREQUENCY_HZ;
                let message = format!(
                    "{} = {}: the storey alone would sway at {} Hz, but storeys sway at {least} to {most} Hz",
                    stiffness.path,
                    stiffness.written,
                    rounded_length(frequency_hz)
                );
                reader.slip(
                    &stiffness.path,
                    message,
                    "is it in N/mm, kN/mm or kN/m?".to_owned(),
                );
            }
        }
    }
}

/// N_i over the weight above for every storey, with the given numbers read as forces in storeys or loads of levels.
fn axial_shares(storeys: &[StoreyPart], weights: &[f64], axial: Axial) -> Vec<f64> {
    let given: Vec<f64> = storeys
        .iter()
        .map(|storey| storey.axial_force.as_ref().map_or(0.0, |force| force.value))
        .collect();
    let carried = |values: &[f64], i: usize| values[i..].iter().sum::<f64>();
    let force = |i: usize| match axial {
        Axial::Level => carried(&given, i),
        Axial::Storey | Axial::FromMasses => given[i],
    };
    (0..storeys.len())
        .map(|i| force(i) / carried(weights, i))
        .collect()
}

fn judge_axial(reader: &mut Reader, frame: &FramePart, masses: &[f64]) {
    let (axial, other, other_word) = match frame.axial {
        Axial::FromMasses => return,
        Axial::Storey => (Axial::Storey, Axial::Level, "level"),
        Axial::Level => (Axial::Level, Axial::Storey, "storey"),
    };
    let weights: Vec<f64> = masses.iter().map(|mass| mass * frame.gravity_m_s2).collect();
    let shares = axial_shares(&frame.storeys, &weights, axial);
    if shares.iter().all(|share| *share == 0.0) {
        return;
    }
    let matches = |shares: &[f64]| shares.iter().all(|share| (share - 1.0).abs() <= AXIAL_MATCH);
    if !matches(&shares) && matches(&axial_shares(&frame.storeys, &weights, other)) {
        let message = format!(
            "axial = \"{}\", but the axial forces are the weights of the masses only if they are read as \"{other_word}\"",
            if axial == Axial::Storey { "storey" } else { "level" },
        );
        reader.slip(
            "axial",
            message,
            format!("did you mean axial = \"{other_word}\"?"),
        );
        return;
    }
    for (i, (storey, share)) in frame.storeys.iter().zip(&shares).enumerate() {
        let Some(force) = &storey.axial_force else {
            continue;
        };
        if *share != 0.0 && !within(*share, AXIAL_SHARE) {
            let weight = reader.echo(weights[i..].iter().sum(), Measure::Force);
            let message = format!(
                "{} = {}: the storey's columns would carry {} × the weight of the masses above, {weight}",
                force.path,
                force.written,
                rounded(*share)
            );
            reader.slip(&force.path, message, guess(*share, unit_of(force)));
        }
    }
}

fn judge_modes(reader: &mut Reader, survey: &Survey) {
    for mode in survey.modes.values().flatten() {
        let frequency = &mode.frequency;
        if !within(frequency.value, FREQUENCY_HZ) {
            let (least, most) = FREQUENCY_HZ;
            let message = format!(
                "{} = {}, but structures sway at {least} to {most} Hz",
                frequency.path, frequency.written
            );
            let help = if frequency.value < 1.0 {
                "did you mean kHz?"
            } else {
                "did you mean mHz or 1/min?"
            };
            reader.slip(&frequency.path, message, help.to_owned());
        }
        if let Some(damping) = &mode.damping_ratio
            && damping.value > DAMPING_RATIO_MOST
        {
            let message = format!(
                "{} = {}, but structures have 0.005 to 0.1",
                damping.path, damping.written
            );
            let help = format!("did you mean \"{} %\"?", short(damping.value));
            reader.slip(&damping.path, message, help);
        }
    }
}
