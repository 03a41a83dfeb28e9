// SPDX-License-Identifier: MIT
// Takes pictures of the page in every state, and of what a stranger sees in his first minute. No test:
// somebody looks at them.
//
// usage: node screenshots.mjs FOLDER [PART ..]
//   parts: first-minute, paced, demo, panels, recording; all of them where none is named
import { mkdirSync } from "node:fs";
import path from "node:path";

import { choose_panel, DESKTOP, open_page, PANELS, PHONE, shows_map, SMALL_PHONE } from "./browser.mjs";
import { start_browser, stats, view } from "./browser.mjs";
import { DrivenRobot, KEY } from "./driving.mjs";
import { now_us, sleep, until } from "./processes.mjs";
import { start_demo, start_serve } from "./robots.mjs";

const FIRST_MINUTE_S = 60;
const EACH_S = 5;
const SETTLES_MS = 800;
const KIDNAPPED_WITHIN_MS = 240_000;
const ENDED_WITHIN_MS = 400_000;

const [folder, ...parts] = process.argv.slice(2);
const has = (part) => parts.length === 0 || parts.includes(part);
mkdirSync(folder, { recursive: true });
const browser = await start_browser();
const take = async (page, name) => {
  await sleep(SETTLES_MS);
  await page.screenshot({ path: path.join(folder, `${name}.png`) });
  console.log(name, JSON.stringify(await view(page)));
};
const LIGHT = { ...DESKTOP, colorScheme: "light" };
const DARK_PHONE = { ...PHONE, colorScheme: "dark" };

/** From the start of the program, as somebody sees it who only typed the command. */
async function first_minute() {
  const begin_us = now_us();
  const since_s = () => ((now_us() - begin_us) / 1e6).toFixed(1);
  const demo = await start_demo(["--speed", "8"]);
  console.log(`the page is served after ${since_s()} s`);
  const { page, close } = await open_page(browser, demo.url, LIGHT);
  await shows_map(page);
  console.log(`the first map is drawn after ${since_s()} s`);
  const { pose } = await view(page);
  const moved = until("the robot moves", async () => {
    const seen = await view(page);
    return seen?.pose && Math.hypot(seen.pose.x - pose.x, seen.pose.y - pose.y) > 0.02;
  }, 60_000).then(() => console.log(`the robot is seen to move after ${since_s()} s`));
  for (let at_s = 0; at_s <= FIRST_MINUTE_S; at_s += EACH_S) {
    await sleep(Math.max(0, 1000 * at_s - (now_us() - begin_us) / 1000));
    await page.screenshot({ path: path.join(folder, `first_minute_${String(at_s).padStart(2, "0")}.png`) });
  }
  await moved;
  await close();
  await demo.end();
}

/** A robot at a cable. */
async function paced() {
  const driven = await DrivenRobot.start();
  const connecting = await open_page(browser, driven.url, LIGHT);
  await connecting.page.screenshot({ path: path.join(folder, "connecting.png") });
  await connecting.close();
  const { page, close } = await open_page(browser, driven.url, LIGHT);
  await shows_map(page);
  const other = await open_page(browser, driven.url, DARK_PHONE);
  await shows_map(other.page);
  await driven.drive(page.keyboard);
  await take(page, "driving_light_desktop");
  await take(other.page, "somebody_else_drives_dark_phone");
  await driven.let_go(page.keyboard);
  await page.keyboard.press("Escape");
  await take(page, "stopped_light_desktop");
  await take(other.page, "stopped_dark_phone");
  await other.close();
  driven.cable.cut();
  await page.getByText("Connection to the server lost").first().waitFor();
  await take(page, "server_lost_light_desktop");
  await page.keyboard.press("Escape");
  await sleep(1500);
  await take(page, "server_lost_and_stop_unconfirmed");
  driven.cable.mend();
  await close();
  await driven.end();
}

/** From exploring to the end, kidnapped in between. */
async function demo_run() {
  const demo = await start_demo(["--speed", "8"]);
  const { page, close } = await open_page(browser, demo.url, LIGHT);
  const phone = await open_page(browser, demo.url, DARK_PHONE);
  await shows_map(page);
  await until("a part is mapped", async () => (await view(page)).time > 30);
  await take(page, "exploring_light_desktop");
  await take(phone.page, "exploring_dark_phone");
  await page.locator("#stop").click();
  await take(page, "stop_pressed_light_desktop");
  await page.getByRole("button", { name: "Go there" }).click();
  await take(page, "go_there_chosen");
  const { x, y, width, height } = await page.locator("#map").boundingBox();
  await page.getByRole("button", { name: "Follow the robot" }).click();
  await sleep(SETTLES_MS);
  await page.mouse.click(x + width / 2 + 60, y + height / 2);
  await page.screenshot({ path: path.join(folder, "going_there.png") });
  await page.getByRole("button", { name: "Show all" }).click();
  await page.getByRole("button", { name: "Explore" }).click();
  await page.getByRole("button", { name: "Cut the cable" }).click();
  await until("the link is lost", async () => (await stats(page)).mode === "lost-link", 20_000).catch(() => {});
  await take(page, "link_lost_light_desktop");
  await take(phone.page, "link_lost_dark_phone");
  await until("the robot is back", async () => (await stats(page)).mode === "explore", 60_000);
  await page.locator("#timeline").fill("10");
  await take(page, "past_light_desktop");
  await page.getByRole("button", { name: "Back to now" }).click();
  await until("it looks for itself", async () => (await view(page)).particles > 0, KIDNAPPED_WITHIN_MS);
  await take(page, "localizing_light_desktop");
  await take(phone.page, "localizing_dark_phone");
  await sleep(2000);
  await take(page, "localizing_later_light_desktop");
  await until("it ends", async () => (await stats(page)).mode === "ended", ENDED_WITHIN_MS);
  await take(page, "ended_light_desktop");
  await take(phone.page, "ended_dark_phone");
  await close();
  await phone.close();
  await demo.end();
  return path.join(demo.folder, "run");
}

async function panels(url) {
  const looks = {
    light_desktop_en: { ...LIGHT, locale: "en-GB" },
    dark_desktop_de: { ...DESKTOP, colorScheme: "dark", locale: "de-DE" },
    dark_phone_en: { ...DARK_PHONE, locale: "en-GB" },
    light_small_de: { ...SMALL_PHONE, colorScheme: "light", locale: "de-DE" },
    dark_small_en: { ...SMALL_PHONE, colorScheme: "dark", locale: "en-GB" },
  };
  for (const [name, look] of Object.entries(looks)) {
    const { page, close } = await open_page(browser, url, look);
    await shows_map(page);
    for (const panel of PANELS) {
      await choose_panel(page, panel);
      await take(page, `panel_${panel}_${name}`);
    }
    await close();
  }
}

async function recording(run) {
  const serve = await start_serve([run]);
  for (const [name, look] of Object.entries({ light_desktop: LIGHT, dark_phone: DARK_PHONE })) {
    const { page, close } = await open_page(browser, serve.url, look);
    await until("the recording is shown", async () => (await view(page))?.tiles > 0);
    await take(page, `recording_${name}`);
    const end = Number(await page.locator("#timeline").getAttribute("max"));
    await page.locator("#timeline").fill(String(end / 3));
    await choose_panel(page, "log");
    await take(page, `recording_third_${name}`);
    await close();
  }
  await serve.end();
}

if (has("first-minute")) {
  await first_minute();
}
if (has("paced")) {
  await paced();
}
if (has("demo") || has("recording")) {
  const run = await demo_run();
  await recording(run);
}
if (has("panels")) {
  const demo = await start_demo(["--speed", "2"]);
  await sleep(15_000);
  await panels(demo.url);
  await demo.end();
}
await browser.close();
