// SPDX-License-Identifier: MIT
#include <cstdint>
#include <cstdlib>
#include <string>

#include "host/evaluation/relation_error.hpp"
#include "host/evaluation/truth_directory.hpp"
#include "host/exports/geojson.hpp"
#include "host/exports/map_yaml.hpp"
#include "host/exports/pgm_image.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/temporary_folder.hpp"

namespace {

using echomap::fuzz::require;
namespace exports = echomap::exports;
namespace fs = std::filesystem;

/// The files that echomap reads back from a run.
enum Kind : std::uint8_t { kTrajectory, kYaml, kPgm, kWalls, kOutline, kRelations, kKinds };

/// A truth directory whose walls are in memory.
class TruthFolder {
 public:
  explicit TruthFolder(const fs::path& walls) {
    exports::write_map_yaml(path() / "truth_map.yaml", {"truth_map.pgm", 0.1, {0, 0}});
    exports::write_pgm(path() / "truth_map.pgm", {1, 1, {254}});
    exports::write_trajectory_tum(path() / "truth.tum", {});
    fs::create_symlink(walls, path() / "truth_walls.geojson");
  }
  const fs::path& path() const { return folder_.path(); }

 private:
  echomap::fuzz::TemporaryFolder folder_;
};

void read(std::uint8_t kind, const fs::path& file) {
  static const TruthFolder truth(file);
  switch (kind % kKinds) {
    case kTrajectory:
      for (const auto& pose : exports::read_trajectory_tum(file)) {
        require(std::abs(pose.stamp.time_since_epoch().count()) <= std::int64_t{1} << 60U,
                "a stamp has room for what comes after");
      }
      break;
    case kYaml:
      require(exports::read_map_yaml(file).resolution_m > 0.0, "a map has a resolution");
      break;
    case kPgm: {
      const auto image = exports::read_pgm(file);
      require(image.pixels.size() ==
                  static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows),
              "a picture has all of its pixels");
      break;
    }
    case kOutline:
      if (const auto map = exports::read_outline_geojson(file)) {
        require(map->outline_m().size() >= 3, "an outline bounds an area");
      }
      break;
    case kRelations:
      echomap::evaluation::read_relations(file);
      break;
    default:
      echomap::evaluation::read_truth(truth.path());
  }
}

}  // namespace

std::vector<echomap::fuzz::Input> echomap::fuzz::seeds() {
  return {
      echomap::fuzz::input_of(kTrajectory,
                              "# t x y z qx qy qz qw\n0.02 0 0 0 0 0 0 1\n1.5 1 2 0 0 0 0.7 0.7\n"),
      echomap::fuzz::input_of(
          kYaml,
          "image: map.pgm\nmode: trinary\nresolution: 0.05\norigin: [-1.5, 2, 0]\n"
          "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"),
      echomap::fuzz::input_of(kPgm, "P5\n# grey\n2 2\n255\nabcd"),
      echomap::fuzz::input_of(
          kWalls,
          R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":)"
          R"("LineString","coordinates":[[0,0],[1,0],[1,2.5]]}}]})"),
      echomap::fuzz::input_of(
          kOutline,
          R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":)"
          R"("Polygon","coordinates":[[[0,0],[1,0],[1,2.5],[0,0]]]}}]})"),
      echomap::fuzz::input_of(kRelations, "0 1 0.5 0 -0.1\n1 4 1 2 3\n"),
  };
}

/// One input is a kind of file and its text. It is read, or refused with a FileError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  static echomap::fuzz::MemoryFile file;
  file.write({data + 1, size - 1});
  try {
    read(data[0], file.path());
  } catch (const echomap::files::FileError&) {
  }
  return 0;
}
