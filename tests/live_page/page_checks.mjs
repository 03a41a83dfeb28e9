// SPDX-License-Identifier: MIT
// What the page shows of a run in lockstep, from its first map to its end and then of its recording.
// Bounds are generous here; ./run bench live_page has the figures.
//
// usage: node page_checks.mjs
import path from "node:path";

import { axe_findings_of_panels, choose_panel, DESKTOP, open_page, PHONE, shows_map, SMALL_PHONE } from "./browser.mjs";
import { start_browser, stats, view } from "./browser.mjs";
import { page_gzip_bytes } from "./page_size.mjs";
import { until } from "./processes.mjs";
import { quantile, Report, require } from "./report.mjs";
import { start_demo, start_serve } from "./robots.mjs";
import { SlowCable } from "./slow_cable.mjs";

const FIRST_MAP_MS = 10_000;
const LATENCY_MS = 1000;
const DRAW_MS = 50;
const PAGE_BYTES = 60_000;
const NEAR_PIXELS = 15;
/** Each panel, in each of the languages, themes and sizes that differ most. */
const LOOKS = [
  { ...DESKTOP, colorScheme: "light", locale: "en-GB" },
  { ...DESKTOP, colorScheme: "dark", locale: "de-DE" },
  { ...PHONE, colorScheme: "dark", locale: "en-GB" },
  { ...SMALL_PHONE, colorScheme: "light", locale: "de-DE" },
];

const report = new Report();
const browser = await start_browser();
const opened = [];
async function open(url, options) {
  const one = await open_page(browser, url, options);
  opened.push(one);
  return one;
}

const demo = await start_demo(["--speed", "8", "--no-kidnap", "--listen", "127.0.0.2:0"]);
const port = Number(new URL(demo.url).port);
const cable = new SlowCable(port, "127.0.0.2");
await cable.listen(port);
const { page, errors } = await open(`http://127.0.0.1:${port}/`);

const mode_is = (wanted) => until(`the mode is ${wanted}`, async () => (await stats(page)).mode === wanted);

await report.check("first_map", async () => {
  const { firstMapMs } = await shows_map(page);
  require(firstMapMs < FIRST_MAP_MS, `the first map came after ${firstMapMs} ms`);
  return `after ${Math.round(firstMapMs)} ms`;
});

await report.check("drawing", async () => {
  await until("motions are drawn", async () => (await stats(page)).latencyMs.length > 50);
  const { drawMs, latencyMs } = await stats(page);
  const [draw_ms, latency_ms] = [quantile(drawMs, 0.95), quantile(latencyMs, 0.95)];
  require(draw_ms < DRAW_MS, `drawing took ${draw_ms} ms`);
  require(latency_ms < LATENCY_MS, `motions were drawn ${latency_ms} ms late`);
  return `p95: drawn in ${draw_ms.toFixed(1)} ms, ${latency_ms.toFixed(0)} ms after the server told it`;
});

await report.check("size", async () => {
  const bytes = await page_gzip_bytes(page.url());
  require(bytes <= PAGE_BYTES, `the page has ${bytes} bytes, as gzip`);
  return `${bytes} bytes, as gzip`;
});

await report.check("pixels", async () => {
  // The robot is on floor that it has seen; walls are around it, and beyond them what nobody has seen.
  await until("a part of the room is mapped", async () => (await view(page)).time > 15);
  const colours = await page.evaluate(() => {
    const canvas = document.getElementById("map");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    const counts = new Map();
    for (let i = 0; i < data.length; i += 4) {
      const colour = (data[i] << 16) | (data[i + 1] << 8) | data[i + 2];
      counts.set(colour, (counts.get(colour) ?? 0) + 1);
    }
    return [...counts.values()].filter((count) => count > 500).length;
  });
  require(colours >= 4, `the map has ${colours} colours`);
  return `${colours} colours of more than 500 pixels`;
});

await report.check("go_there", async () => {
  await page.locator("#stop").click();
  await mode_is("stopped");
  try {
    await page.getByText("STOP was pressed").first().waitFor();
    await choose_panel(page, "drive");
    await page.getByRole("button", { name: "Go there" }).click();
    // The robot is in the middle of the map then; it stands on floor that it has seen.
    await page.getByRole("button", { name: "Follow the robot" }).click();
    const { x, y, width, height } = await page.locator("#map").boundingBox();
    await page.mouse.click(x + width / 2 + NEAR_PIXELS, y + height / 2);
    // At this speed it is there before the page hears that it goes; a wall may be in its way.
    return await until("it goes there, or says why not", async () => {
      const { mode } = await stats(page);
      const words = await page.locator(".banners").innerText();
      return mode === "go" ? mode : !words.includes("STOP was pressed") && mode === "stopped" && words;
    });
  } finally {
    await page.getByRole("button", { name: "Explore" }).click();
    await mode_is("explore");
  }
});

await report.check("timeline", async () => {
  await until("the past is there", async () => Number(await page.locator("#timeline").getAttribute("max")) > 5);
  await page.locator("#timeline").fill("2");
  await page.getByText("You look at the past").waitFor();
  const { time } = await view(page);
  require(time <= 2.05, `at second 2 it shows ${time} s`);
  await page.getByRole("button", { name: "Back to now" }).click();
  await until("it shows the present", async () => (await view(page)).time > 5);
});

await report.check("reconnects", async () => {
  const errors_before = errors.length;
  cable.cut();
  await page.getByText("Connection to the server lost").first().waitFor();
  cable.mend();
  await until("it is connected again", async () => (await stats(page)).connected);
  const { time } = await view(page);
  await until("the run goes on", async () => (await view(page)).time > time);
  // The browser itself tells of the connection that broke.
  errors.splice(errors_before);
});

await report.check("axe", async () => {
  const findings = [];
  for (const look of LOOKS) {
    const { page: looked, close } = await open(`http://127.0.0.1:${port}/`, look);
    await shows_map(looked);
    findings.push(...(await axe_findings_of_panels(looked, look)));
    await close();
  }
  require(findings.length === 0, findings.join("\n"));
});

await report.check("ends", async () => {
  // As fast as it can, so that it ends.
  await page.getByRole("button", { name: "max" }).click();
  await until("the run ends", async () => (await stats(page)).mode === "ended", 120_000);
  await page.locator(".banner", { hasText: "Next" }).waitFor();
  return page.locator(".banners").innerText();
});

// Who served is gone, which a browser calls an error.
const noted = opened.map((one) => [...one.errors]).flat();
await demo.end();
await page.close();

await report.check("recording", async () => {
  const serve = await start_serve([path.join(demo.folder, "run")]);
  const { page: recorded, errors: found, close } = await open(serve.url);
  await until("the recording is shown", async () => (await view(recorded))?.tiles > 0);
  const length = async () => Number(await recorded.locator("#timeline").getAttribute("max"));
  await until("the timeline is there", async () => (await length()) > 0);
  const end = await length();
  await recorded.locator("#timeline").fill(String(end / 2));
  const half = await view(recorded);
  require(Math.abs(half.time - end / 2) < 0.3 * end, `in the middle of ${end} s it shows ${half.time} s`);
  await recorded.getByRole("button", { name: "Play" }).click();
  await until("it plays", async () => (await view(recorded)).time > half.time);
  noted.push(...found);
  await close();
  await serve.end();
});

await report.check("console", () => require(noted.length === 0, noted.join("\n")));
await report.check("requests", () => {
  const strangers = opened.flatMap((one) => one.strangers);
  require(strangers.length === 0, strangers.join("\n"));
});

cable.close();
await browser.close();
report.print();
