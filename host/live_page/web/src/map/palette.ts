// SPDX-License-Identifier: MIT
// Okabe and Ito's colours, which colour-blind people tell apart.

export type Theme = 'light' | 'dark';
type Rgb = readonly [number, number, number];

export interface Palette {
  free: Rgb;
  undecided: Rgb;
  occupied: Rgb;
  unknown: string;
  hatch: string;
  grid: string;
  ink: string;
  paper: string;
  /** Around lines that must stand out from floor and hatching alike. */
  halo: string;
  estimate: string;
  odometry: string;
  truth: string;
  robot: string;
  robotEdge: string;
  wall: string;
  sonar: string;
  echo: string;
  silence: string;
  noAnswer: string;
  choice: string;
  chosen: string;
  hypothesis: string;
  measure: string;
  /** From the lightest to the heaviest particle. */
  particles: readonly string[];
  /** One robot each; they begin again where a fleet is larger. */
  team: readonly string[];
  source: string;
}

export const palettes: Record<Theme, Palette> = {
  light: {
    free: [255, 255, 255],
    undecided: [176, 183, 194],
    occupied: [33, 37, 43],
    unknown: '#d5d9e0',
    hatch: '#c3c9d3',
    grid: 'rgba(40, 60, 90, 0.16)',
    ink: '#16202c',
    paper: 'rgba(255, 255, 255, 0.88)',
    halo: '#ffffff',
    estimate: '#0072b2',
    odometry: '#6b7480',
    truth: '#a8487f',
    robot: '#d55e00',
    robotEdge: '#ffffff',
    wall: '#009e73',
    sonar: '#b87d00',
    echo: '#b87d00',
    silence: '#2f86bd',
    noAnswer: '#d55e00',
    choice: '#0072b2',
    chosen: '#d55e00',
    hypothesis: '#a8487f',
    measure: '#16202c',
    particles: ['#9ccbe8', '#74b6de', '#4a9fd0', '#2788bf', '#0072b2', '#00588a'],
    team: ['#0072b2', '#d55e00', '#009e73', '#a8487f', '#b87d00', '#2f86bd', '#7a5195', '#6b7480'],
    source: '#d5008f',
  },
  dark: {
    free: [201, 208, 216],
    undecided: [140, 149, 161],
    occupied: [4, 6, 9],
    unknown: '#4b5563',
    hatch: '#5b6675',
    grid: 'rgba(16, 24, 36, 0.18)',
    ink: '#eef2f7',
    paper: 'rgba(18, 23, 30, 0.86)',
    halo: '#10161d',
    estimate: '#00568a',
    odometry: '#4a525d',
    truth: '#8c2f66',
    robot: '#c24e00',
    robotEdge: '#ffffff',
    wall: '#1fb98d',
    sonar: '#8a5d00',
    echo: '#e08a00',
    silence: '#1a5a85',
    noAnswer: '#b23c00',
    choice: '#8ecff5',
    chosen: '#ffab3d',
    hypothesis: '#f0a9d4',
    measure: '#0b0f14',
    particles: ['#7fb3d3', '#5a9dc6', '#3a86b5', '#1f6f9f', '#005a8c', '#003f66'],
    team: ['#00568a', '#b23c00', '#00704f', '#8c2f66', '#8a5d00', '#1a5a85', '#5b3a75', '#4a525d'],
    source: '#b3007a',
  },
};
