# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes whose steps are timed, each as a dictionary in the scene format.

wall    running bond of 1 m x 0.5 m bricks on a fixed slab, settled, then at rest
shaken  the same under a body acceleration of up to 0.1 g along it at 5 Hz, so that every step is solved although nothing slides
tilt    the same with 20 degrees of friction and a body acceleration of g sin 25 degrees along it: it slides and topples
tunnel  cells of 1 m between a fixed floor and fixed walls; those within 4 m of the middle are removed at once
drift   the sample drift-unbolted, and with more rock around it as drift-large: the key block falls while the other blocks are at rest
collapse  a horseshoe 11 m wide in three joint sets, static, without bolts
pulled  blocks that hang from a fixed roof on grouted bars, static, pulled down until the bond of every bar has failed
"""
import json
import math
import pathlib

SAMPLES = pathlib.Path(__file__).resolve().parents[3] / "samples"
GRAVITY = 9.81  # m/s2
STONE = {"density": 2500, "youngs_modulus": 10e9, "poissons_ratio": 0.2}


def box(left, bottom, width, height, **more):
    right, top = left + width, bottom + height
    points = [[left, bottom], [right, bottom], [right, top], [left, top]]
    return {"points": points, "material": "stone", "joint_material": "joint"} | more


def scene(title, stages, **parts):
    return {
        "format": "keyblock-scene",
        "version": 1,
        "title": title,
        "analysis": {"gravity": [0, -GRAVITY], "tolerance": 1e-4, "penalty_ratio": 40},
        "materials": {"stone": STONE},
        "joint_materials": {"joint": {"friction_angle": 30}},
        "stages": [{"name": "settle", "kind": "static"}] + stages,
        "output": {"frames": 1},
    } | parts


def bricks(columns, rows):
    blocks = [box(-1, -1, columns + 2.5, 1)]
    for row in range(rows):
        shifted = row % 2
        if shifted:
            blocks += [box(0, 0.5 * row, 0.5, 0.5)]
        blocks += [box(column + 0.5 * shifted, 0.5 * row, 1, 0.5) for column in range(columns - shifted)]
        if shifted:
            blocks += [box(columns - 0.5, 0.5 * row, 0.5, 0.5)]
    return blocks


def rebars(columns, rows, count=100, length=1.2):
    """Rebars of 60 divisions, evenly spread over the wall and slightly inclined, so that each crosses two or three bricks."""
    bolts = []
    per_row = 10
    for i in range(count):
        x = (i % per_row + 0.5) * (columns - 2) / per_row + 0.37
        y = (i // per_row + 0.5) * (0.5 * rows - 1) / (count // per_row) + 0.21
        ends = {"far_end": [round(x, 3), round(y, 3)], "head": [round(x + length, 3), round(y + 0.31, 3)]}
        bolts.append({"name": f"R{i + 1}", "type": "rebar-20", "divisions": 60} | ends)
    return bolts


def wall(columns, rows, steps=100, bolted=False):
    stage = {"name": "wall", "kind": "dynamic", "duration": steps * 1e-3, "time_step": 1e-3}
    parts = {"blocks": bricks(columns, rows), "supports": [{"block_at": [0.5, -0.5], "fix": "all"}]}
    if bolted:
        parts["bolts"] = rebars(columns, rows)
    return scene(f"wall of {columns} x {rows}", [stage], **parts)


def shaken(columns, rows, steps=100):
    """Nothing slides, but loads change in every step, so that every step is solved."""
    wall_shaken = wall(columns, rows, steps)
    wall_shaken["stages"][-1]["body_acceleration"] = {"axis": "x", "sine": {"amplitude": 0.1 * GRAVITY, "frequency": 5}}
    return wall_shaken


def tilt(columns, rows, steps=100, time_step=1e-3, bolted=False):
    tilted = wall(columns, rows, bolted=bolted)
    tilted["title"] = f"tilted wall of {columns} x {rows}"
    tilted["stages"][-1] |= {
        "duration": steps * time_step,
        "time_step": time_step,
        "set": [{"joint_material": "joint", "friction_angle": 20}],
        "body_acceleration": {"axis": "x", "value": GRAVITY * math.sin(math.radians(25))},
    }
    return tilted


def tunnel(steps=90, time_step=1e-3):
    stage = {"name": "dig", "kind": "dynamic", "duration": steps * time_step, "time_step": time_step, "excavate": ["hole"]}
    held = [[0, -17], [-17, 0], [17, 0]]
    return scene(
        "hole dug into cells",
        [stage],
        domain={
            "boundary": [[-16, -16], [16, -16], [16, 16], [-16, 16]],
            "material": "stone",
            "joint_material": "joint",
        },
        voronoi={"size": 1, "seed": 1, "joint_material": "joint"},
        tunnels=[{"name": "hole", "profile": "circle", "center": [0, 0], "diameter": 8}],
        blocks=[box(-18, -18, 36, 2, name="floor"), box(-18, -16, 2, 32, name="west"), box(16, -16, 2, 32, name="east")],
        supports=[{"block_at": at, "fix": "all"} for at in held],
    )


def collapse(half=16, depth=60):
    unit_weight = 2700 * GRAVITY  # N/m3
    above = unit_weight * (depth - half)
    sets = [(62, 2.2), (-55, 2.2), (8, 2.5)]
    shoe = scene(
        "horseshoe that collapses",
        [{"name": "open", "kind": "static", "excavate": ["horseshoe"]}],
        materials={"rock": {"density": 2700, "youngs_modulus": 30e9, "poissons_ratio": 0.2}},
        joint_materials={"joint": {"friction_angle": 35}},
        domain={
            "boundary": [[-half, -half], [half, -half], [half, half], [-half, half]],
            "material": "rock",
            "joint_material": "joint",
        },
        joint_sets=[
            {"name": f"J{i}", "dip": dip, "spacing": spacing, "origin": [0.3 * i, 0.2 + 0.17 * i], "joint_material": "joint"}
            for i, (dip, spacing) in enumerate(sets)
        ],
        tunnels=[{"name": "horseshoe", "profile": "horseshoe", "center": [0, 0], "width": 11, "height": 9}],
        supports=[
            {"boundary": "bottom", "fix": "xy"},
            {"boundary": "left", "fix": "x"},
            {"boundary": "right", "fix": "x"},
        ],
        in_situ_stress={
            "syy": -above,
            "sxx": -0.5 * above,
            "gradient_y": {"syy": unit_weight, "sxx": 0.5 * unit_weight},
            "reference_y": half,
        },
    )
    shoe["analysis"] = {"gravity": [0, -GRAVITY]}
    shoe["stages"][0]["loads"] = [{"along": [[-half, half], [half, half]], "pressure": above}]
    return shoe


def sample(name):
    return json.loads((SAMPLES / f"{name}.json").read_text(encoding="utf-8"))


def large_drift(half=27, rest=0.2, duration=0.7):
    """The unbolted drift in more rock. The key block falls. In the last stage the other blocks no longer vibrate, and it
    ends before the key block lands."""
    drift = sample("drift-unbolted")
    drift["domain"]["boundary"] = [[-half, 2 - half], [half, 2 - half], [half, half], [-half, half]]
    drift["in_situ_stress"]["reference_y"] = half
    lengths = {"come to rest": rest, "fall": duration}
    drift["stages"][3:] = [{"name": n, "kind": "dynamic", "duration": d, "time_step": 0.002} for n, d in lengths.items()]
    drift["output"] = {"frames": 1}
    return {key: value for key, value in drift.items() if key not in ("expected", "quantities")}


def pulled(blocks=20, bars=10, divisions=12):
    """Each block moves further than the one before, so that the bars of different blocks do not fail at once."""
    width, hanging, bolts, motions = 2.0, [], [], []
    for i in range(blocks):
        left = i * width
        hanging.append(box(left, -0.6, width, 0.6))
        motions.append({"block_at": [left + 0.5 * width, -0.5], "axis": "y", "table": [[0, 0], [1, -0.02 - 0.001 * i]]})
        for k in range(bars):
            x = round(left + (k + 0.5) * width / bars, 3)
            ends = {"far_end": [x, 1.0], "head": [x, -0.2]}
            bolts.append({"name": f"R{len(bolts) + 1}", "type": "rebar-20", "divisions": divisions} | ends)
    roof = box(-0.5, 0, blocks * width + 1, 1.2)
    hung = scene(f"{len(bolts)} grouted bars pulled until their bond fails", [], blocks=[roof] + hanging, bolts=bolts)
    hung["analysis"]["gravity"] = [0, 0]
    hung["supports"] = [{"block_at": [0.0, 0.6], "fix": "all"}]
    hung["stages"] = [{"name": "pull", "kind": "static", "motions": motions}]
    return hung


def awake(scene):
    scene["analysis"]["model_everything"] = True
    return scene


def all_scenes(large):
    """Pairs of a name and a scene; `large` adds those of 5,000 blocks and more."""
    yield "wall-settled", wall(40, 26, steps=10000)
    yield "wall-awake", awake(wall(40, 26))
    yield "wall-shaken", awake(shaken(40, 26))
    yield "tilt", tilt(20, 13)
    yield "tilt", tilt(40, 26)
    yield "tilt-fine", tilt(40, 26, time_step=1e-4)
    yield "tunnel", tunnel()
    yield "tunnel-fine", tunnel(time_step=1e-4)
    yield "wall-bolts", awake(wall(40, 26, bolted=True))
    yield "wall-bolts-settled", wall(40, 26, steps=10000, bolted=True)
    yield "tilt-bolts", tilt(40, 26, bolted=True)
    yield "drift", sample("drift-unbolted")
    yield "drift-large", large_drift()
    yield "drift-large-awake", awake(large_drift())
    yield "collapse", collapse()
    yield "pulled", pulled(blocks=2)
    if large:
        yield "pulled", pulled()
        yield "wall-settled", wall(90, 56, steps=10000)
        yield "wall-settled", wall(180, 112, steps=10000)
        yield "wall-awake", awake(wall(90, 56, steps=20))
        yield "tilt", tilt(90, 56, steps=20)
        yield "wall-awake", awake(wall(180, 112, steps=10))
        yield "tilt", tilt(180, 112, steps=5)
