// Preloaded into a program: a wall clock that jumps three years ahead and back with every look at it. The
// steady clock runs on.

#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

#include <atomic>
#include <ctime>

namespace {

timespec jumped(clockid_t clock) {
  static std::atomic<bool> ahead{false};
  timespec now{};
  syscall(SYS_clock_gettime, clock, &now);
  constexpr time_t far = 100'000'000;
  if (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE)
    now.tv_sec += ahead.exchange(!ahead) ? -far : far;
  return now;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  *now = jumped(clock);
  return 0;
}

int gettimeofday(timeval* now, void* /*zone*/) noexcept {
  const timespec time = jumped(CLOCK_REALTIME);
  *now = {time.tv_sec, time.tv_nsec / 1000};
  return 0;
}

time_t time(time_t* now) noexcept {
  const time_t seconds = jumped(CLOCK_REALTIME).tv_sec;
  if (now != nullptr) *now = seconds;
  return seconds;
}
}
