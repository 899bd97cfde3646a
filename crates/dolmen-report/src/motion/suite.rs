//! A suite of motions whose mean spectrum follows a demand.

use crate::brief_rows::BriefText;
use crate::document::{Block, Cell, Column, Document, Table, TextStyle, document_text, heading_text};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::motion::{NotTaken, SuiteAnswer, SuiteMember};

/// Excess of the mean over the demand that is reported. Our choice.
const ABOVE_SAID: f64 = 0.3;

messages! {
    /// A suite.
    pub(crate) enum Suite in "motion.suite" {
        Head(count: usize) => { en: "Suite of {count} motions", ko: "지반운동 세트({count}개)" },
        Follows { taken: usize, of: usize, demand: String, from: Quantity, to: Quantity, damping: Quantity } => {
            en: "{taken} of {of} records for {demand}, {from} to {to}, damping {damping}, chosen by Dolmen's own rule.",
            ko: "{demand}에 맞추어 Dolmen의 규칙으로 기록 {of}개 중 {taken}개를 골랐다. 주기 {from}~{to}, 감쇠비 {damping}.",
        },
        Mean { mean: Quantity, lowest: Quantity, at: Quantity, highest: Quantity } => {
            en: "Misfit of the mean spectrum {mean} (root mean square), {lowest} at {at} to {highest}.",
            ko: "평균 스펙트럼의 오차는 제곱평균제곱근 {mean}, 최소 {lowest}(주기 {at}), 최대 {highest}이다.",
        },
        Rule { share: Quantity, least: Quantity, most: Quantity, alike: usize } => {
            en: "Dolmen's own rule, of no code: the mean over the periods is at least that of the demand, no period below {share} of it; factors {least} to {most}; of one record one direction, of one earthquake and of one station {alike} where files say them.",
            ko: "Dolmen의 규칙이며 어느 기준의 조항도 아니다. 모든 주기에 걸친 평균이 목표 이상이고 어느 주기에서도 목표의 {share} 이상이다. 배율은 {least}~{most}이고, 한 기록에서는 한 방향, 파일에 적혀 있으면 한 지진과 한 관측소에서는 {alike}개까지 고른다.",
        },
        Above { highest: Quantity, at: Quantity } => {
            en: "The mean lies {highest} above the demand at {at}: give more records, a narrower --range, or --match, or the structure is shaken harder there than the demand asks.",
            ko: "주기 {at}에서 평균이 목표보다 {highest} 크다. 기록을 더 주거나 --range를 좁히거나 --match를 쓴다. 그대로 쓰면 그 주기에서 목표보다 강하게 흔든다.",
        },
        Short(share: Quantity) => {
            en: "NOT FOLLOWED: the mean of the matched motions falls below {share} of the demand; leave --match out, or give other records.",
            ko: "목표에 미치지 못함: 부합시킨 지반운동의 평균이 목표의 {share}보다 작다. --match를 빼거나 다른 기록을 준다.",
        },
        Caption => {
            en: "Motions, each against the demand as it acts: negative where it falls short.",
            ko: "배율을 적용한 각 지반운동의 목표에 대한 오차. 음의 값은 목표보다 작음을 뜻한다.",
        },
        Motion => { en: "motion", ko: "지반운동" },
        Name(name: String) => { en: "{name}", ko: "{name}" },
        Factor => { en: "factor", ko: "배율" },
        Peak => { en: "PGA", ko: "최대지반가속도" },
        RootMeanSquare => { en: "rms", ko: "제곱평균제곱근" },
        Lowest => { en: "lowest", ko: "최소" },
        Highest => { en: "highest", ko: "최대" },
        Matched(count: usize) => {
            en: "Each of the {count} was matched to the demand by wavelets after it was multiplied: its factor is in the file already.",
            ko: "{count}개 모두 배율을 곱한 뒤 웨이블릿으로 목표에 부합시켰다. 배율은 파일에 이미 들어 있다.",
        },
        NoDirection(count: usize) => {
            en: "{count} of the records do not say which way they point and were taken as horizontal: keep vertical ones out of the folder.",
            ko: "기록 {count}개는 방향이 적혀 있지 않아 수평으로 보았다. 연직 성분은 폴더에서 뺀다.",
        },
        Vertical(count: usize) => {
            en: "Vertical channels, without a part: {count}.",
            ko: "연직 성분이라 뺀 채널: {count}개.",
        },
        CopyOf { file: String, first: String } => {
            en: "Not taken: {file} is {first} again: the same samples, or scaled, turned over, cut or sampled anew.",
            ko: "뺀 파일: {file}은(는) {first}의 사본이다. 표본이 같거나 배율·부호·길이·표본 간격만 다르다.",
        },
        Refused { file: String, why: Both } => {
            en: "Not taken: {file}: {why}",
            ko: "뺀 파일: {file}: {why}",
        },
    }
}

/// The suite on a terminal.
pub fn suite_text(answer: &SuiteAnswer, style: TextStyle) -> String {
    let head = Suite::Head(answer.members.len());
    let head = heading_text(&Sentence::from(head).text(style.language));
    let lead = Block::Paragraph(vec![lead(answer), nearness(answer)]);
    let warnings: Vec<Sentence> = short(answer).into_iter().chain(above(answer)).collect();
    let members = members(answer);
    if style.is_full {
        let mut document = Document { blocks: vec![lead] };
        document.blocks.extend(warnings.into_iter().map(Block::Warning));
        document.paragraph(rule(answer));
        document.put(Block::Table(members));
        remarks(answer)
            .into_iter()
            .for_each(|remark| document.note(remark));
        return head + &document_text(&document, style);
    }
    let mut brief = BriefText::new(style);
    brief.block(lead);
    brief.blocks(warnings.into_iter().map(Block::Warning));
    let count = members.rows.len();
    brief.table(&members, count);
    brief.blocks(remarks(answer).into_iter().map(Block::Note));
    brief.block(Block::Paragraph(vec![rule(answer)]));
    head + &brief.finish()
}

fn seconds(period_s: f64) -> Quantity {
    Quantity::new(period_s, Unit::si("s"), Digits::Trimmed(3))
}

fn tenths(share: f64) -> Quantity {
    Quantity::new(share, Unit::percent(), Digits::Fixed(1))
}

/// Number of chosen records, and the demand.
pub(super) fn lead(answer: &SuiteAnswer) -> Sentence {
    let end = |at: Option<&f64>| seconds(at.copied().unwrap_or(0.0));
    Suite::Follows {
        taken: answer.members.len(),
        of: answer.candidates,
        demand: answer.demand.clone(),
        from: end(answer.periods_s.first()),
        to: end(answer.periods_s.last()),
        damping: Quantity::new(answer.damping_ratio, Unit::percent(), Digits::Trimmed(6)),
    }
    .into()
}

fn nearness(answer: &SuiteAnswer) -> Sentence {
    Suite::Mean {
        mean: tenths(answer.misfit.root_mean_square),
        lowest: tenths(answer.misfit.lowest),
        at: seconds(answer.worst_s),
        highest: tenths(answer.misfit.highest),
    }
    .into()
}

fn rule(answer: &SuiteAnswer) -> Sentence {
    let factor = |value| Quantity::new(value, Unit::ratio(), Digits::Trimmed(3));
    let [least, most] = answer.rule.factors;
    Suite::Rule {
        share: Quantity::percent(answer.rule.least_share, 2),
        least: factor(least),
        most: factor(most),
        alike: answer.rule.alike_most,
    }
    .into()
}

fn short(answer: &SuiteAnswer) -> Option<Sentence> {
    let share = || Quantity::percent(answer.rule.least_share, 2);
    (!answer.is_kept()).then(|| Suite::Short(share()).into())
}

/// A note if the mean is far above the demand.
fn above(answer: &SuiteAnswer) -> Option<Sentence> {
    let over = |k: &usize| answer.mean_m_s2[*k] / answer.target_m_s2[*k];
    let at = (0..answer.periods_s.len()).max_by(|a, b| over(a).total_cmp(&over(b)))?;
    let is_far = answer.misfit.highest > ABOVE_SAID;
    let (highest, at) = (tenths(answer.misfit.highest), seconds(answer.periods_s[at]));
    is_far.then(|| Suite::Above { highest, at }.into())
}

fn members(answer: &SuiteAnswer) -> Table {
    Table {
        caption: vec![Suite::Caption.into()],
        columns: vec![
            Column::words(Suite::Motion),
            Column::numbers(Suite::Factor, Unit::ratio()),
            Column::numbers(Suite::Peak, Unit::si("g")),
            Column::numbers(Suite::RootMeanSquare, Unit::percent()),
            Column::numbers(Suite::Lowest, Unit::percent()),
            Column::numbers(Suite::Highest, Unit::percent()),
        ],
        rows: answer.members.iter().map(row).collect(),
    }
}

fn row(member: &SuiteMember) -> Vec<Cell> {
    let number = |value, digits| Cell::number(Quantity::new(value, Unit::ratio(), digits));
    let misfit = &member.misfit;
    let mut cells = vec![
        Cell::words(Suite::Name(member.name.clone())),
        number(member.factor, Digits::Fixed(3)),
        number(member.peak_m_s2() / STANDARD_GRAVITY_M_S2, Digits::Fixed(3)),
    ];
    let shares = [misfit.root_mean_square, misfit.lowest, misfit.highest];
    cells.extend(shares.map(|share| Cell::number(tenths(share))));
    cells
}

fn remarks(answer: &SuiteAnswer) -> Vec<Sentence> {
    let mut said: Vec<Sentence> = Vec::new();
    let count = answer
        .members
        .iter()
        .filter(|member| member.matched.is_some())
        .count();
    if count > 0 {
        said.push(Suite::Matched(count).into());
    }
    let refused = answer.not_taken.iter().filter_map(|(file, why)| match why {
        NotTaken::Refused { why } => Some(Sentence::from(Suite::Refused {
            file: file.clone(),
            why: why.clone(),
        })),
        NotTaken::CopyOf { file: first } => Some(Sentence::from(Suite::CopyOf {
            file: file.clone(),
            first: first.clone(),
        })),
        NotTaken::Vertical => None,
    });
    said.extend(refused);
    let count = answer.without_direction;
    if count > 0 {
        said.push(Suite::NoDirection(count).into());
    }
    let is_vertical = |(_, why): &&(String, NotTaken)| *why == NotTaken::Vertical;
    let count = answer.not_taken.iter().filter(is_vertical).count();
    if count > 0 {
        said.push(Suite::Vertical(count).into());
    }
    said
}
