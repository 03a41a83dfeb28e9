// SPDX-License-Identifier: MIT
// The figures of ./run bench live_page, as one JSON list in FILE; on stderr what they were made of.
//
// usage: node figures.mjs FILE TRIALS [PART ..]
//   parts: page, looks, large, stops, clients; all of them where none is named
import { writeFileSync } from "node:fs";

import WebSocket from "ws";

import { axe_findings_of_panels, DESKTOP, open_page, PHONE, shows_map, SMALL_PHONE } from "./browser.mjs";
import { start_browser, stats } from "./browser.mjs";
import { DrivenRobot, repeated } from "./driving.mjs";
import { page_gzip_bytes } from "./page_size.mjs";
import { sleep, until } from "./processes.mjs";
import { median, quantile } from "./report.mjs";
import { memory_mb, start_demo, start_paced_robot, start_synthetic_run } from "./robots.mjs";

const SLOWEST = 0.95;
const FIRST_MAPS = 10;
const WATCHED_MS = 20_000;
const LAG_MS = 3000;
const CLIENTS = 1000;
const CLIENTS_AT_ONCE = 50;
const SETTLES_MS = 5000;

const figures = [];
const console_errors = [];
const off_host_requests = [];

function add(name, value, unit, runs = 1) {
  figures.push({ name, value, unit, runs });
  console.error(`${name} ${value} ${unit}`);
}

async function look_at(browser, url, look, act) {
  const { page, errors, strangers, close } = await open_page(browser, url, look);
  await shows_map(page);
  const result = await act(page);
  console_errors.push(...errors);
  off_host_requests.push(...strangers);
  await close();
  return result;
}

/** Of a robot in the pace of the wall clock, as at a cable. */
async function page_figures() {
  const robot = await start_paced_robot(["--listen", "127.0.0.1:0"]);
  const browser = await start_browser();
  const kilobytes = (await page_gzip_bytes(robot.url)) / 1000;
  add("page_gzip_kb", kilobytes, "kB");
  const first_ms = [];
  for (let i = 0; i < FIRST_MAPS; ++i) {
    first_ms.push(await look_at(browser, robot.url, DESKTOP, async (page) => (await stats(page)).firstMapMs));
  }
  add("first_map_ms", median(first_ms), "ms", FIRST_MAPS);
  add("first_map_max_ms", Math.max(...first_ms), "ms", FIRST_MAPS);
  await look_at(browser, robot.url, DESKTOP, async (page) => {
    await sleep(WATCHED_MS);
    const { latencyMs, dropped } = await stats(page);
    add("drawn_p95_ms", quantile(latencyMs, SLOWEST), "ms", latencyMs.length);
    add("motions_dropped", dropped, "motions", latencyMs.length);
  });
  await browser.close();
  await robot.end();
}

async function looks_figures() {
  const demo = await start_demo(["--speed", "2"]);
  const browser = await start_browser();
  const findings = [];
  let looks = 0;
  for (const size of [DESKTOP, PHONE, SMALL_PHONE]) {
    for (const colorScheme of ["light", "dark"]) {
      for (const locale of ["en-GB", "de-DE"]) {
        const look = { ...size, colorScheme, locale };
        findings.push(...(await look_at(browser, demo.url, look, (page) => axe_findings_of_panels(page, look))));
        ++looks;
      }
    }
  }
  findings.forEach((line) => console.error(line));
  add("axe_findings", findings.length, "", looks);
  await browser.close();
  await demo.end();
}

async function large_figures() {
  const run = await start_synthetic_run();
  const browser = await start_browser();
  await look_at(browser, run.url, DESKTOP, async (page) => {
    await sleep(WATCHED_MS);
    const { drawMs, latencyMs } = await stats(page);
    add("draw_p95_ms", quantile(drawMs, SLOWEST), "ms", drawMs.length);
    add("drawn_large_p95_ms", quantile(latencyMs, SLOWEST), "ms", latencyMs.length);
  });
  await browser.close();
  await run.end();
}

async function stop_figures(trials) {
  const driven = await DrivenRobot.start();
  const measure = async (name, times, trial) => {
    const results = await repeated(times, trial);
    console.error(`${name}: ${results.map(({ wall_ms }) => wall_ms.toFixed(0))}`);
    return results;
  };
  const worst = async (name, times, trial) => {
    const results = await measure(name, times, trial);
    add(name, Math.max(...results.map(({ simulated_ms }) => simulated_ms)), "ms", times);
  };
  const few = Math.ceil(trials / 4);
  const { page, close } = await driven.open();
  const clicks = await measure("stop", trials, () => driven.stop_by_click(page));
  add("stop_p95_ms", quantile(clicks.map(({ wall_ms }) => wall_ms), SLOWEST), "ms", trials);
  await worst("frozen_server_stop_ms", few, () => driven.stop_by_freezing(page));
  await close();
  await worst("closed_tab_stop_ms", few, () => driven.stop_by_closing());
  await worst("cut_network_stop_ms", few, () => driven.stop_by_cutting_the_network());
  const tab = await driven.open_visible_tab();
  await worst("hidden_tab_stop_ms", few, async () => {
    const took = await driven.stop_by_hiding(tab);
    if (took.visibility !== "hidden") {
      throw new Error(`the tab is ${took.visibility}`);
    }
    return took;
  });
  await tab.close();
  const late_commands = await driven.late_motions("to_server_ms", LAG_MS);
  const late_pictures = await driven.late_motions("to_browser_ms", LAG_MS);
  add("late_motions", late_commands + late_pictures, "", 2);
  await driven.end();
}

/** Clients that listen and say nothing. */
async function client_figures() {
  const robot = await start_paced_robot(["--listen", "127.0.0.1:0"]);
  const socket_url = new URL("ws", robot.url.replace("http", "ws"));
  const { pid } = robot.echomap;
  await sleep(SETTLES_MS);
  const before_mb = memory_mb(pid);
  const sockets = [];
  const open = () =>
    new Promise((resolve, reject) => {
      const socket = new WebSocket(socket_url, "echomap.v1", { skipUTF8Validation: true });
      socket.on("open", () => resolve(socket)).on("error", reject);
    });
  while (sockets.length < CLIENTS) {
    sockets.push(...(await Promise.all(Array.from({ length: CLIENTS_AT_ONCE }, open))));
  }
  await sleep(SETTLES_MS);
  const open_now = sockets.filter(({ readyState }) => readyState === WebSocket.OPEN).length;
  add("idle_clients", open_now, "clients");
  add("idle_clients_memory_mb", memory_mb(pid) - before_mb, "MB", open_now);
  sockets.forEach((socket) => socket.terminate());
  await until("the server runs on", async () => (await fetch(new URL("api/v1/runs", robot.url))).ok);
  await robot.end();
}

const [file, trials, ...parts] = process.argv.slice(2);
const has = (part) => parts.length === 0 || parts.includes(part);
if (has("page")) {
  await page_figures();
}
if (has("looks")) {
  await looks_figures();
}
if (has("large")) {
  await large_figures();
}
if (has("page") || has("looks") || has("large")) {
  [...console_errors, ...off_host_requests].forEach((line) => console.error(line));
  add("console_errors", console_errors.length, "");
  add("off_host_requests", off_host_requests.length, "");
}
if (has("stops")) {
  await stop_figures(Number(trials));
}
if (has("clients")) {
  await client_figures();
}
writeFileSync(file, JSON.stringify(figures));
