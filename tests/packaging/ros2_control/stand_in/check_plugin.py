"""Stands in for what ROS reads of a package. Usage: check_plugin.py BASE FOLDER PROJECT DESCRIPTION

Would catch: descriptions that are no XML, and names of package, library, class and YAML that are not each other's."""

import os
import re
import sys
from xml.etree import ElementTree

base, folder, project, description = sys.argv[1:]
library = ElementTree.parse(os.path.join(folder, description)).getroot()
plugin = library.find("class")
assert base == "controller_interface" and library.get("path") == project
assert plugin.get("type") == f"{project}::Controller" and plugin.get("name") == f"{project}/Controller"
assert plugin.get("base_class_type") == "controller_interface::ControllerInterface"
package = ElementTree.parse(os.path.join(folder, "package.xml")).getroot()
assert package.get("format") == "3" and package.find("name").text == project
assert re.fullmatch(r"[a-z][a-z0-9_]*", project) and re.fullmatch(r"\d+\.\d+\.\d+", package.find("version").text)
for tag in ("description", "maintainer", "license"):
    assert package.find(tag).text, tag
depends = {depend.text for depend in package.findall("depend")}
with open(os.path.join(folder, "controllers.yaml"), encoding="utf-8") as file:
    assert f"type: {plugin.get('name')}\n" in file.read()
with open(os.path.join(folder, "CMakeLists.txt"), encoding="utf-8") as file:
    text = file.read()
assert set(re.search(r"set\(packages ([\w\s]+)\)", text)[1].split()) == depends
