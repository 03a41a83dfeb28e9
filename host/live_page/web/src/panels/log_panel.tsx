// SPDX-License-Identifier: MIT
import { useSignal } from '@preact/signals';
import type { JSX } from 'preact';
import { useEffect } from 'preact/hooks';
import { bytes, duration } from '../format';
import { codeText, text } from '../language';
import { fetchFiles, fileUrl, type RunFile } from '../protocol/runs';
import type { TimedEvent } from '../run/view';
import type { Session } from '../session';
import { Icon, type IconName } from '../shell/icons';

const maxEvents = 200;
const icons: Record<string, IconName> = { info: 'info', warning: 'weak', error: 'down' };

function EventItem({ event, onSeek }: { event: TimedEvent; onSeek: () => void }): JSX.Element {
  const { code, level } = event;
  const cause = codeText('event', `${code}.cause`, event.cause);
  const remedy = codeText('event', `${code}.remedy`, event.remedy);
  return (
    <li class={`event event-${level}`}>
      <Icon name={icons[level] ?? 'info'} />
      <div>
        <p>
          <button type="button" class="time-link" onClick={onSeek}>
            {duration(event.time)}
          </button>{' '}
          <strong>{codeText('level', level, level)}:</strong> {codeText('event', code, event.text)}
        </p>
        {cause && (
          <p class="help">
            {text('events.cause')}: {cause}
          </p>
        )}
        {remedy && (
          <p class="help">
            {text('events.remedy')}: {remedy}
          </p>
        )}
      </div>
    </li>
  );
}

export function LogPanel({ session }: { session: Session }): JSX.Element {
  const { events } = session.shown.value.view;
  return (
    <>
      <section>
        <h2>{text('events.title')}</h2>
        {events.length === 0 && <p class="help">{text('events.none')}</p>}
        <ul class="events">
          {events
            .slice(-maxEvents)
            .reverse()
            .map((event, index) => (
              <EventItem key={events.length - index} event={event} onSeek={() => session.seek(event.time)} />
            ))}
        </ul>
      </section>
      <Downloads session={session} />
    </>
  );
}

function Downloads({ session }: { session: Session }): JSX.Element {
  const files = useSignal<RunFile[]>([]);
  const run = session.shownRun.value;
  const load = (): void => {
    if (run === null) return;
    fetchFiles(run).then(
      (found) => (files.value = found),
      () => (files.value = []),
    );
  };
  useEffect(load, [run]);
  return (
    <section>
      <h2>{text('files.title')}</h2>
      {files.value.length === 0 && <p class="help">{text('files.none')}</p>}
      <ul class="files">
        {files.value.map((file) => (
          <li key={file.name}>
            <a href={fileUrl(run ?? '', file.name)} download={file.name}>
              {file.name}
            </a>{' '}
            <span class="help">{bytes(file.bytes)}</span>
          </li>
        ))}
      </ul>
      <button type="button" class="small" onClick={load}>
        {text('files.reload')}
      </button>
    </section>
  );
}
