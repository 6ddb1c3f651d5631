#include <fmt/format.h>
#include <httplib.h>
#include <poll.h>

#include "analytic/scene/input/json_reader.hpp"
#include "analytic/scene/lists.hpp"
#include "analytic/scene/messages/one_line.hpp"
#include "comparisons/interfaces/live/lobby.hpp"
#include "comparisons/interfaces/live/requests.hpp"

namespace rockstack::live {
namespace {

constexpr const char* home = "127.0.0.1";
constexpr std::size_t longest_request = std::size_t{512} << 10U;  // bytes, headers included
constexpr std::size_t readers = 32;  // threads beside those of requests that wait or run

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

/// A connection that gives up: reads end after so many bytes or so long, whatever they hold. The socket is
/// not closed with this.
class BoundedStream : public httplib::Stream {
 public:
  /// `begun`: what has been read of it.
  BoundedStream(int socket, std::string begun) : socket_(socket), begun_(std::move(begun)) {}

  bool is_readable() const override {
    return heard_ < begun_.size() || (left_ > 0 && wait_for(socket_, POLLIN, end_));
  }

  /// Whether the other side has not closed it.
  bool is_writable() const override {
    char byte = 0;
    const ssize_t count = recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    return count > 0 || (count < 0 && (errno == EAGAIN || errno == EINTR));
  }

  ssize_t read(char* to, std::size_t size) override {
    if (heard_ < begun_.size()) {
      const std::size_t count = begun_.copy(to, size, heard_);
      heard_ += count;
      return static_cast<ssize_t>(count);
    }
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
  std::string begun_;
  std::size_t heard_ = 0;  ///< of that
  std::size_t left_ = longest_request;
  Clock::time_point end_ = Clock::now() + reading_time;
};

/// Threads for those who may come in; the others wait in a lobby.
class Connections : public httplib::TaskQueue {
 public:
  /// `door.let_in` serves.
  Connections(std::size_t threads, Lobby::Door door)
      : pool_(threads), lobby_(std::in_place, in_a_thread(std::move(door))) {}

  void add(int socket) { lobby_->add(socket); }
  void enqueue(std::function<void()> accepted) override { accepted(); }
  void shutdown() override {
    lobby_.reset();
    pool_.shutdown();
  }

 private:
  Lobby::Door in_a_thread(Lobby::Door door) {
    door.let_in = [this, serve = std::move(door.let_in)](int socket, std::string begun) {
      pool_.enqueue([serve, socket, begun = std::move(begun)] { serve(socket, begun); });
    };
    return door;
  }

  httplib::ThreadPool pool_;
  std::optional<Lobby> lobby_;
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
    refuse(response, 400, one_line("the page: must be a question in JSON: " + plain_words(error)));
  } catch (const Faults& faults) {
    const auto line = [](const std::string& fault) { return one_line(fault); };
    refuse(response, 400, joined_texts(faults.lines, line, "\n"));
  } catch (const std::invalid_argument& error) {
    refuse(response, 400, one_line(error.what()));
  } catch (const Busy& busy) {
    response.set_header("Retry-After", "1");
    refuse(response, 503, busy.what());
  } catch (const std::exception& error) {
    refuse(response, 500, one_line(error.what()));
  }
}

const char* media_type(const std::filesystem::path& file) {
  static const std::map<std::string, const char*> types{{".html", "text/html; charset=utf-8"},
                                                        {".js", "text/javascript; charset=utf-8"},
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
    new_task_queue = [this] {
      return connections_ = new Connections(readers + requests_.most_at_once(), door());
    };
    // Without the port being shared, which is what the library sets.
    set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    port_ = port == 0 ? bind_to_any_port(home) : (bind_to_port(home, port) ? port : -1);
    if (port_ <= 0) throw std::runtime_error(fmt::format("port {} of {}: cannot be listened to", port, home));
    ::listen(svr_sock_,
             SOMAXCONN);  // as many as come at once wait to be accepted, not the few of the library
    set_payload_max_length(longest_request);
    set_default_headers(
        {{"Cache-Control", "no-store"},
         {"X-Content-Type-Options", "nosniff"},
         {"Referrer-Policy", "no-referrer"},
         {"Cross-Origin-Resource-Policy", "same-origin"},
         // A course's pages load the solver, which they compile and run in workers of their own.
         {"Content-Security-Policy",
          "default-src 'none'; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; worker-src blob:; style-src 'unsafe-inline'; img-src data:; "
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

  /// What a request gives for the token, by its first line.
  static std::string token_of(const std::string& line) {
    const std::size_t begin = line.find(' ') + 1;  // of the path; 0: none
    const std::string path = begin == 0 ? "" : line.substr(begin, line.find_first_of(" \r", begin) - begin);
    const std::string query = "?token=";
    if (path.starts_with(course_root))
      return path.substr(0, path.find('/', course_root.size())).substr(course_root.size());
    const std::size_t place = path.find(query);
    return place == std::string::npos ? ""
                                      : path.substr(0, path.find('&', place)).substr(place + query.size());
  }

  Lobby::Door door() {
    const std::string reason = "token: must be that of the address that this `rockstack live` has printed\n";
    return {[this](const std::string& line) { return is_same(token_of(line), token_); },
            fmt::format(
                "HTTP/1.1 403 Forbidden\r\nContent-Type: text/plain; charset=utf-8\r\nContent-Length: {}\r\n"
                "Connection: close\r\n\r\n{}",
                reason.size(), reason),
            [this](int socket, std::string begun) { serve_one(socket, std::move(begun)); }};
  }

  /// Whoever has been led here by another name or another page does not know the token either; each is
  /// refused for itself.
  bool admits(const httplib::Request& request, httplib::Response& response) {
    const std::string host = request.get_header_value("Host");
    const bool known =
        host == fmt::format("{}:{}", home, port_) || host == fmt::format("localhost:{}", port_);
    const auto [first, last] = request.headers.equal_range("Origin");
    const bool own =
        std::all_of(first, last, [&](const auto& header) { return header.second == "http://" + host; });
    if (known && request.get_header_value_count("Host") == 1 && own) return true;
    refuse(response, 403, "Host or Origin: must be the address that `rockstack live` has printed");
    return false;
  }

  /// In the place of the library's own: its first line decides who is served.
  bool process_and_close_socket(socket_t socket) override {
    connections_->add(socket);
    return true;
  }

  /// A connection of bounded length and time, for one request.
  void serve_one(int socket, std::string begun) {
    BoundedStream stream(socket, std::move(begun));
    current = &stream;
    bool closed = false;
    // Packing an answer takes ten times as long as making it.
    process_request(stream, true, closed,
                    [](httplib::Request& request) { request.headers.erase("Accept-Encoding"); });
    current = nullptr;
    close_both_ways(socket);
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
