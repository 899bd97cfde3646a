"""MuJoCo on single blocks whose motion is known: rocking, spinning, sliding, at 1 ms, with the settings of mujoco_peer.py.

The known numbers are exact solutions for a rigid block: rocking by quadrature and Housner's velocity ratio, spinning by
the friction torque of a face under even pressure, sliding event by event.
"""

import math

import mujoco
from case import GRAVITY, STEP_S
from mujoco_peer import SETTINGS


def block(half, friction, settings):
    options, contact = SETTINGS[settings]
    return mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{STEP_S}" gravity="0 0 {-GRAVITY}" {options}/>'
        f'<default><geom condim="3" friction="{friction} 0 0" {contact}/></default><worldbody>'
        f'<geom type="plane" size="50 50 1"/><body pos="0 0 {half[2]}"><freejoint/>'
        f'<geom type="box" size="{half[0]} {half[1]} {half[2]}" density="2600"/></body></worldbody></mujoco>'
    )


def angle(d, axis):
    return 2 * math.atan2(d.qpos[3 + axis], d.qpos[3])


def known_rocking(b, h, start, impacts):
    """Times of the impacts, and amplitude / α after each; the angle φ = x − s² takes the root out of the integral."""
    radius, alpha = math.hypot(b, h), math.atan(b / h)
    p, r = math.sqrt(0.75 * GRAVITY / radius), 1 - 1.5 * math.sin(alpha) ** 2

    def quarter(x, parts=20_000):
        width = math.sqrt(x) / parts
        middles = ((k + 0.5) * width for k in range(parts))
        return width / p * sum(2 * s / math.sqrt(2 * (math.cos(alpha - x) - math.cos(alpha - x + s * s))) for s in middles)

    x, time, times, amplitudes = start, quarter(start), [], []
    for _ in range(impacts):
        times.append(time)
        x = alpha - math.acos(math.cos(alpha) + r * r * (math.cos(alpha - x) - math.cos(alpha)))
        amplitudes.append(x / alpha)
        time += 2 * quarter(x)
    return times, amplitudes


def rocking(settings):
    b, h = 0.2, 1.0
    alpha, radius = math.atan(b / h), math.hypot(b, h)
    start = alpha / 2
    m = block((b, 0.3, h), 5.0, settings)
    d = mujoco.MjData(m)
    d.qpos[:3] = [b - radius * math.sin(alpha - start), 0, radius * math.cos(alpha - start)]
    d.qpos[3:7] = [math.cos(start / 2), 0, math.sin(start / 2), 0]
    before, widest, times, amplitudes = start, 0.0, [], []
    while d.time < 14:
        mujoco.mj_step(m, d)
        now = angle(d, 2)
        if now * before < 0:
            times.append(d.time - STEP_S * abs(now) / (abs(now) + abs(before)))
            amplitudes.append(widest / alpha)  # the first is the start, not an amplitude
            widest = 0.0
        before, widest = now, max(widest, abs(now))
    known_times, known_amplitudes = known_rocking(b, h, start, 20)
    shown = [("T/4", times[0:], known_times[0]), ("impact 20", times[19:], known_times[19]), ("amplitude 5", amplitudes[5:], known_amplitudes[4])]
    return ", ".join(f"{name} {l[0]:.4f} (exact {k:.4f}, {100 * (l[0] / k - 1):+.2f} %)" if l else f"no {name}" for name, l, k in shown)


def spinning(settings):
    m = block((0.15, 0.1, 0.02), 0.5, settings)
    d = mujoco.MjData(m)
    mujoco.mj_step(m, d, 1000)
    start, d.qvel[5] = angle(d, 3), 5.0
    mujoco.mj_step(m, d, 500)
    turned = math.degrees(angle(d, 3) - start)
    return f"{turned:.3f} degrees (exact 16.339, {100 * (turned / 16.339 - 1):+.1f} %)"


def sliding(settings):
    m = block((0.5, 0.5, 0.05), 0.3, settings)

    def slipped(seconds, acceleration):
        d, peak = mujoco.MjData(m), 0.0
        m.opt.gravity[0] = 0
        mujoco.mj_step(m, d, 1000)
        start = d.qpos[0]
        for k in range(round((seconds + 2) / STEP_S)):
            t = (k + 0.5) * STEP_S
            m.opt.gravity[0] = -acceleration(t) if t < seconds else 0
            mujoco.mj_step(m, d)
            peak = max(peak, abs(d.qpos[0] - start))
        return 1e3 * peak, 1e3 * abs(d.qpos[0] - start)

    pulse = slipped(0.2, lambda t: 0.5 * GRAVITY)[1]
    peak, left = slipped(10, lambda t: 0.5 * GRAVITY * math.sin(4 * math.pi * t))
    return f"pulse {pulse:.3f} mm (exact 65.40), sine {peak:.3f} mm, left {left:.4f} (exact 24.48, .4203)"


for name in SETTINGS:
    print(name, f"rocks {rocking(name)}", f"spins {spinning(name)}", f"slides {sliding(name)}", sep="\n  ")
