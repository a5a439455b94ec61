// The same bits in Chromium, from a server as a page has them. Usage: compare_in_chromium.mjs FOLDER NAME...
// Would catch: modules that only Node can load, by names, types of files or ways to read them.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { find_chromium } from "../../page/browser.mjs";

const [folder, ...names] = process.argv.slice(2);
const chromium = find_chromium();
if (!chromium || !names.every((name) => existsSync(join(folder, name, "tests/expected.txt")))) {
  console.log(`skipped: ${chromium ? "the packages are not built, see packaging.wasm" : "Chromium is missing (Debian: chromium)"}`);
  process.exit(0);
}

const page = (name) => `<script type="module">
  const answer = (text) => fetch("/answer", { method: "POST", body: text });
  try {
    const { list_bits } = await import("/list_bits.mjs");
    const calls = await (await fetch("/${name}/tests/calls.json")).json();
    await answer(list_bits(await import("/${name}/${name}.mjs"), calls).join("\\n"));
  } catch (error) {
    await answer(String(error));
  }
</script>`;
const types = { mjs: "text/javascript", json: "application/json", wasm: "application/wasm" };
let answered;
const server = createServer(async (request, response) => {
  const path = decodeURIComponent(request.url);
  if (path === "/answer") {
    let text = "";
    for await (const part of request) text += part;
    response.end();
    answered(text);
  } else if (path.startsWith("/page/")) {
    response.setHeader("Content-Type", "text/html").end(page(path.slice(6)));
  } else {
    const file = path === "/list_bits.mjs" ? join(import.meta.dirname, path) : join(folder, path);
    if (!existsSync(file)) return response.writeHead(404).end();
    response.setHeader("Content-Type", types[path.split(".").at(-1)] ?? "text/plain").end(readFileSync(file));
  }
}).listen(0, "127.0.0.1");
await once(server, "listening");

for (const name of names) {
  const profile = mkdtempSync(join(tmpdir(), "treeline-wasm-"));
  const answer = new Promise((resolve) => { answered = resolve; });
  const browser = spawn(chromium, ["--headless", "--no-sandbox", "--disable-gpu", `--user-data-dir=${profile}`,
    `http://127.0.0.1:${server.address().port}/page/${name}`], { stdio: "ignore", timeout: 120000 });
  const closed = once(browser, "exit");
  const text = await Promise.race([answer, closed.then(([code]) => `Chromium ended with ${code}`)]);
  browser.kill();
  await closed;
  rmSync(profile, { recursive: true, force: true, maxRetries: 9 });
  assert.equal(text, readFileSync(join(folder, name, "tests/expected.txt"), "utf8").trimEnd());
}
server.close();
