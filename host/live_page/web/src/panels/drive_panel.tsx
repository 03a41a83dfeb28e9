// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { deviceName, setDeviceName } from '../device_name';
import { Joystick } from '../drive/joystick';
import { text } from '../language';
import type { Tool } from '../map/tools';
import type { TextKey } from '../texts';
import type { Session } from '../session';
import { DemoPanel } from './demo_panel';

function driverWords(session: Session): string {
  const { state } = session.shown.value.view;
  const driver = state?.driver;
  const isOwn = driver ? driver.client === session.ownClient.value : session.drives.value;
  // Who has stopped holds the lock for a moment.
  if (isOwn && (session.drives.value || state?.mode !== 'stopped')) return text('drive.you');
  return driver && !isOwn ? text('drive.other', { name: driver.name }) : text('drive.nobody');
}

export function DrivePanel({ session }: { session: Session }): JSX.Element {
  const can = session.can.value;
  const action = (name: 'explore' | 'moved'): JSX.Element | false =>
    can.has(name) && (
      <button
        type="button"
        class={name === 'explore' ? 'primary' : ''}
        title={text(`drive.${name}.help`)}
        onClick={() => void session.command({ do: name })}
      >
        {text(`drive.${name}`)}
      </button>
    );
  const tool = (name: Extract<Tool, 'go' | 'pose' | 'box'>): JSX.Element | false =>
    can.has(name) && (
      <button type="button" aria-pressed={session.tool.value === name} onClick={() => session.chooseTool(name)}>
        {text(`tool.${name}` satisfies TextKey)}
      </button>
    );
  if (can.size === 0) return <p class="help">{text('drive.none')}</p>;
  return (
    <>
      {can.has('drive') && (
        <section class="hand">
          <Joystick session={session} />
          <div class="hand-words">
            <h2>{text('drive.title')}</h2>
            <p class={session.drives.value ? 'driver driver-you' : 'driver'}>{driverWords(session)}</p>
            <p class="help help-long">{text('drive.help')}</p>
          </div>
        </section>
      )}
      <section class="actions">
        {action('explore')}
        {tool('go')}
        {tool('pose')}
        {action('moved')}
        {tool('box')}
      </section>
      <DemoPanel session={session} />
      {can.has('drive') && (
        <section>
          <label class="field">
            {text('drive.name')}
            <input
              type="text"
              maxLength={24}
              defaultValue={deviceName.value}
              onChange={(event) => {
                setDeviceName(event.currentTarget.value);
                session.sendName();
              }}
            />
          </label>
        </section>
      )}
    </>
  );
}
