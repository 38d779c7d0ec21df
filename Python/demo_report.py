# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the demo prints: field data of its results, and checks that do not rest on the filter."""

import pathlib
import sys
import time

from paraview import servermanager, simple
from surfacebooleans.measures import is_closed, volume
from vtkmodules.vtkIOLegacy import vtkPolyDataReader

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "build" / "demo"
IDENTITY_LIMIT = 1e-12  # of the volume of A: how exactly the filter's volumes have to agree
RECOUNT_LIMIT = 1e-7  # relative; quads with float points are bent a little


def field(surface, name):
    array = surface.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def name_of(proxy):
    return servermanager.ProxyManager().GetProxyName("sources", proxy)


def print_operands(result, operands):
    """The operands as the filter measured them."""
    surface = servermanager.Fetch(result)
    print(f"{'operand':<14}{'cells':>9}{'volume':>14}{'area':>12}")
    measures = zip(operands, field(surface, "OperandVolume"), field(surface, "OperandArea"))
    for operand, enclosed, area in measures:
        cells = operand.GetDataInformation().GetNumberOfCells()
        print(f"{name_of(operand):<14}{cells:>9,}{enclosed:>14.9f}{area:>12.6f}")


def print_results(results):
    """A line for each result; whether all are closed, with Status 0 and the volume they claim."""
    print("\nA = elephant, drum and plinth; B = drill and pegs")
    heads = f"{'result':<8}{'Status':>6}  {'closed':<7}{'cells':>9}{'volume':>14}{'area':>12}"
    print(f"{heads}{'seconds':>10}  Message")
    right = True
    for name, result in results.items():
        start = time.perf_counter()
        result.UpdatePipeline()
        seconds = time.perf_counter() - start
        surface = servermanager.Fetch(result)
        seconds = max(seconds, sum(field(surface, "StageSeconds")))  # updated already: its own time
        status, claimed = field(surface, "Status")[0], field(surface, "ResultVolume")[0]
        closed = is_closed(surface)
        print(
            f"{name:<8}{status:>6}  {'yes' if closed else 'NO':<7}{surface.GetNumberOfCells():>9,}"
            f"{claimed:>14.9f}{field(surface, 'ResultArea')[0]:>12.6f}{seconds:>10.3f}"
            f"  {field(surface, 'Message')[0]}"
        )
        agrees = abs(volume(surface) - claimed) <= RECOUNT_LIMIT * claimed
        right = right and closed and status == 0 and agrees
    return right


def print_identities(results):
    """What set theory says of the volumes; each sum would be 0 without rounding."""
    v = {
        name: field(servermanager.Fetch(result), "ResultVolume")[0]
        for name, result in results.items()
    }
    sums = {
        "vol(A|B) + vol(A&B) - vol(A) - vol(B)": v["A | B"] + v["A & B"] - v["A"] - v["B"],
        "vol(A-B) + vol(A&B) - vol(A)": v["A - B"] + v["A & B"] - v["A"],
        "vol(A^B) + vol(A&B) - vol(A|B)": v["A ^ B"] + v["A & B"] - v["A | B"],
    }
    print()
    for name, value in sums.items():
        print(f"{name:<40}{value / v['A']:>10.1e} of vol(A)")
    return all(abs(value) <= IDENTITY_LIMIT * v["A"] for value in sums.values())


def print_file(path):
    """Read the result back, and look whether what is in the file is closed."""
    reader = vtkPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    closed = is_closed(reader.GetOutput())
    print(f"\n{path.name}, read back: {'closed' if closed else 'NOT CLOSED'}")
    return closed


def print_stages(name, result):
    """Where the time of a result went."""
    surface = servermanager.Fetch(result)
    stages = dict(zip(field(surface, "StageNames"), field(surface, "StageSeconds")))
    print(f"\n{name} took {sum(stages.values()):.3f} s:")
    for stage, seconds in stages.items():
        print(f"  {stage:<18}{seconds:>8.3f} s")


def run(main, proxy):
    """Run a demo in the folder that is its argument; ends with exit status 1 where something is not as it has to be."""
    if not hasattr(simple, proxy):
        sys.exit("ParaView does not know the plugin. Run this first: . build/env.sh")
    if not main(pathlib.Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else FOLDER):
        sys.exit("FAILED: a result is not closed, or its volume is wrong; see the tables above.")
