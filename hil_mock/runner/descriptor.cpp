// SPDX-License-Identifier: MIT
#include "hil_mock/runner/descriptor.hpp"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace echomap::runner {

Descriptor::Descriptor(int number, const std::string& tried) : number_(number) {
  check_call(number, tried);
}

void Descriptor::close() {
  if (is_open()) {
    ::close(number_);
    number_ = -1;
  }
}

void check_call(int result, const std::string& tried) {
  if (result < 0) {
    throw std::system_error(errno, std::generic_category(), tried);
  }
}

void set_non_blocking(int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  check_call(flags, "fcntl");
  check_call(::fcntl(descriptor, F_SETFL, flags | O_NONBLOCK), "fcntl");
}

}  // namespace echomap::runner
