//! Opens input files with a clear error, and writes results completely or not at all.

use crate::wrong::{Lying, PathError};
use anyhow::Result;
use dolmen_records::FileError;
use dolmen_words::{composed, nearest, said_by_system};
use std::fs;
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The project file that `path` means: itself, or `project.toml` in the folder it names.
pub(crate) fn project_file(path: &Path) -> Result<PathBuf> {
    if path.is_dir() {
        let file = path.join("project.toml");
        if !file.is_file() {
            let shown = path.display().to_string();
            return Err(match likely_project(path) {
                Some(near) => PathError::OtherName { path: shown, near },
                None => PathError::NoProject { path: shown },
            }
            .into());
        }
        return Ok(file);
    }
    if !path.exists() {
        let shown = path.display().to_string();
        return Err(match likely_path(path) {
            Some(near) => PathError::NotThereNear { path: shown, near },
            None => PathError::NotThere { path: shown },
        }
        .into());
    }
    Ok(path.to_owned())
}

/// The file in a folder that is probably its project: Project.toml, project.toml.txt, or the only TOML file.
pub(crate) fn likely_project(folder: &Path) -> Option<String> {
    let mut names = beside(&folder.join("project.toml"));
    names.retain(|name| folder.join(name).is_file());
    names.sort();
    let is_project = |name: &&String| {
        let name = name.to_lowercase();
        name == "project.toml" || name.starts_with("project.toml.") && !name.ends_with('~')
    };
    let is_toml = |name: &&String| {
        let name = name.to_lowercase();
        name.ends_with(".toml") || name.ends_with(".toml.txt")
    };
    let mut tomls = names.iter().filter(is_toml);
    let only = tomls.next().filter(|_| tomls.next().is_none());
    names.iter().find(is_project).or(only).cloned()
}

/// A folder or TOML file whose name is similar to that of a missing path.
fn likely_path(path: &Path) -> Option<String> {
    let name = path.file_name()?.to_string_lossy().into_owned();
    let mut names = beside(path);
    names.retain(|name| {
        let near = path.with_file_name(name);
        near.is_dir()
            || near
                .extension()
                .is_some_and(|ending| ending.eq_ignore_ascii_case("toml"))
    });
    names.sort();
    let near = nearest(&name, names.iter().map(String::as_str))?;
    Some(path.with_file_name(near).display().to_string())
}

/// What exists instead of a regular file; `None` for a regular file.
fn not_a_file(there: &fs::Metadata) -> Option<Lying> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt as _;
        let kind = there.file_type();
        if kind.is_fifo() || kind.is_socket() {
            return Some(Lying::Pipe);
        }
        if kind.is_char_device() || kind.is_block_device() {
            return Some(Lying::Device);
        }
    }
    match there {
        there if there.is_dir() => Some(Lying::Folder),
        there if there.is_file() => None,
        _ => Some(Lying::NoRegularFile),
    }
}

/// Names of the files in the same folder.
fn beside(path: &Path) -> Vec<String> {
    let folder = folder_of(path);
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries
        .filter_map(|entry| entry.file_name().into_string().ok())
        .collect()
}

/// An existing file whose name differs only in Unicode normalization: macOS decomposes Hangul (NFD), Windows and Linux do not (NFC).
fn composed_alike(path: &Path) -> Option<PathBuf> {
    let wanted = composed(path.file_name()?.to_str()?);
    let found = beside(path).into_iter().find(|name| composed(name) == wanted)?;
    Some(path.with_file_name(found))
}

/// Whether a missing path exists with another Unicode normalization.
pub(crate) fn is_composed_otherwise(path: &Path) -> bool {
    !path.exists() && composed_alike(path).is_some()
}

fn absent(path: &Path) -> FileError {
    let shown = path.display().to_string();
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned());
    let (name, beside) = (name.unwrap_or_default(), beside(path));
    if name.contains('\\') {
        let slashes = name.replace('\\', "/");
        return FileError::Backslash { shown, slashes };
    }
    match nearest(&name, beside.iter().map(String::as_str)) {
        Some(near) => FileError::Misspelt {
            shown,
            near: near.to_owned(),
        },
        None => FileError::Absent { shown },
    }
}

/// All bytes of a regular file of limited size. Finds a name in either Unicode normalization (NFC, NFD).
pub fn read(path: &Path, most: u64) -> Result<Vec<u8>, FileError> {
    let shown = || path.display().to_string();
    let unreadable = |why: std::io::Error| FileError::Unreadable {
        shown: shown(),
        why: said_by_system(&why),
    };
    let (found, there) = match fs::metadata(path) {
        Ok(there) => (path.to_owned(), there),
        Err(why) if why.kind() == std::io::ErrorKind::NotFound => {
            let found = composed_alike(path).ok_or_else(|| absent(path))?;
            let there = fs::metadata(&found).map_err(unreadable)?;
            (found, there)
        }
        Err(why) => return Err(unreadable(why)),
    };
    // before opening it: opening a pipe waits for a writer
    if let Some(what) = not_a_file(&there) {
        return Err(FileError::NotAFile {
            shown: shown(),
            what: what.into(),
        });
    }
    let file = fs::File::open(found).map_err(unreadable)?;
    let bytes = file.metadata().map_err(unreadable)?.len();
    let too_large = |bytes: u64| FileError::TooLarge {
        shown: shown(),
        bytes,
        most,
    };
    if bytes > most {
        return Err(too_large(bytes));
    }
    let mut read = Vec::with_capacity(bytes as usize);
    file.take(most.saturating_add(1))
        .read_to_end(&mut read)
        .map_err(unreadable)?;
    match read.len() as u64 {
        bytes if bytes > most => Err(too_large(bytes)),
        _ => Ok(read),
    }
}

/// The first bytes of a regular file, enough to recognise its format; empty if it cannot be read.
pub fn start(path: &Path) -> Vec<u8> {
    const LOOKED_AT: u64 = 1000;
    let mut start = Vec::new();
    if fs::metadata(path).is_ok_and(|there| there.is_file()) {
        let file = fs::File::open(path);
        let _ = file.and_then(|file| file.take(LOOKED_AT).read_to_end(&mut start)); // keeps what was read before a fault
    }
    start
}

/// The text of a file, which must be UTF-8.
pub fn read_text(path: &Path, most: u64) -> Result<String> {
    text_of(read(path, most)?, path)
}

/// The whole lines of a text that may end within a letter, as a killed process leaves it.
pub(crate) fn read_whole_lines(path: &Path, most: u64) -> Result<String> {
    let mut bytes = read(path, most)?;
    let whole = bytes.iter().rposition(|byte| *byte == b'\n');
    bytes.truncate(whole.map_or(0, |at| at + 1));
    text_of(bytes, path)
}

fn text_of(bytes: Vec<u8>, path: &Path) -> Result<String> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        let path = path.display().to_string();
        return Err(PathError::Utf16 { path }.into());
    }
    String::from_utf8(bytes).map_err(|fault| {
        let at = fault.utf8_error().valid_up_to();
        PathError::NotUtf8 {
            path: path.display().to_string(),
            at,
        }
        .into()
    })
}

/// Replaces the bytes of an existing file, completely or not at all; keeps its permissions.
///
/// # Errors
/// As [`write()`], and if the file is read-only.
pub fn rewrite(path: &Path, bytes: &[u8]) -> Result<()> {
    let failed = |why: std::io::Error| {
        anyhow::Error::new(PathError::CannotWrite {
            path: path.display().to_string(),
            why,
        })
    };
    let kept = fs::metadata(path).map_err(failed)?.permissions();
    if kept.readonly() {
        return Err(failed(std::io::ErrorKind::PermissionDenied.into()));
    }
    write(path, bytes)?;
    fs::set_permissions(path, kept).map_err(failed)
}

/// Writes `bytes` to `path` completely or not at all: to a temporary file in the same folder, which is then renamed. Follows a link;
/// writes directly to a device or pipe.
pub fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    let failed = |why: std::io::Error| {
        let path = path.display().to_string();
        anyhow::Error::new(match why.kind() {
            std::io::ErrorKind::FileTooLarge => PathError::TooLargeToWrite {
                path,
                bytes: bytes.len(),
                why,
            },
            _ => PathError::CannotWrite { path, why },
        })
    };
    if fs::metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir()) {
        let opened = fs::OpenOptions::new().write(true).open(path);
        let written = opened.and_then(|mut file| file.write_all(bytes).and_then(|()| file.flush()));
        return written.map_err(failed);
    }
    let target = match path.is_symlink() {
        true => path.canonicalize().map_err(|why| PathError::LinkToNothing {
            path: path.display().to_string(),
            why,
        })?,
        false => path.to_owned(),
    };
    let folder = folder_of(&target);
    fs::create_dir_all(folder).map_err(|why| cannot_make(folder, why))?;
    // retry: another process may take our temporary file for one left behind, and remove it
    let mut written = part_then_rename(folder, &target, bytes);
    for _ in 0..TRIES {
        match &written {
            Err(fault) if fault.kind() == std::io::ErrorKind::NotFound => {
                written = part_then_rename(folder, &target, bytes);
            }
            _ => break,
        }
    }
    written.map_err(failed)
}

/// The folder of a file.
pub(crate) fn folder_of(file: &Path) -> &Path {
    let folder = file.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder.unwrap_or(Path::new("."))
}

/// Beginning and end of the name of a temporary file, which is hidden and contains the process and a number.
const PART: (&str, &str) = (".dolmen-", ".part");
/// Number of retries after another process removed the temporary file.
const TRIES: usize = 20;
/// Number of temporary files of this process.
static PARTS: AtomicUsize = AtomicUsize::new(0);

fn part_then_rename(folder: &Path, target: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let number = PARTS.fetch_add(1, Ordering::Relaxed);
    let part = folder.join(format!("{}{}-{number}{}", PART.0, std::process::id(), PART.1));
    let written = fs::File::create(&part).and_then(|mut file| {
        // locked until the rename, so that another process does not remove it
        let _ = file.try_lock(); // some file systems have no locks
        file.write_all(bytes)?;
        file.sync_all()?;
        fs::rename(&part, target)
    });
    if written.is_err() {
        let _ = fs::remove_file(&part); // remove it if it exists
    }
    written
}

/// Removes temporary files of killed processes from a folder.
pub(crate) fn clear_parts(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if !name.starts_with(PART.0) || !name.ends_with(PART.1) {
            continue;
        }
        let abandoned = fs::File::open(entry.path()).is_ok_and(|file| file.try_lock().is_ok());
        if abandoned {
            let _ = fs::remove_file(entry.path()); // a file that cannot be removed does no harm
        }
    }
}

/// The error of a folder that cannot be created.
pub(crate) fn cannot_make(folder: &Path, why: std::io::Error) -> PathError {
    PathError::CannotMake {
        path: folder.display().to_string(),
        why,
    }
}

/// Creates the folder `path`; refuses one that is not empty, so that nothing is overwritten.
pub fn fresh_folder(path: &Path) -> Result<()> {
    if path.exists() && !path.is_dir() {
        return Err(PathError::IsFile {
            path: path.display().to_string(),
        }
        .into());
    }
    if path.is_dir() && fs::read_dir(path)?.next().is_some() {
        return Err(PathError::NotEmpty {
            path: path.display().to_string(),
        }
        .into());
    }
    Ok(fs::create_dir_all(path).map_err(|why| cannot_make(path, why))?)
}

/// Creates the folder `path` with these files, or changes nothing.
pub fn fill_fresh(path: &Path, files: &[(&str, &[u8])]) -> Result<()> {
    let was_there = path.is_dir();
    match is_begun(path, files) {
        true => clear_parts(path),
        false => fresh_folder(path)?,
    }
    let filled = files
        .iter()
        .try_for_each(|(name, bytes)| write(&path.join(name), bytes));
    if filled.is_err() {
        for (name, _) in files {
            let _ = fs::remove_file(path.join(name)); // some do not exist yet
        }
        if !was_there {
            let _ = fs::remove_dir(path); // stays if something else was put into it
        }
    }
    filled
}

/// Whether a folder contains only some of these files, as a killed process leaves it.
fn is_begun(path: &Path, files: &[(&str, &[u8])]) -> bool {
    let Ok(entries) = fs::read_dir(path) else {
        return false;
    };
    let names: Vec<String> = entries
        .map(|entry| {
            entry.map_or_else(
                |_| String::new(),
                |of| of.file_name().to_string_lossy().into_owned(),
            )
        })
        .filter(|name| !(name.starts_with(PART.0) && name.ends_with(PART.1)))
        .collect();
    let is_ours = |name: &String| {
        let of_name = files.iter().find(|(own, _)| own == name);
        of_name.is_some_and(|(_, bytes)| fs::read(path.join(name)).is_ok_and(|found| found == *bytes))
    };
    names.len() < files.len() && names.iter().all(is_ours)
}

/// Creates the folder `wanted`, or the first free one of "NAME-2", "NAME-3"…; nothing is overwritten.
pub fn free_folder(wanted: &Path) -> Result<PathBuf> {
    let name = wanted
        .file_name()
        .map(|n| n.to_string_lossy().into_owned())
        .unwrap_or_default();
    let mut folder = wanted.to_owned();
    let mut number = 1;
    while folder.exists() {
        number += 1;
        folder = wanted.with_file_name(format!("{name}-{number}"));
    }
    fresh_folder(&folder)?;
    Ok(folder)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scratch(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("dolmen-files-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    #[test]
    fn holds_a_text_torn_within_a_letter_keeps_its_whole_lines() {
        let file = scratch("torn").join("runs");
        let text = "하나\n둘";
        for torn in 0..3 {
            fs::write(&file, &text.as_bytes()[..text.len() - torn]).unwrap();
            assert_eq!(read_whole_lines(&file, 100).unwrap(), "하나\n");
        }
    }

    #[test]
    fn holds_a_failed_write_leaves_the_old_file_and_no_part() {
        let folder = scratch("write");
        let file = folder.join("report.html");
        write(&file, b"old").unwrap();
        let taken = folder.join("taken");
        fs::create_dir_all(taken.join("full")).unwrap();
        assert!(
            write(&taken, b"new").is_err(),
            "a folder that is not empty cannot be replaced by a file"
        );
        write(&file, b"new").unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"new");
        let names: Vec<_> = fs::read_dir(&folder)
            .unwrap()
            .map(|e| e.unwrap().file_name())
            .collect();
        assert_eq!(names.len(), 2, "{names:?}");
        fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn holds_a_device_is_written_to_and_stays_one() {
        use std::os::unix::fs::FileTypeExt as _;
        let full = Path::new("/dev/full");
        if !full.exists() {
            return; // not every system has it
        }
        // through a link, so that the device itself cannot be replaced
        let folder = scratch("device");
        let link = folder.join("report.html");
        std::os::unix::fs::symlink(full, &link).unwrap();
        let fault = write(&link, b"new").unwrap_err();
        assert!(fault.to_string().contains("cannot write"), "{fault}");
        let there = fs::metadata(&link).unwrap().file_type();
        assert!(there.is_char_device() && fs::symlink_metadata(&link).unwrap().is_symlink());
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn refuses_a_folder_without_a_project_and_says_how_to_start_one() {
        let folder = scratch("empty");
        let message = project_file(&folder).unwrap_err().to_string();
        assert!(message.contains("holds no project.toml"), "{message}");
        let message = fresh_folder(folder.parent().unwrap()).unwrap_err().to_string();
        assert!(message.contains("is not empty"), "{message}");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn refuses_text_that_is_not_utf8() {
        let folder = scratch("text");
        let file = folder.join("project.toml");
        fs::write(&file, b"name = \"\xb3\xaa\xc1\xd6\"").unwrap();
        let message = read_text(&file, 100).unwrap_err().to_string();
        assert!(message.contains("is not UTF-8 text (byte 8)"), "{message}");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn holds_a_link_is_written_through_and_one_to_nothing_refused() {
        let folder = scratch("link");
        let (real, link, loose) = (
            folder.join("real.csv"),
            folder.join("link.csv"),
            folder.join("loose"),
        );
        fs::write(&real, b"old").unwrap();
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(&real, &link).unwrap();
            std::os::unix::fs::symlink(folder.join("nowhere"), &loose).unwrap();
            write(&link, b"new").unwrap();
            assert!(link.is_symlink() && fs::read(&real).unwrap() == b"new");
            assert!(
                write(&loose, b"new")
                    .unwrap_err()
                    .to_string()
                    .contains("a link to nothing")
            );
        }
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn holds_parts_that_a_killed_process_left_are_cleared_and_those_in_the_making_stay() {
        let folder = scratch("parts");
        let (left, made) = (folder.join(".dolmen-1-0.part"), folder.join(".dolmen-2-0.part"));
        let other = folder.join(".other-1-0.part");
        for path in [&left, &made, &other] {
            fs::write(path, b"half").unwrap();
        }
        let held = fs::File::open(&made).unwrap();
        held.try_lock().unwrap();
        clear_parts(&folder);
        assert!(!left.exists() && made.exists() && other.exists());
        drop(held);
        fs::remove_dir_all(folder).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn refuses_what_is_no_regular_file_and_what_is_too_large() {
        let folder = scratch("kinds");
        let told = |path: &Path, most| read(path, most).unwrap_err().to_string();
        assert!(told(&folder, 9).contains("is a folder, but only regular files"));
        assert!(told(Path::new("/dev/zero"), 9).contains("is a device, but only regular files"));
        let pipe = folder.join("pipe");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        if made.is_ok_and(|status| status.success()) {
            assert!(told(&pipe, 9).contains("is a pipe, but only regular files"));
        }
        let large = folder.join("large");
        fs::write(&large, b"0123456789").unwrap();
        assert!(told(&large, 9).contains("holds 10 bytes, but at most 9 are read"));
        assert_eq!(read(&large, 10).unwrap().len(), 10);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn holds_a_folder_that_cannot_be_filled_is_taken_away_again() {
        let folder = scratch("fresh");
        let new = folder.join("new");
        let files: [(&str, &[u8]); 2] = [("project.toml", b"a"), ("project.toml/x", b"b")];
        assert!(fill_fresh(&new, &files).is_err(), "a file is no folder");
        assert!(!new.exists());
        fill_fresh(&new, &files[..1]).unwrap();
        assert!(new.join("project.toml").is_file());
        fs::remove_dir_all(folder).unwrap();
    }
}
