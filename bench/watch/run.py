"""Every structure of a store watched: CPU time and peak of memory of `dolmen watch --all` over many structures, and of one structure of many surveys.

    python3 bench/watch/run.py [--structures 10000] [--surveys 40] [--store FOLDER]

Structures are made: three modes known to 0.12 %, temperature over the year, a disturbance that stays from survey to survey (0.3). One in fifty lost
stiffness in one joint. One in ten has a model, a chain of three links, so that the part is sought where it changed. Goals: 60 s of CPU for 10,000
structures of 40 surveys with memory that does not grow with them but for the lines of the answer; one structure of 3,650 surveys within 1 s.
A store that is kept with --store is used again.
"""

import argparse
import datetime
import json
import math
import os
import random
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DOLMEN = os.environ.get("DOLMEN", os.path.join(ROOT, "target", "release", "dolmen"))
BATCH = 250
# of the chain below, and how far each falls where the middle joint keeps 85 % of its stiffness
FREQUENCIES_HZ = [0.67674, 2.47603, 5.51566]
FALL = [0.0305, 0.0348, 0.0204]
CHAIN = """units = { length = "m", force = "kN", stiffness = "kN*m/rad" }
links = [
{ name = "low", weight = 40, length = 3.5, centroid = 1.7 },
{ name = "middle", weight = 18, length = 2.8, centroid = 1.3 },
{ name = "top", weight = 8, length = 2.0, centroid = 0.9 },
]
joints = [{ stiffness = 3000 }, { stiffness = 900 }, { stiffness = 300 }]
"""


def project(number, surveys, step_days):
    draw = random.Random(number)
    kind, model = ("chain", CHAIN) if number % 10 == 0 else ("survey", "")
    text = [f'schema = 1\nkind = "{kind}"\nname = "structure {number:05d}"\nevidence = "measured"\n{model}']
    changes_at = surveys // 2 if number % 50 == 0 else surveys + 1
    day, disturbance = datetime.date(2012, 1, 15), [0.0] * 3
    for at in range(surveys):
        temperature = 12 - 12 * math.cos(2 * math.pi * day.timetuple().tm_yday / 365.25) + draw.gauss(0, 3)
        each = []
        for mode, hz in enumerate(FREQUENCIES_HZ):
            disturbance[mode] = 0.3 * disturbance[mode] + draw.gauss(0, 0.0008)
            change = -0.0006 * (temperature - 12) + disturbance[mode] + draw.gauss(0, 0.0012)
            if at >= changes_at:
                change -= FALL[mode]
            each.append(f"{{ value = {hz * (1 + change):.5f}, sd = {0.0012 * hz:.5f} }}")
        text.append(f"[survey.{day}]\ntemperature_c = {temperature:.1f}\nfrequencies.x = [{', '.join(each)}]\n")
        day += datetime.timedelta(days=step_days)
    return "\n".join(text)


def measured(command, cwd):
    """Standard output, CPU s, wall s and peak MB of a command."""
    begun = time.monotonic()
    with tempfile.TemporaryFile() as out:
        child = subprocess.Popen(command, cwd=cwd, stdout=out, stderr=subprocess.PIPE)
        said = child.stderr.read().decode()
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode > 1:
            sys.exit(f"{' '.join(command)}: {child.returncode}: {said}")
        out.seek(0)
        return out.read(), used.ru_utime + used.ru_stime, time.monotonic() - begun, used.ru_maxrss / 1024


def fill(folder, store, first, last, surveys):
    for start in range(first, last, BATCH):
        names = []
        for number in range(start, min(start + BATCH, last)):
            names.append(f"p{number}.toml")
            with open(os.path.join(folder, names[-1]), "w") as file:
                file.write(project(number, surveys, 91))
        measured([DOLMEN, "survey", "add", *names, "--without-modes", "--quiet", "--store", store], folder)
        for name in names:
            os.remove(os.path.join(folder, name))


def watch(folder, store, structures):
    said, cpu_s, wall_s, peak_mb = measured([DOLMEN, "watch", "--all", "--json", "--store", store], folder)
    found = json.loads(said)["structures"]
    assert len(found) == structures, len(found)
    changed = [of for of in found if of["history"]["change"]]
    named = [of for of in changed if of["history"]["change"].get("explained_by")]
    print(
        f"| {structures} | {cpu_s:.1f} s | {wall_s:.1f} s | {peak_mb:.0f} MB | {len(changed)} | {len(named)} |", flush=True
    )


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--structures", type=int, default=10_000)
    options.add_argument("--surveys", type=int, default=40)
    options.add_argument("--store", help="folder in which the store is kept")
    options = options.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.store or temporary
        os.makedirs(folder, exist_ok=True)
        print(f"structures of {options.surveys} surveys in one store, `dolmen watch --all`:\n")
        print("| structures | CPU | wall | peak of memory | changed | of these with a part named |\n|--:|--:|--:|--:|--:|--:|", flush=True)
        for structures in [options.structures // 4, options.structures]:
            store = os.path.join(folder, f"{structures}x{options.surveys}.db")
            if not os.path.exists(store):
                fill(folder, store, 0, structures, options.surveys)
            watch(folder, store, structures)
        with open(os.path.join(folder, "long.toml"), "w") as file:
            file.write(project(1, 3650, 1))
        _, cpu_s, wall_s, peak_mb = measured([DOLMEN, "watch", "long.toml", "--json"], folder)
        print(f"\none structure of 3650 surveys: {cpu_s:.2f} s of CPU, {wall_s:.2f} s, {peak_mb:.0f} MB")


if __name__ == "__main__":
    main()
