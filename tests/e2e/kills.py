# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Edits a scene during a run, with real keys, and kills the program at a random moment.
# Then checks: no edit older than two seconds is lost; the next start offers the scene
# with and without the last command, and both are correct; the run's store opens, and
# contains every frame that was seen in it before. (The kills test of the command line
# checks that a resumed run has the same bytes.)
#     kills.py STUDIO KEYBLOCK SAMPLES [KILLS]
# Every start of the program runs in a process of its own: a process that reads the
# accessibility bus before the program starts never sees the program.
import json
import os
import random
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time

from screen import Gone, Screen, in_own_session, needs, wait

TABLES = ("history", "events", "bolts", "blocks", "contacts", "energy")
SCENES = ("angle-rebar-20", "burst-rebar", "angle-dbolt-20", "drift-bolted")
MOST_LOST = 2.0  # [s]
PICTURES = os.path.join(tempfile.gettempdir(), "keyblock-kills-pictures")


class Stack:
    """A model of undo and redo for moves to the right, independent of the program."""

    def __init__(self):
        self.states, self.at = [0], 0
        self.history = [0]  # number of moves in effect after each change

    def move(self):
        self.states = self.states[:self.at + 1] + [self.states[self.at] + 1]
        self.at += 1
        self.history.append(self.states[self.at])

    def go(self, way):
        """Never back to the start: after undoing everything there is nothing to recover."""
        if not 1 <= self.at + way < len(self.states):
            return False
        self.at += way
        self.history.append(self.states[self.at])
        return True


def place_in(scene):
    """A coordinate that changes when everything is moved."""
    for key, member in (("bolts", "head"), ("tunnels", "center"), ("blocks", "points")):
        if scene.get(key):
            value = scene[key][0][member]
            return value[0] if isinstance(value[0], (int, float)) else value[0][0]
    raise ValueError("the scene has no coordinates")


class FrameCount(threading.Thread):
    """Reads the store while it is written, as another program may."""

    def __init__(self, store):
        super().__init__(daemon=True)
        self.store, self.seen, self.ends = store, 0, False

    def run(self):
        while not self.ends:
            if os.path.exists(self.store):
                try:
                    with sqlite3.connect(f"file:{self.store}?mode=ro", uri=True, timeout=1) as base:
                        self.seen = max(self.seen, base.execute("SELECT count(*) FROM frames").fetchone()[0])
                except sqlite3.Error:
                    pass  # does not exist yet
            time.sleep(0.1)


def edit_and_run(studio, scene_file, seed, home):
    """Starts a run and edits until the program is killed at a random moment; returns the edits with their times."""
    chance = random.Random(int(seed))
    screen = Screen(studio, [scene_file], PICTURES)
    screen.press_at(800, 420)
    screen.keys("F5")
    screen.pause(chance.uniform(0.3, 1.5))
    screen.keys("j", "Escape", "Escape", "s")  # back to drawing, during the run
    screen.press_at(800, 420)
    screen.keys("ctrl+a")
    stack, times = Stack(), []
    end = time.monotonic() + chance.uniform(0.5, 7.0)
    while time.monotonic() < end:
        what = chance.random()
        key = "Right"
        if what < 0.2 and stack.go(-1):
            key = "ctrl+z"
        elif 0.2 <= what < 0.3 and stack.go(1):
            key = "ctrl+shift+z"
        else:
            stack.move()
        screen._run("xdotool", "key", key)
        times.append(time.monotonic())
        screen.pause(chance.uniform(0.0, 0.35))
    killed = time.monotonic()
    screen.kill()
    screen.copy_home(screen.home, home)
    screen.close()
    return {"moves": stack.history, "times": times, "killed": killed}


def recover(studio, scene_file, button, with_file, home):
    """Starts the program again, recovers, saves, and reads the file."""
    Screen.copy_home(home, os.environ["KEYBLOCK_E2E_HOME"])
    screen = Screen(studio, [scene_file] if with_file == "file" else [], PICTURES)
    try:
        if with_file == "file":
            screen.click("Recover…")
        screen.click(button)
        before = os.stat(scene_file).st_mtime_ns
        screen.pause(0.7)
        screen.keys("ctrl+s")
        written = wait(lambda: os.stat(scene_file).st_mtime_ns != before, 15)
    except Gone as gone:
        return {"problem": str(gone)}
    finally:
        screen.kill()
        screen.close()
    with open(scene_file, encoding="utf-8") as file:
        return {"place": place_in(json.load(file))} if written else {"problem": "it was not saved"}


class Kills:
    def __init__(self, studio, keyblock, samples):
        self.studio, self.keyblock, self.samples = studio, keyblock, samples
        self.folder = tempfile.mkdtemp(prefix="keyblock-kills-")
        self.steps = {}  # length of a move, by scene
        self.longest = 0.0
        self.recovered = self.kept = self.edits = 0
        self.failures = []

    def expect(self, condition, text):
        if not condition:
            self.failures.append(text)
            print("FAILED", text, flush=True)
        return bool(condition)

    def user(self, *words):
        """Runs one action in a process of its own and returns its result."""
        ended = subprocess.run(["/usr/bin/python3", os.path.abspath(__file__), *map(str, words)],
                               capture_output=True, text=True, timeout=600)
        last = (ended.stdout.strip().splitlines() or [""])[-1]
        return json.loads(last) if last.startswith("{") else {"problem": ended.stderr[-500:]}

    def command_line(self, *words):
        return subprocess.run([self.keyblock, *words], capture_output=True, text=True, timeout=900)

    def read_tables(self, store):
        """Exports every table; one that cannot be read gives no file."""
        out = os.path.join(self.folder, "table.csv")
        for name in TABLES:
            self.command_line("export", store, "--table", name, "--out", out, "--at", "all")
            os.remove(out)

    def sample(self, name):
        return os.path.join(self.samples, name + ".json")

    @staticmethod
    def changes_in(home):
        """Number of changes in the remaining journal, counted without the program."""
        folder = os.path.join(home, ".local/share/keyblock/keyblock-studio/journals")
        found = [name for name in (os.listdir(folder) if os.path.isdir(folder) else []) if name.endswith(".journal")]
        if len(found) != 1:
            return 0
        with open(os.path.join(folder, found[0]), encoding="utf-8") as lines:
            bodies = [json.loads(line[17:]) for line in lines if line.endswith("\n")]
        return sum(1 for body in bodies if "at" in body and "saved" not in body)

    def check_recovery(self, name, label, kill, scene_file, home, moves, count):
        with open(self.sample(name), encoding="utf-8") as file:
            first = place_in(json.load(file))
        for button, changes in (("Recover", count), ("Recover without last edit", count - 1)):
            shutil.copy(self.sample(name), scene_file)
            # Every second time the next start opens a file, as from a file manager.
            found = self.user("recover", self.studio, scene_file, button, "file" if kill % 2 else "page", home)
            if not self.expect("place" in found, f"{label}: {button}: {found.get('problem')}"):
                continue
            if moves[changes] and name not in self.steps:
                self.steps[name] = (found["place"] - first) / moves[changes]
            promised = first + moves[changes] * self.steps.get(name, 0.0)
            right = self.expect(abs(found["place"] - promised) < 1e-6,
                                f"{label}: {button} leads to {found['place']}, not to {promised}")
            self.recovered += right and button == "Recover"

    def check_store(self, label, store, seen):
        if not os.path.exists(store):
            return print(f"{label}: killed before the run had a store", flush=True)
        info = self.command_line("info", store, "--json")
        if not self.expect(info.returncode == 0, f"{label}: the store does not open: {info.stderr}"):
            return
        with sqlite3.connect(store) as base:
            frames = base.execute("SELECT count(*) FROM frames").fetchone()[0]
        self.kept += self.expect(frames >= seen, f"{label}: {frames} of {seen} frames remain")
        try:
            self.read_tables(store)
        except OSError as error:
            self.expect(False, f"{label}: {error}")

    def once(self, kill, seed):
        name = SCENES[3] if kill % 6 == 5 else SCENES[kill % 3]
        label = f"kill {kill} of {name}"
        folder = tempfile.mkdtemp(dir=self.folder)
        scene_file, store = os.path.join(folder, name + ".json"), os.path.join(folder, name + "-1.kbrun")
        home = os.path.join(folder, "home")
        os.mkdir(home)
        shutil.copy(self.sample(name), scene_file)
        counting = FrameCount(store)
        counting.start()
        done = self.user("edit", self.studio, scene_file, seed, home)
        counting.ends = True
        counting.join()
        if not self.expect("times" in done, f"{label}: {done.get('problem')}"):
            return
        times = done["times"]
        count = self.changes_in(home)
        self.edits += len(times)
        self.expect(count <= len(times), f"{label}: {count} changes in the journal of {len(times)}")
        loss = done["killed"] - times[count] if count < len(times) else 0.0
        self.longest = max(self.longest, loss)
        self.expect(loss < MOST_LOST, f"{label}: {loss:.2f} s are lost")
        print(f"{label}: {len(times)} edits, {count} in the journal, {loss:.3f} s lost, {counting.seen} frames seen",
              flush=True)
        if count > 0:
            self.check_recovery(name, label, kill, scene_file, home, done["moves"], count)
        self.check_store(label, store, counting.seen)
        shutil.rmtree(folder)

    def tell(self, kills):
        print(f"{kills} kills, {self.edits} edits; longest loss {self.longest:.3f} s; {self.recovered} scenes recovered; "
              f"{self.kept} stores with all their frames; {len(self.failures)} failures")


def main():
    if missing := needs():
        sys.exit(f"missing: {', '.join(missing)}")
    roles = {"edit": edit_and_run, "recover": recover}
    if sys.argv[1] in roles:
        in_own_session()
        print(json.dumps(roles[sys.argv[1]](*sys.argv[2:])))
        return shutil.rmtree(os.environ["KEYBLOCK_E2E_HOME"], ignore_errors=True)
    kills = int(sys.argv[4]) if len(sys.argv) > 4 else 30
    chance = random.Random(int(os.environ.get("KEYBLOCK_SEED", "1")))
    all_kills = Kills(*(os.path.abspath(path) for path in sys.argv[1:4]))
    for kill in range(kills):
        all_kills.once(kill, chance.randrange(1 << 30))
    shutil.rmtree(all_kills.folder)
    all_kills.tell(kills)
    sys.exit(1 if all_kills.failures else 0)


if __name__ == "__main__":
    main()
