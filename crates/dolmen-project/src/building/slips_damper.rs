//! Probable slips in the dampers of a building, and faults that the library finds in them.

use super::built_damper::BuiltDamper;
use super::damper::{DamperPart, HostBuilding};
use super::part::BuildingPart;
use crate::error::Fault;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::wrong::WrongDamper;
use crate::wrong::said;
use dolmen::damper::DamperKind;
use dolmen::dynamics::VibratingBuilding;
use dolmen::structure::Building;
use dolmen::structure::building::{BuildingModes, Outline};

/// Largest mass of a damper over that of the building. Our choice: built ones have a hundredth.
const HEAVY: f64 = 0.25;
/// Largest ratio of a damper's frequency to that of its mode, either way. Our choice: 2π, for rad/s instead of Hz, is beyond.
const OUT_OF_TUNE: f64 = 5.0;
/// Largest share of critical damping that a dashpot alone may give one of the lowest modes; beyond it the dashpot is a strut. Our choice:
/// built ones give 0.05 to 0.3.
const STRUT: f64 = 1.0;
/// Number of modes checked for this: one along each side, and one that twists.
const LOWEST_MODES: usize = 3;
/// Least stroke of a damper, m, and the largest where the floor is unknown; otherwise at most half the longest side of the floor.
const ROOM_LEAST_M: f64 = 0.002;
const ROOM_MOST_M: f64 = 5.0;

/// Judges each damper alone on the building.
pub(super) fn judge_dampers(reader: &mut Reader, part: &BuildingPart, vibrating: &VibratingBuilding) {
    let (building, modes) = (vibrating.building(), vibrating.modes());
    let host = HostBuilding {
        vibrating,
        gravity_m_s2: part.gravity_m_s2,
    };
    for damper in &part.dampers {
        let path = format!("damper.{}", damper.name);
        judge_room(reader, damper, building);
        let built = match damper.build(&host, &mut Quantity::nominal) {
            Ok(built) => built,
            Err(why) => {
                reader.fault(Fault::new(reader.place(&path), &path, said(&why)));
                continue;
            }
        };
        let mass_kg: f64 = built.iter().map(|own| own.kind.mass_kg()).sum();
        if mass_kg > HEAVY * building.mass_kg() {
            let message = WrongDamper::WeighsTOfBuilding {
                path: path.to_string(),
                mass_t: format!("{:.1}", 1e-3 * mass_kg),
                percent: format!("{:.0}", 100.0 * mass_kg / building.mass_kg()),
            };
            let help = WrongDamper::DoesItsModeHardly;
            reader.slip(&path, message, help);
        }
        for own in &built {
            judge_tune(reader, &path, own, modes);
            judge_dashpot(reader, &path, own, modes);
        }
    }
}

/// Judges the tuning: of a damper with its mode, and of the liquid of a column on a spring with the container.
fn judge_tune(reader: &mut Reader, path: &str, own: &BuiltDamper, modes: &BuildingModes) {
    let mode = own.tuned_to.and_then(|to| modes.modes.get(to.mode - 1));
    let (Some(mode), Some([hz, _])) = (mode, own.own()) else {
        return;
    };
    let is_out = |ratio: f64| !(1.0 / OUT_OF_TUNE..=OUT_OF_TUNE).contains(&ratio);
    let ratio = hz / mode.frequency_hz;
    if is_out(ratio) {
        let message = WrongDamper::ItsFrequencyIsHz {
            path: path.to_string(),
            hz: format!("{:.4}", hz),
            ratio: format!("{:.2}", ratio),
            frequency_hz: format!("{:.4}", mode.frequency_hz),
        };
        reader.slip(path, message, WrongDamper::IsItsFrequencyIn.to_owned());
    }
    if let DamperKind::LiquidColumnMass {
        liquid_frequency_hz, ..
    } = own.kind
    {
        let ratio = liquid_frequency_hz / mode.frequency_hz;
        if is_out(ratio) {
            let message = WrongDamper::ItsLiquidSwingsAt {
                path: path.to_string(),
                liquid_frequency_hz: format!("{:.4}", liquid_frequency_hz),
                ratio: format!("{:.2}", ratio),
                frequency_hz: format!("{:.4}", mode.frequency_hz),
            };
            let help = WrongDamper::IsLiquidFrequencyIn;
            reader.slip(path, message, help);
        }
    }
}

/// Damping that a dashpot alone gives a mode, to first order: c (row · φ)²/(2ω).
fn judge_dashpot(reader: &mut Reader, path: &str, own: &BuiltDamper, modes: &BuildingModes) {
    let DamperKind::Viscous { coefficient_n_s_m } = own.kind else {
        return;
    };
    let given = |shape: &[f64], omega_rad_s: f64| {
        let along: f64 = own.row.iter().zip(shape).map(|(r, phi)| r * phi).sum();
        coefficient_n_s_m * along * along / (2.0 * omega_rad_s)
    };
    let lowest = modes.modes.iter().take(LOWEST_MODES).enumerate();
    let most = lowest
        .map(|(j, mode)| (j + 1, given(&mode.shape, mode.omega_rad_s)))
        .max_by(|a, b| a.1.total_cmp(&b.1));
    if let Some((mode, ratio)) = most.filter(|(_, ratio)| *ratio > STRUT) {
        let message = WrongDamper::ItsCoefficientWouldGive {
            path: path.to_string(),
            mode: mode.to_string(),
            ratio: format!("{:.1}", ratio),
        };
        reader.slip(path, message, WrongDamper::IsItInN);
    }
}

fn judge_room(reader: &mut Reader, damper: &DamperPart, building: &Building) {
    let floor = damper
        .floor
        .checked_sub(1)
        .and_then(|index| building.floors().get(index));
    let outline = floor.and_then(|floor| floor.outline.as_ref());
    let most_m = outline.map_or(ROOM_MOST_M, |outline| 0.5 * longest_side_m(outline));
    for room in damper.stroke.iter().chain(&damper.liquid_stroke) {
        if !(ROOM_LEAST_M..=most_m).contains(&room.value) {
            let message = WrongDamper::ButDampersHaveMm {
                path: room.path.to_string(),
                written: room.written.to_string(),
                least: (1e3 * ROOM_LEAST_M).to_string(),
                most_m: most_m.to_string(),
            };
            reader.slip(&room.path, message, WrongDamper::IsItInM);
        }
    }
}

fn longest_side_m(outline: &Outline) -> f64 {
    let extent = |axis: usize| {
        let values = outline.corners_m().iter().map(|corner| corner[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        high - low
    };
    extent(0).max(extent(1))
}
