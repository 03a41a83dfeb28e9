// SPDX-License-Identifier: MIT
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

#include "host/live_page/web_request.hpp"
#include "host/live_page/web_response.hpp"

/// What the sources share that include Boost.Beast; no other source includes this header.
namespace echomap::live_page {

/// A request with its whole body.
using BeastRequest = boost::beast::http::request<boost::beast::http::string_body>;
using BeastRequestParser = boost::beast::http::request_parser<boost::beast::http::string_body>;

/// The request without Beast.
WebRequest web_request_of(const BeastRequest& request);

/// What is answered to bytes that are no request.
WebResponse refusal_of(boost::beast::error_code error);

/// Of a request that is to be read.
void set_limits(BeastRequestParser& parser);

}  // namespace echomap::live_page
