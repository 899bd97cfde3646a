//! The wind on the links of a chain.

use crate::loads::{WindMet, WindOnLink};
use dolmen::structure::Chain;
use dolmen::structure::wind::{WindBody, WindError};
use dolmen_project::{ChainAxis, ChainPart, Pick, WindArea, WindGiven};

/// The wind on each link, along one direction of the chain.
pub(super) fn wind_met(
    part: &ChainPart,
    (wind, axis): (&WindGiven, ChainAxis),
    frequency_hz: Option<f64>,
    chain: &Chain,
    pick: Pick<'_>,
) -> Result<WindMet, WindError> {
    let own = |i: usize, pick: Pick<'_>| -> f64 {
        let replaced = |area: &&WindArea| area.part == i && area.height.is_none();
        let mut replacing = wind.areas.iter().filter(replaced).peekable();
        if replacing.peek().is_some() {
            return replacing.map(|area| pick(&area.area)).sum();
        }
        let link = &part.links[i];
        let bed = part.bed(i, pick);
        let width = link.met_by_wind(axis, bed, pick);
        width.unwrap_or(f64::NAN) * pick(&link.length)
    };
    let areas: Vec<f64> = (0..part.links.len()).map(|i| own(i, pick)).collect();
    let height_m = chain.height_m();
    let body = WindBody {
        height_m,
        breadth_m: areas.iter().sum::<f64>() / height_m,
        frequency_hz,
        damping_ratio: part.damping_ratio.as_ref().map(&mut *pick),
    };
    let pressure = wind.build(pick).pressure(&body)?;
    let coefficient = pick(&wind.force_coefficient);
    let bottoms = chain.joint_heights_m();
    let mut links = Vec::with_capacity(areas.len());
    for (i, (own_m2, bottom_m)) in areas.iter().zip(bottoms).enumerate() {
        let length_m = chain.links()[i].length_m;
        let strip = pressure.strip(bottom_m, bottom_m + length_m);
        let mut of = WindOnLink {
            area_m2: *own_m2,
            ..WindOnLink::default()
        };
        let replaced = |area: &&WindArea| area.part == i && area.height.is_none();
        let mut replacing = wind.areas.iter().filter(replaced).peekable();
        // areas that replace that of the link may have their own coefficients
        let effective_m2 = match replacing.peek().is_some() {
            true => replacing
                .map(|area| {
                    let own = area.force_coefficient.as_ref().map_or(coefficient, &mut *pick);
                    own * pick(&area.area)
                })
                .sum(),
            false => coefficient * own_m2,
        };
        of.force_n += effective_m2 / length_m * strip.force_n_m;
        of.moment_n_m += effective_m2 / length_m * strip.moment_n;
        for area in wind.areas.iter().filter(|area| area.part == i) {
            let Some(height) = &area.height else { continue };
            let (height_m, area_m2) = (pick(height), pick(&area.area));
            let own = area.force_coefficient.as_ref().map_or(coefficient, &mut *pick);
            let force_n = own * area_m2 * pressure.at_pa(height_m);
            of.area_m2 += area_m2;
            of.force_n += force_n;
            of.moment_n_m += force_n * height_m;
        }
        links.push(of);
    }
    Ok(WindMet {
        pressure_at_top_pa: pressure.at_pa(height_m),
        response_factor: pressure.response_factor,
        resonance: pressure.resonance,
        frequency_hz,
        force_n: links.iter().map(|of| of.force_n).sum(),
        moment_n_m: links.iter().map(|of| of.moment_n_m).sum(),
        links,
    })
}
