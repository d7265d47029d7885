"""The settings of Sphinx. `make docs` builds the documentation, and a warning is an error."""

import sys
from pathlib import Path

import carom

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "_ext"))

project = "carom"
author = "the carom authors"
copyright = "the carom authors"  # noqa: A001 -- the name that Sphinx gives it
version = release = carom.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx.ext.napoleon",
    "carom_help",
]
exclude_patterns = ["_build", "_ext"]

# Formulas in $…$; links to headings.
myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence", "deflist"]
myst_heading_anchors = 3

# Docstrings are in Google's style. Attributes of dataclasses are documented in the class only.
napoleon_google_docstring = True
napoleon_numpy_docstring = False
napoleon_use_ivar = True
napoleon_attr_annotations = False
autodoc_typehints = "signature"
autodoc_member_order = "bysource"

html_theme = "furo"
# scripts/build_docs.py writes the live table of the first page there.
html_extra_path = ["gallery/live"]
html_title = f"carom {release}"
html_copy_source = False
html_show_sphinx = False
