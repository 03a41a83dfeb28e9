// SPDX-License-Identifier: MIT
// A robot in the mock room: it wanders or is driven, and says so in messages.
import * as encode from './mock_encode.mjs';
import { MockRoom } from './mock_room.mjs';

const tickS = 0.05;
const sonarRangeM = 3;
const speedMps = 0.25;
const turnRps = 1.2;

export class MockRun {
  constructor({ cells = 200, particles = 5000, filled = false } = {}) {
    this.room = new MockRoom(cells, 0.05);
    if (filled) this.room.fill();
    this.particleCount = particles;
    this.time = 0;
    this.ticks = 0;
    this.pose = [-1, -1, 0.4];
    this.odometry = [-1, -1, 0.4];
    this.trail = [];
    this.mode = 'explore';
    this.why = 'frontier';
    this.stopped = null;
    this.goal = null;
    this.drive = null;
    this.driver = null;
    this.speed = 1;
    this.clients = 0;
    this.cutUntil = 0;
    this.uncertainty = 0.02;
    this.ping = { bearing: 0, range: NaN, number: 0, outcome: 0 };
    this.history = [];
    this.newest = new Map();
    this.onMessage = () => {};
  }

  hello(live) {
    return {
      version: '0.1.0', run: '0', name: 'first_map', command: 'demo', live, robot: 'uno_2wd',
      radius_m: 0.11, resolution_m: 0.05, step_logits: 0.05, free_below: 0.196, occupied_above: 0.65,
      sonar: { x_m: 0.05, y_m: 0, half_angle_rad: 0.26, max_range_m: sonarRangeM },
      can: ['stop', 'drive', 'go', 'explore', 'moved', 'pose', 'speed', 'carry-off', 'box', 'cut-cable'],
      has_truth: true,
    };
  }

  send(kind, key, bytes) {
    const isState = kind !== 8 && kind !== 9;
    if (isState) this.newest.set(`${kind} ${key}`, bytes);
    const isThinned = (kind === 3 && this.ticks % 2 !== 0) || (kind === 4 && this.ticks % 20 !== 0);
    if (!isThinned) this.history.push(bytes);
    this.onMessage(bytes);
  }

  begin(live = true) {
    this.send(1, '', encode.hello(this.time, this.hello(live)));
    for (const tile of this.room.dirty) this.send(2, `${tile.x},${tile.y}`, encode.tile(this.time, tile.x, tile.y, tile.cells));
    this.room.dirty.clear();
    this.tell('link-ready', 'info', 'the robot answers');
  }

  tell(code, level, text, cause = null, remedy = null) {
    this.send(8, '', encode.event(this.time, { code, level, text, cause, remedy }));
  }

  snapshot() {
    const order = [1, 2, 5, 6, 4, 7, 3];
    return order.flatMap((kind) => [...this.newest].filter(([key]) => key.startsWith(`${kind} `)).map(([, bytes]) => bytes));
  }

  tick() {
    this.time += tickS;
    this.ticks += 1;
    const isCut = this.time < this.cutUntil;
    if (!isCut) this.move();
    if (!isCut && this.ticks % 2 === 0) this.sound();
    for (const tile of this.room.dirty) this.send(2, `${tile.x},${tile.y}`, encode.tile(this.time, tile.x, tile.y, tile.cells));
    this.room.dirty.clear();
    if (this.ticks % 4 === 0) this.send(4, '', encode.particles(this.time, this.particles()));
    if (this.ticks % 100 === 0) this.send(5, '', encode.trail(this.time, this.trail));
    if (this.ticks % 60 === 1) this.send(6, '', encode.room(this.time, this.roomState()));
    if (this.ticks % 600 === 0) this.tell('bumped', 'info', 'it touched something, which is now in the map', 'too low, too thin or too soft for the sonar');
    if (this.ticks % 5 === 0) this.sendState(isCut);
    this.sendMotion();
  }

  sendMotion() {
    const spread = this.uncertainty ** 2;
    const unknown = this.uncertainty > 1;
    this.send(3, '', encode.motion(this.time, {
      clockMs: performance.now(),
      pose: this.pose,
      covariance: unknown ? [NaN, NaN, NaN] : [spread, spread * 0.4, spread * 0.6],
      headingStddev: 0.03,
      odometry: this.odometry,
      truth: [this.pose[0] + 0.03, this.pose[1] - 0.02, this.pose[2] + 0.02],
      ping: this.ping,
    }));
  }

  move() {
    let forward = 0;
    let turn = 0;
    if (this.mode === 'explore' || this.mode === 'go') {
      const ahead = this.room.range(this.pose[0], this.pose[1], this.pose[2]);
      const toGoal = this.goal && Math.atan2(this.goal[1] - this.pose[1], this.goal[0] - this.pose[0]) - this.pose[2];
      if (this.mode === 'go' && Math.hypot(this.goal[0] - this.pose[0], this.goal[1] - this.pose[1]) < 0.1) {
        this.mode = 'stopped';
        this.stopped = { code: 'arrived', text: 'it is where it was sent' };
        this.goal = null;
      } else if (this.mode === 'go') {
        turn = Math.max(-1, Math.min(1, 2 * Math.atan2(Math.sin(toGoal), Math.cos(toGoal))));
        forward = Math.abs(turn) < 0.5 ? 1 : 0;
      } else {
        turn = ahead < 0.6 ? 1 : Math.sin(this.time * 0.31) * 0.5;
        forward = ahead < 0.35 ? 0 : 1;
      }
    } else if (this.mode === 'drive' && this.drive) {
      ({ forward, turn } = this.drive);
      if (this.room.range(this.pose[0], this.pose[1], this.pose[2]) < 0.15 && forward > 0) {
        this.halt('bumped', 'the bumper touched something');
        forward = 0;
      }
    }
    const step = forward * speedMps * tickS;
    this.pose[2] += turn * turnRps * tickS;
    this.pose[0] += Math.cos(this.pose[2]) * step;
    this.pose[1] += Math.sin(this.pose[2]) * step;
    this.odometry[2] += turn * turnRps * tickS * 1.03;
    this.odometry[0] += Math.cos(this.odometry[2]) * step * 1.02;
    this.odometry[1] += Math.sin(this.odometry[2]) * step * 1.02;
    if (step !== 0) this.trail.push(this.pose[0], this.pose[1]);
    this.uncertainty = Math.min(2, Math.max(0.02, this.uncertainty * (this.uncertainty > 0.3 ? 0.99 : 1)));
  }

  halt(code, text) {
    this.mode = 'stopped';
    this.drive = null;
    this.stopped = { code, text };
    this.tell(code, 'warning', text);
  }

  sound() {
    const { number } = this.ping;
    const bearing = Math.sin(this.ticks * 0.06) * 1.4;
    const [x, y, heading] = this.pose;
    let range = null;
    for (let ray = -6; ray <= 6; ++ray) {
      const hit = this.room.addRay(x, y, heading + bearing + ray * 0.04, sonarRangeM);
      if (hit !== null && (range === null || hit < range)) range = hit;
    }
    const noAnswer = number % 23 === 22;
    this.ping = {
      bearing,
      range: noAnswer || range === null ? NaN : range,
      number: number + 1,
      outcome: noAnswer ? 3 : range === null ? 2 : 1,
    };
  }

  particles() {
    const values = [];
    const spread = Math.min(this.room.size / 3, 0.04 + this.uncertainty * 2);
    for (let index = 0; index < this.particleCount; ++index) {
      const radius = spread * Math.sqrt(-Math.log(Math.random() + 1e-9));
      const angle = Math.random() * 2 * Math.PI;
      const weight = Math.exp(-((radius / spread) ** 2)) / this.particleCount;
      values.push(this.pose[0] + radius * Math.cos(angle), this.pose[1] + radius * Math.sin(angle), this.pose[2], weight);
    }
    return values;
  }

  roomState() {
    const bearings = Array.from({ length: 72 }, (_, index) => (index / 72) * 2 * Math.PI - Math.PI);
    const ranges = bearings.map((bearing) => this.room.range(this.pose[0], this.pose[1], bearing));
    return {
      walls: this.room.outline.slice(0, 4).map((from, index) => [from, this.room.outline[index + 1]]),
      outline: this.room.outline,
      cylinders: this.room.pillars,
      sweep: { origin: [...this.pose], bearings, ranges_m: ranges.map((range) => (range < sonarRangeM ? range : null)) },
    };
  }

  sendState(isCut) {
    const coverage = Math.min(0.97, this.time / 120);
    const edge = this.room.size * 0.4;
    const choices = [
      { at: [edge * 0.7, -edge * 0.7], gain_m2: 1.7, cost_m: 1.2, chosen: true },
      { at: [-edge * 0.7, edge * 0.8], gain_m2: 0.9, cost_m: 2.2, chosen: false },
      { at: [edge * 0.2, edge * 0.7], gain_m2: 0.4, cost_m: 0.6, chosen: false },
    ];
    const isLost = this.uncertainty > 0.3;
    const hypotheses = isLost
      ? [0.7, 0.2, 0.1].map((probability, index) => ({
          x: this.pose[0] + index * 0.8, y: this.pose[1] - index * 0.5, heading: this.pose[2] + index, probability, xx: 0.02, xy: 0.005, yy: 0.01,
        }))
      : [];
    this.send(7, '', encode.state(this.time, {
      mode: isCut ? 'lost-link' : this.mode,
      driver: this.driver && { client: this.driver.number, name: this.driver.name },
      clients: this.clients,
      speed: this.speed,
      why: this.mode === 'explore' ? { code: this.why, goal: choices[0].at, gain_m2: 1.7, choices } : this.goal ? { code: 'operator', goal: this.goal, gain_m2: null, choices: [] } : null,
      stops: Math.floor(this.time / 8), floor_m2: 12.3 * coverage, coverage, unseen_m2: 12.3 * (1 - coverage),
      travelled_m: this.trail.length * 0.0125, left_s: Math.max(0, 120 - this.time),
      link: { state: isCut ? 'lost' : 'ready', round_trip_ms: 3 + 2 * Math.sin(this.time), frames_lost: 2, frames_bad: 1, resets: 0, outages: 0, frames_per_s: 48, battery_v: 7.4 },
      localization: { status: isLost ? 'lost' : 'localized', lost_probability: isLost ? 0.8 : 0.02, hypotheses },
      stopped: this.stopped,
      score: { free_iou: 0.5 + coverage * 0.45, wall_rmse_m: 0.02, solid_called_free: 0.01, objects_found: 0.9, pose_error_m: 0.036 },
      result: this.result ?? null,
    }));
  }

  /** A refusal, or null. */
  take(command, client) {
    switch (command.do) {
      case 'stop':
        this.halt('stop', 'STOP was pressed');
        return null;
      case 'drive':
        if (!(performance.now() - command.seen < 400)) return { code: 'stale', why: 'what you saw is too old' };
        if (this.driver && this.driver !== client) return { code: 'not-driver', why: `${this.driver.name} is driving` };
        this.driver = client;
        this.mode = 'drive';
        this.stopped = null;
        this.drive = { forward: command.forward, turn: command.turn };
        clearTimeout(this.deadMan);
        clearTimeout(this.lockTimer);
        this.deadMan = setTimeout(() => {
          if (this.drive && (this.drive.forward || this.drive.turn)) this.halt('driver-silent', 'nothing came from the driver');
          this.drive = null;
        }, 250);
        this.lockTimer = setTimeout(() => (this.driver = null), 2000);
        return null;
      case 'release':
        if (this.driver === client) this.driver = null;
        this.drive = null;
        return null;
      case 'explore':
        this.mode = 'explore';
        this.stopped = null;
        return null;
      case 'go':
        if (Math.abs(command.x) > this.room.size / 2) return { code: 'not-possible', why: 'there is no floor' };
        this.mode = 'go';
        this.stopped = null;
        this.goal = [command.x, command.y];
        return null;
      case 'moved':
      case 'carry-off':
        this.uncertainty = 1.2;
        this.tell('carried-off', 'info', 'somebody carries the robot off');
        return null;
      case 'pose':
        this.pose = [command.x, command.y, command.heading];
        this.uncertainty = 0.1;
        return null;
      case 'speed':
        this.speed = command.factor;
        return null;
      case 'box':
        this.room.pillars.push({ at: [command.x, command.y], radius_m: 0.15 });
        return null;
      case 'cut-cable':
        this.cutUntil = this.time + command.seconds;
        return null;
      default:
        return { code: 'unknown', why: `no command ${command.do}` };
    }
  }

  leave(client) {
    if (this.driver !== client) return;
    this.driver = null;
    if (this.drive) this.halt('driver-gone', 'the driver has gone');
  }
}
