//! Errors of wind, loads and their combinations.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of wind, loads and their combinations.
    pub(crate) enum WrongLoads in "project.error.loads" {
        ThereIsNoPart { path: String, written: String } => {
            en: "{path}: there is no part \"{written}\"",
            ko: "{path}: 부재 \"{written}\"이(가) 없다",
        },
        PartsAreCalled { path: String, count: String, written: String } => {
            en: "{path}: {count} parts are called \"{written}\"",
            ko: "{path}: 이름이 \"{written}\"인 부재가 {count}개이다",
        },
        WriteForLowestTo { list: String, count: String } => {
            en: "write \"{list}[1]\" for the lowest to \"{list}[{count}]\"",
            ko: "가장 아래 \"{list}[1]\"부터 \"{list}[{count}]\"까지 번호로 쓴다",
        },
        IsNotOn { path: String, written: String, list: String, part: String } => {
            en: "{path} = {written} is not on {list}[{part}]",
            ko: "{path} = {written}이(가) {list}[{part}] 위에 있지 않다",
        },
        MustBeTo { bottom: String, top: String } => {
            en: "must be {bottom} to {top}",
            ko: "{bottom}~{top}이어야 한다",
        },
        HeightsCountFromLowest => {
            en: "heights count from the lowest joint; name the part that stands there",
            ko: "높이는 가장 아래 접합부에서 잰다. 그 높이에 있는 부재의 이름을 쓴다",
        },
        HeightsCountFromFeet => {
            en: "heights count from the feet of the lowest columns; name the storey that carries it, and only an area of wind may lie above its storey, as a roof does",
            ko: "높이는 최하층 기둥의 바닥에서 잰다. 이를 지지하는 층의 이름을 쓴다. 지붕처럼 층 위에 놓일 수 있는 것은 바람을 받는 면적뿐이다",
        },
        ForceOnFrameNeedsDirection(path: String) => {
            en: "{path} is one number, but the frame has several directions",
            ko: "{path}이(가) 수 하나이나 골조에 방향이 여럿이다",
        },
        GiveForceOfTwo => {
            en: "give force = [x, y]: [2, 0] pushes the direction along x alone",
            ko: "force = [x, y]로 입력한다. [2, 0]은 x를 따르는 방향만 민다",
        },
        ForceOnFrame(path: String) => {
            en: "{path} has the wrong number of components: a storey is pushed along its directions",
            ko: "{path}의 성분 수가 맞지 않는다. 층에는 골조의 방향을 따라 힘이 작용한다",
        },
        GiveForceAlongOne => {
            en: "the frame has one direction: give one number, force = \"2 kN\"",
            ko: "골조의 방향이 하나이므로 force = \"2 kN\"처럼 수 하나를 쓴다",
        },
        NothingAlong { path: String, component: String } => {
            en: "{path} pushes along {component}, but no direction of the frame lies along {component}",
            ko: "{path}은(는) {component} 방향의 힘인데 {component}를 따르는 골조의 방향이 없다",
        },
        WriteAlong(component: String) => {
            en: "write direction.NAME.along = \"{component}\" where a direction has another name, or 0 if nothing pushes there",
            ko: "방향의 이름이 다르면 direction.이름.along = \"{component}\"를 쓰고, 힘이 없으면 0을 쓴다",
        },
        GiveForceOrWeight => {
            en: "give force = … (from the side) or weight = …",
            ko: "force = …(수평) 또는 weight = …를 입력한다",
        },
        MomentOfStoreyIs => {
            en: "take it out: a storey sways on hinged columns, which a moment does not push. Give the force that makes the moment, at the level where it acts",
            ko: "삭제한다. 층은 양단 핀 기둥 위에서 수평으로 움직이므로 모멘트는 층을 밀지 않는다. 모멘트를 만드는 힘을 그 힘이 작용하는 층에 입력한다",
        },
        WindAreaOfIs(unknown: String) => {
            en: "wind: the area of {unknown} that the wind meets is not known, in every direction",
            ko: "wind: {unknown}이(가) 바람을 받는 면적을 방향마다 알 수 없다",
        },
        GiveAreaOfStorey(first: String) => {
            en: "give wind.areas = [{{ part = \"{first}\", area = … }}] for its columns and walls, 0 where the wind meets none, with direction = \"…\" where the directions differ; and a roof as an area with a height",
            ko: "기둥과 벽체의 면적을 wind.areas = [{{ part = \"{first}\", area = … }}]로 입력하고 바람을 받지 않으면 0을 쓴다. 방향마다 다르면 direction = \"…\"을 쓰고, 지붕은 height가 있는 면적으로 쓴다",
        },
        ThereIsNoDirection { path: String, written: String } => {
            en: "{path}: the frame has no direction \"{written}\"",
            ko: "{path}: 골조에 \"{written}\" 방향이 없다",
        },
        DirectionsAre(names: String) => {
            en: "its directions are {names}",
            ko: "골조의 방향은 {names}이다",
        },
        IsNotReadFor(key: String) => {
            en: "{key} is not read for this kind of structure",
            ko: "이 종류의 구조물에는 {key}을(를) 쓰지 않는다",
        },
        TakeItOutWind => {
            en: "take it out: wind and static loads are for kind = \"chain\", \"stack\", \"frame\" and \"building\"",
            ko: "삭제한다. 풍하중과 정하중은 kind = \"chain\", \"stack\", \"frame\", \"building\"에만 쓴다",
        },
        WriteFloor(count: String) => {
            en: "write the name of a floor as it is in the file, or its number from the ground, \"1\" to \"{count}\"",
            ko: "파일에 있는 바닥의 이름이나 지반에서 센 번호 \"1\"~\"{count}\"을(를) 쓴다",
        },
        ForceOnFloorNeedsDirection(path: String) => {
            en: "{path} is one number, but a floor is pushed in two directions",
            ko: "{path}이(가) 수 하나이나 바닥에 작용하는 힘은 두 방향 성분이 필요하다",
        },
        GiveForceOfFloor => {
            en: "give force = [x, y], as [20, 0] along x, with position = [x, y] where it does not act at the centre of mass, or torque = …",
            ko: "force = [x, y]로 입력한다. [20, 0]은 x 방향이다. 작용점이 질량중심이 아니면 position = [x, y]을 함께 쓰거나 torque = …을 입력한다",
        },
        HasNoForceTorque(path: String) => {
            en: "{path} has no force or torque",
            ko: "{path}에 force도 torque도 없다",
        },
        PlaceBesideFloor { path: String, beyond: String, floor: String } => {
            en: "{path} lies {beyond} beside floor {floor}",
            ko: "{path}이(가) {floor}번 바닥에서 {beyond} 벗어나 있다",
        },
        GiveTorqueBeside => {
            en: "positions are in the axes of the plan; for a force that acts beside the floor give it at the edge and what is left of its torque as torque",
            ko: "position은 평면 좌표계의 값이다. 바닥 밖에 작용하는 힘은 단부에 입력하고 나머지 비틀림모멘트를 torque로 쓴다",
        },
        HeightOfFloorIs => {
            en: "take it out: a load acts on a floor. Give what acts between two floors to both, by the distances",
            ko: "삭제한다. 하중은 바닥에 작용한다. 두 바닥 사이의 하중은 거리에 따라 두 바닥에 나누어 입력한다",
        },
        WeightOfFloorIs => {
            en: "take it out: what rests on a floor and moves with it belongs to the mass of the floor",
            ko: "삭제한다. 바닥에 놓여 함께 움직이는 무게는 바닥의 mass에 포함한다",
        },
        MomentOfFloorIs => {
            en: "take it out: floors of this model do not tilt, so that an overturning moment moves nothing. A moment about the vertical is torque = …",
            ko: "삭제한다. 이 모델의 바닥은 기울지 않으므로 전도모멘트로 움직이지 않는다. 연직축에 대한 모멘트는 torque = …으로 쓴다",
        },
        TorqueOfBuilding => {
            en: "take it out: only the floors of kind = \"building\" turn about the vertical",
            ko: "삭제한다. 연직축에 대한 비틀림은 kind = \"building\"의 바닥에만 있다",
        },
        EarthquakeOfBuilding => {
            en: "take it out: only the drifts of kind = \"building\" are combined with those of an earthquake. The earthquake of [site] is judged by itself",
            ko: "삭제한다. 지진에 의한 층간변위와의 조합은 kind = \"building\"에만 있다. [site]의 지진은 따로 판정한다",
        },
        WriteSite => {
            en: "write [site] with its spectrum",
            ko: "[site]에 지점의 스펙트럼을 입력한다",
        },
        WriteWindSpeedMeans => {
            en: "write wind = {{ speed, means, force_coefficient }}, or wind = \"sheltered\"",
            ko: "wind = {{ speed, means, force_coefficient }} 또는 wind = \"sheltered\"를 쓴다",
        },
        WriteLoadsNameAt => {
            en: "write loads = [{{ name, at, force }}]",
            ko: "loads = [{{ name, at, force }}]를 쓴다",
        },
        ButFileHasNo { path: String, factor: String, key: String } => {
            en: "{path} = {factor}, but the file has no {key}",
            ko: "{path} = {factor}인데 파일에 {key}이(가) 없다",
        },
        OrTakeItOut(help: Both) => { en: "{help}; or take it out", ko: "{help}. 또는 삭제한다" },
        HasNoForceWeight(path: String) => {
            en: "{path} has no force, weight or moment",
            ko: "{path}에 force, weight, moment 중 아무것도 없다",
        },
        GiveForceFromSide => {
            en: "give force = … (from the side), weight = … or moment = …",
            ko: "force = …(수평), weight = … 또는 moment = …을 입력한다",
        },
        WeightLeavesNoWeight(path: String) => {
            en: "{path}.weight = 0 leaves no weight",
            ko: "{path}.weight = 0이면 무게가 없다",
        },
        StonesWithoutWeightHold => {
            en: "stones without weight hold nothing: give the factor on the weight, such as 0.9 or 1",
            ko: "석재는 무게가 없으면 저항하지 못한다. 자중의 하중계수를 0.9나 1과 같이 입력한다",
        },
        WriteNameOfStone => {
            en: "write the name of a stone as it is in the file",
            ko: "파일에 있는 석재의 이름을 쓴다",
        },
        HasNoForce(path: String) => { en: "{path} has no force", ko: "{path}에 force가 없다" },
        GiveForceOfThree => {
            en: "give force = [x, y, z], z upwards: [0.4, 0, 0] pushes along x, [0, 0, -2] presses down",
            ko: "force = [x, y, z]로 입력한다. z는 위쪽이며 [0.4, 0, 0]은 x 방향, [0, 0, -2]는 아래로 작용한다",
        },
        ForceOnStoneNeedsDirection(path: String) => {
            en: "{path} is one number, but a stone is pushed in three dimensions",
            ko: "{path}이(가) 수 하나이나 석재에 작용하는 힘은 세 방향 성분이 필요하다",
        },
        ForceIsFromSide(path: String) => {
            en: "{path} has components, but links are pushed along one direction; two, [x, y], where the chain has something of its own across (bed_depth)",
            ko: "{path}에 성분이 여러 개이나 이 구조물의 힘은 한 방향이다. 직각 방향의 값(bed_depth)이 있으면 [x, y] 두 성분을 쓴다",
        },
        IsNotReadHere(path: String) => {
            en: "{path} is not read here",
            ko: "{path}은(는) 여기에 쓰지 않는다",
        },
        WeightOfStoneIs => {
            en: "what rests on a stone and shakes with it is a block of its own; what only presses is force = [0, 0, -w]",
            ko: "석재 위에 놓여 함께 흔들리는 것은 별도의 블록으로, 누르기만 하는 것은 force = [0, 0, -w]로 쓴다",
        },
        MomentOfStoneIs => {
            en: "give the force where it acts: position = [x, y, z] may lie off the stone, as at the end of a bracket",
            ko: "힘을 작용점에 입력한다. position = [x, y, z]은 까치발 끝처럼 석재 밖이어도 된다",
        },
        PositionHasHeight => {
            en: "its z is the height: keep position or height",
            ko: "position의 z가 높이이므로 position과 height 중 하나만 쓴다",
        },
        GiveHeightInstead => {
            en: "give height, above the lowest joint",
            ko: "가장 아래 접합부에서 잰 height를 쓴다",
        },
        WriteMeansGustFor => {
            en: "write means = \"gust\" for a gust of some 3 s, or means = \"10 min\" with code = \"EN 1991-1-4\" or \"KDS 41 12 00\" for the mean that weather stations and maps of codes give: the force differs by a factor of 2 to 3",
            ko: "약 3초 가스트이면 means = \"gust\", 기상관측소나 기준의 풍속 지도와 같은 10분 평균이면 means = \"10 min\"과 code = \"EN 1991-1-4\" 또는 \"KDS 41 12 00\"을 쓴다. 둘의 풍력은 2~3배 차이가 난다",
        },
        WindWidthOfIs(unknown: String) => {
            en: "wind: the width of {unknown} is not known",
            ko: "wind: {unknown}의 폭을 알 수 없다",
        },
        GiveBreadthOrBed(first: String) => {
            en: "give {first}.breadth or bed_width, or wind.areas = [{{ part = \"{first}\", area = … }}]",
            ko: "{first}.breadth나 bed_width 또는 wind.areas = [{{ part = \"{first}\", area = … }}]를 입력한다",
        },
        WindHasBothSpeed => { en: "wind has both speed and pressure", ko: "wind에 speed와 pressure가 모두 있다" },
        KeepOneOfThem => {
            en: "keep one of them: pressure = ½ ρ speed²",
            ko: "둘 중 하나만 남긴다. pressure = ½ ρ speed²",
        },
        WindHasNeitherSpeed => {
            en: "wind has neither speed nor pressure",
            ko: "wind에 speed도 pressure도 없다",
        },
        GiveSpeedMS => {
            en: "give speed = \"30 m/s\" or pressure = \"0.6 kPa\", with means = \"gust\" or \"10 min\"",
            ko: "speed = \"30 m/s\" 또는 pressure = \"0.6 kPa\"를 means = \"gust\"나 \"10 min\"과 함께 입력한다",
        },
        WindDoesNotSay => {
            en: "wind does not say whether it is a gust or a mean",
            ko: "wind가 가스트인지 평균 풍속인지 알 수 없다",
        },
        WindHasCodeBut => {
            en: "wind has a code, but means = \"gust\": a code makes the gust from a 10-minute mean",
            ko: "wind에 code가 있는데 means = \"gust\"이다. code는 10분 평균에서 가스트를 계산한다",
        },
        WriteMeansMinIf => {
            en: "write means = \"10 min\" if speed is the basic wind speed of the code, else take code and terrain out",
            ko: "speed가 기준의 기본풍속이면 means = \"10 min\"으로 쓰고, 아니면 code와 terrain을 삭제한다",
        },
        WindPressureIsMean => {
            en: "wind.pressure is the mean of 10 minutes, which says nothing of gusts",
            ko: "wind.pressure는 10분 평균이어서 가스트를 알 수 없다",
        },
        GiveSpeedWithCode => {
            en: "give speed with a code, or the pressure of the gust with means = \"gust\"",
            ko: "speed를 code와 함께 주거나, 가스트의 pressure를 means = \"gust\"로 준다",
        },
        WindMeansMinBut => {
            en: "wind.means = \"10 min\", but no code makes the gust of it",
            ko: "wind.means = \"10 min\"인데 가스트를 계산할 code가 없다",
        },
        WriteCodeEnOr => {
            en: "write code = \"EN 1991-1-4\" or code = \"KDS 41 12 00\" with its terrain, or give the speed of the gust",
            ko: "code = \"EN 1991-1-4\" 또는 code = \"KDS 41 12 00\"을 terrain과 함께 쓰거나 가스트의 speed를 입력한다",
        },
        Code => { en: "a code", ko: "기준(code)" },
        Speed => { en: "a speed", ko: "풍속(speed)" },
        HasNoMeaningWithout { path: String, needs: Both } => {
            en: "{path} has no meaning without {needs}",
            ko: "{path}은(는) {needs} 없이는 쓰이지 않는다",
        },
        CodeEnHasTerrain => {
            en: "code = \"EN 1991-1-4\" has terrain \"0\" (sea), \"I\", \"II\", \"III\" (suburb, forest) or \"IV\" (town)",
            ko: "code = \"EN 1991-1-4\"의 terrain은 \"0\"(바다), \"I\", \"II\", \"III\"(교외, 숲), \"IV\"(도심)이다",
        },
        CodeKdsHasTerrain => {
            en: "code = \"KDS 41 12 00\" has terrain \"A\" (large town), \"B\", \"C\" (open country) or \"D\" (coast)",
            ko: "code = \"KDS 41 12 00\"의 terrain은 \"A\"(대도시 중심), \"B\", \"C\"(개활지), \"D\"(해안)이다",
        },
        WindHasCodeButNo => { en: "wind has a code, but no terrain", ko: "wind에 code가 있는데 terrain이 없다" },
        WindTerrainIsOne => {
            en: "wind.terrain is one of another code",
            ko: "wind.terrain이 다른 기준의 지표면조도구분이다",
        },
        GustOfMS => {
            en: "a gust of 30 m/s has 560 Pa; is it in Pa or kPa?",
            ko: "30 m/s 가스트의 속도압은 560 Pa이다. 단위가 Pa, kPa 중 어느 것인가?",
        },
        SpeedsAreInM => {
            en: "speeds are in m/s: 100 km/h is 28 m/s, 50 knots are 26 m/s",
            ko: "풍속의 단위는 m/s이다. 100 km/h는 28 m/s, 50노트는 26 m/s이다",
        },
        IsNoStormThat { path: String, written: String } => {
            en: "{path} = {written} is no storm that people design for",
            ko: "{path} = {written}은(는) 설계에 쓰는 바람이 아니다",
        },
        IsOutsideWhatBodies { path: String, written: String } => {
            en: "{path} = {written} is outside what bodies have",
            ko: "{path} = {written}은(는) 물체의 풍력계수 범위를 벗어난다",
        },
        IsNoLoad { path: String, written: String } => {
            en: "{path} = {written} is no load of a structure",
            ko: "{path} = {written}은(는) 구조물에 작용하는 하중으로 볼 수 없다",
        },
        LoadsAre => {
            en: "a banner in a storm pulls with 0.5 to 5 kN, snow on a roof weighs 1 to 100 kN: is it N, kN or MN?",
            ko: "폭풍 때 현수막은 0.5~5 kN으로 당기고 지붕의 눈은 1~100 kN이다. 단위가 N, kN, MN 중 무엇인가?",
        },
        WeightFactor { path: String, factor: String } => {
            en: "{path} = {factor}: no code multiplies the weight so",
            ko: "{path} = {factor}: 자중에 이런 계수를 곱하는 기준은 없다",
        },
        FactorsOfWeight => { en: "codes have 0.9 to 1.4", ko: "기준의 계수는 0.9~1.4이다" },
        SquarePrismHasOctagon => {
            en: "a square prism has 2.0, an octagon 1.3 to 1.45, a circle 0.7 to 1.2",
            ko: "정사각기둥 2.0, 팔각기둥 1.3~1.45, 원기둥 0.7~1.2이다",
        },
        WindDensityIsKg(density: String) => {
            en: "wind.density is {density} kg/m3",
            ko: "wind.density가 {density} kg/m3이다",
        },
        PressureOnBuilding => {
            en: "wind.pressure says nothing of how gusts come and go, which makes a building swing",
            ko: "wind.pressure로는 건물을 진동시키는 돌풍의 시간 변화를 알 수 없다",
        },
        GustOnBuilding => {
            en: "wind.means = \"gust\", but a building swings about the mean wind: taken for a mean, a gust would make the force 2 to 3 times what it is",
            ko: "wind.means = \"gust\"인데 건물의 진동에는 평균 풍속이 필요하다. 가스트를 평균으로 쓰면 풍력이 실제의 2~3배가 된다",
        },
        GiveMeanOfCode => {
            en: "give the 10-minute mean: speed with means = \"10 min\", code = \"EN 1991-1-4\" or \"KDS 41 12 00\" and its terrain",
            ko: "10분 평균 speed를 means = \"10 min\", code = \"EN 1991-1-4\" 또는 \"KDS 41 12 00\" 및 terrain과 함께 입력한다",
        },
        AreasOnBuilding => {
            en: "wind.areas is not read for a building",
            ko: "건물에는 wind.areas를 쓰지 않는다",
        },
        BreadthOfFloors => {
            en: "take it out: the wind meets the breadth of the floors over their storeys",
            ko: "삭제한다. 건물은 바닥의 폭과 층고로 바람을 받는 면적을 정한다",
        },
        BreadthUnknown(floor: String) => {
            en: "wind: the breadth of floors[{floor}] is not known",
            ko: "wind: floors[{floor}]의 폭을 알 수 없다",
        },
        GiveSidesOf(floor: String) => {
            en: "give floors[{floor}].sides or outline",
            ko: "floors[{floor}].sides나 outline을 입력한다",
        },
        ImportanceUnlikely(given: String) => {
            en: "wind.importance_factor = {given} is none of KDS 41 12 00",
            ko: "wind.importance_factor = {given}은(는) KDS 41 12 00에 없는 값이다",
        },
        ImportanceOfCode => {
            en: "the code has 0.9 for the least important buildings to 1.05",
            ko: "기준의 값은 중요도가 가장 낮은 건물의 0.9부터 1.05까지이다",
        },
        ComfortUnlikely(written: String) => {
            en: "wind.acceleration_limit = {written} is no limit of comfort",
            ko: "wind.acceleration_limit = {written}은(는) 사용성 한계로 볼 수 없는 값이다",
        },
        ComfortOfCodes => {
            en: "codes and guides allow 0.05 to 0.3 m/s2; at 1 m/s2 people hardly stand",
            ko: "기준과 지침의 값은 0.05~0.3 m/s2이며, 1 m/s2에서는 서 있기도 어렵다",
        },
        DriftUnlikely(written: String) => {
            en: "wind.drift_limit = {written} is more than codes allow in an earthquake",
            ko: "wind.drift_limit = {written}은(는) 지진 때 허용하는 값보다 크다",
        },
        DriftOfWind => {
            en: "limits for the wind are 1/200 to 1/500",
            ko: "바람에 대한 허용값은 1/200~1/500이다",
        },
        DriftOfHeight(given: String) => {
            en: "wind.drift_limit is {given} of the height",
            ko: "wind.drift_limit이 층고의 {given}이다",
        },
        DriftWithin { least: String, most: String } => {
            en: "must be {least} to {most}",
            ko: "{least}~{most}이어야 한다",
        },
        DriftPerCent => {
            en: "did you mean per cent? \"0.25 %\" is 0.0025, which is 1/400",
            ko: "백분율인가? \"0.25 %\"는 0.0025, 즉 1/400이다",
        },
        AirHasKgM3 => { en: "air has 1.2 kg/m3", ko: "공기의 밀도는 1.2 kg/m3이다" },
    }
}
