# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays that users give, checked, and matrices that they get."""

import os
from reprlib import repr as shortened

import numpy as np


def expect_word(x, name, words):
    """Checks that an option is one of some words."""
    if not isinstance(x, str) or x not in words:
        offered = ", ".join(f'"{word}"' for word in words)
        raise ValueError(f"{name}={shortened(x)} does not exist; give {offered}")


def is_single(x):
    """Tells whether something is one element: no sequence, and no array with axes."""
    if type(x) in (int, float):  # `np.ndim()` takes longer than a short trace
        return True
    return not isinstance(x, (list, tuple)) and np.ndim(x) == 0


def flag(x, name):
    """Returns a bool. Words are not taken: "no" would be true."""
    if isinstance(x, (bool, np.bool_)) or type(x) is int and x in (0, 1):
        return bool(x)
    raise ValueError(f"{name} is {shortened(x)}; give True or False")


def file_name(x, name="path"):
    """Returns the name of a file, as text or as bytes."""
    try:
        path = os.fspath(x)
    except TypeError:
        raise TypeError(f"{name} is {shortened(x)}; give the name of a file") from None
    if not path:
        raise ValueError(f"{name} is empty; give the name of a file")
    return path


def number(x, name, wanted="a finite positive number", holds=lambda x: 0 < x < np.inf):
    """Returns one real number as a float.

    `holds` tells whether it may be given, and `wanted` says to users which may.
    """
    if isinstance(x, float) and holds(x):  # the usual case: all checks take longer than a trace
        return float(x)
    try:
        if is_single(x) and not isinstance(x, (str, bytes, bool, np.bool_)) and holds(float(x)):
            return float(x)
    except (TypeError, ValueError, OverflowError):
        pass
    raise ValueError(f"{name} is {shortened(x)}; give {wanted}")


def not_negative(x, name, reason=""):
    """Returns one number that is not negative, and finite. `reason` follows in the error."""
    return number(x, name, "a finite number that is not negative" + reason,
                  lambda x: 0 <= x < np.inf)


def whole(x, name, wanted="a whole number that is not negative", least=0, most=2**53):
    """Returns one whole number as an int."""
    return int(number(x, name, wanted, lambda x: least <= x <= most and x == int(x)))


def sequence(x, name, wanted):
    """Returns a list of the elements of something that is no text."""
    try:
        if not isinstance(x, (str, bytes)):
            return list(x)
        raise TypeError
    except TypeError:
        raise TypeError(f"{name} is {shortened(x)}; give {wanted}") from None


def array(x, name, kind):
    """Returns an array, of numbers of a kind if its elements are objects that can be these."""
    try:
        a = np.asarray(x)
    except ValueError as error:  # rows of different lengths
        raise ValueError(f"{name} has rows of different lengths; give an array") from error
    if a.dtype.kind == "O":
        try:
            a = a.astype(kind)
        except (TypeError, ValueError, OverflowError):
            pass
    return a


def refuse_first(a, bad, name, remedy):
    """Raises ValueError about the first element of an array that is bad, if there is one."""
    if bad.any():
        at = tuple(int(i) for i in np.argwhere(bad)[0])
        where = f"[{', '.join(map(str, at))}]" if at else ""
        raise ValueError(f"{name}{where} is {a[at]}; {remedy}")


def numbers(x, name, shape=None, may_be_infinite=False):
    """Returns finite numbers of any type as a C-contiguous array of doubles.

    `shape` is a tuple, in which None stands for any size. With `may_be_infinite`, numbers may be
    infinite, or NaN.
    """
    a = array(x, name, np.float64)
    if a.dtype.kind not in "iufb":
        raise ValueError(f"{name} has no real numbers but {a.dtype}; give an array of numbers")
    if shape is not None:
        expect_shape(a, name, shape)
    a = np.asarray(a, dtype=np.float64, order="C")  # keeps single numbers single
    if not may_be_infinite:
        finite = np.isfinite(a)
        if not np.logical_and.reduce(finite, axis=None):  # the method all() takes twice as long
            refuse_first(a, ~finite, name, "give finite numbers")
    return a


def expect_shape(a, name, shape):
    """Checks the shape of an array."""
    if a.ndim == len(shape) and all(n is None or n == m for n, m in zip(shape, a.shape)):
        return
    wanted = ", ".join("n" if n is None else str(n) for n in shape)
    wanted += "," if len(shape) == 1 else ""
    raise ValueError(f"{name} has the shape {a.shape}; give an array of the shape ({wanted})")


def indices(x, name, shape=None, count=None):
    """Returns whole numbers of any type as a C-contiguous array of int64.

    `count` says how many elements there are, whose numbers they are.
    """
    a = array(x, name, np.int64)
    if a.size == 0 and a.dtype.kind == "f":
        a = a.astype(np.int64)
    if a.dtype.kind == "f":
        whole = np.isfinite(a) & (a == np.floor(a)) & (np.abs(a) < 2**62)
        refuse_first(a, ~whole, name, "give whole numbers")
    elif a.dtype.kind == "b":
        raise ValueError(f"{name} has no whole numbers but bool; give numbers, such as "
                         "np.flatnonzero() of it")
    elif a.dtype.kind not in "iu":
        raise ValueError(f"{name} has no whole numbers but {a.dtype}; give an array of integers")
    if shape is not None:
        expect_shape(a, name, shape)
    if a.dtype == np.uint64 and a.size and a.max() > 2**62:
        raise ValueError(f"{name} has the number {a.max()}, which no element has")
    a = np.asarray(a, dtype=np.int64, order="C")
    if count is not None and a.size and not 0 <= a.min() <= a.max() < count:  # no array of flags
        refuse_first(a, (a < 0) | (a >= count), name, f"give numbers from 0 to {count - 1}")
    return a


def points(x, name):
    """Returns points in space, or in the plane, as an array of shape (n, 3)."""
    a = numbers(x, name)
    if a.ndim == 2 and a.shape[1] == 2:
        a = np.column_stack([a, np.zeros(len(a))])
    expect_shape(a, name, (None, 3))
    return a


def polygons(x, name, count):
    """Returns the corners of all faces, and where those of each face begin, and one entry more.

    `count` is how many vertices there are.
    """
    try:
        a = np.asarray(x)
        is_array = a.ndim == 2 and a.dtype.kind != "O"
    except ValueError:  # faces of different sizes
        is_array = False
    if is_array:
        corners = indices(a, name, count=count)
        return corners.ravel(), np.arange(len(corners) + 1) * corners.shape[1]
    listed = sequence(x, name, "an array or a list of faces")
    if listed and is_single(listed[0]):
        raise ValueError(f"{name} is a list of numbers; give an array of the shape (m, k), or a "
                         "list of faces")
    faces = [indices(face, f"{name}[{i}]", (None,), count) for i, face in enumerate(listed)]
    begins = np.zeros(len(faces) + 1, dtype=np.int64)
    np.cumsum([len(face) for face in faces], out=begins[1:])
    return np.concatenate([np.zeros(0, dtype=np.int64), *faces]), begins


def sparse(parts, symmetric=False):
    """Returns a matrix of scipy, stored by rows, of what `_core` gives."""
    from scipy.sparse import csc_matrix, csr_matrix

    data, columns, begins, shape, has_rows = parts
    by_rows = has_rows or symmetric
    m = (csr_matrix if by_rows else csc_matrix)(shape)
    m.data, m.indices, m.indptr = data, columns, begins  # scipy would look at all of them again
    return m if by_rows else m.tocsr()
