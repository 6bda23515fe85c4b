# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces as pages for browsers and notebooks."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from . import _arrays, _core

if TYPE_CHECKING:
    from typing import Any
    from ._types import Path


class _Pages:
    def html(self, *, megabytes: float = 30) -> str:
        """Returns a page for browsers that shows the triangulation on the surface."""
        return _core.page(self._core, _arrays.number(megabytes, "megabytes"))

    def show(self, path: Path | None = None, *, open_browser: bool = True) -> str:
        """Writes the page of `html()` to a file, by default a temporary one, and opens it."""
        import tempfile
        import webbrowser

        open_browser = _arrays.flag(open_browser, "open_browser")
        if path is None:
            handle, path = tempfile.mkstemp(suffix=".html", prefix="intrinsic-")
            os.close(handle)
        path = _arrays.file_name(path)
        with open(path, "w", encoding="utf-8") as page:
            page.write(self.html())
        if open_browser:
            webbrowser.open("file://" + os.path.abspath(path))
        return path

    def _repr_html_(self):
        if self._core.points is None:
            return None
        import html

        page = html.escape(self.html(megabytes=8), quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 480px; border: 0"></iframe>'

    def to_pyvista(self) -> Any:
        """Returns the common subdivision as a pyvista.PolyData, if PyVista is installed."""
        return self.common_subdivision().to_pyvista()
