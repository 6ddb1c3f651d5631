#pragma once

#include <functional>
#include <string>

#include "comparisons/interfaces/live/live_page.hpp"
#include "comparisons/interfaces/live/requests.hpp"

namespace rockstack::live {

/// Serves a page, its requests and the lessons beside it on this machine alone, until the program ends: on
/// 127.0.0.1, to who knows the token and calls the server by this address. A connection carries one request,
/// of limited length and time. `port` 0: any that is free.
/// `listening` is told the address, with a token that is drawn anew each time: of the lessons, where there
/// are any, else of the page. @throws std::runtime_error where the port is taken.
void serve(Requests& requests, LivePage page, int port,
           const std::function<void(const std::string& address)>& listening);

}  // namespace rockstack::live
