// SPDX-License-Identifier: MIT
import {
  type Hello,
  type Message,
  type Motion,
  type Particles,
  PingOutcome,
  type Pose,
  type Room,
  type RunEvent,
  type RunState,
  type Team,
  type Tile,
  type Trail,
} from '../protocol/messages';

const trailStepM = 0.02;
const seriesStepS = 1;
const maxEchoes = 400;
const jumpM = 0.4;

/** A path that grows: x, y for each point. */
export type GrowingTrail = number[];

export interface TimedEvent extends RunEvent {
  time: number;
}

/** Values over time, of equal length. */
export interface Series {
  time: number[];
  distanceM: number[];
  headingRad: number[];
  roundTripMs: (number | null)[];
}

/** All that a run's messages up to an instant say. */
export interface View {
  time: number;
  hello: Hello | null;
  tiles: Map<string, Tile>;
  /** Changes with every tile. */
  tilesVersion: number;
  motion: Motion | null;
  particles: Particles | null;
  /** As the server last sent it. */
  trail: Trail | null;
  /** Estimated poses since then. */
  trailSince: GrowingTrail;
  odometryTrail: GrowingTrail;
  truthTrail: GrowingTrail;
  /** Of the newest echoes x, y, on the axis of their beams. */
  echoes: number[];
  room: Room | null;
  state: RunState | null;
  /** Of a fleet; null for a robot alone. */
  team: Team | null;
  events: TimedEvent[];
  series: Series;
}

let lastTilesVersion = 0;

export function emptyView(): View {
  return {
    time: 0,
    hello: null,
    tiles: new Map(),
    tilesVersion: ++lastTilesVersion,
    motion: null,
    particles: null,
    trail: null,
    trailSince: [],
    odometryTrail: [],
    truthTrail: [],
    echoes: [],
    room: null,
    state: null,
    team: null,
    events: [],
    series: { time: [], distanceM: [], headingRad: [], roundTripMs: [] },
  };
}

/** A view that further messages do not change. */
export function cloneView(view: View): View {
  return {
    ...view,
    tiles: new Map(view.tiles),
    trailSince: view.trailSince.slice(),
    odometryTrail: view.odometryTrail.slice(),
    truthTrail: view.truthTrail.slice(),
    echoes: view.echoes.slice(),
    events: view.events.slice(),
    series: {
      time: view.series.time.slice(),
      distanceM: view.series.distanceM.slice(),
      headingRad: view.series.headingRad.slice(),
      roundTripMs: view.series.roundTripMs.slice(),
    },
  };
}

/** Brings the view up to the message: the one way, for live and recorded runs alike. */
export function apply(view: View, message: Message): void {
  view.time = Math.max(view.time, message.time);
  switch (message.kind) {
    case 'hello':
      view.hello = message.hello;
      break;
    case 'tile':
      view.tiles.set(`${message.tile.x},${message.tile.y}`, message.tile);
      view.tilesVersion = ++lastTilesVersion;
      break;
    case 'motion':
      applyMotion(view, message.motion, message.time);
      break;
    case 'particles':
      view.particles = message.particles;
      break;
    case 'trail':
      view.trail = message.trail;
      view.trailSince = [];
      break;
    case 'room':
      view.room = message.room;
      break;
    case 'state':
      view.state = message.state;
      break;
    case 'team':
      view.team = message.team;
      break;
    case 'event':
      view.events.push({ ...message.event, time: message.time });
      break;
    case 'newMap':
      view.tiles = new Map();
      view.tilesVersion = ++lastTilesVersion;
      view.particles = null;
      view.trail = null;
      view.trailSince = [];
      view.odometryTrail = [];
      view.truthTrail = [];
      view.echoes = [];
      view.room = null;
      break;
  }
}

function applyMotion(view: View, motion: Motion, time: number): void {
  const before = view.motion?.pose;
  // It has found itself elsewhere: what it heard was not there.
  if (before && Math.hypot(motion.pose.x - before.x, motion.pose.y - before.y) > jumpM) view.echoes = [];
  if (motion.ping.number !== view.motion?.ping.number) addEcho(view, motion);
  view.motion = motion;
  extend(view.trailSince, motion.pose);
  extend(view.odometryTrail, motion.odometry);
  if (motion.truth) extend(view.truthTrail, motion.truth);
  const { series } = view;
  const previous = series.time.at(-1);
  if (previous === undefined || time >= previous + seriesStepS) {
    series.time.push(time);
    series.distanceM.push(Math.hypot(motion.odometry.x - motion.pose.x, motion.odometry.y - motion.pose.y));
    series.headingRad.push(Math.abs(wrapAngle(motion.odometry.heading - motion.pose.heading)));
    series.roundTripMs.push(view.state?.link?.round_trip_ms ?? null);
  }
}

function addEcho({ hello, echoes }: View, { pose, ping }: Motion): void {
  const sonar = hello?.sonar;
  if (!sonar || ping.range === null || ping.outcome !== PingOutcome.echo || !Number.isFinite(pose.x)) return;
  const cos = Math.cos(pose.heading);
  const sin = Math.sin(pose.heading);
  const beam = pose.heading + ping.bearing;
  echoes.push(
    pose.x + cos * sonar.x_m - sin * sonar.y_m + ping.range * Math.cos(beam),
    pose.y + sin * sonar.x_m + cos * sonar.y_m + ping.range * Math.sin(beam),
  );
  if (echoes.length > 2 * maxEchoes) echoes.splice(0, 2);
}

function extend(trail: GrowingTrail, pose: Pose): void {
  const x = trail.at(-2);
  const y = trail.at(-1);
  if (x === undefined || y === undefined || Math.hypot(pose.x - x, pose.y - y) >= trailStepM) {
    trail.push(pose.x, pose.y);
  }
}

/** The same angle in -pi .. pi. */
export function wrapAngle(angle: number): number {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}
