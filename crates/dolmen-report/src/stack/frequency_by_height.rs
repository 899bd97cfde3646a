//! First frequencies of pagodas like that of the file, with other heights and storeys.

use crate::document::{Cell, Column, Document, Figure, Series, Table};
use crate::figures::frequency_by_height;
use dolmen::stability::stack::period_of_thumb;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::{FrequencyByHeight, HeightAndFrequency};
use dolmen_work::state::StackAnswer;

messages! {
    /// Frequency against height.
    pub(crate) enum ByHeight in "stack.frequency_by_height" {
        Caption => {
            en: "First frequency of swaying against the height of the body.",
            ko: "탑신 높이에 따른 1차 고유진동수.",
        },
        Meaning => {
            en: "Pagodas of the other factors and joints of the file, as Fig. 17 of Kim, Koo and Hong (2018). With every joint four times as stiff all are twice as high, with a quarter half: it goes with the root of one factor on all springs.",
            ko: "파일의 다른 인자와 접합면을 그대로 둔 석탑이며, 김남희·구인영·홍성걸(2018)의 그림 17에 해당한다. 진동수는 모든 스프링에 곱한 배수의 제곱근에 비례하므로 강성이 4배이면 2배, 1/4이면 절반이 된다.",
        },
        Body => { en: "body", ko: "탑신 높이" },
        Storeys { count: usize } => { en: "{count} storeys", ko: "{count}층" },
        OfHeight => { en: "eq. 1, height alone", ko: "식 (1), 높이만" },
    }
}

/// Body height and the frequency from the total height alone.
fn of_thumb(grid: &[FrequencyByHeight]) -> Vec<[f64; 2]> {
    let longest = grid.iter().max_by_key(|of| of.points.len());
    let points = longest.into_iter().flat_map(|of| &of.points);
    let each = points.filter_map(|point| {
        let thumb = period_of_thumb(point.height_m).ok()?;
        Some([point.body_height_m, 1.0 / thumb.period_s])
    });
    each.collect()
}

/// The table and the figure; empty for a stack without factors.
pub(super) fn section<'a>(document: &mut Document<'a>, answer: &'a StackAnswer) {
    let grid = &answer.frequency_by_height;
    let thumb = of_thumb(grid);
    if thumb.is_empty() {
        return;
    }
    let caption = vec![Sentence::from(ByHeight::Caption), ByHeight::Meaning.into()];
    document.put(crate::document::Block::Table(table(
        grid,
        &thumb,
        caption.clone(),
    )));
    let drawn = Figure::drawn(caption, {
        let thumb = thumb.clone();
        move |language| frequency_by_height(grid, &thumb, language).unwrap_or_default()
    });
    document.charted(drawn.with_series(move || series(grid)));
}

fn at(of: &FrequencyByHeight, body_height_m: f64) -> Option<&HeightAndFrequency> {
    of.points
        .iter()
        .find(|point| point.body_height_m == body_height_m)
}

fn table(grid: &[FrequencyByHeight], thumb: &[[f64; 2]], caption: Vec<Sentence>) -> Table {
    let hertz = Unit::si("Hz");
    let number = |value: f64| Quantity::new(value, hertz.clone(), Digits::Significant(3));
    let mut columns = vec![Column::numbers(ByHeight::Body, Unit::si("m"))];
    for of in grid {
        let count = of.storeys as usize;
        columns.push(Column::numbers(ByHeight::Storeys { count }, hertz.clone()));
    }
    columns.push(Column::numbers(ByHeight::OfHeight, hertz.clone()));
    let rows = thumb.iter().map(|[body_height_m, thumb_hz]| {
        let body = Quantity::new(*body_height_m, Unit::si("m"), Digits::Trimmed(4));
        let each = grid
            .iter()
            .map(|of| Cell::Number(at(of, *body_height_m).map(|point| number(point.frequency_hz))));
        std::iter::once(Cell::number(body))
            .chain(each)
            .chain([Cell::number(number(*thumb_hz))])
            .collect()
    });
    Table {
        caption,
        rows: rows.collect(),
        columns,
    }
}

fn series(grid: &[FrequencyByHeight]) -> Vec<Series> {
    let each = grid.iter().flat_map(|of| {
        let count = of.storeys as usize;
        [
            Series::numbers(
                ByHeight::Body,
                "m",
                of.points.iter().map(|point| point.body_height_m),
            ),
            Series::numbers(
                ByHeight::Storeys { count },
                "Hz",
                of.points.iter().map(|point| point.frequency_hz),
            ),
        ]
    });
    each.collect()
}
