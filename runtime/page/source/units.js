// How values of coordinates are shown: angles in degrees or radians, lengths in metres.

let degrees = true;

export function show_degrees(yes) {
  degrees = yes;
}

function turns(coordinate) {
  return coordinate.kind === 'angle' || coordinate.kind === 'planar_theta';
}

export function unit_of(coordinate) {
  if (!turns(coordinate)) return 'm';
  return degrees ? 'deg' : 'rad';
}

/** How a unit looks beside a number. */
export function sign_of(coordinate) {
  return unit_of(coordinate) === 'deg' ? '°' : unit_of(coordinate);
}

function factor(coordinate) {
  return unit_of(coordinate) === 'deg' ? 180 / Math.PI : 1;
}

/** A value of q in the unit that is shown. */
export function to_shown(coordinate, value) {
  return value * factor(coordinate);
}

/** The shown number as text, without its unit. */
export function write_value(coordinate, value) {
  const text = to_shown(coordinate, value).toFixed(unit_of(coordinate) === 'deg' ? 1 : 3);
  return /^-[0.]*$/.test(text) ? text.slice(1) : text;
}

/** The same with its unit. */
export function say(coordinate, value) {
  const sign = sign_of(coordinate);
  return `${write_value(coordinate, value)}${sign === '°' ? '' : ' '}${sign}`;
}

/** How a number in a unit of SI is shown: [factor, unit]. Angles follow the choice of degrees. */
export function shown_as(wanted, unit = wanted) {
  if (wanted === 'mm' && unit === 'm') return [1000, 'mm'];
  if (degrees && unit.startsWith('rad')) return [180 / Math.PI, unit.replace('rad', '°')];
  return [1, unit.replace('us', 'µs')];
}
