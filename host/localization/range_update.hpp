// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/localization/observation_model.hpp"
#include "host/localization/particles.hpp"
#include "host/localization/range_table.hpp"
#include "host/localization/workers.hpp"
#include "host/models/range_likelihood.hpp"

namespace echomap::localization {

/// Logarithms of a model's likelihoods for all pairs of codes of a table, in 1/256. To
/// stand where no floor is costs 32 for each reading, less than the least likely reading may.
class LikelihoodCodes {
 public:
  using Row = std::array<std::int16_t, 256>;
  static constexpr float kPerNat = 256.0F;

  template <models::RangeLikelihood Model>
  LikelihoodCodes(const RangeTable& table, const Model& model) {
    for (std::int32_t read = 1; read < 256; ++read) {
      const auto range_m = table.expected_of(static_cast<std::uint8_t>(read)).range_m;
      for (std::int32_t expected = 1; expected < 256; ++expected) {
        rows_[static_cast<std::size_t>(read)][static_cast<std::size_t>(expected)] = coded(
            model.likelihood(range_m, table.expected_of(static_cast<std::uint8_t>(expected))));
      }
    }
    close();
  }

  /// By the code that is expected, for a code that was read, which is not kNoFloor.
  const Row& row(std::uint8_t read) const { return rows_[read]; }

 private:
  static std::int16_t coded(double likelihood);
  void close();

  std::vector<Row> rows_ = std::vector<Row>(256);
};

/// Readings as the kernel takes them: those from one place on the robot together.
class CodedReadings {
 public:
  CodedReadings(std::span<const RangeReading> readings,
                const RangeTable& table,
                const LikelihoodCodes& likelihoods);

  struct Beam {
    std::int32_t heading = 0;  ///< In 1/16 of a table's heading.
    const std::int16_t* row = nullptr;
  };
  struct Place {
    float ahead_m = 0.0F;
    float left_m = 0.0F;
    std::vector<Beam> beams;
  };
  const std::vector<Place>& places() const { return places_; }
  /// Of all places together.
  std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0;
  std::vector<Place> places_;
};

/// Adds `temper` times the logarithm of the readings' likelihood to each particle's weight: below 1
/// where readings of one sweep are not independent of each other. The table must have been filled
/// under all of them (fill_under).
void update_weights(const RangeTable& table,
                    const CodedReadings& readings,
                    float likelihood_exponent,
                    ParticleRange range,
                    Particles& particles);

/// Fills the table wherever a particle's sensor may stand.
void fill_under(const Particles& particles,
                const CodedReadings& readings,
                RangeTable& table,
                const Workers& workers = Workers());

}  // namespace echomap::localization
