// SPDX-License-Identifier: MIT
import type { Point } from '../protocol/messages';
import type { Camera } from './camera';

export interface GestureListener {
  /** Whether a press belongs to a tool and does not move the map. */
  aims(): boolean;
  onMove(): void;
  onZoom(): void;
  onTap(at: Point): void;
  onAim(from: Point, to: Point, done: boolean): void;
}

const tapPixels = 6;

interface Pressed {
  x: number;
  y: number;
}

/** Mouse, wheel and fingers on the map. */
export function watchGestures(canvas: HTMLCanvasElement, camera: Camera, listener: GestureListener): void {
  const pressed = new Map<number, Pressed>();
  let start: Pressed | null = null;
  let moved = false;
  let aimFrom: Point | null = null;
  /** Two fingers hold these points of the map, as far apart as they were at first. */
  let pinch: { middle: Point; apart: number; scale: number } | null = null;

  const placeOf = (event: PointerEvent | WheelEvent): Pressed => {
    const edges = canvas.getBoundingClientRect();
    return { x: event.clientX - edges.left, y: event.clientY - edges.top };
  };
  const fingers = (): { x: number; y: number; apart: number } => {
    const [a, b] = [...pressed.values()] as [Pressed, Pressed];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.max(1, Math.hypot(a.x - b.x, a.y - b.y)) };
  };

  canvas.addEventListener('pointerdown', (event) => {
    if (event.button !== 0 || pressed.size >= 2) return;
    canvas.setPointerCapture(event.pointerId);
    const at = placeOf(event);
    pressed.set(event.pointerId, at);
    if (pressed.size === 1) {
      start = at;
      moved = false;
      aimFrom = listener.aims() ? camera.toMap(at.x, at.y) : null;
    } else {
      const { x, y, apart } = fingers();
      pinch = { middle: camera.toMap(x, y), apart, scale: camera.scale };
      moved = true;
      aimFrom = null;
    }
  });

  canvas.addEventListener('pointermove', (event) => {
    const before = pressed.get(event.pointerId);
    if (!before) return;
    const at = placeOf(event);
    pressed.set(event.pointerId, at);
    if (pinch && pressed.size === 2) {
      const { x, y, apart } = fingers();
      camera.place(pinch.middle, x, y, (pinch.scale * apart) / pinch.apart);
      listener.onZoom();
      return;
    }
    if (start && Math.hypot(at.x - start.x, at.y - start.y) > tapPixels) moved = true;
    if (aimFrom) {
      if (moved) listener.onAim(aimFrom, camera.toMap(at.x, at.y), false);
    } else if (moved) {
      camera.panBy(at.x - before.x, at.y - before.y);
      listener.onMove();
    }
  });

  const lift = (event: PointerEvent): void => {
    if (!pressed.delete(event.pointerId)) return;
    pinch = null;
    if (pressed.size > 0) return;
    const at = placeOf(event);
    const point = camera.toMap(at.x, at.y);
    if (event.type === 'pointerup') {
      if (aimFrom && moved) listener.onAim(aimFrom, point, true);
      else if (!moved) listener.onTap(point);
    }
    start = aimFrom = null;
  };
  canvas.addEventListener('pointerup', lift);
  canvas.addEventListener('pointercancel', lift);

  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const { x, y } = placeOf(event);
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
      camera.zoomAt(x, y, Math.exp(-event.deltaY * lines * (event.ctrlKey ? 0.01 : 0.0015)));
      listener.onZoom();
    },
    { passive: false },
  );
}
