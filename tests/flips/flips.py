#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a run store with single flipped bits through every command that reads one.

    flips.py PROGRAM RUN.kbrun [--flips 200] [--seed 1]

Each command must either refuse the store (exit code 3) or write the same bytes as for the intact one. Exits 1 if one
writes something else, ends with another code or takes longer than 20 s.
"""
import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile

TABLES = ["history", "events", "bolts", "blocks", "contacts", "energy", "forces"]


def commands(run, out):
    """Words of thirteen commands that read a run; those with an output write to `out`."""
    export = ["export", run]
    figure = ["--width", "80", "--out", out + ".svg"]
    return ([["info", run], ["info", run, "--json"]] +
            [export + ["--table", table, "--out", out] + (["--at", "all"] if table not in ("history", "events") else [])
             for table in TABLES] +
            [export + ["--vtk", out], export + ["--figure", "section", *figure],
             export + ["--figure", "curves", *figure], export + ["--figure", "events", *figure]])


def digest(folder):
    """Hash of the names and contents of all files below a folder."""
    sums = hashlib.sha256()
    for path in sorted(pathlib.Path(folder).rglob("*")):
        if path.is_file():
            sums.update(str(path.relative_to(folder)).encode() + path.read_bytes())
    return sums.hexdigest()


def answers(program, store):
    """Exit code and hash of output and files of every command, for the bytes of a store."""
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for index in range(len(commands("", ""))):
            place = pathlib.Path(folder, str(index))
            (place / "out").mkdir(parents=True)
            (place / "run.kbrun").write_bytes(store)
            words = commands("run.kbrun", "out/out")[index]
            try:
                ended = subprocess.run([program, *words], cwd=place, capture_output=True, timeout=20, check=False)
                code = ended.returncode
                said = b"" if code else ended.stdout
            except subprocess.TimeoutExpired:
                code, said = "timeout", b""
            found.append((code, hashlib.sha256(said + digest(place / "out").encode()).hexdigest()))
            shutil.rmtree(place)
    return found


def flipped(store, bit):
    changed = bytearray(store)
    changed[bit // 8] ^= 1 << bit % 8
    return bytes(changed)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("run")
    parser.add_argument("--flips", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    program, store = os.path.abspath(given.program), pathlib.Path(given.run).read_bytes()
    intact = answers(program, store)
    names = [" ".join(words) for words in commands("run.kbrun", "out")]
    for name, (code, _) in zip(names, intact):
        if code != 0:
            sys.exit(f"{name}: exit code {code} for the intact store")
    bits = [random.Random(given.seed + i).randrange(8 * len(store)) for i in range(given.flips)]
    same = refused = wrong = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for bit, found in zip(bits, pool.map(lambda bit: answers(program, flipped(store, bit)), bits)):
            for name, before, after in zip(names, intact, found):
                same += after == before
                refused += after[0] == 3
                if after != before and after[0] != 3:
                    wrong += 1
                    print(f"bit {bit}: {name}: exit code {after[0]}, other output")
    print(f"{len(bits)} flipped bits, {len(names)} commands: {same} the same, {refused} refused, {wrong} wrong")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
