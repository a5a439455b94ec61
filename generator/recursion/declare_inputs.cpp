#include "recursion/declare_inputs.hpp"

#include <string>

namespace treeline {
namespace {

int internal_force_entries(const Mechanism& mechanism) {
  int entries = 0;
  for (const MechanismObject& object : mechanism.objects) {
    entries += 6 * (static_cast<int>(object.grasps.size()) - 1);
  }
  return entries;
}

}  // namespace

int size_of(IndexSpace space, const Mechanism& mechanism) {
  switch (space) {
    case IndexSpace::positions:
      return mechanism.nq();
    case IndexSpace::velocities:
      return mechanism.nv();
    case IndexSpace::task_rows:
      return mechanism.task_rows();
    case IndexSpace::external_forces:
      return 6 * static_cast<int>(mechanism.external_forces.size());
    case IndexSpace::contacts:
      return 3 * static_cast<int>(mechanism.contacts.size());
    case IndexSpace::objects:
      return 6 * static_cast<int>(mechanism.objects.size());
    case IndexSpace::linkages:
      return internal_force_entries(mechanism);
    case IndexSpace::grasp_gains:
      break;
  }
  return 2;
}

TracedInputs::TracedInputs(const Mechanism& mechanism, Function function, Program& program) {
  for (const Quantity quantity : info_of(function).inputs) {
    const QuantityInfo& row = info_of(quantity);
    const int size = size_of(row.space, mechanism);
    if (size == 0) continue;
    program.arguments.push_back({row.symbol, size, 1, row.meaning});
    std::vector<Expression>& entries = entries_[static_cast<std::size_t>(quantity)];
    for (int i = 0; i < size; ++i) {
      entries.push_back(
          program.graph.input(std::string(row.symbol) + "[" + std::to_string(i) + "]"));
    }
  }
}

}  // namespace treeline
