# Copyright (c) 2026 The Intrinsic Triangulations authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which process of Snakemake this is: versions 7 and 8 say it by other names."""


def is_first_process(workflow):
    """Tells whether a user has started this process, and not Snakemake for a job."""
    try:
        from snakemake.common import Mode
    except ImportError:  # from version 8 on
        from snakemake_interface_executor_plugins.settings import ExecMode

        return workflow.exec_mode == ExecMode.DEFAULT
    return workflow.mode == Mode.default
