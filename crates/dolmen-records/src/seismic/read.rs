//! Any seismic file: what begins with a mark is told by it, alphanumeric SAC by its rows.

use super::{Raw, SeismicError, at2, cosmos, csmip, esm, knet, miniseed, sac};

/// The numbers of each channel of a file that vibration records and ground motions come in; `None` if it is none.
pub(crate) fn raw_channels(bytes: &[u8]) -> Option<Result<Vec<Raw>, SeismicError>> {
    if miniseed::is_miniseed(bytes) {
        Some(miniseed::read(bytes))
    } else if sac::is_binary(bytes) {
        Some(sac::read_binary(bytes))
    } else if knet::is_knet(bytes) {
        Some(knet::read(bytes))
    } else if cosmos::is_cosmos(bytes) {
        Some(cosmos::read(bytes))
    } else if csmip::is_csmip(bytes) {
        Some(csmip::read(bytes))
    } else if esm::is_esm(bytes) {
        Some(esm::read(bytes))
    } else {
        None
    }
}

/// The numbers of each channel of a file of a ground motion, whole; `None` if it is none, or text in columns.
pub(crate) fn motion_channels(bytes: &[u8], unit_is_given: bool) -> Option<Result<Vec<Raw>, SeismicError>> {
    if let Some(read) = raw_channels(bytes) {
        Some(read.and_then(miniseed::whole))
    } else if sac::is_alphanumeric(bytes) {
        Some(sac::read_alphanumeric(bytes))
    } else if at2::is_at2(bytes) {
        Some(at2::read(bytes, unit_is_given))
    } else {
        None
    }
}
