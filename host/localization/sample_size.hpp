// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace echomap::localization {

/// So many particles, in so many occupied bins, differ from the distribution that they stand for by
/// at most `max_error` (Kullback-Leibler) in 99 of 100 draws (Fox 2003).
std::size_t kld_sample_size(std::size_t occupied_bins, double max_error);

}  // namespace echomap::localization
