// SPDX-License-Identifier: MIT
import { useSignal } from '@preact/signals';
import type { JSX } from 'preact';
import { number } from '../format';
import { text } from '../language';
import type { Session } from '../session';

const maxFactor = 50;
const asFastAsItCan = 0;
const cutForS = 4;

/** What one can do to a simulated robot. */
export function DemoPanel({ session }: { session: Session }): JSX.Element | null {
  const can = session.can.value;
  const dragged = useSignal<number | null>(null);
  const speed = dragged.value ?? session.shown.value.view.state?.speed ?? 1;
  if (!can.has('speed') && !can.has('carry-off') && !can.has('cut-cable')) return null;
  return (
    <section>
      <h2>{text('demo.title')}</h2>
      {can.has('speed') && (
        <div class="speed">
          <label class="field" for="speed">
            {text('demo.speed')}: {speed === asFastAsItCan ? text('demo.speedMax') : `×${number(speed)}`}
          </label>
          <input
            id="speed"
            type="range"
            min={1}
            max={maxFactor}
            value={speed === asFastAsItCan ? maxFactor : speed}
            onInput={(event) => (dragged.value = Number(event.currentTarget.value))}
            onChange={(event) => {
              dragged.value = null;
              void session.command({ do: 'speed', factor: Number(event.currentTarget.value) });
            }}
          />
          <button
            type="button"
            class="small"
            aria-pressed={speed === asFastAsItCan}
            onClick={() => void session.command({ do: 'speed', factor: asFastAsItCan })}
          >
            {text('demo.speedMax')}
          </button>
        </div>
      )}
      <div class="actions">
        {can.has('carry-off') && (
          <button type="button" title={text('demo.carry-off.help')} onClick={() => void session.command({ do: 'carry-off' })}>
            {text('demo.carry-off')}
          </button>
        )}
        {can.has('cut-cable') && (
          <button
            type="button"
            title={text('demo.cut-cable.help')}
            onClick={() => void session.command({ do: 'cut-cable', seconds: cutForS })}
          >
            {text('demo.cut-cable')}
          </button>
        )}
      </div>
    </section>
  );
}
