# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The readers of VTK by the endings of their files. A module of VTK is imported when a file asks for it."""

import importlib
import re

READERS = {
    ".avs": "vtkIOGeometry.vtkAVSucdReader",
    ".byu": "vtkIOGeometry.vtkBYUReader",
    ".case": "vtkIOEnSight.vtkGenericEnSightReader",
    ".cgns": "vtkIOCGNSReader.vtkCGNSReader",
    ".e": "vtkIOExodus.vtkExodusIIReader",
    ".encas": "vtkIOEnSight.vtkGenericEnSightReader",
    ".ex2": "vtkIOExodus.vtkExodusIIReader",
    ".exo": "vtkIOExodus.vtkExodusIIReader",
    ".foam": "vtkIOGeometry.vtkOpenFOAMReader",
    ".g": "vtkIOGeometry.vtkBYUReader",
    ".glb": "vtkIOGeometry.vtkGLTFReader",
    ".gltf": "vtkIOGeometry.vtkGLTFReader",
    ".hdf": "vtkIOHDF.vtkHDFReader",
    ".mha": "vtkIOImage.vtkMetaImageReader",
    ".mhd": "vtkIOImage.vtkMetaImageReader",
    ".nii": "vtkIOImage.vtkNIFTIImageReader",
    ".obj": "vtkIOGeometry.vtkOBJReader",
    ".pvti": "vtkIOXML.vtkXMLPImageDataReader",
    ".pvtp": "vtkIOXML.vtkXMLPPolyDataReader",
    ".pvtr": "vtkIOXML.vtkXMLPRectilinearGridReader",
    ".pvts": "vtkIOXML.vtkXMLPStructuredGridReader",
    ".pvtu": "vtkIOXML.vtkXMLPUnstructuredGridReader",
    ".stl": "vtkIOGeometry.vtkSTLReader",
    ".tec": "vtkIOGeometry.vtkTecplotReader",
    ".vti": "vtkIOXML.vtkXMLImageDataReader",
    ".vtk": "vtkIOLegacy.vtkDataSetReader",
    ".vtkhdf": "vtkIOHDF.vtkHDFReader",
    ".vtm": "vtkIOXML.vtkXMLMultiBlockDataReader",
    ".vtmb": "vtkIOXML.vtkXMLMultiBlockDataReader",
    ".vtp": "vtkIOXML.vtkXMLPolyDataReader",
    ".vtpc": "vtkIOXML.vtkXMLPartitionedDataSetCollectionReader",
    ".vtpd": "vtkIOXML.vtkXMLPartitionedDataSetReader",
    ".vtr": "vtkIOXML.vtkXMLRectilinearGridReader",
    ".vts": "vtkIOXML.vtkXMLStructuredGridReader",
    ".vtu": "vtkIOXML.vtkXMLUnstructuredGridReader",
    ".xdmf": "vtkIOXdmf2.vtkXdmfReader",
    ".xmf": "vtkIOXdmf2.vtkXdmfReader",
}
HDF, NETCDF = b"\x89HDF", b"CDF"
HEADS = {  # how files have to begin whose readers, or the libraries behind them, print or end the program otherwise
    ".cgns": (HDF, b"@(#)ADF"),
    ".e": (HDF, NETCDF),
    ".ex2": (HDF, NETCDF),
    ".exo": (HDF, NETCDF),
    ".mha": (b"ObjectType", b"NDims"),
    ".mhd": (b"ObjectType", b"NDims"),
    ".xdmf": (b"<",),
    ".xmf": (b"<",),
}
FILE_NAME_SETTERS = ("SetFileName", "SetCaseFileName")
KINDS_OF_ARRAYS = ("Point", "Cell", "PointResult", "ElementResult")


def reader_of(path, suffix):
    """A reader of VTK for a file, which reads all of its arrays.

    Parameters
    ----------
    path : pathlib.Path
    suffix : str
        The ending that tells the format.

    Returns
    -------
    vtkAlgorithm or None
        None where VTK has no reader of such files, or this VTK is without it.

    Raises
    ------
    ValueError
        If the file is none of its format.
    """
    with open(path, "rb") as file:
        head = file.read(2000)
    suffix = _format(suffix, head)
    name = READERS.get(suffix)
    if not name:
        return None
    if suffix in HEADS and not head.startswith(HEADS[suffix]):
        raise ValueError(f"it has not the head of a {suffix} file")
    module, name = name.split(".")
    try:
        reader = getattr(importlib.import_module(f"vtkmodules.{module}"), name)()
    except (ImportError, AttributeError):
        return None
    setter = next(setter for setter in FILE_NAME_SETTERS if hasattr(reader, setter))
    getattr(reader, setter)(str(path))
    return reader


def select_all_arrays(reader):
    """Ask for all arrays, of which some readers leave out the most. To be called after UpdateInformation."""
    for kind in KINDS_OF_ARRAYS:
        if hasattr(reader, f"GetNumberOf{kind}Arrays"):
            for k in range(getattr(reader, f"GetNumberOf{kind}Arrays")()):
                getattr(reader, f"Set{kind}ArrayStatus")(getattr(reader, f"Get{kind}ArrayName")(k), 1)


def _format(suffix, head):
    """The ending that a file should have: two formats each are called .g (BYU, Exodus) and .inp (Abaqus, AVS)."""
    if suffix == ".g" and head.startswith((HDF, NETCDF)):
        return ".e"
    if suffix == ".inp" and re.match(rb"(\s*#.*\n)*\s*\d+\s+\d+\s+\d+\s+\d+\s+\d+\s", head):
        return ".avs"
    return suffix
