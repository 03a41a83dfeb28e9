// SPDX-License-Identifier: MIT
// How much a browser loads of the page at most, packed as a server packs it.
import { gzipSync } from "node:zlib";

/** Of index.html and each file that it names. */
export async function page_gzip_bytes(url) {
  const load = async (address) => Buffer.from(await (await fetch(address)).arrayBuffer());
  const index = await load(url);
  const named = [...index.toString().matchAll(/(?:src|href)="([^"#]+)"/g)].map(([, name]) => new URL(name, url));
  const files = [index, ...(await Promise.all(named.map(load)))];
  return files.reduce((bytes, file) => bytes + gzipSync(file, { level: 9 }).length, 0);
}
