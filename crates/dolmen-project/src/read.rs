//! From the text of a project file to a [`Project`]: parse, check against the schema, read, judge, then the variants.

use super::buildable::buildable;
use super::building::building;
use super::chain::{chain, lean_chain};
use super::check::SchemaCheck;
use super::content::{Project, Structure, Variant, Warning, WarningKind};
use super::date_slips::{judge_dates, judge_report_place};
use super::doubted::Doubted;
use super::doubts;
use super::error::{Fault, ProjectError};
use super::exact::exact;
use super::file::{FileRaw, KindRaw};
use super::file_names::NamesRaw;
use super::file_number::{At, QuantityRaw};
use super::foreign::foreign_keys;
use super::frame::{frame, lean_frame};
use super::identified::{sought_by_variant, sought_in_none, without_survey};
use super::inspected::{OfInspections, of_inspections};
use super::leaves::leaves;
use super::length_slips::one_for_all;
use super::limits::limits;
use super::loads::{judge_loads, loads};
use super::measure::{Bound, Measure};
use super::merge::merge;
use super::names::{Names, names};
use super::printed::printed_names;
use super::quantity::Quantity;
use super::reader::Reader;
use super::report::report;
use super::safe_text::unsafe_text;
use super::schema::kind_word;
use super::schema_tree::{BUILT, TREE};
use super::site::{motions, place, site};
use super::slips;
use super::stack::{lean, stack};
use super::study::studies;
use super::survey::{Survey, change, surveys, watch};
use super::syntax::{of_syntax, version};
use super::tabled::Tabled;
use super::tabled_modes::beside_the_file;
use super::units::STANDARD_GRAVITY_M_S2;
use super::unknown_variants::unknown_variants;
use super::warned::Warned;
use super::wrong::{Common, WrongFile};
use dolmen_records::{Files, NoFiles};
use dolmen_words::message::Both;
use serde::Deserialize;
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Keys that hold for the whole file: a variant cannot change them.
const KEYS_OF_THE_FILE: [&str; 9] = [
    "schema", "kind", "units", "variant", "study", "change", "report", "watch", "surveys",
];

/// Most paths in one warning, our choice: further ones are counted.
const PATHS_LISTED: usize = 12;

/// Reads a project file. `file` is its name, for messages only.
///
/// # Errors
/// [`ProjectError`] with every problem found, each with its line, column, and where possible what is allowed and
/// what to do.
///
/// # Example
/// ```
/// use dolmen_project::{Quantity, Structure, parse_project};
/// let text = r#"
/// schema = 1
/// kind = "chain"
/// name = "Two stones"
/// units = { force = "kN" }
/// links = [
///   { weight = 20, length = 2.0, centroid = 0.9 },
///   { weight = "15 kN", length = "1800 mm", centroid = { value = 0.8, cov = 0.05, source = "assumed" } },
/// ]
/// joints = "unknown"
/// "#;
/// let project = parse_project(text, "stones.toml")?;
/// let Structure::Chain(chain) = &project.structure else { unreachable!() };
/// let chain = chain.build(&mut Quantity::nominal).unwrap();
/// assert_eq!(chain.links()[1].length_m, 1.8);
/// assert_eq!(project.input("links[2].centroid").and_then(|q| q.cov), Some(0.05));
///
/// let mistake = text.replace("0.9", "9.0");
/// let fault = parse_project(&mistake, "stones.toml").unwrap_err();
/// assert_eq!(fault.problems[0].message.english, "links[1].centroid = 9 m lies above the link's top");
/// # Ok::<(), dolmen_project::ProjectError>(())
/// ```
pub fn parse_project(text: &str, file: &str) -> Result<Project, ProjectError> {
    parse_project_with(text, file, &NoFiles)
}

/// Reads a project file that may name others: meshes of stones, tables of spectra. `files` gives their bytes.
///
/// # Errors
/// As [`parse_project`]; a fault in another file stands at the key that names the file.
pub fn parse_project_with(text: &str, file: &str, files: &dyn Files) -> Result<Project, ProjectError> {
    read(text, files).map_err(|faults| ProjectError::of(faults, file, text))
}

fn read(text: &str, files: &dyn Files) -> Result<Project, Vec<Fault>> {
    let lists = beside_the_file(text, files)?;
    read_with(text, files, &lists).map_err(|mut faults| {
        Tabled::name_cells(&lists, &mut faults);
        faults
    })
}

fn read_with(text: &str, files: &dyn Files, lists: &[Tabled]) -> Result<Project, Vec<Fault>> {
    let (root, syntax) = DeTable::parse_recoverable(text);
    if !syntax.is_empty() {
        return Err(of_syntax(&syntax, text));
    }
    let span = root.span();
    let mut root = root.into_inner();
    version(&root)?;
    let wrong = unsafe_text(&root);
    if !wrong.is_empty() {
        return Err(wrong);
    }
    lists.iter().for_each(|list| list.put(&mut root));
    let variants = root.remove("variant");
    let mut base = root.clone();
    for key in ["study", "report", "names"] {
        root.remove(key); // of the file as a whole
    }
    let mut faults = Vec::new();
    let project = read_one((text, files), (&mut base, &span), None, &mut faults);
    let mut read_variants = Vec::new();
    if let Some(variants) = variants {
        let DeValue::Table(table) = variants.get_ref() else {
            let fault = Fault::new(variants.span(), "variant", WrongFile::VariantIsNotTable);
            faults.push(
                fault
                    .allowed(WrongFile::MustBeTable)
                    .help(WrongFile::WriteVariantNameAbove),
            );
            return Err(faults);
        };
        let mut listed: Vec<_> = table.iter().collect();
        listed.sort_by_key(|(key, _)| key.span().start);
        for (key, patch) in listed {
            let name = key.get_ref().as_ref();
            read_variants.extend(variant((text, files), name, patch, (&root, &span), &mut faults));
        }
    }
    if let Some(project) = project.as_ref().filter(|_| faults.is_empty()) {
        faults.extend(unknown_variants(project, &read_variants));
        faults.extend(
            read_variants
                .iter()
                .flat_map(|variant| sought_by_variant(variant, project)),
        );
    }
    match project {
        Some(mut project) if faults.is_empty() => {
            let own = read_variants
                .iter()
                .flat_map(|variant| doubts_of(variant, &project));
            let own: Vec<Warning> = own.collect();
            project.warnings.extend(own);
            project
                .warnings
                .extend(lists.iter().flat_map(|list| list.warnings(text)));
            project.variants = read_variants;
            Ok(project)
        }
        _ => Err(faults),
    }
}

/// Doubts of a variant that the file itself does not raise: they are listed with those of the file.
fn doubts_of(variant: &Variant, project: &Project) -> Vec<Warning> {
    let is_new = |warning: &&Warning| {
        warning.kind == WarningKind::Doubtful
            && !project
                .warnings
                .iter()
                .any(|own| own.kind == warning.kind && own.message == warning.message)
    };
    let in_variant = |warning: &Warning| Warning {
        message: Doubted::InVariant {
            variant: variant.name.clone(),
            said: warning.message.clone(),
        }
        .into(),
        ..warning.clone()
    };
    variant
        .project
        .warnings
        .iter()
        .filter(is_new)
        .map(in_variant)
        .collect()
}

/// Reads one whole structure, the file's own or a merged variant.
///
/// `own`: for a variant, the starts of the file's own values.
pub(super) fn read_one<'i>(
    (text, files): (&str, &dyn Files),
    (root, span): (&mut DeTable<'i>, &Range<usize>),
    own: Option<BTreeSet<usize>>,
    faults: &mut Vec<Fault>,
) -> Option<Project> {
    // first: a key of another kind of structure is no fault of type or spelling
    let mut foreign = Vec::new();
    foreign_keys(root, &mut foreign);
    let untouched = root.clone();
    let mut check = SchemaCheck::new(text, &TREE);
    check.file(root, span);
    if !check.faults.is_empty() {
        // the types themselves find the faults, whatever the built-in tree says
        *root = untouched;
        check = SchemaCheck::new(text, &BUILT);
        check.file(root, span);
    }
    check.faults.append(&mut foreign);
    let leaves = leaves(root);
    let tree = Spanned::new(span.clone(), std::mem::take(root));
    let raw = match FileRaw::deserialize(toml::Deserializer::from(tree)) {
        Ok(raw) => raw,
        Err(error) => {
            // Not in the schema: whole numbers beyond 64 bits.
            let message = error.message().lines().next().unwrap_or_default().to_owned();
            check
                .faults
                .push(Fault::new(error.span().unwrap_or(0..0), "", message));
            faults.append(&mut check.faults);
            return None;
        }
    };
    let mut project = of_raw((text, files), raw, own, &mut check);
    if let Some(project) = &mut project {
        project.leaves = Arc::from(leaves);
    }
    let sound = check.faults.is_empty();
    faults.append(&mut check.faults);
    project.filter(|_| sound)
}

fn of_raw(
    (text, files): (&str, &dyn Files),
    mut raw: FileRaw,
    own: Option<BTreeSet<usize>>,
    check: &mut SchemaCheck<'_, '_>,
) -> Option<Project> {
    let kind = raw.kind.as_ref().map(|kind| kind.value);
    let mut reader = Reader::new(
        raw.units.as_ref(),
        kind.unwrap_or(KindRaw::Survey),
        raw.allow.take(),
        files,
    );
    reader.set_evidence(raw.evidence, own);
    reader.take_over(&mut check.faults, std::mem::take(&mut check.meant));
    let gravity = gravity(&mut reader, raw.gravity.as_ref());
    let gravity_given = gravity.as_ref().map(|gravity| gravity.value);
    let gravity_m_s2 = gravity_given.unwrap_or(STANDARD_GRAVITY_M_S2);
    let name = raw
        .name
        .take()
        .and_then(|name| self::name(&mut reader, name, "name"));
    let mut surveys = surveys(&mut reader, raw.survey.as_ref());
    let change = change(&mut reader, raw.change.as_ref());
    let watch = watch(&mut reader, raw.watch.as_ref());
    let has_korean_name = name.as_ref().is_some_and(|name| name.ko.is_some());
    let place = place(&mut reader, raw.site.as_ref(), has_korean_name);
    let site = site(&mut reader, raw.site.as_ref());
    let drift_limit = limits(&mut reader, raw.limits.as_ref(), kind);
    let motions = motions(&mut reader, raw.motion.as_ref());
    let studies = studies(&mut reader, text, raw.study.as_ref());
    let mut structure = structure(&mut reader, (&raw, kind), gravity_m_s2, &surveys);
    let loads = loads(&mut reader, &raw, structure.as_ref());
    match &mut structure {
        Some(Structure::Stack(part)) => part.static_loads.clone_from(&loads.loads),
        Some(Structure::Frame(part)) => part.static_loads.clone_from(&loads.loads),
        _ => {}
    }
    if !reader.has_wrong_units {
        judge_loads(&mut reader, &loads);
        slips::judge(&mut reader, gravity.as_ref(), structure.as_ref(), &surveys);
        if let Some(structure) = &structure {
            one_for_all(&mut reader, text, structure);
        }
    }
    if let Some(structure) = &structure {
        judge_surveys_named(&mut reader, structure, &surveys);
    }
    buildable(&mut reader, structure.as_mut());
    if reader.faults.is_empty() {
        doubts::doubt(&mut reader, structure.as_ref(), &loads, &surveys, &motions);
    }
    let OfInspections { parts, damage } = of_inspections(&mut reader, &raw, &mut surveys, structure.as_mut());
    let report = report(&mut reader, raw.report.as_ref(), &parts);
    judge_report_place(&mut reader, report.as_ref(), has_korean_name);
    judge_dates(&mut reader, &surveys, report.as_ref());
    let printed_names = printed_names(&mut reader, &raw, structure.as_ref(), (&surveys, &motions));
    let schema = raw.schema.and_then(|schema| u32::try_from(schema.value).ok());
    let mut project = match (schema, structure, name) {
        (Some(schema), Some(structure), Some(name)) if reader.faults.is_empty() => Project {
            schema,
            name,
            description: raw.description.map(|given| super::names::names(given.value)),
            printed_names,
            source: raw.source,
            gravity_m_s2,
            structure,
            loads,
            site,
            drift_limit,
            place,
            from_surveys: None,
            motions,
            studies,
            surveys,
            damage: damage.damage,
            earlier: damage.earlier,
            change,
            report,
            watch,
            variants: Vec::new(),
            warnings: Vec::new(),
            leaves: Arc::from([]),
            spans: BTreeMap::new(),
        },
        _ => {
            check.faults.append(&mut reader.faults);
            return None;
        }
    };
    warn_of_assumed(&mut reader, &project);
    project.warnings = reader.take_warnings(text);
    project.spans = reader.take_places();
    Some(project)
}

/// The acceleration of gravity, which samples do not draw.
fn gravity(reader: &mut Reader, raw: Option<&At<QuantityRaw>>) -> Option<Quantity> {
    let given = reader.quantity(raw, "gravity", Measure::Acceleration, Bound::Positive);
    exact(reader, given, raw)
}

/// Rejects numbers and stiffness whose survey is not in the file.
fn judge_surveys_named(reader: &mut Reader, structure: &Structure, surveys: &[Survey]) {
    let names: Vec<&str> = surveys.iter().map(|survey| survey.name.as_str()).collect();
    let mut faults = without_survey(&structure.inputs(), &names, |path| reader.place(path));
    faults.extend(sought_in_none(structure, &names, |path| reader.place(path)));
    faults.into_iter().for_each(|fault| reader.fault(fault));
}

fn structure(
    reader: &mut Reader,
    (raw, kind): (&FileRaw, Option<KindRaw>),
    gravity_m_s2: f64,
    surveys: &[Survey],
) -> Option<Structure> {
    match kind {
        Some(KindRaw::Chain) => chain(reader, raw, gravity_m_s2).map(|mut part| {
            lean_chain(reader, raw.as_surveyed.as_ref(), surveys, &mut part);
            Structure::Chain(Box::new(part))
        }),
        Some(KindRaw::Frame) => {
            let mut surveyed: Vec<String> = Vec::new();
            for direction in surveys.iter().flat_map(|survey| survey.modes.keys()) {
                if !surveyed.contains(direction) {
                    surveyed.push(direction.clone());
                }
            }
            frame(reader, raw, gravity_m_s2, &surveyed).map(|mut part| {
                lean_frame(reader, raw.as_surveyed.as_ref(), surveys, &mut part);
                Structure::Frame(part)
            })
        }
        Some(KindRaw::Stack) => stack(reader, raw, gravity_m_s2).map(|mut part| {
            lean(reader, raw.as_surveyed.as_ref(), surveys, &mut part);
            Structure::Stack(Box::new(part))
        }),
        Some(KindRaw::Building) => {
            building(reader, raw, gravity_m_s2).map(|part| Structure::Building(Box::new(part)))
        }
        Some(KindRaw::Survey) => Some(Structure::Survey),
        None => None,
    }
}

fn name(reader: &mut Reader, raw: At<NamesRaw>, path: &str) -> Option<Names> {
    let names = names(raw.value);
    let is_empty = |name: &Option<String>| name.as_deref().is_none_or(|name| name.trim().is_empty());
    if is_empty(&names.en) && is_empty(&names.ko) {
        let fault = Fault::new(raw.span, path, Common::IsEmpty(path.to_string()));
        reader.fault(fault.allowed(WrongFile::NeedsText).help(WrongFile::NameEnKoOr));
        return None;
    }
    Some(names)
}

fn warn_of_assumed(reader: &mut Reader, project: &Project) {
    let paths = |which: fn(&Quantity) -> bool| -> Vec<&str> {
        let inputs = project.inputs().into_iter();
        inputs
            .filter(|input| which(input))
            .map(|input| input.path.as_str())
            .collect()
    };
    let values = paths(Quantity::is_assumed);
    let scatter = paths(|input| input.is_scatter_assumed() && !input.is_assumed());
    for (paths, is_scatter) in [(values, false), (scatter, true)] {
        if let Some(first) = paths.first() {
            let listed = match paths.get(..PATHS_LISTED) {
                Some(some) if paths.len() > PATHS_LISTED + 1 => Common::AndMore {
                    some: some.join(", "),
                    count: paths.len() - PATHS_LISTED,
                }
                .into(),
                _ => Both::from(paths.join(", ")),
            };
            let warned = match is_scatter {
                false => Warned::Assumed { paths: listed },
                true => Warned::Scatter { paths: listed },
            };
            reader.warn(WarningKind::Assumed, first, warned);
        }
    }
}

/// Merges one variant into the file and reads the result again.
fn variant<'i>(
    source: (&str, &dyn Files),
    name: &str,
    patch: &Spanned<DeValue<'i>>,
    base: (&DeTable<'i>, &Range<usize>),
    faults: &mut Vec<Fault>,
) -> Option<Variant> {
    let path = format!("variant.{name}");
    let DeValue::Table(table) = patch.get_ref() else {
        let fault = Fault::new(patch.span(), &path, WrongFile::IsNotTable(path.to_string()));
        faults.push(
            fault
                .allowed(WrongFile::MustBeTable)
                .help(WrongFile::GiveVariantNameVariant),
        );
        return None;
    };
    let before = faults.len();
    let mut table = table.clone();
    let title = title(table.remove_entry("title"), &path, faults);
    for key in KEYS_OF_THE_FILE {
        if let Some((written, _)) = table.remove_entry(key) {
            let path = format!("{path}.{key}");
            let fault = Fault::new(
                written.span(),
                &path,
                WrongFile::VariantCannotChange {
                    name: name.to_string(),
                    key: key.to_string(),
                },
            );
            faults.push(
                fault
                    .allowed(WrongFile::HoldsForWholeFile)
                    .help(WrongFile::TakeItOutOrMake),
            );
        }
    }
    let (base, span) = base;
    let mut merged = base.clone();
    let mut own = merge(&mut merged, &table, "");
    let mut starts = BTreeSet::new();
    for value in base.iter().map(|(_, value)| value) {
        value_starts(value, &mut starts);
    }
    let project = read_one(source, (&mut merged, span), Some(starts), &mut own);
    for fault in own {
        // Faults of the file itself are already listed.
        if !faults[..before].contains(&fault) {
            faults.push(fault.in_variant(name));
        }
    }
    Some(Variant {
        name: name.to_owned(),
        title,
        project: project?,
    })
}

/// The start of a value and of all values within it.
pub(super) fn value_starts(node: &Spanned<DeValue<'_>>, starts: &mut BTreeSet<usize>) {
    starts.insert(node.span().start);
    match node.get_ref() {
        DeValue::Array(list) => list.iter().for_each(|value| value_starts(value, starts)),
        DeValue::Table(table) => table.iter().for_each(|(_, value)| value_starts(value, starts)),
        _ => {}
    }
}

fn title<'i>(
    written: Option<(Spanned<Cow<'i, str>>, Spanned<DeValue<'i>>)>,
    path: &str,
    faults: &mut Vec<Fault>,
) -> Option<Names> {
    let (_, node) = written?;
    let span = node.span();
    let read = NamesRaw::deserialize(toml::de::ValueDeserializer::from(node));
    match read {
        Ok(raw) => Some(names(raw)),
        Err(_) => {
            let path = format!("{path}.title");
            let fault = Fault::new(span, &path, WrongFile::IsNotName(path.to_string()));
            faults.push(fault.allowed(WrongFile::MustBeTextOr));
            None
        }
    }
}

impl Project {
    /// "chain", "frame", "stack" or "survey".
    pub fn kind(&self) -> &'static str {
        kind_word(match &self.structure {
            Structure::Chain(_) => KindRaw::Chain,
            Structure::Frame(_) => KindRaw::Frame,
            Structure::Stack(_) => KindRaw::Stack,
            Structure::Building(_) => KindRaw::Building,
            Structure::Survey => KindRaw::Survey,
        })
    }
}
