# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How scripts of the workflow say what users have to correct."""


class Failure(Exception):
    """Valid usage that failed; the message names the file or the word, and the remedy."""
