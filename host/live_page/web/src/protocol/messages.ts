// SPDX-License-Identifier: MIT
// What the server sends: docs/live_protocol.md.

export type Point = [number, number];

export interface Pose {
  x: number;
  y: number;
  heading: number;
}

export interface Covariance {
  xx: number;
  xy: number;
  yy: number;
}

export interface Hello {
  version: string;
  run: string;
  name: string;
  command: string;
  live: boolean;
  robot: string;
  radius_m: number;
  resolution_m: number;
  step_logits: number;
  free_below: number;
  occupied_above: number;
  sonar: { x_m: number; y_m: number; half_angle_rad: number; max_range_m: number } | null;
  can: string[];
  has_truth: boolean;
}

export const tileCells = 64;

export interface Tile {
  x: number;
  y: number;
  /** 64 x 64, row by row upwards; 0: no evidence. */
  cells: Uint8Array;
}

export const enum PingOutcome {
  none = 0,
  echo = 1,
  silence = 2,
  noAnswer = 3,
}

export interface Motion {
  clockMs: number;
  pose: Pose;
  /** Null where the position is unknown. */
  covariance: Covariance | null;
  headingStddev: number | null;
  odometry: Pose;
  truth: Pose | null;
  ping: { bearing: number; range: number | null; number: number; outcome: PingOutcome };
}

export interface Choice {
  at: Point;
  gain_m2: number;
  cost_m: number;
  chosen: boolean;
}

export interface Hypothesis extends Pose, Covariance {
  probability: number;
}

export interface LinkState {
  state: string | null;
  round_trip_ms: number | null;
  frames_lost: number | null;
  frames_bad: number | null;
  resets: number | null;
  outages: number | null;
  frames_per_s: number | null;
  battery_v: number | null;
}

export interface Score {
  free_iou: number | null;
  wall_rmse_m: number | null;
  solid_called_free: number | null;
  objects_found: number | null;
  pose_error_m: number | null;
}

export interface RunState {
  mode: string | null;
  driver: { client: number; name: string } | null;
  clients: number | null;
  speed: number | null;
  why: { code: string | null; goal: Point | null; gain_m2: number | null; choices: Choice[] | null } | null;
  stops: number | null;
  floor_m2: number | null;
  coverage: number | null;
  unseen_m2: number | null;
  travelled_m: number | null;
  left_s: number | null;
  link: LinkState | null;
  localization: { status: string | null; lost_probability: number | null; hypotheses: Hypothesis[] | null } | null;
  stopped: { code: string; text: string } | null;
  score: Score | null;
  result: { finished: boolean; why: string | null; next: string | null } | null;
}

export interface Sweep {
  origin: [number, number, number];
  bearings: number[];
  ranges_m: (number | null)[];
}

export interface Room {
  walls: Point[][] | null;
  outline: Point[] | null;
  cylinders: { at: Point; radius_m: number }[] | null;
  sweep: Sweep | null;
}

export interface RunEvent {
  code: string;
  level: 'info' | 'warning' | 'error';
  text: string;
  cause: string | null;
  remedy: string | null;
}

export type Presence = 'alive' | 'left' | 'gone';

/** Of a fleet; pose and claim are null where its map is not joined to the one that is shown. */
export interface TeamRobot {
  name: string;
  presence: Presence;
  radius_m: number;
  stops: number;
  pose: Pose | null;
  /** x, y for each point. */
  trail: number[];
  claim: Point | null;
}

/** The probability of each cell, 0 to 255 for the highest of all, row by row upwards. */
export interface TeamField {
  origin: Point;
  resolution_m: number;
  columns: number;
  cells: number[];
}

export interface TeamSource {
  verdict: string;
  at: Point | null;
  radius_m: number;
  none_probability: number;
  field: TeamField | null;
}

export interface Team {
  robots: TeamRobot[];
  source: TeamSource | null;
}

/** For each particle x, y, heading, weight. */
export type Particles = Float32Array;
/** For each point x, y. */
export type Trail = Float32Array;

export type Message =
  | { kind: 'hello'; time: number; hello: Hello }
  | { kind: 'tile'; time: number; tile: Tile }
  | { kind: 'motion'; time: number; motion: Motion }
  | { kind: 'particles'; time: number; particles: Particles }
  | { kind: 'trail'; time: number; trail: Trail }
  | { kind: 'room'; time: number; room: Room }
  | { kind: 'state'; time: number; state: RunState }
  | { kind: 'event'; time: number; event: RunEvent }
  | { kind: 'newMap'; time: number }
  | { kind: 'team'; time: number; team: Team };
