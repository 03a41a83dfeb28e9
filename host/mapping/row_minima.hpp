// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace echomap::mapping {

/// The longest row.
constexpr std::int32_t kMaxRowCells = 1 << 14;

/// min over i of heights[i] + (x - i)^2 for x = first, first + 1 .., one for each of `minima`.
///
/// The i that attains the minimum never falls as x grows, since all parabolas are alike. So it is
/// found for every 256th x first, then between these for every 16th, then for all, each time for 16
/// x at once and only among the i that the neighbours found before leave: about three steps of a
/// vector for each i, whatever the heights are. Heights are at most 2^30 and used up; x and i are
/// from 0 to kMaxRowCells - 1.
void row_minima(std::span<std::int32_t> heights,
                std::int32_t first,
                std::span<std::int32_t> minima);

/// The farthest reach of near_row_minima: twice its square is a whole number of 16 bits.
constexpr std::int32_t kMaxNearReach = 181;
/// So many values beyond the last may be read.
constexpr std::size_t kNearPadding = 32;

/// min over |d| <= reach of squares[x + reach + d] + d^2 for x = 0, 1 .., one for each of `minima`:
/// where only minima below reach^2 matter, nothing farther off can make one. 32 x at once.
/// `squares` are at most reach^2 and 2 reach + kNearPadding more than `minima`.
void near_row_minima(std::span<const std::uint16_t> squares,
                     std::int32_t reach,
                     std::span<std::uint16_t> minima);

}  // namespace echomap::mapping
