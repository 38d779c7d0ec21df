# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads and writes meshes and clouds: by VTK where it knows the format, by meshio (if it is installed) where not.

Which formats keep what: .vtk and .vtp keep all digits, arrays, lines and points; .stl and .ply hold surfaces (.ply
clouds, too) in 32-bit numbers, without arrays; .obj surfaces and lines; .vti images.
"""

import contextlib
import os
import pathlib
import re
import tempfile

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkDataSetWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLImageDataWriter, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridReader

from surfacebooleans import vtk as classes
from surfacebooleans.appended_xml import has_appended_data, inlined
from surfacebooleans.errors import FileError, SurfaceBooleansError
from surfacebooleans.meshes import as_data, points_of, polydata
from surfacebooleans.ply import read_ply
from surfacebooleans.running import configure, update
from surfacebooleans.vtk_formats import READERS, reader_of, select_all_arrays

OWN_READERS = {".ply": read_ply}
POINT_LISTS = (".asc", ".csv", ".pts", ".pwn", ".txt", ".xyz")
WRITERS = {
    ".ply": vtkPLYWriter,
    ".stl": vtkSTLWriter,
    ".vti": vtkXMLImageDataWriter,
    ".vtk": vtkDataSetWriter,
    ".vtp": vtkXMLPolyDataWriter,
}
CAD_FILES = (".iges", ".igs", ".step", ".stp")
HAS_CAD = hasattr(classes, "vtkNURBSReader")  # else this was built without Open CASCADE
if HAS_CAD:
    WRITERS.update(dict.fromkeys((".step", ".stp"), classes.vtkNURBSWriter))
XDMF = (".xdmf", ".xmf")
SURFACES_ONLY = (".stl", ".step", ".stp")


def readable_suffixes():
    """The endings of all files that `read` takes, in lower case; those of meshio only if it is installed."""
    return sorted({*READERS, *OWN_READERS, *POINT_LISTS, *(CAD_FILES if HAS_CAD else ()), *_suffixes_of_meshio()})


def is_writable(suffix):
    """Whether `write` knows the format of such an ending, in lower case."""
    return suffix in WRITERS or suffix == ".obj" or suffix in _suffixes_of_meshio()


def suffix_of(path):
    """What tells a file's format: its ending in lower case, of two parts where that is one (.vol.gz)."""
    suffixes = [suffix.lower() for suffix in pathlib.Path(path).suffixes[-2:]]
    return "".join(suffixes) if suffixes[-1:] == [".gz"] else "".join(suffixes[-1:])


def stem_and_ending(path):
    """A file's name before what tells its format, and that as it is written there."""
    name = pathlib.Path(path).name
    length = len(name) - len(suffix_of(path))
    return name[:length], name[length:]


def read(path):
    """Read a mesh, a cloud of points or an image.

    Parameters
    ----------
    path : str or path-like
        The ending tells the format. VTK reads .vtk .vtp .vtu .vti .vts .vtr .vtm .vtpc and others of its own, .stl .ply
        .obj .gltf .glb .byu .g, of simulations .e .ex2 .exo (Exodus) .case (EnSight) .cgns .foam .tec (Tecplot) .avs
        .xdmf, and the images .mha .mhd .nii; .xyz .pwn .pts .txt .csv .asc are lists of points, with normals if there
        are six columns; .step .stp .iges .igs are read as `read_nurbs` does; meshio, if it is installed, reads .off
        .msh .inp .med .mesh .bdf and more. What none of these knows is read as ParaView would do in its window: .pvd,
        .cas (Fluent), .gml and others. Of several time steps the first one is read. `surfacebooleans.vtk_formats` has
        the list of VTK's formats.

    Returns
    -------
    vtkDataObject
        As it stands in the file: vtkPolyData for surfaces and clouds, other data sets for .vtu, .vti, .vtm and so on.

    Raises
    ------
    FileError
        If there is no such file, or if it holds nothing that can be read.
    """
    path = pathlib.Path(path)
    suffix = suffix_of(path)
    if suffix in CAD_FILES:
        return read_nurbs(path)
    if suffix in OWN_READERS:
        return _read(path, lambda: OWN_READERS[suffix](path))
    return _read(path, lambda: _read_points(path) if suffix in POINT_LISTS else _read_by_vtk_or_meshio(path, suffix))


def read_nurbs(path, chord_error=1e-3):
    """Read a CAD file: facets, and the exact surfaces (rational B-splines) behind them, for the point set recipes.

    Parameters
    ----------
    path : str or path-like
        A .step, .stp, .iges or .igs file.
    chord_error : float, optional
        How far facets may be from their surfaces, as a share of the diagonal of the whole.

    Returns
    -------
    vtkPolyData
        In millimetres. Cell arrays ``FaceId`` and ``SolidId``, point array ``UV``; the field data have the surfaces
        and, among others, ``NumberOfSolids``, ``Closed`` and the measured ``ChordError``.

    Raises
    ------
    FileError
        If the file cannot be read.

    Warns
    -----
    SurfaceBooleansWarning
        If the facets are not closed, or some faces not exact.

    References
    ----------
    L. Piegl, W. Tiller, "The NURBS Book", 2nd edition, Springer, 1997.
    """
    path = pathlib.Path(path)
    if suffix_of(path) not in CAD_FILES:
        raise FileError(f"{path}: CAD files end in {', '.join(CAD_FILES)}")
    if not HAS_CAD:
        raise FileError(f"{path}: this build reads no CAD files; it was made without Open CASCADE")
    reader = configure(classes.vtkNURBSReader(), FileName=str(path), ChordError=chord_error)
    return _read(path, lambda: _updated(reader))


def write(data, path):
    """Write a mesh, curves, a cloud or an image. The file appears when it is complete.

    Parameters
    ----------
    data : mesh
        `surfacebooleans.meshes` says what that is.
    path : str or path-like
        The ending tells the format: .vtk, .vtp, .stl, .ply, .obj, .vti; .step and .stp for facets that have exact
        surfaces; with meshio also .off, .msh and more.

    Raises
    ------
    FileError
        If the format is not known or cannot hold the data, or the file cannot be written.
    """
    path, data = pathlib.Path(path), as_data(data)
    suffix = suffix_of(path)
    _check_format(path, data)
    # The name of the unfinished file ends alike, because meshio goes by it.
    unfinished = path.with_name(f".{stem_and_ending(path)[0]}.unfinished{suffix}")
    try:
        unfinished.touch()
        if suffix in WRITERS:
            _write_by_vtk(unfinished, data, WRITERS[suffix]())
        elif suffix == ".obj":
            _write_obj(unfinished, data)
        else:
            _write_by_meshio(unfinished, data)
        os.replace(unfinished, path)
    except (SurfaceBooleansError, OSError, ValueError) as error:
        text = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise FileError(f"{path}: cannot be written: {text}") from error
    finally:
        with contextlib.suppress(OSError):
            unfinished.unlink()


def _read(path, reading):
    """The data of a file; whatever goes wrong is told with the file's name."""
    if not path.is_file():
        raise FileError(f"{path}: there is no such file")
    try:
        data = reading()
    except FileError:
        raise
    except (SurfaceBooleansError, OSError, ValueError) as error:
        raise FileError(f"{path}: {error}") from error
    if data is None or data.GetNumberOfElements(vtkDataObject.POINT) == 0:
        raise FileError(f"{path}: no points in it; is it a {suffix_of(path)} file?")
    return data


# ---- VTK ---------------------------------------------------------------------------------------


@contextlib.contextmanager
def _messages_caught():
    """What VTK's readers have to say beyond what their listeners hear is an error, too, and not for the terminal."""
    usual, caught = vtkOutputWindow.GetInstance(), vtkStringOutputWindow()
    verbosity = vtkLogger.ConvertToVerbosity(vtkLogger.GetCurrentVerbosityCutoff())
    vtkOutputWindow.SetInstance(caught)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        yield
    finally:
        vtkOutputWindow.SetInstance(usual)
        vtkLogger.SetStderrVerbosity(verbosity)
    text = caught.GetOutput()  # bytes where it is no text, as in what is quoted of a damaged file
    text = text.decode(errors="replace") if isinstance(text, bytes) else text
    error = re.search(r"ERROR: In .*\n\w+ \(\w+\): (.*)", text)
    if error:
        raise SurfaceBooleansError(error.group(1))


def _read_by_vtk_or_meshio(path, suffix):
    if suffix in XDMF and _meshio():
        with contextlib.suppress(FileError):  # without h5py it reads none with arrays in a file of their own
            return _read_by_meshio(path)
    reader = reader_of(path, suffix)
    if reader:
        return _read_by_vtk(path, suffix, reader)
    if suffix in _suffixes_of_meshio():
        return _read_by_meshio(path)
    data = _read_by_paraview(path)
    if data:
        return data
    raise FileError(
        f"{path}: the format {suffix or 'without an ending'} is not known; these are: "
        f"{' '.join(readable_suffixes())}{_hint_at_meshio()}"
    )


def _read_by_vtk(path, suffix, reader):
    if suffix == ".stl":
        _check_length_of_stl(path)
    if suffix == ".vtk":
        _check_head_of_vtk(path)
    if suffix.startswith(".vt") and has_appended_data(path):
        reader.ReadFromInputStringOn()
        reader.SetInputString(inlined(path.read_bytes()))

    def read_all():
        reader.UpdateInformation()
        select_all_arrays(reader)
        reader.Update()

    return _updated(reader, read_all)


def _updated(reader, work=None):
    with _messages_caught():
        update(reader, work=work)
    return reader.GetOutputDataObject(0)


def _check_length_of_stl(path):
    """A binary STL file that was cut off; vtkSTLReader takes what is there without a word."""
    with open(path, "rb") as file:
        head = file.read(84)
    if head.lstrip()[:5].lower() == b"solid" or len(head) < 84:
        return
    promised, present = int.from_bytes(head[80:], "little"), (path.stat().st_size - 84) // 50
    if present < promised:
        raise FileError(f"{path}: the file ends after {present:,} of {promised:,} triangles")


def _check_head_of_vtk(path):
    """vtkDataSetReader ends the program where the version is no number."""
    with open(path, "rb") as file:
        if not re.match(rb"# vtk DataFile Version \d+\.\d+\s", file.read(64)):
            raise FileError(f"{path}: it has no head of a VTK file")


def _check_format(path, data):
    suffix = suffix_of(path)
    if not is_writable(suffix):
        known = " ".join(sorted({*WRITERS, ".obj"}))
        raise FileError(
            f"{path}: the format {suffix or 'without an ending'} cannot be written; these can: {known}{_hint_at_meshio()}"
        )
    if isinstance(data, vtkImageData) != (suffix == ".vti") and suffix != ".vtk":
        holds = "images only" if suffix == ".vti" else "no images"
        raise FileError(f"{path}: {suffix} holds {holds}; choose .{'vtp' if suffix == '.vti' else 'vti'} or .vtk")
    if suffix in SURFACES_ONLY and data.GetNumberOfPolys() == 0 and data.GetNumberOfCells() > 0:
        raise FileError(
            f"{path}: {suffix} holds surfaces only, and these are lines or points; choose .vtp, .vtk or .ply"
        )


def _write_by_vtk(path, data, writer):
    if hasattr(writer, "SetDataModeToBinary"):
        writer.SetDataModeToBinary()  # not appended, which VTK 9.2 cannot read back where expat is newer
    elif hasattr(writer, "SetFileTypeToBinary"):
        writer.SetFileTypeToBinary()
    writer.SetFileName(str(path))
    writer.SetInputDataObject(data)
    update(writer, work=writer.Write)


def _write_obj(path, data):
    """Points with all their digits, where vtkOBJWriter has six."""
    with open(path, "w", encoding="ascii") as file:
        np.savetxt(file, points_of(data), fmt="v %.17g %.17g %.17g")
        for letter, cells in (("f", data.GetPolys()), ("l", data.GetLines())):
            ids = vtk_to_numpy(cells.GetConnectivityArray()) + 1
            offsets = vtk_to_numpy(cells.GetOffsetsArray())
            for begin, end in zip(offsets[:-1], offsets[1:]):
                file.write(f"{letter} {' '.join(map(str, ids[begin:end]))}\n")


# ---- ParaView ----------------------------------------------------------------------------------


def _read_by_paraview(path):
    """By the reader that ParaView would choose in its window; None if it has none."""
    try:
        from paraview import servermanager, simple
    except ImportError:
        return None
    with _messages_caught():
        try:
            reader = simple.OpenDataFile(str(path))
        except RuntimeError:
            return None
        if not reader:
            return None
        try:
            reader.UpdatePipeline()
            return servermanager.Fetch(reader)
        finally:
            simple.Delete(reader)


# ---- lists of points ---------------------------------------------------------------------------


def _read_points(path):
    """A point a line: x y z, or x y z and its normal; spaces or commas between them. A first line that is not such, a
    header or the number of points, is passed over."""
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = [line for line in file if line.strip() and line.lstrip()[0] not in "#/"]
    delimiter = "," if lines and "," in lines[-1] else None
    numbers = len(lines[-1].split(delimiter)) if lines else 0
    if lines and not _are_numbers(lines[0].split(delimiter), numbers):
        lines = lines[1:]
    table = np.loadtxt(lines, delimiter=delimiter, ndmin=2) if lines else np.zeros((0, 3))
    if table.shape[1] < 3:
        raise ValueError("each line has to have the three coordinates of a point")
    return polydata(table[:, :3], normals=table[:, 3:6] if table.shape[1] == 6 else None)


def _are_numbers(words, count):
    with contextlib.suppress(ValueError):
        return len(words) == count and bool([float(word) for word in words])
    return False


# ---- meshio ------------------------------------------------------------------------------------


def _meshio():
    try:
        import meshio
    except ImportError:
        return None
    return meshio


def _hint_at_meshio():
    """The end of a sentence on a format that is not known."""
    return "" if _meshio() else "; with meshio there are more (pip install meshio)"


def _suffixes_of_meshio():
    meshio = _meshio()
    return tuple(meshio.extension_to_filetypes) if meshio else ()


def _read_by_meshio(path):
    """By way of a .vtu file, which both know."""
    meshio = _meshio()
    with tempfile.TemporaryDirectory() as folder:
        between = pathlib.Path(folder, "mesh.vtu")
        try:
            with contextlib.redirect_stdout(None), contextlib.redirect_stderr(None):
                meshio.write(between, meshio.read(path))
        except (Exception, SystemExit) as error:  # its readers fail in every way, and some end the program
            raise FileError(f"{path}: meshio cannot read it: {error}") from error
        return _updated(configure(vtkXMLUnstructuredGridReader(), FileName=str(between)))


def _write_by_meshio(path, data):
    """Triangles and segments, with all arrays of numbers."""
    cutter = vtkTriangleFilter()
    cutter.SetInputData(data)
    cutter.PassVertsOff()
    cutter.Update()
    simple = cutter.GetOutput()
    cells = [
        (kind, vtk_to_numpy(part.GetConnectivityArray()).reshape(-1, size))
        for kind, part, size in (("line", simple.GetLines(), 2), ("triangle", simple.GetPolys(), 3))
        if part.GetNumberOfCells()
    ]
    attributes = simple.GetPointData()
    arrays = (attributes.GetArray(k) for k in range(attributes.GetNumberOfArrays()))
    point_data = {array.GetName(): vtk_to_numpy(array) for array in arrays if array and array.GetName()}
    meshio = _meshio()
    try:
        with contextlib.redirect_stdout(None), contextlib.redirect_stderr(None):
            meshio.write(path, meshio.Mesh(points_of(simple).astype(float), cells, point_data=point_data))
    except (Exception, SystemExit) as error:
        raise FileError(f"meshio cannot write it: {error}") from error
