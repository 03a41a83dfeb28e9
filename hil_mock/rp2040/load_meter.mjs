// SPDX-License-Identifier: MIT
// How much of the chip is busy, and how punctual its tick is.
const kTickException = 16; // Alarm 0 of TIMER.
const kTickNs = 1e6;

export class LoadMeter {
  constructor(nowNs) {
    this.sinceNs = nowNs;
    this.sleptNs = 0;
    this.firstTickNs = undefined;
    this.earliestNs = 0;
    this.latestNs = 0;
  }

  sleep(ns) {
    this.sleptNs += ns;
  }

  /** An exception is entered; ticks are held against a grid of a millisecond through the first. */
  enter(exception, nowNs) {
    if (exception !== kTickException) {
      return;
    }
    this.firstTickNs ??= nowNs;
    const late = nowNs - this.firstTickNs;
    const offGrid = late - Math.round(late / kTickNs) * kTickNs;
    this.earliestNs = Math.min(this.earliestNs, offGrid);
    this.latestNs = Math.max(this.latestNs, offGrid);
  }

  busyShare(nowNs) {
    return 1 - this.sleptNs / (nowNs - this.sinceNs);
  }

  get tickJitterNs() {
    return this.latestNs - this.earliestNs;
  }
}
