#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what a step costs, and compares two measurements.

    speed.py measure PROGRAM [--json FILE] [--large] [NAME ...]   PROGRAM is keyblock_speed_bench
    speed.py page FILE PAGE                                       writes the measurements of FILE to a help page
    speed.py compare OLD NEW [--worse 1.2]                        exit code 1 if a scene has become slower

Times are CPU times on one thread. If the last stage is static, the whole run counts as one step and `step/F` is left out. `step/F` is a step over
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
    ("awake", "awake", "{:.0%}"),
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
    if entry[key] is None:
        return "-"
    return f"{entry[key]:,.0f}" if form == "{:.3g}" and entry[key] >= 1000 else form.format(entry[key])


def measure(arguments):
    entries = []
    print(row(title for title, _, _ in COLUMNS))
    print(row("---" for _ in COLUMNS))
    for name, scene in scenes.all_scenes(arguments.large):
        if arguments.names and name not in arguments.names:
            continue
        entries.append(measured(arguments.program, name, scene))
        print(row(cell(entries[-1], key, form) for _, key, form in COLUMNS), flush=True)
        if arguments.json:
            write(pathlib.Path(arguments.json), entries)
    if not entries:
        sys.exit("no scene has one of these names")


def write(path, entries):
    """Replaces the file as a whole after every scene, so that an interrupted measurement keeps what it has."""
    part = path.with_name(path.name + ".part")
    part.write_text(json.dumps({"scenes": entries}, indent=1) + "\n", encoding="utf-8")
    part.replace(path)


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


PHASES = {
    "search": "contact search",
    "build": "building the step",
    "judge": "balance, line search",
    "sweep": "sweeps",
    "assemble": "assembly",
    "factor": "factorization",
    "update": "rank updates",
    "solve": "back-substitution",
    "accept": "energies, new state",
    "other": "rest",
}

# Sections of the page that other scripts write.
OTHERS = ("Estimated and measured time", "Everything modelled")

PAGE = """<!-- SPDX-FileCopyrightText: The Keyblock contributors -->
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
# Speed

What a step costs, measured with one thread by

```
make bench BENCH_JSON=FILE{large}
/usr/bin/python3 tests/bench/speed/speed.py page FILE resources/help/speed.md
```

Times are CPU times and depend on the machine. *F* is the time of one numeric factorization of the scene's matrix with all contacts closed, *S* that of one back-substitution; *step/F* therefore compares machines. On a shared machine times scatter, as *F* of the same wall in several rows shows. In a static scene the whole run counts as one step.

{scenes}

## Scenes

{descriptions}

{table}

*awake* is the share of the blocks that moved with the steps on average ([Sleep](theory.md#sleep)); in *wall-awake*, *wall-shaken*, *wall-bolts* and *drift-large-awake* nothing may sleep; in the first and the third, steps soon change nothing and are not made again. *cuts* are steps that were repeated with a shorter time step.

## Where the time goes

Share of the time in per cent, sampled every millisecond during the steps of the last stage.

{shares}
"""


def page(arguments):
    entries = list(read(arguments.file).values())
    table = [row(title for title, _, _ in COLUMNS), row("---" for _ in COLUMNS)]
    table += [row(cell(entry, key, form) for _, key, form in COLUMNS) for entry in entries]
    shares = [row(["scene", "blocks", *PHASES.values()]), row("---" for _ in range(len(PHASES) + 2))]
    for entry in entries:
        parts = [f"{100 * entry['shares'][name]:.0f}" for name in PHASES]
        shares.append(row([entry["name"], f"{entry['blocks']:,}", *parts]))
    lines = [line for line in scenes.__doc__.splitlines()[2:] if line.strip()]
    text = PAGE.format(
        large=" LARGE=1" if any(entry["blocks"] > 4000 for entry in entries) else "",
        scenes="Every row is one scene of `tests/bench/speed/scenes.py`.",
        descriptions="\n".join(f"- *{line.split(None, 1)[0]}*: {line.split(None, 1)[1]}" for line in lines),
        table="\n".join(table),
        shares="\n".join(shares),
    )
    target = pathlib.Path(arguments.page)
    kept = [part for part in target.read_text(encoding="utf-8").split("\n## ")[1:] if part.startswith(OTHERS)] \
        if target.exists() else []
    target.write_text("\n## ".join([text, *kept]), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    command = commands.add_parser("measure")
    command.add_argument("program")
    command.add_argument("names", nargs="*", metavar="NAME")
    command.add_argument("--json", metavar="FILE")
    command.add_argument("--large", action="store_true")
    command.set_defaults(action=measure)
    command = commands.add_parser("page")
    command.add_argument("file")
    command.add_argument("page")
    command.set_defaults(action=page)
    command = commands.add_parser("compare")
    command.add_argument("old")
    command.add_argument("new")
    command.add_argument("--worse", type=float, default=1.2)
    command.set_defaults(action=compare)
    arguments = parser.parse_args()
    arguments.action(arguments)


if __name__ == "__main__":
    main()
