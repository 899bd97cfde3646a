//! Doubts about patterns over a whole file that look like a mistake, but may be right.

use dolmen_words::{Quantity, Sentence, messages};

messages! {
    /// A probable slip that the numbers alone cannot prove: the sentence names the likely correction, and the answer is given.
    pub enum Doubted in "project.doubt" {
        ChainOrder(ratio: Quantity) => {
            en: "links: each is heavier per length than the one below, the top {ratio} times the lowest: is the list top first? Links are listed lowest first",
            ko: "links: 위로 갈수록 단위 길이당 질량이 커져 최상부가 최하부의 {ratio}배이다. 위에서부터 적은 것이 아닌가? 부재는 아래에서부터 적는다",
        },
        StackOrder(share: Quantity) => {
            en: "blocks: the stones become wider upwards ({share} % more of the pairs than narrower ones): is the list top first? Stones are listed lowest first",
            ko: "blocks: 위로 갈수록 부재가 넓어진다(넓어지는 쌍이 좁아지는 쌍보다 {share} % 많음). 위에서부터 적은 것이 아닌가? 부재는 아래에서부터 적는다",
        },
        ColumnsUnread { file: String, heads: Vec<String> } => {
            en: "{file}: the model does not use the numbers of {heads}: if they matter, write them in the project file; if not, take the columns out",
            ko: "{file}: {heads} 열의 수는 모델에 쓰이지 않는다. 필요한 값이면 프로젝트 파일에 적고, 아니면 열을 삭제한다",
        },
        MeshLarge { path: String, name: String, extent: Quantity, height: Quantity, others: String } => {
            en: "{path}: '{name}' is {extent} across, in a stack {height} high; stones are seldom above 8 m, and stacks of scanned stones above 25 m. Is the mesh in another unit? Stone and stack would be {others}. «Write unit = \"mm\" or \"cm\" beside file; scale|Scale» a mesh in inches by 25.4 to mm",
            ko: "{path}: '{name}'의 크기가 {extent}, 전체 높이가 {height}이다. 석재가 8 m를, 스캔한 석조물이 25 m를 넘는 일은 드물다. 메시가 다른 단위가 아닌가? 그 단위로 본 석재와 전체의 크기: {others}. «file 옆에 unit = \"mm\" 또는 \"cm\"를 쓴다. »인치 메시는 25.4배 하여 mm로 한다",
        },
        FloorOrder(ratio: Quantity) => {
            en: "floors: no storey is softer than the one below, and the top one is {ratio} times as stiff as the lowest: is the list top first? Floors are listed lowest first",
            ko: "floors: 위로 갈수록 층강성이 커져 최상층이 최하층의 {ratio}배이다. 위에서부터 적은 것이 아닌가? 층은 아래에서부터 적는다",
        },
        TiltsDiffer { survey: String, measured: String, own: String } => {
            en: "survey {survey} measured a tilt of {measured}, but the blocks as the file places them lean by {own}: the file's own places are used; correct them, or the survey",
            ko: "{survey} 조사의 기울기는 {measured}인데 파일에 적은 부재 위치로는 {own}만큼 기울어 있다. 계산은 파일의 부재 위치로 하였다. 부재 위치나 조사 값을 바로잡는다",
        },
        CentroidsFromTop(share: Quantity) => {
            en: "centroid: every centre of mass lies above the middle of its link, at {share} of its length on average: are they measured from the top? A centroid is its height above the link's lower joint",
            ko: "centroid: 모든 부재의 무게중심이 가운데보다 위(평균 길이의 {share}배)에 있다. 위에서 잰 값이 아닌가? centroid는 부재의 아래 접합부에서 잰 높이이다",
        },
        Thin { width: Quantity, height: Quantity } => {
            en: "links: as stone the lowest would be {width} wide under a height of {height}: are the weights in tf or kgf (1 tf is 9.81 kN), or are they masses?",
            ko: "links: 석재로 보면 최하부 부재의 폭이 {width}이고 전체 높이는 {height}이다. 무게가 tf나 kgf(1 tf = 9.81 kN) 또는 질량이 아닌가?",
        },
        Thick { width: Quantity, height: Quantity } => {
            en: "links: as stone the lowest would be {width} wide under a height of only {height}: are the weights in kN where N, kgf or kg are meant (1 kN is 102 kgf)?",
            ko: "links: 석재로 보면 최하부 부재의 폭이 {width}이고 전체 높이는 {height}뿐이다. N, kgf 또는 kg 값을 kN으로 적은 것이 아닌가(1 kN = 102 kgf)?",
        },
        Beds(ratio: Quantity) => {
            en: "links: the beds are {ratio} times as wide as links of stone of that weight and length: are the weights in the unit that is written (1 tf is 9.81 kN), or the widths?",
            ko: "links: 접합면 폭이 같은 무게와 길이의 석재 부재 폭의 {ratio}배이다. 무게의 단위(1 tf = 9.81 kN) 또는 폭의 단위가 맞는가?",
        },
        LinkOdd { path: String, ratio: Quantity } => {
            en: "{path} makes the link {ratio} times as heavy per length as those below and above it: is it in tf, kgf or kg (1 tf is 9.81 kN)?",
            ko: "{path}에 따르면 이 부재의 단위 길이당 무게가 위아래 부재의 {ratio}배이다. tf, kgf 또는 kg 값이 아닌가(1 tf = 9.81 kN)?",
        },
        WeakJoints(share: Quantity) => {
            en: "joints: the stiffest has {share} of the weight times height above it, and a chain needs about 1: is the stiffness per degree (1 N·m/deg is 57.3 N·m/rad)?",
            ko: "joints: 가장 강한 접합부도 상부 무게 × 높이의 {share}배뿐이며 자립하려면 약 1배가 필요하다. 도(°)당 강성이 아닌가(1 N·m/deg = 57.3 N·m/rad)?",
        },
        StiffJoints(share: Quantity) => {
            en: "joints: the softest has {share} times the weight times height above it, stiffer than stone on stone: is its unit N·m/rad, kN·m/rad or N·mm/rad?",
            ko: "joints: 가장 약한 접합부도 상부 무게 × 높이의 {share}배로 석재 접합부보다 강하다. 단위가 N·m/rad, kN·m/rad, N·mm/rad 중 어느 것인가?",
        },
        AxialFactor(ratio: Quantity) => {
            en: "«axial_force|axial force»: in every storey it is {ratio} times the weight of the masses: is one of them in tf or kgf (1 tf is 9.81 kN), or a mass given as a weight?",
            ko: "«axial_force|축력»: 모든 층에서 질량에 따른 무게의 {ratio}배이다. 어느 한쪽이 tf나 kgf(1 tf = 9.81 kN)이거나 무게를 질량으로 적은 것이 아닌가?",
        },
        FrictionWithoutWeight { path: String, coefficient: String } => {
            en: "{path} is 0, and so is the friction that {coefficient} takes from it: to leave P-delta out and keep the friction, give friction.force",
            ko: "{path}이(가) 0이므로 {coefficient}에 따른 마찰력도 0이다. P-델타 효과만 빼려면 friction.force로 마찰력을 준다",
        },
        FloorMass { path: String, per_area: Quantity } => {
            en: "{path} gives the floor {per_area}, and floors have 0.2 to 5 t/m²: is it a weight in kN (1 t weighs 9.81 kN), or in another unit?",
            ko: "{path}에 따르면 바닥의 질량이 {per_area}이다. 보통 0.2~5 t/m²이다. kN 단위의 무게(1 t = 9.81 kN)이거나 다른 단위가 아닌가?",
        },
        DampingHigh { path: String, value: Quantity } => {
            en: "{path} is {value}, twice or more what structures have (0.005 to 0.1): did you mean a tenth of it? 2 % is 0.02",
            ko: "{path}이(가) {value}(으)로 구조물의 값(0.005~0.1)보다 크다. 10분의 1이 아닌가? 2 %는 0.02이다",
        },
        DampingLow { path: String, value: Quantity } => {
            en: "{path} is {value}, far below what structures have (0.005 to 0.1): was it divided by 100 twice? 2 % is 0.02",
            ko: "{path}이(가) {value}(으)로 구조물의 값(0.005~0.1)보다 훨씬 작다. 100으로 두 번 나눈 것이 아닌가? 2 %는 0.02이다",
        },
        FrictionLow { path: String, value: Quantity } => {
            en: "{path} is {value}, and stone on stone has 0.4 to 0.8: did you mean ten times as much?",
            ko: "{path}이(가) {value}이며 석재 사이의 마찰계수는 0.4~0.8이다. 10배 값이 아닌가?",
        },
        SoftBed { path: String, sinks: Quantity } => {
            en: "{path}: under its own weight the lowest joint would give way by {sinks}: is it in MPa/m or GPa/m?",
            ko: "{path}: 자중만으로 최하부 접합면이 {sinks} 눌린다. MPa/m 또는 GPa/m 값이 아닌가?",
        },
        LoadSmall { path: String, force: Quantity, stone: String, ratio: Quantity } => {
            en: "{path}: a force of {force}, {ratio} times the weight of '{stone}': is it in kN«, as in force = [0, 0, \"-12 kN\"]»?",
            ko: "{path}: 힘이 {force}(으)로 ‘{stone}’ 무게의 {ratio}배이다. «force = [0, 0, \"-12 kN\"]처럼 »kN 값이 아닌가?",
        },
        LoadLarge { path: String, force: Quantity, stone: String, ratio: Quantity } => {
            en: "{path}: a force of {force}, {ratio} times the weight of '{stone}': is it in N? That stones crack or bend is not computed",
            ko: "{path}: 힘이 {force}(으)로 ‘{stone}’ 무게의 {ratio}배이다. N 값이 아닌가? 석재의 균열과 휨은 계산하지 않는다",
        },
        LoadUpwards { path: String, force: Quantity, stone: String } => {
            en: "{path} pulls '{stone}' upwards with {force}: z points up, so a weight has a negative third component",
            ko: "{path}이(가) ‘{stone}’을(를) {force}(으)로 위로 당긴다. z는 위쪽이므로 누르는 힘의 셋째 성분은 음수이다",
        },
        LoadOff { path: String, stone: String, away: Quantity } => {
            en: "{path} acts {away} off '{stone}': are the coordinates of its position in another order, or in another unit?",
            ko: "{path}의 작용점이 ‘{stone}’에서 {away} 떨어져 있다. 좌표의 순서나 단위가 다르지 않은가?",
        },
        WeightHolds { path: String, weight: Quantity } => {
            en: "{path} is {weight}, and weight holds stones against wind and thrust: a combination with the same loads and at most their own weight (codes have 0.9 or 1) is missing",
            ko: "{path}이(가) {weight}이나 자중은 풍하중과 추력에 저항한다. 같은 하중에 자중 계수가 1 이하인(기준은 0.9 또는 1) 하중조합이 없다",
        },
        Frequency { path: String, measured: Quantity, model: Quantity, likely: Sentence } => {
            en: "{path}: {measured} was measured and the model has {model}. {likely}",
            ko: "{path}: 실측 {measured}, 모델 {model}. {likely}",
        },
        RadiansPerSecond => { en: "The ratio is near 2π: is the measured one in rad/s?", ko: "비가 2π에 가깝다. 실측값이 rad/s가 아닌가?" },
        Period => { en: "The one is near the inverse of the other: is it a period in s?", ko: "서로 역수에 가깝다. 초 단위의 주기가 아닌가?" },
        PerDegree => { en: "The ratio is near √57.3: is the stiffness per degree or per radian?", ko: "비가 √57.3에 가깝다. 강성이 도(°)당인가, rad당인가?" },
        Tenfold => { en: "The ratio is near √10: is the stiffness or mass in tf or kgf (9.81), or off by a factor of 10?", ko: "비가 √10에 가깝다. 강성이나 질량이 tf, kgf(9.81)이거나 10배 틀린 것이 아닌가?" },
        Thousandfold => { en: "The ratio is near √1000: is the stiffness or mass off by a factor of 1000 (kN for N, t for kg)?", ko: "비가 √1000에 가깝다. 강성이나 질량이 1000배(kN과 N, t와 kg) 틀린 것이 아닌가?" },
        SurveysDiffer { path: String, measured: Quantity, others: Quantity } => {
            en: "{path}: frequency {measured}, where the other surveys have {others} for the same mode: is it in rad/s, or a period in s?",
            ko: "{path}: 진동수 {measured}, 같은 모드의 다른 조사는 {others}이다. rad/s이거나 초 단위의 주기가 아닌가?",
        },
        Warm { path: String, given: Quantity } => {
            en: "{path} = {given} is hotter than air gets: is it °F? (°F − 32) × 5/9 is °C",
            ko: "{path} = {given}은(는) 기온으로 볼 수 없게 높다. 화씨(°F)인가? (°F − 32) × 5/9가 섭씨이다",
        },
        WideCrack { path: String, given: Quantity } => {
            en: "{path}: a crack {given} wide: is it in mm? A number without a unit is in the lengths of the file: \"0.4 mm\"",
            ko: "{path}: 균열 폭이 {given}이다. mm 단위가 아닌가? 단위 없는 수는 파일의 길이 단위로 읽는다: \"0.4 mm\"",
        },
        LargeTilt { path: String, degrees: Quantity } => {
            en: "{path} is a tilt of {degrees}°: is it in degrees? A number without a unit is horizontal / vertical: \"1/177\", \"0.32 deg\", \"5.65 mm/m\"",
            ko: "{path}의 기울기가 {degrees}°이다. 도(°) 단위가 아닌가? 단위 없는 수는 수평/수직 비이다: \"1/177\", \"0.32 deg\", \"5.65 mm/m\"",
        },
        LargeTiltWritten { path: String, written: String, degrees: Quantity } => {
            en: "{path} = \"{written}\" is a tilt of {degrees}°, more than towers at their end lean (5.7°): check the number and its unit",
            ko: "{path} = \"{written}\"은(는) 기울기 {degrees}°로, 무너지기 직전의 탑(5.7°)보다 크다. 수와 단위를 확인한다",
        },
        SensorFar { path: String, away: Quantity } => {
            en: "{path}: the position of the sensor is {away} from the others: is it in mm, or one digit too long? Positions without a unit are in that of units.length, m if none is given",
            ko: "{path}: 센서 위치(position)가 다른 센서에서 {away} 떨어져 있다. mm 단위이거나 자릿수가 틀린 것이 아닌가? 단위 없는 위치는 units.length의 단위(없으면 m)이다",
        },
        TurnRadians { path: String, degrees: Quantity } => {
            en: "{path} is {degrees}°, a round part of π read as degrees: is the angle in radians?",
            ko: "{path}이(가) {degrees}°로 π의 배수를 도(°)로 읽은 값과 같다. 라디안이 아닌가?",
        },
        TurnedFar { path: String, degrees: Quantity } => {
            en: "{path}: the stone is turned by {degrees}°: is the angle in degrees, not rad?",
            ko: "{path}: 부재가 {degrees}° 회전하였다. rad가 아니라 도(°) 단위가 아닌가?",
        },
        Sways { frequency: Quantity, height: Quantity } => {
            en: "floors: a building {height} high would sway at {frequency}, and buildings have about 10 to 100 Hz over their height in m: is the stiffness in N/mm, kN/mm or kN/m, and the mass in t?",
            ko: "floors: 높이 {height}인 건물의 1차 고유진동수가 {frequency}이다. 보통 높이(m)로 나눈 10~100 Hz이다. 강성(N/mm, kN/mm, kN/m)과 질량(t)의 단위가 맞는가?",
        },
        InVariant { variant: String, said: Sentence } => {
            en: "in variant {variant}: {said}",
            ko: "대안 {variant}: {said}",
        },
    }
}
