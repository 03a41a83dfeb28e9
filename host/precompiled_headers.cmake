# SPDX-License-Identifier: MIT
# Headers that most sources read, compiled once for all targets that compile with the same options.
# A source still includes what it uses: the presets lint, fuzz and those of gcc's sanitizers read it without.
find_package(Eigen3 REQUIRED)

# echomap_headers(SET HEADERS <a> .. [DEPENDS target ..] [OPTIONS flag ..])
function(echomap_headers set)
  if(NOT ECHOMAP_PRECOMPILE)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "HEADERS;DEPENDS;OPTIONS" ${ARGN})
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/headers_${set}.cpp CONTENT "")
  add_library(echomap_headers_${set} OBJECT ${CMAKE_BINARY_DIR}/headers_${set}.cpp)
  target_link_libraries(echomap_headers_${set} PRIVATE echomap_options ${ARG_DEPENDS})
  target_compile_options(echomap_headers_${set} PRIVATE ${ARG_OPTIONS})
  target_precompile_headers(echomap_headers_${set} PRIVATE ${ARG_HEADERS})
endfunction()

# echomap_use_headers(TARGET SET)
# With std::string precompiled, g++-12 reports -Wrestrict's false alarm (CMakeLists.txt) under two
# more names; builds without ECHOMAP_PRECOMPILE have both.
function(echomap_use_headers name set)
  if(ECHOMAP_PRECOMPILE)
    target_precompile_headers(${name} REUSE_FROM echomap_headers_${set})
    target_compile_options(${name} PRIVATE
      "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow>")
  endif()
endfunction()

# echomap_source_options(OPTIONS flag .. SOURCES a.cpp ..): options of single sources of this folder,
# whose code then differs from that of the precompiled headers.
function(echomap_source_options)
  cmake_parse_arguments(ARG "" "" "OPTIONS;SOURCES" ${ARGN})
  set_source_files_properties(${ARG_SOURCES} PROPERTIES COMPILE_OPTIONS "${ARG_OPTIONS}"
                              SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

set(standard_headers
  <algorithm> <array> <charconv> <chrono> <cmath> <cstdint> <deque> <filesystem> <functional> <limits>
  <map> <memory> <numbers> <numeric> <optional> <random> <set> <span> <sstream> <stdexcept> <string>
  <string_view> <system_error> <utility> <variant> <vector>)
set(eigen_headers <Eigen/Cholesky> <Eigen/Core> <Eigen/Eigenvalues> <Eigen/Geometry> <Eigen/LU>)
echomap_headers(host DEPENDS Eigen3::Eigen HEADERS ${standard_headers} ${eigen_headers})
