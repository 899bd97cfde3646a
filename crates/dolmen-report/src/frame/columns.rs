//! Resistance of the free-standing columns of a frame.

use crate::document::{Block, Cell, Column, Document, Figure, Finding, Table, Tone};
use crate::figures::{columns_series, free_columns};
use dolmen::stability::{ColumnPoint, ColumnStanding};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::frame::{ColumnSwing, Springs, StoreyColumns};

messages! {
    /// Findings on columns.
    pub(crate) enum Found in "frame.columns.findings" {
        Stand { storey: usize, count: usize, share: Quantity, force: Quantity, drift: Quantity, falls: Quantity } => {
            en: "the columns of storey {storey} ({count}, free on their stones) hold at most {share} of the weight on them, {force}, at a drift of {drift}; alone they would fall at {falls}.",
            ko: "{storey}층의 자립 기둥 {count}개는 층간변위 {drift}에서 상부 무게의 최대 {share}({force})까지 버틴다. 기둥만으로는 {falls}에서 전도된다.",
        },
        StandRigid { storey: usize, count: usize, share: Quantity, force: Quantity, falls: Quantity } => {
            en: "the columns of storey {storey} ({count}, free on rigid stones) hold at most {share} of the weight on them, {force}, just as they lift off; alone they would fall at a drift of {falls}.",
            ko: "{storey}층의 자립 기둥 {count}개(강체 초석)는 들리기 시작할 때 상부 무게의 최대 {share}({force})까지 버틴다. 기둥만으로는 층간변위 {falls}에서 전도된다.",
        },
        DoNotStand { storey: usize, count: usize, given: Quantity, least: Quantity } => {
            en: "the columns of storey {storey} ({count}) do not stand by their weight alone: their bed has {given}, and {least} is the least. Joints, walls and braces hold them up.",
            ko: "{storey}층의 자립 기둥 {count}개는 자중만으로 서 있지 못한다. 지반반력계수가 {given}(으)로 한계값 {least} 이하이다. 접합부·벽체·가새가 기둥을 지지한다.",
        },
        Alone { storey: usize, beds: Quantity } => {
            en: "nothing but these columns holds storey {storey}: its stiffness is that of their beds, {beds}, and is less as soon as the feet lift off.",
            ko: "{storey}층은 이 기둥만으로 지지된다. 층강성은 주각 지압면의 {beds}이며 주각이 들리면 감소한다.",
        },
        LessThanBeds { storey: usize, given: Quantity, beds: Quantity } => {
            en: "storey {storey} has a stiffness of {given}, less than the beds of its columns alone would give, {beds}: the bed stiffness is too high, or the columns do not bear on their whole feet.",
            ko: "{storey}층의 강성은 {given}(으)로 기둥의 주각 지압면만으로 얻어지는 {beds}보다 작다. 지압면 강성이 너무 크거나 기둥이 전면 접촉하지 않은 것이다.",
        },
    }
}

messages! {
    /// The section on columns.
    pub(crate) enum FreeColumns in "frame.columns" {
        Caption { storey: usize, count: usize } => {
            en: "Columns of storey {storey}: {count}, free on their stones.",
            ko: "{storey}층 자립 기둥 {count}개.",
        },
        Meaning => {
            en: "V is what they resist with by their weight N alone, P-delta in it.",
            ko: "V는 축력 N만에 의한 복원력이며 P-델타 효과를 포함한다.",
        },
        State => { en: "State", ko: "상태" },
        Drift => { en: "drift", ko: "층간변위" },
        DriftShare => { en: "drift / height", ko: "층간변위각" },
        Force => { en: "V", ko: "V" },
        ForceShare => { en: "V/N", ko: "V/N" },
        LiftOff => { en: "feet lift off", ko: "주각 들림 시작" },
        HoldMost => { en: "hold most", ko: "최대 복원력" },
        Fall => { en: "fall", ko: "전도" },
        SwingCaption(storey: usize) => {
            en: "Free swings on the columns of storey {storey}: the larger, the slower.",
            ko: "{storey}층 기둥의 자유진동: 진폭이 클수록 느려진다.",
        },
        SwingMeaning => {
            en: "Everything above the storey moves as one mass; impacts take energy and leave the frequency at an amplitude as it is.",
            ko: "층 상부 전체를 하나의 질량으로 보았다. 충돌은 에너지를 소산시키지만 해당 진폭의 진동수는 바꾸지 않는다.",
        },
        OnColumns => { en: "columns alone", ko: "기둥만" },
        WithSprings => { en: "with joints and walls", ko: "접합부·벽체 포함" },
        Figure(storey: usize) => {
            en: "What the columns of storey {storey} hold against drift.",
            ko: "{storey}층 기둥의 복원력-층간변위 곡선.",
        },
        FigureMeaning => {
            en: "Feet and heads roll without slipping, and nothing crushes.",
            ko: "주각과 주두는 미끄러지지 않고 구르며 압괴는 없다고 본다.",
        },
        Contained { beds: Quantity, springs: Quantity } => {
            en: "Small drifts: the beds give the storey {beds} of its stiffness, {springs} is left for joints, walls and braces. A stiffness from measured frequencies contains the beds' part, and so does that of the file: frequencies and load factor do not count the columns again. At larger drift the joints are drawn linear; where they slip they hold less.",
            ko: "미소변형에서 층강성 가운데 {beds}은(는) 주각 지압면이, 나머지 {springs}은(는) 접합부·벽체·가새가 부담한다. 계측 진동수로 구한 강성에는 지압면의 몫이 포함되어 있으며 파일의 강성도 같은 뜻이다. 따라서 고유진동수와 하중배율에 기둥을 다시 더하지 않는다. 큰 변위에서도 접합부를 선형으로 그렸으므로, 미끄러지면 이보다 작다.",
        },
        Unknown(beds: Quantity) => {
            en: "Small drifts: the beds give the storey {beds}. A stiffness from measured frequencies contains it.",
            ko: "미소변형에서 주각 지압면이 층에 주는 강성은 {beds}이며, 계측 진동수로 구한 층강성에 포함된다.",
        },
        Rigid => {
            en: "On rigid stones the columns do not move before they lift off, so that the stiffness of the storey cannot be divided into joints and columns: the columns stand alone here. Frequencies and load factor rest on the stiffness given.",
            ko: "강체 초석 위에서는 들리기 전까지 기둥이 움직이지 않으므로 층강성을 접합부와 기둥의 몫으로 나눌 수 없다. 여기서는 기둥만 다루며, 고유진동수와 하중배율은 주어진 층강성에 따른다.",
        },
        Grounded => {
            en: "The stiffness given acts on the displacement from the ground, the columns on drift: they are not added.",
            ko: "주어진 강성은 지반 기준 변위에, 기둥은 층간변위에 작용하므로 더하지 않았다.",
        },
    }
}

/// Digits of forces and drifts.
const DIGITS: usize = 4;
/// Digits in findings.
const FEW: usize = 3;

/// Findings on the columns of a direction.
pub(super) fn findings(columns: &StoreyColumns) -> Vec<Finding> {
    let (storey, count) = (columns.storey, columns.count);
    let mut all = vec![match &columns.standing {
        Some(standing) => Finding::key(Tone::Plain, stand(columns, standing)),
        None => {
            let bed = |value| Quantity::engineering(value, "Pa/m", FEW);
            let found = Found::DoNotStand {
                storey,
                count,
                given: bed(columns.bed_stiffness_n_m3.unwrap_or(0.0)),
                least: bed(columns.least_bed_stiffness_n_m3),
            };
            Finding::key(Tone::Warn, found)
        }
    }];
    if let (Springs::Beside { stiffness_n_m }, Some(beds_n_m)) = (columns.springs, columns.bed_stiffness_n_m)
        && stiffness_n_m == 0.0
    {
        let beds = Quantity::engineering(beds_n_m, "N/m", FEW);
        all.push(Finding::key(Tone::Plain, Found::Alone { storey, beds }));
    }
    if let (Springs::LessThanBeds { stiffness_n_m }, Some(beds_n_m)) =
        (columns.springs, columns.bed_stiffness_n_m)
    {
        let found = Found::LessThanBeds {
            storey,
            given: Quantity::engineering(stiffness_n_m, "N/m", FEW),
            beds: Quantity::engineering(beds_n_m, "N/m", FEW),
        };
        all.push(Finding::key(Tone::Warn, found));
    }
    all
}

fn stand(columns: &StoreyColumns, standing: &ColumnStanding) -> Found {
    let (storey, count) = (columns.storey, columns.count);
    let force = Quantity::engineering(standing.greatest.force_n, "N", FEW);
    let share = Quantity::percent(standing.greatest.force_n / columns.axial_n, FEW);
    let falls = Quantity::engineering(standing.falls.drift_m, "m", FEW);
    match columns.bed_stiffness_n_m3 {
        None => Found::StandRigid {
            storey,
            count,
            share,
            force,
            falls,
        },
        Some(_) => Found::Stand {
            storey,
            count,
            share,
            force,
            drift: Quantity::engineering(standing.greatest.drift_m, "m", FEW),
            falls,
        },
    }
}

/// Tables, figure and notes, one set per storey.
pub(super) fn section<'a>(document: &mut Document<'a>, columns: &'a StoreyColumns) {
    let Some(standing) = &columns.standing else {
        return; // the finding reports it
    };
    document.put(Block::Table(states(columns, standing)));
    document.put(Block::Table(swings(columns)));
    let storey = columns.storey;
    let caption = vec![
        FreeColumns::Figure(storey).into(),
        FreeColumns::FigureMeaning.into(),
    ];
    let drawn = Figure::drawn(caption, move |language| free_columns(columns, language));
    document.charted(drawn.with_series(move || columns_series(columns)));
    let stiffness = |value| Quantity::engineering(value, "N/m", DIGITS);
    match (columns.springs, columns.bed_stiffness_n_m) {
        (Springs::Beside { stiffness_n_m }, Some(beds)) => document.note(FreeColumns::Contained {
            beds: stiffness(beds),
            springs: stiffness(stiffness_n_m),
        }),
        (Springs::Grounded, _) => document.note(FreeColumns::Grounded),
        (_, None) => document.note(FreeColumns::Rigid),
        (_, Some(beds)) => document.note(FreeColumns::Unknown(stiffness(beds))),
    }
}

/// Units and cells that both tables share.
struct Shown {
    drift: Unit,
    force: Unit,
    height_m: f64,
    axial_n: f64,
}

impl Shown {
    fn new(columns: &StoreyColumns, standing: &ColumnStanding) -> Shown {
        Shown {
            drift: Unit::of(&[standing.falls.drift_m], "m"),
            force: Unit::of(&[standing.greatest.force_n], "N"),
            height_m: columns.height_m,
            axial_n: columns.axial_n,
        }
    }

    fn heads(&self) -> Vec<Column> {
        vec![
            Column::numbers(FreeColumns::Drift, self.drift.clone()),
            Column::numbers(FreeColumns::DriftShare, Unit::percent()),
            Column::numbers(FreeColumns::Force, self.force.clone()),
            Column::numbers(FreeColumns::ForceShare, Unit::percent()),
        ]
    }

    fn cells(&self, point: &ColumnPoint) -> Vec<Cell> {
        let digits = || Digits::Significant(DIGITS);
        let share =
            |value: f64| Cell::number(Quantity::new(value, Unit::percent(), Digits::Significant(FEW)));
        vec![
            Cell::number(Quantity::new(point.drift_m, self.drift.clone(), digits())),
            share(point.drift_m / self.height_m),
            Cell::number(Quantity::new(point.force_n, self.force.clone(), digits())),
            share(point.force_n / self.axial_n),
        ]
    }
}

fn states(columns: &StoreyColumns, standing: &ColumnStanding) -> Table {
    let shown = Shown::new(columns, standing);
    let fallen = ColumnPoint {
        force_n: 0.0, // to the last digits of the root
        ..standing.falls
    };
    let states = [
        (FreeColumns::LiftOff, standing.uplift),
        (FreeColumns::HoldMost, standing.greatest),
        (FreeColumns::Fall, fallen),
    ];
    let rows = states.into_iter().map(|(name, point)| {
        let mut row = vec![Cell::words(name)];
        row.extend(shown.cells(&point));
        row
    });
    let mut heads = vec![Column::words(FreeColumns::State)];
    heads.extend(shown.heads());
    let (storey, count) = (columns.storey, columns.count);
    Table {
        caption: vec![
            FreeColumns::Caption { storey, count }.into(),
            FreeColumns::Meaning.into(),
        ],
        columns: heads,
        rows: rows.collect(),
    }
}

fn swings(columns: &StoreyColumns) -> Table {
    let hertz = || Unit::si("Hz");
    let has_springs = matches!(columns.springs, Springs::Beside { .. });
    let amplitude: Vec<f64> = columns.swings.iter().map(|swing| swing.at.drift_m).collect();
    let drift = Unit::of(&amplitude, "m");
    let mut heads = vec![
        Column::numbers(FreeColumns::Drift, drift.clone()),
        Column::numbers(FreeColumns::DriftShare, Unit::percent()),
        Column::numbers(FreeColumns::OnColumns, hertz()),
    ];
    if has_springs {
        heads.push(Column::numbers(FreeColumns::WithSprings, hertz()));
    }
    let frequency = |value| Cell::number(Quantity::new(value, hertz(), Digits::Significant(FEW)));
    let row = |swing: &ColumnSwing| {
        let share = swing.at.drift_m / columns.height_m;
        let mut row = vec![
            Cell::number(Quantity::new(
                swing.at.drift_m,
                drift.clone(),
                Digits::Significant(FEW),
            )),
            Cell::number(Quantity::new(share, Unit::percent(), Digits::Significant(FEW))),
            frequency(swing.columns_hz),
        ];
        row.extend(swing.with_springs_hz.map(frequency));
        row
    };
    let caption: Vec<Sentence> = vec![
        FreeColumns::SwingCaption(columns.storey).into(),
        FreeColumns::SwingMeaning.into(),
    ];
    Table {
        caption,
        columns: heads,
        rows: columns.swings.iter().map(row).collect(),
    }
}
