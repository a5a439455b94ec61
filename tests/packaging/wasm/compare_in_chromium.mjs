// The same bits in Chromium, from a server as a page has them. Usage: compare_in_chromium.mjs FOLDER NAME...
// Would catch: modules that only Node can load, by names, types of files or ways to read them.
import assert from "node:assert/strict";
import { once } from "node:events";
import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";

import { find_chromium, launch_browser } from "../../page/browser.mjs";
import { page_is_built } from "../../page/packages.mjs";

const [folder, ...names] = process.argv.slice(2);
const missing = !find_chromium() ? "Chromium is missing (Debian: chromium)"
  : !page_is_built() ? "the page of drive and its packages are not built"
  : !names.every((name) => existsSync(join(folder, name, "tests/expected.txt")))
    ? "the packages are not built, see packaging.wasm" : "";
if (missing) {
  console.log(`skipped: ${missing}`);
  process.exit(0);
}

const types = { ".mjs": "text/javascript", ".json": "application/json", ".wasm": "application/wasm" };
const server = createServer((request, response) => {
  const path = decodeURIComponent(request.url);
  if (path === "/") return response.setHeader("Content-Type", "text/html").end("<!doctype html>");
  const file = path === "/list_bits.mjs" ? join(import.meta.dirname, path) : join(folder, path);
  if (!existsSync(file)) return response.writeHead(404).end();
  response.setHeader("Content-Type", types[extname(path)] ?? "text/plain").end(readFileSync(file));
}).listen(0, "127.0.0.1");
await once(server, "listening");

/** In the page: the bits of all calls of a package. */
async function list_bits_of(name) {
  const { list_bits } = await import("/list_bits.mjs");
  const calls = await (await fetch(`/${name}/tests/calls.json`)).json();
  return list_bits(await import(`/${name}/${name}.mjs`), calls).join("\n");
}

const browser = await launch_browser();
try {
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/`);
  for (const name of names) {
    assert.equal(await page.evaluate(list_bits_of, name),
      readFileSync(join(folder, name, "tests/expected.txt"), "utf8").trimEnd());
  }
} finally {
  await browser.close();
  server.close();
}
