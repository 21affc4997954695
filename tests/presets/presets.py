#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what the presets change and what they save, and writes the help page.

    presets.py measure PROGRAM --json FILE [--only NAME ...]    PROGRAM is keyblock; runs every scene with every preset
    presets.py stiffness PROGRAM --json FILE [--only NAME ...]  runs every scene and a drift with stiffer contacts
    presets.py page FILE STIFFNESS PAGE                         writes the measurements of both files to a help page

The scenes are samples that leave their numerical settings to the preset: time steps are removed, divisions too where
the bond is given per metre. Errors are differences from the preset `reference`.
"""
import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "samples"
PRESETS = ["sketch", "draft", "engineering", "reference"]

SCENES = """angle-dbolt-00 angle-rebar-00 burst-dbolt burst-rebar cone-bolt
dbolt-table-steel drift-rebar-dbolt drift-unbolted drop-cone-bolt drop-d-bolt drop-garford drop-roofex expansion-shell
free-fall garford impact incline plate-block pull-out-gap rebar-20 rebar-brittle rebar-stated rocking-block roofex shaken-incline shaken-record slope-safety slope-shaken
spin split-set suspended-block swellex toppling-block tower-100 weaken-incline""".split()

# Where contacts under in-situ stress decide how far a wall moves.
STIFF_SCENES = ["deep-drift", *SCENES]
RATIOS = [40, 120, 200, 400]

# A bolt that was hit swings back at the end of the run, so whether the block is still at that moment says nothing about
# stability.
REBOUNDING = {"drop-cone-bolt", "drop-d-bolt", "drop-garford", "drop-roofex", "burst-dbolt", "burst-rebar", "impact"}


def is_per_node(anchors):
    return any(a.get("per", "node") == "node" and "at" not in a for a in anchors)


def largest(monitor):
    """The extreme of a bolt's force, of which the last value after a rupture is round-off. Moments of the samples are
    negative where they are large."""
    return "min" if monitor.get("quantity") == "moment" else "max"


def scene_of(name):
    """The sample without settings that presets determine, and with quantities of interest."""
    scene = json.loads((SAMPLES / f"{name}.json").read_text(encoding="utf-8"))
    for stage in scene.get("stages", []):
        stage.pop("time_step", None)
    for key in ("tolerance", "max_passes", "sleep_tolerance", "contact", "preset"):
        scene.get("analysis", {}).pop(key, None)
    types = scene.get("bolt_types", {})
    for bolt in scene.get("bolts", []) + scene.get("bolt_patterns", []):
        anchors = bolt.get("anchors") or types.get(bolt.get("type"), {}).get("anchors", [])
        if anchors and not is_per_node(anchors):
            bolt.pop("divisions", None)
    expected = [e["quantity"] for e in scene.get("about", {}).get("expected", [])]
    moved = [f"{largest(m)} {m['name']}" if "bolt" in m else f"last {m['name']}" + (".u" if "point" in m else "")
             for m in scene.get("monitors", [])]
    wanted = ["stands"] + scene.get("quantities", []) + expected + moved
    scene["quantities"] = [q for q in dict.fromkeys(wanted) if q not in ("factor_of_safety", "energy_error")]
    return scene


def run(program, scene, preset, folder):
    path, out = folder / "scene.json", folder / "run.kbrun"
    path.write_text(json.dumps(scene), encoding="utf-8")
    start = time.monotonic()
    ended = subprocess.run([program, "run", path, "--out", out, "--overwrite", "--preset", preset, "--threads", "1"],
                           capture_output=True, text=True, check=False)
    seconds = time.monotonic() - start
    if ended.returncode not in (0, 5):
        return {"failure": (ended.stderr.strip() or str(ended.returncode)).replace(str(folder), "")}
    info = json.loads(subprocess.run([program, "info", out, "--json"], capture_output=True, text=True,
                                     check=True).stdout)
    quantities = {q["quantity"]: q["order"] if q["order"] else q["value"] for q in info["quantities"]}
    return {"seconds": seconds, "work": sum(s["work"]["total"] for s in info["stages"]),
            "stands": info["verdict"]["stands"], "quantities": quantities}


def measure(arguments):
    results = {}
    for name in arguments.only or SCENES:
        scene = scene_of(name)
        results[name] = {}
        with tempfile.TemporaryDirectory() as folder:
            for file in SAMPLES.glob("*.csv"):
                (pathlib.Path(folder) / file.name).write_bytes(file.read_bytes())
            for preset in PRESETS:
                results[name][preset] = run(arguments.program, scene, preset, pathlib.Path(folder))
        print(name, *(f"{p}: {entry(name, results[name], p)}" for p in PRESETS), sep="  ", flush=True)
        arguments.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


def stiffness(arguments):
    results = {}
    for name in arguments.only or STIFF_SCENES:
        scene = scene_of(name)
        if "penalty_ratio" in scene.get("analysis", {}):
            continue  # not determined by presets
        results[name] = {}
        with tempfile.TemporaryDirectory() as folder:
            for file in SAMPLES.glob("*.csv"):
                (pathlib.Path(folder) / file.name).write_bytes(file.read_bytes())
            for ratio in RATIOS:
                scene.setdefault("analysis", {})["penalty_ratio"] = ratio
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                one = run(arguments.program, scene, "engineering", pathlib.Path(folder))
                results[name][str(ratio)] = one | {"cpu": resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before}
        print(name, *(f"{r}: {one['cpu']:.2f} s, {one.get('failure', one.get('stands'))}" for r, one in results[name].items()),
              sep="  ", flush=True)
        arguments.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


def moves(name):
    return any(stage.get("kind") == "dynamic" for stage in scene_of(name).get("stages", []))


def stiffness_table(results):
    """Cost and effect of the penalty ratio, against the stiffest contacts."""
    usual, stiffest = str(RATIOS[0]), str(RATIOS[-1])
    whole = {n: r for n, r in results.items() if not any("failure" in one for one in r.values())}
    text = row(["`penalty_ratio`", "time, static scenes", "time, scenes in motion", "work, median", "work, largest",
                "changed verdicts", "forces in bolts, largest", "changes above 0.5 %"]) + row(["---"] * 8)
    for ratio in map(str, RATIOS):
        cells = [ratio]
        for moving in (False, True):
            runs = [r for n, r in whole.items() if moves(n) == moving]
            cells.append(f"{sum(r[ratio]['cpu'] for r in runs) / sum(r[usual]['cpu'] for r in runs):.2f}")
        works = {n: r[ratio]["work"] / r[usual]["work"] for n, r in whole.items() if r[usual]["work"] > 0}
        most = max(works, key=works.get)
        flips = [n for n, r in whole.items() if n not in REBOUNDING and r[ratio]["stands"] != r[stiffest]["stands"]]
        found = {(n, q): e for n, r in whole.items() for q, e in errors(n, r[ratio], r[stiffest]).items()}
        forces = max(e for (n, q), e in found.items() if kind_of(scene_of(n), q) == "forces in bolts")
        large = {}
        for (n, q), e in found.items():
            if e > 0.005 and e > large.get(n, ("", 0.0))[1]:
                large[n] = (q, e)
        cells += [f"{median(works.values()):.2f}", f"{works[most]:.2f}" + (f" ({most})" if works[most] > 1.005 else ""),
                  f"{len(flips)} of {len(whole)}" + (f" ({', '.join(flips)})" if flips else ""), percent(forces),
                  "; ".join(f"{n} {percent(e)} ({q})" for n, (q, e) in large.items()) or "none"]
        text += row(cells if ratio != stiffest else cells[:-2] + ["–", "–"])
    return text


def entry(name, runs, preset):
    one, reference = runs[preset], runs["reference"]
    if "failure" in one or "failure" in reference:
        return one.get("failure", "-")
    largest = max(errors(name, one, reference).values(), default=0.0)
    own = runs["engineering"]
    ratio = one["work"] / own["work"] if own.get("work") else 1.0
    return f"{ratio:.2f} of the work, {100 * largest:.2g} %" + ("" if same_verdict(runs, preset) else ", VERDICT")


def same_verdict(runs, preset):
    return runs[preset].get("stands") == runs["reference"].get("stands")


def error(value, reference):
    if isinstance(value, list) or isinstance(reference, list):
        return 0.0 if value == reference else 1.0
    if value is None or reference is None:
        return 0.0 if value == reference else 1.0
    return abs(value) if reference == 0 else abs(value / reference - 1.0)


def errors(name, one, reference):
    """Errors by quantity, without the verdict and without orders of events. Differences of less than a millionth of the
    largest quantity of the same kind in the scene are round-off."""
    scene = scene_of(name)
    largest = {}
    for quantity, value in reference["quantities"].items():
        if isinstance(value, float):
            kind = kind_of(scene, quantity)
            largest[kind] = max(largest.get(kind, 0.0), abs(value))
    found = {}
    for quantity, value in one["quantities"].items():
        if quantity == "stands" or quantity.startswith("order "):
            continue
        true = reference["quantities"].get(quantity)
        small = isinstance(value, float) and isinstance(true, float) and \
            abs(value - true) <= 1e-6 * largest[kind_of(scene, quantity)]
        found[quantity] = 0.0 if small else error(value, true)
    return found


def median(values):
    ordered = sorted(values)
    return ordered[len(ordered) // 2] if ordered else 0.0


def kind_of(scene, quantity):
    if quantity.startswith("count "):
        return "number of events"
    monitors = {m["name"]: m.get("quantity", "") for m in scene.get("monitors", [])}
    what = monitors.get(quantity.split(" ")[-1], "") + quantity.rpartition(".")[2]
    if any(word in what for word in ("axial_force", "shear_force", "moment", "plate", "joint_force")):
        return "forces in bolts"
    if quantity.startswith("first "):
        return "openings at the first event"
    return "displacements and others"


def percent(value):
    if value >= 1.0:
        return f"{100 * value:.0f} %"
    return "0" if value < 5e-6 else f"{100 * value:.2g} %"


def row(cells):
    return "| " + " | ".join(cells) + " |\n"


def settings():
    """A table of what each preset sets."""
    files = {p: json.loads((ROOT / f"resources/presets/{p}.json").read_text(encoding="utf-8")) for p in PRESETS}
    usual = files["engineering"]["settings"]
    text = row(["setting", *PRESETS]) + row(["---"] * 5)
    for key in usual:
        text += row([f"`{key}`", *(str(files[p]["settings"].get(key, usual[key])) for p in PRESETS)])
    return text + row(["for", *(files[p]["help"].rstrip(".") for p in PRESETS)])


def page(arguments):
    results = json.loads(arguments.file.read_text(encoding="utf-8"))
    whole = {n: r for n, r in results.items() if not any("failure" in one for one in r.values())}
    judged = {n: r for n, r in whole.items() if n not in REBOUNDING and r["reference"]["stands"] is not None}
    text = (ROOT / "tests/presets/page.md").read_text(encoding="utf-8")
    summary = row(["preset", "work, median", "work, range", "changed verdicts", "forces in bolts",
                   "displacements and others", "openings at the first event", "number of events"])
    summary += row(["---"] * 8)
    for preset in PRESETS:
        ratios = [r[preset]["work"] / r["engineering"]["work"] for r in whole.values() if r["engineering"]["work"] > 0]
        flips = [n for n, r in judged.items() if not same_verdict(r, preset)]
        cells = [preset, f"{median(ratios):.2f}", f"{min(ratios):.2f} to {max(ratios):.2f}",
                 f"{len(flips)} of {len(judged)}" + (f" ({', '.join(flips)})" if flips else "")]
        for kind in ("forces in bolts", "displacements and others", "openings at the first event", "number of events"):
            found = [e for n, r in whole.items() for q, e in errors(n, r[preset], r["reference"]).items()
                     if kind_of(scene_of(n), q) == kind and e > 0.0]
            cells.append("–" if preset == "reference" else
                         f"{percent(median(found))} ({percent(max(found))})" if found else "0")
        summary += row(cells)
    scenes = row(["scene"] + [f"{p}: work, largest error" for p in PRESETS[:-1]] + ["reference: work"])
    scenes += row(["---"] * 5)
    for name, runs in results.items():
        cells = [name]
        for preset in PRESETS:
            one, own = runs[preset], runs["engineering"]
            if "failure" in one or "failure" in own or "failure" in runs["reference"]:
                cells.append("no result")
                continue
            ratio = f"{one['work'] / own['work']:.2f}" if own["work"] > 0 else "–"
            found = errors(name, one, runs["reference"])
            worst = max(found, key=found.get, default=None)
            note = "" if name in REBOUNDING or same_verdict(runs, preset) else ", **verdict**"
            at = f" ({worst})" if worst and found[worst] >= 5e-6 else ""
            cells.append(ratio if preset == "reference" else
                         f"{ratio}, {percent(found[worst]) if worst else '–'}{at}{note}")
        scenes += row(cells)
    failed = [f"- {n}, {p} has no result: {one['failure']}\n" for n, r in results.items() for p, one in r.items() if "failure" in one]
    counts = {"@settings@": settings(), "@scenes@": str(len(results)), "@judged@": str(len(judged)), "@summary@": summary, "@table@": scenes,
              "@stiffness@": stiffness_table(json.loads(arguments.stiffness.read_text(encoding="utf-8"))), "@failed@": "".join(failed) or "All runs ended with a result.\n"}
    for key, value in counts.items():
        text = text.replace(key, value)
    arguments.page.write_text(text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    measuring = commands.add_parser("measure")
    measuring.add_argument("program")
    measuring.add_argument("--json", type=pathlib.Path, required=True)
    measuring.add_argument("--only", nargs="*", choices=SCENES, metavar="NAME")
    measuring.set_defaults(do=measure)
    stiffer = commands.add_parser("stiffness")
    stiffer.add_argument("program")
    stiffer.add_argument("--json", type=pathlib.Path, required=True)
    stiffer.add_argument("--only", nargs="*", choices=STIFF_SCENES, metavar="NAME")
    stiffer.set_defaults(do=stiffness)
    writing = commands.add_parser("page")
    writing.add_argument("file", type=pathlib.Path)
    writing.add_argument("stiffness", type=pathlib.Path)
    writing.add_argument("page", type=pathlib.Path)
    writing.set_defaults(do=page)
    arguments = parser.parse_args()
    return arguments.do(arguments)


if __name__ == "__main__":
    sys.exit(main())
