// SPDX-License-Identifier: MIT
import { computed, signal } from '@preact/signals';
import { deviceName } from './device_name';
import { DriveSampler } from './drive/drive_sampler';
import { codeText, text } from './language';
import { defaultLayers, type LayerName, type Layers } from './map/layers';
import type { Tool, ToolMarks } from './map/tools';
import type { Ack, Command } from './protocol/commands';
import { Connection } from './protocol/connection';
import { decode } from './protocol/decode';
import type { Message, Point, RunState } from './protocol/messages';
import { fetchHistory, fetchRuns, type RunEntry } from './protocol/runs';
import { Player } from './run/player';
import { type Cursor, type Encoded, joinHistory, splitHistory, Timeline } from './run/timeline';
import { apply, emptyView, type TimedEvent, type View } from './run/view';
import { Stats } from './stats';

export type LinkStatus = 'connecting' | 'open' | 'lost' | 'recorded';
export type StopStatus = 'idle' | 'sent' | 'confirmed' | 'unconfirmed';

export interface Notice {
  words: string;
  isError: boolean;
}

const panelsEveryMs = 120;
const historyAfterMs = 300;
const historyAgainAfterMs = 3000;
const stopByPostAfterMs = 300;
const stopAnswerWithinMs = 1000;
const noticeForMs = 6000;
const retryRunsMs = 1000;

/** All that the page knows and does, apart from how it looks. */
export class Session {
  readonly stats = new Stats();
  readonly player = new Player();
  readonly runs = signal<RunEntry[]>([]);
  readonly shownRun = signal<string | null>(null);
  readonly linkStatus = signal<LinkStatus>('connecting');
  readonly stopStatus = signal<StopStatus>('idle');
  readonly notice = signal<Notice | null>(null);
  readonly layers = signal<Layers>(defaultLayers);
  readonly follows = signal(false);
  readonly tool = signal<Tool>('pan');
  readonly marks = signal<ToolMarks>({ measure: [], pose: null });
  readonly drives = signal(false);
  readonly ownClient = signal<number | null>(null);
  /** Of the shown run; changes as it grows. */
  readonly span = signal({ start: 0, end: 0, events: [] as TimedEvent[] });
  /** For panels: the shown view, a few times a second. */
  readonly shown = signal<{ view: View }>({ view: emptyView() });
  readonly can = computed(() => {
    const { view } = this.shown.value;
    const obeys = this.isLiveRun.value && view.state?.mode !== 'ended';
    return new Set(obeys ? (view.hello?.can ?? []) : []);
  });
  readonly isLiveRun = computed(() => this.runs.value.find(({ id }) => id === this.shownRun.value)?.live ?? false);

  readonly connection = new Connection({
    onOpen: () => this.beginLive(),
    onNumber: (client) => (this.ownClient.value = client),
    onMessage: (bytes) => this.takeMessage(bytes),
    onLost: () => this.loseConnection(),
    isLive: async () => {
      await this.loadRuns();
      if (this.liveRun) return true;
      this.endLive();
      return false;
    },
  });
  readonly sampler = new DriveSampler({
    isReady: () => this.connection.isOpen && this.connection.bufferedBytes === 0,
    drive: ({ forward, turn }) => {
      const seen = this.connection.clock.seenMs;
      return this.connection.sendNow({ do: 'drive', forward, turn, seen })?.then((ack) => this.takeDriveAck(ack)) ?? null;
    },
    release: () => void this.connection.sendNow({ do: 'release' }),
  });
  /** Called when something on the map has changed. */
  onChange: () => void = () => {};
  /** Called when another run is shown. */
  onOtherRun: () => void = () => {};

  private readonly nothing = emptyView();
  private liveView = emptyView();
  private liveSince: Encoded[] = [];
  private liveTimeline: Timeline | null = null;
  private shownTimeline: Timeline | null = null;
  private cursor: Cursor | undefined;
  private connects = 0;
  private panelsTimer = 0;
  private noticeTimer = 0;
  private stopNumber = 0;
  private movingStates = 0;

  get view(): View {
    const followsLive = this.isLiveRun.peek() && (this.player.live.peek() || !this.shownTimeline);
    return followsLive ? this.liveView : (this.cursor?.view ?? this.nothing);
  }

  start(): void {
    this.loadRuns().then(
      () => {
        const first = this.liveRun ?? this.runs.value[0];
        if (first) void this.showRun(first.id);
        else setTimeout(() => this.start(), retryRunsMs);
      },
      () => {
        this.linkStatus.value = 'lost';
        setTimeout(() => this.start(), retryRunsMs);
      },
    );
  }

  async showRun(id: string): Promise<void> {
    this.shownRun.value = id;
    this.tool.value = 'pan';
    this.marks.value = { measure: [], pose: null };
    this.onOtherRun();
    this.cursor = undefined;
    this.shownTimeline = null;
    if (this.liveRun) this.connection.start();
    if (this.isLiveRun.value) {
      this.shownTimeline = this.liveTimeline;
      this.player.toLive();
      this.changed();
      return;
    }
    if (!this.liveRun) this.linkStatus.value = 'recorded';
    try {
      const timeline = await buildTimeline(splitHistory(await fetchHistory(id)));
      if (this.shownRun.value !== id) return;
      this.shownTimeline = timeline;
      this.seek(timeline.end);
    } catch {
      this.tell(text('refused.no-answer'), true);
    }
  }

  seek(time: number): void {
    const timeline = this.shownTimeline;
    if (!timeline) return;
    this.player.toTime(Math.min(timeline.end, Math.max(timeline.start, time)));
    this.cursor = timeline.seek(this.player.time.value, this.cursor);
    this.changed();
  }

  /** Lets the playback go on by so many seconds. */
  advance(seconds: number): void {
    if (!this.player.playing.value || !this.shownTimeline) return;
    this.player.advance(seconds, this.shownTimeline.end);
    this.cursor = this.shownTimeline.seek(this.player.time.value, this.cursor);
    this.changed();
  }

  toLive(): void {
    this.player.toLive();
    this.changed();
  }

  /** From everybody, at any time, by every way there is. */
  stop(): void {
    this.dropDriving();
    this.player.pause();
    if (this.runs.value.length > 0 && !this.liveRun) return;
    this.stopStatus.value = 'sent';
    const number = ++this.stopNumber;
    let answered = false;
    const settle = (ack: Ack): void => {
      if (number !== this.stopNumber || answered || !ack.ok) return;
      answered = true;
      this.stopStatus.value = 'confirmed';
    };
    const wasOpen = this.connection.isOpen;
    void this.connection.send({ do: 'stop' }).then(settle);
    setTimeout(() => {
      if (!answered && wasOpen) void this.connection.post({ do: 'stop' }).then(settle);
    }, stopByPostAfterMs);
    setTimeout(() => {
      if (!answered && number === this.stopNumber) this.stopStatus.value = 'unconfirmed';
    }, stopAnswerWithinMs);
  }

  async command(command: Command): Promise<void> {
    const ack = await this.connection.sendNow(command);
    if (!ack?.ok) this.tellRefusal(ack);
    else if (command.do === 'explore' || command.do === 'go') this.stopStatus.value = 'idle';
  }

  sendName(): void {
    void this.connection.sendNow({ do: 'name', name: deviceName.value });
  }

  hold(...held: Parameters<DriveSampler['hold']>): void {
    if (held[1] && !this.can.value.has('drive')) return;
    if (held[1] && !this.player.live.value) this.toLive();
    this.sampler.hold(...held);
    this.drives.value = this.sampler.isDriving;
  }

  abandonDriving(): void {
    this.sampler.abandon();
    this.drives.value = false;
  }

  chooseTool(tool: Tool): void {
    this.tool.value = this.tool.value === tool ? 'pan' : tool;
    this.marks.value = { measure: [], pose: null };
    this.onChange();
  }

  /** A press on the map with the tool that is chosen. */
  useTool(at: Point): void {
    const [x, y] = at;
    const { measure } = this.marks.value;
    switch (this.tool.value) {
      case 'go':
        void this.command({ do: 'go', x, y });
        this.chooseTool('go');
        break;
      case 'box':
        void this.command({ do: 'box', x, y });
        this.chooseTool('box');
        break;
      case 'measure':
        this.marks.value = { measure: measure.length === 1 ? [...measure, at] : [at], pose: null };
        this.onChange();
        break;
      case 'pan':
      case 'pose':
        break;
    }
  }

  aimPose(from: Point, to: Point, done: boolean): void {
    const heading = Math.atan2(to[1] - from[1], to[0] - from[0]);
    const pose = { x: from[0], y: from[1], heading };
    if (done) {
      void this.command({ do: 'pose', ...pose });
      this.chooseTool('pose');
    } else {
      this.marks.value = { measure: [], pose };
      this.onChange();
    }
  }

  toggleLayer(name: LayerName): void {
    this.layers.value = { ...this.layers.value, [name]: !this.layers.value[name] };
    this.onChange();
  }

  tell(words: string, isError: boolean): void {
    this.notice.value = { words, isError };
    clearTimeout(this.noticeTimer);
    this.noticeTimer = window.setTimeout(() => (this.notice.value = null), noticeForMs);
  }

  private get liveRun(): RunEntry | undefined {
    return this.runs.value.find(({ live }) => live);
  }

  private async loadRuns(): Promise<void> {
    this.runs.value = await fetchRuns();
  }

  private beginLive(): void {
    const connect = ++this.connects;
    this.linkStatus.value = 'open';
    this.liveSince = [];
    this.liveTimeline = null;
    this.liveView = emptyView();
    this.sendName();
    if (this.stopStatus.value === 'unconfirmed' || this.stopStatus.value === 'sent') this.stop();
    setTimeout(() => void this.loadLiveHistory(connect), historyAfterMs);
  }

  private async loadLiveHistory(connect: number): Promise<void> {
    const run = this.liveRun;
    if (!run || connect !== this.connects) return;
    try {
      const history = splitHistory(await fetchHistory(run.id));
      const joined = joinHistory(history, this.liveSince);
      const received = this.liveSince.length;
      const timeline = await buildTimeline(joined);
      if (connect !== this.connects) return;
      for (const bytes of this.liveSince.slice(received)) timeline.append(bytes);
      this.liveSince = [];
      this.liveTimeline = timeline;
      this.liveView = timeline.head;
      if (this.isLiveRun.value) {
        this.shownTimeline = timeline;
        this.cursor = this.player.live.value ? undefined : timeline.seek(this.player.time.value);
      }
      this.changed();
    } catch {
      setTimeout(() => void this.loadLiveHistory(connect), historyAgainAfterMs);
    }
  }

  private takeMessage(bytes: Encoded): void {
    this.stats.messages += 1;
    let message: Message | null;
    if (this.liveTimeline) {
      message = this.liveTimeline.append(bytes);
    } else {
      message = decode(bytes);
      if (message) {
        apply(this.liveView, message);
        this.liveSince.push(bytes);
      }
    }
    if (message?.kind === 'motion') {
      this.connection.clock.see(message.motion.clockMs);
      this.stats.addMotion();
    }
    if (message?.kind === 'state') this.noticeMode(message.state);
    this.changed();
  }

  /** What STOP has brought about is over once the robot does something else. */
  private noticeMode({ mode, stopped }: RunState): void {
    if (this.stopStatus.value === 'unconfirmed' && stopped?.code === 'stop') this.stopStatus.value = 'confirmed';
    if (this.stopStatus.value === 'confirmed' && mode !== 'stopped' && mode !== 'ended') {
      if (++this.movingStates > 1) this.stopStatus.value = 'idle';
    } else {
      this.movingStates = 0;
    }
  }

  private takeDriveAck(ack: Ack): void {
    if (ack.ok) {
      if (this.drives.value) this.stopStatus.value = 'idle';
      return;
    }
    if (ack.code === 'no-answer') return;
    this.tellRefusal(ack);
    if (ack.code !== 'stale') this.dropDriving();
  }

  /** Who was refused must press anew: the robot does not start when somebody else lets go. */
  private dropDriving(): void {
    this.sampler.drop();
    this.drives.value = false;
  }

  private tellRefusal(ack: Ack | null): void {
    const driver = this.liveView.state?.driver;
    if (ack?.code === 'not-driver' && driver) this.tell(text('drive.other', { name: driver.name }), true);
    else this.tell(codeText('refused', ack?.code, ack?.why ?? text('refused.no-answer')), true);
  }

  private loseConnection(): void {
    this.dropDriving();
    this.ownClient.value = null;
    this.linkStatus.value = 'lost';
    this.changed();
  }

  /** The server has no live run any more: what has come is a recording. */
  private endLive(): void {
    this.linkStatus.value = 'recorded';
    const run = this.shownRun.value ?? this.runs.value[0]?.id;
    if (run !== undefined) void this.showRun(run);
  }

  private changed(): void {
    this.onChange();
    if (this.panelsTimer) return;
    this.panelsTimer = window.setTimeout(() => {
      this.panelsTimer = 0;
      const timeline = this.shownTimeline;
      const head = timeline?.head ?? this.liveView;
      this.span.value = { start: timeline?.start ?? 0, end: head.time, events: head.events };
      this.shown.value = { view: this.view };
    }, panelsEveryMs);
  }
}

const sliceMs = 12;

/** Leaves the page time to draw in between. */
async function buildTimeline(messages: Encoded[]): Promise<Timeline> {
  const timeline = new Timeline();
  let sliceEnd = performance.now() + sliceMs;
  for (const bytes of messages) {
    timeline.append(bytes);
    if (performance.now() > sliceEnd) {
      await new Promise((resolve) => setTimeout(resolve));
      sliceEnd = performance.now() + sliceMs;
    }
  }
  return timeline;
}

export const session = new Session();
