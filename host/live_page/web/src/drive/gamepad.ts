// SPDX-License-Identifier: MIT
import type { Steering } from './drive_sampler';
import { steeringOfStick } from './joystick_steering';

export interface GamepadListener {
  onSteering(steering: Steering | null): void;
  onStop(): void;
}

/** Reads the first gamepad before each frame: the left stick steers, every button stops. */
export function watchGamepad(listener: GamepadListener): void {
  let pressed = false;
  let steered = false;
  let watching = false;
  const read = (): void => {
    const pad = navigator.getGamepads().find((candidate) => candidate?.connected);
    if (!pad) {
      watching = false;
      if (steered) listener.onSteering(null);
      steered = false;
      return;
    }
    const anyButton = pad.buttons.some((button) => button.pressed);
    if (anyButton && !pressed) listener.onStop();
    pressed = anyButton;
    const steering = steeringOfStick(pad.axes[0] ?? 0, pad.axes[1] ?? 0);
    const steers = !anyButton && (steering.forward !== 0 || steering.turn !== 0);
    if (steers || steered) listener.onSteering(steers ? steering : null);
    steered = steers;
    requestAnimationFrame(read);
  };
  window.addEventListener('gamepadconnected', () => {
    if (watching) return;
    watching = true;
    read();
  });
}
