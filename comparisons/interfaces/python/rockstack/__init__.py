"""rockstack: exact histories of stacked rocking blocks, sweeps, and physics engines beside them, as arrays.

SI units; angles in rad, clockwise positive. Keys of scenes are those of scene files: `rockstack.keys("scene")`.
"""
from rockstack._core import version as __version__
from rockstack.compare import Comparison, compare
from rockstack.cylinder import RoundMotion, round_motion
from rockstack.engines import Canon, Simulation, canon, engines, simulate
from rockstack.errors import EngineError, InputError, Unfinished
from rockstack.figures import draw
from rockstack.ground import GroundMotion
from rockstack.keys import keys, shipped
from rockstack.notebook import Player, player
from rockstack.proved import Proved, proved
from rockstack.scene import Block, Scene
from rockstack.solution import Motion, Solution, solve, solve_many
from rockstack.sweep import Fragility, SobolIndices, SweepTable, Threshold, fragility, read_sweep, sobol_indices, sweep, threshold
from rockstack.worker import Setting, Setup, Worker

__all__ = [
    "Block", "Canon", "Comparison", "EngineError", "Fragility", "GroundMotion", "InputError", "Motion", "Player", "Proved", "RoundMotion",
    "Scene", "Setting", "Setup", "Simulation", "SobolIndices", "Solution", "SweepTable", "Threshold", "Unfinished", "Worker", "__version__",
    "canon", "compare", "draw", "engines", "fragility", "keys", "player", "proved", "read_sweep", "round_motion", "shipped", "simulate",
    "sobol_indices", "solve", "solve_many", "sweep", "threshold",
]
