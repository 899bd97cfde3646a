//! What looks like a slip, whatever the kind.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// What looks like a slip, whatever the kind.
    pub(crate) enum Slip in "project.error.slips" {
        GravityIsNotThat { written: String } => {
            en: "gravity = {written} is not that of the Earth, 9.78 to 9.83 m/s2",
            ko: "gravity = {written}은(는) 지구의 중력가속도(9.78~9.83 m/s2)가 아니다",
        },
        GalMS2And => {
            en: "981 gal, 9.81 m/s2 and 1 g are the same",
            ko: "981 gal, 9.81 m/s2, 1 g은 같은 값이다",
        },
        ButStructuresSwayAt { path: String, written: String, least: String, most: String } => {
            en: "{path} = {written}, but structures sway at {least} to {most} Hz",
            ko: "{path} = {written}인데, 구조물의 진동수는 {least}~{most} Hz이다",
        },
        DidYouMeanKhz => { en: "did you mean kHz?", ko: "kHz 단위인가?" },
        DidYouMeanMhz => { en: "did you mean mHz or 1/min?", ko: "mHz 또는 1/min 단위인가?" },
        ButStructuresHaveTo { path: String, written: String } => {
            en: "{path} = {written}, but structures have 0.005 to 0.1",
            ko: "{path} = {written}인데, 구조물의 감쇠비는 0.005~0.1이다",
        },
        DidYouMean { name: String } => { en: "did you mean {name}?", ko: "단위가 {name}인가?" },
        ItIsAboutWhat { ratio: String } => {
            en: "it is about {ratio} × what is usual: check its unit",
            ko: "보통 값의 약 {ratio}배이다. 단위를 확인한다",
        },
        Above { ratio: String, part: Both } => {
            en: "{ratio} × the {part} above",
            ko: "위 {part}의 {ratio}배이다",
        },
        Below { ratio: String, part: Both } => {
            en: "{ratio} × the {part} below",
            ko: "아래 {part}의 {ratio}배이다",
        },
        OfAbove { ratio: String, part: Both } => {
            en: "{ratio} of the {part} above",
            ko: "위 {part}의 {ratio}이다",
        },
        OfBelow { ratio: String, part: Both } => {
            en: "{ratio} of the {part} below",
            ko: "아래 {part}의 {ratio}이다",
        },
        Beside { path: String, written: String, beside: Both } => {
            en: "{path} = {written}, {beside}",
            ko: "{path} = {written}인데, {beside}",
        },
        Link => { en: "link", ko: "부재" },
        Stone => { en: "stone", ko: "석재" },
    }
}
