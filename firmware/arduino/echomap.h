// SPDX-License-Identifier: MIT
#pragma once

// The Arduino IDE takes a library into a sketch that includes a header of it. The library's main()
// then stands in the place of Arduino's, so a sketch has no setup() and no loop().
