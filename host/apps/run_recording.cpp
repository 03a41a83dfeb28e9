// SPDX-License-Identifier: MIT
#include "host/apps/run_recording.hpp"

#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/recording/session_file.hpp"
#include "host/session/firmware_name.hpp"
#include "protocol/config_digest.hpp"
#include "protocol/messages.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;

/// Files of a run directory that the recording takes along, and what they are.
constexpr std::pair<const char*, const char*> kAttached[] = {
    {"map.pgm", "image/x-portable-graymap"},
    {"map.yaml", "application/yaml"},
    {"map.png", "image/png"},
    {"outline.geojson", "application/geo+json"},
};

std::map<std::string, std::string> facts_of(const session::RobotContext& robot,
                                            const std::string& command,
                                            const exports::RunSummary& summary) {
  const auto& link = robot.session().link();
  const auto& described = link.robot();
  return {
      {"version", ECHOMAP_VERSION},
      {"command", command},
      {"robot", robot.profile().name},
      {"strategy", summary.strategy},
      {"slam", summary.slam},
      {"seed", std::to_string(robot.seed().number())},
      {"world", summary.world},
      {"emulator", summary.emulator},
      {"firmware", described ? session::firmware_of(*described) : ""},
      {"firmware_schema_digest",
       described ? fmt::format("{:08x}", described->schema_digest) : std::string()},
      {"host_schema_digest", fmt::format("{:08x}", protocol::kSchemaDigest)},
      {"configuration_digest",
       fmt::format("{:08x}", protocol::config_digest(robot.profile().configuration))},
  };
}

std::map<std::string, std::string> ending_of_report(const nlohmann::ordered_json& report) {
  std::map<std::string, std::string> facts;
  for (const char* key : {"outcome", "finished", "why", "next"}) {
    const auto value = report.value(key, nlohmann::ordered_json());
    facts[key] = value.is_string() ? value.get<std::string>() : value.dump();
  }
  return facts;
}

}  // namespace

void begin_recording(session::RobotContext& robot,
                     const std::string& command,
                     const exports::RunSummary& summary,
                     const fs::path& out,
                     std::uint64_t split_bytes) {
  robot.recorder().describe("session", facts_of(robot, command, summary));
  robot.recorder().open(out / recording::kSessionFileName, split_bytes);
}

void end_recording(session::RobotContext& robot,
                   const nlohmann::ordered_json& report,
                   const fs::path& out) {
  recording::SessionRecorder& recorder = robot.recorder();
  if (recorder.path().empty()) {
    return;
  }
  nlohmann::ordered_json lasting = report;
  lasting.erase("wall_seconds");
  recorder.attach("summary.json", "application/json", lasting.dump(2) + "\n");
  for (const auto& [name, media_type] : kAttached) {
    if (exists(out / name)) {
      recorder.attach(name, media_type, files::read_text_file(out / name));
    }
  }
  recorder.describe_ending(ending_of_report(report));
  recorder.finish();
}

}  // namespace echomap::apps
