//! Why a damage cannot be included in the model.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Why a damage cannot be included in the model.
    pub(crate) enum WrongDamage in "project.error.damage" {
        NotOne { path: String, count: usize } => {
            en: "{path} gives {count} of its keys",
            ko: "{path}에 주어진 키가 {count}개이다",
        },
        MustBeOne => {
            en: "must give one: bed_lost (with side), stiffness_left, ties_broken = true, lost = true or mended = true",
            ko: "다음 중 하나만 주어야 한다: bed_lost(side와 함께), stiffness_left, ties_broken = true, lost = true, mended = true",
        },
        SideOfNothing(path: String) => { en: "{path} stands without bed_lost", ko: "{path}가 bed_lost 없이 있다" },
        LeaveSideOut => { en: "leave side out, or give bed_lost", ko: "side를 삭제하거나 bed_lost를 준다" },
        NotCarried { part: String, survey: String, why: Both } => {
            en: "the damage of \"{part}\" in survey {survey} cannot be carried into the model: {why}",
            ko: "{survey} 조사의 \"{part}\" 손상을 모델에 반영할 수 없다: {why}",
        },
        Twice(earlier: String) => {
            en: "survey {earlier} has another damage of this kind on this part, with the same name or none, and the model would have only the later one",
            ko: "{earlier} 조사에 같은 부재, 같은 종류의 손상이 이름 없이 또는 같은 이름으로 또 있어 나중 것만 모델에 반영된다",
        },
        NameEach => {
            en: "if they are two damages, give each its own name = \"…\" in every inspection; if they are one, give it one effect (on one side)",
            ko: "서로 다른 손상이면 모든 점검에서 각각 name = \"…\"을 주고, 같은 손상이면 하나의 효과(한쪽 방향)로 적는다",
        },
        NoModel => { en: "the file has no model of it", ko: "파일에 이 부재의 모델이 없다" },
        NoDate => {
            en: "the name of the survey begins with no date, so that it is not known which inspection came last",
            ko: "조사 이름이 날짜로 시작하지 않아 어느 점검이 마지막인지 알 수 없다",
        },
        NameSurveyByDate => { en: "name the survey by its date: [survey.2026-05-12]", ko: "조사 이름을 날짜로 쓴다: [survey.2026-05-12]" },
        OfBuilding => {
            en: "a building has walls and columns in plan, and none of these says which of them is damaged",
            ko: "building의 벽과 기둥 가운데 어느 것이 손상되었는지 이 키로는 알 수 없다",
        },
        OfChain => {
            en: "a chain takes bed_lost and stiffness_left; it has no ties, and no link of it can be missing",
            ko: "chain에는 bed_lost와 stiffness_left만 반영한다. 연결재가 없고 부재를 뺄 수 없다",
        },
        OfFrame => { en: "a frame takes stiffness_left alone", ko: "frame에는 stiffness_left만 반영한다" },
        OfMesh => {
            en: "its stone is a mesh, whose foot is where the scan has it",
            ko: "석재가 메시이므로 밑면은 스캔된 그대로이다",
        },
        Sought => {
            en: "its stiffness is sought in the modes of a survey",
            ko: "강성을 조사의 모드에서 구하게 되어 있다",
        },
        AlreadyIn(survey: String) => {
            en: "its stiffness was identified from survey {survey}, which is not before the inspection: the damage is in it already",
            ko: "강성을 점검보다 앞서지 않은 {survey} 조사에서 구하여 손상이 이미 반영되어 있다",
        },
        LeaveStiffnessOut => {
            en: "leave stiffness_left out where the survey is not before the inspection; else write the stiffness that was found into the file",
            ko: "조사가 점검보다 앞서지 않으면 stiffness_left를 삭제하고, 아니면 구한 강성을 파일에 적는다",
        },
        WriteStiffness => {
            en: "write the stiffness that was found into the file (dolmen identify --write)",
            ko: "구한 강성을 파일에 적는다(dolmen identify --write)",
        },
        NoStiffness => { en: "its stiffness is not known", ko: "강성을 알 수 없다" },
        RigidBeds => {
            en: "columns alone hold the storey, and their beds are rigid (no bed_stiffness)",
            ko: "기둥만으로 지지하는 층인데 기둥 밑이 강체이다(bed_stiffness 없음)",
        },
        GiveStiffness => { en: "give the stiffness, or leave the damage out of the model", ko: "강성을 주거나 손상을 모델에서 뺀다" },
        NoBed => { en: "the width of its bed is not given", ko: "접합면의 폭(bed_width)이 없다" },
        GiveBed => { en: "give bed_width of the link", ko: "부재의 bed_width를 준다" },
        BesideItsBed => {
            en: "with half of the bed or more lost at one side, the weight stands beside what is left of it",
            ko: "한쪽에서 절반 이상을 잃으면 무게가 남은 접합면을 벗어난다",
        },
        OneDirection => {
            en: "the chain moves in one direction, and the side is across it",
            ko: "chain은 한 방향으로 움직이는데 side가 그 직각 방향이다",
        },
        SideAlong => { en: "leave side out, or give x+ or x-", ko: "side를 삭제하거나 x+ 또는 x-를 준다" },
        NoSide => { en: "the side from which the bed is lost is not given", ko: "접합면을 잃은 방향(side)이 없다" },
        GiveSide => { en: "give side = \"x+\", \"x-\", \"y+\" or \"y-\"", ko: "side = \"x+\", \"x-\", \"y+\", \"y-\" 중 하나를 준다" },
        NoTies => { en: "no dowel or clamp joins it to what it stands on", ko: "아래 부재와 잇는 은장이나 촉이 없다" },
        NoList => { en: "the file does not list its stones", ko: "파일에 석재의 목록이 없다" },
        ListBlocks => { en: "list the stones as blocks", ko: "석재를 blocks로 나열한다" },
        StoodOn(upper: String) => { en: "\"{upper}\" stands on it alone", ko: "\"{upper}\"이(가) 이 부재 위에만 놓여 있다" },
        LoadedOrAlone => {
            en: "it is the only stone, or a static load acts on it",
            ko: "하나뿐인 석재이거나 정적 하중이 작용한다",
        },
        WriteItYourself => {
            en: "change the model itself where the damage counts, and leave model out of this entry",
            ko: "손상을 모델의 값에 직접 반영하고 이 항목의 model은 삭제한다",
        },
        LeaveModelOut => { en: "leave model out of this entry", ko: "이 항목의 model을 삭제한다" },
        AsInspectedButNo(name: String) => {
            en: "as_inspected = \"{name}\", but no inspection has this name and a date",
            ko: "as_inspected = \"{name}\"인데 날짜가 있는 점검 중에 이 이름이 없다",
        },
        MustBeOneOf(allowed: String) => {
            en: "must be one of {allowed}",
            ko: "다음 중 하나이어야 한다: {allowed}",
        },
    }
}
