/** What a package gives for the calls of tests/calls.json, as expected.txt has it. In Node and in browsers. */
export function list_bits(robot, { real, calls, constants }) {
  const [Real, Bits] = real === "float" ? [Float32Array, Uint32Array] : [Float64Array, BigUint64Array];
  const lines = [];
  const add = (numbers) => lines.push(...Array.from(new Bits(Real.from(numbers).buffer), String));
  for (const { function: called, results, returns, arguments: given } of calls) {
    const made = robot[called](...given);
    const arrays = results.length === 1 && !returns ? { [results[0]]: made } : made;
    for (const symbol of results) add(arrays[symbol]);
    if (returns) add([Object.values(arrays).at(-1)]);
  }
  // A limit that is not stated is the largest number in C.
  const largest = real === "float" ? 3.4028234663852886e38 : Number.MAX_VALUE;
  const stated = (entry) => Math.min(Math.max(entry, -largest), largest);
  for (const constant of constants) {
    const entries = robot[constant];
    if (typeof entries[0] === "string") lines.push(...entries);
    else add(entries.map(stated));
  }
  return lines;
}
