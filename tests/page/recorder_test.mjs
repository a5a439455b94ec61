// Would catch: plots and traces that join the end of a motion with its beginning when it is shown
// again.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {load_source} from './packages.mjs';

const {Recorder} = await load_source('recorder.js');

test('a motion that begins again leaves nothing of before', () => {
  const recorder = new Recorder();
  assert.deepEqual([0, 0.1, 0.1, 0.2].map((time) => recorder.add({time})),
    [false, false, false, false]);
  assert.equal(recorder.states.length, 4);
  assert.equal(recorder.add({time: 0.05}), true);
  assert.deepEqual(recorder.states, [{time: 0.05}]);
  assert.equal(recorder.add({time: 0.1}), false);
  assert.deepEqual(recorder.recent(10).map(({time}) => time), [0.05, 0.1]);
});
