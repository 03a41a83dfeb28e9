// SPDX-License-Identifier: MIT
import type { Session } from '../session';
import { watchGamepad } from './gamepad';
import { isDriveKey, ownsKeys, steeringOfKeys } from './keyboard';

/** Keys and gamepad of the whole page, and what happens when it goes out of sight. */
export function startControls(session: Session): void {
  const held = new Set<string>();
  const isStopKey = (event: KeyboardEvent): boolean =>
    event.code === 'Escape' || (event.code === 'Space' && !ownsKeys(event.target, event.code));

  window.addEventListener(
    'keydown',
    (event) => {
      if (isStopKey(event)) {
        event.preventDefault();
        event.stopPropagation();
        held.clear();
        if (!event.repeat) session.stop();
        return;
      }
      if (!isDriveKey(event.code) || event.ctrlKey || event.metaKey || event.altKey) return;
      if (!session.can.value.has('drive') || ownsKeys(event.target, event.code)) return;
      event.preventDefault();
      if (event.repeat) return;
      if (held.size === 0) session.hold('keyboard', null);
      held.add(event.code);
      session.hold('keyboard', steeringOfKeys(held));
    },
    true,
  );
  window.addEventListener(
    'keyup',
    (event) => {
      if (isStopKey(event)) event.preventDefault();
      if (!isDriveKey(event.code)) return;
      held.delete(event.code);
      session.hold('keyboard', steeringOfKeys(held));
    },
    true,
  );

  const leave = (): void => {
    held.clear();
    session.abandonDriving();
  };
  document.addEventListener('visibilitychange', () => {
    if (document.hidden) leave();
  });
  window.addEventListener('blur', leave);
  window.addEventListener('pagehide', leave);

  watchGamepad({
    onSteering: (steering) => session.hold('gamepad', steering),
    onStop: () => session.stop(),
  });
}
