#include "emission/loop_templates.hpp"

#include "emission/core_headers.hpp"
#include "emission/print_link_table.hpp"

namespace treeline {

std::vector<LoopTemplate> list_loop_templates(std::span<const Program> programs) {
  std::vector<LoopTemplate> headers = {{"link_vectors", core_headers::kLinkVectors},
                                       {"link_table", core_headers::kLinkTable},
                                       {"link_pose", core_headers::kLinkPose},
                                       {"link_factors", core_headers::kLinkFactors},
                                       {"link_friction", core_headers::kLinkFriction},
                                       {"link_motion", core_headers::kLinkMotion},
                                       {"link_inertia", core_headers::kLinkInertia},
                                       {"link_matrix", core_headers::kLinkMatrix},
                                       {"link_articulation", core_headers::kLinkArticulation},
                                       {"link_rows", core_headers::kLinkRows},
                                       {"link_functions", core_headers::kLinkFunctions}};
  if (has_inputs(programs)) headers.push_back({"link_inputs", core_headers::kLinkInputs});
  return headers;
}

}  // namespace treeline
