// SPDX-License-Identifier: MIT
// Whether the wheels stop when nobody steers any more, in cycles of the robot's processor: the firmware
// runs in simavr at the pace of the wall clock, and a person drives by the page. What is timed is
// simulated time; the figures of the wall clock are those of ./run bench live_page.
//
// usage: node stop_checks.mjs
import { DrivenRobot, KEY, repeated, until_view } from "./driving.mjs";
import { stop_after } from "./duty_log.mjs";
import { now_us } from "./processes.mjs";
import { Report, median, require } from "./report.mjs";

const WITHIN_MS = 500;
const TRIALS = 3;
const LAG_MS = 3000;

const report = new Report();
const driven = await DrivenRobot.start();

async function check_stops(name, trial) {
  await report.check(name, async () => {
    const results = await repeated(TRIALS, trial);
    const times_ms = results.map(({ simulated_ms }) => Math.round(simulated_ms));
    require(median(times_ms) <= WITHIN_MS, `the wheels stopped after ${times_ms.join(", ")} simulated ms`);
    return `after ${times_ms.join(", ")} simulated ms`;
  });
}

async function check_lag(name, direction) {
  await report.check(name, async () => {
    const motions = await driven.late_motions(direction, LAG_MS);
    require(motions === 0, `the robot moved ${motions} times after it had stopped`);
    return "nothing that came late moved the robot";
  });
}

const { page, close } = await driven.open();
await check_stops("stop_button", () => driven.stop_by_click(page));
await check_stops("letting_go", () => driven.stop_by_letting_go(page));

async function stop_of_who_does_not_drive() {
  const other = await driven.open();
  try {
    await page.fill("input[type=text]", "Anna");
    await page.press("input[type=text]", "Tab");
    await driven.drive(page.keyboard);
    await page.getByText("You are driving").first().waitFor({ timeout: 10_000 });
    await other.page.getByText("Anna is driving").first().waitFor({ timeout: 10_000 });
    await other.page.keyboard.down(KEY);
    await other.page.locator(".banner", { hasText: "Anna is driving" }).waitFor({ timeout: 10_000 });
    await other.page.keyboard.up(KEY);
    require((await other.page.getByText("You are driving").count()) === 0, "two drive");
    const pressed_us = now_us();
    await other.page.keyboard.press("Escape");
    await stop_after(driven.duty_log, pressed_us);
    await until_view(other.page, "STOP of who does not drive is confirmed", ({ stop }) => stop === "confirmed");
  } finally {
    await driven.let_go(page.keyboard);
    await other.close();
  }
}

await report.check("second_driver", async () => {
  await repeated(1, stop_of_who_does_not_drive);
  return "sees who drives, does not steer, and can stop";
});
await check_stops("frozen_server", () => driven.stop_by_freezing(page));
await close();
await check_stops("closed_tab", () => driven.stop_by_closing());
await check_stops("cut_network", () => driven.stop_by_cutting_the_network());

const tab = await driven.open_visible_tab();
await check_stops("hidden_tab", async () => {
  const took = await driven.stop_by_hiding(tab);
  require(took.visibility === "hidden", `the tab is ${took.visibility}`);
  return took;
});
await tab.close();

await check_lag("commands_come_late", "to_server_ms");
await check_lag("what_is_seen_comes_late", "to_browser_ms");

await driven.end();
report.print();
