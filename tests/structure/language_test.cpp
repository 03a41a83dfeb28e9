// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/structure/file_rules.hpp"
#include "tests/structure/source_tree.hpp"
#include "tests/structure/tree_root.hpp"

// Names and messages are in the words of the field: what is in the left column of the table below
// had a term already, which is in the right one. Sources, settings and documents hold none of them.
namespace echomap::structure {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

const std::string this_file = "tests/structure/language_test.cpp";

/// A word of our own making and what to write instead.
struct Replacement {
  std::string_view hint;     ///< In every line that the pattern finds.
  std::string_view pattern;  ///< ECMAScript.
  std::string_view instead;
};

/// A file that has to write a word that the table replaces.
struct Exception {
  std::string_view path;
  std::string_view hint;  ///< Of the word's entry in the table.
  std::string_view reason;
};

constexpr Exception kExceptions[] = {
    {"host/apps/saved_map.cpp", "former_", "reads the folders of runs of an older version"},
    {"tests/host/apps/saved_map_test.cpp", "former_", "makes such folders"},
};

bool is_excepted(const SourceFile& file, const Replacement& word) {
  return std::any_of(std::begin(kExceptions), std::end(kExceptions), [&](const Exception& each) {
    return each.path == file.path && each.hint == word.hint;
  });
}

// clang-format off
constexpr Replacement kReplacements[] = {
    // Names.
    {"most_", R"(\bmost_(particles|stops|cells|range_m|points|iterations|s|m|rad)\b)", "max_particles, max_stops, .."},
    {"least_", R"(\bleast_(particles|points|echoes|readings|turn_rad|gain_m2|m|rad)\b)", "min_particles, min_points, .."},
    {"widest_", R"(\bwidest_(m|rad|gap_m|gap_rad)\b)", "max_gap_m, .."},
    {"farthest_", R"(\bfarthest_(m|rad|deg|cdeg|off_m)\b)", "max_range_m, .."},
    {"kMost", R"(\bkMost[A-Z]\w*)", "kMaxCells, .."},
    {"kLeast", R"(\bkLeast[A-Z]\w*)", "kMinReadings, .."},
    {"_sd", R"([a-z]_sd(_[a-z]\w*)?\b)", "_stddev, as range_stddev_m"},
    {"_std", R"([a-z]_std(_[a-z]\w*)?\b(?!::))", "_stddev, as range_stddev_m"},
    {"Sd", R"([a-z]Sd(M|Rad|Share|Factor)\b)", "kRangeStddevM"},
    {"Std", R"([a-z]Std(M|Rad)\b)", "kRangeStddevM"},
    {"_opening", R"(\b(half|beam|cone)_opening(s|_\w+)?\b)", "beam_half_angle_rad, beam_width_rad"},
    {"ConeOpening", R"(\bConeOpening\b)", "BeamWidth"},
    {"way_m", R"(\b(\w+_)?way_m_?\b)", "distance_m, travelled_m, path_m or offset_m"},
    {"by_pose", R"(\bby_pose\b)", "jacobian_pose"},
    {"by_landmark", R"(\bby_landmark\b)", "jacobian_landmark"},
    {"where_few", R"(\bresample_where_few_count\b)", "resample_if_needed"},
    {"surprise_", R"(\b(least_)?surprise_(of|at)\b)", "negative_log_evidence, nees or mahalanobis"},
    {"kernel_share", R"(\bkernel_share\b)", "robust_weight"},
    {"OdometryBelief", R"(\bOdometryBelief\b)", "OdometryNoiseHypothesis"},
    {"OdometryTrust", R"(\bOdometryTrust\b)", "OdometryNoisePrior"},
    {"_by_", R"(\b(turn|drive|side|speed|final)_by_(turn|drive|speed)(_\w+)?\b)", "alpha1 .. alpha6 (Thrun et al. 2005)"},
    {"move_past", R"(\bmove_past\b)", "apply_corrected_trajectory"},
    {"aslant", R"(\b(is_aslant|aslant_\w+)\b)", "is_oblique, oblique_missed_chance"},
    {"NearMapper", R"(\bNearMapper\w*)", "ContactMapper"},
    {"near_mapper", R"(\bnear_mapper\b)", "contact_mapper"},
    {"near_grid", R"(\bnear_grid_?\b)", "contact grid"},
    {"far_grid", R"(\bfar_grid_?\b)", "sonar grid"},
    {"KeptWay", R"(\bKeptWay\w*)", "PoseHistory"},
    {"kept_way", R"(\bkept_way\b)", "pose_history"},
    {"LandmarkSlamByBeams", R"(\bLandmarkSlamByBeams\b)", "EkfSlam"},
    {"RunKeeper", R"(\bRunKeeper\w*)", "RunWriter"},
    {"Teller", R"(\b(Maps|Progress)Teller\w*)", "AtlasReporter, ProgressReporter"},
    {"riven", R"(\b(DrivenRobot|driven_robot)\b)", "RobotContext"},
    {"former_", R"(\b(T_)?former_[a-z0-9]\w*)", "previous_1, previous_maps"},
    {"FormerMap", R"(\bFormerMap\b)", "PreviousMap"},
    {"_anew", R"(\b(begins?|starts?)_anew_?\b)", "begin_new_map, start_again"},
    // Messages, comments and pages.
    {" anew", R"(\b([Ss]tarts?|[Bb]egins?|[Bb]egun|[Bb]egan) anew\b)", "start again"},
    {"drawn anew", R"(\bdrawn anew\b)", "resampled"},
    {"goes on with {", R"(\bgoes on with \{)", "resuming {}"},
    {"stands for none", R"(\bstands for none\b)", "an assertion or a type"},
    {"where few count", R"(\bwhere few count\b)", "if the effective sample size is low"},
    {"without sense", R"(\bwithout sense\b)", "invalid"},
    {"make no sense", R"(\bthat make no sense\b)", "that are invalid"},
    {"outside of its range", R"(\ba parameter is outside of its range\b)",
     "field, value and range: geometry::ParameterValidator"},
    {"every parameter", R"(\bevery parameter is above 0\b)", "field, value and range: geometry::ParameterValidator"},
    {"the map of before", R"(\bin the map of before\b)", "relocalized in the previous map"},
    {"look for itself", R"(\bdid not look for itself\b)", "relocalization stopped early"},
    {"wherever it looks", R"(\bone range wherever it looks\b)", "the same range in every direction"},
    {"all before it is", R"(\bis cut off, and all before it is read\b)",
     "is incomplete; everything before it was read"},
    {"--slam grid", R"(--slam grid\b)", "--slam multiscan"},
};
// clang-format on

/// Every text that a reader of the product may see: sources, settings and documents.
std::vector<SourceFile> texts() {
  std::vector<SourceFile> files = read_source_tree(tree_root);
  for (const char* folder : {"docs", "host", "hil_mock"}) {
    for (const auto& entry : fs::recursive_directory_iterator(tree_root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (entry.is_regular_file() && (extension == ".md" || extension == ".toml")) {
        files.push_back({entry.path().lexically_relative(tree_root).generic_string(),
                         read_lines(entry.path())});
      }
    }
  }
  for (const char* name : {"README.md", "CONTRIBUTING.md"}) {
    files.push_back({name, read_lines(tree_root / name)});
  }
  return files;
}

/// What one rule finds in one file.
void find_words(const SourceFile& file, const Replacement& word, Problems& problems) {
  const std::regex pattern(word.pattern.begin(), word.pattern.end());
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    std::smatch found;
    if (file.lines[i].find(word.hint) != std::string::npos &&
        std::regex_search(file.lines[i], found, pattern)) {
      problems.push_back(file.path + ":" + std::to_string(i + 1) + ": '" + found.str() +
                         "'; write " + std::string(word.instead));
    }
  }
}

Problems language_problems(const std::vector<SourceFile>& files) {
  Problems problems;
  for (const SourceFile& file : files) {
    if (file.path == this_file) {
      continue;
    }
    for (const Replacement& word : kReplacements) {
      if (!is_excepted(file, word)) {
        find_words(file, word, problems);
      }
    }
  }
  return problems;
}

/// Where the literal ends that begins at `from`: at its closing quote.
std::size_t end_of_literal(std::string_view line, std::size_t from) {
  std::size_t at = from + 1;
  while (at < line.size() && line[at] != '"') {
    at += line[at] == '\\' ? 2 : 1;
  }
  return at;
}

bool has_letters(std::string_view text) {
  return std::any_of(
      text.begin(), text.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
}

/// Two literals of words side by side, the first of which does not end a line of its text.
bool has_split_literal(std::string_view line) {
  std::string_view last;
  std::size_t after_last = 0;
  for (std::size_t from = line.find('"'); from < line.size();) {
    const std::size_t to = end_of_literal(line, from);
    const std::string_view literal = line.substr(from, std::min(to, line.size()) - from);
    const std::string_view between = line.substr(after_last, from - after_last);
    if (has_letters(last) && has_letters(literal) && !last.ends_with("\\n") &&
        between.find_first_not_of(' ') == std::string_view::npos) {
      return true;
    }
    last = literal;
    after_last = to + 1;
    from = line.find('"', after_last);
  }
  return false;
}

/// Literals side by side in one line, as a formatter leaves them after a rename.
Problems split_literal_problems(const std::vector<SourceFile>& files) {
  Problems problems;
  for (const SourceFile& file : files) {
    for (std::size_t i = 0; i < file.lines.size() && file.path != this_file; ++i) {
      const std::string& line = file.lines[i];
      const bool is_plain = line.find("R\"") == std::string::npos &&
                            line.find("'\"'") == std::string::npos &&
                            line.find("//") == std::string::npos;
      if (is_plain && has_split_literal(line)) {
        problems.push_back(file.path + ":" + std::to_string(i + 1) +
                           ": two string literals side by side; join them");
      }
    }
  }
  return problems;
}

TEST(Language, IsThatOfTheField) { EXPECT_THAT(language_problems(texts()), IsEmpty()); }

TEST(Language, LeavesNoStringLiteralSplitWithinALine) {
  EXPECT_THAT(split_literal_problems(read_source_tree(tree_root)), IsEmpty());
}

TEST(Language, CatchesAWordOfOurOwnMakingAndSaysTheTerm) {
  const SourceFile file{"host/x.hpp",
                        {"int most_particles = 1;",
                         "double x_sd_m = 0.1;",
                         "double range_std_m = 0.1;",
                         "std::vector<int> almost_points;",
                         "say(\"put it down and start anew\");"}};
  EXPECT_THAT(language_problems({file}),
              ElementsAre(HasSubstr("host/x.hpp:1: 'most_particles'; write max_particles"),
                          HasSubstr("host/x.hpp:2"),
                          HasSubstr("host/x.hpp:3"),
                          HasSubstr("host/x.hpp:5: 'start anew'; write start again")));
}

/// One line for every entry of the table, in its order.
constexpr std::string_view kFound[] = {
    "most_particles",
    "least_points",
    "widest_gap_m",
    "farthest_off_m",
    "kMostCells",
    "kLeastReadings",
    "double x_sd_m = 0.1;",
    "double range_std_m = 0.1;",
    "kRangeSdM",
    "kRangeStdM",
    "half_opening_rad",
    "ConeOpening",
    "most_way_m",
    "by_pose",
    "by_landmark",
    "resample_where_few_count()",
    "surprise_of(x)",
    "kernel_share",
    "OdometryBelief",
    "OdometryTrust",
    "turn_by_drive_rad_per_m",
    "move_past(pose)",
    "aslant_missed_chance",
    "NearMapper",
    "near_mapper",
    "near_grid",
    "far_grid_",
    "KeptWayParams",
    "kept_way",
    "LandmarkSlamByBeams",
    "RunKeeper",
    "MapsTeller",
    "DrivenRobot",
    "former_maps",
    "FormerMap",
    "begin_anew",
    "put it down and start anew",
    "particles are drawn anew",
    "goes on with {}",
    "session 0 stands for none",
    "where few count",
    "parameters without sense",
    "values that make no sense",
    "a parameter is outside of its range",
    "every parameter is above 0",
    "found itself in the map of before",
    "the robot did not look for itself",
    "one range wherever it looks",
    "the line is cut off, and all before it is read",
    "--slam grid",
};

TEST(Language, CatchesEveryEntryOfItsTable) {
  ASSERT_EQ(std::size(kFound), std::size(kReplacements));
  for (std::size_t i = 0; i < std::size(kFound); ++i) {
    Problems problems;
    find_words({"host/x.cpp", {std::string(kFound[i])}}, kReplacements[i], problems);
    EXPECT_EQ(problems.size(), 1U) << kReplacements[i].hint << " in: " << kFound[i];
  }
}

TEST(Language, ExceptsAWordOnlyInTheFileThatNeedsIt) {
  EXPECT_THAT(language_problems({{"host/apps/saved_map.cpp", {"former_1"}}}), IsEmpty());
  EXPECT_THAT(language_problems({{"host/apps/saved_map.cpp", {"near_grid"}}}), SizeIs(1));
  EXPECT_THAT(language_problems({{"host/apps/run_writer.cpp", {"former_1"}}}), SizeIs(1));
}

TEST(Language, CatchesLiteralsThatWereSplitWithinALine) {
  const SourceFile file{"host/x.cpp",
                        {"say(\"put it down and start \" \"again\");",
                         "say(\"put it down and \"",
                         "    \"start again\");",
                         "say(\"two\\n\" \"lines\");",
                         "say(\"a \" + name + \" is \" + text);",
                         "names = {\"left\", \"right\"};"}};
  EXPECT_THAT(split_literal_problems({file}), ElementsAre(HasSubstr("host/x.cpp:1")));
}

}  // namespace
}  // namespace echomap::structure
