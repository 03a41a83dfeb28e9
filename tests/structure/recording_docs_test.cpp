// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/structure/source_tree.hpp"
#include "tests/structure/tree_root.hpp"

// The guide to recordings and its layout name topics: they are those that the recorder writes.
namespace echomap::structure {
namespace {

using nlohmann::json;
using testing::IsEmpty;
using testing::IsSupersetOf;
using Names = std::set<std::string>;

/// The topics in quotes in the sources of host/recording.
Names recorded_topics() {
  static const std::regex topic("\"(/[a-z][a-z_/]*)\"");
  Names topics;
  for (const auto& entry : std::filesystem::directory_iterator(tree_root / "host/recording")) {
    for (const std::string& line : read_lines(entry.path())) {
      for (std::sregex_iterator match(line.begin(), line.end(), topic), end; match != end;
           ++match) {
        topics.insert((*match)[1]);
      }
    }
  }
  return topics;
}

json layout() {
  std::ifstream file(tree_root / "docs/guides/recording_layout.json");
  return json::parse(file);
}

/// Adds `text` without the field behind it, if it is a topic.
void add_topic(const std::string& text, Names& topics) {
  if (text.rfind('/', 0) == 0) {
    topics.insert(text.substr(0, text.find('.')));
  }
}

/// Adds every topic that is a key or a value in `node`.
void add_topics(const json& node, Names& topics) {
  if (node.is_string()) {
    add_topic(node.get<std::string>(), topics);
  } else if (node.is_structured()) {
    for (const auto& item : node.items()) {
      if (node.is_object()) {
        add_topic(item.key(), topics);
      }
      add_topics(item.value(), topics);
    }
  }
}

/// Adds the panels that are placed in `node` of a layout.
void add_panels(const json& node, Names& panels) {
  if (node.is_string()) {
    panels.insert(node.get<std::string>());
    return;
  }
  add_panels(node.at("first"), panels);
  add_panels(node.at("second"), panels);
}

TEST(RecordingLayout, ShowsTopicsThatAreRecorded) {
  Names shown;
  add_topics(layout().at("configById"), shown);
  EXPECT_GE(shown.size(), 8U);
  EXPECT_THAT(recorded_topics(), IsSupersetOf(shown));
}

TEST(RecordingLayout, PlacesEveryPanelThatItConfigures) {
  const json file = layout();
  Names configured;
  for (const auto& panel : file.at("configById").items()) {
    configured.insert(panel.key());
  }
  Names placed;
  add_panels(file.at("layout"), placed);
  EXPECT_EQ(placed, configured);
}

TEST(RecordingGuide, NamesEveryTopicThatIsRecorded) {
  std::string guide;
  for (const std::string& line : read_lines(tree_root / "docs/guides/recording.md")) {
    guide += line + "\n";
  }
  std::vector<std::string> missing;
  for (const std::string& topic : recorded_topics()) {
    if (guide.find("`" + topic + "`") == std::string::npos) {
      missing.push_back(topic);
    }
  }
  EXPECT_THAT(missing, IsEmpty());
}

}  // namespace
}  // namespace echomap::structure
