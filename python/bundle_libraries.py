#!/usr/bin/env python3
# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a wheel that runs on other Linux systems: copies the shared libraries that these may lack,
with their licences, and names the oldest C library that suffices (needs patchelf and binutils).

    bundle_libraries.py WHEEL FOLDER    # writes the new wheel to the folder, and says its name
"""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

BUNDLED = re.compile(r"lib(gmp|mpfr)\.so\.\d+")
# What every system has: the policy `manylinux` allows these.
EVERYWHERE = re.compile(r"lib(c|m|gcc_s|stdc\+\+|pthread|dl|rt)\.so\.\d+|ld-linux.*")
# Of the bundled libraries, and of what was compiled in.
PACKAGES = ("libgmp10", "libmpfr6", "libcgal-dev", "libeigen3-dev", "libspectra-dev",
            "libcli11-dev", "nlohmann-json3-dev", "pybind11-dev", "libjs-three", "gmp", "mpfr")
LICENCES = ("/usr/share/doc/{}/copyright", "/usr/share/licenses/{}/COPYING*",
            "/usr/share/common-licenses/*PL-[23]*")


def run(*command):
    """What a command writes."""
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


def libraries(file):
    """The path of each shared library that a file needs, by name."""
    text = run("ldd", file)
    if "not found" in text:
        sys.exit(f"{file.name} needs a library that is not found:\n{text}")
    return dict(re.findall(r"^\s*(\S+) => (/\S+)", text, re.MULTILINE))


def bundle(files, folder):
    """Copies libraries to the folder, and makes the files, and each other, find them there."""
    folder.mkdir()
    for file in files:
        for name, path in libraries(file).items():
            if BUNDLED.fullmatch(name):
                shutil.copy(path, folder / name)
            elif not EVERYWHERE.fullmatch(name):
                sys.exit(f"{file.name} needs {name}, which other systems may lack")
    for file in [*files, *folder.iterdir()]:
        up = "../" * (len(file.relative_to(folder.parent).parts) - 1)
        run("patchelf", "--set-rpath", f"$ORIGIN/{up}{folder.name}", file)


def oldest_c_library(files):
    """The version of the C library from which on all symbols are there."""
    text = "".join(run("objdump", "-T", file) for file in files)
    return max(tuple(map(int, v)) for v in re.findall(r"GLIBC_(\d+)\.(\d+)", text))


def copy_licences(folder):
    """Copies those of the libraries, as their packages have them."""
    folder.mkdir(exist_ok=True)
    for pattern in LICENCES:
        for package in PACKAGES if "{}" in pattern else [""]:
            for file in Path("/").glob(pattern.format(package).lstrip("/")):
                shutil.copy(file, folder / "-".join(filter(None, [package, file.name])))


def main(wheel, target):
    Path(target).mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        run(sys.executable, "-m", "wheel", "unpack", wheel, "--dest", temporary)
        root = next(Path(temporary).iterdir())
        files = [*root.glob("intrinsic/*.so"), *root.glob("intrinsic/programs/*")]
        for file in files:
            file.chmod(0o755)  # which unpacking forgets
        bundle(files, root / "intrinsic.libs")
        files += (root / "intrinsic.libs").iterdir()
        about = next(root.glob("*.dist-info"))
        copy_licences(about / "licenses")
        platform = "manylinux_{}_{}".format(*oldest_c_library(files))
        tags = about / "WHEEL"
        tags.write_text(re.sub(r"-linux_", f"-{platform}_", tags.read_text()))
        print(run(sys.executable, "-m", "wheel", "pack", root, "--dest-dir", target), end="")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
