#include "inspect/warn_of_rows.hpp"

#include <fmt/format.h>

#include <vector>

#include "description/scene_queries.hpp"
#include "inspect/propose_scene.hpp"

namespace treeline {

void warn_of_rows(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  if (!scene.controller || !scene.controller->task) return;
  std::vector<ScenePoint> kept = scene.operational_points;
  keep_independent_rows(robot, scene, kept);
  for (std::size_t p = 0; p < kept.size(); ++p) {
    const ScenePoint& point = scene.operational_points[p];
    ScenePoint lost = point;
    bool any = false;
    for (std::size_t i = 0; i < lost.rows.size(); ++i) {
      lost.rows[i] = point.rows[i] && !kept[p].rows[i];
      any = any || lost.rows[i];
    }
    if (!any) continue;
    diagnostics.add(
        {Severity::warning, scene.file, 0, "operational_points",
         fmt::format("the joints cannot move rows {} of point \"{}\" independently of the others: "
                     "where the controller leads it to a pose that they cannot take, that is the "
                     "fault FOLLOWING",
                     list_rows(lost, ", "), point.name),
         fmt::format("control fewer rows, such as rows: [{}], or send it to poses within reach",
                     list_rows(kept[p], ", "))});
  }
}

}  // namespace treeline
