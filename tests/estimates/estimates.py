#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the estimated time of every sample with the time that its run takes.

    estimates.py measure PROGRAM --json FILE [--only NAME ...] [--repeat N]   PROGRAM is keyblock
    estimates.py page FILE PAGE                 writes the table to its section of a help page

The time is the CPU time of a run on one thread, the least of a few runs, because other programs can only prolong it. The
estimate is the middle one of as many. Fails if fewer than nine of ten samples are within half and double; a sample
whose run takes less than a second counts as met.
"""
import argparse
import json
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "samples"
TITLE = "## Estimated and measured time\n"
SHARE = 0.9
SHORT = 1.0  # [s]


def cpu_seconds(command):
    def used():
        now = resource.getrusage(resource.RUSAGE_CHILDREN)
        return now.ru_utime + now.ru_stime
    before = used()
    ended = subprocess.run(command, capture_output=True, text=True, check=False)
    return used() - before, ended


def estimate(program, scene):
    seconds, ended = cpu_seconds([program, "check", scene, "--json"])
    return json.loads(ended.stdout)["census"]["estimate"] | {"check_seconds": seconds}


def measure(arguments):
    results = json.loads(arguments.json.read_text(encoding="utf-8")) if arguments.json.exists() else {}
    names = arguments.only or sorted(path.stem for path in SAMPLES.glob("*.json"))
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            scene = SAMPLES / f"{name}.json"
            run = [arguments.program, "run", scene, "--threads", "1", "--overwrite", "--out", f"{folder}/run.kbrun",
                   "--progress", "none"]
            times = [cpu_seconds(run)[0] for _ in range(arguments.repeat)]
            estimates = [estimate(arguments.program, scene) for _ in range(arguments.repeat)]
            middle = sorted(estimates, key=lambda e: e["seconds"])[len(estimates) // 2]
            results[name] = {"measured": min(times), "estimate": middle["seconds"], "least": middle["seconds_least"],
                             "most": middle["seconds_most"],
                             "check": statistics.median(e["check_seconds"] for e in estimates)}
            print(name, *row_of(results[name]), sep="  ", flush=True)
            arguments.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    met = [name for name, one in results.items() if is_met(one)]
    print(f"{len(met)} of {len(results)} samples are met")
    return 0 if len(met) >= SHARE * len(results) else 1


def is_met(one):
    return one["measured"] < SHORT or one["least"] <= one["measured"] <= one["most"]


def shown(seconds):
    return f"{seconds:.2f}" if seconds < 10.0 else f"{seconds:.1f}"


def row_of(one):
    return [shown(one["estimate"]), f"{shown(one['least'])} to {shown(one['most'])}", shown(one["measured"]),
            f"{one['measured'] / one['estimate']:.2f}",
            "yes" if is_met(one) else "**no**"]


def section(results):
    met = [one for one in results.values() if is_met(one)]
    long = [one for one in results.values() if one["measured"] >= SHORT]
    text = TITLE + f"""
Made by `make estimates`. `keyblock check` and the model summary of the window run the beginning of the scene for half a second of CPU time and continue its pace; where bolts dominate, they also run the whole scene with fewer elements. The estimate is the CPU time on one thread, with a band from half to double of it; with more threads a large scene ends earlier. For {len(met)} of {len(results)} samples the measured time is in the band or less than a second, for {len([o for o in long if is_met(o)])} of the {len(long)} samples that take longer it is in the band. `check` itself took at most {shown(max(o['check'] for o in results.values()))} s.

| sample | estimate, s | band, s | measured, s | measured/estimate | met |
| --- | --- | --- | --- | --- | --- |
"""
    for name, one in sorted(results.items(), key=lambda item: -item[1]["measured"]):
        text += "| " + " | ".join([name, *row_of(one)]) + " |\n"
    return text


def page(arguments):
    """Replaces the section of the page, or adds it at the end."""
    text = arguments.page.read_text(encoding="utf-8")
    before, _, rest = text.partition(TITLE)
    after = rest.find("\n## ")
    new = section(json.loads(arguments.file.read_text(encoding="utf-8")))
    arguments.page.write_text(before.rstrip() + "\n\n" + new + (rest[after:] if after >= 0 else ""), encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(required=True)
    measuring = commands.add_parser("measure")
    measuring.add_argument("program")
    measuring.add_argument("--json", type=pathlib.Path, required=True)
    measuring.add_argument("--only", nargs="*", metavar="NAME")
    measuring.add_argument("--repeat", type=int, default=3)
    measuring.set_defaults(do=measure)
    writing = commands.add_parser("page")
    writing.add_argument("file", type=pathlib.Path)
    writing.add_argument("page", type=pathlib.Path)
    writing.set_defaults(do=page)
    arguments = parser.parse_args()
    return arguments.do(arguments)


if __name__ == "__main__":
    sys.exit(main())
