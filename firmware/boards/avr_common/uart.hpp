// SPDX-License-Identifier: MIT
#pragma once

namespace echomap {
namespace boards {

/// USART0 with ECHOMAP_BAUD, 8N1, driven by interrupts.
void start_uart();

}  // namespace boards
}  // namespace echomap
