// SPDX-License-Identifier: MIT
import type {
  Hello,
  Message,
  Motion,
  Particles,
  Pose,
  Room,
  RunEvent,
  RunState,
  Tile,
  Trail,
} from '../protocol/messages';

const trailStepM = 0.02;
const seriesStepS = 1;

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
  room: Room | null;
  state: RunState | null;
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
    room: null,
    state: null,
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
      view.room = null;
      break;
  }
}

function applyMotion(view: View, motion: Motion, time: number): void {
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
