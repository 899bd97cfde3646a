"""Writes record.npy: ten minutes of ambient vibration of a gate, one of whose columns moves by itself. Standard library only."""
import cmath, math, random, struct

RATE, SECONDS, DAMPING, NOISE = 16.0, 600, 0.02, 0.1
LOOSE = 1.2  # column 3 of the lower storey moves so many times as far as the others
LOW, HIGH = [1.0, 1.0, LOOSE, 1.0], [1.0, 1.0]
MODES = [(1.1, 0.843, 1.0), (4.2, 1.0, -0.7786)]  # Hz; displacement of the two levels: 290 and 314 t on 32.65 and 96.14 kN/mm

draw = random.Random(2026)
samples = int(RATE * SECONDS)
channels = [[0.0] * samples for _ in LOW + HIGH]
for hz, low, high in MODES:
    omega = 2 * math.pi * hz
    pole = omega * complex(-DAMPING, math.sqrt(1 - DAMPING**2))
    over_a_sample = cmath.exp(pole / RATE)
    state = 0j  # q = Re z: a force held over each sample turns and damps z
    for sample in range(-int(8 * RATE / (DAMPING * omega)), samples):
        force = draw.gauss(0, 1)
        state = over_a_sample * state + force * (over_a_sample - 1) / (pole * pole.imag) * -1j
        if sample >= 0:
            acceleration = (pole * pole * state).real
            shape = [low * c for c in LOW] + [high * c for c in HIGH]
            for channel, component in zip(channels, shape):
                channel[sample] += component * acceleration
for channel in channels:
    sd = NOISE * math.sqrt(sum(x * x for x in channel) / samples)
    for sample in range(samples):
        channel[sample] += draw.gauss(0, sd)
head = f"{{'descr': '<f4', 'fortran_order': False, 'shape': ({samples}, {len(channels)}), }}"
head += " " * (118 - len(head) - 1) + "\n"
with open("record.npy", "wb") as file:
    file.write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode())
    for row in zip(*channels):
        file.write(struct.pack(f"<{len(row)}f", *row))
