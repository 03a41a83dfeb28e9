# SPDX-License-Identifier: MIT
# cmake -DBOARD=uno -DVERSION=n.n.n -DOUT=folder -P package.cmake
# Makes the Arduino library echomap_BOARD in OUT, and a zip of it that the Arduino IDE installs, from
# the very files that the other builds compile: sources.cmake names them.
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
include(${root}/firmware/sources.cmake)
set(library ${OUT}/echomap_${BOARD})
file(REMOVE_RECURSE ${library})

list(TRANSFORM ECHOMAP_FIRMWARE_SOURCES PREPEND firmware/)
list(TRANSFORM ECHOMAP_PROTOCOL_SOURCES PREPEND protocol/)
set(boards firmware/boards/avr_common firmware/boards/edge_counter firmware/boards/no_own_sensors
           firmware/boards/arduino_${BOARD})
set(files ${ECHOMAP_FIRMWARE_SOURCES} ${ECHOMAP_PROTOCOL_SOURCES} firmware/app/main.cpp)
foreach(folder protocol firmware/hal firmware/drivers firmware/control firmware/tasks firmware/app)
  file(GLOB headers RELATIVE ${root} ${root}/${folder}/*.hpp)
  list(APPEND files ${headers})
endforeach()
foreach(folder ${boards})
  file(GLOB sources RELATIVE ${root} ${root}/${folder}/*.hpp ${root}/${folder}/*.cpp)
  list(APPEND files ${sources})
endforeach()

foreach(file ${files})
  get_filename_component(folder ${file} DIRECTORY)
  file(COPY ${root}/${file} DESTINATION ${library}/src/${folder})
endforeach()
file(COPY ${CMAKE_CURRENT_LIST_DIR}/echomap.h DESTINATION ${library}/src)
file(COPY ${root}/LICENSE DESTINATION ${library})
file(COPY ${CMAKE_CURRENT_LIST_DIR}/echomap_robot.ino
     DESTINATION ${library}/examples/echomap_robot)
configure_file(${CMAKE_CURRENT_LIST_DIR}/library.properties.in ${library}/library.properties @ONLY)
execute_process(COMMAND ${CMAKE_COMMAND} -E tar cf echomap_${BOARD}.zip --format=zip echomap_${BOARD}
                WORKING_DIRECTORY ${OUT} COMMAND_ERROR_IS_FATAL ANY)
