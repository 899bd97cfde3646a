//! Sensors with positions, and the lines drawn between them.

use dolmen::modal::Modes;

/// Sensors closer than this in plan are above one another, m; so are sensors of setups at one position.
const ABOVE_M: f64 = 0.1;

/// Sensors and the lines between them.
pub(crate) struct Wires {
    /// Positions of the sensors, m, followed by those of their feet on the ground, which do not move.
    pub(crate) places: Vec<[f64; 3]>,
    /// Number of positions with sensors, which come first.
    pub(crate) sensors: usize,
    /// Position and direction of each channel.
    pub(crate) channels: Vec<(usize, [f64; 3])>,
    /// Places joined by lines.
    pub(crate) wires: Vec<Vec<usize>>,
}

impl Wires {
    /// `None` if fewer than two sensors have a position and a direction, or if a channel lacks them.
    pub(crate) fn of(modes: &Modes) -> Option<Wires> {
        let mut places: Vec<[f64; 3]> = Vec::new();
        let mut channels = Vec::new();
        for channel in &modes.channels {
            let (at, direction) = (channel.position_m?, channel.direction?);
            let place = places.iter().position(|p| *p == at).unwrap_or_else(|| {
                places.push(at);
                places.len() - 1
            });
            channels.push((place, direction));
        }
        let sensors = places.len();
        if sensors < 2 {
            return None;
        }
        let mut wires = levels(&places);
        for mut column in columns(&places) {
            let foot = places[column[0]];
            if foot[2] > 0.0 {
                places.push([foot[0], foot[1], 0.0]);
                column.insert(0, places.len() - 1);
            }
            if column.len() > 1 {
                wires.push(column);
            }
        }
        Some(Wires {
            places,
            sensors,
            channels,
            wires,
        })
    }

    /// Motion of every position, real and imaginary part of each component, scaled to a largest displacement of `most_m`.
    pub(crate) fn moved(&self, shape: &[[f64; 2]], most_m: f64) -> Vec<[[f64; 3]; 2]> {
        let mut parts = vec![[[0.0; 3]; 2]; self.places.len()];
        for ((place, direction), [re, im]) in self.channels.iter().zip(shape) {
            for (k, along) in direction.iter().enumerate() {
                parts[*place][0][k] += re * along;
                parts[*place][1][k] += im * along;
            }
        }
        let lengths = parts.iter().map(|part| {
            let squares = part.iter().flatten().map(|x| x * x);
            squares.sum::<f64>().sqrt()
        });
        let factor = most_m / lengths.fold(1e-12, f64::max);
        for part in parts.iter_mut().flatten().flatten() {
            *part *= factor;
        }
        parts
    }
}

/// Positions of each level, as a closed loop around their middle.
fn levels(places: &[[f64; 3]]) -> Vec<Vec<usize>> {
    let mut heights: Vec<f64> = places.iter().map(|p| p[2]).collect();
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    let mut wires = Vec::new();
    for height in heights {
        let mut level: Vec<usize> = (0..places.len()).filter(|&at| places[at][2] == height).collect();
        let count = level.len() as f64;
        let sum = level
            .iter()
            .fold([0.0; 2], |s, &at| [s[0] + places[at][0], s[1] + places[at][1]]);
        let angle = |at: usize| (places[at][1] - sum[1] / count).atan2(places[at][0] - sum[0] / count);
        level.sort_by(|a, b| angle(*a).total_cmp(&angle(*b)));
        if level.len() > 2 {
            level.push(level[0]);
        }
        if level.len() > 1 {
            wires.push(level);
        }
    }
    wires
}

/// Positions above one another, lowest first.
fn columns(places: &[[f64; 3]]) -> Vec<Vec<usize>> {
    let mut columns: Vec<Vec<usize>> = Vec::new();
    for (at, place) in places.iter().enumerate() {
        let near = |column: &&mut Vec<usize>| {
            let foot = places[column[0]];
            (foot[0] - place[0]).hypot(foot[1] - place[1]) <= ABOVE_M
        };
        match columns.iter_mut().find(near) {
            Some(column) => column.push(at),
            None => columns.push(vec![at]),
        }
    }
    for column in &mut columns {
        column.sort_by(|a, b| places[*a][2].total_cmp(&places[*b][2]));
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_wires_of_a_house_with_two_levels() {
        let places = [
            [0.0, 0.0, 3.0],
            [4.0, 0.0, 3.0],
            [4.0, 5.0, 3.0],
            [0.0, 5.0, 3.0],
            [0.0, 0.05, 6.0],
            [4.0, 5.0, 6.0],
        ];
        assert_eq!(levels(&places), [vec![0, 1, 2, 3, 0], vec![4, 5]]);
        assert_eq!(columns(&places), [vec![0, 4], vec![1], vec![2, 5], vec![3]]);
    }
}
