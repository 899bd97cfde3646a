//! The earthquake and station of a channel, if its file states them.

use super::{ComponentReading, MotionFormat};

/// The earthquake and the station of a channel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Origin {
    /// The earthquake, as the file writes it: "Imperial Valley-02, 5/19/1940".
    pub event: Option<String>,
    /// The station, likewise: "El Centro Array #9", "AOM004", "HI.ARS1".
    pub station: Option<String>,
}

/// The origin from the title and the name of a channel: both for AT2, K-NET and ESM, the station for SAC and miniSEED, nothing for others.
///
/// # Example
/// ```
/// use dolmen_records::motions::{MotionOptions, origin, read_component};
/// let file = "PEER\nImperial Valley-02, 5/19/1940, El Centro Array #9, 180\nUNITS OF G\nNPTS= 2, DT= .01 SEC\n0.1 -0.3\n";
/// let origin = origin(&read_component(file.as_bytes(), &MotionOptions::default())?);
/// assert_eq!(origin.event.as_deref(), Some("Imperial Valley-02, 5/19/1940"));
/// assert_eq!(origin.station.as_deref(), Some("El Centro Array #9"));
/// # Ok::<(), dolmen_records::motions::MotionError>(())
/// ```
pub fn origin(reading: &ComponentReading) -> Origin {
    let some = |text: &str| {
        let text = text.trim_matches([' ', ',', '.']);
        (!text.is_empty()).then(|| text.to_owned())
    };
    let fields: Vec<&str> = reading.title.split(',').map(str::trim).collect();
    // a SEED name without its channel
    let of_code = || {
        let (station, _) = reading.name.rsplit_once('.')?;
        some(station)
    };
    match reading.format {
        MotionFormat::At2 => match fields.as_slice() {
            [event, station, _] => Origin {
                event: some(event),
                station: some(station),
            },
            [event, date, station @ .., _] => Origin {
                event: some(&format!("{event}, {date}")),
                station: some(&station.join(", ")),
            },
            _ => Origin::default(),
        },
        MotionFormat::KNet => Origin {
            event: reading
                .title
                .split_once("earthquake of")
                .and_then(|(_, at)| some(at)),
            station: reading.title.split(',').next().and_then(some),
        },
        MotionFormat::Esm => Origin {
            event: match fields.as_slice() {
                [event, date, ..] => some(&format!("{event}, {date}")),
                _ => None,
            },
            station: of_code(),
        },
        MotionFormat::Sac | MotionFormat::SacText | MotionFormat::MiniSeed => Origin {
            event: None,
            station: of_code(),
        },
        MotionFormat::Cosmos | MotionFormat::Csmip | MotionFormat::Text => Origin::default(),
    }
}
