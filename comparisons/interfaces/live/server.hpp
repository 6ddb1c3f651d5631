#pragma once

#include <functional>
#include <memory>
#include <string>

#include "comparisons/interfaces/live/live_page.hpp"
#include "comparisons/interfaces/live/questions.hpp"

namespace rockstack::live {

/// Serves a page, its questions and the lessons beside it on this machine alone: on 127.0.0.1, to who knows
/// the token and calls the server by this address. A connection carries one request, of limited length and
/// time.
class LiveServer {
 public:
  /// `port` 0: any that is free. `page` stays as it is. @throws std::runtime_error where the port is taken.
  LiveServer(Questions& questions, LivePage page, int port);
  ~LiveServer();

  /// With a token that is drawn anew for each server: of the lessons, where there are any, else of the page.
  std::string address() const;

  /// Until stop(), which another thread calls.
  void run();
  void stop();

 private:
  class Http;
  std::unique_ptr<Http> http_;
};

}  // namespace rockstack::live
