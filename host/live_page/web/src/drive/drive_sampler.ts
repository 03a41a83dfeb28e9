// SPDX-License-Identifier: MIT

export interface Steering {
  /** Shares of the robot's speeds, -1 .. 1; turns are counter-clockwise. */
  forward: number;
  turn: number;
}

export type DriveSource = 'keyboard' | 'joystick' | 'gamepad';

export interface DriveLine {
  /** False while bytes wait in the browser, or the socket is closed. */
  isReady(): boolean;
  /** Settles when the server has answered. Null where it could not be sent. */
  drive(steering: Steering): Promise<unknown> | null;
  release(): void;
}

const sampleEveryMs = 100;
const answerWithinMs = 250;
const standing: Steering = { forward: 0, turn: 0 };

/** Steers while something is held: at most one command is under way, and only the newest follows. */
export class DriveSampler {
  private readonly held = new Map<DriveSource, Steering>();
  /** Held when the robot was stopped: they have to let go before they steer again. */
  private readonly blocked = new Set<DriveSource>();
  /** A server whose robot was stopped wants to see the stick at rest before it steers again. */
  private owesZero = false;
  private timer: ReturnType<typeof setInterval> | null = null;
  private answerDue = 0;
  private flight = 0;
  private inFlight = false;
  private waits = false;

  constructor(
    private readonly line: DriveLine,
    private readonly now: () => number = () => performance.now(),
  ) {}

  get isDriving(): boolean {
    return this.timer !== null;
  }

  get steering(): Steering {
    return [...this.held.values()].at(-1) ?? standing;
  }

  /** Null lets go. */
  hold(source: DriveSource, steering: Steering | null): void {
    if (!steering) {
      this.blocked.delete(source);
      this.held.delete(source);
      if (this.held.size === 0 && this.isDriving) this.finish();
      return;
    }
    if (this.blocked.has(source)) return;
    this.held.delete(source);
    this.held.set(source, steering);
    if (this.timer === null) {
      if (this.owesZero) void this.line.drive(standing);
      this.owesZero = false;
      this.timer = setInterval(() => this.sample(), sampleEveryMs);
      this.sample();
    }
  }

  /** Lets go of everything at once: the page is hidden, or something else takes over. */
  abandon(): void {
    if (!this.isDriving) return;
    this.block();
    this.line.release();
  }

  /** Sends nothing more of what is held: the robot is stopped, or steering was refused. */
  drop(): void {
    if (!this.isDriving) return;
    this.block();
    this.owesZero = true;
  }

  private block(): void {
    for (const source of this.held.keys()) this.blocked.add(source);
    this.end();
  }

  private finish(): void {
    this.end();
    void this.line.drive(standing);
  }

  private end(): void {
    this.held.clear();
    if (this.timer !== null) clearInterval(this.timer);
    this.timer = null;
    this.waits = false;
    this.inFlight = false;
    this.flight += 1;
  }

  private sample(): void {
    if (this.inFlight && this.now() < this.answerDue) {
      this.waits = true;
      return;
    }
    if (!this.line.isReady()) return;
    const answer = this.line.drive(this.steering);
    if (!answer) return;
    const flight = ++this.flight;
    this.inFlight = true;
    this.waits = false;
    this.answerDue = this.now() + answerWithinMs;
    void answer.then(() => {
      if (flight !== this.flight) return;
      this.inFlight = false;
      if (this.waits) this.sample();
    });
  }
}
