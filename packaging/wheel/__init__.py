# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""The program rigor, beside this file with every library that it uses. Nothing of it is Python."""

import os
import sys


def main():
    program = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bin", "rigor")
    os.execv(program, ["rigor", *sys.argv[1:]])
