# SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
# SPDX-License-Identifier: BSD-3-Clause
"""A few pairs of each family of `make torture`, judged by winding numbers alone."""

import pytest

import meshes
import torture

pytestmark = pytest.mark.skipif(
    not meshes.CGAL_DATA.exists(), reason="the package libcgal-demo is not installed"
)


@pytest.mark.parametrize("number", range(18))
def test_nothing_is_wrong_open_or_refused(number):
    wrong, _ = torture.verdicts(number)
    assert not wrong


def test_there_are_enough_meshes():
    assert len(torture.closed_names()) > 30
    assert len([name for name in torture.CAD_PARTS if name in torture.closed_names()]) > 5


def test_a_wrong_result_is_noticed(monkeypatch):
    """A judge that never condemns is none."""
    honest = torture.boolean

    def swapped(inputs, tools, operation, *rest):
        return honest(inputs, tools, torture.UNION if operation == torture.DIFFERENCE else operation, *rest)

    monkeypatch.setattr(torture, "boolean", swapped)
    assert "wrong inside" in torture.verdicts(0)[0]
