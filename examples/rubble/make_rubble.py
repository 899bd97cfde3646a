"""Twelve bumpy stones in three layers, from a seed: writes stone01.obj to stone12.obj and prints the blocks of project.toml.

Each stone is an icosphere of 42 vertices, flattened, with twelve wide bumps of 5 % of its radius and a scatter of 1 mm. It is lowered to 1 mm above
the stones below it, or the ground: `python3 make_rubble.py --lowered`. That pile is no heap yet. `dolmen simulate` let it go down to PLACES, where it
lies; from there each stone is moved by up to 1 mm, as a scan would: `python3 make_rubble.py`. From its own folder; Python's standard library only.
"""

import math
import random
import sys

SEED = 1
BUMPS, NOISE_M, GAP_M = 0.05, 0.001, 0.001
# mean of the vertices of each stone at rest, m, and the rotation vector from the lowered stone, rad
PLACES = [
    (-0.7138, -0.3280, 0.1593, -0.1473, 0.1415, -0.1002),
    (-0.7287, 0.3918, 0.1753, -0.2582, -0.1068, 0.5960),
    (0.0024, -0.3149, 0.1344, -0.1579, -0.0173, -0.2825),
    (-0.0208, 0.3847, 0.1568, -0.2001, -0.0250, -0.0561),
    (0.7025, -0.3161, 0.1730, -0.0245, -0.1916, -0.3175),
    (0.7230, 0.3439, 0.1712, -0.1218, -0.0784, -0.1367),
    (-0.3358, -0.0999, 0.2981, -0.5870, -0.0443, 0.1416),
    (-0.3971, 0.3918, 0.3744, 0.0681, 0.0794, -0.1931),
    (0.3720, -0.1214, 0.2912, -0.6144, -0.2101, 0.1586),
    (0.3355, 0.2771, 0.3913, 0.1361, -0.1907, 0.0700),
    (-0.4027, 0.1063, 0.6203, 0.0310, -0.1270, 0.0596),
    (0.3022, -0.0326, 0.6207, 0.2516, -0.2819, 0.1771),
]


def icosphere():
    g = (1 + math.sqrt(5)) / 2
    corners = [p for a in (-1, 1) for b in (-g, g) for p in ((0, a, b), (a, b, 0), (b, 0, a))]
    near = lambda i, j: i != j and sum((p - q) ** 2 for p, q in zip(corners[i], corners[j])) < 4.1
    faces = []
    for i in range(12):
        for j in range(i + 1, 12):
            for k in range(j + 1, 12):
                if near(i, j) and near(j, k) and near(i, k):
                    (a, b, c), (d, e, f), (p, q, r) = corners[i], corners[j], corners[k]
                    out = a * (e * r - f * q) + b * (f * p - d * r) + c * (d * q - e * p) > 0
                    faces.append((i, j, k) if out else (i, k, j))
    middles, finer = {}, []
    for i, j, k in faces:
        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                corners.append(tuple((p + q) / 2 for p, q in zip(corners[a], corners[b])))
                middles[key] = len(corners) - 1
            return middles[key]
        x, y, z = middle(i, j), middle(j, k), middle(k, i)
        finer += [(i, x, z), (j, y, x), (k, z, y), (x, y, z)]
    unit = lambda p: tuple(x / math.hypot(*p) for x in p)
    return [unit(p) for p in corners], finer


def stone(draw, sphere):
    axes = draw.uniform(0.25, 0.35), draw.uniform(0.20, 0.30), draw.uniform(0.12, 0.18)
    bumps = []
    for _ in range(12):
        at = [draw.gauss(0, 1) for _ in range(3)]
        bumps.append(([x / math.hypot(*at) for x in at], BUMPS * draw.gauss(0, 1)))
    turn = draw.uniform(0, 2 * math.pi)
    points = []
    for p in sphere:
        radius = 1 + sum(h * math.exp(-2 * math.dist(p, at) ** 2) for at, h in bumps)
        x, y, z = (a * radius * c + NOISE_M * draw.gauss(0, 1) for a, c in zip(axes, p))
        points.append([x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn), z])
    return points


def gap(upper, lower, faces, edges):
    """Least vertical distance of the upper stone over the lower one: corners over faces, and edges that cross in plan."""
    least = math.inf
    cross = lambda o, p, q: (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0])
    for points, under, sign in ((upper, lower, 1), (lower, upper, -1)):
        for o in points:
            for a, b, c in ((under[i], under[j], under[k]) for i, j, k in faces):
                u, v, w = cross(o, b, c), cross(o, c, a), cross(o, a, b)
                whole = u + v + w
                if abs(whole) > 1e-12 and min(u * whole, v * whole, w * whole) >= 0:
                    height = (u * a[2] + v * b[2] + w * c[2]) / whole
                    least = min(least, sign * (o[2] - height))
    for a, b in ((upper[i], upper[j]) for i, j in edges):
        for c, d in ((lower[i], lower[j]) for i, j in edges):
            s, t = cross(c, d, a), cross(c, d, b)
            u, v = cross(a, b, c), cross(a, b, d)
            if s * t < 0 and u * v < 0:
                along, across = s / (s - t), u / (u - v)
                least = min(least, a[2] + along * (b[2] - a[2]) - c[2] - across * (d[2] - c[2]))
    return least


def placed_at(points, place, draw):
    """The stone moved to its place of rest, and then by up to 1 mm: half as far to each side, and upwards."""
    angle = math.hypot(*place[3:])
    x, y, z = (part / angle for part in place[3:])
    cos, sin = math.cos(angle), math.sin(angle)
    mean = [sum(p[k] for p in points) / len(points) for k in range(3)]
    shift = draw.uniform(-5e-4, 5e-4), draw.uniform(-5e-4, 5e-4), draw.uniform(0, 1e-3)
    moved = []
    for p in points:
        a, b, c = (p[k] - mean[k] for k in range(3))
        along = (x * a + y * b + z * c) * (1 - cos)
        turned = (
            a * cos + (y * c - z * b) * sin + x * along,
            b * cos + (z * a - x * c) * sin + y * along,
            c * cos + (x * b - y * a) * sin + z * along,
        )
        moved.append([turned[k] + place[k] + shift[k] for k in range(3)])
    return moved


def main():
    draw = random.Random(SEED)
    sphere, faces = icosphere()
    edges = sorted({(min(i, j), max(i, j)) for face in faces for i, j in zip(face, face[1:] + face[:1])})
    placed = []
    for layer, (along, across) in enumerate([(3, 2), (2, 2), (2, 1)]):
        for i in range(along):
            for j in range(across):
                points = stone(draw, sphere)
                close = 0.6 if layer == 1 else 1
                x = 0.72 * (i - (along - 1) / 2) + draw.uniform(-0.02, 0.02)
                y = close * (0.66 * (j - (across - 1) / 2) + draw.uniform(-0.02, 0.02))
                points = [[p[0] + x, p[1] + y, p[2] + 10] for p in points]
                fall = min([min(p[2] for p in points)] + [gap(points, below, faces, edges) for below in placed])
                placed.append([[p[0], p[1], p[2] - fall + GAP_M] for p in points])
    if "--lowered" not in sys.argv:
        placed = [placed_at(points, place, draw) for points, place in zip(placed, PLACES)]
    print("blocks = [")
    for number, points in enumerate(placed, 1):
        name = f"stone{number:02}.obj"
        with open(name, "w") as file:
            file.writelines(f"v {x:.5f} {y:.5f} {z:.5f}\n" for x, y, z in points)
            file.writelines(f"f {i + 1} {j + 1} {k + 1}\n" for i, j, k in faces)
        print(f'  {{ name = "{number}", shape = "mesh", file = "{name}", coordinates = "site" }},')
    print("]")


main()
