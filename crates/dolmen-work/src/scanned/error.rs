//! Errors of cutting a scan.

use dolmen::structure::stack::{SliceError, SlicedStep};
use dolmen_records::meshes::MeshError;
use dolmen_words::sentences;

/// Why a scan gives no stones.
#[derive(Clone, Debug, PartialEq)]
pub enum ScanError {
    /// The file is no mesh.
    Mesh(MeshError),
    /// The mesh cannot be cut.
    Slice(SliceError),
    /// The section steps where no bed is given.
    StepsWithoutBed {
        /// The steps, lowest first.
        steps: Vec<SlicedStep>,
    },
    /// The section steps where no bed is given, and beds are given where it does not.
    BedsBesideSteps {
        /// The steps, lowest first.
        steps: Vec<SlicedStep>,
        /// Numbers from 1, and heights in m, of the given beds at which the section has no step.
        plain_beds: Vec<(usize, f64)>,
    },
    /// Metres and millimetres are both possible.
    UnitUnclear {
        /// Height of the mesh in the unit of its file.
        height: f64,
    },
    /// No tower has this height.
    Height {
        /// Height of the mesh, m.
        height_m: f64,
        /// The given unit.
        unit: &'static str,
        /// Least height, m.
        least_m: f64,
        /// Greatest height, m.
        most_m: f64,
    },
}

/// "0.500 m (1.000 → 0.360 m²), 2.000 m (…)": heights of steps, and the areas below and above.
pub fn listed_steps(steps: &[SlicedStep]) -> String {
    let one = |step: &SlicedStep| {
        let SlicedStep {
            at_m,
            area_below_m2,
            area_above_m2,
        } = step;
        format!("{at_m:.3} m ({area_below_m2:.3} → {area_above_m2:.3} m²)")
    };
    steps.iter().map(one).collect::<Vec<_>>().join(", ")
}

fn heights(steps: &[SlicedStep]) -> String {
    let heights: Vec<String> = steps.iter().map(|step| format!("{:.3}", step.at_m)).collect();
    heights.join(",")
}

fn listed_beds(beds: &[(usize, f64)]) -> String {
    let listed: Vec<String> = beds
        .iter()
        .map(|(number, at_m)| format!("{number} ({at_m:.3} m)"))
        .collect();
    listed.join(", ")
}

sentences! {
    ScanError in "scan.error" {
        StepsWithoutBed { steps } as { steps: listed_steps(steps), allow: heights(steps) } => {
            en: "the section steps at {steps}, and no bed is there. A tower without one of its beds seems stronger than it is: give these heights with --beds; where the step is within one stone (a moulding, a corbel), with --allow {allow}. If the tower leans and its beds with it, turn the scan upright first and give the lean as the tilt of a survey",
            ko: "{steps}에서 단면이 바뀌는데 그곳에 접합면이 없다. 접합면을 빠뜨리면 탑이 실제보다 강해 보인다. 이 높이를 --beds에 쓴다. 한 석재 안에서 단면이 바뀌는 곳(몰딩, 받침)이면 --allow {allow}(으)로 쓴다. 탑이 접합면과 함께 기울어 있으면 스캔을 먼저 바로 세우고 기울기는 조사의 tilt로 준다",
        },
        BedsBesideSteps { steps, plain_beds } as { steps: listed_steps(steps), beds: listed_beds(plain_beds), allow: heights(steps) } => {
            en: "the section steps at {steps}, and no bed is there; it does not step at bed {beds}. A bed cut beside its step seems stronger than it is: correct the heights of --beds; where the step is within one stone (a moulding, a corbel), give it with --allow {allow}",
            ko: "{steps}에서 단면이 바뀌는데 그곳에 접합면이 없다. 접합면 {beds}에서는 단면이 바뀌지 않는다. 단면이 바뀌는 곳을 벗어나 자른 접합면은 실제보다 강해 보인다. --beds의 높이를 고친다. 한 석재 안에서 단면이 바뀌는 곳(몰딩, 받침)이면 --allow {allow}(으)로 쓴다",
        },
        UnitUnclear { height } as { height: format!("{height:.3}") } => {
            en: "the mesh is {height} high in the unit of its file, which names none: say with --unit whether that is \"m\", \"cm\" or \"mm\"",
            ko: "메시의 높이가 {height}인데 파일에 단위가 없다. --unit으로 \"m\", \"cm\", \"mm\" 중 하나를 지정한다",
        },
        Height { height_m, unit, least_m, most_m } as { height_m: format!("{height_m:.4}"), unit, least_m, most_m } => {
            en: "the mesh is {height_m} m high if its file is in {unit}, but must be {least_m} to {most_m} m: correct --unit",
            ko: "파일의 단위가 {unit}이면 메시의 높이가 {height_m} m인데 {least_m}~{most_m} m이어야 한다. --unit을 고친다",
        },
    }
    handed on { Mesh(MeshError), Slice(SliceError) }
}
