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
}

/** The server's first words. */
export interface Welcome {
  /** The number by which it names this client. */
  client: number;
}

/** Null for what is neither. */
export function decodeText(text: string): Ack | Welcome | null {
  try {
    const value = JSON.parse(text) as Partial<Ack & Welcome> | null;
    const isAck = typeof value?.ack === 'number' && typeof value.ok === 'boolean';
    return isAck || typeof value?.client === 'number' ? (value as Ack | Welcome) : null;
  } catch {
    return null;
  }
}
