//! Removes the commands and keys of a terminal from sentences: a reader of paper cannot type them.

use crate::document::{Block, Document, Finding};
use dolmen_words::message::Run;
use dolmen_words::{Language, Sentence};

/// What a command does, in English and Korean. The Korean ends in the same kind of sound, so the particle after it stays right.
const ACTS: [(&str, [&str; 2]); 9] = [
    ("identify", ["the identification from vibration", "진동 평가"]),
    ("check", ["the check of stability", "안정성 검토"]),
    ("simulate", ["a simulation in time", "지진응답 검토"]),
    ("watch", ["the review of all surveys", "장기 변화 검토"]),
    ("compare", ["the comparison of two surveys", "조사 비교"]),
    ("report", ["the report", "보고서"]),
    ("study", ["a study of many runs", "반복 해석 검토"]),
    ("sensors", ["a plan of sensors", "센서 배치 검토"]),
    ("explain", ["the list of terms", "용어 설명"]),
];

/// What keys are called in English sentences whose content needs them.
const NAMED: [(&str, &str); 17] = [
    ("works of [watch]", "the list of works"),
    ("in [watch]", "in the list of works"),
    (" (tilt_limit)", ""),
    ("tilt_limit", "the tilt limit"),
    (" ([limits])", ""),
    (" (frequency_within)", ""),
    ("into a [variant]", "into a variant"),
    ("needs damping_ratio", "needs the damping ratio"),
    ("stiffness and damping_ratio", "stiffness and damping"),
    ("bed_depth / bed_width", "depth / width of the bed"),
    ("bed_width", "bed width"),
    ("without bed_stiffness", "without a stiffness of the beds"),
    ("belong under axial = \"storey\"", "are those of the storey"),
    ("axial_force", "the axial force"),
    ("temperature_c", "the temperature"),
    ("rocking_restitution", "rocking restitution"),
    ("distance_km", "distance"),
];

/// The same in Korean, with their particles.
const NAMED_KOREAN: [(&str, &str); 22] = [
    ("[watch]의 works에 repair로", "조치 이력에 보수로"),
    ("[watch]의 works", "조치 이력"),
    ("[watch]의", "조치 이력의"),
    ("(tilt_limit)", ""),
    ("tilt_limit와", "기울기 한계와"),
    ("([limits])", ""),
    (" [limits]가", "가"),
    ("(frequency_within)", ""),
    ("[variant]로", "대안으로"),
    ("(detrend_degree = 1)", ""),
    ("damping_ratio가", "감쇠비가"),
    ("damping_ratio에", "감쇠비에"),
    ("bed_depth / bed_width", "접합면 깊이 / 폭"),
    ("bed_width가", "접합면 폭이"),
    ("bed_stiffness가", "지압면 강성이"),
    ("axial = \"storey\"로", "층의 축력으로"),
    ("axial_force와", "축력과"),
    ("axial_force가", "축력이"),
    ("temperature_c를", "기온을"),
    ("(rocking_restitution)", ""),
    ("rocking_restitution", "로킹 반발계수"),
    ("distance_km가", "거리가"),
];

/// Groups of sentences that are the engineer's own words, which stay as they are.
const OWN_WORDS: &str = "engineer";

/// The findings in words for paper.
pub(crate) fn on_paper(findings: &mut [Finding]) {
    for finding in findings {
        finding.sentence = plain(&finding.sentence);
    }
}

/// The blocks in words for paper.
pub(crate) fn document_on_paper(document: &mut Document<'_>) {
    // the list of terms belongs to the terminal
    document
        .blocks
        .retain(|block| !matches!(block, Block::Note(said) if is_of_terms(said)));
    for block in &mut document.blocks {
        let sentences: &mut [Sentence] = match block {
            Block::Heading(one) | Block::Subheading(one) | Block::Warning(one) | Block::Note(one) => {
                std::slice::from_mut(one)
            }
            Block::Paragraph(all) | Block::List(all) => all,
            Block::Table(table) => &mut table.caption,
            Block::Figures(figures) => {
                for figure in figures {
                    figure.caption.iter_mut().for_each(|said| *said = plain(said));
                }
                continue;
            }
            Block::KeyValues(_)
            | Block::Equation(_)
            | Block::Photos(_)
            | Block::Signatures(_)
            | Block::Answers(_) => continue,
        };
        sentences.iter_mut().for_each(|said| *said = plain(said));
    }
}

fn is_of_terms(said: &Sentence) -> bool {
    said.text(Language::English).starts_with("`dolmen explain`")
}

fn plain(sentence: &Sentence) -> Sentence {
    let is_own = sentence.id.starts_with(OWN_WORDS);
    let of = |runs: &[Run], language| {
        let runs = match is_own {
            true => runs.to_vec(),
            false => without_instructions(runs, language),
        };
        let each = runs.iter().map(|run| match run {
            Run::Text(text) => Run::Text(without_commands(text, language)),
            Run::Name(text) => Run::Name(without_commands(text, language)),
            Run::Quantity(_) => run.clone(),
        });
        each.collect()
    };
    Sentence {
        id: sentence.id.clone(),
        arguments: sentence.arguments.clone(),
        english: of(&sentence.english, Language::English),
        korean: of(&sentence.korean, Language::Korean),
    }
}

/// First of the signs that stand for names and quantities while a sentence is cut.
const SLOT: u32 = 0xF_0000;

/// The runs without clauses that say what to write into the file.
fn without_instructions(runs: &[Run], language: Language) -> Vec<Run> {
    let mut kept = Vec::new();
    let mut text = String::new();
    for run in runs {
        match run {
            Run::Text(own) => text.push_str(own),
            Run::Name(_) | Run::Quantity(_) => {
                text.extend(char::from_u32(SLOT + kept.len() as u32));
                kept.push(run.clone());
            }
        }
    }
    let slot = |sign: char| kept.get((sign as u32).checked_sub(SLOT)? as usize).cloned();
    let mut all = Vec::new();
    let mut said = String::new();
    for sign in without_keys(&text, language).chars() {
        match slot(sign) {
            Some(run) => {
                if !said.is_empty() {
                    all.push(Run::Text(std::mem::take(&mut said)));
                }
                all.push(run);
            }
            None => said.push(sign),
        }
    }
    if !said.is_empty() {
        all.push(Run::Text(said));
    }
    all
}

/// Without clauses that name keys of the file or flags of a command, but never without the first.
fn without_keys(text: &str, language: Language) -> String {
    let named: &[(&str, &str)] = match language {
        Language::English => &NAMED,
        Language::Korean => &NAMED_KOREAN,
    };
    let text = named
        .iter()
        .fold(text.to_owned(), |text, (key, word)| text.replace(key, word));
    let mut said = String::with_capacity(text.len());
    let (mut between, mut is_after_gap) = ("", false);
    for (clause, after) in clauses(&text) {
        if said.is_empty() || !has_key(clause) {
            said.push_str(between);
            let begins = is_after_gap && between == ". ";
            said.push_str(&if begins {
                capital(clause)
            } else {
                clause.to_owned()
            });
            (between, is_after_gap) = (after, false);
            continue;
        }
        // a bracket that the clause closes stays closed
        let open = clause.matches('(').count();
        let closing = clause.match_indices(')').nth(open).map(|(at, _)| at);
        said.push_str(closing.map_or("", |at| &clause[at..]));
        if closing.is_none() && after.is_empty() && clause.ends_with('.') {
            said.push('.');
        }
        if closing.is_some() || matches!(after, "" | ". ") {
            between = after;
        }
        is_after_gap = closing.is_none();
    }
    said
}

/// The clauses of a text, each with what parts it from the next.
fn clauses(text: &str) -> Vec<(&str, &'static str)> {
    let mut all = Vec::new();
    let mut rest = text;
    loop {
        let ends = [". ", "; "].map(|sign| rest.find(sign).map(|at| (at, sign)));
        match ends.into_iter().flatten().min() {
            Some((at, sign)) => {
                all.push((&rest[..at], sign));
                rest = &rest[at + sign.len()..];
            }
            None => {
                all.push((rest, ""));
                return all;
            }
        }
    }
}

/// Whether a clause names a table, a key with its value, a key of several words, or a command with a flag.
fn has_key(clause: &str) -> bool {
    let is_of_key = |sign: char| sign.is_ascii_lowercase() || sign == '_';
    let has_flag = clause
        .split('`')
        .skip(1)
        .step_by(2)
        .any(|command| command.starts_with("dolmen ") && command.contains(" --"));
    let mut rest = clause;
    let mut before = None;
    while let Some(start) = rest.find(is_of_key) {
        let last = rest[..start].chars().next_back().or(before);
        let own = &rest[start..];
        let end = own.find(|sign| !is_of_key(sign)).unwrap_or(own.len());
        let (word, after) = own.split_at(end);
        let is_long = word.len() > 2 && dolmen_project::is_key(word);
        let is_named = word.contains('_') || after.starts_with(" = ") || last == Some('[');
        if is_long && is_named {
            return true;
        }
        before = word.chars().next_back();
        rest = after;
    }
    has_flag
}

fn without_commands(text: &str, language: Language) -> String {
    let text = without_asides(text);
    let mut said = String::with_capacity(text.len());
    let mut rest = text.as_str();
    while let Some((before, behind)) = rest.split_once("`dolmen ") {
        let Some((command, after)) = behind.split_once('`') else {
            break;
        };
        said.push_str(before);
        let verb = command.split(' ').next().unwrap_or_default();
        match ACTS.iter().find(|(known, _)| *known == verb) {
            Some((_, [english, korean])) => {
                let act = language.pick(english, korean);
                let begins = said.is_empty() || said.ends_with(". ");
                said.push_str(&if begins { capital(act) } else { (*act).to_string() });
            }
            None => said.push_str(command),
        }
        rest = after;
    }
    said + rest
}

fn capital(text: &str) -> String {
    let mut signs = text.chars();
    let first = signs.next().into_iter().flat_map(char::to_uppercase);
    first.chain(signs).collect()
}

/// Without brackets that hold nothing but commands, keys or flags: "(`dolmen compare`)", "(--law both)", "(`tilt`, `offset`)".
fn without_asides(text: &str) -> String {
    let mut said = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, behind)) = rest.split_once('(') {
        let inside = behind.split_once(')').filter(|(inside, _)| is_aside(inside));
        match inside {
            Some((_, after)) => {
                said.push_str(before.trim_end_matches(' '));
                rest = after;
            }
            None => {
                said.push_str(before);
                said.push('(');
                rest = behind;
            }
        }
    }
    said + rest
}

fn is_aside(inside: &str) -> bool {
    if inside.starts_with("--") {
        return true;
    }
    // the text between backquotes
    let between: String = inside.split('`').step_by(2).collect();
    inside.starts_with('`') && between.chars().all(|sign| matches!(sign, ',' | ' '))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_what_to_write_into_the_file_is_left_out() {
        let english = |text| without_keys(text, Language::English);
        let korean = |text| without_keys(text, Language::Korean);
        for (said, shown) in [
            (
                "It leans as found, tilt 1/300; as_surveyed = \"none\" leaves that out.",
                "It leans as found, tilt 1/300.",
            ),
            (
                "Find the stiffness (`dolmen identify`); if a survey determines it, `dolmen identify PROJECT --write` puts it into the file.",
                "Find the stiffness (`dolmen identify`).",
            ),
            (
                "Peaks: 3 Hz (damping 0.2 %, below 0.5 %; damping_least lowers the bound), 7 Hz.",
                "Peaks: 3 Hz (damping 0.2 %, below 0.5 %), 7 Hz.",
            ),
            (
                "Without damping. Give damping_ratio; stone poles have 1 to 5 %.",
                "Without damping. Stone poles have 1 to 5 %.",
            ),
            (
                "Nothing followed. Look at the structure; then enter it into works of [watch].",
                "Nothing followed. Look at the structure; then enter it into the list of works.",
            ),
            // nothing else would be left
            ("storey_drift is missing.", "storey_drift is missing."),
            // names of the user, coordinates
            (
                "The mode turns about x = 2, y = 3; so does tower_1.",
                "The mode turns about x = 2, y = 3; so does tower_1.",
            ),
        ] {
            assert_eq!(english(said), shown);
        }
        for (said, shown) in [
            (
                "허용값이 없어 판정하지 않았다. [limits]에 storey_drift를 쓴다.",
                "허용값이 없어 판정하지 않았다.",
            ),
            (
                "강성을 추정한다(`dolmen identify`). 한 조사로 하나만 정해지면 `dolmen identify PROJECT --write`가 그 값을 파일에 쓴다.",
                "강성을 추정한다(`dolmen identify`).",
            ),
            (
                "점검에 없다. 보수하였다면 [watch]의 works에 repair로 적는다.",
                "점검에 없다. 보수하였다면 조치 이력에 보수로 적는다.",
            ),
            (
                "3 Hz(감쇠비가 하한보다 작다. damping_least로 하한을 낮출 수 있다), 7 Hz.",
                "3 Hz(감쇠비가 하한보다 작다), 7 Hz.",
            ),
        ] {
            assert_eq!(korean(said), shown);
        }
    }

    #[test]
    fn exact_commands_become_acts_and_asides_go() {
        let english = |text| without_commands(text, Language::English);
        let korean = |text| without_commands(text, Language::Korean);
        assert_eq!(
            english("let `dolmen identify` find the stiffness (`tilt`, `offset`)."),
            "let the identification from vibration find the stiffness."
        );
        assert_eq!(
            korean("`dolmen identify PROJECT --write`로 쓰고 두 조사를 비교한다(`dolmen compare`)."),
            "진동 평가로 쓰고 두 조사를 비교한다."
        );
        assert_eq!(
            english("Not shown here. `dolmen watch` finds both, and `dolmen check` one."),
            "Not shown here. The review of all surveys finds both, and the check of stability one."
        );
        assert_eq!(
            english("It can be asked for (--law both)."),
            "It can be asked for."
        );
        assert_eq!(korean("기울기(x, `tilt`)와 `폭`"), "기울기(x, `tilt`)와 `폭`");
    }
}
