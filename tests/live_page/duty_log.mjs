// SPDX-License-Identifier: MIT
// When the emulated robot's wheels were driven, by the file of --duty-log.
import { readFileSync } from "node:fs";

import { until } from "./processes.mjs";

/** Lines that are complete, each with simulated time, CLOCK_MONOTONIC and both duties. */
export function read_duties(file) {
  const lines = readFileSync(file, "utf8").split("\n").slice(1, -1);
  return lines.map((line) => {
    const [sim_us, monotonic_us, left, right] = line.split(",").map(Number);
    return { sim_us, monotonic_us, drives: left !== 0 || right !== 0 };
  });
}

export function wheels_are_driven(file) {
  return read_duties(file).at(-1)?.drives ?? false;
}

/**
 * How long the wheels went on after that instant (CLOCK_MONOTONIC), at which they were driven. In
 * simulated time the instant is where it lies between the entries around it: the robot's clock goes
 * at the wall's pace, but not where the machine is too slow for that.
 */
export async function stop_after(file, event_us, within_ms = 5000) {
  const before = read_duties(file).findLast(({ monotonic_us }) => monotonic_us < event_us);
  if (!before?.drives) {
    throw new NotDriven();
  }
  const end = await until("the wheels stand", () => {
    return read_duties(file).find(({ monotonic_us, drives }) => monotonic_us >= event_us && !drives);
  }, within_ms);
  const wall_us = end.monotonic_us - event_us;
  const pace = (end.sim_us - before.sim_us) / (end.monotonic_us - before.monotonic_us);
  return { wall_ms: wall_us / 1000, simulated_ms: (wall_us * pace) / 1000 };
}

/** A browser that got no processor for 250 ms has let the robot stop before it was told to. */
export class NotDriven extends Error {
  constructor() {
    super("the wheels were not driven at that instant");
  }
}
