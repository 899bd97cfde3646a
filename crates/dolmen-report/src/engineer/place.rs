//! Location of the structure, purpose of the report, photographs and drawings.

use super::photos::Pictures;
use super::words::said;
use crate::document::{Block, Cell, Document};
use dolmen_project::ReportPart;
use dolmen_words::number::fixed;
use dolmen_words::{Sentence, messages};

/// Digits of degrees: a metre on the ground.
const DIGITS: usize = 5;

messages! {
    /// Place and photographs.
    pub(crate) enum Place in "engineer.place" {
        Head => { en: "Location and photographs", ko: "위치와 사진" },
        HeadOfLocation => { en: "Location", ko: "위치" },
        HeadOfPhotos => { en: "Photographs", ko: "사진" },
        Drawings => { en: "Drawings", ko: "도면" },
        Purpose => { en: "Purpose", ko: "목적" },
        Address => { en: "Address", ko: "소재지" },
        Coordinates => { en: "Coordinates", ko: "좌표" },
        NorthEast { north: String, east: String } => { en: "{north}° N, {east}° E", ko: "북위 {north}°, 동경 {east}°" },
        NorthWest { north: String, east: String } => { en: "{north}° N, {east}° W", ko: "북위 {north}°, 서경 {east}°" },
        SouthEast { north: String, east: String } => { en: "{north}° S, {east}° E", ko: "남위 {north}°, 동경 {east}°" },
        SouthWest { north: String, east: String } => { en: "{north}° S, {east}° W", ko: "남위 {north}°, 서경 {east}°" },
    }
}

/// The section; empty if no data are given.
pub(crate) fn place<'a>(report: &'a ReportPart, pictures: Pictures<'a>) -> Document<'a> {
    let mut document = Document::default();
    let location = report.location.iter();
    let address = location.clone().filter_map(|location| location.address.as_ref());
    let degrees = location.filter_map(|location| location.degrees);
    let mut rows: Vec<(Sentence, Cell)> = Vec::new();
    rows.extend(
        report
            .purpose
            .iter()
            .map(|text| (Place::Purpose.into(), Cell::words(said(text)))),
    );
    rows.extend(address.map(|text| (Place::Address.into(), Cell::words(said(text)))));
    rows.extend(degrees.map(|of| (Place::Coordinates.into(), Cell::words(coordinates(of)))));
    let images = report.images().next().is_some();
    document.heading(match (rows.is_empty(), images) {
        (true, false) => return document,
        (true, true) => Place::HeadOfPhotos,
        (false, false) => Place::HeadOfLocation,
        (false, true) => Place::Head,
    });
    if !rows.is_empty() {
        document.put(Block::KeyValues(rows));
    }
    if !report.photos.is_empty() {
        document.put(Block::Photos(pictures.photos(&report.photos)));
    }
    if !report.drawings.is_empty() {
        document.subheading(Place::Drawings);
        document.put(Block::Photos(pictures.photos(&report.drawings)));
    }
    document
}

/// "35.02930° N, 126.71700° E".
fn coordinates([latitude, longitude]: [f64; 2]) -> Sentence {
    let [north, east] = [latitude, longitude].map(|degrees| fixed(degrees.abs(), DIGITS));
    match (latitude >= 0.0, longitude >= 0.0) {
        (true, true) => Place::NorthEast { north, east },
        (true, false) => Place::NorthWest { north, east },
        (false, true) => Place::SouthEast { north, east },
        (false, false) => Place::SouthWest { north, east },
    }
    .into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_words::Language;

    #[test]
    fn exact_signs_of_degrees_are_north_and_east() {
        let said = |degrees| {
            let said = coordinates(degrees);
            [said.text(Language::English), said.text(Language::Korean)]
        };
        assert_eq!(
            said([35.0293, 126.717]),
            ["35.02930° N, 126.71700° E", "북위 35.02930°, 동경 126.71700°"]
        );
        assert_eq!(
            said([-33.8568, -0.5]),
            ["33.85680° S, 0.50000° W", "남위 33.85680°, 서경 0.50000°"]
        );
    }
}
