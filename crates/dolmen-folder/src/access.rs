//! What may be read and replaced.

/// How far the files of a project are trusted, and what may be replaced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Access {
    /// Whether a project may name files outside its folder; default no.
    pub allow_outside: bool,
    /// Most bytes that are read of any file; the limit of its kind if `None`.
    pub largest_file: Option<u64>,
    /// Whether files that Dolmen did not write are replaced; those that are read never are. Default no.
    pub force: bool,
}

impl Access {
    /// Most bytes that are read of a file whose kind allows `of_the_kind`.
    pub fn most(&self, of_the_kind: u64) -> u64 {
        self.largest_file.unwrap_or(of_the_kind)
    }
}
