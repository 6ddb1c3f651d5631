#include <fmt/format.h>
#include <httplib.h>
#include <poll.h>
#include <sys/ioctl.h>

#include <nlohmann/json.hpp>

#include "analytic/scene/input/document.hpp"
#include "comparisons/interfaces/live/requests.hpp"

namespace rockstack::live {
namespace {

constexpr const char* home = "127.0.0.1";
constexpr std::size_t longest_request = std::size_t{512} << 10U;  // bytes, headers included
constexpr std::chrono::seconds reading_time{10};                  // of a whole request, and of each write
constexpr std::size_t threads = 64;

/// Lessons lie under this, a token and a sign, so that links between them keep the token.
const std::string course_root = "/course/";

std::string drawn_token() {
  std::random_device device;  // the system's own
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", device());
  return token;
}

/// In a time that does not tell how much is right.
bool is_same(const std::string& given, const std::string& token) {
  unsigned different = given.size() == token.size() ? 0 : 1;
  for (std::size_t i = 0; i < token.size(); ++i)
    different |=
        static_cast<unsigned char>(token[i]) ^ static_cast<unsigned char>(i < given.size() ? given[i] : 0);
  return different == 0;
}

using Clock = std::chrono::steady_clock;

/// Waits for an event on a socket. @return whether it came before the end.
bool wait_for(int socket, short event, Clock::time_point end) {
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd watched{socket, event, 0};
    const int count = poll(&watched, 1, static_cast<int>(std::max<std::int64_t>(0, left)));
    if (count > 0) return true;
    if (count == 0 || errno != EINTR) return false;
  }
}

/// A connection that gives up: reads end after so many bytes or so long, whatever they hold. The socket is
/// not closed with this.
class BoundedStream : public httplib::Stream {
 public:
  explicit BoundedStream(socket_t socket) : socket_(socket) {}

  bool is_readable() const override { return left_ > 0 && wait_for(socket_, POLLIN, end_); }

  /// Whether the other side has not closed it.
  bool is_writable() const override {
    char byte = 0;
    const ssize_t count = recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
  }

  ssize_t read(char* to, std::size_t size) override {
    if (!is_readable()) return -1;
    const ssize_t count = recv(socket_, to, std::min(size, left_), 0);
    if (count > 0) left_ -= static_cast<std::size_t>(count);
    return count;
  }

  /// All of it, or −1.
  ssize_t write(const char* from, std::size_t size) override {
    const Clock::time_point end = Clock::now() + reading_time;
    for (std::size_t done = 0; done < size;) {
      if (!wait_for(socket_, POLLOUT, end)) return -1;
      const ssize_t count = send(socket_, from + done, size - done, MSG_NOSIGNAL | MSG_DONTWAIT);
      if (count < 0 && (errno == EAGAIN || errno == EINTR)) continue;
      if (count <= 0) return -1;
      done += static_cast<std::size_t>(count);
    }
    return static_cast<ssize_t>(size);
  }

  void get_remote_ip_and_port(std::string& ip, int& port) const override {
    ip = home;
    port = 0;
  }
  void get_local_ip_and_port(std::string& ip, int& port) const override { get_remote_ip_and_port(ip, port); }
  socket_t socket() const override { return socket_; }

 private:
  int socket_;
  std::size_t left_ = longest_request;
  Clock::time_point end_ = Clock::now() + reading_time;
};

/// The library's threads, and the connections that have not yet shown that they may ask. Where more are open
/// than there are threads, the one that has been silent for longest makes room, so that no number of idle
/// ones keeps a request waiting.
class Connections : public httplib::ThreadPool {
 public:
  Connections() : httplib::ThreadPool(threads) {}

  /// One more is open, and has no thread yet.
  void enqueue(std::function<void()> serve) override {
    {
      const std::lock_guard lock(mutex_);
      ++open_;
      make_room(-1);
    }
    httplib::ThreadPool::enqueue(std::move(serve));
  }

  /// It has a thread now.
  void enter(int socket) {
    const std::lock_guard lock(mutex_);
    sockets_.push_back(socket);
    make_room(socket);
  }

  /// It may ask.
  void admit(int socket) {
    const std::lock_guard lock(mutex_);
    std::erase(sockets_, socket);
  }

  /// Before it is closed.
  void leave(int socket) {
    const std::lock_guard lock(mutex_);
    std::erase(sockets_, socket);
    --open_;
  }

 private:
  void make_room(int except) {
    if (open_ <= threads) return;
    const auto silent = std::ranges::find_if(sockets_, [&](int socket) {
      int bytes = 0;
      return socket != except && ioctl(socket, FIONREAD, &bytes) == 0 && bytes == 0;
    });
    if (silent == sockets_.end()) return;
    ::shutdown(*silent, SHUT_RDWR);
    sockets_.erase(silent);
  }

  std::mutex mutex_;
  std::size_t open_ = 0;
  std::vector<int> sockets_;  ///< of those with a thread, in the order in which they came
};

/// The connection that this thread serves.
thread_local const BoundedStream* current = nullptr;

void refuse(httplib::Response& response, int status, const std::string& reason) {
  response.status = status;
  response.set_content(reason + "\n", "text/plain; charset=utf-8");
}

/// What is wrong with a request is its answer, with status 400.
template <class Answer>
void answer_with(httplib::Response& response, const Answer& answer) {
  try {
    response.set_content(answer(), "application/json");
  } catch (const nlohmann::json::exception& error) {
    refuse(response, 400, std::string("the page: must be a question in JSON: ") + error.what());
  } catch (const std::invalid_argument& error) {
    refuse(response, 400, one_line(error.what()));
  } catch (const std::exception& error) {
    refuse(response, 500, one_line(error.what()));
  }
}

const char* media_type(const std::filesystem::path& file) {
  static const std::map<std::string, const char*> types{{".html", "text/html; charset=utf-8"},
                                                        {".json", "application/json"},
                                                        {".svg", "image/svg+xml"},
                                                        {".png", "image/png"},
                                                        {".pdf", "application/pdf"}};
  const auto type = types.find(file.extension().string());
  return type == types.end() ? "text/plain; charset=utf-8" : type->second;
}

class LiveServer : public httplib::Server {
 public:
  LiveServer(LivePage page, int port) : page_(std::move(page)) {
    new_task_queue = [this] { return connections_ = new Connections(); };
    // Without the port being shared, which is what the library sets.
    set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    port_ = port == 0 ? bind_to_any_port(home) : (bind_to_port(home, port) ? port : -1);
    if (port_ <= 0) throw std::runtime_error(fmt::format("port {} of {}: cannot be listened to", port, home));
    set_payload_max_length(longest_request);
    set_default_headers(
        {{"Cache-Control", "no-store"},
         {"X-Content-Type-Options", "nosniff"},
         {"Referrer-Policy", "no-referrer"},
         {"Cross-Origin-Resource-Policy", "same-origin"},
         // A course's pages have the solver in them, which they compile and run in workers of their own.
         {"Content-Security-Policy",
          "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:; style-src 'unsafe-inline'; img-src data:; "
          "connect-src 'self'; frame-src 'self'; frame-ancestors 'self'; base-uri 'none'; form-action "
          "'none'"}});
    set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      return admits(request, response) ? HandlerResponse::Unhandled : HandlerResponse::Handled;
    });
    Get("/", [this](const httplib::Request&, httplib::Response& response) {
      response.set_content(page_.text, "text/html; charset=utf-8");
    });
    Get(course_root + ".*", [this](const httplib::Request& request, httplib::Response& response) {
      const std::size_t root = course_path().size();
      const auto file = page_.course.files.find(request.path.size() < root ? "" : request.path.substr(root));
      if (file == page_.course.files.end()) return refuse(response, 404, "there is no such page");
      std::ifstream in(file->second, std::ios::binary);
      if (!in) return refuse(response, 404, "the file is no longer there");
      response.set_content(std::string{std::istreambuf_iterator<char>(in), {}}, media_type(file->second));
    });
    Post("/answer", [this](const httplib::Request& request, httplib::Response& response) {
      const auto has_left = [] { return !current->is_writable(); };
      answer_with(response, [&] { return requests_.answer(request.body, has_left); });
    });
    Post("/files", [this](const httplib::Request& request, httplib::Response& response) {
      answer_with(response, [&] { return requests_.files(request.body); });
    });
  }

  std::string address() const {
    const std::string& first = page_.course.first;
    return fmt::format("http://{}:{}{}", home, port_,
                       first.empty() ? "/?token=" + token_ : course_path() + first);
  }

 private:
  std::string course_path() const { return course_root + token_ + "/"; }

  /// What a request gives for the token.
  static std::string token_of(const httplib::Request& request) {
    if (request.method != "GET" && request.method != "HEAD")
      return request.get_header_value("X-Rockstack-Token");
    if (request.path.compare(0, course_root.size(), course_root) != 0)
      return request.get_param_value("token");
    const std::string rest = request.path.substr(course_root.size());
    return rest.substr(0, rest.find('/'));
  }

  /// Whoever has been led here by another name or another page does not know the token either; each is
  /// refused for itself.
  bool admits(const httplib::Request& request, httplib::Response& response) {
    const std::string host = request.get_header_value("Host"), origin = request.get_header_value("Origin");
    const bool known =
        host == fmt::format("{}:{}", home, port_) || host == fmt::format("localhost:{}", port_);
    const bool own = !request.has_header("Origin") || origin == "http://" + host;
    if (!known || request.get_header_value_count("Host") != 1 || !own) {
      refuse(response, 403, "Host or Origin: must be the address that `rockstack live` has printed");
      return false;
    }
    if (!is_same(token_of(request), token_)) {
      refuse(response, 403, "token: must be that of the address that this `rockstack live` has printed");
      return false;
    }
    connections_->admit(current->socket());
    return true;
  }

  /// In the place of the library's own: a connection of bounded length and time, for one request.
  bool process_and_close_socket(socket_t socket) override {
    BoundedStream stream(socket);
    connections_->enter(socket);
    current = &stream;
    bool closed = false;
    // Packing an answer takes ten times as long as making it.
    const bool done = process_request(
        stream, true, closed, [](httplib::Request& request) { request.headers.erase("Accept-Encoding"); });
    current = nullptr;
    connections_->leave(socket);
    shutdown(socket, SHUT_RDWR);
    close(socket);
    return done;
  }

  LivePage page_;
  Requests requests_{page_.records};
  Connections* connections_ = nullptr;  ///< the library's, for as long as it serves
  std::string token_ = drawn_token();
  int port_ = 0;
};

}  // namespace

void serve(LivePage page, int port, const std::function<void(const std::string& address)>& listening) {
  LiveServer server(std::move(page), port);
  listening(server.address());
  server.listen_after_bind();
}

}  // namespace rockstack::live
