//! The wind on the storeys of a frame.

use crate::loads::{FrameWind, WindMet, WindOnLink};
use dolmen::structure::Frame;
use dolmen::structure::wind::{WindBody, WindError, WindPressure};
use dolmen_project::{FramePart, Pick, WindArea, WindGiven};

/// Wind data of a storey in numbers: its area, area times force coefficient, and the centre height of an additional area.
struct StoreyWindArea {
    storey: usize,
    area_m2: f64,
    effective_m2: f64,
    height_m: Option<f64>,
}

/// The wind along a direction of a frame with a given lowest frequency.
pub(super) fn wind_met(
    part: &FramePart,
    (wind, direction): (&WindGiven, usize),
    frequency_hz: Option<f64>,
    frame: &Frame,
    pick: Pick<'_>,
) -> Result<FrameWind, WindError> {
    let coefficient = pick(&wind.force_coefficient);
    let of = |area: &WindArea, pick: Pick<'_>| {
        let area_m2 = pick(&area.area);
        let own = area.force_coefficient.as_ref().map_or(coefficient, &mut *pick);
        StoreyWindArea {
            storey: area.part,
            area_m2,
            effective_m2: own * area_m2,
            height_m: area.height.as_ref().map(pick),
        }
    };
    let areas = wind.areas.iter().filter(|area| area.is_met(direction));
    let all: Vec<StoreyWindArea> = areas.map(|area| of(area, pick)).collect();
    let levels_m = frame.level_heights_m();
    let top_m = levels_m.iter().fold(0.0_f64, |most, level| most.max(*level));
    let height_m = all.iter().filter_map(|of| of.height_m).fold(top_m, f64::max);
    let own = &part.directions[direction];
    let damping_ratio = own.damping_ratio.as_ref().map(&mut *pick);
    let pressure = wind.build(pick).pressure(&WindBody {
        height_m,
        breadth_m: all.iter().map(|of| of.area_m2).sum::<f64>() / height_m,
        frequency_hz,
        damping_ratio,
    })?;
    let mut storeys = vec![WindOnLink::default(); levels_m.len()];
    let mut levels_n = vec![0.0; levels_m.len()];
    for met in &all {
        let below_m = met.storey.checked_sub(1).map_or(0.0, |below| levels_m[below]);
        let span_m = [below_m, levels_m[met.storey]];
        let on = on_storey(met, span_m, &pressure);
        // a column is hinged at its ends, which share its wind; areas above its level push only the level
        let lever_m = on.moment_n_m - on.force_n * span_m[0];
        let above_n = match met.height_m {
            Some(middle_m) if middle_m >= span_m[1] => on.force_n,
            _ => lever_m / (span_m[1] - span_m[0]),
        };
        levels_n[met.storey] += above_n;
        if let Some(below) = met.storey.checked_sub(1) {
            levels_n[below] += on.force_n - above_n;
        }
        let storey = &mut storeys[met.storey];
        storey.area_m2 += on.area_m2;
        storey.force_n += on.force_n;
        storey.moment_n_m += on.moment_n_m;
    }
    Ok(FrameWind {
        direction: own.name.clone(),
        met: WindMet {
            pressure_at_top_pa: pressure.at_pa(height_m),
            response_factor: pressure.response_factor,
            resonance: pressure.resonance,
            frequency_hz,
            force_n: storeys.iter().map(|of| of.force_n).sum(),
            moment_n_m: storeys.iter().map(|of| of.moment_n_m).sum(),
            links: storeys,
        },
        levels_n,
        slipping: None,
    })
}

/// Force, and moment about the ground, of one area: spread over its storey, or at its centre height.
fn on_storey(met: &StoreyWindArea, [bottom_m, top_m]: [f64; 2], pressure: &WindPressure) -> WindOnLink {
    let (force_n, moment_n_m) = match met.height_m {
        None => {
            let strip = pressure.strip(bottom_m, top_m);
            let breadth_m = met.effective_m2 / (top_m - bottom_m);
            (breadth_m * strip.force_n_m, breadth_m * strip.moment_n)
        }
        Some(middle_m) => {
            let force_n = met.effective_m2 * pressure.at_pa(middle_m);
            (force_n, force_n * middle_m)
        }
    };
    WindOnLink {
        area_m2: met.area_m2,
        force_n,
        moment_n_m,
    }
}
