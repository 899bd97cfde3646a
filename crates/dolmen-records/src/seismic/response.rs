//! Reads instrument responses (SEED RESP), which networks publish for miniSEED files: the value of one count of a recorder.
//!
//! | field | what |
//! |:--|:--|
//! | B050F03, B050F16 | station, network |
//! | B052F03, B052F04 | location, channel |
//! | B052F22, B052F23 | start, end: year, day of year, time |
//! | B053F05 and others | "Response in units lookup" of the first stage: measured quantity |
//! | B058F03, B058F04 | stage, its gain; for stage 0 the total sensitivity, in counts per unit |
//!
//! Source: FDSN (2012) *SEED Reference Manual*, version 2.4, blockettes 50 to 58; in the format of rdseed (IRIS, release 5).

use super::SeismicError;
use super::lines::excerpt;
use crate::start::{days, seconds};
use crate::wrong::OfStation;
use dolmen::signal::Quantity;

/// Response of one channel in a period of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// "KS.ADOA..HGE": network, station, location, channel, as the miniSEED file names it.
    pub channel: String,
    /// Start of the period, s from 1970.
    pub from_s: f64,
    /// End of the period, s from 1970; `None` if it is still valid.
    pub to_s: Option<f64>,
    /// Measured quantity.
    pub quantity: Quantity,
    /// Counts per SI unit of the quantity.
    pub counts_per_unit: f64,
}

/// Fields of a response that is being read.
#[derive(Default)]
struct ResponseParts {
    line: usize,
    station: String,
    network: String,
    location: String,
    channel: String,
    from_s: Option<f64>,
    to_s: Option<f64>,
    quantity: Option<Quantity>,
    whole: Option<f64>,
    stages: Vec<f64>,
    stage: Option<usize>,
}

/// Reads the responses of a RESP file, or of several files in one text.
///
/// # Errors
/// [`SeismicError`] for a field that is missing or does not have the required form.
///
/// # Limits
/// Only the total sensitivity is used. It is valid in the flat part of the response, for accelerometers from 0 to about 40 Hz. If the file
/// does not give it, the gains of the stages are multiplied.
///
/// # Example
/// ```
/// use dolmen_records::motions::responses;
/// let text = "B050F03 Station: ADOA\nB050F16 Network: KS\nB052F03 Location: ??\nB052F04 Channel: HGE\n\
///     B052F22 Start date: 2015,001\nB052F23 End date: No Ending Time\n\
///     B053F05 Response in units lookup: M/S**2 - Acceleration\nB058F03 Stage sequence number: 0\nB058F04 Sensitivity: 2.5e5\n";
/// let found = &responses(text)?[0];
/// assert_eq!((found.channel.as_str(), found.counts_per_unit), ("KS.ADOA..HGE", 2.5e5));
/// # Ok::<(), dolmen_records::motions::SeismicError>(())
/// ```
pub fn responses(text: &str) -> Result<Vec<Response>, SeismicError> {
    let mut all = Vec::new();
    let mut open: Option<ResponseParts> = None;
    for (at, line) in text.lines().enumerate() {
        let number = at + 1;
        let Some((field, value)) = field(line) else {
            continue;
        };
        if field == "B050F03" {
            all.extend(open.take().map(ResponseParts::finished).transpose()?);
            open = Some(ResponseParts {
                line: number,
                station: value.to_owned(),
                ..ResponseParts::default()
            });
            continue;
        }
        if let Some(given) = &mut open {
            given.put(field, value, line, number)?;
        }
    }
    all.extend(open.map(ResponseParts::finished).transpose()?);
    match all.is_empty() {
        true => Err(SeismicError::EndsEarly {
            line: 1,
            wanted: OfStation::ResponseStation.into(),
        }),
        false => Ok(all),
    }
}

/// Splits "B058F04     Sensitivity:   2.5e5" into "B058F04" and "2.5e5".
fn field(line: &str) -> Option<(&str, &str)> {
    let line = line.trim();
    let (field, rest) = line.split_once(char::is_whitespace)?;
    let (_, value) = rest.split_once(':')?;
    (field.len() == 7 && field.starts_with('B')).then_some((field, value.trim()))
}

impl ResponseParts {
    fn put(&mut self, field: &str, value: &str, line: &str, number: usize) -> Result<(), SeismicError> {
        let refused = |wanted: OfStation| SeismicError::Line {
            line: number,
            text: excerpt(line.as_bytes()),
            wanted: wanted.into(),
        };
        match field {
            "B050F16" => self.network = value.to_owned(),
            "B052F03" => self.location = value.trim_matches('?').to_owned(),
            "B052F04" => self.channel = value.to_owned(),
            "B052F22" => self.from_s = Some(time(value).ok_or_else(|| refused(OfStation::ResponseTime))?),
            "B052F23" if !value.starts_with("No ") => {
                self.to_s = Some(time(value).ok_or_else(|| refused(OfStation::ResponseTime))?);
            }
            "B058F03" => self.stage = value.parse().ok(),
            "B058F04" => {
                let gain = value
                    .parse()
                    .ok()
                    .filter(|gain: &f64| gain.is_finite() && *gain != 0.0);
                let gain = gain.ok_or_else(|| refused(OfStation::ResponseGain))?;
                match self.stage {
                    Some(0) => self.whole = Some(gain),
                    _ => self.stages.push(gain),
                }
            }
            _ if self.quantity.is_none() && line.contains("Response in units lookup") => {
                let unit = value.split_whitespace().next().unwrap_or_default();
                self.quantity = Some(match unit.to_ascii_uppercase().as_str() {
                    "M/S**2" | "M/S/S" | "M/S^2" => Quantity::Acceleration,
                    "M/S" => Quantity::Velocity,
                    "M" => Quantity::Displacement,
                    _ => return Err(refused(OfStation::ResponseUnit)),
                });
            }
            _ => {}
        }
        Ok(())
    }

    fn finished(self) -> Result<Response, SeismicError> {
        let missing = |wanted: OfStation| SeismicError::EndsEarly {
            line: self.line,
            wanted: wanted.into(),
        };
        if self.channel.is_empty() {
            return Err(missing(OfStation::ResponseChannel));
        }
        let of_stages = || (!self.stages.is_empty()).then(|| self.stages.iter().product());
        Ok(Response {
            channel: [&self.network, &self.station, &self.location, &self.channel]
                .map(String::as_str)
                .join("."),
            from_s: self.from_s.unwrap_or(f64::NEG_INFINITY),
            to_s: self.to_s,
            quantity: self.quantity.ok_or_else(|| missing(OfStation::ResponseUnit))?,
            counts_per_unit: self
                .whole
                .or_else(of_stages)
                .ok_or_else(|| missing(OfStation::ResponseGain))?,
        })
    }
}

/// Seconds from 1970 of "2015,001" or "2015,001,12:30:00.5".
fn time(text: &str) -> Option<f64> {
    let mut parts = text.split(',').map(str::trim);
    let (year, day_of_year) = (parts.next()?.parse().ok()?, parts.next()?.parse::<i64>().ok()?);
    let day = days(year, 1, 1)? + day_of_year - 1;
    if !(1..=366).contains(&day_of_year) {
        return None;
    }
    let mut of_day = parts.next().unwrap_or("0").split(':').map(str::parse::<f64>);
    let mut next = || of_day.next().unwrap_or(Ok(0.0)).ok();
    let (hour, minute, second) = (next()?, next()?, next()?);
    Some(seconds(day, hour as i64, minute as i64, second))
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEAD: &str = "#\nB050F03     Station:     ADOA\nB050F16     Network:     KS\nB052F03     Location:    ??\nB052F04     Channel:     HGE\n\
        B052F22     Start date:  2015,001,00:00:00.0000\nB052F23     End date:    2020,002\n\
        B053F05     Response in units lookup:              M/S**2 - Acceleration in Meters Per Second Per Second\n\
        B053F06     Response out units lookup:             V - Volts\n";

    #[test]
    fn exact_the_sensitivity_of_the_whole_else_the_product_of_its_stages() {
        let stages = "B058F03     Stage sequence number: 1\nB058F04     Gain: 0.25\nB058F03     Stage sequence number: 2\nB058F04     Gain: 4.0E+05\n";
        let whole = "B058F03     Stage sequence number: 0\nB058F04     Sensitivity: 1.1E+05\n";
        let of = |text: &str| responses(text).unwrap()[0].clone();
        assert_eq!(of(&format!("{HEAD}{stages}")).counts_per_unit, 1e5);
        let both = of(&format!("{HEAD}{stages}{whole}"));
        // 2015-01-01 and 2020-01-02, s from 1970
        assert_eq!(
            (both.counts_per_unit, both.from_s, both.to_s),
            (1.1e5, 1_420_070_400.0, Some(1_577_923_200.0))
        );
        assert_eq!(
            (both.channel.as_str(), both.quantity),
            ("KS.ADOA..HGE", Quantity::Acceleration)
        );
    }

    #[test]
    fn refuses_what_is_no_response() {
        let said = |text: &str| responses(text).unwrap_err().to_string();
        assert!(said("hello").contains("B050F03"), "{}", said("hello"));
        assert!(said(HEAD).contains("B058F04"), "{}", said(HEAD));
        let unit = HEAD.replace("M/S**2", "PA");
        assert!(said(&unit).starts_with("line 8"), "{}", said(&unit));
        let gain = format!("{HEAD}B058F03 Stage: 0\nB058F04 Sensitivity: 0\n");
        assert!(said(&gain).starts_with("line 11"), "{}", said(&gain));
    }
}
