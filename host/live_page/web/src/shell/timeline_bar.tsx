// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { duration, number } from '../format';
import { codeText, text } from '../language';
import { playbackSpeeds } from '../run/player';
import type { TimedEvent } from '../run/view';
import type { Session } from '../session';
import { Icon } from './icons';

const maxMarks = 60;
const keySteps: Record<string, number> = {
  ArrowLeft: -1,
  ArrowRight: 1,
  ArrowDown: -1,
  ArrowUp: 1,
  PageDown: -10,
  PageUp: 10,
};
/** An event is told where the instant is no further away, seconds. */
const nearS = 0.5;

function wordsAt(event: TimedEvent): string {
  return `${duration(event.time)}: ${codeText('event', event.code, event.text)}`;
}

/** Which instant is shown, of a run that is live or recorded. */
export function TimelineBar({ session }: { session: Session }): JSX.Element {
  const { player } = session;
  const { start, end, events } = session.span.value;
  const isLive = session.isLiveRun.value;
  const follows = isLive && player.live.value;
  const time = follows ? end : player.time.value;
  const length = Math.max(0.001, end - start);
  const marks = events.slice(-maxMarks);
  const here = marks.find((event) => Math.abs(event.time - time) <= nearS);
  return (
    <div class="timeline">
      <button
        type="button"
        class="map-button"
        title={text(player.playing.value ? 'timeline.pause' : 'timeline.play')}
        aria-label={text(player.playing.value ? 'timeline.pause' : 'timeline.play')}
        disabled={follows}
        onClick={() => {
          player.togglePlaying(start, end);
          session.onChange();
        }}
      >
        <Icon name={player.playing.value ? 'pause' : 'play'} />
      </button>
      <div class="track">
        <div class="event-marks" aria-hidden="true">
          {marks.map((event, index) => (
            <i
              key={index}
              class={`mark mark-${event.level}`}
              title={wordsAt(event)}
              onClick={() => session.seek(event.time)}
              style={{ left: `${((event.time - start) / length) * 100}%` }}
            />
          ))}
        </div>
        <input
          type="range"
          id="timeline"
          min={start}
          max={end}
          step={0.1}
          value={time}
          aria-label={text('timeline.label')}
          aria-valuetext={here ? wordsAt(here) : duration(time)}
          onKeyDown={(event) => {
            const step = keySteps[event.key];
            if (step === undefined) return;
            event.preventDefault();
            session.seek(time + step);
          }}
          onInput={(event) => session.seek(Number(event.currentTarget.value))}
        />
      </div>
      <output class="time">
        {duration(time)}
        <span class="time-end"> / {duration(end)}</span>
      </output>
      {!follows && (
        <select
          aria-label={text('timeline.speed')}
          value={player.speed.value}
          onChange={(event) => (player.speed.value = Number(event.currentTarget.value))}
        >
          {playbackSpeeds.map((speed) => (
            <option key={speed} value={speed}>
              ×{number(speed)}
            </option>
          ))}
        </select>
      )}
      {isLive && (
        <button type="button" class="live" aria-pressed={follows} onClick={() => session.toLive()}>
          <i class="live-dot" aria-hidden="true" />
          {text('timeline.live')}
        </button>
      )}
    </div>
  );
}
