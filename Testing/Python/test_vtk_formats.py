# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Claims about the formats that VTK reads: a block of cubes comes out of each as a closed surface with its arrays."""

import numpy as np
import pytest
import surfacebooleans as sb
from paraview.modules.vtkPVVTKExtensionsIOCGNSWriter import vtkCGNSWriter
from surfacebooleans.command_line import main
from surfacebooleans.meshes import as_surface, merged
from surfacebooleans.vtk_formats import READERS
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import (
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPartitionedDataSet,
    vtkPartitionedDataSetCollection,
    vtkRectilinearGrid,
)
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkImageDataToPointSet
from vtkmodules.vtkIOExodus import vtkExodusIIWriter
from vtkmodules.vtkIOGeometry import vtkBYUWriter
from vtkmodules.vtkIOImage import vtkMetaImageWriter, vtkNIFTIImageWriter
from vtkmodules.vtkIOParallel import vtkEnSightWriter
from vtkmodules.vtkIOParallelXML import (
    vtkXMLPartitionedDataSetCollectionWriter,
    vtkXMLPartitionedDataSetWriter,
    vtkXMLPImageDataWriter,
    vtkXMLPPolyDataWriter,
    vtkXMLPRectilinearGridWriter,
    vtkXMLPStructuredGridWriter,
    vtkXMLPUnstructuredGridWriter,
)
from vtkmodules.vtkIOXML import (
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataWriter,
    vtkXMLRectilinearGridWriter,
    vtkXMLStructuredGridWriter,
    vtkXMLUnstructuredGridWriter,
)
from vtkmodules.vtkIOXdmf2 import vtkXdmfWriter

VOLUME = 2.0 * 3.0 * 4.0


def output_of(algorithm, data):
    algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm.GetOutput()


@pytest.fixture(scope="module")
def image():
    """2 x 3 x 4 cubes with an array that is the height at the points."""
    image = vtkImageData()
    image.SetDimensions(3, 4, 5)
    heights = np.repeat(np.arange(5.0), 12)
    array = numpy_to_vtk(heights, deep=True)
    array.SetName("height")
    image.GetPointData().SetScalars(array)
    return image


@pytest.fixture(scope="module")
def structured(image):
    return output_of(vtkImageDataToPointSet(), image)


@pytest.fixture(scope="module")
def grid(structured):
    return output_of(vtkAppendFilter(), structured)


@pytest.fixture(scope="module")
def surface(grid):
    return output_of(vtkTriangleFilter(), as_surface(grid))


def written(writer, data, path, **settings):
    (writer.SetGeometryFileName if hasattr(writer, "SetGeometryFileName") else writer.SetFileName)(str(path))
    writer.SetInputData(data)
    for name, value in settings.items():
        getattr(writer, "Set" + name)(value)
    writer.Write()
    return path


def blocks(kind, *data):
    composite = kind()
    for k, part in enumerate(data):
        if kind is vtkPartitionedDataSetCollection:
            composite.SetPartition(k, 0, part)
        else:
            (composite.SetPartition if kind is vtkPartitionedDataSet else composite.SetBlock)(k, part)
    return composite


def check(path, arrays=True):
    """The file is the block of cubes, and a Boolean takes it."""
    data = sb.read(path)
    measured = sb.measure(data)
    assert measured["closed"] and measured["volume"] == pytest.approx(VOLUME, rel=1e-6), measured
    low = ((-10, -10, -10), (0, 0, 1))
    clipped = sb.clip(data, [low, ((0, 0, 1.0), (0, 0, 1))])
    assert sb.measure(clipped)["volume"] == pytest.approx(VOLUME * 3 / 4, rel=1e-6)
    heights = merged(data).GetPointData().GetArray("height")
    assert not arrays or heights.GetRange() == (0.0, 4.0)
    return data


def test_files_of_pieces(image, structured, grid, surface, tmp_path):
    for suffix, writer, data in (
        (".pvtp", vtkXMLPPolyDataWriter, surface),
        (".pvtu", vtkXMLPUnstructuredGridWriter, grid),
        (".pvts", vtkXMLPStructuredGridWriter, structured),
        (".pvti", vtkXMLPImageDataWriter, image),
    ):
        check(written(writer(), data, tmp_path / f"file{suffix}", DataMode=1))


def test_grids_count_as_their_boundary(image, structured, grid, tmp_path):
    rectilinear = vtkRectilinearGrid()
    rectilinear.SetDimensions(image.GetDimensions())
    for axis, size in zip("XYZ", image.GetDimensions()):
        getattr(rectilinear, f"Set{axis}Coordinates")(numpy_to_vtk(np.arange(float(size)), deep=True))
    rectilinear.GetPointData().ShallowCopy(image.GetPointData())
    check(written(vtkXMLRectilinearGridWriter(), rectilinear, tmp_path / "file.vtr", DataMode=1))
    check(written(vtkXMLPRectilinearGridWriter(), rectilinear, tmp_path / "file.pvtr", DataMode=1))
    check(written(vtkXMLUnstructuredGridWriter(), grid, tmp_path / "file.vtu", DataMode=1))
    check(written(vtkXMLStructuredGridWriter(), structured, tmp_path / "file.vts", DataMode=1))


def test_blocks_count_as_one_surface(surface, grid, tmp_path):
    for suffix, writer, kind in (
        (".vtm", vtkXMLMultiBlockDataWriter, vtkMultiBlockDataSet),
        (".vtmb", vtkXMLMultiBlockDataWriter, vtkMultiBlockDataSet),
        (".vtpd", vtkXMLPartitionedDataSetWriter, vtkPartitionedDataSet),
        (".vtpc", vtkXMLPartitionedDataSetCollectionWriter, vtkPartitionedDataSetCollection),
    ):
        for data in (surface, grid):
            check(written(writer(), blocks(kind, data), tmp_path / f"file{suffix}"))


def test_files_of_simulations(grid, tmp_path):
    for suffix in (".e", ".ex2", ".exo", ".g"):
        check(written(vtkExodusIIWriter(), grid, tmp_path / f"file{suffix}"))
    check(written(vtkCGNSWriter(), grid, tmp_path / "file.cgns"))
    for suffix in (".xdmf", ".xmf"):
        check(written(vtkXdmfWriter(), grid, tmp_path / f"file{suffix}"))


def test_ensight(grid, tmp_path):
    ids = numpy_to_vtk(np.ones(grid.GetNumberOfCells(), dtype=np.int32), deep=True)
    ids.SetName("BlockId")
    data = grid.NewInstance()
    data.ShallowCopy(grid)
    data.GetCellData().AddArray(ids)
    writer = vtkEnSightWriter()
    writer.SetPath(str(tmp_path))
    writer.SetBaseName("file")
    written(writer, data, tmp_path / "file")
    case = (  # the writer's own WriteCaseFile leaves the file open
        "FORMAT\ntype: ensight gold\n\nGEOMETRY\nmodel: file.0.00000.geo\n\n"
        "VARIABLE\nscalar per node: height file.0.00000_n.height\n"
    )
    for suffix in (".case", ".encas"):
        (tmp_path / f"file{suffix}").write_text(case)
        check(tmp_path / f"file{suffix}")


def test_what_only_paraview_knows_is_read_by_its_reader(surface, tmp_path):
    piece = written(vtkXMLPolyDataWriter(), surface, tmp_path / "piece.vtp", DataMode=1)
    (tmp_path / "file.pvd").write_text(
        '<VTKFile type="Collection" version="0.1">\n<Collection>\n'
        f'<DataSet timestep="0" part="0" file="{piece.name}"/>\n</Collection>\n</VTKFile>\n'
    )
    check(tmp_path / "file.pvd")
    (tmp_path / "file.blah").write_text("nonsense\n")
    with pytest.raises(sb.FileError, match="the format .blah is not known; these are: .asc .avs"):
        sb.read(tmp_path / "file.blah")


def test_surfaces(surface, tmp_path):
    check(written(vtkBYUWriter(), surface, tmp_path / "file.byu"), False)
    check(written(vtkBYUWriter(), surface, tmp_path / "file.g"), False)


def test_images(image, tmp_path):
    for suffix, writer in ((".mha", vtkMetaImageWriter), (".mhd", vtkMetaImageWriter), (".nii", vtkNIFTIImageWriter)):
        path = written(writer(), image, tmp_path / f"file{suffix}")
        assert sb.measure(sb.read(path))["volume"] == pytest.approx(VOLUME)


def test_foam(grid, tmp_path):
    """A polyMesh of one hexahedron a cell: each face is named once, with its owner and, inside, the neighbour."""
    cells, sides = corners(grid), {}
    faces_of_cube = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    for cell, ids in enumerate(cells):
        for face in faces_of_cube:
            sides.setdefault(frozenset(ids[k] for k in face), []).append((cell, [ids[k] - 1 for k in face]))
    inner = [side for side in sides.values() if len(side) == 2]
    outer = [side for side in sides.values() if len(side) == 1]
    files = {
        "points": [f"({words(point)})" for point in places(grid)],
        "faces": [f"4({words(side[0][1])})" for side in inner + outer],
        "owner": [side[0][0] for side in inner + outer],
        "neighbour": [side[1][0] for side in inner],
    }
    kinds = {"points": "vectorField", "faces": "faceList", "owner": "labelList", "neighbour": "labelList"}
    folder = tmp_path / "constant" / "polyMesh"
    folder.mkdir(parents=True)
    head = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
    for name, lines in files.items():
        listed = "\n".join(map(str, lines))
        (folder / name).write_text(head.format(kinds[name], name) + f"{len(lines)}\n(\n{listed}\n)\n")
    walls = f"walls {{ type wall; nFaces {len(outer)}; startFace {len(inner)}; }}"
    (folder / "boundary").write_text(head.format("polyBoundaryMesh", "boundary") + f"1\n(\n{walls}\n)\n")
    (tmp_path / "system").mkdir()
    times = "startTime 0; endTime 1; deltaT 1; writeInterval 1; writeControl timeStep;\n"
    (tmp_path / "system" / "controlDict").write_text(head.format("dictionary", "controlDict") + times)
    (tmp_path / "case.foam").touch()
    check(tmp_path / "case.foam", arrays=False)


# ---- text --------------------------------------------------------------------------------------


def places(grid):
    return [grid.GetPoint(k) for k in range(grid.GetNumberOfPoints())]


def corners(grid):
    """The corners of each hexahedron, counted from one: round below, then round above."""
    return (vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8) + 1).tolist()


def words(numbers):
    return " ".join(map(str, numbers))


@pytest.mark.parametrize("suffix", [".avs", ".inp"])
def test_avs(grid, suffix, tmp_path):
    points, cells = places(grid), corners(grid)
    lines = [f"{len(points)} {len(cells)} 1 0 0"]
    lines += [f"{k} {words(point)}" for k, point in enumerate(points, 1)]
    lines += [f"{k} 1 hex {words(ids)}" for k, ids in enumerate(cells, 1)]
    lines += ["1 1", "height, m"] + [f"{k} {point[2]}" for k, point in enumerate(points, 1)]
    (tmp_path / f"file{suffix}").write_text("\n".join(lines) + "\n")
    check(tmp_path / f"file{suffix}")


def test_tecplot(grid, tmp_path):
    points, cells = places(grid), corners(grid)
    lines = ['TITLE = "cubes"', 'VARIABLES = "X", "Y", "Z", "height"']
    lines += [f"ZONE T=\"one\", N={len(points)}, E={len(cells)}, F=FEPOINT, ET=BRICK"]
    lines += [f"{words(point)} {point[2]}" for point in points] + [words(ids) for ids in cells]
    (tmp_path / "file.tec").write_text("\n".join(lines) + "\n")
    check(tmp_path / "file.tec")


@pytest.mark.parametrize("suffix", sorted(READERS))
def test_what_is_not_of_its_format_is_told(suffix, tmp_path, capfd):
    (tmp_path / f"file{suffix}").write_bytes(b"nonsense \xff\n")
    with pytest.raises(sb.FileError, match=f"file{suffix}: "):
        sb.read(tmp_path / f"file{suffix}")
    assert capfd.readouterr() == ("", "")


def test_of_a_folder_what_cannot_be_written_alike_becomes_vtp(grid, surface, tmp_path):
    (tmp_path / "in").mkdir()
    written(vtkExodusIIWriter(), grid, tmp_path / "in" / "a.ex2")
    sb.write(surface, tmp_path / "in" / "b.stl")
    assert main(f"resolve {tmp_path}/in -o {tmp_path}/out --quiet".split()) == 0
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["a.vtp", "b.stl"]
