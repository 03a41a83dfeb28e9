// SPDX-License-Identifier: MIT
#include "host/localization/range_update.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "host/localization/lane_math.hpp"
#include "host/localization/usable_reading.hpp"
#include "host/mapping/vector_clones.hpp"

namespace echomap::localization {

namespace {

constexpr int kFractionBits = 4;
constexpr float kUnitsPerRad =
    static_cast<float>(RangeTable::kHeadings << kFractionBits) / (2.0F * std::numbers::pi_v<float>);

/// Where the sensors of some particles stand in the table.
struct Stands {
  static constexpr std::size_t kMost = 256;
  alignas(64) std::array<std::int32_t, kMost> tile;
  alignas(64) std::array<std::int32_t, kMost> codes;    ///< Where the cell begins in its tile.
  alignas(64) std::array<std::int32_t, kMost> heading;  ///< In 1/16; not negative.
};

struct Layout {
  float origin_x_m, origin_y_m, cells_per_m, columns, rows;
  std::int32_t tile_columns;
};

Layout layout_of(const RangeTable& table) {
  return {static_cast<float>(table.origin_m().x()),
          static_cast<float>(table.origin_m().y()),
          static_cast<float>(1.0 / table.resolution_m()),
          static_cast<float>(table.columns()) - 0.5F,
          static_cast<float>(table.rows()) - 0.5F,
          table.tile_columns()};
}

/// What lies beyond the map falls into the ring around it.
[[gnu::always_inline]] inline std::int32_t cell_of(float cells, float most) {
  const float above = cells > 0.0F ? cells : 0.0F;
  return static_cast<std::int32_t>(above < most ? above : most);
}

ECHOMAP_AVX2_CLONES
// NOLINTNEXTLINE(readability-function-size): __restrict holds for parameters only
void find_stands(const float* __restrict x_m,
                 const float* __restrict y_m,
                 const float* __restrict heading_rad,
                 std::size_t count,
                 const float ahead_m,
                 const float left_m,
                 const Layout layout,
                 Stands& __restrict stands) {
  constexpr std::int32_t kWithin = RangeTable::kTileSide - 1;
  constexpr std::int32_t kTurn = RangeTable::kHeadings << kFractionBits;
  for (std::size_t i = 0; i < count; ++i) {
    const SinCos direction = sin_cos(heading_rad[i]);
    const float sensor_x_m = x_m[i] + ahead_m * direction.cos - left_m * direction.sin;
    const float sensor_y_m = y_m[i] + ahead_m * direction.sin + left_m * direction.cos;
    const std::int32_t x =
        cell_of((sensor_x_m - layout.origin_x_m) * layout.cells_per_m, layout.columns);
    const std::int32_t y =
        cell_of((sensor_y_m - layout.origin_y_m) * layout.cells_per_m, layout.rows);
    stands.tile[i] =
        (y >> RangeTable::kTileBits) * layout.tile_columns + (x >> RangeTable::kTileBits);
    stands.codes[i] =
        (((y & kWithin) << RangeTable::kTileBits) + (x & kWithin)) * RangeTable::kHeadings;
    // Half a heading more, so that headings are rounded; two turns, so that it is above 0.
    stands.heading[i] = static_cast<std::int32_t>(heading_rad[i] * kUnitsPerRad + 2.0F * kTurn) +
                        (1 << (kFractionBits - 1));
  }
}

/// The sum over the beams of what their rows say of the expected codes.
[[gnu::always_inline]] inline std::int32_t sum_of_beams(const std::uint8_t* codes,
                                                        std::int32_t heading,
                                                        const CodedReadings::Beam* beams,
                                                        std::size_t count) {
  std::int32_t sum = 0;
  for (std::size_t b = 0; b < count; ++b) {
    const std::int32_t bin =
        ((heading + beams[b].heading) >> kFractionBits) & (RangeTable::kHeadings - 1);
    sum += beams[b].row[codes[bin]];
  }
  return sum;
}

/// Calls visit(place, first particle, stands, count) for stretches of particles and each place of a
/// sensor on the robot.
template <typename Visit>
void for_stands(const RangeTable& table,
                const CodedReadings& readings,
                ParticleRange range,
                const Particles& particles,
                const Visit& visit) {
  const Layout layout = layout_of(table);
  Stands stands;
  for (std::size_t begin = range.begin; begin < range.end; begin += Stands::kMost) {
    const std::size_t count = std::min(Stands::kMost, range.end - begin);
    for (const CodedReadings::Place& place : readings.places()) {
      find_stands(&particles.x_m[begin],
                  &particles.y_m[begin],
                  &particles.heading_rad[begin],
                  count,
                  place.ahead_m,
                  place.left_m,
                  layout,
                  stands);
      visit(place, begin, stands, count);
    }
  }
}

}  // namespace

std::int16_t LikelihoodCodes::coded(double likelihood) {
  const double nats = std::log(std::max(likelihood, 1e-30));
  return static_cast<std::int16_t>(std::lround(std::clamp(nats * kPerNat, -32767.0, 32767.0)));
}

void LikelihoodCodes::close() {
  constexpr std::int16_t kNever = -32768 / 4;
  for (Row& row : rows_) {
    row[RangeTable::kNoFloor] = kNever;
  }
}

CodedReadings::CodedReadings(std::span<const RangeReading> readings,
                             const RangeTable& table,
                             const LikelihoodCodes& likelihoods) {
  for (const RangeReading& reading : readings) {
    if (!is_usable(reading)) {
      continue;
    }
    const auto ahead_m = static_cast<float>(reading.T_robot_sensor.x_m());
    const auto left_m = static_cast<float>(reading.T_robot_sensor.y_m());
    if (places_.empty() || places_.back().ahead_m != ahead_m || places_.back().left_m != left_m) {
      places_.push_back({ahead_m, left_m, {}});
    }
    const auto heading = std::lround(reading.T_robot_sensor.heading_rad() * kUnitsPerRad);
    ++count_;
    places_.back().beams.push_back(
        {static_cast<std::int32_t>(heading),
         likelihoods.row(table.code_of({reading.range_m, false})).data()});
  }
}

void update_weights(const RangeTable& table,
                    const CodedReadings& readings,
                    float likelihood_exponent,
                    ParticleRange range,
                    Particles& particles) {
  const float scale = likelihood_exponent / LikelihoodCodes::kPerNat;
  for_stands(table,
             readings,
             range,
             particles,
             [&](const CodedReadings::Place& place,
                 std::size_t begin,
                 const Stands& stands,
                 std::size_t count) {
               for (std::size_t i = 0; i < count; ++i) {
                 const std::uint8_t* codes =
                     table.tiles()[stands.tile[i]]->data() + stands.codes[i];
                 const std::int32_t sum =
                     sum_of_beams(codes, stands.heading[i], place.beams.data(), place.beams.size());
                 particles.log_weight[begin + i] += scale * static_cast<float>(sum);
               }
             });
}

void fill_under(const Particles& particles,
                const CodedReadings& readings,
                RangeTable& table,
                const Workers& workers) {
  std::vector<std::vector<std::int32_t>> missing(blocks_in(particles.size()));
  share_blocks(workers, particles.size(), [&](ParticleRange range, std::size_t block) {
    const auto note_missing = [&](const CodedReadings::Place& /*place*/,
                                  std::size_t /*begin*/,
                                  const Stands& stands,
                                  std::size_t count) {
      std::copy_if(stands.tile.begin(),
                   stands.tile.begin() + static_cast<std::ptrdiff_t>(count),
                   std::back_inserter(missing[block]),
                   [&](std::int32_t tile) { return table.tiles()[tile] == nullptr; });
    };
    for_stands(table, readings, range, particles, note_missing);
  });
  for (const std::vector<std::int32_t>& tiles : missing) {
    for (const std::int32_t tile : tiles) {
      table.fill_tile(tile);
    }
  }
}

}  // namespace echomap::localization
