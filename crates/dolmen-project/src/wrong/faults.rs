//! Why stones or dampers of a project cannot be built, in both languages.

use crate::building::DamperFault;
use crate::stack::StackFault;
use dolmen::damper::DamperError;
use dolmen_words::sentences;

sentences! {
    StackFault in "project.fault.stack" {
        Part { path, why } => {
            en: "{path}: {why}",
            ko: "{path}: {why}",
        },
        Apart { path, upper, lower, apart_m, allowed_m } as { upper, lower, x_m: format!("{:.4}", apart_m[0]), y_m: format!("{:.4}", apart_m[1]), z_m: format!("{:.4}", apart_m[2]), allowed_m } => {
            en: "'{upper}' is said to stand on '{lower}', but they do not touch: it is {x_m} m along x, {y_m} m along y and {z_m} m along z away from it, and a bed there must lie within {allowed_m} m of it and be level with it to 5°",
            ko: "'{upper}'이(가) '{lower}' 위에 놓인다고 하였으나 서로 닿지 않는다. x축으로 {x_m} m, y축으로 {y_m} m, z축으로 {z_m} m 떨어져 있다. 접합면의 높이 차는 {allowed_m} m, 기울기 차는 5° 이내이어야 한다",
        },
        Loose {} => {
            en: "the stones are loose (loose = true), and have no joints: only `dolmen check`, `dolmen simulate` and `dolmen report` let them settle; take \"loose\" out for anything else",
            ko: "돌이 놓인 자리가 정해지지 않아(loose = true) 접합면이 없다. `dolmen check`, `dolmen simulate`, `dolmen report`만 돌을 가라앉혀 자리를 찾는다. 다른 명령에는 \"loose\"를 삭제한다",
        },
        Twice { path, upper, lower, first } => {
            en: "{path} gives the joint of '{upper}' on '{lower}' a second time, after contacts[{first}]: keep one of them",
            ko: "{path}이(가) '{lower}' 위 '{upper}'의 접합면을 contacts[{first}]에 이어 다시 준다. 둘 중 하나만 남긴다",
        },
    }
}

sentences! {
    DamperFault in "project.fault.damper" {
        Still { name, mode, why } => {
            en: "damper.{name}: mode {mode} does not move at its place along its direction ({why}): no mass ratio can be taken of it; place or turn the damper, or name another mode",
            ko: "damper.{name}: 모드 {mode}이(가) 감쇠기의 위치에서 그 방향으로 움직이지 않는다({why}). 질량비를 정할 수 없다. 감쇠기를 옮기거나 돌리거나 다른 모드를 지정한다",
        },
        Mode { name, mode, most } => {
            en: "damper.{name}: mode = {mode}, but the building has {most} modes",
            ko: "damper.{name}: mode = {mode}인데 건물의 모드는 {most}개이다",
        },
        Heavy { name, mass_ratio, mode, modal_mass_kg } as { name, mass_ratio: format!("{mass_ratio:.4}"), mode, modal_mass_kg: format!("{modal_mass_kg:.0}") } => {
            en: "damper.{name}: its mass ratio is {mass_ratio}, more than 1: it would be heavier than the modal mass of mode {mode}, which is {modal_mass_kg} kg at its place; is the unit of its mass right?",
            ko: "damper.{name}: 질량비가 1보다 큰 {mass_ratio}이다. 그 위치에서 {modal_mass_kg} kg인 모드 {mode}의 모드질량보다 무겁다. 질량의 단위가 맞는가?",
        },
        HeavierThanAll { name, mass_kg, building_kg, mode } as { name, mass_kg: format!("{mass_kg:.0}"), building_kg: format!("{building_kg:.0}"), mode } => {
            en: "damper.{name}: its mass would be {mass_kg} kg, more than the whole building's {building_kg} kg: mode {mode} hardly moves at its place, so that its modal mass there is large; place it farther from the mode's centre, or give mass",
            ko: "damper.{name}: 질량이 {mass_kg} kg이 되어 건물 전체의 {building_kg} kg보다 무겁다. 모드 {mode}이(가) 그 위치에서 거의 움직이지 않아 모드질량이 크다. 모드의 중심에서 더 먼 곳에 두거나 mass를 입력한다",
        },
        Place { name, why } as { path: format!("damper.{name}"), why: why } => {
            en: "{path}: {why}",
            ko: "{path}: {why}",
        },
    }
    handed on { Tuning(DamperError) }
}
