"""P10 and its motion, the same numbers for every peer.

P10 is ten square blocks of stone on the ground. The motion is RSN6 180 along x and 270 along y, first 30 s, .1 s cosine
taper at both ends, both scaled by the one factor that makes 180 peak at .3 g, linear between samples.
"""

import itertools
import math
import pathlib

GRAVITY = 9.81  # m/s²: LMGC90's wheel knows no other, so it is everybody's
DENSITY = 2600.0  # kg/m³
FRICTION = 0.6
STEP_S = 1e-3
DURATION_S = 30.0
TAPER_S = 0.1
PEAK_G = 0.3
SETTLE_S = 2.0  # before the motion, gravity only, not timed: soft contacts sink
QUIET_S = 10.0  # after the motion, gravity only, not timed: what creeps goes on moving

# side and height, m, bottom up
P10 = [(2.4, 0.5), (2.6, 0.25), (1.9, 0.9), (2.1, 0.25), (1.1, 1.1), (1.9, 0.5), (1.0, 0.45), (1.65, 0.45), (0.85, 0.40), (1.4, 0.40)]


def blocks():
    """(side, height, height of the centre above the ground, mass) of each block, bottom up."""
    base = 0.0
    for side, height in P10:
        yield side, height, base + height / 2, DENSITY * side * side * height
        base += height


def uplift_g():
    """Least static acceleration, g, that lifts an edge of a joint: the shaking of x and y each has its own pair of edges."""
    stack, least = list(blocks()), math.inf
    for joint in range(len(stack)):
        above = stack[joint:]
        mass = sum(m for *_, m in above)
        centre = sum(m * z for _, _, z, m in above) / mass - sum(h for _, h in P10[:joint])
        side = P10[joint][0] if joint == 0 else min(P10[joint - 1][0], P10[joint][0])
        least = min(least, side / 2 / centre)
    return least


def at2(path):
    """Sampling interval, s, and values, g, of a file of the PEER NGA database."""
    lines = pathlib.Path(path).read_text().splitlines()
    if len(lines) < 5 or "UNITS OF G" not in lines[2]:
        raise ValueError(f"{path} is not an AT2 file in units of g")
    header = lines[3].replace(",", " ").replace("=", " ").split()  # NPTS 5372 DT .0100 SEC
    count, interval = int(header[1]), float(header[3])
    values = [float(word) for line in lines[4:] for word in line.split()]
    if len(values) != count:
        raise ValueError(f"{path} holds {len(values)} values, its header says {count}")
    return interval, values


def prepared(path):
    """Interval and the values, g, of the first 30 s, tapered."""
    interval, values = at2(path)
    values = values[: round(DURATION_S / interval) + 1]
    taper, last = round(TAPER_S / interval), len(values) - 1
    if last * interval < DURATION_S - interval / 2:
        raise ValueError(f"{path} is shorter than {DURATION_S} s")
    for i in range(taper + 1):
        window = 0.5 * (1 - math.cos(math.pi * i / taper))
        values[i] *= window
        values[last - i] *= window
    return interval, values


def motion(path_180, path_270, peak_g=PEAK_G):
    """Ground acceleration (x, y), m/s², at every step from 0 to 30 s."""
    (interval, x), (also, y) = prepared(path_180), prepared(path_270)
    if interval != also:
        raise ValueError(f"intervals {interval} and {also} s differ")
    factor = peak_g / max(map(abs, x)) * GRAVITY
    fine, rows = round(interval / STEP_S), []
    for (x0, y0), (x1, y1) in itertools.pairwise(zip(x, y)):
        rows += [(factor * (x0 + (x1 - x0) * k / fine), factor * (y0 + (y1 - y0) * k / fine)) for k in range(fine)]
    return rows + [(factor * x[-1], factor * y[-1])]


def write(path, rows):
    pathlib.Path(path).write_text("".join(f"{x!r} {y!r}\n" for x, y in rows))


def read(path):
    return [tuple(map(float, line.split())) for line in pathlib.Path(path).read_text().splitlines()]


def moved(history, residual, quiet):
    """What is printed of a run, from block centres [(x, y, z), ...] relative to the ground and to where they settled.

    history: top block at every step of the motion; residual and quiet: all blocks at its end and QUIET_S later.
    """
    norm = lambda v: math.sqrt(sum(c * c for c in v))
    below = [(0.0, 0.0, 0.0), *residual[:-1]]
    return {
        "peak_mm": 1e3 * max(map(norm, history)),
        "residual_mm": 1e3 * norm(residual[-1]),
        "joint_mm": 1e3 * max(math.hypot(a[0] - b[0], a[1] - b[1]) for a, b in zip(residual, below)),
        "creep_mm": 1e3 * norm([b - a for a, b in zip(residual[-1], quiet[-1])]),
    }


def say(name, **figures):
    print(name, *(f"{key}={value:.6g}" for key, value in figures.items()), flush=True)
