# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark's inputs, and the volumes (of curves, the lengths) that their results must have.

Everything is made with numpy from a fixed seed: the same bytes on every machine. A mesh is a pair (points, triangles):
float64 of shape (n, 3) and int32 of shape (m, 3), outward oriented and closed.

An expected volume comes from geometry, never from a contender: a closed form where the shapes have one, else a
quadrature. Its tolerance is what the facets of the meshes or the quadrature account for, so that a shell lost or
counted twice is caught and a rounding difference is not.
"""

from dataclasses import dataclass, field

import numpy as np


# The curves in which two surfaces meet: alone, or with both surfaces cut along them.
CURVES = ("curves", "curves and cut surfaces")


@dataclass
class Case:
    """One comparison: (union of input) operation (union of tool)."""

    name: str
    operation: str  # "union", "intersection" or "difference", "clip", "check", or one of CURVES
    input: list
    tool: list
    volume: float  # or the length of the curves
    tolerance: float  # absolute, same unit as volume
    contenders: tuple = ("ours", "manifold3d", "trueform", "trueform-float", "meshlib")
    planes: tuple = ()  # of a clip: pairs (origin, normal); kept is what lies in front of all
    triangles: int = field(init=False)

    def __post_init__(self):
        self.triangles = sum(len(mesh[1]) for mesh in self.input + self.tool)


# ---------------------------------------------------------------------------------------------------------- meshes


def icosphere(frequency):
    """Unit sphere: each face of an icosahedron cut into frequency^2 triangles. Vertices are shared."""
    golden = (1 + 5**0.5) / 2
    corners = np.array(
        [[-1, golden, 0], [1, golden, 0], [-1, -golden, 0], [1, -golden, 0]]
        + [[0, -1, golden], [0, 1, golden], [0, -1, -golden], [0, 1, -golden]]
        + [[golden, 0, -1], [golden, 0, 1], [-golden, 0, -1], [-golden, 0, 1]]
    )
    faces = np.array(
        [[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4]]
        + [[11, 10, 2], [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8]]
        + [[3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]]
    )
    # A point of a face is three whole weights that add up to the frequency. Sorted by corner they are its name, the
    # same from every face that shares it.
    row, column = np.array([(i, j) for i in range(frequency + 1) for j in range(i + 1)]).T
    weights = np.stack([frequency - row, row - column, column], axis=1)
    corner = np.repeat(faces[:, None, :], len(weights), axis=1)
    weight = np.repeat(weights[None], len(faces), axis=0)
    name = np.sort(np.where(weight > 0, (corner + 1) * 4096 + weight, 0), axis=2)
    name = (name[..., 0] << 34) + (name[..., 1] << 17) + name[..., 2]
    _, first, point = np.unique(name.ravel(), return_index=True, return_inverse=True)
    points = np.einsum("fpk,fpkc->fpc", weight, corners[corner]).reshape(-1, 3)[first]
    points /= np.linalg.norm(points, axis=1)[:, None]

    start = row * (row + 1) // 2 + column
    upward = start[row < frequency]
    below = upward + row[row < frequency] + 1
    triangles = [np.stack([upward, below, below + 1], axis=1)]
    inner = column[row < frequency] < row[row < frequency]
    triangles.append(np.stack([upward, below + 1, upward + 1], axis=1)[inner])
    local = np.concatenate(triangles)
    offsets = np.arange(len(faces))[:, None, None] * len(weights)
    return points, point.reshape(-1)[(local[None] + offsets).reshape(-1, 3)].astype(np.int32)


def rotation(axis, angle):
    """Rotation matrix about an axis (Rodrigues)."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


GENERIC = rotation((1.0, 2.0, 3.0), 0.4)  # keeps two equal meshes from being symmetric to each other


def placed(mesh, centre, radius=1.0, turn=GENERIC):
    """The mesh turned, scaled and moved."""
    return mesh[0] @ turn.T * radius + np.asarray(centre), mesh[1]


def joined(meshes):
    """All meshes as one."""
    starts = np.cumsum([0] + [len(points) for points, _ in meshes[:-1]])
    triangles = [triangles + start for (_, triangles), start in zip(meshes, starts)]
    return np.concatenate([points for points, _ in meshes]), np.concatenate(triangles).astype(np.int32)


def box(low, high):
    """A box of 12 triangles."""
    points = np.array([[(low, high)[k >> axis & 1][axis] for axis in range(3)] for k in range(8)])
    quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    triangles = [[q[0], q[i], q[i + 1]] for q in quads for i in (1, 2)]
    return points.astype(float), np.array(triangles, dtype=np.int32)


# --------------------------------------------------------------------------------------------------------- volumes


def mesh_volume(mesh):
    """Signed volume of a closed mesh; its centre is taken as origin to keep the sum's terms small."""
    points = mesh[0] - mesh[0].mean(axis=0)
    a, b, c = (points[mesh[1][:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6


def lens_volume(r, s, distance):
    """Common volume of two balls of radii r and s."""
    if distance >= r + s:
        return 0.0
    overlap = r + s - distance
    return np.pi * overlap**2 * (distance**2 + 2 * distance * (r + s) - 3 * (r - s) ** 2) / (12 * distance)


def volume_below(mesh, height):
    """Volume of the part of a closed mesh with z < height, exactly: the flux of (z - height) through its facets."""
    points, triangles = mesh
    a, b, c = (points[triangles[:, k]] for k in range(3))
    area_z = np.cross(b - a, c - a)[:, 2] / 2
    depth = np.sort(points[triangles][:, :, 2] - height, axis=1)
    low, middle, high = depth.T
    with np.errstate(divide="ignore", invalid="ignore"):
        one_below = low**3 / ((low - middle) * (low - high)) / 3
        two_below = (low + middle + high) / 3 - high**3 / ((high - low) * (high - middle)) / 3
    mean = np.where(high <= 0, depth.mean(axis=1), np.where(middle <= 0, two_below, np.where(low < 0, one_below, 0)))
    return float(np.sum(mean * area_z))


def union_volume_of_balls(centres, radius, rays_per_radius):
    """Volume of a union of equal balls, by parallel rays on which the covered length is summed exactly."""
    step = radius / rays_per_radius
    low, high = centres.min(axis=0) - radius, centres.max(axis=0) + radius
    x = np.arange(low[0] + step / 2, high[0], step)
    total = 0.0
    for y in np.arange(low[1] + step / 2, high[1], step):
        half = radius**2 - (x[:, None] - centres[:, 0]) ** 2 - (y - centres[:, 1]) ** 2
        half = np.sqrt(np.maximum(half, 0))
        order = np.argsort(centres[:, 2] - half, axis=1)
        start = np.take_along_axis(centres[:, 2] - half, order, axis=1)
        end = np.take_along_axis(centres[:, 2] + half, order, axis=1)
        reached = np.maximum.accumulate(end, axis=1)
        before = np.concatenate([start[:, :1], reached[:, :-1]], axis=1)
        total += np.maximum(end - np.maximum(start, before), 0).sum()
    return float(total * step * step)


# ----------------------------------------------------------------------------------------------------------- cases


def two_spheres(frequency, operations, prefix="spheres", **options):
    """Unit spheres, the second one turned and moved by less than a radius."""
    centre = np.array([0.5, 0.3, 0.2])
    sphere = icosphere(frequency)
    other = placed(sphere, centre)
    volume = mesh_volume(sphere)
    lens = lens_volume(1, 1, np.linalg.norm(centre))
    expected = {"union": 2 * volume - lens, "intersection": lens, "difference": volume - lens}
    facets = 4 / 3 * np.pi - volume
    for operation in operations:
        yield Case(
            f"{prefix} {operation}", operation, [sphere], [other], expected[operation], 2 * facets, **options
        )


def bumpy_radius(directions, phase):
    x, y, z = (12 * directions.T) + phase
    return 1 + 0.05 * np.sin(x) * np.sin(y) * np.sin(z)


BUMPS = np.array([[0.1, 0.2, 0.3], [1.3, 1.9, 2.6]]).reshape(2, 3, 1)


def bumpy_meshes(frequency):
    sphere = icosphere(frequency)
    first = sphere[0] * bumpy_radius(sphere[0], BUMPS[0])[:, None], sphere[1]
    turned = sphere[0] @ GENERIC.T
    return first, (turned * bumpy_radius(turned, BUMPS[1])[:, None], sphere[1])


def bumpy_spheres(frequency):
    """Two concentric spheres whose bumps cross each other everywhere: the intersection curves are long."""
    first, second = bumpy_meshes(frequency)
    cosine, weights = np.polynomial.legendre.leggauss(800)
    angle = np.arange(1600) * (2 * np.pi / 1600)
    sine = np.sqrt(1 - cosine**2)[:, None]
    directions = np.stack(
        [sine * np.cos(angle), sine * np.sin(angle), np.repeat(cosine[:, None], len(angle), 1)], axis=-1
    ).reshape(-1, 3)
    radius = [bumpy_radius(directions, phase).reshape(800, 1600) for phase in BUMPS]
    volume = float(weights @ (np.maximum(*radius) ** 3).sum(axis=1)) * (2 * np.pi / 1600) / 3
    yield Case("bumpy union", "union", [first], [second], volume, volume * 40 / frequency**2)


def bumpy_check(frequency):
    """The same two spheres beside each other, as one surface, which meets itself nowhere."""
    first, second = bumpy_meshes(frequency)
    both = joined([first, (second[0] + (3.0, 0.0, 0.0), second[1])])
    contenders = ("ours", "pymeshlab", "meshlib")
    yield Case("bumpy check", "check", [both], [], mesh_volume(first) + mesh_volume(second), 1e-9, contenders)


def bumpy_curves(frequency):
    """The curves of the same two: the directions in which their radii are equal, found on a grid of directions."""
    cosine, angle = np.linspace(-1, 1, 1601), np.linspace(0, 2 * np.pi, 3201)
    sine = np.sqrt(1 - cosine**2)[:, None]
    directions = np.stack(
        [sine * np.cos(angle), sine * np.sin(angle), np.repeat(cosine[:, None], len(angle), 1)], axis=-1
    )
    radii = [bumpy_radius(directions.reshape(-1, 3), phase).reshape(sine.size, -1) for phase in BUMPS]
    places, height = directions * radii[0][..., None], radii[0] - radii[1]
    corners = [(slice(a, a - 1 or None), slice(b, b - 1 or None)) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
    length = 0.0
    for k, m in ((1, 2), (2, 3)):  # each square of the grid is two triangles, in which both radii are taken as linear
        points = np.stack([places[corners[i]] for i in (0, k, m)], axis=2).reshape(-1, 3, 3)
        values = np.stack([height[corners[i]] for i in (0, k, m)], axis=2).reshape(-1, 3)
        above = values > 0
        crossed = above.any(axis=1) & ~above.all(axis=1)
        points, values, above = points[crossed], values[crossed], above[crossed]
        lone = np.where(above.sum(axis=1) == 1, above.argmax(axis=1), (~above).argmax(axis=1))
        row = np.arange(len(lone))
        ends = []
        for step in (1, 2):
            other = (lone + step) % 3
            share = values[row, lone] / (values[row, lone] - values[row, other])
            ends.append(points[row, lone] * (1 - share[:, None]) + points[row, other] * share[:, None])
        length += float(np.linalg.norm(ends[1] - ends[0], axis=1).sum())
    first, second = bumpy_meshes(frequency)
    peers = ("ours", "trueform", "trueform-float")
    yield Case("bumpy curves", CURVES[0], [first], [second], length, 0.01 * length, peers)


def sphere_curves(frequency):
    """Two unit spheres meet in a circle."""
    centre = np.array([0.5, 0.3, 0.2])
    sphere = icosphere(frequency)
    length = 2 * np.pi * np.sqrt(1 - centre @ centre / 4)
    for operation in CURVES:
        yield Case(operation, operation, [sphere], [placed(sphere, centre)], length, 0.01 * length, ("ours", "vtk"))


def small_tool(frequency):
    """A large body and a tool whose triangles are a thousandth of its own."""
    body, ball = icosphere(frequency), placed(icosphere(8), (0, 0, 0))
    radius = 0.1 * (mesh_volume(ball) / (4 / 3 * np.pi)) ** (1 / 3)
    tool = placed(ball, GENERIC @ [0, 0, 1], 0.1)
    lens = lens_volume(1, radius, 1)
    yield Case("small tool", "difference", [body], [tool], mesh_volume(body) - lens, 0.02 * lens)


def plate_minus_spheres(counts):
    """Dimples in one face of a plate: the cuts of all spheres lie in two triangles."""
    random = np.random.default_rng(2011)
    plate = box((0, 0, 0), (40, 25, 1))
    cells = random.permutation(1000)
    ball = icosphere(8)
    spheres = []
    for cell in cells[: max(counts)]:
        centre = [cell % 40 + 0.5, cell // 40 + 0.5, 1] + random.uniform(-0.1, 0.1, 3)
        turn = rotation(random.normal(size=3), random.uniform(0, np.pi))
        spheres.append(placed(ball, centre, 0.35, turn))
    for count in counts:
        removed = sum(volume_below(sphere, 1.0) for sphere in spheres[:count])
        tool = joined(spheres[:count])
        yield Case(f"plate - {count}", "difference", [plate], [tool], 1000 - removed, 0.1 * removed / count)


def many_spheres(counts, frequency):
    """A rope of spheres in which each overlaps several others, united in one call."""
    random = np.random.default_rng(50)
    turn = 0.16 * np.arange(max(counts))
    centres = np.stack([3 * np.cos(turn), 3 * np.sin(turn), 0.22 * turn], axis=1)
    centres += random.uniform(-0.1, 0.1, centres.shape)
    sphere = icosphere(frequency)
    radius = (mesh_volume(sphere) / (4 / 3 * np.pi)) ** (1 / 3)
    meshes = [
        placed(sphere, centre, 1.0, rotation(random.normal(size=3), random.uniform(0, np.pi))) for centre in centres
    ]
    for count in counts:
        volume = union_volume_of_balls(centres[:count], radius, 60)
        yield Case(f"union of {count}", "union", meshes[:count], [], volume, 2e-3 * volume)


VTK = ("ours", "manifold3d", "vtk", "trueform", "meshlib")


# ----------------------------------------------------------------------------------------------------------- clips


def clipped_volume(mesh, planes):
    """Volume of a solid in front of planes: of tetrahedra from a point of all planes to the clipped triangles."""
    normals = np.array([normal for _, normal in planes], dtype=float)
    apex = np.linalg.lstsq(normals, np.einsum("ij,ij->i", normals, np.array([o for o, _ in planes])), rcond=None)[0]
    corners = (mesh[0] - apex)[mesh[1]]
    for normal in normals:
        corners = clipped_triangles(corners, normal)
    return float(np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))) / 6


def clipped_triangles(corners, normal):
    """The parts of triangles (n, 3, 3) in front of a plane through the origin, as triangles."""
    height = corners @ normal
    number = np.count_nonzero(height > 0, axis=1)
    parts = [corners[number == 3]]
    for inside in (1, 2):  # turned so that the odd one out comes first
        some, h = corners[number == inside], height[number == inside]
        first = np.argmax(h > 0, axis=1) if inside == 1 else np.argmin(h > 0, axis=1)
        order = (first[:, None] + np.arange(3)) % 3
        a, b, c = np.moveaxis(np.take_along_axis(some, order[..., None], 1), 1, 0)
        ha, hb, hc = np.take_along_axis(h, order, 1).T[..., None]
        ab, ac = a + (b - a) * ha / (ha - hb), a + (c - a) * ha / (ha - hc)
        parts += [np.stack(t, 1) for t in ([(a, ab, ac)] if inside == 1 else [(ab, b, c), (ab, c, ac)])]
    return np.concatenate(parts)


def clips(frequencies):
    """A bumpy sphere clipped by one plane and by three."""
    planes = tuple(((0.05, 0.02, 0.03), tuple(normal)) for normal in GENERIC)
    contenders = ("ours", "vtk-packaged", "vtk", "manifold3d", "trimesh", "meshlib", "trueform")
    for name, frequency in frequencies:
        sphere = icosphere(frequency)
        phase = np.array([[0.1], [0.2], [0.3]])
        solid = sphere[0] * bumpy_radius(sphere[0], phase)[:, None], sphere[1]
        for count in (1, 3):
            volume = clipped_volume(solid, planes[:count])
            title = f"clip {name}, {count} plane" + "s" * (count > 1)
            yield Case(title, "clip", [solid], [], volume, 1e-4 * volume, contenders, planes[:count])


def all_cases(quick):
    """Every case, made one at a time. Quick: the same shapes, small, to try the harness."""
    operations = ("union", "intersection", "difference")
    yield from two_spheres(16 if quick else 256, operations)
    yield from bumpy_spheres(40 if quick else 158)
    yield from bumpy_check(40 if quick else 158)
    yield from bumpy_curves(40 if quick else 224)
    yield from sphere_curves(16 if quick else 50)
    yield from small_tool(32 if quick else 224)
    yield from plate_minus_spheres((10, 20, 40) if quick else (250, 500, 1000))
    yield from many_spheres((5, 10) if quick else (25, 50), 8 if quick else 32)
    yield from clips((("5k", 16),) if quick else (("500k", 158), ("2M", 316)))
    yield from two_spheres(8 if quick else 22, ("union",), "spheres 20k", contenders=VTK)
    if not quick:
        yield from two_spheres(44, ("union",), "spheres 80k", contenders=VTK)
