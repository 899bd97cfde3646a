//! Several setups put together, as text.

use super::Table;
use dolmen::modal::{Agreement, JointSetups, MergedMode, Mode, PartialMode};
use dolmen_words::Language;
use dolmen_words::number::TWO_SIDED_95;
use dolmen_work::surveyed::{REFERENCES_ALIKE, SetupsAnswer};

/// What all setups give together; each by itself has been printed before.
pub(super) fn merged_text(setups: &SetupsAnswer) -> String {
    let merged = &setups.merged;
    let names: Vec<&str> = merged
        .references
        .iter()
        .map(|&c| merged.modes.channels[c].name.as_str())
        .collect();
    let mut out = format!(
        "\n{} setups together: {} sensors, of which in more than one setup: {}\n",
        setups.records.len(),
        merged.modes.channels.len(),
        names.join(", ")
    );
    let mut heads: Vec<String> = ["mode", "f, Hz", "± 95 %", "damping, %", "± 95 %"]
        .map(str::to_owned)
        .to_vec();
    heads.extend((1..=setups.records.len()).map(|s| format!("f of setup {s}")));
    heads.extend(["p, f", "p, damping", "MAC of references"].map(str::to_owned));
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let mut table = Table::new(&heads, 1);
    for (i, (mode, of)) in merged.modes.modes.iter().zip(&merged.merged).enumerate() {
        table.row(row(i, mode, of));
    }
    out += &table.text();
    out += "  p: probability that setups which agree differ so much (χ²); where they differ the deviations are widened [setups]\n";
    for sentence in remarks(setups, Language::English) {
        out += &format!("  note: {sentence}\n");
    }
    out
}

/// What the identification of all setups as one rests on; its modes follow.
pub(super) fn joint_heading(joint: &JointSetups) -> String {
    let names: Vec<&str> = joint
        .references
        .iter()
        .map(|&c| joint.modes.channels[c].name.as_str())
        .collect();
    let strength: Vec<String> = joint.strength.iter().map(|s| format!("{s:.3}")).collect();
    format!(
        "\nAll setups identified as one (PreGER): {} sensors, of which in every setup: {}; strength of their motion: {}\n  {} block rows \
         at {:.4} Hz, orders to {}, modes sought in {:.3} to {:.3} Hz; these are the modes of the survey, those above are beside \
         them [setups]\n",
        joint.modes.channels.len(),
        names.join(", "),
        strength.join(" : "),
        joint.settings.block_rows,
        joint.settings.sampling_rate_hz,
        joint.settings.order_most,
        joint.settings.range_hz[0],
        joint.settings.range_hz[1],
    )
}

fn row(i: usize, mode: &Mode, of: &MergedMode) -> Vec<String> {
    let some = |x: Option<f64>, decimals: usize| x.map_or("-".to_owned(), |x| format!("{x:.decimals$}"));
    let mut row = vec![
        (i + 1).to_string(),
        format!("{:.4}", mode.frequency_hz),
        some(mode.frequency_sd_hz.map(|sd| TWO_SIDED_95 * sd), 4),
        some(mode.damping_ratio.map(|zeta| 100.0 * zeta), 3),
        some(mode.damping_ratio_sd.map(|sd| 100.0 * TWO_SIDED_95 * sd), 3),
    ];
    row.extend(of.frequency_hz.iter().map(|f| format!("{f:.4}")));
    row.push(some(of.frequency.p, 3));
    row.push(some(of.damping.as_ref().and_then(|d| d.p), 3));
    let least = of
        .reference_assurance
        .iter()
        .flatten()
        .copied()
        .min_by(f64::total_cmp);
    row.push(some(least, 3));
    row
}

/// The sensor that holds the setups together, if it is one alone.
fn only_reference(setups: &SetupsAnswer) -> Option<&str> {
    let (references, channels) = match &setups.joint {
        Some(joint) => (&joint.references, &joint.modes.channels),
        None => (&setups.merged.references, &setups.merged.modes.channels),
    };
    match references[..] {
        [one] => channels.get(one).map(|channel| channel.name.as_str()),
        _ => None,
    }
}

/// What must be known beside the modes.
pub(crate) fn remarks(setups: &SetupsAnswer, language: Language) -> Vec<String> {
    const ALIKE: f64 = REFERENCES_ALIKE;
    let merged = &setups.merged;
    let of = |which: &dyn Fn(&MergedMode) -> bool| {
        let both = merged.modes.modes.iter().zip(&merged.merged);
        let all: Vec<String> = both
            .filter(|(_, of)| which(of))
            .map(|(mode, _)| format!("{:.3}", mode.frequency_hz))
            .collect();
        all.join(", ")
    };
    let mut said = Vec::new();
    if let Some(alone) = only_reference(setups) {
        said.push(language.pick(format!("one sensor alone, \"{alone}\", holds the setups together: a mode with a node there is lost or scaled by noise, and no MAC can tell whether \
             the setups show one mode; three references see it"), format!("센서 \"{alone}\" 하나만이 배치들을 연결한다. 그 위치가 마디인 모드는 놓치거나 잡음으로 척도가 정해지며, 배치들이 같은 모드를 보이는지 MAC로 확인할 수 없다. 기준 센서 세 개가 있으면 알 수 있다")));
    }
    let differing = of(&|m| m.frequency.differs());
    if !differing.is_empty() {
        said.push(language.pick(format!("the setups differ in the frequency of the modes at {differing} Hz beyond chance: weather, strength of the motion or moved mass between them"), format!("{differing} Hz 모드는 배치 사이의 진동수 차이가 우연을 넘는다. 그 사이의 날씨, 진동의 세기, 옮겨진 질량의 영향이다")));
    }
    let damping = of(&|m| m.damping.as_ref().is_some_and(Agreement::differs));
    if !damping.is_empty() {
        said.push(language.pick(
            format!("the setups differ in the damping of the modes at {damping} Hz beyond chance"),
            format!("{damping} Hz 모드는 배치 사이의 감쇠비 차이가 우연을 넘는다"),
        ));
    }
    let unlike = of(&|m| m.reference_assurance.iter().flatten().any(|mac| *mac < ALIKE));
    if !unlike.is_empty() {
        said.push(language.pick(format!("at the references the shapes of the modes at {unlike} Hz are not alike in all setups (MAC below {ALIKE}): the merged shape is not to be trusted, and goes on to no stiffness"), format!("{unlike} Hz 모드는 기준 센서에서의 형상이 배치마다 같지 않다(MAC {ALIKE} 미만). 합성한 모드형상은 신뢰할 수 없으며 강성 추정에 쓰지 않는다")));
    }
    let doubtful = of(&|m| m.doubtful);
    if !doubtful.is_empty() {
        said.push(language.pick(format!("another pairing is nearly as good: the setups may not show one mode at {doubtful} Hz, which goes on to no stiffness"), format!("다른 짝도 거의 같은 정도로 가능하다. {doubtful} Hz에서 배치들이 같은 모드를 보이는지 확실하지 않으며 강성 추정에 쓰지 않는다")));
    }
    let listed = |setups: &[usize]| -> String {
        let setups: Vec<String> = setups.iter().map(|s| (s + 1).to_string()).collect();
        setups.join(", ")
    };
    let left_out = |of: &dyn Fn(&PartialMode) -> Option<String>| -> String {
        let all: Vec<String> = merged.partial.iter().filter_map(of).collect();
        all.join("; ")
    };
    let missing = left_out(&|p| {
        let setup = language.pick("setup", "배치");
        let one = || format!("{:.3} Hz ({setup} {})", p.frequency_hz, listed(&p.setups));
        p.unlike_in.is_empty().then(one)
    });
    if !missing.is_empty() {
        said.push(language.pick(
            format!("left out, since not every setup shows them: {missing}"),
            format!("모든 배치에서 확인되지 않아 제외한 모드: {missing}"),
        ));
    }
    let unlike = left_out(&|p| {
        let one = || {
            let (own, others) = (listed(&p.setups), listed(&p.unlike_in));
            let hz = p.frequency_hz;
            language.pick(
                format!("{hz:.3} Hz (setup {own}, unlike in setup {others})"),
                format!("{hz:.3} Hz(배치 {own}, 배치 {others}에서는 다름)"),
            )
        };
        (!p.unlike_in.is_empty()).then(one)
    });
    if !unlike.is_empty() {
        said.push(language.pick(format!("left out, since other setups show that frequency with another shape at the references: {unlike}: a sensor turned, exchanged or of \
             another gain, or modes that lie close"), format!("다른 배치가 그 진동수에서 기준 센서에 다른 형상을 보여 제외한 모드: {unlike}. 센서가 돌아갔거나 바뀌었거나 감도가 다르거나, 모드가 서로 가깝다")));
    }
    let faults = merged.reference_faults.iter();
    said.extend(faults.map(|fault| format!("{}{fault}", language.pick("", "[영문] "))));
    if let Some(joint) = &setups.joint
        && let Ok(lost_hz) = joint.not_shown_hz(merged)
        && !lost_hz.is_empty()
    {
        let all: Vec<String> = lost_hz.iter().map(|hz| format!("{hz:.3}")).collect();
        let all = all.join(", ");
        said.push(language.pick(
            format!(
                "setups by themselves show modes that the identification of all as one does not: {all} Hz"
            ),
            format!("배치별 분석에는 있으나 전체를 하나로 분석하면 나타나지 않는 모드: {all} Hz"),
        ));
    }
    said
}
