#include "engines/worker/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <system_error>
#include <thread>

namespace rockstack {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool limits_memory = false;
#else
constexpr bool limits_memory = true;
#endif

constexpr int no_program = 127;  ///< exit code of a child that could not become the program

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(fmt::format("{}: {}", what, std::strerror(errno)));
}

/// What the child finds open.
struct Files {
  int input, reply, complaint, nothing, failure;
};

/// Between fork and exec: system calls alone, since another thread may have held any lock.
[[noreturn]] void become(pid_t parent, const char* program, const Files& files, const Limits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(no_program);  // it was gone before it could be watched
  setsid();
  dup2(files.input, 0);
  dup2(files.nothing, 1);
  dup2(files.complaint, 2);
  dup2(files.reply, 3);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  const rlimit reply{limits.reply, limits.reply};
  setrlimit(RLIMIT_FSIZE, &reply);
  if (limits_memory) {
    const rlimit memory{limits.memory, limits.memory};
    setrlimit(RLIMIT_DATA, &memory);
  }
  std::array<char*, 2> arguments{const_cast<char*>(program), nullptr};
  execv(program, arguments.data());
  const int error = errno;
  _exit(write(files.failure, &error, sizeof error) == sizeof error ? no_program : 1);
}

/// Why a program could not be started, where it left that behind.
void require_started(const std::string& path, const FileDescriptor& failure) {
  const std::string bytes = content(failure);
  int error = 0;
  if (bytes.size() != sizeof error) return;
  std::memcpy(&error, bytes.data(), sizeof error);
  const bool there = access(path.c_str(), F_OK) == 0;
  throw std::runtime_error(
      fmt::format("{}: cannot be started as a worker: {}{}", path, std::strerror(error),
                  error == ENOENT && there ? ", the interpreter that its first line names" : ""));
}

/// Calls `use` with each process of a session.
template <class Use>
void each_process_of(pid_t session, const Use& use) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
    const pid_t process = std::atoi(entry.path().filename().c_str());
    if (process > 0 && getsid(process) == session) use(process);
  }
}

/// Whether a child is in that state, WEXITED or WSTOPPED; it stays to be waited for.
bool is(int state, pid_t child) {
  siginfo_t found{};
  return waitid(P_PID, static_cast<id_t>(child), &found, state | WNOHANG | WNOWAIT) == 0 &&
         found.si_pid == child;
}

/// Kills a child, which may not have its session yet, and all that it has left in that, as groups of jobs.
/// Precondition: it has not been waited for, so that its number is still that of its session.
void kill_session(pid_t child) {
  kill(child, SIGKILL);
  kill(-child, SIGKILL);
  each_process_of(child, [](pid_t process) { kill(process, SIGKILL); });
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

FileDescriptor::FileDescriptor(int number) : number_(number) {
  if (number < 0) fail("no descriptor for a worker");
}

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) close(number_);
}

FileDescriptor high(int number) {
  const FileDescriptor low(number);
  return FileDescriptor(fcntl(low.get(), F_DUPFD_CLOEXEC, 10));
}

Ends make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0 || fcntl(ends[0], F_SETFL, O_NONBLOCK) != 0)
    fail("no pipe for a worker");
  return {high(ends[0]), high(ends[1])};
}

FileDescriptor memory_file(std::string_view content) {
  FileDescriptor file = high(memfd_create("rockstack", MFD_CLOEXEC));
  while (!content.empty()) {
    const ssize_t written = write(file.get(), content.data(), content.size());
    if (written <= 0) fail("no memory for a worker's input");
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  lseek(file.get(), 0, SEEK_SET);
  return file;
}

std::string content(const FileDescriptor& file) {
  std::string bytes(static_cast<std::size_t>(std::max<off_t>(lseek(file.get(), 0, SEEK_END), 0)), '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t read =
        pread(file.get(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (read <= 0) fail("a worker's reply cannot be read");
    done += static_cast<std::size_t>(read);
  }
  return bytes;
}

Scheduled scheduled(pid_t session) {
  constexpr double nanosecond = 1e-9;
  Scheduled sum;
  each_process_of(session, [&](pid_t process) {
    std::error_code gone;
    std::filesystem::directory_iterator threads(fmt::format("/proc/{}/task", process), gone);
    for (; !gone && threads != std::filesystem::directory_iterator(); threads.increment(gone)) {
      std::ifstream stream(threads->path() / "schedstat");
      double run = 0, waited = 0;
      if (!(stream >> run >> waited)) continue;
      sum.run += nanosecond * run;
      sum.waited += nanosecond * waited;
    }
  });
  return sum;
}

bool Allowance::lasts(std::chrono::microseconds wait) {
  const auto now = std::chrono::steady_clock::now();
  const auto passed =
      std::min<std::chrono::steady_clock::duration>(now - std::exchange(last_, now), 10 * wait);
  clock_ += std::chrono::duration<double>(passed).count();
  cancelled_ = asked_ != nullptr && (*asked_)();
  return !cancelled_ && (clock_ < limit_ || used() < limit_);
}

/// The clock's time less what the session waited for processors; no less than the time it had them.
double Allowance::used() const {
  const Scheduled sum = scheduled(session_);
  const double waited = std::max(0.0, sum.waited - before_.waited);
  return std::max(clock_ - waited, std::min(clock_, sum.run - before_.run));
}

Child::Child(const std::filesystem::path& program, int input, int reply, const Limits& limits,
             Ends complaints)
    : program_(program.string()), failure_(memory_file({})), complaints_(std::move(complaints.ours)) {
  const FileDescriptor nothing = high(open("/dev/null", O_WRONLY | O_CLOEXEC));
  const pid_t parent = getpid();
  number_ = fork();
  if (number_ < 0) fail("a worker cannot be started");
  if (number_ == 0)
    become(parent, program_.c_str(), {input, reply, complaints.theirs.get(), nothing.get(), failure_.get()},
           limits);
}

Child::~Child() {
  if (number_ <= 0) return;
  kill_session(number_);
  waitpid(number_, nullptr, 0);
}

double Child::processor_time() const {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(number_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool Child::has_ended() const {
  return is(WEXITED, number_);
}

bool Child::wait_for_end(Allowance& time, std::chrono::milliseconds tick) {
  // The last writer of the pipe is gone when the child ends, but for what it has started.
  for (bool over = silent_; !over;) {
    if (!time.lasts(tick)) return false;
    pollfd watched{complaints_.get(), POLLIN, 0};
    const int count = poll(&watched, 1, static_cast<int>(tick.count()));
    if (count < 0 && errno != EINTR) fail("a worker cannot be waited for");
    listen();
    over = silent_ || (count == 0 && has_ended());
  }
  // A child that has closed its standard error may live on.
  while (!has_ended()) {
    constexpr std::chrono::microseconds short_tick{200};
    std::this_thread::sleep_for(short_tick);
    if (!time.lasts(short_tick)) return false;
  }
  return true;
}

void Child::listen() {
  constexpr int most = 16;  // of somebody outside its session there may be no end
  std::array<char, 1 << 16> buffer{};
  for (int reads = 0; reads < most; ++reads) {
    const ssize_t size = read(complaints_.get(), buffer.data(), buffer.size());
    if (size == 0) silent_ = true;
    if (size <= 0) return;
    words_.hear({buffer.data(), static_cast<std::size_t>(size)});
  }
}

void Child::forget_words() {
  listen();
  words_ = {};
}

ProcessEnd Child::finish(const Allowance& time) {
  ProcessEnd end;
  const bool ended = has_ended();
  if (!ended) {
    end.cancelled = time.cancelled();
    end.timed_out = !end.cancelled;
    end.stopped = is(WSTOPPED, number_);
  }
  kill_session(number_);
  int status = 0;
  rusage usage{};
  wait4(std::exchange(number_, 0), &status, 0, &usage);
  if (WIFSIGNALED(status) && ended) end.signal = WTERMSIG(status);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  end.processor_time = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  require_started(program_, failure_);
  listen();
  end.last_words = words_.telling_line();
  return end;
}

}  // namespace rockstack
