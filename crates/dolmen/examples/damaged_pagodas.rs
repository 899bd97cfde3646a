//! Stones that move first in pagodas like those of Table 3 of Kim, Koo and Hong (2018): the table of `docs/score.md`.
//!
//! `damaged_pagodas`: each pagoda of `data/damaged_pagodas` of which storeys are known, with slenderness and taper that the table does
//! not give varied, under El Centro 1940 north-south at three peaks.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::disallowed_methods,
    reason = "a measurement that fails loudly"
)]

use dolmen::blocks::{ContactLaw, ContactRule, Outcome, Springs, StackHistory, simulate_stack};
use dolmen::signal::{Component, GroundMotion};
use dolmen::structure::stack::{JointMaterial, PagodaFactors, PagodaSlenderness, Stack, pagoda};

const GRAVITY_M_S2: f64 = 9.81;
const PEAKS_G: [f64; 3] = [0.2, 0.4, 0.8];
const BODY_SLENDERNESS: [f64; 3] = [2.8, 3.4, 4.2];
const TAPER_DEG: [f64; 3] = [4.0, 6.0, 8.0];
/// Height of the body over that of one base, or of two.
const BODY_BASE_HEIGHT_RATIO: [f64; 2] = [3.0, 1.5];
/// Width at the top of the body over that at its foot.
const TOP_WIDTH: [f64; 2] = [0.3, 0.8];

fn main() {
    println!(
        "pagoda, runs that moved, of them most in the topmost storey, in another, in the base; runs in which a stone fell, the joint that gave way in the topmost storey"
    );
    let table = include_str!("../../../data/damaged_pagodas/damaged_pagodas.csv");
    let mut all = [0; 6];
    for row in table.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let Ok(storeys) = cells[1].parse::<u32>() else {
            println!("{}: no stack of storeys, not modelled", cells[0]);
            continue;
        };
        let bases: usize = cells[3].parse().unwrap();
        let found = places(
            storeys,
            cells[2].parse().unwrap(),
            BODY_BASE_HEIGHT_RATIO[bases - 1],
        );
        println!("{} ({}): {found:?}", cells[0], cells[4]);
        for (all, found) in all.iter_mut().zip(found) {
            *all += found;
        }
    }
    println!("all: {all:?}");
}

fn places(storeys: u32, height_m: f64, ratio: f64) -> [usize; 6] {
    let mut found = [0; 6];
    for body_slenderness in BODY_SLENDERNESS {
        for taper_deg in TAPER_DEG {
            let taper_rad = f64::to_radians(taper_deg);
            let top_width = 1.0 - body_slenderness * taper_rad.tan();
            if !(TOP_WIDTH[0]..=TOP_WIDTH[1]).contains(&top_width) {
                continue;
            }
            let made = pagoda(&PagodaFactors {
                storeys,
                body_height_m: height_m * ratio / (1.0 + ratio),
                slenderness: PagodaSlenderness::Body(body_slenderness),
                taper_rad,
                body_base_height_ratio: ratio,
                ..PagodaFactors::default()
            })
            .unwrap();
            let material = JointMaterial::with_friction(0.6);
            let stack = Stack::new(made.blocks, material, GRAVITY_M_S2).unwrap();
            for peak_g in PEAKS_G {
                let law = ContactLaw::Springs(Springs {
                    contact_rule: ContactRule::Corners,
                    ..Springs::default()
                });
                let history = simulate_stack(&stack, Some(&el_centro(peak_g)), &law, &mut |_| true).unwrap();
                count(&mut found, &stack, &history, storeys as usize);
            }
        }
    }
    found
}

/// Counts where the run moved most: the largest opening or slip over the width of the joint.
fn count(found: &mut [usize; 6], stack: &Stack, history: &StackHistory, storeys: usize) {
    let moved_m = |joint: usize| {
        history.joints[joint]
            .peak_opening_m
            .max(history.joints[joint].peak_slip_m)
    };
    let most = |joint: usize| {
        let corners = stack.joints()[joint].patch.corners_m.iter();
        moved_m(joint) / corners.map(|corner| 2.0 * corner[0].abs()).fold(0.0, f64::max)
    };
    let count = stack.joints().len();
    let base = count - 2 * storeys;
    let place = |joint: usize| match joint {
        top if top >= count - 2 => 1,
        body if body >= base => 2,
        _ => 3,
    };
    let largest = (0..count).max_by(|a, b| most(*a).total_cmp(&most(*b))).unwrap();
    if moved_m(largest) > StackHistory::UPLIFT_LEAST_M {
        found[0] += 1;
        found[place(largest)] += 1;
    }
    if let Outcome::Fell { joint, .. } = history.outcome {
        found[4] += 1;
        found[5] += usize::from(place(joint) == 1);
    }
}

fn el_centro(peak_g: f64) -> GroundMotion {
    let text = include_str!("../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let values: Vec<f64> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(1).unwrap().parse().unwrap())
        .collect();
    let peak = values.iter().fold(0.0_f64, |peak, a| peak.max(a.abs()));
    let scaled = values.iter().map(|a| a / peak * peak_g * GRAVITY_M_S2);
    GroundMotion::new("El Centro", 0.02, vec![(Component::X, scaled.collect())]).unwrap()
}
