// SPDX-License-Identifier: MIT

const storedPings = 20;

/** How the server's clock and this page's clock differ, by the fastest of the newest pings. */
export class ServerClock {
  private pings: { roundTripMs: number; offsetMs: number }[] = [];
  /** The server's clock, of the newest motion or pong; 0 before the first. */
  seenMs = 0;

  addPong(sentMs: number, receivedMs: number, serverMs: number): void {
    const roundTripMs = receivedMs - sentMs;
    this.pings.push({ roundTripMs, offsetMs: serverMs - (sentMs + receivedMs) / 2 });
    if (this.pings.length > storedPings) this.pings.shift();
    this.see(serverMs);
  }

  see(serverMs: number): void {
    this.seenMs = Math.max(this.seenMs, serverMs);
  }

  get roundTripMs(): number | null {
    return this.pings.at(-1)?.roundTripMs ?? null;
  }

  /** How long ago the server's clock read that; null before the first ping. */
  ageMs(serverMs: number, nowMs: number): number | null {
    const fastest = this.pings.reduce<{ roundTripMs: number; offsetMs: number } | null>(
      (best, ping) => (best && best.roundTripMs <= ping.roundTripMs ? best : ping),
      null,
    );
    return fastest && nowMs + fastest.offsetMs - serverMs;
  }

  reset(): void {
    this.pings = [];
    this.seenMs = 0;
  }
}
