//! Errors of a building.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of a building.
    pub(crate) enum WrongBuilding in "project.error.building" {
        ButBuildingHasFloors { path: String, given: String, floors: String } => {
            en: "{path} = {given}, but the building has {floors} floors",
            ko: "{path} = {given}인데 건물은 {floors}개 층이다",
        },
        MustBeLowestTo(floors: String) => {
            en: "must be 1 (the lowest) to {floors}",
            ko: "1(최하층)~{floors}이어야 한다",
        },
        EccentricityOfCodes => {
            en: "it is a fraction of the side of a floor: codes have 0.05, which is \"5 %\"; 0 leaves accidental torsion out",
            ko: "바닥 변의 길이에 대한 비이다. 기준값은 0.05, 즉 \"5 %\"이며 0이면 우발비틀림을 제외한다",
        },
        BuildingNeedsFloors => { en: "a building needs floors", ko: "building에는 floors가 필요하다" },
        FloorsMassSidesHeight => {
            en: "floors = [ {{ mass = …, sides = [10, 8], height = …, walls = [ … ] }}, … ], lowest first",
            ko: "floors = [ {{ mass = …, sides = [10, 8], height = …, walls = [ … ] }}, … ]를 아래에서부터 쓴다",
        },
        FloorsHasFloorsIn(count: String) => {
            en: "floors has {count} floors in all",
            ko: "floors가 모두 {count}개 층이다",
        },
        MustBeAtMost(most: String) => { en: "must be at most {most}", ko: "{most} 이하이어야 한다" },
        TwoAreNamed { what: Both, name: String } => {
            en: "two {what} are named \"{name}\"",
            ko: "이름이 \"{name}\"인 {what}이(가) 둘이다",
        },
        GiveEachItsOwn => { en: "give each its own name", ko: "서로 다른 이름을 붙인다" },
        WallsOfOneStorey => { en: "walls of one storey", ko: "같은 층의 벽체" },
        HasBothGyrationAnd(path: String) => {
            en: "{path} has both gyration and inertia",
            ko: "{path}에 gyration과 inertia가 모두 있다",
        },
        KeepOneOfThem => {
            en: "keep one of them: inertia = mass × gyration²",
            ko: "둘 중 하나만 남긴다. inertia = mass × gyration²",
        },
        ItsCentreOfMass => { en: "its centre of mass", ko: "질량중심" },
        ItsRadiusOfGyration => { en: "its radius of gyration", ko: "회전반경" },
        HasNeitherSidesNor { path: String, what: Both } => {
            en: "{path} has neither sides nor outline, so that {what} is not known",
            ko: "{path}에 sides도 outline도 없어 {what}을(를) 알 수 없다",
        },
        GiveSidesXY(key: String) => {
            en: "give sides = [x, y], outline = [[x, y], …], or {key} = …",
            ko: "sides = [x, y], outline = [[x, y], …] 또는 {key} = …을(를) 입력한다",
        },
        AlongXAlongY => { en: "[along x, along y]", ko: "[x 방향, y 방향]" },
        HasBothSidesAnd(path: String) => {
            en: "{path} has both sides and outline",
            ko: "{path}에 sides와 outline이 모두 있다",
        },
        KeepOneOfThemSides => {
            en: "keep one of them: sides are those of a rectangle about the origin",
            ko: "둘 중 하나만 남긴다. sides는 원점을 중심으로 하는 직사각형의 변이다",
        },
        HasBothWallsAnd(path: String) => {
            en: "{path} has both walls and stiffness",
            ko: "{path}에 walls와 stiffness가 모두 있다",
        },
        KeepOneOfThemStiffness => {
            en: "keep one of them: the stiffness of a storey is the sum of its walls",
            ko: "둘 중 하나만 남긴다. 층의 강성은 벽체 강성의 합이다",
        },
        HasNeitherWallsNor(path: String) => {
            en: "{path} has neither walls nor stiffness",
            ko: "{path}에 walls도 stiffness도 없다",
        },
        GiveWallsXY => {
            en: "give walls = [ {{ x = …, y = …, stiffness_x = …, stiffness_y = … }}, … ], or stiffness = {{ x = …, y = …, rotation = …, centre = [x, y] }}",
            ko: "walls = [ {{ x = …, y = …, stiffness_x = …, stiffness_y = … }}, … ] 또는 stiffness = {{ x = …, y = …, rotation = …, centre = [x, y] }}를 입력한다",
        },
        HasNeitherStiffnessX(path: String) => {
            en: "{path} has neither stiffness_x nor stiffness_y",
            ko: "{path}에 stiffness_x도 stiffness_y도 없다",
        },
        GiveLateralStiffnessOf => {
            en: "give the lateral stiffness of the wall along x, along y, or both",
            ko: "벽체의 x 방향, y 방향 또는 양방향 횡강성을 입력한다",
        },
        HasBothMatrixAnd { path: String, other: String } => {
            en: "{path} has both matrix and {other}",
            ko: "{path}에 matrix와 {other}이(가) 모두 있다",
        },
        KeepOneOfThemMatrix => {
            en: "keep one of them: the matrix holds x, y and rotation",
            ko: "둘 중 하나만 남긴다. matrix에 x, y, rotation이 들어 있다",
        },
        MatrixIsNot(path: String) => {
            en: "{path}.matrix is not 3 × 3",
            ko: "{path}.matrix가 3 × 3이 아니다",
        },
        MustBeThreeRows => {
            en: "must be three rows of three numbers, against u, v, θ, in SI",
            ko: "u, v, θ에 대한 세 수씩 세 행(SI)이어야 한다",
        },
        IsMissing(key: String) => { en: "{key} is missing", ko: "{key}이(가) 없다" },
        StoreyResistsAlongX => {
            en: "a storey resists along x, along y, and against turning: rotation = \"… kN*m/rad\"",
            ko: "층은 x 방향, y 방향, 회전에 저항한다: rotation = \"… kN*m/rad\"",
        },
        TwoPointsAreNamed(name: String) => {
            en: "two points are named \"{name}\"",
            ko: "이름이 \"{name}\"인 점이 둘이다",
        },
        PointIsWhereIs { name: String, other: String } => {
            en: "point \"{name}\" is where \"{other}\" is",
            ko: "점 \"{name}\"의 위치가 점 \"{other}\"와(과) 같다",
        },
        IsItsPlaceRight => { en: "is its place right?", ko: "위치가 맞는가?" },
        Damping(why: Both) => { en: "damping: {why}", ko: "damping(감쇠): {why}" },
        ButFloorsHaveT { path: String, written: String } => {
            en: "{path} = {written}, but floors have 1 t to 20 000 t",
            ko: "{path} = {written}인데, 층의 질량은 1~20 000 t이다",
        },
        StoreyWithItsOwn { path: String, written: String, frequency_hz: String, least: String, most: String } => {
            en: "{path} = {written}: the storey with its own floor alone would sway at {frequency_hz} Hz, outside {least} to {most} Hz expected for a storey",
            ko: "{path} = {written}: 이 층과 그 바닥만의 진동수가 {frequency_hz} Hz인데, 층은 {least}~{most} Hz이다",
        },
        IsMLongBut { path: String, side_m: String, most: String } => {
            en: "{path} is {side_m} m long, but floors are at most {most} m",
            ko: "{path}의 길이가 {side_m} m인데, 바닥은 {most} m 이하이다",
        },
        AreItsSidesIn => { en: "are its sides in mm?", ko: "변의 단위가 mm인가?" },
        LiesMOffIts { path: String, written: String, beyond_m: String, side_m: String } => {
            en: "{path} = {written} lies {beyond_m} m off its floor, which is {side_m} m long",
            ko: "{path} = {written}이(가) 바닥에서 {beyond_m} m 벗어나 있다. 바닥의 길이는 {side_m} m이다",
        },
        IsItInM => {
            en: "is it in m, and from the same origin as the outline?",
            ko: "m 단위이며 outline과 같은 원점에서 잰 값인가?",
        },
        Floors => { en: "floors", ko: "층" },
    }
}
