// SPDX-License-Identifier: MIT
// Connects to a server of the Foxglove WebSocket protocol by a client that is not ours, subscribes to
// each channel as soon as it is advertised, decodes all messages as ROS 2 messages and prints after
// some seconds what has come, as one JSON object. Exit code 1 with the reason where there is no
// connection or a message cannot be decoded.
//
// usage: node foxglove_client.mjs URL SECONDS [SUB_PROTOCOL]
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import ws_protocol from "@foxglove/ws-protocol";
import WebSocket from "ws";

const { FoxgloveClient } = ws_protocol;

// A CDR payload may be padded to a multiple of four bytes.
const MAX_PADDING_BYTES = 3;
const MAX_SHOWN_ERRORS = 8;

/** What a client hears of a server. */
class Summary {
  sub_protocol = "";
  server_info = null;
  topics = {};
  times = 0;
  times_back = 0;
  statuses = [];
  decode_errors = [];
  #last_time = undefined;

  add_time(timestamp) {
    this.times += 1;
    if (this.#last_time !== undefined && timestamp < this.#last_time) {
      this.times_back += 1;
    }
    this.#last_time = timestamp;
  }
  add_error(text) {
    if (this.decode_errors.length < MAX_SHOWN_ERRORS) {
      this.decode_errors.push(text);
    }
  }
}

/** A channel that is subscribed to. */
class Channel {
  #reader;
  #topic;
  #last_time = 0n;

  constructor(channel, summary) {
    const definition = parse(channel.schema, { ros2: true });
    this.#reader = new MessageReader(definition);
    this.#topic = {
      id: channel.id,
      schema: channel.schemaName,
      encoding: channel.encoding,
      schema_encoding: channel.schemaEncoding,
      messages: 0,
      bytes: 0,
      times_back: 0,
    };
    summary.topics[channel.topic] = this.#topic;
  }
  decode({ data, timestamp }) {
    this.#topic.messages += 1;
    this.#topic.bytes += data.byteLength;
    this.#topic.times_back += timestamp < this.#last_time ? 1 : 0;
    this.#last_time = timestamp;
    this.#reader.readMessage(data);
    const bytes_left = data.byteLength - this.#reader.lastReadByteLength();
    if (bytes_left > MAX_PADDING_BYTES) {
      throw new Error(`${bytes_left} bytes behind the end of a message`);
    }
  }
}

function listen(client, summary) {
  const by_subscription = new Map();
  client.on("serverInfo", (info) => {
    summary.server_info = info;
  });
  client.on("status", ({ level, message }) => {
    summary.statuses.push({ level, message });
  });
  client.on("time", ({ timestamp }) => {
    summary.add_time(timestamp);
  });
  client.on("advertise", (channels) => {
    for (const channel of channels) {
      try {
        const one = new Channel(channel, summary);
        by_subscription.set(client.subscribe(channel.id), { one, name: channel.topic });
      } catch (error) {
        summary.add_error(`${channel.topic}: schema: ${error.message}`);
      }
    }
  });
  client.on("message", (message) => {
    const channel = by_subscription.get(message.subscriptionId);
    try {
      channel.one.decode(message);
    } catch (error) {
      summary.add_error(`${channel?.name ?? `subscription ${message.subscriptionId}`}: ${error.message}`);
    }
  });
}

/** Resolves after so many seconds of a connection, or where it breaks. */
async function summary_of(url, seconds, sub_protocol) {
  const summary = new Summary();
  const socket = new WebSocket(url, [sub_protocol]);
  const client = new FoxgloveClient({ ws: socket });
  listen(client, summary);
  await new Promise((resolve, reject) => {
    client.on("open", () => {
      summary.sub_protocol = socket.protocol;
      setTimeout(resolve, seconds * 1000);
    });
    client.on("error", reject);
    client.on("close", resolve);
  });
  client.close();
  return summary;
}

const [url, seconds, sub_protocol = FoxgloveClient.SUPPORTED_SUBPROTOCOL] = process.argv.slice(2);
if (url === undefined || !(Number(seconds) > 0)) {
  console.error("usage: node foxglove_client.mjs URL SECONDS [SUB_PROTOCOL]");
  process.exit(2);
}
try {
  const summary = await summary_of(url, Number(seconds), sub_protocol);
  console.log(JSON.stringify(summary));
  process.exitCode = summary.decode_errors.length > 0 ? 1 : 0;
} catch (error) {
  console.error(`${url}: ${error.message}`);
  process.exitCode = 1;
}
