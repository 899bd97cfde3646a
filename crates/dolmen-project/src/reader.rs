//! Common tools of reading: units, places, faults, and numbers as quantities.

use super::content::{Warning, WarningKind};
use super::doubted::Doubted;
use super::error::Fault;
use super::file::{KindRaw, UnitsRaw};
use super::file_number::{At, EvidenceRaw, NumberRaw, QuantityRaw};
use super::identified::identified_from;
use super::measure::{Bound, Measure};
use super::quantity::{Evidence, Quantity};
use super::unit_help::{help_of_unit, with_its_unit, write_with_one};
use super::units::{Unit, UnitError, is_angle, parse_unit, split_number, tilt_ratio};
use super::warned::Warned;
use super::written::{in_full, short, with_unit};
use super::written_at::written_at;
use super::wrong::{Common, WrongNumber, WrongUnit};
use dolmen_records::Files;
use dolmen_words::Sentence;
use dolmen_words::message::Both;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// The unit of bare numbers of one measure: its text and its meaning.
#[derive(Clone, Debug)]
struct BareUnit {
    text: String,
    factor: f64,
}

/// An entry of `allow`.
struct Allowed {
    path: At<String>,
    /// Whether any value needed it.
    is_used: bool,
}

/// The state of one reading.
pub(super) struct Reader<'f> {
    units: BTreeMap<Measure, BareUnit>,
    places: BTreeMap<String, Range<usize>>,
    allow: Vec<Allowed>,
    /// Source of numbers without their own source.
    evidence: Option<Evidence>,
    /// The starts of the file's own values, if a variant is read: only they have the default source.
    own: Option<BTreeSet<usize>>,
    /// Paths that a misspelt key was probably intended for.
    meant: Vec<String>,
    /// Access to the files that the project names.
    pub(super) files: &'f dyn Files,
    /// Whether a unit of bare numbers is wrong: their size then has no meaning.
    pub(super) has_wrong_units: bool,
    pub(super) faults: Vec<Fault>,
    warnings: Vec<(Range<usize>, Warning)>,
}

impl<'f> Reader<'f> {
    pub(super) fn new(
        units: Option<&UnitsRaw>,
        kind: KindRaw,
        allow: Option<Vec<At<String>>>,
        files: &'f dyn Files,
    ) -> Self {
        let allowed = allow
            .into_iter()
            .flatten()
            .map(|path| Allowed { path, is_used: false });
        let mut reader = Reader {
            units: BTreeMap::new(),
            places: BTreeMap::new(),
            allow: allowed.collect(),
            evidence: None,
            own: None,
            meant: Vec::new(),
            files,
            has_wrong_units: false,
            faults: Vec::new(),
            warnings: Vec::new(),
        };
        let Some(units) = units else {
            return reader;
        };
        let stiffness = match kind {
            KindRaw::Frame | KindRaw::Building => Measure::StoreyStiffness,
            KindRaw::Stack => Measure::BedStiffness,
            KindRaw::Chain | KindRaw::Survey => Measure::JointStiffness,
        };
        for (name, measure, written) in [
            ("length", Measure::Length, &units.length),
            ("force", Measure::Force, &units.force),
            ("mass", Measure::Mass, &units.mass),
            ("stiffness", stiffness, &units.stiffness),
            ("damping", Measure::JointDamping, &units.damping),
            ("moment", Measure::Moment, &units.moment),
            ("inertia", Measure::Inertia, &units.inertia),
            ("frequency", Measure::Frequency, &units.frequency),
            ("acceleration", Measure::Acceleration, &units.acceleration),
            ("density", Measure::Density, &units.density),
            ("stress", Measure::Stress, &units.stress),
        ] {
            let Some(written) = written else { continue };
            let path = format!("units.{name}");
            reader.mark(&path, &written.span);
            if let Some(unit) = reader.unit(&written.value, &written.span, &path, measure, &path) {
                let bare = BareUnit {
                    text: written.value.trim().to_owned(),
                    factor: unit.factor,
                };
                reader.units.insert(measure, bare);
            } else {
                reader.has_wrong_units = true;
            }
        }
        reader
    }

    /// Sets the source of numbers without their own: of all, or of those that start at one of `own`.
    pub(super) fn set_evidence(&mut self, evidence: Option<EvidenceRaw>, own: Option<BTreeSet<usize>>) {
        self.evidence = evidence.map(self::evidence);
        self.own = own;
    }

    /// Takes the results of the check against the schema.
    pub(super) fn take_over(&mut self, faults: &mut Vec<Fault>, meant: Vec<String>) {
        self.faults.append(faults);
        self.meant = meant;
    }

    /// Whether a fault at a path, or a missing value there, has been reported already.
    pub(super) fn is_reported(&self, path: &str) -> bool {
        self.meant.iter().any(|meant| meant == path)
            || self.faults.iter().any(|fault| fault.is_at_or_below(path))
    }

    /// The unit of bare numbers: its text, and its size in SI units.
    pub(super) fn bare_unit(&self, measure: Measure) -> (&str, f64) {
        let given = self.units.get(&measure);
        given.map_or((measure.si(), 1.0), |unit| (&unit.text, unit.factor))
    }

    /// An SI value in the unit of bare numbers, for a message: "2.61 m".
    pub(super) fn echo(&self, value: f64, measure: Measure) -> String {
        let (unit, factor) = self.bare_unit(measure);
        with_unit(&short(value / factor), unit)
    }

    /// The place of the value at a path.
    pub(super) fn place(&self, path: &str) -> Range<usize> {
        self.places.get(path).cloned().unwrap_or(0..0)
    }

    pub(super) fn mark(&mut self, path: &str, span: &Range<usize>) {
        self.places.insert(path.to_owned(), span.clone());
    }

    pub(super) fn fault(&mut self, fault: Fault) {
        self.faults.push(fault);
    }

    fn allowed(&mut self, path: &str) -> Option<&mut Allowed> {
        self.allow.iter_mut().find(|allowed| allowed.path.value == path)
    }

    /// A probable slip: a fault, or a warning where `allow` names its path.
    pub(super) fn slip(&mut self, path: &str, message: impl Into<Both>, help: impl Into<Both>) {
        if let Some(allowed) = self.allowed(path) {
            allowed.is_used = true;
            self.warn(
                WarningKind::Allowed,
                path,
                Warned::Allowed { slip: message.into() },
            );
            return;
        }
        let (help, path_named) = (help.into(), path.to_owned());
        let help = match help.english.ends_with('?') {
            true => WrongNumber::IfRightThen {
                help,
                path: path_named,
            },
            false => WrongNumber::IfRight {
                help,
                path: path_named,
            },
        };
        let fault = Fault::new(self.place(path), path, message);
        self.fault(fault.allowed(WrongNumber::ProbablySlip).help(help));
    }

    /// A pattern that looks like a slip but may be right: a warning, or nothing where `allow` names its path.
    pub(super) fn doubt(&mut self, path: &str, doubted: Doubted) {
        match self.allowed(path) {
            Some(allowed) => allowed.is_used = true,
            None => self.put(WarningKind::Doubtful, path, doubted.into()),
        }
    }

    pub(super) fn warn(&mut self, kind: WarningKind, path: &str, warned: Warned) {
        self.put(kind, path, warned.into());
    }

    fn put(&mut self, kind: WarningKind, path: &str, message: Sentence) {
        let warning = Warning::new(kind, path, message);
        self.warnings.push((self.place(path), warning));
    }

    /// The place in the text of each value that was read.
    pub(super) fn take_places(&mut self) -> BTreeMap<String, Range<usize>> {
        std::mem::take(&mut self.places)
    }

    /// The warnings, by line, including unnecessary entries of `allow`.
    pub(super) fn take_warnings(&mut self, text: &str) -> Vec<Warning> {
        let mut all = std::mem::take(&mut self.warnings);
        for Allowed { path, .. } in self.allow.iter().filter(|allowed| !allowed.is_used) {
            let path_in_vain = path.value.clone();
            let said = Warned::AllowedInVain { path: path_in_vain };
            let warning = Warning::new(WarningKind::AllowedInVain, "allow", said.into());
            all.push((path.span.clone(), warning));
        }
        for (span, warning) in &mut all {
            if *span == (0..0) {
                *span = written_at(text, &warning.path).unwrap_or(0..0);
            }
            warning.line = Fault::new(span.clone(), "", "").locate(text).line;
        }
        all.sort_by_key(|(span, _)| span.start);
        all.into_iter().map(|(_, warning)| warning).collect()
    }

    /// Reads a unit and checks its dimension. `path` is the place of the unit, `of` the value that it belongs to.
    pub(super) fn unit(
        &mut self,
        text: &str,
        span: &Range<usize>,
        path: &str,
        measure: Measure,
        of: &str,
    ) -> Option<Unit> {
        let unit = match parse_unit(text) {
            Ok(unit) => unit,
            Err(fault) => {
                let (of, said) = (of.to_owned(), fault.said());
                let message = match &fault {
                    UnitError::Unknown { symbol, .. } | UnitError::Ton { symbol }
                        if symbol == text.trim() =>
                    {
                        WrongUnit::At { of, said }
                    }
                    _ => WrongUnit::AtIn {
                        of,
                        text: text.trim().to_owned(),
                        said,
                    },
                };
                self.fault(
                    Fault::new(span.clone(), path, message)
                        .allowed(Common::UnknownUnit)
                        .help(fault.help()),
                );
                return None;
            }
        };
        if measure == Measure::Ratio && is_angle(text) {
            let (of, text) = (of.to_owned(), text.trim().to_owned());
            self.fault(
                Fault::new(span.clone(), path, WrongNumber::AngleForRatio { of, text })
                    .allowed(WrongNumber::WrongKindOfUnit)
                    .help(WrongNumber::TangentOfAngle),
            );
            return None;
        }
        if let Some(unit) = unit.measuring(measure.dimension()) {
            return Some(unit);
        }
        let needed = measure.dimension();
        let message = WrongNumber::NeedsButIs {
            of: of.to_string(),
            needed: needed.said(),
            text: text.trim().to_string(),
            dimension: unit.dimension.said(),
        };
        let help = help_of_unit((of, text), unit.dimension, measure);
        self.fault(
            Fault::new(span.clone(), path, message)
                .allowed(WrongNumber::WrongKindOfUnit)
                .help(help),
        );
        None
    }

    /// A number with its unit: SI value, factor and text.
    fn number(
        &mut self,
        raw: &NumberRaw,
        unit: Option<&At<String>>,
        span: &Range<usize>,
        path: &str,
        measure: Measure,
    ) -> Option<Number> {
        let (value, unit_text, unit_span) = match (raw, unit) {
            (NumberRaw::Number(value), Some(unit)) => (*value, unit.value.as_str(), &unit.span),
            (NumberRaw::Number(value), None) => return self.bare_number(*value, span, path, measure),
            (NumberRaw::Text(text), _) if measure == Measure::Tilt => return self.tilt(text, span, path),
            (NumberRaw::Text(text), _) => {
                let (value, rest) = self.number_and_unit(text, span, path, measure)?;
                if let Some(unit) = unit {
                    let message = WrongNumber::HasItsUnitTwice {
                        path: path.to_string(),
                        text: text.to_string(),
                        unit: unit.value.to_string(),
                    };
                    self.fault(Fault::new(unit.span.clone(), path, message).help(Common::KeepOneOfThem));
                    return None;
                }
                (value, if rest.is_empty() { "1" } else { rest }, span)
            }
        };
        let unit = self.unit(unit_text, unit_span, path, measure, path)?;
        let written = match raw {
            NumberRaw::Number(number) => with_unit(&in_full(*number), unit_text),
            NumberRaw::Text(text) => text.trim().to_owned(),
        };
        Some(Number {
            value: value * unit.factor,
            factor: unit.factor,
            written,
        })
    }

    /// A number without a unit: in the unit of the file, where its measure allows that.
    fn bare_number(
        &mut self,
        value: f64,
        span: &Range<usize>,
        path: &str,
        measure: Measure,
    ) -> Option<Number> {
        if let (true, Some((what, units))) = (value != 0.0, with_its_unit(measure)) {
            let given = short(value);
            let message = WrongNumber::HasNoUnit {
                path: path.to_string(),
                given: given.to_string(),
            };
            let help = write_with_one(&given, units);
            let fault = Fault::new(span.clone(), path, message).allowed(WrongNumber::MustBeWithIts(what));
            self.fault(fault.help(help));
            return None;
        }
        let (text, factor) = self.bare_unit(measure);
        let written = with_unit(&in_full(value), text);
        Some(Number {
            value: value * factor,
            factor,
            written,
        })
    }

    fn tilt(&mut self, text: &str, span: &Range<usize>, path: &str) -> Option<Number> {
        let Some(value) = tilt_ratio(text) else {
            let message = WrongNumber::IsNotTilt {
                path: path.to_string(),
                text: text.to_string(),
            };
            self.fault(Fault::new(span.clone(), path, message).allowed(Common::MustBeTilt));
            return None;
        };
        Some(Number {
            value,
            factor: 1.0,
            written: text.trim().to_owned(),
        })
    }

    /// The number at the start of a text, and the unit after it; only a ratio may have no unit.
    fn number_and_unit<'t>(
        &mut self,
        text: &'t str,
        span: &Range<usize>,
        path: &str,
        measure: Measure,
    ) -> Option<(f64, &'t str)> {
        let (path_named, given) = (path.to_owned(), text.to_owned());
        let must_be = WrongNumber::MustBeNumberOr(measure.example());
        let fault = match split_number(text) {
            None => {
                let message = WrongNumber::IsTextNotNumber {
                    path: path_named,
                    text: given,
                };
                Fault::new(span.clone(), path, message).allowed(must_be)
            }
            Some((_, "")) if measure != Measure::Ratio => {
                let number = text.trim();
                let help = match with_its_unit(measure) {
                    Some((_, units)) => write_with_one(number, units),
                    None => WrongNumber::WriteWithoutQuotesOr {
                        text: number.to_owned(),
                        bare: self.bare_unit(measure).0.to_owned(),
                    },
                };
                let message = WrongNumber::IsTextWithoutUnit {
                    path: path_named,
                    text: given,
                };
                let fault = Fault::new(span.clone(), path, message);
                fault.allowed(must_be).help(help)
            }
            Some((_, rest)) if rest.starts_with(',') => {
                let message = WrongNumber::HoldsComma {
                    path: path_named,
                    text: given,
                };
                let fault = Fault::new(span.clone(), path, message);
                fault
                    .allowed(WrongNumber::UnclearNumber)
                    .help(WrongNumber::WriteDecimalsWithPoint)
            }
            found => return found,
        };
        self.fault(fault);
        None
    }

    /// A quantity; `None` if it is missing or wrong, which is reported.
    pub(super) fn quantity(
        &mut self,
        raw: Option<&At<QuantityRaw>>,
        path: &str,
        measure: Measure,
        bound: Bound,
    ) -> Option<Quantity> {
        let raw = raw?;
        self.quantity_at((&raw.value, &raw.span), path, measure, bound)
    }

    /// A quantity from a value and its place.
    pub(super) fn quantity_at(
        &mut self,
        (value, at): (&QuantityRaw, &Range<usize>),
        path: &str,
        measure: Measure,
        bound: Bound,
    ) -> Option<Quantity> {
        self.mark(path, at);
        let (plain, table, span) = match value {
            QuantityRaw::Plain(plain) => (plain, None, at),
            QuantityRaw::Table(table) => {
                let value = table.value.as_ref()?;
                (&value.value, Some(table), &value.span)
            }
        };
        let unit = table.and_then(|table| table.unit.as_ref());
        let number = self.number(plain, unit, span, path, measure)?;
        self.bounded(number.value, &number.written, span, path, bound)?;
        let mut quantity = Quantity {
            value: number.value,
            unit: measure.si(),
            cov: None,
            source: None,
            cov_source: None,
            survey: None,
            note: None,
            path: path.to_owned(),
            written: number.written,
        };
        let is_own = |own: &BTreeSet<usize>| own.contains(&at.start);
        if self.own.as_ref().is_none_or(is_own) {
            quantity.source = self.evidence;
        }
        if let Some(table) = table {
            quantity.source = table.source.map(evidence).or(quantity.source);
            quantity.note.clone_from(&table.note);
            match identified_from(table, path, at) {
                Ok(survey) => quantity.survey = survey,
                Err(fault) => self.fault(*fault),
            }
            quantity.cov = match (&table.cov, &table.sd) {
                (Some(_), Some(sd)) => {
                    let message = WrongNumber::HasBothCovAnd(path.to_string());
                    self.fault(Fault::new(sd.span.clone(), path, message).help(WrongNumber::CovOrSd));
                    return None;
                }
                (Some(cov), None) => Some(self.cov(cov.value, cov, &format!("{path}.cov"))?),
                (None, Some(sd)) => {
                    let cov = sd.value * number.factor / number.value.abs();
                    Some(self.cov(cov, sd, &format!("{path}.sd"))?)
                }
                (None, None) => None,
            };
            if quantity.cov.is_some_and(|cov| cov > 0.0) && quantity.value <= 0.0 {
                let message = WrongNumber::HasScatter {
                    path: path.to_string(),
                    written: quantity.written.to_string(),
                };
                let fault = Fault::new(at.clone(), path, message);
                self.fault(
                    fault
                        .allowed(WrongNumber::ScatterAboveZero)
                        .help(WrongNumber::NumberWithCovOr),
                );
                return None;
            }
            if quantity.cov.is_some() {
                quantity.cov_source = table.cov_source.map(evidence).or(quantity.source);
            }
        }
        Some(quantity)
    }

    /// A number without scatter and source, in SI; `None` if it is missing or wrong, which is reported.
    pub(super) fn plain(
        &mut self,
        raw: Option<&At<NumberRaw>>,
        path: &str,
        measure: Measure,
        bound: Bound,
    ) -> Option<f64> {
        let raw = raw?;
        self.mark(path, &raw.span);
        let number = self.number(&raw.value, None, &raw.span, path, measure)?;
        self.bounded(number.value, &number.written, &raw.span, path, bound)?;
        Some(number.value)
    }
}

struct Number {
    value: f64,
    factor: f64,
    written: String,
}

fn evidence(raw: EvidenceRaw) -> Evidence {
    match raw {
        EvidenceRaw::Measured => Evidence::Measured,
        EvidenceRaw::Test => Evidence::Test,
        EvidenceRaw::Literature => Evidence::Literature,
        EvidenceRaw::Identified => Evidence::Identified,
        EvidenceRaw::Assumed => Evidence::Assumed,
    }
}
