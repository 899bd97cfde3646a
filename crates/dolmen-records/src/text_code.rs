//! Converts the text of a file to UTF-8 from either of the two encodings of Korean programs.

use encoding_rs::EUC_KR;
use std::borrow::Cow;

/// The bytes of a text file, and their original encoding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Decoded<'a> {
    /// UTF-8 if the encoding was detected, otherwise the original bytes.
    pub(crate) bytes: Cow<'a, [u8]>,
    /// Whether the file was in CP949, of which EUC-KR is a part.
    pub(crate) is_cp949: bool,
}

/// Bytes that are not UTF-8, converted if they are Korean text in CP949 (EUC-KR) throughout. No other encoding is guessed: every byte must
/// belong to a character of that encoding, and most characters beyond ASCII must be among the 2,350 common Korean syllables. Single letters of a
/// Western code page ("m/s²", "Höhe") do not pass.
///
/// # Source
/// WHATWG Encoding Standard, euc-kr (the Windows code page 949); KS X 1001:2004, rows 16 to 40.
pub(crate) fn decoded(bytes: &[u8]) -> Decoded<'_> {
    let as_it_is = Decoded {
        bytes: Cow::Borrowed(bytes),
        is_cp949: false,
    };
    if std::str::from_utf8(bytes).is_ok() {
        return as_it_is;
    }
    match EUC_KR.decode_without_bom_handling_and_without_replacement(bytes) {
        Some(text) if is_korean(bytes) => Decoded {
            bytes: Cow::Owned(text.into_owned().into_bytes()),
            is_cp949: true,
        },
        _ => as_it_is,
    }
}

/// The bytes of a text file as UTF-8 if they are Korean text in CP949 (EUC-KR) throughout; otherwise unchanged.
pub fn utf8(bytes: &[u8]) -> Cow<'_, [u8]> {
    decoded(bytes).bytes
}

/// Whether more than half of the characters of two bytes are syllables of KS X 1001; the text is in CP949 throughout.
fn is_korean(bytes: &[u8]) -> bool {
    let (mut syllables, mut others) = (0_usize, 0_usize);
    let mut rest = bytes.iter();
    while let Some(lead) = rest.next() {
        if lead.is_ascii() {
            continue;
        }
        let trail = rest.next().copied().unwrap_or_default();
        match (0xb0..=0xc8).contains(lead) && trail >= 0xa1 {
            true => syllables += 1,
            false => others += 1,
        }
    }
    syllables > others
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_python_on_korean_text_and_leaves_other_bytes_alone() {
        // "측정시각,1층 가속도(㎨)".encode("cp949") of Python 3.11
        let korean = b"\xc3\xf8\xc1\xa4\xbd\xc3\xb0\xa2,1\xc3\xfe \xb0\xa1\xbc\xd3\xb5\xb5(\xa7\xbe)";
        let turned = decoded(korean);
        assert_eq!(&*turned.bytes, "측정시각,1층 가속도(㎨)".as_bytes());
        assert!(turned.is_cp949);
        // "똠방각하,1" : the first syllable is not among those of KS X 1001
        let extended = decoded(b"\x8c\x63\xb9\xe6\xb0\xa2\xc7\xcf,1");
        assert_eq!(&*extended.bytes, "똠방각하,1".as_bytes());
        // Windows-1252: "Höhe (m/s²)", "µg", "Größe;Länge"; bytes of no text; half a character at the end
        for bytes in [
            b"H\xf6he (m/s\xb2)".as_slice(),
            b"a [\xb5g]",
            b"Gr\xf6\xdfe;L\xe4nge",
            b"\x00\xff\xfe\x80",
            b"\xb0\xa1\xb0",
            "측정,1".as_bytes(),
        ] {
            let kept = decoded(bytes);
            assert_eq!((&*kept.bytes, kept.is_cp949), (bytes, false));
        }
    }
}
