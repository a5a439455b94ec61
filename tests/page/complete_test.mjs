// Would catch: completion that offers words of another command, joints for points, or nothing
// after an optional part.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {load_source} from './packages.mjs';

const {complete, accept, shared_beginning} = await load_source('panel/complete.js');

const kHello = {
  base: 'floating',
  coordinates: [{name: 'base.x', kind: 'x'}, {name: 'elbow', kind: 'angle'},
    {name: 'elbow_roll', kind: 'angle'}, {name: 'slide', kind: 'length'}],
  points: [{name: 'left_hand'}],
  links: ['arm', 'hand'],
  commands: ['start', 'stop', 'mode joint|task|gravity', 'joint NAME to X [deg|rad|m] [in T s]',
    'joint NAME by X [deg|rad|m] [in T s]', 'move POINT by X Y Z [in T s]',
    'drag joint NAME to X [deg|rad|m]', 'pull LINK at X Y Z to X Y Z', 'hold', 'hold POINT',
    'gains [joint|task] stiffness K damping D'].map((usage) => ({usage})),
};
const offers = (line) => complete(line, kHello).sort();

test('words of commands', () => {
  assert.deepEqual(offers('st'), ['start', 'stop']);
  assert.deepEqual(offers('start'), []);
  assert.deepEqual(offers('mode '), ['gravity', 'joint', 'task']);
  assert.deepEqual(offers('gains '), ['joint', 'stiffness', 'task']);
  assert.deepEqual(offers('gains task '), ['stiffness']);
  assert.deepEqual(offers('gains stiffness 3 d'), ['damping']);
});

test('names where names stand', () => {
  assert.deepEqual(offers('joint '), ['elbow', 'elbow_roll', 'slide']);
  assert.deepEqual(offers('joint e'), ['elbow', 'elbow_roll']);
  assert.deepEqual(offers('move '), ['base', 'left_hand']);
  assert.deepEqual(offers('drag joint s'), ['slide']);
  assert.deepEqual(offers('pull '), ['arm', 'hand']);
  assert.deepEqual(offers('move elbow '), []);
});

test('what may follow a number', () => {
  assert.deepEqual(offers('joint elbow to 45 '), ['deg', 'in', 'm', 'rad']);
  assert.deepEqual(offers('joint elbow to 45 deg '), ['in']);
  assert.deepEqual(offers('joint elbow to 45 deg in 2 '), ['s']);
  assert.deepEqual(offers('joint elbow to abc '), []);
  assert.deepEqual(offers('move left_hand by 0 0 -1e-1 '), ['in']);
});

test('taking an offer replaces what was begun', () => {
  assert.equal(accept('joint el', 'elbow'), 'joint elbow ');
  assert.equal(accept('joint ', 'elbow'), 'joint elbow ');
  assert.equal(shared_beginning(['elbow', 'elbow_roll']), 'elbow');
  assert.equal(shared_beginning([]), '');
});
