// SPDX-License-Identifier: MIT
// Fails where the built page is larger than its budget.
import { readFileSync, readdirSync } from 'node:fs';
import { gzipSync } from 'node:zlib';

const budgetBytes = 60_000;
const folder = new URL('../../built_page/', import.meta.url);
let total = 0;
for (const name of readdirSync(folder).sort()) {
  const bytes = gzipSync(readFileSync(new URL(name, folder)), { level: 9 }).length;
  total += bytes;
  console.log(`${name.padEnd(12)} ${bytes} bytes gzip`);
}
console.log(`${'page'.padEnd(12)} ${total} of ${budgetBytes} bytes gzip`);
if (total > budgetBytes) process.exit(1);
