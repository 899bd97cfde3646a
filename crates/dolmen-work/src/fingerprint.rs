//! Fingerprints of texts that determine results.

/// FNV-1a over 128 bits, as 32 hexadecimal digits: distinguishes inputs; not for secrets.
///
/// # Source
/// Fowler, G., Noll, L. C., Vo, K.-P. and Eastlake, D., The FNV non-cryptographic hash algorithm, IETF draft-eastlake-fnv.
///
/// # Example
/// ```
/// assert_eq!(dolmen_work::study::fingerprint(b""), "6c62272e07bb014262b821756295c58d");
/// assert_eq!(dolmen_work::study::fingerprint(b"a"), "d228cb696f1a8caf78912b704e4a8964");
/// ```
pub fn fingerprint(bytes: &[u8]) -> String {
    const PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013b;
    const BASIS: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    let hash = bytes
        .iter()
        .fold(BASIS, |hash, &byte| (hash ^ u128::from(byte)).wrapping_mul(PRIME));
    format!("{hash:032x}")
}
