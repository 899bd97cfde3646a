//! Results that depend on assumed values.

use super::variants::title;
use super::variants::version;
use crate::document::{Finding, Tone};
use crate::html::words::{input_words, set};
use dolmen_project::{Cap, JointDefaults, Project, Quantity as Input, Structure};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::answer::CheckAnswer;
use dolmen_work::judgement::AssumedInputs;
use dolmen_work::state::VariantAnswer;

/// Number of inputs that a sentence names; further inputs are only counted.
const NAMED_MOST: usize = 3;

messages! {
    /// Assumed values.
    pub(crate) enum Assumed in "check.assumed" {
        All { assumed: usize, all: usize, parts: Vec<Sentence> } => {
            en: "Assumed, not measured, {assumed} of {all} inputs: {parts}.",
            ko: "실측이 아닌 가정값(입력 {all}개 중 {assumed}개): {parts}.",
        },
        Names(names: Both) => { en: "{names}", ko: "{names}" },
        NamesAndMore { names: Both, more: usize } => { en: "{names} and {more} more", ko: "{names} 외 {more}개" },
        StonesBody(inputs: Sentence) => {
            en: "{inputs} (every result that uses them)",
            ko: "{inputs}(이 값을 쓴 모든 결과가 이에 의존한다)",
        },
        Body(inputs: Sentence) => {
            en: "{inputs} (every result that uses them)",
            ko: "{inputs}(이 값을 쓴 모든 결과가 이에 의존한다)",
        },
        StonesStiffness(inputs: Sentence) => {
            en: "{inputs} (natural frequencies, demand on elastic joints and with it the verdict on the earthquake, and simulated motion rest on them; whether it stands and the limits do not)",
            ko: "{inputs}(고유진동수, 탄성 접합면의 요구 수준과 그에 따른 지진 판정, 지진응답이 이에 의존하며 자중에 대한 판정과 거동 시작 가속도는 무관하다)",
        },
        ChainStiffness(inputs: Sentence) => {
            en: "{inputs} (the verdict, the load factor, the margins and the modes rest on them; limits from weights and lengths do not)",
            ko: "{inputs}(판정, 하중배율, 여유도, 모드가 이에 의존하며, 무게와 길이로만 정해지는 한계값은 무관하다)",
        },
        Stiffness(inputs: Sentence) => {
            en: "{inputs} (the verdict, the load factor and the modes rest on them; limits from weights and lengths do not)",
            ko: "{inputs}(판정, 하중배율, 모드가 이에 의존하며, 무게와 길이로만 정해지는 한계값은 무관하다)",
        },
        Surveyed(inputs: Sentence) => {
            en: "{inputs} (the stiffness found from them is an illustration, not a finding)",
            ko: "{inputs}(이로부터 추정한 강성은 예시일 뿐 결과가 아니다)",
        },
        SurveysOnly(inputs: Sentence) => {
            en: "{inputs} (every change below rests on them: an illustration, not a finding)",
            ko: "{inputs}(아래의 변화는 모두 이에 의존하며 예시일 뿐이다)",
        },
        BuildingDamping(inputs: Sentence) => {
            en: "{inputs} (the response to spectra and motions rests on them; verdict and modes do not)",
            ko: "{inputs}(스펙트럼과 지진에 대한 응답이 이에 의존하며 판정과 모드는 무관하다)",
        },
        StonesDamping(inputs: Sentence) => {
            en: "{inputs} (simulated motion alone rests on them)",
            ko: "{inputs}(지진응답만 이에 의존한다)",
        },
        Damping(inputs: Sentence) => {
            en: "{inputs} (the response to the spectrum of a site and to motions, and changes from survey to survey, rest on them; stability and modes do not)",
            ko: "{inputs}(부지 스펙트럼과 지반운동에 대한 응답, 조사 사이의 변화가 이에 의존하며 안정성과 모드는 무관하다)",
        },
        OfVariant { variant: Both, inputs: Vec<Sentence> } => {
            en: "Every result of the variant “{variant}” rests on what is assumed, not measured: {inputs}.",
            ko: "대안 ‘{variant}’의 모든 결과는 실측이 아닌 가정값에 의존한다: {inputs}.",
        },
        Input { input: Both, written: String } => { en: "{input} {written}", ko: "{input} {written}" },
        Defaults(values: Vec<Sentence>) => {
            en: "{values} (not given for the joints, taken by Dolmen)",
            ko: "{values}(접합면에 입력하지 않아 Dolmen의 기본값을 적용)",
        },
        Friction(value: Quantity) => { en: "friction {value}", ko: "마찰계수 {value}" },
        NormalStiffness(value: Quantity) => { en: "normal stiffness {value}", ko: "수직강성 {value}" },
        ShearStiffness(value: Quantity) => { en: "shear stiffness {value}", ko: "전단강성 {value}" },
        DampingRatio(value: Quantity) => { en: "damping ratio {value}", ko: "감쇠비 {value}" },
        CapLeftOut => {
            en: "The part at the very top (cap stone) is left out of the model: the true limits are higher and the true margins lower than stated.",
            ko: "최상부 부재(옥개석)가 모델에서 제외되었다. 실제 한계 강성은 여기 값보다 크고 실제 여유도는 작다.",
        },
        OneScatter => {
            en: "The scatter of one input is itself assumed, and the probability rests on it.",
            ko: "입력 1개의 변동계수 자체가 가정값이며, 확률은 이에 의존한다.",
        },
        Scatter(count: usize) => {
            en: "The scatter of {count} inputs is itself assumed, and the probability rests on it.",
            ko: "입력 {count}개의 변동계수 자체가 가정값이며, 확률은 이에 의존한다.",
        },
    }
}

/// A cap stone that the model of a flagpole leaves out.
pub(super) fn cap_left_out(project: &Project) -> Option<Finding> {
    let is_left_out = matches!(&project.structure, Structure::Chain(part) if part.cap == Cap::LeftOut);
    is_left_out.then(|| Finding::key(Tone::Warn, Assumed::CapLeftOut))
}

/// Findings on assumptions of a check.
pub(super) fn findings(answer: &CheckAnswer) -> Vec<Finding> {
    let project = &answer.project;
    let mut all = Vec::new();
    let inputs = project.inputs();
    let scatters = inputs.iter().filter(|input| input.is_scatter_assumed()).count();
    let sampled = answer.state.as_ref().is_some_and(|state| state.sampled.is_some());
    if sampled && scatters > 0 {
        let said = match scatters {
            1 => Assumed::OneScatter,
            count => Assumed::Scatter(count),
        };
        all.push(Finding::new(Tone::Warn, said));
    }
    all.extend(of_project(project));
    all.extend(
        answer
            .variants
            .iter()
            .filter_map(|variant| of_variant(variant, &answer.project)),
    );
    all
}

/// Values that Dolmen assumes for joints of stones if the file gives none.
fn defaults(taken: &JointDefaults) -> Option<Sentence> {
    let bare = |value: f64| Quantity::new(value, Unit::ratio(), Digits::Trimmed(3));
    let stiffness = |value: f64| Quantity::new(value, Unit::si("Pa/m"), Digits::Significant(2));
    let each = [
        taken.friction.map(|value| Assumed::Friction(bare(value))),
        taken
            .normal_stiffness_pa_m
            .map(|value| Assumed::NormalStiffness(stiffness(value))),
        taken
            .shear_stiffness_pa_m
            .map(|value| Assumed::ShearStiffness(stiffness(value))),
        taken
            .damping_ratio
            .map(|value| Assumed::DampingRatio(bare(value))),
    ];
    let values: Vec<Sentence> = each.into_iter().flatten().map(Sentence::from).collect();
    (!values.is_empty()).then(|| Assumed::Defaults(values).into())
}

/// Finding for the project as it is; `None` if nothing is assumed.
pub(crate) fn of_project(project: &Project) -> Option<Finding> {
    let structure = &project.structure;
    let assumed: Vec<&Input> = project.inputs().into_iter().filter(|q| q.is_assumed()).collect();
    let is_without_model = matches!(structure, Structure::Survey);
    let is_damping = |q: &Input| q.path.contains("damping");
    let is_stiffness =
        |q: &Input| !is_damping(q) && (q.path.ends_with("stiffness") || q.path.contains("stiffness["));
    let is_surveyed = |q: &Input| q.path.starts_with("survey.") && !is_damping(q);
    let is_body = |q: &Input| !is_stiffness(q) && !is_damping(q) && !is_surveyed(q);
    let of = |which: &dyn Fn(&Input) -> bool| {
        let own: Vec<&Input> = assumed.iter().copied().filter(|q| which(q)).collect();
        named(project, &own)
    };
    let taken = match structure {
        Structure::Stack(part) => Some(part.joint_defaults()),
        _ => None,
    };
    let parts = [
        of(&is_body).map(|inputs| body_words(structure, inputs)),
        of(&is_stiffness).map(|inputs| stiffness_words(structure, inputs)),
        of(&|q| is_surveyed(q) || (is_without_model && is_damping(q))).map(|inputs| match is_without_model {
            true => Assumed::SurveysOnly(inputs),
            false => Assumed::Surveyed(inputs),
        }),
        of(&|q| !is_without_model && is_damping(q)).map(|inputs| damping_words(structure, inputs)),
    ];
    let parts = parts.into_iter().flatten().map(Sentence::from);
    let parts: Vec<Sentence> = parts.chain(taken.as_ref().and_then(defaults)).collect();
    let AssumedInputs { assumed, all } = AssumedInputs::of(project);
    // limits depend on friction, the response to an earthquake on stiffness
    let is_key = taken.is_some_and(|of| of.friction.is_some() || of.normal_stiffness_pa_m.is_some());
    (!parts.is_empty()).then(|| {
        let said = Assumed::All { assumed, all, parts };
        let finding = Finding::new(Tone::Warn, said).with_code("assumed-input");
        Finding { is_key, ..finding }
    })
}

/// "friction of the joints, width of body 1, width of roof 1 and 4 more"; `None` without an input.
fn named(project: &Project, inputs: &[&Input]) -> Option<Sentence> {
    let (some, rest) = inputs.split_at(inputs.len().min(NAMED_MOST));
    let names = Both::of(|language| {
        let each = some
            .iter()
            .map(|input| input_words(project, &input.path, language));
        each.collect::<Vec<_>>().join(", ")
    });
    match (some.is_empty(), rest.len()) {
        (true, _) => None,
        (false, 0) => Some(Assumed::Names(names).into()),
        (false, more) => Some(Assumed::NamesAndMore { names, more }.into()),
    }
}

fn body_words(structure: &Structure, inputs: Sentence) -> Assumed {
    match structure {
        Structure::Stack(_) => Assumed::StonesBody(inputs),
        Structure::Chain(_) | Structure::Frame(_) | Structure::Building(_) | Structure::Survey => {
            Assumed::Body(inputs)
        }
    }
}

fn stiffness_words(structure: &Structure, inputs: Sentence) -> Assumed {
    match structure {
        Structure::Stack(_) => Assumed::StonesStiffness(inputs),
        Structure::Chain(_) => Assumed::ChainStiffness(inputs),
        Structure::Frame(_) | Structure::Building(_) | Structure::Survey => Assumed::Stiffness(inputs),
    }
}

fn damping_words(structure: &Structure, inputs: Sentence) -> Assumed {
    match structure {
        Structure::Stack(_) => Assumed::StonesDamping(inputs),
        Structure::Building(_) => Assumed::BuildingDamping(inputs),
        Structure::Chain(_) | Structure::Frame(_) | Structure::Survey => Assumed::Damping(inputs),
    }
}

/// Assumptions that a variant adds, which affect all its results.
fn of_variant(variant: &VariantAnswer, project: &Project) -> Option<Finding> {
    let project = version(project, variant);
    let assumed = variant.own_inputs.iter().filter(|input| input.is_assumed());
    let said = |input: &Input| {
        Sentence::from(Assumed::Input {
            input: Both::of(|language| input_words(project, &input.path, language)),
            written: set(&input.written),
        })
    };
    let inputs: Vec<Sentence> = assumed.map(said).collect();
    (!inputs.is_empty()).then(|| {
        let variant = title(variant);
        Finding::new(Tone::Warn, Assumed::OfVariant { variant, inputs })
    })
}
