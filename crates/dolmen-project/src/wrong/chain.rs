//! Errors of a chain.

use dolmen_words::messages;

messages! {
    /// Errors of a chain.
    pub(crate) enum WrongChain in "project.error.chain" {
        DampingRatioAndBoth(path: String) => {
            en: "damping_ratio and {path} both damp the joints",
            ko: "damping_ratio와 {path}이(가) 모두 접합부의 감쇠를 정한다",
        },
        KeepOneOfThem => {
            en: "keep one of them: damping_ratio makes a dashpot of every joint",
            ko: "둘 중 하나만 남긴다. damping_ratio는 모든 접합부에 감쇠를 준다",
        },
        StandsWithoutFrictionMoment(path: String) => {
            en: "{path} stands without friction_moment",
            ko: "{path}이(가) friction_moment 없이 주어졌다",
        },
        GiveFrictionMomentToo => {
            en: "give friction_moment too: the moment while the joint turns",
            ko: "friction_moment(접합부가 회전하는 동안의 모멘트)도 입력한다",
        },
        IsBelow { path: String, written: String, other: String, other_written: String } => {
            en: "{path} = {written} is below {other} = {other_written}",
            ko: "{path} = {written}이(가) {other} = {other_written}보다 작다",
        },
        JointThatStandsHolds => {
            en: "a joint that stands holds at least what one that turns does",
            ko: "멈춰 있는 접합부의 저항은 회전하는 접합부 이상이다",
        },
        HasBothInertiaAnd(path: String) => {
            en: "{path} has both inertia and breadth",
            ko: "{path}에 inertia와 breadth가 모두 있다",
        },
        KeepOneOfThemBreadth => {
            en: "keep one of them: breadth makes the inertia that of a box",
            ko: "둘 중 하나만 남긴다. breadth를 주면 직육면체의 관성모멘트로 계산한다",
        },
        HasBothInertiaAcrossAnd(path: String) => {
            en: "{path} has both inertia_across and depth",
            ko: "{path}에 inertia_across와 depth가 모두 있다",
        },
        KeepOneOfThemDepth => {
            en: "keep one of them: depth makes the inertia across that of a box",
            ko: "둘 중 하나만 남긴다. depth를 주면 직각 방향의 관성모멘트를 직육면체로 계산한다",
        },
        AcrossWithoutAlong(path: String) => {
            en: "{path} is given, but nothing in the direction of motion",
            ko: "{path}이(가) 있는데 운동 방향의 값이 없다",
        },
        GiveBreadthToo => { en: "give breadth or inertia there too", ko: "그곳에 breadth나 inertia도 입력한다" },
        LiesAboveLinkS { path: String, written: String } => {
            en: "{path} = {written} lies above the link's top",
            ko: "{path} = {written}이(가) 부재 상단보다 위에 있다",
        },
        MustBeToLink { number: String, unit: String } => {
            en: "must be 0 to {number} {unit}, the link's own length",
            ko: "0~{number} {unit}(부재 길이)이어야 한다",
        },
        CentroidIsMeasuredFrom => {
            en: "centroid is measured from the link's lower joint, not from the ground",
            ko: "centroid는 지면이 아니라 부재 하단 접합부에서 잰다",
        },
        SupportNeeds(path: String) => { en: "a side support needs {path}", ko: "측면 지지에는 {path}이(가) 필요하다" },
        SupportKeys => {
            en: "side_supports = [ {{ height = \"1.2 m\", stiffness = \"20 kN/mm\", gap = \"5 mm\" }} ], the height above the lowest joint",
            ko: "side_supports = [ {{ height = \"1.2 m\", stiffness = \"20 kN/mm\", gap = \"5 mm\" }} ]를 쓴다. height는 최하단 접합면에서 잰다",
        },
        SupportOfStack(path: String) => {
            en: "{path} is for blocks: a chain is held at a height",
            ko: "{path}은(는) 블록에 쓴다. chain은 높이로 지지 위치를 정한다",
        },
        SupportDirection(path: String) => {
            en: "{path} of a chain is neither \"x\" nor \"y\"",
            ko: "chain의 {path}은(는) \"x\"나 \"y\"이어야 한다",
        },
        SupportDirections => {
            en: "write direction = \"x\" for posts that hold it in the direction of motion, \"y\" for posts across; it holds to either side",
            ko: "운동 방향으로 지지하면 direction = \"x\", 직각 방향으로 지지하면 \"y\"를 쓴다. 지지는 양쪽으로 작용한다",
        },
        SupportAboveTop { path: String, written: String, top: String } => {
            en: "{path} = {written} lies above the top of the chain, {top}",
            ko: "{path} = {written}이(가) 체인 상단({top})보다 높다",
        },
        SupportHeight => {
            en: "height is measured from the lowest joint, and lies on the chain",
            ko: "height는 최하단 접합면에서 재며 체인 위에 있어야 한다",
        },
        ChainNeedsLinks => { en: "a chain needs links", ko: "chain에는 links가 필요하다" },
        LinksWeightLengthCentroid => {
            en: "links = [ {{ weight = …, length = …, centroid = … }}, … ]",
            ko: "links = [ {{ weight = …, length = …, centroid = … }}, … ]를 쓴다",
        },
        ChainNeedsJoints => { en: "a chain needs joints", ko: "chain에는 joints가 필요하다" },
        WriteJointsUnknownIf => {
            en: "write joints = \"unknown\" if nobody has measured them, or [ {{ stiffness = … }}, … ]",
            ko: "측정한 적이 없으면 joints = \"unknown\", 아니면 [ {{ stiffness = … }}, … ]를 쓴다",
        },
        EdgeButWidthOf(path: String) => {
            en: "{path} = \"edge\", but the width of its bed is not given",
            ko: "{path} = \"edge\"인데 접합면 폭이 주어지지 않았다",
        },
        GiveBedWidthThere => {
            en: "give bed_width there, or write opening = \"held\"",
            ko: "그곳에 bed_width를 입력하거나 opening = \"held\"로 쓴다",
        },
        IsSameBedAs { path: String, other: String } => {
            en: "{path} is the same bed as {other}",
            ko: "{path}은(는) {other}와(과) 같은 접합면이다",
        },
        GivenTwice => { en: "given twice", ko: "두 번 주어졌다" },
        LinksAreToM { least: String, most: String } => {
            en: "links are {least} to {most} m long",
            ko: "부재 길이는 {least}~{most} m이다",
        },
        AllWeights { key: String, unit: String, side_m: String, height_m: String } => {
            en: "{key} = \"{unit}\": with all their weights in {unit} the links would, as stone, be {side_m} m wide under a height of {height_m} m",
            ko: "{key} = \"{unit}\": 모든 부재의 무게가 {unit} 단위이면 석재 부재의 폭이 {side_m} m가 되는데 전체 높이는 {height_m} m이다",
        },
        AsStoneLinkWould { path: String, written: String, side_m: String, height_m: String } => {
            en: "{path} = {written}: as stone the link would be {side_m} m wide, and the whole is {height_m} m high",
            ko: "{path} = {written}: 석재라면 부재의 폭이 {side_m} m가 되는데 전체 높이는 {height_m} m이다",
        },
        IsOfLinkS { path: String, written: String, share: String } => {
            en: "{path} = {written} is {share} of the link's length: a block's centre of mass is near its middle",
            ko: "{path} = {written}은(는) 부재 길이의 {share}이다. 부재의 무게중심은 가운데 부근에 있다",
        },
        LinkSDensityWould { path: String, written: String, density: String } => {
            en: "{path} = {written}: the link's density would be about {density} kg/m3",
            ko: "{path} = {written}: 부재의 밀도가 약 {density} kg/m3이 된다",
        },
        LinkSRadiusOf { path: String, written: String, radius_m: String, length_m: String } => {
            en: "{path} = {written}: the link's radius of gyration would be {radius_m} m, and the link is {length_m} m long",
            ko: "{path} = {written}: 부재의 회전반경이 {radius_m} m가 되는데 부재 길이는 {length_m} m이다",
        },
        ThinRodOfThis(factor: String) => {
            en: "a thin rod of this mass and length has {factor}",
            ko: "같은 질량과 길이의 가는 봉은 {factor}이다",
        },
        LinkWouldBeM { path: String, written: String, side_m: String } => {
            en: "{path} = {written}: the link would be {side_m} m wide as stone",
            ko: "{path} = {written}: 석재라면 부재의 폭은 {side_m} m가 된다",
        },
        IsWeightTimesHeight { path: String, written: String, share: String, product: String } => {
            en: "{path} = {written} is {share} × the weight times height above the joint, {product}",
            ko: "{path} = {written}은(는) 접합부 위 무게 × 높이({product})의 {share}배이다",
        },
        JointThatKeepsChain => {
            en: "a joint that keeps a chain upright has about 1 × that or more; is it in N m/rad, kN m/rad or kN m/deg?",
            ko: "서 있는 구조물의 접합부는 약 1배 이상이다. 단위가 N m/rad, kN m/rad, kN m/deg 중 어느 것인가?",
        },
        IsWeightTimesHeightAbove { path: String, written: String, share: String, product: String } => {
            en: "{path} = {written} is {share} × the weight times height above the joint, {product}",
            ko: "{path} = {written}은(는) 접합부 위 무게 × 높이({product})의 {share}배이다",
        },
        FrictionHoldsSmallPart => {
            en: "friction holds a small part of that; is it in N m or kN m? A number without a unit is in units.moment, or in N m if that is not given",
            ko: "마찰은 그 일부만 저항한다. 단위가 N m, kN m 중 어느 것인가? 단위 없는 수는 units.moment, 그것도 없으면 N m이다",
        },
        IsGivenButWidth(path: String) => {
            en: "{path} is given, but the width of its bed is not",
            ko: "{path}이(가) 있는데 접합면 폭이 없다",
        },
        GiveBedWidthThereToo => { en: "give bed_width there too", ko: "그곳에 bed_width도 입력한다" },
        IsNotAboveWeight { path: String, written: String, pressure: String } => {
            en: "{path} = {written} is not above {pressure}, the weight above over the whole bed",
            ko: "{path} = {written}이(가) 접합면 전체에 걸리는 위 무게의 압력 {pressure}보다 크지 않다",
        },
        BedCrushesUnderWeight => { en: "the bed crushes under the weight alone", ko: "자중만으로 접합면이 압괴한다" },
        IsItInPa => {
            en: "is it in Pa, kPa or MPa? Mortar has 1 to 10 MPa, granite 100 MPa and more",
            ko: "단위가 Pa, kPa, MPa 중 어느 것인가? 모르타르는 1~10 MPa, 화강암은 100 MPa 이상이다",
        },
        StoneNeeds(path: String) => { en: "stone has no {path}", ko: "stone에 {path}이(가) 없다" },
        StoneKeys => {
            en: "stone = {{ elastic_modulus = \"40 GPa\", poisson_ratio = 0.2, density = \"2600 kg/m3\" }}; granite has 20 to 60 GPa, 0.15 to 0.3 and 2600 kg/m3",
            ko: "stone = {{ elastic_modulus = \"40 GPa\", poisson_ratio = 0.2, density = \"2600 kg/m3\" }}를 쓴다. 화강암은 20~60 GPa, 0.15~0.3, 2600 kg/m3이다",
        },
        PoissonOfStone => { en: "granite has 0.15 to 0.3", ko: "화강암은 0.15~0.3이다" },
        SoilNeedsFooting => {
            en: "soil has no footing, or two",
            ko: "soil에 기초의 크기가 없거나 두 가지로 주어졌다",
        },
        SoilKeys => {
            en: "soil = {{ shear_modulus = \"40 MPa\", poisson_ratio = 0.35, along = 1.8, across = 2.4 }}, or diameter = 2.0 in place of both sides",
            ko: "soil = {{ shear_modulus = \"40 MPa\", poisson_ratio = 0.35, along = 1.8, across = 2.4 }}를 쓴다. 원형 기초는 두 변 대신 diameter = 2.0을 쓴다",
        },
        PoissonOfSoil => {
            en: "dry sand has 0.25 to 0.35, saturated clay nearly 0.5",
            ko: "마른 모래는 0.25~0.35, 포화 점토는 0.5에 가깝다",
        },
        ModulusOfNoSoil { path: String, written: String } => {
            en: "{path} = {written}, but soil and rock have 0.3 MPa to 40 GPa",
            ko: "{path} = {written}인데 흙과 암반은 0.3 MPa~40 GPa이다",
        },
        FootingBelowBed { path: String, written: String, bed_path: String, bed: String } => {
            en: "{path} = {written}, but the bed that stands on it is wider: {bed_path} = {bed}",
            ko: "{path} = {written}인데 그 위의 접합면이 더 넓다: {bed_path} = {bed}",
        },
        FootingBelowStones => {
            en: "a footing is at least as wide as what stands on it: is the unit that of units.length, and is this the whole side, not half of it?",
            ko: "기초는 그 위의 부재보다 좁지 않다. 길이 단위(units.length)가 맞는가? 한 변의 절반이 아니라 전체 길이인가?",
        },
        FootingOfNoPole { path: String, written: String } => {
            en: "{path} = {written}, but footings of poles and towers are at most 40 m wide",
            ko: "{path} = {written}인데 당간이나 탑의 기초는 40 m를 넘지 않는다",
        },
        GapOfPost { path: String, written: String, share: String } => {
            en: "{path} = {written}, {share} × the height at which the pole would meet the post: it has fallen long before",
            ko: "{path} = {written}은(는) 지주에 닿는 높이의 {share}배이며, 당간은 그 전에 이미 전도된다",
        },
        StiffnessOfPost { path: String, written: String, share: String, product: String } => {
            en: "{path} = {written}: with its height squared it is {share} of weight × height of the pole ({product}), and posts have 1/100 of that or more and no more than 10 GN/m",
            ko: "{path} = {written}: 높이의 제곱을 곱하면 당간의 중량 × 높이({product})의 {share}인데, 지주는 그 1/100 이상, 10 GN/m 이하이다",
        },
        StiffnessOfPostUnits => {
            en: "it is a force per length, and a bare number is in N/m unless units.force and units.length are given for it: write \"20 kN/mm\"",
            ko: "단위 길이당 힘이다. 단위 없는 수는 N/m로 읽을 수 있으므로 \"20 kN/mm\"처럼 단위를 붙인다",
        },
        FootingInUnits => {
            en: "a bare number is in units.length, m without it: is it in mm?",
            ko: "단위 없는 수는 units.length, 그것도 없으면 m이다. mm로 쓴 값인가?",
        },
        SoilModulusInPa => {
            en: "is it in Pa, kPa or MPa? A shear wave of 150 m/s in 1800 kg/m3 has 40 MPa. A number without a unit is in units.stress, or in Pa if that is not given",
            ko: "단위가 Pa, kPa, MPa 중 어느 것인가? 전단파속도 150 m/s, 밀도 1800 kg/m3이면 40 MPa이다. 단위 없는 수는 units.stress, 그것도 없으면 Pa이다",
        },
        StoneOfTooMany(links: usize) => {
            en: "stone is given for {links} links",
            ko: "부재 {links}개에 stone이 주어졌다",
        },
        StoneOfAtMost(most: usize) => {
            en: "the pole without joints is computed for at most {most} links",
            ko: "접합면이 없는 기둥은 부재 {most}개까지 계산한다",
        },
        LeaveStoneOut => {
            en: "leave stone out if no comparison with one stone is wanted",
            ko: "한 돌로 된 기둥과 비교하지 않으려면 stone을 뺀다",
        },
        StoneHasNoSuchShaft { path: String, written: String, share: String } => {
            en: "{path} = {written} is {share} of the link's length: stone makes each link a shaft that tapers evenly, and none has its centre of mass there",
            ko: "{path} = {written}은(는) 부재 길이의 {share}이다. stone은 각 부재를 고르게 가늘어지는 돌기둥으로 보는데 무게중심이 그곳인 돌기둥은 없다",
        },
        CentroidOfShaft => {
            en: "must be 0.25 to 0.75 of the length, 0.75 left out",
            ko: "길이의 0.25 이상 0.75 미만이어야 한다",
        },
        ModulusOfNoStone { path: String, written: String } => {
            en: "{path} = {written}, but stone has 0.5 to 250 GPa",
            ko: "{path} = {written}인데 석재는 0.5~250 GPa이다",
        },
        ModulusInPa => {
            en: "is it in Pa, MPa or GPa? A number without a unit is in units.stress, or in Pa if that is not given",
            ko: "단위가 Pa, MPa, GPa 중 어느 것인가? 단위 없는 수는 units.stress, 그것도 없으면 Pa이다",
        },
        DensityOfNoStone { path: String, written: String } => {
            en: "{path} = {written}, but it must be 300 to 9000 kg/m3",
            ko: "{path} = {written}인데 300~9000 kg/m3이어야 한다",
        },
        DensityInKg => {
            en: "is it in kg/m3 or t/m3? Granite has 2600 kg/m3",
            ko: "단위가 kg/m3, t/m3 중 어느 것인가? 화강암은 2600 kg/m3이다",
        },
    }
}
