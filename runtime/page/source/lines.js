// Lines of the command language, as gestures and forms write them.

/** A number as the language takes it: at most six digits after the point. */
export function number(value) {
  const text = value.toFixed(6).replace(/\.?0+$/, '');
  return text === '-0' ? '0' : text;
}

export function numbers(values) {
  return [...values].map(number).join(' ');
}

/** ` in T s`, or nothing where no duration was chosen. */
function duration(seconds) {
  return seconds > 0 ? ` in ${number(seconds)} s` : '';
}

export function joint_line(name, value, unit, seconds) {
  return `joint ${name} to ${number(value)} ${unit}${duration(seconds)}`;
}

export function posture_line(name, value, unit, seconds) {
  return `posture ${name} to ${number(value)} ${unit}${duration(seconds)}`;
}

/** `how` is `to` or `by`. */
export function move_line(point, how, place, seconds) {
  return `move ${point} ${how} ${numbers(place)}${duration(seconds)}`;
}

export function turn_line(point, degrees, seconds) {
  return `turn ${point} by ${numbers(degrees)} deg${duration(seconds)}`;
}

export function drag_joint_line(name, value) {
  return `drag joint ${name} to ${number(value)}`;
}

/** `turn` (quaternion x y z w) may be left out. */
export function drag_point_line(point, place, turn = []) {
  return `drag ${point} to ${numbers([...place, ...turn])}`;
}

export function pull_line(link, at, to) {
  return `pull ${link} at ${numbers(at)} to ${numbers(to)}`;
}
