//! Probable slips of unit: values that are possible in themselves, but not beside each other or in this world.
//!
//! A slip between units of one kind is a factor of 1000 (mm, kN, t), seldom 10, 100 or 57.3. Each bound lies outside
//! the widest real structures we know, with a margin; a slip of 1000 in a part that is like the others crosses it. A slip
//! in a part that was already odd the other way does not, nor do slips of 10 to 100. What is rejected can be let pass with `allow`.
//!
//! | what is compared | real structures | slip of 1000 in a flagpole or gate | bound |
//! |:--|:--|:--|:--|
//! | mass per length of a link / median of the others | 1/92 (iron finial on stone drums) to 13 | 1/550, 550 and more | 200 |
//! | side of a link as a block of stone / height of the whole | 0.006 (antenna tube) to 1.4 (squat statue) | 0.002, 1.9 (lowest link) | 0.004 to 1.5 |
//! | length of a link / median of the others | 1/70 to 10 | 370 and more | 100 |
//! | joint stiffness / (P H) over the median of the others | 1/100 to 100 (wedged base, loose tops) | 1000 | 300 |
//! | mass of a storey | 1 t (open pavilion) to 20 000 t | 0.3 t, 290 000 t | 1 t to 20 000 t |
//! | axial force / weight above | 0.5 to 2 (columns and loads counted differently) | 1/1000, 1000 | 0.2 to 5 |
//! | √(k/m)/2π of a storey | 0.3 to 30 Hz | 0.05 to 0.13, 50 to 130 Hz | 0.2 to 60 Hz |
//! | measured frequency | 0.1 Hz (high tower) to 100 Hz (small stone) | 0.001, 1000 Hz | 0.05 to 200 Hz |

use super::building::judge_building;
use super::chain::judge_chain;
use super::content::Structure;
use super::frame::judge_frame;
use super::quantity::Quantity;
use super::reader::Reader;
use super::stack::judge_stack;
use super::survey::Survey;
use super::usual::within;
use super::written::short;
use super::wrong::{Common, Slip};

/// Measured frequency, Hz.
const FREQUENCY_HZ: (f64, f64) = (0.05, 200.0);
/// Standard deviation over a measured frequency: records give 0.001 to 0.05, rough readings of a few peaks 0.35.
const DEVIATION_MOST: f64 = 0.4;
/// Damping ratio: ambient vibration of heritage has 0.005 to 0.1.
const DAMPING_RATIO_MOST: f64 = 0.3;
/// Gravity on Earth, m/s²: 9.78 at the equator, 9.83 at the poles, 9.76 on high mountains.
const GRAVITY_M_S2: (f64, f64) = (9.75, 9.85);

/// Reports every probable slip in the file.
pub(super) fn judge(
    reader: &mut Reader,
    gravity: Option<&Quantity>,
    structure: Option<&Structure>,
    surveys: &[Survey],
) {
    if let Some(gravity) = gravity
        && !within(gravity.value, GRAVITY_M_S2)
    {
        let message = Slip::GravityIsNotThat(gravity.written.to_string());
        reader.slip(&gravity.path, message, Slip::GalMS2And);
    }
    match structure {
        Some(Structure::Chain(chain)) => judge_chain(reader, chain),
        Some(Structure::Frame(frame)) => judge_frame(reader, frame),
        Some(Structure::Stack(stack)) => judge_stack(reader, stack),
        Some(Structure::Building(building)) => judge_building(reader, building),
        Some(Structure::Survey) | None => {}
    }
    for survey in surveys {
        judge_modes(reader, survey);
    }
}

fn judge_modes(reader: &mut Reader, survey: &Survey) {
    for mode in survey.modes.values().flatten() {
        let frequency = &mode.frequency;
        if let Some(cov) = frequency.cov.filter(|cov| *cov > DEVIATION_MOST) {
            let message = Slip::DeviationLarge {
                path: frequency.path.to_string(),
                sd: format!("{} Hz", short(cov * frequency.value)),
                written: frequency.written.to_string(),
                percent: format!("{:.0}", 100.0 * cov),
            };
            reader.slip(&frequency.path, message, Slip::FrequenciesAreKnown);
        }
        if !within(frequency.value, FREQUENCY_HZ) {
            let (least, most) = FREQUENCY_HZ;
            let message = Slip::ButStructuresSwayAt {
                path: frequency.path.to_string(),
                written: frequency.written.to_string(),
                least: least.to_string(),
                most: most.to_string(),
            };
            let help = if frequency.value < 1.0 {
                Slip::DidYouMeanKhz
            } else {
                Slip::DidYouMeanMhz
            };
            reader.slip(&frequency.path, message, help.to_owned());
        }
        if let Some(damping) = &mode.damping_ratio
            && damping.value > DAMPING_RATIO_MOST
        {
            let message = Slip::ButStructuresHaveTo {
                path: damping.path.to_string(),
                written: damping.written.to_string(),
            };
            let help = Common::IsItPerCent(short(damping.value));
            reader.slip(&damping.path, message, help);
        }
    }
}
