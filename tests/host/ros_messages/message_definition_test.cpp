// SPDX-License-Identifier: MIT
#include "host/ros_messages/message_definition.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/all_ros_messages.hpp"

namespace echomap::ros_messages {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;

const std::string separator = std::string(80, '=') + "\nMSG: ";

TEST(MessageDefinition, OfAFlatMessageIsItsFields) {
  EXPECT_EQ(message_definition<Point>(), "float64 x\nfloat64 y\nfloat64 z\n");
}

TEST(MessageDefinition, HasNestedMessagesBehindALine) {
  EXPECT_EQ(message_definition<TransformStamped>(),
            "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n" +
                separator + "std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" +
                separator + "builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" + separator +
                "geometry_msgs/Transform\ngeometry_msgs/Vector3 translation\n"
                "geometry_msgs/Quaternion rotation\n" +
                separator + "geometry_msgs/Vector3\nfloat64 x\nfloat64 y\nfloat64 z\n" + separator +
                "geometry_msgs/Quaternion\nfloat64 x\nfloat64 y\nfloat64 z\nfloat64 w\n");
}

TEST(MessageDefinition, MarksSequencesAndArrays) {
  EXPECT_THAT(message_definition<PoseWithCovariance>(), HasSubstr("\nfloat64[36] covariance\n"));
  EXPECT_THAT(message_definition<JointState>(), HasSubstr("\nstring[] name\nfloat64[] position\n"));
  EXPECT_THAT(message_definition<PoseArray>(), HasSubstr("\ngeometry_msgs/Pose[] poses\n"));
  EXPECT_THAT(message_definition<OccupancyGrid>(), HasSubstr("\nint8[] data\n"));
}

/// Every type of numbers, named as ROS names it.
struct Numbers {
  static constexpr std::string_view kName = "test/msg/Numbers";
  template <class M, class V>
  static void fields(M& /*self*/, V& visit) {
    visit("a", bool{});
    visit("b", std::byte{});
    visit("c", char{});
    visit("d", std::int8_t{});
    visit("e", std::uint8_t{});
    visit("f", std::int16_t{});
    visit("g", std::uint16_t{});
    visit("h", std::int32_t{});
    visit("i", std::uint32_t{});
    visit("j", std::int64_t{});
    visit("k", std::uint64_t{});
    visit("l", float{});
    visit("m", double{});
  }
};

TEST(MessageDefinition, NamesNumbersAsRosDoes) {
  EXPECT_EQ(message_definition<Numbers>(),
            "bool a\nbyte b\nchar c\nint8 d\nuint8 e\nint16 f\nuint16 g\nint32 h\nuint32 i\n"
            "int64 j\nuint64 k\nfloat32 l\nfloat64 m\n");
}

/// The names behind `MSG: `, in order.
std::vector<std::string> nested_in(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("MSG: ")) {
      names.push_back(line.substr(5));
    }
  }
  return names;
}

/// The types of fields that are of a package.
std::set<std::string> types_in(const std::string& text) {
  std::set<std::string> types;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string type = line.substr(0, line.find_first_of(" ["));
    if (type.find('/') != std::string::npos) {
      types.insert(type);
    }
  }
  return types;
}

TEST(MessageDefinition, HasEveryNestedTypeOnce) {
  tests::AllRosMessages::for_each([]<class M>() {
    const std::string text = message_definition<M>();
    const std::vector<std::string> nested = nested_in(text);
    const std::set<std::string> names(nested.begin(), nested.end());
    EXPECT_EQ(names.size(), nested.size()) << M::kName;
    EXPECT_EQ(names, types_in(text)) << M::kName;
  });
}

TEST(MessageDefinition, FollowsNestingToItsEnd) {
  EXPECT_THAT(nested_in(message_definition<MarkerArray>()),
              IsSupersetOf({"visualization_msgs/Marker",
                            "std_msgs/Header",
                            "builtin_interfaces/Time",
                            "builtin_interfaces/Duration",
                            "sensor_msgs/CompressedImage",
                            "visualization_msgs/UVCoordinate",
                            "visualization_msgs/MeshFile"}));
}

TEST(MessageDefinition, EveryNameHasAPackageAndIsThereOnce) {
  std::set<std::string_view> names;
  tests::AllRosMessages::for_each([&names]<class M>() {
    EXPECT_THAT(std::string(M::kName), testing::MatchesRegex("[a-z0-9_]+/msg/[A-Z][A-Za-z0-9]*"));
    EXPECT_TRUE(names.insert(M::kName).second) << M::kName;
  });
}

}  // namespace
}  // namespace echomap::ros_messages
