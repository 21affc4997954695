#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Keyblock contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a sweep on a Slurm cluster of two nodes, both on this machine, and breaks it.

Usage: cluster.py PROGRAM [--cases N]. A case is killed, a task is queued again while it
runs, and a node loses its daemon and all its processes. Afterwards every case must have
its row, and results.csv the same bytes as after a serial run. The cluster has ports,
logs and a state folder of its own, which is removed at the end; it needs root, the
Debian packages slurmctld, slurmd and slurm-client, and no munge. Exits with 1 if a
check fails, and with 2 where it cannot run.
"""
import argparse
import contextlib
import glob
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

NODES = {"n1": 17103, "n2": 17104}
CONTROLLER_PORT = 17102

SCENE = """{
  "format": "keyblock-scene", "version": 1,
  "analysis": { "gravity": [0, -9.81], "sleep_tolerance": 0 },
  "materials": { "rock": { "density": 2700, "youngs_modulus": 1e9, "poissons_ratio": 0.2 } },
  "joint_materials": { "joint": { "friction_angle": 30, "cohesion": 0, "tensile_strength": 0 } },
  "blocks": [
    { "name": "floor", "points": [[0,0],[3,0],[3,1],[0,1]], "material": "rock" },
    { "name": "stone", "points": [[1,1],[2,1],[2,2],[1,2]], "material": "rock" } ],
  "supports": [ { "block_at": [0.5,0.5], "fix": "all" } ],
  "stages": [ { "name": "slide", "kind": "dynamic", "duration": DURATION, "time_step": 0.001,
                "initial_velocities": [ { "block_at": [1.5,1.5], "velocity": [0.5,0] } ] } ],
  "monitors": [ { "name": "top", "point": [1.5,2] } ],
  "output": { "every": 0.1 }
}
"""

STUDY = """{
  "format": "keyblock-study", "version": 1, "scene": "scene.json", "title": "Sliding stone",
  "plan": { "kind": "monte-carlo", "cases": CASES, "seed": 5, "cases_per_task": 2 },
  "parameters": [
    { "name": "friction", "path": "joint_materials.joint.friction_angle",
      "distribution": { "kind": "normal", "mean": 20, "deviation": 4, "least": 5, "most": 40 } } ],
  "quantities": [ "last top.ux", "energy_error" ], "fails": "last top.ux > 0.04"
}
"""


def fail(message):
    print("FAILED: " + message)
    sys.exit(1)


def cannot(message):
    print(message, file=sys.stderr)
    sys.exit(2)


def configuration(folder):
    host = socket.gethostname()
    nodes = "\n".join(f"NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs=1"
                      for name, port in NODES.items())
    return f"""ClusterName=keyblock
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={CONTROLLER_PORT}
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
PriorityType=priority/basic
SlurmUser=root
SlurmdUser=root
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
SlurmdTimeout=15
KillWait=10
ReturnToService=2
{nodes}
PartitionName=all Nodes={",".join(NODES)} Default=YES State=UP MaxTime=INFINITE
"""


class Cluster:
    """A controller and two nodes, all on this machine."""

    def __init__(self, folder):
        self.folder = folder
        self.started = []
        (folder / "state").mkdir()
        (folder / "slurm.conf").write_text(configuration(folder))
        plugins = glob.glob("/usr/lib/*/slurm-wlm")
        self.environment = dict(os.environ, SLURM_CONF=str(folder / "slurm.conf"),
                                LD_LIBRARY_PATH=":".join(plugins))
        self.controller = self.start(["slurmctld", "-D"])
        self.nodes = {name: self.start_node(name) for name in NODES}

    def start(self, words):
        process = subprocess.Popen(words, env=self.environment, cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        self.started.append(process)
        return process

    def start_node(self, name):
        return self.start(["slurmd", "-D", "-N", name])

    def ask(self, *words, cwd=None):
        for _ in range(20):  # the controller may be busy
            done = subprocess.run(words, env=self.environment, capture_output=True, text=True, cwd=cwd)
            if done.returncode == 0:
                return done.stdout
            time.sleep(0.5)
        fail(" ".join(words) + ": " + done.stderr.strip())

    def processes(self, node=None, name=None):
        """Processes of this cluster's jobs, as (id, name), on a node."""
        found = []
        for entry in os.listdir("/proc"):
            if not entry.isdigit():
                continue
            with contextlib.suppress(OSError):
                environment = pathlib.Path("/proc", entry, "environ").read_bytes().split(b"\0")
                variables = dict(v.split(b"=", 1) for v in environment if b"=" in v)
                if variables.get(b"SLURM_CONF", b"").decode() != self.environment["SLURM_CONF"]:
                    continue
                command = pathlib.Path("/proc", entry, "comm").read_text().strip()
                there = variables.get(b"SLURMD_NODENAME", b"").decode()
                if (node is None or there == node) and (name is None or command == name):
                    found.append((int(entry), command))
        return found

    def step_daemons(self, node):
        """The daemons of a node's jobs: parents of their processes."""
        daemons = set()
        for process, _ in self.processes(node):
            with contextlib.suppress(OSError, ValueError):
                parent = int(pathlib.Path("/proc", str(process), "stat").read_text().rsplit(")", 1)[1].split()[1])
                if "slurmstepd" in pathlib.Path("/proc", str(parent), "comm").read_text():
                    daemons.add(parent)
        return daemons

    def power_off(self, node):
        """The node's daemon and all its processes disappear at once."""
        daemons = self.step_daemons(node)
        self.nodes[node].kill()
        self.nodes[node].wait()
        for process in [p for p, _ in self.processes(node)] + list(daemons):
            with contextlib.suppress(ProcessLookupError):
                os.kill(process, signal.SIGKILL)

    def node_state(self, node):
        return self.ask("sinfo", "-h", "-N", "-n", node, "-o", "%T").strip()

    def jobs(self):
        return [line.split() for line in self.ask("squeue", "-h", "-r", "-o", "%i %T %N").splitlines()]

    def wait(self, what, condition, seconds):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                fail("no " + what + " after " + str(seconds) + " s; logs are above")
            time.sleep(0.3)

    def stop(self):
        for process, _ in self.processes():
            if process != os.getpid():
                with contextlib.suppress(ProcessLookupError):
                    os.kill(process, signal.SIGKILL)
        for process in reversed(self.started):
            process.kill()
            process.wait()


def run(program, *words):
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True)
    if done.returncode != 0:
        fail(" ".join(map(str, words)) + " ended with " + str(done.returncode) + ": " + done.stderr)
    return done.stdout


def status(program, sweep):
    return json.loads(run(program, "sweep", "status", sweep, "--json"))


def requirements():
    if os.geteuid() != 0:
        cannot("the cluster needs root: slurmd starts jobs for their users")
    for command in ("slurmctld", "slurmd", "sbatch"):
        if not shutil.which(command, path=os.environ["PATH"] + ":/usr/sbin"):
            cannot(f"{command} is missing; install the Debian packages slurmctld, slurmd and slurm-client")
    os.environ["PATH"] += ":/usr/sbin"


def break_and_finish(cluster, program, sweep, cases):
    cluster.wait("node", lambda: all(cluster.node_state(n) in ("idle", "allocated") for n in NODES), 60)
    cluster.ask("sbatch", "submit.sbatch", cwd=sweep)
    cluster.wait("tenth case", lambda: status(program, sweep)["finished"] >= cases // 10, 300)

    cluster.wait("running case", lambda: cluster.processes("n1", "keyblock"), 60)
    victim = cluster.processes("n1", "keyblock")[0][0]
    os.kill(victim, signal.SIGKILL)
    print(f"killed one case of node n1 after {status(program, sweep)['finished']} cases")

    cluster.wait("running task", lambda: any(j[1] == "RUNNING" for j in cluster.jobs()), 60)
    task = next(j[0] for j in cluster.jobs() if j[1] == "RUNNING")
    cluster.ask("scontrol", "requeue", task)
    print("queued the running task " + task + " again")

    cluster.wait("third of the cases", lambda: status(program, sweep)["finished"] >= cases // 3, 300)
    cluster.wait("running case", lambda: cluster.processes("n2", "keyblock"), 60)
    cluster.power_off("n2")
    print(f"node n2 lost its power after {status(program, sweep)['finished']} cases")
    cluster.wait("report of the lost node", lambda: "down" in cluster.node_state("n2"), 120)
    cluster.nodes["n2"] = cluster.start_node("n2")
    cluster.wait("return of node n2", lambda: cluster.node_state("n2") in ("idle", "allocated"), 60)
    print("node n2 is back")

    # a requeued task waits two minutes by default; releasing it shortens the test
    cluster.wait("end of the job array", lambda: not cluster.jobs() or release(cluster), 600)
    state = status(program, sweep)
    print(f"{state['finished']} of {cases} cases finished, {state['interrupted']} interrupted by the kills")
    cluster.ask("sbatch", "submit.sbatch", cwd=sweep)
    cluster.wait("end of the second job array", lambda: not cluster.jobs() or release(cluster), 300)


def release(cluster):
    """Lets tasks that wait for their time begin now. False: it is not the end."""
    for job in cluster.jobs():
        if job[1] == "PENDING":
            subprocess.run(["scontrol", "update", "JobId=" + job[0], "StartTime=now"], env=cluster.environment,
                           capture_output=True)
    return False


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--cases", type=int, default=100)
    parser.add_argument("--duration", type=float, default=15.0, help="simulated time of a case [s]")
    options = parser.parse_args()
    requirements()
    program, cases = str(pathlib.Path(options.program).resolve()), options.cases
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="keyblock-cluster-") as name:
        folder = pathlib.Path(name)
        folder.chmod(0o755)
        (folder / "scene.json").write_text(SCENE.replace("DURATION", str(options.duration)))
        (folder / "study.json").write_text(STUDY.replace("CASES", str(cases)))
        for sweep in ("serial", "cluster"):
            run(program, "sweep", "plan", folder / "study.json", "--out", folder / sweep)
        cluster = Cluster(folder)
        try:
            break_and_finish(cluster, program, folder / "cluster", cases)
        finally:
            cluster.stop()
        run(program, "sweep", "run", folder / "serial", "--index", f"1-{cases}")
        for sweep in ("serial", "cluster"):
            run(program, "sweep", "collect", folder / sweep)
        state = status(program, folder / "cluster")
        if state["finished"] != cases or state["outcomes"]["done"] != cases:
            fail(f"only {state['finished']} of {cases} cases finished")
        if (folder / "serial/results.csv").read_bytes() != (folder / "cluster/results.csv").read_bytes():
            fail("results.csv differs from that of a serial run")
    print(f"{cases} cases on two nodes: results.csv has the same bytes as after a serial run "
          f"({time.monotonic() - began:.0f} s)")


if __name__ == "__main__":
    main()
