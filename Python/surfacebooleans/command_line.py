# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: files in, files out, one line for each; and whole folders."""

import argparse
import contextlib
import json
import math
import os
import pathlib
import re
import sys
import time
import warnings
from typing import NamedTuple

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkDataObject

from surfacebooleans.commands import COMMANDS, FILES
from surfacebooleans.errors import FileError, SurfaceBooleansError, SurfaceBooleansWarning
from surfacebooleans.files import CAD_FILES, is_writable, read, read_nurbs, readable_suffixes, stem_and_ending, suffix_of, write
from surfacebooleans.measures import measure
from surfacebooleans.meshes import fields_of

PROGRAM = "surfacebooleans"
DONE, NO_RESULT, WRONG_CALL, BAD_FILE, INTERRUPTED = 0, 1, 2, 3, 130

GENERAL = """\
Exact Boolean operations, curves, distances and clips of surfaces in files.

  %(prog)s difference plate.stl drill.stl -o drilled.stl
  %(prog)s union parts/ stand.stl -o results/         each file of a folder with the same tool
  %(prog)s clip brain.ply --plane 0 0 0  1 0 0 -o half.ply --json report.json
  %(prog)s distance scan.xyz part.stl -o deviation.vtp
"""

FORMATS = """\
formats: .vtk .vtp .stl .ply .obj (read and written); .vtu .vti .vts .vtr .vtm .vtpc .gltf .glb .byu .g (read); of
simulations .e .ex2 .exo .case .cgns .foam .tec .avs .xdmf, of grids the boundary; .mha .mhd .nii (images); .xyz .pwn
.pts .txt .csv .asc (lists of points, with normals if there are six columns); .step .stp .iges .igs (CAD; only .step and
.stp are written, where the surfaces are exact); with meshio installed .off .msh .inp .med and more; single files of all
other formats that ParaView opens, such as .pvd. .vtk and .vtp keep all digits and arrays; .stl and .ply store 32-bit
numbers, which leaves a closed surface closed.

exit status: 0 done (there may have been warnings); 1 the filter has no result for such input; 2 wrong call; 3 a file
could not be read or written; 130 interrupted. Of a folder the other files are still done, and the status is the
highest.
"""


def main(words=None):
    """Run the command line.

    Parameters
    ----------
    words : list of str, optional
        The arguments; those of the program by default.

    Returns
    -------
    int
        The exit status.
    """
    arguments = _parser().parse_args(words)
    try:
        return _Batch(arguments).run()
    except KeyboardInterrupt:
        _say("interrupted; no file was left half written")
        return INTERRUPTED


# ---- the arguments -----------------------------------------------------------------------------


class _Parser(argparse.ArgumentParser):
    """Takes -1e-3 for a number, not for an option."""

    def __init__(self, **settings):
        super().__init__(**settings)
        self._negative_number_matcher = re.compile(r"^-(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")


def _parser():
    layout = {"formatter_class": argparse.RawDescriptionHelpFormatter, "epilog": FORMATS}
    parser = _Parser(prog=PROGRAM, description=GENERAL % {"prog": PROGRAM}, **layout)
    subparsers = parser.add_subparsers(metavar="command", dest="command", required=True)
    for command in COMMANDS:
        added = subparsers.add_parser(command.name, help=command.summary, description=command.description, **layout)
        for name in FILES[command.files]:
            count = name[-1] if name[-1] in "?*+" else None
            role = "a file, or a folder: then all files in it, one by one" if name == "file" else "further files"
            added.add_argument(name.rstrip("?*+"), metavar=name.rstrip("?*+").upper(), nargs=count, help=role)
        added.add_argument("-o", "--output", required=True, metavar="FILE", help="the result (for a folder: a folder)")
        command.arguments(added)
        _add_common(added)
        added.set_defaults(chosen=command, parser=added)
    return parser


def _add_common(parser):
    parser.add_argument(
        "--format",
        metavar="ENDING",
        help="of the files written into a folder, such as .vtp (that of the input, if it can be written)",
    )
    parser.add_argument(
        "--cad-error",
        type=float,
        default=1e-3,
        metavar="SHARE",
        help="how far facets of CAD files may be from their surfaces, as a share of the whole (0.001)",
    )
    parser.add_argument(
        "--json", metavar="FILE", help="write a report: sizes, volume, area, closed, times (-: print it)"
    )
    parser.add_argument("--threads", type=int, default=0, metavar="N", help="0: one a core; the result is the same (0)")
    parser.add_argument("--progress", action="store_true", help="show a bar (needs tqdm)")
    parser.add_argument("--quiet", action="store_true", help="say nothing but warnings and errors")


# ---- the work ----------------------------------------------------------------------------------


class _Batch:
    """One file, or all files of a folder."""

    def __init__(self, arguments):
        self.arguments = arguments
        self.folder = pathlib.Path(arguments.file) if os.path.isdir(arguments.file) else None
        self.output = arguments.output
        self.others = []  # what is the same for all files
        self.reports = []
        self.status = DONE

    def run(self):
        self._check_call()
        tools = getattr(self.arguments, "tool", None) or getattr(self.arguments, "other", None) or []
        try:
            self.others = [self._source(path) for path in ([tools] if isinstance(tools, str) else tools)]
            files = self._files()
        except SurfaceBooleansError as error:
            return self._failed(error)
        for path in files:
            self._one(path)
        return self._report()

    def _check_call(self):
        arguments = self.arguments
        if self.folder is None:
            return
        extra = [
            n
            for n in ("curves", "second", "outline", "split_file", "split_tool", "points")
            if getattr(arguments, n, None)
        ]
        if extra:
            arguments.parser.error(f"--{extra[0].replace('_', '-')} is for one file, but {self.folder} is a folder")
        if os.path.abspath(arguments.output) == os.path.abspath(self.folder):
            arguments.parser.error("the results would replace the files of the folder; give another folder with -o")

    def _files(self):
        if self.folder is None:
            return [pathlib.Path(self.arguments.file)]
        files = sorted(path for path in self.folder.iterdir() if suffix_of(path) in readable_suffixes())
        if not files:
            raise FileError(f"{self.folder}: no file in this folder has a format that can be read")
        try:
            os.makedirs(self.output, exist_ok=True)
        except OSError as error:
            raise FileError(f"{self.output}: {error.strerror}") from error
        return files

    def _one(self, path):
        """Read, compute, write and report one file; errors are told and counted."""
        if self.folder:
            stem, ending = stem_and_ending(path)
            if self.arguments.format:
                ending = "." + self.arguments.format.lstrip(".")
            elif not is_writable(ending.lower()):
                ending = ".vtp"
            self.arguments.output = str(pathlib.Path(self.output, stem + ending))
        report = {"command": self.arguments.command, "inputs": [], "outputs": [], "warnings": [], "error": None}
        self.reports.append(report)
        try:
            with _warnings_told(report["warnings"], self._place(path)):
                self._compute(path, report)
        except (SurfaceBooleansError, ModuleNotFoundError) as error:
            self._failed(error, report, self._place(path))
        except (TypeError, ValueError, OverflowError) as error:  # a setting that does not fit its type
            self._failed(error, report, self._place(path))
        except MemoryError:
            self._failed(SurfaceBooleansError("the result does not fit into memory"), report, self._place(path))

    def _source(self, path):
        is_cad = suffix_of(path) in CAD_FILES
        data = read_nurbs(path, self.arguments.cad_error) if is_cad else read(path)
        return _Source(data, {"file": str(path), **measure(data)})

    def _compute(self, path, report):
        arguments, watch = self.arguments, _Stopwatch()
        sources = [self._source(path), *self.others]
        report["inputs"] = [source.described for source in sources]
        report["seconds"] = {"read": watch.lap()}
        common = {"threads": arguments.threads, "progress": arguments.progress}
        results = arguments.chosen.recipe(arguments, [source.data for source in sources], common)
        report["seconds"]["compute"] = watch.lap()
        results = {file: data for file, data in results.items() if file is not None}
        for file, data in results.items():
            write(data, file)
        report["seconds"]["write"] = watch.lap()
        report["outputs"] = [{"file": file, **measure(data)} for file, data in results.items()]
        report["fields"] = fields_of(results[arguments.output])
        for output in report["outputs"]:
            self._tell(output, report)

    def _tell(self, output, report):
        if not self.arguments.quiet and self.arguments.json != "-":
            print(f"{output['file']}: {_in_words(output)} ({report['seconds']['compute']:.3f} s)")

    def _place(self, path):
        """What a message starts with: the file, if there are several and the message does not name it."""
        return f"{path}: " if self.folder else ""

    def _failed(self, error, report=None, place=""):
        _say(f"error: {'' if isinstance(error, FileError) else place}{error}")
        if report is not None:
            report["error"] = str(error)
        status = BAD_FILE if isinstance(error, FileError) else NO_RESULT
        self.status = max(self.status, WRONG_CALL if isinstance(error, ModuleNotFoundError) else status)
        return self.status

    def _report(self):
        if not self.arguments.json:
            return self.status
        text = json.dumps({"status": self.status, "results": _plain(self.reports)}, indent=2)
        if self.arguments.json == "-":
            print(text)
            return self.status
        try:
            pathlib.Path(self.arguments.json).write_text(text + "\n", encoding="utf-8")
        except OSError as error:
            self._failed(FileError(f"{self.arguments.json}: cannot be written: {error.strerror}"))
        return self.status


class _Source(NamedTuple):
    """A file that was read."""

    data: vtkDataObject
    described: dict


class _Stopwatch:
    def __init__(self):
        self.last = time.perf_counter()

    def lap(self):
        """Seconds since the last call."""
        before, self.last = self.last, time.perf_counter()
        return self.last - before


@contextlib.contextmanager
def _warnings_told(sentences, place):
    """Tell the filters' warnings in one line each, and keep them."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", SurfaceBooleansWarning)
        try:
            yield
        finally:
            for warning in caught:
                if issubclass(warning.category, SurfaceBooleansWarning):
                    sentences.append(str(warning.message))
                    _say(f"warning: {place}{warning.message}")


def _say(text):
    print(f"{PROGRAM}: {text}", file=sys.stderr)


def _in_words(measured):
    """Such as "1,200 polygons, closed, area 6, volume 1"."""
    parts = [f"{measured[name]:,} {name}" for name in ("polygons", "lines") if measured.get(name)]
    parts = parts or [f"{measured['points']:,} points" if measured["points"] else "nothing: the result is empty"]
    if "closed" in measured:
        parts.append("closed" if measured["closed"] else "open")
        parts.append(f"area {measured['area']:.9g}")
        parts += [f"volume {measured['volume']:.9g}"] if measured["closed"] else []
    return ", ".join(parts)


def _plain(value):
    """A report in what JSON knows; it has no NaN and no infinity."""
    if isinstance(value, dict):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [_plain(item) for item in value]
    if isinstance(value, np.generic):
        value = value.item()
    return None if isinstance(value, float) and not math.isfinite(value) else value
