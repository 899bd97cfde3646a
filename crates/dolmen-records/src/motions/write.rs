//! Motions as files: AT2 of PEER, and text in columns.

use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::signal::{Component, GroundMotion};
use std::fmt::Write as _;

/// Numbers on a line of AT2.
const ON_A_LINE: usize = 5;

/// One component in the newer header of PEER, units of g, eight digits.
///
/// # Example
/// ```
/// use dolmen::signal::{Component, GroundMotion};
/// use dolmen_records::motions::{MotionOptions, motion_at2, read_component};
/// let motion = GroundMotion::new("made", 0.01, vec![(Component::X, vec![0.0, 1.5, -2.0])])?;
/// let read = read_component(motion_at2(&motion, Component::X).as_bytes(), &MotionOptions::default()).unwrap();
/// assert!(read.acceleration_m_s2.iter().zip([0.0, 1.5, -2.0]).all(|(a, b)| (a - b).abs() < 1e-7));
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn motion_at2(motion: &GroundMotion, component: Component) -> String {
    let samples = motion.acceleration_m_s2(component);
    let steps: Vec<String> = motion.history().iter().map(ToString::to_string).collect();
    let title: String = format!("{}, {component}: {}", motion.name(), steps.join("; "));
    let title: String = title
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    let mut out = format!(
        "DOLMEN, IN THE FORMAT OF THE PEER NGA STRONG MOTION DATABASE\n{title}\nACCELERATION TIME SERIES IN UNITS OF G\n\
         NPTS= {:6}, DT= {} SEC\n",
        samples.len(),
        motion.time_step_s()
    );
    for row in samples.chunks(ON_A_LINE) {
        for a in row {
            let _ = write!(out, " {:15.7e}", a / STANDARD_GRAVITY_M_S2);
        }
        out.push('\n');
    }
    out
}

/// All given directions as `time_s,x_m_s2,…`, with every digit and the history in comments.
///
/// # Example
/// ```
/// use dolmen::signal::{Component, GroundMotion};
/// use dolmen_records::motions::motion_csv;
/// let motion = GroundMotion::new("made", 0.01, vec![(Component::X, vec![0.0, 1.5])])?;
/// assert!(motion_csv(&motion).ends_with("time_s,x_m_s2\n0,0\n0.01,1.5\n"));
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn motion_csv(motion: &GroundMotion) -> String {
    let mut out = format!("# {}\n", motion.name().replace(char::is_control, " "));
    for step in motion.history() {
        let _ = writeln!(out, "# {step}");
    }
    let given: Vec<Component> = Component::ALL.into_iter().filter(|c| motion.has(*c)).collect();
    out.push_str("time_s");
    given
        .iter()
        .for_each(|component| out.push_str(&format!(",{component}_m_s2")));
    out.push('\n');
    for i in 0..motion.length() {
        let time = format!("{:.9}", i as f64 * motion.time_step_s()); // steps are 1e-9 s and longer
        out += time.trim_end_matches('0').trim_end_matches('.');
        for component in &given {
            let _ = write!(out, ",{}", motion.acceleration_m_s2(*component)[i]);
        }
        out.push('\n');
    }
    out
}
