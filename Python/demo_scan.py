# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The second demo: a scanned cat becomes the knob of a screw, in one Point Set Boolean.

    make demo

After Figure 1 of Yang and Qian (2009), where a scanned head is joined to a designed body. The scan
is a cloud of points of CGAL's (Debian's libcgal-demo), the screw a STEP file of Open CASCADE's (occt-misc).
Writes the result (also as .stl, to be printed), a state file and a picture into the folder given as
argument (build/demo), and ends with exit status 1 if the result is not what it has to be.
"""

import pathlib
import sys
import tarfile

import numpy as np
from paraview import servermanager, simple

import demo_picture
import demo_report
from demo_elephant import ARCHIVE

SCAN = "data/points_3/kitten.xyz"
SCREW = "/usr/share/opencascade/data/step/screw.step"
OPERATIONS = {"A | B": "Union", "A & B": "Intersection", "A - B": "Difference", "B - A": "Reverse Difference"}


def make_scan(path):
    """The cloud: points with normals, from a table as scanners write them."""
    try:
        with tarfile.open(ARCHIVE) as archive:
            rows = np.loadtxt(archive.extractfile(SCAN))
    except FileNotFoundError:
        sys.exit(f"{ARCHIVE} is missing; install it: apt-get install libcgal-demo")
    np.savetxt(path, rows, delimiter=",", header="x,y,z,nx,ny,nz", comments="", fmt="%.9g")
    table = simple.CSVReader(registrationName="Scan table", FileName=[str(path)])
    points = simple.TableToPoints(registrationName="Scan points", Input=table)
    points.XColumn, points.YColumn, points.ZColumn = "x", "y", "z"
    scan = simple.Calculator(registrationName="Scan", Input=points)
    scan.Function = "nx*iHat + ny*jHat + nz*kHat"
    scan.ResultArrayName = "Normals"
    scan.ResultNormals = 1
    return scan


def make_body():
    """The screw with its exact faces, head up under the cat; without a reader for it, a plinth."""
    if hasattr(simple, "NURBSReader") and pathlib.Path(SCREW).exists():
        file = simple.NURBSReader(registrationName="screw.step", FileName=SCREW)
        body = simple.Transform(registrationName="Screw", Input=file)
        body.Transform.Rotate = [-90, 0, 0]
        body.Transform.Scale = [0.0425, 0.0425, 0.0425]
        body.Transform.Translate = [0.7607, -0.74, -0.0356]
        return body
    print("Without Open CASCADE and occt-misc there is no screw; a plinth takes its place.")
    plinth = simple.Cylinder(registrationName="Plinth", Radius=0.42, Height=0.3, Resolution=96)
    body = simple.Transform(registrationName="Body", Input=plinth)
    body.Transform.Translate = [0, -0.55, 0]
    return body


def join(name, scan, body, operation):
    return simple.PointSetBoolean(registrationName=name, Input=scan, Tool=body, Operation=operation)


def field(surface, name):
    return demo_report.field(surface, name)[0]


def print_results(results):
    """A line for each operation; whether all are closed and as large as they claim."""
    print("\nA = scanned cat; B = designed body")
    print(f"{'result':<8}{'Status':>6}  {'closed':<7}{'cells':>9}{'volume':>14}{'area':>12}{'seam off by':>13}  Message")
    right = True
    for name, result in results.items():
        result.UpdatePipeline()
        surface = servermanager.Fetch(result)
        status, claimed, off = (field(surface, key) for key in ("Status", "ResultVolume", "SeamResidual"))
        closed = demo_report.is_closed(surface)
        print(
            f"{name:<8}{status:>6}  {'yes' if closed else 'NO':<7}{surface.GetNumberOfCells():>9,}{claimed:>14.9f}"
            f"{field(surface, 'ResultArea'):>12.6f}{off:>13.1e}  {field(surface, 'Message')}"
        )
        agrees = abs(demo_report.volume(surface) - claimed) <= demo_report.RECOUNT_LIMIT * claimed
        flipped, crossing = (field(surface, f"NumberOf{key}") for key in ("FlippedTriangles", "SelfIntersections"))
        right = right and closed and agrees and flipped == crossing == 0
    return right


def print_identities(results):
    """What set theory says of the volumes, within the error that the filter states."""
    surfaces = {name: servermanager.Fetch(result) for name, result in results.items()}
    v = {name: field(surface, "ResultVolume") for name, surface in surfaces.items()}
    union = surfaces["A | B"]
    a, b = field(union, "CloudVolume"), field(union, "ToolVolume")
    seam = results["A | B"].SMProxy.GetClientSideObject().GetOutputDataObject(2).GetCellData().GetArray("Length")
    length = sum(seam.GetValue(i) for i in range(seam.GetNumberOfTuples()))
    # Only along the seam are the results' triangles other ones: within a cell of it, by the budget.
    limit = (2 * length * field(union, "CellSize") * field(union, "ErrorBudget")) / a
    sums = {
        "vol(A|B) + vol(A&B) - vol(A) - vol(B)": v["A | B"] + v["A & B"] - a - b,
        "vol(A-B) + vol(A&B) - vol(A)": v["A - B"] + v["A & B"] - a,
        "vol(B-A) + vol(A&B) - vol(B)": v["B - A"] + v["A & B"] - b,
    }
    print()
    for name, value in sums.items():
        print(f"{name:<40}{value / a:>10.1e} of vol(A)   (budget {limit:.1e})")
    return all(abs(value) <= limit * a for value in sums.values())


def print_budget(result):
    surface = servermanager.Fetch(result)
    print(f"\nError of the result, in spacings of the scan ({field(surface, 'Spacing'):.4f}):")
    for name in ("NoiseError", "FacetError", "SeamChordError", "ToolError", "ErrorBudget"):
        print(f"  {name:<18}{field(surface, name) / field(surface, 'Spacing'):>8.4f}")


def main(folder):
    """Write everything into the folder; whether the results are what they have to be."""
    folder.mkdir(parents=True, exist_ok=True)
    scan, body = make_scan(folder / "cat.csv"), make_body()
    for source in (scan, body):
        source.UpdatePipeline()
    results = {name: join(operation, scan, body, operation) for name, operation in OPERATIONS.items()}
    joined = results["A | B"]
    right = print_results(results)
    right = print_identities(results) and right
    print_budget(joined)
    demo_report.print_stages("A | B", joined)
    result_file = folder / "cat_screw.stl"
    simple.SaveData(str(result_file), proxy=joined)
    for name, result in results.items():
        if result is not joined:
            simple.Delete(result)

    picture = folder / "cat_screw.png"
    demo_picture.draw_scan(picture, scan=scan, body=body, result=joined)
    simple.SaveState(str(folder / "scan.pvsm"))
    print(f"\nPicture: {picture}\nResult:  {result_file} (to print)")
    print(f"State:   {folder / 'scan.pvsm'} (open it from: make gui)")
    return right


if __name__ == "__main__":
    demo_report.run(main, "PointSetBoolean")
