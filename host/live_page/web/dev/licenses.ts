// SPDX-License-Identifier: MIT
import { readFileSync } from 'node:fs';

const libraries = ['preact', '@preact/signals', '@preact/signals-core', 'uplot'];

function licenseOf(library: string): string {
  return readFileSync(new URL(`../node_modules/${library}/LICENSE`, import.meta.url), 'utf8').trim();
}

/** What app.js begins with: where it comes from, and the licenses of what it contains. */
export function licenseComment(): string {
  const notices = libraries.map((library) => `${library}: ${/Copyright.*/.exec(licenseOf(library))?.[0]}`);
  const terms = licenseOf('preact').replace(/^[\s\S]*?(?=Permission is hereby)/, '');
  return [
    '/*! SPDX-License-Identifier: MIT',
    'Generated from host/live_page/web: do not edit. It contains, under the MIT License,',
    ...notices,
    '',
    `${terms} */`,
    '',
  ].join('\n');
}
