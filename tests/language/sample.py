#!/usr/bin/python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws texts of the window and comments of public declarations for somebody who reviews the language.

    sample.py --seed N [--texts 100] [--comments 50]

Texts are string literals in `tr`, `translatable` and `translate`; comments are blocks of `///` in headers. Each is printed
with its file and line. The same seed draws the same texts from the same sources.
"""
import argparse
import pathlib
import random
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
LITERAL = r'"(?:[^"\\]|\\.)*"'
TEXT = re.compile(r'\b(?:tr|translatable|translate)\(\s*(?:"\w+",\s*)?(' + LITERAL + r'(?:\s*' + LITERAL + r')*)')
MARK = re.compile(r'^\s*///( |<)?')


def sources(*patterns):
    return sorted(path for pattern in patterns for path in ROOT.glob(pattern) if "build" not in path.parts)


def texts():
    for path in sources("ui/**/*.cpp", "ui/**/*.h", "app/studio/*.cpp", "solver/**/*.cpp", "solver/**/*.h"):
        source = path.read_text()
        for found in TEXT.finditer(source):
            text = "".join(part[1:-1] for part in re.findall(LITERAL, found.group(1)))
            if len(text.split()) > 1:
                yield path.relative_to(ROOT), source.count("\n", 0, found.start()) + 1, text


def comments():
    for path in sources("geometry/**/*.h", "solver/**/*.h", "ui/**/*.h", "app/**/*.h"):
        lines, block = path.read_text().splitlines(), []
        for number, line in enumerate(lines, 1):
            if MARK.match(line):
                block.append(MARK.sub("", line).strip())
            elif block:
                yield path.relative_to(ROOT), number - len(block), " ".join(block) + f"  [{line.strip()}]"
                block = []


def draw(chosen, every, count, title):
    every = list(every)
    print(f"{title}: {count} of {len(every)}")
    for number, (path, line, text) in enumerate(chosen.sample(every, min(count, len(every))), 1):
        print(f"{number:>3}  {path}:{line}  {text}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--texts", type=int, default=100)
    parser.add_argument("--comments", type=int, default=50)
    asked = parser.parse_args()
    chosen = random.Random(asked.seed)
    draw(chosen, texts(), asked.texts, "Texts of the window")
    draw(chosen, comments(), asked.comments, "Comments of public declarations")
