// SPDX-License-Identifier: MIT
// Writes an MCAP file with a writer that is not ours: an attachment, metadata and twenty messages
// "line N" on the topic /log, in chunks or without.
//
// usage: node write.mjs FILE chunked|loose
import { writeFile } from "node:fs/promises";

import { McapWriter, TempBuffer } from "@mcap/core";

const MESSAGES = 20;
const CHUNK_BYTES = 200;

const [path, form] = process.argv.slice(2);
const encoder = new TextEncoder();
const buffer = new TempBuffer();
const writer = new McapWriter({ writable: buffer, useChunks: form === "chunked", chunkSize: CHUNK_BYTES });
await writer.start({ profile: "ros2", library: "a peer" });
const schemaId = await writer.registerSchema({
  name: "std_msgs/msg/String",
  encoding: "ros2msg",
  data: encoder.encode("string data"),
});
const channelId = await writer.registerChannel({
  schemaId,
  topic: "/log",
  messageEncoding: "text",
  metadata: new Map([["qos", "reliable"]]),
});
await writer.addAttachment({
  logTime: 1n,
  createTime: 2n,
  name: "config.toml",
  mediaType: "text/plain",
  data: encoder.encode("a = 1"),
});
await writer.addMetadata({ name: "session", metadata: new Map([["seed", "7"]]) });
for (let i = 0; i < MESSAGES; ++i) {
  const logTime = BigInt(1000 * i);
  await writer.addMessage({ channelId, sequence: i, logTime, publishTime: logTime, data: encoder.encode(`line ${i}`) });
}
await writer.end();
await writeFile(path, buffer.get());
