// SPDX-License-Identifier: MIT
import { type Ack, type Command, decodeText } from './commands';
import { ServerClock } from './server_clock';

const pingEveryMs = 500;
const silentAfterMs = 2500;
const ackWithinMs = 3000;
const minRetryMs = 300;
const maxRetryMs = 3000;

export interface ConnectionListener {
  onOpen(): void;
  /** The number by which the server names this client. */
  onNumber(client: number): void;
  onMessage(bytes: Uint8Array): void;
  onLost(): void;
  /** Whether a run is live; rejects where nobody answers. */
  isLive(): Promise<boolean>;
}

interface Waiting {
  resolve: (ack: Ack) => void;
  timer: number;
}

/** The WebSocket to the server: it comes back by itself, and asks for the server's clock. */
export class Connection {
  readonly clock = new ServerClock();
  private socket: WebSocket | null = null;
  private sequence = 0;
  private readonly waiting = new Map<number, Waiting>();
  private retryMs = minRetryMs;
  private retryTimer = 0;
  private lastHeardMs = 0;
  private active = false;

  constructor(private readonly listener: ConnectionListener) {
    setInterval(() => this.keepAlive(), pingEveryMs);
  }

  get isOpen(): boolean {
    return this.socket?.readyState === WebSocket.OPEN;
  }

  /** Bytes that the browser has not sent yet. */
  get bufferedBytes(): number {
    return this.socket?.bufferedAmount ?? 0;
  }

  start(): void {
    if (this.active) return;
    this.active = true;
    this.open();
  }

  /** By the socket, or by a POST where that is closed. Never rejects: without an answer it says so. */
  send(command: Command): Promise<Ack> {
    const sequence = ++this.sequence;
    const { socket } = this;
    if (!socket || socket.readyState !== WebSocket.OPEN) return this.post(command, sequence);
    socket.send(JSON.stringify({ ...command, seq: sequence }));
    return new Promise((resolve) => {
      const timer = window.setTimeout(() => {
        this.waiting.delete(sequence);
        resolve(unanswered(sequence));
      }, ackWithinMs);
      this.waiting.set(sequence, { resolve, timer });
    });
  }

  /** By the socket alone: who does not see the robot must not set it off. Null where it is closed. */
  sendNow(command: Command): Promise<Ack> | null {
    return this.isOpen ? this.send(command) : null;
  }

  post(command: Command, sequence = ++this.sequence): Promise<Ack> {
    return fetch('api/v1/commands', {
      method: 'POST',
      headers: { 'Content-Type': 'application/json' },
      body: JSON.stringify({ ...command, seq: sequence }),
      keepalive: true,
    })
      .then(async (response) => {
        const words = decodeText(await response.text());
        return words && 'ack' in words ? words : unanswered(sequence);
      })
      .catch(() => unanswered(sequence));
  }

  private open(): void {
    const url = new URL('ws', document.baseURI);
    url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
    const socket = new WebSocket(url, 'echomap.v1');
    socket.binaryType = 'arraybuffer';
    this.socket = socket;
    this.lastHeardMs = performance.now();
    socket.onopen = () => {
      this.clock.reset();
      this.lastHeardMs = performance.now();
      this.listener.onOpen();
      this.ping();
    };
    socket.onmessage = ({ data }: MessageEvent<ArrayBuffer | string>) => {
      this.lastHeardMs = performance.now();
      this.retryMs = minRetryMs;
      if (typeof data !== 'string') {
        this.listener.onMessage(new Uint8Array(data));
        return;
      }
      const words = decodeText(data);
      if (!words) return;
      if ('ack' in words) this.settle(words);
      else this.listener.onNumber(words.client);
    };
    socket.onclose = () => this.lose(socket);
  }

  private lose(socket: WebSocket): void {
    if (this.socket !== socket) return;
    this.socket = null;
    for (const sequence of [...this.waiting.keys()]) this.settle(unanswered(sequence));
    this.listener.onLost();
    this.retry();
  }

  private retry(): void {
    clearTimeout(this.retryTimer);
    this.retryTimer = window.setTimeout(() => {
      this.listener.isLive().then(
        (live) => {
          if (live) this.open();
          else this.active = false;
        },
        () => this.retry(),
      );
    }, this.retryMs);
    this.retryMs = Math.min(maxRetryMs, this.retryMs * 1.6);
  }

  private keepAlive(): void {
    const { socket } = this;
    if (!socket) return;
    if (performance.now() - this.lastHeardMs > silentAfterMs) {
      socket.onclose = null;
      socket.close();
      this.lose(socket);
    } else if (this.isOpen) {
      this.ping();
    }
  }

  private ping(): void {
    const sentMs = performance.now();
    void this.send({ do: 'ping' }).then(({ clock }) => {
      if (clock !== undefined) this.clock.addPong(sentMs, performance.now(), clock);
    });
  }

  private settle(ack: Ack): void {
    const waiting = this.waiting.get(ack.ack);
    if (!waiting) return;
    this.waiting.delete(ack.ack);
    clearTimeout(waiting.timer);
    waiting.resolve(ack);
  }
}

function unanswered(sequence: number): Ack {
  return { ack: sequence, ok: false, code: 'no-answer' };
}
