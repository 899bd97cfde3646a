//! Tilts as surveys read them, each survey by itself: the newest, and those beyond the limit.

use crate::near_limit::is_near;
use crate::watched::WatchAnswer;
use dolmen_project::WorkKind;
use std::collections::BTreeMap;

/// The tilt of one survey: x and y of one mark together, other directions separately.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltRead {
    /// Index of the survey.
    pub survey: usize,
    /// Its day.
    pub day: f64,
    /// The mark.
    pub datum: Option<String>,
    /// The directions.
    pub directions: Vec<String>,
    /// Horizontal over vertical; with its sign for one direction, the resultant for two.
    pub ratio: f64,
    /// The limit of its size.
    pub limit: Option<f64>,
}

impl TiltRead {
    /// Its size over the limit.
    pub fn share_of_limit(&self) -> Option<f64> {
        self.limit.map(|limit| (self.ratio / limit).abs())
    }

    /// Whether it is near its limit, or has reached it.
    pub fn is_near(&self) -> bool {
        self.share_of_limit().is_some_and(is_near)
    }

    /// Whether it has reached its limit.
    pub fn is_beyond(&self) -> bool {
        self.limit.is_some_and(|limit| self.ratio.abs() >= limit.abs())
    }
}

/// Readings beyond the limit, of which the newest reading is not one.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltsBeyond {
    /// The largest of them.
    pub largest: TiltRead,
    /// Their number.
    pub count: usize,
}

impl WatchAnswer {
    /// The tilts of each mark and direction, x and y together, in the order of the surveys.
    fn tilts_read(&self) -> Vec<Vec<TiltRead>> {
        let limit = self.project.watch.tilt_limit;
        type Group = (Option<String>, Option<String>);
        let mut groups: BTreeMap<Group, BTreeMap<usize, TiltRead>> = BTreeMap::new();
        for trend in &self.watched.tilts {
            let of = &trend.series;
            let is_plane = matches!(of.direction.as_str(), "x" | "y");
            let apart = (!is_plane).then(|| of.direction.clone());
            let own = groups.entry((of.datum.clone(), apart)).or_default();
            for ((survey, day), ratio) in of.surveys.iter().zip(&of.days).zip(&of.ratios) {
                let read = own.entry(*survey).or_insert_with(|| TiltRead {
                    survey: *survey,
                    day: *day,
                    datum: of.datum.clone(),
                    directions: Vec::new(),
                    ratio: 0.0,
                    limit,
                });
                read.ratio = match read.directions.is_empty() {
                    true => *ratio,
                    false => read.ratio.hypot(*ratio),
                };
                read.directions.push(of.direction.clone());
            }
        }
        let each = groups.into_values().map(|reads| reads.into_values().collect());
        each.collect()
    }

    /// The newest reading of each tilt, without marks that were replaced.
    pub fn latest_tilts(&self) -> Vec<TiltRead> {
        let is_current = |read: &TiltRead| {
            let mut series = self.watched.tilts.iter().map(|trend| &trend.series);
            series.any(|of| {
                of.datum == read.datum && read.directions.contains(&of.direction) && !self.is_replaced(of)
            })
        };
        let newest = self
            .tilts_read()
            .into_iter()
            .filter_map(|reads| reads.last().cloned());
        newest.filter(is_current).collect()
    }

    /// For each tilt whose newest reading is below its limit: the earlier readings beyond it since the last repair.
    pub fn tilts_were_beyond(&self) -> Vec<TiltsBeyond> {
        let repaired_after = |day: f64| {
            let mut repairs = self
                .works
                .iter()
                .filter(|(_, work)| work.kind == WorkKind::Repair);
            repairs.any(|(on, _)| *on > day && !self.is_far_ahead(*on))
        };
        let each = self.tilts_read().into_iter().filter_map(|reads| {
            let is_now = reads.last().is_none_or(TiltRead::is_beyond);
            let beyond = reads
                .iter()
                .filter(|read| read.is_beyond() && !repaired_after(read.day));
            let beyond: Vec<&TiltRead> = beyond.collect();
            let largest = beyond
                .iter()
                .max_by(|a, b| a.ratio.abs().total_cmp(&b.ratio.abs()))
                .filter(|_| !is_now)?;
            Some(TiltsBeyond {
                largest: (*largest).clone(),
                count: beyond.len(),
            })
        });
        each.collect()
    }
}

#[cfg(test)]
mod tests {
    use crate::opened::Opened;
    use crate::watched::WatchAnswer;
    use dolmen_records::NoFiles;

    fn yearly(x: &[f64], watch: &str) -> WatchAnswer {
        let survey = |(i, x): (usize, &f64)| format!("[survey.{}-05-01]\ntilt.x = \"{x} mm/m\"\n", 2010 + i);
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"Pole\"\n[watch]\ntilt_limit = \"1/150\"\n{watch}\n{}",
            x.iter().enumerate().map(survey).collect::<String>()
        );
        let opened = Opened::read(text, "p".to_owned(), &NoFiles).unwrap();
        crate::watch::watch(&opened, &NoFiles, &crate::progress::Silent).unwrap()
    }

    #[test]
    fn exact_the_newest_reading_against_its_limit() {
        // the limit is 6.667 mm/m
        for (last, is_near, is_beyond) in [(5.3, false, false), (5.34, true, false), (6.7, true, true)] {
            let answer = yearly(&[4.0, 4.5, last], "");
            let [read] = answer.latest_tilts().try_into().unwrap();
            assert_eq!(
                (read.survey, read.is_near(), read.is_beyond()),
                (2, is_near, is_beyond),
                "{last}"
            );
            assert_eq!(answer.is_tilt_beyond(), is_beyond, "{last}");
        }
        // a reading beyond the limit counts, though the line through all is below it
        let steady = [5.5, 5.4, 5.6, 5.5, 5.4, 5.6, 5.5, 5.4, 5.6, 6.8];
        assert!(yearly(&steady, "").is_tilt_beyond());
    }

    #[test]
    fn exact_earlier_readings_beyond_the_limit_are_kept() {
        let beyond = |x: &[f64], watch: &str| -> Vec<(usize, usize)> {
            let found = yearly(x, watch).tilts_were_beyond();
            found.iter().map(|of| (of.largest.survey, of.count)).collect()
        };
        assert_eq!(beyond(&[3.0, 6.9, 3.1], ""), [(1, 1)]);
        assert_eq!(beyond(&[3.0, 6.9, -7.5, 6.8, 3.1], ""), [(2, 3)]);
        assert_eq!(beyond(&[3.0, 6.0, 3.1], ""), []);
        assert_eq!(beyond(&[3.0, 6.9, 7.1], ""), []);
        let righted = "works = [ { date = \"2011-07-01\", kind = \"repair\" } ]";
        assert_eq!(beyond(&[3.0, 6.9, 3.1], righted), []);
    }
}
