// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { area, duration, percent } from '../format';
import { codeText, text } from '../language';
import type { RunState } from '../protocol/messages';
import { planOf } from '../run/plan';
import type { Session } from '../session';
import { Icon } from './icons';

export function modeWords(state: RunState | null): string {
  return state?.mode ? codeText('mode', state.mode, state.mode) : text('app.waiting');
}

export function whyWords(state: RunState | null): string {
  const why = planOf(state);
  if (!why?.code) return '';
  // Of a robot that looks for its place, that says more.
  const status = why.code === 'strategy' ? state?.localization?.status : null;
  const reason = status ? codeText('localization', status, status) : codeText('why', why.code, why.code);
  return why.gain_m2 ? `${reason}: ${text('why.gain', { area: area(why.gain_m2) })}` : reason;
}

/** What the robot does and why, in a line. */
export function MissionStrip({ session }: { session: Session }): JSX.Element {
  const { state } = session.shown.value.view;
  const coverage = state?.coverage;
  return (
    <div class="mission">
      <span class={`mode mode-${state?.mode ?? 'none'}`}>{modeWords(state)}</span>
      <span class="why">{whyWords(state)}</span>
      {coverage !== null && coverage !== undefined && (
        <span class="coverage" title={text('status.coverage.help')}>
          {percent(coverage)} <progress max={1} value={coverage} aria-label={text('status.coverage')} />
        </span>
      )}
      {state && state.left_s !== null && (
        <span class="left" title={text('status.left')}>
          <Icon name="clock" />
          {duration(state.left_s)}
        </span>
      )}
    </div>
  );
}
