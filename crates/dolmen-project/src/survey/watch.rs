//! The record of a structure over the years: what was done to it, and how its surveys are watched.

/// How many surveys are watched: `[watch]`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WatchPart {
    /// Mean time between false alarms, years; `None` leaves the choice to the method.
    pub years_between_false_alarms: Option<f64>,
    /// Tilt that must not be reached.
    pub tilt_limit: Option<f64>,
    /// What was done, in the order of the file.
    pub works: Vec<WorkPart>,
}

/// Something that was done to the structure, or befell it.
#[derive(Clone, Debug, PartialEq)]
pub struct WorkPart {
    /// When: "2018", "2018-05" or "2018-05-10".
    pub date: String,
    /// What.
    pub what: Option<String>,
    /// Of what kind.
    pub kind: WorkKind,
}

/// Of what kind a work is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WorkKind {
    /// The structure was changed on purpose: its levels begin anew.
    Repair,
    /// Somebody looked at it.
    Inspection,
    /// Sensors were exchanged or moved.
    Sensors,
    /// An earthquake, a storm, a collision.
    Event,
}

/// The year, month and day that a text begins with: "2019", "2019-04" or "2019-04-02", what is missing 0.
pub fn date_of(text: &str) -> Option<[u32; 3]> {
    let mut parts = text.splitn(3, '-');
    let year = parts.next().filter(|y| y.len() == 4)?.parse().ok()?;
    let mut part = |most: u32| {
        let text = parts.next()?;
        let digits: String = text.chars().take_while(char::is_ascii_digit).collect();
        digits
            .parse()
            .ok()
            .filter(|n| digits.len() == 2 && (1..=most).contains(n))
    };
    let month = part(12);
    let day = month.and_then(|_| part(31));
    Some([year, month.unwrap_or(0), day.unwrap_or(0)])
}
