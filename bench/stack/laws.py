"""What the springs law with assumed stiffness changes, beside the rigid law: pulses that overturn a block, and peaks of pagodas under El Centro.

    python bench/stack/laws.py [DOLMEN]

Prints the tables of docs/measured.md.
"""

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DOLMEN = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "target/release/dolmen")
STIFFNESS = ["1e9", "1e10", "1e11"]
G = 9.80665
WIDTH, HEIGHT = 0.4, 2.0
# overturning by half sines of frequency q p, over alpha g, of the exact equation (known/overturning.rs)
EXACT = {1: 1.339, 2: 1.825, 3: 2.3264, 4: 2.832}
# peaks, g: the pagoda of five storeys rocks in all joints beyond 0.2 g, which takes the rigid law many minutes
PAGODAS = {"p10": [0.2, 0.3, 0.4], "three_storey_pagoda": [0.2, 0.3, 0.4], "five_storey_pagoda": [0.2]}
BLOCK = """schema = 1
kind = "stack"
name = "block"
density = 2600
evidence = "assumed"
joint = {{ friction = 0.8, normal_stiffness = "{k} Pa/m", shear_stiffness = "{shear:g} Pa/m", damping_ratio = 0.3 }}
blocks = [{{ name = "block", width = 0.4, depth = 1, height = 2 }}]
"""


def simulate(folder, law, *words):
    command = [DOLMEN, "simulate", str(folder), "--law", law, "--json", "--force", *words]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 1, 3):  # 3: not decided
        sys.exit(f"{' '.join(command)}: {done.stderr}")
    return json.loads(done.stdout)


def overturns_at(folder, law, q):
    """Amplitude of the half sine that overturns the block, over alpha g, by halving."""
    alpha = math.atan2(WIDTH, HEIGHT)
    omega = q * math.sqrt(0.75 * G / (0.5 * math.hypot(WIDTH, HEIGHT)))
    step, low, high = 5e-4, 0.6 * EXACT[q], 1.2 * EXACT[q]
    samples = int(math.pi / omega / step) + 1
    while high - low > 2e-3 * EXACT[q]:
        middle = 0.5 * (low + high)
        wave = [f"{i * step:.6f},{middle * alpha * math.sin(min(omega * i * step, math.pi)):.9f}" for i in range(samples + 1)]
        (folder / "pulse.csv").write_text("time (s),acceleration (g)\n" + "\n".join(wave) + "\n")
        found = simulate(folder, law, "--motion-file", f"x={folder / 'pulse.csv'}", "--duration", "8", "--allow-outside")
        falls = found["outcome"]["kind"] == "fell"
        low, high = (low, middle) if falls else (middle, high)
    return 0.5 * (low + high)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        columns = [("rigid", "1e9"), *(("springs", k) for k in STIFFNESS)]
        print("half sine, ω/p   exact      rigid     springs " + "  ".join(STIFFNESS))
        for q, exact in EXACT.items():
            row = []
            for law, k in columns:
                (folder / "project.toml").write_text(BLOCK.format(k=k, shear=0.4 * float(k)))
                row.append(100 * (overturns_at(folder, law, q) / exact - 1))
            print(f"{q:8d}{exact:15.4f}   " + "  ".join(f"{value:+8.1f} %" for value in row), flush=True)
        print("\npagoda, peak of El Centro: largest opening and slip of a joint, mm; damage state")
        for example, peaks_g in PAGODAS.items():
            text = (ROOT / "examples" / example / "project.toml").read_text()
            for peak in peaks_g:
                row = []
                for law, k in columns:
                    stiff = f'normal_stiffness = "{k} Pa/m", shear_stiffness = "{0.4 * float(k):g} Pa/m"'
                    (folder / "project.toml").write_text(re.sub(r'normal_stiffness = "[^"]*", shear_stiffness = "[^"]*"', stiff, text))
                    found = simulate(folder, law, "--motion", "el-centro-1940-ns", "--peak", f"{peak}g")
                    opening, slip = (1e3 * max(joint[key] for joint in found["joints"]) for key in ("peak_opening_m", "peak_slip_m"))
                    fell = "fell" if found["outcome"]["kind"] == "fell" else f"{opening:.1f}, {slip:.1f}"
                    row.append(f"{fell}; {found['damage_state']}")
                print(f"{example:20s} {peak:4.2f} g  " + "   ".join(f"{cell:>16s}" for cell in row), flush=True)


main()
