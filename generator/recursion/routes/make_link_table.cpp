#include "recursion/routes/make_link_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "functions/quantity.hpp"
#include "recursion/methods/task_basis.hpp"
#include "recursion/parameters/base_parameters.hpp"

namespace treeline {

namespace {

LinkTypes::TlTurn table_turn(const PlanarRotation<double>& r) {
  return {r.c, r.s};
}

/// The rotation by what a joint adds to its coordinate, behind the last of the placement: both are
/// about the joint's axis.
PlanarRotation<double> turned_on(const PlanarRotation<double>& b, double offset) {
  if (offset == 0) return b;
  const double c = std::cos(offset);
  const double s = std::sin(offset);
  return {b.c * c - b.s * s, b.s * c + b.c * s};
}

LinkTypes::TlLink table_link(const TreeLink<double>& link) {
  const auto& [mass, h, Sigma, J] = link.inertia;
  LinkTypes::TlLink row{};
  row.parent = static_cast<std::int16_t>(link.parent);
  row.slides = link.kind == JointKind::prismatic;
  row.a = table_turn(link.R.a);
  row.alpha = table_turn(link.R.alpha);
  row.b = table_turn(row.slides ? link.R.b : turned_on(link.R.b, link.offset));
  row.rotor = link.drive.inertia;
  row.body.mass = mass;
  const Vector3<double> origin =
      row.slides ? link.p + rotate(link.R, Vector3<double>{0, 0, link.offset}) : link.p;
  const double p[3] = {origin.x, origin.y, origin.z};
  const double moment[3] = {h.x, h.y, h.z};
  const double inertia[6] = {J.xx, J.xy, J.xz, J.yy, J.yz, J.zz};
  std::copy(std::begin(p), std::end(p), row.p);
  std::copy(std::begin(moment), std::end(moment), row.body.h);
  std::copy(std::begin(inertia), std::end(inertia), row.body.J);
  return row;
}

LinkTypes::TlLinkPoint table_point(const TreePoint<double>& point) {
  LinkTypes::TlLinkPoint row{};
  row.link = static_cast<std::int16_t>(point.link);
  row.world = point.axes == Axes::world;
  const Matrix3<double> axes = transposed(point.R);
  const Vector3<double> each[3] = {axes.row_x, axes.row_y, axes.row_z};
  for (int k = 0; k < 3; ++k) {
    const double e[3] = {each[k].x, each[k].y, each[k].z};
    // Rows along the world's axes do not read these.
    for (int j = 0; j < 3; ++j) row.axes[3 * k + j] = row.world ? 0 : e[j];
  }
  const double p[3] = {point.p.x, point.p.y, point.p.z};
  std::copy(std::begin(p), std::end(p), row.p);
  return row;
}

void append_rows(const TreePoint<double>& point, std::int16_t index, LinkTableData& table) {
  for (std::int16_t k = 0; k < 6; ++k) {
    if (!point.rows[static_cast<std::size_t>(k)]) continue;
    table.rows.push_back({index, static_cast<std::int16_t>(k % 3), k >= 3});
  }
}

/// Sorts the rows by the priorities of their points, the order in which they are eliminated.
void sort_rows(const Tree<double>& tree, LinkTableData& table) {
  std::vector<std::int16_t> order(table.rows.size());
  std::iota(order.begin(), order.end(), std::int16_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::int16_t a, std::int16_t b) {
    const auto priority_of = [&](std::int16_t row) {
      const std::int16_t point = table.rows[static_cast<std::size_t>(row)].point;
      return tree.operational_points[static_cast<std::size_t>(point)].priority;
    };
    return priority_of(a) < priority_of(b);
  });
  if (std::is_sorted(order.begin(), order.end())) return;
  const auto rows = table.rows;
  std::transform(order.begin(), order.end(), table.rows.begin(),
                 [&](std::int16_t row) { return rows[static_cast<std::size_t>(row)]; });
  table.row_entries = std::move(order);
}

/// Numbers the slots: links on one way out that carry one link each share theirs.
void number_slots(LinkTableData& table) {
  std::vector<int> children(table.links.size());
  for (const auto& link : table.links) {
    if (link.parent >= 0) ++children[static_cast<std::size_t>(link.parent)];
  }
  for (auto& link : table.links) {
    if (link.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(link.parent);
    const int slot = table.links[parent].slot + (children[parent] > 1 ? 1 : 0);
    link.slot = static_cast<std::int16_t>(slot);
    table.slots = std::max(table.slots, slot + 1);
  }
}

/// Says which links each carries, and where limbs start: at the root, behind joints that slide,
/// which may take them far from there, and on long ways out.
void divide_limbs(LinkTableData& table) {
  constexpr int kLinksOfLimb = 8;
  std::vector<int> places;  // of links in their limbs
  for (std::size_t i = 0; i < table.links.size(); ++i) {
    auto& link = table.links[i];
    const int place = link.parent < 0 ? 0 : places[static_cast<std::size_t>(link.parent)] + 1;
    link.starts = link.parent < 0 || link.slides || place == kLinksOfLimb;
    places.push_back(link.starts ? 0 : place);
    link.end = static_cast<std::int16_t>(i + 1);
  }
  for (std::size_t i = table.links.size(); i-- > 0;) {
    const auto& link = table.links[i];
    if (link.parent < 0) continue;
    std::int16_t& end = table.links[static_cast<std::size_t>(link.parent)].end;
    end = std::max(end, link.end);
  }
}

/// Friction and springs of all links, where there are any, or arguments give some.
void add_drives(const Tree<double>& tree, LinkTableData& table) {
  const bool driven = table.gives(LinkInput::Gives::dampings) ||
                      std::any_of(tree.links.begin(), tree.links.end(), [](const auto& link) {
                        return link.drive.damping != 0 || link.drive.stiffness != 0;
                      });
  const bool rubbing = table.gives(LinkInput::Gives::frictions) ||
                       std::any_of(tree.links.begin(), tree.links.end(),
                                   [](const auto& link) { return link.drive.friction != 0; });
  for (const TreeLink<double>& link : tree.links) {
    const TreeDrive<double>& drive = link.drive;
    if (driven) table.drives.push_back({drive.damping, drive.stiffness, drive.rest});
    if (rubbing) table.frictions.push_back({drive.friction, drive.sharpness});
  }
}

/// Adds the coordinate of each joint, where some joints share one.
void add_couplings(const Mechanism& mechanism, const SplitTree& split, LinkTableData& table) {
  if (!split.tree.has_mimics) return;
  for (std::size_t i = 0; i < split.axes.size(); ++i) {
    const TreeLink<double>& link = split.tree.links[i];
    const int joint = link.v_index - (table.floats && !link.is_floating() ? 5 : 0);
    const double multiplier = link.is_floating() ? 1 : link.multiplier;
    const auto& coordinate = mechanism.coordinates[static_cast<std::size_t>(link.q_index)];
    const bool own_sine = link.kind == JointKind::revolute && !link.spins && split.axes[i] == 0 &&
                          (std::abs(multiplier) != 1 || !coordinate.is_angle());
    table.couplings.push_back({static_cast<std::int16_t>(joint), multiplier, link.spins, own_sine});
    table.own_sines = table.own_sines || own_sine;
    table.joints = std::max(table.joints, joint + 1);
  }
}

/// Adds the links that are axes of ball joints or of joints that move freely, if there are any.
void add_balls(const SplitTree& split, LinkTableData& table) {
  const std::vector<int>& axes = split.axes;
  if (std::all_of(axes.begin(), axes.end(), [](int axis) { return axis == 0; })) return;
  int rotations = table.floats ? 1 : 0;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const int rotation = axes[i] == 1 ? rotations++ : 0;
    table.balls.push_back({static_cast<std::int16_t>(axes[i]), static_cast<std::int16_t>(rotation),
                           static_cast<std::int16_t>(split.tree.links[i].q_index)});
  }
  table.rotations = rotations;
}

/// The frame in which an argument is given, from its entry `at` on.
LinkTypes::TlInputFrame input_frame(const MechanismPoint& frame, int of, std::size_t at) {
  LinkTypes::TlInputFrame row{static_cast<std::int16_t>(of), static_cast<std::int16_t>(at), {}, {}};
  const Rotation<double> R = planar_factors<double>(frame.pose.R);
  const Matrix3<double> columns{rotate(R, Vector3<double>{1, 0, 0}),
                                rotate(R, Vector3<double>{0, 1, 0}),
                                rotate(R, Vector3<double>{0, 0, 1})};
  const Matrix3<double> rows = transposed(columns);
  const double entries[] = {rows.row_x.x, rows.row_x.y, rows.row_x.z, rows.row_y.x, rows.row_y.y,
                            rows.row_y.z, rows.row_z.x, rows.row_z.y, rows.row_z.z};
  std::copy(std::begin(entries), std::end(entries), row.R.Q);
  const Vector3<double> p = rounded<double>(frame.pose.p);
  const double origin[] = {p.x, p.y, p.z};
  std::copy(std::begin(origin), std::end(origin), row.p);
  return row;
}

/// The place of a link among those whose inertia depends on arguments.
int place_among_loaded(int link, LinkTableData& table) {
  auto& loaded = table.loaded_links;
  const auto at = std::find(loaded.begin(), loaded.end(), link);
  const auto place = static_cast<int>(at - loaded.begin());
  if (at == loaded.end()) loaded.push_back(static_cast<std::int16_t>(link));
  return place;
}

/// Bodies that an argument gives, but for those on links that do not move.
void add_bodies(Quantity argument, const std::vector<MechanismInertia>& bodies,
                const std::vector<int>& places, LinkTableData& table) {
  LinkInput input{symbol_of(argument), LinkInput::Gives::bodies, {}};
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const MechanismPoint& frame = bodies[i].frame;
    if (frame.link < 0) continue;
    const int link = places[static_cast<std::size_t>(frame.link)];
    input.frames.push_back(
        input_frame(frame, place_among_loaded(link, table), kInertialParameters * i));
  }
  if (!input.frames.empty()) table.inputs.push_back(std::move(input));
}

/// Bodies of which an argument gives the base parameters.
void add_base_bodies(const Mechanism& mechanism, const std::vector<int>& places,
                     LinkTableData& table) {
  if (mechanism.inputs.base.empty()) return;
  LinkInput input{symbol_of(Quantity::base_parameters), LinkInput::Gives::bodies, {}};
  const auto found = base_parameters_of(mechanism);
  std::size_t last = mechanism.inputs.base.size();
  for (const BaseParameter& base : found->base) {
    const ModelParameter& parameter = found->parameters[base.parameter];
    if (!parameter.is_of_body()) break;  // those of joints come last
    if (parameter.frame != std::exchange(last, parameter.frame)) {
      const MechanismPoint& frame = mechanism.inputs.base[parameter.frame].frame;
      const int link = places[static_cast<std::size_t>(frame.link)];
      input.frames.push_back(
          input_frame(frame, place_among_loaded(link, table), input.entries.size()));
    }
    input.entries.push_back(static_cast<std::int16_t>(parameter.entry));
  }
  if (!input.frames.empty()) table.inputs.push_back(std::move(input));
}

/// Index of a parameter in the argument; -1 if no base parameter is named after it.
std::int16_t find_base_entry(const BaseParameters& found, std::size_t parameter) {
  const auto at =
      std::find_if(found.base.begin(), found.base.end(),
                   [&](const BaseParameter& base) { return base.parameter == parameter; });
  return static_cast<std::int16_t>(at == found.base.end() ? -1 : at - found.base.begin());
}

/// Rotors and friction among the base parameters that an argument gives.
void add_base_drives(const Mechanism& mechanism, SplitTree& split, LinkTableData& table) {
  if (mechanism.inputs.base.empty()) return;
  using Gives = LinkInput::Gives;
  LinkInput inputs[] = {{symbol_of(Quantity::base_parameters), Gives::rotors, {}},
                        {symbol_of(Quantity::base_parameters), Gives::dampings, {}},
                        {symbol_of(Quantity::base_parameters), Gives::frictions, {}}};
  const auto found = base_parameters_of(mechanism);
  for (std::size_t k = 0; k < found->parameters.size(); ++k) {
    const ModelParameter& parameter = found->parameters[k];
    if (parameter.is_of_body()) continue;
    const int link = split.places[link_of(parameter, mechanism)];
    const bool rubs = parameter.kind == ModelParameter::Kind::coulomb;
    if (rubs) {
      split.tree.links[static_cast<std::size_t>(link)].drive.sharpness =
          static_cast<double>(parameter.sharpness);
    }
    LinkInput& input = inputs[parameter.kind == ModelParameter::Kind::rotor ? 0 : rubs ? 2 : 1];
    input.numbers.push_back({static_cast<std::int16_t>(link), find_base_entry(*found, k),
                             static_cast<double>(parameter.factor)});
  }
  for (LinkInput& input : inputs) {
    if (!input.numbers.empty()) table.inputs.push_back(std::move(input));
  }
}

/// Origins and axes of points that arguments give.
void add_tools(const std::vector<MechanismTool>& tools, LinkTableData& table) {
  LinkInput origins{symbol_of(Quantity::tool), LinkInput::Gives::origins, {}};
  LinkInput axes{symbol_of(Quantity::tool_orientation), LinkInput::Gives::axes, {}};
  for (const MechanismTool& tool : tools) {
    const auto point = static_cast<int>(tool.point);
    origins.frames.push_back(input_frame(tool.frame, point, 3 * origins.frames.size()));
    if (!tool.orientation) continue;
    axes.frames.push_back(input_frame(tool.frame, point, 4 * axes.frames.size()));
  }
  for (LinkInput* const input : {&origins, &axes}) {
    if (!input->frames.empty()) table.inputs.push_back(std::move(*input));
  }
}

}  // namespace

LinkTableData make_link_table(const Mechanism& mechanism, bool with_points) {
  SplitTree split = split_free_joints(mechanism);
  LinkTableData table;
  add_base_drives(mechanism, split, table);
  const Tree<double>& tree = split.tree;
  table.freed =
      std::any_of(split.axes.begin(), split.axes.end(), [](int axis) { return axis > 3; });
  table.floats = tree.links.front().is_floating();
  table.gravity = mechanism.gravity;
  for (const TreeLink<double>& link : tree.links) {
    table.links.push_back(table_link(link));
    table.names.push_back(link.name);
    table.sliding = table.sliding || table.links.back().slides;
  }
  number_slots(table);
  divide_limbs(table);
  add_drives(tree, table);
  add_couplings(mechanism, split, table);
  add_balls(split, table);
  for (const TreePoint<double>& point : tree.external_forces) {
    table.pushed_points.push_back(table_point(point));
  }
  const auto is_on_world = [](const auto& point) { return point.link < 0; };
  const auto& pushed = table.pushed_points;
  table.grounded = std::any_of(pushed.begin(), pushed.end(), is_on_world);
  add_bodies(Quantity::payload, mechanism.inputs.payloads, split.places, table);
  add_bodies(Quantity::parameters, mechanism.inputs.parameters, split.places, table);
  add_base_bodies(mechanism, split.places, table);
  if (!with_points) return table;
  add_tools(mechanism.inputs.tools, table);
  for (const TreePoint<double>& point : tree.operational_points) {
    append_rows(point, static_cast<std::int16_t>(table.points.size()), table);
    table.points.push_back(table_point(point));
    table.grounded = table.grounded || is_on_world(point);
    table.turning = table.turning || has_turning_rows(point);
  }
  sort_rows(tree, table);
  return table;
}

}  // namespace treeline
