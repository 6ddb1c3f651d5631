"""mypy finds nothing wrong in the package, by its own stubs, nor in the notebooks' code by the package."""
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

PACKAGE = Path(os.environ["ROCKSTACK_SOURCE"]) / "comparisons/interfaces/python"


def code_of(notebook: Path) -> str:
    """Its cells one after the other, without the commands of notebooks."""
    cells = [cell["source"] for cell in json.loads(notebook.read_text())["cells"] if cell["cell_type"] == "code"]
    return "\n".join(line.rstrip("\n") for cell in cells for line in [*cell, ""] if not line.startswith("%"))


def main() -> int:
    if subprocess.run([sys.executable, "-c", "import mypy"], capture_output=True).returncode != 0:
        print("skipped: no mypy")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        files = [Path(folder) / (notebook.stem.replace("-", "_") + ".py") for notebook in sorted(PACKAGE.glob("notebooks/*.ipynb"))]
        for file in files:
            file.write_text(code_of(PACKAGE / "notebooks" / (file.stem.replace("_", "-") + ".ipynb")))
        assert len(files) >= 4, files
        return subprocess.run([sys.executable, "-m", "mypy", "--ignore-missing-imports", "--check-untyped-defs", "--cache-dir", folder,
                               PACKAGE / "rockstack", *files], env={**os.environ, "MYPYPATH": str(PACKAGE)}).returncode


if __name__ == "__main__":
    sys.exit(main())
