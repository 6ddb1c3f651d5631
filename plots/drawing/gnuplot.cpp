#include "plots/drawing/gnuplot.hpp"

#include <fmt/core.h>
#include <gnuplot-iostream.h>
#include <stdlib.h>  // mkdtemp is POSIX, not in <cstdlib>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "comparisons/measures/results/files.hpp"

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// A folder for what gnuplot writes, away from results, that goes away with its contents.
struct Scratch {
  fs::path folder;

  Scratch() {
    std::string name = (fs::temp_directory_path() / "rockstack-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": no such folder can be made");
    folder = name;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
};

std::string quoted_for_shell(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The shell outlives gnuplot and takes what gnuplot left unread: a pipe that breaks would end this process.
/// What the user's environment says about gnuplot's terminal does not count.
std::string command(const fs::path& folder, double time_limit) {
  const std::string place = quoted_for_shell(folder.string());
  return fmt::format(
      "cd {0}; unset GNUTERM; LC_ALL=C.UTF-8 /usr/bin/timeout -k 1 {1} gnuplot -d - 2>{0}/errors >&2; "
      "echo $? >{0}/status; while read -r _; do :; done",
      place, time_limit);
}

/// The formats draw marks of one size differently; `mark` evens that out.
std::string script(const Drawing& drawing) {
  constexpr double per_inch = 125;  // pixels of the others that take an inch on paper
  const std::string size = fmt::format("size {},{}", drawing.width, drawing.height);
  return fmt::format(
      "set encoding utf8\n{0}"
      "set terminal pngcairo {1} background '#ffffff' font 'DejaVu Sans,14' enhanced rounded\nmark = 1\n"
      "set output 'picture.png'\n{2}\nunset output\nreset\n"
      "set terminal svg {1} dynamic background '#ffffff' font 'DejaVu Sans,14' fontscale 1.25 enhanced "
      "rounded\nmark = "
      "0.55\n"
      "set output 'picture.svg'\n{2}\nunset output\nreset\n"
      "set terminal pdfcairo size {3:.2f}in,{4:.2f}in background '#ffffff' font 'DejaVu Sans,14' fontscale "
      "0.57 enhanced "
      "rounded\n"
      "mark = 0.62\nset output 'picture.pdf'\n{2}\nunset output\n",
      drawing.data, size, drawing.commands, drawing.width / per_inch, drawing.height / per_inch);
}

/// gnuplot's complaint in one line.
std::string complaint(const fs::path& folder) {
  std::string text = contents(folder / "errors");
  for (char& c : text)
    if (c == '\n' || c == '\t') c = ' ';
  constexpr std::size_t longest = 400;
  if (text.size() > longest) text.erase(0, text.size() - longest);
  return text;
}

/// Frames one by one: into one file that loops, and where `film` is set into a picture each.
std::string script(const Animation& animation, bool film) {
  const std::string size = fmt::format("size {},{}", animation.width, animation.height);
  std::string text = fmt::format(
      "set encoding utf8\nset terminal gif animate delay {} loop 0 {} background '#ffffff' font 'DejaVu Sans,12'\n"
      "set output 'picture.gif'\n{}",
      animation.interval / 10, size, animation.settings);
  for (const std::string& frame : animation.frames) text += frame;
  text += "unset output\n";
  if (!film) return text;
  text += fmt::format("set terminal pngcairo {} background '#ffffff' font 'DejaVu Sans,12' rounded\n", size);
  for (std::size_t i = 0; i < animation.frames.size(); ++i)
    text += fmt::format("set output 'frame-{:05}.png'\n", i) + animation.frames[i] + "unset output\n";
  return text;
}

/// Turns numbered frames into a film that every browser and slide program plays.
void make_film(const Animation& animation, const fs::path& folder, const fs::path& stem) {
  const std::string line = fmt::format(
      "cd {}; ffmpeg -loglevel error -y -framerate {} -i frame-%05d.png -c:v libx264 -pix_fmt yuv420p -movflags "
      "+faststart picture.mp4 2>errors >&2",
      quoted_for_shell(folder.string()), 1000.0 / animation.interval);
  if (std::system(line.c_str()) != 0)
    throw std::runtime_error(
        fmt::format("ffmpeg failed to make {}.mp4: {}", stem.string(), complaint(folder)));
  write_file(fs::path(stem).concat(".mp4"), contents(folder / "picture.mp4"));
}

/// Throws where gnuplot did not run, or failed.
void check_status(const fs::path& folder, const fs::path& stem, double time_limit) {
  const std::string status = contents(folder / "status");
  constexpr auto not_found = "127\n";
  constexpr auto out_of_time = "124\n";
  if (status == out_of_time)
    throw std::runtime_error(fmt::format("gnuplot has not drawn {} within {} s", stem.string(), time_limit));
  if (status == not_found)
    throw std::runtime_error(
        fmt::format("cannot draw {}: gnuplot is not installed, or not in PATH", stem.string()));
  if (status != "0\n")
    throw std::runtime_error(fmt::format("gnuplot failed to draw {} (status {}): {}", stem.string(),
                                         status.substr(0, status.find('\n')), complaint(folder)));
}

/// Words in the unseen colour have no fill: gnuplot's SVG knows no transparent ones.
std::string without_unseen(std::string svg) {
  const std::string filled = R"*(fill="rgb(1,2,3)")*";
  const std::string empty = R"(fill="none")";
  for (std::size_t at = svg.find(filled); at != std::string::npos; at = svg.find(filled, at + empty.size()))
    svg.replace(at, filled.size(), empty);
  return svg;
}

void check(const fs::path& folder, const fs::path& stem, double time_limit) {
  check_status(folder, stem, time_limit);
  const bool whole = contents(folder / "picture.png").find("IEND") != std::string::npos &&
                     contents(folder / "picture.svg").find("</svg>") != std::string::npos &&
                     contents(folder / "picture.pdf").find("%%EOF") != std::string::npos;
  if (!whole)
    throw std::runtime_error(fmt::format("gnuplot left {} unfinished: {}", stem.string(), complaint(folder)));
}

}  // namespace

bool has_ffmpeg() {
  return std::system("command -v ffmpeg >/dev/null 2>&1") == 0;
}

void draw(const Animation& animation, const std::filesystem::path& stem) {
  const Scratch scratch;
  const bool film = has_ffmpeg();
  {
    Gnuplot pipe(command(scratch.folder, animation.time_limit));
    pipe << script(animation, film);
  }
  check_status(scratch.folder, stem, animation.time_limit);
  if (film) make_film(animation, scratch.folder, stem);
  fs::create_directories(stem.parent_path());
  write_file(fs::path(stem).concat(".gif"), contents(scratch.folder / "picture.gif"));
}

void draw(const Drawing& drawing, const std::filesystem::path& stem) {
  const Scratch scratch;
  {
    Gnuplot pipe(command(scratch.folder, drawing.time_limit));
    pipe << script(drawing);
  }
  check(scratch.folder, stem, drawing.time_limit);
  fs::create_directories(stem.parent_path());
  for (const std::string format : {".png", ".pdf"})
    write_file(fs::path(stem).concat(format), contents(scratch.folder / ("picture" + format)));
  write_file(fs::path(stem).concat(".svg"), without_unseen(contents(scratch.folder / "picture.svg")));
}

}  // namespace rockstack::plots
