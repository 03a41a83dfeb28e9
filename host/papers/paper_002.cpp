// SPDX-License-Identifier: MIT
#include "host/papers/paper_002.hpp"

#include "host/papers/paper_002_ekf.hpp"
#include "host/papers/paper_002_grid.hpp"
#include "host/papers/paper_002_localization.hpp"

namespace echomap::papers {

paper_report::PaperReport paper_002(const PaperSettings& settings) {
  paper_report::PaperReport report;
  report.number = "002";
  report.title =
      "Localization and Mapping of Cheap Educational Robot with Low Bandwidth Noisy IR Sensors";
  report.authors = "Muhammad Habib Mahmood and Pere Ridao Rodriquez, 2017";
  report.summary =
      "An e-puck with eight infra-red sensors that see 6 cm far is followed by an overhead camera, "
      "maps its field of 0.8 x 0.6 m in cells of a millimetre, and finds itself in that map with "
      "1,000 particles.";
  report.experiments = {epuck_ekf_experiment(settings),
                        epuck_grid_experiment(settings),
                        epuck_localization_experiment(settings)};
  report.seed = settings.seed;
  return report;
}

}  // namespace echomap::papers
