//! Probable slips in a stack.

use dolmen_words::messages;

messages! {
    /// Probable slips in a stack.
    pub(crate) enum StackSlip in "project.error.stack-slips" {
        BlocksLastStoneStands { top: String, last_m: String, foot: String, first_m: String } => {
            en: "blocks: the last stone, '{top}', stands on top and is {last_m} m wide, the first, '{foot}', stands on the ground and is {first_m} m",
            ko: "blocks: 마지막 석재 '{top}'은(는) 맨 위에 있고 폭이 {last_m} m, 첫 석재 '{foot}'은(는) 지반 위에 있고 폭이 {first_m} m이다",
        },
        NamesBeginWithTop { foot: String, top: String } => {
            en: "blocks: the first stone, '{foot}', stands on the ground and the last, '{top}', on top, but by their names the list begins with the top",
            ko: "blocks: 첫 석재 '{foot}'이(가) 지반 위에, 마지막 석재 '{top}'이(가) 맨 위에 놓였으나 이름으로 보면 위에서부터 적은 목록이다",
        },
        ListStonesLowestFirst => {
            en: "list the stones lowest first, or say with on what each stands on",
            ko: "석재를 아래에서부터 쓰거나 각 석재가 놓인 곳을 on으로 밝힌다",
        },
        TieStiffness { path: String, written: String } => {
            en: "{path} = {written}, but dowels and clamps have 100 kN/m to 100 GN/m",
            ko: "{path} = {written}인데 촉과 은장은 100 kN/m~100 GN/m이다",
        },
        TieStrength { path: String, written: String } => {
            en: "{path} = {written}, but dowels and clamps bear 100 N to 50 MN",
            ko: "{path} = {written}인데 촉과 은장의 강도는 100 N~50 MN이다",
        },
        BesideStiffness { path: String, written: String } => {
            en: "{path} = {written}, but what stands beside stones has 10 kN/m to 100 GN/m",
            ko: "{path} = {written}인데 석재 옆의 지지물은 10 kN/m~100 GN/m이다",
        },
        BesideGap { path: String, written: String } => {
            en: "{path} = {written}, but stones that move by 2 m have fallen",
            ko: "{path} = {written}인데 석재가 2 m 움직이면 이미 낙하한 것이다",
        },
        Movement { path: String, written: String } => {
            en: "{path} = {written}, but supports move by millimetres to decimetres",
            ko: "{path} = {written}인데 지점 변위는 보통 수 mm~수십 cm이다",
        },
        ForceUnits => {
            en: "a stiffness is a force per length, \"20 kN/mm\", a strength a force, \"15 kN\"; bare numbers are in N/m and N unless units are given for them",
            ko: "강성은 단위 길이당 힘(\"20 kN/mm\"), 강도는 힘(\"15 kN\")이다. 단위 없는 수는 units가 없으면 N/m, N이다",
        },
        LeansFar { path: String, written: String } => {
            en: "{path} = {written} leans further than any stone stands",
            ko: "{path} = {written}은(는) 석재가 설 수 없을 만큼 큰 기울기이다",
        },
        TiltedIntoBed { path: String, written: String } => {
            en: "{path} = {written} presses an edge of the stone into a bed that is level: half the width times the tilt must be less than those 0.005 m. For a lean of the whole structure give the tilt of a survey; for one stone correct the tilt, or give its corners as they lie (shape = \"points\")",
            ko: "{path} = {written}이면 석재의 모서리가 수평인 접합면 속으로 들어간다. 반폭 × 기울기가 허용값 0.005 m보다 작아야 한다. 전체가 기울었으면 조사(survey)의 tilt로 주고, 석재 하나이면 기울기를 고치거나 꼭짓점을 실제 위치대로 준다(shape = \"points\")",
        },
        IsItInDegrees => {
            en: "a bare number is horizontal / vertical: \"1/177\", \"0.32 deg\", \"5.65 mm/m\". Is it in degrees?",
            ko: "단위 없는 수는 수평/수직 비이다: \"1/177\", \"0.32 deg\", \"5.65 mm/m\". 도(°) 단위인가?",
        },
        ButItIsTo { path: String, written: String, least: String, most: String } => {
            en: "{path} = {written}, but it is {least} to {most} m",
            ko: "{path} = {written}인데, 보통 {least}~{most} m이다",
        },
        ButPagodasHaveTo { path: String, written: String } => {
            en: "{path} = {written}, but pagodas have 1 to 20 m",
            ko: "{path} = {written}인데, 석탑은 1~20 m이다",
        },
        ButPagodasHaveToOther { path: String, written: String } => {
            en: "{path} = {written}, but pagodas have 0.2 to 0.6",
            ko: "{path} = {written}인데, 석탑은 0.2~0.6이다",
        },
        ItIsHalfWidth => {
            en: "it is half width over height of the centroid, or an angle with its unit: \"21 deg\"",
            ko: "무게중심 높이에 대한 반폭의 비이거나, 단위를 붙인 각도(\"21 deg\")이다",
        },
        ButStonesAreTo { least: String, most: String } => {
            en: "but stones are {least} to {most} m",
            ko: "석재는 {least}~{most} m이다",
        },
        IsMAcrossBut { path: String, name: String, extent: String, least: String, most: String } => {
            en: "{path}: '{name}' is {extent} m across, but stones are {least} to {most} m",
            ko: "{path}: '{name}'의 크기가 {extent} m인데, 석재는 {least}~{most} m이다",
        },
        FarFromOrigin { name: String, far: String, most: String } => {
            en: "'{name}' lies {far} km from the origin of its coordinates, as in the grid of a map: beyond {most} km rounding disturbs the forces in the joints",
            ko: "'{name}'이(가) 좌표 원점에서 {far} km 떨어져 있다. 지도 좌표계로 보이는데, {most} km를 넘으면 반올림 오차가 접합면의 힘을 흐트러뜨린다",
        },
        TakeOff { x: String, y: String } => {
            en: "take {x} off every x and {y} off every y, of all stones alike (programs for point clouds call that a global shift)",
            ko: "모든 석재의 x에서 {x}, y에서 {y}을(를) 똑같이 뺀다(점군 프로그램의 global shift)",
        },
        ButStoneHasTo { path: String, written: String } => {
            en: "{path} = {written}, but stone has 1500 to 3200 kg/m3",
            ko: "{path} = {written}인데, 석재의 밀도는 1500~3200 kg/m3이다",
        },
        DidYouMeanT { tonnes: String } => {
            en: "did you mean \"{tonnes} t/m3\"?",
            ko: "\"{tonnes} t/m3\"인가?",
        },
        KgM3TM3 => {
            en: "2600 kg/m3, 2.6 t/m3 and a unit weight of 25.5 kN/m3 are the same: is it in kg/m3?",
            ko: "2600 kg/m3, 2.6 t/m3, 단위중량 25.5 kN/m3은 같은 값이다. kg/m3 단위인가?",
        },
        ButStoneOnStone { path: String, written: String } => {
            en: "{path} = {written}, but stone on stone has 0.4 to 0.8",
            ko: "{path} = {written}인데, 석재 사이의 마찰계수는 0.4~0.8이다",
        },
        DidYouMean { percent: String } => { en: "did you mean \"{percent} %\"?", ko: "\"{percent} %\"인가?" },
        NarrowBetween { path: String, written: String, name: String, below: String, above: String, beside_m: String } => {
            en: "{path} = {written} makes ‘{name}’ less than a fifth as wide as what it lies between, ‘{below}’ and ‘{above}’, {beside_m} m and more",
            ko: "{path} = {written}이면 ‘{name}’의 폭이 위아래 부재 ‘{below}’, ‘{above}’({beside_m} m 이상)의 5분의 1에 못 미친다",
        },
        IsDigitMissing => {
            en: "stones of a tower are about as wide as their neighbours: is a digit missing?",
            ko: "쌓은 부재의 폭은 위아래 부재와 비슷하다. 숫자 하나를 빠뜨렸는가?",
        },
        HighBesideOthers { path: String, written: String, name: String, times: String } => {
            en: "{path} = {written} makes ‘{name}’ {times} × as high as the others usually are, and a needle",
            ko: "{path} = {written}이면 ‘{name}’의 높이가 다른 부재의 {times}배이고 폭에 비해 지나치게 높다",
        },
        IsItAngle { degrees: String, tangent: String } => {
            en: "is it an angle of friction of {degrees}°? Its tangent is the coefficient: write {tangent}",
            ko: "마찰각 {degrees}°인가? 마찰계수는 그 탄젠트이므로 {tangent}(으)로 쓴다",
        },
        ItIsFrictionCoefficient => {
            en: "it is the friction coefficient, not an angle",
            ko: "각도가 아니라 마찰계수이다",
        },
        ButJointsHaveE6 { path: String, written: String } => {
            en: "{path} = {written}, but joints have 1e6 to 1e13 Pa/m",
            ko: "{path} = {written}인데, 접합면 강성은 1e6~1e13 Pa/m이다",
        },
        DidYouMeanMpa => { en: "did you mean MPa/m or GPa/m?", ko: "MPa/m 또는 GPa/m 단위인가?" },
        GpaMIsE9 => { en: "1 GPa/m is 1e9 Pa/m", ko: "1 GPa/m은 1e9 Pa/m이다" },
        IsNormalStiffnessBut { path: String, written: String, ratio: String } => {
            en: "{path} = {written} is {ratio} × the normal stiffness, but joints have 0.3 to 1",
            ko: "{path} = {written}은(는) 수직강성의 {ratio}배인데, 접합면은 0.3~1배이다",
        },
        AreBothInSame => { en: "are both in the same unit?", ko: "두 값의 단위가 같은가?" },
        ButMortarHasKpa { path: String, written: String } => {
            en: "{path} = {written}, but mortar has 10 kPa to 1 MPa",
            ko: "{path} = {written}인데, 모르타르는 10 kPa~1 MPa이다",
        },
        ButStoneCrushesAtMpa { path: String, written: String } => {
            en: "{path} = {written}, but joints crush at 0.1 MPa to 1 GPa",
            ko: "{path} = {written}인데, 접합면의 압축강도는 0.1 MPa~1 GPa이다",
        },
        IsStrengthInMpa => {
            en: "bare numbers are in Pa: lime mortar has 0.5 to 5 MPa, granite 100 MPa and more",
            ko: "단위가 없으면 Pa이다. 석회 모르타르는 0.5~5 MPa, 화강암은 100 MPa 이상이다",
        },
        DidYouMeanKpa => { en: "did you mean kPa or MPa?", ko: "kPa 또는 MPa 단위인가?" },
        DidYouMeanPa => { en: "did you mean Pa or kPa?", ko: "Pa 또는 kPa 단위인가?" },
        ButItIsToOther { path: String, written: String } => {
            en: "{path} = {written}, but it is 0 to 1",
            ko: "{path} = {written}인데, 0~1이어야 한다",
        },
    }
}
