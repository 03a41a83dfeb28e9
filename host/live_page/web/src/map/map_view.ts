// SPDX-License-Identifier: MIT
import { area, metres, percent } from '../format';
import type { Motion } from '../protocol/messages';
import type { Session } from '../session';
import { theme } from '../theme';
import { Camera } from './camera';
import { MapPainter, roundLength } from './draw_map';
import { watchGestures } from './gestures';
import { mapBounds } from './map_bounds';
import { ShownPose } from './shown_pose';

const maxPixelRatio = 2;
const maxCanvasEdge = 4096;
const keyPanPixels = 60;
const keyZoom = 1.3;
const scaleBarPixels = 56;

/** The map on its canvas: draws a frame whenever something has changed, and none otherwise. */
export class MapView {
  /** Called with the scale bar's length when it changes. */
  onScale: (length: string, pixels: number) => void = () => {};
  private readonly camera = new Camera();
  private readonly painter = new MapPainter();
  private readonly pose = new ShownPose();
  private readonly context: CanvasRenderingContext2D;
  private pixelRatio = 1;
  private frame = 0;
  private fits = true;
  private previousFrameMs = 0;
  private drawnMotion: Motion | null = null;
  private scaleKey = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly session: Session,
  ) {
    this.context = canvas.getContext('2d', { alpha: false })!;
    session.onChange = () => this.invalidate();
    session.onOtherRun = () => this.fit();
    watchGestures(canvas, this.camera, {
      aims: () => session.tool.value === 'pose',
      onMove: () => this.moved(),
      onZoom: () => this.zoomed(),
      onTap: (at) => session.useTool(at),
      onAim: (from, to, done) => session.aimPose(from, to, done),
    });
    canvas.addEventListener('keydown', (event) => this.onKey(event));
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  invalidate(): void {
    this.frame ||= requestAnimationFrame((now) => this.draw(now));
  }

  fit(): void {
    this.fits = true;
    this.session.follows.value = false;
    this.invalidate();
  }

  zoom(factor: number): void {
    this.camera.zoomAt(this.camera.width / 2, this.camera.height / 2, factor);
    this.zoomed();
  }

  /** Goes on following the robot. */
  private zoomed(): void {
    this.fits = false;
    this.invalidate();
  }

  private moved(): void {
    this.fits = false;
    this.session.follows.value = false;
    this.invalidate();
  }

  private onKey(event: KeyboardEvent): void {
    const pan: Record<string, [number, number]> = {
      ArrowLeft: [keyPanPixels, 0],
      ArrowRight: [-keyPanPixels, 0],
      ArrowUp: [0, keyPanPixels],
      ArrowDown: [0, -keyPanPixels],
    };
    const shift = pan[event.key];
    if (event.key === '+' || event.key === '=') this.zoom(keyZoom);
    else if (event.key === '-') this.zoom(1 / keyZoom);
    else if (event.key === '0') this.fit();
    else if (shift && !event.defaultPrevented) {
      this.camera.panBy(...shift);
      this.moved();
    } else return;
    event.preventDefault();
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    const longer = Math.max(clientWidth, clientHeight);
    this.pixelRatio = Math.min(devicePixelRatio, maxPixelRatio, maxCanvasEdge / longer);
    this.canvas.width = Math.round(clientWidth * this.pixelRatio);
    this.canvas.height = Math.round(clientHeight * this.pixelRatio);
    this.camera.width = clientWidth;
    this.camera.height = clientHeight;
    this.invalidate();
  }

  private draw(nowMs: number): void {
    this.frame = 0;
    const { session, camera } = this;
    session.advance(Math.min(0.25, (nowMs - this.previousFrameMs) / 1000));
    this.previousFrameMs = nowMs;
    const startMs = performance.now();
    const { view } = session;
    const pose = this.pose.at(view.motion, startMs);
    if (this.fits) {
      const bounds = mapBounds(view);
      if (bounds) camera.fit(bounds);
    }
    if (session.follows.value && pose) {
      camera.x = pose.x;
      camera.y = pose.y;
    }
    this.painter.draw(this.context, camera, this.pixelRatio, {
      view,
      pose,
      layers: session.layers.value,
      marks: session.marks.value,
      theme: theme.value,
      formatMetres: metres,
      formatArea: area,
      formatPercent: percent,
    });
    this.measure(startMs, performance.now(), view.motion, view.tiles.size > 0);
    this.showScale();
    if (this.pose.isGliding(startMs) || session.player.playing.value) this.invalidate();
  }

  private measure(startMs: number, endMs: number, motion: Motion | null, hasMap: boolean): void {
    const { stats, connection, player, linkStatus } = this.session;
    stats.addDraw(endMs - startMs);
    stats.addDrawnMotion();
    if (hasMap) stats.firstMapMs ??= endMs;
    if (!motion || motion === this.drawnMotion) return;
    this.drawnMotion = motion;
    if (linkStatus.value !== 'open' || !player.live.value) return;
    const latency = connection.clock.ageMs(motion.clockMs, endMs);
    if (latency !== null) stats.addLatency(Math.max(0, latency));
  }

  private showScale(): void {
    if (this.camera.scale === this.scaleKey) return;
    this.scaleKey = this.camera.scale;
    const length = roundLength(scaleBarPixels, this.camera.scale);
    this.onScale(length < 1 ? `${Math.round(length * 100)} cm` : `${length} m`, length * this.camera.scale);
  }
}
