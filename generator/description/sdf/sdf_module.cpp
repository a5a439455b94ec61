// The part that needs libsdformat: a module that the program loads when it meets SDF, see
// `read_sdf`.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sdf/Model.hh>
#include <sdf/World.hh>
#include <vector>

#include "description/sdf/flatten_model.hpp"
#include "description/sdf/read_sdf.hpp"

namespace treeline {
namespace {

/// Models of the file that can move, at its top or in its worlds.
std::vector<const sdf::Model*> list_models(const sdf::Root& root) {
  std::vector<const sdf::Model*> models;
  if (root.Model() != nullptr) models.push_back(root.Model());
  for (std::uint64_t w = 0; w < root.WorldCount(); ++w) {
    const sdf::World& world = *root.WorldByIndex(w);
    for (std::uint64_t i = 0; i < world.ModelCount(); ++i) {
      if (!world.ModelByIndex(i)->Static()) models.push_back(world.ModelByIndex(i));
    }
  }
  return models;
}

void note_world(const sdf::Root& root, const std::string& file, Diagnostics& diagnostics) {
  if (root.WorldCount() == 0) return;
  const auto g = root.WorldByIndex(0)->Gravity();
  diagnostics.add({Severity::note, file, 0, "sdf/world",
                   fmt::format("of the world only the model is read, not its pose nor gravity, "
                               "which is [{}, {}, {}]",
                               g.X(), g.Y(), g.Z()),
                   "set gravity in the scene; the model's frame is the world"});
}

std::optional<FlatModel> read(const SdfText& text, Diagnostics& diagnostics) {
  const auto root = load_sdf(text, diagnostics);
  if (!root) return std::nullopt;
  const std::vector<const sdf::Model*> models = list_models(*root);
  if (models.size() != 1) {
    std::vector<std::string> names;
    for (const sdf::Model* model : models) names.push_back(model->Name());
    diagnostics.add(
        {Severity::error, text.shown, 0, "sdf",
         models.empty() ? "the file has no model that moves: there is none, or all are <static>"
                        : fmt::format("the file has several models: {}", fmt::join(names, ", ")),
         models.empty()
             ? "name the file of a robot, or remove <static> from its model"
             : "write one model in a file; a scene can list several files under robots"});
    return std::nullopt;
  }
  note_world(*root, text.shown, diagnostics);
  return flatten_model(*models.front(), text.shown, diagnostics);
}

}  // namespace
}  // namespace treeline

extern "C" __attribute__((visibility("default"))) void treeline_read_sdf(
    const treeline::SdfText& text, std::optional<treeline::FlatModel>& model,
    treeline::Diagnostics& diagnostics) {
  model = treeline::read(text, diagnostics);
}
