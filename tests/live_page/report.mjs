// SPDX-License-Identifier: MIT
// What a script has checked, as one JSON object on stdout for the test that runs it.

export class Report {
  #checks = {};

  /** `act` returns what it saw, and throws where something is wrong. */
  async check(name, act) {
    const begin_ms = performance.now();
    try {
      this.#checks[name] = { holds: true, seen: (await act()) ?? "" };
    } catch (error) {
      this.#checks[name] = { holds: false, seen: error.message };
    }
    const took_s = (performance.now() - begin_ms) / 1000;
    console.error(`${took_s.toFixed(1)} s ${name}: ${JSON.stringify(this.#checks[name])}`);
  }
  print() {
    console.log(JSON.stringify(this.#checks));
  }
}

export function require(holds, what) {
  if (!holds) {
    throw new Error(what);
  }
}

export function quantile(values, share) {
  const sorted = values.toSorted((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
}

export const median = (values) => quantile(values, 0.5);
