#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how long each sample runs, for the samples on the start page.

Usage: measure.py PROGRAM. Writes samples.json next to this script. The smaller of
wall-clock time and processor time counts: other programs lengthen the first,
threads the second.
"""
import json
import pathlib
import platform
import resource
import subprocess
import sys
import tempfile
import time

here = pathlib.Path(__file__).resolve().parent


def used():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def measure(program, scene, folder):
    census = json.loads(subprocess.run([program, "check", scene, "--json"], capture_output=True).stdout)["census"]
    began, before = time.monotonic(), used()
    subprocess.run([program, "run", scene, "--overwrite", "--out", folder / "run.kbrun"], capture_output=True)
    seconds = min(time.monotonic() - began, used() - before)
    return {"blocks": census["blocks"], "bolts": census["bolts"], "seconds": float(f"{seconds:.2g}")}


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    rows = {}
    with tempfile.TemporaryDirectory() as folder:
        for scene in sorted((here / "../../samples").glob("*.json")):
            rows[scene.stem] = measure(program, scene, pathlib.Path(folder))
            print(scene.stem, rows[scene.stem], flush=True)
    lines = ",\n".join(f'    "{name}": {json.dumps(row)}' for name, row in rows.items())
    (here / "samples.json").write_text(f'{{\n  "machine": "{platform.machine()}",\n  "samples": {{\n{lines}\n  }}\n}}\n')


main()
