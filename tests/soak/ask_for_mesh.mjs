// Asks a drive for its first mesh, some thirty times a second, without a right to it or with the
// token, and takes all of the answer, a little or nothing.
//   node ask_for_mesh.mjs ADDRESS SECONDS
import http from 'node:http';

import {dice} from './dice.mjs';

const url = new URL(process.argv[2]);
const end = performance.now() + 1000 * Number(process.argv[3]);
const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));
const answers = {};
let bytes = 0;

async function ask(random) {
  while (performance.now() < end) {
    const address = `/mesh/0${random() < 0.5 ? '' : url.search}`;
    const takes = random() < 0.5;
    const request = http.get({host: url.hostname, port: url.port, path: address, agent: false},
      (response) => {
        answers[response.statusCode] = (answers[response.statusCode] ?? 0) + 1;
        if (takes) response.on('data', (data) => { bytes += data.length; });
      });
    request.on('error', () => {});
    setTimeout(() => request.destroy(), 3000 * random());
    await pause(200 * random());
  }
}

await Promise.all([1, 2, 3].map((seed) => ask(dice(seed))));
console.log(`requests for the mesh: ${JSON.stringify(answers)}, ${(bytes / 1e6).toFixed(0)} MB taken`);
process.exit(0);
