// SPDX-License-Identifier: MIT
import type { Session } from './session';

/** What tests and curious people read in the browser's console. */
export function exposeTestInterface(session: Session): void {
  const stats = (): object => {
    const { drawMs, latencyMs, firstMapMs, messages, dropped } = session.stats;
    return {
      drawMs: drawMs.slice(),
      latencyMs: latencyMs.slice(),
      firstMapMs,
      messages,
      dropped,
      connected: session.linkStatus.value === 'open',
      mode: session.view.state?.mode ?? null,
    };
  };
  const view = (): object => {
    const { hello, motion, tiles, particles, events, time } = session.view;
    return {
      run: hello?.run ?? null,
      time,
      pose: motion && { ...motion.pose },
      tiles: tiles.size,
      particles: (particles?.length ?? 0) / 4,
      events: events.length,
      client: session.ownClient.value,
      driving: session.drives.value,
      stop: session.stopStatus.value,
    };
  };
  Object.defineProperty(window, '__echomap', {
    value: Object.freeze({
      stats,
      get view() {
        return view();
      },
    }),
  });
}
