"""Executes the notebooks through nbconvert, each in a folder of its own; cells assert what they say. notebooks.py [FOLDER]
leaves them there, with their outputs."""
import os
import sys
import tempfile
from pathlib import Path

try:
    import ipykernel  # noqa: F401
    import matplotlib  # noqa: F401
    import nbformat
    import pandas  # noqa: F401
    from nbconvert.preprocessors import ExecutePreprocessor
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

NOTEBOOKS = Path(os.environ["ROCKSTACK_SOURCE"]) / "comparisons/interfaces/python/notebooks"


def execute(file: Path, folder: Path) -> None:
    """Writes the notebook with its outputs into the folder."""
    notebook = nbformat.read(file, as_version=4)
    assert not any(cell.get("outputs") for cell in notebook.cells), f"{file}: must be kept without outputs"
    ExecutePreprocessor(timeout=300, kernel_name="python3").preprocess(notebook, {"metadata": {"path": str(folder)}})
    nbformat.write(notebook, folder / file.name)


def main() -> None:
    # Workers written in a notebook name "python3", which is to be this one.
    os.environ["PATH"] = str(Path(sys.executable).parent) + os.pathsep + os.environ["PATH"]
    files = sorted(NOTEBOOKS.glob("*.ipynb"))
    assert len(files) >= 4, files
    with tempfile.TemporaryDirectory() as scratch:
        os.environ.update(IPYTHONDIR=scratch, MPLCONFIGDIR=scratch, JUPYTER_RUNTIME_DIR=scratch, MPLBACKEND="")
        del os.environ["MPLBACKEND"]
        for file in files:
            folder = Path(sys.argv[1] if len(sys.argv) > 1 else scratch) / file.stem
            folder.mkdir(parents=True, exist_ok=True)
            execute(file, folder)
            print(file.name, "executed")


if __name__ == "__main__":
    main()
