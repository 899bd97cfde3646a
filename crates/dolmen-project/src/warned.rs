//! Warnings about a project.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// A warning that does not stop the reading and appears with every result.
    pub enum Warned in "project.warning" {
        CapLeftOut => {
            en: "the part at the very top (cap stone) is left out: its weight would lower the load factor and every frequency, so what follows is on the unsafe side",
            ko: "최상부 부재(옥개석)를 모델에서 제외하였다. 그 무게는 하중배율과 모든 고유진동수를 낮추므로 이하의 결과는 불안전측이다",
        },
        Assumed { paths: Both } => {
            en: "assumed inputs, and what rests on them is no finding: {paths}",
            ko: "가정값이 쓰였으며, 이에 의존하는 결과는 확인된 것이 아니다: {paths}",
        },
        Scatter { paths: Both } => {
            en: "inputs with an assumed scatter, and so is every probability: {paths}",
            ko: "변동계수에 가정값이 쓰였으며, 모든 확률도 가정에 의존한다: {paths}",
        },
        ThinRods { links: String } => {
            en: "no moment of inertia for link {links}: taken as a thin rod, m L²/12; give breadth for that of a box. It touches frequencies, not stability",
            ko: "부재 {links}의 관성모멘트가 주어지지 않아 가는 봉(m L²/12)으로 보았다. 부재의 폭(breadth)을 입력하면 직육면체로 계산한다. 고유진동수에만 영향을 주고 안정성에는 영향이 없다",
        },
        AxialFromMasses => {
            en: "«no axial_force:|the axial force is not given:» taken as the weight of the masses at the storey's top and above«; axial_force = 0 would leave P-delta out»",
            ko: "축력«(axial_force)»이 주어지지 않아 각 층 상단과 그 위 질량의 무게로 보았다«. P-델타 효과를 제외하려면 axial_force = 0으로 한다»",
        },
        ColumnsNotInMotion => {
            en: "columns: «`dolmen check`|the check of stability» says what free-standing columns hold. Where joints or walls hold it too, runs of one storey soften where feet lift off if «bed_stiffness|the stiffness of the beds» says how beds and joints share its stiffness; other runs move on storey stiffness and friction alone, without the columns' restoring moment",
            ko: "«columns|기둥»: 자립 기둥의 복원력은 «`dolmen check`|안정성 검토»에서 확인한다. 접합부나 벽체도 지지하는 단층은 «bed_stiffness로|지압면 강성으로» 지압면과 접합부의 강성 분담이 주어지면 주각이 들린 뒤의 강성 저하를 해석에 반영하고, 그 밖의 해석은 기둥의 복원모멘트 없이 층강성과 마찰만으로 거동한다",
        },
        JointDefaults { taken: String } => {
            en: "joint does not say everything; Dolmen's own values are taken, and assumed: {taken} (friction acts in the limits; stiffness and damping in frequencies, in the demand on elastic joints and in motion)",
            ko: "접합면(joint) 물성 일부가 주어지지 않아 Dolmen의 기본값으로 가정하였다: {taken} (마찰은 한계에, 강성과 감쇠는 고유진동수·탄성 접합면의 요구 수준·지진응답에 작용한다)",
        },
        RestitutionOfFalls { path: String } => {
            en: "{path} is read as «normal_restitution|the normal restitution», of falls alone: a stone that rocks keeps what geometry leaves it, or «rocking_restitution|rocking restitution»",
            ko: "{path}은(는) «normal_restitution(낙하 시 수직 반발계수)|낙하 시 수직 반발계수»«으로|로» 읽었다. 로킹하는 부재의 반발계수는 기하 조건으로 정해지며, 실측값이 있으면 «rocking_restitution을|로킹 반발계수를» 준다",
        },
        TiltOnParts { survey: String } => {
            en: "the tilt of survey {survey} is not added to the model: its blocks carry their own tilt, offset or place",
            ko: "{survey} 조사의 기울기는 모델에 더하지 않았다. 부재별 기울기, 이동량 또는 좌표가 이미 주어져 있다",
        },
        TiltOfSeveralFeet { survey: String } => {
            en: "the tilt of survey {survey} is not in the model: several blocks stand on the ground; give each block its own tilt",
            ko: "{survey} 조사의 기울기는 모델에 반영되지 않았다. 지반 위에 놓인 부재가 여러 개이므로 부재별 tilt를 준다",
        },
        Allowed { slip: Both } => {
            en: "{slip}; the file allows it",
            ko: "의심스러운 값을 파일의 allow 항목에 따라 허용하였다: {slip}",
        },
        ColumnsLeftOut { file: String, heads: Vec<String> } => {
            en: "{file}: the model does not use the columns {heads}",
            ko: "{file}: 모델에 쓰지 않은 열은 {heads}이다",
        },
        AllowedInVain { path: String } => {
            en: "allow names \"{path}\", but nothing there needs it: take it out",
            ko: "allow에 \"{path}\"이(가) 있으나 그곳에는 필요하지 않다. 삭제한다",
        },
    }
}
