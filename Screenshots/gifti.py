# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads the surfaces of brains that nilearn comes with (pip install --no-deps nilearn), with numpy alone."""

import base64
import gzip
import zlib
from xml.etree import ElementTree

import numpy as np

TYPES = {"NIFTI_TYPE_FLOAT32": "f4", "NIFTI_TYPE_INT32": "i4"}


def read_gifti(path):
    """Points (n, 3) and triangles (m, 3) of a .gii.gz file."""
    with gzip.open(path) as file:
        root = ElementTree.parse(file).getroot()
    arrays = []
    for element in root.iter("DataArray"):
        order = "<" if element.get("Endian") == "LittleEndian" else ">"
        data = zlib.decompress(base64.b64decode(element.find("Data").text))
        shape = int(element.get("Dim0")), int(element.get("Dim1"))
        arrays.append(np.frombuffer(data, order + TYPES[element.get("DataType")]).reshape(shape))
    return arrays[0].astype(float), arrays[1].astype(np.int32)
