// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { milliseconds, number, volts } from '../format';
import { text } from '../language';
import type { RunState } from '../protocol/messages';
import type { Session } from '../session';
import { Icon } from './icons';

export type LinkHealth = 'good' | 'weak' | 'down' | 'unknown';

const slowMs = 50;

export function linkHealth(state: RunState | null): LinkHealth {
  const link = state?.link;
  if (!link?.state) return 'unknown';
  if (link.state !== 'ready') return 'down';
  return (link.round_trip_ms ?? 0) > slowMs ? 'weak' : 'good';
}

/** How well the robot is heard: colour, sign and words. */
export function LinkPill({ session }: { session: Session }): JSX.Element {
  const { state } = session.shown.value.view;
  const link = state?.link;
  const health = session.linkStatus.value === 'lost' ? 'down' : linkHealth(state);
  const details: [string, string][] = [
    [text('link.roundTrip'), milliseconds(link?.round_trip_ms)],
    [text('link.lost'), number(link?.frames_lost)],
    [text('link.bad'), number(link?.frames_bad)],
    [text('link.resets'), number(link?.resets)],
    [text('link.rate'), number(link?.frames_per_s)],
    [text('link.battery'), volts(link?.battery_v)],
  ];
  return (
    <div class={`pill pill-${health}`} title={details.map((detail) => detail.join(': ')).join('\n')}>
      <Icon name={health} />
      <span class="pill-word">{text(`link.${health}`)}</span>
      {link && <span class="pill-number">{milliseconds(link.round_trip_ms)}</span>}
      {link && (
        <>
          <span class="pill-number pill-wide">{number(link.frames_per_s)}/s</span>
          <span class="pill-number pill-wide">{text('link.lostShort', { count: number(link.frames_lost) })}</span>
          <span class="pill-number pill-wide">{text('link.badShort', { count: number(link.frames_bad) })}</span>
          <span class="pill-number pill-wide">{text('link.resetsShort', { count: number(link.resets) })}</span>
          {link.battery_v !== null && <span class="pill-number pill-battery">{volts(link.battery_v)}</span>}
        </>
      )}
    </div>
  );
}
