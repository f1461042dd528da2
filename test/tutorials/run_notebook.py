#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""run_notebook.py NOTEBOOK SOURCE FOLDER [-write]: runs the cells of a notebook one after the other, where the simulation's
plans are as in the project's folder SOURCE and the programs of FOLDER are installed. What they print must be what the
notebook shows, and a cell that shows pictures must draw as many. With -write the notebook gets both instead."""

import base64
import contextlib
import io
import json
import os
import sys
import tempfile
import warnings
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def outputs_of(source, names):
    """Run a cell: its outputs as a notebook has them."""
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(source, names)
    outputs = []
    if printed.getvalue():
        outputs.append({"name": "stdout", "output_type": "stream", "text": printed.getvalue().splitlines(keepends=True)})
    for number in plt.get_fignums():
        picture = io.BytesIO()
        plt.figure(number).savefig(picture, dpi=70, bbox_inches="tight", metadata={"Software": None})
        data = {"image/png": base64.b64encode(picture.getvalue()).decode()}
        outputs.append({"data": data, "metadata": {}, "output_type": "display_data"})
    plt.close("all")
    return outputs


def printed(outputs):
    return "".join("".join(one.get("text", [])) for one in outputs)


def pictures(outputs):
    return sum(one["output_type"] == "display_data" for one in outputs)


def main(path, source, programs, writes):
    notebook = json.loads(path.read_text())
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        Path("simulation").symlink_to(source / "simulation")
        os.environ["PATH"] = os.pathsep.join([str(programs), os.environ["PATH"]])
        warnings.simplefilter("ignore")
        names = {}
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        for number, cell in enumerate(cells, 1):
            outputs = outputs_of("".join(cell["source"]), names)
            if writes:
                cell.update(outputs=outputs, execution_count=number)
            elif printed(outputs) != printed(cell["outputs"]):
                sys.exit(f"cell {number} prints\n{printed(outputs)}and shows\n{printed(cell['outputs'])}")
            elif pictures(outputs) != pictures(cell["outputs"]):
                sys.exit(f"cell {number} draws {pictures(outputs)} pictures and shows {pictures(cell['outputs'])}")
        os.chdir(source)
    if writes:
        path.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main(*(Path(one).resolve() for one in sys.argv[1:4]), "-write" in sys.argv[4:])
