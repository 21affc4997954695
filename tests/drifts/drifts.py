#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random drifts in jointed rock, one scene for each seed, against which the static verdict is checked.

Two or three joint sets, depths of 30 to 300 m and every tenth at 1,000 m, stress ratios of 0.4 to 1.2, friction of 22 to
42 degrees. Of every five seeds three have no bolts; two install a pattern of at most 20 bolts after a part of the walls'
forces is released. A seed gives the same scene on every machine.

    drifts.py SEED [SEED ...] --out DIR        writes DIR/SEED.json; SEED may be a range, 1-200
"""
import argparse
import json
import math
import pathlib
import random

UNIT_WEIGHT = 2700 * 9.81  # N/m3
BOLT_TYPES = ["d-bolt-20", "expansion-shell-17", "cone-bolt-17", "rebar-20", "split-set-47"]


def joint_sets(draw):
    dips = [draw.uniform(40, 80), -draw.uniform(40, 80), draw.uniform(-15, 15)][: draw.choice([2, 2, 3])]
    return [
        {
            "name": f"J{i + 1}",
            "dip": round(dip, 1),
            "spacing": round(draw.uniform(1.1, 2.4), 2),
            "origin": [round(draw.uniform(-1, 1), 2), round(draw.uniform(-1, 1), 2)],
            "joint_material": "joint",
        }
        for i, dip in enumerate(dips)
    ]


def pattern(draw, width, height):
    """From springline to springline over the roof; the spacing limits it to 20 bolts."""
    arc = math.pi * width / 2 + 2 * 0.1 * height
    return {
        "name": "roof",
        "type": draw.choice(BOLT_TYPES),
        "tunnel": "drift",
        "from": [width / 2, 0.1 * height],
        "to": [-width / 2, 0.1 * height],
        "way": "ccw",
        "spacing": round(max(draw.uniform(1.0, 1.6), arc / 19), 2),
        "length": round(draw.uniform(1.8, 3.0), 2),
    }


def drift(seed):
    draw = random.Random(seed)
    depth = 1000.0 if seed % 10 == 0 else math.exp(draw.uniform(math.log(30), math.log(300)))
    ratio = draw.uniform(0.4, 1.2)
    width, height = round(draw.uniform(3.5, 6.0), 2), round(draw.uniform(3.5, 5.5), 2)
    height = min(height, round(1.3 * width, 2))  # higher ones would have no floor
    half = max(12.0, 2.5 * width)
    scene = {
        "format": "keyblock-scene",
        "version": 1,
        "title": f"Drift {seed}",
        "analysis": {"plane": "strain", "gravity": [0, -9.81]},
        "materials": {
            "granite": {
                "density": 2700,
                "youngs_modulus": draw.choice([20e9, 50e9]),
                "poissons_ratio": 0.2,
            }
        },
        "joint_materials": {"joint": {"friction_angle": round(draw.uniform(22, 42), 2)}},
        "domain": {
            "boundary": [[-half, -half + 1], [half, -half + 1], [half, half], [-half, half]],
            "material": "granite",
            "joint_material": "joint",
        },
        "joint_sets": joint_sets(draw),
        "tunnels": [
            {
                "name": "drift",
                "profile": draw.choice(["d-shape", "d-shape", "horseshoe"]),
                "center": [0, 0],
                "width": width,
                "height": height,
            }
        ],
        "supports": [
            {"boundary": "bottom", "fix": "xy"},
            {"boundary": "left", "fix": "x"},
            {"boundary": "right", "fix": "x"},
        ],
        "in_situ_stress": {
            "gradient_y": {"sxx": round(ratio * UNIT_WEIGHT, 1), "syy": UNIT_WEIGHT},
            "reference_y": round(depth, 2),
        },
        "stages": [
            {
                "name": "settle",
                "kind": "static",
                "loads": [{"along": [[-half, half], [half, half]], "pressure": round(UNIT_WEIGHT * (depth - half), 1)}],
            },
            {"name": "excavate", "kind": "static", "excavate": ["drift"]},
        ],
        "output": {"frames": 4},
    }
    if seed % 5 in (3, 4):
        scene["bolt_patterns"] = [pattern(draw, width, height)]
        scene["stages"][1]["relaxation"] = round(draw.uniform(0.2, 0.6), 2)
        scene["stages"] += [
            {"name": "bolt", "kind": "static", "install": ["roof"]},
            {"name": "release", "kind": "static", "relaxation": 1},
        ]
    return scene


def seeds_of(words):
    seeds = []
    for word in words:
        first, _, last = word.partition("-")
        seeds += range(int(first), int(last or first) + 1)
    return seeds


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seeds", nargs="+")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    asked = parser.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    for seed in seeds_of(asked.seeds):
        (asked.out / f"{seed}.json").write_text(json.dumps(drift(seed), indent=1) + "\n")
