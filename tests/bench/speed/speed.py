#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what a step costs, and compares two measurements.

    speed.py measure PROGRAM [--json FILE] [--large] [NAME ...]   PROGRAM is keyblock_speed_bench
    speed.py compare OLD NEW [--worse 1.2]                        exit code 1 if a scene has become slower

Times are CPU times on one thread. If the last stage is static, the whole run counts as one step. `step/F` is a step over
one numeric factorization of the same scene with all contacts closed, measured in the same run, so that results of
different machines can be compared.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import scenes

COLUMNS = [
    ("scene", "name", "{}"),
    ("blocks", "blocks", "{:,}"),
    ("ms per step", "ms_per_step", "{:.3g}"),
    ("F, ms", "F_ms", "{:.3g}"),
    ("S, ms", "S_ms", "{:.3g}"),
    ("step/F", "step_in_F", "{:.2f}"),
    ("iterations", "iterations", "{:.2f}"),
    ("factorizations", "factorizations", "{:.2f}"),
    ("cuts", "cuts", "{}"),
    ("memory, MB", "memory_MB", "{:.0f}"),
]


def measured(program, name, scene):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.json"
        path.write_text(json.dumps(scene), encoding="utf-8")
        run = subprocess.run([program, path], capture_output=True, text=True, check=False)
    if run.returncode != 0:
        sys.exit(f"{name}: {run.stderr.strip() or run.returncode}")
    return {"name": name} | json.loads(run.stdout)


def row(cells):
    return "| " + " | ".join(cells) + " |"


def cell(entry, key, form):
    return form.format(entry[key]) if entry[key] is not None else "-"


def measure(arguments):
    entries = []
    print(row(title for title, _, _ in COLUMNS))
    print(row("---" for _ in COLUMNS))
    for name, scene in scenes.all_scenes(arguments.large):
        if arguments.names and name not in arguments.names:
            continue
        entries.append(measured(arguments.program, name, scene))
        print(row(cell(entries[-1], key, form) for _, key, form in COLUMNS), flush=True)
    if not entries:
        sys.exit("no scene has one of these names")
    if arguments.json:
        text = json.dumps({"scenes": entries}, indent=1) + "\n"
        pathlib.Path(arguments.json).write_text(text, encoding="utf-8")


def read(path):
    try:
        entries = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))["scenes"]
        return {(entry["name"], entry["blocks"]): entry for entry in entries}
    except (OSError, ValueError, KeyError, TypeError) as error:
        sys.exit(f"{path}: not a file of measurements ({error})")


def slower(old, new, worse):
    """True if the step has become slower, in factorizations where both are known, so that the machine does not matter."""
    unit = "step_in_F" if old["step_in_F"] and new["step_in_F"] else "ms_per_step"
    return new[unit] > worse * old[unit]


def compare(arguments):
    old, new = read(arguments.old), read(arguments.new)
    failed = False
    for key, before in old.items():
        title = f"{key[0]}, {key[1]:,} blocks"
        if key not in new:
            print(f"{title}: not measured again")
            failed = True
            continue
        now = new[key]
        verdict = "SLOWER" if slower(before, now, arguments.worse) else "ok"
        failed = failed or verdict != "ok"
        print(
            f"{title}: {before['ms_per_step']:.3g} -> {now['ms_per_step']:.3g} ms,"
            f" {cell(before, 'step_in_F', '{:.2f}')} -> {cell(now, 'step_in_F', '{:.2f}')} F  {verdict}"
        )
    sys.exit(1 if failed else 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    command = commands.add_parser("measure")
    command.add_argument("program")
    command.add_argument("names", nargs="*", metavar="NAME")
    command.add_argument("--json", metavar="FILE")
    command.add_argument("--large", action="store_true")
    command.set_defaults(action=measure)
    command = commands.add_parser("compare")
    command.add_argument("old")
    command.add_argument("new")
    command.add_argument("--worse", type=float, default=1.2)
    command.set_defaults(action=compare)
    arguments = parser.parse_args()
    arguments.action(arguments)


if __name__ == "__main__":
    main()
