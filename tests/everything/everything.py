#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs six scenes with everything modelled and with what they need only, and compares unknowns, time and results.

    everything.py measure PROGRAM --json FILE [--only NAME ...]    PROGRAM is keyblock
    everything.py page FILE PAGE                   writes the table to its section of a help page

Times are CPU times on one thread, unknowns the mean over all steps in motion. Fails if a result differs by more than the
tolerance, or if the scene with 5 % of its blocks in motion is less than five times faster.
"""
import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/bench/speed"))
import scenes  # noqa: E402

TITLE = "## Everything modelled, and what the scene needs\n"
TOLERANCE = 0.02  # relative difference of a result; below a hundredth of a millimetre it is the same
SMALL = 1e-5  # [m]
FASTER = 5.0  # where 5 % of the blocks move


def sliders(steps=800):
    """A wall of 480 bricks at rest, and 24 stones that slide on a slab next to it."""
    scene = scenes.wall(24, 20, steps)
    scene["blocks"].append(scenes.box(30, -1, 80, 1))
    scene["supports"].append({"block_at": [31, -0.5], "fix": "all"})
    stones = [31 + 1.6 * i for i in range(24)]
    scene["blocks"] += [scenes.box(x, 0, 1, 0.5) for x in stones]
    stage = scene["stages"][-1]
    stage["initial_velocities"] = [{"block_at": [x + 0.5, 0.25], "velocity": [6, 0]} for x in stones]
    scene["monitors"] = [{"name": "first", "point": [31.5, 0.25]}, {"name": "last", "point": [stones[-1] + 0.5, 0.25]},
                         {"name": "wall", "point": [12.3, 9.7]}]
    scene["quantities"] = ["last first.ux", "last last.ux", "last wall.u"]
    return scene


SCENES = {
    "wall-sliders": sliders,
    "tower-100": lambda: scenes.sample("tower-100"),
    "drift-unbolted": lambda: scenes.sample("drift-unbolted"),
    "slope-shaken": lambda: scenes.sample("slope-shaken"),
    "shaken-incline": lambda: scenes.sample("shaken-incline"),
    "rocking-block": lambda: scenes.sample("rocking-block"),
}


def run(program, scene, everything, folder):
    path, out = folder / "scene.json", folder / "run.kbrun"
    path.write_text(json.dumps(scene), encoding="utf-8")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ended = subprocess.run([program, "run", path, "--out", out, "--overwrite", "--threads", "1", "--progress", "none",
                            "--set", f"analysis.model_everything={'true' if everything else 'false'}"],
                           capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if ended.returncode != 0:
        raise SystemExit(ended.stderr)
    info = json.loads(subprocess.run([program, "info", out, "--json"], capture_output=True, text=True, check=True).stdout)
    census = json.loads(subprocess.run([program, "check", path, "--json"], capture_output=True, text=True,
                                       check=True).stdout)["census"]
    bodies = census["blocks"] + census["plates"] - census["fixed"]
    awake = info["health"]["awake_mean"]
    return {"seconds": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
            "unknowns": 6 * bodies * (1.0 if awake is None else awake) + census["unknowns"]["bolts"],
            "awake": awake,
            "work": sum(stage["work"]["total"] for stage in info["stages"]),
            "stands": info["verdict"]["stands"],
            "quantities": {q["quantity"]: q["value"] for q in info["quantities"]}}


def difference(one, other):
    """Largest relative difference of the results, with its quantity."""
    worst = (0.0, "")
    for name, value in one["quantities"].items():
        true = other["quantities"][name]
        if name == "energy_error" or (value is None and true is None):
            continue
        if value is None or true is None:
            return float("inf"), name
        change = abs(value - true)
        worst = max(worst, (0.0 if change < SMALL else change / abs(true) if true else float("inf"), name))
    return worst if one["stands"] == other["stands"] else (float("inf"), "stands")


def scene_of(name):
    scene = SCENES[name]()
    expected = [e["quantity"] for e in scene.get("about", {}).get("expected", [])]
    scene["quantities"] = list(dict.fromkeys(scene.get("quantities", []) + expected))
    return scene


def measure(arguments):
    results = json.loads(arguments.json.read_text(encoding="utf-8")) if arguments.json.exists() else {}
    for name in arguments.only or SCENES:
        with tempfile.TemporaryDirectory() as folder:
            for file in scenes.SAMPLES.glob("*.csv"):
                (pathlib.Path(folder) / file.name).write_bytes(file.read_bytes())
            results[name] = [run(arguments.program, scene_of(name), everything, pathlib.Path(folder))
                             for everything in (True, False)]
        print(*row_of(name, results[name]), sep="  ", flush=True)
        arguments.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    return 0 if all(is_met(name, pair) for name, pair in results.items()) else 1


def is_met(name, pair):
    everything, needed = pair
    fast = name != "wall-sliders" or everything["seconds"] >= FASTER * needed["seconds"]
    return fast and difference(needed, everything)[0] <= TOLERANCE


def row_of(name, pair):
    everything, needed = pair
    change, quantity = difference(needed, everything)
    return [name, f"{100 * needed['awake']:.1f}%", f"{everything['unknowns']:,.0f}", f"{needed['unknowns']:,.0f}",
            f"{everything['seconds']:.2f}", f"{needed['seconds']:.2f}", f"{everything['seconds'] / needed['seconds']:.1f}",
            "0" if change == 0.0 else f"{100 * change:.2g}% ({quantity})"]


def page(arguments):
    """Replaces the section of the page, or adds it at the end."""
    results = json.loads(arguments.file.read_text(encoding="utf-8"))
    section = TITLE + f"""
Made by `make everything`: with `analysis.model_everything` and without. *awake* is the share of the movable blocks that moved with a step on average; unknowns are the mean over the steps. Times are CPU times on one thread, the static stages before included. Fixed blocks and prescribed displacements are no unknowns in either. Results count as equal within {100 * TOLERANCE:.0f}% or {1e3 * SMALL:g} mm; the difference is the largest.

| scene | awake | unknowns, everything | unknowns, as needed | s, everything | s, as needed | times faster | difference |
| --- | --- | --- | --- | --- | --- | --- | --- |
"""
    for name, pair in results.items():
        section += "| " + " | ".join(row_of(name, pair)) + " |\n"
    text = arguments.page.read_text(encoding="utf-8")
    before, _, rest = text.partition(TITLE)
    after = rest.find("\n## ")
    arguments.page.write_text(before.rstrip() + "\n\n" + section + (rest[after:] if after >= 0 else ""), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    measuring = commands.add_parser("measure")
    measuring.add_argument("program")
    measuring.add_argument("--json", type=pathlib.Path, required=True)
    measuring.add_argument("--only", nargs="*", choices=SCENES, metavar="NAME")
    measuring.set_defaults(do=measure)
    writing = commands.add_parser("page")
    writing.add_argument("file", type=pathlib.Path)
    writing.add_argument("page", type=pathlib.Path)
    writing.set_defaults(do=page)
    arguments = parser.parse_args()
    return arguments.do(arguments)


if __name__ == "__main__":
    sys.exit(main())
