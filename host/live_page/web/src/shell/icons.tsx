// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';

const paths = {
  plus: 'M12 5v14M5 12h14',
  minus: 'M5 12h14',
  fit: 'M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5',
  follow: 'M12 2v4M12 18v4M2 12h4M18 12h4M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8',
  play: 'M7 4l13 8-13 8z',
  pause: 'M8 4v16M16 4v16',
  good: 'M4 12l5 6L20 6',
  weak: 'M12 3 2 21h20zM12 10v5M12 18v.1',
  down: 'M5 5l14 14M19 5 5 19',
  unknown: 'M8 9a4 4 0 1 1 5.5 3.7c-1 .5-1.5 1-1.5 2.3M12 19v.1',
  clock: 'M12 7v5l3 2M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18',
  info: 'M12 11v7M12 6v.1M12 2a10 10 0 1 0 0 20 10 10 0 0 0 0-20',
  theme: 'M12 3a9 9 0 1 0 0 18zM12 3a9 9 0 0 1 0 18',
  drive: 'M12 3v18M3 12h18M9 6l3-3 3 3M9 18l3 3 3-3M6 9l-3 3 3 3M18 9l3 3-3 3',
  status: 'M3 20h18M6 20v-6M11 20V9M16 20V5',
  layers: 'M12 3 2 8.5l10 5.5 10-5.5zM3 13l9 5 9-5M3 17l9 5 9-5',
  plots: 'M3 3v18h18M6 16l4-6 4 3 6-8',
  log: 'M5 4h14v16H5zM8 9h8M8 13h8M8 17h5',
} as const;

export type IconName = keyof typeof paths;

export function Icon({ name }: { name: IconName }): JSX.Element {
  return (
    <svg class="icon" viewBox="0 0 24 24" aria-hidden="true">
      <path d={paths[name]} />
    </svg>
  );
}
