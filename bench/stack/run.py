"""P10 through 30 s of El Centro at .3 g: CPU time and error of Dolmen and of its peers, in turn, in one run.

Run by scripts/bench --stack. See README.md beside this file.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

import case

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
EXAMPLE = ROOT / "crates" / "dolmen-records" / "examples" / "stack_bench.rs"
FIGURES = ("peak_mm", "residual_mm", "joint_mm", "creep_mm")
ONE_THREAD = {f"{name}_NUM_THREADS": "1" for name in ("OMP", "OPENBLAS", "MKL", "RAYON")}
MOTIONS = [ROOT / "data" / "peer" / f"RSN6_IMPVALL.I_I-ELC{part}.AT2" for part in ("180-hor1", "270-hor2")]


def measured(command):
    """Rows {engine: figures} that a program prints, with the CPU time of its whole process."""
    with tempfile.TemporaryFile() as out:
        process = subprocess.Popen(command, cwd=ROOT, stdout=out, env={**os.environ, **ONE_THREAD})
        _, status, used = os.wait4(process.pid, 0)
        if status:
            sys.exit(f"{' '.join(map(str, command))} ended with status {os.waitstatus_to_exitcode(status)}")
        out.seek(0)
        text = out.read().decode()
    rows = {}
    for line in text.splitlines():
        name, *words = line.split()
        figures = {key: float(value) for key, _, value in (word.partition("=") for word in words)}
        if "loop_cpu_s" not in figures:
            sys.exit(f"{command[0]} printed {line!r}, not NAME loop_cpu_s=SECONDS ...")
        rows[name] = {**figures, "process_cpu_s": used.ru_utime + used.ru_stime}
    if not rows:
        sys.exit(f"{' '.join(map(str, command))} printed nothing")
    return rows


def cargo(*arguments):
    subprocess.run(["cargo", *arguments, "--release", "--locked", "--quiet", "-j1"], cwd=ROOT, check=True)


def programs(options, motion):
    """Every program that takes part: (is ours, is slow, command)."""
    if not options.no_dolmen and EXAMPLE.exists():
        cargo("build", "-p", "dolmen-records", "--example", "stack_bench")
        yield True, False, [ROOT / "target" / "release" / "examples" / "stack_bench", *MOTIONS]
    cargo("build", "--manifest-path", HERE / "rapier" / "Cargo.toml")
    for name in ("rapier_default", "rapier_fast", "rapier_tuned"):
        yield False, False, [HERE / "rapier" / "target" / "release" / "stack_rapier", motion, name]
    for name in ("mujoco_default", "mujoco_tuned"):
        yield False, False, [options.peer, HERE / "mujoco_peer.py", motion, name]
    yield False, True, [options.peer, HERE / "lmgc90_peer.py", motion]


def table(runs, ours):
    """Least and median CPU; each ratio is the median over the rounds of peer / Dolmen of the same round."""
    loops = {name: [run[name]["loop_cpu_s"] for run in runs if name in run] for name in {n: 0 for run in runs for n in run}}
    ratio_heads = [f"{'x ' + o:>14}" for o in ours]
    print(f"{'':16}{'loop CPU, s':>18}{'process, s':>12}{'top block, mm':>22}{'joint':>10}{'creep':>10}", *ratio_heads)
    print(f"{'':16}{'least':>9}{'median':>9}{'least':>12}{'peak':>11}{'residual':>11}{'mm':>10}{'mm':>10}")
    for name, loop in loops.items():
        of_it = [run[name] for run in runs if name in run]
        shown = [f"{of_it[0][f]:.2e}" if f in of_it[0] else "-" for f in FIGURES]
        both = [[run[name]["loop_cpu_s"] / run[o]["loop_cpu_s"] for run in runs if name in run] for o in ours]
        ratios = [statistics.median(rounds) for rounds in both]
        print(
            f"{name:16}{min(loop):9.3f}{statistics.median(loop):9.3f}{min(r['process_cpu_s'] for r in of_it):12.2f}"
            f"{shown[0]:>11}{shown[1]:>11}{shown[2]:>10}{shown[3]:>10}",
            *(f"{ratio:14.2f}" for ratio in ratios),
        )
        if any(run[f] != of_it[0][f] for run in of_it for f in FIGURES if f in run):
            print(f"{'':16}its motion differs from run to run")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--peer", default=str(HERE / ".venv" / "bin" / "python"), help="python that has the peers")
    parser.add_argument("--repeat", type=int, default=5, help="rounds; a slow peer takes part in the first only")
    parser.add_argument("--no-slow", action="store_true", help="leave LMGC90 out")
    parser.add_argument("--no-dolmen", action="store_true", help="the peers only")
    parser.add_argument("--peak-g", type=float, default=case.PEAK_G, help="another peak than .3 g: the peers only")
    options = parser.parse_args()
    options.no_dolmen |= options.peak_g != case.PEAK_G
    if not pathlib.Path(options.peer).exists():
        sys.exit(f"{options.peer} is missing: run scripts/bench --stack, or name a python that has requirements.txt")
    for file in MOTIONS:
        if not file.exists():
            sys.exit(f"{file} is missing: run scripts/data --motions")
    rows = case.motion(*MOTIONS, options.peak_g)
    peaks = [max(abs(row[axis]) for row in rows) / case.GRAVITY for axis in (0, 1)]
    settings = f"{case.DURATION_S:.0f} s at {1e3 * case.STEP_S:.0f} ms, friction {case.FRICTION}"
    print(f"P10, {settings}, peaks {peaks[0]:.4f} and {peaks[1]:.4f} g")
    print(f"statically it uplifts at {case.uplift_g():.4f} g: below that rigid blocks do not move at all")
    with tempfile.TemporaryDirectory() as folder:
        motion = pathlib.Path(folder) / "motion.txt"
        case.write(motion, rows)
        todo = [p for p in programs(options, motion) if not (p[1] and options.no_slow)]
        runs, ours = [], []
        for turn in range(options.repeat):
            run = {}
            for is_ours, slow, command in todo:
                if slow and turn:
                    continue
                printed = measured(command)
                ours += [name for name in printed if is_ours and name not in ours]
                run.update(printed)
            runs.append(run)
    table(runs, ours)
    if not ours:
        said = "left out" if options.no_dolmen else f"missing: there is no {EXAMPLE.relative_to(ROOT)}"
        print(f"Dolmen is {said}, so no ratio is printed")


if __name__ == "__main__":
    main()
