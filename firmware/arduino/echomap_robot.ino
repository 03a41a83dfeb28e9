// SPDX-License-Identifier: MIT
// The echomap firmware: all of it is in the library.
#include <echomap.h>
