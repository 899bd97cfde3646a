//! The rows of a log in the order of time: files with the newest row first, exports pasted in another order, rows of a wrong clock.

const DAY_S: f64 = 86_400.0;
/// Longest gap between two exports that follow each other, s, and in usual gaps. Our choice.
const JOINED_S: f64 = 31.0 * DAY_S;
const JOINED_GAPS: f64 = 5.0;
/// Largest fraction of the rows that may come from a wrong clock. With more the order of the file is in doubt. Our choice.
const MISDATED_MOST: f64 = 0.2;
/// Rows up to which any number may come from a wrong clock: with so few a fraction says nothing.
const ROWS_FEW: usize = 20;

/// Time, s, and value of a row.
type Row = (f64, f64);

/// Rows by time.
#[derive(Debug, Default)]
pub(super) struct OrderedRows {
    /// The rows; those with equal times in the order of their reading.
    pub(super) rows: Vec<Row>,
    /// Rows with an earlier time than the row read before them.
    pub(super) set_back: usize,
    /// Rows of a wrong clock, left out.
    pub(super) misdated: usize,
    /// Whether the last row is one of them.
    pub(super) ends_misdated: bool,
}

/// The number of rows that contradict the others in time: too many for a wrong clock.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct OutOfOrder(pub(super) usize);

impl OrderedRows {
    /// From rows as the file has them. Where most rows are earlier than the row above, the newest stands first, and the file is read from its end.
    /// Pieces that follow each other in time without overlap, or overlap with equal rows, are exports and are put in order. Otherwise the rows that
    /// contradict most of the others have a wrong clock and are left out.
    pub(super) fn of(mut rows: Vec<Row>) -> Result<Self, OutOfOrder> {
        let steps = || rows.windows(2).map(|pair| pair[1].0 - pair[0].0);
        if steps().filter(|step| *step < 0.0).count() > steps().filter(|step| *step > 0.0).count() {
            rows.reverse();
        }
        if let Some(joined) = exports(&rows) {
            rows = joined;
        }
        let set_back = rows.windows(2).filter(|pair| pair[1].0 < pair[0].0).count();
        let (read, last) = (rows.len(), rows.last().copied());
        let mut rows = of_one_clock(rows);
        let ends_misdated = rows.last().copied() != last;
        let misdated = read - rows.len();
        if read > ROWS_FEW && misdated as f64 > MISDATED_MOST * read as f64 {
            return Err(OutOfOrder(misdated));
        }
        rows.sort_by(|a, b| a.0.total_cmp(&b.0)); // stable: equal times keep their order
        Ok(OrderedRows {
            rows,
            set_back,
            misdated,
            ends_misdated,
        })
    }
}

/// The pieces of a file in the order of time, if each begins where another one ends. `None` for a file in one piece, and where a piece does not fit.
fn exports(rows: &[Row]) -> Option<Vec<Row>> {
    let mut gaps: Vec<f64> = rows
        .windows(2)
        .map(|pair| pair[1].0 - pair[0].0)
        .filter(|gap| *gap > 0.0)
        .collect();
    gaps.sort_by(f64::total_cmp);
    let joined_s = JOINED_S.max(JOINED_GAPS * gaps.get(gaps.len() / 2)?);
    let mut pieces: Vec<&[Row]> = rows
        .chunk_by(|a, b| b.0 >= a.0 - DAY_S && b.0 <= a.0 + joined_s)
        .collect();
    if !pieces.windows(2).any(|pair| first_s(pair[1]) < last_s(pair[0])) {
        return None;
    }
    pieces.sort_by(|a, b| first_s(a).total_cmp(&first_s(b)));
    let follow = |pair: &[&[Row]]| {
        let (from_s, to_s) = (first_s(pair[1]), last_s(pair[0]));
        from_s - to_s <= joined_s && is_alike_within(pair[0], pair[1], [from_s, to_s])
    };
    pieces.windows(2).all(follow).then(|| {
        let mut joined: Vec<Row> = Vec::with_capacity(rows.len());
        for piece in pieces {
            let until_s = last_s(&joined);
            joined.extend(piece.iter().filter(|row| row.0 > until_s));
        }
        joined
    })
}

fn first_s(piece: &[Row]) -> f64 {
    piece.iter().map(|row| row.0).fold(f64::INFINITY, f64::min)
}

fn last_s(piece: &[Row]) -> f64 {
    piece.iter().map(|row| row.0).fold(f64::NEG_INFINITY, f64::max)
}

/// Whether two pieces have the same rows in a span of time.
fn is_alike_within(a: &[Row], b: &[Row], [from_s, to_s]: [f64; 2]) -> bool {
    let within = |piece: &[Row]| -> Vec<Row> {
        let own = piece.iter().filter(|row| row.0 >= from_s && row.0 <= to_s);
        own.copied().collect()
    };
    within(a) == within(b)
}

/// Removes rows with a wrong clock: it keeps the largest set of rows with ascending times, and those within a day of the kept row before them.
fn of_one_clock(rows: Vec<Row>) -> Vec<Row> {
    let mut latest_s = f64::NEG_INFINITY;
    let is_in_order = |(at_s, _): &Row| {
        latest_s = latest_s.max(*at_s);
        *at_s >= latest_s - DAY_S
    };
    if rows.iter().all(is_in_order) {
        return rows;
    }
    // the longest non-descending subsequence (Schensted 1961): for each length the row with the earliest end, and the predecessor of each row
    let (mut ends, mut before): (Vec<usize>, Vec<Option<usize>>) = (Vec::new(), Vec::new());
    for (row, (at_s, _)) in rows.iter().enumerate() {
        let length = ends.partition_point(|end| rows[*end].0 <= *at_s);
        before.push(length.checked_sub(1).map(|shorter| ends[shorter]));
        match ends.get_mut(length) {
            Some(end) => *end = row,
            None => ends.push(row),
        }
    }
    let mut stays = vec![false; rows.len()];
    let mut next = ends.last().copied();
    while let Some(row) = next {
        stays[row] = true;
        next = before[row];
    }
    let mut last_s = f64::NAN;
    let kept = rows.into_iter().zip(stays).filter(|((at_s, _), stays)| {
        if *stays {
            last_s = *at_s;
        }
        *stays || (at_s - last_s).abs() <= DAY_S
    });
    kept.map(|(row, _)| row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row a day, its value being its day.
    fn days(days: impl IntoIterator<Item = i32>) -> Vec<Row> {
        let row = |day: i32| (DAY_S * f64::from(day), f64::from(day));
        days.into_iter().map(row).collect()
    }

    fn ordered(rows: Vec<Row>) -> OrderedRows {
        OrderedRows::of(rows).unwrap()
    }

    #[test]
    fn exact_the_newest_row_first_is_the_same_log() {
        let found = ordered(days((0..1096).rev()));
        assert_eq!(found.rows, days(0..1096));
        assert_eq!(
            (found.misdated, found.set_back, found.ends_misdated),
            (0, 0, false)
        );
        // of two readings of one time the upper one is the later one
        let found = ordered(vec![(9.0, 3.0), (8.0, 2.0), (8.0, 1.0), (7.0, 0.0)]);
        assert_eq!(found.rows, [(7.0, 0.0), (8.0, 1.0), (8.0, 2.0), (9.0, 3.0)]);
    }

    #[test]
    fn exact_exports_pasted_in_another_order_are_one_log() {
        let all = days(0..900);
        for pasted in [
            days((500..900).chain(0..500)),
            days((300..600).chain(600..900).chain(0..300)),
            days((0..300).chain(600..900).chain(300..600)),
            days((500..900).chain(0..520)), // twenty days are in both
            days((500..900).rev().chain((0..500).rev())), // each with its newest row first
            days((0..500).rev().chain((500..900).rev())),
        ] {
            let found = ordered(pasted);
            assert_eq!((found.misdated, found.set_back), (0, 0));
            assert_eq!(found.rows, all);
        }
    }

    #[test]
    fn holds_rows_of_a_wrong_clock_are_no_exports() {
        // the clock restarted in another year, ran ahead, or repeats days with other readings
        for wrong in [-9000..-8960, 5000..5040, 100..140] {
            let other: Vec<Row> = days(wrong).iter().map(|(at, value)| (*at, value + 0.5)).collect();
            let found = ordered([days(0..300), other, days(340..900)].concat());
            assert_eq!((found.misdated, found.ends_misdated), (40, false));
            assert_eq!(found.rows, days((0..300).chain(340..900)));
        }
        let found = ordered([days(0..860), days(-9000..-8960)].concat());
        assert_eq!((found.misdated, found.ends_misdated), (40, true));
    }

    #[test]
    fn refuses_rows_that_are_sorted_by_something_else() {
        // seven times through the days: no more than one pass, 129 rows, and a few beside it ascend
        let shuffled = days((0..900).map(|i| i * 7 % 900));
        let OutOfOrder(rows) = OrderedRows::of(shuffled).unwrap_err();
        assert!(rows > 700, "{rows}");
    }
}
