#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a run store in which one value is not finite or extreme, by every kind of output.

    not_finite.py PROGRAM RUN.kbrun

Nine values of the last frame and the last row of the history are replaced, one at a time, by NaN, +-inf, +-1e308 and the
smallest double, with the checksums that belong to them. Each output must end within 20 s, refuse the store (exit code 3)
or write valid files: JSON without NaN or Infinity, SVG that an XML reader accepts, without such numbers, and a table that
has the changed value where it belongs. Exits 1 if one does not.
"""
import argparse
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import re
import sqlite3
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import xxhash

VALUES = [math.nan, math.inf, -math.inf, 1e308, -1e308, 5e-324]
PLACES = [("blocks", "x"), ("blocks", "uy"), ("blocks", "sxx"), ("corners", "x"), ("contacts", "normal_force"),
          ("nodes", "axial_force"), ("nodes", "slip"), ("bolt_extremes", "axial_force"), ("history", None)]
OUTPUTS = ["info", "table", "section", "bolt", "curves", "vtk"]
PAYLOADS = ["blocks", "corners", "contacts", "nodes", "bolts", "weights", "inertia", "contact_forces", "node_forces",
            "other_forces", "bolt_extremes", "block_extremes"]
BAD_NUMBER = re.compile(r"""[ ,"(]-?(nan|inf)\b""", re.IGNORECASE)


def checksum(values):
    """XXH3 hash of a row, as the help page on run stores describes it."""
    data = b""
    for position, value in enumerate(values):
        if value is None:
            continue
        if isinstance(value, int):
            data += struct.pack("<IIq", position, 8, value)
        elif isinstance(value, float):
            data += struct.pack("<IId", position, 8, value + 0.0)
        else:
            value = value.encode() if isinstance(value, str) else value
            data += struct.pack("<II", position, len(value)) + value
    total = xxhash.xxh3_64_intdigest(data)
    return total - 2**64 if total >= 2**63 else total


def put(blob, index, value):
    return blob[: 8 * index] + struct.pack("<d", value) + blob[8 * index + 8 :]


def change(store, payload, name, value):
    """Replaces one value of a store and makes the checksum right again."""
    base = sqlite3.connect(store)
    if payload == "history":
        row = list(base.execute('SELECT row, stage, time, step, "values" FROM history ORDER BY row DESC').fetchone())
        row[4] = put(row[4], 0, value)
        base.execute('UPDATE history SET "values" = ?, checksum = ? WHERE row = ?', (row[4], checksum(row), row[0]))
    else:
        position = [row[0] for row in base.execute(
            "SELECT name FROM columns WHERE payload = ? ORDER BY position", (payload,))].index(name)
        frame, *blobs = base.execute(f"SELECT frame, {', '.join(PAYLOADS)} FROM frames ORDER BY frame DESC").fetchone()
        at = PAYLOADS.index(payload)
        blobs[at] = put(blobs[at], position, value)
        base.execute(f"UPDATE frames SET {payload} = ?, payload_checksum = ? WHERE frame = ?",
                     (blobs[at], checksum(blobs), frame))
    base.commit()
    base.close()


def words(output, payload):
    export = ["export", "run.kbrun"]
    table = {"blocks": "blocks", "contacts": "contacts", "nodes": "bolts", "history": "history"}.get(payload, "design")
    return {"info": ["info", "run.kbrun", "--json"],
            "table": [*export, "--table", table, "--out", "out.csv"],
            "vtk": [*export, "--vtk", "vtk"]}.get(output, [*export, "--figure", output, "--width", "80", "--out", "out.svg"])


def has_value(path, value):
    """Whether a cell of a table is the value, or empty where there can be none."""
    with open(path, newline="", encoding="utf-8") as file:
        for row in csv.reader(file):
            for cell in row:
                try:
                    number = float(cell)
                except ValueError:
                    continue
                if number == value or (math.isnan(number) and math.isnan(value)):
                    return True
    return False


def fault(folder, output, payload, name, value, ended):
    """What is wrong with an output, or None."""
    if ended.returncode == 3:
        return None if ended.stderr.strip() else "refused without a message"
    if ended.returncode != 0:
        return f"exit code {ended.returncode}: {ended.stderr.strip()[:200]}"
    if output == "info":
        json.loads(ended.stdout, parse_constant=lambda word: sys.exit(f"JSON has {word}"))
    if output == "table" and payload in ("blocks", "contacts", "nodes", "history"):
        if name not in ("x",) and not has_value(folder / "out.csv", value):
            return "the table does not have the value"
    if output in ("section", "bolt", "curves"):
        text = (folder / "out.svg").read_text(encoding="utf-8")
        xml.etree.ElementTree.fromstring(text)
        if BAD_NUMBER.search(re.sub(r">[^<]*<", "><", text)):
            return "the figure has numbers that are not finite"
    return None


def judge(program, store, place, value):
    """Faults of all outputs for one changed value, and how many refused the store."""
    faults, refused = [], 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        (folder / "run.kbrun").write_bytes(store)
        change(folder / "run.kbrun", *place, value)
        for output in OUTPUTS:
            try:
                ended = subprocess.run([program, *words(output, place[0])], cwd=folder, capture_output=True, text=True,
                                       timeout=20, check=False)
                found = fault(folder, output, *place, value, ended)
                refused += ended.returncode == 3
            except subprocess.TimeoutExpired:
                found = "no end within 20 s"
            except (ValueError, xml.etree.ElementTree.ParseError) as error:
                found = f"not valid: {error}"
            if found:
                faults.append(f"{place[0]}.{place[1] or 'values'} = {value}, {output}: {found}")
            for written in folder.glob("out.*"):
                written.unlink()
    return faults, refused


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("run")
    given = parser.parse_args()
    program, store = os.path.abspath(given.program), pathlib.Path(given.run).read_bytes()
    cases = [(place, value) for place in PLACES for value in VALUES]
    wrong = refused = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for faults, count in pool.map(lambda case: judge(program, store, *case), cases):
            refused += count
            wrong += len(faults)
            for line in faults:
                print(line)
    print(f"{len(cases)} values, {len(OUTPUTS)} outputs: {refused} refused, {wrong} wrong, the rest right")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
