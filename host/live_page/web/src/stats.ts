// SPDX-License-Identifier: MIT

const stored = 1000;

/** What the page measures of itself; tests read it. */
export class Stats {
  readonly drawMs: number[] = [];
  /** From the server's clock in a motion until it was drawn. */
  readonly latencyMs: number[] = [];
  /** Since navigation started. */
  firstMapMs: number | null = null;
  messages = 0;
  /** Motions that a newer one replaced before they were drawn. */
  dropped = 0;
  private motionWaits = false;

  addMotion(): void {
    if (this.motionWaits) this.dropped += 1;
    this.motionWaits = true;
  }
  addDrawnMotion(): void {
    this.motionWaits = false;
  }
  addDraw(ms: number): void {
    push(this.drawMs, ms);
  }
  addLatency(ms: number): void {
    push(this.latencyMs, ms);
  }
}

function push(values: number[], value: number): void {
  values.push(value);
  if (values.length > stored) values.shift();
}
