// SPDX-License-Identifier: MIT
#include "host/exploration/company.hpp"

namespace echomap::exploration {

pipeline::Snapshot with_company(const pipeline::Snapshot& snapshot, const Company& company) {
  pipeline::Snapshot known = snapshot;
  known.grid = company.grid ? company.grid : known.grid;
  known.scans = company.scans ? company.scans : known.scans;
  known.features = company.features ? company.features : known.features;
  if (!company.been_m.empty()) {
    auto trajectory = std::make_shared<std::vector<pipeline::StampedPose>>();
    trajectory->reserve(company.been_m.size() + snapshot.trajectory->size());
    for (const Eigen::Vector2d& been_m : company.been_m) {
      trajectory->push_back({{}, {been_m.x(), been_m.y(), 0.0}});
    }
    trajectory->insert(trajectory->end(), snapshot.trajectory->begin(), snapshot.trajectory->end());
    known.trajectory = trajectory;
  }
  return known;
}

}  // namespace echomap::exploration
