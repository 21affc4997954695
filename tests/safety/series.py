#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Factors of safety checked against closed forms: forty scenes, each with its expected factor.

    series.py PROGRAM --out DIR [--only TEXT]              'keyblock safety' on every scene, one row each
    series.py PROGRAM --out DIR [--only TEXT] --monotone   30 factors per scene, each an ordinary run; after the first failure all must fail

Roof prisms supported by horizontal stress (10): joints of given stiffness, so a sinking prism loses normal force. At the
critical friction angle f, with H = stress x height (Crawford and Bray 1983; Brady and Brown 2004),
    W = 2 H (ks cos2 a + kn sin2 a) sin(f - a) / (ks cos a cos f + kn sin a sin f),   F = tan phi / tan f.
The same prisms without stress (10): both faces overhang, so they fall at every factor and have no number.
Blocks in a roof that slide on one joint while the other opens (10), and wedges on a joint that daylights in a slope (10):
    F = tan phi / tan dip.
Exit code 1 if a scene misses its tolerance.
"""
import argparse
import copy
import json
import math
import pathlib
import resource
import subprocess
import sys
import time
from dataclasses import dataclass

GRAVITY = 9.81  # m/s2
UNIT_WEIGHT = 26e3  # N/m3
NORMAL_STIFFNESS = 10e9  # Pa/m

# half-angle and friction angle [deg], ks/kn, horizontal stress [Pa]; the base is 2 m wide
PRISMS = [
    (10, 30, 1.0, 67e3),
    (10, 40, 0.4, 61e3),
    (12, 35, 0.1, 62e3),
    (15, 30, 0.7, 70e3),
    (15, 45, 0.2, 62e3),
    (20, 40, 1.0, 57e3),
    (20, 40, 0.1, 49e3),
    (25, 45, 0.4, 76e3),
    (25, 50, 0.1, 80e3),
    (30, 50, 1.0, 54e3),
]
# dip of the joint below, dip of the joint above, friction angle [deg]; the base is 1 m wide
OVERHANGS = [
    (30, 20, 35),
    (35, 24, 30),
    (35, 23, 45),
    (40, 28, 50),
    (45, 32, 40),
    (45, 30, 55),
    (50, 37, 60),
    (55, 42, 45),
    (60, 47, 65),
    (65, 54, 60),
]
# dip of the joint, slope of the face, friction angle [deg], height of the joint above the toe [m]
SLOPES = [
    (15, 60, 20, 2.0),
    (20, 70, 35, 1.0),
    (25, 60, 20, 3.0),
    (30, 75, 45, 2.0),
    (33, 65, 30, 1.5),
    (35, 65, 45, 2.0),
    (40, 70, 60, 3.0),
    (45, 80, 40, 1.0),
    (50, 75, 65, 2.0),
    (55, 80, 70, 1.5),
]


@dataclass
class Scene:
    name: str
    document: dict
    expected: float | None  # None: falls with any strength
    tolerance: float  # relative


def radians(angle):
    return angle * math.pi / 180


def document(title, friction, boundary, joints, held, stiffness=None):
    joint = {"friction_angle": friction, "cohesion": 0, "tensile_strength": 0}
    if stiffness:
        joint |= {"normal_stiffness": stiffness[0], "shear_stiffness": stiffness[1]}
    return {
        "format": "keyblock-scene",
        "version": 1,
        "title": title,
        "analysis": {"plane": "strain", "thickness": 1, "gravity": [0, -GRAVITY]},
        "materials": {"rock": {"density": UNIT_WEIGHT / GRAVITY, "youngs_modulus": 6e13, "poissons_ratio": 0.25}},
        "joint_materials": {"joint": joint},
        "domain": {"boundary": boundary, "material": "rock", "joint_material": "joint"},
        "joints": [{"name": f"joint {i + 1}", "points": line, "joint_material": "joint"} for i, line in enumerate(joints)],
        "supports": [{"boundary": held, "fix": "all"}],
        "stages": [{"name": "gravity", "kind": "static"}],
    }


def box(left, bottom, right, top):
    return [[left, bottom], [right, bottom], [right, top], [left, top]]


def prism_document(half_angle, friction, ratio, stress):
    height = 1 / math.tan(radians(half_angle))
    title = f"Roof prism, half-angle {half_angle} deg, friction {friction} deg, ks/kn {ratio}, {stress / 1e3:g} kPa"
    stiffness = (NORMAL_STIFFNESS, ratio * NORMAL_STIFFNESS)
    made = document(title, friction, box(-3, 0, 3, 1.4 * height), [[[-1, 0], [0, height], [1, 0]]], "top", stiffness)
    if stress > 0:
        made["in_situ_stress"] = {"sxx": -stress, "syy": 0, "sxy": 0}
    return made


def prism_factor(half_angle, friction, ratio, stress):
    """By bisection; sin(f - a) rises with f and the denominator changes little, so there is one root."""
    a = radians(half_angle)
    height = 1 / math.tan(a)
    stiffness = ratio * math.cos(a) ** 2 + math.sin(a) ** 2

    def held(f):
        lost = ratio * math.cos(a) * math.cos(f) + math.sin(a) * math.sin(f)
        return 2 * stress * height * stiffness * math.sin(f - a) / lost

    low, high = a, math.pi / 2
    while high - low > 1e-12:
        middle = (low + high) / 2
        low, high = (low, middle) if held(middle) > UNIT_WEIGHT * height else (middle, high)
    return math.tan(radians(friction)) / math.tan(high)


def overhang_document(below, above, friction):
    """A triangle over a base of 1 m in the roof, its apex where the two joints meet, mirrored for every even friction."""
    cot_below, cot_above = 1 / math.tan(radians(below)), 1 / math.tan(radians(above))
    height = 1 / (cot_above - cot_below)
    apex = height * cot_above
    size = math.hypot(apex - (1 + apex) / 3, height - height / 3)
    if (1 + apex) / 3 - 0.1 * size * math.cos(radians(below)) <= 1:
        raise SystemExit(f"overhang {below}/{above}: the block tilts over the edge before it has slid a tenth of its size")
    sign = 1 if friction % 2 else -1
    boundary = box(-2, 0, apex + 2, height + 2)
    joints = [[[0, 0], [apex, height], [1, 0]]]
    title = f"Overhanging block on a joint of {below} deg under one of {above} deg, friction {friction} deg"
    mirrored = [[[sign * x, y] for x, y in line] for line in [boundary] + joints]
    return document(title, friction, mirrored[0], mirrored[1:], "top")


def slope_document(dip, face, friction, above_toe):
    tan_dip, tan_face, top = math.tan(radians(dip)), math.tan(radians(face)), 10.0
    boundary = [[-5, -5], [40, -5], [40, top], [top / tan_face, top], [0, 0], [-5, 0]]
    daylight = above_toe / tan_face
    reach = (top - above_toe) / tan_dip
    joint = [[daylight - 0.05, above_toe - 0.05 * tan_dip], [daylight + reach + 0.05, top + 0.05 * tan_dip]]
    title = f"Plane slide on a joint of {dip} deg in a slope of {face} deg, friction {friction} deg"
    return document(title, friction, boundary, [joint], "bottom")


def plane_factor(friction, dip):
    return math.tan(radians(friction)) / math.tan(radians(dip))


def scenes():
    found = []
    for row in PRISMS:
        found.append(Scene(f"prism-{len(found) + 1:02}", prism_document(*row), prism_factor(*row), 0.05))
    for i, (half_angle, friction, ratio, _) in enumerate(PRISMS):
        found.append(Scene(f"loose-{i + 1:02}", prism_document(half_angle, friction, ratio, 0), None, 0.0))
    for i, row in enumerate(OVERHANGS):
        found.append(Scene(f"overhang-{i + 1:02}", overhang_document(*row), plane_factor(row[2], row[0]), 0.01))
    for i, row in enumerate(SLOPES):
        found.append(Scene(f"slope-{i + 1:02}", slope_document(*row), plane_factor(row[2], row[0]), 0.01))
    return found


class Timed:
    """One run of the program: exit code, output and CPU seconds."""

    def __init__(self, *words):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.code, self.out, self.err = done.returncode, done.stdout, done.stderr
        self.seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


def number(value):
    return "-" if value is None else f"{value:.4f}"


def miss_of(scene, answer):
    """The error in an answer; empty if there is none. The expected factor must be within tolerance of both ends."""
    lower, upper = answer["factor"]["lower"], answer["factor"]["upper"]
    if scene.expected is None:
        return "" if answer["answer"] == "falls_always" and lower is None else "should fall at every factor"
    if answer["answer"] != "bracketed":
        return "no bracket"
    off = max(abs(lower - scene.expected), abs(upper - scene.expected))
    return "" if off <= scene.tolerance * scene.expected else "beyond tolerance"


def check_factor(program, folder, scene):
    made = copy.deepcopy(scene.document)
    made["safety"] = {"reduce": "joints", "tolerance": 0.002 * (scene.expected or 1)}
    path = folder / f"{scene.name}.json"
    path.write_text(json.dumps(made, indent=1))
    done = Timed(program, "safety", path, "--json", "--threads", 1, "--out", folder / f"{scene.name}-safety", "--overwrite")
    if done.code != 0 or not done.out:
        print(f"{scene.name:12} exit {done.code}: {done.err.strip()}")
        return False
    answer = json.loads(done.out)
    lower, upper = answer["factor"]["lower"], answer["factor"]["upper"]
    miss = miss_of(scene, answer)
    error = ""
    if scene.expected and lower is not None and upper is not None:
        error = f"{100 * ((lower + upper) / 2 / scene.expected - 1):+.2f} %"
    verdict = answer["answer"] + (f"  MISS: {miss}" if miss else "")
    runs = len(answer["runs"])
    bracket = f"{number(lower)} {number(upper)}"
    print(f"{scene.name:12} {number(scene.expected):>8} {bracket:>16} {error:>8} {runs:>4} {done.seconds:>7.1f}  {verdict}")
    return not miss


def factors(scene):
    """Thirty from a quarter to four times the expected factor, closer near it; for loose prisms over the whole search range."""
    spread = [2 * i / 29 - 1 for i in range(30)]
    if scene.expected is None:
        return [1000**x for x in spread]
    return [scene.expected * 4 ** (x * abs(x)) for x in spread]


def outcome_at(program, folder, scene, factor):
    made = copy.deepcopy(scene.document)
    joint = made["joint_materials"]["joint"]
    joint["friction_angle"] = math.degrees(math.atan(math.tan(radians(joint["friction_angle"])) / factor))
    path = folder / f"{scene.name}-one.json"
    path.write_text(json.dumps(made))
    run = path.with_suffix(".kbrun")
    done = Timed(program, "run", path, "--out", run, "--overwrite", "--threads", 1)
    if done.code not in (0, 5):
        raise SystemExit(f"{scene.name} at {factor}: exit {done.code}\n{done.err}")
    stands = json.loads(Timed(program, "info", run, "--json").out)["verdict"]["stands"]
    return {True: "S", False: "f", None: "?"}[stands], done.seconds


def check_monotone(program, folder, scene):
    tried = factors(scene)
    found = [outcome_at(program, folder, scene, factor) for factor in tried]
    text = "".join(outcome for outcome, _ in found)
    expected = "".join("S" if scene.expected and factor < scene.expected else "f" for factor in tried)
    decided = text.replace("?", "")
    good = "fS" not in decided and text.count("?") == 0
    verdict = "" if good else "  MISS: not monotone" if "fS" in decided else "  MISS: undecided"
    note = "" if text == expected or not good else "  changes, but not at the closed form"
    print(f"{scene.name:12} {text}  {sum(seconds for _, seconds in found):7.1f}{verdict}{note}")
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--only", default="", help="scenes whose name contains this text")
    parser.add_argument("--monotone", action="store_true")
    asked = parser.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    chosen = [scene for scene in scenes() if asked.only in scene.name]
    if asked.monotone:
        print(f"{'scene':12} {'S stable, f fails, ? undecided':30}  {'CPU s':>7}")
    else:
        print(f"{'scene':12} {'expected':>8} {'bracket':>16} {'error':>8} {'runs':>4} {'CPU s':>7}  answer")
    check = check_monotone if asked.monotone else check_factor
    started = time.monotonic()
    good = 0
    for scene in chosen:
        good += check(asked.program.absolute(), asked.out.absolute(), scene)
        sys.stdout.flush()
    print(f"{good} of {len(chosen)} scenes within tolerance, {time.monotonic() - started:.0f} s")
    sys.exit(0 if good == len(chosen) else 1)


if __name__ == "__main__":
    main()
