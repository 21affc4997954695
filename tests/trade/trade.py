#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures accuracy against time of eight samples and writes the help page.

    trade.py measure PROGRAM --out DIR [--only NAME ...] [--budget SECONDS]    PROGRAM is keyblock; a trade in DIR continues
    trade.py page DIR PAGE [--truth FILE]     writes the trades in DIR to a help page; FILE is that of tests/presets/truth.py

The samples leave their numerical settings to the preset, as in tests/presets/presets.py, so that presets mean something.
A trade in DIR that belongs to another scene or to another version of the program is measured again. `page` writes
nothing unless all eight trades are complete and belong to the samples as they are now; it fails, with the page written, if
a stated error is not met.
"""
import argparse
import csv
import json
import math
import re
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/presets"))
import presets  # noqa: E402
import truth  # noqa: E402

SCENES = {
    "rebar-20": ("Quasi-static pull of a rebar", "A grouted rebar is pulled until its bond has failed on one side of the joint."),
    "dbolt-table-steel": ("D-bolt to rupture", "A smooth bar with four anchors stretches between two of them and ruptures."),
    "angle-dbolt-40": ("Pull and shear", "A D-bolt is pulled at 40° to its axis: hinges form at the joint before it ruptures."),
    "deep-drift": ("Drift", "Three rows of D-bolts are installed early and late around a drift in 530 blocks at depth."),
    "burst-dbolt": ("Rockburst", "A slab at a speed of metres per second is stopped by the steel of a D-bolt."),
    "slope-shaken": (
        "Wave",
        "Three pulses of acceleration travel into a slope of seven blocks that slide together. Only the scheme of "
        "integration damps the rock: with shorter steps its vibration lasts longer, and the toe creeps ahead. With "
        "`damping.stiffness` of 1e-4 s the toe is off from Newmark's integral by 0.01 % with steps of 1 ms and by "
        "0.18 % with an eighth of it (`keyblock run samples/slope-shaken.json --set analysis.damping.stiffness=1e-4 "
        "--set stages.0.time_step=0.000125`).",
    ),
    "incline": ("Slide", "A block slides from rest down a slope of 30° with a friction angle of 20°."),
    "toppling-block": ("Toppling", "A slender block topples about its lower corner."),
}
AXES = {
    "divisions": "Divisions of the bolts", "time_step": "The time step", "increments": "The number of increments",
    "penalty_ratio": "The penalty ratio", "contact": "The augmented Lagrangian method", "tolerance": "The tolerance",
    "iteration": "The classical open–close iteration", "integration": "The scheme of time integration",
    "sleep_tolerance": "The sleep tolerance", "threads": "The number of threads", "bond": "A brittle bond",
}
NOTHING = 2e-4  # a change that is not worth a word
LARGE = 0.03


FILES = {"points.json", "trade.csv", "trade.md", "trade.svg"}  # of a trade


def text_of(name):
    return json.dumps(presets.scene_of(name))


def trade(arguments, name):
    """Runs or continues a trade. Returns how it ended and what it said."""
    ended = subprocess.run([arguments.program, "trade", arguments.out / f"{name}.json", "--out", arguments.out / name,
                            "--progress", "none", "--budget", str(arguments.budget)], stderr=subprocess.PIPE, text=True, check=False)
    return ended.returncode, ended.stderr


def remove(folder):
    """Removes a trade, and nothing but its files."""
    for file in folder.iterdir():
        if file.name in FILES:
            file.unlink()


def measure(arguments):
    arguments.out.mkdir(parents=True, exist_ok=True)
    for file in presets.SAMPLES.glob("*.csv"):
        (arguments.out / file.name).write_bytes(file.read_bytes())
    for name in arguments.only or SCENES:
        (arguments.out / f"{name}.json").write_text(text_of(name), encoding="utf-8")
        print(name, flush=True)
        code, said = trade(arguments, name)
        if code == 6 and ": it holds " in said:  # a trade of another scene, or by another version of the program
            print(f"{name}: the trade in {arguments.out / name} is of another scene or program; measured again", file=sys.stderr, flush=True)
            remove(arguments.out / name)
            code, said = trade(arguments, name)
        sys.stderr.write(said)
        if code != 0:
            return code
    return 0


def build_of(folder):
    """The version of the program that measured a trade, and when."""
    file = folder / "points.json"
    return (file.stat().st_mtime, json.loads(file.read_text(encoding="utf-8"))["build"]) if file.exists() else (0.0, "")


def missing(folder, name, build):
    """What a trade lacks for a page with trades of one version of the program; empty: nothing."""
    if any(not (folder / name / file).exists() for file in ("trade.csv", "trade.md")):
        return "was not measured"
    scene = folder / f"{name}.json"
    if not scene.exists() or scene.read_text(encoding="utf-8") != text_of(name):
        return "is of another scene than the sample"
    if "interrupted before all runs were made" in (folder / name / "trade.md").read_text(encoding="utf-8"):
        return "was interrupted"
    if build_of(folder / name)[1] != build:
        return "is by another version of the program"
    return ""


def points_of(folder):
    """The points of a trade in the order in which they were measured: axis, setting, seconds, work, front, errors."""
    points = {}
    with open(folder / "trade.csv", encoding="utf-8", newline="") as table:
        for row in csv.DictReader(table):
            point = points.setdefault((row["axis"], row["setting"]), {
                "axis": row["axis"], "setting": row["setting"], "seconds": float(row["wall_s"]),
                "factorizations": int(row["factorizations"]), "front": row["on_front"] == "1", "errors": {}, "orders": {}, "scatters": {}})
            if row["quantity"] != "energy_error":
                # a quantity with a value in one of two runs only is wrong altogether
                point["errors"][row["quantity"]] = float(row["error"]) if row["error"] else math.inf
                point["orders"][row["quantity"]] = row["order"]
                point["scatters"][row["quantity"]] = float(row.get("scatter") or 0)
    return list(points.values())


def largest(point):
    return max(point["errors"].items(), key=lambda item: item[1], default=("", 0.0))


def name_of(point):
    if point["axis"] in ("preset", "combination"):
        return point["setting"]
    return "scene's own (engineering)" if point["axis"] == "own settings" else f"{point['axis']} {point['setting']}".strip()


def percent(share):
    return "no value" if math.isinf(share) else presets.percent(share)


def seconds(value):
    return f"{value:.2g}" if value < 1 else f"{value:.3g}"


def front_table(points):
    text = presets.row(["settings", "time, s", "largest error", "of"]) + presets.row(["---"] * 4)
    front = sorted((p for p in points if p["front"]), key=lambda p: p["seconds"])
    extra = [p for p in points if p["axis"] in ("own settings", "preset") and p not in front]
    for point in sorted(front + extra, key=lambda p: p["seconds"]):
        quantity, error = largest(point)
        shown = quantity if error >= 5e-6 else "–"
        name = name_of(point) + (" **(front)**" if point["front"] else "")
        text += presets.row([name, seconds(point["seconds"]), percent(error), shown])
    return text


def finding(axis, points, own):
    """One sentence on what a setting changes against the scene's own, and what it costs."""
    changed = {}
    for point in points:
        for quantity, error in point["errors"].items():
            changed[quantity] = max(changed.get(quantity, 0.0), abs(error - own["errors"].get(quantity, 0.0)))
    quantity, most = max(changed.items(), key=lambda item: item[1], default=("", 0.0))
    times = sorted(p["seconds"] / own["seconds"] for p in points)
    cost = f"{times[0]:.2g}" + (f" to {times[-1]:.2g}" if len(times) > 1 else "") + " of the time"
    settings = ", ".join(p["setting"] for p in points)
    if most < NOTHING:
        return f"{AXES[axis]} ({settings}; {cost}): no effect on the results.\n"
    orders = {p["orders"].get(quantity, "") for p in points} - {"", "no effect"}
    order = next(iter(orders), "")
    told = "" if not order else f"; its error is not regular" if order == "not regular" else f"; its error falls with the power {order} of the setting"
    quantity = "the verdict on stability" if quantity == "stands" else quantity
    weight = "changes" if most < LARGE else "decides:"
    amount = f"{quantity} by up to {percent(most)}" if not math.isinf(most) else f"{quantity} is lost in some runs"
    return f"{AXES[axis]} ({settings}; {cost}) {weight} {amount}{told}.\n"


def findings(points):
    own = points[0]
    text = ""
    for axis in AXES:
        along = [p for p in points if p["axis"] == axis]
        if along and axis != "threads":
            text += "- " + finding(axis, along, own)
    return text


def recommended(page):
    line = next((line for line in page.splitlines() if line.endswith("(recommended)**")), None)
    if line is None:
        return None
    return line[len("- **"):-len(" (recommended)**")]


def section(folder, name):
    title, what = SCENES[name]
    points = points_of(folder / name)
    page = (folder / name / "trade.md").read_text(encoding="utf-8")
    best = recommended(page)
    without = re.search(r"No preset is recommended: .*", page)
    text = f"## {title}\n\nSample `{name}`. {what}\n\n"
    text += (f"Recommended preset, to quote: **{best}.**\n\n" if best
             else f"{without[0]}\n\n")
    against = re.search(r"the finest settings \((.*); ([^;]*) s\)", page)
    uncertain, scatter = max(points[0]["scatters"].items(), key=lambda item: item[1], default=("", 0.0))
    known = f", itself known to ± {percent(scatter)} ({uncertain})" if scatter >= 1e-3 else ""
    text += f"{len(points)} runs; errors against {against[1]} ({seconds(float(against[2]))} s){known}."
    left = page.count(": not run; ")
    if left:
        text += f" {left} runs were left out for their time" + (
            "." if against[1].startswith("reference:") else ", so that errors are against the finest of those made.")
    text += "\n\n"
    return text + front_table(points) + "\n" + findings(points)


PAGE = """<!-- SPDX-FileCopyrightText: The Keyblock contributors -->
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
# Accuracy and time

`keyblock trade SCENE.json --out DIR` and *Run > Measure accuracy and time* run a scene with coarser and finer settings, one at a time and then in combinations, and compare the results with the finest run. Here are eight samples. On the front, no other settings are both faster and more accurate; the presets are listed with it. Errors are the largest of all quantities of interest, and a quantity that only one of two runs has counts as lost. Made by `make trade`; times are CPU times on one thread and depend on the machine.

The order of convergence comes from the three finest settings of an axis, if the quantity converges regularly: the differences have one sign, and the order lies between half of the lowest that theory gives (1, where bonds fail or joints begin to slide) and twice the highest (2; 1 for penalties and tolerances). Otherwise the order is *not regular*, and the finest run itself is only known to within the range of these three values, relative to the reference; the ranges of all axes together follow the error after ±.

The samples leave their numerical settings to the preset: time steps, tolerances and, where the bond is given per metre, divisions are removed. The divisions of a bond that is given per node stay, because its strength depends on them.

"""


def page(arguments):
    latest = max(build_of(arguments.folder / name) for name in SCENES)[1]
    lacking = {name: why for name in SCENES if (why := missing(arguments.folder, name, latest))}
    for name, why in lacking.items():
        print(f"{arguments.folder / name}: the trade of sample {name} {why}; run `trade.py measure` to complete it", file=sys.stderr)
    if lacking:
        return 1
    text = PAGE + "\n".join(section(arguments.folder, name) for name in SCENES)
    arguments.page.write_text(text, encoding="utf-8")
    if arguments.truth:
        return truth.page(argparse.Namespace(file=arguments.truth, page=arguments.page))
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    measuring = commands.add_parser("measure")
    measuring.add_argument("program", type=lambda path: pathlib.Path(path).resolve())
    measuring.add_argument("--out", type=pathlib.Path, required=True)
    measuring.add_argument("--only", nargs="*", choices=SCENES, metavar="NAME")
    measuring.add_argument("--budget", type=float, default=600.0)
    measuring.set_defaults(do=measure)
    writing = commands.add_parser("page")
    writing.add_argument("folder", type=pathlib.Path)
    writing.add_argument("page", type=pathlib.Path)
    writing.add_argument("--truth", type=pathlib.Path)
    writing.set_defaults(do=page)
    arguments = parser.parse_args()
    return arguments.do(arguments)


if __name__ == "__main__":
    sys.exit(main())
