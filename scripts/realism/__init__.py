"""Measured numbers beside the engine: one module per subject, for scripts/realism_figures.py."""
