#include "plots/gnuplot.hpp"

#include <fmt/core.h>
#include <gnuplot-iostream.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace rockstack::plots {
namespace {

namespace fs = std::filesystem;

/// A folder beside the pictures that goes away with its contents.
struct Scratch {
  fs::path folder;

  explicit Scratch(const fs::path& stem)
      : folder(fs::absolute(stem.parent_path()) /
               fmt::format(".{}-{}", stem.filename().string(), static_cast<long>(::getpid()))) {
    fs::create_directories(folder);
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
std::string command(const fs::path& folder) {
  const std::string place = quoted_for_shell(folder.string());
  return fmt::format(
      "cd {0}; LC_ALL=C.UTF-8 gnuplot -d - 2>{0}/errors >&2; echo $? >{0}/status; while read -r _; do :; "
      "done",
      place);
}

/// The formats draw marks of one size differently; `mark` evens that out.
std::string script(const Drawing& drawing) {
  constexpr double per_inch = 125;  // pixels of the others that take an inch on paper
  const std::string size = fmt::format("size {},{}", drawing.width, drawing.height);
  return fmt::format(
      "set encoding utf8\n{0}"
      "set terminal pngcairo {1} background '#ffffff' font 'DejaVu Sans,14' enhanced rounded\nmark = 1\n"
      "set output 'picture.png'\n{2}\nunset output\nreset\n"
      "set terminal svg {1} dynamic background '#ffffff' font 'DejaVu Sans,17' enhanced rounded\nmark = "
      "0.55\n"
      "set output 'picture.svg'\n{2}\nunset output\nreset\n"
      "set terminal pdfcairo size {3:.2f}in,{4:.2f}in background '#ffffff' font 'DejaVu Sans,10' enhanced "
      "rounded\n"
      "mark = 0.8\nset output 'picture.pdf'\n{2}\nunset output\n",
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

void check(const fs::path& folder, const fs::path& stem) {
  const std::string status = contents(folder / "status");
  constexpr auto not_found = "127\n";
  if (status == not_found)
    throw std::runtime_error(
        fmt::format("cannot draw {}: gnuplot is not installed, or not in PATH", stem.string()));
  if (status != "0\n")
    throw std::runtime_error(fmt::format("gnuplot failed to draw {} (status {}): {}", stem.string(),
                                         status.substr(0, status.find('\n')), complaint(folder)));
  const bool whole = contents(folder / "picture.png").find("IEND") != std::string::npos &&
                     contents(folder / "picture.svg").find("</svg>") != std::string::npos &&
                     contents(folder / "picture.pdf").find("%%EOF") != std::string::npos;
  if (!whole)
    throw std::runtime_error(fmt::format("gnuplot left {} unfinished: {}", stem.string(), complaint(folder)));
}

}  // namespace

void draw(const Drawing& drawing, const std::filesystem::path& stem) {
  const Scratch scratch(stem);
  {
    Gnuplot pipe(command(scratch.folder));
    pipe << script(drawing);
  }
  check(scratch.folder, stem);
  for (const std::string format : {".png", ".svg", ".pdf"})
    fs::rename(scratch.folder / ("picture" + format), fs::path(stem).concat(format));
}

}  // namespace rockstack::plots
