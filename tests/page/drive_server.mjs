// Starts the program `treeline drive` for tests, on any free port.
import {spawn} from 'node:child_process';
import path from 'node:path';

import {kSource} from './packages.mjs';

const kAddress = /http:\/\/127\.0\.0\.1:\d+\/\?token=\S+/;
const kLongestStart = 300000;  // ms: it generates and compiles the robot

export class DriveServer {
  said = '';

  /** Files are relative to the root of the source tree; `options` are those of the program. */
  async start(files, options = []) {
    this.program = spawn(process.env.TREELINE_DRIVE, ['drive',
      ...files.map((file) => path.join(kSource, file)), '--port', '0', ...options],
    {stdio: ['pipe', 'pipe', 'pipe']});
    this.ended = new Promise((resolve) => this.program.on('exit', resolve));
    for (const stream of [this.program.stdout, this.program.stderr]) {
      stream.on('data', (data) => { this.said += data; });
    }
    const end = performance.now() + kLongestStart;
    while (!kAddress.test(this.said)) {
      if (this.program.exitCode !== null || performance.now() > end) {
        throw new Error(`treeline drive gave no address:\n${this.said}`);
      }
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    [this.address] = this.said.match(kAddress);
    [this.watching_address] = this.address.split('?');
  }

  /** Ends as Ctrl-C does; resolves with the exit status. */
  async close() {
    this.program.kill('SIGINT');
    const overdue = setTimeout(() => this.program.kill('SIGKILL'), 10000);
    const status = await this.ended;
    clearTimeout(overdue);
    return status;
  }
}
