// Would catch: a disk that turns the wrong way, by the wrong angle, back after half a turn, or not
// at all when it is seen edge-on; a plane or a rail that does not stay under the pointer.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {load_source} from './packages.mjs';

const {three, TurnDrag, PlaneDrag, SlideDrag} = await load_source('view/drag_math.js');
const vector = (...values) => new three.Vector3(...values);

/** Ray from `eye` through `place`. */
function look(eye, place) {
  return new three.Ray(eye, place.clone().sub(eye).normalize());
}

test('a disk follows the pointer around through more than a turn, in both directions', () => {
  const center = vector(0.2, -0.1, 0.5);
  const eye = vector(1, -2, 3);
  const axis = vector(0.3, 0.2, 0.9).normalize();
  const arm = vector(1, 0, 0).projectOnPlane(axis).normalize().multiplyScalar(0.3);
  const at = (angle) => center.clone().add(arm.clone().applyAxisAngle(axis, angle));
  const turn = new TurnDrag(center, axis, at(0), look(eye, at(0)));
  for (let angle = 0; angle <= 8; angle += 0.25) {
    assert.ok(Math.abs(turn.angle(look(eye, at(angle))) - angle) < 1e-9, `at ${angle} rad`);
  }
  for (let angle = 8; angle >= -3; angle -= 0.25) {
    assert.ok(Math.abs(turn.angle(look(eye, at(angle))) - angle) < 1e-9, `back at ${angle} rad`);
  }
});

test('a disk seen edge-on turns as its near rim is pushed', () => {
  // Seen from -y, the disk about z is a line; its near rim is at (0, -0.3, 0).
  const eye = vector(0, -3, 0.01);
  const grab = vector(0, -0.3, 0);
  const turn = new TurnDrag(vector(0, 0, 0), vector(0, 0, 1), grab, look(eye, grab));
  const angle = turn.angle(look(eye, vector(0.06, -0.3, 0)));
  // Pushing the near rim to +x by 0.06 m turns by 0.06/0.3 about z.
  assert.ok(Math.abs(angle - 0.2) < 1e-3, `${angle} rad`);
});

test('a ray that misses the disk\'s plane leaves the angle as it was', () => {
  const turn = new TurnDrag(vector(0, 0, 0), vector(0, 0, 1), vector(1, 0, 0),
    look(vector(0, 0, 5), vector(1, 0, 0)));
  const before = turn.angle(look(vector(0, 0, 5), vector(0, 1, 0)));
  assert.ok(Math.abs(before - Math.PI / 2) < 1e-9);
  assert.equal(turn.angle(new three.Ray(vector(0, 0, 5), vector(1, 0, 0))), before);
  assert.equal(turn.angle(new three.Ray(vector(0, 0, 5), vector(0, 0, 1))), before);
});

test('a plane stays under the pointer, and within reach', () => {
  const grab = vector(0.5, 0.2, 1);
  const eye = vector(3, -3, 2);
  const plane = new PlaneDrag(grab, vector(0, 1, 0), 2);
  const offset = plane.offset(look(eye, vector(0.9, 0.2, 0.7)));
  assert.ok(offset.distanceTo(vector(0.4, 0, -0.3)) < 1e-9);
  assert.ok(plane.offset(look(eye, vector(90, 0.2, 0))).length() <= 2 + 1e-9);
});

test('a rail follows the pointer along its axis alone', () => {
  const grab = vector(0.1, 0.2, 0.3);
  const axis = vector(0, 0, 1);
  const slide = new SlideDrag(grab, axis);
  const eye = vector(2, -1, 1);
  assert.ok(Math.abs(slide.distance(look(eye, vector(0.1, 0.2, 0.75))) - 0.45) < 1e-9);
  assert.ok(Math.abs(slide.distance(look(eye, vector(0.1, 0.2, -0.2))) + 0.5) < 1e-9);
});
