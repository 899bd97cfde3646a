//! One run of a study: the file with a variant and some replaced values, read again by the ordinary reader.

use super::check::Node;
use super::content::Project;
use super::error::{Fault, ProjectError};
use super::merge::merge;
use super::paths::keys;
use super::placed::place;
use super::read::{read_one, value_starts};
use super::study::Override;
use super::syntax::of_toml;
use super::tabled_modes::beside_the_file;
use super::wrong::WrongFile;
use dolmen_records::Files;
use std::borrow::Cow;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Reads a project file after merging a variant and then `overrides` into it; the result has no variants and no studies.
///
/// # Errors
/// [`ProjectError`] with every problem found: those of overrides have the place of the study that gives them.
///
/// # Example
/// ```
/// use dolmen_project::{NoFiles, Structure, parse_combination, parse_project};
/// let text = r#"
/// schema = 1
/// kind = "stack"
/// name = "Pagoda"
/// density = 2600
/// pagoda = { storeys = 3, body_height = 3.0 }
/// [study.height]
/// vary = { "pagoda.storeys" = [3, 5, 14] }
/// motions = ["el-centro-1940-ns"]
/// scale = [1]
/// "#;
/// let study = &parse_project(text, "p.toml")?.studies[0];
/// let (variant, values) = study.combination(1);
/// let changed = parse_combination(text, "p.toml", &NoFiles, variant, &values)?;
/// let Structure::Stack(stack) = &changed.structure else { unreachable!() };
/// assert_eq!(stack.pagoda.as_ref().map(|pagoda| pagoda.storeys), Some(5));
/// let (variant, values) = study.combination(2);
/// let refused = parse_combination(text, "p.toml", &NoFiles, variant, &values).unwrap_err();
/// assert!(refused.to_string().contains("must be 1 to 13") && refused.problems[0].line == 8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn parse_combination(
    text: &str,
    file: &str,
    files: &dyn Files,
    variant: Option<&str>,
    overrides: &[&Override],
) -> Result<Project, ProjectError> {
    combined(text, files, variant, overrides).map_err(|faults| ProjectError::of(faults, file, text))
}

fn combined(
    text: &str,
    files: &dyn Files,
    variant: Option<&str>,
    overrides: &[&Override],
) -> Result<Project, Vec<Fault>> {
    let lists = beside_the_file(text, files)?;
    let (root, syntax) = DeTable::parse_recoverable(text);
    if !syntax.is_empty() {
        return Err(syntax.iter().map(|error| of_toml(error, text)).collect());
    }
    let span = root.span();
    let mut root = root.into_inner();
    lists.iter().for_each(|list| list.put(&mut root));
    root.remove("study");
    root.remove("report");
    root.remove("names");
    let variants = root.remove("variant");
    let mut starts = BTreeSet::new();
    for value in root.iter().map(|(_, value)| value) {
        value_starts(value, &mut starts);
    }
    let mut faults = Vec::new();
    if let Some(name) = variant {
        let table = variants
            .as_ref()
            .and_then(|all| all.get_ref().as_table()?.get(name));
        match table.and_then(|table| table.get_ref().as_table()) {
            Some(patch) => {
                let mut patch = patch.clone();
                patch.remove("title");
                faults.extend(merge(&mut root, &patch, ""));
            }
            None => faults.push(Fault::new(
                0..0,
                "variant",
                WrongFile::ThereIsNoVariant(name.to_string()),
            )),
        }
    }
    for given in overrides {
        match patch(given) {
            Some(patch) => faults.extend(merge(&mut root, &patch, "")),
            None => faults.push(not_a_path(given)),
        }
    }
    match read_one((text, files), (&mut root, &span), Some(starts), &mut faults) {
        Some(mut project) if faults.is_empty() => {
            project
                .warnings
                .extend(lists.iter().flat_map(|list| list.warnings(text)));
            Ok(project)
        }
        _ => Err(faults),
    }
}

fn not_a_path(given: &Override) -> Fault {
    let message = WrongFile::IsNoPathOf {
        path: given.path.to_string(),
        text: given.text.to_string(),
    };
    Fault::new(given.span.clone(), &given.path, message).help(WrongFile::WriteItAsJoint)
}

/// The value of an override at the end of its path, as a table to merge into the file; every part has the place in the study that gives it.
fn patch<'i>(given: &'i Override) -> Option<DeTable<'i>> {
    let mut value = DeValue::parse(&given.text).ok()?;
    place(&mut value, &given.span);
    let mut keys = keys(&given.path)?;
    let first = keys.remove(0);
    let at = |value: DeValue<'i>| Spanned::new(given.span.clone(), value);
    let key = |name: &'i str| Spanned::new(given.span.clone(), Cow::Borrowed(name));
    let mut inner = value;
    for name in keys.into_iter().rev() {
        let mut table = DeTable::new();
        table.insert(key(name), inner);
        inner = at(DeValue::Table(table));
    }
    let mut table = DeTable::new();
    table.insert(key(first), inner);
    Some(table)
}

/// Keys of a study that do not affect the runs, only their evaluation.
const OF_THE_ANSWER: [&str; 4] = ["title", "expect", "spectral_periods_s", "spectral_damping_ratio"];

/// Keys of a motion that do not affect the runs.
const OF_THE_EARTHQUAKE: [&str; 2] = ["magnitude", "distance_km"];

/// All parts of a project file that affect the runs of a study, in one order: the file without comments, surveys, report, other studies, variants
/// that the study does not name, and keys for the evaluation of the runs.
///
/// # Errors
/// [`ProjectError`] if it is no TOML.
///
/// # Example
/// ```
/// use dolmen_project::canonical_text;
/// let of = |text: &str| canonical_text(text, "p.toml", "a");
/// let first = of("x = 1 # one\n[study.a]\ny = [2]\n[study.b]\nz = 3\n")?;
/// assert_eq!(first, of("# again\nx = 1\n[study.a]\ny = [ 2 ]\n")?);
/// assert_eq!(first, of("x = 1\n[study.a]\ny = [2]\ntitle = 'A'\n")?);
/// let motion = of("x = 1\nmotion.m = { scale = 2 }\n[study.a]\ny = [2]\n")?;
/// assert_eq!(motion, of("x = 1\nmotion.m = { scale = 2, magnitude = 6.5 }\n[study.a]\ny = [2]\n")?);
/// assert_ne!(first, of("x = 1\n[study.a]\ny = [3]\n")?);
/// assert_eq!(first, of("x = 1\n[study.a]\ny = [2]\n[variant.v]\nx = 2\n")?);
/// # Ok::<(), dolmen_project::ProjectError>(())
/// ```
pub fn canonical_text(text: &str, file: &str, study: &str) -> Result<String, ProjectError> {
    let (root, syntax) = DeTable::parse_recoverable(text);
    if !syntax.is_empty() {
        let faults = syntax.iter().map(|error| of_toml(error, text));
        return Err(ProjectError::of(faults.collect(), file, text));
    }
    let mut root = root.into_inner();
    root.remove("survey");
    root.remove("report");
    root.remove("names");
    if let Some(DeValue::Table(motions)) = root.get_mut("motion").map(Spanned::get_mut) {
        for (_, motion) in motions.iter_mut() {
            if let DeValue::Table(motion) = motion.get_mut() {
                OF_THE_EARTHQUAKE.iter().for_each(|key| drop(motion.remove(*key)));
            }
        }
    }
    let mut out = String::new();
    let mut studies = root.remove("study");
    let own = match studies.as_mut().map(Spanned::get_mut) {
        Some(DeValue::Table(all)) => all.get_mut(study),
        _ => None,
    };
    let used = own.as_deref().map(variants_of).unwrap_or_default();
    if let Some(DeValue::Table(variants)) = root.get_mut("variant").map(Spanned::get_mut) {
        let unused = variants.iter().map(|(name, _)| name.get_ref().to_string());
        let unused: Vec<String> = unused.filter(|name| !used.contains(name)).collect();
        for name in unused {
            variants.remove(name.as_str());
        }
        if variants.is_empty() {
            root.remove("variant");
        }
    }
    table_text(&root, &mut out);
    if let Some(DeValue::Table(own)) = own.map(Spanned::get_mut) {
        for key in OF_THE_ANSWER {
            own.remove(key);
        }
        table_text(own, &mut out);
    }
    Ok(out)
}

/// The variants of a study.
fn variants_of(study: &Node<'_>) -> Vec<String> {
    let listed = study.get_ref().as_table().and_then(|study| study.get("variants"));
    match listed.map(Spanned::get_ref) {
        Some(DeValue::Array(list)) => {
            let names = list.iter().filter_map(|name| name.get_ref().as_str());
            names.map(str::to_owned).collect()
        }
        _ => Vec::new(),
    }
}

fn table_text(table: &DeTable<'_>, out: &mut String) {
    let mut keys: Vec<_> = table.iter().collect();
    keys.sort_by(|a, b| a.0.get_ref().cmp(b.0.get_ref()));
    for (key, value) in keys {
        let _ = write!(out, "{:?}=", key.get_ref()); // into a String: cannot fail
        value_text(value.get_ref(), out);
        out.push('\n');
    }
}

fn value_text(value: &DeValue<'_>, out: &mut String) {
    let _ = match value {
        DeValue::String(text) => write!(out, "{text:?}"),
        DeValue::Integer(number) => write!(out, "{number}"),
        DeValue::Float(number) => write!(out, "{number}"),
        DeValue::Boolean(is) => write!(out, "{is}"),
        DeValue::Datetime(date) => write!(out, "{date}"),
        DeValue::Array(list) => {
            out.push('[');
            for value in list.iter() {
                value_text(value.get_ref(), out);
                out.push(',');
            }
            out.push(']');
            Ok(())
        }
        DeValue::Table(table) => {
            out.push('{');
            table_text(table, out);
            out.push('}');
            Ok(())
        }
    }; // into a String: cannot fail
}
