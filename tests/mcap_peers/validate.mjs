// SPDX-License-Identifier: MIT
// Reads an MCAP file with two readers that are not ours, by its index and as a stream, decodes all
// of its ROS 2 messages and prints what is in it as one JSON object. Exit code 1 with the reason
// where the file breaks a rule or the two readers differ.
//
// usage: node validate.mjs FILE
import { open, readFile } from "node:fs/promises";
import zlib from "node:zlib";

import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";

const STREAM_BLOCK_BYTES = 65536;
const MAX_SHOWN_ENTRIES = 8;
// A CDR payload may be padded to a multiple of four bytes.
const MAX_PADDING_BYTES = 3;

function require(holds, rule) {
  if (!holds) {
    throw new Error(rule);
  }
}

/** A message in the form that JSON can hold, its arrays shortened. */
function shown(value) {
  if (typeof value === "bigint") {
    return Number.isSafeInteger(Number(value)) ? Number(value) : value.toString();
  }
  if (typeof value === "number") {
    return Number.isFinite(value) ? value : String(value);
  }
  if (Array.isArray(value) || ArrayBuffer.isView(value)) {
    return Array.from(value).slice(0, MAX_SHOWN_ENTRIES).map(shown);
  }
  if (value !== null && typeof value === "object") {
    return Object.fromEntries(Object.entries(value).map(([key, each]) => [key, shown(each)]));
  }
  return value;
}

/** All that identifies a message, as one line. */
function line_of(message) {
  const data = Buffer.from(message.data).toString("base64");
  return `${message.channelId} ${message.sequence} ${message.logTime} ${message.publishTime} ${data}`;
}

/** What both readers collect of a file. */
class Contents {
  messages = [];
  attachments = [];
  metadata = [];

  add(record) {
    if (record.type === "Message") {
      this.messages.push(line_of(record));
    } else if (record.type === "Attachment") {
      this.attachments.push(record.name);
    } else if (record.type === "Metadata") {
      this.metadata.push(record.name);
    }
  }
  /** The order of messages differs: one reader has that of log times, the other that of the file. */
  sorted() {
    return JSON.stringify([this.messages, this.attachments, this.metadata].map((all) => all.toSorted()));
  }
}

/** Decodes the messages of the channels that are in the encoding of ROS 2, and counts all. */
class Channels {
  #by_id = new Map();

  add(channel, schema) {
    const is_ros2 = channel.messageEncoding === "cdr" && schema?.encoding === "ros2msg";
    const definition = is_ros2 ? new TextDecoder("utf-8", { fatal: true }).decode(schema.data) : undefined;
    this.#by_id.set(channel.id, {
      topic: channel.topic,
      schema: schema?.name ?? "",
      reader: is_ros2 ? new MessageReader(parse(definition, { ros2: true })) : undefined,
      messages: 0,
      first: null,
    });
  }
  decode(message) {
    const channel = this.#by_id.get(message.channelId);
    require(channel !== undefined, `a message of channel ${message.channelId}, which the summary does not have`);
    channel.messages += 1;
    if (channel.reader === undefined) {
      return;
    }
    const decoded = channel.reader.readMessage(message.data);
    const bytes_left = message.data.byteLength - channel.reader.lastReadByteLength();
    require(bytes_left <= MAX_PADDING_BYTES, `${channel.topic}: ${bytes_left} bytes behind the end of a message`);
    channel.first ??= shown(decoded);
  }
  report() {
    const topics = {};
    for (const { topic, schema, messages, first } of this.#by_id.values()) {
      require(!(topic in topics), `two channels have the topic ${topic}`);
      topics[topic] = { schema, messages, first };
    }
    return topics;
  }
}

function readable_of(file) {
  return {
    size: async () => BigInt((await file.stat()).size),
    read: async (offset, length) => {
      const block = new Uint8Array(Number(length));
      const { bytesRead } = await file.read(block, 0, block.length, Number(offset));
      require(bytesRead === block.length, `byte ${offset}: the index points behind the end of the file`);
      return block;
    },
  };
}

/** The checksum of the data section counts from the first byte of the file. */
function require_data_crc(bytes, reader) {
  if (reader.dataSectionCrc !== undefined && typeof zlib.crc32 === "function") {
    const crc = zlib.crc32(bytes.subarray(0, Number(reader.dataEndOffset)));
    require(crc === reader.dataSectionCrc, "the checksum of the data section differs");
  }
}

async function read_indexed(file, decompressHandlers, channels) {
  const reader = await McapIndexedReader.Initialize({ readable: readable_of(file), decompressHandlers });
  const contents = new Contents();
  for (const channel of reader.channelsById.values()) {
    channels.add(channel, reader.schemasById.get(channel.schemaId));
  }
  for await (const message of reader.readMessages({ validateCrcs: true })) {
    channels.decode(message);
    contents.add(message);
  }
  for await (const attachment of reader.readAttachments({ validateCrcs: true })) {
    contents.add(attachment);
  }
  for await (const metadata of reader.readMetadata()) {
    contents.add(metadata);
  }
  require(
    reader.statistics === undefined || Number(reader.statistics.messageCount) === contents.messages.length,
    "the statistics count other messages than there are",
  );
  return { reader, contents };
}

function read_streamed(bytes, decompressHandlers) {
  const reader = new McapStreamReader({ validateCrcs: true, decompressHandlers });
  const contents = new Contents();
  for (let offset = 0; offset < bytes.length; offset += STREAM_BLOCK_BYTES) {
    reader.append(bytes.subarray(offset, offset + STREAM_BLOCK_BYTES));
    for (let record = reader.nextRecord(); record !== undefined; record = reader.nextRecord()) {
      contents.add(record);
    }
  }
  require(reader.done() && reader.bytesRemaining() === 0, "the file does not end with its footer");
  return contents;
}

async function report_of(path) {
  const decompressHandlers = await loadDecompressHandlers();
  const channels = new Channels();
  const bytes = await readFile(path);
  const streamed = read_streamed(bytes, decompressHandlers);
  const file = await open(path);
  const { reader, contents } = await read_indexed(file, decompressHandlers, channels);
  await file.close();
  require_data_crc(bytes, reader);
  require(contents.sorted() === streamed.sorted(), "the index and the stream have other records");
  return {
    messages: contents.messages.length,
    channels: channels.report(),
    attachments: contents.attachments,
    metadata: contents.metadata,
    indexed_equals_streamed: true,
  };
}

if (process.argv.length !== 3) {
  console.error("usage: node validate.mjs FILE");
  process.exit(2);
}
try {
  console.log(JSON.stringify(await report_of(process.argv[2])));
} catch (error) {
  console.error(`${process.argv[2]}: ${error.message}`);
  process.exit(1);
}
