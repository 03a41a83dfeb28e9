# SPDX-License-Identifier: MIT
# Toolchain of the EV3: Debian's g++-arm-linux-gnueabi.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-linux-gnueabi-g++)
set(CMAKE_AR arm-linux-gnueabi-gcc-ar)
set(CMAKE_RANLIB arm-linux-gnueabi-gcc-ranlib)
