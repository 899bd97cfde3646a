//! Errors of a frame.

use dolmen_words::messages;

messages! {
    /// Errors of a frame.
    pub(crate) enum WrongFrame in "project.error.frame" {
        HasLawJenkinsBut(path: String) => {
            en: "{path} has law = \"jenkins\", but no slipping_stiffness",
            ko: "{path}에 law = \"jenkins\"가 있는데 slipping_stiffness가 없다",
        },
        GiveWhatIsLeft => {
            en: "give the stiffness that each storey keeps while its joints slip (0 if none)",
            ko: "접합부가 미끄러지는 동안 각 층에 남는 강성을 입력한다. 남지 않으면 0이다",
        },
        IsGivenButLaw(slipping_path: String) => {
            en: "{slipping_path} is given, but the law is \"coulomb\", which does not use it: its slider acts in parallel with the whole spring",
            ko: "{slipping_path}이(가) 있는데 law가 \"coulomb\"이다. 이 모델은 그 값을 쓰지 않으며 마찰 요소가 스프링 전체와 병렬로 작용한다",
        },
        WriteLawJenkinsOr => {
            en: "write law = \"jenkins\", or take slipping_stiffness out",
            ko: "law = \"jenkins\"로 쓰거나 slipping_stiffness를 삭제한다",
        },
        IsNotBelow { path: String, written: String, other: String, other_written: String } => {
            en: "{path} = {written} is not below {other} = {other_written}",
            ko: "{path} = {written}이(가) {other} = {other_written}보다 작지 않다",
        },
        StiffnessIsWhatVibration => {
            en: "stiffness is what vibration measures, with all joints stuck; slipping joints leave less",
            ko: "stiffness는 모든 접합부가 고착된 상태에서 진동으로 측정한 값이며, 미끄러지는 접합부의 강성은 그보다 작다",
        },
        ItIsSlipForce => {
            en: "coefficient is slip force ÷ axial force; to give forces, write force = [ … ]",
            ko: "coefficient는 축력에 대한 미끄러짐 힘의 비이다. 힘으로 주려면 force = [ … ]를 쓴다",
        },
        IsBelowCoefficient { fixed_path: String, written: String, other_written: String } => {
            en: "{fixed_path} = {written} is below coefficient = {other_written}",
            ko: "{fixed_path} = {written}이(가) coefficient = {other_written}보다 작다",
        },
        MustBeAtLeast => {
            en: "static_coefficient must be at least coefficient, the value while slipping",
            ko: "static_coefficient는 미끄러지는 동안의 값인 coefficient 이상이어야 한다",
        },
        HasBothForceAnd(path: String) => {
            en: "{path} has both force and static_coefficient",
            ko: "{path}에 force와 static_coefficient가 모두 있다",
        },
        GiveCoefficientAndStatic => {
            en: "give coefficient and static_coefficient, or force alone",
            ko: "coefficient와 static_coefficient를 주거나 force만 준다",
        },
        HasBothCoefficientAnd(path: String) => {
            en: "{path} has both coefficient and force",
            ko: "{path}에 coefficient와 force가 모두 있다",
        },
        KeepOneOfThem => {
            en: "keep one of them: force = coefficient × axial force",
            ko: "둘 중 하나만 남긴다. force = coefficient × 축력",
        },
        HasNeitherCoefficientNor(path: String) => {
            en: "{path} has neither coefficient nor force",
            ko: "{path}에 coefficient도 force도 없다",
        },
        WriteFrictionCoefficientOr => {
            en: "write friction = {{ coefficient = 0.3 }}, or force = [ … ] with one for each storey",
            ko: "friction = {{ coefficient = 0.3 }}을 쓰거나 force = [ … ]를 층마다 하나씩 쓴다",
        },
        FrameNeedsStoreys => { en: "a frame needs storeys", ko: "frame에는 storeys가 필요하다" },
        StoreysMassHeight => {
            en: "storeys = [ {{ mass = …, height = … }}, … ]",
            ko: "storeys = [ {{ mass = …, height = … }}, … ]를 쓴다",
        },
        AxialIsGivenBut => {
            en: "axial is given, but no storey has an axial_force",
            ko: "axial이 있는데 axial_force가 있는 층이 없다",
        },
        GiveEachStoreyIts => {
            en: "give each storey its axial_force, or take axial out: it then follows the masses",
            ko: "층마다 axial_force를 입력하거나 axial을 삭제한다. 삭제하면 축력은 질량으로 계산한다",
        },
        StoreysHasNoAxial(first: String) => {
            en: "storeys[{first}] has no axial_force, but another storey has",
            ko: "storeys[{first}]에 axial_force가 없는데 다른 층에는 있다",
        },
        GiveAllOfThem => {
            en: "give all of them, or none: they then follow from the masses",
            ko: "모든 층에 주거나 모두 삭제한다. 모두 없으면 질량으로 계산한다",
        },
        AxialForceIsGiven => {
            en: "axial_force is given without axial, which says what the force is",
            ko: "axial_force가 있는데 그 뜻을 정하는 \"axial\"이 없다",
        },
        WriteAxialStoreyIf => {
            en: "write axial = \"storey\" if it is the force in the storey's columns (its own level and all above), axial = \"level\" if it is the load added at its top",
            ko: "그 층 기둥의 축력(그 층과 위층 전체)이면 axial = \"storey\", 그 층 상단에 더해지는 하중이면 axial = \"level\"로 쓴다",
        },
        NothingAtSmallDrift(path: String) => {
            en: "{path} = 0: columns alone on rigid stones have no stiffness at small drift, and no frequency",
            ko: "{path} = 0: 강체 초석 위의 기둥만으로는 미소변형에서 강성과 고유진동수가 정해지지 않는다",
        },
        GiveBedStiffness(place: String) => {
            en: "give {place}.bed_stiffness, or \"unknown\": `dolmen check` then says what the columns hold",
            ko: "{place}.bed_stiffness를 입력하거나 \"unknown\"으로 쓴다. 기둥의 복원력은 `dolmen check`로 본다",
        },
        AloneGrounded(path: String) => {
            en: "{path} = 0: columns resist drift, but with convention = \"grounded\" the springs connect each storey to the ground",
            ko: "{path} = 0: 기둥은 층간변위에 저항하나 convention = \"grounded\"에서는 스프링이 각 층을 지반에 연결한다",
        },
        WriteDrift => {
            en: "write convention = \"drift\"",
            ko: "convention = \"drift\"로 쓴다",
        },
        AloneRubs(path: String) => {
            en: "{path} = 0: only columns carry this storey, so it has no joint with friction",
            ko: "{path} = 0: 기둥만으로 지지되는 층에는 마찰하는 접합부가 없다",
        },
        AloneHasTenons(path: String) => {
            en: "{path} = 0: only columns carry this storey, so it has no tenons",
            ko: "{path} = 0: 기둥만으로 지지되는 층에는 장부가 없다",
        },
        TakeTenonsOut(direction: String) => {
            en: "take direction.{direction}.tenons out, or give the stiffness within their slack",
            ko: "direction.{direction}.tenons를 삭제하거나 유격 안의 강성을 입력한다",
        },
        SlackIsRotation => {
            en: "slack is a rotation (storey drift ÷ storey height): write 0.004 or \"4 mm/m\". At 0.1 the storey counts as fallen",
            ko: "slack은 층고에 대한 층간변위, 곧 회전각이다. 0.004 또는 \"4 mm/m\"로 쓰며 0.1이면 전도로 본다",
        },
        HalfWithoutCrushing(half_path: String) => {
            en: "{half_path} is given, but no crushing_force: nothing is ever crushed",
            ko: "{half_path}이(가) 있는데 crushing_force가 없어 압괴가 일어나지 않는다",
        },
        GiveCrushingForce => {
            en: "give crushing_force of each storey, or take half_stiffness_depth out",
            ko: "층마다 crushing_force를 입력하거나 half_stiffness_depth를 삭제한다",
        },
        TakeFrictionOut(direction: String) => {
            en: "take direction.{direction}.friction out, or give the stiffness of its joints",
            ko: "direction.{direction}.friction을 삭제하거나 접합부의 강성을 입력한다",
        },
        BothAlong { name: String, other: String, component: String } => {
            en: "directions {other} and {name} both lie along {component}",
            ko: "{other} 방향과 {name} 방향이 모두 {component}를 따른다",
        },
        OneAlongEach => {
            en: "write along = \"x\" in one direction and along = \"y\" in the other",
            ko: "한 방향에는 along = \"x\", 다른 방향에는 along = \"y\"를 쓴다",
        },
        ButStoreysHaveT { path: String, written: String } => {
            en: "{path} = {written} is outside 1 t to 20 000 t, the range expected for a storey",
            ko: "{path} = {written}: 층의 질량으로 예상되는 범위(1~20 000 t)를 벗어난다",
        },
        StoreyAloneWouldSway { path: String, written: String, frequency_hz: String, least: String, most: String } => {
            en: "{path} = {written}: the storey alone would sway at {frequency_hz} Hz, outside {least} to {most} Hz expected for a storey",
            ko: "{path} = {written}: 이 층만의 진동수가 {frequency_hz} Hz로, 층에서 예상되는 {least}~{most} Hz를 벗어난다",
        },
        NamesBeginWithTop { foot: String, top: String } => {
            en: "storeys: the first, '{foot}', stands on the ground and the last, '{top}', on top, but by their names the list begins with the top",
            ko: "storeys: 첫 층 '{foot}'이(가) 지반 위에, 마지막 층 '{top}'이(가) 맨 위에 놓였으나 이름으로 보면 위에서부터 적은 목록이다",
        },
        ListStoreysLowestFirst => {
            en: "list the storeys lowest first, and the numbers of stiffness and friction in the same order",
            ko: "층을 아래에서부터 쓰고, 강성과 마찰 등 층별 값도 같은 순서로 쓴다",
        },
        AxialButAxialForces { word: String, other_word: String } => {
            en: "axial = \"{word}\", but the axial forces are the weights of the masses only if they are read as \"{other_word}\"",
            ko: "axial = \"{word}\"인데, 축력은 \"{other_word}\"(으)로 읽을 때에만 질량의 무게와 맞는다",
        },
        DidYouMeanAxial(other_word: String) => {
            en: "did you mean axial = \"{other_word}\"?",
            ko: "axial = \"{other_word}\"인가?",
        },
        StoreySColumnsWould { path: String, written: String, share: String, weight: String } => {
            en: "{path} = {written}: the storey's columns would carry {share} × the weight of the masses above, {weight}",
            ko: "{path} = {written}: 이 층 기둥의 축력이 위 질량의 무게({weight})의 {share}배가 된다",
        },
    }
}
