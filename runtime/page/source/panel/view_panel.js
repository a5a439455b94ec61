// What the picture shows.
import {button, element, toggle} from '../element.js';

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
    root.append(element('h3', {}, 'Handles'), element('div', {className: 'tools'}, ...handles),
      element('h3', {}, 'Shown'), element('div', {className: 'tools'}, ...overlays),
      element('h3', {}, 'Picture'), element('div', {className: 'tools'},
        button('Whole robot', 'Place the camera so that the whole robot is seen',
          () => view.model && view.look_at_all()),
        toggle('Follow', 'The camera goes along with a robot that goes away', true,
          (yes) => { view.follows = yes; }),
        button('Clear traces', 'Forget where the points have been', () => view.clear_traces()), button('Save PNG', 'Save the picture', save_png)),
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

  #shown(name) {
    return name !== 'frames' && name !== 'torques';
  }
}
