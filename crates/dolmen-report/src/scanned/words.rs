//! Sentences on a scan cut into stones.

use dolmen_words::{Quantity, messages};

messages! {
    /// A scan, its beds and its stones.
    pub(crate) enum Scanned in "scanned" {
        Head(file: String) => { en: "Stones cut from {file}", ko: "{file}에서 자른 석재" },
        Whole { stones: usize, beds: usize, share: Quantity, volume: Quantity } => {
            en: "{stones} stones at {beds} beds; together they hold {share} of the scan's {volume}.",
            ko: "접합면 {beds}곳에서 석재 {stones}개로 잘랐다. 부피의 합은 스캔 부피 {volume}의 {share}이다.",
        },
        UnitRecognised { height: String, unit: &'static str, height_m: Quantity } => {
            en: "The file names no unit. Its height of {height} was read in {unit}, which makes {height_m}: if that is wrong, give --unit.",
            ko: "파일에 단위가 없다. 높이 {height}을(를) {unit} 단위로 보아 {height_m}(으)로 읽었다. 틀렸으면 --unit을 지정한다.",
        },
        Moved { x: Quantity, y: Quantity, z: Quantity } => {
            en: "The stones were moved by x {x}, y {y}, z {z}, so that the ground is at 0. Beds are given and shown in the coordinates of the file.",
            ko: "지반이 0이 되도록 석재를 x {x}, y {y}, z {z} 옮겼다. 접합면의 높이는 파일의 좌표로 주고 나타낸다.",
        },
        AtSteps(beds: usize) => {
            en: "Beds put at the step of the section next to the height given: {beds}. Look at the table and at drawing.svg.",
            ko: "주어진 높이 옆의 단면이 바뀌는 곳으로 옮긴 접합면: {beds}곳. 표와 drawing.svg에서 확인한다.",
        },
        StepsAllowed(steps: String) => {
            en: "The section steps within a stone, as --allow states: at {steps}. If a bed is there, the tower is weaker than computed.",
            ko: "--allow에 따라 한 석재 안에서 단면이 바뀌는 곳: {steps}. 그곳에 접합면이 있으면 탑은 계산보다 약하다.",
        },
        NoStep(beds: String) => {
            en: "Beds without a step of the section: {beds}. The scan does not show them; they are where you gave them.",
            ko: "단면이 바뀌지 않는 접합면: {beds}. 스캔에 나타나지 않으므로 주어진 높이에 두었다.",
        },
        Pieces(stones: String) => {
            en: "Separate pieces between two beds became stones of their own: {stones}. Take out of the scan what is no part of the tower.",
            ko: "두 접합면 사이에 떨어져 있어 따로 나눈 석재: {stones}. 탑의 일부가 아닌 것은 스캔에서 제거한다.",
        },
        Assumed => {
            en: "The beds are planes because they were cut: the outside of a scan shows neither how rough a joint is, nor how much of it bears, nor what is inside of a stone. Density and friction are assumed.",
            ko: "접합면은 잘라서 만든 평면이다. 스캔한 외면으로는 접합면의 거칠기, 실제 접촉 면적, 석재 내부를 알 수 없다. 밀도와 마찰계수는 가정값이다.",
        },
        Beds => { en: "Beds, and the sections just below and above.", ko: "접합면과 바로 아래, 위의 단면." },
        Number => { en: "bed", ko: "접합면" },
        Named => { en: "given", ko: "주어진 높이" },
        Cut => { en: "cut at", ko: "자른 높이" },
        Below => { en: "below", ko: "아래 단면적" },
        Above => { en: "above", ko: "위 단면적" },
        Stones => { en: "Stones.", ko: "석재." },
        Stone => { en: "stone", ko: "석재" },
        File => { en: "file", ko: "파일" },
        Volume => { en: "volume", ko: "부피" },
        Triangles => { en: "triangles", ko: "삼각형" },
        Name(name: String) => { en: "{name}", ko: "{name}" },
    }
}
