// Completion of lines of the command language. Free of the page: tests run it in Node.

/** Words that may stand for NAME and the like, from the server's hello. */
function names_of(hello) {
  const movable = hello.coordinates.filter((one) =>
    !one.passive && !/^q?[xyzw]$/.test(one.kind));
  const points = hello.points.map((point) => point.name);
  if (hello.base === 'floating' && !points.includes('base')) points.push('base');
  return {NAME: movable.map((one) => one.name), POINT: points, LINK: hello.links ?? []};
}

/** Words of a usage as {choices, skip}; `skip` words in brackets may be left out together. */
function parse_usage(usage) {
  return (usage.match(/\[[^\]]*\]|\S+/g) ?? []).flatMap((part) => {
    const inner = part.replace(/^\[|\]$/g, '').trim().split(/\s+/);
    return inner.map((word, i) => ({choices: word.split('|'),
      skip: part.startsWith('[') && i === 0 ? inner.length : 0}));
  });
}

function is_number(word) {
  return word !== '' && Number.isFinite(Number(word));
}

/** True if `word` may stand where the usage has `expected`. */
function matches(word, expected, names) {
  return expected.choices.some((choice) => {
    if (names[choice]) return names[choice].includes(word);
    if (/^[A-Z]+$/.test(choice)) return is_number(word);
    return choice === word;
  });
}

/** Indices in `usage` that the next word may have after `typed`; empty if `typed` does not fit. */
function reach(usage, typed, names) {
  const skip = (places) => {
    for (const place of places) {
      if (usage[place]?.skip > 0) places.add(place + usage[place].skip);
    }
    return places;
  };
  let places = skip(new Set([0]));
  for (const word of typed) {
    const next = [...places].filter((place) =>
      place < usage.length && matches(word, usage[place], names)).map((place) => place + 1);
    places = skip(new Set(next));
  }
  return places;
}

/**
 * Words that can stand at the end of `line`, which begins with what is typed of the last one.
 * `hello` names joints, points and links, and lists the commands' usages.
 */
export function complete(line, hello) {
  const words = line.trimStart().split(/\s+/);
  const begun = words.pop() ?? '';
  const names = names_of(hello);
  const found = new Set();
  for (const {usage} of hello.commands) {
    const parsed = parse_usage(usage);
    for (const place of reach(parsed, words, names)) {
      for (const choice of parsed[place]?.choices ?? []) {
        const options = names[choice] ?? (/^[A-Z]+$/.test(choice) ? [] : [choice]);
        for (const option of options) {
          if (option.startsWith(begun) && option !== begun) found.add(option);
        }
      }
    }
  }
  return [...found];
}

/** `line` with its last word replaced by `word` and a blank. */
export function accept(line, word) {
  return `${line.slice(0, line.length - line.match(/\S*$/)[0].length)}${word} `;
}

/** The part that all `words` begin with. */
export function shared_beginning(words) {
  let shared = words[0] ?? '';
  for (const word of words) {
    while (!word.startsWith(shared)) shared = shared.slice(0, -1);
  }
  return shared;
}
