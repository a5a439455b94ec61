"""Stands in for generate_parameter_library: a header of the parameters in the YAML, each with its default, with the
node's overrides in their place. Usage: write_parameters.py YAML HEADER"""

import json
import os
import re
import sys

TYPES = {"string": "std::string", "string_array": "std::vector<std::string>", "double": "double", "int": "int64_t",
         "double_array": "std::vector<double>"}
with open(sys.argv[1], encoding="utf-8") as file:
    text = file.read()
name, = re.findall(r"^(\w+):$", text, re.M)
members, reads = "", ""
for parameter, body in re.findall(r"^  (\w+):\n((?:    .*\n)+)", text, re.M):
    entries = dict(re.findall(r"^    (\w+): (.+)$", body, re.M))
    kind, value = TYPES[entries["type"]], json.loads(entries["default_value"])
    size = re.search(r"fixed_size<>: \[(\d+)\]", body)
    assert size is None or int(size[1]) == len(value), parameter
    assert json.loads(entries["description"]) and entries["read_only"] == "true", parameter
    literal = json.dumps(value).replace("[", "{").replace("]", "}")
    members += f"  {kind} {parameter} = {literal};\n"
    reads += f'    if (overrides.count("{parameter}")) ' \
             f'params.{parameter} = std::any_cast<{kind}>(overrides.at("{parameter}"));\n'
os.makedirs(os.path.dirname(sys.argv[2]), exist_ok=True)
with open(sys.argv[2], "w", encoding="utf-8") as file:
    file.write(f"""#pragma once
#include <any>
#include <memory>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <string>
#include <vector>
namespace {name} {{
struct Params {{
{members}}};
class ParamListener {{
 public:
  explicit ParamListener(std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node) : node_(node) {{}}
  Params get_params() const {{
    const auto& overrides = node_->overrides;
    Params params;
{reads}    return params;
  }}
 private:
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node_;
}};
}}  // namespace {name}
""")
