// Calls a package for WebAssembly as tests/calls.json says, and compares bits with what C printed.
// Usage: compare_bits.mjs PACKAGE NAME
// Would catch: arguments in another order than C's, results of other sizes or names, memory that
// calls share, constants that are read wrongly, and arrays of wrong sizes that are taken.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

import { list_bits } from "./list_bits.mjs";

const [folder, name] = process.argv.slice(2);
const robot = await import(pathToFileURL(`${folder}/${name}.mjs`));
const read = (file) => readFileSync(`${folder}/tests/${file}`, "utf8");
const told = JSON.parse(read("calls.json"));
assert.deepEqual(list_bits(robot, told), read("expected.txt").trimEnd().split("\n"));

const Real = told.real === "float" ? Float32Array : Float64Array;
const kept = [];
for (const { function: called, results, returns, arguments: given } of told.calls) {
  const call = robot[called];
  const made = call(...given);
  const arrays = results.length === 1 && !returns ? { [results[0]]: made } : made;
  assert.deepEqual(Object.keys(arrays).slice(0, results.length), results);
  for (const symbol of results) {
    assert.ok(arrays[symbol] instanceof Real);
    kept.push([arrays[symbol], arrays[symbol].slice()]);
  }
  assert.throws(() => call(...given.slice(1)), TypeError);
  assert.throws(() => call(given[0].slice(1), ...given.slice(1)), TypeError);
  assert.throws(() => call(undefined, ...given.slice(1)), TypeError);
}
for (const [array, copy] of kept) assert.deepEqual(array, copy);
for (const constant of told.constants) assert.ok(Object.isFrozen(robot[constant]));
