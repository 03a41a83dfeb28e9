// SPDX-License-Identifier: MIT

export const layerNames = [
  'grid',
  'walls',
  'trail',
  'odometry',
  'truth',
  'sonar',
  'choices',
  'hypotheses',
  'particles',
  'team',
  'source',
] as const;

export type LayerName = (typeof layerNames)[number];
export type Layers = Record<LayerName, boolean>;

export const defaultLayers: Layers = {
  grid: true,
  walls: true,
  trail: true,
  odometry: false,
  truth: false,
  sonar: true,
  choices: true,
  hypotheses: true,
  particles: true,
  team: true,
  source: true,
};
