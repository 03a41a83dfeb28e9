# SPDX-License-Identifier: MIT
# echomap_avr_image(NAME MCU chip BAUD n SOURCES a.cpp ..): NAME.elf and NAME.hex for a chip at
# 16 MHz, with its sizes printed and held to ECHOMAP_FLASH_LIMIT and ECHOMAP_RAM_LIMIT.
function(echomap_avr_image name)
  cmake_parse_arguments(ARG "" "MCU;BAUD" "SOURCES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES SUFFIX .elf CXX_STANDARD 14 CXX_STANDARD_REQUIRED ON)
  target_include_directories(${name} PRIVATE ${root})
  target_compile_definitions(${name} PRIVATE F_CPU=16000000UL ECHOMAP_BAUD=${ARG_BAUD}UL)
  set(code -gdwarf-2 -mmcu=${ARG_MCU} -Os -flto -ffunction-sections -fdata-sections -fno-exceptions
      -fno-rtti -fno-threadsafe-statics)
  target_compile_options(${name} PRIVATE ${code} -Wall -Wextra -Wpedantic -Wshadow
                         -Wcast-align
                         $<$<BOOL:${ECHOMAP_WERROR}>:-Werror>)
  target_link_options(${name} PRIVATE ${code} -Wl,--gc-sections,--relax
                      $<$<BOOL:${ECHOMAP_WERROR}>:-Wl,--fatal-warnings>)
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DSIZE=avr-size -DELF=$<TARGET_FILE:${name}>
            -DFLASH_LIMIT=${ECHOMAP_FLASH_LIMIT}
            -DRAM_LIMIT=${ECHOMAP_RAM_LIMIT} -P ${root}/firmware/cmake/size_limits.cmake
    COMMAND avr-objcopy -O ihex -R .eeprom $<TARGET_FILE:${name}>
            $<TARGET_FILE_DIR:${name}>/${name}.hex
    VERBATIM)
endfunction()
