# SPDX-License-Identifier: MIT
# echomap_avr_board(NAME MCU chip BAUDS n ..): the images of an AVR board, with a toolchain of its
# own: echomap-NAME for the first baud rate, echomap-NAME-BAUD for the others, and with
# ECHOMAP_TESTS the images that the golden vectors and the differential test run through. Sources are
# the caller's folder, avr_common, edge_counter and no_own_sensors. ECHOMAP_FLASH_LIMIT and
# ECHOMAP_RAM_LIMIT are the caller's.
option(ECHOMAP_WERROR "Treat compiler warnings as errors" OFF)
option(ECHOMAP_TESTS "Build the firmware's test images" OFF)

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
include(${root}/firmware/sources.cmake)
include(${root}/firmware/cmake/avr_image.cmake)

function(echomap_avr_board board)
  cmake_parse_arguments(ARG "" "MCU" "BAUDS" ${ARGN})
  file(GLOB board_sources CONFIGURE_DEPENDS
       ${root}/firmware/boards/avr_common/*.cpp
       ${root}/firmware/boards/edge_counter/*.cpp
       ${root}/firmware/boards/no_own_sensors/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(TRANSFORM ECHOMAP_FIRMWARE_SOURCES PREPEND ${root}/firmware/ OUTPUT_VARIABLE robot_sources)
  list(TRANSFORM ECHOMAP_PROTOCOL_SOURCES PREPEND ${root}/protocol/ OUTPUT_VARIABLE wire_sources)
  set(program ${robot_sources} ${root}/firmware/app/main.cpp ${wire_sources} ${board_sources})

  list(POP_FRONT ARG_BAUDS usual_baud)
  echomap_avr_image(echomap-${board} MCU ${ARG_MCU} BAUD ${usual_baud} SOURCES ${program})
  foreach(baud ${ARG_BAUDS})
    echomap_avr_image(echomap-${board}-${baud} MCU ${ARG_MCU} BAUD ${baud} SOURCES ${program})
  endforeach()
  if(ECHOMAP_TESTS)
    echomap_avr_image(echomap-${board}-vectors MCU ${ARG_MCU} BAUD ${usual_baud}
                      SOURCES ${board_sources} ${wire_sources}
                              ${root}/firmware/drivers/serial_port.cpp
                              ${root}/tests/firmware/vector_echo_main.cpp)
    # The robot without its board, in a random world: it needs room for that world.
    set(ECHOMAP_FLASH_LIMIT 32768)
    set(ECHOMAP_RAM_LIMIT 1536)
    file(GLOB world_sources CONFIGURE_DEPENDS ${root}/tests/firmware/differential/*.cpp)
    list(FILTER world_sources EXCLUDE REGEX main_hosted)
    echomap_avr_image(echomap-${board}-differential MCU ${ARG_MCU} BAUD ${usual_baud}
                      SOURCES ${robot_sources} ${wire_sources} ${world_sources})
  endif()
endfunction()
