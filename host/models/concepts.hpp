// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>

#include "host/models/sensor_reading.hpp"

namespace echomap::models {

/// What a reading says of a cell. `evidence` is what a map adds to the cell at a point seen from
/// the sensor: above zero for an obstacle, below zero for free floor, zero for nothing said
/// (log-odds, unless the model says otherwise). `reach_m` bounds the points with evidence.
template <typename Model>
concept InverseModel =
    requires(const Model& model, const SensorReading& reading, const PolarPoint& point) {
      { model.evidence(reading, point) } -> std::same_as<double>;
      { model.reach_m(reading) } -> std::same_as<double>;
    };

}  // namespace echomap::models
