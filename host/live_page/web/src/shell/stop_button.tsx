// SPDX-License-Identifier: MIT
import type { JSX } from 'preact';
import { text } from '../language';
import type { Session } from '../session';

/** Acts when it is pressed, not when it is let go. */
export function StopButton({ session }: { session: Session }): JSX.Element {
  const status = session.stopStatus.value;
  return (
    <button
      type="button"
      id="stop"
      class={`stop stop-${status}`}
      title={text('stop.help')}
      onPointerDown={(event) => {
        event.preventDefault();
        session.stop();
      }}
      onClick={(event) => {
        if (event.detail === 0) session.stop();
      }}
    >
      <span class="stop-word">{text('stop.label')}</span>
      <span class="stop-status">{text(`stop.${status}`)}</span>
    </button>
  );
}
