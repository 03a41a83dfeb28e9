// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace echomap::recording {

/// Name of the file beside a recording that makes its folder a bag of ROS 2.
inline constexpr const char* kBagMetadataName = "metadata.yaml";

/// What a recording holds, as the metadata.yaml of a ROS 2 bag says it (rosbag2, version 5): tools
/// that open folders look for it.
class BagMetadata {
 public:
  /// Messages that are added from here on are in that file of the folder.
  void begin_part(const std::string& file_name);
  void add(std::string_view topic, std::string_view type, std::uint64_t time_ns);

  std::string yaml() const;

 private:
  struct Span {
    std::uint64_t begin_ns = 0;
    std::uint64_t end_ns = 0;
    std::uint64_t messages = 0;

    void add(std::uint64_t time_ns);
  };
  struct Part {
    std::string file_name;
    Span span;
  };
  struct Topic {
    std::string type;
    std::uint64_t messages = 0;
  };

  Span span_;
  std::vector<Part> parts_;
  std::map<std::string, Topic, std::less<>> topics_;
};

}  // namespace echomap::recording
