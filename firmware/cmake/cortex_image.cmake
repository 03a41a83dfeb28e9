# SPDX-License-Identifier: MIT
# echomap_cortex_image(NAME CPU cortex-m3 SCRIPT x.ld BAUD n SOURCES a.cpp ..): NAME.elf, NAME.hex and
# NAME.bin, with its sizes printed and held to ECHOMAP_FLASH_LIMIT and ECHOMAP_RAM_LIMIT.
function(echomap_cortex_image name)
  cmake_parse_arguments(ARG "" "CPU;SCRIPT;BAUD" "SOURCES" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES SUFFIX .elf CXX_STANDARD 14 CXX_STANDARD_REQUIRED ON
                        LINK_DEPENDS ${ARG_SCRIPT})
  target_include_directories(${name} PRIVATE ${root})
  target_compile_definitions(${name} PRIVATE ECHOMAP_BAUD=${ARG_BAUD}UL)
  set(code -mcpu=${ARG_CPU} -mthumb -Os -flto -ffunction-sections -fdata-sections -fno-exceptions
      -fno-rtti -fno-threadsafe-statics -fno-unwind-tables -fno-asynchronous-unwind-tables)
  # Without the C++ library, as on the AVR: the sources are the same.
  target_compile_options(${name} PRIVATE ${code} -nostdinc++ -Wall -Wextra -Wpedantic -Wshadow
                         -Wcast-align=strict
                         $<$<BOOL:${ECHOMAP_WERROR}>:-Werror>)
  target_link_options(${name} PRIVATE ${code} -nostartfiles -nodefaultlibs -T${ARG_SCRIPT}
                      -Wl,--gc-sections $<$<BOOL:${ECHOMAP_WERROR}>:-Wl,--fatal-warnings>)
  # By name: g++ would ask for the C++ library, which the packages leave out.
  target_link_libraries(${name} PRIVATE c_nano gcc)
  add_custom_command(TARGET ${name} POST_BUILD
    COMMAND ${CMAKE_COMMAND} -DSIZE=arm-none-eabi-size -DELF=$<TARGET_FILE:${name}>
            -DFLASH_LIMIT=${ECHOMAP_FLASH_LIMIT} -DRAM_LIMIT=${ECHOMAP_RAM_LIMIT}
            -P ${root}/firmware/cmake/size_limits.cmake
    COMMAND arm-none-eabi-objcopy -O ihex $<TARGET_FILE:${name}>
            $<TARGET_FILE_DIR:${name}>/${name}.hex
    COMMAND arm-none-eabi-objcopy -O binary $<TARGET_FILE:${name}>
            $<TARGET_FILE_DIR:${name}>/${name}.bin
    VERBATIM)
endfunction()
