// What the picture shows.
import {button, element, set_text, toggle} from '../element.js';

const kParts = [['ghost', 'Ghost of the goal'], ['trace', 'Trace of points'],
  ['points', 'Frames of points'], ['frames', 'Frames of links'], ['mass', 'Centre of mass'],
  ['forces', 'Forces'], ['torques', 'Torques, as shares of their limits']];
const kHandles = [['joints', 'Disks and rails of joints'],
  ['points', 'Planes and belts of points']];

export class ViewPanel {
  constructor(root, view, save_png) {
    const overlays = kParts.map(([name, label]) =>
      toggle(label, `Show or hide: ${label.toLowerCase()}`, this.#shown(name), (yes) => {
        this.chosen[name] = yes;
        this.apply(view);
      }));
    const handles = kHandles.map(([name, label]) =>
      toggle(label, `Show or hide: ${label.toLowerCase()}`, true, (yes) => {
        this.handles[name] = yes;
        this.apply(view);
      }));
    root.append(element('h2', {}, 'Handles'), element('div', {className: 'tools'}, ...handles),
      element('h2', {}, 'Shown'), element('div', {className: 'tools'}, ...overlays),
      element('h2', {}, 'Picture'), element('div', {className: 'tools'},
        toggle('Follow', 'The camera goes along with a robot that goes away', true,
          (yes) => { view.follows = yes; }),
        button('Clear traces', 'Forget where the points have been', () => view.clear_traces()),
        button('Save PNG', 'Save the picture', save_png)),
      this.floor = element('p', {className: 'readout'}),
      element('p', {className: 'hint'}, 'Drag the picture to turn it, with the right button to ' +
        'move it; the wheel zooms. A touch of two fingers does both.'));
  }

  chosen = {};
  handles = {};

  /** Passes the choices on to the robot that is shown. */
  apply(view) {
    if (!view.overlays) return;
    Object.assign(view.overlays.shown, this.chosen);
    for (const [kind, visible] of Object.entries(this.handles)) view.handles.show(kind, visible);
    view.stage.redraw();
  }

  /** Says how high the floor is, and how wide its cells are. */
  update(_, stage) {
    set_text(this.floor, `Floor at z = ${Number(stage.floor.toFixed(3))} m, cells of ` +
      `${Number(stage.floor_plane.cell.toPrecision(1))} m`);
  }

  #shown(name) {
    return name !== 'frames' && name !== 'torques';
  }
}
