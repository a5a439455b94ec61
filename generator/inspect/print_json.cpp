#include <cmath>
#include <nlohmann/json.hpp>

#include "inspect/inspect_robot.hpp"
#include "text/json_text.hpp"

namespace treeline {
namespace {

using Json = nlohmann::ordered_json;

Json finite(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json to_json(const std::optional<Inertial>& nearest) {
  if (!nearest) return nullptr;
  return {{"ixx", nearest->ixx}, {"ixy", nearest->ixy}, {"ixz", nearest->ixz},
          {"iyy", nearest->iyy}, {"iyz", nearest->iyz}, {"izz", nearest->izz}};
}

Json to_json(const LinkReport& link) {
  Json json{{"name", link.name},
            {"parent", link.parent},
            {"joint", link.joint},
            {"joint_type", link.joint_type},
            {"moves", link.moves},
            {"motion", link.motion},
            {"lumped_with", link.lumped_with.empty() ? Json(nullptr) : Json(link.lumped_with)},
            {"inertial", nullptr}};
  if (!link.has_inertial) return json;
  json["inertial"] = {{"mass", link.mass},
                      {"com", link.com},
                      {"principal_moments", link.moments},
                      {"unphysical", link.unphysical ? Json(*link.unphysical) : Json(nullptr)},
                      {"felt", link.felt},
                      {"nearest", to_json(link.nearest)},
                      {"flat", link.flat ? Json(*link.flat) : Json(nullptr)}};
  return json;
}

Json to_json(const JointReport& joint) {
  Json json{{"name", joint.name},
            {"type", joint.type},
            {"q", joint.q},
            {"nq", joint.nq},
            {"v", joint.v},
            {"nv", joint.nv},
            {"unit", joint.unit},
            {"lower", finite(joint.lower)},
            {"upper", finite(joint.upper)},
            {"effort", finite(joint.effort)},
            {"velocity", finite(joint.velocity)},
            {"mimics", joint.follows.empty() ? Json(nullptr) : Json(joint.follows)}};
  if (joint.drive) {
    json["drive"] = {{"rotor", joint.drive->rotor},         {"damping", joint.drive->damping},
                     {"friction", joint.drive->friction},   {"width", joint.drive->width},
                     {"stiffness", joint.drive->stiffness}, {"rest", joint.drive->rest}};
  }
  return json;
}

Json to_json(const PointReport& point) {
  Json json{{"name", point.name}, {"link", point.link}, {"axes", point.axes}};
  if (!point.rows.empty()) json["rows"] = point.rows;
  return json;
}

Json to_json(const ReductionReport& link) {
  return {{"link", link.link},
          {"mass_before", link.mass_before},
          {"mass_after", link.mass_after},
          {"numbers_before", link.numbers_before},
          {"numbers_after", link.numbers_after}};
}

Json to_json(const NoteReport& note) {
  return {{"step", note.step}, {"link", note.link}, {"text", note.text}};
}

Json to_json(const RiskReport& risk) {
  return {{"joint", risk.joint.empty() ? Json(nullptr) : Json(risk.joint)},
          {"kind", risk.kind},
          {"digits_lost", risk.digits_lost},
          {"finding", risk.finding},
          {"advice", risk.advice}};
}

Json to_json(const std::optional<MassMatrixReport>& M) {
  if (!M) return nullptr;
  return {{"diagonal", M->diagonal},
          {"least_eigenvalue", M->least},
          {"largest_eigenvalue", M->largest},
          {"condition", finite(M->condition)},
          {"scaled_condition", finite(M->scaled_condition)}};
}

Json to_json(const std::optional<LoopsReport>& loops) {
  if (!loops) return nullptr;
  return {{"rows", loops->rows},
          {"dependent", loops->dependent},
          {"freedoms", loops->freedoms},
          {"unheld", loops->unheld}};
}

template <class Items>
Json list(const Items& items) {
  Json json = Json::array();
  for (const auto& item : items) json.push_back(to_json(item));
  return json;
}

}  // namespace

std::string print_json(const Report& report) {
  const Json json{{"robot", report.robot},
                  {"urdf", report.urdf},
                  {"scene", report.scene.empty() ? Json(nullptr) : Json(report.scene)},
                  {"base", report.base},
                  {"gravity", report.gravity},
                  {"coordinates", report.nq},
                  {"velocities", report.nv},
                  {"mass", report.mass},
                  {"moving_mass", report.moving_mass},
                  {"com", report.com},
                  {"links", list(report.links)},
                  {"joints", list(report.joints)},
                  {"operational_points", list(report.operational_points)},
                  {"external_forces", list(report.external_forces)},
                  {"reductions", list(report.reductions)},
                  {"notes", list(report.notes)},
                  {"mass_matrix", to_json(report.mass_matrix)},
                  {"loops", to_json(report.loops)},
                  {"risks", list(report.risks)}};
  return json_text(json);
}

}  // namespace treeline
