// SPDX-License-Identifier: MIT
import { useSignal } from '@preact/signals';
import type { JSX } from 'preact';
import { text } from '../language';
import type { Session } from '../session';
import { steeringOfStick } from './joystick_steering';

const travelPixels = 52;

/** Steers while a finger or the mouse holds it; springs back when let go. */
export function Joystick({ session }: { session: Session }): JSX.Element {
  const knob = useSignal({ x: 0, y: 0 });
  const pointer = useSignal<number | null>(null);
  const move = (event: PointerEvent & { currentTarget: HTMLElement }): void => {
    const edges = event.currentTarget.getBoundingClientRect();
    const right = (event.clientX - edges.left - edges.width / 2) / travelPixels;
    const down = (event.clientY - edges.top - edges.height / 2) / travelPixels;
    const shrink = Math.max(1, Math.hypot(right, down));
    knob.value = { x: (right / shrink) * travelPixels, y: (down / shrink) * travelPixels };
    session.hold('joystick', steeringOfStick(right, down));
  };
  const letGo = (event: PointerEvent): void => {
    if (pointer.value !== event.pointerId) return;
    pointer.value = null;
    knob.value = { x: 0, y: 0 };
    session.hold('joystick', null);
  };
  return (
    <div
      class={pointer.value === null ? 'joystick' : 'joystick joystick-held'}
      role="img"
      aria-label={text('drive.stick')}
      title={text('drive.stick')}
      onPointerDown={(event) => {
        if (pointer.value !== null || event.button !== 0) return;
        event.preventDefault();
        event.currentTarget.setPointerCapture(event.pointerId);
        pointer.value = event.pointerId;
        move(event);
      }}
      onPointerMove={(event) => {
        if (pointer.value === event.pointerId) move(event);
      }}
      onPointerUp={letGo}
      onPointerCancel={letGo}
    >
      <div class="knob" style={{ transform: `translate(${knob.value.x}px, ${knob.value.y}px)` }} />
    </div>
  );
}
