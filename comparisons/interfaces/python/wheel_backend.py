"""Makes a wheel of what the whole tree installs, for pip and other front ends (PEP 517). It needs nothing but CMake and what
the build needs.

Config settings: build-dir, a build that is there and is taken as it is; left out, build/wheel is configured and built.
"""
import base64
import hashlib
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
TREE = FOLDER.parents[2]
TAG = "cp{0}-cp{0}-{1}".format(sysconfig.get_config_var("py_version_nodot"), re.sub(r"\W", "_", sysconfig.get_platform()))


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel and tells its name."""
    given = (config_settings or {}).get("build-dir")
    build = Path(given) if given else built()
    with tempfile.TemporaryDirectory() as prefix:
        subprocess.run(["cmake", "--install", build, "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
        package = package_of(Path(prefix))
        return write(Path(wheel_directory), {f"rockstack/{file.relative_to(package)}": content(file)
                                             for file in package.rglob("*") if file.is_file()})


def built():
    """The folder of a build of this tree for this interpreter."""
    build = TREE / "build/wheel"
    subprocess.run(["cmake", "-C", TREE / ".ci/release.cmake", "-S", TREE, "-B", build, "-DROCKSTACK_TESTS=OFF",
                    "-DROCKSTACK_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}"], check=True)
    subprocess.run(["cmake", "--build", build, "--parallel", str(len(os.sched_getaffinity(0)))], check=True)
    return build


def package_of(prefix):
    """The package, with programs and data inside of it as they are under a prefix: it may lie anywhere."""
    modules = list(prefix.glob("lib/**/rockstack/_core" + sysconfig.get_config_var("EXT_SUFFIX")))
    if not modules:
        sys.exit(f"the build has no Python module for {sys.executable}")
    package = modules[0].parent
    for folder in ("bin", "share/rockstack"):
        shutil.move(prefix / folder, package / folder)
    return package


def content(file):
    """Mode and bytes; for a link, which a wheel cannot hold, a script that goes where it leads."""
    if file.is_symlink():
        return 0o755, f'#!/bin/sh\nexec "$(dirname "$0")/{file.readlink()}" "$@"\n'.encode()
    return file.stat().st_mode & 0o777, file.read_bytes()


def write(folder, contents):
    """Packs files and what describes them; the same ones give the same bytes."""
    project = tomllib.loads((FOLDER / "pyproject.toml").read_text())["project"]
    version = re.search(r"project\(rockstack VERSION ([0-9.]+)", (TREE / "CMakeLists.txt").read_text())[1]
    name = f"rockstack-{version}"
    extras = [f"Provides-Extra: {extra}\n" + "".join(f"Requires-Dist: {one}; extra == '{extra}'\n" for one in wanted)
              for extra, wanted in project["optional-dependencies"].items()]
    texts = {
        "METADATA": f"Metadata-Version: 2.1\nName: rockstack\nVersion: {version}\nSummary: {project['description']}\n"
                    f"Requires-Python: {project['requires-python']}\n"
                    + "".join(f"Requires-Dist: {one}\n" for one in project["dependencies"]) + "".join(extras)
                    + "Description-Content-Type: text/markdown\n\n" + (FOLDER / project["readme"]).read_text(),
        "WHEEL": f"Wheel-Version: 1.0\nGenerator: rockstack\nRoot-Is-Purelib: false\nTag: {TAG}\n",
        "entry_points.txt": "[console_scripts]\n" + "".join(f"{one} = {goal}\n" for one, goal in project["scripts"].items()),
    }
    contents |= {f"{name}.dist-info/{file}": (0o644, text.encode()) for file, text in texts.items()}
    record = f"{name}.dist-info/RECORD"
    rows = [f"{file},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}\n"
            for file, (_, data) in sorted(contents.items())]
    contents[record] = 0o644, "".join([*rows, f"{record},,\n"]).encode()
    with zipfile.ZipFile(folder / f"{name}-{TAG}.whl", "w", zipfile.ZIP_DEFLATED, compresslevel=1) as wheel:
        for file, (mode, data) in sorted(contents.items()):
            entry = zipfile.ZipInfo(file)
            entry.external_attr, entry.compress_type = (0o100000 | mode) << 16, zipfile.ZIP_DEFLATED
            wheel.writestr(entry, data, compresslevel=1)
    return f"{name}-{TAG}.whl"
