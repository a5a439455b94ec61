// Writes the code that CppADCodeGen records from Pinocchio's algorithms for one robot, one file per
// function:
//   cppadcodegen_record URDF fixed|floating NAMESPACE FOLDER LINK...
// LINK are links with points, with all six rows in world axes. Gravity is 9.81 m/s^2 downward.
// Joints are ordered depth-first, children in the file's order. FOLDER/manifest.json gets the
// number of operations.
#include <tinyxml2.h>

#include <fstream>
#include <iostream>

#include "pinocchio/record_whole_mass_matrix.hpp"
// The scalar comes first.
#include "bench/peers/pinocchio/read_solver.hpp"

namespace treeline::peer::pin {
namespace {

std::string attribute(const tinyxml2::XMLElement& joint, const char* child, const char* name) {
  const auto* element = joint.FirstChildElement(child);
  const char* value = element == nullptr ? nullptr : element->Attribute(name);
  return value == nullptr ? "" : value;
}

/// Appends the links below `parent` that a joint moves.
void add_moved_links(const tinyxml2::XMLElement& robot, const std::string& parent,
                     std::vector<std::string>& links) {
  for (const auto* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    if (attribute(*joint, "parent", "link") != parent) continue;
    const std::string child = attribute(*joint, "child", "link");
    if (std::string(joint->Attribute("type")) != "fixed") links.push_back(child);
    add_moved_links(robot, child, links);
  }
}

std::string root_of(const tinyxml2::XMLElement& robot) {
  for (const auto* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    const std::string name = link->Attribute("name");
    bool moved = false;
    for (const auto* joint = robot.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      moved = moved || attribute(*joint, "child", "link") == name;
    }
    if (!moved) return name;
  }
  return {};
}

Description describe(char** arguments, int count) {
  Description description{arguments[1], std::string(arguments[2]) == "floating", {}, {}, {}};
  description.gravity = {0, 0, -9.81};
  tinyxml2::XMLDocument file;
  file.LoadFile(arguments[1]);
  const auto& robot = *file.RootElement();
  const std::string root = root_of(robot);
  if (description.floating) description.links.assign(6, root);
  add_moved_links(robot, root, description.links);
  for (int i = 5; i < count; ++i) {
    description.points.push_back({arguments[i], {1, 0, 0, 0, 1, 0, 0, 0, 1}, {}});
  }
  return description;
}

long count(const std::string& statements, const std::string& what) {
  long found = 0;
  for (auto at = statements.find(what); at != std::string::npos;
       at = statements.find(what, at + 1)) {
    ++found;
  }
  return found;
}

/// A function of a robot that is recorded.
struct Function {
  std::string name;
  std::string (*record)(const Solver<double>&);
};

/// The recorded function under the name and with the arguments of a function of C++.
std::string source_of(const std::string& space, const Function& function, const std::string& code) {
  return "#include <cmath>\n\nnamespace " + space + " {\n\nvoid " + function.name +
         "(const double* const* in, double* __restrict y) noexcept {\n" +
         code.substr(code.find("{\n") + 2) + "\n}  // namespace " + space + "\n";
}

/// Prints an entry of the manifest.
std::string facts_of(const Function& function, const std::string& statements) {
  const long divisions = count(statements, " / ");
  const long flops =
      count(statements, " + ") + count(statements, " - ") + count(statements, " * ") + divisions;
  return "{\"name\": \"" + function.name +
         "\", \"method\": \"recorded\", \"flops\": " + std::to_string(flops) +
         ", \"div\": " + std::to_string(divisions) +
         ", \"sin_cos\": " + std::to_string(count(statements, "cos(")) + "}";
}

void write_functions(const Solver<double>& solver, const std::string& space,
                     const std::string& folder) {
  const Function functions[] = {{"inverse_dynamics", record_rnea},
                                {"forward_dynamics", record_aba},
                                {"mass_matrix", record_whole_mass_matrix},
                                {"lambda_inverse", record_lambda_inverse},
                                {"lambda", record_lambda},
                                {"control_torque", record_control_torque}};
  std::string facts;
  for (const Function& function : functions) {
    const std::string code = function.record(solver);
    std::ofstream(folder + '/' + function.name + ".cpp") << source_of(space, function, code);
    facts += (facts.empty() ? "" : ",\n") + facts_of(function, code);
  }
  std::ofstream(folder + "/manifest.json") << "{\"functions\": [\n" << facts << "\n]}\n";
}

}  // namespace
}  // namespace treeline::peer::pin

int main(int count, char** arguments) {
  using namespace treeline::peer::pin;
  if (count < 6) {
    std::cerr << "usage: cppadcodegen_record URDF fixed|floating NAMESPACE FOLDER LINK...\n";
    return 2;
  }
  const auto solver = read_solver(describe(arguments, count));
  if (!solver) {
    std::cerr << arguments[1] << ": Pinocchio does not read the robot as it is described\n";
    return 1;
  }
  write_functions(*solver, arguments[3], arguments[4]);
  return 0;
}
