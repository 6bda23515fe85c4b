#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The files that describe the project to others are right: they say CMake's version, and are YAML."""

import re
import unittest
from pathlib import Path

try:
    import yaml
except ImportError:  # Debian: python3-yaml
    yaml = None

ROOT = Path(__file__).resolve().parent.parent


def first(pattern, name):
    """What a pattern finds in a file of the project first."""
    return re.search(pattern, (ROOT / name).read_text(encoding="utf-8"), re.MULTILINE)[1]


class Metadata(unittest.TestCase):
    def test_files_say_the_version_of_cmake(self):
        version = first(r"^  VERSION ([0-9.]+)$", "CMakeLists.txt")
        for name, pattern in {"CITATION.cff": r"^version: (\S+)$",
                              "CHANGELOG.md": r"^## \[(\S+)\]",
                              "debian/changelog": r"\(([0-9.]+)\)"}.items():
            self.assertEqual(first(pattern, name), version, name)

    @unittest.skipUnless(yaml, "python3-yaml is not installed")
    def test_yaml_can_be_read(self):
        files = [*(ROOT / ".github").rglob("*.yml"), ROOT / "CITATION.cff",
                 ROOT / "python" / "conda" / "meta.yaml"]
        self.assertGreater(len(files), 5)
        for file in files:
            with self.subTest(file.name):
                self.assertIsInstance(yaml.safe_load(file.read_text(encoding="utf-8")), dict)


if __name__ == "__main__":
    unittest.main()
