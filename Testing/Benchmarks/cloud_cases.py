# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is done with clouds of points in the benchmark, and the surface that they were taken from.

All clouds are random points of a torus, moved along its normals by a fifth of the spacing. Errors are distances from
the torus itself, in spacings.
"""

from dataclasses import dataclass

import numpy as np

from cases import icosphere

TUBE = 0.4
NOISE = 0.2  # in spacings
TOOL_RADIUS = 0.7  # around (1, 0, 0)
LIBRARIES = ("ours", "pymeshlab")
WITH_THREADS = ("ours", "ours-threads", "pymeshlab")


@dataclass
class CloudCase:
    """One thing to do with a cloud: `task` is the name of a method of the contenders."""

    name: str
    task: str
    points: np.ndarray
    normals: np.ndarray
    contenders: tuple = LIBRARIES
    tool: tuple = (np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64))

    @property
    def spacing(self):
        return float(np.sqrt(4 * np.pi**2 * TUBE / len(self.points)))


def noisy_torus(count, random):
    """Points and exact normals, evenly in the area."""
    a, b = random.uniform(0, 2 * np.pi, (2, 2 * count))
    kept = np.flatnonzero(random.uniform(size=2 * count) < (1 + TUBE * np.cos(b)) / (1 + TUBE))[:count]
    a, b = a[kept], b[kept]
    normals = np.stack([np.cos(a) * np.cos(b), np.sin(a) * np.cos(b), np.sin(b)], axis=1)
    places = np.stack([np.cos(a), np.sin(a), 0 * a], axis=1) + TUBE * normals
    spacing = np.sqrt(4 * np.pi**2 * TUBE / len(places))
    return places + NOISE * spacing * random.normal(size=(len(places), 1)) * normals, normals


def from_torus(points):
    """Signed distances."""
    return np.hypot(np.hypot(points[:, 0], points[:, 1]) - 1, points[:, 2]) - TUBE


def from_tool(points):
    return np.linalg.norm(points - [1, 0, 0], axis=1) - TOOL_RADIUS


def from_surface(task, points):
    """How far points are from the surface that the task should find."""
    if task != "boolean":
        return from_torus(points)
    torus, tool = from_torus(points), from_tool(points)
    return np.where(np.abs(torus) < np.abs(tool), torus, tool)


def volume_left(steps=160):
    """Of the torus without the tool, by the midpoint rule."""
    middles = (np.arange(steps) + 0.5) / steps
    radius, around, along = np.meshgrid(TUBE * middles, 2 * np.pi * middles, np.pi * middles, indexing="ij")
    reach = 1 + radius * np.cos(around)
    far = (reach * np.cos(along) - 1) ** 2 + (reach * np.sin(along)) ** 2 + (radius * np.sin(around)) ** 2
    left = (reach * radius)[far > TOOL_RADIUS**2].sum()
    return 2 * left * (TUBE / steps) * (2 * np.pi / steps) * (np.pi / steps)  # the other half is the same


def all_cloud_cases(quick):
    """Every case, made one at a time. Quick: the same, small, to try the harness."""
    count = 20_000 if quick else 1_000_000
    points, normals = noisy_torus(count, np.random.default_rng(2009))
    size = "20k" if quick else "1M"
    yield CloudCase(f"project {size} points", "project", points, normals)
    yield CloudCase(f"normals of {size} points", "estimate", points, normals)
    yield CloudCase(f"mesh of {size} points", "mesh", points, normals, WITH_THREADS)
    sphere, triangles = icosphere(20 if quick else 64)
    tool = sphere * TOOL_RADIUS + [1, 0, 0], triangles
    yield CloudCase(f"{size} points - sphere", "boolean", points, normals, WITH_THREADS, tool)
