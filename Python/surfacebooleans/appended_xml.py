# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""Files of VTK's XML formats with *appended* data, as ParaView writes them, turned into ones without.

VTK 9.2 cannot read such files where the expat library is a newer one (2.6, or 2.5.0 with Debian's security fixes): "not
well-formed (invalid token)", and nothing is read. With the arrays inline, where they are used, it can.
The format: VTK File Formats, "XML File Formats", https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
"""

import base64
import re

ARRAY = re.compile(rb'<(?:DataArray|Array)\b[^>]*?\bformat="appended"[^>]*?>', re.DOTALL)
APPENDED = re.compile(rb'<AppendedData\s+encoding="(\w+)"\s*>\s*_')


def has_appended_data(path):
    """Whether a file is one of VTK's XML formats with appended data."""
    with open(path, "rb") as file:
        if b"<VTKFile" not in file.read(1000):
            return False
        file.seek(0)
        return b"<AppendedData" in file.read()


def inlined(text):
    """The same file with each array where it is used.

    Parameters
    ----------
    text : bytes
        The content of the file.

    Raises
    ------
    ValueError
        If the file ends within the data.
    """
    place = APPENDED.search(text)
    if not place:
        raise ValueError("the file ends within its head")
    head, data, encoding = text[: place.start()], text[place.end() :], place.group(1)
    word = 8 if b'header_type="UInt64"' in head else 4
    order = "big" if b'byte_order="BigEndian"' in head else "little"
    compressed = b"compressor=" in head
    reader = _raw_block if encoding == b"raw" else _base64_block

    def inline(match):
        tag = match.group(0)
        offset = re.search(rb'\boffset="(\d+)"', tag)
        if not offset:
            raise ValueError("an array in it does not say where its data are")
        tag = re.sub(rb'\boffset="\d+"', b"", tag).replace(b'format="appended"', b'format="binary"')
        content = reader(data, int(offset.group(1)), word, order, compressed)
        name = re.match(rb"<(\w+)", tag).group(1)
        return (
            tag.rstrip(b"/>").rstrip()
            + b">"
            + content
            + (b"</" + name + b">" if match.group(0).endswith(b"/>") else b"")
        )

    return ARRAY.sub(inline, head) + b"</VTKFile>\n"


def _raw_block(data, offset, word, order, compressed):
    """A block of bytes as base64. Of a compressed one, header and content are encoded each for itself."""
    numbers = _numbers(data[offset : offset + 3 * word], word, order)
    if not numbers:
        raise ValueError("the file ends within its data")
    if not compressed:
        stop = offset + word + numbers[0]
        return base64.b64encode(_piece(data, offset, stop))
    content = offset + (3 + numbers[0]) * word
    sizes = _numbers(_piece(data, offset + 3 * word, content), word, order)
    return base64.b64encode(data[offset:content]) + base64.b64encode(_piece(data, content, content + sum(sizes)))


def _base64_block(data, offset, word, order, compressed):
    """A block that is base64 already: how long it is, its header tells."""
    if not compressed:
        size = _numbers(base64.b64decode(_piece(data, offset, offset + _encoded(word))), word, order)[0]
        return _piece(data, offset, offset + _encoded(word + size))
    blocks = _numbers(base64.b64decode(_piece(data, offset, offset + _encoded(3 * word))), word, order)[0]
    content = offset + _encoded((3 + blocks) * word)
    sizes = _numbers(base64.b64decode(_piece(data, offset, content)), word, order)[3:]
    return _piece(data, offset, content + _encoded(sum(sizes)))


def _encoded(size):
    """How many characters so many bytes take in base64."""
    return (size + 2) // 3 * 4


def _numbers(data, word, order):
    return [int.from_bytes(data[at : at + word], order) for at in range(0, len(data) - word + 1, word)]


def _piece(data, begin, end):
    if end > len(data):
        raise ValueError("the file ends within its data")
    return data[begin:end]
