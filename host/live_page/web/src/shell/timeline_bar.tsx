// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { duration, number } from '../format';
import { codeText, text } from '../language';
import { playbackSpeeds } from '../run/player';
import type { Session } from '../session';
import { Icon } from './icons';

const maxMarks = 60;

/** Which instant is shown, of a run that is live or recorded. */
export function TimelineBar({ session }: { session: Session }): JSX.Element {
  const { player } = session;
  const { start, end, events } = session.span.value;
  const isLive = session.isLiveRun.value;
  const follows = isLive && player.live.value;
  const time = follows ? end : player.time.value;
  const length = Math.max(0.001, end - start);
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
          {events.slice(-maxMarks).map((event, index) => (
            <i
              key={index}
              class={`mark mark-${event.level}`}
              title={codeText('event', event.code, event.code)}
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
          aria-valuetext={duration(time)}
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
