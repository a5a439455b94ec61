// Would catch: plots and traces that join the end of a motion with its beginning when it is shown
// again, a record that grows without end, a replay that shows another moment than it says.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {load_source} from './packages.mjs';

const {Recorder} = await load_source('recorder.js');

function times(states) {
  return states.map(({time}) => time);
}

test('a motion that begins again leaves nothing of before', () => {
  const recorder = new Recorder();
  assert.deepEqual([0, 0.1, 0.1, 0.2].map((time) => recorder.add({time})),
    [false, false, false, false]);
  assert.equal(recorder.states.length, 4);
  assert.equal(recorder.add({time: 0.05}), true);
  assert.deepEqual(times(recorder.states), [0.05]);
  assert.equal(recorder.add({time: 0.1}), false);
  assert.deepEqual(times(recorder.recent(10)), [0.05, 0.1]);
});

test('a moment is the state before it', () => {
  const recorder = new Recorder();
  for (const time of [1, 2, 3, 4]) recorder.add({time});
  assert.deepEqual([0, 1, 2.9, 3, 9].map((time) => recorder.at(time).time), [1, 1, 2, 3, 4]);
  assert.deepEqual(recorder.span, [1, 4]);
  assert.deepEqual(times(recorder.recent(1)), [3, 4]);
  assert.deepEqual(times(recorder.recent(1, 3.5)), [2, 3]);
});

test('what is kept is bounded', () => {
  const recorder = new Recorder();
  for (let i = 0; i < 40000; ++i) recorder.add({time: i / 30, histogram: {period: [i]}});
  assert.ok(recorder.states.length <= 18000, `${recorder.states.length} states`);
  assert.ok(recorder.span[1] - recorder.span[0] > 500, 'nearly ten minutes are kept');
  assert.equal(recorder.at(1000).histogram, null, 'histograms are not kept');
});
