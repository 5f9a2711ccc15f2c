# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""`python3 -m rigor` is the program."""

from rigor import main

main()
