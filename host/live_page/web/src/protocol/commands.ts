// SPDX-License-Identifier: MIT

export type Command =
  | { do: 'stop' | 'release' | 'explore' | 'moved' | 'carry-off' | 'ping' }
  | { do: 'drive'; forward: number; turn: number; seen: number }
  | { do: 'go' | 'box'; x: number; y: number }
  | { do: 'pose'; x: number; y: number; heading: number }
  | { do: 'speed'; factor: number }
  | { do: 'cut-cable'; seconds: number }
  | { do: 'name'; name: string };

export interface Ack {
  ack: number;
  ok: boolean;
  why?: string;
  code?: string;
  /** Of a ping: the server's clock, milliseconds. */
  clock?: number;
  /** Of a name: this client's number. */
  client?: number;
}

export function decodeAck(text: string): Ack | null {
  try {
    const value: unknown = JSON.parse(text);
    if (typeof value !== 'object' || value === null) return null;
    const { ack, ok } = value as Partial<Ack>;
    return typeof ack === 'number' && typeof ok === 'boolean' ? (value as Ack) : null;
  } catch {
    return null;
  }
}
