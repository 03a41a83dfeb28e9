// SPDX-License-Identifier: MIT
// A real browser without a screen that looks at the page.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

import { chromium } from "playwright-core";

import { until } from "./processes.mjs";

const AXE = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
export const CHROMIUM = process.env.ECHOMAP_CHROMIUM ?? "/usr/bin/chromium";
export const FLAGS = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];
export const DESKTOP = { viewport: { width: 1280, height: 800 } };
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };
export const SMALL_PHONE = { ...PHONE, viewport: { width: 320, height: 568 } };
export const PANELS = ["drive", "status", "layers", "plots", "log"];

export function start_browser(args = []) {
  return chromium.launch({ executablePath: CHROMIUM, args: [...FLAGS, ...args] });
}

/**
 * A page in a fresh profile, and what it should not do: errors on its console, and requests to
 * other hosts.
 */
export async function open_page(browser, url, options = DESKTOP) {
  const context = await browser.newContext({ locale: "en-GB", ...options });
  const page = await context.newPage();
  const errors = [];
  const strangers = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) {
      errors.push(`${message.text()} (${message.location().url})`);
    }
  });
  page.on("pageerror", (error) => errors.push(String(error)));
  const { host } = new URL(url);
  const note = (address) => {
    const asked = new URL(address);
    if (!["data:", "blob:"].includes(asked.protocol) && asked.host !== host) {
      strangers.push(address);
    }
  };
  page.on("request", (request) => note(request.url()));
  page.on("websocket", (socket) => note(socket.url()));
  await page.goto(url, { waitUntil: "commit" });
  return { page, context, errors, strangers, close: () => context.close() };
}

export const stats = (page) => page.evaluate(() => globalThis.__echomap?.stats() ?? null);
export const view = (page) => page.evaluate(() => globalThis.__echomap?.view ?? null);

/** Until the page draws a map of a run whose motion has come. */
export function shows_map(page, within_ms = 60_000) {
  return until("a map is drawn", async () => {
    const seen = await stats(page);
    return seen?.firstMapMs !== null && seen?.connected && seen;
  }, within_ms);
}

/** What axe-core finds in each panel of a page that looks so, one line for each element. */
export async function axe_findings_of_panels(page, look) {
  const findings = [];
  for (const panel of PANELS) {
    await choose_panel(page, panel);
    const where = `${look.viewport.width} px, ${look.colorScheme}, ${look.locale}, ${panel}`;
    findings.push(...(await axe_findings(page)).map((line) => `${where}: ${line}`));
  }
  return findings;
}

async function axe_findings(page) {
  await page.evaluate(AXE);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  return violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, failureSummary }) => `${id} at ${target}: ${failureSummary.replaceAll("\n", " ")}`),
  );
}

export async function choose_panel(page, name) {
  const tab = page.locator(`#tab-${name}`);
  if ((await tab.getAttribute("aria-selected")) !== "true") {
    await tab.click();
  }
}
