# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Drives the program with real mouse and keyboard events on a virtual display under a
# window manager; widgets are found by their accessible names. Debian: xvfb openbox xdotool at-spi2-core
# python3-pyatspi imagemagick dbus wmctrl x11-utils; the Python is Debian's, /usr/bin/python3.
import os
import shutil
import subprocess
import sys
import tempfile
import time


MOST_CHILDREN = 250  # of a widget that are searched; lists may have thousands of events


class Gone(Exception):
    """The widget is not on the screen."""


def wait(condition, seconds=20, step=0.05):
    """Waits until `condition()` is true and returns it; None after `seconds`."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(step)
    return None


def in_own_session():
    """First line of a script: restarts it with a session bus and a home folder of its own."""
    if os.environ.get("KEYBLOCK_E2E_HOME"):
        return
    home = tempfile.mkdtemp(prefix="keyblock-e2e-")
    os.environ.update(KEYBLOCK_E2E_HOME=home, HOME=home, XDG_RUNTIME_DIR=home, LC_ALL="C.UTF-8")
    for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"):
        os.environ.pop(name, None)
    sys.stdout.flush()
    os.execvp("dbus-run-session", ["dbus-run-session", "--", "/usr/bin/python3", *sys.argv])


class Screen:
    def __init__(self, program, arguments=(), pictures=None, size="1600x1000", scale="1"):
        self.home = os.environ["KEYBLOCK_E2E_HOME"]
        self.pictures = pictures
        self.clicks = self.shots = 0
        self.program = None
        os.makedirs(pictures, exist_ok=True)
        self.log = open(os.path.join(self.home, "log"), "w")
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", "1", "-screen", "0", size + "x24", "-nolisten", "tcp"],
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        display = ":" + self.server.stdout.readline().decode().strip()
        os.environ.update(DISPLAY=display, QT_SCALE_FACTOR=scale, QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1",
                          QT_ACCESSIBILITY="1")
        self._manage()
        self._tell_bus()
        self.program = subprocess.Popen([program, *arguments], stdout=self.log, stderr=self.log)
        self.window = wait(self._window, 30) or self._fail("the window is not on the screen")
        wait(self._is_told, 20, 0.2) or self._fail("the program publishes no accessible names")
        import pyatspi
        self.spi = pyatspi
        self.root = wait(self._application) or self._fail("the program is not on the screen")
        self.root.set_cache_mask(self.spi.Atspi.Cache.NONE if hasattr(self.spi, "Atspi") else 0)
        self.pause(1)
        self.raise_window()

    def _manage(self):
        """Starts the window manager, again if the display was not ready yet."""
        for _ in range(5):
            self.manager = subprocess.Popen(["openbox"], stderr=subprocess.DEVNULL)
            if wait(lambda: self._run("wmctrl", "-m") or self.manager.poll() is not None) and self.manager.poll() is None:
                return
        self._fail("the window manager does not start")

    def _tell_bus(self):
        """
        Writes the address of the accessibility bus to the root window, as a desktop does. If accessibility is enabled
        by its environment, Qt 5.15 requests the address without waiting for the answer, but reads the root window
        first.
        """
        answer = self._run("dbus-send", "--session", "--print-reply", "--dest=org.a11y.Bus", "/org/a11y/bus",
                           "org.a11y.Bus.GetAddress")
        address = answer.split('"')[1] if '"' in answer else self._fail("there is no accessibility bus")
        self._run("xprop", "-root", "-f", "AT_SPI_BUS", "8s", "-set", "AT_SPI_BUS", address)

    @staticmethod
    def copy_home(source, target):
        """Copies the settings and data of the program."""
        for folder in (".local", ".config"):
            shutil.rmtree(os.path.join(target, folder), ignore_errors=True)
            if os.path.isdir(os.path.join(source, folder)):
                shutil.copytree(os.path.join(source, folder), os.path.join(target, folder))

    def kill(self):
        """Kills the program."""
        self.program.kill()
        self.program.wait()

    def _fail(self, text):
        self.close()
        raise Gone(text)

    def _is_told(self):
        """Whether the program has published its names: asked in another process, as one that asks too early never sees it."""
        count = "import pyatspi; print(pyatspi.Registry.getDesktop(0).childCount)"
        return self._run("/usr/bin/python3", "-c", count) not in ("", "0")

    def _application(self):
        desktop = self.spi.Registry.getDesktop(0)
        for i in range(desktop.childCount):
            child = desktop.getChildAtIndex(i)
            if child and child.get_process_id() == self.program.pid:
                return child
        return None

    def _window(self):
        found = self._run("xdotool", "search", "--onlyvisible", "--pid", str(self.program.pid))
        return found.split()[0] if found else None

    def raise_window(self):
        """Fills the screen with the window."""
        self._run("xdotool", "windowactivate", "--sync", self.window)
        self._run("xdotool", "key", "--clearmodifiers", "super+Up")
        self._run("wmctrl", "-i", "-r", self.window, "-b", "add,maximized_vert,maximized_horz")
        self.pause(0.5)

    def _run(self, *command):
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout.decode().strip()

    def alive(self):
        return self.program.poll() is None

    def pause(self, seconds):
        time.sleep(seconds)

    # search

    def _walk(self, node, depth=0):
        yield node
        if depth > 40:
            return
        for i in range(min(node.childCount, MOST_CHILDREN)):
            try:
                child = node.getChildAtIndex(i)
            except Exception:  # it has disappeared
                continue
            if child is not None:
                yield from self._walk(child, depth + 1)

    def _matches(self, node, name, role):
        try:
            if role and node.getRoleName() != role:
                return False
            said = node.name
            if not (said == name or said.startswith(name + " (") or said.startswith(name + "\t")):
                return False
            state = node.getState()
            return state.contains(self.spi.STATE_SHOWING)
        except Exception:
            return False

    def find(self, name, role=None, seconds=10):
        """The widget with that accessible name that is visible on the screen."""
        def look():
            for node in self._walk(self.root):
                if self._matches(node, name, role):
                    return node
            return None
        node = wait(look, seconds, 0.2)
        if node is None:
            self.shoot("gone")
            raise Gone(f"{role or 'widget'} '{name}' is not on the screen")
        return node

    def there(self, name, role=None):
        return any(self._matches(node, name, role) for node in self._walk(self.root))

    def showing(self):
        """Every widget on the screen that has a name."""
        for node in self._walk(self.root):
            if node.name and node.getState().contains(self.spi.STATE_SHOWING):
                yield node

    def names(self):
        """Every accessible name on the screen with its role, for writing scripts."""
        for node in self.showing():
            yield node.getRoleName(), node.name

    def box(self, node):
        box = node.queryComponent().getExtents(self.spi.DESKTOP_COORDS)
        return box.x, box.y, box.width, box.height

    # actions

    def move(self, x, y):
        self._run("xdotool", "mousemove", "--sync", str(int(x)), str(int(y)))

    def press_at(self, x, y, button=1, count=True):
        self.move(x, y)
        self.pause(0.12)
        self._run("xdotool", "click", str(button))
        self.clicks += count
        self.pause(0.25)

    def click(self, name, role=None, button=1):
        x, y, width, height = self.box(self.find(name, role))
        self.press_at(x + width / 2, y + height / 2, button)

    def double_click(self, name, role=None):
        x, y, width, height = self.box(self.find(name, role))
        self.move(x + width / 2, y + height / 2)
        self._run("xdotool", "click", "--repeat", "2", "--delay", "80", "1")
        self.clicks += 2
        self.pause(0.3)

    def drag(self, start, end, button=1):
        self.move(*start)
        self._run("xdotool", "mousedown", str(button))
        for share in (0.2, 0.5, 0.8, 1.0):
            self.move(start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1]))
            self.pause(0.05)
        self._run("xdotool", "mouseup", str(button))
        self.clicks += 1
        self.pause(0.25)

    def keys(self, *keys):
        for key in keys:
            self._run("xdotool", "key", "--clearmodifiers", key)
            self.pause(0.12)

    def type(self, text):
        self._run("xdotool", "type", "--delay", "25", "--", text)
        self.pause(0.2)

    def shoot(self, name):
        """Takes a screenshot, numbered in the order of the steps."""
        self.shots += 1
        path = os.path.join(self.pictures, f"{self.shots:02d}-{name}.png")
        self._run("import", "-window", "root", path)
        return path

    def close(self):
        for process in (self.program, self.manager, self.server):
            if process and process.poll() is None:
                process.terminate()
                try:
                    process.wait(10)
                except subprocess.TimeoutExpired:
                    process.kill()
        self.log.close()


def needs():
    """Names of programs that are missing."""
    programs = ("Xvfb", "openbox", "xdotool", "xprop", "import", "dbus-run-session", "wmctrl")
    return [name for name in programs if not shutil.which(name)]


if __name__ == "__main__":
    sys.exit(f"this is used by the other scripts in this folder; missing programs: {', '.join(needs()) or 'none'}")
