// SPDX-License-Identifier: MIT
// Emulated robots whose runs are served, at the usual programs of the folder ECHOMAP_PROGRAMS.
import { readFileSync } from "node:fs";
import path from "node:path";

import { Program, scratch_folder } from "./processes.mjs";

const programs = process.env.ECHOMAP_PROGRAMS ?? "build/release/bin";
const LISTENS = /live page: (http:\/\/\S+)/;

function program(name, args, log) {
  return new Program(path.join(programs, name), args, log);
}

/** `echomap demo` in lockstep. */
export async function start_demo(args = []) {
  const folder = scratch_folder();
  const demo = program(
    "echomap",
    ["demo", "--emulator", "mock", "--seed", "1", "--no-browser", "--view", "none"]
      .concat(["--out", path.join(folder, "run")], args.includes("--listen") ? [] : ["--listen", "127.0.0.1:0"], args),
    path.join(folder, "demo.log"),
  );
  const [, url] = await demo.said(LISTENS);
  return { url, folder, echomap: demo, end: () => demo.end() };
}

/** Runs that have ended. */
export async function start_serve(runs, args = []) {
  const folder = scratch_folder();
  const serve = program(
    "echomap",
    ["serve", "--no-browser", "--listen", "127.0.0.1:0", ...args, ...runs],
    path.join(folder, "serve.log"),
  );
  const [, url] = await serve.said(LISTENS);
  return { url, echomap: serve, end: () => serve.end() };
}

/** A large map and many particles that no robot has made. */
export async function start_synthetic_run() {
  const folder = scratch_folder();
  const run = program("synthetic_run", [], path.join(folder, "synthetic.log"));
  const [, url] = await run.said(LISTENS);
  return { url, echomap: run, end: () => run.end() };
}

/**
 * The Uno's firmware in cycles of the AVR, at the pace of the wall clock, and `echomap explore` that
 * drives it as it drives a robot at a cable.
 */
export async function start_paced_robot(args = []) {
  const folder = scratch_folder();
  const port = path.join(folder, "pty");
  const duty_log = path.join(folder, "duty.csv");
  const emulator = program("echomap-simavr", ["--link", port, "--duty-log", duty_log], path.join(folder, "simavr.log"));
  await emulator.said(/listens on/);
  const echomap = program(
    "echomap",
    ["explore", "--live", "--no-browser", "--view", "none", "--port", port, "--out", path.join(folder, "run"), ...args],
    path.join(folder, "explore.log"),
  );
  const [, url] = await echomap.said(LISTENS);
  const end = async () => {
    await echomap.end();
    await emulator.end("SIGTERM");
  };
  return { url, folder, duty_log, echomap, end };
}

/** Memory of a process that is in use, MB. */
export function memory_mb(pid) {
  const [, kb] = /VmRSS:\s+(\d+) kB/.exec(readFileSync(`/proc/${pid}/status`, "utf8"));
  return Number(kb) / 1024;
}
