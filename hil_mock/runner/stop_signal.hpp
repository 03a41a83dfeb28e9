// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::runner {

/// Lets SIGINT and SIGTERM ask for an orderly end and ignores SIGPIPE; for the whole process.
void catch_stop_signals();

/// Whether one of them has come.
bool stop_requested();

}  // namespace echomap::runner
