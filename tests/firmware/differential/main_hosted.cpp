// SPDX-License-Identifier: MIT
/// differential SEED STEPS REPORT_EVERY REPORT_FROM: reports on the standard output, a line each.
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/firmware/differential/program.hpp"

namespace echomap {
namespace differential {

void report(const Report& report) {
  printf("%" PRIu32 " %" PRIu32 " %" PRIu32 "\n", report.step, report.sum, report.sum_of_sums);
}

}  // namespace differential
}  // namespace echomap

int main(int count, char** arguments) {
  uint32_t numbers[4] = {};
  for (int i = 0; i < 4 && count == 5; ++i) {
    numbers[i] = static_cast<uint32_t>(strtoul(arguments[i + 1], nullptr, 10));
  }
  if (numbers[2] == 0) {
    fprintf(stderr, "usage: %s SEED STEPS REPORT_EVERY REPORT_FROM\n", arguments[0]);
    return 2;
  }
  echomap::differential::run({numbers[0], numbers[1], numbers[2], numbers[3]});
  return 0;
}
