//! A building in the report: verdict, plan, storeys, modes, dampers, spectrum.

use super::finding::{Finding, Tone};
use super::table::{Cell, figure, table};
use crate::figures::building_plan;
use crate::load_factor::load_factor_finding;
use crate::text::GROWN;
use dolmen::stability::Verdict;
use dolmen::structure::building::StoreyFall;
use dolmen_project::{BuiltDamper, strokes_of};
use dolmen_words::Language;
use dolmen_words::number::{beside_one, fixed, percent, prefix, significant, significant_beside};
use dolmen_work::building::{BuildingAnswer, BuildingSpectral, DampedSpectral, StandingBuilding};
use dolmen_work::state::{Check, VariantAnswer};
use maud::{Markup, html};

/// Share of the energy in rotation, in a mode that sways, from which the building is said to twist. Our choice.
const TWISTS: f64 = 0.02;

pub(super) fn findings(answer: &BuildingAnswer, language: Language) -> Vec<Finding> {
    let factor = answer.load_factor();
    let verdict = Verdict::of_load_factor(factor);
    let mut all = vec![Finding::said(load_factor_finding(factor, verdict), language)];
    if let Some(first) = StoreyFall::first(&answer.falls) {
        let name = &answer.floors[first.storey - 1];
        let (motion, korean) = if first.motion() == "twists" {
            ("twisting", "비틀림으로")
        } else {
            ("swaying", "횡변위로")
        };
        let factor = beside_one(first.load_factor, 3);
        all.push(Finding::of(
            verdict,
            language.pick(
                format!("The storey below floor {} has the least margin: it would fall by {motion} under {factor} times the weight above it.", floor_words(name, language)),
                format!("여유가 가장 작은 층은 {} 바닥 아래이며, 상부 무게의 {factor}배에서 {korean} 무너진다.", floor_words(name, language)),
            ),
        ));
    }
    if let Some(standing) = &answer.stands {
        all.extend(mode_findings(standing, language));
        if let Some(spectral) = &standing.spectral {
            all.push(spectral_finding(answer, spectral, language));
        }
        all.extend(more_finding(standing, language));
        all.extend(room_findings(standing, language));
    }
    all
}

/// What the dampers make more under the spectrum of the site.
fn more_finding(standing: &StandingBuilding, language: Language) -> Option<Finding> {
    let more = standing.against_without();
    let more = more.iter().filter(|of| of.ratio > GROWN).map(|of| {
        let [english, korean] = &of.what;
        format!("{} {}", language.pick(english, korean), significant(of.ratio, 4))
    });
    let list: Vec<String> = more.collect();
    (!list.is_empty()).then(|| {
        let list = list.join(", ");
        Finding::new(
            Tone::Warn,
            language.pick(
                format!("With the dampers some of the response to the spectrum is more than without, by these factors: {list}."),
                format!("제진장치로 인해 부지 스펙트럼에 대한 응답 일부가 커진다(배수): {list}."),
            ),
        )
    })
}

/// Dampers that need more room under the spectrum of the site than they have.
fn room_findings(standing: &StandingBuilding, language: Language) -> Vec<Finding> {
    let each = standing.beyond_room().into_iter().map(|damper| {
        let (needed, has) = (
            significant(1e3 * damper.stroke_m, 4),
            significant(1e3 * damper.room_m, 4),
        );
        Finding::new(
            Tone::Bad,
            language.pick(
                format!("Damper {} is beyond its room under the spectrum of the site: it needs {needed}\u{202f}mm each way and has {has}\u{202f}mm.", damper.name),
                format!("부지 스펙트럼에서 제진장치 {}의 행정 {needed}\u{202f}mm가 여유 {has}\u{202f}mm를 넘는다.", damper.name),
            ),
        )
    });
    each.collect()
}

/// The same of the variants.
pub(super) fn variant_findings(variants: &[VariantAnswer], language: Language) -> Vec<Finding> {
    let states = variants.iter().map(|variant| &variant.state.check);
    let standing = states.filter_map(|check| match check {
        Check::Building(answer) => answer.stands.as_deref(),
        _ => None,
    });
    standing
        .flat_map(|standing| room_findings(standing, language))
        .collect()
}

fn mode_findings(standing: &StandingBuilding, language: Language) -> Vec<Finding> {
    let mut all = Vec::new();
    if let Some(first) = standing.modes.modes.first() {
        let hertz = significant(first.frequency_hz, 3);
        all.push(Finding::new(
            Tone::Plain,
            language.pick(
                format!("The lowest natural frequency is {hertz}\u{202f}Hz."),
                format!("최저 고유진동수는 {hertz}\u{202f}Hz이다."),
            ),
        ));
    }
    let twisting = standing.modes.modes.iter().take(3).enumerate().find(|(_, mode)| {
        let share = mode.energy_shares[2];
        (TWISTS..0.5).contains(&share)
    });
    if let Some((j, mode)) = twisting {
        let share = percent(mode.energy_shares[2], 2);
        all.push(Finding::new(
            Tone::Warn,
            language.pick(
                format!("The building twists as it sways: {share} of the energy of mode {} is rotation, so that its edges move unequally.", j + 1),
                format!("횡변위와 비틀림이 연성되어 있다. {}차 모드 에너지의 {share}가 회전이므로 양 끝의 변위가 다르다.", j + 1),
            ),
        ));
    }
    all
}

fn spectral_finding(answer: &BuildingAnswer, spectral: &BuildingSpectral, language: Language) -> Finding {
    let damped = answer
        .stands
        .as_ref()
        .and_then(|standing| standing.damped.as_ref());
    let drifts = damped.map_or(&spectral.edge_drift_m, |damped| &damped.edge_drift_m);
    let storeys = answer.elastic.storeys().iter().zip(drifts).enumerate();
    let worst = storeys
        .filter_map(|(i, (storey, drift))| drift.map(|[x, y]| (i, x.max(y) / storey.height_m)))
        .reduce(|most, own| if own.1 > most.1 { own } else { most });
    let Some(worst) = worst else {
        return Finding::new(
            Tone::Warn,
            language.pick(
                "No floor has an outline: drifts at the edges, the largest where it twists, are not known.",
                "바닥 외곽선이 없어 비틀림 때 가장 큰 단부 층간변위를 알 수 없다.",
            ),
        );
    };
    let (name, ratio) = (&answer.floors[worst.0], percent(worst.1, 3));
    let [with, with_ko] = match damped {
        Some(_) => [", with the dampers,", "제진장치를 포함한 "],
        None => ["", ""],
    };
    Finding::new(
        Tone::Plain,
        language.pick(
            format!("By the spectrum of the site the largest elastic drift at an edge{with} is {ratio} of the storey height, below floor {}.", floor_words(name, language)),
            format!("부지 스펙트럼에 의한 {with_ko}최대 탄성 층간변위(단부)는 {} 바닥 아래에서 층고의 {ratio}이다.", floor_words(name, language)),
        ),
    )
}

/// A floor in a sentence: "3", "3층", or its name in quotes.
pub(super) fn floor_words(name: &str, language: Language) -> String {
    let numbered = name.bytes().all(|b| b.is_ascii_digit());
    match (numbered, language) {
        (true, Language::English) => name.to_owned(),
        (true, Language::Korean) => format!("{name}층"),
        (false, _) => format!("‘{name}’"),
    }
}

/// The sections of a building.
pub(super) fn sections(answer: &BuildingAnswer, language: Language) -> Markup {
    html! {
        h2 { (language.pick("Stability", "안정성")) }
        (storeys(answer, language))
        @if let Some(standing) = &answer.stands {
            h2 { (language.pick("Natural modes", "고유모드")) }
            (figure(&building_plan(standing, language), language.pick(
                "Where the top floor turns in each mode. A mode whose centre is far away sways; one whose centre lies on the floor twists. An arrow points to a centre beyond the picture. Walls are drawn as long as they are stiff.",
                "각 모드에서 최상층이 회전하는 중심. 중심이 멀면 횡변위가, 평면 안에 있으면 비틀림이 지배한다. 화살표는 그림 밖의 중심을 가리킨다. 벽체의 길이는 강성에 비례하여 그렸다.",
            )))
            (modes(standing, language))
            (dampers(&standing.dampers, language))
            @if let Some(spectral) = &standing.spectral { (spectrum(answer, spectral, language)) }
            @if let Some(damped) = &standing.damped { (damped_spectrum(answer, damped, standing, language)) }
            @if let Some(why) = &standing.damped_refused {
                p { b { (language.pick("The response with the dampers is not computed: ", "제진장치를 포함한 스펙트럼 응답을 계산하지 않았다: ")) (why) } }
            }
            @if let Some(why) = &standing.spectral_refused {
                p { b { (language.pick("The response to the spectrum of the site is not computed: ", "부지 스펙트럼에 대한 응답을 계산하지 않았다: ")) (why) } }
            }
        }
    }
}

fn storeys(answer: &BuildingAnswer, language: Language) -> Markup {
    let building = &answer.elastic;
    let matrices: Vec<_> = building
        .storeys()
        .iter()
        .map(|storey| {
            let at = storey.stiffness.centre_of_rigidity_m().unwrap_or([f64::NAN; 2]);
            (at, storey.stiffness.matrix_about(at))
        })
        .collect();
    let of = |i: usize| -> Vec<f64> { matrices.iter().map(|(_, k)| k[i][i]).collect() };
    let lateral = prefix(&[of(0), of(1)].concat(), "N/m");
    let turning = prefix(&of(2), "N·m/rad");
    let masses: Vec<f64> = building.floors().iter().map(|floor| floor.mass_kg).collect();
    let mass = prefix(&masses, "kg");
    let head = [
        language.pick("Floor", "층").to_owned(),
        format!("{} ({})", language.pick("mass", "질량"), mass.unit),
        format!("k x ({})", lateral.unit),
        format!("k y ({})", lateral.unit),
        format!("k θ ({})", turning.unit),
        language.pick("eccentricity x (m)", "편심 x (m)").to_owned(),
        language.pick("y (m)", "y (m)").to_owned(),
        language.pick("load factor λ", "하중배율 λ").to_owned(),
    ];
    let rows: Vec<Vec<Cell>> = matrices
        .iter()
        .enumerate()
        .rev()
        .map(|(i, (at, k))| {
            let centre = building.floors()[i].centre_m;
            let factor = answer.falls[i].load_factor;
            vec![
                answer.floors[i].clone().into(),
                mass.number(masses[i], 5).into(),
                lateral.number(k[0][0], 5).into(),
                lateral.number(k[1][1], 5).into(),
                turning.number(k[2][2], 5).into(),
                fixed(at[0] - centre[0] + 0.0, 3).into(),
                fixed(at[1] - centre[1] + 0.0, 3).into(),
                if factor > 1.0 {
                    beside_one(factor, 4).into()
                } else {
                    Cell::bad(beside_one(factor, 4))
                },
            ]
        })
        .collect();
    let caption = language.pick(
        "Floors and the storey below each. Stiffness about its centre of rigidity, the eccentricity of that from the centre of mass; λ is the factor on the weight above at which the storey falls.",
        "각 층 바닥과 그 아래 층. 강성은 강성 중심에 대한 값이고 편심은 질량 중심에서 강성 중심까지의 거리이다. λ는 그 층이 무너지는 상부 무게의 배수이다.",
    );
    table(caption, 1, &head, &rows)
}

fn modes(standing: &StandingBuilding, language: Language) -> Markup {
    let head = [
        language.pick("Mode", "모드").to_owned(),
        language.pick("f (Hz)", "진동수 (Hz)").to_owned(),
        language.pick("T (s)", "주기 (s)").to_owned(),
        language.pick("damping", "감쇠비").to_owned(),
        language.pick("mass x", "유효질량 x").to_owned(),
        language.pick("mass y", "유효질량 y").to_owned(),
        language.pick("energy x", "에너지 x").to_owned(),
        "y".to_owned(),
        language.pick("rotation", "회전").to_owned(),
        language.pick("centre x (m)", "중심 x (m)").to_owned(),
        "y (m)".to_owned(),
    ];
    let all = &standing.modes;
    let rows: Vec<Vec<Cell>> = all
        .modes
        .iter()
        .take(standing.shown())
        .enumerate()
        .map(|(j, mode)| {
            let centre = mode.centres.last().copied().flatten();
            let at = |value: Option<f64>| value.map_or("–".to_owned(), |x| fixed(x + 0.0, 2));
            let share = |value: f64| percent(value, 3);
            vec![
                (j + 1).to_string().into(),
                significant(mode.frequency_hz, 4).into(),
                significant(mode.period_s(), 4).into(),
                percent(standing.damping_ratios[j], 3).into(),
                share(mode.effective_mass[0] / all.total_mass[0]).into(),
                share(mode.effective_mass[1] / all.total_mass[1]).into(),
                share(mode.energy_shares[0]).into(),
                share(mode.energy_shares[1]).into(),
                share(mode.energy_shares[2]).into(),
                at(centre.map(|c| c.x_m)).into(),
                at(centre.map(|c| c.y_m)).into(),
            ]
        })
        .collect();
    let caption = language.pick(
        "Modes without dampers. Shares of the effective mass and of the kinetic energy; the centre is where the top floor turns about, – if it moves without turning.",
        "제진장치가 없는 상태의 모드. 유효질량비와 운동에너지 비율이며, 중심은 최상층이 회전하는 점이다(–: 회전이 없음).",
    );
    table(caption, 1, &head, &rows)
}

/// The dampers, every number worked out.
pub(super) fn dampers(dampers: &[BuiltDamper], language: Language) -> Markup {
    if dampers.is_empty() {
        return html! {};
    }
    let head = [
        language.pick("Damper", "제진장치").to_owned(),
        language.pick("kind", "종류").to_owned(),
        language.pick("floor", "층").to_owned(),
        "x, y (m)".to_owned(),
        language.pick("for mode", "대상 모드").to_owned(),
        language.pick("mass ratio", "질량비").to_owned(),
        language.pick("mass (t)", "질량 (t)").to_owned(),
        language.pick("f (Hz)", "진동수 (Hz)").to_owned(),
        language.pick("damping", "감쇠비").to_owned(),
        language.pick("besides", "기타").to_owned(),
    ];
    let rows: Vec<Vec<Cell>> = dampers
        .iter()
        .map(|damper| {
            let none = || "–".to_owned();
            let tuned = damper.tuned_to;
            let own = damper.own();
            vec![
                damper.name.clone().into(),
                damper.word().to_owned().into(),
                damper.floor.to_string().into(),
                format!("{:.2}, {:.2}", damper.place_m[0], damper.place_m[1]).into(),
                tuned.map_or_else(none, |tuned| tuned.mode.to_string()).into(),
                tuned
                    .map_or_else(none, |tuned| percent(tuned.mass_ratio, 3))
                    .into(),
                tuned
                    .map_or_else(none, |_| significant(1e-3 * damper.kind.mass_kg(), 4))
                    .into(),
                own.map_or_else(none, |own| significant(own[0], 4)).into(),
                own.map_or_else(none, |own| percent(own[1], 3)).into(),
                Cell::wrapping(damper.rest()),
            ]
        })
        .collect();
    let caption = language.pick(
        "Dampers. tmd, a mass on a spring; tlcd, a liquid column; tlcmd, such a column on a spring; link, a dashpot. The mass ratio is of the modal mass at the damper's place, the damping ratio on its own frequency.",
        "제진장치. tmd 동조질량감쇠기, tlcd 동조액체기둥감쇠기, tlcmd 그 혼합형, link 점성감쇠기. 질량비는 장치 위치에서의 모드질량에 대한 값이고 감쇠비는 장치 자신의 진동수에 대한 값이다.",
    );
    table(caption, 2, &head, &rows)
}

fn spectrum(answer: &BuildingAnswer, spectral: &BuildingSpectral, language: Language) -> Markup {
    let [sum, srss, cqc] = spectral.base_shear_n;
    let largest_n = cqc[0].abs().max(cqc[1].abs());
    let kn = |value: f64| significant_beside(1e-3 * value, 1e-3 * largest_n, 4);
    let worst = spectral.least_favourable.map(|of| of.largest);
    html! {
        h2 { (language.pick("Response to the spectrum of the site", "부지 스펙트럼에 대한 응답")) }
        p { (language.pick(
            format!("Base shear along x {} kN, along y {} kN by CQC (SRSS {} and {}, absolute sums {} and {} kN); torque about the centre of all mass {} kN·m. In the least favourable direction of shaking, the weaker component .85 of the stronger, {} and {} kN.", kn(cqc[0]), kn(cqc[1]), kn(srss[0]), kn(srss[1]), kn(sum[0]), kn(sum[1]), kn(spectral.base_torque_n_m), kn(worst[0]), kn(worst[1])),
            format!("CQC에 의한 밑면전단력은 x 방향 {} kN, y 방향 {} kN(SRSS {}, {}; 절대합 {}, {} kN)이고 전체 질량중심에 대한 비틀림모멘트는 {} kN·m이다. 가장 불리한 지진 방향(약축 성분 0.85)에서는 {}, {} kN이다.", kn(cqc[0]), kn(cqc[1]), kn(srss[0]), kn(srss[1]), kn(sum[0]), kn(sum[1]), kn(spectral.base_torque_n_m), kn(worst[0]), kn(worst[1])),
        )) }
        (moved(answer, (&spectral.displacement_m, &spectral.edge_drift_m), language, language.pick(
            "Largest elastic response, without dampers. Modes by CQC with the damping of each, shaking along x and y by the root of the sum of squares.",
            "최대 탄성응답(제진장치 제외). 모드는 각 감쇠비를 고려한 CQC로, x·y 방향 지진은 제곱합의 제곱근으로 조합하였다.",
        )))
    }
}

/// Floors and the storeys below them.
fn moved(
    answer: &BuildingAnswer,
    (displacement_m, edge_drift_m): (&[[f64; 2]], &[Option<[f64; 2]>]),
    language: Language,
    caption: &str,
) -> Markup {
    let head = [
        language.pick("Floor", "층").to_owned(),
        language.pick("x (mm)", "변위 x (mm)").to_owned(),
        "y (mm)".to_owned(),
        language
            .pick("edge drift x (mm)", "단부 층간변위 x (mm)")
            .to_owned(),
        "y (mm)".to_owned(),
        language.pick("of the height", "층고에 대한 비").to_owned(),
    ];
    let storeys = answer.elastic.storeys();
    let largest_m = displacement_m
        .iter()
        .flatten()
        .fold(0.0_f64, |most, x| most.max(x.abs()));
    let rows: Vec<Vec<Cell>> = (0..storeys.len())
        .rev()
        .map(|i| {
            let [x, y] = displacement_m[i];
            let mm = |value: f64| significant_beside(1e3 * value, 1e3 * largest_m, 3);
            let mut row: Vec<Cell> = vec![answer.floors[i].clone().into(), mm(x).into(), mm(y).into()];
            row.extend(match edge_drift_m[i] {
                Some([x, y]) => [mm(x), mm(y), percent(x.max(y) / storeys[i].height_m, 3)].map(Cell::from),
                None => ["–", "–", "–"].map(|none| none.to_owned().into()),
            });
            row
        })
        .collect();
    table(caption, 1, &head, &rows)
}

/// With the dampers.
fn damped_spectrum(
    answer: &BuildingAnswer,
    damped: &DampedSpectral,
    standing: &StandingBuilding,
    language: Language,
) -> Markup {
    let largest_n = damped.base_shear_n[0].abs().max(damped.base_shear_n[1].abs());
    let kn = |value: f64| significant_beside(1e-3 * value, 1e-3 * largest_n, 4);
    let [x, y] = damped.base_shear_n.map(kn);
    let strokes: Vec<String> = strokes_of(&standing.dampers)
        .iter()
        .zip(&damped.strokes_m)
        .map(|(damper, stroke_m)| format!("{} {}\u{202f}mm", damper.name, significant(1e3 * stroke_m, 4)))
        .collect();
    let list = strokes.join(", ");
    let torque = kn(damped.base_torque_n_m);
    html! {
        p { (language.pick(
            format!("With the dampers: base shear along x {x} kN, along y {y} kN, torque {torque} kN·m; strokes {list}."),
            format!("제진장치 포함: 밑면전단력 x 방향 {x} kN, y 방향 {y} kN, 비틀림 모멘트 {torque} kN·m, 행정 {list}."),
        )) }
        (moved(answer, (&damped.displacement_m, &damped.edge_drift_m), language, language.pick(
            "Largest elastic response with the dampers. Complex modes by CQC for damping that couples them.",
            "제진장치를 포함한 최대 탄성응답. 비고전감쇠 복소모드를 CQC로 조합하였다.",
        )))
    }
}
