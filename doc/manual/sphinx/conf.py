# conf.py - how Sphinx makes the manual. The date is SOURCE_DATE_EPOCH's; the version is that of the manual's touchstone.
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))

project = "touchstone"
author = "the authors of touchstone"
version = release = os.environ.get("TOUCHSTONE_VERSION", "")
html_title = f"touchstone {release}".strip()
extensions = ["myst_parser", "book", "offline"]
root_doc = "index"
myst_enable_extensions = ["deflist"]
myst_heading_anchors = 4
suppress_warnings = ["misc.highlighting_failure", "myst.header"]
smartquotes = False  # -- is an option
highlight_language = "text"
pygments_style = "friendly"
html_theme = "furo"
html_css_files = ["web.css"]
html_static_path = [str(pathlib.Path(__file__).parent / "static")]
html_show_sourcelink = False
html_copy_source = False
html_show_copyright = False
html_use_index = True
html_domain_indices = False
templates_path = []
