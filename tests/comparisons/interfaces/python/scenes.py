"""Scenes of these tests."""
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import rockstack

PROGRAM = os.environ["ROCKSTACK_PROGRAM"]
SOURCE = Path(os.environ["ROCKSTACK_SOURCE"])

BLOCK = {"width": 0.5, "height": 1.5, "density": 2500.0}
TWO = [{"width": 0.6, "height": 1.6, "density": 2500.0}, {"width": 0.5, "height": 1.2, "density": 2500.0}]


#: A block that rocks for days, followed in a minute by large steps; and on springs, which take half an hour.
LONG = ("rockstack.Scene(duration=1e6, blocks=[dict(width=0.5, height=1.5, density=2500)], ground=dict("
        "horizontal=dict(pulse='sine', amplitude=3.6, period=0.5, cycles=1e9)))")
ENDLESS = LONG + ".replace({'law': 'compliant', 'contact.stiffness': 1e6})"


def rocking(folder="", **changes) -> rockstack.Scene:
    """One block released at 0.1 rad."""
    return rockstack.Scene({"duration": 1.0, "blocks": [BLOCK], "initial": {"angles": [0.1]}, **changes}, folder=folder)


def solved_by_program(scene: Path, *arguments: str) -> Path:
    """The folder of what the program makes of a scene file; the caller removes it."""
    out = Path(tempfile.mkdtemp())
    subprocess.run([PROGRAM, "solve", scene, "--out", out, "--no-plots", "--quiet", *arguments], check=True)
    return out


def message_of_program(*arguments: str) -> str:
    """The one line that the program says of wrong input."""
    run = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True)
    assert run.returncode == 2, run
    return run.stderr.strip()


def interrupted(call: str) -> str:
    """What a process of its own prints that makes a call, and that Ctrl-C comes to half a second later."""
    program = ("import signal\nimport rockstack\n"
               "signal.signal(signal.SIGINT, signal.default_int_handler)  # which those in the background ignore\n"
               f"try:\n    print('ready', flush=True)\n    {call}\nexcept KeyboardInterrupt: print('ended')")
    process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    process.stdout.readline()
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    return process.communicate(timeout=30)[0].strip()
