// SPDX-License-Identifier: MIT
// Writes FILE, a bag of ROS 2 as others write one: a robot with a sonar that turns, in a room of 3 x 2 m.
//
// usage: node write_bag.mjs FILE
import { writeFile } from "node:fs/promises";

import { parse } from "@foxglove/rosmsg";
import { MessageWriter } from "@foxglove/rosmsg2-serialization";
import { McapWriter, TempBuffer } from "@mcap/core";

const separator = "\n" + "=".repeat(80) + "\n";
const types = {
  "builtin_interfaces/Time": "int32 sec\nuint32 nanosec",
  "std_msgs/Header": "builtin_interfaces/Time stamp\nstring frame_id",
  "geometry_msgs/Vector3": "float64 x\nfloat64 y\nfloat64 z",
  "geometry_msgs/Point": "float64 x\nfloat64 y\nfloat64 z",
  "geometry_msgs/Quaternion": "float64 x\nfloat64 y\nfloat64 z\nfloat64 w",
  "geometry_msgs/Pose": "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation",
  "geometry_msgs/Twist": "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular",
  "geometry_msgs/PoseWithCovariance": "geometry_msgs/Pose pose\nfloat64[36] covariance",
  "geometry_msgs/TwistWithCovariance": "geometry_msgs/Twist twist\nfloat64[36] covariance",
  "geometry_msgs/Transform":
    "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation",
  "geometry_msgs/TransformStamped":
    "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform",
};
const messages = {
  "sensor_msgs/msg/Range":
    "std_msgs/Header header\nuint8 radiation_type\nfloat32 field_of_view\nfloat32 min_range\n" +
    "float32 max_range\nfloat32 range",
  "nav_msgs/msg/Odometry":
    "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n" +
    "geometry_msgs/TwistWithCovariance twist",
  "tf2_msgs/msg/TFMessage": "geometry_msgs/TransformStamped[] transforms",
};
const definition = (name) =>
  messages[name] +
  Object.entries(types)
    .map(([type, fields]) => `${separator}MSG: ${type}\n${fields}`)
    .join("");

const buffer = new TempBuffer();
const bag = new McapWriter({ writable: buffer });
await bag.start({ profile: "ros2", library: "somebody else" });

const topics = {};
for (const [topic, type] of [
  ["/sonar", "sensor_msgs/msg/Range"],
  ["/odom", "nav_msgs/msg/Odometry"],
  ["/tf", "tf2_msgs/msg/TFMessage"],
]) {
  const text = definition(type);
  const schemaId = await bag.registerSchema({
    name: type,
    encoding: "ros2msg",
    data: new TextEncoder().encode(text),
  });
  topics[topic] = {
    id: await bag.registerChannel({
      topic,
      messageEncoding: "cdr",
      schemaId,
      metadata: new Map([["offered_qos_profiles", ""]]),
    }),
    writer: new MessageWriter(parse(text, { ros2: true })),
    sequence: 0,
  };
}

let time_ms = 1_700_000_000_000;
const stamp = () => ({ sec: Math.floor(time_ms / 1000), nanosec: (time_ms % 1000) * 1_000_000 });
const yawed = (yaw) => ({ x: 0, y: 0, z: Math.sin(yaw / 2), w: Math.cos(yaw / 2) });
async function write(topic, message) {
  const channel = topics[topic];
  const logTime = BigInt(time_ms) * 1_000_000n;
  await bag.addMessage({
    channelId: channel.id,
    sequence: channel.sequence++,
    logTime,
    publishTime: logTime,
    data: channel.writer.writeMessage(message),
  });
}

const room = { width: 3, depth: 2 };
const rangeFrom = (x, y, yaw) =>
  Math.min(
    Math.abs((Math.cos(yaw) > 0 ? room.width - x : x) / Math.cos(yaw)),
    Math.abs((Math.sin(yaw) > 0 ? room.depth - y : y) / Math.sin(yaw)),
  );

for (let x = 0.8; x < 2.3; x += 0.3) {
  await write("/odom", {
    header: { stamp: stamp(), frame_id: "odom" },
    child_frame_id: "base_link",
    pose: {
      pose: { position: { x, y: 1, z: 0 }, orientation: yawed(0) },
      covariance: new Float64Array(36),
    },
    twist: {
      twist: { linear: { x: 0, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } },
      covariance: new Float64Array(36),
    },
  });
  for (let yaw = -Math.PI + 0.05; yaw < Math.PI; yaw += 0.1) {
    time_ms += 100;
    const header = { stamp: stamp(), frame_id: "base_link" };
    await write("/tf", {
      transforms: [
        {
          header,
          child_frame_id: "sonar",
          transform: { translation: { x: 0, y: 0, z: 0 }, rotation: yawed(yaw) },
        },
      ],
    });
    await write("/sonar", {
      header: { stamp: stamp(), frame_id: "sonar" },
      radiation_type: 0,
      field_of_view: 0.3,
      min_range: 0.03,
      max_range: 4,
      range: rangeFrom(x, 1, yaw),
    });
  }
  time_ms += 1000;
}
await bag.end();
await writeFile(process.argv[2], buffer.get());
