// SPDX-License-Identifier: MIT
// Programs that a test starts: none of them outlives it.
import { spawn } from "node:child_process";
import { createWriteStream, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";

const POLL_MS = 5;
// The first ends a run, the next one the page that is still watched.
const QUIT_SIGNALS = 3;
const QUIT_WITHIN_MS = 2000;

export const sleep = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** CLOCK_MONOTONIC, as the duty log has it. */
export const now_us = () => Number(process.hrtime.bigint() / 1000n);

/** What `look` returns as soon as that is neither null, undefined nor false. */
export async function until(what, look, within_ms = 30_000) {
  const end_us = now_us() + 1000 * within_ms;
  for (;;) {
    const seen = await look();
    if (seen !== null && seen !== undefined && seen !== false) {
      return seen;
    }
    if (now_us() > end_us) {
      throw new Error(`not within ${within_ms / 1000} s: ${what}`);
    }
    await sleep(POLL_MS);
  }
}

const running = new Set();
process.on("exit", () => running.forEach((child) => child.kill("SIGKILL")));
for (const signal of ["SIGINT", "SIGTERM"]) {
  process.on(signal, () => process.exit(1));
}

/** A program with its output so far; all of it is in `log`, too. */
export class Program {
  output = "";
  #child;
  #ended = false;

  constructor(command, args, log, options = {}) {
    const file = createWriteStream(log);
    this.#child = spawn(command, args, { stdio: ["ignore", "pipe", "pipe"], ...options });
    running.add(this.#child);
    for (const stream of [this.#child.stdout, this.#child.stderr]) {
      stream.on("data", (bytes) => {
        this.output += bytes;
        file.write(bytes);
      });
    }
    this.#child.on("error", (error) => (this.output += `${command}: ${error.message}\n`));
    this.#child.on("close", () => {
      this.#ended = true;
      running.delete(this.#child);
      file.end();
    });
  }
  get pid() {
    return this.#child.pid;
  }
  get has_ended() {
    return this.#ended;
  }
  /** The match in what the program has said. */
  said(pattern, within_ms) {
    return until(`${pattern} in: ${this.output}`, () => {
      const match = pattern.exec(this.output);
      if (!match && this.#ended) {
        throw new Error(`ended without ${pattern}: ${this.output}`);
      }
      return match;
    }, within_ms);
  }
  signal(name) {
    this.#child.kill(name);
  }
  async end(signal = "SIGINT") {
    if (this.#ended) {
      return;
    }
    this.#child.kill("SIGCONT");
    for (let told = 0; told < QUIT_SIGNALS && !this.#ended; ++told) {
      this.#child.kill(signal);
      await until("the program ends", () => this.#ended, QUIT_WITHIN_MS).catch(() => {});
    }
    this.#child.kill("SIGKILL");
  }
}

/** A folder that is gone when this program ends. */
export function scratch_folder() {
  const folder = mkdtempSync(path.join(tmpdir(), "echomap-live-page-"));
  process.on("exit", () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}
