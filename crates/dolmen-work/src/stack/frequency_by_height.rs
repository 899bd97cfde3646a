//! The first frequency of pagodas with the factors of the file, for other heights and storeys.

use dolmen::blocks::{ContactRule, first_sway, lowest_stack_modes};
use dolmen::structure::stack::Stack;
use dolmen_project::{PagodaPart, Quantity, StackPart};

/// Heights of the body, m, and numbers of storeys: those of Fig. 17 and section 4.3 of Kim, Koo and Hong (2018).
const HEIGHTS_M: [f64; 9] = [3.0, 3.75, 4.5, 5.25, 6.0, 6.75, 7.5, 8.25, 9.0];
const STOREYS: [u32; 3] = [3, 5, 7];
/// Number of modes computed for each; the first sway mode is among the lowest.
const MODES: usize = 8;

/// Pagodas with the same number of storeys.
#[derive(Clone, Debug, PartialEq)]
pub struct FrequencyByHeight {
    /// Storeys.
    pub storeys: u32,
    /// Height of the body, m, total height, m, and first frequency of swaying, Hz; impossible heights are left out.
    pub points: Vec<HeightAndFrequency>,
}

/// One pagoda of the row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeightAndFrequency {
    /// Height of all storeys, without the base, m.
    pub body_height_m: f64,
    /// Height of the whole, m.
    pub height_m: f64,
    /// First frequency of swaying, Hz.
    pub frequency_hz: f64,
}

/// The grid for a file with factors; empty for any other.
pub(crate) fn grid(part: &StackPart, rule: ContactRule) -> Vec<FrequencyByHeight> {
    let Some(pagoda) = &part.pagoda else {
        return Vec::new();
    };
    let each = STOREYS.map(|storeys| FrequencyByHeight {
        storeys,
        points: HEIGHTS_M
            .into_iter()
            .filter_map(|body_height_m| {
                let stack = like(part, pagoda, (storeys, body_height_m))?;
                Some(HeightAndFrequency {
                    body_height_m,
                    height_m: stack.height_m(),
                    frequency_hz: first_frequency_hz(&stack, rule)?,
                })
            })
            .collect(),
    });
    each.into()
}

/// The pagoda of the file with another height and number of storeys; `None` if the other factors do not allow it.
fn like(part: &StackPart, pagoda: &PagodaPart, (storeys, body_height_m): (u32, f64)) -> Option<Stack> {
    let mut other = part.clone();
    other.pagoda = Some(PagodaPart {
        storeys,
        body_height: Quantity {
            value: body_height_m,
            ..pagoda.body_height.clone()
        },
        ..pagoda.clone()
    });
    other.build(&mut Quantity::nominal).ok()
}

/// The first frequency of swaying, Hz.
pub(crate) fn first_frequency_hz(stack: &Stack, rule: ContactRule) -> Option<f64> {
    let modes = lowest_stack_modes(stack, rule, MODES).ok()?;
    let first = first_sway(&modes, 0)?;
    Some(modes[first].frequency_hz).filter(|hz| *hz > 0.0)
}
