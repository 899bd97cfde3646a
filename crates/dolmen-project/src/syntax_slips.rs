//! Slips that the TOML reader reports late or without useful words: a missing comma or bracket, full-width signs and blanks. The first slip
//! is the real one; later messages of the reader follow from it.

use super::error::Fault;
use super::wrong::WrongToml;
use std::ops::Range;

/// A piece of text between blanks, outside comments.
#[derive(Clone, Debug, PartialEq)]
enum Token {
    /// An opening bracket or brace.
    Open(char),
    /// A closing one.
    Close(char),
    Comma,
    Equals,
    /// A string, or a run of other characters.
    Word,
}

#[derive(Clone, Debug, PartialEq)]
struct Placed {
    token: Token,
    span: Range<usize>,
    /// Whether it is the first token of its line.
    starts_line: bool,
}

/// The tokens that may follow within brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Next {
    Key,
    Value,
    /// A comma, or the end.
    Comma,
}

/// An open list or inline table.
#[derive(Clone, Debug)]
struct Open {
    sign: char,
    at: usize,
    /// The key whose value it is, or belongs to.
    key: String,
    next: Next,
}

/// The first slip in a text that is not TOML; `None` for another fault.
pub(super) fn slip(text: &str) -> Option<Fault> {
    let tokens = tokens(text);
    wide_signs(text, &tokens).or_else(|| brackets(text, &tokens))
}

/// The tokens up to an unclosed string.
fn tokens(text: &str) -> Vec<Placed> {
    let mut all: Vec<Placed> = Vec::new();
    // a byte order mark before the first line, as some editors save it, belongs to no token
    let mut at = text.len() - text.trim_start_matches('\u{feff}').len();
    let mut starts_line = true;
    while let Some(sign) = text[at..].chars().next() {
        let rest = &text[at..];
        let (token, length) = match sign {
            '\n' => {
                (starts_line, at) = (true, at + 1);
                continue;
            }
            ' ' | '\t' | '\r' => {
                at += 1;
                continue;
            }
            '#' => {
                at += rest.find('\n').unwrap_or(rest.len());
                continue;
            }
            '"' | '\'' => match string_length(rest, sign) {
                Some(length) => (Token::Word, length),
                None => return all,
            },
            '[' | '{' => (Token::Open(sign), 1),
            ']' | '}' => (Token::Close(sign), 1),
            ',' => (Token::Comma, 1),
            '=' => (Token::Equals, 1),
            _ => {
                let ends = |sign: char| {
                    matches!(
                        sign,
                        ' ' | '\t' | '\r' | '\n' | '#' | '"' | '\'' | '[' | ']' | '{' | '}' | ',' | '='
                    )
                };
                (Token::Word, rest.find(ends).unwrap_or(rest.len()))
            }
        };
        let span = at..at + length;
        at = span.end;
        all.push(Placed {
            token,
            span,
            starts_line: std::mem::take(&mut starts_line),
        });
    }
    all
}

/// The bytes of a string that begins here, with its quotes; `None` if it is not closed.
fn string_length(rest: &str, quote: char) -> Option<usize> {
    let triple: String = [quote; 3].iter().collect();
    let (mark, is_long) = match rest.starts_with(&triple) {
        true => (triple.as_str(), true),
        false => (&triple[..1], false),
    };
    let mut at = mark.len();
    loop {
        let left = rest.get(at..)?;
        let sign = left.chars().next()?;
        match sign {
            '\n' if !is_long => return None,
            '\\' if quote == '"' => at += 1 + left[1..].chars().next()?.len_utf8(),
            _ if left.starts_with(mark) => return Some(at + mark.len()),
            _ => at += sign.len_utf8(),
        }
    }
}

/// The ordinary character of a full-width one; `None` for others. Another function treats quotes.
fn plain(sign: char) -> Option<char> {
    match sign {
        '\u{3000}' | '\u{a0}' | '\u{2007}' | '\u{202f}' | '\u{200b}' | '\u{feff}' => Some(' '),
        '\u{2212}' | '\u{2013}' | '\u{2014}' => Some('-'),
        '、' => Some(','),
        '＂' | '＇' => None,
        '\u{ff01}'..='\u{ff5e}' => char::from_u32(u32::from(sign) - 0xfee0),
        _ => None,
    }
}

/// The first word with full-width characters, outside strings.
fn wide_signs(text: &str, tokens: &[Placed]) -> Option<Fault> {
    let is_string = |span: &Range<usize>| text[span.clone()].starts_with(['"', '\'']);
    let words = tokens
        .iter()
        .filter(|of| of.token == Token::Word && !is_string(&of.span));
    let mut wide = words.filter(|of| text[of.span.clone()].contains(|sign| plain(sign).is_some()));
    let mut span = wide.next()?.span.clone();
    let written = &text[span.clone()];
    let turned: String = written.chars().map(|sign| plain(sign).unwrap_or(sign)).collect();
    let blank = written.char_indices().find(|(_, sign)| plain(*sign) == Some(' '));
    let has_blank = blank.is_some();
    if let Some((at, sign)) = blank {
        span = span.start + at..span.start + at + sign.len_utf8();
    }
    let message = match has_blank {
        true => WrongToml::WideBlank,
        false => WrongToml::WideSigns(written.to_owned()),
    };
    let help = match has_blank {
        true => WrongToml::WritePlainBlank,
        false => WrongToml::WritePlain(turned.trim().to_owned()),
    };
    Some(Fault::new(span, "", message).help(help))
}

/// The first missing comma or bracket.
fn brackets(text: &str, tokens: &[Placed]) -> Option<Fault> {
    let word = |at: usize| tokens.get(at).is_some_and(|of| of.token == Token::Word);
    let equals = |at: usize| tokens.get(at).is_some_and(|of| of.token == Token::Equals);
    let said = |of: &Placed| text[of.span.clone()].to_owned();
    let mut open: Vec<Open> = Vec::new();
    let mut key = String::new();
    let mut at = 0;
    while let Some(of) = tokens.get(at) {
        let Some(top) = open.last_mut() else {
            match of.token {
                // a header: up to the end of its line
                Token::Open('[') if of.starts_line => {
                    at += 1;
                    while tokens.get(at).is_some_and(|next| !next.starts_line) {
                        at += 1;
                    }
                    continue;
                }
                Token::Open(sign) => open.push(opened(sign, of.span.start, &key)),
                Token::Word if of.starts_line && !equals(at) => key = said(of),
                _ => {}
            }
            at += 1;
            continue;
        };
        let begins_pair = word(at) && equals(at + 1);
        let is_header = of.token == Token::Open('[') && of.starts_line && is_header(text, of.span.start);
        let is_list = top.sign == '[';
        let is_after = top.next == Next::Comma;
        // a header, or a line that begins with its own key, cannot be in a list
        let is_no_item = is_header || begins_pair && of.starts_line;
        let is_cut_off = match is_list {
            true => is_no_item,
            false => is_after && is_header,
        };
        if is_cut_off {
            return Some(unclosed(text, top, of.span.start));
        }
        match of.token {
            Token::Comma => top.next = if is_list { Next::Value } else { Next::Key },
            Token::Equals if !is_list && top.next == Next::Key => top.next = Next::Value,
            Token::Close(sign) if (sign == ']') == is_list => {
                open.pop();
            }
            Token::Close(_) => return Some(unclosed(text, top, of.span.start)),
            Token::Word | Token::Open(_) if is_after => {
                // a table that continues in the next line lacks its bracket rather than a comma
                if !is_list && (of.starts_line || matches!(of.token, Token::Open(_))) {
                    return Some(unclosed(text, top, of.span.start));
                }
                let next = match of.token {
                    Token::Open(sign) => sign.to_string(),
                    _ => said(of),
                };
                let fault = Fault::new(of.span.clone(), "", WrongToml::CommaMissing(next.clone()));
                return Some(fault.help(WrongToml::WriteComma(next)));
            }
            // no key begins with a bracket
            Token::Open(_) if !is_list && top.next == Next::Key => {
                return Some(unclosed(text, top, of.span.start));
            }
            Token::Open(sign) => {
                top.next = Next::Comma;
                let key = top.key.clone();
                open.push(opened(sign, of.span.start, &key));
            }
            Token::Word if top.next == Next::Value => top.next = Next::Comma,
            Token::Word | Token::Equals => {}
        }
        at += 1;
    }
    open.last().map(|top| unclosed(text, top, text.len()))
}

fn opened(sign: char, at: usize, key: &str) -> Open {
    let next = if sign == '[' { Next::Value } else { Next::Key };
    let key = key.to_owned();
    Open { sign, at, key, next }
}

/// Whether a line that begins with a bracket is the header of a table: only a name in brackets.
fn is_header(text: &str, at: usize) -> bool {
    let line = text[at..].lines().next().unwrap_or_default();
    let line = line.split('#').next().unwrap_or_default().trim();
    let name = line.trim_start_matches('[').trim_end_matches(']').trim();
    line.ends_with(']')
        && !name.contains(['[', ']', ',', '{', '='])
        && name.starts_with(|sign: char| sign.is_alphabetic())
}

/// A list or table that is not closed before a place.
fn unclosed(text: &str, open: &Open, before: usize) -> Fault {
    let line = text[..before].matches('\n').count() + 1;
    let what = text[before..]
        .lines()
        .next()
        .unwrap_or_default()
        .trim()
        .to_owned();
    let sign = if open.sign == '[' { "]" } else { "}" }.to_owned();
    let key = open.key.clone();
    let message = match open.sign {
        '[' => WrongToml::ListNotClosed(key),
        _ => WrongToml::TableNotClosed(key),
    };
    let fault = Fault::new(open.at..open.at + 1, "", message);
    fault.help(match what.is_empty() {
        true => WrongToml::CloseAtEnd(sign),
        false => WrongToml::CloseBefore {
            sign,
            line: line.to_string(),
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(text: &str) -> Option<(String, String)> {
        let fault = slip(text)?;
        Some((text[fault.span.clone()].to_owned(), fault.text_of_help()))
    }

    #[test]
    fn holds_the_first_slip_is_found() {
        for (text, at, help) in [
            ("a = [{ w = 30.2 l = 3 }, { w = 1 }]\n", "l", "comma"),
            ("a = [1 2]\n", "2", "comma"),
            ("a = [\n { w = 1 },\n { w = 2 }\n { w = 3 },\n]\n", "{", "comma"),
            ("a = [\n { w = 1 },\n\nb = [{ s = 3 }]\n", "[", "] before line 4"),
            (
                "a = [\n [1, 2],\n [3, 4],\n[survey.\"2025\"]\nx = 1\n",
                "[",
                "] before line 4",
            ),
            ("a = { w = 1, l = 2\nb = 3\n", "{", "} before line 2"),
            ("a = [1, 2\n", "[", "] at the end"),
            ("a = ３０.２\n", "３０.２", "30.2"),
            ("a ＝ 3\n", "＝", "="),
            ("a =　3\n", "　", "plain blank"),
            ("a = −3\n", "−3", "-3"),
            ("\u{feff}b = 1\na = [1 2]\n", "2", "comma"),
        ] {
            let (span, said) = found(text).unwrap_or_else(|| panic!("{text}"));
            assert!(span == at && said.contains(help), "{text}: {span} {said}");
        }
        assert_eq!(found("\u{feff}a = \"open\n"), None); // a string that is not closed: the reader reports it
        // sound, or another fault
        for text in [
            "a = [\n  1, # ３\n  2,\n]\n[b.\"c d\"]\ne.f = { g = [[1, 2], [3]], h = \"＝\" }\n[[i]]\nj = '''\n[\n'''\n",
            "a = \"x\nb = 1\n",
            "무게 = 3\n",
        ] {
            assert_eq!(found(text), None, "{text}");
        }
    }
}
