# SPDX-License-Identifier: MIT
# echomap_cortex_board(NAME CPU cortex-m3 SCRIPT x.ld BAUDS n ..): the images of a board with a
# Cortex-M, with a toolchain of its own: echomap-NAME for the first baud rate, echomap-NAME-BAUD for
# the others, and with ECHOMAP_TESTS the image that the golden vectors run through. Sources are the
# caller's folder, cortex_common and no_own_sensors. ECHOMAP_FLASH_LIMIT and ECHOMAP_RAM_LIMIT are
# the caller's.
option(ECHOMAP_WERROR "Treat compiler warnings as errors" OFF)
option(ECHOMAP_TESTS "Build the firmware's test images" OFF)

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
include(${root}/firmware/sources.cmake)
include(${root}/firmware/cmake/cortex_image.cmake)

function(echomap_cortex_board board)
  cmake_parse_arguments(ARG "" "CPU;SCRIPT" "BAUDS" ${ARGN})
  file(GLOB board_sources CONFIGURE_DEPENDS
       ${root}/firmware/boards/cortex_common/*.cpp
       ${root}/firmware/boards/no_own_sensors/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(TRANSFORM ECHOMAP_FIRMWARE_SOURCES PREPEND ${root}/firmware/ OUTPUT_VARIABLE robot_sources)
  list(TRANSFORM ECHOMAP_PROTOCOL_SOURCES PREPEND ${root}/protocol/ OUTPUT_VARIABLE wire_sources)
  set(program ${robot_sources} ${root}/firmware/app/main.cpp ${wire_sources} ${board_sources})
  set(chip CPU ${ARG_CPU} SCRIPT ${CMAKE_CURRENT_SOURCE_DIR}/${ARG_SCRIPT})

  list(POP_FRONT ARG_BAUDS usual_baud)
  echomap_cortex_image(echomap-${board} ${chip} BAUD ${usual_baud} SOURCES ${program})
  foreach(baud ${ARG_BAUDS})
    echomap_cortex_image(echomap-${board}-${baud} ${chip} BAUD ${baud} SOURCES ${program})
  endforeach()
  if(ECHOMAP_TESTS)
    echomap_cortex_image(echomap-${board}-vectors ${chip} BAUD ${usual_baud}
                         SOURCES ${board_sources} ${wire_sources}
                                 ${root}/firmware/drivers/serial_port.cpp
                                 ${root}/tests/firmware/vector_echo_main.cpp)
  endif()
endfunction()
