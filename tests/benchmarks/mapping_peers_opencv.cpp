// SPDX-License-Identifier: MIT
#include "tests/benchmarks/mapping_workloads.hpp"

#ifdef ECHOMAP_WITH_OPENCV

#include <opencv2/imgproc.hpp>

#include "tests/benchmarks/thread_clock.hpp"

namespace echomap::bench {

std::vector<Contestant> distance_peers(const mapping::RasterMap& map) {
  cv::setNumThreads(1);
  cv::Mat obstacles(map.rows(), map.columns(), CV_8U);
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const bool is_obstacle = map.state({x, y}) == mapping::CellState::kOccupied;
      obstacles.at<unsigned char>(y, x) = is_obstacle ? 0 : 255;
    }
  }
  return {{"opencv", [obstacles, distances = cv::Mat()]() mutable {
             return processor_seconds([&] {
               cv::distanceTransform(obstacles, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
             });
           }}};
}

}  // namespace echomap::bench

#else

namespace echomap::bench {

std::vector<Contestant> distance_peers(const mapping::RasterMap&) { return {}; }

}  // namespace echomap::bench

#endif
