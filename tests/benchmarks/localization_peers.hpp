// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "host/mapping/raster_map.hpp"

namespace echomap::bench {

/// Figures of MRPT's particle filter on the work of localization_kernel_figures, by their names:
/// its likelihood field, Thrun's odometry model, systematic resampling, mean and covariance. Says
/// so and gives none where MRPT is not installed.
std::map<std::string, double> mrpt_localization_figures(const mapping::RasterMap& map,
                                                        std::size_t repetitions);

}  // namespace echomap::bench
