# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws how far a scanned icosahedron is from a perfect one: fit, distance map and histogram.

    . build/env.sh && xvfb-run -a /usr/bin/python3 Screenshots/scan_to_cad.py

The scan is CGAL's ball.ply (Debian: libcgal-demo), 31,374 points of a real body. Its pose and size are found by VTK's
iterative closest points; `sb.distance` measures.
"""

import pathlib
import tarfile

import numpy as np
import surfacebooleans as sb
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401  (the chart)
from offscreen import INK, actor_of, balls, look, save, side_by_side, white_room
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartXY
from vtkmodules.vtkCommonDataModel import vtkIterativeClosestPointTransform, vtkTable
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingContext2D import vtkContextActor
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

HERE = pathlib.Path(__file__).resolve().parent
ARCHIVE, SCAN = "/usr/share/doc/libcgal-dev/data.tar.gz", "data/points_3/ball.ply"
HEADER = 12  # lines
BODY = (0.86, 0.87, 0.89)


def scanned():
    with tarfile.open(ARCHIVE) as archive:
        rows = np.loadtxt(archive.extractfile(SCAN), skiprows=HEADER)
    return np.ascontiguousarray(rows[:, :3])


def icosahedron():
    source = vtkPlatonicSolidSource()
    source.SetSolidTypeToIcosahedron()
    source.Update()
    solid = source.GetOutput()
    faces = vtk_to_numpy(solid.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return vtk_to_numpy(solid.GetPoints().GetData()).astype(float), faces[:, ::-1]  # VTK's face inwards


def fitted(scan):
    """The icosahedron as the scan has it, the best of several starts: each ends where it is nearest to some face."""
    corners, faces = icosahedron()
    corners = corners / np.linalg.norm(corners, axis=1)[:, None]
    random = np.random.default_rng(1)
    center, size = scan.mean(axis=0), 1.2 * np.linalg.norm(scan - scan.mean(axis=0), axis=1).mean()
    best = (np.inf, None)
    for _ in range(8):
        turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
        turn *= np.sign(np.linalg.det(turn))
        body = moved(scan, (center + size * corners @ turn.T, faces))
        rms = np.sqrt(np.mean(sb.distance(scan, body) ** 2))
        best = min(best, (rms, body), key=lambda found: found[0])
    return best


def moved(scan, body):
    """The body, turned, shifted and scaled so that the scan's points are nearest to it."""
    registration = vtkIterativeClosestPointTransform()
    registration.SetSource(sb.polydata(scan))
    registration.SetTarget(sb.polydata(*body))
    registration.GetLandmarkTransform().SetModeToSimilarity()
    registration.SetMaximumNumberOfIterations(60)
    registration.SetMaximumNumberOfLandmarks(1000)
    registration.Update()
    matrix = registration.GetMatrix()
    to_body = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    corners = np.column_stack([body[0], np.ones(len(body[0]))])
    return (corners @ np.linalg.inv(to_body).T)[:, :3], body[1]


def diverging(largest):
    """Blue inside, red outside, and nearly white where they agree."""
    colors = vtkColorTransferFunction()
    colors.SetColorSpaceToDiverging()
    colors.AddRGBPoint(-largest, 0.23, 0.30, 0.75)
    colors.AddRGBPoint(largest, 0.71, 0.02, 0.15)
    return colors


def map_of(scan, distances, body, largest):
    """The points over the body, coloured by their distance, with a colour bar."""
    cloud = sb.polydata(scan)
    values = numpy_to_vtk(distances, deep=True)
    values.SetName("Distance")
    cloud.GetPointData().SetScalars(values)
    points = actor_of(balls(cloud, 0.45))
    points.GetMapper().SetLookupTable(diverging(largest))
    points.GetMapper().UseLookupTableScalarRangeOn()
    middle = body[0].mean(axis=0)
    solid = actor_of(sb.polydata(middle + 0.99 * (body[0] - middle), body[1]), BODY)  # hides the far side, not dents
    room = white_room((points, solid, color_bar(points.GetMapper().GetLookupTable())), contrast=2)
    look(room, (1.0, -1.5, 0.9), zoom=1.25)
    return room


def color_bar(colors):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(colors)
    bar.SetTitle("Distance")
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.1f")
    bar.SetUnconstrainedFontSize(True)
    for style in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        style.SetColor(INK)
        style.SetFontSize(15)
        style.SetBold(False)
        style.SetItalic(False)
        style.SetShadow(False)
    bar.SetPosition(0.86, 0.2)
    bar.SetWidth(0.11)
    bar.SetHeight(0.6)
    return bar


def histogram(distances, largest, words):
    counts, edges = np.histogram(distances, bins=60, range=(-largest, largest))
    table = vtkTable()
    for name, values in (("Distance", (edges[1:] + edges[:-1]) / 2), ("Points", counts)):
        column = numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=True)
        column.SetName(name)
        table.AddColumn(column)
    chart = vtkChartXY()
    bars = chart.AddPlot(vtkChart.BAR)
    bars.SetInputData(table, 0, 1)
    bars.SetColor(90, 120, 180, 255)
    chart.SetTitle(words)
    chart.GetTitleProperties().SetFontSize(16)
    chart.GetAxis(vtkAxis.BOTTOM).SetTitle("Distance (unit of the scan)")
    chart.GetAxis(vtkAxis.LEFT).SetTitle("Points")
    drawn = vtkContextActor()
    drawn.GetScene().AddItem(chart)
    return white_room([drawn])


def main():
    scan = scanned()
    rms, body = fitted(scan)
    distances = sb.distance(scan, body)
    largest = float(np.quantile(np.abs(distances), 0.98))
    size = np.ptp(body[0], axis=0).max()
    words = f"{len(scan):,} points, rms {rms:.2f} = {100 * rms / size:.2f} % of the body's size"
    print(words)
    rooms = side_by_side([map_of(scan, distances, body, largest), histogram(distances, largest, words)])
    save(HERE / "scan_to_cad.png", rooms, (1240, 560))


if __name__ == "__main__":
    main()
