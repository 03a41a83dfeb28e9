// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace echomap::runner {

/// A command line as main gets it.
class Arguments {
 public:
  Arguments(std::initializer_list<std::string> words) : words_(words) {
    words_.insert(words_.begin(), "echomap-fake");
    for (std::string& word : words_) {
      pointers_.push_back(word.data());
    }
  }

  int argc() const { return static_cast<int>(pointers_.size()); }
  char** argv() { return pointers_.data(); }

 private:
  std::vector<std::string> words_;
  std::vector<char*> pointers_;
};

}  // namespace echomap::runner
