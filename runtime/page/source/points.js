// The points of a robot that can be led, and where they are.

const kAllRows = ['x', 'y', 'z', 'rx', 'ry', 'rz'];

/** Points that can be dragged: those of the scene, and a floating base. */
export function points_of(hello) {
  const named = hello.points.map((point) => ({...point}));
  if (hello.base !== 'floating' || named.some((point) => point.name === 'base')) return named;
  return [...named, {name: 'base', rows: kAllRows, is_base: true}];
}

/** States of `points_of(hello)`, in their order. */
export function point_states_of(hello, state) {
  const states = state.points;
  if (points_of(hello).length === states.length) return states;
  const goal = state.goal_q ?? state.q;
  return [...states, {at: state.q.slice(0, 3), turn: state.q.slice(3, 7),
    goal: goal.slice(0, 3), goal_turn: goal.slice(3, 7), free: false}];
}

/** Distance of a point from its goal, m; NaN where it has none. */
export function distance_from_goal({at, goal}) {
  return goal ? Math.hypot(...at.map((x, i) => x - goal[i])) : NaN;
}

/** Angle between a point's orientation and its goal's, rad; NaN where it has none. */
export function turn_from_goal({turn, goal_turn}) {
  if (!goal_turn) return NaN;
  const cosine = Math.abs(turn.reduce((sum, x, i) => sum + x * goal_turn[i], 0));
  return 2 * Math.acos(Math.min(cosine, 1));
}
