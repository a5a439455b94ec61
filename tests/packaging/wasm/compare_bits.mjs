// Calls a package for WebAssembly as tests/calls.json says, and compares bits with what C printed.
// Usage: compare_bits.mjs PACKAGE NAME
// Would catch: arguments in another order than C's, results of other sizes or names, memory that
// calls share, constants that are read wrongly, and arrays of wrong sizes that are taken.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [folder, name] = process.argv.slice(2);
const robot = await import(pathToFileURL(`${folder}/${name}.mjs`));
const read = (file) => readFileSync(`${folder}/tests/${file}`, "utf8");
const { real, calls, constants } = JSON.parse(read("calls.json"));
const lines = read("expected.txt").trimEnd().split("\n").reverse();
const [Real, Bits] = real === "float" ? [Float32Array, Uint32Array] : [Float64Array, BigUint64Array];
const same = (numbers, what) => {
  for (const bits of new Bits(Real.from(numbers).buffer)) assert.equal(String(bits), lines.pop(), what);
};

const kept = [];
for (const { function: called, results, returns, arguments: given } of calls) {
  const call = robot[called];
  const made = call(...given);
  const arrays = results.length === 1 && !returns ? { [results[0]]: made } : made;
  const own = Object.values(arrays);
  assert.deepEqual(Object.keys(arrays).slice(0, results.length), results);
  for (const symbol of results) {
    assert.ok(arrays[symbol] instanceof Real);
    same(arrays[symbol], called);
    kept.push([arrays[symbol], arrays[symbol].slice()]);
  }
  if (returns) same([own.at(-1)], called);
  assert.throws(() => call(...given.slice(1)), TypeError);
  assert.throws(() => call(given[0].slice(1), ...given.slice(1)), TypeError);
  assert.throws(() => call(undefined, ...given.slice(1)), TypeError);
}
for (const [array, copy] of kept) assert.deepEqual(array, copy);
// A limit that is not stated is the largest number in C.
const largest = real === "float" ? 3.4028234663852886e38 : Number.MAX_VALUE;
for (const constant of constants) {
  const entries = robot[constant];
  assert.ok(Object.isFrozen(entries));
  if (typeof entries[0] === "string") {
    for (const entry of entries) assert.equal(entry, lines.pop());
  } else {
    same(entries.map((entry) => Math.min(Math.max(entry, -largest), largest)), constant);
  }
}
assert.equal(lines.length, 0);
