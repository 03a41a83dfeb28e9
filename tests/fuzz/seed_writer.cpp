// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/fuzz/fuzz_target.hpp"

/// libFuzzer calls this first. `fuzz_x --seeds FOLDER` only writes what it is to begin from.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  if (*argc != 3 || std::string((*argv)[1]) != "--seeds") {
    return 0;
  }
  const std::filesystem::path folder = (*argv)[2];
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const echomap::fuzz::Input& seed : echomap::fuzz::seeds()) {
    std::ofstream(folder / ("seed-" + std::to_string(++number)), std::ios::binary)
        .write(reinterpret_cast<const char*>(seed.data()),
               static_cast<std::streamsize>(seed.size()));
  }
  std::exit(EXIT_SUCCESS);
}
