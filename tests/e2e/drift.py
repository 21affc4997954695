# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# End-to-end test of the window with real mouse and keyboard input: it draws a drift in
# two joint sets, bolts it, loads its key block, runs, waits for bonds to fail, and exports
# a figure and a chart, with at most sixty clicks. The result of every step is checked on
# the screen and in the files; screenshots after each step are kept in a folder.
#     drift.py STUDIO FOLDER
import json
import os
import re
import subprocess
import sys
import time

from screen import Gone, Screen, in_own_session, needs, wait

MOST_CLICKS = 60
LONGEST_RUN = 420  # [s], on a busy machine


class Missed(Exception):
    """A step did not have the expected result."""


class Drift:
    def __init__(self, studio, folder):
        self.keyblock = os.path.join(os.path.dirname(studio), "keyblock")
        self.folder = folder
        self.scene_file, self.store = (os.path.join(folder, name) for name in ("drift.json", "drift-1.kbrun"))
        self.screen = Screen(studio, [], folder)
        self.bolts, self.seconds = 0, 0.0

    # checks

    def expect(self, condition, text, seconds=20):
        if not wait(condition, seconds, 0.3):
            raise Missed(text)

    def says(self, pattern, role=None):
        """Whether a widget on the screen has a matching name."""
        return any(re.search(pattern, name) and role in (None, found) for found, name in self.screen.names())

    def expect_said(self, pattern, role=None, seconds=20):
        self.expect(lambda: self.says(pattern, role), f"no widget on the screen matches '{pattern}'", seconds)

    def info(self):
        told = subprocess.run([self.keyblock, "info", self.store, "--json"], capture_output=True, text=True)
        return json.loads(told.stdout) if told.returncode == 0 else {"events": {}, "stages": [], "frames": 0}

    def scene(self):
        with open(self.scene_file, encoding="utf-8") as file:
            return json.load(file)

    # actions

    def enter(self, text):
        self.screen.type(text)
        self.screen.keys("Return")
        self.screen.pause(0.3)

    def fill(self, name, text):
        """Types a number into a field."""
        self.screen.click(name, "text")
        self.screen.keys("ctrl+a")
        self.enter(text)

    def choose(self, shown, *keys):
        """Selects another entry in the box that shows `shown`, by keys in its list."""
        self.screen.click(shown, "combo box")
        self.screen.keys(*keys, "Return")

    def click_on(self, pattern, kind):
        """Clicks a widget with a number in its name: the button of a tool shows how many objects it would place."""
        node = wait(lambda: next((node for node in self.screen.showing()
                                  if node.getRoleName() == kind and re.fullmatch(pattern, node.name)), None))
        if not node:
            raise Missed(f"no {kind} matches '{pattern}'")
        said = node.name
        x, y, width, height = self.screen.box(node)  # at once: the number may change
        self.screen.press_at(x + width / 2, y + height / 2)
        return said

    def commit(self, pattern):
        return self.click_on(pattern, "push button")

    def canvas(self):
        return self.screen.box(self.screen.find("Section", "filler"))

    def pixel(self, x, y):
        """Screen position of a point of the section: two points are read from the coordinate box at the mouse."""
        read = []
        left, top, width, height = self.canvas()
        self.screen.keys("F3")  # without snapping
        for share in (0.3, 0.6):
            at = left + share * width, top + share * height
            self.screen.move(at[0] - 3, at[1])
            self.screen.move(*at)
            self.screen.pause(0.6)
            texts = (self.screen.find(f"{axis} of the next point", "text").queryText() for axis in "xy")
            read.append((at, [float(text.getText(0, -1).replace("\u2212", "-")) for text in texts]))
        self.screen.keys("F3")
        (p, a), (q, b) = read
        return tuple(p[i] + (value - a[i]) * (q[i] - p[i]) / (b[i] - a[i]) for i, value in enumerate((x, y)))

    def zoom_in(self, x, y):
        """Zooms with the wheel at a point."""
        self.screen.move(*self.pixel(x, y))
        for _ in range(6):
            self.screen._run("xdotool", "click", "4")
            self.screen.pause(0.1)

    def press_on(self, x, y):
        self.screen.press_at(*self.pixel(x, y))

    # steps

    def begin(self):
        self.screen.click("New scene")
        self.expect_said("^Tunnels none", "table cell")

    def outline(self):
        self.screen.click("Outline", "check box")
        self.enter("-15,-15")
        self.enter("15,15")
        self.expect_said("^Domain 30 × 30 m", "table cell")
        self.expect_said("^Blocks 1$", "table cell")

    def joint_sets(self):
        self.screen.click("Joint set", "check box")
        self.commit(r"Place \d+ traces")
        self.expect_said("^J1 ", "table cell")
        self.commit(r"Place \d+ traces")
        self.expect_said("^J2 ", "table cell")

    def tunnel(self):
        self.screen.click("Tunnel", "check box")
        self.enter("0,0")
        self.expect_said("^(Tunnels 1|T1 )", "table cell")
        self.expect_said("^Blocks [12]..$", "table cell")

    def pattern(self):
        self.screen.click("Bolt pattern", "check box")
        self.enter("2.5,0.5")
        self.enter("-2.5,0.5")
        self.bolts = int(self.commit(r"Place \d+ bolts").split()[1])
        self.expect_said("^P1 ", "table cell")

    def grouted_bar(self):
        self.screen.click("Bolt", "check box")
        self.choose("d-bolt-20", "r")
        self.expect_said("^rebar-20$", "combo box")
        self.zoom_in(0.0, 3.0)
        self.press_on(0.4, 2.42)
        self.expect_said("^B1 ", "table cell")

    def stage(self):
        self.screen.click("Stages", "check box")
        self.screen.click("Add a dynamic stage")
        self.expect_said("installs P1, B1", "table cell")
        self.fill("Duration", "0.008")
        self.expect_said("^0.008 s$", "table cell")

    def load(self):
        self.screen.click("Load", "check box")
        self.choose("force at a point", "Down")
        self.fill("Fy", "-300")
        self.press_on(0.0, 3.3)
        self.expect_said("1 load", "table cell")

    def save(self):
        self.screen.keys("ctrl+s")
        self.screen.pause(1.0)
        self.enter(self.scene_file)
        self.expect(lambda: os.path.exists(self.scene_file), "the scene is not saved")
        scene = self.scene()
        if len(scene["joint_sets"]) != 2 or len(scene["stages"]) != 4 or not scene["stages"][3]["loads"]:
            raise Missed("the file does not contain the drawing")
        self.expect_said("^Problems$", "page tab")  # without a count: there are none

    def run(self):
        self.screen.keys("F5")
        self.expect(lambda: os.path.exists(self.store), "there is no run")
        self.expect_said("^Pause", seconds=30)

    def watch(self):
        """Waits for bonds to fail during the run."""
        began = time.monotonic()
        self.expect(lambda: self.info()["events"].get("debonding", 0) > 0, "no bond failed", LONGEST_RUN)
        self.seconds = time.monotonic() - began
        if self.info()["stages"][-1]["outcome"] is not None:
            raise Missed("the run ended before a failed bond was seen")
        self.click_on("Events  .*", "page tab")
        self.expect_said("debond", seconds=30)

    def end(self):
        self.expect(lambda: self.info()["stages"][-1]["outcome"] == "duration", "the run does not end", LONGEST_RUN)
        self.screen.pause(2.0)
        self.expect_said("^Run$", "push button")

    def look(self):
        self.screen.keys("End", "shift+n", "shift+n", "shift+n")
        self.screen.pause(1.5)

    def figure(self):
        self.screen.keys("ctrl+k")
        self.enter("export figure")
        self.expect_said("^Section$", "combo box")
        self.take_along("section.pdf")

    def chart(self):
        self.choose("Section", "Down", "Down")
        self.take_along("curves.pdf")

    def take_along(self, name):
        path = os.path.join(self.folder, name)
        self.screen.click("Export", "push button")
        self.screen.pause(1.0)
        self.screen.keys("ctrl+a")
        self.enter(path)
        self.expect(lambda: os.path.exists(path) and open(path, "rb").read(4) == b"%PDF", f"there is no {name}", 60)

    STEPS = (begin, outline, joint_sets, tunnel, pattern, grouted_bar, stage, load, save, run, watch, end, look,
             figure, chart)

    def everything(self):
        failed = 0
        for step in self.STEPS:
            name = step.__name__.replace("_", "-")
            try:
                step(self)
            except (Gone, Missed) as problem:
                failed, said = 1, f"FAILED: {problem}"
            else:
                said = "done"
            self.screen.shoot(name)
            if os.environ.get("KEYBLOCK_NAMES"):
                with open(os.path.join(self.folder, name + ".txt"), "w") as file:
                    file.writelines(f"{role} | {text}\n" for role, text in self.screen.names())
            print(f"{name:12} {self.screen.clicks:3} clicks  {said}", flush=True)
            if failed or not self.screen.alive():
                return 1
        events = self.info()["events"]
        print(f"first bond failed {self.seconds:.0f} s after F5; {events}")
        print(f"{self.screen.clicks} clicks of {MOST_CLICKS}")
        return int(self.screen.clicks > MOST_CLICKS)


def main():
    if missing := needs():
        sys.exit(f"missing: {', '.join(missing)}")
    if len(sys.argv) != 3:
        sys.exit("usage: drift.py STUDIO FOLDER")
    in_own_session()
    studio, folder = (os.path.abspath(path) for path in sys.argv[1:])
    os.makedirs(folder, exist_ok=True)
    for name in ("drift.json", "drift-1.kbrun", "section.pdf", "curves.pdf"):
        if os.path.exists(os.path.join(folder, name)):
            os.remove(os.path.join(folder, name))
    drift = Drift(studio, folder)
    try:
        failed = drift.everything()
    finally:
        drift.screen.close()
    sys.exit(failed)


if __name__ == "__main__":
    main()
