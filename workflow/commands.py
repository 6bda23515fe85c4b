# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of a collection, with the limits of each."""

import hashlib
import math
import re
import shlex
from typing import NamedTuple

from failure import Failure


class Command(NamedTuple):
    """A command of `intrinsic`, and what it may take on one file."""

    text: str
    time_limit: float  # seconds
    memory_limit: int  # MiB
    cores: int

    @property
    def is_study(self):
        return shlex.split(self.text)[0] == "study"

    @property
    def minutes(self):
        """What a cluster is asked for: the limit, and time to start."""
        return 1 + math.ceil(self.time_limit / 60)


def _command_of(entry, config):
    own = {"run": entry} if isinstance(entry, str) else entry
    allowed = {"run", "time_limit", "memory_limit", "cores"}
    if not isinstance(own, dict) or not own.get("run") or set(own) - allowed:
        raise Failure(f"{entry} is no command; give what follows `intrinsic`, or a mapping with "
                      "`run` and what it changes of " + ", ".join(sorted(allowed - {"run"})))
    values = {key: own.get(key, config[key]) for key in allowed - {"run"}}
    return Command(own["run"], **values)


def _name_of(text):
    """A name that is good for directories, and tells commands apart."""
    name = re.sub(r"[^A-Za-z0-9.+-]+", "_", text).strip("_")
    if len(name) > 60:
        name = name[:60] + "_" + hashlib.sha256(text.encode()).hexdigest()[:8]
    return name


def named_commands(config):
    """Returns the commands of a config by name."""
    commands = [_command_of(entry, config) for entry in config["commands"] or []]
    if not commands:
        raise Failure("there are no commands; give some, such as `delaunay`, in `commands`")
    named = {_name_of(command.text): command for command in commands}
    if len(named) < len(commands):
        raise Failure("two commands have the same name; leave one out")
    return named
