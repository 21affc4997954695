#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Proves the verdicts of static runs from their tables, without any code of the program.

    prove.py PROGRAM DIR SEED [SEED ...]             runs the scenes DIR/SEED.json and proves every equilibrium
    prove.py PROGRAM DIR --motion SEED [SEED ...]    continues the same scenes in motion and compares the verdicts

A stage that ends in equilibrium, or displaced, is proved at its last frame: force and moment on every free block within
2 % of its weight (from area, density and gravity), every contact in compression and within its friction (except in
intact rock), every bolt within its strength. The energy balance of every run closes to 1 %. In motion, an equilibrium
continues for 1 s under the same loads and no block may move more than 5 mm; for a collapse, the last equilibrium is
computed again, the rest of the load is applied over 0.3 s and followed for 1.5 s: every block that was named has to move
more than 5 % of its size, and every block that does so before the first of them has moved by its own size has to be named,
unless it was hit: touched by a block that had moved farther and had not touched it before. Blocks slower than 0.05 g get
the time in which they move by a fifth of their size.
"""
import argparse
import copy
import csv
import io
import json
import math
import pathlib
import subprocess
import sys

from drifts import seeds_of

SMALLEST = 0.01  # m2; smaller blocks do not affect the verdict
REST = 0.005  # m in 1 s
SLOW = 0.05 * 9.81  # m/s2; slower blocks are followed for longer
LONGEST = 20.0  # s
BALANCE = 0.01  # energy balance error, at the end of any run


def call(*words, codes=(0,)):
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True)
    if done.returncode not in codes:
        raise SystemExit(f"{' '.join(map(str, words))}: exit {done.returncode}\n{done.stderr}")
    return done


def table(program, run, name, *more):
    out = run.with_suffix(f".{name}.csv")
    call(program, "export", run, "--table", name, *more, "--out", out)
    rows = list(csv.DictReader(io.StringIO(out.read_text())))
    out.unlink()
    return rows


def info(program, run):
    return json.loads(call(program, "info", run, "--json").stdout)


def run_scene(program, scene, path):
    path.with_suffix(".json").write_text(json.dumps(scene))
    call(program, "run", path.with_suffix(".json"), "--out", path, "--overwrite", "--threads", 1, codes=(0, 5))
    return info(program, path)


def size(row):
    return math.sqrt(float(row["area_m2"]))


class Proof:
    """Errors in the last frame of a stage, as lines of text."""

    def __init__(self, program, run, scene, stage):
        self.scene, self.faults = scene, []
        at = ("--stage", stage, "--at", "last")
        self.blocks = {row["block"]: row for row in table(program, run, "blocks", *at) if float(row["area_m2"] or 0) > 0}
        self.contacts = table(program, run, "contacts", *at)
        self.forces = table(program, run, "forces", *at)
        self.bolts = table(program, run, "bolts", *at)

    def weight(self, row):
        material = next(iter(self.scene["materials"].values()))
        return float(row["area_m2"]) * material["density"] * math.hypot(*self.scene["analysis"]["gravity"])

    def balance(self):
        """Weight from the area, all other forces from the table of forces, moments about the centroid recomputed."""
        worst = (0.0, "")
        for name, row in self.blocks.items():
            if float(row["area_m2"]) < SMALLEST:
                continue
            weight, x, y = self.weight(row), float(row["x_m"]), float(row["y_m"])
            gravity = self.scene["analysis"]["gravity"]
            fx = weight * gravity[0] / math.hypot(*gravity)
            fy = weight * gravity[1] / math.hypot(*gravity)
            moment = 0.0
            for force in self.forces:
                if force["block"] != name or force["source"] in ("weight", "inertia"):
                    continue
                px, py = float(force["fx_N"]), float(force["fy_N"])
                fx, fy = fx + px, fy + py
                arm = (float(force["x_m"]) - x) * py - (float(force["y_m"]) - y) * px
                moment += arm if force["source"] == "contact" else float(force["moment_Nm"])
            share = max(math.hypot(fx, fy), abs(moment) / size(row)) / weight
            worst = max(worst, (share, name))
            if share > 0.02:
                self.faults.append(f"block {name}: {share:.3g} of its weight unbalanced")
        return worst

    def friction(self):
        largest = max((abs(float(c["normal_force_N"])) for c in self.contacts), default=0.0)
        for c in self.contacts:
            if c["joint_material"] == "intact":  # divided only by the outline of rock that is not yet excavated, without a joint
                continue
            normal, shear = float(c["normal_force_N"]), abs(float(c["shear_force_N"]))
            tangent = math.tan(math.radians(self.scene["joint_materials"]["joint"]["friction_angle"]))
            where = f"contact of {c['block_a']} and {c['block_b']}"
            if normal < -1e-6 * largest:
                self.faults.append(f"{where} is in tension with {-normal:.3g} N")
            if shear > normal * tangent * (1 + 1e-6) + 1e-9 * largest:
                self.faults.append(f"{where} carries {shear:.6g} N in shear, its friction limit is {normal * tangent:.6g} N")

    def strength(self):
        for bolt in self.bolts:
            steel = STEEL.get(self.scene["bolt_patterns"][0]["type"]) if "bolt_patterns" in self.scene else None
            if steel and abs(float(bolt["axial_force_N"] or 0)) > steel * (1 + 1e-3):
                self.faults.append(f"bolt {bolt['bolt']} carries {bolt['axial_force_N']} N, its steel {steel:.4g} N")

    def prove(self):
        worst = self.balance()
        self.friction()
        self.strength()
        return worst


# Area times the largest stress of the steel [N], from the library.
STEEL = {"d-bolt-20": 197920.4, "expansion-shell-17": 148050.0, "cone-bolt-17": 185881.6, "rebar-20": 197920.4, "split-set-47": 169860.0}


def prove(program, folder, seed):
    scene = json.loads((folder / f"{seed}.json").read_text())
    run = folder / f"{seed}.kbrun"
    told = run_scene(program, scene, folder / f"{seed}.kbrun")
    outcomes = [stage["outcome"] for stage in told["stages"]]
    worst, faults = (0.0, ""), []
    for stage in told["stages"]:
        if stage["outcome"] in ("equilibrium", "displaced"):
            proof = Proof(program, run, scene, stage["name"])
            worst = max(worst, proof.prove())
            faults += [f"{stage['name']}: {fault}" for fault in proof.faults]
    if abs(told["health"]["balance_error"]) > BALANCE:
        faults.append(f"energy balance error {told['health']['balance_error']:.2g}")
    print(f"{seed:>4} {outcomes[-1]:<12} stands {told['verdict']['stands']!s:<6} worst {worst[0]:.2g} {worst[1]:<6} "
          f"balance {told['health']['balance_error']:.1e}", *faults, sep="\n     ", flush=True)
    return told, faults


def motion(name, duration, **more):
    return {"name": name, "kind": "dynamic", "duration": duration, "time_step": 1e-3, **more}


def rows_since(program, run, name, start):
    """Rows of a table in all frames from stage `start` on, with the time since its beginning."""
    order, clock, before, last = [stage["name"] for stage in info(program, run)["stages"]], 0.0, None, 0.0
    for row in table(program, run, name, "--at", "all"):
        if order.index(row["stage"]) < order.index(start):
            continue
        if row["stage"] != before:
            clock, before = clock + (last if before else 0.0), row["stage"]
        last = float(row["time_s"])
        yield clock + last, row


def moves(program, run, start):
    """For every block, a row per frame since the start of stage `start`: time, and movement of its centroid."""
    tracks = {}
    for time, row in rows_since(program, run, "blocks", start):
        if not float(row["area_m2"] or 0) > 0:
            continue
        place = (float(row["x_m"]), float(row["y_m"]))
        first = tracks.setdefault(row["block"], {"place": place, "size": size(row), "area": float(row["area_m2"]), "way": []})
        first["way"].append((time, math.dist(place, first["place"])))
    return tracks


def hits(program, run, start):
    """For every block, when it touched which block that it did not touch when stage `start` began."""
    began, touching, found = None, set(), {}
    for time, row in rows_since(program, run, "contacts", start):
        began = time if began is None else began
        pair = frozenset((row["block_a"], row["block_b"]))
        if time == began:
            touching.add(pair)
        elif len(pair) == 2 and pair not in touching:
            touching.add(pair)
            for block in pair:
                found.setdefault(block, []).append((time, *(pair - {block})))
    return found


def moved(track, until):
    return max((way for time, way in track["way"] if time <= until), default=0.0)


def is_hit(name, found, tracks, until):
    """True if the block was touched, up to a time, by a block that had moved farther than itself."""
    return any(time <= until and other in tracks and moved(tracks[other], time) > moved(tracks[name], time)
               for time, other in found.get(name, []))


def patience(track):
    """Time [s] in which a block slower than 0.05 g, at its mean acceleration so far, moves by a fifth of its size."""
    time, way = track["way"][-1]
    acceleration = 2 * way / time**2
    return math.sqrt(0.4 * track["size"] / acceleration) if 0 < acceleration < SLOW else 0.0


def reached(track, way):
    return next((time for time, gone in track["way"] if gone > way), math.inf)


def told_by(seed, outcome, agrees, words):
    print(f"{seed:>4} {outcome:<12} {words}: {'agrees' if agrees else 'DIFFERS'}", flush=True)
    return agrees


def follow_equilibrium(program, scene, run, seed):
    scene["stages"].append(motion("motion", 1.0))
    run_scene(program, scene, run)
    gone = {name: t["way"][-1][1] for name, t in moves(program, run, "motion").items() if t["area"] >= SMALLEST}
    worst = max(gone, key=gone.get)
    return told_by(seed, "equilibrium", gone[worst] <= REST, f"block {worst} moved {1e3 * gone[worst]:.3g} mm in 1 s")


def share_of_relaxation(stages, index, share):
    """Relaxation at a share of a stage that changes it, between that of the stages before and its own."""
    before = max((stage.get("relaxation", 0.0) for stage in stages[:index]), default=0.0)
    return before + (stages[index].get("relaxation", 1.0) - before) * share


def follow_collapse(program, scene, run, seed, told, time=1.5):
    """`time`: how long the blocks are followed after the whole load is on. Slow ones may need longer."""
    last, stages = told["stages"][-1], copy.deepcopy(scene["stages"])
    index = next(i for i, stage in enumerate(stages) if stage["name"] == last["name"])
    stages[index]["relaxation"] = share_of_relaxation(stages, index, last["time_s"])
    moving = scene | {"stages": stages[: index + 1] + [motion("load", 0.3, relaxation=1), motion("motion", time)]}
    again = run_scene(program, moving, run)["stages"][index]["outcome"]
    if again not in ("equilibrium", "displaced"):  # both are balanced
        words = f"the last equilibrium, at {last['time_s']:.3g} of {last['name']}, is {again} when computed again"
        return told_by(seed, "collapse", False, words)
    tracks = moves(program, run, "load")
    named = {block["block"] for block in told["verdict"]["blocks"]}
    goes = {name: reached(track, 0.05 * track["size"]) for name, track in tracks.items()}
    still = [name for name in named if goes[name] == math.inf]
    longer = max((patience(tracks[name]) for name in still), default=0.0)
    if time < longer <= LONGEST:
        return follow_collapse(program, scene, run, seed, told, longer)
    first = min(reached(tracks[name], tracks[name]["size"]) for name in named)
    unnamed = [name for name, t in tracks.items() if t["area"] >= SMALLEST and name not in named and goes[name] < first]
    found = hits(program, run, "load") if unnamed else {}
    excepted = [name for name in unnamed if is_hit(name, found, tracks, goes[name])]
    unnamed = [name for name in unnamed if name not in excepted]
    words = (f"named {len(named)}, first moved by its size after {first:.2f} s of {time + 0.3:.2f} s; at rest {still}, "
             f"not named {unnamed}, hit {excepted}")
    return told_by(seed, "collapse", not still and not unnamed, words)


def follow(program, folder, seed):
    scene = json.loads((folder / f"{seed}.json").read_text())
    told = run_scene(program, scene, folder / f"{seed}.kbrun")
    outcome, run = told["stages"][-1]["outcome"], folder / f"{seed}-motion.kbrun"
    # frames at given times would end increments there: the last equilibrium would be another one
    moving = copy.deepcopy(scene) | {"output": {}}
    if outcome == "equilibrium":
        return follow_equilibrium(program, moving, run, seed)
    if outcome == "collapse":
        return follow_collapse(program, moving, run, seed, told)
    print(f"{seed:>4} {outcome}: not followed", flush=True)
    return True


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("seeds", nargs="+")
    parser.add_argument("--motion", action="store_true")
    asked = parser.parse_args()
    asked.seeds = seeds_of(asked.seeds)
    if asked.motion:
        wrong = sum(not follow(asked.program, asked.folder, seed) for seed in asked.seeds)
        print(f"{len(asked.seeds)} followed, {wrong} differ")
    else:
        wrong = sum(bool(prove(asked.program, asked.folder, seed)[1]) for seed in asked.seeds)
        print(f"{len(asked.seeds)} run, {wrong} not proved")
    sys.exit(1 if wrong else 0)
