// SPDX-License-Identifier: MIT
// Takes pictures of the page that a server serves, and says what axe-core and the console find.
//   node dev/screenshots.mjs URL FOLDER
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { chromium } from 'playwright-core';

const [url = 'http://127.0.0.1:8091/', folder = '.'] = process.argv.slice(2);
const axe = await readFile(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const screens = [
  { name: 'desktop_light', width: 1280, height: 800, colorScheme: 'light' },
  { name: 'desktop_dark', width: 1280, height: 800, colorScheme: 'dark' },
  { name: 'phone_dark', width: 390, height: 844, colorScheme: 'dark', hasTouch: true, deviceScaleFactor: 2 },
  { name: 'small_light', width: 320, height: 568, colorScheme: 'light', hasTouch: true, deviceScaleFactor: 2 },
];
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu'] });
for (const { name, width, height, ...options } of screens) {
  const page = await browser.newPage({ viewport: { width, height }, bypassCSP: false, ...options });
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && console.log(name, message.text()));
  page.on('pageerror', (error) => console.log(name, String(error)));
  await page.goto(url);
  await page.waitForTimeout(2500);
  for (const tab of ['drive', 'status', 'layers', 'plots', 'log']) {
    if (tab !== 'drive') await page.click(`#tab-${tab}`);
    await page.waitForTimeout(400);
    await page.screenshot({ path: `${folder}/${name}_${tab}.png` });
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => globalThis.axe.run());
    for (const violation of violations) {
      console.log(name, tab, violation.id, violation.nodes.slice(0, 3).map(({ target, failureSummary }) => `${target}: ${failureSummary}`).join(' | '));
    }
  }
  const { drawMs, latencyMs, ...stats } = await page.evaluate(() => globalThis.__echomap.stats());
  const quantile = (values, share) => [...values].sort((a, b) => a - b)[Math.floor(values.length * share)]?.toFixed(2);
  console.log(name, stats, `draw p50 ${quantile(drawMs, 0.5)} p95 ${quantile(drawMs, 0.95)} ms, latency p50 ${quantile(latencyMs, 0.5)} p95 ${quantile(latencyMs, 0.95)} ms`);
  await page.close();
}
await browser.close();
