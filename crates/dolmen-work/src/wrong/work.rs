//! Errors of the verbs, in both languages.

use crate::change_fault::ChangeFault;
use crate::error::WorkError;
use crate::known::known_beside;
use crate::motion::MotionRequestError;
use crate::portfolio::PortfolioError;
use crate::scanned::ScanError;
use crate::score::ScoreDesignsError;
use crate::sensors::SensorsError;
use crate::study::{JournalError, StudyError};
use dolmen::assess::AssessError;
use dolmen::blocks::BlocksError;
use dolmen::comparisons::ValidationError;
use dolmen::damper::DamperError;
use dolmen::dynamics::DynamicsError;
use dolmen::modal::ModalError;
use dolmen::monitoring::MonitoringError;
use dolmen::numeric::NumericError;
use dolmen::signal::SignalError;
use dolmen::stability::StabilityError;
use dolmen::structure::StructureError;
use dolmen::structure::building::BuildingError;
use dolmen::structure::stack::StackError;
use dolmen_project::{AngleError, DamperFault, ProjectError, StackFault};
use dolmen_records::motions::MotionError;
use dolmen_records::records::RecordError;
use dolmen_records::{FileError, LogError, PhotoError};
use dolmen_words::number::trimmed;
use dolmen_words::sentences;

sentences! {
    WorkError in "work.error" {
        Within { place, cause } as { place } => {
            en: "{place}",
            ko: "{place}",
        },
        NothingToWrite => {
            en: "nothing is written: no survey leads to one stiffness that the file can hold. Several solutions, one known only between bounds, directions of a chain that disagree, a lowest joint that its soil alone is softer than, a storey in plan whose centre of rigidity no mode tells, walls or a matrix of a building, what a record leads to whose sensors are doubted, and the springs of a stack are not written; `dolmen identify --full` says what was found",
            ko: "쓴 것이 없다. 파일에 쓸 수 있는 강성을 하나로 정하는 조사가 없다. 해가 여럿이거나 상·하한만 정해진 강성, 방향마다 다른 체인의 강성, 지반만의 강성보다 큰 맨 아래 접합부 강성, 모드로 강성 중심을 알 수 없는 건물의 평면 강성, 건물의 벽체나 행렬, 적층 구조의 스프링, 센서가 의심스러운 기록에서 구한 값은 쓰지 않는다. 추정 결과는 `dolmen identify --full`로 본다",
        },
        SpringsToType { survey, factor, keys } as { survey, factor, keys } => {
            en: "nothing is written: the springs of a stack are not written, since with other springs other joints close; type them and identify again. By survey {survey} all of them are {factor} times those of the file: in joint give {keys}, each with source = \"identified\" and survey = \"{survey}\"",
            ko: "쓴 것이 없다. 적층 구조는 강성이 바뀌면 닿는 접합면도 바뀌므로 강성을 직접 입력하고 다시 추정한다. {survey} 조사에 따르면 모든 접합부 강성은 파일 값의 {factor}배이다. joint에 {keys}을(를) 입력하고 각각 source = \"identified\", survey = \"{survey}\"를 함께 적는다",
        },
        SeveralToWrite { surveys } as { surveys: surveys.join(", ") } => {
            en: "nothing is written: several surveys determine the stiffness ({surveys}); name one with --survey",
            ko: "쓴 것이 없다. 강성을 정하는 조사가 여럿이다({surveys}). --survey로 하나를 지정한다",
        },
        NotInTheFile { path } => {
            en: "nothing is written: {path} does not stand in the project file itself; change it in the table that holds it",
            ko: "쓴 것이 없다. {path}은(는) 프로젝트 파일에 직접 쓴 값이 아니다. 그 값이 있는 표에서 고친다",
        },
        TooManyPhotos { most } => {
            en: "the photographs of one report hold more than {most} MiB together: save them smaller (3000 pixels across fill a page), or leave some out",
            ko: "보고서 하나의 사진이 모두 합쳐 {most} MiB를 넘는다. 더 작게 저장하거나(너비 3000픽셀이면 한 면에 충분하다) 몇 장을 뺀다",
        },
        LogUnit { stated, unit } => {
            en: "the file says that the readings are in \"{stated}\", the project that they are in \"{unit}\": correct unit, or name the column that is meant; if the file is wrong, correct the head of its column",
            ko: "파일에는 단위가 \"{stated}\"(으)로, 프로젝트에는 \"{unit}\"(으)로 되어 있다. unit을 고치거나 column에 맞는 열을 지정한다. 파일이 틀렸으면 열 이름을 고친다",
        },
        Outside { why } => {
            en: "{why}",
            ko: "{why}",
        },
        SamplesOfStack => {
            en: "--samples cannot draw for a stack yet: its verdict is without shaking; take --sensitivity for what moves it",
            ko: "--samples는 stack에는 아직 쓸 수 없다. stack의 판정은 지반운동이 없는 상태의 것이다. 무엇이 판정을 바꾸는지는 --sensitivity로 본다",
        },
        SampleNotANumber => {
            en: "the load factor of a sample is not a number: it must not be counted as standing",
            ko: "표본의 하중배율이 수가 아니다. 안정으로 셀 수 없다",
        },
        ScatterCrosses { smaller, smaller_cov, larger, larger_cov } as { smaller, smaller_cov: format!("{smaller_cov:.3}"), larger, larger_cov: format!("{larger_cov:.3}") } => {
            en: "{smaller} (cov {smaller_cov}) cannot stay below {larger} (cov {larger_cov}) with the means and the scatter of both, as it must: give both the same cov, or only the larger one",
            ko: "{smaller}(cov {smaller_cov})은(는) {larger}(cov {larger_cov})보다 작아야 하는데 두 값의 평균과 변동으로는 그럴 수 없다. 두 값의 cov를 같게 하거나 큰 값에만 준다",
        },
        NoSuchVariant { name, known } as { name, known: known_beside(name, known) } => {
            en: "there is no variant \"{name}\": the file has {known}",
            ko: "대안 \"{name}\"이(가) 없다. 파일에 있는 것: {known}",
        },
        NoSuchSurvey { name, known } as { name, known: known_beside(name, known) } => {
            en: "there is no survey \"{name}\": the file has {known}",
            ko: "조사 \"{name}\"이(가) 없다. 파일에 있는 것: {known}",
        },
        NoSuchReference { name, known } as { name: format!("{name:?}"), known } => {
            en: "modal.references names {name}, but the channels used are {known}",
            ko: "modal.references에 {name}이(가) 있는데 쓰는 채널은 {known}이다",
        },
        NoSuchInput { name, known } as { name: format!("{name:?}"), known } => {
            en: "modal.inputs names {name}, but the channels used are {known}",
            ko: "modal.inputs에 {name}이(가) 있는데 쓰는 채널은 {known}이다",
        },
        NoSuchSpectrogram { name, known } as { name: format!("{name:?}"), known } => {
            en: "modal.spectrogram names {name}, but the channels used are {known}",
            ko: "modal.spectrogram에 {name}이(가) 있는데 쓰는 채널은 {known}이다",
        },
        NoRecord => {
            en: "no survey of the project has a vibration record: write [survey.NAME.records] with its file",
            ko: "프로젝트에 진동 기록이 있는 조사가 없다. [survey.NAME.records]에 파일을 적는다",
        },
        WhichRecord { meant, known } => {
            en: "one record is wanted, but {meant} of the project are of that description: name the survey with --survey, and of several setups one with --setup ({known})",
            ko: "기록 하나를 지정해야 하는데 조건에 맞는 기록이 {meant}개이다. --survey로 조사를, 배치가 여럿이면 --setup으로 하나를 지정한다({known})",
        },
        NoneToFollow => {
            en: "no survey of the project has its vibration record in one file: records that come by themselves take sensors, units and channels from the latest such survey; add one to the project and store it with `dolmen survey add`",
            ko: "진동 기록을 파일 하나로 읽는 조사가 프로젝트에 없다. 들어오는 기록의 센서, 단위, 채널은 그런 최근 조사에서 가져온다. 조사를 프로젝트에 넣고 `dolmen survey add`로 저장한다",
        },
        NoMotionPrepared => {
            en: "the run was prepared without a motion",
            ko: "지반운동 없이 해석을 준비했다",
        },
        TwoHorizontal { what } => {
            en: "{what} moves in one direction, but the motion has the components x and y: give one file, or turn the motion and give the component that you mean as x",
            ko: "{what}은(는) 한 방향으로 움직이는데 지반운동에 x와 y 성분이 있다. 파일 하나만 주거나, 지반운동을 돌려 쓰려는 성분을 x로 준다",
        },
        FrameOfOneDirection { direction } => {
            en: "the motion has the components x and y, but the frame has one direction, {direction}: describe the other in [direction.NAME] too, or give one component",
            ko: "지반운동에 x와 y 성분이 있는데 골조에는 {direction} 방향만 있다. 다른 방향도 [direction.NAME]에 적거나 한 성분만 준다",
        },
        DirectionsNotAlong { directions } => {
            en: "the motion has the components x and y, and the frame the directions {directions}: write along = \"x\" in [direction.NAME] of one of two and along = \"y\" in the other, or give one component",
            ko: "지반운동에 x와 y 성분이 있고 골조의 방향은 {directions}이다. 두 방향의 [direction.NAME] 한쪽에 along = \"x\", 다른 쪽에 along = \"y\"를 적거나 한 성분만 준다",
        },
        DirectionOfBoth { direction } => {
            en: "--direction {direction} names one direction, but the motion has the components x and y, which act on both together: leave it out, or give one component",
            ko: "--direction {direction}은(는) 한 방향인데 지반운동의 x와 y 성분은 두 방향에 함께 작용한다. 이 옵션을 빼거나 한 성분만 준다",
        },
        OnePlaneFriction { joint } => {
            en: "the motion has the components x and y, but joint {joint} has friction, which acts against the turn of both together: leave the friction out, or give one component",
            ko: "지반운동에 x와 y 성분이 있으나 접합면 {joint}의 마찰은 두 방향의 회전에 함께 작용한다. 마찰을 빼거나 한 성분만 준다",
        },
        OnePlaneStrength { joint } => {
            en: "the motion has the components x and y, but the bed of joint {joint} has a strength, with which it bears less towards its corners: leave strength out, or give one component",
            ko: "지반운동에 x와 y 성분이 있으나 접합면 {joint}에 강도가 있어 모서리 쪽 저항이 줄어든다. strength를 빼거나 한 성분만 준다",
        },
        OnePlaneNoDepth { joint } => {
            en: "the motion has the components x and y, and the bed of joint {joint} can open: give its bed_depth across, or opening = \"held\", or one component of the motion",
            ko: "지반운동에 x와 y 성분이 있고 접합면 {joint}은(는) 벌어질 수 있다. 직각 방향 폭 bed_depth나 opening = \"held\"를 주거나 지반운동을 한 성분만 준다",
        },
        NoHorizontal { what } => {
            en: "{what} moves horizontally, but the motion has neither x nor y",
            ko: "{what}은(는) 수평으로 움직이는데 지반운동에 x도 y도 없다",
        },
        NoHorizontalOf { name } => {
            en: "motion \"{name}\" has no horizontal component",
            ko: "지반운동 \"{name}\"에 수평 성분이 없다",
        },
        SurveySimulated => {
            en: "only stacks, frames, chains and buildings can be simulated: the file has kind = \"survey\"",
            ko: "\"stack\", \"frame\", \"chain\", \"building\"만 해석할 수 있는데 이 파일은 kind = \"survey\"이다",
        },
        SurveyReported { file } => {
            en: "{file}: only stacks, frames and chains can be simulated; leave the motion out",
            ko: "{file}: \"stack\", \"frame\", \"chain\"만 해석할 수 있다. 지반운동을 뺀다",
        },
        PushOfOther => {
            en: "--push lets a chain lean at the start: the file has another kind",
            ko: "--push는 chain을 처음에 기울이는 것인데 이 파일은 다른 종류이다",
        },
        SlidingOfSupports => {
            en: "--law sliding follows blocks that slide on each other under a motion, and has no supports that move: leave it out, or take --law springs or rigid",
            ko: "--law sliding은 지반운동에서 서로 미끄러지는 부재를 해석하는 것으로 지점 변위를 다루지 못한다. 빼거나 --law springs 또는 rigid를 쓴다",
        },
        SlidingOfLoose => {
            en: "--law sliding follows blocks that slide on their beds, and loose stones have none: leave it out, or take --law springs or rigid",
            ko: "--law sliding은 접합면에서 미끄러지는 부재를 해석하는 것인데 돌무더기에는 접합면이 없다. 빼거나 --law springs 또는 rigid를 쓴다",
        },
        SpikesHideModes { channel, count, first_s } as { channel, count, first_s: trimmed(*first_s, 6) } => {
            en: "channel \"{channel}\": single samples far from their neighbours ({count}, the first at {first_s} s) hide every mode; loggers write such a number (9999, -9999) where they have no reading: correct these samples, or cut the record",
            ko: "채널 \"{channel}\": 주변과 동떨어진 단일 표본 {count}개(처음은 {first_s} s)에 모드가 모두 가려진다. 기록계는 값이 없을 때 이런 수(9999, -9999)를 쓴다. 그 표본을 고치거나 기록을 자른다",
        },
        PlacedVariant { variant } => {
            en: "the stones are loose, but those of the variant \"{variant}\" are placed (loose = false), and the two have different checks: give the variant loose stones, or put it in a file of its own",
            ko: "파일의 부재는 돌무더기인데 대안 \"{variant}\"의 부재는 쌓은 것(loose = false)이어서 검토 방법이 서로 다르다. 대안도 돌무더기로 하거나 별도 파일로 나눈다",
        },
        PushTooLarge { push_rad, most_rad } => {
            en: "--push is {push_rad} rad, but must be at most {most_rad} rad in size",
            ko: "--push가 {push_rad} rad인데 크기가 {most_rad} rad 이하이어야 한다",
        },
        NothingMovesChain => {
            en: "nothing moves the chain: give --motion or --motion-file, or let it lean at the start with --push \"1e-4 rad\"",
            ko: "chain을 움직이는 것이 없다. --motion이나 --motion-file을 주거나 --push \"1e-4 rad\"로 처음에 기울인다",
        },
        JointsUnknown => {
            en: "the joints are unknown: `dolmen identify` finds stiffness that measured modes allow; write it into joints or into a variant, and simulate that with --variant",
            ko: "접합부 강성을 알 수 없다. `dolmen identify`로 계측 모드에 맞는 강성을 구해 joints나 대안에 쓰고, 대안은 --variant로 해석한다",
        },
        DirectionUnknown { direction } => {
            en: "the stiffness of direction \"{direction}\" is unknown: `dolmen identify` finds those that its frequencies allow; write one of them into [direction.{direction}] or into a variant, and simulate that",
            ko: "방향 \"{direction}\"의 강성을 알 수 없다. `dolmen identify`로 계측 진동수에 맞는 강성을 구해 하나를 [direction.{direction}]이나 대안에 쓰고 해석한다",
        },
        NoSuchDirection { direction, known } as { direction, known: known_beside(direction, known) } => {
            en: "there is no direction \"{direction}\": the file has {known}",
            ko: "방향 \"{direction}\"이(가) 없다. 파일에 있는 것: {known}",
        },
        NoDirectionKnown { directions } => {
            en: "the stiffness of no direction is known ({directions}): `dolmen identify` finds those that measured frequencies allow; write one of them into [direction.NAME] or into a variant, and simulate that with --variant",
            ko: "강성을 아는 방향이 없다({directions}). `dolmen identify`로 계측 진동수에 맞는 강성을 구해 하나를 [direction.NAME]이나 대안에 쓰고, 대안은 --variant로 해석한다",
        },
        BuildingFalls => {
            en: "the building falls under its own weight, so that nothing was simulated: `dolmen check` says where",
            ko: "건물이 자중으로 쓰러져 해석하지 않았다. 어디서 쓰러지는지는 `dolmen check`로 본다",
        },
        NoWindGiven => {
            en: "--wind blows the wind of the file, and the file gives none: write wind = {{ speed = \"27 m/s\", means = \"10 min\", code = \"EN 1991-1-4\", terrain = \"III\", force_coefficient = 1.3 }} with your own numbers",
            ko: "--wind는 파일의 바람을 작용시키는데 파일에 바람이 없다. wind = {{ speed = \"27 m/s\", means = \"10 min\", code = \"EN 1991-1-4\", terrain = \"III\", force_coefficient = 1.3 }}을 실제 값으로 적는다",
        },
        WindAndMotion => {
            en: "--wind blows the wind of the file and moves no ground: leave --motion and what changes it out, or leave --wind out",
            ko: "--wind는 파일의 바람만 작용시키고 지반은 움직이지 않는다. --motion과 이를 바꾸는 옵션을 빼거나 --wind를 뺀다",
        },
        ThenWithoutMotion => {
            en: "--then is the second of two motions, and there is no first: give --motion or --motion-file too",
            ko: "--then은 두 지반운동 중 둘째인데 첫째가 없다. --motion이나 --motion-file도 준다",
        },
        ThenAndDuration => {
            en: "--duration is the length of a run of one motion, and with --then there are two, with the time to rest between them: leave --duration or --then out",
            ko: "--duration은 지반운동 하나의 해석 길이인데 --then을 주면 지반운동이 둘이고 그 사이에 멈출 시간이 있다. --duration이나 --then을 뺀다",
        },
        ThenComponents { first, second } => {
            en: "{first} and {second} shake along other components, x or y, and each direction meets one component: give both the same, for example with turn = \"90 deg\" in [motion.{second}]",
            ko: "{first}와(과) {second}의 수평 성분(x, y)이 서로 다른데 방향마다 한 성분이 작용한다. [motion.{second}]에 turn = \"90 deg\"를 주는 등 성분을 같게 한다",
        },
        NoWindAsked { flag } => {
            en: "--{flag} of a building is for histories of the wind: give --wind too, or leave --{flag} out",
            ko: "building의 --{flag}는 바람의 시간이력에 쓴다. --wind를 함께 주거나 --{flag}를 뺀다",
        },
        OutputStepOfWind => {
            en: "--output-step has no effect with --wind: histories of the wind are written at every step; give --step instead",
            ko: "--wind에는 --output-step이 쓰이지 않는다. 바람의 시간이력은 모든 시간 간격에서 쓴다. --step을 준다",
        },
        WindStepTooLong { step_s, most_s, mode_hz } as { step_s, most_s: format!("{most_s:.4}"), mode_hz: format!("{mode_hz:.3}") } => {
            en: "--step is {step_s} s, but gusts reach a quarter of the rate of samples, and the mode at {mode_hz} Hz needs them well beyond it: give at most {most_s} s, or leave --step out",
            ko: "--step이 {step_s} s인데 난류는 표본화 진동수의 4분의 1까지만 들어가므로 {mode_hz} Hz 모드의 공진이 빠진다. {most_s} s 이하로 주거나 --step을 뺀다",
        },
        PointNotWatched => {
            en: "a point of the file was not watched",
            ko: "파일의 점 하나를 살피지 않았다",
        },
        CaseRefused { why } => {
            en: "{why}",
            ko: "{why}",
        },
        NoSuchDamper { name, file } => {
            en: "there is no damper \"{name}\" in {file} that stands at a place to be found: \"tmd\" and \"tlcd\" do, \"tlcmd\" and \"link\" are tuned with the others, without --damper",
            ko: "{file}에 위치를 찾는 감쇠기 \"{name}\"이(가) 없다. \"tmd\"와 \"tlcd\"는 위치를 찾고, \"tlcmd\"와 \"link\"는 --damper 없이 다른 것과 함께 동조한다",
        },
        NoDamper { file } => {
            en: "{file} has no damper to tune: write a table such as [damper.roof] with kind = \"tmd\", floor, place, direction, mass_ratio and tuning, in the file or in a variant",
            ko: "{file}에 동조할 감쇠기가 없다. 파일이나 대안에 kind = \"tmd\"와 floor, place, direction, mass_ratio, tuning이 있는 [damper.roof]와 같은 표를 쓴다",
        },
        TuneOfOther => {
            en: "only buildings have dampers to tune: the file has another kind; start one with kind = \"building\"",
            ko: "감쇠기를 동조하는 것은 building뿐인데 이 파일은 다른 종류이다. kind = \"building\"으로 시작한다",
        },
        TuneWithoutWind => {
            en: "--load gusts is the wind of the file, which gives none: write wind = {{ speed, means = \"10 min\", code, terrain, force_coefficient }}, or take --load wind with --corner",
            ko: "--load gusts는 파일의 바람인데 파일에 바람이 없다. wind = {{ speed, means = \"10 min\", code, terrain, force_coefficient }}를 쓰거나 --load wind와 --corner를 쓴다",
        },
        BuildingFallsItself => {
            en: "the building falls under its own weight: `dolmen check` says where",
            ko: "건물이 자중으로 쓰러진다. 어디서 쓰러지는지는 `dolmen check`로 본다",
        },
        TunedToNoMode => {
            en: "it is tuned to no mode",
            ko: "동조하는 모드가 없다",
        },
        FloorWithoutOutline { floor } => {
            en: "floor {floor} has no outline, so that places on it are not known: give sides or outline in its table",
            ko: "바닥 {floor}의 외곽선이 없어 그 위의 위치를 알 수 없다. 그 표에 sides나 outline을 쓴다",
        },
        NoSuchFloors { from, to, count } => {
            en: "--floors is {from}-{to}, and the building has floors 1 to {count}: write all, or the lower and the upper one of these, such as 1-{count}",
            ko: "--floors는 {from}-{to}인데 건물의 바닥은 1번부터 {count}번까지이다. all을 쓰거나 1-{count}처럼 이 가운데 낮은 바닥과 높은 바닥을 쓴다",
        },
        PagodaUnlike { how } => {
            en: "the score does not know such a pagoda: {how}. Simulate it with dolmen study, or force the score with --extrapolate; a measured frequency alone is for dolmen score --given SURVEY",
            ko: "이런 석탑은 점수로 평가할 수 없다: {how}. dolmen study로 해석하거나 --extrapolate로 점수를 낸다. 실측 고유진동수만 다르면 dolmen score --given SURVEY를 쓴다",
        },
        NoPagoda { file } => {
            en: "{file} has no pagoda given by six factors: write pagoda = {{ storeys = 5, body_height = 6.0, … }} in a stack, or simulate its blocks with dolmen study",
            ko: "{file}에 여섯 인자 점수에 쓸 석탑 정보가 없다. stack에 pagoda = {{ storeys = 5, body_height = 6.0, … }}를 추가하거나, 블록 모델은 dolmen study로 해석한다",
        },
        SurveyTellsNoFrequency { survey } => {
            en: "survey {survey} has no measured frequency of swaying along x or y: write frequencies = {{ x = [3.1] }} or modes into it, or find them in its record with dolmen identify",
            ko: "조사 {survey}에 x나 y 방향 흔들림의 실측 고유진동수가 없다. 그 조사에 frequencies = {{ x = [3.1] }}나 modes를 쓰거나, dolmen identify로 기록에서 구한다",
        },
        FrequencyBeyondDesigns { measured_hz, least_hz, most_hz } as { measured_hz: format!("{measured_hz:.2}"), least_hz: format!("{least_hz:.2}"), most_hz: format!("{most_hz:.2}") } => {
            en: "the measured frequency is {measured_hz} Hz, but the joints behind the score allow {least_hz} Hz to {most_hz} Hz for this pagoda: check the frequency and its direction, or simulate the pagoda with dolmen study",
            ko: "실측 고유진동수가 {measured_hz} Hz인데, 점수의 바탕이 된 접합면으로는 이 석탑에서 {least_hz}~{most_hz} Hz이어야 한다. 진동수와 방향을 확인하거나 dolmen study로 이 석탑을 해석한다",
        },
        TooFewDrawsNear { effective, least } as { effective: format!("{effective:.0}"), least } => {
            en: "the measured frequency leaves {effective} effective draws of the stiffness, and {least} are needed: give the frequency a standard deviation that its record has",
            ko: "실측 고유진동수에 맞는 강성 표본의 유효 개수가 {effective}인데 {least}개가 필요하다. 진동수에 기록에서 얻은 표준편차를 준다",
        },
        TooFewDesigns { designs } => {
            en: "{designs} designs are too few for a score: 50 and more with a curve are needed",
            ko: "점수를 내기에는 설계 {designs}개가 너무 적다. 곡선이 있는 설계가 50개 이상 필요하다",
        },
        TooFewDesignsOfState => {
            en: "the score has too few designs of this state",
            ko: "점수에 이 손상상태의 설계가 너무 적다",
        },
        NoneRanked { structures, reasons } => {
            en: "none of {structures} structures can be ranked:{reasons}",
            ko: "구조물 {structures}기 가운데 순위를 매길 수 있는 것이 없다:{reasons}",
        },
        SurveyToRank => {
            en: "it is a survey without a structure (kind = \"survey\"), so nothing says how much shaking it bears: leave it out, or give the project of the structure",
            ko: "구조물이 없는 조사(kind = \"survey\")여서 저항능력을 알 수 없다. 목록에서 빼거나 구조물의 과제를 지정한다",
        },
        NoStudyToRankBy { file } => {
            en: "it has no study and is no pagoda of six factors: add a [study.NAME] with motions to {file}, run dolmen study {file}, and rank again",
            ko: "해석(study)도 여섯 인자의 석탑도 없다. {file}에 지진파를 쓰는 [study.이름]을 더하고 dolmen study {file}을(를) 실행한 뒤 다시 평가한다",
        },
        NothingToRankBy { file } => {
            en: "it has neither results of a study nor a pagoda of six factors: run dolmen study {file} first",
            ko: "study의 결과도 여섯 인자의 석탑도 없다. 먼저 dolmen study {file}을(를) 실행한다",
        },
        PalisadenWithoutRecord => {
            en: "palisaden has no record",
            ko: "palisaden에 기록이 없다",
        },
    }
    handed on { File(Box<FileError>), Project(Box<ProjectError>), Record(Box<RecordError>), Motion(Box<MotionError>), Photo(Box<PhotoError>), Log(Box<LogError>), Angle(Box<AngleError>), StackPart(Box<StackFault>), DamperPart(Box<DamperFault>), Change(Box<ChangeFault>), Portfolio(Box<PortfolioError>), Designs(Box<ScoreDesignsError>), Scan(Box<ScanError>), Sensors(Box<SensorsError>), Journal(Box<JournalError>), Assess(Box<AssessError>), Blocks(Box<BlocksError>), Building(Box<BuildingError>), Damper(Box<DamperError>), Dynamics(Box<DynamicsError>), Modal(Box<ModalError>), Numeric(Box<NumericError>), Signal(Box<SignalError>), Stability(Box<StabilityError>), Stack(Box<StackError>), Structure(Box<StructureError>), Validation(Box<ValidationError>), MotionRequest(Box<MotionRequestError>), Study(Box<StudyError>) }
    caused by { Within: cause }
}

sentences! {
    ChangeFault in "change.error" {
        NoSurvey { given, known } as { given, known: known_beside(given, known) } => {
            en: "there is no survey \"{given}\" with frequencies, modes, records, tilts or inspections: the file has {known}",
            ko: "진동수, 모드, 기록, 기울기 또는 점검 결과가 있는 조사 \"{given}\"이(가) 없다. 파일에 있는 것: {known}",
        },
        Unclear { known } => {
            en: "the file has no two surveys whose names begin with a date (2019, 2019-04 or 2019-04-02), so that it is not clear which came first: name them with --from and --to (it has {known})",
            ko: "파일에 날짜(2019, 2019-04 또는 2019-04-02)로 시작하는 이름의 조사가 둘이 아니어서 어느 것이 먼저인지 알 수 없다. --from과 --to로 지정한다(있는 것: {known})",
        },
        Same { given } => {
            en: "survey \"{given}\" cannot be compared with itself: name an earlier one with --from, or a later one with --to",
            ko: "조사 \"{given}\"을(를) 그 자신과 비교할 수 없다. 더 이른 조사를 --from으로, 더 나중 조사를 --to로 지정한다",
        },
        SameRecord { surveys, files } as { first: surveys[0], second: surveys[1], of_first: files[0], of_second: files[1] } => {
            en: "surveys \"{first}\" ({of_first}) and \"{second}\" ({of_second}) have the same record, byte for byte: name the file of each date. Where one file holds both, give each its own channels, or its own stretch with conditioning.cut",
            ko: "조사 \"{first}\"({of_first})와(과) \"{second}\"({of_second})의 기록이 바이트까지 같다. 날짜마다 그 날짜의 파일을 지정한다. 한 파일에 두 기록이 함께 있으면 조사마다 channels의 열을 따로 쓰거나 conditioning.cut으로 구간을 따로 지정한다",
        },
        TooFewToWatch { given, least } => {
            en: "{given} surveys of the file have modes, a tilt or an inspection, and a name that begins with a date (2026-03-10), but a history needs {least}: measure again; where there are two surveys, compare them with dolmen compare",
            ko: "모드, 기울기 또는 점검 결과가 있고 이름이 날짜(2026-03-10)로 시작하는 조사가 {given}회이다. 변화 이력을 분석하려면 이러한 조사가 {least}회 이상 있어야 한다. 더 계측하며, 조사가 2회이면 dolmen compare로 비교한다",
        },
    }
    handed on { Monitoring(MonitoringError), Assess(AssessError) }
}
