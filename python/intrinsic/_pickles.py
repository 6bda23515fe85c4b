# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How objects of `_core` are pickled and copied. `pickle` finds it before their own methods, so
that
every protocol works: by the oldest ones, pybind11 would make objects without content."""

import copyreg

from . import _core


def _surface(contents, exact, name, is_flipped, points):
    return _core.restore(contents, exact, name, is_flipped, points)


def _field(*parts):
    return _core.field_of_parts(*parts)


def _way(*parts):
    return _core.way_of_parts(parts)


def _refuse(x):
    raise TypeError(f"{type(x).__name__} cannot be pickled or copied; make it again")


copyreg.pickle(_core.Surface, lambda s: (
    _surface, (_core.dump(s), s.is_exact, s.name, s.is_flipped, s.points)))
copyreg.pickle(_core.Field, lambda f: (_field, _core.parts_of_field(f)))
copyreg.pickle(_core.Way, lambda w: (_way, _core.parts_of_way(w)))
for _kind in _core.CurveEdges, _core.DistanceMethod:
    copyreg.pickle(_kind, _refuse)
