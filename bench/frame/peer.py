"""Two or twenty storeys with dry friction through El Centro in OpenSees: one process, one case, one line of figures.

    peer.py CASE [--step S] [--ratio R] [--material ElasticPP|Steel01|CoulombDamper] [--algorithm NAME]

OpenSees has no Coulomb slider with a set-valued law. As is usual there, each storey is a zero-length spring of κ in parallel with an
elastic-plastic one that yields at the slip force and whose stiffness is R times κ. Newmark's average acceleration, Newton.
"""

import argparse
import time

BEGAN = time.process_time()
import openseespy.opensees as ops  # noqa: E402  (what the import takes is measured)

IMPORTED = time.process_time()

import math  # noqa: E402
import pathlib  # noqa: E402
import tempfile  # noqa: E402

RECORD = pathlib.Path(__file__).resolve().parent.parent.parent / "data" / "el_centro_1940_ns" / "el_centro_1940_ns.csv"
DURATION_S = 40.0
SAMPLE_S = 0.02
GRAVITY = 9.81


def storeys(case):
    """Mass, kg, stiffness less P-delta, N/m, and slip force, N, of each storey, lowest first; Rayleigh's factors."""
    if case == "two_storeys":
        forces = [0.03 * n for n in (5919e3, 3077e3)]
        return [290e3, 314e3], [184_170_010.214_826_73, 16_447_964.437_896_422], forces, None
    n = 20
    forces = [0.01 * 9.81 * 200e3 * (n - i) for i in range(n)]
    return [200e3] * n, [3e8 - 1e7 * i for i in range(n)], forces, (0.05, 0.002) if case == "twenty_damped" else None


def slider(tag, stiffness, force, material):
    if material == "ElasticPP":
        ops.uniaxialMaterial("ElasticPP", tag, stiffness, force / stiffness)
    elif material == "Steel01":
        ops.uniaxialMaterial("Steel01", tag, force, stiffness, 0.0)
    else:
        ops.uniaxialMaterial(material, tag, stiffness, force)


def model(options):
    masses, springs, forces, rayleigh = storeys(options.case)
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(0, 0.0)
    ops.fix(0, 1)
    for i, (mass, spring, force) in enumerate(zip(masses, springs, forces), 1):
        ops.node(i, 0.0)
        ops.mass(i, mass)
        ops.uniaxialMaterial("Elastic", 1000 + i, spring)
        slider(2000 + i, options.ratio * spring, force, options.material)
        # Two elements: the stiffness that damps is that of the springs alone, as in Dolmen.
        ops.element("zeroLength", i, i - 1, i, "-mat", 1000 + i, "-dir", 1, "-doRayleigh", 1)
        ops.element("zeroLength", 100 + i, i - 1, i, "-mat", 2000 + i, "-dir", 1)
    if rayleigh:
        ops.rayleigh(rayleigh[0], rayleigh[1], 0.0, 0.0)
    values = [GRAVITY * float(line.split(",")[1]) for line in RECORD.read_text().splitlines()[1:]]
    ops.timeSeries("Path", 1, "-dt", SAMPLE_S, "-values", *values)
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", options.tolerance, 50, 0)
    ops.algorithm(*options.algorithm.split())
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    return len(masses)


def analysed(options):
    """Status and CPU time, s, of all steps in one call: the loop is OpenSees' own, in C++."""
    began = time.process_time()
    failed = ops.analyze(round(DURATION_S / options.step), options.step)
    return failed, time.process_time() - began


def rest(level, step):
    """Middle and half the range of a level's displacement in the next two seconds: stuck, the substitute still swings."""
    seen = []
    for _ in range(round(2.0 / step)):
        if ops.analyze(1, step):
            return math.nan, math.nan
        seen.append(ops.nodeDisp(level, 1))
    return 0.5 * (min(seen) + max(seen)), 0.5 * (max(seen) - min(seen))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("case", choices=["two_storeys", "twenty_storeys", "twenty_damped"])
    parser.add_argument("--step", type=float, default=0.005)
    parser.add_argument("--ratio", type=float, default=1000.0)
    parser.add_argument("--material", default="ElasticPP", choices=["ElasticPP", "Steel01", "CoulombDamper"])
    parser.add_argument("--loops", type=int, default=1, help="times the analysis is run, each from a new model; the mean is given")
    parser.add_argument("--algorithm", default="NewtonLineSearch")
    parser.add_argument("--tolerance", type=float, default=1e-10)
    options = parser.parse_args()
    loop = 0.0
    for _ in range(options.loops - 1):
        model(options)
        loop += analysed(options)[1]
    roof = model(options)
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "envelope.out"
        ops.recorder("EnvelopeNode", "-file", str(file), "-precision", 12, "-node", roof, "-dof", 1, "disp")
        failed, last = analysed(options)
        loop, until = (loop + last) / options.loops, ops.getTime()
        middle = swing = later = math.nan
        if not failed:
            middle, swing = rest(roof, options.step)
            ops.analyze(round(8.0 / options.step), options.step)
            later, _ = rest(roof, options.step)
        ops.wipe()  # writes the envelope
        peak = float(file.read_text().split()[2])
    print(
        f"{options.case} loop_cpu_s={loop:.5f} import_cpu_s={IMPORTED - BEGAN:.4f} peak_mm={1e3 * peak:.6f} "
        f"residual_mm={1e3 * middle:.8f} swing_mm={1e3 * swing:.2e} creep_mm={1e3 * (later - middle):.2e} until_s={until:.3f}"
    )


if __name__ == "__main__":
    main()
