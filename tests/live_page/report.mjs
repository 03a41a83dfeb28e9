// SPDX-License-Identifier: MIT
// What a script has checked, as one JSON object on stdout for the test that runs it.

export class Report {
  #checks = {};

  /** `act` returns what it saw, and throws where something is wrong. */
  async check(name, act) {
    try {
      this.#checks[name] = { holds: true, seen: (await act()) ?? "" };
    } catch (error) {
      this.#checks[name] = { holds: false, seen: error.message };
    }
    console.error(`${name}: ${JSON.stringify(this.#checks[name])}`);
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
