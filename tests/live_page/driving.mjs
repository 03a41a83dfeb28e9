// SPDX-License-Identifier: MIT
// A person who drives the robot by the page, and what stops it. Each of these drives first, and returns
// how long the wheels then went on.
import { open_page, shows_map, start_browser, view } from "./browser.mjs";
import { NotDriven, read_duties, stop_after, wheels_are_driven } from "./duty_log.mjs";
import { now_us, sleep, until } from "./processes.mjs";
import { require } from "./report.mjs";
import { start_paced_robot } from "./robots.mjs";
import { SlowCable } from "./slow_cable.mjs";
import { VisibleTab } from "./visible_tab.mjs";

// It turns on the spot: nothing is in its way.
export const KEY = "KeyA";
// The lock of a page that is gone is free after 2 s; who was refused until then has to press anew.
const REFUSED_MS = 2500;
const MAX_PRESSES = 8;
const MAX_TRIALS = 3;
// Steering is under way, not just begun.
const DRIVES_MS = 400;
// Until an emulated robot has said that it stands, and whoever drove it is forgotten.
const RESTS_MS = 300;
const STANDS_WITHIN_MS = 1000;

/** A paced robot, a browser, and the cable between them. */
export class DrivenRobot {
  static async start() {
    const driven = new DrivenRobot();
    driven.robot = await start_paced_robot(["--listen", "127.0.0.2:0"]);
    driven.port = Number(new URL(driven.robot.url).port);
    driven.cable = new SlowCable(driven.port, "127.0.0.2");
    await driven.cable.listen(driven.port);
    driven.url = `http://127.0.0.1:${driven.port}/`;
    driven.browser = await start_browser();
    return driven;
  }
  get duty_log() {
    return this.robot.duty_log;
  }
  async end() {
    await this.browser.close();
    this.cable.close();
    await this.robot.end();
  }
  async open() {
    const opened = await open_page(this.browser, this.url);
    await shows_map(opened.page);
    return opened;
  }
  /** Until the wheels are driven by a key that stays pressed. */
  async drive(keyboard) {
    await until("the robot stands", () => !wheels_are_driven(this.duty_log));
    for (let presses = 0; !wheels_are_driven(this.duty_log); ++presses) {
      require(presses < MAX_PRESSES, "the wheels do not turn while a key is held");
      await keyboard.up(KEY);
      await keyboard.down(KEY);
      await until("the wheels are driven", () => wheels_are_driven(this.duty_log), REFUSED_MS).catch(() => {});
    }
    await sleep(DRIVES_MS);
  }
  async let_go(keyboard) {
    await keyboard.up(KEY);
    await sleep(RESTS_MS);
  }

  async stop_by_click(page) {
    await this.drive(page.keyboard);
    const { x, y, width, height } = await page.locator("#stop").boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    const event_us = now_us();
    await page.mouse.down();
    const took = await stop_after(this.duty_log, event_us);
    await page.mouse.up();
    await this.let_go(page.keyboard);
    return took;
  }
  async stop_by_letting_go(page) {
    await this.drive(page.keyboard);
    const event_us = now_us();
    await page.keyboard.up(KEY);
    return stop_after(this.duty_log, event_us);
  }
  async stop_by_hiding(tab) {
    await this.drive(tab.keyboard);
    const event_us = now_us();
    await tab.cover();
    const took = await stop_after(this.duty_log, event_us);
    const visibility = await tab.value_of("document.visibilityState");
    await tab.show();
    await this.let_go(tab.keyboard);
    return { ...took, visibility };
  }
  async stop_by_closing() {
    const { page, close } = await this.open();
    await this.drive(page.keyboard);
    const event_us = now_us();
    const closed = page.close();
    const took = await stop_after(this.duty_log, event_us);
    await closed;
    await close();
    return took;
  }
  /** The firmware alone is left. */
  async stop_by_freezing(page) {
    await this.drive(page.keyboard);
    const event_us = now_us();
    this.robot.echomap.signal("SIGSTOP");
    try {
      return await stop_after(this.duty_log, event_us);
    } finally {
      await this.let_go(page.keyboard);
      this.robot.echomap.signal("SIGCONT");
    }
  }
  async stop_by_cutting_the_network() {
    const { page, close } = await this.open();
    await this.drive(page.keyboard);
    const event_us = now_us();
    this.cable.cut();
    try {
      return await stop_after(this.duty_log, event_us);
    } finally {
      await close();
      this.cable.mend();
    }
  }
  /**
   * Somebody drives, the network gets slow in that direction, he steers on for a second and lets go.
   * How often the wheels began to turn once they had come to a stop.
   */
  async late_motions(direction, lag_ms) {
    const { page, close } = await this.open();
    try {
      await this.drive(page.keyboard);
      this.cable[direction] = lag_ms;
      await sleep(1000);
      await until("the wheels stand", () => !wheels_are_driven(this.duty_log), STANDS_WITHIN_MS);
      const stood_us = now_us();
      await page.keyboard.up(KEY);
      await sleep(lag_ms + 1000);
      return read_duties(this.duty_log).filter(({ monotonic_us, drives }) => drives && monotonic_us > stood_us).length;
    } finally {
      this.cable[direction] = 0;
      await close();
    }
  }
  async open_visible_tab() {
    const tab = await VisibleTab.open(this.url);
    await until("the tab shows a map", () => tab.value_of("globalThis.__echomap?.stats().firstMapMs > 0"));
    return tab;
  }
}

/** So many results of a trial, without those in which the robot had stopped before. */
export async function repeated(times, trial) {
  const results = [];
  for (let trials = 0; results.length < times; ++trials) {
    try {
      results.push(await trial());
    } catch (error) {
      if (!(error instanceof NotDriven) || trials >= MAX_TRIALS * times) {
        throw error;
      }
    }
  }
  return results;
}

/** What the page says of the run, as soon as that holds. */
export const until_view = (page, what, holds) =>
  until(what, async () => {
    const seen = await view(page);
    return seen && holds(seen) && seen;
  });
