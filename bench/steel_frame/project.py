"""Makes a project of the fifteen setups of a steel frame, published as measured at Bauhaus-Universität Weimar: FOLDER INTO

FOLDER is tests/files of the repository pyOMA-dev/pyOMA (GPL-3.0; commit c0e17452), INTO a new folder. Three lasers measure the velocity of
one node a setup along their beams, two accelerometers stay: velocities are differentiated, so that all channels are accelerations. Then:

    dolmen identify INTO/defaults.toml
    dolmen identify INTO/steel.toml        damping_least = 0.0005
"""

import math
import pathlib
import sys

import numpy as np

RATE_HZ = 256
HEAD = 'schema = 1\nkind = "survey"\nname = "Steel frame"\n'


def rows(path):
    return [line.split() for line in path.read_text().splitlines()[1:] if line.strip()]


def accelerations(samples):
    frequency_hz = np.fft.rfftfreq(len(samples), 1 / RATE_HZ)
    for column in range(3):
        spectrum = np.fft.rfft(samples[:, column] - samples[:, column].mean())
        samples[:, column] = np.fft.irfft(2j * np.pi * frequency_hz * spectrum, len(samples))
    return samples


def direction(azimuth_deg, elevation_deg):
    a, b = math.radians(azimuth_deg), math.radians(elevation_deg)
    return [math.cos(b) * math.cos(a), math.cos(b) * math.sin(a), math.sin(b)]


def main():
    source, into = map(pathlib.Path, sys.argv[1:3])
    into.mkdir()
    place_m = {row[0]: [float(x) / 100 for x in row[1:]] for row in rows(source / "grid.txt")}
    setups = []
    for number in range(1, 16):
        folder = source / f"measurement_{number}"
        samples = np.load(folder / f"measurement_{number}.npy").astype(float)
        np.save(into / f"{number}.npy", accelerations(samples))
        channels = []
        for column, node, azimuth, elevation, name in rows(folder / "channel_dofs.txt"):
            if column == "5":  # upwards, left out by those who measured
                continue
            at = ", ".join(f"{x:.3f}" for x in place_m[node])
            along = ", ".join(f"{x:.6f}" for x in direction(float(azimuth), float(elevation)))
            channels.append(
                f'  {{ column = {int(column) + 1}, name = "{name} {node}", position = [{at}], direction = [{along}] }},\n'
            )
        setups.append((f"{number}.npy", "".join(channels)))
    for name, more in ("defaults.toml", ""), ("steel.toml", "modal = { damping_least = 0.0005 }\n"):
        text = HEAD
        for file, channels in setups:
            text += f'\n[[survey.frame.setups]]\nfile = "{file}"\nsampling_rate = "{RATE_HZ} Hz"\n{more}channels = [\n{channels}]\n'
        (into / name).write_text(text)


main()
