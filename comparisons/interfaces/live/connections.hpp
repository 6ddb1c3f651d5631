#pragma once

#include <cstddef>
#include <mutex>
#include <vector>

namespace rockstack::live {

/// The connections that are open, and which have not yet shown that they may ask. Where more are open than
/// there are threads, the one that has been silent for longest makes room, so that no number of idle ones
/// keeps a request waiting.
class Connections {
 public:
  explicit Connections(std::size_t threads) : threads_(threads) {}

  void queue();            ///< one more is open, and has no thread yet
  void enter(int socket);  ///< it has a thread now
  void admit(int socket);  ///< it may ask
  void leave(int socket);  ///< before it is closed

 private:
  void make_room(int except);

  std::mutex mutex_;
  std::size_t threads_;
  std::size_t open_ = 0;
  std::vector<int> sockets_;  ///< of those with a thread, in the order in which they came
};

}  // namespace rockstack::live
