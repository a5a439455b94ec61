// Sliders and numbers of the joints.
import {button, element, set_text, toggle} from '../element.js';
import {group_by_limb} from '../limbs.js';
import {drag_joint_line, joint_line, posture_line} from '../lines.js';
import {say, show_degrees, sign_of, to_shown, unit_of, write_value} from '../units.js';
import {is_movable} from '../view/handles.js';
import {Lease} from '../view/lease.js';
import {velocity_indices} from '../view/pose_robot.js';

const kFreeReach = {angle: Math.PI, length: 1};  // rad, m: sliders of joints without limits
const kKeyTime = 0.3;  // s for one step of the arrow keys
const kSettle = 800;   // ms after the last key for which a slider shows its goal
const kTail = 9;       // last letters of a name, which are shown however long it is
const kHigh = 0.8;     // share of its limit from which on a torque is pointed out
const kReadable = 200; // ms for which a torque stands, to be read

function range_of(coordinate) {
  const reach = unit_of(coordinate) === 'm' ? kFreeReach.length : kFreeReach.angle;
  return [coordinate.lower ?? -reach, coordinate.upper ?? reach];
}

/** A name that loses letters in its middle where it is too long. */
function write_name(name) {
  const cut = Math.max(name.length - kTail, 0);
  return element('span', {className: 'joint-name', title: name},
    element('span', {}, name.slice(0, cut)), element('span', {}, name.slice(cut)));
}

/** What a joint's motor gives, and how much of its limit that is. */
class TorqueReadout {
  #due = 0;  // ms

  constructor({unit, effort}) {
    this.effort = effort;
    this.unit = unit === 'm' ? 'N' : 'N m';
    this.text = element('span', {className: 'number'});
    this.bar = element('span', {className: 'bar', 'aria-hidden': 'true'});
    this.root = element('span', {className: 'torque', title: 'Torque or force, and its limit'},
      this.text, this.bar);
  }

  show(torque) {
    this.root.hidden = !Number.isFinite(torque);
    if (this.root.hidden || performance.now() < this.#due) return;
    this.#due = performance.now() + kReadable;
    const share = this.effort ? Math.abs(torque) / this.effort : 0;
    const limit = this.effort ? ` / ${Number(this.effort.toPrecision(3))}` : '';
    set_text(this.text, `${torque.toFixed(1).replace(/^-0\.0$/, '0.0')}${limit} ${this.unit}`);
    this.bar.style.setProperty('--share', Math.min(share, 1).toFixed(3));
    this.root.dataset.tone = share > 0.999 ? 'bad' : share > kHigh ? 'warn' : 'quiet';
  }
}

/** One joint: name and torque, slider between the limits, number, unit. */
class JointRow {
  #led_until = 0;

  constructor(coordinate, index, velocity, panel) {
    Object.assign(this, {coordinate, index, velocity, panel});
    this.lease = new Lease(panel.send);
    const {name} = coordinate;
    this.slider = element('input', {type: 'range', step: 'any', 'aria-label': `${name}, slider`});
    this.value = element('input', {type: 'number', step: 'any', 'aria-label': `${name}, value`});
    this.unit = element('span', {className: 'unit'});
    this.torque = new TorqueReadout(coordinate);
    this.lower = element('span', {className: 'limit'});
    this.upper = element('span', {className: 'limit'});
    this.row = element('div', {className: 'joint', role: 'group', 'aria-label': name},
      element('div', {className: 'joint-what'}, write_name(name), this.torque.root),
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

  show({q, tau}) {
    const value = q[this.index];
    this.torque.show(tau[this.velocity]);
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
        this.#send(joint_line, to_shown(this.coordinate, goal), kKeyTime);
      }
    });
    value.addEventListener('focus', () => value.select());
    value.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') this.#send_number();
      if (event.key === 'Escape') value.blur();
    });
  }

  #send_number() {
    if (!Number.isFinite(this.value.valueAsNumber)) return;
    this.#send(this.panel.sets_posture ? posture_line : joint_line, this.value.valueAsNumber,
      this.panel.duration());
    this.value.select();
  }

  /** `value` is in the unit that is shown. */
  #send(write, value, seconds) {
    this.panel.run(write(this.coordinate.name, value, unit_of(this.coordinate), seconds));
  }
}

export class JointPanel {
  sets_posture = false;

  /**
   * `run(line)` sends and shows the reply, `send(line)` sends a line of a drag, `change_units()`
   * hears that angles are shown in another unit.
   */
  constructor(root, {run, send, duration}, change_units) {
    Object.assign(this, {run, send, duration});
    this.rows = [];
    this.list = element('div', {className: 'joints'});
    this.units = toggle('Degrees', 'Show angles in degrees, or in radians', true, (yes) => {
      show_degrees(yes);
      for (const row of this.rows) row.paint_unit();
      change_units();
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
    const {of_coordinates} = velocity_indices(hello.coordinates);
    this.rows = hello.coordinates.map((coordinate, index) => ({coordinate, index}))
      .filter(({coordinate}) => is_movable(coordinate))
      .map(({coordinate, index}) =>
        new JointRow(coordinate, index, of_coordinates[index], this));
    this.list.replaceChildren(...this.#group(hello.tree));
    this.hint.textContent = this.rows.length > 0
      ? 'Drag a slider, or type a number and press Enter. Arrow keys step a slider.'
      : 'No joint of this robot turns or slides. Move it under Points.';
  }

  /** Rows by limb, below its name where there are several. */
  #group(tree) {
    const limbs = group_by_limb(tree, [...new Set(this.rows.map((row) => row.coordinate.joint))]);
    if (limbs.length < 2) return this.rows.map((row) => row.row);
    return limbs.map(({title, joints}) => element('section',
      {className: 'joints', 'aria-label': `limb to ${title}`}, element('h2', {}, title),
      ...this.rows.filter((row) => joints.includes(row.coordinate.joint)).map((row) => row.row)));
  }

  update(state) {
    for (const row of this.rows) row.show(state);
  }

  release() {
    for (const row of this.rows) row.lease.end();
  }
}
