// Sliders and numbers of the joints.
import {button, element, set_text, toggle} from '../element.js';
import {drag_joint_line, joint_line, posture_line} from '../lines.js';
import {say, show_degrees, sign_of, to_shown, unit_of, write_value} from '../units.js';
import {is_movable} from '../view/handles.js';
import {Lease} from '../view/lease.js';

const kFreeReach = {angle: Math.PI, length: 1};  // rad, m: sliders of joints without limits
const kKeyTime = 0.3;  // s for one step of the arrow keys
const kSettle = 800;   // ms after the last key for which a slider shows its goal

function range_of(coordinate) {
  const reach = unit_of(coordinate) === 'm' ? kFreeReach.length : kFreeReach.angle;
  return [coordinate.lower ?? -reach, coordinate.upper ?? reach];
}

/** One joint: name, slider between the limits, number, unit. */
class JointRow {
  #led_until = 0;

  constructor(coordinate, index, panel) {
    Object.assign(this, {coordinate, index, panel});
    this.lease = new Lease(panel.send);
    const {name} = coordinate;
    this.slider = element('input', {type: 'range', step: 'any', 'aria-label': `${name}, slider`});
    this.value = element('input', {type: 'number', step: 'any', 'aria-label': `${name}, value`});
    this.unit = element('span', {className: 'unit'});
    this.lower = element('span', {className: 'limit'});
    this.upper = element('span', {className: 'limit'});
    this.row = element('div', {className: 'joint', role: 'group', 'aria-label': name},
      element('span', {className: 'joint-name', title: name}, name),
      element('div', {className: 'reach'}, this.slider, this.lower, this.upper), this.value,
      this.unit);
    this.#listen();
    this.paint_unit();
  }

  paint_unit() {
    const [lower, upper] = range_of(this.coordinate);
    this.slider.min = lower;
    this.slider.max = upper;
    this.slider.step = (upper - lower) / 400;
    set_text(this.lower, this.#write_limit(this.coordinate.lower));
    set_text(this.upper, this.#write_limit(this.coordinate.upper));
    set_text(this.unit, sign_of(this.coordinate));
  }

  #write_limit(limit) {
    if (limit === null) return 'free';
    const digits = unit_of(this.coordinate) === 'deg' ? 0 : 2;
    return String(Number(to_shown(this.coordinate, limit).toFixed(digits)));
  }

  show(q) {
    const value = q[this.index];
    if (!this.lease.is_held && performance.now() > this.#led_until) this.slider.value = value;
    if (document.activeElement !== this.value) {
      const text = write_value(this.coordinate, value);
      if (this.value.value !== text) this.value.value = text;
    }
    this.slider.setAttribute('aria-valuetext', say(this.coordinate, value));
  }

  #listen() {
    const {slider, value} = this;
    slider.addEventListener('pointerdown', () => this.lease.begin());
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture', 'blur']) {
      slider.addEventListener(name, () => this.lease.end());
    }
    slider.addEventListener('input', () => {
      const goal = Number(slider.value);
      if (this.lease.is_held) {
        this.lease.update(drag_joint_line(this.coordinate.name, goal));
      } else {
        this.#led_until = performance.now() + kSettle;
        this.panel.run(joint_line(this.coordinate.name, goal, this.#plain_unit(), kKeyTime));
      }
    });
    value.addEventListener('focus', () => value.select());
    value.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.#send_number();
      if (event.key === 'Escape') value.blur();
    });
  }

  #plain_unit() {
    return unit_of(this.coordinate) === 'm' ? 'm' : 'rad';
  }

  #send_number() {
    if (!Number.isFinite(this.value.valueAsNumber)) return;
    const write = this.panel.sets_posture ? posture_line : joint_line;
    this.panel.run(write(this.coordinate.name, this.value.valueAsNumber, unit_of(this.coordinate),
      this.panel.duration()));
    this.value.select();
  }
}

export class JointPanel {
  sets_posture = false;

  /** `run(line)` sends and shows the reply, `send(line)` sends a line of a drag. */
  constructor(root, {run, send, duration}) {
    Object.assign(this, {run, send, duration});
    this.rows = [];
    this.list = element('div', {className: 'joints'});
    this.units = toggle('Degrees', 'Show angles in degrees, or in radians', true, (yes) => {
      show_degrees(yes);
      for (const row of this.rows) row.paint_unit();
    });
    const posture = toggle('As posture',
      'Numbers become goals of the posture, in the null space of the task', false,
      (yes) => { this.sets_posture = yes; });
    root.append(element('div', {className: 'tools'}, this.units, posture,
      button('Home', 'All joints to where the robot began',
        () => run(`posture home${duration() > 0 ? ` in ${duration()} s` : ''}`))), this.list,
    this.hint = element('p', {className: 'hint'}));
  }

  greet(hello) {
    for (const row of this.rows) row.lease.end();
    this.rows = hello.coordinates.map((coordinate, index) => ({coordinate, index}))
      .filter(({coordinate}) => is_movable(coordinate))
      .map(({coordinate, index}) => new JointRow(coordinate, index, this));
    this.list.replaceChildren(...this.rows.map((row) => row.row));
    this.hint.textContent = this.rows.length > 0
      ? 'Drag a slider, or type a number and press Enter. Arrow keys step a slider.'
      : 'No joint of this robot turns or slides. Move it under Points.';
  }

  update(state) {
    for (const row of this.rows) row.show(state.q);
  }

  release() {
    for (const row of this.rows) row.lease.end();
  }
}
