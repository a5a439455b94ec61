"""A hook of MkDocs: lays what the site shows into a folder of its own, in the places that it has in the repository.

So a link means the same here, in a copy of the sources and in the site. What pages link to is laid beside them, such as
a scene or a test; the rest of the sources is not.
"""

import os
import re
import shutil
import subprocess
import tempfile

SOURCES = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
NO_PAGES = re.compile(r"^(\..*|build.*|out|install|node_modules|generated|templates)$")
FOLDER = tempfile.mkdtemp()
LINK = re.compile(r'(?:\]\(|src=")([^)#"\s]+)')


def pages():
    """Every page, as its path from the root of the sources."""
    for folder, folders, files in os.walk(SOURCES):
        folders[:] = [name for name in folders if not NO_PAGES.match(name)]
        for name in files:
            if name.endswith(".md"):
                yield os.path.relpath(os.path.join(folder, name), SOURCES)


def files_of(page):
    """The page and each file that it links to, as paths from the root of the sources."""
    yield page
    with open(os.path.join(SOURCES, page), encoding="utf-8") as file:
        for link in LINK.findall(file.read()):
            path = os.path.normpath(os.path.join(os.path.dirname(page), link))
            if os.path.isfile(os.path.join(SOURCES, path)):
                yield path


def write_headers(folder):
    """The pages of the headers, by Doxygen; where that is missing, one that says so."""
    os.makedirs(folder)
    if not shutil.which("doxygen"):
        with open(os.path.join(folder, "index.html"), "w", encoding="utf-8") as file:
            file.write("<p>Doxygen was missing where this site was built. The headers are in runtime/.</p>")
        return
    with open(os.path.join(SOURCES, "docs", "Doxyfile"), encoding="utf-8") as file:
        settings = file.read() + f'OUTPUT_DIRECTORY = "{folder}"\nHTML_OUTPUT = .\nWARN_AS_ERROR = FAIL_ON_WARNINGS\n'
    subprocess.run(["doxygen", "-"], input=settings, cwd=SOURCES, text=True, check=True)


def on_config(config):
    for path in {path for page in pages() for path in files_of(page)} | set(config["extra_css"]):
        os.makedirs(os.path.join(FOLDER, os.path.dirname(path)), exist_ok=True)
        shutil.copy(os.path.join(SOURCES, path), os.path.join(FOLDER, path))
    write_headers(os.path.join(FOLDER, "headers"))
    config["docs_dir"] = FOLDER
    return config


def on_serve(server, config, builder):
    """Watches the sources, not the copies."""
    server.unwatch(FOLDER)
    server.watch(os.path.join(SOURCES, "docs"))
    return server


def on_shutdown():
    shutil.rmtree(FOLDER)
