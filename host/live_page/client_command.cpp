// SPDX-License-Identifier: MIT
#include "host/live_page/client_command.hpp"

#include <map>

#include <nlohmann/json.hpp>

namespace echomap::live_page {
namespace {

using nlohmann::json;

constexpr double kMaxPlaceM = 1e4;
constexpr double kMinSpeed = 0.1;
constexpr double kMaxSpeed = 100.0;
constexpr double kMaxCableCutS = 60.0;
constexpr std::size_t kMaxNameCharacters = 40;
constexpr std::uint64_t kMaxSeq = std::uint64_t{1} << 53;  ///< What a browser's numbers hold.

/// The numbers of a command. What is missing or outside of its range is noted, and read as 0.
class CommandFields {
 public:
  explicit CommandFields(const json& object) : object_(object) {}

  double number(const char* key, double min, double max) {
    const auto found = object_.find(key);
    if (found == object_.end() || !found->is_number()) {
      return refuse(std::string(key) + " has to be a number");
    }
    const double value = found->get<double>();
    const bool is_inside = value >= min && value <= max;
    if (!is_inside) {
      return refuse(std::string(key) + " is outside of its range");
    }
    return value;
  }
  double share(const char* key) { return number(key, -1.0, 1.0); }
  double place_m(const char* key) { return number(key, -kMaxPlaceM, kMaxPlaceM); }
  Eigen::Vector2d point_m() { return {place_m("x"), place_m("y")}; }
  std::string text(const char* key) {
    const auto found = object_.find(key);
    if (found == object_.end() || !found->is_string()) {
      refuse(std::string(key) + " has to be a text");
      return {};
    }
    return found->get<std::string>();
  }
  double refuse(const std::string& why) {
    why_ = why_.empty() ? why : why_;
    return 0.0;
  }
  /// Empty where all is well.
  const std::string& why() const { return why_; }

 private:
  const json& object_;
  std::string why_;
};

ClientRequest read_drive(CommandFields& fields) {
  const double forward = fields.share("forward");
  const double turn = fields.share("turn");
  return Drive{{forward, turn}, fields.number("seen", 0.0, 1e15)};
}

ClientRequest read_pose(CommandFields& fields) {
  const Eigen::Vector2d at_m = fields.point_m();
  const double heading = fields.number("heading", -1e3, 1e3);
  return session::PlaceRobot{geometry::Pose2(at_m.x(), at_m.y(), heading)};
}

ClientRequest read_speed(CommandFields& fields) {
  const double factor = fields.number("factor", 0.0, kMaxSpeed);
  if (factor > 0.0 && factor < kMinSpeed) {
    fields.refuse("factor is outside of its range");
  }
  return session::SetSpeed{factor};
}

ClientRequest read_name(CommandFields& fields) {
  const std::string name = fields.text("name");
  const std::string cleaned = cleaned_name(name, kMaxNameCharacters + 1);
  if (cleaned_name(cleaned, kMaxNameCharacters) != cleaned) {
    fields.refuse("name is longer than 40 characters");
  }
  return NameClient{cleaned};
}

using ReadCommand = ClientRequest (*)(CommandFields&);

const std::map<std::string, ReadCommand, std::less<>>& commands() {
  static const std::map<std::string, ReadCommand, std::less<>> readers{
      {"drive", read_drive},
      {"release", [](CommandFields&) -> ClientRequest { return ReleaseLock{}; }},
      {"explore", [](CommandFields&) -> ClientRequest { return session::ResumeStrategy{}; }},
      {"go",
       [](CommandFields& fields) -> ClientRequest { return session::GoTo{fields.point_m()}; }},
      {"moved", [](CommandFields&) -> ClientRequest { return session::ReportMoved{}; }},
      {"pose", read_pose},
      {"speed", read_speed},
      {"carry-off", [](CommandFields&) -> ClientRequest { return session::CarryOff{}; }},
      {"box",
       [](CommandFields& fields) -> ClientRequest { return session::PutBox{fields.point_m()}; }},
      {"cut-cable",
       [](CommandFields& fields) -> ClientRequest {
         return session::CutCable{fields.number("seconds", 0.0, kMaxCableCutS)};
       }},
      {"name", read_name},
      {"ping", [](CommandFields&) -> ClientRequest { return AskClock{}; }},
  };
  return readers;
}

/// Of the object, where it is a number that a client can count with.
std::optional<std::uint64_t> seq_of(const json& object) {
  const auto found = object.find("seq");
  if (found == object.end() || !found->is_number_unsigned()) {
    return std::nullopt;
  }
  const auto seq = found->get<std::uint64_t>();
  return seq <= kMaxSeq ? std::optional(seq) : std::nullopt;
}

ClientRequest read_request(const json& object, const std::string& name) {
  const auto reader = commands().find(name);
  if (reader == commands().end()) {
    return Refusal{RefusalCode::kUnknown, "there is no such command"};
  }
  CommandFields fields(object);
  ClientRequest request = reader->second(fields);
  if (object.contains("seq") && !seq_of(object)) {
    fields.refuse("seq has to be a whole number");
  }
  if (!fields.why().empty()) {
    return Refusal{RefusalCode::kMalformed, fields.why()};
  }
  return request;
}

/// Of a UTF-8 character, by its first byte; 0 for none.
std::size_t length_by_first_byte(unsigned first) {
  if (first < 0x80) {
    return 1;
  }
  if (first < 0xC2 || first > 0xF4) {
    return 0;
  }
  if (first < 0xE0) {
    return 2;
  }
  return first < 0xF0 ? 3 : 4;
}

/// Of the UTF-8 character that begins there; 0 where none does.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  const std::size_t length = length_by_first_byte(first);
  if (length > text.size()) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) {
      return 0;
    }
  }
  const bool is_overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool is_beyond = (first == 0xED && byte(1) >= 0xA0) || (first == 0xF4 && byte(1) >= 0x90);
  return is_overlong || is_beyond ? 0 : length;
}

/// ASCII's, and U+0080 to U+009F.
bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  return first < 0x20 || first == 0x7F ||
         (first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0);
}

}  // namespace

std::string_view name_of(RefusalCode code) {
  switch (code) {
    case RefusalCode::kUnknown:
      return "unknown";
    case RefusalCode::kMalformed:
      return "malformed";
    case RefusalCode::kNotPossible:
      return "not-possible";
    case RefusalCode::kStale:
      return "stale";
    case RefusalCode::kNotDriver:
      return "not-driver";
    case RefusalCode::kBusy:
      return "busy";
  }
  return "unknown";
}

ClientCommand parse_command(std::string_view text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) {
    return {{}, {}, Refusal{RefusalCode::kMalformed, "a command is a JSON object"}};
  }
  const std::optional<std::uint64_t> seq = seq_of(object);
  const auto named = object.find("do");
  if (named == object.end() || !named->is_string()) {
    return {seq, {}, Refusal{RefusalCode::kMalformed, "do has to be a text"}};
  }
  const auto name = named->get<std::string>();
  if (name == "stop") {
    return {seq, name, session::OperatorCommand(session::StopRobot{})};
  }
  return {seq, name, read_request(object, name)};
}

std::string cleaned_name(std::string_view text, std::size_t max_characters) {
  std::string cleaned;
  for (std::size_t count = 0; !text.empty() && count < max_characters;) {
    const std::size_t length = character_length(text);
    if (length > 0 && !is_control(text.substr(0, length))) {
      cleaned += text.substr(0, length);
      ++count;
    }
    text.remove_prefix(length > 0 ? length : 1);
  }
  return cleaned;
}

}  // namespace echomap::live_page
