// SPDX-License-Identifier: MIT

/** Every code that the server sends, by what it is of; the page has words for each. */
export const codes = {
  mode: ['connecting', 'explore', 'drive', 'go', 'stopped', 'lost-link', 'ended', 'recording'],
  why: ['frontier', 'known-walls', 'tell-apart', 'opening', 'sweep', 'operator', 'strategy'],
  stopped: [
    'stop',
    'driver-gone',
    'driver-silent',
    'bumped',
    'hazard',
    'stalled',
    'lifted',
    'no-way',
    'arrived',
  ],
  refused: ['unknown', 'malformed', 'not-possible', 'stale', 'not-driver', 'busy'],
  event: [
    'reset',
    'link-ready',
    'link-lost',
    'lifted',
    'bumped',
    'sonar-dead',
    'sonar-answers',
    'encoder-left-dirty',
    'encoder-right-dirty',
    'maps-joined',
    'new-map',
    'stop',
    'driver-gone',
    'no-way',
    'stalled',
    'carried-off',
    'box',
    'cable-cut',
  ],
  localization: ['lost', 'recovering', 'localized'],
  level: ['info', 'warning', 'error'],
  presence: ['alive', 'left', 'gone'],
  'source.verdict': ['searching', 'found', 'none'],
} as const;

export type EventCode = (typeof codes.event)[number];
export type StoppedCode = (typeof codes.stopped)[number];
