// SPDX-License-Identifier: MIT
#include "host/papers/paper_002_grid.hpp"

#include <functional>
#include <string>
#include <vector>

#include "host/papers/epuck_field.hpp"
#include "host/papers/epuck_grid_figures.hpp"
#include "host/papers/epuck_grid_picture.hpp"

namespace echomap::papers {
namespace {

using mapping::RasterMap;
using paper_report::Experiment;
using paper_report::Finding;
using paper_report::Measured;
using paper_report::PaperPicture;

/// Log-odds of 0.7 and of 0.3: silence weighs as much as an echo.
constexpr double kEvenLogOdds = 0.85;

using GridFigures = std::vector<EpuckGridFigures>;
using MapOnce = std::function<RasterMap(std::uint32_t seed)>;

GridFigures map_often(const PaperSettings& settings,
                      const std::string& words,
                      const MapOnce& map_once) {
  GridFigures figures;
  for (std::size_t i = 0; i < settings.runs; ++i) {
    const auto seed = settings.seed + static_cast<std::uint32_t>(i);
    figures.push_back(epuck_grid_figures(map_once(seed)));
    settings.progress(words, i + 1, settings.runs);
  }
  return figures;
}

RasterMap map_as_told(std::uint32_t seed) { return map_epuck_field(epuck_field(), {}, seed); }

RasterMap map_our_way(std::uint32_t seed) { return map_epuck_contacts(epuck_field(), seed); }

RasterMap map_by_even_odds(std::uint32_t seed) {
  EpuckGridParams params;
  params.occupied_log_odds = kEvenLogOdds;
  params.free_log_odds = -kEvenLogOdds;
  return map_epuck_field(epuck_field(), params, seed);
}

Measured mean_of_share(const GridFigures& figures, double EpuckGridFigures::*figure, double scale) {
  std::vector<double> values;
  for (const EpuckGridFigures& each : figures) {
    values.push_back(each.*figure);
  }
  return scaled(paper_report::measured_mean(values), scale);
}

/// Grids of the same drives.
struct EpuckGrids {
  GridFigures as_told;
  GridFigures filled;     ///< As told, small unknown clots called free.
  GridFigures even_odds;  ///< As told, silence weighing as much as an echo.
  GridFigures ours;
};

EpuckGrids map_all(const PaperSettings& settings) {
  EpuckGrids grids;
  grids.as_told = map_often(settings, "mapping by algorithms 2 and 3", [&](std::uint32_t seed) {
    const RasterMap map = map_as_told(seed);
    grids.filled.push_back(epuck_grid_figures(without_small_clots(map)));
    return map;
  });
  grids.even_odds = map_often(settings, "mapping by even odds", map_by_even_odds);
  grids.ours = map_often(settings, "mapping by contacts", map_our_way);
  return grids;
}

/// One quantity of the grids as told and, where it is one of them, of ours.
Finding grid_row(const std::string& quantity,
                 const std::string& paper,
                 const GridFigures& as_told,
                 const GridFigures& ours,
                 double EpuckGridFigures::*figure) {
  Finding finding;
  finding.quantity = quantity;
  finding.where = "figure 5";
  finding.paper = paper;
  finding.as_told = mean_of_share(as_told, figure, 100.0);
  if (!ours.empty()) {
    finding.ours = mean_of_share(ours, figure, 100.0);
  }
  finding.unit = "%";
  finding.decimals = 1;
  return finding;
}

std::vector<Finding> grid_findings(const EpuckGrids& grids) {
  const std::string correct = "\"most\" are correct";
  Finding rms = grid_row("occupied cells are off by, RMS",
                         "\"fits perfectly\"",
                         grids.as_told,
                         grids.ours,
                         &EpuckGridFigures::occupied_rms_m);
  rms.as_told = scaled(*rms.as_told, 10.0);
  rms.ours = scaled(*rms.ours, 10.0);
  rms.unit = "mm";
  return {
      grid_row("walls found, within 3 mm",
               "with discontinuities",
               grids.as_told,
               {},
               &EpuckGridFigures::walls_found),
      grid_row("walls found, within 1 cm",
               "with discontinuities",
               grids.as_told,
               grids.ours,
               &EpuckGridFigures::walls_about),
      grid_row("occupied cells within 5 mm of a wall",
               "\"fits perfectly\"",
               grids.as_told,
               grids.ours,
               &EpuckGridFigures::occupied_near),
      rms,
      grid_row("floor found", correct, grids.as_told, grids.ours, &EpuckGridFigures::free_found),
      grid_row("floor found, small clots called free",
               "proposed",
               grids.filled,
               {},
               &EpuckGridFigures::free_found),
      grid_row("inside of the blocks unknown",
               "not said",
               grids.as_told,
               grids.ours,
               &EpuckGridFigures::blocks_unknown),
      grid_row("the same, small clots called free",
               "\"except for obstacles\"",
               grids.filled,
               {},
               &EpuckGridFigures::blocks_unknown),
      grid_row("free that is no floor",
               "not said",
               grids.as_told,
               grids.ours,
               &EpuckGridFigures::free_wrong),
      grid_row("walls found, by odds of 0.7 and 0.3",
               "odds not given",
               grids.even_odds,
               {},
               &EpuckGridFigures::walls_found)};
}

std::vector<PaperPicture> grid_pictures(const PaperSettings& settings) {
  const auto folder = settings.out / "pictures";
  const RasterMap map = map_as_told(settings.seed);
  return {{"The grid in the paper's shades",
           "figure 5, left",
           "Cells of 1 mm; obstacles white, free cells black, unknown ones grey.",
           draw_in_shades(folder / "002_grid_shades.png", map)},
          {"The grid on the true walls",
           "figure 5, right",
           "The same, obstacles black. The arcs behind the walls are oblique beams that looked too "
           "far, the white moat those that got no answer.",
           draw_under_walls(folder / "002_grid_walls.png", map)},
          {"Small unknown clots called free",
           "section 4.1",
           "Clots smaller than the robot are gone; the blocks are larger and stay.",
           draw_under_walls(folder / "002_grid_filled.png", without_small_clots(map))},
          {"The grid our way",
           "figure 5, right",
           "The same drive in cells of 1 cm by the contact mapper.",
           draw_under_walls(folder / "002_grid_ours.png", map_our_way(settings.seed))}};
}

std::vector<paper_report::Equation> grid_equations() {
  return {{"Algorithm 2, occupancy grid mapping",
           "l(t, i) = l(t-1, i) + IRSM(m(i), x, z) - l₀  for each cell m(i) that the beam covers",
           "host/papers/epuck_field.cpp",
           "void insert(const models::SensorReading"},
          {"Algorithm 3, inverse range sensor model",
           "r > min(z_max, z + α/2) or |φ - θ| > β/2:  l₀\n"
           "z < z_max and |r - z| < α/2:  l_occ  (the paper prints |r - z_max|)\n"
           "r ≤ z:  l_free",
           "host/models/occupied_sector.cpp",
           "double OccupiedSector::evidence"},
          {"section 4.1, unknown clots",
           "a clot of unknown cells smaller than π · (37 mm)² is free",
           "host/papers/epuck_grid_figures.cpp",
           "RasterMap without_small_clots"},
          {"our way, walls at oblique incidence",
           "of sensors less than 69° apart only the shortest range is a wall",
           "host/mapping/contact_mapper.cpp",
           "void ContactMapper::add_ranges"}};
}

}  // namespace

Experiment epuck_grid_experiment(const PaperSettings& settings) {
  Experiment experiment;
  experiment.title = "An occupancy grid in cells of a millimetre";
  experiment.question =
      "Do eight infra-red sensors of 6 cm map walls and obstacles to a millimetre?";
  experiment.as_told =
      "Two laps beside walls and obstacles of a field of 0.8 x 0.6 m, poses by the camera, 10 "
      "readings a second at 5 cm/s. Each reading adds its evidence to the cells of its sector "
      "(Algorithms 2 and 3); ranges count as true (section 4.1). Here α is 4 mm, β 10 degrees, "
      "l_occ "
      "the log-odds of 0.9 and l_free those of 0.4; the camera errs by 1 mm and 0.6 degrees.\n\n"
      "Unknown clots that are smaller than the robot are then called free, as section 4.1 "
      "proposes.";
  experiment.our_way =
      "The same readings in cells of 1 cm: of neighbouring sensors only the shortest range is a "
      "wall, silence has little weight, and the floor under the robot is free "
      "(mapping::ContactMapper). In cells of this size no wall can be found within 3 mm.";
  experiment.answer =
      "Roughly. The walls are found with gaps, and nearly all of the floor. But a wall that a beam "
      "meets obliquely looks too far or does not answer: arcs and a moat called free lie behind "
      "the walls, which the paper's algorithm does nothing about. With small clots called free, "
      "less of the floor is unknown, and the middles of the blocks stay as they are. Our way, in "
      "coarser cells, has fewer ghosts behind the walls, and a little less of walls and floor.";
  experiment.findings = grid_findings(map_all(settings));
  experiment.pictures = grid_pictures(settings);
  experiment.equations = grid_equations();
  experiment.open = {
      "α, β, l_occ, l_free and l₀ are not given. With odds of 0.7 and 0.3 silent beams outvote the "
      "echoes.",
      "Line 8 of Algorithm 3 compares with z_max, which would put each obstacle at the end of the "
      "range: read as z.",
      "Size and places of the obstacles are not given; here they are two blocks.",
      "How the light of a sensor is converted into a distance is not given, nor any figure for the "
      "grid."};
  return experiment;
}

}  // namespace echomap::papers
