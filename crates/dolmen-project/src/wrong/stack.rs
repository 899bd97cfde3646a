//! Errors of a stack.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Errors of a stack.
    pub(crate) enum WrongStack in "project.error.stack" {
        CorniceWithOpenings { path: String } => {
            en: "{path}: the block has openings as well",
            ko: "{path}: 부재에 openings도 있다",
        },
        SplitStone => {
            en: "keep one of them, or give the mass that is missing by the density of the block",
            ko: "둘 중 하나만 쓰거나, 빠지는 질량을 부재의 density로 반영한다",
        },
        CorniceOfShape { path: String } => {
            en: "{path}: only boxes, frusta and prisms have a cornice",
            ko: "{path}: cornice는 직육면체, 각뿔대, 각기둥에만 쓴다",
        },
        CorniceShapes => {
            en: "write shape = \"frustum\", or the steps as points or blocks",
            ko: "shape = \"frustum\"으로 쓰거나 받침을 별도의 블록으로 쓴다",
        },
        CorniceLeavesNothing { path: String, steps: String, setback: String, width: String } => {
            en: "{path}: {steps} steps of {setback} from either side leave no bed of a width of {width}",
            ko: "{path}: 양쪽에서 {setback}씩 {steps}단을 물리면 폭 {width}의 밑면이 남지 않는다",
        },
        CorniceBed => {
            en: "setback is that of one step: the bed is as wide as the block without 2 × steps × setback",
            ko: "setback은 한 단의 값이다. 밑면의 폭은 부재의 폭에서 2 × steps × setback을 뺀 것이다",
        },
        MastUnderBlock { path: String, above: String } => {
            en: "{path} stands where \"{above}\" rests on the block",
            ko: "{path}이(가) \"{above}\"이(가) 놓인 자리에 있다",
        },
        MastOnTop => {
            en: "give the mast to the uppermost stone; what passes through the stones below ties them, as ties = …",
            ko: "mast는 최상단 부재에 쓴다. 아래 부재를 관통하는 부분은 ties = …로 쓴다",
        },
        SupportOfChain { path: String } => {
            en: "{path} is for a chain: a block meets its side support at a point",
            ko: "{path}은(는) chain에 쓴다. 블록의 측면 지지는 점으로 위치를 정한다",
        },
        CannotBeMade { kind: String, why: Both } => {
            en: "{kind} cannot be made: {why}",
            ko: "{kind}을(를) 만들 수 없다: {why}",
        },
        RestitutionTwice { path: String } => {
            en: "{path} has restitution and normal_restitution, which are one",
            ko: "{path}에 같은 뜻인 restitution과 normal_restitution이 모두 있다",
        },
        KeepNormalRestitution => { en: "keep normal_restitution", ko: "normal_restitution만 남긴다" },
        SupportHasPosition => {
            en: "give block, position and direction",
            ko: "block, position, direction을 쓴다",
        },
        NeedsNameOfBlock => {
            en: "needs the name of a block, or \"ground\"",
            ko: "부재 이름 또는 \"ground\"가 필요하다",
        },
        IsBlockItself { path: String, name: String } => {
            en: "{path} = \"{name}\" is the block itself",
            ko: "{path} = \"{name}\"은(는) 그 부재 자신이다",
        },
        NeedsNameOfAnother => {
            en: "needs the name of another block, or \"ground\"",
            ko: "다른 부재의 이름 또는 \"ground\"가 필요하다",
        },
        CannotBe { path: String, name: String } => {
            en: "{path} = \"{name}\" cannot be",
            ko: "{path} = \"{name}\"은(는) 쓸 수 없는 이름이다",
        },
        NeedsNameOtherThan => { en: "needs a name other than \"ground\"", ko: "\"ground\"가 아닌 이름이 필요하다" },
        IsAlsoNameOf { path: String, name: String, other: String } => {
            en: "{path} = \"{name}\" is also the name of blocks[{other}]",
            ko: "{path} = \"{name}\"은(는) blocks[{other}]의 이름과 같다",
        },
        MustBeUnique => { en: "must be unique", ko: "이름이 서로 달라야 한다" },
        NumberThemBodyBody => {
            en: "number them: \"body 1\", \"body 2\"",
            ko: "번호를 붙인다: \"body 1\", \"body 2\"",
        },
        IsNo { path: String, name: String, which: Both } => {
            en: "{path} = \"{name}\" is no {which}",
            ko: "{path} = \"{name}\"은(는) {which}의 이름이 아니다",
        },
        WriteNameOfBlock { ground: String } => {
            en: "write the name of a block as it stands in blocks, or \"{ground}\"",
            ko: "blocks에 있는 부재 이름 또는 \"{ground}\"을(를) 쓴다",
        },
        WriteNameOfABlock => {
            en: "write the name of a block as it stands in blocks, or as the generator names it (see `dolmen check --full`)",
            ko: "blocks에 있는 부재 이름 또는 자동 생성된 부재 이름을 쓴다(`dolmen check --full`로 확인)",
        },
        UnknownName => { en: "unknown name", ko: "없는 이름" },
        Is { path: String, ground: String } => {
            en: "{path} is \"{ground}\"",
            ko: "{path}이(가) \"{ground}\"이다",
        },
        MustBeNameOf => { en: "must be the name of a block", ko: "부재 이름이어야 한다" },
        TiltDirection { direction: String } => {
            en: "the model leans as this survey found it, along x and y; \"{direction}\" is neither",
            ko: "모델은 이 조사의 기울기만큼 x, y 방향으로 기울인다. \"{direction}\"은(는) 그 가운데 없다",
        },
        MustBeXOrY => { en: "must be x or y", ko: "x 또는 y이어야 한다" },
        OrLeftUpright => {
            en: "turn the tilt to x and y of the blocks, or leave it out of the model with as_surveyed = \"none\"",
            ko: "기울기를 부재의 x, y 방향으로 바꾸거나 as_surveyed = \"none\"으로 모델에서 뺀다",
        },
        TiltTooSteep { degrees: String } => {
            en: "leans the stack by {degrees}° on level ground",
            ko: "수평 지반 위의 적층 모델이 {degrees}° 기울어진다",
        },
        TiltMost => {
            en: "5° at most (1/11.4, 87 mm/m): beyond, joints are not recognised any more",
            ko: "5° 이하(1/11.4, 87 mm/m)이어야 한다. 그보다 크면 접합면을 인식하지 못한다",
        },
        TiltOnEachBlock => {
            en: "check the number and its unit; else give each block its own tilt, or leave this one out of the model with as_surveyed = \"none\"",
            ko: "값과 단위를 확인한다. 맞으면 부재마다 tilt를 주거나 as_surveyed = \"none\"으로 모델에서 뺀다",
        },
        TiltsOfOneDay { surveys: Vec<String> } => {
            en: "the surveys {surveys} are of one day, the latest, and their tilts differ",
            ko: "가장 최근인 같은 날의 조사 {surveys}의 기울기가 서로 다르다",
        },
        SayAsSurveyed => {
            en: "say which one the model leans by: as_surveyed = \"…\" at top level",
            ko: "모델에 반영할 조사를 파일 맨 위에 as_surveyed = \"…\"로 지정한다",
        },
        AsSurveyedButNo { name: String } => {
            en: "as_surveyed = \"{name}\", but no survey of this name has a tilt",
            ko: "as_surveyed = \"{name}\"인데 기울기(tilt)가 있는 조사 중에 이 이름이 없다",
        },
        MustBeOneOf { allowed: String } => {
            en: "must be one of {allowed}",
            ko: "다음 중 하나이어야 한다: {allowed}",
        },
        PagodaHasBothBody => {
            en: "pagoda has both body_slenderness and slenderness_angle",
            ko: "pagoda에 body_slenderness와 slenderness_angle이 모두 있다",
        },
        KeepOneOfThem => {
            en: "keep one of them: it determines the other",
            ko: "둘 중 하나만 남긴다. 하나가 다른 하나를 결정한다",
        },
        Pagoda { why: Both } => { en: "pagoda: {why}", ko: "pagoda(석탑): {why}" },
        PagodaOther => { en: "a pagoda", ko: "석탑(pagoda)" },
        Arch => { en: "an arch", ko: "홍예(arch)" },
        Wall => { en: "a wall", ko: "돌담(wall)" },
        Tower => { en: "a tower", ko: "석조 탑(tower)" },
        Trilithon => { en: "a trilithon", ko: "삼석문(trilithon)" },
        Vault => { en: "a vault", ko: "볼트(vault)" },
        Dome => { en: "a dome", ko: "돔(dome)" },
        StonesOfNoRing => {
            en: "stones counts the stones in a ring, but this tower has no rings",
            ko: "stones는 고리 한 켜의 부재 수인데 이 탑에는 고리가 없다",
        },
        GiveThicknessAndRound => {
            en: "a round hollow tower has them: plan = \"round\" and a thickness; or leave stones out",
            ko: "plan = \"round\"와 thickness를 함께 주거나 stones를 뺀다",
        },
        FileHasBothAnd { first: Both, second: Both } => {
            en: "the file has both {first} and {second}",
            ko: "파일에 {first}와(과) {second}이(가) 모두 있다",
        },
        KeepOneOfThemMakes { second: Both } => {
            en: "keep one of them: {second} makes its own blocks",
            ko: "둘 중 하나만 남긴다. {second}은(는) 부재를 스스로 만든다",
        },
        BlocksNameBaseWidth => {
            en: "blocks = [ {{ name = \"base\", width = …, height = … }}, … ], lowest first; or pagoda = {{ storeys = 3, … }}, arch = {{ … }}, wall = {{ … }}, tower = {{ … }}, trilithon = {{ … }}, vault = {{ … }}, dome = {{ … }}",
            ko: "blocks = [ {{ name = \"base\", width = …, height = … }}, … ]를 아래에서부터 쓰거나 pagoda = {{ storeys = 3, … }}, arch = {{ … }}, wall = {{ … }}, tower = {{ … }}, trilithon = {{ … }}, vault = {{ … }}, dome = {{ … }} 중 하나를 쓴다",
        },
        StackNeedsBlocks => { en: "a stack needs blocks", ko: "stack에는 blocks가 필요하다" },
        WriteDensityAtTop => {
            en: "write density = 2600 at the top level (granite, kg/m3)",
            ko: "최상위에 density = 2600(화강암, kg/m3)을 쓴다",
        },
        StonesOfNeedDensity { makers: Vec<Both> } => {
            en: "the stones of {makers} need a density",
            ko: "{makers}의 석재에 밀도가 필요하다",
        },
        StandsOverBlocksBelow { path: String, name: String } => {
            en: "{path}: '{name}' stands, over the blocks below it, on itself",
            ko: "{path}: '{name}'이(가) 아래 부재들을 거쳐 자기 자신 위에 놓인다",
        },
        SupportStaysWhereItIs { path: String } => {
            en: "{path} moves nothing: x, y and z are 0 or not given",
            ko: "{path}에 변위가 없다: x, y, z가 모두 0이거나 주어지지 않았다",
        },
        WriteHowFarGroundMoves => {
            en: "write how far the ground below the block moves, such as x = \"30 mm\" outwards or z = \"-10 mm\" down",
            ko: "부재 아래 지반이 움직이는 거리를 쓴다. 예: 바깥쪽으로 x = \"30 mm\", 아래로 z = \"-10 mm\"",
        },
        LetOneOfThem => { en: "let one of them stand on \"ground\"", ko: "그중 하나를 \"ground\" 위에 놓는다" },
        NorHaveMoreBlocks { others: String } => {
            en: ", nor have {others} more blocks",
            ko: "(이 밖에 부재 {others}개에도 없다)",
        },
        BlocksHasNoDensity { first: String, others: Both } => {
            en: "blocks[{first}] has no density{others}",
            ko: "blocks[{first}]에 밀도가 없다{others}",
        },
        WriteDensityAtTopLevel => {
            en: "write density = 2600 at the top level for all blocks (granite, kg/m3), or density = … in the block",
            ko: "모든 부재에 적용하려면 최상위에 density = 2600(화강암, kg/m3)을, 아니면 해당 부재에 density = …을 쓴다",
        },
        OfLooseStones { path: String } => {
            en: "{path} has no meaning with loose = true: loose stones have neither joints nor fixed places",
            ko: "{path}은(는) loose = true와 함께 쓰지 않는다. 놓인 자리가 정해지지 않은 돌에는 접합면도 정해진 위치도 없다",
        },
        TakeOutOrNotLoose { path: String } => {
            en: "take {path} out, or loose",
            ko: "{path} 또는 loose를 삭제한다",
        },
        HasNoMeaningIn { key_path: String, shape: Both } => {
            en: "{key_path} has no meaning in a {shape}",
            ko: "{key_path}은(는) {shape}에 쓰지 않는다",
        },
        HasNoButNeeds { path: String, key: String, shape: Both } => {
            en: "{path} has no \"{key}\", but a {shape} needs it",
            ko: "{shape}에 필요한 \"{key}\"이(가) {path}에 없다",
        },
        Write { key: String } => { en: "write {key} = …", ko: "{key} = …을(를) 쓴다" },
        HasNoSidesBut { path: String } => {
            en: "{path} has no \"sides\", but a prism needs it",
            ko: "prism에 필요한 \"sides\"가 {path}에 없다",
        },
        WriteSides => { en: "write sides = …", ko: "sides = …을 쓴다" },
        HasNoMeaningWith { key_path: String } => {
            en: "{key_path} has no meaning with coordinates = \"site\"",
            ko: "coordinates = \"site\"에는 {key_path}을(를) 쓰지 않는다",
        },
        TakeItOutOr => {
            en: "take it out, or write coordinates = \"own\"",
            ko: "삭제하거나 coordinates = \"own\"으로 쓴다",
        },
        HasNoPointsBut { path: String } => {
            en: "{path} has no \"points\", but a solid of points needs them",
            ko: "points 형상에 필요한 \"points\"가 {path}에 없다",
        },
        WritePointsXY => {
            en: "write points = [[x, y, z], …], four or more",
            ko: "points = [[x, y, z], …]로 네 점 이상 쓴다",
        },
        HasNoFileBut { path: String } => {
            en: "{path} has no \"file\", but a mesh needs it",
            ko: "mesh에 필요한 \"file\"이 {path}에 없다",
        },
        WriteFileStoneObj => {
            en: "write file = \"stone.obj\" (OBJ, STL or PLY)",
            ko: "file = \"stone.obj\"(OBJ, STL, PLY)를 쓴다",
        },
        MeshOf { file_path: String, file: String, name: String, why: Both } => {
            en: "{file_path} = \"{file}\", the mesh of '{name}': {why}",
            ko: "{file_path} = \"{file}\", '{name}'의 메시: {why}",
        },
        OfBlock => { en: "block", ko: "부재" },
    }
}
