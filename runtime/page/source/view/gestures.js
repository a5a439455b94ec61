// Pointers on the picture: handles are dragged, links are pulled, the rest turns the camera.
import * as three from 'three';

import {drag_joint_line, drag_point_line, pull_line} from '../lines.js';
import {PlaneDrag, SlideDrag, TurnDrag} from './drag_math.js';
import {Lease} from './lease.js';

function clamp(value, {lower, upper}) {
  return Math.min(Math.max(value, lower ?? -Infinity), upper ?? Infinity);
}

/** Link of the model that `part` belongs to. */
function link_of(part) {
  let found = part;
  while (found && !found.isURDFLink) found = found.parent;
  return found;
}

/**
 * Turns pointer events into lines of the command language. `view` has the stage, the handles, the
 * model, the newest state and its points; `send` sends a line; `tell` shows what the handle under
 * the pointer does, or nothing.
 */
export class Gestures {
  pulls_links = false;
  #drag = null;

  constructor(view, send, tell) {
    this.view = view;
    this.tell = tell;
    this.lease = new Lease(send);
    const canvas = view.stage.canvas;
    const listen = (name, call) => canvas.addEventListener(name, call, {capture: true});
    listen('pointerdown', (event) => this.#press(event));
    listen('pointermove', (event) => this.#move(event));
    // Raw events come as the mouse moves, not with the next picture.
    listen('pointerrawupdate', (event) => this.#drag && this.#move(event));
    for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      listen(name, () => this.end());
    }
    listen('pointerleave', () => this.#hover(null));
    addEventListener('blur', () => this.end());
  }

  get is_dragging() {
    return this.#drag !== null;
  }

  /** What is being led where, for the ghost: {index, value} of a joint, {point, at}, {from, to}. */
  get target() {
    return this.#drag?.target ?? null;
  }

  end() {
    if (!this.#drag) return;
    this.lease.end();
    this.#drag = null;
    this.view.stage.orbit.enabled = true;
    this.#hover(null);
  }

  #press(event) {
    if (event.button !== 0 || !event.isPrimary || !this.view.state) return;
    const caster = this.view.stage.ray_through(event);
    const drag = this.#begin(caster);
    if (!drag) return;
    event.stopImmediatePropagation();
    this.view.stage.orbit.enabled = false;
    this.view.stage.canvas.setPointerCapture(event.pointerId);
    this.#drag = drag;
    this.lease.begin();
    this.#lead(caster);
  }

  #begin(caster) {
    if (!this.view.may_drag) return null;
    const picked = this.view.handles.pick(caster);
    if (picked) {
      const {kind} = picked.handle;
      const begin = {disk: this.#begin_disk, rail: this.#begin_rail, plane: this.#begin_plane,
        belt: this.#begin_belt}[kind];
      return begin.call(this, picked.handle, picked.place, caster.ray);
    }
    return this.pulls_links ? this.#begin_pull(caster) : null;
  }

  #begin_disk(handle, place, ray) {
    const turn = new TurnDrag(handle.object.position, handle.axis, place, ray);
    return this.#lead_joint(handle, (now) => turn.angle(now));
  }

  #begin_rail(handle, place) {
    const slide = new SlideDrag(place, handle.axis);
    return this.#lead_joint(handle, (now) => slide.distance(now));
  }

  #lead_joint({index, coordinate}, moved) {
    const start = this.view.state.q[index];
    return {lead: (ray) => {
      const value = clamp(start + moved(ray), coordinate);
      return {line: drag_joint_line(coordinate.name, value), target: {index, value},
        text: `${coordinate.name} to ${this.view.say(coordinate, value)}`};
    }};
  }

  #begin_plane(handle, place) {
    const plane = new PlaneDrag(place, this.#axis(handle), this.view.radius * 4);
    const {name, at} = this.#point(handle);
    return {lead: (ray) => {
      const to = at.clone().add(plane.offset(ray));
      return {line: drag_point_line(name, to), target: {point: handle.point, at: to.toArray()},
        text: `${name} to ${to.toArray().map((x) => x.toFixed(3)).join(' ')} m`};
    }};
  }

  #begin_belt(handle, place, ray) {
    const axis = this.#axis(handle);
    const {name, at, turn: start} = this.#point(handle);
    const turn = new TurnDrag(at, axis, place, ray);
    return {lead: (now) => {
      const angle = turn.angle(now);
      const to = new three.Quaternion().setFromAxisAngle(axis, angle).multiply(start);
      return {line: drag_point_line(name, at, to.toArray()),
        target: {point: handle.point, at: at.toArray(), turn: to.toArray()},
        text: `${name} turned by ${three.MathUtils.radToDeg(angle).toFixed(1)}°`};
    }};
  }

  #begin_pull(caster) {
    const hit = caster.intersectObject(this.view.model, true).find((one) =>
      one.object.isMesh && link_of(one.object));
    const link = hit && link_of(hit.object);
    if (!link || !this.view.can_pull(link.urdfName)) return null;
    const at = link.worldToLocal(hit.point.clone());
    const plane = new PlaneDrag(hit.point, caster.ray.direction.clone().negate(),
      this.view.radius * 4);
    return {lead: (ray) => {
      const to = hit.point.clone().add(plane.offset(ray));
      return {line: pull_line(link.urdfName, at, to),
        target: {from: link.localToWorld(at.clone()), to}, text: `pull ${link.urdfName}`};
    }};
  }

  #axis(handle) {
    return new three.Vector3().setComponent(handle.axis, 1);
  }

  /** A point's goal, or where it is if it has none, as the start of a drag. */
  #point(handle) {
    const {name} = this.view.points[handle.point];
    const now = this.view.point_states[handle.point];
    return {name, at: new three.Vector3(...(now.goal ?? now.at)),
      turn: new three.Quaternion(...(now.goal_turn ?? now.turn))};
  }

  #lead(caster) {
    const {line, target, text} = this.#drag.lead(caster.ray);
    this.#drag.target = target;
    this.lease.update(line);
    this.tell(text);
    this.view.stage.redraw();
  }

  #move(event) {
    if (this.#drag) {
      event.stopImmediatePropagation();
      this.#lead(this.view.stage.ray_through(event));
    } else if (event.buttons === 0 && this.view.state && this.view.may_drag) {
      this.#hover(this.view.handles.pick(this.view.stage.ray_through(event))?.handle ?? null);
    }
  }

  #hover(handle) {
    const {stage, handles} = this.view;
    stage.canvas.style.cursor = handle ? 'grab' : '';
    if (!handles) return;
    handles.highlight(handle);
    this.tell(handle ? this.#describe(handle) : '');
    stage.redraw();
  }

  #describe(handle) {
    if (handle.coordinate) {
      const value = this.view.state.q[handle.index];
      return `${handle.coordinate.name}: ${this.view.say(handle.coordinate, value)}`;
    }
    const {name} = this.view.points[handle.point];
    const [, , axes] = handle.name.split(':');
    return handle.kind === 'plane' ? `move ${name} in ${axes}` : `turn ${name} about ${axes}`;
  }
}
